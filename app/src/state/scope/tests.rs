//! The scope as a user works it.

use super::*;

const NAMES: [(&str, &str); 5] = [
    ("x.position", "counts"),
    ("x.command", "counts"),
    ("x.velocity", "counts/s"),
    ("x.error", "counts"),
    ("outputs", "bits"),
];

fn signals() -> Vec<Signal> {
    let signal = |(name, unit): (&str, &str)| Signal {
        name: name.to_owned(),
        unit: unit.to_owned(),
    };
    NAMES.map(signal).to_vec()
}

/// Samples of 2 ms from `from_ms` on, at the given demanded positions; output 2 is on where that is above 50.
fn samples(from_ms: u64, positions: &[f64]) -> Vec<f64> {
    let mut trace = Trace::new(NAMES.len(), positions.len());
    for (i, &position) in positions.iter().enumerate() {
        let at = ms(from_ms + 2 * i as u64);
        let output = if position > 50.0 { 4.0 } else { 0.0 };
        trace.push(
            at,
            &[position - 1.0, position, 500.0 * position, 1.0, output],
        );
    }
    protocol::pack(&trace)
}

fn ramp(from: f64, to: f64, rows: usize) -> Vec<f64> {
    (0..rows)
        .map(|i| from + (to - from) * i as f64 / (rows - 1) as f64)
        .collect()
}

fn ms(millis: u64) -> Nanos {
    Nanos::from_millis(millis)
}

/// The axis has moved from 0 to 100 within 800 ms, and stands.
fn moved() -> Scope {
    let mut scope = Scope::new(&signals());
    scope.take(&samples(0, &ramp(0.0, 100.0, 401)), false);
    scope.take(&samples(802, &[100.0; 200]), false);
    scope
}

fn position(scope: &Scope) -> Picture {
    let strip = scope.strip("position").unwrap();
    let view = scope.view().unwrap();
    scope.picture(strip, view, 200, 3.0).unwrap()
}

#[test]
fn nothing_is_shown_until_something_moves() {
    let mut scope = Scope::new(&signals());
    scope.take(&samples(0, &[7.0; 1000]), false);
    assert_eq!(scope.view(), None);
    assert_eq!(scope.newest(1), Some(7.0));
    assert!(!scope.take(&samples(2000, &[7.0; 1000]), false));
}

#[test]
fn the_picture_begins_with_the_motion_and_holds_all_of_it() {
    let mut scope = Scope::new(&signals());
    scope.take(&samples(0, &[0.0; 1000]), false);
    assert!(scope.take(&samples(2000, &ramp(0.0, 40_960.0, 751)), false));
    let view = scope.view().unwrap();
    // The ramp's first row still stands at 0.
    assert_eq!(
        (view.zero, view.from, view.to),
        (ms(2000), ms(2000), ms(4000))
    );
    let picture = position(&scope);
    assert_eq!(
        (picture.scale.high, picture.scale.step),
        (60_000.0, 20_000.0)
    );
    let names: Vec<_> = scope.strips()[0]
        .traces
        .iter()
        .map(|t| t.name.as_str())
        .collect();
    assert_eq!(names, ["actual", "demanded"]);
    let demanded = &picture.lines[1].points;
    assert_eq!(demanded.last().unwrap().1, 40_960.0);
    let rises = demanded.windows(2).all(|pair| pair[0].1 <= pair[1].1);
    assert!(rises, "a ramp is drawn as a ramp");
    assert!(demanded.len() <= 400);
}

#[test]
fn it_stands_still_when_the_axis_does_and_its_line_is_complete() {
    let mut scope = Scope::new(&signals());
    scope.take(&samples(0, &ramp(0.0, 100.0, 400)), false);
    let goes_on = scope.take(&samples(800, &[100.0; 50]), false);
    assert!(goes_on, "the line goes on to the right edge");
    let view = scope.view().unwrap();
    scope.take(&samples(900, &[100.0; 500]), false);
    assert!(!scope.take(&samples(1900, &[100.0; 500]), false));
    assert_eq!(scope.view(), Some(view));
}

#[test]
fn a_second_motion_joins_the_picture_or_begins_a_new_one() {
    let mut scope = Scope::new(&signals());
    scope.take(&samples(0, &ramp(0.0, 100.0, 400)), false);
    scope.take(&samples(800, &[100.0; 500]), false);
    scope.take(&samples(1800, &ramp(100.0, 200.0, 400)), false);
    assert_eq!(scope.view().unwrap().zero, Nanos::ZERO);
    assert_eq!(scope.view().unwrap().to, ms(5000));
    scope.take(&samples(2600, &[200.0; 2000]), false);
    scope.take(&samples(6600, &ramp(200.0, 300.0, 400)), false);
    assert_eq!(scope.view().unwrap().zero, ms(6600));
}

#[test]
fn a_long_motion_moves_through_the_picture() {
    let mut scope = Scope::new(&signals());
    scope.take(&samples(0, &ramp(0.0, 1e6, 45_000)), false);
    let view = scope.view().unwrap();
    assert_eq!(view.width(), ms(60_000));
    assert!(view.to > ms(89_998) && view.from > view.zero);
    let scale = view.scale();
    assert!(scale.marks().all(|s| s >= scale.low && s <= scale.high));
}

#[test]
fn a_register_reset_by_the_mains_switch_is_no_motion() {
    let mut scope = Scope::new(&signals());
    scope.take(&samples(0, &[500.0; 10]), false);
    scope.take(&samples(20, &[500.0, 0.0, 0.0]), true);
    assert_eq!(scope.view(), None);
    assert_eq!(scope.newest(1), Some(0.0));
}

#[test]
fn a_paused_picture_stands_while_the_recording_goes_on() {
    let mut scope = moved();
    scope.pause(true);
    let (view, picture) = (scope.view(), position(&scope));
    assert!(!scope.take(&samples(1202, &ramp(100.0, 0.0, 400)), false));
    assert_eq!((scope.view(), scope.newest(1)), (view, Some(100.0)));
    assert_eq!(scope.now("x.command"), Some(0.0));
    assert_eq!(position(&scope), picture);
    scope.pan(0.1);
    assert_ne!(scope.view(), view);
    scope.pause(false);
    assert_eq!(scope.follows(), Follow::Motion);
    assert_eq!(
        (scope.view().unwrap().to, scope.newest(1)),
        (ms(5000), Some(0.0))
    );
}

#[test]
fn what_the_user_zooms_to_stays_until_it_follows_again() {
    let mut scope = moved();
    scope.zoom(0.5, 0.0);
    let view = scope.view().unwrap();
    assert_eq!((view.from, view.to), (Nanos::ZERO, ms(500)));
    assert_eq!(scope.follows(), Follow::Nothing);
    scope.take(&samples(5000, &ramp(100.0, 0.0, 400)), false);
    assert_eq!(scope.view(), Some(view));
    scope.follow(Follow::Newest);
    assert_eq!(scope.view().unwrap().from, Nanos::ZERO);
    scope.take(&samples(20_000, &[0.0; 10]), false);
    assert_eq!(scope.view().unwrap().to, ms(20_018));
    scope.follow(Follow::Motion);
    assert_eq!(scope.view().unwrap().zero, ms(5000));
}

#[test]
fn cursors_stand_on_samples_and_tell_differences_and_slope() {
    let mut scope = moved();
    scope.show_cursors(true);
    // The picture is 1 s wide; the ramp rises by 125 a second.
    scope.move_cursor(0, 0.1003);
    scope.move_cursor(1, 0.5);
    assert_eq!(scope.cursors(), Some([ms(100), ms(500)]));
    let reading = scope.reading(1).unwrap();
    assert_eq!(reading.values, [12.5, 62.5]);
    assert_eq!((reading.seconds, reading.difference()), (0.4, 50.0));
    assert_eq!(reading.slope(), Some(125.0));
    scope.move_cursor(1, -3.0);
    assert_eq!(scope.between_cursors(), Some(-0.1));
    scope.move_cursor(1, 0.1);
    assert_eq!(scope.reading(1).unwrap().slope(), None);
    scope.show_cursors(false);
    assert_eq!(scope.reading(1), None);
}

#[test]
fn a_key_moves_a_cursor_by_a_sample_at_least() {
    let mut scope = moved();
    scope.show_cursors(true);
    scope.move_cursor(0, 0.5);
    scope.zoom(0.1, 0.5);
    scope.step_cursor(0, 1.0);
    assert_eq!(scope.cursors().unwrap()[0], ms(502));
    scope.step_cursor(0, -1.0);
    scope.step_cursor(0, -1.0);
    assert_eq!(scope.cursors().unwrap()[0], ms(498));
    scope.step_cursor(0, 1e9);
    assert_eq!(scope.cursors().unwrap()[0], ms(1200), "the newest");
}

#[test]
fn bits_are_drawn_in_a_lane_for_each_that_was_ever_on() {
    let mut scope = moved();
    scope.choose(4, true);
    let strip = scope.strip("outputs").unwrap();
    let picture = scope
        .picture(strip, scope.view().unwrap(), 100, 3.0)
        .unwrap();
    assert_eq!(picture.lanes, [2]);
    let points = &picture.lines[0].points;
    assert_eq!(points.len(), 4, "{points:?}");
    assert!(points[0].1 < points[3].1);
    assert!((0.39..0.42).contains(&points[1].0), "{points:?}");
}

#[test]
fn the_csv_holds_what_is_shown_and_no_more() {
    let mut scope = moved();
    scope.choose(0, false);
    scope.choose(3, false);
    scope.zoom(0.2, 0.5);
    let csv = scope.csv();
    let lines: Vec<&str> = csv.split_terminator("\r\n").collect();
    assert_eq!(
        lines[0],
        "time (s),x.command (counts),x.velocity (counts/s)"
    );
    assert_eq!(lines[1], "0.4,50,25000");
    assert_eq!(lines.len(), 1 + 101);
    assert!(lines[101].starts_with("0.6,75,"), "{}", lines[101]);
}

#[test]
fn a_new_simulator_is_seen_as_the_last_one_was() {
    let mut scope = moved();
    scope.remove("velocity");
    scope.follow(Follow::Newest);
    scope.start(&signals(), 1);
    assert_eq!((scope.strips().len(), scope.view()), (2, None));
    scope.take(&samples(0, &[3.0; 10]), false);
    assert_eq!(scope.follows(), Follow::Newest);
    assert_eq!(scope.newest(1), Some(3.0));
}
