//! Axes as they come out of the box.

use super::axis::{AxisParameters, Span};

/// A small brushless servo with a well-matched load: 3000 rpm rated, no stops within reach.
///
/// With its load it can accelerate by 180 rpm/ms; friction takes 2 % of the peak torque, at 3000 rpm 5 %.
pub const SERVO: AxisParameters = AxisParameters {
    motor_acceleration: 6000.0,
    load_inertia: 1.0,
    coulomb_friction: 0.02,
    viscous_friction: 0.01,
    torque_limit: 1.0,
    bandwidth: 1000.0,
    max_speed: 100.0,
    travel: Span::ENDLESS,
    limits: Span::ENDLESS,
    home: Span::NOWHERE,
    pull: 0.0,
};

/// A motor with its amplifier on its back and a load of its own inertia: 5000 rpm, no stops within reach.
///
/// With its load it can accelerate by 540 rpm/ms; friction takes 1.2 % of the peak torque.
pub const INTEGRATED: AxisParameters = AxisParameters {
    motor_acceleration: 18_000.0,
    coulomb_friction: 0.012,
    max_speed: 5000.0 / 60.0,
    ..SERVO
};
