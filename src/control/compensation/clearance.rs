//! Distance between the path of the nose centre and programmed elements.
//!
//! In: a piece of the path of the centre, and a programmed element. Out: whether the nose cuts into the
//! element. Knows nothing of tips, and not how the path was found.

use super::path::{Element, Shape, Vector};
use crate::geometry::{Arc, Point, SAME, within};

/// Permitted depth of a cut into an element, mm: end points rounded to 0.01 mm make arcs that miss their
/// neighbours by as much.
pub(super) const ALLOWED: f64 = 0.02;

/// A piece of the path of the centre.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct CenterPath {
    pub(super) from: Point,
    pub(super) to: Point,
    pub(super) shape: Shape,
}

impl CenterPath {
    pub(super) fn of(element: &Element) -> Self {
        Self { from: element.from, to: element.to, shape: element.shape }
    }

    pub(super) fn straight(from: Point, to: Point) -> Self {
        Self { from, to, shape: Shape::Line }
    }

    /// Depth, mm, of the cut of a nose on this path into an element, if it is more than [`ALLOWED`].
    pub(super) fn gouge_depth(&self, element: &Element, radius: f64) -> Option<f64> {
        if radius <= ALLOWED {
            return None;
        }
        let other = Self::of(element);
        // Elements with distant bounding boxes need no exact test.
        let (low, high) = self.extent();
        let (other_low, other_high) = other.extent();
        let apart = (other_low.x - high.x).max(low.x - other_high.x).max(other_low.z - high.z);
        if apart.max(low.z - other_high.z) > radius {
            return None;
        }
        let depth = radius - self.distance(&other);
        (depth > ALLOWED).then_some(depth)
    }

    /// Corners of its bounding box.
    fn extent(&self) -> (Point, Point) {
        let (a, b) = (self.from, self.to);
        match self.shape {
            Shape::Line => (Point::new(a.x.min(b.x), a.z.min(b.z)), Point::new(a.x.max(b.x), a.z.max(b.z))),
            Shape::Arc { center, .. } => {
                let radius = center.distance(a).max(center.distance(b));
                (
                    Point::new(center.x - radius, center.z - radius),
                    Point::new(center.x + radius, center.z + radius),
                )
            }
        }
    }

    /// Smallest distance between two pieces, mm.
    fn distance(&self, other: &Self) -> f64 {
        if self.meets(other) {
            return 0.0;
        }
        let to_other =
            self.near_places(other).map(|place| place.map_or(f64::MAX, |at| other.distance_to(at)));
        let to_self = other.near_places(self).map(|place| place.map_or(f64::MAX, |at| self.distance_to(at)));
        to_other.into_iter().chain(to_self).fold(f64::MAX, f64::min)
    }

    /// Candidates for the point of this piece that is nearest to the other one: its ends, and the points in
    /// line with the centre of an arc.
    fn near_places(&self, other: &Self) -> [Option<Point>; 4] {
        let ends = [Some(self.from), Some(self.to)];
        let between = match (self.shape, other.shape) {
            (Shape::Line, Shape::Line) => [None; 2],
            (Shape::Line, Shape::Arc { center, .. }) => [Some(self.foot(center)), None],
            (Shape::Arc { center, .. }, Shape::Line) => {
                let foot = Vector::between(center, other.foot(center));
                self.across(center, foot)
            }
            (Shape::Arc { center, .. }, Shape::Arc { center: other, .. }) => {
                self.across(center, Vector::between(center, other))
            }
        };
        [ends[0], ends[1], between[0], between[1]]
    }

    /// The two points of an arc in a direction from its centre, and opposite.
    fn across(&self, center: Point, direction: Vector) -> [Option<Point>; 2] {
        let length = direction.length();
        if length <= SAME {
            return [None; 2];
        }
        let out = direction * (center.distance(self.from) / length);
        [out, out * -1.0].map(|out| Some(out.from(center)).filter(|at| self.has(*at)))
    }

    /// The point of a straight piece nearest to `point`.
    fn foot(&self, point: Point) -> Point {
        let along = Vector::between(self.from, self.to);
        let square = along.dot(along);
        if square <= SAME * SAME {
            return self.from;
        }
        let share = within(Vector::between(self.from, point).dot(along) / square, 0.0, 1.0);
        (along * share).from(self.from)
    }

    /// Whether a point of the arc's circle is on the arc.
    fn has(&self, point: Point) -> bool {
        match self.shape {
            Shape::Line => true,
            Shape::Arc { center, turn } => {
                let arc = Arc { start: self.from, end: self.to, center, turn };
                let reached = Arc { end: point, ..arc }.sweep();
                self.from.is_same(self.to) || reached.abs() <= arc.sweep().abs()
            }
        }
    }

    /// Distance from a point, mm.
    fn distance_to(&self, point: Point) -> f64 {
        match self.shape {
            Shape::Line => point.distance(self.foot(point)),
            Shape::Arc { center, .. } => {
                let ends = point.distance(self.from).min(point.distance(self.to));
                match self.has(point) {
                    true => ends.min((point.distance(center) - center.distance(self.from)).abs()),
                    false => ends,
                }
            }
        }
    }

    /// Whether the two cross.
    fn meets(&self, other: &Self) -> bool {
        match (self.shape, other.shape) {
            (Shape::Line, Shape::Line) => {
                let (one, two) = (Vector::between(self.from, self.to), Vector::between(other.from, other.to));
                let sides = |along: Vector, from: Point, a: Point, b: Point| {
                    along.cross(Vector::between(from, a)) * along.cross(Vector::between(from, b))
                };
                sides(one, self.from, other.from, other.to) < 0.0
                    && sides(two, other.from, self.from, self.to) < 0.0
            }
            (Shape::Line, Shape::Arc { center, .. }) => self.crosses_arc(other, center),
            (Shape::Arc { center, .. }, Shape::Line) => other.crosses_arc(self, center),
            (Shape::Arc { center, .. }, Shape::Arc { center: other_center, .. }) => {
                let (radius, other_radius) = (center.distance(self.from), other_center.distance(other.from));
                let between = Vector::between(center, other_center);
                let distance = between.length();
                if distance <= SAME {
                    return false;
                }
                let reach = (distance + (radius - other_radius) * (radius + other_radius) / distance) / 2.0;
                let square = (radius - reach) * (radius + reach);
                let middle = between * (reach / distance);
                let aside = between.left() * (square.max(0.0).sqrt() / distance);
                let on_both = |at: Vector| self.has(at.from(center)) && other.has(at.from(center));
                square > 0.0 && (on_both(middle + aside) || on_both(middle - aside))
            }
        }
    }

    /// Whether this straight piece crosses an arc.
    fn crosses_arc(&self, arc: &Self, center: Point) -> bool {
        let along = Vector::between(self.from, self.to);
        let length = along.length();
        if length <= SAME {
            return false;
        }
        let direction = along * (1.0 / length);
        let way_to_foot = direction.dot(Vector::between(self.from, center));
        let foot = (direction * way_to_foot).from(self.from);
        let radius = center.distance(arc.from);
        let off = foot.distance(center);
        let square = (radius - off) * (radius + off);
        let half = square.max(0.0).sqrt();
        let crosses = |way: f64| (0.0..=length).contains(&way) && arc.has((direction * way).from(self.from));
        square > 0.0 && (crosses(way_to_foot - half) || crosses(way_to_foot + half))
    }
}
