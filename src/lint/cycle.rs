//! Single and multiple cycles: passes that cut nothing, starts that are too far or too near.

use crate::control::modal::DeepestPass;
use crate::cycles::single::Single;
use crate::message::Message;
use crate::setup::Stock;

/// Lengths this near are the same, mm.
const NEAR: f64 = 0.001;
/// A pass deeper than this is much for a small lathe, mm (radius).
const DEEPEST_PASS: f64 = 3.0;
/// A start farther from the work than this wastes time with each pass, mm.
const FAR: f64 = 10.0;

/// A pass that goes no deeper than one before it from the same start to the same end.
pub fn pass_not_deeper(
    cycle: Single,
    own: &DeepestPass,
    before: &DeepestPass,
    word: String,
) -> Option<Message> {
    let same = own.start.distance(before.start) <= NEAR && (own.taper - before.taper).abs() <= NEAR;
    let (deep, other, deepest) = match cycle {
        Single::Turning => {
            let inward = (own.start.x - before.end.x).signum();
            let deep = inward * (before.end.x - own.end.x);
            (deep, (own.end.z - before.end.z).abs(), 2.0 * before.end.x)
        }
        Single::Facing => {
            let inward = (own.start.z - before.end.z).signum();
            (inward * (before.end.z - own.end.z), (own.end.x - before.end.x).abs(), before.end.z)
        }
        Single::Threading => return None,
    };
    let axis = if cycle == Single::Facing { 'Z' } else { 'X' };
    let side = |pass: &DeepestPass| match cycle {
        Single::Facing => (pass.end.z - pass.start.z).signum(),
        _ => (pass.end.x - pass.start.x).signum(),
    };
    (same && side(own) == side(before) && other <= NEAR && deep < -NEAR).then_some(Message::PassNotDeeper {
        word,
        axis,
        deepest,
    })
}

/// How deep the first pass of a taper is at its thin end, outside, where that is far deeper than a pass (radius, mm).
pub fn edge_depth(cycle: Single, own: &DeepestPass, surface: Option<f64>, first: bool) -> Option<f64> {
    let outside = cycle == Single::Turning && own.taper < -NEAR && own.end.x <= own.start.x + NEAR;
    let depth = surface? - (own.end.x + own.taper);
    // A thick bar takes a deeper cut.
    let deepest = DEEPEST_PASS.max(0.14 * surface?);
    (first && outside && depth > deepest).then_some(depth)
}

/// The deeper of two passes.
pub fn deeper(cycle: Single, own: DeepestPass, before: Option<DeepestPass>) -> DeepestPass {
    let Some(before) = before else { return own };
    let same_end = match cycle {
        Single::Facing => (own.end.x - before.end.x).abs() <= NEAR,
        _ => (own.end.z - before.end.z).abs() <= NEAR,
    };
    let kept = same_end && pass_not_deeper(cycle, &own, &before, String::new()).is_some();
    if kept { before } else { own }
}

/// A cycle that starts too far from the blank.
pub fn start(cycle: Single, own: &DeepestPass, stock: &Stock) -> Option<Message> {
    let radius = stock.diameter.radius();
    let outside = own.end.x < own.start.x;
    let far_x = own.start.x - radius;
    if outside && far_x > FAR && own.end.x < radius {
        return Some(Message::AirCut { axis: 'X', distance: far_x });
    }
    let far_z = own.start.z - stock.face;
    if cycle != Single::Threading && far_z > FAR && own.end.z < stock.face {
        return Some(Message::AirCut { axis: 'Z', distance: far_z });
    }
    None
}
