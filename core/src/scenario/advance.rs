//! Lets time pass for a scenario: samples are folded, scheduled statements are performed, checkpoints are taken.

use crate::controller::{RunState, Status, Value};
use crate::exec::Wait;
use crate::time::Nanos;

use super::MOST_OUTPUT;
use super::condition::Condition;
use super::console::{Reader, find};
use super::runner::{Checkpoint, Failure, Runner};
use super::text::show_time;
use super::watch::Source;

/// Checkpoints that are kept, whatever `rewind` needs.
const MOST_CHECKPOINTS: usize = 256;

/// What time passes for.
#[derive(Debug)]
pub(super) enum Goal<'t> {
    /// The time itself.
    Time,
    /// Nothing happens any more, at two samples in a row.
    Idle { since: Option<Nanos> },
    /// The line's output has this text; it has been sought up to `from`.
    Text {
        line: usize,
        text: &'t [u8],
        from: usize,
    },
    /// The station's console is at its prompt, and all that was typed has been read.
    Prompt { station: usize },
    /// The controller of the IEEE-488 bus has done all that was asked of it.
    Bus,
    /// A unit requests service on the IEEE-488 bus.
    Service,
    /// The condition fails, with this value.
    Breaks {
        station: usize,
        condition: &'t Condition,
        source: Source,
        value: Option<Value>,
    },
}

/// Why a station is not idle, in words; `None` if it is.
pub fn busy(status: &Status) -> Option<String> {
    if !status.power {
        // A motor that coasts is all that a controller does while it is off.
        return status.moving.then(|| "an axis moves".to_owned());
    }
    let line = status
        .line
        .map_or(String::new(), |line| format!(" in line {line}"));
    match status.run {
        RunState::Idle => {}
        RunState::Command => return Some("a command is being executed".to_owned()),
        RunState::Running => return Some(format!("the program runs{line}")),
        RunState::Waiting(Wait::Input) => {
            return Some(format!("the program waits for input{line}"));
        }
        RunState::Waiting(Wait::Output) => {
            return Some(format!("the program waits until its output is sent{line}"));
        }
        RunState::Waiting(Wait::Time) => return Some(format!("the program waits{line}")),
        RunState::Waiting(Wait::Motion) => {
            return Some(format!("the program waits for the end of a motion{line}"));
        }
        RunState::Paused => return Some(format!("the program is held{line}")),
    }
    if status.moving {
        Some("an axis moves".to_owned())
    } else if status.unsent > 0 {
        Some(format!("{} bytes are not sent", status.unsent))
    } else if status.unread > 0 {
        Some(format!("{} bytes are not read", status.unread))
    } else {
        None
    }
}

impl<'a> Runner<'a> {
    /// Why the bench is not idle.
    pub(super) fn busy(&self) -> Option<String> {
        let bench = &self.state.bench;
        for (index, planned) in self.scenario.stations.iter().enumerate() {
            let station = bench.station(index);
            if let Some(reason) = station.and_then(|station| busy(&station.status())) {
                return Some(match self.scenario.stations.len() {
                    1 => reason,
                    _ => format!("{}: {reason}", planned.name),
                });
            }
        }
        if let Some(reason) = self.bus_waits() {
            return Some(reason);
        }
        (!bench.is_quiet()).then(|| "bytes are on the line".to_owned())
    }

    /// Lets `time` pass, or less if the goal is reached; tells whether it was.
    pub(super) fn advance(&mut self, time: Nanos, goal: &mut Goal<'_>) -> Result<bool, Failure> {
        let until = self.state.bench.now() + time;
        let most = self.limits.simulated;
        if until > most {
            return Err(format!("a scenario simulates at most {}", show_time(most)).into());
        }
        if self.reached(goal, false) {
            return Ok(true);
        }
        loop {
            let scheduled = self.state.schedule.first().map(|&(at, _)| at);
            let leg = until.min(scheduled.unwrap_or(Nanos::MAX));
            if self.leg(leg, goal)? {
                return Ok(true);
            }
            match self.state.schedule.first().copied() {
                Some((at, what)) if at <= until => {
                    self.state.schedule.remove(0);
                    self.perform(what)?;
                }
                _ => return Ok(false),
            }
        }
    }

    /// Runs to `leg`, with nothing from outside until then.
    fn leg(&mut self, leg: Nanos, goal: &mut Goal<'_>) -> Result<bool, Failure> {
        loop {
            self.checkpoint();
            let stop = match self.scenario.rewinds {
                Nanos::ZERO => leg,
                _ => leg.min(self.state.bench.now() + self.checkpoint_interval()),
            };
            while self.state.bench.run_next(stop, &mut self.probe) {
                let sampled = self.observe()?;
                if self.reached(goal, sampled) {
                    return Ok(true);
                }
            }
            self.state.bench.run_until(stop, &mut self.probe);
            self.observe()?;
            if self.reached(goal, false) {
                return Ok(true);
            }
            if stop == leg {
                return Ok(false);
            }
        }
    }

    /// Takes in what has happened; tells whether some station has sampled.
    fn observe(&mut self) -> Result<bool, Failure> {
        let state = &mut self.state;
        for received in self.probe.console.drain(..) {
            let words = [
                received.line as u64,
                received.at.0,
                u64::from(received.byte),
            ];
            words.iter().for_each(|&word| state.digest.add(word));
            if let Some(output) = self.outputs.get_mut(received.line) {
                output.push(received.byte);
                if output.len() > MOST_OUTPUT {
                    return Err("the console has sent more than a scenario keeps"
                        .to_owned()
                        .into());
                }
            }
        }
        for report in self.probe.bus.drain(..) {
            state.digest.add(report.word());
            state.bus.hear(report)?;
        }
        let mut sampled = false;
        for index in 0..self.state.bench.len() {
            let next = self
                .state
                .bench
                .station(index)
                .map(|station| station.next());
            if let Some((due, next)) = self.state.due.get_mut(index).zip(next)
                && *due != next
            {
                *due = next;
                sampled = true;
                self.fold(index);
            }
        }
        Ok(sampled)
    }

    /// Takes in a station's sample.
    fn fold(&mut self, index: usize) {
        self.record(index);
        let state = &mut self.state;
        let now = state.bench.now();
        state.digest.add(now.0);
        self.row.iter().for_each(|&n| state.digest.add_number(n));
        let Some(on) = state.powered.get(index).copied().flatten() else {
            return;
        };
        let Some(station) = state.bench.station_mut(index) else {
            return;
        };
        let watches = self.scenario.watches.iter().zip(&self.sources);
        for ((watch, source), fold) in watches.zip(&mut state.folds) {
            if watch.station != index {
                continue;
            }
            // A variable that does not exist yet has no value to judge.
            if let Some(Ok(value)) = source.as_ref().map(|s| s.read(station, &self.row)) {
                fold.add(watch, now.since(on), value);
            }
        }
    }

    /// Puts a station's recorded signals in `row`.
    pub(super) fn record(&mut self, index: usize) {
        self.row.clear();
        if let Some(station) = self.state.bench.station(index) {
            station.record(&mut self.row);
        }
    }

    fn reached(&mut self, goal: &mut Goal<'_>, sampled: bool) -> bool {
        match goal {
            Goal::Time => false,
            Goal::Idle { since } => sampled && self.is_idle(since),
            Goal::Text { line, text, from } => {
                let output = self.outputs.get(*line).map_or(&[][..], Vec::as_slice);
                let rest = output.get(*from..).unwrap_or_default();
                let found = find(rest, text).is_some();
                // What is sought may stand across the end.
                *from += (rest.len() + 1).saturating_sub(text.len().max(1));
                found
            }
            Goal::Bus => self.state.bench.bus().is_none_or(|bus| !bus.busy),
            Goal::Service => self.state.bench.bus().is_some_and(|bus| bus.service),
            Goal::Prompt { station } => sampled && self.is_at_prompt(*station),
            Goal::Breaks {
                station,
                condition,
                source,
                value,
            } => {
                if sampled {
                    self.record(*station);
                    let controller = self.state.bench.station_mut(*station);
                    let read = controller.and_then(|c| source.read(c, &self.row).ok());
                    *value = read.filter(|value| !condition.holds(value));
                }
                value.is_some()
            }
        }
    }

    fn is_idle(&self, since: &mut Option<Nanos>) -> bool {
        if self.busy().is_some() {
            *since = None;
            return false;
        }
        let now = self.state.bench.now();
        let since = *since.get_or_insert(now);
        let stations = (0..self.state.bench.len()).filter_map(|i| self.state.bench.station(i));
        let longest = stations.map(|s| s.info().sample).max().unwrap_or_default();
        now.since(since) >= longest
    }

    fn is_at_prompt(&self, index: usize) -> bool {
        let bench = &self.state.bench;
        let line = bench.line_of(index);
        let asked = bench.station(index).map(|station| station.status());
        // What others on the line have still to pass on belongs to the reply.
        let passed_on = (0..bench.len())
            .filter(|&other| bench.line_of(other) == line)
            .filter_map(|other| bench.station(other))
            .map(|station| station.status())
            .all(|status| !status.power || (status.unread == 0 && status.unsent == 0));
        asked.is_some_and(|status| status.at_prompt) && passed_on && bench.is_quiet()
    }

    fn checkpoint_interval(&self) -> Nanos {
        Nanos((self.scenario.rewinds.0 / 64).max(10_000_000))
    }

    /// Takes a checkpoint if the scenario rewinds, and forgets those that it cannot reach any more.
    fn checkpoint(&mut self) {
        let reach = self.scenario.rewinds;
        if reach == Nanos::ZERO {
            return;
        }
        let oldest = self.state.bench.now().since(reach);
        while self.checkpoints.len() >= MOST_CHECKPOINTS
            || self
                .checkpoints
                .get(1)
                .is_some_and(|second| second.state.bench.now() <= oldest)
        {
            self.checkpoints.pop_front();
        }
        self.checkpoints.push_back(Checkpoint {
            state: self.state.clone(),
            lengths: self.outputs.iter().map(Vec::len).collect(),
        });
    }

    /// Takes back the last `time`: everything is as it was then, after all that was done at that moment.
    pub(super) fn rewind(&mut self, time: Nanos) -> Result<(), Failure> {
        let now = self.state.bench.now();
        let earliest = self.checkpoints.front().map(|c| c.state.bench.now());
        let reach = now.since(earliest.unwrap_or(now));
        if time > reach {
            let message = format!("only {} can be taken back", show_time(reach));
            return Err(message.into());
        }
        let target = now.since(time);
        while self
            .checkpoints
            .back()
            .is_some_and(|checkpoint| checkpoint.state.bench.now() > target)
        {
            self.checkpoints.pop_back();
        }
        if let Some(checkpoint) = self.checkpoints.back() {
            self.state = checkpoint.state.clone();
            for (output, &length) in self.outputs.iter_mut().zip(&checkpoint.lengths) {
                output.truncate(length);
            }
        }
        // Nothing came from outside between the checkpoint and there.
        while self.state.bench.run_next(target, &mut self.probe) {
            self.observe()?;
        }
        self.state.bench.run_until(target, &mut self.probe);
        self.observe()?;
        Ok(())
    }

    /// Notes a station that has come on the bench.
    pub(super) fn added(&mut self, index: usize) {
        let next = self
            .state
            .bench
            .station(index)
            .map(|station| station.next());
        self.state.due.push(next.unwrap_or(Nanos::MAX));
        self.state.powered.push(None);
        let lines = self.state.bench.line_of(index).map_or(0, |line| line + 1);
        self.outputs
            .resize(self.outputs.len().max(lines), Vec::new());
        let readers = &mut self.state.readers;
        readers.resize(readers.len().max(lines), Reader::default());
    }
}
