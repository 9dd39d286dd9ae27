//! N codes, the stack, and where programs end (5-5, 6-2 to 6-4).

use super::scan::Scan;
use super::{Flow, Modes, Outcome, Place, Run, World, known};
use crate::unidex3::firmware::LEVELS;
use crate::unidex3::trouble::Trouble;
use crate::unidex3::words::{self, Sequence};

/// A level of the stack.
#[derive(Debug, Clone)]
pub(super) struct Frame {
    /// Where to go on.
    place: Place,
    keeps: Keeps,
}

/// What is as before after the return.
#[derive(Debug, Clone, Copy)]
enum Keeps {
    /// `N-`, `N+`: nothing.
    Nothing,
    /// `N=`: feedrates, absolute or incremental, corner rounding.
    Some(Modes),
    /// `N<`: all of the modes; the end of the called program returns.
    All(Modes),
}

impl Run {
    pub(super) fn sequence(&mut self, scan: &mut Scan<'_>, world: &World<'_>) -> Outcome {
        let start = scan.at;
        let end = words::next_end(scan.text, start).unwrap_or(scan.text.len());
        scan.at = end;
        let word = scan.text.get(start..end).unwrap_or_default();
        let sequence = words::sequence(word).ok_or(Trouble::N)?;
        let name = match sequence {
            Sequence::Label(_) => "Nn",
            Sequence::Call(_) => "N-n",
            Sequence::Independent(_) => "N=n",
            Sequence::Jump(_) => "N>n",
            Sequence::Push(_) => "N+n",
            Sequence::Program(_) => "N<n",
        };
        known(name, world, Trouble::N)?;
        match sequence {
            Sequence::Label(_) => Ok(Flow::Next),
            Sequence::Jump(line) => {
                self.place.at = self.line(line)?;
                Ok(Flow::Jump)
            }
            Sequence::Call(line) => self.call(line, end, Keeps::Nothing),
            Sequence::Independent(line) => self.call(line, end, Keeps::Some(self.modes)),
            Sequence::Push(line) => {
                let at = self.line(line)?;
                self.push(at, Keeps::Nothing)?;
                Ok(Flow::Next)
            }
            Sequence::Program(number) => {
                let number = u8::try_from(number).map_err(|_| Trouble::NoProgram)?;
                let text = world.memory.text(number).ok_or(Trouble::NoProgram)?;
                self.push(end, Keeps::All(self.modes))?;
                self.place = Place {
                    number: Some(number),
                    text,
                    at: 0,
                };
                Ok(Flow::Jump)
            }
        }
    }

    fn line(&self, line: u32) -> Result<usize, Trouble> {
        words::label(&self.place.text, line).ok_or(Trouble::N)
    }

    fn call(&mut self, line: u32, back: usize, keeps: Keeps) -> Outcome {
        let at = self.line(line)?;
        self.push(back, keeps)?;
        self.place.at = at;
        Ok(Flow::Jump)
    }

    fn push(&mut self, at: usize, keeps: Keeps) -> Result<(), Trouble> {
        if self.stack.len() >= LEVELS {
            return Err(Trouble::Stack);
        }
        let place = Place {
            at,
            ..self.place.clone()
        };
        self.stack.push(Frame { place, keeps });
        Ok(())
    }

    /// M89: forgets the last level.
    pub(super) fn pop(&mut self) -> Result<Frame, Trouble> {
        self.stack.pop().ok_or(Trouble::Stack)
    }

    /// M99.
    pub(super) fn return_from(&mut self, world: &World<'_>) -> Outcome {
        let frame = self.pop()?;
        self.go_back(frame, world);
        Ok(Flow::Jump)
    }

    fn go_back(&mut self, frame: Frame, _world: &World<'_>) {
        self.place = frame.place;
        match frame.keeps {
            Keeps::Nothing => {}
            Keeps::Some(before) => {
                self.modes = Modes {
                    vector: self.modes.vector,
                    register: self.modes.register,
                    ..before
                }
            }
            Keeps::All(before) => self.modes = before,
        }
    }

    /// M2, M30 and the end of the text: back to the program that called this one, if one has.
    pub(super) fn end_of_program(&mut self, world: &World<'_>) -> Outcome {
        while let Some(frame) = self.stack.pop() {
            if matches!(frame.keeps, Keeps::All(_)) {
                self.go_back(frame, world);
                return Ok(Flow::Jump);
            }
        }
        Ok(Flow::End)
    }

    /// M47: the program from its start, with nothing of its own on the stack.
    pub(super) fn restart(&mut self) -> Outcome {
        let caller = self
            .stack
            .iter()
            .rposition(|f| matches!(f.keeps, Keeps::All(_)));
        self.stack.truncate(caller.map_or(0, |caller| caller + 1));
        self.place.at = 0;
        Ok(Flow::Jump)
    }
}
