//! One strip: its name and what can be done with it, the newest values, and its plot.

use leptos::html;
use leptos::prelude::*;

use super::{Sheets, cursors};
use crate::panels::popover::Popover;
use crate::state::scope::{Scale, Scope, Shown, Strip};
use crate::state::{Store, wiring, words};

/// Marks that a scale needs to be round.
const MARKS: f64 = 4.0;

/// What stands beside a plot for one of its lines.
#[derive(Debug, Clone, PartialEq)]
struct Value {
    name: String,
    text: String,
    color: usize,
}

/// One strip.
#[component]
pub(super) fn StripView(
    store: Store,
    sheets: Sheets,
    folds: Memo<Vec<(String, bool)>>,
    name: String,
) -> impl IntoView {
    let canvas = NodeRef::<html::Canvas>::new();
    register(sheets, canvas, name.clone());
    let name = StoredValue::new(name);
    let folded = Memo::new(move |_| {
        folds.with(|folds| name.with_value(|name| folds.contains(&(name.clone(), true))))
    });
    let values = sheets.word(store, move |scope| {
        let strip = name.with_value(|name| scope.strip(name));
        let traces = strip.map_or(&[][..], |strip| &strip.traces);
        let value = |trace| value(scope, trace);
        traces.iter().map(value).collect::<Vec<_>>()
    });
    let unit = choice(store, name, |strip| match strip.has_lanes() {
        true => "on".to_owned(),
        false => words::unit(&strip.unit),
    });
    let first = move |read: fn(&Value) -> String| {
        move || values.with(|values| values.first().map_or_else(String::new, read))
    };
    let others = move || {
        let others = values.with(|values| values.get(1..).unwrap_or_default().to_vec());
        let other = |value: Value| {
            let key = format!("key second trace-{}", value.color);
            view! {
                <dd class="other">
                    <span class=key aria-hidden="true"></span>
                    {value.name}" "<span class="figures">{value.text}</span>
                </dd>
            }
        };
        others.into_iter().map(other).collect_view()
    };
    let bar = move || {
        let color = values.with(|values| values.first().map_or(1, |value| value.color));
        format!("strip-name trace-{color}")
    };
    view! {
        <div class="strip" class:folded=folded>
            <dl class="strip-label">
                <dt class=bar>
                    <Popover label=move || name.get_value() name=name.get_value() class="tool strip-menu">
                        <StripMenu store name folded />
                    </Popover>
                </dt>
                <dd class="value">{first(|value| value.text.clone())}</dd>
                <dd class="unit">{unit}</dd>
                {others}
            </dl>
            <div class="strip-plot">
                <canvas node_ref=canvas aria-hidden="true"></canvas>
                <cursors::Readings store name />
            </div>
        </div>
    }
}

/// Reads what the user chooses of a strip.
fn choice<T: PartialEq + Default + Send + Sync + 'static>(
    store: Store,
    name: StoredValue<String>,
    read: fn(&Strip) -> T,
) -> Memo<T> {
    Sheets::choice(store, move |scope| {
        let strip = name.with_value(|name| scope.strip(name));
        strip.map_or_else(T::default, read)
    })
}

fn value(scope: &Scope, trace: &Shown) -> Value {
    let newest = scope.newest(trace.signal);
    Value {
        name: trace.name.clone(),
        text: match newest {
            Some(image) if trace.bits => wiring::bits_words(image),
            newest => words::value(newest.unwrap_or(f64::NAN)),
        },
        color: trace.color,
    }
}

/// Has the canvas drawn on for as long as it is in the page.
fn register(sheets: Sheets, canvas: NodeRef<html::Canvas>, name: String) {
    let leaving = name.clone();
    canvas.on_load(move |canvas| {
        sheets
            .strips
            .update_value(|strips| strips.push((name, canvas.clone())));
        sheets.fit(canvas);
    });
    on_cleanup(move || {
        let _ = sheets
            .strips
            .try_update_value(|strips| strips.retain(|(other, _)| *other != leaving));
    });
}

/// What can be done with a strip.
#[component]
fn StripMenu(store: Store, name: StoredValue<String>, folded: Memo<bool>) -> impl IntoView {
    let lanes = choice(store, name, Strip::has_lanes);
    let change = move |change: &dyn Fn(&mut Scope, &str)| {
        name.with_value(|name| store.change_scope(|scope| change(scope, name)));
    };
    view! {
        <Show when=move || !lanes.get()><ScaleChoice store name /></Show>
        <button type="button" class="item"
            on:click=move |_| change(&|scope, name| scope.fold(name, !folded.get_untracked()))>
            {move || if folded.get() { "Unfold" } else { "Fold" }}
        </button>
        <button type="button" class="item" on:click=move |_| change(&|scope, name| scope.remove(name))>
            "Remove"
        </button>
    }
}

/// Automatic or fixed, and from where to where.
#[component]
fn ScaleChoice(store: Store, name: StoredValue<String>) -> impl IntoView {
    let fixed = choice(store, name, |strip| strip.fixed);
    let set = move |scale: Option<Scale>| {
        name.with_value(|name| store.change_scope(|scope| scope.fix(name, scale)));
    };
    let fix = move |_| {
        let now = store.with_scope(|scope| {
            let strip = name.with_value(|name| scope.strip(name))?;
            let picture = scope.picture(strip, scope.view()?, 1, MARKS)?;
            Some(picture.scale)
        });
        set(now.or(Scale::between(-1.0, 1.0, MARKS)));
    };
    let end = move |read: fn(&Scale) -> f64| {
        move || {
            fixed.with(|scale| {
                scale
                    .as_ref()
                    .map_or_else(String::new, |s| read(s).to_string())
            })
        }
    };
    // A text that is no scale yet changes nothing.
    let change = move |event, low: bool| {
        let (Some(scale), Ok(typed)) = (fixed.get_untracked(), event_target_value(&event).parse())
        else {
            return;
        };
        let ends = if low {
            (typed, scale.high)
        } else {
            (scale.low, typed)
        };
        if let Some(scale) = Scale::between(ends.0, ends.1, MARKS) {
            set(Some(scale));
        }
    };
    view! {
        <fieldset class="scale-choice">
            <legend>"Scale"</legend>
            <div class="segments">
                <button type="button" class="segment" aria-pressed=move || fixed.get().is_none().to_string()
                    on:click=move |_| set(None)>"Automatic"</button>
                <button type="button" class="segment" aria-pressed=move || fixed.get().is_some().to_string()
                    on:click=fix>"Fixed"</button>
            </div>
            <Show when=move || fixed.get().is_some()>
                <label class="end">
                    "to"
                    <input class="field" type="number" step="any" prop:value=end(|scale| scale.high)
                        on:change=move |event| change(event, false) />
                </label>
                <label class="end">
                    "from"
                    <input class="field" type="number" step="any" prop:value=end(|scale| scale.low)
                        on:change=move |event| change(event, true) />
                </label>
            </Show>
        </fieldset>
    }
}
