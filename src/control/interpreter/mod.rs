//! Blocks to motions: what the control does with one block after the other.
//!
//! In: blocks, the setup. Out: motions and messages. Values become millimetres and radii here and nowhere
//! else. An error drops the motion of its block, the position stays, and later motions are marked uncertain
//! until what they depend on is known again.
//!
//! Order within a block: plane, unit and feed mode – G96/G97 with S – F – T – M03, M04 –
//! coordinate system – compensation – motion or cycle – M05, M00, M01, M02, M30.

mod block;
pub(crate) mod calls;
mod checks;
mod compensated;
pub(crate) mod contours;
mod corner;
mod doubts;
pub(crate) mod holes;
mod macro_a;
mod macro_body;
pub(crate) mod macros;
mod motions;
mod multiples;
pub(crate) mod output;
pub(crate) mod path;
pub(crate) mod pecks;
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
mod system;
pub(crate) mod threads;
pub(crate) mod trace;
pub(crate) mod unread;
pub(crate) mod y_axis;

#[cfg(test)]
mod tests;

use super::contour::Landmarks;
use super::events::{Event, Moment, Observer};
use super::modal::State;
use super::origins::{Chronicle, Chronicler};
use super::program::Program;
use super::sink::Sink;
use super::words::{Reading, letters, quote};
use crate::message::{Diagnostic, said};
use crate::motion::{Chunk, Motions};
use crate::parts::Part;
use crate::setup::Setup;
use crate::setup::dialect::{CodeList, Dialect, GSystem};
use crate::source::Span;
use crate::text::block::Block;
use crate::text::parser::{READS_FAULTS, Resume};
use crate::units::Unit;
use contours::Contours;

pub use calls::Here;
pub use snapshot::{Remainder, Snapshot};
pub use trace::{Context, Executed};

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

/// Runs blocks and keeps what comes of them.
pub struct Interpreter {
    setup: Setup,
    dialect: Dialect,
    /// The state of the control after the last block.
    pub state: State,
    /// Who notes which block set what is in force.
    chronicler: Option<Box<dyn Chronicler>>,
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
    /// A part of the module that a block needs and that has not been loaded.
    missing: Option<Part>,
}

impl Interpreter {
    /// Whether a part has been loaded that a block needs; where it has not, nothing of this run can be used.
    fn has(&mut self, part: Part) -> bool {
        let is_loaded = part.is_loaded();
        if !is_loaded {
            self.missing = Some(part);
        }
        is_loaded
    }

    /// A part that the run needed and that had not been loaded.
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
            chronicler: None,
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
            missing: None,
        }
    }

    /// Whoever is to hear what happens from here on.
    pub fn observed_by(mut self, observer: Box<dyn Observer>) -> Self {
        self.observer = Some(observer);
        self
    }

    /// Something happens: what whoever listens reports of it is reported. `text`: empty
    /// where the event names no word.
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
            self.report_heard();
        }
    }

    #[cold]
    fn report_heard(&mut self) {
        for report in std::mem::take(&mut self.reports) {
            self.report(report);
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

    /// Motions kept so far.
    pub fn kept_motions(&self) -> usize {
        self.sink.kept()
    }

    /// Motions of the finished chunks.
    pub fn motions(&self) -> &Motions {
        &self.sink.motions
    }

    /// Notes from here on which block sets what; as one that noted it of another control at power-on, if there was one.
    pub fn chronicled_like(&mut self, before: Option<&dyn Chronicler>) {
        self.chronicler = before.map(|chronicler| chronicler.anew(&self.state));
    }

    /// Begins to note which block sets what is in force.
    pub fn begin_chronicle(&mut self) {
        self.chronicler = Some(Box::new(Chronicle::new(&self.state)));
    }

    /// Who notes it, if somebody does.
    pub fn chronicler(&self) -> Option<&dyn Chronicler> {
        self.chronicler.as_deref()
    }

    /// What was noted; nothing where nobody does.
    pub fn chronicle_mut(&mut self) -> Option<&mut Chronicle> {
        self.chronicler.as_mut().map(|chronicler| chronicler.chronicle_mut())
    }

    /// What is in force now was set by a block that begins at this byte, as far as it was not before.
    #[inline]
    pub fn note_origins(&mut self, block: u32) {
        if let Some(chronicler) = &mut self.chronicler {
            chronicler.note(&self.state, block);
        }
    }

    /// A block gives a variable a value. `level`: calls of macros under way.
    fn note_assigned(&mut self, level: usize, variable: u32, block: u32) {
        if let Some(chronicler) = &mut self.chronicler {
            chronicler.assigned(level, variable, block);
        }
    }

    /// Messages so far, in the order in which they were reported.
    pub fn diagnostics(&self) -> &[Diagnostic] {
        &self.sink.diagnostics
    }

    /// The messages, taken out of a run that needs them no more.
    pub fn take_diagnostics(&mut self) -> Vec<Diagnostic> {
        std::mem::take(&mut self.sink.diagnostics)
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
    pub fn finish(&mut self, text: &[u8]) {
        self.settle();
        self.observe(text, Event::RunEnds);
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
    pub fn report(&mut self, diagnostic: Diagnostic) {
        if !self.sink.is_silent_about(&diagnostic) {
            // Which of them were reported before is not kept any more once the limit is reached.
            self.sink.report(diagnostic.in_unit(self.state.unit), self.program.has_jumped());
        }
    }

    /// What is reported for the setup: many faults of one kind have no other place than
    /// the beginning of the text.
    pub fn report_of_setup(&mut self, diagnostic: Diagnostic) {
        self.sink.report_of_setup(diagnostic);
    }

    /// Reports, even when no more messages are kept: why the run ends.
    pub fn report_always(&mut self, diagnostic: Diagnostic) {
        self.sink.report_always(diagnostic);
    }

    /// How numbers are read at the moment.
    pub fn reading(&self) -> Reading {
        Reading { unit: self.state.unit, decimal: self.dialect.decimal }
    }

    /// Reports that a word is recognised and not carried out here.
    fn not_supported(&mut self, text: &[u8], span: Span) {
        let what = format!("`{}`", shortened(&quote(text, span)));
        self.report(Diagnostic::new(said::NotSupported { what }, span));
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

    /// Reads the program in another unit, until a code names one.
    pub fn set_unit(&mut self, unit: Unit) {
        self.dialect.unit = unit;
        self.state.unit = unit;
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
    pub fn report_faults(&mut self, block: &Block) {
        self.sink.fault = None;
        if block.is_unread {
            self.missing = Some(READS_FAULTS);
        }
        for fault in &block.faults {
            // In a loop most faults have been reported before.
            if !self.program.has_jumped() || self.sink.has_room_for(fault) {
                self.report(fault.clone());
            }
        }
        // Where the words are read as intended, their other faults are reported.
        let fault = block.faults.iter().find(|fault| fault.is_error() && block.is_broken());
        self.sink.fault = fault.map(|fault| fault.span);
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
