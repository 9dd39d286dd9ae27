//! What each command of the controller does.

use super::{Again, EndEntry, Interface};
use crate::time::Nanos;
use crate::unidex3::firmware::text;
use crate::unidex3::panel::Mode;
use crate::unidex3::run::{Kind, Wait};
use crate::unidex3::trouble::Trouble;
use crate::unidex3::{Link, Unidex3, words};

/// Hexadecimal pairs of W (4-9 F).
const MOST_PAIRS: usize = 4;

impl Unidex3 {
    /// Carries out a command.
    pub(super) fn command(&mut self, now: Nanos, line: &[u8]) {
        if self.remote.end_entry == EndEntry::Code {
            return self.enter_end(line);
        }
        let start = line.iter().take_while(|&&byte| byte == b' ').count();
        let line = line.get(start..).unwrap_or_default();
        let Some((&letter, rest)) = line.split_first() else {
            return self.again(now);
        };
        let packed: Vec<u8> = rest.iter().copied().filter(|&byte| byte != b' ').collect();
        let of_line = matches!(
            letter,
            b'Q' | b'C' | b'L' | b'T' | b'J' | b'K' | b'U' | b'W' | b'Z'
        );
        if !self.knows(word(letter, &packed)) || (of_line && self.is_remote_by(Interface::Bus)) {
            return;
        }
        if letter != b'Q' {
            self.end_edit();
        }
        match letter {
            b'Q' => self.poll(now),
            b'E' => self.edit_command(now, &packed),
            b'A' | b'S' => self.start_command(now, letter, &packed),
            b'I' => {
                let mut in_message = false;
                let text = words::packed(rest, &mut in_message).into();
                self.start(now, Again::Immediate(text));
            }
            b'R' => self.panel.mode = Mode::None,
            b'V' => self.begin_test(now, false, true),
            b'B' => self.end_halt(),
            b'P' => self.print_command(&packed),
            b'W' => self.configure_request(rest),
            b'U' => self.remote.hexadecimal = true,
            b'Z' => {
                self.remote.string = None;
                self.remote.hexadecimal = false;
            }
            b'C' => self.clear_device(now),
            b'H' => self.remote.hold = true,
            b'O' => {
                self.remote.hold = false;
                self.remote.held = None;
            }
            b'T' => self.trigger(now),
            b'J' => self.remote.parallel = false,
            b'K' => self.remote.parallel = true,
            b'L' => self.go_to_local(now),
            b'%' | b'&' | b';' => {}
            _ => {
                self.errors.note(Trouble::IllegalCharacter);
                self.remote.request();
            }
        }
    }

    /// B: on behind a G25. A person may have had the unit meanwhile (6-10).
    fn end_halt(&mut self) {
        if self.executing && self.run.wait == Some(Wait::Halt) {
            self.remote_run = true;
            self.resume();
        }
    }

    /// A bare CR LF: the same again, or the next block.
    fn again(&mut self, now: Nanos) {
        if self.executing || self.remote.edit.is_some() {
            return;
        }
        if let Some(again) = self.remote.again.clone() {
            match again {
                Again::Single(_) if self.next_block => self.go_on(),
                again => self.start(now, again),
            }
        }
    }

    fn start_command(&mut self, now: Nanos, letter: u8, packed: &[u8]) {
        let (digits, held) = match packed.split_last() {
            Some((b'H', digits)) => (digits, true),
            _ => (packed, false),
        };
        let Some(number) = program_number(digits).filter(|&number| number > 0) else {
            self.errors.note(Trouble::NoProgram);
            return self.remote.request();
        };
        self.remote.hold |= held;
        self.start(
            now,
            match letter {
                b'A' => Again::Auto(number),
                _ => Again::Single(number),
            },
        );
    }

    /// Starts something, or holds it for T.
    fn start(&mut self, now: Nanos, what: Again) {
        match self.remote.hold {
            true => self.remote.held = Some(what),
            false => self.start_now(now, what),
        }
    }

    /// What was held starts.
    pub(super) fn trigger(&mut self, now: Nanos) {
        self.end_edit();
        self.remote.hold = false;
        if let Some(held) = self.remote.held.take() {
            self.start_now(now, held);
        }
    }

    fn start_now(&mut self, now: Nanos, what: Again) {
        self.remote.again = Some(what.clone());
        match what {
            Again::Auto(number) => {
                self.panel.mode = Mode::Auto { select: false };
                self.panel.number = Some(number);
                self.start_program(now, number, Kind::Auto);
            }
            Again::Single(number) => {
                self.panel.mode = Mode::Single { select: false };
                self.panel.number = Some(number);
                self.start_program(now, number, Kind::Single);
            }
            Again::Immediate(text) => {
                self.panel.mode = Mode::Immediate;
                self.start_text(now, None, text, Kind::Immediate);
            }
        }
    }

    /// `E nn`, `E $ nn`, `E N`.
    fn edit_command(&mut self, now: Nanos, packed: &[u8]) {
        match packed {
            b"N" => {
                self.remote.end_entry = EndEntry::Code;
                self.say(text::ENTER);
            }
            [b'$', digits @ ..] => match program_number(digits) {
                Some(number) if !self.is_protected(number) => self.erase(number),
                _ => self.remote.request(),
            },
            digits => match program_number(digits) {
                Some(number) if number > 0 && !self.is_protected(number) => {
                    self.open_edit(now, number);
                }
                _ => self.remote.request(),
            },
        }
    }

    fn erase(&mut self, number: u8) {
        match number {
            0 => self.memory.clear(),
            number => drop(self.memory.remove(number)),
        }
        self.memory.seal();
    }

    /// The code behind `E N`.
    fn enter_end(&mut self, line: &[u8]) {
        self.remote.end_entry = EndEntry::None;
        let digits: Vec<u8> = line.iter().copied().filter(|&byte| byte != b' ').collect();
        let code = std::str::from_utf8(&digits)
            .ok()
            .and_then(|text| text.parse().ok());
        match code {
            Some(code) => self.memory.end_of_file = code,
            None => self.remote.request(),
        }
        self.say(text::REMOTE);
    }

    /// `W % 0D 0A`: the first character as it is, then pairs of digits; a last one alone is padded with 0.
    fn configure_request(&mut self, rest: &[u8]) {
        let mut characters = rest.iter().copied().filter(|&byte| byte != b' ');
        let Some(first) = characters.next() else {
            return;
        };
        let digits: Vec<u8> = characters
            .filter_map(|byte| char::from(byte).to_digit(16))
            .filter_map(|digit| u8::try_from(digit).ok())
            .collect();
        let pairs = digits.chunks(2).take(MOST_PAIRS).map(|pair| match *pair {
            [high, low] => high << 4 | low,
            [high] => high << 4,
            _ => 0,
        });
        self.remote.string = Some(std::iter::once(first).chain(pairs).collect());
    }

    /// L: local with remote enabled.
    pub(super) fn go_to_local(&mut self, now: Nanos) {
        if self.link != Link::Remote {
            return;
        }
        self.end_edit();
        self.leave_manual(now);
        self.remote.addressed = false;
        self.remote.line.clear();
        self.remote.waiting.clear();
        self.link = Link::Enabled;
        self.panel.mode = Mode::None;
        match self.run.wait {
            Some(Wait::Halt) if self.executing => {
                self.remote_run = false;
                self.show_halt();
            }
            _ if self.executing => {}
            _ => self.say(text::READY_SYSTEM),
        }
    }

    /// V has run.
    pub(in crate::unidex3) fn remote_tested(&mut self) {
        self.remote.test_result = Some(self.test_result());
        self.remote.request();
    }
}

/// One or two digits.
fn program_number(digits: &[u8]) -> Option<u8> {
    let decimal = (1..=2).contains(&digits.len()) && digits.iter().all(u8::is_ascii_digit);
    let text = std::str::from_utf8(digits).ok().filter(|_| decimal)?;
    text.parse().ok()
}

/// The table's word for a command.
pub(in crate::unidex3) fn word(letter: u8, packed: &[u8]) -> &'static str {
    match (letter, packed) {
        (b'E', b"N") => "E N",
        (b'E', b"$00") => "E $ 00",
        (b'E', [b'$', ..]) => "E $ nn",
        (b'E', _) => "E nn",
        (b'A', [.., b'H']) => "A nnH",
        (b'A', _) => "A nn",
        (b'S', _) => "S nn",
        (b'P', b"00") => "P00",
        (b'P', [b'0'..=b'9', ..]) => "Pnn",
        (b'P', b"X") => "PX",
        (b'P', b"Y") => "PY",
        (b'P', b"S") => "PS",
        (b'P', b"D") => "PD",
        (b'P', b"N") => "PN",
        (b'P', b"M") => "PM",
        (b'P', b"X1") => "PX1",
        (b'P', b"X2") => "PX2",
        (b'P', b"X3") => "PX3",
        (b'P', b"X4") => "PX4",
        (b'P', b"Y1") => "PY1",
        (b'P', b"Y2") => "PY2",
        (b'P', b"Y3") => "PY3",
        (b'P', b"Y4") => "PY4",
        (b'I', _) => "I",
        (b'R', _) => "R",
        (b'V', _) => "V",
        (b'Q', _) => "Q",
        (b'C', _) => "C",
        (b'L', _) => "L",
        (b'T', _) => "T",
        (b'H', _) => "H",
        (b'O', _) => "O",
        (b'J', _) => "J",
        (b'K', _) => "K",
        (b'W', _) => "W",
        (b'Z', _) => "Z",
        (b'U', _) => "U",
        (b'B', _) => "B",
        (b'%', _) => "%",
        (b'&', _) => "&",
        _ => "",
    }
}
