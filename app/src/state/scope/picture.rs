//! What there is to draw in a strip.

use motionbench_core::trace::{Bits, Extremes};

use super::scale::Scale;
use super::strips::{Strip, Trace};
use super::{Scope, View};

/// Levels of a lane of bits, as parts of its height.
const LANE_OFF: f64 = 0.2;
const LANE_ON: f64 = 0.75;

/// What there is to draw in a strip.
#[derive(Debug, Clone, PartialEq)]
pub struct Picture {
    /// Of its values; of lanes: their number.
    pub scale: Scale,
    /// Its lines.
    pub lines: Vec<Line>,
    /// The numbers of the bits whose lanes these are, from below.
    pub lanes: Vec<u32>,
}

/// One line.
#[derive(Debug, Clone, PartialEq)]
pub struct Line {
    /// Which of the four colours of lines, from 1.
    pub color: usize,
    /// The second of its strip.
    pub second: bool,
    /// In s from the zero of the time axis, and in the unit of the strip.
    pub points: Vec<(f64, f64)>,
}

impl Scope {
    /// What to draw in a strip within `view`: each line with at most two points for each of `columns`, as many as
    /// there are pixels, on a scale with about `marks` marks. `None` while there is nothing.
    pub fn picture(
        &self,
        strip: &Strip,
        view: View,
        columns: usize,
        marks: f64,
    ) -> Option<Picture> {
        if strip.has_lanes() {
            return self.lanes(&strip.traces, view, columns);
        }
        let to = self.until(view);
        let columns = shown_columns(view, to, columns);
        let shown = View { to, ..view };
        let all: Vec<_> = strip
            .traces
            .iter()
            .map(|trace| self.trace.extremes(trace.signal, view.from, to, columns))
            .collect();
        let found = all.iter().flatten().flatten();
        let whole = found.copied().reduce(|a, b| Extremes {
            min: a.min.min(b.min),
            max: a.max.max(b.max),
        })?;
        let line = |(place, (trace, extremes)): (usize, (&Trace, &Vec<Option<Extremes>>))| Line {
            color: trace.color,
            second: place > 0,
            points: self.joined(trace.signal, shown, points(shown, extremes)),
        };
        Some(Picture {
            scale: strip.scale(whole.min, whole.max, marks),
            lines: strip
                .traces
                .iter()
                .zip(&all)
                .enumerate()
                .map(line)
                .collect(),
            lanes: Vec::new(),
        })
    }

    /// A line that goes on beyond both edges of the picture, where there are samples.
    fn joined(&self, signal: usize, view: View, mut points: Vec<(f64, f64)>) -> Vec<(f64, f64)> {
        let point = |at| Some((view.seconds(at), self.trace.value(signal, at)?));
        if let Some(before) = self.trace.before(view.from).and_then(point) {
            points.insert(0, before);
        }
        let last = self.recorded().map(|(_, last)| last);
        let after = self.trace.after(view.to).filter(|&at| Some(at) <= last);
        points.extend(after.and_then(point));
        points
    }

    /// A lane for each bit that has ever been on.
    fn lanes(&self, traces: &[Trace], view: View, columns: usize) -> Option<Picture> {
        let trace = traces.first()?;
        let to = self.until(view);
        let columns = shown_columns(view, to, columns);
        let bits = self.trace.bits(trace.signal, view.from, to, columns);
        let ever = self.ever.get(trace.signal).copied().unwrap_or_default();
        let lanes: Vec<u32> = (0..32).filter(|bit| ever & 1 << bit != 0).collect();
        let shown = View { to, ..view };
        let line = |(lane, &bit): (usize, &u32)| Line {
            color: trace.color,
            second: false,
            points: steps(shown, &bits, bit, lane as f64),
        };
        Some(Picture {
            scale: Scale {
                low: 0.0,
                high: lanes.len().max(1) as f64,
                step: 1.0,
            },
            lines: lanes.iter().enumerate().map(line).collect(),
            lanes,
        })
    }
}

/// The columns that are left of `to`.
fn shown_columns(view: View, to: motionbench_core::time::Nanos, columns: usize) -> usize {
    (view.place(to).clamp(0.0, 1.0) * columns as f64)
        .ceil()
        .max(1.0) as usize
}

/// A line through the extremes of each column.
fn points(view: View, columns: &[Option<Extremes>]) -> Vec<(f64, f64)> {
    let (left, width) = columns_of(view, columns.len());
    let mut points = Vec::with_capacity(2 * columns.len());
    let mut last = f64::NEG_INFINITY;
    for (column, extremes) in columns.iter().enumerate() {
        let Some(extremes) = extremes else { continue };
        let at = left + (column as f64 + 0.5) * width;
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

/// The line of one bit, with a point where it changes.
fn steps(view: View, columns: &[Option<Bits>], bit: u32, lane: f64) -> Vec<(f64, f64)> {
    let (left, width) = columns_of(view, columns.len());
    let level = |on: bool| lane + if on { LANE_ON } else { LANE_OFF };
    let mut points: Vec<(f64, f64)> = Vec::new();
    let mut end = left;
    for (column, bits) in columns.iter().enumerate() {
        let Some(bits) = bits else { continue };
        let at = left + (column as f64 + 0.5) * width;
        let (all, any) = (bits.all & 1 << bit != 0, bits.any & 1 << bit != 0);
        match points.last() {
            None => points.push((at, level(all))),
            Some(&(_, before)) if all == any && before == level(all) => {}
            Some(&(_, before)) => {
                // One that changes within the column has the other level at its end, or the next column corrects it.
                let now = if all == any {
                    all
                } else {
                    before == level(false)
                };
                points.extend([(at, before), (at, level(now))]);
            }
        }
        end = at;
    }
    if let Some(&(_, before)) = points.last() {
        points.push((end, before));
    }
    points
}

/// The left edge and the width of columns, s.
fn columns_of(view: View, columns: usize) -> (f64, f64) {
    let left = view.seconds(view.from);
    (left, (view.seconds(view.to) - left) / columns.max(1) as f64)
}

/// The points of a line that goes from left to right which are needed to draw it no further than `tolerance` from
/// where it is: of what is level or straight, both ends.
pub fn thin(points: impl IntoIterator<Item = (i32, i32)>, tolerance: i32) -> Vec<(i32, i32)> {
    let tolerance = f64::from(tolerance);
    let mut kept: Vec<(i32, i32)> = Vec::new();
    // The last point that is not kept yet, and the slopes of lines from the last kept one that pass all between.
    let mut open: Option<(i32, i32)> = None;
    let mut slopes = (f64::NEG_INFINITY, f64::INFINITY);
    for point in points {
        let Some(&(x, y)) = kept.last() else {
            kept.push(point);
            continue;
        };
        let slope = |x: i32, y: i32, off: f64| {
            let (width, height) = (f64::from(point.0 - x), f64::from(point.1 - y));
            (height + off) / width
        };
        let narrowed = (
            slopes.0.max(slope(x, y, -tolerance)),
            slopes.1.min(slope(x, y, tolerance)),
        );
        let direct = slope(x, y, 0.0);
        if point.0 > x && (narrowed.0..=narrowed.1).contains(&direct) {
            (open, slopes) = (Some(point), narrowed);
            continue;
        }
        kept.extend(open.take());
        slopes = (f64::NEG_INFINITY, f64::INFINITY);
        let (x, y) = kept.last().copied().unwrap_or(point);
        if point.0 > x {
            slopes = (slope(x, y, -tolerance), slope(x, y, tolerance));
            open = Some(point);
        } else {
            kept.push(point);
        }
    }
    kept.extend(open);
    kept
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn straight_parts_need_their_ends_alone() {
        let level = (0..100).map(|x| (x, 7));
        let rise = (100..200).map(|x| (x, 7 + (x - 99) * 3));
        assert_eq!(thin(level.chain(rise), 1), [(0, 7), (99, 7), (199, 307)]);
    }

    #[test]
    fn a_thinned_line_is_nowhere_far_from_the_line() {
        let wave = |x: i32| (f64::from(x) / 40.0).sin() * 300.0;
        let points: Vec<(i32, i32)> = (0..1000).map(|x| (x, wave(x) as i32)).collect();
        let kept = thin(points.iter().copied(), 2);
        assert!(kept.len() < 200, "{} points", kept.len());
        for pair in kept.windows(2) {
            let ((left, from), (right, to)) = (pair[0], pair[1]);
            for &(x, y) in &points[left as usize..=right as usize] {
                let part = f64::from(x - left) / f64::from(right - left);
                let drawn = f64::from(from) + f64::from(to - from) * part;
                assert!((drawn - f64::from(y)).abs() <= 4.0, "at {x}");
            }
        }
        assert_eq!(kept.last(), points.last());
    }

    #[test]
    fn spikes_and_steps_stay() {
        let points = [(0, 0), (5, 0), (5, 90), (6, 0), (9, 0), (9, 40), (9, 0)];
        assert_eq!(
            thin(points, 2),
            [(0, 0), (5, 0), (5, 90), (6, 0), (9, 0), (9, 40), (9, 0)]
        );
        assert!(thin([], 2).is_empty());
    }
}
