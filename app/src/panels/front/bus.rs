//! The bench's controller of the IEEE-488 bus: addressing, data, polls, and what came of them.

use leptos::ev;
use leptos::prelude::*;
use motionbench_core::bench::BusView;
use motionbench_core::ieee488::{LAST_ADDRESS, Order};

use crate::protocol::ToWorker;
use crate::state::Store;
use crate::state::bus::{self, BusLog};
use crate::state::keys::sent;

/// What can be asked of a unit; of all units, or of the bus, where it has no address.
type Ask = fn(u8) -> Order;

/// For the unit at the address.
const UNIT: [(&str, &str, Ask); 7] = [
    ("Listen", "it takes the data that follow", |unit| {
        Order::Listen(vec![unit])
    }),
    ("Talk", "it says what it has to say", Order::Talk),
    ("Serial poll", "reads its status byte", Order::SerialPoll),
    ("Trigger", "GET", |unit| Order::Trigger(vec![unit])),
    ("Clear", "SDC", |unit| Order::Clear(vec![unit])),
    ("Go to local", "GTL", |unit| Order::GoToLocal(vec![unit])),
    ("Unlisten", "no one listens", |_| Order::Listen(Vec::new())),
];
/// For all.
const ALL: [(&str, &str, Ask); 4] = [
    ("Parallel poll", "which lines request service", |_| {
        Order::ParallelPoll
    }),
    ("Clear all", "DCL", |_| Order::Clear(Vec::new())),
    ("Lock out", "LLO: RMT does nothing", |_| Order::LocalLockout),
    ("IFC", "no one talks or listens, and nothing waits", |_| {
        Order::InterfaceClear
    }),
];

/// The bus.
#[component]
pub(super) fn Bus(store: Store) -> impl IntoView {
    let view = Memo::new(move |_| store.device.with(|device| device.bus).unwrap_or_default());
    let unit = RwSignal::new(1_u8);
    let order = move |order: Order| {
        store.bus.update(|log| log.ask(&order));
        store.send(ToWorker::Bus(order));
    };
    let button = move |(name, what, ask): (&'static str, &'static str, Ask)| {
        view! {
            <button type="button" class="button" title=what on:click=move |_| order(ask(unit.get_untracked()))>{name}</button>
        }
    };
    let address = move |event| {
        if let Some(address) = event_target_value(&event)
            .parse()
            .ok()
            .filter(|a| *a <= LAST_ADDRESS)
        {
            unit.set(address);
        }
    };
    view! {
        <div class="bus">
            <div class="bus-asks">
                <Lines view order />
                <div class="choices" role="group" aria-label="One unit">
                    <label class="bus-address">"Unit "
                        <input class="input figures" type="number" min="0" max=LAST_ADDRESS prop:value=move || unit.get().to_string()
                            on:change=address />
                    </label>
                    {UNIT.map(button)}
                </div>
                <div class="choices" role="group" aria-label="All units">{ALL.map(button)}</div>
                <Data order />
            </div>
            <Log store />
        </div>
    }
}

/// SRQ, REN, and what the bus is at.
#[component]
fn Lines(view: Memo<BusView>, order: impl Fn(Order) + Copy + Send + 'static) -> impl IntoView {
    let remote = Memo::new(move |_| view.get().remote_enabled);
    let service = Memo::new(move |_| view.get().service);
    view! {
        <div class="bus-lines">
            <button type="button" class="button" role="switch" aria-checked=move || remote.get().to_string()
                title="Remote enable: units that are addressed leave their panel"
                on:click=move |_| order(Order::RemoteEnable(!remote.get_untracked()))>
                <span class="lamp" aria-hidden="true"></span>"REN"
            </button>
            <p class="point srq" class:on=service role="status">
                <span class="bulb" aria-hidden="true"></span>
                "SRQ"<span class="unseen">{move || if service.get() { " on" } else { " off" }}</span>
            </p>
            <p class="muted" role="status">"Bus "{move || bus::state_words(&view.get())}</p>
        </div>
    }
}

/// Data for those that listen.
#[component]
fn Data(order: impl Fn(Order) + Copy + Send + 'static) -> impl IntoView {
    let text = RwSignal::new(String::new());
    let line_end = RwSignal::new(true);
    let end = RwSignal::new(false);
    let submit = move |event: ev::SubmitEvent| {
        event.prevent_default();
        let mut bytes: Vec<u8> = sent(&text.get_untracked())
            .chars()
            .filter_map(|character| u8::try_from(character).ok())
            .collect();
        if line_end.get_untracked() {
            bytes.extend(b"\r\n");
        }
        if !bytes.is_empty() {
            order(Order::Send(bytes, end.get_untracked()));
            text.set(String::new());
        }
    };
    view! {
        <form class="bus-data" on:submit=submit>
            <input class="input" type="text" autocomplete="off" autocapitalize="characters" spellcheck="false"
                aria-label="Data for the listeners" placeholder="I X1000 F500" bind:value=text />
            <label class="check"><input type="checkbox" bind:checked=line_end />"CR LF"</label>
            <label class="check"><input type="checkbox" bind:checked=end />"EOI"</label>
            <button type="submit" class="button">"Send"</button>
        </form>
    }
}

/// What was asked and learnt; the newest line stays in sight.
#[component]
fn Log(store: Store) -> impl IntoView {
    let lines = move || store.bus.with(BusLog::lines);
    let empty = move || lines().is_empty();
    view! {
        <div class="bus-log" role="log" tabindex="0" aria-label="What was asked of the bus, and what it answered">
            <div>
                <Show when=empty>
                    <p class="muted">"REN on, Listen, then send a command; SRQ comes when it is done, and a serial poll answers it."</p>
                </Show>
                <For each=lines key=|line| (line.number, line.words.len()) children=|line| view! {
                    <p class:asked=line.asked>{line.words}</p>
                } />
            </div>
        </div>
    }
}
