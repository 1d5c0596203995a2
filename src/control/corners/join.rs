//! The chamfer or arc between two moves, straight or round, at any angle (§3.2.1).
//!
//! Both moves are seen from the corner, as two arms that lead away from it; the first one backwards.
//! Distances are measured outwards on both arms, so the same rules apply to both.

use super::{ANGLE_ALLOWANCE, Corner, CornerError, Joined, Side};
use crate::cycles::Piece;
use crate::geometry::{Arc, Point, SAME, Turn};

/// A remaining move up to this length, mm, counts as empty: its ends count as the same point, and an arc
/// between them would be read as a full circle.
const USED_UP: f64 = 2.0 * SAME;

/// Shortens two moves that meet at `first.to` and joins them by a chamfer or an arc.
///
/// Between lines the arc begins and ends `r · tan(φ/2)` from the corner; φ is the turn. On an arc the
/// distance of a chamfer is the chord from the corner (NCT 2000M, p. 119).
pub fn join(first: &Piece, second: &Piece, corner: Corner) -> Result<Joined, CornerError> {
    let value = match corner {
        Corner::Chamfer(value) | Corner::Round(value) => value,
    };
    if value < -SAME {
        return Err(CornerError::Negative { value });
    }
    let untouched = Joined { first: *first, inserted: None, second: *second };
    if value.is_nan() || value <= SAME {
        return Ok(untouched);
    }
    let arms = [Arm::new(first, Side::First), Arm::new(second, Side::Second)];
    for arm in &arms {
        if arm.length <= SAME {
            return Err(CornerError::TooLong { side: arm.side, needed: value, available: 0.0 });
        }
    }
    let (before, after) = (arms[0].direction().scaled(-1.0), arms[1].direction());
    let turn = before.cross(after).atan2(before.dot(after));
    if turn.abs() < ANGLE_ALLOWANCE || turn.abs() > std::f64::consts::PI - ANGLE_ALLOWANCE {
        return Err(CornerError::NoCorner { turn });
    }
    let (cuts, arc) = match corner {
        Corner::Chamfer(distance) => ([arms[0].chamfer(distance)?, arms[1].chamfer(distance)?], None),
        Corner::Round(radius) => {
            let (center, cuts) = round(&arms, radius, turn)?;
            for (arm, needed) in arms.iter().zip(cuts) {
                if needed > arm.length + SAME {
                    return Err(CornerError::TooLong { side: arm.side, needed, available: arm.length });
                }
            }
            let way = if turn > 0.0 { Turn::Counterclockwise } else { Turn::Clockwise };
            (cuts, Some((center, way)))
        }
    };
    let (from, to) = (arms[0].at(cuts[0]), arms[1].at(cuts[1]));
    if from.is_same(to) {
        return Ok(untouched);
    }
    Ok(Joined {
        first: rest(Piece { to: from, ..*first }, arms[0].length - cuts[0]),
        inserted: Some(Piece { from, to, arc }),
        second: rest(Piece { from: to, ..*second }, arms[1].length - cuts[1]),
    })
}

/// The centre of the arc that touches both arms, and the distances along them to the touching points.
///
/// The centre is `radius` to the inside of both. If there are several, the nearest to the corner is used: it
/// moves into the corner as the radius shrinks.
fn round(arms: &[Arm; 2], radius: f64, turn: f64) -> Result<(Point, [f64; 2]), CornerError> {
    let left = radius.copysign(turn);
    // The first arm leads backwards, so its left is the other side.
    let lines = arms[0].beside(-left).zip(arms[1].beside(left));
    let (one, other) = lines.ok_or(CornerError::NoFit { radius })?;
    crossings(&one, &other)
        .into_iter()
        .flatten()
        .map(|center| (center, [arms[0].touch(center), arms[1].touch(center)]))
        .filter(|(_, cuts)| cuts.iter().all(|cut| *cut >= 0.0))
        .min_by(|(_, a), (_, b)| (a[0] + a[1]).total_cmp(&(b[0] + b[1])))
        .ok_or(CornerError::NoFit { radius })
}

/// The remaining part of a move, `length` mm long.
fn rest(piece: Piece, length: f64) -> Piece {
    if length > USED_UP { piece } else { Piece { to: piece.from, arc: None, ..piece } }
}

/// A move seen from the corner.
struct Arm {
    side: Side,
    corner: Point,
    /// The other end.
    far: Point,
    /// Along the move, mm.
    length: f64,
    form: Form,
}

/// A line or a circle, with a direction.
enum Form {
    /// Through a point in a direction, a unit vector.
    Line { through: Point, direction: Vector },
    /// `spin` is 1 counter-clockwise, -1 clockwise.
    Circle { center: Point, radius: f64, spin: f64 },
}

impl Arm {
    fn new(piece: &Piece, side: Side) -> Self {
        let (corner, far, sense) = match side {
            Side::First => (piece.to, piece.from, -1.0),
            Side::Second => (piece.from, piece.to, 1.0),
        };
        let straight = corner.distance(far);
        let Some((center, turn)) = piece.arc else {
            let direction = Vector::between(corner, far).scaled(1.0 / straight);
            return Self {
                side,
                corner,
                far,
                length: straight,
                form: Form::Line { through: corner, direction },
            };
        };
        let spin = match turn {
            Turn::Counterclockwise => sense,
            Turn::Clockwise => -sense,
        };
        // An end slightly off the circle is allowed: the circle through the corner is used.
        let radius = center.distance(corner);
        let sweep = Arc { start: piece.from, end: piece.to, center, turn }.sweep().abs();
        Self { side, corner, far, length: sweep * radius, form: Form::Circle { center, radius, spin } }
    }

    /// The direction in which the arm leaves the corner.
    fn direction(&self) -> Vector {
        match self.form {
            Form::Line { direction, .. } => direction,
            Form::Circle { center, radius, spin } => {
                Vector::between(center, self.corner).left().scaled(spin / radius)
            }
        }
    }

    /// The point at a distance along the arm from the corner; the far end if the distance nearly reaches it.
    fn at(&self, distance: f64) -> Point {
        if self.length - distance <= USED_UP {
            return self.far;
        }
        match self.form {
            Form::Line { through, direction } => direction.scaled(distance).added_to(through),
            Form::Circle { center, radius, spin } => {
                Vector::between(center, self.corner).turned(spin * distance / radius).added_to(center)
            }
        }
    }

    /// The distance along the arm to the point at the straight distance `straight` from the corner.
    fn chamfer(&self, straight: f64) -> Result<f64, CornerError> {
        let available = match self.form {
            Form::Line { .. } => self.length,
            Form::Circle { radius, .. } => chord(radius, self.length),
        };
        if straight > available + SAME {
            return Err(CornerError::TooLong { side: self.side, needed: straight, available });
        }
        Ok(match self.form {
            Form::Line { .. } => straight.min(self.length),
            Form::Circle { radius, .. } => 2.0 * radius * (straight / (2.0 * radius)).min(1.0).asin(),
        })
    }

    /// The line or circle offset to the left, or to the right if negative; `None` if the arc is too small.
    fn beside(&self, left: f64) -> Option<Form> {
        match self.form {
            Form::Line { through, direction } => {
                Some(Form::Line { through: direction.left().scaled(left).added_to(through), direction })
            }
            Form::Circle { center, radius, spin } => {
                let radius = radius - spin * left;
                (radius > SAME).then_some(Form::Circle { center, radius, spin })
            }
        }
    }

    /// Distance along the arm to the point where a circle around `center` touches it; negative before the
    /// corner, on a line.
    fn touch(&self, center: Point) -> f64 {
        match self.form {
            Form::Line { through, direction } => Vector::between(through, center).dot(direction),
            Form::Circle { center: own, radius, spin } => {
                let (start, end) = (Vector::between(own, self.corner), Vector::between(own, center));
                let angle = start.cross(end).atan2(start.dot(end));
                (spin * angle).rem_euclid(std::f64::consts::TAU) * radius
            }
        }
    }
}

/// The largest straight distance from the start of an arc `length` mm long.
fn chord(radius: f64, length: f64) -> f64 {
    let half = (length / radius / 2.0).min(std::f64::consts::FRAC_PI_2);
    2.0 * radius * half.sin()
}

/// Intersections of two lines or circles.
fn crossings(one: &Form, other: &Form) -> [Option<Point>; 2] {
    match (one, other) {
        (
            Form::Line { through, direction },
            Form::Line { through: other_through, direction: other_direction },
        ) => {
            let slope = direction.cross(*other_direction);
            let along = Vector::between(*through, *other_through).cross(*other_direction) / slope;
            [(slope != 0.0).then(|| direction.scaled(along).added_to(*through)), None]
        }
        (Form::Line { through, direction }, Form::Circle { center, radius, .. })
        | (Form::Circle { center, radius, .. }, Form::Line { through, direction }) => {
            let foot =
                direction.scaled(Vector::between(*through, *center).dot(*direction)).added_to(*through);
            beside_foot(foot, *direction, radius * radius - Vector::between(foot, *center).square())
        }
        (
            Form::Circle { center, radius, .. },
            Form::Circle { center: other_center, radius: other_radius, .. },
        ) => {
            let apart = Vector::between(*center, *other_center);
            let distance = apart.square().sqrt();
            if distance <= SAME {
                return [None, None];
            }
            let direction = apart.scaled(1.0 / distance);
            let to_foot = (distance + (radius - other_radius) * (radius + other_radius) / distance) / 2.0;
            let foot = direction.scaled(to_foot).added_to(*center);
            beside_foot(foot, direction.left(), (radius - to_foot) * (radius + to_foot))
        }
    }
}

/// The two points on either side of the foot of a perpendicular, from the square of their distance to it.
fn beside_foot(foot: Point, direction: Vector, square: f64) -> [Option<Point>; 2] {
    // Keeps an arc that just fits despite rounding errors.
    if square.is_nan() || square < -SAME * SAME {
        return [None, None];
    }
    let half = square.max(0.0).sqrt();
    [Some(direction.scaled(half).added_to(foot)), Some(direction.scaled(-half).added_to(foot))]
}

/// A displacement in the plane of the lathe, mm, or a direction.
#[derive(Clone, Copy)]
struct Vector {
    x: f64,
    z: f64,
}

impl Vector {
    fn between(from: Point, to: Point) -> Self {
        Self { x: to.x - from.x, z: to.z - from.z }
    }

    fn added_to(self, start: Point) -> Point {
        Point::new(start.x + self.x, start.z + self.z)
    }

    fn scaled(self, by: f64) -> Self {
        Self { x: self.x * by, z: self.z * by }
    }

    /// A quarter turn counter-clockwise.
    fn left(self) -> Self {
        Self { x: self.z, z: -self.x }
    }

    /// Turned by an angle, radians, counter-clockwise.
    fn turned(self, angle: f64) -> Self {
        let (sin, cos) = angle.sin_cos();
        Self { x: self.z * sin + self.x * cos, z: self.z * cos - self.x * sin }
    }

    fn dot(self, other: Self) -> f64 {
        self.x * other.x + self.z * other.z
    }

    /// Positive if `other` is to the left of this vector.
    fn cross(self, other: Self) -> f64 {
        self.z * other.x - self.x * other.z
    }

    fn square(self) -> f64 {
        self.dot(self)
    }
}
