//! The drive's parameters by their object numbers, as `sdoread` and `sdowrite` reach them.
//!
//! Source: "The Drive related functions"; numbers, names and defaults from the public description of the drive. What an
//! object does where the manual says nothing is D201 to D205.

/// What went wrong with the last access, as `sdoerror` tells it (the table "Error code for PLD read/write SDO").
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[repr(u8)]
pub enum SdoError {
    /// There is no such object.
    InvalidNumber = 0x07,
    /// The object can only be read.
    ReadOnly = 0x0B,
    /// Not while the drive is enabled.
    DriveState = 0x0D,
    /// Below the least value.
    TooSmall = 0x0E,
    /// Above the greatest value.
    TooGreat = 0x0F,
}

/// An object of the drive, by the drive's own name.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[allow(missing_docs)] // the names are the drive's
pub enum Object {
    Accr,
    Decr,
    Dref,
    Drvstat,
    Gp,
    Gpfbt,
    Gptn,
    Gpv,
    Gv,
    Ipeak,
    Nref,
    Opmode,
    Pfb,
    Pgeari,
    Pgearo,
    Prbase,
    Prd,
    Ptmin,
    Refip,
    Roffs,
    Status,
    Vjog,
    Vref,
    /// DPRVAR1 to DPRVAR16.
    Dprvar(u8),
}

/// How an object may be written.
struct Range {
    object: Object,
    number: i32,
    default: i32,
    least: i32,
    most: i32,
    access: Access,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Access {
    Read,
    Write,
    /// Only while the drive is disabled.
    WriteDisabled,
}

const fn row(
    number: i32,
    object: Object,
    default: i32,
    least: i32,
    most: i32,
    access: Access,
) -> Range {
    Range {
        object,
        number,
        default,
        least,
        most,
        access,
    }
}

use Access::{Read, Write, WriteDisabled};

const MAX: i32 = i32::MAX;

/// Object number 3500h + n, default, least and greatest value.
const OBJECTS: [Range; 23] = [
    row(0x3502, Object::Accr, 10, 1, 32_767, Write),
    row(0x3524, Object::Decr, 10, 1, 32_767, Write),
    row(0x352C, Object::Dref, 0, 0, 2, Write),
    row(0x352D, Object::Drvstat, 0, 0, 0, Read),
    row(0x3542, Object::Gp, 150, 10, 25_000, Write),
    row(0x3543, Object::Gpfbt, 1000, 0, 1500, Write),
    row(0x3546, Object::Gptn, 50_000, 1000, 200_000, Write),
    row(0x3547, Object::Gpv, 3000, 10, 60_000, Write),
    row(0x3548, Object::Gv, 1000, 10, 60_000, Write),
    row(0x356E, Object::Ipeak, IPEAK, 0, IPEAK, Write),
    row(0x35AD, Object::Nref, 0, 0, 8, Write),
    row(0x35B4, Object::Opmode, 5, 0, 8, WriteDisabled),
    row(0x35C8, Object::Pfb, 0, 0, 0, Read),
    row(0x35CA, Object::Pgeari, 10_000, 1, MAX, WriteDisabled),
    row(0x35CB, Object::Pgearo, 1 << 20, 1, MAX, WriteDisabled),
    row(0x35D1, Object::Prbase, 20, 16, 20, WriteDisabled),
    row(0x35D2, Object::Prd, 0, 0, 0, Read),
    row(0x35D6, Object::Ptmin, 1, 1, 32_767, Write),
    row(0x35E2, Object::Refip, IPEAK / 8, 0, IPEAK, Write),
    row(0x35E7, Object::Roffs, 0, -MAX, MAX, Write),
    row(0x35FD, Object::Status, 0, 0, 0, Read),
    row(0x3621, Object::Vjog, 10_000, -MAX, MAX, Write),
    row(0x3628, Object::Vref, 10_000, 1, MAX, Write),
];

/// Lengths on the planner's scale go no further: 32 bits of counts.
const LONGEST: i128 = 1 << 40;
/// Peak current of the drive in mA (D204).
const IPEAK: i32 = 6000;
/// The first of the sixteen user variables.
const FIRST_USER_VARIABLE: i32 = 0x36A6;

impl Object {
    /// The object of a number, in full (3500h + n) or short (n).
    pub fn from_number(number: i32) -> Option<Object> {
        let number = if (0..0x3500).contains(&number) {
            number + 0x3500
        } else {
            number
        };
        let user = number.checked_sub(FIRST_USER_VARIABLE)?;
        if let Ok(user @ 0..=15) = u8::try_from(user) {
            return Some(Object::Dprvar(user + 1));
        }
        let found = OBJECTS.iter().find(|range| range.number == number)?;
        Some(found.object)
    }

    fn index(self) -> Option<usize> {
        OBJECTS.iter().position(|range| range.object == self)
    }
}

/// The values of the drive's parameters.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Objects {
    values: [i32; OBJECTS.len()],
    user: [i32; 16],
    /// Of the last access.
    error: Option<SdoError>,
}

impl Objects {
    /// As at power-up.
    pub fn new() -> Objects {
        Objects {
            values: OBJECTS.map(|range| range.default),
            user: [0; 16],
            error: None,
        }
    }

    /// The value of a parameter; what the drive measures is not kept here.
    pub fn get(&self, object: Object) -> i32 {
        match object {
            Object::Dprvar(number) => {
                let at = usize::from(number).wrapping_sub(1);
                self.user.get(at).copied().unwrap_or(0)
            }
            _ => {
                let value = object.index().and_then(|index| self.values.get(index));
                value.copied().unwrap_or(0)
            }
        }
    }

    /// Sets a user variable, 1 to 16.
    pub fn set_user(&mut self, number: u8, value: i32) {
        let at = usize::from(number).wrapping_sub(1);
        if let Some(variable) = self.user.get_mut(at) {
            *variable = value;
        }
    }

    /// `sdowrite`; the result is kept for `sdoerror`. Whether it was written.
    pub fn write(&mut self, number: i32, value: i32, enabled: bool) -> bool {
        let written = self.try_write(number, value, enabled);
        self.error = written.err();
        self.error.is_none()
    }

    fn try_write(&mut self, number: i32, value: i32, enabled: bool) -> Result<(), SdoError> {
        let object = Object::from_number(number).ok_or(SdoError::InvalidNumber)?;
        if let Object::Dprvar(number) = object {
            self.set_user(number, value);
            return Ok(());
        }
        let index = object.index().ok_or(SdoError::InvalidNumber)?;
        let range = OBJECTS.get(index).ok_or(SdoError::InvalidNumber)?;
        match range.access {
            Read => return Err(SdoError::ReadOnly),
            WriteDisabled if enabled => return Err(SdoError::DriveState),
            Write | WriteDisabled => {}
        }
        if value < range.least {
            return Err(SdoError::TooSmall);
        }
        // PRBASE knows two values only.
        if value > range.most || object == Object::Prbase && value != 16 && value != 20 {
            return Err(SdoError::TooGreat);
        }
        if let Some(slot) = self.values.get_mut(index) {
            *slot = value;
        }
        Ok(())
    }

    /// Notes how a reading went, and gives what is read.
    pub fn reading(&mut self, number: i32) -> Option<Object> {
        let object = Object::from_number(number);
        self.error = match object {
            Some(_) => None,
            None => Some(SdoError::InvalidNumber),
        };
        object
    }

    /// `sdoerror`: 0 after an access that went well.
    pub fn error(&self) -> i32 {
        self.error.map_or(0, |error| i32::from(error as u8))
    }

    /// A parameter as a part of its default.
    pub fn part(&self, object: Object) -> f64 {
        let default = object.index().and_then(|index| OBJECTS.get(index));
        let default = default.map_or(1, |range| range.default);
        f64::from(self.get(object)) / f64::from(default)
    }

    /// A current in mA as a part of the drive's peak.
    pub fn torque(&self, object: Object) -> f64 {
        f64::from(self.get(object)) / f64::from(IPEAK)
    }

    /// A length of the drive, in um at default gearing, in units of which `turn` are one revolution; the lengths of
    /// planner and drive relate as PGEARO, PGEARI and PRBASE say.
    pub fn length(&self, length: i32, turn: i64) -> i64 {
        let (input, output) = (self.get(Object::Pgeari), self.get(Object::Pgearo));
        let revolution = 1i128 << self.get(Object::Prbase);
        let scaled = i128::from(length) * i128::from(output) * i128::from(turn);
        let scaled = scaled.div_euclid(i128::from(input.max(1)) * revolution);
        i64::try_from(scaled.clamp(-LONGEST, LONGEST)).unwrap_or(0)
    }
}
