//! The stored program: its text as the motor keeps it, without comments and spare blanks.

use super::code::Image;
use super::compile::compile;
use super::firmware::PROGRAM_BYTES;
use super::lexer::{TokenKind, tokens};
use crate::language::split_lines;

/// What a motor holds that has no program: a download of END alone leaves the same.
const EMPTY: &[u8] = b"END\n";

/// The stored program. It stays without power.
#[derive(Debug, Clone)]
pub struct Store {
    text: Vec<u8>,
    checksum: String,
    /// Grows with every change.
    pub revision: u64,
}

/// A text as the motor keeps it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Stripped {
    /// Lines end with LF.
    pub text: Vec<u8>,
    /// For each line of the source, its line there, from 1; `None` where nothing is left of it.
    pub lines: Vec<Option<u32>>,
}

/// Leaves out comments, empty lines and blanks that separate nothing.
pub fn strip(source: &[u8]) -> Stripped {
    let mut text = Vec::new();
    let mut lines = Vec::new();
    let mut last = 0u32;
    for line in split_lines(source) {
        let start = text.len();
        let mut behind = None;
        for token in tokens(line) {
            if token.kind == TokenKind::Comment {
                break;
            }
            if behind.is_some_and(|behind| behind != token.span.start) {
                text.push(b' ');
            }
            text.extend_from_slice(token.span.of(line));
            behind = Some(token.span.end);
        }
        let kept = text.len() > start;
        if kept {
            text.push(b'\n');
            last = last.saturating_add(1);
        }
        lines.push(kept.then_some(last));
    }
    Stripped { text, lines }
}

impl Default for Store {
    fn default() -> Store {
        Store {
            text: EMPTY.to_vec(),
            checksum: checksum(EMPTY, &Image::default()),
            revision: 0,
        }
    }
}

impl Store {
    /// Keeps a text that is stripped already and gives its operations; `None` if it is too long, and nothing has
    /// changed then. A motor that lacks a word reads its program without it.
    pub fn keep(&mut self, text: Vec<u8>, without: Option<&str>) -> Option<Image> {
        if text.len() > PROGRAM_BYTES {
            return None;
        }
        self.text = text;
        self.revision += 1;
        let image = self.image(without);
        self.checksum = checksum(&self.text, &image);
        Some(image)
    }

    /// The operations of the program.
    pub fn image(&self, without: Option<&str>) -> Image {
        compile(&self.text, without).0
    }

    /// Its text.
    pub fn text(&self) -> &[u8] {
        &self.text
    }

    /// Whether there is more than END.
    pub fn has_program(&self) -> bool {
        self.text != EMPTY
    }

    /// What RCKS answers; `broken` if the memory is.
    pub fn checksum(&self, broken: bool) -> String {
        format!("{} {}", self.checksum, if broken { 'F' } else { 'P' })
    }
}

/// Six hexadecimal digits for the labels and six for the text (D140).
fn checksum(text: &[u8], image: &Image) -> String {
    let labels = image.labels.iter().fold(0u32, |sum, (&label, &at)| {
        sum.wrapping_add(u32::from(label)).wrapping_add(at)
    });
    let sum = text
        .iter()
        .fold(0u32, |sum, &byte| sum.wrapping_add(u32::from(byte)));
    format!("{:06X} {:06X}", labels & 0xFF_FFFF, sum & 0xFF_FFFF)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn comments_and_spare_blanks_are_left_out() {
        let source = b"' title\n\n  a=1    b=2  'two\r\nPRINT(\"a  b\", #13)\nEND";
        let stripped = strip(source);
        assert_eq!(stripped.text, b"a=1 b=2\nPRINT(\"a  b\", #13)\nEND\n");
        assert_eq!(stripped.lines, [None, None, Some(1), Some(2), Some(3)]);
        assert_eq!(strip(&stripped.text).text, stripped.text);
    }

    #[test]
    fn an_empty_motor_holds_end() {
        let mut store = Store::default();
        assert_eq!(store.checksum(false), "000000 0000E1 P");
        assert!(!store.has_program());
        assert!(store.keep(b"a=1\nEND\n".to_vec(), None).is_some());
        assert!(store.has_program());
        assert!(store.keep(vec![b' '; 32_768], None).is_none());
        assert_eq!(store.text(), b"a=1\nEND\n");
    }
}
