//! X and Y: one axis alone, or both together (5-2).

use super::scan::Scan;
use super::{Acceleration, Flow, Outcome, RegisterMode, Run, Wait, World, known};
use crate::unidex3::indexer::{Axis, Feedrate, LARGEST, Leg, Move, Pair, Ramp, Shape};
use crate::unidex3::trouble::Trouble;

/// By axis, what stands behind its letter.
pub(super) type Legs = Pair<Option<i64>>;

impl Run {
    /// Reads an axis word and, if it follows with nothing but feedrates between, that of the other axis. Feedrates
    /// are noted: of the axis before them, or of the path.
    pub(super) fn legs(&mut self, scan: &mut Scan<'_>, world: &World<'_>) -> Result<Legs, Trouble> {
        let mut legs = Legs::default();
        let mut axis = None;
        loop {
            match scan.peek() {
                Some(letter @ (b'X' | b'Y')) => {
                    let next = if letter == b'X' { Axis::X } else { Axis::Y };
                    if legs.of(next).is_some() {
                        break;
                    }
                    scan.at += 1;
                    let word = if next == Axis::X { "Xn" } else { "Yn" };
                    known(word, world, Trouble::IllegalCharacter)?;
                    *legs.of_mut(next) = Some(self.distance(scan, world)?);
                    axis = Some(next);
                }
                Some(b'F') => {
                    scan.at += 1;
                    if let Some(feedrate) = self.read_feedrate(scan, world)? {
                        match axis {
                            Some(axis) if !self.modes.vector => {
                                *self.modes.feedrates.of_mut(axis) = feedrate;
                            }
                            _ => self.modes.vector_feedrate = Some(feedrate),
                        }
                    }
                }
                _ => break,
            }
        }
        Ok(legs)
    }

    /// A number, or in G48 `=` and an expression.
    fn distance(&mut self, scan: &mut Scan<'_>, world: &World<'_>) -> Result<i64, Trouble> {
        let value = match self.modes.register {
            RegisterMode::Move => {
                if !scan.eat(b'=') {
                    return Err(Trouble::IllegalCharacter);
                }
                self.expression(scan, world)?
            }
            _ => scan.signed().ok_or(Trouble::IllegalCharacter)?,
        };
        bounded(value)
    }

    /// Starts a move; registers and tracking show it pulse by pulse.
    pub(super) fn start_move(&mut self, legs: Legs, world: &mut World<'_>) -> Outcome {
        let mut steps = Legs::default();
        for axis in Axis::BOTH {
            if let Some(value) = *legs.of(axis) {
                let here = world.indexer.register(axis);
                let by = match self.modes.absolute {
                    true => value - here,
                    false => value,
                };
                bounded(here + by)?;
                *steps.of_mut(axis) = Some(by);
            }
        }
        let order = match self.modes.vector {
            true => self.vector_move(steps)?,
            false => self.independent_move(steps),
        };
        world.indexer.start(world.now, &order);
        Ok(Flow::Wait(Wait::Move))
    }

    fn independent_move(&self, steps: Legs) -> Move {
        let leg = |axis| {
            steps.of(axis).map(|steps| Leg {
                steps,
                feedrate: *self.modes.feedrates.of(axis),
            })
        };
        let parameters = &self.parameters;
        let timed = |shape| {
            let time = parameters.milliseconds(shape);
            Some(Ramp::timed(shape, time, parameters.start_stop))
        };
        let ramp = match parameters.acceleration {
            Acceleration::None => None,
            // G38 in G00 is linear, with the linear time (6-16 E).
            Acceleration::Linear | Acceleration::Vector => timed(Shape::Linear),
            Acceleration::Exponential => timed(Shape::Exponential),
        };
        Move::independent(leg(Axis::X), leg(Axis::Y), ramp)
    }

    fn vector_move(&mut self, steps: Legs) -> Result<Move, Trouble> {
        let feedrate = self.modes.vector_feedrate.ok_or(Trouble::F)?;
        let parameters = &self.parameters;
        let timed = |shape| {
            let time = parameters.milliseconds(shape);
            Some(Ramp::timed(shape, time, Feedrate::START_STOP))
        };
        let ramp = match parameters.acceleration {
            Acceleration::None => None,
            Acceleration::Vector => Some(Ramp::rated(feedrate, parameters.rate)),
            Acceleration::Linear => timed(Shape::Linear),
            Acceleration::Exponential => timed(Shape::Exponential),
        };
        let (x, y) = (steps.x.unwrap_or_default(), steps.y.unwrap_or_default());
        let parts = feedrate.components(x, y);
        for axis in Axis::BOTH {
            if let Some(part) = *parts.of(axis) {
                *self.modes.feedrates.of_mut(axis) = part;
            }
        }
        Ok(Move::vector(x, y, feedrate, ramp))
    }
}

/// Positions and registers go up to 2,000,000,000 (5-2).
pub(super) fn bounded(value: i64) -> Result<i64, Trouble> {
    match value.abs() <= LARGEST {
        true => Ok(value),
        false => Err(Trouble::IllegalCharacter),
    }
}
