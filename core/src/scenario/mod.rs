//! The scenario language: puts controllers on the bench, does to them what a person would, and says what must follow.
//!
//! `text` takes a line apart, `parse` and `words` make statements of it, `run`, `station`, `panel` and `bus` perform them, `advance` lets time pass
//! meanwhile, `watch` folds what is seen, `report` tells how it went. `docs/scenario.md` describes the language.
//!
//! A scenario is parsed whole before it runs, so that what is folded while running (`check always`, `check ever`) is
//! known from the start. Parsing is bounded and never panics; files that a scenario mentions are handed in.

mod advance;
mod bus;
mod condition;
mod console;
mod panel;
mod parse;
mod report;
mod run;
mod runner;
mod statement;
mod station;
mod text;
mod watch;
mod words;

pub use advance::busy;
pub use report::{Outcome, Report};
pub use text::duration;

use crate::catalog::Station;
use crate::language::latin1;
use crate::time::Nanos;

use condition::Condition;
use statement::Statement;

/// Time that a statement that waits has without `within`.
const WITHIN: Nanos = Nanos::from_millis(10_000);
/// The longest time that a statement may name and, unless told, a scenario may simulate: a day.
const LONGEST: Nanos = Nanos::from_millis(86_400_000);
/// Bytes of a scenario.
const MOST_TEXT: usize = 4 << 20;
/// Times that a block may be repeated.
const MOST_REPEATS: u32 = 1_000_000;
/// Statements that a run may execute, unless told.
const MOST_EXECUTED: u64 = 10_000_000;
/// Controllers on the bench.
const MOST_STATIONS: usize = 128;
/// Bytes that one console may have sent, and that `file get` may take.
const MOST_OUTPUT: usize = 16 << 20;
/// Statements that may wait for their time.
const MOST_SCHEDULED: usize = 10_000;

/// A scenario, ready to run any number of times.
#[derive(Debug, Clone, Default)]
pub struct Scenario {
    statements: Vec<Statement>,
    stations: Vec<Planned>,
    watches: Vec<Watch>,
    /// Its line and the reason.
    known_failure: Option<(u32, String)>,
    /// All that its rewinds take back, one after the other; zero if it never does.
    rewinds: Nanos,
    last_line: u32,
}

/// A station that a `bench` line puts on the bench.
#[derive(Debug, Clone)]
struct Planned {
    name: String,
    /// The kind of controller.
    id: &'static str,
    station: Station,
    /// The earlier station whose host line it shares, further down the chain.
    behind: Option<usize>,
    /// The host line as `line=` calls it.
    line: Option<String>,
}

/// A condition that is folded at every sample.
#[derive(Debug, Clone)]
struct Watch {
    line: u32,
    station: usize,
    /// `check ever`, not `check always`.
    ever: bool,
    condition: Condition,
}

/// Why a text is no scenario.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Problem {
    /// Line of the text, from 1.
    pub line: u32,
    /// One clear sentence.
    pub message: String,
}

/// How far a run may go; what goes further has failed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Limits {
    /// Simulated time: a day if not told.
    pub simulated: Nanos,
    /// Executed statements, those in `repeat` each time: ten million if not told.
    pub executed: u64,
}

impl Default for Limits {
    fn default() -> Limits {
        Limits {
            simulated: LONGEST,
            executed: MOST_EXECUTED,
        }
    }
}

/// Reads a file that a scenario mentions, by the name that it gives, relative to the scenario.
///
/// # Errors
/// One clear line that says why not.
pub type ReadFile<'a> = dyn FnMut(&str) -> Result<Vec<u8>, String> + 'a;

impl Scenario {
    /// Reads a scenario.
    ///
    /// # Errors
    /// The first [`Problem`]; nothing has run then.
    pub fn parse(text: &str) -> Result<Scenario, Problem> {
        parse::parse(text)
    }

    /// Runs it on a bench of its own.
    pub fn run(&self, read: &mut ReadFile<'_>) -> Report {
        self.run_within(Limits::default(), read)
    }

    /// As [`Scenario::run`], but not as far.
    pub fn run_within(&self, limits: Limits, read: &mut ReadFile<'_>) -> Report {
        run::run(self, limits, read)
    }
}

/// A program file as text: UTF-8 where it is that (less a byte-order mark), otherwise a character for a byte.
pub fn program_text(bytes: &[u8]) -> String {
    match std::str::from_utf8(bytes) {
        Ok(text) => text.strip_prefix('\u{feff}').unwrap_or(text).to_owned(),
        Err(_) => latin1::text(bytes),
    }
}
