//! What is wrong with a program, told from its text alone, and the colours of its lines.

use super::words::{self, Objection, codewords, packed};
use crate::language::{Diagnostic, Highlight, HighlightClass, Severity, Span, latin1};

/// A text as memory holds it, and for each of its characters where it stands: line and column, both from 0.
struct Packed {
    text: Vec<u8>,
    places: Vec<(usize, usize)>,
}

fn pack(text: &str) -> Packed {
    let mut packed = Packed {
        text: Vec::new(),
        places: Vec::new(),
    };
    let mut in_message = false;
    for (row, line) in text.split('\n').enumerate() {
        for (column, byte) in latin1::bytes(line).into_iter().enumerate() {
            match byte {
                b'"' => in_message = !in_message,
                b'\r' => continue,
                _ if in_message => {}
                b';' => break,
                b' ' | b'\t' => continue,
                _ => {}
            }
            packed.text.push(byte);
            packed.places.push((row, column));
        }
    }
    packed
}

/// Everything that keeps a program from compiling, in the order of its lines. Programs that it calls are taken to be
/// there.
pub fn diagnose(text: &str) -> Vec<Diagnostic> {
    let packed = pack(text);
    let objections = words::objections(&packed.text, |number| (1..=99).contains(&number));
    let objections = objections.into_iter();
    objections
        .map(|(word, objection)| {
            let place = |at: usize| packed.places.get(at).copied().unwrap_or_default();
            let (line, start) = place(word.start);
            let (last_line, last) = place(word.end.saturating_sub(1));
            let end = if last_line == line {
                last + 1
            } else {
                start + 1
            };
            let cause = match objection {
                Objection::NoLine(number) => format!("The program has no line N{number}."),
                Objection::NoProgram(number) => format!("There is no program {number}."),
                Objection::Malformed => {
                    "Behind N comes one of - = > < + or nothing, then one to six digits.".to_owned()
                }
                Objection::OpenMessage => "The message has no closing quote.".to_owned(),
            };
            Diagnostic {
                line: u32::try_from(line).unwrap_or(u32::MAX),
                span: Span::new(start, end),
                severity: Severity::Error,
                message: "C-ERR".to_owned(),
                cause,
                cure: None,
            }
        })
        .collect()
}

/// The block that each line of a text begins in, from 1; none where only a comment stands.
pub fn device_lines(text: &str) -> Vec<Option<u32>> {
    let mut in_message = false;
    let mut block = 1;
    let mut lines = Vec::new();
    for line in text.split('\n') {
        let text = packed(&latin1::bytes(line), &mut in_message);
        lines.push((!text.is_empty()).then_some(block));
        let ends = codewords(&text)
            .into_iter()
            .filter(|word| text.get(word.clone()) == Some(b"*"));
        block += u32::try_from(ends.count()).unwrap_or(0);
    }
    lines
}

/// The words of the keyword table that a line uses.
pub fn words(line: &str) -> Vec<&'static str> {
    let rows = super::keywords::rows();
    let line = latin1::bytes(line);
    let mut in_message = false;
    let text = packed(&line, &mut in_message);
    let mut found = Vec::new();
    for range in codewords(&text) {
        let word = text.get(range).unwrap_or_default();
        let word = shape(word);
        found.extend(
            rows.iter()
                .filter(|row| row.word == word)
                .map(|row| row.word),
        );
    }
    found
}

/// A codeword as the table writes it: `X1000` is `Xn`, `G25=7` is `G25=n`.
fn shape(word: &[u8]) -> String {
    let text = latin1::text(word);
    let (stem, digits) = match text.find(|c: char| c.is_ascii_digit()) {
        Some(at) => text.split_at(at),
        None => (text.as_str(), ""),
    };
    match stem {
        "G" => match digits.split_once('=') {
            Some((number, _)) => format!("G{number}=n"),
            None => text,
        },
        "M" => text,
        "\"" => "\"text\"".to_owned(),
        stem if digits.is_empty() => stem.to_owned(),
        stem => format!("{}n", stem.trim_end_matches('-')),
    }
}

/// The parts of one line of a program.
pub fn highlight(line: &str) -> Vec<Highlight> {
    let line = latin1::bytes(line);
    let mut parts = Vec::new();
    let mut at = 0;
    while let Some(&byte) = line.get(at) {
        let rest = line.get(at + 1..).unwrap_or_default();
        let while_in = |set: fn(&u8) -> bool| rest.iter().take_while(|byte| set(byte)).count();
        let (length, class) = match byte {
            b' ' | b'\t' | b'\r' => {
                at += 1;
                continue;
            }
            b';' => (rest.len(), HighlightClass::Comment),
            b'"' => match rest.iter().position(|&byte| byte == b'"') {
                Some(end) => (end + 1, HighlightClass::Text),
                None => (rest.len(), HighlightClass::Error),
            },
            b'G' => (while_in(u8::is_ascii_digit), HighlightClass::Keyword),
            b'M' => (while_in(u8::is_ascii_digit), HighlightClass::Function),
            b'N' => (0, HighlightClass::LineNumber),
            b'X' | b'Y' => (0, HighlightClass::Variable),
            b'F' | b'D' => (0, HighlightClass::SystemVariable),
            b'0'..=b'9' => (while_in(u8::is_ascii_digit), HighlightClass::Number),
            b'*' | b'+' | b'-' | b'=' | b'<' | b'>' => (0, HighlightClass::Operator),
            _ => (0, HighlightClass::Error),
        };
        parts.push(Highlight {
            span: Span::new(at, at + 1 + length),
            class,
        });
        at += 1 + length;
    }
    parts
}
