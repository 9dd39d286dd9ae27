//! Homing against the plant's switches, zero marks and stops.

use motionbench_core::mc600::machine::Machine;
use motionbench_core::mc600::sysvars::SysVar;

use crate::bench::{HOME, PLANNER_BITS, call, enabled, run, until};

const DREF: i32 = 0x352C;
const NREF: i32 = 0x35AD;
const ROFFS: i32 = 0x35E7;
const VREF: i32 = 0x3628;

/// Homes at 1 rev/s and gives where the axis stands afterwards, in revolutions of its shaft since it was built.
fn home(machine: &mut Machine, kind: i32, direction: i32) -> f64 {
    machine.write_object(NREF, kind);
    machine.write_object(DREF, direction);
    call(machine, "MHOME", &[1]);
    assert_eq!(machine.get(SysVar::HmFlag), 1);
    assert_eq!(machine.get(SysVar::GvStatus) & PLANNER_BITS, HOME);
    until(machine, |m| m.get(SysVar::GvStatus) & HOME == 0);
    run(machine, 100);
    machine.signals().shaft
}

fn is_done(machine: &Machine) -> bool {
    machine.get(SysVar::HmFlag) == 2 && machine.get(SysVar::GvMflag) & 16 != 0
}

#[test]
fn the_reference_switch_with_and_without_zero_mark() {
    for (kind, direction, place) in [
        (3, 1, 2.3),
        (1, 1, 3.0),
        // From the other side the switch is beyond the limit's reversal.
        (3, 0, 2.3),
    ] {
        let mut machine = enabled();
        machine.configure("x", "home", "2.3rev..2.6rev").unwrap();
        machine.configure("x", "limits", "-1.5rev..5rev").unwrap();
        machine.write_object(ROFFS, 5000);
        let shaft = home(&mut machine, kind, direction);
        assert!(is_done(&machine), "NREF {kind}");
        let edge = if direction == 0 { 2.6 } else { place };
        assert!(
            (shaft - edge).abs() < 0.002,
            "NREF {kind} {direction}: {shaft}"
        );
        assert_eq!(machine.get(SysVar::GvFeedback), 2048, "ROFFS");
        assert_eq!(machine.get(SysVar::SlPosDemand), 2048);
    }
}

#[test]
fn an_axis_on_its_switch_leaves_it_first() {
    let mut machine = enabled();
    machine.configure("x", "home", "-0.2rev..0.3rev").unwrap();
    let shaft = home(&mut machine, 3, 1);
    assert!((shaft + 0.2).abs() < 0.002, "{shaft}");
    assert_eq!(machine.get(SysVar::GvFeedback), 0);
}

#[test]
fn the_limit_switch_with_and_without_zero_mark() {
    for (kind, direction, place) in [(4, 1, 1.4), (4, 0, -1.7), (2, 1, 1.0), (2, 0, -1.0)] {
        let mut machine = enabled();
        machine.configure("x", "limits", "-1.7rev..1.4rev").unwrap();
        let shaft = home(&mut machine, kind, direction);
        assert!(is_done(&machine), "NREF {kind}");
        assert!(
            (shaft - place).abs() < 0.002,
            "NREF {kind} {direction}: {shaft}"
        );
        assert_eq!(machine.get(SysVar::GvFeedback), 0);
    }
}

#[test]
fn the_next_zero_mark() {
    for (direction, place) in [(1, 1.0), (0, 0.0), (2, 0.0)] {
        let mut machine = enabled();
        call(&mut machine, "MMOVE", &[1400]);
        until(&mut machine, |m| !m.is_moving());
        let shaft = home(&mut machine, 5, direction);
        assert!((shaft - place).abs() < 0.001, "{direction}: {shaft}");
        assert_eq!(machine.get(SysVar::GvFeedback), 0);
    }
}

#[test]
fn the_mechanical_stop() {
    let mut machine = enabled();
    machine.configure("x", "travel", "-4rev..1.4rev").unwrap();
    let shaft = home(&mut machine, 7, 1);
    assert!(is_done(&machine) && machine.is_enabled());
    assert!((shaft - 1.0).abs() < 0.001, "{shaft}");
    assert_eq!(machine.get(SysVar::GvFeedback), 0);
    assert!(machine.signals().following_error.abs() < 1.0);
}

#[test]
fn setting_the_position_moves_nothing() {
    for kind in [0, 6] {
        let mut machine = enabled();
        call(&mut machine, "MMOVE", &[1400]);
        until(&mut machine, |m| !m.is_moving());
        machine.write_object(ROFFS, -10_000);
        let before = machine.signals().shaft;
        let shaft = home(&mut machine, kind, 1);
        assert!((shaft - before).abs() < 0.001);
        assert_eq!(machine.get(SysVar::GvFeedback), -4096);
        call(&mut machine, "MMOVE", &[0]);
        until(&mut machine, |m| !m.is_moving());
        assert!((machine.signals().shaft - before - 1.0).abs() < 0.001);
    }
}

#[test]
fn the_absolute_position_is_a_target() {
    let mut machine = enabled();
    machine.wire("ssi", 3000.0).unwrap();
    let shaft = home(&mut machine, 8, 1);
    assert!((shaft - 3000.0 / 4096.0).abs() < 0.001, "{shaft}");
    assert_eq!(machine.get(SysVar::GvFeedback), 3000);
}

#[test]
fn homing_needs_an_idle_planner_and_can_be_aborted() {
    let mut machine = enabled();
    machine.configure("x", "home", "50rev").unwrap();
    machine.write_object(NREF, 3);
    machine.write_object(DREF, 1);
    call(&mut machine, "MSPEED", &[7000]);
    call(&mut machine, "MHOME", &[1]);
    assert_eq!(
        machine.get(SysVar::HmFlag),
        0,
        "the speed generator is active"
    );
    call(&mut machine, "MIDLE", &[]);
    until(&mut machine, |m| !m.is_moving());
    call(&mut machine, "MHOME", &[1]);
    run(&mut machine, 100);
    assert_eq!(machine.get(SysVar::HmFlag), 1);
    assert_eq!(machine.get(SysVar::SlSpdDemand), 2097, "VREF of 1 rev/s");
    call(&mut machine, "MHOME", &[2]);
    until(&mut machine, |m| !m.is_moving());
    assert_eq!(
        (
            machine.get(SysVar::HmFlag),
            machine.get(SysVar::GvMflag) & 16
        ),
        (0, 0)
    );
}

#[test]
fn a_switch_that_is_nowhere_ends_in_failure() {
    let mut machine = enabled();
    machine.configure("x", "limits", "-1rev..1rev").unwrap();
    machine.write_object(VREF, 20_000);
    home(&mut machine, 3, 1);
    assert_eq!(machine.get(SysVar::HmFlag), 0);
    assert!(machine.is_enabled() && !machine.is_moving());
}

#[test]
fn homing_in_fine_counts_and_within_a_modulus() {
    for (resolution, modulus, reading) in [(1, 0, 32_768), (0, 1000, 48), (1, 10_000, 2768)] {
        let mut machine = enabled();
        machine.set(SysVar::Mres, resolution);
        machine.set(SysVar::GvSmod, modulus);
        machine.configure("x", "home", "2.3rev").unwrap();
        machine.write_object(ROFFS, 5000);
        let shaft = home(&mut machine, 1, 1);
        assert!(is_done(&machine) && (shaft - 3.0).abs() < 0.001, "{shaft}");
        assert_eq!(machine.get(SysVar::SlPosDemand), reading);
        let feedback = machine.get(SysVar::GvFeedback);
        assert!((feedback - reading).abs() <= 1, "{feedback}");
    }
}

#[test]
fn a_phase_becomes_part_of_the_position() {
    let mut machine = enabled();
    call(&mut machine, "MPHASE", &[1500]);
    until(&mut machine, |m| !m.is_moving());
    let before = machine.signals().shaft;
    let shaft = home(&mut machine, 0, 1);
    assert!((shaft - before).abs() < 0.001);
    assert_eq!(machine.get(SysVar::PhPosition), 0);
    assert_eq!(machine.get(SysVar::GvFeedback), 0);
}
