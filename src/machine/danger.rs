//! What runs into what.
//!
//! In: each motion with its tool, and the work as it stands. Out: [`Finding`]s. What only touches is no
//! finding: outlines are held against the work a hundredth of a millimetre smaller than they are. Of a
//! tool that nobody has named only the tip counts, and nothing is found in a blank that nobody has
//! named. Must not know messages.

use super::live_way::LiveCuts;
use super::part::{Part, Turned, cut};
use super::region::Region;
use super::resolved_setup::{Basis, ResolvedSetup, ResolvedTool};
use super::sweep::{Outline, way_of};
use super::tool::Action;
use crate::geometry::{Point, SAME};
use crate::motion::{
    Cycle, CycleFamily, Feed, Motion, MotionKind, Motions, Quill, SpindleSpeed, SpindleTurn, Step,
};
use crate::setup::{Setup, Stock, Tailstock, ToolKind, Travel};
use crate::units::Diameter;

/// A place where something is wrong.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Finding {
    /// The motion.
    pub motion: usize,
    /// Where, mm: radius and length.
    pub at: Point,
    /// What.
    pub danger: Danger,
}

/// What can be wrong at the machine.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Danger {
    /// A rapid goes through the work.
    RapidThroughStock,
    /// A rapid goes through the work where each axis moves at its own rate until it is there.
    DoglegThroughStock,
    /// A rapid goes along the outside of the blank.
    RapidAlongStock,
    /// A rapid out of a bore goes through its wall.
    LeavesBore,
    /// A cycle comes back at rapid to a start within the material.
    CycleStart,
    /// A facing cycle starts on the chuck side of the face: what stands in front of it is cut at once.
    BehindFace {
        /// Z of the face of the blank, mm.
        face: f64,
    },
    /// The tool meets the jaws.
    IntoJaws,
    /// The tool meets the tailstock.
    IntoTailstock,
    /// The holder meets the work.
    HolderInStock,
    /// The slope falls more steeply than the trailing edge behind the tip: it cuts too. Degrees.
    SlopeTooSteep {
        /// The slope.
        slope: f64,
        /// What the tool can follow.
        tool: f64,
    },
    /// The tip cuts beyond the spindle axis.
    BelowCenter,
    /// The tip leaves the travel of an axis.
    OverTravel {
        /// The axis.
        axis: Axis,
        /// The end of its travel as a program writes it, mm.
        limit: f64,
    },
    /// The setup names tools, but not this one.
    ToolNotListed {
        /// Its station.
        station: u16,
    },
    /// The tool of the setup is of a kind that does not do this.
    OtherWork {
        /// The tool.
        kind: ToolKind,
        /// Its station.
        station: u16,
    },
    /// A cut with more feed than an insert takes.
    FastFeed {
        /// The feed, mm/rev.
        per_turn: f64,
    },
}

impl Danger {
    /// Whether there is a place of the picture to mark.
    pub fn has_place(&self) -> bool {
        !matches!(self, Self::ToolNotListed { .. } | Self::OtherWork { .. })
    }
}

/// An axis of the machine.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axis {
    /// Across the spindle axis.
    X,
    /// Along it.
    Z,
}

/// Length of the jaws across the axis, and of the chuck body, mm.
const JAW: f64 = 40.0;

/// How far beyond the axis a tip may go without a word, mm: facing goes a little past it.
const PAST_CENTER: f64 = 0.5;

/// Nearer to the spindle axis than this, mm, is on it.
const OFF_AXIS: f64 = 0.01;

/// Material that an edge takes off beside the way of the tip and that is worth a
/// word, mm² for each mm of way.
const BESIDE: f64 = 0.05;

/// Material that may be in the way of a tool without a word, mm². An entering angle of 95° leaves a wedge of
/// 5° at a shoulder: where the tool leaves at rapid, as many programs have it, it scrapes that off.
const SCRAPED: f64 = 0.25;

/// Where a bore is looked at, in front of the tip, mm.
const IN_FRONT: f64 = 0.5;

/// How far within the material the start of a cycle may lie without a word, mm.
const INSIDE: f64 = 0.1;

/// Nearer to the blank than this, mm, no tool is changed.
const CLEAR: f64 = 10.0;

/// With so much feed no insert of a common lathe cuts, mm/rev, and on blanks of more than [`LARGE`].
const FAST: f64 = 1.0;
const FAST_ON_LARGE: f64 = 2.0;

/// Diameter of a blank that is turned on heavy lathes, mm.
const LARGE: f64 = 200.0;

/// From here on it is reported as a feed in the other unit, mm/rev.
const FEED_OF_OTHER_UNIT: f64 = 5.0;

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

/// How near a rapid may come to the surface it runs along, mm.
const ALONG: f64 = 0.001;

/// How deep below the outside of the blank it is looked whether that still stands, and
/// along how much of the way, mm.
const SKIN: f64 = 0.05;
const STANDS: f64 = 0.5;

/// Whether a setup says anything that motions can be held against.
pub fn can_be_found(setup: &Setup) -> bool {
    setup.stock.is_some() || setup.tailstock.is_some() || setup.machine.travel != Travel::default()
}

/// Looks at motions, one after the other.
#[derive(Clone, Debug)]
pub struct DangerDetector {
    /// The jaws and the body of the chuck, as one: what meets both meets one thing.
    jaws: Option<Region>,
    /// The same as two, as they are drawn.
    chuck: Option<[Region; 2]>,
    /// The centre, in a program that has it forward.
    tailstock: Option<Region>,
    /// Where the quill is before the program says so.
    quill: Quill,
    stock: Option<Stock>,
    travel: Travel,
    missed: Vec<u16>,
    /// Stations that were reported to do other work.
    misused: Vec<u16>,
    /// The holes of drills on the axis.
    holes: Vec<Hole>,
    /// What live tools have cut.
    live_cuts: LiveCuts,
    /// Where C stands, degrees.
    c: f64,
    /// The motion before, dwells aside.
    before: Option<Motion>,
    /// The feed that was reported last, mm/rev.
    fast: Option<f64>,
    /// Station of the tool of the last motion.
    station: Option<u16>,
    /// Axes whose place is not known, X and Z: the tool was changed at the work, and
    /// they have not moved since.
    unknown: [bool; 2],
    /// The thread under way begins within the work.
    plunges: bool,
    /// Where the pass of a cycle under way began.
    pass_start: Option<Point>,
    /// All that was found.
    pub findings: Vec<Finding>,
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

/// Most findings that are kept.
const MOST: usize = 1000;

/// Whether the first pass of a thread goes down to its depth within the work: the tip, a little
/// above its end, in material.
fn plunges(infeed: &Motion, part: &mut Part) -> bool {
    let (from, to) = (infeed.from, infeed.to);
    let way = to.x - from.x;
    way.abs() > INSIDE && part.now().holds(Point::new(to.x - INSIDE * way.signum(), to.z))
}

impl DangerDetector {
    /// A detector for a program with these tools and this stock.
    pub fn new(resolved: &ResolvedSetup, motions: &Motions, setup: &Setup) -> Self {
        let given = |stock: (Stock, Basis)| (stock.1 == Basis::Given).then_some(stock.0);
        let stock = resolved.stock().and_then(given);
        let quill = quill_at_start(motions);
        let comes = motions.is_empty() || motions.quills().any(|said| is_forward(said, quill));
        Self {
            jaws: stock.and_then(|stock| jaws(&stock)),
            chuck: stock.and_then(|stock| chuck(&stock)),
            tailstock: setup.tailstock.filter(|_| comes).map(|tailstock| center(&tailstock)),
            quill,
            stock,
            travel: setup.machine.travel,
            missed: Vec::new(),
            misused: Vec::new(),
            holes: Vec::new(),
            live_cuts: LiveCuts::default(),
            c: 0.0,
            before: None,
            fast: None,
            station: None,
            unknown: [false; 2],
            plunges: false,
            pass_start: None,
            findings: Vec::new(),
        }
    }

    /// What stands around the work: the chuck, and the tailstock where it is forward. `moment`: what the program
    /// has said of the quill by then; nothing for all of the program.
    pub fn obstacles(&self, moment: Option<Quill>) -> impl Iterator<Item = &Region> {
        let forward = moment.is_none_or(|said| is_forward(said, self.quill));
        self.chuck.iter().flatten().chain(self.tailstock.iter().filter(move |_| forward))
    }

    /// Whether there is a chuck with jaws, and a tailstock.
    pub fn has_chuck_and_tailstock(&self) -> [bool; 2] {
        [self.jaws.is_some(), self.tailstock.is_some()]
    }

    /// Looks at the next motion, before its material is off.
    pub fn check_motion(&mut self, index: usize, motion: &Motion, resolved: &ResolvedSetup, part: &mut Part) {
        let process = &motion.process;
        let c = self.c;
        self.c = motion.rotary.map_or(c, |rotary| rotary.to);
        if self.findings.len() >= MOST
            || motion.kind == MotionKind::Dwell
            || process.uncertain
            || process.elsewhere
        {
            if motion.kind.cuts() {
                self.live_cuts.lose();
            }
            return;
        }
        let before = self.before.replace(*motion);
        let tool = resolved.tool(motion);
        let station = motion.process.tool.0;
        if self.station.replace(station).is_some_and(|last| last != station) && self.is_at_work(motion.from) {
            self.unknown = [true; 2];
        }
        let comes_from_elsewhere = self.unknown != [false; 2];
        self.unknown[0] &= (motion.to.x - motion.from.x).abs() <= SAME;
        self.unknown[1] &= (motion.to.z - motion.from.z).abs() <= SAME;
        if motion.kind.cuts() && resolved.misses(station) && !self.missed.contains(&station) {
            self.missed.push(station);
            self.tell(index, motion.from, Danger::ToolNotListed { station });
        }
        self.travel(index, motion);
        if self.unknown != [false; 2] {
            if motion.kind.cuts() {
                self.live_cuts.lose();
            }
            return;
        }
        // A tool is not changed in the work: where it comes from is not known, only where it arrives.
        let arrives = Motion { from: motion.to, ..*motion };
        let rapid = if comes_from_elsewhere { &arrives } else { motion };
        if tool.is_live_in(motion) {
            self.live(index, if motion.kind.cuts() { motion } else { rapid }, c, tool, part);
            return;
        }
        self.hit_obstacles(index, motion, tool);
        // After a block that was not carried out it is not known what is in the way.
        if self.stock.is_none() || motion.process.incomplete {
            return;
        }
        if motion.cycle.is_some() && self.cycle_start(index, motion, part) {
            return;
        }
        part.end_thread(motion);
        match motion.kind {
            MotionKind::Rapid => self.rapid(index, rapid, tool, part),
            _ => self.cut(index, motion, before.as_ref(), tool, part),
        }
    }

    /// A motion of a tool that turns itself: of its way only the tip is known.
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
            self.tell(index, at, Danger::RapidThroughStock);
        }
    }

    /// Whether a place is in the blank or near it.
    fn is_at_work(&self, at: Point) -> bool {
        self.stock.is_some_and(|stock| at.x < stock.diameter.radius() + CLEAR && at.z < stock.face + CLEAR)
    }

    fn tell(&mut self, motion: usize, at: Point, danger: Danger) {
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
                self.tell(index, motion.to, Danger::OverTravel { axis, limit });
            }
        }
    }

    fn hit_obstacles(&mut self, index: usize, motion: &Motion, tool: &ResolvedTool) {
        let tailstock = self.tailstock.as_ref().filter(|_| is_forward(motion.process.quill, self.quill));
        let obstacles = [(Danger::IntoJaws, self.jaws.as_ref()), (Danger::IntoTailstock, tailstock)];
        let found = obstacles.map(|(danger, obstacle)| {
            let obstacle = obstacle?;
            Some((danger, tool.shape.solids().find_map(|outline| hit(obstacle, outline, motion))?))
        });
        for (danger, at) in found.into_iter().flatten() {
            self.tell(index, at, danger);
        }
    }

    /// Whether a cycle starts in the material: each pass comes back at rapid to the start, along the work.
    fn cycle_start(&mut self, index: usize, motion: &Motion, part: &mut Part) -> bool {
        let Some(tag) = motion.cycle else { return false };
        let facing = match tag.cycle.family() {
            CycleFamily::Turning => tag.cycle == Cycle::Facing,
            CycleFamily::Threading => false,
            CycleFamily::Contour | CycleFamily::Pecking | CycleFamily::FaceHole | CycleFamily::SideHole => {
                return false;
            }
        };
        match tag.step {
            Step::Infeed => {
                self.pass_start = Some(motion.from);
                if tag.cycle == Cycle::Turning || facing {
                    return false;
                }
                if tag.pass == 1 {
                    self.plunges = plunges(motion, part);
                    if let Some(stock) = self.stock.filter(|_| self.plunges) {
                        self.tell(index, motion.from, Danger::BehindFace { face: stock.face });
                    }
                }
                // Of the later passes it is known.
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
        let found = places.any(|place| now.holds(place));
        if found {
            let face = self.stock.map_or(0.0, |stock| stock.face);
            self.tell(index, start, if facing { Danger::BehindFace { face } } else { Danger::CycleStart });
        }
        found
    }

    fn rapid(&mut self, index: usize, motion: &Motion, tool: &ResolvedTool, part: &mut Part) {
        let Some(stock) = self.stock else { return };
        let outlines = || tool.shape.solids();
        // Far from the blank nothing needs to be worked out.
        let far = |outline: &Outline, way: &[Point]| outline.along(way).all(|swept| !near(&stock, &swept));
        let straight = [motion.from, motion.to];
        if !outlines().all(|outline| far(outline, &straight)) {
            let now = part.now();
            if let Some(at) = outlines().find_map(|outline| hit(now, outline, motion)) {
                let from = motion.from;
                // Material begins beyond the tip all along the way to the wall: it stands in a bore.
                // Looked at a little in front of the tip, which may stand at the bottom or touch the wall.
                let in_bore = from.z < stock.face
                    && motion.to.x > from.x
                    && now
                        .radii(from.z + IN_FRONT)
                        .first()
                        .is_some_and(|material| material.0 > from.x - IN_FRONT && material.0 > 0.0);
                let danger = if in_bore { Danger::LeavesBore } else { Danger::RapidThroughStock };
                self.tell(index, at, danger);
                return;
            }
        }
        if let Some(at) = along_outside(&stock, motion, part) {
            self.tell(index, at, Danger::RapidAlongStock);
            return;
        }
        let Some(dogleg) = dogleg(motion) else { return };
        if !outlines().all(|outline| far(outline, &dogleg)) {
            let now = part.now();
            let legs = dogleg.windows(2).map(|ends| Motion { from: ends[0], to: ends[1], ..*motion });
            let found = legs.flat_map(|leg| outlines().find_map(|outline| hit(now, outline, &leg))).next();
            if let Some(at) = found {
                self.tell(index, at, Danger::DoglegThroughStock);
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
            self.tell(index, if motion.to.x == low { motion.to } else { motion.from }, Danger::BelowCenter);
        }
        self.misuse(index, motion, before, tool, part);
        self.fast_feed(index, motion, before, tool, part);
        if let Some(body) = &tool.shape.body {
            let body = body.shrunk(0.01);
            // What the edge takes off in the same motion is not in the way of the holder.
            if hit(part.now(), &body, motion).is_some() {
                let mut left = part.now().clone();
                left.cut(&cut(motion, &Turned::default(), tool));
                if let Some(at) = hit(&left, &body, motion) {
                    self.tell(index, at, Danger::HolderInStock);
                    return;
                }
            }
        }
        if let Some(danger) = too_steep(motion, tool, part) {
            self.tell(index, motion.to, danger);
        }
    }
}

/// Whether a motion stays on the spindle axis.
fn is_on_axis(motion: &Motion) -> bool {
    motion.from.x.abs() <= OFF_AXIS && motion.to.x.abs() <= OFF_AXIS
}

impl DangerDetector {
    /// A tool of the setup does what another kind of tool is for: once for each station.
    fn misuse(
        &mut self,
        index: usize,
        motion: &Motion,
        before: Option<&Motion>,
        tool: &ResolvedTool,
        part: &mut Part,
    ) {
        let Some(kind) = tool.tool.kind.filter(|_| tool.basis == Basis::Given) else { return };
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
            ToolKind::Drill => turns && !threads && !on_axis && !self.bores_own_hole(station, motion, before),
            ToolKind::Tap | ToolKind::Threading => turns && !threads && !on_axis,
            ToolKind::Turning => threads && !on_axis,
            ToolKind::Boring | ToolKind::Grooving => threads && !on_axis && !suits_lead(motion, tool, kind),
            ToolKind::Endmill => false,
        };
        if other && !self.misused.contains(&station) && is_in_material(motion, part) {
            self.misused.push(station);
            self.tell(index, motion.to, Danger::OtherWork { kind, station });
        }
    }

    /// A drill goes into the work on the axis.
    fn drills(&mut self, station: u16, z: f64) {
        match self.holes.iter_mut().find(|hole| hole.station == station) {
            Some(hole) => hole.bottom = hole.bottom.min(z),
            None => self.holes.push(Hole { station, bottom: z, is_bored: false }),
        }
    }

    /// Whether a drill turns in the hole that it has drilled, and first goes outwards to do so.
    fn bores_own_hole(&mut self, station: u16, motion: &Motion, before: Option<&Motion>) -> bool {
        let Some(hole) = self.holes.iter_mut().find(|hole| hole.station == station) else { return false };
        let goes_outwards = before.is_some_and(|before| before.from.x < motion.from.x - SAME);
        hole.is_bored |= goes_outwards;
        hole.is_bored && motion.from.z.min(motion.to.z) >= hole.bottom - SAME
    }

    /// A cut off the axis, where no tap stands, or of a drilling cycle, with an absurd feed: once for each feed.
    fn fast_feed(
        &mut self,
        index: usize,
        motion: &Motion,
        before: Option<&Motion>,
        tool: &ResolvedTool,
        part: &mut Part,
    ) {
        let on_axis = is_on_axis(motion);
        let drills = motion.cycle.is_some_and(|tag| {
            matches!(tag.cycle, Cycle::FacePecking | Cycle::Drilling | Cycle::FaceDrilling)
        });
        // A keyway is shaped with the spindle held.
        if motion.process.turn == SpindleTurn::Stopped {
            return;
        }
        let per_turn = match (motion.process.feed, motion.process.speed) {
            (Feed::PerTurn(feed), _) if feed < FEED_OF_OTHER_UNIT => feed,
            (Feed::PerMinute(feed), SpindleSpeed::Constant(speed)) if speed > 0.0 => feed / speed,
            _ => return,
        };
        let is_large = self.stock.is_some_and(|stock| stock.diameter.mm() > LARGE);
        let is_fast = per_turn >= if is_large { FAST_ON_LARGE } else { FAST };
        let cuts_by_feed = motion.kind != MotionKind::Thread && (!on_axis || drills);
        if is_fast
            && cuts_by_feed
            && self.fast != Some(per_turn)
            && is_in_material(motion, part)
            && !before.is_some_and(|before| is_way_out(motion, before, tool, part))
        {
            self.fast = Some(per_turn);
            self.tell(index, motion.to, Danger::FastFeed { per_turn });
        }
    }
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

/// Whether a slope is steeper than the trailing edge of a turning tool, and the edge cuts because of it.
fn too_steep(motion: &Motion, tool: &ResolvedTool, part: &mut Part) -> Option<Danger> {
    if tool.basis == Basis::Inferred || motion.arc().is_some() || motion.kind != MotionKind::Feed {
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
    // What lies behind the tip, above the slope, and is taken off.
    let behind = part.now().in_common(&cut(motion, &Turned::default(), tool));
    let above = behind.area_beside(motion.from, motion.to);
    let worth = above > BESIDE * motion.length();
    worth.then_some(Danger::SlopeTooSteep { slope: slope.to_degrees(), tool: follows.to_degrees() })
}

/// Where an outline first meets a region on the way of a motion.
fn hit(region: &Region, outline: &Outline, motion: &Motion) -> Option<Point> {
    if outline.points().len() < 3 {
        return None;
    }
    let from = motion.from;
    outline.along(&way_of(motion)).filter(|swept| region.meets(swept)).find_map(|swept| {
        let common = region.in_common(&[swept]);
        if common.area() < SCRAPED {
            return None;
        }
        common.outlines().flatten().min_by(|a, b| a.distance(from).total_cmp(&b.distance(from)))
    })
}

/// Whether an outline comes near the box of the blank.
fn near(stock: &Stock, outline: &[Point]) -> bool {
    let radius = stock.diameter.radius();
    outline.iter().any(|point| point.x < radius)
        && outline.iter().any(|point| point.z < stock.face)
        && outline.iter().any(|point| point.z > stock.back())
}

/// A rapid that runs along the outside of the blank where that still stands, and where it begins to.
fn along_outside(stock: &Stock, motion: &Motion, part: &mut Part) -> Option<Point> {
    let (from, to) = (motion.from, motion.to);
    let on = |point: Point| (point.x - stock.diameter.radius()).abs() <= ALONG;
    let (low, high) = (from.z.min(to.z).max(stock.back()), from.z.max(to.z).min(stock.face));
    if !on(from) || !on(to) || high - low <= ALONG {
        return None;
    }
    let skin = [(from.x - SKIN, low), (from.x - SKIN, high), (from.x, high), (from.x, low)];
    let (now, skin) = (part.now(), skin.map(|(x, z)| Point::new(x, z)));
    let stands = now.meets(&skin) && now.in_common(&[skin]).area() > SKIN * STANDS.min((high - low) / 2.0);
    stands.then(|| Point::new(from.x, if from.z > to.z { high } else { low }))
}

/// The way of a rapid whose axes move at the same rate until the shorter one is there; nothing for
/// one that is straight anyway.
fn dogleg(motion: &Motion) -> Option<[Point; 3]> {
    let (from, to) = (motion.from, motion.to);
    let (dx, dz) = (to.x - from.x, to.z - from.z);
    let both = dx.abs().min(dz.abs());
    let differs = both > SAME && (dx.abs() - dz.abs()).abs() > SAME;
    differs.then(|| [from, Point::new(from.x + both * dx.signum(), from.z + both * dz.signum()), to])
}

/// The jaws around the end of the blank, with the chuck body.
fn jaws(stock: &Stock) -> Option<Region> {
    let grip = stock.grip.filter(|&grip| grip > 0.0)?;
    let (outside, back) = (stock.diameter.radius(), stock.back());
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

/// The jaws, and the body that they stand on.
fn chuck(stock: &Stock) -> Option<[Region; 2]> {
    let grip = stock.grip.filter(|&grip| grip > 0.0)?;
    let (outside, back) = (stock.diameter.radius(), stock.back());
    let block = |inner: f64, from: f64, to: f64| {
        let outer = outside + JAW;
        let corners = [(inner, from), (inner, to), (outer, to), (outer, from)];
        Region::inside(&corners.map(|(x, z)| Point::new(x, z)))
    };
    Some([block(outside, back, back + grip), block(stock.bore.radius(), back - JAW, back)])
}

/// Where the quill is before the program says so: forward, as the setup has it, unless the program first brings
/// it there.
fn quill_at_start(motions: &Motions) -> Quill {
    match motions.quills().find(|&said| said != Quill::Unsaid) {
        Some(Quill::Forward) => Quill::Back,
        Some(Quill::Back | Quill::Unsaid) | None => Quill::Forward,
    }
}

fn is_forward(said: Quill, at_start: Quill) -> bool {
    let quill = if said == Quill::Unsaid { at_start } else { said };
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
