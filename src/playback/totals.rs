//! Totals for each tool: time, cutting length, extents.
//!
//! In: the motions and the machine. Out: [`ToolTotals`] for each tool, in the order of first use, and for the
//! whole program.

use std::collections::BTreeMap;

use super::timing::Total;
use crate::geometry::bounds::{Bounds, join};
use crate::motion::{MotionKind, Motions};
use crate::setup::Machine;

/// Totals of the motions of a tool.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ToolTotals {
    /// Station and offset of the T word; zero before the first one.
    pub tool: (u16, u16),
    /// The time.
    pub time: Total,
    /// Path length at feed, mm.
    pub cut: f64,
    /// Path length at rapid, mm.
    pub rapid: f64,
    /// Bounding box of its cuts on the workpiece, if any.
    pub extents: Option<Bounds>,
}

/// Adds up the motions: for each tool, and for all of them.
pub fn totals(motions: &Motions, machine: &Machine) -> (Vec<ToolTotals>, ToolTotals) {
    let mut tools: Vec<ToolTotals> = Vec::new();
    let mut all = ToolTotals::default();
    let mut places: BTreeMap<(u16, u16), usize> = BTreeMap::new();
    let mut last = 0;
    for motion in motions.iter() {
        let tool = motion.process.tool;
        if tools.get(last).is_none_or(|totals| totals.tool != tool) {
            last = *places.entry(tool).or_insert(tools.len());
            if last == tools.len() {
                tools.push(ToolTotals { tool, ..ToolTotals::default() });
            }
        }
        for totals in [&mut tools[last], &mut all] {
            totals.time.add(&motion, machine);
            match motion.kind {
                MotionKind::Dwell => continue,
                MotionKind::Rapid => totals.rapid += motion.length(),
                _ => totals.cut += motion.length(),
            }
            if motion.kind.cuts() && !motion.process.other_setup {
                let placed = motion.on_workpiece();
                let own = placed
                    .arc()
                    .map_or_else(|| Bounds::around(placed.from, placed.to), |arc| Bounds::of_arc(&arc));
                totals.extents = join(totals.extents, Some(own));
            }
        }
    }
    (tools, all)
}
