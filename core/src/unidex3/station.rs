//! The Unidex as a station on the bench.

use super::firmware::SAMPLE;
use super::indexer::{Axis, AxisSignals, FAULTS, Indexer};
use super::memory::DEFAULT_PROGRAM;
use super::panel::{Edit, Mode};
use super::run::{Register, Wait};
use super::trouble::Trouble;
use super::words::packed;
use super::{Busy, Options, Unidex3, keys, listing, switches};
use crate::controller::{
    Controller, ControllerInfo, Debug, DebugReply, HandsOn, Input, LoadError, Memory, MemoryItem,
    Output, Panel, Ports, Refused, Revision, RunState, Sharing, Signal, Slot, Status, Survives,
    Value,
};
use crate::exec;
use crate::ieee488::Lines;
use crate::language::{latin1, split_lines};
use crate::time::Nanos;

/// The version of the items below.
const MEMORY_VERSION: u32 = 1;
/// In front of a program's number.
const PROGRAM_ITEM: &str = "PROGRAM ";
const SETTINGS_ITEM: &str = "SETTINGS";
/// Faults of the unit itself.
const OWN_FAULTS: [&str; 5] = ["rom", "sram", "uram", "battery", "internal"];
/// The RTS line of the unit behind in the daisy chain.
const RTS_WIRE: &str = "RTS";

/// What a Unidex is and what it has.
pub(super) fn info(options: &Options) -> ControllerInfo {
    let axis_signals = [
        ("position", "steps"),
        ("command", "steps"),
        ("velocity", "steps/s"),
        ("rate", "steps/s"),
        ("acceleration", "steps/s^2"),
        ("error", "steps"),
        ("output", "of peak"),
        ("shaft", "revolutions"),
        ("clocked", "steps"),
        ("tracking", "steps"),
    ];
    let signal = |name: String, unit: &str| Signal {
        name,
        unit: unit.to_owned(),
    };
    let mut signals = Vec::new();
    for axis in ["x", "y"] {
        let of_axis = axis_signals.iter();
        signals.extend(of_axis.map(|(name, unit)| signal(format!("{axis}.{name}"), unit)));
    }
    for name in ["m", "c", "flags"] {
        signals.push(signal(name.to_owned(), "bits"));
    }
    for name in ["strobe", "rts"] {
        signals.push(signal(name.to_owned(), "level"));
    }
    let mut wires = Indexer::wires();
    wires.extend(switches::names());
    wires.push(RTS_WIRE.to_owned());
    ControllerInfo {
        id: "unidex3",
        name: "Aerotech Unidex IIIa",
        axes: vec!["x", "y"],
        line: options.line,
        prompt: "",
        // Clears all units, without a self-test.
        attention: b"\x1BC\r",
        // Addresses the unit, answers what it may have requested, and runs program 1.
        start: format!("\u{1b}{:02}\rQ\rA 01", options.address),
        hands_on: Some(HandsOn {
            stop: "RES",
            listen: "RMT",
        }),
        program_slot: Slot::Number(u16::from(DEFAULT_PROGRAM)),
        signals,
        wires,
        faults: FAULTS.into_iter().chain(OWN_FAULTS).collect(),
        keys: keys::NAMES.to_vec(),
        sample: SAMPLE,
        sharing: Sharing::Bus,
        panel_selector: options.shares_panel.then_some(switches::PAIR),
    }
}

impl Controller for Unidex3 {
    fn info(&self) -> &ControllerInfo {
        &self.info
    }

    fn power(&mut self, at: Nanos, on: bool) {
        if on && !self.powered {
            self.power_up(at);
        } else if !on && self.powered {
            self.indexer.power_off(at);
            self.executing = false;
            self.busy = None;
            self.run.outputs = 0;
        }
        self.powered = on;
    }

    fn next(&self) -> Nanos {
        self.next
    }

    fn input(&mut self, at: Nanos, input: Input) -> Result<(), Refused> {
        match input {
            Input::Frame { connector, frame } => {
                if self.powered && connector == 0 {
                    self.line.accept(frame);
                }
                Ok(())
            }
            Input::Wire { name, value } if switches::is_switch(&name) => {
                self.set_switch(at, &name, value).map_err(Refused)
            }
            Input::Wire { name, value } if name == RTS_WIRE => {
                self.remote.set_behind(value != 0.0);
                Ok(())
            }
            Input::Wire { name, value } => self.indexer.wire(at, &name, value).map_err(Refused),
            Input::Fault { kind, axis, active } => self.break_or_mend(at, &kind, axis, active),
            Input::Plant { axis, key, value } => self
                .indexer
                .configure(at, &axis, &key, &value)
                .map_err(Refused),
            Input::Key { key, down } => self.key(at, &key, down),
            Input::Telegram(_) => Ok(()),
            Input::Ieee488(message) => {
                self.bus_message(message);
                Ok(())
            }
        }
    }

    fn sample(&mut self, now: Nanos, ports: &mut Ports) {
        self.next = now + SAMPLE;
        self.strobed = false;
        self.indexer.sample(now);
        if !self.powered {
            // What happened to a unit that is off is not told later.
            while self.indexer.take_event().is_some() {}
            return self.raise_rts(ports);
        }
        let strobes = self.run.strobes;
        self.line.receive(now);
        self.busy_sample(now);
        self.remote_sample(now);
        self.execute_sample(now, ports.log_motion);
        self.strobed = self.run.strobes != strobes;
        self.line.transmit(now, self.next, ports);
        self.raise_rts(ports);
        let log = self.log.drain(..).map(|command| (now, command));
        ports.motion.extend(log);
    }

    fn record(&self, row: &mut Vec<f64>) {
        for axis in Axis::BOTH {
            let AxisSignals {
                register,
                position,
                rate,
                velocity,
                acceleration,
                error,
                output,
                shaft,
                clocked,
            } = self.indexer.signals(axis);
            row.extend([
                register,
                register,
                velocity,
                rate,
                acceleration,
                error,
                output,
                shaft,
                clocked,
                position,
            ]);
        }
        let inputs = (1..=4).map(|input| u8::from(self.indexer.input(input)) << (input - 1));
        row.extend([self.run.outputs, inputs.sum(), self.run.flags].map(f64::from));
        row.extend([self.strobed, self.rts()].map(|on| f64::from(u8::from(on))));
    }

    fn status(&self) -> Status {
        Status {
            power: self.powered,
            run: self.run_state(),
            line: self.device_line(),
            spent: self.credit.spent,
            unread: self.line.unread() + self.remote.unread() + self.unread_on_bus(),
            unsent: self.line.unsent(),
            moving: self.indexer.is_moving(),
            enabled: self.powered && self.indexer.is_enabled(),
            fault: self.indexer.fault_words(),
            at_prompt: self.powered && !self.executing && !self.remote.is_typing(),
            listens: self.listens(),
            error: self.errors.any().then(|| self.last_error.clone()).flatten(),
            revision: self.memory.revision,
        }
    }

    fn panel(&self) -> Option<Panel> {
        // A shared panel shows the unit that it is switched to.
        (!self.options.shares_panel || self.has_keyboard()).then(|| self.shown())
    }

    fn ieee488(&self) -> Option<Lines> {
        Some(self.bus_lines())
    }

    fn debug(&mut self, command: Debug) -> DebugReply {
        match command {
            Debug::Breakpoints(lines) => {
                self.debugger.breakpoints = lines;
                DebugReply::Done
            }
            Debug::Control(control) => {
                let spent = self.credit.spent;
                self.debugger.hold.obey(control, self.executing, spent)
            }
            Debug::Read(name) => match self.read(&name) {
                Some(value) => DebugReply::Value(value),
                None => DebugReply::Refused(format!("unidex3 has no variable or signal '{name}'")),
            },
            Debug::Write(name, value) => match (Register::from_name(name.as_bytes()), value) {
                (Some(register), Value::Number(number)) if number.abs() <= 2e9 => {
                    #[allow(clippy::cast_possible_truncation)] // within 2,000,000,000
                    let value = number as i64;
                    self.run
                        .set_register(register, value, &mut self.indexer, self.next);
                    DebugReply::Done
                }
                _ => DebugReply::Refused(format!("unidex3 cannot set '{name}' to that")),
            },
            Debug::Cam => DebugReply::Refused("unidex3 has no cam".to_owned()),
        }
    }

    /// A download by a controller, without the line.
    fn load(&mut self, slot: &Slot, text: &str) -> Result<Revision, LoadError> {
        let refuse = |line: u32, message: String| Err(LoadError { line, message });
        let number = match slot {
            Slot::Program => Some(DEFAULT_PROGRAM),
            Slot::Number(number) => u8::try_from(*number).ok().filter(|n| (1..=99).contains(n)),
            Slot::File(_) => None,
        };
        let Some(number) = number else {
            return refuse(0, "unidex3 has programs 1 to 99, and no files".to_owned());
        };
        let mut in_message = false;
        let source = latin1::bytes(text);
        let program: Vec<u8> = split_lines(&source)
            .flat_map(|line| packed(line, &mut in_message))
            .collect();
        if !self.memory.store(number, &program) {
            return refuse(0, "BUF FULL: the program has no room in memory".to_owned());
        }
        if self.memory.editing.is_none() {
            self.memory.seal();
        }
        if self.panel.edited.number == number
            && matches!(self.panel.mode, Mode::Edit(Edit::Program))
        {
            self.open(number);
        }
        Ok(Revision {
            number: self.memory.revision,
            lines: super::diagnose::device_lines(text),
        })
    }

    fn listing(&self, slot: &Slot) -> Option<String> {
        let number = match slot {
            Slot::Program => DEFAULT_PROGRAM,
            Slot::Number(number) => u8::try_from(*number).ok()?,
            Slot::File(_) => return None,
        };
        let text = self.memory.text(number);
        let lines = text.map(|text| listing::lines(&text)).unwrap_or_default();
        let lines: Vec<String> = lines.iter().map(|line| latin1::text(line)).collect();
        Some(lines.join("\n"))
    }

    /// The battery keeps all of it.
    fn memory(&self, _event: Survives) -> Memory {
        let programs = self.memory.programs().iter();
        let mut items: Vec<MemoryItem> = programs
            .map(|program| MemoryItem {
                name: format!("{PROGRAM_ITEM}{}", program.number),
                bytes: program.text.to_vec(),
            })
            .collect();
        items.push(MemoryItem {
            name: SETTINGS_ITEM.to_owned(),
            bytes: self.memory.settings(),
        });
        items.extend(self.unknown.iter().cloned());
        Memory {
            version: MEMORY_VERSION,
            items,
        }
    }

    fn restore(&mut self, memory: &Memory) {
        self.unknown.clear();
        for item in &memory.items {
            let number = item.name.strip_prefix(PROGRAM_ITEM);
            let number = number.and_then(|number| number.parse().ok());
            let known = memory.version == MEMORY_VERSION
                && match (number, item.name.as_str()) {
                    (Some(number), _) => self.memory.store(number, &item.bytes),
                    (None, SETTINGS_ITEM) => self.memory.set_settings(&item.bytes),
                    _ => false,
                };
            if !known {
                self.unknown.push(item.clone());
            }
        }
        if self.memory.editing.is_none() {
            self.memory.seal();
        }
    }
}

impl Unidex3 {
    /// Tells the unit before this one what the RTS line is, when it changes, and that there is one.
    fn raise_rts(&mut self, ports: &mut Ports) {
        let rts = self.rts();
        if self.rts != Some(rts) {
            self.rts = Some(rts);
            let output = Output::Wire {
                name: RTS_WIRE.to_owned(),
                value: f64::from(u8::from(rts)),
            };
            ports.outputs.push((self.next, output));
        }
    }

    fn rts(&self) -> bool {
        self.powered && self.remote.rts(self.options.last)
    }

    fn run_state(&self) -> RunState {
        let waiting = |wait| match wait {
            Wait::Move => exec::Wait::Motion,
            Wait::Dwell { .. } | Wait::Count | Wait::Stop => exec::Wait::Time,
            Wait::Halt | Wait::Input(_) | Wait::Slew => exec::Wait::Input,
            Wait::Print => exec::Wait::Output,
        };
        match self.busy {
            _ if !self.powered => RunState::Idle,
            Some(Busy::Dead) => RunState::Idle,
            Some(_) => RunState::Command,
            None if !self.executing => RunState::Idle,
            None if self.debugger.hold.holds() => RunState::Paused,
            None => self
                .run
                .wait
                .map_or(RunState::Running, |wait| RunState::Waiting(waiting(wait))),
        }
    }

    fn break_or_mend(
        &mut self,
        at: Nanos,
        kind: &str,
        axis: Option<String>,
        active: bool,
    ) -> Result<(), Refused> {
        match kind {
            "rom" => self.broken.rom = active,
            "sram" => self.broken.system_ram = active,
            "uram" => self.broken.user_ram = active,
            "battery" => self.broken.battery = active,
            "internal" => {
                let number = axis.as_deref().and_then(|axis| axis.parse().ok());
                let number = number.filter(|number| (1..=99).contains(number));
                let Some(number) = number else {
                    return Err(Refused(
                        "an internal error has a number from 1 to 99".to_owned(),
                    ));
                };
                if active && self.powered {
                    self.end_with(at, Trouble::Internal(number));
                }
            }
            _ => {
                return self
                    .indexer
                    .fault(at, kind, axis.as_deref(), active)
                    .map_err(Refused);
            }
        }
        Ok(())
    }

    /// A register, the flags, the outputs, a status byte, or what the line and the panel show.
    fn read(&self, name: &str) -> Option<Value> {
        if let Some(register) = Register::from_name(name.as_bytes()) {
            #[allow(clippy::cast_precision_loss)] // to 2,000,000,000
            let value = self.run.register(register, &self.indexer) as f64;
            return Some(Value::Number(value));
        }
        let bit = |bits: u8, digit: &str| {
            let place = digit
                .parse()
                .ok()
                .filter(|place| (1..=8_u32).contains(place))?;
            Some(Value::Number(f64::from(bits >> (place - 1) & 1)))
        };
        match name {
            "display" => Some(Value::Text(self.shown().display)),
            "message" => Some(Value::Text(latin1::text(&self.run.buffer.0))),
            "free" => Some(Value::Number(f64::from(
                u32::try_from(self.memory.free()).ok()?,
            ))),
            _ if name.starts_with("status") => {
                let place: usize = name.strip_prefix("status")?.parse().ok()?;
                let byte = *self.status_bytes().get(place.checked_sub(1)?)?;
                Some(Value::Number(f64::from(byte)))
            }
            _ => match name.get(..1)? {
                "M" => bit(self.run.outputs, name.get(1..)?),
                "C" => {
                    let inputs = (1..=4).map(|n| u8::from(self.indexer.input(n)) << (n - 1));
                    bit(inputs.sum(), name.get(1..)?)
                }
                _ => bit(self.run.flags, name.strip_prefix("flag")?),
            },
        }
    }
}
