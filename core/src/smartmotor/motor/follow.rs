//! Demands that come from the counter: a ratio without drift, and the cam.

/// Positions are in 1/65536 count.
const ONE: i64 = 1 << 16;

/// Master counts times a ratio. What a division leaves is kept for the next, so nothing is ever lost.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Ratio {
    multiplier: i64,
    /// Not zero.
    divisor: i64,
    /// Left of the last division, in 0..|divisor|.
    remainder: i64,
}

impl Ratio {
    /// A ratio of two 16-bit numbers; a divisor of 0 is 1.
    pub fn new(multiplier: i16, divisor: i16) -> Ratio {
        Ratio {
            multiplier: i64::from(multiplier),
            divisor: if divisor == 0 { 1 } else { i64::from(divisor) },
            remainder: 0,
        }
    }

    /// How far to go for `counts` of the master, in 1/65536 count.
    #[inline]
    pub fn step(&mut self, counts: i64) -> i64 {
        if counts == 0 {
            return 0;
        }
        let scaled = counts * self.multiplier * ONE + self.remainder;
        self.remainder = scaled.rem_euclid(self.divisor);
        scaled.div_euclid(self.divisor)
    }
}

/// A cam: SIZE segments over BASE master counts, straight lines between the points of the table.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Cam {
    /// Master counts of a turn, 1 to [`Cam::LONGEST`].
    base: i64,
    /// Segments, 1 to [`Cam::MOST`].
    size: i64,
    /// MC2, MC4, MC8 stretch the table.
    multiplier: i64,
    /// Master counts since the start.
    master: i64,
    /// Where the cam stood in the last sample, in 1/65536 count.
    last: i64,
}

impl Cam {
    /// Largest BASE.
    pub const LONGEST: i32 = 1 << 24;
    /// Largest SIZE: aw[] ends with aw[100].
    pub const MOST: i32 = 100;

    /// A cam that begins with the first point of its table.
    pub fn new(base: i32, size: i32, multiplier: u8) -> Cam {
        Cam {
            base: i64::from(base.clamp(1, Cam::LONGEST)),
            size: i64::from(size.clamp(1, Cam::MOST)),
            multiplier: i64::from(multiplier),
            master: 0,
            last: 0,
        }
    }

    /// How far to go for `counts` of the master, in 1/65536 count. A table whose ends differ goes on from where a turn
    /// has ended (D178). A change of the table acts at once.
    pub fn step(&mut self, counts: i64, table: impl Fn(u8) -> i16) -> i64 {
        self.master = self.master.wrapping_add(counts);
        let position = self.position(table);
        let moved = position.wrapping_sub(self.last);
        self.last = position;
        moved
    }

    fn position(&self, table: impl Fn(u8) -> i16) -> i64 {
        let point = |index: i64| i64::from(table(u8::try_from(index).unwrap_or(0)));
        let turns = self.master.div_euclid(self.base);
        let place = self.master.rem_euclid(self.base) * self.size;
        let (segment, within) = (place / self.base, place % self.base);
        let start = point(0);
        let from = point(segment);
        let rise = (point(segment + 1) - from) * within * ONE;
        let turn = point(self.size) - start;
        let whole = turns.wrapping_mul(turn).wrapping_add(from - start);
        whole
            .wrapping_mul(ONE)
            .wrapping_add(rise.div_euclid(self.base))
            .wrapping_mul(self.multiplier)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn seventeen_to_twenty_three_does_not_drift_over_ten_million_counts() {
        let mut ratio = Ratio::new(17, 23);
        let (mut master, mut slave, mut step) = (0i64, 0i64, 1);
        while master < 10_000_000 {
            master += step;
            slave += ratio.step(step);
            step = step % 61 + 1;
        }
        assert_eq!(slave, (master * 17 * ONE).div_euclid(23));
        slave += ratio.step(-master);
        assert_eq!(slave, 0);
    }

    proptest! {
        #[test]
        fn a_ratio_never_loses_a_part_of_a_count(
            multiplier in any::<i16>(),
            divisor in any::<i16>().prop_filter("not zero", |d| *d != 0),
            steps in prop::collection::vec(-2000i64..2000, 1..200),
        ) {
            let mut ratio = Ratio::new(multiplier, divisor);
            let slave: i64 = steps.iter().map(|&step| ratio.step(step)).sum();
            let master: i64 = steps.iter().sum();
            let exact = master * i64::from(multiplier) * ONE;
            prop_assert_eq!(slave, exact.div_euclid(i64::from(divisor)));
        }

        #[test]
        fn a_cam_depends_on_the_master_alone(
            base in 1i32..5000,
            size in 1i32..=100,
            points in prop::collection::vec(any::<i16>(), 101),
            steps in prop::collection::vec(-700i64..700, 1..50),
        ) {
            let table = |index: u8| points[usize::from(index)];
            let mut stepped = Cam::new(base, size, 2);
            let way: i64 = steps.iter().map(|&step| stepped.step(step, table)).sum();
            let at_once = Cam::new(base, size, 2).step(steps.iter().sum(), table);
            prop_assert_eq!(way, at_once);
        }
    }

    #[test]
    fn a_cam_meets_its_points_and_is_straight_between_them() {
        let points = [100i16, 300, -100, 100];
        let table = |index: u8| points[usize::from(index)];
        let mut cam = Cam::new(600, 3, 1);
        let at: Vec<i64> = [0, 100, 100, 100, 100, 200, 600]
            .map(|step| cam.step(step, table))
            .iter()
            .scan(0, |position, moved| {
                *position += moved;
                Some(*position / ONE)
            })
            .collect();
        assert_eq!(at, [0, 100, 200, 0, -200, 0, 0]);
    }

    #[test]
    fn a_table_with_different_ends_goes_on() {
        let points = [0i16, 50];
        let mut cam = Cam::new(100, 1, 4);
        assert_eq!(
            cam.step(1000, |index| points[usize::from(index)]),
            2000 * ONE
        );
        assert_eq!(
            cam.step(-1100, |index| points[usize::from(index)]),
            -2200 * ONE
        );
    }
}
