//! The workpiece during machining: the rest of the blank after each motion.
//!
//! In: the motions, and the given or inferred tools and blank. Out: the half-section at any moment, on the side of
//! the tool or on the other side of the axis, where the grooves of a thread are half a turn further. Material is
//! removed in slices (`advance`), so that a long program blocks nothing. Some states are kept, so that every moment
//! is close to a known state.

use std::cell::RefCell;

use super::region::Region;
use super::resolved_setup::{Basis, ResolvedSetup, ResolvedTool};
use super::sweep::chords;
use super::tool::Action;
use crate::geometry::bounds::Bounds;
use crate::geometry::{Point, SAME, within};
use crate::motion::{Motion, MotionKind, Motions};
use crate::setup::Blank;

/// Most turns of a thread that are cut one by one; a finer thread is cut as a whole.
const MAX_TURNS: f64 = 2000.0;

/// Most corners of the outlines that wait to be removed.
const MAX_WAITING: usize = 1500;

/// Least number of motions between two kept states.
const STRIDE: usize = 32;

/// Longest loose piece in front of Z0 that a facing cut leaves, mm; a longer one was parted off.
const LOOSE: f64 = 3.0;

/// At negative Z such a piece is the rest of a core only if its radius is at most this share of the radius of
/// the workpiece.
const CORE: f64 = 0.4;

/// Most corners of all kept states; beyond, every other state is dropped.
const MAX_KEPT: usize = 1_000_000;

/// A workpiece in progress.
#[derive(Clone, Debug, Default)]
pub struct Part {
    blank: Region,
    now: Region,
    /// Number of motions whose material was removed or is in `waiting`.
    done: usize,
    /// Outlines that must still be removed from `now`.
    waiting: Vec<Vec<Point>>,
    corners: usize,
    turned: Turned,
    half: Half,
    /// The kept states.
    kept: Vec<Kept>,
    /// Corners of all kept states.
    kept_corners: usize,
    /// Least number of motions between two of them.
    stride: usize,
    /// The state of the last request, since the next request is often for a slightly later moment.
    last: RefCell<Option<Kept>>,
}

/// The half of the section. Only the grooves of threads differ.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum Half {
    /// On the side of the tool.
    #[default]
    Tool,
    /// On the other side of the axis: half a turn of the spindle further.
    Opposite,
}

impl Half {
    /// The motion as this half meets it.
    fn meets(self, motion: &Motion) -> Motion {
        match self {
            Self::Tool => *motion,
            Self::Opposite => Motion { start_angle: motion.start_angle + 180.0, ..*motion },
        }
    }

    /// The angle of the spindle past a whole turn at the tool, in turns; `past`: that of this half.
    fn at_tool(self, past: f64) -> f64 {
        match self {
            Self::Tool => past,
            Self::Opposite => half_a_turn_further(past),
        }
    }
}

/// An angle of the spindle past a whole turn, in turns.
fn half_a_turn_further(past: f64) -> f64 {
    (past + 0.5).fract()
}

/// The workpiece after `done` motions.
#[derive(Clone, Debug)]
struct Kept {
    done: usize,
    turned: Turned,
    region: Region,
}

/// The current thread. A thread that continues with another lead, or out of the workpiece, has its grooves at
/// the same spindle angle.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Turned {
    /// Angle of the spindle past a whole turn, in turns.
    past: Option<f64>,
    /// The cut of the insert if the thread ends here, between two whole turns: the insert stays while the
    /// workpiece turns, and cuts a groove all around it, at most as wide as one lead.
    groove: Vec<Point>,
}

impl Turned {
    /// The state after a motion with its tool, in a half of the section.
    fn after(&self, motion: &Motion, tool: &ResolvedTool, half: Half) -> Self {
        let turns = motion.turns().filter(|_| motion.kind == MotionKind::Thread);
        let Some(past) = turns.map(|turns| (self.before(motion) + turns).fract()) else {
            return Self::default();
        };
        let at_tool = half.at_tool(past);
        let is_between = at_tool > SAME && at_tool < 1.0 - SAME;
        let cuts = is_between && removes_material(motion, tool) && tool.shape.action == Action::Threading;
        Self { past: Some(past), groove: if cuts { groove(motion, tool) } else { Vec::new() } }
    }

    /// Angle of the spindle past a whole turn at the start of a motion, in turns: the start angle of a
    /// thread, unless it continues another thread.
    fn before(&self, motion: &Motion) -> f64 {
        self.past.unwrap_or_else(|| (motion.start_angle / 360.0).fract())
    }
}

impl Part {
    /// The blank, before the first motion.
    pub fn new(blank: &Blank) -> Self {
        let blank = Region::inside(&blank.corners());
        Self { now: blank.clone(), blank, stride: STRIDE, ..Self::default() }
    }

    /// The opposite half with the same motions done, before the first thread that cuts turns.
    pub fn opposite(&mut self) -> Self {
        self.remove_waiting();
        let turned = Turned { past: self.turned.past.map(half_a_turn_further), ..self.turned.clone() };
        let region = self.now.clone();
        let start = Kept { done: self.done, turned: turned.clone(), region: region.clone() };
        Self {
            blank: self.blank.clone(),
            now: region,
            done: self.done,
            turned,
            half: Half::Opposite,
            kept_corners: start.region.corners(),
            kept: vec![start],
            stride: self.stride,
            ..Self::default()
        }
    }

    /// The blank.
    pub fn blank(&self) -> &Region {
        &self.blank
    }

    /// Number of motions that are done.
    pub fn done(&self) -> usize {
        self.done
    }

    /// Executes the next motion with its tool.
    pub fn step(&mut self, motion: &Motion, tool: &ResolvedTool) {
        let before = self.waiting.len();
        let motion = self.half.meets(motion);
        self.waiting.extend(cut(&motion, &self.turned, tool));
        self.turned = self.turned.after(&motion, tool, self.half);
        self.corners += self.waiting[before..].iter().map(Vec::len).sum::<usize>();
        self.done += 1;
        // Passes of a thread share flanks: removed together, they would split each other into thousands of
        // pieces.
        if self.corners > MAX_WAITING || self.waiting.len() > before + 1 {
            self.remove_waiting();
        }
        if self.done >= self.kept.last().map_or(0, |last| last.done) + self.stride && !self.waiting.is_empty()
        {
            self.remove_waiting();
            self.keep();
        }
    }

    /// Removes the groove at the end of a thread if the next motion ends the thread, because the insert
    /// leaves it there.
    pub fn end_thread(&mut self, next: &Motion) {
        if let Some(groove) = left_by_thread(next, &self.turned) {
            self.corners += groove.len();
            self.waiting.push(groove);
            // `step` must not remove it again.
            self.turned.groove.clear();
        }
    }

    /// Keeps the current state.
    fn keep(&mut self) {
        self.kept_corners += self.now.corners();
        self.kept.push(Kept { done: self.done, turned: self.turned.clone(), region: self.now.clone() });
        if self.kept_corners > MAX_KEPT {
            let mut odd = false;
            self.kept.retain(|_| {
                odd = !odd;
                odd
            });
            self.kept_corners = self.kept.iter().map(|state| state.region.corners()).sum();
            self.stride *= 2;
        }
    }

    /// Number of corners of the remaining material.
    pub fn corners(&self) -> usize {
        self.now.corners()
    }

    /// The current workpiece.
    pub fn now(&mut self) -> &Region {
        self.remove_waiting();
        &self.now
    }

    /// The workpiece after all motions that are done.
    pub fn finished(&self) -> Region {
        let mut now = self.now.clone();
        now.cut(&self.waiting);
        now.drop_pieces(is_left_by_facing);
        now
    }

    /// The workpiece after `count` motions and the fraction `share` of the next one.
    pub fn at(&self, motions: &Motions, resolved: &ResolvedSetup, count: usize, share: f64) -> Region {
        let count = count.min(self.done);
        let Kept { done: from, mut turned, mut region } = self.near(count);
        let mut outlines: Vec<Vec<Point>> = Vec::new();
        let met = |index| self.half.meets(&motions.get_on_workpiece(index).on_positive_side());
        for motion in (from..count).map(met) {
            let tool = resolved.tool(&motion);
            outlines.extend(cut(&motion, &turned, tool));
            turned = turned.after(&motion, tool, self.half);
        }
        region.cut(&outlines);
        region.drop_pieces(is_left_by_facing);
        self.last.replace(Some(Kept { done: count, turned: turned.clone(), region: region.clone() }));
        if count < motions.len() && count < self.done && share > 0.0 {
            let motion = met(count);
            region.cut(&cut_so_far(&motion, share, &turned, resolved.tool(&motion)));
            region.drop_pieces(is_left_by_facing);
        }
        region
    }

    /// The latest known state that is not after `count` motions.
    fn near(&self, count: usize) -> Kept {
        let kept = self
            .kept
            .partition_point(|state| state.done <= count)
            .checked_sub(1)
            .map(|index| &self.kept[index]);
        let from = kept.map_or(0, |state| state.done);
        match (self.last.take().filter(|last| (from..=count).contains(&last.done)), kept) {
            (Some(last), _) => last,
            (None, Some(state)) => state.clone(),
            (None, None) => Kept { done: 0, turned: Turned::default(), region: self.blank.clone() },
        }
    }

    fn remove_waiting(&mut self) {
        if !self.waiting.is_empty() {
            self.now.cut(&self.waiting);
            self.now.drop_pieces(is_left_by_facing);
            self.waiting.clear();
            self.corners = 0;
        }
    }
}

/// Whether a piece is a remainder of a facing cut: it lies in front of Z0 or is the rest of a core on the
/// axis, and other pieces are closer to the chuck.
fn is_left_by_facing(piece: Bounds, all: Bounds) -> bool {
    let is_core = piece.min.x <= SAME && piece.max.x <= CORE * all.max.x;
    let in_front = piece.min.z > if is_core { all.min.z + SAME } else { -SAME };
    in_front && all.min.z < -SAME && piece.max.z - piece.min.z <= LOOSE
}

/// The material that a motion removes, as outlines that may overlap.
pub fn cut(motion: &Motion, turned: &Turned, tool: &ResolvedTool) -> Vec<Vec<Point>> {
    cut_so_far(motion, 1.0, turned, tool)
}

/// The material that the fraction `share` of a motion removes.
fn cut_so_far(motion: &Motion, share: f64, turned: &Turned, tool: &ResolvedTool) -> Vec<Vec<Point>> {
    let mut outlines: Vec<_> = left_by_thread(motion, turned).into_iter().collect();
    if removes_material(motion, tool) && motion.kind.cuts() {
        outlines.extend(cut_by(motion, share, turned.before(motion), tool));
    }
    outlines
}

/// Whether the material that a motion removes shows in the section: tool and path are known, and the
/// workpiece turned.
fn removes_material(motion: &Motion, tool: &ResolvedTool) -> bool {
    motion.process.removes_material() && tool.basis != Basis::Unknown && !tool.is_live_in(motion)
}

/// The groove at the end of a thread, if `motion` is the first one after it.
fn left_by_thread(motion: &Motion, turned: &Turned) -> Option<Vec<Point>> {
    (motion.kind != MotionKind::Thread && !turned.groove.is_empty()).then(|| turned.groove.clone())
}

/// The groove of an insert that stays at the end of a thread for one turn.
fn groove(thread: &Motion, tool: &ResolvedTool) -> Vec<Point> {
    let outline = tool.takes.at(thread.to);
    let is_along_z = (thread.to.z - thread.from.z).abs() >= (thread.to.x - thread.from.x).abs();
    match thread.lead.filter(|_| is_along_z) {
        Some(lead) => {
            let (z, half) = (thread.to.z, lead.abs() / 2.0);
            beyond(&beyond(&outline, z - half, 1.0), z + half, -1.0)
        }
        None => outline,
    }
}

/// The part of an outline beyond `z`, on the side of +Z or of −Z.
fn beyond(outline: &[Point], z: f64, side: f64) -> Vec<Point> {
    let ahead = |point: &Point| side * (point.z - z);
    let mut part = Vec::with_capacity(outline.len() + 2);
    for (at, &point) in outline.iter().enumerate() {
        let next = outline[(at + 1) % outline.len()];
        let (own, other) = (ahead(&point), ahead(&next));
        if own >= 0.0 {
            part.push(point);
        }
        if own * other < 0.0 {
            part.push(between(point, next, own / (own - other)));
        }
    }
    part
}

/// The material that the fraction `share` of a cut removes; `past` is the angle of the spindle past a whole
/// turn of a thread, in turns.
fn cut_by(motion: &Motion, share: f64, past: f64, tool: &ResolvedTool) -> Vec<Vec<Point>> {
    let share = within(share, 0.0, 1.0);
    let edge = &tool.takes;
    let turns = motion.first_part(share).turns();
    if let Some(turns) = turns.filter(|_| cuts_turn_by_turn(motion, tool)) {
        let (first, last) = ((past - SAME).ceil(), (past + turns + SAME).floor());
        let places = (first as u32..=last as u32)
            .map(|turn| motion.share_after(f64::from(turn) - past).unwrap_or(0.0));
        return places
            .map(|place| edge.at(between(motion.from, motion.to, within(place, 0.0, 1.0))))
            .collect();
    }
    match motion.arc() {
        Some(arc) => edge.along(&first_part(chords(&arc), share)).collect(),
        None => vec![edge.along_line(motion.from, between(motion.from, motion.to, share))],
    }
}

/// Whether a motion cuts the turns of a thread one by one, so that the halves of the section differ.
pub fn cuts_turn_by_turn(motion: &Motion, tool: &ResolvedTool) -> bool {
    motion.kind == MotionKind::Thread
        && tool.shape.action == Action::Threading
        && motion.turns().is_some_and(|turns| turns <= MAX_TURNS)
}

/// The first part of a path of equal pieces. It has the same points as the whole path, so that no material
/// that it removes reappears at the end.
fn first_part(mut way: Vec<Point>, share: f64) -> Vec<Point> {
    let done = share * (way.len() - 1) as f64;
    let whole = done as usize;
    if let Some(&[from, to]) = way.get(whole..whole + 2) {
        way.truncate(whole + 1);
        way.push(between(from, to, done.fract()));
    }
    way
}

fn between(from: Point, to: Point, share: f64) -> Point {
    if share >= 1.0 {
        to
    } else {
        Point::new(from.x + share * (to.x - from.x), from.z + share * (to.z - from.z))
    }
}
