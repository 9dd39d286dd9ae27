//! Which signals are drawn, and in which strip.

use motionbench_core::controller::Signal;

use super::scale::Scale;

/// One strip of the picture.
#[derive(Debug, Clone, PartialEq)]
pub struct Strip {
    /// What it shows, for people; no two strips have the same.
    pub name: String,
    /// For example `counts`.
    pub unit: String,
    /// The lines, in the order in which the signals were recorded; never none.
    pub traces: Vec<Trace>,
    /// The scale that it keeps whatever the values are.
    pub fixed: Option<Scale>,
    /// Folded or not, by the user; `None` leaves it to the room that there is.
    pub folded: Option<bool>,
}

/// One line of a strip.
#[derive(Debug, Clone, PartialEq)]
pub struct Trace {
    /// The column of the recording.
    pub signal: usize,
    /// What tells it from the other line of the strip, for people; empty where there can be no other.
    pub name: String,
    /// Which of the four colours of lines, from 1.
    pub color: usize,
    /// Bits: a lane for each.
    pub bits: bool,
    /// The automatic scale spans no less.
    least: f64,
}

/// What a signal is to people.
struct Kind {
    /// The signal's name, behind that of its axis.
    signal: &'static str,
    strip: &'static str,
    trace: &'static str,
    color: usize,
    least: f64,
    /// Shown until the user chooses.
    shown: bool,
}

const fn kind(
    signal: &'static str,
    strip: &'static str,
    trace: &'static str,
    color: usize,
    least: f64,
    shown: bool,
) -> Kind {
    Kind {
        signal,
        strip,
        trace,
        color,
        least,
        shown,
    }
}

/// In the order of the strips. Smaller spans than these are noise to look at.
const KINDS: [Kind; 18] = [
    kind("x.command", "position", "demanded", 1, 10.0, true),
    kind("x.position", "position", "actual", 2, 10.0, true),
    kind("x.velocity", "velocity", "demanded", 3, 100.0, true),
    kind("x.speed", "velocity", "actual", 2, 100.0, false),
    kind("x.acceleration", "acceleration", "", 1, 10.0, false),
    kind("y.command", "position Y", "demanded", 1, 10.0, true),
    kind("y.position", "position Y", "actual", 2, 10.0, true),
    kind("y.velocity", "velocity Y", "demanded", 3, 100.0, true),
    kind("x.error", "following error", "", 4, 4.0, true),
    kind("y.error", "following error Y", "", 4, 4.0, false),
    kind("y.acceleration", "acceleration Y", "", 1, 10.0, false),
    kind("x.output", "torque", "", 3, 0.1, false),
    kind("y.output", "torque Y", "", 3, 0.1, false),
    kind("x.shaft", "motor shaft", "", 4, 0.1, false),
    kind("inputs", "inputs", "", 1, 1.0, false),
    kind("outputs", "outputs", "", 3, 1.0, false),
    kind("m", "M outputs", "", 3, 1.0, false),
    kind("c", "C inputs", "", 1, 1.0, false),
];

/// The unit of signals that hold bits.
const BITS: &str = "bits";

/// The strips of these signals that are shown until the user chooses.
pub(super) fn initial(signals: &[Signal]) -> Vec<Strip> {
    let mut strips = Vec::new();
    for (signal, recorded) in signals.iter().enumerate() {
        if place(&recorded.name).is_some_and(|place| KINDS[place].shown) {
            add(&mut strips, signals, signal);
        }
    }
    strips
}

/// The same strips of signals that may be recorded in another order, or not any more.
pub(super) fn again(strips: &[Strip], before: &[Signal], signals: &[Signal]) -> Vec<Strip> {
    let moved = |trace: &Trace| {
        let name = &before.get(trace.signal)?.name;
        let signal = signals.iter().position(|signal| signal.name == *name)?;
        Some(Trace {
            signal,
            ..trace.clone()
        })
    };
    let again = strips.iter().map(|strip| Strip {
        traces: strip.traces.iter().filter_map(moved).collect(),
        ..strip.clone()
    });
    again.filter(|strip| !strip.traces.is_empty()).collect()
}

/// What people call a signal.
pub fn name(signal: &Signal) -> String {
    match place(&signal.name).map(|place| &KINDS[place]) {
        Some(kind) if kind.trace.is_empty() => kind.strip.to_owned(),
        Some(kind) => format!("{}, {}", kind.strip, kind.trace),
        None => signal.name.clone(),
    }
}

/// Draws a signal, in the strip where it belongs.
pub(super) fn add(strips: &mut Vec<Strip>, signals: &[Signal], signal: usize) {
    let Some(recorded) = signals.get(signal) else {
        return;
    };
    let kind = place(&recorded.name).map(|place| &KINDS[place]);
    let trace = Trace {
        signal,
        name: kind.map_or_else(String::new, |kind| kind.trace.to_owned()),
        color: kind.map_or(1 + signal % 4, |kind| kind.color),
        bits: recorded.unit == BITS,
        least: kind.map_or(0.0, |kind| kind.least),
    };
    let name = kind.map_or(recorded.name.as_str(), |kind| kind.strip);
    if let Some(strip) = strips.iter_mut().find(|strip| strip.name == name) {
        let before = strip.traces.partition_point(|other| other.signal < signal);
        strip.traces.insert(before, trace);
        return;
    }
    let rank = |name: &str| KINDS.iter().position(|kind| kind.strip == name);
    let rank = |name: &str| rank(name).unwrap_or(KINDS.len());
    let before = strips.partition_point(|strip| rank(&strip.name) <= rank(name));
    let strip = Strip {
        name: name.to_owned(),
        unit: recorded.unit.clone(),
        traces: vec![trace],
        fixed: None,
        folded: None,
    };
    strips.insert(before, strip);
}

/// No longer draws a signal; a strip without one goes.
pub(super) fn remove(strips: &mut Vec<Strip>, signal: usize) {
    for strip in &mut *strips {
        strip.traces.retain(|trace| trace.signal != signal);
    }
    strips.retain(|strip| !strip.traces.is_empty());
}

fn place(signal: &str) -> Option<usize> {
    KINDS.iter().position(|kind| kind.signal == signal)
}

/// Which strips are folded to their names and values, when there is room for the plots of so many: the user's wishes
/// first, then from the top.
pub fn folded(strips: &[Strip], room: usize) -> Vec<bool> {
    let wanted = strips.iter().filter(|s| s.folded == Some(false)).count();
    let mut left = room.max(1).saturating_sub(wanted);
    let mut fold = |strip: &Strip| {
        strip.folded.unwrap_or_else(|| {
            let fits = left > 0;
            left = left.saturating_sub(1);
            !fits
        })
    };
    strips.iter().map(&mut fold).collect()
}

impl Strip {
    /// The scale that its lines need, which lie between `min` and `max`, with about `marks` marks.
    pub(super) fn scale(&self, min: f64, max: f64, marks: f64) -> Scale {
        if let Some(Scale { low, high, .. }) = self.fixed {
            return Scale::between(low, high, marks).unwrap_or(Scale::fit(min, max, marks));
        }
        let least = self.traces.iter().fold(0.0, |least, t| t.least.max(least));
        let missing = (least - (max - min)).max(0.0);
        // Around the line; level with zero it has zero as its middle.
        Scale::fit(min - missing / 2.0, max + missing / 2.0, marks)
    }

    /// Whether it shows lanes of bits, which need no scale.
    pub fn has_lanes(&self) -> bool {
        self.traces.iter().any(|trace| trace.bits)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn signals(names: &[&str]) -> Vec<Signal> {
        let signal = |name: &&str| Signal {
            name: (*name).to_owned(),
            unit: if name.ends_with("puts") {
                BITS
            } else {
                "counts"
            }
            .to_owned(),
        };
        names.iter().map(signal).collect()
    }

    const ALL: [&str; 7] = [
        "x.command",
        "x.position",
        "x.velocity",
        "x.speed",
        "x.error",
        "inputs",
        "gauge",
    ];

    fn names(strips: &[Strip]) -> Vec<(&str, usize)> {
        strips
            .iter()
            .map(|strip| (strip.name.as_str(), strip.traces.len()))
            .collect()
    }

    #[test]
    fn at_first_there_are_both_positions_velocity_and_following_error() {
        let strips = initial(&signals(&ALL));
        assert_eq!(
            names(&strips),
            [("position", 2), ("velocity", 1), ("following error", 1)]
        );
        assert_eq!(strips[0].traces[1].name, "actual");
    }

    #[test]
    fn a_signal_joins_its_strip_or_makes_one_in_its_place() {
        let all = signals(&ALL);
        let mut strips = initial(&all);
        for signal in [6, 5, 3] {
            add(&mut strips, &all, signal);
        }
        assert_eq!(
            names(&strips),
            [
                ("position", 2),
                ("velocity", 2),
                ("following error", 1),
                ("inputs", 1),
                ("gauge", 1)
            ]
        );
        assert!(strips[3].has_lanes());
        remove(&mut strips, 0);
        remove(&mut strips, 4);
        assert_eq!(strips[0].traces[0].name, "actual");
        assert_eq!(
            names(&strips)[..3],
            [("position", 1), ("velocity", 2), ("inputs", 1)]
        );
    }

    #[test]
    fn a_simulator_that_starts_again_is_shown_in_the_same_strips() {
        let before = signals(&ALL);
        let mut strips = initial(&before);
        remove(&mut strips, 2);
        strips[0].fixed = Scale::between(0.0, 5.0, 3.0);
        let now = signals(&["x.velocity", "x.position", "x.error"]);
        let strips = again(&strips, &before, &now);
        assert_eq!(names(&strips), [("position", 1), ("following error", 1)]);
        assert_eq!(
            (strips[0].traces[0].signal, strips[1].traces[0].signal),
            (1, 2)
        );
        assert!(strips[0].fixed.is_some());
    }

    #[test]
    fn the_lowest_strips_fold_first_unless_the_user_wants_them() {
        let mut strips = initial(&signals(&ALL));
        assert_eq!(folded(&strips, 3), [false, false, false]);
        assert_eq!(folded(&strips, 2), [false, false, true]);
        assert_eq!(folded(&strips, 0), [false, true, true]);
        strips[2].folded = Some(false);
        assert_eq!(folded(&strips, 2), [false, true, false]);
        strips[0].folded = Some(true);
        assert_eq!(folded(&strips, 2), [true, false, false]);
    }

    #[test]
    fn noise_is_not_blown_up_and_a_fixed_scale_stays() {
        let mut strips = initial(&signals(&ALL));
        let scale = strips[2].scale(-0.01, 0.01, 3.0);
        assert!(scale.low <= -2.0 && scale.high >= 2.0, "{scale:?}");
        strips[2].fixed = Scale::between(-1.0, 7.0, 3.0);
        assert_eq!(strips[2].scale(0.0, 900.0, 3.0).high, 7.0);
    }
}
