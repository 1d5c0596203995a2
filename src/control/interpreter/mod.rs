//! Blocks to motions: carries out one block after the other.
//!
//! In: blocks, the setup. Out: motions and messages. This is the only place that converts values to
//! millimetres and radii. An error drops the motion of its block and leaves the position unchanged. Later
//! motions are marked as uncertain until the values they depend on are known again.
//!
//! Order within a block: plane, unit and feed mode – G96/G97 with S – F – T – M03, M04 –
//! coordinate system – compensation – motion or cycle – M05, M00, M01, M02, M30.

pub(crate) mod block;
mod budget;
pub(crate) mod calls;
mod checks;
pub(crate) mod compensated;
pub(crate) mod contours;
mod core;
pub(crate) mod corner;
pub(crate) mod cycle_moves;
mod doubts;
pub(crate) mod holes;
mod loops;
mod macro_a;
mod macro_body;
mod macro_values;
pub(crate) mod macros;
mod motions;
mod multiples;
pub(crate) mod output;
pub(crate) mod path;
mod pecks;
mod plain_lines;
pub(crate) mod read_words;
mod reference;
pub(crate) mod repairs;
mod request;
mod rotary;
mod settings;
pub(crate) mod singles;
mod snapshot;
mod store;
mod system_values;
mod system_writes;
mod targets;
pub(crate) mod threads;
pub(crate) mod trace;
pub(crate) mod unread;
pub(crate) mod with_y;
pub(crate) mod y_axis;

#[cfg(test)]
mod tests;

use super::contour::Landmarks;
use super::events::{Event, Observer};
use super::modal::State;
use super::origins::{OriginRecord, OriginRecorder};
use super::program::Program;
use super::sink::Sink;
use super::words::letters;
use crate::message::Diagnostic;
use crate::motion::{Chunk, Motions};
use crate::parts::Part;
use crate::setup::Setup;
use crate::setup::dialect::{CodeList, Dialect, GSystem};
use crate::text::parser::Resume;
use crate::units::Unit;
use contours::Contours;

pub use snapshot::{RunTail, Snapshot};
pub use trace::{Context, Executed};

/// Words that move X or Z.
const AXES: u32 = letters(b"XZUW");

/// Addresses of the C axis.
const TURNS: u32 = letters(b"CH");

/// How the program continues after a block.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Flow {
    /// With the next block.
    Next,
    /// With the block at this position.
    Jump(Resume),
    /// Starts the run again with the program at this position: the program that ran first is only its
    /// subprogram.
    Restart(Resume),
    /// It has ended.
    End,
}

/// Position of a block in the text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BlockPosition {
    /// Start of the block.
    pub at: Resume,
    /// Start of the next block.
    pub next: Resume,
}

/// Runs blocks and collects the results.
pub struct Interpreter {
    setup: Setup,
    dialect: Dialect,
    /// The state of the control after the last block.
    pub state: State,
    /// Records which blocks set the state, if wanted.
    recorder: Option<Box<dyn OriginRecorder>>,
    /// Where to read next.
    program: Program,
    /// Motions and messages.
    sink: Sink,
    /// Contours read by G70 to G73.
    contours: Contours,
    /// The observer, if any.
    observer: Option<Box<dyn Observer>>,
    /// What the observer reports about the current event.
    reports: Vec<Diagnostic>,
    /// Something has happened since the last cut that may matter for the next one.
    cut_context_changed: bool,
    /// The executed blocks, in order, if a trace is wanted.
    trace: Option<Vec<Executed>>,
    /// A block was not carried out since this flag was last cleared.
    block_failed: bool,
    /// A value of the current block comes from a variable with an unknown value.
    uses_unknown_value: bool,
    /// A part of the module that a block needs and that is not loaded.
    missing: Option<Part>,
}

impl Interpreter {
    /// The part that the run needed and that was not loaded, if any.
    pub fn missing(&self) -> Option<Part> {
        self.missing
    }

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
            recorder: None,
            state,
            program: Program::default(),
            sink,
            contours: Contours::default(),
            observer: None,
            reports: Vec::new(),
            cut_context_changed: true,
            trace: None,
            block_failed: false,
            uses_unknown_value: false,
            missing: None,
        }
    }

    /// Sends events to `observer` from here on.
    pub fn with_observer(mut self, observer: Box<dyn Observer>) -> Self {
        self.observer = Some(observer);
        self
    }

    /// Starts to keep the executed blocks.
    pub fn keep_trace(&mut self) {
        self.trace.get_or_insert_default();
    }

    /// Takes the executed blocks.
    pub fn take_trace(&mut self) -> Vec<Executed> {
        self.trace.take().unwrap_or_default()
    }

    /// Whether executed blocks are kept.
    pub fn has_trace(&self) -> bool {
        self.trace.is_some()
    }

    /// Number of motions kept.
    pub fn kept_motions(&self) -> usize {
        self.sink.kept()
    }

    /// Motions of the finished chunks.
    pub fn motions(&self) -> &Motions {
        &self.sink.motions
    }

    /// Starts to record which block sets what, with a new recorder like `before`, if there is one.
    pub fn record_origins_like(&mut self, before: Option<&dyn OriginRecorder>) {
        self.recorder = before.map(|recorder| recorder.restarted(&self.state));
    }

    /// Starts to record which block sets what.
    pub fn begin_recording(&mut self) {
        self.recorder = Some(Box::new(OriginRecord::new(&self.state)));
    }

    /// The record of origins, if any.
    pub fn record_mut(&mut self) -> Option<&mut OriginRecord> {
        self.recorder.as_mut().map(|recorder| recorder.record_mut())
    }

    /// Records what the block at this byte has changed.
    #[inline]
    pub fn note_origins(&mut self, block: u32) {
        if let Some(recorder) = &mut self.recorder {
            recorder.note(&self.state, block);
        }
    }

    /// Messages in the order in which they were reported.
    pub fn diagnostics(&self) -> &[Diagnostic] {
        &self.sink.diagnostics
    }

    /// Takes the messages out of a run that no longer needs them.
    pub fn take_diagnostics(&mut self) -> Vec<Diagnostic> {
        std::mem::take(&mut self.sink.diagnostics)
    }

    /// Positions of the contour cycles that have run.
    pub fn landmarks(&self) -> &[Landmarks] {
        &self.contours.landmarks
    }

    /// Number of messages that were not kept.
    pub fn hidden(&self) -> usize {
        self.sink.hidden
    }

    /// The setup of the run.
    pub fn setup(&self) -> &Setup {
        &self.setup
    }

    /// Makes the waiting moves: the program has ended.
    pub fn finish(&mut self, text: &[u8]) {
        self.flush_pending();
        self.observe(text, Event::RunEnds);
    }

    /// Closes the last chunk, so that [`Interpreter::motions`] contains all motions.
    pub fn close(&mut self) {
        self.begin_chunk(Resume::default());
    }

    /// The motions.
    pub fn into_motions(self) -> Motions {
        self.sink.motions
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

    /// Switches to another G-code system.
    pub fn set_system(&mut self, system: GSystem) {
        self.dialect.g_system = system;
    }

    /// Switches to another unit, until a code sets one.
    pub fn set_unit(&mut self, unit: Unit) {
        self.dialect.unit = unit;
        self.state.unit = unit;
    }

    /// Starts the O program at this position: it becomes the main program, unless a call is active.
    pub fn enter_program(&mut self, head: Resume) {
        if self.state.call_stack.calls.is_empty() {
            self.state.call_stack.head = head;
        }
        self.program.enter(head);
    }

    /// Starts the program to run, which is not the first of the text.
    pub fn start_at_other_program(&mut self, head: Resume) {
        self.enter_program(head);
        self.program.start_at_other_program(head);
    }

    /// Whether the current program begins here.
    pub fn is_head(&self, at: Resume) -> bool {
        self.state.call_stack.program_head().byte == at.byte
    }

    /// Whether the program at this position has run.
    pub fn was_run(&self, at: Resume) -> bool {
        self.program.was_run(at)
    }

    /// Whether a program of the text calls program `number`.
    pub fn is_called(&mut self, text: &[u8], number: u32) -> bool {
        self.program.labels(text).is_called(number)
    }

    /// Whether a jump or call has left the linear order of the text.
    pub fn has_left_linear_order(&self) -> bool {
        self.program.has_left_linear_order()
    }
}
