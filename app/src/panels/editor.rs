//! The editor: the program's text with its breakpoints and the line that runs, and below it what is wrong.

use leptos::html;
use leptos::prelude::*;
use leptos::wasm_bindgen::JsCast;
use motionbench_core::language::Diagnostic;

use crate::state::Store;
use crate::state::editor::lines::{self, Edit};
use crate::state::editor::{EditorState, Toggled};

mod element;
mod problems;
mod programs;

use element::{Answers, ProgramEditor};

/// The editor of the program.
#[component]
pub(super) fn Editor(
    store: Store,
    /// The text may be read and copied, but not changed.
    #[prop(optional, into)]
    read_only: Signal<bool>,
) -> impl IntoView {
    let editor = store.editor;
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
        start(&node, store, problems, cursor);
        element.set_value(Some(node.clone()));
        show_text(editor, node.clone());
        let lock = node.clone();
        Effect::new(move |_| lock.set_read_only(read_only.get()));
        show_marks(store, node);
    });
    on_cleanup(move || {
        element.try_with_value(|element| element.as_ref().map(ProgramEditor::stop));
    });
    let agreement = Memo::new(move |_| editor.with(EditorState::agreement));
    view! {
        <section class="panel editor" aria-labelledby="editor-title" class:typing=store.editing
            on:focusin=move |_| store.editing.set(true)
            on:focusout=move |_| store.editing.set(false)>
            <header class="panel-head">
                <h2 id="editor-title">"Program"</h2>
                <span class="muted">{move || agreement.get().words()}</span>
                <programs::ProgramMenu store />
            </header>
            <Show when=move || failed.get()>
                <p class="sorry" role="alert">"The editor could not be loaded. Reload the page to try again."</p>
            </Show>
            <programs::TwoPrograms store />
            <program-editor node_ref=node></program-editor>
            <programs::Refusal store element />
            <problems::Problems editor problems cursor element />
        </section>
    }
}

/// Gives the element its text, and answers what it asks.
fn start(
    element: &ProgramEditor,
    store: Store,
    problems: RwSignal<Vec<Diagnostic>>,
    cursor: RwSignal<u32>,
) {
    let editor = store.editor;
    let announcer = element.clone();
    let answers = Answers {
        highlight: move |line: &str| {
            let kind = editor.with_untracked(EditorState::kind);
            lines::highlights(kind, line)
        },
        problems: move || {
            let found = editor.with_untracked(EditorState::problems);
            let json = serde_json::to_string(&found).unwrap_or_default();
            problems.set(found);
            json
        },
        edited: move |text: String, edits: Vec<Edit>| {
            editor.update(|editor| editor.edit(text, &edits));
            store.refusal.set(None);
        },
        cursor: move |line| cursor.set(line),
        toggle: move |line| {
            let toggled = editor.try_update(|editor| editor.toggle_breakpoint(line));
            let name = editor.with_untracked(|editor| editor.line_name(line));
            announcer.announce(&match toggled {
                Some(Toggled::Set) => format!("Breakpoint at {name}"),
                Some(Toggled::Cleared) => format!("No breakpoint at {name}"),
                Some(Toggled::Blank) | None => "Nothing to stop at in this line".to_owned(),
            });
        },
    };
    let (kind, text) = editor.with_untracked(|editor| (editor.kind(), editor.text().to_owned()));
    element.use_words(kind);
    element.begin(&text, answers);
}

/// Shows another text when the state has one that was not typed here.
fn show_text(editor: RwSignal<EditorState>, element: ProgramEditor) {
    let counts = Memo::new(move |_| editor.with(|editor| (editor.opens(), editor.takes())));
    Effect::new(move |before: Option<(u64, u64)>| {
        let now = counts.get();
        editor.with_untracked(|editor| match before {
            Some((opens, _)) if opens != now.0 => {
                element.use_words(editor.kind());
                element.open(editor.text());
                // They may be at the same lines as before.
                element.set_breakpoints(editor.breakpoints());
                element.set_running(as_shown(editor.running()), false);
            }
            Some((_, takes)) if takes != now.1 => element.set_text(editor.text()),
            _ => {}
        });
        now
    });
}

/// Shows the breakpoints and the line that runs; a line at which the program is held is brought into sight.
fn show_marks(store: Store, element: ProgramEditor) {
    let breakpoints = Memo::new(move |_| store.editor.with(EditorState::breakpoints));
    let dots = element.clone();
    Effect::new(move |_| dots.set_breakpoints(breakpoints.get()));
    let running = Memo::new(move |_| store.editor.with(EditorState::running));
    let held = Memo::new(move |_| store.is_held());
    Effect::new(move |_| {
        element.set_running(as_shown(running.get()), held.get());
    });
}

/// A line for the element: below 0, none.
fn as_shown(line: Option<u32>) -> i32 {
    line.and_then(|line| i32::try_from(line).ok()).unwrap_or(-1)
}
