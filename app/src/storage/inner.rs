//! What a keeper knows, and what follows from it; it waits for nothing.

use std::future::Future;
use std::pin::Pin;
use std::rc::Rc;

use crate::clock::Timer;
use js_sys::Function;
use leptos::wasm_bindgen::JsValue;

use super::database::{Changes, Contents, Database};
use super::{Fault, Keeping};
use crate::state::order::sort_few;
use crate::state::project::{Device, LARGEST, Project, Work, kept, kept_device};
use crate::state::versions::{Reason, Version, is_due, thin};

/// What comes of a write that the browser has been given.
pub(super) type Written = Pin<Box<dyn Future<Output = Result<(), Fault>>>>;
/// An open database with what is in it.
pub(super) type Read = Result<(Rc<Database>, Contents), Fault>;

/// Who may write the project.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Access {
    NotKnown,
    ThisPage,
    AnotherTab,
    /// That tab has gone, perhaps after it wrote what this page does not know.
    Nobody,
}

/// What has come of an attempt to save.
pub(super) enum Save {
    /// There is nothing to be saved.
    Nothing,
    /// What there is cannot be saved.
    TooLarge,
    /// The browser has it.
    Begun(Written),
    /// The database must be opened again first.
    NoDatabase,
}

/// What a keeper knows.
pub(super) struct Inner {
    /// Of the database.
    pub(super) name: &'static str,
    /// Lets go of the project's lock.
    pub(super) release: Option<Function>,
    /// The next save, or attempt at one: none before it.
    pub(super) timer: Option<Timer>,
    access: Access,
    database: Option<Rc<Database>>,
    work: Option<Box<dyn Fn() -> Work>>,
    /// The device's part of the text.
    device: String,
    versions: Vec<Version>,
    /// What was kept before this page wrote, until it is safe as a version to go back to.
    before: Option<(Version, String)>,
    /// What was kept and cannot be read.
    unreadable: Option<String>,
    /// There are changes that no write has begun for.
    dirty: bool,
    /// Writes that have begun and not ended.
    writing: u32,
    fault: Option<Fault>,
    kept_at_ms: Option<f64>,
}

/// Opens the database and reads it.
pub(super) async fn read(name: &str) -> Read {
    let database = Rc::new(Database::open(name).await?);
    let contents = database.read().await?;
    Ok((database, contents))
}

impl Inner {
    pub(super) fn new(name: &'static str) -> Inner {
        Inner {
            name,
            release: None,
            timer: None,
            access: Access::NotKnown,
            database: None,
            work: None,
            device: String::new(),
            versions: Vec::new(),
            before: None,
            unreadable: None,
            dirty: false,
            writing: 0,
            fault: None,
            kept_at_ms: None,
        }
    }

    /// Takes in what was found when the page started; gives the project.
    pub(super) fn opened(&mut self, writes: bool, read: Read, now_ms: f64) -> Option<Project> {
        self.access = if writes {
            Access::ThisPage
        } else {
            Access::AnotherTab
        };
        let text = self.take(read)?;
        match Project::read(&text) {
            Ok(project) => {
                self.before = Some((by_time(now_ms), text));
                Some(project)
            }
            Err(error) => {
                self.fault = Some(Fault::Unreadable(error));
                self.unreadable = Some(text);
                None
            }
        }
    }

    /// Takes in what was found later. What this page has never read must not be lost by what it writes.
    pub(super) fn reopened(&mut self, read: Read, now_ms: f64) {
        let seen = self.kept_at_ms.is_some() || self.before.is_some();
        let text = self.take(read);
        if !seen {
            self.before = text.map(|text| (by_time(now_ms), text));
        }
    }

    fn take(&mut self, read: Read) -> Option<String> {
        match read {
            Ok((database, contents)) => {
                self.database = Some(database);
                self.versions = contents.versions;
                contents.present
            }
            Err(fault) => {
                self.fault = Some(fault);
                None
            }
        }
    }

    /// The tab that had the project has let go of it. Whether this page may write now: what is kept is what it has read.
    pub(super) fn inherit(&mut self, read: Read) -> bool {
        let known = self.before.as_ref().map(|(_, text)| text.clone());
        let text = self.take(read);
        if self.database.is_some() && text == known && self.unreadable.is_none() {
            self.access = Access::ThisPage;
            return true;
        }
        self.access = Access::Nobody;
        self.let_go();
        false
    }

    pub(super) fn watch(&mut self, work: Box<dyn Fn() -> Work>, device: &Device) {
        self.work = Some(work);
        self.set_device(device);
    }

    pub(super) fn set_device(&mut self, device: &Device) {
        self.device = kept_device(device);
    }

    /// Something has changed; whether it is to be saved at once.
    pub(super) fn change(&mut self) -> bool {
        if self.access != Access::ThisPage || self.work.is_none() || self.unreadable.is_some() {
            return false;
        }
        self.dirty = true;
        self.timer.is_none()
    }

    pub(super) fn is_dirty(&self) -> bool {
        self.dirty
    }

    pub(super) fn database(&self) -> Option<Rc<Database>> {
        self.database.clone()
    }

    /// What can be gone back to, the newest first.
    pub(super) fn versions(&self) -> Vec<Version> {
        let mut versions = self.versions.clone();
        sort_few(&mut versions, |a, b| a.at_ms > b.at_ms);
        versions
    }

    /// What is true for the user.
    pub(super) fn state(&self) -> Keeping {
        match (self.access, &self.fault) {
            (Access::NotKnown, _) => Keeping::Opening,
            (Access::AnotherTab, _) => Keeping::ReadOnly,
            (Access::Nobody, _) => Keeping::Freed,
            (Access::ThisPage, Some(fault)) => Keeping::Failed(fault.clone()),
            (Access::ThisPage, None) if self.dirty || self.writing > 0 => Keeping::Changed,
            (Access::ThisPage, None) => self.kept_at_ms.map_or(Keeping::Unchanged, Keeping::Kept),
        }
    }

    /// Gives the browser what has changed.
    pub(super) fn save(&mut self, now_ms: f64) -> Save {
        self.timer = None;
        let Some(text) = self.dirty.then(|| self.text()).flatten() else {
            return Save::Nothing;
        };
        if text.len() > LARGEST {
            self.fault = Some(Fault::TooLarge);
            // Not again before there is another change.
            self.dirty = false;
            return Save::TooLarge;
        }
        let Some(database) = self.database.clone() else {
            return Save::NoDatabase;
        };
        let version = match self.before.clone() {
            Some(before) => Some(before),
            None if is_due(&self.versions, now_ms) => Some((by_time(now_ms), text.clone())),
            None => None,
        };
        let dropped = self.add_version(version.as_ref().map(|(version, _)| *version));
        self.dirty = false;
        self.writing += 1;
        Save::Begun(Box::pin(
            database.write(&Changes {
                present: Some(&text),
                version: version
                    .as_ref()
                    .map(|(version, text)| (*version, text.as_str())),
                dropped: &dropped,
            }),
        ))
    }

    /// Takes in what came of a save that began at `now_ms`.
    pub(super) fn saved(&mut self, result: Result<(), Fault>, now_ms: f64) {
        self.writing -= 1;
        match result {
            Ok(()) => {
                self.fault = None;
                self.before = None;
                self.kept_at_ms = Some(now_ms);
            }
            Err(fault) => {
                self.fault = Some(fault);
                self.dirty = true;
                // It may be this connection that has failed.
                self.database = None;
            }
        }
    }

    /// Gives the browser a version to go back to: what the page has, or what it could not read; and what takes its place.
    pub(super) fn back_up(
        &mut self,
        reason: Reason,
        next: Option<&str>,
        now_ms: f64,
    ) -> Result<Written, Fault> {
        if self.access != Access::ThisPage {
            return Err(Fault::Elsewhere);
        }
        let (reason, text) = match self.unreadable.clone() {
            Some(text) => (Reason::Unreadable, Some(text)),
            None => (reason, self.text()),
        };
        let (Some(text), Some(database)) = (text, self.database.clone()) else {
            return Err(self.fault.clone().unwrap_or(Fault::Closed));
        };
        let version = Version {
            at_ms: now_ms,
            reason,
        };
        let dropped = self.add_version(Some(version));
        Ok(Box::pin(database.write(&Changes {
            present: next,
            version: Some((version, &text)),
            dropped: &dropped,
        })))
    }

    /// Keeps nothing more of what this page has.
    pub(super) fn stop(&mut self) {
        self.work = None;
        self.dirty = false;
        self.timer = None;
    }

    /// Forgets what cannot be read, so that what the page has may take its place.
    pub(super) fn start_over(&mut self) {
        self.unreadable = None;
        self.fault = None;
    }

    pub(super) fn close(&mut self) {
        self.access = Access::Nobody;
        self.database = None;
        self.let_go();
    }

    /// Lets another tab have the project.
    fn let_go(&mut self) {
        if let Some(release) = self.release.take() {
            // A function of the browser that takes anything.
            let _ = release.call0(&JsValue::NULL);
        }
    }

    fn text(&self) -> Option<String> {
        Some(kept(&self.work.as_ref()?(), &self.device))
    }

    /// Adds a version, and gives those that are too many then.
    fn add_version(&mut self, version: Option<Version>) -> Vec<Version> {
        let new = version.filter(|version| !self.versions.contains(version));
        self.versions.extend(new);
        thin(&mut self.versions)
    }
}

fn by_time(at_ms: f64) -> Version {
    Version {
        at_ms,
        reason: Reason::Time,
    }
}
