//! Detects tools of the setup that do the work of another kind of tool, and cuts with a feed that no insert
//! takes.
//!
//! In: cuts in order, and the workpiece before each. Out: [`Danger`]s: each kind of misuse once for a
//! station, and a fast feed unless it was the last one reported. Must not know messages.

use super::danger::Danger;
use super::part::{Part, Turned, cut};
use super::resolved_setup::{Basis, ResolvedTool};
use super::tool::EDGE;
use crate::geometry::{Point, SAME};
use crate::motion::{Cycle, CycleFamily, Feed, Motion, MotionKind, SpindleSpeed, SpindleTurn};
use crate::setup::{Stock, ToolKind};

/// Feed from which no insert of a common lathe cuts, mm/rev.
const FAST: f64 = 1.0;

/// The same for blanks larger than [`LARGE_DIAMETER`], mm/rev.
const FAST_ON_LARGE: f64 = 2.0;

/// Diameter of a blank that needs a heavy lathe, mm.
const LARGE_DIAMETER: f64 = 200.0;

/// Distance to the spindle axis up to which a point counts as on the axis, mm.
const AXIS_TOLERANCE: f64 = 0.01;

/// Area that a tool may cut on its way out without being reported, mm². An entering angle of 95° leaves a
/// wedge of 5° at a shoulder; many programs leave at rapid and scrape it off.
pub(super) const SCRAPED: f64 = 0.25;

/// Area that a tool may scrape off on its way out at feed, as a share of the square of its path: a wedge of
/// 5° has 0.044. The area is at least [`SCRAPED`] and at most [`MAX_SCRAPED`].
const WEDGE: f64 = 0.045;

/// Maximum area that a tool may scrape off on its way out at feed, mm².
const MAX_SCRAPED: f64 = 2.0;

/// Minimum length of a cut along Z that leaves a shoulder, mm. A cut across after a shorter one, which only
/// moved to the depth, is not a way out.
const SHOULDER: f64 = 2.0;

/// A grooving tool cuts a square or trapezoidal thread if the lead is at least this many times its width.
const LEAD_OF_GROOVING: f64 = 1.3;

/// Lead above which a thread cut by a boring tool is taken for an oil groove, mm.
const OIL_GROOVE: f64 = 8.0;

/// An insert does not cut deeper than this across the axis, mm, if its edge length is not given.
const INSERT: f64 = EDGE;

/// A cut with the context needed to check it.
#[derive(Clone, Copy)]
pub(super) struct Cut<'a> {
    pub motion: &'a Motion,
    /// The motion before it, except dwells.
    pub before: Option<&'a Motion>,
    pub tool: &'a ResolvedTool,
    pub blank: Option<Stock>,
}

/// The findings that were reported, and the holes that were drilled.
#[derive(Clone, Debug, Default)]
pub(super) struct Misuse {
    /// Stations that were reported as misused.
    misused: Vec<u16>,
    /// Stations whose tool cuts on the wrong side. Their collisions are not reported, because they have the
    /// same cause.
    wrong_side: Vec<u16>,
    /// The holes of drills on the axis.
    holes: Vec<Hole>,
    /// The feed that was reported last, mm/rev.
    fast: Option<f64>,
}

/// The hole that the drill of a station has drilled on the axis.
#[derive(Clone, Copy, Debug)]
struct Hole {
    station: u16,
    /// Z of its bottom, mm.
    bottom: f64,
    /// Whether the drill also bores the hole: such drills are made for both.
    is_bored: bool,
}

impl Misuse {
    /// The dangers of the next cut.
    pub fn next(&mut self, cut: &Cut, part: &mut Part) -> impl Iterator<Item = Danger> + use<> {
        let found = [self.wrong_side(cut, part), self.other_work(cut, part), self.fast_feed(cut, part)];
        found.into_iter().flatten()
    }

    /// Whether the tool of a station was reported to cut on the wrong side.
    pub fn cuts_on_wrong_side(&self, station: u16) -> bool {
        self.wrong_side.contains(&station)
    }

    /// Reports a boring bar that turns the outside, or an outside turning tool that bores, once for each
    /// station: at the cut, the material on the side of its body is thicker than its insert, and on the other
    /// side it is not.
    fn wrong_side(&mut self, cut: &Cut, part: &mut Part) -> Option<Danger> {
        let Cut { motion, tool, before: last, .. } = *cut;
        let kind = tool.tool.kind.filter(|_| tool.basis == Basis::Given)?;
        let direction = tool.tool.tip_direction();
        let is_boring_bar = match kind {
            ToolKind::Boring if matches!(direction, 1 | 2) => true,
            ToolKind::Turning if matches!(direction, 3 | 4) => false,
            _ => return None,
        };
        let (from, to) = (motion.from, motion.to);
        let along = (to.z - from.z).abs() > (to.x - from.x).abs();
        let is_exempt =
            motion.process.turn == SpindleTurn::Stopped || self.wrong_side.contains(&tool.station);
        if motion.kind != MotionKind::Feed || motion.arc().is_some() || !along || is_exempt {
            return None;
        }
        let (x, z) = ((from.x + to.x) / 2.0, (from.z + to.z) / 2.0);
        let (low, high) = part.now().radii(z).into_iter().find(|&(low, high)| low < x && x < high)?;
        let insert = tool.tool.edge_length.unwrap_or(INSERT);
        let (body_side, edge_side) = if is_boring_bar { (x - low, high - x) } else { (high - x, x - low) };
        // In a solid bar there is no bore that an outside tool could cut.
        if body_side <= insert || edge_side > insert || !is_boring_bar && low <= AXIS_TOLERANCE {
            return None;
        }
        // It comes from the outside, or from the bore.
        let last = last?;
        let comes_from_there = match is_boring_bar {
            true => last.from.x.max(last.to.x) >= high - SAME,
            false => last.from.x.min(last.to.x) <= low + SAME,
        };
        if !comes_from_there {
            return None;
        }
        self.wrong_side.push(tool.station);
        Some(Danger::WrongSide { kind, station: tool.station })
    }

    /// Reports a tool of the setup that does the work of another kind of tool, once for each station.
    fn other_work(&mut self, cut: &Cut, part: &mut Part) -> Option<Danger> {
        let Cut { motion, tool, .. } = *cut;
        let kind = tool.tool.kind.filter(|_| tool.basis == Basis::Given)?;
        let on_axis = is_on_axis(motion);
        let threads = motion.kind == MotionKind::Thread;
        let turns = motion
            .cycle
            .is_some_and(|tag| matches!(tag.cycle.family(), CycleFamily::Contour | CycleFamily::Turning));
        let station = tool.station;
        if kind == ToolKind::Drill && on_axis {
            self.record_hole(station, motion.to.z);
        }
        let other = match kind {
            // A live drill works off the axis.
            ToolKind::Drill => turns && !threads && !on_axis && !self.bores_own_hole(station, cut),
            ToolKind::Tap | ToolKind::Threading => turns && !threads && !on_axis,
            ToolKind::Turning => threads && !on_axis,
            ToolKind::Boring | ToolKind::Grooving => threads && !on_axis && !suits_lead(motion, tool, kind),
            ToolKind::Endmill => false,
        };
        if !other || self.misused.contains(&station) || !is_in_material(motion, part) {
            return None;
        }
        self.misused.push(station);
        Some(Danger::OtherWork { kind, station })
    }

    /// Records a hole that a drill makes on the axis.
    fn record_hole(&mut self, station: u16, z: f64) {
        match self.holes.iter_mut().find(|hole| hole.station == station) {
            Some(hole) => hole.bottom = hole.bottom.min(z),
            None => self.holes.push(Hole { station, bottom: z, is_bored: false }),
        }
    }

    /// Whether a drill bores the hole that it has drilled, after it has moved outwards.
    fn bores_own_hole(&mut self, station: u16, cut: &Cut) -> bool {
        let Cut { motion, before, .. } = *cut;
        let Some(hole) = self.holes.iter_mut().find(|hole| hole.station == station) else { return false };
        let goes_outwards = before.is_some_and(|before| before.from.x < motion.from.x - SAME);
        hole.is_bored |= goes_outwards;
        hole.is_bored && motion.from.z.min(motion.to.z) >= hole.bottom - SAME
    }

    /// Reports an absurd feed of a cut off the axis, where no tap works, or of a drilling cycle, unless this
    /// feed was the last one reported.
    fn fast_feed(&mut self, cut: &Cut, part: &mut Part) -> Option<Danger> {
        let Cut { motion, before, tool, blank } = *cut;
        let on_axis = is_on_axis(motion);
        let is_drilling_cycle = motion.cycle.is_some_and(|tag| {
            matches!(tag.cycle, Cycle::FacePecking | Cycle::Drilling | Cycle::FaceDrilling)
        });
        // A keyway is shaped with the spindle stopped.
        if motion.process.turn == SpindleTurn::Stopped {
            return None;
        }
        let per_turn = match (motion.process.feed, motion.process.speed) {
            (Feed::PerTurn(feed), _) if feed < Feed::OF_OTHER_UNIT => feed,
            (Feed::PerMinute(feed), SpindleSpeed::Constant(speed)) if speed > 0.0 => feed / speed,
            _ => return None,
        };
        let is_large = blank.is_some_and(|stock| stock.diameter.mm() > LARGE_DIAMETER);
        let is_fast = per_turn >= if is_large { FAST_ON_LARGE } else { FAST };
        let cuts_by_feed = motion.kind != MotionKind::Thread && (!on_axis || is_drilling_cycle);
        let is_new = is_fast
            && cuts_by_feed
            && self.fast != Some(per_turn)
            && is_in_material(motion, part)
            && !before.is_some_and(|before| is_way_out(motion, before, tool, part));
        if !is_new {
            return None;
        }
        self.fast = Some(per_turn);
        Some(Danger::FastFeed { per_turn })
    }
}

/// Whether a motion stays on the spindle axis.
fn is_on_axis(motion: &Motion) -> bool {
    motion.from.x.abs() <= AXIS_TOLERANCE && motion.to.x.abs() <= AXIS_TOLERANCE
}

/// Whether a tool of another kind may cut a thread of this lead.
fn suits_lead(motion: &Motion, tool: &ResolvedTool, kind: ToolKind) -> bool {
    let Some(lead) = motion.lead.map(f64::abs) else { return false };
    match kind {
        ToolKind::Grooving => tool.tool.width.is_some_and(|width| lead >= LEAD_OF_GROOVING * width),
        ToolKind::Boring => lead > OIL_GROOVE,
        ToolKind::Turning | ToolKind::Threading | ToolKind::Drill | ToolKind::Tap | ToolKind::Endmill => {
            false
        }
    }
}

/// Whether a tool only leaves the workpiece: back along the previous cut, or across from a shoulder that the
/// previous cut has left. It removes no more than the wedge that its edge leaves at a wall.
fn is_way_out(motion: &Motion, before: &Motion, tool: &ResolvedTool, part: &mut Part) -> bool {
    let way = |motion: &Motion| (motion.to.x - motion.from.x, motion.to.z - motion.from.z);
    let ((dx, dz), (before_x, before_z)) = (way(motion), way(before));
    let is_line = |motion: &Motion| motion.kind == MotionKind::Feed;
    let follows = before.to.is_same(motion.from) && is_line(motion) && is_line(before);
    let aside = (dx * before_z - dz * before_x).abs();
    let goes_back = dx * before_x + dz * before_z < 0.0 && aside <= SAME * motion.length();
    let leaves_shoulder = dz.abs() <= SAME && before_z.abs() >= SHOULDER;
    if !follows || !goes_back && !leaves_shoulder {
        return false;
    }
    let scraped = (WEDGE * motion.length() * motion.length()).clamp(SCRAPED, MAX_SCRAPED);
    part.now().intersection(&cut(motion, &Turned::default(), tool)).area() <= scraped
}

/// Whether the middle of the path of the tip lies in material.
fn is_in_material(motion: &Motion, part: &mut Part) -> bool {
    let middle = match motion.arc() {
        Some(arc) => arc.at(0.5),
        None => {
            let (from, to) = (motion.from, motion.to);
            Point::new((from.x + to.x) / 2.0, (from.z + to.z) / 2.0)
        }
    };
    // The axis itself is the edge of the workpiece.
    part.now().contains(Point::new(middle.x.max(AXIS_TOLERANCE), middle.z))
}
