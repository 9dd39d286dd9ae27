//! The parts of a scenario's line: words, quoted strings, times, numbers.

use std::fmt::Write;

use crate::language::latin1;
use crate::time::Nanos;

/// What is left of a line.
#[derive(Debug, Clone, Copy)]
pub(super) struct Line<'a> {
    rest: &'a str,
}

impl<'a> Line<'a> {
    pub(super) fn new(text: &'a str) -> Line<'a> {
        Line { rest: text }
    }

    /// Everything that follows, without the one blank that ends the word before.
    pub(super) fn literal(self) -> &'a str {
        self.rest.strip_prefix([' ', '\t']).unwrap_or(self.rest)
    }

    /// The next word, up to a blank.
    pub(super) fn word(&mut self) -> Option<&'a str> {
        let text = self.rest.trim_start();
        let end = text.find(char::is_whitespace).unwrap_or(text.len());
        let (word, rest) = text.split_at_checked(end)?;
        self.rest = rest;
        (!word.is_empty()).then_some(word)
    }

    /// The next word without taking it.
    pub(super) fn peek(mut self) -> Option<&'a str> {
        self.word()
    }

    /// The next word, which is `what`.
    pub(super) fn need(&mut self, what: &str) -> Result<&'a str, String> {
        self.word().ok_or_else(|| format!("{what} is missing"))
    }

    /// Takes the next word if it is `word`.
    pub(super) fn eat(&mut self, word: &str) -> bool {
        let found = self.peek() == Some(word);
        if found {
            self.word();
        }
        found
    }

    /// Takes the next word, which must be `word`.
    pub(super) fn keyword(&mut self, word: &str) -> Result<(), String> {
        match self.word() {
            Some(found) if found == word => Ok(()),
            Some(found) => Err(format!("expected `{word}`, found `{found}`")),
            None => Err(format!("`{word}` is missing")),
        }
    }

    /// A length of time, which is `what`: `0.5s`, `20ms`, `100us`, `2min`.
    pub(super) fn time(&mut self, what: &str) -> Result<Nanos, String> {
        duration(self.need(what)?)
    }

    /// `within 5s`, or ten seconds without it.
    pub(super) fn within(&mut self) -> Result<Nanos, String> {
        if self.eat("within") {
            self.time("the time after `within`")
        } else {
            Ok(super::WITHIN)
        }
    }

    /// Whether a quoted string follows.
    pub(super) fn is_quoted(&self) -> bool {
        self.rest.trim_start().starts_with('"')
    }

    /// A quoted string as the bytes that it stands for.
    pub(super) fn bytes(&mut self) -> Result<Vec<u8>, String> {
        let text = self.quoted()?;
        let strange = text.chars().find(|&c| latin1::byte(c).is_none());
        match strange {
            Some(c) => Err(format!(
                "`{c}` is not a character of eight bits: write its bytes as \\xHH"
            )),
            None => Ok(latin1::bytes(&text)),
        }
    }

    /// A quoted string as text: the name of a file.
    pub(super) fn quoted(&mut self) -> Result<String, String> {
        let text = self.rest.trim_start();
        let Some(text) = text.strip_prefix('"') else {
            return Err(match self.word() {
                Some(word) => format!("expected a text in double quotes, found `{word}`"),
                None => "a text in double quotes is missing".to_owned(),
            });
        };
        let mut found = String::new();
        let mut characters = text.chars();
        loop {
            match characters.next() {
                None => return Err("the text has no closing double quote".to_owned()),
                Some('"') => break,
                Some('\\') => found.push(escaped(&mut characters)?),
                Some(c) => found.push(c),
            }
        }
        self.rest = characters.as_str();
        if self.rest.starts_with(|c: char| !c.is_whitespace()) {
            return Err("a blank is missing after the closing double quote".to_owned());
        }
        Ok(found)
    }

    /// `key=value`, where the value may stand in quotes; `None` at the end of the line.
    pub(super) fn setting(&mut self) -> Result<Option<(String, String)>, String> {
        let text = self.rest.trim_start();
        if text.is_empty() {
            return Ok(None);
        }
        let word = text.split(char::is_whitespace).next().unwrap_or(text);
        let Some((key, value)) = text.split_once('=').filter(|_| word.contains('=')) else {
            return Err(format!("expected `key=value`, found `{word}`"));
        };
        if key.is_empty() {
            return Err(format!("`{word}` has no key before its `=`"));
        }
        self.rest = value;
        let value = if value.starts_with('"') {
            self.quoted()?
        } else if value.is_empty() || value.starts_with(char::is_whitespace) {
            return Err(format!("`{key}=` has no value"));
        } else {
            self.need("the value")?.to_owned()
        };
        Ok(Some((key.to_owned(), value)))
    }

    /// Nothing may follow.
    pub(super) fn end(mut self) -> Result<(), String> {
        match self.word() {
            None => Ok(()),
            Some(word) => Err(format!("`{word}` is one word too many")),
        }
    }
}

fn escaped(characters: &mut std::str::Chars<'_>) -> Result<char, String> {
    Ok(match characters.next() {
        Some('r') => '\r',
        Some('n') => '\n',
        Some('t') => '\t',
        Some('\\') => '\\',
        Some('"') => '"',
        Some('x') => {
            let mut digit = || characters.next().and_then(|c| c.to_digit(16));
            let value = digit().and_then(|high| Some(high * 16 + digit()?));
            value
                .and_then(char::from_u32)
                .ok_or("\\x needs two hexadecimal digits")?
        }
        Some(c) => return Err(format!("\\{c} is none of \\r \\n \\t \\\\ \\\" \\xHH")),
        None => return Err("the text has no closing double quote".to_owned()),
    })
}

/// A length of time with its unit, at most a day: `0.5s`, `20ms`, `100us`, `2min`.
///
/// # Errors
/// One clear line.
pub fn duration(word: &str) -> Result<Nanos, String> {
    let split = word.find(|c: char| c.is_ascii_alphabetic());
    let (digits, unit) = word
        .split_at_checked(split.unwrap_or(word.len()))
        .unwrap_or((word, ""));
    let unit = match unit {
        "us" => 1e-6,
        "ms" => 1e-3,
        "s" => 1.0,
        "min" => 60.0,
        _ => {
            return Err(format!(
                "`{word}` is not a time: write 0.5s, 20ms, 100us or 2min"
            ));
        }
    };
    let seconds = digits
        .parse::<f64>()
        .ok()
        .filter(|seconds| (0.0..=1e9).contains(seconds))
        .map(|seconds| seconds * unit);
    match seconds {
        Some(seconds) if seconds <= super::LONGEST.seconds() => Ok(Nanos::from_seconds(seconds)),
        Some(_) => Err(format!("`{word}` is more than a day")),
        None => Err(format!(
            "`{word}` is not a time: write 0.5s, 20ms, 100us or 2min"
        )),
    }
}

/// A finite number: `-1.5`, `1e3`, `0x40`.
pub(super) fn number(word: &str) -> Option<f64> {
    let (sign, digits) = match word.strip_prefix('-') {
        Some(digits) => (-1.0, digits),
        None => (1.0, word.strip_prefix('+').unwrap_or(word)),
    };
    let value = match digits.strip_prefix("0x").or(digits.strip_prefix("0X")) {
        Some(hex) => f64::from(u32::from_str_radix(hex, 16).ok()?),
        // `inf` and `nan` are words, not numbers.
        None if digits.starts_with(|c: char| c.is_ascii_digit() || c == '.') => digits
            .parse()
            .ok()
            .filter(|value: &f64| value.is_finite())?,
        None => return None,
    };
    Some(sign * value)
}

/// Bytes as a scenario would write them, in quotes; of a long text only the end.
pub(super) fn show(bytes: &[u8]) -> String {
    const MOST: usize = 240;
    let skipped = bytes.len().saturating_sub(MOST);
    let mut shown = String::from(if skipped > 0 { "...\"" } else { "\"" });
    for &byte in bytes.iter().skip(skipped) {
        match byte {
            b'\r' => shown.push_str("\\r"),
            b'\n' => shown.push_str("\\n"),
            b'\t' => shown.push_str("\\t"),
            b'\\' => shown.push_str("\\\\"),
            b'"' => shown.push_str("\\\""),
            b' '..=b'~' => shown.push(char::from(byte)),
            // Writing to a string cannot fail.
            _ => drop(write!(shown, "\\x{byte:02X}")),
        }
    }
    shown.push('"');
    shown
}

/// A time as a scenario would write it.
pub(super) fn show_time(time: Nanos) -> String {
    format!("{} s", time.seconds())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn strings_know_their_escapes() {
        let mut line = Line::new(r#"  "a\r\n\t\\\"\x07\xfe" rest"#);
        assert_eq!(line.bytes().unwrap(), b"a\r\n\t\\\"\x07\xfe");
        assert_eq!(line.word(), Some("rest"));
        for (bad, why) in [
            (r#""open"#, "the text has no closing double quote"),
            (r#""open\"#, "the text has no closing double quote"),
            (r#""\x4""#, "\\x needs two hexadecimal digits"),
            (r#""\q""#, r#"\q is none of \r \n \t \\ \" \xHH"#),
            ("word", "expected a text in double quotes, found `word`"),
            ("", "a text in double quotes is missing"),
            (
                r#""a"b"#,
                "a blank is missing after the closing double quote",
            ),
            (
                "\"\u{2126}\"",
                "`\u{2126}` is not a character of eight bits: write its bytes as \\xHH",
            ),
        ] {
            assert_eq!(Line::new(bad).bytes().unwrap_err(), why, "{bad}");
        }
    }

    #[test]
    fn times_need_a_unit() {
        for (word, nanos) in [
            ("0.5s", 500_000_000),
            (".5s", 500_000_000),
            ("20ms", 20_000_000),
            ("100us", 100_000),
            ("2min", 120_000_000_000),
            ("0s", 0),
        ] {
            assert_eq!(duration(word), Ok(Nanos(nanos)), "{word}");
        }
        for word in [
            "5", "s", "-1s", "1e9s", "1h", "25e3min", "infs", "nans", "5 s", "", "1e999s",
        ] {
            assert!(duration(word).is_err(), "{word}");
        }
    }

    #[test]
    fn numbers_are_finite() {
        assert_eq!(number("-1.5e3"), Some(-1500.0));
        assert_eq!(number("0x40"), Some(64.0));
        assert_eq!(number("-.5"), Some(-0.5));
        for word in ["inf", "nan", "1e999", "", "-", "0x", "1,5", "--1", "+-1"] {
            assert_eq!(number(word), None, "{word}");
        }
    }

    #[test]
    fn settings_may_stand_in_quotes() {
        let mut line = Line::new(r#" a=1 b="x y" c=p=q"#);
        let pair = |a: &str, b: &str| Ok(Some((a.to_owned(), b.to_owned())));
        assert_eq!(line.setting(), pair("a", "1"));
        assert_eq!(line.setting(), pair("b", "x y"));
        assert_eq!(line.setting(), pair("c", "p=q"));
        assert_eq!(line.setting(), Ok(None));
        for bad in ["a", "a b=1", "=1", "a= 1", "a="] {
            assert!(Line::new(bad).setting().is_err(), "{bad}");
        }
    }

    #[test]
    fn long_output_is_shown_from_its_end() {
        assert_eq!(show(b"a\x13\r\n"), r#""a\x13\r\n""#);
        let shown = show(&[b'x'; 300]);
        assert!(shown.starts_with("...\"xxx") && shown.len() == 240 + 5);
    }
}
