//! The frame around the panels: where they stand, the dividers between them, and what folds them away.

use leptos::ev;
use leptos::html;
use leptos::prelude::*;
use leptos::wasm_bindgen::JsCast;
use web_sys::{Element, KeyboardEvent, PointerEvent};

use super::{editor, scope, terminal};
use crate::state::Store;
use crate::state::layout::{Divider, LEAST, Layout, MOST, Panel, STEP};
use crate::storage::Keeper;

/// Where there is room for one panel alone, as in the style sheet.
const NARROW: &str = "(max-width: 43.75rem)";

/// What a press of the mouse uses without taking the keyboard to it, from where the user types.
const ONLY_PRESSED: &str = "button, .topbar, .panel-head";
/// What needs the mouse as it is.
const USED: &str = "select, input, textarea, a";

/// Has buttons leave the keyboard where it is when the mouse presses them.
fn keep_keyboard() {
    let listener = window_event_listener(ev::mousedown, |event| {
        let target = event
            .target()
            .and_then(|target| target.dyn_into::<Element>().ok());
        let within = |what| {
            let found = target.as_ref().and_then(|target| target.closest(what).ok());
            found.flatten().is_some()
        };
        if within(ONLY_PRESSED) && !within(USED) {
            event.prevent_default();
        }
    });
    on_cleanup(move || listener.remove());
}

/// Whether there is room for one panel alone.
pub(super) fn is_narrow() -> bool {
    let query = window().match_media(NARROW).ok().flatten();
    query.is_some_and(|query| query.matches())
}

/// The panels.
#[component]
pub(super) fn Frame(store: Store, keeper: Keeper) -> impl IntoView {
    let main = NodeRef::<html::Main>::new();
    keep_keyboard();
    // As CSS numbers: the shares of what stands before a divider and of what stands behind it.
    let share = move |divider| store.layout.with(|layout| layout.share(divider));
    let before = move |divider| share(divider).to_string();
    let behind = move |divider| (1000 - share(divider)).to_string();
    view! {
        <main class="workshop" node_ref=main data-shown=move || store.layout.with(Layout::shown).name()
            style:--program=move || before(Divider::Program) style:--bench=move || behind(Divider::Program)
            style:--terminal=move || before(Divider::Terminal) style:--scope=move || behind(Divider::Terminal)>
            <Cell store panel=Panel::Program><editor::Editor store read_only=Signal::derive(move || keeper.is_read_only()) /></Cell>
            <DividerView store divider=Divider::Program main />
            <div class="bench">
                <Cell store panel=Panel::Terminal><terminal::Terminal store /></Cell>
                <DividerView store divider=Divider::Terminal main />
                <Cell store panel=Panel::Scope><scope::Scope store /></Cell>
            </div>
        </main>
    }
}

fn is_folded(store: Store, panel: Panel) -> bool {
    store.layout.with(|layout| layout.is_folded(panel))
}

/// The place of a panel. Folded away, the panel stays as it is, out of sight.
#[component]
fn Cell(store: Store, panel: Panel, children: Children) -> impl IntoView {
    let folded = Memo::new(move |_| is_folded(store, panel));
    let title = panel.title();
    let verb = move || if folded.get() { "Show" } else { "Fold" };
    let fold = move |_| {
        store
            .layout
            .update(|layout| layout.fold(panel, !folded.get_untracked()))
    };
    view! {
        <div class=format!("cell {}-cell", panel.name()) class:folded=folded>
            <div class="content">{children()}</div>
            <button type="button" class="fold" aria-expanded=move || (!folded.get()).to_string()
                aria-label=move || format!("{} {title}", verb()) title=move || format!("{} {title}", verb())
                on:click=fold>
                <span class="chevron" aria-hidden="true"></span>
                <span class="fold-title">{title}</span>
            </button>
        </div>
    }
}

/// What parts two panels: dragged, or moved by the arrow keys; Enter folds, a double click puts it back.
#[component]
fn DividerView(store: Store, divider: Divider, main: NodeRef<html::Main>) -> impl IntoView {
    let upright = divider == Divider::Program;
    let (label, orientation, panel) = match divider {
        Divider::Program => ("Width of the program", "vertical", Panel::Program),
        Divider::Terminal => ("Height of the terminal", "horizontal", Panel::Terminal),
    };
    let share = Memo::new(move |_| store.layout.with(|layout| layout.share(divider)));
    let put = move |share| {
        store
            .layout
            .update(|layout| layout.move_divider(divider, share))
    };
    let drag = move |event: PointerEvent| {
        let Some(main) = main.get_untracked().filter(|_| event.buttons() & 1 == 1) else {
            return;
        };
        let room = main.get_bounding_client_rect();
        let part = if upright {
            (f64::from(event.client_x()) - room.left()) / room.width()
        } else {
            (f64::from(event.client_y()) - room.top()) / room.height()
        };
        // A share is clamped; outside the page it is the nearest.
        put((part.clamp(0.0, 1.0) * 1000.0) as u16);
    };
    let take = move |event: PointerEvent| {
        let target = event
            .target()
            .and_then(|target| target.dyn_into::<Element>().ok());
        if let Some(target) = target {
            // Without it, the pointer must stay on the divider.
            let _ = target.set_pointer_capture(event.pointer_id());
        }
    };
    let key = move |event: KeyboardEvent| {
        let (less, more) = if upright {
            ("ArrowLeft", "ArrowRight")
        } else {
            ("ArrowUp", "ArrowDown")
        };
        match event.key().as_str() {
            key if key == less => put(share.get_untracked().saturating_sub(STEP)),
            key if key == more => put(share.get_untracked() + STEP),
            "Home" => put(LEAST),
            "End" => put(MOST),
            "Enter" => store
                .layout
                .update(|layout| layout.fold(panel, !layout.is_folded(panel))),
            _ => return,
        }
        event.prevent_default();
    };
    view! {
        <div class=format!("divider {orientation}") role="separator" tabindex="0" aria-label=label
            aria-orientation=orientation aria-valuemin=LEAST / 10 aria-valuemax=MOST / 10
            aria-valuenow=move || share.get() / 10 title=format!("{label}: drag, or arrow keys; Enter folds")
            on:pointerdown=take on:pointermove=drag on:keydown=key
            on:dblclick=move |_| put(divider.usual())></div>
    }
}

/// Where there is room for one panel alone: which it is.
#[component]
pub(super) fn Tabs(store: Store) -> impl IntoView {
    let shown = Memo::new(move |_| store.layout.with(Layout::shown));
    let tab = move |panel: Panel| {
        let current = move || (shown.get() == panel).then_some("true");
        let show = move |_| store.layout.update(|layout| layout.show(panel));
        view! {
            <button type="button" class="tab" aria-current=current
                on:click=show>
                {panel.title()}
            </button>
        }
    };
    view! { <nav class="tabs" aria-label="Panels">{Panel::ALL.map(tab).collect_view()}</nav> }
}
