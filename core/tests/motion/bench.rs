//! An MC-600 without its interpreter, as the tests handle it.

use motionbench_core::mc600::machine::{Machine, MotionCommand};
use motionbench_core::mc600::sysvars::SysVar;
use motionbench_core::mc600::{keywords, motion_calls};

pub(crate) const IDLE: i32 = 1 << 10;
pub(crate) const SPEED: i32 = 1 << 11;
pub(crate) const MOVE: i32 = 1 << 13;
pub(crate) const GEAR: i32 = 1 << 12;
pub(crate) const CAM: i32 = 1 << 14;
pub(crate) const HOME: i32 = 1 << 15;
pub(crate) const PLANNER_BITS: i32 = 0xFC00;

/// A machine that was just switched on.
pub(crate) fn powered() -> Machine {
    let mut machine = Machine::new();
    machine.power_up();
    machine
}

/// A machine whose drive holds the motor at 0.
pub(crate) fn enabled() -> Machine {
    let mut machine = powered();
    machine.command(MotionCommand::EnableDrive);
    run(&mut machine, 5);
    assert_eq!(machine.get(SysVar::GvStatus), IDLE | 0b10_0111);
    machine
}

/// A call as a program makes it.
pub(crate) fn call(machine: &mut Machine, word: &str, arguments: &[i32]) {
    let mut four = [0.0; 4];
    four.iter_mut()
        .zip(arguments)
        .for_each(|(place, &argument)| *place = f64::from(argument));
    let keyword = keywords::keyword(word).unwrap();
    machine.command(motion_calls::command(keyword, four).unwrap().unwrap());
}

/// Some samples.
pub(crate) fn run(machine: &mut Machine, samples: u32) {
    (0..samples).for_each(|_| machine.sample());
}

/// Samples until `done`.
pub(crate) fn until(machine: &mut Machine, done: impl Fn(&Machine) -> bool) -> u32 {
    for samples in 0..1_000_000 {
        if done(machine) {
            return samples;
        }
        machine.sample();
    }
    panic!("never done: {:?}", machine.signals());
}

/// `mv_flag%` bit 0.
pub(crate) fn move_is_over(machine: &Machine) -> bool {
    machine.get(SysVar::MvFlag) & 1 == 1
}

/// Sets the three limits of moves.
pub(crate) fn limit(machine: &mut Machine, speed: i32, acceleration: i32, deceleration: i32) {
    machine.set(SysVar::MvSpeed, speed);
    machine.set(SysVar::MvAcc, acceleration);
    machine.set(SysVar::MvDec, deceleration);
}
