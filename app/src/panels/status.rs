//! The status line: what is true now.

use leptos::prelude::*;

use crate::offline::Updates;
use crate::state::device::{Activity, line_words};
use crate::state::{Device, Store, words};
use crate::storage::Keeper;

/// The status line.
#[component]
pub(super) fn StatusLine(store: Store, keeper: Keeper, updates: Updates) -> impl IntoView {
    let memo = move |read: fn(&Device) -> String| Memo::new(move |_| store.device.with(read));
    let activity = Memo::new(move |_| store.device.with(Device::activity));
    let line = Memo::new(move |_| {
        let line = store.device.with(Device::running_line);
        let name = |line| store.editor.with(|editor| editor.device_line_name(line));
        line.map_or_else(String::new, name)
    });
    let moving = memo(|device| {
        let words = if device.is_moving() { "axis moves" } else { "" };
        words.to_owned()
    });
    let error = memo(|device| device.error().unwrap_or_default().to_owned());
    let time = memo(|device| words::time(device.now.seconds()));
    let settings = memo(|device| device.line.as_ref().map_or_else(String::new, line_words));
    // Where switches say how the controller's end is set, not its programs.
    let controller = Memo::new(move |_| {
        let other = store.device.with(Device::other_line);
        other.filter(|_| store.kind().face.is_some())
    });
    let why = memo(|device| device.why().to_owned());
    let sending = Memo::new(move |_| {
        store.console.sending.with(|progress| {
            progress.as_ref().map_or_else(String::new, |progress| {
                let percent = 100 * progress.sent / progress.total.max(1);
                format!("sending, {percent} %")
            })
        })
    });
    let keyboard = move || {
        if store.pressing.get() {
            "keyboard: panel"
        } else if store.typing.get() {
            "keyboard: terminal"
        } else if store.editing.get() {
            "keyboard: editor"
        } else {
            "keyboard: page"
        }
    };
    view! {
        <footer class="status" aria-label="Status">
            <span class="activity" class:running=move || activity.get().is_running()
                class:held=move || activity.get() == Activity::Paused
                class:failed=move || activity.get() == Activity::Failed>
                {move || activity.get().words()}
            </span>
            <span class="figures line">{line}</span>
            <span class="why">{why}</span>
            <span class="moving">{moving}</span>
            <span class="error">{error}</span>
            <span class="figures time">"t = "{time}</span>
            <span class="figures settings">{settings}</span>
            <span class="figures error">
                {move || controller.get().map(|line| format!("the controller is set to {}", line_words(&line)))}
            </span>
            <span class="figures sending">{sending}</span>
            <span class="figures saved">{move || keeper.state.get().words()}</span>
            <span class="offline">{move || updates.state.get().words()}</span>
            <span class="keyboard">{keyboard}</span>
        </footer>
    }
}
