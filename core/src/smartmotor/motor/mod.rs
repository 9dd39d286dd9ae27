//! Everything behind the SmartMotor's interpreter: trajectory, filter, amplifier, motor, limits, brake, pins, encoders.
//!
//! The interpreter sees numbers ([`Register`]), orders ([`Command`]) and the status word ([`Flag`]); the bench sees
//! wires, faults, mechanics and [`Signals`].

pub mod command;
pub mod ports;
pub mod register;
pub mod status;

pub use command::{Brake, Command, ModeWord};
pub use ports::Port;
pub use register::Register;
pub use status::Flag;

use crate::time::Nanos;

/// A servo sample: 24576 periods of 10 ns ("Rates and units").
pub const SAMPLE: Nanos = Nanos(245_760);
/// Edges a revolution of the encoder.
pub const COUNTS_PER_REVOLUTION: u32 = 2000;

/// The faults that [`Motor::fault`] knows.
pub const FAULTS: [&str; 6] = ["drive", "limit+", "limit-", "stall", "encoder", "estop"];

/// What can be recorded after a sample. Positions are in counts as a program reads them, velocities in counts/sample x
/// 65536, accelerations in counts/sample² x 65536.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Signals {
    /// Of the trajectory.
    pub demand_position: f64,
    /// Of the trajectory.
    pub demand_velocity: f64,
    /// Of the trajectory.
    pub demand_acceleration: f64,
    /// `@P`.
    pub position: f64,
    /// Of the motor.
    pub velocity: f64,
    /// `@PE`.
    pub following_error: f64,
    /// What the filter asks of the amplifier, -1023 to 1023.
    pub output: f64,
    /// Motor current in A.
    pub current: f64,
    /// Of the motor itself, in revolutions since it was built.
    pub shaft: f64,
    /// Bit n is the level of pin n, A first, as a program reads it.
    pub pins: u32,
    /// The status word.
    pub status: f64,
}

/// How a motor in MD stands with its host: what Q answers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct StreamStatus {
    /// Bit 0 contouring runs, bit 1 position and time out of order, bit 2 FIFO was full, bit 3 FIFO ran dry,
    /// bit 4 the step was too far, bit 5 the motor is off.
    pub state: u8,
    /// Free places in the FIFO.
    pub free: u8,
}

/// The motor, its amplifier and its load.
#[derive(Debug, Clone)]
pub struct Motor {
    powered: bool,
    status: u16,
    ticks: u64,
}

impl Motor {
    /// A motor that is switched off.
    pub fn new() -> Motor {
        Motor {
            powered: false,
            status: 0,
            ticks: 0,
        }
    }

    /// Mains on: registers and modes as at power-up, all pins inputs, the motor off, position 0 where it is.
    pub fn power_up(&mut self) {
        self.reset();
        self.powered = true;
    }

    /// Mains off: the motor coasts. What is wired to it and broken about it stays.
    pub fn power_off(&mut self) {
        self.powered = false;
    }

    /// `Z` and `RESET`: as at power-up, while the motor may still turn.
    pub fn reset(&mut self) {
        self.status = Flag::Off.mask();
    }

    /// The value of a register, without any effect. A register that is only set reads 0.
    pub fn get(&self, register: Register) -> i32 {
        let _ = register;
        0
    }

    /// The value of a register as a program reads it: I gives up the captured index, so that the next is captured.
    pub fn read(&mut self, register: Register) -> i32 {
        self.get(register)
    }

    /// Sets a register; what is out of range is limited to it. One that cannot be set stays as it is.
    pub fn set(&mut self, register: Register, value: i32) {
        let _ = (register, value);
    }

    /// Carries out a command.
    pub fn command(&mut self, command: Command) {
        let _ = command;
    }

    /// The status word `W`; its low byte is `S`.
    pub fn status(&self) -> u16 {
        self.status
    }

    /// Whether a bit of the status word is set.
    pub fn is(&self, flag: Flag) -> bool {
        self.status() & flag.mask() != 0
    }

    /// Sets a latched bit that the interpreter answers for: `Bd`, `Bu`, `Bs`, `Bk`.
    pub fn raise(&mut self, flag: Flag) {
        self.status |= flag.mask();
    }

    /// Whether a fault or a limit has asked for the fault routine C1 (F=32) since it was last asked.
    pub fn take_fault_call(&mut self) -> bool {
        false
    }

    /// Servo samples since power-up, which WAIT counts: fewer by PID2, PID4, PID8. CLK is [`Register::Clock`].
    pub fn ticks(&self) -> u64 {
        self.ticks
    }

    /// The servo samples counted by PID#: 1, 2, 4 or 8.
    pub fn servo_divisor(&self) -> u8 {
        1
    }

    /// The letter that RMODE answers.
    pub fn mode_letter(&self) -> char {
        'O'
    }

    /// A position (byte 250) from the host for MD, in counts.
    pub fn stream_position(&mut self, position: i32) {
        let _ = position;
    }

    /// A time (byte 251) from the host for MD, in servo samples.
    pub fn stream_time(&mut self, time: i32) {
        let _ = time;
    }

    /// What Q answers.
    pub fn stream_status(&self) -> StreamStatus {
        StreamStatus { state: 0, free: 0 }
    }

    /// One sample of 245.76 us. `table` is aw[], which MC takes its cam from.
    pub fn sample(&mut self, table: impl Fn(u8) -> i16) {
        let _ = table;
        self.ticks += 1;
    }

    /// Names that [`Motor::wire`] knows: `UA` to `UG` (volts), `encoder` (rpm of an external encoder of 2000 counts on A
    /// and B), `steps` (steps a second, negative backwards).
    pub fn wires() -> Vec<String> {
        Vec::new()
    }

    /// Sets a thing outside.
    ///
    /// # Errors
    /// One line if there is no such wire, or the value does not fit.
    pub fn wire(&mut self, name: &str, value: f64) -> Result<(), String> {
        let _ = value;
        Err(format!("the SmartMotor has no wire `{name}`"))
    }

    /// Breaks something, or mends it: one of [`FAULTS`].
    ///
    /// # Errors
    /// One line if there is no such fault or axis.
    pub fn fault(&mut self, kind: &str, axis: Option<&str>, active: bool) -> Result<(), String> {
        let _ = (axis, active);
        Err(format!("the SmartMotor has no fault `{kind}`"))
    }

    /// Changes the mechanics; see [`crate::plant::configure::KEYS`].
    ///
    /// # Errors
    /// One line if there is no such axis or key, or the value does not fit.
    pub fn configure(&mut self, axis: &str, key: &str, value: &str) -> Result<(), String> {
        let _ = (axis, value);
        Err(format!("the SmartMotor has no `{key}`"))
    }

    /// Whether a trajectory is in progress, or the motor turns or is not yet where it should be.
    pub fn is_moving(&self) -> bool {
        false
    }

    /// Whether the servo holds the motor.
    pub fn is_enabled(&self) -> bool {
        !self.is(Flag::Off)
    }

    /// What has tripped the motor, in words.
    pub fn fault_words(&self) -> Option<String> {
        None
    }

    /// What can be recorded now.
    pub fn signals(&self) -> Signals {
        Signals::default()
    }
}

impl Default for Motor {
    fn default() -> Motor {
        Motor::new()
    }
}
