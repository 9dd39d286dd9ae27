//! Everything that makes pulses: the two indexers, their drives and motors, the inputs that interrupt them.
//!
//! Orders are plain ([`command`]) and have the time at which they are given; everything inside is timed in
//! microseconds. The firmware calls [`Indexer::sample`] every millisecond, orders in between (`orders`), and takes what
//! has happened from [`Indexer::take_event`].
//!
//! `timeline` lets time pass: from one pulse, edge or period of the drives to the next. A `clock` gives pulses, by a
//! `ramp` if it has one; a `drive` follows them; `inputs` interrupt. `bench` is what a scenario sees.

mod bench;
mod clock;
pub mod command;
mod drive;
pub mod feedrate;
mod inputs;
mod orders;
mod pair;
mod ramp;
#[cfg(test)]
mod tests;
mod timeline;

pub use bench::{AxisSignals, FAULTS};

pub use command::{Direction, Edge, Event, Interrupt, Leg, Move, Ramp, Shape};
pub use feedrate::Feedrate;
pub use pair::{Axis, Pair};

use crate::time::Nanos;
use clock::{Clock, Job};
use drive::Drive;
use inputs::{Counter, Inputs, Joystick};
use std::collections::VecDeque;
use timeline::Homing;

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
    /// JP47, JP46: width of a clock pulse in us, 1 to 4, by axis (D305).
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

/// Events that no one takes are forgotten beyond this many, the oldest first.
const MOST_EVENTS: usize = 64;

/// The two indexers with all that they drive and listen to. Times inside are in us.
#[derive(Debug, Clone)]
pub struct Indexer {
    config: Config,
    powered: bool,
    now: u64,
    clocks: Pair<Clock>,
    homing: Pair<Option<Homing>>,
    /// The axes of the last move or home: those that it waits for without corner rounding.
    ordered: Pair<bool>,
    /// Where the jobs of the clocks began.
    registers: Pair<i64>,
    drives: Pair<Drive>,
    /// The limit switches, positive and negative, as last seen.
    closed: Pair<(bool, bool)>,
    inputs: Inputs,
    /// The feedhold inputs are low.
    feedhold: Pair<bool>,
    counter: Counter,
    joystick: Joystick,
    events: VecDeque<(Nanos, Event)>,
    /// When the last pulse of a job ended, and how long holds have lasted.
    finished: u64,
    held: u64,
    /// Of the motors in the last two samples, for their acceleration.
    velocities: Pair<(f64, f64)>,
}

/// How things are.
impl Indexer {
    /// A unit that is switched off.
    pub fn new(config: Config) -> Indexer {
        Indexer {
            config,
            powered: false,
            now: 0,
            clocks: Pair::same(Clock::IDLE),
            homing: Pair::same(None),
            ordered: Pair::same(false),
            registers: Pair::same(0),
            drives: config
                .reversed
                .map(|reversed| Drive::new(config.drive, reversed)),
            closed: Pair::same((false, false)),
            inputs: Inputs::new(config.debounced),
            feedhold: Pair::same(false),
            counter: Counter::NEW,
            joystick: Joystick::NEW,
            events: VecDeque::new(),
            finished: 0,
            held: 0,
            velocities: Pair::same((0.0, 0.0)),
        }
    }

    /// The jumpers.
    pub fn config(&self) -> &Config {
        &self.config
    }

    /// The oldest event that was not taken yet, and its time.
    pub fn take_event(&mut self) -> Option<(Nanos, Event)> {
        self.events.pop_front()
    }

    /// The position register: all pulses that were given, true at every instant.
    pub fn register(&self, axis: Axis) -> i64 {
        *self.registers.of(axis) + self.clocks.of(axis).given()
    }

    /// What a tracking display shows: the encoder's position, or with a stepper the pulses that its drive let through.
    pub fn tracking(&self, axis: Axis) -> i64 {
        self.drives.of(axis).tracking()
    }

    /// Whether an axis has pulses to give: a move, a home or a slew, also while held.
    pub fn is_busy(&self, axis: Axis) -> bool {
        self.clocks.of(axis).is_busy()
    }

    /// Whether an axis is in position (LED CZ); a stepper is whenever it stands.
    pub fn in_position(&self, axis: Axis) -> bool {
        let drive = self.drives.of(axis);
        drive.in_position() && (self.config.drive == DriveKind::Dc || !self.is_busy(axis))
    }

    /// Whether moves and homes are complete: all pulses given, and without corner rounding (G24) the axes of the last
    /// one in position (D306).
    pub fn is_complete(&self, corner_rounding: bool) -> bool {
        let gives = |axis| matches!(self.clocks.of(axis).job(), Job::Move | Job::Home);
        let given = !Axis::BOTH.into_iter().any(gives) && self.now >= self.finished;
        let rests = |axis| !*self.ordered.of(axis) || self.in_position(axis);
        given && (corner_rounding || Axis::BOTH.into_iter().all(rests))
    }

    /// When the last pulse of the last move, home or slew ended.
    pub fn finished_at(&self) -> Nanos {
        Nanos::from_micros(self.finished)
    }

    /// Whether an armed input holds the pulses (and, by the firmware, the program and its dwells).
    pub fn is_held(&self) -> bool {
        self.inputs.is_holding()
    }

    /// How long armed inputs have held since power-up, to lengthen a dwell by the difference.
    pub fn held_for(&self) -> Nanos {
        Nanos::from_micros(self.held)
    }

    /// Edges that `D=` still waits for; 0 when it is done or was ended. The enable output is high meanwhile.
    pub fn counts_left(&self) -> u64 {
        self.counter.left()
    }

    /// The level of C input 1 to 4, debounced; high is true (5-6 E).
    pub fn input(&self, number: u8) -> bool {
        self.inputs.level(number)
    }

    /// All C inputs; bit n is input n + 1.
    pub fn inputs(&self) -> u8 {
        self.inputs.levels()
    }

    /// Whether the limit switch that bars this direction is closed.
    pub fn is_barred(&self, axis: Axis, direction: Direction) -> bool {
        self.powered && self.drives.of(axis).is_barred(direction)
    }

    /// The direction that a closed limit switch of an axis bars, if one is closed (LED LMT); the positive one if both
    /// are.
    pub fn limit(&self, axis: Axis) -> Option<Direction> {
        [Direction::Positive, Direction::Negative]
            .into_iter()
            .find(|&direction| self.is_barred(axis, direction))
    }

    /// Whether the motor stands on its marker, which is once a revolution (LED M).
    pub fn marker(&self, axis: Axis) -> bool {
        self.drives.of(axis).at_marker()
    }

    /// Whether the joystick gives pulses (status byte 10, bit 3).
    pub fn joystick_clock(&self) -> bool {
        self.joystick.has_clock()
    }
}
