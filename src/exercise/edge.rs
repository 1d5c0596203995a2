//! An edge of the outline of a target: its geometry, its size and the tolerance of the size.
//!
//! In: the ends of a line or arc, and tolerances. Out: how far a point is from the edge, and how much material more
//! or less the tolerance permits. Must not know the text of the file.

use super::values::Tolerance;
use crate::geometry::{Arc, Point, SAME, nearest_on};
use crate::machine::sweep::chords;
use crate::units::Diameter;

/// Tolerance of the angle of a cone if the file gives none, degrees.
pub(super) const ANGLE: Tolerance = Tolerance::both(0.5);

/// The size that an edge has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Size {
    /// A cylinder: its diameter.
    Diameter,
    /// A face: its distance from the right end.
    Length,
    /// A cone: its diameters and its angle.
    Taper,
    /// An arc: its radius.
    Radius,
}

/// The thread on a cylinder.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ThreadOf {
    /// Lead, mm.
    pub lead: f64,
    /// Diameter at the roots.
    pub root: Diameter,
    /// Tolerance of this diameter, mm.
    pub tolerance: Tolerance,
}

/// An edge of the outline.
#[derive(Clone, Debug, PartialEq)]
pub struct Edge {
    /// Its start, in the order of the outline.
    pub from: Point,
    /// Its end.
    pub to: Point,
    /// Its arc; `None` for a straight edge.
    pub arc: Option<Arc>,
    /// The tolerance of its size, mm.
    pub tolerance: Tolerance,
    /// The tolerance of the width of the groove; `None` if the edge is not the bottom of a groove.
    pub width: Option<Tolerance>,
    /// The tolerance of the angle of a cone, degrees.
    pub angle: Tolerance,
    /// The thread on it.
    pub thread: Option<ThreadOf>,
    /// Whether it is not measured, such as the surface of the bar.
    pub is_free: bool,
    /// The direction from the edge into the material, of length 1, at the middle of the edge.
    pub inwards: Point,
}

impl Edge {
    /// A straight edge with a tolerance.
    pub(super) fn line(from: Point, to: Point, tolerance: Tolerance) -> Self {
        Self {
            from,
            to,
            arc: None,
            tolerance,
            width: None,
            angle: ANGLE,
            thread: None,
            is_free: false,
            inwards: Point::default(),
        }
    }

    /// Its size.
    pub fn size(&self) -> Size {
        if self.arc.is_some() {
            Size::Radius
        } else if (self.from.x - self.to.x).abs() <= SAME {
            Size::Diameter
        } else if (self.from.z - self.to.z).abs() <= SAME {
            Size::Length
        } else {
            Size::Taper
        }
    }

    /// Its points: two for a line, chords for an arc.
    pub fn points(&self) -> Vec<Point> {
        self.arc.as_ref().map_or_else(|| vec![self.from, self.to], chords)
    }

    /// The point at the middle of its length.
    pub fn middle(&self) -> Point {
        self.at(0.5)
    }

    /// The point at a share of its length, 0 to 1.
    pub fn at(&self, share: f64) -> Point {
        let straight = || crate::geometry::at_share([self.from, self.to], share);
        self.arc.map_or_else(straight, |arc| arc.at(share))
    }

    /// Length, mm.
    pub fn length(&self) -> f64 {
        self.arc.map_or_else(|| self.from.distance(self.to), |arc| arc.length())
    }

    /// The direction to the left of its middle, of length 1, as the outline runs.
    pub(super) fn left(&self) -> Point {
        let [a, b] = [self.at(0.499), self.at(0.501)];
        let length = a.distance(b).max(f64::MIN_POSITIVE);
        Point::new((b.z - a.z) / length, -(b.x - a.x) / length)
    }

    /// Distance of a point, mm.
    pub fn distance(&self, at: Point) -> f64 {
        match self.arc {
            None => nearest_on([self.from, self.to], at).distance(at),
            Some(arc) if is_beside(&arc, at) => (at.distance(arc.center) - arc.radius()).abs(),
            Some(_) => at.distance(self.from).min(at.distance(self.to)),
        }
    }

    /// How far the surface may be from the edge, mm: with more material, or with less.
    pub fn permitted(&self, material: Material) -> f64 {
        let Tolerance { lower, upper } = self.tolerance;
        // Whether a larger size means more material.
        let grows = match self.size() {
            Size::Diameter | Size::Taper => self.inwards.x < 0.0,
            Size::Length => self.inwards.z > 0.0,
            Size::Radius => return upper.max(-lower),
        };
        let permitted = if grows == (material == Material::More) { upper } else { -lower };
        match self.size() {
            Size::Diameter | Size::Taper => Diameter::new(permitted).radius(),
            Size::Length | Size::Radius => permitted,
        }
    }
}

/// Whether the part has more or less material than the target at a place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Material {
    /// The part has material that the target lacks.
    More,
    /// The part lacks material.
    Less,
}

/// Whether the point is in the sector of an arc.
fn is_beside(arc: &Arc, at: Point) -> bool {
    let angle = (at.x - arc.center.x).atan2(at.z - arc.center.z);
    let turned = crate::geometry::wrapped(angle - arc.start_angle(), std::f64::consts::TAU);
    let sweep = arc.sweep();
    if sweep >= 0.0 { turned <= sweep } else { turned == 0.0 || std::f64::consts::TAU - turned <= -sweep }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Turn;

    #[test]
    fn distances_of_lines_and_arcs() {
        let line = Edge::line(Point::new(10.0, 0.0), Point::new(10.0, -20.0), Tolerance::both(0.1));
        assert_eq!(line.distance(Point::new(10.5, -5.0)), 0.5);
        assert_eq!(line.distance(Point::new(10.0, 3.0)), 3.0);
        let arc = Arc {
            start: Point::new(0.0, 0.0),
            end: Point::new(5.0, -5.0),
            center: Point::new(0.0, -5.0),
            turn: Turn::Counterclockwise,
        };
        let edge = Edge { arc: Some(arc), ..Edge::line(arc.start, arc.end, Tolerance::both(0.1)) };
        let angle = 45f64.to_radians();
        let beside = |radius: f64| Point::new(radius * angle.sin(), radius * angle.cos() - 5.0);
        assert!((edge.distance(beside(6.0)) - 1.0).abs() < 1e-9);
        assert!((edge.distance(beside(4.5)) - 0.5).abs() < 1e-9);
        assert!((edge.distance(Point::new(5.0, -8.0)) - 3.0).abs() < 1e-9);
    }

    #[test]
    fn a_tolerance_is_of_the_diameter_and_permits_half_of_it_on_a_side() {
        let fit = Tolerance { lower: -0.1, upper: 0.02 };
        let outside = Edge {
            inwards: Point::new(-1.0, 0.0),
            ..Edge::line(Point::new(10.0, 0.0), Point::new(10.0, -9.0), fit)
        };
        assert_eq!((outside.permitted(Material::More), outside.permitted(Material::Less)), (0.01, 0.05));
        let bore = Edge { inwards: Point::new(1.0, 0.0), ..outside };
        assert_eq!((bore.permitted(Material::More), bore.permitted(Material::Less)), (0.05, 0.01));
        // A shoulder that faces the tailstock: a longer step has less material.
        let shoulder = Edge {
            inwards: Point::new(0.0, -1.0),
            ..Edge::line(Point::new(10.0, -9.0), Point::new(12.0, -9.0), fit)
        };
        assert_eq!((shoulder.permitted(Material::More), shoulder.permitted(Material::Less)), (0.1, 0.02));
    }
}
