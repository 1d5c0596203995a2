//! The wanted part of an exercise: an outline whose edges have tolerances.
//!
//! In: the lines of the outline. Out: a [`Target`]: edges, the area of the half-section, and where it ends. Must not
//! know how a part is made.

use super::edge::{Edge, Material};
use super::fault::TargetFault;
use super::flats::Flats;
use super::outline;
use super::values::Tolerance;
use crate::geometry::{Point, SAME};
use crate::machine::region::Region;

/// Distance beside an edge at which its side of the material is looked up, mm.
const BESIDE: f64 = 1e-3;

/// Least area, mm², and the share of it that rounding may change: an outline that crosses itself changes more.
const LEAST_AREA: f64 = 0.1;
const ROUNDING: f64 = 1e-4;

/// The wanted part.
#[derive(Clone, Debug, PartialEq)]
pub struct Target {
    /// The edges in their order.
    pub edges: Vec<Edge>,
    /// Largest rounding of inside corners, mm.
    pub corners: f64,
    /// The half-section.
    pub region: Region,
    /// Whether the part is parted off: its left end is an edge. Otherwise the rest of the bar follows.
    pub is_parted: bool,
    /// Z of its right end, mm.
    pub right: f64,
    /// Z of its left end, mm.
    pub left: f64,
    /// Flats that are milled on it.
    pub flats: Option<Flats>,
}

impl Target {
    /// Reads the lines of an outline. `general` is the tolerance of sizes without their own, `corners` the largest
    /// rounding of inside corners, mm. The error has the index of its line.
    pub(super) fn read(
        lines: &[&str],
        general: Tolerance,
        corners: f64,
    ) -> Result<Self, (usize, TargetFault)> {
        let (edges, flats) = outline::read(lines, general)?;
        let target = Self::of(edges, corners).map_err(|fault| (0, fault))?;
        Ok(Self { flats, ..target })
    }

    /// The target with these connected edges.
    pub(super) fn of(edges: Vec<Edge>, corners: f64) -> Result<Self, TargetFault> {
        let (Some(first), Some(last)) = (edges.first(), edges.last()) else {
            return Err(TargetFault::TooFew);
        };
        let (first, last) = (first.from, last.to);
        let z = || edges.iter().flat_map(Edge::points).map(|at| at.z);
        let (right, left) = (z().fold(f64::MIN, f64::max), z().fold(f64::MAX, f64::min));
        let is_closed = last.is_same(first);
        let is_on_axis = last.x <= SAME && first.x <= SAME;
        let ends_at_left =
            (last.z - left).abs() <= SAME && (first.x <= SAME || (first.z - left).abs() <= SAME);
        let is_parted = is_closed || is_on_axis;
        if !is_parted && !ends_at_left {
            return Err(TargetFault::End);
        }
        let region = region(&edges, left)?;
        let mut target = Self { edges, corners, region, is_parted, right, left, flats: None };
        target.find_material();
        Ok(target)
    }

    /// Determines on which side of each edge the material is.
    fn find_material(&mut self) {
        for edge in &mut self.edges {
            let (middle, left) = (edge.middle(), edge.left());
            let beside = Point::new(middle.x + BESIDE * left.x, middle.z + BESIDE * left.z);
            edge.inwards = if self.region.contains(beside) { left } else { left.opposite() };
        }
    }

    /// The edge that is nearest to a point after its tolerance is subtracted, and by how much the distance exceeds
    /// the tolerance, mm.
    pub(super) fn excess(&self, at: Point, material: Material) -> Option<(usize, f64)> {
        let edges = self.edges.iter().enumerate();
        let excess = edges.map(|(index, edge)| match edge.is_free {
            true => (index, edge.distance(at) - FREE),
            false => (index, edge.distance(at) - edge.permitted(material)),
        });
        excess.min_by(|a, b| a.1.total_cmp(&b.1))
    }

    /// Whether a point is so near to an inside corner that material there is the rounding of the tool.
    pub(super) fn is_in_corner(&self, at: Point) -> bool {
        self.inside_corners().any(|corner| corner.distance(at) <= self.corners + SAME)
    }

    /// The inside corners: between them and the next surface is no material.
    fn inside_corners(&self) -> impl Iterator<Item = Point> + '_ {
        let pairs = self.edges.iter().zip(self.edges.iter().skip(1));
        pairs.filter(|(before, after)| self.is_inside_corner(before, after)).map(|(before, _)| before.to)
    }

    /// Whether two connected edges form an inside corner.
    fn is_inside_corner(&self, before: &Edge, after: &Edge) -> bool {
        let [a, b] = [before.at(0.99), after.at(0.01)];
        let middle = Point::new((a.x + b.x) / 2.0, (a.z + b.z) / 2.0);
        before.to.distance(middle) > SAME && !self.region.contains(middle)
    }

    /// Whether an end of an edge is at an inside corner.
    pub(super) fn has_inside_corner(&self, at: Point) -> bool {
        self.inside_corners().any(|corner| corner.is_same(at))
    }
}

/// Permitted distance from an edge that is not measured, mm.
const FREE: f64 = 0.5;

/// The area inside the edges, closed along the spindle axis or at the left end.
fn region(edges: &[Edge], left: f64) -> Result<Region, TargetFault> {
    let mut corners: Vec<Point> = edges.iter().flat_map(Edge::points).collect();
    corners.dedup_by(|a, b| a.is_same(*b));
    let (Some(&first), Some(&last)) = (corners.first(), corners.last()) else {
        return Err(TargetFault::TooFew);
    };
    if first.x <= SAME && last.x > SAME && !first.is_same(last) {
        corners.push(Point::new(0.0, left));
    }
    let next = corners.iter().cycle().skip(1);
    let area: f64 = corners.iter().zip(next).map(|(a, b)| (a.z * b.x - b.z * a.x) / 2.0).sum();
    let region = Region::inside(&corners);
    let is_simple = (region.area() - area.abs()).abs() <= ROUNDING * area.abs() + SAME;
    if area.abs() < LEAST_AREA || !is_simple || region.pieces().count() != 1 {
        return Err(TargetFault::Crosses);
    }
    Ok(region)
}

#[cfg(test)]
mod tests {
    use super::super::edge::Size;
    use super::*;

    fn read(text: &str) -> Result<Target, TargetFault> {
        let lines: Vec<&str> = text.lines().collect();
        Target::read(&lines, Tolerance::both(0.1), 0.5).map_err(|(_, fault)| fault)
    }

    #[test]
    fn an_open_outline_ends_in_the_bar() {
        let step = read("X0 Z0\nX26\nZ-30\nX30\nZ-40").expect("a target");
        assert!(!step.is_parted && step.right == 0.0 && step.left == -40.0);
        assert!((step.region.area() - (13.0 * 30.0 + 15.0 * 10.0)).abs() < 1e-3);
        let inwards: Vec<_> = step.edges.iter().map(|edge| (edge.inwards.x, edge.inwards.z)).collect();
        assert_eq!(inwards, [(0.0, -1.0), (-1.0, 0.0), (0.0, -1.0), (-1.0, 0.0)]);
        // Only the foot of the shoulder is an inside corner.
        assert!(step.has_inside_corner(Point::new(13.0, -30.0)));
        assert!(!step.has_inside_corner(Point::new(15.0, -30.0)));
    }

    #[test]
    fn a_closed_outline_is_parted_off() {
        let pin = read("X0 Z0\nX20\nZ-30\nX0").expect("a target");
        assert!(pin.is_parted && pin.edges.len() == 3);
        let sleeve = read("X20 Z-40\nZ-30\nX30 Z0\nX46\nX50 Z-20\nX60\nZ-40\nX20").expect("a target");
        assert!(sleeve.is_parted);
        let bore = &sleeve.edges[0];
        assert_eq!((bore.size(), bore.inwards.x), (Size::Diameter, 1.0));
        // A tube in the bar begins and ends at its left end.
        assert!(!read("X20 Z-40\nZ0\nX60\nZ-40").expect("a target").is_parted);
    }

    #[test]
    fn outlines_without_an_area_are_refused() {
        for (text, fault) in [
            ("X0 Z0", TargetFault::TooFew),
            ("X0 Z0\nX20", TargetFault::Crosses),
            ("X0 Z0\nX20\nZ-10\nX30\nZ-5", TargetFault::End),
            ("X0 Z0\nX20\nZ-10\nX10 Z5\nX30\nZ-20", TargetFault::Crosses),
            ("X10 Z0\nX20\nZ-10", TargetFault::End),
        ] {
            assert_eq!(read(text), Err(fault), "{text}");
        }
    }
}
