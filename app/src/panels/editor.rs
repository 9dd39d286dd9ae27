//! The editor: the program's text with its breakpoints and the line that runs, and below it what is wrong.

use leptos::html;
use leptos::prelude::*;
use leptos::wasm_bindgen::JsCast;

use motionbench_core::language::Diagnostic;

use crate::state::editor::lines::Edit;
use crate::state::editor::{EditorState, Toggled};

mod element;
mod problems;
mod programs;

use element::{Answers, ProgramEditor};

/// The editor of a program. `typing` tells whether it has the keyboard; `held`, whether the program is held at a line,
/// which is then brought into sight; `send` loads the text into the controller.
#[component]
pub(super) fn Editor(
    editor: RwSignal<EditorState>,
    typing: RwSignal<bool>,
    #[prop(into)] held: Signal<bool>,
    send: Callback<()>,
) -> impl IntoView {
    let node = NodeRef::<html::Custom<&'static str>>::new();
    let element = StoredValue::<Option<ProgramEditor>, _>::new_local(None);
    let problems = RwSignal::new(Vec::new());
    let cursor = RwSignal::new(0);
    let failed = RwSignal::new(false);
    node.on_load(move |node| {
        let node: ProgramEditor = node.unchecked_into();
        if !node.is_defined() {
            failed.set(true);
            return;
        }
        start(&node, editor, problems, cursor);
        element.set_value(Some(node.clone()));
        show(editor, held, node);
    });
    on_cleanup(move || {
        element.try_with_value(|element| element.as_ref().map(ProgramEditor::stop));
    });
    let agreement = Memo::new(move |_| editor.with(EditorState::agreement));
    view! {
        <section class="panel editor" aria-labelledby="editor-title" class:typing=typing
            on:focusin=move |_| typing.set(true)
            on:focusout=move |_| typing.set(false)>
            <header class="panel-head">
                <h2 id="editor-title">"Program"</h2>
                <span class="muted">{move || agreement.get().words()}</span>
            </header>
            <Show when=move || failed.get()>
                <p class="sorry" role="alert">"The editor could not be loaded. Reload the page to try again."</p>
            </Show>
            <programs::TwoPrograms editor send />
            <program-editor node_ref=node></program-editor>
            <problems::Problems editor problems cursor element />
        </section>
    }
}

/// Gives the element its text, and answers what it asks.
fn start(
    element: &ProgramEditor,
    editor: RwSignal<EditorState>,
    problems: RwSignal<Vec<Diagnostic>>,
    cursor: RwSignal<u32>,
) {
    let announcer = element.clone();
    let answers = Answers {
        problems: move || {
            let found = editor.with_untracked(EditorState::problems);
            let json = serde_json::to_string(&found).unwrap_or_default();
            problems.set(found);
            json
        },
        edited: move |text: String, edits: Vec<Edit>| {
            editor.update(|editor| editor.edit(text, &edits))
        },
        cursor: move |line| cursor.set(line),
        toggle: move |line| {
            let toggled = editor.try_update(|editor| editor.toggle_breakpoint(line));
            let number = editor
                .with_untracked(|editor| editor.device_line(line))
                .unwrap_or(line + 1);
            announcer.announce(&match toggled {
                Some(Toggled::Set) => format!("Breakpoint at line {number}"),
                Some(Toggled::Cleared) => format!("No breakpoint at line {number}"),
                Some(Toggled::Blank) | None => "Nothing to stop at in this line".to_owned(),
            });
        },
    };
    let (kind, text) = editor.with_untracked(|editor| (editor.kind(), editor.text().to_owned()));
    element.begin(kind, &text, answers);
}

/// Keeps what the element shows as the state is.
fn show(editor: RwSignal<EditorState>, held: Signal<bool>, element: ProgramEditor) {
    let takes = Memo::new(move |_| editor.with(EditorState::takes));
    let texts = element.clone();
    Effect::new(move |before: Option<u64>| {
        let takes = takes.get();
        if before.is_some_and(|before| before != takes) {
            editor.with_untracked(|editor| texts.set_text(editor.text()));
        }
        takes
    });
    let breakpoints = Memo::new(move |_| editor.with(EditorState::breakpoints));
    let dots = element.clone();
    Effect::new(move |_| dots.set_breakpoints(breakpoints.get()));
    let running = Memo::new(move |_| editor.with(EditorState::running));
    Effect::new(move |_| {
        let line = running.get().and_then(|line| i32::try_from(line).ok());
        element.set_running(line.unwrap_or(-1), held.get());
    });
}
