//! Recognises four consecutive moves as a single cycle, and the passes that continue it.
//!
//! In: plain moves. Out: passes ([`Pass`]). Pure geometry: the reverse of `cycles::single`.

use super::SAME;
use super::places::Move;
use crate::cycles::single::{Single, Work};
use crate::geometry::Point;
use crate::motion::{Motion, MotionKind};

/// One pass of a cycle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pass {
    /// The cycle.
    pub single: Single,
    /// Its start, which is also its return point.
    pub start: Point,
    /// End of its cut.
    pub end: Point,
    /// Start of the cut minus its end, mm: a radius, or a length for G94.
    pub taper: f64,
}

/// The passes of one cycle at the start of `moves`; empty if the moves do not begin with one.
pub fn passes(moves: &[Move]) -> Vec<Pass> {
    let mut found: Vec<Pass> = Vec::new();
    for four in moves.chunks_exact(4) {
        let joined = four.iter().skip(usize::from(found.is_empty())).all(|own| own.follows);
        let Some(pass) = pass_of(four).filter(|_| joined) else { break };
        if let Some(first) = found.first()
            && (first.single != pass.single || !same(first.start, pass.start))
        {
            break;
        }
        found.push(pass);
    }
    found
}

/// The cycle that four moves form, if any.
fn pass_of(moves: &[Move]) -> Option<Pass> {
    let [infeed, cut, retract, back] = moves else { return None };
    let [infeed, cut, retract, back] = [infeed, cut, retract, back].map(|own| own.motion);
    let start = infeed.from;
    let connected = [(infeed, cut), (cut, retract), (retract, back)].iter().all(|(a, b)| same(a.to, b.from));
    let returns_at_rapid =
        same(back.to, start) && infeed.kind == MotionKind::Rapid && back.kind == MotionKind::Rapid;
    if !connected || !returns_at_rapid {
        return None;
    }
    let kinds = (cut.kind, retract.kind);
    let along_x = |motion: &Motion| level(motion.from.z, motion.to.z) && !level(motion.from.x, motion.to.x);
    let along_z = |motion: &Motion| level(motion.from.x, motion.to.x) && !level(motion.from.z, motion.to.z);
    let turning = along_x(&infeed) && along_x(&retract) && along_z(&back);
    let facing = along_z(&infeed) && along_z(&retract) && along_x(&back);
    let single = match kinds {
        (MotionKind::Feed, MotionKind::Feed) if turning => Single::Turning,
        (MotionKind::Feed, MotionKind::Feed) if facing => Single::Facing,
        (MotionKind::Thread, MotionKind::Rapid) if turning => Single::Threading,
        _ => return None,
    };
    let taper = match single.work() {
        Work::Turning | Work::Threading => cut.from.x - cut.to.x,
        Work::Facing => cut.from.z - cut.to.z,
    };
    let taper = if level(taper, 0.0) { 0.0 } else { taper };
    Some(Pass { single, start, end: cut.to, taper })
}

/// Whether two lengths are equal within the tolerance.
pub fn level(a: f64, b: f64) -> bool {
    (a - b).abs() <= SAME
}

fn same(a: Point, b: Point) -> bool {
    a.distance(b) <= SAME
}
