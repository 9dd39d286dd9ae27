//! The speed of the simulator, as ratios to a reference loop on the same machine.
//!
//! `cargo xtask bench` takes the report from `motionbench speed` and, in the browser, from the test in
//! `tests/tests/speed.rs`.

mod motion;
mod programs;
mod reference;

use std::hint::black_box;

use serde_json::{Map, Value, json};

/// Tells the time in nanoseconds since any moment: the runner's clock or the browser's.
pub type Clock<'a> = &'a dyn Fn() -> f64;

/// Measures and returns `{"machine": .., "reference_ns": n, "programs": {"mc600/1": {"ns": n, "ratio": r}, ..},
/// "motion": {"32x2kHz": {"ns_per_axis_sample": n, "times_real_time": n}, ..}, "authentic": {"mc600/1":
/// {"times_real_time": n}}}`, where `only` limits all three to the names that contain it.
///
/// Programs are measured at `speed=fast`, per innermost pass and without what they take to start. A ratio is to the
/// reference loop, measured beside the program. `authentic` tells how much faster than the device's own pace a program
/// runs when its statements take their time.
pub fn report(only: Option<&str>, now: Clock) -> Value {
    let wanted = |name: &str| only.is_none_or(|only| name.contains(only));
    let reference = Loop::calibrate(now, |n| {
        black_box(reference::run(n));
    });
    let reference_ns = median((0..ROUNDS).map(|_| reference.ns_per_pass(now)));
    let programs = programs::PROGRAMS
        .iter()
        .filter(|program| wanted(program.name));
    let measured: Map<String, Value> = programs
        .map(|program| {
            (
                program.name.to_owned(),
                program_speed(program, &reference, now),
            )
        })
        .collect();
    let rigs = motion::RIGS.iter().filter(|(name, _)| wanted(name));
    let motion: Map<String, Value> = rigs
        .map(|&(name, axes)| (name.to_owned(), motion_speed(axes, now)))
        .collect();
    let first = &programs::PROGRAMS[0];
    let authentic: Map<String, Value> = [first]
        .into_iter()
        .filter(|program| wanted(program.name))
        .map(|program| (program.name.to_owned(), authentic_speed(program, now)))
        .collect();
    json!({
        "machine": machine(),
        "reference_ns": reference_ns,
        "programs": measured,
        "motion": motion,
        "authentic": authentic,
    })
}

fn machine() -> String {
    format!("{} {}", std::env::consts::ARCH, std::env::consts::OS)
}

fn program_speed(program: &programs::Program, reference: &Loop<impl Fn(u32)>, now: Clock) -> Value {
    if program.run(1, "fast").is_none() {
        return json!({ "error": "it does not compute what it should" });
    }
    let passes = Loop::calibrate(now, |n| {
        black_box(program.run(n, "fast"));
    });
    let per_n = program.passes(1);
    // Both in each round: the machine is not equally fast all the time.
    let rounds: Vec<(f64, f64)> = (0..ROUNDS)
        .map(|_| {
            let ns = passes.ns_per_pass(now) / per_n;
            (ns, ns / reference.ns_per_pass(now))
        })
        .collect();
    json!({
        "ns": median(rounds.iter().map(|round| round.0)),
        "ratio": median(rounds.iter().map(|round| round.1)),
    })
}

fn motion_speed(axes: u32, now: Clock) -> Value {
    let samples = Loop::calibrate(now, |n| {
        black_box(motion::run(axes, n));
    });
    let ns = median((0..ROUNDS).map(|_| samples.ns_per_pass(now))) / f64::from(axes);
    json!({
        "ns_per_axis_sample": ns,
        "times_real_time": 1e9 / (ns * motion::axis_samples(axes)),
    })
}

/// Simulated time over the time that it took, for a run of some minutes.
fn authentic_speed(program: &programs::Program, now: Clock) -> Value {
    const PASSES: u32 = 200_000;
    let round = || {
        let start = now();
        let simulated = program.run(PASSES, "authentic");
        simulated.map_or(f64::NAN, |simulated| {
            simulated.seconds() * 1e9 / (now() - start)
        })
    };
    json!({ "times_real_time": median((0..ROUNDS).map(|_| round())) })
}

const ROUNDS: usize = 7;
/// Long against the steps of a browser's clock, 0.005 to 0.1 ms.
const ROUND_NS: f64 = 60e6;

/// Something that repeats a pass as often as it is told.
struct Loop<F> {
    run: F,
    /// Passes that take long enough for the clock.
    passes: u32,
}

impl<F: Fn(u32)> Loop<F> {
    /// Finds how many passes are long enough.
    fn calibrate(now: Clock, run: F) -> Loop<F> {
        let mut found = Loop { run, passes: 16 };
        while found.timed(now, found.passes) < ROUND_NS && found.passes < u32::MAX / 2 {
            found.passes *= 2;
        }
        found
    }

    fn timed(&self, now: Clock, passes: u32) -> f64 {
        let start = now();
        (self.run)(passes);
        now() - start
    }

    /// What a pass costs, without what one pass alone costs to start.
    fn ns_per_pass(&self, now: Clock) -> f64 {
        let start = self.timed(now, 1);
        (self.timed(now, self.passes) - start) / f64::from(self.passes - 1)
    }
}

fn median(values: impl Iterator<Item = f64>) -> f64 {
    let mut values: Vec<f64> = values.collect();
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(f64::NAN)
}
