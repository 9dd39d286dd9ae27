//! Gearing: the axis follows the master by a ratio of whole numbers, exactly.
//!
//! Source: "Mgear(type)". What was lost while the axis sped up, and `gr_prepost%`, are counted in the master's frame: the
//! axis should stand `gr_prepost%` ahead of where the ratio alone would have it since it was told to engage.

use super::units::FRACTION;
use super::{POWER_UP_ACCELERATION, POWER_UP_SPEED};
use crate::motion::ramp::{
    RampLimits, next_velocity_to_speed, next_velocity_to_target, stopping_distance,
};

/// No axis goes further in a sample, in 1/256 count; it keeps the arithmetic far from its bounds.
const FURTHEST: i128 = 1 << 40;

/// Where the engagement stands.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum State {
    /// Not engaged.
    Released,
    /// Comes up to the master's speed.
    Catching,
    /// At the master's speed, regains what was lost.
    Recovering,
    /// Follows digitally.
    Locked,
}

/// What `mgear(type)` asks for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct GearType {
    /// The edge of input 3 that engages; at once without one.
    edge: Option<Edge>,
    /// Regains what is lost while engaging.
    recovers: bool,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Edge {
    Rising,
    Falling,
    Any,
}

impl GearType {
    /// Types 1 to 8; `None` for any other.
    pub fn from_number(number: i32) -> Option<GearType> {
        let edge = match number {
            1 | 5 => None,
            2 | 6 => Some(Edge::Rising),
            3 | 7 => Some(Edge::Falling),
            4 | 8 => Some(Edge::Any),
            _ => return None,
        };
        Some(GearType {
            edge,
            recovers: number > 4,
        })
    }
}

/// The gear and its variables.
#[derive(Debug, Clone, PartialEq)]
pub struct Gear {
    /// `gr_ration%`.
    pub numerator: i32,
    /// `gr_ratioid%`.
    pub denominator: i32,
    /// `gr_acc%`.
    pub acceleration: i32,
    /// `gr_speed%`: of the recovery, relative to the master (D191).
    pub speed: i32,
    /// `gr_prepost%`, in counts of the axis.
    pub prepost: i32,
    /// Waits for its edge.
    armed: Option<GearType>,
    state: State,
    recovers: bool,
    /// The ratio that the remainder belongs to.
    ratio: (i32, i32),
    /// What the division has left over.
    remainder: i128,
    /// How far the axis is ahead of the ratio since it was engaged, in 1/256 count.
    ahead: i64,
}

impl Gear {
    pub(super) fn new() -> Gear {
        Gear {
            numerator: 1,
            denominator: 1,
            acceleration: POWER_UP_ACCELERATION,
            speed: POWER_UP_SPEED,
            prepost: 0,
            armed: None,
            state: State::Released,
            recovers: false,
            ratio: (1, 1),
            remainder: 0,
            ahead: 0,
        }
    }

    /// `mgear`; whether it engages at once.
    pub(super) fn request(&mut self, kind: GearType) -> bool {
        self.armed = Some(kind);
        kind.edge.is_none()
    }

    /// Whether it waits for this edge of input 3.
    pub(super) fn waits_for(&self, rising: bool) -> bool {
        let edge = self.armed.and_then(|kind| kind.edge);
        edge.is_some_and(|edge| match edge {
            Edge::Rising => rising,
            Edge::Falling => !rising,
            Edge::Any => true,
        })
    }

    /// Begins to engage. Since the edge that it engages by, the axis has moved by `moved` and the master by `master`.
    pub(super) fn engage(&mut self, moved: i64, master: i64) {
        self.recovers = self.armed.take().is_some_and(|kind| kind.recovers);
        self.state = State::Catching;
        (self.remainder, self.ratio) = (0, (self.numerator, self.denominator));
        self.ahead = moved.wrapping_sub(self.follow(master));
    }

    /// Another generator takes over.
    pub(super) fn release(&mut self) {
        (self.armed, self.state) = (None, State::Released);
    }

    /// What the ratio makes of a way of the master, in 1/256 count; nothing of it is lost over the samples.
    fn follow(&mut self, master: i64) -> i64 {
        let ratio = (self.numerator, self.denominator);
        if ratio != self.ratio {
            self.ratio = ratio;
            self.remainder = 0;
        }
        let (numerator, denominator) = (i128::from(ratio.0), i128::from(ratio.1));
        if denominator == 0 {
            return 0;
        }
        let total = i128::from(master) * numerator + self.remainder;
        self.remainder = total.rem_euclid(denominator);
        let way = total.div_euclid(denominator);
        i64::try_from(way.clamp(-FURTHEST, FURTHEST)).unwrap_or(0)
    }

    /// The velocity of the next sample, in which the master moves by `master` (1/256 count).
    pub(super) fn next_velocity(&mut self, velocity: i64, master: i64) -> i64 {
        let changed = self.ratio != (self.numerator, self.denominator);
        if changed && matches!(self.state, State::Recovering | State::Locked) {
            self.state = State::Catching;
        }
        let pace = self.follow(master);
        let acceleration = i64::from(self.acceleration);
        let target = i64::from(self.prepost) << FRACTION;
        let to_go = if self.recovers {
            target.wrapping_sub(self.ahead)
        } else {
            0
        };
        let next = match self.state {
            State::Released => velocity,
            State::Catching if self.loses_too_little(velocity - pace, to_go) => {
                pace + lower_acceleration(velocity - pace, to_go, acceleration)
            }
            State::Catching => next_velocity_to_speed(velocity, pace, acceleration, acceleration),
            State::Locked if to_go == 0 => pace,
            State::Recovering | State::Locked => {
                let limits = RampLimits {
                    speed: i64::from(self.speed),
                    acceleration,
                    deceleration: acceleration,
                };
                pace + next_velocity_to_target(velocity - pace, to_go, &limits)
            }
        };
        let gained = next - pace;
        if self.recovers {
            self.ahead = self.ahead.wrapping_add(gained);
        }
        let left = if self.recovers {
            to_go.wrapping_sub(gained)
        } else {
            0
        };
        self.state = match self.state {
            State::Released => State::Released,
            _ if gained == 0 && left == 0 => State::Locked,
            State::Catching if gained != 0 => State::Catching,
            _ => State::Recovering,
        };
        next
    }

    /// Whether the axis would be up to the master's speed with less lost than `gr_prepost%` wants: then it takes a lower
    /// acceleration.
    fn loses_too_little(&self, gaining: i64, to_go: i64) -> bool {
        let stops = stopping_distance(gaining, i64::from(self.acceleration));
        self.acceleration > 0
            && gaining != 0
            && gaining.signum() == to_go.signum()
            && stops.unsigned_abs() < to_go.unsigned_abs()
    }

    /// `gr_flag%`: bit 0 engaging, bit 1 locked.
    pub fn flags(&self) -> i32 {
        match self.state {
            State::Released => 0,
            State::Catching | State::Recovering => 1,
            State::Locked => 2,
        }
    }

    /// Whether it follows digitally.
    pub fn is_locked(&self) -> bool {
        self.state == State::Locked
    }
}

/// The next relative velocity of an axis that reaches the master's speed just when it has lost `to_go`: with the lowest
/// acceleration that does, v²/(2s + v) in samples but for rounding.
fn lower_acceleration(gaining: i64, to_go: i64, acceleration: i64) -> i64 {
    let (speed, way) = (
        i128::from(gaining.unsigned_abs()),
        i128::from(to_go.unsigned_abs()),
    );
    let lowest = speed * speed / (2 * way + speed).max(1);
    let lowest = i64::try_from(lowest).unwrap_or(acceleration).max(1);
    let suffices = |a: &i64| {
        let next = (gaining.abs() - a).max(0);
        stopping_distance(next, *a).saturating_add(next) <= to_go.saturating_abs()
    };
    // Rounding makes a difference of one or two.
    let mut candidates = lowest..lowest.saturating_add(4).min(acceleration);
    let limits = RampLimits {
        speed: gaining.abs(),
        acceleration: 0,
        deceleration: candidates.find(suffices).unwrap_or(acceleration),
    };
    next_velocity_to_target(gaining, to_go, &limits)
}
