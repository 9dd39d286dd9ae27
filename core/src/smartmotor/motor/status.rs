//! The status word.

/// A bit of the status word; the discriminant is its number ("Status word").
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Flag {
    /// `Bt`: a trajectory is in progress.
    Trajectory = 0,
    /// `Br`: the right limit was active; latched.
    RightLimit = 1,
    /// `Bl`: the left limit was active; latched.
    LeftLimit = 2,
    /// `Bi`: an index position is captured and not read.
    IndexCaptured = 3,
    /// `Bw`: the position went around the 32 bits; latched.
    Wrap = 4,
    /// `Be`: the position error was too large; latched.
    PositionError = 5,
    /// `Bh`: the motor was too hot; latched.
    Overheat = 6,
    /// `Bo`: the motor is off.
    Off = 7,
    /// `Bx`: the index mark is under the encoder now.
    IndexLevel = 8,
    /// `Bp`: the right limit is active now.
    RightNow = 9,
    /// `Bm`: the left limit is active now.
    LeftNow = 10,
    /// `Bd`: a calculation overflowed; latched.
    MathOverflow = 11,
    /// `Bu`: an array index was out of range; latched.
    IndexRange = 12,
    /// `Bs`: a command was not understood; latched.
    Syntax = 13,
    /// `Ba`: the current was at its limit; latched.
    OverCurrent = 14,
    /// `Bk`: the program's checksum is wrong; latched.
    Checksum = 15,
}

/// Letters of the bits, bit 0 first: `Bt`, `Br` and so on.
const LETTERS: &[u8; 16] = b"trliwehoxpmdusak";

const FLAGS: [Flag; 16] = [
    Flag::Trajectory,
    Flag::RightLimit,
    Flag::LeftLimit,
    Flag::IndexCaptured,
    Flag::Wrap,
    Flag::PositionError,
    Flag::Overheat,
    Flag::Off,
    Flag::IndexLevel,
    Flag::RightNow,
    Flag::LeftNow,
    Flag::MathOverflow,
    Flag::IndexRange,
    Flag::Syntax,
    Flag::OverCurrent,
    Flag::Checksum,
];

impl Flag {
    /// The flag of a letter: `t` of `Bt`. Bits of communication (`b`, `c`, `f`) are not of the status word.
    pub fn from_letter(letter: u8) -> Option<Flag> {
        let bit = LETTERS.iter().position(|&known| known == letter)?;
        FLAGS.get(bit).copied()
    }

    /// Its bit in the status word.
    pub const fn mask(self) -> u16 {
        1 << self as u16
    }
}
