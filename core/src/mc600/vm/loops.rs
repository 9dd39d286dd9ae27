//! FOR and GOSUB: one stack, as in Microsoft BASIC, so that RETURN closes the loops of its subroutine.

use super::super::code::{ANY, Code, Op};
use super::super::firmware::{ErrorCode, FOR_LEVELS, GOSUB_LEVELS};
use super::super::value::{floor_in_range, in_range};
use super::Vm;

/// A loop or a call that is open.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Frame {
    /// FOR.
    For {
        /// The variable's register.
        variable: u16,
        /// The variable is an integer.
        integer: bool,
        /// The last value.
        limit: f64,
        /// The increment.
        step: f64,
        /// The first operation of the body.
        body: u32,
    },
    /// GOSUB, or an interrupt.
    Gosub {
        /// Where RETURN or RETI goes.
        back: u32,
    },
}

impl Frame {
    /// The operation that it goes back to.
    pub fn place(&self) -> u32 {
        match *self {
            Frame::For { body, .. } => body,
            Frame::Gosub { back } => back,
        }
    }
}

impl Vm {
    /// NEXT: one step of the loop with this variable ([`ANY`]: the innermost); gives the next operation.
    #[inline(always)]
    pub(super) fn next(&mut self, variable: u16, behind: u32) -> Result<u32, ErrorCode> {
        match self.frames.last() {
            Some(&Frame::For {
                variable: innermost,
                integer,
                limit,
                step,
                body,
            }) if variable == innermost || variable == ANY => {
                let mut value = in_range(self.register(innermost) + step)?;
                if integer {
                    value = floor_in_range(value)?;
                }
                self.set_register(innermost, value);
                // A step of zero loops forever (STEP).
                let done = if step > 0.0 {
                    value > limit
                } else {
                    step < 0.0 && value < limit
                };
                if !done {
                    return Ok(body);
                }
                self.frames.pop();
                Ok(behind)
            }
            _ => self.next_outer(variable, behind),
        }
    }

    /// NEXT for a loop that is not the innermost: the ones within it are given up.
    #[inline(never)]
    fn next_outer(&mut self, variable: u16, behind: u32) -> Result<u32, ErrorCode> {
        let position = self.find_loop(variable).ok_or(ErrorCode::NextWithoutFor)?;
        self.frames.truncate(position + 1);
        self.next(variable, behind)
    }

    /// FOR, whose variable already has its first value.
    pub(super) fn enter_loop(&mut self, op: Op) -> Result<(), ErrorCode> {
        // The same variable again starts the loop anew and gives up the ones within it.
        if let Some(position) = self.find_loop(op.a) {
            self.frames.truncate(position);
        }
        let levels = self
            .frames
            .iter()
            .filter(|frame| matches!(frame, Frame::For { .. }))
            .count();
        if levels >= FOR_LEVELS {
            return Err(ErrorCode::OutOfMemory);
        }
        self.frames.push(Frame::For {
            variable: op.a,
            integer: op.code == Code::ForInteger,
            limit: self.register(op.b),
            step: self.register(op.c),
            body: self.pc,
        });
        Ok(())
    }

    /// The open loop with this variable within the present subroutine.
    fn find_loop(&self, wanted: u16) -> Option<usize> {
        let calls = self
            .frames
            .iter()
            .rposition(|frame| matches!(frame, Frame::Gosub { .. }));
        let found = self
            .frames
            .iter()
            .rposition(|frame| matches!(frame, Frame::For { variable, .. } if *variable == wanted || wanted == ANY))?;
        calls.is_none_or(|call| found > call).then_some(found)
    }

    /// GOSUB; gives the next operation.
    pub(super) fn gosub(&mut self, target: u32, back: u32) -> Result<u32, ErrorCode> {
        let levels = self
            .frames
            .iter()
            .filter(|frame| matches!(frame, Frame::Gosub { .. }))
            .count();
        if levels >= GOSUB_LEVELS {
            return Err(ErrorCode::OutOfMemory);
        }
        self.frames.push(Frame::Gosub { back });
        Ok(target)
    }

    /// RETURN; gives the next operation.
    pub(super) fn give_back(&mut self) -> Result<u32, ErrorCode> {
        while let Some(frame) = self.frames.pop() {
            if let Frame::Gosub { back } = frame {
                // An interrupt's subroutine ends with RETI alone.
                if self.is_interrupt(self.frames.len()) {
                    self.frames.push(frame);
                    break;
                }
                return Ok(back);
            }
        }
        Err(ErrorCode::ReturnWithoutGosub)
    }
}
