//! The holes that live tools drill off the axis and into the side of the workpiece, each at its angle of C.
//! They do not belong to the turned region; a picture of the body shows their mouths.
//!
//! In: the motions up to a moment, the tools, the part at that moment. Out: holes with mouth and bottom. Must
//! not know how they are drawn.

use super::region::Region;
use super::resolved_setup::{ResolvedSetup, ResolvedTool};
use crate::geometry::{Point, SAME};
use crate::motion::{CycleFamily, Motion, Motions};

/// Most holes that are kept.
const MAX_HOLES: usize = 1000;

/// A hole of a live tool: radius and Z of its ends, mm, and its angle of C.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LiveHole {
    /// Point at which the tool enters the material, on the centre line of the hole.
    pub mouth: Point,
    /// The deepest position of the tip.
    pub bottom: Point,
    /// Angle of C, degrees, relative to the section, as programmed.
    pub c: f64,
    /// Radius of the tool, mm.
    pub radius: f64,
}

/// The holes in a part after the motions before `until` and a share of that motion, in the order in which
/// they are drilled.
pub fn live_holes(
    motions: &Motions,
    resolved: &ResolvedSetup,
    part: &Region,
    until: Option<(usize, f64)>,
) -> Vec<LiveHole> {
    let mut holes: Vec<LiveHole> = Vec::new();
    let mut c = 0.0;
    for (index, motion) in motions.on_workpiece().enumerate() {
        let motion = match until {
            Some((last, share)) if index == last => motion.first_part(share),
            Some((last, _)) if index > last => break,
            _ => motion,
        };
        c = motion.rotary.map_or(c, |rotary| rotary.to);
        let Some(hole) = hole(&motion, resolved.tool(&motion), part, c) else { continue };
        // The pecks of one hole are consecutive, and each begins where material was.
        let is_same = |own: &LiveHole| {
            own.c == hole.c && own.radius == hole.radius && is_on_line(own.mouth, own.bottom, hole.bottom)
        };
        let has_room = holes.len() < MAX_HOLES;
        match holes.last_mut().filter(|own| is_same(own)) {
            Some(own) if deeper(own.bottom, hole.bottom, own.mouth) => own.bottom = hole.bottom,
            Some(_) => {}
            None if has_room => holes.push(hole),
            None => break,
        }
    }
    holes
}

/// Whether a motion cuts a hole straight into the side of the workpiece.
pub fn goes_into_side(motion: &Motion, tool: &ResolvedTool) -> bool {
    let of_cycle = motion.cycle.is_some_and(|step| step.cycle.family() == CycleFamily::SideHole);
    let straight = motion.from.z == motion.to.z && motion.to.x < motion.from.x;
    straight && motion.kind.cuts() && (of_cycle || motion.cycle.is_none() && tool.is_live_drill())
}

/// The hole of a cut straight into the face or the side.
fn hole(motion: &Motion, tool: &ResolvedTool, part: &Region, c: f64) -> Option<LiveHole> {
    let (from, to) = (motion.from, motion.to);
    let into_face = from.x == to.x && to.z < from.z && to.x > SAME;
    let of_cycle = |family| motion.cycle.is_some_and(|step| step.cycle.family() == family);
    let into_face =
        into_face && (of_cycle(CycleFamily::FaceHole) || motion.cycle.is_none() && tool.is_live_drill());
    let is_hole = into_face || goes_into_side(motion, tool);
    let known = motion.virtual_move().is_none() && motion.process.removes_material();
    if !is_hole || !known || !motion.kind.cuts() || !tool.is_live_in(motion) {
        return None;
    }
    let radius = tool.tool.cutter_radius().or(tool.tool.geometry_r).filter(|radius| *radius > 0.0)?;
    Some(LiveHole { mouth: mouth(part, from, to)?, bottom: to, c, radius })
}

/// The first point of material on a straight path along an axis.
fn mouth(part: &Region, from: Point, to: Point) -> Option<Point> {
    let along_z = from.x == to.x;
    let (at, low, high) = if along_z { (from.x, to.z, from.z) } else { (from.z, to.x, from.x) };
    let turned = |point: Point| if along_z { (point.x, point.z) } else { (point.z, point.x) };
    let mut first: Option<f64> = None;
    for (a, b) in part.edges() {
        let ((a_beside, a_along), (b_beside, b_along)) = (turned(a), turned(b));
        if (a_beside - at) * (b_beside - at) > 0.0 || (a_beside - b_beside).abs() <= SAME {
            continue;
        }
        let crossing = a_along + (at - a_beside) / (b_beside - a_beside) * (b_along - a_along);
        if (low..=high).contains(&crossing) {
            first = Some(first.map_or(crossing, |own| own.max(crossing)));
        }
    }
    // A peck that starts inside the material has its mouth at its start.
    let within = || part.contains(from).then_some(high);
    let along = first.or_else(within)?;
    Some(if along_z { Point::new(at, along) } else { Point::new(along, at) })
}

fn is_on_line(mouth: Point, bottom: Point, place: Point) -> bool {
    let same = |a: f64, b: f64| (a - b).abs() <= SAME;
    if same(mouth.x, bottom.x) { same(place.x, mouth.x) } else { same(place.z, mouth.z) }
}

fn deeper(bottom: Point, place: Point, mouth: Point) -> bool {
    place.distance(mouth) > bottom.distance(mouth)
}
