//! Files and standard output, with one clear line where they fail.

use std::fs;
use std::io::{self, Write};
use std::path::Path;

/// Bytes of a file that is read.
const MOST: u64 = 16 << 20;

/// A whole file.
pub(crate) fn read(path: &Path) -> Result<Vec<u8>, String> {
    let why = |error: io::Error| format!("{}: {}", path.display(), reason(&error));
    let length = fs::metadata(path).map_err(why)?.len();
    if length > MOST {
        return Err(format!("{}: more than {MOST} bytes", path.display()));
    }
    fs::read(path).map_err(why)
}

/// Writes a whole file.
pub(crate) fn write(path: &Path, bytes: &[u8]) -> Result<(), String> {
    fs::write(path, bytes).map_err(|error| format!("{}: {}", path.display(), reason(&error)))
}

/// Prints to standard output. A reader that has gone away is no error: `motionbench keywords mc600 | head` is usual.
pub(crate) fn print(text: &str) -> Result<(), String> {
    let mut out = io::stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => {
            Err(format!("standard output: {}", reason(&error)))
        }
        _ => Ok(()),
    }
}

/// The system's words without its number.
pub(crate) fn reason(error: &io::Error) -> String {
    let text = error.to_string();
    match text.split_once(" (os error") {
        Some((reason, _)) => reason.to_lowercase(),
        None => text,
    }
}
