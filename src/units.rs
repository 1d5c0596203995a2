//! Units of length: millimetre and inch, radius and diameter; and how numbers are shown.
//!
//! In: a unit, or a value. Out: its size in millimetres, its least input increment, the
//! value as text. Knows no words.

use serde::{Deserialize, Serialize};

/// Unit of length of the program.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Unit {
    /// G21.
    #[default]
    Millimetre,
    /// G20.
    Inch,
}

impl Unit {
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

    /// Metres in the length that the S of G96 counts a minute: a metre, under G20 a foot (FANUC
    /// 16/18-T B-62754EN p. 127).
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

/// A length across the spindle axis as people write it: a diameter, mm. Inside, X is a radius
/// ([`Point`](crate::geometry::Point)); this type is the only way from one to the other, so neither
/// can be taken for the other.
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd, Deserialize, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(transparent)]
pub struct Diameter(f64);

impl Diameter {
    /// A diameter as it is written, mm.
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

    /// Half of it, mm.
    pub const fn radius(self) -> f64 {
        self.0 / 2.0
    }

    /// The diameter after a change of its number, such as rounding.
    pub fn map(self, change: impl FnOnce(f64) -> f64) -> Self {
        Self(change(self.0))
    }
}

/// A number as people write it: at most four decimals, no trailing zeros, never `-0`.
pub fn number(value: f64) -> String {
    let mut text = format!("{value:.4}");
    while text.ends_with('0') {
        text.pop();
    }
    if text.ends_with('.') {
        text.pop();
    }
    if text == "-0" { "0".into() } else { text }
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
    fn numbers_read_as_people_write_them() {
        let cases = [(10.0, "10"), (-0.00001, "0"), (2.5, "2.5"), (1.0 / 3.0, "0.3333"), (-20.0, "-20")];
        for (value, text) in cases {
            assert_eq!(number(value), text);
        }
    }
}
