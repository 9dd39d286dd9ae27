//! Reads numbers and signs from a program's text.

/// A place in a text that moves forward.
pub(super) struct Scan<'a> {
    pub(super) text: &'a [u8],
    pub(super) at: usize,
}

impl<'a> Scan<'a> {
    pub(super) fn new(text: &'a [u8], at: usize) -> Scan<'a> {
        Scan { text, at }
    }

    pub(super) fn peek(&self) -> Option<u8> {
        self.text.get(self.at).copied()
    }

    pub(super) fn next(&mut self) -> Option<u8> {
        let byte = self.peek()?;
        self.at += 1;
        Some(byte)
    }

    pub(super) fn eat(&mut self, byte: u8) -> bool {
        let found = self.peek() == Some(byte);
        self.at += usize::from(found);
        found
    }

    /// Digits; `None` where there is none. Beyond 18 digits it saturates.
    pub(super) fn digits(&mut self) -> Option<i64> {
        let start = self.at;
        let mut value = 0_i64;
        while let Some(digit @ b'0'..=b'9') = self.peek() {
            value = value
                .saturating_mul(10)
                .saturating_add(i64::from(digit - b'0'));
            self.at += 1;
        }
        (self.at > start).then_some(value)
    }

    /// Digits behind a sign or none.
    pub(super) fn signed(&mut self) -> Option<i64> {
        let negative = self.eat(b'-');
        let value = self.digits()?;
        Some(if negative { -value } else { value })
    }

    /// Digits within a range.
    pub(super) fn within(&mut self, least: u32, most: u32) -> Option<u32> {
        let value = u32::try_from(self.digits()?).ok()?;
        (least..=most).contains(&value).then_some(value)
    }
}
