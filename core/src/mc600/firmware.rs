//! What the firmware says and how long it takes: error texts, statement times, limits.
//!
//! Sources: the manual's descriptions of each keyword for the texts, `docs/decisions.md` for what it leaves out.

use crate::time::Nanos;

/// Every error of MotionBasic.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[allow(missing_docs)] // the texts below say what they are
pub enum ErrorCode {
    Syntax,
    NextWithoutFor,
    ReturnWithoutGosub,
    OutOfData,
    IllegalQuantity,
    Overflow,
    OutOfMemory,
    UndefdStatement,
    UndefinedLineNumber,
    BadSubscript,
    RedimdArray,
    DivisionByZero,
    TypeMismatch,
    StringTooLong,
    FormulaTooComplex,
    CantContinue,
    FileNotFound,
    FileOpen,
    IllegalDirect,
    NotImplemented,
}

impl ErrorCode {
    const ALL: [ErrorCode; 20] = [
        ErrorCode::Syntax,
        ErrorCode::NextWithoutFor,
        ErrorCode::ReturnWithoutGosub,
        ErrorCode::OutOfData,
        ErrorCode::IllegalQuantity,
        ErrorCode::Overflow,
        ErrorCode::OutOfMemory,
        ErrorCode::UndefdStatement,
        ErrorCode::UndefinedLineNumber,
        ErrorCode::BadSubscript,
        ErrorCode::RedimdArray,
        ErrorCode::DivisionByZero,
        ErrorCode::TypeMismatch,
        ErrorCode::StringTooLong,
        ErrorCode::FormulaTooComplex,
        ErrorCode::CantContinue,
        ErrorCode::FileNotFound,
        ErrorCode::FileOpen,
        ErrorCode::IllegalDirect,
        ErrorCode::NotImplemented,
    ];

    /// The error that `error as u16` came from.
    pub fn from_number(number: u16) -> ErrorCode {
        ErrorCode::ALL
            .get(usize::from(number))
            .copied()
            .unwrap_or(ErrorCode::Syntax)
    }

    /// The words between `?` and ` ERROR`.
    pub fn text(self) -> &'static str {
        match self {
            ErrorCode::Syntax => "SYNTAX",
            ErrorCode::NextWithoutFor => "NEXT WITHOUT FOR",
            ErrorCode::ReturnWithoutGosub => "RETURN WITHOUT GOSUB",
            ErrorCode::OutOfData => "OUT OF DATA",
            ErrorCode::IllegalQuantity => "ILLEGAL QUANTITY",
            ErrorCode::Overflow => "OVERFLOW",
            ErrorCode::OutOfMemory => "OUT OF MEMORY",
            ErrorCode::UndefdStatement => "UNDEF'D STATEMENT",
            ErrorCode::UndefinedLineNumber => "UNDEFINED LINE NUMBER",
            ErrorCode::BadSubscript => "BAD SUBSCRIPT",
            ErrorCode::RedimdArray => "REDIM'D ARRAY",
            ErrorCode::DivisionByZero => "DIVISION BY ZERO",
            ErrorCode::TypeMismatch => "TYPE MISMATCH",
            ErrorCode::StringTooLong => "STRING TOO LONG",
            ErrorCode::FormulaTooComplex => "FORMULA TOO COMPLEX",
            ErrorCode::CantContinue => "CAN'T CONTINUE",
            ErrorCode::FileNotFound => "FILE NOT FOUND",
            ErrorCode::FileOpen => "FILE OPEN",
            ErrorCode::IllegalDirect => "ILLEGAL DIRECT",
            ErrorCode::NotImplemented => "NOT IMPLEMENTED",
        }
    }
}

/// The planner's sample period ("How the MC-600 works"; the unit `Sampling time` of the planner).
pub const SAMPLE: Nanos = Nanos(2_000_000);

/// Firmware time in which statement costs are counted, in ns (D46: what one operand adds to a statement on the
/// card's C167).
pub const COST_UNIT: i64 = 50_000;

/// What a statement costs before its operands are counted, so that a simple one takes 0.4 ms (D46).
pub const STATEMENT_COST: u16 = 6;

/// What SAVE, LOAD, RUN of a file and RENUM take for each byte of the program, in ns (D54): so a long program cannot
/// stop the clock on the wall by being saved again and again.
pub const BYTE_COST: i64 = 2_000;

/// Firmware time that a sample holds at the most, in ns: 10,000 of the cheapest statements, however fast the interpreter
/// is made to be.
pub const CREDIT_A_SAMPLE: Nanos = Nanos(10_000 * (STATEMENT_COST as u64) * (COST_UNIT as u64));

/// Longest line that the console takes (Basic programming rules).
pub const LINE_LENGTH: usize = 80;

/// Highest line number (D20).
pub const LAST_LINE: u16 = 63_999;

/// Longest name before its `%` or `$` (Integer floating point and string variables).
pub const NAME_LENGTH: usize = 20;

/// Longest string (functions take lengths of 0 to 255).
pub const STRING_LENGTH: usize = 255;

/// Deepest nesting of parentheses in an expression (Hierarchy of operations).
pub const PARENTHESES: usize = 10;

/// Deepest nesting of FOR loops (NEXT).
pub const FOR_LEVELS: usize = 9;

/// Deepest nesting of GOSUB (D21).
pub const GOSUB_LEVELS: usize = 64;

/// Program and variables share the card's RAM (Technical data).
pub const MEMORY: usize = 1 << 20;

/// Disk A:, in RAM (The BASIC Filesystem).
pub const DISK_A: usize = 512 << 10;

/// Disk B:, in FLASH (The BASIC Filesystem).
pub const DISK_B: usize = 768 << 10;

/// Largest magnitude of a real: 1.70141183E+38 is 2^127 (Floating-point constants).
pub const LARGEST: f64 = 1.701_411_834_604_692_3e38;

/// Smallest magnitude above zero: 2.93873588E-39 is 2^-128; less is zero without an error.
pub const SMALLEST: f64 = 2.938_735_877_055_719e-39;

/// Print zones: eight of ten columns on the 80-column line (PRINT).
pub const ZONE: usize = 10;

/// Columns of the logical line (PRINT).
pub const COLUMNS: usize = 80;
