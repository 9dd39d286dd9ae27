//! What a program can see of the MC-600's planner and of its inputs and outputs.

use motionbench_core::mc600::machine::{Machine, MotionCommand};
use motionbench_core::mc600::sysvars::SysVar;
use motionbench_core::motion::profile::Trapezoid;

use crate::bench::{
    IDLE, MOVE, PLANNER_BITS, SPEED, enabled, limit, move_is_over, powered, run, until,
};
use crate::random::Random;

#[test]
fn a_move_right_after_mdrven_lands_exactly() {
    let mut machine = powered();
    machine.command(MotionCommand::EnableDrive);
    machine.command(MotionCommand::Move(40_960));
    assert_eq!(
        machine.get(SysVar::MvFlag),
        0,
        "the move is active before the first sample"
    );
    until(&mut machine, move_is_over);
    assert_eq!(machine.get(SysVar::SlPosDemand), 40_960);
    assert_eq!(machine.get(SysVar::SlSpdDemand), 0);
    assert_eq!(machine.get(SysVar::GvMflag), 1);
    assert_eq!(machine.get(SysVar::GvStatus), IDLE | 0b10_0111);
    until(&mut machine, |m| !m.is_moving());
    assert_eq!(machine.get(SysVar::GvFeedback), 40_960);
    assert_eq!(machine.get(SysVar::GvVelmot), 0);
    run(&mut machine, 1000);
    assert_eq!(machine.get(SysVar::GvFeedback), 40_960);
}

#[test]
fn the_following_error_is_small_in_motion_and_zero_at_rest() {
    let mut machine = enabled();
    limit(&mut machine, 3 * 34_952, 699, 1400);
    machine.command(MotionCommand::Move(-300_000));
    let mut worst = 0.0f64;
    while !move_is_over(&machine) {
        machine.sample();
        worst = worst.max(machine.signals().following_error.abs());
        let signals = machine.signals();
        assert!(
            (signals.demand_position - signals.position - signals.following_error).abs() <= 1.0
        );
    }
    assert!(worst > 0.0 && worst < 2.0, "{worst}");
    until(&mut machine, |m| !m.is_moving());
    assert!(machine.signals().following_error.abs() < 0.5);
    assert_eq!(machine.get(SysVar::GvFeedback), -300_000);
}

#[test]
fn the_units_are_those_of_the_manual() {
    let mut machine = enabled();
    machine.set(SysVar::SmAcc, 3500);
    machine.command(MotionCommand::Speed(34_952)); // 1000 rpm
    run(&mut machine, 500);
    let before = machine.get(SysVar::GvFeedback);
    run(&mut machine, 500);
    let turns = f64::from(machine.get(SysVar::GvFeedback) - before) / 4096.0;
    assert!(
        (turns - 1000.0 / 60.0).abs() < 0.001,
        "one second at 1000 rpm: {turns}"
    );
    let velmot = f64::from(machine.get(SysVar::GvVelmot)) * 240_000.0 / 33_554_432.0;
    assert!((velmot - 1000.0).abs() < 1.0, "{velmot}");
    let signals = machine.signals();
    assert!((machine.rpm(signals.velocity) - 1000.0).abs() < 1.0);
    assert!((machine.rpm(signals.demand_velocity) - 1000.0).abs() < 0.02);
}

#[test]
fn speed_and_acceleration_never_exceed_the_set_ones_and_durations_match() {
    let mut random = Random::new(11);
    let mut machine = enabled();
    for _ in 0..3000 {
        let (speed, acceleration, deceleration) = (
            20_000 + random.below(80_000),
            200 + random.below(2000),
            200 + random.below(2000),
        );
        limit(
            &mut machine,
            speed as i32,
            acceleration as i32,
            deceleration as i32,
        );
        let start = machine.get(SysVar::SlPosDemand);
        let target = random.signed(200_000) as i32;
        machine.command(MotionCommand::Move(target));
        let distance = f64::from(target - start) * 256.0;
        let (mut last, mut moved, mut samples) = (0i64, 0i64, 0);
        while !move_is_over(&machine) {
            machine.sample();
            samples += 1;
            let velocity = i64::from(machine.get(SysVar::SlSpdDemand));
            moved += velocity;
            assert_eq!(
                i64::from(machine.get(SysVar::SlPosDemand)),
                i64::from(start) + ((moved + 128) >> 8)
            );
            let change = velocity.abs() - last.abs();
            assert!(velocity.abs() <= speed && change <= acceleration && -change <= deceleration);
            last = velocity;
        }
        assert_eq!(machine.get(SysVar::SlPosDemand), target);
        let plan = Trapezoid::plan(
            distance,
            0.0,
            speed as f64,
            acceleration as f64,
            deceleration as f64,
        )
        .unwrap();
        // The last sample is the one that comes to rest; the target was reached in the sample before it.
        let reached = f64::from(samples) - 1.0;
        assert!(
            (reached - plan.duration()).abs() <= 1.0,
            "{reached} {}",
            plan.duration()
        );
    }
}

#[test]
fn parameters_and_targets_change_on_the_fly() {
    let mut random = Random::new(12);
    for _ in 0..300 {
        let mut machine = enabled();
        let (mut target, mut last) = (0, 0i64);
        for sample in 0..600 {
            if random.below(40) == 0 {
                limit(
                    &mut machine,
                    random.below(100_000) as i32,
                    1 + random.below(2000) as i32,
                    1 + random.below(2000) as i32,
                );
                machine.set(SysVar::SmAcc, 1 + random.below(2000) as i32);
            }
            match random.below(60) {
                0 | 1 => {
                    target = random.signed(100_000) as i32;
                    machine.command(MotionCommand::Move(target));
                }
                2 => machine.command(MotionCommand::Speed(random.signed(100_000) as i32)),
                3 => machine.command(MotionCommand::Idle),
                4 => machine.command(MotionCommand::MoveBy(random.signed(10_000) as i32)),
                _ => {}
            }
            machine.sample();
            let velocity = i64::from(machine.get(SysVar::SlSpdDemand));
            let limits =
                [SysVar::SmAcc, SysVar::MvAcc, SysVar::MvDec].map(|v| i64::from(machine.get(v)));
            assert!(
                (velocity - last).abs() <= limits.into_iter().max().unwrap(),
                "{sample}: {last} -> {velocity}"
            );
            last = velocity;
        }
        limit(&mut machine, 34_952, 700, 700);
        machine.command(MotionCommand::Move(target));
        until(&mut machine, move_is_over);
        assert_eq!(machine.get(SysVar::SlPosDemand), target);
    }
}

#[test]
fn a_move_takes_over_from_speed_and_speed_from_a_move() {
    let mut machine = enabled();
    machine.command(MotionCommand::Speed(34_952));
    assert_eq!(machine.get(SysVar::GvStatus) & PLANNER_BITS, SPEED);
    assert_eq!(
        (machine.get(SysVar::SmFlag), machine.get(SysVar::GvMflag)),
        (0, 0)
    );
    run(&mut machine, 600);
    assert_eq!(
        (machine.get(SysVar::SmFlag), machine.get(SysVar::GvMflag)),
        (4, 4),
        "at speed"
    );
    assert_eq!(machine.get(SysVar::SmSpeed), 34_952);

    let target = machine.get(SysVar::SlPosDemand) + 100_000;
    machine.command(MotionCommand::Move(target));
    machine.sample();
    assert_eq!(
        machine.get(SysVar::SlSpdDemand),
        34_952,
        "no step of the speed"
    );
    assert_eq!(
        (machine.get(SysVar::SmFlag), machine.get(SysVar::MvFlag)),
        (1, 0)
    );
    assert_eq!(machine.get(SysVar::GvStatus) & PLANNER_BITS, MOVE);
    run(&mut machine, 100);
    machine.command(MotionCommand::Speed(-10_000));
    machine.sample();
    assert_eq!(machine.get(SysVar::SlSpdDemand), 34_952 - 70);
    assert_eq!(
        (machine.get(SysVar::SmFlag), machine.get(SysVar::MvFlag)),
        (0, 1),
        "the move is aborted"
    );

    machine.command(MotionCommand::Move(target));
    until(&mut machine, move_is_over);
    assert_eq!(machine.get(SysVar::SlPosDemand), target);
}

#[test]
fn midle_decelerates_by_sm_acc_and_holds() {
    let mut machine = enabled();
    machine.command(MotionCommand::Speed(7000));
    run(&mut machine, 200);
    machine.set(SysVar::SmAcc, 35);
    machine.command(MotionCommand::Idle);
    machine.sample();
    assert_eq!(machine.get(SysVar::SlSpdDemand), 7000 - 35);
    assert_eq!(
        until(&mut machine, |m| m.get(SysVar::GvStatus) & PLANNER_BITS
            == IDLE),
        199
    );
    let rest = machine.get(SysVar::SlPosDemand);
    run(&mut machine, 100);
    assert_eq!(
        (
            machine.get(SysVar::SlPosDemand),
            machine.get(SysVar::SmFlag)
        ),
        (rest, 1)
    );
}

#[test]
fn speed_0_stays_active_at_rest() {
    let mut machine = enabled();
    machine.command(MotionCommand::Speed(7000));
    run(&mut machine, 200);
    machine.command(MotionCommand::Speed(0));
    until(&mut machine, |m| !m.is_moving());
    assert_eq!(machine.get(SysVar::GvStatus) & PLANNER_BITS, SPEED);
    assert_eq!(
        (machine.get(SysVar::SmFlag), machine.get(SysVar::SmSpeed)),
        (4, 0)
    );
}

#[test]
fn mimove_adds_to_the_target() {
    let mut machine = enabled();
    machine.command(MotionCommand::MoveBy(10_000));
    run(&mut machine, 50);
    machine.command(MotionCommand::MoveBy(5000));
    until(&mut machine, move_is_over);
    assert_eq!(machine.get(SysVar::SlPosDemand), 15_000);
    machine.command(MotionCommand::MoveBy(-15_001));
    until(&mut machine, move_is_over);
    assert_eq!(machine.get(SysVar::SlPosDemand), -1);
}

#[test]
fn positions_wrap_to_the_modulus_and_moves_keep_to_their_direction() {
    let at = |machine: &Machine| machine.get(SysVar::SlPosDemand);
    let go = |machine: &mut Machine, flags: i32, target: i32| {
        machine.set(SysVar::MvFlag, flags);
        machine.command(MotionCommand::Move(target));
        let (mut travelled, mut backwards) = (0, 0);
        while !move_is_over(machine) {
            machine.sample();
            travelled += machine.get(SysVar::SlSpdDemand);
            backwards += i32::from(machine.get(SysVar::SlSpdDemand) < 0);
            assert!((0..4096).contains(&machine.get(SysVar::SlPosDemand)));
            assert!((0..4096).contains(&machine.get(SysVar::GvFeedback)));
        }
        (travelled / 256, backwards > 0)
    };
    let mut machine = enabled();
    machine.set(SysVar::GvSmod, 4096);
    assert_eq!(
        go(&mut machine, 0, 4000),
        (4000, false),
        "without a direction the way does not pass 0"
    );
    assert_eq!(go(&mut machine, 0, 100), (-3900, true));
    assert_eq!(
        go(&mut machine, 1 << 4, 50),
        (4046, false),
        "always positive"
    );
    assert_eq!(go(&mut machine, 1 << 4, 50), (0, false));
    assert_eq!(
        go(&mut machine, 1 << 5, 60),
        (-4086, true),
        "always negative"
    );
    assert_eq!(go(&mut machine, 1 << 6, 4000), (-156, true), "shortest");
    assert_eq!(
        go(&mut machine, 1 << 6, 4000 + 2048),
        (2048, false),
        "half a turn goes forward"
    );
    assert_eq!(at(&machine), 4000 + 2048 - 4096);
    assert_eq!(machine.get(SysVar::MvFlag), 1 << 6 | 1);

    machine.set(SysVar::MvFlag, 1 << 4);
    machine.command(MotionCommand::Speed(34_952));
    run(&mut machine, 600);
    let here = at(&machine);
    assert!(
        !go(&mut machine, 1 << 4, here + 10).1,
        "too fast to stop there, so one turn more"
    );
    assert_eq!(at(&machine), (here + 10) % 4096);

    machine.command(MotionCommand::MoveBy(-3 * 4096 - 7));
    until(&mut machine, move_is_over);
    assert_eq!(at(&machine), (here + 3 + 4096) % 4096);
    let rest = at(&machine);
    machine.set(SysVar::GvSmod, 0);
    assert_eq!(
        (at(&machine), machine.get(SysVar::GvFeedback)),
        (rest, rest),
        "positions stay as they read"
    );
}

#[test]
fn mres_changes_the_counts_but_not_the_axis() {
    let mut machine = enabled();
    machine.command(MotionCommand::Move(1000));
    until(&mut machine, |m| !m.is_moving());
    machine.set(SysVar::Mres, 1);
    assert_eq!(
        (
            machine.get(SysVar::SlPosDemand),
            machine.get(SysVar::GvFeedback)
        ),
        (16_000, 16_000)
    );
    run(&mut machine, 100);
    assert!(!machine.is_moving() && machine.is_enabled());
    machine.set(SysVar::MvSpeed, 559_240);
    machine.command(MotionCommand::Move(655_360));
    until(&mut machine, |m| !m.is_moving());
    assert_eq!(machine.get(SysVar::GvFeedback), 655_360);
    machine.set(SysVar::Mres, 0);
    assert_eq!(
        (
            machine.get(SysVar::SlPosDemand),
            machine.get(SysVar::GvFeedback)
        ),
        (40_960, 40_960)
    );
    assert_eq!(machine.get(SysVar::Mres), 0);
}

#[test]
fn inputs_and_outputs() {
    let mut machine = powered();
    assert_eq!((machine.inputs(), machine.outputs()), (0, 0));
    machine.wire("in3", 1.0).unwrap();
    machine.wire("in9", 1.0).unwrap();
    assert_eq!(machine.inputs(), 8);
    let inputs = [3, 4, 9, 12, 13].map(|number| machine.get(SysVar::GvIn(number)));
    assert_eq!(inputs, [1, 0, 1, 1, 0]);
    machine.write_outputs(0x81);
    machine.set(SysVar::GvOut(1), 7);
    machine.set(SysVar::GvOut(9), 1);
    assert_eq!(machine.outputs(), 0x83);
    assert_eq!(
        [0, 1, 2, 8, 9].map(|number| machine.get(SysVar::GvOut(number))),
        [1, 1, 0, 0, 1]
    );
    assert_eq!(machine.signals().outputs, 0x283);
}

#[test]
fn power_keeps_the_motor_where_it_is_and_forgets_the_rest() {
    let mut machine = enabled();
    limit(&mut machine, 1, 2, 3);
    machine.set(SysVar::MvSpeed, 34_952);
    machine.command(MotionCommand::Speed(34_952));
    machine.write_outputs(255);
    machine.wire("in2", 1.0).unwrap();
    run(&mut machine, 600);
    machine.power_off();
    assert_eq!(machine.outputs(), 0);
    assert!(machine.is_moving(), "the motor coasts");
    until(&mut machine, |m| !m.is_moving());
    machine.power_up();
    assert_eq!(
        machine.get(SysVar::GvFeedback),
        0,
        "positions are counted from power-up"
    );
    assert_eq!(
        [SysVar::MvAcc, SysVar::MvDec, SysVar::MvSpeed].map(|var| machine.get(var)),
        [70, 70, 34_952]
    );
    assert_eq!((machine.get(SysVar::GvMflag), machine.inputs()), (0, 4));
    assert_eq!(machine.get(SysVar::GvStatus), IDLE | 0b10_0001);
}

#[test]
fn what_does_not_exist_is_refused_in_one_line() {
    let mut machine = powered();
    let refusals = [
        machine.wire("in13", 1.0),
        machine.wire("motor", 1.0),
        machine.wire("in0", f64::NAN),
        machine.fault("fire", None, true),
        machine.fault("drive", Some("y"), true),
        machine.configure("y", "inertia", "2"),
        machine.configure("x", "colour", "2"),
    ];
    for refusal in refusals {
        assert!(!refusal.unwrap_err().contains('\n'));
    }
}

#[test]
fn commands_print_as_the_program_wrote_them() {
    let printed = [
        MotionCommand::Speed(-5),
        MotionCommand::Move(40_960),
        MotionCommand::MoveBy(1),
        MotionCommand::Idle,
        MotionCommand::EnableDrive,
        MotionCommand::DisableDrive,
        MotionCommand::ClearFault,
    ]
    .map(|command| command.to_string());
    assert_eq!(
        printed,
        [
            "mspeed(-5)",
            "mmove(40960)",
            "mimove(1)",
            "midle()",
            "mdrven()",
            "mdrvdis()",
            "mclrfault()"
        ]
    );
}
