//! Every word of the unit: codewords, commands of the controller, keys.
//!
//! One table feeds completion, help and the support table.

mod keys;
mod motion;
mod preparatory;
mod registers;
mod remote;

use crate::language::{KeywordRow, ManualRef, Support};

/// The groups of the table; in each, words stand in the order of their bytes.
const TABLES: [&[KeywordRow]; 5] = [
    motion::ROWS,
    preparatory::ROWS,
    registers::ROWS,
    remote::ROWS,
    keys::ROWS,
];

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

/// The row of a word, as the table writes it.
pub fn find(word: &str) -> Option<&'static KeywordRow> {
    let mut rows = TABLES.into_iter().flatten();
    rows.find(|row| row.word == word)
}

/// The row of a G code: `G7`, `G25=n`.
pub fn g_code(word: &str) -> Option<&'static str> {
    let place = preparatory::ROWS.binary_search_by(|row| row.word.cmp(word));
    let row = preparatory::ROWS.get(place.ok()?);
    row.map(|row| row.word)
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
