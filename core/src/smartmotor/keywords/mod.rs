//! Every word of the language: what it is called, what it does, and whether it works here.
//!
//! One table feeds completion, help and the support table. A row may stand for many words: `C#` for every label, `a..z`
//! for 26 variables, `RUAI` for the reports of all pins. Ten words are more than the list has (D150).

mod flow;
mod motion;
mod ports;
mod reports;
mod serial;
mod status;
mod variables;

use crate::language::{KeywordRow, ManualRef, Support, find_word, words_of};

const FLOW: ManualRef = ManualRef("Program Flow");
const MOTION: ManualRef = ManualRef("spec: Motion");
const STATUS: ManualRef = ManualRef("spec: Status word");
const VARIABLES: ManualRef = ManualRef("spec: Variables");
const PORTS: ManualRef = ManualRef("spec: Ports");
const SERIAL: ManualRef = ManualRef("spec: Serial");

/// The groups of the table; in each, words stand in the order of their bytes.
const TABLES: [&[KeywordRow]; 7] = [
    flow::ROWS,
    motion::ROWS,
    status::ROWS,
    variables::ROWS,
    ports::ROWS,
    serial::ROWS,
    reports::ROWS,
];

/// The words of each group.
const WORDS: [&[&str]; 7] = [
    &words_of::<{ flow::ROWS.len() }>(flow::ROWS),
    &words_of::<{ motion::ROWS.len() }>(motion::ROWS),
    &words_of::<{ status::ROWS.len() }>(status::ROWS),
    &words_of::<{ variables::ROWS.len() }>(variables::ROWS),
    &words_of::<{ ports::ROWS.len() }>(ports::ROWS),
    &words_of::<{ serial::ROWS.len() }>(serial::ROWS),
    &words_of::<{ reports::ROWS.len() }>(reports::ROWS),
];

const fn row_of(
    word: &'static str,
    kind: &'static str,
    section: ManualRef,
    support: Support,
    text: [&'static str; 3],
) -> KeywordRow {
    let [syntax, summary, example] = text;
    KeywordRow {
        word,
        kind,
        syntax,
        summary,
        section,
        support,
        example,
    }
}

/// Every row.
pub fn rows() -> Vec<&'static KeywordRow> {
    TABLES.into_iter().flatten().collect()
}

/// The row of a word, as the table writes it.
pub fn row(word: &str) -> Option<&'static KeywordRow> {
    TABLES.into_iter().find_map(|table| {
        let at = table.binary_search_by(|row| row.word.cmp(word)).ok()?;
        table.get(at)
    })
}

/// The word of the table that is written so.
pub fn find(word: &str) -> Option<&'static str> {
    find_word(&WORDS, word)
}

#[cfg(test)]
mod tests {
    use super::super::ast::StatementKind;
    use super::super::parser::parse_line;
    use super::*;

    #[test]
    fn every_word_is_found() {
        for known in rows() {
            assert_eq!(row(known.word), Some(known), "{}", known.word);
            assert_eq!(find(known.word), Some(known.word));
        }
        assert_eq!(find("GOTO"), None);
    }

    #[test]
    fn every_example_parses_and_uses_its_word() {
        for row in rows() {
            let parsed = parse_line(row.example.as_bytes(), None);
            let mut kinds = parsed.statements.iter().map(|statement| &statement.kind);
            let bad = kinds.find(|kind| matches!(kind, StatementKind::Malformed(_)));
            assert_eq!(bad, None, "{}", row.example);
            assert!(
                parsed.used.contains(&row.word),
                "{}: {:?}",
                row.word,
                parsed.used
            );
            let without = parse_line(row.example.as_bytes(), Some(row.word));
            let mut kinds = without.statements.iter().map(|statement| &statement.kind);
            assert!(kinds.any(|kind| matches!(kind, StatementKind::Malformed(_))));
        }
    }
}
