//! Every word of MotionBasic: what it is called, what it does, and whether it works here.
//!
//! One table feeds lexer, highlighting, completion, help and the support table. What the device itself does not implement
//! is in the table as absent, and says `?NOT IMPLEMENTED ERROR`.

use super::sysvars::SysVar;
use crate::language::{KeywordRow, ManualRef, Support};

/// The manual has it with the remark "not implemented yet".
const ABSENT: Support = Support::Absent("The device itself does not implement it.");

// Sections of the manual.
const RULES: ManualRef = ManualRef("Basic programming rules");
const EXPRESSIONS: ManualRef = ManualRef("Expressions and operators");
const FILESYSTEM: ManualRef = ManualRef("The BASIC Filesystem");
const KEYWORDS: ManualRef = ManualRef("Description of BASIC keywords");
const MOTION: ManualRef = ManualRef("The Motion functions");
const INTERRUPTS: ManualRef = ManualRef("The Interrupt functions");
const DRIVE: ManualRef = ManualRef("The Drive related functions");
const IO: ManualRef = ManualRef("The I/O functions");
const SERVOBUS: ManualRef = ManualRef("Servobus");
const UNITS: ManualRef = ManualRef("The Motion planner units");
const OTHER: ManualRef = ManualRef("The other system variables");

/// Makes [`Keyword`] and its rows from the table.
macro_rules! words {
    ($($keyword:ident $word:literal $kind:literal $section:ident $support:ident
        $syntax:literal $summary:literal $example:literal;)*) => {
        /// A word or mark of the language.
        #[derive(Debug, Clone, Copy, PartialEq, Eq)]
        pub enum Keyword {
            $(#[doc = concat!("`", $word, "`: ", $summary)] $keyword,)*
            /// A variable of the card.
            System(crate::mc600::sysvars::SysVar),
        }

        /// Every word and its keyword in the table's order: marks, then letters by alphabet.
        pub(super) const WORDS: &[(&str, Keyword)] = &[$(($word, Keyword::$keyword),)*];

        // What a simulator needs of the table, so that it carries no texts for people.
        impl Keyword {
            /// As the device prints it.
            pub fn word(self) -> &'static str {
                match self {
                    $(Keyword::$keyword => $word,)*
                    Keyword::System(variable) => variable.word(),
                }
            }

            /// How it is written.
            pub fn syntax(self) -> &'static str {
                match self {
                    $(Keyword::$keyword => $syntax,)*
                    Keyword::System(variable) => variable.word(),
                }
            }

            /// Whether the table says that it does not work here.
            pub fn is_absent(self) -> bool {
                match self {
                    $(Keyword::$keyword => matches!($support, crate::language::Support::Absent(_)),)*
                    Keyword::System(_) => false,
                }
            }

            /// Its row of the table.
            pub fn row(self) -> &'static crate::language::KeywordRow {
                match self {
                    $(Keyword::$keyword => {
                        static ROW: crate::language::KeywordRow = crate::language::KeywordRow {
                            word: $word,
                            kind: $kind,
                            syntax: $syntax,
                            summary: $summary,
                            section: super::$section,
                            support: $support,
                            example: $example,
                        };
                        &ROW
                    })*
                    Keyword::System(variable) => super::system::row(variable),
                }
            }
        }
    };
}

mod system;
mod words;

pub use words::Keyword;
use words::WORDS;

/// Every row of the table, system variables last.
pub fn rows() -> Vec<&'static KeywordRow> {
    let words = WORDS.iter().map(|(_, keyword)| keyword.row());
    words.chain(system::rows()).collect()
}

/// The keyword that is spelled `word`, in letters of either case.
pub fn keyword(word: &str) -> Option<Keyword> {
    let variable = || SysVar::from_word(&word.to_ascii_uppercase()).map(Keyword::System);
    WORDS
        .iter()
        .find(|(spelled, _)| spelled.eq_ignore_ascii_case(word))
        .map(|&(_, keyword)| keyword)
        .or_else(variable)
}

/// The longest word of letters at the start of `text`, in either case, and its length in bytes. Words glued to what
/// follows are found; system variables, `GO TO` and the `(` that TAB and SPC need are the lexer's affair.
pub(super) fn longest_at(text: &[u8]) -> Option<(Keyword, usize)> {
    let letter = text.first()?.to_ascii_uppercase().checked_sub(b'A')?;
    let first = *BY_LETTER.get(usize::from(letter))?;
    let behind = *BY_LETTER.get(usize::from(letter) + 1)?;
    // A longer word stands behind the word that it begins with.
    let words = WORDS.get(first..behind)?.iter().rev();
    words
        .filter(|(_, keyword)| *keyword != Keyword::GoTo)
        .find(|(word, _)| {
            text.get(..word.len())
                .is_some_and(|start| start.eq_ignore_ascii_case(word.as_bytes()))
        })
        .map(|&(word, keyword)| (keyword, word.len()))
}

/// Where the words of each letter begin in [`WORDS`]; the last entry is its length.
const BY_LETTER: [usize; 27] = by_letter();

#[allow(clippy::indexing_slicing)] // runs at compile time only: an index out of range would not compile
const fn by_letter() -> [usize; 27] {
    let mut starts = [0; 27];
    let mut index = 0;
    while index < WORDS.len() {
        let first = WORDS[index].0.as_bytes()[0];
        // Marks stand before A, and a word stands before the words of every later letter.
        let mut later = if first.is_ascii_uppercase() {
            (first - b'A') as usize + 1
        } else {
            0
        };
        while later < starts.len() {
            starts[later] += 1;
            later += 1;
        }
        index += 1;
    }
    starts
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mc600::ast::StatementKind;
    use crate::mc600::parser::parse_line;

    #[test]
    fn every_word_is_found_and_stands_in_order() {
        for row in rows() {
            let found = keyword(&row.word.to_ascii_lowercase()).unwrap();
            // The manual's misprint is the same variable.
            assert_eq!(
                found.word().replace("EED", "PED"),
                row.word.replace("EED", "PED")
            );
        }
        let letters: Vec<&str> = WORDS
            .iter()
            .map(|(word, _)| *word)
            .filter(|word| word.starts_with(|c: char| c.is_ascii_alphabetic()))
            .collect();
        assert!(letters.is_sorted(), "{letters:?}");
        for (word, keyword) in WORDS {
            if letters.contains(word) && *word != "GO TO" {
                assert_eq!(longest_at(word.as_bytes()), Some((*keyword, word.len())));
            }
        }
    }

    #[test]
    fn every_example_parses_and_uses_its_word() {
        for row in rows() {
            let lines = row.example.lines();
            let parsed = lines.flat_map(|line| parse_line(line.as_bytes()).statements);
            let parsed: Vec<StatementKind> = parsed.map(|statement| statement.kind).collect();
            let absent = matches!(row.support, Support::Absent(_));
            for kind in &parsed {
                let malformed = matches!(kind, StatementKind::Malformed(_));
                assert!(!malformed, "{}: {kind:?}", row.example);
            }
            let refused = |kind: &StatementKind| matches!(kind, StatementKind::NotImplemented(_));
            assert_eq!(parsed.iter().any(refused), absent, "{}", row.example);
            assert!(row.example.contains(row.word), "{}", row.example);
            assert!(row.example.lines().all(|line| line.len() <= 80));
        }
    }

    #[test]
    fn the_longest_word_wins() {
        for (text, expected) in [
            ("gotoxy 1,2", Some((Keyword::Gotoxy, 6))),
            ("GOTO100", Some((Keyword::Goto, 4))),
            ("SQRT(2)", Some((Keyword::Sqrt, 4))),
            ("SQR(2)", Some((Keyword::Sqr, 3))),
            ("INTSETUP", Some((Keyword::Intsetup, 8))),
            ("INTO", Some((Keyword::Int, 3))),
            ("FORMAT", Some((Keyword::Format, 6))),
            ("ZEBRA", None),
            ("1", None),
            ("", None),
            ("{pi}", None),
        ] {
            assert_eq!(longest_at(text.as_bytes()), expected, "{text}");
        }
    }
}
