//! Detects collisions, and tools used for something they are not made for.
//!
//! In: each motion with its tool, and the workpiece before it. Out: [`Finding`]s. Contact alone is not a
//! finding: for the check, outlines are shrunk by a hundredth of a millimetre. Of an inferred tool only the
//! tip counts, and an inferred blank has no findings. Must not know messages.

use super::danger::{Axis, Danger, Finding};
use super::live_path::LiveCuts;
use super::misuse::{Cut, Misuse, SCRAPED};
use super::part::{Part, Turned, cut};
use super::region::Region;
use super::resolved_setup::{Basis, ResolvedSetup, ResolvedTool};
use super::sweep::{Outline, path_of};
use super::tip_place::{Route, TipPlace};
use super::tool::{Action, Solid};
use crate::cycles::single::cuts_along_x;
use crate::geometry::{Point, SAME};
use crate::motion::{CycleFamily, Motion, MotionKind, Motions, Quill, Step};
use crate::setup::{Blank, Setup, Stock, Tailstock, ToolKind, Travel};
use crate::units::Diameter;

/// Length of the jaws across the axis, and of the chuck body, mm.
const JAW: f64 = 40.0;

/// How far beyond the axis a tip may go without a finding, mm: facing goes a little past it.
const PAST_CENTER: f64 = 0.5;

/// Least area that an edge takes off beside the path of the tip to be reported, mm² for each mm of path.
const BESIDE: f64 = 0.05;

/// A bore is measured at this distance in front of the tip, mm.
const IN_FRONT: f64 = 0.5;

/// How far within the material the start of a cycle may be without a finding, mm.
const INSIDE: f64 = 0.1;

/// Tools are not changed closer to the blank than this, mm.
const CLEAR: f64 = 10.0;

/// Distance at which a rapid counts as running along a surface, mm.
const ALONG: f64 = 0.001;

/// A rapid is checked for remaining material this deep below the outside of the blank, mm; it is reported if
/// the material lies along at least `MIN_REMAINING` mm of its path.
const SKIN: f64 = 0.05;
const MIN_REMAINING: f64 = 0.5;

/// A contact is located to this along the path, mm, and its area is computed this far behind it.
const CONTACT: f64 = 1e-5;
const FLAT: [f64; 4] = [0.001, 0.01, 0.1, 1.0];

/// Most halvings of a path: enough for 100 m.
const HALVINGS: u32 = 34;

/// The core of a tool enters at most this far behind the tool itself, mm, unless the tool slides along a
/// surface: that of a given tool, and that of an assumed one.
const BEFORE: [f64; 2] = [0.1, 2.0];

/// A contact at most this far from the nose is made by the tip, mm.
const AT_TIP: f64 = 0.1;

/// Whether the setup contains anything to check motions against: a blank, a tailstock or travel limits.
pub fn can_be_found(setup: &Setup) -> bool {
    setup.stock.is_some() || setup.tailstock.is_some() || setup.machine.travel != Travel::default()
}

/// Checks motions one after the other.
#[derive(Clone, Debug)]
pub struct DangerDetector {
    /// Jaws and chuck body as one region: hitting both is one finding.
    jaws: Option<Region>,
    /// The jaws with the end of the bar that they clamp: the tip of an outside tool is there only if the tool is
    /// in the jaws.
    clamped: Option<Region>,
    /// Jaws and chuck body as two regions, for drawing.
    chuck: Option<[Region; 2]>,
    /// The centre, if the program moves it forward.
    tailstock: Option<Region>,
    /// Position of the quill before the first quill command.
    quill: Quill,
    stock: Option<Stock>,
    travel: Travel,
    missed: Vec<u16>,
    misuse: Misuse,
    /// The station of a tool that was fed into the material with the spindle stopped. It leaves through material
    /// that the cut should have removed, so its rapid moves are not reported until it is outside.
    stopped_inside: Option<u16>,
    /// The cuts of live tools.
    live_cuts: LiveCuts,
    /// Angle of C, degrees.
    c: f64,
    /// The last motion, except dwells.
    before: Option<Motion>,
    tip: TipPlace,
    /// Whether the current thread begins within the workpiece.
    plunges: bool,
    /// Start of the current pass of a cycle.
    pass_start: Option<Point>,
    /// All findings.
    pub findings: Vec<Finding>,
}

/// Most findings that are kept.
const MAX_FINDINGS: usize = 1000;

/// Whether the first pass of a thread moves to its depth within the workpiece: the tip, just above the end of
/// the infeed, is in material.
fn plunges(infeed: &Motion, part: &mut Part) -> bool {
    let (from, to) = (infeed.from, infeed.to);
    let way = to.x - from.x;
    way.abs() > INSIDE && part.now().contains(Point::new(to.x - INSIDE * way.signum(), to.z))
}

impl DangerDetector {
    /// A detector for a program with these tools and this stock.
    pub fn new(resolved: &ResolvedSetup, motions: &Motions, setup: &Setup) -> Self {
        let blank = resolved.blank().filter(|blank| blank.1 == Basis::Given).map(|blank| blank.0);
        let stock = blank.map(Blank::extents);
        let outside = blank.map_or(0.0, Blank::clamped_radius);
        let quill = quill_at_start(motions);
        let comes = motions.is_empty() || motions.quills().any(|said| is_forward(said, quill));
        Self {
            jaws: stock.and_then(|stock| jaws(&stock, outside)),
            clamped: stock.and_then(|stock| clamped(&stock, outside)),
            chuck: stock.and_then(|stock| chuck(&stock, outside)),
            tailstock: setup.tailstock.filter(|_| comes).map(|tailstock| center(&tailstock)),
            quill,
            stock,
            travel: setup.machine.travel,
            missed: Vec::new(),
            misuse: Misuse::default(),
            stopped_inside: None,
            live_cuts: LiveCuts::default(),
            c: 0.0,
            before: None,
            tip: TipPlace::default(),
            plunges: false,
            pass_start: None,
            findings: Vec::new(),
        }
    }

    /// The obstacles around the workpiece: the chuck, and the tailstock if it is forward. `moment` is the
    /// quill state commanded at that moment; `None` means the whole program.
    pub fn obstacles(&self, moment: Option<Quill>) -> impl Iterator<Item = &Region> {
        let forward = moment.is_none_or(|said| is_forward(said, self.quill));
        self.chuck.iter().flatten().chain(self.tailstock.iter().filter(move |_| forward))
    }

    /// Whether there is a chuck with jaws, and a tailstock.
    pub fn has_chuck_and_tailstock(&self) -> [bool; 2] {
        [self.jaws.is_some(), self.tailstock.is_some()]
    }

    /// Checks the next motion, before its material is removed.
    pub fn check_motion(&mut self, index: usize, motion: &Motion, resolved: &ResolvedSetup, part: &mut Part) {
        let process = &motion.process;
        let c = self.c;
        self.c = motion.rotary.map_or(c, |rotary| rotary.to);
        if self.findings.len() >= MAX_FINDINGS
            || motion.kind == MotionKind::Dwell
            || process.uncertain
            || process.other_setup
        {
            self.skip(motion);
            return;
        }
        let before = self.before.replace(*motion);
        let tool = resolved.tool(motion);
        let station = motion.process.tool.0;
        let route = self.tip.follow(motion, self.is_at_work(motion.from));
        if motion.kind.cuts() && resolved.lacks_tool(station) && !self.missed.contains(&station) {
            self.missed.push(station);
            self.report(index, motion.from, Danger::ToolNotListed { station });
        }
        self.travel(index, motion);
        if route == Route::Unknown {
            self.skip(motion);
            return;
        }
        // Tools are not changed within the workpiece: the start of the rapid is unknown, only its end is
        // known.
        let known = if route == Route::EndKnown && !motion.kind.cuts() {
            Motion { from: motion.to, ..*motion }
        } else {
            *motion
        };
        if tool.is_live_in(motion) {
            self.live(index, &known, c, tool, part);
            return;
        }
        self.hit_obstacles(index, motion, tool);
        // After a block that was not executed, the remaining material is unknown.
        if self.stock.is_none() || motion.process.incomplete {
            return;
        }
        if self.misuse.cuts_on_wrong_side(station) {
            return;
        }
        if motion.cycle.is_some() && self.cycle_start(index, motion, part) {
            return;
        }
        part.end_thread(motion);
        self.stopped_inside = self.stopped_inside.filter(|own| motion.process.still && *own == station);
        match motion.kind {
            MotionKind::Rapid if self.stopped_inside.is_some() => {
                let now = part.now();
                if !tool.shape.solids().any(|solid| now.overlaps(&solid.core.at(motion.to))) {
                    self.stopped_inside = None;
                }
            }
            MotionKind::Rapid => self.rapid(index, &known, tool, part),
            // A gripper only touches the workpiece.
            _ if motion.process.still => {
                let is_near = self.stock.is_some_and(|stock| near(&stock, &[motion.from, motion.to]));
                let hits = |solid| hit(part.now(), solid, motion).is_some();
                if is_near && tool.shape.solids().any(hits) {
                    self.stopped_inside = Some(station);
                }
            }
            _ => self.cut(index, motion, before.as_ref(), tool, part),
        }
    }

    /// Skips a motion. If it is a cut, the live cuts are no longer known.
    fn skip(&mut self, motion: &Motion) {
        if motion.kind.cuts() {
            self.live_cuts.mark_unknown();
        }
    }

    /// Checks a motion of a live tool: of its path only the tip is known.
    fn live(&mut self, index: usize, motion: &Motion, c: f64, tool: &ResolvedTool, part: &mut Part) {
        let Some(stock) = self.stock.filter(|_| !motion.process.incomplete) else { return };
        if motion.kind.cuts() {
            self.live_cuts.cut(motion, c, tool);
            return;
        }
        let is_near = motion.rotary.is_some() || near(&stock, &[motion.from, motion.to]);
        if tool.shape.action == Action::Live
            && is_near
            && let Some(at) = self.live_cuts.rapid(motion, c, part.now())
        {
            self.report(index, at, Danger::RapidThroughStock);
        }
    }

    /// Whether a place is in the blank or near it.
    fn is_at_work(&self, at: Point) -> bool {
        self.stock.is_some_and(|stock| at.x < stock.diameter.radius() + CLEAR && at.z < stock.face + CLEAR)
    }

    fn report(&mut self, motion: usize, at: Point, danger: Danger) {
        self.findings.push(Finding { motion, at, danger });
    }

    fn travel(&mut self, index: usize, motion: &Motion) {
        let Travel { x_min, x_max, z_min, z_max } = self.travel;
        let Point { x, z } = motion.to;
        let beyond = |low: Option<f64>, high: Option<f64>, value: f64| {
            low.filter(|&low| value < low - SAME).or(high.filter(|&high| value > high + SAME))
        };
        let [low, high] = [x_min, x_max].map(|end| end.map(Diameter::mm));
        let x = beyond(low, high, Diameter::from_radius(x).mm());
        for (axis, limit) in [(Axis::X, x), (Axis::Z, beyond(z_min, z_max, z))] {
            if let Some(limit) = limit {
                self.report(index, motion.to, Danger::OverTravel { axis, limit });
            }
        }
    }

    fn hit_obstacles(&mut self, index: usize, motion: &Motion, tool: &ResolvedTool) {
        let tailstock = self.tailstock.as_ref().filter(|_| is_forward(motion.process.quill, self.quill));
        // Of an assumed tool only the tip is known.
        let jaws = if tool.is_assumed_outside() { &self.clamped } else { &self.jaws };
        let obstacles = [(Danger::IntoJaws, jaws.as_ref()), (Danger::IntoTailstock, tailstock)];
        let found = obstacles.map(|(danger, obstacle)| {
            let obstacle = obstacle?;
            Some((danger, tool.shape.solids().find_map(|solid| hit(obstacle, solid, motion))?))
        });
        for (danger, at) in found.into_iter().flatten() {
            self.report(index, at, danger);
        }
    }

    /// Whether a cycle starts in the material. Each pass returns at rapid to the start, along the workpiece.
    fn cycle_start(&mut self, index: usize, motion: &Motion, part: &mut Part) -> bool {
        let Some(tag) = motion.cycle else { return false };
        let facing = match tag.cycle.family() {
            CycleFamily::Turning => cuts_along_x(tag.cycle),
            CycleFamily::Threading => false,
            CycleFamily::Contour | CycleFamily::Pecking | CycleFamily::FaceHole | CycleFamily::SideHole => {
                return false;
            }
        };
        match tag.step {
            Step::Infeed => {
                self.pass_start = Some(motion.from);
                if tag.cycle.family() == CycleFamily::Turning {
                    return false;
                }
                if tag.pass == 1 {
                    self.plunges = plunges(motion, part);
                    if let Some(stock) = self.stock.filter(|_| self.plunges) {
                        self.report(index, motion.from, Danger::BehindFace { face: stock.face });
                    }
                }
                // Known already for later passes.
                return self.plunges;
            }
            Step::Cut if !self.plunges => {}
            _ => return false,
        }
        let Some(start) = self.pass_start.take().filter(|_| tag.pass == 1) else { return false };
        // A short distance before the start of the cut.
        let behind = |start: f64, cut: f64| start + INSIDE * (start - cut).signum();
        let (from, to) = (motion.from, motion.to);
        let line = match facing {
            false => [Point::new(behind(start.x, to.x), from.z), Point::new(behind(start.x, to.x), to.z)],
            true => [Point::new(from.x, behind(start.z, to.z)), Point::new(to.x, behind(start.z, to.z))],
        };
        let shares = (1..=9).map(|tenth| f64::from(tenth) / 10.0);
        let now = part.now();
        let between = |share: f64, from: f64, to: f64| from + share * (to - from);
        let mut places = shares.map(|share| {
            Point::new(between(share, line[0].x, line[1].x), between(share, line[0].z, line[1].z))
        });
        let found = places.any(|place| now.contains(place));
        if found {
            let face = self.stock.map_or(0.0, |stock| stock.face);
            self.report(index, start, if facing { Danger::BehindFace { face } } else { Danger::CycleStart });
        }
        found
    }

    fn rapid(&mut self, index: usize, motion: &Motion, tool: &ResolvedTool, part: &mut Part) {
        let Some(stock) = self.stock else { return };
        let solids = || tool.shape.solids();
        // Cheap check first: far from the blank there is nothing to compute.
        let far = |outline: &Outline, way: &[Point]| outline.along(way).all(|swept| !near(&stock, &swept));
        let straight = [motion.from, motion.to];
        if !solids().all(|solid| far(solid.core, &straight)) {
            let now = part.now();
            if let Some(at) = solids().find_map(|solid| hit(now, solid, motion)) {
                let from = motion.from;
                // If there is material all along the path to the wall beyond the tip, the tip is in a bore.
                // Measured slightly in front of the tip, which may be at the bottom or touch the wall.
                let in_bore = from.z < stock.face
                    && motion.to.x > from.x
                    && now
                        .radii(from.z + IN_FRONT)
                        .first()
                        .is_some_and(|material| material.0 > from.x - IN_FRONT && material.0 > 0.0);
                let danger = if in_bore { Danger::LeavesBore } else { Danger::RapidThroughStock };
                self.report(index, at, danger);
                return;
            }
        }
        if let Some(at) = along_outside(&stock, motion, part) {
            self.report(index, at, Danger::RapidAlongStock);
            return;
        }
        let Some(dogleg) = dogleg(motion) else { return };
        if !solids().all(|solid| far(solid.core, &dogleg)) {
            let now = part.now();
            let legs = dogleg.windows(2).map(|ends| Motion { from: ends[0], to: ends[1], ..*motion });
            let found = legs.flat_map(|leg| solids().find_map(|solid| hit(now, solid, &leg))).next();
            if let Some(at) = found {
                self.report(index, at, Danger::DoglegThroughStock);
            }
        }
    }

    fn cut(
        &mut self,
        index: usize,
        motion: &Motion,
        before: Option<&Motion>,
        tool: &ResolvedTool,
        part: &mut Part,
    ) {
        let turns = matches!(tool.tool.kind, Some(ToolKind::Turning | ToolKind::Boring | ToolKind::Grooving));
        let low = motion.from.x.min(motion.to.x);
        if turns && tool.basis == Basis::Given && low < -2.0 * tool.shape.nose - PAST_CENTER {
            self.report(index, if motion.to.x == low { motion.to } else { motion.from }, Danger::BelowCenter);
        }
        for danger in self.misuse.next(&Cut { motion, before, tool, blank: self.stock }, part) {
            self.report(index, motion.to, danger);
        }
        if self.misuse.cuts_on_wrong_side(motion.process.tool.0) {
            return;
        }
        if let Some(outline) = &tool.shape.body {
            let body = Solid { outline, core: &outline.shrunk(0.01), nose: None };
            // The material that the edge takes off in the same motion is not in the way of the holder.
            if hit(part.now(), body, motion).is_some() {
                let mut left = part.now().clone();
                left.cut(&cut(motion, &Turned::default(), tool));
                if let Some(at) = hit(&left, body, motion) {
                    self.report(index, at, Danger::HolderInStock);
                    return;
                }
            }
        }
        if let Some(danger) = too_steep(motion, tool, part) {
            self.report(index, motion.to, danger);
        }
    }
}

/// Whether a slope is steeper than the trailing edge of a turning tool, so that this edge cuts.
fn too_steep(motion: &Motion, tool: &ResolvedTool, part: &mut Part) -> Option<Danger> {
    if tool.basis != Basis::Given || motion.arc().is_some() || motion.kind != MotionKind::Feed {
        return None;
    }
    let side = match tool.tool.kind? {
        ToolKind::Turning if tool.tool.tip_direction() == 3 => 1.0,
        ToolKind::Boring if tool.tool.tip_direction() == 2 => -1.0,
        _ => return None,
    };
    let (dx, dz) = (side * (motion.to.x - motion.from.x), motion.to.z - motion.from.z);
    if dx > -SAME || dz > -SAME {
        return None;
    }
    let slope = (-dx).atan2(-dz);
    let follows = tool.shape.trailing?;
    if slope <= follows + 0.01 {
        return None;
    }
    // The removed material behind the tip, above the slope.
    let behind = part.now().intersection(&cut(motion, &Turned::default(), tool));
    let above = behind.area_beside(motion.from, motion.to);
    let worth = above > BESIDE * motion.length();
    worth.then_some(Danger::SlopeTooSteep { slope: slope.to_degrees(), tool: follows.to_degrees() })
}

/// The first contact of a solid with a region that it enters.
fn hit(region: &Region, solid: Solid, motion: &Motion) -> Option<Point> {
    let Solid { outline, core, nose } = solid;
    if core.points().len() < 3 {
        return None;
    }
    let way = path_of(motion);
    let enters = |ends: &&[Point]| {
        let swept = core.along_line(ends[0], ends[1]);
        region.overlaps(&swept) && region.intersection(&[swept]).area() >= SCRAPED
    };
    let ends = way.windows(2).find(enters)?;
    let (from, to) = (ends[0], ends[1]);
    let of_start = region.intersection(&[core.at(from)]);
    if !of_start.is_empty() {
        // It was there already.
        let is_tip = nose.is_some() && region.contains(Point::new(from.x, from.z + SKIN));
        return if is_tip { Some(from) } else { nearest_corner(&of_start, from) };
    }
    let length = from.distance(to).max(CONTACT);
    let of_core = first_overlap(region, core, from, to);
    // The core enters later than the outline, which may touch the region all along the path.
    let before = BEFORE.map(|way| between(from, to, (of_core - way / length).max(0.0)));
    let free = before.into_iter().find(|&place| !region.overlaps(&outline.at(place)));
    let (used, begin) = free.map_or((core, from), |place| (outline, place));
    let length = begin.distance(to).max(CONTACT);
    let share = first_overlap(region, used, begin, to);
    let tip = between(begin, to, share);
    // Far enough behind the contact for an area that is no rounding error.
    let at = FLAT.into_iter().find_map(|way| {
        let behind = between(begin, to, (share + way / length).min(1.0));
        nearest_corner(&region.intersection(&[used.along_line(begin, behind)]), tip)
    });
    let at = at.unwrap_or(tip);
    // A nose touches a wall beside the programmed point, which is the place to report.
    let blunt =
        used.points().iter().map(|point| point.distance(Point::default())).fold(f64::INFINITY, f64::min);
    let is_at_tip = nose.is_some_and(|nose| at.distance(tip) <= nose + blunt + AT_TIP);
    if is_at_tip && free.is_some() {
        return Some(tip);
    }
    region.nearest_on_edge(if is_at_tip { tip } else { at })
}

/// The corner of a region that is nearest to a point.
fn nearest_corner(region: &Region, to: Point) -> Option<Point> {
    region.outlines().flatten().min_by(|a, b| a.distance(to).total_cmp(&b.distance(to)))
}

/// The share of a line after which an outline overlaps a region.
fn first_overlap(region: &Region, outline: &Outline, from: Point, to: Point) -> f64 {
    let (mut free, mut met) = (0.0, 1.0);
    for _ in 0..HALVINGS {
        if (met - free) * from.distance(to) <= CONTACT {
            break;
        }
        let middle = (free + met) / 2.0;
        let overlaps = region.overlaps(&outline.along_line(from, between(from, to, middle)));
        *(if overlaps { &mut met } else { &mut free }) = middle;
    }
    met
}

fn between(from: Point, to: Point, share: f64) -> Point {
    Point::new(from.x + share * (to.x - from.x), from.z + share * (to.z - from.z))
}

/// Whether an outline comes near the bounding box of the blank.
fn near(stock: &Stock, outline: &[Point]) -> bool {
    let radius = stock.diameter.radius();
    outline.iter().any(|point| point.x < radius)
        && outline.iter().any(|point| point.z < stock.face)
        && outline.iter().any(|point| point.z > stock.back())
}

/// The point where a rapid begins to run along the outside of the blank, if material remains there.
fn along_outside(stock: &Stock, motion: &Motion, part: &mut Part) -> Option<Point> {
    let (from, to) = (motion.from, motion.to);
    let on = |point: Point| (point.x - stock.diameter.radius()).abs() <= ALONG;
    let (low, high) = (from.z.min(to.z).max(stock.back()), from.z.max(to.z).min(stock.face));
    if !on(from) || !on(to) || high - low <= ALONG {
        return None;
    }
    let skin = [(from.x - SKIN, low), (from.x - SKIN, high), (from.x, high), (from.x, low)];
    let (now, skin) = (part.now(), skin.map(|(x, z)| Point::new(x, z)));
    let stands = now.overlaps(&skin)
        && now.intersection(&[skin]).area() > SKIN * MIN_REMAINING.min((high - low) / 2.0);
    stands.then(|| Point::new(from.x, if from.z > to.z { high } else { low }))
}

/// The path of a rapid if both axes move at the same rate until the shorter one arrives. `None` if that path
/// is straight.
fn dogleg(motion: &Motion) -> Option<[Point; 3]> {
    let (from, to) = (motion.from, motion.to);
    let (dx, dz) = (to.x - from.x, to.z - from.z);
    let both = dx.abs().min(dz.abs());
    let differs = both > SAME && (dx.abs() - dz.abs()).abs() > SAME;
    differs.then(|| [from, Point::new(from.x + both * dx.signum(), from.z + both * dz.signum()), to])
}

/// The jaws around the end of the blank, which has the radius `outside` there, with the chuck body.
fn jaws(stock: &Stock, outside: f64) -> Option<Region> {
    let grip = stock.grip.filter(|&grip| grip > 0.0)?;
    let back = stock.back();
    let corners = [
        (outside, back),
        (outside, back + grip),
        (outside + JAW, back + grip),
        (outside + JAW, back - JAW),
        (stock.bore.radius(), back - JAW),
        (stock.bore.radius(), back),
    ];
    Some(Region::inside(&corners.map(|(x, z)| Point::new(x, z))))
}

/// The jaws, with the end of the bar and the chuck body.
fn clamped(stock: &Stock, outside: f64) -> Option<Region> {
    let grip = stock.grip.filter(|&grip| grip > 0.0)?;
    Some(block((stock.bore.radius(), outside + JAW), (stock.back() - JAW, stock.back() + grip)))
}

/// The jaws and the chuck body.
fn chuck(stock: &Stock, outside: f64) -> Option<[Region; 2]> {
    let grip = stock.grip.filter(|&grip| grip > 0.0)?;
    let (back, outer) = (stock.back(), outside + JAW);
    let body = block((stock.bore.radius(), outer), (back - JAW, back));
    Some([block((outside, outer), (back, back + grip)), body])
}

/// The region between two radii and between two places along Z.
fn block((inner, outer): (f64, f64), (from, to): (f64, f64)) -> Region {
    let corners = [(inner, from), (inner, to), (outer, to), (outer, from)];
    Region::inside(&corners.map(|(x, z)| Point::new(x, z)))
}

/// Position of the quill before the first quill command: back if that command moves it forward, otherwise
/// forward, as in the setup.
fn quill_at_start(motions: &Motions) -> Quill {
    match motions.quills().find(|&said| said != Quill::Unknown) {
        Some(Quill::Forward) => Quill::Back,
        Some(Quill::Back | Quill::Unknown) | None => Quill::Forward,
    }
}

fn is_forward(said: Quill, at_start: Quill) -> bool {
    let quill = if said == Quill::Unknown { at_start } else { said };
    quill == Quill::Forward
}

/// The centre of the tailstock: a cone of 60°, and the quill.
fn center(tailstock: &Tailstock) -> Region {
    let Tailstock { z, diameter } = *tailstock;
    let radius = diameter.radius();
    let shoulder = z + radius / 30f64.to_radians().tan();
    let corners = [(0.0, z), (0.0, shoulder + 200.0), (radius, shoulder + 200.0), (radius, shoulder)];
    Region::inside(&corners.map(|(x, z)| Point::new(x, z)))
}
