//! Asynchronous serial lines: characters as they stand on the wire, paced at the line's speed.
//!
//! A [`Transmitter`] turns bytes into [`Frame`]s, a [`Receiver`] turns frames into bytes. Both ends have their own
//! [`LineSettings`]; where they differ the receiver samples the sender's levels at its own bit times and reads what
//! a real one would: garbage.

mod receiver;
mod transmitter;

pub use receiver::{Received, Receiver};
pub use transmitter::Transmitter;

use crate::time::Nanos;

/// Stops the other side's transmitter (Ctrl-S).
pub const XOFF: u8 = 0x13;
/// Lets it go on (Ctrl-Q).
pub const XON: u8 = 0x11;

/// How one end of a line is set.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub struct LineSettings {
    /// Bits per second, 50 to 1,000,000.
    pub baud: u32,
    /// 7 or 8.
    pub data_bits: u8,
    /// The bit after the data.
    pub parity: Parity,
    /// 1 or 2.
    pub stop_bits: u8,
    /// Whether XON and XOFF are obeyed by this end's transmitter.
    pub flow: Flow,
}

/// The parity bit of a character.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[allow(missing_docs)]
pub enum Parity {
    None,
    Even,
    Odd,
}

/// Software flow control.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[allow(missing_docs)]
pub enum Flow {
    None,
    XonXoff,
}

impl LineSettings {
    /// 8 data bits, no parity, one stop bit, XON/XOFF.
    pub const fn new(baud: u32) -> LineSettings {
        LineSettings {
            baud,
            data_bits: 8,
            parity: Parity::None,
            stop_bits: 1,
            flow: Flow::XonXoff,
        }
    }

    /// Bits on the wire per character: start, data, parity, stop.
    pub fn frame_bits(&self) -> u8 {
        1 + self.data_bits + u8::from(self.parity != Parity::None) + self.stop_bits
    }

    /// The time of `bits` bits.
    pub fn time_of(&self, bits: u32) -> Nanos {
        Nanos(u64::from(bits) * 1_000_000_000 / u64::from(self.baud.max(1)))
    }

    /// The time of one character.
    pub fn character(&self) -> Nanos {
        self.time_of(u32::from(self.frame_bits()))
    }

    /// The parity bit that belongs to `byte`.
    fn parity_bit(&self, byte: u8) -> bool {
        let ones = byte.count_ones() % 2 == 1;
        match self.parity {
            Parity::None => true,
            Parity::Even => ones,
            Parity::Odd => !ones,
        }
    }

    /// `byte` without the bits that do not travel.
    fn mask(&self, byte: u8) -> u8 {
        if self.data_bits == 7 {
            byte & 0x7F
        } else {
            byte
        }
    }
}

/// One character on the wire, or a break.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Frame {
    /// When its start bit begins.
    pub start: Nanos,
    /// What is sent.
    pub symbol: Symbol,
    /// The sender's settings.
    pub settings: LineSettings,
}

/// What a frame carries.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Symbol {
    /// A character.
    Byte(u8),
    /// The line held low for two character times.
    Break,
}

impl Frame {
    /// When its last stop bit ends.
    pub fn end(&self) -> Nanos {
        match self.symbol {
            Symbol::Byte(_) => self.start + self.settings.character(),
            Symbol::Break => {
                self.start
                    + self
                        .settings
                        .time_of(2 * u32::from(self.settings.frame_bits()))
            }
        }
    }

    /// The level of the wire at `at`, which lies within the frame: `true` is mark (idle, stop, one).
    fn level(&self, at: Nanos) -> bool {
        let Symbol::Byte(byte) = self.symbol else {
            return false;
        };
        let settings = &self.settings;
        let bit = at
            .since(self.start)
            .0
            .saturating_mul(u64::from(settings.baud))
            / 1_000_000_000;
        let data = u64::from(settings.data_bits);
        if bit == 0 {
            false
        } else if bit <= data {
            (settings.mask(byte) >> (bit - 1)) & 1 == 1
        } else if bit == data + 1 && settings.parity != Parity::None {
            settings.parity_bit(settings.mask(byte))
        } else {
            true
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Sends `bytes` from one setting to another and returns what arrives.
    fn over(from: LineSettings, to: LineSettings, bytes: &[u8]) -> Vec<Received> {
        let mut transmitter = Transmitter::new(from);
        let mut receiver = Receiver::new(to);
        let mut arrived = Vec::new();
        bytes.iter().for_each(|&byte| transmitter.push(byte));
        while let Some(frame) = transmitter.next_frame(Nanos::ZERO, Nanos::MAX) {
            receiver.accept(frame);
            while let Some(received) = receiver.next(frame.end()) {
                arrived.push(received);
            }
        }
        while let Some(received) = receiver.next(Nanos::from_millis(10_000)) {
            arrived.push(received);
        }
        arrived
    }

    fn bytes(received: &[Received]) -> Vec<u8> {
        received.iter().map(|r| r.byte).collect()
    }

    #[test]
    fn equal_settings_carry_every_byte_at_line_speed() {
        let all: Vec<u8> = (0..=255).collect();
        let arrived = over(LineSettings::new(9600), LineSettings::new(9600), &all);
        assert_eq!(bytes(&arrived), all);
        assert!(arrived.iter().all(|r| !r.framing && !r.parity));
        // 256 characters of 10 bits at 9600 baud: 266.67 ms.
        let last = arrived.last().unwrap().at;
        assert!(last.0.abs_diff(266_666_666) < 1000, "{last:?}");
    }

    #[test]
    fn a_sampled_line_reads_the_same_as_a_matched_one() {
        // 8N2 into 8N1 differs in settings, not in meaning, so it takes the sampling path.
        let sender = LineSettings {
            stop_bits: 2,
            ..LineSettings::new(9600)
        };
        let all: Vec<u8> = (0..=255).collect();
        assert_eq!(bytes(&over(sender, LineSettings::new(9600), &all)), all);
    }

    #[test]
    fn a_wrong_baud_rate_gives_garbage() {
        let text = b"PRINT 2+2\r";
        for baud in [300, 1200, 2400, 4800, 19_200, 38_400, 115_200] {
            let arrived = over(LineSettings::new(baud), LineSettings::new(9600), text);
            assert_ne!(bytes(&arrived), text, "at {baud}");
        }
        // Twice too fast gives about half the characters, twice too slow about twice as many.
        assert!(
            over(
                LineSettings::new(19_200),
                LineSettings::new(9600),
                &[b'U'; 40]
            )
            .len()
                <= 25
        );
        assert!(
            over(
                LineSettings::new(4800),
                LineSettings::new(9600),
                &[b'U'; 40]
            )
            .len()
                >= 40
        );
    }

    #[test]
    fn a_wrong_parity_is_told() {
        let even = LineSettings {
            data_bits: 7,
            parity: Parity::Even,
            ..LineSettings::new(9600)
        };
        let odd = LineSettings {
            parity: Parity::Odd,
            ..even
        };
        let arrived = over(even, odd, b"AB");
        assert_eq!(bytes(&arrived), b"AB");
        assert!(arrived.iter().all(|r| r.parity));
    }

    #[test]
    fn a_break_is_a_zero_with_a_framing_error() {
        let mut receiver = Receiver::new(LineSettings::new(9600));
        let frame = Frame {
            start: Nanos::ZERO,
            symbol: Symbol::Break,
            settings: LineSettings::new(9600),
        };
        receiver.accept(frame);
        let received = receiver.next(Nanos::from_millis(100)).unwrap();
        assert_eq!((received.byte, received.framing), (0, true));
        assert_eq!(receiver.next(Nanos::from_millis(100)), None);
    }

    #[test]
    fn flow_control_characters_pass_a_held_transmitter() {
        let mut transmitter = Transmitter::new(LineSettings::new(9600));
        transmitter.push(b'A');
        transmitter.hold(true);
        transmitter.push_urgent(XOFF);
        let frame = transmitter.next_frame(Nanos::ZERO, Nanos::MAX).unwrap();
        assert_eq!(frame.symbol, Symbol::Byte(XOFF));
        assert_eq!(transmitter.next_frame(Nanos::ZERO, Nanos::MAX), None);
    }

    #[test]
    fn a_held_transmitter_finishes_its_character_and_waits() {
        let mut transmitter = Transmitter::new(LineSettings::new(9600));
        transmitter.push(b'A');
        transmitter.push(b'B');
        assert!(transmitter.next_frame(Nanos::ZERO, Nanos::MAX).is_some());
        transmitter.hold(true);
        assert_eq!(transmitter.next_frame(Nanos::ZERO, Nanos::MAX), None);
        transmitter.hold(false);
        let frame = transmitter
            .next_frame(Nanos::from_millis(50), Nanos::MAX)
            .unwrap();
        assert_eq!(frame.start, Nanos::from_millis(50));
    }
}
