#![no_main]

#[path = "../../tests/src/fuzz.rs"]
#[allow(dead_code)]
mod fuzz;

libfuzzer_sys::fuzz_target!(|data: &[u8]| fuzz::unidex3_text(data));
