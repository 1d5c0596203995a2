//! Blocks to motions: what the control does with one block after the other.
//!
//! In: blocks, the setup. Out: motions and messages. Values become millimetres and radii here and nowhere
//! else. An error drops the motion of its block, the position stays, and later motions are marked uncertain.
//!
//! Order within a block (semantics §1.3): plane, unit and feed mode – G96/G97 with S – F – T – M03, M04 –
//! coordinate system – compensation – motion or cycle – M05, M00, M01, M02, M30.

mod calls;
mod contours;
mod holes;
mod macros;
mod motions;
mod multiples;
mod path;
mod reference;
mod rotary;
mod settings;
mod singles;
mod system;
mod watch;

use std::collections::{BTreeMap, BTreeSet};

use super::arcs::{self, CenterWords};
use super::codes::{self, Compensation, G, M, MotionMode, Multiple, Plane, Switch};
use super::dialect::{
    CodeList, Control, DecimalRule, Dialect, FeedMode, G71Retract, G73Intervals, G76Clamp, GSystem, IInG92,
    NegativeArcR, PqUnit, XuConflict,
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
use crate::motion::{Chunk, CycleStep, Feed, Motion, MotionKind, Motions, SpindleTurn, Step};
use crate::text::block::{Block, BlockKind, Value, Word};
use crate::text::parser::Resume;
use crate::text::source::Span;
use calls::Passage;
use rotary::TURNS;

pub use calls::Here;

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
    /// Everything from the start, with the program that begins there: what ran is only its subprogram.
    Restart(Resume),
    /// It has ended.
    End,
}

/// A block that was carried out.
#[derive(Clone, Debug, PartialEq)]
pub struct Executed {
    /// Where it stands.
    pub at: Resume,
    /// Motions kept before it.
    pub first: usize,
    /// Its words with values in place of expressions.
    pub values: Option<String>,
    /// It only steers the program: a macro statement, a call, a return.
    pub steers: bool,
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
    OtherHome,
    CheckHome,
    FromHome,
    Machine,
    Data,
    Setting,
    LocalFrame,
    /// G12.1, G13.1.
    Polar(Switch),
    /// G07.1.
    Cylinder,
    /// G70 to G76.
    Multiple(Multiple),
    NotSupported,
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
    /// M97, M98, M99.
    passage: Option<Passage>,
    /// G65 or G66: the words behind it are arguments.
    macro_call: Option<&'static str>,
    /// A hole cycle stands in the block.
    hole: Option<codes::Hole>,
    /// G43: H names a length offset.
    length_offset: bool,
    /// G54.1, whose P names the frame.
    extended_frame: Option<Span>,
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
    /// Where loops go on behind their END, by the first byte of their DO; found when first asked for.
    ends: BTreeMap<u32, Option<Resume>>,
    /// Places of the contour cycles, for the picture.
    landmarks: Vec<Landmarks>,
    /// Where the contours of G71 to G73 begin, by P and Q.
    roughed: Vec<((u32, u32), Resume)>,
    /// Where the program goes on after the block.
    jump: Option<Resume>,
    /// Blocks of the main program from this byte on have not been run yet.
    furthest: u32,
    /// Blocks carried out through jumps, loops and calls.
    repeated: usize,
    /// Their bytes.
    repeated_text: usize,
    /// The block that jumped or called last.
    jumped_by: Option<Span>,
    /// The program has left the straight way through its text.
    wandered: bool,
    /// First bytes of the programs that were run.
    heads: BTreeSet<u32>,
    /// The blocks carried out, in order, if they are asked for.
    trace: Option<Vec<Executed>>,
    /// Messages told, by place and name: what runs again is not told again.
    told: BTreeSet<(u32, &'static str)>,
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
            ends: BTreeMap::new(),
            landmarks: Vec::new(),
            roughed: Vec::new(),
            jump: None,
            furthest: 0,
            repeated: 0,
            repeated_text: 0,
            jumped_by: None,
            wandered: false,
            heads: BTreeSet::new(),
            trace: None,
            told: BTreeSet::new(),
        }
    }

    /// Keeps the blocks carried out from here on.
    pub fn keep_trace(&mut self) {
        self.trace.get_or_insert_default();
    }

    /// The blocks carried out.
    pub fn take_trace(&mut self) -> Vec<Executed> {
        self.trace.take().unwrap_or_default()
    }

    /// Whether blocks carried out are kept.
    pub fn has_trace(&self) -> bool {
        self.trace.is_some()
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

    /// Tells the user something, unless it was told of the same place before. Why the run ends is told even when no
    /// more messages are kept.
    pub fn tell(&mut self, diagnostic: Diagnostic) {
        if self.diagnostics.len() >= self.limits.messages && !diagnostic.message.ends_the_run() {
            // Which of them were told before is not kept any more.
            self.hidden += usize::from(!self.wandered);
        } else if self.told.insert((diagnostic.span.start, diagnostic.message.slug())) {
            self.diagnostics.push(diagnostic);
        }
    }

    /// The G-code system in force.
    pub fn system(&self) -> GSystem {
        self.dialect.g_system
    }

    /// The G codes in force.
    pub fn code_list(&self) -> CodeList {
        self.dialect.code_list()
    }

    /// Reads the program in another G-code system.
    pub fn set_system(&mut self, system: GSystem) {
        self.dialect.g_system = system;
    }

    /// An O program begins here and is run: the main program, unless a call is under way.
    pub fn enter_program(&mut self, head: Resume) {
        if self.state.course.calls.is_empty() {
            self.state.course.head = head;
        }
        self.heads.insert(head.byte);
    }

    /// The program to run begins here, and is not the first of the text.
    pub fn begin_elsewhere(&mut self, head: Resume) {
        self.enter_program(head);
        self.furthest = head.byte;
        self.wandered = true;
    }

    /// Whether the program in force begins here.
    pub fn is_head(&self, at: Resume) -> bool {
        self.state.course.program_head().byte == at.byte
    }

    /// Whether the program that begins here was run.
    pub fn was_run(&self, at: Resume) -> bool {
        self.heads.contains(&at.byte)
    }

    /// Whether a program of the text calls the one of a number.
    pub fn is_called(&mut self, text: &[u8], number: u32) -> bool {
        self.labels(text).is_called(number)
    }

    /// The bounds of the run.
    pub fn limits(&self) -> Limits {
        self.limits
    }

    /// Whether the program has left the straight way through its text.
    pub fn has_wandered(&self) -> bool {
        self.wandered
    }

    /// Tells what is wrong with the writing of a block that is not run.
    pub fn tell_faults(&mut self, block: &Block) {
        for fault in &block.faults {
            self.tell(fault.clone());
        }
    }

    /// Carries out one block.
    pub fn run(&mut self, text: &[u8], block: &Block, here: Here) -> Flow {
        if self.recorded.is_none() && !self.may_go_on(block) {
            return Flow::End;
        }
        self.carry_out(text, block, here)
    }

    fn carry_out(&mut self, text: &[u8], block: &Block, here: Here) -> Flow {
        if block.delete.is_some_and(|level| self.setup.block_skip.contains(&level)) {
            self.tell_faults(block);
            return Flow::Next;
        }
        if block.optional.is_some_and(|(_, level)| self.setup.block_skip.contains(&level)) {
            return self.carry_out(text, &without_optional(block), here);
        }
        let broken = !block.faults.is_empty() && {
            self.tell_faults(block);
            block.is_broken()
        };
        if self.recorded.is_none() && self.chunk.is_empty() {
            self.chunk.begin_at(block.span.start, block.line, self.state.position);
        } else if self.recorded.is_none() && self.chunk.len() >= CHUNK {
            let next = Chunk::new(block.span.start, block.line, self.state.position);
            self.motions.push(std::mem::replace(&mut self.chunk, next));
        }
        if self.trace.is_some() {
            self.trace_block(block, here);
        }
        self.state.sequence = block.sequence.unwrap_or(self.state.sequence);
        match block.kind {
            BlockKind::Percent => return Flow::Next,
            BlockKind::Macro if broken => {
                self.state.uncertain = true;
                return Flow::Next;
            }
            BlockKind::Macro => return self.macro_statement(text, block, here),
            BlockKind::Words => {}
        }
        if self.state.data_input {
            let ends = |word: &Word| word.address == b'G' && plain(word) == Some(11.0);
            self.state.data_input = !block.words.iter().any(ends);
            return Flow::Next;
        }
        if block.words.is_empty() {
            // Prose in a line of its own moves nothing; anything else that is broken may have been a motion.
            self.state.uncertain |= broken && block.faults.iter().any(|fault| !is_prose(fault));
            return Flow::Next;
        }
        self.words_of(text, block, here)
    }

    /// Carries out a block of words.
    #[inline]
    fn words(&mut self, text: &[u8], block: &Block, here: Here) -> Flow {
        let broken = block.is_broken();
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
            self.end_of_program(text, block);
        }
        if request.stop_spindle {
            self.state.spindle.turn = SpindleTurn::Stopped;
            self.state.spindle.live_tool = false;
            self.state.told.forget(Once::SpindleStopped);
        }
        match (self.jump.take(), request.passage) {
            _ if request.end || self.full => Flow::End,
            (Some(at), _) => Flow::Jump(at),
            // A call in a contour was told already.
            (None, _) if self.recorded.is_some() => Flow::Next,
            (None, Some(passage)) => self.pass(text, block, &words, passage, here),
            (None, None) => match request.macro_call {
                Some(code) => self.macro_call(text, block, here, code),
                None if request.moved && self.state.course.modal.is_some() => {
                    self.modal_call(block, here.next).unwrap_or(Flow::Next)
                }
                None => Flow::Next,
            },
        }
    }

    /// Keeps a block that is carried out.
    #[cold]
    fn trace_block(&mut self, block: &Block, here: Here) {
        let first = self.kept();
        let Some(trace) = self.trace.as_mut().filter(|_| self.recorded.is_none()) else { return };
        let steers = !block.is_broken() && block.kind == BlockKind::Macro || block.words.iter().any(steers);
        trace.push(Executed { at: here.at, first, values: None, steers });
    }

    /// Keeps what the last block wrote into a table of the control.
    fn trace_write(&mut self, variable: u32, value: f64) {
        if let Some(last) = self.trace.as_mut().and_then(|trace| trace.last_mut()) {
            last.values = Some(format!("#{variable}={value}"));
        }
    }

    /// The last block could not be carried out, and stays as it is.
    fn trace_fault(&mut self) {
        if let Some(last) = self.trace.as_mut().and_then(|trace| trace.last_mut()) {
            last.steers = false;
        }
    }

    /// Keeps the words of the last block with their values.
    #[cold]
    fn trace_values(&mut self, block: &Block) {
        let Some(trace) = self.trace.as_mut().filter(|_| self.recorded.is_none()) else { return };
        let mut values = String::new();
        for word in &block.words {
            let Value::Number { number, negative } = word.value else { continue };
            let (comma, minus) = (if word.comma { "," } else { "" }, if negative { "-" } else { "" });
            let space = if values.is_empty() { "" } else { " " };
            let whole = number.value().fract() == 0.0;
            let point = if number.has_point() && whole { "." } else { "" };
            values += &format!("{space}{comma}{}{minus}{}{point}", word.address as char, number.value());
        }
        if let Some(last) = trace.last_mut() {
            last.values = Some(values);
            last.steers = !block.is_broken() && block.words.iter().any(steers);
        }
    }

    /// The last block was not carried out, for want of a value.
    fn trace_nothing(&mut self) {
        if let Some(last) = self.trace.as_mut().and_then(|trace| trace.last_mut()) {
            (last.values, last.steers) = (Some(String::new()), false);
        }
    }

    /// M02, M30.
    fn end_of_program(&mut self, text: &[u8], block: &Block) {
        self.settle();
        let end = block.words.iter().find(|word| word.address == b'M');
        self.plane_left_on(text, end.map_or_else(|| block.words_span(), |word| word.span));
        self.state.compensation = Compensation::Off;
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
        let Value::Number { number, .. } = word.value else { return };
        if request.macro_call.is_some() || (word.address == b'H' && request.length_offset) {
            return;
        }
        if let Some(wrong) = words::check(text, word) {
            let wrong = if self.dialect.strict { wrong.graded(Severity::Error) } else { wrong };
            request.drop |= wrong.is_error();
            let carried_out = !wrong.is_error();
            self.tell(wrong);
            if !carried_out {
                return;
            }
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
        let Some(found) = codes::g_code(key, self.dialect.code_list()) else {
            self.unknown_g(text, request, key, word);
            return;
        };
        if found.group == 1 {
            self.note_motion_word(text, request, word.span);
        }
        if self.state.virtual_plane.is_some() && !self.may_stand_in_plane(text, found.code, word) {
            request.drop = true;
            return;
        }
        let state = &mut self.state;
        match found.code {
            G::Polar(switch) => request.one_shot = Some(OneShot::Polar(switch)),
            G::Cylinder => request.one_shot = Some(OneShot::Cylinder),
            G::Motion(mode) => {
                request.motion = Some(mode);
            }
            G::Hole(hole) => request.hole = Some(hole),
            G::NoHole => {
                if let Some(hole) = state.hole.take() {
                    state.motion = hole.before;
                }
            }
            G::HoleReturn(level) => state.hole_return = level,
            G::MacroCall(call) => request.macro_call = Some(call.code()),
            G::NoModalMacro => state.course.modal = None,
            G::Distance { incremental } => state.incremental = incremental,
            G::OtherHome => request.one_shot = Some(OneShot::OtherHome),
            G::CheckHome => request.one_shot = Some(OneShot::CheckHome),
            G::FromHome => request.one_shot = Some(OneShot::FromHome),
            G::Machine => request.one_shot = Some(OneShot::Machine),
            G::Data => request.one_shot = Some(OneShot::Data),
            G::EndOfData => {}
            G::ExtendedFrame => request.extended_frame = Some(word.span),
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
            G::NotSupported => {
                request.one_shot = Some(OneShot::NotSupported);
                self.not_supported(text, word.span);
            }
        }
    }

    /// A G code this control does not have: an alarm; of the numbers machine makers use, a question of the machine.
    fn unknown_g(&mut self, text: &[u8], request: &mut Request, key: u64, word: &Word) {
        let quoted = quote(text, word.span);
        // Tool length offsets of mills: on a lathe the T word has them, and on some machines with a B axis G43.
        if matches!(key, 430 | 440) {
            request.length_offset = true;
            self.tell(Diagnostic::new(Message::MakerG { word: quoted }, word.span));
            return;
        }
        if matches!(key, 1_140..4_000 | 9_000..) && key.is_multiple_of(10) {
            self.tell(Diagnostic::new(Message::MakerG { word: quoted }, word.span));
            self.state.uncertain = true;
            return;
        }
        self.tell(Diagnostic::new(Message::UnknownG { word: quoted }, word.span));
        request.drop = true;
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
        state.m_code = number.min(u64::from(u32::MAX)) as u32;
        match codes::m_code(number) {
            Some(M::Spindle(SpindleTurn::Stopped)) => request.stop_spindle = true,
            Some(M::Spindle(turn)) => {
                state.spindle.turn = turn;
                // A spindle that turns is no axis.
                state.c_axis = false;
            }
            Some(M::LiveTool) => state.spindle.live_tool = true,
            Some(M::ThreadPullOut(switch)) => state.thread_chamfer_on = switch == Switch::On,
            Some(M::End) => request.end = true,
            Some(M::CAxis(switch)) => state.c_axis = switch == Switch::On,
            Some(M::Pause | M::Idle) => {}
            Some(M::Call) => request.passage = Some(Passage::Call),
            Some(M::LocalCall) => request.passage = Some(Passage::LocalCall),
            Some(M::Return) => request.passage = Some(Passage::Return),
            None => {
                state.unknown_m = true;
                self.tell(Diagnostic::new(Message::UnknownM { word: quote(text, word.span) }, word.span));
            }
        }
    }

    /// Coordinate systems, motion, cycles.
    fn act(&mut self, text: &[u8], block: &Block, request: &mut Request, words: &Words) {
        if let Some(mode) = request.motion {
            self.enter(mode, block, words);
        }
        if let Some(span) = request.extended_frame {
            self.extended_frame(text, request, words, span);
        }
        if let Some(hole) = request.hole {
            self.enter_hole(hole, block.words_span());
        }
        if request.macro_call.is_some() {
            return;
        }
        if let Some(one_shot) = request.one_shot {
            if one_shot != OneShot::Dwell {
                self.state.memory = CycleMemory { passes: self.state.memory.passes, ..CycleMemory::EMPTY };
            }
            if let (OneShot::Setting | OneShot::Data | OneShot::Dwell, Some(word)) =
                (one_shot, words.get(b'T'))
            {
                let message = Message::ToolWithSetting { word: quote(text, word.span) };
                // Old controls take T with G50; it was usual there.
                let taken = one_shot == OneShot::Setting && !self.dialect.strict;
                let severity = if taken { Severity::Warning } else { Severity::Error };
                self.tell(Diagnostic::new(message, word.span).graded(severity));
                if !taken {
                    request.drop = true;
                    return;
                }
            }
            if !self.may_stand_with_hole(text, block, one_shot) {
                request.drop = true;
                return;
            }
            match one_shot {
                OneShot::Dwell | OneShot::Polar(_) | OneShot::Cylinder => {}
                OneShot::Multiple(_) => self.arrive_for_cycle(),
                _ => self.leave_compensation(),
            }
            match one_shot {
                OneShot::Dwell => self.dwell(text, block, words, request),
                OneShot::Home | OneShot::OtherHome => self.home(text, block, request, words),
                OneShot::CheckHome => self.check_home(text, block, request, words),
                OneShot::FromHome => self.leave_home(text, block, request, words),
                OneShot::Machine => self.machine_move(block, request, words),
                OneShot::Data => self.write_data(text, request, words),
                OneShot::Setting => self.setting(words),
                OneShot::LocalFrame => self.local_frame(words),
                OneShot::Polar(switch) => self.polar(text, block, request, switch),
                OneShot::Cylinder => self.cylinder(text, block, request, words),
                OneShot::Multiple(cycle) => self.multiple(text, block, request, words, cycle),
                OneShot::NotSupported => self.state.uncertain = true,
            }
            return;
        }
        if self.state.hole.is_some() {
            self.hole(text, block, request, words);
            return;
        }
        const OTHER_AXES: u32 = letters(b"YV");
        if words.has_any(OTHER_AXES) && !matches!(self.state.motion, MotionMode::Cycle(_)) {
            self.other_axes(text, words);
        }
        if self.state.virtual_plane.is_some()
            && words.has_any(AXES | TURNS)
            && !self.may_move_in_plane(text, block, words)
        {
            request.drop = true;
            return;
        }
        match self.state.motion {
            MotionMode::Rapid if words.has_any(AXES | TURNS) => {
                self.settle_angle();
                if let Some(index) = request.comma.into_iter().flatten().next() {
                    let span = block.words[index].span;
                    self.tell(Diagnostic::new(Message::CornerNone { word: quote(text, span) }, span));
                    request.drop = true;
                    return;
                }
                let to = self.target(text, words);
                request.moved = words.has_any(AXES);
                let c = self.turn_target(words);
                if c.is_some() || !self.travel_plainly(block, MotionKind::Rapid, to, None) {
                    let motion = self.motion(MotionKind::Rapid, to);
                    let motion = self.turning(motion, c);
                    self.travel(block, motion, None);
                }
            }
            MotionMode::Line if words.has_any(AXES | TURNS | letters(b"A")) || request.comma[2].is_some() => {
                self.line(text, block, request, words);
            }
            MotionMode::Arc(turn) if words.has_any(AXES | TURNS | letters(b"IJKR")) => {
                self.arc(text, block, request, words, turn)
            }
            MotionMode::Thread | MotionMode::VariableThread | MotionMode::Tapping if words.has_any(AXES) => {
                self.thread(text, block, request, words);
            }
            MotionMode::Cycle(cycle) => self.cycle(text, block, request, words, cycle),
            _ => {}
        }
    }

    /// A code of group 01 comes into force.
    fn enter(&mut self, mode: MotionMode, block: &Block, words: &Words) {
        let state = &mut self.state;
        state.hole = None;
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

    fn not_supported(&mut self, text: &[u8], span: Span) {
        let what = format!("`{}`", shortened(&quote(text, span)));
        self.tell(Diagnostic::new(Message::NotSupported { what }, span));
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
            rotary: None,
            cycle: None,
            process: self.state.process(),
        }
    }

    /// Keeps a motion unless it has no length, and puts the tip at its end.
    #[inline]
    fn push(&mut self, block: &Block, motion: Motion) {
        self.emit(self.routed(block, motion));
        self.state.position = motion.to;
    }

    /// Keeps a motion unless it has no length.
    #[inline]
    fn emit(&mut self, mut routed: Routed) {
        if let Some(tip) = self.state.tip.take() {
            routed.motion.from = tip;
        }
        let motion = &routed.motion;
        let still = motion.from.is_same(motion.to)
            && motion.center.is_none()
            && motion.seconds.is_none()
            && motion.rotary.is_none()
            && routed.third.is_none_or(|(from, to)| from == to);
        if still || self.full {
            return;
        }
        if let Some(third) = routed.third {
            routed = self.on_machine(routed, third);
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
            self.tell(Diagnostic::new(message, block.words_span()));
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

/// The block as it is when the slash within it counts.
fn without_optional(block: &Block) -> Block {
    let mut rest = block.clone();
    if let Some((first, _)) = rest.optional.take() {
        rest.words.truncate(first);
    }
    rest
}

/// Whether a word only steers the program.
fn steers(word: &Word) -> bool {
    match word.address {
        b'M' => matches!(plain(word), Some(97.0 | 98.0 | 99.0 | 198.0)),
        b'G' => matches!(plain(word), Some(65.0 | 66.0 | 67.0)),
        _ => false,
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
