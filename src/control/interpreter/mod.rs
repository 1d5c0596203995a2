//! Blocks to motions: what the control does with one block after the other.
//!
//! In: blocks, the setup. Out: motions and messages. Values become millimetres and radii here and nowhere
//! else. An error drops the motion of its block, the position stays, and later motions are marked uncertain.
//!
//! Order within a block (semantics §1.3): plane, unit and feed mode – G96/G97 with S – F – T – M03, M04 –
//! coordinate system – compensation – motion or cycle – M05, M00, M01, M02, M30.

mod contours;
mod motions;
mod multiples;
mod path;
mod settings;
mod singles;
mod watch;

use super::arcs::{self, CenterWords};
use super::codes::{self, Compensation, G, M, MotionMode, Multiple, Plane, Switch};
use super::dialect::{
    Control, DecimalRule, Dialect, FeedMode, G71Retract, G73Intervals, G76Clamp, IInG92, NegativeArcR,
    PqUnit, XuConflict,
};
use super::modal::{CycleMemory, Once, Routed, State, Target};
use super::program::Labels;
use super::setup::{Setup, Tool};
use super::words::{self, Reading, Words, letters, plain, quote};
use crate::cycles::single::{self, PullOut, Single};
use crate::cycles::{Contour, Move};
use crate::diagnostics::{Diagnostic, Message, Severity};
use crate::geometry::{Point, Turn};
use crate::limits::Limits;
use crate::motion::{Chunk, CycleStep, Motion, MotionKind, Motions, SpindleTurn, Step};
use crate::text::block::{Block, BlockKind, Value, Word};
use crate::text::parser::Resume;
use crate::text::source::Span;

/// Motions of a chunk before the next one is begun.
const CHUNK: usize = 4096;

/// Words that move X or Z.
const AXES: u32 = letters(b"XZUW");

/// Whether the program goes on after a block.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Flow {
    /// With the next block.
    Next,
    /// With the block at another place.
    Jump(Resume),
    /// It has ended.
    End,
}

/// The places manuals name in a cycle along a contour.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Landmarks {
    /// The cycle block.
    pub span: Span,
    /// A: where the cycle starts.
    pub start: Point,
    /// A′: where the contour begins.
    pub first: Point,
    /// B: where the contour ends.
    pub last: Point,
    /// P and Q.
    pub named: (u32, u32),
    /// Whether it was roughed there.
    pub roughed: bool,
}

/// One-shot codes: they use up the words of their block.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum OneShot {
    Dwell,
    Home,
    Setting,
    LocalFrame,
    /// G70 to G76.
    Multiple(Multiple),
    NotYet,
}

/// What the codes of one block ask for.
#[derive(Default)]
struct Request {
    one_shot: Option<OneShot>,
    /// A code of group 01 stands in the block.
    motion: Option<MotionMode>,
    /// G96 (true) or G97.
    surface: Option<bool>,
    /// M05.
    stop_spindle: bool,
    /// M02, M30.
    end: bool,
    /// The motion of the block is not carried out.
    drop: bool,
    /// The word of group 01 met so far.
    motion_word: Option<Span>,
    /// Indices of the words with a comma: `,C2`, `,R1`, `,A30`.
    comma: [Option<usize>; 3],
    /// The block made a move of the path.
    moved: bool,
    /// G40, G41 or G42 changes compensation.
    switches_compensation: bool,
}

/// Runs blocks and keeps what comes of them.
pub struct Interpreter {
    setup: Setup,
    dialect: Dialect,
    limits: Limits,
    /// The state of the control after the last block.
    pub state: State,
    /// Finished chunks.
    motions: Motions,
    chunk: Chunk,
    diagnostics: Vec<Diagnostic>,
    hidden: usize,
    full: bool,
    /// Steps so far that left no motion: see [`Limits::cycle_work`].
    work: usize,
    /// While a contour is read, motions are kept here instead of being stored.
    recorded: Option<Vec<Routed>>,
    /// What for, if a contour is being read.
    purpose: Option<contours::Purpose>,
    /// Sequence numbers, made when first asked for.
    labels: Option<Labels>,
    /// Places of the contour cycles, for the picture.
    landmarks: Vec<Landmarks>,
    /// Where the program goes on after the block.
    jump: Option<Resume>,
}

impl Interpreter {
    /// A control at power-on.
    pub fn new(setup: Setup, limits: Limits) -> Self {
        let dialect = Dialect::new(&setup.dialect);
        let state = State::new(&setup, &dialect);
        let chunk = Chunk::new(0, 0, state.position);
        Self {
            setup,
            dialect,
            limits,
            state,
            motions: Motions::default(),
            chunk,
            diagnostics: Vec::new(),
            hidden: 0,
            full: false,
            work: 0,
            recorded: None,
            purpose: None,
            labels: None,
            landmarks: Vec::new(),
            jump: None,
        }
    }

    /// Motions of the finished chunks.
    pub fn motions(&self) -> &Motions {
        &self.motions
    }

    /// Messages so far.
    pub fn diagnostics(&self) -> &[Diagnostic] {
        &self.diagnostics
    }

    /// Places of the contour cycles so far.
    pub fn landmarks(&self) -> &[Landmarks] {
        &self.landmarks
    }

    /// Messages that were not kept.
    pub fn hidden(&self) -> usize {
        self.hidden
    }

    /// The setup of the run.
    pub fn setup(&self) -> &Setup {
        &self.setup
    }

    /// Makes the moves that wait for a next one: the program has ended.
    pub fn finish(&mut self) {
        self.settle();
    }

    /// Closes the last chunk, so that [`Interpreter::motions`] holds all motions, and puts the messages in
    /// order of their place.
    pub fn close(&mut self) {
        let next = Chunk::new(0, 0, self.state.position);
        self.motions.push(std::mem::replace(&mut self.chunk, next));
        self.diagnostics.sort_by_key(|diagnostic| diagnostic.span.start);
    }

    /// Motions and messages.
    pub fn into_parts(self) -> (Motions, Vec<Diagnostic>) {
        (self.motions, self.diagnostics)
    }

    /// Tells something even when no more messages are kept.
    pub fn tell_always(&mut self, diagnostic: Diagnostic) {
        self.diagnostics.push(diagnostic);
    }

    /// Tells the user something.
    pub fn tell(&mut self, diagnostic: Diagnostic) {
        if self.diagnostics.len() < self.limits.messages {
            self.diagnostics.push(diagnostic);
        } else {
            self.hidden += 1;
        }
    }

    /// Tells what is wrong with the writing of a block that is not run.
    pub fn tell_faults(&mut self, block: &Block) {
        for fault in &block.faults {
            self.tell(fault.clone());
        }
    }

    /// Carries out one block.
    pub fn run(&mut self, text: &[u8], block: &Block) -> Flow {
        let broken = !block.faults.is_empty() && {
            self.tell_faults(block);
            block.is_broken()
        };
        if self.recorded.is_none() && (self.chunk.is_empty() || self.chunk.len() >= CHUNK) {
            let next = Chunk::new(block.span.start, block.line, self.state.position);
            self.motions.push(std::mem::replace(&mut self.chunk, next));
        }
        match block.kind {
            BlockKind::Percent => return Flow::Next,
            BlockKind::Macro => {
                let what = format!("`{}`", shortened(&quote(text, block.span)));
                self.tell(Diagnostic::new(Message::NotYet { what }, block.span));
                self.state.uncertain = true;
                return Flow::Next;
            }
            BlockKind::Words => {}
        }
        if block.words.is_empty() {
            // Prose in a line of its own moves nothing; anything else that is broken may have been a motion.
            self.state.uncertain |= broken && block.faults.iter().any(|fault| !is_prose(fault));
            return Flow::Next;
        }
        let mut request = Request { drop: broken, ..Request::default() };
        let mut words = Words::new(block);
        for (index, word) in block.words.iter().enumerate() {
            self.take(text, block, &mut request, &mut words, index, word);
        }
        self.technology(text, &request, &words);
        if request.drop {
            self.state.uncertain = true;
            if let Some(mode) = request.motion {
                self.enter(mode, block, &words);
            }
        } else {
            self.act(text, block, &mut request, &words);
            self.state.uncertain |= request.drop;
        }
        if !request.moved {
            self.idle_block();
        }
        if request.end {
            self.settle();
            self.state.compensation = Compensation::Off;
        }
        if request.stop_spindle {
            self.state.spindle.turn = SpindleTurn::Stopped;
            self.state.spindle.live_tool = false;
            self.state.told.forget(Once::SpindleStopped);
        }
        match self.jump.take() {
            _ if request.end || self.full => Flow::End,
            Some(at) => Flow::Jump(at),
            None => Flow::Next,
        }
    }

    /// Takes one word: codes change the request and the modal state, data words are kept for later.
    #[inline]
    fn take<'b>(
        &mut self,
        text: &[u8],
        block: &'b Block,
        request: &mut Request,
        words: &mut Words<'b>,
        index: usize,
        word: &Word,
    ) {
        let Value::Number { number, .. } = word.value else {
            let what = format!("`{}`", shortened(&quote(text, word.span)));
            self.tell(Diagnostic::new(Message::NotYet { what }, word.span));
            request.drop = true;
            return;
        };
        if let Some(wrong) = words::check(text, word) {
            self.tell(wrong);
            request.drop = true;
            return;
        }
        match word.address {
            b'G' => {
                let key = match number.decimals {
                    0 => number.mantissa * 10,
                    1 => number.mantissa,
                    _ => u64::MAX,
                };
                self.take_g(text, request, key, word);
            }
            b'M' => self.take_m(text, request, number.mantissa, word),
            b'C' if word.comma => request.comma[0] = Some(index),
            b'R' if word.comma => request.comma[1] = Some(index),
            b'A' if word.comma => request.comma[2] = Some(index),
            _ if word.comma => {
                let text = quote(text, word.span);
                self.tell(Diagnostic::new(Message::NotUnderstood { text }, word.span));
                request.drop = true;
            }
            address => {
                if let Some(_before) = words.take(index, word) {
                    let used = quote(text, block.words[index].span);
                    self.tell(Diagnostic::new(
                        Message::DuplicateWord { address: address as char, used },
                        word.span,
                    ));
                }
            }
        }
    }

    fn take_g(&mut self, text: &[u8], request: &mut Request, key: u64, word: &Word) {
        let Some((code, group)) = codes::g_code(key) else {
            self.tell(Diagnostic::new(Message::UnknownG { word: quote(text, word.span) }, word.span));
            request.drop = true;
            return;
        };
        if group == 1 {
            self.note_motion_word(text, request, word.span);
        }
        let state = &mut self.state;
        match code {
            G::Motion(MotionMode::Tapping) if self.dialect.control != Control::Gsk => {
                // System A of FANUC has no G33.
                self.tell(Diagnostic::new(Message::UnknownG { word: quote(text, word.span) }, word.span));
                request.drop = true;
            }
            G::Motion(mode) => {
                request.motion = Some(mode);
                if mode == MotionMode::NotYet {
                    self.not_yet(text, word.span);
                }
            }
            G::Dwell => request.one_shot = Some(OneShot::Dwell),
            G::Home => request.one_shot = Some(OneShot::Home),
            G::Setting => request.one_shot = Some(OneShot::Setting),
            G::LocalFrame => request.one_shot = Some(OneShot::LocalFrame),
            G::Multiple(cycle) => request.one_shot = Some(OneShot::Multiple(cycle)),
            G::Plane(plane) if plane != state.plane && state.compensation != Compensation::Off => {
                self.tell(Diagnostic::new(Message::CompensationPlane, word.span));
                request.drop = true;
            }
            G::Plane(plane) => state.plane = plane,
            G::Unit(unit) => state.unit = unit,
            // Roughing cycles pass over compensation in their contour (semantics §7.1 rule 5).
            G::Compensation(_) if self.purpose == Some(contours::Purpose::Roughing) => {}
            G::Compensation(compensation) => {
                request.switches_compensation = compensation != state.compensation;
                state.compensation = compensation;
                state.told.forget(Once::CompensationIdle);
            }
            G::Frame(frame) => {
                self.leave_compensation();
                let state = &mut self.state;
                state.change_frame(|frames| frames.active = frame);
            }
            G::SurfaceSpeed => request.surface = Some(true),
            G::ConstantSpeed => request.surface = Some(false),
            G::Feed(mode) => {
                state.feed_is_old |= mode != state.feed_mode && state.feed.is_some();
                state.feed_mode = mode;
                state.told.forget(Once::FeedUnit);
            }
            G::Idle => {}
            G::NotYet => {
                // Under polar interpolation C is an axis, not a chamfer.
                self.state.c_axis |= matches!(key, 121 | 1120);
                request.one_shot = Some(OneShot::NotYet);
                self.not_yet(text, word.span);
            }
        }
    }

    /// Two different codes of group 01 in a block: the last is valid. The other groups are rarely met twice.
    fn note_motion_word(&mut self, text: &[u8], request: &mut Request, span: Span) {
        if let Some(before) = request.motion_word.replace(span)
            && quote(text, before) != quote(text, span)
        {
            let (dropped, used) = (quote(text, before), quote(text, span));
            self.tell(Diagnostic::new(Message::SameGroup { dropped, used }, span));
        }
    }

    fn take_m(&mut self, text: &[u8], request: &mut Request, number: u64, word: &Word) {
        let state = &mut self.state;
        match codes::m_code(number) {
            Some(M::Spindle(SpindleTurn::Stopped)) => request.stop_spindle = true,
            Some(M::Spindle(turn)) => state.spindle.turn = turn,
            Some(M::LiveTool) => state.spindle.live_tool = true,
            Some(M::ThreadPullOut(switch)) => state.thread_chamfer_on = switch == Switch::On,
            Some(M::End) => request.end = true,
            Some(M::CAxis(switch)) => state.c_axis = switch == Switch::On,
            Some(M::Pause | M::Idle) => {}
            Some(M::NotYet) => {
                self.not_yet(text, word.span);
                self.state.uncertain = true;
                // M99 goes back to the caller or to the head of the program: either way this run is over.
                request.end |= number == 99;
            }
            None => self.tell(Diagnostic::new(Message::UnknownM { word: quote(text, word.span) }, word.span)),
        }
    }

    /// Coordinate systems, motion, cycles.
    fn act(&mut self, text: &[u8], block: &Block, request: &mut Request, words: &Words) {
        if let Some(mode) = request.motion {
            self.enter(mode, block, words);
        }
        if let Some(one_shot) = request.one_shot {
            if one_shot != OneShot::Dwell {
                self.state.memory = CycleMemory { passes: self.state.memory.passes, ..CycleMemory::EMPTY };
            }
            if let (OneShot::Setting | OneShot::Dwell, Some(word)) = (one_shot, words.get(b'T')) {
                let message = Message::ToolWithSetting { word: quote(text, word.span) };
                self.tell(Diagnostic::new(message, word.span));
                request.drop = true;
                return;
            }
            match one_shot {
                OneShot::Dwell => {}
                OneShot::Multiple(_) => self.arrive_for_cycle(),
                _ => self.leave_compensation(),
            }
            match one_shot {
                OneShot::Dwell => self.dwell(text, block, words, request),
                OneShot::Home => self.home(text, block, words),
                OneShot::Setting => self.setting(words),
                OneShot::LocalFrame => self.local_frame(words),
                OneShot::Multiple(cycle) => self.multiple(text, block, request, words, cycle),
                OneShot::NotYet => self.state.uncertain = true,
            }
            return;
        }
        const OTHER_AXES: u32 = letters(b"YVCH");
        if words.has_any(OTHER_AXES) && !matches!(self.state.motion, MotionMode::Cycle(_)) {
            self.other_axes(text, words);
        }
        match self.state.motion {
            MotionMode::Rapid if words.has_any(AXES) => {
                self.settle_angle();
                if let Some(index) = request.comma.into_iter().flatten().next() {
                    let span = block.words[index].span;
                    self.tell(Diagnostic::new(Message::CornerNone { word: quote(text, span) }, span));
                    request.drop = true;
                    return;
                }
                let to = self.target(text, words);
                request.moved = true;
                self.travel(block, self.motion(MotionKind::Rapid, to), None);
            }
            MotionMode::Line if words.has_any(AXES | letters(b"A")) || request.comma[2].is_some() => {
                self.line(text, block, request, words);
            }
            MotionMode::Arc(turn) if words.has_any(AXES | letters(b"IKR")) => {
                self.arc(text, block, request, words, turn)
            }
            MotionMode::Thread | MotionMode::VariableThread | MotionMode::Tapping if words.has_any(AXES) => {
                self.thread(text, block, request, words);
            }
            MotionMode::Cycle(cycle) => self.cycle(text, block, request, words, cycle),
            MotionMode::NotYet if words.has_any(AXES) => self.state.uncertain = true,
            _ => {}
        }
    }

    /// A code of group 01 comes into force.
    fn enter(&mut self, mode: MotionMode, block: &Block, words: &Words) {
        let state = &mut self.state;
        match (mode, state.motion) {
            (MotionMode::Cycle(new), MotionMode::Cycle(old)) => {
                // Spelled again, the code forgets its taper but not its end point (seed 000, semantics §6.2).
                state.memory.taper = 0.0;
                if new != old {
                    state.memory.passes = 0;
                }
            }
            _ => state.memory = CycleMemory::EMPTY,
        }
        state.motion = mode;
        if mode == MotionMode::Cycle(Single::Turning)
            && !words.has_any(AXES)
            && state.told.first(Once::G90AsAbsolute)
        {
            let g90 = block.words.iter().find(|word| word.address == b'G' && plain(word) == Some(90.0));
            let span = g90.map_or_else(|| block.words_span(), |word| word.span);
            self.tell(Diagnostic::new(Message::G90AsAbsolute, span));
        }
    }

    fn reading(&self) -> Reading {
        Reading { unit: self.state.unit, decimal: self.dialect.decimal }
    }

    fn not_yet(&mut self, text: &[u8], span: Span) {
        let what = format!("`{}`", shortened(&quote(text, span)));
        self.tell(Diagnostic::new(Message::NotYet { what }, span));
    }

    /// A motion from where the tip stands.
    #[inline]
    fn motion(&self, kind: MotionKind, to: Point) -> Motion {
        Motion {
            kind,
            from: self.state.position,
            to,
            center: None,
            lead: None,
            seconds: None,
            programmed: None,
            cycle: None,
            process: self.state.process(),
        }
    }

    /// Moves straight to a place.
    #[inline]
    fn go(&mut self, block: &Block, kind: MotionKind, to: Point) {
        self.push(block, self.motion(kind, to));
    }

    /// Keeps a motion unless it has no length, and puts the tip at its end.
    #[inline]
    fn push(&mut self, block: &Block, motion: Motion) {
        self.emit(Routed { motion, span: block.span, line: block.line });
        self.state.position = motion.to;
    }

    /// Keeps a motion unless it has no length.
    #[inline]
    fn emit(&mut self, mut routed: Routed) {
        if let Some(tip) = self.state.tip.take() {
            routed.motion.from = tip;
        }
        let motion = &routed.motion;
        let still = motion.from.is_same(motion.to) && motion.center.is_none() && motion.seconds.is_none();
        if still || self.full {
            return;
        }
        match &mut self.recorded {
            // One more than a cycle may have, so that it is refused rather than cut short.
            Some(recorded) if recorded.len() <= self.limits.moves_per_cycle => recorded.push(routed),
            Some(_) => {}
            None => self.store(routed),
        }
    }

    /// Counts steps that leave no motion. False: they were too many, and the run ends here.
    fn spend(&mut self, steps: usize, block: &Block) -> bool {
        self.work = self.work.saturating_add(steps);
        if self.work > self.limits.cycle_work && !self.full {
            self.full = true;
            let message = Message::TooMuchWork { most: self.limits.cycle_work };
            self.tell_always(Diagnostic::new(message, block.words_span()));
        }
        !self.full
    }

    /// Motions kept so far.
    fn kept(&self) -> usize {
        self.motions.len() + self.chunk.len()
    }

    /// Keeps a motion for good.
    #[inline]
    fn store(&mut self, routed: Routed) {
        if self.kept() >= self.limits.motions {
            if !self.full {
                self.full = true;
                let message = Message::TooManyMotions { most: self.limits.motions };
                self.tell(Diagnostic::new(message, routed.span));
            }
            return;
        }
        self.chunk.push(&routed.motion, routed.span, routed.line);
    }
}

fn is_prose(fault: &Diagnostic) -> bool {
    matches!(fault.message, Message::PlainText { .. })
}

/// The head of a long quotation.
fn shortened(text: &str) -> String {
    const LONGEST: usize = 24;
    if text.chars().count() <= LONGEST {
        return text.to_owned();
    }
    text.chars().take(LONGEST - 1).collect::<String>() + "…"
}
