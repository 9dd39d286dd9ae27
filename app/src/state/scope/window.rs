//! Which part of simulated time the scope shows.

use motionbench_core::time::Nanos;

use super::scale::{Scale, nice};

/// An axis that stood so long begins a new picture.
const PAUSE: Nanos = Nanos::from_millis(2000);
/// Shown at least, behind the end of a motion.
const TAIL: Nanos = Nanos::from_millis(100);
/// Widths of the picture of a motion, s; a longer motion moves through the last.
const WIDTHS_S: [u64; 6] = [1, 2, 5, 10, 20, 60];
/// The picture that follows the newest samples, unless it is zoomed.
const NEWEST: Nanos = Nanos::from_millis(10_000);
/// What can be shown at most and at least.
const WIDEST: Nanos = Nanos::from_millis(1_000_000);
const NARROWEST: Nanos = Nanos::from_millis(20);

/// What the picture keeps up with.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Follow {
    /// It begins where an axis that stood begins to move, grows with the motion, and stands still when the axis does.
    Motion,
    /// Its right edge is now.
    Newest,
    /// Nothing: it shows the part that the user chose.
    Nothing,
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

/// What decides the view.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Window {
    pub(super) follow: Follow,
    pub(super) motion: Option<Motion>,
    /// The width that follows the newest samples.
    width: Nanos,
    /// What the user chose.
    held: View,
}

/// When the shown motion began, and when something last changed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Motion {
    start: Nanos,
    last: Nanos,
}

impl Default for Window {
    fn default() -> Window {
        Window {
            follow: Follow::Motion,
            motion: None,
            width: NEWEST,
            held: View {
                zero: Nanos::ZERO,
                from: Nanos::ZERO,
                to: NEWEST,
            },
        }
    }
}

impl Window {
    /// Something that is demanded of the axis changed at `at`, and stood at `previous`.
    pub(super) fn moved(&mut self, previous: Nanos, at: Nanos) {
        let goes_on = self
            .motion
            .filter(|motion| at.since(motion.last) <= PAUSE)
            .map_or(previous, |motion| motion.start);
        self.motion = Some(Motion {
            start: goes_on,
            last: at,
        });
    }

    /// What is shown when the newest sample is of `newest`; `None` before anything has moved, if that is waited for.
    pub(super) fn view(&self, newest: Nanos) -> Option<View> {
        match self.follow {
            Follow::Motion => self.motion.and_then(Motion::view),
            Follow::Newest => {
                let from = newest.since(self.width);
                Some(View {
                    zero: Nanos::ZERO,
                    from,
                    to: from + self.width,
                })
            }
            Follow::Nothing => Some(self.held),
        }
    }

    /// Shows this and keeps up with nothing.
    pub(super) fn hold(&mut self, view: View) {
        self.follow = Follow::Nothing;
        self.held = view;
    }

    /// Keeps up with something from here on; with nothing: `shown` stays.
    pub(super) fn follow(&mut self, follow: Follow, shown: Option<View>) {
        match shown {
            Some(view) if follow == Follow::Nothing => self.hold(view),
            _ => self.follow = follow,
        }
    }

    /// Another width around what is shown. What follows the newest samples goes on to.
    pub(super) fn zoom(&mut self, shown: View, factor: f64, at: f64) {
        let zoomed = shown.zoomed(factor, at);
        if self.follow == Follow::Newest {
            self.width = zoomed.width();
        } else {
            self.hold(zoomed);
        }
    }
}

impl Motion {
    fn view(self) -> Option<View> {
        let Motion { start, last } = self;
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
}

impl View {
    /// From edge to edge.
    pub fn width(&self) -> Nanos {
        self.to.since(self.from)
    }

    /// The time axis, in s from its zero.
    pub fn scale(&self) -> Scale {
        let (low, high) = (self.seconds(self.from), self.seconds(self.to));
        Scale {
            low,
            high,
            step: nice((high - low) / 5.0),
        }
    }

    /// A time as the time axis has it: in s from its zero, negative before it.
    pub fn seconds(&self, at: Nanos) -> f64 {
        at.since(self.zero).seconds() - self.zero.since(at).seconds()
    }

    /// Where a time lies between the left edge, 0, and the right edge, 1; beyond them it is less or more.
    pub fn place(&self, at: Nanos) -> f64 {
        (at.since(self.from).seconds() - self.from.since(at).seconds()) / self.width().seconds()
    }

    /// The time at a place.
    pub fn time(&self, place: f64) -> Nanos {
        let distance = Nanos::from_seconds((place * self.width().seconds()).abs());
        if place < 0.0 {
            self.from.since(distance)
        } else {
            self.from + distance
        }
    }

    /// `factor` times as wide, within what can be shown; what is at `place` stays there.
    pub fn zoomed(&self, factor: f64, place: f64) -> View {
        let wanted = Nanos::from_seconds(self.width().seconds() * factor);
        let width = wanted.clamp(NARROWEST, WIDEST);
        let left = Nanos::from_seconds(width.seconds() * place);
        let from = self.time(place).since(left);
        View {
            from,
            to: from + width,
            ..*self
        }
    }

    /// Moved to the right by a part of its width, but not away from what was recorded in `span`.
    pub fn panned(&self, part: f64, span: (Nanos, Nanos)) -> View {
        let half = Nanos(self.width().0 / 2);
        let (least, most) = (span.0.since(half), span.1.since(half));
        let from = self.time(part).clamp(least, most.max(least));
        View {
            from,
            to: from + self.width(),
            ..*self
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ms(millis: u64) -> Nanos {
        Nanos::from_millis(millis)
    }

    fn view(from: u64, to: u64) -> View {
        View {
            zero: ms(1000),
            from: ms(from),
            to: ms(to),
        }
    }

    #[test]
    fn times_and_places_are_one_scale() {
        let view = view(500, 2500);
        assert_eq!(view.time(0.25), ms(1000));
        assert_eq!(view.place(ms(1500)), 0.5);
        assert_eq!(view.place(ms(0)), -0.25);
        assert_eq!((view.scale().low, view.scale().high), (-0.5, 1.5));
    }

    #[test]
    fn zoom_keeps_what_is_under_the_pointer_and_has_ends() {
        let zoomed = view(500, 2500).zoomed(0.5, 0.25);
        assert_eq!((zoomed.from, zoomed.to), (ms(750), ms(1750)));
        assert_eq!(view(500, 2500).zoomed(1e-9, 0.5).width(), NARROWEST);
        assert_eq!(view(500, 2500).zoomed(1e9, 0.5).width(), WIDEST);
        assert_eq!(view(0, 2000).zoomed(2.0, 0.75).from, Nanos::ZERO);
    }

    #[test]
    fn panning_never_leaves_the_recording() {
        let span = (ms(0), ms(10_000));
        let panned = view(500, 2500).panned(0.5, span);
        assert_eq!((panned.from, panned.to), (ms(1500), ms(3500)));
        assert_eq!(view(500, 2500).panned(-3.0, span).from, Nanos::ZERO);
        assert_eq!(view(500, 2500).panned(90.0, span).from, ms(9000));
    }

    #[test]
    fn the_newest_is_followed_at_the_width_it_is_zoomed_to() {
        let mut window = Window::default();
        window.follow(Follow::Newest, None);
        let shown = window.view(ms(30_000)).unwrap();
        assert_eq!((shown.from, shown.to), (ms(20_000), ms(30_000)));
        window.zoom(shown, 0.5, 0.3);
        assert_eq!(window.view(ms(31_000)).unwrap().from, ms(26_000));
        assert_eq!(window.follow, Follow::Newest);
    }
}
