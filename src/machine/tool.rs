//! The outline of a tool: the cutting part, and the part that must not touch anything.
//!
//! In: a [`Tool`] of the setup. Out: convex outlines about the programmed point (the imaginary tip), in mm,
//! for a tool at the upper half of the section. Angles are measured from +Z towards +X. Must not know
//! programs.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use super::sweep::{CHORD, Outline};
use super::thread_point::ThreadPoint;
use crate::control::compensation::{Nose, Vector};
use crate::geometry::Point;
use crate::setup::thread_insert::Hand;
use crate::setup::{Side, Tool, ToolKind};
use crate::units::Diameter;

/// Default insert edge length, mm.
pub(super) const EDGE: f64 = 12.0;

/// Default entering angle of a turning or boring tool, degrees.
pub(super) const ENTERING: f64 = 95.0;

/// Largest default entering angle of a square or blunter insert, degrees.
const SQUARE_ENTERING: f64 = 75.0;

/// Default point angle of an insert, degrees: a rhombus of 80°.
pub(super) const POINT: f64 = 80.0;

/// Default width of a grooving insert, mm.
pub(super) const BLADE: f64 = 3.0;

/// Default diameter of a drill, mm.
pub(super) const DRILL: Diameter = Diameter::new(10.0);

/// Default point angle of a drill, degrees.
pub(super) const DRILL_POINT: f64 = 118.0;

/// Longer than any workpiece, mm.
pub const LONG: f64 = 400.0;

/// Side of the square shank of a turning tool, mm.
const SHANK: f64 = 25.0;

/// How a tool removes material.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Action {
    /// It removes the area it sweeps.
    Turning,
    /// It cuts a groove for each spindle revolution in a synchronized motion, otherwise it removes the area
    /// it sweeps.
    Threading,
    /// It is live and removes nothing from the turned profile.
    Live,
}

/// The outlines of a tool, for drawing and cutting.
#[derive(Clone, Debug, PartialEq)]
pub struct Shape {
    /// How it removes material.
    pub action: Action,
    /// The cutting part.
    pub edge: Outline,
    /// The cutting part, slightly smaller: an edge that touches the workpiece without cutting it does not
    /// overlap this.
    pub core: Outline,
    /// The holder, if it is known.
    pub body: Option<Outline>,
    /// Nose radius, mm.
    pub nose: f64,
    /// For a turning or boring insert, the angle between the edge behind the tip and the spindle axis,
    /// radians: the insert cannot follow a slope that falls more steeply.
    pub trailing: Option<f64>,
}

/// A part of a tool that can collide.
#[derive(Clone, Copy, Debug)]
pub struct Solid<'a> {
    /// Its outline.
    pub outline: &'a Outline,
    /// The outline that counts: an overlap with it is more than contact.
    pub core: &'a Outline,
    /// Nose radius of the cutting part, mm; `None` for a holder.
    pub nose: Option<f64>,
}

/// How much smaller the core is, mm: a smaller overlap counts as contact.
const CORE: f64 = 0.01;

/// The direction of the tool's body from its tip: from the imaginary tip to the centre of its nose, as in the
/// table of tip directions in the Haas lathe manual.
fn body_direction(tip: u8) -> Vector {
    Nose { radius: 1.0, tip }.vector()
}

impl Shape {
    /// The parts that can collide: the cutting part, and the holder if it is known.
    pub fn solids(&self) -> impl Iterator<Item = Solid<'_>> {
        let edge = Solid { outline: &self.edge, core: &self.core, nose: Some(self.nose) };
        let body = self.body.as_ref().map(|body| Solid { outline: body, core: body, nose: None });
        [Some(edge), body].into_iter().flatten()
    }

    /// The shape of a tool.
    pub fn of(tool: &Tool) -> Self {
        let kind = tool.kind.unwrap_or(ToolKind::Turning);
        let (action, edge, body) = match kind {
            ToolKind::Turning | ToolKind::Boring => {
                let (edge, body) = insert(tool, kind);
                (Action::Turning, edge, body)
            }
            ToolKind::Grooving => {
                let (edge, body) = blade(tool);
                (Action::Turning, edge, body)
            }
            ToolKind::Threading => {
                let (edge, body) = thread(tool);
                (Action::Threading, edge, body)
            }
            ToolKind::Drill | ToolKind::Tap => {
                let (edge, body) = drill(tool, kind);
                (Action::Turning, edge, body)
            }
            ToolKind::Endmill => {
                let radius = tool.cutter_radius().unwrap_or(DRILL.radius());
                (Action::Live, Outline::around(rectangle((0.0, LONG / 10.0), (-radius, radius))), None)
            }
        };
        let nose = match kind {
            ToolKind::Drill | ToolKind::Tap | ToolKind::Endmill => 0.0,
            _ => tool.nose(),
        };
        let trailing = match kind {
            ToolKind::Turning | ToolKind::Boring => {
                angles(tool).map(|(entering, point)| PI - entering - point)
            }
            _ => None,
        };
        Self { action, core: edge.shrunk(CORE), edge, body, nose, trailing }
    }
}

/// A turning or boring insert and its holder.
fn insert(tool: &Tool, kind: ToolKind) -> (Outline, Option<Outline>) {
    let written = tool.insert();
    let length = tool.edge_length.or_else(|| written?.edge_length).unwrap_or(EDGE);
    let direction =
        body_direction(if tool.tip == Some(0) || tool.tip == Some(9) { 0 } else { tool.tip_direction() });
    let Some((entering, point)) = angles(tool) else {
        let radius = tool.nose_radius.filter(|&radius| radius > 0.0).unwrap_or(length / 2.0);
        let center = Point::new(direction.x * radius, direction.z * radius);
        return (Outline::around(circle(center, radius, 0.0, TAU)), None);
    };
    let nose = tool.nose();
    // Built as a tool that points to the lower left, or straight down, then mirrored.
    let (low, high) = match (direction.x == 0.0, direction.z == 0.0) {
        (false, true) => (FRAC_PI_2 - point / 2.0, FRAC_PI_2 + point / 2.0),
        (true, false) => (-point / 2.0, point / 2.0),
        _ => (PI - entering - point, PI - entering),
    };
    let center = Point::new(nose * direction.x.abs(), nose * direction.z.abs());
    let corners = match written.map(|insert| insert.shape) {
        Some('T') => Corners::Three,
        _ => Corners::Four,
    };
    let points = wedge(low, high, center, nose, length, corners);
    let over = |point: &Point| {
        Point::new(
            if direction.x < 0.0 { -point.x } else { point.x },
            if direction.z < 0.0 { -point.z } else { point.z },
        )
    };
    // The holder begins slightly behind the edges.
    let far = far_corner(low, high, center, nose, length);
    let inside = points
        .iter()
        .map(|point| Point::new(far.x + 0.75 * (point.x - far.x), far.z + 0.75 * (point.z - far.z)));
    let seat: Vec<Point> = inside.collect();
    let left = seat.iter().map(|point| point.z).fold(f64::INFINITY, f64::min);
    let top = seat.iter().map(|point| point.x).fold(f64::NEG_INFINITY, f64::max);
    let body = match kind {
        // A square shank across the axis.
        _ if kind == ToolKind::Turning => Some(Outline::around(
            seat.iter()
                .copied()
                .chain(rectangle((left, left + SHANK), (top, LONG)))
                .map(|point| over(&point)),
        )),
        // A round bar along the axis, whose upper side is slightly below the edge.
        _ => tool.shank.map(|bar| {
            let low = seat.iter().map(|point| point.x).fold(f64::INFINITY, f64::min);
            Outline::around(
                rectangle((left, tool.reach.unwrap_or(LONG)), (low, low + bar))
                    .into_iter()
                    .map(|point| over(&point)),
            )
        }),
    };
    let body = body.filter(|_| tool.kind.is_some());
    (Outline::around(points.iter().map(over)), body)
}

/// Entering angle and point angle of a turning or boring insert, radians. `None` for a round one.
fn angles(tool: &Tool) -> Option<(f64, f64)> {
    let point = match (tool.point_angle, tool.insert()) {
        (None, Some(written)) => written.point_angle?,
        (own, _) => own.unwrap_or(POINT),
    };
    // A square insert at 95° would cut with the edge behind its tip, deeper than programmed.
    let usual = if point <= 80.0 { ENTERING } else { (175.0 - point).min(SQUARE_ENTERING) };
    Some((tool.entering_angle.unwrap_or(usual).to_radians(), point.to_radians()))
}

/// A grooving or parting insert and its holder.
fn blade(tool: &Tool) -> (Outline, Option<Outline>) {
    let width = tool.width.unwrap_or(BLADE);
    let nose = tool.nose().min(width / 2.0);
    let direction = body_direction(tool.tip_direction());
    let side = tool.side.unwrap_or_default();
    // Built as an insert for outside grooves: width along Z, reach along X.
    let across = match side {
        Side::Outside | Side::Inside => direction.z,
        Side::Face => direction.x,
    };
    let (first, last) = match across {
        sign if sign > 0.0 => (0.0, width),
        sign if sign < 0.0 => (-width, 0.0),
        _ => (-width / 2.0, width / 2.0),
    };
    let turned = |point: Point| match side {
        Side::Outside => point,
        Side::Inside => Point::new(-point.x, point.z),
        Side::Face => Point::new(point.z, point.x),
    };
    let top = tool.reach.unwrap_or(LONG);
    let mut points = vec![Point::new(top, first), Point::new(top, last)];
    points.extend(circle(Point::new(nose, first + nose), nose, PI, FRAC_PI_2));
    points.extend(circle(Point::new(nose, last - nose), nose, PI + FRAC_PI_2, FRAC_PI_2));
    let body = tool.reach.map(|reach| {
        Outline::around(rectangle((first, first + SHANK), (reach, LONG)).into_iter().map(turned))
    });
    (Outline::around(points.into_iter().map(turned)), body)
}

/// A threading insert and its holder: the point, and above it a block as wide as the flanks at their ends.
fn thread(tool: &Tool) -> (Outline, Option<Outline>) {
    let ThreadPoint { angle, flank, height, hand } = ThreadPoint::of(tool);
    let half = angle.to_radians() / 2.0;
    let nose = tool.nose();
    let point = wedge(FRAC_PI_2 - half, FRAC_PI_2 + half, Point::new(nose, 0.0), nose, flank, Corners::Three);
    let wide = point.iter().map(|point| point.z).fold(0.0, f64::max);
    let inwards = match tool.working_side() {
        Side::Outside | Side::Face => 1.0,
        Side::Inside => -1.0,
    };
    let forward = match hand {
        Hand::Right => 1.0,
        Hand::Left => -1.0,
    };
    let placed = |point: Point| Point::new(inwards * point.x, forward * point.z);
    let edge = point.into_iter().chain(rectangle((-wide, wide), (height, height))).map(placed);
    let body = tool.reach.map(|reach| {
        let holder = rectangle((-wide, SHANK - wide), (reach.max(height), LONG));
        Outline::around(holder.into_iter().map(placed))
    });
    (Outline::around(edge), body)
}

/// A drill or a tap, and its holder. The programmed point is its tip, or, with tip direction 6, the edge of a
/// flat drill.
fn drill(tool: &Tool, kind: ToolKind) -> (Outline, Option<Outline>) {
    let radius = tool.diameter.unwrap_or(DRILL).radius();
    if tool.tip == Some(6) {
        let length = tool.reach.unwrap_or(LONG);
        return (Outline::around(rectangle((0.0, length), (-2.0 * radius, 0.0))), None);
    }
    let point = if kind == ToolKind::Tap { 180.0 } else { tool.angle.unwrap_or(DRILL_POINT) };
    let shoulder = radius / (point.to_radians() / 2.0).tan();
    let length = tool.reach.unwrap_or(LONG).max(shoulder);
    let body = [
        Point::new(-radius, shoulder),
        Point::new(radius, shoulder),
        Point::new(-radius, length),
        Point::new(radius, length),
    ];
    let holder =
        tool.reach.map(|reach| Outline::around(rectangle((reach, LONG), (-2.0 * radius, 2.0 * radius))));
    (Outline::around(body.into_iter().chain([Point::default()])), holder)
}

/// Number of corners of an insert.
#[derive(Clone, Copy)]
enum Corners {
    Three,
    Four,
}

/// Corners of an insert between two edges in the directions `low` and `high`, rounded about `center` with
/// radius `nose`. `length` is that of an edge from the corner that it would have without a nose.
fn wedge(low: f64, high: f64, center: Point, nose: f64, length: f64, corners: Corners) -> Vec<Point> {
    let half = (high - low) / 2.0;
    let (sharp, left) = (sharp_corner(low, high, center, nose), length.max(1.01 * nose / half.tan()));
    let mut points = circle(center, nose, high + FRAC_PI_2, PI - (high - low));
    points.extend([ahead(sharp, low, left), ahead(sharp, high, left)]);
    if let Corners::Four = corners {
        points.push(far_corner(low, high, center, nose, left));
    }
    points
}

fn sharp_corner(low: f64, high: f64, center: Point, nose: f64) -> Point {
    ahead(center, (low + high) / 2.0, -nose / ((high - low) / 2.0).sin())
}

fn far_corner(low: f64, high: f64, center: Point, nose: f64, length: f64) -> Point {
    ahead(ahead(sharp_corner(low, high, center, nose), low, length), high, length)
}

/// The point `length` mm from another, in a direction.
fn ahead(from: Point, direction: f64, length: f64) -> Point {
    Point::new(from.x + length * direction.sin(), from.z + length * direction.cos())
}

/// Points on a circle from an angle on, counter-clockwise; their chords stay within half of [`CHORD`] on
/// either side of the circle. Only the centre if the radius is zero.
fn circle(center: Point, radius: f64, from: f64, sweep: f64) -> Vec<Point> {
    if radius <= 0.0 {
        return vec![center];
    }
    let step = 2.0 * (1.0 - CHORD / radius).max(0.0).acos();
    let count = (sweep / step).ceil().max(1.0);
    let outside = radius + CHORD / 2.0;
    (0..=count as u32)
        .map(|index| {
            let share = f64::from(index) / count;
            // The ends lie on the edges.
            let radius = if index == 0 || f64::from(index) == count { radius } else { outside };
            ahead(center, from + share * sweep, radius)
        })
        .collect()
}

fn rectangle(z: (f64, f64), x: (f64, f64)) -> [Point; 4] {
    [Point::new(x.0, z.0), Point::new(x.0, z.1), Point::new(x.1, z.1), Point::new(x.1, z.0)]
}

/// The outline with which an inferred tool removes material.
pub(super) fn takes(tool: &Tool) -> Outline {
    over_edge(tool, &Shape::of(tool))
}

/// The edge length of an inferred insert is usually unknown, so it leaves no material above it.
pub(super) fn over_edge(tool: &Tool, shape: &Shape) -> Outline {
    let over = match tool.kind.filter(|_| tool.edge_length.is_none()) {
        Some(ToolKind::Turning) => LONG,
        Some(ToolKind::Boring) => -LONG,
        _ => 0.0,
    };
    let edge = shape.edge.points().iter();
    Outline::around(edge.flat_map(|&own| [own, Point::new(own.x + over, own.z)]))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shape(json: &str) -> Shape {
        Shape::of(&serde_json::from_str(json).expect("a tool"))
    }

    /// Checks the extents of the cutting part: minimum and maximum Z, minimum and maximum X.
    fn check(json: &str, expected: [f64; 4]) {
        let edge = shape(json).edge;
        let fold = |of: fn(&Point) -> f64| {
            let all = edge.points().iter().map(of);
            [all.clone().fold(f64::INFINITY, f64::min), all.fold(f64::NEG_INFINITY, f64::max)]
        };
        let ([left, right], [low, high]) = (fold(|point| point.z), fold(|point| point.x));
        for (found, expected) in [left, right, low, high].into_iter().zip(expected) {
            assert!((found - expected).abs() < 0.003, "{json}: {left} {right} {low} {high}");
        }
    }

    #[test]
    fn the_tip_touches_both_axes() {
        // A rhombus of 80° with edges of 12 mm between 5° and 85°.
        let reach = 12.0 * (5f64.to_radians().cos() + 85f64.to_radians().cos());
        check(r#"{"type": "turning"}"#, [0.0, reach, 0.0, reach]);
        check(r#"{"type": "boring"}"#, [0.0, reach, -reach, 0.0]);
        // The edges of a square insert are at 75°: no part of it is below the tip.
        let (left, up) = (12.0 * 75f64.to_radians().cos(), 12.0 * 75f64.to_radians().sin());
        check(r#"{"type": "turning", "insert": "S"}"#, [-left, up, 0.0, up + left]);
        check(r#"{"type": "turning", "tip": 4}"#, [-reach, 0.0, 0.0, reach]);
        check(r#"{"type": "turning", "tip": 1}"#, [-reach, 0.0, -reach, 0.0]);
    }

    #[test]
    fn a_nose_keeps_the_imaginary_tip() {
        for tip in [1, 2, 3, 4] {
            let edge = shape(&format!(
                r#"{{"type": "turning", "insert": "DNMG150608", "enteringAngle": 93, "tip": {tip}}}"#
            ))
            .edge;
            let (x, z) = (if tip <= 2 { -1.0 } else { 1.0 }, if tip == 2 || tip == 3 { 1.0 } else { -1.0 });
            let low = |of: &dyn Fn(&Point) -> f64| edge.points().iter().map(of).fold(f64::INFINITY, f64::min);
            assert!(
                low(&|point| x * point.x).abs() < 0.002 && low(&|point| z * point.z).abs() < 0.002,
                "{tip}"
            );
            // The nose is 0.8 mm about its centre: no part of the insert is nearer to the imaginary tip than
            // this.
            let nearest = low(&|point| point.x.hypot(point.z));
            assert!((nearest - 0.8 * (2f64.sqrt() - 1.0)).abs() < 0.01, "{tip}: {nearest}");
        }
    }

    #[test]
    fn blades_are_set_by_a_corner() {
        check(r#"{"type": "grooving", "width": 4, "reach": 20}"#, [0.0, 4.0, 0.0, 20.0]);
        check(r#"{"type": "grooving", "width": 4, "reach": 20, "tip": 4}"#, [-4.0, 0.0, 0.0, 20.0]);
        check(
            r#"{"type": "grooving", "width": 4, "reach": 20, "tip": 8, "noseRadius": 0.4}"#,
            [-2.0, 2.0, 0.0, 20.0],
        );
        check(r#"{"type": "grooving", "width": 4, "reach": 20, "side": "inside"}"#, [0.0, 4.0, -20.0, 0.0]);
        check(r#"{"type": "grooving", "width": 4, "reach": 20, "side": "face"}"#, [0.0, 20.0, 0.0, 4.0]);
    }

    #[test]
    fn drills_and_points() {
        check(r#"{"type": "drill", "diameter": 10, "reach": 50}"#, [0.0, 50.0, -5.0, 5.0]);
        check(r#"{"type": "turning", "insert": "RCMT0803"}"#, [0.0, 8.0, 0.0, 8.0]);
        check(r#"{"type": "turning", "insert": "RCMT0803", "tip": 8}"#, [-4.0, 4.0, 0.0, 8.0]);
    }

    #[test]
    fn a_threading_insert_is_little_wider_than_its_tooth() {
        // A pitch of 3 mm: half a tooth is 1.5.
        check(r#"{"type": "threading"}"#, [-1.75, 1.75, 0.0, 16.0]);
        check(r#"{"type": "threading", "side": "inside"}"#, [-1.75, 1.75, -16.0, 0.0]);
        check(r#"{"type": "threading", "insert": "16ER1.5ISO"}"#, [-0.925, 0.925, 0.0, 16.0]);
        check(r#"{"type": "threading", "insert": "22IRN60"}"#, [-2.85, 2.85, -22.0, 0.0]);
        check(r#"{"type": "threading", "insert": "16ER", "side": "inside"}"#, [-1.75, 1.75, -16.0, 0.0]);
        // A tool ground to a point: its edge length is that of its flanks.
        let half = 12.0 * 30f64.to_radians().sin();
        check(r#"{"type": "threading", "edgeLength": 12}"#, [-half, half, 0.0, 27.0]);
        check(r#"{"type": "threading", "edgeLength": 3, "reach": 8}"#, [-1.5, 1.5, 0.0, 8.0]);
        // Its holder is on the side away from the shoulder.
        for (insert, left) in [("16ERAG60", -1.75), ("16ELAG60", 1.75 - SHANK)] {
            let json = format!(r#"{{"type": "threading", "insert": "{insert}", "reach": 10}}"#);
            let body = shape(&json).body.expect("a holder");
            let found = body.points().iter().map(|point| point.z).fold(f64::INFINITY, f64::min);
            assert!((found - left).abs() < 1e-9, "{insert}: {found}");
        }
    }

    #[test]
    fn a_holder_stays_behind_the_edges() {
        for json in [
            r#"{"type": "turning"}"#,
            r#"{"type": "turning", "insert": "VNMG160404", "enteringAngle": 93}"#,
            r#"{"type": "boring", "shank": 12}"#,
            r#"{"type": "grooving", "reach": 12}"#,
            r#"{"type": "drill", "reach": 40}"#,
        ] {
            let shape = shape(json);
            let body = shape.body.expect("a known holder");
            assert!(body.points().iter().all(|point| point.x.hypot(point.z) > 1.0), "{json}");
        }
        assert_eq!(shape("{}").body, None);
    }
}
