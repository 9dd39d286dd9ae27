//! The text of a program from the controller: character by character into memory (4-5 B).

use crate::time::Nanos;
use crate::unidex3::Unidex3;
use crate::unidex3::trouble::Trouble;

/// A program that is being sent.
#[derive(Debug, Clone)]
pub(super) struct OpenEdit {
    number: u8,
    text: Vec<u8>,
    in_message: bool,
    /// Behind a `;`, to the end of the line.
    in_comment: bool,
    /// Nothing but blanks since the last line end.
    at_line_start: bool,
    /// There was no room.
    full: bool,
}

impl Unidex3 {
    /// `E nn`: an old program of that number is gone (3-5 B).
    pub(super) fn open_edit(&mut self, _now: Nanos, number: u8) {
        self.errors = Default::default();
        self.memory.remove(number);
        if !self.memory.store(number, &[]) {
            self.errors.note(Trouble::BufferFull);
            return self.remote.request();
        }
        self.memory.editing = Some(number);
        self.panel.number = Some(number);
        self.remote.edit = Some(OpenEdit {
            number,
            text: Vec::new(),
            in_message: false,
            in_comment: false,
            at_line_start: true,
            full: false,
        });
    }

    /// Whether a byte begins a command although a program is open: at the start of a line, a letter that no codeword
    /// begins with.
    pub(super) fn is_command(&self, byte: u8) -> bool {
        let edit = self.remote.edit.as_ref();
        edit.is_some_and(|edit| {
            edit.at_line_start
                && !edit.in_message
                && !edit.in_comment
                && matches!(
                    byte,
                    b'E' | b'A'
                        | b'S'
                        | b'I'
                        | b'R'
                        | b'V'
                        | b'P'
                        | b'L'
                        | b'Q'
                        | b'C'
                        | b'T'
                        | b'H'
                        | b'O'
                        | b'J'
                        | b'K'
                        | b'W'
                        | b'Z'
                        | b'U'
                        | b'B'
                )
        })
    }

    /// A line that has waited.
    pub(super) fn edit_line(&mut self, line: &[u8]) {
        for &byte in line.iter().chain(b"\r") {
            self.edit_byte(byte);
        }
        // Its line end is over.
        self.remote.ends_edit = false;
    }

    pub(super) fn edit_byte(&mut self, byte: u8) {
        let knows_comments = self.knows(";");
        let Some(edit) = &mut self.remote.edit else {
            return;
        };
        match byte {
            b'\r' | b'\n' => {
                edit.at_line_start = true;
                edit.in_comment = false;
                return;
            }
            _ if edit.in_comment => return,
            b'%' | b'&' if !edit.in_message => {
                let word = if byte == b'%' { "%" } else { "&" };
                if self.knows(word) {
                    self.remote.ends_edit = true;
                    self.end_edit();
                }
                return;
            }
            b';' if !edit.in_message && knows_comments => {
                edit.in_comment = true;
                return;
            }
            // Blanks are neither needed nor kept.
            0..=b' ' | b'@' if !edit.in_message => return,
            0..b' ' => return,
            b'"' => edit.in_message = !edit.in_message,
            _ => {}
        }
        edit.at_line_start = false;
        edit.text.push(byte);
        let (number, text) = (edit.number, &edit.text);
        if !self.memory.store(number, text) {
            edit.text.pop();
            if !std::mem::replace(&mut edit.full, true) {
                self.errors.note(Trouble::BufferFull);
                self.remote.request();
            }
        }
    }

    /// `%`, `&` or another command: the program is whole, and compiled with all others.
    pub(in crate::unidex3) fn end_edit(&mut self) {
        if self.remote.edit.take().is_none() {
            return;
        }
        if let Some(number) = self.close_edit() {
            self.errors.note(Trouble::Compile(number));
            self.say(&Trouble::Compile(number).text());
            self.remote.request();
        }
    }
}
