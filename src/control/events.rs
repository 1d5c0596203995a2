//! What happens while a program runs, as events for an observer: the lints.
//!
//! In: the interpreter announces each action when it performs it. Out: the diagnostics of the observer. The
//! observer is stored with the state of the control: a snapshot contains both. The control does not use the
//! observer's own state. A run without an observer makes no events.

use std::any::Any;
use std::fmt;
use std::ops::Range;

use super::codes::{M, MotionMode, Multiple};
use super::contour::{ContourUse, FirstBlock, Landmarks};
use super::modal::{State, VirtualPlane};
use super::sink::Sink;
use super::tool_offset;
use super::words::{Reading, Words};
use crate::cycles::Contour;
use crate::cycles::pattern::Pattern;
use crate::cycles::roughing::Roughing;
use crate::cycles::single::Single;
use crate::cycles::threading::MultiThread;
use crate::geometry::Point;
use crate::message::Diagnostic;
use crate::motion::Motion;
use crate::setup::dialect::{Dialect, FeedMode};
use crate::setup::{Blank, Setup, Stock};
use crate::source::Span;
use crate::source::shift::Shift;
use crate::text::block::{Block, Word};

/// The context of an event.
pub struct EventContext<'a> {
    /// The program. May be empty for an event without a [`Word`] or [`Words`].
    pub text: &'a [u8],
    /// The state of the control.
    pub state: &'a State,
    /// The setup of the run.
    pub setup: &'a Setup,
    /// The switches of the control.
    pub dialect: &'a Dialect,
    /// Motions and messages of the run up to now.
    pub sink: &'a Sink,
    /// Why a cycle is reading the current block as part of its contour; `None` outside contours.
    pub contour: Option<ContourUse>,
}

impl EventContext<'_> {
    /// How numbers are read at present.
    pub fn reading(&self) -> Reading {
        Reading { unit: self.state.unit, decimal: self.dialect.decimal }
    }

    /// The extents of the blank in the coordinates in force; `None` if it is not given, or if its position in
    /// them is unknown.
    pub fn stock(&self) -> Option<Stock> {
        let frames = &self.state.frames;
        let stock = self.setup.extents().filter(|_| !frames.has_unknown_workpiece_position())?;
        Some(stock.moved(frames.on_workpiece().opposite()))
    }

    /// The blank in the coordinates in force, if it is a bar or a tube: its diameter is the same all along.
    pub fn bar(&self) -> Option<Stock> {
        self.stock().filter(|_| self.setup.stock.as_ref().is_some_and(Blank::is_bar))
    }

    /// The motions with a known position on the workpiece, in the coordinates in force.
    pub fn motions(&self) -> impl Iterator<Item = Motion> + '_ {
        let here = self.state.frames.on_workpiece().opposite();
        let known = self.sink.all_motions().filter(|motion| !motion.process.other_setup);
        known.map(move |mut motion| {
            motion.process.zero = motion.process.zero.moved(here);
            motion.on_workpiece()
        })
    }

    /// Spindle speed with the tip at a radius in mm, in rpm, at most the machine's maximum. `None` at the
    /// axis without a limit.
    pub fn spindle_speed(&self, radius: f64) -> Option<f64> {
        self.state.spindle.speed_within(radius, self.setup.machine.max_speed)
    }

    /// Radius of the tool nose in force, mm; negative if the offset reverses the side of compensation.
    pub fn nose_radius(&self) -> f64 {
        tool_offset::nose_entry(self.state, self.setup).0
    }

    /// Direction of the imaginary tool tip in force, 0 to 9.
    pub fn tip_direction(&self) -> u8 {
        tool_offset::nose_entry(self.state, self.setup).1
    }
}

/// A pass of G90, G92 or G94 that is about to be cut. Lengths in mm, X as a radius.
#[derive(Clone, Copy)]
pub struct SinglePass<'a> {
    /// The block.
    pub block: &'a Block,
    /// Its words.
    pub words: &'a Words<'a>,
    /// The cycle.
    pub cycle: Single,
    /// Start point of the cycle.
    pub start: Point,
    /// End point of the cut.
    pub end: Point,
    /// The address of the taper word in this block, if any.
    pub taper_word: Option<u8>,
    /// Span of that word; of the block if the taper comes from an earlier block.
    pub taper_span: Span,
    /// Lead of a thread.
    pub lead: Option<f64>,
    /// Starts of a thread.
    pub starts: u64,
}

impl<'a> SinglePass<'a> {
    /// The thread pass; `None` for G90 and G94.
    pub fn thread(&self, at: &EventContext) -> Option<ThreadPass<'a>> {
        let &Self { block, words, start, end, starts, .. } = self;
        let start = Point::new(end.x + at.state.memory.taper, start.z);
        let by = ThreadSource::Pass { outwards: self.start.x < end.x };
        self.lead.map(|lead| ThreadPass { block, words, start, end, lead, starts, by })
    }
}

/// A cut along a thread. Lengths in mm, X as a radius.
#[derive(Clone, Copy)]
pub struct ThreadPass<'a> {
    /// The block.
    pub block: &'a Block,
    /// Its words.
    pub words: &'a Words<'a>,
    /// Start of the cut.
    pub start: Point,
    /// End of the cut.
    pub end: Point,
    /// Lead of the thread.
    pub lead: f64,
    /// Starts of the thread.
    pub starts: u64,
    /// What cuts the thread.
    pub by: ThreadSource,
}

/// What cuts a thread.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ThreadSource {
    /// A move (G32 to G34).
    Move,
    /// A pass of G92.
    Pass {
        /// Whether it cuts away from the spindle axis, as in a bore: a larger X is deeper.
        outwards: bool,
    },
    /// G76: all of its passes.
    Passes,
}

/// A move with nose radius compensation.
#[derive(Clone, Copy)]
pub struct CompensatedMove<'a> {
    /// The previous move, if compensation was already active.
    pub before: Option<&'a Motion>,
    /// The move as it is programmed.
    pub motion: &'a Motion,
    /// Whether compensation begins or ends with this move.
    pub begins_or_ends: bool,
    /// The words of its block.
    pub words: Span,
    /// Its block.
    pub span: Span,
}

/// A cycle that reads a contour, with that contour.
#[derive(Clone, Copy)]
pub struct ContourCall<'a, Parameters> {
    /// The cycle block.
    pub block: &'a Block,
    /// Its words.
    pub words: &'a Words<'a>,
    /// The contour.
    pub contour: &'a Contour,
    /// Contents of the first block of the contour.
    pub first: FirstBlock,
    /// Span of the first block of the contour.
    pub first_span: Span,
    /// Span of its last block with a move.
    pub last_span: Option<Span>,
    /// The parameters of the cycle.
    pub how: &'a Parameters,
}

/// G70, with its contour.
#[derive(Clone, Copy)]
pub struct FinishingCall<'a> {
    /// The cycle block.
    pub block: &'a Block,
    /// The contour cycles that the run has called; the last one is this G70.
    pub landmarks: &'a [Landmarks],
    /// Ends of the moves along the contour.
    pub ends: &'a [Point],
    /// Whether the last move of the contour is a rapid.
    pub leaves_at_rapid: bool,
}

/// The second block of G76. Lengths in mm, X as a radius.
#[derive(Clone, Copy)]
pub struct ThreadingCall<'a> {
    /// The cycle block.
    pub block: &'a Block,
    /// Its words.
    pub words: &'a Words<'a>,
    /// Where the cycle starts.
    pub start: Point,
    /// The parameters of the cycle.
    pub how: &'a MultiThread,
    /// Lead of the thread.
    pub lead: f64,
    /// Angle of the tool, degrees.
    pub angle: f64,
    /// Whether it is the one-block form of G76.
    pub one_block: bool,
}

/// Something that happens. Where a code or word changes the state, the event is sent before the change,
/// unless its comment says otherwise.
#[derive(Clone, Copy)]
#[allow(missing_docs, reason = "the comment of an event describes its fields")]
pub enum Event<'a> {
    /// G98 or G99 (G94 or G95 of the other systems).
    FeedMode(FeedMode),
    /// G40, G41 or G42.
    Compensation,
    /// A code of group 01 other than a cycle comes into force. `mode`: the new code, which differs from the
    /// previous one.
    MotionCode { mode: MotionMode },
    /// The code of a single cycle comes into force, possibly again.
    CycleCode { cycle: Single, block: &'a Block, words: &'a Words<'a> },
    /// A one-shot code other than a dwell. Sent after the values of single cycles were cleared.
    OneShot,
    /// G27, G28, G30 or G53 with a word of X or Z: a move to a machine position. G28 and G30 also send
    /// `Home`, after this event.
    MachinePlace { block: &'a Block },
    /// G28 or G30 is carried out, with or without a word of an axis.
    Home,
    /// An M code. `known`: its meaning; `None` if it has no known meaning.
    MCode { number: u64, known: Option<M>, word: &'a Word },
    /// F, in a block without a macro call.
    Feed,
    /// S outside of G50.
    SpindleSpeed { value: f64, word: &'a Word },
    /// G96 (`surface`) or G97.
    SpeedMode { surface: bool, block: &'a Block, words: &'a Words<'a> },
    /// G50 S.
    HighestSpeed { word: &'a Word },
    /// T, sent after the change. `before`: station and offset before it; `goes_home`: the block also goes to
    /// the reference point (G28, G30).
    Tool { word: &'a Word, before: (u16, u16), goes_home: bool },
    /// M05 takes effect. `moved`: the block also has a move.
    SpindleStops { block: &'a Block, moved: bool },
    /// A cut at a feed rate greater than zero begins. Sent only if an event since the previous cut matters
    /// for cuts ([`Event::matters_for_cuts`]). `feed`: the F in force.
    Cut { block: &'a Block, words: &'a Words<'a>, feed: f64 },
    /// A cut begins before any F.
    CutWithoutFeed { block: &'a Block },
    /// A move at rapid.
    Rapid,
    /// A block has words that the control ignores; `unread` contains their letters. `code`: the code of the
    /// block, which does not read them; `None` if the block has no such code.
    UnreadWords { block: &'a Block, words: &'a Words<'a>, unread: u32, code: Option<&'static str> },
    /// G04 waits.
    Dwell { words: &'a Words<'a>, seconds: f64 },
    /// A word is ignored because its variable is vacant.
    VacantWord { word: &'a Word },
    /// A loop begins (`enter`), or is skipped because the condition of its WHILE is false.
    While { statement: Span, enter: bool },
    /// A move in a straight line at feed while compensation is on. `to`: its end, in mm, X as a radius.
    CompensatedLine { block: &'a Block, to: Point },
    /// A straight move, at rapid or feed, that starts on the spindle axis, as a drill or tap does. `to`: its
    /// end, in mm, X as a radius.
    FromAxis { block: &'a Block, to: Point },
    /// The F in force is used as the lead of a thread. `feed`: this lead, in mm.
    LeadOfFeed { block: &'a Block, code: &'static str, feed: f64 },
    /// A thread begins. `to`: its end for G32 to G34, whose path is known, in mm, X as a radius.
    Thread { block: &'a Block, code: &'static str, to: Option<Point> },
    /// G32 to G34 cut from the position of the tip.
    ThreadMove { pass: ThreadPass<'a>, code: &'static str },
    /// The thread of a G76, as one cut.
    ThreadPass(ThreadPass<'a>),
    /// I in a G92 on a control that writes the taper with R.
    OldTaperWord { words: &'a Words<'a> },
    /// A block of a single cycle without an axis makes no motion. `taper`: the word of the taper, if any.
    CycleWithoutAxis { words: &'a Words<'a>, cycle: Single, taper: Option<&'a Word> },
    /// A pass of a single cycle is about to be cut.
    SinglePass(SinglePass<'a>),
    /// G70 to G76 is called.
    MultipleCycle { block: &'a Block, cycle: Multiple },
    /// F, S or T in a contour that is read for roughing.
    IgnoredInRoughing { address: u8, words: &'a Words<'a> },
    /// P and Q of a contour cycle name a contour. `purpose`: why the cycle reads it; `named`: P and Q.
    ContourNamed { purpose: ContourUse, named: (u32, u32) },
    /// G70 follows its contour.
    Finishing(FinishingCall<'a>),
    /// G71 or G72 has read its contour; its passes are not computed yet.
    RoughingCalled(ContourCall<'a, Roughing>),
    /// G71 or G72 has computed its passes.
    Roughing(ContourCall<'a, Roughing>),
    /// G73 has read its contour; its passes are not computed yet.
    Pattern(ContourCall<'a, Pattern>),
    /// G76 has computed its passes.
    Threading(ThreadingCall<'a>),
    /// A hole needs a live tool.
    Milling { block: &'a Block },
    /// A hole is tapped on the axis of the spindle.
    TapOnAxis { block: &'a Block },
    /// A move in a virtual plane.
    PlaneMove { block: &'a Block, words: &'a Words<'a>, plane: VirtualPlane },
    /// C moves. `span`: its word, or the block.
    CAxis { span: Span },
    /// A path of polar interpolation. `distance`: its smallest distance to the centre of the face, in mm.
    NearCenter { distance: f64, words: Span },
    /// A move is compensated.
    Compensated(CompensatedMove<'a>),
    /// The words of a block were carried out while compensation was active, or ended. `moved`: the block has
    /// a move.
    CompensatedBlock { block: &'a Block, moved: bool },
    /// A block was not carried out.
    LeftOut,
    /// The settings that a block or program makes are unknown.
    SettingsUnknown,
    /// M02 or M30. `end`: the last M word of the block.
    ProgramEnds { end: Option<&'a Word> },
    /// Nothing is left to carry out.
    RunEnds,
}

impl Event<'_> {
    /// Whether the next cut may differ from the previous one: in feed, spindle, tool or axes.
    #[inline]
    pub fn matters_for_cuts(&self) -> bool {
        !matches!(
            self,
            Self::SinglePass(_)
                | Self::MotionCode { .. }
                | Self::CycleCode { .. }
                | Self::Rapid
                | Self::UnreadWords { .. }
                | Self::Dwell { .. }
                | Self::VacantWord { .. }
                | Self::While { .. }
                | Self::CompensatedLine { .. }
                | Self::FromAxis { .. }
                | Self::Compensated(_)
                | Self::CompensatedBlock { .. }
        )
    }
}

/// Observes a run.
pub trait Observer: Any {
    /// Handles an event and adds its diagnostics to `reports`.
    fn on_event(&mut self, event: &Event<'_>, at: &EventContext<'_>, reports: &mut Vec<Diagnostic>);

    /// A copy of this observer.
    fn clone_box(&self) -> Box<dyn Observer>;

    /// Whether it will report the same as `other`, an observer of the same type, from here on.
    fn continues_like(&self, other: &dyn Observer) -> bool;

    /// Moves the spans it holds after a change of the text before them.
    fn shift(&mut self, shift: &Shift);

    /// Whether it still holds back a message about a block or word that begins in `changed`.
    fn waits_for(&self, changed: Range<u32>) -> bool;

    /// Called before the blocks of a contour are read. This observer sees them; the returned copy, without
    /// what they did, replaces it afterwards.
    fn fork_for_contour(&mut self) -> Box<dyn Observer>;

    /// Called when this observer replaces `before`: what `before` has reported is not reported again.
    fn inherit_reported(&mut self, before: &mut dyn Observer);
}

impl fmt::Debug for dyn Observer {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Observer")
    }
}

impl Clone for Box<dyn Observer> {
    fn clone(&self) -> Self {
        self.as_ref().clone_box()
    }
}
