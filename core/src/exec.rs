//! How a program is executed a slice at a time: what a step returns, what a program waits for, and the credit of
//! firmware time that paces it.

use crate::time::Nanos;

/// What executing a slice came to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Step {
    /// The credit is used up; there is more to do.
    Ran,
    /// The statement cannot go on until something happens; it is tried again at the next sample.
    Waiting(Wait),
    /// The program is over, or stands still for the debugger.
    Stopped(StopReason),
}

/// Why a statement cannot go on. Data that is polled at each sample, so that everything is interruptible.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub enum Wait {
    /// Waits for a line or a character from the console.
    Input,
    /// Waits until the console has sent what was printed.
    Output,
    /// Waits for a time.
    Time,
    /// Waits until a motion has ended.
    Motion,
}

/// Why a program does not run.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum StopReason {
    /// It came to its end, by END, STOP, an error or the last line; the console has said so.
    Ended,
    /// A breakpoint, or one step was asked for.
    Debugger,
}

/// Firmware time that a program may still use.
///
/// Each sample deposits its period; each statement withdraws its cost, never zero. Debt carries over to the next
/// sample. The counter is the only hook into a running program: what wants it to stop takes the credit away.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Credit {
    /// What is left, in ns of firmware time; negative is debt.
    pub balance: i64,
    /// All that was ever withdrawn: grows with every statement, so it names a place in the run (simulated time does
    /// not: many statements share a sample).
    pub spent: u64,
}

impl Credit {
    /// Deposits one sample's period times the speed factor. What is not used expires (a waiting program does not save
    /// up), and one sample never holds more than `most`.
    pub fn deposit(&mut self, period: Nanos, speed: u32, most: Nanos) {
        let deposit = period.0.saturating_mul(u64::from(speed)).min(most.0);
        let deposit = i64::try_from(deposit).unwrap_or(i64::MAX);
        self.balance = self.balance.min(0).saturating_add(deposit);
    }

    /// Books what a slice left over.
    pub fn settle(&mut self, left: i64) {
        self.spent = self
            .spent
            .saturating_add_signed(self.balance.saturating_sub(left));
        self.balance = left;
    }
}
