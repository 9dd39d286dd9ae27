//! Numeric functions. Transcendental ones come from `libm`, so that every platform gives the same bits.

use super::ast::Function;
use super::firmware::ErrorCode;
use super::value::{in_range, to_integer};

/// Arguments above this overflow EXP (EXP).
const EXP_LIMIT: f64 = 88.029_691_9;

/// Functions of one number by the numbers that compiled programs know them by; INT and SQRT are operations.
const BY_NUMBER: [Function; 15] = [
    Function::Abs,
    Function::Atn,
    Function::Cos,
    Function::Exp,
    Function::Insta,
    Function::Log,
    Function::Outsta,
    Function::Rnd,
    Function::Sgn,
    Function::Sin,
    Function::Sqr,
    Function::Tan,
    Function::CanData,
    Function::Sdoerror,
    Function::Sdoread,
];

/// The number that compiled programs know a function by; `None` for those that are operations of their own.
pub fn number(function: Function) -> Option<u16> {
    let position = BY_NUMBER.iter().position(|&known| known == function)?;
    u16::try_from(position).ok()
}

/// The function with that number.
pub fn by_number(number: u16) -> Option<Function> {
    BY_NUMBER.get(usize::from(number)).copied()
}

/// The value of a function that depends on its argument alone.
///
/// # Errors
/// OVERFLOW, ILLEGAL QUANTITY or DIVISION BY ZERO, as the manual says at each.
pub fn pure(function: Function, x: f64) -> Result<f64, ErrorCode> {
    match function {
        Function::Abs => Ok(x.abs()),
        Function::Atn => in_range(libm::atan(x)),
        Function::Cos => in_range(libm::cos(x)),
        Function::Exp => exponential(x),
        Function::Log => logarithm(x),
        Function::Sgn if x > 0.0 => Ok(1.0),
        Function::Sgn => Ok(if x < 0.0 { -1.0 } else { 0.0 }),
        Function::Sin => in_range(libm::sin(x)),
        Function::Sqr => in_range(x * x),
        Function::Tan => tangent(x),
        _ => Err(ErrorCode::Syntax),
    }
}

fn exponential(x: f64) -> Result<f64, ErrorCode> {
    if x > EXP_LIMIT {
        return Err(ErrorCode::Overflow);
    }
    in_range(libm::exp(x))
}

fn logarithm(x: f64) -> Result<f64, ErrorCode> {
    if x <= 0.0 {
        return Err(ErrorCode::IllegalQuantity);
    }
    in_range(libm::log(x))
}

/// The square root.
///
/// # Errors
/// ILLEGAL QUANTITY of a negative number.
#[inline(always)]
pub fn square_root(x: f64) -> Result<f64, ErrorCode> {
    if x < 0.0 {
        Err(ErrorCode::IllegalQuantity)
    } else {
        Ok(x.sqrt())
    }
}

/// TAN overflows where the cosine is zero (TAN; D31).
fn tangent(x: f64) -> Result<f64, ErrorCode> {
    if libm::cos(x).abs() < 1e-15 {
        return Err(ErrorCode::DivisionByZero);
    }
    in_range(libm::tan(x))
}

/// `base ^ exponent`.
///
/// # Errors
/// DIVISION BY ZERO for a negative power of zero, ILLEGAL QUANTITY for a broken power of a negative number, OVERFLOW.
pub fn power(base: f64, exponent: f64) -> Result<f64, ErrorCode> {
    if base == 0.0 && exponent < 0.0 {
        return Err(ErrorCode::DivisionByZero);
    }
    if base < 0.0 && exponent.floor() != exponent {
        return Err(ErrorCode::IllegalQuantity);
    }
    // Small whole powers are exact, as repeated multiplication is (D30).
    if let Ok(times @ 0..=16) = to_integer(exponent)
        .map(u8::try_from)
        .unwrap_or(Ok(u8::MAX))
        && exponent.floor() == exponent
    {
        return in_range((0..times).fold(1.0, |product, _| product * base));
    }
    in_range(libm::pow(base, exponent))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers() {
        assert_eq!(power(3.0, 3.0), Ok(27.0));
        assert_eq!(power(3.0, -2.0), Ok(libm::pow(3.0, -2.0)));
        assert_eq!(power(0.0, 0.0), Ok(1.0));
        assert_eq!(power(0.0, -1.0), Err(ErrorCode::DivisionByZero));
        assert_eq!(power(-2.0, 3.0), Ok(-8.0));
        assert_eq!(power(-2.0, 0.5), Err(ErrorCode::IllegalQuantity));
        assert_eq!(power(10.0, 39.0), Err(ErrorCode::Overflow));
        assert_eq!(power(10.0, 1e300), Err(ErrorCode::Overflow));
    }
}
