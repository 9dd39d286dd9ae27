//! Register operations: assignments, comparisons and the expressions in them (6-5).

use super::moves::bounded;
use super::scan::Scan;
use super::{Flow, Outcome, RegisterMode, Run, World, known};
use crate::unidex3::indexer::{Axis, Feedrate};
use crate::unidex3::trouble::Trouble;

/// A register that a program reads and sets.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Register {
    /// The position register of an axis.
    Position(Axis),
    /// X1 to X4, from 0.
    X(u8),
    /// Y1 to Y4, from 0.
    Y(u8),
}

impl Register {
    /// `X`, `Y3`.
    pub fn from_name(name: &[u8]) -> Option<Register> {
        let (register, rest) = match name {
            [b'X', rest @ ..] => (Register::Position(Axis::X), rest),
            [b'Y', rest @ ..] => (Register::Position(Axis::Y), rest),
            _ => return None,
        };
        match (register, rest) {
            (_, []) => Some(register),
            (Register::Position(Axis::X), [digit @ b'1'..=b'4']) => Some(Register::X(digit - b'1')),
            (_, [digit @ b'1'..=b'4']) => Some(Register::Y(digit - b'1')),
            _ => None,
        }
    }

    /// As it is written.
    pub fn word(self) -> &'static str {
        let of = |words: [&'static str; 4], index: u8| words.get(usize::from(index)).copied();
        match self {
            Register::Position(Axis::X) => Some("X"),
            Register::Position(Axis::Y) => Some("Y"),
            Register::X(index) => of(["X1", "X2", "X3", "X4"], index),
            Register::Y(index) => of(["Y1", "Y2", "Y3", "Y4"], index),
        }
        .unwrap_or_default()
    }
}

/// What both sides of a comparison may be to each other.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
struct Relation {
    less: bool,
    equal: bool,
    greater: bool,
}

impl Relation {
    fn holds(self, left: i64, right: i64) -> bool {
        match left.cmp(&right) {
            std::cmp::Ordering::Less => self.less,
            std::cmp::Ordering::Equal => self.equal,
            std::cmp::Ordering::Greater => self.greater,
        }
    }
}

impl Run {
    pub(super) fn is_comparing(&self) -> bool {
        let mode = self.modes.register;
        matches!(mode, RegisterMode::SkipIfTrue | RegisterMode::SkipIfFalse)
    }

    /// X or Y, with 1 to 4 behind it or not.
    pub(super) fn scan_register(
        scan: &mut Scan<'_>,
        world: &World<'_>,
    ) -> Result<Register, Trouble> {
        let start = scan.at;
        scan.at += 1;
        if matches!(scan.peek(), Some(b'1'..=b'4')) {
            scan.at += 1;
        }
        let name = scan.text.get(start..scan.at).unwrap_or_default();
        let register = Register::from_name(name).ok_or(Trouble::IllegalCharacter)?;
        known(register.word(), world, Trouble::IllegalCharacter)?;
        Ok(register)
    }

    /// Registers and numbers with `+` and `-` between them.
    pub(super) fn expression(
        &self,
        scan: &mut Scan<'_>,
        world: &World<'_>,
    ) -> Result<i64, Trouble> {
        let mut sum = 0_i64;
        let mut negative = match scan.peek() {
            Some(sign @ (b'+' | b'-')) => {
                scan.at += 1;
                known(
                    if sign == b'-' { "-" } else { "+" },
                    world,
                    Trouble::IllegalCharacter,
                )?;
                sign == b'-'
            }
            _ => false,
        };
        loop {
            let value = match scan.peek() {
                Some(b'X' | b'Y') => {
                    let register = Run::scan_register(scan, world)?;
                    self.register(register, world.indexer)
                }
                _ => scan.digits().ok_or(Trouble::IllegalCharacter)?,
            };
            sum = sum.saturating_add(if negative { -value } else { value });
            match scan.peek() {
                Some(sign @ (b'+' | b'-')) => {
                    scan.at += 1;
                    let word = if sign == b'-' { "-" } else { "+" };
                    known(word, world, Trouble::IllegalCharacter)?;
                    negative = sign == b'-';
                }
                _ => return bounded(sum),
            }
        }
    }

    /// G45, G46: skips to the end of the block, or goes on in normal mode.
    pub(super) fn comparison(&mut self, scan: &mut Scan<'_>, world: &World<'_>) -> Outcome {
        let left = self.expression(scan, world)?;
        let relation = relation(scan, world)?;
        let right = self.expression(scan, world)?;
        let skip_if = self.modes.register == RegisterMode::SkipIfTrue;
        // The rest of the block is no comparison any more (D256).
        self.modes.register = RegisterMode::Normal;
        match relation.holds(left, right) == skip_if {
            true => self.skip(scan.at),
            false => Ok(Flow::Next),
        }
    }

    /// G47: `X1=`, `Y=`, `F=`, `F1=`.
    pub(super) fn assignment(&mut self, scan: &mut Scan<'_>, world: &mut World<'_>) -> Outcome {
        if scan.peek() == Some(b'F') {
            return self.assign_feedrate(scan, world);
        }
        let register = Run::scan_register(scan, world)?;
        if !scan.eat(b'=') {
            return Err(Trouble::IllegalCharacter);
        }
        known("=", world, Trouble::IllegalCharacter)?;
        let value = self.expression(scan, world)?;
        self.set_register(register, value, world.indexer, world.now);
        Ok(Flow::Next)
    }

    fn assign_feedrate(&mut self, scan: &mut Scan<'_>, world: &World<'_>) -> Outcome {
        scan.at += 1;
        let word = match scan.peek() {
            Some(b'1') => "F1",
            Some(b'2') => "F2",
            _ => "F",
        };
        known(word, world, Trouble::IllegalCharacter)?;
        scan.at += word.len() - 1;
        if !scan.eat(b'=') || (word == "F" && !self.modes.vector) {
            return Err(Trouble::IllegalCharacter);
        }
        let value = self.expression(scan, world)?;
        let value = u32::try_from(value).map_err(|_| Trouble::F)?;
        let feedrate = Feedrate::frequency(value).ok_or(Trouble::F)?;
        match word {
            "F1" => self.modes.feedrates.x = feedrate,
            "F2" => self.modes.feedrates.y = feedrate,
            _ => self.modes.vector_feedrate = Some(feedrate),
        }
        Ok(Flow::Next)
    }
}

fn relation(scan: &mut Scan<'_>, world: &World<'_>) -> Result<Relation, Trouble> {
    let mut relation = Relation::default();
    let start = scan.at;
    loop {
        let part = match scan.peek() {
            Some(b'<') => &mut relation.less,
            Some(b'=') => &mut relation.equal,
            Some(b'>') => &mut relation.greater,
            _ => break,
        };
        *part = true;
        scan.at += 1;
    }
    let word = scan.text.get(start..scan.at).unwrap_or_default();
    let word = std::str::from_utf8(word).unwrap_or_default();
    known(word, world, Trouble::IllegalCharacter)?;
    match word.len() {
        1..=3 => Ok(relation),
        _ => Err(Trouble::IllegalCharacter),
    }
}
