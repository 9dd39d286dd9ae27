//! The joystick: pulled by a finger, pushed by arrow keys, and back in the middle when let go.

use leptos::ev;
use leptos::html;
use leptos::prelude::*;
use motionbench_core::controller::Joystick as Stick;
use web_sys::{KeyboardEvent, PointerEvent};

use crate::protocol::ToWorker;
use crate::state::{Store, words};

/// The middle of it, in which it gives nothing.
const DEAD: f64 = 0.06;

/// The stick and its button.
#[component]
pub(super) fn Joystick(store: Store, stick: Stick) -> impl IntoView {
    let [x, y, button] = stick.wires;
    // Of the whole way, to the right and up.
    let at = RwSignal::new((0.0_f64, 0.0_f64));
    let keys = RwSignal::new(Vec::<String>::new());
    let base = NodeRef::<html::Div>::new();
    let wire = move |name: &str, value: f64| {
        store.send(ToWorker::Wire {
            name: name.to_owned(),
            value,
        });
    };
    let put = move |to: (f64, f64)| {
        let before = at.get_untracked();
        at.set(to);
        let value = |part: f64| (part * stick.most).round();
        for (name, before, to) in [(x, before.0, to.0), (y, before.1, to.1)] {
            if value(before) != value(to) {
                wire(name, value(to));
            }
        }
    };
    let let_go = move || {
        keys.set(Vec::new());
        put((0.0, 0.0));
    };
    let pull = move |event: PointerEvent| {
        let Some(base) = base.get_untracked().filter(|_| event.buttons() & 1 == 1) else {
            return;
        };
        let room = base.get_bounding_client_rect();
        let part =
            |at: i32, from: f64, room: f64| ((f64::from(at) - from) / room * 2.0 - 1.0) * 1.25;
        let right = part(event.client_x(), room.left(), room.width());
        let down = part(event.client_y(), room.top(), room.height());
        put((notched(right), notched(-down)));
    };
    let take = move |event: PointerEvent| {
        if let Some(base) = base.get_untracked() {
            // Without it, the stick goes back when the finger leaves it.
            let _ = base.set_pointer_capture(event.pointer_id());
        }
        pull(event);
    };
    let push = move || {
        let pushed = |key: &str| {
            f64::from(u8::from(
                keys.with_untracked(|keys| keys.iter().any(|k| k == key)),
            ))
        };
        put((
            pushed("ArrowRight") - pushed("ArrowLeft"),
            pushed("ArrowUp") - pushed("ArrowDown"),
        ));
    };
    let down = move |event: KeyboardEvent| {
        if event.key().starts_with("Arrow") {
            event.prevent_default();
            keys.update(|keys| {
                keys.retain(|key| *key != event.key());
                keys.push(event.key());
            });
            push();
        }
    };
    let up = move |event: KeyboardEvent| {
        keys.update(|keys| keys.retain(|key| *key != event.key()));
        push();
    };
    let blur = window_event_listener(ev::blur, move |_| let_go());
    let hidden = window_event_listener(ev::visibilitychange, move |_| let_go());
    on_cleanup(move || {
        blur.remove();
        hidden.remove();
        let_go();
    });
    let click = move |pressed: bool| wire(button, f64::from(u8::from(pressed)));
    let said = move || {
        let (right, up) = at.get();
        let value = |part: f64| words::number(part * stick.most, 0);
        format!("X {} Hz, Y {} Hz", value(right), value(up))
    };
    view! {
        <div class="joystick">
            <div class="stick-base" node_ref=base tabindex="0" role="group"
                aria-label="Joystick: arrow keys push it while they are held"
                on:pointerdown=take on:pointermove=pull on:pointerup=move |_| let_go()
                on:pointercancel=move |_| let_go() on:keydown=down on:keyup=up on:blur=move |_| let_go()>
                <span class="stick" style:--x=move || at.get().0.to_string() style:--y=move || (-at.get().1).to_string()></span>
            </div>
            <p class="figures muted">{said}</p>
            <button type="button" class="button" title="Clears the registers in a slew; ends one that a program asks for"
                on:pointerdown=move |_| click(true) on:pointerup=move |_| click(false)
                on:pointercancel=move |_| click(false) on:pointerleave=move |_| click(false)
                on:click=move |event| {
                    // From a keyboard or a screen reader.
                    if event.detail() == 0 {
                        click(true);
                        click(false);
                    }
                }>"Button"</button>
            <p class="muted">"After SLW it moves the axes at half its rate, or what F-n divides it by."</p>
        </div>
    }
}

/// Within its way, and at rest near the middle.
fn notched(part: f64) -> f64 {
    match part {
        part if part.abs() < DEAD || !part.is_finite() => 0.0,
        part => part.clamp(-1.0, 1.0),
    }
}
