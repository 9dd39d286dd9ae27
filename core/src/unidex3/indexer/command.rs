//! What a program or a key orders of the indexers.

use super::feedrate::Feedrate;
use super::pair::{Axis, Pair};

/// Which way steps count.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Direction {
    /// Clockwise: the register grows.
    Positive,
    /// Counter-clockwise: the register shrinks.
    Negative,
}

impl Direction {
    /// Of a signed number of steps; 0 is positive.
    pub fn of(steps: i64) -> Direction {
        if steps < 0 {
            Direction::Negative
        } else {
            Direction::Positive
        }
    }

    /// The other way.
    pub fn opposite(self) -> Direction {
        match self {
            Direction::Positive => Direction::Negative,
            Direction::Negative => Direction::Positive,
        }
    }

    /// 1 or -1.
    pub fn sign(self) -> i64 {
        match self {
            Direction::Positive => 1,
            Direction::Negative => -1,
        }
    }
}

/// The part of a move on one axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Leg {
    /// Signed number of steps; 0 is done at once.
    pub steps: i64,
    /// How fast.
    pub feedrate: Feedrate,
}

/// A move of one axis, or of both at the same time.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Move {
    /// By axis.
    pub legs: Pair<Option<Leg>>,
    /// Acceleration and deceleration; `None` after G36.
    pub ramp: Option<Ramp>,
    /// Both axes keep the same number of ramp steps, so that the path is straight.
    pub vector: bool,
}

impl Move {
    /// G00: each axis at its own feedrate.
    pub fn independent(x: Option<Leg>, y: Option<Leg>, ramp: Option<Ramp>) -> Move {
        Move {
            legs: Pair { x, y },
            ramp,
            vector: false,
        }
    }

    /// G01: along a straight line, `feedrate` being that of the path. The start/stop frequency is the default one.
    pub fn vector(x: i64, y: i64, feedrate: Feedrate, ramp: Option<Ramp>) -> Move {
        let feedrates = feedrate.components(x, y);
        let leg =
            |steps, feedrate: Option<Feedrate>| feedrate.map(|feedrate| Leg { steps, feedrate });
        Move {
            legs: Pair {
                x: leg(x, feedrates.x),
                y: leg(y, feedrates.y),
            },
            ramp: ramp.map(|ramp| Ramp {
                start_stop: Feedrate::START_STOP,
                ..ramp
            }),
            vector: true,
        }
    }
}

/// How the feedrate grows and falls; not in home, slew and step (6-16).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Ramp {
    /// Along which curve.
    pub shape: Shape,
    /// Between two of the at most 24 feedrates, in us; not below 1000.
    pub sample_us: u64,
    /// The lowest feedrate of the ramp; a move that is programmed slower has no ramp.
    pub start_stop: Feedrate,
}

/// The curve of a [`Ramp`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Shape {
    /// G37, and G38.
    Linear,
    /// G39; a move too short for the whole ramp is linear.
    Exponential,
}

/// Feedrates of a whole ramp.
pub(super) const RAMP_STEPS: u64 = 24;
/// The shortest time between two of them, in us.
pub(super) const SHORTEST_SAMPLE_US: u64 = 1000;

impl Ramp {
    /// `G37=` and `G39=`: to the whole feedrate in `milliseconds`, 23 to 4,000,000 (power-up: 184).
    pub fn timed(shape: Shape, milliseconds: u32, start_stop: Feedrate) -> Ramp {
        let sample_us = u64::from(milliseconds) * 1000 / (RAMP_STEPS - 1);
        Ramp {
            shape,
            sample_us: sample_us.max(SHORTEST_SAMPLE_US),
            start_stop,
        }
    }

    /// G38 in G01: `G38=` 50 to 5,000,000 steps/s² (power-up: 250) for a vector feedrate. In G00 it is
    /// [`Ramp::timed`] with the linear time.
    pub fn rated(feedrate: Feedrate, steps_per_second_squared: u32) -> Ramp {
        // Phase in a microsecond per step/s is feedrate x 1e6 / 2^35: the same quotient as a time in us.
        let scale = u128::from(steps_per_second_squared.max(1)) << super::feedrate::FRACTION_BITS;
        let time = u128::from(feedrate.raw()) * 1_000_000 / scale;
        let sample_us = u64::try_from(time).unwrap_or(u64::MAX) / (RAMP_STEPS - 1);
        Ramp {
            shape: Shape::Linear,
            sample_us: sample_us.max(SHORTEST_SAMPLE_US),
            start_stop: Feedrate::START_STOP,
        }
    }
}

/// What an armed C input does when its edge comes (6-6 to 6-8).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Interrupt {
    /// G20n, G21n: pulses stop until the opposite edge.
    Feedhold,
    /// G30n, G31n: the move ends where it is.
    Abort,
    /// G40n, G41n: the unit is reset.
    Reset,
}

/// Which edge of a C input.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Edge {
    /// High to low.
    Falling,
    /// Low to high.
    Rising,
}

/// What the indexers tell of themselves, once, in the order it happened.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Event {
    /// A limit switch closed: both indexers have stopped and the registers are true (4-10).
    Limit(Axis),
    /// An armed input, 1 to 4, has ended what was under way.
    Abort(u8),
    /// An armed input, 1 to 4, asks for a reset; the pulses have stopped.
    Reset(u8),
    /// The joystick's button was pressed.
    JoystickButton,
}
