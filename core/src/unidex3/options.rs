//! What can be given when a unit is put on the bench: its jumpers and rear panel switches.

use super::firmware::LINE;
use super::indexer::{Config, Direction, DriveKind, HomeKind, Pair};
use super::keywords;
use crate::controller::Opt;
use crate::serial::{LineSettings, Parity};

/// What can be given.
pub const OPTIONS: &[Opt] = &[
    Opt {
        key: "speed",
        help: "authentic (default), fast, or how many times faster codewords run, 1 to 10000",
    },
    Opt {
        key: "memory",
        help: "user memory: 4k (default) or 28k",
    },
    Opt {
        key: "drive",
        help: "dc (default), stepper or stepper-high",
    },
    Opt {
        key: "home",
        help: "hardware (default), or software with drive=stepper",
    },
    Opt {
        key: "home-x",
        help: "the direction of the X axis's software home: cw (default) or ccw",
    },
    Opt {
        key: "home-y",
        help: "the direction of the Y axis's software home: cw (default) or ccw",
    },
    Opt {
        key: "reversed",
        help: "axes with direction N: none (default), x, y or xy",
    },
    Opt {
        key: "debounce",
        help: "yes (default): C inputs are debounced; no",
    },
    Opt {
        key: "clock",
        help: "width of a clock pulse in microseconds, 1 (default) to 4",
    },
    Opt {
        key: "address",
        help: "the device address, 0 to 30 (default: 1)",
    },
    Opt {
        key: "last",
        help: "the last-device switch: yes (default) or no",
    },
    Opt {
        key: "ppr",
        help: "the parallel poll switches: 1 (default) to 8",
    },
    Opt {
        key: "oem",
        help: "the OEM jumper: in (default) or out",
    },
    Opt {
        key: "jp37",
        help: "in (default): a limit in remote gives the unit to the panel; out",
    },
    Opt {
        key: "keyboard",
        help: "the keyboard jumpers: yes (default), no, or 1 to 8 for a panel that units share by its axis-pair selector",
    },
    Opt {
        key: "baud",
        help: "the serial line's switches: 50 to 38400 (default: 9600)",
    },
    Opt {
        key: "format",
        help: "the serial line's format: 8N1 (default), 7E1, 7O2 and the like",
    },
    Opt {
        key: "without",
        help: "a word of the keyword table that the unit does not know (default: none)",
    },
];

/// What was given.
#[derive(Debug, Clone, Copy)]
pub struct Options {
    /// Codewords take this many times less than on the device.
    pub speed: u32,
    /// User memory.
    pub kilobytes: u16,
    /// Jumpers about motion.
    pub config: Config,
    /// Device address.
    pub address: u8,
    /// The data line that answers a parallel poll, 1 to 8.
    pub poll_line: u8,
    /// Last-device switch.
    pub last: bool,
    /// OEM jumper.
    pub oem_in: bool,
    /// JP37 is in: a limit in remote goes to local.
    pub limit_goes_local: bool,
    /// The keyboard address, 1 to 8; 0 is none: keys do nothing.
    pub keyboard: u8,
    /// The panel is one for several units.
    pub shares_panel: bool,
    /// The serial line.
    pub line: LineSettings,
    /// A word that this unit lacks.
    pub without: Option<&'static str>,
}

impl Options {
    /// Reads them.
    ///
    /// # Errors
    /// One clear line about an option that does not exist or a value that it cannot have.
    pub fn new(given: &[(String, String)]) -> Result<Options, String> {
        let mut options = Options {
            speed: 1,
            kilobytes: 4,
            config: Config::default(),
            address: 1,
            poll_line: 1,
            last: true,
            oem_in: true,
            limit_goes_local: true,
            keyboard: 1,
            shares_panel: false,
            line: LINE,
            without: None,
        };
        for (key, value) in given {
            options.set(key, value)?;
        }
        let software = matches!(options.config.home, HomeKind::Software(_));
        if software && options.config.drive != DriveKind::StepperLow {
            return Err("home=software is for drive=stepper".to_owned());
        }
        Ok(options)
    }

    fn set(&mut self, key: &str, value: &str) -> Result<(), String> {
        match key {
            "speed" => self.speed = speed(value)?,
            "memory" => self.kilobytes = choice(key, value, &[("4k", 4), ("28k", 28)])?,
            "address" => {
                let address = value.parse().ok().filter(|address| *address <= 30);
                self.address = address.ok_or("address is a number from 0 to 30")?;
            }
            "ppr" => {
                let line = value.parse().ok().filter(|line| (1..=8).contains(line));
                self.poll_line = line.ok_or("ppr is a number from 1 to 8")?;
            }
            "last" => self.last = yes_or_no(key, value)?,
            "oem" => self.oem_in = in_or_out(key, value)?,
            "jp37" => self.limit_goes_local = in_or_out(key, value)?,
            "keyboard" => self.set_keyboard(value)?,
            "baud" => {
                let baud = value.parse().ok();
                let baud = baud.filter(|baud| (50..=38_400).contains(baud));
                self.line.baud = baud.ok_or("baud is a number from 50 to 38400")?;
            }
            "format" => self.set_format(value)?,
            "without" => {
                let word = keywords::find(value)
                    .ok_or_else(|| format!("unidex3 has no keyword '{value}'"))?;
                self.without = Some(word);
            }
            _ => return self.set_drive(key, value),
        }
        Ok(())
    }

    fn set_keyboard(&mut self, value: &str) -> Result<(), String> {
        let place = value.parse().ok().filter(|place| (1..=8).contains(place));
        self.shares_panel = place.is_some();
        self.keyboard = match (place, value) {
            (Some(place), _) => place,
            (None, "yes") => 1,
            (None, "no") => 0,
            (None, _) => return Err("keyboard is yes, no or a number from 1 to 8".to_owned()),
        };
        Ok(())
    }

    fn set_drive(&mut self, key: &str, value: &str) -> Result<(), String> {
        let directions = [("cw", Direction::Positive), ("ccw", Direction::Negative)];
        let config = &mut self.config;
        let home = match config.home {
            HomeKind::Software(directions) => directions,
            HomeKind::Hardware => Pair::same(Direction::Positive),
        };
        match key {
            "drive" => {
                let drives = [
                    ("dc", DriveKind::Dc),
                    ("stepper", DriveKind::StepperLow),
                    ("stepper-high", DriveKind::StepperHigh),
                ];
                config.drive = choice(key, value, &drives)?;
            }
            "home" => {
                let homes = [
                    ("hardware", HomeKind::Hardware),
                    ("software", HomeKind::Software(home)),
                ];
                config.home = choice(key, value, &homes)?;
            }
            "home-x" => {
                let x = choice(key, value, &directions)?;
                config.home = HomeKind::Software(Pair { x, ..home });
            }
            "home-y" => {
                let y = choice(key, value, &directions)?;
                config.home = HomeKind::Software(Pair { y, ..home });
            }
            "reversed" => {
                let axes = [
                    ("none", (false, false)),
                    ("x", (true, false)),
                    ("y", (false, true)),
                    ("xy", (true, true)),
                ];
                let (x, y) = choice(key, value, &axes)?;
                config.reversed = Pair { x, y };
            }
            "debounce" => config.debounced = [yes_or_no(key, value)?; 4],
            "clock" => {
                let widths = [("1", 1), ("2", 2), ("3", 3), ("4", 4)];
                config.clock_width_us = Pair::same(choice(key, value, &widths)?);
            }
            _ => {
                let known: Vec<&str> = OPTIONS.iter().map(|option| option.key).collect();
                return Err(format!(
                    "unidex3 has no option '{key}'; it has {}",
                    known.join(", ")
                ));
            }
        }
        Ok(())
    }

    fn set_format(&mut self, value: &str) -> Result<(), String> {
        let wrong = || "format is like 8N1: 7 or 8, N E or O, 1 or 2".to_owned();
        let &[bits @ (b'7' | b'8'), parity, stop @ (b'1' | b'2')] = value.as_bytes() else {
            return Err(wrong());
        };
        self.line.parity = match parity.to_ascii_uppercase() {
            b'N' => Parity::None,
            b'E' => Parity::Even,
            b'O' => Parity::Odd,
            _ => return Err(wrong()),
        };
        self.line.data_bits = bits - b'0';
        self.line.stop_bits = stop - b'0';
        Ok(())
    }
}

fn speed(value: &str) -> Result<u32, String> {
    match value {
        "authentic" => Ok(1),
        "fast" => Ok(10_000),
        value => {
            let speed = value
                .parse()
                .ok()
                .filter(|speed| (1..=10_000).contains(speed));
            speed.ok_or_else(|| "speed is authentic, fast or a number from 1 to 10000".to_owned())
        }
    }
}

/// One of the words of an option.
fn choice<T: Copy>(key: &str, value: &str, choices: &[(&str, T)]) -> Result<T, String> {
    let found = choices.iter().find(|(word, _)| *word == value);
    found.map(|&(_, choice)| choice).ok_or_else(|| {
        let words: Vec<&str> = choices.iter().map(|(word, _)| *word).collect();
        format!("{key} is {}", words.join(" or "))
    })
}

fn yes_or_no(key: &str, value: &str) -> Result<bool, String> {
    choice(key, value, &[("yes", true), ("no", false)])
}

fn in_or_out(key: &str, value: &str) -> Result<bool, String> {
    choice(key, value, &[("in", true), ("out", false)])
}
