//! How the terminal's end of the line is set.

use leptos::ev;
use leptos::prelude::*;
use motionbench_core::serial::{Flow, LineSettings, Parity};

use crate::panels::dialog::Dialog;
use crate::state::Store;
use crate::state::device::line_words;

/// What terminals of the time could be set to, and a few faster.
const BAUDS: [u32; 10] = [
    300, 600, 1200, 2400, 4800, 9600, 19_200, 38_400, 57_600, 115_200,
];
const PARITIES: [(Parity, &str); 3] = [
    (Parity::None, "none"),
    (Parity::Even, "even"),
    (Parity::Odd, "odd"),
];
const FLOWS: [(Flow, &str); 2] = [(Flow::XonXoff, "XON/XOFF"), (Flow::None, "none")];

/// Asks for the settings.
#[component]
pub(super) fn LineDialog(store: Store, open: RwSignal<bool>) -> impl IntoView {
    view! {
        <Dialog open=open title="Line settings"><LineForm store open /></Dialog>
    }
}

#[component]
fn LineForm(store: Store, open: RwSignal<bool>) -> impl IntoView {
    let console = store.device.with_untracked(|device| device.console);
    let present = store.device.with_untracked(|device| device.line);
    let usual = console.unwrap_or(LineSettings::new(9600));
    let line = RwSignal::new(present.unwrap_or(usual));
    let terminal = RwSignal::new(untrack(|| store.terminal_settings()));
    let as_controller = move |_| {
        line.set(usual);
        terminal.set(untrack(|| store.kind().terminal));
    };
    let submit = move |event: ev::SubmitEvent| {
        event.prevent_default();
        store.set_line(line.get_untracked());
        store.set_terminal(Some(terminal.get_untracked()));
        open.set(false);
    };
    let number = |number: u32| (number, number.to_string());
    let bits = |bits: u8| (bits, bits.to_string());
    view! {
        <form class="dialog-body" on:submit=submit>
            <p>"What the terminal is set to. The controller's console is set to "
                <strong>{line_words(&usual)}</strong>
                ": where the two differ, both receive garbage, as on a real line."</p>
            <div class="fields">
                <Choice label="Baud" options=BAUDS.map(number).to_vec() line
                    read=|line| line.baud write=|line, baud| line.baud = baud />
                <Choice label="Data bits" options=[7, 8].map(bits).to_vec() line
                    read=|line| line.data_bits write=|line, bits| line.data_bits = bits />
                <Choice label="Parity" options=PARITIES.map(named).to_vec() line
                    read=|line| line.parity write=|line, parity| line.parity = parity />
                <Choice label="Stop bits" options=[1, 2].map(bits).to_vec() line
                    read=|line| line.stop_bits write=|line, bits| line.stop_bits = bits />
                <Choice label="Flow control" options=FLOWS.map(named).to_vec() line
                    read=|line| line.flow write=|line, flow| line.flow = flow />
            </div>
            <label class="check">
                <input type="checkbox" prop:checked=move || terminal.get().local_echo
                    on:change=move |event| terminal.update(|t| t.local_echo = event_target_checked(&event)) />
                "Show what is sent (local echo)"
            </label>
            <label class="check">
                <input type="checkbox" prop:checked=move || terminal.get().line_feeds
                    on:change=move |event| terminal.update(|t| t.line_feeds = event_target_checked(&event)) />
                "A new line at each CR"
            </label>
            <div class="choices">
                <button type="submit" class="button primary">"Set"</button>
                <button type="button" class="button" on:click=as_controller>"As the controller"</button>
                <button type="button" class="button" on:click=move |_| open.set(false)>"Cancel"</button>
            </div>
        </form>
    }
}

fn named<T>((value, name): (T, &str)) -> (T, String) {
    (value, name.to_owned())
}

/// One setting.
#[component]
fn Choice<T: Copy + PartialEq + Send + Sync + 'static>(
    label: &'static str,
    options: Vec<(T, String)>,
    line: RwSignal<LineSettings>,
    read: fn(&LineSettings) -> T,
    write: fn(&mut LineSettings, T),
) -> impl IntoView {
    let values: Vec<T> = options.iter().map(|(value, _)| *value).collect();
    let choose = move |event: ev::Event| {
        let index = event_target_value(&event).parse::<usize>();
        if let Some(value) = index.ok().and_then(|index| values.get(index).copied()) {
            line.update(|line| write(line, value));
        }
    };
    let option = |(index, (value, name)): (usize, (T, String))| {
        let selected = move || line.with(read) == value;
        view! { <option value=index.to_string() prop:selected=selected>{name}</option> }
    };
    view! {
        <label class="labelled">
            {label}
            <select class="select" on:change=choose>
                {options.into_iter().enumerate().map(option).collect_view()}
            </select>
        </label>
    }
}
