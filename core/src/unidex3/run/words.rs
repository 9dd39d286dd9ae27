//! What each codeword does: F, D, M and the dispatch.

use super::moves::Legs;
use super::scan::Scan;
use super::{Flow, Outcome, RegisterMode, Run, Wait, World, known};
use crate::time::Nanos;
use crate::unidex3::indexer::{Axis, Feedrate};
use crate::unidex3::trouble::Trouble;

/// A dwell is shorter than this, in ms (5-3).
const LONGEST_DWELL: u32 = 4_000_000;
/// Edges that `D=` counts at most.
const MOST_EDGES: i64 = 999_999_999;

impl Run {
    /// Carries out the codeword at `scan`, and moves it behind.
    pub(super) fn codeword(&mut self, scan: &mut Scan<'_>, world: &mut World<'_>) -> Outcome {
        let Some(letter) = scan.next() else {
            return self.end_of_program(world);
        };
        match letter {
            b'X' | b'Y' | b'+' | b'-' | b'0'..=b'9' if self.is_comparing() => {
                scan.at -= 1;
                self.comparison(scan, world)
            }
            b'X' | b'Y' | b'F' if self.modes.register == RegisterMode::Assign => {
                scan.at -= 1;
                self.assignment(scan, world)
            }
            b'X' | b'Y' => {
                scan.at -= 1;
                self.axis_move(scan, world)
            }
            b'F' => self.feedrate(scan, world),
            b'D' => dwell(scan, world),
            b'M' => self.miscellaneous(scan, world),
            b'N' => {
                scan.at -= 1;
                self.sequence(scan, world)
            }
            b'G' => self.preparatory(scan, world),
            b'"' => {
                scan.at -= 1;
                self.message(scan, world)
            }
            b'*' => {
                known("*", world, Trouble::IllegalCharacter)?;
                if self.is_comparing() {
                    self.modes.register = RegisterMode::Normal;
                }
                Ok(Flow::Block)
            }
            b'0'..=b'9' => Err(Trouble::NoCommand),
            _ => Err(Trouble::IllegalCharacter),
        }
    }

    /// An F codeword that stands alone: of the path, or of the joystick (5-1).
    fn feedrate(&mut self, scan: &mut Scan<'_>, world: &World<'_>) -> Outcome {
        match self.read_feedrate(scan, world)? {
            None => {}
            Some(feedrate) if self.modes.vector => self.modes.vector_feedrate = Some(feedrate),
            Some(_) => return Err(Trouble::F),
        }
        Ok(Flow::Next)
    }

    /// What stands behind an F: `None` for the joystick's factor, which is noted.
    pub(super) fn read_feedrate(
        &mut self,
        scan: &mut Scan<'_>,
        world: &World<'_>,
    ) -> Result<Option<Feedrate>, Trouble> {
        self.feedrate_value(scan, world.without)
    }

    fn feedrate_value(
        &mut self,
        scan: &mut Scan<'_>,
        without: Option<&str>,
    ) -> Result<Option<Feedrate>, Trouble> {
        let word = match scan.peek() {
            Some(b'=') => "F=n",
            Some(b'-') => "F-n",
            _ => "Fn",
        };
        if without == Some(word) {
            return Err(Trouble::F);
        }
        if scan.eat(b'-') {
            self.parameters.joystick = scan.within(2, 65_535).ok_or(Trouble::F)?;
            return Ok(None);
        }
        let period = scan.eat(b'=');
        if period && !scan.peek().is_some_and(|byte| byte.is_ascii_digit()) {
            // A register behind F= is one only in G47 (6-5 A).
            return Err(Trouble::IllegalCharacter);
        }
        let value = scan.within(1, 4_000_000_000).ok_or(Trouble::F)?;
        if scan.peek() == Some(b'=') {
            // F1= is a register operation, in G47 alone.
            return Err(Trouble::IllegalCharacter);
        }
        let feedrate = match period {
            true => Feedrate::period(value),
            false => Feedrate::frequency(value),
        };
        feedrate.map(Some).ok_or(Trouble::F)
    }

    /// See [`Run::slew_feedrates`]; ends before what is none of them.
    pub(super) fn slew_words(
        &mut self,
        scan: &mut Scan<'_>,
        without: Option<&str>,
    ) -> Result<(), Trouble> {
        let mut axes = Axis::BOTH.to_vec();
        while let Some(letter) = scan.peek() {
            match letter {
                b'X' | b'Y' => {
                    scan.at += 1;
                    axes = vec![if letter == b'X' { Axis::X } else { Axis::Y }];
                    scan.signed();
                }
                b'F' => {
                    scan.at += 1;
                    if let Some(feedrate) = self.feedrate_value(scan, without)? {
                        for &axis in &axes {
                            *self.modes.feedrates.of_mut(axis) = feedrate;
                        }
                    }
                }
                _ => break,
            }
        }
        Ok(())
    }

    fn miscellaneous(&mut self, scan: &mut Scan<'_>, world: &mut World<'_>) -> Outcome {
        if scan.eat(b'=') {
            known("M=n", world, Trouble::M)?;
            let value = scan.within(0, 255).ok_or(Trouble::M)?;
            self.set_outputs(u8::try_from(value).unwrap_or_default(), world.oem_in);
            return Ok(Flow::Next);
        }
        if scan.eat(b'-') {
            known("M-n", world, Trouble::M)?;
            let value = scan.within(0, 99).ok_or(Trouble::M)?;
            let digits = u8::try_from(value / 10 * 16 + value % 10).unwrap_or_default();
            self.set_outputs(digits, world.oem_in);
            return Ok(Flow::Next);
        }
        let number = scan.digits().ok_or(Trouble::M)?;
        let word = match number {
            0 => "M0",
            2 => "M2",
            30 => "M30",
            47 => "M47",
            89 => "M89",
            99 => "M99",
            _ => return Err(Trouble::M),
        };
        known(word, world, Trouble::M)?;
        match number {
            0 => Ok(Flow::Wait(Wait::Stop)),
            2 | 30 => self.end_of_program(world),
            47 => self.restart(),
            89 => self.pop().map(|_| Flow::Next),
            _ => self.return_from(world),
        }
    }

    /// What an X or Y codeword has behind it is for moves; see there.
    fn axis_move(&mut self, scan: &mut Scan<'_>, world: &mut World<'_>) -> Outcome {
        let legs: Legs = self.legs(scan, world)?;
        self.start_move(legs, world)
    }
}

/// D and `D=` (5-3).
fn dwell(scan: &mut Scan<'_>, world: &mut World<'_>) -> Outcome {
    if scan.eat(b'=') {
        known("D=n", world, Trouble::D)?;
        let edges = scan.digits().filter(|&edges| edges <= MOST_EDGES);
        let edges = u64::try_from(edges.ok_or(Trouble::D)?).unwrap_or_default();
        world.indexer.count(world.now, edges);
        return Ok(Flow::Wait(Wait::Count));
    }
    known("Dn", world, Trouble::D)?;
    let time = scan.within(0, LONGEST_DWELL - 1).ok_or(Trouble::D)?;
    let time = Nanos::from_millis(u64::from(time));
    let until = Nanos(world.now.0.saturating_sub(world.indexer.held_for().0)) + time;
    Ok(Flow::Wait(Wait::Dwell { until }))
}
