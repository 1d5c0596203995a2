//! Detects unusual removals: cycles that remove nothing, cuts deeper than an insert bears, cuts beyond the
//! back of the blank, threads with a wrong depth or too near a shoulder.
//!
//! In: each motion with its tool, and the workpiece before it. Out: [`Unusual`]s, only with a given blank,
//! and none after M00, because the workpiece may be turned around or changed there. Must not know messages.

use std::collections::BTreeSet;

use super::part::{Part, Turned, cut};
use super::region::Region;
use super::resolved_setup::{Basis, ResolvedSetup, ResolvedTool};
use super::thread_depth::{Threads, UnusualDepth};
use super::thread_run_out::{RunOuts, ShortRunOut};
use super::tool::Action;
use crate::cycles::single::cuts_along_x;
use crate::geometry::Point;
use crate::motion::{Cycle, CycleFamily, Motion, MotionKind, Motions, StopKind};
use crate::setup::stock::deepest_cut;
use crate::setup::{Stock, ToolKind};

/// An unusual removal of material.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Unusual {
    /// Index of the motion.
    pub motion: usize,
    /// The kind of removal.
    pub removal: Removal,
}

/// A kind of unusual removal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Removal {
    /// No move of a cycle call comes near the workpiece; without a cycle, no plain cut of a tool.
    Nothing(Option<Cycle>),
    /// A cut is deeper than an insert bears. Lengths in mm, across the cut.
    TooDeep {
        /// Depth of the cut.
        depth: f64,
        /// Greatest permitted depth.
        most: f64,
    },
    /// A cut continues beyond the back of the blank.
    BeyondBlank {
        /// Z of its end, mm.
        z: f64,
        /// Z of the back of the blank, mm.
        back: f64,
    },
    /// The depth of a thread does not fit its lead. Lengths in mm.
    ThreadDepth {
        /// Its depth on one side.
        depth: f64,
        /// Its lead.
        lead: f64,
    },
    /// A thread ends nearer to a shoulder than the slide needs to stop. Lengths in mm.
    ThreadRunOut(ShortRunOut),
}

/// A cycle that is at most this far from the workpiece, mm, may be a finishing pass.
const FINISHING: f64 = 0.1;

/// A blank may be longer than given by this much in front of the face, mm: a bar is sawn off, then faced.
const SAWN: f64 = 5.0;

/// A tool may go this far beyond the back of a blank, mm: rings and tubes are machined over their whole
/// length.
const OVERRUN: f64 = 5.0;

/// Shorter cuts are not checked for depth, mm.
const SHORT: f64 = 5.0;

/// A call of a cycle.
#[derive(Clone, Copy, Debug)]
struct Call {
    cycle: Cycle,
    /// Its first cut, and the first byte of its block.
    first: Option<(usize, u32)>,
    /// Its last pass.
    pass: u32,
    /// Whether it removes material.
    takes: bool,
    /// Least Z of its ends, mm.
    back: f64,
    /// Whether the tool comes from a call of the same cycle without another move between.
    repeats: bool,
}

/// The cuts of a tool until the next T word.
#[derive(Clone, Copy, Debug)]
struct PlainCuts {
    /// Station and offset of the T word.
    tool: (u16, u16),
    first: Option<usize>,
    /// Whether it touches the work, or whether its cuts are checked elsewhere.
    takes: bool,
    /// Least Z of its ends, mm.
    back: f64,
}

/// Checks the removal of material, motion by motion.
#[derive(Clone, Debug)]
pub struct RemovalWatch {
    /// The given blank.
    stock: Option<Stock>,
    /// The motion from which on nothing is checked.
    end: usize,
    call: Option<Call>,
    plain: Option<PlainCuts>,
    /// Blocks of cycles that have removed material. When they run again, for the next part, they need not
    /// remove anything.
    done: BTreeSet<u32>,
    threads: Threads,
    run_outs: RunOuts,
    /// All findings.
    pub found: Vec<Unusual>,
}

impl RemovalWatch {
    /// A watch for a program with this blank.
    pub fn new(resolved: &ResolvedSetup, motions: &Motions) -> Self {
        let given = resolved.stock().filter(|stock| stock.1 == Basis::Given);
        let stops = || {
            motions
                .stops(0..motions.len())
                .filter(|(_, stop)| stop.kind == StopKind::Always)
                .map(|stop| stop.0)
        };
        let first_cut = || motions.iter().position(|motion| motion.kind.cuts());
        let end = stops().next().and_then(|_| first_cut()).and_then(|cut| stops().find(|&stop| stop > cut));
        Self {
            stock: given.map(|given| given.0),
            end: end.unwrap_or(usize::MAX),
            call: None,
            plain: None,
            done: BTreeSet::new(),
            threads: Threads::default(),
            run_outs: RunOuts::default(),
            found: Vec::new(),
        }
    }

    /// Checks the next motion, before its material is removed. `block` returns the first byte of its block.
    pub fn check_motion(
        &mut self,
        index: usize,
        motion: &Motion,
        block: impl Fn() -> u32,
        resolved: &ResolvedSetup,
        part: &mut Part,
    ) {
        let Some(stock) = self.stock.filter(|_| index < self.end) else { return };
        let process = &motion.process;
        let tool = resolved.tool(motion);
        let is_turned = motion.rotary.is_none() && tool.shape.action != Action::Live;
        if !process.removes_material() || process.incomplete || !is_turned {
            (self.call, self.threads) = (None, Threads::default());
            self.cuts_of(motion).takes = true;
            return;
        }
        if motion.kind == MotionKind::Thread {
            let over = self.threads.pass(index, motion, || part.now());
            self.found.extend(over.map(thread_depth));
            if let Some(short) = self.run_outs.pass(motion, || part.now()) {
                self.report(index, Removal::ThreadRunOut(short));
            }
        }
        self.cycle(index, motion, block, tool, part);
        self.plain_cut(index, motion, tool, part);
        if !motion.kind.cuts() {
            return;
        }
        let insert = match tool.tool.kind {
            Some(ToolKind::Turning | ToolKind::Boring | ToolKind::Grooving | ToolKind::Threading) => true,
            Some(ToolKind::Drill | ToolKind::Tap | ToolKind::Endmill) | None => false,
        };
        if insert && let Some(z) = behind(&stock, motion) {
            self.report(index, Removal::BeyondBlank { z, back: stock.back() });
        }
        if let Some((depth, most)) = too_deep(&stock, motion, tool, part) {
            self.report(index, Removal::TooDeep { depth, most });
        }
    }

    /// Ends the checks after the last motion.
    pub fn finish(&mut self) {
        self.close();
        self.close_plain();
        let over = self.threads.close();
        self.found.extend(over.map(thread_depth));
    }

    fn report(&mut self, motion: usize, removal: Removal) {
        self.found.push(Unusual { motion, removal });
    }

    /// Checks a motion with the cycle call that it belongs to, if any.
    fn cycle(
        &mut self,
        index: usize,
        motion: &Motion,
        block: impl Fn() -> u32,
        tool: &ResolvedTool,
        part: &mut Part,
    ) {
        let watched = motion.cycle.filter(|tag| match tag.cycle.family() {
            CycleFamily::Turning | CycleFamily::Threading | CycleFamily::Contour | CycleFamily::Pecking => {
                true
            }
            CycleFamily::FaceHole | CycleFamily::SideHole => false,
        });
        let Some(tag) = watched else { return self.close() };
        let begins = self.call.is_none_or(|call| {
            // A groove may have a single column.
            let may_begin = tag.pass > 0 && tag.pass < call.pass || tag.cycle == Cycle::Grooving;
            call.cycle != tag.cycle || may_begin && call.first.is_none_or(|first| first.1 != block())
        });
        let repeats = begins && self.call.is_some_and(|call| call.cycle == tag.cycle);
        if begins {
            self.close();
        }
        let new = Call { cycle: tag.cycle, first: None, pass: 0, takes: false, back: f64::INFINITY, repeats };
        let call = self.call.get_or_insert(new);
        call.pass = call.pass.max(tag.pass);
        let roughs = matches!(tag.cycle, Cycle::RoughTurning | Cycle::RoughFacing | Cycle::Pattern)
            || tag.cycle == Cycle::Grooving && call.repeats;
        if !motion.kind.cuts() {
            return;
        }
        call.back = call.back.min(motion.to.z);
        if call.first.is_none() {
            call.first = Some((index, block()));
        }
        if !call.takes {
            let now = part.now();
            call.takes = match roughs {
                true => meets(now, motion, Point::new(0.0, 0.0), tool),
                false => touches(now, motion, tool),
            };
        }
    }

    /// Ends the current call.
    fn close(&mut self) {
        let Some(Call { cycle, first: Some((first, block)), takes, back, .. }) = self.call.take() else {
            return;
        };
        let faces = cuts_along_x(cycle);
        if takes || faces && self.is_just_in_front(back) {
            self.done.insert(block);
        } else if self.done.insert(block) {
            self.report(first, Removal::Nothing(Some(cycle)));
        }
    }

    /// Whether a cut that ends at this Z is just in front of the blank: a bar is seldom as long as stated.
    fn is_just_in_front(&self, z: f64) -> bool {
        self.stock.is_some_and(|stock| z > stock.face - FINISHING && z < stock.face + SAWN)
    }

    /// The cuts of the tool of a motion.
    fn cuts_of(&mut self, motion: &Motion) -> &mut PlainCuts {
        let tool = motion.process.tool;
        if self.plain.is_some_and(|cuts| cuts.tool != tool) {
            self.close_plain();
        }
        let new = PlainCuts { tool, first: None, takes: false, back: f64::INFINITY };
        self.plain.get_or_insert(new)
    }

    /// Checks a motion with the other cuts of its tool.
    fn plain_cut(&mut self, index: usize, motion: &Motion, tool: &ResolvedTool, part: &mut Part) {
        let cuts = self.cuts_of(motion);
        if cuts.takes || !motion.kind.cuts() {
            return;
        }
        cuts.first.get_or_insert(index);
        cuts.back = cuts.back.min(motion.to.z);
        let is_plain = motion.cycle.is_none()
            && matches!(tool.tool.kind, Some(ToolKind::Turning | ToolKind::Boring | ToolKind::Grooving));
        cuts.takes = !is_plain || touches(part.now(), motion, tool);
    }

    /// Ends the cuts of a tool.
    fn close_plain(&mut self) {
        if let Some(PlainCuts { first: Some(first), takes: false, back, .. }) = self.plain.take()
            && !self.is_just_in_front(back)
        {
            self.report(first, Removal::Nothing(None));
        }
    }
}

fn thread_depth(found: UnusualDepth) -> Unusual {
    let UnusualDepth { motion, depth, lead } = found;
    Unusual { motion, removal: Removal::ThreadDepth { depth, lead } }
}

/// Whether a cut, shifted slightly, removes material.
#[inline(never)]
fn meets(now: &Region, motion: &Motion, shift: Point, tool: &ResolvedTool) -> bool {
    let moved = |point: Point| Point::new(point.x + shift.x, point.z + shift.z);
    let beside = Motion {
        from: moved(motion.from),
        to: moved(motion.to),
        center: motion.center.map(moved),
        ..*motion
    };
    cut(&beside, &Turned::default(), tool).iter().any(|outline| now.overlaps(outline))
}

/// Whether a cut removes material, or a finishing allowance of it.
fn touches(now: &Region, motion: &Motion, tool: &ResolvedTool) -> bool {
    let shifts = [(1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)];
    shifts.into_iter().any(|(x, z)| meets(now, motion, Point::new(FINISHING * x, FINISHING * z), tool))
}

/// Z of the end of a cut within the blank that continues far beyond its back.
fn behind(stock: &Stock, motion: &Motion) -> Option<f64> {
    let end = if motion.from.z < motion.to.z { motion.from } else { motion.to };
    let within = end.x > stock.bore.radius() && end.x < stock.diameter.radius();
    (within && end.z < stock.back() - OVERRUN).then_some(end.z)
}

/// The average depth of a cut in the blank and the permitted depth, if that is exceeded: of a cut along the
/// axis, or of a facing cycle across it. If a given insert is too short for the cut, the check of its holder
/// reports that.
fn too_deep(stock: &Stock, motion: &Motion, tool: &ResolvedTool, part: &mut Part) -> Option<(f64, f64)> {
    match tool.tool.kind? {
        ToolKind::Turning | ToolKind::Boring => {}
        ToolKind::Grooving | ToolKind::Threading | ToolKind::Drill | ToolKind::Tap | ToolKind::Endmill => {
            return None;
        }
    }
    let most = deepest_cut(stock.diameter.radius());
    let (from, to) = (motion.from, motion.to);
    let (dx, dz) = ((to.x - from.x).abs(), (to.z - from.z).abs());
    let is_across = dx > dz;
    let cycle = motion.cycle.map(|tag| tag.cycle);
    let faces = cycle.is_some_and(cuts_along_x);
    if motion.kind != MotionKind::Feed || is_across && !faces {
        return None;
    }
    // The share of the path within the blank.
    let within = match is_across {
        true => from.x.max(to.x).min(stock.diameter.radius()) - from.x.min(to.x).max(stock.bore.radius()),
        false => from.z.max(to.z).min(stock.face) - from.z.min(to.z).max(stock.back()),
    };
    if within < SHORT {
        return None;
    }
    let length = motion.length() * within / dx.max(dz);
    // Quick check: is there material at the permitted depth on either side of the path?
    let middle = Point::new((from.x + to.x) / 2.0, (from.z + to.z) / 2.0);
    let beside = [most, -most].map(|away| match is_across {
        true => Point::new(middle.x, middle.z + away),
        false => Point::new(middle.x + away, middle.z),
    });
    let (radii, places) = (stock.bore.radius()..=stock.diameter.radius(), stock.back()..=stock.face);
    if !beside.iter().any(|point| radii.contains(&point.x) && places.contains(&point.z)) {
        return None;
    }
    // The area cut by the part of the insert beyond the permitted depth. This intersection costs far more.
    let deeper = [1.0, -1.0].map(|side| match is_across {
        true => tool.takes.beyond(most, Point::new(0.0, side)).along_line(from, to),
        false => tool.takes.beyond(most, Point::new(side, 0.0)).along_line(from, to),
    });
    if deeper.iter().all(Vec::is_empty) {
        return None;
    }
    let now = part.now();
    if !beside.iter().any(|&point| now.contains(point)) || !deeper.iter().any(|outline| now.overlaps(outline))
    {
        return None;
    }
    let depth = now.intersection(&cut(motion, &Turned::default(), tool)).area() / length;
    (depth > most).then_some((depth, most))
}
