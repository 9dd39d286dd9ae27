//! Arrays of up to four dimensions (Integer, floating point and string arrays; DIM).

use std::rc::Rc;

use smallvec::SmallVec;

use super::ast::VariableKind;
use super::firmware::ErrorCode;
use super::value::{Text, to_integer};

/// Most dimensions.
pub const DIMENSIONS: usize = 4;
/// Highest subscript.
pub const LAST: i32 = 32_767;
/// Highest subscript of an array that was never dimensioned.
const DEFAULT_LAST: u16 = 10;

/// An array, dimensioned or not yet.
#[derive(Debug, Clone)]
pub struct Array {
    kind: VariableKind,
    /// Elements in each dimension; empty until it is dimensioned.
    sizes: SmallVec<[u32; DIMENSIONS]>,
    elements: Elements,
}

/// Elements in the order of the last subscript first; behind `Rc`, so that a checkpoint shares them.
#[derive(Debug, Clone)]
enum Elements {
    Real(Rc<[f64]>),
    Integer(Rc<[i32]>),
    Text(Rc<[Text]>),
}

impl Array {
    /// An array that is not dimensioned yet.
    pub fn new(kind: VariableKind) -> Array {
        let elements = match kind {
            VariableKind::Real => Elements::Real(Rc::default()),
            VariableKind::Integer => Elements::Integer(Rc::default()),
            VariableKind::String => Elements::Text(Rc::default()),
        };
        Array {
            kind,
            sizes: SmallVec::new(),
            elements,
        }
    }

    /// Dimensions it; `room` is what is left of the card's memory.
    ///
    /// # Errors
    /// REDIM'D ARRAY the second time, ILLEGAL QUANTITY for a subscript outside 0 to 32767, BAD SUBSCRIPT for more
    /// than four dimensions, OUT OF MEMORY if there is no room.
    pub fn dimension(&mut self, last: &[f64], room: usize) -> Result<(), ErrorCode> {
        if !self.sizes.is_empty() {
            return Err(ErrorCode::RedimdArray);
        }
        if last.is_empty() || last.len() > DIMENSIONS {
            return Err(ErrorCode::BadSubscript);
        }
        let mut sizes = SmallVec::new();
        let mut count: u64 = 1;
        for &last in last {
            let size = u64::from(subscript(last)?) + 1;
            count = count.saturating_mul(size);
            sizes.push(u32::try_from(size).unwrap_or(u32::MAX));
        }
        let count = usize::try_from(count).unwrap_or(usize::MAX);
        if count.saturating_mul(self.element_bytes()) > room {
            return Err(ErrorCode::OutOfMemory);
        }
        self.elements = match self.kind {
            VariableKind::Real => Elements::Real(vec![0.0; count].into()),
            VariableKind::Integer => Elements::Integer(vec![0; count].into()),
            VariableKind::String => Elements::Text(vec![Text::new(); count].into()),
        };
        self.sizes = sizes;
        Ok(())
    }

    /// Bytes of the card's memory that one element takes: eight, four, or three for a string's descriptor.
    fn element_bytes(&self) -> usize {
        match self.kind {
            VariableKind::Real => 8,
            VariableKind::Integer => 4,
            VariableKind::String => 3,
        }
    }

    /// Bytes of the card's memory that it takes, without the contents of strings.
    pub fn bytes(&self) -> usize {
        if self.sizes.is_empty() {
            0
        } else {
            self.len() * self.element_bytes()
        }
    }

    fn len(&self) -> usize {
        match &self.elements {
            Elements::Real(elements) => elements.len(),
            Elements::Integer(elements) => elements.len(),
            Elements::Text(elements) => elements.len(),
        }
    }

    /// Where the element with one subscript stands: the quick way for the commonest case.
    #[inline(always)]
    pub fn index1(&self, at: f64) -> Option<f64> {
        match self.sizes.as_slice() {
            [size] if at >= 0.0 && at < f64::from(*size) => Some(at.trunc()),
            _ => None,
        }
    }

    /// The number at one subscript, if the array has one dimension and such an element.
    #[inline(always)]
    pub fn number_at(&self, at: f64) -> Option<f64> {
        let index = self.place(at)?;
        match &self.elements {
            Elements::Real(elements) => elements.get(index).copied(),
            Elements::Integer(elements) => elements.get(index).map(|&value| f64::from(value)),
            Elements::Text(_) => None,
        }
    }

    /// Sets the number at one subscript; false, and nothing done, where that needs more than a store: a checkpoint may
    /// share the elements.
    #[inline(always)]
    pub fn set_number_at(&mut self, at: f64, value: f64) -> bool {
        let Some(index) = self.place(at) else {
            return false;
        };
        match &mut self.elements {
            Elements::Real(elements) => {
                let elements = Rc::get_mut(elements);
                match elements.and_then(|elements| elements.get_mut(index)) {
                    Some(element) => *element = value,
                    None => return false,
                }
            }
            Elements::Integer(elements) => {
                let elements = Rc::get_mut(elements);
                let element = elements.and_then(|elements| elements.get_mut(index));
                match (element, to_integer(value)) {
                    (Some(element), Ok(value)) => *element = value,
                    _ => return false,
                }
            }
            Elements::Text(_) => return false,
        }
        true
    }

    /// The place of one subscript, which may lie behind the last element.
    #[inline(always)]
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // `as` saturates, behind any array
    fn place(&self, at: f64) -> Option<usize> {
        (self.sizes.len() == 1 && at >= 0.0).then_some(at as usize)
    }

    /// Where an element stands, dimensioning the array to 10 in each direction on its first use (D29).
    ///
    /// # Errors
    /// ILLEGAL QUANTITY for a subscript that no array can have, BAD SUBSCRIPT for one that this array has not, OUT OF
    /// MEMORY if it had to be dimensioned and there is no room.
    pub fn index(&mut self, subscripts: &[f64], room: usize) -> Result<f64, ErrorCode> {
        if self.sizes.is_empty() {
            let last = [f64::from(DEFAULT_LAST); DIMENSIONS];
            self.dimension(
                last.get(..subscripts.len())
                    .ok_or(ErrorCode::BadSubscript)?,
                room,
            )?;
        }
        let mut index: u64 = 0;
        for (&at, &size) in subscripts.iter().zip(&self.sizes) {
            let at = subscript(at)?;
            if at >= size {
                return Err(ErrorCode::BadSubscript);
            }
            index = index * u64::from(size) + u64::from(at);
        }
        if subscripts.len() != self.sizes.len() {
            return Err(ErrorCode::BadSubscript);
        }
        // At most 2^53 by far: the card's memory bounds it.
        Ok(u32::try_from(index).map_or(f64::NAN, f64::from))
    }

    /// A numeric element.
    #[inline(always)]
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // an index made by this array
    pub fn number(&self, index: f64) -> Option<f64> {
        match &self.elements {
            Elements::Real(elements) => elements.get(index as usize).copied(),
            Elements::Integer(elements) => {
                elements.get(index as usize).map(|&value| f64::from(value))
            }
            Elements::Text(_) => None,
        }
    }

    /// Sets a numeric element.
    ///
    /// # Errors
    /// ILLEGAL QUANTITY for what an integer array cannot hold.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // an index made by this array
    pub fn set_number(&mut self, index: f64, value: f64) -> Result<(), ErrorCode> {
        match &mut self.elements {
            Elements::Real(elements) => {
                if let Some(element) = Rc::make_mut(elements).get_mut(index as usize) {
                    *element = value;
                }
            }
            Elements::Integer(elements) => {
                let value = to_integer(value)?;
                if let Some(element) = Rc::make_mut(elements).get_mut(index as usize) {
                    *element = value;
                }
            }
            Elements::Text(_) => return Err(ErrorCode::TypeMismatch),
        }
        Ok(())
    }

    /// The elements of an integer array of one dimension, for a cam.
    pub fn table(&self) -> Option<&Rc<[i32]>> {
        match &self.elements {
            Elements::Integer(elements) if self.sizes.len() == 1 => Some(elements),
            _ => None,
        }
    }

    /// The first two elements of a row of an integer array of two dimensions.
    pub fn pair(&self, row: usize) -> Option<(i32, i32)> {
        let Elements::Integer(elements) = &self.elements else {
            return None;
        };
        let &[rows, columns] = self.sizes.as_slice() else {
            return None;
        };
        let columns = usize::try_from(columns)
            .ok()
            .filter(|&columns| columns > 1)?;
        let first = (row < usize::try_from(rows).ok()?).then_some(row * columns)?;
        Some((*elements.get(first)?, *elements.get(first + 1)?))
    }

    /// Sets the first elements of an integer array.
    pub fn fill(&mut self, values: &[i32]) {
        if let Elements::Integer(elements) = &mut self.elements {
            let elements = Rc::make_mut(elements).iter_mut();
            elements
                .zip(values)
                .for_each(|(element, &value)| *element = value);
        }
    }

    /// A string element.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // an index made by this array
    pub fn text(&self, index: f64) -> Option<&Text> {
        match &self.elements {
            Elements::Text(elements) => elements.get(index as usize),
            _ => None,
        }
    }

    /// Sets a string element and returns by how many bytes the array's contents grew.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // an index made by this array
    pub fn set_text(&mut self, index: f64, text: &Text) -> isize {
        let Elements::Text(elements) = &mut self.elements else {
            return 0;
        };
        let Some(element) = Rc::make_mut(elements).get_mut(index as usize) else {
            return 0;
        };
        let grown = text.len().cast_signed() - element.len().cast_signed();
        element.clone_from(text);
        grown
    }
}

/// A subscript as an element number.
fn subscript(value: f64) -> Result<u32, ErrorCode> {
    let at = to_integer(value)?;
    if at > LAST {
        return Err(ErrorCode::IllegalQuantity);
    }
    u32::try_from(at).map_err(|_| ErrorCode::IllegalQuantity)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_array_is_made_on_first_use_with_eleven_elements_each_way() {
        let mut array = Array::new(VariableKind::Real);
        assert_eq!(array.index(&[10.0, 10.0], 10_000), Ok(120.0));
        assert_eq!(
            array.index(&[11.0, 0.0], 10_000),
            Err(ErrorCode::BadSubscript)
        );
        assert_eq!(array.index(&[1.0], 10_000), Err(ErrorCode::BadSubscript));
        assert_eq!(
            array.index(&[-1.0, 0.0], 10_000),
            Err(ErrorCode::IllegalQuantity)
        );
        assert_eq!(array.dimension(&[5.0], 10_000), Err(ErrorCode::RedimdArray));
    }

    #[test]
    fn a_huge_array_is_out_of_memory_and_costs_nothing() {
        let mut array = Array::new(VariableKind::Real);
        assert_eq!(
            array.dimension(&[32_767.0, 32_767.0], 1 << 20),
            Err(ErrorCode::OutOfMemory)
        );
        assert_eq!(
            array.dimension(&[32_768.0], 1 << 20),
            Err(ErrorCode::IllegalQuantity)
        );
        assert_eq!(
            array.dimension(&[32_767.0, 32_767.0, 32_767.0, 32_767.0], 1 << 20),
            Err(ErrorCode::OutOfMemory)
        );
        assert_eq!(array.bytes(), 0);
    }

    #[test]
    fn integer_elements_take_the_floor() {
        let mut array = Array::new(VariableKind::Integer);
        let at = array.index(&[3.0], 1000).unwrap();
        array.set_number(at, -2.5).unwrap();
        assert_eq!(array.number(at), Some(-3.0));
        assert_eq!(array.set_number(at, 3e9), Err(ErrorCode::IllegalQuantity));
    }
}
