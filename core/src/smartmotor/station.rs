//! The SmartMotor as a station on the bench.

use super::ast::{Expr, Operand, Place, Report, StatementKind, Target};
use super::compile::compile;
use super::firmware::{LINE, PROGRAM_BYTES, SAMPLE};
use super::memory::{element, set_element};
use super::motor::{FAULTS, Motor, Signals};
use super::parser::parse_line;
use super::store::strip;
use super::{SmartMotor, vm};
use crate::controller::{
    Controller, ControllerInfo, Debug, DebugReply, Input, LoadError, Memory, MemoryItem, Ports,
    Refused, Revision, RunState, Sharing, Signal, Slot, Status, Survives, Value,
};
use crate::exec::Wait;
use crate::language::latin1;
use crate::time::Nanos;

/// The version of the items below.
const MEMORY_VERSION: u32 = 1;
const PROGRAM_ITEM: &str = "PROGRAM";
const EEPROM_ITEM: &str = "EEPROM";
/// The fault of the program memory, which is the interpreter's; the others are the motor's.
const MEMORY_FAULT: &str = "rom";

/// What a SmartMotor is and what it has.
pub(super) fn info() -> ControllerInfo {
    let signal = |(name, unit): (&str, &str)| Signal {
        name: name.to_owned(),
        unit: unit.to_owned(),
    };
    ControllerInfo {
        id: "smartmotor",
        name: "Animatics SmartMotor",
        axes: vec!["x"],
        line: LINE,
        prompt: "",
        attention: b"\rEND\r",
        start: "RUN".to_owned(),
        hands_on: None,
        program_slot: Slot::Program,
        signals: [
            ("x.command", "counts"),
            ("x.position", "counts"),
            ("x.velocity", "counts/sample*65536"),
            ("x.speed", "counts/sample*65536"),
            ("x.acceleration", "counts/sample^2*65536"),
            ("x.error", "counts"),
            ("x.output", "of 1023"),
            ("x.current", "A"),
            ("x.shaft", "revolutions"),
            ("counter", "counts"),
            ("pins", "bits"),
            ("status", "bits"),
        ]
        .map(signal)
        .to_vec(),
        wires: Motor::wires(),
        faults: FAULTS.into_iter().chain([MEMORY_FAULT]).collect(),
        keys: Vec::new(),
        sample: SAMPLE,
        sharing: Sharing::Chain,
        panel_selector: None,
    }
}

impl Controller for SmartMotor {
    fn info(&self) -> &ControllerInfo {
        &self.info
    }

    fn power(&mut self, at: Nanos, on: bool) {
        if on && !self.powered {
            self.next = self.next.max(at);
            self.power_up(self.next);
        } else if !on && self.powered {
            self.motor.power_off();
            self.stop();
        }
        self.powered = on;
    }

    fn next(&self) -> Nanos {
        self.next
    }

    fn input(&mut self, _at: Nanos, input: Input) -> Result<(), Refused> {
        match input {
            Input::Frame { connector, frame } => {
                if self.powered && connector == 0 {
                    self.line.accept(frame);
                }
                Ok(())
            }
            Input::Wire { name, value } => self.motor.wire(&name, value).map_err(Refused),
            Input::Fault { kind, active, .. } if kind == MEMORY_FAULT => {
                self.broken_memory = active;
                Ok(())
            }
            Input::Fault { kind, axis, active } => self
                .motor
                .fault(&kind, axis.as_deref(), active)
                .map_err(Refused),
            Input::Plant { axis, key, value } => {
                self.motor.configure(&axis, &key, &value).map_err(Refused)
            }
            Input::Key { .. } => Err(Refused("smartmotor has no panel".to_owned())),
            Input::Ieee488(_) => Err(Refused("smartmotor has no IEEE-488 bus".to_owned())),
            Input::Telegram(_) => Ok(()),
        }
    }

    fn sample(&mut self, now: Nanos, ports: &mut Ports) {
        self.next = now + SAMPLE;
        if self.powered {
            self.firmware(now, ports.log_motion);
        }
        self.sample_motor();
        if self.powered {
            self.transmit(now, ports);
        }
        if ports.log_motion {
            ports
                .motion
                .extend(self.log.drain(..).map(|command| (now, command)));
        }
    }

    fn record(&self, row: &mut Vec<f64>) {
        let Signals {
            demand_position,
            demand_velocity,
            demand_acceleration,
            position,
            velocity,
            following_error,
            output,
            current,
            shaft,
            counter,
            pins,
            status,
        } = self.motor.signals();
        row.extend([
            demand_position,
            position,
            demand_velocity,
            velocity,
            demand_acceleration,
            following_error,
            output,
            current,
            shaft,
            counter,
            f64::from(pins),
            status,
        ]);
    }

    fn status(&self) -> Status {
        // A motor that holds no program has nothing to start.
        let will_start = self.start_at.is_some() && self.store.has_program();
        let run = match self.waiting {
            _ if !self.powered => RunState::Idle,
            _ if self.vm.running && self.debugger.hold.holds() => RunState::Paused,
            Some(wait) => RunState::Waiting(wait),
            None if self.vm.running => RunState::Running,
            None if will_start => RunState::Waiting(Wait::Time),
            None if self.vm.has_command() => RunState::Command,
            None => RunState::Idle,
        };
        Status {
            power: self.powered,
            run,
            line: self.vm.line(),
            spent: self.credit.spent,
            unread: self.line.unread(),
            unsent: self.line.unsent(),
            moving: self.motor.is_moving(),
            enabled: self.motor.is_enabled(),
            fault: self.motor.fault_words(),
            at_prompt: self.powered && !self.vm.has_command() && !self.host.is_typing(),
            listens: true,
            error: None,
            revision: self.store.revision,
        }
    }

    fn debug(&mut self, command: Debug) -> DebugReply {
        match command {
            Debug::Breakpoints(lines) => {
                self.debugger.set_breakpoints(lines, &self.vm.program.image);
                DebugReply::Done
            }
            Debug::Control(control) => {
                let runs = self.vm.running;
                self.debugger.hold.obey(control, runs, self.credit.spent)
            }
            Debug::Read(name) => match self.read(&name) {
                Some(value) => DebugReply::Value(value),
                None => {
                    DebugReply::Refused(format!("smartmotor has no variable or signal '{name}'"))
                }
            },
            Debug::Write(name, value) => match self.write(&name, &value) {
                true => DebugReply::Done,
                false => DebugReply::Refused(format!("smartmotor cannot set '{name}' to that")),
            },
            Debug::Cam => DebugReply::Refused("a SmartMotor's cam is drawn from aw[]".to_owned()),
        }
    }

    /// A download by the vendor's tool: what its compiler refuses does not reach the motor.
    fn load(&mut self, slot: &Slot, text: &str) -> Result<Revision, LoadError> {
        let refuse = |line: u32, message: String| Err(LoadError { line, message });
        if *slot != Slot::Program {
            return refuse(0, "smartmotor has one program, and no files".to_owned());
        }
        let source = latin1::bytes(text);
        let stripped = strip(&source);
        if stripped.text.len() > PROGRAM_BYTES {
            return refuse(0, format!("a program has at most {PROGRAM_BYTES} bytes"));
        }
        let (_, problems) = compile(&source, self.without);
        if let Some(problem) = problems.first() {
            let message = format!("{}: {}", problem.name, problem.cause);
            return refuse(problem.line, message);
        }
        self.download(stripped.text);
        Ok(Revision {
            number: self.store.revision,
            lines: stripped.lines,
        })
    }

    fn listing(&self, slot: &Slot) -> Option<String> {
        match slot {
            Slot::Program => Some(latin1::text(self.store.text())),
            Slot::Number(_) | Slot::File(_) => None,
        }
    }

    /// Program and EEPROM survive the mains switch, and there is nothing else that a reload would lose.
    fn memory(&self, _event: Survives) -> Memory {
        let mut items = Vec::new();
        if self.store.has_program() {
            items.push(MemoryItem {
                name: PROGRAM_ITEM.to_owned(),
                bytes: self.store.text().to_vec(),
            });
        }
        if self.eeprom.bytes().iter().any(|&byte| byte != 0) {
            items.push(MemoryItem {
                name: EEPROM_ITEM.to_owned(),
                bytes: self.eeprom.bytes().to_vec(),
            });
        }
        items.extend(self.unknown.iter().cloned());
        Memory {
            version: MEMORY_VERSION,
            items,
        }
    }

    fn restore(&mut self, memory: &Memory) {
        self.unknown.clear();
        // As if it had been there at power-up: the program starts when it would have.
        let start_at = self.start_at;
        for item in &memory.items {
            let known = memory.version == MEMORY_VERSION
                && match item.name.as_str() {
                    PROGRAM_ITEM => self.download(item.bytes.clone()),
                    EEPROM_ITEM => {
                        self.eeprom.fill(&item.bytes);
                        true
                    }
                    _ => false,
                };
            if !known {
                self.unknown.push(item.clone());
            }
        }
        self.start_at = start_at;
    }
}

impl SmartMotor {
    /// A value by the name that an expression or a report has for it.
    fn read(&self, name: &str) -> Option<Value> {
        let line = latin1::bytes(&format!("a={}", name.trim()));
        if let [statement] = parse_line(&line, None).statements.as_slice()
            && let StatementKind::Assign(_, Expr { left, rest: None }) = &statement.kind
        {
            return self
                .operand(*left)
                .map(|value| Value::Number(f64::from(value)));
        }
        let line = latin1::bytes(name.trim());
        match parse_line(&line, None).statements.as_slice() {
            [statement] => match &statement.kind {
                StatementKind::Report(report) => self.report(*report),
                _ => None,
            },
            _ => None,
        }
    }

    /// What a report would answer: a number where it is one.
    fn report(&self, report: Report) -> Option<Value> {
        let text = match report {
            Report::Value(operand) => {
                return self
                    .operand(operand)
                    .map(|value| Value::Number(f64::from(value)));
            }
            Report::Text(text) => text,
        };
        let text = vm::text_report(text, &self.motor, &self.checksum);
        Some(match text.parse() {
            Ok(number) => Value::Number(number),
            Err(_) => Value::Text(text),
        })
    }

    fn operand(&self, operand: Operand) -> Option<i32> {
        match operand {
            Operand::Number(_) => None,
            Operand::Place(Place::Variable(register)) => {
                self.vm.registers.get(usize::from(register)).copied()
            }
            Operand::Place(Place::Element(array, index)) => {
                element(&self.vm.registers, array, self.index(index)?)
            }
            Operand::Source(source) => {
                Some(vm::read(source, &self.motor, &self.line, &self.eeprom))
            }
        }
    }

    fn index(&self, index: super::ast::Index) -> Option<i32> {
        use super::ast::Index;
        let variable = |register: u16| self.vm.registers.get(usize::from(register)).copied();
        match index {
            Index::Number(number) => Some(number),
            Index::Variable(a) => variable(a),
            Index::Sum(a, b) => variable(a)?.checked_add(variable(b)?),
            Index::Difference(a, b) => variable(a)?.checked_sub(variable(b)?),
        }
    }

    fn write(&mut self, name: &str, value: &Value) -> bool {
        let Some(number) = whole(value) else {
            return false;
        };
        let line = latin1::bytes(&format!("{}={number}", name.trim()));
        let parsed = parse_line(&line, None);
        let [statement] = parsed.statements.as_slice() else {
            return false;
        };
        let StatementKind::Assign(target, _) = &statement.kind else {
            return false;
        };
        match *target {
            Target::Place(Place::Variable(register)) => {
                let place = self.vm.registers.get_mut(usize::from(register));
                place.map(|place| *place = number).is_some()
            }
            Target::Place(Place::Element(array, index)) => match self.index(index) {
                Some(index) => set_element(&mut self.vm.registers, array, index, number),
                None => false,
            },
            Target::Register(register) => {
                self.motor.set(register, number);
                true
            }
            Target::EepromPointer => {
                self.eeprom.pointer = number;
                true
            }
            Target::Address => {
                let address = u8::try_from(number);
                let address = address.ok().filter(|&a| a <= super::LAST_ADDRESS);
                address.map(|a| self.line.set_address(a)).is_some()
            }
        }
    }
}

/// A number of 32 bits.
fn whole(value: &Value) -> Option<i32> {
    match value {
        Value::Number(number) => {
            let limits = f64::from(i32::MIN)..=f64::from(i32::MAX);
            let fits = limits.contains(number) && libm::trunc(*number) == *number;
            #[allow(clippy::cast_possible_truncation)] // whole and within the limits
            fits.then_some(*number as i32)
        }
        Value::Text(_) => None,
    }
}
