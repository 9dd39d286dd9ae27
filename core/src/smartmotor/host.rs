//! What the host sends: commands, addresses, binary set commands, programs.

use super::ast::{LineCommand, Malformed, Statement, StatementKind};
use super::firmware::{COMMAND_BYTES, LAST_ADDRESS, PROGRAM_BYTES};
use super::line::{ALL_MOTORS, Line};
use super::motor::{Motor, Register};
use super::parser::parse_line;

/// Ends a program that is sent.
const PROGRAM_END: u8 = 0xFF;
/// Answers every eight bytes of a program.
const ACKNOWLEDGE: u8 = 0x06;
/// The highest address byte.
const LAST_SELECT: u8 = ALL_MOTORS + LAST_ADDRESS;

/// Something to do for the host.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Request {
    /// A command, which may hold several.
    Command(Vec<Statement>),
    /// A program to be stored; `None` if it was too long.
    Program(Option<Vec<u8>>),
}

/// The command interpreter's side of the host's line.
#[derive(Debug, Clone, Default)]
pub struct Host {
    /// The command that is coming in.
    pending: Vec<u8>,
    /// A binary set command, and its bytes so far.
    binary: Option<(u8, Vec<u8>)>,
    /// The program that is coming in, and the bytes of it.
    loading: Option<(Vec<u8>, usize)>,
}

impl Host {
    /// Whether part of a command, a set command or a program has come in.
    pub fn is_typing(&self) -> bool {
        !self.pending.is_empty() || self.binary.is_some() || self.loading.is_some()
    }

    /// LOAD: what comes now is a program, up to the byte 255.
    pub fn load(&mut self) {
        self.loading = Some((Vec::new(), 0));
    }

    /// Reads bytes until there is something to do.
    pub fn next(
        &mut self,
        line: &mut Line,
        motor: &mut Motor,
        without: Option<&str>,
    ) -> Option<Request> {
        while let Some(byte) = line.take_byte() {
            let request = if self.loading.is_some() {
                self.program_byte(byte, line)
            } else if self.binary.is_some() {
                self.binary_byte(byte, line, motor);
                None
            } else {
                self.byte(byte, line, without)
            };
            if request.is_some() {
                return request;
            }
        }
        None
    }

    fn byte(&mut self, byte: u8, line: &mut Line, without: Option<&str>) -> Option<Request> {
        match byte {
            ALL_MOTORS..=LAST_SELECT => {
                self.pending.clear();
                line.select(byte);
            }
            0xFA..=0xFE => self.binary = Some((byte, Vec::new())),
            229..=249 | 255 => {}
            _ if !line.is_selected() => {}
            b'\r' | b'\n' | b' ' => return self.command(byte, line.is_asleep(), without),
            0..b' ' => {}
            // What is too long cannot be right: it is cut off, and sets Bs.
            byte if self.pending.len() <= COMMAND_BYTES => self.pending.push(byte),
            _ => {}
        }
        None
    }

    /// A CR, LF or blank: the command is complete, or goes on behind the blank.
    fn command(&mut self, end: u8, asleep: bool, without: Option<&str>) -> Option<Request> {
        if self.pending.is_empty() {
            return None;
        }
        let parsed = parse_line(&self.pending, without);
        let last = parsed.statements.last().map(|last| &last.kind);
        let unfinished = matches!(
            last,
            Some(StatementKind::Malformed(Malformed {
                unfinished: true,
                ..
            }))
        );
        if end == b' ' && (unfinished || parsed.comment) && self.pending.len() <= COMMAND_BYTES {
            self.pending.push(end);
            return None;
        }
        self.pending.clear();
        let mut statements = parsed.statements;
        if asleep {
            let wake = StatementKind::Line(LineCommand::Wake);
            statements.retain(|statement| statement.kind == wake);
        }
        (!statements.is_empty()).then_some(Request::Command(statements))
    }

    /// Four bytes follow, the highest first.
    fn binary_byte(&mut self, byte: u8, line: &Line, motor: &mut Motor) {
        let Some((kind, bytes)) = &mut self.binary else {
            return;
        };
        bytes.push(byte);
        let Ok(whole) = <[u8; 4]>::try_from(bytes.as_slice()) else {
            return;
        };
        let (kind, value) = (*kind, i32::from_be_bytes(whole));
        self.binary = None;
        if !line.is_selected() || line.is_asleep() {
            return;
        }
        match kind {
            0xFA => motor.stream_position(value),
            0xFB => motor.stream_time(value),
            0xFC => motor.set(Register::Acceleration, value),
            0xFD => motor.set(Register::Velocity, value),
            _ => motor.set(Register::Position, value),
        }
    }

    fn program_byte(&mut self, byte: u8, line: &mut Line) -> Option<Request> {
        let (program, count) = self.loading.as_mut()?;
        if byte == PROGRAM_END {
            let fits = *count == program.len();
            let program = std::mem::take(program);
            self.loading = None;
            return Some(Request::Program(fits.then_some(program)));
        }
        *count += 1;
        if program.len() < PROGRAM_BYTES {
            program.push(byte);
        }
        if count.is_multiple_of(8) {
            line.send(&[ACKNOWLEDGE]);
        }
        None
    }
}
