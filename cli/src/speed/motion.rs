//! The cost of motion: axes with generator, servo, plant, encoder and trace.

use motionbench_core::motion::rig::{RATE, Rig};

/// Name and axes of each measurement.
pub(super) const RIGS: [(&str, u32); 2] = [("1x2kHz", 1), ("32x2kHz", 32)];

/// Samples of every axis that a second has.
pub(super) fn axis_samples(axes: u32) -> f64 {
    f64::from(axes) * f64::from(RATE)
}

/// Runs `samples` samples of every axis; the result tells that they have moved.
pub(super) fn run(axes: u32, samples: u32) -> f64 {
    let mut rig = Rig::new(axes);
    (0..samples).for_each(|_| rig.sample());
    rig.positions().map(|(_, actual)| actual).sum()
}
