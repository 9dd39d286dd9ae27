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

/// The same by the keys of the front panel: a square.
pub const PANEL: &[(&str, &str)] = &[
    (
        "EDT 0 5 EXC",
        "opens program 05, empty: `>>` is where it begins",
    ),
    ("SHIFT G 9 1 *", "G91: moves count from where the axes are"),
    (
        "SHIFT X 1 0 0 0 SHIFT F 5 0 0 *",
        "X1000 F500: 1000 steps of X, 500 in a second",
    ),
    ("SHIFT Y 1 0 0 0 SHIFT F 5 0 0 *", "the same of Y"),
    ("SHIFT X - 1 0 0 0 *", "X back"),
    ("SHIFT Y - 1 0 0 0 *", "Y back: the square is closed"),
    ("SHIFT M 2 *", "M2 ends the program"),
    (
        "AUT EXC",
        "runs it: `RUN   05`, `RUNNING`, and `READY` at the end",
    ),
];
