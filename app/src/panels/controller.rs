//! Which controller is on the bench.

use leptos::prelude::*;
use motionbench_core::catalog::{KINDS, kind};

use crate::state::Store;
use crate::storage::Keeper;

/// The choice of the controller. The work with the present one is kept.
#[component]
pub(super) fn ControllerChoice(store: Store, keeper: Keeper) -> impl IntoView {
    let present = Memo::new(move |_| store.kind().id);
    let choose = move |event| {
        if let Some(kind) = kind(&event_target_value(&event)) {
            store.choose(kind);
        }
    };
    let options = KINDS.iter().map(|kind| {
        view! { <option value=kind.id prop:selected=move || present.get() == kind.id>{kind.name}</option> }
    });
    view! {
        <select class="select controller" aria-label="Controller" title="The controller on the bench"
            disabled=move || keeper.is_read_only() on:change=choose>
            {options.collect_view()}
        </select>
    }
}
