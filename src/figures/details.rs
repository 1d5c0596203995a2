//! The details of the figure of a cycle: the finishing allowance of a contour, the start, and the infeed of G76.
//!
//! In: a call of a cycle, and the annotations of its words. Out: details at a larger scale, which replace the
//! annotations of what would be too small.

use super::NUMBERS;
use super::cycle::{Call, SAME_DEPTH, length_of, pass_of};
use crate::geometry::{Point, at_share};
use crate::motion::{Cycle, Motion, MotionKind, Step};
use crate::scene::annotation::{Annotation, Detail, Measure, Shape};
use crate::units::Diameter;

/// Maximum number of passes in a detail.
const MAX_PASSES: usize = 60;
/// Length of the pieces of a contour in its detail, as a multiple of the allowance: at most, and at least.
const LONGEST: f64 = 4.0;
const SHORTEST: f64 = 2.0;
/// A point nearer to the start than this share of the extent of the cycle is indistinguishable from it.
const NEAR_START: f64 = 0.03;
/// Length of the pieces of moves in the detail of the start, as a multiple of that distance.
const LONGEST_AT_START: f64 = 1.5;
/// The dimensions of G76 that its detail shows.
const DEPTHS: [&str; 5] = ["k", "Δd", "Δd min", "d", "a"];

/// Replaces the allowances of roughing, which are too small to be seen, by a detail of a corner of the contour, or of a
/// straight piece of it: the last roughing pass, and the finished contour with the part hatched.
pub fn add_allowance(call: &Call, all: &mut Vec<Annotation>) {
    let [x, z] = ["Δu/2", "Δw"].map(|name| length_of(all, name).unwrap_or(0.0));
    let largest = x.abs().max(z.abs());
    if largest < SAME_DEPTH {
        return;
    }
    let last = call.last(Step::Contour).map_or(0, pass_of);
    let straight = |motion: &&Motion| motion.arc().is_none() && motion.length() >= SHORTEST * largest;
    // Where a side of the part faces the other way, the roughing pass is inside the finished contour.
    let is_outside = |motion: &&Motion| {
        let (dx, dz) = (motion.to.x - motion.from.x, motion.to.z - motion.from.z);
        dx * x * dz * z <= SAME_DEPTH * SAME_DEPTH
    };
    let own = call.steps(Step::Contour).filter(|motion| pass_of(motion) == last);
    let pieces: Vec<&Motion> = own.filter(straight).filter(is_outside).collect();
    let Some(corner) = Corner::best(&pieces) else { return };
    let reach =
        corner.arms().map(|arm| arm.distance(corner.at)).into_iter().fold(LONGEST * largest, f64::min);
    let [before, after] =
        corner.arms().map(|arm| at_share([corner.at, arm], reach / arm.distance(corner.at)));
    let finished = |at: Point| Point::new(at.x - x, at.z - z);
    let rough = vec![before, corner.at, after];
    let edge: Vec<Point> = rough.iter().copied().map(finished).collect();
    // A band of the part beside its edge.
    let sign = |length: f64| if length.abs() < SAME_DEPTH { 0.0 } else { length.signum() };
    let inward = |at: &Point| Point::new(at.x - 0.5 * reach * sign(x), at.z - 0.5 * reach * sign(z));
    let part = edge.iter().copied().chain(edge.iter().rev().map(inward)).collect();
    let arm = |along: fn([Point; 2]) -> bool| {
        let own = [before, after].into_iter().find(|arm| along([corner.at, *arm]));
        own.map(|arm| at_share([corner.at, arm], 0.7))
    };
    // Beside a piece parallel to an axis, otherwise between the two corners.
    let [level, upright] = [arm(is_along_z), arm(is_along_x)];
    let at = |own: Option<Point>| own.or(Some(corner.at).filter(|_| corner.is_sharp()));
    let radial = at(level).map(|at| match level {
        Some(_) => [at, Point::new(at.x - x, at.z)],
        None => [at, finished(at)],
    });
    let axial = at(upright).map(|at| match upright {
        Some(_) => [at, Point::new(at.x, at.z - z)],
        None => [at, finished(at)],
    });
    let dimensions = [(radial.map(Shape::Radial), "Δu/2", x), (axial.map(Shape::Axial), "Δw", z)].into_iter();
    let shown = dimensions.filter_map(|(shape, name, mm)| Some((shape?, name, mm)));
    let mut annotations: Vec<Annotation> = shown
        .filter(|(shape, ..)| shape.is_visible())
        .map(|(shape, name, mm)| Annotation::dimension(shape, name, Measure::Length(mm)))
        .collect();
    all.retain(|own| !annotations.iter().any(|shown| shown.label.name == own.label.name));
    // The last roughing pass is step ⑥ of G71 and G72, pass d of G73.
    let name = if call.cycle == Cycle::Pattern { "d" } else { NUMBERS[5] };
    annotations.push(Annotation::step([corner.at, before], name));
    annotations.push(Annotation::step([corner.at, after].map(finished), "A′–B"));
    let detail = Detail {
        at: corner.at,
        radius: reach,
        edges: vec![edge, rough],
        part: vec![part],
        annotations,
        ..Detail::default()
    };
    all.push(Annotation::detail(detail));
}

/// Moves a point that is indistinguishable from the start A, which is C of G71 and G72 and D of G73, to a detail: with the
/// moves to it and from it, and its distances.
pub fn add_start(call: &Call, all: &mut Vec<Annotation>) {
    let name = match call.cycle {
        Cycle::RoughTurning | Cycle::RoughFacing => "C",
        Cycle::Pattern => "D",
        _ => return,
    };
    let (start, bounds) = (call.start(), call.bounds());
    let least = NEAR_START * bounds.length().max(bounds.height());
    let place = |own: &Annotation| match own.shape {
        Shape::Point(at) if (SAME_DEPTH..least).contains(&at.distance(start)) => Some(at),
        _ => None,
    };
    let Some(at) = all.iter().filter(|own| own.label.name == name).find_map(place) else { return };
    let reach = at.distance(start);
    let piece = |motion: &Motion, from: Point, to: Point| {
        let share = (LONGEST_AT_START * reach / from.distance(to)).min(1.0);
        (motion.kind, [from, at_share([from, to], share)])
    };
    let to = call.steps(Step::Approach).find(|motion| motion.to.is_same(at));
    let from = call.steps(Step::Infeed).find(|motion| motion.from.is_same(at));
    let ways =
        [to.map(|motion| piece(motion, at, motion.from)), from.map(|motion| piece(motion, at, motion.to))];
    let ways = ways.into_iter().flatten();
    let (rapids, cuts): (Vec<_>, Vec<_>) = ways.partition(|(kind, _)| *kind == MotionKind::Rapid);
    let across = Shape::Radial([at, Point::new(start.x, at.z)]);
    let along = Shape::Axial([at, Point::new(at.x, start.z)]);
    let mut annotations = vec![Annotation::point(start, "A"), Annotation::point(at, name)];
    let distances = [(across, "Δu/2", at.x - start.x), (along, "Δw", at.z - start.z)].into_iter();
    let shown = distances.filter(|(shape, ..)| shape.is_visible());
    annotations
        .extend(shown.map(|(shape, name, mm)| Annotation::dimension(shape, name, Measure::Length(mm))));
    let is_inside = |own: &Annotation| match own.shape {
        Shape::Point(place) => place.is_same(at),
        Shape::Step([from, to]) => from.is_same(start) && to.is_same(at),
        _ => false,
    };
    annotations
        .extend(all.iter().filter(|own| is_inside(own) && matches!(own.shape, Shape::Step(_))).cloned());
    all.retain(|own| !is_inside(own));
    let detail = Detail {
        at: start,
        radius: 1.5 * reach,
        edges: cuts.into_iter().map(|(_, ends)| ends.to_vec()).collect(),
        rapids: rapids.into_iter().map(|(_, ends)| ends).collect(),
        annotations,
        ..Detail::default()
    };
    all.push(Annotation::detail(detail));
}

/// Two straight pieces of a contour that meet, or one piece with a point on it.
struct Corner {
    before: Point,
    at: Point,
    after: Point,
}

impl Corner {
    /// The corner that shows an allowance best: between pieces along both axes, or else at a piece along an axis, or
    /// else any corner, the one with the longest pieces; or else the middle of a piece along an axis.
    fn best(pieces: &[&Motion]) -> Option<Self> {
        let corners = pieces.windows(2).filter(|pair| pair[0].to.is_same(pair[1].from));
        let corners = corners.map(|pair| Self { before: pair[0].from, at: pair[0].to, after: pair[1].to });
        let along = |corner: &Self| {
            let arms = corner.arms().map(|arm| [corner.at, arm]);
            let is_along = |along: fn([Point; 2]) -> bool| usize::from(arms.into_iter().any(along));
            is_along(is_along_x) + is_along(is_along_z)
        };
        let shortest = |corner: &Self| {
            corner.arms().map(|arm| arm.distance(corner.at)).into_iter().fold(f64::INFINITY, f64::min)
        };
        let sharp = corners.max_by(|a, b| along(a).cmp(&along(b)).then(shortest(a).total_cmp(&shortest(b))));
        sharp.or_else(|| {
            let ends = pieces.iter().map(|motion| [motion.from, motion.to]);
            let lands = ends.filter(|ends| is_along_x(*ends) || is_along_z(*ends));
            let longest = lands.max_by(|a, b| a[0].distance(a[1]).total_cmp(&b[0].distance(b[1])));
            longest.map(|[before, after]| Self { before, at: at_share([before, after], 0.5), after })
        })
    }

    fn arms(&self) -> [Point; 2] {
        [self.before, self.after]
    }

    /// Whether its pieces have different directions.
    fn is_sharp(&self) -> bool {
        let middle = at_share(self.arms(), self.at.distance(self.before) / self.before.distance(self.after));
        middle.distance(self.at) > SAME_DEPTH
    }
}

fn is_along_x([from, to]: [Point; 2]) -> bool {
    (to.z - from.z).abs() < SAME_DEPTH
}

fn is_along_z([from, to]: [Point; 2]) -> bool {
    (to.x - from.x).abs() < SAME_DEPTH
}

/// Replaces the depths of the passes of G76 by a detail of the groove with each pass, the infeed law √n.
pub fn add_infeed(call: &Call, all: &mut Vec<Annotation>) {
    if call.cycle != Cycle::MultiThreading {
        return;
    }
    let leads = call.last(Step::Cut).map_or(0.0, leads_to_middle);
    // A taper thread has no single diameter.
    let straight = call.last(Step::Cut).filter(|cut| (cut.from.x - cut.to.x).abs() < SAME_DEPTH);
    if let (Some(height), Some(last)) = (length_of(all, "k"), straight) {
        let out = (call.home() - last.from.x).signum();
        let crest = after_leads(*last, leads).from.moved(Point::new(out * height, 0.0));
        let diameter = Measure::Diameter(Diameter::from_radius(crest.x).mm());
        all.push(Annotation::dimension(Shape::Diameter(crest), "", diameter));
    }
    let cuts: Vec<Motion> = call.steps(Step::Cut).map(|cut| after_leads(*cut, leads)).collect();
    let Some(detail) = infeed(all, &cuts, call.home()) else { return };
    all.retain(|annotation| !DEPTHS.contains(&annotation.label.name));
    all.push(Annotation::detail(detail));
}

/// The number of whole leads in the first half of a cut of a thread.
fn leads_to_middle(cut: &Motion) -> f64 {
    let lead = cut.lead.unwrap_or_default().abs();
    if lead < SAME_DEPTH { 0.0 } else { (0.5 * cut.length() / lead).floor() }
}

/// A cut of a thread from a later groove: at its start there is no material.
fn after_leads(cut: Motion, leads: f64) -> Motion {
    let along = leads * cut.lead.unwrap_or_default().abs();
    if along < SAME_DEPTH || along > cut.length() {
        return cut;
    }
    Motion { from: at_share([cut.from, cut.to], along / cut.length()), ..cut }
}

/// The groove of a thread with the edges of each pass, the last ones thick, and its depths: `Δd` of the first, `Δd√2` of
/// the second, `Δd√n` with its number n of the last one that follows this law, then the least infeed and the allowance.
/// `home`: X of the start of the cycle, a radius, mm.
fn infeed(all: &[Annotation], cuts: &[Motion], home: f64) -> Option<Detail> {
    let length = |name: &str| length_of(all, name);
    let height = length("k")?;
    let half = all.iter().find(|own| own.label.name == "a").map_or(0.0, |own| match own.label.value {
        Some(Measure::Degrees(degrees)) => (degrees / 2.0).to_radians(),
        _ => 0.0,
    });
    let (first, last) = (cuts.first()?.from, cuts.last()?.from);
    let above = if (first.x - last.x).abs() > SAME_DEPTH { first.x } else { home };
    let out = (above - last.x).signum();
    let crest = last.x + out * height;
    let mut tips: Vec<Point> = Vec::new();
    for cut in cuts.iter().take(MAX_PASSES) {
        if tips.last().is_none_or(|tip| (tip.x - cut.from.x).abs() > SAME_DEPTH) {
            tips.push(cut.from);
        }
    }
    let depth = |tip: &Point| (crest - tip.x).abs();
    let reach = |tip: &Point| depth(tip) * half.tan();
    let mut edges: Vec<Vec<Point>> = tips
        .iter()
        .map(|tip| {
            let [right, left] = [1.0, -1.0].map(|side| Point::new(crest, tip.z + side * reach(tip)));
            vec![left, *tip, right]
        })
        .collect();
    let ends: Vec<f64> = edges.iter().flatten().map(|at| at.z).collect();
    let right = ends.iter().copied().fold(f64::MIN, f64::max) + 0.3 * height;
    let left = ends.iter().copied().fold(f64::MAX, f64::min) - 0.3 * height;
    let mut lines = vec![vec![Point::new(crest, left), Point::new(crest, right)]];
    lines.extend(edges.drain(..edges.len() - 1));
    let from_crest = |tip: &Point, name: &'static str, value: Measure| {
        Annotation::dimension(Shape::Radial([Point::new(crest, tip.z), *tip]), name, value)
    };
    let between = |pair: &[Point], name: &'static str| {
        let shape = Shape::Radial([Point::new(pair[0].x, pair[1].z), pair[1]]);
        Annotation::dimension(shape, name, Measure::Length((pair[0].x - pair[1].x).abs()))
    };
    let mut annotations = vec![from_crest(&last, "k", Measure::Length(height))];
    if let Some(step) = length("Δd") {
        let follows =
            |number: usize, tip: &Point| (depth(tip) - step * (number as f64).sqrt()).abs() < SAME_DEPTH;
        let law = (1..).zip(&tips).filter(|(number, tip)| follows(*number, tip));
        let law: Vec<(usize, &Point)> = law.collect();
        let of_pass = |(number, tip): &(usize, &Point)| {
            let value = match number {
                1 => Measure::Length(depth(tip)),
                _ => Measure::Root(*number, depth(tip)),
            };
            from_crest(tip, "Δd", value)
        };
        annotations.extend(law.iter().take(2).map(of_pass));
        annotations.extend(law.get(2..).and_then(<[_]>::last).map(of_pass));
    }
    if let Some(least) = length("Δd min") {
        let is_least = |pair: &&[Point]| ((pair[0].x - pair[1].x).abs() - least).abs() < SAME_DEPTH;
        // The last infeed is the finishing allowance, which may be as large.
        let before_last = &tips[..tips.len().saturating_sub(1)];
        annotations.extend(before_last.windows(2).find(is_least).map(|pair| between(pair, "Δd min")));
    }
    if length("d").is_some() {
        annotations.extend(tips.windows(2).last().map(|pair| between(pair, "d")));
    }
    if half > 0.0 {
        let arm = |side: f64| Point::new(crest, last.z + side * reach(&last));
        let shape = Shape::Angle { vertex: last, base: arm(1.0), end: arm(-1.0) };
        annotations.push(Annotation::dimension(shape, "a", Measure::Degrees(2.0 * half.to_degrees())));
        // The infeed is along the flank on the side of the start; above the crest there is room for its angle.
        let side = if cuts.first()?.from.z >= cuts.first()?.to.z { 1.0 } else { -1.0 };
        let vertex = Point::new(crest, last.z + side * reach(&last));
        let above = crest + 0.3 * out * height;
        let base = Point::new(above, vertex.z);
        let end = Point::new(above, vertex.z + side * 0.3 * height * half.tan());
        let shape = Shape::Angle { vertex, base, end };
        annotations.push(Annotation::dimension(shape, "a/2", Measure::Degrees(half.to_degrees())));
    }
    let at = Point::new((crest + last.x) / 2.0, (left + right) / 2.0);
    Some(Detail {
        at,
        radius: ((right - left) / 2.0).max(0.6 * height),
        lines,
        edges,
        annotations,
        ..Detail::default()
    })
}
