//! Polar (G12.1) and cylindrical (G07.1) interpolation, and the planes of a machine with a Y axis: transforms
//! between the plane of the program and the axes of the machine.
//!
//! In: points of the plane. Out: radius, Y and Z of the tool, and the angle of C. In the plane `z` is the
//! first axis, to the right, and `x` the second, upwards, both in mm: X as a radius and C for the end face
//! (seen from the tailstock), Z and the unrolled circumference for the cylinder, two of X, Y and Z for
//! [`Flat`]. Must not know words and blocks.

use super::{Arc, Point, SAME, wrapped};

/// A virtual plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Surface {
    /// The end face: G12.1.
    Face,
    /// A cylinder about the spindle axis: G07.1.
    Cylinder {
        /// Radius by which angles are unrolled, mm.
        radius: f64,
        /// Whether it is seen from inside, so that G02 turns the other way: under G19, whose first axis is C.
        turned: bool,
    },
    /// Two of the linear axes, on a machine with a Y axis.
    Flat(Flat),
}

/// The planes of X, Y and Z, seen from the positive side of the third axis (seed 002, figure 5-5).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Flat {
    /// G17: X to the right, Y up.
    Xy,
    /// G18: Z to the right, X up.
    Zx,
    /// G19: Y to the right, Z up.
    Yz,
}

/// A position of the tool on a machine with a Y axis, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Space {
    /// X, as a radius.
    pub x: f64,
    /// Y.
    pub y: f64,
    /// Z.
    pub z: f64,
}

impl Flat {
    /// The point in the plane of a position, and its coordinate on the third axis.
    pub fn enter(self, at: Space) -> (Point, f64) {
        match self {
            Self::Xy => (Point::new(at.y, at.x), at.z),
            Self::Zx => (Point::new(at.x, at.z), at.y),
            Self::Yz => (Point::new(at.z, at.y), at.x),
        }
    }

    /// The position of a point in the plane.
    pub fn space(self, plane: Point, third: f64) -> Space {
        match self {
            Self::Xy => Space { x: plane.z, y: plane.x, z: third },
            Self::Zx => Space { x: plane.x, y: third, z: plane.z },
            Self::Yz => Space { x: third, y: plane.z, z: plane.x },
        }
    }
}

/// Most pieces of a drawn curve.
const MAX_PIECES: u32 = 1024;

/// The path of a move in the plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Way {
    /// A line.
    Line(Point, Point),
    /// An arc.
    Arc(Arc),
}

impl Way {
    /// The point at a fraction `t` of the path.
    pub fn at(&self, t: f64) -> Point {
        match self {
            Self::Line(from, to) => Point::new(from.x + t * (to.x - from.x), from.z + t * (to.z - from.z)),
            Self::Arc(arc) => arc.at(t),
        }
    }

    /// The path displaced in the plane.
    pub fn moved(self, by: Point) -> Self {
        match self {
            Self::Line(from, to) => Self::Line(from.moved(by), to.moved(by)),
            Self::Arc(arc) => Self::Arc(Arc {
                start: arc.start.moved(by),
                end: arc.end.moved(by),
                center: arc.center.moved(by),
                ..arc
            }),
        }
    }

    /// Least distance of the path from the origin of the plane, mm.
    pub fn distance_from_center(&self) -> f64 {
        let origin = Point::default();
        match *self {
            Self::Line(from, to) => {
                let (dx, dz) = (to.x - from.x, to.z - from.z);
                let square = dx * dx + dz * dz;
                let t = if square > 0.0 { -(from.x * dx + from.z * dz) / square } else { 0.0 };
                self.at(super::within(t, 0.0, 1.0)).distance(origin)
            }
            Self::Arc(arc) => {
                let ends = arc.start.distance(origin).min(arc.end.distance(origin));
                // The point of the circle nearest to the origin lies on the ray from its centre through the
                // origin.
                let toward = (-arc.center.x).atan2(-arc.center.z) - arc.start_angle();
                let turned = if arc.sweep() < 0.0 { -toward } else { toward };
                if wrapped(turned, std::f64::consts::TAU) <= arc.sweep().abs() {
                    (arc.center.distance(origin) - arc.radius()).abs().min(ends)
                } else {
                    ends
                }
            }
        }
    }

    /// Angle about the origin from the start to the end of the path, radians, counter-clockwise. A whole
    /// circle about the origin gives a full turn.
    fn angle_about_center(&self) -> f64 {
        let (from, to) = (self.at(0.0), self.at(1.0));
        let (cross, dot) = (from.z * to.x - from.x * to.z, from.z * to.z + from.x * to.x);
        let straight = cross.atan2(dot);
        match self {
            Self::Arc(arc) if arc.center.distance(Point::default()) < arc.radius() - SAME => {
                // The origin lies within the circle: the path turns about it as about its centre.
                let sweep = arc.sweep();
                let full = std::f64::consts::TAU;
                match (sweep.abs() >= full - 1e-12, sweep > 0.0) {
                    (true, _) => sweep,
                    (false, true) => wrapped(straight, full),
                    (false, false) => -wrapped(-straight, full),
                }
            }
            // If the origin is outside, neither a line nor a circle covers half a turn.
            _ => straight,
        }
    }
}

impl Surface {
    /// The point in the plane of a tool with Y at `y` mm and C at `c` degrees, and its coordinate on the
    /// third axis. On the face the second axis counts from there, whatever the angle of C is (FANUC 15i
    /// B-63324EN p. 80).
    pub fn enter(self, at: Point, y: f64, c: f64) -> (Point, f64) {
        match self {
            Self::Face => (Point::new(0.0, at.x), at.z),
            Self::Cylinder { radius, .. } => (Point::new(radius * c.to_radians(), at.z), at.x),
            Self::Flat(flat) => flat.enter(Space { x: at.x, y, z: at.z }),
        }
    }

    /// The position of the tool in the machine: radius and Z, mm. `third` is the coordinate on the axis that
    /// is not in the plane, mm: Z on the face, X as a radius on the cylinder. Y is ignored.
    pub fn machine(self, plane: Point, third: f64) -> Point {
        match self {
            Self::Face => Point::new(plane.x.hypot(plane.z), third),
            Self::Cylinder { .. } => Point::new(third, plane.z),
            Self::Flat(flat) => {
                let at = flat.space(plane, third);
                Point::new(at.x, at.z)
            }
        }
    }

    /// The turn of C along a path, degrees. On the face the angle is tracked from point to point, so that a
    /// path around the centre turns C around as well. With a Y axis C does not move.
    pub fn turn_along(self, way: &Way) -> f64 {
        match self {
            Self::Cylinder { radius, .. } => {
                let (from, to) = (way.at(0.0), way.at(1.0));
                ((to.x - from.x) / radius).to_degrees()
            }
            Self::Face => way.angle_about_center().to_degrees(),
            Self::Flat(_) => 0.0,
        }
    }
}

/// A move in a virtual plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VirtualMove {
    /// The plane.
    pub surface: Surface,
    /// The path in the plane.
    pub way: Way,
    /// Start and end on the third axis, mm.
    pub third: (f64, f64),
}

impl VirtualMove {
    /// The position in the machine at a fraction `t` (0 start, 1 end) of the path.
    pub fn at(&self, t: f64) -> Point {
        self.surface.machine(self.way.at(t), self.third.0 + t * (self.third.1 - self.third.0))
    }

    /// The move displaced by a radius and a length, mm.
    pub fn moved(&self, by: Point) -> Self {
        let (plane, third) = self.surface.enter(by, 0.0, 0.0);
        Self { way: self.way.moved(plane), third: (self.third.0 + third, self.third.1 + third), ..*self }
    }

    /// Whether it is a move of a machine with a Y axis.
    pub fn has_y(&self) -> bool {
        matches!(self.surface, Surface::Flat(_))
    }

    /// Y at a fraction `t` of the path, mm; 0 if no Y axis moves.
    pub fn y_at(&self, t: f64) -> f64 {
        let Surface::Flat(flat) = self.surface else { return 0.0 };
        flat.space(self.way.at(t), self.third.0 + t * (self.third.1 - self.third.0)).y
    }

    /// The same move over the end face, if it can be projected there: an arc in another plane cannot.
    pub fn over_face(&self) -> Option<Self> {
        let (way, third) = match (self.surface, self.way) {
            (Surface::Face | Surface::Flat(Flat::Xy), way) => (way, self.third),
            (Surface::Flat(flat), Way::Line(from, to)) => {
                let ends = [flat.space(from, self.third.0), flat.space(to, self.third.1)];
                let [(from, from_z), (to, to_z)] = ends.map(|end| Flat::Xy.enter(end));
                (Way::Line(from, to), (from_z, to_z))
            }
            (Surface::Flat(_), Way::Arc(_)) | (Surface::Cylinder { .. }, _) => return None,
        };
        Some(Self { surface: Surface::Face, way, third })
    }

    /// Length of the path, mm.
    pub fn length(&self) -> f64 {
        let plane = match self.way {
            Way::Line(from, to) => from.distance(to),
            Way::Arc(arc) => arc.length(),
        };
        plane.hypot(self.third.1 - self.third.0)
    }

    /// The part from the start to the fraction `t`, and the part from there to the end.
    pub fn split(&self, t: f64) -> (Self, Self) {
        let (point, third) = (self.way.at(t), self.third.0 + t * (self.third.1 - self.third.0));
        let (first, second) = match self.way {
            Way::Line(from, to) => (Way::Line(from, point), Way::Line(point, to)),
            Way::Arc(arc) => {
                // An arc that ends at its start is a full circle: a part of zero length must not become one.
                let part = |arc: Arc, share: f64| match share * self.length() > SAME {
                    true => Way::Arc(arc),
                    false => Way::Line(arc.start, arc.end),
                };
                (part(Arc { end: point, ..arc }, t), part(Arc { start: point, ..arc }, 1.0 - t))
            }
        };
        (
            Self { way: first, third: (self.third.0, third), ..*self },
            Self { way: second, third: (third, self.third.1), ..*self },
        )
    }

    /// Points along the path in the machine, from start to end, so dense that the lines between them deviate
    /// from the curve by at most `chord` mm.
    pub fn machine_path(&self, chord: f64) -> Vec<Point> {
        let mut pieces = 4u32;
        // The curve has only a few bends, so doubling finds a number of pieces that is enough everywhere.
        while pieces < MAX_PIECES {
            let miss = |piece: u32| {
                let at = |t: f64| self.at((f64::from(piece) + t) / f64::from(pieces));
                let (from, middle, to) = (at(0.0), at(0.5), at(1.0));
                middle.distance(Point::new((from.x + to.x) / 2.0, (from.z + to.z) / 2.0))
            };
            if (0..pieces).map(miss).fold(0.0, f64::max) <= chord {
                break;
            }
            pieces *= 2;
        }
        (0..=pieces).map(|piece| self.at(f64::from(piece) / f64::from(pieces))).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Turn;

    fn point(x: f64, c: f64) -> Point {
        Point::new(c, x)
    }

    #[test]
    fn c_follows_a_square_around_the_centre() {
        assert_eq!(Surface::Face.enter(Point::new(35.0, -20.0), 0.0, 10.0), (point(35.0, 0.0), -20.0));
        let corners = [(35.0, 0.0), (35.0, 35.0), (-35.0, 35.0), (-35.0, -35.0), (35.0, -35.0), (35.0, 0.0)];
        let turned: f64 = corners
            .windows(2)
            .map(|pair| Way::Line(point(pair[0].0, pair[0].1), point(pair[1].0, pair[1].1)))
            .map(|way| Surface::Face.turn_along(&way))
            .sum();
        assert!((turned - 360.0).abs() < 1e-9);
        assert_eq!(Surface::Face.machine(point(-30.0, 40.0), -5.0), Point::new(50.0, -5.0));
    }

    #[test]
    fn c_turns_once_for_a_circle_around_the_centre_and_comes_back_beside_it() {
        let circle = |center: Point| {
            let start = Point::new(center.x, center.z + 10.0);
            Way::Arc(Arc { start, end: start, center, turn: Turn::Clockwise })
        };
        let turned = |way: Way| Surface::Face.turn_along(&way);
        assert!((turned(circle(Point::default())) + 360.0).abs() < 1e-9);
        assert!((turned(circle(point(3.0, 4.0))) + 360.0).abs() < 1e-9);
        assert!(turned(circle(point(30.0, 0.0))).abs() < 1e-9);
        assert!((circle(point(30.0, 0.0)).distance_from_center() - 20.0).abs() < 1e-3);
    }

    #[test]
    fn angle_and_distance_agree_with_what_is_found_step_by_step() {
        const STEPS: u32 = 20_000;
        for number in 0..400u32 {
            let part = |of: u32| f64::from(number / of % 7) - 3.0;
            let center = point(4.0 * part(1) + 0.3, 3.0 * part(7) - 0.2);
            let (radius, begin, sweep) =
                (1.0 + f64::from(number % 11), f64::from(number), f64::from(number % 23));
            let on =
                |angle: f64| Point::new(center.x + radius * angle.sin(), center.z + radius * angle.cos());
            let turn = if number % 2 == 0 { Turn::Clockwise } else { Turn::Counterclockwise };
            let way = Way::Arc(Arc { start: on(begin), end: on(begin + sweep), center, turn });
            let (mut turned, mut nearest, mut from) = (0.0, f64::INFINITY, way.at(0.0));
            for step in 0..=STEPS {
                let to = way.at(f64::from(step) / f64::from(STEPS));
                turned += (from.z * to.x - from.x * to.z).atan2(from.z * to.z + from.x * to.x).to_degrees();
                nearest = f64::min(nearest, to.distance(Point::default()));
                from = to;
            }
            if nearest > 0.01 {
                assert!((Surface::Face.turn_along(&way) - turned).abs() < 1e-6, "{way:?} {turned}");
                assert!((way.distance_from_center() - nearest).abs() < 1e-3, "{way:?} {nearest}");
            }
        }
    }

    #[test]
    fn a_cylinder_unrolls_degrees_into_millimetres() {
        let surface = Surface::Cylinder { radius: 30.0, turned: false };
        let (at, third) = surface.enter(Point::new(28.0, -10.0), 0.0, 90.0);
        assert!((at.x - 15.0 * std::f64::consts::PI).abs() < 1e-9);
        let way = Way::Line(at, Point::new(at.x + 30.0f64.to_radians() * 60.0, -20.0));
        assert!((surface.turn_along(&way) - 60.0).abs() < 1e-9);
        assert_eq!(surface.machine(way.at(1.0), third), Point::new(28.0, -20.0));
    }

    #[test]
    fn the_machine_dips_towards_the_axis_along_a_straight_edge() {
        let way = Way::Line(point(40.0, 30.0), point(-40.0, 30.0));
        let edge = VirtualMove { surface: Surface::Face, way, third: (-5.0, -5.0) };
        let path = edge.machine_path(0.05);
        let nearest = path.iter().map(|at| at.x).fold(f64::INFINITY, f64::min);
        assert!((nearest - 30.0).abs() < 1e-9 && path.len() < 200);
        assert!((way.distance_from_center() - 30.0).abs() < 1e-9);
        let (first, second) = edge.split(0.25);
        assert!((first.length() + second.length() - 80.0).abs() < 1e-9);
        assert!(first.at(1.0).is_same(edge.at(0.25)) && second.at(0.0).is_same(edge.at(0.25)));
    }
}
