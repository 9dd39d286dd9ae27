//! A controller that is a device of its own: its front panel, the switches and jumpers, the printer at its line.

use leptos::prelude::*;
use motionbench_core::catalog;
use motionbench_core::controller::Face;

mod bus;
mod device;
mod hands;
mod joystick;
mod printer;
mod rear;
mod segments;

use crate::state::Store;
use crate::state::front;
use crate::state::layout::Panel;
use crate::state::recording::Recording;
use crate::storage::files;

/// What is shown of it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Side {
    Front,
    Rear,
    Printer,
    Bus,
}

/// What stands beside the device.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Tray {
    Joystick,
    Steps,
}

/// The panel of a controller that has a face.
#[component]
pub(super) fn Front(store: Store, face: &'static Face) -> impl IntoView {
    let side = RwSignal::new(Side::Front);
    let tray = RwSignal::new(None);
    let has_bus = Memo::new(move |_| store.device.with(|device| device.bus.is_some()));
    let shown = move || match side.get() {
        Side::Front => view! { <device::Device store face tray /> }.into_any(),
        Side::Rear => view! { <rear::Rear store face /> }.into_any(),
        Side::Printer => view! { <printer::Printer store /> }.into_any(),
        Side::Bus => view! { <bus::Bus store /> }.into_any(),
    };
    let tab = move |this: Side, title: &'static str| {
        let current = move || (side.get() == this).then_some("true");
        view! {
            <button type="button" class="side" aria-current=current on:click=move |_| side.set(this)>{title}</button>
        }
    };
    let tool = move |this: Tray, title: &'static str| {
        let pressed = move || (tray.get() == Some(this)).to_string();
        let turn =
            move |_| tray.update(|tray| *tray = Some(this).filter(|this| *tray != Some(*this)));
        view! {
            <button type="button" class="tool" aria-pressed=pressed on:click=turn>{title}</button>
        }
    };
    view! {
        <section class="panel front" aria-labelledby="front-title" class:typing=store.pressing>
            <header class="panel-head">
                <h2 id="front-title" class="unseen">"Front panel"</h2>
                <nav class="sides" aria-label="Sides of the controller">
                    {tab(Side::Front, "Front")}
                    {tab(Side::Rear, "Rear")}
                    {tab(Side::Printer, "Printer")}
                    <Show when=move || has_bus.get()>{tab(Side::Bus, "Bus")}</Show>
                    <button type="button" class="side to-terminal"
                        on:click=move |_| store.layout.update(|layout| layout.show(Panel::Terminal))>
                        "Terminal"
                    </button>
                </nav>
                <Show when=move || side.get() == Side::Front>
                    <div class="tools" role="group" aria-label="Beside the panel">
                        {tool(Tray::Steps, "First steps")}
                        {tool(Tray::Joystick, "Joystick")}
                        <Record store />
                    </div>
                </Show>
            </header>
            {shown}
        </section>
    }
}

/// Writes down what is pressed, for a file that presses it again.
#[component]
fn Record(store: Store) -> impl IntoView {
    let kept = Memo::new(move |_| {
        store
            .recording
            .with(|kept| kept.as_ref().map(Recording::len))
    });
    let turn = move |_| {
        let (now, unit) = store
            .device
            .with_untracked(|device| (device.now, device.unit));
        let Some(recording) = store.recording.get_untracked() else {
            return store.recording.set(Some(Recording::new(now, unit)));
        };
        store.recording.set(None);
        let kind = untrack(|| store.kind());
        let options = store.settings.with_untracked(front::options);
        let Ok(units) = catalog::units(kind.id, &options) else {
            return;
        };
        let text = recording.scenario(kind, &units, now);
        if files::save("keys.scenario", "text/plain", &text).is_err() {
            store
                .notice
                .set(Some("The browser refuses to save a file."));
        }
    };
    let label = move || match kept.get() {
        Some(count) => format!("Save {count} keys"),
        None => "Record keys".to_owned(),
    };
    view! {
        <button type="button" class="tool figures" aria-pressed=move || kept.get().is_some().to_string()
            title="Writes the keys that are pressed into a scenario, which the runner plays again" on:click=turn>
            {label}
        </button>
    }
}

/// The way from the terminal to the front panel, where there is one.
#[component]
pub(super) fn ToFront(store: Store) -> impl IntoView {
    let has_face = Memo::new(move |_| store.kind().face.is_some());
    view! {
        <Show when=move || has_face.get()>
            <nav class="sides" aria-label="Terminal or panel">
                <button type="button" class="side"
                    on:click=move |_| store.layout.update(|layout| layout.show(Panel::Front))>"Panel"</button>
                <button type="button" class="side" aria-current="true">"Terminal"</button>
            </nav>
        </Show>
    }
}

/// What help says of the panel.
#[component]
pub(super) fn Help(face: &'static Face) -> impl IntoView {
    let row = |(key, pressed): (&str, &'static str)| {
        view! { <dt><kbd>{hands::words(key)}</kbd></dt><dd>{pressed}</dd> }
    };
    view! {
        <h3>"A program of your own, by the keys of the front panel"</h3>
        <Steps face />
        <h3>"The front panel on the keyboard"</h3>
        <p>"While it has the keyboard, letters, digits and signs press the keys that bear them, without SHIFT.
            Two fingers may hold two keys. Other keys:"</p>
        <dl class="keys-help">{hands::NAMED.map(row)}</dl>
        <h3>"Several units"</h3>
        <p>"The keyboard setting, at the rear, puts up to eight units behind this panel. Its axis-pair selector says
            which of them has keys and displays, and which is seen in the scope, at inputs and outputs, in the editor.
            All go on meanwhile, and hang on one line, each with its address."</p>
    }
}

/// The keys of a newcomer, and what they do.
#[component]
fn Steps(face: &'static Face) -> impl IntoView {
    let key = |key: &str| {
        let key = key.to_owned();
        view! { <kbd>{key}</kbd>" " }
    };
    let step = move |&(keys, what): &(&'static str, &'static str)| {
        let said = what.split('`').enumerate().map(|(place, part)| {
            let part = part.to_owned();
            match place % 2 {
                0 => part.into_any(),
                _ => view! { <code>{part}</code> }.into_any(),
            }
        });
        view! {
            <li>
                <p class="keys-row">{keys.split(' ').map(key).collect_view()}</p>
                <p class="muted">{said.collect_view()}</p>
            </li>
        }
    };
    view! { <ol class="panel-steps">{face.steps.iter().map(step).collect_view()}</ol> }
}
