//! What cuts take off, and what they ought to: cycles that take off nothing, cuts deeper than an insert bears,
//! cuts beyond the back of the blank, threads of another depth or too near a shoulder.
//!
//! In: each motion with its tool, and the work before it. Out: [`Unusual`]s, in a blank that somebody has named
//! only, and none after M00: the work may be turned round or changed there. Must not know messages.

use std::collections::BTreeSet;

use super::part::{Part, Turned, cut};
use super::region::Region;
use super::resolved_setup::{Basis, ResolvedSetup, ResolvedTool};
use super::thread_depth::{Threads, UnusualDepth};
use super::thread_run_out::{RunOuts, ShortRunOut};
use super::tool::Action;
use crate::geometry::Point;
use crate::motion::{Cycle, CycleFamily, Motion, MotionKind, Motions, StopKind};
use crate::setup::stock::deepest_cut;
use crate::setup::{Stock, ToolKind};

/// Something unusual about what a motion takes off.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Unusual {
    /// The motion.
    pub motion: usize,
    /// What.
    pub removal: Removal,
}

/// What can be unusual.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Removal {
    /// No move of a call of a cycle comes near the work.
    Nothing(Cycle),
    /// A cut is deeper than an insert bears. Lengths in mm, across the cut.
    TooDeep {
        /// How deep it is.
        depth: f64,
        /// How deep it may be.
        most: f64,
    },
    /// A cut goes on beyond the back of the blank.
    BeyondBlank {
        /// Z of its end, mm.
        z: f64,
        /// Z of the back of the blank, mm.
        back: f64,
    },
    /// A thread is far deeper than one of its lead, or far less deep. Lengths in mm.
    ThreadDepth {
        /// Its depth on one side.
        depth: f64,
        /// Its lead.
        lead: f64,
    },
    /// A thread ends nearer to a shoulder than the slide needs to come to rest. Lengths in mm.
    ThreadRunOut(ShortRunOut),
}

/// A cycle no farther from the work than this, mm, may be a finishing pass.
const FINISHING: f64 = 0.1;

/// So far in front of the face, mm, a blank may be longer than somebody has said: a bar is sawn off, and faced.
const SAWN: f64 = 5.0;

/// A tool may go so far beyond the back of a blank, mm: a ring or a tube is turned and bored over its whole length.
const OVERRUN: f64 = 5.0;

/// Of a shorter cut it is not asked how deep it is, mm.
const SHORT: f64 = 5.0;

/// A call of a cycle.
#[derive(Clone, Copy, Debug)]
struct Call {
    cycle: Cycle,
    /// Its first cut, and the first byte of its block.
    first: Option<(usize, u32)>,
    /// Its last pass.
    pass: u32,
    /// It takes something off.
    takes: bool,
    /// Z of its end nearest to the chuck, mm.
    back: f64,
    /// The tool comes from a call of the same cycle without another move.
    repeats: bool,
}

/// Watches what is taken off, motion by motion.
#[derive(Clone, Debug)]
pub struct RemovalWatch {
    /// The blank that somebody has named.
    stock: Option<Stock>,
    /// The first motion after which nothing is watched.
    end: usize,
    call: Option<Call>,
    /// Blocks of cycles that have taken something off: carried out once more, for the next part, they need not.
    done: BTreeSet<u32>,
    threads: Threads,
    run_outs: RunOuts,
    /// All that was found.
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
            done: BTreeSet::new(),
            threads: Threads::default(),
            run_outs: RunOuts::default(),
            found: Vec::new(),
        }
    }

    /// Looks at the next motion, before its material is off. `block`: the first byte of its block.
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
            return;
        }
        if motion.kind == MotionKind::Thread {
            let over = self.threads.pass(index, motion, || part.now());
            self.found.extend(over.map(thread_depth));
            if let Some(short) = self.run_outs.pass(motion, || part.now()) {
                self.tell(index, Removal::ThreadRunOut(short));
            }
        }
        self.cycle(index, motion, block, tool, part);
        if !motion.kind.cuts() {
            return;
        }
        let insert = match tool.tool.kind {
            Some(ToolKind::Turning | ToolKind::Boring | ToolKind::Grooving | ToolKind::Threading) => true,
            Some(ToolKind::Drill | ToolKind::Tap | ToolKind::Endmill) | None => false,
        };
        if insert && let Some(z) = behind(&stock, motion) {
            self.tell(index, Removal::BeyondBlank { z, back: stock.back() });
        }
        if let Some((depth, most)) = too_deep(&stock, motion, tool, part) {
            self.tell(index, Removal::TooDeep { depth, most });
        }
    }

    /// There are no more motions.
    pub fn finish(&mut self) {
        self.close();
        let over = self.threads.close();
        self.found.extend(over.map(thread_depth));
    }

    fn tell(&mut self, motion: usize, removal: Removal) {
        self.found.push(Unusual { motion, removal });
    }

    /// A motion with the call of a cycle that it belongs to, if any.
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
            let at = |shift: Point| meets(now, motion, shift, tool);
            call.takes = match roughs {
                true => at(Point::new(0.0, 0.0)),
                false => [(1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)]
                    .into_iter()
                    .any(|(x, z)| at(Point::new(FINISHING * x, FINISHING * z))),
            };
        }
    }

    /// The call under way is over.
    fn close(&mut self) {
        let Some(Call { cycle, first: Some((first, block)), takes, back, .. }) = self.call.take() else {
            return;
        };
        let faces = matches!(cycle, Cycle::Facing | Cycle::RoughFacing);
        let is_in_front = |stock: Stock| back > stock.face - FINISHING && back < stock.face + SAWN;
        if takes || faces && self.stock.is_some_and(is_in_front) {
            self.done.insert(block);
        } else if self.done.insert(block) {
            self.tell(first, Removal::Nothing(cycle));
        }
    }
}

fn thread_depth(found: UnusualDepth) -> Unusual {
    let UnusualDepth { motion, depth, lead } = found;
    Unusual { motion, removal: Removal::ThreadDepth { depth, lead } }
}

/// Whether a cut takes something off, a little beside its way.
fn meets(now: &Region, motion: &Motion, shift: Point, tool: &ResolvedTool) -> bool {
    let moved = |point: Point| Point::new(point.x + shift.x, point.z + shift.z);
    let beside = Motion {
        from: moved(motion.from),
        to: moved(motion.to),
        center: motion.center.map(moved),
        ..*motion
    };
    cut(&beside, &Turned::default(), tool).iter().any(|outline| now.meets(outline))
}

/// Z of the end of a cut within the blank that goes on far beyond its back.
fn behind(stock: &Stock, motion: &Motion) -> Option<f64> {
    let end = if motion.from.z < motion.to.z { motion.from } else { motion.to };
    let within = end.x > stock.bore.radius() && end.x < stock.diameter.radius();
    (within && end.z < stock.back() - OVERRUN).then_some(end.z)
}

/// How deep a cut in the blank is on average, and how deep it may be, where it is deeper: one along the axis, or
/// one of a facing cycle across it. What a given insert is too short for, its holder meets.
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
    let faces = matches!(cycle, Some(Cycle::Facing | Cycle::RoughFacing));
    if motion.kind != MotionKind::Feed || is_across && !faces {
        return None;
    }
    // As much of the way as is in the blank.
    let within = match is_across {
        true => from.x.max(to.x).min(stock.diameter.radius()) - from.x.min(to.x).max(stock.bore.radius()),
        false => from.z.max(to.z).min(stock.face) - from.z.min(to.z).max(stock.back()),
    };
    if within < SHORT {
        return None;
    }
    let length = motion.length() * within / dx.max(dz);
    // Is there material so far above the way, or below it?
    let middle = Point::new((from.x + to.x) / 2.0, (from.z + to.z) / 2.0);
    let beside = [most, -most].map(|away| match is_across {
        true => Point::new(middle.x, middle.z + away),
        false => Point::new(middle.x + away, middle.z),
    });
    let (radii, places) = (stock.bore.radius()..=stock.diameter.radius(), stock.back()..=stock.face);
    if !beside.iter().any(|point| radii.contains(&point.x) && places.contains(&point.z)) {
        return None;
    }
    // What of the insert goes deeper than it may; the common part costs far more.
    let deeper = [1.0, -1.0].map(|side| match is_across {
        true => tool.takes.beyond(most, Point::new(0.0, side)).along_line(from, to),
        false => tool.takes.beyond(most, Point::new(side, 0.0)).along_line(from, to),
    });
    if deeper.iter().all(Vec::is_empty) {
        return None;
    }
    let now = part.now();
    if !beside.iter().any(|&point| now.holds(point)) || !deeper.iter().any(|outline| now.meets(outline)) {
        return None;
    }
    let depth = now.in_common(&cut(motion, &Turned::default(), tool)).area() / length;
    (depth > most).then_some((depth, most))
}
