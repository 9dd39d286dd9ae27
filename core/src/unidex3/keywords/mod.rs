//! Every word of the unit: codewords, commands of the controller, keys.
//!
//! One table feeds completion, help and the support table.

mod keys;
mod motion;
mod preparatory;
mod registers;
mod remote;

use crate::language::{KeywordRow, ManualRef, Support, find_word, words_of};

/// The groups of the table; in each, words stand in the order of their bytes.
const TABLES: [&[KeywordRow]; 5] = [
    motion::ROWS,
    preparatory::ROWS,
    registers::ROWS,
    remote::ROWS,
    keys::ROWS,
];

/// The words of each group.
const WORDS: [&[&str]; 5] = [
    &words_of::<{ motion::ROWS.len() }>(motion::ROWS),
    G_CODES,
    &words_of::<{ registers::ROWS.len() }>(registers::ROWS),
    &words_of::<{ remote::ROWS.len() }>(remote::ROWS),
    &words_of::<{ keys::ROWS.len() }>(keys::ROWS),
];
const G_CODES: &[&str] = &words_of::<{ preparatory::ROWS.len() }>(preparatory::ROWS);

const fn row(
    word: &'static str,
    kind: &'static str,
    section: &'static str,
    text: [&'static str; 3],
) -> KeywordRow {
    let [syntax, summary, example] = text;
    KeywordRow {
        word,
        kind,
        syntax,
        summary,
        section: ManualRef(section),
        support: Support::Full,
        example,
    }
}

/// Every row.
pub fn rows() -> Vec<&'static KeywordRow> {
    TABLES.into_iter().flatten().collect()
}

/// The word of the table that is written so.
pub fn find(word: &str) -> Option<&'static str> {
    find_word(&WORDS, word)
}

/// The word of a G code: `G7`, `G25=n`.
pub fn g_code(word: &str) -> Option<&'static str> {
    find_word(&[G_CODES], word)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_stand_in_order() {
        for table in TABLES {
            assert!(table.is_sorted_by_key(|row| row.word));
        }
    }
}
