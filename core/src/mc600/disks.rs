//! Disk A: in RAM and disk B: in FLASH (The BASIC Filesystem).

use std::rc::Rc;

use super::firmware::{DISK_A, DISK_B, ErrorCode};
use crate::catalog::DiskInfo;
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
        let name = if rest.contains('.') {
            rest
        } else {
            format!("{rest}.BAS")
        };
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
        let disk = if name.unit == Unit::A {
            &mut self.a
        } else {
            &mut self.b
        };
        disk.write(&name.name, bytes)
            .map_err(|_| ErrorCode::OutOfMemory)
    }

    /// The directory of the files that match a mask, and what is free (D50).
    ///
    /// # Errors
    /// ILLEGAL QUANTITY for a disk that there is not.
    pub fn directory(&self, mask: &[u8]) -> Result<String, ErrorCode> {
        let (unit, mask) = unit_and_rest(mask)?;
        let mask = if mask.is_empty() { "*" } else { &mask };
        let disk = self.disk(unit);
        let mut text = String::new();
        for (name, bytes) in disk.iter().filter(|(name, _)| matches(mask, name)) {
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
