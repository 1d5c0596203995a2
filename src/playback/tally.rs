//! What each tool does, added up: time, cutting length, extents.
//!
//! In: the motions and the machine. Out: a [`Tally`] for each tool in the order in which the tools are first used, and the
//! whole program.

use super::timing::Total;
use crate::geometry::bounds::{Bounds, join};
use crate::motion::{MotionKind, Motions};
use crate::setup::Machine;

/// What is added up of the motions of a tool.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Tally {
    /// Station and offset of the T word; zero before the first one.
    pub tool: (u16, u16),
    /// The time.
    pub time: Total,
    /// Path cut at feed, mm.
    pub cut: f64,
    /// Path at rapid, mm.
    pub rapid: f64,
    /// The box around its cuts; nothing where it does not cut.
    pub extents: Option<Bounds>,
}

/// Adds up all motions: by tool, and all of them.
pub fn tally(motions: &Motions, machine: &Machine) -> (Vec<Tally>, Tally) {
    let mut tools: Vec<Tally> = Vec::new();
    let mut all = Tally::default();
    let mut last = 0;
    for motion in motions.iter() {
        let tool = motion.process.tool;
        if tools.get(last).is_none_or(|tally| tally.tool != tool) {
            last = tools.iter().position(|tally| tally.tool == tool).unwrap_or_else(|| {
                tools.push(Tally { tool, ..Tally::default() });
                tools.len() - 1
            });
        }
        for tally in [&mut tools[last], &mut all] {
            tally.time.add(&motion, machine);
            match motion.kind {
                MotionKind::Dwell => continue,
                MotionKind::Rapid => tally.rapid += motion.length(),
                _ => tally.cut += motion.length(),
            }
            if motion.kind.cuts() {
                let own = motion
                    .arc()
                    .map_or_else(|| Bounds::around(motion.from, motion.to), |arc| Bounds::of_arc(&arc));
                tally.extents = join(tally.extents, Some(own));
            }
        }
    }
    (tools, all)
}
