//! What stands around a Unidex on the bench: what a person moves at its connectors, the lamps at its M outputs, and the
//! switches of its rear panel and jumpers of its boards.

use crate::controller::{Handle, Lamps, Range, Setting, Wired};

/// C inputs, feedhold inputs, joystick, external clock and home switches. C and feedhold inputs are pulled up.
pub const INPUTS: &[Wired] = &[
    switch("C1", "Input C1", "C1", 1.0),
    switch("C2", "Input C2", "C2", 1.0),
    switch("C3", "Input C3", "C3", 1.0),
    switch("C4", "Input C4", "C4", 1.0),
    switch("FX", "Feedhold input X", "feedholdx", 1.0),
    switch("FY", "Feedhold input Y", "feedholdy", 1.0),
    switch("HX", "Home switch X", "homex", 0.0),
    switch("HY", "Home switch Y", "homey", 0.0),
    switch("clk", "External clock", "clock", 1.0),
    knob(
        "rate",
        "External clock, steady",
        "clockrate",
        (0.0, 10_000.0, 10.0),
        "Hz",
    ),
    knob(
        "JX",
        "Joystick X",
        "joyx",
        (-10_000.0, 10_000.0, 100.0),
        "Hz",
    ),
    knob(
        "JY",
        "Joystick Y",
        "joyy",
        (-10_000.0, 10_000.0, 100.0),
        "Hz",
    ),
    switch("JB", "Joystick button", "joybutton", 0.0),
];

/// The M outputs.
pub const LAMPS: Lamps = Lamps {
    signal: "m",
    labels: &["M1", "M2", "M3", "M4", "M5", "M6", "M7", "M8"],
};

const OUT_IN: &[(f64, &str)] = &[(0.0, "out"), (1.0, "in")];
const OFF_ON: &[(f64, &str)] = &[(0.0, "off"), (1.0, "on")];
const WIDTHS: &[(f64, &str)] = &[(1.0, "1 us"), (2.0, "2 us"), (3.0, "3 us"), (4.0, "4 us")];
const DEBOUNCE: &[(f64, &str)] = &[(0.0, "2-3, bypassed"), (1.0, "1-2, debounced")];

/// Rear panel switches, then jumpers, as on a new bench (2-4, tables 2-1 to 2-3).
pub const SETTINGS: &[Setting] = &[
    setting("ADDRESS", "Device address", &NUMBERS, 1.0),
    setting("PPR", "Parallel poll response", PPR, 1.0),
    setting("LAST", "Last device", OFF_ON, 1.0),
    setting("BAUD", "Baud rate", BAUD, 9600.0),
    setting("BITS", "Character length", &[(7.0, "7"), (8.0, "8")], 8.0),
    setting(
        "PARITY",
        "Parity",
        &[(0.0, "none"), (1.0, "odd"), (2.0, "even")],
        0.0,
    ),
    setting("STOP", "Stop bits", &[(1.0, "1"), (2.0, "2")], 1.0),
    setting("OEM", "OEM jumper", OUT_IN, 1.0),
    setting("CONFIG", "JP9 to JP16, JP24 to JP27: system", SYSTEMS, 1.0),
    setting("JP5", "JP5: standard direction of X", OUT_IN, 1.0),
    setting("JP7", "JP7: standard direction of Y", OUT_IN, 1.0),
    setting("JP20", "JP20: C1", DEBOUNCE, 1.0),
    setting("JP21", "JP21: C2", DEBOUNCE, 1.0),
    setting("JP22", "JP22: C3", DEBOUNCE, 1.0),
    setting("JP23", "JP23: C4", DEBOUNCE, 1.0),
    setting("JP37", "JP37: a limit goes to local", OUT_IN, 1.0),
    setting("KEYBOARD", "JP38 to JP45: keyboard address", KEYBOARD, 1.0),
    setting("JP47", "JP47: clock pulse X", WIDTHS, 1.0),
    setting("JP46", "JP46: clock pulse Y", WIDTHS, 1.0),
];

/// Table 2-2.
const SYSTEMS: &[(f64, &str)] = &[
    (1.0, "DC, hardware home"),
    (2.0, "low speed stepper, hardware home"),
    (3.0, "high speed stepper, hardware home"),
    (4.0, "low speed stepper, software home X CW, Y CW"),
    (5.0, "low speed stepper, software home X CW, Y CCW"),
    (6.0, "low speed stepper, software home X CCW, Y CW"),
    (7.0, "low speed stepper, software home X CCW, Y CCW"),
];

const BAUD: &[(f64, &str)] = &[
    (50.0, "50"),
    (75.0, "75"),
    (110.0, "110"),
    (150.0, "150"),
    (300.0, "300"),
    (600.0, "600"),
    (1200.0, "1200"),
    (2400.0, "2400"),
    (4800.0, "4800"),
    (9600.0, "9600"),
    (19_200.0, "19200"),
    (38_400.0, "38400"),
];

const PPR: &[(f64, &str)] = &[
    (1.0, "PPR 1"),
    (2.0, "PPR 2"),
    (3.0, "PPR 3"),
    (4.0, "PPR 4"),
    (5.0, "PPR 5"),
    (6.0, "PPR 6"),
    (7.0, "PPR 7"),
    (8.0, "PPR 8"),
];

const KEYBOARD: &[(f64, &str)] = &[
    (0.0, "none"),
    (1.0, "JP45"),
    (2.0, "JP44"),
    (3.0, "JP43"),
    (4.0, "JP42"),
    (5.0, "JP41"),
    (6.0, "JP40"),
    (7.0, "JP39"),
    (8.0, "JP38"),
];

/// Table 2-1.
#[rustfmt::skip]
const NUMBERS: [(f64, &str); 32] = [
    (0.0, "0"), (1.0, "1"), (2.0, "2"), (3.0, "3"), (4.0, "4"), (5.0, "5"), (6.0, "6"), (7.0, "7"),
    (8.0, "8"), (9.0, "9"), (10.0, "10"), (11.0, "11"), (12.0, "12"), (13.0, "13"), (14.0, "14"), (15.0, "15"),
    (16.0, "16"), (17.0, "17"), (18.0, "18"), (19.0, "19"), (20.0, "20"), (21.0, "21"), (22.0, "22"), (23.0, "23"),
    (24.0, "24"), (25.0, "25"), (26.0, "26"), (27.0, "27"), (28.0, "28"), (29.0, "29"), (30.0, "30"), (31.0, "none"),
];

const fn switch(label: &'static str, name: &'static str, wire: &'static str, at: f64) -> Wired {
    Wired {
        label,
        name,
        wire,
        handle: Handle::Switch,
        at,
    }
}

/// `range` is the lowest and the highest value, and the step.
const fn knob(
    label: &'static str,
    name: &'static str,
    wire: &'static str,
    range: (f64, f64, f64),
    unit: &'static str,
) -> Wired {
    let (from, to, step) = range;
    Wired {
        label,
        name,
        wire,
        handle: Handle::Knob(Range {
            from,
            to,
            step,
            unit,
        }),
        at: 0.0,
    }
}

const fn setting(
    wire: &'static str,
    name: &'static str,
    positions: &'static [(f64, &'static str)],
    at: f64,
) -> Setting {
    Setting {
        name,
        wire,
        positions,
        at,
    }
}

#[cfg(test)]
mod tests {
    use super::{INPUTS, SETTINGS};
    use crate::controller::{Controller, Input};
    use crate::time::Nanos;
    use crate::unidex3::Unidex3;

    #[test]
    fn a_new_bench_stands_as_told_and_takes_every_position() {
        let mut unit = Unidex3::new(&[]).unwrap();
        unit.power(Nanos::ZERO, true);
        let status = unit.status_bytes();
        let mut set = |wire: &str, value: f64| {
            let name = wire.to_owned();
            unit.input(Nanos::ZERO, Input::Wire { name, value })
        };
        for setting in SETTINGS {
            for &(position, _) in setting.positions {
                assert_eq!(set(setting.wire, position), Ok(()), "{}", setting.wire);
            }
            assert!(set(setting.wire, 40_000.0).is_err(), "{}", setting.wire);
            assert!(set(setting.wire, 0.5).is_err(), "{}", setting.wire);
            assert_eq!(set(setting.wire, setting.at), Ok(()), "{}", setting.wire);
        }
        for input in INPUTS {
            assert_eq!(set(input.wire, input.at), Ok(()), "{}", input.wire);
        }
        assert_eq!(unit.status_bytes(), status);
    }
}
