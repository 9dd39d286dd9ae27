//! Everything behind the SmartMotor's interpreter: trajectory, filter, amplifier, motor, limits, brake, pins, encoders.
//!
//! The interpreter sees numbers ([`Register`]), orders ([`Command`]) and the status word ([`Flag`]); the bench sees
//! wires, faults, mechanics and [`Signals`] (`bench`). Registers are in `settings`, commands in `orders`. A sample
//! reads from the outside in: `counter` and `ports`, then `servo` with `trajectory` (`follow`, `stream`) and `filter`,
//! then the plant and the `amplifier` that heats.

mod amplifier;
mod bench;
pub mod command;
mod counter;
mod filter;
mod follow;
mod orders;
pub mod ports;
pub mod register;
mod servo;
mod settings;
pub mod status;
mod stream;
#[cfg(test)]
mod tests;
mod trajectory;

pub use bench::{FAULTS, Signals};
pub use command::{Brake, Command, ModeWord};
pub use ports::Port;
pub use register::Register;
pub use status::Flag;

use crate::plant::{PlantAxis, presets};
use crate::time::Nanos;
use amplifier::Amplifier;
use bench::Broken;
use counter::Counter;
use filter::Filter;
use ports::Pins;
use settings::{Buffered, Settings};
use stream::Stream;
use trajectory::Trajectory;

/// A servo sample: 24576 periods of 10 ns ("Rates and units").
pub const SAMPLE: Nanos = Nanos(245_760);
/// [`SAMPLE`] in seconds.
const PERIOD: f64 = 245.76e-6;
/// Edges a revolution of the encoder.
pub const COUNTS_PER_REVOLUTION: u32 = 2000;

/// `F` bit 0: a limit decelerates the motor instead of switching it off.
const DECELERATE_AT_LIMIT: i32 = 1;
/// `F` bit 5: faults call the program's C1.
const CALL_AT_FAULT: i32 = 32;

/// Bits that ZS clears; `Bi` is cleared by reading I, the others tell how things are.
const LATCHED: u16 = Flag::RightLimit.mask()
    | Flag::LeftLimit.mask()
    | Flag::Wrap.mask()
    | Flag::PositionError.mask()
    | Flag::MathOverflow.mask()
    | Flag::IndexRange.mask()
    | Flag::Syntax.mask()
    | Flag::OverCurrent.mask();

/// How a motor in MD stands with its host: what Q answers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct StreamStatus {
    /// Bit 0 contouring runs, bit 1 a time was out of range, bit 2 a step was too far, bit 4 more came than the FIFO
    /// holds, bit 5 the FIFO ran dry.
    pub state: u8,
    /// Free places in the FIFO, 0 to 16.
    pub free: u8,
}

/// What the power stage does.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Drive {
    /// Nothing: the shaft is free.
    Off,
    /// Gives the torque of T.
    Torque,
    /// Follows the trajectory.
    Servo,
}

/// The motor, its amplifier and its load.
#[derive(Debug, Clone)]
pub struct Motor {
    powered: bool,
    /// Latched bits and those that the servo keeps; [`Motor::status`] adds those that follow from the state.
    status: u16,
    buffered: Buffered,
    settings: Settings,
    drive: Drive,
    trajectory: Trajectory,
    stream: Stream,
    filter: Filter,
    counter: Counter,
    /// How much the counter moved since the last servo sample.
    master: i64,
    pins: Pins,
    /// Right and left limit and GO in the last sample.
    limits: (bool, bool),
    go: bool,
    plant: PlantAxis,
    amplifier: Amplifier,
    /// What the filter or T asks of the amplifier, -1023 to 1023.
    output: i32,
    /// The encoder's count in the last sample; position as a program reads it where the encoder counts 0; and which
    /// round of 32 bits that is.
    count: i64,
    origin: i64,
    round: i64,
    /// Where the index mark was captured, in counts of the encoder.
    index: i64,
    /// The brake grips.
    braked: bool,
    /// Servo samples since power-up, their divisor, and samples until the next.
    ticks: u64,
    divisor: u8,
    wait: u8,
    /// `ticks` where CLK is 0, as 32 bits.
    clock: i32,
    /// A fault has asked for C1.
    fault_call: bool,
    broken: Broken,
}

impl Motor {
    /// A motor that is switched off.
    pub fn new() -> Motor {
        let mut motor = Motor {
            powered: false,
            status: 0,
            buffered: Buffered::POWER_UP,
            settings: Settings::POWER_UP,
            drive: Drive::Off,
            trajectory: Trajectory::new(0),
            stream: Stream::default(),
            filter: Filter::new(),
            counter: Counter::new(),
            master: 0,
            pins: Pins::new(),
            limits: (false, false),
            go: false,
            plant: PlantAxis::new(
                presets::INTEGRATED,
                PERIOD,
                COUNTS_PER_REVOLUTION,
                COUNTS_PER_REVOLUTION,
            ),
            amplifier: Amplifier::new(),
            output: 0,
            count: 0,
            origin: 0,
            round: 0,
            index: 0,
            braked: false,
            ticks: 0,
            divisor: 1,
            wait: 0,
            clock: 0,
            fault_call: false,
            broken: Broken::default(),
        };
        motor.reset();
        motor
    }

    /// Mains on: registers and modes as at power-up, all pins inputs, the motor off, position 0 where it is.
    pub fn power_up(&mut self) {
        self.powered = true;
        self.ticks = 0;
        self.reset();
    }

    /// Mains off: the motor coasts. What is wired to it and broken about it stays, and so does the brake, unless it
    /// follows the servo or the trajectory (D181).
    pub fn power_off(&mut self) {
        self.switch_off();
        self.powered = false;
        self.limits = (false, false);
        self.pins.reset();
        self.counter.reset();
    }

    /// `Z` and `RESET`: as at power-up, while the motor may still turn.
    pub fn reset(&mut self) {
        self.status = 0;
        self.buffered = Buffered::POWER_UP;
        self.settings = Settings::POWER_UP;
        self.stream.clear();
        self.filter = Filter::new();
        self.counter.reset();
        self.master = 0;
        self.pins.reset();
        self.go = true;
        self.count = self.plant.encoder.count();
        self.set_origin(0);
        self.index = self.count;
        (self.divisor, self.wait) = (1, 0);
        self.set_clock(0);
        self.fault_call = false;
        self.switch_off();
    }

    /// No torque; no trajectory.
    fn switch_off(&mut self) {
        self.drive = Drive::Off;
        self.output = 0;
        self.stream.end();
        self.trajectory.release(self.count, 0);
    }

    /// Closes the loop where the motor is. Whether it can be: nothing is broken, nothing too hot.
    fn switch_on(&mut self) -> bool {
        let can = self.powered && !self.broken.drive && !self.broken.emergency_stop;
        if !can || self.status & Flag::Overheat.mask() != 0 {
            return false;
        }
        self.status &= !Flag::PositionError.mask();
        if self.drive != Drive::Servo {
            self.trajectory.release(self.count, self.motor_velocity());
            self.filter.reset();
            self.drive = Drive::Servo;
        }
        true
    }

    /// The status word `W`; its low byte is `S`.
    pub fn status(&self) -> u16 {
        let mut status = self.status;
        let mut set = |flag: Flag, on: bool| {
            if on {
                status |= flag.mask();
            }
        };
        set(Flag::Trajectory, self.trajectory.is_active());
        set(Flag::Off, self.drive == Drive::Off);
        set(Flag::RightNow, self.limits.0);
        set(Flag::LeftNow, self.limits.1);
        let turn = i64::from(COUNTS_PER_REVOLUTION);
        set(Flag::IndexLevel, self.count.rem_euclid(turn) == 0);
        status
    }

    /// Whether a bit of the status word is set.
    pub fn is(&self, flag: Flag) -> bool {
        self.status() & flag.mask() != 0
    }

    /// Sets a latched bit that the interpreter answers for: `Bd`, `Bu`, `Bs`, `Bk`.
    pub fn raise(&mut self, flag: Flag) {
        self.status |= flag.mask();
    }

    /// Whether a fault or a limit has asked for the routine C1 (F=32) since this was last asked.
    pub fn take_fault_call(&mut self) -> bool {
        std::mem::take(&mut self.fault_call)
    }

    /// Servo samples since power-up, which WAIT counts: fewer by PID2, PID4, PID8. CLK is [`Register::Clock`].
    pub fn ticks(&self) -> u64 {
        self.ticks
    }

    /// The samples that make a servo sample (PID#): 1, 2, 4 or 8.
    pub fn servo_divisor(&self) -> u8 {
        self.divisor
    }

    /// The letter that RMODE answers (D175).
    pub fn mode_letter(&self) -> char {
        if self.status & Flag::PositionError.mask() != 0 {
            return 'E';
        }
        if self.drive == Drive::Off {
            return 'O';
        }
        match self.buffered.mode {
            ModeWord::Position if self.buffered.relative => 'R',
            ModeWord::Position => 'P',
            ModeWord::Velocity => 'V',
            ModeWord::Torque => 'T',
            ModeWord::Contour => 'H',
            ModeWord::Follow(_) | ModeWord::Count => 'F',
            ModeWord::Steps | ModeWord::CountSteps => 'S',
            ModeWord::FollowRatio | ModeWord::StepsRatio => 'X',
            ModeWord::Cam(_) => 'C',
        }
    }

    /// A position (byte 250) from the host for MD, in counts.
    pub fn stream_position(&mut self, position: i32) {
        self.stream.position(position);
    }

    /// A time (byte 251) from the host for MD, in servo samples: the position before it is to be reached in it.
    pub fn stream_time(&mut self, time: i32) {
        let here = self.reading(self.trajectory.count());
        self.stream.time(time, here);
    }

    /// What Q answers.
    pub fn stream_status(&self) -> StreamStatus {
        StreamStatus {
            state: self.stream.state(),
            free: self.stream.free(),
        }
    }

    /// A count of the encoder as a program reads it.
    fn reading(&self, count: i64) -> i32 {
        wrap(count.wrapping_add(self.origin))
    }

    /// Demanded minus actual position, in counts.
    fn error(&self) -> i64 {
        match self.drive {
            Drive::Servo => self.trajectory.count() - self.count,
            Drive::Off | Drive::Torque => 0,
        }
    }

    /// Of the trajectory, without one of the motor; counts/sample x 65536.
    fn velocity(&self) -> i64 {
        match self.drive {
            Drive::Servo => self.trajectory.velocity(),
            Drive::Off | Drive::Torque => self.motor_velocity(),
        }
    }

    /// Of the motor, in counts in a servo sample x 65536.
    #[allow(clippy::cast_possible_truncation)] // far below 2^63
    fn motor_velocity(&self) -> i64 {
        let revolutions = self.plant.velocity() * PERIOD * f64::from(self.divisor);
        (revolutions * f64::from(COUNTS_PER_REVOLUTION) * 65_536.0) as i64
    }
}

impl Default for Motor {
    fn default() -> Motor {
        Motor::new()
    }
}

#[allow(clippy::cast_possible_truncation)] // wrapping is what the motor's registers do
fn wrap(value: i64) -> i32 {
    value as i32
}

fn saturate(value: i64) -> i32 {
    i32::try_from(value).unwrap_or(if value < 0 { i32::MIN } else { i32::MAX })
}
