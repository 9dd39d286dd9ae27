//! One motor with its current loop, and the load on its shaft.

use core::f64::consts::PI;

use super::encoder::Encoder;

/// The mechanics of an axis. Torques are fractions of the motor's peak torque, positions revolutions of its shaft.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AxisParameters {
    /// What peak torque does to the bare motor, in rev/s²; above zero.
    pub motor_acceleration: f64,
    /// Inertia of the load as a multiple of the motor's; not negative.
    pub load_inertia: f64,
    /// Torque that it takes to start and to keep turning, whatever the speed.
    pub coulomb_friction: f64,
    /// Torque for each 1000 rpm.
    pub viscous_friction: f64,
    /// Largest torque the drive gives, 0 to 1.
    pub torque_limit: f64,
    /// Of the drive's current loop, in Hz.
    pub bandwidth: f64,
    /// Speed at which the drive's voltage gives no more torque, in rev/s.
    pub max_speed: f64,
    /// Between the hard stops.
    pub travel: Span,
    /// Where neither limit switch is pressed.
    pub limits: Span,
    /// Where the home switch is pressed.
    pub home: Span,
    /// Torque that always acts on the load, backwards where it is above zero: a weight on a vertical axis.
    pub pull: f64,
}

/// A range of positions, in revolutions; either end may be infinite.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Span {
    /// Lower end.
    pub from: f64,
    /// Upper end.
    pub to: f64,
}

impl Span {
    /// Everywhere.
    pub const ENDLESS: Span = Span {
        from: f64::NEG_INFINITY,
        to: f64::INFINITY,
    };
    /// No position at all.
    pub const NOWHERE: Span = Span {
        from: f64::INFINITY,
        to: f64::NEG_INFINITY,
    };

    /// Whether `position` is within, ends included.
    pub fn contains(&self, position: f64) -> bool {
        position >= self.from && position <= self.to
    }
}

/// Speeds within this part of the maximum see the torque fade.
const FADE: f64 = 1.0 / 16.0;

/// A motor, its load and its encoder, stepped at a fixed period. It starts at rest at position 0.
#[derive(Debug, Clone, PartialEq)]
pub struct PlantAxis {
    parameters: AxisParameters,
    /// In seconds.
    period: f64,
    /// Of the controller that positions are configured for.
    pub(super) counts_per_revolution: f64,
    constants: StepConstants,
    /// In revolutions.
    position: f64,
    /// In rev/s.
    velocity: f64,
    /// Fraction of peak.
    torque: f64,
    jammed: bool,
    /// On the motor's shaft.
    pub encoder: Encoder,
}

/// The parameters as one step needs them.
#[derive(Debug, Clone, Copy, PartialEq)]
struct StepConstants {
    /// Part of a torque step that the current loop makes in one period.
    lag: f64,
    /// Velocity that full torque adds.
    kick: f64,
    /// Factor that viscous friction leaves of a velocity.
    damping: f64,
    /// Velocity that Coulomb friction takes; infinite when jammed.
    friction: f64,
    /// Velocity that the pull on the load takes.
    pull: f64,
    /// Torque per rev/s below the maximum speed.
    fade: f64,
    /// Half the period.
    half_period: f64,
}

impl StepConstants {
    fn new(parameters: &AxisParameters, period: f64, jammed: bool) -> StepConstants {
        let kick = parameters.motor_acceleration / (1.0 + parameters.load_inertia) * period;
        let viscous = parameters.viscous_friction * 60.0 / 1000.0;
        StepConstants {
            lag: 1.0 - libm::exp(-2.0 * PI * parameters.bandwidth * period),
            kick,
            damping: 1.0 / (1.0 + kick * viscous),
            friction: if jammed {
                f64::INFINITY
            } else {
                kick * parameters.coulomb_friction
            },
            pull: kick * parameters.pull,
            fade: 1.0 / (FADE * parameters.max_speed),
            half_period: 0.5 * period,
        }
    }
}

impl PlantAxis {
    /// An axis stepped every `period` seconds, with an encoder of `encoder_counts` a revolution, for a controller that
    /// counts `counts_per_revolution`.
    pub fn new(
        parameters: AxisParameters,
        period: f64,
        encoder_counts: u32,
        counts_per_revolution: u32,
    ) -> PlantAxis {
        PlantAxis {
            parameters,
            period,
            counts_per_revolution: f64::from(counts_per_revolution),
            constants: StepConstants::new(&parameters, period, false),
            position: 0.0,
            velocity: 0.0,
            torque: 0.0,
            jammed: false,
            encoder: Encoder::new(encoder_counts),
        }
    }

    /// One period with the drive asked for `torque`, a fraction of peak.
    #[inline]
    pub fn step(&mut self, torque: f64) {
        let StepConstants {
            lag,
            kick,
            damping,
            friction,
            pull,
            fade,
            half_period,
        } = self.constants;
        let limit = self.parameters.torque_limit;
        let asked = if torque > limit {
            limit
        } else if torque < -limit {
            -limit
        } else {
            torque
        };
        let mut torque = self.torque + (asked - self.torque) * lag;
        let most = (self.parameters.max_speed - self.velocity) * fade;
        let least = (-self.parameters.max_speed - self.velocity) * fade;
        torque = if torque > most {
            most
        } else if torque < least {
            least
        } else {
            torque
        };
        self.torque = torque;

        // Friction can stop the axis but never drive it: what is left of the velocity when it has taken its part.
        let pushed = (self.velocity + torque * kick - pull) * damping;
        let velocity = if pushed > friction {
            pushed - friction
        } else if pushed < -friction {
            pushed + friction
        } else {
            0.0
        };
        self.position += (self.velocity + velocity) * half_period;
        self.velocity = velocity;
        let travel = self.parameters.travel;
        if self.position > travel.to {
            self.rest_at(travel.to);
        } else if self.position < travel.from {
            self.rest_at(travel.from);
        }
        self.encoder.update(self.position);
    }

    /// A stepping motor: its field holds the shaft at `position`, in revolutions, unless a hard stop is in the way or
    /// the shaft is seized; then it stays where it can be.
    pub fn hold_at(&mut self, position: f64) {
        let travel = self.parameters.travel;
        if !self.jammed && position.is_finite() {
            self.position = if position > travel.to {
                travel.to
            } else if position < travel.from {
                travel.from
            } else {
                position
            };
        }
        (self.velocity, self.torque) = (0.0, 0.0);
        self.encoder.update(self.position);
    }

    /// A hard stop takes all the speed.
    #[cold]
    fn rest_at(&mut self, position: f64) {
        self.position = position;
        self.velocity = 0.0;
    }

    /// In revolutions since the axis was built.
    pub fn position(&self) -> f64 {
        self.position
    }

    /// In rev/s.
    pub fn velocity(&self) -> f64 {
        self.velocity
    }

    /// What the motor gives, as a fraction of peak.
    pub fn torque(&self) -> f64 {
        self.torque
    }

    /// Whether the axis stands on or beyond its positive limit switch.
    pub fn at_positive_limit(&self) -> bool {
        self.position > self.parameters.limits.to
    }

    /// Whether the axis stands on or beyond its negative limit switch.
    pub fn at_negative_limit(&self) -> bool {
        self.position < self.parameters.limits.from
    }

    /// Whether the home switch is pressed.
    pub fn at_home(&self) -> bool {
        self.parameters.home.contains(self.position)
    }

    /// Seizes the shaft, or lets it go.
    pub fn set_jammed(&mut self, jammed: bool) {
        self.jammed = jammed;
        self.constants = StepConstants::new(&self.parameters, self.period, jammed);
    }

    /// The mechanics now.
    pub fn parameters(&self) -> &AxisParameters {
        &self.parameters
    }

    /// Changes the mechanics; position and speed stay.
    pub fn set_parameters(&mut self, parameters: AxisParameters) {
        self.parameters = parameters;
        self.constants = StepConstants::new(&parameters, self.period, self.jammed);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plant::presets::SERVO;

    const PERIOD: f64 = 250e-6;

    fn axis(change: impl FnOnce(&mut AxisParameters)) -> PlantAxis {
        let mut parameters = SERVO;
        change(&mut parameters);
        PlantAxis::new(parameters, PERIOD, 1 << 20, 4096)
    }

    fn push(axis: &mut PlantAxis, torque: f64, seconds: f64) {
        let steps = (seconds / PERIOD).round() as u32;
        (0..steps).for_each(|_| axis.step(torque));
    }

    #[test]
    fn rests_until_the_push_exceeds_friction() {
        let mut axis = axis(|p| p.coulomb_friction = 0.1);
        push(&mut axis, 0.099, 1.0);
        assert_eq!((axis.position(), axis.velocity()), (0.0, 0.0));
        push(&mut axis, 0.11, 0.1);
        assert!(axis.velocity() > 0.0);
    }

    #[test]
    fn coasts_to_rest_and_stays() {
        let mut axis = axis(|_| ());
        push(&mut axis, 1.0, 0.01);
        push(&mut axis, 0.0, 2.0);
        let rest = axis.position();
        assert_eq!(axis.velocity(), 0.0);
        push(&mut axis, 0.0, 1.0);
        assert_eq!(axis.position(), rest);
    }

    #[test]
    fn accelerates_as_its_inertia_says() {
        let mut axis = axis(|p| {
            (p.load_inertia, p.coulomb_friction, p.viscous_friction) = (2.0, 0.0, 0.0);
        });
        push(&mut axis, 0.5, 0.02);
        let ideal = 0.5 * SERVO.motor_acceleration / 3.0 * 0.02;
        assert!(
            (axis.velocity() - ideal).abs() < 0.02 * ideal,
            "{} {ideal}",
            axis.velocity()
        );
    }

    #[test]
    fn settles_where_viscous_friction_balances_the_push() {
        let mut axis = axis(|p| (p.coulomb_friction, p.viscous_friction) = (0.0, 0.1));
        push(&mut axis, 0.2, 5.0);
        assert!(
            (axis.velocity() * 60.0 - 2000.0).abs() < 1.0,
            "{}",
            axis.velocity()
        );
    }

    #[test]
    fn runs_no_faster_than_its_voltage_allows() {
        let mut axis = axis(|_| ());
        push(&mut axis, 1.0, 5.0);
        assert!(axis.velocity() < SERVO.max_speed && axis.velocity() > 0.9 * SERVO.max_speed);
        push(&mut axis, -1.0, 5.0);
        assert!(axis.velocity() < -0.9 * SERVO.max_speed);
    }

    #[test]
    fn a_weight_falls_unless_it_is_held() {
        let mut axis = axis(|p| p.pull = 0.1);
        push(&mut axis, 0.1, 1.0);
        assert!(axis.velocity() == 0.0 && axis.position().abs() < 1e-3);
        push(&mut axis, 0.0, 0.1);
        assert!(axis.velocity() < -10.0);
    }

    #[test]
    fn hard_stops_hold() {
        let mut axis = axis(|p| {
            p.travel = Span {
                from: -0.5,
                to: 0.25,
            }
        });
        push(&mut axis, 1.0, 1.0);
        assert_eq!((axis.position(), axis.velocity()), (0.25, 0.0));
        push(&mut axis, -1.0, 1.0);
        assert_eq!(axis.position(), -0.5);
    }

    #[test]
    fn a_stepping_motor_is_where_its_field_is_unless_it_cannot() {
        let mut axis = axis(|p| {
            p.travel = Span {
                from: -1.0,
                to: 2.0,
            }
        });
        axis.hold_at(1.5);
        assert_eq!((axis.position(), axis.encoder.count()), (1.5, 3 << 19));
        axis.hold_at(2.5);
        assert_eq!(axis.position(), 2.0);
        axis.set_jammed(true);
        axis.hold_at(0.0);
        assert_eq!(axis.position(), 2.0);
    }

    #[test]
    fn a_jammed_shaft_does_not_turn() {
        let mut axis = axis(|_| ());
        axis.set_jammed(true);
        push(&mut axis, 1.0, 1.0);
        assert_eq!(axis.position(), 0.0);
        axis.set_jammed(false);
        push(&mut axis, 1.0, 0.1);
        assert!(axis.position() > 0.0);
    }
}
