//! The switches and jumpers of the rear panel and the MPU board while the unit is in use (2-4, tables 2-1 to 2-3).
//!
//! They act at once (D330). `face` tells a person how they can stand.

use super::Unidex3;
use super::indexer::{Config, Direction, DriveKind, HomeKind, Pair};
use crate::serial::Parity;
use crate::time::Nanos;

/// By name, with the lowest and the highest position; all positions are whole numbers.
const SWITCHES: [(&str, f64, f64); 20] = [
    ("ADDRESS", 0.0, 31.0),
    ("PPR", 1.0, 8.0),
    ("LAST", 0.0, 1.0),
    ("BAUD", 50.0, 38_400.0),
    ("BITS", 7.0, 8.0),
    ("PARITY", 0.0, 2.0),
    ("STOP", 1.0, 2.0),
    ("OEM", 0.0, 1.0),
    ("CONFIG", 1.0, 7.0),
    ("JP5", 0.0, 1.0),
    ("JP7", 0.0, 1.0),
    ("JP20", 0.0, 1.0),
    ("JP21", 0.0, 1.0),
    ("JP22", 0.0, 1.0),
    ("JP23", 0.0, 1.0),
    ("JP37", 0.0, 1.0),
    ("JP46", 1.0, 4.0),
    ("JP47", 1.0, 4.0),
    ("KEYBOARD", 0.0, 8.0),
    (PAIR, 1.0, 8.0),
];

/// The axis-pair selector of a panel that units share.
pub const PAIR: &str = "PAIR";

/// Their names.
pub fn names() -> impl Iterator<Item = String> {
    SWITCHES.iter().map(|&(name, ..)| name.to_owned())
}

/// Whether there is one of that name.
pub fn is_switch(name: &str) -> bool {
    SWITCHES.iter().any(|&(known, ..)| known == name)
}

impl Unidex3 {
    /// Sets a switch.
    ///
    /// * `ADDRESS`: the device address, 0 to 30; 31 is none. `PPR`: the line of the parallel poll, 1 to 8.
    /// * `LAST`: the last-device switch. `OEM`, `JP37`, `JP5` and `JP7`: 1 is in; the last two out are direction N.
    /// * `BAUD`, `BITS`, `PARITY` (0 none, 1 odd, 2 even) and `STOP`: the line.
    /// * `CONFIG`: the column of table 2-2. 1 DC, 2 and 3 low and high speed stepper with hardware home, 4 to 7 low
    ///   speed stepper with software home: X and Y clockwise, Y or X counter-clockwise, both.
    /// * `JP20` to `JP23`: 1 debounces C1 to C4. `JP46` (Y) and `JP47` (X): width of a clock pulse in microseconds.
    /// * `KEYBOARD`: which of the jumpers JP45 to JP38 is in, from 1; 0 is none, and keys do nothing. `PAIR`: the
    ///   selector of a shared panel.
    ///
    /// # Errors
    /// One line if the switch has no such position.
    pub(super) fn set_switch(&mut self, at: Nanos, name: &str, value: f64) -> Result<(), String> {
        if name == PAIR && !self.options.shares_panel {
            return Err("unidex3 has its panel for itself; keyboard=1 to 8 shares one".to_owned());
        }
        let range = SWITCHES.iter().find(|&&(known, ..)| known == name);
        let fits = |&&(_, least, most): &&(&str, f64, f64)| {
            (least..=most).contains(&value) && libm::trunc(value) == value
        };
        if range.filter(fits).is_none() {
            return Err(match range {
                Some((_, least, most)) => format!("switch {name}: expected {least} to {most}"),
                None => format!("unidex3 has no switch `{name}`"),
            });
        }
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
        // whole, and within 0 to 38,400
        let position = value as u32;
        let small = u8::try_from(position).unwrap_or(u8::MAX);
        match name {
            "ADDRESS" => self.options.address = small,
            "PPR" => self.options.poll_line = small,
            "LAST" => self.options.last = small == 1,
            "OEM" => self.options.oem_in = small == 1,
            "JP37" => self.options.limit_goes_local = small == 1,
            "KEYBOARD" => self.options.keyboard = small,
            PAIR => self.pair = small,
            "BAUD" | "BITS" | "PARITY" | "STOP" => self.set_line(name, position),
            _ => self.set_jumper(at, name, small),
        }
        // Keys that are down come up where the selector leaves.
        if !self.has_keyboard() {
            self.release_arrows(at);
        }
        Ok(())
    }

    fn set_line(&mut self, name: &str, position: u32) {
        let line = &mut self.options.line;
        let small = u8::try_from(position).unwrap_or(u8::MAX);
        match name {
            "BAUD" => line.baud = position,
            "BITS" => line.data_bits = small,
            "STOP" => line.stop_bits = small,
            _ => {
                line.parity = match position {
                    0 => Parity::None,
                    1 => Parity::Odd,
                    _ => Parity::Even,
                }
            }
        }
        self.line.set(self.options.line);
    }

    fn set_jumper(&mut self, at: Nanos, name: &str, position: u8) {
        let mut config = *self.indexer.config();
        let [c1, c2, c3, c4] = &mut config.debounced;
        match name {
            "JP5" => config.reversed.x = position == 0,
            "JP7" => config.reversed.y = position == 0,
            "JP20" => *c1 = position == 1,
            "JP21" => *c2 = position == 1,
            "JP22" => *c3 = position == 1,
            "JP23" => *c4 = position == 1,
            "JP46" => config.clock_width_us.y = position,
            "JP47" => config.clock_width_us.x = position,
            _ => configure(&mut config, position),
        }
        self.indexer.set_config(at, config);
    }

    /// Whether keys reach the unit: by its keyboard address, and as the selector stands.
    pub(super) fn has_keyboard(&self) -> bool {
        self.options.keyboard == self.pair
    }
}

/// A column of table 2-2.
fn configure(config: &mut Config, column: u8) {
    use Direction::{Negative, Positive};
    config.drive = match column {
        1 => DriveKind::Dc,
        3 => DriveKind::StepperHigh,
        _ => DriveKind::StepperLow,
    };
    config.home = match column {
        4 => HomeKind::Software(Pair::same(Positive)),
        5 => HomeKind::Software(Pair {
            x: Positive,
            y: Negative,
        }),
        6 => HomeKind::Software(Pair {
            x: Negative,
            y: Positive,
        }),
        7 => HomeKind::Software(Pair::same(Negative)),
        _ => HomeKind::Hardware,
    };
}

#[cfg(test)]
mod tests {
    use super::SWITCHES;
    use crate::controller::{Controller, Input, Refused};
    use crate::time::Nanos;
    use crate::unidex3::Unidex3;

    fn set(unit: &mut Unidex3, name: &str, value: f64) -> Result<(), Refused> {
        let name = name.to_owned();
        unit.input(Nanos::ZERO, Input::Wire { name, value })
    }

    #[test]
    fn a_switch_takes_its_positions_and_no_others() {
        let keyboard = ("keyboard".to_owned(), "1".to_owned());
        let mut unit = Unidex3::new(&[keyboard]).unwrap();
        unit.power(Nanos::ZERO, true);
        for (name, least, most) in SWITCHES {
            for value in [least, most, (least + most) / 2.0] {
                let fits = libm::trunc(value) == value;
                assert_eq!(set(&mut unit, name, value).is_ok(), fits, "{name} {value}");
            }
            assert!(set(&mut unit, name, most + 1.0).is_err(), "{name}");
            assert!(set(&mut unit, name, least - 1.0).is_err(), "{name}");
        }
    }

    #[test]
    fn only_a_shared_panel_has_a_selector() {
        let mut unit = Unidex3::new(&[]).unwrap();
        assert!(set(&mut unit, super::PAIR, 1.0).is_err());
    }
}
