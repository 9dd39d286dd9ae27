//! An incremental encoder with one index mark a revolution.

/// Counts edges of a shaft's position.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Encoder {
    counts_per_revolution: f64,
    revolutions_per_count: f64,
    /// Whole numbers; kept as they come out of the plant, which spares each step a conversion.
    count: f64,
    last_count: f64,
    dead: bool,
}

impl Encoder {
    /// An encoder on a shaft that stands at position 0.
    pub fn new(counts_per_revolution: u32) -> Encoder {
        let counts_per_revolution = f64::from(counts_per_revolution);
        Encoder {
            counts_per_revolution,
            revolutions_per_count: 1.0 / counts_per_revolution,
            count: 0.0,
            last_count: 0.0,
            dead: false,
        }
    }

    /// Reads the shaft, `position` in revolutions.
    #[inline]
    pub fn update(&mut self, position: f64) {
        if self.dead {
            return;
        }
        self.last_count = self.count;
        self.count = (position * self.counts_per_revolution).floor();
    }

    /// Edges counted since position 0.
    #[allow(clippy::cast_possible_truncation)] // whole already, and `as` saturates
    pub fn count(&self) -> i64 {
        self.count as i64
    }

    /// The position that the count stands for, in revolutions.
    #[inline]
    pub fn revolutions(&self) -> f64 {
        self.count * self.revolutions_per_count
    }

    /// Whether the index mark, which is at whole revolutions, was passed by the last update.
    pub fn index(&self) -> bool {
        let turn = |count: f64| (count / self.counts_per_revolution).floor();
        turn(self.count) != turn(self.last_count)
    }

    /// Breaks the encoder, so that its count stands still, or mends it.
    pub fn set_dead(&mut self, dead: bool) {
        self.dead = dead;
        self.last_count = self.count;
    }

    /// Whether the encoder is broken.
    pub fn is_dead(&self) -> bool {
        self.dead
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_are_floors_on_both_sides_of_zero() {
        let mut encoder = Encoder::new(1000);
        for (position, count) in [
            (0.0, 0),
            (0.0009, 0),
            (0.001, 1),
            (-0.0001, -1),
            (-1.0, -1000),
            (2.5, 2500),
        ] {
            encoder.update(position);
            assert_eq!(encoder.count(), count, "{position}");
        }
    }

    #[test]
    fn the_index_shows_once_a_revolution_in_both_directions() {
        let mut encoder = Encoder::new(4);
        let seen = |encoder: &mut Encoder, positions: &mut dyn Iterator<Item = f64>| {
            positions
                .filter(|&position| {
                    encoder.update(position);
                    encoder.index()
                })
                .count()
        };
        assert_eq!(
            seen(&mut encoder, &mut (0..=300).map(|i| f64::from(i) * 0.01)),
            3
        );
        assert_eq!(
            seen(
                &mut encoder,
                &mut (-50..=300).rev().map(|i| f64::from(i) * 0.01)
            ),
            4
        );
    }

    #[test]
    fn a_broken_encoder_stands_still() {
        let mut encoder = Encoder::new(4);
        encoder.update(1.0);
        encoder.set_dead(true);
        encoder.update(2.0);
        assert_eq!(encoder.count(), 4);
        encoder.set_dead(false);
        encoder.update(2.0);
        assert_eq!(encoder.count(), 8);
    }
}
