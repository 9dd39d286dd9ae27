//! Homing: the drive's own procedures NREF 0 to 8, which give the axis its position.
//!
//! Source: "Mhome(cmd)". The axis ends on its reference point, which then reads `ROFFS` (D198). A zero mark is where the
//! feedback unit begins a new turn, which it knows without passing it.

use crate::motion::ramp::{RampLimits, next_velocity_to_speed, next_velocity_to_target};

/// What the drive's parameters ask for, on the planner's scale.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Homing {
    /// NREF, 0 to 8.
    pub kind: i32,
    /// DREF: 0 negative, 1 positive, 2 the shorter way (NREF 5).
    pub direction: i32,
    /// VREF, in counts*256/sample.
    pub speed: i64,
    /// ACCR, in counts*256/sample².
    pub acceleration: i64,
    /// DECR, likewise.
    pub deceleration: i64,
    /// ROFFS, in 1/256 count.
    pub offset: i64,
    /// What the SSI input reads, in 1/256 count.
    pub absolute: i64,
}

/// What the axis meets in a sample, positions in 1/256 count.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Surroundings {
    /// The reference switch is pressed.
    pub switch: bool,
    /// Where the reference switch last changed, within this sample.
    pub switch_edge: Option<i64>,
    /// The positive limit switch is pressed.
    pub positive_limit: bool,
    /// The negative limit switch is pressed.
    pub negative_limit: bool,
    /// Where a limit switch last changed, within this sample.
    pub limit_edge: Option<i64>,
    /// Actual position.
    pub feedback: i64,
    /// A zero mark of the feedback unit.
    pub zero_mark: i64,
    /// From one zero mark to the next.
    pub turn: i64,
    /// The axis cannot follow: it stands at a mechanical stop.
    pub stalled: bool,
}

impl Surroundings {
    /// The limit switch in a direction.
    fn limit(&self, direction: i64) -> bool {
        if direction > 0 {
            self.positive_limit
        } else {
            self.negative_limit
        }
    }

    /// The first zero mark beyond a position.
    fn next_zero(&self, from: i64, direction: i64) -> i64 {
        let turn = self.turn.max(1);
        let before = (from - self.zero_mark).rem_euclid(turn);
        if direction > 0 {
            from - before + turn
        } else if before == 0 {
            from - turn
        } else {
            from - before
        }
    }
}

/// Directions are 1 and -1.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum State {
    /// Leaves the reference switch that it stood on at the start.
    Leaving,
    /// On the way to the reference switch.
    Seeking,
    /// Met the limit before the switch: goes back until the switch is behind it.
    Returning { met: bool },
    /// On the way to the limit switch.
    ToLimit,
    /// On the way off the limit switch.
    OffLimit,
    /// On the way to the mechanical stop.
    ToStop,
    /// Ends on the reference point; `None` keeps the positions as they are.
    Landing { target: i64 },
}

/// What homing asks of the axis in a sample.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Step {
    /// Moves on at this velocity.
    Go(i64),
    /// The reference stands at the actual position now, at rest.
    Yield,
    /// The axis stands on its reference point, which gets this position.
    Done(Option<i64>),
    /// The procedure cannot be carried out.
    Failed,
}

/// A homing procedure under way.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Home {
    homing: Homing,
    direction: i64,
    state: State,
}

impl Home {
    /// Begins, with the axis at rest.
    pub fn new(homing: Homing, around: &Surroundings) -> Home {
        let ahead = around.next_zero(around.feedback, 1);
        let behind = around.next_zero(around.feedback, -1);
        let nearer_ahead = ahead - around.feedback <= around.feedback - behind;
        let forward = homing.direction == 1 || homing.direction == 2 && nearer_ahead;
        let direction = if forward { 1 } else { -1 };
        let state = match homing.kind {
            1 | 3 if around.switch => State::Leaving,
            1 | 3 => State::Seeking,
            2 | 4 => State::ToLimit,
            5 => State::Landing {
                target: if forward { ahead } else { behind },
            },
            7 => State::ToStop,
            8 => State::Landing {
                target: homing.absolute,
            },
            _ => State::Landing {
                target: around.feedback,
            },
        };
        Home {
            homing,
            direction,
            state,
        }
    }

    /// Whether the drive lends only REFIP of its torque, and lets the axis fall behind.
    pub fn pushes(&self) -> bool {
        self.state == State::ToStop
    }

    /// The scale of positions moves by `shift`.
    pub fn shift(&mut self, shift: i64) {
        if let State::Landing { target } = &mut self.state {
            *target = target.wrapping_add(shift);
        }
    }

    /// One sample of an axis whose reference is at `position` with `velocity`.
    pub fn next(&mut self, velocity: i64, position: i64, around: &Surroundings) -> Step {
        let d = self.direction;
        match self.state {
            State::Leaving if !around.switch => self.state = State::Seeking,
            State::Seeking if around.switch => {
                let edge = around.switch_edge.unwrap_or(around.feedback);
                self.land(edge, d, self.homing.kind == 1, around);
            }
            State::Seeking if around.limit(d) => self.state = State::Returning { met: false },
            State::Returning { met: false } if around.switch => {
                self.state = State::Returning { met: true };
            }
            State::Returning { met: true } if !around.switch => self.state = State::Seeking,
            State::Leaving | State::Returning { .. } if around.limit(-d) => return Step::Failed,
            State::ToLimit if around.limit(d) => self.state = State::OffLimit,
            State::OffLimit if !around.limit(d) && velocity.signum() == -d => {
                let edge = around.limit_edge.unwrap_or(around.feedback);
                self.land(edge, -d, self.homing.kind == 2, around);
            }
            State::ToStop if around.stalled => {
                self.land(around.feedback, -d, true, around);
                return Step::Yield;
            }
            State::Landing { .. }
                if matches!(self.homing.kind, 1 | 3 | 5 | 8)
                    && velocity != 0
                    && around.limit(velocity.signum()) =>
            {
                return Step::Failed;
            }
            _ => {}
        }
        self.velocity(velocity, position)
    }

    /// Ends on the edge of a switch, or on the zero mark behind it.
    fn land(&mut self, edge: i64, direction: i64, zero_mark: bool, around: &Surroundings) {
        let target = if zero_mark {
            around.next_zero(edge, direction)
        } else {
            edge
        };
        self.state = State::Landing { target };
    }

    fn velocity(&self, velocity: i64, position: i64) -> Step {
        let Homing {
            speed,
            acceleration,
            deceleration,
            ..
        } = self.homing;
        let towards = |direction: i64| {
            Step::Go(next_velocity_to_speed(
                velocity,
                speed * direction,
                acceleration,
                deceleration,
            ))
        };
        match self.state {
            State::Seeking | State::ToLimit | State::ToStop => towards(self.direction),
            State::Leaving | State::Returning { .. } | State::OffLimit => towards(-self.direction),
            State::Landing { target } if velocity == 0 && position == target => {
                Step::Done((self.homing.kind != 8).then_some(self.homing.offset))
            }
            State::Landing { target } => {
                let limits = RampLimits {
                    speed,
                    acceleration,
                    deceleration,
                };
                Step::Go(next_velocity_to_target(
                    velocity,
                    target - position,
                    &limits,
                ))
            }
        }
    }
}
