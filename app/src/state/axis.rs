//! The axis as a thing that moves: a carriage on a track, and the angle of the motor.

use super::scope::Scale;

/// Counts that the track shows at least.
const LEAST: f64 = 10_000.0;
/// Marks of the track, about.
const MARKS: f64 = 4.0;
/// The carriage comes no nearer to an end of the track than this part of it, or the track grows.
const EDGE: f64 = 0.04;

/// The part of an endless track that is shown. It doubles at once when the carriage comes near its end, and shrinks only
/// when a motion begins, so that it is the carriage that is seen to move, not the track.
#[derive(Debug, Clone, PartialEq)]
pub struct Track {
    low: f64,
    high: f64,
    moving: bool,
}

impl Default for Track {
    fn default() -> Track {
        Track {
            low: -LEAST / 2.0,
            high: LEAST / 2.0,
            moving: false,
        }
    }
}

impl Track {
    /// The carriage is at `actual` and should be at `demanded`, and the axis moves, or not.
    pub fn take(&mut self, actual: f64, demanded: f64, moving: bool) {
        if !actual.is_finite() || !demanded.is_finite() {
            return;
        }
        let (low, high) = (actual.min(demanded), actual.max(demanded));
        if moving && !self.moving {
            // Where it comes from, and zero, where programs count from.
            let (low, high) = (low.min(0.0), high.max(0.0));
            let missing = (LEAST - (high - low)).max((high - low) * 2.0 * EDGE) / 2.0;
            (self.low, self.high) = (low - missing, high + missing);
        }
        self.moving = moving;
        let span = self.high - self.low;
        if low < self.low + span * EDGE {
            self.low = low - span;
        }
        if high > self.high - span * EDGE {
            self.high = high + span;
        }
    }

    /// Its ends and marks, in counts.
    pub fn scale(&self) -> Scale {
        Scale::fit(self.low, self.high, MARKS)
    }

    /// Where a position is on the track, from 0 to 1.
    pub fn place(&self, position: f64) -> f64 {
        let Scale { low, high, .. } = self.scale();
        let place = (position - low) / (high - low);
        if place.is_finite() {
            place.clamp(0.0, 1.0)
        } else {
            0.0
        }
    }
}

/// The angle of a shaft, in degrees from 0 to 360.
pub fn angle(revolutions: f64) -> f64 {
    let angle = revolutions.rem_euclid(1.0) * 360.0;
    if angle.is_finite() { angle } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// How often the scale of the track changes while the carriage runs.
    fn changes(track: &mut Track, from: f64, to: f64) -> usize {
        let mut changes = 0;
        let mut before = track.scale();
        for step in 0..=1000 {
            let at = from + (to - from) * f64::from(step) / 1000.0;
            track.take(at, at, true);
            changes += usize::from(track.scale() != before);
            before = track.scale();
            assert!((0.0..=1.0).contains(&track.place(at)));
        }
        changes
    }

    #[test]
    fn the_track_holds_the_carriage_and_is_calm() {
        let mut track = Track::default();
        track.take(0.0, 0.0, false);
        assert_eq!(track.place(0.0), 0.5);
        let seen = changes(&mut track, 0.0, 40_960.0);
        assert!((1..=4).contains(&seen), "{seen} changes");
        let place = track.place(40_960.0);
        assert!((0.4..0.98).contains(&place), "{place}");
        assert_eq!(
            changes(&mut track, 40_960.0, 0.0),
            0,
            "the way back is known"
        );
    }

    #[test]
    fn a_new_motion_takes_the_track_that_it_needs() {
        let mut track = Track::default();
        changes(&mut track, 0.0, 1e7);
        changes(&mut track, 1e7, 0.0);
        track.take(0.0, 0.0, false);
        assert!(track.scale().high >= 1e7, "it stands: nothing changes");
        track.take(1.0, 1.0, true);
        assert!(track.scale().high < 20_000.0);
    }

    #[test]
    fn what_is_no_position_changes_nothing() {
        let mut track = Track::default();
        track.take(f64::NAN, 0.0, true);
        assert_eq!(track, Track::default());
        assert_eq!(track.place(f64::NAN), 0.0);
        assert_eq!((angle(-0.25), angle(f64::INFINITY)), (270.0, 0.0));
    }
}
