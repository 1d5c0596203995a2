//! Converts the outline of the part to lines and true arcs.
//!
//! In: the half-section, whose arcs are approximated by chords. Out: closed chains of [`Segment`]s, in which
//! consecutive edges on one circle are an arc again. Must not know what the outline is for.

use std::f64::consts::PI;

use crate::geometry::bounds::Bounds;
use crate::geometry::{Arc, Point, SAME, Turn};
use crate::machine::region::Region;
use crate::machine::sweep::CHORD;

/// Maximum distance of an arc from the corners and edge midpoints that it replaces, mm.
pub const FIT: f64 = 2.0 * CHORD;

/// Minimum number of edges in an arc: any three points lie on a circle.
const MIN_EDGES: usize = 3;

/// Number of consecutive failures before the search for a longer arc stops: an arc may not fit if it ends at
/// a corner slightly off the circle, although a longer one fits.
const MAX_FAILURES: usize = 2;

/// Maximum distance of a corner from the line through its neighbours to be ignored, mm.
const STRAIGHT: f64 = CHORD / 8.0;

/// Maximum turn of an arc in the opposite direction at a corner, radians: both the nose and the path of a
/// tool are approximated by chords, so their combination may turn back slightly.
const WOBBLE: f64 = 0.02;

/// Minimum height of an arc above its chord, mm; a flatter one is a straight line. Three chords of an arc
/// rise nine times as much as one.
const MIN_HEIGHT: f64 = 3.0 * FIT;

/// Number of iterations that balance an arc between the corners outside and inside of it.
const BALANCINGS: usize = 3;

/// Maximum angle of an arc, radians: a full circle has no end points that show its direction, and the rest of
/// it must be an arc, too.
const WIDEST: f64 = 1.5 * PI;

/// Maximum radius of a corner on the spindle axis, mm: the grid of areas may shift a corner by this.
const ON_AXIS: f64 = 2e-5;

/// Rounding steps of radii, mm; the coarsest one that fits is used.
const ROUND: [f64; 4] = [0.5, 0.1, 0.01, 0.001];

/// A segment of an outline.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Segment {
    /// A straight edge.
    Line(Point, Point),
    /// A true arc.
    Arc(Arc),
}

/// The closed outlines of an area, including those of holes, with the material on the left. The outline of a
/// solid part runs along the spindle axis; nothing is below the axis.
pub fn outlines(region: &Region) -> Vec<Vec<Segment>> {
    let above = |at: Point| Point::new(if at.x < ON_AXIS { 0.0 } else { at.x }, at.z);
    region.outlines().map(|outline| segments(&outline.map(above).collect::<Vec<_>>())).collect()
}

/// Converts a closed outline to lines and arcs.
fn segments(outline: &[Point]) -> Vec<Segment> {
    let mut points = from_sharpest_corner(outline);
    points.dedup_by(|a, b| a.is_same(*b));
    if points.len() < 3 {
        return Vec::new();
    }
    points.push(points[0]);
    let mut found = Vec::new();
    let mut at = 0;
    while at + 1 < points.len() {
        let (edges, segment) = next_segment(&points[at..]);
        found.push(segment);
        at += edges;
    }
    found
}

/// Rotates the outline to begin at its sharpest corner, which no arc crosses.
fn from_sharpest_corner(outline: &[Point]) -> Vec<Point> {
    let count = outline.len();
    let sharpness = |&index: &usize| {
        let at = |step: usize| outline[(index + count + step - 1) % count];
        turned(at(0), at(1), at(2)).abs()
    };
    let first = (0..count).max_by(|a, b| sharpness(a).total_cmp(&sharpness(b))).unwrap_or(0);
    outline.iter().cycle().skip(first).take(count).copied().collect()
}

/// The longest arc from the first point, or else the longest straight line.
fn next_segment(points: &[Point]) -> (usize, Segment) {
    let mut best = None;
    let mut missed = 0;
    for edges in MIN_EDGES..points.len() {
        match arc_through(&points[..=edges]) {
            Some(arc) => (best, missed) = (Some((edges, Segment::Arc(arc))), 0),
            None => missed += 1,
        }
        if missed > MAX_FAILURES {
            break;
        }
    }
    best.unwrap_or_else(|| {
        let straight = |&edges: &usize| {
            let (from, to) = (points[0], points[edges]);
            points[1..edges].iter().all(|&point| distance_from_line(point, from, to) <= STRAIGHT)
        };
        let edges = (2..points.len()).take_while(straight).last().unwrap_or(1);
        (edges, Segment::Line(points[0], points[edges]))
    })
}

/// The arc from the first point to the last on which all other points lie, if any.
fn arc_through(points: &[Point]) -> Option<Arc> {
    let (start, end) = (points[0], points[points.len() - 1]);
    let inner = &points[1..points.len() - 1];
    // All edges must turn in the same direction, and by less than `WIDEST` in total.
    let turns: Vec<f64> = points.windows(3).map(|three| turned(three[0], three[1], three[2])).collect();
    let whole: f64 = turns.iter().sum();
    let same_way = turns.iter().all(|turn| turn * whole.signum() > -WOBBLE);
    if !same_way || whole.abs() > WIDEST || start.is_same(end) {
        return None;
    }
    // Inscribed angle: from every point on an arc its chord is seen at the same angle. The sum weights points
    // far from the ends more.
    let (cross, dot) = inner.iter().fold((0.0, 0.0), |(cross, dot), point| {
        let (a, b) = (from_to(*point, start), from_to(*point, end));
        (cross + a.1 * b.0 - a.0 * b.1, dot + a.0 * b.0 + a.1 * b.1)
    });
    let seen = f64::atan2(cross, dot);
    // Half the angle of the arc, radians; positive is counter-clockwise.
    let half = if seen < 0.0 { seen + PI } else { seen - PI };
    if half.signum() != whole.signum() {
        return None;
    }
    let chord = start.distance(end);
    let mut height = chord / 2.0 * (half / 2.0).tan();
    for _ in 0..BALANCINGS {
        let arc = arc_of(start, end, 2.0 * (2.0 * height / chord).atan())?;
        let (least, most) = deviations(&arc, points);
        height += height.signum() * (least + most) / 2.0;
    }
    if height.abs() < MIN_HEIGHT {
        return None;
    }
    let half = 2.0 * (2.0 * height / chord).atan();
    let radius = chord / (2.0 * half.sin().abs());
    let rounded = ROUND.iter().filter_map(|step| {
        let radius = (radius / step).round() * step;
        let quarter = (chord / (2.0 * radius)).asin();
        let size = if half.abs() > PI / 2.0 { PI - quarter } else { quarter };
        arc_of(start, end, half.signum() * size)
    });
    // A nose that ends on the axis is tangent there: a larger circle through the same corners would extend
    // below the axis.
    let lowest = points.iter().fold(0.0, |lowest: f64, point| lowest.min(point.x));
    let fits = |arc: &Arc| {
        let (least, most) = deviations(arc, points);
        least >= -FIT && most <= FIT && Bounds::of_arc(arc).min.x >= lowest - SAME
    };
    rounded.chain(arc_of(start, end, half)).find(fits)
}

/// The arc between two points with the angle 2 × `half`, radians, positive counter-clockwise.
fn arc_of(start: Point, end: Point, half: f64) -> Option<Arc> {
    let chord = start.distance(end);
    let beside = chord / 2.0 / half.tan();
    if !beside.is_finite() || chord <= SAME {
        return None;
    }
    let turn = if half > 0.0 { Turn::Counterclockwise } else { Turn::Clockwise };
    // The centre is left of the chord for a counter-clockwise arc of less than a half circle.
    let (dx, dz) = ((end.x - start.x) / chord, (end.z - start.z) / chord);
    let middle = Point::new((start.x + end.x) / 2.0, (start.z + end.z) / 2.0);
    Some(Arc { start, end, center: Point::new(middle.x + beside * dz, middle.z - beside * dx), turn })
}

/// The minimum and maximum distance of corners and edge midpoints from the circle of an arc, mm; negative is
/// inside.
fn deviations(arc: &Arc, points: &[Point]) -> (f64, f64) {
    let radius = arc.radius();
    let middles = points
        .windows(2)
        .map(|edge| Point::new((edge[0].x + edge[1].x) / 2.0, (edge[0].z + edge[1].z) / 2.0));
    points
        .iter()
        .copied()
        .chain(middles)
        .map(|point| point.distance(arc.center) - radius)
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), deviation| {
            (least.min(deviation), most.max(deviation))
        })
}

/// The change of direction at the second of three points, radians, positive to the left.
fn turned(a: Point, b: Point, c: Point) -> f64 {
    let (before, after) = (from_to(a, b), from_to(b, c));
    f64::atan2(before.1 * after.0 - before.0 * after.1, before.0 * after.0 + before.1 * after.1)
}

fn distance_from_line(point: Point, from: Point, to: Point) -> f64 {
    let (way, own) = (from_to(from, to), from_to(from, point));
    (way.1 * own.0 - way.0 * own.1).abs() / from.distance(to).max(SAME)
}

/// The vector from one point to another: X, Z.
fn from_to(a: Point, b: Point) -> (f64, f64) {
    (b.x - a.x, b.z - a.z)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::machine::sweep::chords;

    fn chain(pieces: &[Segment]) -> Vec<Point> {
        let mut points: Vec<Point> = Vec::new();
        for piece in pieces {
            match piece {
                Segment::Line(a, b) => points.extend([*a, *b]),
                Segment::Arc(arc) => points.extend(chords(arc)),
            }
        }
        points.dedup_by(|a, b| a.is_same(*b));
        points.pop();
        points
    }

    fn at(x: f64, z: f64) -> Point {
        Point::new(x, z)
    }

    fn arc(start: Point, end: Point, center: Point, turn: Turn) -> Segment {
        Segment::Arc(Arc { start, end, center, turn })
    }

    /// A shaft with a round end, a groove with a round bottom, and a shoulder with a radius, all tangent on
    /// both sides.
    fn shaft() -> Vec<Segment> {
        vec![
            arc(at(0.0, 0.0), at(10.0, -10.0), at(0.0, -10.0), Turn::Counterclockwise),
            Segment::Line(at(10.0, -10.0), at(10.0, -20.0)),
            arc(at(10.0, -20.0), at(10.0, -26.0), at(10.0, -23.0), Turn::Clockwise),
            Segment::Line(at(10.0, -26.0), at(10.0, -35.0)),
            arc(at(10.0, -35.0), at(15.0, -40.0), at(15.0, -35.0), Turn::Clockwise),
            arc(at(15.0, -40.0), at(19.5, -44.5), at(15.0, -44.5), Turn::Counterclockwise),
            Segment::Line(at(19.5, -44.5), at(19.5, -60.0)),
            Segment::Line(at(19.5, -60.0), at(0.0, -60.0)),
            Segment::Line(at(0.0, -60.0), at(0.0, 0.0)),
        ]
    }

    #[test]
    fn arcs_come_back_as_they_were() {
        let wanted = shaft();
        let mut outline = chain(&wanted);
        for _ in 0..3 {
            // The result must not depend on where the outline begins.
            outline.rotate_left(17);
            let found = segments(&outline);
            assert_eq!(found.len(), wanted.len(), "{found:#?}");
            for wanted in &wanted {
                let same = |found: &&Segment| match (found, wanted) {
                    (Segment::Line(a, b), Segment::Line(c, d)) => a.is_same(*c) && b.is_same(*d),
                    (Segment::Arc(a), Segment::Arc(b)) => {
                        a.turn == b.turn
                            && a.start.is_same(b.start)
                            && a.end.is_same(b.end)
                            && a.center.distance(b.center) < 1e-4
                    }
                    _ => false,
                };
                assert!(found.iter().any(|one| same(&one)), "{wanted:?} in {found:#?}");
            }
        }
    }

    #[test]
    fn corners_are_no_arcs() {
        // The corners of an octagon lie on a circle, but its edges are not an arc.
        let octagon: Vec<Point> = (0..8)
            .map(|corner| {
                let (sin, cos) = (f64::from(corner) * PI / 4.0).sin_cos();
                at(10.0 + 4.0 * sin, 4.0 * cos)
            })
            .collect();
        let found = segments(&octagon);
        assert_eq!(found.len(), 8);
        assert!(found.iter().all(|segment| matches!(segment, Segment::Line(..))));
    }

    #[test]
    fn a_round_hole_is_arcs_only() {
        // Chords of the same length as in a tool path.
        let circle: Vec<Point> = (0..50)
            .map(|corner| {
                let (sin, cos) = (f64::from(corner) * PI / 25.0).sin_cos();
                at(20.0 + 2.0 * sin, 2.0 * cos)
            })
            .collect();
        let found = segments(&circle);
        assert!(found.len() <= 3, "{found:?}");
        for segment in found {
            let Segment::Arc(arc) = segment else { panic!("{segment:?}") };
            assert!((arc.radius() - 2.0).abs() < 1e-6 && arc.turn == Turn::Counterclockwise);
        }
    }

    #[test]
    fn corners_on_a_line_are_none() {
        let outline =
            [at(0.0, 0.0), at(5.0, 0.0), at(5.0, -3.0), at(5.0001, -6.0), at(5.0, -9.0), at(0.0, -9.0)];
        assert_eq!(segments(&outline).len(), 4);
    }
}
