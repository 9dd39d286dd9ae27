//! Recorded signals in column blocks, bounded.
//!
//! Writing a row only appends numbers. The minima and maxima that a drawing needs are made from sealed blocks when
//! they are first drawn, so any zoom draws in time that depends on the pixels, not on the length of the record.

use std::cell::OnceCell;
use std::collections::VecDeque;

use crate::time::Nanos;

/// Rows in a block.
pub const BLOCK: usize = 1024;
/// Rows that one entry of a block's summary covers.
const GROUP: usize = 32;

/// The recorded signals of one station.
#[derive(Debug, Clone)]
pub struct Trace {
    signals: usize,
    blocks: VecDeque<Block>,
    most_blocks: usize,
}

/// Up to [`BLOCK`] rows, column by column.
#[derive(Debug, Clone)]
struct Block {
    times: Vec<Nanos>,
    columns: Vec<Vec<f64>>,
    /// Per column, the extremes of each [`GROUP`] rows; made when a full block is first drawn.
    summary: OnceCell<Vec<Vec<Extremes>>>,
}

/// The smallest and the largest of some values.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Extremes {
    /// Smallest.
    pub min: f64,
    /// Largest.
    pub max: f64,
}

/// The bits of some values.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Bits {
    /// On in all of them.
    pub all: u32,
    /// On in at least one.
    pub any: u32,
}

impl Extremes {
    const NONE: Extremes = Extremes {
        min: f64::INFINITY,
        max: f64::NEG_INFINITY,
    };

    fn add(&mut self, other: Extremes) {
        self.min = self.min.min(other.min);
        self.max = self.max.max(other.max);
    }

    fn add_value(&mut self, value: f64) {
        self.add(Extremes {
            min: value,
            max: value,
        });
    }
}

impl Trace {
    /// A trace of `signals` columns that keeps at least `rows` rows; the oldest block goes when it is full.
    pub fn new(signals: usize, rows: usize) -> Trace {
        Trace {
            signals,
            blocks: VecDeque::new(),
            most_blocks: rows.div_ceil(BLOCK) + 1,
        }
    }

    /// Appends a row; `values` beyond the columns are ignored and missing ones are not-a-number.
    pub fn push(&mut self, at: Nanos, values: &[f64]) {
        if self
            .blocks
            .back()
            .is_none_or(|block| block.times.len() == BLOCK)
        {
            if self.blocks.len() >= self.most_blocks {
                self.blocks.pop_front();
            }
            self.blocks.push_back(Block::new(self.signals));
        }
        if let Some(block) = self.blocks.back_mut() {
            block.times.push(at);
            for (signal, column) in block.columns.iter_mut().enumerate() {
                column.push(values.get(signal).copied().unwrap_or(f64::NAN));
            }
        }
    }

    /// Rows now held.
    pub fn len(&self) -> usize {
        self.blocks.iter().map(|block| block.times.len()).sum()
    }

    /// Whether nothing is held.
    pub fn is_empty(&self) -> bool {
        self.blocks.is_empty()
    }

    /// Columns.
    pub fn signals(&self) -> usize {
        self.signals
    }

    /// Forgets everything.
    pub fn clear(&mut self) {
        self.blocks.clear();
    }

    /// Times of the oldest and the newest row.
    pub fn span(&self) -> Option<(Nanos, Nanos)> {
        Some((
            *self.blocks.front()?.times.first()?,
            *self.blocks.back()?.times.last()?,
        ))
    }

    /// All rows of one signal, oldest first.
    pub fn rows(&self, signal: usize) -> impl Iterator<Item = (Nanos, f64)> + '_ {
        self.blocks.iter().flat_map(move |block| {
            let values = block
                .columns
                .get(signal)
                .map(Vec::as_slice)
                .unwrap_or_default();
            block.times.iter().copied().zip(values.iter().copied())
        })
    }

    /// The last value of a signal at or before `at`.
    pub fn value(&self, signal: usize, at: Nanos) -> Option<f64> {
        let block = self
            .blocks
            .iter()
            .rev()
            .find(|block| block.times.first().is_some_and(|&first| first <= at))?;
        let row = block
            .times
            .partition_point(|&time| time <= at)
            .checked_sub(1)?;
        block.columns.get(signal)?.get(row).copied()
    }

    /// The extremes of `signal` in each of `buckets` equal parts of `from..to`; `None` where a part holds no row.
    pub fn extremes(
        &self,
        signal: usize,
        from: Nanos,
        to: Nanos,
        buckets: usize,
    ) -> Vec<Option<Extremes>> {
        let mut found = vec![Extremes::NONE; buckets];
        let mut parts = Parts::new(from, to, buckets);
        if to > from && buckets > 0 {
            for block in &self.blocks {
                block.fold(
                    signal,
                    from,
                    to,
                    |at, extremes| {
                        if let Some(found) = found.get_mut(parts.holding(at)) {
                            found.add(extremes);
                        }
                    },
                    Nanos(to.since(from).0 / buckets as u64),
                );
            }
        }
        found
            .into_iter()
            .map(|e| (e.min <= e.max).then_some(e))
            .collect()
    }

    /// Of a signal that holds bits: those that are on all the time, and those that are on some of the time, in each of
    /// `buckets` equal parts of `from..to`; `None` where a part holds no row.
    pub fn bits(&self, signal: usize, from: Nanos, to: Nanos, buckets: usize) -> Vec<Option<Bits>> {
        let mut found: Vec<Option<Bits>> = vec![None; buckets];
        let mut parts = Parts::new(from, to, buckets);
        let within = |block: &&Block| {
            let (first, last) = (block.times.first(), block.times.last());
            first.is_some_and(|&first| first <= to) && last.is_some_and(|&last| last >= from)
        };
        for block in self.blocks.iter().filter(within) {
            let Some(column) = block.columns.get(signal) else {
                continue;
            };
            for (&at, &value) in block.times.iter().zip(column) {
                if at < from || at > to {
                    continue;
                }
                // What is no 32-bit number has no bits that anyone could mean.
                #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // `as` saturates
                let on = value as u32;
                if let Some(found) = found.get_mut(parts.holding(at)) {
                    let bits = found.get_or_insert(Bits { all: on, any: on });
                    bits.all &= on;
                    bits.any |= on;
                }
            }
        }
        found
    }

    /// The time of the row that is nearest to `at`.
    pub fn nearest(&self, at: Nanos) -> Option<Nanos> {
        let before = self.times_to(at);
        let after = self.after(at);
        match (before, after) {
            (Some(before), Some(after)) if after.since(at) < at.since(before) => Some(after),
            (before, after) => before.or(after),
        }
    }

    /// The time of the first row after `at`.
    pub fn after(&self, at: Nanos) -> Option<Nanos> {
        let starts_later = |block: &Block| block.times.last().is_none_or(|&last| last <= at);
        let block = self.blocks.get(self.blocks.partition_point(starts_later))?;
        let row = block.times.partition_point(|&time| time <= at);
        block.times.get(row).copied()
    }

    /// The time of the last row before `at`.
    pub fn before(&self, at: Nanos) -> Option<Nanos> {
        self.times_to(Nanos(at.0.checked_sub(1)?))
    }

    /// The time of the last row at or before `at`.
    fn times_to(&self, at: Nanos) -> Option<Nanos> {
        let starts = |block: &Block| block.times.first().is_some_and(|&first| first <= at);
        let block = self
            .blocks
            .get(self.blocks.partition_point(starts).checked_sub(1)?)?;
        let row = block.times.partition_point(|&time| time <= at);
        block.times.get(row.checked_sub(1)?).copied()
    }
}

/// Equal parts of a time, walked through in order: without a division for each row.
struct Parts {
    from: u128,
    width: u128,
    count: usize,
    part: usize,
    /// The first time that is behind `part`.
    end: Nanos,
}

impl Parts {
    fn new(from: Nanos, to: Nanos, count: usize) -> Parts {
        let mut parts = Parts {
            from: u128::from(from.0),
            width: u128::from(to.since(from).0),
            count,
            part: 0,
            end: Nanos::ZERO,
        };
        parts.end = parts.end_of(0);
        parts
    }

    /// Which part holds `at`, which is not before the time asked for last.
    fn holding(&mut self, at: Nanos) -> usize {
        while at >= self.end && self.part + 1 < self.count {
            self.part += 1;
            self.end = self.end_of(self.part);
        }
        self.part
    }

    fn end_of(&self, part: usize) -> Nanos {
        let count = self.count.max(1) as u128;
        let end = self.from + (self.width * (part as u128 + 1)).div_ceil(count);
        Nanos(u64::try_from(end).unwrap_or(u64::MAX))
    }
}

impl Block {
    fn new(signals: usize) -> Block {
        Block {
            times: Vec::with_capacity(BLOCK),
            // Not `vec![…; signals]`, whose clones have no capacity. The few rows more keep columns from lying a whole
            // page apart, where they would contend for the same cache lines.
            columns: (0..signals)
                .map(|_| Vec::with_capacity(BLOCK + 8))
                .collect(),
            summary: OnceCell::new(),
        }
    }

    /// Calls `each` with the extremes of groups or of single rows within `from..=to`, whichever `resolution` asks for.
    fn fold(
        &self,
        signal: usize,
        from: Nanos,
        to: Nanos,
        mut each: impl FnMut(Nanos, Extremes),
        resolution: Nanos,
    ) {
        let (Some(&first), Some(&last)) = (self.times.first(), self.times.last()) else {
            return;
        };
        if last < from || first > to {
            return;
        }
        let Some(column) = self.columns.get(signal) else {
            return;
        };
        let group_time = last.since(first).0 / (BLOCK / GROUP) as u64;
        let whole =
            self.times.len() == BLOCK && first >= from && last <= to && group_time < resolution.0;
        if whole {
            let summary = self.summary.get_or_init(|| self.summarise());
            let starts = self.times.iter().step_by(GROUP);
            let groups = summary.get(signal).map(Vec::as_slice).unwrap_or_default();
            starts
                .zip(groups)
                .for_each(|(&at, &extremes)| each(at, extremes));
            return;
        }
        for (&at, &value) in self.times.iter().zip(column) {
            if at >= from && at <= to {
                each(
                    at,
                    Extremes {
                        min: value,
                        max: value,
                    },
                );
            }
        }
    }

    fn summarise(&self) -> Vec<Vec<Extremes>> {
        let group = |values: &[f64]| {
            let mut extremes = Extremes::NONE;
            values.iter().for_each(|&value| extremes.add_value(value));
            extremes
        };
        self.columns
            .iter()
            .map(|column| column.chunks(GROUP).map(group).collect())
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ramp(rows: u64) -> Trace {
        let mut trace = Trace::new(1, 1 << 20);
        (0..rows).for_each(|i| trace.push(Nanos(i * 100), &[i as f64]));
        trace
    }

    #[test]
    fn extremes_of_groups_equal_extremes_of_rows() {
        let trace = ramp(10_000);
        for buckets in [1, 7, 40, 300] {
            let found = trace.extremes(0, Nanos(0), Nanos(1_000_000), buckets);
            assert_eq!(found.len(), buckets);
            assert_eq!(found[0].unwrap().min, 0.0);
            assert_eq!(found[buckets - 1].unwrap().max, 9999.0);
            assert!(found.iter().all(Option::is_some));
        }
    }

    #[test]
    fn old_blocks_go_first() {
        let mut trace = Trace::new(1, 2 * BLOCK);
        (0..10 * BLOCK as u64).for_each(|i| trace.push(Nanos(i), &[i as f64]));
        assert!(trace.len() >= 2 * BLOCK && trace.len() <= 3 * BLOCK);
        assert_eq!(trace.span().unwrap().1, Nanos(10 * BLOCK as u64 - 1));
    }

    #[test]
    fn the_value_at_a_time_is_the_last_row_before_it() {
        let trace = ramp(3000);
        assert_eq!(trace.value(0, Nanos(250)), Some(2.0));
        assert_eq!(trace.value(0, Nanos(299_900)), Some(2999.0));
    }

    #[test]
    fn rows_are_found_by_their_time() {
        let trace = ramp(3000);
        assert_eq!(trace.nearest(Nanos(149)), Some(Nanos(100)));
        assert_eq!(trace.nearest(Nanos(151)), Some(Nanos(200)));
        assert_eq!(trace.nearest(Nanos(999_999)), Some(Nanos(299_900)));
        assert_eq!(trace.after(Nanos(102_300)), Some(Nanos(102_400)));
        assert_eq!(trace.after(Nanos(299_900)), None);
        assert_eq!(trace.before(Nanos(102_400)), Some(Nanos(102_300)));
        assert_eq!(trace.before(Nanos(0)), None);
        assert_eq!(Trace::new(1, 10).nearest(Nanos(5)), None);
    }

    #[test]
    fn bits_that_change_within_a_part_are_on_some_of_the_time() {
        let mut trace = Trace::new(1, 100);
        (0..40).for_each(|i| trace.push(Nanos(i), &[f64::from(u8::from(i >= 15)) + 4.0]));
        let found = trace.bits(0, Nanos(0), Nanos(40), 4);
        let bits = |all, any| Some(Bits { all, any });
        assert_eq!(found, [bits(4, 4), bits(4, 5), bits(5, 5), bits(5, 5)]);
        assert_eq!(trace.bits(0, Nanos(50), Nanos(60), 2), [None, None]);
    }
}
