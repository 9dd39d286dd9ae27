//! The seeds of the fuzzers, as ordinary tests: `fuzz/README.md`.
#![cfg(not(target_family = "wasm"))]

use motionbench_tests::fuzz::TARGETS;
use motionbench_tests::seeds::seeds;

fn replay(target: &str) {
    let (_, run) = TARGETS.iter().find(|(name, _)| *name == target).unwrap();
    let seeds = seeds(target);
    assert!(seeds.len() > 100, "{} seeds", seeds.len());
    for (name, bytes) in &seeds {
        let held = std::panic::catch_unwind(|| run(bytes));
        assert!(held.is_ok(), "{target}: {name}");
    }
    // Every text cut short somewhere, too.
    for (index, (name, bytes)) in seeds.iter().enumerate() {
        let cut = bytes.len() * (index % 7 + 1) / 8;
        let held = std::panic::catch_unwind(|| run(&bytes[..cut]));
        assert!(held.is_ok(), "{target}: the first {cut} bytes of {name}");
    }
}

#[test]
fn mc600_text() {
    replay("mc600_text");
}

#[test]
fn mc600_console() {
    replay("mc600_console");
}

#[test]
fn smartmotor_text() {
    replay("smartmotor_text");
}

#[test]
fn smartmotor_serial() {
    replay("smartmotor_serial");
}

#[test]
fn unidex3_text() {
    replay("unidex3_text");
}

#[test]
fn unidex3_keys() {
    replay("unidex3_keys");
}

#[test]
fn scenario() {
    replay("scenario");
}
