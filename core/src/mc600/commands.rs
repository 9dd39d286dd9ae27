//! Commands: what changes the program and starts it.

use super::ast::LineRange;
use super::code::{Op, SystemCall};
use super::compile::{compile, compile_direct};
use super::firmware::{ErrorCode, LAST_LINE, MEMORY};
use super::interrupts::Interrupts;
use super::lexer::line_number;
use super::parser::parse_line;
use super::program::Program;
use super::value::to_integer;
use super::{Mc600, Mode};

impl Mc600 {
    /// A line was typed at the prompt: a program line is stored, anything else is executed.
    pub(super) fn entered(&mut self, line: &[u8]) {
        let (number, body) = line_number(line);
        match number {
            Err(error) => self.report(error, None),
            Ok(Some(number)) => self.store_line(number, line.get(body..).unwrap_or_default()),
            Ok(None) if line.iter().all(|&byte| byte == b' ') => {}
            Ok(None) => self.run_direct(line),
        }
    }

    fn store_line(&mut self, number: u16, text: &[u8]) {
        if self.program.bytes() + text.len() > MEMORY {
            self.report(ErrorCode::OutOfMemory, None);
            return;
        }
        self.program.enter(number, text);
        self.program_changed();
    }

    /// Variables, loops and what CONT remembers do not outlive a change of the program, as in Microsoft BASIC (D24).
    pub(super) fn program_changed(&mut self) {
        self.compiled = false;
        self.resume = None;
        self.vm.image = super::code::Image::default();
        self.vm.symbols = super::symbols::Symbols::default();
        self.vm.program_bytes = self.program.bytes();
        self.vm.clear();
        self.machine.interrupts = Interrupts::new();
    }

    pub(super) fn new_program(&mut self) {
        self.program.clear();
        self.file = None;
        self.listing = None;
        self.program_changed();
    }

    /// Compiles the program if it has changed since.
    pub(super) fn prepare(&mut self) {
        if self.compiled {
            return;
        }
        self.vm.symbols = super::symbols::Symbols::default();
        self.vm.image = compile(&self.program, &mut self.vm.symbols, self.without);
        self.vm.program_bytes = self.program.bytes();
        self.vm.clear();
        self.compiled = true;
        self.debugger.bind(&self.vm.image);
    }

    fn run_direct(&mut self, line: &[u8]) {
        self.prepare();
        let frames = &mut self.vm.frames;
        // Loops of an earlier direct line are gone with it.
        let program_ops = self.vm.image.program_ops;
        frames.retain(|frame| frame.place() < program_ops);
        self.vm.pc = compile_direct(line, &mut self.vm.symbols, &mut self.vm.image, self.without);
        self.vm.take_in_symbols();
        self.debugger.bind(&self.vm.image);
        self.error = None;
        self.mode = Mode::Running;
    }

    /// What a running statement asks of the firmware.
    pub(super) fn system(&mut self, call: SystemCall, op: Op) {
        // The line of the statement, before the program changes under it.
        let line = self.vm.image.line_at(self.vm.pc.saturating_sub(1));
        let done = match call {
            SystemCall::New => {
                self.new_program();
                self.finish();
                Ok(())
            }
            SystemCall::List => {
                self.listing = Some(LineRange {
                    first: op.b,
                    last: op.c,
                });
                Ok(())
            }
            SystemCall::Run => self.start(None),
            SystemCall::RunLine => self.start(Some(op.b)),
            SystemCall::RunAt => self.start_at(op.b),
            SystemCall::RunFile => self.load_file(op.b).and_then(|()| self.start(None)),
            SystemCall::RunFileLine => self.load_file(op.b).and_then(|()| self.start(Some(op.c))),
            SystemCall::Cont => self.go_on(),
            SystemCall::Del => self.delete_lines(op.b, op.c),
            SystemCall::Renum => self.renumber(op.b, op.c),
            SystemCall::Auto => {
                self.finish();
                self.mode = Mode::Auto {
                    line: op.b,
                    increment: op.c,
                    prompted: false,
                };
                Ok(())
            }
            SystemCall::Files => self.directory(op.b),
            SystemCall::Save => self.save(op.b),
            SystemCall::Load => self.load_file(op.b).map(|()| self.finish()),
            SystemCall::Merge => self.merge_file(op.b),
            SystemCall::Copy => self.copy(op.b, op.c),
            SystemCall::Erase => self.erase(op.b),
            SystemCall::Format => self.format(op.b),
            SystemCall::Password => {
                self.ask_for_password();
                Ok(())
            }
        };
        if let Err(error) = done {
            self.report(error, line);
            self.finish();
        }
    }

    /// RUN: everything from the start.
    pub(super) fn start(&mut self, line: Option<u16>) -> Result<(), ErrorCode> {
        self.prepare();
        let pc = match line {
            Some(line) => self
                .vm
                .image
                .line_start(line)
                .ok_or(ErrorCode::UndefinedLineNumber)?,
            None => 0,
        };
        self.vm.clear();
        self.machine.interrupts = Interrupts::new();
        self.vm.pc = pc;
        (self.resume, self.error) = (None, None);
        self.mode = Mode::Running;
        Ok(())
    }

    /// RUN with a line number that is computed (D26), before the variables are cleared.
    fn start_at(&mut self, register: u16) -> Result<(), ErrorCode> {
        let line = to_integer(self.vm.register(register))?;
        let line = u16::try_from(line).map_err(|_| ErrorCode::UndefinedLineNumber)?;
        self.start(Some(line))
    }

    fn go_on(&mut self) -> Result<(), ErrorCode> {
        self.vm.pc = self.resume.take().ok_or(ErrorCode::CantContinue)?;
        Ok(())
    }

    /// DEL ends a running line or program, which it may have deleted.
    fn delete_lines(&mut self, first: u16, last: u16) -> Result<(), ErrorCode> {
        // Further ranges of the same statement follow as further operations: the program stays compiled until the end.
        self.program.delete(LineRange { first, last });
        let more = usize::try_from(self.vm.pc)
            .ok()
            .and_then(|pc| self.vm.image.ops.get(pc))
            .copied();
        if more.is_some_and(|op| {
            op.code == super::code::Code::System && op.a == SystemCall::Del as u16
        }) {
            return Ok(());
        }
        self.program_changed();
        self.finish();
        Ok(())
    }

    fn renumber(&mut self, start: u16, increment: u16) -> Result<(), ErrorCode> {
        self.charge_bytes(self.program.bytes());
        self.program.renumber(start, increment)?;
        self.program_changed();
        self.finish();
        Ok(())
    }

    /// Prints the next line of LIST.
    pub(super) fn list_next(&mut self) {
        let Some(range) = self.listing else { return };
        let next = self.program.lines_in(range).next();
        let number = next.map(|(number, _)| number);
        match number.and_then(|number| Some((number, self.program.list_line(number)?))) {
            Some((number, text)) => {
                self.vm.say(&text);
                self.vm.say(b"\r\n");
                self.listing = number
                    .checked_add(1)
                    .map(|first| LineRange { first, ..range });
                self.charge_a_line();
            }
            None => self.listing = None,
        }
    }

    /// AUTO: a number is offered, a line is stored, an empty one ends it (D52).
    pub(super) fn offer_line(&mut self, line: u16, increment: u16, prompted: bool) -> bool {
        if !prompted {
            self.on_new_line(&format!(">{line} "));
            self.mode = Mode::Auto {
                line,
                increment,
                prompted: true,
            };
            return true;
        }
        let Some(typed) = self.console.take_line() else {
            return false;
        };
        let number_length = line.to_string().len() + 1;
        self.mode = Mode::Ready { prompted: false };
        if typed.too_long || typed.text.len() + number_length > super::firmware::LINE_LENGTH {
            self.report(ErrorCode::StringTooLong, None);
        } else if !typed.text.iter().all(|&byte| byte == b' ') {
            // The blank that was offered behind the number is part of the line.
            self.store_line(line, &[b" ", &typed.text[..]].concat());
            if let Some(next) = line
                .checked_add(increment)
                .filter(|&next| next <= LAST_LINE && increment > 0)
            {
                self.mode = Mode::Auto {
                    line: next,
                    increment,
                    prompted: false,
                };
            }
        }
        self.charge_a_line();
        true
    }

    /// Puts another program into memory; what runs is over.
    pub(super) fn replace_program(&mut self, program: Program) {
        self.new_program();
        self.program.replace(program);
        self.program_changed();
    }
}

/// Whether a line is one to store, for those who only look at it.
pub(super) fn device_line(line: &[u8]) -> Option<u16> {
    parse_line(line).number.ok().flatten()
}
