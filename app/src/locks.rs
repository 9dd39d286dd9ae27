//! The browser's locks between pages of one site. A lock is let go of when its page is gone, however that happened.

use js_sys::{Object, Promise, Reflect};
use leptos::prelude::window;
use leptos::wasm_bindgen::prelude::*;

#[wasm_bindgen]
extern "C" {
    type Locks;
    #[wasm_bindgen(method)]
    fn request(this: &Locks, name: &str, options: &Object, granted: &JsValue) -> Promise;
}

/// How a lock is held.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Mode {
    /// By one page.
    Exclusive,
    /// By any number of pages.
    Shared,
}

/// Waits for a lock. When it is granted, `granted` says until when it is held. Returns whether the browser has locks:
/// it has none on a page that came over plain http from another machine.
pub fn request(name: &str, mode: Mode, granted: impl FnOnce() -> Promise + 'static) -> bool {
    let navigator = window().navigator();
    let Ok(locks) = Reflect::get(&navigator, &"locks".into()) else {
        return false;
    };
    if !locks.is_object() {
        return false;
    }
    let options = Object::new();
    let mode = match mode {
        Mode::Exclusive => "exclusive",
        Mode::Shared => "shared",
    };
    // A plain object takes any property.
    let _ = Reflect::set(&options, &"mode".into(), &mode.into());
    let granted = Closure::once_into_js(move |_lock: JsValue| granted());
    // It settles when the lock has been let go of, which nobody waits for.
    let _ = locks
        .unchecked_ref::<Locks>()
        .request(name, &options, &granted);
    true
}

/// For as long as the page lives.
pub fn for_ever() -> Promise {
    Promise::new(&mut |_, _| {})
}
