//! Every scenario in a dedicated worker, where the page runs the simulator.
#![cfg(target_family = "wasm")]

wasm_bindgen_test::wasm_bindgen_test_configure!(run_in_dedicated_worker);

include!(concat!(env!("OUT_DIR"), "/scenarios.rs"));
