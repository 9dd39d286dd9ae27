//! How a scenario went.

use crate::time::Nanos;

/// How a scenario went.
#[derive(Debug, Clone, PartialEq)]
pub struct Report {
    /// In a word.
    pub outcome: Outcome,
    /// The line that the message is about, from 1; 0 where there is none.
    pub line: u32,
    /// What was expected and what was there; empty for [`Outcome::Held`].
    pub message: String,
    /// Simulated time at the end.
    pub simulated: Nanos,
    /// Names everything that could be observed: every console byte and every recorded row with its time. Two runs are
    /// equal bit for bit if their digests are.
    pub digest: u64,
    /// What `file get` took from the devices, by the names that the scenario gives, relative to it.
    pub files: Vec<(String, Vec<u8>)>,
}

/// How a scenario went, in a word.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Outcome {
    /// Everything held.
    Held,
    /// It failed, as its `known-failure` says.
    KnownFailure,
    /// Something did not hold, or a known failure held.
    Failed,
    /// It could not be tried: a file is missing.
    Unusable,
}

impl Report {
    /// Whether all is as it should be.
    pub fn is_ok(&self) -> bool {
        matches!(self.outcome, Outcome::Held | Outcome::KnownFailure)
    }
}

/// A rolling digest (FNV-1a over 64-bit words).
#[derive(Debug, Clone, Copy)]
pub(super) struct Digest(pub(super) u64);

impl Digest {
    pub(super) fn new() -> Digest {
        Digest(0xcbf2_9ce4_8422_2325)
    }

    pub(super) fn add(&mut self, word: u64) {
        self.0 = (self.0 ^ word).wrapping_mul(0x0000_0100_0000_01b3);
    }

    /// Every not-a-number counts as the same.
    pub(super) fn add_number(&mut self, number: f64) {
        let number = if number.is_nan() { f64::NAN } else { number };
        self.add(number.to_bits());
    }
}
