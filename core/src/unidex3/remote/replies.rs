//! What the controller is told (4-7; spec, "Remote interface").

use super::Interface;
use crate::time::Nanos;
use crate::unidex3::Unidex3;
use crate::unidex3::indexer::Axis;
use crate::unidex3::run::{Register, Wait, formatted};
use crate::unidex3::trouble::Trouble;

const LINE_END: &[u8] = b"\r\n";
/// Replies that several units give in turn: Q, PS, PX, PY.
pub(super) const TURNS: usize = 4;

/// One of them.
#[derive(Debug, Clone, Copy)]
enum Turn {
    Poll,
    Status,
    X,
    Y,
}

impl Unidex3 {
    /// Whether it is this unit's turn: they answer from the lowest address to the highest, one each time (4-7 C).
    fn takes_turn(&mut self, turn: Turn) -> bool {
        if self.remote.interface == Interface::Bus {
            return true;
        }
        let (own, units) = self.remote.turn;
        let Some(asked) = self.remote.asked.get_mut(turn as usize) else {
            return false;
        };
        let mine = *asked == own;
        *asked = (*asked + 1) % units.max(1);
        mine
    }

    /// Status bytes, on the line in hexadecimal digits after U.
    fn status_text(&self, bytes: &[u8]) -> Vec<u8> {
        match self.remote.hexadecimal && self.remote.interface == Interface::Serial {
            true => bytes
                .iter()
                .flat_map(|byte| format!("{byte:02X}").into_bytes())
                .collect(),
            false => bytes.to_vec(),
        }
    }

    /// Q: the status byte. The request is answered.
    pub(super) fn poll(&mut self, _now: Nanos) {
        if !self.takes_turn(Turn::Poll) {
            return;
        }
        let status = self.status_text(&[self.poll_byte()]);
        let end = [self.memory.end_of_file];
        self.line.send(&[&status, LINE_END, &end].concat());
        self.remote.answer_request();
    }

    /// Whether a listing that the controller has asked for is under way.
    pub(in crate::unidex3) fn is_listing(&self) -> bool {
        self.remote.lists && (self.line.unsent() > 0 || self.remote.bus.unsent() > 0)
    }

    /// Sends a reply; on the bus a listing ends with EOI (4-7).
    fn reply(&mut self, bytes: &[u8], ends: bool) {
        self.remote.lists = ends;
        match self.remote.interface {
            Interface::Serial => self.line.send(bytes),
            Interface::Bus => self.remote.bus.reply(bytes, ends),
        }
    }

    pub(super) fn print_command(&mut self, packed: &[u8]) {
        let reply = match packed {
            b"S" => {
                if !self.takes_turn(Turn::Status) {
                    return;
                }
                let status = self.status_text(&self.status_bytes());
                [&status, LINE_END].concat()
            }
            b"X" | b"Y" => {
                let (axis, turn) = match packed {
                    b"X" => (Axis::X, Turn::X),
                    _ => (Axis::Y, Turn::Y),
                };
                if !self.takes_turn(turn) {
                    return;
                }
                self.position(Register::Position(axis))
            }
            b"N" => [&[self.run.halt_number.unwrap_or(0)], LINE_END].concat(),
            b"M" => [&self.run.buffer.0, LINE_END].concat(),
            b"D" => {
                self.cancel_halt();
                self.list_directory()
            }
            [b'X' | b'Y', _] => match Register::from_name(packed) {
                Some(register) => self.position(register),
                None => return self.refuse(Trouble::IllegalCharacter),
            },
            digits => {
                let text = std::str::from_utf8(digits).unwrap_or_default();
                match text.parse() {
                    Ok(number) if self.is_protected(number) => return self.remote.request(),
                    Ok(0) => {
                        self.cancel_halt();
                        self.list_memory()
                    }
                    Ok(number) => match self.list_program(number) {
                        Some(listing) => {
                            self.cancel_halt();
                            listing
                        }
                        None => return self.refuse(Trouble::NoProgram),
                    },
                    Err(_) => return self.refuse(Trouble::IllegalCharacter),
                }
            }
        };
        let lists = matches!(packed, [b'D'] | [b'0'..=b'9', ..]);
        self.reply(&reply, lists);
    }

    fn refuse(&mut self, trouble: Trouble) {
        self.errors.note(trouble);
        self.remote.request();
    }

    /// A directory or a program ends a G25 (6-10).
    fn cancel_halt(&mut self) {
        if self.executing && self.run.wait == Some(Wait::Halt) {
            let at = self.next;
            self.cancel(at);
        }
    }

    /// `X0000001000`.
    fn position(&self, register: Register) -> Vec<u8> {
        let value = self.run.register(register, &self.indexer);
        let letter = register.word().bytes().next().unwrap_or(b'X');
        let sign: &[u8] = if value < 0 { b"-" } else { b"" };
        let digits = formatted(value.saturating_abs(), 10);
        [&[letter], sign, &digits, LINE_END].concat()
    }
}
