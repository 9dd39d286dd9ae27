//! The emergency stop of the machine: always there, latched until it is released.

use leptos::prelude::*;

use crate::protocol::ToWorker;
use crate::state::Store;
use crate::state::wiring::Wiring;

/// The button, for the corner of the top bar.
#[component]
pub(super) fn EStop(store: Store) -> impl IntoView {
    let pressed = pressed(store);
    let title = move || match pressed.get() {
        true => "Lets the drive be enabled again",
        false => "Stops the axis and takes the drive's enable, whatever the program does",
    };
    view! {
        <button type="button" class="estop" class:pressed=pressed title=title
            on:click=move |_| store.send(ToWorker::EmergencyStop(!pressed.get_untracked()))>
            {move || if pressed.get() { "Release " } else { "" }}
            <span>"E-STOP"</span>
        </button>
    }
}

/// What it means, while it is pressed.
#[component]
pub(super) fn EStopNotice(store: Store) -> impl IntoView {
    let enable = move || store.kind().enable;
    let pressed = pressed(store);
    view! {
        <div role="status">
            <Show when=move || pressed.get()>
                <p class="stopped">
                    <strong>"Emergency stop."</strong>
                    " The axis brakes and the drive is disabled; the program goes on. Release E-STOP, then enable \
                     the drive again with "<code>{enable}</code>"."
                </p>
            </Show>
        </div>
    }
}

fn pressed(store: Store) -> Memo<bool> {
    Memo::new(move |_| store.wiring.with(Wiring::is_stopped))
}
