//! What the unit prints: programs, directory, registers, messages (3-4 E to J, 4-7; spec, "Remote interface").

use super::Unidex3;
use super::memory::Program;
use super::run::{Register, formatted};
use super::words::codewords;

/// The margin.
const MARGIN: &[u8] = b"         ";
const LINE_END: &[u8] = b"\r\n";
const ESCAPE: u8 = 0x1B;

impl Unidex3 {
    /// A program, with what makes it load back; `None` if it is not there.
    pub(super) fn list_program(&self, number: u8) -> Option<Vec<u8>> {
        let mut programs = self.memory.programs().iter();
        let program = programs.find(|program| program.number == number)?;
        let mut text = self.leader();
        text.extend(header(program));
        text.extend(body(&program.text));
        text.extend(b"%\r\nL\r\n");
        text.push(self.memory.end_of_file);
        Some(text)
    }

    /// All programs.
    pub(super) fn list_memory(&self) -> Vec<u8> {
        let mut text = self.leader();
        let programs = self.memory.programs();
        for (index, program) in programs.iter().enumerate() {
            text.extend(header(program));
            text.extend(body(&program.text));
            let last = index + 1 == programs.len();
            text.push(if last { b'%' } else { b'&' });
            text.extend(LINE_END);
        }
        text.extend(self.free_line());
        text
    }

    /// Numbers and lengths of all programs.
    pub(super) fn list_directory(&self) -> Vec<u8> {
        let mut text = title("DIRECTORY");
        for program in self.memory.programs() {
            text.extend(program_line(program));
        }
        text.push(b'\n');
        text.extend(self.free_line());
        text
    }

    /// The message buffer, as G65 and PRT M print it.
    pub(super) fn list_message(&self) -> Vec<u8> {
        [MARGIN, &self.run.buffer.0, LINE_END].concat()
    }

    /// `X:AXIS = 0000000000`.
    pub(super) fn list_register(&self, register: Register) -> Vec<u8> {
        let what = match register {
            Register::Position(_) => "AXIS",
            Register::X(_) | Register::Y(_) => "REG",
        };
        let value = self.run.register(register, &self.indexer);
        let sign = if value < 0 { "-" } else { "" };
        let digits = formatted(value.saturating_abs(), 10);
        let name = format!("{}:{what} = {sign}", register.word());
        [name.as_bytes(), &digits, LINE_END].concat()
    }

    fn leader(&self) -> Vec<u8> {
        let mut text = title("PROGRAM");
        text.push(ESCAPE);
        text.extend(self.options.address.to_string().bytes());
        text.extend(LINE_END);
        text
    }

    fn free_line(&self) -> Vec<u8> {
        let free = format!(";FREE: {:05} BYTES", self.memory.free());
        let end = [self.memory.end_of_file];
        [MARGIN, free.as_bytes(), LINE_END, &end].concat()
    }
}

fn title(what: &str) -> Vec<u8> {
    let title = format!(";UNIDEX-III {what} LISTING\r\n\n");
    [MARGIN, title.as_bytes()].concat()
}

fn header(program: &Program) -> Vec<u8> {
    let mut text = format!("E{:02}\r\n", program.number).into_bytes();
    text.extend(program_line(program));
    text.extend(LINE_END);
    text
}

fn program_line(program: &Program) -> Vec<u8> {
    let line = format!(
        ";PROGRAM # {:02}   LENGTH: {:05} BYTES\r\n",
        program.number,
        program.length()
    );
    [MARGIN, line.as_bytes()].concat()
}

/// The program's lines, a block each.
fn body(text: &[u8]) -> Vec<u8> {
    let lines = lines(text).into_iter();
    lines
        .flat_map(|line| [MARGIN, &line, LINE_END].concat())
        .collect()
}

/// The blocks of a program, with a blank before every letter, message and end of block but the first.
pub fn lines(text: &[u8]) -> Vec<Vec<u8>> {
    let mut lines: Vec<Vec<u8>> = Vec::new();
    let mut line = Vec::new();
    for word in codewords(text) {
        let word = text.get(word).unwrap_or_default();
        if !line.is_empty() {
            line.push(b' ');
        }
        line.extend(word);
        if word == b"*" {
            lines.push(std::mem::take(&mut line));
        }
    }
    if !line.is_empty() {
        lines.push(line);
    }
    lines
}
