//! Breakpoints, holding and stepping. A breakpoint replaces the first operation of its line in a copy of the program;
//! what is held goes on with the copy's original.

use std::rc::Rc;

use super::code::{Code, Exit, Image, Op};
use super::vm::{Vm, World};
use crate::exec::Credit;

/// What the debugger wants of the running program.
#[derive(Debug, Clone, Default)]
pub struct Debugger {
    /// Lines with a breakpoint.
    lines: Vec<u32>,
    /// The program with its statements apart, for single steps.
    apart: Rc<Vec<Op>>,
    /// The same with breakpoints in it; `None` without any.
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
        let starts: Vec<usize> = self
            .lines
            .iter()
            .filter_map(|&line| usize::try_from(image.line_start(line)?).ok())
            .collect();
        let mut ops: Vec<Op> = image.ops.iter().map(|op| op.apart()).collect();
        self.apart = Rc::new(ops.clone());
        for &start in &starts {
            if let Some(op) = ops.get_mut(start) {
                op.code = Code::Break;
            }
        }
        self.patched = (!starts.is_empty()).then(|| Rc::new(ops));
    }

    /// Holds the program.
    pub fn hold(&mut self) {
        self.state = State::Held;
    }

    /// Whether the program is held.
    pub fn holds(&self) -> bool {
        self.state == State::Held
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
    pub fn run(&mut self, vm: &mut Vm, credit: &mut Credit, world: &mut World<'_>) -> Exit {
        match self.state {
            State::Held => Exit::Break,
            State::Free => match self.patched.clone() {
                Some(patched) => vm.run_ops(&patched, credit, world),
                None => vm.run(credit, world),
            },
            State::Leaving => {
                let exit = vm.step(&self.apart, credit, world);
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
                let exit = vm.run_ops(&self.apart, credit, world);
                if credit.spent >= spent {
                    self.state = State::Held;
                }
                exit
            }
        }
    }
}
