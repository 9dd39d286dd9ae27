//! What a run leaves behind. The bench writes to it and never asks it anything.

use crate::ieee488::Report;
use crate::time::Nanos;
use crate::trace::Trace;

/// Everything that can be observed of a run, outside the bench so that a checkpoint of the bench stays small.
#[derive(Debug, Default)]
pub struct Probe {
    /// What each host line received, oldest first. The reader drains it.
    pub console: Vec<ConsoleByte>,
    /// What the controller of the IEEE-488 bus has learnt, oldest first. The reader drains it.
    pub bus: Vec<Report>,
    /// The motion commands, where asked for.
    pub motion: Vec<MotionLog>,
    /// One trace per station, in the bench's order, where recording is on.
    pub traces: Vec<Trace>,
    /// Record rows.
    pub record: bool,
    /// Log motion commands.
    pub log_motion: bool,
    /// Where a row is gathered before it goes to its trace.
    pub(crate) row: Vec<f64>,
}

/// A byte that a host received.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ConsoleByte {
    /// Which host line.
    pub line: usize,
    /// When its stop bit ended.
    pub at: Nanos,
    /// The byte as the host's settings read it.
    pub byte: u8,
}

/// A motion command that a program gave.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct MotionLog {
    /// The station.
    pub station: usize,
    /// When.
    pub at: Nanos,
    /// As the program wrote it.
    pub command: String,
}

impl Probe {
    /// A probe that records signals.
    pub fn recording() -> Probe {
        Probe {
            record: true,
            ..Probe::default()
        }
    }
}
