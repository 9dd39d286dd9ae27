//! What a clock output drives: a servo amplifier with its motor, or a stepper translator with its.

use super::DriveKind;
use super::command::Direction;
use crate::plant::{AxisParameters, PlantAxis, Span, presets};

/// Steps a revolution, of the encoder and of the translators (D294).
pub(super) const STEPS_PER_REVOLUTION: u32 = 2000;
/// Between two updates of the servo and its motor, in us.
pub(super) const PERIOD_US: u64 = 250;
const PERIOD: f64 = 250e-6;

/// The mechanics of a new bench: home from the place at power-up on (D296).
const MECHANICS: AxisParameters = AxisParameters {
    home: Span {
        from: 0.0,
        to: f64::INFINITY,
    },
    ..presets::SERVO
};

/// Of the servo (D294): the velocity that a following error asks for, 1/s; so the lag at a feedrate is that of 20 ms.
const POSITION_GAIN: f64 = 50.0;
/// Torque for each rev/s that the tachometer misses: a velocity loop of 400 rad/s.
const VELOCITY_GAIN: f64 = 400.0 / 3000.0;
/// Torque added in the direction of the error: what turns the motor at all on a new bench.
const FRICTION: f64 = MECHANICS.coulomb_friction;
/// Torque that the integrator gathers in a second for each rev of error, and the most that it gives.
const INTEGRAL_GAIN: f64 = 200.0;
const INTEGRAL_LIMIT: f64 = 0.5;
/// The integrator works below this speed only, in rev/s: it overcomes more friction and weight, not lag.
const INTEGRAL_SPEED: f64 = 0.1;
/// A following error beyond this trips the servo, in steps.
const LARGEST_ERROR: f64 = 8192.0;
/// In position within this, in steps.
const IN_POSITION: f64 = 1.0;
/// A motor slower than this stands still, in rev/s.
const STANDSTILL: f64 = 0.002;

/// Injected faults that last until they are mended.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Broken {
    pub drive: bool,
    pub positive_limit: bool,
    pub negative_limit: bool,
    pub emergency_stop: bool,
    pub home: bool,
}

/// A drive with its motor, load and switches.
#[derive(Debug, Clone)]
pub(super) struct Drive {
    kind: DriveKind,
    reversed: bool,
    powered: bool,
    pub plant: PlantAxis,
    pub broken: Broken,
    /// The shaft is seized.
    jammed: bool,
    /// Every pulse at the clock output, and those that no limit held back.
    clocked: i64,
    passed: i64,
    /// Of what the tracking display counts, where it shows 0.
    zero: i64,
    /// Servo: where the motor should be, in counts of the encoder.
    reference: f64,
    integral: f64,
    torque: f64,
    tripped: bool,
}

impl Drive {
    pub fn new(kind: DriveKind, reversed: bool) -> Drive {
        let steps = STEPS_PER_REVOLUTION;
        Drive {
            kind,
            reversed,
            powered: false,
            plant: PlantAxis::new(MECHANICS, PERIOD, steps, steps),
            broken: Broken::default(),
            jammed: false,
            clocked: 0,
            passed: 0,
            zero: 0,
            reference: 0.0,
            integral: 0.0,
            torque: 0.0,
            tripped: false,
        }
    }

    /// Mains on or off. On, all counters are 0.
    pub fn power(&mut self, on: bool) {
        self.powered = on;
        self.clocked = 0;
        self.passed = 0;
        self.reset();
        self.clear_tracking();
    }

    /// The reset pulse: no fault, no following error.
    pub fn reset(&mut self) {
        self.tripped = false;
        self.release();
    }

    /// The motor should be where it is.
    fn release(&mut self) {
        self.reference = self.count();
        (self.integral, self.torque) = (0.0, 0.0);
    }

    /// Other jumpers; the tracking display stays.
    pub fn rebuild(&mut self, kind: DriveKind, reversed: bool) {
        let shown = self.tracking();
        if kind != self.kind {
            self.release();
        }
        (self.kind, self.reversed) = (kind, reversed);
        self.zero += self.tracking() - shown;
    }

    /// A clock pulse. A closed limit switch holds back what leads further into it (4-10, D300).
    #[inline]
    pub fn clock(&mut self, direction: Direction) {
        self.clocked += direction.sign();
        if self.is_barred(direction) {
            return;
        }
        self.passed += direction.sign();
        let sign = self.shaft_sign(direction);
        match self.kind {
            DriveKind::Dc => self.reference += sign,
            DriveKind::StepperLow | DriveKind::StepperHigh if self.is_enabled() => {
                let step = sign / f64::from(STEPS_PER_REVOLUTION);
                // Off the grid only after the motor was turned without power: it falls onto it again.
                let steps = f64::from(STEPS_PER_REVOLUTION);
                let place = ((self.plant.position() + step) * steps).round() / steps;
                self.plant.hold_at(place);
            }
            DriveKind::StepperLow | DriveKind::StepperHigh => {}
        }
    }

    /// One period of motor and load.
    #[inline]
    pub fn step(&mut self) {
        let holds = self.is_enabled();
        match self.kind {
            DriveKind::Dc if holds => self.servo(),
            DriveKind::Dc => {
                self.tripped |= self.powered;
                self.plant.step(0.0);
                self.release();
            }
            DriveKind::StepperLow | DriveKind::StepperHigh if holds => {
                if self.plant.velocity() != 0.0 {
                    self.plant.hold_at(self.plant.position());
                }
            }
            DriveKind::StepperLow | DriveKind::StepperHigh => self.plant.step(0.0),
        }
    }

    /// Position loop around a velocity loop with a tachometer: the error is what makes the motor turn.
    fn servo(&mut self) {
        let error = self.reference - self.count();
        if error.abs() > LARGEST_ERROR {
            self.tripped = true;
            self.plant.step(0.0);
            self.release();
            return;
        }
        let revolutions = error / f64::from(STEPS_PER_REVOLUTION);
        if self.plant.velocity().abs() < INTEGRAL_SPEED {
            let integral = self.integral + INTEGRAL_GAIN * revolutions * PERIOD;
            self.integral = integral.clamp(-INTEGRAL_LIMIT, INTEGRAL_LIMIT);
        }
        let velocity = POSITION_GAIN * revolutions - self.plant.velocity();
        let friction = if error == 0.0 {
            0.0
        } else {
            FRICTION.copysign(error)
        };
        self.torque = VELOCITY_GAIN * velocity + friction + self.integral;
        self.plant.step(self.torque);
    }

    /// Holds its motor.
    pub fn is_enabled(&self) -> bool {
        self.powered && !self.tripped && !self.broken.drive && !self.broken.emergency_stop
    }

    /// What has tripped it, in words (D301).
    pub fn fault(&self) -> Option<&'static str> {
        let broken = [
            (self.broken.emergency_stop, "emergency stop"),
            (self.broken.drive, "drive"),
            (self.tripped, "drive tripped"),
        ];
        let found = broken.iter().find(|(is, _)| *is);
        found.filter(|_| self.powered).map(|(_, words)| *words)
    }

    /// Whether pulses in this direction are held back.
    pub fn is_barred(&self, direction: Direction) -> bool {
        if self.shaft_sign(direction) > 0.0 {
            self.broken.positive_limit || self.plant.at_positive_limit()
        } else {
            self.broken.negative_limit || self.plant.at_negative_limit()
        }
    }

    pub fn at_home(&self) -> bool {
        self.broken.home || self.plant.at_home()
    }

    /// The encoder's count is a whole number of revolutions.
    pub fn at_marker(&self) -> bool {
        // A step's fraction, because a stepper's place is a quotient that may lie a last digit below its step.
        let steps = f64::from(STEPS_PER_REVOLUTION);
        (self.plant.position() * steps + 1e-6).floor() % steps == 0.0
    }

    /// The drive stops where the motor is now, and takes the pulses that it has not followed as done.
    pub fn stop_here(&mut self) {
        self.reference = self.count();
    }

    pub fn set_jammed(&mut self, jammed: bool) {
        self.jammed = jammed;
        self.plant.set_jammed(jammed);
    }

    pub fn tracking(&self) -> i64 {
        self.tracked() - self.zero
    }

    pub fn clear_tracking(&mut self) {
        self.zero = self.tracked();
    }

    /// What the tracking display counts: a servo's encoder, a stepper's pulses.
    fn tracked(&self) -> i64 {
        match self.kind {
            DriveKind::Dc if self.reversed => -self.plant.encoder.count(),
            DriveKind::Dc => self.plant.encoder.count(),
            DriveKind::StepperLow | DriveKind::StepperHigh => self.passed,
        }
    }

    pub fn clocked(&self) -> i64 {
        self.clocked
    }

    pub fn in_position(&self) -> bool {
        match self.kind {
            DriveKind::Dc => self.is_enabled() && self.error().abs() <= IN_POSITION,
            DriveKind::StepperLow | DriveKind::StepperHigh => true,
        }
    }

    /// Turns, or has yet to settle on its place. What is blocked rests.
    pub fn is_moving(&self) -> bool {
        let blocked = self.integral.abs() >= INTEGRAL_LIMIT;
        let settles = self.is_enabled() && self.error() != 0.0 && !blocked;
        settles || self.plant.velocity().abs() > STANDSTILL
    }

    /// Pulses that the motor has yet to follow, as they count.
    pub fn error(&self) -> f64 {
        match self.kind {
            DriveKind::Dc => (self.reference - self.count()) * self.shaft_sign(Direction::Positive),
            DriveKind::StepperLow | DriveKind::StepperHigh => 0.0,
        }
    }

    /// Of the motor, in steps/s as they count; that of a stepper follows from its clock.
    pub fn velocity(&self) -> f64 {
        self.plant.velocity()
            * f64::from(STEPS_PER_REVOLUTION)
            * self.shaft_sign(Direction::Positive)
    }

    /// Torque asked of the motor, as it counts.
    pub fn output(&self) -> f64 {
        self.torque.clamp(-1.0, 1.0) * self.shaft_sign(Direction::Positive)
    }

    /// Which way the shaft goes: 1.0 or -1.0.
    #[inline]
    fn shaft_sign(&self, direction: Direction) -> f64 {
        match direction {
            Direction::Positive if self.reversed => -1.0,
            Direction::Positive => 1.0,
            Direction::Negative if self.reversed => 1.0,
            Direction::Negative => -1.0,
        }
    }

    #[allow(clippy::cast_precision_loss)] // exact to 2^53 counts
    fn count(&self) -> f64 {
        self.plant.encoder.count() as f64
    }
}
