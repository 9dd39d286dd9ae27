//! The devices' eight-bit characters as text: a byte is the character U+0000 to U+00FF of the same number.

/// The byte for a character; `None` where the devices have none.
pub fn byte(character: char) -> Option<u8> {
    u8::try_from(character).ok()
}

/// The bytes for a text, one a character; `?` stands in for what the devices do not have.
pub fn bytes(text: &str) -> Vec<u8> {
    text.chars().map(|c| byte(c).unwrap_or(b'?')).collect()
}

/// The text for bytes.
pub fn text(bytes: &[u8]) -> String {
    bytes.iter().map(|&byte| char::from(byte)).collect()
}

#[cfg(test)]
mod tests {
    #[test]
    fn every_byte_survives_and_strangers_become_a_question_mark() {
        let all: Vec<u8> = (0..=255).collect();
        assert_eq!(super::bytes(&super::text(&all)), all);
        assert_eq!(super::bytes("5 \u{2126} \u{e9}"), b"5 ? \xe9");
    }
}
