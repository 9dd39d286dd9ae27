//! Step and slew: moving the axes by arrow keys or joystick (3-4 L).

use super::Unidex3;
use crate::time::Nanos;
use crate::unidex3::firmware::text;
use crate::unidex3::indexer::{Axis, Direction};
use crate::unidex3::keys::{Function, Key, Stroke};
use crate::unidex3::run::Wait;

/// What an arrow key does.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Manual {
    /// One step at each press.
    Step,
    /// Steps while it is held.
    Slew,
}

fn arrow(key: Key) -> (Axis, Direction) {
    match key {
        Key::Right => (Axis::X, Direction::Positive),
        Key::Left => (Axis::X, Direction::Negative),
        Key::Up => (Axis::Y, Direction::Positive),
        _ => (Axis::Y, Direction::Negative),
    }
}

impl Unidex3 {
    /// STP or SLW.
    pub(super) fn enter_manual(&mut self, at: Nanos, function: Function) {
        self.take_slew_feedrates();
        let manual = match function {
            Function::Slew => Manual::Slew,
            _ => Manual::Step,
        };
        self.begin_manual(at, manual);
        let message = match (manual, self.run.wait, self.run.slew_number) {
            (Manual::Slew, Some(Wait::Slew), Some(number)) => format!("SLEW={number}"),
            (Manual::Slew, ..) => text::SLEW.to_owned(),
            (Manual::Step, ..) => text::STEP.to_owned(),
        };
        self.say(&message);
    }

    /// Arrow keys move axes from now on, in a slew also the joystick.
    pub(in crate::unidex3) fn begin_manual(&mut self, at: Nanos, manual: Manual) {
        self.release_arrows(at);
        self.panel.manual = Some(manual);
        let divisor = (manual == Manual::Slew).then_some(self.run.parameters.joystick);
        self.indexer.joystick(at, divisor);
    }

    /// Arrow keys and joystick move nothing any more.
    pub(in crate::unidex3) fn leave_manual(&mut self, at: Nanos) {
        if self.panel.manual.take().is_some() {
            self.release_arrows(at);
            self.indexer.joystick(at, None);
        }
    }

    /// No arrow key is down any more.
    pub(in crate::unidex3) fn release_arrows(&mut self, at: Nanos) {
        for (axis, _) in std::mem::take(&mut self.panel.held) {
            self.indexer.stop_axis(at, axis);
        }
    }

    pub(super) fn key_in_manual(&mut self, at: Nanos, stroke: Stroke) {
        match stroke {
            Stroke::Function(Function::ClearEntry | Function::ClearCommand) => {
                self.leave_manual(at);
                self.show_mode();
            }
            Stroke::Function(function @ (Function::Step | Function::Slew)) => {
                self.enter_manual(at, function);
            }
            Stroke::Function(Function::Execute) | Stroke::Character(_) => {}
            Stroke::Function(_) => {
                self.leave_manual(at);
                self.key_in_mode(at, stroke);
            }
        }
    }

    pub(super) fn arrow_down(&mut self, at: Nanos, key: Key) {
        let (axis, direction) = arrow(key);
        match self.panel.manual {
            None => {}
            Some(Manual::Step) => self.indexer.step(at, axis, direction),
            Some(Manual::Slew) => {
                self.panel.held.retain(|&(held, _)| held != axis);
                self.panel.held.push((axis, direction));
                let feedrate = *self.run.modes.feedrates.of(axis);
                self.indexer.slew(at, axis, direction, feedrate);
            }
        }
    }

    pub(super) fn arrow_up(&mut self, at: Nanos, key: Key) {
        let arrow = arrow(key);
        let before = self.panel.held.len();
        self.panel.held.retain(|&held| held != arrow);
        if self.panel.held.len() != before {
            self.indexer.stop_axis(at, arrow.0);
        }
    }
}
