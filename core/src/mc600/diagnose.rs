//! What is wrong with a program, told from its text alone, and the colours of its lines.

#[cfg(test)]
mod tests;

use std::collections::BTreeMap;

use super::ast::{Statement, StatementKind};
use super::commands::device_line;
use super::compile::{Problem, check};
use super::firmware::{ErrorCode, LAST_LINE, LINE_LENGTH};
use super::jumps::{Jump, jumps};
use super::keywords::{Keyword, rows};
use super::lexer::{TokenKind, is_blank, line_number, tokens};
use super::parser::{ParsedLine, parse_line};
use super::program::Program;
use crate::language::Support::{Absent, Full, Partial};
use crate::language::{
    Cure, Diagnostic, Highlight, HighlightClass, Severity, Span, latin1, split_lines,
};

/// Everything that can be said about a program's text, in the order of its lines.
pub fn diagnose(text: &str) -> Vec<Diagnostic> {
    let mut findings = Findings::default();
    for (index, line) in split_lines(text.as_bytes()).enumerate() {
        let index = u32::try_from(index).unwrap_or(u32::MAX);
        // A line end is never part of another character.
        findings.line(index, std::str::from_utf8(line).unwrap_or_default());
    }
    findings.jumps();
    findings.compiled();
    Diagnostic::sort(&mut findings.found);
    findings.found
}

#[derive(Default)]
struct Findings {
    found: Vec<Diagnostic>,
    program: Program,
    /// Where each program line stands in the text; lines with characters that the device does not have are left out.
    places: BTreeMap<u16, Place>,
    last: Option<u16>,
}

#[derive(Clone, Copy)]
struct Place {
    /// Line of the text.
    line: u32,
    /// Where the text behind the number begins.
    body: usize,
}

impl Findings {
    fn error(
        &mut self,
        line: u32,
        span: Span,
        error: ErrorCode,
        cause: String,
        cure: Option<Cure>,
    ) {
        self.found.push(Diagnostic {
            line,
            span,
            severity: Severity::Error,
            message: message(error),
            cause,
            cure,
        });
    }

    fn warning(&mut self, line: u32, span: Span, message: String, cause: String) {
        self.found.push(Diagnostic {
            line,
            span,
            severity: Severity::Warning,
            message,
            cause,
            cure: None,
        });
    }

    fn line(&mut self, index: u32, line: &str) {
        let bytes = latin1::bytes(line);
        if bytes.iter().all(|&byte| is_blank(byte)) {
            return;
        }
        if bytes.len() > LINE_LENGTH {
            let span = Span::new(LINE_LENGTH, bytes.len());
            let cause = format!(
                "The line has {} characters; the console takes {LINE_LENGTH}. Continue on a line of its own.",
                bytes.len()
            );
            self.error(index, span, ErrorCode::StringTooLong, cause, None);
        }
        let parsed = parse_line(&bytes);
        let number = self.number(index, &bytes, &parsed);
        let strange = self.strangers(index, line);
        if let Some(number) = number {
            let body = parsed.body;
            let place = Place { line: index, body };
            match strange {
                // It has replaced a line of the same number.
                true => self.places.remove(&number),
                false => self.places.insert(number, place),
            };
        }
        if !strange {
            self.statements(index, &parsed.statements);
        }
    }

    /// Judges the number in front and takes the line into the program.
    fn number(&mut self, index: u32, line: &[u8], parsed: &ParsedLine) -> Option<u16> {
        let number = match parsed.number {
            Ok(Some(number)) => number,
            Ok(None) => {
                let start = Span::new(parsed.body, parsed.body);
                let next = self
                    .last
                    .map_or(10, |last| last.saturating_add(10))
                    .min(LAST_LINE);
                let cure = Cure {
                    label: format!("Number it {next}"),
                    span: start,
                    replacement: format!("{next} "),
                };
                let cause = "A program line begins with its number.".into();
                let first = parsed.statements.first().map_or(start, |first| first.span);
                self.error(index, first, ErrorCode::Syntax, cause, Some(cure));
                return None;
            }
            Err(error) => {
                let cause = format!("A line number is at most {LAST_LINE}.");
                self.error(index, Span::new(0, parsed.body), error, cause, None);
                return None;
            }
        };
        let span = Span::new(0, parsed.body);
        let body = line.get(parsed.body..).unwrap_or_default();
        if body.iter().all(|&byte| is_blank(byte)) {
            let cause = format!("A number alone deletes line {number}.");
            self.warning(index, span, format!("LINE {number} IS EMPTY"), cause);
        } else if self.program.text(number).is_some() {
            let cause =
                format!("Line {number} stands here a second time: this one replaces the first.");
            self.warning(index, span, format!("LINE {number} TWICE"), cause);
        } else if let Some(last) = self.last.filter(|&last| last > number) {
            let cause =
                format!("The device sorts its lines: line {number} will stand before line {last}.");
            self.warning(index, span, format!("LINE {number} OUT OF ORDER"), cause);
        }
        self.last = Some(number);
        self.program.enter(number, body);
        Some(number)
    }

    /// Characters that the device does not have; whether there are any.
    fn strangers(&mut self, index: u32, line: &str) -> bool {
        let before = self.found.len();
        for (position, character) in line.chars().enumerate() {
            if latin1::byte(character).is_some() {
                continue;
            }
            let span = Span::new(position, position + 1);
            let replacement = match character {
                '\u{201c}'..='\u{201f}' | '\u{2033}' => "\"",
                '\u{2018}'..='\u{201b}' | '\u{2032}' => "'",
                '\u{2010}'..='\u{2015}' | '\u{2212}' => "-",
                '\u{2264}' => "<=",
                '\u{2265}' => ">=",
                '\u{2260}' => "<>",
                '\u{3c0}' => "{pi}",
                _ => "?",
            };
            let cure = Cure {
                label: format!("Write {replacement}"),
                span,
                replacement: replacement.into(),
            };
            let cause = format!("The device has no character {character}.");
            self.error(index, span, ErrorCode::Syntax, cause, Some(cure));
        }
        self.found.len() > before
    }

    fn statements(&mut self, index: u32, statements: &[Statement]) {
        for statement in statements {
            match &statement.kind {
                StatementKind::Malformed(bad) => {
                    self.error(
                        index,
                        bad.span,
                        bad.error,
                        bad.cause.clone(),
                        bad.cure.clone(),
                    );
                }
                StatementKind::NotImplemented(keyword) => {
                    let cause = not_implemented(*keyword);
                    self.error(
                        index,
                        statement.span,
                        ErrorCode::NotImplemented,
                        cause,
                        None,
                    );
                }
                StatementKind::If {
                    then, otherwise, ..
                } => {
                    self.statements(index, then);
                    self.statements(index, otherwise.as_deref().unwrap_or_default());
                }
                _ => {}
            }
        }
    }

    /// What only the compiler sees, such as a string where a number is wanted.
    fn compiled(&mut self) {
        Diagnostic::sort(&mut self.found);
        for problem in self.new_problems() {
            if let Some(place) = self.places.get(&problem.line) {
                let (line, span) = (place.line, place.span(problem.span));
                self.error(line, span, problem.error, sentence(&problem.cause), None);
            }
        }
    }

    /// The compiler passes on what the parser has found; that stands here already, with its exact place.
    fn new_problems(&self) -> Vec<Problem> {
        let is_new = |problem: &Problem| {
            let Some(&place) = self.places.get(&problem.line) else {
                return false;
            };
            let span = place.span(problem.span);
            let first = self.found.partition_point(|found| found.line < place.line);
            let known = self.found.iter().skip(first);
            !known
                .take_while(|found| found.line == place.line)
                .any(|found| {
                    let touches = found.span.start <= span.end && span.start <= found.span.end;
                    touches && found.message == message(problem.error)
                })
        };
        let mut problems = check(&self.program);
        problems.retain(|problem| problem.error != ErrorCode::UndefdStatement && is_new(problem));
        problems
    }

    /// Jumps to lines that do not exist.
    fn jumps(&mut self) {
        let numbers: Vec<u16> = self.program.lines().map(|(number, _)| number).collect();
        for (&number, &place) in &self.places.clone() {
            let found = self.program.text(number).map(jumps).unwrap_or_default();
            for Jump { line: to, error } in found {
                if numbers.binary_search(&to.number).is_ok() {
                    continue;
                }
                let span = place.span(to.span);
                let behind = numbers.partition_point(|&known| known < to.number);
                let nearest = [behind.checked_sub(1), Some(behind)]
                    .into_iter()
                    .filter_map(|index| numbers.get(index?))
                    .min_by_key(|known| known.abs_diff(to.number));
                let cure = nearest.map(|nearest| Cure {
                    label: format!("Go to line {nearest}"),
                    span,
                    replacement: nearest.to_string(),
                });
                let cause = format!("There is no line {}.", to.number);
                self.error(place.line, span, error, cause, cure);
            }
        }
    }
}

impl Place {
    /// A span of the program line's text as one of the text's line.
    fn span(self, span: Span) -> Span {
        let range = span.range();
        Span::new(self.body + range.start, self.body + range.end)
    }
}

fn message(error: ErrorCode) -> String {
    format!("?{} ERROR", error.text())
}

/// With a capital and a full stop.
fn sentence(words: &str) -> String {
    let mut characters = words.chars();
    let first = characters.next().map(|first| first.to_ascii_uppercase());
    let stop = if words.ends_with('.') { "" } else { "." };
    format!("{}{}{stop}", first.unwrap_or_default(), characters.as_str())
}

fn not_implemented(keyword: Keyword) -> String {
    let row = keyword.row();
    match row.support {
        Absent(why) | Partial(why) => format!("{}: {why}", row.word),
        // PRINT# and INPUT#: the word works, but not with files.
        Full => format!(
            "{} does not work with files: the device itself does not implement them.",
            row.word
        ),
    }
}

/// The number of each line of a text that has one.
pub fn device_lines(text: &str) -> Vec<Option<u32>> {
    let number = |line: &str| device_line(&latin1::bytes(line)).map(u32::from);
    text.split('\n').map(number).collect()
}

/// The words of the keyword table that a line uses.
pub fn words(line: &str) -> Vec<&'static str> {
    let bytes = latin1::bytes(line);
    let (_, body) = line_number(&bytes);
    tokens(&bytes, body)
        .into_iter()
        .filter_map(|token| match token.kind {
            // A variable may have two spellings in the table.
            TokenKind::Keyword(keyword) => {
                let spelled = token.span.of(&bytes);
                let row = rows()
                    .into_iter()
                    .find(|row| row.word.as_bytes().eq_ignore_ascii_case(spelled));
                Some(row.map_or(keyword.word(), |row| row.word))
            }
            _ => None,
        })
        .collect()
}

/// The parts of one line of a program, by the device's own lexer.
pub fn highlight(line: &str) -> Vec<Highlight> {
    let bytes = latin1::bytes(line);
    let (number, body) = line_number(&bytes);
    let digits = Span::new(
        bytes.iter().take_while(|&&byte| is_blank(byte)).count(),
        body,
    );
    let class = match number {
        Ok(_) => HighlightClass::LineNumber,
        Err(_) => HighlightClass::Error,
    };
    let front = (!digits.is_empty()).then_some(Highlight {
        span: digits,
        class,
    });
    let parts = tokens(&bytes, body).into_iter().map(|token| Highlight {
        span: token.span,
        class: class_of(token.kind),
    });
    front.into_iter().chain(parts).collect()
}

fn class_of(kind: TokenKind) -> HighlightClass {
    match kind {
        TokenKind::Keyword(Keyword::System(_)) => HighlightClass::SystemVariable,
        TokenKind::Keyword(Keyword::Rem) | TokenKind::Remark => HighlightClass::Comment,
        TokenKind::Keyword(keyword) => match keyword.row().kind {
            "operator" => HighlightClass::Operator,
            "constant" => HighlightClass::Number,
            "function" | "motion" | "drive" | "io" => HighlightClass::Function,
            _ => HighlightClass::Keyword,
        },
        TokenKind::Integer(_) | TokenKind::Real(_) => HighlightClass::Number,
        TokenKind::Text | TokenKind::Data => HighlightClass::Text,
        TokenKind::Name(_) => HighlightClass::Variable,
        TokenKind::ParenOpen
        | TokenKind::ParenClose
        | TokenKind::Comma
        | TokenKind::Semicolon
        | TokenKind::Colon
        | TokenKind::Hash => HighlightClass::Operator,
        TokenKind::Bad(_) => HighlightClass::Error,
    }
}
