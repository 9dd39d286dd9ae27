//! `mspline`: a natural cubic spline through pairs of positions, as a cam table.
//!
//! Source: "mspline(xy%,np%,camtab%)". Only `+ - * /`, so every machine gives the same bits.

/// Entries of the table.
pub const ENTRIES: usize = 360;

/// The last pair has at least this number.
pub const LEAST_LAST: i32 = 7;

/// The table through `pairs` of master and follower, or `None` if the master's positions decrease, do not begin with
/// (0, 0) or do not go anywhere. Entry i stands at i/360 of the last master position; a pair with the master position of
/// the one before it is passed over (D216).
pub fn spline(pairs: &[(i32, i32)]) -> Option<Vec<i32>> {
    if pairs.first() != Some(&(0, 0)) {
        return None;
    }
    let mut points: Vec<(f64, f64)> = Vec::new();
    for &(x, y) in pairs {
        let (x, y) = (f64::from(x), f64::from(y));
        match points.last() {
            Some(&(before, _)) if x < before => return None,
            Some(&(before, _)) if x == before => {}
            _ => points.push((x, y)),
        }
    }
    let &(end, _) = points.last().filter(|&&(x, _)| x > 0.0)?;
    let bends = bends(&points);
    let mut table = Vec::with_capacity(ENTRIES);
    let mut intervals = points.windows(2).zip(bends.windows(2)).peekable();
    let mut interval = intervals.next()?;
    for entry in 0..ENTRIES {
        let x = entry as f64 * end / ENTRIES as f64;
        while let ([_, (to, _)], _) = interval
            && x > *to
            && let Some(next) = intervals.next()
        {
            interval = next;
        }
        table.push(nearest(value(interval, x)));
    }
    Some(table)
}

/// An interval's two points with the second derivatives there.
type Interval<'a> = (&'a [(f64, f64)], &'a [f64]);

/// The cubic of an interval at `x`.
fn value(interval: Interval<'_>, x: f64) -> f64 {
    let (&[(x0, y0), (x1, y1)], &[m0, m1]) = interval else {
        return 0.0;
    };
    let h = x1 - x0;
    let (a, b) = ((x1 - x) / h, (x - x0) / h);
    a * y0 + b * y1 + ((a * a * a - a) * m0 + (b * b * b - b) * m1) * (h * h) / 6.0
}

/// The second derivative at each point, zero at both ends: the tridiagonal system solved forwards, then backwards.
fn bends(points: &[(f64, f64)]) -> Vec<f64> {
    // Of each inner point: what its successor's bend is multiplied by, and what is added.
    let mut forward = vec![(0.0, 0.0)];
    for three in points.windows(3) {
        let &[(x0, y0), (x1, y1), (x2, y2)] = three else {
            continue;
        };
        let (h0, h1) = (x1 - x0, x2 - x1);
        let &(factor, rest) = forward.last().unwrap_or(&(0.0, 0.0));
        let right = 6.0 * ((y2 - y1) / h1 - (y1 - y0) / h0);
        let pivot = 2.0 * (h0 + h1) + h0 * factor;
        forward.push((-h1 / pivot, (right - h0 * rest) / pivot));
    }
    let mut bends = vec![0.0];
    for &(factor, rest) in forward.iter().rev() {
        let next = bends.last().copied().unwrap_or(0.0);
        bends.push(factor * next + rest);
    }
    bends.reverse();
    bends
}

/// The nearest 32-bit integer.
#[allow(clippy::cast_possible_truncation)] // `as` saturates
fn nearest(value: f64) -> i32 {
    (value + 0.5).floor() as i32
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_curve_passes_through_its_points() {
        let pairs = [
            (0, 0),
            (0, 0),
            (60, 100),
            (120, 40),
            (180, 300),
            (340, 0),
            (350, 0),
            (360, 0),
        ];
        let table = spline(&pairs).unwrap();
        assert_eq!(table.len(), ENTRIES);
        for (x, y) in pairs.into_iter().filter(|&(x, _)| x < 360) {
            assert_eq!(table[x as usize], y, "at {x}");
        }
    }

    #[test]
    fn points_on_a_line_give_the_line() {
        let pairs: Vec<(i32, i32)> = (0..9).map(|i| (i * 45, i * 450)).collect();
        let table = spline(&pairs).unwrap();
        assert!(table.iter().enumerate().all(|(i, &y)| y == i as i32 * 10));
        let scaled: Vec<(i32, i32)> = (0..9).map(|i| (i * 512, i * 450)).collect();
        assert_eq!(spline(&scaled).unwrap(), table, "entry i is at i/360");
    }

    #[test]
    fn what_is_no_table_is_refused() {
        assert_eq!(spline(&[(0, 1), (10, 5)]), None);
        assert_eq!(spline(&[(0, 0), (10, 5), (9, 5)]), None);
        assert_eq!(spline(&[(0, 0), (0, 0)]), None);
        assert_eq!(spline(&[]), None);
    }
}
