//! Operations that are not worth a place in the hot loop: the motor, the serial line, waits, output.

use super::super::ast::{Source, Target, TextReport};
use super::super::code::{Exit, Op, Slow};
use super::super::line::Line;
use super::super::memory::{Eeprom, Sequence, set_element};
use super::super::motor::{Flag, Motor, Register};
use super::run::Flow;
use super::{Stream, Vm, World};
use crate::exec::Wait;

/// What RSP answers: the sample time in 10 ns, and the version of the firmware (D149).
const SAMPLE_TIME: &str = "24576/412";

impl Vm {
    #[inline(never)]
    pub(super) fn slow(&mut self, op: Op, world: &mut World<'_>) -> Flow {
        let slow = match world.host {
            true => self.host.image.slow.clone(),
            false => self.program.image.slow.clone(),
        };
        let Some(slow) = slow.get(usize::from(op.a)) else {
            return Flow::Next;
        };
        let value = self.register(op.b);
        match slow {
            Slow::Get(source) => {
                let value = take(*source, world);
                self.set_register(op.c, value);
            }
            Slow::Set(target) => set(*target, value, world),
            Slow::Fill(array, values) => {
                for (offset, &number) in (0..).zip(values.iter()) {
                    let index = value.saturating_add(offset);
                    if !set_element(&mut self.registers, *array, index, number) {
                        world.motor.raise(Flag::IndexRange);
                    }
                }
            }
            Slow::Motor(command) => {
                world.motor.command(*command);
                log(world, || command.to_string());
            }
            Slow::ClearLine(flag) => world.line.flags.clear(*flag),
            Slow::Save(place) => {
                let sequence = Sequence::new(*place, self.register(op.c));
                if !world.eeprom.save(&self.registers, sequence, value) {
                    world.motor.raise(Flag::IndexRange);
                }
            }
            Slow::Restore(place) => {
                let sequence = Sequence::new(*place, self.register(op.c));
                if !world.eeprom.restore(&mut self.registers, sequence, value) {
                    world.motor.raise(Flag::IndexRange);
                }
            }
            Slow::Stack => self.forget_calls(),
            Slow::Raise(flag) => world.motor.raise(*flag),
            Slow::RunIfAsked if self.asked => {}
            Slow::RunIfAsked | Slow::End => return Flow::Leave(Exit::End),
            Slow::System(system) => return Flow::Leave(Exit::System(*system)),
            Slow::Line(command) => world.line.command(*command, world.motor),
            Slow::Nothing => {}
            Slow::Wait | Slow::WaitForTrajectory | Slow::Pause => {
                return self.wait(slow, value, world);
            }
            Slow::PrintText(_)
            | Slow::PrintNumber
            | Slow::PrintByte
            | Slow::PrintEnd(_)
            | Slow::Report
            | Slow::ReportText(_) => return self.print(slow, value, world),
        }
        Flow::Next
    }

    fn register(&self, register: u16) -> i32 {
        self.registers
            .get(usize::from(register))
            .copied()
            .unwrap_or(0)
    }

    fn set_register(&mut self, register: u16, value: i32) {
        if let Some(place) = self.registers.get_mut(usize::from(register)) {
            *place = value;
        }
    }

    fn stream(&mut self, host: bool) -> &mut Stream {
        match host {
            true => &mut self.host,
            false => &mut self.program,
        }
    }

    fn wait(&mut self, slow: &Slow, value: i32, world: &mut World<'_>) -> Flow {
        let (now, reason) = match slow {
            Slow::WaitForTrajectory => {
                return match world.motor.is(Flag::Trajectory) {
                    true => Flow::Again(Exit::Wait(Wait::Motion)),
                    false => Flow::Next,
                };
            }
            Slow::Pause => (world.line.received(), Wait::Input),
            _ => (world.motor.ticks(), Wait::Time),
        };
        // The statement itself takes the last of the samples, where it takes one (D147).
        let own = u64::from(world.authentic && world.motor.servo_divisor() == 1);
        let stream = self.stream(world.host);
        let until = *stream.until.get_or_insert(match slow {
            Slow::Pause => now + 1,
            _ => now + u64::try_from(value).unwrap_or(0).saturating_sub(own),
        });
        if now < until {
            return Flow::Again(Exit::Wait(reason));
        }
        stream.until = None;
        Flow::Next
    }

    /// PRINT composes its parts, so that what one statement sends stays together.
    fn print(&mut self, slow: &Slow, value: i32, world: &mut World<'_>) -> Flow {
        let stream = self.stream(world.host);
        match slow {
            Slow::PrintText(text) => stream.composed.extend_from_slice(text),
            Slow::PrintNumber => stream.composed.extend(value.to_string().bytes()),
            Slow::PrintByte => stream.composed.extend(value.to_le_bytes().first()),
            _ => {
                if !world.line.has_room() {
                    return Flow::Again(Exit::Wait(Wait::Output));
                }
                let mut composed = std::mem::take(&mut stream.composed);
                let mut channel = 0;
                match slow {
                    Slow::Report => composed.extend(format!("{value}\r").bytes()),
                    Slow::ReportText(report) => {
                        let text = text_report(*report, world.motor, world.checksum);
                        composed.extend(text.bytes().chain(std::iter::once(b'\r')));
                    }
                    Slow::PrintEnd(number) => channel = *number,
                    _ => {}
                }
                world.line.print(channel, &composed, world.host);
            }
        }
        Flow::Next
    }
}

fn log(world: &mut World<'_>, what: impl FnOnce() -> String) {
    if let Some(log) = world.log.as_deref_mut() {
        log.push(what());
    }
}

fn set(target: Target, value: i32, world: &mut World<'_>) {
    match target {
        Target::Register(register) => {
            world.motor.set(register, value);
            log(world, || format!("{register}={value}"));
        }
        Target::EepromPointer => world.eeprom.pointer = value,
        Target::Address => match u8::try_from(value).ok().filter(|&number| number <= 100) {
            Some(address) => world.line.set_address(address),
            None => world.motor.raise(Flag::Syntax),
        },
        // Variables are set by the hot loop.
        Target::Place(_) => {}
    }
}

/// The value that a program takes; some are gone then.
fn take(source: Source, world: &mut World<'_>) -> i32 {
    match source {
        Source::Register(register) => world.motor.read(register),
        Source::Character => world.line.take_character().map_or(-1, i32::from),
        source => read(source, world.motor, world.line, world.eeprom),
    }
}

/// The value of something of the motor, without any effect.
pub fn read(source: Source, motor: &Motor, line: &Line, eeprom: &Eeprom) -> i32 {
    match source {
        Source::Register(register) => motor.get(register),
        Source::Flag(flag) => i32::from(motor.is(flag)),
        Source::LineFlag(flag) => i32::from(line.flags.is(flag)),
        Source::EepromPointer => eeprom.pointer,
        Source::Address => i32::from(line.address()),
        Source::Length => i32::try_from(line.characters()).unwrap_or(i32::MAX),
        Source::Character => line.next_character().map_or(-1, i32::from),
        Source::ModuleInput => 0,
    }
}

/// A report that is no single number, without its CR.
pub fn text_report(report: TextReport, motor: &Motor, checksum: &str) -> String {
    let word = motor.status();
    match report {
        TextReport::Word => word.to_string(),
        TextReport::Byte => (word & 0xFF).to_string(),
        TextReport::PositionAndWord => {
            format!("{},{word}", motor.get(Register::ActualPosition))
        }
        TextReport::Sample => SAMPLE_TIME.to_owned(),
        TextReport::Checksum => checksum.to_owned(),
        // Channel 1 has nothing connected that could go wrong.
        TextReport::Channel1 => "0".to_owned(),
        TextReport::Mode => motor.mode_letter().to_string(),
    }
}
