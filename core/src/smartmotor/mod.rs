//! The Animatics SmartMotor, class 4: a servo motor with its amplifier and its controller inside.
//!
//! In reading order: `line` takes what comes in and echoes it, `host` makes commands of it, this file is the firmware
//! around the interpreter, `lexer`, `parser` and `compile` make operations of text, `vm` runs them on `memory`, `store`
//! keeps the program, `motor` is everything behind it.

mod ast;
mod code;
mod compile;
mod debugger;
pub mod diagnose;
mod firmware;
pub mod first_steps;
mod host;
pub mod keywords;
mod lexer;
mod line;
mod memory;
pub mod motor;
mod parser;
mod station;
pub mod store;
mod vm;
pub mod wiring;

pub use firmware::LINE;

use crate::controller::{ControllerInfo, MemoryItem, Opt, Ports};
use crate::exec::{Credit, Wait};
use crate::hold::Hold;
use crate::time::Nanos;
use code::{Exit, System};
use compile::compile_command;
use debugger::Debugger;
use firmware::{CREDIT_A_SAMPLE, LAST_ADDRESS, SAMPLE, START_WINDOW};
use host::{Host, Request};
use line::Line;
use memory::Eeprom;
use motor::{Flag, Motor};
use store::{Store, strip};
use vm::{Vm, World};

/// What can be given when a motor is put on the bench (D151).
pub const OPTIONS: &[Opt] = &[
    Opt {
        key: "speed",
        help: "authentic (default), fast, or how many times faster statements run, 1 to 10000",
    },
    Opt {
        key: "address",
        help: "the motor's address at power-up, 1 to 100 (default: none)",
    },
    Opt {
        key: "echo",
        help: "yes: sends on what comes in, from power-up; no (default)",
    },
    Opt {
        key: "without",
        help: "a word of the keyword table that the motor does not know (default: none)",
    },
];

/// The label that a fault calls (F=32).
const FAULT_ROUTINE: u16 = 1;
/// Ends a program that is sent.
const PROGRAM_END: u8 = 0xFF;

/// One SmartMotor with its load.
#[derive(Debug, Clone)]
pub struct SmartMotor {
    info: ControllerInfo,
    powered: bool,
    motor: Motor,
    line: Line,
    host: Host,
    vm: Vm,
    store: Store,
    eeprom: Eeprom,
    /// When the stored program starts, unless something comes in before.
    start_at: Option<Nanos>,
    credit: Credit,
    /// Statements take this many times less than on the device.
    speed: u32,
    /// Why the program's present statement does not go on.
    waiting: Option<Wait>,
    debugger: Debugger,
    next: Nanos,
    address: u8,
    echo: bool,
    /// A word that this motor lacks.
    without: Option<&'static str>,
    /// The program memory is broken.
    broken_memory: bool,
    /// What RCKS answers.
    checksum: String,
    /// Items of non-volatile memory that this version does not know.
    unknown: Vec<MemoryItem>,
    /// Orders for the motor in this sample, while someone wants them.
    log: Vec<String>,
}

impl SmartMotor {
    /// A motor that is switched off.
    ///
    /// # Errors
    /// One clear line about an option that does not exist or a value that it cannot have.
    pub fn new(options: &[(String, String)]) -> Result<SmartMotor, String> {
        let mut motor = SmartMotor {
            info: station::info(),
            powered: false,
            motor: Motor::new(),
            line: Line::new(0, false),
            host: Host::default(),
            vm: Vm::default(),
            store: Store::default(),
            eeprom: Eeprom::default(),
            start_at: None,
            credit: Credit::default(),
            speed: 1,
            waiting: None,
            debugger: Debugger::default(),
            next: Nanos::ZERO,
            address: 0,
            echo: false,
            without: None,
            broken_memory: false,
            checksum: String::new(),
            unknown: Vec::new(),
            log: Vec::new(),
        };
        for (key, value) in options {
            motor.set_option(key, value)?;
        }
        Ok(motor)
    }

    fn set_option(&mut self, key: &str, value: &str) -> Result<(), String> {
        match (key, value) {
            ("speed", "authentic") => self.speed = 1,
            ("speed", "fast") => self.speed = 10_000,
            ("speed", value) => {
                let speed = value.parse().ok();
                let speed = speed.filter(|speed| (1..=10_000).contains(speed));
                self.speed = speed.ok_or("speed is authentic, fast or a number from 1 to 10000")?;
            }
            ("address", value) => {
                let address = value.parse().ok();
                let address = address.filter(|address| (1..=LAST_ADDRESS).contains(address));
                self.address = address.ok_or("address is a number from 1 to 100")?;
            }
            ("echo", "yes" | "no") => self.echo = value == "yes",
            ("echo", _) => return Err("echo is yes or no".to_owned()),
            ("without", word) => {
                let known = keywords::find(word)
                    .ok_or_else(|| format!("smartmotor has no keyword '{word}'"))?;
                self.without = Some(known);
            }
            _ => {
                let known: Vec<&str> = OPTIONS.iter().map(|option| option.key).collect();
                return Err(format!(
                    "smartmotor has no option '{key}'; it has {}",
                    known.join(", ")
                ));
            }
        }
        Ok(())
    }

    /// The mains switch goes on.
    fn power_up(&mut self, now: Nanos) {
        self.motor.power_up();
        self.line = Line::new(self.address, self.echo);
        self.credit = Credit::default();
        self.begin(now);
    }

    /// Z: as at power-up, but for the serial line's settings and what it has still to send (D136).
    fn reset(&mut self, now: Nanos) {
        self.motor.reset();
        self.line.flags.clear_all();
        self.begin(now);
    }

    /// Variables are 0, and the stored program starts soon.
    fn begin(&mut self, now: Nanos) {
        self.host = Host::default();
        self.vm = Vm::default();
        self.eeprom.pointer = 0;
        self.debugger.hold = Hold::Free;
        self.waiting = None;
        self.take_program();
        self.start_at = Some(now + START_WINDOW).filter(|_| !self.broken_memory);
        if self.broken_memory {
            self.motor.raise(Flag::Checksum);
        }
    }

    /// Readies the stored program; nothing runs.
    fn take_program(&mut self) {
        let image = self.store.image(self.without);
        self.debugger.bind(&image);
        self.vm.set_program(image);
        self.checksum = self.store.checksum(self.broken_memory);
    }

    /// Stores a program; `false` if it is too long.
    fn download(&mut self, text: Vec<u8>) -> bool {
        if self.store.keep(text, self.without).is_none() {
            return false;
        }
        self.stop();
        self.take_program();
        true
    }

    fn stop(&mut self) {
        self.vm.stop();
        self.debugger.hold = Hold::Free;
        (self.waiting, self.start_at) = (None, None);
    }

    /// One sample of the firmware: what came in, then the host's commands and the program on their credit.
    fn firmware(&mut self, now: Nanos, log_motion: bool) {
        let before = self.line.received();
        self.line.receive(now);
        self.start_window(now, before);
        self.credit.deposit(SAMPLE, self.speed, CREDIT_A_SAMPLE);
        self.debugger.hold.limit(&mut self.credit);
        if self.motor.take_fault_call() && self.vm.running {
            self.vm.gosub(FAULT_ROUTINE);
        }
        while self.credit.balance > 0 && self.host_command(now, log_motion) {}
        while self.credit.balance > 0 && self.program(now, log_motion) {}
    }

    /// The program starts by itself if nothing comes in for 200 ms ("Serial").
    fn start_window(&mut self, now: Nanos, received: u64) {
        let Some(start_at) = self.start_at else {
            return;
        };
        if self.line.received() != received {
            self.start_at = None;
        } else if now >= start_at {
            self.start_at = None;
            self.vm.start(false);
        }
    }

    /// Runs what the host has sent; whether there may be more to do in this sample.
    fn host_command(&mut self, now: Nanos, log_motion: bool) -> bool {
        if !self.vm.has_command() {
            let without = self.without;
            match self.host.next(&mut self.line, &mut self.motor, without) {
                None => return false,
                Some(Request::Command(statements)) => {
                    self.vm.set_command(compile_command(&statements));
                }
                Some(Request::Program(program)) => {
                    let text = program.map(|program| strip(&program).text);
                    if !text.is_some_and(|text| self.download(text)) {
                        self.motor.raise(Flag::Checksum);
                    }
                    return true;
                }
            }
        }
        match self.run(true, log_motion) {
            Exit::Credit | Exit::Wait(_) | Exit::Break => false,
            Exit::End => {
                self.vm.end_command();
                true
            }
            Exit::System(system) => self.system(system, now, true),
        }
    }

    /// Runs the program; whether there may be more to do in this sample.
    fn program(&mut self, now: Nanos, log_motion: bool) -> bool {
        self.waiting = None;
        if !self.vm.running || self.debugger.hold.holds() {
            return false;
        }
        match self.run(false, log_motion) {
            Exit::Credit => false,
            Exit::Wait(wait) => {
                self.waiting = Some(wait);
                false
            }
            Exit::Break => {
                self.debugger.hold = Hold::Held;
                false
            }
            Exit::End => {
                self.stop();
                false
            }
            Exit::System(system) => self.system(system, now, false),
        }
    }

    fn run(&mut self, host: bool, log_motion: bool) -> Exit {
        let mut world = World {
            motor: &mut self.motor,
            line: &mut self.line,
            eeprom: &mut self.eeprom,
            log: log_motion.then_some(&mut self.log),
            host,
            authentic: self.speed == 1,
            checksum: &self.checksum,
        };
        match host {
            true => self.vm.run(&mut self.credit, &mut world),
            false => self
                .debugger
                .run(&mut self.vm, &mut self.credit, &mut world),
        }
    }

    /// What a statement asks of the firmware; whether there may be more to do in this sample.
    fn system(&mut self, system: System, now: Nanos, host: bool) -> bool {
        let known = match system {
            System::Run => {
                self.stop();
                self.vm.start(true);
                true
            }
            System::Reset => {
                self.reset(now);
                return false;
            }
            System::Stop => {
                self.stop();
                true
            }
            System::Goto(label) => self.vm.goto(label),
            System::Gosub(label) => self.vm.gosub(label),
            System::Load => {
                self.stop();
                self.host.load();
                true
            }
            System::Upload { compiled } => {
                self.upload(compiled);
                true
            }
        };
        if !known {
            self.motor.raise(Flag::Syntax);
        }
        host || self.vm.running
    }

    /// UPLOAD, UP: the program as it is stored, with CR for its line ends, up to the byte 255 (D141).
    fn upload(&mut self, compiled: bool) {
        let mut bytes = Vec::new();
        if compiled {
            for (label, at) in self.vm.program.image.labels.iter() {
                bytes.extend(format!("C{label}={at:04X}\r").bytes());
            }
        }
        let text = self.store.text().iter();
        bytes.extend(text.map(|&byte| if byte == b'\n' { b'\r' } else { byte }));
        bytes.push(PROGRAM_END);
        self.line.send(&bytes);
    }

    /// One sample of the motor.
    fn sample_motor(&mut self) {
        let registers = &self.vm.registers;
        self.motor
            .sample(|index| memory::cam_entry(registers, index));
    }

    fn transmit(&mut self, now: Nanos, ports: &mut Ports) {
        self.line.transmit(now, self.next, ports);
    }
}
