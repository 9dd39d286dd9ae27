//! What the page says of a newer version of itself.

use leptos::prelude::*;

use crate::offline::{Offline, Updates};

/// Asks whether to change over to a newer version. Until then the page goes on in its own.
#[component]
pub(super) fn UpdatePrompt(updates: Updates) -> impl IntoView {
    // Asked once a visit: who says later is not to be asked again for the same.
    let later = RwSignal::new(false);
    let asks = Memo::new(move |_| updates.state.get() == Offline::NewVersion && !later.get());
    // There from the start, so that a screen reader notices what comes into it.
    view! {
        <div role="status">
            {move || asks.get().then(|| view! {
                <div class="notice">
                    <p>"A newer version of Motionbench is ready. It is used when you reload; your work is kept."</p>
                    <button type="button" class="button" on:click=move |_| updates.accept()>"Reload now"</button>
                    <button type="button" class="button" on:click=move |_| later.set(true)>"Later"</button>
                </div>
            })}
        </div>
    }
}
