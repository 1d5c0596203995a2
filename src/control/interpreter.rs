//! Blocks to motions: what the control does with one block after the other.
//!
//! In: blocks, the setup. Out: motions and messages. Values become millimetres and radii here and nowhere
//! else. An error drops the motion of its block, the position stays, and later motions are marked uncertain.
//!
//! Order within a block (semantics §1.3): plane, unit and feed mode – G96/G97 with S – F – T – M03, M04 –
//! coordinate system – compensation – motion or cycle – M05, M00, M01, M02, M30.

use super::arcs::{self, CenterWords};
use super::codes::{self, Compensation, G, M, Plane, Switch};
use super::dialect::{Control, Dialect, FeedMode, IInG92, NegativeArcR, XuConflict};
use super::modal::{CycleMemory, MotionMode, Once, State, Target};
use super::setup::{Setup, Tool};
use super::words::{self, Reading, Words, letters, plain, quote};
use crate::cycles::Move;
use crate::cycles::single::{self, PullOut, Single};
use crate::diagnostics::{Diagnostic, Message, Severity};
use crate::geometry::{Point, Turn};
use crate::limits::Limits;
use crate::motion::{Chunk, CycleStep, Motion, MotionKind, Motions, SpindleTurn};
use crate::text::block::{Block, BlockKind, Value, Word};
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
    /// It has ended.
    End,
}

/// One-shot codes: they use up the words of their block.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum OneShot {
    Dwell,
    Home,
    Setting,
    LocalFrame,
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
    /// Groups met so far, as bits, and the word of group 01.
    groups: u32,
    group_words: [Span; 2],
    /// A word of a corner: `,C2`, `,R1`, `,A30`.
    corner: Option<Span>,
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

    /// Messages that were not kept.
    pub fn hidden(&self) -> usize {
        self.hidden
    }

    /// The setup of the run.
    pub fn setup(&self) -> &Setup {
        &self.setup
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
        if self.chunk.is_empty() || self.chunk.len() >= CHUNK {
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
        if request.stop_spindle {
            self.state.spindle.turn = SpindleTurn::Stopped;
            self.state.spindle.live_tool = false;
            self.state.told.forget(Once::SpindleStopped);
        }
        if request.end || self.full { Flow::End } else { Flow::Next }
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
            _ if word.comma => request.corner = Some(word.span),
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
        self.note_group(text, request, group, word.span);
        let state = &mut self.state;
        match code {
            G::Rapid => request.motion = Some(MotionMode::Rapid),
            G::Line => request.motion = Some(MotionMode::Line),
            G::Arc(turn) => request.motion = Some(MotionMode::Arc(turn)),
            G::Thread => request.motion = Some(MotionMode::Thread),
            G::Cycle(cycle) => request.motion = Some(MotionMode::Cycle(cycle)),
            G::Dwell => request.one_shot = Some(OneShot::Dwell),
            G::Home => request.one_shot = Some(OneShot::Home),
            G::Setting => request.one_shot = Some(OneShot::Setting),
            G::LocalFrame => request.one_shot = Some(OneShot::LocalFrame),
            G::Plane(plane) => state.plane = plane,
            G::Unit(unit) => state.unit = unit,
            G::Compensation(compensation) => {
                state.compensation = compensation;
                state.told.forget(Once::CompensationIdle);
            }
            G::Frame(frame) => {
                state.change_frame(|frames| frames.active = frame);
                state.memory = CycleMemory::EMPTY;
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
                request.one_shot = Some(OneShot::NotYet);
                self.not_yet(text, word.span);
            }
            G::MotionNotYet => {
                request.motion = Some(MotionMode::NotYet);
                self.not_yet(text, word.span);
            }
        }
    }

    /// Two different codes of one group in a block: the last is valid.
    fn note_group(&mut self, text: &[u8], request: &mut Request, group: u8, span: Span) {
        if group == 0 {
            return;
        }
        let bit = 1 << group;
        // Only the group of motions keeps its word to compare; the others are rarely met twice.
        if request.groups & bit != 0 && group == 1 && quote(text, request.group_words[1]) != quote(text, span)
        {
            let (dropped, used) = (quote(text, request.group_words[1]), quote(text, span));
            self.tell(Diagnostic::new(Message::SameGroup { dropped, used }, span));
        }
        request.groups |= bit;
        if group == 1 {
            request.group_words[1] = span;
        }
    }

    fn take_m(&mut self, text: &[u8], request: &mut Request, number: u64, word: &Word) {
        let state = &mut self.state;
        match codes::m_code(number) {
            Some(M::Spindle(SpindleTurn::Stopped)) => request.stop_spindle = true,
            Some(M::Spindle(turn)) => state.spindle.turn = turn,
            Some(M::LiveTool) => state.spindle.live_tool = true,
            Some(M::ThreadPullOut(switch)) => state.thread_chamfer_on = switch == Switch::On,
            Some(M::End) => {
                request.end = true;
                state.compensation = Compensation::Off;
            }
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

    /// S, F and T, with what G96, G97 and G50 make of S.
    #[inline]
    fn technology(&mut self, text: &[u8], request: &Request, words: &Words) {
        const TECHNOLOGY: u32 = letters(b"FST");
        if request.surface.is_none() && !words.has_any(TECHNOLOGY) {
            return;
        }
        let reading = self.reading();
        let setting = request.one_shot == Some(OneShot::Setting);
        if let Some(surface) = request.surface {
            self.surface_speed(surface, words);
        }
        if let Some(value) = words.get(b'S').filter(|_| !setting).and_then(plain) {
            let spindle = &mut self.state.spindle;
            if spindle.surface {
                spindle.cutting_speed = value;
            } else {
                spindle.rpm = value;
            }
        }
        if let Some(value) = words.get(b'F').and_then(|word| reading.feed(word)) {
            self.state.feed = Some(value);
            self.state.feed_is_old = false;
            self.state.threads_per_inch = None;
        }
        if let Some(word) = words.get(b'T') {
            self.tool(text, word);
        }
    }

    fn surface_speed(&mut self, surface: bool, words: &Words) {
        let radius = self.state.position.x;
        let spindle = &mut self.state.spindle;
        if !surface && spindle.surface && words.get(b'S').is_none() {
            // G97 without S keeps the speed that was reached last.
            spindle.rpm = spindle.speed_at(radius).unwrap_or(spindle.rpm);
        }
        let begins = surface && !spindle.surface;
        spindle.surface = surface;
        if begins && spindle.highest.is_none() {
            self.tell(Diagnostic::new(Message::NoSpeedClamp, words.span(b'S')));
        }
    }

    /// The T word: station and offset (semantics §8.2).
    fn tool(&mut self, text: &[u8], word: &Word) {
        let Value::Number { number, .. } = word.value else { return };
        let digits = word.span.of(text).iter().filter(|byte| byte.is_ascii_digit()).count();
        let value = number.mantissa;
        let (station, offset) = match digits {
            0..=2 => (0, value),
            3 | 4 => (value / 100, value % 100),
            _ => (value / 1000, value % 1000),
        };
        if digits <= 2 && value > 0 {
            let message = Message::ShortTool { word: quote(text, word.span), offset: offset as u16 };
            self.tell(Diagnostic::new(message, word.span));
        }
        if station > 999 {
            self.tell(Diagnostic::new(Message::ToolNumber { word: quote(text, word.span) }, word.span));
            return;
        }
        let station = if digits <= 2 { self.state.tool.0 } else { station as u16 };
        self.state.tool = (station, offset as u16);
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
                OneShot::Dwell => self.dwell(text, block, words, request),
                OneShot::Home => self.home(text, block, words),
                OneShot::Setting => self.setting(words),
                OneShot::LocalFrame => self.local_frame(words),
                OneShot::NotYet => self.state.uncertain = true,
            }
            return;
        }
        const OTHER_AXES: u32 = letters(b"YVCH");
        if words.has_any(OTHER_AXES) {
            self.other_axes(text, request, words);
        }
        match self.state.motion {
            MotionMode::Rapid if words.has_any(AXES) => {
                let to = self.target(text, words);
                self.watch_compensation(text, block);
                self.go(block, MotionKind::Rapid, to);
            }
            MotionMode::Line if words.has_any(AXES) => {
                let to = self.target(text, words);
                if self.may_cut(block, words, request) {
                    self.corner(text, request, words);
                    self.go(block, MotionKind::Feed, to);
                }
            }
            MotionMode::Arc(turn) if words.has_any(AXES | letters(b"IK")) => {
                self.arc(text, block, request, words, turn)
            }
            MotionMode::Thread if words.has_any(AXES) => self.thread(text, block, request, words),
            MotionMode::Cycle(cycle) => self.cycle(text, block, request, words, cycle),
            MotionMode::NotYet if words.has_any(AXES) => self.state.uncertain = true,
            _ if request.corner.is_some() => self.corner(text, request, words),
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

    /// The end point that X, U, Z and W name.
    #[inline]
    fn target(&mut self, text: &[u8], words: &Words) -> Point {
        let from = self.state.position;
        let x = self.axis(text, words, b'X', b'U', 0.5);
        let z = self.axis(text, words, b'Z', b'W', 1.0);
        Point::new(x.from(from.x), z.from(from.z))
    }

    /// What the absolute and the incremental word of an axis say; `scale` turns a diameter into a radius.
    #[inline]
    fn axis(&mut self, text: &[u8], words: &Words, absolute: u8, incremental: u8, scale: f64) -> Target {
        let reading = self.reading();
        let (a, i) = (words.get(absolute), words.get(incremental));
        let value = |word: &Word| reading.length(word).map_or(0.0, |value| value * scale);
        match (a, i) {
            (Some(a), None) => Target::Absolute(value(a)),
            (None, Some(i)) => Target::Incremental(value(i)),
            (None, None) => Target::Stay,
            (Some(a), Some(i)) => self.conflict(text, a, i, scale),
        }
    }

    /// X with U, or Z with W: which one counts.
    #[cold]
    fn conflict(&mut self, text: &[u8], a: &Word, i: &Word, scale: f64) -> Target {
        let reading = self.reading();
        let value = |word: &Word| reading.length(word).map_or(0.0, |value| value * scale);
        let absolute_counts = match self.dialect.xu_conflict {
            XuConflict::Absolute => true,
            XuConflict::Last => a.span.start > i.span.start,
        };
        let (absolute, incremental) = (quote(text, a.span), quote(text, i.span));
        let used = if absolute_counts { absolute.clone() } else { incremental.clone() };
        let span = a.span.to(i.span);
        self.tell(Diagnostic::new(Message::AbsoluteAndIncremental { absolute, incremental, used }, span));
        if absolute_counts { Target::Absolute(value(a)) } else { Target::Incremental(value(i)) }
    }

    /// Y, V, C and H: told once.
    fn other_axes(&mut self, text: &[u8], request: &mut Request, words: &Words) {
        // C on a G01 block may be a chamfer, which `corner` answers.
        let is_line = self.state.motion == MotionMode::Line;
        for address in [b'Y', b'V', b'H', b'C'] {
            if words.get(address).is_some() && !(address == b'C' && is_line) {
                if self.state.told.first(Once::AxisNotYet) {
                    self.not_yet(text, words.span(address));
                }
                // The motion of X and Z is drawn all the same.
                self.state.uncertain = true;
                request.corner = None;
            }
        }
    }

    /// Chamfers, rounded corners and angles: the move to the programmed corner is drawn.
    fn corner(&mut self, text: &[u8], request: &Request, words: &Words) {
        const CORNER: u32 = letters(b"CRIKALD");
        if request.corner.is_none() && !words.has_any(CORNER) {
            return;
        }
        let gsk = self.dialect.control == Control::Gsk;
        let addresses: &[u8] = if gsk { b"CRIKALD" } else { b"CRIKA" };
        let word = addresses.iter().find_map(|&letter| words.get(letter)).map(|word| word.span);
        if let Some(span) = request.corner.or(word) {
            if self.state.told.first(Once::CornerNotYet) {
                self.not_yet(text, span);
            }
            self.state.uncertain = true;
        }
    }

    fn arc(&mut self, text: &[u8], block: &Block, request: &mut Request, words: &Words, turn: Turn) {
        if self.state.plane != Plane::Zx {
            if self.state.told.first(Once::PlaneNotYet) {
                let what = if self.state.plane == Plane::Xy { "`G17`" } else { "`G19`" };
                self.tell(Diagnostic::new(Message::NotYet { what: what.into() }, block.words_span()));
            }
            request.drop = true;
            return;
        }
        let reading = self.reading();
        let code = if turn == Turn::Clockwise { "G02" } else { "G03" };
        let given = |address: u8| words.get(address).and_then(|word| reading.length(word));
        let center_words = match (given(b'R'), given(b'I'), given(b'K')) {
            (Some(radius), ..) => CenterWords::Radius(radius),
            (None, None, None) => {
                self.tell(Diagnostic::new(Message::ArcNoCenter { code }, block.words_span()));
                request.drop = true;
                return;
            }
            (None, i, k) => CenterWords::Offset { i: i.unwrap_or(0.0), k: k.unwrap_or(0.0) },
        };
        if let CenterWords::Radius(radius) = center_words
            && radius < 0.0
            && self.dialect.negative_arc_r == NegativeArcR::Alarm
        {
            self.tell(Diagnostic::new(Message::ArcRadiusNegative { radius }, words.span(b'R')));
            request.drop = true;
            return;
        }
        let to = self.target(text, words);
        if !self.may_cut(block, words, request) {
            return;
        }
        self.watch_compensation(text, block);
        let (kind, from) = match turn {
            Turn::Clockwise => (MotionKind::ArcClockwise, self.state.position),
            Turn::Counterclockwise => (MotionKind::ArcCounterclockwise, self.state.position),
        };
        match arcs::center(from, to, turn, center_words) {
            Ok(Some(center)) => self.push(block, Motion { center: Some(center), ..self.motion(kind, to) }),
            Ok(None) => self.tell(Diagnostic::new(Message::ArcNowhere, block.words_span())),
            Err(message) => {
                self.tell(Diagnostic::new(message, block.words_span()));
                request.drop = true;
            }
        }
    }

    /// G32: one thread cut (semantics §3.5).
    fn thread(&mut self, text: &[u8], block: &Block, request: &mut Request, words: &Words) {
        let to = self.target(text, words);
        let Some(lead) = self.lead(block, words, "G32") else {
            request.drop = true;
            return;
        };
        self.watch_thread(text, block, words, "G32");
        let reading = self.reading();
        let gsk = self.dialect.control == Control::Gsk;
        let given = |address: u8| words.get(address).filter(|_| gsk).and_then(|word| reading.length(word));
        let from = self.state.position;
        let ends = match (given(b'J'), given(b'K')) {
            (None, None) => [Some(to), None],
            (j, k) => {
                let (out, along) = (j.or(k).unwrap_or(0.0), k.or(j).unwrap_or(0.0));
                gsk_pull_out(from, to, out, along)
            }
        };
        for end in ends.into_iter().flatten() {
            let motion = Motion { lead: Some(lead), ..self.motion(MotionKind::Thread, end) };
            self.push(block, motion);
        }
    }

    /// The lead of a thread, mm.
    fn lead(&mut self, block: &Block, words: &Words, code: &'static str) -> Option<f64> {
        let reading = self.reading();
        if self.dialect.i_in_g92 == IInG92::Tpi
            && let Some(threads) = words.get(b'I').and_then(plain).filter(|&threads| threads > 0.0)
        {
            self.state.threads_per_inch = Some(threads);
        }
        let by_e = words.get(b'E').and_then(|word| reading.feed(word));
        let by_inch = self.state.threads_per_inch.map(|threads| 25.4 / threads);
        let lead = by_e.or(by_inch).or(self.state.feed).filter(|&lead| lead > 0.0);
        if lead.is_none() {
            self.tell(Diagnostic::new(Message::LeadMissing { code }, block.words_span()));
        }
        lead
    }

    /// G90, G92, G94 (semantics §6).
    fn cycle(&mut self, text: &[u8], block: &Block, request: &mut Request, words: &Words, cycle: Single) {
        let reading = self.reading();
        let taper = self.taper_word(words, cycle).and_then(|address| words.get(address));
        if let Some(value) = taper.and_then(|word| reading.length(word)) {
            self.state.memory.taper = value;
        }
        if cycle == Single::Threading
            && words.get(b'I').is_some()
            && self.state.told.first(Once::LetterIInG92)
        {
            let as_taper = self.dialect.i_in_g92 == IInG92::Taper;
            self.tell(Diagnostic::new(Message::LetterIInG92 { as_taper }, words.span(b'I')));
        }
        if !words.has_any(AXES) {
            return;
        }
        match self.axis(text, words, b'X', b'U', 0.5) {
            Target::Stay => {}
            target => self.state.memory.x = target,
        }
        match self.axis(text, words, b'Z', b'W', 1.0) {
            Target::Stay => {}
            target => self.state.memory.z = target,
        }
        let start = self.state.position;
        let memory = self.state.memory;
        let end = Point::new(memory.x.from(start.x), memory.z.from(start.z));
        let taper_span = taper.map_or_else(|| block.words_span(), |word| word.span);
        if !self.taper_fits(cycle, start, end, taper_span) {
            request.drop = true;
            return;
        }
        let lead = match cycle {
            Single::Threading => {
                let Some(lead) = self.lead(block, words, "G92") else {
                    request.drop = true;
                    return;
                };
                self.watch_thread(text, block, words, "G92");
                Some(lead)
            }
            Single::Turning | Single::Facing => {
                if !self.may_cut(block, words, request) {
                    return;
                }
                self.watch_cycle_compensation(text, block, cycle);
                None
            }
        };
        for _ in 0..self.starts(words, cycle) {
            self.state.memory.passes += 1;
            let pass = self.state.memory.passes;
            match (cycle, lead) {
                (Single::Threading, Some(lead)) => {
                    let moves = single::threading(start, end, memory.taper, self.pull_out(words, lead));
                    self.run_moves(block, cycle, pass, Some(lead), &moves);
                }
                (Single::Facing, _) => {
                    self.run_moves(block, cycle, pass, None, &single::facing(start, end, memory.taper));
                }
                _ => self.run_moves(block, cycle, pass, None, &single::turning(start, end, memory.taper)),
            }
        }
    }

    /// The letter that holds the taper in a block of a cycle: R, or its older spelling.
    fn taper_word(&self, words: &Words, cycle: Single) -> Option<u8> {
        let old = match cycle {
            Single::Turning => Some(b'I'),
            Single::Facing => Some(b'K'),
            Single::Threading => (self.dialect.i_in_g92 == IInG92::Taper).then_some(b'I'),
        };
        [Some(b'R'), old].into_iter().flatten().find(|&address| words.get(address).is_some())
    }

    /// Checks the taper against the start point and, where a blank is known, against the drawing.
    fn taper_fits(&mut self, cycle: Single, start: Point, end: Point, span: Span) -> bool {
        let taper = self.state.memory.taper;
        let (way, limit, axis) = match cycle {
            Single::Turning | Single::Threading => (end.x - start.x, 2.0 * (end.x - start.x), 'U'),
            Single::Facing => (end.z - start.z, end.z - start.z, 'W'),
        };
        if single::begins_beyond_start(way, taper) {
            // GSK states it as an error (seed 000); no FANUC alarm is known for it.
            let error = self.dialect.control == Control::Gsk || self.dialect.strict;
            let severity = if error { Severity::Error } else { Severity::Warning };
            let message = Message::TaperBeyondStart { taper, limit, axis };
            self.tell(Diagnostic::new(message, span).graded(severity));
            return !error;
        }
        if let Some(stock) = self.setup.stock
            && let Some(message) =
                crate::diagnostics::rules::taper_not_extended(cycle, start, end, taper, stock)
        {
            self.tell(Diagnostic::new(message, span));
        }
        true
    }

    /// How often a G92 pass is cut: once, or for each start (GSK L).
    fn starts(&self, words: &Words, cycle: Single) -> u64 {
        let several = cycle == Single::Threading && self.dialect.control == Control::Gsk;
        let starts = words.get(b'L').filter(|_| several).and_then(plain);
        starts.map_or(1, |starts| starts.clamp(1.0, 99.0) as u64)
    }

    /// How G92 leaves the thread: J and K (GSK), or the chamfer in tenths of a lead.
    fn pull_out(&self, words: &Words, lead: f64) -> Option<PullOut> {
        let reading = self.reading();
        let gsk = self.dialect.control == Control::Gsk;
        let given = |address: u8| words.get(address).filter(|_| gsk).and_then(|word| reading.length(word));
        match (given(b'J'), given(b'K')) {
            (None, None) => {
                let length = 0.1 * f64::from(self.state.thread_chamfer) * lead;
                (self.state.thread_chamfer_on && length > 0.0)
                    .then_some(PullOut { along: length, out: length })
            }
            (j, k) => {
                let (j, k) = (j.map(f64::abs), k.map(f64::abs));
                Some(PullOut { along: k.or(j).unwrap_or(0.0), out: j.or(k).unwrap_or(0.0) })
            }
        }
    }

    fn run_moves(&mut self, block: &Block, cycle: Single, pass: u32, lead: Option<f64>, moves: &[Move]) {
        for step in moves {
            let tag = CycleStep { cycle: cycle.cycle(), pass, step: step.step };
            let motion = Motion { cycle: Some(tag), lead, ..self.motion(step.kind, step.to) };
            self.push(block, motion);
        }
    }

    /// Checks before a cut at feed: whether there is a feed, and what a teacher would remark.
    #[inline]
    fn may_cut(&mut self, block: &Block, words: &Words, request: &mut Request) -> bool {
        let Some(feed) = self.state.feed.filter(|&feed| feed > 0.0) else {
            self.tell(Diagnostic::new(Message::FeedMissing, block.words_span()));
            request.drop = true;
            return false;
        };
        if words.has_any(letters(b"F")) {
            let per_turn = self.state.feed_mode == FeedMode::PerTurn;
            let mixed_up = if per_turn { feed >= 5.0 } else { feed < 2.0 };
            if mixed_up && self.state.told.first(Once::FeedUnit) {
                self.tell(Diagnostic::new(Message::FeedUnit { feed, per_turn }, words.span(b'F')));
            }
        } else if self.state.feed_is_old {
            self.state.feed_is_old = false;
            let per_turn = self.state.feed_mode == FeedMode::PerTurn;
            self.tell(Diagnostic::new(Message::FeedNotRepeated { feed, per_turn }, block.words_span()));
        }
        self.watch_spindle(block);
        true
    }

    #[inline]
    fn watch_spindle(&mut self, block: &Block) {
        let spindle = &self.state.spindle;
        if spindle.turn == SpindleTurn::Stopped
            && !spindle.live_tool
            && self.state.told.first(Once::SpindleStopped)
        {
            self.tell(Diagnostic::new(Message::SpindleStopped, block.words_span()));
        }
    }

    fn watch_thread(&mut self, text: &[u8], block: &Block, words: &Words, code: &'static str) {
        self.watch_spindle(block);
        if self.state.spindle.surface && self.state.told.first(Once::ThreadAtSurfaceSpeed) {
            self.tell(Diagnostic::new(Message::ThreadAtSurfaceSpeed { code }, block.words_span()));
        }
        if self.state.compensation != Compensation::Off && self.state.told.first(Once::CompensationIdle) {
            self.tell(Diagnostic::new(Message::CompensationIdle { code }, block.words_span()));
        }
        if let Some(word) = words.get(b'Q')
            && let Value::Number { number, .. } = word.value
            && number.has_point()
            && self.dialect.control != Control::Forum
        {
            let message = Message::PointNotAllowed { word: quote(text, word.span) };
            self.tell(Diagnostic::new(message, word.span));
        }
    }

    fn watch_cycle_compensation(&mut self, text: &[u8], block: &Block, cycle: Single) {
        if self.state.compensation == Compensation::Off {
            return;
        }
        if self.nose_radius() > 0.0 {
            self.watch_compensation(text, block);
        } else if self.state.told.first(Once::CompensationIdle) {
            self.tell(Diagnostic::new(
                Message::CompensationIdle { code: cycle.cycle().code() },
                block.words_span(),
            ));
        }
    }

    /// Compensation with a radius would shift the path, which is not done yet; without one it changes nothing.
    #[inline]
    fn watch_compensation(&mut self, _text: &[u8], block: &Block) {
        if self.state.compensation == Compensation::Off || self.nose_radius() == 0.0 {
            return;
        }
        if self.state.told.first(Once::CompensationNotYet) {
            let what = if self.state.compensation == Compensation::Left { "`G41`" } else { "`G42`" };
            self.tell(Diagnostic::new(Message::NotYet { what: what.into() }, block.words_span()));
        }
        self.state.uncertain = true;
    }

    /// Radius of the nose or cutter in force, mm; 0 without an offset.
    fn nose_radius(&self) -> f64 {
        let (station, offset) = self.state.tool;
        if offset == 0 {
            return 0.0;
        }
        let tool: Option<&Tool> = self.setup.tools.get(&format!("T{station:02}{offset:02}"));
        tool.map_or(0.0, |tool| tool.tool_radius.or(tool.geometry_r).unwrap_or(tool.nose_radius))
    }

    /// G04.
    fn dwell(&mut self, text: &[u8], block: &Block, words: &Words, request: &mut Request) {
        let reading = self.reading();
        let by_seconds = words.get(b'X').or(words.get(b'U')).and_then(|word| reading.seconds(word));
        if let Some(word) = words.get(b'P')
            && let Value::Number { number, .. } = word.value
            && number.has_point()
            && self.dialect.control != Control::Forum
        {
            self.tell(Diagnostic::new(Message::PointNotAllowed { word: quote(text, word.span) }, word.span));
            request.drop = true;
            return;
        }
        let by_milliseconds = words.get(b'P').and_then(plain).map(|value| value / 1000.0);
        match by_seconds.or(by_milliseconds) {
            Some(seconds) if seconds > 0.0 => {
                let motion = self.motion(MotionKind::Dwell, self.state.position);
                self.push(block, Motion { seconds: Some(seconds), ..motion });
            }
            Some(_) => {}
            None => self.tell(Diagnostic::new(Message::DwellNoTime, block.words_span())),
        }
    }

    /// G28: over the intermediate point to the reference point (semantics §3.8).
    fn home(&mut self, text: &[u8], block: &Block, words: &Words) {
        if words.has_any(letters(b"CHYV")) && self.state.told.first(Once::AxisNotYet) {
            let address = *b"CHYV".iter().find(|&&address| words.get(address).is_some()).unwrap_or(&b'C');
            self.not_yet(text, words.span(address));
        }
        if !words.has_any(AXES) {
            if !words.has_any(letters(b"CHYV")) {
                self.tell(Diagnostic::new(Message::G28NoAxis, block.words_span()));
            }
            return;
        }
        let middle = self.target(text, words);
        self.go(block, MotionKind::Rapid, middle);
        let (offset, home) = (self.state.frames.offset(), self.dialect.ref_point);
        let from = self.state.position;
        let to = Point::new(
            if words.has_any(letters(b"XU")) { home.x / 2.0 - offset.x } else { from.x },
            if words.has_any(letters(b"ZW")) { home.z - offset.z } else { from.z },
        );
        self.go(block, MotionKind::Rapid, to);
    }

    /// G50: coordinate setting and speed limits (semantics §3.9).
    fn setting(&mut self, words: &Words) {
        let reading = self.reading();
        let length = |address: u8| words.get(address).and_then(|word| reading.length(word));
        let at = self.state.position;
        let x = length(b'X').map(|x| x / 2.0).or(length(b'U').map(|u| at.x + u / 2.0));
        let z = length(b'Z').or(length(b'W').map(|w| at.z + w));
        let (to_x, to_z) = (x.unwrap_or(at.x), z.unwrap_or(at.z));
        self.state.frames.shift.x += at.x - to_x;
        self.state.frames.shift.z += at.z - to_z;
        self.state.position = Point::new(to_x, to_z);
        let spindle = &mut self.state.spindle;
        if let Some(highest) = words.get(b'S').and_then(plain) {
            spindle.highest = Some(highest);
        }
        if let Some(lowest) = words.get(b'Q').and_then(plain) {
            spindle.lowest = Some(lowest);
        }
        if let (Some(lowest), Some(highest)) = (spindle.lowest, spindle.highest)
            && lowest > highest
        {
            self.tell(Diagnostic::new(Message::ClampReversed { lowest, highest }, words.span(b'Q')));
        }
    }

    /// G52: local shift of the frame in force; X0 Z0 takes it away.
    fn local_frame(&mut self, words: &Words) {
        let reading = self.reading();
        let length = |address: u8| words.get(address).and_then(|word| reading.length(word));
        let (x, z) = (length(b'X').map(|x| x / 2.0), length(b'Z'));
        self.state.change_frame(|frames| {
            let local = &mut frames.local[frames.active as usize];
            *local = Point::new(x.unwrap_or(local.x), z.unwrap_or(local.z));
        });
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
        let still = motion.from.is_same(motion.to) && motion.center.is_none() && motion.seconds.is_none();
        if still || self.full {
            return;
        }
        if self.motions.len() + self.chunk.len() >= self.limits.motions {
            self.full = true;
            self.tell(Diagnostic::new(Message::TooManyMotions { most: self.limits.motions }, block.span));
            return;
        }
        self.chunk.push(&motion, block.span, block.line);
        self.state.position = motion.to;
    }
}

/// Pull-out of GSK's G32: K along the long axis (unsigned), J along the short one (signed, a radius for X).
fn gsk_pull_out(from: Point, to: Point, out: f64, along: f64) -> [Option<Point>; 2] {
    let (way_x, way_z) = (to.x - from.x, to.z - from.z);
    let long = way_x.abs().max(way_z.abs());
    if long == 0.0 {
        return [Some(to), None];
    }
    let part = (along.abs() / long).min(1.0);
    let leave = Point::new(to.x - part * way_x, to.z - part * way_z);
    let end = if way_z.abs() >= way_x.abs() {
        Point::new(leave.x + out, to.z)
    } else {
        Point::new(to.x, leave.z + out)
    };
    [Some(leave), Some(end)]
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
