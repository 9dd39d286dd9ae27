//! The program in memory: numbered lines of text.
//!
//! Source: "Basic programming rules", DEL, LIST, LOAD, RENUM, SAVE.

use std::collections::BTreeMap;
use std::rc::Rc;

use super::ast::LineRange;
use super::firmware::{ErrorCode, LAST_LINE, LINE_LENGTH, MEMORY};
use super::jumps::jumps;
use super::lexer::{TokenKind, is_blank, line_number, tokens};
use crate::language::{latin1, split_lines};

/// The longest line that a program holds, its number counted (D27). The console takes 80 characters, but RENUM
/// makes lines longer, and a program that was saved must load again.
pub const STORED_LENGTH: usize = 255;

/// What a line takes in memory besides its text: number, length and link (D27).
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

    /// Adds the lines of another program; of two with the same number the other's stays (MERGE).
    ///
    /// # Errors
    /// OUT OF MEMORY if both together do not fit; nothing has changed then.
    pub fn merge(&mut self, other: &Program) -> Result<(), ErrorCode> {
        let mut merged = self.clone();
        for (number, text) in other.lines() {
            merged.enter(number, text);
        }
        if merged.bytes() > MEMORY {
            return Err(ErrorCode::OutOfMemory);
        }
        merged.revision = self.revision + 1;
        *self = merged;
        Ok(())
    }

    /// Numbers the lines anew from `start` in steps of `increment`, and every jump with them: behind GOTO, GOSUB,
    /// THEN, ELSE and RUN, in the lists of ON, and the line of INTSETUP. Jumps to lines that do not exist stay.
    ///
    /// # Errors
    /// ILLEGAL QUANTITY if a line would get a number above 63999, a text that is too long, or all lines the same
    /// number; nothing has changed then.
    pub fn renumber(&mut self, start: u16, increment: u16) -> Result<(), ErrorCode> {
        let numbers = (start..=LAST_LINE).step_by(usize::from(increment.max(1)));
        let new: Vec<(u16, u16)> = self.lines.keys().copied().zip(numbers).collect();
        if new.len() < self.lines.len() || increment == 0 {
            return Err(ErrorCode::IllegalQuantity);
        }
        let mut renumbered = Program::default();
        for (old, text) in self.lines() {
            let number = renumbered_as(old, &new).unwrap_or(old);
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

/// A text with its jumps changed from old numbers to new ones.
fn with_new_jumps(text: &[u8], new: &[(u16, u16)]) -> Vec<u8> {
    let mut changed = Vec::with_capacity(text.len());
    let mut copied = 0;
    for jump in jumps(text) {
        let Some(number) = renumbered_as(jump.line.number, new) else {
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

/// The new number of a line, of the old and new ones in order.
fn renumbered_as(line: u16, new: &[(u16, u16)]) -> Option<u16> {
    let at = new.binary_search_by_key(&line, |&(old, _)| old).ok()?;
    new.get(at).map(|&(_, number)| number)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn program(text: &str) -> Program {
        Program::from_typed(text).unwrap()
    }

    fn text(program: &Program) -> String {
        latin1::text(&program.to_text()).replace("\r\n", "\n")
    }

    /// The memory that a program takes, counted anew.
    fn counted(program: &Program) -> usize {
        program.lines().map(|(_, text)| text.len() + 5).sum()
    }

    #[test]
    fn lists_keywords_in_upper_case_and_all_else_as_typed() {
        for (typed, listed) in [
            ("10 print \"print\"; x", "10 PRINT \"print\"; x"),
            ("20   for i=1to10: rem to do", "20   FOR i=1TO10: REM to do"),
            ("  030data to, \"go\":goto10", "30 DATA to, \"go\":GOTO10"),
            ("40\tx=sl_posdemand%+{pi}", "40\tx=SL_POSDEMAND%+{PI}"),
            ("50?a$", "50 ?a$"),
            ("60 go  to 10", "60 GO  TO 10"),
            ("70 scoring=1", "70 scoring=1"),
            ("80 5 print", "80 5 PRINT"),
        ] {
            assert_eq!(text(&program(typed)), format!("{listed}\n"));
        }
    }

    #[test]
    fn keeps_lines_in_order_replaces_and_deletes() {
        let mut program = program("20 STOP\r10 PRINT\n\n20 END\r\n30 NEW\n40 RUN\n50 CONT");
        assert_eq!(
            text(&program),
            "10 PRINT\n20 END\n30 NEW\n40 RUN\n50 CONT\n"
        );
        assert_eq!(program.bytes(), counted(&program));
        let revision = program.revision();
        program.delete(LineRange {
            first: 35,
            last: 38,
        });
        program.delete(LineRange {
            first: 50,
            last: 30,
        });
        assert_eq!(program.revision(), revision, "nothing was there");
        program.delete(LineRange {
            first: 30,
            last: 45,
        });
        program.enter(10, b"  ");
        assert_eq!(text(&program), "20 END\n50 CONT\n");
        assert_eq!(program.bytes(), counted(&program));
        assert!(program.revision() > revision);
        assert_eq!(program.list_line(30), None);
        program.clear();
        assert!(program.is_empty() && program.bytes() == 0);
    }

    #[test]
    fn a_clone_keeps_what_it_had() {
        let mut program = program("10 END");
        let before = program.clone();
        program.enter(20, b" STOP");
        assert_eq!(text(&before), "10 END\n");
        assert_eq!(text(&program), "10 END\n20 STOP\n");
    }

    #[test]
    fn renumbering_takes_every_jump_along() {
        let mut program = program(
            "1 GOTO 5: GO TO7: GOSUB 9\n\
             5 IF A THEN 7 ELSE 9\n\
             7 ON X GOTO 1,5 , 8,9: RUN 7: RUN \"A\",7\n\
             8 PRINT 7: X=7: REM GOTO 7\n\
             9 INTSETUP(7,9,1): DATA 7: IF A GOTO 7 ELSE PRINT 7\n\
             11 GOTO 6: X = = 1: GOTO 11",
        );
        assert_eq!(program.renumber(100, 10), Ok(()));
        assert_eq!(
            text(&program),
            "100 GOTO 110: GO TO120: GOSUB 140\n\
             110 IF A THEN 120 ELSE 140\n\
             120 ON X GOTO 100,110 , 130,140: RUN 120: RUN \"A\",120\n\
             130 PRINT 7: X=7: REM GOTO 7\n\
             140 INTSETUP(120,9,1): DATA 7: IF A GOTO 120 ELSE PRINT 7\n\
             150 GOTO 6: X = = 1: GOTO 150\n"
        );
        assert_eq!(program.bytes(), counted(&program));
    }

    #[test]
    fn a_jump_to_line_0_that_is_left_out_is_written_when_line_0_moves() {
        let mut program = program("0 GOTO: PRINT\n5 ON X GOTO ,5\n6 IF A GOTO ELSE STOP");
        assert_eq!(program.renumber(10, 10), Ok(()));
        let expected = "10 GOTO10: PRINT\n20 ON X GOTO10 ,20\n30 IF A GOTO10 ELSE STOP\n";
        assert_eq!(text(&program), expected);
    }

    #[test]
    fn renumbering_beyond_the_last_line_changes_nothing() {
        let mut program = program("10 GOTO 20\n20 END");
        for (start, increment) in [(63_999, 1), (10, 63_999), (10, 0), (0, 65_535)] {
            let before = text(&program);
            let result = program.renumber(start, increment);
            assert_eq!(
                result,
                Err(ErrorCode::IllegalQuantity),
                "{start},{increment}"
            );
            assert_eq!(text(&program), before);
        }
        assert_eq!(program.renumber(63_989, 10), Ok(()));
        assert_eq!(text(&program), "63989 GOTO 63999\n63999 END\n");
    }

    #[test]
    fn the_longest_typed_line_survives_renumbering_saving_and_loading() {
        let jumps = ",1".repeat(33);
        let mut program = program(&format!("1 ON X GOTO 1{jumps}"));
        assert_eq!(program.renumber(60_000, 1), Ok(()));
        let saved = program.to_text();
        assert!(saved.len() > 200);
        let loaded = Program::from_text(&saved, STORED_LENGTH).unwrap();
        assert_eq!(loaded.to_text(), saved);
    }

    #[test]
    fn text_that_is_no_program_is_refused_with_its_line() {
        let long = format!("10 END\n20 {}", "X".repeat(78));
        let huge = format!("10 REM {}\n", "X".repeat(70)).repeat(3);
        for (text, line, error) in [
            ("10 END\nPRINT", 1, ErrorCode::Syntax),
            ("10 END\r\n\r\n64000 END", 2, ErrorCode::Syntax),
            (&long, 1, ErrorCode::StringTooLong),
            ("10 PRINT \u{201c}A\u{201d}", 0, ErrorCode::Syntax),
        ] {
            let fault = Program::from_typed(text).unwrap_err();
            assert_eq!((fault.line, fault.error), (line, error), "{text}");
        }
        assert!(Program::from_typed(&huge).is_ok());
        let lines = (0..15_000).map(|line| format!("{line} REM {}\n", "X".repeat(70)));
        let fault = Program::from_typed(&lines.collect::<String>()).unwrap_err();
        assert_eq!(fault.error, ErrorCode::OutOfMemory);
    }

    #[test]
    fn merged_programs_fit_or_stay_apart() {
        let mut first = program("10 PRINT 1\n20 PRINT 2");
        first.merge(&program("20 GOTO 10\n30 END")).unwrap();
        assert_eq!(text(&first), "10 PRINT 1\n20 GOTO 10\n30 END\n");
        assert_eq!(first.bytes(), counted(&first));
        let large = |start: usize| {
            let lines = (0..8_000).map(|line| format!("{} REM {}\n", start + line, "X".repeat(60)));
            program(&lines.collect::<String>())
        };
        let (mut low, high) = (large(0), large(8_000));
        let before = (low.bytes(), low.revision());
        assert_eq!(low.merge(&high), Err(ErrorCode::OutOfMemory));
        assert_eq!((low.bytes(), low.revision()), before);
        // The same lines again take no more room.
        assert_eq!(low.merge(&large(0)), Ok(()));
        assert_eq!((low.bytes(), low.revision()), (before.0, before.1 + 1));
    }

    #[test]
    fn every_byte_survives_a_file() {
        let bytes: Vec<u8> = (0x20..=0xff).filter(|&byte| byte != 0x7f).collect();
        let line = [b"10 REM ".as_slice(), &bytes].concat();
        let program = Program::from_text(&line, STORED_LENGTH).unwrap();
        assert_eq!(program.list_line(10), Some(line));
    }
}
