//! Where names and constants live: each simple variable and each constant has a register or a string of its own,
//! each array a number, for as long as the variables live.

use std::collections::BTreeMap;

use super::ast::{Name, VariableKind};
use super::code::{REGISTERS, STRING_TEMPORARIES, TEMPORARIES};
use super::firmware::ErrorCode;
use super::value::Text;

/// Most strings and arrays that names can stand for.
const MOST: usize = 32_768;

/// Names and constants with their places.
#[derive(Debug, Clone, Default)]
pub struct Symbols {
    numbers: BTreeMap<Box<str>, u16>,
    constants: BTreeMap<u64, u16>,
    strings: BTreeMap<Box<str>, u16>,
    texts: BTreeMap<Vec<u8>, u16>,
    arrays: BTreeMap<Box<str>, u16>,
    /// What each array holds, by its number.
    kinds: Vec<VariableKind>,
}

impl Symbols {
    /// The register of a numeric variable.
    ///
    /// # Errors
    /// OUT OF MEMORY when there are no registers left.
    pub fn number(&mut self, name: &Name) -> Result<u16, ErrorCode> {
        if let Some(&register) = self.numbers.get(&name.text) {
            return Ok(register);
        }
        let register = self.next_register()?;
        self.numbers.insert(name.text.clone(), register);
        Ok(register)
    }

    /// The register that holds a constant.
    ///
    /// # Errors
    /// As for [`Symbols::number`].
    pub fn constant(&mut self, value: f64) -> Result<u16, ErrorCode> {
        if let Some(&register) = self.constants.get(&value.to_bits()) {
            return Ok(register);
        }
        let register = self.next_register()?;
        self.constants.insert(value.to_bits(), register);
        Ok(register)
    }

    /// The place of a string variable.
    ///
    /// # Errors
    /// OUT OF MEMORY when there are too many.
    pub fn string(&mut self, name: &Name) -> Result<u16, ErrorCode> {
        if let Some(&place) = self.strings.get(&name.text) {
            return Ok(place);
        }
        let place = self.next_string()?;
        self.strings.insert(name.text.clone(), place);
        Ok(place)
    }

    /// The place that holds a string constant.
    ///
    /// # Errors
    /// As for [`Symbols::string`].
    pub fn text(&mut self, text: &[u8]) -> Result<u16, ErrorCode> {
        if let Some(&place) = self.texts.get(text) {
            return Ok(place);
        }
        let place = self.next_string()?;
        self.texts.insert(text.to_vec(), place);
        Ok(place)
    }

    /// The number of an array.
    ///
    /// # Errors
    /// OUT OF MEMORY when there are too many.
    pub fn array(&mut self, name: &Name) -> Result<u16, ErrorCode> {
        if let Some(&number) = self.arrays.get(&name.text) {
            return Ok(number);
        }
        let number = place(self.kinds.len(), MOST)?;
        self.arrays.insert(name.text.clone(), number);
        self.kinds.push(name.kind);
        Ok(number)
    }

    /// What is known of a name, without making it: its register or string.
    pub fn find(&self, name: &Name) -> Option<u16> {
        match name.kind {
            VariableKind::String => self.strings.get(&name.text).copied(),
            _ => self.numbers.get(&name.text).copied(),
        }
    }

    /// The array called `name`, without making it.
    pub fn find_array(&self, name: &Name) -> Option<u16> {
        self.arrays.get(&name.text).copied()
    }

    /// Every constant with its register.
    pub fn constants(&self) -> impl Iterator<Item = (u16, f64)> {
        self.constants
            .iter()
            .map(|(&bits, &register)| (register, f64::from_bits(bits)))
    }

    /// Every string constant with its place.
    pub fn texts(&self) -> impl Iterator<Item = (u16, Text)> {
        self.texts
            .iter()
            .map(|(text, &place)| (place, Text::from_slice(text)))
    }

    /// How many strings there are, temporaries included.
    pub fn string_count(&self) -> usize {
        usize::from(STRING_TEMPORARIES) + self.strings.len() + self.texts.len()
    }

    /// What each array holds.
    pub fn array_kinds(&self) -> &[VariableKind] {
        &self.kinds
    }

    /// Bytes of the card's memory that the names take (D27: 16 each).
    pub fn bytes(&self) -> usize {
        16 * (self.numbers.len() + self.strings.len() + self.arrays.len())
    }

    fn next_register(&self) -> Result<u16, ErrorCode> {
        place(
            usize::from(TEMPORARIES) + self.numbers.len() + self.constants.len(),
            REGISTERS,
        )
    }

    fn next_string(&self) -> Result<u16, ErrorCode> {
        place(self.string_count(), MOST)
    }
}

fn place(next: usize, most: usize) -> Result<u16, ErrorCode> {
    u16::try_from(next)
        .ok()
        .filter(|_| next < most)
        .ok_or(ErrorCode::OutOfMemory)
}
