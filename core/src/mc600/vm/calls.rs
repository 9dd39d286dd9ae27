//! Calls: what they order of the machine, and the few that need the program's own lines and arrays.

use std::rc::Rc;

use super::super::arrays::Array;
use super::super::code::Op;
use super::super::firmware::ErrorCode;
use super::super::interrupts::Interrupts;
use super::super::keywords::Keyword;
use super::super::motion_calls::{self, small};
use super::super::planner::cam::Table;
use super::super::planner::spline::{ENTRIES, LEAST_LAST, spline};
use super::super::value::to_integer;
use super::run::Flow;
use super::{Vm, World};

impl Vm {
    /// A motion, drive or I/O call. It is checked whole, then it acts.
    pub(super) fn motion_call(&mut self, op: Op, world: &mut World) -> Result<Flow, ErrorCode> {
        let argument = |at: u16| self.register(op.b.saturating_add(at));
        let arguments = [argument(0), argument(1), argument(2), argument(3)];
        let Some(keyword) = motion_calls::by_number(op.a) else {
            return Err(ErrorCode::Syntax);
        };
        match keyword {
            Keyword::Outw => world.machine.write_outputs(small(arguments[0], u8::MAX)?),
            Keyword::Sdowrite => {
                let [number, value] = [to_integer(arguments[0])?, to_integer(arguments[1])?];
                world.machine.write_object(number, value);
            }
            Keyword::Mspline => self.spline(op.b)?,
            Keyword::Intsetup => self.set_up_interrupt(arguments, world)?,
            Keyword::Intdisable => world.machine.interrupts.enable(false),
            Keyword::Intenable => {
                world.machine.interrupts.enable(true);
                // What was held back enters now, behind this statement.
                if world.machine.interrupts.is_pending() {
                    return Ok(Flow::Jump(self.interrupted(world)));
                }
            }
            Keyword::Mcam | Keyword::Mcamhard => {
                let table = self.table(op.b)?;
                world.machine.lay_table(table);
            }
            _ => {}
        }
        if let Some(command) = motion_calls::command(keyword, arguments)? {
            world.machine.command(command);
            if let Some(log) = world.log.as_deref_mut() {
                log.push(command);
            }
        }
        Ok(Flow::Next)
    }

    /// `intsetup(line,source,edge)`.
    fn set_up_interrupt(
        &mut self,
        arguments: [f64; motion_calls::ARGUMENTS],
        world: &mut World,
    ) -> Result<(), ErrorCode> {
        let source = Interrupts::source(to_integer(arguments[1])?)?;
        let edge = small(arguments[2], 3)?;
        let line = u16::try_from(to_integer(arguments[0])?).ok();
        let line = line.filter(|&line| edge == 0 || self.image.line_start(line).is_some());
        let line = match line {
            Some(line) => line,
            None if edge == 0 => 0,
            None => return Err(ErrorCode::UndefdStatement),
        };
        world.machine.set_up_interrupt(line, source, edge);
        Ok(())
    }

    /// The array whose number stands in a register.
    fn named_array(&self, register: u16) -> Result<&Array, ErrorCode> {
        let number = self.array_at(register);
        number
            .and_then(|number| self.array(number))
            .ok_or(ErrorCode::BadSubscript)
    }

    /// A cam table: an integer array of one dimension, as it stands now (D193).
    fn table(&self, register: u16) -> Result<Table, ErrorCode> {
        let array = self.named_array(register)?;
        array.table().map(Rc::clone).ok_or(ErrorCode::BadSubscript)
    }

    /// `mspline(xy%,np%,camtab%)`, arguments in registers from `first` on.
    fn spline(&mut self, first: u16) -> Result<(), ErrorCode> {
        let last = to_integer(self.register(first.saturating_add(1)))?;
        if last < LEAST_LAST {
            return Err(ErrorCode::IllegalQuantity);
        }
        let source = self.named_array(first)?;
        let pair = |row: i32| source.pair(usize::try_from(row).ok()?);
        let pairs: Option<Vec<(i32, i32)>> = (0..=last).map(pair).collect();
        let pairs = pairs.ok_or(ErrorCode::BadSubscript)?;
        let target = first.saturating_add(2);
        let room = self.table(target)?.len();
        if room < ENTRIES {
            return Err(ErrorCode::BadSubscript);
        }
        let table = spline(&pairs).ok_or(ErrorCode::IllegalQuantity)?;
        let target = self.array_at(target).ok_or(ErrorCode::BadSubscript)?;
        self.array_mut(target)?.fill(&table);
        Ok(())
    }
}
