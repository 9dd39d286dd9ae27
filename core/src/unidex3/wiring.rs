//! What stands around a Unidex on the bench: switches at its inputs, lamps at its M outputs.

use crate::controller::{Handle, Lamps, Range, Wired};

/// What a person sets at the connectors: the C inputs, of which an open one reads high; the feedhold inputs, which low
/// stop their axis (D298); home and limit switches, pressed wherever the axis is (D351); a clock at the external one.
pub const INPUTS: &[Wired] = &[
    switch("C1", "Input C1", "C1", 1.0),
    switch("C2", "Input C2", "C2", 1.0),
    switch("C3", "Input C3", "C3", 1.0),
    switch("C4", "Input C4", "C4", 1.0),
    switch("FX", "Feedhold input X", "feedholdx", 1.0),
    switch("FY", "Feedhold input Y", "feedholdy", 1.0),
    switch("HX", "Home switch X", "homex", 0.0),
    switch("HY", "Home switch Y", "homey", 0.0),
    switch("X\u{2212}", "Limit switch X, negative", "limitx-", 0.0),
    switch("X+", "Limit switch X, positive", "limitx+", 0.0),
    switch("Y\u{2212}", "Limit switch Y, negative", "limity-", 0.0),
    switch("Y+", "Limit switch Y, positive", "limity+", 0.0),
    Wired {
        label: "CK",
        name: "External clock",
        wire: "clockrate",
        handle: Handle::Knob(Range {
            from: 0.0,
            to: 1000.0,
            step: 10.0,
            unit: "Hz",
        }),
        at: 0.0,
    },
];

/// The M outputs.
pub const LAMPS: Lamps = Lamps {
    signal: "m",
    labels: &["M1", "M2", "M3", "M4", "M5", "M6", "M7", "M8"],
    strobe: Some("strobe"),
};

const fn switch(label: &'static str, name: &'static str, wire: &'static str, at: f64) -> Wired {
    Wired {
        label,
        name,
        wire,
        handle: Handle::Switch,
        at,
    }
}
