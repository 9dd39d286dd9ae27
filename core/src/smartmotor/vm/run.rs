//! Dispatch: arithmetic and jumps here, everything else by a call.

use super::super::code::{Code, Exit, Op, REGISTERS};
use super::super::firmware::COST_UNIT;
use super::super::memory::{Registers, array, element, set_element};
use super::super::motor::Flag;
use super::{Calls, SPECIAL, Vm, World};
use crate::exec::Credit;
use std::rc::Rc;

/// Register `index`: registers are a power of two, so no index can fail.
macro_rules! register {
    ($registers:expr, $index:expr) => {
        $registers[usize::from($index) & (REGISTERS - 1)]
    };
}

/// How a slow operation went on.
pub(super) enum Flow {
    /// To the next operation.
    Next,
    /// Out of the interpreter, to this same operation again.
    Again(Exit),
    /// Out of the interpreter, to the next operation.
    Leave(Exit),
}

impl Vm {
    /// Runs the program, or the host's command, until the credit is used up or something else happens.
    pub fn run(&mut self, credit: &mut Credit, world: &mut World<'_>) -> Exit {
        let stream = match world.host {
            true => &self.host,
            false => &self.program,
        };
        let ops = Rc::clone(&stream.image.ops);
        self.run_ops(&ops, credit, world)
    }

    /// Runs another copy of the program: one with breakpoints in it.
    pub fn run_ops(&mut self, ops: &[Op], credit: &mut Credit, world: &mut World<'_>) -> Exit {
        let statements = credit.balance.saturating_add(COST_UNIT - 1) / COST_UNIT;
        let most = i32::try_from(statements).unwrap_or(i32::MAX);
        self.spend(ops, most, credit, world)
    }

    /// Runs one statement of a copy of the program.
    pub fn step(&mut self, ops: &[Op], credit: &mut Credit, world: &mut World<'_>) -> Exit {
        self.spend(ops, 1, credit, world)
    }

    /// Runs about so many statements and books what they cost.
    fn spend(
        &mut self,
        ops: &[Op],
        statements: i32,
        credit: &mut Credit,
        world: &mut World<'_>,
    ) -> Exit {
        let mut left = statements;
        let exit = self.dispatch(ops, &mut left, world);
        self.tell_overflow(world);
        let spent = i64::from(statements) - i64::from(left);
        credit.settle(credit.balance.saturating_sub(spent * COST_UNIT));
        exit
    }

    pub(super) fn tell_overflow(&mut self, world: &mut World<'_>) {
        if std::mem::take(&mut self.overflow) {
            world.motor.raise(Flag::MathOverflow);
        }
    }

    /// Runs operations until something happens that the hot loop cannot do itself.
    fn dispatch(&mut self, ops: &[Op], left: &mut i32, world: &mut World<'_>) -> Exit {
        let mut at = At {
            pc: match world.host {
                true => self.host.pc,
                false => self.program.pc,
            },
            credit: *left,
            overflow: false,
        };
        let exit = loop {
            let stop = hot(&mut self.registers, &mut self.calls, ops, &mut at);
            self.overflow |= std::mem::take(&mut at.overflow);
            match stop {
                Stop::Credit => break Exit::Credit,
                Stop::End => break Exit::End,
                Stop::Break => break Exit::Break,
                Stop::Raise(flag) => world.motor.raise(flag),
                Stop::ComeBack(back) => match self.come_back(back) {
                    Some(back) => at.pc = back,
                    None => break Exit::End,
                },
                Stop::Slow(op) => {
                    self.tell_overflow(world);
                    match self.slow(op, world) {
                        Flow::Next => at.credit -= i32::from(op.cost),
                        Flow::Again(exit) => {
                            at.pc -= 1;
                            break exit;
                        }
                        Flow::Leave(exit) => {
                            at.credit -= i32::from(op.cost);
                            break exit;
                        }
                    }
                }
            }
        };
        *left = at.credit;
        match world.host {
            true => self.host.pc = at.pc,
            false => self.program.pc = at.pc,
        }
        exit
    }
}

/// Where the hot loop is.
struct At {
    /// The next operation.
    pc: u32,
    /// Statements that may still run.
    credit: i32,
    /// A calculation has overflowed.
    overflow: bool,
}

/// Why the hot loop has ended. The operation is paid for, but for [`Stop::Slow`].
enum Stop {
    Credit,
    End,
    Break,
    /// Sets a bit of the status word and goes on.
    Raise(Flag),
    /// Returns to a place that is more than a place.
    ComeBack(u32),
    /// Does this operation.
    Slow(Op),
}

/// Arithmetic and jumps. A function of its own with no way to anything else, so that what it needs stays in machine
/// registers.
#[allow(clippy::indexing_slicing)] // masked to the registers' number, see `register!`
fn hot(r: &mut Registers, calls: &mut Calls, ops: &[Op], at: &mut At) -> Stop {
    let At {
        mut pc,
        mut credit,
        mut overflow,
    } = *at;
    // Its sign tells whether a sum or a difference has overflowed.
    let mut signs = 0;
    let stop = loop {
        if credit <= 0 {
            break Stop::Credit;
        }
        let Some(&op) = usize::try_from(pc).ok().and_then(|pc| ops.get(pc)) else {
            break Stop::End;
        };
        pc += 1;
        macro_rules! arithmetic {
            ($operation:ident) => {{
                let (value, over) = register!(r, op.a).$operation(register!(r, op.b));
                register!(r, op.c) = value;
                overflow |= over;
            }};
        }
        macro_rules! compare {
            ($relation:tt) => {
                register!(r, op.c) = i32::from(register!(r, op.a) $relation register!(r, op.b))
            };
        }
        macro_rules! jump_if {
            ($relation:tt) => {
                if register!(r, op.a) $relation register!(r, op.b) {
                    pc = u32::from(op.c);
                }
            };
        }
        credit -= i32::from(op.cost);
        match op.code {
            Code::Add => {
                let (a, b) = (register!(r, op.a), register!(r, op.b));
                let sum = a.wrapping_add(b);
                register!(r, op.c) = sum;
                signs |= (a ^ sum) & (b ^ sum);
            }
            Code::Subtract => {
                let (a, b) = (register!(r, op.a), register!(r, op.b));
                let difference = a.wrapping_sub(b);
                register!(r, op.c) = difference;
                signs |= (a ^ b) & (a ^ difference);
            }
            Code::Count => {
                let (count, number) = (register!(r, op.c), constant(op));
                let sum = count.wrapping_add(number);
                register!(r, op.c) = sum;
                signs |= (count ^ sum) & (number ^ sum);
            }
            Code::Multiply => arithmetic!(overflowing_mul),
            Code::Divide => match register!(r, op.b) {
                0 => {
                    register!(r, op.c) = 0;
                    overflow = true;
                }
                _ => arithmetic!(overflowing_div),
            },
            Code::And => register!(r, op.c) = register!(r, op.a) & register!(r, op.b),
            Code::Or => register!(r, op.c) = register!(r, op.a) | register!(r, op.b),
            Code::Equal => compare!(==),
            Code::NotEqual => compare!(!=),
            Code::Less => compare!(<),
            Code::LessEqual => compare!(<=),
            Code::Move => register!(r, op.c) = register!(r, op.a),
            Code::Constant => register!(r, op.c) = constant(op),
            Code::Jump => pc = u32::from(op.c),
            Code::JumpIfZero => {
                if register!(r, op.a) == 0 {
                    pc = u32::from(op.c);
                }
            }
            Code::JumpIfNotZero => {
                if register!(r, op.a) != 0 {
                    pc = u32::from(op.c);
                }
            }
            Code::JumpIfEqual => jump_if!(==),
            Code::JumpIfNotEqual => jump_if!(!=),
            Code::JumpIfLess => jump_if!(<),
            Code::JumpIfLessEqual => jump_if!(<=),
            Code::Gosub => match calls.push(pc) {
                true => pc = u32::from(op.c),
                false => break Stop::Raise(Flag::Syntax),
            },
            Code::Return => match calls.pop() {
                Some(back) if back & SPECIAL == 0 => pc = back,
                Some(back) => break Stop::ComeBack(back),
                None => break Stop::Raise(Flag::Syntax),
            },
            Code::Load => {
                let value = element(r, array(op.a), register!(r, op.b));
                register!(r, op.c) = value.unwrap_or(0);
                if value.is_none() {
                    break Stop::Raise(Flag::IndexRange);
                }
            }
            Code::Store => {
                let (index, value) = (register!(r, op.b), register!(r, op.c));
                if !set_element(r, array(op.a), index, value) {
                    break Stop::Raise(Flag::IndexRange);
                }
            }
            Code::Break => {
                pc -= 1;
                credit += i32::from(op.cost);
                break Stop::Break;
            }
            Code::Slow => {
                credit += i32::from(op.cost);
                break Stop::Slow(op);
            }
        }
    };
    *at = At {
        pc,
        credit,
        overflow: overflow || signs < 0,
    };
    stop
}

/// The number whose halves the operation holds.
#[inline(always)]
#[allow(clippy::cast_possible_wrap)] // the same bits
fn constant(op: Op) -> i32 {
    ((u32::from(op.a) << 16) | u32::from(op.b)) as i32
}
