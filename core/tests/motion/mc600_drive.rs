//! What a program can see of the MC-600's drive: enabling, faults, emergency stops, limit switches.

use motionbench_core::mc600::machine::{Machine, MotionCommand};
use motionbench_core::mc600::sysvars::SysVar;

use crate::bench::{IDLE, PLANNER_BITS, enabled, move_is_over, powered, run, until};

#[test]
fn a_motion_commanded_while_disabled_is_ignored() {
    let mut machine = powered();
    for command in [
        MotionCommand::Move(5000),
        MotionCommand::MoveBy(5000),
        MotionCommand::Speed(5000),
    ] {
        machine.command(command);
        run(&mut machine, 10);
        assert_eq!(machine.get(SysVar::GvStatus), IDLE | 0b10_0001);
        assert_eq!(machine.get(SysVar::MvFlag), 1);
    }
    machine.command(MotionCommand::EnableDrive);
    run(&mut machine, 100);
    assert_eq!(machine.get(SysVar::GvFeedback), 0);
}

#[test]
fn the_enable_sequence_takes_a_step_a_sample() {
    let mut machine = powered();
    let drive_bits = |machine: &Machine| machine.get(SysVar::GvStatus) & 0x3FF;
    assert_eq!(
        (drive_bits(&machine), machine.get(SysVar::GvCommand)),
        (0b10_0001, 6)
    );
    machine.command(MotionCommand::EnableDrive);
    assert_eq!(machine.get(SysVar::GvCommand), 15);
    machine.sample();
    assert_eq!(drive_bits(&machine), 0b10_0011);
    machine.sample();
    assert_eq!(drive_bits(&machine), 0b10_0111);
    machine.wire("in12", 0.0).unwrap();
    machine.sample();
    assert_eq!(
        drive_bits(&machine),
        0b110_0000,
        "without the ENABLE input: switch-on inhibit"
    );
    machine.wire("in12", 1.0).unwrap();
    machine.command(MotionCommand::DisableDrive);
    machine.sample();
    assert_eq!(
        (drive_bits(&machine), machine.get(SysVar::GvCommand)),
        (0b10_0001, 6)
    );
    machine.set(SysVar::GvCommand, 15);
    run(&mut machine, 2);
    assert!(machine.is_enabled());
}

#[test]
fn a_disabled_motor_coasts_and_the_demand_follows_it() {
    let mut machine = enabled();
    machine.command(MotionCommand::Speed(34_952));
    run(&mut machine, 600);
    machine.command(MotionCommand::DisableDrive);
    let left = machine.get(SysVar::GvFeedback);
    run(&mut machine, 20);
    assert!(machine.get(SysVar::GvFeedback) > left + 1000, "it coasts");
    assert!(
        machine.get(SysVar::SlPosDemand) > left + 1000,
        "the demand follows"
    );
    assert_eq!(machine.get(SysVar::GvStatus) & PLANNER_BITS, IDLE);
    until(&mut machine, |m| !m.is_moving());
    run(&mut machine, 1);
    assert_eq!(
        machine.get(SysVar::SlPosDemand),
        machine.get(SysVar::GvFeedback)
    );
    let rest = machine.get(SysVar::GvFeedback);
    machine.command(MotionCommand::EnableDrive);
    run(&mut machine, 100);
    assert_eq!(
        machine.get(SysVar::GvFeedback),
        rest,
        "no jump when it is enabled again"
    );
}

#[test]
fn enabling_a_turning_motor_stops_it_smoothly() {
    let mut machine = enabled();
    machine.command(MotionCommand::Speed(34_952));
    run(&mut machine, 600);
    machine.command(MotionCommand::DisableDrive);
    run(&mut machine, 10);
    machine.command(MotionCommand::EnableDrive);
    machine.sample();
    let mut last = machine.signals();
    for _ in 0..600 {
        machine.sample();
        let signals = machine.signals();
        assert!(
            (signals.demand_velocity - last.demand_velocity).abs() <= 70.0,
            "{signals:?}"
        );
        assert!(
            (signals.velocity - last.velocity).abs() < 500.0 && signals.following_error.abs() < 3.0,
            "{signals:?}"
        );
        last = signals;
    }
    assert_eq!(machine.get(SysVar::SlSpdDemand), 0);
    assert!(machine.is_enabled());
}

#[test]
fn faults_are_latched_until_they_are_mended_and_cleared() {
    for (kind, words) in [("drive", "F14 output stage"), ("encoder", "F04 feedback")] {
        let mut machine = enabled();
        machine.command(MotionCommand::Move(100_000));
        run(&mut machine, 300);
        machine.fault(kind, Some("x"), true).unwrap();
        run(&mut machine, 2);
        assert_eq!(machine.get(SysVar::GvStatus), IDLE | 0b10_1000, "{kind}");
        assert_eq!(machine.get(SysVar::MvFlag), 1, "the move is gone");
        assert_eq!(machine.fault_words().as_deref(), Some(words));
        machine.command(MotionCommand::ClearFault);
        run(&mut machine, 2);
        assert_eq!(
            machine.get(SysVar::GvStatus),
            IDLE | 0b10_1000,
            "{kind} is not mended"
        );
        machine.fault(kind, None, false).unwrap();
        machine.command(MotionCommand::EnableDrive);
        run(&mut machine, 5);
        assert!(!machine.is_enabled(), "{kind} is not cleared");
        machine.command(MotionCommand::ClearFault);
        run(&mut machine, 500);
        assert_eq!(machine.get(SysVar::GvStatus), IDLE | 0b10_0001);
        assert_eq!(machine.fault_words(), None);
        machine.command(MotionCommand::EnableDrive);
        machine.command(MotionCommand::Move(100_000));
        until(&mut machine, move_is_over);
        assert_eq!(machine.get(SysVar::SlPosDemand), 100_000, "{kind}");
    }
}

#[test]
fn a_shaft_that_cannot_follow_trips_the_drive() {
    let jam = |machine: &mut Machine| machine.fault("stall", None, true).unwrap();
    let stop = |machine: &mut Machine| machine.configure("x", "travel", "-1rev..1rev").unwrap();
    for block in [jam, stop] {
        let mut machine = enabled();
        block(&mut machine);
        machine.command(MotionCommand::Move(100_000));
        until(&mut machine, |m| m.get(SysVar::GvStatus) & (1 << 3) != 0);
        assert_eq!(
            machine.get(SysVar::GvStatus) & 0x3FF,
            0b1_0010_1000,
            "error and following error"
        );
        machine.command(MotionCommand::ClearFault);
        run(&mut machine, 2);
        assert_eq!(machine.get(SysVar::GvStatus), IDLE | 0b10_0001);
        assert!(machine.get(SysVar::GvFeedback) <= 4096);
        assert!(!machine.is_moving());
    }
}

#[test]
fn an_emergency_stop_brakes_then_disables() {
    let mut machine = enabled();
    machine.command(MotionCommand::Speed(34_952));
    run(&mut machine, 600);
    machine.fault("estop", None, true).unwrap();
    machine.sample();
    let velocity = machine.get(SysVar::SlSpdDemand);
    assert_eq!(34_952 - velocity, 1398, "20 rpm/ms");
    assert_eq!(
        machine.get(SysVar::GvStatus) & 0x3FF,
        0b111,
        "in emergency stop, still held"
    );
    let samples = until(&mut machine, |m| !m.is_enabled());
    assert!((25..30).contains(&samples), "{samples}");
    machine.command(MotionCommand::EnableDrive);
    machine.command(MotionCommand::Move(0));
    run(&mut machine, 10);
    assert_eq!(machine.get(SysVar::GvStatus), IDLE | 0b100_0000);
    machine.fault("estop", None, false).unwrap();
    run(&mut machine, 10);
    assert_eq!(
        machine.get(SysVar::GvStatus),
        IDLE | 0b10_0001,
        "it waits for mdrven"
    );
}

#[test]
fn bit_2_of_the_command_is_an_emergency_stop_that_holds() {
    let mut machine = enabled();
    machine.command(MotionCommand::Speed(34_952));
    run(&mut machine, 600);
    machine.set(SysVar::GvCommand, 0b1011);
    run(&mut machine, 30);
    assert_eq!(
        (machine.get(SysVar::SlSpdDemand), machine.is_enabled()),
        (0, true)
    );
    machine.command(MotionCommand::Move(0));
    assert_eq!(
        machine.get(SysVar::MvFlag),
        1,
        "no motion while the stop is held"
    );
    machine.set(SysVar::GvCommand, 0b1111);
    machine.command(MotionCommand::Move(0));
    until(&mut machine, move_is_over);
    assert_eq!(machine.get(SysVar::SlPosDemand), 0);
    machine.command(MotionCommand::Speed(1000));
    run(&mut machine, 20);
    machine.set(SysVar::GvCommand, 0b1101);
    run(&mut machine, 5);
    assert_eq!(
        machine.get(SysVar::GvStatus),
        IDLE | 0b100_0000,
        "bit 1 disables after the stop"
    );
}

#[test]
fn a_limit_switch_stops_one_direction_and_frees_the_other() {
    let mut machine = enabled();
    machine.configure("x", "limits", "-5000..5000").unwrap();
    machine.command(MotionCommand::Move(20_000));
    until(&mut machine, |m| !m.is_moving());
    let stopped = machine.get(SysVar::SlPosDemand);
    assert!((5000..5300).contains(&stopped), "{stopped}");
    assert_eq!(machine.get(SysVar::GvStatus), IDLE | 0b1010_0111, "warning");
    machine.command(MotionCommand::MoveBy(1000));
    run(&mut machine, 100);
    assert_eq!(machine.get(SysVar::SlPosDemand), stopped);
    machine.command(MotionCommand::Move(0));
    until(&mut machine, move_is_over);
    assert_eq!(
        (
            machine.get(SysVar::SlPosDemand),
            machine.get(SysVar::GvStatus)
        ),
        (0, IDLE | 0b10_0111)
    );

    machine.fault("limit-", Some("x"), true).unwrap();
    machine.command(MotionCommand::Move(-100));
    run(&mut machine, 100);
    assert_eq!(machine.get(SysVar::SlPosDemand), 0);
}
