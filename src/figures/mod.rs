//! The annotations of pictures: the dimension of a word, the letters of a cycle, the dimensions of a part.
//!
//! In: a run, and help at a place (`assist`). Out: lists of [`Annotation`], which `scene` places and draws. All
//! values come from the run, so they follow every edit. Must not know canvases or a language.

mod cycle;
mod details;
mod face;
mod finish;
pub mod measure;
mod nose;
mod part;
mod speeds;
mod word;

pub use face::of_face;
pub use nose::of_nose;
pub use part::of_part;
pub use speeds::of_speeds;

use std::ops::Range;

use cycle::Call;

use crate::assist::Query;
use crate::assist::form::Form;
use crate::control::codes::cycles::CycleBlock;
use crate::geometry::bounds::Bounds;
use crate::geometry::{Point, SAME};
use crate::machine::SimulationResult;
use crate::machine::feature::threads;
use crate::machine::resolved_setup::Basis;
use crate::motion::Motions;
use crate::run::Run;
use crate::run::replay::{Found, VisitChoice};
use crate::scene::annotation::{Annotation, Importance, Measure, Shape};
use crate::setup::Stock;
use crate::setup::tool::ToolKind;
use crate::source::LineIndex;
use crate::text::block::Block;
use crate::text::parser::{Parser, Resume};
use crate::units::Diameter;

/// Maximum number of blocks that are executed again to find a block; with more, a figure would delay the page.
const MAX_BLOCKS: usize = 200_000;

/// Maximum number of lines between the two blocks of a cycle, plus one.
const MAX_BETWEEN: usize = 20;

/// The numbers of the steps of a cycle and of the moves of a contour.
const NUMBERS: [&str; 20] =
    ["①", "②", "③", "④", "⑤", "⑥", "⑦", "⑧", "⑨", "⑩", "⑪", "⑫", "⑬", "⑭", "⑮", "⑯", "⑰", "⑱", "⑲", "⑳"];

/// The dimensions of the finished part of a simulation; empty without one.
pub fn of_finished(simulation: &SimulationResult, motions: &Motions) -> Vec<Annotation> {
    let threads = || threads(motions, simulation.resolved_setup());
    simulation.finished().map_or_else(Vec::new, |part| of_part(&part, &threads(), motions))
}

/// The annotations of the word at a byte of a program that has finished.
pub fn of_word(run: &mut Run, byte: u32) -> Vec<Annotation> {
    let Some(found) = replay(run, &LineIndex::new(run.text()), byte) else { return Vec::new() };
    let block = found.block(run);
    let asked = Query::new(run, &found, &block);
    at_cursor(&asked, byte, run.motions())
}

/// The annotations of the word at a byte of a block.
pub fn at_cursor(asked: &Query, byte: u32, motions: &Motions) -> Vec<Annotation> {
    let hover = asked.hover(byte, &[], motions);
    hover.map_or_else(Vec::new, |hover| asked.annotations(&hover, motions))
}

/// The figure of a cycle.
#[derive(Clone, Debug, Default)]
pub struct Figure {
    /// Letters, steps and dimensions; empty if the block calls no cycle.
    pub annotations: Vec<Annotation>,
    /// The first motion of the call.
    first: usize,
}

impl Figure {
    /// The motions that a picture of the cycle alone shows; empty without a cycle.
    pub fn motions(&self, motions: &Motions) -> Vec<Range<usize>> {
        if self.annotations.is_empty() { Vec::new() } else { cycle::shown(motions, self.first) }
    }
}

/// The figure of the cycle that the block at a byte calls: its letters, and the dimensions of the words of both of its
/// blocks. Empty if the block calls none.
pub fn of_cycle(run: &mut Run, byte: u32) -> Figure {
    let lines = LineIndex::new(run.text());
    let Some(mut found) = replay(run, &lines, byte) else { return Figure::default() };
    let mut first = None;
    match cycle_block_of(run, &found) {
        // The second block makes the motions.
        Some(CycleBlock::First) => {
            let line = line_beside(run.text(), &lines, byte, CycleBlock::First);
            let Some(second) = line.and_then(|start| replay(run, &lines, start)) else {
                return Figure::default();
            };
            first = Some(std::mem::replace(&mut found, second));
        }
        Some(CycleBlock::Second) => {
            let line = line_beside(run.text(), &lines, byte, CycleBlock::Second);
            let before = line.and_then(|start| replay(run, &lines, start));
            first = before.filter(|found| cycle_block_of(run, found) == Some(CycleBlock::First));
        }
        _ => {}
    }
    let block = found.block(run);
    let asked = Query::new(run, &found, &block);
    let Some(call) = Call::of(&asked, run.motions()) else { return Figure::default() };
    let mut all = call.letters(block.span, run.landmarks());
    all.extend(cycle::dimensions(&asked, run.motions()));
    if let Some(found) = first {
        let block = found.block(run);
        all.extend(cycle::dimensions(&Query::new(run, &found, &block), run.motions()));
    }
    call.finish_diameter(&mut all);
    all.extend(call.distances(&all));
    all.extend(call.ends_of_thread(&all));
    // The lead may be shown anywhere along the thread.
    all.sort_by_key(|own| own.label.name == "F");
    all.extend(call.corner_of_taper(|| bar_of(run)));
    call.add_pass_numbers(&mut all);
    details::add_allowance(&call, &mut all);
    details::add_infeed(&call, &mut all);
    // Dimensions need the places beside their points.
    all.extend(call.step_numbers());
    details::add_start(&call, &mut all);
    add_origin(&mut all);
    Figure { annotations: all, first: call.first }
}

/// Adds zero of the program, to the letter of a point that is there.
fn add_origin(all: &mut Vec<Annotation>) {
    let zero = Point::default();
    let is_there = |own: &&mut Annotation| matches!(own.shape, Shape::Point(at) if at.is_same(zero));
    match all.iter_mut().find(is_there) {
        Some(own) if own.label.name == "A′" => own.label.name = "A′ = O",
        Some(_) => {}
        None => all.push(origin()),
    }
}

/// Zero of the program.
fn origin() -> Annotation {
    Annotation { importance: Importance::Low, ..Annotation::point(Point::default(), "O") }
}

/// The bar that a program is turned from; `None` for a blank with an outline.
fn bar_of(run: &Run) -> Option<Stock> {
    let blank = run.setup_at_machine().stock?;
    blank.outline().is_none().then(|| blank.extents())
}

/// Which block of a multiple cycle an executed block is.
fn cycle_block_of(run: &Run, found: &Found) -> Option<CycleBlock> {
    let block = found.block(run);
    let asked = Query::new(run, found, &block);
    match Form::of(asked.block, &asked.visit?.before.state, asked.codes) {
        Form::Multiple(_, block) => Some(block),
        _ => None,
    }
}

/// The insert of the tool of a figure at the start of its first cut, if the setup has the tool; with the width of a
/// grooving insert and of its groove, or the diameter of a drill.
pub fn of_tool(simulation: &SimulationResult, motions: &Motions, shown: &[Range<usize>]) -> Vec<Annotation> {
    let own = || shown.iter().flat_map(Clone::clone).map(|index| motions.get_on_workpiece(index));
    let mut cuts = own().filter(|motion| motion.kind.cuts());
    let Some(first) = cuts.next() else { return Vec::new() };
    let last = cuts.next_back().unwrap_or(first);
    let tool = simulation.resolved_setup().tool(&first);
    if tool.basis != Basis::Given {
        return Vec::new();
    }
    let edge: Vec<Point> = tool.shape.edge.points().iter().map(|corner| corner.moved(first.from)).collect();
    let bounds = edge.iter().fold(Bounds::of(first.from), |bounds, corner| bounds.with(*corner));
    let size = match tool.tool.kind {
        Some(ToolKind::Drill) => {
            // At the end of its point.
            let is_widest = |corner: &&Point| corner.x > bounds.max.x - SAME;
            let shoulder = edge.iter().filter(is_widest).min_by(|a, b| a.z.total_cmp(&b.z));
            let diameter = Measure::Diameter(Diameter::from_radius(bounds.max.x).mm());
            let own = |at: &Point| Annotation::dimension(Shape::Diameter(*at), "", diameter);
            shoulder.map(own).into_iter().collect()
        }
        // A groove in a cylinder.
        Some(ToolKind::Grooving) if first.from.z == first.to.z => {
            let along = |x: f64, [from, to]: [f64; 2], name: &'static str| {
                let ends = [Point::new(x, from), Point::new(x, to)];
                Annotation::dimension(Shape::Axial(ends), name, Measure::Length((to - from).abs()))
            };
            let reach = last.to.z - first.from.z;
            let groove = [bounds.min.z + reach.min(0.0), bounds.max.z + reach.max(0.0)];
            vec![along(first.from.x, [bounds.min.z, bounds.max.z], "w"), along(last.to.x, groove, "")]
        }
        _ => Vec::new(),
    };
    [Annotation::outline(edge)].into_iter().chain(size).collect()
}

/// The first byte of the block that calls the first cycle of a program that has finished.
pub fn first_cycle(run: &Run) -> Option<u32> {
    let motions = run.motions();
    (0..motions.len()).find(|&index| motions.glance(index).is_of_cycle).map(|index| motions.span(index).start)
}

/// The first byte of the nearest line with words before the second block of a cycle, or after its first one. `byte`: a
/// byte of `this` block.
fn line_beside(text: &[u8], lines: &LineIndex, byte: u32, this: CycleBlock) -> Option<u32> {
    let line = lines.line_of(byte);
    let has_words = |line: u32| {
        let mut block = Block::default();
        Parser::new(lines.line(text, line).of(text)).next_block(&mut block) && !block.words.is_empty()
    };
    let beside = match this {
        CycleBlock::First => (line + 1..lines.len()).take(MAX_BETWEEN).find(|&line| has_words(line)),
        _ => (0..line).rev().take(MAX_BETWEEN).find(|&line| has_words(line)),
    };
    beside.map(|line| lines.line(text, line).start)
}

/// The execution of the block at a byte; `None` if it comes after too many blocks. `lines`: those of the text.
fn replay(run: &mut Run, lines: &LineIndex, byte: u32) -> Option<Found> {
    let line = lines.line_of(byte);
    let start = Resume::inside(lines.line(run.text(), line).start, line);
    let mut replay = run.replay(start, byte, VisitChoice::Usual);
    run.advance_replay(&mut replay, MAX_BLOCKS).then(|| replay.found())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::control::codes::role::Role;
    use crate::control::codes::{self, G, MotionMode};
    use crate::setup::Setup;
    use crate::setup::dialect::CodeList;

    /// Programs that contain every word of every cycle at least once.
    const PROGRAMS: &[&str] = &[
        "G00 X62 Z2 M03 S500\nG90 X58 Z-25 R-10.8 F0.2\nU-8 W-27\nG00 X62 Z2\nG90 X58 Z-25 I-5\nM30\n",
        "G00 X54 Z5 M03 S500\nG94 X30 Z0 R-24 F0.1\nG00 X54 Z5\nG94 U-24 W-5 K-24\nM30\n",
        "G00 X32 Z5 M03 S300\nG92 X29 Z-20 R-1 F2\nG00 X32 Z5\nG92 U-3 W-25 I8\nM30\n",
        "(CONTROL GSK)\nG00 X32 Z5 M03 S300\nG92 X29 Z-20 F2 J2 K3\nM30\n",
        "G00 X60 Z10 M03 S300\nG76 X33.8 Z-60 K2.4 D700 F4 A60\nM30\n",
        "G00 X41 Z0 M03 S600\nG71 U2 R1\nG71 P50 Q70 U0.5 W0.2 F0.2\nN50 G00 X20\nN60 G01 Z-20\nN70 X41\n\
            G70 P50 Q70\nM30\n",
        "G00 X41 Z1 M03 S600\nG72 W2 R1\nG72 P50 Q70 U0.5 W0.2 F0.2\nN50 G00 Z-20\nN60 G01 X20\nN70 Z1\n\
            M30\n",
        "G00 X50 Z10 M03 S600\nG73 U18 W5 R10\nG73 P50 Q70 U0.5 W0.5 F0.2\nN50 G00 X20 Z1\nN60 G01 Z-20\n\
            N70 X41\nM30\n",
        "G00 X20 Z2 M03 S500\nG74 R1\nG74 X10 Z-12 P2000 Q5000 R0.3 F0.1\nG00 X20 Z2\n\
            G74 U-10 W-14 P2000 Q5000 F0.1\nM30\n",
        "G00 X42 Z22 M03 S500\nG75 R1\nG75 X30 Z10 P3000 Q2900 R0.3 F0.1\nG00 X42 Z22\n\
            G75 U-12 W-12 P3000 Q2900 F0.1\nM30\n",
        "G00 X60 Z10 M03 S300\nG76 P011060 Q250 R0.1\nG76 X33.8 Z-60 R-1 P2400 Q700 F4\nG00 X60 Z10\n\
            G76 U-26.2 W-70 P2400 Q700 F4\nM30\n",
    ];

    /// The roles whose word has an annotation in a program.
    fn annotated(text: &str) -> Vec<Role> {
        let setup = if text.contains("GSK") { r#"{"dialect": {"control": "gsk"}}"# } else { "{}" };
        let mut run = Run::finished(text.as_bytes().to_vec(), Setup::from_json(setup).expect("a setup"));
        let lines = LineIndex::new(run.text());
        let mut roles = Vec::new();
        for line in 0..lines.len() {
            let start = lines.line(run.text(), line).start;
            let Some(found) = replay(&mut run, &lines, start) else { continue };
            let block = found.block(&run);
            let asked = Query::new(&run, &found, &block);
            for word in &block.words {
                let hover = asked.hover(word.span.start, &[], run.motions());
                if let Some(hover) = hover.filter(|hover| !asked.annotations(hover, run.motions()).is_empty())
                {
                    roles.extend(hover.role);
                }
            }
        }
        roles
    }

    /// Why the word of a cycle has no dimension; `None` if it has one.
    fn reason_for_none(role: Role) -> Option<&'static str> {
        use Role::*;
        Some(match role {
            Feed | CuttingSpeed | SpindleSpeed => "a speed, not a length",
            DwellSeconds | DwellMilliseconds | HoleDwell => "a time",
            ContourFirst | ContourLast => "a block number: A′ and B are the ends of the contour",
            FinishAfter | InfeedMethod => "a choice, not a length",
            Starts | Repeats => "a number of repetitions",
            StartAngle => "an angle of the spindle, which a half-section does not show",
            HoleAngle | EndC | WayC => "an angle about the axis, which a half-section does not show",
            ThreadsPerInch => "F shows the lead",
            ToolAndOffset => "the number of a tool",
            Ignored => "not used by the control",
            _ => return None,
        })
    }

    #[test]
    fn both_blocks_of_a_cycle_show_its_figure() {
        let program = |between: &str| {
            format!(
                "G00 X41 Z0 M03 S600\nG71 U2 R1\n{between}G71 P50 Q70 U0.5 W0.2 F0.2\nN50 G00 X20\nN60 G01 Z-20\n\
                 N70 X41\nG71 U1 R1\nM30\n"
            )
        };
        let figure = |text: &str, line: u32| {
            let mut run = Run::finished(text.as_bytes().to_vec(), Setup::default());
            let byte = LineIndex::new(text.as_bytes()).line(text.as_bytes(), line).start;
            of_cycle(&mut run, byte).annotations
        };
        let usual = figure(&program(""), 2);
        // The depth of a pass is a word of the first block.
        assert!(
            usual.iter().any(|own| own.label.name == "A′") && usual.iter().any(|own| own.label.name == "Δd")
        );
        for (between, second) in [("", 2), ("(DEPTH)\n\n", 4)] {
            assert_eq!(figure(&program(between), 1), usual, "{between:?}");
            assert_eq!(figure(&program(between), second), usual, "{between:?}");
        }
        // No second block follows the last one.
        assert_eq!(figure(&program(""), 6), []);
    }

    #[test]
    fn every_word_of_a_cycle_has_a_dimension_or_a_reason() {
        let seen: Vec<Role> = PROGRAMS.iter().flat_map(|text| annotated(text)).collect();
        let blocks = [CycleBlock::First, CycleBlock::Second];
        let mut wrong = Vec::new();
        for (_, code) in codes::g_codes(CodeList::A) {
            let lists = match code.code {
                G::Multiple(cycle) => blocks.map(|block| cycle.spec().words(block)).to_vec(),
                G::Motion(MotionMode::Cycle(cycle)) => vec![cycle.spec().words],
                _ => continue,
            };
            for &role in lists.into_iter().flatten().flat_map(|word| word.roles) {
                if seen.contains(&role) == reason_for_none(role).is_some() {
                    wrong.push((code.code, role));
                }
            }
        }
        assert!(wrong.is_empty(), "{wrong:?}");
    }
}
