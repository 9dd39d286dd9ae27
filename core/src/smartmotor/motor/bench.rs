//! The motor as the bench has it: wires, faults, mechanics, and what can be recorded.

use super::{COUNTS_PER_REVOLUTION, Drive, Flag, Motor, PERIOD, Port, amplifier};

/// The faults that [`Motor::fault`] knows.
pub const FAULTS: [&str; 6] = ["drive", "limit+", "limit-", "stall", "encoder", "estop"];

/// Fastest that a wire may say an encoder turns (rpm) or steps come (a second).
const FASTEST: f64 = 1e6;
/// A motor slower than this stands still for the bench, in rev/s.
const STANDSTILL: f64 = 0.01;

/// Injected faults that last until they are mended.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Broken {
    pub drive: bool,
    pub right_limit: bool,
    pub left_limit: bool,
    /// The shaft is seized.
    pub shaft: bool,
    pub emergency_stop: bool,
}

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
    /// The counter, `CTR`.
    pub counter: f64,
    /// Bit n is the level of pin n, UA first, as a program reads it.
    pub pins: u32,
    /// The status word.
    pub status: f64,
}

impl Motor {
    /// Names that [`Motor::wire`] knows.
    pub fn wires() -> Vec<String> {
        let pins = Port::ALL.iter().map(Port::to_string);
        let analog = Port::ALL.iter().map(|port| format!("{port}A"));
        pins.chain(analog)
            .chain(["encoder".to_owned(), "steps".to_owned()])
            .collect()
    }

    /// Sets a thing outside.
    ///
    /// * `UA` to `UG`: a switch at the pin, 0 or 1; another number is a voltage up to 5 V.
    /// * `UAA` to `UGA`: a voltage at the pin, 0 to 5 V.
    /// * `encoder`: speed in rpm of an encoder of 500 lines on UA and UB.
    /// * `steps`: steps a second on UA, the direction on UB by the sign.
    ///
    /// # Errors
    /// One line if there is no such wire, or the value does not fit.
    pub fn wire(&mut self, name: &str, value: f64) -> Result<(), String> {
        if !value.is_finite() {
            return Err(format!("wire {name}: expected a number"));
        }
        let analog = name.strip_suffix('A').and_then(Port::from_word);
        if let Some(port) = analog.or_else(|| Port::from_word(name)) {
            if !(0.0..=5.0).contains(&value) {
                return Err(format!("wire {name}: a pin takes 0 to 5 V"));
            }
            let switch = analog.is_none() && value == 1.0;
            self.pins.wire(port, if switch { 5.0 } else { value });
            return Ok(());
        }
        let speed = value.clamp(-FASTEST, FASTEST);
        match name {
            "encoder" => self.counter.turn(speed, PERIOD),
            "steps" => self.counter.step(speed, PERIOD),
            _ => {
                return Err(format!(
                    "the SmartMotor has no wire `{name}`; it has UA to UG, UAA to UGA, encoder and steps"
                ));
            }
        }
        Ok(())
    }

    /// Breaks something, or mends it: one of [`FAULTS`].
    ///
    /// `drive` is the power stage: the motor is off and stays off, Ba is set. `limit+` and `limit-` press a limit
    /// switch. `stall` seizes the shaft, which ends in Be or Ba. `encoder` stops its count, so that the motor runs away
    /// until Be. `estop` takes the power from the motor and engages the brake; the motor stays off until G (D182).
    ///
    /// # Errors
    /// One line if there is no such fault or axis.
    pub fn fault(&mut self, kind: &str, axis: Option<&str>, active: bool) -> Result<(), String> {
        check_axis(axis)?;
        match kind {
            "drive" => self.broken.drive = active,
            "limit+" => self.broken.right_limit = active,
            "limit-" => self.broken.left_limit = active,
            "stall" => {
                self.broken.shaft = active;
                self.apply_jam();
            }
            "encoder" => self.plant.encoder.set_dead(active),
            "estop" => self.broken.emergency_stop = active,
            _ => {
                return Err(format!(
                    "the SmartMotor has no fault `{kind}`; it has {}",
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

    /// Whether a trajectory is in progress, or the motor turns or is not yet where it should be. Following and waiting
    /// for a counter that stands is rest.
    pub fn is_moving(&self) -> bool {
        let turns = self.plant.velocity().abs() > STANDSTILL;
        let works = self.filter.is_winding() && self.output.abs() < self.settings.amps;
        let settles = self.error() != 0 && works && !self.braked && !self.broken.shaft;
        self.trajectory.is_under_way() || turns || settles
    }

    /// Whether the power stage is on.
    pub fn is_enabled(&self) -> bool {
        self.drive != Drive::Off
    }

    /// What keeps the motor off, in words.
    pub fn fault_words(&self) -> Option<String> {
        let words: Vec<&str> = [
            (self.broken.emergency_stop, "emergency stop"),
            (self.broken.drive, "power stage"),
            (self.is(Flag::PositionError), "position error"),
            (self.is(Flag::Overheat), "too hot"),
        ]
        .iter()
        .filter(|(is, _)| *is)
        .map(|(_, words)| *words)
        .collect();
        (self.powered && !words.is_empty()).then(|| words.join(", "))
    }

    /// What can be recorded now.
    pub fn signals(&self) -> Signals {
        let turns_to_velocity =
            PERIOD * f64::from(self.divisor) * f64::from(COUNTS_PER_REVOLUTION) * 65_536.0;
        let trajectory = &self.trajectory;
        let fraction = (trajectory.position() & 0xFFFF) as f64 / 65_536.0;
        Signals {
            demand_position: f64::from(self.reading(trajectory.count())) + fraction,
            demand_velocity: trajectory.velocity() as f64,
            demand_acceleration: trajectory.acceleration() as f64,
            position: f64::from(self.reading(self.count)),
            velocity: self.plant.velocity() * turns_to_velocity,
            following_error: self.error() as f64,
            output: f64::from(self.output),
            current: amplifier::current(self.plant.torque()),
            shaft: self.plant.position(),
            counter: self.counter.count() as f64,
            pins: u32::from(self.pins.levels()),
            status: f64::from(self.status()),
        }
    }
}

fn check_axis(axis: Option<&str>) -> Result<(), String> {
    match axis {
        None | Some("x" | "0") => Ok(()),
        Some(other) => Err(format!(
            "the SmartMotor has no axis `{other}`; its axis is x"
        )),
    }
}
