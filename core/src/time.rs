//! Simulated time.

use std::ops::{Add, AddAssign, Sub};

/// A point in simulated time, or a length of it, in nanoseconds. 2^64 ns are 584 years.
#[derive(
    Debug,
    Clone,
    Copy,
    PartialEq,
    Eq,
    PartialOrd,
    Ord,
    Default,
    serde::Serialize,
    serde::Deserialize,
)]
pub struct Nanos(pub u64);

impl Nanos {
    /// The start of the simulation.
    pub const ZERO: Nanos = Nanos(0);
    /// Never.
    pub const MAX: Nanos = Nanos(u64::MAX);

    /// Whole milliseconds.
    pub const fn from_millis(millis: u64) -> Nanos {
        Nanos(millis.saturating_mul(1_000_000))
    }

    /// Whole microseconds.
    pub const fn from_micros(micros: u64) -> Nanos {
        Nanos(micros.saturating_mul(1_000))
    }

    /// Seconds, rounded to the nanosecond; negative and not-a-number are zero.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // `as` saturates, which is what is wanted
    pub fn from_seconds(seconds: f64) -> Nanos {
        Nanos((seconds * 1e9 + 0.5) as u64)
    }

    /// In seconds.
    #[allow(clippy::cast_precision_loss)] // exact for 104 days, then to a few nanoseconds
    pub fn seconds(self) -> f64 {
        self.0 as f64 / 1e9
    }

    /// The distance to an earlier time, zero if it is later.
    pub fn since(self, earlier: Nanos) -> Nanos {
        Nanos(self.0.saturating_sub(earlier.0))
    }
}

impl Add for Nanos {
    type Output = Nanos;
    fn add(self, other: Nanos) -> Nanos {
        Nanos(self.0.saturating_add(other.0))
    }
}

impl AddAssign for Nanos {
    fn add_assign(&mut self, other: Nanos) {
        *self = *self + other;
    }
}

impl Sub for Nanos {
    type Output = Nanos;
    fn sub(self, other: Nanos) -> Nanos {
        self.since(other)
    }
}
