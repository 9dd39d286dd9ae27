//! Inputs and outputs: switches, lamps, and the state of the drive.

use leptos::prelude::*;

use crate::state::wiring::{self, Drive, INPUTS, OUTPUTS};
use crate::state::{Device, Store};

/// Switches and lamps.
#[component]
pub(super) fn Io(store: Store) -> impl IntoView {
    let lit = Memo::new(move |_| {
        let on = store.device.with(Device::is_on);
        let image = store.with_scope(|scope| scope.now("outputs"));
        image.filter(|_| on).unwrap_or_default()
    });
    let inputs = (0..INPUTS).map(|input| view! { <Switch store input /> });
    let outputs = (0..OUTPUTS).map(|output| {
        let on = Memo::new(move |_| wiring::is_on(lit.get(), output));
        view! {
            <li class="point" class:on=on>
                <span class="bulb" aria-hidden="true">{output}</span>
                <span class="unseen">
                    {move || format!("output {output} {}", if on.get() { "on" } else { "off" })}
                </span>
            </li>
        }
    });
    view! {
        <div class="io" role="group" aria-label="Inputs and outputs">
            <div class="points">
                <h3>"In"<span class="unseen">"puts"</span></h3>
                <ul>{inputs.collect_view()}</ul>
            </div>
            <div class="points">
                <h3>"Out"<span class="unseen">"puts"</span></h3>
                <ul>{outputs.collect_view()}</ul>
            </div>
        </div>
    }
}

/// The switch at an input.
#[component]
fn Switch(store: Store, input: u8) -> impl IntoView {
    let on = Memo::new(move |_| store.wiring.with(|wiring| wiring.is_on(input)));
    let name = wiring::input_name(input);
    let label = match input {
        wiring::ENABLE => "Input 12, ENABLE of the drive".to_owned(),
        _ => format!("Input {input}"),
    };
    view! {
        <li>
            <button type="button" class="point" class:on=on role="switch" aria-label=label
                aria-checked=move || on.get().to_string()
                on:click=move |_| store.send(wiring::switch(input, !on.get_untracked()))>
                <span class="slide" aria-hidden="true"></span>
                <span aria-hidden="true">{name}</span>
            </button>
        </li>
    }
}

/// What the drive does, in words.
#[component]
pub(super) fn DriveState(store: Store) -> impl IntoView {
    let drive = Memo::new(move |_| {
        let (stopped, enable) = store
            .wiring
            .with(|w| (w.is_stopped(), w.is_on(wiring::ENABLE)));
        store.device.with(|device| device.drive(stopped, enable))
    });
    view! {
        <p class="drive" role="status"
            class:enabled=move || drive.with(|d| *d == Drive::Enabled)
            class:failed=move || drive.with(|d| matches!(d, Drive::Fault(_) | Drive::Stopped))>
            "Drive "<strong>{move || drive.with(Drive::words)}</strong>
        </p>
    }
}
