//! Path of the nose centre at the corner between two elements (FANUC 16/18-T B-62754EN p. 225).
//!
//! In: the two elements, which share the corner, and the radius. Out: vectors from the corner to the centre.
//! Knows nothing of tips.

use std::f64::consts::{FRAC_PI_4, PI};

use super::path::{Shape, Track, Vector, ZERO, angle_between};
use crate::geometry::{Point, SAME};

/// The centre at a corner: vectors from the programmed corner, mm, joined by straight moves if they differ.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Corner {
    /// End of the first element.
    pub(super) end: Vector,
    /// Two points on the path around the corner.
    pub(super) around: [Vector; 2],
    /// Start of the second element.
    pub(super) begin: Vector,
}

/// Sine of the largest turn that counts as straight.
const STRAIGHT: f64 = 1e-6;
/// An arc of a larger angle, radians, is not lengthened at an outer corner, because it could intersect
/// itself.
const MAX_LENGTHENED: f64 = 1.5 * PI;
/// Maximum angle by which an arc is lengthened, radians.
const MAX_LENGTHENING: f64 = FRAC_PI_4;

/// The corner between two elements, or `None` if their offset paths do not meet.
pub(super) fn corner(first: Track, second: Track, radius: f64) -> Option<Corner> {
    if radius == 0.0 {
        return Some(Corner::at(ZERO));
    }
    let (t1, t2) = (first.end_direction(), second.start_direction());
    let (n1, n2) = (first.end_normal() * radius, second.start_normal() * radius);
    if first.side != second.side {
        return Some(crossing(first, second, radius));
    }
    let (cross, dot) = (t1.cross(t2), t1.dot(t2));
    let straight = cross.abs() <= STRAIGHT;
    if straight && dot > 0.0 {
        return Some(Corner::at(n1));
    }
    let outer = straight || first.side.sign() * cross < 0.0;
    if outer && dot < -SAME {
        // More than 90° around the outside: first extended by the radius, then across, then to the start of
        // the second, which is extended backwards by as much.
        return Some(around(first, second, [n1 + t1 * radius, n2 - t2 * radius], [n1, n2]));
    }
    let tangents_meet = (n1 + n2) * (1.0 / (1.0 + n1.dot(n2) / (radius * radius)));
    if first.shape == Shape::Line && second.shape == Shape::Line {
        return Some(Corner::at(tangents_meet));
    }
    let (ending, beginning) = (Curve::of(first, first.to, n1, t1), Curve::of(second, second.from, n2, t2));
    let ahead = |meeting: &Vector| match outer {
        true => {
            t1.dot(*meeting) >= -SAME
                && t2.dot(*meeting) <= SAME
                && ending.may_lengthen(n1, *meeting)
                && beginning.may_lengthen(n2, *meeting)
        }
        false => t1.dot(*meeting) <= SAME && t2.dot(*meeting) >= -SAME,
    };
    let nearest = ending
        .intersections(beginning)
        .into_iter()
        .flatten()
        .filter(ahead)
        .min_by(|one, other| one.length().total_cmp(&other.length()));
    match nearest {
        Some(meeting) => Some(Corner::at(meeting)),
        None if outer => Some(around(first, second, [tangents_meet; 2], [n1, n2])),
        None => None,
    }
}

impl Corner {
    fn at(vector: Vector) -> Self {
        Self { end: vector, around: [vector; 2], begin: vector }
    }
}

/// Around the outside through two points on the tangents: lines are lengthened to them; arcs keep their ends,
/// where the centre is perpendicular to the corner.
fn around(first: Track, second: Track, points: [Vector; 2], perpendicular: [Vector; 2]) -> Corner {
    let keeps = |track: Track, index: usize| match track.shape {
        Shape::Line => points[index],
        Shape::Arc { .. } => perpendicular[index],
    };
    Corner { end: keeps(first, 0), around: points, begin: keeps(second, 1) }
}

/// The side changes, so the nose crosses the path. Two lines at an angle of 90° or less cross where their
/// offset paths meet; otherwise the first element ends and the second begins perpendicular to the corner.
fn crossing(first: Track, second: Track, radius: f64) -> Corner {
    let (n1, n2) = (first.end_normal(), second.start_normal());
    let both_lines = first.shape == Shape::Line && second.shape == Shape::Line;
    if both_lines && n1.dot(n2) > -SAME {
        return Corner::at((n1 + n2) * (radius / (1.0 + n1.dot(n2))));
    }
    let (end, begin) = (n1 * radius, n2 * radius);
    Corner { end, around: [end, begin], begin }
}

/// The offset path of an element, without its ends; all vectors are relative to the programmed corner.
#[derive(Clone, Copy, Debug)]
enum Curve {
    Line {
        through: Vector,
        direction: Vector,
    },
    Circle {
        center: Vector,
        radius: f64,
        /// Angle of the programmed arc, radians.
        sweep: f64,
    },
}

impl Curve {
    /// The offset path of an element that passes `through` in `direction` at `corner`. An arc whose ends
    /// differ in radius is treated as the circle through the end at the corner.
    fn of(track: Track, corner: Point, through: Vector, direction: Vector) -> Self {
        match track.shape {
            Shape::Line => Self::Line { through, direction },
            Shape::Arc { center, .. } => {
                let center = Vector::between(corner, center);
                Self::Circle { center, radius: (through - center).length(), sweep: track.sweep().abs() }
            }
        }
    }

    /// Whether the element may be lengthened from the point where it is perpendicular to the corner to
    /// another point of the curve.
    fn may_lengthen(self, perpendicular: Vector, to: Vector) -> bool {
        match self {
            Self::Line { .. } => true,
            Self::Circle { center, sweep, .. } => {
                let angle = angle_between(perpendicular - center, to - center).abs();
                sweep <= MAX_LENGTHENED && angle <= MAX_LENGTHENING
            }
        }
    }

    /// Intersections of two curves. Curves that miss each other by less than [`SAME`] touch.
    fn intersections(self, other: Self) -> [Option<Vector>; 2] {
        match (self, other) {
            (Self::Line { through, direction }, Self::Circle { center, radius, .. })
            | (Self::Circle { center, radius, .. }, Self::Line { through, direction }) => {
                let foot = through + direction * direction.dot(center - through);
                either_side(foot, direction, radius, (foot - center).length())
            }
            (
                Self::Circle { center, radius, .. },
                Self::Circle { center: other_center, radius: other_radius, .. },
            ) => {
                let between = other_center - center;
                let distance = between.length();
                let too_far = distance > radius + other_radius + SAME;
                let one_inside = distance < (radius - other_radius).abs() - SAME;
                if too_far || one_inside || distance == 0.0 {
                    return [None; 2];
                }
                let along = between * (1.0 / distance);
                // Intersection of the line through both points with the line of centres.
                let squares = (radius - other_radius) * (radius + other_radius);
                let reach = ((distance + squares / distance) / 2.0).max(-radius).min(radius);
                either_side(center + along * reach, along.left(), radius, reach.abs())
            }
            (Self::Line { .. }, Self::Line { .. }) => [None; 2],
        }
    }
}

/// The two ends of a chord through `foot`, its middle, at `distance` from the centre of a circle.
fn either_side(foot: Vector, direction: Vector, radius: f64, distance: f64) -> [Option<Vector>; 2] {
    if distance > radius + SAME {
        return [None; 2];
    }
    let half = direction * ((radius - distance) * (radius + distance)).max(0.0).sqrt();
    [Some(foot + half), Some(foot - half)]
}
