//! The interpreter: registers, calls, and what a statement prints, run a slice at a time.

mod run;
mod slow;

use super::code::{HOST_CONSTANTS, Image, PROGRAM_CONSTANTS, REGISTERS};
use super::line::Line;
use super::memory::{Eeprom, Registers};
use super::motor::Motor;

pub use slow::{read, text_report};

/// Calls that have not returned, at most.
const STACK: usize = 9;
/// In a place to return to: the call came from outside of the program, and something else is to be put back.
const SPECIAL: u32 = 1 << 31;
/// Where a subroutine returns to that was called while no program ran.
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

/// Where the calls return to that have not returned.
#[derive(Debug, Clone, Default)]
struct Calls {
    places: [u32; STACK],
    depth: usize,
}

impl Calls {
    /// `false` if there is no room.
    #[inline(always)]
    fn push(&mut self, place: u32) -> bool {
        match self.places.get_mut(self.depth) {
            Some(free) => {
                *free = place;
                self.depth += 1;
                true
            }
            None => false,
        }
    }

    #[inline(always)]
    fn pop(&mut self) -> Option<u32> {
        self.depth = self.depth.checked_sub(1)?;
        self.places.get(self.depth).copied()
    }
}

/// What the program was at when a subroutine was called from outside.
#[derive(Debug, Clone)]
struct Interrupted {
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
    calls: Calls,
    /// For each call from outside that has not returned, innermost last.
    interrupted: Vec<Interrupted>,
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
            calls: Calls::default(),
            interrupted: Vec::new(),
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
        self.forget_calls();
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

    /// Calls a label from outside of the program (D144). `false` if there is no such label, or no room for the call.
    pub fn gosub(&mut self, label: u16) -> bool {
        let Some(&target) = self.program.image.labels.get(&label) else {
            return false;
        };
        let back = match self.running {
            true => self.program.pc | SPECIAL,
            false => NOWHERE,
        };
        if !self.running {
            self.start(true);
        }
        if !self.calls.push(back) {
            return false;
        }
        self.interrupted.push(Interrupted {
            until: self.program.until,
            composed: std::mem::take(&mut self.program.composed),
        });
        self.program.go(target);
        true
    }

    /// Puts back what a call from outside has interrupted; `None` if it was nothing.
    fn come_back(&mut self, back: u32) -> Option<u32> {
        let interrupted = self.interrupted.pop();
        if back == NOWHERE {
            return None;
        }
        if let Some(Interrupted { until, composed }) = interrupted {
            (self.program.until, self.program.composed) = (until, composed);
        }
        Some(back & !SPECIAL)
    }

    /// STACK: forgets all calls.
    fn forget_calls(&mut self) {
        self.calls = Calls::default();
        self.interrupted.clear();
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
