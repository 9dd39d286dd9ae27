//! One clock output: gives pulses at a rate, and counts them down.

use super::command::{Direction, Leg, Ramp};
use super::feedrate::{Feedrate, STEP};
use super::ramp::Ramping;

/// What a clock output does.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Job {
    /// Nothing.
    Idle,
    /// A move; or a step.
    Move,
    /// Goes home.
    Home,
    /// Slews while an arrow key is down.
    Slew,
    /// Slews by the joystick.
    Joystick,
}

/// More pulses than there is time for.
const ENDLESS: u64 = u64::MAX;

/// One clock output. Time is in us; the phase of the step in progress is in parts of [`STEP`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Clock {
    job: Job,
    direction: Direction,
    /// Pulses to give, [`ENDLESS`] in home and slew, and those that are left of them.
    total: u64,
    left: u64,
    /// As [`Feedrate::raw`]; 0 stands still.
    rate: u64,
    phase: u64,
    ramp: Option<Ramping>,
}

impl Clock {
    /// Gives no pulses.
    pub const IDLE: Clock = Clock {
        job: Job::Idle,
        direction: Direction::Positive,
        total: 0,
        left: 0,
        rate: 0,
        phase: 0,
        ramp: None,
    };

    /// A leg of a move; `samples` is Nmov for the ramp.
    pub fn of_leg(leg: &Leg, ramp: Option<&Ramp>, samples: u64) -> Clock {
        if leg.steps == 0 {
            return Clock::IDLE;
        }
        let ramp = ramp.and_then(|ramp| Ramping::new(leg, ramp, samples));
        Clock {
            job: Job::Move,
            direction: Direction::of(leg.steps),
            total: leg.steps.unsigned_abs(),
            left: leg.steps.unsigned_abs(),
            rate: ramp.map_or(leg.feedrate.raw(), |ramp| ramp.rate()),
            phase: 0,
            ramp,
        }
    }

    /// A single pulse, with the next [`Clock::pass`] of a microsecond.
    pub fn single(direction: Direction) -> Clock {
        Clock {
            job: Job::Move,
            direction,
            total: 1,
            left: 1,
            rate: STEP,
            ..Clock::IDLE
        }
    }

    /// Pulses without end.
    pub fn endless(job: Job, direction: Direction, feedrate: Feedrate) -> Clock {
        Clock::at_rate(job, direction, feedrate.raw())
    }

    /// The same at a rate in 2^-35 steps/s.
    pub fn at_rate(job: Job, direction: Direction, rate: u64) -> Clock {
        Clock {
            job,
            direction,
            rate,
            total: ENDLESS,
            left: ENDLESS,
            ..Clock::IDLE
        }
    }

    /// The joystick's rate, as [`Feedrate::raw`]; the step in progress goes on while the direction stays.
    pub fn with_joystick(self, direction: Direction, rate: u64) -> Clock {
        let goes_on = self.job == Job::Joystick && self.direction == direction;
        Clock {
            phase: if goes_on { self.phase } else { 0 },
            ..Clock::at_rate(Job::Joystick, direction, rate)
        }
    }

    /// What it does.
    pub fn job(&self) -> Job {
        self.job
    }

    /// Which way its pulses count.
    pub fn direction(&self) -> Direction {
        self.direction
    }

    /// What its down-counter says of the pulses given, signed. Another job begins at 0.
    pub fn given(&self) -> i64 {
        let given = i64::try_from(self.total - self.left).unwrap_or(i64::MAX);
        given * self.direction.sign()
    }

    /// In 2^-35 steps/s, 0 when it stands.
    pub fn rate(&self) -> u64 {
        self.rate
    }

    /// Whether it has pulses to give; a joystick at rest has none.
    pub fn is_busy(&self) -> bool {
        match self.job {
            Job::Idle => false,
            Job::Joystick => self.rate != 0,
            Job::Move | Job::Home | Job::Slew => true,
        }
    }

    /// Time to its next pulse or change of rate.
    #[inline]
    pub fn due(&self) -> u64 {
        if self.rate == 0 {
            return u64::MAX;
        }
        let pulse = (STEP - self.phase).div_ceil(self.rate);
        self.ramp.map_or(pulse, |ramp| pulse.min(ramp.due()))
    }

    /// `elapsed` us pass, not more than [`Clock::due`]. Whether that gives a pulse; the last one makes it idle.
    #[inline]
    pub fn pass(&mut self, elapsed: u64) -> bool {
        if self.rate == 0 {
            return false;
        }
        self.phase += self.rate * elapsed;
        let pulse = self.phase >= STEP;
        if pulse {
            self.phase -= STEP;
            self.left = self.left.saturating_sub(1);
            if self.left == 0 {
                (self.job, self.rate, self.ramp) = (Job::Idle, 0, None);
                return true;
            }
        }
        if let Some(ramp) = &mut self.ramp {
            let whole = u128::from(self.left) * u128::from(STEP);
            ramp.pass(elapsed, whole.saturating_sub(u128::from(self.phase)));
            self.rate = ramp.rate();
        }
        pulse
    }
}
