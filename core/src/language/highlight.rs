use super::Span;

/// The class of one part of a line. Parts are in order and do not overlap; what lies between them is blank.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub struct Highlight {
    /// Where in the line.
    pub span: Span,
    /// How to show it.
    pub class: HighlightClass,
}

/// What a part of a line is, for an editor's colours.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub enum HighlightClass {
    /// The number in front of a line.
    LineNumber,
    /// A statement, a command, or a word inside one.
    Keyword,
    /// Something that is called with arguments.
    Function,
    /// A variable of the program.
    Variable,
    /// A variable of the controller.
    SystemVariable,
    /// A numeric constant.
    Number,
    /// A string constant, or the text of a DATA line.
    Text,
    /// A remark.
    Comment,
    /// An operator or a punctuation mark.
    Operator,
    /// What the controller cannot read.
    Error,
}
