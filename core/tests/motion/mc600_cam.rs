//! The MC-600's cam: exact at its points, straight between them, entered within limits.

use std::rc::Rc;

use motionbench_core::mc600::machine::{Machine, MotionCommand};
use motionbench_core::mc600::sysvars::SysVar;

use crate::bench::{CAM, PLANNER_BITS, call, enabled, run, until};
use crate::random::Random;

fn cam(machine: &mut Machine, table: &[i32], command: MotionCommand) {
    machine.set(SysVar::CmNum, table.len() as i32);
    machine.lay_table(Rc::from(table));
    machine.command(command);
}

fn is_locked(machine: &Machine) -> bool {
    machine.get(SysVar::GvMflag) & 8 != 0
}

/// A closed table of gentle waves.
fn waves(random: &mut Random, points: usize, height: f64) -> Vec<i32> {
    let (a, b) = (random.below(1000) as f64 / 1000.0, random.below(3) + 1);
    let at = |i: usize| i as f64 / points as f64 * 2.0 * std::f64::consts::PI;
    (0..points)
        .map(|i| (height * (libm::sin(at(i) * b as f64) + a * (1.0 - libm::cos(at(i))))) as i32)
        .collect()
}

#[test]
fn exact_at_each_point_and_straight_between() {
    let mut random = Random::new(8);
    for points in [4usize, 36, 360] {
        let table = waves(&mut random, points, points as f64 * 8.0);
        let interval = 40;
        let mut machine = enabled();
        machine.set(SysVar::GvMmod, points as i32 * interval);
        cam(&mut machine, &table, MotionCommand::Cam);
        until(&mut machine, is_locked);
        assert_eq!(machine.get(SysVar::GvStatus) & PLANNER_BITS, CAM);
        for step in 0..points as i32 * 2 {
            for part in 0..4 {
                let from = table[(step as usize) % points];
                let to = table[(step as usize + 1) % points];
                let due = f64::from(from) + f64::from(to - from) * f64::from(part) / 4.0;
                let here = machine.get(SysVar::SlPosDemand);
                assert!(
                    (f64::from(here) - due).abs() <= 0.51,
                    "{step}.{part}: {here} {due}"
                );
                if part == 0 {
                    assert_eq!(here, from, "point {step}");
                    assert_eq!(machine.get(SysVar::CmIndex), step % points as i32);
                }
                assert_eq!(machine.get(SysVar::CmCamout), here);
                machine
                    .wire("encoder.counts", f64::from(interval) / 4.0)
                    .unwrap();
                machine.sample();
            }
        }
    }
}

#[test]
fn engaging_never_jumps_above_the_set_limits() {
    let mut random = Random::new(9);
    for _ in 0..40 {
        let table = waves(&mut random, 360, 2000.0);
        let mut machine = enabled();
        machine.set(SysVar::GvMmod, 36_000);
        machine.set(SysVar::SmAcc, 100 + random.below(400) as i32);
        machine.set(SysVar::PhAcc, 100 + random.below(400) as i32);
        machine.set(SysVar::PhDec, 100 + random.below(400) as i32);
        machine.set(SysVar::PhSpeed, 2000 + random.below(20_000) as i32);
        call(&mut machine, "MVSPEED", &[random.signed(30_000) as i32]);
        machine.set(SysVar::VsAcc, 30_000);
        run(&mut machine, 20 + random.below(200) as u32);
        let limit = [SysVar::SmAcc, SysVar::PhAcc, SysVar::PhDec].map(|var| machine.get(var));
        cam(&mut machine, &table, MotionCommand::Cam);
        let (mut last, mut pace) = (0, None);
        let mut camout = machine.get(SysVar::CmCamout);
        while !is_locked(&machine) {
            machine.sample();
            let velocity = machine.get(SysVar::SlSpdDemand);
            let now = machine.get(SysVar::CmCamout);
            // The table's own change of speed comes on top, with its rounding to counts.
            let this_pace = (now - camout) * 256;
            let own = pace.map_or(0, |before: i32| (this_pace - before).abs()) + 512;
            let allowed = limit.into_iter().max().unwrap() + own;
            assert!(
                (velocity - last).abs() <= allowed,
                "{last} -> {velocity}, {allowed}"
            );
            (last, pace, camout) = (velocity, Some(this_pace), now);
        }
        assert_eq!(
            machine.get(SysVar::SlPosDemand),
            machine.get(SysVar::CmCamout)
        );
        run(&mut machine, 500);
        assert_eq!(
            machine.get(SysVar::SlPosDemand),
            machine.get(SysVar::CmCamout)
        );
    }
}

#[test]
fn a_table_turns_the_axis_on_and_on_within_its_modulus() {
    let mut machine = enabled();
    let table: Vec<i32> = (0..16).map(|i| i * 256).collect();
    machine.set(SysVar::GvSmod, 4096);
    machine.set(SysVar::GvMmod, 1600);
    cam(&mut machine, &table, MotionCommand::Cam);
    machine.wire("encoder.speed", 2560.0).unwrap();
    until(&mut machine, is_locked);
    for _ in 0..2000 {
        machine.sample();
        assert_eq!(
            machine.get(SysVar::SlSpdDemand),
            6553 + i32::from(machine.get(SysVar::SlSpdDemand) == 6554)
        );
        let due = machine.get(SysVar::GvMaster) * 256 / 100;
        assert!((machine.get(SysVar::SlPosDemand) - due).abs() <= 1);
    }
}

#[test]
fn camhard_is_connected_at_once_and_tables_change_on_the_fly() {
    let mut machine = enabled();
    machine.set(SysVar::GvMmod, 4000);
    cam(&mut machine, &[0, 100, 0, -100], MotionCommand::CamHard);
    machine.sample();
    assert!(is_locked(&machine));
    machine.wire("encoder.counts", 1000.0).unwrap();
    machine.sample();
    assert_eq!(machine.get(SysVar::SlPosDemand), 100);
    machine.lay_table(Rc::from([0, 150, 0, 0]));
    machine.command(MotionCommand::Cam);
    machine.sample();
    assert_eq!(
        machine.get(SysVar::SlPosDemand),
        150,
        "the other table, without engaging anew"
    );
    assert!(is_locked(&machine));
}

#[test]
fn camend_releases_at_the_end_of_the_modulus() {
    let mut machine = enabled();
    machine.set(SysVar::GvMmod, 4000);
    machine.wire("encoder.speed", 2560.0).unwrap();
    cam(
        &mut machine,
        &[0, 0, 500, 1000, 1000, 1000, 500, 0],
        MotionCommand::Cam,
    );
    until(&mut machine, |m| {
        is_locked(m) && m.get(SysVar::CmIndex) == 3
    });
    machine.command(MotionCommand::CamEnd);
    assert_eq!(machine.get(SysVar::CmFlag), 1);
    while machine.get(SysVar::GvStatus) & CAM != 0 {
        assert_eq!(
            machine.get(SysVar::SlPosDemand),
            machine.get(SysVar::CmCamout)
        );
        machine.sample();
    }
    assert_eq!(machine.get(SysVar::CmFlag), 0);
    until(&mut machine, |m| m.get(SysVar::SlSpdDemand) == 0);
    assert_eq!(machine.get(SysVar::CmIndex), 0);
    assert!(
        machine.get(SysVar::SlPosDemand).abs() < 150,
        "it slows down from point 0"
    );
}

#[test]
fn without_points_or_modulus_the_cam_is_point_0() {
    for (points, modulus) in [(0, 4000), (-1, 4000), (4, 0)] {
        let mut machine = enabled();
        machine.set(SysVar::GvMmod, modulus);
        cam(&mut machine, &[10, 100, 0, -100], MotionCommand::Cam);
        machine.set(SysVar::CmNum, points);
        machine.wire("encoder.speed", 2560.0).unwrap();
        run(&mut machine, 300);
        assert_eq!(machine.get(SysVar::SlPosDemand), 10);
        assert_eq!(machine.get(SysVar::CmIndex), 0);
    }
}
