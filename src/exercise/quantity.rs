//! A measured size of a part.

use super::values::Tolerance;
use crate::geometry::Point;

/// What is measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// A diameter, mm.
    Diameter,
    /// The distance of a face from the right end, mm.
    Length,
    /// Z of the right end, mm.
    Face,
    /// The angle of a cone to the spindle axis, degrees.
    Angle,
    /// A radius, mm.
    Radius,
    /// The width of a groove, mm.
    Width,
    /// The lead of a thread, mm.
    Lead,
    /// The diameter at the roots of a thread, mm.
    Root,
    /// The diameter at the crests of a thread, mm.
    Crest,
    /// How far a thread is cut from the right end, mm.
    ThreadLength,
    /// The width across milled flats, mm.
    Flats,
}

/// A size of the part.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measured {
    /// What is measured.
    pub quantity: Quantity,
    /// Where: radius and Z, mm.
    pub at: Point,
    /// The wanted size.
    pub nominal: f64,
    /// The size of the part; `None` if it has no such surface.
    pub actual: Option<f64>,
    /// The permitted deviations.
    pub tolerance: Tolerance,
    /// The edge of the target, by its index.
    pub edge: usize,
}

impl Measured {
    /// Actual minus nominal size.
    pub fn deviation(&self) -> Option<f64> {
        self.actual.map(|actual| actual - self.nominal)
    }

    /// Whether the size is within its tolerance.
    pub fn is_in(&self) -> bool {
        self.deviation().is_some_and(|deviation| self.tolerance.permits(deviation))
    }
}
