//! The axis as a thing that moves: a carriage on its track, and the shaft of the motor.

use std::time::Duration;

use leptos::prelude::*;

use super::draw;
use super::io::DriveState;
use crate::clock;
use crate::state::axis;
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

/// The strip above the plots.
#[component]
pub(super) fn Axis(store: Store) -> impl IntoView {
    let seen = look(store);
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
    let scale = Memo::new(move |_| place.get().2);
    let marks = move || {
        let scale = scale.get();
        let mark = |mark: f64| {
            let left = percent((mark - scale.low) / (scale.high - scale.low));
            view! { <span class="mark" style:left=left>{words::short(mark, scale.digits())}</span> }
        };
        scale.marks().map(mark).collect_view()
    };
    // Changes no faster than it can be read.
    let value = RwSignal::new(String::new());
    let say = draw::after(WORDS, move || {
        value.set(words::value(seen.get_untracked().actual))
    });
    Effect::new(move |_| {
        seen.track();
        say();
    });
    let hand = move || format!("rotate({:.1}deg)", axis::angle(seen.get().shaft));
    // Said when it begins and when it ends, not all the way.
    let moving = Memo::new(move |_| seen.get().moving);
    let said = move || {
        if moving.get() {
            "The axis moves.".to_owned()
        } else {
            let at = seen.with_untracked(|seen| words::value(seen.actual));
            format!("The axis stands at {at} counts.")
        }
    };
    view! {
        <div class="axis-strip">
            <div class="dial" aria-hidden="true" title="The shaft of the motor">
                <span class="hand" style:transform=hand></span>
            </div>
            <div class="track" aria-hidden="true">
                {marks}
                <span class="ghost" style:--at=move || format!("{:.4}", place.get().1)></span>
                <span class="carriage" style:--at=move || format!("{:.4}", place.get().0)></span>
            </div>
            <div class="axis-words">
                <p class="position" aria-hidden="true">{value}<span class="muted">" counts"</span></p>
                <DriveState store />
            </div>
            <p class="unseen" role="status">{said}</p>
        </div>
    }
}

/// Follows the axis, as closely as the user likes.
fn look(store: Store) -> Memo<Seen> {
    let last = StoredValue::new(0.0);
    Memo::new(move |before: Option<&Seen>| {
        let moving = store.device.with(|device| {
            let status = device.status.as_ref();
            status.is_some_and(|status| status.moving)
        });
        let now = store.with_scope(|scope| {
            let value = |name| scope.now(name).unwrap_or_default();
            Seen {
                actual: value("x.position"),
                demanded: value("x.command"),
                shaft: value("x.shaft"),
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
