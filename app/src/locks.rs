//! The browser's locks between pages of one site. A lock is let go of when its page is gone, however that happened.

use js_sys::{Object, Promise, Reflect};
use leptos::prelude::window;
use leptos::wasm_bindgen::prelude::*;

#[wasm_bindgen]
extern "C" {
    type Locks;
    #[wasm_bindgen(method)]
    fn request(this: &Locks, name: &str, options: &Object, answered: &JsValue) -> Promise;
}

/// How a lock is held.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Mode {
    /// By one page.
    Exclusive,
    /// By one page, if no other has it now.
    IfFree,
    /// By any number of pages.
    Shared,
}

/// Waits for a lock. `answered` hears whether it is granted, which it is but for [`Mode::IfFree`], and says until when it
/// is held. Returns whether the browser has locks: it has none on a page that came over plain http from another machine.
pub fn request(name: &str, mode: Mode, answered: impl FnOnce(bool) -> Promise + 'static) -> bool {
    let navigator = window().navigator();
    let Ok(locks) = Reflect::get(&navigator, &"locks".into()) else {
        return false;
    };
    if !locks.is_object() {
        return false;
    }
    let options = Object::new();
    let kind = match mode {
        Mode::Exclusive | Mode::IfFree => "exclusive",
        Mode::Shared => "shared",
    };
    // A plain object takes any property.
    let _ = Reflect::set(&options, &"mode".into(), &kind.into());
    let _ = Reflect::set(
        &options,
        &"ifAvailable".into(),
        &(mode == Mode::IfFree).into(),
    );
    let answered = Closure::once_into_js(move |lock: JsValue| answered(lock.is_object()));
    // It settles when the lock has been let go of, which nobody waits for.
    let _ = locks
        .unchecked_ref::<Locks>()
        .request(name, &options, &answered);
    true
}

/// For as long as the page lives.
pub fn for_ever() -> Promise {
    Promise::new(&mut |_, _| {})
}
