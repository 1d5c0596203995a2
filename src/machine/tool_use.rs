//! The purposes that a program uses each turret station for, found from its motions.
//!
//! In: the motions, the tools that comments describe, the blank. Out: a [`ToolUse`] for each purpose of a
//! station, and a [`Tool`] that could do it.

use std::collections::BTreeMap;

use super::blank::{Extents, ON_AXIS};
use super::evidence::Evidence;
use super::finishing::Finishings;
use super::tool::BLADE;
use crate::cycles::drilling::OFF_CENTER;
use crate::cycles::single::cuts_along_x;
use crate::geometry::SAME;
use crate::motion::{Cycle, CycleFamily, Feed, Motion, MotionKind, SpindleTurn};
use crate::setup::stock::deepest_cut;
use crate::setup::{Side, Stock, Tool, ToolKind};
use crate::units::Diameter;

/// Most uses of stations that are distinguished. A turret with 60 stations has fewer.
const MAX_USES: usize = 300;

/// A shorter move back along +Z only clears the bottom of a groove, mm.
const SHORT: f64 = 2.0;

/// Widest material between two columns of pecks that is a ridge, mm; wider material is a land between two
/// grooves.
const RIDGE: f64 = 1.0;

/// From this feed on a move is as fast as a rapid, mm/rev.
const AS_RAPID: f64 = 1.0;

/// Thinnest wall between a bore and the turned outside, mm.
const WALL: f64 = 0.5;

/// Largest difference between the radius of a drill and the X at which its edge is programmed, mm.
const EDGE_OFF: f64 = 0.2;

/// A rapid that moves less across the axis than this share of its movement along it does not leave the
/// workpiece.
const ASIDE: f64 = 0.1;

/// The purpose of a motion, for choosing the tool.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Purpose {
    /// Turning, facing or boring.
    Turning,
    /// Thread cutting.
    Threading,
    /// Plunging.
    Grooving,
    /// Drilling or tapping on the axis.
    Hole,
    /// Work of a live tool.
    Live,
}

impl Purpose {
    /// The purpose of a motion.
    pub fn of(motion: &Motion) -> Self {
        let on_axis = motion.from.x.abs() <= 0.01 && motion.to.x.abs() <= 0.01;
        let along = (motion.to.z - motion.from.z).abs() > SAME;
        let of_motion = match motion.kind {
            _ if on_axis && along && motion.kind.cuts() => Self::Hole,
            MotionKind::Thread => Self::Threading,
            _ => Self::Turning,
        };
        match motion.cycle.map(|step| step.cycle.family()) {
            _ if motion.rotary.is_some() => Self::Live,
            Some(CycleFamily::SideHole) => Self::Live,
            Some(CycleFamily::FaceHole) if is_off_center_hole(motion) => Self::Hole,
            Some(CycleFamily::FaceHole) if !on_axis => Self::Live,
            Some(CycleFamily::Turning) => Self::Turning,
            Some(CycleFamily::Threading) if of_motion != Self::Hole => Self::Threading,
            Some(CycleFamily::Pecking) if of_motion == Self::Turning => Self::Grooving,
            Some(
                CycleFamily::Threading | CycleFamily::Pecking | CycleFamily::Contour | CycleFamily::FaceHole,
            )
            | None => of_motion,
        }
    }
}

/// A use of a station: its purpose, and the evidence from its motions.
#[derive(Clone, Copy, Debug)]
pub(super) struct ToolUse {
    pub station: u16,
    pub purpose: Purpose,
    /// The first motion of this use.
    pub first: usize,
    /// Number of cuts within the workpiece that the tool leaves outwards, minus those that it leaves inwards.
    outside: i32,
    /// Distance of the last cut on the chuck side of the face along Z, mm.
    along: f64,
    /// Radius from which the tool moved straight in at rapid in front of the face, mm: there an outside tool
    /// is clear of the workpiece.
    clear: Option<f64>,
    /// Whether it follows the contour of a cycle.
    pub contour: bool,
    /// Number of plunges that return along the same path, and of all cuts. Each step of a plunge counts.
    plunges: u32,
    cuts: u32,
    /// Number of steps straight into the workpiece that are followed by another step.
    steps: u32,
    /// Whether it dwells at the end of a cut straight across the axis.
    dwells: bool,
    /// The last pass of G73, and the radius of its start, mm.
    pattern: Option<(u32, f64)>,
    /// Number of cuts towards −Z; towards +Z that end at a shoulder or climb; and towards +Z that descend.
    left: u32,
    right: u32,
    down: u32,
    /// Whether it runs a facing cycle, whose cuts towards +Z are returns or follow the contour.
    faces: bool,
    /// Z of the cut straight into the workpiece that is nearest to the face, mm: the tool returns to it
    /// through the air.
    front: f64,
    /// Number of cuts along Z that end at negative Z and are followed by a cut straight into the workpiece.
    approaches: u32,
    /// Smallest radius of cuts along Z at negative Z, mm; infinite if there are none.
    pub turned: f64,
    /// Whether the first cut that reaches negative Z falls towards the axis, like the chamfer of a bore.
    narrows: Option<bool>,
    /// Number of moves into the workpiece along the axis and back, and Z of the deepest, mm.
    holes: u32,
    pub deepest: f64,
    /// Steepest descent behind the tip, radians from the spindle axis: outside and inside.
    slopes: [f64; 2],
    /// Number of cuts that can be a hole off the axis: plunges, cuts straight across into the workpiece
    /// followed by a rapid, and cuts straight along Z that return along the same path.
    like_holes: u32,
    /// Number of cuts straight across the axis.
    across: u32,
    /// Number of cuts with a spindle that turned before and is stopped now, while something may drive the
    /// tool.
    stopped: u32,
    /// Radius of the cuts straight along Z into the workpiece, mm, if all cuts have the same one: the edge of
    /// a drill.
    edge: Option<f64>,
    /// Whether it leaves the workpiece sideways at negative Z.
    aside: bool,
    /// Whether its first cut is on the side of −X.
    negative: bool,
    /// Greatest radius at negative Z since the last rapid or the last move from in front of the face, mm.
    deep: f64,
    /// Whether it leaves along Z at a radius smaller than `deep`, where an outside tool would collide with
    /// the workpiece.
    retreats: bool,
    /// Whether it taps: on the axis, locked to the spindle.
    taps: bool,
    /// Position of the last column of pecks, and the greatest distance of two columns of one cycle: along Z,
    /// or across for grooves in the face, mm.
    column: Option<f64>,
    columns: f64,
    /// Whether grooves are in the end face.
    face: bool,
    pub extents: Extents,
}

/// The frame of the cuts that are used.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Clamping {
    /// Cuts in the frame of the first cut.
    First,
    /// Cuts [elsewhere](crate::motion::Process::elsewhere).
    Other,
}

impl Clamping {
    fn of(motion: &Motion) -> Self {
        if motion.process.other_setup { Self::Other } else { Self::First }
    }
}

impl ToolUse {
    /// All uses of stations in a clamping.
    pub fn all(
        evidence: &Evidence,
        described_tools: &BTreeMap<u16, Tool>,
        stock: Option<Stock>,
        clamping: Clamping,
    ) -> Vec<Self> {
        let mut seen: Vec<ToolUse> = Vec::new();
        let mut before = None;
        let finishings = Finishings::of(evidence);
        let mut has_turned = false;
        // Number of turns of C at rapid, by station.
        let mut turns_of_c: BTreeMap<u16, u32> = BTreeMap::new();
        let is_certain = |(_, motion): &(usize, Motion)| !motion.process.uncertain;
        let mut moves = evidence.moves().enumerate().filter(is_certain).peekable();
        while let Some((index, motion)) = moves.next() {
            let mut dwells = false;
            while moves.next_if(|(_, next)| next.kind == MotionKind::Dwell).is_some() {
                dwells = true;
            }
            if motion.kind == MotionKind::Dwell {
                continue;
            }
            let before = before.replace(motion);
            has_turned |= motion.process.turn != SpindleTurn::Stopped;
            if motion.rotary.is_some() && !motion.kind.cuts() {
                // A turn of C after a cut counts twice: between two cuts only a live tool needs it.
                let station = motion.process.tool.0;
                let has_cut = seen.iter().any(|own| own.station == station);
                *turns_of_c.entry(station).or_default() += 1 + u32::from(has_cut);
            }
            let counts = motion.kind.cuts() && !motion.process.still;
            if !counts || Clamping::of(&motion) != clamping {
                continue;
            }
            let (station, purpose) = (motion.process.tool.0, Purpose::of(&motion));
            let known = seen.iter().position(|own| (own.station, own.purpose) == (station, purpose));
            let at = match known {
                Some(at) => at,
                None if seen.len() == MAX_USES => continue,
                None => {
                    let negative = evidence.is_on_negative_x(index);
                    seen.push(ToolUse { negative, ..ToolUse::new(station, purpose, index) });
                    seen.len() - 1
                }
            };
            let next = moves.peek().map(|(_, next)| next);
            seen[at].add_evidence(&motion, before.as_ref(), next, finishings.side(index));
            seen[at].stopped += u32::from(has_turned && motion.process.turn == SpindleTurn::Stopped);
            let across = (motion.to.z - motion.from.z).abs() <= SAME && motion.to.x < motion.from.x - SAME;
            seen[at].dwells |= dwells && across && motion.to.z < -SAME && motion.to.x > 1.0;
        }
        // The beginning of a contour on the axis, or the return of a facing tool, is not a hole.
        let stations: Vec<u16> =
            seen.iter().filter(|own| own.purpose != Purpose::Hole).map(|own| own.station).collect();
        seen.retain(|own| own.purpose != Purpose::Hole || own.holes > 0 || !stations.contains(&own.station));
        let has_positive = seen.iter().any(|own| !own.negative);
        for own in &mut seen {
            let turns_of_c = turns_of_c.get(&own.station).copied().unwrap_or_default();
            let words = described_tools.get(&own.station);
            let is_face =
                |words: &Tool| words.kind == Some(ToolKind::Grooving) && words.side == Some(Side::Face);
            own.negative &= has_positive;
            let is_narrow = own.extents.behind() - own.extents.least() <= BLADE;
            own.face |= own.purpose == Purpose::Turning && is_narrow && words.is_some_and(is_face);
            own.purpose = own.purpose_by_words(words, turns_of_c);
        }
        // A live cutter that also moves along X or Z alone does not bore.
        let live: Vec<u16> =
            seen.iter().filter(|own| own.purpose == Purpose::Live).map(|own| own.station).collect();
        for own in seen.iter_mut().filter(|own| live.contains(&own.station)) {
            own.outside = 0;
        }
        // A drill that is fed off the axis within its hole is still a drill.
        let holes: Vec<(u16, f64)> =
            seen.iter().filter(|own| own.holes > 0).map(|own| (own.station, own.deepest)).collect();
        let is_in_hole = |own: &ToolUse| {
            holes.iter().any(|&(station, bottom)| station == own.station && bottom <= own.deepest - SAME)
        };
        seen.retain(|own| {
            own.purpose != Purpose::Turning || own.outside != 0 || own.contour || !is_in_hole(own)
        });
        // Uses that the motions do not decide are decided by comments and by the grooves of the same tool.
        let inside: Vec<u16> = seen.iter().filter(|own| own.is_inside()).map(|own| own.station).collect();
        for own in seen.iter_mut().filter(|own| own.outside == 0) {
            let bores = bores(described_tools.get(&own.station)) || inside.contains(&own.station);
            own.outside = if bores { -1 } else { 0 };
        }
        for index in 0..seen.len() {
            if seen[index].outside == 0 && bores_after_drill(&seen[index], &seen) {
                seen[index].outside = -1;
            }
        }
        // A solid bar cannot be bored: a tool that leaves a cut inwards there would collide with the
        // workpiece.
        let is_drilled = seen.iter().any(|own| own.purpose == Purpose::Hole);
        if stock.is_some_and(|stock| stock.bore.mm() <= SAME) && !is_drilled {
            for own in seen.iter_mut().filter(|own| !bores(described_tools.get(&own.station))) {
                own.outside = own.outside.max(0);
            }
        }
        seen
    }

    fn new(station: u16, purpose: Purpose, first: usize) -> Self {
        Self {
            station,
            purpose,
            first,
            outside: 0,
            along: 0.0,
            clear: None,
            contour: false,
            plunges: 0,
            cuts: 0,
            steps: 0,
            dwells: false,
            pattern: None,
            left: 0,
            right: 0,
            down: 0,
            faces: false,
            front: f64::NEG_INFINITY,
            approaches: 0,
            turned: f64::INFINITY,
            narrows: None,
            holes: 0,
            deepest: f64::INFINITY,
            slopes: [0.0; 2],
            like_holes: 0,
            across: 0,
            stopped: 0,
            edge: None,
            aside: false,
            negative: false,
            deep: f64::NEG_INFINITY,
            retreats: false,
            taps: false,
            column: None,
            columns: 0.0,
            face: false,
            extents: Extents::default(),
        }
    }

    /// Whether it works in a bore.
    pub fn is_inside(&self) -> bool {
        self.outside < 0 && matches!(self.purpose, Purpose::Turning | Purpose::Threading | Purpose::Grooving)
    }

    /// The purpose, corrected by comments, the spindle and the C axis: off the axis a drill or end mill is a
    /// live tool, and a tool that pecks near the axis is a drill.
    fn purpose_by_words(&self, words: Option<&Tool>, turns_of_c: u32) -> Purpose {
        let kind = words.and_then(|words| words.kind);
        let is_cutter = kind == Some(ToolKind::Endmill);
        let is_drill = matches!(kind, Some(ToolKind::Drill | ToolKind::Tap));
        let is_insert = matches!(kind, Some(ToolKind::Grooving | ToolKind::Turning | ToolKind::Boring));
        let all_stopped = self.stopped == self.cuts;
        // H beside G41 also turns C, so a single turn is weak evidence.
        let moves_with_c = turns_of_c > 1 || turns_of_c > 0 && all_stopped;
        match self.purpose {
            Purpose::Turning if is_cutter && (self.is_across() || moves_with_c || all_stopped) => {
                Purpose::Live
            }
            Purpose::Turning if is_drill && self.makes_holes() && (self.is_across() || all_stopped) => {
                Purpose::Live
            }
            Purpose::Turning if self.is_programmed_by_edge(words, moves_with_c) => Purpose::Hole,
            Purpose::Turning if self.face => Purpose::Grooving,
            Purpose::Turning if moves_with_c && (self.is_across() || self.makes_holes()) => Purpose::Live,
            Purpose::Grooving if self.face && self.extents.behind() <= OFF_CENTER && !is_insert => {
                Purpose::Hole
            }
            purpose => purpose,
        }
    }

    /// Whether it is a drill that is programmed by its edge: all cuts go straight along Z at one X, the
    /// diameter of the hole, while the workpiece turns. A comment names the drill, or no other tool works on
    /// the side of −X.
    fn is_programmed_by_edge(&self, words: Option<&Tool>, moves_with_c: bool) -> bool {
        let Some(edge) = self.edge.filter(|_| self.stopped == 0 && !self.aside && !moves_with_c) else {
            return false;
        };
        match words.and_then(|words| words.kind.map(|kind| (kind, words.diameter))) {
            Some((kind, diameter)) => {
                let fits = |diameter: Diameter| (diameter.radius() - edge).abs() <= EDGE_OFF;
                kind == ToolKind::Drill && diameter.is_none_or(fits)
            }
            None => self.negative,
        }
    }

    /// Whether all cuts go straight across the axis.
    fn is_across(&self) -> bool {
        self.across == self.cuts
    }

    /// Whether all cuts, except approaches to plunges, go straight across the axis, and some are plunges.
    fn only_plunges(&self) -> bool {
        let leads_there = self.approaches > 0 && self.across + self.approaches == self.cuts;
        self.plunges > 0 && (self.plunges == self.cuts || leads_there || self.dwells)
    }

    /// Whether all cuts can be holes off the axis.
    fn makes_holes(&self) -> bool {
        self.like_holes >= self.cuts
    }

    /// Adds the evidence of a cut. `side` is the side of its finishing cycle, if known.
    fn add_evidence(
        &mut self,
        motion: &Motion,
        before: Option<&Motion>,
        next: Option<&Motion>,
        side: Option<i32>,
    ) {
        let way = |motion: &Motion| (motion.to.x - motion.from.x, motion.to.z - motion.from.z);
        let (dx, dz) = way(motion);
        let at = motion.from.x;
        let is_led_along = dx.abs() <= SAME && at > OFF_CENTER;
        let is_same = self.cuts == 0 || self.edge.is_some_and(|edge| (edge - at).abs() <= SAME);
        self.edge = (is_led_along && is_same).then_some(at);
        self.cuts += 1;
        self.taps |= motion.kind == MotionKind::Thread;
        self.extents.add(motion);
        self.note_retreat(motion, before, next);
        let after_x = next.map_or(0.0, |next| way(next).0);
        // Between two tools the turret moves home, even if the program does not show it.
        let own_next = next.filter(|next| next.process.tool == motion.process.tool);
        // Distance of a rapid straight across the axis before the cut.
        let mut infeed = 0.0;
        if let Some(rapid) = before.filter(|before| before.kind == MotionKind::Rapid) {
            let (dx, dz) = way(rapid);
            infeed = if dz.abs() <= SAME { dx } else { 0.0 };
            self.clear = (infeed < -SAME && rapid.to.z > SAME).then_some(rapid.from.x);
        }
        let returns = dz.abs() <= SAME && self.clear.is_some_and(|clear| (motion.to.x - clear).abs() <= SAME);
        self.outside += match motion.cycle.map(|step| (step.cycle, step.pass)) {
            Some((Cycle::Pattern, pass)) => self.goes_on_in_pattern(pass, motion.from.x),
            // A pass of G71 begins outside of its cut, in a bore nearer to the axis. This counts more than
            // how the tool leaves.
            Some((Cycle::RoughTurning, _)) if infeed < -SAME => 2,
            Some((Cycle::RoughTurning, _)) if infeed > SAME => -2,
            _ if dx > SAME && returns => 1,
            // From the axis out to the mouth of a bore.
            _ if dx > SAME && motion.from.x <= ON_AXIS && motion.from.z < -SAME && motion.to.z > SAME => -2,
            _ => side.unwrap_or_else(|| leaves(motion, self.along, own_next)),
        };
        self.along = if motion.to.z < -SAME { dz } else { 0.0 };
        if dz.abs() > SAME && motion.to.z < -SAME {
            self.turned = self.turned.min(motion.from.x.min(motion.to.x));
            self.narrows.get_or_insert(dz < -SAME && dx < -SAME);
        }
        let cycle = motion.cycle.map(|step| step.cycle);
        self.contour |= cycle.is_some_and(|cycle| cycle.family() == CycleFamily::Contour);
        let plunges = self.plunges;
        self.note_plunge(motion, before, next);
        let goes_in = dz.abs() <= SAME && dx < -SAME && motion.to.z < -SAME;
        let is_single = goes_in && next.is_none_or(|next| !next.kind.cuts());
        self.across += u32::from(dz.abs() <= SAME);
        self.like_holes += match self.plunges - plunges {
            0 => u32::from(is_single || is_along_and_back(motion, before, next)),
            plunges => plunges,
        };
        // Towards −Z, or towards +Z while still on the chuck side of the face.
        let ends_at_shoulder = dx > SAME || (dx.abs() <= SAME && after_x > SAME);
        self.left += u32::from(dz < -SAME);
        let is_new = motion.to.z < -SAME && motion.to.z > self.front + SAME;
        self.right += u32::from(dz > SAME && is_new && ends_at_shoulder);
        if dz.abs() <= SAME && dx < -SAME {
            self.front = self.front.max(motion.to.z);
        }
        self.down += u32::from(dz > SAME && dx < -SAME);
        self.faces |= cycle.is_some_and(cuts_along_x);
        let goes_along = dx.abs() <= SAME && dz < -SAME && motion.to.z < -SAME;
        let goes_in_next = next.is_some_and(|next| {
            let (dx, dz) = way(next);
            next.kind.cuts() && dx < -SAME && dz.abs() <= SAME
        });
        self.approaches += u32::from(goes_along && goes_in_next);
        let axis = |motion: &Motion| motion.from.x.abs() <= 0.01 && motion.to.x.abs() <= 0.01;
        self.holes += u32::from(dz < -SAME && is_off_center_hole(motion));
        let drills = !matches!(cycle, None | Some(Cycle::Finishing | Cycle::RoughTurning | Cycle::Pattern));
        self.deepest = self.deepest.min(motion.to.z);
        self.holes += u32::from(dz < -SAME && axis(motion) && (drills || next.is_some_and(axis)));
        if motion.cycle.is_some_and(|step| step.cycle == Cycle::FacePecking) {
            self.face = true;
        }
        self.note_columns(motion, before);
        // An approach to the workpiece at feed follows no slope.
        if motion.to.z > SAME && before.is_none_or(|before| !before.kind.cuts()) {
            return;
        }
        let [outside, inside] = &mut self.slopes;
        for (sx, slope) in [(1.0, outside), (-1.0, inside)] {
            // Only a descent along Z is a slope of the workpiece; straight in is a plunge.
            for (dx, dz) in directions(motion) {
                if dz < -SAME && sx * dx < -SAME {
                    *slope = slope.max((sx * -dx).atan2(-dz));
                }
            }
        }
    }

    /// Notes a retreat in front of the face, straight along Z at rapid or as fast.
    fn note_retreat(&mut self, motion: &Motion, before: Option<&Motion>, next: Option<&Motion>) {
        let is_fast = |motion: &Motion| match motion.process.feed {
            _ if motion.kind == MotionKind::Rapid => true,
            Feed::PerTurn(feed) => feed >= AS_RAPID,
            Feed::PerMinute(_) | Feed::Unset => false,
        };
        if before.is_none_or(|before| !before.kind.cuts()) || motion.from.z > -SAME {
            self.deep = f64::NEG_INFINITY;
        }
        if motion.to.z < -SAME && (motion.to.z - motion.from.z).abs() > SAME {
            self.deep = self.deep.max(motion.from.x).max(motion.to.x);
        }
        let Some(next) = next.filter(|next| is_fast(next) && motion.to.z < -SAME) else { return };
        let is_straight = (next.to.x - next.from.x).abs() <= SAME;
        self.aside |= !is_straight;
        self.retreats |= is_straight && next.to.z > -SAME && self.deep > motion.to.x + SAME;
    }

    /// Notes the distance between the columns of G74 and G75.
    fn note_columns(&mut self, motion: &Motion, before: Option<&Motion>) {
        let Some(cycle) =
            motion.cycle.map(|step| step.cycle).filter(|cycle| cycle.family() == CycleFamily::Pecking)
        else {
            self.column = None;
            return;
        };
        let at = if cycle == Cycle::FacePecking { motion.from.x } else { motion.from.z };
        let is_same_cycle = before.is_some_and(|before| before.cycle.map(|step| step.cycle) == Some(cycle));
        if let Some(last) = self.column.replace(at).filter(|_| is_same_cycle) {
            self.columns = self.columns.max((at - last).abs());
        }
    }

    /// The side of a pass of G73: the passes approach the contour from outside (1) or from the axis (−1).
    fn goes_on_in_pattern(&mut self, pass: u32, begins: f64) -> i32 {
        match self.pattern {
            Some((last, _)) if last == pass => 0,
            before => {
                self.pattern = Some((pass, begins));
                let moved =
                    before.filter(|(last, _)| *last < pass).map_or(0.0, |(_, before)| before - begins);
                if moved.abs() <= SAME { 0 } else { moved.signum() as i32 }
            }
        }
    }

    /// Counts a cut straight across the axis that returns, in one step or several; between steps the tool may
    /// retract slightly at rapid to break the chip.
    fn note_plunge(&mut self, motion: &Motion, before: Option<&Motion>, next: Option<&Motion>) {
        let across = |motion: &&Motion| (motion.to.z - motion.from.z).abs() <= SAME;
        let way = |motion: &Motion| motion.to.x - motion.from.x;
        let dx = way(motion);
        let (Some(next), true) = (next.filter(across), across(&motion)) else {
            self.steps = 0;
            return;
        };
        let comes_back = before.filter(across).is_some_and(|before| {
            let first = way(before);
            first * dx < 0.0 && dx.abs() >= first.abs() - SAME
        });
        let goes_back =
            way(next) * dx < 0.0 && (next.kind == MotionKind::Rapid || way(next).abs() >= dx.abs() - SAME);
        if comes_back || goes_back {
            self.plunges += 1 + std::mem::take(&mut self.steps);
        } else if next.kind.cuts() && way(next) * dx > 0.0 {
            self.steps += 1;
        } else {
            self.steps = 0;
        }
    }

    /// A tool that could do this use; `bore` is the radius at which boring begins.
    pub fn tool(&self, bore: f64) -> Tool {
        let inside = self.is_inside();
        let side = if inside { Side::Inside } else { Side::Outside };
        match self.purpose {
            // Holes off the axis are drilled; all other work of live tools is milling.
            Purpose::Live if self.makes_holes() => Tool { kind: Some(ToolKind::Drill), ..Tool::default() },
            Purpose::Live => Tool { kind: Some(ToolKind::Endmill), ..Tool::default() },
            Purpose::Hole => {
                if let Some(edge) = self.edge {
                    let diameter = Some(Diameter::from_radius(edge));
                    return Tool { kind: Some(ToolKind::Drill), diameter, tip: Some(6), ..Tool::default() };
                }
                let kind = if self.taps { ToolKind::Tap } else { ToolKind::Drill };
                // A drill off the axis makes a larger hole.
                let radius = bore - self.extents.behind();
                let diameter = if radius.is_finite() && radius > 0.0 {
                    Some(Diameter::from_radius(radius))
                } else {
                    None
                };
                Tool { kind: Some(kind), diameter, ..Tool::default() }
            }
            Purpose::Threading => {
                Tool { kind: Some(ToolKind::Threading), side: Some(side), ..Tool::default() }
            }
            Purpose::Grooving => self.blade(if self.face { Side::Face } else { side }),
            Purpose::Turning if self.only_plunges() => self.blade(Side::Outside),
            Purpose::Turning => {
                let kind = if inside { ToolKind::Boring } else { ToolKind::Turning };
                let slope = self.slopes[usize::from(inside)].to_degrees();
                // A tool that only cuts away from the chuck has its edge on the other side.
                let is_left_hand = self.right > 0 && self.left + self.down == 0 && !self.faces;
                let tip = (!inside && is_left_hand).then_some(4);
                // The usual roughing tool, or the bluntest one that can follow the slope.
                let (insert, entering) = match slope {
                    slope if slope < 4.5 => ("C", 95.0),
                    slope if slope < 31.5 => ("D", 93.0),
                    slope if slope < 51.5 => ("V", 93.0),
                    _ => {
                        let point = (88.0 - slope).max(1.0);
                        return Tool {
                            kind: Some(kind),
                            point_angle: Some(point),
                            entering_angle: Some(91.0),
                            tip,
                            ..Tool::default()
                        };
                    }
                };
                Tool {
                    kind: Some(kind),
                    insert: Some(insert.into()),
                    entering_angle: Some(entering),
                    tip,
                    ..Tool::default()
                }
            }
        }
    }

    /// A grooving insert, as wide as the distance of the columns if one of the default width would leave
    /// ridges.
    fn blade(&self, side: Side) -> Tool {
        let leaves_ridges = self.columns > BLADE + SAME && self.columns <= BLADE + RIDGE + SAME;
        let width = leaves_ridges.then_some(BLADE + RIDGE);
        Tool { kind: Some(ToolKind::Grooving), side: Some(side), width, ..Tool::default() }
    }
}

/// Whether a motion belongs to a hole cycle of a drill slightly off the axis with a turning spindle, as
/// indexable drills are set.
fn is_off_center_hole(motion: &Motion) -> bool {
    let is_hole = motion
        .cycle
        .is_some_and(|step| step.cycle.family() == CycleFamily::FaceHole && step.cycle != Cycle::FaceTapping);
    let turns = motion.process.turn != SpindleTurn::Stopped && motion.rotary.is_none();
    is_hole && turns && motion.from.x.abs().max(motion.to.x.abs()) <= OFF_CENTER
}

/// Whether a cut straight along Z returns along the same path, or is that return.
fn is_along_and_back(motion: &Motion, before: Option<&Motion>, next: Option<&Motion>) -> bool {
    let along = |motion: &&Motion| (motion.to.x - motion.from.x).abs() <= SAME;
    let way = |motion: &Motion| motion.to.z - motion.from.z;
    let goes_back = |first: &Motion, second: &Motion| way(first) < -SAME && way(second) > SAME;
    along(&motion)
        && (next.filter(along).is_some_and(|next| goes_back(motion, next))
            || before.filter(along).is_some_and(|before| before.kind.cuts() && goes_back(before, motion)))
}

/// Whether a comment describes a tool for a bore.
fn bores(words: Option<&Tool>) -> bool {
    words.is_some_and(|tool| tool.kind == Some(ToolKind::Boring) || tool.side == Some(Side::Inside))
}

/// Whether a use that leaves the workpiece neither outwards nor inwards works in a hole that was drilled
/// before: deeper within turned material than an insert cuts in one pass, or from a chamfer inwards, or it
/// leaves at a smaller radius than its cuts. The last case needs no drilled hole if another tool turns the
/// outside.
fn bores_after_drill(own: &ToolUse, all: &[ToolUse]) -> bool {
    let is_drilled = all.iter().any(|hole| {
        hole.purpose == Purpose::Hole && hole.first < own.first && hole.deepest <= own.deepest + SAME
    });
    let turned = all.iter().filter(|other| other.purpose == Purpose::Turning && other.outside > 0);
    let turned = turned.map(|other| other.turned).fold(f64::INFINITY, f64::min);
    let wall = turned - own.extents.behind();
    let is_bored = own.narrows == Some(true) || own.retreats;
    let is_within = match turned.is_finite() {
        true => wall > deepest_cut(turned) || is_bored && wall > WALL,
        false => is_bored,
    };
    is_within && (is_drilled || own.retreats && turned.is_finite())
}

/// Direction in which a tool leaves the workpiece after a cut: 1 outwards, −1 inwards, 0 if unknown. Between
/// cuts it follows the contour, which may fall or rise. `along` is the distance of the previous cut along Z.
fn leaves(motion: &Motion, along: f64, next: Option<&Motion>) -> i32 {
    let (dx, dz) = (motion.to.x - motion.from.x, motion.to.z - motion.from.z);
    // A cut to the axis faces the workpiece. After a short move back along +Z from the bottom of a groove,
    // either direction is possible.
    let faces = dx < -SAME && motion.to.x <= 1.0;
    if motion.to.z > SAME || faces || next.is_some_and(|next| next.kind.cuts()) {
        return 0;
    }
    let is_last = next.is_none();
    let goes_back = (SAME..SHORT).contains(&dz) && dx.abs() <= SAME;
    let aside = |next: &&Motion| (next.to.x - next.from.x).abs() > ASIDE * (next.to.z - next.from.z).abs();
    let next = next.filter(|_| !goes_back).filter(aside);
    let after = next.map_or(0.0, |next| next.to.x - next.from.x);
    let escapes = along.abs() > SAME && dz * along <= SAME * SAME;
    // A program that ends in the bottom of a groove does not leave the workpiece.
    let on_the_way = if escapes && !is_last { dx } else { 0.0 };
    // A move deeper along Z does not leave the workpiece.
    let deeper = next.is_some_and(|next| next.to.z < next.from.z - SAME);
    // Straight out, or back along Z from the end of the last cut.
    match if after.abs() > SAME { after } else { on_the_way } {
        way if way > SAME => 1,
        way if way < -SAME && !deeper => -1,
        _ => 0,
    }
}

/// Directions of a cut: one for a line, those at both ends and the middle for an arc.
fn directions(motion: &Motion) -> Vec<(f64, f64)> {
    match motion.arc() {
        None => vec![(motion.to.x - motion.from.x, motion.to.z - motion.from.z)],
        Some(arc) => {
            let points: Vec<_> = (0..=8).map(|index| arc.at(f64::from(index) / 8.0)).collect();
            points.windows(2).map(|ends| (ends[1].x - ends[0].x, ends[1].z - ends[0].z)).collect()
        }
    }
}
