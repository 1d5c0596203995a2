//! Arithmetic operators and functions.
//!
//! In: numbers, angles in degrees. Out: a number within the range of the control, or the error. Knows nothing
//! of text or variables.

use super::MacroErrorKind;
use super::cursor::{Arithmetic, Comparison};
use crate::limits::LARGEST_VARIABLE;

/// Smaller absolute values become zero.
const MIN_MAGNITUDE: f64 = 1e-29;

/// Trigonometric results this close to a multiple of 0.5 are rounded to it: COS\[90\] is 0, SIN\[30\] is 0.5.
const ROUND_RESULT: f64 = 1e-12;

/// Relative rounding error that FIX, FUP and ROUND tolerate: FIX\[0.29*100\] is 29. A control may give 28
/// here.
const ARITHMETIC_ERROR: f64 = 1e-12;

/// Rounding error that is tolerated in an argument: of SQRT below 0, of ASIN and ACOS beyond 1. The last
/// point of an ellipse is often computed with such an error.
const ARGUMENT_ERROR: f64 = 1e-9;

/// Largest whole number for AND, OR, XOR, BIN and BCD: a double holds it exactly.
const WHOLE: f64 = 9_007_199_254_740_992.0;

/// Largest number of eight decimal digits, for BCD.
const EIGHT_DIGITS: f64 = 99_999_999.0;

/// A function of one number; ATAN and POW may have two.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Function {
    /// Sine.
    Sin,
    /// Cosine.
    Cos,
    /// Tangent.
    Tan,
    /// Arcsine.
    Asin,
    /// Arccosine.
    Acos,
    /// Arctangent.
    Atan,
    /// Square root.
    Sqrt,
    /// Absolute value.
    Abs,
    /// Nearest integer, halves away from zero.
    Round,
    /// Integer towards zero.
    Fix,
    /// Integer away from zero.
    Fup,
    /// Natural logarithm.
    Ln,
    /// Power of e.
    Exp,
    /// Power.
    Pow,
    /// BCD to binary.
    Bin,
    /// Binary to BCD.
    Bcd,
    /// The value itself; adds a decimal point to arguments on controls that count increments.
    Adp,
}

impl Function {
    /// The function with this name: the full name, the second spelling of the manual, or the first two
    /// letters (POW has no short form).
    pub fn named(name: &[u8]) -> Option<Self> {
        if name.len() > 5 {
            return None;
        }
        let mut upper = [0; 5];
        let upper = &mut upper[..name.len()];
        upper.copy_from_slice(name);
        upper.make_ascii_uppercase();
        Some(match &*upper {
            b"SIN" | b"SI" => Self::Sin,
            b"COS" | b"CO" => Self::Cos,
            b"TAN" | b"TA" => Self::Tan,
            b"ASIN" | b"ASN" | b"AS" => Self::Asin,
            b"ACOS" | b"ACS" | b"AC" => Self::Acos,
            b"ATAN" | b"ATN" | b"AT" => Self::Atan,
            b"SQRT" | b"SQR" | b"SQ" => Self::Sqrt,
            b"ABS" | b"AB" => Self::Abs,
            b"ROUND" | b"RO" | b"RND" | b"RN" => Self::Round,
            b"FIX" | b"FI" => Self::Fix,
            b"FUP" | b"FU" => Self::Fup,
            b"LN" => Self::Ln,
            b"EXP" | b"EX" => Self::Exp,
            b"POW" => Self::Pow,
            b"BIN" | b"BI" => Self::Bin,
            b"BCD" | b"BC" => Self::Bcd,
            b"ADP" | b"AD" => Self::Adp,
            _ => return None,
        })
    }

    /// Applies the function to one number. Fails for POW, which needs two.
    pub fn of(self, value: f64) -> Result<f64, MacroErrorKind> {
        check_range(match self {
            Self::Sin => sine(value),
            Self::Cos => sine(value % 360.0 + 90.0),
            Self::Tan => match sine(value % 360.0 + 90.0) {
                0.0 => return Err(MacroErrorKind::FunctionArgument),
                cosine => snap_to_half(sine(value) / cosine),
            },
            // 270° to 90°, because ATAN starts at 0 (bit NAT of parameter 6004 is 0). [K]
            Self::Asin => positive(snap_to_half(clamp_argument(value, 1.0)?.asin().to_degrees())),
            Self::Acos => snap_to_half(clamp_argument(value, 1.0)?.acos().to_degrees()),
            Self::Atan => snap_to_half(value.atan().to_degrees()),
            Self::Sqrt if value < -ARGUMENT_ERROR => return Err(MacroErrorKind::FunctionArgument),
            Self::Sqrt => value.max(0.0).sqrt(),
            Self::Abs => value.abs(),
            Self::Round => snap_to_integer(value).round(),
            Self::Fix => snap_to_integer(value).trunc(),
            Self::Fup => {
                let value = snap_to_integer(value);
                value.abs().ceil().copysign(value)
            }
            Self::Ln if value <= 0.0 => return Err(MacroErrorKind::FunctionArgument),
            Self::Ln => value.ln(),
            Self::Exp => value.exp(),
            Self::Pow => return Err(MacroErrorKind::FunctionArgument),
            Self::Bin => digits(value, f64::from(u32::MAX), 16, 10)?,
            Self::Bcd => digits(value, EIGHT_DIGITS, 10, 16)?,
            Self::Adp => value,
        })
    }

    /// Whether the function can take two numbers in one pair of brackets.
    pub fn takes_two(self) -> bool {
        matches!(self, Self::Atan | Self::Pow)
    }

    /// Applies the function to two numbers: ATAN\[y, x\], the direction of a point, 0 to 360°, and POW\[x,
    /// y\].
    pub fn of_two(self, first: f64, second: f64) -> Result<f64, MacroErrorKind> {
        match self {
            Self::Atan if first != 0.0 || second != 0.0 => {
                check_range(positive(snap_to_half(first.atan2(second).to_degrees())))
            }
            Self::Pow if first > 0.0 || (first == 0.0 && second > 0.0) => check_range(first.powf(second)),
            Self::Pow if first < 0.0 && second.fract() == 0.0 => check_range(first.powf(second)),
            _ => Err(MacroErrorKind::FunctionArgument),
        }
    }
}

/// ROUND in the value of an address: rounds to the least increment.
pub(super) fn round_to(value: f64, increment: f64) -> Result<f64, MacroErrorKind> {
    let parts = (1.0 / increment).round();
    if !(1.0..1e9).contains(&parts) {
        return Function::Round.of(value);
    }
    check_range(snap_to_integer(value * parts).round() / parts)
}

/// Applies an operator to two numbers.
pub(super) fn combine(operator: Arithmetic, left: f64, right: f64) -> Result<f64, MacroErrorKind> {
    check_range(match operator {
        Arithmetic::Add => left + right,
        Arithmetic::Subtract => left - right,
        Arithmetic::Multiply => left * right,
        Arithmetic::Divide if right == 0.0 => return Err(MacroErrorKind::DivisionByZero),
        Arithmetic::Divide => left / right,
        Arithmetic::Modulo => {
            // For whole numbers; the result has the sign of the first. [K]
            let (left, right) = (left.round(), right.round());
            if right == 0.0 {
                return Err(MacroErrorKind::DivisionByZero);
            }
            left % right
        }
        Arithmetic::And => (whole(left)? & whole(right)?) as f64,
        Arithmetic::Or => (whole(left)? | whole(right)?) as f64,
        Arithmetic::Xor => (whole(left)? ^ whole(right)?) as f64,
    })
}

/// Compares two values. A vacant value differs from zero for EQ and NE, and equals zero for the others.
pub(super) fn compare(comparison: Comparison, left: Option<f64>, right: Option<f64>) -> bool {
    let (first, second) = (left.unwrap_or(0.0), right.unwrap_or(0.0));
    match comparison {
        Comparison::Equal => left == right,
        Comparison::NotEqual => left != right,
        Comparison::Greater => first > second,
        Comparison::GreaterOrEqual => first >= second,
        Comparison::Less => first < second,
        Comparison::LessOrEqual => first <= second,
    }
}

/// Checks that a result is within the range of the control, and removes a negative zero.
pub(super) fn check_range(value: f64) -> Result<f64, MacroErrorKind> {
    if !value.is_finite() || value.abs() > LARGEST_VARIABLE {
        return Err(MacroErrorKind::Overflow);
    }
    Ok(if value.abs() < MIN_MAGNITUDE { 0.0 } else { value })
}

/// The number of a variable, block and so on: a non-negative whole number.
pub(super) fn count(value: f64) -> Option<u32> {
    let nearest = value.round();
    let near = (value - nearest).abs() < 1e-6;
    (near && (0.0..=f64::from(u32::MAX)).contains(&nearest)).then_some(nearest as u32)
}

/// Sine of an angle in degrees, exact at multiples of 90°.
fn sine(degrees: f64) -> f64 {
    let turn = (degrees % 360.0 + 360.0) % 360.0;
    let quarter = (turn / 90.0).round();
    let rest = (turn - 90.0 * quarter).to_radians();
    snap_to_half(match quarter as u8 % 4 {
        0 => rest.sin(),
        1 => rest.cos(),
        2 => -rest.sin(),
        _ => -rest.cos(),
    })
}

/// Rounds a value to the nearest multiple of 0.5, if the difference is only a rounding error.
fn snap_to_half(value: f64) -> f64 {
    let halves = (value * 2.0).round() / 2.0;
    if (value - halves).abs() <= ROUND_RESULT * halves.abs().max(1.0) { halves } else { value }
}

/// Rounds a value to the nearest integer, if the difference is only a rounding error.
fn snap_to_integer(value: f64) -> f64 {
    let nearest = value.round();
    if (value - nearest).abs() <= ARITHMETIC_ERROR * value.abs().max(1.0) { nearest } else { value }
}

/// Converts an angle to the range 0 to 360°.
fn positive(degrees: f64) -> f64 {
    if degrees < 0.0 { degrees + 360.0 } else { degrees }
}

/// Checks that a value is within ±`most`, and limits it to this range.
fn clamp_argument(value: f64, most: f64) -> Result<f64, MacroErrorKind> {
    if value.abs() > most + ARGUMENT_ERROR {
        return Err(MacroErrorKind::FunctionArgument);
    }
    Ok(crate::geometry::within(value, -most, most))
}

fn whole(value: f64) -> Result<i64, MacroErrorKind> {
    if value.abs() > WHOLE {
        return Err(MacroErrorKind::FunctionArgument);
    }
    Ok(value.round() as i64)
}

/// Writes a whole number in one base and reads its digits in another.
fn digits(value: f64, most: f64, base: u64, read_as: u64) -> Result<f64, MacroErrorKind> {
    let value = value.round();
    if !(0.0..=most).contains(&value) {
        return Err(MacroErrorKind::FunctionArgument);
    }
    let (mut rest, mut result, mut place) = (value as u64, 0, 1);
    while rest > 0 {
        let digit = rest % base;
        if digit > 9 {
            return Err(MacroErrorKind::FunctionArgument);
        }
        result += digit * place;
        place *= read_as;
        rest /= base;
    }
    Ok(result as f64)
}
