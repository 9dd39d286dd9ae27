//! Standard input as the console of a controller.

use std::io::{self, BufRead, IsTerminal, Read};
use std::sync::mpsc::{Receiver, TryRecvError, channel};

use crossterm::terminal;

use crate::files;

/// Ctrl-D leaves the console.
const LEAVE: u8 = 0x04;

/// Where what is typed comes from.
pub(super) enum Source {
    /// There is no one at the console.
    Nothing,
    /// Lines, each read when the controller waits for one, so that a run does not depend on who is faster.
    Pipe,
    /// Keys as they are pressed.
    Terminal(Terminal),
}

/// What was given.
pub(super) enum Given {
    /// These bytes.
    Bytes(Vec<u8>),
    /// Nothing now.
    Nothing,
    /// Nothing any more.
    End,
}

/// A terminal without echo and line editing: the controller does both.
pub(super) struct Terminal {
    keys: Receiver<u8>,
}

impl Source {
    /// Standard input, whatever it is.
    pub(super) fn standard_input() -> Result<Source, String> {
        // Where the output goes elsewhere, the input is read as if it came from a file.
        if !io::stdin().is_terminal() || !io::stdout().is_terminal() {
            return Ok(Source::Pipe);
        }
        terminal::enable_raw_mode()
            .map_err(|error| format!("the terminal: {}", files::reason(&error)))?;
        let (sender, keys) = channel();
        std::thread::spawn(move || {
            for key in io::stdin().lock().bytes().map_while(Result::ok) {
                if sender.send(key).is_err() {
                    break;
                }
            }
        });
        Ok(Source::Terminal(Terminal { keys }))
    }

    pub(super) fn is_terminal(&self) -> bool {
        matches!(self, Source::Terminal(_))
    }

    /// What has been typed, without waiting.
    pub(super) fn at_hand(&mut self) -> Given {
        match self {
            Source::Nothing | Source::Pipe => Given::Nothing,
            Source::Terminal(terminal) => match terminal.keys.try_recv() {
                Ok(key) => terminal.given(key),
                Err(TryRecvError::Empty) => Given::Nothing,
                Err(TryRecvError::Disconnected) => Given::End,
            },
        }
    }

    /// What is typed next.
    pub(super) fn wait(&mut self) -> Given {
        match self {
            Source::Nothing => Given::End,
            Source::Pipe => line(&mut io::stdin().lock()),
            Source::Terminal(terminal) => match terminal.keys.recv() {
                Ok(key) => terminal.given(key),
                Err(_) => Given::End,
            },
        }
    }
}

impl Terminal {
    fn given(&self, first: u8) -> Given {
        let keys = std::iter::once(first).chain(self.keys.try_iter());
        let keys: Vec<u8> = keys.collect();
        match keys.contains(&LEAVE) {
            true => Given::End,
            false => Given::Bytes(keys),
        }
    }
}

impl Drop for Terminal {
    fn drop(&mut self) {
        // There is nothing to do about a terminal that does not go back.
        let _ = terminal::disable_raw_mode();
        println!();
    }
}

/// A line of a pipe, its end as the key of a terminal sends it.
fn line(input: &mut impl BufRead) -> Given {
    let mut line = Vec::new();
    match input.read_until(b'\n', &mut line) {
        Ok(0) | Err(_) => return Given::End,
        Ok(_) => {}
    }
    if line.ends_with(b"\n") {
        line.pop();
        if line.ends_with(b"\r") {
            line.pop();
        }
        line.push(b'\r');
    }
    Given::Bytes(line)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_end_as_the_enter_key_does() {
        let mut input = &b"PRINT 1\r\nPRINT 2\n\nPRINT 3"[..];
        let mut lines = Vec::new();
        while let Given::Bytes(bytes) = line(&mut input) {
            lines.push(String::from_utf8(bytes).unwrap());
        }
        assert_eq!(lines, ["PRINT 1\r", "PRINT 2\r", "\r", "PRINT 3"]);
    }
}
