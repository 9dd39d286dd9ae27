//! What a person meets at the unit: what is printed on the keys of the front panel, the switches of the rear panel and
//! the jumpers inside, and the joystick.

use crate::controller::{Binary, Choices, Face, Joystick, Keycap, Setting};

/// All of it.
pub const FACE: Face = Face {
    keys: KEYS,
    settings: SETTINGS,
    joystick: Joystick {
        wires: ["joyx", "joyy", "joybutton"],
        most: 10_000.0, // D350
    },
    selector: super::switches::PAIR,
    steps: super::first_steps::PANEL,
};

/// The keys: those of the pad, row by row, and the others as the front panel groups them (2-3; spec, "Keycap layout").
const KEYS: &[Keycap] = &[
    pad("7", "G", ""),
    pad("8", "F", ""),
    pad("9", "", "H"),
    pad("=", "X", ""),
    pad("4", "", "J"),
    pad("5", "", "O"),
    pad("6", "", "Q"),
    pad("-", "Y", ""),
    pad("1", "", "B"),
    pad("2", "", "C"),
    pad("3", "", "U"),
    pad("*", "M", ""),
    pad("0", "", "V"),
    pad("<", "D", ""),
    pad(">", "N", ""),
    pad("+", "\"", ""),
    key("EDT", "edit", "", ("E", "")),
    key("AUT", "auto", "", ("A", "")),
    key("SGL", "single", "", ("S", "")),
    key("IMD", "immediate", "", ("I", "")),
    key("RMT", "remote", "", ("R", "")),
    key("SHIFT", "", "", ("", "")),
    key("PRT", "print", "", ("P", "/")),
    key("RES", "reset", "", ("", "")),
    key("CE", "clear entry", "CC", ("", "")),
    key("EXC", "execute", "", ("", "")),
    key("SLW", "slew", "SCH", ("L", "\u{2423}")),
    key("BST", "backstep", "", ("K", "Z")),
    key("STP", "step", "", ("T", "W")),
    arrow("UP", "Y axis forwards", "\u{25b2}"),
    arrow("DOWN", "Y axis backwards", "\u{25bc}"),
    arrow("LEFT", "X axis backwards", "\u{25c0}"),
    arrow("RIGHT", "X axis forwards", "\u{25b6}"),
    arrow("CLRX", "clear the X display", "CLR"),
    arrow("CLRY", "clear the Y display", "CLR"),
];

const fn pad(legend: &'static str, shifted: &'static str, message: &'static str) -> Keycap {
    key(legend, "", shifted, ("", message))
}

const fn key(
    legend: &'static str,
    name: &'static str,
    shifted: &'static str,
    message: (&'static str, &'static str),
) -> Keycap {
    Keycap {
        key: legend,
        name,
        legends: (legend, shifted),
        message,
    }
}

const fn arrow(key: &'static str, name: &'static str, legend: &'static str) -> Keycap {
    Keycap {
        key,
        name,
        legends: (legend, ""),
        message: ("", ""),
    }
}

/// Tables 2-1 to 2-3, figures 2-4 and 2-5.
const SETTINGS: &[Setting] = &[
    Setting {
        key: "address",
        name: "Device address",
        place: "switches 4 to 8",
        choices: Choices::Binary(Binary {
            first: 4,
            switches: 5,
            from: 0,
            to: 30,
            at: 1,
        }),
    },
    Setting {
        key: "ppr",
        name: "Parallel poll",
        place: "switches 1 to 3, IEEE-488",
        choices: Choices::Binary(Binary {
            first: 1,
            switches: 3,
            from: 1,
            to: 8,
            at: 1,
        }),
    },
    Setting {
        key: "last",
        name: "Last device",
        place: "switch, of a daisy chain",
        choices: Choices::Words(&[("ON", ""), ("OFF", "last=no")]),
    },
    Setting {
        key: "baud",
        name: "Baud rate",
        place: "switches, serial line",
        choices: Choices::Words(&[
            ("50", "baud=50"),
            ("75", "baud=75"),
            ("110", "baud=110"),
            ("150", "baud=150"),
            ("300", "baud=300"),
            ("600", "baud=600"),
            ("1200", "baud=1200"),
            ("1800", "baud=1800"),
            ("2400", "baud=2400"),
            ("3600", "baud=3600"),
            ("4800", "baud=4800"),
            ("7200", "baud=7200"),
            ("9600", ""),
            ("19200", "baud=19200"),
            ("38400", "baud=38400"),
        ]),
    },
    Setting {
        key: "format",
        name: "Format",
        place: "switches, serial line",
        choices: Choices::Words(&[
            ("8 bits, no parity, 1 stop bit", ""),
            ("8 bits, no parity, 2 stop bits", "format=8N2"),
            ("8 bits, even parity, 1 stop bit", "format=8E1"),
            ("8 bits, odd parity, 1 stop bit", "format=8O1"),
            ("7 bits, even parity, 1 stop bit", "format=7E1"),
            ("7 bits, odd parity, 1 stop bit", "format=7O1"),
            ("7 bits, even parity, 2 stop bits", "format=7E2"),
            ("7 bits, odd parity, 2 stop bits", "format=7O2"),
        ]),
    },
    Setting {
        key: "oem",
        name: "Programs 50 to 99",
        place: "OEM jumper",
        choices: Choices::Words(&[("IN: open to the user", ""), ("OUT: protected", "oem=out")]),
    },
    Setting {
        key: "configuration",
        name: "Drives and home",
        place: "JP9 to JP16, JP24 to JP27",
        choices: Choices::Words(&[
            ("DC servo, hardware home", ""),
            ("Stepper, low speed, hardware home", "drive=stepper"),
            ("Stepper, high speed, hardware home", "drive=stepper-high"),
            (
                "Stepper, low speed, software home X CW, Y CW",
                "drive=stepper home=software",
            ),
            (
                "Stepper, low speed, software home X CW, Y CCW",
                "drive=stepper home=software home-y=ccw",
            ),
            (
                "Stepper, low speed, software home X CCW, Y CW",
                "drive=stepper home=software home-x=ccw",
            ),
            (
                "Stepper, low speed, software home X CCW, Y CCW",
                "drive=stepper home=software home-x=ccw home-y=ccw",
            ),
        ]),
    },
    Setting {
        key: "direction",
        name: "Direction",
        place: "JP5 (X), JP7 (Y)",
        choices: Choices::Words(&[
            ("Both standard", ""),
            ("X reversed", "reversed=x"),
            ("Y reversed", "reversed=y"),
            ("Both reversed", "reversed=xy"),
        ]),
    },
    Setting {
        key: "debounce",
        name: "C inputs",
        place: "JP20 to JP23",
        choices: Choices::Words(&[("1-2: debounced", ""), ("2-3: direct", "debounce=no")]),
    },
    Setting {
        key: "limit",
        name: "A limit in remote",
        place: "JP37",
        choices: Choices::Words(&[
            ("IN: gives the unit to the panel", ""),
            ("OUT: stays in remote", "jp37=out"),
        ]),
    },
    Setting {
        key: "clock",
        name: "Clock pulses",
        place: "JP46 (Y), JP47 (X)",
        choices: Choices::Words(&[
            ("1 \u{b5}s", ""),
            ("2 \u{b5}s", "clock=2"),
            ("3 \u{b5}s", "clock=3"),
            ("4 \u{b5}s", "clock=4"),
        ]),
    },
    Setting {
        key: "keyboard",
        name: "Keyboard",
        place: "JP38 to JP45",
        choices: Choices::Words(&[
            ("Fitted", ""),
            ("None", "keyboard=no"),
            ("One for 2 units, with a selector", "units=2"),
            ("One for 3 units, with a selector", "units=3"),
            ("One for 4 units, with a selector", "units=4"),
            ("One for 5 units, with a selector", "units=5"),
            ("One for 6 units, with a selector", "units=6"),
            ("One for 7 units, with a selector", "units=7"),
            ("One for 8 units, with a selector", "units=8"),
        ]),
    },
    Setting {
        key: "memory",
        name: "User memory",
        place: "option",
        choices: Choices::Words(&[("4 KB", ""), ("28 KB", "memory=28k")]),
    },
];

#[cfg(test)]
mod tests {
    use super::super::keys::{self, Stroke};
    use super::super::{Unidex3, units};
    use super::*;

    fn letter(text: &str) -> Option<u8> {
        match text.as_bytes() {
            [letter] => Some(*letter),
            _ if text == "\u{2423}" => Some(b' '),
            _ => None,
        }
    }

    #[test]
    fn keys_mean_what_is_printed_on_them() {
        for cap in KEYS {
            let (key, shifted) = keys::named(cap.key).unwrap();
            assert!(!shifted, "{}", cap.key);
            for shift in [false, true] {
                let of =
                    |(plain, shifted): (&str, &str)| letter(if shift { shifted } else { plain });
                // A mode key types its letter behind SHIFT too.
                let typed = of(cap.message)
                    .or(of(cap.legends))
                    .or(letter(cap.message.0));
                let character = |message| match keys::stroke(key, shift, message) {
                    Some(Stroke::Character(character)) => Some(character),
                    _ => None,
                };
                assert_eq!(character(false), of(cap.legends), "{} {shift}", cap.key);
                assert_eq!(character(true), typed, "{} {shift}", cap.key);
            }
        }
    }

    #[test]
    fn every_switch_and_jumper_can_be_set() {
        for setting in SETTINGS {
            let choices: Vec<String> = match setting.choices {
                Choices::Words(choices) => {
                    choices.iter().map(|choice| choice.1.to_owned()).collect()
                }
                Choices::Binary(binary) => (binary.from..=binary.to)
                    .map(|number| format!("{}={number}", setting.key))
                    .collect(),
            };
            for options in choices {
                let words = options.split_whitespace();
                let given: Vec<(String, String)> = words
                    .map(|word| word.split_once('=').unwrap())
                    .map(|(key, value)| (key.to_owned(), value.to_owned()))
                    .collect();
                for unit in units::units(&given).unwrap() {
                    assert!(Unidex3::new(&unit).is_ok(), "{options}");
                }
            }
        }
    }
}
