//! What is wrong with a program, told from its text alone, and the colours of its lines.

#[cfg(test)]
mod tests;

use super::compile::{Problem, compile};
use super::firmware::PROGRAM_BYTES;
use super::keywords;
use super::lexer::{Token, TokenKind, tokens};
use super::parser::parse_line;
use super::store::strip;
use crate::language::{
    Cure, Diagnostic, Highlight, HighlightClass, Severity, Span, latin1, split_lines,
};

/// Everything that can be said about a program's text, in the order of its lines.
pub fn diagnose(text: &str) -> Vec<Diagnostic> {
    let source = latin1::bytes(text);
    let mut found = strangers(text);
    let strange: Vec<u32> = found.iter().map(|found| found.line).collect();
    let bytes = strip(&source).text.len();
    if bytes > PROGRAM_BYTES {
        found.push(diagnostic(Problem {
            line: 0,
            span: Span::default(),
            name: "program too long".to_owned(),
            cause: format!("The motor keeps {PROGRAM_BYTES} bytes, and this program has {bytes}."),
            cure: None,
        }));
    } else {
        let (_, problems) = compile(&source, None);
        // A line with characters that the motor does not have is not judged further.
        let judged = problems
            .into_iter()
            .filter(|problem| strange.binary_search(&problem.line).is_err());
        found.extend(judged.map(diagnostic));
    }
    Diagnostic::sort(&mut found);
    found
}

fn diagnostic(problem: Problem) -> Diagnostic {
    Diagnostic {
        line: problem.line,
        span: problem.span,
        severity: Severity::Error,
        message: problem.name,
        cause: problem.cause,
        cure: problem.cure,
    }
}

/// Characters that the motor does not have.
fn strangers(text: &str) -> Vec<Diagnostic> {
    let mut found = Vec::new();
    for (index, line) in (0..).zip(split_lines(text.as_bytes())) {
        // A line end is never part of another character.
        let line = std::str::from_utf8(line).unwrap_or_default();
        for (position, character) in line.chars().enumerate() {
            if latin1::byte(character).is_some() {
                continue;
            }
            let span = Span::new(position, position + 1);
            let replacement = match character {
                '\u{2018}'..='\u{201b}' | '\u{2032}' => "'",
                '\u{201c}'..='\u{201f}' | '\u{2033}' => "\"",
                '\u{2010}'..='\u{2015}' | '\u{2212}' => "-",
                '\u{2264}' => "<=",
                '\u{2265}' => ">=",
                '\u{2260}' => "!=",
                _ => "?",
            };
            let cure = Cure {
                label: format!("Write {replacement}"),
                span,
                replacement: replacement.to_owned(),
            };
            found.push(diagnostic(Problem {
                line: index,
                span,
                name: "syntax error".to_owned(),
                cause: format!("The motor has no character {character}."),
                cure: Some(cure),
            }));
        }
    }
    found
}

/// The line of the stored program that each line of a text becomes, from 1; none where only a comment stands.
pub fn device_lines(text: &str) -> Vec<Option<u32>> {
    strip(&latin1::bytes(text)).lines
}

/// The words of the keyword table that a line uses.
pub fn words(line: &str) -> Vec<&'static str> {
    parse_line(&latin1::bytes(line), None).used
}

/// The parts of one line of a program, by the motor's own lexer.
pub fn highlight(line: &str) -> Vec<Highlight> {
    let bytes = latin1::bytes(line);
    tokens(&bytes)
        .into_iter()
        .map(|token| Highlight {
            span: token.span,
            class: class_of(token, &bytes),
        })
        .collect()
}

fn class_of(token: Token, line: &[u8]) -> HighlightClass {
    match token.kind {
        TokenKind::Word => word_class(token.span.of(line)),
        TokenKind::Name => HighlightClass::Variable,
        TokenKind::Number(_) => HighlightClass::Number,
        TokenKind::Text(true) => HighlightClass::Text,
        TokenKind::Text(false) | TokenKind::Bad => HighlightClass::Error,
        TokenKind::Comment => HighlightClass::Comment,
        TokenKind::Bang => HighlightClass::Keyword,
        TokenKind::Operator(_)
        | TokenKind::Assign
        | TokenKind::Open
        | TokenKind::Close
        | TokenKind::OpenBracket
        | TokenKind::CloseBracket
        | TokenKind::Comma
        | TokenKind::Hash
        | TokenKind::Period => HighlightClass::Operator,
    }
}

/// A word alone tells its class; what takes a number or an operand is found by its beginning.
fn word_class(word: &[u8]) -> HighlightClass {
    let word = std::str::from_utf8(word).unwrap_or_default();
    let stem = word.trim_end_matches(|c: char| c.is_ascii_digit());
    let row = [
        word.to_owned(),
        format!("{word}="),
        format!("{stem}#"),
        format!("{stem}[]"),
    ]
    .iter()
    .find_map(|word| keywords::row(word));
    match row.map(|row| row.kind) {
        Some("flow") => HighlightClass::Keyword,
        Some("status" | "variable") => HighlightClass::SystemVariable,
        Some(_) => HighlightClass::Function,
        // Reports of variables, module inputs, parts of OCHN.
        None if parse_line(word.as_bytes(), None).used.is_empty() => HighlightClass::SystemVariable,
        None => HighlightClass::Function,
    }
}
