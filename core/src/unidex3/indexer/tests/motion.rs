use super::*;

#[track_caller]
fn assert_close(a: f64, b: f64, tolerance: f64) {
    assert!((a - b).abs() <= tolerance, "{a} is not {b}");
}

#[test]
fn a_move_lasts_as_many_periods_as_it_has_pulses() {
    let mut unit = Unit::stepper();
    assert_close(unit.time(x(100, 50)), 2.0, 2e-6);
    assert_close(unit.time(x(-3, 1)), 3.0, 2e-6);
    assert_eq!(unit.registers(), (97, 0));
    let feedrate = Feedrate::period(40).unwrap();
    let by_period = Move::independent(
        Some(Leg {
            steps: 25_000,
            feedrate,
        }),
        None,
        None,
    );
    assert_close(unit.time(by_period), 1.0, 2e-6);
}

#[test]
fn feedrates_have_the_ranges_of_the_manual() {
    for (steps, valid) in [(0, false), (1, true), (150_000, true), (150_001, false)] {
        assert_eq!(Feedrate::frequency(steps).is_some(), valid, "{steps}");
    }
    for (us, valid) in [
        (0, false),
        (5, false),
        (6, true),
        (4_000_000_000, true),
        (u32::MAX, false),
    ] {
        assert_eq!(Feedrate::period(us).is_some(), valid, "{us}");
    }
    for (steps, valid) in [(30, false), (31, true), (166_500, true), (166_501, false)] {
        assert_eq!(Feedrate::start_stop(steps).is_some(), valid, "{steps}");
    }
    let shown = Feedrate::START_STOP.steps_per_second();
    assert_close(shown, 30.52, 0.005);
}

#[test]
fn periods_of_whole_microseconds_are_kept_to_the_microsecond() {
    for us in [6, 7, 11, 13, 997, 30_001] {
        let feedrate = Feedrate::period(us).unwrap();
        let steps = 1000;
        let seconds =
            Unit::stepper().time(Move::independent(Some(Leg { steps, feedrate }), None, None));
        assert_close(seconds * 1e6, f64::from(us) * 1000.0 + 1.0, 0.5);
    }
}

#[test]
fn the_slowest_period_gives_a_pulse_after_4000_seconds() {
    let feedrate = Feedrate::period(4_000_000_000).unwrap();
    let mut unit = Unit::stepper();
    unit.start(Move::independent(
        Some(Leg { steps: 1, feedrate }),
        None,
        None,
    ));
    unit.now = Nanos::from_millis(3_999_998);
    unit.indexer.sample(unit.now);
    assert_eq!(unit.registers(), (0, 0));
    unit.run(4);
    assert_eq!(unit.registers(), (1, 0));
}

#[test]
fn axes_move_at_the_same_time_each_at_its_own_feedrate() {
    let mut unit = Unit::stepper();
    unit.start(Move::independent(
        Some(leg(1000, 1000)),
        Some(leg(-500, 250)),
        None,
    ));
    unit.run(1001);
    assert_eq!(unit.registers(), (1000, -250));
    assert!(!unit.indexer.is_complete(true));
    unit.run(1000);
    assert_eq!(unit.registers(), (1000, -500));
    assert!(unit.indexer.is_complete(false));
}

/// 5-1: 3000, 4000 at 1000 steps/s.
#[test]
fn a_vector_is_a_straight_line() {
    let feedrate = Feedrate::frequency(1000).unwrap();
    let parts = feedrate.components(3000, -4000);
    assert_eq!(parts.x.unwrap().steps_per_second(), 600.0);
    assert_eq!(parts.y.unwrap().steps_per_second(), 800.0);
    assert_eq!(feedrate.components(0, 7).x, None);
    assert_eq!(feedrate.components(0, 7).y, Some(feedrate));

    let mut unit = Unit::stepper();
    unit.start(Move::vector(3000, -4000, feedrate, None));
    for _ in 0..4999 {
        unit.sample();
        let (x, y) = unit.registers();
        assert!((4 * x + 3 * y).abs() <= 6, "{x} {y}");
    }
    unit.run(2);
    assert_eq!(unit.registers(), (3000, -4000));
    assert!(unit.indexer.is_complete(true));
}

fn sample_1() -> Ramp {
    Ramp::timed(Shape::Linear, 500, Feedrate::start_stop(250).unwrap())
}

/// 6-16 I, sample program 1: 2.4996 s, and 0.6174 s.
#[test]
fn the_first_sample_of_ramps() {
    let mut unit = Unit::stepper();
    let mut order = x(10_000, 5000);
    order.ramp = Some(sample_1());
    assert_close(unit.time(order), 2.4996, 0.0001);
    let y = Move::independent(None, Some(leg(10_000, 40_000)), Some(sample_1()));
    assert_close(unit.time(y), 0.6174, 0.0001);
    assert_eq!(unit.registers(), (10_000, 10_000));
}

/// Its second axis reaches 17/24 of what is programmed.
#[test]
fn a_short_move_does_not_reach_its_feedrate() {
    let mut unit = Unit::stepper();
    unit.start(Move::independent(
        None,
        Some(leg(10_000, 40_000)),
        Some(sample_1()),
    ));
    let mut fastest = 0.0f64;
    while !unit.indexer.is_complete(true) {
        unit.sample();
        fastest = fastest.max(unit.indexer.signals(Axis::Y).rate);
    }
    assert_close(fastest, 28_333.3, 0.1);
}

/// 6-16 I, sample program 2: 21.739 ms a step, 24 of them, both axes in step.
#[test]
fn the_second_sample_of_ramps() {
    let feedrate = Feedrate::frequency(10_000).unwrap();
    let ramp = Ramp::rated(feedrate, 20_000);
    assert_eq!(ramp.sample_us, 21_739);
    let parts = feedrate.components(5000, 10_000);
    assert_close(parts.x.unwrap().steps_per_second(), 4472.14, 0.005);
    assert_close(parts.y.unwrap().steps_per_second(), 8944.27, 0.005);

    let mut unit = Unit::stepper();
    unit.start(Move::vector(5000, 10_000, feedrate, Some(ramp)));
    let mut top = 0;
    while !unit.indexer.is_complete(true) {
        unit.sample();
        let (x, y) = unit.registers();
        assert!((2 * x - y).abs() <= 3, "{x} {y}");
        let rate = unit.indexer.signals(Axis::X).rate;
        top += u32::from((rate - 4472.14).abs() < 0.01);
    }
    assert_eq!(unit.registers(), (5000, 10_000));
    // 5000 steps less twice 11.5 ramp samples at full feedrate.
    assert_close(f64::from(top), (5000.0 / 4472.14 - 0.5) * 1000.0, 2.0);
}

#[test]
fn a_vector_whose_axes_differ_much_keeps_its_line_on_the_ramp() {
    let feedrate = Feedrate::frequency(5000).unwrap();
    for (dx, dy) in [(6i64, 1000i64), (1000, 37), (-200, 333)] {
        let mut unit = Unit::stepper();
        let ramp = Ramp::timed(Shape::Linear, 184, Feedrate::START_STOP);
        unit.start(Move::vector(dx, dy, feedrate, Some(ramp)));
        while !unit.indexer.is_complete(true) {
            unit.sample();
            let (x, y) = unit.registers();
            let aside = (x * dy - y * dx).abs() / dx.abs().max(dy.abs());
            assert!(aside <= 2, "{x} {y} of {dx} {dy}");
        }
        assert_eq!(unit.registers(), (dx, dy));
    }
}

#[test]
fn what_is_slower_than_start_stop_has_no_ramp() {
    let ramp = Ramp::timed(Shape::Linear, 500, Feedrate::start_stop(300).unwrap());
    let mut order = x(100, 200);
    order.ramp = Some(ramp);
    assert_close(Unit::stepper().time(order), 0.5, 2e-6);
    let mut order = x(600, 300);
    order.ramp = Some(ramp);
    assert_close(Unit::stepper().time(order), 2.0, 2e-6);
}

#[test]
fn an_exponential_ramp_gets_fast_sooner() {
    let ramp = |shape| Some(Ramp::timed(shape, 184, Feedrate::START_STOP));
    let mut linear = x(10_000, 10_000);
    linear.ramp = ramp(Shape::Linear);
    let mut exponential = linear;
    exponential.ramp = ramp(Shape::Exponential);
    let linear = Unit::stepper().time(linear);
    assert_close(linear, 1.0 + 0.184, 0.001);
    // The sum of (1 - e^(-3i/24)) / (1 - e^-3) for i = 1 to 23 is 16.80.
    let exponential = Unit::stepper().time(exponential);
    assert_close(exponential, 1.0 + 2.0 * (0.184 - 0.008 * 16.80), 0.001);
}

#[test]
fn the_shortest_time_between_feedrates_is_a_millisecond() {
    assert_eq!(
        Ramp::timed(Shape::Linear, 23, Feedrate::START_STOP).sample_us,
        1000
    );
    let fast = Feedrate::frequency(1000).unwrap();
    assert_eq!(Ramp::rated(fast, 5_000_000).sample_us, 1000);
    assert_eq!(
        Ramp::timed(Shape::Linear, 184, Feedrate::START_STOP).sample_us,
        8000
    );
}

#[test]
fn a_servo_lags_and_settles_a_stepper_does_not() {
    let mut unit = Unit::dc();
    unit.start(x(2000, 10_000));
    unit.run(150);
    let signals = unit.indexer.signals(Axis::X);
    assert_close(signals.register, 1500.0, 1.0);
    assert_close(signals.error, 200.0, 30.0);
    unit.run(51);
    assert!(unit.indexer.is_complete(true) && !unit.indexer.is_complete(false));
    let settling = unit.until(|indexer| indexer.is_complete(false));
    assert!((0.03..0.3).contains(&settling), "{settling}");
    unit.until(|indexer| !indexer.is_moving());
    assert_eq!(unit.tracking(), (2000, 0));

    let mut unit = Unit::stepper();
    unit.start(x(2000, 10_000));
    while !unit.indexer.is_complete(true) {
        unit.sample();
        assert_eq!(unit.tracking(), unit.registers());
    }
    assert!(unit.indexer.is_complete(false));
}

#[test]
fn a_servo_takes_the_highest_feedrate_without_a_ramp() {
    let mut unit = Unit::dc();
    unit.start(Move::independent(
        Some(leg(100_000, 150_000)),
        Some(leg(-100_000, 150_000)),
        None,
    ));
    unit.until(|indexer| !indexer.is_moving());
    assert_eq!(unit.tracking(), (100_000, -100_000));
    assert_eq!(unit.indexer.fault_words(), None);
}

#[test]
fn steps_slews_and_the_joystick() {
    let mut unit = Unit::stepper();
    for direction in [
        Direction::Negative,
        Direction::Negative,
        Direction::Positive,
    ] {
        unit.indexer.step(unit.now, Axis::Y, direction);
    }
    assert_eq!(unit.registers(), (0, -1));

    let slew = Feedrate::DEFAULT;
    unit.indexer
        .slew(unit.now, Axis::X, Direction::Positive, slew);
    unit.run(1000);
    unit.indexer.stop_axis(unit.now, Axis::X);
    unit.run(100);
    assert_eq!(unit.registers(), (250, -1));

    unit.indexer.joystick(unit.now, Some(20));
    unit.wire("joyx", -2000.0);
    unit.wire("joyy", 200.0);
    unit.run(1000);
    assert_eq!(unit.registers(), (150, 9));
    // A key overrides the joystick on its axis.
    unit.indexer
        .slew(unit.now, Axis::X, Direction::Positive, slew);
    unit.run(1000);
    assert_eq!(unit.registers(), (400, 19));
    unit.indexer.stop_axis(unit.now, Axis::X);
    unit.run(1000);
    assert_eq!(unit.registers(), (300, 29));
    unit.indexer.joystick(unit.now, None);
    unit.run(1000);
    assert_eq!(unit.registers(), (300, 29));
    unit.wire("joybutton", 1.0);
    assert_eq!(unit.events(), [Event::JoystickButton]);
}

#[test]
fn registers_and_tracking_displays_are_cleared_apart() {
    let mut unit = Unit::stepper();
    unit.time(x(100, 1000));
    unit.indexer.clear_tracking(unit.now, Axis::X);
    assert_eq!((unit.registers().0, unit.tracking().0), (100, 0));
    unit.indexer.preload(unit.now, Axis::X, -5);
    unit.time(x(10, 1000));
    assert_eq!((unit.registers().0, unit.tracking().0), (5, 10));
    unit.indexer.reset(unit.now);
    assert_eq!((unit.registers().0, unit.tracking().0), (0, 0));
}

#[test]
fn direction_jumpers_turn_the_motor_round_and_nothing_else() {
    for drive in [DriveKind::Dc, DriveKind::StepperHigh] {
        let reversed = Pair { x: true, y: false };
        let mut unit = Unit::of(Config {
            drive,
            reversed,
            ..Config::default()
        });
        unit.start(Move::independent(
            Some(leg(500, 5000)),
            Some(leg(500, 5000)),
            None,
        ));
        unit.until(|indexer| !indexer.is_moving());
        assert_eq!(
            (unit.registers(), unit.tracking()),
            ((500, 500), (500, 500))
        );
        assert_close(unit.indexer.signals(Axis::X).shaft, -0.25, 0.001);
        assert_close(unit.indexer.signals(Axis::Y).shaft, 0.25, 0.001);
    }
}

/// 5-6 B.
#[test]
fn hardware_home_is_the_marker_behind_the_switch() {
    for drive in [DriveKind::Dc, DriveKind::StepperHigh] {
        for start in [-300, 0, 700] {
            let mut unit = Unit::new(drive);
            unit.configure("x", "home", "-100");
            unit.time(x(start, 20_000));
            unit.indexer.home(
                unit.now,
                Pair {
                    x: Some(Feedrate::DEFAULT),
                    y: None,
                },
            );
            assert!(unit.indexer.is_busy(Axis::X) && !unit.indexer.is_busy(Axis::Y));
            unit.until(|indexer| indexer.is_complete(false) && !indexer.is_moving());
            assert_eq!((unit.registers(), unit.tracking()), ((0, 0), (0, 0)));
            assert!(unit.indexer.marker(Axis::X), "{drive:?} {start}");
            assert_close(unit.indexer.signals(Axis::X).shaft, 0.0, 0.001);
        }
    }
}

#[test]
fn software_home_is_the_switch_in_its_direction_at_its_feedrate() {
    let home = HomeKind::Software(Pair {
        x: Direction::Negative,
        y: Direction::Positive,
    });
    let mut unit = Unit::of(Config {
        drive: DriveKind::StepperLow,
        home,
        ..Config::default()
    });
    unit.configure("x", "home", "..-500");
    unit.configure("y", "home", "1000");
    let begin = unit.now;
    let at = |steps| Feedrate::frequency(steps);
    unit.indexer.home(
        unit.now,
        Pair {
            x: at(100),
            y: at(2000),
        },
    );
    unit.run(2000);
    assert_eq!(unit.registers(), (-200, 0));
    unit.until(|indexer| indexer.is_complete(true));
    assert_eq!(unit.registers(), (0, 0));
    assert_close(
        unit.indexer.finished_at().since(begin).seconds(),
        5.0,
        0.001,
    );
    assert_close(unit.indexer.signals(Axis::X).shaft, -0.25, 1e-9);
    assert_close(unit.indexer.signals(Axis::Y).shaft, 0.5, 1e-9);
}
