//! Checks the depth of a thread, measured from the workpiece before its first pass.
//!
//! In: the cuts of threads in order, with the workpiece before each. Out: an [`UnusualDepth`] at the deepest
//! pass. G76 states its height itself and is not checked.

use super::region::Region;
use crate::geometry::SAME;
use crate::motion::{Cycle, Motion};

/// Usual depth on one side as a share of the pitch: 0.28 to 0.3 for the round threads of bottles and lamps,
/// 0.5 for trapezoidal, 0.54 to 0.65 for triangular, 0.87 for buttress threads.
const SHARE: std::ops::RangeInclusive<f64> = 0.27..=1.0;

/// Above this lead, mm, a helix may be an oil groove or have many starts, and its depth does not follow from
/// its lead.
const COARSE: f64 = 8.0;

/// Lengths that differ by at most this are equal, mm.
const NEAR: f64 = 0.001;

/// Least number of passes of a complete thread.
const FEW: u32 = 3;

/// A depth that does not fit the lead.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct UnusualDepth {
    /// The deepest pass.
    pub motion: usize,
    /// Its depth on one side, mm.
    pub depth: f64,
    /// The lead, mm.
    pub lead: f64,
}

/// The current thread.
#[derive(Clone, Copy, Debug, Default)]
pub struct Threads {
    thread: Option<Thread>,
}

#[derive(Clone, Copy, Debug)]
struct Thread {
    tool: (u16, u16),
    lead: f64,
    /// Z of its end.
    end: f64,
    /// Z of the start of its first pass.
    start: f64,
    /// Radius of the workpiece before its first pass, and the sign: 1 outside, where deeper is a smaller
    /// radius, −1 in a bore.
    crest: (f64, f64),
    /// Depth of the last pass below the crest, and of the deepest pass, mm.
    depths: (f64, f64),
    /// Its deepest pass.
    motion: usize,
    /// Number of passes that are each deeper than the one before.
    passes: u32,
    /// Whether there are several starts: a pass begins elsewhere, is less deep, or gets deeper after one as
    /// deep as the one before.
    has_starts: bool,
    repeats: u32,
}

impl Threads {
    /// Adds a cut along a thread. Returns the unusual depth of the thread before, if that is over.
    pub fn pass<'a>(
        &mut self,
        index: usize,
        motion: &Motion,
        work: impl FnOnce() -> &'a Region,
    ) -> Option<UnusualDepth> {
        let (from, to) = (motion.from, motion.to);
        let lead = motion.lead?.abs();
        let is_cylinder = (to.x - from.x).abs() <= SAME && to.x > SAME && (to.z - from.z).abs() > lead;
        let cycle = motion.cycle.map(|tag| tag.cycle);
        if !is_cylinder || cycle == Some(Cycle::MultiThreading) {
            return None;
        }
        let tool = motion.process.tool;
        let continue_thread = self.thread.as_mut().filter(|thread| {
            let (crest, side) = thread.crest;
            thread.tool == tool
                && (thread.lead - lead).abs() <= NEAR
                && (thread.end - to.z).abs() <= NEAR
                && (side * (crest - to.x) - thread.depths.0).abs() <= lead
        });
        if let Some(thread) = continue_thread {
            thread.continue_thread(index, motion);
            return None;
        }
        let over = self.close();
        self.thread = crest(work(), motion, lead).map(|crest| {
            let depth = crest.1 * (crest.0 - to.x);
            Thread {
                tool,
                lead,
                end: to.z,
                start: from.z,
                crest,
                depths: (depth, depth),
                motion: index,
                passes: 1,
                has_starts: false,
                repeats: 0,
            }
        });
        over
    }

    /// Ends the current thread.
    pub fn close(&mut self) -> Option<UnusualDepth> {
        let Thread { lead, depths: (_, depth), motion, passes, has_starts, .. } = self.thread.take()?;
        let share = depth / lead;
        let is_whole = passes >= FEW && !has_starts;
        let fits = if is_whole { SHARE.contains(&share) } else { share <= *SHARE.end() };
        (!fits && lead <= COARSE).then_some(UnusualDepth { motion, depth, lead })
    }
}

impl Thread {
    fn continue_thread(&mut self, index: usize, motion: &Motion) {
        let (crest, side) = self.crest;
        let depth = side * (crest - motion.to.x);
        let (last, deepest) = self.depths;
        let turns = (motion.from.z - self.start) / self.lead - motion.start_angle / 360.0;
        self.has_starts |= (turns - turns.round()).abs() * self.lead > NEAR || depth < last - NEAR;
        if depth > last + NEAR {
            self.passes += 1;
            self.has_starts |= self.repeats > 0;
        } else {
            self.repeats += 1;
        }
        self.depths = (depth, deepest.max(depth));
        if depth > deepest {
            self.motion = index;
        }
    }
}

/// The radius of the workpiece at the middle of a thread, and the side of the tool: 1 outside, −1 in a bore.
/// `None` if there is no material.
pub(super) fn crest(work: &Region, motion: &Motion, lead: f64) -> Option<(f64, f64)> {
    let middle = (motion.from.z + motion.to.z) / 2.0;
    let places = || (-2..=2).map(|step| work.radii(middle + lead * f64::from(step) / 4.0));
    let outer = places().filter_map(|radii| Some(radii.last()?.1)).reduce(f64::max)?;
    let inner = places().filter_map(|radii| Some(radii.first()?.0)).reduce(f64::min)?;
    let x = motion.to.x;
    Some(if (outer - x).abs() <= (x - inner).abs() || inner <= SAME { (outer, 1.0) } else { (inner, -1.0) })
}
