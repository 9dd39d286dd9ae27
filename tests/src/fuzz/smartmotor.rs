//! What the fuzzers of the SmartMotor do with their bytes.

use motionbench_core::bench::Bench;
use motionbench_core::catalog::{self, Kind};
use motionbench_core::controller::{
    Control, Controller, Debug, DebugReply, Input, Slot, Survives, Value,
};
use motionbench_core::language::{latin1, split_lines};
use motionbench_core::probe::Probe;
use motionbench_core::scenario::program_text;
use motionbench_core::serial::{Flow, LineSettings, Parity};
use motionbench_core::smartmotor::store::strip;
use motionbench_core::time::Nanos;

use super::{ESCAPE, LONGEST_SESSION, LONGEST_TYPED, edited};

/// The answer to what every motor understands, whatever has happened to it before.
const SIX: &[u8] = b"6\r";

fn kind() -> &'static Kind {
    catalog::kind("smartmotor").expect("the catalogue has it")
}

/// Bytes as the text of a program: in the editor, downloaded, sent by LOAD, run, sent back, kept without power.
///
/// # Panics
/// If something is not as it must be.
pub fn smartmotor_text(data: &[u8]) {
    let text = program_text(data);
    edited(kind(), &text);
    let source = latin1::bytes(&text);
    let stripped = strip(&source);
    assert_eq!(strip(&stripped.text).text, stripped.text);
    assert_eq!(stripped.lines.len(), split_lines(&source).count());
    let mut chain = Chain::new(&[("speed", "50")], 1);
    chain.run(20);
    let sound = (kind().diagnose)(&text).is_empty();
    let loaded = chain.motor(0).load(&Slot::Program, &text);
    // The vendor's compiler and the editor object to the same programs.
    assert_eq!(loaded.is_ok(), sound, "{loaded:?}");
    if !sound {
        // The motor takes anything that the line brings.
        let sent: Vec<u8> = source.iter().map(|&byte| byte.min(0xFE)).collect();
        chain.send(b"LOAD\r");
        chain.run(10);
        chain.send(&sent[..sent.len().min(2000)]);
        chain.send(b"\xFF");
        chain.settle();
    }
    let listing = chain.motor(0).listing(&Slot::Program);
    chain.send(b"RUN\r");
    chain.run(200);
    chain.send(b"12\r");
    chain.run(100);
    chain.recover();
    assert_eq!(chain.motor(0).listing(&Slot::Program), listing);
    let kept = chain.motor(0).memory(Survives::MainsSwitch);
    let mut other = Chain::new(&[], 1);
    other.motor(0).restore(&kept);
    assert_eq!(other.motor(0).listing(&Slot::Program), listing);
}

/// Bytes on the host's line of three motors in a chain. ESC and a letter do what does not come through the line.
///
/// # Panics
/// If something is not as it must be.
pub fn smartmotor_serial(data: &[u8]) {
    let Some((&options, typed)) = data.split_first() else {
        return;
    };
    let speed = ["1", "10", "30", "3"][usize::from(options & 3)];
    let echo = ["no", "yes"][usize::from(options >> 2 & 1)];
    let mut chain = Chain::new(&[("speed", speed), ("echo", echo)], 3);
    if options & 8 != 0 {
        chain.run(300);
    }
    let mut typed = typed.iter().take(LONGEST_TYPED);
    while let Some(&byte) = typed.next()
        && chain.bench.now() < LONGEST_SESSION
    {
        match byte {
            ESCAPE => chain.outside(typed.next().copied()),
            byte => chain.send(&[byte]),
        }
    }
    chain.settle();
    chain.recover();
}

/// The host's side of the line: a motor knows no flow control, and what it sends may well be an XOFF.
fn at(baud: u32) -> LineSettings {
    LineSettings {
        flow: Flow::None,
        ..LineSettings::new(baud)
    }
}

/// Motors on one line, switched on.
struct Chain {
    bench: Bench,
    probe: Probe,
}

impl Chain {
    fn new(options: &[(&str, &str)], motors: usize) -> Chain {
        let options: Vec<(String, String)> = options
            .iter()
            .map(|&(key, value)| (key.to_owned(), value.to_owned()))
            .collect();
        let mut bench = Bench::new();
        for index in 0..motors {
            let station = kind()
                .create(&options)
                .expect("the options are the motor's");
            bench.add("motor", station, (index > 0).then_some(0));
            bench.power(index, true);
        }
        Chain {
            bench,
            probe: Probe::default(),
        }
    }

    fn motor(&mut self, index: usize) -> &mut dyn Controller {
        self.bench.station_mut(index).expect("it is on the bench")
    }

    fn send(&mut self, bytes: &[u8]) {
        assert_eq!(self.bench.send(0, bytes), bytes.len());
    }

    fn run(&mut self, ms: u64) {
        let until = self.bench.now() + Nanos::from_millis(ms);
        self.bench.run_until(until, &mut self.probe);
    }

    /// Lets everything that was sent arrive.
    fn settle(&mut self) {
        while self.bench.host_pending(0) > 0 {
            self.run(100);
        }
        self.probe.console.clear();
        self.run(20);
    }

    /// Does what the byte behind an ESC says.
    fn outside(&mut self, what: Option<u8>) {
        self.settle();
        match what {
            Some(b'p') => {
                self.bench.power(0, false);
                self.run(10);
                self.bench.power(0, true);
            }
            Some(b'o') => self.bench.power(1, false),
            Some(b'b') => self.bench.send_break(0),
            Some(b'r') => self.run(50),
            Some(b's') => self.bench.set_line(0, at(19_200)),
            Some(b'e') => {
                let settings = LineSettings {
                    parity: Parity::Even,
                    ..at(9600)
                };
                self.bench.set_line(0, settings);
            }
            Some(b'd') => {
                let commands = [
                    Debug::Control(Control::Pause),
                    Debug::Control(Control::Step),
                    Debug::Control(Control::Continue),
                    Debug::Breakpoints(vec![1, 3]),
                ];
                for command in commands {
                    self.motor(0).debug(command);
                }
            }
            Some(b'w') => {
                for (name, value) in [("al[2]", -5.0), ("P", 1e12), ("V", 3e5), ("b", 0.5)] {
                    let write = Debug::Write(name.to_owned(), Value::Number(value));
                    self.motor(0).debug(write);
                    self.motor(0).debug(Debug::Read(name.to_owned()));
                }
            }
            Some(digit @ b'0'..=b'9') => {
                let wires = self.motor(0).info().wires.clone();
                let name = wires[usize::from(digit) % wires.len()].clone();
                let value = f64::from(digit & 1);
                self.input(Input::Wire { name, value });
            }
            Some(fault @ b'A'..=b'N') => {
                let faults = self.motor(0).info().faults.clone();
                let index = usize::from(fault - b'A');
                let kind = faults[index % faults.len()].to_owned();
                let active = index < faults.len();
                let axis = None;
                self.input(Input::Fault { kind, axis, active });
            }
            _ => self.send(&[ESCAPE]),
        }
    }

    fn input(&mut self, input: Input) {
        self.bench.input(0, input).expect("it has that");
    }

    /// After the mains switch, with the line set right, every motor answers, and END stops what runs.
    fn recover(&mut self) {
        let motors = self.bench.len();
        for index in 0..motors {
            self.motor(index).debug(Debug::Breakpoints(Vec::new()));
            self.bench.power(index, false);
        }
        self.bench.set_line(0, at(9600));
        self.run(50);
        for index in 0..motors {
            self.bench.power(index, true);
        }
        self.run(50);
        // Within the first 200 ms: no program starts. The echo of the ones before reaches the next.
        for _ in 0..motors {
            self.send(b"\r\x80ECHO\rEND\r");
            self.run(60);
        }
        self.probe.console.clear();
        self.send(b"a=2 b=a*3 Rb\r");
        self.run(100);
        let output: Vec<u8> = self.probe.console.drain(..).map(|r| r.byte).collect();
        assert!(output.ends_with(SIX), "{:?}", latin1::text(&output));
        for index in 0..motors {
            let read = self.motor(index).debug(Debug::Read("b".to_owned()));
            assert_eq!(read, DebugReply::Value(Value::Number(6.0)), "{index}");
        }
    }
}
