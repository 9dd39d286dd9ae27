//! Mode keys, and what follows them up to EXC.

use super::{Edit, Mode, Print, Unidex3};
use crate::time::Nanos;
use crate::unidex3::firmware::{LAST_PROGRAM, LOOKING, OEM_PROGRAM, TEST_KILOBYTE, text};
use crate::unidex3::indexer::Axis;
use crate::unidex3::keys::{Function, Key, Stroke};
use crate::unidex3::run::{Kind, Register};
use crate::unidex3::trouble::Trouble;
use crate::unidex3::{Busy, words};

impl Unidex3 {
    /// A key while no program runs and no axis is moved by hand.
    pub(super) fn key_in_mode(&mut self, at: Nanos, stroke: Stroke) {
        match stroke {
            Stroke::Function(
                function @ (Function::Edit
                | Function::Auto
                | Function::Single
                | Function::Immediate
                | Function::Print),
            ) => self.mode_key(function),
            Stroke::Function(Function::Remote) => self.remote_key(at),
            Stroke::Function(function @ (Function::Step | Function::Slew))
                if !self.is_editing() =>
            {
                self.enter_manual(at, function);
            }
            Stroke::Function(Function::Execute) => self.execute(at),
            _ => match self.panel.mode {
                Mode::Edit(_) => self.key_in_edit(stroke),
                Mode::Immediate => self.key_in_immediate(stroke),
                Mode::Print(_) => self.key_in_print(stroke),
                Mode::Auto { select: true } | Mode::Single { select: true } => {
                    if let Stroke::Character(digit @ b'0'..=b'9') = stroke {
                        self.panel.number = Some(shifted_in(self.panel.number, digit));
                        self.prompt();
                    }
                }
                _ => {}
            },
        }
    }

    fn is_editing(&self) -> bool {
        matches!(self.panel.mode, Mode::Edit(Edit::Program | Edit::Search(_)))
    }

    /// A mode key ends an edit; what cannot be compiled is said instead (3-4 A).
    pub(super) fn mode_key(&mut self, function: Function) {
        if !self.leave_edit() {
            return;
        }
        self.panel.message = false;
        let mode = match function {
            Function::Edit => Mode::Edit(Edit::Select),
            Function::Auto => Mode::Auto { select: true },
            Function::Single => Mode::Single { select: true },
            Function::Immediate => Mode::Immediate,
            _ => Mode::Print(Print::Program),
        };
        self.panel.mode = mode;
        self.panel.block.clear();
        self.next_block = false;
        self.prompt();
    }

    /// What the mode asks for.
    pub(in crate::unidex3) fn prompt(&mut self) {
        let selected = |verb: &str, number: Option<u8>| match number {
            Some(number) => format!("{verb} {number:02}"),
            None => text::PROMPT.to_owned(),
        };
        let number = self.panel.number;
        let message = match &self.panel.mode {
            Mode::None => return,
            Mode::Auto { .. } => selected("RUN", number),
            Mode::Single { .. } => selected("WALK", number),
            Mode::Immediate => text::ENTER.to_owned(),
            Mode::Print(Print::Program) => selected("PRNT", number),
            Mode::Print(Print::Directory) => text::PRINT_DIRECTORY.to_owned(),
            Mode::Print(Print::Message) => text::PRINT_MESSAGE.to_owned(),
            Mode::Print(Print::Register(register)) => format!("PRNT {}", register.word()),
            Mode::Edit(edit) => match edit {
                Edit::Select => selected("EDIT", number),
                Edit::Program => return self.show_edited(),
                Edit::Search(sought) => {
                    self.panel.display.typed(sought);
                    return;
                }
                Edit::Clear(None) => text::CLEAR_PROMPT.to_owned(),
                Edit::Clear(Some(number)) => format!("CLR {number:02}"),
                Edit::Boot(number) => format!("BOOT {number:02}"),
                Edit::SetUp(number) => format!("SETUP {number:02}"),
                Edit::NoBoot => text::NO_BOOT.to_owned(),
                Edit::Free => text::FREE.to_owned(),
                Edit::Test => text::TEST.to_owned(),
                Edit::ModifyEnd => text::MODIFY_EOF.to_owned(),
                Edit::EnterEnd(digits) if digits.is_empty() => text::ENTER.to_owned(),
                Edit::EnterEnd(digits) => {
                    self.panel.display.typed(digits);
                    return;
                }
            },
        };
        self.say(&message);
    }

    /// After EDT: digits, and the letters that ask for something else (2-6 E to J, 2-7 E).
    pub(super) fn key_in_selection(&mut self, edit: Edit, stroke: Stroke) {
        let start = self.memory.start();
        let digit = match stroke {
            Stroke::Character(digit @ b'0'..=b'9') => Some(digit),
            _ => None,
        };
        let next = match (edit, stroke, digit) {
            (Edit::Select, Stroke::Function(Function::ClearCommand), _) => Edit::Clear(None),
            (Edit::Select, Stroke::Character(b'F'), _) => Edit::Boot(start.boot.unwrap_or(0)),
            (Edit::Select, Stroke::Character(b'G'), _) => Edit::SetUp(start.set_up.unwrap_or(0)),
            (Edit::Select, Stroke::Character(b'M'), _) => Edit::NoBoot,
            (Edit::Select, Stroke::Character(b'D'), _) => Edit::Free,
            (Edit::Select, Stroke::Character(b'X'), _) => Edit::Test,
            (Edit::Select, Stroke::Character(b'N'), _) => Edit::ModifyEnd,
            (Edit::Select, _, Some(digit)) => {
                self.panel.number = Some(shifted_in(self.panel.number, digit));
                Edit::Select
            }
            (Edit::Clear(number), _, Some(digit)) => Edit::Clear(Some(shifted_in(number, digit))),
            (Edit::Boot(number), _, Some(digit)) => Edit::Boot(shifted_in(Some(number), digit)),
            (Edit::SetUp(number), _, Some(digit)) => Edit::SetUp(shifted_in(Some(number), digit)),
            (Edit::EnterEnd(mut digits), Stroke::Function(Function::ClearEntry), _) => {
                digits.pop();
                Edit::EnterEnd(digits)
            }
            (Edit::EnterEnd(mut digits), _, Some(digit)) => {
                // The last three digits count, as in a shift register.
                digits.push(digit);
                let first = digits.len().saturating_sub(3);
                Edit::EnterEnd(digits.split_off(first))
            }
            _ => return,
        };
        self.panel.mode = Mode::Edit(next);
        self.prompt();
    }

    /// Whether PRT takes this pad key without SHIFT.
    pub(super) fn print_takes(&self, key: Key) -> bool {
        matches!(self.panel.mode, Mode::Print(_))
            && matches!(key, Key::Pad(b'=' | b'-' | b'*' | b'<'))
    }

    fn key_in_print(&mut self, stroke: Stroke) {
        let Mode::Print(print) = self.panel.mode else {
            return;
        };
        let next = match (print, stroke) {
            (_, Stroke::Character(b'D')) => Print::Directory,
            (_, Stroke::Character(b'M')) => Print::Message,
            (_, Stroke::Character(b'X')) => Print::Register(Register::Position(Axis::X)),
            (_, Stroke::Character(b'Y')) => Print::Register(Register::Position(Axis::Y)),
            (Print::Register(register), Stroke::Character(digit @ b'1'..=b'4')) => {
                let letter = register.word().bytes().next().unwrap_or(b'X');
                match Register::from_name(&[letter, digit]) {
                    Some(register) => Print::Register(register),
                    None => return,
                }
            }
            (Print::Program, Stroke::Character(digit @ b'0'..=b'9')) => {
                self.panel.number = Some(shifted_in(self.panel.number, digit));
                Print::Program
            }
            _ => return,
        };
        self.panel.mode = Mode::Print(next);
        self.prompt();
    }

    /// EXC.
    fn execute(&mut self, at: Nanos) {
        let number = self.panel.number.unwrap_or(1);
        match self.panel.mode.clone() {
            Mode::None => {}
            Mode::Auto { .. } => {
                self.panel.mode = Mode::Auto { select: false };
                self.panel.number = Some(number);
                self.start_program(at, number, Kind::Auto);
            }
            Mode::Single { .. } => {
                self.panel.mode = Mode::Single { select: false };
                self.panel.number = Some(number);
                match self.next_block {
                    true => self.go_on(),
                    false => self.start_program(at, number, Kind::Single),
                }
            }
            Mode::Immediate => self.execute_block(at),
            Mode::Print(print) => self.print(print, number),
            Mode::Edit(edit) => self.execute_edit(at, edit),
        }
    }

    fn print(&mut self, print: Print, number: u8) {
        let listing = match print {
            Print::Program if number == 0 && self.options.oem_in => Some(self.list_memory()),
            Print::Program if self.is_protected(number) => None,
            Print::Program => self.list_program(number),
            Print::Directory => Some(self.list_directory()),
            Print::Message => Some(self.list_message()),
            Print::Register(register) => Some(self.list_register(register)),
        };
        match listing {
            Some(listing) => {
                self.line.send(&listing);
                self.busy = Some(Busy::Printing);
                self.say(text::PRINTING);
            }
            None => self.what(),
        }
    }

    /// Programs 50 to 99 are not for users while the OEM jumper is out, nor is all of the memory (4-11 A).
    pub(in crate::unidex3) fn is_protected(&self, number: u8) -> bool {
        !self.options.oem_in && (number == 0 || number >= OEM_PROGRAM)
    }

    /// WHAT?, and no mode.
    pub(super) fn what(&mut self) {
        self.panel.mode = Mode::None;
        self.say(text::WHAT);
    }

    fn execute_edit(&mut self, at: Nanos, edit: Edit) {
        match edit {
            Edit::Select => {
                let number = self.panel.number.unwrap_or(1);
                if self.is_protected(number) || number == 0 {
                    return self.what();
                }
                self.open(number);
            }
            Edit::Program => {}
            Edit::Search(sought) => {
                let found = self.find(&sought);
                self.busy = Some(Busy::Looking {
                    until: at + LOOKING,
                    found,
                });
                self.say(text::LOOKING);
            }
            Edit::Clear(number) => self.clear(number.unwrap_or(1)),
            Edit::Boot(number) => self.select_start(number, true),
            Edit::SetUp(number) => self.select_start(number, false),
            Edit::NoBoot => {
                self.memory.user = Default::default();
                if self.options.oem_in {
                    self.memory.oem = Default::default();
                }
                self.panel.mode = Mode::None;
            }
            Edit::Free => {
                let free = self.memory.free();
                self.panel.mode = Mode::None;
                self.say(&format!("{free:05}"));
            }
            Edit::Test => {
                let time = TEST_KILOBYTE.0 * u64::from(self.memory.kilobytes());
                self.busy = Some(Busy::Testing {
                    until: at + Nanos(time),
                });
                self.say(text::TESTING);
            }
            Edit::ModifyEnd => {
                self.panel.mode = Mode::Edit(Edit::EnterEnd(Vec::new()));
                self.prompt();
            }
            Edit::EnterEnd(digits) => {
                let code = std::str::from_utf8(&digits)
                    .ok()
                    .and_then(|text| text.parse().ok());
                let Some(code) = code else {
                    return self.what();
                };
                self.memory.end_of_file = code;
                self.panel.mode = Mode::None;
                self.say(text::MODIFIED);
            }
        }
    }

    /// BOOT nn, SETUP nn: one takes the other's place (2-6 G).
    fn select_start(&mut self, number: u8, boots: bool) {
        if number == 0 || number > LAST_PROGRAM {
            return self.what();
        }
        let start = self.memory.start_mut(self.options.oem_in);
        start.boot = boots.then_some(number);
        start.set_up = (!boots).then_some(number);
        self.panel.mode = Mode::None;
    }

    /// CLR nn; 00 is all of the memory, which also makes it valid (2-6 E).
    fn clear(&mut self, number: u8) {
        if self.is_protected(number) {
            return self.what();
        }
        let cleared = match number {
            0 => {
                self.memory.clear();
                true
            }
            number => self.memory.remove(number),
        };
        self.memory.seal();
        self.panel.mode = Mode::None;
        match cleared {
            true => self.say(text::CLEARED),
            false => self.what(),
        }
    }

    /// What a search finds: behind the cursor first, then from the start.
    fn find(&self, sought: &[u8]) -> Option<usize> {
        let edited = &self.panel.edited;
        if sought.is_empty() {
            return None;
        }
        let windows = edited.text.windows(sought.len());
        let ends = windows.enumerate().filter(|(_, window)| *window == sought);
        let mut ends: Vec<usize> = ends.map(|(start, _)| start + sought.len()).collect();
        let behind = ends.partition_point(|&end| end <= edited.cursor);
        ends.rotate_left(behind);
        let end = ends.first()?;
        Some(words::next_end(&edited.text, end - 1).unwrap_or(*end))
    }

    /// A search is over.
    pub(in crate::unidex3) fn looked(&mut self, found: Option<usize>) {
        self.panel.mode = Mode::Edit(Edit::Program);
        self.panel.message = false;
        match found {
            Some(at) => {
                self.panel.edited.cursor = at;
                self.show_edited();
            }
            None => self.say(text::WHAT),
        }
    }

    /// Says an error where a person is, and turns the modes off for one of the firmware's own.
    pub(in crate::unidex3) fn complain(&mut self, trouble: Trouble) {
        self.errors.note(trouble);
        self.last_error = Some(trouble.text());
        self.panel.message = false;
        if let Trouble::Internal(_) = trouble {
            self.busy = Some(Busy::Dead);
        }
        self.say(&trouble.text());
    }
}

/// A two-digit shift register; behind a `<1>` prompt the first digit gives `0d`.
fn shifted_in(number: Option<u8>, digit: u8) -> u8 {
    let before = number.unwrap_or(0) % 10;
    before * 10 + (digit - b'0')
}
