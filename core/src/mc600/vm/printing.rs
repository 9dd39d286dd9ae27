//! PRINT: items go to the console as fast as the line takes them.

use super::super::code::Exit;
use super::super::code::{Code, Op};
use super::super::console::Console;
use super::super::firmware::{COLUMNS, ErrorCode, ZONE};
use super::super::value::to_byte;
use super::run::Flow;
use super::{Vm, World};
use crate::exec::Wait;

impl Vm {
    pub(super) fn console_operation(
        &mut self,
        op: Op,
        world: &mut World,
    ) -> Result<Flow, ErrorCode> {
        match op.code {
            Code::PrintNumber
            | Code::PrintString
            | Code::PrintComma
            | Code::PrintTab
            | Code::PrintSpaces
            | Code::PrintEnd => {
                // An item waits until the one before it is out: columns are known then.
                if !self.drain(world.console) {
                    return Ok(Flow::Again(Exit::Wait(Wait::Output)));
                }
                self.print_item(op, world.console.column())?;
                self.drain(world.console);
                Ok(Flow::Next)
            }
            _ => self.input_operation(op, world),
        }
    }

    fn print_item(&mut self, op: Op, column: usize) -> Result<(), ErrorCode> {
        let mut out = std::mem::take(&mut self.printing);
        match op.code {
            Code::PrintNumber => {
                self.format_number(op, &mut out);
                out.push(b' ');
            }
            Code::PrintString => out.extend_from_slice(self.string(op.a)),
            Code::PrintComma => {
                // Eight zones of ten on the 80-column line; behind the last one comes the next line.
                let zone = (column / ZONE + 1) * ZONE;
                if zone >= COLUMNS {
                    out.extend_from_slice(b"\r\n");
                } else {
                    out.resize(zone - column, b' ');
                }
            }
            Code::PrintTab => {
                let to = usize::from(to_byte(self.register(op.a))?);
                out.resize(to.saturating_sub(column), b' ');
            }
            Code::PrintSpaces => out.resize(usize::from(to_byte(self.register(op.a))?), b' '),
            _ => out.extend_from_slice(b"\r\n"),
        }
        self.printing = out;
        Ok(())
    }

    /// Gives the console what it takes now; whether everything is out.
    pub(super) fn drain(&mut self, console: &mut Console) -> bool {
        if !self.printing.is_empty() {
            let taken = console.print(&self.printing);
            self.printing.drain(..taken);
        }
        self.printing.is_empty()
    }

    /// Puts text before the console, to be taken as the line allows.
    pub fn say(&mut self, text: &[u8]) {
        self.printing.extend_from_slice(text);
    }

    /// Where the next character will stand on its line, once all is out.
    pub fn column(&self, console: &Console) -> usize {
        console.column_behind(&self.printing)
    }

    /// Gives the console what it takes now; whether everything is out.
    pub fn flush(&mut self, console: &mut Console) -> bool {
        self.drain(console)
    }
}
