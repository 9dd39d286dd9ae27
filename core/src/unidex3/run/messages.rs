//! Messages: what stands between quotes, on the display or in the buffer (6-12, 6-13).

use super::registers::Register;
use super::scan::Scan;
use super::{Flow, Outcome, Run, Shown, World, known};
use crate::unidex3::firmware::MESSAGE;
use crate::unidex3::trouble::Trouble;

impl Run {
    pub(super) fn message(&mut self, scan: &mut Scan<'_>, world: &mut World<'_>) -> Outcome {
        known("\"text\"", world, Trouble::IllegalCharacter)?;
        scan.at += 1;
        let start = scan.at;
        let rest = scan.text.get(start..).unwrap_or_default();
        let length = rest.iter().position(|&byte| byte == b'"');
        let length = length.ok_or(Trouble::IllegalCharacter)?;
        scan.at = start + length + 1;
        let inside = rest.get(..length).unwrap_or_default();
        let text = self.expanded(inside.get(..MESSAGE).unwrap_or(inside), world);
        if std::mem::take(&mut self.to_buffer) {
            self.buffer.set(&text);
        } else {
            let mut shown = [b' '; 8];
            for (place, &byte) in shown.iter_mut().zip(&text) {
                *place = byte;
            }
            *world.show = Some(Shown { text: shown });
        }
        Ok(Flow::Next)
    }

    /// The characters with the values of what stands between `<` and `>`.
    fn expanded(&self, inside: &[u8], world: &World<'_>) -> Vec<u8> {
        let mut text = Vec::new();
        let mut rest = inside;
        while let Some((&byte, behind)) = rest.split_first() {
            let close = behind.iter().position(|&byte| byte == b'>');
            let name = close.and_then(|close| behind.get(..close));
            let value = (byte == b'<').then(|| name.and_then(|name| self.value(name, world)));
            match (value.flatten(), close) {
                (Some(value), Some(close)) => {
                    text.extend(value);
                    rest = behind.get(close + 1..).unwrap_or_default();
                }
                _ => {
                    text.push(byte);
                    rest = behind;
                }
            }
        }
        text
    }

    /// What `X`, `Y3/5`, `C`, `M` or `F` stand for.
    fn value(&self, name: &[u8], world: &World<'_>) -> Option<Vec<u8>> {
        let known = |word| known(word, world, Trouble::IllegalCharacter).ok();
        let bits = |bits: u8, count: u8| {
            let bit = |index: u8| b'0' + (bits >> index & 1);
            Some((0..count).rev().map(bit).collect())
        };
        match name {
            b"C" => {
                known("\"<C>\"")?;
                let level = |input: u8| u8::from(world.indexer.input(input)) << (input - 1);
                bits((1..=4).map(level).sum(), 4)
            }
            b"M" => known("\"<M>\"").and_then(|()| bits(self.outputs, 8)),
            b"F" => known("\"<F>\"").and_then(|()| bits(self.flags, 8)),
            _ => {
                let mut parts = name.splitn(2, |&byte| byte == b'/');
                let register = Register::from_name(parts.next()?)?;
                let places = match parts.next() {
                    None => known("\"<X>\"").map(|()| 10)?,
                    Some(digits) => known("\"<X/n>\"").and_then(|()| places(digits))?,
                };
                Some(formatted(self.register(register, world.indexer), places))
            }
        }
    }
}

/// 1 to 10; none or 0 is ten (6-12 B).
fn places(digits: &[u8]) -> Option<usize> {
    match std::str::from_utf8(digits).ok()? {
        "" => Some(10),
        digits => match digits.parse().ok()? {
            0 => Some(10),
            places @ 1..=10 => Some(places),
            _ => None,
        },
    }
}

/// The low digits of a value in so many places, the first of them a `-` if it is negative.
pub fn formatted(value: i64, places: usize) -> Vec<u8> {
    let digits = format!("{:010}", value.unsigned_abs());
    let sign = usize::from(value < 0);
    let low = digits.len().saturating_sub(places.saturating_sub(sign));
    let mut text = vec![b'-'; sign];
    text.extend(digits.bytes().skip(low));
    text
}
