//! The dimension of a word: X60 is a diameter, U2 of G71 the depth of a pass, R−7.5 the step of a taper.
//!
//! In: the word with its role and value, and the motions of its block. Out: its annotations. A word of the first
//! block of a cycle is shown in the passes of the next block of that cycle. FANUC B-64304, figures of G70 to G94.

use std::ops::Range;

use crate::assist::Query;
use crate::assist::fact::Quantity;
use crate::assist::hover::Hover;
use crate::control::codes::role::Role;
use crate::geometry::{Point, at_share};
use crate::motion::{Cycle, Motion, MotionKind, Motions, Step};
use crate::run::replay::Visit;
use crate::scene::annotation::{Annotation, Measure, Shape};
use crate::units::Diameter;

/// Two values in mm that differ by less are the same.
const SAME_VALUE: f64 = 1e-4;
/// Maximum number of later motions searched for motions of a block.
const MAX_LATER: usize = 64;
/// Maximum number of motions of a block that are looked at.
const MAX_MOTIONS: usize = 20_000;

impl Query<'_> {
    /// The annotations of the word that `hover` describes; empty if it has no place in the picture.
    pub fn annotations(&self, hover: &Hover, motions: &Motions) -> Vec<Annotation> {
        let Some(role) = hover.role else { return Vec::new() };
        let own = Own::new(motions, self.own_motions(motions));
        let mut all = own.annotations(role, hover.quantity).unwrap_or_default();
        // R0 is no step.
        all.retain(|annotation| annotation.shape.is_visible());
        all
    }

    /// The motions in which the words of the block are visible.
    fn own_motions(&self, motions: &Motions) -> Range<usize> {
        let Some(visit) = self.visit else { return 0..0 };
        if visit.purpose.is_some() {
            return contour_motion(visit, motions);
        }
        // A move before a corner becomes a motion while a later block is executed.
        let block = self.block.span;
        let is_inside = |index: &usize| {
            let span = motions.span(*index);
            block.start <= span.start && span.end <= block.end
        };
        let end = motions.len().min(visit.motions.end + MAX_LATER);
        if let Some(first) = (visit.motions.start..end).find(is_inside) {
            return first..(first..end).find(|index| !is_inside(index)).unwrap_or(end);
        }
        if !visit.motions.is_empty() {
            return visit.motions.clone();
        }
        // The first block of a cycle only sets amounts; the next block of the cycle uses them.
        let start = visit.motions.end;
        let Some(first) = (start < motions.len()).then(|| motions.get(start)) else { return 0..0 };
        let Some(step) = first.cycle else { return 0..0 };
        let is_same = |index: &usize| motions.get(*index).cycle.is_some_and(|own| own.cycle == step.cycle);
        start..(start..motions.len()).find(|index| !is_same(index)).unwrap_or(motions.len())
    }
}

/// The motion along the contour that is nearest to the move that a block of a contour programs: a pass of the
/// cycle that reads the block.
fn contour_motion(visit: &Visit, motions: &Motions) -> Range<usize> {
    let [from, to] = [&visit.before, &visit.after].map(|moment| moment.state.position);
    let distance = |index: usize| {
        let motion = motions.get(index);
        motion.from.distance(from) + motion.to.distance(to)
    };
    let is_pass = |index: &usize| motions.get(*index).cycle.is_some_and(|own| own.step == Step::Contour);
    let passes = visit.motions.clone().filter(is_pass);
    let nearest = passes.min_by(|&one, &other| distance(one).total_cmp(&distance(other)));
    nearest.map_or(0..0, |index| index..index + 1)
}

/// The motions of a block, on the workpiece.
struct Own {
    list: Vec<Motion>,
    /// The motion after the block, which may begin with the corner that the block asks for.
    next: Option<Motion>,
}

/// The two axes, for dimensions that have the same meaning along either.
#[derive(Clone, Copy, PartialEq)]
enum Along {
    X,
    Z,
}

impl Own {
    fn new(motions: &Motions, own: Range<usize>) -> Self {
        let end = own.end.min(own.start.saturating_add(MAX_MOTIONS));
        let list = (own.start..end).map(|index| motions.get_on_workpiece(index)).collect();
        let next = (end < motions.len()).then(|| motions.get_on_workpiece(end));
        Self { list, next }
    }

    fn annotations(&self, role: Role, quantity: Option<Quantity>) -> Option<Vec<Annotation>> {
        use Role::*;
        let value = quantity.and_then(millimetres);
        // For words that are diameters.
        let radius = value.map(|mm| Diameter::new(mm).radius());
        Some(match role {
            EndX | ViaX | CycleEndX | PeckEndX | ThreadEndX | HoleEndX | HolePlaceX => {
                let at = self.reaching(Along::X, radius?)?;
                let diameter = Shape::Diameter(at);
                let half = Shape::Radial([Point::new(0.0, at.z), at]);
                vec![
                    Annotation::of_word(diameter, "", Measure::Diameter(value?)),
                    Annotation::dimension(half, "X/2", Measure::Length(radius?)),
                ]
            }
            EndZ | ViaZ | CycleEndZ | PeckEndZ | ThreadEndZ | HoleEndZ | HolePlaceZ => {
                let at = self.reaching(Along::Z, value?)?;
                let shape = Shape::Axial([Point::new(at.x, at.z - value?), at]);
                vec![Annotation::of_word(shape, "", Measure::Coordinate('Z', value?))]
            }
            WayX | CycleWayX | PeckWayX | ThreadWayX | HoleWayX => {
                let from = self.list.first()?.from;
                let at = self.reaching(Along::X, from.x + radius?)?;
                word(Shape::Radial([from, at]), "U/2", radius?)
            }
            WayZ | CycleWayZ | PeckWayZ | ThreadWayZ | HoleWayZ | RPoint => {
                let from = self.list.first()?.from;
                let at = self.reaching(Along::Z, from.z + value?)?;
                word(Shape::Axial([from, at]), if role == RPoint { "R" } else { "W" }, value?)
            }
            ArcRadius => {
                let arc = self.list.iter().find_map(Motion::arc)?;
                let shape = Shape::Radius { center: arc.center, on: arc.at(0.5) };
                vec![Annotation::of_word(shape, "", Measure::Radius(value?))]
            }
            ArcCenterX => {
                let arc = self.list.iter().find_map(Motion::arc)?;
                word(Shape::Radial([arc.start, arc.center]), "I", value?)
            }
            ArcCenterZ => {
                let arc = self.list.iter().find_map(Motion::arc)?;
                word(Shape::Axial([arc.start, arc.center]), "K", value?)
            }
            Chamfer | CornerX | CornerZ => {
                let corner = self.corner(|motion| motion.arc().is_none())?;
                let middle = halfway(corner.from, corner.to);
                vec![Annotation::of_word(Shape::Note(middle), "", Measure::Coordinate('C', value?.abs()))]
            }
            Rounding => {
                let arc = self.corner(|motion| motion.arc().is_some())?.arc()?;
                let shape = Shape::Radius { center: arc.center, on: arc.at(0.5) };
                vec![Annotation::of_word(shape, "", Measure::Radius(value?.abs()))]
            }
            LineAngle => {
                let Some(Quantity::Degrees(degrees)) = quantity else { return None };
                let line = self.list.iter().find(|motion| motion.length() > 0.0)?;
                // Counted counter-clockwise from +Z.
                let base = Point::new(line.from.x, line.from.z + line.length());
                let shape = Shape::Angle { vertex: line.from, base, end: line.to };
                vec![Annotation::of_word(shape, "A", Measure::Degrees(degrees))]
            }
            TaperX | ThreadTaper => {
                let cut = self.taper_cut()?;
                let start = Shape::Radial([cut.from, Point::new(cut.from.x - value?, cut.from.z)]);
                let mut all = word(start, "R", value?);
                all.extend(angle(cut.to, cut.from, "α/2"));
                all
            }
            TaperZ => {
                let cut = self.taper_cut()?;
                let start = Shape::Axial([cut.from, Point::new(cut.from.x, cut.from.z - value?)]);
                let mut all = word(start, "R", value?);
                all.extend(angle(cut.to, cut.from, "α/2"));
                all
            }
            PassDepth => {
                let [first, second] = self.levels(Along::X)?;
                word(Shape::Radial([first, Point::new(second.x, first.z)]), "Δd", value?)
            }
            PassDepthZ => {
                let [first, second] = self.levels(Along::Z)?;
                word(Shape::Axial([first, Point::new(first.x, second.z)]), "Δd", value?)
            }
            Escape => {
                let escape = self.step(Step::Escape)?;
                let ends = [escape.from, escape.to];
                // From the bottom of the pass.
                let is_facing = escape.cycle.is_some_and(|own| own.cycle == Cycle::RoughFacing);
                let shape = if is_facing { Shape::Axial(ends) } else { Shape::Radial(ends) };
                let mut all = word(shape, "e", value?);
                all.extend(angle(escape.from, escape.to, ""));
                all
            }
            AllowanceX => {
                let at = self.middle_of_contour(Along::Z)?;
                word(Shape::Radial([at, Point::new(at.x - radius?, at.z)]), "Δu/2", radius?)
            }
            AllowanceZ => {
                let at = self.middle_of_contour(Along::X)?;
                word(Shape::Axial([at, Point::new(at.x, at.z - value?)]), "Δw", value?)
            }
            ReliefX => {
                let [first, last] = self.pattern_starts()?;
                word(Shape::Radial([first, last]), "Δi", value?)
            }
            ReliefZ => {
                let [first, last] = self.pattern_starts()?;
                word(Shape::Axial([first, last]), "Δk", value?)
            }
            PatternPasses => {
                let [first, _] = self.pattern_starts()?;
                let Some(Quantity::Count(count)) = quantity else { return None };
                vec![Annotation::of_word(Shape::Note(first), "d", Measure::Count(count))]
            }
            PeckRetract => {
                let retract = self.step(Step::Retract)?;
                self.along_motion(&retract, "e", value?)
            }
            Peck | HolePeck => {
                let cut = self.step(Step::Cut)?;
                let name = if along(&cut) == Along::X { "Δi" } else { "Δk" };
                self.along_motion(&cut, name, value?)
            }
            StepOver => {
                let cut = self.step(Step::Cut)?;
                let pecking = along(&cut);
                let is_other = |motion: &&Motion| match pecking {
                    Along::X => (motion.from.z - cut.from.z).abs() > SAME_VALUE,
                    Along::Z => (motion.from.x - cut.from.x).abs() > SAME_VALUE,
                };
                let other = self.steps(Step::Cut).find(is_other)?;
                match pecking {
                    Along::X => {
                        let to = Point::new(cut.from.x, other.from.z);
                        word(Shape::Axial([cut.from, to]), "Δk", value?)
                    }
                    Along::Z => {
                        let to = Point::new(other.from.x, cut.from.z);
                        word(Shape::Radial([cut.from, to]), "Δi", value?)
                    }
                }
            }
            BottomRelief => {
                let relief = self.step(Step::Relief)?;
                self.along_motion(&relief, "Δd", value?)
            }
            ThreadHeight => {
                let [_, root] = self.thread_cuts()?;
                let crest = Point::new(root.from.x + self.outward()? * value?, root.from.z);
                word(Shape::Radial([root.from, crest]), "k", value?)
            }
            FirstDepth => {
                let [first, _] = self.thread_cuts()?;
                let crest = Point::new(first.from.x + self.outward()? * value?, first.from.z);
                word(Shape::Radial([crest, first.from]), "Δd", value?)
            }
            LeastDepth => {
                let cuts: Vec<Motion> = self.steps(Step::Cut).copied().collect();
                let depth = |pair: &[Motion]| (pair[0].from.x - pair[1].from.x).abs();
                let is_reached = |pair: &&[Motion]| (depth(pair) - value.unwrap_or(0.0)).abs() < SAME_VALUE;
                // The infeed to the last depth is the finishing allowance, which may be as large.
                let last = cuts.last()?.from.x;
                let end = cuts.iter().position(|cut| (cut.from.x - last).abs() < SAME_VALUE)?;
                let pair = cuts[..end].windows(2).find(is_reached)?;
                word(Shape::Radial([pair[0].from, pair[1].from]), "Δd min", value?)
            }
            ThreadAllowance => {
                let cuts: Vec<Motion> = self.steps(Step::Cut).copied().collect();
                let last = cuts.last()?;
                let is_above = |cut: &&Motion| (cut.from.x - last.from.x).abs() > SAME_VALUE;
                let before = cuts.iter().rev().find(is_above)?;
                word(Shape::Radial([before.from, last.from]), "d", value?)
            }
            Lead => {
                let thread = self.list.iter().find(|motion| motion.kind == MotionKind::Thread)?;
                let Some(Quantity::FeedPerTurn(lead)) = quantity else { return None };
                // Not in the middle, where the label of the length is.
                let (start, along) = (at_share([thread.from, thread.to], 0.3), along(thread));
                let sign =
                    if along == Along::X { thread.to.x - thread.from.x } else { thread.to.z - thread.from.z }
                        .signum();
                match along {
                    Along::Z => {
                        let end = Point::new(start.x, start.z + sign * lead);
                        word(Shape::Axial([start, end]), "F", lead)
                    }
                    Along::X => {
                        let end = Point::new(start.x + sign * lead, start.z);
                        word(Shape::Radial([start, end]), "F", lead)
                    }
                }
            }
            ThreadPacked => {
                let mut all = Vec::new();
                if let Some(out) = self.step(Step::PullOut) {
                    let length = (out.to.z - out.from.z).abs();
                    all.extend(word(Shape::Axial([out.from, out.to]), "r", length));
                }
                all.extend(self.thread_angle());
                all
            }
            ThreadAngle => self.thread_angle().into_iter().collect(),
            PullOutAcross => {
                let out = self.step(Step::PullOut)?;
                word(Shape::Radial([out.from, out.to]), "J", value?)
            }
            PullOutAlong => {
                let out = self.step(Step::PullOut)?;
                word(Shape::Axial([out.from, out.to]), "K", value?)
            }
            _ => return None,
        })
    }

    /// The angle between the flanks of a thread, from the starts of its first and last cut: the tool feeds in
    /// along a flank. `None` if it feeds in straight.
    fn thread_angle(&self) -> Option<Annotation> {
        let [first, last] = self.thread_cuts()?;
        let (x, z) = ((first.from.x - last.from.x).abs(), (first.from.z - last.from.z).abs());
        let degrees = 2.0 * z.atan2(x).to_degrees();
        let value = Measure::Degrees(degrees);
        (z > SAME_VALUE).then(|| Annotation::of_word(Shape::Note(last.from), "a", value))
    }

    /// The motions of a step.
    fn steps(&self, step: Step) -> impl DoubleEndedIterator<Item = &Motion> {
        self.list.iter().filter(move |motion| motion.cycle.is_some_and(|own| own.step == step))
    }

    /// The first motion of a step.
    fn step(&self, step: Step) -> Option<Motion> {
        self.steps(step).find(|motion| motion.length() > SAME_VALUE).copied()
    }

    /// The end of the motion that reaches a coordinate, preferably of a cut; otherwise the end of the block.
    fn reaching(&self, axis: Along, value: f64) -> Option<Point> {
        let reaches = |motion: &&Motion| {
            let end = if axis == Along::X { motion.to.x } else { motion.to.z };
            (end - value).abs() < SAME_VALUE
        };
        let cuts = self.list.iter().filter(|motion| motion.kind != MotionKind::Rapid);
        let found = cuts.rev().find(reaches).or_else(|| self.list.iter().rev().find(reaches));
        found.or(self.list.last()).map(|motion| motion.to)
    }

    /// The first cut of a cycle.
    fn taper_cut(&self) -> Option<Motion> {
        self.step(Step::Cut)
    }

    /// The starts of two cuts at different levels, or the start of the cycle and its only level.
    fn levels(&self, axis: Along) -> Option<[Point; 2]> {
        let value = |at: Point| if axis == Along::X { at.x } else { at.z };
        let first = self.step(Step::Cut)?;
        let is_other = |cut: &&Motion| (value(cut.from) - value(first.from)).abs() > SAME_VALUE;
        match self.steps(Step::Cut).find(is_other) {
            Some(second) => Some([first.from, second.from]),
            None => Some([self.list.first()?.from, first.from]),
        }
    }

    /// The middle of the longest piece of the last pass along the contour in the direction of an axis, preferably
    /// parallel to it; without such a piece, the end of the contour.
    fn middle_of_contour(&self, axis: Along) -> Option<Point> {
        let length = |motion: &Motion| match axis {
            Along::X => (motion.to.x - motion.from.x).abs(),
            Along::Z => (motion.to.z - motion.from.z).abs(),
        };
        let last = self.steps(Step::Contour).next_back()?;
        let pass = |motion: &Motion| motion.cycle.map(|own| own.pass);
        let pieces = self
            .steps(Step::Contour)
            .filter(|motion| pass(motion) == pass(last) && motion.arc().is_none() && along(motion) == axis);
        let is_parallel = |motion: &Motion| motion.length() - length(motion) < SAME_VALUE;
        let order = |a: &&Motion, b: &&Motion| {
            is_parallel(a).cmp(&is_parallel(b)).then(length(a).total_cmp(&length(b)))
        };
        let longest = pieces.max_by(order);
        let middle = longest.map(|piece| halfway(piece.from, piece.to));
        Some(middle.unwrap_or(last.to))
    }

    /// The starts of the first and the last pass of G73.
    fn pattern_starts(&self) -> Option<[Point; 2]> {
        let mut passes = self.steps(Step::Contour);
        let first = passes.next()?;
        let last = passes.next_back()?.cycle?.pass;
        let starts_last = |motion: &&Motion| motion.cycle.is_some_and(|own| own.pass == last);
        Some([first.from, self.steps(Step::Contour).find(starts_last)?.from])
    }

    /// The first and the last cut of a thread.
    fn thread_cuts(&self) -> Option<[Motion; 2]> {
        Some([*self.steps(Step::Cut).next()?, *self.steps(Step::Cut).last()?])
    }

    /// The direction from the root of a thread to its crest along X: 1 outside, −1 in a bore.
    fn outward(&self) -> Option<f64> {
        let [first, last] = self.thread_cuts()?;
        let start = self.list.first()?.from;
        let by = if (first.from.x - last.from.x).abs() > SAME_VALUE { first.from.x } else { start.x };
        Some((by - last.from.x).signum())
    }

    /// A corner between this block and the next: a short motion at the end of this block or the beginning of
    /// the next one.
    fn corner(&self, is_kind: impl Fn(&Motion) -> bool) -> Option<Motion> {
        let inserted = self.list.iter().skip(1).rev().find(|motion| is_kind(motion));
        inserted.copied().or_else(|| self.next.filter(|next| is_kind(next)))
    }

    /// The length of a motion along its longer axis.
    fn along_motion(&self, motion: &Motion, name: &'static str, value: f64) -> Vec<Annotation> {
        match along(motion) {
            Along::X => word(Shape::Radial([motion.from, motion.to]), name, value),
            Along::Z => word(Shape::Axial([motion.from, motion.to]), name, value),
        }
    }
}

/// The annotation of the word itself.
fn word(shape: Shape, name: &'static str, mm: f64) -> Vec<Annotation> {
    vec![Annotation::of_word(shape, name, Measure::Length(mm))]
}

/// The angle between the Z axis and a line; `None` for a line along an axis.
fn angle(vertex: Point, end: Point, name: &'static str) -> Option<Annotation> {
    let (x, z) = ((end.x - vertex.x).abs(), (end.z - vertex.z).abs());
    (x > SAME_VALUE && z > SAME_VALUE).then(|| {
        let degrees = x.atan2(z).to_degrees();
        let base = Point::new(vertex.x, end.z);
        Annotation::dimension(Shape::Angle { vertex, base, end }, name, Measure::Degrees(degrees))
    })
}

fn along(motion: &Motion) -> Along {
    let (x, z) = ((motion.to.x - motion.from.x).abs(), (motion.to.z - motion.from.z).abs());
    if x > z { Along::X } else { Along::Z }
}

fn halfway(a: Point, b: Point) -> Point {
    Point::new((a.x + b.x) / 2.0, (a.z + b.z) / 2.0)
}

fn millimetres(quantity: Quantity) -> Option<f64> {
    match quantity {
        Quantity::Length(mm) => Some(mm),
        Quantity::Diameter(diameter) => Some(diameter.mm()),
        _ => None,
    }
}
