//! Two cursors on the time axis, and what the signals are at them.

use motionbench_core::time::Nanos;

use super::{Scope, View};

/// Where a picture's cursors are when they appear, as parts of its width.
const PLACES: [f64; 2] = [0.35, 0.65];
/// A key moves a cursor by this part of the picture's width, or by a sample if that is more.
const STEP: f64 = 1.0 / 400.0;

/// The values of a signal at both cursors.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Reading {
    /// At the first and at the second.
    pub values: [f64; 2],
    /// From the first cursor to the second, s; negative if they have passed each other.
    pub seconds: f64,
}

impl Reading {
    /// The second value less the first.
    pub fn difference(&self) -> f64 {
        self.values[1] - self.values[0]
    }

    /// Of the straight line between both, a second; `None` where the cursors are at one time.
    pub fn slope(&self) -> Option<f64> {
        (self.seconds != 0.0).then(|| self.difference() / self.seconds)
    }
}

impl Scope {
    /// Shows the cursors, within the picture, or takes them away.
    pub fn show_cursors(&mut self, show: bool) {
        let Some(view) = self.view().filter(|_| show) else {
            self.cursors = None;
            return;
        };
        let at = |place| self.trace.nearest(view.time(place));
        self.cursors = match PLACES.map(at) {
            [Some(first), Some(second)] => Some([first, second]),
            _ => None,
        };
    }

    /// Where the cursors are.
    pub fn cursors(&self) -> Option<[Nanos; 2]> {
        self.cursors
    }

    /// Moves a cursor to the sample nearest to a place of the picture.
    pub fn move_cursor(&mut self, which: usize, place: f64) {
        if let Some(view) = self.view() {
            let at = self.trace.nearest(view.time(place.clamp(0.0, 1.0)));
            self.set_cursor(which, at);
        }
    }

    /// Moves a cursor by so many steps, to the right or to the left; each is a sample at least.
    pub fn step_cursor(&mut self, which: usize, steps: f64) {
        let at = self.cursors.and_then(|at| at.get(which).copied());
        let (Some(at), Some(view)) = (at, self.view()) else {
            return;
        };
        let distance = Nanos::from_seconds(view.width().seconds() * STEP * steps.abs());
        let (to, neighbour) = if steps > 0.0 {
            (at + distance, self.trace.after(at))
        } else {
            (at.since(distance), self.trace.before(at))
        };
        let near = self.trace.nearest(to).filter(|&near| near != at);
        self.set_cursor(which, near.or(neighbour));
    }

    fn set_cursor(&mut self, which: usize, at: Option<Nanos>) {
        let cursor = self.cursors.as_mut().and_then(|both| both.get_mut(which));
        if let (Some(cursor), Some(at)) = (cursor, at) {
            *cursor = at;
        }
    }

    /// From the first cursor to the second, s.
    pub fn between_cursors(&self) -> Option<f64> {
        let [first, second] = self.cursors?;
        let from_first = View {
            zero: first,
            from: first,
            to: second,
        };
        Some(from_first.seconds(second))
    }

    /// The values of a signal at the cursors.
    pub fn reading(&self, signal: usize) -> Option<Reading> {
        let [first, second] = self.cursors?;
        let value = |at| self.trace.value(signal, at);
        Some(Reading {
            values: [value(first)?, value(second)?],
            seconds: self.between_cursors()?,
        })
    }
}
