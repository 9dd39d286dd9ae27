use super::*;

#[test]
fn a_move_takes_its_closed_form_time_and_ends_on_the_count() {
    let mut motor = motor();
    assert_eq!(bits(&motor), "ox");
    say(&mut motor, "A=100 V=100000 P=10000 G");
    assert!(!motor.is(Flag::Off));
    // 10000 x 65536 / 100000 and 100000 / 100.
    let expected = 6553.6 + 1000.0;
    assert!((f64::from(arrive(&mut motor)) - expected).abs() <= 1.0);
    run(&mut motor, SECOND / 4);
    assert_eq!((position(&motor), error(&motor)), (10_000, 0));
    assert_eq!(
        bits(&motor),
        "ix",
        "ten thousand counts are five revolutions"
    );
}

#[test]
fn a_distance_is_repeated_by_g() {
    let mut motor = motor();
    say(&mut motor, "A=500 V=400000 D=-700 G");
    assert_eq!(motor.mode_letter(), 'R');
    arrive(&mut motor);
    say(&mut motor, "G");
    arrive(&mut motor);
    run(&mut motor, SECOND / 4);
    assert_eq!(position(&motor), -1400);
    say(&mut motor, "P=50 G");
    arrive(&mut motor);
    run(&mut motor, SECOND / 4);
    assert_eq!((position(&motor), motor.mode_letter()), (50, 'P'));
}

#[test]
fn buffered_values_wait_for_g() {
    let mut motor = motor();
    say(&mut motor, "A=200 V=200000 P=40000 G");
    run(&mut motor, 2000);
    say(&mut motor, "V=50000 P=5000");
    run(&mut motor, 10);
    assert_eq!(motor.get(Register::ActualVelocity), 200_000);
    assert_eq!(motor.get(Register::Velocity), 50_000);
    say(&mut motor, "P=9000 G");
    run(&mut motor, 1000);
    assert_eq!(motor.get(Register::ActualVelocity), 50_000);
    arrive(&mut motor);
    run(&mut motor, SECOND / 4);
    assert_eq!(position(&motor), 9000);
}

#[test]
fn velocity_mode_turns_both_ways_and_x_and_s_stop() {
    let mut motor = motor();
    say(&mut motor, "MV A=100 V=-300000 G");
    run(&mut motor, 4000);
    assert_eq!(motor.get(Register::ActualVelocity), -300_000);
    assert!((motor.signals().velocity + 300_000.0).abs() < 15_000.0);
    say(&mut motor, "X");
    assert!((2999..=3001).contains(&arrive(&mut motor)));
    say(&mut motor, "V=300000 G");
    run(&mut motor, 4000);
    say(&mut motor, "S");
    assert!(!motor.is(Flag::Trajectory));
    run(&mut motor, SECOND);
    assert_eq!((error(&motor), motor.is_moving()), (0, false));
    say(&mut motor, "V=0 G");
    arrive(&mut motor);
    assert!(!motor.is(Flag::Off));
}

#[test]
fn the_origin_can_be_set_anywhere() {
    let mut motor = motor();
    say(&mut motor, "A=500 V=400000 P=3000 G");
    arrive(&mut motor);
    run(&mut motor, SECOND / 4);
    say(&mut motor, "O=-20");
    assert_eq!((position(&motor), error(&motor)), (-20, 0));
    say(&mut motor, "P=80 G");
    arrive(&mut motor);
    run(&mut motor, SECOND / 4);
    assert_eq!(position(&motor), 80);
    assert_eq!((motor.signals().shaft * 2000.0).floor(), 3100.0);
}

#[test]
fn off_coasts_and_g_catches_a_turning_motor() {
    let mut motor = motor();
    say(&mut motor, "MV A=500 V=600000 G");
    run(&mut motor, 2000);
    say(&mut motor, "OFF");
    assert!(motor.is(Flag::Off) && !motor.is(Flag::Trajectory) && motor.mode_letter() == 'O');
    run(&mut motor, 100);
    assert!(motor.signals().velocity > 300_000.0);
    say(&mut motor, "V=0 G");
    arrive(&mut motor);
    run(&mut motor, SECOND / 4);
    assert_eq!((error(&motor), motor.is(Flag::PositionError)), (0, false));
    motor.power_off();
    run(&mut motor, SECOND);
    assert!(!motor.is_enabled() && !motor.is_moving());
}

#[test]
fn torque_acts_at_once_and_amps_limit_it() {
    let mut motor = motor();
    say(&mut motor, "MT T=100");
    run(&mut motor, 100);
    assert_eq!((motor.output, motor.mode_letter()), (100, 'T'));
    assert!(motor.get(Register::ActualVelocity) > 0 && motor.get(Register::Current) > 90);
    say(&mut motor, "AMPS=30 T=-2000");
    run(&mut motor, 1);
    assert_eq!((motor.output, motor.get(Register::Torque)), (-30, -1023));
    say(&mut motor, "MP A=500 V=400000 P=0 G");
    assert_eq!(motor.mode_letter(), 'P');
    arrive(&mut motor);
}

#[test]
fn positions_go_around_the_32_bits() {
    let mut motor = motor();
    say(&mut motor, "O=2147483600 A=500 V=400000 D=100 G");
    arrive(&mut motor);
    run(&mut motor, SECOND / 4);
    assert_eq!(position(&motor), i32::MIN + 52);
    assert!(motor.is(Flag::Wrap));
    say(&mut motor, "Zw P=2147483640 G");
    assert!(!motor.is(Flag::Wrap));
    arrive(&mut motor);
    run(&mut motor, SECOND / 4);
    assert_eq!(position(&motor), 2_147_483_640, "the shorter way");
    assert!(motor.is(Flag::Wrap));
}

#[test]
fn a_slower_servo_counts_slower_and_moves_slower() {
    let mut motor = motor();
    say(&mut motor, "PID4 CLK=0 MV A=100 V=100000 G");
    run(&mut motor, 4000);
    assert_eq!(motor.get(Register::Clock), 1000);
    assert_eq!(motor.get(Register::ActualVelocity), 100_000);
    let speed = motor.plant.velocity();
    assert!(
        (speed - 100_000.0 / 32_212.578 / 4.0).abs() < 0.2,
        "{speed}"
    );
}

#[test]
fn a_contour_goes_through_its_positions() {
    let mut motor = motor();
    say(&mut motor, "MD");
    for (position, time) in [(500, 1024), (500, 256), (-300, 2048), (-300, 0)] {
        motor.stream_position(position);
        motor.stream_time(time);
    }
    assert_eq!(motor.stream_status().free, 12);
    say(&mut motor, "G");
    assert_eq!((motor.mode_letter(), motor.stream_status().state), ('H', 1));
    run(&mut motor, 1024 + 128);
    assert_eq!(motor.signals().demand_position, 500.0);
    run(&mut motor, 128 + 2048 + 1);
    assert!(!motor.is(Flag::Trajectory));
    run(&mut motor, SECOND / 4);
    assert_eq!((position(&motor), motor.stream_status().state), (-300, 0));
}

#[test]
fn words_of_commands_and_registers_are_their_own_text() {
    for word in [
        "G", "MFR", "MC2", "UAI", "UGO", "UCP", "Zw", "ZS", "BRKTRJ", "PID8", "F",
    ] {
        assert_eq!(Command::from_word(word).unwrap().to_string(), word);
    }
    for word in ["KP", "O", "UA", "CLK", "MFDIV", "F"] {
        assert_eq!(Register::writable(word).unwrap().to_string(), word);
    }
    assert_eq!(Register::readable("UBA"), Some(Register::Analog(Port::B)));
    assert_eq!(Register::readable("UBI"), Some(Register::Pin(Port::B)));
    assert_eq!(
        (Register::readable("O"), Register::writable("@P")),
        (None, None)
    );
    assert_eq!(
        (Command::from_word("UHI"), Command::from_word("Ze")),
        (None, None)
    );
}
