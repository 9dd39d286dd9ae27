//! Which controller is on the bench. One takes the place of another; the work with each is kept.

use leptos::prelude::*;
use motionbench_core::catalog::{Kind, kind};
use motionbench_core::controller::{Memory, TerminalSettings};
use motionbench_core::serial::LineSettings;

use super::bus::BusLog;
use super::editor::EditorState;
use super::front::{Paper, Settings};
use super::project::{self, Desk};
use super::revive::Health;
use super::store::Wanted;
use super::terminal::Terminal;
use super::wiring::Wiring;
use super::{Device, Store};
use crate::protocol::ToWorker;

impl Store {
    /// The kind of controller on the bench.
    pub fn kind(&self) -> &'static Kind {
        self.editor.with(EditorState::kind)
    }

    /// Puts a controller of another kind on the bench, as soon as the present one has said what it holds.
    pub fn choose(&self, kind: &'static Kind) {
        if kind.id != untrack(|| self.kind().id) {
            self.wanted.set_value(Some(Wanted::Kind(kind)));
            self.send(ToWorker::Keep);
        }
    }

    /// Sets the switches and jumpers of the present controller: it is switched off and on for that.
    pub fn set_switches(&self, settings: Settings) {
        self.wanted.set_value(Some(Wanted::Settings(settings)));
        self.send(ToWorker::Keep);
    }

    /// A frame has come: what was asked for before it has been answered.
    pub(super) fn change_over(&self) {
        match self.wanted.try_update_value(Option::take).flatten() {
            Some(Wanted::Kind(kind)) => self.change_kind(kind),
            Some(Wanted::Settings(settings)) => {
                self.settings.set(settings);
                self.start_again();
            }
            None => {}
        }
    }

    fn change_kind(&self, kind: &'static Kind) {
        let mut others = self.others.get_untracked();
        let place = others
            .iter()
            .position(|desk| desk.device.controller == kind.id);
        let next = match place {
            Some(place) => others.remove(place),
            None => new_desk(kind),
        };
        others.push(self.desk());
        self.put_on_bench(next);
        self.others.set(others);
    }

    /// The work with the present controller.
    pub(super) fn desk(self) -> Desk {
        let line = self.device.with_untracked(|device| device.line);
        let (text, breakpoints) = self
            .editor
            .with_untracked(|editor| (editor.text().to_owned(), editor.breakpoints()));
        Desk {
            text,
            breakpoints,
            line: line.unwrap_or(LineSettings::new(9600)),
            terminal: self.terminal_settings.get_untracked(),
            settings: self.settings.get_untracked(),
            device: self.held(),
        }
    }

    /// What the present controller holds.
    pub(super) fn held(self) -> project::Device {
        let status = |device: &Device| device.status.as_ref().is_none_or(|status| status.power);
        project::Device {
            controller: untrack(|| self.kind().id.to_owned()),
            power: self.device.with_untracked(status),
            memory: self.kept.get_untracked().unwrap_or_default(),
        }
    }

    /// Puts a controller on the bench, with the work that belongs to it. A kind that there is not is passed over:
    /// nothing that is read has one.
    pub(super) fn put_on_bench(self, desk: Desk) {
        let Some(kind) = kind(&desk.device.controller) else {
            return;
        };
        if kind.id != untrack(|| self.kind().id) {
            self.clear_bench(kind, desk.settings);
        } else if self
            .settings
            .with_untracked(|settings| *settings != desk.settings)
        {
            self.settings.set(desk.settings);
            self.start_worker();
        }
        self.editor
            .update(|editor| editor.open(&desk.text, desk.breakpoints));
        self.kept.set(Some(desk.device.memory));
        self.equip_worker(desk.device.power, Some(desk.line), desk.terminal);
    }

    /// Gives a new worker all that is known of its controller.
    pub(super) fn equip_worker(
        self,
        on: bool,
        line: Option<LineSettings>,
        terminal: Option<TerminalSettings>,
    ) {
        self.send(ToWorker::Speed(
            self.device.with_untracked(|device| device.speed),
        ));
        if let Some(line) = line {
            self.set_line(line);
        }
        self.set_terminal(terminal);
        // What the mains switch clears comes back behind it.
        if !on {
            self.send(ToWorker::Power(false));
        }
        if let Some(memory) = self.kept.get_untracked() {
            self.send(ToWorker::Restore(memory));
        }
    }

    /// Takes everything off the bench that belongs to the present controller, and starts a simulator of another.
    fn clear_bench(self, kind: &'static Kind, settings: Settings) {
        let speed = self.device.with_untracked(|device| device.speed);
        self.editor.update(|editor| editor.change_kind(kind));
        self.device.set(Device {
            speed,
            ..Device::default()
        });
        self.wiring.set(Wiring::new(kind));
        self.settings.set(settings);
        self.paper.set(Paper::default());
        self.bus.set(BusLog::default());
        self.recording.set(None);
        self.cam.set(None);
        self.filed.set(None);
        self.asked.set(false);
        self.refusal.set(None);
        self.health.set_value(Health::default());
        self.terminal.update_value(Terminal::reset);
        self.printed.update(|count| *count += 1);
        self.clear_scopes();
        self.start_worker();
    }
}

/// What a controller is found with that has not been used yet.
fn new_desk(kind: &Kind) -> Desk {
    Desk {
        text: kind.first_program.to_owned(),
        breakpoints: Default::default(),
        line: kind.line,
        terminal: None,
        settings: Settings::new(),
        device: project::Device {
            controller: kind.id.to_owned(),
            power: true,
            memory: Memory::default(),
        },
    }
}
