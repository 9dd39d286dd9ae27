//! Sends a text file to the console.

use leptos::ev;
use leptos::html;
use leptos::prelude::*;
use leptos::task::spawn_local;
use motionbench_core::time::Nanos;
use web_sys::File;

use crate::panels::dialog::Dialog;
use crate::protocol::Pace;
use crate::state::Store;
use crate::state::keys::sent;
use crate::state::terminal::outbox::MOST;
use crate::storage::files::{self, Unreadable};

/// The longest pause, ms.
const LONGEST_MS: u64 = 10_000;

/// Asks for the file and its pace.
#[component]
pub(super) fn FileDialog(store: Store, open: RwSignal<bool>) -> impl IntoView {
    // Stays from one file to the next.
    let character = RwSignal::new("0".to_owned());
    let line = RwSignal::new("0".to_owned());
    let prompt = RwSignal::new(true);
    let input = NodeRef::<html::Input>::new();
    let wrong = RwSignal::new(String::new());
    let submit = move |event: ev::SubmitEvent| {
        event.prevent_default();
        let chosen = input
            .get_untracked()
            .and_then(|input| input.files()?.get(0));
        let Some(file) = chosen else {
            return wrong.set("Choose a file first.".to_owned());
        };
        let pace = Pace {
            character: pause(&character.get_untracked()),
            line: pause(&line.get_untracked()),
            prompt: prompt.get_untracked(),
        };
        spawn_local(async move {
            match read(&file).await {
                Ok(text) => {
                    wrong.set(String::new());
                    open.set(false);
                    store.send_file(&file.name(), &sent(&text), pace);
                }
                Err(words) => wrong.set(words),
            }
        });
    };
    view! {
        <Dialog open=open title="Send a text file">
            <form class="dialog-body" on:submit=submit>
                <p>"The file goes over the line as if it were typed. A controller that is slower than the line needs pauses,
                    or a terminal that waits for its prompt."</p>
                <label class="labelled">"File"
                    <input class="input" type="file" accept=".bas,.txt,text/plain" node_ref=input />
                </label>
                <div class="fields">
                    <Pause label="Pause behind a character, ms" value=character />
                    <Pause label="Pause behind a line, ms" value=line />
                </div>
                <label class="check">
                    <input type="checkbox" bind:checked=prompt />
                    "Wait for the prompt behind each line"
                </label>
                <p class="wrong" role="alert">{wrong}</p>
                <div class="choices">
                    <button type="submit" class="button primary">"Send"</button>
                    <button type="button" class="button" on:click=move |_| open.set(false)>"Cancel"</button>
                </div>
            </form>
        </Dialog>
    }
}

#[component]
fn Pause(label: &'static str, value: RwSignal<String>) -> impl IntoView {
    view! {
        <label class="labelled">
            {label}
            <input class="input figures" type="number" inputmode="numeric" min="0" max=LONGEST_MS.to_string() required
                bind:value=value />
        </label>
    }
}

/// A pause as the browser lets it be written.
fn pause(ms: &str) -> Nanos {
    Nanos::from_millis(ms.parse::<u64>().unwrap_or(0).min(LONGEST_MS))
}

/// The text of a file that can be sent or stored, or in words why not.
pub(super) async fn read(file: &File) -> Result<String, String> {
    files::text(file, MOST).await.map_err(|why| {
        match why {
            Unreadable::TooLarge => "The file is larger than can be sent: 4 million characters.",
            Unreadable::Refused => "The browser cannot read the file.",
        }
        .to_owned()
    })
}
