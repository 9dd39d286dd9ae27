//! The interpreter: registers, strings, arrays and loops of the program, run a slice at a time.

mod calls;
mod input;
mod interrupt;
mod loops;
mod printing;
mod run;
mod strings;

use super::arrays::Array;
use super::code::{Image, REGISTERS, STRING_TEMPORARIES};
use super::console::Console;
use super::firmware::{ErrorCode, MEMORY};
use super::machine::{Machine, MotionCommand};
use super::symbols::Symbols;
use super::value::{Text, to_integer};
pub use input::Answer;
pub use loops::Frame;

/// What the interpreter reaches outside of itself while it runs.
pub struct World<'a> {
    /// Planner, drive and I/O.
    pub machine: &'a mut Machine,
    /// The serial console.
    pub console: &'a mut Console,
    /// Where motion commands are noted, if anyone wants them.
    pub log: Option<&'a mut Vec<MotionCommand>>,
    /// The sample counter, for `RND(0)`.
    pub samples: u64,
}

/// All that a program has at run time.
#[derive(Debug, Clone)]
pub struct Vm {
    /// Names and constants; grows with direct lines.
    pub symbols: Symbols,
    /// The compiled program.
    pub image: Image,
    registers: Box<[f64; REGISTERS]>,
    strings: Vec<Text>,
    arrays: Vec<Array>,
    /// Bytes in the elements of string arrays.
    string_bytes: usize,
    /// Loops and calls that are open, innermost last.
    pub frames: Vec<Frame>,
    /// Interrupts whose subroutines run, innermost last.
    interrupted: Vec<interrupt::Interrupted>,
    /// The next operation.
    pub pc: u32,
    /// The next operation begins a statement: an interrupt may enter.
    between_statements: bool,
    /// The next DATA item.
    data: usize,
    /// The line that INPUT reads from.
    answer: Answer,
    /// Printed bytes that the console has not taken yet.
    printing: Vec<u8>,
    /// An integer expression left the integers on its way to being printed.
    left_integers: bool,
    /// Subscripts of the next index.
    subscripts: u16,
    random: u64,
    /// Bytes of the program text, which shares the card's memory.
    pub program_bytes: usize,
}

impl Default for Vm {
    fn default() -> Vm {
        Vm {
            symbols: Symbols::default(),
            image: Image::default(),
            registers: Box::new([0.0; REGISTERS]),
            strings: Vec::new(),
            arrays: Vec::new(),
            string_bytes: 0,
            frames: Vec::new(),
            interrupted: Vec::new(),
            pc: 0,
            between_statements: true,
            data: 0,
            answer: Answer::default(),
            printing: Vec::new(),
            left_integers: false,
            subscripts: 1,
            random: 0x2545_F491_4F6C_DD1D,
            program_bytes: 0,
        }
    }
}

impl Vm {
    /// Forgets all variables, loops and calls; constants stay.
    pub fn clear(&mut self) {
        self.registers.fill(0.0);
        self.strings.clear();
        self.arrays.clear();
        self.string_bytes = 0;
        self.frames.clear();
        self.interrupted.clear();
        self.data = 0;
        self.give_up();
        self.take_in_symbols();
    }

    /// Forgets what was printed and has not gone out, and the statement that printed it.
    pub fn stop(&mut self) {
        self.printing.clear();
        self.give_up();
    }

    /// Forgets what a statement that will not be finished left behind; what it printed still goes out.
    fn give_up(&mut self) {
        self.answer = Answer::default();
        self.left_integers = false;
        self.between_statements = true;
    }

    /// Gives a register to each new constant, a place to each new string, an array to each new name.
    pub fn take_in_symbols(&mut self) {
        for (register, value) in self.symbols.constants() {
            if let Some(place) = self.registers.get_mut(usize::from(register)) {
                *place = value;
            }
        }
        let count = self
            .symbols
            .string_count()
            .max(usize::from(STRING_TEMPORARIES));
        self.strings.resize(count, Text::new());
        for (place, text) in self.symbols.texts() {
            if let Some(string) = self.strings.get_mut(usize::from(place)) {
                *string = text;
            }
        }
        for &kind in self.symbols.array_kinds().iter().skip(self.arrays.len()) {
            self.arrays.push(Array::new(kind));
        }
    }

    /// Whether the console still has to take what was printed.
    pub fn is_printing(&self) -> bool {
        !self.printing.is_empty()
    }

    /// Room that is left in the card's memory, in bytes.
    pub fn room(&self) -> usize {
        let arrays: usize = self.arrays.iter().map(Array::bytes).sum();
        MEMORY
            .saturating_sub(self.program_bytes + self.symbols.bytes() + arrays + self.string_bytes)
    }

    /// A string by its place; what no operation can name is empty.
    pub fn string(&self, place: u16) -> &[u8] {
        self.strings
            .get(usize::from(place))
            .map(Text::as_slice)
            .unwrap_or_default()
    }

    /// The value of a register.
    #[inline(always)]
    #[allow(clippy::indexing_slicing)] // registers are a power of two, and the index is masked
    pub fn register(&self, register: u16) -> f64 {
        self.registers[usize::from(register) & (REGISTERS - 1)]
    }

    /// Sets a register.
    #[inline(always)]
    #[allow(clippy::indexing_slicing)] // as above
    pub fn set_register(&mut self, register: u16, value: f64) {
        self.registers[usize::from(register) & (REGISTERS - 1)] = value;
    }

    /// Sets a string.
    pub fn set_string(&mut self, place: u16, text: Text) {
        if let Some(string) = self.strings.get_mut(usize::from(place)) {
            *string = text;
        }
    }

    /// An array by its number.
    pub fn array(&self, number: u16) -> Option<&Array> {
        self.arrays.get(usize::from(number))
    }

    /// The number of an array, from a register that holds it.
    fn array_at(&self, register: u16) -> Option<u16> {
        to_integer(self.register(register)).ok()?.try_into().ok()
    }

    /// The array that an operation names, with the room that it may take.
    fn array_mut(&mut self, number: u16) -> Result<&mut Array, ErrorCode> {
        self.arrays
            .get_mut(usize::from(number))
            .ok_or(ErrorCode::BadSubscript)
    }

    /// The next number from 0 to below 1: 32 bits of xorshift64*.
    fn next_random(&mut self) -> f64 {
        self.random ^= self.random >> 12;
        self.random ^= self.random << 25;
        self.random ^= self.random >> 27;
        let bits = self.random.wrapping_mul(0x2545_F491_4F6C_DD1D) >> 32;
        f64::from(u32::try_from(bits).unwrap_or(0)) / 4_294_967_296.0
    }
}
