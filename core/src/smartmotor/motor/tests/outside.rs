use super::*;

#[test]
fn all_pins_are_inputs_that_are_pulled_up() {
    let mut motor = motor();
    for port in Port::ALL {
        assert_eq!(motor.get(Register::Pin(port)), 1);
        assert_eq!(motor.get(Register::Analog(port)), 1023);
    }
    motor.wire("UA", 0.0).unwrap();
    motor.wire("UB", 2.5).unwrap();
    motor.wire("UEA", 1.0).unwrap();
    assert_eq!(motor.get(Register::Pin(Port::A)), 0);
    assert_eq!(motor.get(Register::Analog(Port::B)), 512);
    assert_eq!(motor.get(Register::Analog(Port::E)), 205);
    motor.wire("UA", 1.0).unwrap();
    assert_eq!(motor.get(Register::Pin(Port::A)), 1);
    say(&mut motor, "UA=0 UAO");
    assert_eq!(motor.get(Register::Pin(Port::A)), 0);
    for wrong in [
        ("UH", 1.0),
        ("UA", 6.0),
        ("UA", -1.0),
        ("UA", f64::NAN),
        ("x", 0.0),
    ] {
        assert!(motor.wire(wrong.0, wrong.1).is_err());
    }
    for name in Motor::wires() {
        motor.wire(&name, 1.0).unwrap();
    }
}

#[test]
fn the_go_input_starts_what_is_buffered() {
    let mut motor = motor();
    say(&mut motor, "A=1000 V=400000 D=500");
    run(&mut motor, 10);
    for expected in [500, 1000] {
        motor.wire("UG", 0.0).unwrap();
        run(&mut motor, 1);
        arrive(&mut motor);
        run(&mut motor, SECOND / 4);
        assert_eq!(
            position(&motor),
            expected,
            "once for each time that it goes low"
        );
        motor.wire("UG", 1.0).unwrap();
        run(&mut motor, 10);
    }
    say(&mut motor, "UGI");
    motor.wire("UG", 0.0).unwrap();
    run(&mut motor, 10);
    assert!(!motor.is(Flag::Trajectory));
    say(&mut motor, "UG");
    run(&mut motor, 10);
    assert!(!motor.is(Flag::Trajectory));
}

#[test]
fn a_limit_switches_the_motor_off_and_is_left_the_other_way() {
    let mut motor = motor();
    say(&mut motor, "MV A=1000 V=400000 G");
    run(&mut motor, SECOND / 4);
    motor.fault("limit+", None, true).unwrap();
    run(&mut motor, 1);
    assert!(bits(&motor).contains('o') && bits(&motor).contains('r') && bits(&motor).contains('p'));
    run(&mut motor, SECOND);
    say(&mut motor, "G");
    run(&mut motor, 2);
    assert!(motor.is(Flag::Off), "not further into the limit");
    say(&mut motor, "V=-400000 G");
    run(&mut motor, SECOND / 4);
    assert!(!motor.is(Flag::Off) && motor.signals().velocity < -300_000.0);
    say(&mut motor, "Zr");
    run(&mut motor, 1);
    assert!(motor.is(Flag::RightLimit), "it is active still");
    motor.fault("limit+", None, false).unwrap();
    run(&mut motor, 1);
    say(&mut motor, "ZS");
    assert!(!motor.is(Flag::RightLimit) && !motor.is(Flag::RightNow));
}

#[test]
fn f_1_decelerates_at_a_limit_and_f_32_calls_the_fault_routine() {
    let mut motor = motor();
    say(&mut motor, "F=33 MV A=1000 V=-400000 G");
    run(&mut motor, SECOND / 4);
    assert!(!motor.take_fault_call());
    motor.wire("UD", 0.0).unwrap();
    run(&mut motor, 1);
    assert!(motor.is(Flag::LeftLimit) && motor.is(Flag::Trajectory));
    assert!(motor.take_fault_call() && !motor.take_fault_call());
    let samples = arrive(&mut motor);
    assert!((395..=401).contains(&samples), "{samples}");
    assert!(!motor.is(Flag::Off));
    say(&mut motor, "G");
    run(&mut motor, 5);
    assert!(!motor.is(Flag::Trajectory) && !motor.is(Flag::Off));
}

#[test]
fn limd_lets_a_motor_that_leaves_a_limit_go_on() {
    for (word, stopped) in [("LIMN", true), ("LIMD", false)] {
        let mut motor = motor();
        say(&mut motor, "MV A=1000 V=400000 G");
        say(&mut motor, word);
        run(&mut motor, SECOND / 4);
        motor.fault("limit-", None, true).unwrap();
        run(&mut motor, 10);
        assert_eq!(motor.is(Flag::Off), stopped, "{word}");
    }
}

#[test]
fn limits_can_be_plain_inputs_or_active_high() {
    let mut motor = motor();
    say(&mut motor, "UCI UDI MV A=1000 V=400000 G");
    motor.fault("limit+", None, true).unwrap();
    run(&mut motor, SECOND / 4);
    assert!(motor.is(Flag::Trajectory) && motor.get(Register::Pin(Port::C)) == 0);
    motor.fault("limit+", None, false).unwrap();
    say(&mut motor, "UCP LIMH");
    run(&mut motor, 2);
    assert!(
        motor.is(Flag::RightNow) && motor.is(Flag::Off),
        "an open pin is high"
    );
}

#[test]
fn homes_on_a_limit_switch_and_on_the_index() {
    let mut motor = motor();
    motor.configure("x", "limits", "-3333..50000").unwrap();
    // A program would say: F=1 MV A=1000 V=-200000 G TWAIT ZS, then look for the index the other way.
    say(&mut motor, "F=1 MV A=1000 V=-200000 G");
    arrive(&mut motor);
    assert!(motor.is(Flag::LeftLimit) && position(&motor) < -3333);
    motor.read(Register::Index);
    say(&mut motor, "V=50000 G");
    while !motor.is(Flag::IndexCaptured) {
        run(&mut motor, 1);
    }
    assert_eq!(motor.get(Register::Index), -2000);
    say(&mut motor, "X");
    arrive(&mut motor);
    let index = motor.read(Register::Index);
    assert!(!motor.is(Flag::IndexCaptured));
    say(&mut motor, &format!("MP P={index} G"));
    arrive(&mut motor);
    run(&mut motor, SECOND / 4);
    say(&mut motor, "O=0 ZS");
    assert_eq!((position(&motor), motor.is(Flag::IndexLevel)), (0, true));
    assert_eq!(motor.plant.encoder.count(), -2000);
}

#[test]
fn the_home_switch_is_on_pin_e() {
    let mut motor = motor();
    motor.configure("x", "home", "1000").unwrap();
    run(&mut motor, 1);
    assert_eq!(motor.get(Register::Pin(Port::E)), 1);
    say(&mut motor, "A=1000 V=400000 P=1200 G");
    arrive(&mut motor);
    run(&mut motor, SECOND / 4);
    assert_eq!(motor.get(Register::Pin(Port::E)), 0);
}

#[test]
fn a_lasting_overload_heats_the_motor_until_it_trips() {
    let mut motor = motor();
    motor.fault("stall", None, true).unwrap();
    say(&mut motor, "MT T=1023");
    run(&mut motor, SECOND);
    assert!(motor.is(Flag::OverCurrent) && motor.get(Register::Current) == 1000);
    assert_eq!(motor.get(Register::Supply), 470);
    run(&mut motor, 9 * SECOND);
    assert!(motor.is(Flag::Overheat) && motor.is(Flag::Off));
    assert!((65..=71).contains(&motor.get(Register::Temperature)));
    say(&mut motor, "MT");
    run(&mut motor, 1);
    assert!(motor.is(Flag::Off), "not before it has cooled");
    run(&mut motor, 20 * SECOND);
    say(&mut motor, "ZS D=0 G");
    assert!(!motor.is(Flag::Off) && !motor.is(Flag::OverCurrent));
}

#[test]
fn the_brake_holds_a_weight_as_its_word_says() {
    let mut motor = motor();
    motor.configure("x", "pull", "0.2").unwrap();
    let falls = |motor: &mut Motor| {
        let before = motor.plant.position();
        run(motor, SECOND / 4);
        motor.plant.position() < before - 0.01
    };
    assert!(falls(&mut motor), "released at power-up");
    say(&mut motor, "BRKSRV BRKC");
    run(&mut motor, 1);
    assert!(!falls(&mut motor));
    run(&mut motor, 1);
    assert_eq!(motor.get(Register::Pin(Port::C)), 0);
    say(&mut motor, "KL=500 F A=1000 V=100000 D=500 G");
    run(&mut motor, 2);
    assert_eq!(motor.get(Register::Pin(Port::C)), 1);
    arrive(&mut motor);
    run(&mut motor, SECOND);
    assert_eq!(error(&motor), 0);
    say(&mut motor, "OFF");
    assert!(!falls(&mut motor));
    say(&mut motor, "BRKRLS");
    assert!(falls(&mut motor));
    say(&mut motor, "BRKTRJ");
    run(&mut motor, 1);
    assert!(!falls(&mut motor));
    say(&mut motor, "D=500 G");
    arrive(&mut motor);
    run(&mut motor, 10);
    assert!(!motor.is_moving() && !motor.is(Flag::Off));
    say(&mut motor, "BRKENG");
    motor.power_off();
    assert!(!falls(&mut motor));
}

#[test]
fn the_emergency_stop_takes_the_power_and_engages_the_brake() {
    let mut motor = motor();
    say(&mut motor, "F=32 MV A=1000 V=400000 G");
    run(&mut motor, SECOND / 4);
    motor.fault("estop", None, true).unwrap();
    run(&mut motor, 2);
    assert!(motor.is(Flag::Off) && !motor.is(Flag::Trajectory) && motor.take_fault_call());
    assert_eq!(motor.plant.velocity(), 0.0);
    assert_eq!(motor.fault_words().as_deref(), Some("emergency stop"));
    say(&mut motor, "G");
    run(&mut motor, 2);
    assert!(motor.is(Flag::Off));
    motor.fault("estop", None, false).unwrap();
    run(&mut motor, SECOND);
    assert!(motor.is(Flag::Off) && motor.fault_words().is_none());
    say(&mut motor, "G");
    run(&mut motor, SECOND / 4);
    assert!(motor.signals().velocity > 300_000.0);
}

#[test]
fn broken_things_switch_the_motor_off() {
    let mut motor = motor();
    say(&mut motor, "MV A=1000 V=400000 G");
    motor.fault("encoder", None, true).unwrap();
    run(&mut motor, SECOND);
    assert!(motor.is(Flag::PositionError));
    motor.fault("encoder", None, false).unwrap();
    motor.fault("drive", Some("x"), true).unwrap();
    say(&mut motor, "G");
    run(&mut motor, 1);
    assert!(motor.is(Flag::Off) && motor.is(Flag::OverCurrent));
    motor.fault("drive", None, false).unwrap();
    run(&mut motor, 5 * SECOND);
    say(&mut motor, "ZS G");
    run(&mut motor, 10);
    assert!(!motor.is(Flag::Off) && !motor.is(Flag::OverCurrent));
    assert!(motor.fault("fire", None, true).is_err());
    assert!(motor.fault("stall", Some("y"), true).is_err());
}
