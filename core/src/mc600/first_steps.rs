//! What a newcomer to the MC-600 starts with.

use crate::catalog::FirstStep::{self, PowerCycle, Type};

/// Moves the axis to and fro within two seconds, and says so.
pub const PROGRAM: &str = include_str!("first_program.bas");

/// A program of one's own: typed, started, kept on disk B: and started again after a power cycle.
pub const STEPS: &[FirstStep] = &[
    Type("NEW", "clears the program that is there"),
    Type(
        "10 MDRVEN()",
        "a line with a number goes into the program: this one enables the drive",
    ),
    Type(
        "20 MMOVE(40960)",
        "moves the axis to position 40960, ten turns from 0",
    ),
    Type("LIST", "shows the program"),
    Type("RUN", "starts it"),
    Type(
        "SAVE \"B:TURNS\"",
        "keeps it on disk B:, which needs no power; A: does",
    ),
    PowerCycle,
    Type("FILES \"B:\"", "shows what is on the disk"),
    Type("LOAD \"B:TURNS\"", "gets the program back"),
    Type("RUN", "starts it again"),
];
