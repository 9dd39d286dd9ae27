//! Values: how reals are kept in range, how they become integers, and strings.

use smallvec::SmallVec;

use super::firmware::{ErrorCode, STRING_LENGTH};

/// A string of up to 255 bytes; short ones need no allocation.
pub type Text = SmallVec<[u8; 24]>;

/// A result of arithmetic as the firmware keeps it: too large is an OVERFLOW, too small is zero
/// (Floating-point constants: 1.70141183E+38 is 2^127, 2.93873588E-39 is 2^-128; D17).
#[inline(always)]
pub fn in_range(value: f64) -> Result<f64, ErrorCode> {
    const LOWEST: u64 = 1023 - 128;
    const EXPONENTS: u64 = 255;
    let exponent = (value.to_bits() >> 52) & 0x7FF;
    if exponent.wrapping_sub(LOWEST) < EXPONENTS {
        Ok(value)
    } else {
        out_of_range(value)
    }
}

#[cold]
#[inline(never)]
fn out_of_range(value: f64) -> Result<f64, ErrorCode> {
    if value.abs() < 1.0 {
        Ok(0.0)
    } else {
        Err(ErrorCode::Overflow)
    }
}

/// The floor within 32 bits (D6).
///
/// # Errors
/// ILLEGAL QUANTITY outside.
#[inline(always)]
#[allow(clippy::cast_possible_truncation)] // `as` saturates; what does not come back the same takes the slow way
pub fn to_integer(value: f64) -> Result<i32, ErrorCode> {
    let whole = value as i32;
    if f64::from(whole) == value {
        Ok(whole)
    } else {
        floor_to_integer(value)
    }
}

/// The floor within 32 bits as a number: what an integer variable takes (D6).
///
/// # Errors
/// ILLEGAL QUANTITY outside.
#[inline(always)]
pub fn floor_in_range(value: f64) -> Result<f64, ErrorCode> {
    // Adding and taking away 1.5 * 2^52 leaves only what is whole; quicker than converting there and back.
    const WHOLE: f64 = 6_755_399_441_055_744.0;
    if (value + WHOLE) - WHOLE == value && value.abs() < 2_147_483_648.0 {
        Ok(value)
    } else {
        floor_to_integer(value).map(f64::from)
    }
}

#[cold]
#[inline(never)]
#[allow(clippy::cast_possible_truncation)] // checked just before
fn floor_to_integer(value: f64) -> Result<i32, ErrorCode> {
    let floor = value.floor();
    if floor >= f64::from(i32::MIN) && floor <= f64::from(i32::MAX) {
        Ok(floor as i32)
    } else {
        Err(ErrorCode::IllegalQuantity)
    }
}

/// Whether a value is a 32-bit integer as it stands.
#[inline(always)]
#[allow(clippy::cast_possible_truncation)] // `as` saturates
pub fn is_integer(value: f64) -> bool {
    f64::from(value as i32) == value
}

/// A byte-sized argument of a string function.
///
/// # Errors
/// ILLEGAL QUANTITY outside 0 to 255.
pub fn to_byte(value: f64) -> Result<u8, ErrorCode> {
    u8::try_from(to_integer(value)?).map_err(|_| ErrorCode::IllegalQuantity)
}

/// Appends `more` to `text`.
///
/// # Errors
/// STRING TOO LONG above 255 bytes; `text` is unchanged then.
pub fn append(text: &mut Text, more: &[u8]) -> Result<(), ErrorCode> {
    if text.len() + more.len() > STRING_LENGTH {
        return Err(ErrorCode::StringTooLong);
    }
    extend(text, more);
    Ok(())
}

/// Appends whatever the length. Single characters are the commonest, and a copy of any length costs a browser a call.
#[inline]
pub fn extend(text: &mut Text, more: &[u8]) {
    match more {
        &[byte] => text.push(byte),
        _ => text.extend_from_slice(more),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_range_of_reals_is_the_manuals() {
        assert_eq!(in_range(1.701_411_82e38), Ok(1.701_411_82e38));
        assert_eq!(in_range(1.701_411_84e38), Err(ErrorCode::Overflow));
        assert_eq!(in_range(-1.8e38), Err(ErrorCode::Overflow));
        assert_eq!(in_range(f64::INFINITY), Err(ErrorCode::Overflow));
        assert_eq!(in_range(f64::NAN), Err(ErrorCode::Overflow));
        assert_eq!(in_range(2.938_735_88e-39), Ok(2.938_735_88e-39));
        assert_eq!(in_range(2.9e-39), Ok(0.0));
        assert_eq!(in_range(0.0), Ok(0.0));
    }

    #[test]
    fn reals_become_integers_by_their_floor() {
        assert_eq!(to_integer(2.9), Ok(2));
        assert_eq!(to_integer(-2.1), Ok(-3));
        assert_eq!(to_integer(2_147_483_647.9), Ok(i32::MAX));
        assert_eq!(to_integer(2_147_483_648.0), Err(ErrorCode::IllegalQuantity));
        assert_eq!(to_integer(-2_147_483_648.0), Ok(i32::MIN));
        for value in [
            0.0,
            -0.0,
            0.5,
            -0.5,
            2.9,
            -2.1,
            2e9,
            -2e9,
            2_147_483_647.0,
            2_147_483_647.9,
            2_147_483_648.0,
            -2_147_483_648.0,
            -2_147_483_648.5,
            1e300,
            -1e300,
            4_503_599_627_370_496.0,
        ] {
            assert_eq!(
                floor_in_range(value),
                to_integer(value).map(f64::from),
                "{value}"
            );
        }
        assert_eq!(
            to_integer(-2_147_483_648.5),
            Err(ErrorCode::IllegalQuantity)
        );
    }
}
