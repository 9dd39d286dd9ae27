/// One word of a controller's language: a row of its table, from which lexer, completion, help and the support tables
/// in `docs/languages` are fed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize)]
pub struct KeywordRow {
    /// As the controller prints it.
    pub word: &'static str,
    /// Which group it belongs to, for example `function`.
    pub kind: &'static str,
    /// How it is written; `[ ]` may be left out, `...` repeats.
    pub syntax: &'static str,
    /// What it does, in one sentence.
    pub summary: &'static str,
    /// Where the manual describes it.
    pub section: ManualRef,
    /// Whether it works here.
    pub support: Support,
    /// One line or more that use it, with `\n` between: a program where they have numbers.
    pub example: &'static str,
}

/// The words of a table by themselves: a simulator that looks for words carries no texts for people.
#[allow(clippy::indexing_slicing)] // runs at compile time only: an index out of range would not compile
pub const fn words_of<const ROWS: usize>(rows: &[KeywordRow]) -> [&'static str; ROWS] {
    let mut words = [""; ROWS];
    let mut row = 0;
    while row < ROWS {
        words[row] = rows[row].word;
        row += 1;
    }
    words
}

/// The word that is written so, of groups in which words stand in the order of their bytes.
pub fn find_word(groups: &[&'static [&'static str]], word: &str) -> Option<&'static str> {
    groups.iter().find_map(|words| {
        let at = words.binary_search(&word).ok()?;
        words.get(at).copied()
    })
}

/// A section of the controller's manual, by its title.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize)]
pub struct ManualRef(pub &'static str);

/// How far a word works.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize)]
pub enum Support {
    /// As the manual says.
    Full,
    /// With the exception named.
    Partial(&'static str),
    /// Not at all, for the reason given.
    Absent(&'static str),
}
