//! What is shown when the controller has another program than the editor: neither is replaced unasked.

use leptos::prelude::*;

use crate::state::editor::programs::Difference;
use crate::state::editor::{Agreement, EditorState};

/// Lines that are compared in one view.
const MOST_COMPARED: usize = 200;

/// The choice between the two programs, while they differ. `send` loads the editor's into the controller.
#[component]
pub(super) fn TwoPrograms(editor: RwSignal<EditorState>, send: Callback<()>) -> impl IntoView {
    let differ =
        Memo::new(move |_| editor.with(EditorState::agreement) == Agreement::ControllerDiffers);
    let compared = RwSignal::new(false);
    let take = move |_| {
        editor.update(|editor| {
            let listing = editor.listing().unwrap_or_default().to_owned();
            editor.take(&listing);
        });
    };
    view! {
        <Show when=move || differ.get()>
            <div class="two-programs" role="group" aria-label="Two programs">
                <p role="alert">"The controller has another program than this."</p>
                <button type="button" class="button" title="Replaces the controller's program by this one"
                    on:click=move |_| send.run(())>"Send"</button>
                <button type="button" class="button" title="Replaces this program by the controller's; undo brings it back"
                    on:click=take>"Take"</button>
                <button type="button" class="button" aria-expanded=move || compared.get().to_string()
                    on:click=move |_| compared.update(|compared| *compared = !*compared)>"Compare"</button>
            </div>
            <Show when=move || compared.get()><Compared editor /></Show>
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
    let row = move |difference: Difference| {
        let Difference {
            number,
            editor,
            controller,
        } = difference;
        view! { <tr><th scope="row">{number}</th>{side(editor)}{side(controller)}</tr> }
    };
    view! {
        <div class="compared" tabindex="0" role="region" aria-label="Differences">
            <table>
                <thead><tr><th scope="col">"Line"</th><th scope="col">"Here"</th><th scope="col">"Controller"</th></tr></thead>
                <tbody>
                    {move || differences.get().into_iter().take(MOST_COMPARED).map(row).collect_view()}
                </tbody>
            </table>
            {move || {
                let more = differences.with(Vec::len).saturating_sub(MOST_COMPARED);
                (more > 0).then(|| view! { <p class="muted">"and "{more}" more"</p> })
            }}
        </div>
    }
}
