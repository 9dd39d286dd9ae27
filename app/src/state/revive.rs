//! A simulator that dies is replaced: program, files and switches come back, and the user is told.

use leptos::prelude::*;

use super::editor::EditorState;
use super::front;
use super::{Fault, Store};
use crate::client::Client;
use crate::clock;
use crate::protocol::{ToWorker, bench_name};

/// Looks for a sign of life this often, ms. A worker that stands idle sends ten frames a second.
const LOOK_MS: u32 = 1000;
/// So many looks without a sign, and it is dead. Browsers slow down hidden pages: those are not looked at.
const SILENT_LOOKS: u32 = 5;
/// A simulator that dies so often is given up.
const MOST_DEATHS: u32 = 3;
/// Looks with signs of life after which earlier deaths are forgotten.
const FORGIVEN_LOOKS: u32 = 30;

/// What is known of the worker's health.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Health {
    /// Frames heard.
    frames: u64,
    seen: u64,
    silent: u32,
    lively: u32,
    deaths: u32,
}

impl Health {
    /// A frame came.
    pub(super) fn heard(&mut self) {
        self.frames += 1;
    }

    /// One look; whether the worker is dead.
    fn look(&mut self) -> bool {
        let lives = self.frames != self.seen;
        self.seen = self.frames;
        if lives {
            self.silent = 0;
            self.lively += 1;
            if self.lively >= FORGIVEN_LOOKS {
                self.deaths = 0;
            }
        } else if self.frames > 0 {
            self.silent += 1;
        }
        self.silent >= SILENT_LOOKS
    }

    /// It has died; whether another is worth a try.
    fn died(&mut self) -> bool {
        (self.silent, self.lively) = (0, 0);
        self.deaths += 1;
        self.deaths <= MOST_DEATHS
    }
}

impl Store {
    /// Looks after the worker for as long as the page lives.
    pub(super) fn look_after_worker(self) {
        clock::every(LOOK_MS, move || {
            let hidden = document().hidden();
            let dead = self
                .health
                .try_update_value(|health| !hidden && health.look());
            if dead == Some(true) {
                self.revive();
            }
        });
    }

    /// Starts another worker in place of a dead one, with all that the last one is known to have held.
    pub(super) fn revive(self) {
        if self.health.try_update_value(Health::died) != Some(true) {
            self.device
                .update(|device| device.fault = Some(Fault::Died));
            return;
        }
        self.start_again();
        self.notice.set(Some(
            "The simulator has failed and was started again. Programs and files are back; what ran has stopped.",
        ));
    }

    /// Starts another worker, with all that the last one is known to have held.
    pub(super) fn start_again(self) {
        let on = self
            .device
            .with_untracked(|device| device.status.as_ref().is_none_or(|status| status.power));
        self.start_worker();
        // Dark until the other one shows something.
        self.device.update(|device| device.panel = None);
        self.editor.update(EditorState::forget_controller);
        self.start_on_new_line();
        let line = self.device.with_untracked(|device| device.line);
        self.equip_worker(on, line, self.terminal_settings.get_untracked());
    }

    /// Starts a worker; the one before it, if any, ends.
    pub(super) fn start_worker(self) {
        let options = self.settings.with_untracked(front::options);
        let name = bench_name(untrack(|| self.kind().id), &options);
        let client = Client::start(&name, move |news| self.hear(&news));
        let before = self.client.try_update_value(|held| held.replace(client));
        if let Some(Some(before)) = before {
            before.end();
        }
        self.send(ToWorker::Terminal(untrack(|| self.terminal_settings())));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn silence_is_death_only_after_it_has_lived() {
        let mut health = Health::default();
        assert!((0..100).all(|_| !health.look()), "still starting");
        health.heard();
        assert!(!health.look());
        assert!((1..SILENT_LOOKS).all(|_| !health.look()));
        assert!(health.look());
    }

    #[test]
    fn one_that_dies_again_and_again_is_given_up() {
        let mut health = Health::default();
        assert!((0..MOST_DEATHS).all(|_| health.died()));
        assert!(!health.died());
        for _ in 0..FORGIVEN_LOOKS {
            health.heard();
            health.look();
        }
        assert!(health.died());
    }
}
