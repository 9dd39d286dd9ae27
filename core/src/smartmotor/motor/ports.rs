//! The seven pins UA to UG.

use std::fmt;

/// A pin of the I/O connector.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Port {
    /// Encoder A, or steps.
    A,
    /// Encoder B, or direction.
    B,
    /// Right (positive) limit.
    C,
    /// Left (negative) limit.
    D,
    /// General; the bench wires the home switch to it (D184).
    E,
    /// General.
    F,
    /// GO input.
    G,
}

impl Port {
    /// All, in order.
    pub const ALL: [Port; 7] = [
        Port::A,
        Port::B,
        Port::C,
        Port::D,
        Port::E,
        Port::F,
        Port::G,
    ];

    /// `UA` to `UG`.
    pub fn from_word(word: &str) -> Option<Port> {
        let letter = match word.as_bytes() {
            [b'U', letter] => letter,
            _ => return None,
        };
        let number = letter.checked_sub(b'A')?;
        Port::ALL.get(usize::from(number)).copied()
    }

    /// Its bit among the pins.
    const fn mask(self) -> u8 {
        1 << self as u8
    }
}

/// `UA` to `UG`.
impl fmt::Display for Port {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "U{self:?}")
    }
}

/// The level of a pull-up, in V.
const HIGH: f64 = 5.0;
/// From here on a pin reads 1, in V.
const THRESHOLD: f64 = 2.5;
/// `UAA` at 5 V.
const FULL_SCALE: f64 = 1023.0;

/// The pins: what is wired to them, and what the program has made of them. Bit n is pin n, UA first.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Pins {
    /// Outside, in V; where nothing is wired the pull-up's.
    wired: [f64; 7],
    /// `wired` as levels.
    outside: u8,
    /// Made outputs.
    outputs: u8,
    /// What an output gives.
    latch: u8,
    /// UC is the right limit, UD the left one, UG the GO input.
    special: u8,
    /// A limit is active while its pin is high.
    pub limits_high: bool,
    /// Switches that the mechanics press: their pins read active.
    pressed: u8,
    /// The pin that the brake signal leaves by, and the signal: high while the brake is released.
    brake: Option<Port>,
    released: bool,
}

/// The pins that the limit switches and GO may have.
const SPECIAL: u8 = Port::C.mask() | Port::D.mask() | Port::G.mask();

impl Pins {
    /// Nothing is wired; as at power-up.
    pub fn new() -> Pins {
        Pins {
            wired: [HIGH; 7],
            outside: 0x7F,
            outputs: 0,
            latch: 0,
            special: SPECIAL,
            limits_high: false,
            pressed: 0,
            brake: None,
            released: true,
        }
    }

    /// As at power-up: all inputs, UC and UD limits, UG GO. What is wired stays.
    pub fn reset(&mut self) {
        (self.outputs, self.latch, self.special) = (0, 0, SPECIAL);
        (self.limits_high, self.brake) = (false, None);
    }

    /// Puts a voltage on a pin; an output overrides it.
    pub fn wire(&mut self, port: Port, volts: f64) {
        if let Some(wired) = self.wired.get_mut(port as usize) {
            *wired = volts.clamp(0.0, HIGH);
        }
        self.outside = change(self.outside, port, volts >= THRESHOLD);
    }

    /// `UAI`.
    pub fn make_input(&mut self, port: Port) {
        self.outputs = change(self.outputs, port, false);
        self.special = change(self.special, port, false);
    }

    /// `UAO`.
    pub fn make_output(&mut self, port: Port) {
        self.special = change(self.special, port, false);
        self.outputs = change(self.outputs, port, true);
    }

    /// `UCP`, `UDM`, `UG`.
    pub fn make_special(&mut self, port: Port) {
        self.outputs = change(self.outputs, port, false);
        self.special = change(self.special, port, true) & SPECIAL;
    }

    /// `BRKC`, `BRKG`, `BRKI`.
    pub fn brake_by(&mut self, port: Option<Port>) {
        self.brake = port;
        if let Some(port) = port {
            self.make_output(port);
        }
    }

    /// `UA=`: what the pin gives when it is an output.
    pub fn write(&mut self, port: Port, on: bool) {
        self.latch = change(self.latch, port, on);
    }

    /// What the mechanics do in this sample: limit switches and home switch, and whether the brake is released.
    #[inline]
    pub fn mechanics(&mut self, right: bool, left: bool, home: bool, released: bool) {
        self.pressed = u8::from(right) << Port::C as u8
            | u8::from(left) << Port::D as u8
            | u8::from(home) << Port::E as u8;
        self.released = released;
    }

    /// All levels as a program reads them. A pressed limit switch pulls to the level that is active; the home switch
    /// pulls to ground.
    #[inline]
    pub fn levels(&self) -> u8 {
        let inputs = if self.limits_high {
            (self.outside | self.pressed) & !(self.pressed & Port::E.mask())
        } else {
            self.outside & !self.pressed
        };
        let mut latch = self.latch;
        if let Some(port) = self.brake {
            latch = change(latch, port, self.released);
        }
        inputs & !self.outputs | latch & self.outputs
    }

    /// `UAI` as a value.
    pub fn level(&self, port: Port) -> bool {
        self.levels() & port.mask() != 0
    }

    /// `UAA`: 0 to 1023 for 0 to 5 V.
    #[allow(clippy::cast_possible_truncation)] // 0 to 1023
    pub fn analog(&self, port: Port) -> i32 {
        let driven = (self.outputs | self.pressed) & port.mask() != 0;
        let volts = match self.wired.get(port as usize) {
            Some(volts) if !driven => *volts,
            _ if self.level(port) => HIGH,
            _ => 0.0,
        };
        (volts / HIGH * FULL_SCALE + 0.5) as i32
    }

    /// Whether the right and the left limit are active.
    #[inline]
    pub fn limits(&self) -> (bool, bool) {
        let active = if self.limits_high {
            self.levels()
        } else {
            !self.levels()
        } & self.special;
        (active & Port::C.mask() != 0, active & Port::D.mask() != 0)
    }

    /// Whether the GO input asks for motion: it is low.
    #[inline]
    pub fn go(&self) -> bool {
        !self.levels() & self.special & Port::G.mask() != 0
    }
}

fn change(bits: u8, port: Port, on: bool) -> u8 {
    if on {
        bits | port.mask()
    } else {
        bits & !port.mask()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_are_the_ports() {
        for port in Port::ALL {
            assert_eq!(Port::from_word(&port.to_string()), Some(port));
        }
        assert_eq!(Port::from_word("UH"), None);
        assert_eq!(Port::from_word("U"), None);
    }

    #[test]
    fn inputs_are_pulled_up_until_something_is_wired() {
        let mut pins = Pins::new();
        assert_eq!((pins.levels(), pins.analog(Port::A)), (0x7F, 1023));
        pins.wire(Port::A, 1.25);
        assert_eq!((pins.level(Port::A), pins.analog(Port::A)), (false, 256));
        pins.make_output(Port::A);
        pins.write(Port::A, true);
        assert_eq!((pins.level(Port::A), pins.analog(Port::A)), (true, 1023));
        pins.reset();
        assert!(!pins.level(Port::A));
    }

    #[test]
    fn limits_have_a_level_and_can_be_plain() {
        let mut pins = Pins::new();
        assert_eq!(pins.limits(), (false, false));
        pins.mechanics(true, false, false, true);
        assert_eq!((pins.limits(), pins.level(Port::C)), ((true, false), false));
        pins.limits_high = true;
        pins.wire(Port::D, 0.0);
        assert_eq!((pins.limits(), pins.level(Port::C)), ((true, false), true));
        pins.make_input(Port::C);
        assert_eq!(pins.limits(), (false, false));
        pins.make_special(Port::C);
        assert_eq!(pins.limits(), (true, false));
    }
}
