//! The alphanumeric display: eight characters. Messages stand at the left, typed text enters at the right and scrolls.

/// Characters of the display.
pub const WIDTH: usize = 8;

/// What the display shows.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Display([u8; WIDTH]);

impl Default for Display {
    fn default() -> Display {
        Display([b' '; WIDTH])
    }
}

impl Display {
    /// A message: its first eight characters, from the left.
    pub fn message(&mut self, text: &[u8]) {
        let blanks = std::iter::repeat(&b' ');
        for (place, &byte) in self.0.iter_mut().zip(text.iter().chain(blanks)) {
            *place = byte;
        }
    }

    /// Typed text: its last eight characters, at the right.
    pub fn typed(&mut self, text: &[u8]) {
        let blanks = std::iter::repeat(&b' ');
        let places = self.0.iter_mut().rev();
        for (place, &byte) in places.zip(text.iter().rev().chain(blanks)) {
            *place = byte;
        }
    }

    /// All eight characters; what the segments cannot show is a blank.
    pub fn text(&self) -> String {
        let shown = |&byte: &u8| match byte {
            b' '..=b'~' => char::from(byte),
            _ => ' ',
        };
        self.0.iter().map(shown).collect()
    }
}
