//! The closed form against its own definition, over thousands of random moves.

use motionbench_core::motion::profile::Trapezoid;

use crate::random::Random;

#[test]
fn a_profile_is_continuous_and_within_its_limits() {
    let mut random = Random::new(21);
    let mut number = |limit: i64| random.signed(limit) as f64 / 16.0;
    for _ in 0..20_000 {
        let (distance, start) = (number(1 << 24), number(1 << 16));
        let (speed, acceleration, deceleration) = (
            number(1 << 16).abs(),
            number(1 << 14).abs(),
            number(1 << 14).abs(),
        );
        let plan = Trapezoid::plan(distance, start, speed, acceleration, deceleration).unwrap();
        let duration = plan.duration();
        let scale = 1.0 + distance.abs() + speed + start.abs() * (1.0 + start.abs() / deceleration);
        let steps = 400;
        let step = duration / f64::from(steps);
        let mut last = plan.at(0.0);
        assert!(
            last.position == 0.0 && (last.velocity - start).abs() <= 1e-9 * scale
                || duration == 0.0
        );
        for i in 1..=steps {
            let now = plan.at(step * f64::from(i));
            let change = (now.velocity - last.velocity).abs();
            assert!(change <= acceleration.max(deceleration) * step + 1e-6 * scale);
            assert!(now.velocity.abs() <= speed.max(last.velocity.abs()) + 1e-9 * scale);
            let (low, high) = (
                last.velocity.min(now.velocity),
                last.velocity.max(now.velocity),
            );
            // Between two samples the velocity leaves their range by less than what either limit allows.
            let bend = acceleration.max(deceleration) * step;
            let moved = now.position - last.position;
            assert!(
                moved >= (low - bend) * step - 1e-9 * scale
                    && moved <= (high + bend) * step + 1e-9 * scale
            );
            last = now;
        }
        let end = plan.at(duration);
        assert_eq!(
            (end.position, end.velocity, end.acceleration),
            (distance, 0.0, 0.0)
        );
        let before = plan.at(duration * (1.0 - 1e-9));
        assert!(
            (before.position - distance).abs() <= 1e-6 * scale,
            "{before:?} {distance}"
        );
    }
}

#[test]
fn no_limit_is_left_unused() {
    let mut random = Random::new(22);
    for _ in 0..20_000 {
        let mut positive = |limit: i64| random.logarithmic(limit) as f64 / 16.0;
        let (distance, speed) = (positive(1 << 24), positive(1 << 16));
        let (acceleration, deceleration) = (positive(1 << 14), positive(1 << 14));
        let duration = Trapezoid::plan(distance, 0.0, speed, acceleration, deceleration)
            .unwrap()
            .duration();
        // From rest: either the speed is reached, or the move is a triangle.
        let ramps = speed / acceleration + speed / deceleration;
        let covered = 0.5 * speed * ramps;
        let expected = if covered <= distance {
            ramps + (distance - covered) / speed
        } else {
            (2.0 * distance * (1.0 / acceleration + 1.0 / deceleration)).sqrt()
        };
        assert!(
            (duration - expected).abs() <= 1e-9 * expected,
            "{duration} {expected}"
        );
    }
}
