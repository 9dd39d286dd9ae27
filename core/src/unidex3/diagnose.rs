//! What is wrong with a program, told from its text alone, and the colours of its lines.

use super::keys::{self, Key};
use super::remote;
use super::words::{self, Objection, codewords, packed};
use crate::language::{Diagnostic, Highlight, HighlightClass, Severity, Span, latin1, split_lines};

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
    for (row, line) in split_lines(&latin1::bytes(text)).enumerate() {
        for (column, &byte) in line.iter().enumerate() {
            match byte {
                b'"' => in_message = !in_message,
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
    for line in split_lines(&latin1::bytes(text)) {
        let text = packed(line, &mut in_message);
        lines.push((!text.is_empty()).then_some(block));
        let ends = codewords(&text)
            .into_iter()
            .filter(|word| text.get(word.clone()) == Some(b"*"));
        block += u32::try_from(ends.count()).unwrap_or(0);
    }
    lines
}

/// The words of the keyword table that a line uses: one of a program, of the controller, or of keys.
pub fn words(line: &str) -> Vec<&'static str> {
    let mut found: Vec<String> = Vec::new();
    let keys: Option<Vec<(Key, bool)>> = line.split_whitespace().map(keys::named).collect();
    if let Some(keys) = keys {
        let words = keys
            .iter()
            .filter_map(|&(key, shifted)| keys::word(key, shifted));
        found.extend(words.map(str::to_owned));
        if line.split_whitespace().any(|name| name.len() > 1) {
            // What is typed makes codewords, as a program's line does.
            let typed: String = line
                .split_whitespace()
                .filter(|name| name.len() == 1)
                .collect();
            found.extend(code_words(&typed));
        }
    }
    if line.starts_with(['\u{1b}', '\\']) {
        found.extend(["<ESC>", "<DEL>"].map(str::to_owned));
    }
    let packed: Vec<u8> = latin1::bytes(line)
        .into_iter()
        .filter(|&byte| byte != b' ')
        .collect();
    let command = packed.strip_prefix(b"\\x1B").unwrap_or(&packed);
    if let Some((&letter, rest)) = command.split_first() {
        found.push(remote::word(letter, rest).to_owned());
    }
    found.extend(code_words(line));
    found.extend(code_words(line.strip_prefix('I').unwrap_or_default()));
    let rows = super::keywords::rows().into_iter();
    rows.map(|row| row.word)
        .filter(|word| found.iter().any(|other| other == word))
        .collect()
}

/// The words of a program's line. What X, Y and F are depends on the modes: they are counted both as codewords and as
/// registers.
fn code_words(line: &str) -> Vec<String> {
    let mut in_message = false;
    let text = packed(&latin1::bytes(line), &mut in_message);
    let mut found = Vec::new();
    let marks = [";", "&", "%"]
        .into_iter()
        .filter(|mark| line.contains(mark));
    found.extend(marks.map(str::to_owned));
    let mut data_input = false;
    for range in codewords(&text) {
        let word = latin1::text(text.get(range).unwrap_or_default());
        if std::mem::replace(&mut data_input, word == "G62") {
            found.push(format!("G62{word}"));
        }
        let (letter, rest) = word.split_at(word.chars().next().map_or(0, char::len_utf8));
        let digits = rest.trim_start_matches(|c: char| c.is_ascii_digit());
        let number = rest.strip_suffix(digits).unwrap_or_default();
        match letter {
            "*" => found.push(word.clone()),
            "\"" => found.extend(message_words(&word)),
            "G" | "M" => {
                let shape = if digits.starts_with(['=', '-'])
                    && (letter == "M" || digits.starts_with('='))
                {
                    format!("{letter}{number}{}n", digits.get(..1).unwrap_or_default())
                } else {
                    format!("{letter}{number}")
                };
                found.push(shape);
            }
            "X" | "Y" | "F" | "D" | "N" => {
                let sign = rest.chars().next().filter(|c| "=-<>+".contains(*c));
                found.push(format!(
                    "{letter}{}n",
                    sign.map_or(String::new(), String::from)
                ));
                found.push(format!("{letter}n"));
                found.push(format!("{letter}{number}"));
            }
            _ => {}
        }
        let operators = rest
            .split(|c: char| !"<>=".contains(c))
            .filter(|part| !part.is_empty());
        found.extend(operators.map(str::to_owned));
        let signs = rest.chars().filter(|c| "+-".contains(*c));
        found.extend(signs.map(String::from));
    }
    found
}

/// What stands in a message between `<` and `>`.
fn message_words(message: &str) -> Vec<String> {
    let inside = message
        .split('<')
        .skip(1)
        .filter_map(|part| part.split('>').next());
    let mut found = vec!["\"text\"".to_owned()];
    found.extend(inside.map(|name| match name {
        "C" | "M" | "F" => format!("\"<{name}>\""),
        name if name.contains('/') => "\"<X/n>\"".to_owned(),
        _ => "\"<X>\"".to_owned(),
    }));
    found
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
