//! The editor's program and the controller's: what goes from one to the other, and when. Neither replaces the other
//! unasked.

use leptos::prelude::*;
use motionbench_core::controller::RunState;

use super::editor::{Agreement, EditorState};
use super::{Device, Store};
use crate::protocol::{Frame, FromWorker, ToWorker};

impl Store {
    /// Runs what the user works on: the editor's program, loaded first if the controller does not have it. If the
    /// controller has one of its own, the user is asked which.
    pub fn run(&self) {
        let agreement = self.editor.with_untracked(EditorState::agreement);
        match agreement {
            Agreement::Same => self.send(ToWorker::Run),
            Agreement::ControllerDiffers => self.asked.set(true),
            Agreement::Unknown | Agreement::NotLoaded | Agreement::EditorChanged => {
                self.load_program(true);
            }
        }
    }

    /// Runs the controller's own program.
    pub fn run_controllers(&self) {
        self.asked.set(false);
        self.send(ToWorker::Run);
    }

    /// Puts the editor's program into the controller.
    pub fn load_program(&self, start: bool) {
        self.asked.set(false);
        let sent = self.editor.try_update(|editor| {
            let lines = editor.send();
            (lines, editor.text().to_owned())
        });
        if let Some((lines, text)) = sent {
            self.send(ToWorker::Breakpoints(lines));
            self.send(ToWorker::Load { text, start });
        }
    }

    /// Puts the controller's program into the editor.
    pub fn take_program(&self) {
        self.asked.set(false);
        let listing = self
            .editor
            .with_untracked(|editor| editor.listing().map(str::to_owned));
        if let Some(listing) = listing {
            self.editor.update(|editor| editor.take(&listing));
        }
    }

    /// Stops simulated time and the program, or lets them go on.
    pub fn freeze(&self) {
        let frozen = self.device.with_untracked(|device| device.frozen);
        self.send(ToWorker::Freeze(!frozen));
    }

    /// Runs one statement.
    pub fn step(&self) {
        self.send(ToWorker::Step);
    }

    /// Keeps the controller's breakpoints as the editor's are.
    pub(super) fn follow_breakpoints(self) {
        let lines = Memo::new(move |_| self.editor.with(EditorState::breakpoints_as_device_lines));
        Effect::new(move |before: Option<Vec<u32>>| {
            let lines = lines.get();
            if before.as_ref().is_some_and(|before| *before != lines) {
                self.send(ToWorker::Breakpoints(lines.clone()));
            }
            lines
        });
    }

    /// What a frame tells of the controller's program.
    pub(super) fn hear_of_program(&self, frame: &Frame) {
        let status = &frame.status;
        let line = (status.run != RunState::Idle)
            .then_some(status.line)
            .flatten();
        let known = self
            .editor
            .with_untracked(|editor| editor.hears_nothing_new(status.revision, line));
        if known {
            return;
        }
        let wanted = self.editor.try_update(|editor| {
            editor.set_running(line);
            editor.heard_revision(status.revision)
        });
        if wanted == Some(true) {
            self.send(ToWorker::Take);
        }
    }

    /// What the worker answered.
    pub(super) fn hear_answer(&self, answer: &FromWorker) {
        match answer {
            FromWorker::Loaded(Ok(revision)) => {
                self.refusal.set(None);
                self.editor.update(|editor| editor.loaded(revision.clone()));
            }
            FromWorker::Loaded(Err(refused)) => {
                self.editor.update(EditorState::refused);
                self.refusal.set(Some(refused.clone()));
            }
            FromWorker::Listing { text, revision } => {
                self.editor
                    .update(|editor| editor.heard_listing(*revision, text));
            }
            FromWorker::Kept(memory) => self.kept.set(Some(memory.clone())),
            FromWorker::Cam(table) => self.cam.set(table.clone()),
            FromWorker::Filed(filed) => self.filed.set(Some(filed.clone())),
            FromWorker::Ready(_) | FromWorker::Frame(_) => {}
        }
    }

    /// Whether the program is held at a line.
    pub fn is_held(&self) -> bool {
        self.device.with(|device: &Device| {
            device.frozen
                && device
                    .status
                    .as_ref()
                    .is_some_and(|status| status.run == RunState::Paused)
        })
    }
}
