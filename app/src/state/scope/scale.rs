//! Scales: the ends and marks of an axis of a picture.

/// The scale of an axis: its ends, and the distance of its marks, which are multiples of it.
#[derive(Debug, Clone, Copy, PartialEq)]
#[allow(missing_docs)]
pub struct Scale {
    pub low: f64,
    pub high: f64,
    pub step: f64,
}

impl Scale {
    /// The smallest scale with about `marks` marks that holds both values; its ends are marks.
    pub fn fit(min: f64, max: f64, marks: f64) -> Scale {
        // A line that is level lies in the middle.
        let span = if max > min {
            max - min
        } else {
            2.0 * min.abs().max(1.0)
        };
        let step = nice(span / marks);
        if max > min {
            Scale {
                low: (min / step).floor() * step,
                high: (max / step).ceil() * step,
                step,
            }
        } else {
            let middle = (min / step).round() * step;
            Scale {
                low: middle - step,
                high: middle + step,
                step,
            }
        }
    }

    /// From `low` to `high`, with about `marks` marks; `None` unless both are finite and `low` is the lower.
    pub fn between(low: f64, high: f64, marks: f64) -> Option<Scale> {
        let step = nice((high - low) / marks);
        (low.is_finite() && high.is_finite() && low < high).then_some(Scale { low, high, step })
    }

    /// Where its marks are.
    pub fn marks(&self) -> impl Iterator<Item = f64> + use<> {
        let Scale { low, high, step } = *self;
        let (first, last) = (
            (low / step - 1e-9).ceil() as i64,
            (high / step + 1e-9).floor() as i64,
        );
        (first..=last).map(move |mark| mark as f64 * step)
    }

    /// Digits behind the point that tell its marks apart.
    pub fn digits(&self) -> usize {
        (-self.step.log10().floor()).clamp(0.0, 9.0) as usize
    }
}

/// The nearest 1, 2 or 5 times a power of ten that is not smaller.
pub(crate) fn nice(size: f64) -> f64 {
    let power = 10f64.powf(size.max(1e-9).log10().floor());
    let steps = [1.0, 2.0, 5.0, 10.0];
    // A little tolerance, as 0.2 has no exact form.
    let step = steps
        .iter()
        .find(|&&step| step * power >= size * (1.0 - 1e-9));
    step.unwrap_or(&10.0) * power
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scales_are_round_and_hold_the_values() {
        let scale = Scale::fit(-3.2, 48_211.0, 3.0);
        assert_eq!(
            (scale.low, scale.high, scale.step),
            (-20_000.0, 60_000.0, 20_000.0)
        );
        assert_eq!(
            scale.marks().collect::<Vec<_>>(),
            [-2e4, 0.0, 2e4, 4e4, 6e4]
        );
        assert_eq!(
            Scale::fit(0.0, 0.0, 3.0).marks().collect::<Vec<_>>(),
            [-1.0, 0.0, 1.0]
        );
        assert_eq!(Scale::fit(0.0, 0.6, 3.0).digits(), 1);
        assert_eq!(scale.digits(), 0);
    }

    #[test]
    fn a_fixed_scale_has_the_ends_it_was_given() {
        let scale = Scale::between(-0.25, 0.8, 4.0).unwrap();
        assert_eq!((scale.low, scale.high, scale.step), (-0.25, 0.8, 0.5));
        assert_eq!(scale.marks().collect::<Vec<_>>(), [0.0, 0.5]);
        assert_eq!(Scale::between(1.0, 1.0, 4.0), None);
        assert_eq!(Scale::between(0.0, f64::NAN, 4.0), None);
    }
}
