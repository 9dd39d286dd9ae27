//! The picture under fingers, mouse and keys.

use leptos::html;
use leptos::prelude::*;
use web_sys::{HtmlDivElement, KeyboardEvent, PointerEvent, WheelEvent};

use super::Sheets;
use crate::state::Store;
use crate::state::scope::{Follow, Moved, Scope, Touches};

/// A key or a notch of the wheel changes the time that is shown by this, or moves it by this part.
const ZOOM: f64 = 1.25;
const PAN: f64 = 0.1;
/// What browsers call a notch of the wheel, pixels.
const NOTCH: f64 = 100.0;

/// Lies over all plots, and holds the cursors.
#[component]
pub(super) fn Plots(store: Store, over: NodeRef<html::Div>, children: Children) -> impl IntoView {
    let touches = StoredValue::new(Touches::default());
    let held = RwSignal::new(false);
    let down = move |event: PointerEvent| {
        let Some(element) = over.get_untracked() else {
            return;
        };
        if event.button() == 0 {
            // Without it a finger that leaves is lost, and comes back as another.
            let _ = element.set_pointer_capture(event.pointer_id());
            touches.update_value(|t| t.down(event.pointer_id(), place(&element, event.client_x())));
            held.set(true);
        }
    };
    let moved = move |event: PointerEvent| {
        let Some(element) = over.get_untracked() else {
            return;
        };
        let to = place(&element, event.client_x());
        let moved = touches.try_update_value(|touches| touches.moved(event.pointer_id(), to));
        if let Some(moved) = moved.flatten() {
            store.change_scope(|scope| follow_fingers(scope, moved));
        }
    };
    let up = move |event: PointerEvent| {
        touches.update_value(|touches| touches.up(event.pointer_id()));
        held.set(false);
    };
    let wheel = move |event: WheelEvent| {
        let Some(element) = over.get_untracked() else {
            return;
        };
        event.prevent_default();
        let at = place(&element, event.client_x());
        store.change_scope(|scope| turn(scope, &event, at));
    };
    let again = move |_| store.change_scope(follow_again);
    view! {
        <div class="plots" class:held=held node_ref=over tabindex="0" role="group"
            aria-label="Plots: plus and minus zoom, arrow keys move, Home follows the axis again"
            on:pointerdown=down on:pointermove=moved on:pointerup=up on:pointercancel=up
            on:wheel=wheel on:dblclick=again
            on:keydown=move |event| {
                if event.target() == event.current_target() && key(store, &event) {
                    event.prevent_default();
                }
            }>
            {children()}
        </div>
    }
}

/// The way back, while the picture shows what the user chose.
#[component]
pub(super) fn Again(store: Store) -> impl IntoView {
    let lost = Sheets::choice(store, |scope| {
        scope.follows() == Follow::Nothing && !scope.is_paused()
    });
    view! {
        <Show when=move || lost.get()>
            <button type="button" class="again" on:click=move |_| store.change_scope(follow_again)>
                "Follow the axis"
            </button>
        </Show>
    }
}

fn follow_again(scope: &mut Scope) {
    scope.follow(Follow::Motion);
}

/// A place of the screen as a part of the plots' width.
pub(super) fn place(element: &HtmlDivElement, client_x: i32) -> f64 {
    let around = element.get_bounding_client_rect();
    (f64::from(client_x) - around.left()) / around.width().max(1.0)
}

fn follow_fingers(scope: &mut Scope, moved: Moved) {
    if moved.pan != 0.0 {
        scope.pan(moved.pan);
    }
    if moved.zoom != 1.0 {
        scope.zoom(moved.zoom, moved.place);
    }
}

/// The wheel zooms; with Shift, or turned sideways, it moves.
fn turn(scope: &mut Scope, event: &WheelEvent, at: f64) {
    let unit = match event.delta_mode() {
        WheelEvent::DOM_DELTA_PIXEL => 1.0,
        _ => NOTCH / 3.0,
    };
    let (sideways, down) = (
        event.delta_x() * unit / NOTCH,
        event.delta_y() * unit / NOTCH,
    );
    if event.shift_key() || sideways.abs() > down.abs() {
        let most = if sideways.abs() > down.abs() {
            sideways
        } else {
            down
        };
        scope.pan(most * PAN);
    } else if down != 0.0 {
        scope.zoom(ZOOM.powf(down.clamp(-3.0, 3.0)), at);
    }
}

/// Whether the key means something to the picture.
fn key(store: Store, event: &KeyboardEvent) -> bool {
    if event.ctrl_key() || event.alt_key() || event.meta_key() {
        return false;
    }
    let part = if event.shift_key() { 1.0 } else { PAN };
    match event.key().as_str() {
        "+" | "=" | "ArrowUp" => store.change_scope(|scope| scope.zoom(1.0 / ZOOM, 0.5)),
        "-" | "_" | "ArrowDown" => store.change_scope(|scope| scope.zoom(ZOOM, 0.5)),
        "ArrowLeft" => store.change_scope(|scope| scope.pan(-part)),
        "ArrowRight" => store.change_scope(|scope| scope.pan(part)),
        "PageUp" => store.change_scope(|scope| scope.pan(-1.0)),
        "PageDown" => store.change_scope(|scope| scope.pan(1.0)),
        "Home" => store.change_scope(follow_again),
        "End" => store.change_scope(|scope| scope.follow(Follow::Newest)),
        " " => store.change_scope(|scope| scope.pause(!scope.is_paused())),
        _ => return false,
    }
    true
}
