//! The printer at the controller's line, and its paper.

use leptos::prelude::*;

use crate::state::Store;
use crate::state::front::Paper;
use crate::storage::files;

/// The paper, and what can be done with it.
#[component]
pub(super) fn Printer(store: Store) -> impl IntoView {
    let blank = Memo::new(move |_| store.paper.with(Paper::is_blank));
    let save = move |_| {
        let text = store.paper.with_untracked(Paper::text);
        if files::save("paper.txt", "text/plain", &text).is_err() {
            store.notice.set(Some(
                "The browser refuses to save a file: select the text and copy it.",
            ));
        }
    };
    let lines = move || store.paper.with(|paper| paper.lines().collect::<Vec<_>>());
    view! {
        <div class="printer">
            <div class="printer-keys">
                <button type="button" class="tool" role="switch" aria-checked=move || store.printer.get().to_string()
                    title="On line, it prints all that the controller sends"
                    on:click=move |_| store.printer.update(|on| *on = !*on)>
                    <span class="lamp" aria-hidden="true"></span>"On line"
                </button>
                <button type="button" class="tool" disabled=blank on:click=move |_| store.paper.set(Paper::default())>
                    "Tear off"
                </button>
                <button type="button" class="tool" disabled=blank on:click=save>"Save"</button>
            </div>
            <div class="paper" tabindex="0" role="region" aria-label="Paper">
                <Show when=move || blank.get()>
                    <p class="muted">"PRT, a program number and EXC print it; PRT D EXC the directory."</p>
                </Show>
                <For each=lines key=Clone::clone children=|(_, line)| view! { <p class="paper-line">{line}</p> } />
            </div>
        </div>
    }
}
