//! Holding a running program for a person who looks at it: what pausing, stepping and going on are to every controller.

use crate::controller::{Control, DebugReply};
use crate::exec::Credit;

/// Whether the running program goes on.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Hold {
    /// It runs.
    #[default]
    Free,
    /// It stands still.
    Held,
    /// It runs until this much firmware time is spent.
    Until(u64),
    /// It runs, but first past the breakpoint that it stands at.
    Leaving,
}

impl Hold {
    /// Does what a debugger asks of a program that `runs` or not and has spent so much firmware time.
    pub fn obey(&mut self, control: Control, runs: bool, spent: u64) -> DebugReply {
        *self = match control {
            Control::Continue => self.released(),
            _ if !runs => return DebugReply::Refused("no program runs".to_owned()),
            Control::Pause => Hold::Held,
            Control::Step => Hold::Until(spent + 1),
            Control::RunTo(spent) => Hold::Until(spent),
        };
        DebugReply::Done
    }

    /// Whether the program is held.
    pub fn holds(self) -> bool {
        self == Hold::Held
    }

    /// Takes away the credit that would carry the program too far, and holds one that is far enough.
    pub fn limit(&mut self, credit: &mut Credit) {
        self.arrive(credit.spent);
        if let Hold::Until(spent) = *self {
            let most = i64::try_from(spent.saturating_sub(credit.spent)).unwrap_or(i64::MAX);
            credit.balance = credit.balance.min(most);
        }
    }

    /// Holds a program that was to run until so much is spent.
    pub fn arrive(&mut self, spent: u64) {
        if matches!(*self, Hold::Until(until) if spent >= until) {
            *self = Hold::Held;
        }
    }

    fn released(self) -> Hold {
        match self {
            Hold::Held => Hold::Leaving,
            Hold::Free | Hold::Until(_) | Hold::Leaving => Hold::Free,
        }
    }
}
