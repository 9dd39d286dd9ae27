//! Disk A: in RAM and disk B: in FLASH (The BASIC Filesystem).

use std::rc::Rc;

use super::firmware::{DISK_A, DISK_B, ErrorCode};
use crate::controller::DiskInfo;
use crate::files::{Disk, matches};

/// The disks for people.
pub const DISKS: &[DiskInfo] = &[
    DiskInfo {
        prefix: "A:",
        words: "RAM, lost with the power",
    },
    DiskInfo {
        prefix: "B:",
        words: "FLASH, kept without power",
    },
];

/// The two disks.
#[derive(Debug, Clone)]
pub struct Disks {
    a: Disk,
    b: Disk,
}

/// Which disk.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Unit {
    /// RAM, the default.
    A,
    /// FLASH.
    B,
}

/// A file's name with its disk, checked.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct FileName {
    unit: Unit,
    name: String,
}

impl FileName {
    /// Reads `[A:|B:]NAME[.EXT]`; without an extension it is `.BAS` (D51), without a disk on A: (D47).
    ///
    /// # Errors
    /// ILLEGAL QUANTITY for what is not a name of eight and three characters (D49).
    pub fn parse(text: &[u8]) -> Result<FileName, ErrorCode> {
        let (unit, rest) = unit_and_rest(text)?;
        let name = with_extension(rest);
        let (stem, extension) = name.split_once('.').unwrap_or((&name, ""));
        let fits = (1..=8).contains(&stem.len()) && extension.len() <= 3;
        let plain = |part: &str| {
            part.bytes()
                .all(|b| b.is_ascii_graphic() && !b"*?:\".,;/\\".contains(&b))
        };
        if fits && plain(stem) && plain(extension) {
            Ok(FileName { unit, name })
        } else {
            Err(ErrorCode::IllegalQuantity)
        }
    }

    /// Reads where a copy of this file goes: a name, or a disk alone, which takes it under the same name (D231).
    ///
    /// # Errors
    /// ILLEGAL QUANTITY as for [`FileName::parse`]; FILE OPEN for the file itself, which is being read.
    pub fn copy_to(&self, text: &[u8]) -> Result<FileName, ErrorCode> {
        let to = match disk_alone(text) {
            Some(unit) => FileName {
                unit,
                name: self.name.clone(),
            },
            None => FileName::parse(text)?,
        };
        if to == *self {
            Err(ErrorCode::FileOpen)
        } else {
            Ok(to)
        }
    }
}

/// A name without an extension is a program's (D51).
fn with_extension(name: String) -> String {
    if name.contains('.') {
        name
    } else {
        format!("{name}.BAS")
    }
}

/// `A:` or `B:` with nothing behind it.
fn disk_alone(text: &[u8]) -> Option<Unit> {
    let (unit, rest) = unit_and_rest(text).ok()?;
    (rest.is_empty() && text.contains(&b':')).then_some(unit)
}

/// Splits off the disk, and takes the rest in upper case.
fn unit_and_rest(text: &[u8]) -> Result<(Unit, String), ErrorCode> {
    let text: String = text
        .trim_ascii()
        .iter()
        .map(|&byte| char::from(byte.to_ascii_uppercase()))
        .collect();
    match text.split_once(':') {
        Some(("A", rest)) => Ok((Unit::A, rest.to_owned())),
        Some(("B", rest)) => Ok((Unit::B, rest.to_owned())),
        Some(_) => Err(ErrorCode::IllegalQuantity),
        None => Ok((Unit::A, text)),
    }
}

/// A mask for the files of a disk; `None` for a disk alone. Without an extension it is for programs, unless it ends in
/// `*` (D230).
fn unit_and_mask(text: &[u8]) -> Result<(Unit, Option<String>), ErrorCode> {
    let (unit, mask) = unit_and_rest(text)?;
    Ok(match mask.as_str() {
        "" => (unit, None),
        any if any.ends_with('*') => (unit, Some(mask)),
        _ => (unit, Some(with_extension(mask))),
    })
}

impl Default for Disks {
    fn default() -> Disks {
        Disks {
            a: Disk::new(DISK_A),
            b: Disk::new(DISK_B),
        }
    }
}

impl Disks {
    /// Formats disk A:, as at power-up.
    pub fn power_up(&mut self) {
        self.a.clear();
    }

    /// A file's bytes.
    pub fn read(&self, name: &FileName) -> Option<Rc<[u8]>> {
        self.disk(name.unit).read(&name.name)
    }

    /// Writes a file whole.
    ///
    /// # Errors
    /// OUT OF MEMORY if the disk has no room (D49).
    pub fn write(&mut self, name: &FileName, bytes: &[u8]) -> Result<(), ErrorCode> {
        let disk = self.disk_mut(name.unit);
        disk.write(&name.name, bytes)
            .map_err(|_| ErrorCode::OutOfMemory)
    }

    /// Erases the files that match a mask (ERASE).
    ///
    /// # Errors
    /// FILE NOT FOUND if there are none; ILLEGAL QUANTITY for a disk that there is not, and for a disk alone, which
    /// only FORMAT empties (D230).
    pub fn erase(&mut self, mask: &[u8]) -> Result<(), ErrorCode> {
        let (unit, mask) = unit_and_mask(mask)?;
        let mask = mask.ok_or(ErrorCode::IllegalQuantity)?;
        let names = self.disk(unit).iter().map(|(name, _)| name);
        let doomed: Vec<String> = names
            .filter(|name| matches(&mask, name))
            .map(str::to_owned)
            .collect();
        if doomed.is_empty() {
            return Err(ErrorCode::FileNotFound);
        }
        for name in doomed {
            self.disk_mut(unit).remove(&name);
        }
        Ok(())
    }

    /// Empties a disk (FORMAT); how many bytes were formatted.
    ///
    /// # Errors
    /// ILLEGAL QUANTITY for anything but a disk alone.
    pub fn format(&mut self, text: &[u8]) -> Result<usize, ErrorCode> {
        let unit = disk_alone(text).ok_or(ErrorCode::IllegalQuantity)?;
        let disk = self.disk_mut(unit);
        disk.clear();
        Ok(disk.free())
    }

    /// The directory of the files that match a mask, and what is free (D50).
    ///
    /// # Errors
    /// ILLEGAL QUANTITY for a disk that there is not.
    pub fn directory(&self, mask: &[u8]) -> Result<String, ErrorCode> {
        let (unit, mask) = unit_and_mask(mask)?;
        let mask = mask.unwrap_or_else(|| "*".to_owned());
        let disk = self.disk(unit);
        let mut text = String::new();
        for (name, bytes) in disk.iter().filter(|(name, _)| matches(&mask, name)) {
            text.push_str(&format!("{name:<12}{:>8}\r\n", bytes.len()));
        }
        text.push_str(&format!("{:>20} BYTES FREE\r\n", disk.free()));
        Ok(text)
    }

    /// The files of A:, which the mains switch clears.
    pub fn lost(&self) -> impl Iterator<Item = (&str, &Rc<[u8]>)> {
        self.a.iter()
    }

    /// The files of B:, which survive the mains switch.
    pub fn kept(&self) -> impl Iterator<Item = (&str, &Rc<[u8]>)> {
        self.b.iter()
    }

    fn disk_mut(&mut self, unit: Unit) -> &mut Disk {
        match unit {
            Unit::A => &mut self.a,
            Unit::B => &mut self.b,
        }
    }

    fn disk(&self, unit: Unit) -> &Disk {
        match unit {
            Unit::A => &self.a,
            Unit::B => &self.b,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_get_their_disk_and_extension() {
        let full = |text: &str| FileName::parse(text.as_bytes());
        let named = |unit, name: &str| {
            Ok(FileName {
                unit,
                name: name.to_owned(),
            })
        };
        assert_eq!(full("test"), named(Unit::A, "TEST.BAS"));
        assert_eq!(full("b:test2.bas"), named(Unit::B, "TEST2.BAS"));
        assert_eq!(full("SECTION.12"), named(Unit::A, "SECTION.12"));
        for bad in ["", "C:X", "TOOLONGNAME", "A.LONG", "A*", "A.B.C", "A:"] {
            assert_eq!(full(bad), Err(ErrorCode::IllegalQuantity), "{bad}");
        }
    }
}
