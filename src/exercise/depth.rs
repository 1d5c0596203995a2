//! The greatest depth of the cuts of turning and boring tools.
//!
//! In: the motions with their tools. Out: the greatest thickness of the material that one cut removes, across its
//! direction, and its motion. Threads, grooves and holes do not count.

use super::answer::Answer;
use crate::machine::compare::Comparison;
use crate::machine::part::{Turned, cut};
use crate::machine::region::Region;
use crate::motion::{Motion, MotionKind};
use crate::setup::ToolKind;

/// Most motions whose depth is examined.
const MOST_MOTIONS: usize = 2000;

/// A cut and its depth, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Deepest {
    pub motion: usize,
    pub depth: f64,
}

/// The deepest cut of a program.
pub(super) fn deepest(answer: &Answer) -> Option<Deepest> {
    let motions = &answer.analysis.motions;
    let count = motions.len().min(MOST_MOTIONS);
    let cuts = (0..count).filter(|&index| motions.kind(index).cuts());
    let depths = cuts.filter_map(|motion| Some(Deepest { motion, depth: depth(answer, motion)? }));
    depths.max_by(|a, b| a.depth.total_cmp(&b.depth))
}

/// The depth of a cut, mm; `None` if it removes nothing.
fn depth(answer: &Answer, index: usize) -> Option<f64> {
    let motions = &answer.analysis.motions;
    let motion = motions.get_on_workpiece(index).on_positive_side();
    let resolved = answer.simulation.resolved_setup();
    let tool = resolved.tool(&motion);
    let is_turning = matches!(tool.tool.kind, Some(ToolKind::Turning | ToolKind::Boring));
    if !is_turning || motion.kind == MotionKind::Thread || !motion.process.removes_material() {
        return None;
    }
    let before = answer.simulation.part_at(motions, index, 0.0)?;
    let removed = before.intersection(&cut(&motion, &Turned::default(), tool));
    let thickness = Comparison::of(&removed, &Region::default());
    let measure = if is_across(&motion) { thickness.axial() } else { thickness.radial() };
    measure.map(|measure| measure.length())
}

/// Whether a cut runs across the spindle axis rather than along it.
fn is_across(motion: &Motion) -> bool {
    (motion.to.x - motion.from.x).abs() > (motion.to.z - motion.from.z).abs()
}
