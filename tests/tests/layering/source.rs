//! A source file as the rules see it: its names and paths, without comments and literals.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

/// A file of the project.
pub(crate) struct Source {
    /// Relative to the project's folder, with `/`.
    pub(crate) name: String,
    pub(crate) text: String,
}

/// The project's folder.
pub(crate) fn root() -> PathBuf {
    let tests = Path::new(env!("CARGO_MANIFEST_DIR"));
    tests
        .parent()
        .expect("this crate has a folder of its own")
        .to_owned()
}

/// Every file under `folder` whose name ends with one of `endings`, but for what builds and fuzzing leave.
pub(crate) fn files(folder: &str, endings: &[&str]) -> Vec<Source> {
    let mut found = Vec::new();
    collect(&root(), folder, endings, &mut found);
    found.sort_by(|a, b| a.name.cmp(&b.name));
    found
}

const MADE: [&str; 6] = [
    ".git",
    "target",
    "node_modules",
    "corpus",
    "artifacts",
    "coverage",
];

fn collect(root: &Path, folder: &str, endings: &[&str], found: &mut Vec<Source>) {
    for entry in root.join(folder).read_dir().into_iter().flatten().flatten() {
        let file = entry.file_name().to_string_lossy().into_owned();
        let name = format!("{folder}/{file}")
            .trim_start_matches('/')
            .to_owned();
        if entry.path().is_dir() {
            if !MADE.contains(&file.as_str()) {
                collect(root, &name, endings, found);
            }
        } else if endings.iter().any(|ending| file.ends_with(ending)) {
            let bytes = std::fs::read(entry.path()).expect("the file can be read");
            let text = String::from_utf8_lossy(&bytes).into_owned();
            found.push(Source { name, text });
        }
    }
}

impl Source {
    /// Every name and mark of a Rust file with its line, from 1.
    pub(crate) fn tokens(&self) -> Vec<(usize, &str)> {
        let mut lexer = Lexer {
            text: &self.text,
            at: 0,
            line: 1,
        };
        std::iter::from_fn(|| lexer.token()).collect()
    }

    /// Every path that a Rust file names, in `use` or elsewhere, from the root of its crate or of another: with its
    /// line, `crate::files::Disk`, `std::rc::Rc`, `std::*`.
    pub(crate) fn paths(&self) -> BTreeSet<(usize, String)> {
        let mut reader = Paths {
            tokens: self.tokens(),
            at: 0,
            modules: module(&self.name)
                .into_iter()
                .map(|name| (0, name))
                .collect(),
            depth: 0,
            found: BTreeSet::new(),
        };
        while reader.at < reader.tokens.len() {
            reader.next();
        }
        reader.found
    }
}

/// The module that a file is, by its name: `core/src/mc600/vm/run.rs` is `mc600`, `vm`, `run`.
fn module(name: &str) -> Vec<String> {
    let inside = name.split_once("/src/").map_or(name, |(_, inside)| inside);
    let mut parts: Vec<&str> = inside.trim_end_matches(".rs").split('/').collect();
    if matches!(parts.last(), Some(&("mod" | "lib" | "main"))) {
        parts.pop();
    }
    parts.into_iter().map(str::to_owned).collect()
}

struct Lexer<'a> {
    text: &'a str,
    at: usize,
    line: usize,
}

impl<'a> Lexer<'a> {
    fn token(&mut self) -> Option<(usize, &'a str)> {
        loop {
            let rest = &self.text[self.at..];
            let first = rest.chars().next()?;
            let length = match first {
                c if c.is_whitespace() => c.len_utf8(),
                '/' if rest.starts_with("//") => rest.find('\n').unwrap_or(rest.len()),
                '/' if rest.starts_with("/*") => comment(rest),
                c if c.is_alphanumeric() || c == '_' => {
                    let word = word(rest);
                    match literal(rest, &rest[word..]) {
                        Some(length) => length,
                        None => return Some(self.take(word)),
                    }
                }
                '"' => string(rest, 0),
                '\'' => match character(rest) {
                    Some(length) => length,
                    None => 1 + word(&rest[1..]),
                },
                ':' if rest.starts_with("::") => return Some(self.take(2)),
                c => return Some(self.take(c.len_utf8())),
            };
            self.take(length);
        }
    }

    fn take(&mut self, length: usize) -> (usize, &'a str) {
        let (line, token) = (self.line, &self.text[self.at..self.at + length]);
        self.at += length;
        self.line += token.matches('\n').count();
        (line, token)
    }
}

fn word(text: &str) -> usize {
    let end = text.find(|c: char| !c.is_alphanumeric() && c != '_');
    end.unwrap_or(text.len())
}

/// The length of a comment, which may have others inside it.
fn comment(text: &str) -> usize {
    let (mut at, mut depth) = (0, 0);
    while at < text.len() {
        let rest = &text.as_bytes()[at..];
        let step = match rest {
            [b'/', b'*', ..] => {
                depth += 1;
                2
            }
            [b'*', b'/', ..] => {
                depth -= 1;
                2
            }
            _ => 1,
        };
        at += step;
        if depth == 0 {
            break;
        }
    }
    at
}

/// The length of a string or character with a prefix such as `b` or `r#`; `rest` stands behind the prefix.
fn literal(text: &str, rest: &str) -> Option<usize> {
    let prefix = &text[..text.len() - rest.len()];
    let hashes = rest.len() - rest.trim_start_matches('#').len();
    match prefix {
        "r" | "br" | "cr" if rest[hashes..].starts_with('"') => {
            let close = format!("\"{}", "#".repeat(hashes));
            let body = &rest[hashes + 1..];
            let end = body
                .find(&close)
                .map_or(body.len(), |end| end + close.len());
            Some(prefix.len() + hashes + 1 + end)
        }
        "b" | "c" if rest.starts_with('"') => Some(string(text, prefix.len())),
        "b" if rest.starts_with('\'') => character(rest).map(|length| 1 + length),
        _ => None,
    }
}

/// The length of a text up to the end of the string that begins at `quote`.
fn string(text: &str, quote: usize) -> usize {
    let mut escaped = false;
    let end = text[quote + 1..].find(|c| {
        let ends = c == '"' && !escaped;
        escaped = c == '\\' && !escaped;
        ends
    });
    end.map_or(text.len(), |end| quote + 1 + end + 1)
}

/// The length of a character constant; `None` for a lifetime.
fn character(text: &str) -> Option<usize> {
    let mut characters = text.char_indices().skip(1);
    let (_, first) = characters.next()?;
    if first == '\\' {
        characters.next()?;
        return text[3..].find('\'').map(|end| 3 + end + 1);
    }
    let (at, second) = characters.next()?;
    (second == '\'').then_some(at + 1)
}

struct Paths<'a> {
    tokens: Vec<(usize, &'a str)>,
    at: usize,
    /// The modules around the present place, each with the depth of braces at which it ends.
    modules: Vec<(usize, String)>,
    depth: usize,
    found: BTreeSet<(usize, String)>,
}

impl<'a> Paths<'a> {
    fn peek(&self, ahead: usize) -> &'a str {
        self.tokens
            .get(self.at + ahead)
            .map_or("", |(_, token)| token)
    }

    fn next(&mut self) {
        match self.peek(0) {
            "use" => {
                self.at += 1;
                self.tree(&[]);
            }
            "mod" if self.peek(2) == "{" => {
                self.modules.push((self.depth + 1, self.peek(1).to_owned()));
                self.depth += 1;
                self.at += 3;
            }
            "{" => {
                self.depth += 1;
                self.at += 1;
            }
            "}" => {
                self.modules
                    .retain(|&(depth, _)| depth == 0 || depth != self.depth);
                self.depth = self.depth.saturating_sub(1);
                self.at += 1;
            }
            word if is_name(word) && self.peek(1) == "::" => {
                let mut path = vec![self.take()];
                while self.peek(0) == "::" && is_name(self.peek(1)) {
                    self.at += 1;
                    path.push(self.take());
                }
                self.note(&path);
            }
            _ => self.at += 1,
        }
    }

    fn take(&mut self) -> &'a str {
        self.at += 1;
        self.tokens[self.at - 1].1
    }

    /// One branch of a `use` and everything behind it.
    fn tree(&mut self, before: &[&'a str]) {
        let mut path = before.to_vec();
        if self.peek(0) == "::" {
            self.at += 1;
        }
        loop {
            match self.peek(0) {
                "{" => {
                    self.at += 1;
                    while !matches!(self.peek(0), "}" | "") {
                        self.tree(&path);
                        if self.peek(0) == "," {
                            self.at += 1;
                        }
                    }
                    self.at += 1;
                    return;
                }
                "*" => {
                    path.push(self.take());
                    return self.note(&path);
                }
                word if is_name(word) => path.push(self.take()),
                _ => return,
            }
            match self.peek(0) {
                "::" => self.at += 1,
                "as" => {
                    self.at += 2;
                    return self.note(&path);
                }
                _ => return self.note(&path),
            }
        }
    }

    /// Notes a path, counted from its crate's root.
    fn note(&mut self, path: &[&'a str]) {
        let line = self.tokens.get(self.at - 1).map_or(0, |(line, _)| *line);
        let mut absolute: Vec<String> = match path.first() {
            Some(&"crate") => vec!["crate".to_owned()],
            Some(&("self" | "super")) => {
                let around = self.modules.iter().map(|(_, name)| name.clone());
                std::iter::once("crate".to_owned()).chain(around).collect()
            }
            _ => Vec::new(),
        };
        for &part in path {
            match part {
                // `use files::{self, ...}` names `files`.
                "crate" | "self" => {}
                "super" => drop(absolute.pop()),
                part => absolute.push(part.to_owned()),
            }
        }
        self.found.insert((line, absolute.join("::")));
    }
}

fn is_name(token: &str) -> bool {
    token.starts_with(|c: char| c.is_alphabetic() || c == '_')
}

#[cfg(test)]
mod tests {
    use super::Source;

    fn source(text: &str) -> Source {
        let name = "core/src/mc600/vm/run.rs".to_owned();
        let text = text.to_owned();
        Source { name, text }
    }

    #[test]
    fn names_are_found_outside_comments_and_literals() {
        let text = "fn a<'b>() { /* c /* d */ e */ \"f\\\"g\"; 'h'; '\\''; b'i'; br#\"j\"k\"#; r\"l\" } // m\nn";
        let source = source(text);
        let names: Vec<(usize, &str)> = source.tokens();
        let names: Vec<(usize, &str)> = names
            .into_iter()
            .filter(|(_, t)| super::is_name(t))
            .collect();
        assert_eq!(names, [(1, "fn"), (1, "a"), (2, "n")]);
    }

    #[test]
    fn paths_are_counted_from_the_root() {
        let text = "use std::{fmt, io::{self, Read as R}, time::*};\n\
                    use super::super::code::Code;\n\
                    use crate::files;\n\
                    fn f() { self::g(std::mem::take(x)); ::std::process::exit(Vec::<u8>::new()) }\n\
                    mod tests { use super::*; mod deeper { use super::super::h; } }\n\
                    use super::last;";
        let found: Vec<(usize, String)> = source(text).paths().into_iter().collect();
        let expected = [
            (1, "std::fmt"),
            (1, "std::io"),
            (1, "std::io::Read"),
            (1, "std::time::*"),
            (2, "crate::mc600::code::Code"),
            (3, "crate::files"),
            (4, "Vec"),
            (4, "crate::mc600::vm::run::g"),
            (4, "std::mem::take"),
            (4, "std::process::exit"),
            (5, "crate::mc600::vm::run::*"),
            (5, "crate::mc600::vm::run::h"),
            (6, "crate::mc600::vm::last"),
        ];
        let found: Vec<(usize, &str)> = found.iter().map(|(l, p)| (*l, p.as_str())).collect();
        assert_eq!(found, expected);
    }
}
