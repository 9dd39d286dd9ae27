//! The integer ramps against their own limits and against the closed form, over thousands of random moves.

use motionbench_core::motion::profile::Trapezoid;
use motionbench_core::motion::ramp::{RampLimits, next_velocity_to_speed, next_velocity_to_target};

use crate::random::Random;

/// Whether one sample's change of velocity keeps to the limits.
fn check_step(before: i64, after: i64, limits: &RampLimits) {
    let RampLimits {
        speed,
        acceleration,
        deceleration,
    } = *limits;
    let (from, to) = (before.abs(), after.abs());
    if before != 0 && after != 0 && before.signum() != after.signum() {
        // Stopping takes its part of the sample, accelerating the rest.
        let used =
            i128::from(from) * i128::from(acceleration) + i128::from(to) * i128::from(deceleration);
        assert!(
            used <= i128::from(acceleration) * i128::from(deceleration),
            "{before} -> {after} {limits:?}"
        );
    } else if to > from {
        assert!(to - from <= acceleration, "{before} -> {after} {limits:?}");
    } else {
        assert!(from - to <= deceleration, "{before} -> {after} {limits:?}");
    }
    assert!(
        to <= speed.max(from - deceleration),
        "{before} -> {after} {limits:?}"
    );
}

fn random_limits(random: &mut Random) -> RampLimits {
    RampLimits {
        speed: random.logarithmic(1 << 21),
        acceleration: random.logarithmic(1 << 15),
        deceleration: random.logarithmic(1 << 15),
    }
}

/// Samples until the axis rests on its target.
fn run(distance: i64, start: i64, limits: &RampLimits, most: u32) -> Option<u32> {
    let (mut to_go, mut velocity) = (distance, start);
    for sample in 0..most {
        if to_go == 0 && velocity == 0 {
            return Some(sample);
        }
        let next = next_velocity_to_target(velocity, to_go, limits);
        check_step(velocity, next, limits);
        velocity = next;
        to_go -= next;
    }
    None
}

/// The samples of a ramp lie half a sample behind the continuous trapezoid (see `ramp`), which gives the distance.
fn closed_form(distance: i64, start: i64, limits: &RampLimits) -> f64 {
    let distance = distance as f64 + 0.5 * start as f64;
    let RampLimits {
        speed,
        acceleration,
        deceleration,
    } = *limits;
    Trapezoid::plan(
        distance,
        start as f64,
        speed as f64,
        acceleration as f64,
        deceleration as f64,
    )
    .unwrap()
    .duration()
}

#[test]
fn moves_from_rest_end_on_target_in_the_time_of_the_closed_form() {
    let mut random = Random::new(1);
    for _ in 0..20_000 {
        let limits = random_limits(&mut random);
        let distance = random.signed(1 << 34);
        let expected = closed_form(distance, 0, &limits);
        if expected > 20_000.0 {
            continue;
        }
        let samples = f64::from(run(distance, 0, &limits, 20_100).expect("ends"));
        assert!(
            samples >= expected - 1e-6,
            "{samples} {expected} {distance} {limits:?}"
        );
        assert!(
            samples < expected + 2.0,
            "{samples} {expected} {distance} {limits:?}"
        );
    }
}

#[test]
fn moves_from_any_velocity_end_on_target_in_the_time_of_the_closed_form() {
    let mut random = Random::new(2);
    for _ in 0..20_000 {
        let limits = random_limits(&mut random);
        let (distance, start) = (random.signed(1 << 30), random.signed(1 << 20));
        let expected = closed_form(distance, start, &limits);
        if expected > 20_000.0 {
            continue;
        }
        let samples = f64::from(run(distance, start, &limits, 20_100).expect("ends"));
        // Braking takes whole samples, which shifts where the axis turns round by up to 1/8 deceleration; the way
        // back takes no longer than a move of its own.
        let shifted = closed_form(limits.deceleration / 8 + 1, 0, &limits);
        assert!(
            (samples - expected).abs() < 2.0 + shifted,
            "{samples} {expected} {distance} {start} {limits:?}"
        );
    }
}

#[test]
fn limits_changed_on_the_fly_are_obeyed_at_once_and_the_move_still_ends() {
    let mut random = Random::new(3);
    for _ in 0..3000 {
        let (mut to_go, mut velocity) = (random.signed(1 << 30), 0);
        let mut limits = random_limits(&mut random);
        let mut samples = 0;
        while to_go != 0 || velocity != 0 {
            if samples < 2000 && random.below(50) == 0 {
                limits = random_limits(&mut random);
            }
            if samples == 2000 {
                limits = RampLimits {
                    speed: 1 << 18,
                    acceleration: 1 << 12,
                    deceleration: 1 << 12,
                };
            }
            let next = next_velocity_to_target(velocity, to_go, &limits);
            check_step(velocity, next, &limits);
            velocity = next;
            to_go -= next;
            samples += 1;
            assert!(samples < 100_000, "{to_go} {velocity}");
        }
    }
}

#[test]
fn speed_is_reached_in_the_fewest_samples_that_the_limits_allow() {
    let mut random = Random::new(4);
    for _ in 0..5000 {
        let limits = RampLimits {
            speed: i64::MAX,
            ..random_limits(&mut random)
        };
        let (mut velocity, speed) = (random.signed(1 << 21), random.signed(1 << 21));
        let slower = if velocity.signum() == speed.signum() {
            (velocity.abs() - speed.abs()).max(0)
        } else {
            velocity.abs()
        };
        let faster = if velocity.signum() == speed.signum() {
            (speed.abs() - velocity.abs()).max(0)
        } else {
            speed.abs()
        };
        let expected =
            slower as f64 / limits.deceleration as f64 + faster as f64 / limits.acceleration as f64;
        if expected > 5000.0 {
            continue;
        }
        let mut samples = 0;
        while velocity != speed {
            let next =
                next_velocity_to_speed(velocity, speed, limits.acceleration, limits.deceleration);
            check_step(velocity, next, &limits);
            velocity = next;
            samples += 1;
        }
        assert!(
            (f64::from(samples) - expected).abs() <= 1.0,
            "{samples} {expected}"
        );
    }
}

#[test]
fn a_move_mirrored_is_the_mirrored_move() {
    let mut random = Random::new(5);
    for _ in 0..10_000 {
        let limits = random_limits(&mut random);
        let (velocity, distance) = (random.signed(1 << 21), random.signed(1 << 30));
        let next = next_velocity_to_target(velocity, distance, &limits);
        assert_eq!(
            next_velocity_to_target(-velocity, -distance, &limits),
            -next
        );
    }
}
