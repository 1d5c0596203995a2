//! One run of a program, from its text to motions and messages, in slices that can be spread over time.
//!
//! In: the bytes of a program and a setup. Out: an [`Analysis`]. Knows the order of the stages, but not what
//! they do.

mod combined;
pub(crate) mod edit;
pub(crate) mod repeated;
pub mod replay;
pub mod subprograms;
mod tried;

use std::collections::BTreeMap;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, OnceLock};

use crate::control::contour::Landmarks;
use crate::control::events::Observer;
use crate::control::interpreter::{BlockPosition, Executed, Flow, Interpreter};
use crate::control::modal::State;
use crate::control::program::Labels;
use crate::control::words;
use crate::findings;
use crate::lint;
use crate::machine::resolved_setup::ResolvedSetup;
use crate::machine::{SimulationResult, detector};
use crate::message::{Diagnostic, Fix, said, sort_by_place};
use crate::motion::Motions;
use crate::parts::{Part, late};
use crate::provenance::{self, DecimalEvidence, Foreign, NumberWithoutPoint, QuickCheck, Target};
use crate::setup::dialect::{CodeList, DecimalChoice, DecimalRule, Dialect, DialectChoice, GSystem};
use crate::setup::ignored::{IgnoreComments, Ran};
use crate::setup::notes::Notes;
use crate::setup::{Lints, Setup, tool_words};
use crate::source::Span;
use crate::text::block::{Block, BlockKind};
use crate::text::lexer::is_between_blocks;
use crate::text::parser::{LEADER, Parser, READS_FAULTS, Resume};
use crate::units::Unit;
use edit::{Checkpoint, PreviousRun};
use repeated::FaultyBlocks;

/// The result of a run: motions, messages and the setup that applied.
#[derive(Clone, Debug, Default)]
pub struct Analysis {
    /// All motions in order.
    pub motions: Motions,
    /// All messages, sorted by place.
    pub diagnostics: Vec<Diagnostic>,
    /// Blocks read, including repeated ones; empty blocks are not counted.
    pub blocks: usize,
    /// The executed blocks, in order, if the run recorded a trace.
    pub trace: Vec<Executed>,
    /// The G codes the program was read with.
    pub codes: CodeList,
    /// The setup of the run: the given one, with the additions of the text and the decimal rule that was
    /// decided.
    pub setup: Setup,
    /// Whether the decimal rule was inferred from the text rather than set by the setup.
    pub decides_decimal: bool,
    /// Whether inches were inferred from the text, without a code that selects them.
    pub concludes_inches: bool,
    /// The unit of length at the end of the program.
    pub unit: Unit,
    /// The comments of the text that hide messages.
    ignored: IgnoreComments,
    /// Tools and blank; computed on first use.
    resolved: OnceLock<ResolvedSetup>,
}

impl Analysis {
    /// Tools and blank: given by the setup, or inferred from the motions. Computed on the first call and
    /// cached, so setup and motions must not change after that.
    pub fn resolved_setup(&self) -> &ResolvedSetup {
        self.resolved.get_or_init(|| ResolvedSetup::new(&self.motions, &self.setup))
    }

    /// Simulates the machining of the whole program.
    pub fn simulate(&self) -> SimulationResult {
        SimulationResult::of_resolved(self.resolved_setup().clone(), &self.motions, &self.setup)
    }

    /// Adds the messages about the machine: collisions, where a blank or a machine is given to check against,
    /// and unknown tools; and those about comments that hide no message.
    pub fn check_at_machine(&mut self) {
        let told = &self.diagnostics;
        let mut found = machine_messages(self.resolved_setup(), &self.setup, &self.motions, told);
        self.ignored.hide_at_machine(&mut found);
        self.diagnostics.extend(found.into_iter().map(|found| found.in_unit(self.unit)));
        sort_by_place(&mut self.diagnostics);
    }

    /// Removes the messages that comments hide, after some messages have been moved to other lines.
    pub fn hide_moved(&mut self) {
        self.ignored.hide_moved(&mut self.diagnostics);
    }
}

/// The messages about the machine, in millimetres. `told`: the other messages.
fn machine_messages(
    resolved: &ResolvedSetup,
    setup: &Setup,
    motions: &Motions,
    told: &[Diagnostic],
) -> Vec<Diagnostic> {
    if detector::can_be_found(setup) {
        let simulation = SimulationResult::of_resolved(resolved.clone(), motions, setup);
        findings::diagnostics(&simulation, motions, &setup.rules, told)
    } else {
        let found = findings::without_simulation(resolved, motions, setup.limits.part_motions);
        found.into_iter().filter_map(|found| setup.rules.apply_to(found)).collect()
    }
}

/// Interprets a whole program.
///
/// ```
/// use gcode_playground::{analyze, setup::Setup};
///
/// let analysis = analyze(b"G00 X32 Z2\nG01 Z-30 F0.1\nM30", &Setup::default());
/// assert_eq!(analysis.motions.len(), 2);
/// ```
pub fn analyze(text: &[u8], setup: &Setup) -> Analysis {
    Run::finished(text.to_vec(), setup.clone()).into_analysis()
}

/// A change to the text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TextEdit {
    /// First byte to remove.
    pub start: usize,
    /// One past the last byte to remove.
    pub end: usize,
    /// The replacement.
    pub insert: Vec<u8>,
}

/// Identifies a run; unique within this process.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct RunId(u64);

impl RunId {
    /// A new, unused id.
    fn next() -> Self {
        static NEXT: AtomicU64 = AtomicU64::new(0);
        Self(NEXT.fetch_add(1, Ordering::Relaxed))
    }
}

/// A run in progress.
pub struct Run {
    /// Changes with each edit.
    id: RunId,
    text: Vec<u8>,
    interpreter: Interpreter,
    /// The current block; a faulty one may be kept in `faulty` as well.
    block: Arc<Block>,
    at: Resume,
    blocks: usize,
    /// First byte of each O program that has been read, by number.
    programs: BTreeMap<u32, u32>,
    recognised: Recognised,
    /// The setup from the caller; the text may add to it.
    given: Setup,
    /// The additions of the text to the setup.
    notes: Notes,
    /// The unit of numbers without a decimal point, if the setup leaves it to the program. Decided once, when
    /// a text is loaded; later edits do not change it.
    decided: Option<DecimalRule>,
    /// The decimal evidence in the text, once its numbers have been examined.
    numbers: Option<DecimalEvidence>,
    /// Number of messages reported before the first block.
    of_setup: usize,
    /// Whether the lints were loaded when the run began.
    has_lints: bool,
    /// A part of the module that the run needed but that was not loaded.
    missing: Option<Part>,
    /// For each value that is tried, how often its block has been reached.
    tried: Vec<u32>,
    /// Whether a block of the main program has been executed.
    begun: bool,
    /// Whether the main program has ended; the rest of the text is only checked for errors.
    ended: bool,
    finished: bool,
    /// Whether the run was stopped early.
    stopped: bool,
    /// All messages sorted by place, once the run has ended.
    sorted: Vec<Diagnostic>,
    /// The comments of the text that hide messages, once a run of it has ended.
    ignored: Option<IgnoreComments>,
    /// Snapshots of the run, in order.
    checkpoints: Vec<Checkpoint>,
    /// Number of blocks read by which the next snapshot must be taken.
    due: usize,
    /// The run before the edit, until this run joins it and takes over its remaining results.
    previous: Option<PreviousRun>,
    /// The next byte at which this run may join the previous one.
    next_join: u32,
    /// Faulty blocks of this text that were read after a jump.
    faulty: FaultyBlocks,
}

/// The control a text was written for, as far as it can be recognised.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Recognised {
    foreign: Option<Foreign>,
    system: Option<(GSystem, Span)>,
    /// The word that shows inches, if no code selects the unit.
    inches: Option<Span>,
}

impl Recognised {
    /// Recognises control, G-code system and unit of a text, except those that the setup fixes. `None` if the
    /// part that recognises them is not loaded.
    fn of(text: &[u8], quick_check: QuickCheck, dialect: &DialectChoice) -> Option<Self> {
        let (may_be_foreign, has_system) = (dialect.recognise != Some(false), dialect.g_system.is_some());
        let is_unknown = quick_check.is_unusual && (may_be_foreign || !has_system);
        let has_no_unit = quick_check.may_be_inches && dialect.unit.is_none();
        if !is_unknown && !has_no_unit {
            return Some(Self::default());
        }
        let shown = provenance::recognise(text)?;
        let foreign = shown.foreign.filter(|_| may_be_foreign);
        let is_open = foreign.is_none() && !has_system;
        let system = shown.system.filter(|_| is_open);
        Some(Self { foreign, system, inches: shown.inches.filter(|_| has_no_unit) })
    }
}

impl Run {
    /// Begins a run. If the setup leaves the decimal rule to the program, it is decided here and kept for all
    /// later edits.
    pub fn new(text: Vec<u8>, given: Setup) -> Self {
        Self::begin(text, given, None)
    }

    /// A run to the end of the program.
    pub fn finished(text: Vec<u8>, setup: Setup) -> Self {
        let mut run = Self::new(text, setup);
        while !run.advance(usize::MAX) {}
        run
    }

    /// Begins a run of a text whose decimal rule was decided before; `rule` applies if the setup leaves it to
    /// the program.
    pub fn with_decimal_rule(text: Vec<u8>, given: Setup, rule: DecimalRule) -> Self {
        Self::begin(text, given, Some(rule))
    }

    fn begin(text: Vec<u8>, given: Setup, before: Option<DecimalRule>) -> Self {
        let unread = (!Notes::can_be_read(&text)).then_some(Part::Early);
        let notes = if unread.is_some() { Notes::default() } else { Notes::read(&text) };
        let (mut setup, faults) = notes.applied_to(given.clone()).without_invalid_values();
        let limits = setup.limits;
        let is_open = setup.dialect.decimal.unwrap_or_default() == DecimalChoice::Auto;
        let decides = is_open && before.is_none();
        // Numbers after the head are examined only to decide the decimal rule.
        let quick_check =
            if decides { provenance::quick_check(&text) } else { provenance::quick_check_head(&text) };
        let numbers = decides.then_some(quick_check.numbers);
        let decided = before.or(numbers.map(|numbers| numbers.rule())).filter(|_| is_open);
        if let Some(rule) = decided {
            setup.dialect.decimal = Some(rule.into());
        }
        let (chosen, dialect) = (setup.program, setup.dialect.clone());
        let tried = vec![0; setup.tried.len()];
        let mut run = Self {
            id: RunId::next(),
            interpreter: observed(setup),
            block: Arc::default(),
            at: Resume::default(),
            blocks: 0,
            programs: BTreeMap::new(),
            recognised: Recognised::default(),
            given,
            notes,
            decided,
            numbers,
            of_setup: 0,
            has_lints: LINTS.is_loaded(),
            missing: unread,
            tried,
            begun: false,
            ended: false,
            finished: false,
            stopped: false,
            sorted: Vec::new(),
            ignored: None,
            checkpoints: Vec::new(),
            due: 0,
            previous: None,
            next_join: u32::MAX,
            faulty: FaultyBlocks::default(),
            text,
        };
        if run.text.len() > limits.text {
            let message = said::TextTooLong { bytes: run.text.len(), most: limits.text };
            run.interpreter.report(Diagnostic::new(message, Span::new(0, 0)));
            run.finish();
            return run;
        }
        match Recognised::of(&run.text, quick_check, &dialect) {
            Some(recognised) => run.recognised = recognised,
            None => run.missing = run.missing.or(Some(provenance::RECOGNISED_BY)),
        }
        if let Some(foreign) = run.recognised.foreign {
            run.interpreter.report(Diagnostic::new(foreign.target.message(), foreign.evidence));
            run.finish();
            return run;
        }
        for diagnostic in run.notes.diagnostics(faults, &run.text) {
            run.interpreter.report_of_setup(diagnostic);
        }
        if let Some((system, evidence)) = run.recognised.system {
            run.interpreter.set_system(system);
            run.interpreter.report(Diagnostic::new(said::SystemGuessed { system: system.name() }, evidence));
        }
        if let Some(evidence) = run.recognised.inches {
            run.interpreter.set_unit(Unit::Inch);
            run.interpreter.report(Diagnostic::new(said::InchesConcluded, evidence));
        }
        run.of_setup = run.interpreter.diagnostics().len();
        if let Some(number) = chosen {
            match Labels::new(&run.text).program(number) {
                Some(head) => run.begin_at(head),
                None => {
                    let message = said::ProgramNotFound { word: format!("O{number:04}") };
                    run.interpreter.report(Diagnostic::new(message, Span::new(0, 0)));
                    run.ended = true;
                }
            }
        }
        run
    }

    /// The given setup with the additions from comments of the program; invalid values are still in it.
    pub fn as_given(&self) -> Setup {
        self.notes.applied_to(self.given.clone())
    }

    /// The unit of numbers without a decimal point in this run.
    pub fn decimal_rule(&self) -> DecimalRule {
        self.interpreter.dialect().decimal
    }

    /// The decimal rule that was decided for the program; `None` if the setup fixes it.
    pub fn decided_rule(&self) -> Option<DecimalRule> {
        self.decided
    }

    /// The decimal rule that a new run of the text would decide; `None` if the setup fixes it.
    pub fn inferred_rule(&self) -> Option<DecimalRule> {
        self.decided.map(|_| provenance::numbers(&self.text).rule())
    }

    /// The given setup with the decimal rule that was decided for the program, so that another run of the
    /// text reads its numbers in the same way.
    pub fn setup_to_repeat(&self) -> Setup {
        let mut setup = self.given.clone();
        if let Some(rule) = self.decided {
            setup.dialect.decimal = Some(rule.into());
        }
        setup
    }

    /// Begins a run of another text with the same setup and decimal rule, but this setting of block skip.
    pub fn repeated(&self, text: Vec<u8>, block_skip: Vec<u8>) -> Self {
        Self::begin(text, Setup { block_skip, ..self.given.clone() }, self.decided)
    }

    /// Begins a run of the same text with another setup. Keeps a decimal rule that was decided for the
    /// program.
    pub fn set_setup(&mut self, given: Setup) {
        *self = Self::begin(self.take_text(), given, self.decided);
    }

    /// A part of the module that was needed but not loaded, by the program or by its comments about the
    /// setup. If there is one, the results of the run are unusable.
    pub fn missing(&self) -> Option<Part> {
        self.missing.or_else(|| self.interpreter.missing())
    }

    /// Whether a part that the run lacks has been loaded since: a part it needed, or the lints.
    pub fn is_outdated(&self) -> bool {
        self.missing().is_some_and(Part::is_loaded) || !self.has_lints && LINTS.is_loaded()
    }

    /// Restarts the run with the parts loaded since.
    pub fn rerun(&mut self) {
        *self = Self::begin(self.take_text(), self.given.clone(), self.decided);
    }

    /// Decides the decimal rule again, for the current text, and restarts the run if the rule changes.
    /// Returns whether it restarted.
    pub fn reinfer_decimal_rule(&mut self) -> bool {
        let Some(rule) = self.inferred_rule().filter(|rule| Some(*rule) != self.decided) else {
            return false;
        };
        *self = Self::begin(self.take_text(), self.given.clone(), Some(rule));
        true
    }

    /// The message about numbers without a decimal point, if one is due.
    pub fn decimal_message(&self) -> Option<Diagnostic> {
        let (bare, rule) = (self.bare_number()?, self.decimal_rule());
        let message = bare.message(rule, words::quote(&self.text, bare.span));
        Some(Diagnostic::new(message, bare.span))
    }

    /// A number of the text that shows the decimal rule, if a message about it is due.
    fn bare_number(&self) -> Option<NumberWithoutPoint> {
        let numbers = self.numbers.unwrap_or_else(|| provenance::numbers(&self.text));
        match self.decimal_rule() {
            DecimalRule::LeastIncrement if self.decided.is_some() => numbers.example(),
            DecimalRule::LeastIncrement => None,
            DecimalRule::Calculator => numbers.evidence(),
        }
    }

    /// The additions to the setup from comments of the program.
    pub fn notes(&self) -> &Notes {
        &self.notes
    }

    /// The same run, recording a trace of its executed blocks.
    pub fn traced(mut self) -> Self {
        self.interpreter.keep_trace();
        self
    }

    /// Runs at most `blocks` blocks; returns true once the run has ended.
    pub fn advance(&mut self, blocks: usize) -> bool {
        if self.finished {
            return true;
        }
        let text = std::mem::take(&mut self.text);
        let mut parser = Parser::resume(&text, self.at);
        let mut left = blocks;
        let mut more = true;
        let mut joined = false;
        while left > 0 {
            let at = parser.position();
            if self.is_due(at) && self.snapshot_if_due(at, text.len()) {
                joined = true;
                break;
            }
            let plain = self.plain_lines(&mut parser, left);
            if plain > 0 {
                left -= plain;
                continue;
            }
            if !self.tried.is_empty() {
                self.try_values(at.byte);
            }
            more = self.next_block(&mut parser);
            left -= 1;
            let here = BlockPosition { at, next: parser.position() };
            let flow = if more {
                self.blocks += usize::from(!self.block.is_empty());
                let flow = self.step(&text, here);
                self.interpreter.note_origins(self.block.span.start);
                flow
            } else {
                self.end_of_text(&text)
            };
            match flow {
                Flow::Next if more => continue,
                Flow::Next => break,
                Flow::Jump(to) => parser = Parser::resume(&text, to),
                Flow::Restart(main) => {
                    self.restart(main);
                    parser = Parser::resume(&text, main);
                }
                Flow::End if !self.ended => {
                    self.ended = true;
                    // Read the blocks that were jumped over too, to check them for errors.
                    if self.interpreter.has_left_linear_order() {
                        parser = Parser::new(&text);
                    }
                }
                Flow::End => {}
            }
            more = true;
        }
        self.at = parser.position();
        self.text = text;
        if joined {
            self.finish();
        } else if !more {
            self.finish_text();
        }
        self.finished
    }

    /// Reads the next block; returns false at the end of the text.
    #[inline]
    fn next_block(&mut self, parser: &mut Parser<'_>) -> bool {
        if self.interpreter.has_left_linear_order() && READS_FAULTS.is_loaded() {
            repeated::next_block(self, parser)
        } else {
            parser.next_block(self.block_to_read())
        }
    }

    /// The block to read into. Its storage is reused unless there is another reference to the block.
    fn block_to_read(&mut self) -> &mut Block {
        if Arc::get_mut(&mut self.block).is_none() {
            self.block = Arc::default();
        }
        Arc::make_mut(&mut self.block)
    }

    /// Executes at most `most` plain lines, stopping where a snapshot is due; returns their number.
    #[inline]
    fn plain_lines(&mut self, parser: &mut Parser, most: usize) -> usize {
        if !self.begun || self.ended || !self.tried.is_empty() {
            return 0;
        }
        let plain = self.interpreter.plain_lines(parser, most.min(self.until_due()), self.next_join);
        self.blocks += plain;
        plain
    }

    /// Ends the run early and reports that.
    pub fn stop(&mut self, seconds: f64) {
        if !self.finished {
            let at = self.at.byte as usize;
            self.interpreter.report_always(Diagnostic::new(said::Stopped { seconds }, Span::new(at, at)));
            self.stopped = true;
            self.finish();
        }
    }

    /// The fraction of the text that has been read, 0 to 1.
    pub fn progress(&self) -> f64 {
        if self.finished { 1.0 } else { f64::from(self.at.byte) / self.text.len().max(1) as f64 }
    }

    /// The id of the run.
    pub fn id(&self) -> RunId {
        self.id
    }

    /// Whether the run has ended.
    pub fn is_finished(&self) -> bool {
        self.finished
    }

    /// Whether the run has ended and was not stopped early.
    pub fn is_complete(&self) -> bool {
        self.finished && !self.stopped
    }

    /// The text.
    pub fn text(&self) -> &[u8] {
        &self.text
    }

    /// Takes the text out of a run that is no longer needed.
    pub fn take_text(&mut self) -> Vec<u8> {
        self.finished = true;
        std::mem::take(&mut self.text)
    }

    /// The state of the control after the last block.
    pub fn state(&self) -> &State {
        &self.interpreter.state
    }

    /// The setup.
    pub fn setup(&self) -> &Setup {
        self.interpreter.setup()
    }

    /// The switches of the control.
    pub fn dialect(&self) -> &Dialect {
        self.interpreter.dialect()
    }

    /// The setup for the simulation of the machine, with the tool descriptions from comments. It is computed
    /// on each call, so cache the result if you need it often.
    pub fn setup_at_machine(&self) -> Setup {
        at_machine(self.setup(), &self.text, self.interpreter.dialect().unit)
    }

    /// Motions of all full chunks while the run is in progress; all motions once it has ended.
    pub fn motions(&self) -> &Motions {
        self.interpreter.motions()
    }

    /// Messages reported so far; sorted by place once the run has ended.
    pub fn diagnostics(&self) -> &[Diagnostic] {
        if self.finished { &self.sorted } else { self.interpreter.diagnostics() }
    }

    /// Removes the messages about the machining that comments of the text hide, and adds a message for each comment
    /// that hides none.
    pub fn hide_at_machine(&self, messages: &mut Vec<Diagnostic>) {
        if let Some(ignored) = &self.ignored {
            ignored.hide_at_machine(messages);
        }
    }

    /// The messages of the finished run about the machine, as [`Analysis::check_at_machine`] adds them.
    pub fn machine_messages(&self) -> Vec<Diagnostic> {
        let (setup, motions) = (self.setup_at_machine(), self.motions());
        let resolved = ResolvedSetup::new(motions, &setup);
        let mut found = machine_messages(&resolved, &setup, motions, self.diagnostics());
        self.hide_at_machine(&mut found);
        found.into_iter().map(|found| found.in_unit(self.state().unit)).collect()
    }

    /// The landmarks of the contour cycles so far.
    pub fn landmarks(&self) -> &[Landmarks] {
        self.interpreter.landmarks()
    }

    /// Blocks read so far, including repeated ones; empty blocks are not counted.
    pub fn blocks(&self) -> usize {
        self.blocks
    }

    /// The unsupported control or machine that the text was recognised to be for.
    pub fn foreign(&self) -> Option<Target> {
        self.recognised.foreign.map(|foreign| foreign.target)
    }

    /// The G-code system that was recognised in the text.
    pub fn recognised_system(&self) -> Option<GSystem> {
        self.recognised.system.map(|system| system.0)
    }

    /// Whether inches were inferred from the text, without a code that selects them.
    pub fn concludes_inches(&self) -> bool {
        self.recognised.inches.is_some()
    }

    /// The O number of the program that is run: the chosen one, or the first.
    pub fn program_number(&self) -> Option<u32> {
        let first = self.programs.iter().min_by_key(|(_, start)| **start);
        self.setup().program.or(first.map(|(number, _)| *number))
    }

    /// The G codes the program is read with.
    pub fn code_list(&self) -> CodeList {
        self.interpreter.code_list()
    }

    /// Converts the run to its result.
    pub fn into_analysis(self) -> Analysis {
        let mut interpreter = self.interpreter;
        let (trace, codes) = (interpreter.take_trace(), interpreter.code_list());
        let diagnostics = if self.finished { self.sorted } else { interpreter.diagnostics().to_vec() };
        let setup = at_machine(interpreter.setup(), &self.text, interpreter.dialect().unit);
        let unit = interpreter.state.unit;
        let motions = interpreter.into_motions();
        let (resolved, decides_decimal) = (OnceLock::new(), self.decided.is_some());
        let ignored = self.ignored.unwrap_or_default();
        let (blocks, concludes_inches) = (self.blocks, self.recognised.inches.is_some());
        Analysis {
            motions,
            diagnostics,
            blocks,
            trace,
            codes,
            setup,
            decides_decimal,
            concludes_inches,
            unit,
            ignored,
            resolved,
        }
    }

    /// Begins with a program other than the first of the text.
    fn begin_at(&mut self, head: Resume) {
        self.at = head;
        self.interpreter.start_at_other_program(head);
    }

    /// Restarts with another program of the text.
    fn restart(&mut self, main: Resume) {
        let setup = self.interpreter.setup().clone();
        let (system, unit) = (self.interpreter.system(), self.interpreter.dialect().unit);
        let traced = self.interpreter.has_trace();
        let mut kept = self.interpreter.take_diagnostics();
        kept.truncate(self.of_setup);
        self.missing = self.missing();
        let before = std::mem::replace(&mut self.interpreter, observed(setup));
        self.interpreter.record_origins_like(before.recorder());
        self.interpreter.set_system(system);
        self.interpreter.set_unit(unit);
        if traced {
            self.interpreter.keep_trace();
        }
        for diagnostic in kept {
            self.interpreter.report_of_setup(diagnostic);
        }
        self.begun = false;
        self.checkpoints.clear();
        self.previous = None;
        self.next_join = u32::MAX;
        self.begin_at(main);
    }

    /// Executes the block just read.
    #[inline]
    fn step(&mut self, text: &[u8], here: BlockPosition) -> Flow {
        if let Some((number, span)) = self.block.program
            && let Some(flow) = self.program(text, number, span, here)
        {
            return flow;
        }
        if self.ended {
            self.interpreter.report_faults(&self.block);
            return Flow::Next;
        }
        self.begun |= !self.block.words.is_empty();
        self.interpreter.run(text, &self.block, here)
    }

    /// Handles an O number: the head of the main program, of a called one, or of one that follows them.
    fn program(&mut self, text: &[u8], number: u32, span: Span, here: BlockPosition) -> Option<Flow> {
        // Blocks before the first O number that move nothing are not a program. Edits this close to the head
        // run everything again.
        let leads = self.programs.is_empty()
            && (span.start as usize) < LEADER
            && self.interpreter.kept_motions() == 0;
        if number == 0 {
            self.interpreter.report(Diagnostic::new(said::ProgramNumberZero, span));
        } else if *self.programs.entry(number).or_insert(span.start) != span.start {
            let program = span.quote(text);
            self.interpreter.report(Diagnostic::new(said::DuplicateProgram { program }, span));
        } else if self.ended
            && !self.interpreter.was_run(here.at)
            && !self.interpreter.is_called(text, number)
        {
            let program = span.quote(text);
            self.interpreter.report(Diagnostic::new(said::NotRun { program }, span));
        }
        if self.ended {
            return None;
        }
        if !self.begun || leads || self.interpreter.is_head(here.at) {
            self.interpreter.enter_program(here.at);
            return None;
        }
        Some(self.end_without_return(text, span, here))
    }

    /// The current program ends without M99 or M30.
    fn end_without_return(&mut self, text: &[u8], span: Span, here: BlockPosition) -> Flow {
        if let Some(back) = self.interpreter.end_without_return(span) {
            return Flow::Jump(back);
        }
        self.report_no_end(text, span, Some(here.at.byte));
        if self.interpreter.has_left_linear_order() {
            return Flow::End;
        }
        // The block is read again, as one that is not executed.
        self.ended = true;
        Flow::Jump(here.at)
    }

    /// Handles the end of the text; returns [`Flow::Next`] when nothing is left to run.
    fn end_of_text(&mut self, text: &[u8]) -> Flow {
        if self.ended || !self.begun {
            return Flow::Next;
        }
        let last = text.trim_ascii_end().len();
        let span = Span::new(last.saturating_sub(1), last);
        if let Some(back) = self.interpreter.end_without_return(span) {
            return Flow::Jump(back);
        }
        self.interpreter.finish(text);
        self.report_no_end(text, span, None);
        if self.interpreter.has_left_linear_order() { Flow::End } else { Flow::Next }
    }

    /// Reports that the program ends at `span` without M02 or M30. Offers M30 before the byte `next` of the
    /// next program or, without one, at the end of the tape.
    fn report_no_end(&mut self, text: &[u8], span: Span, next: Option<u32>) {
        let mut diagnostic = Diagnostic::new(said::NoEnd, span);
        // Under G10, M30 would be data.
        if READING.is_loaded() && !self.state().data_input {
            diagnostic = with_end(diagnostic, text, next);
        }
        self.interpreter.report(diagnostic);
    }

    fn finish_text(&mut self) {
        let end = self.text.len();
        self.interpreter.finish(&self.text);
        if !self.begun && self.diagnostics().is_empty() {
            self.interpreter.report(Diagnostic::new(said::EmptyProgram, Span::new(0, 0)));
        }
        let hidden = self.interpreter.hidden();
        if hidden > 0 {
            self.interpreter
                .report_always(Diagnostic::new(said::MoreMessages { hidden }, Span::new(end, end)));
        }
        self.finish();
    }

    fn finish(&mut self) {
        self.interpreter.close();
        self.sorted = self.reported();
        if READING.is_loaded() {
            complete_messages(self);
        }
        self.finished = true;
    }

    /// Adds the messages about the whole program and sorts all messages.
    fn complete_messages(&mut self) {
        let most = self.interpreter.setup().limits.compared_blocks;
        let motions = self.interpreter.motions();
        let setup = self.interpreter.setup();
        if self.recognised.foreign.is_some() || self.stopped || setup.lints == Lints::Off || !self.has_lints {
            // Skip the comparison: the program did not run, or only partly, or lints are off or not loaded.
        } else if self.blocks > most || motions.len() > 10 * most {
            let diagnostic = Diagnostic::new(said::NotCompared { most }, Span::new(0, 0));
            self.sorted.extend(setup.rules.apply_to(diagnostic));
        } else {
            self.compare_numbers();
        }
        if self.begun {
            self.report_decimal_rule();
        }
        self.hide_ignored();
        sort_by_place(&mut self.sorted);
        combined::combine_repeated(&mut self.sorted, &self.text);
    }

    /// Removes the messages that comments of the text hide.
    fn hide_ignored(&mut self) {
        let mut ignored = self.ignored.take().unwrap_or_else(|| IgnoreComments::read(&self.text));
        let setup = self.interpreter.setup();
        let has_lints = self.has_lints && setup.lints == Lints::On;
        let is_whole = self.recognised.foreign.is_none() && !self.stopped && self.interpreter.hidden() == 0;
        let ran = Ran {
            text: &self.text,
            levels: &setup.rules,
            most: setup.limits.messages,
            is_complete: has_lints && is_whole,
        };
        ignored.hide_of_run(&mut self.sorted, ran);
        self.ignored = Some(ignored);
    }

    fn compare_numbers(&mut self) {
        let interpreter = &self.interpreter;
        let (reading, list) = (interpreter.reading(), interpreter.code_list());
        let (motions, setup) = (interpreter.motions(), interpreter.setup());
        lint::plausible::compare(&self.text, motions, reading, list, setup, &mut self.sorted);
    }

    /// Reports the unit of numbers without a decimal point if it was inferred or looks wrong.
    fn report_decimal_rule(&mut self) {
        let Some(diagnostic) = self.decimal_message() else { return };
        // A long dwell is a consequence of the decimal rule.
        self.sorted.retain(|old| !old.message.is::<said::DwellLong>() || old.span != diagnostic.span);
        let is_known = self.sorted.iter().any(|old| old.is_about(diagnostic.span));
        // If the rule is wrong, a consequence of it may already be reported for the same word.
        if is_known && self.decimal_rule() == DecimalRule::Calculator {
            return;
        }
        let room = self.sorted.len() < self.interpreter.setup().limits.messages;
        self.sorted.extend(self.interpreter.setup().rules.apply_to(diagnostic).filter(|_| room));
    }

    /// The reported messages, in the order in which they were reported.
    fn reported(&mut self) -> Vec<Diagnostic> {
        // If edits may resume from a snapshot, the control still needs its messages, so copy them.
        if edit::EDITS.is_loaded() { copied(&self.interpreter) } else { self.interpreter.take_diagnostics() }
    }
}

/// The part that sorts messages; no messages are shown before it is loaded.
const READING: Part = Part::Late;

/// Where M30 belongs at the end of the tape, and the text to insert there.
fn place_of_end(text: &[u8]) -> (usize, &'static str) {
    let mut parser = Parser::new(text);
    let mut block = Block::default();
    let mut place = (0, "M30\n");
    while parser.next_block(&mut block) {
        let start = block.span.start as usize;
        let bytes = block.span.of(text);
        // After a character that ends the tape, the rest of its line belongs to the block, including
        // semicolons.
        let len = bytes.len() - bytes.iter().rev().take_while(|byte| is_between_blocks(**byte)).count();
        // Blanks at the end of an unclosed comment belong to the comment.
        let comment_end = block.comments.last().map_or(0, |comment| comment.end as usize);
        let end = (start + len).max(comment_end);
        place = match text[start..end].last() {
            // After the end of the last block.
            None if text[..start].ends_with(b";") => (start, "\nM30"),
            None => place,
            // Nothing after this character is read.
            Some(_) if block.kind == BlockKind::Percent => (start, "M30\n"),
            Some(b'%') if comment_end < end => (end - 1, "\nM30\n"),
            Some(_) => (end, "\nM30"),
        };
    }
    place
}

/// The setup of a run, with the tools and blank described in comments of its text; `unit` is the unit of the
/// text if no code selects one.
fn at_machine(setup: &Setup, text: &[u8], unit: Unit) -> Setup {
    let described_stock = tool_words::stock(text, unit);
    Setup { described_tools: tool_words::read(text, unit), described_stock, ..setup.clone() }
}

/// A control at power-on. Once the lints are loaded, it records origins and, unless the setup switches
/// them off, reports its events to the lints.
fn observed(setup: Setup) -> Interpreter {
    let listens = setup.lints == Lints::On && LINTS.is_loaded();
    let mut interpreter = Interpreter::new(setup);
    if LINTS.is_loaded() {
        record_origins(&mut interpreter);
    }
    if listens { interpreter.with_observer(lints()) } else { interpreter }
}

/// The part that contains the lints.
const LINTS: Part = Part::Late;

late! {
    fn lints() -> Box<dyn Observer> {
        Box::new(lint::Lints::default())
    }

    fn record_origins(interpreter: &mut Interpreter) {
        interpreter.begin_recording();
    }

    fn complete_messages(run: &mut Run) {
        run.complete_messages();
    }

    fn with_end(diagnostic: Diagnostic, text: &[u8], next: Option<u32>) -> Diagnostic {
        let (at, insert) = next.map_or_else(|| place_of_end(text), |next| (next as usize, "M30\n"));
        diagnostic.with(Fix::insert(at as u32, insert.to_owned()).safe())
    }

    fn copied(interpreter: &Interpreter) -> Vec<Diagnostic> {
        interpreter.diagnostics().to_vec()
    }
}
