//! Interrupts: which source calls which line, and what has fired and not been served.
//!
//! Source: "The Interrupt functions". They are looked at once a sample; the interpreter takes one between two statements.

use super::firmware::ErrorCode;

/// Sources, by the manual's numbers; 19 to 21 are reserved.
const SOURCES: u8 = 32;
const RESERVED: std::ops::RangeInclusive<u8> = 19..=21;

/// The timer (D206).
pub const TIMER: u8 = 17;
/// The cam's index passes 0.
pub const CAM_INDEX: u8 = 18;
/// The first position comparator.
pub const COMPARATORS: u8 = 22;
/// The capture by input 2; that by input 3 follows.
pub const CAPTURES: u8 = 30;

/// What `intsetup` was told, and what has happened since.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Interrupts {
    /// Sources interrupt the program.
    enabled: bool,
    /// The line that each source calls.
    lines: [u16; SOURCES as usize],
    /// Sources that fire when they go from 0 to 1.
    rising: u32,
    /// Sources that fire when they go from 1 to 0.
    falling: u32,
    /// Sources whose subroutine runs: they are disabled until RETI.
    serving: u32,
    /// Sources that have fired and wait.
    pending: u32,
    /// As the sources were last.
    levels: u32,
}

impl Interrupts {
    /// No source set up, the program may be interrupted (D207).
    pub fn new() -> Interrupts {
        Interrupts {
            enabled: true,
            lines: [0; SOURCES as usize],
            rising: 0,
            falling: 0,
            serving: 0,
            pending: 0,
            levels: 0,
        }
    }

    /// Whether `source` is one of the manual's list.
    ///
    /// # Errors
    /// ILLEGAL QUANTITY if it is not.
    pub fn source(number: i32) -> Result<u8, ErrorCode> {
        u8::try_from(number)
            .ok()
            .filter(|source| *source < SOURCES && !RESERVED.contains(source))
            .ok_or(ErrorCode::IllegalQuantity)
    }

    /// `intsetup`, with the sources as they are now. `edge` is 0 off, 1 rising, 2 falling, 3 both.
    pub fn set_up(&mut self, line: u16, source: u8, edge: u8, levels: u32) {
        let bit = bit(source);
        if let Some(vector) = self.lines.get_mut(usize::from(source)) {
            *vector = line;
        }
        self.rising = self.rising & !bit | if edge & 1 != 0 { bit } else { 0 };
        self.falling = self.falling & !bit | if edge & 2 != 0 { bit } else { 0 };
        self.pending &= !bit;
        self.levels = self.levels & !bit | levels & bit;
    }

    /// `intenable`, `intdisable`. What fires while they are held back waits (D207).
    pub fn enable(&mut self, enabled: bool) {
        self.enabled = enabled;
    }

    /// Whether any source is set up.
    pub fn are_set_up(&self) -> bool {
        self.rising | self.falling != 0
    }

    /// The sources as they are after a sample, and those that have fired without having a level.
    pub fn observe(&mut self, levels: u32, pulses: u32) {
        let changed = levels ^ self.levels;
        let risen = changed & levels | pulses;
        let fallen = changed & !levels | pulses;
        self.pending |= (risen & self.rising | fallen & self.falling) & !self.serving;
        self.levels = levels;
    }

    /// Whether the program has to be interrupted.
    pub fn is_pending(&self) -> bool {
        self.pending != 0 && self.enabled
    }

    /// The source that interrupts now, the lowest number first, and its line; it is disabled until [`Interrupts::done`].
    pub fn take(&mut self) -> Option<(u8, u16)> {
        if !self.is_pending() {
            return None;
        }
        let source = u8::try_from(self.pending.trailing_zeros()).ok()?;
        self.pending &= !bit(source);
        self.serving |= bit(source);
        let line = self.lines.get(usize::from(source)).copied()?;
        Some((source, line))
    }

    /// RETI: the source is let in again.
    pub fn done(&mut self, source: u8) {
        self.serving &= !bit(source);
    }
}

/// The bit of a source.
pub fn bit(source: u8) -> u32 {
    1u32.checked_shl(u32::from(source)).unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn edges_fire_once_and_a_source_rests_while_it_is_served() {
        let mut interrupts = Interrupts::new();
        interrupts.set_up(100, 3, 1, 0);
        interrupts.set_up(200, 5, 2, bit(5));
        interrupts.observe(bit(3) | bit(5), 0);
        assert_eq!(interrupts.take(), Some((3, 100)));
        assert_eq!(interrupts.take(), None);
        interrupts.observe(bit(5), 0);
        interrupts.observe(bit(3), 0);
        assert_eq!(interrupts.take(), Some((5, 200)), "3 is being served");
        interrupts.done(3);
        interrupts.observe(0, 0);
        assert_eq!(interrupts.take(), None, "only rising edges");
        interrupts.observe(bit(3), 0);
        assert_eq!(interrupts.take(), Some((3, 100)));
    }

    #[test]
    fn what_fires_while_held_back_waits() {
        let mut interrupts = Interrupts::new();
        interrupts.set_up(100, TIMER, 1, 0);
        interrupts.enable(false);
        interrupts.observe(0, bit(TIMER));
        assert_eq!(interrupts.take(), None);
        interrupts.enable(true);
        assert_eq!(interrupts.take(), Some((TIMER, 100)));
    }
}
