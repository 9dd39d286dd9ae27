//! The speed of the simulator in the browser; `cargo xtask bench` runs it and reads its line.
#![cfg(target_family = "wasm")]

use wasm_bindgen::prelude::wasm_bindgen;
use wasm_bindgen_test::{console_log, wasm_bindgen_test, wasm_bindgen_test_configure};

// Where the page runs the simulator too.
wasm_bindgen_test_configure!(run_in_dedicated_worker);

#[wasm_bindgen]
extern "C" {
    /// Milliseconds since the worker started.
    #[wasm_bindgen(js_namespace = performance, js_name = now)]
    fn performance_now() -> f64;
}

#[wasm_bindgen_test]
#[ignore = "a measurement, not a check"]
fn speed() {
    let now = || performance_now() * 1e6;
    console_log!("speed report: {}", motionbench::speed::report(None, &now));
}
