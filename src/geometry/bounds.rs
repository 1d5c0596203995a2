//! Bounding boxes in the plane of the lathe.
//!
//! In: points and arcs. Out: the axis-parallel box around them, with the exact extents of arcs. Must not know
//! pixels.

use std::f64::consts::{FRAC_PI_2, TAU};

use super::{Arc, Point, Turn, wrapped};

/// An axis-parallel box; both corners in mm, `x` a radius.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// Smallest radius and smallest Z, mm.
    pub min: Point,
    /// Largest radius and largest Z, mm.
    pub max: Point,
}

impl Bounds {
    /// The box of a single point.
    pub fn of(point: Point) -> Self {
        Self { min: point, max: point }
    }

    /// The box around two points.
    pub fn around(a: Point, b: Point) -> Self {
        Self::of(a).with(b)
    }

    /// The box around an arc: its ends, and the quarter points of the circle that it passes.
    pub fn of_arc(arc: &Arc) -> Self {
        let mut bounds = Self::around(arc.start, arc.end);
        let (start, sweep) = (arc.start_angle(), arc.sweep());
        for quarter in 0..4 {
            let angle = f64::from(quarter) * FRAC_PI_2;
            let turned = match arc.turn {
                Turn::Counterclockwise => wrapped(angle - start, TAU),
                Turn::Clockwise => wrapped(start - angle, TAU),
            };
            if turned < sweep.abs() {
                bounds = bounds.with(arc.at(turned / sweep.abs()));
            }
        }
        bounds
    }

    /// The box extended to contain `point`.
    pub fn with(self, point: Point) -> Self {
        Self {
            min: Point::new(self.min.x.min(point.x), self.min.z.min(point.z)),
            max: Point::new(self.max.x.max(point.x), self.max.z.max(point.z)),
        }
    }

    /// The smallest box that contains both.
    pub fn union(self, other: Bounds) -> Self {
        self.with(other.min).with(other.max)
    }

    /// The box extended by `margin`, mm, on every side.
    pub fn grown(self, margin: f64) -> Self {
        Self {
            min: Point::new(self.min.x - margin, self.min.z - margin),
            max: Point::new(self.max.x + margin, self.max.z + margin),
        }
    }

    /// Extent along Z, mm.
    pub fn length(self) -> f64 {
        self.max.z - self.min.z
    }

    /// Extent along the radius, mm.
    pub fn height(self) -> f64 {
        self.max.x - self.min.x
    }

    /// Whether the point lies in the box or on its edge.
    pub fn contains(self, point: Point) -> bool {
        (self.min.x..=self.max.x).contains(&point.x) && (self.min.z..=self.max.z).contains(&point.z)
    }

    /// Whether both boxes share a point.
    pub fn overlaps(self, other: Bounds) -> bool {
        self.min.x <= other.max.x
            && other.min.x <= self.max.x
            && self.min.z <= other.max.z
            && other.min.z <= self.max.z
    }
}

/// The union of two optional boxes.
pub fn join(a: Option<Bounds>, b: Option<Bounds>) -> Option<Bounds> {
    match (a, b) {
        (Some(a), Some(b)) => Some(a.union(b)),
        (one, other) => one.or(other),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(start: (f64, f64), end: (f64, f64), center: (f64, f64), turn: Turn, expected: [f64; 4]) {
        let point = |(x, z)| Point::new(x, z);
        let arc = Arc { start: point(start), end: point(end), center: point(center), turn };
        let bounds = Bounds::of_arc(&arc);
        let found = [bounds.min.x, bounds.max.x, bounds.min.z, bounds.max.z];
        for (found, expected) in found.iter().zip(expected) {
            assert!((found - expected).abs() < 1e-9, "{bounds:?} of {arc:?}");
        }
    }

    #[test]
    fn arcs_reach_as_far_as_they_bulge() {
        // (x, z): a quarter from the right-most to the top-most point, in both directions.
        check((0.0, 10.0), (10.0, 0.0), (0.0, 0.0), Turn::Counterclockwise, [0.0, 10.0, 0.0, 10.0]);
        check((0.0, 10.0), (10.0, 0.0), (0.0, 0.0), Turn::Clockwise, [-10.0, 10.0, -10.0, 10.0]);
        check((6.0, 8.0), (6.0, -8.0), (0.0, 0.0), Turn::Counterclockwise, [6.0, 10.0, -8.0, 8.0]);
        check((6.0, 8.0), (6.0, -8.0), (0.0, 0.0), Turn::Clockwise, [-10.0, 6.0, -10.0, 10.0]);
        check((5.0, 0.0), (5.0, 0.0), (0.0, 0.0), Turn::Clockwise, [-5.0, 5.0, -5.0, 5.0]);
    }
}
