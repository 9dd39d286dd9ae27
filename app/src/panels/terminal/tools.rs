//! What can be done with the terminal as a whole, and what it says of that.

use leptos::prelude::*;
use leptos::task::spawn_local;
use wasm_bindgen_futures::JsFuture;

use super::{disks, file, line};
use crate::panels::popover::{self, Popover};
use crate::protocol::ToWorker;
use crate::state::device::line_words;
use crate::state::terminal::Terminal;
use crate::state::{Store, words};
use crate::storage::files;

/// The tools in the head of the terminal.
#[component]
pub(super) fn Tools(store: Store) -> impl IntoView {
    let line_open = RwSignal::new(false);
    let file_open = RwSignal::new(false);
    let disks_open = RwSignal::new(false);
    let has_disks = Memo::new(move |_| !store.kind().disks.is_empty());
    let settings = Memo::new(move |_| {
        let line = store.device.with(|device| device.line);
        line.as_ref().map_or_else(String::new, line_words)
    });
    view! {
        <div class="tools" role="group" aria-label="Terminal">
            <button type="button" class="tool figures" title="Line settings of the terminal" aria-haspopup="dialog"
                on:click=move |_| line_open.set(true)>
                <span class="unseen">"Line settings "</span>{settings}
            </button>
            <button type="button" class="tool" aria-haspopup="dialog" on:click=move |_| file_open.set(true)>
                "Send file"
            </button>
            <Show when=move || has_disks.get()>
                <button type="button" class="tool" aria-haspopup="dialog" on:click=move |_| disks_open.set(true)>
                    "Disks"
                </button>
            </Show>
            <Capture store />
            <Popover label=|| "More" name="More of the terminal">
                <div on:click=popover::close>
                    <button type="button" class="item" on:click=move |_| copy_all(store)>"Copy all"</button>
                    <button type="button" class="item" on:click=move |_| store.clear_terminal()>"Clear"</button>
                    <button type="button" class="item" title="Holds the line low for a moment"
                        on:click=move |_| store.send(ToWorker::Break)>"Send a break"</button>
                </div>
            </Popover>
        </div>
        <line::LineDialog store open=line_open />
        <file::FileDialog store open=file_open />
        <disks::DisksDialog store open=disks_open />
    }
}

/// Keeps what arrives for a file.
#[component]
fn Capture(store: Store) -> impl IntoView {
    let captured = store.console.captured;
    let is_on = Memo::new(move |_| captured.with(Option::is_some));
    let press = move |_| {
        if is_on.get_untracked() {
            let text = store.end_capture();
            if files::save("terminal.txt", "text/plain", &text).is_err() {
                store.say("The browser refuses to save a file: use Copy all.");
            }
        } else {
            store.start_capture();
        }
    };
    let label = move || match captured.get() {
        Some(kept) => format!("Save capture, {}", words::number(kept as f64, 0)),
        None => "Capture".to_owned(),
    };
    view! {
        <button type="button" class="tool figures" aria-pressed=move || is_on.get().to_string()
            title=move || if is_on.get() { "Ends the capture and saves it as a file" } else { "Keeps what arrives for a file" }
            on:click=press>{label}</button>
    }
}

/// Puts all that the terminal has on the clipboard.
fn copy_all(store: Store) {
    let text = store.with_terminal(|terminal: &mut Terminal| terminal.text());
    let clipboard = window().navigator().clipboard();
    // A page that came over plain http from another machine has none.
    if AsRef::<leptos::wasm_bindgen::JsValue>::as_ref(&clipboard).is_undefined() {
        return store.say("The browser gives this page no clipboard: select the text and copy it.");
    }
    let written = clipboard.write_text(&text.unwrap_or_default());
    spawn_local(async move {
        store.say(match JsFuture::from(written).await {
            Ok(_) => "All of it is on the clipboard.",
            Err(_) => {
                "The browser did not let the page use the clipboard: select the text and copy it."
            }
        });
    });
}

/// How far what is sent is, and what the terminal has to say.
#[component]
pub(super) fn Notices(store: Store) -> impl IntoView {
    let sending = store.console.sending;
    let name =
        Memo::new(move |_| sending.with(|progress| progress.as_ref().map(|p| p.name.clone())));
    let part = move || {
        sending.with(|progress| {
            let (sent, total) = progress
                .as_ref()
                .map_or((0, 1), |p| (p.sent, p.total.max(1)));
            (sent, total, 100 * sent / total)
        })
    };
    let words = move || {
        let (sent, total, percent) = part();
        let number = |count: usize| words::number(count as f64, 0);
        format!(
            "{percent} %, {} of {} characters",
            number(sent),
            number(total)
        )
    };
    view! {
        {move || name.get().map(|name| view! {
            <div class="notice-line" role="group" aria-label="Sending">
                <span>"Sending "{name}</span>
                <progress max="100" aria-label="Sent" prop:value=move || part().2 as f64></progress>
                <span class="muted figures">{words}</span>
                <button type="button" class="tool" on:click=move |_| store.cancel_sending()>"Cancel"</button>
            </div>
        })}
        <div role="status">
            {move || store.console.said.get().map(|said| view! {
                <div class="notice-line">
                    <span>{said}</span>
                    <button type="button" class="tool" on:click=move |_| store.console.said.set(None)>"OK"</button>
                </div>
            })}
        </div>
    }
}
