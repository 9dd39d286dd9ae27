//! The feedrate of a move with acceleration: up in at most 24 steps, cruise, down in as many (6-16 A, D291).

use super::command::{Leg, RAMP_STEPS, Ramp, SHORTEST_SAMPLE_US, Shape};
use super::feedrate::STEP;

/// Denominator of [`EXPONENTIAL`].
const SCALE: u64 = 1 << 16;

/// (1 - e^(-3i/24)) / (1 - e^-3) for step i, in 1/65536 (D293).
const EXPONENTIAL: [u64; 25] = [
    0, 8104, 15256, 21568, 27138, 32053, 36391, 40219, 43597, 46579, 49210, 51532, 53581, 55389,
    56985, 58393, 59636, 60733, 61700, 62555, 63308, 63974, 64561, 65079, 65536,
];

/// A ramp at work on one axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Ramping {
    plan: Plan,
    stage: Stage,
    /// Feedrate now, in 24ths of the programmed one.
    step: u64,
    /// Until the next change, in us; [`u64::MAX`] when there is none.
    wait: u64,
}

/// What was worked out before the move.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Plan {
    shape: Shape,
    /// The programmed feedrate and the lowest one, as [`super::Feedrate::raw`].
    top: u64,
    start_stop: u64,
    sample_us: u64,
    /// Nacl: steps up, at most 24.
    highest: u64,
    /// What the 23 steps of a whole ramp give, as phase.
    length: u128,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Stage {
    Up,
    Cruise,
    Down,
}

/// Nmov: samples that a leg would last without acceleration, from its first pulse to its last.
pub(super) fn samples(leg: &Leg, ramp: &Ramp) -> u64 {
    let pulses = u128::from(leg.steps.unsigned_abs().saturating_sub(1));
    let sample = u128::from(leg.feedrate.raw()) * u128::from(ramp.sample_us.max(1));
    u64::try_from(pulses * u128::from(STEP) / sample.max(1)).unwrap_or(u64::MAX)
}

impl Ramping {
    /// The ramp of a leg that lasts `samples`; `None` where it has none because it is slower than start/stop.
    pub fn new(leg: &Leg, ramp: &Ramp, samples: u64) -> Option<Ramping> {
        let (top, start_stop) = (leg.feedrate.raw(), ramp.start_stop.raw());
        if top < start_stop {
            return None;
        }
        let whole = samples >= RAMP_STEPS;
        let mut plan = Plan {
            shape: if whole { ramp.shape } else { Shape::Linear },
            top,
            start_stop,
            sample_us: ramp.sample_us.max(SHORTEST_SAMPLE_US),
            highest: if whole {
                RAMP_STEPS
            } else {
                (samples + RAMP_STEPS) / 2
            },
            length: 0,
        };
        plan.length = (1..RAMP_STEPS)
            .map(|step| u128::from(plan.rate(step)) * u128::from(plan.sample_us))
            .sum();
        Some(Ramping {
            plan,
            stage: Stage::Up,
            step: 1,
            wait: plan.sample_us,
        })
    }

    /// The feedrate now, as [`super::Feedrate::raw`].
    pub fn rate(&self) -> u64 {
        self.plan.rate(self.step)
    }

    /// Time to the next change of the feedrate, in us.
    pub fn due(&self) -> u64 {
        self.wait
    }

    /// `elapsed` us pass, not more than [`Ramping::due`]; `left` is the phase that the move has yet to give.
    pub fn pass(&mut self, elapsed: u64, left: u128) {
        if self.wait == u64::MAX {
            return;
        }
        self.wait = self.wait.saturating_sub(elapsed);
        if self.wait == 0 {
            self.change(left);
        }
    }

    fn change(&mut self, left: u128) {
        let plan = self.plan;
        self.wait = plan.sample_us;
        match self.stage {
            Stage::Up if self.step < plan.highest => {
                self.step += 1;
                if self.step == RAMP_STEPS {
                    self.cruise(left);
                }
            }
            Stage::Up | Stage::Cruise => {
                self.stage = Stage::Down;
                self.step -= 1;
            }
            Stage::Down if self.step > 1 => self.step -= 1,
            // The last feedrate lasts until the count ends.
            Stage::Down => self.wait = u64::MAX,
        }
    }

    /// Step 24 lasts until what is left is as long as the ramp up was.
    fn cruise(&mut self, left: u128) {
        let Plan { top, length, .. } = self.plan;
        let cruising = left.saturating_sub(length).div_ceil(u128::from(top.max(1)));
        self.stage = Stage::Cruise;
        self.wait = u64::try_from(cruising).unwrap_or(u64::MAX - 1);
        if self.wait == 0 {
            self.change(left);
        }
    }
}

impl Plan {
    fn rate(&self, step: u64) -> u64 {
        let rate = match self.shape {
            Shape::Linear => self.top * step / RAMP_STEPS,
            Shape::Exponential => {
                let index = usize::try_from(step).unwrap_or(usize::MAX);
                let part = EXPONENTIAL.get(index).copied().unwrap_or(SCALE);
                // In two halves, because the product of the whole has more than 64 bits.
                self.top / SCALE * part + self.top % SCALE * part / SCALE
            }
        };
        rate.clamp(self.start_stop, self.top)
    }
}
