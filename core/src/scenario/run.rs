//! Performs a scenario's statements, one function a group.

use crate::controller::{Controller, Input};
use crate::time::Nanos;

use super::advance::Goal;
use super::console::NoReply;
use super::report::{Outcome, Report};
use super::runner::{Done, Failure, Runner, Scheduled};
use super::statement::{Action, LineSetting, Statement};
use super::text::{show, show_time};
use super::watch::Source;
use super::{Limits, ReadFile, Scenario};

/// Runs a scenario; see [`Scenario::run_within`].
pub(super) fn run(scenario: &Scenario, limits: Limits, read: &mut ReadFile<'_>) -> Report {
    let mut runner = Runner::new(scenario, limits);
    let mut outcome = Outcome::Unusable;
    let mut ended = runner.read_files(&scenario.statements, read);
    if ended.is_ok() {
        outcome = Outcome::Failed;
        ended = runner.execute(&scenario.statements);
    }
    if ended.is_ok() {
        ended = runner.nothing_is_left();
    }
    let (outcome, line, message) = match (ended, &scenario.known_failure) {
        (Ok(()), None) => (Outcome::Held, 0, String::new()),
        (Ok(()), Some((line, reason))) => {
            let message = format!("marked as a known failure ({reason}), but everything held");
            (Outcome::Failed, *line, message)
        }
        (Err(failure), Some((_, reason))) if outcome == Outcome::Failed => {
            let message = format!("{} (known failure: {reason})", failure.message);
            (Outcome::KnownFailure, failure.line, message)
        }
        (Err(failure), _) => (outcome, failure.line, failure.message),
    };
    Report {
        outcome,
        line,
        message,
        simulated: runner.state.bench.now(),
        digest: runner.state.digest.0,
        files: runner.taken,
    }
}

impl<'a> Runner<'a> {
    fn read_files(&mut self, statements: &'a [Statement], read: &mut ReadFile<'_>) -> Done {
        for statement in statements {
            let file = match &statement.action {
                Action::Load { file, .. } | Action::FilePut { file, .. } => file,
                Action::Repeat { body, .. } => {
                    self.read_files(body, read)?;
                    continue;
                }
                Action::At { statement, .. } => {
                    self.read_files(std::slice::from_ref(statement.as_ref()), read)?;
                    continue;
                }
                _ => continue,
            };
            if !self.files.contains_key(file.as_str()) {
                let bytes = read(file).map_err(|m| Failure::from(m).at(statement.line))?;
                self.files.insert(file, bytes);
            }
        }
        Ok(())
    }

    fn execute(&mut self, statements: &'a [Statement]) -> Done {
        for statement in statements {
            self.executed += 1;
            let most = self.limits.executed;
            let done = if self.executed > most {
                let message = format!("a scenario executes at most {most} statements");
                Err(message.into())
            } else {
                self.act(statement)
            };
            done.map_err(|failure| failure.at(statement.line))?;
        }
        Ok(())
    }

    /// A scheduled statement whose time did not come has tested nothing.
    fn nothing_is_left(&self) -> Done {
        let now = self.state.bench.now();
        for (at, what) in &self.state.schedule {
            if let Scheduled::Statement(statement) = what {
                let left = show_time(at.since(now));
                let message = format!("the scenario ends {left} before this is due");
                return Err(Failure::from(message).at(statement.line));
            }
        }
        Ok(())
    }

    /// Does what was scheduled.
    pub(super) fn perform(&mut self, what: Scheduled<'a>) -> Done {
        match what {
            Scheduled::Statement(statement) => self.execute(std::slice::from_ref(statement)),
            Scheduled::Release { station, key } => self.key(station, key, false),
        }
    }

    fn act(&mut self, statement: &'a Statement) -> Done {
        let station = statement.station;
        match &statement.action {
            Action::Bench => self.bench(station),
            Action::Line(settings) => self.line(station, settings),
            Action::Break => self.send_break(station),
            Action::Axis { axis, settings } => self.axis(station, axis, settings),
            Action::FilePut { name, file } => self.file_put(station, name, file),
            Action::FileGet { name, file } => self.file_get(station, name, file),
            Action::FileExpect { name, text } => self.file_expect(station, name, text.as_deref()),
            Action::Load { slot, file } => self.load(station, slot.as_ref(), file),
            Action::Program { slot, text } => {
                self.program(station, slot.as_ref(), text, statement.line)
            }
            Action::Power(on) => self.power(station, *on),
            Action::Type(text) => self.type_line(station, text),
            Action::Send(bytes) => self.send(station, bytes),
            Action::Press(keys) => self.press(station, keys),
            Action::Hold { key, time } => self.hold(station, key, *time),
            Action::Wire { name, value } => self.wire(station, name, *value),
            Action::Fault { kind, axis, active } => {
                self.fault(station, kind, axis.as_deref(), *active)
            }
            Action::Run(time) => self.advance(*time, &mut Goal::Time).map(drop),
            Action::RunUntilIdle { within } => self.run_until_idle(station, *within),
            Action::RunUntil { text, within } => self.run_until(station, text, *within),
            Action::Expect(text) => self.expect(station, text),
            Action::ExpectExactly(bytes) => self.expect_exactly(station, bytes),
            Action::ExpectNothing => self.expect_exactly(station, b""),
            Action::Reply { text, within } => self.reply(station, text, *within),
            Action::Display(text) => self.display(station, text),
            Action::Led { name, state } => self.led(station, name, *state),
            Action::Lamp { name, on } => self.lamp(station, name, *on),
            Action::Printer(text) => self.printer(station, text),
            Action::Bus(action) => self.bus(station, action),
            Action::Needs(part) => Err(self.has_no(station, part)),
            Action::Repeat { count, body } => (0..*count).try_for_each(|_| self.execute(body)),
            Action::At { time, statement } => self.at(station, *time, statement),
            Action::Rewind(time) => self.rewind(*time),
            Action::Check(condition) => self.check(station, condition),
            Action::CheckAlways(watch) | Action::CheckEver(watch) => self.check_fold(*watch),
            Action::CheckSettled { condition, within } => {
                self.check_settled(station, condition, *within)
            }
        }
    }

    fn bench(&mut self, index: usize) -> Done {
        let Some(planned) = self.scenario.stations.get(index) else {
            return Ok(());
        };
        let station = planned.station.clone();
        for (watch, source) in self.scenario.watches.iter().zip(&mut self.sources) {
            if watch.station == index {
                let info = station.controller().info();
                *source = Some(Source::new(info, &watch.condition.signal));
            }
        }
        let before = planned.behind;
        let line = before.and_then(|before| self.state.bench.line_of(before));
        let added = self.state.bench.add(&planned.name, station, line);
        self.added(added);
        Ok(())
    }

    pub(super) fn controller(&mut self, station: usize) -> Result<&mut dyn Controller, Failure> {
        let controller = self.state.bench.station_mut(station);
        controller.ok_or_else(|| "the controller is not on the bench".to_owned().into())
    }

    pub(super) fn has_no(&self, station: usize, part: &str) -> Failure {
        let id = self.scenario.stations.get(station).map_or("", |s| s.id);
        format!("{id} has no {part}").into()
    }

    pub(super) fn input(&mut self, station: usize, input: Input) -> Done {
        let given = self.state.bench.input(station, input);
        given.map_err(|refused| refused.0.into())
    }

    // The line and the console.

    fn host_line(&self, station: usize) -> usize {
        self.state.bench.line_of(station).unwrap_or_default()
    }

    fn output(&self, station: usize) -> &[u8] {
        let output = self.outputs.get(self.host_line(station));
        output.map_or(&[], Vec::as_slice)
    }

    fn line(&mut self, station: usize, changes: &[LineSetting]) -> Done {
        let line = self.host_line(station);
        if let Some(mut settings) = self.state.bench.line_settings(line) {
            for &change in changes {
                match change {
                    LineSetting::Baud(baud) => settings.baud = baud,
                    LineSetting::Parity(parity) => settings.parity = parity,
                    LineSetting::DataBits(bits) => settings.data_bits = bits,
                    LineSetting::StopBits(bits) => settings.stop_bits = bits,
                    LineSetting::Flow(flow) => settings.flow = flow,
                }
            }
            self.state.bench.set_line(line, settings);
        }
        Ok(())
    }

    fn send_break(&mut self, station: usize) -> Done {
        let line = self.host_line(station);
        self.state.bench.send_break(line);
        Ok(())
    }

    fn send(&mut self, station: usize, bytes: &[u8]) -> Done {
        let line = self.host_line(station);
        let sent = self.state.bench.send(line, bytes);
        match sent == bytes.len() {
            true => Ok(()),
            false => Err("the host's queue is full: let time pass first"
                .to_owned()
                .into()),
        }
    }

    fn type_line(&mut self, station: usize, text: &[u8]) -> Done {
        let line = self.host_line(station);
        let output = self.outputs.get(line).map_or(&[][..], Vec::as_slice);
        if let Some(reader) = self.state.readers.get_mut(line) {
            reader.typed(text, output);
        }
        self.send(station, text)?;
        self.send(station, b"\r")
    }

    /// What the console has sent since the last match, for a message.
    fn sent(&self, station: usize) -> String {
        let reader = self.state.readers.get(self.host_line(station));
        match reader.map_or(&[][..], |reader| reader.unmatched(self.output(station))) {
            [] => "the console sent nothing".to_owned(),
            bytes => format!("the console sent {}", show(bytes)),
        }
    }

    /// Moves the position of the station's console.
    fn matched(&mut self, station: usize, text: &[u8]) -> bool {
        let line = self.host_line(station);
        let output = self.outputs.get(line).map_or(&[][..], Vec::as_slice);
        let reader = self.state.readers.get_mut(line);
        reader.is_some_and(|reader| reader.expect(text, output))
    }

    fn finish(&mut self, station: usize) {
        let line = self.host_line(station);
        let output = self.outputs.get(line).map_or(&[][..], Vec::as_slice);
        if let Some(reader) = self.state.readers.get_mut(line) {
            reader.finish(output);
        }
    }

    pub(super) fn expect(&mut self, station: usize, text: &[u8]) -> Done {
        match self.matched(station, text) {
            true => Ok(()),
            false => Err(format!("expected {}, {}", show(text), self.sent(station)).into()),
        }
    }

    fn expect_exactly(&mut self, station: usize, bytes: &[u8]) -> Done {
        let reader = self.state.readers.get(self.host_line(station));
        let sent = reader.map_or(&[][..], |reader| reader.unmatched(self.output(station)));
        if sent == bytes {
            self.finish(station);
            return Ok(());
        }
        let expected = match bytes {
            [] => "nothing".to_owned(),
            _ => format!("exactly {}", show(bytes)),
        };
        Err(format!("expected {expected}, {}", self.sent(station)).into())
    }

    fn run_until(&mut self, station: usize, text: &[u8], within: Nanos) -> Done {
        let line = self.host_line(station);
        let from = self.state.readers.get(line).map_or(0, |r| r.position());
        let mut goal = Goal::Text { line, text, from };
        if !self.advance(within, &mut goal)? {
            let message = format!("no {} within {}", show(text), show_time(within));
            let why = self.busy().unwrap_or_else(|| "all is idle".to_owned());
            return Err(format!("{message}: {why}; {}", self.sent(station)).into());
        }
        self.matched(station, text);
        Ok(())
    }

    fn run_until_idle(&mut self, station: usize, within: Nanos) -> Done {
        if self.advance(within, &mut Goal::Idle { since: None })? {
            return Ok(());
        }
        let why = self.busy().unwrap_or_default();
        let last = match self.output(station) {
            [] => "the console sent nothing".to_owned(),
            output => format!("the console sent last {}", show(output)),
        };
        Err(format!("not idle within {}: {why}; {last}", show_time(within)).into())
    }

    fn reply(&mut self, station: usize, text: &[u8], within: Nanos) -> Done {
        let prompted = self.advance(within, &mut Goal::Prompt { station })?;
        let prompt: &'static str = self.controller(station)?.info().prompt;
        let reader = self.state.readers.get(self.host_line(station));
        let output = self.output(station);
        let found = match reader {
            Some(reader) if prompted => reader.reply(prompt.as_bytes(), output),
            _ => Err(NoReply::Prompt),
        };
        let message = match found {
            Ok(found) if found == text => None,
            Ok(found) => Some(format!(
                "expected the reply {}, it was {}",
                show(text),
                show(found)
            )),
            Err(NoReply::Echo) => {
                let typed = reader.map_or(&[][..], |reader| reader.last_typed());
                Some(format!(
                    "no echo of {}: {}",
                    show(typed),
                    self.sent(station)
                ))
            }
            Err(NoReply::Prompt) => {
                let why = self.busy().unwrap_or_else(|| "all is idle".to_owned());
                let within = show_time(within);
                let sent = self.sent(station);
                Some(format!("no prompt within {within}: {why}; {sent}"))
            }
        };
        match message {
            Some(message) => Err(message.into()),
            None => {
                self.finish(station);
                Ok(())
            }
        }
    }
}
