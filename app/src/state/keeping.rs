//! What the browser keeps of the page's state, and what comes back from there.

use leptos::prelude::*;
use leptos::reactive::spawn_local_scoped;

use super::Store;
use super::project::{Desk, Project, Work};
use crate::clock;
use crate::protocol::ToWorker;
use crate::storage::Keeper;

/// The controller is asked what it holds this often, ms, while something happens in it.
const ASK_MS: u32 = 500;

impl Store {
    /// Gets the kept project, if there is one, and keeps what happens from then on.
    pub fn keep(self, keeper: Keeper) {
        // Scoped, because effects live as long as what owns them.
        spawn_local_scoped(async move {
            if let Some(project) = keeper.open().await {
                self.put_back(project);
            }
            keeper.watch(move || self.work(), &self.held());
            self.watch_work(keeper);
            self.watch_device(keeper);
        });
    }

    /// The project as it is now.
    pub fn project(self) -> Project {
        Project {
            work: self.work(),
            device: self.held(),
        }
    }

    /// Puts a project into a page that has just been opened.
    fn put_back(self, project: Project) {
        let Project { work, device } = project;
        self.project_name.set(work.name);
        self.layout.set(work.layout);
        self.others.set(work.others);
        self.device.update(|device| device.speed = work.speed);
        self.put_on_bench(Desk {
            text: work.text,
            breakpoints: work.breakpoints,
            line: work.line,
            terminal: work.terminal,
            settings: work.settings,
            device,
        });
    }

    fn work(self) -> Work {
        let Desk {
            text,
            breakpoints,
            line,
            terminal,
            settings,
            ..
        } = self.desk();
        Work {
            name: self.project_name.get_untracked(),
            text,
            breakpoints,
            line,
            terminal,
            settings,
            speed: self.device.with_untracked(|device| device.speed),
            layout: self.layout.get_untracked(),
            others: self.others.get_untracked(),
        }
    }

    /// The editor, the layout and the settings.
    fn watch_work(self, keeper: Keeper) {
        let settings = Memo::new(move |_| self.device.with(|device| (device.speed, device.line)));
        let text = Memo::new(move |_| {
            self.editor
                .with(|editor| (editor.text().to_owned(), editor.breakpoints()))
        });
        Effect::new(move |before: Option<()>| {
            // Read, not only tracked: a memo that nobody reads is not computed, and so tells of nothing.
            settings.with(|_| ());
            text.with(|_| ());
            self.layout.track();
            self.project_name.track();
            self.others.track();
            self.terminal_settings.track();
            self.settings.track();
            if before.is_some() {
                keeper.work_changed();
            }
        });
    }

    /// What the controller holds.
    fn watch_device(self, keeper: Keeper) {
        let mut asked = None;
        clock::every(ASK_MS, move || {
            let now = self.device.with_untracked(|device| {
                let status = device.status.as_ref();
                status.map(|status| (device.work, status.power))
            });
            if now.is_some() && now != asked {
                asked = now;
                self.send(ToWorker::Keep);
            }
        });
        let power = Memo::new(move |_| {
            self.device
                .with(|device| device.status.as_ref().map(|status| status.power))
        });
        Effect::new(move |before: Option<()>| {
            power.with(|_| ());
            self.kept.track();
            if before.is_some() {
                keeper.device_changed(&self.held());
            }
        });
    }
}
