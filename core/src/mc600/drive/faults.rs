//! What trips the drive and what it warns of, by the numbers of its own lists (public): F01 to F32, n01 to n32.

use std::fmt;

/// A fault of the drive, F01 to F32.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Fault(u8);

impl Fault {
    /// F03.
    pub const FOLLOWING_ERROR: Fault = Fault(3);
    /// F04.
    pub const FEEDBACK: Fault = Fault(4);
    /// F14; stands for any fault of the drive itself.
    pub const OUTPUT_STAGE: Fault = Fault(14);

    /// Fault Fnn, 1 to 32.
    pub fn from_number(number: u8) -> Option<Fault> {
        (1..=32).contains(&number).then_some(Fault(number))
    }

    /// Its bit of ERRCODE: nn-1.
    pub fn bit(self) -> u32 {
        1 << (self.0 - 1)
    }

    /// The faults of an ERRCODE.
    pub fn all_of(code: u32) -> impl Iterator<Item = Fault> {
        (1..=32)
            .map(Fault)
            .filter(move |fault| fault.bit() & code != 0)
    }
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let name = match self.0 {
            1 => "heat sink",
            2 => "overvoltage",
            3 => "following error",
            4 => "feedback",
            5 => "undervoltage",
            6 => "motor temperature",
            7 => "auxiliary voltage",
            8 => "overspeed",
            9 => "EEPROM",
            10 => "flash",
            11 => "brake",
            12 => "motor phase",
            13 => "internal temperature",
            14 => "output stage",
            15 => "I²t",
            16 => "mains",
            17 => "A/D converter",
            18 => "regen",
            19 => "mains phase",
            20 => "slot",
            21 => "handling",
            22 => "earth",
            23 => "CAN bus off",
            24 => "warning",
            25 => "commutation",
            26 => "limit switch",
            27 => "restart lock",
            32 => "system",
            _ => "reserved",
        };
        write!(f, "F{:02} {name}", self.0)
    }
}

/// STATCODE n10: the positive limit switch is pressed.
pub const WARNING_POSITIVE_LIMIT: u32 = 1 << 9;
/// STATCODE n11: the negative limit switch is pressed.
pub const WARNING_NEGATIVE_LIMIT: u32 = 1 << 10;
