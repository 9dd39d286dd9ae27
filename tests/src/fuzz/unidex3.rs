//! What the fuzzers of the Unidex do with their bytes.

use motionbench_core::bench::Bench;
use motionbench_core::catalog::{self, Kind};
use motionbench_core::controller::{Control, Controller, Debug, Input, Slot, Survives};
use motionbench_core::ieee488::Order;
use motionbench_core::language::latin1;
use motionbench_core::probe::Probe;
use motionbench_core::scenario::program_text;
use motionbench_core::serial::{Flow, LineSettings};
use motionbench_core::time::Nanos;

use super::{LONGEST_SESSION, LONGEST_TYPED, edited};

/// Between these, bytes go to the serial line and not to the keys.
const LINE: u8 = 0xFF;
/// Keys for the bytes below the blank; 10 is EXC, as a line's end.
const FUNCTIONS: [&str; 32] = [
    "RES", "EDT", "AUT", "SGL", "IMD", "RMT", "PRT", "STP", "BST", "SLW", "EXC", "CE", "CC", "EXC",
    "SCH", "SHIFT", "UP", "DOWN", "LEFT", "RIGHT", "CLRX", "CLRY", "SHIFT", "EDT", "AUT", "SGL",
    "IMD", "RMT", "EXC", "STP", "SLW", "CE",
];

/// Wires that do not stand at 0 on a new bench.
const WIRES: [(&str, f64); 25] = [
    ("ADDRESS", 1.0),
    ("PPR", 1.0),
    ("LAST", 1.0),
    ("BAUD", 9600.0),
    ("BITS", 8.0),
    ("STOP", 1.0),
    ("OEM", 1.0),
    ("CONFIG", 1.0),
    ("JP5", 1.0),
    ("JP7", 1.0),
    ("JP20", 1.0),
    ("JP21", 1.0),
    ("JP22", 1.0),
    ("JP23", 1.0),
    ("JP37", 1.0),
    ("JP46", 1.0),
    ("JP47", 1.0),
    ("KEYBOARD", 1.0),
    ("C1", 1.0),
    ("C2", 1.0),
    ("C3", 1.0),
    ("C4", 1.0),
    ("clock", 1.0),
    ("feedholdx", 1.0),
    ("feedholdy", 1.0),
];

/// What the controller of the bus may be asked.
fn orders() -> [Order; 16] {
    let send = |text: &str| Order::Send(text.as_bytes().to_vec(), true);
    [
        Order::RemoteEnable(true),
        Order::Listen(vec![1]),
        send("I X1000 F5000 Y-1000 F5000\r\n"),
        Order::SerialPoll(1),
        send("P00\r\n"),
        Order::Talk(1),
        Order::ParallelPoll,
        send("E 01\r\nX10*\"A;B\"G25*;C\r\n%\r\nA 01H\r\n"),
        Order::Trigger(vec![1]),
        Order::InterfaceClear,
        Order::Clear(Vec::new()),
        Order::Clear(vec![1, 2]),
        Order::GoToLocal(vec![1]),
        Order::LocalLockout,
        Order::RemoteEnable(false),
        Order::Listen(Vec::new()),
    ]
}

fn kind() -> &'static Kind {
    catalog::kind("unidex3").expect("the catalogue has it")
}

/// Bytes as the text of a program: in the editor, loaded, run, printed, kept without power.
///
/// # Panics
/// If something is not as it must be.
pub fn unidex3_text(data: &[u8]) {
    let text = program_text(data);
    edited(kind(), &text);
    text.lines().for_each(|line| drop((kind().words)(line)));
    let mut unit = Unit::new(&[("speed", "50"), ("memory", "28k")]);
    let slot = Slot::Number(1);
    if unit.station().load(&slot, &text).is_err() {
        return;
    }
    unit.run(5000);
    unit.press("AUT");
    unit.press("EXC");
    unit.run(200);
    unit.press("EXC");
    unit.run(100);
    let listing = unit.station().listing(&slot).expect("it is there");
    // What it lists is the same program.
    unit.station().load(&slot, &listing).expect("it has room");
    assert_eq!(unit.station().listing(&slot), Some(listing.clone()));
    let kept = unit.station().memory(Survives::MainsSwitch);
    let mut other = Unit::new(&[("memory", "28k")]);
    other.station().restore(&kept);
    assert_eq!(other.station().listing(&slot), Some(listing));
    unit.recover();
}

/// Bytes as keys, and between two FFh on the line; above 7Fh what happens to a unit besides.
///
/// # Panics
/// If something is not as it must be.
pub fn unidex3_keys(data: &[u8]) {
    let mut unit = Unit::new(&[("speed", "10")]);
    unit.run(2000);
    let mut on_line = false;
    for &byte in data.iter().take(LONGEST_TYPED) {
        if unit.bench.now() >= LONGEST_SESSION {
            break;
        }
        match byte {
            LINE => on_line = !on_line,
            byte if on_line => drop(unit.bench.send(0, &[byte])),
            byte @ 0..0x80 => {
                let character = char::from(byte).to_string();
                let function = FUNCTIONS.get(usize::from(byte)).copied();
                unit.press(function.unwrap_or(&character));
            }
            byte => unit.outside(byte & 0x7F),
        }
    }
    unit.run(500);
    unit.recover();
}

/// One unit, switched on.
struct Unit {
    bench: Bench,
    probe: Probe,
    /// Of what has happened outside: more can happen than a byte can say.
    past: usize,
}

impl Unit {
    fn new(options: &[(&str, &str)]) -> Unit {
        let options: Vec<(String, String)> = options
            .iter()
            .map(|&(key, value)| (key.to_owned(), value.to_owned()))
            .collect();
        let mut bench = Bench::new();
        let station = kind().create(&options).expect("the options are the unit's");
        bench.add("unit", station, None);
        bench.power(0, true);
        Unit {
            bench,
            probe: Probe::default(),
            past: 0,
        }
    }

    fn station(&mut self) -> &mut dyn Controller {
        self.bench.station_mut(0).expect("it is on the bench")
    }

    fn run(&mut self, ms: u64) {
        let until = self.bench.now() + Nanos::from_millis(ms);
        self.bench.run_until(until, &mut self.probe);
        let panel = self.station().panel().expect("it has one");
        assert_eq!(panel.display.chars().count(), 8);
        assert!(self.probe.console.len() < 1 << 20);
    }

    /// A key; not every character has one.
    fn press(&mut self, key: &str) {
        for down in [true, false] {
            let key = key.to_owned();
            let _ = self.bench.input(0, Input::Key { key, down });
        }
    }

    fn fault(&mut self, index: usize, active: bool) {
        let faults = self.station().info().faults.clone();
        let kind = faults[index % faults.len()].to_owned();
        let axis = (kind == "internal").then(|| "17".to_owned());
        let fault = Input::Fault { kind, axis, active };
        self.bench.input(0, fault).expect("it has that");
    }

    fn outside(&mut self, what: u8) {
        let index = usize::from(what % 16);
        self.past = (self.past % 64) * 16 + index;
        let past = self.past;
        match what / 16 {
            0 => self.run(u64::from(what) * 10 + 1),
            1 => {
                let wires = self.station().info().wires.clone();
                let name = wires[past % wires.len()].clone();
                let value = [0.0, 1.0, 2.0, 4.0, 9600.0, -100.0, 5000.0][past % 7];
                let _ = self.bench.input(0, Input::Wire { name, value });
            }
            2 => self.fault(index, true),
            3 => self.fault(index, false),
            4 => {
                self.bench.power(0, false);
                self.run(10);
                self.bench.power(0, true);
            }
            5 => {
                let key = ["UP", "DOWN", "LEFT", "RIGHT"][index % 4].to_owned();
                let down = index < 8;
                self.bench
                    .input(0, Input::Key { key, down })
                    .expect("a key");
            }
            6 => {
                let commands = [
                    Debug::Control(Control::Pause),
                    Debug::Control(Control::Step),
                    Debug::Control(Control::Continue),
                    Debug::Breakpoints(vec![1, 2]),
                ];
                for command in commands {
                    self.station().debug(command);
                }
                self.station().debug(Debug::Control(Control::Continue));
            }
            _ if index == 0 => self.run(1000),
            _ => self.bench.order(&orders()[index]).expect("it has a bus"),
        }
    }

    /// After the mains switch a unit that is whole takes keys, and answers.
    fn recover(&mut self) {
        for index in 0..self.station().info().faults.len() {
            self.fault(index, false);
        }
        self.station().debug(Debug::Breakpoints(Vec::new()));
        self.bench.power(0, false);
        self.bench.cancel(0);
        let settings = LineSettings {
            flow: Flow::None,
            ..LineSettings::new(9600)
        };
        self.bench.set_line(0, settings);
        for name in self.station().info().wires.clone() {
            let known = WIRES.iter().find(|(wire, _)| *wire == name);
            let value = known.map_or(0.0, |&(_, value)| value);
            // One of them is the selector of a panel that this unit does not share.
            let _ = self.bench.input(0, Input::Wire { name, value });
        }
        self.bench
            .order(&Order::InterfaceClear)
            .expect("it has a bus");
        self.bench
            .order(&Order::RemoteEnable(false))
            .expect("it has a bus");
        self.run(100);
        // No boot-strap program starts behind a reset.
        self.bench.power(0, true);
        self.press("RES");
        self.run(8000);
        for key in ["RMT", "EDT", "CC", "0", "0", "EXC"] {
            self.press(key);
        }
        let shown = self.station().panel().expect("it has one").display;
        assert_eq!(shown.trim(), "CLEARED");
        self.press("RMT");
        self.run(10);
        self.probe.console.clear();
        self.bench.send(0, b"\r\n\x1B1\r\nPX1\r\n");
        self.run(100);
        let output: Vec<u8> = self.probe.console.drain(..).map(|r| r.byte).collect();
        let answer = b"X0000000000\r\n";
        assert!(output.ends_with(answer), "{:?}", latin1::text(&output));
    }
}
