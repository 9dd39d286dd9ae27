//! Many axes at once, each with generator, servo, plant, encoder and trace: the load that motion is measured by.

use super::profile::Trapezoid;
use crate::plant::{PlantAxis, presets};
use crate::servo::{Gains, Servo};
use crate::time::Nanos;
use crate::trace::Trace;

/// Samples a second.
pub const RATE: u32 = 2000;
const PERIOD: f64 = 1.0 / RATE as f64;
const ENCODER: u32 = 1 << 16;
/// Kept of the trace: half a second.
const ROWS: usize = 1024;

/// Axes that move to and fro for ever, each over its own distance.
#[derive(Debug, Clone)]
pub struct Rig {
    axes: Vec<Axis>,
    samples: u64,
    row: Vec<f64>,
    trace: Trace,
}

#[derive(Debug, Clone)]
struct Axis {
    /// In revolutions, as its profile is.
    start: f64,
    distance: f64,
    profile: Trapezoid,
    /// Seconds into the profile.
    time: f64,
    servo: Servo,
    plant: PlantAxis,
}

/// A critically damped position loop of 40 Hz for [`presets::SERVO`], which does 3000 rev/s² at full torque.
const GAINS: Gains = Gains {
    proportional: 21.0,
    integral: 600.0,
    integral_deadband: 1.0 / ENCODER as f64,
    derivative: 0.168,
    velocity_feedforward: 0.0006,
    acceleration_feedforward: 1.0 / 3000.0,
    output_limit: 1.0,
};

impl Rig {
    /// A rig of `axes` axes at rest.
    pub fn new(axes: u32) -> Rig {
        let row = Vec::with_capacity(axes as usize);
        let trace = Trace::new(axes as usize, ROWS);
        Rig {
            axes: (0..axes).filter_map(Axis::new).collect(),
            samples: 0,
            row,
            trace,
        }
    }

    /// One sample of every axis.
    pub fn sample(&mut self) {
        self.row.clear();
        for axis in &mut self.axes {
            axis.sample();
            self.row.push(axis.plant.position());
        }
        self.trace.push(
            Nanos(self.samples * (1_000_000_000 / u64::from(RATE))),
            &self.row,
        );
        self.samples += 1;
    }

    /// Demanded and actual position of each axis, in revolutions.
    pub fn positions(&self) -> impl Iterator<Item = (f64, f64)> + '_ {
        self.axes.iter().map(|axis| {
            (
                axis.start + axis.profile.at(axis.time).position,
                axis.plant.position(),
            )
        })
    }

    /// What was recorded: the actual positions.
    pub fn trace(&self) -> &Trace {
        &self.trace
    }
}

impl Axis {
    /// Distances of 2 to 6 revolutions keep the axes out of step with each other.
    fn new(number: u32) -> Option<Axis> {
        let distance = 2.0 + f64::from(number % 32) * 0.125;
        Some(Axis {
            start: 0.0,
            distance,
            profile: plan(distance)?,
            time: 0.0,
            servo: Servo::new(GAINS, PERIOD),
            plant: PlantAxis::new(presets::SERVO, PERIOD, ENCODER, ENCODER),
        })
    }

    #[inline]
    fn sample(&mut self) {
        self.time += PERIOD;
        if self.time >= self.profile.duration() {
            self.turn_round();
        }
        let demand = self.profile.at(self.time);
        let error = self.start + demand.position - self.plant.encoder.revolutions();
        let torque = self
            .servo
            .update(error, demand.velocity, demand.acceleration);
        self.plant.step(torque);
    }

    #[cold]
    fn turn_round(&mut self) {
        self.time -= self.profile.duration();
        self.start += self.distance;
        self.distance = -self.distance;
        if let Some(profile) = plan(self.distance) {
            self.profile = profile;
        }
    }
}

/// 1200 rpm, 600 rev/s² up and 450 down.
fn plan(distance: f64) -> Option<Trapezoid> {
    Trapezoid::plan(distance, 0.0, 20.0, 600.0, 450.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_axis_follows_its_demand() {
        let mut rig = Rig::new(32);
        let mut worst = 0.0f64;
        for _ in 0..4 * RATE {
            rig.sample();
            worst = rig
                .positions()
                .map(|(demand, actual)| (demand - actual).abs())
                .fold(worst, f64::max);
        }
        assert!(worst < 0.02, "{worst}");
        assert_eq!(rig.positions().count(), 32);
        assert!(rig.trace().len() >= ROWS);
    }
}
