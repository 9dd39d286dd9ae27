/// A place in bytes that moves forward only: what every lexer is built on.
#[derive(Debug, Clone, Copy)]
pub struct Cursor<'a> {
    text: &'a [u8],
    position: usize,
}

impl<'a> Cursor<'a> {
    /// At byte `position` of `text`; behind its end there is nothing to read.
    pub fn new(text: &'a [u8], position: usize) -> Cursor<'a> {
        Cursor { text, position }
    }

    /// The index of the next byte.
    pub fn position(&self) -> usize {
        self.position
    }

    /// The next byte.
    pub fn peek(&self) -> Option<u8> {
        self.text.get(self.position).copied()
    }

    /// Takes the next byte.
    pub fn bump(&mut self) -> Option<u8> {
        let byte = self.peek()?;
        self.position += 1;
        Some(byte)
    }

    /// Takes the next byte if it is `byte`.
    pub fn eat(&mut self, byte: u8) -> bool {
        let found = self.peek() == Some(byte);
        if found {
            self.position += 1;
        }
        found
    }

    /// Takes bytes as long as `wanted` holds and gives them.
    pub fn take_while(&mut self, mut wanted: impl FnMut(u8) -> bool) -> &'a [u8] {
        let rest = self.rest();
        let length = rest
            .iter()
            .position(|&byte| !wanted(byte))
            .unwrap_or(rest.len());
        self.skip(length);
        rest.get(..length).unwrap_or_default()
    }

    /// Takes `count` bytes, or what there is.
    pub fn skip(&mut self, count: usize) {
        self.position = (self.position + count).min(self.text.len());
    }

    /// Everything not yet taken.
    pub fn rest(&self) -> &'a [u8] {
        self.text.get(self.position..).unwrap_or_default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reads_to_the_end_and_no_further() {
        let mut cursor = Cursor::new(b"12 X", 0);
        assert_eq!(cursor.take_while(|byte| byte.is_ascii_digit()), b"12");
        assert!(!cursor.eat(b'X'));
        assert!(cursor.eat(b' '));
        assert_eq!(cursor.rest(), b"X");
        cursor.skip(9);
        assert_eq!((cursor.position(), cursor.bump()), (4, None));
        assert_eq!(Cursor::new(b"ab", 7).take_while(|_| true), b"");
    }
}
