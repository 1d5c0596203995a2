//! The report on an answer: is it the wanted part, where does it differ and why, and which checks are passed.
//!
//! In: an exercise and the program of an answer. Out: a [`Report`]. Must not know languages.

use super::answer::Answer;
use super::checks::{Checked, checked};
use super::codes::used;
use super::edge::{Edge, Material, Size};
use super::measure;
use super::quantity::{Measured, Quantity};
use super::shape::{Excess, Shape};
use super::slip::{Cause, cause};
use super::{Exercise, Kind};
use crate::geometry::{Point, SAME, nearest_on};
use crate::machine::sweep::path_of;
use crate::message::{Diagnostic, Severity};
use crate::motion::MotionKind;
use crate::source::Span;
use crate::units::Diameter;

/// Depth below the surface at which material is looked for, mm.
const BELOW: f64 = 0.002;

/// The report on an answer.
#[derive(Clone, Debug, PartialEq)]
pub struct Report {
    /// Whether the part is the wanted one.
    pub verdict: Verdict,
    /// The measuring report.
    pub sizes: Vec<Measured>,
    /// The checks of the exercise.
    pub checks: Vec<Checked>,
    /// Why the part differs, if a slip explains it.
    pub cause: Option<Cause>,
    /// The codes that the program uses, in the spelling of system A.
    pub codes: Vec<String>,
    /// Time of the program, seconds; rapids without a rate of the machine count at the assumed one.
    pub seconds: Option<f64>,
    /// The messages of the run.
    pub diagnostics: Vec<Diagnostic>,
}

/// Whether the part is the wanted one.
#[derive(Clone, Debug, PartialEq)]
pub enum Verdict {
    /// The part is within all tolerances.
    Same,
    /// It differs; the first size that is out, or the place with the greatest difference.
    Differs(Place),
    /// The program makes no part.
    NoPart,
}

/// A place at which the part differs.
#[derive(Clone, Debug, PartialEq)]
pub struct Place {
    /// The size there.
    pub size: Measured,
    /// Whether there is more or less material than wanted.
    pub has_more: bool,
    /// The block that made the surface, or that comes nearest to it.
    pub span: Option<Span>,
}

impl Report {
    /// Whether the part is the wanted one and all checks are passed.
    pub fn is_passed(&self) -> bool {
        self.verdict == Verdict::Same && self.checks.iter().all(|check| check.passed)
    }

    /// Number of messages with a severity.
    pub fn count(&self, severity: Severity) -> usize {
        self.diagnostics.iter().filter(|found| found.severity == severity).count()
    }
}

/// Runs an answer with the setup of its exercise, and compares it with the target.
pub fn check(exercise: &Exercise, text: &[u8]) -> Report {
    let program = if exercise.kind == Kind::Predict { exercise.program.as_bytes() } else { text };
    let answer = Answer::run(program, &exercise.setup);
    let codes = used(&answer.text, &answer.analysis);
    let checks = checked(exercise, &answer, &codes, text);
    let (verdict, sizes) = verdict(exercise, &answer);
    let cause = if verdict == Verdict::Same { None } else { cause(exercise, &answer) };
    Report {
        verdict,
        sizes,
        checks,
        cause,
        codes,
        seconds: answer.time(),
        diagnostics: answer.analysis.diagnostics,
    }
}

fn verdict(exercise: &Exercise, answer: &Answer) -> (Verdict, Vec<Measured>) {
    let Some(part) = answer.part.clone() else { return (Verdict::NoPart, Vec::new()) };
    // The part of a prediction is that of the exercise.
    if exercise.kind == Kind::Predict {
        return (Verdict::Same, Vec::new());
    }
    let target = &exercise.target;
    let shape = Shape::new(target, part, &answer.threads);
    let sizes = measure::report(target, &shape, answer);
    let finder = Finder { exercise, answer, shape: &shape };
    let size = first_out(&sizes).map(|size| finder.of_size(size));
    let place = size.or_else(|| shape.excess().map(|excess| finder.of_excess(excess)));
    (place.map_or(Verdict::Same, Verdict::Differs), sizes)
}

/// The size out of its tolerance that is named first: diameters and cones before lengths, and sizes that can be
/// measured before missing surfaces.
fn first_out(sizes: &[Measured]) -> Option<&Measured> {
    let rank = |size: &&Measured| match size.quantity {
        Quantity::Diameter => 0,
        Quantity::Radius | Quantity::Width | Quantity::Flats => 1,
        Quantity::Angle | Quantity::Lead | Quantity::Root | Quantity::ThreadLength | Quantity::Crest => 2,
        Quantity::Length | Quantity::Face => 3,
    };
    let out = sizes.iter().filter(|size| !size.is_in());
    out.min_by_key(|size| (size.actual.is_none(), rank(size)))
}

struct Finder<'a> {
    exercise: &'a Exercise,
    answer: &'a Answer,
    shape: &'a Shape<'a>,
}

impl Finder<'_> {
    fn of_size(&self, size: &Measured) -> Place {
        let edge = &self.exercise.target.edges[size.edge];
        let inside = below(size.at, edge);
        let has_more = self.shape.region.contains(inside);
        self.place(*size, edge, has_more)
    }

    /// The size at a place that no size of the measuring report covers.
    fn of_excess(&self, excess: Excess) -> Place {
        let edge = &self.exercise.target.edges[excess.edge];
        let nominal = nearest_on([edge.from, edge.to], excess.at);
        let is_face = edge.size() == Size::Length;
        let beside = Point::new(excess.at.x, excess.at.z - BELOW);
        let size =
            if is_face { self.length(excess, edge) } else { self.diameter(excess, edge, nominal, beside) };
        self.place(size, edge, excess.material == Material::More)
    }

    fn length(&self, excess: Excess, edge: &Edge) -> Measured {
        let right = self.exercise.target.right;
        let is_right = (edge.from.z - right).abs() <= SAME;
        let size = |z: f64| if is_right { z } else { right - z };
        let actual = self.shape.length((excess.at.x - BELOW).max(BELOW), edge, excess.at.z);
        Measured {
            quantity: if is_right { Quantity::Face } else { Quantity::Length },
            at: excess.at,
            nominal: size(edge.from.z),
            actual: actual.map(size),
            tolerance: edge.tolerance,
            edge: excess.edge,
        }
    }

    fn diameter(&self, excess: Excess, edge: &Edge, nominal: Point, beside: Point) -> Measured {
        let actual = self.shape.radius(beside.z, edge, excess.at.x);
        Measured {
            quantity: Quantity::Diameter,
            at: Point::new(nominal.x, excess.at.z),
            nominal: Diameter::from_radius(nominal.x).mm(),
            actual: actual.map(|radius| Diameter::from_radius(radius).mm()),
            tolerance: edge.tolerance,
            edge: excess.edge,
        }
    }

    fn place(&self, size: Measured, edge: &Edge, has_more: bool) -> Place {
        let motion = if has_more { self.nearest_cut(size.at) } else { self.removed_by(below(size.at, edge)) };
        Place { size, has_more, span: motion.map(|motion| self.answer.analysis.motions.span(motion)) }
    }

    /// The last of the cuts that come nearest to a point.
    fn nearest_cut(&self, at: Point) -> Option<usize> {
        let motions = &self.answer.analysis.motions;
        let cuts = (0..motions.len()).filter(|&index| motions.kind(index).cuts());
        let distance = |index: usize| {
            let path = path_of(&motions.get_on_workpiece(index).on_positive_side());
            let pieces = path.windows(2).map(|ends| nearest_on([ends[0], ends[1]], at).distance(at));
            pieces.fold(f64::INFINITY, f64::min)
        };
        let all: Vec<(usize, f64)> = cuts.map(|index| (index, distance(index))).collect();
        let least = all.iter().map(|(_, distance)| *distance).fold(f64::INFINITY, f64::min);
        all.into_iter().rev().find(|(_, distance)| *distance <= least + BELOW).map(|(index, _)| index)
    }

    /// The motion that removed the material at a point.
    fn removed_by(&self, at: Point) -> Option<usize> {
        let motions = &self.answer.analysis.motions;
        let is_there = |count: usize| {
            let part = self.answer.simulation.part_at(motions, count, 0.0);
            part.is_some_and(|part| part.contains(at))
        };
        if !is_there(0) || is_there(motions.len()) {
            return None;
        }
        let (mut low, mut high) = (0, motions.len());
        while high - low > 1 {
            let middle = usize::midpoint(low, high);
            if is_there(middle) { low = middle } else { high = middle }
        }
        Some(low).filter(|&index| motions.kind(index) != MotionKind::Dwell)
    }
}

/// A point just below a surface of the target.
fn below(at: Point, edge: &Edge) -> Point {
    Point::new(at.x + BELOW * edge.inwards.x, at.z + BELOW * edge.inwards.z)
}
