//! The area that a tool sweeps.
//!
//! In: the outline of a tool and the path of its tip. Out: outlines of the swept area. Straight paths are
//! exact; arcs are approximated by chords within [`CHORD`]. Must not know what is cut.

use crate::geometry::{Arc, Point};
use crate::motion::Motion;

/// Greatest distance of a chord from its arc, mm. The radius of a part is exact to twice this.
pub const CHORD: f64 = 0.002;

/// Most chords of one arc.
const MAX_CHORDS: f64 = 2000.0;

/// A closed convex outline, counter-clockwise with Z to the right and X up. The tip is at the origin.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Outline {
    points: Vec<Point>,
}

impl Outline {
    /// The smallest convex outline around some points.
    pub fn around(points: impl IntoIterator<Item = Point>) -> Self {
        // With a few dozen points an insertion sort is fast enough, and smaller in the module than `sort`.
        let mut sorted: Vec<Point> = Vec::new();
        for point in points {
            let is_before = |other: &Point| (other.z, other.x) < (point.z, point.x);
            sorted.insert(sorted.partition_point(is_before), point);
        }
        sorted.dedup_by(|a, b| a.is_same(*b));
        // Andrew's two chains: the lower one from left to right, the upper one back.
        let mut points: Vec<Point> = Vec::with_capacity(sorted.len() + 1);
        for half in [sorted.to_vec(), sorted.into_iter().rev().collect()] {
            let begin = points.len();
            for point in half {
                while points.len() >= begin + 2
                    && turn(points[points.len() - 2], points[points.len() - 1], point) <= 0.0
                {
                    points.pop();
                }
                points.push(point);
            }
            points.pop();
        }
        Self { points }
    }

    /// Its corners.
    pub fn points(&self) -> &[Point] {
        &self.points
    }

    /// The outline with the tip at a point.
    pub fn at(&self, tip: Point) -> Vec<Point> {
        self.points.iter().map(|point| point.moved(tip)).collect()
    }

    /// The area swept while the tip moves straight; empty for an empty outline. The edges that face forwards
    /// are at the end of the path, the others at the start.
    pub fn along_line(&self, from: Point, to: Point) -> Vec<Point> {
        let (dx, dz) = (to.x - from.x, to.z - from.z);
        let count = self.points.len();
        if count == 0 {
            return Vec::new();
        }
        let looks_ahead = |index: usize| {
            let (a, b) = (self.points[index % count], self.points[(index + 1) % count]);
            // The component along the path of the normal to the right of the edge, which points outwards.
            (b.x - a.x) * dz - (b.z - a.z) * dx > 0.0
        };
        let mut outline = Vec::with_capacity(count + 2);
        let mut before = looks_ahead(count.wrapping_sub(1));
        for (index, &point) in self.points.iter().enumerate() {
            let behind = looks_ahead(index);
            match (before, behind) {
                (true, true) => outline.push(point.moved(to)),
                (false, false) => outline.push(point.moved(from)),
                (true, false) => outline.extend([point.moved(to), point.moved(from)]),
                (false, true) => outline.extend([point.moved(from), point.moved(to)]),
            }
            before = behind;
        }
        outline
    }

    /// The area swept while the tip moves through the points, one outline for each straight piece.
    pub fn along(&self, way: &[Point]) -> impl Iterator<Item = Vec<Point>> {
        way.windows(2).map(|ends| self.along_line(ends[0], ends[1]))
    }

    /// The part of the outline nearest to the tip: the outline scaled by `share` about its nearest corner.
    pub fn near_tip(&self, share: f64) -> Self {
        let from_tip = |point: &Point| point.distance(Point::default());
        let nearest = self
            .points
            .iter()
            .copied()
            .min_by(|a, b| from_tip(a).total_cmp(&from_tip(b)))
            .unwrap_or_default();
        let drawn = |to: f64, from: f64| from + share * (to - from);
        let points =
            self.points.iter().map(|point| Point::new(drawn(point.x, nearest.x), drawn(point.z, nearest.z)));
        Self { points: points.collect() }
    }

    /// The part of the outline at least `by` mm from the tip in a direction of length 1.
    pub fn beyond(&self, by: f64, direction: Point) -> Self {
        let depth = |point: Point| point.x * direction.x + point.z * direction.z - by;
        Self { points: cut_off(&self.points, depth) }
    }

    /// The outline shrunk by `by` mm on all sides; empty if it is too small.
    pub fn shrunk(&self, by: f64) -> Self {
        let count = self.points.len();
        let mut points = self.points.clone();
        for index in 0..count {
            let (a, b) = (self.points[index], self.points[(index + 1) % count]);
            let length = a.distance(b);
            if length <= 0.0 {
                continue;
            }
            // Removes everything outside the line `by` inside this edge.
            let (nx, nz) = (-(b.z - a.z) / length, (b.x - a.x) / length);
            let depth = |point: Point| -((point.x - a.x) * nx + (point.z - a.z) * nz) - by;
            points = cut_off(&points, depth);
        }
        Self { points }
    }
}

/// The points of the path of a motion in the turning plane, to be joined by straight lines.
pub fn path_of(motion: &Motion) -> Vec<Point> {
    motion.arc().map_or_else(|| vec![motion.from, motion.to], |arc| chords(&arc))
}

/// The points of an arc, including its ends, whose chords stay within [`CHORD`] of the arc.
pub fn chords(arc: &Arc) -> Vec<Point> {
    let radius = arc.radius().max(CHORD);
    let widest = 2.0 * (1.0 - CHORD / radius).max(-1.0).acos();
    let count = (arc.sweep().abs() / widest).ceil().clamp(1.0, MAX_CHORDS);
    let inside = (1..count as u32).map(|piece| arc.at(f64::from(piece) / count));
    [arc.start].into_iter().chain(inside).chain([arc.end]).collect()
}

/// The part of a convex outline where `depth`, a linear function, is not negative.
fn cut_off(points: &[Point], depth: impl Fn(Point) -> f64) -> Vec<Point> {
    let mut kept = Vec::with_capacity(points.len() + 1);
    for (index, &point) in points.iter().enumerate() {
        let next = points[(index + 1) % points.len()];
        let (own, its) = (depth(point), depth(next));
        if own >= 0.0 {
            kept.push(point);
        }
        if (own >= 0.0) != (its >= 0.0) {
            let share = own / (own - its);
            kept.push(Point::new(point.x + share * (next.x - point.x), point.z + share * (next.z - point.z)));
        }
    }
    kept
}

/// Positive if the path from `a` through `b` to `c` turns left.
fn turn(a: Point, b: Point, c: Point) -> f64 {
    (b.z - a.z) * (c.x - a.x) - (b.x - a.x) * (c.z - a.z)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Turn;
    use crate::machine::region::Region;

    fn square() -> Outline {
        let corners = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0), (0.5, 0.5)];
        Outline::around(corners.map(|(x, z)| Point::new(x, z)))
    }

    #[test]
    fn an_outline_is_convex_and_runs_to_the_left() {
        assert_eq!(square().points().len(), 4);
        assert!((Region::inside(square().points()).area() - 1.0).abs() < 1e-9);
    }

    #[test]
    fn a_straight_way_passes_over_start_end_and_all_between() {
        for (to, area) in [((3.0, 0.0), 4.0), ((0.0, -2.0), 3.0), ((2.0, 2.0), 5.0), ((-2.0, 1.0), 4.0)] {
            let outline = square().along_line(Point::new(10.0, 5.0), Point::new(10.0 + to.0, 5.0 + to.1));
            assert!((Region::inside(&outline).area() - area).abs() < 1e-4, "{to:?}");
            assert!(outline.iter().all(|point| point.x.is_finite()));
        }
        assert!(
            (Region::inside(&square().along_line(Point::default(), Point::default())).area() - 1.0).abs()
                < 1e-9
        );
    }

    #[test]
    fn shrinking_moves_every_edge() {
        let smaller = square().shrunk(0.1);
        assert!((Region::inside(smaller.points()).area() - 0.64).abs() < 1e-4);
        assert!(square().shrunk(0.6).points().len() < 3);
    }

    #[test]
    fn chords_stay_near_their_arc() {
        let arc = |turn| Arc {
            start: Point::new(20.0, 0.0),
            end: Point::new(0.0, -20.0),
            center: Point::default(),
            turn,
        };
        for arc in [arc(Turn::Clockwise), arc(Turn::Counterclockwise)] {
            let points = chords(&arc);
            assert_eq!((points[0], *points.last().unwrap()), (arc.start, arc.end));
            for ends in points.windows(2) {
                let middle = Point::new((ends[0].x + ends[1].x) / 2.0, (ends[0].z + ends[1].z) / 2.0);
                assert!((middle.distance(arc.center) - 20.0).abs() <= CHORD + 1e-9);
            }
        }
    }
}
