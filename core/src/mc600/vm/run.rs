//! Dispatch: numeric work and jumps here, everything else by a call.

use super::super::ast::Function;
use super::super::code::{Code, Exit, Op, REGISTERS, SystemCall};
use super::super::firmware::{COST_UNIT, ErrorCode};
use super::super::functions;
use super::super::value::{floor_in_range, in_range, is_integer, to_integer};
use super::{Vm, World};
use crate::exec::{Credit, Wait};
use std::rc::Rc;

/// Register `index`: registers are a power of two, so no index can fail.
macro_rules! register {
    ($registers:expr, $index:expr) => {
        $registers[usize::from($index) & (REGISTERS - 1)]
    };
}

/// What a comparison yields.
fn truth(holds: bool) -> f64 {
    if holds { -1.0 } else { 0.0 }
}

/// How a slow operation went on.
pub(super) enum Flow {
    /// To the next operation.
    Next,
    /// Elsewhere.
    Jump(u32),
    /// Out of the interpreter, to this same operation again.
    Again(Exit),
    /// Out of the interpreter, to the next operation.
    Leave(Exit),
}

impl Vm {
    /// Runs until the credit is used up or something else happens. The credit is taken down as statements end.
    pub fn run(&mut self, credit: &mut Credit, world: &mut World) -> Exit {
        let ops = Rc::clone(&self.image.ops);
        self.run_ops(&ops, credit, world)
    }

    /// Runs another copy of the program: one with breakpoints in it.
    pub fn run_ops(&mut self, ops: &[Op], credit: &mut Credit, world: &mut World) -> Exit {
        if !self.drain(world.console) {
            return Exit::Wait(Wait::Output);
        }
        let mut left = credit.balance;
        let exit = self.dispatch(ops, &mut left, world);
        credit.settle(left);
        self.note_place(exit, left);
        exit
    }

    /// Runs one statement.
    pub fn step(&mut self, credit: &mut Credit, world: &mut World) -> Exit {
        if !self.drain(world.console) {
            return Exit::Wait(Wait::Output);
        }
        let ops = Rc::clone(&self.image.ops);
        let before = credit.balance.saturating_sub(1);
        let mut left = 1;
        let exit = self.dispatch(&ops, &mut left, world);
        credit.settle(before.saturating_add(left));
        self.note_place(exit, left);
        exit
    }

    /// Only what waits with credit left is in the middle of its statement.
    fn note_place(&mut self, exit: Exit, left: i64) {
        self.between_statements = left <= 0 || !matches!(exit, Exit::Wait(_));
    }

    #[allow(clippy::indexing_slicing)] // masked to the registers' number, see `register!`
    fn dispatch(&mut self, ops: &[Op], left: &mut i64, world: &mut World) -> Exit {
        macro_rules! attempt {
            ($result:expr) => {
                match $result {
                    Ok(value) => value,
                    Err(error) => return self.fail(error),
                }
            };
        }
        // Locals, so that they stay in machine registers.
        let mut pc = self.pc;
        let mut credit = *left;
        while credit > 0 {
            let Some(op) = usize::try_from(pc).ok().and_then(|pc| ops.get(pc)) else {
                (self.pc, *left) = (pc, credit);
                return Exit::End;
            };
            pc += 1;
            let r = &mut self.registers;
            // Where an operation can fail, `pc` is stored first: the error names the statement's line.
            macro_rules! arithmetic {
                ($result:expr) => {{
                    match in_range($result) {
                        Ok(value) => register!(r, op.c) = value,
                        Err(error) => {
                            (self.pc, *left) = (pc, credit);
                            return self.fail(error);
                        }
                    }
                }};
            }
            macro_rules! whole {
                ($value:expr) => {{
                    match floor_in_range($value) {
                        Ok(value) => register!(r, op.c) = value,
                        Err(error) => {
                            (self.pc, *left) = (pc, credit);
                            return self.fail(error);
                        }
                    }
                }};
            }
            macro_rules! integers {
                ($operation:expr) => {{
                    let (a, b) = (
                        to_integer(register!(r, op.a)),
                        to_integer(register!(r, op.b)),
                    );
                    match (a, b) {
                        (Ok(a), Ok(b)) => register!(r, op.c) = f64::from($operation(a, b)),
                        _ => {
                            (self.pc, *left) = (pc, credit);
                            return self.fail(ErrorCode::IllegalQuantity);
                        }
                    }
                }};
            }
            // The jump that follows is taken at once: time is spent at the end of a statement, not within.
            macro_rules! when {
                ($holds:expr) => {{
                    if $holds {
                        pc += 1;
                    } else if let Some(jump) = usize::try_from(pc).ok().and_then(|pc| ops.get(pc))
                        && jump.code == Code::Jump
                    {
                        pc = jump.target();
                    }
                }};
            }
            match op.code {
                Code::Add => arithmetic!(register!(r, op.a) + register!(r, op.b)),
                Code::Subtract => arithmetic!(register!(r, op.a) - register!(r, op.b)),
                Code::Multiply => arithmetic!(register!(r, op.a) * register!(r, op.b)),
                Code::Divide => {
                    let divisor = register!(r, op.b);
                    if divisor == 0.0 {
                        (self.pc, *left) = (pc, credit);
                        return self.fail(ErrorCode::DivisionByZero);
                    }
                    arithmetic!(register!(r, op.a) / divisor);
                }
                Code::Negate => register!(r, op.c) = -register!(r, op.a),
                Code::Move => register!(r, op.c) = register!(r, op.a),
                Code::ToInteger => whole!(register!(r, op.a)),
                Code::AddInteger => whole!(register!(r, op.a) + register!(r, op.b)),
                Code::Equal => register!(r, op.c) = truth(register!(r, op.a) == register!(r, op.b)),
                Code::NotEqual => {
                    register!(r, op.c) = truth(register!(r, op.a) != register!(r, op.b))
                }
                Code::Less => register!(r, op.c) = truth(register!(r, op.a) < register!(r, op.b)),
                Code::LessEqual => {
                    register!(r, op.c) = truth(register!(r, op.a) <= register!(r, op.b))
                }
                Code::And => integers!(|a: i32, b: i32| a & b),
                Code::Or => integers!(|a: i32, b: i32| a | b),
                Code::Xor => integers!(|a: i32, b: i32| a ^ b),
                Code::Jump => pc = op.target(),
                Code::When => when!(register!(r, op.a) != 0.0),
                Code::WhenEqual => when!(register!(r, op.a) == register!(r, op.b)),
                Code::WhenNotEqual => when!(register!(r, op.a) != register!(r, op.b)),
                Code::WhenLess => when!(register!(r, op.a) < register!(r, op.b)),
                Code::WhenLessEqual => when!(register!(r, op.a) <= register!(r, op.b)),
                Code::Next => {
                    (self.pc, *left) = (pc, credit);
                    pc = attempt!(self.next(op.a, pc));
                }
                Code::Gosub => {
                    (self.pc, *left) = (pc, credit);
                    pc = attempt!(self.gosub(op.target(), pc));
                }
                Code::Return => {
                    (self.pc, *left) = (pc, credit);
                    pc = attempt!(self.give_back());
                }
                Code::Index1 => {
                    let at = register!(r, op.b);
                    let index = self
                        .arrays
                        .get(usize::from(op.a))
                        .and_then(|array| array.index1(at));
                    match index {
                        Some(index) => register!(r, op.c) = index,
                        None => {
                            (self.pc, *left) = (pc, credit);
                            let index = attempt!(self.index(op.a, &[at]));
                            self.set_register(op.c, index);
                        }
                    }
                }
                Code::LoadAt => {
                    let at = register!(r, op.b);
                    let array = self.arrays.get(usize::from(op.a));
                    match array.and_then(|array| array.number_at(at)) {
                        Some(value) => register!(r, op.c) = value,
                        None => {
                            (self.pc, *left) = (pc, credit);
                            attempt!(self.load_at(*op));
                        }
                    }
                }
                Code::StoreAt => {
                    let (at, value) = (register!(r, op.b), register!(r, op.c));
                    let array = self.arrays.get_mut(usize::from(op.a));
                    if array.is_none_or(|array| !array.set_number_at(at, value)) {
                        (self.pc, *left) = (pc, credit);
                        attempt!(self.store_at(*op));
                    }
                }
                Code::Floor => register!(r, op.c) = register!(r, op.a).floor(),
                Code::SquareRoot => match functions::square_root(register!(r, op.a)) {
                    Ok(root) => register!(r, op.c) = root,
                    Err(error) => {
                        (self.pc, *left) = (pc, credit);
                        return self.fail(error);
                    }
                },
                Code::Function => {
                    (self.pc, *left) = (pc, credit);
                    let value = attempt!(self.function(*op, world));
                    self.set_register(op.c, value);
                }
                Code::Load => {
                    let array = self.arrays.get(usize::from(op.a));
                    register!(r, op.c) = array
                        .and_then(|array| array.number(register!(r, op.b)))
                        .unwrap_or_default();
                }
                Code::Store => {
                    if let Some(array) = self.arrays.get_mut(usize::from(op.a))
                        && let Err(error) = array.set_number(register!(r, op.b), register!(r, op.c))
                    {
                        (self.pc, *left) = (pc, credit);
                        return self.fail(error);
                    }
                }
                Code::StringMove
                | Code::StringAppend
                | Code::StringLoad
                | Code::StringStore
                | Code::StringEqual
                | Code::StringNotEqual
                | Code::StringLess
                | Code::StringLessEqual
                | Code::Chr
                | Code::Str
                | Code::Left
                | Code::Right
                | Code::MidRest
                | Code::Mid
                | Code::Len
                | Code::Asc
                | Code::Val => {
                    (self.pc, *left) = (pc, credit);
                    attempt!(self.text(*op));
                }
                Code::Nothing => {}
                _ => {
                    (self.pc, *left) = (pc, credit);
                    match attempt!(self.slow(*op, ops, world)) {
                        Flow::Next => {}
                        Flow::Jump(target) => pc = target,
                        Flow::Again(exit) => {
                            self.pc = pc - 1;
                            return exit;
                        }
                        Flow::Leave(exit) => {
                            *left = credit - i64::from(op.cost) * COST_UNIT;
                            return exit;
                        }
                    }
                }
            }
            credit -= i64::from(op.cost) * COST_UNIT;
        }
        (self.pc, *left) = (pc, credit);
        if self.is_printing() {
            Exit::Wait(Wait::Output)
        } else {
            Exit::Credit
        }
    }

    /// Operations that are not worth a place in the hot loop.
    #[inline(never)]
    fn slow(&mut self, op: Op, ops: &[Op], world: &mut World) -> Result<Flow, ErrorCode> {
        match op.code {
            Code::For | Code::ForInteger => self.enter_loop(op)?,
            Code::On => return self.on(op, ops),
            Code::Raise => return Err(ErrorCode::from_number(op.a)),
            Code::End => return Ok(Flow::Again(Exit::End)),
            Code::Stop => return Ok(Flow::Leave(Exit::Stop)),
            Code::Break => return Ok(Flow::Again(Exit::Break)),
            Code::System => {
                return Ok(Flow::Leave(Exit::System(SystemCall::from_number(op.a), op)));
            }
            Code::Power => {
                let power = functions::power(self.register(op.a), self.register(op.b))?;
                self.set_register(op.c, power);
            }
            Code::Not => {
                let value = !to_integer(self.register(op.a))?;
                self.set_register(op.c, f64::from(value));
            }
            Code::Modulo => {
                let (a, b) = (
                    to_integer(self.register(op.a))?,
                    to_integer(self.register(op.b))?,
                );
                let value = if b == 0 {
                    return Err(ErrorCode::DivisionByZero);
                } else {
                    a.wrapping_rem(b)
                };
                self.set_register(op.c, f64::from(value));
            }
            Code::CheckInteger => self.left_integers |= !is_integer(self.register(op.a)),
            Code::GetSystem => {
                let value = self
                    .image
                    .sysvars
                    .get(usize::from(op.a))
                    .map_or(0, |&var| world.machine.get(var));
                self.set_register(op.c, f64::from(value));
            }
            Code::SetSystem => {
                let value = to_integer(self.register(op.b))?;
                if let Some(&var) = self.image.sysvars.get(usize::from(op.a)) {
                    world.machine.set(var, value);
                }
            }
            Code::Motion => return self.motion_call(op, world),
            Code::ReturnFromInterrupt => return self.return_from_interrupt(world).map(Flow::Jump),
            Code::Dim => {
                let sizes = self.consecutive(op.b, op.c);
                let room = self.room();
                self.array_mut(op.a)?.dimension(&sizes, room)?;
            }
            Code::Subscripts => self.subscripts = op.a,
            Code::Index => {
                let subscripts = self.consecutive(op.b, self.subscripts);
                let index = self.index(op.a, &subscripts)?;
                self.set_register(op.c, index);
            }
            _ => return self.console_operation(op, world),
        }
        Ok(Flow::Next)
    }

    fn fail(&mut self, error: ErrorCode) -> Exit {
        // The place of the statement that failed, for the message's line.
        self.pc = self.pc.saturating_sub(1);
        self.give_up();
        Exit::Error(error, None)
    }

    /// What [`Code::LoadAt`] does when the quick way does not serve: the array is not dimensioned, or not like this.
    #[cold]
    fn load_at(&mut self, op: Op) -> Result<(), ErrorCode> {
        let index = self.index(op.a, &[self.register(op.b)])?;
        let value = self.array(op.a).and_then(|array| array.number(index));
        self.set_register(op.c, value.unwrap_or_default());
        Ok(())
    }

    /// What [`Code::StoreAt`] does then.
    #[cold]
    fn store_at(&mut self, op: Op) -> Result<(), ErrorCode> {
        let index = self.index(op.a, &[self.register(op.b)])?;
        let value = self.register(op.c);
        self.array_mut(op.a)?.set_number(index, value)
    }

    fn index(&mut self, array: u16, subscripts: &[f64]) -> Result<f64, ErrorCode> {
        let room = self.room();
        self.array_mut(array)?.index(subscripts, room)
    }

    /// The values of `count` registers from `first` on.
    fn consecutive(&self, first: u16, count: u16) -> smallvec::SmallVec<[f64; 4]> {
        (0..count)
            .map(|offset| self.register(first.saturating_add(offset)))
            .collect()
    }

    fn function(&mut self, op: Op, world: &mut World) -> Result<f64, ErrorCode> {
        let argument = self.register(op.b);
        match functions::by_number(op.a) {
            Some(Function::Sdoerror) => Ok(f64::from(world.machine.object_error())),
            Some(Function::Sdoread) => {
                let number = to_integer(argument)?;
                Ok(f64::from(world.machine.read_object(number)))
            }
            Some(Function::CanData) => {
                let mailbox = usize::try_from(to_integer(argument)?).ok();
                let data = mailbox.and_then(|number| world.machine.mailbox(number));
                data.map(f64::from).ok_or(ErrorCode::BadSubscript)
            }
            Some(Function::Insta) => Ok(f64::from(world.machine.inputs())),
            Some(Function::Outsta) => Ok(f64::from(world.machine.outputs())),
            Some(Function::Rnd) => {
                // As on a Commodore (D19): negative starts a series, zero takes the clock, positive goes on.
                if argument < 0.0 {
                    self.random = argument.to_bits() | 1;
                } else if argument == 0.0 {
                    self.random = world.samples.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1;
                }
                Ok(self.next_random())
            }
            Some(function) => functions::pure(function, argument),
            None => Err(ErrorCode::Syntax),
        }
    }

    fn on(&mut self, op: Op, ops: &[Op]) -> Result<Flow, ErrorCode> {
        let choice = to_integer(self.register(op.a))?;
        let behind = self.pc.saturating_add(u32::from(op.b));
        let Ok(choice) = u32::try_from(choice) else {
            return Err(ErrorCode::IllegalQuantity);
        };
        if choice == 0 || choice > u32::from(op.b) {
            return Ok(Flow::Jump(behind));
        }
        let entry = usize::try_from(self.pc.saturating_add(choice - 1))
            .ok()
            .and_then(|entry| ops.get(entry));
        match entry {
            Some(entry) if entry.code == Code::OnGoto => Ok(Flow::Jump(entry.target())),
            Some(entry) if entry.code == Code::OnGosub => {
                self.gosub(entry.target(), behind).map(Flow::Jump)
            }
            _ => Err(ErrorCode::UndefdStatement),
        }
    }
}
