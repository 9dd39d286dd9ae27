//! What the fuzzers do with their bytes, and an ordinary test with the seeds: whatever is not as it must be panics.
//!
//! The fuzzers are a workspace of their own and include this file: it names nothing but the simulator.

use motionbench_core::bench::Bench;
use motionbench_core::catalog::{self, Kind};
use motionbench_core::controller::{Controller, Input, Slot, Status, Survives};
use motionbench_core::language::{Span, latin1, split_lines};
use motionbench_core::mc600::program::{Program, STORED_LENGTH};
use motionbench_core::probe::Probe;
use motionbench_core::scenario::{Limits, Outcome, Scenario, program_text};
use motionbench_core::serial::{LineSettings, Parity};
use motionbench_core::time::Nanos;

#[path = "fuzz/smartmotor.rs"]
mod smartmotor;

#[path = "fuzz/unidex3.rs"]
mod unidex3;

pub use smartmotor::{smartmotor_serial, smartmotor_text};
pub use unidex3::{unidex3_keys, unidex3_text};

/// A fuzzer's name and what it does with bytes.
pub type Target = (&'static str, fn(&[u8]));

/// Every fuzzer.
pub const TARGETS: [Target; 7] = [
    ("mc600_text", mc600_text),
    ("mc600_console", mc600_console),
    ("smartmotor_text", smartmotor_text),
    ("smartmotor_serial", smartmotor_serial),
    ("unidex3_text", unidex3_text),
    ("unidex3_keys", unidex3_keys),
    ("scenario", scenario),
];

/// Bytes as the text of a program: in the editor, in memory, renumbered, run, saved and loaded.
///
/// # Panics
/// If something is not as it must be.
pub fn mc600_text(data: &[u8]) {
    let text = program_text(data);
    edited(kind(), &text);
    let program = Program::from_typed(&text).unwrap_or_else(|_| numbered(&text));
    stored(&program);
    let mut renumbered = program.clone();
    if renumbered.renumber(100, 3).is_ok() {
        assert_eq!(renumbered.lines().count(), program.lines().count());
        stored(&renumbered);
    }
    let listing = latin1::text(&program.to_text());
    edited(kind(), &listing);
    executed(&listing);
}

/// Bytes as typed on the console. ESC and a letter do what does not come through the console: see [`Card::outside`].
///
/// # Panics
/// If something is not as it must be.
pub fn mc600_console(data: &[u8]) {
    let Some((&options, typed)) = data.split_first() else {
        return;
    };
    let speed = ["1", "10", "30", "3"][usize::from(options & 3)];
    let locked = ["no", "yes"][usize::from(options >> 2 & 1)];
    let mut card = Card::new(&[("speed", speed), ("locked", locked)]);
    let mut typed = typed.iter().take(LONGEST_TYPED);
    while let Some(&byte) = typed.next()
        && card.bench.now() < LONGEST_SESSION
    {
        match (byte, byte == ESCAPE) {
            (_, true) => card.outside(typed.next().copied()),
            (byte, false) => drop(card.bench.send(card.line, &[byte])),
        }
    }
    card.settle();
    card.bench.power(card.station, true);
    card.bench.set_line(card.line, LineSettings::new(9600));
    // A receiver that is set right in the middle of a stream finds its step in the pause that Ctrl-C makes.
    card.bench.send_urgent(card.line, &[CTRL_C]);
    card.run(100);
    if card.interrupt() == At::Password {
        let password = card.password();
        card.answer(&password);
    }
    card.answer(b"NEW");
    let answer = card.answer(b"PRINT 7*6");
    let expected = b"\r\n 42 \r\n>";
    assert!(answer.ends_with(expected), "{:?}", latin1::text(&answer));
}

/// Bytes as a scenario, and as every file that it mentions.
///
/// # Panics
/// If something is not as it must be.
pub fn scenario(data: &[u8]) {
    let text = program_text(data);
    let lines = text.lines().count();
    let scenario = match Scenario::parse(&text) {
        Ok(scenario) => scenario,
        Err(problem) => {
            assert!(
                (1..=lines.max(1)).contains(&(problem.line as usize)),
                "{problem:?}"
            );
            assert!(!problem.message.is_empty());
            return;
        }
    };
    if text.matches("bench").count() > MOST_STATIONS {
        return;
    }
    let limits = Limits {
        simulated: Nanos::from_millis(500),
        executed: 500,
    };
    let run = || scenario.run_within(limits, &mut |_| Ok(data.to_vec()));
    let report = run();
    assert_eq!(run(), report, "not the same a second time");
    assert!((report.line as usize) <= lines);
    assert_eq!(report.message.is_empty(), report.outcome == Outcome::Held);
    assert!(report.simulated <= limits.simulated);
}

/// Typed bytes that are looked at: about four seconds of the line.
const LONGEST_TYPED: usize = 4096;
/// Simulated time after which no more is typed: XOFF may hold back every byte.
const LONGEST_SESSION: Nanos = Nanos::from_millis(10_000);
/// Stations of a scenario that is run.
const MOST_STATIONS: usize = 4;
const ESCAPE: u8 = 0x1B;
const CTRL_C: u8 = 0x03;

fn kind() -> &'static Kind {
    catalog::kind("mc600").expect("the catalogue has it")
}

/// What the editor asks of a text: every place lies inside it.
fn edited(kind: &Kind, text: &str) {
    let lines: Vec<&[u8]> = split_lines(text.as_bytes()).collect();
    let length = |line: u32| {
        let line = lines
            .get(line as usize)
            .expect("the line is one of the text");
        String::from_utf8_lossy(line).chars().count()
    };
    let inside = |span: Span, length: usize| span.start <= span.end && span.end as usize <= length;
    for found in (kind.diagnose)(text) {
        let length = length(found.line);
        assert!(inside(found.span, length), "{found:?} in {length}");
        assert!(!found.message.is_empty() && !found.cause.is_empty());
        let cure = found.cure.as_ref();
        assert!(
            cure.is_none_or(|cure| inside(cure.span, length)),
            "{found:?}"
        );
    }
    for line in text.lines() {
        let mut last = 0;
        for part in (kind.highlight)(line) {
            assert!(part.span.start >= last && !part.span.is_empty(), "{part:?}");
            last = part.span.end;
        }
        assert!(last as usize <= line.chars().count());
    }
}

/// The lines of any text that can be those of a program, numbered.
fn numbered(text: &str) -> Program {
    let mut program = Program::default();
    let lines = latin1::bytes(text);
    for (number, line) in (10..).step_by(10).zip(split_lines(&lines).take(1000)) {
        let digits = line.iter().take_while(|byte| byte.is_ascii_digit()).count();
        let body = &line[digits..line.len().min(75).max(digits)];
        if digits < 6 {
            program.enter(number, &[b" ", body].concat());
        }
    }
    program
}

/// What LIST shows and SAVE writes loads again and shows the same.
fn stored(program: &Program) {
    let listing = program.to_text();
    let loaded = Program::from_text(&listing, STORED_LENGTH).expect("a listing is a program");
    let again = loaded.to_text();
    assert_eq!(latin1::text(&again), latin1::text(&listing));
}

/// Runs a program for a while, stops it, and lists, saves, renumbers and loads what is left.
fn executed(listing: &str) {
    let mut card = Card::new(&[("speed", "50")]);
    card.run(20);
    let station = card.controller();
    if station.load(&Slot::Program, listing).is_err() {
        // A full line that began with a number and no blank is one longer as listed: the console would not take it.
        return;
    }
    assert_eq!(station.listing(&Slot::Program).as_deref(), Some(listing));
    card.send(b"RUN\r");
    card.run(200);
    card.send(b"1,-2.5,X\r\"A\",&H1F,1E9\r");
    card.run(100);
    card.interrupt();
    card.send(b"LIST\r");
    card.run(60);
    card.interrupt();
    card.send(b"CONT\r");
    card.run(60);
    card.interrupt();
    let before = card
        .controller()
        .listing(&Slot::Program)
        .unwrap_or_default();
    let saved = Slot::File("B:F0Z9.BAS".to_owned());
    card.answer(b"SAVE \"B:F0Z9\"");
    if card.controller().listing(&saved).as_ref() != Some(&before) {
        // The program has filled the disk.
        return;
    }
    card.answer(b"RENUM 1,1");
    card.answer(b"NEW");
    assert_eq!(
        card.controller().listing(&Slot::Program).as_deref(),
        Some("")
    );
    card.answer(b"LOAD \"B:F0Z9\"");
    assert_eq!(card.controller().listing(&Slot::Program), Some(before));
}

/// What the card waits for after Ctrl-C.
#[derive(PartialEq)]
enum At {
    Prompt,
    Password,
}

/// A card on the bench, switched on, and its console.
struct Card {
    bench: Bench,
    probe: Probe,
    station: usize,
    line: usize,
}

impl Card {
    fn new(options: &[(&str, &str)]) -> Card {
        let options: Vec<(String, String)> = options
            .iter()
            .map(|&(key, value)| (key.to_owned(), value.to_owned()))
            .collect();
        let station = kind().create(&options).expect("the options are the card's");
        let mut bench = Bench::new();
        let station = bench.add("card", station, None);
        let line = bench.line_of(station).expect("it is on the bench");
        bench.power(station, true);
        Card {
            bench,
            probe: Probe::default(),
            station,
            line,
        }
    }

    fn controller(&mut self) -> &mut dyn Controller {
        self.bench
            .station_mut(self.station)
            .expect("it is on the bench")
    }

    fn status(&self) -> Status {
        let station = self.bench.station(self.station);
        station.expect("it is on the bench").status()
    }

    fn send(&mut self, bytes: &[u8]) {
        assert_eq!(self.bench.send(self.line, bytes), bytes.len());
    }

    fn run(&mut self, ms: u64) {
        let until = self.bench.now() + Nanos::from_millis(ms);
        self.bench.run_until(until, &mut self.probe);
    }

    /// The console's output since the last call.
    fn output(&mut self) -> Vec<u8> {
        self.probe
            .console
            .drain(..)
            .map(|received| received.byte)
            .collect()
    }

    /// Lets everything that was typed arrive, unless the card holds it back.
    fn settle(&mut self) {
        let mut rounds = 0;
        while self.bench.host_pending(self.line) > 0 && rounds < 60 {
            self.run(100);
            self.probe.console.clear();
            rounds += 1;
        }
        self.run(20);
    }

    /// Does what the byte behind an ESC says.
    fn outside(&mut self, what: Option<u8>) {
        self.settle();
        match what {
            Some(b'p') => {
                self.bench.power(self.station, false);
                self.run(10);
                self.bench.power(self.station, true);
            }
            Some(b'o') => self.bench.power(self.station, false),
            Some(b'b') => self.bench.send_break(self.line),
            Some(b'c') => self.bench.send_urgent(self.line, &[CTRL_C]),
            Some(b'r') => self.run(50),
            Some(b's') => self.bench.set_line(self.line, LineSettings::new(4800)),
            Some(b'e') => {
                let parity = Parity::Even;
                let settings = LineSettings {
                    parity,
                    ..LineSettings::new(9600)
                };
                self.bench.set_line(self.line, settings);
            }
            Some(digit @ b'0'..=b'9') => {
                let name = format!("in{}", digit - b'0');
                let value = f64::from(digit & 1);
                self.input(Input::Wire { name, value });
            }
            Some(fault @ b'A'..=b'L') => {
                let faults = self.controller().info().faults.clone();
                let index = usize::from(fault - b'A');
                let kind = faults[index % faults.len()].to_owned();
                let active = index < faults.len();
                // A fault of the drive by its number.
                let axis = (kind == "internal").then(|| "13".to_owned());
                self.input(Input::Fault { kind, axis, active });
            }
            _ => self.send(&[ESCAPE]),
        }
    }

    fn input(&mut self, input: Input) {
        self.bench.input(self.station, input).expect("it has that");
    }

    /// Ctrl-C: 50 ms after it has arrived the prompt is back, the line's time for the message apart; before the
    /// password that is the question for it.
    fn interrupt(&mut self) -> At {
        self.probe.console.clear();
        self.bench.send_urgent(self.line, &[CTRL_C]);
        let character = 11.0 / 9600.0;
        // One is on the wire already.
        let arrived = self.bench.now() + Nanos::from_seconds(2.0 * character);
        let message = "\r\nBREAK IN 63999\r\nPASSWORD? ".len() as f64;
        let limit = arrived + Nanos::from_millis(50) + Nanos::from_seconds(message * character);
        self.bench.run_until(limit, &mut self.probe);
        let output = self.output();
        assert_eq!(self.bench.host_pending(self.line), 0);
        if output.ends_with(b">") {
            At::Prompt
        } else if output.ends_with(b"PASSWORD? ") {
            At::Password
        } else {
            panic!("{:?} {:?}", latin1::text(&output), self.status());
        }
    }

    /// The password that it has now: what was typed may have changed it.
    fn password(&self) -> Vec<u8> {
        let station = self.bench.station(self.station).unwrap();
        let memory = station.memory(Survives::MainsSwitch);
        let changed = memory
            .items
            .into_iter()
            .find(|item| item.name == "PASSWORD");
        changed.map_or(b"PASSWORD".to_vec(), |item| item.bytes)
    }

    /// Types a line at the prompt and gives what the card sends until it is there again.
    fn answer(&mut self, line: &[u8]) -> Vec<u8> {
        self.output();
        self.send(line);
        self.send(b"\r");
        for _ in 0..100 {
            self.run(20);
            let status = self.status();
            if status.at_prompt && status.unsent == 0 && self.bench.is_quiet() {
                return self.output();
            }
        }
        let output = latin1::text(&self.output());
        panic!(
            "no prompt after {:?}: {output:?} {:?}",
            latin1::text(line),
            self.status()
        );
    }
}
