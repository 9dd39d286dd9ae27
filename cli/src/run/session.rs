//! One controller on a bench, and a person at its console.

use std::io::{self, Write};
use std::time::{Duration, Instant};

use motionbench_core::bench::Bench;
use motionbench_core::controller::{ControllerInfo, LoadError, RunState, Status};
use motionbench_core::exec::Wait;
use motionbench_core::language::latin1;
use motionbench_core::probe::Probe;
use motionbench_core::scenario::busy;
use motionbench_core::time::Nanos;
use motionbench_core::trace::Trace;
use serde_json::{Map, Value, json};

use super::input::{Given, Source};
use crate::arguments::RunArguments;
use crate::files;

/// The station's index and its host line's: there is one of each.
const ONE: usize = 0;
/// Simulated time that a controller may take to its first prompt.
const BOOT: Nanos = Nanos::from_millis(1_000);
/// Simulated time that a run may take without being told.
const MOST: Nanos = Nanos::from_millis(600_000);
/// Samples in a row at which nothing happens before the controller counts as idle.
const STILL: u32 = 2;

/// A controller that runs.
pub(super) struct Session {
    bench: Bench,
    probe: Probe,
    info: ControllerInfo,
    /// Print what the console sends as it comes; otherwise keep it.
    print: bool,
    kept: Vec<u8>,
    /// Simulated time at which to stop, where one is given.
    stop: Option<Nanos>,
    real_time: bool,
}

/// Why a run is over.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Ended {
    /// Nothing happens any more.
    Idle,
    /// The time given is over.
    TimeGiven,
    /// The longest time is over.
    TimeOut,
    /// The program waits for input that does not come.
    NoInput,
    /// The person has left.
    Left,
}

/// What the controller is at.
enum At {
    Work,
    Input,
    Rest,
}

impl Session {
    pub(super) fn new(arguments: &RunArguments, record: bool) -> Result<Session, String> {
        let station = arguments.controller.create(&arguments.options)?;
        let info = station.controller().info().clone();
        let mut bench = Bench::new();
        bench.add(info.id, station, None);
        let mut probe = Probe::default();
        probe.record = record;
        Ok(Session {
            bench,
            probe,
            info,
            print: !arguments.json,
            kept: Vec::new(),
            stop: arguments.time,
            real_time: arguments.real_time,
        })
    }

    pub(super) fn info(&self) -> &ControllerInfo {
        &self.info
    }

    /// What was recorded; `None` if nothing was.
    pub(super) fn trace(&self) -> Option<&Trace> {
        self.probe.traces.get(ONE)
    }

    /// When the record starts, if it does not reach back to the start.
    pub(super) fn lost(&self) -> Option<Nanos> {
        let (first, _) = self.trace()?.span()?;
        (first > self.info.sample).then_some(first)
    }

    /// Turns the mains switch on and waits for the first prompt.
    pub(super) fn power_on(&mut self) -> Result<(), String> {
        self.bench.power(ONE, true);
        let boot = self.stop.map_or(BOOT, |stop| stop.min(BOOT));
        let mut still = 0;
        while self.bench.now() < boot && still < STILL {
            self.sample()?;
            still = if matches!(self.at(), At::Work) {
                0
            } else {
                still + 1
            };
        }
        Ok(())
    }

    pub(super) fn load(&mut self, text: &str) -> Result<(), LoadError> {
        let slot = self.info.program_slot.clone();
        match self.bench.station_mut(ONE) {
            Some(station) => station.load(&slot, text).map(drop),
            None => Ok(()),
        }
    }

    /// Types a line; it travels at line speed.
    pub(super) fn type_line(&mut self, text: &str) -> Result<(), String> {
        let mut line = latin1::bytes(text);
        line.push(b'\r');
        self.send(&line)
    }

    fn send(&mut self, bytes: &[u8]) -> Result<(), String> {
        match self.bench.send(ONE, bytes) {
            sent if sent == bytes.len() => Ok(()),
            _ => Err("more is typed than the line can take".to_owned()),
        }
    }

    /// Runs to the end. A `console` is asked for more when the controller rests; a program only when it waits for input.
    pub(super) fn run(&mut self, mut source: Source, console: bool) -> Result<Ended, String> {
        let mut still = 0;
        let mut since = self.bench.now();
        let mut pace = Pace::start(self.bench.now());
        loop {
            match source.at_hand() {
                Given::Bytes(bytes) => self.send(&bytes)?,
                Given::Nothing => {}
                Given::End => return self.ended(Ended::Left),
            }
            let over = self.stop.is_some_and(|stop| self.bench.now() >= stop);
            if over {
                return self.ended(Ended::TimeGiven);
            }
            if self.stop.is_none() && self.bench.now().since(since) >= MOST && !source.is_terminal()
            {
                return self.ended(Ended::TimeOut);
            }
            self.sample()?;
            if self.real_time {
                pace.keep(self.bench.now());
            }
            let at = self.at();
            still = if matches!(at, At::Work) { 0 } else { still + 1 };
            if still < STILL {
                continue;
            }
            if matches!(at, At::Rest) && !console {
                return self.ended(Ended::Idle);
            }
            self.flush()?;
            match source.wait() {
                Given::Bytes(bytes) => self.send(&bytes)?,
                Given::Nothing => {}
                Given::End if source.is_terminal() => return self.ended(Ended::Left),
                Given::End if matches!(at, At::Rest) => return self.ended(Ended::Idle),
                Given::End => return self.ended(Ended::NoInput),
            }
            (still, since) = (0, self.bench.now());
            pace = Pace::start(self.bench.now());
        }
    }

    fn ended(&mut self, ended: Ended) -> Result<Ended, String> {
        self.flush()?;
        if let Some(note) = super::note(ended, self.busy()) {
            eprintln!("{note}");
        }
        Ok(ended)
    }

    /// Runs for one sample.
    fn sample(&mut self) -> Result<(), String> {
        let mut until = self.bench.now() + self.info.sample;
        if let Some(stop) = self.stop {
            until = until.min(stop);
        }
        self.bench.run_until(until, &mut self.probe);
        if self.probe.console.is_empty() {
            return Ok(());
        }
        let bytes: Vec<u8> = self.probe.console.drain(..).map(|c| c.byte).collect();
        match self.print {
            true => check(io::stdout().lock().write_all(&bytes)),
            false => {
                self.kept.extend(bytes);
                Ok(())
            }
        }
    }

    fn flush(&self) -> Result<(), String> {
        check(io::stdout().lock().flush())
    }

    fn status(&self) -> Option<Status> {
        self.bench.station(ONE).map(|station| station.status())
    }

    fn busy(&self) -> Option<String> {
        busy(&self.status()?)
    }

    fn at(&self) -> At {
        let Some(status) = self.status() else {
            return At::Rest;
        };
        let settled = !status.moving && status.unread == 0 && status.unsent == 0;
        match status.run {
            RunState::Waiting(Wait::Input) if settled && self.bench.is_quiet() => At::Input,
            RunState::Idle if settled && self.bench.is_quiet() => At::Rest,
            _ => At::Work,
        }
    }

    /// The final state, for scripts.
    pub(super) fn state(&self, ended: Ended) -> Value {
        let mut row = Vec::new();
        if let Some(station) = self.bench.station(ONE) {
            station.record(&mut row);
        }
        let signals = self.info.signals.iter().zip(row);
        let signals: Map<String, Value> = signals
            .map(|(signal, value)| {
                let shown = json!({ "value": value, "unit": signal.unit });
                (signal.name.clone(), shown)
            })
            .collect();
        json!({
            "controller": self.info.id,
            "time_s": self.bench.now().seconds(),
            "ended": match ended {
                Ended::Idle => "idle",
                Ended::TimeGiven | Ended::TimeOut => "time",
                Ended::NoInput => "input",
                Ended::Left => "left",
            },
            "error": self.status().and_then(|status| status.error),
            "console": latin1::text(&self.kept),
            "status": self.status(),
            "signals": signals,
        })
    }

    pub(super) fn code(&self, ended: Ended) -> u8 {
        let error = self.status().is_some_and(|status| status.error.is_some());
        super::exit_code(ended, error)
    }
}

/// Keeps simulated time from running ahead of the clock on the wall.
struct Pace {
    wall: Instant,
    simulated: Nanos,
}

impl Pace {
    fn start(now: Nanos) -> Pace {
        Pace {
            wall: Instant::now(),
            simulated: now,
        }
    }

    fn keep(&self, now: Nanos) {
        let simulated = Duration::from_nanos(now.since(self.simulated).0);
        let ahead = simulated.saturating_sub(self.wall.elapsed());
        if ahead > Duration::from_millis(5) {
            std::thread::sleep(ahead);
        }
    }
}

fn check(written: io::Result<()>) -> Result<(), String> {
    written.map_err(|error| format!("standard output: {}", files::reason(&error)))
}
