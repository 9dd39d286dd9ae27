//! Two cursors over the plots, and what they tell.

use leptos::html;
use leptos::prelude::*;
use web_sys::{KeyboardEvent, PointerEvent};

use super::Sheets;
use super::gestures::place;
use crate::state::scope::{Reading, Scope, Strip};
use crate::state::{Store, wiring, words};

/// What they are called.
const NAMES: [&str; 2] = ["A", "B"];
/// With Shift a key moves a cursor so many times as far.
const FAR: f64 = 10.0;

/// Both cursors.
#[component]
pub(super) fn Cursors(store: Store, over: NodeRef<html::Div>) -> impl IntoView {
    let shown = Sheets::choice(store, |scope| scope.cursors().is_some());
    view! {
        <Show when=move || shown.get()>
            <Cursor store over which=0 />
            <Cursor store over which=1 />
        </Show>
    }
}

/// One of them.
#[component]
fn Cursor(store: Store, over: NodeRef<html::Div>, which: usize) -> impl IntoView {
    let read = move |read: fn(&Scope, usize) -> Option<String>| {
        Memo::new(move |_| {
            store.recorded.track();
            store.with_scope(|scope| read(scope, which))
        })
    };
    // `None` beyond the edges of the picture.
    let left = read(|scope, which| {
        let place = scope.view()?.place(scope.cursors()?[which]);
        let inside = (-0.001..=1.001).contains(&place);
        inside.then(|| format!("{:.3}%", place.clamp(0.0, 1.0) * 100.0))
    });
    let now = read(|scope, which| Some(format!("{:.4}", seconds(scope, which)?)));
    let least = read(|scope, _| Some(format!("{:.4}", scope.view()?.scale().low)));
    let most = read(|scope, _| Some(format!("{:.4}", scope.view()?.scale().high)));
    let text = read(said);
    let dragged = StoredValue::new(false);
    let down = move |event: PointerEvent| {
        event.stop_propagation();
        let element: web_sys::Element = event_target(&event);
        // Without it the pointer must stay on the cursor.
        let _ = element.set_pointer_capture(event.pointer_id());
        dragged.set_value(true);
    };
    let moved = move |event: PointerEvent| {
        if let (true, Some(plots)) = (dragged.get_value(), over.get_untracked()) {
            event.stop_propagation();
            let to = place(&plots, event.client_x());
            store.change_scope(|scope| scope.move_cursor(which, to));
        }
    };
    let up = move |_: PointerEvent| dragged.set_value(false);
    view! {
        <div class="scope-cursor" role="slider" tabindex="0" aria-label=format!("Cursor {}", NAMES[which])
            aria-orientation="horizontal" aria-valuenow=now aria-valuemin=least aria-valuemax=most
            aria-valuetext=text
            hidden=move || left.get().is_none()
            style:left=move || left.get().unwrap_or_default()
            on:pointerdown=down on:pointermove=moved on:pointerup=up on:pointercancel=up
            on:dblclick=|event| event.stop_propagation()
            on:keydown=move |event| {
                if key(store, which, &event) {
                    event.prevent_default();
                }
            }>
            <span class="grip" aria-hidden="true">{NAMES[which]}</span>
        </div>
    }
}

fn key(store: Store, which: usize, event: &KeyboardEvent) -> bool {
    let steps = if event.shift_key() { FAR } else { 1.0 };
    let step = |steps| store.change_scope(|scope| scope.step_cursor(which, steps));
    match event.key().as_str() {
        "ArrowRight" | "ArrowUp" => step(steps),
        "ArrowLeft" | "ArrowDown" => step(-steps),
        "PageUp" => step(FAR),
        "PageDown" => step(-FAR),
        "Home" => store.change_scope(|scope| scope.move_cursor(which, 0.0)),
        "End" => store.change_scope(|scope| scope.move_cursor(which, 1.0)),
        _ => return false,
    }
    true
}

/// Where a cursor is on the time axis, s.
fn seconds(scope: &Scope, which: usize) -> Option<f64> {
    Some(scope.view()?.seconds(scope.cursors()?[which]))
}

/// A cursor for a screen reader: the time and every value there.
fn said(scope: &Scope, which: usize) -> Option<String> {
    let mut said = format!("{} s", words::number(seconds(scope, which)?, 3));
    for (strip, trace) in scope.traces() {
        let value = scope.reading(trace.signal)?.values[which];
        let value = match trace.bits {
            true => wiring::bits_words(value),
            false => format!("{} {}", words::value(value), strip.unit),
        };
        said.push_str(&format!(", {} {} {value}", strip.name, trace.name));
    }
    Some(said)
}

/// The time between the cursors, beside the time axis.
#[component]
pub(super) fn Between(store: Store) -> impl IntoView {
    let text = Sheets::choice(store, |scope| {
        Some(format!("{} s", words::number(scope.between_cursors()?, 3)))
    });
    view! {
        <p class="between figures">
            {move || text.get().map(|text| view! { "\u{394}t "<strong>{text}</strong> })}
        </p>
    }
}

/// What the cursors tell of a strip, over its plot.
#[component]
pub(super) fn Readings(store: Store, name: StoredValue<String>) -> impl IntoView {
    let rows = Sheets::choice(store, move |scope| {
        let strip = name.with_value(|name| scope.strip(name));
        strip.map_or_else(Vec::new, |strip| rows(scope, strip))
    });
    // On the side where the cursors are not.
    let left = Sheets::choice(store, |scope| {
        let (view, cursors) = (scope.view(), scope.cursors());
        let places = view
            .zip(cursors)
            .map(|(view, at)| at.map(|at| view.place(at)));
        places.is_some_and(|[a, b]| a + b > 1.0)
    });
    let row = |(color, cells): (usize, [String; 4])| {
        let key = format!("key trace-{color}");
        let [a, b, difference, slope] = cells;
        view! {
            <p>
                <span class=key aria-hidden="true"></span>
                <span>"A "{a}</span>
                <span>"B "{b}</span>
                <span class="difference">{difference}</span>
                <span>{slope}</span>
            </p>
        }
    };
    view! {
        <Show when=move || rows.with(|rows| !rows.is_empty())>
            <div class="readings figures" class:left=left>{move || rows.get().into_iter().map(row).collect_view()}</div>
        </Show>
    }
}

/// The colour of each line, and its values at both cursors, the difference and the slope.
fn rows(scope: &Scope, strip: &Strip) -> Vec<(usize, [String; 4])> {
    let row = |trace: &crate::state::scope::Shown| {
        let reading = scope.reading(trace.signal)?;
        let cells = match trace.bits {
            true => {
                let [a, b] = reading.values.map(wiring::bits_words);
                [a, b, String::new(), String::new()]
            }
            false => cells(&reading),
        };
        Some((trace.color, cells))
    };
    strip.traces.iter().filter_map(row).collect()
}

fn cells(reading: &Reading) -> [String; 4] {
    let [a, b] = reading.values.map(words::value);
    let difference = format!("\u{394} {}", words::value(reading.difference()));
    let slope = reading
        .slope()
        .map_or_else(String::new, |slope| format!("{} /s", words::value(slope)));
    [a, b, difference, slope]
}
