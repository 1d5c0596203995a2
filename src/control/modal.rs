//! The state of the control: everything that outlives a block, as one plain value.
//!
//! It can be cloned and compared, so that a run after an edit can continue from a stored state, and stop
//! where the new state equals the old one.

use std::collections::BTreeMap;
use std::sync::Arc;

use super::codes::{Compensation, Hole, HoleReturn, MotionMode, Plane};
use super::compensation::Compensator;
use super::corners::{Corner, Letter};
use super::doubt::{Doubt, Doubts};
use super::macros::Variables;
use super::offsets::{Frames, ToolOffsets};
use super::program::CallStack;
use crate::cycles::units::Amount;
use crate::geometry::Point;
use crate::geometry::virtual_plane::Surface;
use crate::motion::{Feed, Motion, Process, Quill, SpindleSpeed, SpindleTurn, Stop, StopKind};
use crate::parts::Part;
use crate::setup::Setup;
use crate::setup::dialect::{Dialect, FeedMode};
use crate::source::Span;
use crate::source::shift::Shift;
use crate::text::parser::Resume;
use crate::units::{Diameter, Unit};

/// End of a cycle along one axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Target {
    /// The axis was not given: it does not move from the start of the cycle.
    Stay,
    /// Absolute, mm (radius for X) in the work frame.
    Absolute(f64),
    /// From the start point of the cycle, mm (radius for X).
    Incremental(f64),
}

impl Target {
    /// The coordinate of the target, for a start at `from`.
    pub fn from(self, from: f64) -> f64 {
        match self {
            Self::Stay => from,
            Self::Absolute(place) => place,
            Self::Incremental(way) => from + way,
        }
    }
}

/// Values that G90, G92 and G94 keep between blocks (seeds 000 and 001).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CycleMemory {
    /// X or U.
    pub x: Target,
    /// Z or W.
    pub z: Target,
    /// R: start of the cut minus its end, mm; a radius (G90, G92) or a length (G94).
    pub taper: f64,
    /// Passes run since the cycle came into force.
    pub passes: u32,
}

impl CycleMemory {
    /// Nothing remembered.
    pub const EMPTY: Self = Self { x: Target::Stay, z: Target::Stay, taper: 0.0, passes: 0 };
}

/// Values that the first blocks of the multiple cycles set, until they are set again (parameters 5132 to
/// 5143). The initial values are the defaults.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CycleParameters {
    /// Depth of a pass of G71 (radius) and G72 (length), mm.
    pub depth: Option<f64>,
    /// Escape of G71 and G72, mm.
    pub escape: f64,
    /// Total relief of G73: radius and length, mm.
    pub relief: Option<Point>,
    /// Passes of G73.
    pub pattern_passes: Option<f64>,
    /// Retract between the pecks of G74 and G75, mm.
    pub retract: f64,
    /// Finishing passes of G76.
    pub finishing: u32,
    /// Tool angle of G76, degrees.
    pub angle: f64,
    /// Q of the first block of G76; its unit is known only when the second block is read.
    pub least_amount: Option<Amount>,
    /// Finishing allowance of G76, mm.
    pub thread_allowance: f64,
}

impl CycleParameters {
    /// Before any first block.
    pub const INITIAL: Self = Self {
        depth: None,
        escape: 1.0,
        relief: None,
        pattern_passes: None,
        retract: 1.0,
        finishing: 1,
        angle: 0.0,
        least_amount: None,
        thread_allowance: 0.0,
    };
}

/// A motion and the block that made it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PathMove {
    /// The motion.
    pub motion: Motion,
    /// Its block.
    pub span: Span,
    /// The words of its block.
    pub words: Span,
    /// Line of its block, from 0.
    pub line: u32,
    /// In a virtual plane, which then contains the points of the motion: start and end along the third axis,
    /// mm. `None` in the turning plane.
    pub third: Option<(f64, f64)>,
    /// A program stop (M00, M01) instead of a motion.
    pub stop: Option<StopKind>,
    /// For the move of a G40 block: the direction of the wall given by I and K; radius and length in mm.
    pub wall: Option<Point>,
}

/// A plane other than the turning plane. The position of the state is then a point in this plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VirtualPlane {
    /// The plane.
    pub surface: Surface,
    /// Start and end of the last move along the axis that is not in the plane, mm: Z on the face, X as a
    /// radius on the cylinder, the perpendicular axis for a Y plane.
    pub third: (f64, f64),
    /// Angle of C after the last emitted move, degrees; not reduced to one turn.
    pub angle: f64,
}

/// An angle word.
#[derive(Clone, Debug, PartialEq)]
pub struct Angle {
    /// The angle, radians, counter-clockwise from +Z.
    pub radians: f64,
    /// The span of the word.
    pub span: Span,
    /// The text of the word.
    pub word: String,
}

/// A chamfer or rounding word.
#[derive(Clone, Debug, PartialEq)]
pub struct Joint {
    /// Chamfer or rounding that replaces the corner.
    pub corner: Corner,
    /// For a form without comma: its letter, whose sign and axis have a meaning, and its value, mm.
    pub signed: Option<(Letter, f64)>,
    /// Which moves may follow.
    pub before: Follower,
    /// The span of the word.
    pub span: Span,
    /// The text of the word.
    pub word: String,
}

/// The moves that may form a corner with the one before (GSK980TDi p. 96, GSK980TDb p. 78).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Follower {
    /// Only G01: FANUC.
    Line,
    /// G01, G02, G03: L and D of GSK.
    LineOrArc,
}

/// A move that cannot be made before the next one is known.
#[derive(Clone, Debug, PartialEq)]
pub struct Pending {
    /// The move, up to the virtual corner.
    pub path_move: PathMove,
    /// The chamfer or rounding between it and the next move.
    pub joint: Option<Joint>,
    /// Its angle, while its end point is open.
    pub angle: Option<Angle>,
    /// The previous move, whose corner waits for the end of this open angle.
    pub before: Option<Box<Pending>>,
    /// Dwells at its end.
    pub dwells: Vec<PathMove>,
}

/// Active nose radius compensation, with the moves it holds back.
#[derive(Clone, Debug, PartialEq)]
pub struct Compensating {
    /// The geometry.
    pub compensator: Compensator,
    /// The moves that it may still emit, by number.
    pub waiting: Vec<(u32, PathMove)>,
    /// The dwells, each after the move of this number.
    pub dwells: Vec<(u32, PathMove)>,
    /// At most one move has been taken in.
    pub is_new: bool,
    /// Blocks without a move since the last one.
    pub idle_blocks: u32,
}

impl PathMove {
    fn shift(&mut self, shift: &Shift) {
        self.line = shift.line(self.line, self.span.start);
        self.span = shift.span(self.span);
        self.words = shift.span(self.words);
    }
}

impl Pending {
    /// First byte of the blocks it is made of.
    fn first(&self) -> u32 {
        let before = self.before.as_ref().map_or(u32::MAX, |before| before.first());
        before.min(self.path_move.span.start)
    }

    fn shift(&mut self, shift: &Shift) {
        self.path_move.shift(shift);
        let spans = self.joint.as_mut().map(|joint| &mut joint.span).into_iter();
        for span in spans.chain(self.angle.as_mut().map(|angle| &mut angle.span)) {
            *span = shift.span(*span);
        }
        if let Some(before) = &mut self.before {
            before.shift(shift);
        }
        self.dwells.iter_mut().for_each(|dwell| dwell.shift(shift));
    }
}

impl Compensating {
    /// First byte of the blocks whose moves it holds back.
    fn first(&self) -> u32 {
        let held = self.waiting.iter().chain(&self.dwells);
        held.map(|(_, path_move)| path_move.span.start).min().unwrap_or(u32::MAX)
    }

    fn shift(&mut self, shift: &Shift) {
        for (_, path_move) in self.waiting.iter_mut().chain(&mut self.dwells) {
            path_move.shift(shift);
        }
    }

    /// Whether both continue in the same way; the number of moves already taken in does not matter.
    fn continues_like(&self, other: &Self) -> bool {
        let counted = |state: &Self| {
            let first = state.waiting.first().map_or(0, |(id, _)| *id);
            let from_first = |held: &Vec<(u32, PathMove)>| {
                held.iter().map(|&(id, path_move)| (id.wrapping_sub(first), path_move)).collect()
            };
            Self {
                compensator: state.compensator.clone().counted_from(first),
                waiting: from_first(&state.waiting),
                dwells: from_first(&state.dwells),
                ..*state
            }
        };
        counted(self) == counted(other)
    }
}

/// A lead that F does not give.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Lead {
    /// I of G32 and G92 on GSK: threads per inch.
    ThreadsPerInch(f64),
    /// E: mm.
    ByE(f64),
}

impl Lead {
    /// In mm.
    pub fn mm(self) -> f64 {
        match self {
            Self::ThreadsPerInch(threads) => 25.4 / threads,
            Self::ByE(lead) => lead,
        }
    }
}

/// The spindle as commanded.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spindle {
    /// Whether S is a cutting speed (G96).
    pub surface: bool,
    /// Speed under G97, rpm; 0 before any S.
    pub rpm: f64,
    /// Cutting speed under G96, m/min.
    pub cutting_speed: f64,
    /// Highest speed (G50 S), rpm.
    pub highest: Option<f64>,
    /// Lowest speed (G50 Q), rpm.
    pub lowest: Option<f64>,
    /// Direction.
    pub turn: SpindleTurn,
    /// S0 was given: the spindle does not turn under M03 either.
    pub zero_speed: bool,
    /// M05 stopped it after M03 or M04.
    pub is_stopped: bool,
    /// A machine-specific M code has run since M05: it may turn a spindle or a tool.
    pub may_turn: bool,
    /// M19 holds it at an angle until M03, M04 or M05.
    pub is_held: bool,
    /// A live tool turns.
    pub live_tool: bool,
    /// A machine-specific M code with S or P has run since M05: it may turn this spindle, another one or a
    /// tool.
    pub machine_code_with_speed: bool,
}

impl Spindle {
    /// Whether M05 or M19 stopped it, and no tool is known to turn.
    fn is_still(&self) -> bool {
        let is_stopped = self.is_stopped || self.is_held && self.turn != SpindleTurn::Stopped;
        is_stopped && !self.live_tool && !self.may_turn
    }

    /// Speed with the tip at radius `x`, at most the machine's maximum `most`, rpm. `None` at the axis
    /// without any limit.
    pub fn speed_within(&self, x: f64, most: Option<f64>) -> Option<f64> {
        self.speed_at(x).map(|speed| most.map_or(speed, |most| speed.min(most))).or(most)
    }

    /// Speed with the tip at radius `x`, rpm: `n = 1000·v / (π·D)` under G96, within the limits of
    /// G50 (FANUC 16/18-T B-62754EN p. 127). `None` at the axis without a limit.
    pub fn speed_at(&self, x: f64) -> Option<f64> {
        if !self.surface {
            return Some(self.rpm);
        }
        if self.cutting_speed <= 0.0 {
            return Some(0.0);
        }
        let diameter = Diameter::from_radius(x.abs()).mm();
        let free = 1000.0 * self.cutting_speed / (std::f64::consts::PI * diameter);
        // If the limits are reversed, the highest speed wins.
        let fast = self.lowest.map_or(free, |lowest| free.max(lowest));
        let held = self.highest.map_or(fast, |highest| fast.min(highest));
        held.is_finite().then_some(held)
    }
}

/// Values that a hole cycle keeps from block to block.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HoleMemory {
    /// The cycle.
    pub kind: Hole,
    /// Position of the tool when the first hole cycle came into force: its level is the initial level.
    pub level: Point,
    /// Group 01 in force before.
    pub before: MotionMode,
    /// R, mm.
    pub r: Option<f64>,
    /// The bottom; an incremental value is measured from the R point.
    pub depth: Target,
    /// Depth of a peck, mm.
    pub peck: Option<f64>,
    /// Wait at the bottom, seconds.
    pub dwell: f64,
}

impl HoleMemory {
    /// An empty memory.
    pub fn at(kind: Hole, level: Point, before: MotionMode) -> Self {
        Self { kind, level, before, r: None, depth: Target::Stay, peck: None, dwell: 0.0 }
    }
}

/// Messages already reported that appear once per program, not at every block.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Reported(u16);

/// A message that appears once.
#[derive(Clone, Copy, Debug)]
#[allow(missing_docs, reason = "each is one message")]
pub enum Once {
    NoFeed,
    FeedZero,
    HoleInForce,
    AxisNotHere,
    MachineZero,
    PlaneNotHere,
    PlaneRapid,
    G28NoAxis,
    SecondAxisY,
    AxisA,
    AxisB,
}

impl Reported {
    /// Marks it as reported. Returns whether it was not reported before, so that it must be reported now.
    pub fn mark_reported(&mut self, once: Once) -> bool {
        let bit = 1 << once as u64;
        let first = self.0 & bit == 0;
        self.0 |= bit;
        first
    }

    /// Allows another report.
    pub fn reset(&mut self, once: Once) {
        self.0 &= !(1 << once as u64);
    }
}

/// The state of the control between two blocks.
#[derive(Clone, Debug, PartialEq)]
pub struct State {
    /// Position of the tip in the work frame in force.
    pub position: Point,
    /// Where the next motion starts, if that is not the programmed point: compensation has just left the tip
    /// beside it, or another tool offset is in force.
    pub tip: Option<Point>,
    /// Angle of C, degrees, outside a virtual plane.
    pub c: f64,
    /// Position of the tip along Y, mm, outside the plane of X and Z.
    pub y: f64,
    /// Polar or cylindrical interpolation; or a Y plane, while a block moves or a move waits in it.
    pub virtual_plane: Option<VirtualPlane>,
    /// Work zero points.
    pub frames: Frames,
    /// The tool offsets that the program wrote.
    pub offsets: ToolOffsets,
    /// Position of the tip minus the programmed position, as [`Process::tip_shift`].
    pub tip_shift: Point,
    /// Intermediate point of the last G28 or G30.
    pub intermediate: Option<Point>,
    /// Group 01.
    pub motion: MotionMode,
    /// Group 10: the hole cycle in force.
    pub hole: Option<HoleMemory>,
    /// Group 11 of systems B and C.
    pub hole_return: HoleReturn,
    /// Group 03 of systems B and C: G91.
    pub incremental: bool,
    /// Group 16.
    pub plane: Plane,
    /// Group 06.
    pub unit: Unit,
    /// Group 05.
    pub feed_mode: FeedMode,
    /// F, mm/min or mm/rev, as it was written.
    pub feed: Option<f64>,
    /// The lead of threads, if it is not F; until the next F.
    pub lead: Option<Lead>,
    /// Group 02 and the M codes of the spindle.
    pub spindle: Spindle,
    /// Group 07.
    pub compensation: Compensation,
    /// Turret station and offset number.
    pub tool: (u16, u16),
    /// A T word of three digits or more was read: shorter ones are offsets.
    pub has_long_tools: bool,
    /// Position of the tailstock quill (M25, M26).
    pub quill: Quill,
    /// A move that waits for the next one.
    pub pending: Option<Pending>,
    /// Active compensation.
    pub compensating: Option<Compensating>,
    /// The program stops here, before the next motion.
    pub stop: Option<Stop>,
    /// Whether a C word is an axis (M45) rather than a chamfer.
    pub c_axis: bool,
    /// Memory of the single cycles.
    pub memory: CycleMemory,
    /// Memory of the multiple cycles.
    pub parameters: CycleParameters,
    /// Thread pull-out, tenths of a lead (parameter 5130).
    pub thread_chamfer: u8,
    /// Whether thread pull-out is on (M23, M24).
    pub thread_chamfer_on: bool,
    /// Active calls and loops.
    pub call_stack: CallStack,
    /// Macro variables.
    pub variables: Variables,
    /// System variables that are stored without further meaning.
    pub system: Arc<BTreeMap<u32, f64>>,
    /// The last sequence number.
    pub sequence: u32,
    /// The last M code.
    pub m_code: u32,
    /// Blocks are data for the control's tables (G10 L3, L50), up to G11.
    pub data_input: bool,
    /// The parts of this state that may be wrong.
    pub doubts: Doubts,
    /// A block was not carried out: material may remain that the program removes.
    pub incomplete: bool,
    /// Messages that were reported once.
    pub reported: Reported,
}

/// The part of the module that can assign variables.
pub const MACROS: Part = Part::Early;

impl State {
    /// The state at power-on with the tip at the setup's start point.
    pub fn new(setup: &Setup, dialect: &Dialect) -> Self {
        let start = setup.start();
        Self {
            position: Point::new(start.x.radius(), start.z),
            tip: None,
            c: 0.0,
            y: 0.0,
            virtual_plane: None,
            frames: Frames::default(),
            offsets: ToolOffsets::default(),
            tip_shift: Point::default(),
            intermediate: None,
            motion: MotionMode::Rapid,
            hole: None,
            hole_return: HoleReturn::Initial,
            incremental: false,
            plane: Plane::Zx,
            unit: dialect.unit,
            feed_mode: dialect.feed_mode,
            feed: None,
            lead: None,
            spindle: Spindle {
                surface: false,
                rpm: 0.0,
                cutting_speed: 0.0,
                highest: None,
                lowest: None,
                turn: SpindleTurn::Stopped,
                zero_speed: false,
                is_stopped: false,
                may_turn: false,
                is_held: false,
                live_tool: false,
                machine_code_with_speed: false,
            },
            compensation: Compensation::Off,
            tool: (0, 0),
            has_long_tools: false,
            quill: Quill::Unknown,
            pending: None,
            compensating: None,
            stop: None,
            c_axis: false,
            memory: CycleMemory::EMPTY,
            parameters: CycleParameters::INITIAL,
            thread_chamfer: dialect.thread_chamfer,
            thread_chamfer_on: true,
            call_stack: CallStack::default(),
            variables: Variables::default(),
            system: Arc::default(),
            sequence: 0,
            m_code: 0,
            data_input: false,
            doubts: Doubts::default(),
            incomplete: false,
            reported: Reported::default(),
        }
    }

    /// Polar or cylindrical interpolation in force.
    pub fn interpolation(&self) -> Option<&VirtualPlane> {
        self.virtual_plane.as_ref().filter(|plane| !matches!(plane.surface, Surface::Flat(_)))
    }

    /// X (as a radius) and Z of the programmed position, in any plane. Under G12.1 X is the programmed
    /// coordinate of the virtual plane, not the distance from the axis.
    pub fn turning_place(&self) -> Point {
        match self.virtual_plane {
            Some(VirtualPlane { surface: Surface::Face, third, .. }) => Point::new(self.position.z, third.1),
            Some(VirtualPlane { surface, third, .. }) => surface.machine(self.position, third.1),
            None => self.position,
        }
    }

    /// C of the programmed position, in the unit of the program: degrees, but mm under G12.1.
    pub fn place_of_c(&self) -> f64 {
        match self.virtual_plane.map(|plane| plane.surface) {
            Some(Surface::Face) => self.position.x,
            Some(Surface::Cylinder { radius, .. }) => (self.position.x / radius).to_degrees(),
            Some(Surface::Flat(_)) | None => self.c,
        }
    }

    /// Position of the tip along Y, mm, even if Y is in the plane of the path.
    pub fn place_along_y(&self) -> f64 {
        match self.virtual_plane {
            Some(VirtualPlane { surface: Surface::Flat(flat), third, .. }) => {
                flat.space(self.position, third.1).y
            }
            _ => self.y,
        }
    }

    /// First byte of the blocks whose moves wait for the next one; `u32::MAX` if there are none.
    pub fn first_waiting(&self) -> u32 {
        let pending = self.pending.as_ref().map_or(u32::MAX, Pending::first);
        let compensating = self.compensating.as_ref().map_or(u32::MAX, Compensating::first);
        let stop = self.stop.map_or(u32::MAX, |stop| stop.span.start);
        pending.min(compensating).min(stop)
    }

    /// Moves the spans it holds after a change of the text before them. Active calls and loops are not moved.
    pub fn shift(&mut self, shift: &Shift) {
        if let Some(pending) = &mut self.pending {
            pending.shift(shift);
        }
        if let Some(compensating) = &mut self.compensating {
            compensating.shift(shift);
        }
        if let Some(stop) = &mut self.stop {
            stop.shift(shift);
        }
        // The head of a program without an O number is the first byte of the text, even after an insertion
        // there.
        if self.call_stack.head != Resume::default() {
            self.call_stack.head = self.call_stack.head.shifted(shift);
        }
        self.call_stack.main_pass.shift(|byte| shift.byte(byte));
    }

    /// Whether a program continues from this state as it does from `other`.
    pub fn continues_like(&self, other: &Self) -> bool {
        let same = match (&self.compensating, &other.compensating) {
            (Some(own), Some(others)) => own.continues_like(others),
            (own, others) => own.is_none() && others.is_none(),
        };
        let rest = |state: &Self| Self { compensating: None, ..state.clone() };
        // Positive and negative zero compare as equal, but a motion would begin at the other one.
        let signs = |state: &Self| {
            let places = [Some(state.position), state.tip].map(Option::unwrap_or_default);
            places.map(|at| (at.x.is_sign_negative(), at.z.is_sign_negative()))
        };
        same && signs(self) == signs(other)
            && if self.compensating.is_none() { self == other } else { rest(self) == rest(other) }
    }

    /// G50 X Z: adds `by` to the coordinates of the tip.
    pub fn shift_coordinates(&mut self, by: Point) {
        self.frames.shift_coordinates(by);
        for place in std::iter::once(&mut self.position).chain(self.tip.as_mut()) {
            *place = place.moved(by);
        }
    }

    /// Changes the frame without moving the machine: updates the tip's coordinates.
    pub fn change_frame(&mut self, change: impl FnOnce(&mut Frames)) {
        let before = self.frames.offset();
        change(&mut self.frames);
        self.frames.update_workpiece_zero();
        let after = self.frames.offset();
        for place in std::iter::once(&mut self.position).chain(self.tip.as_mut()) {
            place.x += before.x - after.x;
            place.z += before.z - after.z;
        }
    }

    /// Puts a tool offset in force. The tip does not move: the next motion starts where it is.
    pub fn set_tip_shift(&mut self, shift: Point) {
        let before = std::mem::replace(&mut self.tip_shift, shift);
        let by = Point::new(before.x - shift.x, before.z - shift.z);
        let start = self.tip.unwrap_or(self.position).moved(by);
        self.tip = (!start.is_same(self.position)).then_some(start);
    }

    /// Whether the next motion may differ from the motion that this state gives.
    #[cold]
    pub fn is_path_doubtful(&self) -> bool {
        const PATH: Doubts = Doubts::of(&[Doubt::X, Doubt::Z, Doubt::Y, Doubt::Path, Doubt::Coordinates]);
        self.doubts.has_any(PATH) || (self.virtual_plane.is_some() && self.doubts.has(Doubt::C))
    }

    /// Feed, spindle and tool for a motion.
    pub fn process(&self) -> Process {
        let spindle = &self.spindle;
        Process {
            feed: match (self.feed, self.feed_mode) {
                (None, _) => Feed::Unset,
                (Some(feed), FeedMode::PerMinute) => Feed::PerMinute(feed),
                (Some(feed), FeedMode::PerTurn) => Feed::PerTurn(feed),
            },
            speed: match spindle.surface {
                true => SpindleSpeed::Surface { speed: spindle.cutting_speed },
                false => SpindleSpeed::Constant(spindle.rpm),
            },
            turn: if spindle.is_held { SpindleTurn::Stopped } else { spindle.turn },
            clamp: spindle.highest,
            lowest: spindle.lowest,
            tool: self.tool,
            quill: self.quill,
            uncertain: !self.doubts.is_empty() && self.is_path_doubtful(),
            incomplete: self.incomplete,
            other_setup: self.frames.has_unknown_workpiece_position(),
            still: spindle.is_still() && !self.c_axis && self.virtual_plane.is_none(),
            frame: self.frames.active,
            zero: self.frames.on_workpiece(),
            tip_shift: self.tip_shift,
        }
    }
}
