//! The figure of a cycle, as in manuals: its letters, the dimension of each of its words, its steps.
//!
//! In: the blocks of the cycle with their execution, and the motions. Out: annotations. Points are named as in
//! FANUC B-64304 and GSK 980TD: A start, B and C the ends of the cut, A′ and B the ends of a contour.

use std::ops::Range;

use super::NUMBERS;
use crate::assist::Query;
use crate::control::contour::Landmarks;
use crate::geometry::{Point, at_share};
use crate::motion::{Cycle, Motion, Motions, Step};
use crate::scene::annotation::{Annotation, Detail, Importance, Measure, Shape};
use crate::source::Span;

/// The steps of a single cycle.
const STEPS: [Step; 4] = [Step::Infeed, Step::Cut, Step::Retract, Step::Return];

/// A call of a cycle.
pub struct Call {
    /// Index of its first motion.
    pub first: usize,
    cycle: Cycle,
    /// Its motions on the workpiece, at most [`MAX_MOTIONS`]; at least one.
    own: Vec<Motion>,
}

impl Call {
    /// The call in a block; `None` if the block makes no motions of a cycle.
    pub fn of(asked: &Query, motions: &Motions) -> Option<Self> {
        let range = asked.visit?.motions.clone();
        let first = range.start;
        let own: Vec<Motion> = range.take(MAX_MOTIONS).map(|index| motions.get_on_workpiece(index)).collect();
        Some(Self { first, cycle: own.first()?.cycle?.cycle, own })
    }

    /// The motions of a step.
    fn steps(&self, step: Step) -> impl DoubleEndedIterator<Item = &Motion> {
        self.own.iter().filter(move |motion| motion.cycle.is_some_and(|own| own.step == step))
    }

    /// The first motion of a step.
    fn step(&self, step: Step) -> Option<&Motion> {
        self.steps(step).next()
    }

    /// The last motion of a step.
    fn last(&self, step: Step) -> Option<&Motion> {
        self.steps(step).next_back()
    }

    /// The letters of the cycle, and the steps of a single cycle. `block`: its block; `landmarks`: the named points of
    /// all contours of the run.
    pub fn letters(&self, block: Span, landmarks: &[Landmarks]) -> Vec<Annotation> {
        let (step, last) = (|step: Step| self.step(step), |step: Step| self.last(step));
        let start = self.own[0].from;
        let mut points = vec![(start, "A")];
        let mut steps = Vec::new();
        match self.cycle {
            Cycle::Turning | Cycle::Facing | Cycle::Threading => {
                points.extend(step(Step::Cut).map(|cut| (cut.from, "B")));
                points.extend(step(Step::Cut).map(|cut| (cut.to, "C")));
                // A pull-out may end at the height of the start.
                let out = step(Step::Retract).or_else(|| step(Step::PullOut));
                points.extend(out.map(|out| (out.to, "D")));
                for (wanted, name) in STEPS.into_iter().zip(NUMBERS) {
                    let motion = step(wanted).filter(|motion| motion.length() > 0.0);
                    steps.extend(motion.map(|motion| Annotation::step([motion.from, motion.to], name)));
                }
            }
            Cycle::RoughTurning | Cycle::RoughFacing | Cycle::Pattern | Cycle::Finishing => {
                let is_own = |span: Span| block.start <= span.start && span.end <= block.end;
                if let Some(found) = landmarks.iter().find(|found| is_own(found.span)) {
                    points.push((found.first.moved(found.zero), "A′"));
                    points.push((found.last.moved(found.zero), "B"));
                }
                points.extend(step(Step::Approach).map(|approach| (approach.to, "C")));
            }
            // B has the X, C the Z of the end point D.
            Cycle::FacePecking | Cycle::Grooving => {
                if let Some(end) = last(Step::Cut).map(|cut| cut.to) {
                    points.push((Point::new(end.x, start.z), "B"));
                    points.push((Point::new(start.x, end.z), "C"));
                    points.push((end, "D"));
                }
            }
            // D is the programmed end point; a chamfer leaves the thread before it.
            Cycle::MultiThreading => {
                points.extend(step(Step::Cut).map(|cut| (cut.from, "B")));
                points.extend(last(Step::Cut).map(|cut| (cut.from, "C")));
                let out = last(Step::Retract).or_else(|| last(Step::PullOut));
                if let Some((cut, out)) = last(Step::Cut).zip(out) {
                    points.push((Point::new(cut.to.x, out.to.z), "D"));
                    points.push((out.to, "E"));
                }
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

    /// The distances from A to C: U/2 and W of a single cycle, also if the block has X and Z; in the pattern of G73 the
    /// relief with the allowance. `all`: the annotations of the block, which may have them already.
    pub fn distances(&self, all: &[Annotation]) -> Vec<Annotation> {
        let (names, end) = match self.cycle {
            Cycle::Turning | Cycle::Facing | Cycle::Threading => (["U/2", "W"], self.step(Step::Cut)),
            Cycle::Pattern => (["Δi + Δu/2", "Δk + Δw"], self.step(Step::Approach)),
            _ => return Vec::new(),
        };
        let out = self.step(Step::Retract).or_else(|| self.step(Step::PullOut));
        let word = all.iter().find_map(|own| match own.label.value {
            Some(Measure::Coordinate('Z', z)) => Some(z),
            _ => None,
        });
        let z = word.or(out.map(|out| out.to.z));
        let Some(end) = end.map(|cut| programmed_end(cut, z)) else { return Vec::new() };
        let start = self.own[0].from;
        let (x, z) = (end.x - start.x, end.z - start.z);
        // Beside the end of the cut, and above the way back: there are no other strokes.
        let across = Shape::Radial([Point::new(start.x, end.z), end]);
        let shapes = [(across, x), (Shape::Axial([start, Point::new(start.x, end.z)]), z)];
        let missing = names.into_iter().zip(shapes).filter(|(name, (shape, _))| {
            shape.is_visible() && !all.iter().any(|other| other.label.name == *name)
        });
        missing.map(|(name, (shape, mm))| Annotation::dimension(shape, name, Measure::Length(mm))).collect()
    }

    /// Numbers the passes of G73, whose number is no length: `1` at the first one, `d = 10` at the last one.
    pub fn add_pass_numbers(&self, all: &mut Vec<Annotation>) {
        let is_count = |own: &Annotation| matches!(own.label.value, Some(Measure::Count(_)));
        let Some(count) = all.iter().find(|own| is_count(own)).map(|own| own.label.clone()) else { return };
        let longest = |pass: u32| {
            let own = self.steps(Step::Contour);
            let own = own.filter(|motion| motion.arc().is_none() && pass_of(motion) == pass);
            own.max_by(|a, b| a.length().total_cmp(&b.length()))
        };
        let numbers = || self.steps(Step::Contour).map(pass_of);
        let ends = [numbers().min(), numbers().max()].map(|pass| longest(pass?));
        let [Some(first), Some(last)] = ends else { return };
        all.retain(|own| !is_count(own) && own.label.name != "Δi" && own.label.name != "Δk");
        all.push(Annotation::step([first.from, first.to], "1"));
        let shape = Shape::Step([last.from, last.to]);
        all.push(Annotation { shape, label: count, importance: Importance::Usual });
    }

    /// Replaces the allowances of roughing, which are too small to be seen, by a detail of a corner of the contour: the
    /// last roughing pass and the finished contour.
    pub fn add_allowance(&self, all: &mut Vec<Annotation>) {
        let [x, z] = ["Δu/2", "Δw"].map(|name| length_of(all, name).unwrap_or(0.0));
        let largest = x.abs().max(z.abs());
        let last = self.last(Step::Contour).map_or(0, pass_of);
        let pieces: Vec<&Motion> =
            self.steps(Step::Contour).filter(|motion| pass_of(motion) == last).collect();
        // Only a corner between two axes shows both.
        let along_x = |motion: &Motion| (motion.to.z - motion.from.z).abs() < SAME_DEPTH;
        let along_z = |motion: &Motion| (motion.to.x - motion.from.x).abs() < SAME_DEPTH;
        let is_corner = |pair: &&[&Motion]| {
            let [one, other] = [pair[0], pair[1]];
            let is_straight = one.arc().is_none() && other.arc().is_none();
            is_straight && (along_x(one) && along_z(other) || along_z(one) && along_x(other))
        };
        let shortest = |pair: &[&Motion]| pair[0].length().min(pair[1].length());
        let corners = pieces.windows(2).filter(is_corner);
        let Some(pair) = corners.max_by(|a, b| shortest(a).total_cmp(&shortest(b))) else { return };
        let reach = shortest(pair).min(4.0 * largest);
        if largest < SAME_DEPTH || reach < 2.0 * largest {
            return;
        }
        let corner = pair[0].to;
        let arm = |motion: &Motion, end: Point| at_share([corner, end], reach / motion.length());
        let arms = [arm(pair[0], pair[0].from), arm(pair[1], pair[1].to)];
        let finished = |at: Point| Point::new(at.x - x, at.z - z);
        let rough = vec![arms[0], corner, arms[1]];
        let lines = vec![rough.iter().copied().map(finished).collect(), rough];
        let [level, upright] = if along_z(pair[0]) { arms } else { [arms[1], arms[0]] };
        let [level, upright] = [level, upright].map(|end| at_share([corner, end], 0.7));
        let dimensions = [
            (Shape::Radial([level, Point::new(level.x - x, level.z)]), "Δu/2", x),
            (Shape::Axial([upright, Point::new(upright.x, upright.z - z)]), "Δw", z),
        ];
        let dimensions = dimensions.into_iter().filter(|(shape, ..)| shape.is_visible());
        let annotations: Vec<Annotation> = dimensions
            .map(|(shape, name, mm)| Annotation::dimension(shape, name, Measure::Length(mm)))
            .collect();
        all.retain(|own| own.label.name != "Δu/2" && own.label.name != "Δw");
        let detail = Detail { at: corner, radius: reach, lines, annotations };
        all.push(Annotation::detail(detail));
    }

    /// Replaces the depths of the passes of G76 by a detail of the groove with each pass, the infeed law √n.
    pub fn add_infeed(&self, all: &mut Vec<Annotation>) {
        if self.cycle != Cycle::MultiThreading {
            return;
        }
        let cuts: Vec<Motion> = self.steps(Step::Cut).copied().collect();
        let Some(detail) = infeed(all, &cuts, self.own[0].from.x) else { return };
        all.retain(|annotation| !DEPTHS.contains(&annotation.label.name));
        all.push(Annotation::detail(detail));
    }
}

/// The programmed end of a cut. A thread is left before it; `z`: the Z of its end.
fn programmed_end(cut: &Motion, z: Option<f64>) -> Point {
    let is_thread = cut.cycle.is_some_and(|step| step.cycle == Cycle::Threading);
    let length = cut.to.z - cut.from.z;
    match z.filter(|_| is_thread && length.abs() > SAME_DEPTH) {
        Some(z) => at_share([cut.from, cut.to], (z - cut.from.z) / length),
        None => cut.to,
    }
}

fn pass_of(motion: &Motion) -> u32 {
    motion.cycle.map_or(0, |own| own.pass)
}

/// The length that a named annotation shows, mm.
fn length_of(all: &[Annotation], name: &str) -> Option<f64> {
    match all.iter().find(|own| own.label.name == name)?.label.value {
        Some(Measure::Length(mm)) => Some(mm),
        _ => None,
    }
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

/// The dimensions of G76 that a detail shows.
const DEPTHS: [&str; 5] = ["k", "Δd", "Δd min", "d", "a"];

/// The groove of a thread with the edges of each pass, and its depths: `Δd` of the first, `Δd√2` of the second,
/// `Δd√n` of the last one that follows this law, then the least infeed and the allowance.
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
    }
    let at = Point::new((crest + last.x) / 2.0, (left + right) / 2.0);
    Some(Detail { at, radius: ((right - left) / 2.0).max(0.6 * height), lines, annotations })
}

/// The motions of the figure of a cycle: its call at `first`, adjacent calls of the same cycle, and finishing after
/// roughing.
pub fn shown(motions: &Motions, first: usize) -> Vec<Range<usize>> {
    let cycle = |index: usize| motions.get(index).cycle.map(|step| step.cycle);
    let own = cycle(first);
    let end_of = |from: usize, own: Option<Cycle>| {
        let end = motions.len().min(from + MAX_MOTIONS);
        (from..end).find(|&index| cycle(index) != own).unwrap_or(end)
    };
    let before = (first.saturating_sub(MAX_MOTIONS)..first).rev().take_while(|&index| cycle(index) == own);
    let calls = before.last().unwrap_or(first)..end_of(first, own);
    let finishing = match own {
        Some(Cycle::RoughTurning | Cycle::RoughFacing | Cycle::Pattern) => {
            let end = motions.len().min(calls.end + MAX_MOTIONS);
            let next = (calls.end..end).find(|&index| cycle(index).is_some());
            next.filter(|&index| cycle(index) == Some(Cycle::Finishing))
        }
        _ => None,
    };
    let finishing = finishing.map(|index| index..end_of(index, Some(Cycle::Finishing)));
    [calls].into_iter().chain(finishing).collect()
}

/// Depths that differ by less, mm, are the same.
const SAME_DEPTH: f64 = 1e-3;
/// Maximum number of passes in a detail.
const MAX_PASSES: usize = 60;
/// Maximum number of motions of a cycle that are looked at.
const MAX_MOTIONS: usize = 20_000;
