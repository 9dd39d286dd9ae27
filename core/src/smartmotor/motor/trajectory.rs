//! What the servo follows: position, velocity and acceleration in exact integers, once a servo sample.
//!
//! Positions are in 1/65536 count and never wrap; they are wrapped where a program reads one. Velocities are what the
//! position moves by in a servo sample, which is the unit of `V`; accelerations likewise that of `A`.

use super::follow::{Cam, Ratio};
use super::stream::Stream;
use crate::motion::ramp::{RampLimits, next_velocity_to_speed, next_velocity_to_target};

/// Bits behind the point of a position.
pub const FRACTION: u32 = 16;
/// Half a count.
const HALF: i64 = 1 << (FRACTION - 1);

/// What makes the demand.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Generator {
    /// Nothing: the position is held.
    Hold,
    /// On the way to a position.
    Position { target: i64 },
    /// On the way to a velocity, or at it.
    Velocity { speed: i64 },
    /// Decelerates to a stop.
    Stop,
    /// Goes with the counter.
    Follow(Ratio),
    /// Goes by the cam.
    Cam(Cam),
    /// Goes by what the host has sent.
    Contour,
}

/// The demand and what makes it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Trajectory {
    position: i64,
    velocity: i64,
    acceleration: i64,
    /// Of the counts that come from the counter in bursts: the mean velocity, which a stop begins with.
    mean: i64,
    generator: Generator,
    /// Of the move in progress.
    limits: RampLimits,
}

impl Trajectory {
    /// At rest at a count.
    pub fn new(count: i64) -> Trajectory {
        Trajectory {
            position: count << FRACTION,
            velocity: 0,
            acceleration: 0,
            mean: 0,
            generator: Generator::Hold,
            limits: RampLimits {
                speed: 0,
                acceleration: 0,
                deceleration: 0,
            },
        }
    }

    /// The velocity of the next servo sample, which [`Trajectory::advance`] makes. `master` is how much the counter
    /// moved.
    #[inline]
    pub fn next_velocity(
        &mut self,
        master: i64,
        stream: &mut Stream,
        table: impl Fn(u8) -> i16,
    ) -> i64 {
        let velocity = self.velocity;
        let acceleration = self.limits.acceleration;
        let to_speed = |speed| next_velocity_to_speed(velocity, speed, acceleration, acceleration);
        match &mut self.generator {
            Generator::Hold => 0,
            Generator::Position { target } => {
                next_velocity_to_target(velocity, *target - self.position, &self.limits)
            }
            Generator::Velocity { speed } => to_speed(*speed),
            Generator::Stop => to_speed(0),
            Generator::Follow(ratio) => ratio.step(master),
            Generator::Cam(cam) => cam.step(master, table),
            Generator::Contour => match stream.step() {
                Some(moved) => moved,
                None => {
                    self.hold();
                    0
                }
            },
        }
    }

    /// One servo sample at `velocity`.
    #[inline]
    pub fn advance(&mut self, velocity: i64) {
        self.acceleration = velocity - self.velocity;
        self.velocity = velocity;
        self.position += velocity;
        match self.generator {
            Generator::Hold => {}
            Generator::Position { target } => {
                // What is left of the velocity is less than a sample takes away.
                if target == self.position && velocity.abs() <= self.limits.deceleration {
                    self.generator = Generator::Hold;
                }
            }
            Generator::Velocity { speed } => {
                if velocity == 0 && speed == 0 {
                    self.hold();
                }
            }
            Generator::Stop => {
                if velocity == 0 {
                    self.hold();
                }
            }
            Generator::Follow(_) | Generator::Cam(_) | Generator::Contour => {
                self.mean += (velocity - self.mean) / 16;
            }
        }
    }

    /// Stops at once and holds the nearest count (`S`).
    pub fn hold(&mut self) {
        self.generator = Generator::Hold;
        self.velocity = 0;
        self.acceleration = 0;
        self.position = (self.position + HALF) >> FRACTION << FRACTION;
    }

    /// Decelerates to a stop by the acceleration of the motion (`X`). One without any stops at once.
    pub fn decelerate(&mut self, acceleration: i32) {
        match self.generator {
            Generator::Hold | Generator::Stop => return,
            Generator::Follow(_) | Generator::Cam(_) | Generator::Contour => {
                self.velocity = self.mean;
                self.set_limits(0, acceleration);
            }
            Generator::Position { .. } | Generator::Velocity { .. } => {}
        }
        if self.limits.acceleration == 0 {
            self.hold();
        } else {
            self.generator = Generator::Stop;
        }
    }

    /// Takes the motor as it is, while the servo does not hold it: position in counts, velocity in counts/sample x
    /// 65536.
    pub fn release(&mut self, count: i64, velocity: i64) {
        self.generator = Generator::Hold;
        self.position = count << FRACTION;
        self.velocity = velocity;
        self.acceleration = 0;
    }

    /// Goes to a position in counts.
    pub fn move_to(&mut self, count: i64, speed: i32, acceleration: i32) {
        self.set_limits(speed, acceleration);
        self.generator = Generator::Position {
            target: count << FRACTION,
        };
    }

    /// Goes at a velocity.
    pub fn run_at(&mut self, speed: i32, acceleration: i32) {
        self.set_limits(0, acceleration);
        self.generator = Generator::Velocity {
            speed: i64::from(speed),
        };
    }

    /// Goes with the counter.
    pub fn follow(&mut self, ratio: Ratio) {
        self.mean = self.velocity;
        self.generator = Generator::Follow(ratio);
    }

    /// Goes by a cam.
    pub fn cam(&mut self, cam: Cam) {
        self.mean = self.velocity;
        self.generator = Generator::Cam(cam);
    }

    /// Goes by the stream.
    pub fn contour(&mut self) {
        self.mean = self.velocity;
        self.generator = Generator::Contour;
    }

    fn set_limits(&mut self, speed: i32, acceleration: i32) {
        self.limits = RampLimits {
            speed: i64::from(speed).abs(),
            acceleration: i64::from(acceleration),
            deceleration: i64::from(acceleration),
        };
    }

    /// A trajectory is in progress: `Bt`.
    #[inline]
    pub fn is_active(&self) -> bool {
        self.generator != Generator::Hold
    }

    /// In progress and not just waiting for a counter that stands.
    pub fn is_under_way(&self) -> bool {
        match self.generator {
            Generator::Hold => false,
            Generator::Follow(_) | Generator::Cam(_) => self.velocity != 0 || self.mean.abs() > 64,
            _ => true,
        }
    }

    /// On its way to a stop.
    pub fn is_stopping(&self) -> bool {
        self.generator == Generator::Stop
    }

    /// In 1/65536 count.
    #[inline]
    pub fn position(&self) -> i64 {
        self.position
    }

    /// In whole counts.
    pub fn count(&self) -> i64 {
        self.position >> FRACTION
    }

    /// In counts/sample x 65536.
    pub fn velocity(&self) -> i64 {
        self.velocity
    }

    /// In counts/sample² x 65536.
    pub fn acceleration(&self) -> i64 {
        self.acceleration
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn run(trajectory: &mut Trajectory) -> u64 {
        let mut samples = 0;
        while trajectory.is_active() {
            let velocity = trajectory.next_velocity(0, &mut Stream::default(), |_| 0);
            trajectory.advance(velocity);
            samples += 1;
        }
        samples
    }

    /// Of a trapezoid or triangle from rest to rest, in samples.
    fn closed_form(distance: i64, speed: i32, acceleration: i32) -> f64 {
        let (d, v, a) = (
            (distance.abs() << FRACTION) as f64,
            f64::from(speed),
            f64::from(acceleration),
        );
        if d > v * v / a {
            d / v + v / a
        } else {
            2.0 * (d / a).sqrt()
        }
    }

    proptest! {
        #[test]
        fn a_move_takes_its_closed_form_time_and_ends_on_the_count(
            start in -1_000_000i64..1_000_000,
            distance in -200_000i64..200_000,
            speed in 10_000i32..4_000_000,
            acceleration in 1i32..4_000,
        ) {
            let mut trajectory = Trajectory::new(start);
            trajectory.move_to(start + distance, speed, acceleration);
            let samples = run(&mut trajectory) as f64;
            prop_assert_eq!(trajectory.position(), (start + distance) << FRACTION);
            let expected = closed_form(distance, speed, acceleration);
            prop_assert!((samples - expected).abs() <= 1.0, "{} {}", samples, expected);
        }

        #[test]
        fn a_move_that_is_changed_on_its_way_still_ends_on_the_count(
            targets in prop::collection::vec((-50_000i64..50_000, 20_000i32..2_000_000, 20i32..4_000, 1u32..600), 1..6),
        ) {
            let mut trajectory = Trajectory::new(0);
            for &(target, speed, acceleration, samples) in &targets {
                trajectory.move_to(target, speed, acceleration);
                for _ in 0..samples {
                    let velocity = trajectory.next_velocity(0, &mut Stream::default(), |_| 0);
                    prop_assert!((velocity - trajectory.velocity()).abs() <= i64::from(acceleration)
                        || velocity == 0 || velocity.abs() <= i64::from(acceleration));
                    trajectory.advance(velocity);
                }
            }
            run(&mut trajectory);
            prop_assert_eq!(trajectory.count(), targets.last().unwrap().0);
        }
    }

    #[test]
    fn a_velocity_is_reached_and_left_at_the_acceleration() {
        let mut trajectory = Trajectory::new(0);
        trajectory.run_at(-100_000, 1000);
        for _ in 0..100 {
            let velocity = trajectory.next_velocity(0, &mut Stream::default(), |_| 0);
            trajectory.advance(velocity);
        }
        assert_eq!(trajectory.velocity(), -100_000);
        trajectory.decelerate(0);
        assert_eq!(run(&mut trajectory), 100);
    }

    #[test]
    fn without_acceleration_nothing_begins_and_nothing_runs_away() {
        let mut trajectory = Trajectory::new(0);
        trajectory.move_to(100, 100_000, 0);
        for _ in 0..100 {
            let velocity = trajectory.next_velocity(0, &mut Stream::default(), |_| 0);
            trajectory.advance(velocity);
        }
        assert_eq!((trajectory.count(), trajectory.is_active()), (0, true));
        trajectory.decelerate(0);
        assert!(!trajectory.is_active());
    }
}
