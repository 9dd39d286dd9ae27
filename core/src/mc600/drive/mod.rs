//! The SERVOSTAR 600: its enable sequence, its faults, and the position loop that follows the planner's reference.
//!
//! Source: "Gv_status%", "Gv_command%" in "The other system variables", "The Drive related functions", "How the
//! MC-600 works". The bits are those of the drive profile that the drive's fieldbus cards use (public), which settles
//! the sequence: switch-on inhibit, ready, switched on, operation enabled, one step a sample.

mod faults;
pub mod objects;

use super::planner::Reference;
use crate::plant::{AxisParameters, PlantAxis, presets};
use crate::servo::{Gains, Servo};
pub use faults::{Fault, WARNING_NEGATIVE_LIMIT, WARNING_POSITIVE_LIMIT};
use objects::{Object, Objects};

/// Steps of the position loop in a planner sample of 2 ms.
pub const STEPS: u32 = 8;
/// Period of the position loop, in seconds.
pub const STEP_PERIOD: f64 = 250e-6;
/// A planner sample in seconds.
pub const SAMPLE_PERIOD: f64 = STEP_PERIOD * STEPS as f64;
/// Edges a revolution of the drive's feedback (PRBASE 20).
pub const ENCODER_COUNTS: u32 = 1 << 20;

/// `gv_command%` bit 0.
const ENABLE: i32 = 1 << 0;
/// `gv_command%` bit 1: 0 is emergency stop, then disable.
const NO_STOP_AND_DISABLE: i32 = 1 << 1;
/// `gv_command%` bit 2: 0 is emergency stop, held.
const NO_STOP: i32 = 1 << 2;
/// `gv_command%` bit 3.
const REFERENCE: i32 = 1 << 3;
const COMMAND_BITS: i32 = ENABLE | NO_STOP_AND_DISABLE | NO_STOP | REFERENCE;
/// `gv_command%` at power-up and after `mdrvdis` (D62).
const DISABLED: i32 = NO_STOP_AND_DISABLE | NO_STOP;

/// Following error at which the drive trips, in revolutions (D66: PEMAX of 262144 at 20 bits).
const FOLLOWING_LIMIT: f64 = 0.25;

/// Where the enable sequence stands, in its order.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum State {
    Fault,
    Inhibited,
    Ready,
    SwitchedOn,
    Enabled,
}

/// Following error of an axis that pushes against a mechanical stop, in revolutions (D198).
const STALL_LIMIT: f64 = 1.0 / 16.0;

/// What the world around the drive is like in a sample.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Conditions {
    /// The hardware ENABLE input.
    pub enable_input: bool,
    /// The machine's emergency stop circuit is open: as bit 1 of the command at 0, and the enable is taken back.
    pub emergency_stop: bool,
    /// What trips the drive for as long as it lasts, as an ERRCODE.
    pub faults: u32,
    /// The planner's reference rests.
    pub at_rest: bool,
}

/// The drive's state.
#[derive(Debug, Clone, PartialEq)]
pub struct Drive {
    state: State,
    command: i32,
    /// Bit n-1 is fault n, latched.
    faults: u32,
    /// An emergency stop is under way or held.
    stopping: bool,
    servo: Servo,
    /// Position in 1/256 count where the encoder counts 0.
    origin: i64,
    /// At the end of the last sample, in 1/256 count.
    following_error: f64,
    /// What the position loop asked of the motor last, as a fraction of peak torque.
    output: f64,
    /// Parameters that a program reaches by their numbers.
    pub objects: Objects,
    /// Seen by homing in the last sample.
    pub edges: Edges,
    switches: Switches,
}

/// Where switches changed in a sample, in 1/256 count; what is not looked at has no edges.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Edges {
    /// The reference switch.
    pub home: Option<i64>,
    /// A limit switch.
    pub limit: Option<i64>,
}

/// The switches that homing looks at in each step of the position loop.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
struct Switches {
    home: bool,
    positive_limit: bool,
    negative_limit: bool,
}

impl Switches {
    fn of(plant: &PlantAxis) -> Switches {
        Switches {
            home: plant.at_home(),
            positive_limit: plant.at_positive_limit(),
            negative_limit: plant.at_negative_limit(),
        }
    }
}

/// What the position loop does in a sample besides following.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Duty {
    /// Nothing.
    Follow,
    /// Looks out for switches.
    Home,
    /// The same, and pushes against a mechanical stop with REFIP.
    Push,
}

/// Tuned for [`presets::SERVO`]: a damped position loop of 100 Hz, feed-forward of inertia and viscous friction.
fn gains(plant: &AxisParameters) -> Gains {
    let full_torque = plant.motor_acceleration / (1.0 + plant.load_inertia);
    let bandwidth = 2.0 * core::f64::consts::PI * 100.0;
    Gains {
        proportional: bandwidth * bandwidth / full_torque,
        integral: bandwidth * bandwidth * bandwidth / 16.0 / full_torque,
        integral_deadband: 4.0 / f64::from(ENCODER_COUNTS),
        derivative: 2.0 * bandwidth / full_torque,
        velocity_feedforward: plant.viscous_friction * 60.0 / 1000.0,
        acceleration_feedforward: 1.0 / full_torque,
        output_limit: 1.0,
    }
}

impl Drive {
    /// As at power-up, with the motor where the encoder counts `count`: that is position 0 (D76).
    pub fn new(count: i64) -> Drive {
        Drive {
            state: State::Ready,
            command: DISABLED,
            faults: 0,
            stopping: false,
            servo: Servo::new(gains(&presets::SERVO), STEP_PERIOD),
            origin: -count,
            following_error: 0.0,
            output: 0.0,
            objects: Objects::new(),
            edges: Edges::default(),
            switches: Switches::default(),
        }
    }

    /// The mains go: no torque, and nothing is remembered but the scale of positions.
    pub fn power_off(&mut self) {
        *self = Drive {
            state: State::Inhibited,
            origin: self.origin,
            ..Drive::new(0)
        };
    }

    /// `mdrven`. Nothing happens while a fault is latched or the emergency stop is open (D65).
    pub fn enable(&mut self, conditions: &Conditions) {
        if self.faults == 0 && !conditions.emergency_stop {
            self.command = COMMAND_BITS;
        }
    }

    /// `mdrvdis`: the motor is without torque from the next sample on.
    pub fn disable(&mut self) {
        self.command = DISABLED;
    }

    /// `mclrfault`: faults whose cause is gone are reset. The drive stays disabled.
    pub fn clear_faults(&mut self, conditions: &Conditions) {
        self.faults = conditions.faults;
    }

    /// `gv_command%`.
    pub fn command(&self) -> i32 {
        self.command
    }

    /// Writes `gv_command%`; a drive with a fault cannot be enabled.
    pub fn set_command(&mut self, command: i32) {
        let allowed = if self.faults == 0 {
            COMMAND_BITS
        } else {
            DISABLED
        };
        self.command = command & allowed;
    }

    /// One step of the enable sequence.
    pub fn advance(&mut self, conditions: &Conditions) {
        if conditions.faults != 0 {
            self.trip(conditions.faults);
        }
        if self.faults != 0 {
            self.state = State::Fault;
            self.stopping = false;
            self.following_error = 0.0;
            return;
        }
        let disable_after_stop =
            conditions.emergency_stop || self.command & NO_STOP_AND_DISABLE == 0;
        let running = self.state == State::Enabled && conditions.enable_input;
        self.stopping = running && (disable_after_stop || self.command & NO_STOP == 0);
        if self.stopping && !(disable_after_stop && conditions.at_rest) {
            return;
        }
        self.stopping = false;
        if conditions.emergency_stop {
            self.command &= !(ENABLE | REFERENCE);
        }
        let goal = self.goal(conditions);
        self.state = if goal > self.state {
            self.state.next()
        } else {
            goal
        };
        if self.state != State::Enabled {
            self.servo.reset();
            self.following_error = 0.0;
        }
    }

    /// Where the command and the inputs would have the drive.
    fn goal(&self, conditions: &Conditions) -> State {
        let released = self.command & DISABLED == DISABLED && !conditions.emergency_stop;
        if !released || !conditions.enable_input {
            State::Inhibited
        } else if self.command & ENABLE == 0 {
            State::Ready
        } else if self.command & REFERENCE == 0 {
            State::SwitchedOn
        } else {
            State::Enabled
        }
    }

    fn trip(&mut self, faults: u32) {
        self.faults |= faults;
        self.state = State::Fault;
        self.command &= !(ENABLE | REFERENCE);
        self.servo.reset();
    }

    /// What has tripped it and is not cleared.
    pub fn faults(&self) -> impl Iterator<Item = Fault> {
        Fault::all_of(self.faults)
    }

    /// `gv_error%`: ERRCODE, fault Fnn in bit nn-1.
    pub fn error_code(&self) -> u32 {
        self.faults
    }

    /// Whether the position loop is closed.
    pub fn is_enabled(&self) -> bool {
        self.state == State::Enabled
    }

    /// Whether an emergency stop is under way or held.
    pub fn is_stopping(&self) -> bool {
        self.stopping
    }

    /// Whether a motion command has an effect: the drive is enabled, or on its way there.
    pub fn takes_reference(&self, conditions: &Conditions) -> bool {
        self.faults == 0 && conditions.faults == 0 && self.goal(conditions) == State::Enabled
    }

    /// The drive's bits of `gv_status%`, 0 to 6 and 8; the warning is the machine's.
    pub fn status(&self, conditions: &Conditions) -> i32 {
        let sequence = match self.state {
            State::Fault => 1 << 3,
            State::Inhibited => 1 << 6,
            State::Ready => 0b001,
            State::SwitchedOn => 0b011,
            State::Enabled => 0b111,
        };
        let released = self.command & DISABLED == DISABLED && !conditions.emergency_stop;
        let followed_badly = self.faults & Fault::FOLLOWING_ERROR.bit() != 0;
        sequence | i32::from(released) << 5 | i32::from(followed_badly) << 8
    }

    /// One planner sample of the position loop with the motor. The reference moves evenly over the steps.
    pub fn run(
        &mut self,
        reference: &Reference,
        units_per_revolution: i64,
        duty: Duty,
        plant: &mut PlantAxis,
    ) {
        if self.state != State::Enabled {
            self.output = 0.0;
            (0..STEPS).for_each(|_| plant.step(0.0));
            return;
        }
        let homing = duty != Duty::Follow;
        if homing {
            self.edges = Edges::default();
            self.switches = Switches::of(plant);
        }
        let revolutions = 1.0 / units_per_revolution as f64;
        let velocity = reference.velocity as f64 * revolutions / SAMPLE_PERIOD;
        let acceleration =
            reference.acceleration as f64 * revolutions / (SAMPLE_PERIOD * SAMPLE_PERIOD);
        let start = reference.position.wrapping_sub(reference.velocity);
        for step in 0..STEPS {
            let behind = start.wrapping_sub(self.feedback(units_per_revolution, plant)) as f64;
            let error = behind + reference.velocity as f64 * (f64::from(step) / f64::from(STEPS));
            self.output = self
                .servo
                .update(error * revolutions, velocity, acceleration);
            if duty == Duty::Push {
                let limit = self.objects.torque(Object::Refip);
                self.output = self.output.clamp(-limit, limit);
            }
            plant.step(self.output);
            if homing {
                self.look_out(units_per_revolution, plant);
            }
        }
        self.following_error = reference
            .position
            .wrapping_sub(self.feedback(units_per_revolution, plant))
            as f64;
        let too_far = (self.following_error * revolutions).abs() > FOLLOWING_LIMIT;
        if too_far && duty != Duty::Push {
            self.trip(Fault::FOLLOWING_ERROR.bit());
        }
    }

    /// Notes where switches change.
    #[inline(never)]
    fn look_out(&mut self, units_per_revolution: i64, plant: &PlantAxis) {
        let (before, now) = (self.switches, Switches::of(plant));
        let here = self.feedback(units_per_revolution, plant);
        if now.home != before.home {
            self.edges.home = Some(here);
        }
        if (now.positive_limit, now.negative_limit)
            != (before.positive_limit, before.negative_limit)
        {
            self.edges.limit = Some(here);
        }
        self.switches = now;
    }

    /// Whether the axis stands far behind its reference: at a mechanical stop, when it pushes.
    pub fn is_stalled(&self, units_per_revolution: i64) -> bool {
        self.following_error.abs() > units_per_revolution as f64 * STALL_LIMIT
    }

    /// A zero mark of the feedback unit, in 1/256 count.
    pub fn zero_mark(&self) -> i64 {
        self.origin
    }

    /// The parameters of the position loop have changed.
    pub fn tune(&mut self) {
        let part = |object| self.objects.part(object);
        let tuned = gains(&presets::SERVO);
        self.servo.tune(
            Gains {
                proportional: tuned.proportional * part(Object::Gp),
                integral: tuned.integral / part(Object::Gptn),
                derivative: tuned.derivative * part(Object::Gpv) * part(Object::Gv),
                velocity_feedforward: tuned.velocity_feedforward * part(Object::Gpfbt),
                acceleration_feedforward: tuned.acceleration_feedforward * part(Object::Gpfbt),
                output_limit: self.objects.torque(Object::Ipeak),
                ..tuned
            },
            STEP_PERIOD,
        );
    }

    /// The actual position on the planner's scale, in 1/256 count.
    pub fn feedback(&self, units_per_revolution: i64, plant: &PlantAxis) -> i64 {
        let scale = units_per_revolution / i64::from(ENCODER_COUNTS);
        plant
            .encoder
            .count()
            .wrapping_mul(scale)
            .wrapping_add(self.origin)
    }

    /// The scale of positions moves by `shift` (1/256 count).
    pub fn shift(&mut self, shift: i64) {
        self.origin = self.origin.wrapping_add(shift);
    }

    /// The scale of positions becomes finer (16 times) or coarser.
    pub fn rescale(&mut self, finer: bool) {
        self.origin = if finer {
            self.origin.wrapping_mul(16)
        } else {
            self.origin / 16
        };
    }

    /// Demanded minus actual position, in 1/256 count.
    pub fn following_error(&self) -> f64 {
        self.following_error
    }

    /// What the position loop asks of the motor, as a fraction of its peak torque.
    pub fn output(&self) -> f64 {
        self.output
    }

    /// Whether the position loop still works on half a count or more, with torque to spare.
    pub fn is_settling(&self) -> bool {
        self.following_error.abs() >= 128.0 && self.output.abs() < 1.0
    }
}

impl State {
    fn next(self) -> State {
        match self {
            State::Fault => State::Inhibited,
            State::Inhibited => State::Ready,
            State::Ready => State::SwitchedOn,
            State::SwitchedOn | State::Enabled => State::Enabled,
        }
    }
}
