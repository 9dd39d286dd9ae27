//! Positions at events: comparators, and captures by edges of inputs.
//!
//! Source: "Mquotecmp", "msetoutcmp (on,off)", "Msetincap(in, edge, time)", "Gv_latch1%".

/// One step of `msetincap`'s delay, in seconds.
const DELAY_STEP: f64 = 0.8e-6;

/// What a position comparator looks at.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Compared {
    /// `gv_feedback%`.
    Feedback,
    /// `gv_master%`.
    Master,
    /// `cm_master%`.
    CamMaster,
}

/// A range of positions in counts, both ends included.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Window {
    pub(super) on: i32,
    pub(super) off: i32,
}

impl Window {
    /// A range whose end is before its start leads through the modulus' end (D208).
    pub(super) fn contains(self, position: i32) -> bool {
        if self.on <= self.off {
            position >= self.on && position <= self.off
        } else {
            position >= self.on || position <= self.off
        }
    }
}

/// The eight comparators of `mquotecmp`, and that of output 7.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Comparators {
    /// Any of them was ever set: most programs compare nothing.
    pub(super) are_set: bool,
    pub(super) windows: [Option<(Compared, Window)>; 8],
    pub(super) output: Option<Window>,
    /// `gv_compare%`.
    pub(super) word: u8,
}

/// An input that captures a position, and what it has captured last (D209).
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Capture {
    pub(super) edge: u8,
    /// Delay of the sensor, in seconds.
    delay: f64,
    /// In counts, wrapped as its source reads.
    pub(super) position: i32,
}

impl Capture {
    /// `msetincap`; what was captured stays.
    pub(super) fn set(&mut self, edge: u8, delay: i32) {
        self.edge = edge;
        self.delay = f64::from(delay) * DELAY_STEP;
    }

    /// Whether this edge captures.
    pub(super) fn takes(self, rising: bool) -> bool {
        self.edge & if rising { 1 } else { 2 } != 0
    }

    /// How long ago the position was, in seconds, for an edge that came `passed` seconds ago.
    pub(super) fn age(self, passed: f64) -> f64 {
        passed + self.delay
    }
}

/// The drive's own captures of the actual position: of its inputs IN1 and IN2, at rising and falling edges
/// (D210).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Latches {
    /// IN1 rising, IN1 falling, IN2 rising, IN2 falling.
    pub(super) positions: [i32; 4],
    /// Which of them have captured since power-up.
    pub(super) taken: u8,
}

impl Latches {
    /// An edge of IN1 (0) or IN2 (1).
    pub(super) fn take(&mut self, input: usize, rising: bool, position: i32) {
        let index = input * 2 + usize::from(!rising);
        if let Some(latch) = self.positions.get_mut(index) {
            *latch = position;
            self.taken |= 1 << index;
        }
    }
}
