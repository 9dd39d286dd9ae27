//! The interpreter: registers, calls, and what a statement prints, run a slice at a time.

mod run;
mod slow;

use super::code::{HOST_CONSTANTS, Image, PROGRAM_CONSTANTS, REGISTERS};
use super::line::Line;
use super::memory::{Eeprom, Registers};
use super::motor::Motor;

pub use slow::{read, text_report};

/// Calls that have not returned.
const STACK: usize = 9;
/// Where a subroutine returns to that the host called while no program ran.
const NOWHERE: u32 = u32::MAX;

/// What the interpreter reaches outside of itself while it runs.
pub struct World<'a> {
    /// The motor with its pins.
    pub motor: &'a mut Motor,
    /// The serial line.
    pub line: &'a mut Line,
    /// The memory for data.
    pub eeprom: &'a mut Eeprom,
    /// Where orders for the motor are noted, if anyone wants them.
    pub log: Option<&'a mut Vec<String>>,
    /// The host's command runs, not the program.
    pub host: bool,
    /// A statement takes a servo sample, so that the last one of a wait is the statement's own.
    pub authentic: bool,
    /// What RCKS answers.
    pub checksum: &'a str,
}

/// A stream of statements: the program, or the host's command.
#[derive(Debug, Clone, Default)]
pub struct Stream {
    /// Its operations.
    pub image: Image,
    /// The next one.
    pub pc: u32,
    /// The value at which the present wait ends.
    until: Option<u64>,
    /// What the present PRINT has composed.
    composed: Vec<u8>,
}

impl Stream {
    /// Goes to an operation and forgets what the present statement was at.
    fn go(&mut self, pc: u32) {
        self.pc = pc;
        self.until = None;
        self.composed.clear();
    }
}

/// A call that has not returned, with what the calling statement was at.
#[derive(Debug, Clone)]
struct Call {
    back: u32,
    until: Option<u64>,
    composed: Vec<u8>,
}

/// All that programs have at run time.
#[derive(Debug, Clone)]
pub struct Vm {
    /// Variables, temporaries and constants.
    pub registers: Box<Registers>,
    /// The stored program.
    pub program: Stream,
    /// The host's command.
    pub host: Stream,
    /// The program runs.
    pub running: bool,
    /// It was started by RUN, not by power-up.
    asked: bool,
    calls: Vec<Call>,
    /// A calculation has overflowed since the motor was told.
    overflow: bool,
}

impl Default for Vm {
    fn default() -> Vm {
        Vm {
            registers: Box::new([0; REGISTERS]),
            program: Stream::default(),
            host: Stream::default(),
            running: false,
            asked: false,
            calls: Vec::new(),
            overflow: false,
        }
    }
}

impl Vm {
    /// Another program; nothing runs.
    pub fn set_program(&mut self, image: Image) {
        self.stop();
        self.load_constants(PROGRAM_CONSTANTS, &image);
        self.program.image = image;
    }

    /// The host's next command.
    pub fn set_command(&mut self, image: Image) {
        self.load_constants(HOST_CONSTANTS, &image);
        self.host.image = image;
        self.host.go(0);
    }

    fn load_constants(&mut self, first: u16, image: &Image) {
        let places = self.registers.iter_mut().skip(usize::from(first));
        for (place, &value) in places.zip(image.constants.iter()) {
            *place = value;
        }
    }

    /// Starts the program; `asked` tells RUN from power-up.
    pub fn start(&mut self, asked: bool) {
        self.stop();
        self.asked = asked;
        self.running = true;
    }

    /// Ends the program.
    pub fn stop(&mut self) {
        self.running = false;
        self.calls.clear();
        self.program.go(0);
    }

    /// Goes to a label; starts the program there if it does not run. `false` if there is no such label.
    pub fn goto(&mut self, label: u16) -> bool {
        let Some(&target) = self.program.image.labels.get(&label) else {
            return false;
        };
        if !self.running {
            self.start(true);
        }
        self.program.go(target);
        true
    }

    /// Calls a label from outside of the program. `false` if there is no such label, or no room for the call.
    pub fn gosub(&mut self, label: u16) -> bool {
        let Some(&target) = self.program.image.labels.get(&label) else {
            return false;
        };
        if self.calls.len() >= STACK {
            return false;
        }
        let back = if self.running {
            self.program.pc
        } else {
            self.start(true);
            NOWHERE
        };
        self.calls.push(Call {
            back,
            until: self.program.until,
            composed: std::mem::take(&mut self.program.composed),
        });
        self.program.go(target);
        true
    }

    /// The line of the program that runs next, from 1.
    pub fn line(&self) -> Option<u32> {
        let line = self.program.image.line_at(self.program.pc);
        line.filter(|_| self.running)
    }

    /// The host's command has more to do.
    pub fn has_command(&self) -> bool {
        usize::try_from(self.host.pc).is_ok_and(|pc| pc < self.host.image.ops.len())
    }

    /// Drops the rest of the host's command.
    pub fn end_command(&mut self) {
        self.host.image = Image::default();
        self.host.go(0);
    }
}
