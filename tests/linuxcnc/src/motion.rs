//! A motion as both sides can say it, and how ours are brought into that form.

use std::collections::BTreeMap;

use gcode_playground::analyze;
use gcode_playground::geometry::{Point, Turn};
use gcode_playground::motion::{self, MotionKind, Programmed};
use gcode_playground::setup::Setup;
use gcode_playground::source::LineIndex;

use crate::program::Program;
use crate::translate::{self, FIRST_LINE};

/// Motions by block, in order.
pub type Motions = BTreeMap<usize, Vec<Motion>>;

/// What a motion is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shape {
    /// Rapid traverse.
    Rapid,
    /// Straight at feed.
    Line,
    /// Straight, locked to the spindle: mm/rev.
    Thread { lead: f64 },
    /// Round at feed.
    Arc { center: Point, turn: Turn },
    /// Waiting.
    Dwell { seconds: f64 },
}

/// Feed, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Feed {
    /// A minute.
    PerMinute(f64),
    /// A spindle revolution.
    PerTurn(f64),
}

/// Where a motion comes from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Origin {
    /// The program.
    Program,
    /// The program, led elsewhere by compensation.
    Compensated(Programmed),
}

/// One motion: points are radius and Z in the frame in force, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Motion {
    /// What it is.
    pub shape: Shape,
    /// Where it begins.
    pub from: Point,
    /// Where it ends.
    pub to: Point,
    /// Feed in force; `None` where none was ever set.
    pub feed: Option<Feed>,
    /// Where it comes from; LinuxCNC does not say.
    pub origin: Origin,
}

impl Motion {
    /// Whether it may end where it begins: an arc, a dwell.
    pub fn may_stay(&self) -> bool {
        matches!(self.shape, Shape::Arc { .. } | Shape::Dwell { .. })
    }

    /// A straight move to where the tool stands: ours makes no motion of it.
    pub fn is_still(&self) -> bool {
        !self.may_stay() && self.from.distance(self.to) < 1e-6
    }
}

/// What the playground makes of a program.
#[derive(Clone, Debug, Default)]
pub struct Run {
    /// Motions by block.
    pub motions: Motions,
    /// The first block with an error, and its code, slug and message.
    pub refused: Option<(usize, Refusal)>,
    /// Codes of the other messages, by block.
    pub remarks: Vec<(usize, &'static str)>,
}

/// Why the playground does not carry out a block.
#[derive(Clone, Debug, PartialEq)]
pub struct Refusal {
    /// Stable name of the fault.
    pub slug: &'static str,
    /// What is wrong, with its numbers.
    pub message: gcode_playground::message::Message,
}

/// Runs a program in the playground.
pub fn ours(program: &Program) -> Result<Run, String> {
    let text = translate::ours(program);
    let analysis = analyze(text.as_bytes(), &Setup::from_json(&translate::setup(program))?);
    let lines = LineIndex::new(text.as_bytes());
    let block = |line: u32| (line.saturating_sub(FIRST_LINE)) as usize;
    let mut run = Run::default();
    for diagnostic in &analysis.diagnostics {
        let block = block(lines.line_of(diagnostic.span.start));
        let message = &diagnostic.message;
        if !diagnostic.is_error() {
            run.remarks.push((block, message.slug()));
        } else if run.refused.as_ref().is_none_or(|(first, _)| block < *first) {
            run.refused = Some((block, Refusal { slug: message.slug(), message: message.clone() }));
        }
    }
    for index in 0..analysis.motions.len() {
        let motion = analysis.motions.get(index);
        run.motions.entry(block(analysis.motions.line(index))).or_default().push(converted(&motion)?);
    }
    Ok(run)
}

fn converted(motion: &motion::Motion) -> Result<Motion, String> {
    let number = |value: Option<f64>| value.ok_or_else(|| format!("incomplete: {motion:?}"));
    let shape = match motion.kind {
        MotionKind::Rapid => Shape::Rapid,
        MotionKind::Feed => Shape::Line,
        MotionKind::Thread => Shape::Thread { lead: number(motion.lead)? },
        MotionKind::Dwell => Shape::Dwell { seconds: number(motion.seconds)? },
        MotionKind::ArcClockwise | MotionKind::ArcCounterclockwise => {
            let arc = motion.arc().ok_or_else(|| format!("arc without centre: {motion:?}"))?;
            Shape::Arc { center: arc.center, turn: arc.turn }
        }
    };
    let feed = match motion.process.feed {
        motion::Feed::Unset => None,
        motion::Feed::PerMinute(feed) => Some(Feed::PerMinute(feed)),
        motion::Feed::PerTurn(feed) => Some(Feed::PerTurn(feed)),
    };
    let origin = motion.programmed.map_or(Origin::Program, Origin::Compensated);
    Ok(Motion { shape, from: motion.from, to: motion.to, feed, origin })
}
