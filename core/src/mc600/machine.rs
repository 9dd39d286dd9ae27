//! Everything behind the MC-600's interpreter: planner, drive, motor and inputs and outputs.

use std::fmt;

use super::drive::{Conditions, Drive, ENCODER_COUNTS, Fault, SAMPLE_PERIOD, STEP_PERIOD};
use super::planner::{Blocked, Planner, saturate};
use super::sysvars::SysVar;
use crate::io::DigitalImage;
use crate::plant::{PlantAxis, presets};

/// Counts a revolution at power-up; positions of the plant are configured in these.
const COUNTS_PER_REVOLUTION: u32 = 4096;
/// Inputs 0 to 7 are on the card, 8 to 11 are IN1 to IN4 of the drive, 12 is its ENABLE.
const INPUTS: u8 = 13;
/// The drive's ENABLE input. It is on until it is wired otherwise, so that `mdrven` works on a new bench (D64).
const ENABLE_INPUT: u8 = 12;
/// Outputs 0 to 7 are on the card, 8 and 9 on the drive.
const OUTPUTS: u8 = 10;
/// `gv_velmot%` of 1 rpm ("The other system variables").
const VELMOT_PER_RPM: f64 = 33_554_432.0 / 240_000.0;
/// A motor slower than this stands still for the bench, in rpm.
const STANDSTILL: f64 = 0.5;
/// `gv_status%` bit 7.
const STATUS_WARNING: i32 = 1 << 7;

/// The faults that [`Machine::fault`] knows.
pub const FAULTS: [&str; 6] = ["drive", "limit+", "limit-", "stall", "encoder", "estop"];

/// What a program orders of planner and drive; written as in the program.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum MotionCommand {
    /// `mspeed(vel)`, in counts*256/sample.
    Speed(i32),
    /// `mmove(pos)`, in counts.
    Move(i32),
    /// `mimove(ipos)`, in counts.
    MoveBy(i32),
    /// `midle()`.
    Idle,
    /// `mdrven()`.
    EnableDrive,
    /// `mdrvdis()`.
    DisableDrive,
    /// `mclrfault()`.
    ClearFault,
}

impl fmt::Display for MotionCommand {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            MotionCommand::Speed(velocity) => write!(f, "mspeed({velocity})"),
            MotionCommand::Move(position) => write!(f, "mmove({position})"),
            MotionCommand::MoveBy(distance) => write!(f, "mimove({distance})"),
            MotionCommand::Idle => f.write_str("midle()"),
            MotionCommand::EnableDrive => f.write_str("mdrven()"),
            MotionCommand::DisableDrive => f.write_str("mdrvdis()"),
            MotionCommand::ClearFault => f.write_str("mclrfault()"),
        }
    }
}

/// What can be recorded of a machine after a sample. Positions are in counts as a program reads them, velocities in
/// counts*256/sample ([`Machine::rpm`] converts), accelerations in counts*256/sample².
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Signals {
    /// `sl_posdemand%`.
    pub demand_position: f64,
    /// `sl_spddemand%`.
    pub demand_velocity: f64,
    /// Change of the demanded velocity.
    pub demand_acceleration: f64,
    /// `gv_feedback%`.
    pub position: f64,
    /// Of the motor.
    pub velocity: f64,
    /// Of the drive's position loop, in counts and fractions.
    pub following_error: f64,
    /// Of the position loop: torque as a fraction of the motor's peak.
    pub output: f64,
    /// Of the motor itself, in revolutions since it was built, whatever the controller counts.
    pub shaft: f64,
    /// Bit n is input n.
    pub inputs: u32,
    /// Bit n is output n.
    pub outputs: u32,
}

/// Planner, drive, motor, inputs and outputs: all that the interpreter sees.
#[derive(Debug, Clone)]
pub struct Machine {
    powered: bool,
    planner: Planner,
    drive: Drive,
    plant: PlantAxis,
    inputs: DigitalImage,
    outputs: DigitalImage,
    broken: Broken,
}

/// Injected faults that last until they are mended.
#[derive(Debug, Clone, Copy, Default)]
struct Broken {
    drive: bool,
    positive_limit: bool,
    negative_limit: bool,
    emergency_stop: bool,
}

impl Machine {
    /// A machine that is switched off.
    pub fn new() -> Machine {
        let plant = PlantAxis::new(
            presets::SERVO,
            STEP_PERIOD,
            ENCODER_COUNTS,
            COUNTS_PER_REVOLUTION,
        );
        let mut inputs = DigitalImage::default();
        inputs.set(ENABLE_INPUT, true);
        Machine {
            powered: false,
            planner: Planner::new(),
            drive: Drive::new(0),
            plant,
            inputs,
            outputs: DigitalImage::default(),
            broken: Broken::default(),
        }
    }

    /// Mains on: variables at their defaults, outputs off, position 0 where the motor is.
    pub fn power_up(&mut self) {
        self.planner = Planner::new();
        self.drive = Drive::new(self.plant.encoder.count());
        self.outputs = DigitalImage::default();
        self.powered = true;
    }

    /// Mains off: the motor coasts. What is wired to the machine and broken about it stays.
    pub fn power_off(&mut self) {
        self.powered = false;
        self.drive.power_off();
        self.outputs = DigitalImage::default();
    }

    /// One planner sample of 2 ms with drive and motor.
    pub fn sample(&mut self) {
        if self.powered {
            self.drive.advance(&self.conditions());
        }
        if self.drive.is_enabled() {
            if self.drive.is_stopping() {
                self.planner.emergency_stop();
            }
            self.planner.sample(self.blocked());
        }
        let units = self.planner.units_per_revolution();
        self.drive
            .run(self.planner.reference(), units, &mut self.plant);
        if !self.drive.is_enabled() {
            self.release_reference();
        }
    }

    /// The reference goes along with a motor that the drive does not hold, so that the drive takes over without a jump.
    fn release_reference(&mut self) {
        if !self.drive.takes_reference(&self.conditions()) {
            self.planner.abort();
        }
        let feedback = self
            .drive
            .feedback(self.planner.units_per_revolution(), &self.plant);
        self.planner.follow(feedback, to_register(self.velocity()));
    }

    fn conditions(&self) -> Conditions {
        let fault = if self.plant.encoder.is_dead() {
            Some(Fault::Feedback)
        } else {
            self.broken.drive.then_some(Fault::OutputStage)
        };
        Conditions {
            enable_input: self.inputs.get(ENABLE_INPUT),
            emergency_stop: self.broken.emergency_stop,
            fault,
            at_rest: self.planner.reference().velocity == 0,
        }
    }

    fn blocked(&self) -> Blocked {
        Blocked {
            forward: self.broken.positive_limit || self.plant.at_positive_limit(),
            reverse: self.broken.negative_limit || self.plant.at_negative_limit(),
        }
    }

    /// Carries out a command of the program.
    ///
    /// A motion command has an effect once the drive is enabled or on its way there, in the very next statement after
    /// `mdrven`: the motion then starts with the enabled drive. Otherwise, and while an emergency stop is held, the
    /// reference is not enabled and the planner stays idle (D63).
    pub fn command(&mut self, command: MotionCommand) {
        let conditions = self.conditions();
        let takes_reference = self.drive.takes_reference(&conditions);
        match command {
            MotionCommand::Speed(velocity) if takes_reference => self.planner.speed(velocity),
            MotionCommand::Move(position) if takes_reference => self.planner.move_to(position),
            MotionCommand::MoveBy(distance) if takes_reference => self.planner.move_by(distance),
            MotionCommand::Speed(_) | MotionCommand::Move(_) | MotionCommand::MoveBy(_) => {}
            MotionCommand::Idle => self.planner.idle(),
            MotionCommand::EnableDrive => self.drive.enable(&conditions),
            MotionCommand::DisableDrive => self.drive.disable(),
            MotionCommand::ClearFault => self.drive.clear_faults(&conditions),
        }
    }

    /// The value of a system variable; 0 for those that this machine does not have.
    pub fn get(&self, var: SysVar) -> i32 {
        let planner = &self.planner;
        match var {
            SysVar::Mres => planner.resolution(),
            SysVar::SmAcc => planner.speed_acceleration,
            SysVar::SmFlag => planner.speed_flags(),
            SysVar::SmSpeed => planner.speed_demand(),
            SysVar::MvAcc => planner.move_acceleration,
            SysVar::MvDec => planner.move_deceleration,
            SysVar::MvSpeed => planner.move_speed,
            SysVar::MvFlag => planner.move_flags(),
            SysVar::GvFeedback => planner.reading(
                self.drive
                    .feedback(planner.units_per_revolution(), &self.plant),
            ),
            SysVar::GvSmod => planner.modulus_word(),
            SysVar::SlPosDemand => planner.reading(planner.reference().position),
            SysVar::SlSpdDemand => saturate(planner.reference().velocity),
            SysVar::GvStatus => self.status(),
            SysVar::GvCommand => self.drive.command(),
            SysVar::GvVelmot => {
                saturate(to_register(self.plant.velocity() * 60.0 * VELMOT_PER_RPM))
            }
            SysVar::GvMflag => planner.motion_flags(),
            SysVar::GvIn(number) => i32::from(number < INPUTS && self.inputs.get(number)),
            SysVar::GvOut(number) => i32::from(number < OUTPUTS && self.outputs.get(number)),
            _ => 0,
        }
    }

    /// Assigns a system variable. Those that cannot be assigned, or that this machine does not have, stay as they are.
    pub fn set(&mut self, var: SysVar, value: i32) {
        match var {
            SysVar::Mres => {
                let before = self.planner.resolution();
                self.planner.set_resolution(value);
                if self.planner.resolution() != before {
                    self.drive.rescale(before == 0);
                }
            }
            SysVar::SmAcc => self.planner.speed_acceleration = value,
            SysVar::MvAcc => self.planner.move_acceleration = value,
            SysVar::MvDec => self.planner.move_deceleration = value,
            SysVar::MvSpeed => self.planner.move_speed = value,
            SysVar::MvFlag => self.planner.set_move_flags(value),
            SysVar::GvSmod => {
                let shift = self.planner.set_modulus(value);
                self.drive.shift(shift);
            }
            SysVar::GvCommand => self.drive.set_command(value),
            SysVar::GvOut(number) if number < OUTPUTS => self.outputs.set(number, value != 0),
            _ => {}
        }
    }

    fn status(&self) -> i32 {
        let blocked = self.blocked();
        let warning = if blocked.forward || blocked.reverse {
            STATUS_WARNING
        } else {
            0
        };
        self.drive.status(&self.conditions()) | warning | self.planner.status()
    }

    /// `outsta`: the card's outputs 0 to 7.
    pub fn outputs(&self) -> u8 {
        self.outputs.low_byte()
    }

    /// `outw`: the card's outputs 0 to 7.
    pub fn write_outputs(&mut self, outputs: u8) {
        self.outputs.set_low_byte(outputs);
    }

    /// `insta`: the card's inputs 0 to 7.
    pub fn inputs(&self) -> u8 {
        self.inputs.low_byte()
    }

    /// Names that [`Machine::wire`] knows.
    pub fn wires() -> Vec<String> {
        (0..INPUTS).map(|number| format!("in{number}")).collect()
    }

    /// Sets a level outside: `in0` to `in12`, on unless `value` is 0.
    ///
    /// # Errors
    /// One line if there is no such wire, or the value is not a number.
    pub fn wire(&mut self, name: &str, value: f64) -> Result<(), String> {
        let number = (0..INPUTS).find(|number| format!("in{number}") == name);
        match number {
            Some(_) if value.is_nan() => Err(format!("wire {name}: expected a number")),
            Some(number) => {
                self.inputs.set(number, value != 0.0);
                Ok(())
            }
            None => Err(format!(
                "the MC-600 has no wire `{name}`; it has in0 to in12"
            )),
        }
    }

    /// Breaks something, or mends it: one of [`FAULTS`].
    ///
    /// `drive` and `encoder` trip the drive until `mclrfault` is given after they are mended. `limit+` and `limit-`
    /// press a limit switch: motion in that direction is stopped, the other is free, `gv_status%` bit 7 warns. `stall`
    /// seizes the shaft, which trips the drive by its following error. `estop` stops the axis and disables the drive.
    ///
    /// # Errors
    /// One line if there is no such fault or axis.
    pub fn fault(&mut self, kind: &str, axis: Option<&str>, active: bool) -> Result<(), String> {
        check_axis(axis)?;
        match kind {
            "drive" => self.broken.drive = active,
            "limit+" => self.broken.positive_limit = active,
            "limit-" => self.broken.negative_limit = active,
            "stall" => self.plant.set_jammed(active),
            "encoder" => self.plant.encoder.set_dead(active),
            "estop" => self.broken.emergency_stop = active,
            _ => {
                return Err(format!(
                    "the MC-600 has no fault `{kind}`; it has {}",
                    FAULTS.join(", ")
                ));
            }
        }
        Ok(())
    }

    /// Changes the mechanics; see [`crate::plant::configure::KEYS`].
    ///
    /// # Errors
    /// One line if there is no such axis or key, or the value does not fit.
    pub fn configure(&mut self, axis: &str, key: &str, value: &str) -> Result<(), String> {
        check_axis(Some(axis))?;
        self.plant.configure(key, value)
    }

    /// Whether the reference moves or is going to, the motor turns or it is not yet where it should be.
    pub fn is_moving(&self) -> bool {
        self.planner.is_moving()
            || self.drive.is_settling()
            || (self.plant.velocity() * 60.0).abs() > STANDSTILL
    }

    /// Whether the drive holds the motor.
    pub fn is_enabled(&self) -> bool {
        self.drive.is_enabled()
    }

    /// What has tripped the drive, by the numbers and names of its own list.
    pub fn fault_words(&self) -> Option<String> {
        let words: Vec<String> = self.drive.faults().map(|fault| fault.to_string()).collect();
        (!words.is_empty()).then(|| words.join(", "))
    }

    /// What can be recorded now.
    pub fn signals(&self) -> Signals {
        let reference = self.planner.reference();
        Signals {
            demand_position: f64::from(self.get(SysVar::SlPosDemand)),
            demand_velocity: reference.velocity as f64,
            demand_acceleration: reference.acceleration as f64,
            position: f64::from(self.get(SysVar::GvFeedback)),
            velocity: self.velocity(),
            following_error: self.drive.following_error() / 256.0,
            output: self.drive.output(),
            shaft: self.plant.position(),
            inputs: self.inputs.0,
            outputs: self.outputs.0,
        }
    }

    /// A velocity in counts*256/sample as revolutions a minute.
    pub fn rpm(&self, velocity: f64) -> f64 {
        velocity * 60.0 / (SAMPLE_PERIOD * self.planner.units_per_revolution() as f64)
    }

    /// Of the motor, in counts*256/sample.
    fn velocity(&self) -> f64 {
        self.plant.velocity() * self.planner.units_per_revolution() as f64 * SAMPLE_PERIOD
    }
}

impl Default for Machine {
    fn default() -> Machine {
        Machine::new()
    }
}

fn check_axis(axis: Option<&str>) -> Result<(), String> {
    match axis {
        None | Some("x" | "0") => Ok(()),
        Some(other) => Err(format!("the MC-600 has no axis `{other}`; its axis is x")),
    }
}

#[allow(clippy::cast_possible_truncation)] // `as` saturates; the fraction is dropped on purpose
fn to_register(value: f64) -> i64 {
    value as i64
}
