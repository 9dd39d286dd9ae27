//! The bench with one controller on it, driven by the page's messages. It knows neither browser nor wall clock.

use motionbench_core::bench::Bench;
use motionbench_core::catalog;
use motionbench_core::controller::{
    ControllerInfo, Debug, Input, Memory, RunState, Slot, Status, Survives,
};
use motionbench_core::language::latin1;
use motionbench_core::probe::Probe;
use motionbench_core::time::Nanos;

use crate::protocol::{self, BUILD, FromWorker, Ready, ToWorker, Unloadable};

/// Rows and console bytes that wait for the page; when there are more, simulation waits too. So much in a frame is
/// taken in by the page within a few milliseconds; 8 KiB of text are hundreds of times the line's own speed.
const MOST_ROWS: usize = 1 << 16;
const MOST_BYTES: usize = 1 << 13;

/// The bench, and what it has done that the page has not heard of.
#[derive(Debug)]
pub struct Engine {
    bench: Bench,
    probe: Probe,
    info: ControllerInfo,
    station: usize,
    line: usize,
    /// Simulated time stands still.
    frozen: bool,
    /// The program may come to be held: by a breakpoint, or behind a step.
    may_be_held: bool,
    /// What the page was last told that the controller holds.
    kept: Memory,
}

/// What happened since the last report.
#[derive(Debug)]
pub struct Report {
    /// Simulated time.
    pub now: Nanos,
    /// What the controller does.
    pub status: Status,
    /// What the console received.
    pub console: String,
    /// Characters that wait to be sent to the controller.
    pub pending: usize,
    /// The samples, as [`protocol::pack`] makes them.
    pub samples: Vec<f64>,
    /// Simulated time stands still.
    pub frozen: bool,
}

impl Engine {
    /// An MC-600, switched on.
    ///
    /// # Errors
    /// One clear line, if the catalogue does not have it.
    pub fn new() -> Result<Engine, String> {
        let kind = catalog::kind("mc600").ok_or("there is no controller mc600")?;
        let station = (kind.create)(&[])?;
        let info = station.controller().info().clone();
        let mut bench = Bench::new();
        let station = bench.add(kind.id, station, None);
        let line = bench
            .line_of(station)
            .ok_or("the controller has no console")?;
        bench.power(station, true);
        Ok(Engine {
            bench,
            probe: Probe::recording(),
            info,
            station,
            line,
            frozen: false,
            may_be_held: false,
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
            ToWorker::Send(text) => {
                self.bench.send(self.line, &latin1::bytes(text));
            }
            ToWorker::Stop => {
                self.frozen = false;
                self.bench.send_urgent(self.line, self.info.attention);
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
            ToWorker::Freeze(frozen) => {
                self.frozen = *frozen;
                if !frozen {
                    self.debug(Debug::Continue);
                }
            }
            ToWorker::Step => {
                self.debug(Debug::Step);
                self.may_be_held = true;
                self.frozen = false;
            }
            ToWorker::EmergencyStop(pressed) => self.outside(Input::Fault {
                kind: "estop".to_owned(),
                axis: None,
                active: *pressed,
            }),
            ToWorker::Wire { name, value } => self.outside(Input::Wire {
                name: name.clone(),
                value: *value,
            }),
            ToWorker::Line(settings) => self.bench.set_line(self.line, *settings),
            ToWorker::Break => self.bench.send_break(self.line),
            ToWorker::Cancel => {
                self.bench.cancel(self.line);
            }
            ToWorker::Keep => {
                let station = self.bench.station(self.station)?;
                let memory = station.memory(Survives::Reload);
                if memory != self.kept {
                    self.kept.clone_from(&memory);
                    return Some(FromWorker::Kept(memory));
                }
            }
            ToWorker::Restore(memory) => {
                self.kept.clone_from(memory);
                self.bench.station_mut(self.station)?.restore(memory);
            }
            ToWorker::Power(on) => {
                self.frozen = false;
                self.bench.cancel(self.line);
                self.bench.power(self.station, *on);
            }
            ToWorker::Speed(_) | ToWorker::Taken(_) => {}
        }
        None
    }

    /// Types the start command, at the prompt.
    fn start(&mut self) {
        self.frozen = false;
        if !self.status().at_prompt {
            self.bench.send_urgent(self.line, self.info.attention);
        }
        let start = format!("{}\r", self.info.start);
        self.bench.send(self.line, start.as_bytes());
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

    /// The page offers only what the controller has.
    fn outside(&mut self, input: Input) {
        let _ = self.bench.input(self.station, input);
    }

    /// Advances simulated time to `until`, or to where the program comes to be held; then everything stands still.
    pub fn advance(&mut self, until: Nanos) {
        if !self.may_be_held {
            self.bench.run_until(until, &mut self.probe);
            return;
        }
        while !self.frozen && self.bench.run_next(until, &mut self.probe) {
            self.frozen = self.status().run == RunState::Paused;
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
        let rows = self.probe.traces.first().map_or(0, |trace| trace.len());
        rows >= MOST_ROWS || self.probe.console.len() >= MOST_BYTES
    }

    /// Whether there is something to report beyond time that passes and an axis that stands still.
    pub fn is_busy(&self) -> bool {
        let status = self.status();
        let idle = self.frozen || matches!(status.run, RunState::Idle);
        !idle || status.moving || !self.probe.console.is_empty()
    }

    /// What happened since the last report.
    pub fn report(&mut self) -> Report {
        let console: Vec<u8> = self.probe.console.drain(..).map(|c| c.byte).collect();
        let trace = self.probe.traces.get_mut(self.station);
        let samples = trace.map_or_else(Vec::new, |trace| {
            let samples = protocol::pack(trace);
            trace.clear();
            samples
        });
        Report {
            now: self.now(),
            status: self.status(),
            console: latin1::text(&console),
            pending: self.bench.host_pending(self.line),
            samples,
            frozen: self.frozen,
        }
    }

    fn status(&self) -> Status {
        // The station was put on the bench when the engine was made, and nothing takes it off.
        self.bench
            .station(self.station)
            .map(|station| station.status())
            .expect("the bench has its station")
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::protocol::ToWorker::{Power, Run, Send, Stop};

    /// Acts, lets simulated time pass, and returns what the console printed and the samples.
    fn after(engine: &mut Engine, messages: &[ToWorker], millis: u64) -> Report {
        for message in messages {
            engine.act(message);
        }
        engine.advance(engine.now() + Nanos::from_millis(millis));
        engine.report()
    }

    fn text(text: &str) -> ToWorker {
        Send(text.to_owned())
    }

    fn bench() -> Engine {
        let mut engine = Engine::new().unwrap();
        let printed = after(&mut engine, &[], 500).console;
        assert!(printed.ends_with('>'), "{printed:?}");
        engine
    }

    #[test]
    fn a_typed_program_moves_the_axis_and_answers() {
        let mut engine = bench();
        let program = text("10 MDRVEN()\r20 MMOVE(40960)\rRUN\r");
        let report = after(&mut engine, &[program], 3000);
        assert!(report.console.ends_with("RUN\r\n>"), "{:?}", report.console);
        let rows = report.samples.len() / (engine.info.signals.len() + 1);
        assert_eq!(rows, 1500);
        let command = engine
            .info
            .signals
            .iter()
            .position(|signal| signal.name == "x.command");
        let newest = report.samples[(command.unwrap() + 2) * rows - 1];
        assert_eq!(newest, 40_960.0);
        assert!(
            after(&mut engine, &[], 0).samples.is_empty(),
            "reported once"
        );
    }

    #[test]
    fn characters_travel_at_line_speed() {
        let mut engine = bench();
        // 100 characters of 10 bits at 9600 baud take 104 ms.
        let report = after(&mut engine, &[text(&"A".repeat(100))], 50);
        assert!(
            (40..=48).contains(&report.console.len()),
            "{}",
            report.console.len()
        );
        assert!((50..=54).contains(&report.pending), "{}", report.pending);
    }

    #[test]
    fn stop_acts_under_a_busy_program_and_a_paste() {
        let mut engine = bench();
        after(
            &mut engine,
            &[text("10 GOTO 10\rRUN\r"), text(&"X".repeat(100_000))],
            200,
        );
        let report = after(&mut engine, &[Stop], 100);
        assert!(
            report.console.ends_with("BREAK IN 10\r\n>"),
            "{:?}",
            report.console
        );
        assert_eq!((report.status.run, report.pending), (RunState::Idle, 0));
    }

    #[test]
    fn run_starts_the_program_whatever_the_console_is_at() {
        let mut engine = bench();
        after(&mut engine, &[text("10 PRINT \"HELLO\"\r")], 200);
        assert!(after(&mut engine, &[Run], 200).console.contains("HELLO"));
        after(&mut engine, &[text("20 HALF A LI")], 200);
        assert!(after(&mut engine, &[Run], 200).console.contains("HELLO"));
        after(&mut engine, &[text("30 GOTO 30\rRUN\r")], 200);
        assert!(after(&mut engine, &[Run], 200).console.contains("HELLO"));
    }

    const LOOP: &str = "10 A=A+1\n20 B=A*2\n30 GOTO 10";

    fn load(text: &str) -> ToWorker {
        ToWorker::Load {
            text: text.to_owned(),
            start: true,
        }
    }

    #[test]
    fn a_program_of_the_page_is_loaded_and_visibly_started() {
        let mut engine = bench();
        let Some(FromWorker::Loaded(Ok(revision))) = engine.act(&load("10 ?\"HI\"\n\n20 END"))
        else {
            panic!("not loaded");
        };
        assert_eq!(revision.lines, [Some(10), None, Some(20)]);
        let report = after(&mut engine, &[], 200);
        assert_eq!(report.console, "RUN\r\nHI\r\n>");
        assert_eq!(report.status.revision, revision.number);
        let refused = engine.act(&load("10 END\nEND"));
        let Some(FromWorker::Loaded(Err(refused))) = refused else {
            panic!("loaded");
        };
        assert_eq!(refused.line, 1);
        let listing = FromWorker::Listing {
            text: "10 ?\"HI\"\r\n20 END\r\n".to_owned(),
            revision: revision.number,
        };
        assert_eq!(engine.act(&ToWorker::Take), Some(listing));
    }

    #[test]
    fn a_breakpoint_holds_program_and_time_and_a_step_runs_one_statement() {
        let mut engine = bench();
        after(
            &mut engine,
            &[ToWorker::Breakpoints(vec![20]), load(LOOP)],
            1000,
        );
        let held = engine.report();
        assert!(held.frozen);
        assert_eq!(
            (held.status.run, held.status.line),
            (RunState::Paused, Some(20))
        );
        let stepped = after(&mut engine, &[ToWorker::Step], 1000);
        assert_eq!(stepped.status.line, Some(30));
        assert!(stepped.frozen && stepped.now.since(held.now) < Nanos::from_millis(10));
        let again = after(&mut engine, &[ToWorker::Freeze(false)], 1000);
        assert_eq!((again.status.line, again.frozen), (Some(20), true));
        let free = [ToWorker::Breakpoints(Vec::new()), ToWorker::Freeze(false)];
        let free = after(&mut engine, &free, 1000);
        assert_eq!((free.status.run, free.frozen), (RunState::Running, false));
        let stopped = after(&mut engine, &[ToWorker::Freeze(true), Stop], 100);
        assert!(stopped.console.ends_with("\r\n>"), "{:?}", stopped.console);
    }

    #[test]
    fn what_is_kept_comes_back_into_another_bench() {
        let mut engine = bench();
        after(&mut engine, &[load("10 END")], 200);
        after(&mut engine, &[text("SAVE \"B:ONE\"\rSAVE \"TWO\"\r")], 300);
        let Some(FromWorker::Kept(memory)) = engine.act(&ToWorker::Keep) else {
            panic!("nothing kept");
        };
        assert_eq!(engine.act(&ToWorker::Keep), None, "nothing has changed");
        let mut other = bench();
        let answer = after(
            &mut other,
            &[ToWorker::Restore(memory), text("LIST\rFILES\r")],
            300,
        );
        assert!(
            answer.console.contains("10 END\r\n"),
            "{:?}",
            answer.console
        );
        assert!(answer.console.contains("TWO.BAS"), "{:?}", answer.console);
        let off_and_on = after(
            &mut other,
            &[Power(false), Power(true), text("LOAD \"B:ONE\"\rLIST\r")],
            500,
        );
        assert!(
            off_and_on.console.ends_with("10 END\r\n>"),
            "{:?}",
            off_and_on.console
        );
    }

    #[test]
    fn the_emergency_stop_acts_under_any_program() {
        let mut engine = bench();
        let spin = "10 MDRVEN()\n20 MSPEED(34952)\n30 GOTO 30";
        assert!(after(&mut engine, &[load(spin)], 2000).status.moving);
        let stopped = after(&mut engine, &[ToWorker::EmergencyStop(true)], 1000).status;
        assert!(!stopped.moving && !stopped.enabled, "{stopped:?}");
        assert_eq!(stopped.run, RunState::Running);
    }

    #[test]
    fn the_mains_switch_forgets_the_program_and_what_was_being_sent() {
        let mut engine = bench();
        after(
            &mut engine,
            &[text("10 GOTO 10\rRUN\r"), text(&"X".repeat(1000))],
            100,
        );
        let report = after(&mut engine, &[Power(false)], 100);
        assert_eq!((report.status.power, report.pending), (false, 0));
        let report = after(&mut engine, &[Power(true)], 500);
        assert!(report.console.ends_with('>'), "{:?}", report.console);
        assert_eq!(
            after(&mut engine, &[text("LIST\r")], 200).console,
            "LIST\r\n>"
        );
    }

    #[test]
    fn a_page_that_does_not_listen_stops_the_simulation() {
        let mut engine = bench();
        while !engine.is_full() {
            engine.advance(engine.now() + Nanos::from_millis(1000));
            assert!(engine.now() < Nanos::from_millis(1_000_000));
        }
        engine.report();
        assert!(!engine.is_full());
    }
}
