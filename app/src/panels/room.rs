//! How much room an element has.

use js_sys::Array;
use leptos::prelude::*;
use leptos::wasm_bindgen::prelude::*;
use web_sys::{Element, ResizeObserver, ResizeObserverEntry};

/// Calls `tell` with the width and height of an element's content box, in CSS pixels, now and whenever they change,
/// until the component that asks is gone.
pub(super) fn watch(element: &Element, tell: impl Fn(f64, f64) + 'static) {
    let changed = Closure::<dyn Fn(Array)>::new(move |entries: Array| {
        for entry in entries.iter() {
            let room = entry.unchecked_into::<ResizeObserverEntry>().content_rect();
            tell(room.width(), room.height());
        }
    });
    if let Ok(observer) = ResizeObserver::new(changed.into_js_value().unchecked_ref()) {
        observer.observe(element);
        let observer = StoredValue::new_local(observer);
        on_cleanup(move || observer.with_value(ResizeObserver::disconnect));
    }
}
