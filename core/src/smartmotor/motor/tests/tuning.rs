use super::*;

/// A move of ten revolutions at 20 rev/s and 250 rev/s²: the largest error on the way, and the largest in the second
/// half of the second that follows.
fn quality(motor: &mut Motor) -> (i32, i32) {
    say(motor, "A=1979 V=644251 P=20000 G");
    let mut worst = 0;
    while motor.is(Flag::Trajectory) {
        run(motor, 1);
        worst = worst.max(error(motor).abs());
    }
    run(motor, SECOND / 2);
    let mut rest = 0;
    for _ in 0..SECOND / 2 {
        run(motor, 1);
        rest = rest.max((position(motor) - 20_000).abs());
    }
    (worst, rest)
}

#[test]
fn the_default_tuning_moves_a_loaded_axis_well() {
    for inertia in ["0.5", "1", "2", "3"] {
        let mut motor = motor();
        motor.configure("x", "inertia", inertia).unwrap();
        let (worst, rest) = quality(&mut motor);
        assert!(worst < 40 && rest == 0, "{inertia}: {worst} {rest}");
    }
}

#[test]
fn too_much_kp_and_no_kd_oscillates_until_the_error_trips() {
    let mut motor = motor();
    say(&mut motor, "KP=800 KD=0 F E=300 A=1979 V=644251 D=2000 G");
    let mut turned = 0;
    let mut last = 0.0;
    for _ in 0..4 * SECOND {
        run(&mut motor, 1);
        let velocity = motor.plant.velocity();
        turned += u32::from(velocity * last < 0.0);
        last = velocity;
    }
    assert!(
        motor.is(Flag::PositionError) && motor.is(Flag::Off),
        "{}",
        bits(&motor)
    );
    assert!(turned > 10, "{turned}");
    assert_eq!(
        (motor.mode_letter(), motor.fault_words().as_deref()),
        ('E', Some("position error"))
    );
    say(&mut motor, "KP=42 KD=550 F D=0 G");
    assert!(!motor.is(Flag::PositionError) && !motor.is(Flag::Off));
}

#[test]
fn feed_forward_takes_the_lag_away() {
    let lag = |tuning| {
        let mut motor = motor();
        motor.configure("x", "viscous", "0.2").unwrap();
        say(&mut motor, "KI=0");
        say(&mut motor, tuning);
        say(&mut motor, "F A=1979 V=644251 P=20000 G");
        let mut worst = 0;
        while motor.is(Flag::Trajectory) {
            run(&mut motor, 1);
            worst = worst.max(error(&motor).abs());
        }
        worst
    };
    let (without, with) = (lag("KV=0"), lag("KV=6400 KA=1380"));
    assert!(without > 20 && with < 6, "{without} {with}");
}

/// Whatever the way, the axis is on its count a tenth of a second after the trajectory, and stays there.
#[test]
fn every_move_settles() {
    for inertia in ["0.3", "1", "2", "4"] {
        let mut motor = motor();
        motor.configure("x", "inertia", inertia).unwrap();
        for step in 0..40 {
            let distance = step * 971 % 4001 - 2000;
            let speed = 100_000 + step * 9973;
            say(&mut motor, &format!("A=2000 V={speed} D={distance} G"));
            arrive(&mut motor);
            run(&mut motor, SECOND / 10);
            for _ in 0..SECOND / 10 {
                assert_eq!(error(&motor), 0, "inertia {inertia}, {distance} at {speed}");
                run(&mut motor, 1);
            }
        }
    }
}

#[test]
fn a_weight_needs_the_integral_or_kg() {
    let mut motor = motor();
    motor.configure("x", "pull", "0.06").unwrap();
    say(&mut motor, "KI=0 F A=1000 V=100000 D=0 G");
    run(&mut motor, SECOND);
    assert!(error(&motor) >= 3, "{}", error(&motor));
    say(&mut motor, "KG=61 KGON F");
    run(&mut motor, SECOND);
    say(&mut motor, "D=100 G");
    arrive(&mut motor);
    run(&mut motor, SECOND);
    assert!(error(&motor).abs() <= 1, "{}", error(&motor));
    say(&mut motor, "KGOFF");
    run(&mut motor, SECOND);
    assert!(error(&motor) >= 3);
    say(&mut motor, "KI=28 KL=200 F");
    run(&mut motor, 2 * SECOND);
    assert_eq!(error(&motor), 0);
}

#[test]
fn the_error_limit_is_met_exactly() {
    let mut motor = motor();
    motor.fault("stall", None, true).unwrap();
    say(&mut motor, "AMPS=500 E=200 A=1000 V=100000 P=200 G");
    arrive(&mut motor);
    run(&mut motor, 100);
    assert_eq!((motor.is(Flag::PositionError), error(&motor)), (false, 200));
    say(&mut motor, "E=199");
    run(&mut motor, 1);
    assert!(motor.is(Flag::PositionError));
}
