//! What a newcomer to the Unidex starts with.

use crate::controller::FirstStep::{self, PowerCycle, Type};

/// Traces a square three times.
pub const PROGRAM: &str = "G91 G00 *
G661=3 *
N10 X1000 F500 *
Y1000 F500 *
X-1000 *
Y-1000 *
G671 N>10 *
M2 *";

/// Commands from the controller: addressing, a move, a program that outlives the mains switch.
pub const STEPS: &[FirstStep] = &[
    Type(
        "\u{1b}01",
        "addresses unit 1: it leaves the panel and listens",
    ),
    Type("I X1000 F500", "runs a block: the X axis moves 1000 steps"),
    Type("Q", "polls the unit, which waits for that after each block"),
    Type("PX", "asks for the X position"),
    Type("E 05", "opens program 5, empty"),
    Type("X500 F500 Y500 F500 * M2 *", "its text"),
    Type("%", "ends the edit"),
    PowerCycle,
    Type("\u{1b}01", "addresses the unit again"),
    Type("A 05", "runs the program"),
];
