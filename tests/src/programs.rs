//! The program text in a scenario: what it types, sends and loads.

use motionbench_core::scenario::program_text;

use crate::conformance::{beside, file, text};

/// What a scenario gives a controller to read, a line each, in its order.
///
/// # Panics
/// If there is no such scenario.
pub fn lines(name: &str) -> Vec<String> {
    let text = text(name);
    let mut lines = Vec::new();
    let mut in_program = false;
    for line in text.lines() {
        if in_program {
            in_program = line.trim() != "end";
            if in_program {
                lines.push(line.to_owned());
            }
            continue;
        }
        let (word, rest) = statement(line);
        match word {
            "program" => in_program = true,
            "type" => lines.push(rest.to_owned()),
            "send" => lines.extend(sent(rest)),
            "press" => lines.push(rest.to_owned()),
            "hold" => lines.extend(rest.split(' ').next().map(str::to_owned)),
            "load" | "file" => lines.extend(loaded(name, rest)),
            _ => {}
        }
    }
    lines
}

/// A line's statement and what follows it, past a station's name and the time of `at`.
fn statement(line: &str) -> (&str, &str) {
    let (word, rest) = line
        .trim_start()
        .split_once(' ')
        .unwrap_or((line.trim(), ""));
    match word {
        "at" => statement(
            rest.trim_start()
                .split_once(' ')
                .map_or("", |(_, rest)| rest),
        ),
        word if word.ends_with(':') => statement(rest),
        word => (word, rest),
    }
}

/// The lines in a quoted text of `send`.
fn sent(quoted: &str) -> Vec<String> {
    let inner = quoted.trim().trim_matches('"');
    let lines = inner.split("\\r").flat_map(|line| line.split("\\n"));
    lines.map(|line| line.replace("\\\"", "\"")).collect()
}

/// The lines of a file in quotes, if it is there.
fn loaded(name: &str, rest: &str) -> Vec<String> {
    let quoted = rest.split('"').nth(1);
    let bytes = quoted.and_then(|quoted| file(&beside(name, quoted)));
    let text = bytes.map(program_text).unwrap_or_default();
    text.lines().map(str::to_owned).collect()
}
