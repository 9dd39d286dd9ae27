//! The page: draws the state, and says what the user does.

// What Leptos makes of a component is public, whatever the component is.
#![allow(unreachable_pub)]

mod axis;
mod cam;
mod controller;
mod dialog;
mod draw;
mod editor;
mod estop;
mod frame;
mod front;
mod io;
mod popover;
mod project;
mod room;
mod scope;
mod status;
mod terminal;
#[cfg(all(test, target_family = "wasm"))]
mod tests;
mod topbar;
mod update;

use leptos::prelude::*;

use crate::offline::Updates;
use crate::state::Store;
use crate::storage::Keeper;

/// Puts the page into the document.
pub fn mount() {
    mount_to_body(|| {
        let store = Store::start();
        let updates = Updates::start();
        let keeper = Keeper::new(Keeper::DATABASE);
        store.keep(keeper);
        view! {
            <topbar::TopBar store keeper />
            <estop::EStopNotice store />
            <Fault store />
            <Notice store />
            <project::KeepingNotice store keeper />
            <update::UpdatePrompt updates />
            <frame::Frame store keeper />
            <terminal::Compose store />
            <status::StatusLine store keeper updates />
            <frame::Tabs store />
        }
    });
}

/// What the user should know, and may put away.
#[component]
fn Notice(store: Store) -> impl IntoView {
    move || {
        store.notice.get().map(|words| {
            view! {
                <div class="fault" role="status">
                    <p>{words}</p>
                    <button type="button" class="button" on:click=move |_| store.notice.set(None)>"OK"</button>
                </div>
            }
        })
    }
}

/// What has gone wrong with the page itself, and the cure.
#[component]
fn Fault(store: Store) -> impl IntoView {
    let fault = Memo::new(move |_| store.device.with(|device| device.fault));
    let reload = move |_| {
        // A browser that refuses to reload leaves the page as it is.
        let _ = window().location().reload();
    };
    move || {
        fault.get().map(|fault| {
            view! {
                <div class="fault" role="alert">
                    <p>{fault.words()}</p>
                    <button type="button" class="button" on:click=reload>"Reload"</button>
                </div>
            }
        })
    }
}
