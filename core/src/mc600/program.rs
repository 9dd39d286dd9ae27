//! The program in memory: numbered lines of text.
//!
//! Source: "Basic programming rules", DEL, LIST, LOAD, RENUM, SAVE.

use std::collections::BTreeMap;
use std::rc::Rc;

use super::ast::LineRange;
use super::firmware::{ErrorCode, LAST_LINE, LINE_LENGTH, MEMORY};
use super::jumps::jumps;
use super::lexer::{TokenKind, is_blank, line_number, tokens};
use crate::language::latin1;

/// The longest line that a program holds, its number counted (assumed). The console takes 80 characters, but RENUM
/// makes lines longer, and a program that was saved must load again.
pub const STORED_LENGTH: usize = 255;

/// What a line takes in memory besides its text: number, length and link (assumed).
const LINE_OVERHEAD: usize = 5;

/// The lines of a program. A clone shares them until one is changed.
#[derive(Debug, Clone, Default)]
pub struct Program {
    lines: Rc<BTreeMap<u16, Rc<[u8]>>>,
    bytes: usize,
    revision: u64,
}

/// Why a text is no program.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct TextFault {
    /// Line of the text, from 0.
    pub line: u32,
    /// What the device says.
    pub error: ErrorCode,
    /// Why, in a plain sentence.
    pub cause: String,
}

impl Program {
    /// Grows with every change.
    pub fn revision(&self) -> u64 {
        self.revision
    }

    /// Memory that the program takes: its text and 5 bytes a line.
    pub fn bytes(&self) -> usize {
        self.bytes
    }

    /// Whether there are no lines.
    pub fn is_empty(&self) -> bool {
        self.lines.is_empty()
    }

    /// Every line in order: its number, and its text from behind the number, blanks included.
    pub fn lines(&self) -> impl Iterator<Item = (u16, &[u8])> {
        self.lines.iter().map(|(&number, text)| (number, &**text))
    }

    /// The lines of a range, as [`Program::lines`].
    pub fn lines_in(&self, range: LineRange) -> impl Iterator<Item = (u16, &[u8])> {
        // A range may be written backwards, and then holds nothing.
        let last = range.last.max(range.first);
        let lines = self.lines.range(range.first..=last);
        let backwards = range.last < range.first;
        lines
            .filter(move |_| !backwards)
            .map(|(&number, text)| (number, &**text))
    }

    /// The text of a line, from behind its number.
    pub fn text(&self, number: u16) -> Option<&[u8]> {
        self.lines.get(&number).map(|text| &**text)
    }

    /// A line as LIST prints it.
    pub fn list_line(&self, number: u16) -> Option<Vec<u8>> {
        self.text(number).map(|text| listed(number, text))
    }

    /// Stores a line, replacing one of the same number; a blank text deletes it. Keywords become upper case, all else
    /// stays as typed.
    pub fn enter(&mut self, number: u16, text: &[u8]) {
        if text.iter().all(|&byte| is_blank(byte)) {
            return self.delete(LineRange {
                first: number,
                last: number,
            });
        }
        let stored = upper_case_keywords(text);
        let added = stored.len() + LINE_OVERHEAD;
        let replaced = Rc::make_mut(&mut self.lines).insert(number, stored.into());
        self.bytes = self.bytes + added - replaced.map_or(0, |old| old.len() + LINE_OVERHEAD);
        self.revision += 1;
    }

    /// Deletes the lines of a range.
    pub fn delete(&mut self, range: LineRange) {
        let doomed: Vec<u16> = self.lines_in(range).map(|(number, _)| number).collect();
        if doomed.is_empty() {
            return;
        }
        let lines = Rc::make_mut(&mut self.lines);
        for number in doomed {
            let removed = lines.remove(&number);
            self.bytes -= removed.map_or(0, |old| old.len() + LINE_OVERHEAD);
        }
        self.revision += 1;
    }

    /// Deletes all lines (NEW).
    pub fn clear(&mut self) {
        *self = Program {
            revision: self.revision + 1,
            ..Program::default()
        };
    }

    /// Puts the lines of another program in place of these.
    pub fn replace(&mut self, program: Program) {
        *self = Program {
            revision: self.revision + 1,
            ..program
        };
    }

    /// Numbers the lines anew from `start` in steps of `increment`, and every jump with them: behind GOTO, GOSUB,
    /// THEN, ELSE and RUN, in the lists of ON, and the line of INTSETUP. Jumps to lines that do not exist stay.
    ///
    /// # Errors
    /// ILLEGAL QUANTITY if a line would get a number above 63999, a text that is too long, or all lines the same
    /// number; nothing has changed then.
    pub fn renumber(&mut self, start: u16, increment: u16) -> Result<(), ErrorCode> {
        let numbers = (start..=LAST_LINE).step_by(usize::from(increment.max(1)));
        let new: BTreeMap<u16, u16> = self.lines.keys().copied().zip(numbers).collect();
        if new.len() < self.lines.len() || increment == 0 {
            return Err(ErrorCode::IllegalQuantity);
        }
        let mut renumbered = Program::default();
        for (old, text) in self.lines() {
            let number = new.get(&old).copied().unwrap_or(old);
            let text = with_new_jumps(text, &new);
            if listed(number, &text).len() > STORED_LENGTH {
                return Err(ErrorCode::IllegalQuantity);
            }
            renumbered.enter(number, &text);
        }
        renumbered.revision = self.revision + 1;
        *self = renumbered;
        Ok(())
    }

    /// Reads a program from text as a person would type it: 80 characters a line.
    ///
    /// # Errors
    /// As [`Program::from_text`], and for a character that the device does not have.
    pub fn from_typed(text: &str) -> Result<Program, TextFault> {
        for (index, line) in split_lines(text.as_bytes()).enumerate() {
            let line = std::str::from_utf8(line).unwrap_or_default();
            if let Some(stranger) = line.chars().find(|&c| latin1::byte(c).is_none()) {
                return Err(TextFault {
                    line: u32::try_from(index).unwrap_or(u32::MAX),
                    error: ErrorCode::Syntax,
                    cause: format!("The device has no character {stranger}."),
                });
            }
        }
        Program::from_text(&latin1::bytes(text), LINE_LENGTH)
    }

    /// Reads a program from the bytes of a file. Lines end with CR, LF or both; blank ones are skipped,
    /// and of two with the same number the later counts, as if they had been typed. `longest` is the most characters
    /// that a line may have: 80 as typed, [`STORED_LENGTH`] from the device's own disks.
    ///
    /// # Errors
    /// The first line that the device would refuse: without a number, with one above 63999, too long, or beyond its
    /// memory.
    pub fn from_text(text: &[u8], longest: usize) -> Result<Program, TextFault> {
        let mut program = Program::default();
        for (index, line) in split_lines(text).enumerate() {
            let fault = |error, cause: String| TextFault {
                line: u32::try_from(index).unwrap_or(u32::MAX),
                error,
                cause,
            };
            if line.iter().all(|&byte| is_blank(byte)) {
                continue;
            }
            if line.len() > longest {
                let cause = format!("The line has more than {longest} characters.");
                return Err(fault(ErrorCode::StringTooLong, cause));
            }
            let (number, body) = line_number(line);
            let number = number
                .map_err(|error| fault(error, "A line number is at most 63999.".into()))?
                .ok_or_else(|| {
                    let cause = "A program line begins with its number.".into();
                    fault(ErrorCode::Syntax, cause)
                })?;
            program.enter(number, line.get(body..).unwrap_or_default());
            if program.bytes() > MEMORY {
                let cause = "The program is larger than the memory.".into();
                return Err(fault(ErrorCode::OutOfMemory, cause));
            }
        }
        Ok(program)
    }

    /// The program as a file's bytes: each line as LIST prints it, then CR LF.
    pub fn to_text(&self) -> Vec<u8> {
        let mut text = Vec::new();
        for (number, line) in self.lines() {
            text.extend(listed(number, line));
            text.extend(b"\r\n");
        }
        text
    }
}

fn listed(number: u16, text: &[u8]) -> Vec<u8> {
    let mut line = number.to_string().into_bytes();
    if !text.first().copied().is_some_and(is_blank) {
        line.push(b' ');
    }
    line.extend_from_slice(text);
    line
}

fn upper_case_keywords(text: &[u8]) -> Vec<u8> {
    let mut upper = text.to_vec();
    for token in tokens(text, 0) {
        if let TokenKind::Keyword(_) = token.kind
            && let Some(word) = upper.get_mut(token.span.range())
        {
            word.make_ascii_uppercase();
        }
    }
    upper
}

/// The lines of a text; they end with CR, LF, or CR LF.
pub fn split_lines(text: &[u8]) -> impl Iterator<Item = &[u8]> {
    // CR LF counts once: the LF ends nothing when the CR has.
    let mut rest = Some(text);
    std::iter::from_fn(move || {
        let text = rest?;
        let end = text.iter().position(|&byte| matches!(byte, b'\r' | b'\n'));
        let Some(end) = end else {
            rest = None;
            return Some(text);
        };
        let behind = text.get(end..).unwrap_or_default();
        let next = match behind {
            [b'\r', b'\n', next @ ..] | [_, next @ ..] => next,
            [] => &[],
        };
        rest = Some(next);
        text.get(..end)
    })
}

/// A text with its jumps changed from old numbers to new ones.
fn with_new_jumps(text: &[u8], new: &BTreeMap<u16, u16>) -> Vec<u8> {
    let mut changed = Vec::with_capacity(text.len());
    let mut copied = 0;
    for jump in jumps(text) {
        let Some(number) = new.get(&jump.line.number) else {
            continue;
        };
        let range = jump.line.span.range();
        changed.extend_from_slice(text.get(copied..range.start).unwrap_or_default());
        changed.extend_from_slice(number.to_string().as_bytes());
        copied = range.end;
    }
    changed.extend_from_slice(text.get(copied..).unwrap_or_default());
    changed
}
