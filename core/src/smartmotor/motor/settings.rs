//! Registers: what a program reads, sets, and starts with G.

use super::filter::FULL;
use super::follow::Cam;
use super::{Brake, Flag, ModeWord, Motor, Register, amplifier, saturate, wrap};

/// `E` at power-up.
const ERROR_LIMIT: i32 = 1000;
/// `TH` at power-up, in °C.
const TRIP_TEMPERATURE: i32 = 70;
/// `BASE` at power-up: a turn of the encoder outside.
const CAM_BASE: i32 = 2000;

/// What a program has set and G starts with.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Buffered {
    pub acceleration: i32,
    pub velocity: i32,
    pub position: i32,
    pub distance: i32,
    /// D was set last, not P.
    pub relative: bool,
    pub mode: ModeWord,
    pub multiplier: i16,
    pub divisor: i16,
    pub base: i32,
    pub size: i32,
}

/// What a program has set and acts at once.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Settings {
    pub torque: i32,
    pub error_limit: i32,
    pub amps: i32,
    pub trip_temperature: i32,
    pub functions: i32,
    pub brake: Brake,
    /// LIMD.
    pub directional: bool,
}

impl Buffered {
    pub const POWER_UP: Buffered = Buffered {
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
    pub const POWER_UP: Settings = Settings {
        torque: 0,
        error_limit: ERROR_LIMIT,
        amps: FULL,
        trip_temperature: TRIP_TEMPERATURE,
        functions: 0,
        brake: Brake::Released,
        directional: false,
    };
}

impl Motor {
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
    pub(super) fn set_origin(&mut self, value: i32) {
        self.stream
            .renumber(value.wrapping_sub(self.reading(self.count)));
        self.origin = i64::from(value) - self.count;
        self.round = 0;
    }

    pub(super) fn set_clock(&mut self, value: i32) {
        self.clock = self.tick_register().wrapping_sub(value);
    }

    #[allow(clippy::cast_possible_truncation)] // CLK wraps at 32 bits
    fn tick_register(&self) -> i32 {
        self.ticks as i32
    }
}

fn short(value: i32) -> i16 {
    i16::try_from(value).unwrap_or(if value < 0 { i16::MIN } else { i16::MAX })
}
