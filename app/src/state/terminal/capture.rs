//! What the terminal receives, kept for a file.

/// The most that is kept, in bytes.
const MOST: usize = 16 << 20;

/// A recording of the terminal.
#[derive(Debug, Default)]
pub struct Capture {
    text: String,
    full: bool,
}

impl Capture {
    /// Takes what arrived.
    pub fn take(&mut self, text: &str) {
        self.full |= self.text.len() + text.len() > MOST;
        if !self.full {
            self.text.push_str(text);
        }
    }

    /// What it holds.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// What it held.
    pub fn into_text(self) -> String {
        self.text
    }

    /// Whether more arrived than it holds.
    pub fn is_full(&self) -> bool {
        self.full
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_capture_has_a_bound_and_says_so() {
        let mut capture = Capture::default();
        capture.take(">LIST\r\n");
        assert_eq!((capture.text(), capture.is_full()), (">LIST\r\n", false));
        capture.take(&"X".repeat(MOST));
        capture.take("Y");
        assert_eq!((capture.text(), capture.is_full()), (">LIST\r\n", true));
    }
}
