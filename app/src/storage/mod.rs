//! Kept work: the project is in the browser's database as soon as it has changed, and comes back from there.
//!
//! [`Keeper`] is what the page talks to. `crate::state::project` says what is kept, `crate::state::versions` what can be
//! gone back to.

mod database;
pub mod files;
mod inner;
mod words;

use js_sys::{Promise, Reflect};
use leptos::prelude::*;

use leptos::wasm_bindgen::prelude::*;
use wasm_bindgen_futures::{JsFuture, spawn_local};
use web_sys::{StorageManager, VisibilityState};

use crate::clock;
use crate::locks::{self, Mode};
use crate::state::project::{Device, Project, ProjectError, Work, kept, kept_device};
use crate::state::versions::{Reason, Version};
use inner::{Inner, Save};

/// A change is written at once, for a page that goes may have no time left. What changes within this time of that, ms,
/// is written together after it.
const PAUSE_MS: f64 = 50.0;
/// A project that is large is written less often: the pause is so many times as long as the page was busy with it, and
/// no longer than `LONGEST_PAUSE_MS`.
const PAUSES: f64 = 10.0;
const LONGEST_PAUSE_MS: f64 = 400.0;
/// When it could not be written, it is tried again, ms.
const RETRY_MS: u32 = 5000;
/// A page that is loaded again may wait this long for the page before it to let go of the project, ms.
const HANDOVER_MS: u32 = 500;

/// Whether the user's work is kept.
#[derive(Debug, Clone, PartialEq)]
pub enum Keeping {
    /// It is being looked for.
    Opening,
    /// Nothing has changed since it was kept.
    Unchanged,
    /// It will be kept in a moment.
    Changed,
    /// It was kept then, in ms since 1970.
    Kept(f64),
    /// Another tab has the project: it is not kept here.
    ReadOnly,
    /// The tab that had it has gone: a reload gets it.
    Freed,
    /// It is not kept.
    Failed(Fault),
}

/// Why work is not kept.
#[derive(Debug, Clone, PartialEq)]
pub enum Fault {
    /// The browser does not let the page store anything.
    Refused,
    /// The browser has given the page no more room.
    Full,
    /// The project is larger than [`crate::state::project::LARGEST`].
    TooLarge,
    /// What is kept cannot be read by this page, and stays as it is.
    Unreadable(ProjectError),
    /// The browser has closed its database.
    Closed,
    /// Another tab has the project.
    Elsewhere,
    /// There is no such version any more.
    Gone,
}

/// What the browser says of how long it keeps the work.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Persistence {
    /// It has not been asked.
    Unasked,
    /// Until the user deletes it.
    UntilDeleted,
    /// Until the browser runs out of room.
    WhileThereIsRoom,
}

/// Keeps the project. A handle: copies are of the same.
#[derive(Clone, Copy)]
pub struct Keeper {
    /// Whether the work is kept.
    pub state: RwSignal<Keeping>,
    /// How long.
    pub persistence: RwSignal<Persistence>,
    inner: StoredValue<Inner, LocalStorage>,
}

impl Keeper {
    /// A keeper that has not looked yet. `name` is that of the browser's database: [`Keeper::DATABASE`] but in tests.
    pub fn new(name: &'static str) -> Keeper {
        Keeper {
            state: RwSignal::new(Keeping::Opening),
            persistence: RwSignal::new(Persistence::Unasked),
            inner: StoredValue::new_local(Inner::new(name)),
        }
    }

    /// Where projects are kept.
    pub const DATABASE: &'static str = "motionbench";

    /// Gets the project that was kept. Without one, or with a fault, the page goes on with a new one; [`Keeper::state`]
    /// says which.
    pub async fn open(self) -> Option<Project> {
        let writes = self.take_lock().await;
        let name = self.inner.with_value(|inner| inner.name);
        let read = inner::read(name).await;
        let project = self
            .inner
            .try_update_value(|inner| inner.opened(writes, read, clock::now_ms()))
            .flatten();
        self.show();
        if writes {
            self.listen();
        }
        project
    }

    /// Where to get what the user does in the page, from now on, when it is to be written; and what the device holds now.
    pub fn watch(self, work: impl Fn() -> Work + 'static, device: &Device) {
        self.inner
            .update_value(|inner| inner.watch(Box::new(work), device));
    }

    /// Something that [`Keeper::watch`] gets has changed.
    pub fn work_changed(self) {
        self.change(|_| {});
    }

    /// The device holds something else.
    pub fn device_changed(self, device: &Device) {
        self.change(|inner| inner.set_device(device));
    }

    /// Whether the project may be edited here: not if another tab has it.
    pub fn is_read_only(self) -> bool {
        matches!(self.state.get(), Keeping::ReadOnly | Keeping::Freed)
    }

    /// Writes now what has changed. The browser has it when this returns.
    pub fn flush(self) {
        if self.inner.with_value(Inner::is_dirty) {
            self.save();
        }
    }

    /// Keeps the project as it is, as a version to go back to, before much of it is changed.
    ///
    /// # Errors
    /// [`Fault`]; it should not be changed then.
    pub async fn back_up(self, reason: Reason) -> Result<(), Fault> {
        self.put_away(reason, None).await
    }

    /// Puts another project in place of the present one, which becomes a version to go back to. The page has the other
    /// one when it is loaded again, and must be: it keeps nothing more.
    ///
    /// # Errors
    /// [`Fault`]; the present project is where it was then.
    pub async fn replace(self, project: &Project, reason: Reason) -> Result<(), Fault> {
        let text = kept(&project.work, &kept_device(&project.device));
        self.put_away(reason, Some(&text)).await?;
        self.inner.update_value(Inner::stop);
        Ok(())
    }

    async fn put_away(self, reason: Reason, next: Option<&str>) -> Result<(), Fault> {
        let now = clock::now_ms();
        let begun = self
            .inner
            .try_update_value(|inner| inner.back_up(reason, next, now));
        begun.unwrap_or(Err(Fault::Closed))?.await
    }

    /// Puts a project that cannot be read by this page among the versions, as it is, and starts to keep the one that the
    /// page has.
    ///
    /// # Errors
    /// [`Fault`]; the unreadable one is where it was then.
    pub async fn start_over(self) -> Result<(), Fault> {
        self.back_up(Reason::Unreadable).await?;
        self.change(Inner::start_over);
        Ok(())
    }

    /// What can be gone back to, the newest first.
    pub fn versions(self) -> Vec<Version> {
        self.inner.with_value(Inner::versions)
    }

    /// The text of an earlier version, which [`Project::read`] reads.
    ///
    /// # Errors
    /// [`Fault`] if it is not to be had.
    pub async fn version(self, version: Version) -> Result<String, Fault> {
        let database = self
            .inner
            .with_value(Inner::database)
            .ok_or(Fault::Closed)?;
        database.version(version).await
    }

    /// Writes what has changed, and lets another tab have the project.
    pub fn close(self) {
        self.flush();
        self.inner.update_value(Inner::close);
    }

    /// Asks for the project's lock; whether this page may write.
    async fn take_lock(self) -> bool {
        match self.ask_lock(Mode::IfFree) {
            // A browser without locks cannot say whether there is another tab.
            None => true,
            Some(answer) => {
                is_granted(answer).await || {
                    // Waited for in any case: a tab may be closed much later.
                    let answer = self.ask_lock(Mode::Exclusive).map(is_granted);
                    let answer = async { answer?.await.then_some(()) };
                    clock::within(HANDOVER_MS, answer).await.flatten().is_some()
                }
            }
        }
    }

    /// The answer to come, where the browser has locks.
    fn ask_lock(self, mode: Mode) -> Option<Promise> {
        let name = self
            .inner
            .with_value(|inner| format!("{} project", inner.name));
        let mut has_locks = false;
        let answer = Promise::new(&mut |resolve, _| {
            let answered = move |granted: bool| {
                // A function of the browser that takes anything.
                let _ = resolve.call1(&JsValue::NULL, &granted.into());
                self.answered(granted)
            };
            has_locks = locks::request(&name, mode, answered);
        });
        has_locks.then_some(answer)
    }

    /// Until when the lock is held.
    fn answered(self, granted: bool) -> Promise {
        if !granted {
            return Promise::resolve(&JsValue::NULL);
        }
        if self.state.get_untracked() != Keeping::Opening {
            spawn_local(self.inherit());
        }
        let mut release = None;
        let held = Promise::new(&mut |resolve, _| release = Some(resolve));
        self.inner.update_value(|inner| inner.release = release);
        held
    }

    /// The tab that had the project has gone. This page goes on with it, unless it has missed something.
    async fn inherit(self) {
        let read = inner::read(self.inner.with_value(|inner| inner.name)).await;
        let writes = self.inner.try_update_value(|inner| inner.inherit(read));
        self.show();
        if writes == Some(true) {
            self.listen();
            self.work_changed();
        }
    }

    /// Writes before the page goes or is put aside, after which it may never be called again.
    fn listen(self) {
        let leave = Closure::<dyn Fn()>::new(move || self.flush());
        let hide = Closure::<dyn Fn()>::new(move || {
            if document().visibility_state() == VisibilityState::Hidden {
                self.flush();
            }
        });
        // Window and document take any listener.
        let leave = leave.into_js_value();
        let _ = window().add_event_listener_with_callback("pagehide", leave.unchecked_ref());
        let hide = hide.into_js_value();
        let _ =
            document().add_event_listener_with_callback("visibilitychange", hide.unchecked_ref());
    }

    fn change(self, change: impl FnOnce(&mut Inner)) {
        let at_once = self.inner.try_update_value(|inner| {
            change(inner);
            inner.change()
        });
        if at_once == Some(true) {
            self.save();
        }
        self.show();
    }

    fn save_in(self, ms: u32) {
        let timer = clock::after(ms, move || self.save());
        self.inner.update_value(|inner| inner.timer = Some(timer));
    }

    fn save(self) {
        let now = clock::now_ms();
        let Some(begun) = self.inner.try_update_value(|inner| inner.save(now)) else {
            return;
        };
        if !matches!(begun, Save::Nothing) {
            let pause = PAUSES * (clock::now_ms() - now);
            // Within its bounds it is a whole number.
            self.save_in(pause.clamp(PAUSE_MS, LONGEST_PAUSE_MS) as u32);
        }
        match begun {
            Save::Begun(written) => spawn_local(async move {
                let result = written.await;
                self.saved(result, now).await;
            }),
            Save::NoDatabase => spawn_local(self.reopen()),
            Save::Nothing | Save::TooLarge => {}
        }
        self.show();
    }

    /// Takes in what came of it.
    async fn saved(self, result: Result<(), Fault>, now: f64) {
        let failed = result.is_err();
        self.inner.update_value(|inner| inner.saved(result, now));
        self.show();
        if failed {
            self.save_in(RETRY_MS);
        } else if self.persistence.get_untracked() == Persistence::Unasked && is_used() {
            self.persistence.set(persist().await);
        }
    }

    async fn reopen(self) {
        let read = inner::read(self.inner.with_value(|inner| inner.name)).await;
        let open = read.is_ok();
        self.inner
            .update_value(|inner| inner.reopened(read, clock::now_ms()));
        self.show();
        if open {
            self.save();
        } else {
            self.save_in(RETRY_MS);
        }
    }

    fn show(self) {
        let state = self.inner.with_value(Inner::state);
        if self.state.get_untracked() != state {
            self.state.set(state);
        }
    }
}

async fn is_granted(answer: Promise) -> bool {
    JsFuture::from(answer)
        .await
        .is_ok_and(|granted| granted.is_truthy())
}

/// Whether the user has done anything in the page: some browsers ask the user before they promise.
fn is_used() -> bool {
    let get = |object: &JsValue, name: &str| Reflect::get(object, &name.into()).ok();
    let activation = get(&window().navigator(), "userActivation").filter(JsValue::is_object);
    // Older browsers do not tell.
    activation.is_none_or(|activation| {
        get(&activation, "hasBeenActive").is_none_or(|active| active.is_truthy())
    })
}

/// Asks the browser to keep the work until the user deletes it.
async fn persist() -> Persistence {
    let manager = Reflect::get(&window().navigator(), &"storage".into());
    let manager = manager
        .ok()
        .and_then(|manager| manager.dyn_into::<StorageManager>().ok());
    let promise = manager.and_then(|manager| manager.persist().ok());
    let kept = match promise {
        Some(promise) => JsFuture::from(promise)
            .await
            .is_ok_and(|kept| kept.is_truthy()),
        None => false,
    };
    if kept {
        Persistence::UntilDeleted
    } else {
        Persistence::WhileThereIsRoom
    }
}
