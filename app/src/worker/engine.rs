//! The bench with one controller on it, or several behind one front panel, driven by the page's messages. It knows neither
//! browser nor wall clock.

use motionbench_core::bench::{Bench, BusView};
use motionbench_core::catalog;
use motionbench_core::controller::{
    Control, Controller, ControllerInfo, Debug, DebugReply, Input, Memory, Panel, RunState, Slot,
    Status, Survives, TerminalSettings,
};
use motionbench_core::ieee488;
use motionbench_core::language::latin1;
use motionbench_core::probe::Probe;
use motionbench_core::time::Nanos;

use super::sender::{Line, Sender};
use super::units;
use crate::protocol::{self, BUILD, FromWorker, Ready, ToWorker, Unloadable, read_bench_name};

/// Rows and console bytes that wait for the page; when there are more, simulation waits too. So much in a frame is
/// taken in by the page within a few milliseconds; 8 KiB of text are hundreds of times the line's own speed.
const MOST_ROWS: usize = 1 << 16;
const MOST_BYTES: usize = 1 << 13;

/// The bench, and what it has done that the page has not heard of.
#[derive(Debug)]
pub struct Engine {
    bench: Bench,
    probe: Probe,
    /// What the console has received, and what the terminal shows.
    received: Vec<u8>,
    shown: Vec<u8>,
    info: ControllerInfo,
    /// The station that the front panel is switched to; all are alike.
    station: usize,
    line: usize,
    sender: Sender,
    terminal: TerminalSettings,
    /// Simulated time stands still.
    frozen: bool,
    /// The program may come to be held: by a breakpoint, or behind a step.
    may_be_held: bool,
    /// So many units were held when time was last let go on. It goes on until another one is.
    left_held: usize,
    /// What the page was last told that the controller holds.
    kept: Memory,
}

/// What happened since the last report.
#[derive(Debug)]
pub struct Report {
    /// Simulated time.
    pub now: Nanos,
    /// The unit of which this tells, from 0.
    pub unit: usize,
    /// What the controller does.
    pub status: Status,
    /// Grows with all that may change what is kept.
    pub work: u64,
    /// What its front panel shows.
    pub panel: Option<Panel>,
    /// How the IEEE-488 bus stands.
    pub bus: Option<BusView>,
    /// What its controller has learnt.
    pub learnt: Vec<ieee488::Report>,
    /// What the terminal shows.
    pub console: String,
    /// What the console received, where that is not the same.
    pub received: Option<String>,
    /// Characters that wait to be sent to the controller.
    pub pending: usize,
    /// The samples of each unit, as [`protocol::pack`] makes them, one behind the other.
    pub samples: Vec<f64>,
    /// How many are each unit's.
    pub parts: Vec<usize>,
    /// Simulated time stands still.
    pub frozen: bool,
}

impl Engine {
    /// The controller of a [`protocol::bench_name`], switched on.
    ///
    /// # Errors
    /// One clear line, if there is no such kind or it has no such option.
    pub fn new(name: &str) -> Result<Engine, String> {
        let (kind, options) = read_bench_name(name);
        let mut bench = Bench::new();
        let mut line = None;
        for options in catalog::units(kind, &options)? {
            let unit = bench.add(kind, catalog::create(kind, &options)?, line);
            line = bench.line_of(unit);
            bench.power(unit, true);
        }
        let first = bench.station(0).map(|station| station.info().clone());
        let (Some(info), Some(line)) = (first, line) else {
            return Err("the controller has no console".to_owned());
        };
        Ok(Engine {
            bench,
            probe: Probe::recording(),
            received: Vec::new(),
            shown: Vec::new(),
            info,
            station: 0,
            line,
            sender: Sender::default(),
            terminal: TerminalSettings::default(), // the page says how it is
            frozen: false,
            may_be_held: false,
            left_held: 0,
            kept: Memory::default(),
        })
    }

    /// What the page must know first.
    pub fn ready(&self) -> Ready {
        Ready {
            build: BUILD.to_owned(),
            controller: self.info.name.to_owned(),
            line: self.info.line,
            signals: self.info.signals.clone(),
            units: self.bench.len(),
        }
    }

    /// Simulated time.
    pub fn now(&self) -> Nanos {
        self.bench.now()
    }

    /// Does what the page asks of the bench, and says what it is to be answered; what concerns only the worker is left
    /// alone.
    pub fn act(&mut self, message: &ToWorker) -> Option<FromWorker> {
        match message {
            ToWorker::Send(text) if self.sender.is_empty() => {
                self.send(&latin1::bytes(text));
            }
            ToWorker::Send(text) => self.sender.queue(&latin1::bytes(text), None),
            ToWorker::SendPaced { text, pace } => {
                self.sender.queue(&latin1::bytes(text), Some(*pace));
            }
            ToWorker::Stop => {
                self.sender.clear();
                self.interrupt();
                self.go_on();
            }
            ToWorker::Run => self.start(),
            ToWorker::Load { text, start } => return Some(self.load(text, *start)),
            ToWorker::Take => {
                let revision = self.status().revision;
                let text = self.bench.station(self.station)?.listing(&Slot::Program)?;
                return Some(FromWorker::Listing { text, revision });
            }
            ToWorker::Breakpoints(lines) => {
                self.may_be_held |= !lines.is_empty();
                self.debug(Debug::Breakpoints(lines.clone()));
            }
            ToWorker::Freeze(true) => self.frozen = true,
            ToWorker::Freeze(false) => {
                self.each(|unit| drop(unit.debug(Debug::Control(Control::Continue))));
                self.go_on();
            }
            ToWorker::Step => {
                self.debug(Debug::Control(Control::Step));
                self.may_be_held = true;
                self.go_on();
            }
            ToWorker::EmergencyStop(pressed) => {
                let stop = Input::Fault {
                    kind: "estop".to_owned(),
                    axis: None,
                    active: *pressed,
                };
                for unit in 0..self.bench.len() {
                    // Every controller has one.
                    let _ = self.bench.input(unit, stop.clone());
                }
            }
            ToWorker::Select(unit) => self.select(*unit),
            ToWorker::Wire { name, value } => self.outside(Input::Wire {
                name: name.clone(),
                value: *value,
            }),
            ToWorker::Key { key, down } => self.outside(Input::Key {
                key: key.clone(),
                down: *down,
            }),
            // The page offers only what there is; what is too much at once is not done.
            ToWorker::Bus(order) => drop(self.bench.order(order)),
            ToWorker::Line(settings) => self.bench.set_line(self.line, *settings),
            ToWorker::Terminal(settings) => self.terminal = *settings,
            ToWorker::Break => self.bench.send_break(self.line),
            ToWorker::Cancel => self.cancel(),
            ToWorker::Keep => {
                let held = self.stations().map(|unit| unit.memory(Survives::Reload));
                let memory = units::join(held);
                if memory != self.kept {
                    self.kept.clone_from(&memory);
                    return Some(FromWorker::Kept(memory));
                }
            }
            ToWorker::Restore(memory) => {
                self.kept.clone_from(memory);
                let mut parts = units::split(memory, self.bench.len()).into_iter();
                self.each(|unit| unit.restore(&parts.next().unwrap_or_default()));
            }
            ToWorker::Cam => {
                let table = match self.bench.station_mut(self.station)?.debug(Debug::Cam) {
                    DebugReply::Cam(table) => Some(table),
                    DebugReply::Done | DebugReply::Value(_) | DebugReply::Refused(_) => None,
                };
                return Some(FromWorker::Cam(table));
            }
            ToWorker::PutFile { name, text } => {
                let station = self.bench.station_mut(self.station)?;
                let taken = station.load(&Slot::File(name.clone()), text);
                let filed = taken.map(|_| name.clone()).map_err(|error| error.message);
                return Some(FromWorker::Filed(filed));
            }
            ToWorker::Power(on) => {
                self.cancel();
                for unit in 0..self.bench.len() {
                    self.bench.power(unit, *on);
                }
                self.go_on();
            }
            ToWorker::Speed(_) | ToWorker::Taken(_) => {}
        }
        None
    }

    /// Sends to the console, and shows it if the terminal is set so.
    fn send(&mut self, bytes: &[u8]) {
        let sent = self.bench.send(self.line, bytes);
        if self.terminal.local_echo {
            self.receive();
            for &byte in bytes.iter().take(sent) {
                self.shown.push(byte);
                // A line that has been sent is left behind, whatever the answer to it begins with.
                if byte == b'\r' && !self.terminal.line_feeds {
                    self.shown.push(b'\n');
                }
            }
        }
    }

    /// Takes what the console has received since the last time.
    fn receive(&mut self) {
        let from = self.received.len();
        let arrived = self.probe.console.drain(..).map(|console| console.byte);
        self.received.extend(arrived);
        self.shown.extend_from_slice(&self.received[from..]);
    }

    /// Forgets what has not been sent.
    fn cancel(&mut self) {
        self.sender.clear();
        self.bench.cancel(self.line);
    }

    /// Types the start command, at the prompt (D356).
    fn start(&mut self) {
        self.cancel();
        if !self.status().at_prompt {
            self.interrupt();
        }
        if let Some(hands_on) = self.info.hands_on {
            // A unit that the bus has does not leave it for the first key.
            for key in [hands_on.listen, hands_on.stop] {
                if !self.status().listens {
                    self.tap(key);
                }
            }
        }
        self.go_on();
        let start = format!("{}\r", self.station().info().start);
        self.send(start.as_bytes());
    }

    /// Stops what runs: from the console, and at the front panels of units that do not listen to it (D356).
    fn interrupt(&mut self) {
        self.bench.send_urgent(self.line, self.info.attention);
        let Some(hands_on) = self.info.hands_on else {
            return;
        };
        let selected = self.station;
        for unit in 0..self.bench.len() {
            let status = self.bench.station(unit).map(|station| station.status());
            let runs = |status: Status| status.run != RunState::Idle || status.moving;
            if status.is_some_and(|status| !status.listens && runs(status)) {
                self.select(unit);
                self.tap(hands_on.stop);
            }
        }
        self.select(selected);
    }

    /// Presses a key of the front panel and lets it go.
    fn tap(&mut self, key: &str) {
        for down in [true, false] {
            self.outside(Input::Key {
                key: key.to_owned(),
                down,
            });
        }
    }

    fn load(&mut self, text: &str, start: bool) -> FromWorker {
        let slot = self.info.program_slot.clone();
        let refused = || Unloadable {
            line: 0,
            message: "there is no controller".to_owned(),
        };
        let station = self.bench.station_mut(self.station).ok_or_else(refused);
        let loaded = station.and_then(|station| {
            station.load(&slot, text).map_err(|error| Unloadable {
                line: error.line,
                message: error.message,
            })
        });
        if loaded.is_ok() && start {
            self.start();
        }
        FromWorker::Loaded(loaded)
    }

    fn debug(&mut self, command: Debug) {
        if let Some(station) = self.bench.station_mut(self.station) {
            // What cannot be held now is not held: the status shows it.
            let _ = station.debug(command);
        }
    }

    /// Turns the selector of the front panel.
    fn select(&mut self, unit: usize) {
        if let Some(selector) = self.info.panel_selector
            && unit < self.bench.len()
        {
            self.station = unit;
            self.outside(Input::Wire {
                name: selector.to_owned(),
                value: (unit + 1) as f64,
            });
        }
    }

    /// All stations.
    fn stations(&self) -> impl Iterator<Item = &dyn Controller> {
        (0..self.bench.len()).filter_map(|unit| self.bench.station(unit))
    }

    /// Does something to each station.
    fn each(&mut self, mut act: impl FnMut(&mut dyn Controller)) {
        for unit in 0..self.bench.len() {
            if let Some(station) = self.bench.station_mut(unit) {
                act(station);
            }
        }
    }

    /// How many units have a program that is held.
    fn held(&self) -> usize {
        let held = |unit: &&dyn Controller| unit.status().run == RunState::Paused;
        self.stations().filter(held).count()
    }

    /// Lets time go on. Units that are held now stay so.
    fn go_on(&mut self) {
        self.frozen = false;
        self.left_held = self.held();
    }

    /// The page offers only what the controller has.
    fn outside(&mut self, input: Input) {
        let _ = self.bench.input(self.station, input);
    }

    /// Advances simulated time to `until`, or to where the program comes to be held; then everything stands still.
    pub fn advance(&mut self, until: Nanos) {
        while !self.sender.is_empty() && !self.frozen && self.now() < until {
            self.send_next();
            let next = self.sender.due(self.now());
            self.run_until(next.min(until));
        }
        self.run_until(until);
    }

    /// Sends the next character of a text that is sent at a pace, if it is time for it.
    fn send_next(&mut self) {
        let status = self.status();
        let settings = self.bench.line_settings(self.line);
        let is_free = self.bench.host_pending(self.line) == 0;
        let line = Line {
            now: self.now(),
            character: settings.map_or(Nanos::ZERO, |settings| settings.character()),
            is_free,
            at_prompt: is_free && status.at_prompt && status.unread == 0 && status.unsent == 0,
        };
        if let Some(byte) = self.sender.take(line) {
            self.send(&[byte]);
        }
    }

    fn run_until(&mut self, until: Nanos) {
        if !self.may_be_held {
            self.bench.run_until(until, &mut self.probe);
            return;
        }
        while !self.frozen && self.bench.run_next(until, &mut self.probe) {
            let held = self.held();
            self.frozen = held > self.left_held;
            self.left_held = self.left_held.min(held);
        }
        if !self.frozen {
            self.bench.run_until(until, &mut self.probe);
        }
    }

    /// Whether simulated time stands still.
    pub fn is_frozen(&self) -> bool {
        self.frozen
    }

    /// Whether so much waits to be reported that simulation must wait.
    pub fn is_full(&self) -> bool {
        let rows: usize = self.probe.traces.iter().map(|trace| trace.len()).sum();
        rows >= MOST_ROWS || self.probe.console.len() + self.shown.len() >= MOST_BYTES
    }

    /// Whether there is something to report beyond time that passes and an axis that stands still.
    pub fn is_busy(&self) -> bool {
        let status = self.status();
        let idle = self.frozen || matches!(status.run, RunState::Idle);
        !idle || status.moving || !self.probe.console.is_empty() || !self.shown.is_empty()
    }

    /// What happened since the last report.
    pub fn report(&mut self) -> Report {
        self.receive();
        let shown = std::mem::take(&mut self.shown);
        let received = std::mem::take(&mut self.received);
        let (mut samples, mut parts) = (Vec::new(), Vec::new());
        for trace in &mut self.probe.traces {
            let packed = protocol::pack(trace);
            trace.clear();
            parts.push(packed.len());
            // The only part is not copied.
            match samples.is_empty() {
                true => samples = packed,
                false => samples.extend(packed),
            }
        }
        Report {
            now: self.now(),
            unit: self.station,
            status: self.status(),
            work: self
                .stations()
                .map(|unit| unit.status())
                .fold(0, |work, status| work + status.spent + status.revision),
            panel: self.bench.panel(self.station),
            bus: self.bench.bus(),
            learnt: std::mem::take(&mut self.probe.bus),
            received: (received != shown || self.terminal.line_feeds)
                .then(|| latin1::text(&received)),
            console: self.as_shown(&shown),
            pending: self.bench.host_pending(self.line) + self.sender.len(),
            samples,
            parts,
            frozen: self.frozen,
        }
    }

    /// What the terminal shows of these bytes.
    fn as_shown(&self, bytes: &[u8]) -> String {
        let text = latin1::text(bytes);
        if self.terminal.line_feeds {
            text.replace('\r', "\r\n")
        } else {
            text
        }
    }

    fn status(&self) -> Status {
        self.station().status()
    }

    fn station(&self) -> &dyn Controller {
        // It was put on the bench when the engine was made, and nothing takes it off.
        let station = self.bench.station(self.station);
        station.expect("the bench has its station")
    }
}

#[cfg(test)]
mod tests;
