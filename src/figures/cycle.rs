//! The figure of a cycle, as in manuals: its letters, the dimension of each of its words, its steps.
//!
//! In: the blocks of the cycle with their execution, and the motions. Out: annotations. Points are named as in
//! FANUC B-64304 and GSK 980TD: A start, B and C the ends of the cut, A′ and B the ends of a contour. G94 has the letters
//! of seed 004, G74 and G75 have the letters of seed 003. Details are in `details`.

use std::ops::Range;

use super::NUMBERS;
use crate::assist::Query;
use crate::control::contour::Landmarks;
use crate::cycles::single::{Single, cuts_along_x};
use crate::cycles::threading::{LEAD_ERROR, run_in, run_out};
use crate::geometry::bounds::Bounds;
use crate::geometry::{Point, at_share, nearest_on};
use crate::motion::{Cycle, CycleFamily, Motion, Motions, SpindleSpeed, Step};
use crate::scene::annotation::{Annotation, Importance, Label, Measure, Shape};
use crate::source::Span;

/// Of fewer roughing passes the first one has the numbers of the steps.
const FEW_PASSES: u32 = 6;

/// A call of a cycle.
pub struct Call {
    /// Index of its first motion.
    pub first: usize,
    /// Its cycle.
    pub cycle: Cycle,
    /// The last cut of a single cycle in its adjacent calls, which finishes the part.
    pub finish: Option<Motion>,
    /// Its motions on the workpiece, at most [`MAX_MOTIONS`]; at least one.
    own: Vec<Motion>,
}

impl Call {
    /// The call in a block; `None` if the block makes no motions of a cycle.
    pub fn of(asked: &Query, motions: &Motions) -> Option<Self> {
        let range = asked.visit?.motions.clone();
        let first = range.start;
        let own: Vec<Motion> = range.take(MAX_MOTIONS).map(|index| motions.get_on_workpiece(index)).collect();
        let cycle = own.first()?.cycle?.cycle;
        let finish = Single::of(cycle).and_then(|_| {
            let mut all = calls(motions, first).rev().map(|index| motions.get_on_workpiece(index));
            all.find(|motion| is_step(motion, Step::Cut))
        });
        Some(Self { first, cycle, finish, own })
    }

    /// Its start.
    pub fn start(&self) -> Point {
        self.own[0].from
    }

    /// The box of its motions.
    pub fn bounds(&self) -> Bounds {
        self.own.iter().fold(Bounds::of(self.start()), |bounds, motion| bounds.with(motion.to))
    }

    /// X of its start, a radius, mm.
    pub fn home(&self) -> f64 {
        self.start().x
    }

    /// The motions of a step.
    pub fn steps(&self, step: Step) -> impl DoubleEndedIterator<Item = &Motion> {
        self.own.iter().filter(move |motion| motion.cycle.is_some_and(|own| own.step == step))
    }

    /// The first motion of a step.
    pub fn step(&self, step: Step) -> Option<&Motion> {
        self.steps(step).next()
    }

    /// The last motion of a step.
    pub fn last(&self, step: Step) -> Option<&Motion> {
        self.steps(step).next_back()
    }

    /// The motions of the numbered steps, as in the manual of the codes; `None` for a step that does not occur.
    fn numbered(&self) -> Vec<Option<&Motion>> {
        let step = |step: Step| self.step(step);
        let back = step(Step::Return).filter(|motion| pass_of(motion) > 0);
        let end = self.own.last().filter(|motion| is_step(motion, Step::Return) && pass_of(motion) == 0);
        let passes = || self.steps(Step::Contour).map(pass_of);
        let contour = |pass: Option<u32>| self.longest_of(pass?);
        match self.cycle {
            cycle if Single::of(cycle).is_some() => {
                [Step::Infeed, Step::Cut, Step::Retract, Step::Return].map(step).to_vec()
            }
            Cycle::RoughTurning | Cycle::RoughFacing => {
                let [approach, infeed] = [Step::Approach, Step::Infeed].map(step);
                let pass = self.plain_pass();
                let of_pass = |step: Step| self.steps(step).find(|motion| pass_of(motion) == pass);
                let [cut, escape, back] = [Step::Cut, Step::Escape, Step::Return].map(of_pass);
                // With e = Δd, only the return of the first pass is beside the cuts.
                let is_visible = |own: &&Motion| pass_of(own) > 0 && !self.is_under_cut(own);
                let back =
                    back.filter(is_visible).or_else(|| self.steps(Step::Return).find(is_visible)).or(back);
                vec![approach, infeed, cut, escape, back, contour(passes().next_back()), end]
            }
            Cycle::Pattern => {
                let next = self.steps(Step::Approach).nth(1);
                vec![step(Step::Approach), step(Step::Infeed), contour(passes().next()), next, end]
            }
            Cycle::FacePecking | Cycle::Grooving => {
                let [cut, retract, relief, over] =
                    [Step::Cut, Step::Retract, Step::Relief, Step::Stepover].map(step);
                vec![cut, retract, relief, back, over, end]
            }
            Cycle::MultiThreading => {
                [Step::Infeed, Step::Cut, Step::PullOut, Step::Retract, Step::Return].map(step).to_vec()
            }
            _ => Vec::new(),
        }
    }

    /// The pass on which the steps are numbered: of many passes one in the middle, because the first one is beside A, and
    /// beside the way back to it.
    fn plain_pass(&self) -> u32 {
        let count = self.last(Step::Cut).map_or(0, pass_of);
        if count < FEW_PASSES { 1 } else { count / 2 }
    }

    /// Whether the middle of a straight motion is on a cut.
    fn is_under_cut(&self, motion: &Motion) -> bool {
        let middle = at_share([motion.from, motion.to], 0.5);
        let is_over = |cut: &Motion| nearest_on([cut.from, cut.to], middle).distance(middle) < SAME_DEPTH;
        self.steps(Step::Cut).any(is_over)
    }

    /// The longest straight motion of a pass along the contour.
    fn longest_of(&self, pass: u32) -> Option<&Motion> {
        let own =
            self.steps(Step::Contour).filter(|motion| motion.arc().is_none() && pass_of(motion) == pass);
        own.max_by(|a, b| a.length().total_cmp(&b.length()))
    }

    /// The letters of the cycle. `block`: its block; `landmarks`: the named points of
    /// all contours of the run.
    pub fn letters(&self, block: Span, landmarks: &[Landmarks]) -> Vec<Annotation> {
        let (step, last) = (|step: Step| self.step(step), |step: Step| self.last(step));
        let start = self.start();
        let mut points = vec![(start, "A")];
        match self.cycle {
            cycle if Single::of(cycle).is_some() => {
                let [end, out] = if cuts_along_x(cycle) { ["E", "F"] } else { ["C", "D"] };
                points.extend(step(Step::Cut).map(|cut| (cut.from, "B")));
                points.extend(step(Step::Cut).map(|cut| (cut.to, end)));
                // A pull-out may end at the height of the start.
                let retract = step(Step::Retract).or_else(|| step(Step::PullOut));
                points.extend(retract.map(|retract| (retract.to, out)));
            }
            Cycle::RoughTurning | Cycle::RoughFacing | Cycle::Pattern | Cycle::Finishing => {
                let is_own = |span: Span| block.start <= span.start && span.end <= block.end;
                if let Some(found) = landmarks.iter().find(|found| is_own(found.span)) {
                    points.push((found.first.moved(found.zero), "A′"));
                    points.push((found.last.moved(found.zero), "B"));
                }
                points.extend(step(Step::Approach).map(|approach| (approach.to, "C")));
                if self.cycle == Cycle::Pattern {
                    points.extend(last(Step::Approach).map(|approach| (approach.to, "D")));
                }
            }
            // B is the end of the first row of columns, C the bottom of the first column; with D they are a rectangle.
            Cycle::FacePecking | Cycle::Grooving => {
                if let Some(end) = last(Step::Cut).map(|cut| cut.to) {
                    let has_x = Point::new(end.x, start.z);
                    let has_z = Point::new(start.x, end.z);
                    let [b, c] = if self.cycle == Cycle::Grooving { [has_z, has_x] } else { [has_x, has_z] };
                    points.extend([(b, "B"), (c, "C"), (end, "D")]);
                }
            }
            // D is the programmed end point; a chamfer leaves the thread before it.
            Cycle::MultiThreading => {
                points.extend(step(Step::Cut).map(|cut| (cut.from, "B")));
                points.extend(last(Step::Cut).map(|cut| (cut.from, "C")));
                let out = last(Step::Retract).or_else(|| last(Step::PullOut));
                if let Some((cut, out)) = last(Step::Cut).zip(out) {
                    points.push((programmed_end(cut, Some(out.to.z)), "D"));
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
        named
    }

    /// The numbers of the steps.
    pub fn step_numbers(&self) -> impl Iterator<Item = Annotation> {
        let numbered = self.numbered().into_iter().zip(NUMBERS);
        let moved =
            numbered.filter_map(|(motion, name)| Some((motion.filter(|own| own.length() > 0.0)?, name)));
        moved.map(|(motion, name)| Annotation::step([motion.from, motion.to], name))
    }

    /// The distances from A to C: U/2 and W of a single cycle, also if the block has X and Z; in the pattern of G73 the
    /// relief with the allowance. `all`: the annotations of the block, which may have them already.
    pub fn distances(&self, all: &[Annotation]) -> Vec<Annotation> {
        let (names, end) = match self.cycle {
            cycle if Single::of(cycle).is_some() => (["U/2", "W"], self.step(Step::Cut)),
            Cycle::MultiThreading => (["U/2", "W"], self.last(Step::Cut)),
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
        let start = self.start();
        let (x, z) = (end.x - start.x, end.z - start.z);
        // Beside the end of the cut, and above the way back: there are no other strokes.
        let across = Shape::Radial([Point::new(start.x, end.z), end]);
        let shapes = [(across, x), (Shape::Axial([start, Point::new(start.x, end.z)]), z)];
        let missing = names.into_iter().zip(shapes).filter(|(name, (shape, _))| {
            shape.is_visible() && !all.iter().any(|other| other.label.name == *name)
        });
        missing.map(|(name, (shape, mm))| Annotation::dimension(shape, name, Measure::Length(mm))).collect()
    }

    /// The run-in δ1 and the run-out δ2 that a thread of G92 needs at a constant speed, and its pull-out r. With a
    /// pull-out there is no run-out. `all`: the annotations of the block, which may have the pull-out already.
    pub fn ends_of_thread(&self, all: &[Annotation]) -> Vec<Annotation> {
        let Some(cut) =
            self.step(Step::Cut).filter(|_| Single::of(self.cycle).is_some_and(Single::is_thread))
        else {
            return Vec::new();
        };
        let length = (cut.to.z - cut.from.z).abs();
        let ends = [cut.from, cut.to];
        let mut own = Vec::new();
        let out = self.step(Step::PullOut);
        if let (SpindleSpeed::Constant(speed), Some(lead)) = (cut.process.speed, cut.lead) {
            let [first, last] = [run_in(speed, lead.abs(), LEAD_ERROR), run_out(speed, lead.abs())];
            if first > SAME_DEPTH && first + last < length {
                let until = at_share(ends, first / length);
                own.push(Annotation::dimension(
                    Shape::Axial([cut.from, until]),
                    "δ1",
                    Measure::AtLeast(first),
                ));
                let from = at_share(ends, 1.0 - last / length);
                let run_out =
                    Annotation::dimension(Shape::Axial([from, cut.to]), "δ2", Measure::AtLeast(last));
                own.extend(Some(run_out).filter(|_| out.is_none()));
            }
        }
        let is_given = ["r", "J", "K"].iter().any(|name| all.iter().any(|own| own.label.name == *name));
        if let Some(out) = out.filter(|_| !is_given) {
            let value = Measure::Length((out.to.z - out.from.z).abs());
            own.push(Annotation::dimension(Shape::Axial([out.from, out.to]), "r", value));
        }
        own.retain(|own| own.shape.is_visible());
        own
    }

    /// Numbers the first and the last pass: `1` and `d = 10` of G73, whose number of passes is no length, `n = 1` and
    /// `n = 12` of G76.
    pub fn add_pass_numbers(&self, all: &mut Vec<Annotation>) {
        if self.cycle == Cycle::MultiThreading {
            let ends = [self.step(Step::Cut), self.last(Step::Cut)].into_iter().flatten();
            all.extend(ends.map(|cut| Annotation {
                shape: Shape::Step([cut.from, cut.to]),
                label: Label::of("n", Some(Measure::Count(f64::from(pass_of(cut))))),
                importance: Importance::Usual,
            }));
        }
        let is_count = |own: &Annotation| matches!(own.label.value, Some(Measure::Count(_)));
        let Some(count) = all.iter().find(|own| is_count(own)).map(|own| own.label.clone()) else { return };
        let numbers = || self.steps(Step::Contour).map(pass_of);
        let ends = [numbers().min(), numbers().max()].map(|pass| self.longest_of(pass?));
        let [Some(first), Some(last)] = ends else { return };
        all.retain(|own| !is_count(own) && own.label.name != "Δi" && own.label.name != "Δk");
        all.push(Annotation::step([first.from, first.to], "1"));
        let shape = Shape::Step([last.from, last.to]);
        all.push(Annotation { shape, label: count, importance: Importance::Usual });
    }
}

/// The programmed end of a cut. A thread is left before it; `z`: the Z of its end.
fn programmed_end(cut: &Motion, z: Option<f64>) -> Point {
    let is_thread = cut.cycle.is_some_and(|step| step.cycle.family() == CycleFamily::Threading);
    let length = cut.to.z - cut.from.z;
    match z.filter(|_| is_thread && length.abs() > SAME_DEPTH) {
        Some(z) => at_share([cut.from, cut.to], (z - cut.from.z) / length),
        None => cut.to,
    }
}

/// The pass of a motion, from 1; 0 outside the passes.
pub fn pass_of(motion: &Motion) -> u32 {
    motion.cycle.map_or(0, |own| own.pass)
}

fn is_step(motion: &Motion, step: Step) -> bool {
    motion.cycle.is_some_and(|own| own.step == step)
}

/// The length that a named annotation shows, mm.
pub fn length_of(all: &[Annotation], name: &str) -> Option<f64> {
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

/// The motions of the figure of a cycle: its call at `first`, adjacent calls of the same cycle, and finishing after
/// roughing. The middle passes of G76 are left out, because a detail shows them, and the infeed of the middle passes of
/// G73, because all infeeds lie on nearly the same line.
pub fn shown(motions: &Motions, first: usize) -> Vec<Range<usize>> {
    let own = cycle_at(motions, first);
    let calls = calls(motions, first);
    let finishing = match own {
        Some(Cycle::RoughTurning | Cycle::RoughFacing | Cycle::Pattern) => {
            let end = motions.len().min(calls.end + MAX_MOTIONS);
            let next = (calls.end..end).find(|&index| cycle_at(motions, index).is_some());
            next.filter(|&index| cycle_at(motions, index) == Some(Cycle::Finishing))
        }
        _ => None,
    };
    let finishing = finishing.map(|index| index..end_of(motions, index));
    match own {
        Some(Cycle::MultiThreading | Cycle::Pattern) => {
            outer_passes(motions, calls).into_iter().chain(finishing).collect()
        }
        _ => [calls].into_iter().chain(finishing).collect(),
    }
}

/// The motions of the call at `first`, and of adjacent calls of the same cycle.
fn calls(motions: &Motions, first: usize) -> Range<usize> {
    let own = cycle_at(motions, first);
    let before = (first.saturating_sub(MAX_MOTIONS)..first).rev();
    let before = before.take_while(|&index| cycle_at(motions, index) == own);
    before.last().unwrap_or(first)..end_of(motions, first)
}

/// The end of the motions of a cycle that begin at an index.
fn end_of(motions: &Motions, from: usize) -> usize {
    let end = motions.len().min(from + MAX_MOTIONS);
    (from..end).find(|&index| cycle_at(motions, index) != cycle_at(motions, from)).unwrap_or(end)
}

fn cycle_at(motions: &Motions, index: usize) -> Option<Cycle> {
    motions.get(index).cycle.map(|step| step.cycle)
}

/// The motions of calls of G76 or G73 that a figure shows.
fn outer_passes(motions: &Motions, calls: Range<usize>) -> Vec<Range<usize>> {
    let mut shown: Vec<Range<usize>> = Vec::new();
    let mut first = calls.start;
    while first < calls.end {
        let line = motions.line(first);
        let end = (first..calls.end).find(|&index| motions.line(index) != line).unwrap_or(calls.end);
        let last = (first..end).map(|index| pass_of(&motions.get(index))).max().unwrap_or(0);
        let is_shown = |index: &usize| {
            let motion = motions.get(*index);
            let is_outer = matches!(pass_of(&motion), 0 | 1) || pass_of(&motion) == last;
            let is_left_out = motion.cycle.is_none_or(|own| own.cycle == Cycle::MultiThreading)
                || is_step(&motion, Step::Infeed);
            is_outer || !is_left_out
        };
        for index in (first..end).filter(is_shown) {
            match shown.last_mut() {
                Some(range) if range.end == index => range.end += 1,
                _ => shown.push(index..index + 1),
            }
        }
        first = end;
    }
    shown
}

/// Depths that differ by less, mm, are the same.
pub const SAME_DEPTH: f64 = 1e-3;
/// Maximum number of motions of a cycle that are looked at.
const MAX_MOTIONS: usize = 20_000;
