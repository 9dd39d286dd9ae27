//! Keys while a program runs: most do nothing, but a program may wait for a person (6-10, 6-11, 6-14).

use super::{Manual, Unidex3};
use crate::time::Nanos;
use crate::unidex3::firmware::{MESSAGE, text};
use crate::unidex3::keys::{Function, Stroke};
use crate::unidex3::run::{Target, Wait};

/// Digits and sign that are kept of a number; the last ten digits count.
const LONGEST_NUMBER: usize = 11;

impl Unidex3 {
    pub(super) fn key_while_running(&mut self, at: Nanos, stroke: Stroke) {
        match self.run.wait {
            Some(Wait::Halt) => self.key_in_halt(at, stroke),
            Some(Wait::Slew) => self.key_in_slew(at, stroke),
            Some(Wait::Input(target)) => self.key_in_input(at, target, stroke),
            _ => {}
        }
    }

    /// G25: EXC goes on, SLW slews meanwhile, a mode key ends the program.
    fn key_in_halt(&mut self, at: Nanos, stroke: Stroke) {
        match stroke {
            Stroke::Function(Function::Execute) if self.panel.manual.is_none() => self.resume(),
            Stroke::Function(Function::ClearEntry | Function::ClearCommand)
                if self.panel.manual.is_some() =>
            {
                self.leave_manual(at);
                self.show_halt();
            }
            Stroke::Function(function @ (Function::Step | Function::Slew)) => {
                self.enter_manual(at, function);
            }
            Stroke::Function(
                function @ (Function::Edit
                | Function::Auto
                | Function::Single
                | Function::Immediate
                | Function::Print),
            ) => {
                self.leave_manual(at);
                self.cancel(at);
                self.mode_key(function);
            }
            // The program stays halted; the controller may ask for the unit again (6-10).
            Stroke::Function(Function::Remote) => self.remote_key(at),
            _ => {}
        }
    }

    /// G78, G79: CE leaves the slew, then EXC goes on; SLW enters it again, also after a limit.
    fn key_in_slew(&mut self, at: Nanos, stroke: Stroke) {
        match stroke {
            Stroke::Function(Function::ClearEntry | Function::ClearCommand) => {
                self.leave_manual(at);
            }
            Stroke::Function(function @ Function::Slew) => self.enter_manual(at, function),
            Stroke::Function(Function::Execute) if self.panel.manual.is_none() => self.resume(),
            _ => {}
        }
    }

    fn key_in_input(&mut self, at: Nanos, target: Target, stroke: Stroke) {
        if target == Target::Message {
            return self.key_in_message(stroke);
        }
        let typed = &mut self.panel.typed;
        match stroke {
            Stroke::Character(digit @ b'0'..=b'9') => {
                typed.push(digit);
                // The sign keeps its place when the digits move on.
                if typed.len() > LONGEST_NUMBER {
                    typed.remove(usize::from(typed.first() == Some(&b'-')));
                }
            }
            Stroke::Character(b'-') if typed.is_empty() => typed.push(b'-'),
            Stroke::Function(Function::ClearEntry) => {
                typed.pop();
            }
            Stroke::Function(Function::Execute) => {
                let value = number(typed);
                self.enter(at, target, value);
                return self.resume();
            }
            _ => return,
        }
        let typed = self.panel.typed.clone();
        self.panel.display.typed(&typed);
    }

    fn key_in_message(&mut self, stroke: Stroke) {
        let typed = &mut self.panel.typed;
        match (self.panel.message, stroke) {
            (false, Stroke::Function(Function::Execute)) => return self.resume(),
            (false, Stroke::Character(b'"')) => {
                typed.clear();
                self.panel.message = true;
            }
            (true, Stroke::Character(b'"')) => {
                self.panel.message = false;
                self.run.buffer.set(typed);
                return;
            }
            (true, Stroke::Character(byte)) => {
                if typed.len() >= MESSAGE {
                    typed.pop();
                }
                typed.push(byte);
            }
            (true, Stroke::Function(Function::ClearEntry)) => {
                typed.pop();
            }
            _ => return,
        }
        let typed = self.panel.typed.clone();
        self.panel.display.typed(&typed);
    }

    /// What a person entered goes where the program wanted it; 8 bits of it for outputs and flags (6-14 B).
    fn enter(&mut self, at: Nanos, target: Target, value: i64) {
        let low = value.to_le_bytes().first().copied().unwrap_or_default();
        match target {
            Target::Register(register) => {
                let most = crate::unidex3::indexer::LARGEST;
                let value = value.clamp(-most, most);
                self.run
                    .set_register(register, value, &mut self.indexer, at);
            }
            Target::Outputs => self.run.set_outputs(low, self.options.oem_in),
            Target::Flags => self.run.flags = low,
            Target::Message => {}
        }
    }

    /// The program goes on.
    pub(in crate::unidex3) fn resume(&mut self) {
        self.run.wait = None;
        self.panel.message = false;
        self.say(match self.remote_run {
            true => text::REMOTE,
            false => text::RUNNING,
        });
    }

    /// `G25=`, `G25=126`; the controller reads it otherwise.
    pub(in crate::unidex3) fn show_halt(&mut self) {
        let message = match self.run.halt_number {
            _ if self.remote_run => text::REMOTE.to_owned(),
            Some(number) => format!("G25={number}"),
            None => "G25=".to_owned(),
        };
        self.say(&message);
    }

    /// `SLEW=57`: arrow keys and joystick move the axes.
    pub(in crate::unidex3) fn show_slew(&mut self, at: Nanos) {
        self.begin_manual(at, Manual::Slew);
        let message = match self.run.slew_number {
            Some(number) => format!("SLEW={number}"),
            None => text::SLEW.to_owned(),
        };
        self.say(&message);
    }
}

/// The last ten digits, behind a sign or none.
fn number(typed: &[u8]) -> i64 {
    let digits = typed.iter().filter(|byte| byte.is_ascii_digit());
    let digits: Vec<u8> = digits.copied().collect();
    let last = digits.len().saturating_sub(10);
    let text = String::from_utf8_lossy(digits.get(last..).unwrap_or_default()).into_owned();
    let value: i64 = text.parse().unwrap_or_default();
    match typed.first() {
        Some(b'-') => -value,
        _ => value,
    }
}
