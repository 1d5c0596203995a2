//! Tools of the setup that do what another kind of tool is for, and cuts with a feed that no insert takes.
//!
//! In: cuts, one after the other, and the work as it stands. Out: [`Danger`]s, each once. Must not know messages.

use super::danger::Danger;
use super::part::{Part, Turned, cut};
use super::resolved_setup::{Basis, ResolvedTool};
use crate::geometry::{Point, SAME};
use crate::motion::{Cycle, CycleFamily, Feed, Motion, MotionKind, SpindleSpeed, SpindleTurn};
use crate::setup::{Stock, ToolKind};

/// With so much feed no insert of a common lathe cuts, mm/rev, and on blanks of more than [`LARGE`].
const FAST: f64 = 1.0;
const FAST_ON_LARGE: f64 = 2.0;

/// Diameter of a blank that is turned on heavy lathes, mm.
const LARGE: f64 = 200.0;

/// Nearer to the spindle axis than this, mm, is on it.
const OFF_AXIS: f64 = 0.01;

/// Material that may be in the way of a tool without a word, mm². An entering angle of 95° leaves a wedge of
/// 5° at a shoulder: where the tool leaves at rapid, as many programs have it, it scrapes that off.
pub(super) const SCRAPED: f64 = 0.25;

/// Where a tool leaves along a wall at feed: so much it may scrape off, as a share of the square of its way (an entering
/// angle of 95° leaves that wedge), but no more than some mm².
const WEDGE: f64 = 0.045;
const MOST_SCRAPED: f64 = 2.0;

/// A cut across that comes from a shorter way along Z, mm, leaves no shoulder: that was its depth.
const SHOULDER: f64 = 2.0;

/// From so many of its widths as a lead on, a grooving tool cuts a square or trapezoidal thread.
const LEAD_OF_GROOVING: f64 = 1.3;

/// With a larger lead, mm, a boring tool cuts an oil groove.
const OIL_GROOVE: f64 = 8.0;

/// A cut and what it is looked at with.
#[derive(Clone, Copy)]
pub(super) struct Cut<'a> {
    pub motion: &'a Motion,
    /// The motion before it, dwells aside.
    pub before: Option<&'a Motion>,
    pub tool: &'a ResolvedTool,
    pub blank: Option<Stock>,
}

/// What was reported, and what drills have drilled.
#[derive(Clone, Debug, Default)]
pub(super) struct Misuse {
    /// Stations that were reported to do other work.
    misused: Vec<u16>,
    /// The holes of drills on the axis.
    holes: Vec<Hole>,
    /// The feed that was reported last, mm/rev.
    fast: Option<f64>,
}

/// What the drill of a station has drilled on the axis.
#[derive(Clone, Copy, Debug)]
struct Hole {
    station: u16,
    /// Z of its bottom, mm.
    bottom: f64,
    /// The drill also bores it out: it is made for both.
    is_bored: bool,
}

impl Misuse {
    /// What is wrong with the next cut, which comes after `before`, dwells aside.
    pub fn next(&mut self, cut: &Cut, part: &mut Part) -> impl Iterator<Item = Danger> + use<> {
        let found = [self.other_work(cut, part), self.fast_feed(cut, part)];
        found.into_iter().flatten()
    }

    /// A tool of the setup does what another kind of tool is for: once for each station.
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
            self.drills(station, motion.to.z);
        }
        let other = match kind {
            // A live one drills beside the axis.
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

    /// A drill goes into the work on the axis.
    fn drills(&mut self, station: u16, z: f64) {
        match self.holes.iter_mut().find(|hole| hole.station == station) {
            Some(hole) => hole.bottom = hole.bottom.min(z),
            None => self.holes.push(Hole { station, bottom: z, is_bored: false }),
        }
    }

    /// Whether a drill turns in the hole that it has drilled, and first goes outwards to do so.
    fn bores_own_hole(&mut self, station: u16, cut: &Cut) -> bool {
        let Cut { motion, before, .. } = *cut;
        let Some(hole) = self.holes.iter_mut().find(|hole| hole.station == station) else { return false };
        let goes_outwards = before.is_some_and(|before| before.from.x < motion.from.x - SAME);
        hole.is_bored |= goes_outwards;
        hole.is_bored && motion.from.z.min(motion.to.z) >= hole.bottom - SAME
    }

    /// A cut off the axis, where no tap stands, or of a drilling cycle, with an absurd feed: once for each feed.
    fn fast_feed(&mut self, cut: &Cut, part: &mut Part) -> Option<Danger> {
        let Cut { motion, before, tool, blank } = *cut;
        let on_axis = is_on_axis(motion);
        let drills = motion.cycle.is_some_and(|tag| {
            matches!(tag.cycle, Cycle::FacePecking | Cycle::Drilling | Cycle::FaceDrilling)
        });
        // A keyway is shaped with the spindle held.
        if motion.process.turn == SpindleTurn::Stopped {
            return None;
        }
        let per_turn = match (motion.process.feed, motion.process.speed) {
            (Feed::PerTurn(feed), _) if feed < Feed::OF_OTHER_UNIT => feed,
            (Feed::PerMinute(feed), SpindleSpeed::Constant(speed)) if speed > 0.0 => feed / speed,
            _ => return None,
        };
        let is_large = blank.is_some_and(|stock| stock.diameter.mm() > LARGE);
        let is_fast = per_turn >= if is_large { FAST_ON_LARGE } else { FAST };
        let cuts_by_feed = motion.kind != MotionKind::Thread && (!on_axis || drills);
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
    motion.from.x.abs() <= OFF_AXIS && motion.to.x.abs() <= OFF_AXIS
}

/// Whether a tool that is made for something else may cut a thread of this lead.
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

/// Whether a tool only leaves the work: back the way it came with the cut before, or across from a shoulder that
/// this cut has left. It takes off no more than the wedge that the edge leaves at a wall.
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
    let scraped = (WEDGE * motion.length() * motion.length()).clamp(SCRAPED, MOST_SCRAPED);
    part.now().in_common(&cut(motion, &Turned::default(), tool)).area() <= scraped
}

/// Whether the middle of the way of the tip lies in material.
fn is_in_material(motion: &Motion, part: &mut Part) -> bool {
    let middle = match motion.arc() {
        Some(arc) => arc.at(0.5),
        None => {
            let (from, to) = (motion.from, motion.to);
            Point::new((from.x + to.x) / 2.0, (from.z + to.z) / 2.0)
        }
    };
    // The axis itself is the edge of the work.
    part.now().holds(Point::new(middle.x.max(OFF_AXIS), middle.z))
}
