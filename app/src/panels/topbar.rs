//! The top bar: run, stop, power, speed.

use leptos::prelude::*;

use crate::protocol::{Speed, ToWorker};
use crate::state::{Device, Store, words};

/// What can be chosen, and how it reads.
const SPEEDS: [(Speed, &str); 8] = [
    (Speed::Times(0.01), "0.01\u{d7}"),
    (Speed::Times(0.1), "0.1\u{d7}"),
    (Speed::Times(0.5), "0.5\u{d7}"),
    (Speed::Times(1.0), "1\u{d7}"),
    (Speed::Times(2.0), "2\u{d7}"),
    (Speed::Times(10.0), "10\u{d7}"),
    (Speed::Times(100.0), "100\u{d7}"),
    (Speed::Max, "max"),
];

/// The top bar.
#[component]
pub(super) fn TopBar(store: Store) -> impl IntoView {
    let name = Memo::new(move |_| store.device.with(|device| device.name.clone()));
    let on = Memo::new(move |_| store.device.with(Device::is_on));
    // A press of the mouse does not take the keyboard from where the user types.
    let keep_focus = |event: web_sys::MouseEvent| event.prevent_default();
    view! {
        <header class="topbar" on:mousedown=move |event| {
            if !is_select(&event) { keep_focus(event) }
        }>
            <h1 class="brand">"Motion"<span>"bench"</span></h1>
            <span class="chip controller">{name}</span>
            <button type="button" class="button primary" disabled=move || !on.get()
                title="Types RUN on the console"
                on:click=move |_| store.send(ToWorker::Run)>
                <span class="icon run" aria-hidden="true"></span>"Run"
            </button>
            <button type="button" class="button" disabled=move || !on.get()
                title="Sends Ctrl-C to the console"
                on:click=move |_| store.send(ToWorker::Stop)>
                <span class="icon stop" aria-hidden="true"></span>"Stop"
            </button>
            <button type="button" class="button power" role="switch"
                aria-checked=move || on.get().to_string()
                on:click=move |_| store.send(ToWorker::Power(!on.get()))>
                <span class="lamp" aria-hidden="true"></span>
                "Power"
                <span class="muted state" aria-hidden="true">{move || if on.get() { "on" } else { "off" }}</span>
            </button>
            <SpeedChoice store />
        </header>
    }
}

fn is_select(event: &web_sys::MouseEvent) -> bool {
    use leptos::wasm_bindgen::JsCast;
    let target = event
        .target()
        .and_then(|target| target.dyn_into::<web_sys::Element>().ok());
    target.is_some_and(|target| target.closest("select").is_ok_and(|found| found.is_some()))
}

/// The speed asked for and the one reached.
#[component]
fn SpeedChoice(store: Store) -> impl IntoView {
    let reached = Memo::new(move |_| words::speed(store.device.with(|device| device.reached)));
    let choose = move |event| {
        let chosen = event_target_value(&event);
        if let Some((speed, _)) = SPEEDS.iter().find(|(_, label)| *label == chosen) {
            store.send(ToWorker::Speed(*speed));
        }
    };
    let options = SPEEDS.map(|(speed, label)| {
        let selected = move || store.device.with(|device| device.speed == speed);
        view! { <option value=label prop:selected=selected>{label}</option> }
    });
    view! {
        <label class="speed">
            <span class="muted">"Speed"</span>
            <select class="select" aria-label="Simulation speed" on:change=choose>{options}</select>
            <span class="muted reached">"reached "<span class="figures">{reached}</span></span>
        </label>
    }
}
