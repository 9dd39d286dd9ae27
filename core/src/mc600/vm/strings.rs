//! Strings: every operation reads whole, then writes.

use super::super::code::{Code, Op, STRING_TEMPORARIES};
use super::super::firmware::{ErrorCode, MEMORY};
use super::super::value::{self, Text, append, in_range, is_integer, to_byte};
use super::Vm;
use crate::number;

impl Vm {
    /// An operation on strings alone.
    pub(super) fn text(&mut self, op: Op) -> Result<(), ErrorCode> {
        match op.code {
            Code::StringMove => self.string_move(op),
            Code::StringAppend => self.string_append(op)?,
            Code::StringLoad => {
                let element = self
                    .array(op.a)
                    .and_then(|array| array.text(self.register(op.b)));
                let text = element.cloned().unwrap_or_default();
                self.set_string(op.c, text);
            }
            Code::StringStore => self.string_store(op)?,
            Code::StringEqual => self.compare(op, |a, b| a == b),
            Code::StringNotEqual => self.compare(op, |a, b| a != b),
            Code::StringLess => self.compare(op, |a, b| a < b),
            Code::StringLessEqual => self.compare(op, |a, b| a <= b),
            Code::Chr => {
                let byte = to_byte(self.register(op.a))?;
                self.set_string(op.c, Text::from_slice(&[byte]));
            }
            Code::Str => {
                let mut digits = Vec::new();
                self.format_number(op, &mut digits);
                self.set_string(op.c, Text::from_slice(&digits));
            }
            Code::Left | Code::Right | Code::MidRest | Code::Mid => self.part(op)?,
            Code::Len => {
                let length = self.string(op.a).len();
                self.set_register(op.c, u32::try_from(length).map_or(0.0, f64::from));
            }
            Code::Asc => {
                let first = *self
                    .string(op.a)
                    .first()
                    .ok_or(ErrorCode::IllegalQuantity)?;
                self.set_register(op.c, f64::from(first));
            }
            Code::Val => {
                let value =
                    number::leading(self.string(op.a)).map_or(0.0, |(constant, _)| constant.real());
                self.set_register(op.c, in_range(value)?);
            }
            _ => {}
        }
        Ok(())
    }

    fn string_move(&mut self, op: Op) {
        let Ok([from, to]) = self
            .strings
            .get_disjoint_mut([usize::from(op.a), usize::from(op.c)])
        else {
            return; // to itself
        };
        if op.a < STRING_TEMPORARIES {
            // A temporary is never read again.
            std::mem::swap(from, to);
        } else {
            to.clear();
            value::extend(to, from);
        }
    }

    fn string_append(&mut self, op: Op) -> Result<(), ErrorCode> {
        let (from, to) = (usize::from(op.a), usize::from(op.c));
        match self.strings.get_disjoint_mut([from, to]) {
            Ok([from, to]) => append(to, from),
            // A$=A$+A$
            Err(_) => {
                let mut text = Text::from_slice(self.string(op.c));
                append(&mut text, self.string(op.a))?;
                self.set_string(op.c, text);
                Ok(())
            }
        }
    }

    fn string_store(&mut self, op: Op) -> Result<(), ErrorCode> {
        let index = self.register(op.b);
        let text = self
            .strings
            .get(usize::from(op.c))
            .cloned()
            .unwrap_or_default();
        if self.string_bytes.saturating_add(text.len()) > MEMORY {
            return Err(ErrorCode::OutOfMemory);
        }
        let grown = self.array_mut(op.a)?.set_text(index, &text);
        self.string_bytes = self.string_bytes.saturating_add_signed(grown);
        Ok(())
    }

    fn compare(&mut self, op: Op, holds: impl Fn(&[u8], &[u8]) -> bool) {
        let truth = if holds(self.string(op.a), self.string(op.b)) {
            -1.0
        } else {
            0.0
        };
        self.set_register(op.c, truth);
    }

    /// LEFT$, RIGHT$, MID$.
    fn part(&mut self, op: Op) -> Result<(), ErrorCode> {
        let first = usize::from(to_byte(self.register(op.b))?);
        let length = match op.code {
            Code::Mid => usize::from(to_byte(self.register(op.b.saturating_add(1)))?),
            _ => usize::MAX,
        };
        let part = |text: &[u8]| match op.code {
            Code::Left => 0..first.min(text.len()),
            Code::Right => text.len().saturating_sub(first)..text.len(),
            _ => {
                // Positions count from 1; the manual allows 0, which is taken as 1 (D32).
                let start = first.saturating_sub(1).min(text.len());
                start..start.saturating_add(length).min(text.len())
            }
        };
        let (from, to) = (usize::from(op.a), usize::from(op.c));
        match self.strings.get_disjoint_mut([from, to]) {
            Ok([from, to]) => {
                to.clear();
                value::extend(to, from.get(part(from)).unwrap_or_default());
            }
            Err(_) => {
                let text = self.string(op.a);
                let part = Text::from_slice(text.get(part(text)).unwrap_or_default());
                self.set_string(op.c, part);
            }
        }
        Ok(())
    }

    /// A number as PRINT and STR$ write it, without a blank behind it: all its digits if it was computed in integers
    /// and is one, nine otherwise.
    pub(super) fn format_number(&mut self, op: Op, out: &mut Vec<u8>) {
        let value = self.register(op.a);
        let left_integers = std::mem::take(&mut self.left_integers);
        if op.b == 1 && !left_integers && is_integer(value) {
            #[allow(clippy::cast_possible_truncation)] // just checked
            number::integer(value as i32, out);
        } else {
            number::microsoft9(value, out);
        }
    }
}
