//! The Danaher MC-600: an add-on card for a SERVOSTAR 600 drive, programmed in MotionBasic.
//!
//! In reading order: `console` takes what is typed, `commands` and this file are the firmware around the interpreter,
//! `lexer`, `parser` and `compile` make operations of text, `vm` runs them, `machine` is planner, drive, motor and I/O.

mod arrays;
pub mod ast;
mod code;
mod commands;
mod compile;
mod console;
mod debugger;
pub mod diagnose;
pub mod disks;
mod drive;
mod file_commands;
pub mod firmware;
pub mod first_steps;
mod functions;
mod interrupts;
mod jumps;
pub mod keywords;
mod lexer;
pub mod machine;
pub mod motion_calls;
pub mod parser;
mod password;
mod planner;
pub mod program;
mod station;
mod symbols;
pub mod sysvars;
mod value;
mod vm;
pub mod wiring;

use crate::controller::{ControllerInfo, MemoryItem, Opt, Ports};
use crate::exec::{Credit, Wait};
use crate::hold::Hold;
use crate::language::latin1;
use crate::time::Nanos;
use code::Exit;
use console::Console;
use debugger::Debugger;
use disks::Disks;
use firmware::{BYTE_COST, COST_UNIT, CREDIT_A_SAMPLE, ErrorCode, SAMPLE, STATEMENT_COST};
use keywords::{Keyword, keyword};
use machine::{Machine, MotionCommand};
use password::{Question, is_password};
use planner::encoder::Interface;
use program::Program;
use vm::{Vm, World};

/// What can be given when a card is put on the bench.
pub const OPTIONS: &[Opt] = &[
    Opt {
        key: "speed",
        help: "authentic (default), fast, or how many times faster statements run, 1 to 10000",
    },
    Opt {
        key: "locked",
        help: "yes or no: asks for the password at power-up (default: once it is not the factory's)",
    },
    Opt {
        key: "alias",
        help: "name of the application on B: that starts at power-up (default: none)",
    },
    Opt {
        key: "password",
        help: "the password, 1 to 80 characters (default: PASSWORD)",
    },
    Opt {
        key: "encoder",
        help: "of the master: quadrature (default), pulse, 24v, 24v-pulse, sincos, or servobus",
    },
    Opt {
        key: "without",
        help: "a keyword that the card answers with ?NOT IMPLEMENTED ERROR (default: none)",
    },
];

/// What the firmware is at.
#[derive(Debug, Clone, PartialEq)]
enum Mode {
    /// The mains switch is off.
    Off,
    /// Asks for the password.
    Locked {
        /// The question is out.
        asked: bool,
    },
    /// PASSWORD asks.
    Password {
        /// What for.
        question: Question,
        /// The question is out.
        asked: bool,
    },
    /// At the prompt.
    Ready {
        /// The prompt is out.
        prompted: bool,
    },
    /// AUTO offers line numbers.
    Auto {
        /// The number now offered.
        line: u16,
        /// Distance to the next.
        increment: u16,
        /// The number is out.
        prompted: bool,
    },
    /// A direct line or a program runs.
    Running,
}

/// One MC-600 in its drive, with motor and load.
#[derive(Debug, Clone)]
pub struct Mc600 {
    info: ControllerInfo,
    mode: Mode,
    machine: Machine,
    console: Console,
    disks: Disks,
    program: Program,
    vm: Vm,
    /// The program is compiled as it stands.
    compiled: bool,
    /// What CONT goes on with.
    resume: Option<u32>,
    /// Lines that LIST still has to print.
    listing: Option<ast::LineRange>,
    /// The name that SAVE without one takes.
    file: Option<disks::FileName>,
    credit: Credit,
    /// Statements take this many times less than on the device.
    speed: u32,
    /// Why the running statement does not go on.
    waiting: Option<Wait>,
    /// What the program last ended with.
    error: Option<String>,
    debugger: Debugger,
    next: Nanos,
    /// When the last sample began.
    sampled: Nanos,
    samples: u64,
    /// Whether the password is asked for at power-up; `None`: once it is not the factory's (D233).
    locked: Option<bool>,
    alias: Option<String>,
    /// As it is typed, 1 to 80 bytes.
    password: Vec<u8>,
    /// A keyword that this card lacks.
    without: Option<Keyword>,
    /// Items of non-volatile memory that this version does not know.
    unknown: Vec<MemoryItem>,
    /// Motion commands of this sample, while someone wants them.
    log: Vec<MotionCommand>,
}

impl Mc600 {
    /// A card that is switched off.
    ///
    /// # Errors
    /// One clear line about an option that does not exist or a value that it cannot have.
    pub fn new(options: &[(String, String)]) -> Result<Mc600, String> {
        let info = station::info();
        let mut card = Mc600 {
            mode: Mode::Off,
            machine: Machine::new(),
            console: Console::new(info.line),
            info,
            disks: Disks::default(),
            program: Program::default(),
            vm: Vm::default(),
            compiled: false,
            resume: None,
            listing: None,
            file: None,
            credit: Credit::default(),
            speed: 1,
            waiting: None,
            error: None,
            debugger: Debugger::default(),
            next: Nanos::ZERO,
            sampled: Nanos::ZERO,
            samples: 0,
            locked: None,
            alias: None,
            password: password::FACTORY.to_vec(),
            without: None,
            unknown: Vec::new(),
            log: Vec::new(),
        };
        for (key, value) in options {
            card.set_option(key, value)?;
        }
        Ok(card)
    }

    fn set_option(&mut self, key: &str, value: &str) -> Result<(), String> {
        match (key, value) {
            ("speed", "authentic") => self.speed = 1,
            ("speed", "fast") => self.speed = 10_000,
            ("speed", value) => {
                let speed = value
                    .parse()
                    .ok()
                    .filter(|speed| (1..=10_000).contains(speed));
                self.speed = speed.ok_or("speed is authentic, fast or a number from 1 to 10000")?;
            }
            ("locked", "yes" | "no") => self.locked = Some(value == "yes"),
            ("locked", _) => return Err("locked is yes or no".to_owned()),
            ("alias", name) => self.alias = (!name.is_empty()).then(|| name.to_owned()),
            ("password", word) => {
                let typed = latin1::bytes(word);
                if !is_password(&typed) {
                    return Err("password is 1 to 80 characters".to_owned());
                }
                self.password = typed;
            }
            ("encoder", name) => {
                let known = Interface::NAMES.iter().find(|(known, _)| *known == name);
                let names = Interface::NAMES.map(|(name, _)| name).join(", ");
                let (_, interface) = known.ok_or_else(|| format!("encoder is one of {names}"))?;
                self.machine.set_encoder(*interface);
            }
            ("without", word) => {
                let keyword =
                    keyword(word).ok_or_else(|| format!("mc600 has no keyword '{word}'"))?;
                self.without = Some(keyword);
            }
            _ => {
                let known: Vec<&str> = OPTIONS.iter().map(|option| option.key).collect();
                return Err(format!(
                    "mc600 has no option '{key}'; it has {}",
                    known.join(", ")
                ));
            }
        }
        Ok(())
    }

    /// The mains switch goes on: RAM is empty, FLASH is as it was.
    fn power_up(&mut self) {
        self.machine.power_up();
        self.disks.power_up();
        self.console = Console::new(self.info.line);
        self.new_program();
        self.vm = Vm::default();
        self.credit = Credit::default();
        (self.waiting, self.error) = (None, None);
        self.debugger.hold = Hold::Free;
        self.mode = Mode::Ready { prompted: false };
        if let Some(alias) = self.alias.clone() {
            self.start_application(&alias);
        } else if self.is_locked() {
            self.mode = Mode::Locked { asked: false };
        }
    }

    /// One sample of the firmware: what was typed, then the program on its credit.
    fn firmware(&mut self, now: Nanos, ports: &Ports) {
        self.console.receive(now);
        if self.console.take_attention() {
            self.attention();
        }
        self.credit.deposit(SAMPLE, self.speed, CREDIT_A_SAMPLE);
        self.debugger.hold.limit(&mut self.credit);
        while self.credit.balance > 0 && self.vm.flush(&mut self.console) {
            let goes_on = match self.mode {
                Mode::Off => false,
                Mode::Locked { asked } => self.unlock(asked),
                Mode::Ready { prompted } => self.at_prompt(prompted),
                Mode::Auto {
                    line,
                    increment,
                    prompted,
                } => self.offer_line(line, increment, prompted),
                Mode::Password { .. } => self.change_password(),
                Mode::Running => self.execute(ports.log_motion),
            };
            if !goes_on {
                break;
            }
        }
    }

    /// Ctrl-C: stops what runs, or forgets what is typed.
    fn attention(&mut self) {
        // What was begun need not be paid any more.
        self.credit.balance = self.credit.balance.max(0);
        let unsent = self.console.unsent() > 0 || self.vm.is_printing();
        let typing = self.console.is_typing();
        self.console.discard();
        self.vm.stop();
        self.listing = None;
        if unsent || typing || self.console.column() != 0 {
            self.vm.say(b"\r\n");
        }
        match self.mode {
            Mode::Off => {}
            Mode::Locked { .. } => self.mode = Mode::Locked { asked: false },
            Mode::Ready { .. } | Mode::Auto { .. } => self.mode = Mode::Ready { prompted: false },
            Mode::Password { .. } => self.end_questions(),
            Mode::Running => self.break_off(),
        }
    }

    /// Ends the running line or program as STOP does (D2).
    fn break_off(&mut self) {
        let line = self.vm.image.line_at(self.vm.pc);
        let message = match line {
            Some(line) => format!("BREAK IN {line}\r\n"),
            None => "BREAK\r\n".to_owned(),
        };
        if line.is_some() {
            self.resume = Some(self.vm.pc);
        }
        self.on_new_line(&message);
        self.finish();
    }

    /// Back to the prompt.
    fn finish(&mut self) {
        self.waiting = None;
        self.debugger.hold = Hold::Free;
        self.mode = Mode::Ready { prompted: false };
    }

    /// Prints a message at the start of a line (D45).
    fn on_new_line(&mut self, message: &str) {
        if self.vm.column(&self.console) != 0 {
            self.vm.say(b"\r\n");
        }
        self.vm.say(message.as_bytes());
    }

    fn at_prompt(&mut self, prompted: bool) -> bool {
        if !prompted {
            self.on_new_line(">");
            self.mode = Mode::Ready { prompted: true };
            return true;
        }
        let Some(typed) = self.console.take_line() else {
            return false;
        };
        self.mode = Mode::Ready { prompted: false };
        if typed.too_long {
            self.report(ErrorCode::StringTooLong, None);
        } else {
            self.entered(&typed.text);
        }
        self.charge_a_line();
        true
    }

    /// Taking a line costs the time of a simple statement.
    fn charge_a_line(&mut self) {
        let cost = i64::from(STATEMENT_COST) * COST_UNIT;
        self.credit.settle(self.credit.balance.saturating_sub(cost));
    }

    /// Handling a program as a whole takes its time byte by byte.
    fn charge_bytes(&mut self, bytes: usize) {
        let cost = i64::try_from(bytes)
            .unwrap_or(i64::MAX)
            .saturating_mul(BYTE_COST);
        self.credit.settle(self.credit.balance.saturating_sub(cost));
    }

    /// Runs the program on its credit; whether the firmware has more to do in this sample.
    fn execute(&mut self, log_motion: bool) -> bool {
        self.waiting = None;
        if self.listing.is_some() {
            self.list_next();
            return true;
        }
        if self.debugger.hold.holds() {
            return false;
        }
        let interrupts = self.machine.interrupts.is_pending() && self.debugger.lets_interrupts_in();
        if interrupts {
            self.vm.enter_interrupt(&mut self.credit, &mut self.machine);
        }
        // A statement that has waited is ended by itself, so that an interrupt enters behind it.
        let ends_statement = interrupts && self.vm.is_amid_a_statement();
        let mut world = World {
            machine: &mut self.machine,
            console: &mut self.console,
            log: log_motion.then_some(&mut self.log),
            samples: self.samples,
        };
        let exit = if ends_statement {
            self.vm.step(&mut self.credit, &mut world)
        } else {
            self.debugger
                .run(&mut self.vm, &mut self.credit, &mut world)
        };
        match exit {
            Exit::Credit => return ends_statement,
            Exit::Wait(wait) => {
                self.waiting = Some(wait);
                return false;
            }
            Exit::Break => {
                self.debugger.hold = Hold::Held;
                return false;
            }
            Exit::End => {
                // CONT goes on behind an END (D25); a direct line that ends forgets nothing.
                let behind = self.vm.pc.saturating_add(1);
                if self.vm.image.line_at(self.vm.pc).is_some() {
                    self.resume = self.vm.image.line_at(behind).map(|_| behind);
                }
                self.finish();
            }
            Exit::Stop => self.break_off_before(),
            Exit::Error(error, line) => {
                self.report(error, line.or(self.vm.image.line_at(self.vm.pc)));
                self.finish();
            }
            Exit::System(call, op) => self.system(call, op),
        }
        true
    }

    /// STOP names its own line, and CONT goes on behind it.
    fn break_off_before(&mut self) {
        let resume = self.vm.pc;
        self.vm.pc = resume.saturating_sub(1);
        self.break_off();
        self.resume = self.resume.map(|_| resume);
    }

    /// Prints an error in the device's words. A running program has ended with it.
    fn report(&mut self, error: ErrorCode, line: Option<u16>) {
        let message = match line {
            Some(line) => format!("?{} ERROR IN {line}", error.text()),
            None => format!("?{} ERROR", error.text()),
        };
        self.on_new_line(&message);
        self.vm.say(b"\r\n");
        self.resume = None;
        self.error = Some(message);
    }
}
