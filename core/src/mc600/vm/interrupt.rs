//! Interrupts enter between two statements and leave with RETI ("The Interrupt functions").

use super::super::firmware::{COST_UNIT, ErrorCode, STATEMENT_COST};
use super::super::machine::Machine;
use super::{Frame, Vm};
use crate::exec::Credit;

/// An interrupt whose subroutine runs.
#[derive(Debug, Clone, Copy)]
pub(super) struct Interrupted {
    /// Which frame leads back.
    frame: usize,
    source: u8,
}

impl Vm {
    /// Whether a frame is an interrupt's.
    pub(super) fn is_interrupt(&self, frame: usize) -> bool {
        let innermost = self.interrupted.last();
        innermost.is_some_and(|interrupted| interrupted.frame == frame)
    }

    /// Calls the subroutine of an interrupt that waits, if the program stands between two statements. That costs the time
    /// of a statement, so that a debugger can tell the places before and behind it apart.
    pub fn enter_interrupt(&mut self, credit: &mut Credit, machine: &mut Machine) {
        let in_program = self.pc < self.image.program_ops;
        if !self.between_statements || !in_program {
            return;
        }
        let here = self.pc;
        if let Some(target) = self.interrupt(here, machine) {
            self.pc = target;
            let cost = i64::from(STATEMENT_COST) * COST_UNIT;
            credit.settle(credit.balance.saturating_sub(cost));
        }
    }

    /// Whether a statement of the program has begun and waits for something.
    pub fn is_amid_a_statement(&self) -> bool {
        !self.between_statements && self.pc < self.image.program_ops
    }

    /// Opens the frame of the interrupt that comes first; gives the first operation of its subroutine.
    fn interrupt(&mut self, back: u32, machine: &mut Machine) -> Option<u32> {
        let (source, line) = machine.interrupts.take()?;
        // The line was there when it was set up, and the program has not changed since.
        let target = self.image.line_start(line)?;
        self.interrupted.push(Interrupted {
            frame: self.frames.len(),
            source,
        });
        self.frames.push(Frame::Gosub { back });
        Some(target)
    }

    /// INTENABLE with an interrupt waiting; gives the next operation.
    pub(super) fn interrupted(&mut self, world: &mut super::World) -> u32 {
        let behind = self.pc;
        let in_program = behind < self.image.program_ops;
        let target = in_program.then(|| self.interrupt(behind, world.machine));
        target.flatten().unwrap_or(behind)
    }

    /// RETI; gives the next operation: that of the next interrupt, if one waits already.
    pub(super) fn return_from_interrupt(
        &mut self,
        world: &mut super::World,
    ) -> Result<u32, ErrorCode> {
        // Frames may have been given up since, by a RUN or a loop that began anew further out.
        while let Some(Interrupted { frame, source }) = self.interrupted.pop() {
            world.machine.interrupts.done(source);
            if let Some(&Frame::Gosub { back }) = self.frames.get(frame) {
                self.frames.truncate(frame);
                return Ok(self.interrupt(back, world.machine).unwrap_or(back));
            }
        }
        Err(ErrorCode::ReturnWithoutGosub)
    }
}
