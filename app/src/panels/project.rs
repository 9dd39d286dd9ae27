//! The project: its name, its file, the way back, and what is said when it is not kept.

use leptos::ev;
use leptos::prelude::*;
use wasm_bindgen_futures::spawn_local;

use super::controller::ControllerChoice;
use super::dialog::Dialog;
use crate::clock;
use crate::state::Store;
use crate::state::project::{LARGEST, Project, ProjectError};
use crate::state::versions::{Reason, Version};
use crate::storage::files::{self, Unreadable};
use crate::storage::{Fault, Keeper, Keeping};

/// The media type of a project's file.
const PROJECT: &str = "application/json";

/// What the project dialog has to tell.
#[derive(Clone)]
enum Word {
    Nothing,
    Done(&'static str),
    Wrong(String),
}

/// The project dialog, and what its parts need.
#[derive(Clone, Copy)]
struct Desk {
    store: Store,
    keeper: Keeper,
    word: RwSignal<Word>,
    versions: RwSignal<Vec<Version>>,
}

impl Desk {
    fn export(self) {
        let project = self.store.project();
        self.give(&project.file_name(), &project.file());
    }

    fn give(self, name: &str, text: &str) {
        self.word.set(match files::save(name, PROJECT, text) {
            Ok(()) => Word::Done("The file is among your downloads."),
            Err(_) => Word::Wrong("The browser does not let the page save files.".to_owned()),
        });
    }

    async fn import(self) {
        let Some(file) = files::choose().await else {
            return;
        };
        let text = files::text(&file, LARGEST).await;
        let text = text.map_err(|why| match why {
            Unreadable::TooLarge => ProjectError::TooLarge,
            Unreadable::Refused => {
                ProjectError::Broken("the browser cannot read the file".to_owned())
            }
        });
        self.take(text, Reason::Import).await;
    }

    async fn go_back(self, version: Version) {
        match self.keeper.version(version).await {
            Ok(text) => self.take(Ok(text), Reason::Back).await,
            Err(fault) => self.word.set(Word::Wrong(fault.to_string())),
        }
    }

    async fn export_version(self, version: Version) {
        let name = self.store.project().file_name();
        match self.keeper.version(version).await {
            Ok(text) => self.give(&name, &text),
            Err(fault) => self.word.set(Word::Wrong(fault.to_string())),
        }
    }

    /// Loads the page again with the project that a text says. The present one goes among the versions.
    async fn take(self, text: Result<String, ProjectError>, reason: Reason) {
        let project = match text.and_then(|text| Project::read(&text)) {
            Ok(project) => project,
            Err(error) => return self.word.set(Word::Wrong(error.to_string())),
        };
        match self.keeper.replace(&project, reason).await {
            Ok(()) => reload(),
            Err(fault) => self.word.set(Word::Wrong(fault.to_string())),
        }
    }
}

/// The button with the project's name, and its dialog.
#[component]
pub(super) fn ProjectMenu(store: Store, keeper: Keeper) -> impl IntoView {
    let desk = Desk {
        store,
        keeper,
        word: RwSignal::new(Word::Nothing),
        versions: RwSignal::new(Vec::new()),
    };
    let is_open = RwSignal::new(false);
    let open = move |_| {
        desk.word.set(Word::Nothing);
        desk.versions.set(keeper.versions());
        is_open.set(true);
    };
    view! {
        <button type="button" class="button project" aria-haspopup="dialog" title="The project: its file, earlier versions"
            on:click=open>
            <span class="name">{store.project_name}</span>
        </button>
        <Dialog open=is_open title="Project">
            <div class="dialog-body">
                <Present desk />
                <div class="labelled narrow-only">
                    <span aria-hidden="true">"Controller"</span>
                    <ControllerChoice store keeper />
                </div>
                <Said desk />
                <Versions desk />
            </div>
        </Dialog>
    }
}

/// Name and file of the present project.
#[component]
fn Present(desk: Desk) -> impl IntoView {
    let Desk { store, keeper, .. } = desk;
    let read_only = move || keeper.is_read_only();
    let rename = move |event: ev::Event| store.project_name.set(event_target_value(&event));
    let import = move |_| spawn_local(desk.import());
    view! {
        <label class="labelled">
            "Name"
            <input class="input" maxlength="100" prop:value=store.project_name
                disabled=read_only on:change=rename />
        </label>
        <p class="muted">{move || keeper.persistence.get().words()}</p>
        <div class="choices">
            <button type="button" class="button" on:click=move |_| desk.export()>"Export to a file"</button>
            <button type="button" class="button" disabled=read_only on:click=import>"Import a file"</button>
        </div>
    }
}

/// What came of it.
#[component]
fn Said(desk: Desk) -> impl IntoView {
    let said = move || match desk.word.get() {
        Word::Nothing => ().into_any(),
        Word::Done(words) => view! { <p>{words}</p> }.into_any(),
        Word::Wrong(words) => view! { <p class="wrong">{words}</p> }.into_any(),
    };
    view! { <div class="said" role="status">{said}</div> }
}

/// What can be gone back to.
#[component]
fn Versions(desk: Desk) -> impl IntoView {
    let row = move |version: Version| {
        let name = format!(
            "{}, {}",
            clock::day_and_time(version.at_ms),
            version.reason.words()
        );
        let take = move |_| spawn_local(desk.go_back(version));
        let export = move |_| spawn_local(desk.export_version(version));
        view! {
            <li>
                <span class="figures">{name.clone()}</span>
                <button type="button" class="button" aria-label=format!("Go back to {name}")
                    disabled=move || desk.keeper.is_read_only() on:click=take>"Go back"</button>
                <button type="button" class="button" aria-label=format!("Export {name}")
                    on:click=export>"Export"</button>
            </li>
        }
    };
    let list = move || {
        let versions = desk.versions.get();
        if versions.is_empty() {
            view! { <p class="muted">"There are none yet. One is kept every minute in which you change something."</p> }
                .into_any()
        } else {
            view! { <ul class="versions">{versions.into_iter().map(row).collect_view()}</ul> }
                .into_any()
        }
    };
    view! {
        <h3>"Earlier versions"</h3>
        {list}
    }
}

/// Says that the project is not kept, and offers the cure.
#[component]
pub(super) fn KeepingNotice(store: Store, keeper: Keeper) -> impl IntoView {
    let notice = Memo::new(move |_| keeper.state.get().notice());
    let cure = move || {
        let (words, act): (_, fn(Store, Keeper)) = match keeper.state.get() {
            Keeping::Freed => ("Reload", |_, _| reload()),
            Keeping::Failed(Fault::Unreadable(_)) => ("Start over", |_, keeper| start_over(keeper)),
            Keeping::Failed(_) => ("Export", |store, _| export(store)),
            _ => return None,
        };
        Some(
            view! { <button type="button" class="button" on:click=move |_| act(store, keeper)>{words}</button> },
        )
    };
    view! {
        <div role="status">
            {move || notice.get().map(|words| view! {
                <div class="notice"><p>{words}</p>{cure}</div>
            })}
        </div>
    }
}

fn export(store: Store) {
    let project = store.project();
    // What the browser refuses, it says itself.
    let _ = files::save(&project.file_name(), PROJECT, &project.file());
}

fn start_over(keeper: Keeper) {
    spawn_local(async move {
        // If that fails, the notice stays.
        let _ = keeper.start_over().await;
    });
}

fn reload() {
    // A browser that refuses to reload leaves the page as it is.
    let _ = window().location().reload();
}
