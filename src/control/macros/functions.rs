//! What operators and functions make of numbers.
//!
//! In: numbers, angles in degrees. Out: a number within the range of the control, or what is wrong. Knows
//! nothing of text or variables.

use super::MacroErrorKind;
use super::cursor::{Arithmetic, Comparison};
use crate::limits::LARGEST_VARIABLE;

/// What is nearer to zero is zero.
const SMALLEST: f64 = 1e-29;

/// Sines and the like as near as this to a multiple of a half are one: COS\[90\] is 0, SIN\[30\] is 0.5.
const ROUND_RESULT: f64 = 1e-12;

/// What FIX, FUP and ROUND take for the error of earlier arithmetic, relative: FIX\[0.29*100\] is 29. A
/// control may give 28 here.
const ARITHMETIC_ERROR: f64 = 1e-12;

/// How far below 0 the argument of SQRT, or beyond 1 that of ASIN and ACOS, is taken for the error of earlier
/// arithmetic: the last point of an ellipse is often reached that way.
const ARGUMENT_ERROR: f64 = 1e-9;

/// Largest whole number that AND, OR, XOR, BIN and BCD work on: what a double holds exactly.
const WHOLE: f64 = 9_007_199_254_740_992.0;

/// Largest number of eight decimal digits, BCD.
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
    /// Angle by its sine.
    Asin,
    /// Angle by its cosine.
    Acos,
    /// Angle by its tangent.
    Atan,
    /// Square root.
    Sqrt,
    /// Without its sign.
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
    /// The function of a name: in full, in the second spelling of the manual, or as its first two letters
    /// (POW in full only).
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

    /// The function of one number. Of POW, which needs two, there is none.
    pub fn of(self, value: f64) -> Result<f64, MacroErrorKind> {
        bounded(match self {
            Self::Sin => sine(value),
            Self::Cos => sine(value % 360.0 + 90.0),
            Self::Tan => match sine(value % 360.0 + 90.0) {
                0.0 => return Err(MacroErrorKind::FunctionArgument),
                cosine => tidy(sine(value) / cosine),
            },
            // 270° to 90°, as ATAN counts from 0 (bit NAT of parameter 6004 is 0). [K]
            Self::Asin => positive(tidy(cut(value, 1.0)?.asin().to_degrees())),
            Self::Acos => tidy(cut(value, 1.0)?.acos().to_degrees()),
            Self::Atan => tidy(value.atan().to_degrees()),
            Self::Sqrt if value < -ARGUMENT_ERROR => return Err(MacroErrorKind::FunctionArgument),
            Self::Sqrt => value.max(0.0).sqrt(),
            Self::Abs => value.abs(),
            Self::Round => settled(value).round(),
            Self::Fix => settled(value).trunc(),
            Self::Fup => {
                let value = settled(value);
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

    /// Whether the function takes two numbers between one pair of brackets.
    pub fn takes_two(self) -> bool {
        matches!(self, Self::Atan | Self::Pow)
    }

    /// The function of two numbers: ATAN\[y, x\], the direction of a point, 0 to 360°, and POW\[x, y\].
    pub fn of_two(self, first: f64, second: f64) -> Result<f64, MacroErrorKind> {
        match self {
            Self::Atan if first != 0.0 || second != 0.0 => {
                bounded(positive(tidy(first.atan2(second).to_degrees())))
            }
            Self::Pow if first > 0.0 || (first == 0.0 && second > 0.0) => bounded(first.powf(second)),
            Self::Pow if first < 0.0 && second.fract() == 0.0 => bounded(first.powf(second)),
            _ => Err(MacroErrorKind::FunctionArgument),
        }
    }
}

/// ROUND as the value of an address: to the least increment.
pub(super) fn round_to(value: f64, increment: f64) -> Result<f64, MacroErrorKind> {
    let parts = (1.0 / increment).round();
    if !(1.0..1e9).contains(&parts) {
        return Function::Round.of(value);
    }
    bounded(settled(value * parts).round() / parts)
}

/// Two numbers and an operator.
pub(super) fn combine(operator: Arithmetic, left: f64, right: f64) -> Result<f64, MacroErrorKind> {
    bounded(match operator {
        Arithmetic::Add => left + right,
        Arithmetic::Subtract => left - right,
        Arithmetic::Multiply => left * right,
        Arithmetic::Divide if right == 0.0 => return Err(MacroErrorKind::DivisionByZero),
        Arithmetic::Divide => left / right,
        Arithmetic::Modulo => {
            // Of whole numbers, with the sign of the first. [K]
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

/// Two values and a comparison: a vacant one differs from zero for EQ and NE, and is zero for the others.
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

/// A result within the range of the control; there is no negative zero.
pub(super) fn bounded(value: f64) -> Result<f64, MacroErrorKind> {
    if !value.is_finite() || value.abs() > LARGEST_VARIABLE {
        return Err(MacroErrorKind::Overflow);
    }
    Ok(if value.abs() < SMALLEST { 0.0 } else { value })
}

/// The number of a variable, block or the like: a whole number that is not negative.
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
    tidy(match quarter as u8 % 4 {
        0 => rest.sin(),
        1 => rest.cos(),
        2 => -rest.sin(),
        _ => -rest.cos(),
    })
}

/// The nearest multiple of a half where the value misses it by no more than rounding.
fn tidy(value: f64) -> f64 {
    let halves = (value * 2.0).round() / 2.0;
    if (value - halves).abs() <= ROUND_RESULT * halves.abs().max(1.0) { halves } else { value }
}

/// The nearest integer where the value misses it by no more than rounding.
fn settled(value: f64) -> f64 {
    let nearest = value.round();
    if (value - nearest).abs() <= ARITHMETIC_ERROR * value.abs().max(1.0) { nearest } else { value }
}

/// An angle from 0 to 360°.
fn positive(degrees: f64) -> f64 {
    if degrees < 0.0 { degrees + 360.0 } else { degrees }
}

/// A value within ±`most`, or what is wrong.
fn cut(value: f64, most: f64) -> Result<f64, MacroErrorKind> {
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
