//! The state in the page: what panels draw from, and where they send what the user does.
//!
//! What was printed and what was recorded stay out of the reactive graph; it carries only the news that there is more.

use leptos::prelude::*;
use motionbench_core::catalog::{KINDS, Kind};
use motionbench_core::controller::{CamTable, Memory, RunState, TerminalSettings};
use motionbench_core::exec::Wait;

use super::bus::BusLog;
use super::editor::EditorState;
use super::front::{Paper, Settings};
use super::project::{Desk, Layout};
use super::recording::Recording;
use super::revive::Health;
use super::scope::Scope;
use super::terminal::Terminal;
use super::wiring::Wiring;
use super::{Console, Device, Fault, News};
use crate::client::Client;
use crate::protocol::{Frame, Ready, ToWorker, Unloadable};

/// What the user wants on the bench instead of what is there.
#[derive(Debug, Clone)]
pub(super) enum Wanted {
    /// A controller of another kind.
    Kind(&'static Kind),
    /// The same with other switches and jumpers.
    Settings(Settings),
}

/// All that the page knows. A handle: copies are of the same state.
#[derive(Clone, Copy)]
pub struct Store {
    /// The controller.
    pub device: RwSignal<Device>,
    /// How the page is laid out.
    pub layout: RwSignal<Layout>,
    /// What goes to the console and comes from it.
    pub console: Console,
    /// The terminal has the keyboard.
    pub typing: RwSignal<bool>,
    /// The front panel has the keyboard.
    pub pressing: RwSignal<bool>,
    /// The editor has the keyboard.
    pub editing: RwSignal<bool>,
    /// Grows when the terminal looks different.
    pub printed: RwSignal<u64>,
    /// How the switches outside the controller stand.
    pub wiring: RwSignal<Wiring>,
    /// Grows when the user changes what the scope shows.
    pub chosen: RwSignal<u64>,
    /// Grows when the scope looks different.
    pub recorded: RwSignal<u64>,
    /// The program that the user edits.
    pub editor: RwSignal<EditorState>,
    /// The user wants to run, and has to say whose program.
    pub asked: RwSignal<bool>,
    /// Why the controller did not take the editor's program.
    pub refusal: RwSignal<Option<Unloadable>>,
    /// What the controller held when it was last asked.
    pub kept: RwSignal<Option<Memory>>,
    /// The cam table in use when it was last asked for.
    pub cam: RwSignal<Option<CamTable>>,
    /// What came of the last file that was given to the controller.
    pub filed: RwSignal<Option<Result<String, String>>>,
    /// The project's name.
    pub project_name: RwSignal<String>,
    /// The work with other controllers of the project, which are not on the bench now.
    pub others: RwSignal<Vec<Desk>>,
    /// What the terminal does besides what the line does, if not what suits the controller best.
    pub terminal_settings: RwSignal<Option<TerminalSettings>>,
    /// How the switches and jumpers of the controller stand.
    pub settings: RwSignal<Settings>,
    /// What its printer has on the paper.
    pub paper: RwSignal<Paper>,
    /// The printer listens to the line.
    pub printer: RwSignal<bool>,
    /// What was asked of the IEEE-488 bus, and what came of it.
    pub bus: RwSignal<BusLog>,
    /// The keys of the front panel, while they are written down.
    pub recording: RwSignal<Option<Recording>>,
    /// Grows with each pulse of the outputs' strobe that was seen.
    pub strobes: RwSignal<u64>,
    /// Something that the user should know, until it is put away.
    pub notice: RwSignal<Option<&'static str>>,
    pub(super) terminal: StoredValue<Terminal, LocalStorage>,
    /// As soon as the present controller has said what it holds.
    pub(super) wanted: StoredValue<Option<Wanted>>,
    /// Of each unit, shown or not; never none.
    scopes: StoredValue<Vec<Scope>, LocalStorage>,
    pub(super) client: StoredValue<Option<Client>, LocalStorage>,
    pub(super) health: StoredValue<Health>,
}

impl Store {
    /// Starts the simulator.
    pub fn start() -> Store {
        let store = Store::without_simulator();
        store.start_worker();
        store.look_after_worker();
        store
    }

    /// A page to which nobody tells anything.
    pub(crate) fn without_simulator() -> Store {
        let store = Store {
            device: RwSignal::default(),
            layout: RwSignal::default(),
            console: Console::default(),
            typing: RwSignal::new(false),
            pressing: RwSignal::new(false),
            editing: RwSignal::new(false),
            printed: RwSignal::new(0),
            wiring: RwSignal::new(Wiring::new(&KINDS[0])),
            chosen: RwSignal::new(0),
            recorded: RwSignal::new(0),
            editor: RwSignal::new(EditorState::new(&KINDS[0], KINDS[0].first_program)),
            asked: RwSignal::new(false),
            refusal: RwSignal::new(None),
            kept: RwSignal::new(None),
            cam: RwSignal::new(None),
            filed: RwSignal::new(None),
            project_name: RwSignal::new("My project".to_owned()),
            others: RwSignal::default(),
            terminal_settings: RwSignal::default(),
            settings: RwSignal::default(),
            paper: RwSignal::default(),
            printer: RwSignal::new(true),
            bus: RwSignal::default(),
            recording: RwSignal::new(None),
            strobes: RwSignal::new(0),
            notice: RwSignal::new(None),
            wanted: StoredValue::new(None),
            health: StoredValue::new(Health::default()),
            terminal: StoredValue::new_local(Terminal::default()),
            scopes: StoredValue::new_local(vec![Scope::default()]),
            client: StoredValue::new_local(None),
        };
        store.follow_breakpoints();
        store
    }

    /// Sends the worker what the user wants.
    pub fn send(&self, message: ToWorker) {
        self.before_sending(&message);
        if let ToWorker::Speed(speed) = message {
            self.device.update(|device| device.speed = speed);
        }
        if matches!(
            message,
            ToWorker::Wire { .. } | ToWorker::EmergencyStop(_) | ToWorker::Select(_)
        ) {
            self.wiring.update(|wiring| wiring.hear(&message));
        }
        if self.recording.with_untracked(Option::is_some) {
            let now = self.device.with_untracked(|device| device.now);
            self.recording
                .update(|kept| kept.iter_mut().for_each(|kept| kept.hear(now, &message)));
        }
        self.client.with_value(|client| {
            if let Some(client) = client {
                client.send(message);
            }
        });
    }

    /// Reads the terminal, which makes what it shows when it is asked.
    pub fn with_terminal<T>(&self, read: impl FnOnce(&mut Terminal) -> T) -> Option<T> {
        self.terminal.try_update_value(read)
    }

    /// Forgets what the terminal shows.
    pub fn clear_terminal(&self) {
        self.terminal.update_value(Terminal::clear);
        self.printed.update(|count| *count += 1);
    }

    /// What is printed next does not go on with what stands there.
    pub(super) fn start_on_new_line(&self) {
        self.terminal.update_value(Terminal::on_new_line);
    }

    /// Fits the terminal into so much room.
    pub fn resize_terminal(&self, columns: usize, rows: usize) {
        self.terminal
            .update_value(|terminal| terminal.resize(columns, rows));
        self.printed.update(|count| *count += 1);
    }

    /// Reads the scope of the selected unit.
    pub fn with_scope<T>(&self, read: impl FnOnce(&Scope) -> T) -> T {
        let unit = self.device.with_untracked(|device| device.unit);
        self.scopes.with_value(|scopes| match scopes.get(unit) {
            Some(scope) => read(scope),
            None => read(&Scope::default()),
        })
    }

    /// Does what the user wants of the scope of the selected unit.
    pub fn change_scope(&self, change: impl FnOnce(&mut Scope)) {
        let unit = self.device.with_untracked(|device| device.unit);
        self.scopes
            .update_value(|scopes| scopes.get_mut(unit).map(change).unwrap_or_default());
        self.redraw_scope();
    }

    /// Forgets all that was recorded and chosen.
    pub(super) fn clear_scopes(&self) {
        self.scopes.set_value(vec![Scope::default()]);
        self.redraw_scope();
    }

    fn redraw_scope(&self) {
        self.chosen.update(|count| *count += 1);
        self.recorded.update(|count| *count += 1);
    }

    /// A simulator has started.
    fn start_recording(&self, ready: &Ready) {
        self.scopes.update_value(|scopes| {
            scopes.resize_with(ready.units.max(1), Scope::default);
            let start = |scope: &mut Scope| scope.start(&ready.signals, ready.units);
            scopes.iter_mut().for_each(start);
        });
        self.redraw_scope();
    }

    /// Takes the samples of a frame; returns those of the unit that it tells of.
    fn record<'a>(&self, frame: &Frame, samples: &'a [f64], power_cycle: bool) -> &'a [f64] {
        let mut of_unit = &[][..];
        let mut rest = samples;
        for (unit, &part) in frame.parts.iter().enumerate() {
            let Some((samples, behind)) = rest.split_at_checked(part) else {
                break;
            };
            rest = behind;
            let changed = self.scopes.try_update_value(|scopes| {
                let scope = scopes.get_mut(unit)?;
                Some(scope.take(samples, power_cycle))
            });
            if unit == frame.unit {
                of_unit = samples;
                if changed.flatten() == Some(true) {
                    self.recorded.update(|count| *count += 1);
                }
            }
        }
        of_unit
    }

    /// The front panel is switched to another unit: what was known of the one before is not known of this one.
    fn hear_selected(&self, frame: &Frame) {
        if self.device.with_untracked(|device| device.unit) != frame.unit {
            self.device.update(|device| device.unit = frame.unit);
            self.editor.update(EditorState::forget_controller);
            self.refusal.set(None);
            self.redraw_scope();
        }
    }

    /// What leaves a controller that has a face: its strobe, and what a printer puts on paper, what the bus carries.
    fn hear_outputs(&self, frame: &Frame, samples: &[f64]) {
        let kind = untrack(|| self.kind());
        let strobed = kind.lamps.strobe.is_some_and(|strobe| {
            let column = |scope: &Scope| {
                let signals = scope.signals();
                let place = signals.iter().position(|signal| signal.name == strobe);
                place.map(|place| (place + 1, signals.len() + 1))
            };
            let column = self.with_scope(column);
            column.is_some_and(|(column, columns)| {
                let rows = samples.len() / columns;
                let column = samples.get(column * rows..(column + 1) * rows);
                column.is_some_and(|levels| levels.iter().any(|level| *level != 0.0))
            })
        });
        if strobed {
            self.strobes.update(|count| *count += 1);
        }
        if !frame.learnt.is_empty() {
            self.bus
                .update(|log| frame.learnt.iter().for_each(|report| log.learn(*report)));
        }
        let text = frame.received.as_ref().unwrap_or(&frame.console);
        if kind.face.is_some() && !text.is_empty() && self.printer.get_untracked() {
            self.paper.update(|paper| paper.print(text));
        }
    }

    /// What the simulator tells.
    pub(crate) fn hear(&self, news: &News) {
        let was_on = self.device.with_untracked(Device::is_on);
        match news {
            News::Ready(ready) => {
                self.start_recording(ready);
                self.wiring.update(|wiring| wiring.set_units(ready.units));
                let wiring = self.wiring.get_untracked();
                wiring.differences().into_iter().for_each(|m| self.send(m));
            }
            News::Frame(frame, samples) => {
                self.health.update_value(Health::heard);
                self.hear_selected(frame);
                if frame.status.power && !was_on {
                    self.start_on_new_line();
                }
                if !frame.console.is_empty() {
                    self.terminal
                        .update_value(|terminal| terminal.print(&frame.console));
                    self.printed.update(|count| *count += 1);
                } else {
                    // Now that all of the question has arrived.
                    let waits = frame.status.run == RunState::Waiting(Wait::Input);
                    self.terminal.update_value(|terminal| terminal.asks(waits));
                }
                let power_cycle = frame.status.power != was_on;
                let samples = self.record(frame, samples, power_cycle);
                self.hear_outputs(frame, samples);
                self.hear_of_program(frame);
                self.hear_console(frame);
            }
            News::Answer(answer) => self.hear_answer(answer),
            News::Fault(Fault::Died) => return self.revive(),
            News::Fault(_) => {}
        }
        self.device.update(|device| device.hear(news));
        if matches!(news, News::Frame(..)) {
            self.change_over();
        }
    }
}
