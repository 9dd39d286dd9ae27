//! The MC-600's gear: locked to the count, and exact about what it loses and regains.

use motionbench_core::mc600::machine::Machine;
use motionbench_core::mc600::sysvars::SysVar;

use crate::bench::{GEAR, PLANNER_BITS, call, enabled, run, until};
use crate::random::Random;

fn gear(machine: &mut Machine, kind: i32, ratio: (i32, i32), acceleration: i32) {
    machine.set(SysVar::GrRation, ratio.0);
    machine.set(SysVar::GrRatioid, ratio.1);
    machine.set(SysVar::GrAcc, acceleration);
    call(machine, "MGEAR", &[kind]);
}

fn is_locked(machine: &Machine) -> bool {
    machine.get(SysVar::GrFlag) == 2
}

/// What the ratio makes of a way of the master, in counts.
fn geared(master: i32, ratio: (i32, i32)) -> i64 {
    (i64::from(master) * i64::from(ratio.0)).div_euclid(i64::from(ratio.1))
}

#[test]
fn locked_to_the_count_for_ten_million_counts_of_the_master() {
    let mut machine = enabled();
    machine.wire("encoder", 1500.0).unwrap();
    run(&mut machine, 10);
    gear(&mut machine, 1, (17, 23), 700);
    until(&mut machine, is_locked);
    assert_eq!(machine.get(SysVar::GvMflag), 2);
    assert_eq!(machine.get(SysVar::GvStatus) & PLANNER_BITS, GEAR);
    let (master, follower) = (
        machine.get(SysVar::GvEncoder),
        machine.get(SysVar::SlPosDemand),
    );
    let mut random = Random::new(3);
    let mut rpm = 1500;
    while i64::from(machine.get(SysVar::GvEncoder) - master) < 10_000_000 {
        if random.below(50) == 0 {
            rpm = (rpm + random.below(101) - 50).clamp(0, 3000);
            machine.wire("encoder", rpm as f64).unwrap();
        }
        machine.sample();
        let now = machine.get(SysVar::GvEncoder);
        let moved = i64::from(machine.get(SysVar::SlPosDemand) - follower);
        // The follower stood on a fraction of a count when it locked.
        assert!((moved - geared(now - master, (17, 23))).abs() <= 1);
        assert!(is_locked(&machine));
    }
}

#[test]
fn recovery_regains_exactly_what_was_lost_and_prepost() {
    let mut random = Random::new(4);
    for _ in 0..200 {
        let mut machine = enabled();
        // Whole counts of the follower for whole counts of the master.
        let ratio = ([1, -1, 2, -3][random.below(4) as usize], 1);
        let speed = random.signed(150) as i32 * 256;
        let prepost = random.signed(6000) as i32;
        let acceleration = 20 + random.below(2000) as i32;
        machine.wire("encoder.speed", f64::from(speed)).unwrap();
        machine.set(SysVar::GrPrepost, prepost);
        machine.set(SysVar::GrSpeed, 256 + random.below(20_000) as i32);
        run(&mut machine, 5);
        let (master, start) = (
            machine.get(SysVar::GvMaster),
            machine.get(SysVar::SlPosDemand),
        );
        gear(&mut machine, 5, ratio, acceleration);
        until(&mut machine, is_locked);
        let due = start + (machine.get(SysVar::GvMaster) - master) * ratio.0 + prepost;
        assert_eq!(machine.get(SysVar::SlPosDemand), due, "{speed} {prepost}");
    }
}

#[test]
fn without_recovery_the_way_of_the_acceleration_is_lost() {
    let mut machine = enabled();
    machine.wire("encoder.speed", 25_600.0).unwrap();
    run(&mut machine, 5);
    let (master, start) = (
        machine.get(SysVar::GvMaster),
        machine.get(SysVar::SlPosDemand),
    );
    gear(&mut machine, 1, (1, 1), 256);
    assert_eq!(machine.get(SysVar::GrFlag), 1, "engaging");
    let samples = until(&mut machine, is_locked);
    assert_eq!(samples, 100);
    let lost = machine.get(SysVar::GvMaster) - master - (machine.get(SysVar::SlPosDemand) - start);
    // 100 + ... + 1 samples of the difference of speed, the last of them none.
    assert_eq!(lost, 99 * 100 / 2);
}

#[test]
fn the_acceleration_and_the_speed_of_the_recovery_stay_within_limits() {
    let mut machine = enabled();
    machine.wire("encoder.speed", 25_600.0).unwrap();
    machine.set(SysVar::GrSpeed, 5120);
    run(&mut machine, 5);
    gear(&mut machine, 5, (1, 1), 200);
    let (mut last, mut fastest) = (0, 0);
    while !is_locked(&machine) {
        machine.sample();
        let velocity = machine.get(SysVar::SlSpdDemand);
        assert!((velocity - last).abs() <= 200);
        fastest = fastest.max(velocity);
        last = velocity;
    }
    assert_eq!(fastest, 25_600 + 5120);
}

#[test]
fn a_pre_trigger_beyond_what_is_lost_takes_a_lower_acceleration() {
    let mut machine = enabled();
    machine.wire("encoder.speed", 25_600.0).unwrap();
    machine.set(SysVar::GrPrepost, -12_000);
    run(&mut machine, 5);
    let (master, start) = (
        machine.get(SysVar::GvMaster),
        machine.get(SysVar::SlPosDemand),
    );
    gear(&mut machine, 5, (1, 1), 1000);
    let (mut last, mut steepest) = (0, 0);
    while !is_locked(&machine) {
        machine.sample();
        let velocity = machine.get(SysVar::SlSpdDemand);
        assert!(velocity <= 25_600, "no overshoot: {velocity}");
        assert!(velocity >= last, "never back");
        steepest = steepest.max(velocity - last);
        last = velocity;
    }
    // 100 counts a sample from standstill over 12000 counts of the master's way: 0.417 counts a sample².
    assert!((105..=110).contains(&steepest), "{steepest}");
    let behind =
        machine.get(SysVar::GvMaster) - master - (machine.get(SysVar::SlPosDemand) - start);
    assert_eq!(behind, 12_000);
}

#[test]
fn hardware_types_wait_for_their_edge() {
    // Type, and the levels of input 3 after which it must be waiting or engaged.
    for (kind, levels) in [
        (2, &[(0, false), (1, true)][..]),
        (3, &[(1, false), (0, true)]),
        (4, &[(1, true)]),
        (6, &[(1, true)]),
        (7, &[(1, false), (0, true)]),
        (8, &[(1, true)]),
    ] {
        let mut machine = enabled();
        machine.wire("encoder.speed", 25_600.0).unwrap();
        gear(&mut machine, kind, (1, 1), 1000);
        run(&mut machine, 50);
        assert_eq!(machine.get(SysVar::SlSpdDemand), 0, "type {kind} waits");
        for &(level, engaged) in levels {
            machine.wire("in3", f64::from(level)).unwrap();
            run(&mut machine, 200);
            assert_eq!(is_locked(&machine), engaged, "type {kind}, input {level}");
        }
    }
}

#[test]
fn the_edge_counts_where_it_comes_not_where_it_is_seen() {
    use motionbench_core::time::Nanos;
    let mut machine = enabled();
    machine.wire("encoder.speed", 25_600.0).unwrap();
    gear(&mut machine, 6, (1, 1), 1000);
    run(&mut machine, 50);
    let master = machine.get(SysVar::GvMaster);
    // A quarter into the last sample, in which the master went 100 counts.
    machine.wire_at("in3", 1.0, Nanos(500_000)).unwrap();
    until(&mut machine, is_locked);
    let moved = machine.get(SysVar::GvMaster) - (master - 75);
    assert_eq!(machine.get(SysVar::SlPosDemand), moved);
}

#[test]
fn another_generator_releases_the_gear_and_the_ratio_changes_on_the_fly() {
    let mut machine = enabled();
    machine.wire("encoder.speed", 25_600.0).unwrap();
    gear(&mut machine, 1, (1, 1), 512);
    until(&mut machine, is_locked);
    machine.set(SysVar::GrRation, 2);
    let mut last = machine.get(SysVar::SlSpdDemand);
    machine.sample();
    assert_eq!(machine.get(SysVar::GrFlag), 1, "it engages anew");
    while !is_locked(&machine) {
        machine.sample();
        let velocity = machine.get(SysVar::SlSpdDemand);
        assert!((velocity - last).abs() <= 1024);
        last = velocity;
    }
    assert_eq!(last, 51_200);
    call(&mut machine, "MIDLE", &[]);
    assert_eq!(machine.get(SysVar::GrFlag), 0);
    until(&mut machine, |m| m.get(SysVar::SlSpdDemand) == 0);
}
