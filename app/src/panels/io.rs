//! Inputs and outputs: switches, knobs, lamps, and the state of the drive.

use std::time::Duration;

use leptos::prelude::*;
use motionbench_core::controller::{Handle, Range, Wired};

use super::draw;
use super::popover::Popover;
use crate::state::wiring::{self, Drive, Wiring};
use crate::state::{Device, Store, words};

/// So long a pulse is seen.
const STROBE: Duration = Duration::from_millis(200);

/// Switches and lamps of the controller on the bench.
#[component]
pub(super) fn Io(store: Store) -> impl IntoView {
    let kind = Memo::new(move |_| store.kind().id);
    move || {
        // Read, not only tracked: a memo that nobody reads is not computed.
        kind.get();
        let inputs = store
            .wiring
            .with_untracked(Wiring::inputs)
            .iter()
            .enumerate();
        let switches = inputs
            .clone()
            .filter(|(_, input)| matches!(input.handle, Handle::Switch | Handle::Pin(_)))
            .map(|(place, input)| view! { <Switch store place input /> });
        let has_knobs = inputs
            .clone()
            .any(|(_, input)| input.handle != Handle::Switch);
        view! {
            <div class="io" role="group" aria-label="Inputs and outputs">
                <div class="points">
                    <h3>"In"<span class="unseen">"puts"</span></h3>
                    <ul>{switches.collect_view()}</ul>
                </div>
                {has_knobs.then(|| view! { <Knobs store /> })}
                <Lamps store />
            </div>
        }
    }
}

/// The lamps at the outputs.
#[component]
fn Lamps(store: Store) -> impl IntoView {
    let lamps = untrack(|| store.kind().lamps);
    let lit = Memo::new(move |_| {
        let on = store.device.with(Device::is_on);
        let image = store.with_scope(|scope| scope.now(lamps.signal));
        image.filter(|_| on).unwrap_or_default()
    });
    let lamp = |(bit, label): (u8, &'static str)| {
        let on = Memo::new(move |_| wiring::is_on(lit.get(), bit));
        view! {
            <li class="point" class:on=on>
                <span class="bulb" aria-hidden="true">{label.trim_start_matches('M')}</span>
                <span class="unseen">
                    {move || format!("output {label} {}", if on.get() { "on" } else { "off" })}
                </span>
            </li>
        }
    };
    view! {
        <div class="points">
            <h3>"Out"<span class="unseen">"puts"</span></h3>
            <ul>
                {(0..).zip(lamps.labels.iter().copied()).map(lamp).collect_view()}
                {lamps.strobe.map(|_| view! { <Strobe store /> })}
            </ul>
        </div>
    }
}

/// The lamp at the strobe. Its pulse is too short to be seen: the lamp stays on for a moment.
#[component]
fn Strobe(store: Store) -> impl IntoView {
    let on = RwSignal::new(false);
    let dark = draw::after(STROBE, move || {
        on.try_set(false);
    });
    Effect::new(move |before: Option<u64>| {
        let strobes = store.strobes.get();
        if before.is_some_and(|before| before != strobes) {
            on.set(true);
            dark();
        }
        strobes
    });
    view! {
        <li class="point strobe" class:on=on title="The strobe of the outputs">
            <span class="bulb" aria-hidden="true">"S"</span>
        </li>
    }
}

/// The switch at an input.
#[component]
fn Switch(store: Store, place: usize, input: &'static Wired) -> impl IntoView {
    let on = Memo::new(move |_| store.wiring.with(|wiring| wiring.is_on(place)));
    let switch = move |_| {
        if let Some(message) = store.wiring.with_untracked(|wiring| wiring.switch(place)) {
            store.send(message);
        }
    };
    view! {
        <li>
            <button type="button" class="point" class:on=on role="switch" aria-label=input.name
                aria-checked=move || on.get().to_string() on:click=switch>
                <span class="slide" aria-hidden="true"></span>
                <span aria-hidden="true">{input.label}</span>
            </button>
        </li>
    }
}

/// What can be turned, in a popover.
#[component]
fn Knobs(store: Store) -> impl IntoView {
    let inputs = store
        .wiring
        .with_untracked(Wiring::inputs)
        .iter()
        .enumerate();
    let knob = move |(place, input): (usize, &'static Wired)| match input.handle {
        Handle::Switch => ().into_any(),
        Handle::Knob(range) | Handle::Pin(range) => {
            view! { <Knob store place input range /> }.into_any()
        }
        Handle::Jog(steps) => view! { <Jog store place input steps /> }.into_any(),
    };
    let knobs: Vec<_> = inputs.collect();
    view! {
        <Popover label=|| "Knobs" name="Knobs at the inputs">
            <div class="knobs">
                {knobs.iter().copied().map(knob).collect_view()}
            </div>
        </Popover>
    }
}

/// What is pushed by steps.
#[component]
fn Jog(store: Store, place: usize, input: &'static Wired, steps: &'static [f64]) -> impl IntoView {
    let button = move |&step: &f64| {
        let push = move |_| {
            let message = store
                .wiring
                .with_untracked(|wiring| wiring.turn(place, step));
            if let Some(message) = message {
                store.send(message);
            }
        };
        let sign = if step > 0.0 { "+" } else { "" };
        view! {
            <button type="button" class="button figures" on:click=push>{sign}{words::number(step, 0)}</button>
        }
    };
    view! {
        <div class="knob" role="group" aria-label=input.name>
            <span aria-hidden="true">{input.name}</span>
            <div class="jog">{steps.iter().map(button).collect_view()}</div>
        </div>
    }
}

/// A knob with its value.
#[component]
fn Knob(store: Store, place: usize, input: &'static Wired, range: Range) -> impl IntoView {
    let value = Memo::new(move |_| store.wiring.with(|wiring| wiring.value(place)));
    let turn = move |event| {
        let turned = event_target_value(&event).parse();
        let message = turned.ok().and_then(|value| {
            store
                .wiring
                .with_untracked(|wiring| wiring.turn(place, value))
        });
        if let Some(message) = message {
            store.send(message);
        }
    };
    let digits = if range.step < 1.0 { 2 } else { 0 };
    let said = move || {
        format!(
            "{}\u{202f}{}",
            words::number(value.get(), digits),
            range.unit
        )
    };
    view! {
        <label class="knob">
            <span>{input.name}</span>
            <input type="range" min=range.from max=range.to step=range.step aria-valuetext=said
                prop:value=move || value.get() on:input=turn />
            <span class="figures">{said}</span>
        </label>
    }
}

/// What the drive does, in words.
#[component]
pub(super) fn DriveState(store: Store) -> impl IntoView {
    let drive = Memo::new(move |_| {
        let enable = store.kind().enable_input;
        let (stopped, enable) = store
            .wiring
            .with(|w| (w.is_stopped(), enable.is_none_or(|input| w.is_on(input))));
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
