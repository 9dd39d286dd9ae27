//! G codes (5-6, 6).

use super::registers::Register;
use super::scan::Scan;
use super::{Acceleration, Flow, Outcome, RegisterMode, Run, Target, Wait, World, known};
use crate::unidex3::indexer::{Axis, Edge, Feedrate, Interrupt, Pair};
use crate::unidex3::keywords::g_code;
use crate::unidex3::trouble::Trouble;

impl Run {
    pub(super) fn preparatory(&mut self, scan: &mut Scan<'_>, world: &mut World<'_>) -> Outcome {
        let start = scan.at;
        let code = scan.digits().ok_or(Trouble::G)?;
        let code = u16::try_from(code).map_err(|_| Trouble::G)?;
        // What stands behind decides which of the table's words it is.
        let digits = scan.text.get(start..scan.at).unwrap_or_default();
        let assigned = scan.peek() == Some(b'=') && code != 45 && code != 46;
        if let Some(without) = world.without
            && Some(without) == name(code, digits, assigned)
        {
            return Err(Trouble::G);
        }
        let value = match assigned && takes_value(code) {
            true => {
                scan.at += 1;
                Some(scan.digits().ok_or(Trouble::G)?)
            }
            false => None,
        };
        match code {
            271..=274
            | 281..=284
            | 201..=204
            | 211..=214
            | 301..=304
            | 311..=314
            | 401..=404
            | 411..=414
            | 321..=325 => self.input_code(code, scan, world),
            501..=508 | 511..=518 | 521..=528 | 531..=538 | 661..=668 | 671..=678 => {
                self.flag_code(code, value, scan)
            }
            36..=39 | 76 => self.acceleration_code(code, value),
            7 | 10..=12 | 60 | 61 | 92 => self.axis_code(code, value, scan, world),
            25 | 62 | 63 | 65 | 78 | 79 => self.operator_code(code, value, scan, world),
            99 => Ok(Flow::Reset),
            _ => self.mode_code(code),
        }
    }

    fn mode_code(&mut self, code: u16) -> Outcome {
        match code {
            0 | 1 => self.modes.vector = code == 1,
            23 | 24 => self.modes.corner_rounding = code == 23,
            90 | 91 => self.modes.absolute = code == 90,
            45 => self.modes.register = RegisterMode::SkipIfTrue,
            46 => self.modes.register = RegisterMode::SkipIfFalse,
            47 => self.modes.register = RegisterMode::Assign,
            48 => self.modes.register = RegisterMode::Move,
            49 => self.modes.register = RegisterMode::Normal,
            _ => return Err(Trouble::G),
        }
        Ok(Flow::Next)
    }

    /// Tests and interrupts of C inputs (5-6 E, 6-6 to 6-9).
    fn input_code(&mut self, code: u16, scan: &Scan<'_>, world: &mut World<'_>) -> Outcome {
        let input = u8::try_from(code % 10).unwrap_or_default();
        let (interrupt, edge) = match code / 10 {
            27 | 28 => {
                let goes_on = world.indexer.input(input) == (code / 10 == 27);
                return match goes_on {
                    true => Ok(Flow::Next),
                    false => self.skip(scan.at),
                };
            }
            32 => {
                let inputs = if input == 5 { 1..=4 } else { input..=input };
                inputs.for_each(|input| world.indexer.disarm(world.now, input));
                return Ok(Flow::Next);
            }
            20 => (Interrupt::Feedhold, Edge::Falling),
            21 => (Interrupt::Feedhold, Edge::Rising),
            30 => (Interrupt::Abort, Edge::Falling),
            31 => (Interrupt::Abort, Edge::Rising),
            40 => (Interrupt::Reset, Edge::Falling),
            _ => (Interrupt::Reset, Edge::Rising),
        };
        world.indexer.arm(world.now, input, interrupt, edge);
        Ok(Flow::Next)
    }

    /// Flags and repeat counters (5-6 F, G).
    fn flag_code(&mut self, code: u16, value: Option<i64>, scan: &Scan<'_>) -> Outcome {
        let index = usize::from(code % 10).saturating_sub(1).min(7);
        let flag = 1_u8 << index;
        let goes_on = match (code / 10, value) {
            (50, None) => {
                self.flags &= !flag;
                true
            }
            (51, None) => {
                self.flags |= flag;
                true
            }
            (52, None) => self.flags & flag != 0,
            (53, None) => self.flags & flag == 0,
            (66, Some(value)) => {
                let value = u16::try_from(value).map_err(|_| Trouble::G)?;
                if let Some(counter) = self.repeat.get_mut(index) {
                    *counter = value;
                }
                true
            }
            (67, None) => self.repeat.get_mut(index).is_some_and(|counter| {
                *counter = counter.wrapping_sub(1);
                *counter != 0
            }),
            _ => return Err(Trouble::G),
        };
        match goes_on {
            true => Ok(Flow::Next),
            false => self.skip(scan.at),
        }
    }

    /// G36 to G39 and G76 (6-16).
    fn acceleration_code(&mut self, code: u16, value: Option<i64>) -> Outcome {
        let parameters = &mut self.parameters;
        let within = |least: u32, most: u32| {
            let value = value.and_then(|value| u32::try_from(value).ok());
            value
                .filter(|value| (least..=most).contains(value))
                .ok_or(Trouble::G)
        };
        match (code, value) {
            (36, None) => parameters.acceleration = Acceleration::None,
            (37, None) => parameters.acceleration = Acceleration::Linear,
            (38, None) => parameters.acceleration = Acceleration::Vector,
            (39, None) => parameters.acceleration = Acceleration::Exponential,
            (37, Some(_)) => parameters.linear_ms = within(23, 4_000_000)?,
            (38, Some(_)) => parameters.rate = within(50, 5_000_000)?,
            (39, Some(_)) => parameters.exponential_ms = within(23, 4_000_000)?,
            (76, Some(_)) => {
                let frequency = within(31, 166_500)?;
                parameters.start_stop = Feedrate::start_stop(frequency).ok_or(Trouble::G)?;
            }
            _ => return Err(Trouble::G),
        }
        Ok(Flow::Next)
    }

    /// Home, drive resets, preload (5-6 B to D).
    fn axis_code(
        &mut self,
        code: u16,
        value: Option<i64>,
        scan: &mut Scan<'_>,
        world: &mut World<'_>,
    ) -> Outcome {
        let home = self.parameters.home;
        match (code, value) {
            (7, None) => world.indexer.home(world.now, home.map(Some)),
            (60, None) => {
                let feedrates = Pair {
                    x: Some(home.x),
                    y: None,
                };
                world.indexer.home(world.now, feedrates);
            }
            (61, None) => {
                let feedrates = Pair {
                    x: None,
                    y: Some(home.y),
                };
                world.indexer.home(world.now, feedrates);
            }
            (60 | 61, Some(value)) => {
                let feedrate = u32::try_from(value).ok().and_then(Feedrate::frequency);
                let axis = if code == 60 { Axis::X } else { Axis::Y };
                *self.parameters.home.of_mut(axis) = feedrate.ok_or(Trouble::G)?;
                return Ok(Flow::Next);
            }
            (10..=12, None) => {
                let axes = match code {
                    11 => [Some(Axis::X), None],
                    12 => [Some(Axis::Y), None],
                    _ => Axis::BOTH.map(Some),
                };
                let mut reset = |axis| world.indexer.reset_drive(world.now, axis);
                axes.into_iter().flatten().for_each(&mut reset);
                return Ok(Flow::Next);
            }
            (92, None) => {
                let legs = self.legs(scan, world)?;
                if legs.x.is_none() && legs.y.is_none() {
                    return Err(Trouble::Internal(37));
                }
                for axis in Axis::BOTH {
                    if let Some(value) = *legs.of(axis) {
                        world.indexer.preload(world.now, axis, value);
                    }
                }
                return Ok(Flow::Next);
            }
            _ => return Err(Trouble::G),
        }
        Ok(Flow::Wait(Wait::Move))
    }

    /// What involves a person or the controller: halts, slews, data, the message buffer (6-10 to 6-14).
    fn operator_code(
        &mut self,
        code: u16,
        value: Option<i64>,
        scan: &mut Scan<'_>,
        world: &World<'_>,
    ) -> Outcome {
        let number = match value {
            Some(value) => Some(u8::try_from(value).map_err(|_| Trouble::G)?),
            None => None,
        };
        match code {
            25 | 65 => {
                self.halt_number = number.or(self.halt_number);
                Ok(Flow::Wait(match code == 25 || world.remote {
                    true => Wait::Halt,
                    false => Wait::Print,
                }))
            }
            63 if number.is_none() => {
                self.to_buffer = true;
                Ok(Flow::Next)
            }
            78 | 79 => {
                self.slew_number = number.or(self.slew_number);
                if code == 78 {
                    self.slew_words(scan, world.without)?;
                }
                Ok(Flow::Wait(Wait::Slew))
            }
            62 if number.is_none() => self.data_input(scan, world),
            _ => Err(Trouble::G),
        }
    }

    fn data_input(&mut self, scan: &mut Scan<'_>, world: &World<'_>) -> Outcome {
        let start = scan.at;
        let target = match scan.peek() {
            Some(b'D') => Target::Message,
            Some(b'M') => Target::Outputs,
            Some(b'F') => Target::Flags,
            Some(b'X' | b'Y') => {
                // Not by scan_register: G62X1 is a word of its own.
                let length = match scan.text.get(start + 1) {
                    Some(b'1'..=b'4') => 2,
                    _ => 1,
                };
                let name = scan.text.get(start..start + length).unwrap_or_default();
                scan.at += length - 1;
                Target::Register(Register::from_name(name).ok_or(Trouble::G)?)
            }
            _ => return Err(Trouble::G),
        };
        scan.at += 1;
        self.own_prompt = scan.eat(b'<');
        let word = scan.text.get(start..scan.at).unwrap_or_default();
        let word = std::str::from_utf8(word).unwrap_or_default();
        known(&format!("G62{word}"), world, Trouble::G)?;
        Ok(Flow::Wait(Wait::Input(target)))
    }
}

fn takes_value(code: u16) -> bool {
    matches!(code, 25 | 37..=39 | 60 | 61 | 65 | 76 | 78 | 79 | 661..=668)
}

/// The table's word for a G code.
fn name(code: u16, digits: &[u8], assigned: bool) -> Option<&'static str> {
    let digits = match code {
        0 => "00",
        1 => "01",
        _ => std::str::from_utf8(digits).unwrap_or_default(),
    };
    let behind = if assigned { "=n" } else { "" };
    g_code(&format!("G{digits}{behind}"))
}
