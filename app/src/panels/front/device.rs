//! The device itself: displays, LEDs and keys, as they stand on its front panel.

use std::time::Duration;

use leptos::html;
use leptos::leptos_dom::helpers::TimeoutHandle;
use leptos::prelude::*;
use motionbench_core::controller::{Face, Keycap, Led, Panel};

use super::hands::{Catcher, Hands, Key};
use super::segments::Segments;
use super::{Steps, Tray, joystick};
use crate::protocol::ToWorker;
use crate::state::Store;

/// Places of the text display and of a tracking display, with its sign.
const TEXT: usize = 8;
const NUMBER: usize = 11;
/// A screen reader says what the display has shown for so long: what is typed is heard when the typing rests.
const CALM: Duration = Duration::from_millis(700);

/// The mode keys and their LEDs.
const MODES: [(&str, &str); 5] = [
    ("EDT", "EDIT"),
    ("AUT", "AUTO"),
    ("SGL", "SINGLE"),
    ("IMD", "IMMEDIATE"),
    ("RMT", "REMOTE"),
];
/// The keys beside the pad, row by row.
const FUNCTIONS: [&str; 12] = [
    "SHIFT", "PRT", "RES", "CE", "EXC", "SLW", "BST", "UP", "STP", "LEFT", "DOWN", "RIGHT",
];

/// What the panel shows.
type Shown = Memo<Panel>;

/// The device, and what stands beside it.
#[component]
pub(super) fn Device(
    store: Store,
    face: &'static Face,
    tray: RwSignal<Option<Tray>>,
) -> impl IntoView {
    let hands = Hands::new(store, NodeRef::new());
    let shown = Memo::new(move |_| {
        let panel = store.device.with(|device| device.panel.clone());
        panel.unwrap_or_default()
    });
    let device = NodeRef::<html::Div>::new();
    let beside = move || match tray.get() {
        Some(Tray::Joystick) => {
            Some(view! { <joystick::Joystick store stick=face.joystick /> }.into_any())
        }
        Some(Tray::Steps) => Some(view! { <Steps face /> }.into_any()),
        None => None,
    };
    let press = move |event: leptos::ev::MouseEvent| {
        event.prevent_default();
        hands.focus();
    };
    view! {
        <div class="front-room">
            <div class="stand" on:focusin=move |_| store.pressing.set(true)
                on:focusout=move |_| store.pressing.set(false)>
                <div class="device" role="group" aria-label="Unidex IIIa" node_ref=device on:mousedown=press>
                    <div class="plate">
                        <p class="brand-plate" aria-hidden="true">"UNIDEX "<span>"IIIa"</span></p>
                        <Selector store />
                    </div>
                    <div class="text-display">
                        <Segments places=TEXT shows=Signal::derive(move || shown.with(|panel| panel.display.clone())) />
                    </div>
                    {["x", "y"].map(|axis| view! { <Tracking hands shown face axis /> })}
                    <Modes hands shown face />
                    <div class="pad" role="group" aria-label="Keyboard">
                        {face.keys.iter().take(16).map(|cap| view! { <Key hands cap /> }).collect_view()}
                    </div>
                    <div class="functions" role="group" aria-label="Functions and arrows">
                        <Light shown name="SHIFT" />
                        {caps(face, &FUNCTIONS).map(|cap| view! { <Key hands cap /> }).collect_view()}
                    </div>
                    <Catcher hands keys=face.keys />
                </div>
                <Spoken shown />
            </div>
            {move || beside().map(|beside| view! { <aside class="tray">{beside}</aside> })}
            <Note store shown />
        </div>
    }
}

/// The axis-pair selector, where the panel is one for several units.
#[component]
fn Selector(store: Store) -> impl IntoView {
    let units = Memo::new(move |_| store.device.with(|device| device.units));
    let selected = Memo::new(move |_| store.device.with(|device| device.unit));
    let place = move |unit: usize| {
        let chosen = move || selected.get() == unit;
        view! {
            <button type="button" class="place" aria-pressed=move || chosen().to_string()
                aria-label=format!("Axis pair {}", unit + 1)
                on:click=move |_| store.send(ToWorker::Select(unit))>{unit + 1}</button>
        }
    };
    view! {
        <Show when=move || { units.get() > 1 }>
            <div class="selector" role="group" aria-label="Axis-pair selector">
                <span aria-hidden="true">"AXIS PAIR"</span>
                {move || (0..units.get()).map(place).collect_view()}
            </div>
        </Show>
    }
}

/// The keys of these names.
fn caps(face: &'static Face, names: &'static [&str]) -> impl Iterator<Item = &'static Keycap> {
    let find = |name: &&str| face.keys.iter().find(|cap| cap.key == *name);
    names.iter().filter_map(find)
}

fn led(panel: &Panel, name: &str) -> Led {
    let found = panel.leds.iter().find(|(legend, _)| legend == name);
    found.map(|(_, led)| *led).unwrap_or_default()
}

/// An LED. What it says is said in words by [`Spoken`].
#[component]
fn Light(shown: Shown, #[prop(into)] name: String) -> impl IntoView {
    let state = Memo::new(move |_| shown.with(|panel| led(panel, &name)));
    view! {
        <span class="led" class:on=move || state.get() == Led::On class:flashing=move || state.get() == Led::Flashing
            aria-hidden="true"></span>
    }
}

/// An axis: where it is, its LEDs, and the key that clears the display.
#[component]
fn Tracking(hands: Hands, shown: Shown, face: &'static Face, axis: &'static str) -> impl IntoView {
    let value = Memo::new(move |_| {
        let value = shown.with(|panel| {
            let found = panel.tracking.iter().find(|(name, _)| name == axis);
            found.map(|(_, value)| value.clone()).unwrap_or_default()
        });
        as_digits(&value)
    });
    let (name, clear): (_, &'static [&str]) = match axis {
        "x" => ("X", &["CLRX"]),
        _ => ("Y", &["CLRY"]),
    };
    let lights = ["CZ", "M", "LMT"].map(|legend| {
        view! {
            <span class="light"><Light shown name=format!("{name}{legend}") />{legend}</span>
        }
    });
    view! {
        <div class=format!("tracking tracking-{axis}")>
            <span class="axis-name" aria-hidden="true">{name}</span>
            <div class="number-display"><Segments places=NUMBER numeric=true shows=value /></div>
            {caps(face, clear).map(|cap| view! { <Key hands cap /> }).collect_view()}
            <div class="lights" aria-hidden="true">{lights}</div>
        </div>
    }
}

/// A number as ten digits behind a place for the sign; nothing where there is none.
fn as_digits(value: &str) -> String {
    match value.strip_prefix('-') {
        _ if value.is_empty() => String::new(),
        Some(digits) => format!("-{digits:0>10}"),
        None => format!(" {value:0>10}"),
    }
}

/// The mode keys with their LEDs, and the LED of the local state.
#[component]
fn Modes(hands: Hands, shown: Shown, face: &'static Face) -> impl IntoView {
    let mode = move |(key, light): (&'static str, &'static str)| {
        let cap = face.keys.iter().find(|cap| cap.key == key);
        view! {
            <div class="mode"><Light shown name=light />{cap.map(|cap| view! { <Key hands cap /> })}</div>
        }
    };
    view! {
        <div class="modes" role="group" aria-label="Modes">
            {MODES.map(mode).collect_view()}
            <div class="mode local" aria-hidden="true"><Light shown name="LOCAL" /><span>"LOCAL"</span></div>
        </div>
    }
}

/// Displays and LEDs as text, and what of them is said as it comes.
#[component]
fn Spoken(shown: Shown) -> impl IntoView {
    let said = RwSignal::new(String::new());
    let pending = StoredValue::new(None::<TimeoutHandle>);
    let news = Memo::new(move |_| shown.with(news));
    Effect::new(move |_| {
        let news = news.get();
        if let Some(Some(pending)) = pending.try_update_value(Option::take) {
            pending.clear();
        }
        let say = move || {
            said.try_set(news.clone());
        };
        if let Ok(timeout) = set_timeout_with_handle(say, CALM) {
            pending.set_value(Some(timeout));
        }
    });
    let text = Memo::new(move |_| shown.with(|panel| panel.display.trim().to_owned()));
    let leds = move || {
        shown.with(|panel| {
            let led = |(name, led): &(String, Led)| view! { <li>{format!("{name} {}", words(*led))}</li> };
            panel.leds.iter().map(led).collect_view()
        })
    };
    let tracking = move || {
        shown.with(|panel| {
            let display = |(axis, value): &(String, String)| {
                let value = if value.is_empty() { "dark" } else { value };
                view! { <li>{format!("{} {value}", axis.to_ascii_uppercase())}</li> }
            };
            panel.tracking.iter().map(display).collect_view()
        })
    };
    view! {
        <div class="unseen">
            <p role="status">{said}</p>
            <p>"Display: "{move || if text.with(String::is_empty) { "blank".to_owned() } else { text.get() }}</p>
            <ul aria-label="Tracking displays">{tracking}</ul>
            <ul aria-label="LEDs">{leds}</ul>
        </div>
    }
}

/// What a person should hear without asking: the display, a limit, message entry.
fn news(panel: &Panel) -> String {
    let mut news = vec![panel.display.trim().to_owned()];
    for (name, light) in &panel.leds {
        match light {
            Led::On if name.ends_with("LMT") => news.push(format!("{name} on")),
            Led::Flashing => news.push(format!("{name} flashing")),
            _ => {}
        }
    }
    news.join(", ")
}

fn words(led: Led) -> &'static str {
    match led {
        Led::Off => "off",
        Led::On => "on",
        Led::Flashing => "flashing",
    }
}

/// Why keys do nothing, where that is so; otherwise how to press them.
#[component]
fn Note(store: Store, shown: Shown) -> impl IntoView {
    let note = Memo::new(move |_| {
        let (off, lit) = store.device.with(|device| {
            let off = device.status.is_some() && !device.is_on();
            (off, device.panel.is_some())
        });
        let remote = lit && shown.with(|panel| led(panel, "LOCAL") == Led::Off);
        match (off, remote) {
            (true, _) => "The unit is off: Power switches it on.",
            (_, true) => "The line has the unit: RMT gives it back to the panel.",
            _ => "",
        }
    });
    view! {
        <p class="note" role="status">{note}</p>
        <p class="note muted hint" class:hidden=move || !note.get().is_empty()>
            "Type it, too: Enter is EXC, Backspace CE; arrows jog while held. Help has the others."
        </p>
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_tracking_display_has_a_sign_and_ten_digits() {
        assert_eq!(as_digits("-52146"), "-0000052146");
        assert_eq!(as_digits("2000000000"), " 2000000000");
        assert_eq!(as_digits("0").len(), NUMBER);
        assert_eq!(as_digits(""), "");
    }

    #[test]
    fn what_is_said_of_itself_is_what_a_person_must_know() {
        let mut panel = Panel {
            display: "EDIT 25 ".to_owned(),
            leds: vec![("EDIT".to_owned(), Led::On), ("XLMT".to_owned(), Led::Off)],
            tracking: Vec::new(),
        };
        assert_eq!(news(&panel), "EDIT 25");
        panel.leds = vec![
            ("EDIT".to_owned(), Led::Flashing),
            ("XLMT".to_owned(), Led::On),
        ];
        assert_eq!(news(&panel), "EDIT 25, EDIT flashing, XLMT on");
    }
}
