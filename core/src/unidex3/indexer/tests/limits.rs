use super::*;

/// 4-10: a limit stops both axes, and no count is lost.
#[test]
fn a_limit_stops_both_axes_with_true_registers() {
    let mut unit = Unit::stepper();
    unit.configure("x", "limits", "-1000..1000");
    unit.start(Move::independent(
        Some(leg(5000, 10_000)),
        Some(leg(5000, 1000)),
        None,
    ));
    unit.run(200);
    assert_eq!(unit.events(), [Event::Limit(Axis::X)]);
    assert_eq!(
        (unit.registers(), unit.tracking()),
        ((1001, 100), (1001, 100))
    );
    assert!(unit.indexer.is_complete(true));
    assert!(unit.indexer.is_barred(Axis::X, Direction::Positive));
    assert!(!unit.indexer.is_barred(Axis::X, Direction::Negative));
    assert!(unit.indexer.limit(Axis::Y).is_none());
}

/// 4-10 B: a move further into a limit counts in the register only.
#[test]
fn a_move_further_into_a_limit_leaves_register_and_display_different() {
    for drive in [DriveKind::Dc, DriveKind::StepperLow] {
        let mut unit = Unit::new(drive);
        unit.configure("x", "limits", "..1000");
        unit.time(x(5000, 1000));
        unit.until(|indexer| !indexer.is_moving());
        assert_eq!(unit.events(), [Event::Limit(Axis::X)]);
        let stood = unit.tracking().0;
        assert_eq!(unit.registers().0, stood);

        unit.time(x(200, 1000));
        unit.until(|indexer| !indexer.is_moving());
        assert_eq!(
            (unit.registers().0, unit.tracking().0),
            (stood + 200, stood)
        );
        assert_eq!(unit.events(), []);

        unit.time(x(-400, 1000));
        unit.until(|indexer| !indexer.is_moving());
        assert_eq!(
            (unit.registers().0, unit.tracking().0),
            (stood - 200, stood - 400)
        );
        assert!(unit.indexer.limit(Axis::X).is_none());
        assert_eq!(unit.events(), []);
    }
}

#[test]
fn a_switch_that_bounces_while_it_is_left_is_a_second_limit() {
    let mut unit = Unit::stepper();
    unit.fault("limit-", "y", true);
    assert_eq!(unit.events(), [Event::Limit(Axis::Y)]);
    unit.indexer
        .slew(unit.now, Axis::Y, Direction::Positive, Feedrate::DEFAULT);
    unit.run(100);
    unit.fault("limit-", "y", false);
    unit.run(4);
    unit.fault("limit-", "y", true);
    unit.fault("limit-", "y", false);
    assert_eq!(unit.events(), [Event::Limit(Axis::Y)]);
    let stood = unit.registers();
    unit.run(100);
    assert_eq!((unit.registers(), stood), ((0, 26), (0, 26)));
}

#[test]
fn a_limit_at_power_up_is_a_state_and_no_event() {
    let mut unit = Unit::stepper();
    unit.indexer.power_off(unit.now);
    unit.fault("limit+", "x", true);
    assert!(unit.indexer.limit(Axis::X).is_none());
    unit.indexer.power_up(unit.now);
    unit.run(10);
    assert_eq!(unit.indexer.limit(Axis::X), Some(Direction::Positive));
    assert_eq!(unit.events(), []);
}

/// 4-10 D.
#[test]
fn the_joystick_backs_out_of_a_limit_by_its_direction() {
    let mut unit = Unit::stepper();
    unit.configure("x", "limits", "..100");
    unit.indexer.joystick(unit.now, Some(2));
    unit.wire("joyx", 2000.0);
    unit.run(200);
    assert_eq!(
        (unit.registers().0, unit.events()),
        (101, vec![Event::Limit(Axis::X)])
    );
    unit.wire("joyx", 1000.0);
    unit.run(100);
    assert_eq!(unit.registers().0, 101);
    unit.wire("joyx", -2000.0);
    unit.run(50);
    assert_eq!(unit.registers().0, 51);
}

#[test]
fn limits_bar_the_way_that_the_motor_turns() {
    let mut unit = Unit::of(Config {
        drive: DriveKind::StepperLow,
        reversed: Pair::same(true),
        ..Config::default()
    });
    unit.fault("limit+", "x", true);
    assert!(unit.indexer.is_barred(Axis::X, Direction::Negative));
    unit.time(x(100, 1000));
    unit.time(x(-50, 1000));
    assert_eq!((unit.registers().0, unit.tracking().0), (50, 100));
}

#[test]
fn broken_drives_lose_the_motor_and_keep_the_count() {
    let mut unit = Unit::dc();
    unit.fault("stall", "x", true);
    unit.start(x(50_000, 100_000));
    unit.until(|indexer| indexer.is_complete(true));
    assert_eq!((unit.registers().0, unit.tracking().0), (50_000, 0));
    assert_eq!(
        unit.indexer.fault_words(),
        Some("X: drive tripped".to_owned())
    );
    assert!(!unit.indexer.is_complete(false) && !unit.indexer.is_moving());
    unit.fault("stall", "x", false);
    unit.indexer.reset_drive(unit.now, Axis::X);
    unit.time(x(100, 1000));
    unit.until(|indexer| indexer.is_complete(false) && !indexer.is_moving());
    assert_eq!((unit.registers().0, unit.tracking().0), (50_100, 100));

    unit.fault("encoder", "x", true);
    unit.start(x(10_000, 10_000));
    unit.until(|indexer| indexer.fault_words().is_some());
    unit.run(1500);
    unit.fault("encoder", "x", false);
    unit.indexer.reset(unit.now);
    assert_eq!(unit.indexer.fault_words(), None);

    let mut unit = Unit::stepper();
    unit.fault("stall", "x", true);
    unit.time(x(500, 1000));
    unit.fault("stall", "x", false);
    unit.time(x(1000, 1000));
    assert_eq!((unit.registers().0, unit.tracking().0), (1500, 1500));
    assert_eq!(unit.indexer.signals(Axis::X).shaft, 0.5);
}

/// 5-2: the other axis is not waited for.
#[test]
fn a_move_waits_for_the_drives_of_its_own_axes() {
    let mut unit = Unit::dc();
    unit.fault("drive", "y", true);
    unit.start(x(100, 1000));
    unit.until(|indexer| indexer.is_complete(false));
    let order = Move::independent(Some(leg(100, 1000)), Some(leg(1, 1000)), None);
    unit.start(order);
    unit.run(1000);
    assert!(unit.indexer.is_complete(true) && !unit.indexer.is_complete(false));
}

#[test]
fn an_emergency_stop_takes_the_torque_until_the_drive_is_reset() {
    let mut unit = Unit::dc();
    unit.start(x(100_000, 10_000));
    unit.run(100);
    unit.fault("estop", "x", true);
    unit.run(2000);
    assert!(!unit.indexer.is_enabled());
    let stood = unit.tracking();
    unit.run(1000);
    assert_eq!(unit.tracking(), stood);
    unit.fault("estop", "x", false);
    unit.run(10);
    assert!(!unit.indexer.is_enabled());
    unit.indexer.reset_drive(unit.now, Axis::X);
    assert!(unit.indexer.is_enabled());
}

#[test]
fn without_mains_nothing_moves_and_a_weight_falls() {
    for drive in [DriveKind::Dc, DriveKind::StepperHigh] {
        let mut unit = Unit::new(drive);
        unit.configure("y", "pull", "0.1");
        unit.run(300);
        assert!(unit.indexer.signals(Axis::Y).shaft.abs() < 0.01);
        unit.start(x(1000, 1000));
        unit.run(100);
        unit.indexer.power_off(unit.now);
        unit.run(300);
        assert!(!unit.indexer.is_busy(Axis::X));
        assert!(unit.indexer.signals(Axis::Y).shaft < -1.0, "{drive:?}");
        unit.indexer.power_up(unit.now);
        unit.until(|indexer| !indexer.is_moving());
        assert_eq!(unit.registers(), (0, 0));
        let now = unit.tracking().1;
        unit.run(500);
        assert_eq!(unit.tracking().1, now, "{drive:?}");
    }
}
