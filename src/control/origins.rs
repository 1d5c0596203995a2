//! Which block set each part of the state: for explaining the state of the control.
//!
//! In: the state after each block, with the position of the block. Out: for each [`Modal`] and each macro
//! variable, the block that gave it its present value; and how a cycle read a block of its contour. A run
//! does not depend on it. The control knows only the trait [`OriginRecorder`], whose code is loaded after the
//! first picture; no query comes before that.

use std::collections::BTreeMap;
use std::fmt;
use std::sync::Arc;

use super::codes::{Compensation, MotionMode, Plane};
use super::contour::ContourUse;
use super::modal::{State, Target};
use crate::geometry::Point;
use crate::motion::SpindleTurn;
use crate::order;
use crate::setup::dialect::FeedMode;
use crate::source::shift::Shift;
use crate::text::block::Block;
use crate::text::parser::Resume;
use crate::units::Unit;

/// Records which blocks set the state, as the control carries them out. Blocks are identified by their first
/// byte.
pub trait OriginRecorder {
    /// A block was carried out.
    fn note(&mut self, state: &State, block: u32);
    /// A block has changed the code of group 01.
    fn note_motion(&mut self, mode: MotionMode, block: u32);
    /// A block assigns a variable. `level`: depth of macro calls.
    fn assigned(&mut self, level: usize, variable: u32, block: u32);
    /// A macro returned, and its variables are gone. `level`: the level of the macro.
    fn macro_returned(&mut self, level: usize);
    /// The blocks of a contour are read next.
    fn contour_begins(&mut self);
    /// The contour has been read, and the control is as it was before.
    fn contour_ends(&mut self);
    /// The next block of the contour is about to be read.
    fn before_reading(&mut self, at: Resume, state: &State);
    /// The block was read.
    fn after_reading(&mut self, block: &Block, state: &State, purpose: ContourUse);
    /// A new recorder for a control at power-on, which watches the same block.
    fn restarted(&self, state: &State) -> Box<dyn OriginRecorder>;
    /// A copy.
    fn clone_box(&self) -> Box<dyn OriginRecorder>;
    /// The record.
    fn record(&self) -> &OriginRecord;
    /// The record, mutable.
    fn record_mut(&mut self) -> &mut OriginRecord;
}

// Prints no content: that would pull in the code that prints a whole state.
impl fmt::Debug for dyn OriginRecorder {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Chronicler")
    }
}

impl Clone for Box<dyn OriginRecorder> {
    fn clone(&self) -> Self {
        self.clone_box()
    }
}

/// The record of a run.
#[derive(Clone, Debug)]
pub struct OriginRecord {
    /// Which block set each part of the state.
    pub origins: Origins,
    /// First byte of the watched block, whose readings are kept.
    watched: Option<u32>,
    /// State and origins before that block, while it is read.
    before: Option<Box<(State, Origins)>>,
    /// The readings of the watched block.
    readings: Vec<Reading>,
    /// The origins before each of the contours being read.
    outer_contours: Vec<Origins>,
}

/// A reading of a block as a part of a contour.
#[derive(Clone, Debug)]
pub struct Reading {
    /// Why the contour is read.
    pub purpose: ContourUse,
    /// State and origins before the block.
    pub before: (State, Origins),
    /// State and origins after the block.
    pub after: (State, Origins),
}

impl OriginRecord {
    /// An empty record for a control at power-on.
    pub fn new(state: &State) -> Self {
        Self {
            origins: Origins::new(state),
            watched: None,
            before: None,
            readings: Vec::new(),
            outer_contours: Vec::new(),
        }
    }

    /// Watches the block at `byte`: keeps each reading of it as a part of a contour from here on.
    pub fn watch(&mut self, byte: u32) {
        self.watched = Some(byte);
    }

    /// Takes the readings since the last call.
    pub fn take_readings(&mut self) -> Vec<Reading> {
        std::mem::take(&mut self.readings)
    }

    /// The record of a new run that met this old run at byte `met` of the old text and continues like it.
    /// Blocks after `met` come from this record, with shifted positions; earlier blocks come from
    /// `meeting`, the record of the new run at that point.
    pub fn merged_after(&self, met: u32, meeting: &Self, shift: &Shift) -> Self {
        Self { origins: self.origins.merged_after(met, &meeting.origins, shift), ..meeting.clone() }
    }
}

impl OriginRecorder for OriginRecord {
    fn note(&mut self, state: &State, block: u32) {
        self.origins.note(state, block);
    }

    fn note_motion(&mut self, mode: MotionMode, block: u32) {
        self.origins.note_motion(mode, block);
    }

    fn assigned(&mut self, level: usize, variable: u32, block: u32) {
        self.origins.assigned(level, variable, block);
    }

    fn macro_returned(&mut self, level: usize) {
        self.origins.macro_returned(level);
    }

    fn contour_begins(&mut self) {
        if self.watched.is_some() {
            self.outer_contours.push(self.origins.clone());
        }
    }

    fn contour_ends(&mut self) {
        if let Some(before) = self.outer_contours.pop() {
            self.origins = before;
        }
    }

    fn before_reading(&mut self, at: Resume, state: &State) {
        if self.watched == Some(at.byte) {
            self.before = Some(Box::new((state.clone(), self.origins.clone())));
        }
    }

    fn after_reading(&mut self, block: &Block, state: &State, purpose: ContourUse) {
        if self.watched.is_none() {
            return;
        }
        self.origins.note(state, block.span.start);
        // The F of roughing does not count for finishing, even if it has the same value.
        if purpose == ContourUse::Finishing
            && block.words.iter().any(|word| word.address == b'F' && !word.comma)
        {
            self.origins.since[Modal::Feed as usize] = block.span.start;
        }
        if let Some(before) = self.before.take() {
            let after = (state.clone(), self.origins.clone());
            self.readings.push(Reading { purpose, before: *before, after });
        }
    }

    fn restarted(&self, state: &State) -> Box<dyn OriginRecorder> {
        Box::new(Self { watched: self.watched, ..Self::new(state) })
    }

    fn clone_box(&self) -> Box<dyn OriginRecorder> {
        Box::new(self.clone())
    }

    fn record(&self) -> &OriginRecord {
        self
    }

    fn record_mut(&mut self) -> &mut OriginRecord {
        self
    }
}

/// Lists the modal settings once, for the enum and for [`Modal::ALL`].
macro_rules! modals {
    ($($(#[$doc:meta])* $name:ident)+) => {
        /// A setting that stays in force from block to block.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
        #[repr(u8)]
        pub enum Modal { $($(#[$doc])* $name),+ }

        impl Modal {
            /// All settings, in display order.
            pub const ALL: &[Self] = &[$(Self::$name),+];
        }
    };
}

modals! {
    /// Group 01.
    Motion
    /// Group 05.
    FeedMode
    /// F.
    Feed
    /// Group 02: whether S is a spindle speed or a cutting speed.
    SpeedMode
    /// S.
    Speed
    /// G50 S.
    HighestSpeed
    /// G50 Q.
    LowestSpeed
    /// M03, M04, M05.
    SpindleTurn
    /// M13, M14.
    LiveTool
    /// Turret station and offset number.
    Tool
    /// Group 07.
    Compensation
    /// Group 14: the work coordinate system.
    Frame
    /// The zero of the work coordinate system: G50, G52, G10.
    Zero
    /// Group 06.
    Unit
    /// Group 03 of systems B and C.
    Distance
    /// Group 16.
    Plane
    /// Group 21 and G07.1.
    Interpolation
    /// Group 10.
    Hole
    /// Group 11.
    HoleReturn
    /// Group 12: G66.
    ModalMacro
    /// M45, M46.
    CAxis
    /// M23, M24.
    ThreadPullOut
    /// X or U that a single cycle remembers.
    CycleX
    /// Z or W that a single cycle remembers.
    CycleZ
    /// R that a single cycle remembers.
    CycleTaper
    /// Depth of a pass of G71 and G72.
    Depth
    /// Escape of G71 and G72.
    Escape
    /// Relief of G73.
    Relief
    /// Passes of G73.
    PatternPasses
    /// Retract of G74 and G75.
    Retract
    /// Finishing passes of G76.
    ThreadFinishing
    /// Tool angle of G76.
    ThreadAngle
    /// Least depth of a pass of G76.
    ThreadLeast
    /// Finishing allowance of G76.
    ThreadAllowance
}

/// Number of settings.
const MODALS: usize = Modal::ThreadAllowance as usize + 1;

/// Not set by the program.
const NEVER: u32 = u32::MAX;

/// Which block set each part of the state; blocks by their first byte.
#[derive(Clone, Debug)]
pub struct Origins {
    /// The values after the last block, encoded for comparison only.
    values: [u64; MODALS],
    since: [u32; MODALS],
    /// By call level (0 in the main program and for common variables) and variable number.
    variables: Arc<BTreeMap<(u8, u32), u32>>,
}

impl Origins {
    /// At power-on.
    pub fn new(state: &State) -> Self {
        Self { values: values(state), since: [NEVER; MODALS], variables: Arc::default() }
    }

    /// A block was carried out. `block`: its first byte.
    #[inline]
    fn note(&mut self, state: &State, block: u32) {
        let values = values(state);
        // Compared pair by pair: comparing them as bytes is a call from this part into the main module.
        if values.iter().zip(&self.values).any(|(now, before)| now != before) {
            self.differ(values, block);
        }
    }

    #[cold]
    fn differ(&mut self, values: [u64; MODALS], block: u32) {
        for ((since, before), now) in self.since.iter_mut().zip(&self.values).zip(&values) {
            if before != now {
                *since = block;
            }
        }
        self.values = values;
    }

    /// A block has changed the code of group 01.
    fn note_motion(&mut self, mode: MotionMode, block: u32) {
        (self.values[Modal::Motion as usize], self.since[Modal::Motion as usize]) = (motion(mode), block);
    }

    /// A block assigns a variable. `level`: depth of macro calls.
    fn assigned(&mut self, level: usize, variable: u32, block: u32) {
        Arc::make_mut(&mut self.variables).insert(key(level, variable), block);
    }

    /// A macro returned, and its variables are gone. `level`: the level of the macro.
    fn macro_returned(&mut self, level: usize) {
        if !self.variables.is_empty() {
            Arc::make_mut(&mut self.variables).retain(|&(own, _), _| usize::from(own) < level);
        }
    }

    /// First byte of the block that set this; `None` if it is unchanged since power-on.
    pub fn since(&self, modal: Modal) -> Option<u32> {
        Some(self.since[modal as usize]).filter(|&since| since != NEVER)
    }

    /// First byte of the block that gave a variable its value.
    pub fn set_by(&self, level: usize, variable: u32) -> Option<u32> {
        self.variables.get(&key(level, variable)).copied()
    }

    /// The origins of a new run that met this old run at byte `met` of the old text and continues like it.
    /// Blocks after `met` come from these origins, with shifted positions; earlier blocks come from
    /// `meeting`, the origins of the new run at that point.
    fn merged_after(&self, met: u32, meeting: &Self, shift: &Shift) -> Self {
        let place = |old: u32, own: u32| if old != NEVER && old >= met { shift.byte(old) } else { own };
        let mut since = meeting.since;
        since.iter_mut().zip(&self.since).for_each(|(own, old)| *own = place(*old, *own));
        let own = |key| meeting.variables.get(key).copied().unwrap_or(NEVER);
        let variables = self.variables.iter().map(|(key, old)| (*key, place(*old, own(key))));
        let variables: BTreeMap<_, _> = order::gathered(variables);
        Self { values: self.values, since, variables: Arc::new(variables) }
    }
}

/// Key of a variable: local variables have the level of their macro.
fn key(level: usize, variable: u32) -> (u8, u32) {
    (if variable <= 33 { level as u8 } else { 0 }, variable)
}

/// The settings, each encoded as a number that differs for each value.
fn values(state: &State) -> [u64; MODALS] {
    let (spindle, cycle, multiple) = (&state.spindle, &state.memory, &state.parameters);
    let mut values = [0; MODALS];
    let mut set = |modal: Modal, value: u64| values[modal as usize] = value;
    set(Modal::Motion, motion(state.motion));
    set(Modal::FeedMode, u64::from(state.feed_mode == FeedMode::PerTurn));
    set(Modal::Feed, optional(state.feed.or(state.lead.map(|lead| -lead.mm()))));
    set(Modal::SpeedMode, u64::from(spindle.surface));
    set(Modal::Speed, if spindle.surface { spindle.cutting_speed } else { spindle.rpm }.to_bits());
    set(Modal::HighestSpeed, optional(spindle.highest));
    set(Modal::LowestSpeed, optional(spindle.lowest));
    set(
        Modal::SpindleTurn,
        match spindle.turn {
            SpindleTurn::Stopped => 0,
            SpindleTurn::Forward => 1,
            SpindleTurn::Reverse => 2,
        },
    );
    set(Modal::LiveTool, u64::from(spindle.live_tool));
    set(Modal::Tool, u64::from(state.tool.0) << 16 | u64::from(state.tool.1));
    set(
        Modal::Compensation,
        match state.compensation {
            Compensation::Off => 0,
            Compensation::Left => 1,
            Compensation::Right => 2,
        },
    );
    set(Modal::Frame, u64::from(state.frames.active));
    set(Modal::Zero, point(state.frames.offset()));
    set(Modal::Unit, u64::from(state.unit == Unit::Inch));
    set(Modal::Distance, u64::from(state.incremental));
    set(
        Modal::Plane,
        match state.plane {
            Plane::Xy => 0,
            Plane::Zx => 1,
            Plane::Yz => 2,
        },
    );
    set(Modal::Interpolation, u64::from(state.interpolation().is_some()));
    set(Modal::Hole, state.hole.map_or(0, |hole| 1 + hole.kind as u64));
    set(Modal::HoleReturn, state.hole_return as u64);
    set(Modal::ModalMacro, state.call_stack.modal.as_ref().map_or(0, |call| 1 + u64::from(call.head.byte)));
    set(Modal::CAxis, u64::from(state.c_axis));
    set(Modal::ThreadPullOut, u64::from(state.thread_chamfer_on));
    set(Modal::CycleX, target(cycle.x));
    set(Modal::CycleZ, target(cycle.z));
    set(Modal::CycleTaper, cycle.taper.to_bits());
    set(Modal::Depth, optional(multiple.depth));
    set(Modal::Escape, multiple.escape.to_bits());
    set(Modal::Relief, multiple.relief.map_or(u64::MAX, point));
    set(Modal::PatternPasses, optional(multiple.pattern_passes));
    set(Modal::Retract, multiple.retract.to_bits());
    set(Modal::ThreadFinishing, u64::from(multiple.finishing));
    set(Modal::ThreadAngle, multiple.angle.to_bits());
    set(Modal::ThreadLeast, multiple.least_amount.map_or(u64::MAX, |amount| amount.in_increments.to_bits()));
    set(Modal::ThreadAllowance, multiple.thread_allowance.to_bits());
    values
}

fn motion(mode: MotionMode) -> u64 {
    u64::from(mode.key())
}

fn optional(value: Option<f64>) -> u64 {
    value.map_or(u64::MAX, f64::to_bits)
}

/// Encodes a point; collisions are rare.
fn point(point: Point) -> u64 {
    point.x.to_bits().rotate_left(31) ^ point.z.to_bits()
}

fn target(target: Target) -> u64 {
    match target {
        Target::Stay => u64::MAX,
        Target::Absolute(place) => place.to_bits(),
        Target::Incremental(way) => way.to_bits().rotate_left(1) ^ 1,
    }
}
