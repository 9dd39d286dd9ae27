//! MD: positions and times from the host, and the way between them.

use std::collections::VecDeque;

/// Places of the FIFO.
const PLACES: usize = 16;
/// A change of position must be smaller, in counts.
const LARGEST_STEP: i64 = 1 << 23;

/// Bits of [`Stream::state`].
pub mod state {
    /// Contouring runs.
    pub const RUNS: u8 = 1 << 0;
    /// A time did not fit 16 bits.
    pub const BAD_TIME: u8 = 1 << 1;
    /// A change of position did not fit 23 bits.
    pub const BAD_POSITION: u8 = 1 << 2;
    /// More came than the FIFO holds.
    pub const OVERFLOW: u8 = 1 << 4;
    /// The FIFO ran dry while contouring ran.
    pub const UNDERFLOW: u8 = 1 << 5;
}

/// Where to be, and in how many servo samples; none at all ends the contour.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Knot {
    /// In counts as a program reads them.
    position: i32,
    /// In servo samples.
    time: i64,
}

/// A straight way.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Segment {
    /// In 1/65536 count.
    length: i64,
    samples: i64,
    /// Samples gone.
    gone: i64,
}

/// The FIFO and where the contour stands.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Stream {
    fifo: VecDeque<Knot>,
    /// The position that waits for its time.
    pending: Option<i32>,
    /// The position that came last; without one, the contour begins where the motor is.
    newest: Option<i32>,
    /// The end of what has been taken from the FIFO.
    reached: i32,
    segment: Option<Segment>,
    state: u8,
}

impl Stream {
    /// Empties the FIFO.
    pub fn clear(&mut self) {
        *self = Stream::default();
    }

    /// The positions that a program reads have grown by `shift`.
    pub fn renumber(&mut self, shift: i32) {
        self.reached = self.reached.wrapping_add(shift);
        if self.fifo.is_empty() {
            self.newest = self.newest.map(|newest| newest.wrapping_add(shift));
        }
    }

    /// A position in counts.
    pub fn position(&mut self, position: i32) {
        self.pending = Some(position);
    }

    /// A time in servo samples, 1 to 65535; with the position before it, it is a knot. `here` is where the motor is
    /// ordered to be. 0 ends the contour when it is reached.
    pub fn time(&mut self, time: i32, here: i32) {
        let newest = self.newest.unwrap_or(here);
        let position = self.pending.take().unwrap_or(newest);
        let step = i64::from(position.wrapping_sub(newest));
        if !(0..=65_535).contains(&time) {
            self.state |= state::BAD_TIME;
        } else if step.abs() >= LARGEST_STEP {
            self.state |= state::BAD_POSITION;
        } else if self.fifo.len() >= PLACES {
            self.state |= state::OVERFLOW;
        } else {
            self.newest = Some(position);
            self.fifo.push_back(Knot {
                position,
                time: i64::from(time),
            });
        }
    }

    /// G: the contour begins at `here`, in counts.
    pub fn begin(&mut self, here: i32) {
        if self.state & state::RUNS == 0 {
            self.reached = here;
            self.state = state::RUNS;
        }
    }

    /// How far to go in the next servo sample, in 1/65536 count; `None` when the contour has ended.
    pub fn step(&mut self) -> Option<i64> {
        if self.segment.is_none() {
            self.next_segment();
        }
        let Some(segment) = &mut self.segment else {
            self.end();
            return None;
        };
        let at = |gone: i64| segment.length * gone / segment.samples;
        let moved = at(segment.gone + 1) - at(segment.gone);
        segment.gone += 1;
        if segment.gone == segment.samples {
            self.segment = None;
        }
        Some(moved)
    }

    fn next_segment(&mut self) {
        match self.fifo.pop_front() {
            Some(knot) if knot.time > 0 => {
                let counts = i64::from(knot.position.wrapping_sub(self.reached));
                self.reached = knot.position;
                self.segment = Some(Segment {
                    length: counts << 16,
                    samples: knot.time,
                    gone: 0,
                });
            }
            Some(_) => {}
            None => self.state |= state::UNDERFLOW,
        }
    }

    /// Contouring is over, at its end or because another motion or a stop has taken its place.
    pub fn end(&mut self) {
        self.state &= !state::RUNS;
        self.fifo.clear();
        (self.pending, self.newest, self.segment) = (None, None, None);
    }

    /// Bits of [`state`].
    pub fn state(&self) -> u8 {
        self.state
    }

    /// Free places.
    pub fn free(&self) -> u8 {
        u8::try_from(PLACES.saturating_sub(self.fifo.len())).unwrap_or(0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_contour_meets_its_knots_on_time() {
        let mut stream = Stream::default();
        for (position, time) in [(1007, 256), (900, 64), (900, 0)] {
            stream.position(position);
            stream.time(time, 1000);
        }
        stream.begin(1000);
        let mut at = 1000 << 16;
        let mut seen = Vec::new();
        while let Some(step) = stream.step() {
            at += step;
            seen.push(at);
        }
        assert_eq!(
            (seen[255], seen[319], seen.len()),
            (1007 << 16, 900 << 16, 320)
        );
        assert_eq!(seen[127], (1000 << 16) + (7 << 15));
        assert_eq!(stream.state(), 0);
    }

    #[test]
    fn what_is_wrong_is_told() {
        let mut stream = Stream::default();
        stream.time(-1, 0);
        assert_eq!(stream.state(), state::BAD_TIME);
        stream.position(1 << 23);
        stream.time(1, 0);
        assert_eq!(stream.state(), state::BAD_TIME | state::BAD_POSITION);
        (0..17).for_each(|_| stream.time(1, 0));
        assert_eq!(
            (stream.free(), stream.state() & state::OVERFLOW),
            (0, state::OVERFLOW)
        );
        stream.begin(0);
        assert_eq!(stream.state(), state::RUNS);
        while stream.step().is_some() {}
        assert_eq!(stream.state(), state::UNDERFLOW);
    }
}
