//! The top bar: run, stop, pause, step, power, speed, and what helps with them.

use leptos::ev;
use leptos::prelude::*;
use motionbench_core::controller::FirstStep;
use web_sys::KeyboardEvent;

use super::controller::ControllerChoice;
use super::dialog::Dialog;
use super::estop::EStop;
use super::frame;
use super::front;
use super::project::ProjectMenu;
use super::terminal::ESCAPE;
use crate::protocol::{Speed, ToWorker};
use crate::state::keys::{Press, Shortcut, shortcut};
use crate::state::layout::Panel;
use crate::state::{Device, Store, words};
use crate::storage::Keeper;

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
pub(super) fn TopBar(store: Store, keeper: Keeper) -> impl IntoView {
    let help = RwSignal::new(false);
    let listener = window_event_listener(ev::keydown, move |event| press(store, &event));
    on_cleanup(move || listener.remove());
    view! {
        <header class="topbar">
            <h1 class="brand">"Motion"<span>"bench"</span></h1>
            <ProjectMenu store keeper />
            <ControllerChoice store keeper />
            <Program store />
            <Power store />
            <SpeedChoice store />
            <button type="button" class="button help" on:click=move |_| help.set(true)>"Help"</button>
            <EStop store />
        </header>
        <Dialog open=help title="Help"><Help store /></Dialog>
    }
}

/// A key that does the same wherever the keyboard is.
fn press(store: Store, event: &KeyboardEvent) {
    let key = event.key();
    let press = Press {
        key: &key,
        ctrl: event.ctrl_key(),
        shift: event.shift_key(),
        other: event.alt_key() || event.meta_key(),
        selection: false,
    };
    let Some(shortcut) = shortcut(press) else {
        return;
    };
    event.prevent_default();
    if event.repeat() && shortcut != Shortcut::Step {
        return;
    }
    let device = |ask: fn(&Device) -> bool| store.device.with_untracked(ask);
    match shortcut {
        Shortcut::Run if device(Device::is_on) => run(store),
        Shortcut::Stop if device(Device::is_on) => store.send(ToWorker::Stop),
        Shortcut::Pause => store.freeze(),
        Shortcut::Step if device(Device::can_step) => store.step(),
        _ => {}
    }
}

/// Starts the program, and where only the program is in sight shows what it does.
fn run(store: Store) {
    store.run();
    if frame::is_narrow() && untrack(|| frame::shown(store)) == Panel::Program {
        let has_front = untrack(|| store.kind().face.is_some());
        let panel = if has_front {
            Panel::Front
        } else {
            Panel::Terminal
        };
        store.layout.update(|layout| layout.show(panel));
    }
}

/// What starts and stops the program, and holds it.
#[component]
fn Program(store: Store) -> impl IntoView {
    let off = Memo::new(move |_| store.device.with(|device| !device.is_on()));
    let frozen = Memo::new(move |_| store.device.with(|device| device.frozen));
    let cannot_step = Memo::new(move |_| store.device.with(|device| !device.can_step()));
    view! {
        <button type="button" class="button primary" disabled=off
            title="Loads the program and starts it from the console (F5)" on:click=move |_| run(store)>
            <span class="icon run" aria-hidden="true"></span>"Run"
        </button>
        <div class="group" role="group" aria-label="The program that runs">
            <button type="button" class="button stop" disabled=off
                title="Interrupts the controller (Shift+F5)" on:click=move |_| store.send(ToWorker::Stop)>
                <span class="icon stop" aria-hidden="true"></span>"Stop"
            </button>
            <button type="button" class="button pause" class:held=frozen
                title=move || if frozen.get() { "Simulated time goes on (F2)" } else { "Freezes simulated time (F2)" }
                on:click=move |_| store.freeze()>
                {move || if frozen.get() { "Continue" } else { "Pause" }}
            </button>
            <button type="button" class="button step" disabled=cannot_step
                title="Runs one statement, then freezes simulated time (F10)"
                on:click=move |_| store.step()>
                "Step"
            </button>
        </div>
    }
}

/// The mains switch.
#[component]
fn Power(store: Store) -> impl IntoView {
    let on = Memo::new(move |_| store.device.with(Device::is_on));
    view! {
        <button type="button" class="button power" role="switch" aria-checked=move || on.get().to_string()
            title="The mains switch of the controller"
            on:click=move |_| store.send(ToWorker::Power(!on.get()))>
            <span class="lamp" aria-hidden="true"></span>
            "Power"
            <span class="muted state" aria-hidden="true">{move || if on.get() { "on" } else { "off" }}</span>
        </button>
    }
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
        <div class="speed">
            <select class="select" aria-label="Simulation speed" title="Simulated seconds in a second"
                on:change=choose>{options}</select>
            <span class="muted reached"><span class="word">"reached "</span><span class="figures">{reached}</span></span>
        </div>
    }
}

/// What is what, and the keys.
#[component]
fn Help(store: Store) -> impl IntoView {
    let kind = store.kind();
    let keys = [
        ("F5", "Run the program"),
        ("Shift+F5", "Stop it"),
        ("F2", "Freeze simulated time, or let it go on"),
        ("F10", "Run one statement"),
        ("F9", "In the program: set a breakpoint, or take it away"),
        ("F8", "In the program: go to the next problem"),
        (
            "Page Up, Page Down",
            "In the terminal: what was printed before and after",
        ),
        (
            "Arrow keys, Enter",
            "On a divider between two panels: move it, fold the panel away",
        ),
        (
            "Tab, Shift+Tab",
            "Go to the next part of the page, and back",
        ),
    ];
    let row = |(key, what)| view! { <dt><kbd>{key}</kbd></dt><dd>{what}</dd> };
    let step = |step: &FirstStep| {
        match *step {
        FirstStep::Type(line, what) => {
            // A key, not a character of the line.
            let escape = line.contains(ESCAPE).then(|| view! { <kbd>"Esc"</kbd>" " });
            let rest = line.replace(ESCAPE, "");
            view! { <li><code>{escape}{rest}</code><span>{what}</span></li> }.into_any()
        }
        FirstStep::PowerCycle => {
            view! { <li><strong>"Power"</strong><span>"press it twice: off, and on again"</span></li> }.into_any()
        }
    }
    };
    view! {
        <div class="dialog-body">
            <p>"The controller is simulated in this page, and keeps its own program. Run gives it the program that you see
                and starts it."</p>
            <p>"The terminal is its console: what you type there goes to the controller, character by character."</p>
            <p>"The scope draws what the axis does."</p>
            {kind.face.map(|face| view! { <front::Help face /> })}
            <h3>"A program of your own, typed in the terminal"</h3>
            <ol class="steps-help">{kind.first_steps.iter().map(step).collect_view()}</ol>
            <h3>"Keys"</h3>
            <dl class="keys-help">{keys.map(row)}</dl>
        </div>
    }
}
