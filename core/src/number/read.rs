use crate::language::Cursor;

/// A number read from digits.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Constant {
    /// Digits alone, within 32 bits.
    Integer(i32),
    /// With a point or an exponent, or beyond 32 bits; infinite beyond f64. Limits are the caller's.
    Real(f64),
}

impl Constant {
    /// As a real.
    pub fn real(self) -> f64 {
        match self {
            Constant::Integer(value) => f64::from(value),
            Constant::Real(value) => value,
        }
    }
}

/// Reads the number without a sign at the start of `text`: digits, a point, an exponent after `E`. Gives how many
/// bytes it took, too. A point alone is zero, as in Microsoft BASIC; an `E` without digits is left (`12ELSE`).
///
/// With `negative` the value is negated, so that -2147483648 is an integer.
pub fn unsigned(text: &[u8], negative: bool) -> Option<(Constant, usize)> {
    let mut cursor = Cursor::new(text, 0);
    let mut digits = cursor.take_while(|byte| byte.is_ascii_digit()).len();
    let mut whole = digits > 0;
    if cursor.eat(b'.') {
        digits += cursor.take_while(|byte| byte.is_ascii_digit()).len();
        whole = false;
    }
    if cursor.position() == 0 {
        return None;
    }
    let mut exponent = cursor;
    if exponent.eat(b'E') || exponent.eat(b'e') {
        let _ = exponent.eat(b'+') || exponent.eat(b'-');
        if !exponent.take_while(|byte| byte.is_ascii_digit()).is_empty() {
            cursor = exponent;
            whole = false;
        }
    }
    let length = cursor.position();
    if digits == 0 {
        return Some((Constant::Real(0.0), length));
    }
    let written = text
        .get(..length)
        .and_then(|bytes| std::str::from_utf8(bytes).ok())
        .unwrap_or_default();
    let signed = |value: i64| if negative { -value } else { value };
    if let Some(value) = written
        .parse()
        .ok()
        .filter(|_| whole)
        .and_then(|value| i32::try_from(signed(value)).ok())
    {
        return Some((Constant::Integer(value), length));
    }
    let magnitude: f64 = written.parse().unwrap_or(0.0);
    let value = if negative { -magnitude } else { magnitude };
    Some((Constant::Real(value), length))
}

/// Reads the number at the start of `text`, with blanks and one sign before it, as VAL, INPUT and READ do. Gives how
/// many bytes it took, blanks included; `None` if there is no number.
pub fn leading(text: &[u8]) -> Option<(Constant, usize)> {
    let mut cursor = Cursor::new(text, 0);
    cursor.take_while(|byte| byte == b' ');
    let negative = cursor.eat(b'-');
    if !negative {
        cursor.eat(b'+');
    }
    cursor.take_while(|byte| byte == b' ');
    let (value, length) = unsigned(cursor.rest(), negative)?;
    Some((value, cursor.position() + length))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reads_the_number_and_leaves_the_rest() {
        use Constant::{Integer, Real};
        for (text, expected) in [
            ("12", Some((Integer(12), 2))),
            ("0012)", Some((Integer(12), 4))),
            ("2147483647", Some((Integer(i32::MAX), 10))),
            ("2147483648", Some((Real(2147483648.0), 10))),
            ("99999999999999999999", Some((Real(1e20), 20))),
            ("12.", Some((Real(12.0), 3))),
            (".5", Some((Real(0.5), 2))),
            (".", Some((Real(0.0), 1))),
            (".E5", Some((Real(0.0), 3))),
            ("1.5E-3", Some((Real(0.0015), 6))),
            ("2359e6", Some((Real(2.359e9), 6))),
            ("12ELSE", Some((Integer(12), 2))),
            ("12E+", Some((Integer(12), 2))),
            ("1.2.3", Some((Real(1.2), 3))),
            ("1E999", Some((Real(f64::INFINITY), 5))),
            ("1E-999", Some((Real(0.0), 6))),
            ("-1", None),
            ("E5", None),
            ("", None),
        ] {
            assert_eq!(unsigned(text.as_bytes(), false), expected, "{text}");
        }
    }

    #[test]
    fn a_sign_and_blanks_may_lead() {
        use Constant::{Integer, Real};
        for (text, expected) in [
            ("  -12 x", Some((Integer(-12), 5))),
            ("+ 4", Some((Integer(4), 3))),
            ("-2147483648", Some((Integer(i32::MIN), 11))),
            ("-2147483649", Some((Real(-2147483649.0), 11))),
            ("-1.7E-9", Some((Real(-1.7e-9), 7))),
            ("--1", None),
            ("JOHN", None),
            (" ", None),
        ] {
            assert_eq!(leading(text.as_bytes()), expected, "{text}");
        }
    }
}
