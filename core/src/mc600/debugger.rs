//! Breakpoints, holding and stepping. A breakpoint replaces the first operation of its line in a copy of the program;
//! what is held goes on with the original.

use std::rc::Rc;

use super::code::{Code, Exit, Image, Op};
use super::vm::{Vm, World};
use crate::exec::Credit;
use crate::hold::Hold;

/// What the debugger wants of the running program.
#[derive(Debug, Clone, Default)]
pub struct Debugger {
    /// Lines with a breakpoint.
    lines: Vec<u32>,
    /// The program with breakpoints in it; `None` without any.
    patched: Option<Rc<Vec<Op>>>,
    /// Whether the program goes on.
    pub hold: Hold,
}

impl Debugger {
    /// Sets the breakpoints.
    pub fn set_breakpoints(&mut self, lines: Vec<u32>, image: &Image) {
        self.lines = lines;
        self.bind(image);
    }

    /// Puts the breakpoints into a newly compiled program.
    pub fn bind(&mut self, image: &Image) {
        self.patched = None;
        let starts = self
            .lines
            .iter()
            .filter_map(|&line| image.line_start(u16::try_from(line).ok()?));
        let mut ops: Option<Vec<Op>> = None;
        for start in starts {
            let ops = ops.get_or_insert_with(|| image.ops.to_vec());
            if let Some(op) = usize::try_from(start)
                .ok()
                .and_then(|start| ops.get_mut(start))
            {
                op.code = Code::Break;
            }
        }
        self.patched = ops.map(Rc::new);
    }

    /// Whether an interrupt may enter: not while the program leaves the breakpoint that it stands at.
    pub fn lets_interrupts_in(&self) -> bool {
        matches!(self.hold, Hold::Free | Hold::Until(_))
    }

    /// Runs the program as far as the debugger lets it.
    pub fn run(&mut self, vm: &mut Vm, credit: &mut Credit, world: &mut World) -> Exit {
        match self.hold {
            Hold::Held => Exit::Break,
            Hold::Free => match self.patched.clone() {
                Some(patched) => vm.run_ops(&patched, credit, world),
                None => vm.run(credit, world),
            },
            Hold::Leaving => {
                let exit = vm.step(credit, world);
                if exit == Exit::Credit {
                    self.hold = Hold::Free;
                    return if credit.balance > 0 {
                        self.run(vm, credit, world)
                    } else {
                        exit
                    };
                }
                if !matches!(exit, Exit::Wait(_)) {
                    self.hold = Hold::Free;
                }
                exit
            }
            Hold::Until(_) => {
                // A step that waits is not over: it ends when the statement has cost something.
                let exit = vm.run(credit, world);
                self.hold.arrive(credit.spent);
                exit
            }
        }
    }
}
