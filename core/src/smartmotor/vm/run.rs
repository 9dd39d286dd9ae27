//! Dispatch: arithmetic and jumps here, everything else by a call.

use super::super::code::{Code, Exit, Op, REGISTERS};
use super::super::firmware::COST_UNIT;
use super::super::memory::{array, element, set_element};
use super::super::motor::Flag;
use super::{SPECIAL, Vm, World};
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

    #[allow(clippy::indexing_slicing)] // masked to the registers' number, see `register!`
    fn dispatch(&mut self, ops: &[Op], left: &mut i32, world: &mut World<'_>) -> Exit {
        // Locals, so that they stay in machine registers.
        let mut pc = match world.host {
            true => self.host.pc,
            false => self.program.pc,
        };
        let mut credit = *left;
        let mut overflow = false;
        let exit = loop {
            if credit <= 0 {
                break Exit::Credit;
            }
            let Some(&op) = usize::try_from(pc).ok().and_then(|pc| ops.get(pc)) else {
                break Exit::End;
            };
            pc += 1;
            let r = &mut *self.registers;
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
            match op.code {
                Code::Add => arithmetic!(overflowing_add),
                Code::Subtract => arithmetic!(overflowing_sub),
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
                Code::Gosub => match self.calls.push(pc) {
                    true => pc = u32::from(op.c),
                    false => world.motor.raise(Flag::Syntax),
                },
                Code::Return => match self.calls.pop() {
                    Some(back) if back & SPECIAL == 0 => pc = back,
                    Some(back) => match self.come_back(back) {
                        Some(back) => pc = back,
                        None => break Exit::End,
                    },
                    None => world.motor.raise(Flag::Syntax),
                },
                Code::Load => {
                    let value = element(r, array(op.a), register!(r, op.b));
                    register!(r, op.c) = value.unwrap_or_else(|| {
                        world.motor.raise(Flag::IndexRange);
                        0
                    });
                }
                Code::Store => {
                    let (index, value) = (register!(r, op.b), register!(r, op.c));
                    if !set_element(r, array(op.a), index, value) {
                        world.motor.raise(Flag::IndexRange);
                    }
                }
                Code::Break => {
                    pc -= 1;
                    break Exit::Break;
                }
                Code::Slow => {
                    self.overflow |= overflow;
                    self.tell_overflow(world);
                    overflow = false;
                    match self.slow(op, world) {
                        Flow::Next => {}
                        Flow::Again(exit) => {
                            pc -= 1;
                            break exit;
                        }
                        Flow::Leave(exit) => {
                            credit -= i32::from(op.cost);
                            break exit;
                        }
                    }
                }
            }
            credit -= i32::from(op.cost);
        };
        self.overflow |= overflow;
        *left = credit;
        match world.host {
            true => self.host.pc = pc,
            false => self.program.pc = pc,
        }
        exit
    }
}

/// The number whose halves the operation holds.
#[inline(always)]
#[allow(clippy::cast_possible_wrap)] // the same bits
fn constant(op: Op) -> i32 {
    ((u32::from(op.a) << 16) | u32::from(op.b)) as i32
}
