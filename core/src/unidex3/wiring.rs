//! What stands around a Unidex on the bench: switches at its inputs, lamps at its M outputs.

use crate::controller::{Handle, Lamps, Wired};

/// The C inputs; an open one reads high.
pub const INPUTS: &[Wired] = &[
    input("C1", "Input C1"),
    input("C2", "Input C2"),
    input("C3", "Input C3"),
    input("C4", "Input C4"),
];

/// The M outputs.
pub const LAMPS: Lamps = Lamps {
    signal: "m",
    labels: &["M1", "M2", "M3", "M4", "M5", "M6", "M7", "M8"],
};

const fn input(label: &'static str, name: &'static str) -> Wired {
    Wired {
        label,
        name,
        wire: label,
        handle: Handle::Switch,
        at: 1.0,
    }
}
