use super::*;

#[test]
fn follows_an_encoder_one_to_one_while_it_counts() {
    let mut motor = motor();
    motor.wire("encoder", 300.0).unwrap();
    say(&mut motor, "MF4");
    run(&mut motor, SECOND / 10);
    let before = motor.get(Register::Counter);
    assert!((before - 1000).abs() < 5, "{before}");
    say(&mut motor, "G");
    assert_eq!(motor.mode_letter(), 'F');
    run(&mut motor, SECOND);
    motor.wire("encoder", 0.0).unwrap();
    run(&mut motor, SECOND / 4);
    assert_eq!(position(&motor), motor.get(Register::Counter) - before);
    assert!(motor.is(Flag::Trajectory) && !motor.is_moving());
    say(&mut motor, "MF0");
    assert_eq!(motor.get(Register::Counter), 0);
}

#[test]
fn a_ratio_of_17_to_23_does_not_drift_over_ten_million_counts() {
    let mut motor = motor();
    say(&mut motor, "MFMUL=17 MFDIV=23 MFR G");
    assert_eq!(motor.mode_letter(), 'X');
    for speed in 1..60 {
        motor.wire("encoder", -100.0 * f64::from(speed)).unwrap();
        run(&mut motor, SECOND);
    }
    run(&mut motor, 25 * SECOND);
    for speed in (0..60).rev() {
        motor.wire("encoder", -100.0 * f64::from(speed)).unwrap();
        run(&mut motor, SECOND);
    }
    run(&mut motor, SECOND / 4);
    let master = i64::from(motor.get(Register::Counter));
    assert!(master < -10_000_000, "{master}");
    assert_eq!(
        motor.trajectory.position(),
        ((master * 17) << 16).div_euclid(23)
    );
    assert!((i64::from(position(&motor)) - master * 17 / 23).abs() <= 1);
}

#[test]
fn x_leaves_the_master_with_the_acceleration() {
    let mut motor = motor();
    motor.wire("encoder", 600.0).unwrap();
    say(&mut motor, "A=200 MF4 G");
    run(&mut motor, SECOND);
    assert!((motor.signals().velocity - 322_000.0).abs() < 20_000.0);
    say(&mut motor, "X");
    let samples = arrive(&mut motor);
    assert!((1400..1800).contains(&samples), "{samples}");
    run(&mut motor, SECOND / 4);
    assert_eq!(error(&motor), 0);
}

#[test]
fn follows_steps_and_directions() {
    let mut motor = motor();
    motor.wire("steps", 2000.0).unwrap();
    say(&mut motor, "MS0 MS G");
    run(&mut motor, SECOND);
    motor.wire("steps", -500.0).unwrap();
    run(&mut motor, SECOND);
    motor.wire("steps", 0.0).unwrap();
    run(&mut motor, SECOND / 4);
    assert_eq!(position(&motor), motor.get(Register::Counter));
    assert!((position(&motor) - 1500).abs() <= 2);
    say(&mut motor, "MFMUL=-3 MFDIV=2 MSR G");
    let before = (position(&motor), motor.get(Register::Counter));
    motor.wire("steps", 1000.0).unwrap();
    run(&mut motor, SECOND);
    motor.wire("steps", 0.0).unwrap();
    run(&mut motor, SECOND / 4);
    let steps = motor.get(Register::Counter) - before.1;
    assert!((position(&motor) - before.0 + steps * 3 / 2).abs() <= 1);
}

#[test]
fn a_cam_takes_its_table_from_the_array() {
    let table = |index: u8| [0i16, 1000, 1000, -500, 0][usize::from(index)];
    let mut motor = motor();
    motor.wire("encoder", 60.0).unwrap();
    say(&mut motor, "BASE=4000 SIZE=4 MF0 MC G");
    let mut seen = Vec::new();
    while motor.get(Register::Counter) < 6000 {
        motor.sample(table);
        if motor.get(Register::Counter) % 500 == 0 {
            seen.push((motor.get(Register::Counter), position(&motor)));
        }
    }
    seen.dedup_by_key(|(counter, _)| *counter);
    let expected = [
        (0, 0),
        (500, 500),
        (1000, 1000),
        (1500, 1000),
        (2000, 1000),
        (2500, 250),
        (3000, -500),
        (3500, -250),
        (4000, 0),
        (4500, 500),
        (5000, 1000),
    ];
    for (counter, place) in expected {
        let near = seen.iter().find(|(at, _)| *at == counter).unwrap().1;
        assert!(
            (near - place).abs() <= 12,
            "at {counter}: {near}, not {place}"
        );
    }
    assert_eq!(motor.mode_letter(), 'C');
}
