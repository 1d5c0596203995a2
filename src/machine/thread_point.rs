//! The shape of a threading tool near its point.
//!
//! In: a [`Tool`], and the pitch it cuts. Out: measures of the insert. The default is a usual lay-down
//! insert: a tooth for one pitch, and little more beside it, so that it reaches a shoulder next to a relief
//! groove.

use std::collections::BTreeMap;

use crate::limits::INFERRED_FROM;
use crate::motion::{MotionKind, Motions};
use crate::setup::thread_insert::Hand;
use crate::setup::{Tool, ToolKind};

/// Default pitch, mm: the largest that inserts of size 16 are made for.
const PITCH: f64 = 3.0;

/// Default thread angle, degrees.
pub(super) const THREAD: f64 = 60.0;

/// Distance from the point to the end of the insert along Z: a multiple of the pitch, and a constant in mm.
/// Tables of lay-down inserts have 0.7 mm for a pitch of 1 mm, 1.5 for 2.5 (size 16) and 2.3 for 4 (size 22).
const BESIDE: (f64, f64) = (0.55, 0.1);

/// Usual edge lengths of lay-down inserts, and the largest pitch of each, mm.
const SIZES: [(f64, f64); 3] = [(16.0, 3.0), (22.0, 6.0), (27.0, 12.0)];

/// The measures of a threading tool, mm and degrees.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ThreadPoint {
    /// Angle between the flanks.
    pub angle: f64,
    /// Length of each flank, from the corner that the insert would have without a nose radius.
    pub flank: f64,
    /// Length of the insert from its point across the axis.
    pub height: f64,
    /// Hand of the tool.
    pub hand: Hand,
}

impl ThreadPoint {
    /// The measures of a tool.
    pub fn of(tool: &Tool) -> Self {
        let insert = tool.thread_insert();
        let angle = tool.angle.or(insert.and_then(|insert| insert.angle)).unwrap_or(THREAD);
        let half = angle.to_radians() / 2.0;
        let pitch = insert.and_then(|insert| insert.pitch).unwrap_or(PITCH);
        let flank = tool.edge_length.unwrap_or_else(|| beside(pitch) / half.sin());
        // The pitch that fits this flank.
        let pitch = (flank * half.sin() - BESIDE.1) / BESIDE.0;
        let usual = SIZES.iter().find(|size| pitch <= size.1 + 0.01).map_or(0.0, |size| size.0);
        let size = insert.map_or(usual, |insert| insert.size);
        let height = tool.reach.unwrap_or(size).max(flank * half.cos());
        Self { angle, flank, height, hand: insert.map(|insert| insert.hand).unwrap_or_default() }
    }
}

fn beside(pitch: f64) -> f64 {
    BESIDE.0 * pitch + BESIDE.1
}

/// A threading tool made for a pitch in mm, if it does not give its pitch or edge length itself. Any other
/// tool is returned unchanged.
pub fn for_pitch(tool: &Tool, pitch: Option<f64>) -> Tool {
    let says =
        tool.edge_length.is_some() || tool.thread_insert().is_some_and(|insert| insert.pitch.is_some());
    match pitch.filter(|_| tool.kind == Some(ToolKind::Threading) && !says) {
        None => tool.clone(),
        Some(pitch) => {
            let half = ThreadPoint::of(tool).angle.to_radians() / 2.0;
            Tool { edge_length: Some(beside(pitch) / half.sin()), ..tool.clone() }
        }
    }
}

/// The largest lead that each station cuts, mm. It is used as the pitch, also for threads with many starts.
pub fn leads(motions: &Motions) -> BTreeMap<u16, f64> {
    let mut leads: BTreeMap<u16, f64> = BTreeMap::new();
    let threads =
        motions.on_workpiece().take(INFERRED_FROM).filter(|motion| motion.kind == MotionKind::Thread);
    for (station, lead) in threads.filter_map(|motion| Some((motion.process.tool.0, motion.lead?.abs()))) {
        let longest = leads.entry(station).or_insert(lead);
        *longest = longest.max(lead);
    }
    leads
}
