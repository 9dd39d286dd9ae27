//! What turns outside on pins A and B: an encoder, or steps with a direction; and the counter that a program sees.

/// Edges a revolution of the encoder outside, all four of a cycle counted.
pub const ENCODER_COUNTS: f64 = 2000.0;
/// Fastest that the counter follows, in edges or steps a second.
const FASTEST: f64 = 4e6;

/// How the counter takes what comes in.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Counting {
    /// The pins are plain; the counter stands.
    Stopped,
    /// An encoder, with 1, 2 or 4 counts a cycle.
    Quadrature(u8),
    /// Steps on A; B is the direction.
    Steps,
}

/// The counter `CTR` and the world that it counts.
#[derive(Debug, Clone, PartialEq)]
pub struct Counter {
    /// How it counts.
    pub counting: Counting,
    /// Of the encoder outside, in edges a sample.
    encoder_speed: f64,
    /// Steps a sample.
    step_rate: f64,
    /// Edges and steps so far, with fractions; whole ones have been counted.
    encoder: f64,
    steps: f64,
    /// Of the present counting since it began, in edges (not yet divided by 1, 2 or 4) or steps.
    raw: i64,
    /// `CTR`.
    count: i64,
}

impl Counter {
    /// Nothing turns, nothing counts.
    pub fn new() -> Counter {
        Counter {
            counting: Counting::Stopped,
            encoder_speed: 0.0,
            step_rate: 0.0,
            encoder: 0.0,
            steps: 0.0,
            raw: 0,
            count: 0,
        }
    }

    /// As at power-up; what turns outside goes on turning.
    pub fn reset(&mut self) {
        self.counting = Counting::Stopped;
        self.raw = 0;
        self.count = 0;
    }

    /// Counts like this from now on; the count goes on.
    pub fn count_by(&mut self, counting: Counting) {
        if counting != self.counting {
            self.counting = counting;
            self.raw = 0;
        }
    }

    /// Counts from 0.
    pub fn zero(&mut self) {
        self.count = 0;
    }

    /// The speed of the encoder outside in rpm, for samples of `period` seconds.
    pub fn turn(&mut self, rpm: f64, period: f64) {
        self.encoder_speed = (rpm / 60.0 * ENCODER_COUNTS).clamp(-FASTEST, FASTEST) * period;
    }

    /// Steps a second, negative with the direction reversed.
    pub fn step(&mut self, rate: f64, period: f64) {
        self.step_rate = rate.clamp(-FASTEST, FASTEST) * period;
    }

    /// One sample of the world; how much the counter moved.
    #[inline]
    pub fn sample(&mut self) -> i64 {
        if self.encoder_speed == 0.0 && self.step_rate == 0.0 {
            return 0;
        }
        let edges = advance(&mut self.encoder, self.encoder_speed);
        let steps = advance(&mut self.steps, self.step_rate);
        let per_count = match self.counting {
            Counting::Stopped => return 0,
            Counting::Steps => 1,
            Counting::Quadrature(counts) => 4 / i64::from(counts.clamp(1, 4)),
        };
        let came = if self.counting == Counting::Steps {
            steps
        } else {
            edges
        };
        let before = self.raw.div_euclid(per_count);
        self.raw = self.raw.wrapping_add(came);
        let moved = self.raw.div_euclid(per_count).wrapping_sub(before);
        self.count = self.count.wrapping_add(moved);
        moved
    }

    /// `CTR`.
    pub fn count(&self) -> i64 {
        self.count
    }
}

/// Moves on and gives the whole units passed; what is left stays a small number, so that none is ever lost.
#[allow(clippy::cast_possible_truncation)] // whole, and bounded by `FASTEST`
fn advance(place: &mut f64, speed: f64) -> i64 {
    let moved = *place + speed;
    let whole = moved.floor();
    *place = moved - whole;
    whole as i64
}

#[cfg(test)]
mod tests {
    use super::*;

    const PERIOD: f64 = 245.76e-6;

    fn run(counter: &mut Counter, samples: u32) -> i64 {
        (0..samples).map(|_| counter.sample()).sum()
    }

    #[test]
    fn counts_one_two_or_four_a_cycle() {
        for (counts, expected) in [(4, 20_000), (2, 10_000), (1, 5_000)] {
            let mut counter = Counter::new();
            counter.count_by(Counting::Quadrature(counts));
            counter.turn(600.0, PERIOD);
            run(&mut counter, 4069);
            assert!(
                (counter.count() - expected).abs() <= 2,
                "{}",
                counter.count()
            );
            counter.turn(-600.0, PERIOD);
            run(&mut counter, 4069);
            assert!(counter.count().abs() <= 1);
        }
    }

    #[test]
    fn pins_that_are_plain_do_not_count() {
        let mut counter = Counter::new();
        counter.turn(600.0, PERIOD);
        counter.step(1000.0, PERIOD);
        assert_eq!(run(&mut counter, 4069), 0);
        counter.count_by(Counting::Steps);
        assert!((run(&mut counter, 4069) - 1000).abs() <= 1);
    }
}
