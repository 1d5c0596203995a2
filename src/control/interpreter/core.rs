//! The base of the interpreter: messages, observers, parts of the module, the reading of numbers.

use super::Interpreter;
use crate::control::events::{Event, EventContext, Observer};
use crate::control::origins::OriginRecorder;
use crate::control::words::{Reading, quote};
use crate::message::{Diagnostic, said};
use crate::parts::Part;
use crate::source::Span;
use crate::text::block::Block;
use crate::text::parser::READS_FAULTS;

impl Interpreter {
    /// Whether a part that a block needs is loaded. If not, the results of this run are unusable.
    pub(super) fn has(&mut self, part: Part) -> bool {
        let is_loaded = part.is_loaded();
        if !is_loaded {
            self.missing = Some(part);
        }
        is_loaded
    }

    /// Sends `event` to the observer and records the diagnostics it returns. `text` is empty if the event
    /// names no word.
    #[inline]
    pub(super) fn observe(&mut self, text: &[u8], event: Event<'_>) {
        if self.observer.is_some() {
            self.cut_context_changed |= event.matters_for_cuts();
            self.on_event(text, &event);
        }
    }

    /// Replaces the observer; the new one inherits what was already reported. Returns the old one.
    pub(super) fn replace_observer(
        &mut self,
        observer: Option<Box<dyn Observer>>,
    ) -> Option<Box<dyn Observer>> {
        self.cut_context_changed = true;
        let mut before = std::mem::replace(&mut self.observer, observer);
        if let (Some(own), Some(before)) = (&mut self.observer, &mut before) {
            own.inherit_reported(before.as_mut());
        }
        before
    }

    #[inline(never)]
    fn on_event(&mut self, text: &[u8], event: &Event<'_>) {
        let Self { observer, reports, state, setup, dialect, sink, contours, .. } = self;
        let Some(observer) = observer else { return };
        let at = EventContext { text, state, setup, dialect, sink, contour: contours.purpose };
        observer.on_event(event, &at, reports);
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

    /// The recorder, if any.
    pub fn recorder(&self) -> Option<&dyn OriginRecorder> {
        self.recorder.as_deref()
    }

    /// Records that a block assigns a variable. `level`: depth of macro calls.
    pub(super) fn note_assigned(&mut self, level: usize, variable: u32, block: u32) {
        if let Some(recorder) = &mut self.recorder {
            recorder.assigned(level, variable, block);
        }
    }

    /// Reports a message, unless it was reported for the same place before.
    pub fn report(&mut self, diagnostic: Diagnostic) {
        if !self.sink.suppresses(&diagnostic) {
            // Once the limit is reached, it is no longer known which of them were reported before.
            self.sink.report(diagnostic.in_unit(self.state.unit), self.program.has_left_linear_order());
        }
    }

    /// Reports a message about the setup. Several messages of the same rule are allowed, because all of them
    /// are placed at the beginning of the text.
    pub fn report_of_setup(&mut self, diagnostic: Diagnostic) {
        self.sink.report_of_setup(diagnostic);
    }

    /// Reports the reason why the run ends, even if the list of messages is full.
    pub fn report_always(&mut self, diagnostic: Diagnostic) {
        self.sink.report_always(diagnostic);
    }

    /// How numbers are read at present.
    pub fn reading(&self) -> Reading {
        Reading { unit: self.state.unit, decimal: self.dialect.decimal }
    }

    /// Reports a word that is recognised but not supported.
    pub(super) fn not_supported(&mut self, text: &[u8], span: Span) {
        let what = format!("`{}`", shortened(&quote(text, span)));
        self.report(Diagnostic::new(said::NotSupported { what }, span));
    }

    /// Reports syntax errors in a block that is not run.
    pub fn report_faults(&mut self, block: &Block) {
        self.sink.fault = None;
        if block.is_unread {
            self.missing = Some(READS_FAULTS);
        }
        for fault in &block.faults {
            // In a loop most errors have been reported before.
            if !self.program.has_left_linear_order() || self.sink.has_room_for(fault) {
                self.report(fault.clone());
            }
        }
        // If the words are read as intended, their other errors are reported.
        let fault = block.faults.iter().find(|fault| fault.is_error() && block.is_broken());
        self.sink.fault = fault.map(|fault| fault.span);
    }

    /// Records for the pass of the main program that a block assigns a variable (`None`), or reads one that
    /// had this value when the pass began.
    pub(super) fn note_access(&mut self, block: u32, variable: u32, read: Option<Option<f64>>) {
        // The local variables of a macro are separate variables.
        if variable > 33 || self.state.variables.level() == 0 {
            let block = self.main_block(block);
            self.state.call_stack.main_pass.note(block, variable, read);
        }
    }

    /// The current block of the main program: the calling block, while the block at byte `block` is in a
    /// subprogram.
    pub(super) fn main_block(&self, block: u32) -> u32 {
        self.state.call_stack.calls.first().map_or(block, |call| call.caller)
    }
}

/// Shortens a long quotation.
pub(super) fn shortened(text: &str) -> String {
    const LONGEST: usize = 24;
    if text.chars().count() <= LONGEST {
        return text.to_owned();
    }
    text.chars().take(LONGEST - 1).collect::<String>() + "…"
}
