//! The programmed elements and the nose that follows them.
//!
//! In: elements, side and nose as programmed. Out: directions, normals and lengths. Knows nothing of corners
//! or the order of elements.

use std::f64::consts::{PI, TAU};
use std::ops::{Add, Mul, Sub};

use crate::geometry::{Arc, Point, Turn};

/// The side of the path, seen in the direction of travel, on which the nose is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// G41.
    Left,
    /// G42.
    Right,
}

impl Side {
    /// The other side, as a negative nose radius requires.
    pub fn opposite(self) -> Self {
        match self {
            Self::Left => Self::Right,
            Self::Right => Self::Left,
        }
    }

    /// +1 to the left, −1 to the right.
    pub(super) fn sign(self) -> f64 {
        match self {
            Self::Left => 1.0,
            Self::Right => -1.0,
        }
    }
}

/// The rounded nose of a tool, from the offset table.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Nose {
    /// Nose radius, or cutter radius, mm; not negative.
    pub radius: f64,
    /// Tool-tip direction, 0 to 9; other numbers are treated as 0.
    pub tip: u8,
}

impl Nose {
    /// Vector from the imaginary tip to the centre of a nose of radius 1 (table of §4.1).
    pub fn vector(self) -> Vector {
        let (x, z) = match self.tip {
            1 => (-1.0, -1.0),
            2 => (-1.0, 1.0),
            3 => (1.0, 1.0),
            4 => (1.0, -1.0),
            5 => (0.0, -1.0),
            6 => (-1.0, 0.0),
            7 => (0.0, 1.0),
            8 => (1.0, 0.0),
            _ => (0.0, 0.0),
        };
        Vector { x, z }
    }

    /// Vector from the imaginary tip to the centre of this nose, mm.
    pub(super) fn offset(self) -> Vector {
        self.vector() * self.radius
    }
}

/// How an element is travelled.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Travel {
    /// G00.
    Rapid,
    /// G01, G02, G03.
    Feed,
}

/// The path between two points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shape {
    /// Straight.
    Line,
    /// Around a centre; a full circle if start and end are the same point.
    Arc {
        /// Centre.
        center: Point,
        /// Direction of rotation, with the first axis to the right and the second upwards.
        turn: Turn,
    },
}

/// A programmed move.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Element {
    /// The caller's number, which the resulting moves carry.
    pub id: u32,
    /// Rapid or feed.
    pub travel: Travel,
    /// Programmed start.
    pub from: Point,
    /// Programmed end.
    pub to: Point,
    /// Straight or round.
    pub shape: Shape,
}

impl Element {
    /// Whether it is straight and has no length.
    pub(super) fn is_still(&self) -> bool {
        self.shape == Shape::Line && self.from.is_same(self.to)
    }
}

/// A displacement in the plane, mm, or a direction of length 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Vector {
    /// Along the second axis (radius, when turning).
    pub x: f64,
    /// Along the first axis.
    pub z: f64,
}

/// No displacement.
pub(super) const ZERO: Vector = Vector { x: 0.0, z: 0.0 };

impl Vector {
    pub(super) fn between(start: Point, end: Point) -> Self {
        Self { x: end.x - start.x, z: end.z - start.z }
    }

    /// The point at this displacement from another one.
    pub(super) fn from(self, start: Point) -> Point {
        Point::new(start.x + self.x, start.z + self.z)
    }

    pub(super) fn length(self) -> f64 {
        self.x.hypot(self.z)
    }

    pub(super) fn dot(self, other: Self) -> f64 {
        self.z * other.z + self.x * other.x
    }

    /// Positive if `other` points to the left of this vector.
    pub(super) fn cross(self, other: Self) -> f64 {
        self.z * other.x - self.x * other.z
    }

    /// A quarter turn to the left.
    pub(super) fn left(self) -> Self {
        Self { x: self.z, z: -self.x }
    }

    fn unit(self) -> Self {
        self * (1.0 / self.length())
    }
}

impl Add for Vector {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self { x: self.x + other.x, z: self.z + other.z }
    }
}

impl Sub for Vector {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self { x: self.x - other.x, z: self.z - other.z }
    }
}

impl Mul<f64> for Vector {
    type Output = Self;
    fn mul(self, factor: f64) -> Self {
        Self { x: self.x * factor, z: self.z * factor }
    }
}

/// An element with the side on which the nose follows it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Track {
    pub(super) from: Point,
    pub(super) to: Point,
    pub(super) shape: Shape,
    pub(super) side: Side,
}

impl Track {
    pub(super) fn new(element: &Element, side: Side) -> Self {
        Self { from: element.from, to: element.to, shape: element.shape, side }
    }

    /// Direction of travel at the start, length 1.
    pub(super) fn start_direction(&self) -> Vector {
        self.direction(self.from)
    }

    /// Direction of travel at the end, length 1.
    pub(super) fn end_direction(&self) -> Vector {
        self.direction(self.to)
    }

    /// Unit vector from the programmed start towards the centre of the nose.
    pub(super) fn start_normal(&self) -> Vector {
        self.start_direction().left() * self.side.sign()
    }

    /// Unit vector from the programmed end towards the centre of the nose.
    pub(super) fn end_normal(&self) -> Vector {
        self.end_direction().left() * self.side.sign()
    }

    /// Radius of the path of the nose centre along an arc of radius `radius`, mm: `R ∓ r` (§4.1).
    pub(super) fn offset_radius(&self, radius: f64, nose: f64) -> f64 {
        match (self.shape, self.side) {
            (Shape::Line, _) => radius,
            (Shape::Arc { turn: Turn::Counterclockwise, .. }, Side::Left)
            | (Shape::Arc { turn: Turn::Clockwise, .. }, Side::Right) => radius - nose,
            (Shape::Arc { .. }, _) => radius + nose,
        }
    }

    /// Signed angle of the programmed arc, radians; 0 for a line.
    pub(super) fn sweep(&self) -> f64 {
        match self.shape {
            Shape::Line => 0.0,
            Shape::Arc { center, turn } => Arc { start: self.from, end: self.to, center, turn }.sweep(),
        }
    }

    /// Length, mm, of the path of the centre that begins at `begin`, relative to the programmed start, and
    /// ends at `end`, relative to the programmed end. Negative if it would run backwards.
    pub(super) fn length_between(&self, begin: Vector, end: Vector) -> f64 {
        let Shape::Arc { center, turn } = self.shape else {
            let direction = self.start_direction();
            return self.from.distance(self.to) + direction.dot(end - begin);
        };
        let advance = |programmed: Point, vector: Vector| {
            let angle = angle_between(
                Vector::between(center, programmed),
                Vector::between(center, vector.from(programmed)),
            );
            match turn {
                Turn::Counterclockwise => angle,
                Turn::Clockwise => -angle,
            }
        };
        let angle = self.sweep().abs() - advance(self.from, begin) + advance(self.to, end);
        angle * center.distance(end.from(self.to))
    }

    fn direction(&self, at: Point) -> Vector {
        match self.shape {
            Shape::Line => Vector::between(self.from, self.to).unit(),
            Shape::Arc { center, turn } => {
                let around = Vector::between(center, at).unit().left();
                match turn {
                    Turn::Counterclockwise => around,
                    Turn::Clockwise => around * -1.0,
                }
            }
        }
    }
}

/// Angle from one vector to another, radians, counter-clockwise, above −π and up to π.
pub(super) fn angle_between(one: Vector, other: Vector) -> f64 {
    let angle = other.x.atan2(other.z) - one.x.atan2(one.z);
    if angle > PI {
        angle - TAU
    } else if angle <= -PI {
        angle + TAU
    } else {
        angle
    }
}
