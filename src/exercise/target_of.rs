//! Writes the outline of a finished part as the target of an exercise.
//!
//! In: a run whose part can be shown. Out: the lines of the block `target`, with sizes as the program states them and
//! default tolerances, each followed by the size it belongs to, in parentheses. The rest of the bar is not part of it,
//! and threads are notes on their cylinders.

use super::fault::TargetFault;
use super::outline;
use super::target::Target;
use super::values::Tolerance;
use crate::geometry::{Point, SAME};
use crate::machine::SimulationResult;
use crate::machine::feature::{self, Feature, Shape, Thread};
use crate::machine::part::Part;
use crate::machine::region::Region;
use crate::machine::resolved_setup::ResolvedSetup;
use crate::motion::{MotionKind, Motions};
use crate::setup::{Blank, Setup, Side, as_comments};
use crate::units::{Diameter, number};

/// The default tolerances, mm.
const DIAMETER: Tolerance = Tolerance::both(0.05);
const LENGTH: Tolerance = Tolerance::both(0.1);
const RADIUS: Tolerance = Tolerance::both(0.1);
/// Length of the bar behind the part, mm.
const BEHIND: f64 = 5.0;
/// Two positions closer than this, mm, are one.
const SAME_PLACE: f64 = 0.005;
/// Largest radius of an arc that is the rounding of the tool, mm.
const ROUNDING: f64 = 0.9;
/// Radius up to which the nose leaves a nib on the axis, mm.
const NIB: f64 = 0.5;
/// Rounding of inside corners in the target, mm.
const CORNERS: f64 = 0.5;

/// Why a part has no target.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NoTarget {
    /// There is no part.
    NoPart,
    /// Its outline has more lines than a target may have.
    TooManyLines,
    /// Its outline cannot be written as a target.
    NoOutline,
}

/// The blocks `setup` and `target` of an exercise whose part a program makes. They contain no block of the program.
///
/// `setup`: of the run, with the additions of its text; `decides_decimal`: its decimal rule was inferred from the text.
///
/// # Errors
///
/// The reason why the part has no target.
pub fn blocks_of_exercise(
    simulation: &SimulationResult,
    motions: &Motions,
    setup: &Setup,
    decides_decimal: bool,
) -> Result<String, NoTarget> {
    let target = target_of(simulation, motions)?;
    let stock = simulation.resolved_setup().blank().map(|(blank, _)| blank.clone());
    let mut setup = Setup { stock, ..setup.clone() };
    if decides_decimal {
        setup.dialect.decimal = None;
    }
    let setup = as_comments::lines(&setup).join("\n");
    Ok(format!("```setup\n{setup}\n```\n\n```target\n{target}```\n"))
}

/// The outline of the finished part of a simulation as the lines of a target.
///
/// # Errors
///
/// The reason why the part has no target.
pub fn target_of(simulation: &SimulationResult, motions: &Motions) -> Result<String, NoTarget> {
    let resolved = simulation.resolved_setup();
    simulation.finished().ok_or(NoTarget::NoPart)?;
    let (blank, _) = resolved.blank().ok_or(NoTarget::NoPart)?;
    let threads = feature::threads(motions, resolved);
    let outline = Outline::of(without_threads(motions, resolved, blank), motions, blank, &threads);
    let lines = outline.lines(&threads);
    if lines.len() > TargetFault::MOST_LINES {
        return Err(NoTarget::TooManyLines);
    }
    let own: Vec<&str> = lines.iter().map(String::as_str).collect();
    let (edges, _) = outline::read(&own, DIAMETER).map_err(|_| NoTarget::NoOutline)?;
    Target::of(edges, CORNERS).map_err(|_| NoTarget::NoOutline)?;
    Ok(lines.into_iter().map(|line| line + "\n").collect())
}

/// The finished part without its threads: their teeth are no edges of a target.
fn without_threads(motions: &Motions, resolved: &ResolvedSetup, blank: &Blank) -> Region {
    let mut part = Part::new(blank);
    for motion in motions.on_workpiece().filter(|motion| motion.kind != MotionKind::Thread) {
        let motion = motion.on_positive_side();
        part.step(&motion, resolved.tool(&motion));
    }
    part.finished()
}

/// The features of the part, from the right end of the axis or the left end of the bore to the left end.
struct Outline {
    features: Vec<Feature>,
    /// The outside of the blank.
    outside: f64,
}

impl Outline {
    fn of(mut part: Region, motions: &Motions, blank: &Blank, threads: &[Thread]) -> Self {
        part.drop_pieces(|own, all| own.max.z < all.max.z - SAME);
        let bar = blank.extents();
        let back = part.edges().map(|(a, _)| a.z).fold(f64::MAX, f64::min);
        let left = (back <= bar.back() + SAME).then(|| left_of(&part, blank, threads));
        if let Some(left) = left {
            let low = Point::new(0.0, left);
            let corners = [low, Point::new(0.0, 1e4), Point::new(1e4, 1e4), Point::new(1e4, left)];
            part = part.intersection(&[corners]);
        }
        let features = feature::all(&part, &[]).into_iter().map(|feature| feature.as_programmed(motions));
        let features = to_axis(without_roundings(in_order(features.collect(), left)));
        Self { features, outside: bar.diameter.radius() }
    }

    fn lines(&self, threads: &[Thread]) -> Vec<String> {
        let Some(first) = self.features.first() else { return Vec::new() };
        let mut at = first.ends()[0];
        let mut lines = vec![format!("X{} Z{}", shown_x(at), shown(at.z))];
        for (index, feature) in self.features.iter().enumerate() {
            lines.push(self.line(index, at, threads));
            at = feature.ends()[1];
        }
        lines
    }

    /// Whether a feature is the bottom of a groove: a cylinder between two faces that rise from it, or fall in a bore.
    /// The outline goes to Z- outside, and to Z+ in a bore.
    fn is_groove(&self, index: usize) -> bool {
        let next = |index: Option<usize>| index.and_then(|index| self.features.get(index));
        let [start, end] = self.features[index].ends();
        let (bottom, is_outside) = (start.x, end.z < start.z);
        let (Some(before), Some(after)) = (next(index.checked_sub(1)), next(Some(index + 1))) else {
            return false;
        };
        let is_face = [before, after].iter().all(|wall| wall.shape == Shape::Face);
        let rises = [before.ends()[0].x, after.ends()[1].x].map(|top| top > bottom);
        self.features[index].shape == Shape::Cylinder && is_face && rises == [is_outside; 2]
    }

    /// The line of a feature that begins at a point.
    fn line(&self, index: usize, from: Point, threads: &[Thread]) -> String {
        let feature = &self.features[index];
        let to = feature.ends()[1];
        let mut words = Vec::new();
        if let Shape::Arc { .. } = feature.shape {
            words.push(if turns_left(feature) { "G03".to_owned() } else { "G02".to_owned() });
        }
        words.extend(((to.x - from.x).abs() > SAME_PLACE).then(|| format!("X{}", shown_x(to))));
        words.extend(((to.z - from.z).abs() > SAME_PLACE).then(|| format!("Z{}", shown(to.z))));
        match feature.shape {
            Shape::Arc { radius } => words.push(format!("R{0} {RADIUS} (R{0})", shown(radius))),
            Shape::Face => words.push(format!("{LENGTH} (Z{})", shown(to.z))),
            Shape::Cylinder if (to.x - self.outside).abs() <= SAME_PLACE => words.push("free".to_owned()),
            Shape::Cylinder => words.push(format!("{DIAMETER} (Ø{})", shown_x(to))),
            _ => words.push(format!("{DIAMETER} (Ø{}, Ø{})", shown_x(from), shown_x(to))),
        }
        words.extend(self.is_groove(index).then(|| format!("width {LENGTH}")));
        words.extend(threads.iter().find_map(|thread| note(thread, feature)));
        words.join(" ")
    }
}

/// Z at which the outline of a part that remains on the bar ends: behind the last surface that was cut.
fn left_of(part: &Region, blank: &Blank, threads: &[Thread]) -> f64 {
    let bar = blank.extents();
    let corners = part.edges().map(|(a, _)| a).filter(|at| at.x > SAME && at.z > bar.back() + SAME);
    let threads = threads.iter().map(|thread| thread.z[0]);
    let last = corners.map(|at| at.z).chain(threads).fold(bar.face, f64::min);
    (last - BEHIND).round().max(bar.back())
}

/// The features that belong to the outline, from its start to its end.
fn in_order(features: Vec<Feature>, left: Option<f64>) -> Vec<Feature> {
    let is_left_out = |feature: &Feature| {
        let ends = feature.ends();
        let is_axis = ends.iter().all(|end| end.x <= NIB);
        is_axis || left.is_some_and(|left| ends.iter().all(|end| end.z <= left + SAME_PLACE))
    };
    let start = match features.iter().rposition(is_left_out) {
        Some(last) if features.iter().any(is_left_out) => {
            let after = (last + 1) % features.len();
            // Several features can be left out in a row: the axis, then the left end.
            (after..features.len()).chain(0..after).find(|&index| !is_left_out(&features[index])).unwrap_or(0)
        }
        _ => first_of_ring(&features),
    };
    let rotated = features[start..].iter().chain(&features[..start]);
    rotated.filter(|feature| !is_left_out(feature)).cloned().collect()
}

/// The feature that begins at the left end of the bore of a part that is a ring.
fn first_of_ring(features: &[Feature]) -> usize {
    let start = |index: &usize| features[*index].ends()[0];
    let order = |a: &usize, b: &usize| {
        let (a, b) = (start(a), start(b));
        if (a.z - b.z).abs() > SAME_PLACE { a.z.total_cmp(&b.z) } else { a.x.total_cmp(&b.x) }
    };
    (0..features.len()).min_by(order).unwrap_or(0)
}

/// The features with the first one extended to the axis, if the nose has left a nib there.
fn to_axis(mut features: Vec<Feature>) -> Vec<Feature> {
    let first = features.first_mut().filter(|first| first.shape == Shape::Face);
    if let Some(start) = first.and_then(|first| first.corners.first_mut()).filter(|start| start.x <= ROUNDING)
    {
        start.x = 0.0;
    }
    features
}

/// The features without the roundings that the nose leaves between straight ones.
fn without_roundings(mut features: Vec<Feature>) -> Vec<Feature> {
    let mut index = 1;
    while index + 1 < features.len() {
        let is_small = matches!(features[index].shape, Shape::Arc { radius } if radius <= ROUNDING);
        match corner(&features[index - 1], &features[index + 1]).filter(|_| is_small) {
            Some(corner) => {
                features.remove(index);
                if let Some(end) = features[index - 1].corners.last_mut() {
                    *end = corner;
                }
                if let Some(start) = features[index].corners.first_mut() {
                    *start = corner;
                }
            }
            None => index += 1,
        }
    }
    features
}

/// Where the lines of two straight features meet.
fn corner(before: &Feature, after: &Feature) -> Option<Point> {
    let is_straight =
        |own: &Feature| matches!(own.shape, Shape::Cylinder | Shape::Face | Shape::Taper { .. });
    if !is_straight(before) || !is_straight(after) {
        return None;
    }
    let ([a, b], [c, d]) = (before.ends(), after.ends());
    let (first, second) = ((b.x - a.x, b.z - a.z), (d.x - c.x, d.z - c.z));
    let cross = first.0 * second.1 - first.1 * second.0;
    let share = ((c.x - a.x) * second.1 - (c.z - a.z) * second.0) / cross;
    let meet = crate::geometry::at_share([a, b], share);
    (cross.abs() > SAME && meet.distance(b) <= 3.0 * ROUNDING).then_some(meet)
}

/// Whether an arc turns to the left: G03.
fn turns_left(arc: &Feature) -> bool {
    let [from, to] = arc.ends();
    let on = arc.corners[arc.corners.len() / 2];
    (on.z - from.z) * (to.x - from.x) - (on.x - from.x) * (to.z - from.z) > 0.0
}

/// The words of a thread on a cylinder.
fn note(thread: &Thread, feature: &Feature) -> Option<String> {
    let [from, to] = feature.ends();
    let (low, high) = (from.z.min(to.z), from.z.max(to.z));
    let middle = f64::midpoint(thread.z[0].max(low), thread.z[1].min(high));
    let is_along = (low..=high).contains(&middle) && thread.z[0] < high && low < thread.z[1];
    let is_deeper = match thread.side {
        Side::Inside => thread.depth > from.x,
        Side::Outside | Side::Face => thread.depth < from.x,
    };
    let is_near = (thread.depth - from.x).abs() <= 1.5 * thread.lead.abs();
    (feature.shape == Shape::Cylinder && is_along && is_deeper && is_near).then(|| {
        let root = shown(Diameter::from_radius(thread.depth).mm());
        format!("thread {} root {root} {RADIUS}", shown(thread.lead.abs()))
    })
}

/// A length with three decimals.
fn shown(value: f64) -> String {
    number((value * 1000.0).round() / 1000.0)
}

/// X of a point, a diameter.
fn shown_x(at: Point) -> String {
    shown(Diameter::from_radius(at.x).mm())
}
