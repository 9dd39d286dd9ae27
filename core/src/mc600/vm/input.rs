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
        let field = Field::first(&line);
        let number = whole_number(&field.text).filter(|_| !field.quoted);
        match number {
            _ if field.torn => return Ok(self.redo()),
            _ if op.code == Code::InputString => {
                self.set_string(op.c, Text::from_slice(&field.text));
            }
            Some(value) => self.set_register(op.c, in_range(value)?),
            None => return Ok(self.redo()),
        }
        self.answer.rest = field.rest;
        Ok(Flow::Next)
    }

    /// Asks for everything again.
    fn redo(&mut self) -> Flow {
        self.say(REDO);
        Flow::Jump(self.answer.statement)
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

/// The first field of a line that was typed. Quotes keep commas and blanks.
#[derive(Debug, PartialEq)]
struct Field {
    text: Vec<u8>,
    /// It stood in quotes, and is no number (D235).
    quoted: bool,
    /// Something stands behind the closing quote.
    torn: bool,
    /// What stands behind its comma.
    rest: Option<Vec<u8>>,
}

impl Field {
    fn first(line: &[u8]) -> Field {
        let line = line.trim_ascii_start();
        let quoted = line.strip_prefix(b"\"");
        let (text, behind) = match quoted {
            Some(inner) => split_at(inner, b'"'),
            None => (line, Some(line)),
        };
        let (before, rest) = split_at(behind.unwrap_or_default(), b',');
        let text = match quoted {
            Some(_) => text,
            None => before.trim_ascii_end(),
        };
        Field {
            text: text.to_vec(),
            quoted: quoted.is_some(),
            torn: quoted.is_some() && !before.trim_ascii().is_empty(),
            rest: rest.map(<[u8]>::to_vec),
        }
    }
}

/// What stands before the first `mark`, and what stands behind it.
fn split_at(text: &[u8], mark: u8) -> (&[u8], Option<&[u8]>) {
    let mut parts = text.splitn(2, |&byte| byte == mark);
    (parts.next().unwrap_or_default(), parts.next())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fields_end_at_commas_outside_quotes() {
        for (line, text, quoted, torn, rest) in [
            (" a b , c", "a b", false, false, Some(" c")),
            ("\"a, b\" , c", "a, b", true, false, Some(" c")),
            ("\" a", " a", true, false, None),
            ("\"a\"b, c", "a", true, true, Some(" c")),
            ("a\"b\"", "a\"b\"", false, false, None),
            ("a,", "a", false, false, Some("")),
            ("a", "a", false, false, None),
            ("", "", false, false, None),
        ] {
            let expected = Field {
                text: text.into(),
                quoted,
                torn,
                rest: rest.map(Into::into),
            };
            assert_eq!(Field::first(line.as_bytes()), expected, "{line}");
        }
    }
}
