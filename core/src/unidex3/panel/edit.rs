//! The editor and the immediate mode: a text, a cursor, and keys that type (3-4 A, D).

use super::{Edit, Edited, Mode, Unidex3};
use crate::time::Nanos;
use crate::unidex3::firmware::{IMMEDIATE, MESSAGE, text};
use crate::unidex3::keys::{Function, Stroke};
use crate::unidex3::run::Kind;
use crate::unidex3::trouble::Trouble;
use crate::unidex3::words;

/// In front of what is typed.
const PROMPT: &[u8] = b">>";

impl Unidex3 {
    /// Opens a program at its first codeword; a new one is empty.
    pub(in crate::unidex3) fn open(&mut self, number: u8) {
        if !self.memory.is_valid() {
            return self.complain(Trouble::Internal(3));
        }
        let text = self.memory.text(number);
        if text.is_none() && !self.memory.store(number, &[]) {
            return self.complain(Trouble::BufferFull);
        }
        let text = text.map(|text| text.to_vec()).unwrap_or_default();
        self.memory.editing = Some(number);
        self.panel.number = Some(number);
        self.panel.edited = Edited {
            number,
            cursor: words::next_end(&text, 0).unwrap_or(0),
            text,
        };
        self.panel.mode = Mode::Edit(Edit::Program);
        self.show_edited();
    }

    /// Ends an edit, and precompiles (6-2); `false` if something does not compile, which has been said.
    pub(in crate::unidex3) fn leave_edit(&mut self) -> bool {
        if !matches!(self.panel.mode, Mode::Edit(Edit::Program | Edit::Search(_))) {
            return true;
        }
        self.panel.mode = Mode::None;
        match self.close_edit() {
            Some(number) => {
                self.panel.number = Some(number);
                self.complain(Trouble::Compile(number));
                false
            }
            None => true,
        }
    }

    pub(super) fn show_edited(&mut self) {
        let edited = &self.panel.edited;
        let before = edited.text.get(..edited.cursor).unwrap_or_default();
        self.panel.display.typed(&[PROMPT, before].concat());
    }

    pub(super) fn key_in_edit(&mut self, stroke: Stroke) {
        let Mode::Edit(edit) = self.panel.mode.clone() else {
            return;
        };
        match (edit, stroke) {
            (Edit::Program | Edit::Search(_), Stroke::Function(Function::Search)) => {
                self.panel.message = false;
                self.panel.mode = Mode::Edit(Edit::Search(Vec::new()));
                self.prompt();
            }
            (Edit::Search(sought), stroke) => self.key_in_search(sought, stroke),
            (Edit::Program, Stroke::Character(byte)) => self.insert(byte),
            (Edit::Program, Stroke::Function(function)) => self.edit_function(function),
            (edit, stroke) => self.key_in_selection(edit, stroke),
        }
    }

    fn key_in_search(&mut self, mut sought: Vec<u8>, stroke: Stroke) {
        match stroke {
            Stroke::Character(byte) => {
                if byte == b'"' {
                    self.panel.message = !self.panel.message;
                }
                if sought.len() < IMMEDIATE {
                    sought.push(byte);
                }
            }
            Stroke::Function(Function::ClearEntry) => {
                if sought.pop() == Some(b'"') {
                    self.panel.message = !self.panel.message;
                }
            }
            Stroke::Function(Function::ClearCommand) => {
                sought.clear();
                self.panel.message = false;
            }
            // Back to the program.
            Stroke::Function(function) => {
                self.panel.message = false;
                self.panel.mode = Mode::Edit(Edit::Program);
                return self.edit_function(function);
            }
        }
        self.panel.mode = Mode::Edit(Edit::Search(sought));
        self.prompt();
    }

    fn edit_function(&mut self, function: Function) {
        let edited = &mut self.panel.edited;
        let (text, at) = (&edited.text, edited.cursor);
        match function {
            // Both wrap around.
            Function::Step => edited.cursor = words::next_end(text, at).unwrap_or(0),
            Function::Backstep => {
                edited.cursor = words::previous_end(text, at).unwrap_or(text.len());
            }
            Function::Slew => edited.cursor = words::next_end(text, 0).unwrap_or(0),
            Function::ClearEntry if at > 0 => {
                edited.text.remove(at - 1);
                edited.cursor = at - 1;
                self.keep_edited();
            }
            Function::ClearCommand if at > 0 => {
                let start = words::word_before(text, at);
                let end = words::next_end(text, at - 1).unwrap_or(at);
                edited.text.drain(start..end.max(at));
                edited.cursor = start;
                self.keep_edited();
            }
            _ => {}
        }
        let edited = &self.panel.edited;
        // Only clearing opens a message again; stepping goes from end to end.
        let clears = matches!(function, Function::ClearEntry | Function::ClearCommand);
        self.panel.message = clears && words::in_message(&edited.text, edited.cursor);
        self.show_edited();
    }

    /// Types a character at the cursor. The 33rd of a message replaces the one before it (6-12 A).
    fn insert(&mut self, byte: u8) {
        let edited = &mut self.panel.edited;
        let at = edited.cursor.min(edited.text.len());
        let start = words::word_before(&edited.text, at);
        let full = self.panel.message && at - start > MESSAGE && byte != b'"';
        if full {
            if let Some(last) = edited.text.get_mut(at - 1) {
                *last = byte;
            }
        } else {
            if !self.memory.has_room(edited.number, edited.text.len() + 1) {
                return self.complain_about_room();
            }
            edited.text.insert(at, byte);
            edited.cursor = at + 1;
        }
        if byte == b'"' {
            self.panel.message = !self.panel.message;
        }
        self.keep_edited();
        self.show_edited();
    }

    fn complain_about_room(&mut self) {
        let message = self.panel.message;
        self.complain(Trouble::BufferFull);
        self.panel.message = message;
    }

    fn keep_edited(&mut self) {
        let edited = &self.panel.edited;
        // It has room: it was asked before it grew.
        self.memory.store(edited.number, &edited.text);
    }

    // The immediate mode.

    pub(super) fn key_in_immediate(&mut self, stroke: Stroke) {
        if self.panel.block_ran && matches!(stroke, Stroke::Character(_)) {
            self.panel.block.clear();
            self.panel.block_ran = false;
        }
        let block = &mut self.panel.block;
        match stroke {
            Stroke::Character(byte) => {
                let start = words::word_before(block, block.len());
                let full = self.panel.message && block.len() - start > MESSAGE && byte != b'"';
                if full {
                    block.pop();
                }
                if block.len() >= IMMEDIATE {
                    return self.complain_about_room();
                }
                block.push(byte);
            }
            Stroke::Function(Function::ClearEntry) => {
                block.pop();
            }
            Stroke::Function(Function::ClearCommand) => {
                let start = words::word_before(block, block.len());
                block.truncate(start);
            }
            _ => return,
        }
        self.panel.message = words::in_message(block, block.len());
        let shown = [PROMPT, block].concat();
        self.panel.display.typed(&shown);
    }

    pub(super) fn execute_block(&mut self, at: Nanos) {
        if self.panel.block.is_empty() {
            return;
        }
        self.panel.block_ran = true;
        let block = self.panel.block.clone();
        self.start_text(at, None, block.into(), Kind::Immediate);
    }

    /// What stands in the immediate mode's block is feedrates for a slew (3-4 L).
    pub(super) fn take_slew_feedrates(&mut self) {
        if self.panel.mode != Mode::Immediate || self.panel.block_ran {
            return;
        }
        let block = std::mem::take(&mut self.panel.block);
        if let Err(trouble) = self.run.slew_feedrates(&block, self.options.without) {
            self.complain(trouble);
        }
    }

    /// The mode's prompt, or what was typed.
    pub(super) fn show_mode(&mut self) {
        match self.panel.mode {
            Mode::None => self.say(text::READY),
            Mode::Auto { select: false } | Mode::Single { select: false } => self.say(text::READY),
            _ => self.prompt(),
        }
    }
}
