//! A window above the page that has the keyboard until it is closed.

use leptos::html;
use leptos::prelude::*;

/// Shows what is in it while `open`. Escape closes it, and the keyboard goes back to where it was.
#[component]
pub(super) fn Dialog(
    open: RwSignal<bool>,
    title: &'static str,
    children: ChildrenFn,
) -> impl IntoView {
    let dialog = NodeRef::<html::Dialog>::new();
    Effect::new(move |_| {
        let (Some(dialog), open) = (dialog.get(), open.get()) else {
            return;
        };
        if open && !dialog.open() {
            // It is in the page, and not open.
            let _ = dialog.show_modal();
        } else if !open && dialog.open() {
            dialog.close();
        }
    });
    view! {
        <dialog class="dialog" node_ref=dialog aria-label=title on:close=move |_| open.set(false)>
            <Show when=move || open.get()>
                <div class="dialog-head">
                    <h2>{title}</h2>
                    <button type="button" class="close" aria-label="Close" on:click=move |_| open.set(false)></button>
                </div>
                {children()}
            </Show>
        </dialog>
    }
}
