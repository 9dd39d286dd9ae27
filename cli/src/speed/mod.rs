//! The speed of the simulator, as ratios to a reference loop on the same machine.

mod reference;

use std::hint::black_box;

use serde_json::{Value, json};

/// Tells the time in nanoseconds since any moment: the runner's clock or the browser's.
pub type Clock<'a> = &'a dyn Fn() -> f64;

/// Measures and returns `{"machine": .., "reference_ns": n, "programs": {"mc600/1": {"ns": n,
/// "ratio": r}, ..}, "motion": {"32x2kHz": {"ns_per_axis_sample": n, "times_real_time": n}, ..}}`,
/// where `only` limits programs and motion to the names that contain it.
pub fn report(_only: Option<&str>, now: Clock) -> Value {
    let reference_ns = per_pass(now, reference::run);
    json!({
        "machine": machine(),
        "reference_ns": reference_ns,
        "programs": {},
        "motion": {},
    })
}

fn machine() -> String {
    format!("{} {}", std::env::consts::ARCH, std::env::consts::OS)
}

const ROUNDS: usize = 7;
/// Long against the steps of a browser's clock, 0.005 to 0.1 ms.
const ROUND_NS: f64 = 100e6;

/// Nanoseconds per pass of `run`, which makes as many passes as it is asked for and returns
/// a result: the median of some rounds, each long enough for the clock.
fn per_pass(now: Clock, mut run: impl FnMut(u32) -> f64) -> f64 {
    let mut timed = |passes: u32| {
        let start = now();
        black_box(run(passes));
        now() - start
    };
    let mut passes = 1_000;
    while timed(passes) < ROUND_NS && passes < u32::MAX / 2 {
        passes *= 2;
    }
    let mut rounds: Vec<f64> = (0..ROUNDS)
        .map(|_| timed(passes) / f64::from(passes))
        .collect();
    rounds.sort_by(f64::total_cmp);
    rounds[ROUNDS / 2]
}
