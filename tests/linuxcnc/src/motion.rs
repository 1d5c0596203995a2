//! Motions in a form that both sides share, and the conversion of ours into it.

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
    /// Arc at feed.
    Arc { center: Point, turn: Turn },
    /// Dwell.
    Dwell { seconds: f64 },
}

/// Feed, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Feed {
    /// Per minute.
    PerMinute(f64),
    /// Per spindle revolution.
    PerTurn(f64),
}

/// The origin of a motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Origin {
    /// Directly from the program.
    Program,
    /// From the program, offset by compensation.
    Compensated(Programmed),
}

/// One motion. Points are radius and Z in the active frame, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Motion {
    /// Kind of motion.
    pub shape: Shape,
    /// Start point.
    pub from: Point,
    /// End point.
    pub to: Point,
    /// Feed in force; `None` if it was never set.
    pub feed: Option<Feed>,
    /// Origin; LinuxCNC does not report it.
    pub origin: Origin,
}

impl Motion {
    /// Whether it may end at its start point: an arc or a dwell.
    pub fn may_stay(&self) -> bool {
        matches!(self.shape, Shape::Arc { .. } | Shape::Dwell { .. })
    }

    /// Whether it is a straight move to the current position: ours makes no motion of it.
    pub fn is_still(&self) -> bool {
        !self.may_stay() && self.from.distance(self.to) < 1e-6
    }
}

/// The playground's result for a program.
#[derive(Clone, Debug, Default)]
pub struct Run {
    /// Motions by block.
    pub motions: Motions,
    /// The first block with an error, and that error.
    pub refused: Option<(usize, Refusal)>,
    /// Slugs of the other messages, by block.
    pub remarks: Vec<(usize, &'static str)>,
}

/// An error of the playground.
#[derive(Clone, Debug, PartialEq)]
pub struct Refusal {
    /// Stable slug of the error.
    pub slug: &'static str,
    /// The message with its arguments.
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
