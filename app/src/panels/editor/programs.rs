//! What is shown when the controller has another program than the editor, or did not take the editor's: neither
//! replaces the other unasked.

use leptos::prelude::*;

use super::element::ProgramEditor;
use crate::panels::popover::{self, Popover};
use crate::state::Store;
use crate::state::editor::programs::Difference;
use crate::state::editor::{Agreement, EditorState};

/// Lines that are compared in one view.
const MOST_COMPARED: usize = 200;

/// What goes from one program to the other without being started.
#[component]
pub(super) fn ProgramMenu(store: Store) -> impl IntoView {
    let has_listing = Memo::new(move |_| store.editor.with(|editor| editor.listing().is_some()));
    view! {
        <Popover label=|| "More" name="More of the program">
            <div on:click=popover::close>
                <button type="button" class="item" title="Replaces the controller's program by this one"
                    on:click=move |_| store.load_program(false)>"Send to the controller"</button>
                <button type="button" class="item" title="Replaces this program by the controller's; undo brings it back"
                    disabled=move || !has_listing.get() on:click=move |_| store.take_program()>
                    "Take the controller's"
                </button>
            </div>
        </Popover>
    }
}

/// The choice between the two programs, while they differ.
#[component]
pub(super) fn TwoPrograms(store: Store) -> impl IntoView {
    let differ = Memo::new(move |_| {
        store.editor.with(EditorState::agreement) == Agreement::ControllerDiffers
    });
    Effect::new(move |_| {
        if !differ.get() {
            store.asked.set(false);
        }
    });
    let compared = RwSignal::new(false);
    let words = move || {
        if store.asked.get() {
            "The controller has another program than this. Which one shall run?"
        } else {
            "The controller has another program than this."
        }
    };
    let send = move |_| store.load_program(store.asked.get_untracked());
    view! {
        <Show when=move || differ.get()>
            <div class="two-programs" role="group" aria-label="Two programs">
                <p role="alert">{words}</p>
                <Show when=move || store.asked.get()>
                    <button type="button" class="button" on:click=move |_| store.run_controllers()>
                        "Run the controller's"
                    </button>
                </Show>
                <button type="button" class="button" title="Replaces the controller's program by this one" on:click=send>
                    {move || if store.asked.get() { "Send and run" } else { "Send" }}
                </button>
                <button type="button" class="button" title="Replaces this program by the controller's; undo brings it back"
                    on:click=move |_| store.take_program()>"Take"</button>
                <button type="button" class="button" aria-expanded=move || compared.get().to_string()
                    on:click=move |_| compared.update(|compared| *compared = !*compared)>"Compare"</button>
            </div>
            <Show when=move || compared.get()><Compared editor=store.editor /></Show>
        </Show>
    }
}

/// The lines in which the two programs differ, side by side.
#[component]
fn Compared(editor: RwSignal<EditorState>) -> impl IntoView {
    let differences = Memo::new(move |_| editor.with(EditorState::differences));
    let side = |line: Option<String>| match line {
        Some(line) => view! { <td><code>{line}</code></td> }.into_any(),
        None => view! { <td class="muted">"no such line"</td> }.into_any(),
    };
    let row = move |Difference {
                        editor, controller, ..
                    }| {
        view! { <tr>{side(editor)}{side(controller)}</tr> }
    };
    let more = move || differences.with(Vec::len).saturating_sub(MOST_COMPARED);
    view! {
        <div class="compared" tabindex="0" role="region" aria-label="Differences">
            <table>
                <thead><tr><th scope="col">"Here"</th><th scope="col">"Controller"</th></tr></thead>
                <tbody>
                    {move || differences.get().into_iter().take(MOST_COMPARED).map(row).collect_view()}
                </tbody>
            </table>
            <Show when=move || { more() > 0 }><p class="muted">"and "{more}" more"</p></Show>
        </div>
    }
}

/// Why the controller did not take the program.
#[component]
pub(super) fn Refusal(
    store: Store,
    element: StoredValue<Option<ProgramEditor>, LocalStorage>,
) -> impl IntoView {
    move || {
        store.refusal.get().map(|refused| {
            let line = refused.line;
            let name = store.editor.with_untracked(|editor| editor.line_name(line));
            let go = move |_| {
                element.with_value(|element| element.as_ref().map(|element| element.go_to(line, 0)));
            };
            view! {
                <div class="problems refused" role="alert">
                    <p>
                        <button type="button" class="link place" title="Go there" on:click=go>{name}</button>
                        " The controller did not take the program: "
                        <span class="message">{refused.message}</span>
                    </p>
                    <button type="button" class="link count" on:click=move |_| store.refusal.set(None)>"Close"</button>
                </div>
            }
        })
    }
}
