//! Data memory: the arrays' view of the variables, and the EEPROM.

use std::rc::Rc;

use super::ast::{Array, Place};
use super::code::{ARRAYS, REGISTERS};

/// Bytes of the EEPROM that VST and VLD reach.
pub const EEPROM_BYTES: usize = 8000;

/// The registers of the interpreter: variables first, see [`super::code`].
pub type Registers = [i32; REGISTERS];

/// An array by the number that operations use.
pub fn array(number: u16) -> Array {
    match number {
        0 => Array::Bytes,
        1 => Array::Words,
        _ => Array::Longs,
    }
}

impl Array {
    /// Bits of an element.
    fn bits(self) -> u32 {
        match self {
            Array::Bytes => 8,
            Array::Words => 16,
            Array::Longs => 32,
        }
    }

    /// The last element.
    fn last(self) -> i32 {
        match self {
            Array::Bytes => 200,
            Array::Words => 100,
            Array::Longs => 50,
        }
    }

    /// The register that holds an element, and its lowest bit there: `aa` is `al[0]`, its low word `aw[0]`, its lowest
    /// byte `ab[0]` (D132).
    fn locate(self, index: i32) -> Option<(usize, u32)> {
        if !(0..=self.last()).contains(&index) {
            return None;
        }
        let bit = u32::try_from(index).ok()? * self.bits();
        let register = usize::from(ARRAYS) + usize::try_from(bit / 32).ok()?;
        Some((register, bit % 32))
    }
}

/// An element, with its sign; `None` if there is none.
pub fn element(registers: &Registers, array: Array, index: i32) -> Option<i32> {
    let (register, bit) = array.locate(index)?;
    let value = *registers.get(register)?;
    let unused = 32 - array.bits();
    Some(
        value
            .wrapping_shr(bit)
            .wrapping_shl(unused)
            .wrapping_shr(unused),
    )
}

/// Sets an element to the low bits of `value`; whether there is one.
pub fn set_element(registers: &mut Registers, array: Array, index: i32, value: i32) -> bool {
    let place = array.locate(index);
    let Some((register, bit)) = place.and_then(|(at, bit)| Some((registers.get_mut(at)?, bit)))
    else {
        return false;
    };
    let mask = match array {
        Array::Longs => -1,
        _ => ((1i32 << array.bits()) - 1).wrapping_shl(bit),
    };
    *register = (*register & !mask) | (value.wrapping_shl(bit) & mask);
    true
}

/// `aw[index]`, for the cam; 0 where there is none.
pub fn cam_entry(registers: &Registers, index: u8) -> i16 {
    let entry = element(registers, Array::Words, i32::from(index));
    entry
        .and_then(|entry| i16::try_from(entry).ok())
        .unwrap_or(0)
}

/// Variables in sequence: `count` of them from a place on.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Sequence {
    /// Registers from one on.
    Variables(u16),
    /// Elements from an index on.
    Elements(Array, i32),
}

impl Sequence {
    /// The place with its index, which has been computed.
    pub fn new(place: Place, index: i32) -> Sequence {
        match place {
            Place::Variable(register) => Sequence::Variables(register),
            Place::Element(array, _) => Sequence::Elements(array, index),
        }
    }

    /// Bytes of one of them.
    fn size(self) -> usize {
        match self {
            Sequence::Variables(_) => 4,
            Sequence::Elements(array, _) => usize::try_from(array.bits() / 8).unwrap_or(4),
        }
    }

    /// Whether `count` of them exist: a sequence does not leave its group of 26, or its array.
    fn has(self, count: i32) -> bool {
        let room = match self {
            Sequence::Variables(register) => 26 - i32::from(register % 26),
            Sequence::Elements(array, index) if index >= 0 => {
                array.last().saturating_sub(index).saturating_add(1)
            }
            Sequence::Elements(..) => 0,
        };
        (0..=room).contains(&count)
    }

    fn get(self, registers: &Registers, offset: i32) -> Option<i32> {
        match self {
            Sequence::Variables(first) => {
                let register = usize::from(first).checked_add(usize::try_from(offset).ok()?)?;
                registers.get(register).copied()
            }
            Sequence::Elements(array, first) => {
                element(registers, array, first.checked_add(offset)?)
            }
        }
    }

    fn set(self, registers: &mut Registers, offset: i32, value: i32) {
        match self {
            Sequence::Variables(first) => {
                let register = usize::try_from(offset).map(|offset| usize::from(first) + offset);
                if let Some(register) = register.ok().and_then(|at| registers.get_mut(at)) {
                    *register = value;
                }
            }
            Sequence::Elements(array, first) => {
                set_element(registers, array, first.saturating_add(offset), value);
            }
        }
    }
}

/// The EEPROM for data, with its pointer. It keeps what it holds without power.
#[derive(Debug, Clone)]
pub struct Eeprom {
    bytes: Rc<Vec<u8>>,
    /// `EPTR`: the next byte.
    pub pointer: i32,
}

impl Default for Eeprom {
    fn default() -> Eeprom {
        Eeprom {
            bytes: Rc::new(vec![0; EEPROM_BYTES]),
            pointer: 0,
        }
    }
}

impl Eeprom {
    /// Where a transfer begins and ends; `None` if it does not fit or the variables do not exist.
    fn span(&self, sequence: Sequence, count: i32) -> Option<std::ops::Range<usize>> {
        let start = usize::try_from(self.pointer).ok()?;
        let bytes = usize::try_from(count).ok()?.checked_mul(sequence.size())?;
        let end = start.checked_add(bytes)?;
        (sequence.has(count) && end <= self.bytes.len()).then_some(start..end)
    }

    /// VST: stores variables and moves the pointer; `false` if they do not exist or do not fit, and nothing is done.
    pub fn save(&mut self, registers: &Registers, sequence: Sequence, count: i32) -> bool {
        let Some(span) = self.span(sequence, count) else {
            return false;
        };
        let bytes = Rc::make_mut(&mut self.bytes);
        let cells = bytes.get_mut(span.clone()).unwrap_or_default();
        for (offset, cell) in (0..).zip(cells.chunks_mut(sequence.size())) {
            let value = sequence.get(registers, offset).unwrap_or(0).to_be_bytes();
            let skip = value.len().saturating_sub(cell.len());
            cell.copy_from_slice(value.get(skip..).unwrap_or(&value));
        }
        self.pointer = i32::try_from(span.end).unwrap_or(i32::MAX);
        true
    }

    /// VLD: loads variables and moves the pointer; `false` as for [`Eeprom::save`].
    pub fn restore(&mut self, registers: &mut Registers, sequence: Sequence, count: i32) -> bool {
        let Some(span) = self.span(sequence, count) else {
            return false;
        };
        let cells = self.bytes.get(span.clone()).unwrap_or_default();
        for (offset, cell) in (0..).zip(cells.chunks(sequence.size())) {
            let bits = cell
                .iter()
                .fold(0i32, |value, &byte| value.wrapping_shl(8) | i32::from(byte));
            let unused = 32u32.saturating_sub(8 * u32::try_from(cell.len()).unwrap_or(4));
            sequence.set(
                registers,
                offset,
                bits.wrapping_shl(unused).wrapping_shr(unused),
            );
        }
        self.pointer = i32::try_from(span.end).unwrap_or(i32::MAX);
        true
    }

    /// Its contents.
    pub fn bytes(&self) -> &[u8] {
        &self.bytes
    }

    /// Puts contents back; what is missing is 0.
    pub fn fill(&mut self, bytes: &[u8]) {
        let mut cells = bytes.to_vec();
        cells.resize(EEPROM_BYTES, 0);
        self.bytes = Rc::new(cells);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn arrays_share_the_memory_of_aa_to_zzz() {
        let mut registers = [0; REGISTERS];
        assert!(set_element(&mut registers, Array::Longs, 0, 0x1234_5678));
        assert_eq!(registers[usize::from(ARRAYS)], 0x1234_5678);
        assert_eq!(element(&registers, Array::Words, 0), Some(0x5678));
        assert_eq!(element(&registers, Array::Bytes, 3), Some(0x12));
        assert!(set_element(&mut registers, Array::Bytes, 1, -1));
        assert_eq!(registers[26], 0x1234_FF78);
        assert_eq!(element(&registers, Array::Bytes, 1), Some(-1));
        assert_eq!(element(&registers, Array::Words, 0), Some(-136));
        assert!(set_element(&mut registers, Array::Words, 3, 70_000));
        assert_eq!(element(&registers, Array::Words, 3), Some(4464));
        for (array, last) in [(Array::Bytes, 200), (Array::Words, 100), (Array::Longs, 50)] {
            assert!(set_element(&mut registers, array, last, 5));
            assert_eq!(element(&registers, array, last), Some(5));
            assert!(!set_element(&mut registers, array, last + 1, 5));
            assert_eq!(element(&registers, array, -1), None);
        }
        assert_eq!(registers[77], 0);
    }

    #[test]
    fn the_eeprom_keeps_every_size_and_refuses_what_does_not_fit() {
        let mut eeprom = Eeprom::default();
        let mut registers = [0; REGISTERS];
        registers[24] = -5;
        registers[25] = i32::MIN;
        set_element(&mut registers, Array::Bytes, 7, -100);
        set_element(&mut registers, Array::Words, 9, -30_000);
        let y = Sequence::Variables(24);
        assert!(eeprom.save(&registers, y, 2));
        assert!(!eeprom.save(&registers, y, 3));
        let byte = Sequence::Elements(Array::Bytes, 7);
        let word = Sequence::Elements(Array::Words, 9);
        assert!(eeprom.save(&registers, byte, 1) && eeprom.save(&registers, word, 1));
        assert_eq!(eeprom.pointer, 11);
        let mut again = [0; REGISTERS];
        eeprom.pointer = 0;
        assert!(eeprom.restore(&mut again, y, 2));
        assert!(eeprom.restore(&mut again, byte, 1) && eeprom.restore(&mut again, word, 1));
        assert_eq!(again[..78], registers[..78]);
        eeprom.pointer = 7998;
        assert!(!eeprom.save(&registers, y, 1));
        assert!(eeprom.save(&registers, word, 1));
        assert_eq!(eeprom.pointer, 8000);
    }
}
