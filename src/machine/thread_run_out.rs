//! Checks the distance between the end of a thread and a shoulder beyond it.
//!
//! In: the cuts of threads in order, with the workpiece before each. Out: a [`ShortRunOut`] at the first pass
//! of a thread whose slide cannot stop before the shoulder. Must not know messages.

use super::region::Region;
use super::thread_depth::crest;
use crate::cycles::threading::run_out;
use crate::geometry::{Point, SAME};
use crate::motion::{Motion, SpindleSpeed};

/// Minimum height of a shoulder above the crest of the thread, mm: less is a burr or the diameter before
/// finishing.
const MIN_SHOULDER: f64 = 0.5;

/// Number of steps in which the path beyond the end is checked.
const STEPS: u32 = 20;

/// A thread that ends too near a shoulder. Lengths in mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShortRunOut {
    /// Distance from its end to the shoulder.
    pub available: f64,
    /// Distance in which the slide stops.
    pub required: f64,
}

/// Finds the first pass of each thread.
#[derive(Clone, Copy, Debug, Default)]
pub struct RunOuts(Option<CurrentThread>);

/// The current thread.
#[derive(Clone, Copy, Debug)]
struct CurrentThread {
    /// Turret station and offset number.
    tool: (u16, u16),
    /// Z of its end, mm.
    end: f64,
}

impl RunOuts {
    /// Adds a cut along a thread. Returns its run-out if that is too short and this is the first pass.
    /// Tapered threads, threads of less than a lead, and threads under constant surface speed are not
    /// checked.
    pub fn pass<'a>(&mut self, motion: &Motion, work: impl FnOnce() -> &'a Region) -> Option<ShortRunOut> {
        let (from, to) = (motion.from, motion.to);
        let lead = motion.lead?.abs();
        let is_cylinder = (to.x - from.x).abs() <= SAME && to.x > SAME && (to.z - from.z).abs() > lead;
        let SpindleSpeed::Constant(speed) = motion.process.speed else { return None };
        if !is_cylinder {
            return None;
        }
        let tool = motion.process.tool;
        let before = self.0.replace(CurrentThread { tool, end: to.z });
        // A pass of the same thread has the same tool, and ends within a lead.
        if before.is_some_and(|thread| thread.tool == tool && (thread.end - to.z).abs() < lead) {
            return None;
        }
        let work = work();
        let (crest, side) = crest(work, motion, lead)?;
        let required = run_out(speed, lead);
        let is_wall = |way: f64| {
            let z = to.z + (to.z - from.z).signum() * way;
            work.contains(Point::new(crest + side * MIN_SHOULDER, z))
        };
        let at = |step: u32| required * f64::from(step) / f64::from(STEPS);
        let wall = (0..STEPS).find(|&step| is_wall(at(step + 1)))?;
        // A tool that ends its pass inside the shoulder leaves it at rapid, which is reported as a collision.
        (!is_wall(-at(1))).then(|| ShortRunOut { available: at(wall), required })
    }
}
