//! Compiled MotionBasic: fixed-size operations on a file of numeric registers and a file of strings.
//!
//! Every operation carries a cost in units of firmware time. Operations in the middle of a statement cost nothing, the
//! last one costs the whole statement: so the interpreter's only hook is one counter that every operation lowers, and a
//! program can only be held between statements.

use std::rc::Rc;

use super::ast::DataItem;
use super::firmware::ErrorCode;
use super::sysvars::SysVar;

/// Numeric registers: temporaries, then constants and simple variables as they are met (D28). A power of two.
pub const REGISTERS: usize = 8192;
/// The first registers are temporaries of expressions; no expression needs more than the nesting limit allows.
pub const TEMPORARIES: u16 = 256;
/// The first strings are temporaries, likewise.
pub const STRING_TEMPORARIES: u16 = 64;
/// One operation. `a` and `b` are operands and `c` the result unless [`Code`] says otherwise; `b` and `c` together
/// hold jump targets.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Op {
    /// What it does.
    pub code: Code,
    /// In units of [`super::firmware::COST_UNIT`]; zero within a statement.
    pub cost: u8,
    /// First operand.
    pub a: u16,
    /// Second operand.
    pub b: u16,
    /// Result.
    pub c: u16,
}

impl Op {
    /// An operation that costs nothing yet.
    pub fn new(code: Code, a: u16, b: u16, c: u16) -> Op {
        Op {
            code,
            cost: 0,
            a,
            b,
            c,
        }
    }

    /// An operation with a jump target.
    pub fn jump(code: Code, a: u16, target: u32) -> Op {
        let mut op = Op::new(code, a, 0, 0);
        op.set_target(target);
        op
    }

    /// The target of a jump.
    #[inline(always)]
    pub fn target(self) -> u32 {
        (u32::from(self.b) << 16) | u32::from(self.c)
    }

    /// Sets the target of a jump.
    #[allow(clippy::cast_possible_truncation)] // the two halves
    pub fn set_target(&mut self, target: u32) {
        self.b = (target >> 16) as u16;
        self.c = target as u16;
    }
}

/// What an operation does. `r` is a numeric register, `s` a string.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[repr(u8)]
pub enum Code {
    /// `rc = ra + rb`
    Add,
    /// `rc = ra - rb`
    Subtract,
    /// `rc = ra * rb`
    Multiply,
    /// `rc = ra / rb`
    Divide,
    /// `rc = ra ^ rb`
    Power,
    /// `rc = -ra`
    Negate,
    /// `rc = ra`
    Move,
    /// `rc = floor(ra)`, within 32 bits
    ToInteger,
    /// `rc = floor(ra + rb)`, within 32 bits
    AddInteger,
    /// `rc = ra = rb` and so on: -1 or 0
    Equal,
    /// `<>`
    NotEqual,
    /// `<`
    Less,
    /// `<=`
    LessEqual,
    /// `rc = ra AND rb` on 32 bits
    And,
    /// `OR`
    Or,
    /// `XOR`
    Xor,
    /// `rc = NOT ra`
    Not,
    /// Goes to the target.
    Jump,
    /// Goes on behind the next operation if `ra` is not zero; that one jumps elsewhere.
    When,
    /// The same if `ra = rb`.
    WhenEqual,
    /// `<>`
    WhenNotEqual,
    /// `<`
    WhenLess,
    /// `<=`
    WhenLessEqual,
    /// Starts a FOR loop with variable `ra`, limit `rb`, step `rc`; the body follows.
    For,
    /// The same with an integer variable.
    ForInteger,
    /// Ends a repetition of the loop with variable `ra` ([`ANY`]: the innermost).
    Next,
    /// Calls the target.
    Gosub,
    /// Returns.
    Return,
    /// `rc = array a (rb)`, one subscript
    LoadAt,
    /// `array a (rb) = rc`, one subscript
    StoreAt,
    /// `rc = array a (linear index rb)`
    Load,
    /// `array a (linear index rb) = rc`
    Store,
    /// `rc = linear index of array a with one subscript rb`
    Index1,
    /// Says how many subscripts the [`Code::Index`] that follows has: `a`
    Subscripts,
    /// `rc = linear index of array a`, subscripts in registers from `b`
    Index,
    /// `rc = INT(ra)`
    Floor,
    /// `rc = SQRT(ra)`
    SquareRoot,
    /// Does nothing but end a statement.
    Nothing,

    // What follows is not on the hot path.
    /// ON: takes entry `ra` of the table of `b` entries that follows, or goes on behind it.
    On,
    /// One entry of ON's table, a GOTO.
    OnGoto,
    /// One entry of ON's table, a GOSUB.
    OnGosub,
    /// Raises [`ErrorCode`] number `a`.
    Raise,
    /// `rc = function a (rb)`: see `functions.rs`
    Function,
    /// `rc = MOD(ra, rb)`
    Modulo,
    /// Remembers that `ra` is not a 32-bit integer, for the next number printed.
    CheckInteger,
    /// `rc = system variable a`
    GetSystem,
    /// `system variable a = rb`
    SetSystem,
    /// Motion call `a` with its arguments in registers from `b`
    Motion,

    /// `DIM` of array `a`, `c` sizes in registers from `b`
    Dim,

    /// `sc = sa`
    StringMove,
    /// `sc = sc + sa`
    StringAppend,
    /// `sc = element rb of array a`
    StringLoad,
    /// `element rb of array a = sc`
    StringStore,
    /// `rc = sa = sb` and so on
    StringEqual,
    /// `<>`
    StringNotEqual,
    /// `<`
    StringLess,
    /// `<=`
    StringLessEqual,
    /// `sc = CHR$(ra)`
    Chr,
    /// `sc = STR$(ra)`; `b` is 1 for an integer-typed value
    Str,
    /// `sc = LEFT$(sa, rb)`
    Left,
    /// `sc = RIGHT$(sa, rb)`
    Right,
    /// `sc = MID$(sa, rb)`
    MidRest,
    /// `sc = MID$(sa, rb, rb+1)`
    Mid,
    /// `rc = LEN(sa)`
    Len,
    /// `rc = ASC(sa)`
    Asc,
    /// `rc = VAL(sa)`
    Val,

    /// Prints `ra`; `b` is 1 for an integer-typed value
    PrintNumber,
    /// Prints `sa`
    PrintString,
    /// Moves to the next zone
    PrintComma,
    /// `TAB(ra)`
    PrintTab,
    /// `SPC(ra)`
    PrintSpaces,
    /// Ends the printed line
    PrintEnd,

    /// Prints prompt `sa` (or none: [`ANY`]) and `? `, waits for a line; a blank line goes to the target
    Input,
    /// `rc = next field of the line`
    InputNumber,
    /// `sc = next field of the line`
    InputString,
    /// Tells whether fields were left over
    InputEnd,
    /// `rc = next DATA item`
    ReadNumber,
    /// `sc = next DATA item`
    ReadString,
    /// Back to the first DATA item
    Restore,

    /// Ends the program or the direct line
    End,
    /// Ends the program with a message
    Stop,
    /// Hands over to the firmware: see [`SystemCall`]; `a` is its number, `b` and `c` its operands
    System,
    /// Returns from an interrupt
    ReturnFromInterrupt,
    /// A breakpoint stands before the operation here
    Break,
}

/// No register, no string.
pub const ANY: u16 = u16::MAX;

/// What only the firmware around the interpreter can do.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SystemCall {
    /// Clears program and variables.
    New,
    /// Lists lines `b` to `c`.
    List,
    /// Starts at the first line.
    Run,
    /// Starts at line `b`.
    RunLine,
    /// Starts at the line whose number is in `rb`.
    RunAt,
    /// Loads file `sb` and starts it at its first line.
    RunFile,
    /// Loads file `sb` and starts it at line `c`.
    RunFileLine,
    /// Goes on where the program stopped.
    Cont,
    /// Deletes lines `b` to `c`.
    Del,
    /// Renumbers from `b` by `c`.
    Renum,
    /// Offers line numbers from `b` by `c`.
    Auto,
    /// Lists the files that match `sb` (or all on the default disk: [`ANY`]).
    Files,
    /// Saves as `sb` (or the name last used: [`ANY`]).
    Save,
    /// Loads `sb`.
    Load,
    /// Adds the lines of `sb` to the program.
    Merge,
    /// Copies `sb` to `sc`.
    Copy,
    /// Erases the files that match `sb`.
    Erase,
    /// Empties disk `sb`.
    Format,
    /// Asks for the old password and a new one.
    Password,
}

impl SystemCall {
    const ALL: [SystemCall; 19] = [
        SystemCall::New,
        SystemCall::List,
        SystemCall::Run,
        SystemCall::RunLine,
        SystemCall::RunAt,
        SystemCall::RunFile,
        SystemCall::RunFileLine,
        SystemCall::Cont,
        SystemCall::Del,
        SystemCall::Renum,
        SystemCall::Auto,
        SystemCall::Files,
        SystemCall::Save,
        SystemCall::Load,
        SystemCall::Merge,
        SystemCall::Copy,
        SystemCall::Erase,
        SystemCall::Format,
        SystemCall::Password,
    ];

    /// The call that `call as u16` came from.
    pub fn from_number(number: u16) -> SystemCall {
        SystemCall::ALL
            .get(usize::from(number))
            .copied()
            .unwrap_or(SystemCall::New)
    }
}

/// A program compiled as a whole, with the direct line that runs now behind it.
#[derive(Debug, Clone, Default)]
pub struct Image {
    /// The program's operations, then the direct line's.
    pub ops: Rc<Vec<Op>>,
    /// How many of them are the program's.
    pub program_ops: u32,
    /// First operation of each program line, in order.
    pub lines: Rc<Vec<(u16, u32)>>,
    /// All DATA of the program with the line they stand on.
    pub data: Rc<Vec<(u16, DataItem)>>,
    /// System variables by the numbers that operations use.
    pub sysvars: Vec<SysVar>,
}

impl Image {
    /// The line that operation `pc` belongs to; `None` in the direct line.
    pub fn line_at(&self, pc: u32) -> Option<u16> {
        if pc >= self.program_ops {
            return None;
        }
        let after = self.lines.partition_point(|&(_, first)| first <= pc);
        Some(self.lines.get(after.checked_sub(1)?)?.0)
    }

    /// The first operation of a line.
    pub fn line_start(&self, number: u16) -> Option<u32> {
        let at = self
            .lines
            .binary_search_by_key(&number, |&(line, _)| line)
            .ok()?;
        self.lines.get(at).map(|&(_, first)| first)
    }
}

/// Why the interpreter gave control back.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Exit {
    /// The credit is used up.
    Credit,
    /// Waits for the console.
    Wait(crate::exec::Wait),
    /// END, or the last line was passed.
    End,
    /// STOP.
    Stop,
    /// A breakpoint.
    Break,
    /// An error; for READ the line of the DATA that does not fit.
    Error(ErrorCode, Option<u16>),
    /// The firmware is asked for something; the operation is named by its place.
    System(SystemCall, Op),
}
