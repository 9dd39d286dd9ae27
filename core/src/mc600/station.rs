//! The MC-600 as a station on the bench.

use super::ast::{Name, VariableKind};
use super::commands::device_line;
use super::disks::FileName;
use super::firmware::SAMPLE;
use super::machine::{FAULTS, Machine, TELEGRAM_TIME};
use super::program::{Program, STORED_LENGTH};
use super::sysvars::SysVar;
use super::value::Text;
use super::{Mc600, Mode, password};
use crate::controller::{
    Controller, ControllerInfo, Debug, DebugReply, Input, LoadError, Memory, MemoryItem, Output,
    Ports, Refused, Revision, RunState, Sharing, Signal, Slot, Status, Survives, Value,
};
use crate::language::latin1;
use crate::serial::LineSettings;
use crate::time::Nanos;

/// The version of the items below.
const MEMORY_VERSION: u32 = 1;
const PASSWORD_ITEM: &str = "PASSWORD";
/// The program in RAM.
const PROGRAM_ITEM: &str = "PROGRAM";

/// What an MC-600 is and what it has.
pub(super) fn info() -> ControllerInfo {
    let signal = |(name, unit): (&str, &str)| Signal {
        name: name.to_owned(),
        unit: unit.to_owned(),
    };
    ControllerInfo {
        id: "mc600",
        name: "Danaher MC-600",
        axes: vec!["x"],
        line: LineSettings::new(9600),
        prompt: ">",
        attention: &[0x03],
        start: "RUN".to_owned(),
        hands_on: None,
        program_slot: Slot::Program,
        signals: [
            ("x.command", "counts"),
            ("x.position", "counts"),
            ("x.velocity", "counts*256/sample"),
            ("x.speed", "counts*256/sample"),
            ("x.acceleration", "counts*256/sample^2"),
            ("x.error", "counts"),
            ("x.output", "of peak torque"),
            ("x.shaft", "revolutions"),
            ("inputs", "bits"),
            ("outputs", "bits"),
        ]
        .map(signal)
        .to_vec(),
        wires: Machine::wires(),
        faults: FAULTS.to_vec(),
        keys: Vec::new(),
        sample: SAMPLE,
        sharing: Sharing::Alone,
        panel_selector: None,
    }
}

impl Controller for Mc600 {
    fn info(&self) -> &ControllerInfo {
        &self.info
    }

    fn power(&mut self, at: Nanos, on: bool) {
        let is_on = self.mode != Mode::Off;
        if on && !is_on {
            self.next = self.next.max(at);
            self.power_up();
        } else if !on && is_on {
            self.mode = Mode::Off;
            self.machine.power_off();
        }
    }

    fn next(&self) -> Nanos {
        self.next
    }

    fn input(&mut self, at: Nanos, input: Input) -> Result<(), Refused> {
        match input {
            Input::Frame { frame, .. } => {
                if self.mode != Mode::Off {
                    self.console.accept(frame);
                }
                Ok(())
            }
            Input::Wire { name, value } => {
                let since = at.since(self.sampled);
                let wired = self.machine.wire_at(&name, value, since);
                wired.map_err(Refused)
            }
            Input::Fault { kind, axis, active } => self
                .machine
                .fault(&kind, axis.as_deref(), active)
                .map_err(Refused),
            Input::Plant { axis, key, value } => {
                self.machine.configure(&axis, &key, &value).map_err(Refused)
            }
            Input::Key { .. } => Err(Refused("mc600 has no panel".to_owned())),
            Input::Ieee488(_) => Err(Refused("mc600 has no IEEE-488 bus".to_owned())),
            Input::Telegram(telegram) => {
                self.machine.receive(&telegram);
                Ok(())
            }
        }
    }

    fn sample(&mut self, now: Nanos, ports: &mut Ports) {
        self.samples += 1;
        (self.sampled, self.next) = (now, now + SAMPLE);
        if self.mode != Mode::Off {
            self.firmware(now, ports);
        }
        self.machine.sample();
        let mut sent = now;
        for telegram in self.machine.send() {
            sent += TELEGRAM_TIME;
            ports.outputs.push((sent, Output::Telegram(telegram)));
        }
        if self.mode != Mode::Off {
            self.console.transmit(now, self.next, ports);
        }
        if ports.log_motion {
            ports
                .motion
                .extend(self.log.drain(..).map(|command| (now, command.to_string())));
        }
    }

    fn record(&self, row: &mut Vec<f64>) {
        let signals = self.machine.signals();
        row.extend([
            signals.demand_position,
            signals.position,
            signals.demand_velocity,
            signals.velocity,
            signals.demand_acceleration,
            signals.following_error,
            signals.output,
            signals.shaft,
            f64::from(signals.inputs),
            f64::from(signals.outputs),
        ]);
    }

    fn status(&self) -> Status {
        let running = self.mode == Mode::Running;
        let line = running.then(|| self.vm.image.line_at(self.vm.pc)).flatten();
        // What a command took may still keep the prompt back.
        let ending = self.mode == Mode::Ready { prompted: false };
        let run = match (running, self.waiting, line) {
            (false, ..) if ending => RunState::Command,
            (false, ..) => RunState::Idle,
            _ if self.debugger.hold.holds() => RunState::Paused,
            (true, Some(wait), _) => RunState::Waiting(wait),
            (true, None, Some(_)) => RunState::Running,
            (true, None, None) => RunState::Command,
        };
        Status {
            power: self.mode != Mode::Off,
            run,
            line: line.map(u32::from),
            spent: self.credit.spent,
            unread: self.console.unread(),
            unsent: self.console.unsent() + usize::from(self.vm.is_printing()),
            moving: self.machine.is_moving(),
            enabled: self.machine.is_enabled(),
            fault: self.machine.fault_words(),
            at_prompt: self.mode == Mode::Ready { prompted: true } && !self.console.is_typing(),
            listens: true,
            error: self.error.clone(),
            revision: self.program.revision(),
        }
    }

    fn debug(&mut self, command: Debug) -> DebugReply {
        match command {
            Debug::Breakpoints(lines) => {
                self.debugger.set_breakpoints(lines, &self.vm.image);
                DebugReply::Done
            }
            Debug::Control(control) => {
                let runs = self.mode == Mode::Running;
                self.debugger.hold.obey(control, runs, self.credit.spent)
            }
            Debug::Read(name) => match self.read(&name) {
                Some(value) => DebugReply::Value(value),
                None => DebugReply::Refused(format!("mc600 has no variable or signal '{name}'")),
            },
            Debug::Write(name, value) => match self.write(&name, &value) {
                true => DebugReply::Done,
                false => DebugReply::Refused(format!("mc600 cannot set '{name}' to that")),
            },
            Debug::Cam => match self.machine.cam_table() {
                Some(table) => DebugReply::Cam(table),
                None => DebugReply::Refused("no cam table has been used yet".to_owned()),
            },
        }
    }

    fn load(&mut self, slot: &Slot, text: &str) -> Result<Revision, LoadError> {
        match slot {
            Slot::Program => {
                let program = Program::from_typed(text).map_err(|fault| LoadError {
                    line: fault.line,
                    message: format!("?{} ERROR: {}", fault.error.text(), fault.cause),
                })?;
                self.replace_program(program);
                if self.mode == Mode::Running {
                    self.vm.stop();
                    self.finish();
                }
                let lines = text
                    .lines()
                    .map(|line| device_line(&latin1::bytes(line)).map(u32::from))
                    .collect();
                Ok(Revision {
                    number: self.program.revision(),
                    lines,
                })
            }
            Slot::File(name) => {
                let refuse = |message: String| LoadError { line: 0, message };
                let file = FileName::parse(name.as_bytes())
                    .map_err(|_| refuse(format!("'{name}' is no file name of this device")))?;
                let full = refuse(format!("there is no room for '{name}'"));
                self.disks
                    .write(&file, &latin1::bytes(text))
                    .map_err(|_| full)?;
                Ok(Revision {
                    number: self.program.revision(),
                    lines: Vec::new(),
                })
            }
            Slot::Number(number) => Err(LoadError {
                line: 0,
                message: format!("mc600 has no program number {number}"),
            }),
        }
    }

    fn listing(&self, slot: &Slot) -> Option<String> {
        match slot {
            Slot::Program => Some(latin1::text(&self.program.to_text())),
            Slot::File(name) => {
                let bytes = self.disks.read(&FileName::parse(name.as_bytes()).ok()?)?;
                Some(latin1::text(&bytes))
            }
            Slot::Number(_) => None,
        }
    }

    fn memory(&self, event: Survives) -> Memory {
        let item = |name: String, bytes: &[u8]| MemoryItem {
            name,
            bytes: bytes.to_vec(),
        };
        let mut items: Vec<MemoryItem> = self
            .disks
            .kept()
            .map(|(name, bytes)| item(format!("B:{name}"), bytes))
            .collect();
        if self.password != password::FACTORY {
            items.push(item(PASSWORD_ITEM.to_owned(), &self.password));
        }
        if event == Survives::Reload {
            let lost = self.disks.lost();
            items.extend(lost.map(|(name, bytes)| item(format!("A:{name}"), bytes)));
            if !self.program.is_empty() {
                items.push(item(PROGRAM_ITEM.to_owned(), &self.program.to_text()));
            }
        }
        items.extend(self.unknown.iter().cloned());
        Memory {
            version: MEMORY_VERSION,
            items,
        }
    }

    fn restore(&mut self, memory: &Memory) {
        self.unknown.clear();
        for item in &memory.items {
            if memory.version != MEMORY_VERSION || !self.restore_item(item) {
                self.unknown.push(item.clone());
            }
        }
    }
}

/// A variable as a person names it: `A`, `CNT%`, `A$`, `A(3)`, `B%(1,2)`.
struct Named {
    name: Name,
    subscripts: Vec<f64>,
}

fn named(text: &str) -> Option<Named> {
    let upper = text.trim().to_ascii_uppercase();
    let (name, subscripts) = match upper.split_once('(') {
        Some((name, rest)) => {
            let inner = rest.strip_suffix(')')?;
            let parsed: Result<Vec<f64>, _> =
                inner.split(',').map(|part| part.trim().parse()).collect();
            (name.trim(), parsed.ok()?)
        }
        None => (upper.as_str(), Vec::new()),
    };
    let kind = match name.chars().last()? {
        '%' => VariableKind::Integer,
        '$' => VariableKind::String,
        _ => VariableKind::Real,
    };
    Some(Named {
        name: Name {
            text: name.into(),
            kind,
        },
        subscripts,
    })
}

impl Mc600 {
    /// Puts back one item; whether it is one that this version knows.
    fn restore_item(&mut self, item: &MemoryItem) -> bool {
        match item.name.as_str() {
            PASSWORD_ITEM => {
                let is_password = password::is_password(&item.bytes);
                if is_password {
                    self.password.clone_from(&item.bytes);
                }
                is_password
            }
            PROGRAM_ITEM => match Program::from_text(&item.bytes, STORED_LENGTH) {
                Ok(program) => {
                    self.replace_program(program);
                    true
                }
                Err(_) => false,
            },
            // Only disks have a colon in their names.
            name if name.contains(':') => FileName::parse(name.as_bytes())
                .and_then(|file| self.disks.write(&file, &item.bytes))
                .is_ok(),
            _ => false,
        }
    }

    fn read(&self, text: &str) -> Option<Value> {
        if let Some(value) = self.read_machine(text) {
            return Some(Value::Number(value));
        }
        let Named { name, subscripts } = named(text)?;
        if subscripts.is_empty() {
            let place = self.vm.symbols.find(&name)?;
            return Some(match name.kind {
                VariableKind::String => Value::Text(latin1::text(self.vm.string(place))),
                _ => Value::Number(self.vm.register(place)),
            });
        }
        let mut array = self.vm.array(self.vm.symbols.find_array(&name)?)?.clone();
        let index = array.index(&subscripts, usize::MAX).ok()?;
        match name.kind {
            VariableKind::String => array
                .text(index)
                .map(|text| Value::Text(latin1::text(text))),
            _ => array.number(index).map(Value::Number),
        }
    }

    /// System variables, mailboxes, and inputs and outputs by their short names.
    fn read_machine(&self, text: &str) -> Option<f64> {
        let lower = text.trim().to_ascii_lowercase();
        let mailbox = lower.strip_prefix("can_data%(");
        if let Some(number) = mailbox.and_then(|rest| rest.strip_suffix(')')) {
            let data = self.machine.mailbox(number.trim().parse().ok()?);
            return data.map(f64::from);
        }
        let short = lower
            .strip_prefix("in")
            .or_else(|| lower.strip_prefix("out"));
        let word = match short
            .filter(|number| !number.is_empty() && number.bytes().all(|b| b.is_ascii_digit()))
        {
            Some(_) => format!("gv_{lower}%"),
            None => lower,
        };
        SysVar::from_word(&word).map(|var| f64::from(self.machine.get(var)))
    }

    fn write(&mut self, text: &str, value: &Value) -> bool {
        if let (Some(var), Value::Number(number)) = (SysVar::from_word(text.trim()), value) {
            return match super::value::to_integer(*number) {
                Ok(number) if !var.is_read_only() => {
                    self.machine.set(var, number);
                    true
                }
                _ => false,
            };
        }
        let Some(Named { name, subscripts }) = named(text) else {
            return false;
        };
        let Some(place) = self
            .vm
            .symbols
            .find(&name)
            .filter(|_| subscripts.is_empty())
        else {
            return false;
        };
        match (name.kind, value) {
            (VariableKind::String, Value::Text(text)) => {
                let bytes = latin1::bytes(text);
                let fits = bytes.len() <= super::firmware::STRING_LENGTH;
                if fits {
                    self.vm.set_string(place, Text::from_slice(&bytes));
                }
                fits
            }
            (VariableKind::Integer, Value::Number(number)) => {
                match super::value::to_integer(*number) {
                    Ok(number) => {
                        self.vm.set_register(place, f64::from(number));
                        true
                    }
                    Err(_) => false,
                }
            }
            (VariableKind::Real, Value::Number(number)) => match super::value::in_range(*number) {
                Ok(number) => {
                    self.vm.set_register(place, number);
                    true
                }
                Err(_) => false,
            },
            _ => false,
        }
    }
}
