//! Where the centre of the nose goes at the corner between two elements (FANUC 16/18-T B-62754EN p. 225).
//!
//! In: the two elements, the end of the first being the start of the second, and the radius. Out: vectors
//! from the corner to the centre. Knows nothing of tips.

use std::f64::consts::{FRAC_PI_4, PI};

use super::path::{Shape, Track, Vector, ZERO, angle_between};
use crate::geometry::{Point, SAME};

/// The centre at a corner: vectors from the programmed corner, mm, joined by
/// straight moves where they differ.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Corner {
    /// Where the first element ends.
    pub(super) end: Vector,
    /// Two places on the way around.
    pub(super) around: [Vector; 2],
    /// Where the second element begins.
    pub(super) begin: Vector,
}

/// Sine of the largest turn that counts as none: radians.
const STRAIGHT: f64 = 1e-6;
/// An arc that turns through more, radians, is not lengthened at an outer corner: it could run into itself.
const LONGEST_LENGTHENED: f64 = 1.5 * PI;
/// An arc is lengthened by this angle at most, radians.
const MOST_LENGTHENING: f64 = FRAC_PI_4;

/// The corner between two elements, or `None` when their offset paths do not meet.
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
        // More than 90° around the outside: on by the radius, across, and up to the
        // second from as far before it.
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
        .meetings(beginning)
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

/// Around the outside through two points on the tangents: lines are lengthened to them, arcs keep their ends,
/// where the centre is perpendicular to the corner.
fn around(first: Track, second: Track, points: [Vector; 2], perpendicular: [Vector; 2]) -> Corner {
    let keeps = |track: Track, index: usize| match track.shape {
        Shape::Line => points[index],
        Shape::Arc { .. } => perpendicular[index],
    };
    Corner { end: keeps(first, 0), around: points, begin: keeps(second, 1) }
}

/// The sides differ: the nose crosses the path. Two lines at a right angle or sharper cross where their
/// offset paths meet; otherwise the first ends and the second begins perpendicular to the corner.
fn crossing(first: Track, second: Track, radius: f64) -> Corner {
    let (n1, n2) = (first.end_normal(), second.start_normal());
    let both_lines = first.shape == Shape::Line && second.shape == Shape::Line;
    if both_lines && n1.dot(n2) > -SAME {
        return Corner::at((n1 + n2) * (radius / (1.0 + n1.dot(n2))));
    }
    let (end, begin) = (n1 * radius, n2 * radius);
    Corner { end, around: [end, begin], begin }
}

/// The offset path of an element without its ends; all vectors from the programmed corner.
#[derive(Clone, Copy, Debug)]
enum Curve {
    Line {
        through: Vector,
        direction: Vector,
    },
    Circle {
        center: Vector,
        radius: f64,
        /// How far the programmed arc turns, radians.
        sweep: f64,
    },
}

impl Curve {
    /// The offset path of an element that passes `through` in `direction` at `corner`. An arc whose ends
    /// differ in radius counts as the circle through the end that meets the corner.
    fn of(track: Track, corner: Point, through: Vector, direction: Vector) -> Self {
        match track.shape {
            Shape::Line => Self::Line { through, direction },
            Shape::Arc { center, .. } => {
                let center = Vector::between(corner, center);
                Self::Circle { center, radius: (through - center).length(), sweep: track.sweep().abs() }
            }
        }
    }

    /// Whether the element may go on from where it is perpendicular to the corner to
    /// another place of the curve.
    fn may_lengthen(self, perpendicular: Vector, to: Vector) -> bool {
        match self {
            Self::Line { .. } => true,
            Self::Circle { center, sweep, .. } => {
                let angle = angle_between(perpendicular - center, to - center).abs();
                sweep <= LONGEST_LENGTHENED && angle <= MOST_LENGTHENING
            }
        }
    }

    /// Where two curves meet. Curves that miss each other by less than [`SAME`] touch.
    fn meetings(self, other: Self) -> [Option<Vector>; 2] {
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
                // Where the line through both meetings crosses the line of centres.
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
