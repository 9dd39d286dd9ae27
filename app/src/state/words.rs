//! Numbers as people read them.

/// Keeps the groups of a number together, and a number and its unit.
const NARROW_SPACE: char = '\u{202f}';
/// A real minus sign: as wide as a digit's plus.
const MINUS: char = '\u{2212}';

/// Simulated time as `00:14.862`, with hours where there are some.
pub fn time(seconds: f64) -> String {
    let millis = (seconds.max(0.0) * 1000.0) as u64;
    let (minutes, rest) = (millis / 60_000, millis % 60_000);
    let seconds = format!("{:02}.{:03}", rest / 1000, rest % 1000);
    if minutes >= 60 {
        format!("{}:{:02}:{seconds}", minutes / 60, minutes % 60)
    } else {
        format!("{minutes:02}:{seconds}")
    }
}

/// A value with `digits` behind the point and its thousands apart: `122 880`.
pub fn number(value: f64, digits: usize) -> String {
    if !value.is_finite() {
        return "\u{2013}".to_owned();
    }
    let text = format!("{:.digits$}", value.abs());
    let (whole, fraction) = text.split_once('.').unwrap_or((&text, ""));
    let mut words = String::new();
    // What rounds to zero has no sign.
    if value < 0.0 && text.bytes().any(|b| (b'1'..=b'9').contains(&b)) {
        words.push(MINUS);
    }
    for (place, digit) in whole.chars().enumerate() {
        if place > 0 && (whole.len() - place).is_multiple_of(3) {
            words.push(NARROW_SPACE);
        }
        words.push(digit);
    }
    if !fraction.is_empty() {
        words.push('.');
        words.push_str(fraction);
    }
    words
}

/// A value beside a mark, where there is little room: `20k`, `1.5M`.
pub fn short(value: f64, digits: usize) -> String {
    match value.abs() {
        size if size >= 1e6 => format!("{}M", decimal(value / 1e6)),
        size if size >= 1e4 => format!("{}k", decimal(value / 1e3)),
        _ => number(value, digits),
    }
}

/// With as many digits behind the point, up to six, as it has.
fn decimal(value: f64) -> String {
    let digits = (0..6).find(|&digits| {
        let scaled = value * 10f64.powi(digits);
        (scaled - scaled.round()).abs() < 1e-6 * scaled.abs().max(1.0)
    });
    number(value, digits.unwrap_or(6) as usize)
}

/// A measured value: all the digits of a whole number, otherwise as many as matter.
pub fn value(value: f64) -> String {
    let digits = match value.abs() {
        size if size >= 100.0 || value.fract() == 0.0 => 0,
        size if size >= 1.0 => 2,
        _ => 4,
    };
    number(value, digits)
}

/// A unit as it is printed: `counts·256/sample`, which may be broken before the stroke.
pub fn unit(unit: &str) -> String {
    unit.replace('*', "\u{b7}")
        .replace("^2", "\u{b2}")
        .replace('/', "\u{200b}/")
}

/// The speed of the simulation: `1.00`, `0.010`, `100`.
pub fn speed(reached: f64) -> String {
    let digits = match reached {
        r if r >= 99.95 => 0,
        r if r >= 9.995 => 1,
        r if r >= 0.0995 => 2,
        _ => 3,
    };
    number(reached, digits)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn time_is_minutes_seconds_and_milliseconds() {
        assert_eq!(time(0.0), "00:00.000");
        assert_eq!(time(14.862), "00:14.862");
        assert_eq!(time(3661.5), "1:01:01.500");
    }

    #[test]
    fn thousands_stand_apart() {
        assert_eq!(number(122_880.0, 0), "122\u{202f}880");
        assert_eq!(
            number(-1_234_567.25, 1),
            "\u{2212}1\u{202f}234\u{202f}567.2"
        );
        assert_eq!(number(-0.001, 1), "0.0");
        assert_eq!(number(999.0, 0), "999");
        assert_eq!(number(f64::NAN, 0), "\u{2013}");
    }

    #[test]
    fn a_mark_is_short() {
        assert_eq!(short(5000.0, 0), "5\u{202f}000");
        assert_eq!(short(-12_500.0, 0), "\u{2212}12.5k");
        assert_eq!(short(1_250_000.0, 0), "1.25M");
        assert_eq!(short(0.5, 1), "0.5");
    }

    #[test]
    fn a_value_shows_the_digits_that_matter() {
        assert_eq!(value(40_960.0), "40\u{202f}960");
        assert_eq!(value(68_265.625), "68\u{202f}266");
        assert_eq!(value(1.5), "1.50");
        assert_eq!(value(0.0), "0");
        assert_eq!(speed(1.0), "1.00");
        assert_eq!(speed(0.01), "0.010");
        assert_eq!(speed(612.4), "612");
    }
}
