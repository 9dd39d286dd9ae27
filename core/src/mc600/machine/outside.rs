//! What a person does to the machine: wires, faults, mechanics.

use super::{Fault, INPUTS, Machine, SysVar, interrupts, to_register};
use crate::mc600::firmware::SAMPLE;
use crate::mc600::planner::units::saturate;
use crate::time::Nanos;

/// The faults that [`Machine::fault`] knows.
pub const FAULTS: [&str; 7] = [
    "drive", "limit+", "limit-", "stall", "encoder", "estop", "internal",
];

/// Wires besides the digital inputs.
const WIRES: [&str; 6] = [
    "encoder",
    "encoder.speed",
    "encoder.counts",
    "anin1",
    "anin2",
    "ssi",
];

/// User variables of the drive that something outside sets.
const OUTSIDE_VARIABLES: std::ops::RangeInclusive<u8> = 9..=16;

impl Machine {
    /// Names that [`Machine::wire`] knows.
    pub fn wires() -> Vec<String> {
        let inputs = (0..INPUTS).map(|number| format!("in{number}"));
        let variables = OUTSIDE_VARIABLES.map(|number| format!("dprvar{number}"));
        let others = WIRES.map(str::to_owned);
        inputs.chain(others).chain(variables).collect()
    }

    /// Sets something outside, at the end of the last sample; see [`Machine::wire_at`].
    ///
    /// # Errors
    /// One line if there is no such wire, or the value is not a number.
    pub fn wire(&mut self, name: &str, value: f64) -> Result<(), String> {
        self.wire_at(name, value, SAMPLE)
    }

    /// Sets something outside, so long after the last sample has begun: the digital inputs `in0` to `in12`, on unless
    /// `value` is 0; the shaft of the master's `encoder` in rpm, or its `encoder.speed` in counts*256/sample;
    /// `encoder.counts` turns it on by counts at once; the analog inputs `anin1` and `anin2` in V; the absolute encoder
    /// `ssi` in counts; the drive's user variables `dprvar9` to `dprvar16`.
    ///
    /// # Errors
    /// One line if there is no such wire, or the value is not a number.
    pub fn wire_at(&mut self, name: &str, value: f64, since: Nanos) -> Result<(), String> {
        let known = Machine::wires().iter().any(|wire| wire == name);
        if known && !value.is_finite() {
            return Err(format!("wire {name}: expected a number"));
        }
        let encoder = &mut self.planner.master.encoder;
        let whole = saturate(to_register(value));
        match name {
            "encoder" => encoder.turn(value),
            "encoder.speed" => encoder.turn_by_counts(value),
            "encoder.counts" => encoder.jog(value),
            "anin1" => self.analog.inputs[0] = millivolts(value),
            "anin2" => self.analog.inputs[1] = millivolts(value),
            "ssi" => self.absolute = whole,
            _ => {
                let number = |prefix: &str| name.strip_prefix(prefix)?.parse::<u8>().ok();
                match (known, number("in"), number("dprvar")) {
                    (true, Some(input), _) => self.set_input(input, value != 0.0, since),
                    (true, _, Some(variable)) => self.drive.objects.set_user(variable, whole),
                    _ => {
                        return Err(format!(
                            "the MC-600 has no wire `{name}`; it has in0 to in12, {} and dprvar9 to dprvar16",
                            WIRES.join(", ")
                        ));
                    }
                }
            }
        }
        Ok(())
    }

    /// An input changes; captures and the gear act by its edge.
    fn set_input(&mut self, number: u8, on: bool, since: Nanos) {
        let was = self.inputs.get(number);
        self.inputs.set(number, on);
        if !self.powered || was == on {
            return;
        }
        let passed = SAMPLE.since(since.min(SAMPLE));
        let (seconds, part) = (passed.0 as f64 * 1e-9, passed.0 as f64 / SAMPLE.0 as f64);
        match number {
            2 | 3 => {
                self.capture(usize::from(number - 2), on, seconds);
                if number == 3 && self.drive.is_enabled() {
                    self.planner.gear_edge(on, part);
                }
            }
            8 | 9 => {
                let position = self.feedback_ago(seconds);
                let position = self.planner.reading(position);
                self.latches.take(usize::from(number - 8), on, position);
            }
            _ => {}
        }
    }

    /// `msetincap`: an edge of input 2 (0) or 3 (1).
    fn capture(&mut self, input: usize, rising: bool, passed: f64) {
        let Some(capture) = self.captures.get(input).copied() else {
            return;
        };
        if !capture.takes(rising) {
            return;
        }
        let age = capture.age(passed);
        let position = match (input, self.capture_source) {
            (0, _) => self.planner.reading(self.feedback_ago(age)),
            (_, 0 | 1) => self.planner.master.reading(self.master_ago(age)),
            _ => self.planner.reading(self.reference_ago(age)),
        };
        if let Some(capture) = self.captures.get_mut(input) {
            capture.position = position;
        }
        self.captured |= interrupts::bit(interrupts::CAPTURES) << input;
    }

    /// The actual position some seconds ago, on a straight line through the last sample.
    fn feedback_ago(&self, seconds: f64) -> i64 {
        let now = self.feedback();
        ago(now, now.wrapping_sub(self.feedback_before), seconds)
    }

    fn master_ago(&self, seconds: f64) -> i64 {
        let master = &self.planner.master;
        ago(master.position(), master.velocity(), seconds)
    }

    fn reference_ago(&self, seconds: f64) -> i64 {
        let reference = self.planner.reference();
        ago(reference.position, reference.velocity, seconds)
    }

    /// Breaks something, or mends it: one of [`FAULTS`].
    ///
    /// `drive` and `encoder` trip the drive until `mclrfault` is given after they are mended, and so does `internal` with
    /// the number of a fault, 1 to 32, in the place of the axis. `limit+` and `limit-` press a limit switch: motion in
    /// that direction is stopped, the other is free, `gv_status%` bit 7 warns. `stall` seizes the shaft, which trips the
    /// drive by its following error. `estop` stops the axis and disables the drive.
    ///
    /// # Errors
    /// One line if there is no such fault or axis.
    pub fn fault(&mut self, kind: &str, axis: Option<&str>, active: bool) -> Result<(), String> {
        if kind == "internal" {
            let number = axis.and_then(|number| Fault::from_number(number.parse().ok()?));
            let fault = number.ok_or("fault internal: expected a number from 1 to 32")?;
            self.broken.internal &= !fault.bit();
            self.broken.internal |= if active { fault.bit() } else { 0 };
            return Ok(());
        }
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

    /// Sets a report of the drive's inputs for its own variables.
    pub(super) fn input_word(&self, number: u8) -> i32 {
        i32::from(number < INPUTS && self.inputs.get(number))
    }

    /// `gv_capsel%`, as far as it names a source.
    pub(super) fn select_capture(&mut self, source: i32) {
        if (0..=2).contains(&source) {
            self.capture_source = source;
        }
    }

    /// The position captured last by input 2 (0) or 3 (1).
    pub(super) fn captured_position(&self, input: usize) -> i32 {
        self.captures
            .get(input)
            .map_or(0, |capture| capture.position)
    }

    /// A latch of the drive, in the order of [`SysVar::GvLatch1`] and the others.
    pub(super) fn latch(&self, var: SysVar) -> i32 {
        let [first, first_falling, second, second_falling] = self.latches.positions;
        match var {
            SysVar::GvLatch1 => first,
            SysVar::GvLatch1n => first_falling,
            SysVar::GvLatch2 => second,
            _ => second_falling,
        }
    }
}

/// Where something stood that moves by `velocity` a sample, in 1/256 count.
fn ago(position: i64, velocity: i64, seconds: f64) -> i64 {
    let samples = seconds / (SAMPLE.0 as f64 * 1e-9);
    position.wrapping_sub(to_register((velocity as f64 * samples).round()))
}

/// At the drive's analog inputs, which read up to 10 V either way.
fn millivolts(volts: f64) -> i32 {
    saturate(to_register((volts * 1000.0).round())).clamp(-10_000, 10_000)
}

fn check_axis(axis: Option<&str>) -> Result<(), String> {
    match axis {
        None | Some("x" | "0") => Ok(()),
        Some(other) => Err(format!("the MC-600 has no axis `{other}`; its axis is x")),
    }
}
