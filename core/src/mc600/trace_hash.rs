//! One number for every bit of a recorded run, to hold native and wasm to the same arithmetic.

use super::machine::{Machine, MotionCommand, Signals};
use super::sysvars::SysVar;
use crate::motion::rig::Rig;

/// What [`trace_hash`] gives, on every machine. It changes with the motion planner, the servo or the plant.
pub const TRACE_HASH: u64 = 0xBC0F_856B_B686_5952;

/// Commands, assignments, and how many samples follow them.
type Phase = (&'static [MotionCommand], &'static [(SysVar, i32)], u32);

/// Hashes the trace of a machine that moves, is changed on the fly, reverses, runs at speed, stops, coasts and moves
/// on, and the positions of some axes of the floating-point profile.
pub fn trace_hash() -> u64 {
    let mut hash = 0xCBF2_9CE4_8422_2325;
    let mut machine = Machine::new();
    machine.power_up();
    let script: [Phase; 7] = [
        (
            &[MotionCommand::EnableDrive, MotionCommand::Move(40_960)],
            &[(SysVar::MvAcc, 699)],
            100,
        ),
        (&[], &[(SysVar::MvSpeed, 69_904), (SysVar::MvDec, 350)], 150),
        (&[MotionCommand::Move(-1000)], &[(SysVar::MvAcc, 1400)], 300),
        (
            &[MotionCommand::Speed(-104_857)],
            &[(SysVar::SmAcc, 350), (SysVar::GvSmod, 10_000)],
            500,
        ),
        (&[MotionCommand::Idle], &[], 200),
        (&[MotionCommand::Speed(50_000)], &[], 100),
        (&[MotionCommand::DisableDrive], &[], 200),
    ];
    for (commands, variables, samples) in script {
        commands
            .iter()
            .for_each(|&command| machine.command(command));
        variables
            .iter()
            .for_each(|&(variable, value)| machine.set(variable, value));
        for _ in 0..samples {
            machine.sample();
            hash_signals(&mut hash, &machine.signals());
        }
    }
    let mut rig = Rig::new(4);
    for _ in 0..2000 {
        rig.sample();
        rig.positions().for_each(|(demand, actual)| {
            hash_number(&mut hash, demand);
            hash_number(&mut hash, actual);
        });
    }
    hash
}

fn hash_signals(hash: &mut u64, signals: &Signals) {
    let motion = [
        signals.demand_position,
        signals.demand_velocity,
        signals.demand_acceleration,
    ];
    let motor = [
        signals.position,
        signals.velocity,
        signals.following_error,
        signals.output,
    ];
    motion
        .into_iter()
        .chain(motor)
        .for_each(|value| hash_number(hash, value));
}

/// FNV-1a over the bytes of a number.
fn hash_number(hash: &mut u64, number: f64) {
    for byte in number.to_bits().to_le_bytes() {
        *hash = (*hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01B3);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_trace_is_what_it_was() {
        assert_eq!(trace_hash(), TRACE_HASH, "{:#x}", trace_hash());
    }
}
