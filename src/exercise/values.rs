//! Values of an exercise file: ranges and tolerances.
//!
//! In: a word or two of the file. Out: a [`Range`] or a [`Tolerance`].

use crate::setup::blank::Outline;
use crate::units::read_number;

/// A range that includes its ends. A missing end is open.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Range {
    /// Least value.
    pub least: Option<f64>,
    /// Greatest value.
    pub most: Option<f64>,
}

impl Range {
    /// Reads `0.1..0.3`, `..2.5` or `80..`; negative values, and a range without an end, are refused.
    pub fn read(text: &str) -> Option<Self> {
        let (least, most) = text.split_once("..")?;
        let end = |text: &str| match text.trim() {
            "" => Some(None),
            number => read_number(number).filter(|value| (0.0..1e6).contains(value)).map(Some),
        };
        let range = Self { least: end(least)?, most: end(most)? };
        let is_empty = range.least.is_none() && range.most.is_none();
        let is_reversed = range.least.zip(range.most).is_some_and(|(least, most)| least > most);
        (!is_empty && !is_reversed).then_some(range)
    }

    /// Whether a value is in the range; a difference below the display of numbers does not count.
    pub fn contains(self, value: f64) -> bool {
        const SMALL: f64 = 1e-4;
        self.least.is_none_or(|least| value >= least - SMALL)
            && self.most.is_none_or(|most| value <= most + SMALL)
    }
}

/// The permitted deviations of a size, mm or degrees: `lower` is zero or less, `upper` zero or more.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tolerance {
    /// Greatest deviation below the nominal size, zero or negative.
    pub lower: f64,
    /// Greatest deviation above the nominal size.
    pub upper: f64,
}

/// A difference below this, mm or degrees, does not leave a tolerance: the measuring error.
const MEASURING: f64 = 5e-4;

impl Tolerance {
    /// The same deviation in both directions.
    pub const fn both(deviation: f64) -> Self {
        Self { lower: -deviation, upper: deviation }
    }

    /// Whether a deviation is permitted.
    pub fn permits(self, deviation: f64) -> bool {
        (self.lower - MEASURING..=self.upper + MEASURING).contains(&deviation)
    }

    /// Reads `±0.05` (also `+-0.05`), or upper and lower deviation, `+0.02 -0.01`. Returns the tolerance and the
    /// number of words that it takes; `None` if the words are no tolerance.
    pub fn read(words: &[&str]) -> Option<(Self, usize)> {
        let first = *words.first()?;
        if let Some(value) = first.strip_prefix('±').or_else(|| first.strip_prefix("+-")) {
            let deviation = deviation(value).filter(|deviation| *deviation >= 0.0)?;
            return Some((Self::both(deviation), 1));
        }
        let upper = first.strip_prefix('+').and_then(deviation)?;
        let lower = words.get(1)?.strip_prefix('-').and_then(deviation)?;
        (upper >= 0.0 && lower >= 0.0).then_some((Self { lower: -lower, upper }, 2))
    }
}

/// A number without a sign, at most 100.
fn deviation(text: &str) -> Option<f64> {
    let is_plain = text.starts_with(|first: char| first.is_ascii_digit() || first == '.');
    read_number(text).filter(|value| is_plain && (0.0..=100.0).contains(value))
}

impl std::fmt::Display for Tolerance {
    /// As in a file: `±0.05` or `+0.02 -0.01`.
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let number = crate::units::number;
        if (self.lower + self.upper).abs() < 1e-9 {
            write!(f, "±{}", number(self.upper))
        } else {
            write!(f, "+{} -{}", number(self.upper), number(-self.lower))
        }
    }
}

/// `X26 Z-30`: a diameter and a length, mm.
pub(super) fn position(value: &str) -> Option<[f64; 2]> {
    let (x, z) = value.split_once(char::is_whitespace)?;
    let read = |text: &str, letter: [char; 2]| {
        let number = read_number(text.trim().strip_prefix(letter)?)?;
        (number.abs() <= Outline::FARTHEST).then_some(number)
    };
    Some([read(x, ['X', 'x'])?, read(z, ['Z', 'z'])?])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranges_have_one_end_or_two() {
        let range = |text: &str| Range::read(text).map(|range| (range.least, range.most));
        assert_eq!(range("0.1..0.3"), Some((Some(0.1), Some(0.3))));
        assert_eq!(range("..2.5"), Some((None, Some(2.5))));
        assert_eq!(range("80 .. "), Some((Some(80.0), None)));
        for text in ["", "..", "3", "3..1", "-1..2", "a..b", "1..2..3", "1..1e9"] {
            assert_eq!(range(text), None, "{text}");
        }
        let range = Range { least: Some(1.0), most: Some(2.0) };
        assert!(range.contains(1.0) && range.contains(2.0) && !range.contains(2.1) && !range.contains(0.9));
    }

    #[test]
    fn a_tolerance_takes_one_word_or_two() {
        let read = |text: &str| {
            let words: Vec<&str> = text.split(' ').collect();
            Tolerance::read(&words).map(|(own, count)| (own.lower, own.upper, count))
        };
        assert_eq!(read("±0.05 width"), Some((-0.05, 0.05, 1)));
        assert_eq!(read("+-0.1"), Some((-0.1, 0.1, 1)));
        assert_eq!(read("+0.02 -0.01"), Some((-0.01, 0.02, 2)));
        assert_eq!(read("+0 -0.1"), Some((-0.1, 0.0, 2)));
        for text in ["", "0.05", "±", "±-1", "+0.1", "+0.1 0.2", "-0.1 +0.1", "±1e9", "+0.1 --0.1"] {
            assert_eq!(read(text), None, "{text}");
        }
        assert_eq!(Tolerance::both(0.05).to_string(), "±0.05");
        assert_eq!(Tolerance { lower: -0.1, upper: 0.0 }.to_string(), "+0 -0.1");
    }
}
