//! The user memory: programs in battery-backed RAM behind a checksum and a prestored word (2-6 B), and what is kept
//! with them.
//!
//! Of its bytes 32 are the header: checksum (2), prestored word (16), what boots and ends files. A program takes its
//! characters and five bytes more (spec, "Memory").

use std::rc::Rc;

use super::firmware::END_OF_FILE;

/// The program that is loaded and listed where none is named.
pub const DEFAULT_PROGRAM: u8 = 1;
/// Bytes that hold no programs.
const HEADER: usize = 32;
/// Bytes that a program takes besides its characters.
const PROGRAM_HEADER: usize = 5;

/// A stored program.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Program {
    /// 1 to 99.
    pub number: u8,
    /// Its characters; blanks only in messages.
    pub text: Rc<[u8]>,
}

impl Program {
    /// As the directory tells it.
    pub fn length(&self) -> usize {
        self.text.len() + PROGRAM_HEADER
    }
}

/// What runs by itself, or is offered, at power-up (2-6 F to H). Never both.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Start {
    /// Runs at power-up.
    pub boot: Option<u8>,
    /// Is offered with `RUN   nn`.
    pub set_up: Option<u8>,
}

/// What the battery keeps.
#[derive(Debug, Clone)]
pub struct Memory {
    /// In the order in which they were entered.
    programs: Vec<Program>,
    kilobytes: u16,
    /// Selected with the OEM jumper in.
    pub oem: Start,
    /// Selected with it out.
    pub user: Start,
    /// Ends what is printed (2-7 E).
    pub end_of_file: u8,
    /// The program that is being edited: what a power failure leaves.
    pub editing: Option<u8>,
    /// The prestored word is there.
    word: bool,
    /// As the last edit has left it.
    checksum: u16,
    /// Grows with every change of a program.
    pub revision: u64,
}

impl Memory {
    /// A memory that was cleared.
    pub fn new(kilobytes: u16) -> Memory {
        let mut memory = Memory {
            programs: Vec::new(),
            kilobytes,
            oem: Start::default(),
            user: Start::default(),
            end_of_file: END_OF_FILE,
            editing: None,
            word: true,
            checksum: 0,
            revision: 0,
        };
        memory.seal();
        memory
    }

    /// Its size, 4 or 28.
    pub fn kilobytes(&self) -> u16 {
        self.kilobytes
    }

    /// The programs, in the order in which they were entered.
    pub fn programs(&self) -> &[Program] {
        &self.programs
    }

    /// A program's text.
    pub fn text(&self, number: u8) -> Option<Rc<[u8]>> {
        let found = self.programs.iter().find(|known| known.number == number);
        found.map(|program| Rc::clone(&program.text))
    }

    /// Bytes that programs may still take.
    pub fn free(&self) -> usize {
        let used: usize = self.programs.iter().map(Program::length).sum();
        (usize::from(self.kilobytes) * 1024 - HEADER).saturating_sub(used)
    }

    /// Whether a program of that number may have so many characters.
    pub fn has_room(&self, number: u8, characters: usize) -> bool {
        let old = self.programs.iter().find(|known| known.number == number);
        let free = self.free() + old.map_or(0, Program::length);
        characters + PROGRAM_HEADER <= free
    }

    /// Stores a program in the place of its like, else behind all others; `false` if there is no room.
    pub fn store(&mut self, number: u8, text: &[u8]) -> bool {
        if !(1..=99).contains(&number) || !self.has_room(number, text.len()) {
            return false;
        }
        self.revision += 1;
        let text = Rc::from(text);
        match self.programs.iter_mut().find(|old| old.number == number) {
            Some(old) => old.text = text,
            None => self.programs.push(Program { number, text }),
        }
        true
    }

    /// Removes a program; whether there was one.
    pub fn remove(&mut self, number: u8) -> bool {
        let before = self.programs.len();
        self.programs.retain(|known| known.number != number);
        self.revision += 1;
        self.programs.len() != before
    }

    /// Removes all programs and makes the memory valid (2-6 E). What boots stays selected (D252).
    pub fn clear(&mut self) {
        self.programs.clear();
        self.word = true;
        self.editing = None;
        self.revision += 1;
        self.seal();
    }

    /// The battery was empty while the mains were off: nothing is as it was.
    pub fn lose(&mut self) {
        let revision = self.revision + 1;
        *self = Memory::new(self.kilobytes);
        self.word = false;
        self.revision = revision;
    }

    /// Notes the checksum of what is there now: at the end of an edit.
    pub fn seal(&mut self) {
        self.checksum = self.sum();
    }

    /// Whether the prestored word is there.
    pub fn is_valid(&self) -> bool {
        self.word
    }

    /// Whether the checksum is that of the last edit's end.
    pub fn is_sealed(&self) -> bool {
        self.checksum == self.sum()
    }

    fn sum(&self) -> u16 {
        let mut sum = 0_u16;
        let mut add = |byte: u8| sum = sum.rotate_left(1).wrapping_add(u16::from(byte));
        for program in &self.programs {
            add(program.number);
            program.text.iter().for_each(|&byte| add(byte));
        }
        sum
    }

    /// The selection that a key changes: that of the jumper's position.
    pub fn start_mut(&mut self, oem_in: bool) -> &mut Start {
        if oem_in {
            &mut self.oem
        } else {
            &mut self.user
        }
    }

    /// What is selected: the OEM's boot-strap program runs first (4-11 A), and its selections win.
    pub fn start(&self) -> Start {
        Start {
            boot: self.oem.boot.or(self.user.boot),
            set_up: self.oem.set_up.or(self.user.set_up),
        }
    }

    /// What is kept besides programs, as bytes that [`Memory::set_settings`] reads.
    pub fn settings(&self) -> Vec<u8> {
        let selected = |number: Option<u8>| number.unwrap_or(0);
        let starts = [self.oem, self.user];
        let mut bytes: Vec<u8> = starts
            .iter()
            .flat_map(|start| [selected(start.boot), selected(start.set_up)])
            .collect();
        bytes.extend([
            self.end_of_file,
            selected(self.editing),
            u8::from(self.word),
        ]);
        bytes.extend(self.checksum.to_le_bytes());
        bytes
    }

    /// Puts them back; `false` if they are not that.
    pub fn set_settings(&mut self, bytes: &[u8]) -> bool {
        let &[
            oem_boot,
            oem_set_up,
            boot,
            set_up,
            end_of_file,
            editing,
            word,
            low,
            high,
        ] = bytes
        else {
            return false;
        };
        let selected = |number: u8| (1..=99).contains(&number).then_some(number);
        let start = |boot, set_up| Start {
            boot: selected(boot),
            set_up: selected(set_up),
        };
        self.oem = start(oem_boot, oem_set_up);
        self.user = start(boot, set_up);
        self.end_of_file = end_of_file;
        self.editing = selected(editing);
        self.word = word != 0;
        self.checksum = u16::from_le_bytes([low, high]);
        true
    }
}
