//! How simulated time follows the clock on the wall. Nothing else in the project knows that clock.

use std::collections::VecDeque;

use motionbench_core::time::Nanos;
use wasm_bindgen::JsCast;
use web_sys::WorkerGlobalScope;

use crate::protocol::Speed;

/// Slowest and fastest factor.
const SLOWEST: f64 = 0.01;
const FASTEST: f64 = 100.0;
/// Simulation that is further behind than this, ms, has lost the time: a computer that slept, or is too slow, does
/// not make up for it later.
const MOST_BEHIND_MS: f64 = 100.0;
/// The speed reached is measured over this time, ms.
const MEASURED_MS: f64 = 500.0;

/// The time on the wall, in ms since the worker started.
pub fn wall_ms() -> f64 {
    let global: WorkerGlobalScope = js_sys::global().unchecked_into();
    global.performance().map_or(0.0, |clock| clock.now())
}

/// Keeps simulated time in step with the wall.
#[derive(Debug, Clone)]
pub struct Pacing {
    speed: Speed,
    /// Wall time and simulated time of one moment from which the rest follows.
    anchor: (f64, Nanos),
    /// Where simulation stood when, oldest first; the first entry is at most a little older than what is measured.
    past: VecDeque<(f64, Nanos)>,
}

impl Pacing {
    /// At the device's own speed from here on.
    pub fn new(wall_ms: f64, now: Nanos) -> Pacing {
        Pacing {
            speed: Speed::Times(1.0),
            anchor: (wall_ms, now),
            past: VecDeque::from([(wall_ms, now)]),
        }
    }

    /// Another speed from here on; factors are brought into 0.01 to 100.
    pub fn set(&mut self, speed: Speed, wall_ms: f64, now: Nanos) {
        self.speed = match speed {
            Speed::Times(factor) if factor.is_nan() => Speed::Times(1.0),
            Speed::Times(factor) => Speed::Times(factor.clamp(SLOWEST, FASTEST)),
            Speed::Max => Speed::Max,
        };
        self.go_on(wall_ms, now);
    }

    /// Counts from here on, as if no time had passed before.
    pub fn go_on(&mut self, wall_ms: f64, now: Nanos) {
        self.anchor = (wall_ms, now);
        self.past = VecDeque::from([(wall_ms, now)]);
    }

    /// How far simulated time, which stands at `now`, may go.
    pub fn goal(&mut self, wall_ms: f64, now: Nanos) -> Nanos {
        let Speed::Times(factor) = self.speed else {
            return Nanos::MAX;
        };
        let (start, from) = self.anchor;
        let goal = from + Nanos::from_seconds((wall_ms - start) / 1e3 * factor);
        let most_behind = Nanos::from_seconds(MOST_BEHIND_MS / 1e3 * factor);
        if goal <= now + most_behind {
            return goal;
        }
        self.anchor = (wall_ms, now + most_behind);
        now + most_behind
    }

    /// Simulated seconds a second, measured over the last half second.
    pub fn reached(&mut self, wall_ms: f64, now: Nanos) -> f64 {
        self.past.push_back((wall_ms, now));
        while self
            .past
            .get(1)
            .is_some_and(|&(at, _)| at <= wall_ms - MEASURED_MS)
        {
            self.past.pop_front();
        }
        match self.past.front() {
            Some(&(at, stood)) if wall_ms > at => {
                now.since(stood).seconds() / ((wall_ms - at) / 1e3)
            }
            _ => 0.0,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Simulates as `pacing` allows for `ms` of wall time in steps of 5 ms; returns where it got.
    fn follow(pacing: &mut Pacing, mut now: Nanos, from_ms: f64, ms: f64) -> Nanos {
        let mut wall = from_ms;
        while wall < from_ms + ms {
            wall += 5.0;
            now = now.max(pacing.goal(wall, now));
            pacing.reached(wall, now);
        }
        now
    }

    #[test]
    fn simulated_time_passes_by_the_factor() {
        for factor in [0.01, 0.5, 1.0, 100.0] {
            let mut pacing = Pacing::new(0.0, Nanos::ZERO);
            pacing.set(Speed::Times(factor), 0.0, Nanos::ZERO);
            let now = follow(&mut pacing, Nanos::ZERO, 0.0, 2000.0);
            assert!(
                (now.seconds() - 2.0 * factor).abs() < 1e-9,
                "{factor}: {now:?}"
            );
            let reached = pacing.reached(2000.0, now);
            assert!((reached / factor - 1.0).abs() < 1e-6, "{factor}: {reached}");
        }
    }

    #[test]
    fn a_new_speed_counts_from_when_it_was_set() {
        let mut pacing = Pacing::new(0.0, Nanos::ZERO);
        let now = follow(&mut pacing, Nanos::ZERO, 0.0, 1000.0);
        pacing.set(Speed::Times(10.0), 1000.0, now);
        let now = follow(&mut pacing, now, 1000.0, 1000.0);
        assert!((now.seconds() - 11.0).abs() < 1e-9, "{now:?}");
    }

    #[test]
    fn a_computer_that_slept_does_not_catch_up() {
        let mut pacing = Pacing::new(0.0, Nanos::ZERO);
        let now = follow(&mut pacing, Nanos::ZERO, 0.0, 1000.0);
        let now = follow(&mut pacing, now, 3_600_000.0, 1000.0);
        assert!(now.seconds() < 2.2, "{now:?}");
    }

    #[test]
    fn factors_out_of_range_are_brought_in() {
        let mut pacing = Pacing::new(0.0, Nanos::ZERO);
        pacing.set(Speed::Times(1e9), 0.0, Nanos::ZERO);
        assert_eq!(pacing.goal(10.0, Nanos::ZERO), Nanos::from_millis(1000));
        pacing.set(Speed::Times(-1.0), 0.0, Nanos::ZERO);
        assert_eq!(pacing.goal(10.0, Nanos::ZERO), Nanos::from_micros(100));
        pacing.set(Speed::Max, 0.0, Nanos::ZERO);
        assert_eq!(pacing.goal(0.0, Nanos::ZERO), Nanos::MAX);
    }
}
