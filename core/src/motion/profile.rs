//! A move in closed form: trapezoidal velocity, evaluated at any time.

use super::MotionState;

/// A move with constant accelerations: slow down or turn round if need be, accelerate, cruise, decelerate.
///
/// Lengths are in any one unit, times in seconds; position 0 is where the move starts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Trapezoid {
    /// Braking from a start that is above the speed limit, in the wrong direction, or too fast to stop on the target.
    brake: Phase,
    accelerate: Phase,
    cruise: Phase,
    decelerate: Phase,
}

/// A stretch of constant acceleration until `end`, described by the state at its `origin` (the last phase's is its
/// end, so that it comes to rest exactly on the target).
#[derive(Debug, Clone, Copy, PartialEq)]
struct Phase {
    end: f64,
    origin: f64,
    state: MotionState,
}

impl Phase {
    #[inline]
    fn at(&self, time: f64) -> MotionState {
        let MotionState {
            position,
            velocity,
            acceleration,
        } = self.state;
        let t = time - self.origin;
        MotionState {
            position: position + t * (velocity + 0.5 * acceleration * t),
            velocity: velocity + acceleration * t,
            acceleration,
        }
    }
}

impl Trapezoid {
    /// Plans the fastest move over `distance` that comes to rest there, from `start_velocity` (same sign convention),
    /// within a highest `speed` and the two accelerations (all three above zero).
    ///
    /// `None` if a limit is not above zero or a number is not finite.
    pub fn plan(
        distance: f64,
        start_velocity: f64,
        speed: f64,
        acceleration: f64,
        deceleration: f64,
    ) -> Option<Trapezoid> {
        let positive = |limit: f64| limit > 0.0 && limit.is_finite();
        if !(positive(speed) && positive(acceleration) && positive(deceleration)) {
            return None;
        }
        if !(distance.is_finite() && start_velocity.is_finite()) {
            return None;
        }
        let brake = braking(distance, start_velocity, speed, deceleration);
        let turned = brake.at(brake.end);
        let to_go = distance - turned.position;
        let direction = if to_go < 0.0 { -1.0 } else { 1.0 };
        let (to_go, start) = (to_go * direction, turned.velocity * direction);

        let room = (2.0 * acceleration * to_go + start * start) * deceleration
            / (acceleration + deceleration);
        let top = larger(start, smaller(speed, room.sqrt()));
        let speeding_up = (top - start) / acceleration;
        let gained = 0.5 * (top + start) * speeding_up;
        let slowing_down = top / deceleration;
        let left = to_go - gained - 0.5 * top * slowing_down;
        let cruising = if top > 0.0 && left > 0.0 {
            left / top
        } else {
            0.0
        };

        let accelerate = Phase {
            end: brake.end + speeding_up,
            origin: brake.end,
            state: MotionState {
                acceleration: acceleration * direction,
                ..turned
            },
        };
        let cruise = Phase {
            end: accelerate.end + cruising,
            origin: accelerate.end,
            state: MotionState {
                position: turned.position + gained * direction,
                velocity: top * direction,
                acceleration: 0.0,
            },
        };
        let end = cruise.end + slowing_down;
        let state = MotionState {
            position: distance,
            velocity: 0.0,
            acceleration: -deceleration * direction,
        };
        Some(Trapezoid {
            brake,
            accelerate,
            cruise,
            decelerate: Phase {
                end,
                origin: end,
                state,
            },
        })
    }

    /// Time from start to rest, in seconds.
    pub fn duration(&self) -> f64 {
        self.decelerate.end
    }

    /// The state `time` seconds after the start: at rest on the target from [`Trapezoid::duration`] on, and as at the
    /// start before it.
    #[inline]
    pub fn at(&self, time: f64) -> MotionState {
        let time = larger(time, 0.0);
        if time >= self.decelerate.end {
            return MotionState {
                position: self.decelerate.state.position,
                velocity: 0.0,
                acceleration: 0.0,
            };
        }
        let phase = if time >= self.cruise.end {
            &self.decelerate
        } else if time >= self.accelerate.end {
            &self.cruise
        } else if time >= self.brake.end {
            &self.accelerate
        } else {
            &self.brake
        };
        phase.at(time)
    }
}

/// The stretch that must be braked before anything else: to rest if the target cannot be reached without turning
/// round, else down to the speed limit; empty if neither is needed.
fn braking(distance: f64, velocity: f64, speed: f64, deceleration: f64) -> Phase {
    let stops_after = 0.5 * velocity * velocity.abs() / deceleration;
    let turns_round =
        (velocity > 0.0 && stops_after > distance) || (velocity < 0.0 && stops_after < distance);
    let keeps = if turns_round {
        0.0
    } else {
        smaller(velocity.abs(), speed)
    };
    let state = MotionState {
        position: 0.0,
        velocity,
        acceleration: if velocity > 0.0 {
            -deceleration
        } else {
            deceleration
        },
    };
    Phase {
        end: (velocity.abs() - keeps) / deceleration,
        origin: 0.0,
        state,
    }
}

// `f64::min` and `max` may return either zero for 0.0 and -0.0, which would differ between machines.
fn smaller(a: f64, b: f64) -> f64 {
    if b < a { b } else { a }
}

fn larger(a: f64, b: f64) -> f64 {
    if b > a { b } else { a }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn close(a: f64, b: f64) -> bool {
        (a - b).abs() <= 1e-9 * (1.0 + a.abs() + b.abs())
    }

    #[test]
    fn a_trapezoid_of_round_numbers() {
        let plan = Trapezoid::plan(100.0, 0.0, 10.0, 5.0, 2.5).unwrap();
        assert!(close(plan.duration(), 2.0 + 7.0 + 4.0));
        assert_eq!(
            plan.at(1.0),
            MotionState {
                position: 2.5,
                velocity: 5.0,
                acceleration: 5.0
            }
        );
        assert_eq!(
            plan.at(4.0),
            MotionState {
                position: 30.0,
                velocity: 10.0,
                acceleration: 0.0
            }
        );
        assert_eq!(
            plan.at(11.0),
            MotionState {
                position: 95.0,
                velocity: 5.0,
                acceleration: -2.5
            }
        );
        assert_eq!(
            plan.at(99.0),
            MotionState {
                position: 100.0,
                velocity: 0.0,
                acceleration: 0.0
            }
        );
    }

    #[test]
    fn a_short_move_is_a_triangle() {
        let plan = Trapezoid::plan(-6.0, 0.0, 1000.0, 1.0, 3.0).unwrap();
        assert!(close(plan.duration(), 3.0 + 1.0));
        assert!(close(plan.at(3.0).velocity, -3.0));
    }

    #[test]
    fn too_fast_to_stop_passes_the_target_and_comes_back() {
        let plan = Trapezoid::plan(1.0, 4.0, 10.0, 2.0, 2.0).unwrap();
        assert!(close(plan.at(2.0).position, 4.0));
        assert!(close(plan.at(2.0).velocity, 0.0));
        assert!(close(plan.duration(), 2.0 + 2.0 * (3.0f64 / 2.0).sqrt()));
    }

    #[test]
    fn starts_in_the_wrong_direction_or_too_fast() {
        let turned = Trapezoid::plan(10.0, -2.0, 5.0, 1.0, 2.0).unwrap();
        assert!(close(turned.at(1.0).position, -1.0) && close(turned.at(1.0).velocity, 0.0));
        let slowed = Trapezoid::plan(100.0, 20.0, 10.0, 1.0, 10.0).unwrap();
        assert!(close(slowed.at(1.0).position, 15.0) && close(slowed.at(1.0).velocity, 10.0));
        assert!(close(slowed.duration(), 1.0 + 8.0 + 1.0));
    }

    #[test]
    fn unusable_limits_are_refused() {
        for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            assert_eq!(Trapezoid::plan(1.0, 0.0, bad, 1.0, 1.0), None);
            assert_eq!(Trapezoid::plan(1.0, 0.0, 1.0, bad, 1.0), None);
            assert_eq!(Trapezoid::plan(1.0, 0.0, 1.0, 1.0, bad), None);
        }
        assert_eq!(Trapezoid::plan(f64::NAN, 0.0, 1.0, 1.0, 1.0), None);
    }

    #[test]
    fn no_distance_takes_no_time() {
        let plan = Trapezoid::plan(0.0, 0.0, 1.0, 1.0, 1.0).unwrap();
        assert_eq!(plan.duration(), 0.0);
        assert_eq!(plan.at(0.0), MotionState::default());
    }
}
