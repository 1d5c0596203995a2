//! Units of length: millimetre and inch, radius and diameter, and number formatting.
//!
//! In: a unit, or a value. Out: its size in millimetres, its least input increment, the value as text.
//! Contains no translated words.

use serde::{Deserialize, Serialize};

/// A unit of length of the program.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema), schemars(inline))]
pub enum Unit {
    /// Millimetre (G21).
    #[default]
    #[serde(rename = "mm")]
    Millimetre,
    /// Inch (G20).
    #[serde(rename = "inch")]
    Inch,
}

impl Unit {
    /// Both units, in display order.
    pub const ALL: [Unit; 2] = [Self::Millimetre, Self::Inch];

    /// The name in a setup.
    pub fn name(self) -> &'static str {
        match self {
            Self::Millimetre => "mm",
            Self::Inch => "inch",
        }
    }

    /// Millimetres in one unit.
    pub fn millimetres(self) -> f64 {
        match self {
            Self::Millimetre => 1.0,
            Self::Inch => 25.4,
        }
    }

    /// Least input increment, in this unit.
    pub fn increment(self) -> f64 {
        10f64.powi(-i32::from(self.decimals()))
    }

    /// Metres in the length unit of S under G96: one metre, or one foot under G20 (FANUC 16/18-T B-62754EN p.
    /// 127).
    pub fn surface_metres(self) -> f64 {
        match self {
            Self::Millimetre => 1.0,
            Self::Inch => 0.3048,
        }
    }

    /// Decimals of the least input increment: 0.001 mm, 0.0001 inch (IS-B).
    pub fn decimals(self) -> u8 {
        match self {
            Self::Millimetre => 3,
            Self::Inch => 4,
        }
    }
}

/// An X value as a diameter, mm. Inside the crate X is a radius ([`Point`](crate::geometry::Point)); this
/// type is the only way from one to the other, so that they cannot be confused.
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd, Deserialize, Serialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema), schemars(inline))]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(transparent)]
pub struct Diameter(f64);

impl Diameter {
    /// A diameter as written in a program, mm.
    pub const fn new(mm: f64) -> Self {
        Self(mm)
    }

    /// The diameter of a radius, mm. A negative radius is on the other side of the axis.
    pub const fn from_radius(radius: f64) -> Self {
        Self(2.0 * radius)
    }

    /// The diameter, mm.
    pub const fn mm(self) -> f64 {
        self.0
    }

    /// The radius, mm.
    pub const fn radius(self) -> f64 {
        self.0 / 2.0
    }

    /// Applies a function, such as rounding, to the diameter.
    pub fn map(self, change: impl FnOnce(f64) -> f64) -> Self {
        Self(change(self.0))
    }
}

/// Formats a number: at most four decimals, no trailing zeros, never `-0`.
pub fn number(value: f64) -> String {
    let bits = value.abs().to_bits();
    // The value is `mantissa * 2^exponent`, exactly.
    let (exponent, mantissa) = ((bits >> 52) as i32 - 1075, bits & ((1 << 52) - 1) | 1 << 52);
    let (mut whole, mut decimals) = match exponent {
        // Less than 2^-15: rounds to zero.
        ..-67 => (0, 0),
        -67..0 => {
            let (shift, mantissa) = (-exponent, u128::from(mantissa));
            let (mask, half) = ((1 << shift) - 1, 1 << (shift - 1));
            let scaled = (mantissa & mask) * 10_000;
            let (decimals, rest) = ((scaled >> shift) as u64, scaled & mask);
            let up = rest > half || rest == half && decimals % 2 == 1;
            ((mantissa >> shift) as u64, decimals + u64::from(up))
        }
        0..=10 => (mantissa << exponent, 0),
        // Larger than any value in practice.
        11.. => return format_large(value),
    };
    if decimals == 10_000 {
        (whole, decimals) = (whole + 1, 0);
    }
    let sign = if value < 0.0 && (whole, decimals) != (0, 0) { "-" } else { "" };
    let text = format!("{sign}{whole}.{decimals:04}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

/// Formats a number of 2^63 or more with all its digits, or a value that is not finite.
#[cold]
fn format_large(value: f64) -> String {
    if !value.is_finite() {
        return if value.is_nan() {
            "NaN"
        } else if value > 0.0 {
            "inf"
        } else {
            "-inf"
        }
        .to_owned();
    }
    // Halve the value until it fits in a 64-bit integer, then double it again in decimal digits, the last
    // digit first.
    let (mut rest, mut doublings) = (value.abs(), 0);
    while rest >= 9e18 {
        (rest, doublings) = (rest / 2.0, doublings + 1);
    }
    let mut digits = (rest as u64).to_string().into_bytes();
    digits.reverse();
    for _ in 0..doublings {
        let mut carry = 0;
        for digit in &mut digits {
            let doubled = 2 * (*digit - b'0') + carry;
            (*digit, carry) = (b'0' + doubled % 10, doubled / 10);
        }
        digits.extend((carry > 0).then_some(b'1'));
    }
    let sign = if value < 0.0 { "-" } else { "" };
    sign.chars().chain(digits.iter().rev().map(|&digit| digit as char)).collect()
}

/// Parses a decimal number: sign, digits with an optional point, and an optional exponent. Up to 15 digits
/// give exactly the nearest value; further digits are used only as far as a length needs them.
pub fn read_number(text: &str) -> Option<f64> {
    let (negative, digits) = match text.as_bytes() {
        [b'-', digits @ ..] => (true, digits),
        [b'+', digits @ ..] | digits => (false, digits),
    };
    let (mut mantissa, mut exponent, mut point, mut any) = (0u64, 0i32, false, false);
    let mut at = 0;
    while let Some(&byte) = digits.get(at) {
        match byte {
            b'.' if !point => point = true,
            b'0'..=b'9' if mantissa < 1 << 53 => {
                mantissa = 10 * mantissa + u64::from(byte - b'0');
                exponent -= i32::from(point);
                any = true;
            }
            b'0'..=b'9' => exponent += i32::from(!point),
            b'e' | b'E' if any => {
                let power = text.get(text.len() - digits.len() + at + 1..)?.parse::<i32>().ok()?;
                exponent = exponent.saturating_add(power);
                break;
            }
            _ => return None,
        }
        at += 1;
    }
    let mantissa = mantissa as f64;
    let size = match exponent {
        0.. => mantissa * 10f64.powi(exponent),
        _ => mantissa / 10f64.powi(exponent.saturating_neg()),
    };
    any.then_some(if negative { -size } else { size })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_diameter_is_twice_its_radius() {
        assert_eq!(Diameter::from_radius(15.0), Diameter::new(30.0));
        assert_eq!((Diameter::new(30.0).mm(), Diameter::new(30.0).radius()), (30.0, 15.0));
    }

    #[test]
    fn a_number_is_shown_as_the_nearest_of_four_decimals() {
        let mut seed = 1u64;
        let mut random = || {
            seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            seed >> 11
        };
        for round in 0..20_000 {
            let value = match round % 4 {
                0 => (random() % 2_000_000) as f64 / 1000.0 - 1000.0,
                1 => (random() % 100_000) as f64 / 32768.0,
                2 => random() as f64 * 2f64.powi((random() % 120) as i32 - 110),
                _ => -(random() as f64) / (random() + 1) as f64,
            };
            let exact = format!("{value:.4}");
            let exact = exact.trim_end_matches('0').trim_end_matches('.');
            assert_eq!(number(value), if exact == "-0" { "0" } else { exact }, "{value:e}");
        }
        for (value, text) in [(f64::INFINITY, "inf"), (f64::NAN, "NaN"), (0.0, "0"), (f64::MIN_POSITIVE, "0")]
        {
            assert_eq!(number(value), text);
        }
        assert_eq!(number(1e20), "100000000000000000000");
        for value in [2f64.powi(63), -2f64.powi(64), 1.2345e25, f64::MAX] {
            assert_eq!(number(value), format!("{value:.0}"));
        }
    }

    #[test]
    fn a_number_is_read_exactly() {
        let texts =
            ["0", "-0", "12.5", "+.25", "5.", "0.1", "-123.4567", "0.30000000000001", "1e3", "2.5E-3"];
        for text in texts.into_iter().chain(["123456789012345", "00012.3400", "25.4", "0.0393700787"]) {
            assert_eq!(read_number(text).map(f64::to_bits), text.parse().ok().map(f64::to_bits), "{text}");
        }
        for text in ["", "-", ".", "1.2.3", "1e", "e5", "--1", "1 ", "1,5", "X1", "1e5.5"] {
            assert_eq!((read_number(text), text.parse::<f64>().ok()), (None, None), "{text}");
        }
        let near = read_number("0.3333333333333333333333333").unwrap();
        assert!((near - 1.0 / 3.0).abs() < 1e-15, "{near}");
    }

    #[test]
    fn numbers_read_as_people_write_them() {
        let cases = [(10.0, "10"), (-0.00001, "0"), (2.5, "2.5"), (1.0 / 3.0, "0.3333"), (-20.0, "-20")];
        for (value, text) in cases {
            assert_eq!(number(value), text);
        }
    }
}
