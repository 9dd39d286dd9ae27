//! Texts as lists of their lines, so that a project can be read by people. A text on one line may stand for itself.

use std::fmt;

use serde::Serializer;
use serde::de::{Deserializer, SeqAccess, Visitor};

/// Writes a text as its lines, each with its line end.
pub(super) fn serialize<S: Serializer>(text: &str, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_seq(text.split_inclusive('\n'))
}

/// Reads a text, or joins its lines.
pub(super) fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<String, D::Error> {
    deserializer.deserialize_any(Lines)
}

struct Lines;

impl<'de> Visitor<'de> for Lines {
    type Value = String;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a text or the list of its lines")
    }

    fn visit_str<E>(self, text: &str) -> Result<String, E> {
        Ok(text.to_owned())
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut lines: A) -> Result<String, A::Error> {
        let mut text = String::new();
        while let Some(line) = lines.next_element::<String>()? {
            text.push_str(&line);
        }
        Ok(text)
    }
}

/// Bytes as the text of a device's eight-bit characters.
pub(super) mod bytes {
    use motionbench_core::language::latin1;
    use serde::de::Error;

    use super::*;

    /// Writes bytes as the lines of a text.
    pub(in super::super) fn serialize<S: Serializer>(
        bytes: &[u8],
        serializer: S,
    ) -> Result<S::Ok, S::Error> {
        super::serialize(&latin1::text(bytes), serializer)
    }

    /// Reads bytes from the lines of a text.
    pub(in super::super) fn deserialize<'de, D: Deserializer<'de>>(
        deserializer: D,
    ) -> Result<Vec<u8>, D::Error> {
        let text = super::deserialize(deserializer)?;
        let byte = |character| {
            latin1::byte(character).ok_or_else(|| {
                Error::custom(format_args!("no device has the character {character}"))
            })
        };
        text.chars().map(byte).collect()
    }
}
