//! The scope: strips of what was recorded, on one time axis.

use leptos::html;
use leptos::prelude::*;
use web_sys::HtmlCanvasElement;

use super::{draw, room};
use crate::state::scope::{Scope as State, View};
use crate::state::{Store, words};

mod fine;
mod plot;

use plot::{Colors, Surface};

/// The strips that there are, from the top; the time axis is below them.
const STRIPS: usize = 2;

/// The scope.
#[component]
pub(super) fn Scope(store: Store) -> impl IntoView {
    let canvases: [NodeRef<html::Canvas>; STRIPS] = std::array::from_fn(|_| NodeRef::new());
    let axis = NodeRef::<html::Canvas>::new();
    let shown = Memo::new(move |_| {
        store.recorded.track();
        store.with_scope(|scope| scope.view().is_some())
    });
    let draw = draw::before_paint(move || {
        let Some(colors) = Colors::of_page() else {
            return;
        };
        store.with_scope(|scope| {
            let Some(view) = scope.view() else { return };
            for (strip, canvas) in canvases.iter().enumerate() {
                if let Some(canvas) = canvas.get_untracked() {
                    draw_strip(scope, strip, view, &canvas, &colors);
                }
            }
            if let Some(canvas) = axis.get_untracked().and_then(|canvas| Surface::of(&canvas)) {
                plot::time_axis(&canvas, view.scale(), &colors);
            }
        });
    });
    redraw(store, &canvases, axis, draw);
    let strips = canvases.into_iter().enumerate();
    view! {
        <section class="panel scope" aria-labelledby="scope-title">
            <header class="panel-head">
                <h2 id="scope-title">"Scope"</h2>
                <span class="muted">"from the start of motion"</span>
            </header>
            <div class="strips">
                {strips.map(|(strip, canvas)| view! { <StripView store strip canvas /> }).collect_view()}
                <div class="axis"><canvas node_ref=axis aria-hidden="true"></canvas></div>
                <Show when=move || !shown.get()><FirstSteps /></Show>
            </div>
        </section>
    }
}

/// Draws when there is more to show, when the room changes, and when the page turns light or dark.
fn redraw(
    store: Store,
    canvases: &[NodeRef<html::Canvas>; STRIPS],
    axis: NodeRef<html::Canvas>,
    draw: impl Fn() + Clone + 'static,
) {
    for canvas in canvases.iter().chain([&axis]) {
        let draw = draw.clone();
        canvas.on_load(move |canvas| {
            // Its frame, not the canvas itself, whose size follows what is drawn.
            let Some(frame) = canvas.parent_element() else {
                return;
            };
            room::watch(&frame, move |width, height| {
                plot::fit(&canvas, width, height);
                draw();
            });
        });
    }
    plot::on_color_scheme(draw.clone());
    Effect::new(move |_| {
        store.recorded.track();
        draw();
    });
}

fn draw_strip(
    scope: &State,
    strip: usize,
    view: View,
    canvas: &HtmlCanvasElement,
    colors: &Colors,
) {
    let Some(surface) = Surface::of(canvas) else {
        return;
    };
    let Some(scale) = scope.scale(strip, view, surface.marks()) else {
        return;
    };
    let line = scope.line(strip, view, surface.columns());
    plot::strip(&surface, view.scale(), scale, &line, colors, strip);
}

/// One strip: its name, its newest value, and its line.
#[component]
fn StripView(store: Store, strip: usize, canvas: NodeRef<html::Canvas>) -> impl IntoView {
    let read = move |read: fn(&State, usize) -> String| {
        Memo::new(move |_| {
            // The name and unit come with the controller's.
            store.device.with(|device| device.name.len());
            store.recorded.track();
            store.with_scope(|scope| read(scope, strip))
        })
    };
    let label = read(|scope, strip| {
        scope
            .strips()
            .get(strip)
            .map_or_else(String::new, |s| s.label.to_owned())
    });
    let unit = read(|scope, strip| {
        scope
            .strips()
            .get(strip)
            .map_or_else(String::new, |s| words::unit(&s.unit))
    });
    let value = read(|scope, strip| words::value(scope.newest(strip).unwrap_or(f64::NAN)));
    view! {
        <dl class="strip-label">
            <dt>{label}</dt>
            <dd class="value">{value}</dd>
            <dd class="unit">{unit}</dd>
        </dl>
        <div class="strip-plot"><canvas node_ref=canvas aria-hidden="true"></canvas></div>
    }
}

/// What to do, as long as nothing has moved.
#[component]
fn FirstSteps() -> impl IntoView {
    view! {
        <div class="first-steps">
            <p>"Nothing has moved yet. Type these three lines into the terminal, each with Enter:"</p>
            <ol class="program">
                <li><code>"10 MDRVEN()"</code><span>"switches the drive on"</span></li>
                <li><code>"20 MMOVE(40960)"</code><span>"moves the axis ten turns"</span></li>
                <li><code>"RUN"</code><span>"starts the program"</span></li>
            </ol>
            <p>"The axis is drawn here while it moves."</p>
        </div>
    }
}
