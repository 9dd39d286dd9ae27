//! The scope: strips of what was recorded, on one time axis.

use std::time::Duration;

use leptos::html;
use leptos::prelude::*;
use web_sys::HtmlCanvasElement;

use super::{draw, room};
use crate::state::Store;
use crate::state::scope::{Scope as State, Strip, folded};

mod controls;
mod cursors;
mod export;
mod fine;
mod gestures;
mod plot;
mod strip;

use controls::Controls;
use cursors::Cursors;
use plot::{Colors, Surface};
use strip::StripView;

/// Heights as in the style sheet, in the page's own size of text: of a strip with its plot at least, of one without,
/// for the mouse and for fingers, and of the time axis.
const STRIP: f64 = 5.0;
const FOLDED: f64 = 2.0;
const FOLDED_TOUCHED: f64 = 2.75;
const TIME_AXIS: f64 = 1.75;
/// Where fingers are to be expected, as in the style sheet.
const TOUCHED: &str = "(max-width: 43.75rem), (pointer: coarse)";

/// Words beside the plots change at most so often: no one reads faster.
const WORDS: Duration = Duration::from_millis(100);

/// The canvases that are in the page, by the names of their strips, and what has them and the words beside them
/// follow.
#[derive(Clone, Copy)]
struct Sheets {
    strips: StoredValue<Vec<(String, HtmlCanvasElement)>, LocalStorage>,
    time: NodeRef<html::Canvas>,
    /// Grows when there is other room.
    changed: RwSignal<u64>,
    /// Grows when there may be other words.
    words: RwSignal<u64>,
}

impl Sheets {
    fn new() -> Sheets {
        Sheets {
            strips: StoredValue::new_local(Vec::new()),
            time: NodeRef::new(),
            changed: RwSignal::new(0),
            words: RwSignal::new(0),
        }
    }

    /// Reads what the user chooses.
    fn choice<T: PartialEq + Send + Sync + 'static>(
        store: Store,
        read: impl Fn(&State) -> T + Send + Sync + 'static,
    ) -> Memo<T> {
        Memo::new(move |_| {
            store.chosen.track();
            store.with_scope(&read)
        })
    }

    /// Reads what changes with the samples too, as often as it can be read.
    fn word<T: PartialEq + Send + Sync + 'static>(
        self,
        store: Store,
        read: impl Fn(&State) -> T + Send + Sync + 'static,
    ) -> Memo<T> {
        Memo::new(move |_| {
            store.chosen.track();
            self.words.track();
            store.with_scope(&read)
        })
    }

    /// Fits a canvas to the room that its frame has, now and when it changes.
    fn fit(self, canvas: HtmlCanvasElement) {
        // Its frame, not the canvas itself, whose size follows what is drawn.
        let Some(frame) = canvas.parent_element() else {
            return;
        };
        room::watch(&frame, move |width, height| {
            plot::fit(&canvas, width, height);
            self.changed.update(|count| *count += 1);
        });
    }
}

/// The scope.
#[component]
pub(super) fn Scope(store: Store) -> impl IntoView {
    let sheets = Sheets::new();
    let draw = draw::before_paint(move || draw(store, sheets));
    sheets.time.on_load(move |canvas| sheets.fit(canvas));
    plot::on_color_scheme(draw.clone());
    let say = draw::after(WORDS, move || sheets.words.update(|count| *count += 1));
    Effect::new(move |_| {
        store.recorded.track();
        sheets.changed.track();
        draw();
        say();
    });
    let scroller = NodeRef::<html::Div>::new();
    let height = RwSignal::new(0.0);
    scroller.on_load(move |element| {
        room::watch(&element, move |_, now| height.set(now / rem()));
    });
    let folds = Memo::new(move |_| {
        store.chosen.track();
        store.with_scope(|scope| folds(scope.strips(), height.get()))
    });
    let names = Memo::new(move |_| {
        folds.with(|folds| {
            folds
                .iter()
                .map(|(name, _)| name.clone())
                .collect::<Vec<_>>()
        })
    });
    let shown = sheets.word(store, |scope| scope.view().is_some());
    let over = NodeRef::<html::Div>::new();
    view! {
        <section class="panel scope" aria-labelledby="scope-title">
            <header class="panel-head">
                <h2 id="scope-title">"Scope"</h2>
                <Show when=move || store.kind().has_cam><super::cam::Cam store /></Show>
                <Controls store sheets />
            </header>
            <super::axis::Axes store />
            <div class="scope-view">
            <div class="scope-room" node_ref=scroller>
                <div class="strips">
                    <For each=move || names.get() key=String::clone let:name>
                        <StripView store sheets folds name />
                    </For>
                    <div class="strip time">
                        <cursors::Between store />
                        <div class="axis"><canvas node_ref=sheets.time aria-hidden="true"></canvas></div>
                    </div>
                    <gestures::Plots store over>
                        <Cursors store over />
                    </gestures::Plots>
                    <Show when=move || !shown.get()><FirstSteps store /></Show>
                </div>
            </div>
            <gestures::Again store />
            </div>
            <super::io::Io store />
        </section>
    }
}

/// The page's own size of text, CSS pixels.
fn rem() -> f64 {
    Colors::of_page().map_or(16.0, |colors| colors.rem)
}

/// The strips by name, and which are folded in a room of this height.
fn folds(strips: &[Strip], height: f64) -> Vec<(String, bool)> {
    let touched = window().match_media(TOUCHED).ok().flatten();
    let touched = touched.is_some_and(|query| query.matches());
    let folded_height = if touched { FOLDED_TOUCHED } else { FOLDED };
    let room = height - TIME_AXIS - folded_height * strips.len() as f64;
    let plots = (room / (STRIP - folded_height)).max(0.0) as usize;
    let names = strips.iter().map(|strip| strip.name.clone());
    names.zip(folded(strips, plots)).collect()
}

/// Draws all that is in sight.
fn draw(store: Store, sheets: Sheets) {
    let Some(colors) = Colors::of_page() else {
        return;
    };
    store.with_scope(|scope| {
        let Some(view) = scope.view() else { return };
        sheets.strips.with_value(|strips| {
            for (name, canvas) in strips {
                let (Some(strip), Some(surface)) =
                    (scope.strip(name), Surface::of(canvas, &colors))
                else {
                    continue;
                };
                let picture = scope.picture(strip, view, surface.columns(), surface.marks());
                if let Some(picture) = picture {
                    plot::strip(&surface, view.scale(), &picture, &colors);
                }
            }
        });
        let time = sheets.time.get_untracked();
        if let Some(surface) = time.and_then(|canvas| Surface::of(&canvas, &colors)) {
            plot::time_axis(&surface, view.scale(), &colors);
        }
    });
}

/// What is what, as long as nothing has moved.
#[component]
fn FirstSteps(store: Store) -> impl IntoView {
    let other_way = move || match store.kind().face {
        Some(_) => "Or press the keys of its front panel: First steps, above it, says which. ",
        None => {
            "The terminal is the controller's console: there you can type to it; Help says what. "
        }
    };
    view! {
        <div class="first-steps">
            <p><strong>"Nothing has moved yet: press Run."</strong></p>
            <p>"Run gives the program to the controller, which is simulated in this page, and starts it. "
                {other_way} "What the axis does is drawn here."</p>
        </div>
    }
}
