//! Whatever a program orders, and whatever happens outside, the machine goes on.

use motionbench_core::mc600::keywords::{self, Keyword};
use motionbench_core::mc600::machine::Machine;
use motionbench_core::mc600::motion_calls;
use motionbench_core::mc600::sysvars::SysVar;

use crate::bench::powered;
use crate::random::Random;

const CALLS: [&str; 24] = [
    "MSPEED",
    "MMOVE",
    "MIMOVE",
    "MMERGE",
    "MIMERGE",
    "MGEAR",
    "MCAM",
    "MCAMHARD",
    "MCAMEND",
    "MVIRTUALAX",
    "MVSPEED",
    "MPHASE",
    "MIDLE",
    "MHOME",
    "MQUOTECMP",
    "MCLRFAULT",
    "MDRVEN",
    "MDRVEN",
    "MDRVEN",
    "MSETOUTCMP",
    "MSETINCAP",
    "MSETSB",
    "MCANTX",
    "MCANRX",
];

fn one_of<T: Clone>(random: &mut Random, list: &[T]) -> T {
    let at = random.below(list.len() as i64) as usize;
    list.get(at).unwrap().clone()
}

/// Small, large, and at the ends of 32 bits.
fn number(random: &mut Random) -> i32 {
    match random.below(4) {
        0 => one_of(random, &[0, 1, -1, i32::MAX, i32::MIN]),
        1 => random.below(10) as i32,
        _ => random.signed(i64::from(i32::MAX)) as i32,
    }
}

fn disturb(machine: &mut Machine, random: &mut Random) {
    match random.below(6) {
        0 => {
            let wire = one_of(random, &Machine::wires());
            let value = f64::from(number(random));
            machine.wire(&wire, value).unwrap();
        }
        1 => {
            let faults = ["drive", "limit+", "limit-", "stall", "encoder", "estop"];
            let fault = one_of(random, &faults);
            machine.fault(fault, None, random.below(4) == 0).unwrap();
        }
        2 => machine.write_object(0x3500 + random.below(0x1C0) as i32, number(random)),
        3 => drop(machine.read_object(number(random))),
        4 => machine.set_up_interrupt(10, random.below(19) as u8, random.below(4) as u8),
        _ => machine.lay_table((0..random.below(50)).map(|_| number(random)).collect()),
    }
}

#[test]
fn nothing_overflows_and_positions_stay_within_their_modulus() {
    let mut random = Random::new(77);
    for _ in 0..200 {
        let mut machine = powered();
        for _ in 0..2000 {
            match random.below(12) {
                0 => {
                    let word = one_of(&mut random, &CALLS);
                    let keyword: Keyword = keywords::keyword(word).unwrap();
                    let arguments = [0; 4].map(|_| f64::from(number(&mut random)));
                    if let Ok(Some(command)) = motion_calls::command(keyword, arguments) {
                        machine.command(command);
                    }
                }
                1 => {
                    let (_, variable) = one_of(&mut random, SysVar::all());
                    if !variable.is_read_only() {
                        machine.set(variable, number(&mut random));
                    }
                }
                2 => disturb(&mut machine, &mut random),
                _ => machine.sample(),
            }
            let modulus = machine.get(SysVar::GvSmod);
            if modulus > 0 {
                assert!((0..modulus).contains(&machine.get(SysVar::SlPosDemand)));
            }
            for (_, variable) in SysVar::all() {
                machine.get(*variable);
            }
            drop(machine.send());
        }
    }
}
