//! The unit of P and Q in G74, G75 and G76: least increments, as on controls (GSK980TDb pp. 119, 135), or
//! millimetres, as in an article on G70 to G76 (seed 003 in the glossary).
//!
//! In: the lengths in least increments, and whether the words have a decimal point. Out: the unit and the
//! reason. Only used if the setup leaves the unit open. The caller reads the words.

use super::grooving::steps;
use crate::geometry::Point;
use crate::units::Unit;

/// Whether a number was written with a decimal point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Written {
    /// `Q500`.
    WithoutPoint,
    /// `Q0.5`.
    WithPoint,
}

/// A P or Q word.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Amount {
    /// The length in mm if the number counts least increments of 0.001 mm, or 0.0001 inch.
    pub in_increments: f64,
    /// Whether it has a decimal point.
    pub written: Written,
}

impl Amount {
    /// The length, mm.
    pub fn mm(self, reading: Reading, unit: Unit) -> f64 {
        match reading {
            Reading::Micrometres => self.in_increments,
            // The written number is a length in the unit of the program.
            Reading::Millimetres(_) => self.in_increments / unit.increment(),
        }
    }
}

/// The unit of P and Q.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reading {
    /// Least increments, 0.001 mm or 0.0001 inch, as in the manuals.
    Micrometres,
    /// Millimetres (inches in an inch program), contrary to the manuals (W-PQ-UNIT).
    Millimetres(Because),
}

/// Why P and Q are read as millimetres.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Because {
    /// A decimal point, which only lengths have.
    Point,
    /// Small numbers that would make hundreds of pecks or columns.
    TooManySteps,
    /// A first thread pass so thin that it would only scratch.
    TooThin,
}

/// P and Q shorter than this, mm, may have been meant as millimetres: `Q5` is 0.005 mm.
const SUSPICIOUS_LENGTH: f64 = 0.05;

/// More pecks or columns than this are not intended.
const MANY_STEPS: f64 = 200.0;

/// Minimum depth of the first pass of a thread, mm; a thinner pass would only scratch.
const MIN_FIRST_PASS: f64 = 0.02;

/// Reads P (along X) and Q (along Z) of G74 or G75 from `start` to `end`.
pub fn pecking(start: Point, end: Point, p: Option<Amount>, q: Option<Amount>) -> Reading {
    if has_point([p, q]) {
        return Reading::Millimetres(Because::Point);
    }
    let too_many = |amount: Option<Amount>, way: f64| {
        amount.is_some_and(|amount| {
            let length = amount.in_increments;
            length > 0.0 && length < SUSPICIOUS_LENGTH && steps(way, length) > MANY_STEPS
        })
    };
    if too_many(p, end.x - start.x) || too_many(q, end.z - start.z) {
        return Reading::Millimetres(Because::TooManySteps);
    }
    Reading::Micrometres
}

/// Reads Q of the first block of G76 (least depth), P (height) and Q (first depth) of the second.
///
/// A thin first pass is no evidence if the height is clearly in micrometres: `P1300 Q15` is not 1300 mm.
pub fn threading(
    least_depth: Option<Amount>,
    height: Option<Amount>,
    first_depth: Option<Amount>,
) -> Reading {
    if has_point([least_depth, height, first_depth]) {
        return Reading::Millimetres(Because::Point);
    }
    let thin =
        first_depth.is_some_and(|first| first.in_increments > 0.0 && first.in_increments < MIN_FIRST_PASS);
    if thin && height.is_none_or(|height| height.in_increments < SUSPICIOUS_LENGTH) {
        return Reading::Millimetres(Because::TooThin);
    }
    Reading::Micrometres
}

fn has_point<const COUNT: usize>(amounts: [Option<Amount>; COUNT]) -> bool {
    amounts.iter().flatten().any(|amount| amount.written == Written::WithPoint)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `Q500` of a millimetre program.
    fn whole(number: u32) -> Option<Amount> {
        Some(Amount { in_increments: f64::from(number) * 0.001, written: Written::WithoutPoint })
    }

    /// `Q0.5`: for a control that counts increments it is half of one.
    fn point(number: f64) -> Option<Amount> {
        Some(Amount { in_increments: number * 0.001, written: Written::WithPoint })
    }

    #[test]
    fn pecks() {
        let read =
            |x: f64, z: f64, p, q| pecking(Point::new(21.0, 22.0), Point::new(21.0 + x, 22.0 + z), p, q);
        let many = Reading::Millimetres(Because::TooManySteps);
        // Blocks of seed 003: `G74 Z-12 Q5` from Z2, `G75 X30 Z10 P3 Q2.9`.
        assert_eq!(read(0.0, -14.0, None, whole(5)), many);
        assert_eq!(read(-6.0, -12.0, whole(3), point(2.9)), Reading::Millimetres(Because::Point));
        assert_eq!(read(-6.0, -12.0, whole(3), whole(2900)), many);
        assert_eq!(read(-6.0, -12.0, whole(3000), whole(2900)), Reading::Micrometres);
        // Small numbers with few steps; many steps with large numbers.
        assert_eq!(read(-0.6, 0.0, whole(3), None), Reading::Micrometres);
        assert_eq!(read(-0.603, 0.0, whole(3), None), many);
        assert_eq!(read(0.0, 300.0, None, whole(50)), Reading::Micrometres);
        assert_eq!(read(0.0, 300.0, None, whole(49)), many);
        // Nothing to count.
        assert_eq!(read(0.0, 300.0, None, whole(0)), Reading::Micrometres);
        assert_eq!(read(0.0, 300.0, None, None), Reading::Micrometres);
    }

    #[test]
    fn threads() {
        assert_eq!(threading(point(0.1), point(2.4), point(0.7)), Reading::Millimetres(Because::Point));
        assert_eq!(threading(point(0.1), whole(2), whole(1)), Reading::Millimetres(Because::Point));
        assert_eq!(threading(None, whole(2), whole(1)), Reading::Millimetres(Because::TooThin));
        assert_eq!(threading(whole(100), whole(1300), whole(450)), Reading::Micrometres);
        assert_eq!(threading(whole(100), whole(1300), whole(15)), Reading::Micrometres);
        assert_eq!(threading(whole(0), whole(2), whole(0)), Reading::Micrometres);
    }
}
