//! Rapids of live tools through the workpiece.
//!
//! The cuts of live tools are not removed from the turned region. So a rapid within that region is compared
//! with the earlier live cuts: its path is free if one of them went at least as deep, and the cutter reached
//! as far sideways.
//!
//! In: the motions of live tools in order, and the turned region. Out: the first point where a rapid meets
//! material. Unknown values count as free: whether a tool points along X or along Z, and the reach of an
//! unknown cutter. Must not know messages.

use std::f64::consts::TAU;

use super::region::Region;
use super::resolved_setup::ResolvedTool;
use crate::geometry::Point;
use crate::geometry::virtual_plane::Surface;
use crate::motion::Motion;

/// How far within the material a rapid may be without a finding, mm.
const INSIDE: f64 = 0.1;

/// Assumed reach of a cutter without a given radius, mm.
const UNKNOWN_REACH: f64 = 10.0;

/// Most points at which a path is checked; a shorter path is checked at each millimetre.
const MAX_PIECES: f64 = 200.0;

/// Most points of cuts that are kept, and most comparisons. Beyond either limit there are no more findings.
const MAX_PLACES: usize = 20_000;
const MAX_COMPARED: usize = 20_000_000;

/// A position of the tip relative to the workpiece.
#[derive(Clone, Copy, Debug)]
struct Place {
    /// Radius and Z, mm.
    tip: Point,
    /// Angle of C, radians.
    angle: f64,
}

/// The axis along which a cutter points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum CutterAxis {
    AlongX,
    AlongZ,
    Unknown,
}

/// A point on the path of a cut.
#[derive(Clone, Copy, Debug)]
struct Cut {
    at: Place,
    cutter_axis: CutterAxis,
    /// Reach of the cutter around the point, mm.
    reach: f64,
}

/// The live cuts before the current motion.
#[derive(Clone, Debug, Default)]
pub(super) struct LiveCuts {
    places: Vec<Cut>,
    compared: usize,
    /// Whether the cuts are unknown.
    is_unknown: bool,
}

impl LiveCuts {
    /// Adds a cut of a live tool. C is at `c` degrees before it.
    pub fn cut(&mut self, motion: &Motion, c: f64, tool: &ResolvedTool) {
        // With a Y axis, radius and C do not give the position of the tool.
        if motion.virtual_move().is_some_and(|own| own.has_y()) {
            self.mark_unknown();
        }
        if self.is_unknown {
            return;
        }
        let way = places(motion, c);
        let reach = tool.tool.cutter_radius().or(tool.tool.geometry_r).unwrap_or(UNKNOWN_REACH);
        self.add(&way, cutter_axis(motion, tool), reach);
    }

    /// From here on the cuts are unknown, and there are no more findings.
    pub fn mark_unknown(&mut self) {
        *self = Self { is_unknown: true, ..Self::default() };
    }

    /// The first point where a rapid of a live tool meets remaining material. C is at `c` degrees before it.
    pub fn rapid(&mut self, motion: &Motion, c: f64, turned: &Region) -> Option<Point> {
        if self.is_unknown || motion.virtual_move().is_some_and(|own| own.has_y()) {
            return None;
        }
        let way = places(motion, c);
        // The tool is at the first point already.
        let hit = way.iter().skip(1).find(|place| is_within(turned, place.tip) && !self.is_free(place))?;
        if self.is_unknown {
            return None;
        }
        // The tool leaves along the same path, which must not be reported again.
        self.add(&way, CutterAxis::Unknown, UNKNOWN_REACH);
        Some(hit.tip)
    }

    fn add(&mut self, way: &[Place], cutter_axis: CutterAxis, reach: f64) {
        let reach = reach + spacing(way);
        self.places.extend(way.iter().map(|&at| Cut { at, cutter_axis, reach }));
        self.is_unknown = self.places.len() > MAX_PLACES;
    }

    /// Whether a cutter went through this point, or beyond it along its own axis.
    fn is_free(&mut self, place: &Place) -> bool {
        self.compared += self.places.len();
        self.is_unknown |= self.compared > MAX_COMPARED;
        self.is_unknown || self.places.iter().any(|cut| cut.clears(place))
    }
}

impl Cut {
    /// Whether the cutter has cleared a point: the point is not deeper, and not farther sideways than the
    /// reach.
    fn clears(&self, place: &Place) -> bool {
        let [own, other] = [self.at, *place];
        let turn = (other.angle - own.angle).rem_euclid(TAU);
        let turn = turn.min(TAU - turn);
        let along_x = || {
            let around = other.tip.x * turn;
            own.tip.x <= other.tip.x + INSIDE && around.hypot(other.tip.z - own.tip.z) <= self.reach
        };
        let along_z = || {
            let aside = (own.tip.x - other.tip.x * turn.cos()).hypot(other.tip.x * turn.sin());
            own.tip.z <= other.tip.z + INSIDE && aside <= self.reach
        };
        match self.cutter_axis {
            CutterAxis::AlongX => along_x(),
            CutterAxis::AlongZ => along_z(),
            CutterAxis::Unknown => along_x() || along_z(),
        }
    }
}

/// The direction of the cutter, if the cut shows it: along Z on the face and in its holes, along X on a
/// cylinder and in holes of the side.
fn cutter_axis(motion: &Motion, tool: &ResolvedTool) -> CutterAxis {
    let drills = tool.is_live_drill() || motion.cycle.is_some();
    match motion.virtual_move().map(|own| own.surface) {
        Some(Surface::Face) => CutterAxis::AlongZ,
        Some(Surface::Cylinder { .. }) => CutterAxis::AlongX,
        None if drills && motion.from.x == motion.to.x => CutterAxis::AlongZ,
        None if drills && motion.from.z == motion.to.z => CutterAxis::AlongX,
        _ => CutterAxis::Unknown,
    }
}

/// Points along a motion from its start to its end, at most about a millimetre apart unless that gives too
/// many.
fn places(motion: &Motion, c: f64) -> Vec<Place> {
    let (from, to) = motion.rotary.map_or((c, c), |rotary| (rotary.from, rotary.to));
    let around = (to - from).to_radians() * motion.from.x.abs().max(motion.to.x.abs());
    let pieces = motion.length().hypot(around).ceil().clamp(1.0, MAX_PIECES) as u32;
    let at = |piece: u32| {
        let share = f64::from(piece) / f64::from(pieces);
        let part = motion.first_part(share);
        let angle = part.rotary.map_or(c, |rotary| rotary.to).to_radians();
        Place { tip: Point::new(part.to.x.abs(), part.to.z), angle }
    };
    (0..=pieces).map(at).collect()
}

/// The longest step from one point to the next, mm.
fn spacing(way: &[Place]) -> f64 {
    let step = |ends: &[Place]| {
        let around = ends[1].tip.x * (ends[1].angle - ends[0].angle);
        ends[0].tip.distance(ends[1].tip).hypot(around)
    };
    way.windows(2).map(step).fold(0.0, f64::max)
}

/// Whether a point lies in the region by more than a small margin.
fn is_within(region: &Region, at: Point) -> bool {
    [(0.0, 0.0), (INSIDE, 0.0), (0.0, INSIDE)]
        .iter()
        .all(|(x, z)| region.contains(Point::new(at.x + x, at.z + z)))
}
