//! What holds for every text, sensible or not.

use proptest::collection::vec;
use proptest::prelude::*;

use super::show_line;
use crate::mc600::ast::{Statement, StatementKind};
use crate::mc600::diagnose::{diagnose, highlight};
use crate::mc600::keywords::rows;
use crate::mc600::lexer::tokens;
use crate::mc600::parser::parse_line;
use crate::mc600::program::{Program, STORED_LENGTH};

/// Words, marks, names and numbers in any order: closer to programs than bytes are.
fn soup() -> impl Strategy<Value = String> {
    let mut parts: Vec<String> = rows()
        .iter()
        .map(|row| row.word.to_ascii_lowercase())
        .collect();
    let others = [
        "A", "B$", "C%", "X(", "(", ")", ",", ";", ":", " ", "#", "\"", "\"x:y\"", "1", "10", ".5",
        "1e9", "-", "&hF", "\u{e9}", "handle%", "gv_inx%", "64000", "=", "then ", "else ",
    ];
    for _ in 0..4 {
        parts.extend(others.map(String::from));
    }
    vec(prop::sample::select(parts), 0..40).prop_map(|parts| parts.concat())
}

fn check_statements(line: &[u8], body: u32, statements: &[Statement]) -> Result<(), TestCaseError> {
    let mut last = body;
    for statement in statements {
        prop_assert!(statement.span.start >= last, "{statement:?} before {last}");
        prop_assert!(statement.span.end as usize <= line.len());
        last = statement.span.end;
        if let StatementKind::If {
            then, otherwise, ..
        } = &statement.kind
        {
            check_statements(line, statement.span.start, then)?;
            let otherwise = otherwise.as_deref().unwrap_or_default();
            check_statements(line, statement.span.start, otherwise)?;
        }
    }
    Ok(())
}

fn check_line(line: &[u8]) -> Result<(), TestCaseError> {
    let mut last = 0;
    for token in tokens(line, 0) {
        prop_assert!(token.span.start >= last && token.span.start < token.span.end);
        last = token.span.end;
    }
    prop_assert!(last as usize <= line.len());
    let parsed = parse_line(line);
    check_statements(
        line,
        u32::try_from(parsed.body).unwrap(),
        &parsed.statements,
    )
}

/// What is stored and listed says the same as what was typed.
fn check_listing(body: &[u8]) -> Result<(), TestCaseError> {
    let typed = [b"10 ".as_slice(), body].concat();
    if typed.len() > STORED_LENGTH {
        return Ok(());
    }
    let mut program = Program::default();
    program.enter(10, &typed[2..]);
    let listed = program.list_line(10).unwrap_or_else(|| b"10".to_vec());
    // Causes quote the text, keywords in upper case.
    let shown = |line: &[u8]| show_line(line).to_ascii_uppercase();
    prop_assert_eq!(shown(&listed), shown(&typed));
    Ok(())
}

proptest! {
    #[test]
    fn bytes_never_panic(line in vec(any::<u8>(), 0..300)) {
        check_line(&line)?;
        check_listing(&line)?;
    }

    #[test]
    fn soup_never_panics(line in soup()) {
        let bytes = crate::language::latin1::bytes(&line);
        check_line(&bytes)?;
        check_listing(&bytes)?;
    }

    #[test]
    fn any_text_can_be_diagnosed_and_coloured(text in "(?s).{0,400}", lines in vec(soup(), 0..8)) {
        let numbered = lines.iter().enumerate().map(|(index, line)| format!("{} {line}\n", index * 5));
        for text in [text, numbered.collect()] {
            let ends = text.chars().filter(|&c| c == '\n' || c == '\r').count();
            for found in diagnose(&text) {
                prop_assert!(found.line as usize <= ends);
                prop_assert!(!found.cause.is_empty() && found.span.start <= found.span.end);
            }
            for line in text.lines() {
                let mut last = 0;
                for part in highlight(line) {
                    prop_assert!(part.span.start >= last && !part.span.is_empty());
                    last = part.span.end;
                }
                prop_assert!(last as usize <= line.chars().count());
            }
        }
    }

    #[test]
    fn renumbering_keeps_what_a_program_says(lines in vec(soup(), 1..8), start in 0u16..60_000) {
        let mut program = Program::default();
        for (number, line) in (0u16..).zip(&lines) {
            program.enter(number, &crate::language::latin1::bytes(&format!(" {line}")));
        }
        let before = program.clone();
        if program.renumber(start, 7).is_ok() {
            prop_assert!(program.renumber(0, 1).is_ok());
        }
        // Lines that were blank left gaps, which renumbering closes.
        if before.lines().map(|(number, _)| number).eq(0..u16::try_from(lines.len()).unwrap()) {
            for (number, _) in before.lines() {
                let shown = |program: &Program| show_line(&program.list_line(number).unwrap());
                // A line 0 that was left out is written when it moves, also in a statement with an error, which may
                // then be another error.
                if !shown(&before).contains("?SYNTAX") {
                    prop_assert_eq!(shown(&program), shown(&before));
                }
            }
        }
    }
}
