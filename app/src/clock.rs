//! Time on the wall, for what happens in the user's day and not in the simulation: when work was kept, when to look
//! for a newer version.

use std::future::{Future, poll_fn};
use std::pin::pin;
use std::task::Poll;

use gloo_timers::callback::{Interval, Timeout};
use gloo_timers::future::TimeoutFuture;
use js_sys::Date;
use wasm_bindgen::JsValue;

/// A call to come; dropped, it does not come.
pub type Timer = Timeout;

/// Milliseconds since 1970.
pub fn now_ms() -> f64 {
    Date::now()
}

/// The time of day where the user is: `14:03`.
pub fn time_of_day(at_ms: f64) -> String {
    let date = Date::new(&JsValue::from(at_ms));
    format!("{:02}:{:02}", date.get_hours(), date.get_minutes())
}

/// The day and the time of day where the user is: `2026-03-09 14:03`.
pub fn day_and_time(at_ms: f64) -> String {
    let date = Date::new(&JsValue::from(at_ms));
    let (year, month, day) = (date.get_full_year(), date.get_month() + 1, date.get_date());
    format!("{year}-{month:02}-{day:02} {}", time_of_day(at_ms))
}

/// Calls once, so many milliseconds from now; not if what this gives is dropped before.
pub fn after(ms: u32, call: impl FnOnce() + 'static) -> Timer {
    Timeout::new(ms, call)
}

/// Calls again and again, every so many milliseconds, for as long as the page lives.
pub fn every(ms: u32, call: impl FnMut() + 'static) {
    Interval::new(ms, call).forget();
}

/// What `future` gives within so many milliseconds.
pub async fn within<T>(ms: u32, future: impl Future<Output = T>) -> Option<T> {
    let (mut future, mut timeout) = (pin!(future), pin!(TimeoutFuture::new(ms)));
    poll_fn(|context| match future.as_mut().poll(context) {
        Poll::Ready(value) => Poll::Ready(Some(value)),
        Poll::Pending => timeout.as_mut().poll(context).map(|()| None),
    })
    .await
}
