//! The oscilloscope: what was recorded, and which part of it is shown at which scale.
//!
//! It triggers on the start of motion: the picture begins where an axis that stood begins to move, grows with the
//! motion, and stands still when the axis does.

use motionbench_core::controller::Signal;
use motionbench_core::time::Nanos;
use motionbench_core::trace::Trace;

use crate::protocol;

/// Rows kept: nearly nine minutes at 500 a second.
const ROWS: usize = 1 << 18;
/// An axis that stood so long begins a new picture.
const PAUSE: Nanos = Nanos::from_millis(2000);
/// Shown at least, behind the end of a motion.
const TAIL: Nanos = Nanos::from_millis(100);
/// Widths of the picture, s; a longer motion moves through the last.
const WIDTHS_S: [u64; 6] = [1, 2, 5, 10, 20, 60];

/// What is drawn: names of signals, and what they are to people. A strip each, the first decides what motion is.
const STRIPS: [(&str, &str); 2] = [("x.command", "position"), ("x.velocity", "velocity")];

/// The recording, and the picture of it.
#[derive(Debug)]
pub struct Scope {
    trace: Trace,
    strips: Vec<Strip>,
    /// The drawn values of the newest row.
    newest: Vec<f64>,
    motion: Option<Motion>,
}

/// One strip of the picture.
#[derive(Debug, Clone, PartialEq)]
pub struct Strip {
    /// For people.
    pub label: &'static str,
    /// For example `counts`.
    pub unit: String,
    /// The column of the trace.
    signal: usize,
}

/// When the shown motion began, and when something last changed.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Motion {
    start: Nanos,
    last: Nanos,
}

/// A part of simulated time.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct View {
    /// Where the time axis has its zero.
    pub zero: Nanos,
    /// Left edge.
    pub from: Nanos,
    /// Right edge.
    pub to: Nanos,
}

/// The scale of an axis: its ends, which are multiples of the distance of its marks.
#[derive(Debug, Clone, Copy, PartialEq)]
#[allow(missing_docs)]
pub struct Scale {
    pub low: f64,
    pub high: f64,
    pub step: f64,
}

impl Default for Scope {
    fn default() -> Scope {
        Scope::new(&[])
    }
}

impl Scope {
    /// An empty recording of these signals.
    pub fn new(signals: &[Signal]) -> Scope {
        let strip = |&(name, label): &(&str, &'static str)| {
            let signal = signals.iter().position(|signal| signal.name == name)?;
            let unit = signals[signal].unit.clone();
            Some(Strip {
                label,
                unit,
                signal,
            })
        };
        Scope {
            trace: Trace::new(signals.len(), ROWS),
            strips: STRIPS.iter().filter_map(strip).collect(),
            newest: Vec::new(),
            motion: None,
        }
    }

    /// Appends samples. In those of a `power_cycle` a register that jumps is no motion.
    /// Returns whether what is shown has changed.
    pub fn take(&mut self, samples: &[f64], power_cycle: bool) -> bool {
        let Scope {
            trace,
            strips,
            newest,
            motion,
        } = self;
        let shown = view(*motion);
        let before = *motion;
        let mut visible = false;
        let mut previous = trace.span().map(|(_, last)| last);
        protocol::unpack(samples, trace, |at, row| {
            let values = strips.iter().map(|strip| row[strip.signal]);
            if !newest.iter().copied().eq(values.clone()) {
                if !newest.is_empty() && !power_cycle {
                    let start = previous.unwrap_or(at);
                    let fresh = motion.is_none_or(|motion| at.since(motion.last) > PAUSE);
                    let start = if fresh {
                        start
                    } else {
                        motion.map_or(start, |m| m.start)
                    };
                    *motion = Some(Motion { start, last: at });
                }
                newest.clear();
                newest.extend(values);
                visible = true;
            }
            visible |= shown.is_some_and(|view| at <= view.to);
            previous = Some(at);
        });
        visible || *motion != before
    }

    /// The strips, from the top.
    pub fn strips(&self) -> &[Strip] {
        &self.strips
    }

    /// The newest value of a strip.
    pub fn newest(&self, strip: usize) -> Option<f64> {
        self.newest.get(strip).copied()
    }

    /// What is shown; `None` before anything has moved.
    pub fn view(&self) -> Option<View> {
        view(self.motion)
    }

    /// The scale that a strip needs within `view`, with about `marks` marks.
    pub fn scale(&self, strip: usize, view: View, marks: f64) -> Option<Scale> {
        let signal = self.strips.get(strip)?.signal;
        let extremes = self.trace.extremes(signal, view.from, view.to, 1);
        let extremes = extremes.first().copied().flatten()?;
        Some(Scale::fit(extremes.min, extremes.max, marks))
    }

    /// A strip's line within `view`, in s from its zero and the signal's unit, with at most two points for each of
    /// `columns`: as many as there are pixels.
    pub fn line(&self, strip: usize, view: View, columns: usize) -> Vec<(f64, f64)> {
        let Some(strip) = self.strips.get(strip) else {
            return Vec::new();
        };
        let width = view.to.since(view.from).seconds() / columns as f64;
        let left = view.from.since(view.zero).seconds() + width / 2.0;
        let mut points = Vec::with_capacity(2 * columns);
        let mut last = f64::NEG_INFINITY;
        let extremes = self
            .trace
            .extremes(strip.signal, view.from, view.to, columns);
        for (column, extremes) in extremes.into_iter().enumerate() {
            let Some(extremes) = extremes else { continue };
            let at = left + column as f64 * width;
            // Down or up, whichever goes on from where the line is.
            let falls = (last - extremes.max).abs() < (last - extremes.min).abs();
            let (first, second) = if falls {
                (extremes.max, extremes.min)
            } else {
                (extremes.min, extremes.max)
            };
            points.push((at, first));
            if second != first {
                points.push((at, second));
            }
            last = second;
        }
        points
    }
}

fn view(motion: Option<Motion>) -> Option<View> {
    let Motion { start, last } = motion?;
    let needed = last.since(start) + TAIL;
    let fits = |&&width: &&u64| Nanos::from_millis(width * 1000) >= needed;
    let width = WIDTHS_S.iter().find(fits).or(WIDTHS_S.last())?;
    let width = Nanos::from_millis(width * 1000);
    let from = start + needed.since(width);
    Some(View {
        zero: start,
        from,
        to: from + width,
    })
}

impl View {
    /// The time axis, in s from its zero.
    pub fn scale(&self) -> Scale {
        let low = self.from.since(self.zero).seconds();
        let high = self.to.since(self.zero).seconds();
        Scale {
            low,
            high,
            step: nice((high - low) / 5.0),
        }
    }
}

impl Scale {
    /// The smallest scale with about `marks` marks that holds both values.
    pub fn fit(min: f64, max: f64, marks: f64) -> Scale {
        // A line that is level lies in the middle.
        let span = if max > min {
            max - min
        } else {
            2.0 * min.abs().max(1.0)
        };
        let step = nice(span / marks);
        if max > min {
            Scale {
                low: (min / step).floor() * step,
                high: (max / step).ceil() * step,
                step,
            }
        } else {
            let middle = (min / step).round() * step;
            Scale {
                low: middle - step,
                high: middle + step,
                step,
            }
        }
    }

    /// Where its marks are.
    pub fn marks(&self) -> impl Iterator<Item = f64> + use<> {
        let Scale { low, high, step } = *self;
        let (first, last) = (
            (low / step).ceil() as i64,
            (high / step + 1e-9).floor() as i64,
        );
        (first..=last).map(move |mark| mark as f64 * step)
    }

    /// Digits behind the point that tell its marks apart.
    pub fn digits(&self) -> usize {
        (-self.step.log10().floor()).clamp(0.0, 9.0) as usize
    }
}

/// The nearest 1, 2 or 5 times a power of ten that is not smaller.
fn nice(size: f64) -> f64 {
    let power = 10f64.powf(size.max(1e-9).log10().floor());
    let steps = [1.0, 2.0, 5.0, 10.0];
    // A little tolerance, as 0.2 has no exact form.
    let step = steps
        .iter()
        .find(|&&step| step * power >= size * (1.0 - 1e-9));
    step.unwrap_or(&10.0) * power
}

#[cfg(test)]
mod tests {
    use super::*;

    fn signals() -> Vec<Signal> {
        let signal = |name: &str, unit: &str| Signal {
            name: name.to_owned(),
            unit: unit.to_owned(),
        };
        vec![
            signal("x.position", "counts"),
            signal("x.command", "counts"),
            signal("x.velocity", "counts/s"),
        ]
    }

    /// Samples of 2 ms from `from_ms` on, at the given demanded positions.
    fn samples(from_ms: u64, positions: &[f64]) -> Vec<f64> {
        let mut trace = Trace::new(3, positions.len());
        for (i, &position) in positions.iter().enumerate() {
            let at = Nanos::from_millis(from_ms + 2 * i as u64);
            trace.push(at, &[0.0, position, 500.0 * position]);
        }
        protocol::pack(&trace)
    }

    fn ramp(from: f64, to: f64, rows: usize) -> Vec<f64> {
        (0..rows)
            .map(|i| from + (to - from) * i as f64 / (rows - 1) as f64)
            .collect()
    }

    #[test]
    fn nothing_is_shown_until_something_moves() {
        let mut scope = Scope::new(&signals());
        scope.take(&samples(0, &[7.0; 1000]), false);
        assert_eq!(scope.view(), None);
        assert_eq!(scope.newest(0), Some(7.0));
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
            (view.zero, view.from),
            (Nanos::from_millis(2000), view.zero)
        );
        assert_eq!(view.to, Nanos::from_millis(4000));
        assert_eq!(
            scope.scale(0, view, 3.0).unwrap(),
            Scale {
                low: 0.0,
                high: 60_000.0,
                step: 20_000.0
            }
        );
        let line = scope.line(0, view, 200);
        assert_eq!(line.last().unwrap().1, 40_960.0);
        assert!(
            line.windows(2).all(|pair| pair[0].1 <= pair[1].1),
            "a ramp is drawn as a ramp"
        );
        assert!(line.len() <= 400);
    }

    #[test]
    fn it_stands_still_when_the_axis_does_and_its_line_is_complete() {
        let mut scope = Scope::new(&signals());
        scope.take(&samples(0, &ramp(0.0, 100.0, 400)), false);
        assert!(
            scope.take(&samples(800, &[100.0; 50]), false),
            "the line goes on to the right edge"
        );
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
        assert_eq!(scope.view().unwrap().to, Nanos::from_millis(5000));
        scope.take(&samples(2600, &[200.0; 2000]), false);
        scope.take(&samples(6600, &ramp(200.0, 300.0, 400)), false);
        assert_eq!(scope.view().unwrap().zero, Nanos::from_millis(6600));
    }

    #[test]
    fn a_long_motion_moves_through_the_picture() {
        let mut scope = Scope::new(&signals());
        scope.take(&samples(0, &ramp(0.0, 1e6, 45_000)), false);
        let view = scope.view().unwrap();
        assert_eq!(view.to.since(view.from), Nanos::from_millis(60_000));
        assert!(view.to > Nanos::from_millis(89_998) && view.from > view.zero);
        assert!(
            view.scale()
                .marks()
                .all(|s| s >= view.from.seconds() && s <= view.to.seconds())
        );
    }

    #[test]
    fn a_register_reset_by_the_mains_switch_is_no_motion() {
        let mut scope = Scope::new(&signals());
        scope.take(&samples(0, &[500.0; 10]), false);
        scope.take(&samples(20, &[500.0, 0.0, 0.0]), true);
        assert_eq!(scope.view(), None);
        assert_eq!(scope.newest(0), Some(0.0));
    }

    #[test]
    fn scales_are_round_and_hold_the_values() {
        let scale = Scale::fit(-3.2, 48_211.0, 3.0);
        assert_eq!(
            (scale.low, scale.high, scale.step),
            (-20_000.0, 60_000.0, 20_000.0)
        );
        assert_eq!(
            scale.marks().collect::<Vec<_>>(),
            [-2e4, 0.0, 2e4, 4e4, 6e4]
        );
        assert_eq!(
            Scale::fit(0.0, 0.0, 3.0).marks().collect::<Vec<_>>(),
            [-1.0, 0.0, 1.0]
        );
        assert_eq!(Scale::fit(0.0, 0.6, 3.0).digits(), 1);
        assert_eq!(scale.digits(), 0);
    }
}
