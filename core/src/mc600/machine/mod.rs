//! Everything behind the MC-600's interpreter: planner, drive, motor and inputs and outputs.
//!
//! `command` is what a program orders, `variables` what it reads and writes, `outside` what a person does to the
//! machine, `positions` and `servobus` the parts that are neither planner nor drive.

mod command;
mod outside;
mod positions;
mod servobus;
mod variables;

use std::rc::Rc;

use super::drive::objects::Object;
use super::drive::{
    Conditions, Drive, Duty, ENCODER_COUNTS, Edges, Fault, SAMPLE_PERIOD, STEP_PERIOD,
};
use super::interrupts::{self, Interrupts};
use super::planner::cam::Table;
use super::planner::encoder::{Encoder, Interface};
use super::planner::home::{Homing, Surroundings};
use super::planner::{Blocked, Planner};
use super::sysvars::SysVar;
use crate::controller::CamTable;
use crate::controller::Telegram;
use crate::io::DigitalImage;
use crate::plant::{PlantAxis, presets};
pub use command::MotionCommand;
pub use outside::FAULTS;
pub use positions::Compared;
use positions::{Capture, Comparators, Latches};
use servobus::ServoBus;
pub use servobus::{IDENTIFIERS, MAILBOXES, TELEGRAM_TIME};

/// Counts a revolution at power-up; positions of the plant are configured in these.
const COUNTS_PER_REVOLUTION: u32 = 4096;
/// Inputs 0 to 7 are on the card, 8 to 11 are IN1 to IN4 of the drive, 12 is its ENABLE.
const INPUTS: u8 = 13;
/// The drive's ENABLE input. It is on until it is wired otherwise, so that `mdrven` works on a new bench (D64).
const ENABLE_INPUT: u8 = 12;
/// Outputs 0 to 7 are on the card, 8 and 9 on the drive.
const OUTPUTS: u8 = 10;
/// The output that `msetoutcmp` drives.
const COMPARED_OUTPUT: u8 = 7;
/// A motor slower than this stands still for the bench, in rpm.
const STANDSTILL: f64 = 0.5;
/// Samples between two timer interrupts: 10 ms (D206).
const TIMER_SAMPLES: u32 = 5;

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
    analog: Analog,
    /// What an absolute encoder at the SSI input reads, in counts.
    absolute: i32,
    /// The table that the next `mcam` takes.
    table: Table,
    comparators: Comparators,
    /// Of inputs 2 and 3.
    captures: [Capture; 2],
    /// Inputs that have captured since the last sample.
    captured: u32,
    /// `gv_capsel%`.
    capture_source: i32,
    latches: Latches,
    bus: ServoBus,
    /// What may interrupt the program.
    pub interrupts: Interrupts,
    /// The actual position before this sample, in 1/256 count.
    feedback_before: i64,
    /// Since power-up.
    samples: u32,
}

/// Analog inputs and monitor outputs of the drive, in mV.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
struct Analog {
    inputs: [i32; 2],
    monitors: [i32; 2],
}

/// Injected faults that last until they are mended.
#[derive(Debug, Clone, Copy, Default)]
struct Broken {
    drive: bool,
    positive_limit: bool,
    negative_limit: bool,
    emergency_stop: bool,
    /// By the drive's own numbers, as an ERRCODE.
    internal: u32,
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
            planner: Planner::new(Encoder::new()),
            drive: Drive::new(0),
            plant,
            inputs,
            outputs: DigitalImage::default(),
            broken: Broken::default(),
            analog: Analog::default(),
            absolute: 0,
            table: Rc::default(),
            comparators: Comparators::default(),
            captures: [Capture::default(); 2],
            captured: 0,
            capture_source: 0,
            latches: Latches::default(),
            bus: ServoBus::default(),
            interrupts: Interrupts::new(),
            feedback_before: 0,
            samples: 0,
        }
    }

    /// Mains on: variables at their defaults, outputs off, position 0 where the motor is. What is outside stays as it is.
    pub fn power_up(&mut self) {
        let inputs = self.analog.inputs;
        *self = Machine {
            powered: true,
            planner: Planner::new(self.planner.master.encoder.clone()),
            drive: Drive::new(self.plant.encoder.count()),
            plant: self.plant.clone(),
            inputs: self.inputs,
            broken: self.broken,
            analog: Analog {
                inputs,
                ..Analog::default()
            },
            absolute: self.absolute,
            ..Machine::new()
        };
    }

    /// Mains off: the motor coasts. What is wired to the machine and broken about it stays.
    pub fn power_off(&mut self) {
        self.powered = false;
        self.drive.power_off();
        self.outputs = DigitalImage::default();
    }

    /// Connects the master's encoder: by the drive's set-up, so at any time.
    pub fn set_encoder(&mut self, interface: Interface) {
        self.planner.master.encoder.set_interface(interface);
    }

    /// One planner sample of 2 ms with drive and motor.
    pub fn sample(&mut self) {
        self.feedback_before = self.feedback();
        if self.powered {
            self.drive.advance(&self.conditions());
            self.planner.sample_master(self.bus.received);
        }
        if self.drive.is_enabled() {
            if self.drive.is_stopping() {
                self.planner.emergency_stop();
            }
            let around = match self.planner.is_homing() {
                true => self.surroundings(),
                false => Surroundings::default(),
            };
            let shift = self.planner.sample(self.blocked(), &around);
            self.drive.shift(shift);
            self.feedback_before = self.feedback_before.wrapping_add(shift);
        }
        let units = self.planner.units_per_revolution();
        let duty = match self.planner.is_homing() {
            false => Duty::Follow,
            true if self.planner.pushes() => Duty::Push,
            true => Duty::Home,
        };
        self.drive
            .run(self.planner.reference(), units, duty, &mut self.plant);
        if !self.drive.is_enabled() {
            self.release_reference();
        }
        if self.powered {
            self.observe();
        }
    }

    /// The reference goes along with a motor that the drive does not hold, so that the drive takes over without a jump.
    fn release_reference(&mut self) {
        if !self.drive.takes_reference(&self.conditions()) {
            self.planner.abort();
        }
        let feedback = self.feedback();
        self.planner.follow(feedback, to_register(self.velocity()));
    }

    /// What comparators and interrupts see of a sample.
    fn observe(&mut self) {
        self.samples = self.samples.wrapping_add(1);
        self.compare();
        if self.interrupts.are_set_up() {
            let mut pulses = self.captured;
            if self.samples.is_multiple_of(TIMER_SAMPLES) {
                pulses |= interrupts::bit(interrupts::TIMER);
            }
            if self.planner.cam_passed_zero() {
                pulses |= interrupts::bit(interrupts::CAM_INDEX);
            }
            let levels = self.interrupt_levels();
            self.interrupts.observe(levels, pulses);
        }
        self.captured = 0;
    }

    /// The interrupt sources that have a level, by their numbers.
    fn interrupt_levels(&self) -> u32 {
        let status = self.status();
        let status = [3, 7, 8, 10]
            .into_iter()
            .enumerate()
            .fold(0, |bits, (at, bit)| {
                bits | u32::from(status >> bit & 1 != 0) << (13 + at)
            });
        let flags = u32::from(self.planner.motion_flags().to_le_bytes()[0]) & 0x1F;
        u32::from(self.inputs())
            | flags << 8
            | status
            | u32::from(self.comparators.word) << interrupts::COMPARATORS
    }

    /// `intsetup(line,source,edge)`, checked already.
    pub fn set_up_interrupt(&mut self, line: u16, source: u8, edge: u8) {
        let levels = self.interrupt_levels();
        self.interrupts.set_up(line, source, edge, levels);
    }

    /// Sets the outputs of the position comparators.
    fn compare(&mut self) {
        if !self.comparators.are_set {
            return;
        }
        let position = |source: Compared| match source {
            Compared::Feedback => self.get(SysVar::GvFeedback),
            Compared::Master => self.get(SysVar::GvMaster),
            Compared::CamMaster => self.get(SysVar::CmMaster),
        };
        let mut word = 0;
        for (number, window) in self.comparators.windows.iter().enumerate() {
            if let Some((source, window)) = window {
                word |= u8::from(window.contains(position(*source))) << number;
            }
        }
        let output = self.comparators.output;
        let output = output.map(|window| window.contains(position(Compared::Feedback)));
        self.comparators.word = word;
        if let Some(on) = output {
            self.outputs.set(COMPARED_OUTPUT, on);
        }
    }

    fn conditions(&self) -> Conditions {
        let mut faults = self.broken.internal;
        if self.plant.encoder.is_dead() {
            faults |= Fault::FEEDBACK.bit();
        }
        if self.broken.drive {
            faults |= Fault::OUTPUT_STAGE.bit();
        }
        Conditions {
            enable_input: self.inputs.get(ENABLE_INPUT),
            emergency_stop: self.broken.emergency_stop,
            faults,
            at_rest: self.planner.reference().velocity == 0,
        }
    }

    fn blocked(&self) -> Blocked {
        Blocked {
            forward: self.broken.positive_limit || self.plant.at_positive_limit(),
            reverse: self.broken.negative_limit || self.plant.at_negative_limit(),
        }
    }

    /// What homing meets.
    fn surroundings(&self) -> Surroundings {
        let blocked = self.blocked();
        let turn = self.planner.units_per_revolution();
        Surroundings {
            switch: self.plant.at_home(),
            switch_edge: self.drive.edges.home,
            positive_limit: blocked.forward,
            negative_limit: blocked.reverse,
            limit_edge: self.drive.edges.limit,
            feedback: self.feedback(),
            zero_mark: self.drive.zero_mark(),
            turn,
            stalled: self.drive.is_stalled(turn),
        }
    }

    /// The drive's homing parameters on the planner's scale: VREF in um/s, ramps in ms to that speed.
    fn homing(&self) -> Homing {
        let objects = &self.drive.objects;
        let turn = self.planner.units_per_revolution();
        let speed = (objects.length(objects.get(Object::Vref), turn) / 500).max(1);
        // A ramp of t ms takes t/2 samples.
        let ramp = |object| (speed * 2 / i64::from(objects.get(object)).max(1)).max(1);
        Homing {
            kind: objects.get(Object::Nref),
            direction: objects.get(Object::Dref),
            speed,
            acceleration: ramp(Object::Accr),
            deceleration: ramp(Object::Decr),
            offset: objects.length(objects.get(Object::Roffs), turn),
            absolute: i64::from(self.absolute) << 8,
        }
    }

    /// The cam table that is or was in use.
    pub fn cam_table(&self) -> Option<CamTable> {
        self.planner.cam_table()
    }

    /// Lays a table ready for the `mcam` that follows.
    pub fn lay_table(&mut self, table: Table) {
        self.table = table;
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

    /// A telegram of another card.
    pub fn receive(&mut self, telegram: &Telegram) {
        if self.powered {
            self.bus.receive(telegram);
        }
    }

    /// What goes out on the ServoBus after a sample, in its order.
    pub fn send(&mut self) -> Vec<Telegram> {
        if !self.powered || self.bus.is_silent() {
            return Vec::new();
        }
        let position = self.get(SysVar::GvMaster);
        self.bus.send(position)
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
        if self.drive.error_code() == 0 {
            return None;
        }
        let words: Vec<String> = self.drive.faults().map(|fault| fault.to_string()).collect();
        Some(words.join(", "))
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

    /// The actual position in 1/256 count, unwrapped.
    fn feedback(&self) -> i64 {
        let units = self.planner.units_per_revolution();
        self.drive.feedback(units, &self.plant)
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

#[allow(clippy::cast_possible_truncation)] // `as` saturates; the fraction is dropped on purpose
fn to_register(value: f64) -> i64 {
    value as i64
}
