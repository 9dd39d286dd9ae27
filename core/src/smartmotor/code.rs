//! Compiled programs: fixed-size operations on a file of 32-bit registers.
//!
//! Every operation carries a cost in statements. Operations in the middle of a statement cost nothing, the last one
//! costs 1 (a LOOP that tests its WHILE's condition at once costs both): so the interpreter's only hook is one counter, and a program can only be held between statements.

use std::collections::BTreeMap;
use std::rc::Rc;

use super::ast::{Array, LineCommand, LineFlag, Place, Source, Target, TextReport, VARIABLES};
use super::motor::{Command, Flag};

/// Registers: variables, temporaries, constants of the host's command, constants of the program. A power of two.
pub const REGISTERS: usize = 1024;
/// The first register of `aa`, where the arrays begin.
pub const ARRAYS: u16 = 26;
/// The first temporary; an expression needs no more than four.
pub const TEMPORARY: u16 = 80;
/// The first constant of the host's command.
pub const HOST_CONSTANTS: u16 = 96;
/// The first constant of the program; what finds no room is loaded by an operation of its own.
pub const PROGRAM_CONSTANTS: u16 = 352;

const _: () = assert!(VARIABLES <= TEMPORARY);

/// One operation. `a` and `b` are operands and `c` the result unless [`Code`] says otherwise.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Op {
    /// What it does.
    pub code: Code,
    /// In statements; zero within one.
    pub cost: u8,
    /// First operand.
    pub a: u16,
    /// Second operand.
    pub b: u16,
    /// Result, or the target of a jump.
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

    /// A conditional jump to `target` where this one stays; `None` if it is none.
    pub fn opposite(self, target: u16) -> Option<Op> {
        let (code, a, b) = match self.code {
            Code::JumpIfZero => (Code::JumpIfNotZero, self.a, self.b),
            Code::JumpIfNotZero => (Code::JumpIfZero, self.a, self.b),
            Code::JumpIfEqual => (Code::JumpIfNotEqual, self.a, self.b),
            Code::JumpIfNotEqual => (Code::JumpIfEqual, self.a, self.b),
            Code::JumpIfLess => (Code::JumpIfLessEqual, self.b, self.a),
            Code::JumpIfLessEqual => (Code::JumpIfLess, self.b, self.a),
            _ => return None,
        };
        Some(Op::new(code, a, b, target))
    }

    /// The operation as the statement says it: a LOOP that tests its WHILE's condition costs both, and goes behind the
    /// WHILE; taken apart it goes to the WHILE.
    pub fn apart(self) -> Op {
        match self.cost {
            LOOP_AND_WHILE => Op {
                cost: 1,
                ..Op::new(Code::Jump, 0, 0, self.c.saturating_sub(1))
            },
            _ => self,
        }
    }
}

/// What a LOOP costs that tests its WHILE's condition; nothing else costs as much.
pub const LOOP_AND_WHILE: u8 = 2;

/// What an operation does; `r` is a register.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[repr(u8)]
pub enum Code {
    /// `rc = ra + rb`, round the 32 bits; that sets Bd (D135)
    Add,
    /// `rc = ra - rb`
    Subtract,
    /// `rc = rc + the number whose halves are a and b`: counting is the commonest of all sums
    Count,
    /// `rc = ra * rb`
    Multiply,
    /// `rc = ra / rb`, toward zero; by zero it is 0 and sets Bd
    Divide,
    /// `rc = ra & rb`
    And,
    /// `rc = ra | rb`
    Or,
    /// `rc = ra == rb`: 1 or 0
    Equal,
    /// `!=`
    NotEqual,
    /// `<`
    Less,
    /// `<=`
    LessEqual,
    /// `rc = ra`
    Move,
    /// `rc = the number whose halves are a and b`
    Constant,
    /// Goes to `c`.
    Jump,
    /// Goes to `c` if `ra` is zero.
    JumpIfZero,
    /// Goes to `c` if `ra` is not zero.
    JumpIfNotZero,
    /// Goes to `c` if `ra == rb`.
    JumpIfEqual,
    /// Goes to `c` if `ra != rb`.
    JumpIfNotEqual,
    /// Goes to `c` if `ra < rb`.
    JumpIfLess,
    /// Goes to `c` if `ra <= rb`.
    JumpIfLessEqual,
    /// Calls `c`.
    Gosub,
    /// Returns.
    Return,
    /// `rc = element rb of array a`; an index out of range sets Bu
    Load,
    /// `element rb of array a = rc`
    Store,
    /// What is not on the hot path: [`Slow`] number `a`, with registers `b` and `c`.
    Slow,
    /// A breakpoint stands before the operation here.
    Break,
}

/// Operations that are not worth a place in the hot loop.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Slow {
    /// `rc = source`
    Get(Source),
    /// `target = rb`
    Set(Target),
    /// Stores numbers in sequence from element `rb` on.
    Fill(Array, Rc<[i32]>),
    /// An order for the motor.
    Motor(Command),
    /// Clears a bit of the serial line.
    ClearLine(LineFlag),
    /// Composes a text.
    PrintText(Rc<[u8]>),
    /// Composes `rb` in digits.
    PrintNumber,
    /// Composes the byte `rb`.
    PrintByte,
    /// Sends what is composed by a channel.
    PrintEnd(u8),
    /// Sends `rb` in digits and a CR.
    Report,
    /// Sends another report and a CR.
    ReportText(TextReport),
    /// Waits `rb` samples.
    Wait,
    /// Waits for the end of the trajectory.
    WaitForTrajectory,
    /// Waits for a character.
    Pause,
    /// Forgets all calls.
    Stack,
    /// Variables from a place on, `rb` of them, to the EEPROM.
    Save(Place),
    /// The same from the EEPROM.
    Restore(Place),
    /// An order for the serial line.
    Line(LineCommand),
    /// Sets a bit of the status word.
    Raise(Flag),
    /// Ends the program if RUN was not given.
    RunIfAsked,
    /// Ends the program.
    End,
    /// What only the firmware around the interpreter can do.
    System(System),
    /// Nothing but a statement's time.
    Nothing,
}

/// What only the firmware around the interpreter can do.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum System {
    /// `RUN`
    Run,
    /// `Z`, `RESET`
    Reset,
    /// `END` from the host
    Stop,
    /// `GOTO` from the host
    Goto(u16),
    /// `GOSUB` from the host
    Gosub(u16),
    /// `LOAD`
    Load,
    /// `UPLOAD`, `UP`
    Upload {
        /// `UP`
        compiled: bool,
    },
}

/// A compiled program, or the host's command.
#[derive(Debug, Clone, Default)]
pub struct Image {
    /// Its operations.
    pub ops: Rc<Vec<Op>>,
    /// Those that are not on the hot path, by number.
    pub slow: Rc<Vec<Slow>>,
    /// The first operation of each line, from line 1 on.
    pub lines: Rc<Vec<u32>>,
    /// Where the labels are.
    pub labels: Rc<BTreeMap<u16, u32>>,
    /// The values of its constants' registers.
    pub constants: Rc<Vec<i32>>,
}

impl Image {
    /// The line that operation `pc` belongs to, from 1.
    pub fn line_at(&self, pc: u32) -> Option<u32> {
        let line = self.lines.partition_point(|&first| first <= pc);
        u32::try_from(line).ok().filter(|&line| line > 0)
    }

    /// The first operation of a line.
    pub fn line_start(&self, line: u32) -> Option<u32> {
        let index = usize::try_from(line).ok()?.checked_sub(1)?;
        self.lines.get(index).copied()
    }
}

/// Why the interpreter gave control back.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Exit {
    /// The credit is used up.
    Credit,
    /// A statement waits.
    Wait(crate::exec::Wait),
    /// END, or the last operation was passed.
    End,
    /// A breakpoint.
    Break,
    /// The firmware is asked for something.
    System(System),
}
