use super::Span;

/// Something to say about a program's text, told without running it.
#[derive(Debug, Clone, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub struct Diagnostic {
    /// Line of the text, from 0 (not the program's own line number).
    pub line: u32,
    /// Where in that line.
    pub span: Span,
    /// Whether the controller would object.
    pub severity: Severity,
    /// The controller's own words, for example `?SYNTAX ERROR`; for a warning, which it would not give, ours.
    pub message: String,
    /// Why, in one plain sentence.
    pub cause: String,
    /// What could be done about it.
    pub cure: Option<Cure>,
}

impl Diagnostic {
    /// Puts what was found in the order in which one reads the text.
    pub fn sort(found: &mut [Diagnostic]) {
        found.sort_by_key(|found| (found.line, found.span));
    }
}

/// How bad it is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub enum Severity {
    /// The controller objects, at the latest when it gets there.
    Error,
    /// The controller takes it, but probably not as it was meant.
    Warning,
}

/// A change that would settle a [`Diagnostic`].
#[derive(Debug, Clone, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub struct Cure {
    /// What it does, for a button.
    pub label: String,
    /// Where in the diagnostic's line; empty inserts.
    pub span: Span,
    /// The text that is put there.
    pub replacement: String,
}
