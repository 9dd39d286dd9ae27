//! Targets: point-to-point and merging moves, and the generator of the virtual axis and of the phase.
//!
//! Source: "Mmove(pos)", "Mimove(ipos)", "Mmerge(pos)", "Mimerge(ipos)", "Mvirtualax(pos)", "Mphase(pos)".

use super::units::{FRACTION, Modulus, counts, wrap32};
use super::{POWER_UP_ACCELERATION, POWER_UP_SPEED};
use crate::motion::ramp::{RampLimits, next_velocity_to_target, stopping_distance};

/// `mv_flag%` bit 4: moves go in the positive direction.
const ALWAYS_POSITIVE: i32 = 1 << 4;
/// `mv_flag%` bit 5: moves go in the negative direction.
const ALWAYS_NEGATIVE: i32 = 1 << 5;
/// `mv_flag%` bit 6: moves go the shortest way.
const SHORTEST: i32 = 1 << 6;
/// `minspeed%` at power-up: 10 rpm (D190), in counts*256/sample.
const POWER_UP_MERGE_SPEED: i32 = 350;

/// What `mmove` and `mmerge` go by.
#[derive(Debug, Clone, PartialEq)]
pub struct Moves {
    /// `mv_acc%`.
    pub acceleration: i32,
    /// `mv_dec%`.
    pub deceleration: i32,
    /// `mv_speed%`.
    pub speed: i32,
    /// `minspeed%`.
    pub merge_speed: i32,
    /// Bits 4 to 6 of `mv_flag%`.
    direction: i32,
}

impl Moves {
    pub(super) fn new() -> Moves {
        Moves {
            acceleration: POWER_UP_ACCELERATION,
            deceleration: POWER_UP_ACCELERATION,
            speed: POWER_UP_SPEED,
            merge_speed: POWER_UP_MERGE_SPEED,
            direction: 0,
        }
    }

    /// The direction bits of `mv_flag%`.
    pub fn direction(&self) -> i32 {
        self.direction
    }

    /// Sets the direction bits of `mv_flag%`, for the next move; the others report.
    pub fn set_flags(&mut self, flags: i32) {
        self.direction = flags & (ALWAYS_POSITIVE | ALWAYS_NEGATIVE | SHORTEST);
    }

    /// The limits of a move; a merge has a speed of its own.
    pub(super) fn limits(&self, merge: Option<i64>) -> RampLimits {
        RampLimits {
            speed: merge.unwrap_or(i64::from(self.speed)),
            acceleration: i64::from(self.acceleration),
            deceleration: i64::from(self.deceleration),
        }
    }

    /// The speed of a merge that begins at `velocity`: it keeps what it has and speeds up to `minspeed%`, but not from
    /// standstill, where the manual says that it never arrives.
    pub(super) fn merge_speed(&self, velocity: i64) -> i64 {
        match velocity.abs() {
            0 => 0,
            speed => speed.max(i64::from(self.merge_speed)),
        }
    }

    /// The way in counts from `here` to `position`. Without a modulus it is the 32-bit difference; with one the target
    /// is taken into it and reached as the direction bits say, without them on the way that does not pass 0 (D72).
    pub(super) fn distance(
        &self,
        position: i32,
        here: i64,
        modulus: Modulus,
        velocity: i64,
    ) -> i64 {
        let position = i64::from(position);
        let Some(modulus) = modulus.counts() else {
            return i64::from(wrap32(position.wrapping_sub(here)));
        };
        let forward = (position - here).rem_euclid(modulus);
        if self.direction & ALWAYS_POSITIVE != 0 {
            forward + self.turns_to_stop(forward, velocity, modulus)
        } else if self.direction & ALWAYS_NEGATIVE != 0 {
            let reverse = (here - position).rem_euclid(modulus);
            -(reverse + self.turns_to_stop(reverse, -velocity, modulus))
        } else if self.direction & SHORTEST != 0 {
            if forward * 2 <= modulus {
                forward
            } else {
                forward - modulus
            }
        } else {
            position.rem_euclid(modulus) - here.rem_euclid(modulus)
        }
    }

    /// Counts of whole turns to add to a `distance`, so that an axis with this `velocity` in its direction need not
    /// turn round because it is too fast to stop there.
    fn turns_to_stop(&self, distance: i64, velocity: i64, modulus: i64) -> i64 {
        if velocity <= 0 || self.deceleration <= 0 {
            return 0;
        }
        let stopping = stopping_distance(velocity, i64::from(self.deceleration));
        let missing = (stopping >> FRACTION) + 1 - distance;
        if missing <= 0 {
            0
        } else {
            (missing + modulus - 1) / modulus * modulus
        }
    }
}

/// A position with a move generator of its own, that is added to another: the virtual axis, the phase.
#[derive(Debug, Clone, PartialEq)]
pub struct Offset {
    /// `vx_acc%`, `ph_acc%`.
    pub acceleration: i32,
    /// `vx_dec%`, `ph_dec%`.
    pub deceleration: i32,
    /// `vx_speed%`, `ph_speed%`.
    pub speed: i32,
    /// In 1/256 count, unwrapped.
    position: i64,
    velocity: i64,
    target: Option<i64>,
}

impl Offset {
    pub(super) fn new() -> Offset {
        Offset {
            acceleration: POWER_UP_ACCELERATION,
            deceleration: POWER_UP_ACCELERATION,
            speed: POWER_UP_SPEED,
            position: 0,
            velocity: 0,
            target: None,
        }
    }

    /// Starts a move to a position in counts, over the 32-bit difference (D218).
    pub fn move_to(&mut self, position: i32) {
        let here = counts(self.position);
        let distance = i64::from(wrap32(i64::from(position).wrapping_sub(here)));
        self.target = Some(here.wrapping_add(distance) << FRACTION);
    }

    /// One sample; gives what it moves by, in 1/256 count.
    pub(super) fn sample(&mut self) -> i64 {
        let Some(target) = self.target else { return 0 };
        let to_go = target.wrapping_sub(self.position);
        self.velocity = next_velocity_to_target(self.velocity, to_go, &self.limits());
        self.position = self.position.wrapping_add(self.velocity);
        if self.velocity == 0 && self.position == target {
            self.target = None;
        }
        self.velocity
    }

    /// `ph_acc%`, `ph_dec%`, `ph_speed%` as limits.
    pub(super) fn limits(&self) -> RampLimits {
        RampLimits {
            speed: i64::from(self.speed),
            acceleration: i64::from(self.acceleration),
            deceleration: i64::from(self.deceleration),
        }
    }

    /// Ends the move where it is.
    pub(super) fn abort(&mut self) {
        (self.target, self.velocity) = (None, 0);
    }

    /// Forgets what was added so far.
    pub(super) fn clear(&mut self) {
        self.abort();
        self.position = 0;
    }

    /// Whether a target is not reached yet.
    pub fn is_active(&self) -> bool {
        self.target.is_some()
    }

    /// In 1/256 count.
    pub(super) fn position(&self) -> i64 {
        self.position
    }

    /// In counts, wrapped to 32 bits.
    pub fn reading(&self) -> i32 {
        wrap32(counts(self.position))
    }

    /// `vx_flag%` bit 0, `ph_flag%` bit 0.
    pub fn flags(&self) -> i32 {
        i32::from(!self.is_active())
    }

    /// Counts become 16 times finer, or coarser.
    pub(super) fn rescale(&mut self, scale: impl Fn(i64) -> i64) {
        self.position = scale(self.position);
        self.velocity = scale(self.velocity);
        self.target = self.target.map(|target| counts(scale(target)) << FRACTION);
    }
}
