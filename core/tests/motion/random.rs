//! Random numbers for the property tests.

/// A xorshift generator: the same numbers on every machine.
pub(crate) struct Random(u64);

impl Random {
    /// A sequence of its own for each seed.
    pub(crate) fn new(seed: u64) -> Random {
        Random(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1)
    }

    fn next(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0
    }

    /// Evenly in `0..limit`.
    pub(crate) fn below(&mut self, limit: i64) -> i64 {
        (self.next() >> 1) as i64 % limit
    }

    /// In `1..limit`, all orders of magnitude alike.
    pub(crate) fn logarithmic(&mut self, limit: i64) -> i64 {
        let bits = self.below(i64::from(limit.ilog2())) + 1;
        1 + self.below((1 << bits) - 1)
    }

    /// In `-limit..limit`, all orders of magnitude alike.
    pub(crate) fn signed(&mut self, limit: i64) -> i64 {
        let magnitude = self.logarithmic(limit);
        if self.next() & 1024 == 0 {
            magnitude
        } else {
            -magnitude
        }
    }
}
