//! A program, followed by the subprograms that it calls and does not contain, as one text.
//!
//! In: the program, and its subprograms one after the other. Out: the text to run, and the messages of that
//! run as messages of the program alone. Must not know where the subprograms come from.

use std::collections::BTreeSet;

use crate::message::{Diagnostic, Severity, said, sort_by_place};
use crate::source::Span;

/// A program with its subprograms.
#[derive(Clone, Debug)]
pub struct Joined {
    /// The program up to the `%` that ends it, then the subprograms.
    pub text: Vec<u8>,
    /// Length of the program itself, bytes.
    own: usize,
    /// Start of each subprogram, and the word in the program that calls it, directly or indirectly.
    added: Vec<(usize, Span)>,
}

impl Joined {
    /// A program without subprograms; `own` ends before the `%` that ends it.
    pub fn new(own: &[u8]) -> Self {
        Self { text: own.to_vec(), own: own.len(), added: Vec::new() }
    }

    /// Length of the program itself, bytes.
    pub fn own(&self) -> usize {
        self.own
    }

    /// Number of subprograms.
    pub fn added(&self) -> usize {
        self.added.len()
    }

    /// Appends a subprogram; `word` calls it, in the program or in a subprogram.
    pub fn append(&mut self, program: &[u8], word: Span) {
        if !self.text.ends_with(b"\n") {
            self.text.push(b'\n');
        }
        self.added.push((self.text.len(), self.call(word).unwrap_or(word)));
        self.text.extend(program);
    }

    /// Whether a span is in the program itself.
    pub fn is_own(&self, place: Span) -> bool {
        place.end as usize <= self.own
    }

    /// The first word of the program that calls the subprogram at a span; `None` in the program itself.
    pub fn call(&self, place: Span) -> Option<Span> {
        let until = self.added.partition_point(|(start, _)| *start <= place.start as usize);
        self.added[..until].last().map(|(_, call)| *call)
    }

    /// Keeps the messages of the program, and moves some messages of its subprograms to the calls: machine
    /// findings, which only the joined run produces, and the first block that is not executed. All other
    /// messages of a subprogram are reported when its own file is checked. `of_control`: the diagnostics
    /// before the machine stage.
    pub fn report_at_calls(&self, diagnostics: &mut Vec<Diagnostic>, of_control: &[Diagnostic]) {
        let mut reported = BTreeSet::new();
        diagnostics.retain_mut(|diagnostic| {
            let Some(call) = self.call(diagnostic.span) else {
                diagnostic.fixes.retain(|fix| fix.edits.iter().all(|edit| self.is_own(edit.span)));
                return self.is_own(diagnostic.span);
            };
            let message = &diagnostic.message;
            let (is_reported, slug) = match of_control.contains(diagnostic) {
                true => (diagnostic.is_error() || message.is::<said::ProgramNotFound>(), None),
                false => (diagnostic.severity >= Severity::Warning, Some(message.slug())),
            };
            diagnostic.span = call;
            diagnostic.fixes.clear();
            is_reported && reported.insert((call.start, slug))
        });
        sort_by_place(diagnostics);
    }
}
