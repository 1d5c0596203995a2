//! Points, arcs and the named tolerances of the whole project.
//!
//! Everything is in millimetres in the plane of the lathe: `z` along the spindle, to the right; `x` the
//! **radius** from the spindle axis, upwards. In this view a counter-clockwise turn is to the left.

pub mod bounds;
pub mod virtual_plane;

/// Lengths that differ by at most this, mm, are equal: otherwise binary rounding would decide.
pub const SAME: f64 = 1e-6;

/// The share of a line at the foot of the perpendicular from a point: 0 at its start, 1 at its end, less or more
/// beyond them; 0 for a line without length.
pub fn share_along([from, to]: [Point; 2], at: Point) -> f64 {
    let (x, z) = (to.x - from.x, to.z - from.z);
    let square = x * x + z * z;
    if square > 0.0 { ((at.x - from.x) * x + (at.z - from.z) * z) / square } else { 0.0 }
}

/// The point at a share of a line.
pub fn at_share([from, to]: [Point; 2], share: f64) -> Point {
    Point::new(from.x + share * (to.x - from.x), from.z + share * (to.z - from.z))
}

/// The point of a line nearest to another point.
pub fn nearest_on(ends: [Point; 2], at: Point) -> Point {
    at_share(ends, within(share_along(ends, at), 0.0, 1.0))
}

/// Limits a value to `low` to `high`. Unlike `clamp` it cannot panic, which would add the number formatting
/// of the standard library to the page's module.
pub fn within(value: f64, low: f64, high: f64) -> f64 {
    if value < low {
        low
    } else if value > high {
        high
    } else {
        value
    }
}

/// A point in the plane of the lathe.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Point {
    /// Radius from the spindle axis, mm; negative beyond the axis.
    pub x: f64,
    /// Position along the spindle axis, mm; positive towards the tailstock.
    pub z: f64,
}

impl Point {
    /// The point at radius `x` and position `z`, both in mm.
    pub fn new(x: f64, z: f64) -> Self {
        Self { x, z }
    }

    /// The point displaced by a radius and a length, mm.
    pub fn moved(self, by: Point) -> Self {
        Self { x: self.x + by.x, z: self.z + by.z }
    }

    /// The opposite displacement: reverses [`Point::moved`].
    pub fn opposite(self) -> Self {
        Self { x: -self.x, z: -self.z }
    }

    /// Distance to another point, mm.
    pub fn distance(self, other: Point) -> f64 {
        (self.x - other.x).hypot(self.z - other.z)
    }

    /// Whether both points are equal within [`SAME`].
    pub fn is_same(self, other: Point) -> bool {
        (self.x - other.x).abs() <= SAME && (self.z - other.z).abs() <= SAME
    }
}

/// The least and the greatest of values; `None` without values.
pub fn extent(values: impl Iterator<Item = f64>) -> Option<[f64; 2]> {
    values.map(|value| [value; 2]).reduce(|[least, most], [value, _]| [least.min(value), most.max(value)])
}

/// The remainder of a value divided by a positive period, from 0 to the period. Unlike `rem_euclid` it does
/// not add `fmod` to the core of the module.
pub fn wrapped(value: f64, period: f64) -> f64 {
    if (0.0..period).contains(&value) { value } else { value - (value / period).floor() * period }
}

/// Direction of an arc, seen with Z to the right and X up.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Turn {
    /// G02.
    Clockwise,
    /// G03.
    Counterclockwise,
}

impl Turn {
    /// The opposite direction.
    pub fn opposite(self) -> Self {
        match self {
            Self::Clockwise => Self::Counterclockwise,
            Self::Counterclockwise => Self::Clockwise,
        }
    }
}

/// An exact arc between two points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Arc {
    /// Start point.
    pub start: Point,
    /// End point; equal to `start` for a full circle.
    pub end: Point,
    /// Centre.
    pub center: Point,
    /// Direction.
    pub turn: Turn,
}

impl Arc {
    /// Distance from the centre to the start, mm.
    pub fn radius(&self) -> f64 {
        self.start.distance(self.center)
    }

    /// Angle of the start point about the centre, radians, counter-clockwise from +Z.
    pub fn start_angle(&self) -> f64 {
        (self.start.x - self.center.x).atan2(self.start.z - self.center.z)
    }

    /// Angle of the end point about the centre, radians, counter-clockwise from +Z.
    pub fn end_angle(&self) -> f64 {
        (self.end.x - self.center.x).atan2(self.end.z - self.center.z)
    }

    /// Signed angle from start to end, radians: positive counter-clockwise, `±2π` for a full circle.
    pub fn sweep(&self) -> f64 {
        let full = std::f64::consts::TAU;
        if self.start.is_same(self.end) {
            return if self.turn == Turn::Counterclockwise { full } else { -full };
        }
        let angle = wrapped(self.end_angle() - self.start_angle(), full);
        match self.turn {
            Turn::Counterclockwise => angle,
            Turn::Clockwise => angle - full,
        }
    }

    /// Length along the arc, mm.
    pub fn length(&self) -> f64 {
        self.sweep().abs() * self.radius()
    }

    /// The point at a fraction `t` (0 start, 1 end) of the arc. The radius is interpolated from start to end,
    /// so that an end slightly off the circle is reached.
    pub fn at(&self, t: f64) -> Point {
        let radius = self.radius() + t * (self.end.distance(self.center) - self.radius());
        let angle = self.start_angle() + t * self.sweep();
        Point::new(self.center.x + radius * angle.sin(), self.center.z + radius * angle.cos())
    }
}
