//! Fixed point and wrapping: how the planner's 64-bit positions look to a program.

/// Bits of a fraction of a count in a position, and of a count per sample in a speed.
pub const FRACTION: u32 = 8;

/// The nearest whole count.
pub fn counts(position: i64) -> i64 {
    position.wrapping_add(1 << (FRACTION - 1)) >> FRACTION
}

/// A value in a 32-bit register that wraps.
#[allow(clippy::cast_possible_truncation)] // wrapping is what the device's registers do
pub fn wrap32(value: i64) -> i32 {
    value as i32
}

/// A 64-bit value in a 32-bit register that does not wrap.
pub fn saturate(value: i64) -> i32 {
    i32::try_from(value).unwrap_or(if value < 0 { i32::MIN } else { i32::MAX })
}

/// The range that positions are read in: `gv_smod%`, `gv_mmod%`. 0 or less is none, which leaves 32 bits.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Modulus(pub i32);

impl Modulus {
    /// In counts.
    pub fn counts(self) -> Option<i64> {
        (self.0 > 0).then_some(i64::from(self.0))
    }

    /// A number of counts as a program reads it.
    pub fn wrap(self, counts: i64) -> i32 {
        wrap32(
            self.counts()
                .map_or(counts, |modulus| counts.rem_euclid(modulus)),
        )
    }

    /// A position in 1/256 count as a program reads it, in counts.
    pub fn reading(self, position: i64) -> i32 {
        self.wrap(counts(position))
    }

    /// By how much a position changes (1/256 count) when it becomes what it reads as.
    pub fn shift(self, position: i64) -> i64 {
        let here = counts(position);
        i64::from(self.wrap(here)).wrapping_sub(here) << FRACTION
    }

    /// One turn of the range in 1/256 count: the modulus, or 32 bits of counts.
    fn turn(self) -> i64 {
        self.counts().unwrap_or(1 << 32) << FRACTION
    }

    /// A difference of two positions, both in 1/256 count, on the shorter way round.
    pub fn nearest(self, difference: i64) -> i64 {
        let turn = self.turn();
        let forward = difference.rem_euclid(turn);
        if forward * 2 <= turn {
            forward
        } else {
            forward - turn
        }
    }
}
