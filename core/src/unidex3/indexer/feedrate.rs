//! How fast steps come: as a frequency, as a period, as a part of a vector (5-1).

use super::pair::Pair;

/// Bits of a [`Feedrate`] below one step per second.
pub(super) const FRACTION_BITS: u32 = 35;
/// A microsecond counts this much of a step at 1 step/s; so much phase makes a step.
pub(super) const STEP: u64 = 1_000_000 << FRACTION_BITS;
/// Bits of a vector's length below one step.
const LENGTH_BITS: u32 = 16;

/// A rate of steps, in 2^-35 steps/s, above zero (D290). A period that is no whole part of a second is rounded up, so that a
/// pulse never misses the microsecond that it belongs to.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct Feedrate(u64);

impl Feedrate {
    /// What slew and home have at power-up: 250 steps/s (Appendix 5).
    pub const DEFAULT: Feedrate = Feedrate::fixed(250);
    /// The start/stop frequency at power-up, always that of vector moves: 2 MHz / 65536, 30.52 steps/s (6-16 B).
    pub const START_STOP: Feedrate = Feedrate((2_000_000 << FRACTION_BITS) / 65_536);
    /// One step in 4000 s.
    const SLOWEST: u64 = (1 << FRACTION_BITS) / 4000;

    /// `F n`: 1 to 150,000 steps/s; `None` outside (5-1 A).
    pub fn frequency(steps_per_second: u32) -> Option<Feedrate> {
        let valid = (1..=150_000).contains(&steps_per_second);
        valid.then_some(Feedrate(u64::from(steps_per_second) << FRACTION_BITS))
    }

    /// `F= n`: 6 to 4,000,000,000 us a step; `None` outside (5-1 B).
    pub fn period(microseconds: u32) -> Option<Feedrate> {
        let valid = (6..=4_000_000_000).contains(&microseconds);
        valid.then_some(Feedrate(STEP.div_ceil(u64::from(microseconds.max(1)))))
    }

    /// `G76= n`: 31 to 166,500 steps/s; `None` outside (6-16 B, D292).
    pub fn start_stop(steps_per_second: u32) -> Option<Feedrate> {
        let valid = (31..=166_500).contains(&steps_per_second);
        valid.then_some(Feedrate(u64::from(steps_per_second) << FRACTION_BITS))
    }

    /// The part of this vector feedrate on each axis for a move by `x` and `y` steps (magnitudes to 4,000,000,000);
    /// `None` for an axis that does not move. These stay in effect when G00 follows (5-1).
    pub fn components(self, x: i64, y: i64) -> Pair<Option<Feedrate>> {
        let sides = Pair { x, y }.map(|side| u128::from(side.unsigned_abs()).min(1 << 32));
        let Pair { x, y } = sides;
        let length = ((x * x + y * y) << (2 * LENGTH_BITS)).isqrt().max(1);
        sides.map(|side| {
            let part = (u128::from(self.0) * (side << LENGTH_BITS)).div_ceil(length);
            let part = u64::try_from(part).unwrap_or(self.0).min(self.0);
            (side > 0).then_some(Feedrate(part.max(Feedrate::SLOWEST)))
        })
    }

    /// A fixed rate of the unit's own.
    pub(super) const fn fixed(steps_per_second: u16) -> Feedrate {
        Feedrate((steps_per_second as u64) << FRACTION_BITS)
    }

    /// In steps per second.
    #[allow(clippy::cast_precision_loss)] // to 53 of at most 53 bits
    pub fn steps_per_second(self) -> f64 {
        self.0 as f64 / (1u64 << FRACTION_BITS) as f64
    }

    /// In 2^-35 steps/s.
    pub(super) fn raw(self) -> u64 {
        self.0
    }
}
