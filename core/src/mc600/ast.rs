//! What a line of MotionBasic says, before it is compiled: the parser's result.
//!
//! Parsing never fails. A statement that cannot be understood becomes [`StatementKind::Malformed`]; the editor shows
//! it at once, the interpreter raises it in the device's own words when it is reached.

use super::firmware::ErrorCode;
use super::keywords::Keyword;
use super::sysvars::SysVar;
use crate::language::{Cure, Span};

/// One statement with its place in the line.
#[derive(Debug, Clone, PartialEq)]
pub struct Statement {
    /// Bytes of the line's text (line number excluded from the statement, included in the count).
    pub span: Span,
    /// What it does.
    pub kind: StatementKind,
}

/// What went wrong in a statement, and why in plain words.
#[derive(Debug, Clone, PartialEq)]
pub struct Malformed {
    /// The error that the device raises when the statement is reached.
    pub error: ErrorCode,
    /// Where, within the statement.
    pub span: Span,
    /// A plain sentence for the editor.
    pub cause: String,
    /// What would settle it, where that is clear.
    pub cure: Option<Cure>,
}

/// Every statement and command of MotionBasic.
#[derive(Debug, Clone, PartialEq)]
pub enum StatementKind {
    /// Raises its error when reached.
    Malformed(Malformed),
    /// `[LET] target = value`
    Let {
        /// Where the value goes.
        target: Target,
        /// What is stored.
        value: Expr,
    },
    /// `PRINT` / `?`
    Print(Vec<PrintItem>),
    /// `INPUT ["prompt";] list`
    Input {
        /// Text before the question mark.
        prompt: Option<Vec<u8>>,
        /// Where the answers go.
        targets: Vec<Target>,
    },
    /// `GOTO n`, `GO TO n`, and the line number after THEN or ELSE.
    Goto(LineRef),
    /// `GOSUB n`
    Gosub(LineRef),
    /// `RETURN`
    Return,
    /// `ON selector GOTO|GOSUB n, n, ...`
    On {
        /// 1-based choice.
        selector: Expr,
        /// GOSUB instead of GOTO.
        gosub: bool,
        /// The choices.
        lines: Vec<LineRef>,
    },
    /// `IF condition THEN|GOTO ... [ELSE ...]`; the branches hold the rest of the line.
    If {
        /// Not zero is true.
        condition: Expr,
        /// After THEN.
        then: Vec<Statement>,
        /// After ELSE; `None` without one.
        otherwise: Option<Vec<Statement>>,
    },
    /// `FOR variable = start TO limit [STEP step]`
    For {
        /// A simple numeric variable.
        variable: Name,
        /// First value.
        start: Expr,
        /// Last value.
        limit: Expr,
        /// Increment; 1 without one.
        step: Option<Expr>,
    },
    /// `NEXT [variable, ...]`
    Next(Vec<Name>),
    /// `WHILE [condition]`
    While(Option<Expr>),
    /// `WHEND [condition]` or `WEND [condition]`
    Whend(Option<Expr>),
    /// `REM anything`
    Rem,
    /// `DATA constants`
    Data(Vec<DataItem>),
    /// `READ targets`
    Read(Vec<Target>),
    /// `RESTORE`
    Restore,
    /// `DIM name(sizes), ...`
    Dim(Vec<(Name, Vec<Expr>)>),
    /// `END`
    End,
    /// `STOP`
    Stop,
    /// `NEW`
    New,
    /// `LIST [first][-[last]]`
    List(LineRange),
    /// `RUN ["file"][,line]` or `RUN line`
    Run {
        /// Program to load first.
        file: Option<Expr>,
        /// Line to start at.
        line: Option<LineRef>,
    },
    /// `CONT`
    Cont,
    /// `DEL range, ...`
    Del(Vec<LineRange>),
    /// `RENUM [start[,increment]]`
    Renum {
        /// New first line number, 10 without one.
        start: Option<u16>,
        /// Distance between lines, 10 without one.
        increment: Option<u16>,
    },
    /// `AUTO [start][,increment]`
    Auto {
        /// First line number offered, 10 without one.
        start: Option<u16>,
        /// Distance between lines, 10 without one.
        increment: Option<u16>,
    },
    /// `FILES ["mask"]`
    Files(Option<Expr>),
    /// `SAVE ["name"]`
    Save(Option<Expr>),
    /// `LOAD "name"`
    Load(Expr),
    /// `MERGE "name"`
    Merge(Expr),
    /// `COPY "from","to"`
    Copy {
        /// The file that there is.
        from: Expr,
        /// The name of the new one, or a disk alone.
        to: Expr,
    },
    /// `ERASE "mask"`
    Erase(Expr),
    /// `FORMAT "disk:"`
    Format(Expr),
    /// `PASSWORD`
    Password,
    /// `RETI`
    Reti,
    /// A motion, drive, interrupt or I/O call: `MMOVE(40960)`, `MCAM(T%)`. The arguments are counted by the parser.
    Call {
        /// One of the calls of `motion_calls`.
        keyword: Keyword,
        /// Numeric expressions, and the names of tables.
        arguments: Vec<Expr>,
    },
    /// A word of the table that this firmware does not do .
    NotImplemented(Keyword),
}

/// A variable's name, upper case, with its `%` or `$` (20 characters at most before it).
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub struct Name {
    /// For example `CNT%`.
    pub text: Box<str>,
    /// From the last character.
    pub kind: VariableKind,
}

/// What a variable or an expression holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum VariableKind {
    /// No suffix: f64.
    Real,
    /// `%`: 32 bit.
    Integer,
    /// `$`: up to 255 bytes.
    String,
}

/// Something that can be assigned.
#[derive(Debug, Clone, PartialEq)]
pub enum Target {
    /// A simple variable.
    Variable(Name),
    /// An array element; one to four subscripts.
    Element(Name, Vec<Expr>),
    /// A system variable that can be written.
    System(SysVar),
}

/// An item of a PRINT list. Juxtaposed items are two `Expr` in a row.
#[derive(Debug, Clone, PartialEq)]
pub enum PrintItem {
    /// A value.
    Expr(Expr),
    /// `,`: to the next zone.
    Comma,
    /// `;`
    Semicolon,
    /// `TAB(n)`: to column n of the line.
    Tab(Expr),
    /// `SPC(n)`: n spaces.
    Spc(Expr),
}

/// A line number in a jump, with its place (for RENUM and diagnostics). `GOTO` without a number is `GOTO 0` with an
/// empty span.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct LineRef {
    /// 0..=63999
    pub number: u16,
    /// Where its digits stand.
    pub span: Span,
}

/// `100`, `100-`, `-200`, `100-200`, or nothing at all.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct LineRange {
    /// First line, inclusive.
    pub first: u16,
    /// Last line, inclusive; `u16::MAX` when open.
    pub last: u16,
}

/// One constant of a DATA line: its text, and whether it stood in quotes.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct DataItem {
    /// Without the quotes; unquoted items lose the blanks around them.
    pub text: Vec<u8>,
    /// A quoted item is never a number.
    pub quoted: bool,
}

/// An expression with its place in the line.
#[derive(Debug, Clone, PartialEq)]
pub struct Expr {
    /// Bytes of the line's text.
    pub span: Span,
    /// What it computes.
    pub kind: ExprKind,
}

/// Every form of expression.
#[derive(Debug, Clone, PartialEq)]
pub enum ExprKind {
    /// A whole constant within 32 bits, or `&H`.
    Integer(i32),
    /// Any other numeric constant, `{pi}` included.
    Real(f64),
    /// A string constant.
    Text(Vec<u8>),
    /// A simple variable.
    Variable(Name),
    /// An array element.
    Element(Name, Vec<Expr>),
    /// A system variable.
    System(SysVar),
    /// `-a` or `NOT a`
    Unary(UnaryOp, Box<Expr>),
    /// `a op b`
    Binary(BinaryOp, Box<Expr>, Box<Expr>),
    /// A function; the parser has counted the arguments.
    Call(Function, Vec<Expr>),
}

/// Operators with one operand.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum UnaryOp {
    /// `-`
    Negate,
    /// `NOT`, on 32 bits
    Not,
}

/// Operators with two operands.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[allow(missing_docs)] // the names say it
pub enum BinaryOp {
    Power,
    Multiply,
    Divide,
    Add,
    Subtract,
    Equal,
    NotEqual,
    Less,
    LessEqual,
    Greater,
    GreaterEqual,
    And,
    Or,
    Xor,
}

/// Functions that stand in expressions.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[allow(missing_docs)] // the names are the language's words
pub enum Function {
    Abs,
    Atn,
    Asc,
    /// `CAN_DATA%(mailbox)`
    CanData,
    ChrS,
    Cos,
    Exp,
    Insta,
    Int,
    LeftS,
    Len,
    Log,
    MidS,
    Mod,
    Outsta,
    RightS,
    Rnd,
    Sdoerror,
    Sdoread,
    Sgn,
    Sin,
    Sqr,
    Sqrt,
    StrS,
    Tan,
    Val,
}
