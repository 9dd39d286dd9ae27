//! Breakpoints, holding and stepping. A breakpoint replaces the first operation of its line in a copy of the program;
//! what is held goes on with the original.

use std::rc::Rc;

use super::code::{Code, Exit, Image, Op};
use super::vm::{Vm, World};
use crate::exec::Credit;

/// What the debugger wants of the running program.
#[derive(Debug, Clone, Default)]
pub struct Debugger {
    /// Lines with a breakpoint.
    lines: Vec<u32>,
    /// The program with breakpoints in it; `None` without any.
    patched: Option<Rc<Vec<Op>>>,
    state: State,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
enum State {
    #[default]
    Free,
    Held,
    /// Runs until this much firmware time is spent.
    Until(u64),
    /// Runs freely, but first past the breakpoint that it stands at.
    Leaving,
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

    /// Holds the program.
    pub fn hold(&mut self) {
        self.state = State::Held;
    }

    /// Whether the program is held.
    pub fn holds(&self) -> bool {
        self.state == State::Held
    }

    /// Whether an interrupt may enter: not while the program leaves the breakpoint that it stands at.
    pub fn lets_interrupts_in(&self) -> bool {
        matches!(self.state, State::Free | State::Until(_))
    }

    /// Lets the program go.
    pub fn release(&mut self) {
        self.state = if self.holds() {
            State::Leaving
        } else {
            State::Free
        };
    }

    /// The program is over: nothing is held any more.
    pub fn forget(&mut self) {
        self.state = State::Free;
    }

    /// Lets a held program run until it has spent this much firmware time.
    pub fn run_to(&mut self, spent: u64) {
        self.state = State::Until(spent);
    }

    /// Takes away the credit that would carry the program too far.
    pub fn limit(&mut self, credit: &mut Credit) {
        if let State::Until(spent) = self.state {
            if credit.spent >= spent {
                self.state = State::Held;
                return;
            }
            let most = i64::try_from(spent.saturating_sub(credit.spent)).unwrap_or(i64::MAX);
            credit.balance = credit.balance.min(most);
        }
    }

    /// Runs the program as far as the debugger lets it.
    pub fn run(&mut self, vm: &mut Vm, credit: &mut Credit, world: &mut World) -> Exit {
        match self.state {
            State::Held => Exit::Break,
            State::Free => match self.patched.clone() {
                Some(patched) => vm.run_ops(&patched, credit, world),
                None => vm.run(credit, world),
            },
            State::Leaving => {
                let exit = vm.step(credit, world);
                if exit == Exit::Credit {
                    self.state = State::Free;
                    return if credit.balance > 0 {
                        self.run(vm, credit, world)
                    } else {
                        exit
                    };
                }
                if !matches!(exit, Exit::Wait(_)) {
                    self.state = State::Free;
                }
                exit
            }
            State::Until(spent) => {
                // A step that waits is not over: it ends when the statement has cost something.
                let exit = vm.run(credit, world);
                if credit.spent >= spent {
                    self.state = State::Held;
                }
                exit
            }
        }
    }
}
