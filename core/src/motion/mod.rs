//! Motion: where an axis should be, at any time.
//!
//! [`ramp`] steps in exact integers, one sample after the other, for controllers whose firmware counts; [`profile`]
//! is a move in closed form, for those that compute in floating point, and what the ramps are measured against.

pub mod profile;
pub mod ramp;
pub mod rig;

/// Where an axis is or should be at one instant, in any one unit of length per second.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct MotionState {
    /// Position.
    pub position: f64,
    /// Velocity, per second.
    pub velocity: f64,
    /// Acceleration, per second squared.
    pub acceleration: f64,
}
