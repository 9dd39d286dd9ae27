//! A button and what it opens: choices that are not needed all the time. The browser closes it, by Escape or a press
//! elsewhere, and gives the focus back.

use std::sync::atomic::{AtomicU32, Ordering};

use leptos::prelude::*;
use leptos::wasm_bindgen::JsCast;
use web_sys::{Element, HtmlElement, MouseEvent};

/// Between the button and what it opens, CSS pixels.
const GAP: f64 = 4.0;

/// A button with `label`; `name` is what a screen reader calls what it opens.
#[component]
pub(super) fn Popover(
    #[prop(into)] label: ViewFn,
    #[prop(into)] name: String,
    /// Classes of the button.
    #[prop(default = "tool")]
    class: &'static str,
    /// Called when it opens, with `true`, and when it closes.
    #[prop(optional, into)]
    on_toggle: Option<Callback<bool>>,
    children: Children,
) -> impl IntoView {
    static NEXT: AtomicU32 = AtomicU32::new(0);
    let id = format!("popover-{}", NEXT.fetch_add(1, Ordering::Relaxed));
    let opened = NodeRef::<leptos::html::Div>::new();
    let place = move |event: MouseEvent| {
        let button = event.current_target();
        let button = button.and_then(|button| button.dyn_into::<HtmlElement>().ok());
        if let (Some(button), Some(opened)) = (button, opened.get_untracked()) {
            beside(&button, &opened);
        }
    };
    view! {
        <button type="button" class=class popovertarget=id.clone() on:click=place>
            {label.run()}
            <span class="caret" aria-hidden="true"></span>
        </button>
        <div class="popover" popover="auto" id=id role="group" aria-label=name node_ref=opened
            on:toggle=move |_| {
                if let (Some(call), Some(opened)) = (on_toggle, opened.get_untracked()) {
                    call.run(opened.matches(":popover-open").unwrap_or(false));
                }
            }>
            {children()}
        </div>
    }
}

/// Whether anything is open that Escape would close.
pub(super) fn is_open() -> bool {
    let open = document().query_selector(":popover-open");
    open.is_ok_and(|open| open.is_some())
}

/// Closes what the chosen item is in.
pub(super) fn close(event: MouseEvent) {
    let target = event
        .target()
        .and_then(|target| target.dyn_into::<Element>().ok());
    let popover = target.and_then(|target| target.closest("[popover]").ok().flatten());
    if let Some(popover) = popover.and_then(|popover| popover.dyn_into::<HtmlElement>().ok()) {
        // One that is closed already stays closed.
        let _ = popover.hide_popover();
    }
}

/// Puts what is opened under or over its button, whichever has more room.
fn beside(button: &HtmlElement, opened: &HtmlElement) {
    let around = button.get_bounding_client_rect();
    let size = |value: Result<leptos::wasm_bindgen::JsValue, _>| {
        value.ok().and_then(|v| v.as_f64()).unwrap_or_default()
    };
    let (width, height) = (size(window().inner_width()), size(window().inner_height()));
    let right = around.left() + around.right() > width;
    let below = around.top() + around.bottom() < height;
    let distances = [
        ("left", (!right).then(|| around.left())),
        ("right", right.then(|| width - around.right())),
        ("top", below.then(|| around.bottom() + GAP)),
        ("bottom", (!below).then(|| height - around.top() + GAP)),
    ];
    for (edge, distance) in distances {
        let distance = distance.map_or_else(|| "auto".to_owned(), |css| format!("{css}px"));
        // Left where the browser has it, it can be used all the same.
        let _ = opened.style().set_property(edge, &distance);
    }
}
