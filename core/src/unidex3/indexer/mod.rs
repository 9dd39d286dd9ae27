//! Everything that makes pulses: the two indexers, their drives and motors, the inputs that interrupt them.
//!
//! Orders are plain ([`command`]) and have the time at which they are given; everything inside is timed in
//! microseconds. The firmware calls [`Indexer::sample`] every millisecond, orders in between, and takes what has
//! happened from [`Indexer::take_event`].

pub mod command;
pub mod feedrate;

pub use command::{Axis, Direction, Edge, Event, Interrupt, Leg, Move, Pair, Ramp, Shape};
pub use feedrate::Feedrate;

use crate::time::Nanos;

/// Registers and moves go up to this magnitude (5-2); whoever orders a move answers for it.
pub const LARGEST: i64 = 2_000_000_000;

/// The jumpers of tables 2-2 and 2-3 that concern motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Config {
    /// What is behind the clock outputs.
    pub drive: DriveKind,
    /// How an axis finds its home.
    pub home: HomeKind,
    /// JP5, JP7 out: direction N, by axis.
    pub reversed: Pair<bool>,
    /// JP47, JP46: width of a clock pulse in us, 1 to 4, by axis.
    pub clock_width_us: Pair<u8>,
    /// JP20 to JP23 at 1-2: C1 to C4 are debounced.
    pub debounced: [bool; 4],
}

/// What is behind the clock outputs (table 2-2).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DriveKind {
    /// A servo with encoder: it lags, and has an in-position signal.
    Dc,
    /// A low speed stepper.
    StepperLow,
    /// A high speed stepper.
    StepperHigh,
}

/// How an axis finds its home (table 2-2, 5-6 B).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum HomeKind {
    /// The drive does: home switch, then marker.
    Hardware,
    /// The indexer does, in these directions by axis, at the feedrates of G60= and G61=; low speed steppers only.
    Software(Pair<Direction>),
}

impl Default for Config {
    fn default() -> Config {
        Config {
            drive: DriveKind::Dc,
            home: HomeKind::Hardware,
            reversed: Pair::same(false),
            clock_width_us: Pair::same(1),
            debounced: [true; 4],
        }
    }
}

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

/// The two indexers with all that they drive and listen to.
#[derive(Debug, Clone)]
pub struct Indexer {
    config: Config,
    register: Pair<i64>,
}

/// Orders. Each has the time at which it is given, not before the last sample.
impl Indexer {
    /// A unit that is switched off.
    pub fn new(config: Config) -> Indexer {
        Indexer {
            config,
            register: Pair::same(0),
        }
    }

    /// Mains on: drives reset, registers and tracking displays 0, nothing armed.
    pub fn power_up(&mut self, at: Nanos) {
        let _ = at;
    }

    /// Mains off: pulses stop and motors coast. What is wired or broken stays.
    pub fn power_off(&mut self, at: Nanos) {
        let _ = at;
    }

    /// RES, G99, clear device: as at power-up.
    pub fn reset(&mut self, at: Nanos) {
        self.power_up(at);
    }

    /// All of the time up to `now`; call it every millisecond, also while switched off.
    pub fn sample(&mut self, now: Nanos) {
        let _ = now;
    }

    /// Begins a move. Whatever an axis of it was doing is ended first.
    pub fn start(&mut self, at: Nanos, order: &Move) {
        let _ = (at, order);
    }

    /// G7, G60, G61: sends the named axes home at these feedrates (hardware home has its own). The registers of an
    /// axis that has found it are 0.
    pub fn home(&mut self, at: Nanos, feedrates: Pair<Option<Feedrate>>) {
        let _ = (at, feedrates);
    }

    /// An arrow key goes down in slew mode: pulses until [`Indexer::stop_axis`].
    pub fn slew(&mut self, at: Nanos, axis: Axis, direction: Direction, feedrate: Feedrate) {
        let _ = (at, axis, direction, feedrate);
    }

    /// An arrow key goes down in step mode: one pulse, at once.
    pub fn step(&mut self, at: Nanos, axis: Axis, direction: Direction) {
        let _ = (at, axis, direction);
    }

    /// Slew mode with the joystick: its clocks divided by `divisor` (2 to 65535); `None` switches it off. A slew by
    /// key overrides it; a limit disables it until one of its directions changes.
    pub fn joystick(&mut self, at: Nanos, divisor: Option<u32>) {
        let _ = (at, divisor);
    }

    /// Ends what an axis does; its register is true.
    pub fn stop_axis(&mut self, at: Nanos, axis: Axis) {
        let _ = (at, axis);
    }

    /// Ends all moves, homes, slews and counts, and the joystick; registers are true.
    pub fn stop(&mut self, at: Nanos) {
        let _ = at;
    }

    /// G20n to G41n: arms input 1 to 4; what was armed on it before is void.
    pub fn arm(&mut self, at: Nanos, input: u8, interrupt: Interrupt, edge: Edge) {
        let _ = (at, input, interrupt, edge);
    }

    /// G321 to G325: disarms input 1 to 4; a hold by it is released.
    pub fn disarm(&mut self, at: Nanos, input: u8) {
        let _ = (at, input);
    }

    /// `D=`: begins to count falling edges of the external clock; see [`Indexer::counts_left`].
    pub fn count(&mut self, at: Nanos, edges: u64) {
        let _ = (at, edges);
    }

    /// G10 to G12: the reset pulse to a drive. It takes its fault and its following error away; registers stay.
    pub fn reset_drive(&mut self, at: Nanos, axis: Axis) {
        let _ = (at, axis);
    }

    /// G92: loads a register.
    pub fn preload(&mut self, at: Nanos, axis: Axis, value: i64) {
        let _ = at;
        *self.register.of_mut(axis) = value;
    }

    /// The clear button of a tracking display.
    pub fn clear_tracking(&mut self, at: Nanos, axis: Axis) {
        let _ = (at, axis);
    }

    /// Changes jumpers; the kinds of drive and home as at the next power-up.
    pub fn configure_unit(&mut self, at: Nanos, config: Config) {
        let _ = at;
        self.config = config;
    }
}

/// How things are.
impl Indexer {
    /// The jumpers.
    pub fn config(&self) -> &Config {
        &self.config
    }

    /// The oldest event that was not taken yet, and its time.
    pub fn take_event(&mut self) -> Option<(Nanos, Event)> {
        None
    }

    /// The position register; true at every instant.
    pub fn register(&self, axis: Axis) -> i64 {
        *self.register.of(axis)
    }

    /// What a tracking display shows: the encoder's position, or with a stepper the pulses that its drive let through.
    pub fn tracking(&self, axis: Axis) -> i64 {
        *self.register.of(axis)
    }

    /// Whether an axis has pulses to give: a move, a home or a slew, also while held.
    pub fn is_busy(&self, axis: Axis) -> bool {
        let _ = axis;
        false
    }

    /// Whether an axis is in position (LED CZ); a stepper is whenever it stands.
    pub fn in_position(&self, axis: Axis) -> bool {
        let _ = axis;
        true
    }

    /// Whether moves and homes are complete: all pulses given, and without corner rounding (G24) both axes in position.
    pub fn is_complete(&self, corner_rounding: bool) -> bool {
        let _ = corner_rounding;
        true
    }

    /// When the last pulse of the last move, home or slew ended.
    pub fn finished_at(&self) -> Nanos {
        Nanos::ZERO
    }

    /// Whether a feedhold stops pulses (and, by the firmware, the program and its dwells).
    pub fn is_held(&self) -> bool {
        false
    }

    /// How long feedholds have lasted since power-up, to lengthen a dwell by the difference.
    pub fn held_for(&self) -> Nanos {
        Nanos::ZERO
    }

    /// Edges that `D=` still waits for; 0 when it is done or was ended.
    pub fn counts_left(&self) -> u64 {
        0
    }

    /// The level of C input 1 to 4, debounced; high is true (5-6 E).
    pub fn input(&self, number: u8) -> bool {
        let _ = number;
        true
    }

    /// The limit switches that are closed now (LED LMT), by the direction that they bar.
    pub fn limit(&self, axis: Axis) -> Option<Direction> {
        let _ = axis;
        None
    }

    /// Whether the encoder stands on its marker (LED M).
    pub fn marker(&self, axis: Axis) -> bool {
        let _ = axis;
        false
    }

    /// Whether the joystick's clock gives pulses (status byte 10, bit 3).
    pub fn joystick_clock(&self) -> bool {
        false
    }

    /// Whether pulses are given, a drive has yet to follow them, or a motor turns.
    pub fn is_moving(&self) -> bool {
        false
    }

    /// Whether the drives hold their motors.
    pub fn is_enabled(&self) -> bool {
        true
    }

    /// What has tripped the drives, in words.
    pub fn fault_words(&self) -> Option<String> {
        None
    }

    /// What can be recorded of an axis now.
    pub fn signals(&self, axis: Axis) -> AxisSignals {
        let _ = axis;
        AxisSignals::default()
    }
}

/// The faults that [`Indexer::fault`] knows.
pub const FAULTS: [&str; 6] = ["drive", "limit+", "limit-", "stall", "encoder", "estop"];

/// What is around the unit on the bench.
impl Indexer {
    /// Names that [`Indexer::wire`] knows.
    pub fn wires() -> Vec<String> {
        Vec::new()
    }

    /// Sets a thing outside.
    ///
    /// # Errors
    /// One line if there is no such wire, or the value does not fit.
    pub fn wire(&mut self, at: Nanos, name: &str, value: f64) -> Result<(), String> {
        let _ = (at, value);
        Err(format!("no wire {name}"))
    }

    /// Breaks something, or mends it: one of [`FAULTS`]; without an axis on both.
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
        let _ = (at, axis, active);
        Err(format!("no fault {kind}"))
    }

    /// Changes the mechanics behind an axis; see [`crate::plant::configure::KEYS`].
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
        let _ = (at, axis, key);
        Err(value.to_owned())
    }
}
