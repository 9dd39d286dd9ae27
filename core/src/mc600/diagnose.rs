//! What is wrong with a program, told from its text alone, and the colours of its lines.

use std::collections::BTreeMap;

use super::ast::{Statement, StatementKind};
use super::compile::check;
use super::firmware::{ErrorCode, LAST_LINE, LINE_LENGTH};
use super::jumps::{Jump, jumps};
use super::keywords::Keyword;
use super::lexer::{TokenKind, is_blank, line_number, tokens};
use super::parser::{ParsedLine, parse_line};
use super::program::{Program, split_lines};
use crate::language::Support::{Absent, Full, Partial};
use crate::language::{Cure, Diagnostic, Highlight, HighlightClass, Severity, Span, latin1};

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
    findings.found.sort_by_key(|found| (found.line, found.span));
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
        if self.strangers(index, line) {
            return;
        }
        self.statements(index, &parsed.statements);
        if let Some(number) = number {
            let body = parsed.body;
            self.places.insert(number, Place { line: index, body });
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
        for problem in check(&self.program) {
            let Some(&place) = self.places.get(&problem.line) else {
                continue;
            };
            let span = place.span(problem.span);
            let message = message(problem.error);
            // The compiler passes on what the parser has found, and that stands here with its exact place.
            let known = self.found.iter().any(|found| {
                let touches = found.span.start <= span.end && span.start <= found.span.end;
                found.line == place.line && found.message == message && touches
            });
            if !known && problem.error != ErrorCode::UndefdStatement {
                self.error(
                    place.line,
                    span,
                    problem.error,
                    sentence(&problem.cause),
                    None,
                );
            }
        }
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
                let nearest = numbers.iter().min_by_key(|known| known.abs_diff(to.number));
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

#[cfg(test)]
mod tests {
    use super::*;

    /// Line, message, cause and what the cure puts where the marked text is.
    fn found(text: &str) -> Vec<(u32, String, String, Option<String>)> {
        let lines: Vec<&str> = text.split('\n').collect();
        let found = diagnose(text).into_iter().map(|found| {
            let line = lines[found.line as usize];
            let cured = found.cure.map(|cure| {
                let (start, end) = (cure.span.start as usize, cure.span.end as usize);
                let before: String = line.chars().take(start).collect();
                let behind: String = line.chars().skip(end).collect();
                format!("{before}{}{behind}", cure.replacement)
            });
            (found.line, found.message, found.cause, cured)
        });
        found.collect()
    }

    fn check(text: &str, expected: &[(u32, &str, &str, Option<&str>)]) {
        let found = found(text);
        let found: Vec<(u32, &str, &str, Option<&str>)> = found
            .iter()
            .map(|(line, message, cause, cured)| {
                (*line, message.as_str(), cause.as_str(), cured.as_deref())
            })
            .collect();
        assert_eq!(found, expected, "{text}");
    }

    #[test]
    fn a_good_program_is_left_alone() {
        check(
            "10 FOR I=1 TO 3\n20 PRINT I\n\n30 NEXT\n40 IF I>3 THEN 10 ELSE END\n",
            &[],
        );
        check("", &[]);
    }

    #[test]
    fn errors_of_a_line_come_with_cause_and_cure() {
        check(
            "10 PRINT (1+2\n20 SCORE=1\n30 MGEAR(1): PRINT#1\n40 PRINT \"A\"+1",
            &[
                (
                    0,
                    "?SYNTAX ERROR",
                    "A closing parenthesis is missing.",
                    Some("10 PRINT (1+2)"),
                ),
                (
                    1,
                    "?SYNTAX ERROR",
                    "The name SCORE has the keyword OR in it; a name must not.",
                    None,
                ),
                (
                    2,
                    "?NOT IMPLEMENTED ERROR",
                    "MGEAR: It is not simulated yet.",
                    None,
                ),
                (
                    2,
                    "?NOT IMPLEMENTED ERROR",
                    "PRINT does not work with files: the device itself does not implement them.",
                    None,
                ),
                (3, "?TYPE MISMATCH ERROR", "A string is wanted here.", None),
            ],
        );
    }

    #[test]
    fn a_jump_to_no_line_offers_the_nearest() {
        check(
            "10 GOTO 100\n 25 IF A THEN X=1 ELSE 24\n30 RUN 500",
            &[
                (
                    0,
                    "?UNDEF'D STATEMENT ERROR",
                    "There is no line 100.",
                    Some("10 GOTO 30"),
                ),
                (
                    1,
                    "?UNDEF'D STATEMENT ERROR",
                    "There is no line 24.",
                    Some(" 25 IF A THEN X=1 ELSE 25"),
                ),
                (
                    2,
                    "?UNDEFINED LINE NUMBER ERROR",
                    "There is no line 500.",
                    Some("30 RUN 30"),
                ),
            ],
        );
    }

    #[test]
    fn line_numbers_are_judged() {
        check(
            "20 END\n10 END\n10 STOP\n15\nPRINT 1\n70000 END",
            &[
                (
                    1,
                    "LINE 10 OUT OF ORDER",
                    "The device sorts its lines: line 10 will stand before line 20.",
                    None,
                ),
                (
                    2,
                    "LINE 10 TWICE",
                    "Line 10 stands here a second time: this one replaces the first.",
                    None,
                ),
                (
                    3,
                    "LINE 15 IS EMPTY",
                    "A number alone deletes line 15.",
                    None,
                ),
                (
                    4,
                    "?SYNTAX ERROR",
                    "A program line begins with its number.",
                    Some("25 PRINT 1"),
                ),
                (5, "?SYNTAX ERROR", "A line number is at most 63999.", None),
            ],
        );
    }

    #[test]
    fn what_the_device_cannot_hold_is_shown() {
        let long = format!("10 PRINT \"{}\"", "X".repeat(80));
        let [found] = &diagnose(&long)[..] else {
            unreachable!("{long}");
        };
        assert_eq!(
            (found.span, found.message.as_str()),
            (Span::new(80, 91), "?STRING TOO LONG ERROR")
        );
        check(
            "10 PRINT \u{201c}A\"\n20 GOTO 10",
            &[(
                0,
                "?SYNTAX ERROR",
                "The device has no character \u{201c}.",
                Some("10 PRINT \"A\""),
            )],
        );
    }

    #[test]
    fn spans_are_counted_in_characters() {
        let [found] = &diagnose("10 PRINT \"\u{e9}\u{e9}\": X=(")[..] else {
            unreachable!();
        };
        assert_eq!(found.span, Span::new(18, 18));
    }

    #[test]
    fn highlights_the_parts_of_a_line() {
        use HighlightClass::*;
        let line = " 10 FORI=1TOX%:A$=CHR$(65)+\"\u{e9}\":MV_ACC%=SCORE AND{pi}:MMOVE(5):REM x";
        let parts: Vec<(String, HighlightClass)> = highlight(line)
            .into_iter()
            .map(|part| {
                let range = part.span.range();
                (
                    line.chars().skip(range.start).take(range.len()).collect(),
                    part.class,
                )
            })
            .collect();
        let expected = [
            ("10", LineNumber),
            ("FOR", Keyword),
            ("I", Variable),
            ("=", Operator),
            ("1", Number),
            ("TO", Keyword),
            ("X%", Variable),
            (":", Operator),
            ("A$", Variable),
            ("=", Operator),
            ("CHR$", Function),
            ("(", Operator),
            ("65", Number),
            (")", Operator),
            ("+", Operator),
            ("\"\u{e9}\"", Text),
            (":", Operator),
            ("MV_ACC%", SystemVariable),
            ("=", Operator),
            ("SCORE", Error),
            ("AND", Operator),
            ("{pi}", Number),
            (":", Operator),
            ("MMOVE", Function),
            ("(", Operator),
            ("5", Number),
            (")", Operator),
            (":", Operator),
            ("REM", Comment),
            (" x", Comment),
        ];
        let parts: Vec<(&str, HighlightClass)> = parts
            .iter()
            .map(|(text, class)| (text.as_str(), *class))
            .collect();
        assert_eq!(parts, expected);
        assert_eq!(highlight("70000 END")[0].class, Error);
    }
}
