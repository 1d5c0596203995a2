//! The unit of length of a program, and how numbers are shown.
//!
//! In: a unit, or a value. Out: its size in millimetres, its least input increment, the value as text. Knows no words.

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

    /// Metres in the length that the S of G96 counts a minute: a metre, under G20 a foot (FANUC 16/18-T B-62754EN p. 127).
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
    fn numbers_read_as_people_write_them() {
        let cases = [(10.0, "10"), (-0.00001, "0"), (2.5, "2.5"), (1.0 / 3.0, "0.3333"), (-20.0, "-20")];
        for (value, text) in cases {
            assert_eq!(number(value), text);
        }
    }
}
