//! What can be done with the whole picture.

use leptos::prelude::*;

use super::{Sheets, export};
use crate::panels::popover::Popover;
use crate::state::Store;
use crate::state::scope::{Follow, Scope, name};
use crate::storage::files;

/// What the picture can keep up with, and how that reads.
const FOLLOWS: [(Follow, &str, &str); 3] = [
    (Follow::Motion, "motion", "Start of motion"),
    (Follow::Newest, "newest", "Newest samples"),
    (Follow::Nothing, "chosen", "Chosen part"),
];
/// A press of a button changes the time that is shown by this.
const ZOOM: f64 = 1.5;

/// The tools of the scope.
#[component]
pub(super) fn Controls(store: Store, sheets: Sheets) -> impl IntoView {
    let paused = Sheets::choice(store, Scope::is_paused);
    let cursors = Sheets::choice(store, |scope| scope.cursors().is_some());
    let empty = sheets.word(store, |scope| scope.view().is_none());
    let zoom = move |factor| move |_| store.change_scope(|scope| scope.zoom(factor, 0.5));
    view! {
        <div class="tools" role="group" aria-label="Scope">
            <FollowChoice store />
            <button type="button" class="tool" aria-pressed=move || paused.get().to_string()
                title="The picture stands still, the machine does not"
                on:click=move |_| store.change_scope(|scope| scope.pause(!paused.get_untracked()))>
                "Hold"
            </button>
            <button type="button" class="tool" aria-label="Zoom out" title="Zoom out" disabled=empty
                on:click=zoom(ZOOM)>"\u{2212}"</button>
            <button type="button" class="tool" aria-label="Zoom in" title="Zoom in" disabled=empty
                on:click=zoom(1.0 / ZOOM)>"+"</button>
            <button type="button" class="tool" aria-pressed=move || cursors.get().to_string() disabled=empty
                on:click=move |_| store.change_scope(|scope| scope.show_cursors(!cursors.get_untracked()))>
                "Cursors"
            </button>
            <Popover label=|| "Traces" name="Traces">
                <Traces store />
            </Popover>
            <Popover label=|| "Export" name="Export">
                <button type="button" class="item" on:click=move |_| {
                    let csv = store.with_scope(Scope::csv);
                    // What the browser refuses, it says itself.
                    let _ = files::save("motionbench-scope.csv", "text/csv", &csv);
                }>"Numbers, CSV"</button>
                <button type="button" class="item" on:click=move |_| export::picture(store, sheets)>
                    "Picture, PNG"
                </button>
            </Popover>
        </div>
    }
}

/// What the picture keeps up with.
#[component]
fn FollowChoice(store: Store) -> impl IntoView {
    let follows = Sheets::choice(store, Scope::follows);
    let options = FOLLOWS.map(|(follow, value, label)| {
        let selected = move || follows.get() == follow;
        view! { <option value=value prop:selected=selected>{label}</option> }
    });
    let choose = move |event| {
        let chosen = event_target_value(&event);
        if let Some((follow, ..)) = FOLLOWS.iter().find(|(_, value, _)| *value == chosen) {
            store.change_scope(|scope| scope.follow(*follow));
        }
    };
    view! {
        <select class="tool" aria-label="What the picture shows" on:change=choose>{options}</select>
    }
}

/// All that is recorded: drawn or not.
#[component]
fn Traces(store: Store) -> impl IntoView {
    let names = |scope: &Scope| scope.signals().iter().map(name).collect::<Vec<_>>();
    let signals = Sheets::choice(store, names);
    let choice = move |(signal, name): (usize, String)| {
        let shown = Sheets::choice(store, move |scope| {
            scope.traces().any(|(_, trace)| trace.signal == signal)
        });
        view! {
            <label class="item">
                <input type="checkbox" prop:checked=shown on:change=move |event| {
                    let shown = event_target_checked(&event);
                    store.change_scope(|scope| scope.choose(signal, shown));
                } />
                {name}
            </label>
        }
    };
    move || {
        signals
            .get()
            .into_iter()
            .enumerate()
            .map(choice)
            .collect_view()
    }
}
