//! What the four languages share: lines and places in them, keyword rows, diagnostics, highlighting, a byte cursor,
//! precedence climbing. What a word means, and how it is spelled, is each controller's own affair.

mod cursor;
mod diagnostic;
mod highlight;
mod keyword;
pub mod latin1;
mod lines;
pub mod precedence;

pub use cursor::Cursor;
pub use diagnostic::{Cure, Diagnostic, Severity};
pub use highlight::{Highlight, HighlightClass};
pub use keyword::{KeywordRow, ManualRef, Support, find_word, words_of};
pub use lines::split_lines;

/// A place in one line of text: bytes `start..end` as the device holds the line, where one character is one byte
/// ([`latin1`]); so these are also character counts of the text that a person edits.
#[derive(
    Debug,
    Clone,
    Copy,
    PartialEq,
    Eq,
    PartialOrd,
    Ord,
    Hash,
    Default,
    serde::Serialize,
    serde::Deserialize,
)]
pub struct Span {
    /// First byte.
    pub start: u32,
    /// Behind the last byte.
    pub end: u32,
}

impl Span {
    /// The bytes `start..end`; beyond 4 GiB it saturates.
    pub fn new(start: usize, end: usize) -> Span {
        let bound = |offset| u32::try_from(offset).unwrap_or(u32::MAX);
        Span {
            start: bound(start),
            end: bound(end),
        }
    }

    /// From the start of this to the end of `last`.
    pub fn to(self, last: Span) -> Span {
        Span {
            start: self.start,
            end: last.end,
        }
    }

    /// The bytes of `text` in this place; empty if it lies outside.
    pub fn of(self, text: &[u8]) -> &[u8] {
        text.get(self.range()).unwrap_or_default()
    }

    /// As a range of indices.
    pub fn range(self) -> std::ops::Range<usize> {
        self.start as usize..self.end as usize
    }

    /// Whether it holds no byte: a place between two characters.
    pub fn is_empty(self) -> bool {
        self.start >= self.end
    }
}
