//! A program's text taken apart: codewords, which the editor steps by, and what the precompilation asks of them.

use std::ops::Range;

/// A letter with what stands behind it, a message with its quotes, or an end of block.
pub fn codewords(text: &[u8]) -> Vec<Range<usize>> {
    let mut words: Vec<Range<usize>> = Vec::new();
    let mut at = 0;
    while let Some(&byte) = text.get(at) {
        let end = word_end(text, at);
        match byte {
            // Characters that begin nothing belong to what is before them.
            b'A'..=b'Z' | b'*' | b'"' => words.push(at..end),
            _ => match words.last_mut() {
                Some(last)
                    if text.get(last.start) != Some(&b'*')
                        && text.get(last.start) != Some(&b'"') =>
                {
                    last.end = end;
                }
                _ => words.push(at..end),
            },
        }
        at = end;
    }
    words
}

fn word_end(text: &[u8], at: usize) -> usize {
    let rest = text.get(at + 1..).unwrap_or_default();
    let length = match text.get(at) {
        Some(b'*') => Some(0),
        Some(b'"') => rest.iter().position(|&byte| byte == b'"').map(|n| n + 1),
        _ => rest
            .iter()
            .position(|byte| matches!(byte, b'A'..=b'Z' | b'*' | b'"')),
    };
    length.map_or(text.len(), |length| at + 1 + length)
}

/// Where the codeword begins that the character before `at` belongs to; 0 at the start.
pub fn word_before(text: &[u8], at: usize) -> usize {
    let words = codewords(text);
    let found = words.iter().rev().find(|word| word.start < at);
    found.map_or(0, |word| word.start)
}

/// The end of the first codeword that ends behind `at`; `None` at the program's end.
pub fn next_end(text: &[u8], at: usize) -> Option<usize> {
    let mut words = codewords(text).into_iter();
    words.find(|word| word.end > at).map(|word| word.end)
}

/// The end of the last codeword that ends before `at`, or 0; `None` at the program's start.
pub fn previous_end(text: &[u8], at: usize) -> Option<usize> {
    let words = codewords(text);
    let found = words.iter().rev().find(|word| word.end < at);
    (at > 0).then(|| found.map_or(0, |word| word.end))
}

/// Whether a message is open at `at`: an odd number of quotes before.
pub fn in_message(text: &[u8], at: usize) -> bool {
    let quotes = text.iter().take(at).filter(|&&byte| byte == b'"');
    quotes.count() % 2 == 1
}

/// The next end of block at or behind `at`, outside messages.
pub fn end_of_block(text: &[u8], at: usize) -> Option<usize> {
    let mut at = at;
    loop {
        match text.get(at)? {
            b'*' => return Some(at),
            b'"' => at = word_end(text, at),
            _ => at += 1,
        }
    }
}

/// What an N codeword says.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Sequence {
    /// `N n`: a place.
    Label(u32),
    /// `N- n`: a subroutine.
    Call(u32),
    /// `N= n`: a subroutine that leaves the modes as they are.
    Independent(u32),
    /// `N> n`: a jump.
    Jump(u32),
    /// `N+ n`: puts a place on the stack.
    Push(u32),
    /// `N< n`: a program as a subroutine.
    Program(u32),
}

/// Reads a whole N codeword; `None` if it is none, or not well formed.
pub fn sequence(word: &[u8]) -> Option<Sequence> {
    let (sign, digits) = match word.split_first()? {
        (b'N', [sign @ (b'-' | b'=' | b'>' | b'+' | b'<'), digits @ ..]) => (*sign, digits),
        (b'N', digits) => (b' ', digits),
        _ => return None,
    };
    let number = number(digits)?;
    Some(match sign {
        b'-' => Sequence::Call(number),
        b'=' => Sequence::Independent(number),
        b'>' => Sequence::Jump(number),
        b'+' => Sequence::Push(number),
        b'<' => Sequence::Program(number),
        _ => Sequence::Label(number),
    })
}

/// One to six digits.
fn number(digits: &[u8]) -> Option<u32> {
    let decimal = (1..=6).contains(&digits.len()) && digits.iter().all(u8::is_ascii_digit);
    let text = std::str::from_utf8(digits).ok().filter(|_| decimal)?;
    text.parse().ok()
}

/// Where a line stands: its first label.
pub fn label(text: &[u8], line: u32) -> Option<usize> {
    let words = codewords(text).into_iter();
    let mut starts = words.filter(|word| {
        let word = text.get(word.clone()).unwrap_or_default();
        sequence(word) == Some(Sequence::Label(line))
    });
    starts.next().map(|word| word.start)
}

/// What the precompilation objects to (6-2).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Objection {
    /// The line that an N codeword names is not in the program.
    NoLine(u32),
    /// The program that it names is not in memory.
    NoProgram(u32),
    /// The N codeword is not well formed.
    Malformed,
    /// A message has no closing quote.
    OpenMessage,
}

/// Everything that keeps a program from compiling, with its codeword.
pub fn objections(
    text: &[u8],
    has_program: impl Fn(u32) -> bool,
) -> Vec<(Range<usize>, Objection)> {
    let words = codewords(text);
    let of = |word: &Range<usize>| text.get(word.clone()).unwrap_or_default();
    let labels: Vec<u32> = words
        .iter()
        .filter_map(|word| match sequence(of(word)) {
            Some(Sequence::Label(line)) => Some(line),
            _ => None,
        })
        .collect();
    let mut found = Vec::new();
    for word in &words {
        let objection = match of(word) {
            [b'"', .., b'"'] => None,
            [b'"', ..] => Some(Objection::OpenMessage),
            [b'N', ..] => match sequence(of(word)) {
                None => Some(Objection::Malformed),
                Some(Sequence::Label(_)) => None,
                Some(Sequence::Program(number)) => {
                    (!has_program(number)).then_some(Objection::NoProgram(number))
                }
                Some(
                    Sequence::Call(line)
                    | Sequence::Independent(line)
                    | Sequence::Jump(line)
                    | Sequence::Push(line),
                ) => (!labels.contains(&line)).then_some(Objection::NoLine(line)),
            },
            _ => None,
        };
        found.extend(objection.map(|objection| (word.clone(), objection)));
    }
    found
}

/// What a typed or listed line is in memory: without blanks outside messages and without its comment.
pub fn packed(line: &[u8], in_message: &mut bool) -> Vec<u8> {
    let mut text = Vec::new();
    for &byte in line {
        match byte {
            b'"' => *in_message = !*in_message,
            _ if *in_message => {}
            b';' => break,
            b' ' | b'\t' => continue,
            _ => {}
        }
        text.push(byte);
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    fn split(text: &str) -> Vec<&str> {
        let words = codewords(text.as_bytes()).into_iter();
        words.map(|word| &text[word]).collect()
    }

    #[test]
    fn codewords_are_what_the_editor_steps_by() {
        assert_eq!(
            split("G47X1=X+Y-350*\"A*B\"N>20*G62D<"),
            [
                "G47", "X1=", "X+", "Y-350", "*", "\"A*B\"", "N>20", "*", "G62", "D<"
            ]
        );
        assert_eq!(split("12*3G7"), ["12", "*", "3", "G7"]);
        assert_eq!(split("\"open"), ["\"open"]);
    }

    #[test]
    fn steps_go_from_end_to_end() {
        let text = b"G7X100F10";
        assert_eq!(next_end(text, 0), Some(2));
        assert_eq!(next_end(text, 4), Some(6));
        assert_eq!(next_end(text, 9), None);
        assert_eq!(previous_end(text, 9), Some(6));
        assert_eq!(previous_end(text, 2), Some(0));
        assert_eq!(previous_end(text, 0), None);
    }

    #[test]
    fn an_end_of_block_in_a_message_is_none() {
        assert_eq!(end_of_block(b"X1\"*\"*", 0), Some(5));
        assert_eq!(end_of_block(b"X1\"*\"", 0), None);
    }
}
