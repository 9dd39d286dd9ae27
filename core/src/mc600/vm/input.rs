//! INPUT, READ and DATA: fields of text become values.

use super::super::code::{ANY, Code, Exit, Op};
use super::super::firmware::ErrorCode;
use super::super::value::{Text, in_range};
use super::run::Flow;
use super::{Vm, World};
use crate::exec::Wait;
use crate::number;

/// Asks for the whole answer again.
const REDO: &[u8] = b"?REDO FROM START\r\n";

/// The state of an INPUT statement.
#[derive(Debug, Clone, Default)]
pub struct Answer {
    state: State,
    /// Where the statement begins, to ask again from there.
    statement: u32,
    /// What was typed and is not read yet; `None` when more has to be asked for.
    rest: Option<Vec<u8>>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
enum State {
    #[default]
    Idle,
    /// A question mark is out; the line has not come yet.
    Asked,
}

impl Vm {
    pub(super) fn input_operation(&mut self, op: Op, world: &mut World) -> Result<Flow, ErrorCode> {
        match op.code {
            Code::Input => {
                let prompt = if op.a == ANY {
                    Vec::new()
                } else {
                    self.string(op.a).to_vec()
                };
                match self.ask(&[&prompt[..], b"? "].concat(), world)? {
                    None => Ok(Flow::Again(self.waiting())),
                    // RETURN alone leaves every variable as it is.
                    Some(line) if line.iter().all(|&byte| byte == b' ') => {
                        Ok(Flow::Jump(op.target()))
                    }
                    Some(line) => {
                        self.answer.statement = self.pc.saturating_sub(1);
                        self.answer.rest = Some(line);
                        Ok(Flow::Next)
                    }
                }
            }
            Code::InputNumber | Code::InputString => self.input_field(op, world),
            Code::InputEnd => {
                if self.answer.rest.take().is_some() {
                    self.say(b"?EXTRA IGNORED\r\n");
                }
                Ok(Flow::Next)
            }
            Code::ReadNumber | Code::ReadString => self.read(op),
            Code::Restore => {
                self.data = 0;
                Ok(Flow::Next)
            }
            // Every other operation is dispatched before.
            _ => Err(ErrorCode::Syntax),
        }
    }

    fn waiting(&self) -> Exit {
        Exit::Wait(if self.is_printing() {
            Wait::Output
        } else {
            Wait::Input
        })
    }

    /// Asks once, then waits for the line.
    fn ask(&mut self, question: &[u8], world: &mut World) -> Result<Option<Vec<u8>>, ErrorCode> {
        if self.answer.state == State::Idle {
            self.answer.state = State::Asked;
            self.say(question);
        }
        if !self.drain(world.console) {
            return Ok(None);
        }
        let Some(typed) = world.console.take_line() else {
            return Ok(None);
        };
        self.answer.state = State::Idle;
        if typed.too_long {
            self.say(REDO);
            return Ok(None);
        }
        Ok(Some(typed.text))
    }

    fn input_field(&mut self, op: Op, world: &mut World) -> Result<Flow, ErrorCode> {
        if self.answer.rest.is_none() {
            match self.ask(b"?? ", world)? {
                Some(line) => self.answer.rest = Some(line),
                None => return Ok(Flow::Again(self.waiting())),
            }
        }
        let line = self.answer.rest.take().unwrap_or_default();
        let (field, rest) = split_field(&line);
        if op.code == Code::InputString {
            let text = Text::from_slice(&field);
            self.set_string(op.c, text);
        } else {
            match whole_number(&field) {
                Some(value) => self.set_register(op.c, in_range(value)?),
                None => {
                    self.say(REDO);
                    return Ok(Flow::Jump(self.answer.statement));
                }
            }
        }
        self.answer.rest = rest;
        Ok(Flow::Next)
    }

    fn read(&mut self, op: Op) -> Result<Flow, ErrorCode> {
        let item = self.image.data.get(self.data).cloned();
        let Some((line, item)) = item else {
            return Err(ErrorCode::OutOfData);
        };
        if op.code == Code::ReadString {
            self.set_string(op.c, Text::from_slice(&item.text));
        } else {
            match whole_number(&item.text).filter(|_| !item.quoted) {
                Some(value) => self.set_register(op.c, in_range(value)?),
                None => {
                    // The error names the line of the DATA that does not fit (D23).
                    self.give_up();
                    return Ok(Flow::Leave(Exit::Error(ErrorCode::Syntax, Some(line))));
                }
            }
        }
        self.data += 1;
        Ok(Flow::Next)
    }
}

/// A number with nothing behind it; nothing at all is zero.
fn whole_number(text: &[u8]) -> Option<f64> {
    let text = text.trim_ascii();
    if text.is_empty() {
        return Some(0.0);
    }
    let (constant, length) = number::leading(text)?;
    (length == text.len()).then(|| constant.real())
}

/// The first field of a line that was typed, and what stands behind its comma. Quotes keep commas and blanks.
fn split_field(line: &[u8]) -> (Vec<u8>, Option<Vec<u8>>) {
    let line = line.trim_ascii_start();
    if let Some(quoted) = line.strip_prefix(b"\"") {
        let end = quoted
            .iter()
            .position(|&byte| byte == b'"')
            .unwrap_or(quoted.len());
        let field = quoted.get(..end).unwrap_or_default().to_vec();
        let behind = quoted.get(end + 1..).unwrap_or_default();
        let comma = behind.iter().position(|&byte| byte == b',');
        return (
            field,
            comma
                .and_then(|comma| behind.get(comma + 1..))
                .map(<[u8]>::to_vec),
        );
    }
    match line.iter().position(|&byte| byte == b',') {
        Some(comma) => {
            let field = line
                .get(..comma)
                .unwrap_or_default()
                .trim_ascii_end()
                .to_vec();
            (field, line.get(comma + 1..).map(<[u8]>::to_vec))
        }
        None => (line.trim_ascii_end().to_vec(), None),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fields_end_at_commas_outside_quotes() {
        let field = |line: &str| {
            let (field, rest) = split_field(line.as_bytes());
            (
                String::from_utf8(field).unwrap(),
                rest.map(|rest| String::from_utf8(rest).unwrap()),
            )
        };
        assert_eq!(field(" a b , c"), ("a b".into(), Some(" c".into())));
        assert_eq!(field("\"a, b\" , c"), ("a, b".into(), Some(" c".into())));
        assert_eq!(field("a,"), ("a".into(), Some(String::new())));
        assert_eq!(field("a"), ("a".into(), None));
    }
}
