//! What stands around a SmartMotor on the bench: a switch and a knob at each pin, what turns its counter, and lamps.

use crate::controller::{Handle, Lamps, Range, Wired};

/// The pins by their levels, which a pull-up holds at 5 V, and the external encoder.
pub const INPUTS: &[Wired] = &[
    pin("A", "Pin UA", "UAA"),
    pin("B", "Pin UB", "UBA"),
    pin("C", "Pin UC, right limit", "UCA"),
    pin("D", "Pin UD, left limit", "UDA"),
    pin("E", "Pin UE", "UEA"),
    pin("F", "Pin UF", "UFA"),
    pin("G", "Pin UG, GO", "UGA"),
    Wired {
        label: "enc",
        name: "External encoder on UA and UB",
        wire: "encoder",
        handle: Handle::Knob(Range {
            from: -1200.0,
            to: 1200.0,
            step: 10.0,
            unit: "rpm",
        }),
        at: 0.0,
    },
];

/// The levels of the pins, inputs and outputs.
pub const LAMPS: Lamps = Lamps {
    signal: "pins",
    labels: &["A", "B", "C", "D", "E", "F", "G"],
    strobe: None,
};

const fn pin(label: &'static str, name: &'static str, wire: &'static str) -> Wired {
    Wired {
        label,
        name,
        wire,
        handle: Handle::Pin(Range {
            from: 0.0,
            to: 5.0,
            step: 0.05,
            unit: "V",
        }),
        at: 5.0,
    }
}
