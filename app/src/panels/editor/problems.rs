//! The line of problems below the editor: one at a time, with its cure.

use leptos::prelude::*;
use motionbench_core::language::{Cure, Diagnostic, Severity};

use super::element::ProgramEditor;
use crate::state::editor::{EditorState, MOST_PROBLEMS};

/// What is wrong with the program; of several, what is wrong where the cursor is.
#[component]
pub(super) fn Problems(
    editor: RwSignal<EditorState>,
    problems: RwSignal<Vec<Diagnostic>>,
    cursor: RwSignal<u32>,
    element: StoredValue<Option<ProgramEditor>, LocalStorage>,
) -> impl IntoView {
    let shown = Memo::new(move |_| problems.with(|problems| at_cursor(problems, cursor.get())));
    let act = move |act: &dyn Fn(&ProgramEditor)| {
        element.with_value(|element| element.as_ref().map(act));
    };
    let next = move |_| act(&|element| element.next_problem());
    move || {
        let Some((index, problem)) = shown.get() else {
            return view! { <p class="problems muted">"No problems"</p> }.into_any();
        };
        let count = problems.with(Vec::len);
        let several = count > 1;
        let all = if count < MOST_PROBLEMS {
            count.to_string()
        } else {
            format!("{count} or more")
        };
        let Diagnostic {
            line,
            span,
            severity,
            message,
            cause,
            cure,
        } = problem;
        let name = editor.with_untracked(|editor| editor.line_name(line));
        let go = move |_| act(&|element| element.go_to(line, span.start));
        let mend = move |cure: Cure| {
            let Cure {
                label,
                span,
                replacement,
            } = cure;
            let mend =
                move |_| act(&|element| element.replace(line, span.start, span.end, &replacement));
            view! { <button type="button" class="link" on:click=mend>{label}</button> }
        };
        view! {
            <div class="problems" role="group" aria-label="Problems">
                <p>
                    <button type="button" class="link place" class:warning=severity == Severity::Warning
                        title="Go there" on:click=go>{name}</button>
                    " "<span class="message">{message}</span>" \u{2014} "{cause}" "
                    {cure.map(mend)}
                </p>
                <Show when=move || several>
                    <button type="button" class="link count" title="Next problem (F8)" on:click=next>
                        {index + 1}" of "{all.clone()}
                    </button>
                </Show>
            </div>
        }
        .into_any()
    }
}

/// The problem to show and its place among all: one of the cursor's line, otherwise the first.
fn at_cursor(problems: &[Diagnostic], cursor: u32) -> Option<(usize, Diagnostic)> {
    let index = problems
        .iter()
        .position(|problem| problem.line == cursor)
        .unwrap_or(0);
    problems.get(index).map(|problem| (index, problem.clone()))
}
