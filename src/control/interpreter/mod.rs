//! Blocks to motions: what the control does with one block after the other.
//!
//! In: blocks, the setup. Out: motions and messages. Values become millimetres and radii here and nowhere
//! else. An error drops the motion of its block, the position stays, and later motions are marked uncertain until what they
//! depend on is known again.
//!
//! Order within a block: plane, unit and feed mode – G96/G97 with S – F – T – M03, M04 –
//! coordinate system – compensation – motion or cycle – M05, M00, M01, M02, M30.

mod block;
mod calls;
mod checks;
mod contours;
mod doubts;
mod holes;
mod macro_body;
mod macros;
mod motions;
mod multiples;
mod output;
mod path;
mod pecks;
mod reference;
mod rotary;
mod settings;
mod singles;
mod snapshot;
mod store;
mod system;
mod take;
mod threads;
mod trace;

use super::arcs::{self, CenterWords};
use super::codes::{self, Compensation, G, M, MacroCall, MotionMode, Multiple, Plane, Switch};
use super::contour::{Landmarks, Purpose};
use super::events::{Event, Moment, Observer};
use super::modal::{CycleMemory, Once, Routed, State, Target};
use super::program::Program;
use super::sink::Sink;
use super::words::{self, Reading, Words, letters, plain, quote};
use crate::cycles::single::{self, PullOut, Single};
use crate::cycles::{Contour, Move};
use crate::geometry::{Point, Turn};
use crate::message::{Diagnostic, Fix, Message, Severity};
use crate::motion::{
    Chunk, CycleStep, Feed, Motion, MotionKind, Motions, Process, SpindleTurn, Step, Stop, StopKind,
};
use crate::setup::Setup;
use crate::setup::dialect::{
    CodeList, Control, DecimalRule, Dialect, FeedMode, G71Retract, G73Intervals, G76Clamp, GSystem, IInG92,
    NegativeArcR, PqUnit, XuConflict,
};
use crate::source::Span;
use crate::text::block::{Block, BlockKind, Value, Word};
use crate::text::parser::Resume;
use crate::units::Unit;
use calls::Passage;
use contours::Contours;
use rotary::TURNS;

pub use calls::Here;
pub use snapshot::{Remainder, Snapshot};

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
    /// Feed, spindle and tool before it.
    pub before: Process,
    /// The same once its own words for them count, before it moves.
    pub ready: Process,
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

/// Groups of codes of which a block can have one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Exclusive {
    Motion,
    Surface,
    Feed,
    Compensation,
    /// M03, M04, M05.
    Spindle,
}

/// What the codes of one block ask for.
#[derive(Default)]
struct Request {
    one_shot: Option<OneShot>,
    /// Ten times the number of a G code that is not done here.
    unsupported: Option<u64>,
    /// A code of group 01 stands in the block.
    motion: Option<MotionMode>,
    /// G96 (true) or G97.
    surface: Option<bool>,
    /// M05.
    stop_spindle: bool,
    /// M00, M01.
    stop: Option<StopKind>,
    /// M02, M30.
    end: bool,
    /// An M code that only the machine knows.
    maker_m: bool,
    /// M97, M98, M99.
    passage: Option<Passage>,
    /// G65 or G66: the words after it are arguments.
    macro_call: Option<MacroCall>,
    /// A hole cycle stands in the block.
    hole: Option<codes::Hole>,
    /// G43: H names a length offset.
    length_offset: bool,
    /// G54.1, whose P names the frame.
    extended_frame: Option<Span>,
    /// The motion of the block is not carried out.
    drop: bool,
    /// The words met so far of the groups that are looked at (`Exclusive`), and their numbers.
    group_words: [Option<(u64, Span)>; 5],
    /// Indices of the words with a comma: `,C2`, `,R1`, `,A30`.
    comma: [Option<usize>; 3],
    /// The block made a move of the path.
    moved: bool,
    /// G40, G41 or G42 changes compensation.
    switches_compensation: bool,
}

impl Request {
    /// Whether a move of the block is of the kind that an earlier block names.
    fn goes_by_last_code(&self) -> bool {
        self.motion.is_none() && self.one_shot.is_none() && self.hole.is_none()
    }
}

/// Runs blocks and keeps what comes of them.
pub struct Interpreter {
    setup: Setup,
    dialect: Dialect,
    /// The state of the control after the last block.
    pub state: State,
    /// Where to read next.
    program: Program,
    /// Motions and messages.
    sink: Sink,
    /// Contours read by G70 to G73.
    contours: Contours,
    /// Who listens.
    observer: Option<Box<dyn Observer>>,
    /// What that one reports of the event under way.
    reports: Vec<Diagnostic>,
    /// Something has happened since the last cut that may matter for the next one.
    cut_is_news: bool,
    /// The blocks carried out, in order, if they are asked for.
    trace: Option<Vec<Executed>>,
    /// A block was not carried out since this was last looked at.
    refused: bool,
    /// A value of the block under way comes from a variable that nobody knows.
    guessing: bool,
}

impl Interpreter {
    /// A control at power-on.
    pub fn new(setup: Setup) -> Self {
        let dialect = Dialect::new(&setup.dialect);
        Self::of(setup, dialect)
    }

    fn of(setup: Setup, dialect: Dialect) -> Self {
        let state = State::new(&setup, &dialect);
        let chunk = Chunk::new(0, 0, state.position);
        let sink = Sink::new(setup.rules.clone(), setup.limits, chunk);
        Self {
            setup,
            dialect,
            state,
            program: Program::default(),
            sink,
            contours: Contours::default(),
            observer: None,
            reports: Vec::new(),
            cut_is_news: true,
            trace: None,
            refused: false,
            guessing: false,
        }
    }

    /// Whoever is to hear what happens from here on.
    pub fn observed_by(mut self, observer: Box<dyn Observer>) -> Self {
        self.observer = Some(observer);
        self
    }

    /// Something happens: what whoever listens reports of it is reported. `text`: empty where the event names no word.
    #[inline]
    fn observe(&mut self, text: &[u8], event: Event<'_>) {
        if self.observer.is_some() {
            self.cut_is_news |= event.matters_for_cuts();
            self.hear(text, &event);
        }
    }

    /// Another one listens from here on, for whom everything counts as reported that was; the one before.
    fn go_on_observed_by(&mut self, observer: Option<Box<dyn Observer>>) -> Option<Box<dyn Observer>> {
        self.cut_is_news = true;
        let mut before = std::mem::replace(&mut self.observer, observer);
        if let (Some(own), Some(before)) = (&mut self.observer, &mut before) {
            own.listen_after(before.as_mut());
        }
        before
    }

    #[inline(never)]
    fn hear(&mut self, text: &[u8], event: &Event<'_>) {
        let Self { observer, reports, state, setup, dialect, sink, contours, .. } = self;
        let Some(observer) = observer else { return };
        let at = Moment { text, state, setup, dialect, sink, contour: contours.purpose };
        observer.hear(event, &at, reports);
        if !self.reports.is_empty() {
            self.tell_reports();
        }
    }

    #[cold]
    fn tell_reports(&mut self) {
        for report in std::mem::take(&mut self.reports) {
            self.tell(report);
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
        &self.sink.motions
    }

    /// Messages so far, in the order in which they were reported.
    pub fn diagnostics(&self) -> &[Diagnostic] {
        &self.sink.diagnostics
    }

    /// Places of the contour cycles so far.
    pub fn landmarks(&self) -> &[Landmarks] {
        &self.contours.landmarks
    }

    /// Messages that were not kept.
    pub fn hidden(&self) -> usize {
        self.sink.hidden
    }

    /// The setup of the run.
    pub fn setup(&self) -> &Setup {
        &self.setup
    }

    /// Makes the moves that wait for a next one: the program has ended.
    pub fn finish(&mut self) {
        self.settle();
        self.observe(&[], Event::RunEnds);
    }

    /// Closes the last chunk, so that [`Interpreter::motions`] holds all motions.
    pub fn close(&mut self) {
        self.begin_chunk(Resume::default());
    }

    /// The motions.
    pub fn into_motions(self) -> Motions {
        self.sink.motions
    }

    /// Reports something to the user, unless it was reported for the same place before.
    pub fn tell(&mut self, diagnostic: Diagnostic) {
        if !self.sink.is_silent_about(&diagnostic) {
            // Which of them were reported before is not kept any more once the limit is reached.
            self.sink.report(diagnostic.in_unit(self.state.unit), self.program.has_jumped());
        }
    }

    /// What is reported for the setup: many faults of one kind have no other place than the beginning of the text.
    pub fn tell_of_setup(&mut self, diagnostic: Diagnostic) {
        self.sink.report_of_setup(diagnostic);
    }

    /// Reports, even when no more messages are kept: why the run ends.
    pub fn tell_always(&mut self, diagnostic: Diagnostic) {
        self.sink.report_always(diagnostic);
    }

    /// How numbers are read at the moment.
    pub fn reading(&self) -> Reading {
        Reading { unit: self.state.unit, decimal: self.dialect.decimal }
    }

    /// Reports that a word is recognised and not carried out here.
    fn not_supported(&mut self, text: &[u8], span: Span) {
        let what = format!("`{}`", shortened(&quote(text, span)));
        self.tell(Diagnostic::new(Message::NotSupported { what }, span));
    }

    /// The switches of the control.
    pub fn dialect(&self) -> &Dialect {
        &self.dialect
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
        if self.state.call_stack.calls.is_empty() {
            self.state.call_stack.head = head;
        }
        self.program.enter(head);
    }

    /// The program to run begins here, and is not the first of the text.
    pub fn begin_elsewhere(&mut self, head: Resume) {
        self.enter_program(head);
        self.program.begin_elsewhere(head);
    }

    /// Whether the program in force begins here.
    pub fn is_head(&self, at: Resume) -> bool {
        self.state.call_stack.program_head().byte == at.byte
    }

    /// Whether the program that begins here was run.
    pub fn was_run(&self, at: Resume) -> bool {
        self.program.was_run(at)
    }

    /// Whether a program of the text calls the one of a number.
    pub fn is_called(&mut self, text: &[u8], number: u32) -> bool {
        self.program.labels(text).is_called(number)
    }

    /// Whether the program has left the straight way through its text.
    pub fn has_wandered(&self) -> bool {
        self.program.has_jumped()
    }

    /// Reports what is wrong with the writing of a block that is not run.
    pub fn tell_faults(&mut self, block: &Block) {
        self.sink.fault = None;
        for fault in &block.faults {
            self.tell(fault.clone());
        }
        self.sink.fault = block.faults.first().map(|fault| fault.span);
    }
}

/// The head of a long quotation.
fn shortened(text: &str) -> String {
    const LONGEST: usize = 24;
    if text.chars().count() <= LONGEST {
        return text.to_owned();
    }
    text.chars().take(LONGEST - 1).collect::<String>() + "…"
}
