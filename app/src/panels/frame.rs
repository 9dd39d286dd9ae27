//! The frame around the panels: where they stand, the dividers between them, and what folds them away.

use leptos::ev;
use leptos::html;
use leptos::prelude::*;
use leptos::wasm_bindgen::JsCast;
use web_sys::{Element, KeyboardEvent, PointerEvent};

use super::{editor, front, scope, terminal};
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
    let face = Memo::new(move |_| store.kind().id);
    let front = move || {
        face.get();
        untrack(|| store.kind().face).map(|face| view! { <front::Front store face /> })
    };
    let upper = move || upper_divider(store);
    let above = move || {
        (store.kind().face.is_some()).then(|| match store.layout.with(Layout::is_front_up) {
            true => "front",
            false => "terminal",
        })
    };
    view! {
        <main class="workshop" node_ref=main data-shown=move || shown(store).name() data-above=above
            style:--program=move || before(Divider::Program) style:--bench=move || behind(Divider::Program)
            style:--terminal=move || before(upper()) style:--scope=move || behind(upper())>
            <Cell store panel=Panel::Program><editor::Editor store read_only=Signal::derive(move || keeper.is_read_only()) /></Cell>
            <DividerView store upright=true main />
            <div class="bench">
                <Cell store panel=Panel::Terminal>{front}<terminal::Terminal store /></Cell>
                <DividerView store upright=false main />
                <Cell store panel=Panel::Scope><scope::Scope store /></Cell>
            </div>
        </main>
    }
}

/// The panel that is shown where there is room for one.
pub(super) fn shown(store: Store) -> Panel {
    let has_front = store.kind().face.is_some();
    store.layout.with(|layout| layout.shown(has_front))
}

/// What parts the panels on the right.
fn upper_divider(store: Store) -> Divider {
    match store.kind().face {
        Some(_) => Divider::Front,
        None => Divider::Terminal,
    }
}

fn is_folded(store: Store, panel: Panel) -> bool {
    store.layout.with(|layout| layout.is_folded(panel))
}

/// The place of a panel. Folded away, the panel stays as it is, out of sight.
#[component]
fn Cell(store: Store, panel: Panel, children: Children) -> impl IntoView {
    let folded = Memo::new(move |_| is_folded(store, panel));
    let title = move || match panel {
        Panel::Terminal if store.kind().face.is_some() => Panel::Front.title(),
        panel => panel.title(),
    };
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
                aria-label=move || format!("{} {}", verb(), title()) title=move || format!("{} {}", verb(), title())
                on:click=fold>
                <span class="chevron" aria-hidden="true"></span>
                <span class="fold-title">{title}</span>
            </button>
        </div>
    }
}

/// What parts two panels: dragged, or moved by the arrow keys; Enter folds, a double click puts it back.
#[component]
fn DividerView(store: Store, upright: bool, main: NodeRef<html::Main>) -> impl IntoView {
    let divider = Memo::new(move |_| match upright {
        true => Divider::Program,
        false => upper_divider(store),
    });
    let (orientation, panel) = match upright {
        true => ("vertical", Panel::Program),
        false => ("horizontal", Panel::Terminal),
    };
    let label = move || match divider.get() {
        Divider::Program => "Width of the program",
        Divider::Terminal => "Height of the terminal",
        Divider::Front => "Height of the panel",
    };
    let share = Memo::new(move |_| store.layout.with(|layout| layout.share(divider.get())));
    let put = move |share| {
        store
            .layout
            .update(|layout| layout.move_divider(divider.get_untracked(), share))
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
            aria-valuenow=move || share.get() / 10 title=move || format!("{}: drag, or arrow keys; Enter folds", label())
            on:pointerdown=take on:pointermove=drag on:keydown=key
            on:dblclick=move |_| put(divider.get_untracked().usual())></div>
    }
}

/// Where there is room for one panel alone: which it is.
#[component]
pub(super) fn Tabs(store: Store) -> impl IntoView {
    let shown = Memo::new(move |_| shown(store));
    let has_front = Memo::new(move |_| store.kind().face.is_some());
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
    let tabs = move || {
        let panels = Panel::ALL.into_iter();
        let there = panels.filter(|panel| *panel != Panel::Front || has_front.get());
        there.map(tab).collect_view()
    };
    view! { <nav class="tabs" aria-label="Panels">{tabs}</nav> }
}
