//! What a program sees of its motor, without the language.

mod following;
mod motion;
mod outside;
mod robust;
mod tuning;

use super::*;

/// Samples of a second.
const SECOND: u32 = 4069;

fn motor() -> Motor {
    let mut motor = Motor::new();
    motor.power_up();
    motor
}

fn run(motor: &mut Motor, samples: u32) {
    (0..samples).for_each(|_| motor.sample(|_| 0));
}

/// Commands and assignments as a program writes them.
fn say(motor: &mut Motor, words: &str) {
    for word in words.split(' ') {
        match word.split_once('=') {
            Some((name, value)) => {
                let register = Register::writable(name).unwrap();
                motor.set(register, value.parse().unwrap());
            }
            None => motor.command(Command::from_word(word).unwrap()),
        }
    }
}

/// Until the trajectory ends; how many samples it took.
fn arrive(motor: &mut Motor) -> u32 {
    let mut samples = 0;
    while motor.is(Flag::Trajectory) {
        run(motor, 1);
        samples += 1;
        assert!(samples < 1_000_000, "no end");
    }
    samples
}

/// `@P`.
fn position(motor: &Motor) -> i32 {
    motor.get(Register::ActualPosition)
}

/// `@PE`.
fn error(motor: &Motor) -> i32 {
    motor.get(Register::PositionError)
}

/// Letters of the bits that are set, bit 0 first.
fn bits(motor: &Motor) -> String {
    "trliwehoxpmdusak"
        .chars()
        .filter(|&letter| motor.is(Flag::from_letter(letter as u8).unwrap()))
        .collect()
}
