//! The cam table in use, as a curve with the place where the master stands.

use leptos::prelude::*;
use motionbench_core::controller::CamTable;
use motionbench_core::time::Nanos;

use super::popover::Popover;
use crate::protocol::ToWorker;
use crate::state::{Store, words};

/// While the curve is in sight, the controller is asked for it this often, in simulated time.
const ASK: Nanos = Nanos::from_millis(100);
/// Of the drawing, in its own units.
const WIDTH: f64 = 400.0;
const HEIGHT: f64 = 160.0;
/// Points that are drawn: more than there are pixels show nothing more.
const MOST: usize = 400;

/// A button that shows the table.
#[component]
pub(super) fn Cam(store: Store) -> impl IntoView {
    let shown = RwSignal::new(false);
    let moment = Memo::new(move |_| store.device.with(|device| device.now.0 / ASK.0));
    Effect::new(move |_| {
        if shown.get() {
            moment.get();
            store.send(ToWorker::Cam);
        }
    });
    let table = move || match store.cam.get() {
        Some(table) => view! { <Curve table /> }.into_any(),
        None => view! {
            <p class="muted">"No cam table has been used yet: MCAM and MCAMHARD take one."</p>
        }
        .into_any(),
    };
    view! {
        <Popover label=|| "Cam" name="Cam table" on_toggle=Callback::new(move |open| shown.set(open))>
            <div class="cam">{table}</div>
        </Popover>
    }
}

/// The curve.
#[component]
fn Curve(table: CamTable) -> impl IntoView {
    let count = table.points.len();
    let low = table.points.iter().copied().min().unwrap_or(0);
    let high = table.points.iter().copied().max().unwrap_or(0);
    let range = (f64::from(high) - f64::from(low)).max(1.0);
    let x = |at: f64| at / count.max(1) as f64 * WIDTH;
    let y = |value: f64| HEIGHT - (value - f64::from(low)) / range * HEIGHT;
    let every = count.div_ceil(MOST).max(1);
    // The last interval leads to point 0.
    let points = (0..count)
        .step_by(every)
        .map(|index| (index, table.points[index]));
    let path: Vec<String> = points
        .chain([(count, table.points.first().copied().unwrap_or(0))])
        .map(|(index, value)| format!("{:.1},{:.1}", x(index as f64), y(f64::from(value))))
        .collect();
    let summary = format!(
        "{} points, {} to {} counts; the master is at point {}, the axis is to be at {} counts",
        words::number(count as f64, 0),
        words::number(f64::from(low), 0),
        words::number(f64::from(high), 0),
        words::number(table.at, 2),
        words::number(table.demand, 0),
    );
    view! {
        <svg viewBox=format!("-6 -6 {} {}", WIDTH + 12.0, HEIGHT + 12.0) role="img" aria-label=summary.clone()>
            <polyline class="curve" points=path.join(" ") />
            <line class="master" x1=x(table.at) x2=x(table.at) y1="0" y2=HEIGHT />
            <circle class="place" cx=x(table.at) cy=y(table.demand) r="4" />
        </svg>
        <p class="muted figures" aria-hidden="true">{summary}</p>
    }
}
