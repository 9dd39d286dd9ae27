//! The axis as a thing that moves: a carriage on its track, and the shaft of the motor.

use std::time::Duration;

use leptos::prelude::*;

use super::draw;
use super::io::DriveState;
use crate::clock;
use crate::state::axis;
use crate::state::scope::Scale;
use crate::state::{Store, words};

/// Who wants less motion sees the axis at most so often while it moves, ms.
const CALM_MS: f64 = 500.0;

/// The number beside the track changes at most so often.
const WORDS: Duration = Duration::from_millis(100);

/// Where the axis is.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Seen {
    actual: f64,
    demanded: f64,
    shaft: f64,
    moving: bool,
}

/// The strips above the plots, one for each axis.
#[component]
pub(super) fn Axes(store: Store) -> impl IntoView {
    let axes = Memo::new(move |_| {
        store.device.with(|device| device.name.len());
        store.with_scope(|scope| {
            let signals = scope.signals().iter();
            let axes = signals.filter_map(|signal| signal.name.strip_suffix(".position"));
            axes.map(str::to_owned).collect::<Vec<_>>()
        })
    });
    let strips = move || {
        let mut axes = axes.get();
        if axes.is_empty() {
            axes.push("x".to_owned());
        }
        let several = axes.len() > 1;
        let strip = |(place, axis): (usize, String)| {
            let name = several.then(|| axis.to_ascii_uppercase());
            view! { <Axis store axis name first=place == 0 /> }
        };
        axes.into_iter().enumerate().map(strip).collect_view()
    };
    view! { {strips} }
}

/// The strip of an axis, with its name where there are several.
#[component]
fn Axis(store: Store, axis: String, name: Option<String>, first: bool) -> impl IntoView {
    let unit = {
        let position = format!("{axis}.position");
        let unit = store.with_scope(|scope| {
            let mut signals = scope.signals().iter();
            let signal = signals.find(|signal| signal.name == position);
            signal.map(|signal| signal.unit.clone())
        });
        unit.unwrap_or_else(|| "counts".to_owned())
    };
    let seen = look(store, &axis);
    let track = StoredValue::new_local(axis::Track::default());
    let place = Memo::new(move |_| {
        let Seen {
            actual,
            demanded,
            moving,
            ..
        } = seen.get();
        track
            .try_update_value(|track| {
                track.take(actual, demanded, moving);
                (track.place(actual), track.place(demanded), track.scale())
            })
            .unwrap_or_else(|| (0.0, 0.0, axis::Track::default().scale()))
    });
    // Changes no faster than it can be read.
    let value = RwSignal::new(String::new());
    let say = draw::after(WORDS, move || {
        if let Some(seen) = seen.try_get_untracked() {
            value.try_set(words::value(seen.actual));
        }
    });
    Effect::new(move |_| {
        seen.track();
        say();
    });
    let hand = move || format!("rotate({:.1}deg)", axis::angle(seen.get().shaft));
    // Said when it begins and when it ends, not all the way.
    let moving = Memo::new(move |_| seen.get().moving);
    let said = {
        let (name, unit) = (name.clone(), unit.clone());
        move || {
            let at = || seen.with_untracked(|seen| words::value(seen.actual));
            match (&name, moving.get()) {
                (None, true) => "The axis moves.".to_owned(),
                (None, false) => format!("The axis stands at {} {unit}.", at()),
                // That something moves is not to say which.
                (Some(_), true) => String::new(),
                (Some(name), false) => format!("The {name} axis stands at {} {unit}.", at()),
            }
        }
    };
    view! {
        <div class="axis-strip">
            <div class="dial" aria-hidden="true" title="The shaft of the motor">
                <span class="hand" style:transform=hand></span>
                {name.map(|name| view! { <span class="dial-name">{name}</span> })}
            </div>
            <TrackView place />
            <div class="axis-words">
                <p class="position" aria-hidden="true">{value}<span class="muted">" "{unit}</span></p>
                {first.then(|| view! { <DriveState store /> })}
            </div>
            <p class="unseen" role="status">{said}</p>
        </div>
    }
}

/// The track with its marks, the carriage, and where that is to be.
#[component]
fn TrackView(place: Memo<(f64, f64, Scale)>) -> impl IntoView {
    let scale = Memo::new(move |_| place.get().2);
    let marks = move || {
        let scale = scale.get();
        let mark = |mark: f64| {
            let left = percent((mark - scale.low) / (scale.high - scale.low));
            view! { <span class="mark" style:left=left>{words::short(mark, scale.digits())}</span> }
        };
        scale.marks().map(mark).collect_view()
    };
    view! {
        <div class="track" aria-hidden="true">
            {marks}
            <span class="ghost" style:--at=move || format!("{:.4}", place.get().1)></span>
            <span class="carriage" style:--at=move || format!("{:.4}", place.get().0)></span>
        </div>
    }
}

/// Follows the axis, as closely as the user likes.
fn look(store: Store, axis: &str) -> Memo<Seen> {
    let [position, command, shaft] =
        ["position", "command", "shaft"].map(|signal| format!("{axis}.{signal}"));
    let last = StoredValue::new(0.0);
    Memo::new(move |before: Option<&Seen>| {
        let moving = store.device.with(|device| {
            let status = device.status.as_ref();
            status.is_some_and(|status| status.moving)
        });
        let now = store.with_scope(|scope| {
            let value = |name: &str| scope.now(name).unwrap_or_default();
            Seen {
                actual: value(&position),
                demanded: value(&command),
                shaft: value(&shaft),
                moving,
            }
        });
        let early = || clock::now_ms() < last.get_value() + CALM_MS;
        match before {
            Some(before) if before.moving && moving && wants_calm() && early() => *before,
            _ => {
                last.set_value(clock::now_ms());
                now
            }
        }
    })
}

fn percent(part: f64) -> String {
    format!("{:.2}%", part * 100.0)
}

fn wants_calm() -> bool {
    let query = window().match_media("(prefers-reduced-motion: reduce)");
    query.is_ok_and(|query| query.is_some_and(|query| query.matches()))
}
