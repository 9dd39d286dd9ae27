//! A scenario that is running: what it has, and what of that `rewind` takes back.

use std::collections::{BTreeMap, VecDeque};

use crate::bench::Bench;
use crate::ieee488;
use crate::probe::Probe;
use crate::time::Nanos;

use super::console::Reader;
use super::report::Digest;
use super::statement::Statement;
use super::watch::{Fold, Source};
use super::{Limits, MOST_OUTPUT, MOST_SCHEDULED, Scenario};

/// What did not hold.
#[derive(Debug)]
pub(super) struct Failure {
    /// Zero until the statement is known.
    pub(super) line: u32,
    pub(super) message: String,
}

impl From<String> for Failure {
    fn from(message: String) -> Failure {
        Failure { line: 0, message }
    }
}

impl Failure {
    pub(super) fn at(mut self, line: u32) -> Failure {
        if self.line == 0 {
            self.line = line;
        }
        self
    }
}

/// How a statement came out.
pub(super) type Done = Result<(), Failure>;

/// A scenario that is running.
pub(super) struct Runner<'a> {
    pub(super) scenario: &'a Scenario,
    pub(super) limits: Limits,
    /// What it mentions, by name.
    pub(super) files: BTreeMap<&'a str, Vec<u8>>,
    pub(super) state: State<'a>,
    pub(super) probe: Probe,
    /// Per host line, all that it received.
    pub(super) outputs: Vec<Vec<u8>>,
    pub(super) checkpoints: VecDeque<Checkpoint<'a>>,
    /// Per watch, from when its station is on the bench.
    pub(super) sources: Vec<Option<Source>>,
    /// The signals of the station that was recorded last.
    pub(super) row: Vec<f64>,
    pub(super) executed: u64,
    /// What `file get` took.
    pub(super) taken: Vec<(String, Vec<u8>)>,
}

impl<'a> Runner<'a> {
    pub(super) fn new(scenario: &'a Scenario, limits: Limits) -> Runner<'a> {
        Runner {
            scenario,
            limits,
            files: BTreeMap::new(),
            state: State::new(scenario.watches.len()),
            probe: Probe::default(),
            outputs: Vec::new(),
            checkpoints: VecDeque::new(),
            sources: vec![None; scenario.watches.len()],
            row: Vec::new(),
            executed: 0,
            taken: Vec::new(),
        }
    }
}

/// Everything that `rewind` takes back, but for what is only cut off: the consoles' output.
#[derive(Debug, Clone)]
pub(super) struct State<'a> {
    pub(super) bench: Bench,
    /// Per station: when it was last switched on; `None` while it is off.
    pub(super) powered: Vec<Option<Nanos>>,
    /// Per station: when its next sample is due, by which one that has been taken is noticed.
    pub(super) due: Vec<Nanos>,
    /// Per host line.
    pub(super) readers: Vec<Reader>,
    /// Per watch.
    pub(super) folds: Vec<Fold>,
    /// In order of time, and at the same time in the order they were scheduled.
    pub(super) schedule: Vec<(Nanos, Scheduled<'a>)>,
    /// What the controller of the IEEE-488 bus has learnt.
    pub(super) bus: BusOutput,
    pub(super) digest: Digest,
}

/// What is done at a moment to come.
#[derive(Debug, Clone, Copy)]
pub(super) enum Scheduled<'a> {
    Statement(&'a Statement),
    /// A held key is let go.
    Release {
        station: usize,
        key: &'a str,
    },
}

/// A place that `rewind` can start from.
#[derive(Debug)]
pub(super) struct Checkpoint<'a> {
    pub(super) state: State<'a>,
    /// Bytes of each host line's output.
    pub(super) lengths: Vec<usize>,
}

impl<'a> State<'a> {
    pub(super) fn new(watches: usize) -> State<'a> {
        State {
            bench: Bench::new(),
            powered: Vec::new(),
            due: Vec::new(),
            readers: Vec::new(),
            folds: vec![Fold::default(); watches],
            schedule: Vec::new(),
            bus: BusOutput::default(),
            digest: Digest::new(),
        }
    }

    /// Puts something on the schedule.
    pub(super) fn schedule(&mut self, at: Nanos, what: Scheduled<'a>) -> Result<(), String> {
        if self.schedule.len() >= MOST_SCHEDULED {
            return Err(format!(
                "at most {MOST_SCHEDULED} statements wait for their time"
            ));
        }
        let place = self.schedule.partition_point(|&(other, _)| other <= at);
        self.schedule.insert(place, (at, what));
        Ok(())
    }
}

/// What the controller of the IEEE-488 bus has learnt, as far as no statement has asked for it.
#[derive(Debug, Clone, Default)]
pub(super) struct BusOutput {
    pub(super) bytes: Vec<u8>,
    /// The last of them came with EOI.
    pub(super) ended: bool,
    /// Of the last poll; `None` if no one answered.
    pub(super) polled: Option<u8>,
}

impl BusOutput {
    pub(super) fn hear(&mut self, report: ieee488::Report) -> Done {
        match report {
            ieee488::Report::Data(byte, end) => {
                self.bytes.push(byte);
                self.ended = end;
                if self.bytes.len() > MOST_OUTPUT {
                    let message = "the bus has brought more than a scenario keeps";
                    return Err(message.to_owned().into());
                }
            }
            ieee488::Report::SerialPoll(_, status) => self.polled = status,
            ieee488::Report::ParallelPoll(bits) => self.polled = Some(bits),
        }
        Ok(())
    }
}
