//! The page without a network: the service worker that keeps its files, and the way to a newer version.
//!
//! `app/service-worker/service-worker.js` is the other side. A site that is built for development has neither.

use js_sys::Promise;
use leptos::prelude::*;

use leptos::wasm_bindgen::prelude::*;
use wasm_bindgen_futures::{JsFuture, spawn_local};
use web_sys::{
    AddEventListenerOptions, RegistrationOptions, ServiceWorker, ServiceWorkerContainer,
    ServiceWorkerRegistration, ServiceWorkerUpdateViaCache, Url,
};

use crate::{clock, locks};

/// Beside the page.
const SCRIPT: &str = "./sw.js";
/// What the page carries until the site is published.
const DEVELOPMENT: &str = "development";
/// An installed page may stay open for days, ms.
const LOOK_AGAIN_MS: u32 = 60 * 60 * 1000;

/// Whether the page works without a network.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Offline {
    /// Not here: a site under development, a browser that has it switched off, plain http from another machine.
    Unavailable,
    /// The files are being fetched.
    Preparing,
    /// All files are kept.
    Ready,
    /// So are those of a newer version, which is used when the user wants it.
    NewVersion,
    /// The files could not be fetched; the next visit tries again.
    Failed,
}

impl Offline {
    /// For the status line.
    pub fn words(self) -> &'static str {
        match self {
            Offline::Unavailable => "needs the network",
            Offline::Preparing => "getting ready for offline use",
            Offline::Ready => "works offline",
            Offline::NewVersion => "works offline, newer version ready",
            Offline::Failed => "not ready for offline use",
        }
    }
}

/// The page's version; `None` under development.
pub fn version() -> Option<String> {
    let page = document().document_element()?;
    page.get_attribute("data-version")
        .filter(|version| version != DEVELOPMENT)
}

/// The address of a file that this version of the page has for itself alone, so that it also finds it when a newer
/// version has been put on the server.
pub fn own_address(file: &str) -> String {
    match version() {
        Some(version) => format!("./{version}/{file}"),
        None => format!("./{file}"),
    }
}

/// Keeps the page for offline use and tells of newer versions. A handle: copies are of the same.
#[derive(Clone, Copy)]
pub struct Updates {
    /// How far it is.
    pub state: RwSignal<Offline>,
    registration: StoredValue<Option<ServiceWorkerRegistration>, LocalStorage>,
    /// The user wants the newer version.
    accepted: StoredValue<bool>,
    /// Another page has changed over; this one goes on in its own version.
    left_behind: StoredValue<bool>,
}

impl Updates {
    /// Starts to keep the page's files, where that can be.
    pub fn start() -> Updates {
        let updates = Updates {
            state: RwSignal::new(Offline::Unavailable),
            registration: StoredValue::new_local(None),
            accepted: StoredValue::new(false),
            left_behind: StoredValue::new(false),
        };
        if let (Some(version), Some(container)) = (version(), container()) {
            hold(&version);
            updates.state.set(Offline::Preparing);
            spawn_local(async move {
                loaded().await;
                updates.register(&container).await;
            });
        }
        updates
    }

    /// Changes over to the newer version: the page is loaded again.
    pub fn accept(&self) {
        self.accepted.set_value(true);
        let waiting = self
            .registration
            .with_value(|registration| registration.as_ref()?.waiting());
        match waiting {
            // It takes over, which reloads the page.
            Some(newer) => post(&newer, "accept"),
            // Another page was first.
            None => reload(),
        }
    }

    async fn register(self, container: &ServiceWorkerContainer) {
        self.listen(container);
        let options = RegistrationOptions::new();
        options.set_update_via_cache(ServiceWorkerUpdateViaCache::None);
        let registered = JsFuture::from(container.register_with_options(SCRIPT, &options)).await;
        let registration = registered.and_then(JsCast::dyn_into::<ServiceWorkerRegistration>);
        let Ok(registration) = registration else {
            self.state.set(Offline::Failed);
            return;
        };
        if let Some(active) = registration.active() {
            post(&active, "tidy");
        }
        let found = Closure::<dyn Fn()>::new(move || self.look());
        registration.set_onupdatefound(Some(found.into_js_value().unchecked_ref()));
        self.registration.set_value(Some(registration.clone()));
        self.look();
        clock::every(LOOK_AGAIN_MS, move || {
            if let Ok(update) = registration.update() {
                // Without a network there is none.
                spawn_local(async move { drop(JsFuture::from(update).await) });
            }
        });
    }

    /// Listens for a service worker that takes over.
    fn listen(self, container: &ServiceWorkerContainer) {
        // On a first visit the page comes before its service worker.
        let mut first = container.controller().is_none();
        let taken_over = Closure::<dyn FnMut()>::new(move || {
            if self.accepted.get_value() {
                reload();
            } else if !std::mem::take(&mut first) {
                self.left_behind.set_value(true);
                self.look();
            }
        });
        container.set_oncontrollerchange(Some(taken_over.into_js_value().unchecked_ref()));
    }

    /// Looks how far it is, and again when that changes.
    fn look(self) {
        let state = self.registration.with_value(|registration| {
            let registration = registration.as_ref()?;
            let (installing, waiting) = (registration.installing(), registration.waiting());
            for worker in installing.iter().chain(&waiting) {
                let changed = Closure::<dyn Fn()>::new(move || self.look());
                worker.set_onstatechange(Some(changed.into_js_value().unchecked_ref()));
            }
            Some(match (registration.active(), waiting, installing) {
                _ if self.left_behind.get_value() => Offline::NewVersion,
                (Some(_), Some(_), _) => Offline::NewVersion,
                (Some(_), None, _) => Offline::Ready,
                (None, None, None) => Offline::Failed,
                (None, _, _) => Offline::Preparing,
            })
        });
        if let Some(state) = state {
            self.state.set(state);
        }
    }
}

/// Until the page has what it starts with: keeping it can wait.
async fn loaded() {
    if document().ready_state() != "complete" {
        let load = Promise::new(&mut |resolve, _| {
            let options = AddEventListenerOptions::new();
            options.set_once(true);
            // The window takes any listener.
            let _ = window().add_event_listener_with_callback_and_add_event_listener_options(
                "load", &resolve, &options,
            );
        });
        // It is never rejected.
        let _ = JsFuture::from(load).await;
    }
}

fn container() -> Option<ServiceWorkerContainer> {
    let container = window().navigator().service_worker();
    // A browser without it has no such property.
    let there: &JsValue = container.as_ref();
    there.is_object().then_some(container)
}

/// Tells newer versions that a page uses this one, by a lock with the name of its cache.
fn hold(version: &str) {
    let base = document().base_uri().ok().flatten().unwrap_or_default();
    if let Ok(scope) = Url::new_with_base("./", &base) {
        let name = format!("motionbench {} {version}", scope.href());
        locks::request(&name, locks::Mode::Shared, |_| locks::for_ever());
    }
}

fn post(worker: &ServiceWorker, message: &str) {
    // Text can always be copied to it.
    let _ = worker.post_message(&message.into());
}

fn reload() {
    // A browser that refuses to reload leaves the page as it is.
    let _ = window().location().reload();
}
