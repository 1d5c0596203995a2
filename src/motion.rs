//! The motion list: the moves of the tool tip, in order, as a structure of arrays.
//!
//! In: motions pushed one by one by the interpreter. Out: columns that can be handed over without copying.
//! Motions live in [`Chunk`]s. Every place in the source is relative to the first block of its chunk, so text
//! inserted before a chunk changes only the base of the chunk. Knows nothing of G-code words.

use std::ops::Range;
use std::sync::atomic::{AtomicU64, Ordering};

use crate::geometry::virtual_plane::VirtualMove;
use crate::geometry::{Arc, Point, SAME, Turn};
use crate::heap;
use crate::source::Span;
use crate::source::shift::Shift;

/// What kind of motion the tool tip makes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum MotionKind {
    /// Rapid traverse, without cutting.
    Rapid = 0,
    /// Straight cut at feed.
    Feed = 1,
    /// Arc, clockwise with Z to the right and X up (G02).
    ArcClockwise = 2,
    /// Arc, counter-clockwise (G03).
    ArcCounterclockwise = 3,
    /// Straight cut locked to the spindle: a thread.
    Thread = 4,
    /// The tool dwells.
    Dwell = 5,
}

impl MotionKind {
    /// All kinds in the order of their numbers.
    pub const ALL: [MotionKind; 6] =
        [Self::Rapid, Self::Feed, Self::ArcClockwise, Self::ArcCounterclockwise, Self::Thread, Self::Dwell];

    /// The kind of an arc with the given direction.
    pub fn of_turn(turn: Turn) -> Self {
        match turn {
            Turn::Clockwise => Self::ArcClockwise,
            Turn::Counterclockwise => Self::ArcCounterclockwise,
        }
    }

    /// Whether the tool is meant to cut.
    pub fn cuts(self) -> bool {
        !matches!(self, Self::Rapid | Self::Dwell)
    }
}

/// Defines the canned cycles: the number that is stored, the code in G-code system A, the family.
macro_rules! cycles {
    ($($(#[$doc:meta])* $cycle:ident = $number:literal, $code:literal, $family:ident;)+) => {
        /// The canned cycle that made a motion.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        #[repr(u8)]
        pub enum Cycle { $($(#[$doc])* $cycle = $number),+ }

        impl Cycle {
            /// All of them, in the order of their numbers, which begin at 1.
            const ALL: &[Cycle] = &[$(Self::$cycle),+];

            /// The family of the cycle.
            pub fn family(self) -> CycleFamily {
                match self { $(Self::$cycle => CycleFamily::$family),+ }
            }

            /// Its code in G-code system A.
            pub fn code(self) -> &'static str {
                match self { $(Self::$cycle => $code),+ }
            }
        }
    };
}

cycles! {
    /// Turning cycle, G90.
    Turning = 1, "G90", Turning;
    /// Thread cycle, G92.
    Threading = 2, "G92", Threading;
    /// Facing cycle, G94.
    Facing = 3, "G94", Turning;
    /// Finishing along the contour, G70.
    Finishing = 4, "G70", Contour;
    /// Rough turning, G71.
    RoughTurning = 5, "G71", Contour;
    /// Rough facing, G72.
    RoughFacing = 6, "G72", Contour;
    /// Pattern repeating, G73.
    Pattern = 7, "G73", Contour;
    /// Pecking along Z, G74.
    FacePecking = 8, "G74", Pecking;
    /// Grooving along X, G75.
    Grooving = 9, "G75", Pecking;
    /// Thread in many passes, G76.
    MultiThreading = 10, "G76", Threading;
    /// Drilling, G81 of some controls.
    Drilling = 11, "G81", FaceHole;
    /// Counterboring, G82 of some controls.
    CounterBoring = 12, "G82", FaceHole;
    /// Drilling into the face, G83.
    FaceDrilling = 13, "G83", FaceHole;
    /// Tapping into the face, G84.
    FaceTapping = 14, "G84", FaceHole;
    /// Boring into the face, G85.
    FaceBoring = 15, "G85", FaceHole;
    /// Boring with a stopped spindle, G86 of some controls.
    BoringStop = 16, "G86", FaceHole;
    /// Drilling into the side, G87.
    SideDrilling = 17, "G87", SideHole;
    /// Tapping into the side, G88.
    SideTapping = 18, "G88", SideHole;
    /// Boring into the side, G89.
    SideBoring = 19, "G89", SideHole;
}

/// Cycles grouped by the kind of work, for code that does not need the exact cycle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CycleFamily {
    /// One cut along or across the axis in each pass: G90, G94.
    Turning,
    /// Threads: G92, G76.
    Threading,
    /// Along a contour: G70 to G73.
    Contour,
    /// Pecks, along Z or along X: G74, G75.
    Pecking,
    /// A hole in the face: G81 to G86.
    FaceHole,
    /// A hole in the side: G87 to G89.
    SideHole,
}

/// The step of a cycle that a motion belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum Step {
    /// From the start point to the depth of the pass.
    Infeed = 1,
    /// Along the workpiece.
    Cut = 2,
    /// Leaving the thread at 45° before its end.
    PullOut = 3,
    /// Away from the workpiece.
    Retract = 4,
    /// Back to the start point of the cycle, or of the next pass.
    Return = 5,
    /// From the start point to the beginning of the passes.
    Approach = 6,
    /// At 45° away from the wall at the end of a pass.
    Escape = 7,
    /// Along the contour: the last pass of roughing, or finishing.
    Contour = 8,
    /// Sideways relief at the bottom of a peck.
    Relief = 9,
    /// To the next column of pecks.
    Stepover = 10,
}

impl Step {
    const ALL: [Step; 10] = [
        Self::Infeed,
        Self::Cut,
        Self::PullOut,
        Self::Retract,
        Self::Return,
        Self::Approach,
        Self::Escape,
        Self::Contour,
        Self::Relief,
        Self::Stepover,
    ];
}

impl Step {
    /// Name in the output of the command line and in the wasm interface.
    pub fn name(self) -> &'static str {
        match self {
            Self::Infeed => "infeed",
            Self::Cut => "cut",
            Self::PullOut => "pull-out",
            Self::Retract => "retract",
            Self::Return => "return",
            Self::Approach => "approach",
            Self::Escape => "escape",
            Self::Contour => "contour",
            Self::Relief => "relief",
            Self::Stepover => "stepover",
        }
    }
}

/// The cycle, pass and step that a motion belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CycleStep {
    /// The cycle.
    pub cycle: Cycle,
    /// Pass from 1, counted while the cycle stays modal.
    pub pass: u32,
    /// The step of the pass.
    pub step: Step,
}

/// How fast the tool travels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Feed {
    /// No F word yet.
    Unset,
    /// Millimetres per minute (G98).
    PerMinute(f64),
    /// Millimetres per revolution (G99).
    PerTurn(f64),
}

impl Feed {
    /// A feed per revolution of at least this value, mm/rev, is assumed to be in the other unit.
    pub const OF_OTHER_UNIT: f64 = 20.0;
}

/// How the spindle turns.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SpindleSpeed {
    /// Spindle speed, rpm (G97); 0 while no S was given.
    Constant(f64),
    /// Constant cutting speed (G96), between the minimum and maximum spindle speed of G50.
    Surface {
        /// Cutting speed, m/min.
        speed: f64,
    },
}

/// Which way the spindle turns.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SpindleTurn {
    /// Not turning (M05).
    Stopped,
    /// Forward (M03).
    Forward,
    /// Reverse (M04).
    Reverse,
}

impl SpindleTurn {
    /// The opposite direction; a stopped spindle stays stopped.
    pub fn reversed(self) -> Self {
        match self {
            Self::Stopped => Self::Stopped,
            Self::Forward => Self::Reverse,
            Self::Reverse => Self::Forward,
        }
    }
}

/// Position of the tailstock quill, as far as the program has set it (M25 and M26 on the machine of seed
/// 002).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quill {
    /// Not set yet.
    Unknown,
    /// Extended (M25).
    Forward,
    /// Retracted (M26).
    Back,
}

/// The state of a motion that seldom changes from one motion to the next.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Process {
    /// Feed in force.
    pub feed: Feed,
    /// Spindle speed in force.
    pub speed: SpindleSpeed,
    /// Spindle direction.
    pub turn: SpindleTurn,
    /// Highest spindle speed (G50 S), rpm, if one is set.
    pub clamp: Option<f64>,
    /// Lowest spindle speed (G50 Q), rpm, if one is set.
    pub lowest: Option<f64>,
    /// Turret station and offset number of the T word in force.
    pub tool: (u16, u16),
    /// Position of the tailstock quill.
    pub quill: Quill,
    /// Whether the motion depends on something unknown, because an earlier block could not be executed.
    pub uncertain: bool,
    /// Whether an earlier block could not be executed, so that the remaining material is not known.
    pub incomplete: bool,
    /// Whether the motion is on the other end of the part, or in a work frame other than that of the first
    /// cut and with an unknown zero: a second clamping, or the sub spindle.
    pub other_setup: bool,
    /// Whether the spindle is stopped (M05) and no tool is known to be driven: a bar puller, a gripper, a
    /// stop. Unlike with a [stopped](SpindleTurn::Stopped) spindle before the first M03, such a motion
    /// removes nothing.
    pub still: bool,
    /// The work coordinate system in force: 0 to 5 for G54 to G59, 6 for G54.1 P1.
    pub frame: u16,
    /// Offset from programmed to workpiece coordinates, mm; zero if unknown. See [`Motion::on_workpiece`].
    pub zero: Point,
    /// Position of the tip minus the programmed position, mm, X as a radius: the wear of the tool offset in
    /// force, and changes of that offset by the program. See [`Motion::at_tip`].
    pub tip_shift: Point,
}

impl Process {
    /// Whether a cut removes material at a known position of the first clamping.
    pub fn removes_material(&self) -> bool {
        !self.uncertain && !self.other_setup && !self.still
    }
}

/// The most frequently used properties of a motion; faster to get than the whole motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Glance {
    /// The kind of motion.
    pub kind: MotionKind,
    /// Start point.
    pub from: Point,
    /// End point.
    pub to: Point,
    /// Whether the motion belongs to a canned cycle.
    pub is_of_cycle: bool,
    /// Turret station in force.
    pub station: u16,
    /// Spindle direction.
    pub turn: SpindleTurn,
}

/// A move as it was programmed, before compensation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Programmed {
    /// Start point.
    pub from: Point,
    /// End point.
    pub to: Point,
    /// Centre, for arcs only; the direction is that of the motion.
    pub center: Option<Point>,
}

/// Whether the operator can make the program skip a stop.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StopKind {
    /// Unconditional (M00).
    Always,
    /// Optional (M01): stops only while the switch for optional stops is on.
    Optional,
}

impl StopKind {
    /// The M code.
    pub fn code(self) -> &'static str {
        match self {
            Self::Always => "M00",
            Self::Optional => "M01",
        }
    }
}

/// A stop: the program waits for the operator before a motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Stop {
    /// Whether the stop is optional.
    pub kind: StopKind,
    /// Bytes of the block.
    pub span: Span,
    /// Line of the block, from 0.
    pub line: u32,
}

impl Stop {
    /// Adjusts the place after a change of the text before it.
    pub fn shift(&mut self, shift: &Shift) {
        self.line = shift.line(self.line, self.span.start);
        self.span = shift.span(self.span);
    }
}

/// The movement of the C axis in a motion. Angles are degrees, not reduced to one turn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rotary {
    /// C at the start.
    pub from: f64,
    /// C at the end.
    pub to: f64,
    /// The feed distance of one degree, mm: 1 under G21, 25.4 under G20 (FANUC B-64304EN, feed of rotary
    /// axes).
    pub degree: f64,
    /// The move as programmed under polar or cylindrical interpolation; the points of the motion itself are
    /// then machine positions.
    pub virtual_move: Option<VirtualMove>,
}

/// One motion as a value, to push or to read.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Motion {
    /// The kind of motion.
    pub kind: MotionKind,
    /// Position of the tip at the start, in the current work frame, like `to`.
    pub from: Point,
    /// End point.
    pub to: Point,
    /// Arc centre, for arcs only.
    pub center: Option<Point>,
    /// Thread lead, mm/rev along the longer axis; for threads and the other motions of a thread cycle.
    pub lead: Option<f64>,
    /// Increase of the lead per revolution of the spindle (K of G34), mm.
    pub lead_change: Option<f64>,
    /// Angle past the zero mark of the spindle at which the first move of a thread begins (Q of G32, G34 and
    /// G92), degrees. 0 for a move that continues a thread.
    pub start_angle: f64,
    /// Dwell time in seconds, for dwells only.
    pub seconds: Option<f64>,
    /// The programmed path, if tool nose radius compensation changes it.
    pub programmed: Option<Programmed>,
    /// The movement of the C axis, if it takes part.
    pub rotary: Option<Rotary>,
    /// The cycle it belongs to.
    pub cycle: Option<CycleStep>,
    /// Feed, spindle and tool.
    pub process: Process,
}

impl Motion {
    /// A straight motion that belongs to no cycle, without thread and C axis.
    #[inline]
    pub fn straight(kind: MotionKind, from: Point, to: Point, process: Process) -> Self {
        Self {
            kind,
            from,
            to,
            center: None,
            lead: None,
            lead_change: None,
            start_angle: 0.0,
            seconds: None,
            programmed: None,
            rotary: None,
            cycle: None,
            process,
        }
    }

    /// The true arc of an arc motion, in the turning plane.
    pub fn arc(&self) -> Option<Arc> {
        let turn = match self.kind {
            MotionKind::ArcClockwise => Turn::Clockwise,
            MotionKind::ArcCounterclockwise => Turn::Counterclockwise,
            _ => return None,
        };
        Some(Arc { start: self.from, end: self.to, center: self.center?, turn })
    }

    /// Whether only C moves while the tool stays in place.
    pub fn is_turn(&self) -> bool {
        self.rotary.is_some_and(|rotary| rotary.virtual_move.is_none())
    }

    /// How far C turns in the turning plane, in mm of feed.
    pub fn turned(&self) -> f64 {
        let turned = self.rotary.filter(|rotary| rotary.virtual_move.is_none());
        turned.map_or(0.0, |rotary| rotary.degree * (rotary.to - rotary.from).abs())
    }

    /// Length along the longer axis, mm; the lead refers to this axis.
    pub fn longer_axis(&self) -> f64 {
        (self.from.x - self.to.x).abs().max((self.from.z - self.to.z).abs())
    }

    /// The lead at the end of a thread, mm: n revolutions are F·n + K·n²/2 long.
    pub fn last_lead(&self) -> Option<f64> {
        let lead = self.lead?;
        let change = self.lead_change.filter(|&change| change != 0.0);
        Some(change.map_or(lead, |change| (lead * lead + 2.0 * change * self.longer_axis()).max(0.0).sqrt()))
    }

    /// The lead of a thread, mm; the mean if it changes.
    pub fn mean_lead(&self) -> Option<f64> {
        Some(f64::midpoint(self.lead?, self.last_lead()?))
    }

    /// Revolutions of the spindle in a motion that is locked to it.
    pub fn turns(&self) -> Option<f64> {
        Some(self.longer_axis() / self.mean_lead()?.abs()).filter(|turns| turns.is_finite())
    }

    /// The fraction of the path, 0 to 1, after `turns` revolutions, for a motion that is locked to the
    /// spindle.
    pub fn share_after(&self, turns: f64) -> Option<f64> {
        let way = self.lead? * turns + self.lead_change.unwrap_or(0.0) * turns * turns / 2.0;
        Some(way / self.longer_axis()).filter(|share| share.is_finite())
    }

    /// The move as programmed under polar or cylindrical interpolation.
    pub fn virtual_move(&self) -> Option<VirtualMove> {
        self.rotary?.virtual_move
    }

    /// Mirrors a cut on the −X side to +X. The workpiece rotates, so the same material is removed. A facing
    /// cut that goes a little past the axis is returned unchanged.
    pub fn on_positive_side(self) -> Motion {
        const PAST_AXIS: f64 = 2.0;
        // The radius of the thinnest pin that is turned there, mm.
        const THINNEST: f64 = 0.5;
        let (from, to) = (self.from, self.to);
        // A facing tool past the axis only arrives from the +X side or returns to it. A tool that moves along
        // the part or away from the axis turns a pin.
        let goes_on = to.x < from.x - SAME || to.z < from.z - SAME && to.x <= SAME;
        let turns = from.x <= -THINNEST && goes_on;
        if from.x + to.x >= 0.0 || from.x.min(to.x) >= -PAST_AXIS && !(turns && self.kind.cuts()) {
            return self;
        }
        self.mirrored(|at| Point::new(-at.x, at.z))
    }

    /// The motion mirrored by the function `over`, which maps points; arcs change their direction.
    pub fn mirrored(self, over: impl Fn(Point) -> Point) -> Motion {
        let kind = match self.kind {
            MotionKind::ArcClockwise => MotionKind::ArcCounterclockwise,
            MotionKind::ArcCounterclockwise => MotionKind::ArcClockwise,
            other => other,
        };
        Motion { kind, from: over(self.from), to: over(self.to), center: self.center.map(over), ..self }
    }

    /// The motion of the tip in the coordinates of the frame of the first cut (workpiece coordinates).
    pub fn on_workpiece(mut self) -> Motion {
        let by = std::mem::take(&mut self.process.zero).moved(std::mem::take(&mut self.process.tip_shift));
        self.moved(by)
    }

    /// The motion of the tip, in the coordinates of the frame in force.
    pub fn at_tip(mut self) -> Motion {
        let by = std::mem::take(&mut self.process.tip_shift);
        self.moved(by)
    }

    /// The motion moved by a distance, with its programmed path.
    fn moved(mut self, by: Point) -> Motion {
        if by == Point::default() {
            return self;
        }
        (self.from, self.to) = (self.from.moved(by), self.to.moved(by));
        self.center = self.center.map(|center| center.moved(by));
        if let Some(programmed) = &mut self.programmed {
            // In a virtual plane, the programmed points are points of the plane.
            let own = self.rotary.and_then(|rotary| rotary.virtual_move);
            let by = own.map_or(by, |own| own.surface.enter(by, 0.0, 0.0).0);
            programmed.from = programmed.from.moved(by);
            programmed.to = programmed.to.moved(by);
            programmed.center = programmed.center.map(|center| center.moved(by));
        }
        if let Some(own) = self.rotary.as_mut().and_then(|rotary| rotary.virtual_move.as_mut()) {
            *own = own.moved(by);
            (self.from, self.to) = (own.at(0.0), own.at(1.0));
        }
        self
    }

    /// The motion along the programmed path, if compensation changes it.
    pub fn as_programmed(&self) -> Option<Motion> {
        // In a virtual plane, the programmed points are points of the plane.
        let Programmed { from, to, center } = self.programmed.filter(|_| self.rotary.is_none())?;
        Some(Motion { from, to, center, programmed: None, ..*self })
    }

    /// The part of the motion up to the fraction `share` of its path.
    pub fn first_part(&self, share: f64) -> Motion {
        let seconds = self.seconds.map(|seconds| share * seconds);
        if let Some(own) = self.virtual_move() {
            let (own, _) = own.split(share);
            let rotary = self.rotary.map(|rotary| Rotary {
                to: rotary.from + own.surface.turn_along(&own.way),
                virtual_move: Some(own),
                ..rotary
            });
            return Motion { to: own.at(1.0), rotary, seconds, ..*self };
        }
        let rotary = self.rotary.map(|own| Rotary { to: own.from + share * (own.to - own.from), ..own });
        let to = self.arc().map_or_else(|| self.between(share), |arc| arc.at(share));
        // An arc that returns to its start is a full circle.
        let center = self.center.filter(|_| !to.is_same(self.from));
        let kind = if self.center.is_some() && center.is_none() { MotionKind::Feed } else { self.kind };
        Motion { kind, to, center, rotary, seconds, ..*self }
    }

    /// The point at the fraction `share` of the straight line from start to end.
    pub fn between(&self, share: f64) -> Point {
        let Motion { from, to, .. } = self;
        Point::new(from.x + share * (to.x - from.x), from.z + share * (to.z - from.z))
    }

    /// Length of the path, mm; 0 for a dwell.
    pub fn length(&self) -> f64 {
        match (self.rotary.and_then(|rotary| rotary.virtual_move), self.arc()) {
            (Some(own), _) => own.length(),
            (None, Some(arc)) => arc.length(),
            (None, None) => self.from.distance(self.to),
        }
    }
}

/// The place of a block that made motions: bytes and line, relative to the chunk.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct BlockPlace {
    /// First byte, relative to the first byte of the chunk; negative if the program jumped back.
    start: i32,
    /// Length in bytes.
    len: u32,
    /// Line, relative to the first line of the chunk.
    line: i32,
}

/// Indices into the tables of the chunk, for the data of a motion other than its kind and end point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Row {
    /// Index into `blocks`.
    block: u32,
    /// Packed [`CycleStep`], 0 for none.
    cycle: u32,
    /// Index into `processes`.
    process: u32,
    /// Index into `centers` (arcs) or `numbers` (lead, seconds), or [`NONE`].
    detail: u32,
}

/// No entry in a side table.
const NONE: u32 = u32::MAX;

/// A work frame that the program has left.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LeftFrame {
    /// As [`Process::frame`].
    pub frame: u16,
    /// Machine position minus work position in this frame, mm.
    pub offset: Point,
}

/// A sequence of motions with the places of the blocks that made them.
#[derive(Clone, Debug, PartialEq)]
pub struct Chunk {
    /// Start of the chunk in the text: the places of its blocks are relative to this byte.
    pub base: u32,
    /// The line (from 0) of `base`.
    pub first_line: u32,
    /// Position of the tip before the first motion.
    start: Point,
    /// Whether a block before the chunk could not be executed.
    incomplete: bool,
    /// Work frames left before the first cut, each with the number of motions before the change. See
    /// [`Chunk::place_on_workpiece`].
    left: Vec<(usize, LeftFrame)>,
    /// Start points of motions that follow a change of the frame: they do not start where the previous motion
    /// ended.
    starts: Vec<(u32, Point)>,
    /// The programmed paths of compensated motions.
    programmed: Vec<(u32, Programmed)>,
    /// Motions in which C takes part.
    rotary: Vec<(u32, Rotary)>,
    /// Threads whose lead changes.
    lead_changes: Vec<(u32, f64)>,
    /// Threads that start past the zero mark of the spindle.
    start_angles: Vec<(u32, f64)>,
    /// Motions before which the program stops.
    stops: Vec<(u32, (StopKind, BlockPlace))>,
    kind: Vec<u8>,
    /// X of the end point, radius in mm.
    x: Vec<f64>,
    /// Z of the end point, mm.
    z: Vec<f64>,
    rows: Vec<Row>,
    blocks: Vec<BlockPlace>,
    processes: Vec<Process>,
    /// Whether any process has a zero other than that of the workpiece, or a shift of the tip.
    is_moved: bool,
    centers: Vec<Point>,
    numbers: Vec<f64>,
}

impl Chunk {
    /// Bytes of a linear motion that is the only one of its block.
    pub const BYTES_PER_MOTION: usize =
        size_of::<u8>() + 2 * size_of::<f64>() + size_of::<Row>() + size_of::<BlockPlace>();

    /// A chunk without motions, whose places are relative to byte `base` on line `first_line` (from 0).
    pub fn new(base: u32, first_line: u32, start: Point) -> Self {
        Self {
            base,
            first_line,
            start,
            incomplete: false,
            left: Vec::new(),
            starts: Vec::new(),
            programmed: Vec::new(),
            rotary: Vec::new(),
            lead_changes: Vec::new(),
            start_angles: Vec::new(),
            stops: Vec::new(),
            kind: Vec::new(),
            x: Vec::new(),
            z: Vec::new(),
            rows: Vec::new(),
            blocks: Vec::new(),
            processes: Vec::new(),
            is_moved: false,
            centers: Vec::new(),
            numbers: Vec::new(),
        }
    }

    /// Sets whether a block before the chunk could not be executed.
    pub fn set_incomplete(&mut self, incomplete: bool) {
        self.incomplete = incomplete;
    }

    /// Adjusts the places of all blocks after a change of the text before them.
    pub fn shift(&mut self, shift: &Shift) {
        self.first_line = shift.line(self.first_line, self.base);
        self.base = shift.byte(self.base);
    }

    /// Number of motions.
    pub fn len(&self) -> usize {
        self.kind.len()
    }

    /// Indices of the motions whose path is changed by compensation.
    pub fn compensated(&self) -> impl Iterator<Item = usize> + '_ {
        self.programmed.iter().map(|(index, _)| *index as usize)
    }

    /// Whether there are no motions.
    pub fn is_empty(&self) -> bool {
        self.kind.is_empty()
    }

    /// Kinds, as the discriminants of [`MotionKind`].
    pub fn kinds(&self) -> &[u8] {
        &self.kind
    }

    /// X of the end points: radius, mm.
    pub fn xs(&self) -> &[f64] {
        &self.x
    }

    /// Z of the end points, mm.
    pub fn zs(&self) -> &[f64] {
        &self.z
    }

    /// Whether all motions are plain turning, without C, Y and cycles.
    pub fn only_turns(&self) -> bool {
        self.rotary.is_empty() && self.rows.iter().all(|row| row.cycle == 0)
    }

    /// Adds a motion of the block at `span` on `line` (from 0).
    pub fn push(&mut self, motion: &Motion, span: Span, line: u32) {
        let index = self.kind.len() as u32;
        self.push_move(motion.kind, motion.from, motion.to, motion.center, &motion.process, span, line);
        if let Some(programmed) = motion.programmed {
            self.programmed.push((index, programmed));
        }
        if let Some(rotary) = motion.rotary {
            self.rotary.push((index, rotary));
        }
        if let Some(change) = motion.lead_change {
            self.lead_changes.push((index, change));
        }
        if motion.start_angle != 0.0 {
            self.start_angles.push((index, motion.start_angle));
        }
        if let Some(step) = motion.cycle {
            self.rows[index as usize].cycle = pack_cycle(step);
        }
        if let Some(number) = motion.lead.or(motion.seconds).filter(|_| motion.center.is_none()) {
            if self.numbers.last() != Some(&number) {
                self.numbers.push(number);
            }
            self.rows[index as usize].detail = self.numbers.len() as u32 - 1;
        }
    }

    /// Adds a plain linear or circular move.
    #[inline]
    #[allow(clippy::too_many_arguments, reason = "the columns of a row")]
    pub fn push_move(
        &mut self,
        kind: MotionKind,
        from: Point,
        to: Point,
        center: Option<Point>,
        process: &Process,
        span: Span,
        line: u32,
    ) {
        self.begin_process(process);
        self.push_on(kind, from, to, center, span, line);
    }

    /// Sets feed, spindle and tool for the motions that are [pushed next](Chunk::push_on).
    pub fn begin_process(&mut self, process: &Process) {
        if self.processes.last() != Some(process) {
            self.processes.push(*process);
            self.is_moved |= process.zero != Point::default() || process.tip_shift != Point::default();
        }
    }

    /// Adds a move with the process that was set last.
    pub fn push_on(
        &mut self,
        kind: MotionKind,
        from: Point,
        to: Point,
        center: Option<Point>,
        span: Span,
        line: u32,
    ) {
        let index = self.kind.len();
        if from != self.end_before(index) {
            self.starts.push((index as u32, from));
        }
        self.kind.push(kind as u8);
        self.x.push(to.x);
        self.z.push(to.z);
        let place = self.place(span, line);
        if self.blocks.last() != Some(&place) {
            self.blocks.push(place);
        }
        let detail = match center {
            Some(center) => {
                self.centers.push(center);
                self.centers.len() as u32 - 1
            }
            None => NONE,
        };
        let (block, process) = (self.blocks.len() as u32 - 1, self.processes.len() as u32 - 1);
        self.rows.push(Row { block, cycle: 0, process, detail });
    }

    /// Reserves space for as many motions as another chunk has.
    pub fn reserve_as(&mut self, other: &Self) {
        // One block more, which may make several motions.
        let motions = other.len() + other.len() / 32;
        self.kind.reserve_exact(motions);
        self.x.reserve_exact(motions);
        self.z.reserve_exact(motions);
        self.rows.reserve_exact(motions);
        self.blocks.reserve_exact(other.blocks.len());
    }

    /// Records a work frame that is left before the first cut; the first cut determines the position of the
    /// workpiece.
    pub fn leave_frame(&mut self, left: LeftFrame) {
        let motions = self.kind.len();
        if motions > self.left.last().map_or(0, |before| before.0) {
            self.left.push((motions, left));
        }
    }

    /// Handles G50 X Z: the coordinates of the tip increase by `by`; neither the tip nor the workpiece moves.
    pub fn shift_coordinates(&mut self, by: Point) {
        for (_, left) in &mut self.left {
            left.offset = left.offset.moved(by.opposite());
        }
    }

    /// Places the motions in frames that were left before the first cut; the first cut determines the
    /// position of the workpiece. `zero` returns the zero of a frame on the workpiece, if it is known.
    #[cold]
    pub fn place_on_workpiece(&mut self, zero: impl Fn(LeftFrame) -> Option<Point>) {
        let current = self.processes.last().copied();
        let mut first = 0;
        for (end, left) in std::mem::take(&mut self.left) {
            let zero = zero(left);
            for index in first..end {
                let own = *self.own_process(index);
                let placed = Process {
                    zero: zero.unwrap_or_default(),
                    other_setup: own.other_setup || zero.is_none(),
                    ..own
                };
                if placed != own {
                    if self.processes.last() != Some(&placed) {
                        self.processes.push(placed);
                    }
                    self.rows[index].process = self.processes.len() as u32 - 1;
                    self.is_moved |= placed.zero != Point::default();
                }
            }
            first = end;
        }
        // The next motions belong to the process that was set last.
        self.processes.extend(current.filter(|own| self.processes.last() != Some(own)));
    }

    /// Records a stop before the motion that is pushed next.
    pub fn stop(&mut self, stop: &Stop) {
        let place = self.place(stop.span, stop.line);
        self.stops.push((self.kind.len() as u32, (stop.kind, place)));
    }

    /// The stops of the program, each with the index of the motion after it.
    pub fn stops(&self) -> impl Iterator<Item = (usize, Stop)> + '_ {
        self.stops.iter().map(|&(index, (kind, place))| {
            (index as usize, Stop { kind, span: self.span_of(place), line: self.line_of(place) })
        })
    }

    /// Whether two chunks have the same motions and stops, at any places in the text.
    fn has_same_motions(&self, other: &Self) -> bool {
        let kinds = |stops: &[(u32, (StopKind, BlockPlace))]| -> Vec<_> {
            stops.iter().map(|(index, (kind, _))| (*index, *kind)).collect()
        };
        let Self { kind, x, z, rows, processes, centers, numbers, .. } = self;
        let Self { start, starts, programmed, rotary, lead_changes, start_angles, stops, .. } = self;
        self.incomplete == other.incomplete
            && (start, starts, programmed, rotary)
                == (&other.start, &other.starts, &other.programmed, &other.rotary)
            && (lead_changes, start_angles) == (&other.lead_changes, &other.start_angles)
            && kinds(stops) == kinds(&other.stops)
            && (kind, x, z, rows) == (&other.kind, &other.x, &other.z, &other.rows)
            && (processes, centers, numbers) == (&other.processes, &other.centers, &other.numbers)
    }

    /// The motion at `index`.
    pub fn get(&self, index: usize) -> Motion {
        let kind = MotionKind::ALL[self.kind[index] as usize];
        let Row { cycle, detail, .. } = self.rows[index];
        let is_arc = matches!(kind, MotionKind::ArcClockwise | MotionKind::ArcCounterclockwise);
        let number = (detail != NONE && !is_arc).then(|| self.numbers[detail as usize]);
        Motion {
            kind,
            from: self.from(index),
            to: Point::new(self.x[index], self.z[index]),
            center: (is_arc && detail != NONE).then(|| self.centers[detail as usize]),
            lead: number.filter(|_| kind != MotionKind::Dwell),
            lead_change: look_up(&self.lead_changes, index),
            start_angle: look_up(&self.start_angles, index).unwrap_or(0.0),
            seconds: number.filter(|_| kind == MotionKind::Dwell),
            programmed: look_up(&self.programmed, index),
            rotary: look_up(&self.rotary, index),
            cycle: unpack_cycle(cycle),
            process: self.process(index),
        }
    }

    /// The motion at `index` in the coordinates of the workpiece.
    pub fn get_on_workpiece(&self, index: usize) -> Motion {
        self.get(index).on_workpiece()
    }

    /// The most frequently used properties of the motion at `index`.
    #[inline]
    pub fn glance(&self, index: usize) -> Glance {
        let process = self.own_process(index);
        Glance {
            kind: self.kind(index),
            from: self.from(index),
            to: Point::new(self.x[index], self.z[index]),
            is_of_cycle: unpack_cycle(self.rows[index].cycle).is_some(),
            station: process.tool.0,
            turn: process.turn,
        }
    }

    /// The kind of the motion at `index`.
    #[inline]
    pub fn kind(&self, index: usize) -> MotionKind {
        MotionKind::ALL[self.kind[index] as usize]
    }

    /// Whether the motion at `index` may be wrong; see [`Process::uncertain`].
    #[inline]
    pub fn is_uncertain(&self, index: usize) -> bool {
        self.own_process(index).uncertain
    }

    /// The end points, in workpiece coordinates, of a straight motion without C (the most frequent kind);
    /// faster than [`Chunk::get_on_workpiece`].
    #[inline]
    pub fn straight_on_workpiece(&self, index: usize) -> Option<(Point, Point)> {
        let straight = matches!(self.kind(index), MotionKind::Rapid | MotionKind::Feed | MotionKind::Thread);
        let plain = straight && look_up(&self.rotary, index).is_none();
        let (from, to) = plain.then(|| (self.from(index), Point::new(self.x[index], self.z[index])))?;
        Some(if self.is_moved {
            let Process { zero, tip_shift, .. } = self.own_process(index);
            let by = zero.moved(*tip_shift);
            (from.moved(by), to.moved(by))
        } else {
            (from, to)
        })
    }

    /// Bytes of the block that made the motion at `index`.
    pub fn span(&self, index: usize) -> Span {
        self.span_of(self.blocks[self.rows[index].block as usize])
    }

    /// Line (from 0) of the block that made the motion at `index`.
    pub fn line(&self, index: usize) -> u32 {
        self.line_of(self.blocks[self.rows[index].block as usize])
    }

    fn place(&self, span: Span, line: u32) -> BlockPlace {
        BlockPlace {
            start: span.start.wrapping_sub(self.base) as i32,
            len: span.len() as u32,
            line: line.wrapping_sub(self.first_line) as i32,
        }
    }

    fn span_of(&self, place: BlockPlace) -> Span {
        let start = self.base.wrapping_add(place.start as u32);
        Span { start, end: start + place.len }
    }

    fn line_of(&self, place: BlockPlace) -> u32 {
        self.first_line.wrapping_add(place.line as u32)
    }

    fn own_process(&self, index: usize) -> &Process {
        &self.processes[self.rows[index].process as usize]
    }

    fn process(&self, index: usize) -> Process {
        let own = *self.own_process(index);
        Process { incomplete: self.incomplete || own.incomplete, ..own }
    }

    fn from(&self, index: usize) -> Point {
        look_up(&self.starts, index).unwrap_or_else(|| self.end_before(index))
    }

    /// The end of the motion before `index`; for the first motion, the start of the chunk.
    #[inline]
    fn end_before(&self, index: usize) -> Point {
        match index {
            0 => self.start,
            _ => Point::new(self.x[index - 1], self.z[index - 1]),
        }
    }
}

/// The entry of a motion in a sparse table that is sorted by index.
fn look_up<T: Copy>(table: &[(u32, T)], index: usize) -> Option<T> {
    if table.is_empty() {
        return None;
    }
    table.binary_search_by_key(&(index as u32), |entry| entry.0).ok().map(|found| table[found].1)
}

/// All motions of a program, in order.
#[derive(Clone, Debug, Default)]
pub struct Motions {
    chunks: Vec<Chunk>,
    /// The id of each chunk, unique within this process.
    ids: Vec<u64>,
    /// Number of motions before each chunk.
    before: Vec<usize>,
    len: usize,
}

impl Motions {
    /// Number of motions.
    pub fn len(&self) -> usize {
        self.len
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.len == 0
    }

    /// Whether the chunks of both have the same motions and stops. Then these are all the same; otherwise they can be,
    /// in other chunks.
    pub fn has_same_chunks(&self, other: &Self) -> bool {
        self.before == other.before
            && self.chunks.iter().zip(&other.chunks).all(|(own, other)| own.has_same_motions(other))
    }

    /// The chunks, in order.
    pub fn chunks(&self) -> &[Chunk] {
        &self.chunks
    }

    /// The unique id of each chunk. A chunk keeps its id when an edit before it only shifts it, so results
    /// computed from its motions stay valid.
    pub fn ids(&self) -> &[u64] {
        &self.ids
    }

    /// Number of motions before each chunk.
    pub fn before(&self) -> &[usize] {
        &self.before
    }

    /// Adds a chunk at the end.
    pub fn push(&mut self, chunk: Chunk) {
        static NEXT: AtomicU64 = AtomicU64::new(0);
        if !chunk.is_empty() {
            self.push_known(chunk, NEXT.fetch_add(1, Ordering::Relaxed));
            heap::reserve_ahead();
        }
    }

    /// Removes and returns the chunks from index `chunks` on.
    pub fn split_off(&mut self, chunks: usize) -> Self {
        let mut rest = Self::default();
        self.len = self.before.get(chunks).copied().unwrap_or(self.len);
        self.before.truncate(chunks);
        for (chunk, id) in self.chunks.drain(chunks..).zip(self.ids.drain(chunks..)) {
            rest.push_known(chunk, id);
        }
        rest
    }

    /// Appends the chunks of another list and keeps their ids. `change` may adjust each chunk.
    pub fn append(&mut self, other: Self, mut change: impl FnMut(usize, &mut Chunk)) {
        for (index, (mut chunk, id)) in other.chunks.into_iter().zip(other.ids).enumerate() {
            change(index, &mut chunk);
            self.push_known(chunk, id);
        }
    }

    fn push_known(&mut self, chunk: Chunk, id: u64) {
        self.ids.push(id);
        self.before.push(self.len);
        self.len += chunk.len();
        self.chunks.push(chunk);
    }

    /// The motion at `index`, counted over all chunks.
    pub fn get(&self, index: usize) -> Motion {
        let (chunk, at) = self.locate(index);
        chunk.get(at)
    }

    /// The motion at `index` in the coordinates of the workpiece.
    pub fn get_on_workpiece(&self, index: usize) -> Motion {
        self.get(index).on_workpiece()
    }

    /// The most frequently used properties of the motion at `index`.
    pub fn glance(&self, index: usize) -> Glance {
        let (chunk, at) = self.locate(index);
        chunk.glance(at)
    }

    /// The kind of the motion at `index`.
    pub fn kind(&self, index: usize) -> MotionKind {
        let (chunk, at) = self.locate(index);
        chunk.kind(at)
    }

    /// Bytes of the block that made the motion at `index`.
    pub fn span(&self, index: usize) -> Span {
        let (chunk, at) = self.locate(index);
        chunk.span(at)
    }

    /// Line (from 0) of the block that made the motion at `index`.
    pub fn line(&self, index: usize) -> u32 {
        let (chunk, at) = self.locate(index);
        chunk.line(at)
    }

    /// The stops before the motions of a range, each with the index of the motion after it.
    pub fn stops(&self, range: Range<usize>) -> impl Iterator<Item = (usize, Stop)> + '_ {
        let first = self.before.partition_point(|&before| before <= range.start).saturating_sub(1);
        let chunks = self.chunks[first..].iter().zip(&self.before[first..]);
        chunks
            .take_while(move |(_, before)| **before < range.end)
            .flat_map(|(chunk, before)| chunk.stops().map(move |(index, stop)| (before + index, stop)))
            .filter(move |(index, _)| range.contains(index))
    }

    /// All motions in order.
    pub fn iter(&self) -> impl Iterator<Item = Motion> + '_ {
        self.chunks.iter().flat_map(|chunk| (0..chunk.len()).map(|index| chunk.get(index)))
    }

    /// All motions in order, in the coordinates of the workpiece.
    pub fn on_workpiece(&self) -> impl Iterator<Item = Motion> + '_ {
        self.iter().map(Motion::on_workpiece)
    }

    /// The settings of the tailstock quill, in order, including repeated ones.
    pub fn quills(&self) -> impl Iterator<Item = Quill> + '_ {
        self.chunks.iter().flat_map(|chunk| chunk.processes.iter().map(|process| process.quill))
    }

    /// The first motion after a block that could not be executed.
    pub fn first_incomplete(&self) -> Option<usize> {
        let found =
            self.chunks.iter().zip(&self.before).find(|(chunk, _)| {
                chunk.incomplete || chunk.processes.iter().any(|process| process.incomplete)
            });
        let (chunk, before) = found?;
        let own = |index: &usize| chunk.incomplete || chunk.own_process(*index).incomplete;
        Some(before + (0..chunk.len()).find(own)?)
    }

    /// The first cut that is [elsewhere](Process::other_setup), and the number of such cuts.
    pub fn cuts_elsewhere(&self) -> Option<(usize, usize)> {
        let mut first = None;
        let mut count = 0;
        for (chunk, before) in self.chunks.iter().zip(&self.before) {
            if chunk.processes.iter().any(|own| own.other_setup) {
                let cuts = |index: &usize| chunk.own_process(*index).other_setup && chunk.kind(*index).cuts();
                let mut cuts = (0..chunk.len()).filter(cuts);
                let own = cuts.next();
                first = first.or(own.map(|index| before + index));
                count += usize::from(own.is_some()) + cuts.count();
            }
        }
        first.map(|first| (first, count))
    }

    /// Number of uncertain cuts.
    pub fn uncertain_cuts(&self) -> usize {
        let chunks = self.chunks.iter().filter(|chunk| chunk.processes.iter().any(|own| own.uncertain));
        let cuts = |chunk: &Chunk, index: &usize| chunk.is_uncertain(*index) && chunk.kind(*index).cuts();
        chunks.map(|chunk| (0..chunk.len()).filter(|index| cuts(chunk, index)).count()).sum()
    }

    fn locate(&self, index: usize) -> (&Chunk, usize) {
        let chunk = self.before.partition_point(|&before| before <= index) - 1;
        (&self.chunks[chunk], index - self.before[chunk])
    }
}

/// Two lists are equal if they have the same motions of the same blocks; chunk ids are ignored.
impl PartialEq for Motions {
    fn eq(&self, other: &Self) -> bool {
        self.chunks == other.chunks
    }
}

const STEP_BITS: u32 = 5;
const CYCLE_BITS: u32 = 5;
const LARGEST_PASS: u32 = (1 << (32 - STEP_BITS - CYCLE_BITS)) - 1;

fn pack_cycle(step: CycleStep) -> u32 {
    step.cycle as u32
        | (step.step as u32) << CYCLE_BITS
        | step.pass.min(LARGEST_PASS) << (CYCLE_BITS + STEP_BITS)
}

fn unpack_cycle(packed: u32) -> Option<CycleStep> {
    let at = |shift: u32, bits: u32| (packed >> shift & ((1 << bits) - 1)) as usize;
    let cycle = Cycle::ALL[at(0, CYCLE_BITS).checked_sub(1)?];
    let step = Step::ALL[at(CYCLE_BITS, STEP_BITS).checked_sub(1)?];
    Some(CycleStep { cycle, pass: packed >> (CYCLE_BITS + STEP_BITS), step })
}
