//! Switches and jumpers: set one after the other, and in force when the unit is switched on again.

use leptos::prelude::*;
use motionbench_core::controller::{Binary, Choices, Face, Setting};

use crate::state::Store;
use crate::state::front::{self, Settings};

/// All that can be set.
#[component]
pub(super) fn Rear(store: Store, face: &'static Face) -> impl IntoView {
    let draft = RwSignal::new(store.settings.get_untracked());
    // Another project, or another tab's.
    Effect::new(move |_| draft.set(store.settings.get()));
    let same = Memo::new(move |_| draft.with(|draft| store.settings.with(|set| draft == set)));
    let usual = Memo::new(move |_| draft.with(Settings::is_empty));
    let several = move || draft.with(|draft| front::are_several(store.kind(), draft));
    let setting = move |setting: &'static Setting| match setting.choices {
        Choices::Words(words) => view! { <Words draft setting words /> }.into_any(),
        Choices::Binary(binary) => view! { <Switches draft setting binary /> }.into_any(),
    };
    view! {
        <div class="rear">
            <div class="rear-settings">{face.settings.iter().map(setting).collect_view()}</div>
            <div class="rear-foot">
                <p class="muted">
                    "Set with the power off: the unit goes off and on again. Programs stay. "
                    <Show when=several>
                        "All units are set like this one; their addresses count on from its, and the last ends the chain."
                    </Show>
                </p>
                <button type="button" class="button" disabled=usual on:click=move |_| draft.set(Settings::new())>
                    "As it came"
                </button>
                <button type="button" class="button primary" disabled=same
                    on:click=move |_| store.set_switches(draft.get_untracked())>"Set"</button>
            </div>
        </div>
    }
}

/// What stands beside a setting.
#[component]
fn Label(setting: &'static Setting) -> impl IntoView {
    view! {
        <span class="setting-name">{setting.name}</span>
        <span class="setting-place">{setting.place}</span>
    }
}

/// One of some words: a jumper where there are two, a switch of many places otherwise.
#[component]
fn Words(
    draft: RwSignal<Settings>,
    setting: &'static Setting,
    words: &'static [(&'static str, &'static str)],
) -> impl IntoView {
    let chosen = Memo::new(move |_| draft.with(|draft| front::chosen(draft, setting, words)));
    let choose = move |place: usize| {
        if let Some((_, options)) = words.get(place) {
            draft.update(|draft| front::choose(draft, setting, options));
        }
    };
    if words.len() > 2 {
        let option = |(place, (word, _)): (usize, &'static (&'static str, &'static str))| {
            view! { <option value=place.to_string() prop:selected=move || chosen.get() == place>{*word}</option> }
        };
        let change = move |event| {
            if let Ok(place) = event_target_value(&event).parse() {
                choose(place);
            }
        };
        return view! {
            <label class="setting">
                <Label setting />
                <select class="select" on:change=change>{words.iter().enumerate().map(option).collect_view()}</select>
            </label>
        }
        .into_any();
    }
    let pin = move |(place, (word, _)): (usize, &'static (&'static str, &'static str))| {
        view! {
            <label class="jumper" class:in=move || chosen.get() == place>
                <input type="radio" name=format!("setting-{}", setting.key) prop:checked=move || chosen.get() == place
                    on:change=move |_| choose(place) />
                <span class="shunt" aria-hidden="true"></span>
                {*word}
            </label>
        }
    };
    view! {
        <fieldset class="setting">
            <legend><Label setting /></legend>
            <div class="jumpers">{words.iter().enumerate().map(pin).collect_view()}</div>
        </fieldset>
    }
    .into_any()
}

/// A number in binary switches.
#[component]
fn Switches(draft: RwSignal<Settings>, setting: &'static Setting, binary: Binary) -> impl IntoView {
    let number = Memo::new(move |_| draft.with(|draft| front::number(draft, setting, binary)));
    let unused = RwSignal::new(false);
    let switch = move |place: u8| {
        let on = Memo::new(move |_| front::is_on(binary, number.get(), place));
        let label = binary.first + place;
        let turn = move |_| {
            let used = draft.try_update(|draft| front::turn(draft, setting, binary, place));
            unused.set(used == Some(false));
        };
        view! {
            <button type="button" class="dip" role="switch" class:on=on aria-checked=move || on.get().to_string()
                aria-label=format!("{}, switch {label}", setting.name)
                title=format!("off adds {}", front::weight(binary, place)) on:click=turn>
                <span class="dip-slot" aria-hidden="true"></span>
                <span aria-hidden="true">{label}</span>
            </button>
        }
    };
    let said = move || match unused.get() {
        true => format!("{} is not used", binary.to.saturating_add(1)),
        false => number.get().to_string(),
    };
    view! {
        <div class="setting" role="group" aria-label=setting.name>
            <Label setting />
            <div class="dips">
                <span class="dip-on" aria-hidden="true">"ON"</span>
                {(0..binary.switches).map(switch).collect_view()}
                <output class="figures">{said}</output>
            </div>
        </div>
    }
}
