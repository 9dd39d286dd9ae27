//! The oscilloscope: what was recorded, and which part of it is shown at which scale.
//!
//! All signals are recorded, shown or not. Until the user chooses otherwise it triggers on the start of motion.

use motionbench_core::controller::Signal;
use motionbench_core::time::Nanos;
use motionbench_core::trace::Trace;

use crate::protocol;

mod cursors;
mod export;
mod picture;
mod scale;
mod strips;
#[cfg(test)]
mod tests;
mod touches;
mod window;

pub use cursors::Reading;
pub use picture::{Line, Picture, thin};
pub use scale::Scale;
pub use strips::{Strip, Trace as Shown, folded, name};
pub use touches::{Moved, Touches};
pub use window::{Follow, View};

use window::Window;

/// Rows kept: nearly nine minutes at 500 a second.
const ROWS: usize = 1 << 18;
/// What is demanded of the axis: motion is when one of these changes.
const DEMANDED: [&str; 4] = ["x.command", "x.velocity", "y.command", "y.velocity"];

/// The recording, and the picture of it.
#[derive(Debug)]
pub struct Scope {
    signals: Vec<Signal>,
    trace: Trace,
    /// The newest row, and the bits that were ever on in each column.
    newest: Vec<f64>,
    ever: Vec<u32>,
    strips: Vec<Strip>,
    window: Window,
    paused: Option<Paused>,
    cursors: Option<[Nanos; 2]>,
}

/// The picture stands still; the machine and the recording do not.
#[derive(Debug, Clone)]
struct Paused {
    view: Option<View>,
    until: Nanos,
    row: Vec<f64>,
}

impl Default for Scope {
    fn default() -> Scope {
        Scope::new(&[])
    }
}

impl Scope {
    /// An empty recording of these signals.
    pub fn new(signals: &[Signal]) -> Scope {
        Scope::keeping(signals, ROWS)
    }

    /// An empty recording that keeps so many rows.
    fn keeping(signals: &[Signal], rows: usize) -> Scope {
        Scope {
            signals: signals.to_vec(),
            trace: Trace::new(signals.len(), rows),
            newest: Vec::new(),
            ever: vec![0; signals.len()],
            strips: strips::initial(signals),
            window: Window::default(),
            paused: None,
            cursors: None,
        }
    }

    /// Begins a new recording, one of so many at the same time, of a simulator that starts again. What the user chose to
    /// see stays.
    pub fn start(&mut self, signals: &[Signal], recordings: usize) {
        let mut started = Scope::keeping(signals, ROWS / recordings.max(1));
        if !self.signals.is_empty() {
            started.strips = strips::again(&self.strips, &self.signals, signals);
            if self.window.follow == Follow::Newest {
                started.window.follow = Follow::Newest;
            }
        }
        *self = started;
    }

    /// Appends samples. In those of a `power_cycle` a register that jumps is no motion.
    /// Returns whether what is shown has changed.
    pub fn take(&mut self, samples: &[f64], power_cycle: bool) -> bool {
        let shown = self.view();
        let demanded = DEMANDED.map(|name| self.signals.iter().position(|s| s.name == name));
        let Scope {
            trace,
            newest,
            ever,
            window,
            ..
        } = self;
        let mut previous = trace.span().map(|(_, last)| last);
        let mut visible = false;
        let mut values_changed = false;
        protocol::unpack(samples, trace, |at, row| {
            let moved = |column: &usize| newest.get(*column) != row.get(*column);
            if !newest.is_empty() && !power_cycle && demanded.iter().flatten().any(moved) {
                window.moved(previous.unwrap_or(at), at);
            }
            if newest != row {
                newest.clear();
                newest.extend_from_slice(row);
                let bits = |(ever, value): (&mut u32, &f64)| *ever |= *value as u32;
                ever.iter_mut().zip(row).for_each(bits);
                values_changed = true;
            }
            visible |= shown.is_some_and(|view| at >= view.from && at <= view.to);
            previous = Some(at);
        });
        self.paused.is_none() && (visible || values_changed || self.view() != shown)
    }

    /// The recorded signals.
    pub fn signals(&self) -> &[Signal] {
        &self.signals
    }

    /// The strips, from the top.
    pub fn strips(&self) -> &[Strip] {
        &self.strips
    }

    /// The strip of this name.
    pub fn strip(&self, name: &str) -> Option<&Strip> {
        self.strips.iter().find(|strip| strip.name == name)
    }

    /// The lines of all strips.
    pub fn traces(&self) -> impl Iterator<Item = (&Strip, &Shown)> {
        let of = |strip| move |trace| (strip, trace);
        self.strips
            .iter()
            .flat_map(move |strip| strip.traces.iter().map(of(strip)))
    }

    /// Draws a signal, or does not any more.
    pub fn choose(&mut self, signal: usize, shown: bool) {
        strips::remove(&mut self.strips, signal);
        if shown {
            strips::add(&mut self.strips, &self.signals, signal);
        }
    }

    /// Takes a strip away, with all of its lines.
    pub fn remove(&mut self, strip: &str) {
        self.strips.retain(|other| other.name != strip);
    }

    /// Folds a strip to its name and value, or unfolds it.
    pub fn fold(&mut self, strip: &str, folded: bool) {
        self.change(strip, |strip| strip.folded = Some(folded));
    }

    /// Gives a strip a scale that stays; `None` lets it follow the values.
    pub fn fix(&mut self, strip: &str, scale: Option<Scale>) {
        self.change(strip, |strip| strip.fixed = scale);
    }

    fn change(&mut self, strip: &str, change: impl FnOnce(&mut Strip)) {
        if let Some(strip) = self.strips.iter_mut().find(|other| other.name == strip) {
            change(strip);
        }
    }

    /// The value of a signal now, or when the picture was paused.
    pub fn newest(&self, signal: usize) -> Option<f64> {
        let row = self.paused.as_ref().map_or(&self.newest, |p| &p.row);
        row.get(signal).copied()
    }

    /// The value of a signal now, by its name, whatever the picture does.
    pub fn now(&self, signal: &str) -> Option<f64> {
        let column = self.signals.iter().position(|s| s.name == signal)?;
        self.newest.get(column).copied()
    }

    /// What is shown; `None` before anything has moved.
    pub fn view(&self) -> Option<View> {
        match &self.paused {
            Some(paused) => paused.view,
            None => self.window.view(self.recorded()?.1),
        }
    }

    /// Of all that was recorded, the part that can be shown.
    fn recorded(&self) -> Option<(Nanos, Nanos)> {
        let (first, last) = self.trace.span()?;
        let last = self.paused.as_ref().map_or(last, |p| p.until);
        Some((first.min(last), last))
    }

    /// Where the lines of a view end.
    fn until(&self, view: View) -> Nanos {
        let last = self.recorded().map_or(view.to, |(_, last)| last);
        view.to.min(last).max(view.from)
    }

    /// What the picture keeps up with.
    pub fn follows(&self) -> Follow {
        self.window.follow
    }

    /// Keeps up with something else, or with nothing.
    pub fn follow(&mut self, follow: Follow) {
        self.paused = None;
        let shown = self.view();
        self.window.follow(follow, shown);
    }

    /// Whether the picture stands still.
    pub fn is_paused(&self) -> bool {
        self.paused.is_some()
    }

    /// Lets the picture stand still, or go on; the machine does not notice.
    pub fn pause(&mut self, pause: bool) {
        self.paused = match self.recorded() {
            Some((_, until)) if pause => Some(Paused {
                view: self.view(),
                until,
                row: self.newest.clone(),
            }),
            _ => None,
        };
    }

    /// Shows `factor` times as much time; what is at a place of the picture, 0 to 1, stays there.
    pub fn zoom(&mut self, factor: f64, place: f64) {
        let Some(view) = self.view() else { return };
        match &mut self.paused {
            Some(paused) => paused.view = Some(view.zoomed(factor, place)),
            None => self.window.zoom(view, factor, place),
        }
    }

    /// Moves the picture to the right by a part of its width.
    pub fn pan(&mut self, part: f64) {
        let (Some(view), Some(span)) = (self.view(), self.recorded()) else {
            return;
        };
        self.show(view.panned(part, span));
    }

    /// Shows this, and keeps up with nothing.
    pub fn show(&mut self, view: View) {
        match &mut self.paused {
            Some(paused) => paused.view = Some(view),
            None => self.window.hold(view),
        }
    }
}
