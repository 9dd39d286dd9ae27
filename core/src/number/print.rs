use std::fmt::Write;

/// Significant digits of a printed real.
const DIGITS: usize = 9;

/// Appends a real as Microsoft BASIC prints it: a blank or `-`, then nine significant digits rounded half away from
/// zero, without trailing zeros and without a zero before the point. From .01 to 999999999 it stands in full, else as
/// `d.ddddddddE+dd`.
///
/// The decimal digits are those of the exact binary value, so that ties are true ties. What is not finite has no
/// digits, and no interpreter here lets it arise: it prints as 0.
pub fn microsoft9(value: f64, out: &mut Vec<u8>) {
    out.push(if value < 0.0 { b'-' } else { b' ' });
    let (digits, exponent) = nine_digits(value.abs());
    let significant = digits.iter().rposition(|&digit| digit != b'0');
    let digits = significant.map_or(&b"0"[..], |last| digits.get(..=last).unwrap_or_default());
    match usize::try_from(exponent) {
        Ok(exponent) if exponent < DIGITS => {
            let whole = exponent + 1;
            out.extend(digits.iter().take(whole));
            out.extend(std::iter::repeat_n(
                b'0',
                whole.saturating_sub(digits.len()),
            ));
            if digits.len() > whole {
                out.push(b'.');
                out.extend(digits.iter().skip(whole));
            }
        }
        _ if exponent == -1 || exponent == -2 => {
            out.extend_from_slice(if exponent == -1 { b"." } else { b".0" });
            out.extend_from_slice(digits);
        }
        _ => {
            out.extend(digits.iter().take(1));
            if digits.len() > 1 {
                out.push(b'.');
                out.extend(digits.iter().skip(1));
            }
            let sign = if exponent < 0 { '-' } else { '+' };
            let written = format!("E{sign}{:02}", exponent.unsigned_abs());
            out.extend_from_slice(written.as_bytes());
        }
    }
}

/// Appends an integer with all its digits: a blank or `-` before them.
pub fn integer(value: i32, out: &mut Vec<u8>) {
    out.push(if value < 0 { b'-' } else { b' ' });
    let mut digits = [b'0'; 10];
    let mut rest = value.unsigned_abs();
    let mut first = digits.len();
    for (place, digit) in digits.iter_mut().enumerate().rev() {
        *digit = b'0' + u8::try_from(rest % 10).unwrap_or(0);
        rest /= 10;
        first = place;
        if rest == 0 {
            break;
        }
    }
    out.extend(digits.iter().skip(first));
}

/// The first nine decimal digits of a magnitude, rounded half up, and the power of ten of the first.
fn nine_digits(magnitude: f64) -> ([u8; DIGITS], i32) {
    // Ten digits decide, unless the tenth is a 5: it may stand for 49999... or for a tie, which the standard library
    // would round to even. The exact expansion of an f64 that is no tie differs from one within 40 digits.
    let mut text = Scientific::of(magnitude, DIGITS);
    if text.tenth() == b'5' {
        text = Scientific::of(magnitude, 45);
    }
    let mut digits = text.first_nine();
    let mut exponent = text.exponent();
    if text.tenth() >= b'5' {
        let all_nines = digits.iter().all(|&digit| digit == b'9');
        for digit in digits.iter_mut().rev() {
            if *digit < b'9' {
                *digit += 1;
                break;
            }
            *digit = b'0';
        }
        if all_nines {
            digits = *b"100000000";
            exponent += 1;
        }
    }
    (digits, exponent)
}

/// A number as `d.ddd...e-dd`, on the stack.
struct Scientific {
    text: [u8; 64],
    length: usize,
}

impl Scientific {
    fn of(magnitude: f64, decimals: usize) -> Scientific {
        let mut text = Scientific {
            text: [b'0'; 64],
            length: 0,
        };
        let finite = if magnitude.is_finite() {
            magnitude
        } else {
            0.0
        };
        // 1 + 1 + 45 + "e-324" fit.
        let _ = write!(text, "{finite:.decimals$e}");
        text
    }

    fn first_nine(&self) -> [u8; DIGITS] {
        let [first, _, b, c, d, e, f, g, h, i, ..] = self.text;
        [first, b, c, d, e, f, g, h, i]
    }

    fn tenth(&self) -> u8 {
        let [_, _, _, _, _, _, _, _, _, _, tenth, ..] = self.text;
        tenth
    }

    fn exponent(&self) -> i32 {
        let text = self.text.get(..self.length).unwrap_or_default();
        text.iter()
            .position(|&byte| byte == b'e')
            .and_then(|at| std::str::from_utf8(text.get(at + 1..)?).ok()?.parse().ok())
            .unwrap_or(0)
    }
}

impl Write for Scientific {
    fn write_str(&mut self, part: &str) -> std::fmt::Result {
        let end = self.length + part.len();
        let room = self.text.get_mut(self.length..end).ok_or(std::fmt::Error)?;
        room.copy_from_slice(part.as_bytes());
        self.length = end;
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn real(value: f64) -> String {
        let mut out = Vec::new();
        microsoft9(value, &mut out);
        String::from_utf8(out).unwrap()
    }

    #[test]
    fn reals_print_as_the_manual_and_microsoft_print_them() {
        for (value, expected) in [
            (0.0, " 0"),
            (-0.0, " 0"),
            (1.0, " 1"),
            (-1.0, "-1"),
            (10.0, " 10"),
            (12.5, " 12.5"),
            (0.5, " .5"),
            (0.1, " .1"),
            (-0.998877, "-.998877"),
            (0.7777777, " .7777777"),
            (0.01, " .01"),
            (0.0123456789, " .0123456789"),
            (0.00999999999, " 9.99999999E-03"),
            (0.001, " 1E-03"),
            (1.0 / 3.0, " .333333333"),
            (2.0 / 3.0, " .666666667"),
            (999_999_999.0, " 999999999"),
            (999_999_999.4, " 999999999"),
            (999_999_999.5, " 1E+09"),
            (1e9, " 1E+09"),
            (2_359_000_000.0, " 2.359E+09"),
            (123_456_789_012.0, " 1.23456789E+11"),
            (-7.09e-12, "-7.09E-12"),
            (235.988e-3, " .235988"),
            (-3.14159e5, "-314159"),
            (1.701_411_834_604_692_3e38, " 1.70141183E+38"),
            (2.938_735_877_055_719e-39, " 2.93873588E-39"),
            (std::f64::consts::PI, " 3.14159265"),
            (libm::exp(1.0), " 2.71828183"),
            (libm::log(45.0 / 7.0), " 1.86075234"),
            (libm::sin(1.5), " .997494987"),
            (10f64.sqrt(), " 3.16227766"),
            (99.4343, " 99.4343"),
            (0.099_999_999_99, " .1"),
        ] {
            assert_eq!(real(value), expected, "{value}");
        }
    }

    #[test]
    fn ties_round_away_from_zero_and_near_ties_do_not() {
        for (value, expected) in [
            // Exact in binary: 2^-2 and 2^-1 behind nine digits.
            (12_345_678.25, " 12345678.3"),
            (12_345_678.75, " 12345678.8"),
            (-12_345_678.25, "-12345678.3"),
            (123_456_788.5, " 123456789"),
            (1_000_000_005.0, " 1.00000001E+09"),
            (0.500_000_000_5, " .500000001"),
            // In binary the first lies just below its tie (1.000000004999...), the second just above.
            (1.000_000_005, " 1"),
            (1.000_000_025, " 1.00000003"),
        ] {
            assert_eq!(real(value), expected, "{value:.30}");
        }
    }

    #[test]
    fn integers_print_all_their_digits() {
        for (value, expected) in [
            (0, " 0"),
            (7, " 7"),
            (-12, "-12"),
            (i32::MAX, " 2147483647"),
            (i32::MIN, "-2147483648"),
            (1_000_000_000, " 1000000000"),
        ] {
            let mut out = Vec::new();
            integer(value, &mut out);
            assert_eq!(String::from_utf8(out).unwrap(), expected);
        }
    }

    #[test]
    fn what_is_printed_reads_back_within_nine_digits() {
        // A fixed walk over magnitudes 1e-39..1e38.
        let mut value = 2.94e-39;
        while value < 1.7e38 {
            let (back, length) = crate::number::leading(real(value).as_bytes()).unwrap();
            assert_eq!(length, real(value).len());
            assert!(
                (back.real() - value).abs() <= value * 0.500_000_1e-8,
                "{value}"
            );
            value *= 1.0073;
        }
    }
}
