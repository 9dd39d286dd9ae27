//! The unit as the bench has it: wires, faults, mechanics, and what can be recorded.

use super::clock::Job;
use super::command::{Direction, Event};
use super::feedrate::FRACTION_BITS;
use super::inputs::{FASTEST_CLOCK, FASTEST_JOYSTICK};
use super::pair::Axis;
use super::{DriveKind, Indexer};
use crate::time::Nanos;

/// The faults that [`Indexer::fault`] knows.
pub const FAULTS: [&str; 6] = ["drive", "limit+", "limit-", "stall", "encoder", "estop"];

/// Names that [`Indexer::wire`] knows.
const WIRES: [&str; 17] = [
    "C1",
    "C2",
    "C3",
    "C4",
    "clock",
    "clockrate",
    "joyx",
    "joyy",
    "joybutton",
    "feedholdx",
    "feedholdy",
    "homex",
    "homey",
    "limitx+",
    "limitx-",
    "limity+",
    "limity-",
];

/// What can be recorded of an axis after a sample, in steps, steps/s and steps/s².
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct AxisSignals {
    /// The position register.
    pub register: f64,
    /// The tracking display: the actual position.
    pub position: f64,
    /// Of the clock output.
    pub rate: f64,
    /// Of the motor.
    pub velocity: f64,
    /// Of the motor, over the last sample.
    pub acceleration: f64,
    /// Pulses that the drive has yet to follow.
    pub error: f64,
    /// Torque as a fraction of the peak; 0 for a stepper.
    pub output: f64,
    /// Of the motor itself, in revolutions since it was built.
    pub shaft: f64,
    /// Pulses that an independent counter at the clock output has counted since power-up, signed.
    pub clocked: f64,
}

impl Indexer {
    /// Names that [`Indexer::wire`] knows.
    pub fn wires() -> Vec<String> {
        WIRES.map(str::to_owned).to_vec()
    }

    /// Sets a thing outside.
    ///
    /// * `C1` to `C4`: the level of a C input, 1 (as when nothing is wired) or 0.
    /// * `clock`: the level of the external clock, 1 or 0; `clockrate`: a steady one, 0 to 500,000 Hz.
    /// * `joyx`, `joyy`: the joystick's clocks, to 300,000 Hz, negative in the negative direction; `joybutton` 1 pressed.
    /// * `feedholdx`, `feedholdy`: the feedhold inputs (D298); 0 stops the clock output of the axis, 1 (nothing wired) lets it.
    /// * `homex`, `homey`: 1 presses the home switch wherever the axis is.
    /// * `limitx+` to `limity-`: 1 presses the limit switch wherever the axis is, as the fault of that name does (D351).
    ///
    /// # Errors
    /// One line if there is no such wire, or the value does not fit.
    pub fn wire(&mut self, at: Nanos, name: &str, value: f64) -> Result<(), String> {
        if !WIRES.contains(&name) {
            let known = WIRES.join(", ");
            return Err(format!(
                "the Unidex III has no wire `{name}`; it has {known}"
            ));
        }
        let (least, most) = match name {
            "joyx" | "joyy" => (-FASTEST_JOYSTICK, FASTEST_JOYSTICK),
            "clockrate" => (0.0, FASTEST_CLOCK),
            _ => (0.0, 1.0),
        };
        if !(least..=most).contains(&value) {
            return Err(format!("wire {name}: expected {least} to {most}"));
        }
        self.advance(at);
        let on = value >= 0.5;
        match name {
            "C1" => self.inputs.wire(1, on),
            "C2" => self.inputs.wire(2, on),
            "C3" => self.inputs.wire(3, on),
            "C4" => self.inputs.wire(4, on),
            "clock" => self.counter.wire(on),
            "clockrate" => self.counter.run_at(value),
            "joyx" => self.wire_joystick(Axis::X, value),
            "joyy" => self.wire_joystick(Axis::Y, value),
            "joybutton" => self.wire_button(on),
            "feedholdx" => self.feedhold.x = !on,
            "feedholdy" => self.feedhold.y = !on,
            "homex" => self.drives.x.broken.home = on,
            "homey" => self.drives.y.broken.home = on,
            "limitx+" => self.drives.x.broken.positive_limit = on,
            "limitx-" => self.drives.x.broken.negative_limit = on,
            "limity+" => self.drives.y.broken.positive_limit = on,
            "limity-" => self.drives.y.broken.negative_limit = on,
            _ => {}
        }
        self.settle_inputs();
        self.look_at_switches();
        Ok(())
    }

    fn wire_joystick(&mut self, axis: Axis, pulses_per_second: f64) {
        self.joystick.wire(axis, pulses_per_second);
        self.follow_joystick();
    }

    fn wire_button(&mut self, down: bool) {
        if down && !self.joystick.button && self.powered {
            self.tell(Event::JoystickButton);
        }
        self.joystick.button = down;
    }

    /// Breaks something, or mends it: one of [`FAULTS`]; without an axis on both.
    ///
    /// `drive` and `estop` leave a motor without torque; a servo is tripped until its drive is reset. `limit+` and
    /// `limit-` close a limit switch. `stall` seizes the shaft; a stepper loses the steps, a servo trips once its
    /// following error is too large. `encoder` stops its count, so that a servo runs away until it trips.
    ///
    /// # Errors
    /// One line if there is no such fault or axis.
    pub fn fault(
        &mut self,
        at: Nanos,
        kind: &str,
        axis: Option<&str>,
        active: bool,
    ) -> Result<(), String> {
        if !FAULTS.contains(&kind) {
            let known = FAULTS.join(", ");
            return Err(format!(
                "the Unidex III's axes have no fault `{kind}`; they have {known}"
            ));
        }
        let only = axis.map(find_axis).transpose()?;
        self.advance(at);
        for axis in Axis::BOTH {
            if only.is_some_and(|only| only != axis) {
                continue;
            }
            let drive = self.drives.of_mut(axis);
            match kind {
                "drive" => drive.broken.drive = active,
                "limit+" => drive.broken.positive_limit = active,
                "limit-" => drive.broken.negative_limit = active,
                "stall" => drive.set_jammed(active),
                "encoder" => drive.plant.encoder.set_dead(active),
                _ => drive.broken.emergency_stop = active,
            }
        }
        self.look_at_switches();
        Ok(())
    }

    /// Changes the mechanics behind an axis; see [`crate::plant::configure::KEYS`]. Positions are in steps.
    ///
    /// # Errors
    /// One line if there is no such axis or key, or the value does not fit.
    pub fn configure(
        &mut self,
        at: Nanos,
        axis: &str,
        key: &str,
        value: &str,
    ) -> Result<(), String> {
        let axis = find_axis(axis)?;
        self.advance(at);
        self.drives.of_mut(axis).plant.configure(key, value)?;
        self.look_at_switches();
        Ok(())
    }

    /// Whether pulses are given, a drive has yet to follow them, or a motor turns. What is held by an input, or goes
    /// home for ever, moves; a joystick at rest does not.
    pub fn is_moving(&self) -> bool {
        Axis::BOTH
            .into_iter()
            .any(|axis| self.is_busy(axis) || self.drives.of(axis).is_moving())
    }

    /// Whether the drives hold their motors.
    pub fn is_enabled(&self) -> bool {
        self.drives.x.is_enabled() && self.drives.y.is_enabled()
    }

    /// What has tripped the drives, in words.
    pub fn fault_words(&self) -> Option<String> {
        let of = |name: &str, axis: Axis| {
            let words = self.drives.of(axis).fault()?;
            Some(format!("{name}: {words}"))
        };
        let words = [of("X", Axis::X), of("Y", Axis::Y)];
        let words: Vec<String> = words.into_iter().flatten().collect();
        (!words.is_empty()).then(|| words.join(", "))
    }

    /// What can be recorded of an axis now.
    pub fn signals(&self, axis: Axis) -> AxisSignals {
        let drive = self.drives.of(axis);
        let (velocity, before) = *self.velocities.of(axis);
        AxisSignals {
            register: self.register(axis) as f64,
            position: self.tracking(axis) as f64,
            rate: self.rate(axis),
            velocity: self.velocity(axis),
            acceleration: (velocity - before) * 1000.0,
            error: drive.error(),
            output: drive.output(),
            shaft: drive.plant.position(),
            clocked: drive.clocked() as f64,
        }
    }

    /// Of a clock output, in steps/s with the sign of the direction; 0 while held.
    fn rate(&self, axis: Axis) -> f64 {
        let clock = self.clocks.of(axis);
        if clock.job() == Job::Idle || self.is_held() || *self.feedhold.of(axis) {
            return 0.0;
        }
        let rate = clock.rate() as f64 / (1u64 << FRACTION_BITS) as f64;
        match clock.direction() {
            Direction::Positive => rate,
            Direction::Negative => -rate,
        }
    }

    /// Of a motor, in steps/s as they count. A stepper has that of the pulses that reach it.
    pub(super) fn velocity(&self, axis: Axis) -> f64 {
        let drive = self.drives.of(axis);
        let follows = self.config.drive != DriveKind::Dc && drive.is_enabled();
        if !follows {
            return drive.velocity();
        }
        if drive.is_barred(self.clocks.of(axis).direction()) {
            return 0.0;
        }
        self.rate(axis)
    }
}

fn find_axis(name: &str) -> Result<Axis, String> {
    Axis::from_name(name)
        .ok_or_else(|| format!("the Unidex III has no axis `{name}`; its axes are x and y"))
}
