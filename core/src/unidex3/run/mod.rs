//! The interpreter: carries out a program's codewords where they stand in the text, as the device does.
//!
//! `scan` reads numbers and signs, `words` carries out codewords, `moves` what stands behind X and Y, `registers` the
//! register operations of 6-5, `messages` quotes and the message buffer, `stack` N codes and ends. What a codeword
//! waits for is data ([`Wait`]) that is polled at each sample, so everything is interruptible.

mod gcodes;
mod messages;
mod moves;
mod registers;
mod scan;
mod stack;
mod words;

pub use messages::formatted;
pub use registers::Register;
use scan::Scan;

use std::rc::Rc;

use super::firmware::MESSAGE;
use super::indexer::{Feedrate, Indexer, Pair, Shape};
use super::memory::Memory;
use super::trouble::Trouble;
use crate::time::Nanos;

/// How a program is executed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum Kind {
    Auto,
    Single,
    Immediate,
}

/// G45 to G49.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RegisterMode {
    /// G49.
    Normal,
    /// G45: skips to the end of the block if the comparison holds.
    SkipIfTrue,
    /// G46: skips if it does not.
    SkipIfFalse,
    /// G47.
    Assign,
    /// G48.
    Move,
}

/// G36 to G39.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum Acceleration {
    None,
    Linear,
    Vector,
    Exponential,
}

/// The modes that a program called with `N<` leaves as they were (6-2).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Modes {
    /// G90.
    pub absolute: bool,
    /// G23.
    pub corner_rounding: bool,
    /// G01.
    pub vector: bool,
    /// G45 to G49.
    pub register: RegisterMode,
    /// By axis; a vector move leaves its parts here (5-1).
    pub feedrates: Pair<Feedrate>,
    /// Of a vector move.
    pub vector_feedrate: Option<Feedrate>,
}

impl Default for Modes {
    fn default() -> Modes {
        Modes {
            absolute: false,
            corner_rounding: false,
            vector: false,
            register: RegisterMode::Normal,
            feedrates: Pair::same(Feedrate::DEFAULT),
            vector_feedrate: None,
        }
    }
}

/// Parameters that last until the unit is reset (6-16 B).
#[derive(Debug, Clone, Copy)]
pub struct Parameters {
    /// G36 to G39.
    pub acceleration: Acceleration,
    /// `G37=`, in ms.
    pub linear_ms: u32,
    /// `G39=`, in ms.
    pub exponential_ms: u32,
    /// `G38=`, in steps/s².
    pub rate: u32,
    /// `G76=`.
    pub start_stop: Feedrate,
    /// `G60=` and `G61=`.
    pub home: Pair<Feedrate>,
    /// `F-`.
    pub joystick: u32,
}

impl Default for Parameters {
    fn default() -> Parameters {
        Parameters {
            acceleration: Acceleration::None,
            linear_ms: 184,
            exponential_ms: 184,
            rate: 250,
            start_stop: Feedrate::START_STOP,
            home: Pair::same(Feedrate::DEFAULT),
            joystick: 2,
        }
    }
}

impl Parameters {
    /// The time of a timed ramp.
    fn milliseconds(&self, shape: Shape) -> u32 {
        match shape {
            Shape::Linear => self.linear_ms,
            Shape::Exponential => self.exponential_ms,
        }
    }
}

/// Where the data of a G62 goes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Target {
    /// The message buffer.
    Message,
    /// A position or general register.
    Register(Register),
    /// The M outputs.
    Outputs,
    /// The flags.
    Flags,
}

/// What a codeword waits for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Wait {
    /// The end of a move or a home.
    Move,
    /// A dwell; feedhold makes it longer.
    Dwell {
        /// It ends when time less what feedholds took reaches this.
        until: Nanos,
    },
    /// `D=`.
    Count,
    /// M0: only an interrupt ends it.
    Stop,
    /// G25, and G65 in remote.
    Halt,
    /// G62.
    Input(Target),
    /// G78, G79.
    Slew,
    /// G65 in local: until the buffer has been printed.
    Print,
}

/// What a codeword came to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Flow {
    /// On to the next.
    Next,
    /// On to the next; it was a jump.
    Jump,
    /// On to the next; a block has ended.
    Block,
    /// The program waits.
    Wait(Wait),
    /// The program has ended.
    End,
    /// G99.
    Reset,
}

/// How a codeword ends: an error ends the program.
pub type Outcome = Result<Flow, Trouble>;

/// A text that is carried out, and where.
#[derive(Debug, Clone)]
pub struct Place {
    /// The program's number; `None` for the immediate mode.
    pub number: Option<u8>,
    /// Its characters.
    pub text: Rc<[u8]>,
    /// The next codeword.
    pub at: usize,
}

impl Default for Place {
    fn default() -> Place {
        Place {
            number: None,
            text: Rc::from([].as_slice()),
            at: 0,
        }
    }
}

/// What a message command asks of the display.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Shown {
    /// Its first characters.
    pub text: [u8; 8],
}

/// What codewords act on besides the interpreter itself.
pub struct World<'a> {
    /// Pulses and inputs.
    pub indexer: &'a mut Indexer,
    /// Programs.
    pub memory: &'a Memory,
    /// Now.
    pub now: Nanos,
    /// The OEM jumper is in.
    pub oem_in: bool,
    /// The program was started by the controller.
    pub remote: bool,
    /// A word of the keyword table that the unit does not know.
    pub without: Option<&'static str>,
    /// What a message command shows.
    pub show: &'a mut Option<Shown>,
    /// Motion commands as they are written, where someone wants them.
    pub log: Option<&'a mut Vec<String>>,
}

/// Whether the unit has a word.
fn known(word: &str, world: &World<'_>, otherwise: Trouble) -> Result<(), Trouble> {
    match world.without {
        Some(without) if without == word => Err(otherwise),
        _ => Ok(()),
    }
}

/// The interpreter's state.
#[derive(Debug, Clone, Default)]
pub struct Run {
    /// What runs, or would go on.
    pub place: Place,
    stack: Vec<stack::Frame>,
    /// Modes that subroutines may keep.
    pub modes: Modes,
    /// Others.
    pub parameters: Parameters,
    /// X1 to X4.
    x: [i64; 4],
    /// Y1 to Y4.
    y: [i64; 4],
    /// Flags 1 to 8.
    pub flags: u8,
    repeat: [u16; 8],
    /// M outputs 1 to 8.
    pub outputs: u8,
    /// How often the strobe has been given.
    pub strobes: u32,
    /// The message buffer.
    pub buffer: MessageBuffer,
    /// G63: the next message goes to the buffer.
    to_buffer: bool,
    /// What G25 and G65 were given last.
    pub halt_number: Option<u8>,
    /// What G78 and G79 were given last.
    pub slew_number: Option<u8>,
    /// The prompt of a G62 is the program's own.
    pub own_prompt: bool,
    /// What the program waits for.
    pub wait: Option<Wait>,
}

/// The 32 characters of 6-13.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct MessageBuffer(pub [u8; MESSAGE]);

impl Default for MessageBuffer {
    fn default() -> MessageBuffer {
        MessageBuffer([b' '; MESSAGE])
    }
}

impl MessageBuffer {
    /// The first 32 characters; what is missing is blank.
    pub fn set(&mut self, text: &[u8]) {
        let blanks = std::iter::repeat(&b' ');
        for (place, &byte) in self.0.iter_mut().zip(text.iter().chain(blanks)) {
            *place = byte;
        }
    }
}

impl Run {
    /// Begins a text at its start.
    pub fn begin(&mut self, number: Option<u8>, text: Rc<[u8]>) {
        self.place = Place {
            number,
            text,
            at: 0,
        };
        self.stack.clear();
        self.wait = None;
        self.to_buffer = false;
    }

    /// Carries out the next codeword.
    ///
    /// # Errors
    /// [`Trouble`]: the program has ended.
    pub fn step(&mut self, world: &mut World<'_>) -> Outcome {
        let start = self.place.at;
        let text = Rc::clone(&self.place.text);
        let mut scan = Scan::new(&text, start);
        let outcome = self.codeword(&mut scan, world);
        // A codeword that goes elsewhere has said where.
        if self.place.at == start && Rc::ptr_eq(&text, &self.place.text) && outcome.is_ok() {
            self.place.at = scan.at;
        }
        if let Some(log) = &mut world.log
            && let Ok(Flow::Wait(Wait::Move)) = outcome
        {
            let word = text.get(start..scan.at).unwrap_or_default();
            log.push(crate::language::latin1::text(word));
        }
        outcome
    }

    /// Whether the text is at its end.
    pub fn is_at_end(&self) -> bool {
        self.stack.is_empty() && self.place.at >= self.place.text.len()
    }

    /// Goes to the end of the block (5-7).
    ///
    /// # Errors
    /// There is none.
    pub fn skip(&mut self, from: usize) -> Outcome {
        match super::words::end_of_block(&self.place.text, from) {
            Some(at) => {
                self.place.at = at;
                Ok(Flow::Next)
            }
            None => Err(Trouble::EndOfBlock),
        }
    }

    /// Feedrates for slewing: `X F500 Y F2000`, `F500` for both, `F-20` (3-4 L, 6-11). Numbers behind X and Y
    /// are passed over.
    ///
    /// # Errors
    /// What is none of these, or out of range.
    pub fn slew_feedrates(&mut self, text: &[u8], without: Option<&str>) -> Result<(), Trouble> {
        self.slew_words(&mut Scan::new(text, 0), without)
    }

    /// A register's value.
    pub fn register(&self, register: Register, indexer: &Indexer) -> i64 {
        let of = |values: &[i64; 4], index: u8| values.get(usize::from(index)).copied();
        match register {
            Register::Position(axis) => Some(indexer.register(axis)),
            Register::X(index) => of(&self.x, index),
            Register::Y(index) => of(&self.y, index),
        }
        .unwrap_or_default()
    }

    /// Sets a register.
    pub fn set_register(
        &mut self,
        register: Register,
        value: i64,
        indexer: &mut Indexer,
        now: Nanos,
    ) {
        let place = match register {
            Register::Position(axis) => return indexer.preload(now, axis, value),
            Register::X(index) => self.x.get_mut(usize::from(index)),
            Register::Y(index) => self.y.get_mut(usize::from(index)),
        };
        if let Some(place) = place {
            *place = value;
        }
    }

    /// Sets M outputs and gives the strobe; with the OEM jumper out only programs 50 to 99 reach M5 to M8 (4-11 A).
    pub fn set_outputs(&mut self, value: u8, oem_in: bool) {
        let all = oem_in || self.place.number >= Some(super::firmware::OEM_PROGRAM);
        let reached = if all { 0xFF } else { 0x0F };
        self.outputs = (self.outputs & !reached) | (value & reached);
        self.strobes = self.strobes.wrapping_add(1);
    }
}
