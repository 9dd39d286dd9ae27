//! What a line says: commands, one after the other.

use super::motor::{Command, Flag, Register};
use crate::language::{Cure, Span};
use crate::serial::Parity;

/// Variables `a` to `z`, `aa` to `zz`, `aaa` to `zzz`, in this order.
pub const VARIABLES: u16 = 78;

/// A command and where it stands in its line.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Statement {
    /// What it does.
    pub kind: StatementKind,
    /// All of it.
    pub span: Span,
}

/// Every command.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum StatementKind {
    /// `C5`
    Label(u16),
    /// `GOTO5`
    Goto(u16),
    /// `GOSUB5`
    Gosub(u16),
    /// `RETURN`
    Return,
    /// `STACK`
    Stack,
    /// `RUN`
    Run,
    /// `RUN?`
    RunIfAsked,
    /// `END`
    End,
    /// `WHILE condition`
    While(Expr),
    /// `LOOP`
    Loop,
    /// `BREAK`
    Break,
    /// `IF condition`
    If(Expr),
    /// `ELSEIF condition`
    ElseIf(Expr),
    /// `ELSE`
    Else,
    /// `ENDIF`
    EndIf,
    /// `SWITCH value`
    Switch(Expr),
    /// `CASE value`
    Case(Expr),
    /// `DEFAULT`
    Default,
    /// `ENDS`
    EndSwitch,
    /// `TWAIT`
    WaitForTrajectory,
    /// `WAIT=samples`
    Wait(Expr),
    /// `Z`, `RESET`
    Reset,
    /// `a=b+1`, `V=1000`
    Assign(Target, Expr),
    /// `aw[t] 63 44 98.`: stores in sequence
    Fill {
        /// Which array.
        array: Array,
        /// Where the first goes.
        index: Index,
        /// What is stored.
        values: Vec<i32>,
    },
    /// An order for the motor.
    Motor(Command),
    /// A clear of a communication bit: `Zb`, `Zc`, `Zf`
    ClearLine(LineFlag),
    /// `Ra`, `RP`, `RW`
    Report(Report),
    /// `PRINT(...)`
    Print {
        /// 0, or 1 of `PRINT1`.
        channel: u8,
        /// What it sends.
        items: Vec<Item>,
    },
    /// `VST(al[0],4)`
    Store(Range),
    /// `VLD(al[0],4)`
    Load(Range),
    /// An order for the serial line.
    Line(LineCommand),
    /// `DOUTA0,1`, `AOUTA,5`: no such module is on the bench.
    ModuleOutput(Expr),
    /// What cannot be understood.
    Malformed(Malformed),
}

/// What cannot be understood, and why.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Malformed {
    /// The part that is wrong.
    pub span: Span,
    /// One sentence.
    pub cause: String,
    /// What could be done about it.
    pub cure: Option<Cure>,
    /// More of the line might make it right: a host may still be typing.
    pub unfinished: bool,
}

/// One value, or two with an operator between them.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Expr {
    /// The first or only operand.
    pub left: Operand,
    /// What is done to it.
    pub rest: Option<(Operator, Operand)>,
}

/// Between two operands.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum Operator {
    Add,
    Subtract,
    Multiply,
    Divide,
    And,
    Or,
    Equal,
    NotEqual,
    Less,
    LessEqual,
    Greater,
    GreaterEqual,
}

impl Operator {
    /// As it is written.
    pub fn word(self) -> &'static str {
        match self {
            Operator::Add => "+",
            Operator::Subtract => "-",
            Operator::Multiply => "*",
            Operator::Divide => "/",
            Operator::And => "&",
            Operator::Or => "|",
            Operator::Equal => "==",
            Operator::NotEqual => "!=",
            Operator::Less => "<",
            Operator::LessEqual => "<=",
            Operator::Greater => ">",
            Operator::GreaterEqual => ">=",
        }
    }
}

/// A value.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Operand {
    /// A constant.
    Number(i32),
    /// A variable or an element.
    Place(Place),
    /// Something of the motor.
    Source(Source),
}

/// Where a number can be kept.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Place {
    /// 0 is `a`, 26 `aa`, 52 `aaa`.
    Variable(u16),
    /// `aw[i]`
    Element(Array, Index),
}

/// An array, by the size of its elements.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Array {
    /// `ab[0]` to `ab[200]`: 8 bits.
    Bytes,
    /// `aw[0]` to `aw[100]`: 16 bits.
    Words,
    /// `al[0]` to `al[50]`: 32 bits.
    Longs,
}

/// Which element.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Index {
    /// `[3]`
    Number(i32),
    /// `[a]`
    Variable(u16),
    /// `[a+b]`
    Sum(u16, u16),
    /// `[a-b]`
    Difference(u16, u16),
}

/// What an assignment sets.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Target {
    /// A variable or an element.
    Place(Place),
    /// A register of the motor.
    Register(Register),
    /// `EPTR=`
    EepromPointer,
    /// `ADDR=`
    Address,
}

/// What is read of the motor besides variables.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Source {
    /// A register.
    Register(Register),
    /// A bit of the status word.
    Flag(Flag),
    /// A bit of the serial line.
    LineFlag(LineFlag),
    /// `EPTR`
    EepromPointer,
    /// `ADDR`
    Address,
    /// `LEN`
    Length,
    /// `GETCHR`
    Character,
    /// `DINA0`, `AINA1`: no such module is on the bench, they read 0 (D148).
    ModuleInput,
}

/// The serial line's error bits.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LineFlag {
    /// `Bb`: a parity error.
    Parity,
    /// `Bc`: characters were lost.
    Overflow,
    /// `Bf`: a framing error.
    Framing,
}

/// What a report tells.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Report {
    /// `Ra`, `RP`, `RBt`: a number.
    Value(Operand),
    /// A text.
    Text(TextReport),
}

/// Reports that are no single number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TextReport {
    /// `RW`: the status word.
    Word,
    /// `RS`: its low byte.
    Byte,
    /// `RPW`: position and status word.
    PositionAndWord,
    /// `RSP`: the sample time and the version.
    Sample,
    /// `RCKS`: the program's checksums.
    Checksum,
    /// `RCS1`: the state of channel 1.
    Channel1,
    /// `RMODE`: a letter.
    Mode,
}

/// A part of what PRINT sends.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Item {
    /// `"text"`
    Text(Vec<u8>),
    /// A number in digits.
    Number(Expr),
    /// `#13`: a byte.
    Byte(Expr),
}

/// Variables in sequence, for VST and VLD.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Range {
    /// The first.
    pub first: Place,
    /// How many.
    pub count: Operand,
}

/// An order for the serial line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LineCommand {
    /// `SADDR5`
    Address(u8),
    /// `SLEEP`
    Sleep,
    /// `WAKE`
    Wake,
    /// `ECHO`, `ECHO_OFF`
    Echo(bool),
    /// `SILENT`, `TALK`
    Silent(bool),
    /// `BAUD19200`
    Baud(u32),
    /// `OCHN(...)`
    Open(Channel),
    /// `CCHN(RS2,0)`: the channel's number
    Close(u8),
    /// `!`
    Pause,
    /// `LOAD`
    Load,
    /// `UPLOAD`; `UP` with the compiler's addresses.
    Upload {
        /// `UP`
        compiled: bool,
    },
    /// `Q`
    Query,
}

/// What OCHN sets.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Channel {
    /// 0 is the host's, 1 the second.
    pub number: u8,
    /// As on the line.
    pub parity: Parity,
    /// Bits a second.
    pub baud: u32,
    /// 1 or 2.
    pub stop_bits: u8,
    /// 7 or 8.
    pub data_bits: u8,
    /// What comes in is data for GETCHR, not commands.
    pub data: bool,
}

/// The number of a variable: `a` is 0, `aa` 26, `aaa` 52.
pub fn variable(name: &[u8]) -> Option<u16> {
    let (&first, rest) = name.split_first()?;
    let letter = first.is_ascii_lowercase().then(|| first - b'a')?;
    let same = rest.len() < 3 && rest.iter().all(|&byte| byte == first);
    let group = u16::try_from(rest.len()).ok()?;
    same.then(|| group * 26 + u16::from(letter))
}
