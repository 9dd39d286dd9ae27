//! Ramps in exact integers: the velocity of the next sample.
//!
//! Positions are in 1/256 count, velocities in 1/256 count per sample, accelerations in 1/256 count per sample². A
//! velocity is what the position moves by in its sample, so that a move ends on its target to the last bit. Taken
//! at `position - velocity / 2` the samples lie on a continuous trapezoid, which is why durations agree with
//! [`super::profile`].
//!
//! All functions are mirror symmetric: negating the inputs negates the result. Inputs beyond [`BOUND`] count as it.

/// Largest magnitude that the arithmetic is exact for; 32-bit motion planners stay far below.
pub const BOUND: i64 = 1 << 59;

/// What a ramp may do. A value that is not above zero permits nothing: no speed, no speeding up, no slowing down.
/// With no deceleration an axis at rest therefore stays there (it could not stop), and one in motion goes on.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct RampLimits {
    /// Highest speed, in 1/256 count per sample.
    pub speed: i64,
    /// Largest increase of speed, in 1/256 count per sample².
    pub acceleration: i64,
    /// Largest decrease of speed, in 1/256 count per sample².
    pub deceleration: i64,
}

impl RampLimits {
    fn bounded(&self) -> RampLimits {
        RampLimits {
            speed: self.speed.clamp(0, BOUND),
            acceleration: self.acceleration.clamp(0, BOUND),
            deceleration: self.deceleration.clamp(0, BOUND),
        }
    }

    /// The highest velocity that the next sample may have. Through zero, the part of the sample that is left after
    /// stopping is spent accelerating.
    fn highest(&self, velocity: i64) -> i64 {
        if velocity >= 0 {
            return velocity + self.acceleration;
        }
        let crossed = velocity + self.deceleration;
        if crossed <= 0 {
            return crossed;
        }
        let crossed =
            i128::from(crossed) * i128::from(self.acceleration) / i128::from(self.deceleration);
        i64::try_from(crossed).unwrap_or(BOUND)
    }

    fn lowest(&self, velocity: i64) -> i64 {
        -self.highest(-velocity)
    }
}

/// The velocity of the next sample of a move with `distance` to go: the largest from which the axis can still stop
/// on its target.
///
/// The last sample of the move has exactly the distance that is left. An axis that is too fast to stop brakes, passes
/// its target and comes back; one above a lowered speed limit slows down at the deceleration.
pub fn next_velocity_to_target(velocity: i64, distance: i64, limits: &RampLimits) -> i64 {
    let velocity = velocity.clamp(-BOUND, BOUND);
    let distance = distance.clamp(-BOUND, BOUND);
    let limits = limits.bounded();
    if distance >= 0 {
        forward(velocity, distance, &limits)
    } else {
        -forward(-velocity, -distance, &limits)
    }
}

fn forward(velocity: i64, distance: i64, limits: &RampLimits) -> i64 {
    let lowest = limits.lowest(velocity);
    let fastest = limits.highest(velocity).min(limits.speed.max(lowest));
    fastest
        .min(landing_velocity(distance, limits.deceleration))
        .max(lowest)
}

/// The velocity of the next sample on the way to a constant speed.
pub fn next_velocity_to_speed(
    velocity: i64,
    speed: i64,
    acceleration: i64,
    deceleration: i64,
) -> i64 {
    let velocity = velocity.clamp(-BOUND, BOUND);
    let speed = speed.clamp(-BOUND, BOUND);
    let limits = RampLimits {
        speed: BOUND,
        acceleration,
        deceleration,
    }
    .bounded();
    if speed >= velocity {
        speed.min(limits.highest(velocity))
    } else {
        speed.max(limits.lowest(velocity))
    }
}

/// How far an axis still goes after a sample at `velocity` when it brakes at `deceleration` in each following sample,
/// with the sign of the velocity; saturates at `i64` (always so without deceleration).
pub fn stopping_distance(velocity: i64, deceleration: i64) -> i64 {
    if velocity == 0 {
        return 0;
    }
    if deceleration <= 0 {
        return if velocity > 0 { i64::MAX } else { i64::MIN };
    }
    let (v, d) = (i128::from(velocity).abs(), i128::from(deceleration));
    let samples = v / d;
    let distance = samples * v - d * (samples * (samples + 1) / 2);
    i64::try_from(distance * i128::from(velocity.signum())).unwrap_or(if velocity > 0 {
        i64::MAX
    } else {
        i64::MIN
    })
}

/// The largest velocity `v` of a sample with `v + stopping_distance(v) <= distance`; 0 without deceleration.
///
/// From `n` whole decelerations on, a velocity of `n * d + r` needs `d * n * (n + 1) / 2 + r * (n + 1)`.
fn landing_velocity(distance: i64, deceleration: i64) -> i64 {
    if deceleration == 0 {
        return 0;
    }
    let n = ((8 * (distance / deceleration) + 1).isqrt() - 1) / 2;
    n * deceleration + (distance - deceleration * (n * (n + 1) / 2)) / (n + 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn stopping_distance_is_the_sum_of_the_samples() {
        for deceleration in [1, 2, 3, 7, 70, 1000] {
            for velocity in -2500..2500 {
                let (mut v, mut sum) = (velocity, 0);
                while v != 0 {
                    v = next_velocity_to_speed(v, 0, deceleration, deceleration);
                    sum += v;
                }
                assert_eq!(
                    stopping_distance(velocity, deceleration),
                    sum,
                    "{velocity} {deceleration}"
                );
            }
        }
    }

    #[test]
    fn landing_velocity_is_the_largest_that_can_stop() {
        for deceleration in [1, 2, 5, 70] {
            for distance in 0..5000 {
                let v = landing_velocity(distance, deceleration);
                assert!(v + stopping_distance(v, deceleration) <= distance);
                assert!(v + 1 + stopping_distance(v + 1, deceleration) > distance);
            }
        }
    }

    #[test]
    fn nothing_overflows_at_the_extremes() {
        let extremes = [i64::MIN, -BOUND, -1, 0, 1, 70, BOUND, i64::MAX];
        for velocity in extremes {
            for distance in extremes {
                for limit in extremes {
                    let limits = RampLimits {
                        speed: limit,
                        acceleration: limit,
                        deceleration: limit,
                    };
                    next_velocity_to_target(velocity, distance, &limits);
                    next_velocity_to_speed(velocity, distance, limit, limit);
                    stopping_distance(velocity, limit);
                }
            }
        }
    }

    #[test]
    fn limits_that_are_not_positive_permit_nothing() {
        let none = RampLimits {
            speed: -5,
            acceleration: 0,
            deceleration: -1,
        };
        assert_eq!(next_velocity_to_target(0, 1000, &none), 0);
        assert_eq!(next_velocity_to_target(300, 1000, &none), 300);
        assert_eq!(next_velocity_to_speed(300, 0, 0, 0), 300);
        let cannot_stop = RampLimits {
            speed: 100,
            acceleration: 10,
            deceleration: 0,
        };
        assert_eq!(next_velocity_to_target(0, 1000, &cannot_stop), 0);
        let slow_down = RampLimits {
            speed: 0,
            acceleration: 10,
            deceleration: 10,
        };
        assert_eq!(next_velocity_to_target(25, 1000, &slow_down), 15);
        assert_eq!(next_velocity_to_target(5, 1000, &slow_down), 0);
    }
}
