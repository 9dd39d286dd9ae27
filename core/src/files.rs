//! Named bytes with a quota: what a controller calls a disk.

use std::collections::BTreeMap;
use std::rc::Rc;

/// Files that a disk holds at the most, however short they are.
const MOST_FILES: usize = 4096;

/// A disk: files by name, in upper case, bounded.
#[derive(Debug, Clone)]
pub struct Disk {
    files: BTreeMap<String, Rc<[u8]>>,
    /// Bytes that all files together hold.
    used: usize,
    /// Bytes that they may hold.
    quota: usize,
}

/// The disk has no room for the file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct DiskFull;

impl Disk {
    /// An empty disk of `quota` bytes.
    pub fn new(quota: usize) -> Disk {
        Disk {
            files: BTreeMap::new(),
            used: 0,
            quota,
        }
    }

    /// Writes a file whole, replacing one of the same name.
    ///
    /// # Errors
    /// [`DiskFull`] if the quota does not allow it, or there are 4096 files; the old file then stays.
    pub fn write(&mut self, name: &str, bytes: &[u8]) -> Result<(), DiskFull> {
        let name = name.to_ascii_uppercase();
        let replaced = self.files.get(&name).map(|old| old.len());
        let used = self.used - replaced.unwrap_or(0) + bytes.len();
        if used > self.quota || replaced.is_none() && self.files.len() >= MOST_FILES {
            return Err(DiskFull);
        }
        self.files.insert(name, bytes.into());
        self.used = used;
        Ok(())
    }

    /// A file's bytes.
    pub fn read(&self, name: &str) -> Option<Rc<[u8]>> {
        self.files.get(&name.to_ascii_uppercase()).cloned()
    }

    /// Removes a file; whether there was one.
    pub fn remove(&mut self, name: &str) -> bool {
        let removed = self.files.remove(&name.to_ascii_uppercase());
        self.used -= removed.as_ref().map_or(0, |bytes| bytes.len());
        removed.is_some()
    }

    /// Removes every file.
    pub fn clear(&mut self) {
        self.files.clear();
        self.used = 0;
    }

    /// Bytes held by all files.
    pub fn used(&self) -> usize {
        self.used
    }

    /// Bytes still free.
    pub fn free(&self) -> usize {
        self.quota.saturating_sub(self.used())
    }

    /// All files in order of their names.
    pub fn iter(&self) -> impl Iterator<Item = (&str, &Rc<[u8]>)> {
        self.files
            .iter()
            .map(|(name, bytes)| (name.as_str(), bytes))
    }
}

/// Whether `name` matches `mask`; name and extension are matched apart, `*` is any number of characters, `?` is one.
/// A mask without a point matches only names without an extension unless it ends in `*`.
pub fn matches(mask: &str, name: &str) -> bool {
    let (mask, name) = (mask.to_ascii_uppercase(), name.to_ascii_uppercase());
    let (mask_stem, mask_extension) = split(&mask);
    let (stem, extension) = split(&name);
    let any_extension = !mask.contains('.') && mask.ends_with('*');
    part_matches(mask_stem.as_bytes(), stem.as_bytes())
        && (any_extension || part_matches(mask_extension.as_bytes(), extension.as_bytes()))
}

fn split(name: &str) -> (&str, &str) {
    name.rsplit_once('.').unwrap_or((name, ""))
}

fn part_matches(mask: &[u8], name: &[u8]) -> bool {
    // Greedy with one remembered star: linear in practice, never exponential.
    let (mut m, mut n) = (0, 0);
    let mut star: Option<(usize, usize)> = None;
    while n < name.len() {
        match mask.get(m) {
            Some(b'*') => {
                star = Some((m, n));
                m += 1;
            }
            Some(&c) if c == b'?' || Some(&c) == name.get(n) => {
                m += 1;
                n += 1;
            }
            _ => match star {
                Some((star_m, star_n)) => {
                    m = star_m + 1;
                    n = star_n + 1;
                    star = Some((star_m, star_n + 1));
                }
                None => return false,
            },
        }
    }
    mask.iter().skip(m).all(|&c| c == b'*')
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn wildcards_match_stem_and_extension_apart() {
        for (mask, name, expected) in [
            ("*.txt", "FREE.TXT", true),
            ("*.txt", "FREE.BAS", false),
            ("chap*.zip", "chapter1.zip", true),
            ("big*.*", "bignews.exe", true),
            ("yah???.bas", "yahabc.bas", true),
            ("yah???.bas", "yahab.bas", false),
            ("*", "A.BAS", true),
            ("A", "A.BAS", false),
            ("*A*B*C.X", "XXAYYBZZC.X", true),
        ] {
            assert_eq!(matches(mask, name), expected, "{mask} {name}");
        }
    }

    #[test]
    fn a_full_disk_keeps_the_old_file() {
        let mut disk = Disk::new(10);
        disk.write("a.bas", b"12345678").unwrap();
        assert_eq!(disk.write("A.BAS", b"12345678901"), Err(DiskFull));
        assert_eq!(disk.read("A.bas").as_deref(), Some(&b"12345678"[..]));
        assert_eq!(disk.write("b", b"123"), Err(DiskFull));
        disk.write("A.BAS", b"1234567890").unwrap();
        assert_eq!(disk.free(), 0);
        assert!(disk.remove("a.bas"));
        assert!(!disk.remove("a.bas"));
        assert_eq!(disk.free(), 10);
        disk.write("C", b"1234").unwrap();
        disk.clear();
        assert_eq!(disk.free(), 10);
    }

    #[test]
    fn empty_files_take_room_too() {
        let mut disk = Disk::new(10);
        for number in 0..MOST_FILES {
            disk.write(&format!("F{number}"), b"").unwrap();
        }
        assert_eq!(disk.write("ONE.MORE", b""), Err(DiskFull));
        assert_eq!(disk.write("F0", b"123"), Ok(()));
    }
}
