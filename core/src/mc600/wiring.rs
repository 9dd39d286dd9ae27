//! What stands around an MC-600 on the bench: switches at its inputs, lamps at its outputs, what turns
//! its master encoder, and voltages.

use crate::controller::{Handle, Lamps, Range, Wired};

/// Inputs 0 to 7 are on the card, 8 to 11 on the drive, whose ENABLE is the last.
pub const INPUTS: &[Wired] = &[
    input("0", "Input 0", "in0"),
    input("1", "Input 1", "in1"),
    input("2", "Input 2", "in2"),
    input("3", "Input 3", "in3"),
    input("4", "Input 4", "in4"),
    input("5", "Input 5", "in5"),
    input("6", "Input 6", "in6"),
    input("7", "Input 7", "in7"),
    input("8", "Input 8", "in8"),
    input("9", "Input 9", "in9"),
    input("10", "Input 10", "in10"),
    input("11", "Input 11", "in11"),
    Wired {
        at: 1.0,
        ..input("ENABLE", "Input 12, ENABLE of the drive", "in12")
    },
    knob("enc", "Master encoder", "encoder", 3000.0, 10.0, "rpm"),
    Wired {
        handle: Handle::Jog(&[-1000.0, -10.0, 10.0, 1000.0]),
        ..input("jog", "Master encoder, counts", "encoder.counts")
    },
    knob("an1", "Analog input 1", "anin1", 10.0, 0.05, "V"),
    knob("an2", "Analog input 2", "anin2", 10.0, 0.05, "V"),
];

/// The place of ENABLE among the inputs.
pub const ENABLE: usize = 12;

/// Outputs 0 to 7 are on the card, 8 and 9 on the drive.
pub const LAMPS: Lamps = Lamps {
    signal: "outputs",
    labels: &["0", "1", "2", "3", "4", "5", "6", "7", "8", "9"],
    strobe: None,
};

/// From `-most` to `most`.
const fn knob(
    label: &'static str,
    name: &'static str,
    wire: &'static str,
    most: f64,
    step: f64,
    unit: &'static str,
) -> Wired {
    Wired {
        handle: Handle::Knob(Range {
            from: -most,
            to: most,
            step,
            unit,
        }),
        ..input(label, name, wire)
    }
}

const fn input(label: &'static str, name: &'static str, wire: &'static str) -> Wired {
    Wired {
        label,
        name,
        wire,
        handle: Handle::Switch,
        at: 0.0,
    }
}
