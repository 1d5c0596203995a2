//! Rapids of live tools through the work.
//!
//! What live tools take off is no part of the turned region. So where a rapid is within that region it is held against the live
//! cuts before it: the way is free where one of them went at least as deep, and no farther aside than its cutter reaches.
//!
//! In: the motions of live tools, one after the other, and the turned region. Out: where a rapid first meets material. What is
//! not known counts as free: whether a tool stands along X or along Z, and how far an unknown cutter reaches. Must not know
//! messages.

use std::f64::consts::TAU;

use super::region::Region;
use super::resolved_setup::ResolvedTool;
use crate::geometry::Point;
use crate::geometry::virtual_plane::Surface;
use crate::motion::Motion;

/// How far within the material a rapid may be without a word, mm.
const INSIDE: f64 = 0.1;

/// How far a cutter reaches whose radius nobody has said, mm.
const UNKNOWN_REACH: f64 = 10.0;

/// Ways are looked at in so many places at most, one for each mm where that is less.
const MOST_PIECES: f64 = 200.0;

/// Most places of cuts that are kept, and most comparisons; beyond either of them nothing more is found.
const MOST_PLACES: usize = 20_000;
const MOST_COMPARED: usize = 20_000_000;

/// A place of the tip, seen from the work.
#[derive(Clone, Copy, Debug)]
struct Place {
    /// Radius and length, mm.
    tip: Point,
    /// Angle of C, radians.
    angle: f64,
}

/// Along which axis a cutter stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Stands {
    AlongX,
    AlongZ,
    Unknown,
}

/// A place on the way of a cut.
#[derive(Clone, Copy, Debug)]
struct Cut {
    at: Place,
    stands: Stands,
    /// How far the cutter reaches around it, mm.
    reach: f64,
}

/// The live cuts so far.
#[derive(Clone, Debug, Default)]
pub(super) struct LiveCuts {
    places: Vec<Cut>,
    compared: usize,
    /// It is not known what was cut.
    is_lost: bool,
}

impl LiveCuts {
    /// A cut of a live tool, with C at `c` degrees before it.
    pub fn cut(&mut self, motion: &Motion, c: f64, tool: &ResolvedTool) {
        // With a Y axis the tool is not where its radius and C say.
        if motion.virtual_move().is_some_and(|own| own.has_y()) {
            self.lose();
        }
        if self.is_lost {
            return;
        }
        let way = places(motion, c);
        let reach = tool.tool.cutter_radius().or(tool.tool.geometry_r).unwrap_or(UNKNOWN_REACH);
        self.add(&way, stands(motion, tool), reach);
    }

    /// What was cut is not known from here on: nothing more is found.
    pub fn lose(&mut self) {
        *self = Self { is_lost: true, ..Self::default() };
    }

    /// Where a rapid of a live tool first meets what is left of the turned region, with C at `c` degrees before it.
    pub fn rapid(&mut self, motion: &Motion, c: f64, turned: &Region) -> Option<Point> {
        if self.is_lost || motion.virtual_move().is_some_and(|own| own.has_y()) {
            return None;
        }
        let way = places(motion, c);
        // Where it begins, the tool stands already.
        let hit = way.iter().skip(1).find(|place| is_within(turned, place.tip) && !self.is_free(place))?;
        if self.is_lost {
            return None;
        }
        // From here the tool leaves the way it came: that is not reported again.
        self.add(&way, Stands::Unknown, UNKNOWN_REACH);
        Some(hit.tip)
    }

    fn add(&mut self, way: &[Place], stands: Stands, reach: f64) {
        let reach = reach + spacing(way);
        self.places.extend(way.iter().map(|&at| Cut { at, stands, reach }));
        self.is_lost = self.places.len() > MOST_PLACES;
    }

    /// Whether a cutter went through this place, or beyond it along its own axis.
    fn is_free(&mut self, place: &Place) -> bool {
        self.compared += self.places.len();
        self.is_lost |= self.compared > MOST_COMPARED;
        self.is_lost || self.places.iter().any(|cut| cut.clears(place))
    }
}

impl Cut {
    /// Whether its cutter has cleared a place: it is not deeper, and aside no farther than the cutter reaches.
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
        match self.stands {
            Stands::AlongX => along_x(),
            Stands::AlongZ => along_z(),
            Stands::Unknown => along_x() || along_z(),
        }
    }
}

/// How the cutter stands, where the cut shows it: on the face and in its holes along Z, on a cylinder and in holes of the
/// side along X.
fn stands(motion: &Motion, tool: &ResolvedTool) -> Stands {
    let drills = tool.is_live_drill() || motion.cycle.is_some();
    match motion.virtual_move().map(|own| own.surface) {
        Some(Surface::Face) => Stands::AlongZ,
        Some(Surface::Cylinder { .. }) => Stands::AlongX,
        None if drills && motion.from.x == motion.to.x => Stands::AlongZ,
        None if drills && motion.from.z == motion.to.z => Stands::AlongX,
        _ => Stands::Unknown,
    }
}

/// Places along a motion from its start to its end, no more than about a millimetre apart where that is not too many.
fn places(motion: &Motion, c: f64) -> Vec<Place> {
    let (from, to) = motion.rotary.map_or((c, c), |rotary| (rotary.from, rotary.to));
    let around = (to - from).to_radians() * motion.from.x.abs().max(motion.to.x.abs());
    let pieces = motion.length().hypot(around).ceil().clamp(1.0, MOST_PIECES) as u32;
    let at = |piece: u32| {
        let share = f64::from(piece) / f64::from(pieces);
        let part = motion.first_part(share);
        let angle = part.rotary.map_or(c, |rotary| rotary.to).to_radians();
        Place { tip: Point::new(part.to.x.abs(), part.to.z), angle }
    };
    (0..=pieces).map(at).collect()
}

/// The longest step from one place to the next, mm.
fn spacing(way: &[Place]) -> f64 {
    let step = |ends: &[Place]| {
        let around = ends[1].tip.x * (ends[1].angle - ends[0].angle);
        ends[0].tip.distance(ends[1].tip).hypot(around)
    };
    way.windows(2).map(step).fold(0.0, f64::max)
}

/// Whether a place lies in the region, and not only just.
fn is_within(region: &Region, at: Point) -> bool {
    [(0.0, 0.0), (INSIDE, 0.0), (0.0, INSIDE)]
        .iter()
        .all(|(x, z)| region.holds(Point::new(at.x + x, at.z + z)))
}
