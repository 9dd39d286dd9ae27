//! Everything behind the SmartMotor's interpreter: trajectory, filter, amplifier, motor, limits, brake, pins, encoders.
//!
//! The interpreter sees numbers ([`Register`]), orders ([`Command`]) and the status word ([`Flag`]); the bench sees
//! wires, faults, mechanics and [`Signals`] (`bench`). A sample reads from the outside in: `counter` and `ports`, then
//! `servo` with `trajectory` (`follow`, `stream`) and `filter`, then the plant and the `amplifier` that heats.

mod amplifier;
mod bench;
pub mod command;
mod counter;
mod filter;
mod follow;
pub mod ports;
pub mod register;
mod servo;
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
use counter::{Counter, Counting};
use filter::{FULL, Filter};
use follow::{Cam, Ratio};
use ports::Pins;
use stream::Stream;
use trajectory::Trajectory;

/// A servo sample: 24576 periods of 10 ns ("Rates and units").
pub const SAMPLE: Nanos = Nanos(245_760);
/// [`SAMPLE`] in seconds.
const PERIOD: f64 = 245.76e-6;
/// Edges a revolution of the encoder.
pub const COUNTS_PER_REVOLUTION: u32 = 2000;

/// `E` at power-up.
const ERROR_LIMIT: i32 = 1000;
/// `TH` at power-up, in °C.
const TRIP_TEMPERATURE: i32 = 70;
/// `BASE` at power-up: a turn of the encoder outside.
const CAM_BASE: i32 = 2000;

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

/// What a program has set and G starts with.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Buffered {
    acceleration: i32,
    velocity: i32,
    position: i32,
    distance: i32,
    /// D was set last, not P.
    relative: bool,
    mode: ModeWord,
    multiplier: i16,
    divisor: i16,
    base: i32,
    size: i32,
}

/// What a program has set and acts at once.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Settings {
    torque: i32,
    error_limit: i32,
    amps: i32,
    trip_temperature: i32,
    functions: i32,
    brake: Brake,
    /// LIMD.
    directional: bool,
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

    /// The value of a register, without any effect. A register that is only set reads 0.
    pub fn get(&self, register: Register) -> i32 {
        if let Some(gain) = self.filter.buffered.get(register) {
            return gain;
        }
        let Buffered {
            acceleration,
            velocity,
            position,
            distance,
            multiplier,
            divisor,
            base,
            size,
            ..
        } = self.buffered;
        let torque = self.plant.torque();
        match register {
            Register::Acceleration => acceleration,
            Register::Velocity => velocity,
            Register::Position => position,
            Register::Distance => distance,
            Register::Torque => self.settings.torque,
            Register::ErrorLimit => self.settings.error_limit,
            Register::Amps => self.settings.amps,
            Register::TripTemperature => self.settings.trip_temperature,
            Register::Temperature => self.amplifier.degrees(),
            Register::Current => amplifier::current_reading(torque),
            Register::Supply => amplifier::supply_reading(torque),
            Register::ActualPosition => self.reading(self.count),
            Register::ActualVelocity => saturate(self.velocity()),
            Register::PositionError => saturate(self.error()),
            Register::Index => self.reading(self.index),
            Register::Counter => wrap(self.counter.count()),
            Register::Clock => self.tick_register().wrapping_sub(self.clock),
            Register::FollowMultiplier => i32::from(multiplier),
            Register::FollowDivisor => i32::from(divisor),
            Register::CamBase => base,
            Register::CamSize => size,
            Register::Functions => self.settings.functions,
            Register::Pin(port) => i32::from(self.pins.level(port)),
            Register::Analog(port) => self.pins.analog(port),
            _ => 0,
        }
    }

    /// The value of a register as a program reads it: I gives up the captured index, so that the next is captured.
    pub fn read(&mut self, register: Register) -> i32 {
        if register == Register::Index {
            self.status &= !Flag::IndexCaptured.mask();
        }
        self.get(register)
    }

    /// Sets a register; what is out of range is limited to it. One that cannot be set stays as it is, as MFDIV does
    /// when it is given 0.
    pub fn set(&mut self, register: Register, value: i32) {
        if self.filter.buffered.set(register, value) {
            return;
        }
        let buffered = &mut self.buffered;
        let settings = &mut self.settings;
        match register {
            Register::Acceleration => buffered.acceleration = value.max(0),
            Register::Velocity => buffered.velocity = value,
            Register::Position => (buffered.position, buffered.relative) = (value, false),
            Register::Distance => (buffered.distance, buffered.relative) = (value, true),
            Register::FollowMultiplier => buffered.multiplier = short(value),
            Register::FollowDivisor if value != 0 => buffered.divisor = short(value),
            Register::CamBase => buffered.base = value.clamp(1, Cam::LONGEST),
            Register::CamSize => buffered.size = value.clamp(1, Cam::MOST),
            Register::Torque => settings.torque = value.clamp(-FULL, FULL),
            Register::ErrorLimit => settings.error_limit = value.clamp(0, 32_767),
            Register::Amps => settings.amps = value.clamp(0, FULL),
            Register::TripTemperature => settings.trip_temperature = value.clamp(0, 85),
            Register::Functions => settings.functions = value,
            Register::Origin => self.set_origin(value),
            Register::Clock => self.set_clock(value),
            Register::Pin(port) => self.pins.write(port, value & 1 != 0),
            _ => {}
        }
    }

    /// The actual position reads `value` from now on; no one moves.
    fn set_origin(&mut self, value: i32) {
        self.stream
            .renumber(value.wrapping_sub(self.reading(self.count)));
        self.origin = i64::from(value) - self.count;
        self.round = 0;
    }

    fn set_clock(&mut self, value: i32) {
        self.clock = self.tick_register().wrapping_sub(value);
    }

    #[allow(clippy::cast_possible_truncation)] // CLK wraps at 32 bits
    fn tick_register(&self) -> i32 {
        self.ticks as i32
    }

    /// Carries out a command. What cannot be, because the motor is too hot or something is broken, is ignored.
    pub fn command(&mut self, command: Command) {
        match command {
            Command::Go => self.go(),
            Command::Decelerate => self.decelerate(),
            Command::StopNow => self.stop_now(),
            Command::Off => self.switch_off(),
            Command::Mode(mode) => self.choose(mode),
            Command::LoadFilter => self.filter.load(),
            Command::GravityOn => self.filter.gravity = true,
            Command::GravityOff => self.filter.gravity = false,
            Command::ServoDivisor(divisor) => self.divisor = divisor.clamp(1, 8),
            Command::Brake(brake) => self.settings.brake = brake,
            Command::BrakePin(port) => self.pins.brake_by(port),
            Command::LimitsDirectional => self.settings.directional = true,
            Command::LimitsNondirectional => self.settings.directional = false,
            Command::LimitsHigh => self.pins.limits_high = true,
            Command::LimitsLow => self.pins.limits_high = false,
            Command::Input(port) => {
                self.uncount(port);
                self.pins.make_input(port);
            }
            Command::Output(port) => {
                self.uncount(port);
                self.pins.make_output(port);
            }
            Command::RightLimit => self.pins.make_special(Port::C),
            Command::LeftLimit => self.pins.make_special(Port::D),
            Command::GoInput => {
                // A pin that is low already is no start.
                self.go = true;
                self.pins.make_special(Port::G);
            }
            Command::ClearAll => self.status &= !LATCHED,
            Command::Clear(flag) => self.status &= !(flag.mask() & LATCHED),
        }
    }

    /// UA and UB become the counter's.
    fn count_by(&mut self, counting: Counting) {
        self.pins.make_input(Port::A);
        self.pins.make_input(Port::B);
        self.counter.count_by(counting);
    }

    /// A pin that becomes plain no longer counts.
    fn uncount(&mut self, port: Port) {
        if matches!(port, Port::A | Port::B) {
            self.counter.count_by(Counting::Stopped);
        }
    }

    /// A mode word: what the next G starts. MT acts at once, and those that count do from now on.
    fn choose(&mut self, mode: ModeWord) {
        match mode {
            ModeWord::Count => {
                self.count_by(Counting::Quadrature(4));
                self.counter.zero();
                return;
            }
            ModeWord::CountSteps => {
                self.count_by(Counting::Steps);
                self.counter.zero();
                return;
            }
            ModeWord::Follow(counts) => self.count_by(Counting::Quadrature(counts)),
            ModeWord::FollowRatio => self.count_by(Counting::Quadrature(4)),
            ModeWord::Steps | ModeWord::StepsRatio => self.count_by(Counting::Steps),
            ModeWord::Cam(_) if self.counter.counting == Counting::Stopped => {
                self.count_by(Counting::Quadrature(4));
            }
            ModeWord::Contour => self.stream.clear(),
            ModeWord::Torque => {
                if self.switch_on() {
                    self.trajectory.hold();
                    self.drive = Drive::Torque;
                }
            }
            ModeWord::Cam(_) | ModeWord::Position | ModeWord::Velocity => {}
        }
        self.buffered.mode = mode;
    }

    /// `G`.
    fn go(&mut self) {
        if !self.switch_on() {
            return;
        }
        let Buffered {
            acceleration,
            velocity,
            position,
            distance,
            relative,
            mode,
            multiplier,
            divisor,
            base,
            size,
        } = self.buffered;
        if mode != ModeWord::Contour {
            self.stream.end();
        }
        let here = self.trajectory.count();
        match mode {
            ModeWord::Position => {
                // Across the end of the 32 bits, if that is the shorter way.
                let way = if relative {
                    distance
                } else {
                    position.wrapping_sub(self.reading(here))
                };
                let target = here + i64::from(way);
                self.trajectory.move_to(target, velocity, acceleration);
            }
            ModeWord::Velocity => self.trajectory.run_at(velocity, acceleration),
            ModeWord::Torque => {
                self.trajectory.hold();
                self.drive = Drive::Torque;
            }
            ModeWord::Contour => {
                self.stream.begin(self.reading(here));
                self.trajectory.contour();
            }
            ModeWord::Follow(_) | ModeWord::Steps => self.trajectory.follow(Ratio::new(1, 1)),
            ModeWord::FollowRatio | ModeWord::StepsRatio => {
                self.trajectory.follow(Ratio::new(multiplier, divisor));
            }
            ModeWord::Cam(times) => self.trajectory.cam(Cam::new(base, size, times)),
            ModeWord::Count | ModeWord::CountSteps => {}
        }
        // What came before G is not followed.
        self.master = 0;
    }

    /// `X`. A motor in torque mode is caught by the servo and decelerated.
    fn decelerate(&mut self) {
        let acceleration = self.buffered.acceleration;
        if self.drive == Drive::Torque && self.switch_on() {
            self.trajectory.run_at(0, acceleration);
        }
        self.stream.end();
        self.trajectory.decelerate(acceleration);
    }

    /// `S`. A motor that is off stays off.
    fn stop_now(&mut self) {
        self.stream.end();
        if self.drive != Drive::Off && self.switch_on() {
            self.trajectory.hold();
        }
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

impl Buffered {
    const POWER_UP: Buffered = Buffered {
        acceleration: 0,
        velocity: 0,
        position: 0,
        distance: 0,
        relative: false,
        mode: ModeWord::Position,
        multiplier: 1,
        divisor: 1,
        base: CAM_BASE,
        size: 1,
    };
}

impl Settings {
    const POWER_UP: Settings = Settings {
        torque: 0,
        error_limit: ERROR_LIMIT,
        amps: FULL,
        trip_temperature: TRIP_TEMPERATURE,
        functions: 0,
        brake: Brake::Released,
        directional: false,
    };
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

fn short(value: i32) -> i16 {
    i16::try_from(value).unwrap_or(if value < 0 { i16::MIN } else { i16::MAX })
}
