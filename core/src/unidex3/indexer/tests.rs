//! What a user can see of the axes, without the interpreter in between.

mod accuracy;
mod interrupts;
mod limits;
mod motion;

use super::*;
use command::{Leg, Ramp};

/// A unit on the bench, and its time.
struct Unit {
    indexer: Indexer,
    now: Nanos,
}

impl Unit {
    fn new(drive: DriveKind) -> Unit {
        Unit::of(Config {
            drive,
            ..Config::default()
        })
    }

    fn of(config: Config) -> Unit {
        let mut indexer = Indexer::new(config);
        indexer.power_up(Nanos::ZERO);
        Unit {
            indexer,
            now: Nanos::ZERO,
        }
    }

    fn dc() -> Unit {
        Unit::new(DriveKind::Dc)
    }

    fn stepper() -> Unit {
        Unit::new(DriveKind::StepperLow)
    }

    fn start(&mut self, order: Move) {
        self.indexer.start(self.now, &order);
    }

    /// Whole milliseconds of samples.
    fn run(&mut self, milliseconds: u64) {
        for _ in 0..milliseconds {
            self.sample();
        }
    }

    fn sample(&mut self) {
        self.now += Nanos::from_millis(1);
        self.indexer.sample(self.now);
    }

    /// Seconds until the indexer says so, at most an hour.
    fn until(&mut self, done: impl Fn(&Indexer) -> bool) -> f64 {
        let begin = self.now;
        while !done(&self.indexer) {
            self.sample();
            assert!(self.now.since(begin) < Nanos::from_millis(3_600_000));
        }
        self.now.since(begin).seconds()
    }

    /// Seconds from the order to the last pulse.
    fn time(&mut self, order: Move) -> f64 {
        let begin = self.now;
        self.start(order);
        self.until(|indexer| indexer.is_complete(true));
        self.indexer.finished_at().since(begin).seconds()
    }

    fn wire(&mut self, name: &str, value: f64) {
        self.indexer.wire(self.now, name, value).unwrap();
    }

    fn fault(&mut self, kind: &str, axis: &str, active: bool) {
        let done = self.indexer.fault(self.now, kind, Some(axis), active);
        done.unwrap();
    }

    fn configure(&mut self, axis: &str, key: &str, value: &str) {
        let done = self.indexer.configure(self.now, axis, key, value);
        done.unwrap();
    }

    fn registers(&self) -> (i64, i64) {
        (
            self.indexer.register(Axis::X),
            self.indexer.register(Axis::Y),
        )
    }

    fn tracking(&self) -> (i64, i64) {
        (
            self.indexer.tracking(Axis::X),
            self.indexer.tracking(Axis::Y),
        )
    }

    fn events(&mut self) -> Vec<Event> {
        std::iter::from_fn(|| self.indexer.take_event())
            .map(|(_, event)| event)
            .collect()
    }
}

fn leg(steps: i64, steps_per_second: u32) -> Leg {
    Leg {
        steps,
        feedrate: Feedrate::frequency(steps_per_second).unwrap(),
    }
}

fn x(steps: i64, steps_per_second: u32) -> Move {
    Move::independent(Some(leg(steps, steps_per_second)), None, None)
}
