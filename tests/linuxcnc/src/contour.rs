//! The programmed elements of a contour and the corners between them, computed from the neutral program
//! alone.

use std::f64::consts::PI;

use gcode_playground::control::compensation::Side;
use gcode_playground::geometry::{Point, Turn};

/// LinuxCNC ignores turns smaller than this, radians.
const NEARLY_STRAIGHT: f64 = 0.05;

/// A programmed element.
#[derive(Clone, Copy, Debug)]
pub struct Way {
    /// Start point.
    pub from: Point,
    /// End point.
    pub to: Point,
    /// Centre and direction.
    pub arc: Option<(Point, Turn)>,
}

/// A corner between two elements.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Corner {
    /// There is no element on the other side.
    Open,
    /// Tangent.
    Straight,
    /// By a small angle.
    Near,
    /// Nearly straight back.
    Back,
    /// The nose passes on the inside.
    Inner,
    /// The nose passes around the outside.
    Outer,
}

/// Position of a block in a contour.
#[derive(Clone, Copy, Debug)]
pub struct InContour {
    /// Number of elements before it; the entry move is the first.
    pub index: usize,
    /// The previous element is a full circle.
    pub after_circle: bool,
    /// Its offset path only touches that of the previous element, or nothing is left of the previous element.
    pub fits_exactly: bool,
    /// No G40 ends the contour.
    pub unfinished: bool,
    /// Corner between the entry move and the contour.
    pub entry: Corner,
    /// Corner before the previous element.
    pub last_but_one: Corner,
    /// Corner before this element.
    pub before: Corner,
    /// Corner after this element.
    pub after: Corner,
}

/// Direction of a straight line as a unit vector: X, Z.
pub fn unit(from: Point, to: Point) -> (f64, f64) {
    let length = from.distance(to);
    ((to.x - from.x) / length, (to.z - from.z) / length)
}

impl Way {
    /// Whether it is a full circle.
    pub fn is_circle(&self) -> bool {
        self.arc.is_some() && self.from.is_same(self.to)
    }

    /// Direction of travel at one of its ends.
    pub fn direction(&self, at: Point) -> (f64, f64) {
        let Some((center, turn)) = self.arc else { return unit(self.from, self.to) };
        // Perpendicular to the radius.
        let (x, z) = unit(center, at);
        match turn {
            Turn::Counterclockwise => (z, -x),
            Turn::Clockwise => (-z, x),
        }
    }
}

/// The corner between two elements, with the nose on the given side.
pub fn corner(first: &Way, second: &Way, side: Side) -> Corner {
    let ((x1, z1), (x2, z2)) = (first.direction(first.to), second.direction(second.from));
    let angle = (z1 * x2 - x1 * z2).atan2(z1 * z2 + x1 * x2);
    let left = if side == Side::Left { 1.0 } else { -1.0 };
    if angle.abs() < 1e-5 {
        Corner::Straight
    } else if angle.abs() < NEARLY_STRAIGHT + 1e-5 {
        Corner::Near
    } else if angle.abs() > PI - NEARLY_STRAIGHT - 1e-5 {
        Corner::Back
    } else if left * angle < 0.0 {
        Corner::Outer
    } else {
        Corner::Inner
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn corners_are_inner_or_outer_by_the_side_of_the_nose() {
        let line = |from: (f64, f64), to: (f64, f64)| Way {
            from: Point::new(from.0, from.1),
            to: Point::new(to.0, to.1),
            arc: None,
        };
        // Towards the chuck, then away from the axis: a turn to the right.
        let (along, out) = (line((20.0, 0.0), (20.0, -30.0)), line((20.0, -30.0), (40.0, -30.0)));
        assert_eq!(corner(&along, &out, Side::Right), Corner::Inner);
        assert_eq!(corner(&along, &out, Side::Left), Corner::Outer);
        assert_eq!(corner(&along, &line((20.0, -30.0), (20.5, -60.0)), Side::Left), Corner::Near);
        assert_eq!(corner(&along, &line((20.0, -30.0), (20.5, -3.0)), Side::Left), Corner::Back);
        // A quarter circle away from the axis begins along the line.
        let arc = Way { arc: Some((Point::new(25.0, -30.0), Turn::Clockwise)), ..out };
        assert_eq!(corner(&along, &arc, Side::Left), Corner::Straight);
    }
}
