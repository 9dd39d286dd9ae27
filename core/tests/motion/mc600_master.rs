//! The MC-600's master: encoders, virtual axis and virtual speed; phase and merge on the axis.

use motionbench_core::mc600::machine::Machine;
use motionbench_core::mc600::sysvars::SysVar;

use crate::bench::{MOVE, PLANNER_BITS, call, enabled, move_is_over, powered, run, until};
use crate::random::Random;

#[test]
fn the_encoder_counts_what_its_shaft_turns() {
    let mut machine = powered();
    machine.wire("encoder", 600.0).unwrap();
    run(&mut machine, 500);
    let counted = machine.get(SysVar::GvEncoder);
    assert!(
        (counted - 40_960).abs() <= 1,
        "ten turns a second: {counted}"
    );
    assert_eq!(machine.get(SysVar::GvMaster), counted);
    let speed = machine.get(SysVar::GvEncspeed);
    assert!((speed - 20_971).abs() <= 256, "{speed}");
    machine.wire("encoder", 0.0).unwrap();
    machine.wire("encoder.counts", -1000.0).unwrap();
    run(&mut machine, 2);
    assert_eq!(machine.get(SysVar::GvEncoder), counted - 1000);
    assert_eq!(machine.get(SysVar::GvEncspeed), 0);
}

#[test]
fn the_master_wraps_to_its_modulus_and_to_32_bits() {
    let mut machine = powered();
    machine.set(SysVar::GvMmod, 4096);
    machine.wire("encoder.speed", -25_600.0).unwrap();
    for _ in 0..1000 {
        machine.sample();
        assert!((0..4096).contains(&machine.get(SysVar::GvMaster)));
        assert_eq!(
            machine.get(SysVar::GvMaster),
            machine.get(SysVar::GvEncoder).rem_euclid(4096)
        );
    }
    machine.set(SysVar::GvMmod, 0);
    let here = machine.get(SysVar::GvMaster);
    assert!((0..4096).contains(&here), "it stays as it read");
    machine.wire("encoder.speed", f64::from(i32::MAX)).unwrap();
    run(&mut machine, 300);
    assert!(machine.get(SysVar::GvEncspeed) > 0);
}

#[test]
fn the_virtual_axis_lands_exactly_and_is_added_to_the_encoder() {
    let mut random = Random::new(21);
    let mut machine = powered();
    for _ in 0..500 {
        machine.set(SysVar::VxAcc, 1 + random.below(3000) as i32);
        machine.set(SysVar::VxDec, 1 + random.below(3000) as i32);
        machine.set(SysVar::VxSpeed, 1000 + random.below(100_000) as i32);
        let target = random.signed(100_000) as i32;
        call(&mut machine, "MVIRTUALAX", &[target]);
        assert_eq!(machine.get(SysVar::VxFlag), 0);
        let mut last = 0;
        while machine.get(SysVar::VxFlag) & 1 == 0 {
            let before = machine.get(SysVar::VxPos);
            machine.sample();
            last = machine.get(SysVar::VxPos) - before;
        }
        assert_eq!((machine.get(SysVar::VxPos), last), (target, 0));
        assert_eq!(machine.get(SysVar::GvMaster), target);
    }
    let start = machine.get(SysVar::GvMaster);
    machine.wire("encoder.speed", 2560.0).unwrap();
    run(&mut machine, 10);
    assert_eq!(machine.get(SysVar::GvMaster), start + 100);
    machine.set(SysVar::VxFlag, 4);
    run(&mut machine, 10);
    assert_eq!(
        machine.get(SysVar::GvMaster),
        start + 100,
        "without the encoder"
    );
    assert_eq!(machine.get(SysVar::GvEncoder), 200);
    assert_eq!(machine.get(SysVar::VxFlag), 5);
}

#[test]
fn the_virtual_speed_is_reached_by_its_acceleration() {
    let mut machine = powered();
    assert_eq!(machine.get(SysVar::VsFlag), 1);
    machine.set(SysVar::VsAcc, 256);
    call(&mut machine, "MVSPEED", &[25_600]);
    run(&mut machine, 50);
    assert_eq!(machine.get(SysVar::VsSpeed), 50 * 256);
    assert_eq!(machine.get(SysVar::VsFlag), 0);
    run(&mut machine, 50);
    assert_eq!(
        (machine.get(SysVar::VsSpeed), machine.get(SysVar::VsFlag)),
        (25_600, 4)
    );
    assert_eq!(machine.get(SysVar::GvMaster), 5050);
    call(&mut machine, "MVSPEED", &[0]);
    run(&mut machine, 101);
    assert_eq!(
        (machine.get(SysVar::VsSpeed), machine.get(SysVar::VsFlag)),
        (0, 1)
    );
    assert_eq!(machine.get(SysVar::GvMaster), 10_000);
}

#[test]
fn a_phase_is_added_to_whatever_drives_the_axis() {
    let mut random = Random::new(22);
    let mut machine = enabled();
    call(&mut machine, "MSPEED", &[20_000]);
    run(&mut machine, 400);
    for _ in 0..50 {
        let (phase, start) = (
            machine.get(SysVar::PhPosition),
            machine.get(SysVar::SlPosDemand),
        );
        let target = random.signed(3000) as i32;
        machine.set(SysVar::PhSpeed, 500 + random.below(20_000) as i32);
        call(&mut machine, "MPHASE", &[target]);
        assert_eq!(machine.get(SysVar::PhFlag), 0);
        let samples = until(&mut machine, |m| m.get(SysVar::PhFlag) == 1);
        assert_eq!(machine.get(SysVar::PhPosition), target);
        let moved = f64::from(machine.get(SysVar::SlPosDemand) - start);
        let due = f64::from(samples) * 20_000.0 / 256.0 + f64::from(target - phase);
        assert!((moved - due).abs() <= 1.0, "{moved} {due}");
    }
}

#[test]
fn a_merge_keeps_the_speed_it_has_and_lands_exactly() {
    let mut random = Random::new(23);
    for _ in 0..200 {
        let mut machine = enabled();
        let speed = 3500 + random.below(60_000) as i32;
        machine.set(SysVar::SmAcc, 2000);
        machine.set(SysVar::MvDec, 700);
        call(&mut machine, "MSPEED", &[speed]);
        run(&mut machine, 100);
        let target = machine.get(SysVar::SlPosDemand) + 40_000 + random.below(100_000) as i32;
        call(&mut machine, "MMERGE", &[target]);
        assert_eq!(machine.get(SysVar::GvStatus) & PLANNER_BITS, MOVE);
        let mut fastest = 0;
        while !move_is_over(&machine) {
            machine.sample();
            fastest = fastest.max(machine.get(SysVar::SlSpdDemand));
        }
        assert_eq!(fastest, speed);
        assert_eq!(machine.get(SysVar::SlPosDemand), target);
    }
}

#[test]
fn a_slow_merge_speeds_up_and_one_from_standstill_never_arrives() {
    let fastest = |machine: &mut Machine| {
        let mut fastest = 0;
        for _ in 0..3000 {
            machine.sample();
            fastest = fastest.max(machine.get(SysVar::SlSpdDemand));
        }
        fastest
    };
    let mut machine = enabled();
    machine.set(SysVar::MinSpeed, 5000);
    call(&mut machine, "MSPEED", &[700]);
    run(&mut machine, 50);
    call(&mut machine, "MIMERGE", &[20_000]);
    assert_eq!(fastest(&mut machine), 5000);
    assert!(move_is_over(&machine));
    call(&mut machine, "MMERGE", &[100_000]);
    assert_eq!(fastest(&mut machine), 0);
    assert_eq!(
        machine.get(SysVar::GvStatus) & PLANNER_BITS,
        MOVE,
        "it stays active"
    );
    call(&mut machine, "MIDLE", &[]);
    assert!(move_is_over(&machine));
}
