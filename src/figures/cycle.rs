//! The figure of a cycle, as in manuals: its letters, the dimension of each of its words, its steps.
//!
//! In: the blocks of the cycle with their execution, and the motions. Out: annotations. Points are named as in
//! FANUC B-64304 and GSK 980TD: A start, B and C the ends of the cut, A′ and B the ends of a contour.

use crate::assist::Query;
use crate::control::contour::Landmarks;
use crate::geometry::Point;
use crate::motion::{Cycle, Motion, Motions, Step};
use crate::scene::annotation::{Annotation, Detail, Importance, Label, Measure, Shape};
use crate::source::Span;

/// The steps of a single cycle.
const STEPS: [(Step, &str); 4] =
    [(Step::Infeed, "①"), (Step::Cut, "②"), (Step::Retract, "③"), (Step::Return, "④")];

/// The letters of a cycle, and the steps of a single cycle. `landmarks`: the named points of all contours of the run.
pub fn letters(asked: &Query, motions: &Motions, landmarks: &[Landmarks]) -> Vec<Annotation> {
    let Some(visit) = asked.visit.filter(|visit| !visit.motions.is_empty()) else { return Vec::new() };
    let own: Vec<Motion> =
        visit.motions.clone().take(MAX_MOTIONS).map(|index| motions.get_on_workpiece(index)).collect();
    let Some(cycle) = own[0].cycle.map(|step| step.cycle) else { return Vec::new() };
    let step = |wanted: Step| own.iter().find(|motion| motion.cycle.is_some_and(|own| own.step == wanted));
    let last = |wanted: Step| own.iter().rfind(|motion| motion.cycle.is_some_and(|own| own.step == wanted));
    let start = own[0].from;
    let mut points = vec![(start, "A")];
    let mut steps = Vec::new();
    match cycle {
        Cycle::Turning | Cycle::Facing | Cycle::Threading => {
            points.extend(step(Step::Cut).map(|cut| (cut.from, "B")));
            points.extend(step(Step::Cut).map(|cut| (cut.to, "C")));
            points.extend(step(Step::Retract).map(|retract| (retract.to, "D")));
            for (wanted, name) in STEPS {
                let motion = step(wanted).filter(|motion| motion.length() > 0.0);
                steps.extend(motion.map(|motion| Annotation::step([motion.from, motion.to], name)));
            }
        }
        Cycle::RoughTurning | Cycle::RoughFacing | Cycle::Pattern | Cycle::Finishing => {
            let block = asked.block.span;
            let is_own = |span: Span| block.start <= span.start && span.end <= block.end;
            if let Some(found) = landmarks.iter().find(|found| is_own(found.span)) {
                points.push((found.first.moved(found.zero), "A′"));
                points.push((found.last.moved(found.zero), "B"));
            }
            points.extend(step(Step::Approach).map(|approach| (approach.to, "C")));
        }
        Cycle::FacePecking | Cycle::Grooving => {
            let cut = |motion: Option<&Motion>| motion.map(|cut| cut.to);
            if let (Some(first), Some(deepest)) = (step(Step::Cut), cut(last(Step::Cut))) {
                let side = if cycle == Cycle::Grooving {
                    Point::new(first.from.x, deepest.z)
                } else {
                    Point::new(deepest.x, first.from.z)
                };
                points.push((side, "B"));
                points.push((deepest, "C"));
            }
        }
        Cycle::MultiThreading => {
            points.extend(step(Step::Cut).map(|cut| (cut.from, "B")));
            points.extend(last(Step::Cut).map(|cut| (cut.from, "C")));
            points.extend(last(Step::Cut).map(|cut| (cut.to, "D")));
            points.extend(last(Step::Retract).map(|retract| (retract.to, "E")));
        }
        _ => {}
    }
    let mut named: Vec<Annotation> = Vec::new();
    for (at, name) in points {
        let is_taken = named.iter().any(|other| match other.shape {
            Shape::Point(place) => place.is_same(at),
            _ => false,
        });
        if !is_taken {
            named.push(Annotation::point(at, name));
        }
    }
    named.extend(steps);
    named
}

/// The dimensions of all words of a block.
pub fn dimensions(asked: &Query, motions: &Motions) -> Vec<Annotation> {
    let mut all: Vec<Annotation> = Vec::new();
    for word in asked.block.words.iter().filter(|word| !b"GMNOST".contains(&word.address)) {
        let hover = asked.hover(word.span.start, &[], motions);
        for annotation in hover.map_or_else(Vec::new, |hover| asked.annotations(&hover, motions)) {
            let own = Annotation { importance: Importance::Usual, ..annotation };
            if !all.contains(&own) {
                all.push(own);
            }
        }
    }
    all
}

/// Replaces the depths of the passes of G76 by a detail of the groove with each pass, the infeed law √n.
pub fn with_detail(mut all: Vec<Annotation>, asked: &Query, motions: &Motions) -> Vec<Annotation> {
    let own = asked.visit.map_or(0..0, |visit| visit.motions.clone());
    let cuts: Vec<Motion> = own
        .take(MAX_MOTIONS)
        .map(|index| motions.get_on_workpiece(index))
        .filter(|motion| {
            motion.cycle.is_some_and(|own| own.cycle == Cycle::MultiThreading && own.step == Step::Cut)
        })
        .collect();
    let Some(detail) = infeed(&all, &cuts) else { return all };
    all.retain(|annotation| !DEPTHS.contains(&annotation.label.name));
    let label = Label::default();
    all.push(Annotation { shape: Shape::Detail(Box::new(detail)), label, importance: Importance::Usual });
    all
}

/// The dimensions of G76 that a detail shows.
const DEPTHS: [&str; 5] = ["k", "Δd", "Δd min", "d", "a"];

/// The groove of a thread with the edges of each pass, and its depths: `Δd` of the first, `Δd√2` of the second,
/// `Δd√n` of the last one that follows this law, then the least infeed and the allowance.
fn infeed(all: &[Annotation], cuts: &[Motion]) -> Option<Detail> {
    let value = |name: &str| all.iter().find(|own| own.label.name == name)?.label.value;
    let length = |name: &str| match value(name) {
        Some(Measure::Length(mm)) => Some(mm),
        _ => None,
    };
    let height = length("k")?;
    let half = match value("a") {
        Some(Measure::Degrees(degrees)) => (degrees / 2.0).to_radians(),
        _ => 0.0,
    };
    let (first, last) = (cuts.first()?.from, cuts.last()?.from);
    let out = (first.x - last.x).signum();
    let crest = last.x + out * height;
    let mut tips: Vec<Point> = Vec::new();
    for cut in cuts.iter().take(MAX_PASSES) {
        if tips.last().is_none_or(|tip| (tip.x - cut.from.x).abs() > SAME_DEPTH) {
            tips.push(cut.from);
        }
    }
    let depth = |tip: &Point| (crest - tip.x).abs();
    let reach = |tip: &Point| depth(tip) * half.tan();
    let mut lines: Vec<Vec<Point>> = tips
        .iter()
        .map(|tip| {
            let [right, left] = [1.0, -1.0].map(|side| Point::new(crest, tip.z + side * reach(tip)));
            vec![left, *tip, right]
        })
        .collect();
    let ends: Vec<f64> = lines.iter().flatten().map(|at| at.z).collect();
    let right = ends.iter().copied().fold(f64::MIN, f64::max) + 0.3 * height;
    let left = ends.iter().copied().fold(f64::MAX, f64::min) - 0.3 * height;
    lines.push(vec![Point::new(crest, left), Point::new(crest, right)]);
    let from_crest = |tip: &Point, name: &'static str| {
        let shape = Shape::Radial([Point::new(crest, tip.z), *tip]);
        Annotation::dimension(shape, name, Measure::Length(depth(tip)))
    };
    let between = |pair: &[Point], name: &'static str| {
        let shape = Shape::Radial([Point::new(pair[0].x, pair[1].z), pair[1]]);
        Annotation::dimension(shape, name, Measure::Length((pair[0].x - pair[1].x).abs()))
    };
    let mut annotations = vec![from_crest(&last, "k")];
    if let Some(step) = length("Δd") {
        let follows =
            |index: usize, tip: &Point| (depth(tip) - step * (index as f64 + 1.0).sqrt()).abs() < SAME_DEPTH;
        let law: Vec<&Point> =
            tips.iter().enumerate().filter(|(index, tip)| follows(*index, tip)).map(|(_, tip)| tip).collect();
        annotations.extend(law.first().map(|tip| from_crest(tip, "Δd")));
        annotations.extend(law.get(1).map(|tip| from_crest(tip, "Δd√2")));
        annotations.extend(law.get(2..).and_then(<[_]>::last).map(|tip| from_crest(tip, "Δd√n")));
    }
    if let Some(least) = length("Δd min") {
        let is_least = |pair: &&[Point]| ((pair[0].x - pair[1].x).abs() - least).abs() < SAME_DEPTH;
        annotations.extend(tips.windows(2).find(is_least).map(|pair| between(pair, "Δd min")));
    }
    if length("d").is_some() {
        annotations.extend(tips.windows(2).last().map(|pair| between(pair, "d")));
    }
    if half > 0.0 {
        let arm = |side: f64| Point::new(crest, last.z + side * reach(&last));
        let shape = Shape::Angle { vertex: last, base: arm(1.0), end: arm(-1.0) };
        annotations.push(Annotation::dimension(shape, "a", Measure::Degrees(2.0 * half.to_degrees())));
    }
    let at = Point::new((crest + last.x) / 2.0, (left + right) / 2.0);
    Some(Detail { at, radius: ((right - left) / 2.0).max(0.6 * height), lines, annotations })
}

/// Depths that differ by less, mm, are the same.
const SAME_DEPTH: f64 = 1e-3;
/// Maximum number of passes in a detail.
const MAX_PASSES: usize = 60;
/// Maximum number of motions of a cycle that are looked at.
const MAX_MOTIONS: usize = 20_000;
