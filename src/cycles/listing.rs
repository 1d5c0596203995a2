//! Prints moves in the format of the worked examples, for tests.
//!
//! One line for each pass: `#1 R(86.5,15.5) F(36.5,6.5) A+(48.5,0.5) c(36.5,0.5) r6`, X a diameter, four
//! decimals, without zero-length moves. `T` is a thread, `A+` G03, `A-` G02; moves outside of the passes
//! follow `#0`.

use super::Move;
use crate::geometry::Point;
use crate::motion::MotionKind;
use crate::units::Diameter;

/// A reflection or rotation of the plane.
pub type Map = fn(Point) -> Point;

/// A limit of moves that no example reaches.
pub const MANY: usize = 4_000_000;

/// A point in program coordinates: X a diameter.
pub fn at(x: f64, z: f64) -> Point {
    Point::new(Diameter::new(x).radius(), z)
}

/// Lists moves that begin at `start`.
pub fn listing(start: Point, moves: &[Move]) -> String {
    let mut out = String::new();
    let (mut at, mut pass) = (start, None);
    for step in moves {
        if at.is_same(step.to) && step.center.is_none() {
            continue;
        }
        if pass != Some(step.pass) {
            out += &format!("{}#{}", if pass.is_none() { "" } else { "\n" }, step.pass);
            pass = Some(step.pass);
        }
        let kind = match step.kind {
            MotionKind::Rapid => "R",
            MotionKind::Feed => "F",
            MotionKind::ArcClockwise => "A-",
            MotionKind::ArcCounterclockwise => "A+",
            MotionKind::Thread => "T",
            MotionKind::Dwell => "dwell",
        };
        out += &format!(" {kind}{}", place(step.to));
        if let Some(center) = step.center {
            out += &format!(" c{} r{}", place(center), number(center.distance(step.to)));
        }
        at = step.to;
    }
    out
}

/// Compares moves with the lines of an example, ignoring blanks at the ends of lines.
#[track_caller]
pub fn check(start: Point, moves: &[Move], expected: &str) {
    let expected: Vec<&str> = expected.trim().lines().map(str::trim).collect();
    assert_eq!(listing(start, moves), expected.join("\n"));
}

fn place(point: Point) -> String {
    format!("({},{})", number(Diameter::from_radius(point.x).mm()), number(point.z))
}

fn number(value: f64) -> String {
    // Adding zero turns -0 into 0.
    ((value * 1e4).round() / 1e4 + 0.0).to_string()
}
