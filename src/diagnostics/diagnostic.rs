//! A message at a place of the text, with its repairs.
//!
//! In: a [`Message`] and a span. Out: what travels, in one list, to the page and the command line. Knows no
//! language: the sentences are in `messages/`.

use super::message::{Message, Severity};
use crate::text::shift::Shift;
use crate::text::source::Span;

/// One message at one place.
#[derive(Clone, Debug, PartialEq)]
pub struct Diagnostic {
    /// What is to be said.
    pub message: Message,
    /// The word or block it is about.
    pub span: Span,
    /// How grave it is; mostly the message's own, but a control can turn an error into a warning.
    pub severity: Severity,
    /// Repairs whose result is known exactly.
    pub fixes: Vec<Fix>,
}

impl Diagnostic {
    /// A message at a place, as grave as it usually is.
    #[inline(never)]
    pub fn new(message: Message, span: Span) -> Self {
        Self { severity: message.severity(), message, span, fixes: Vec::new() }
    }

    /// The same with another severity.
    pub fn graded(mut self, severity: Severity) -> Self {
        self.severity = severity;
        self
    }

    /// The same with one more repair.
    pub fn with(mut self, fix: Fix) -> Self {
        self.fixes.push(fix);
        self
    }

    /// Moves its places along, when the text before them has changed.
    pub fn shift(&mut self, shift: &Shift) {
        self.span = shift.span(self.span);
        for edit in self.fixes.iter_mut().flat_map(|fix| &mut fix.edits) {
            edit.span = shift.span(edit.span);
        }
    }

    /// Whether the block cannot be carried out as it is written.
    pub fn is_error(&self) -> bool {
        self.severity == Severity::Error
    }
}

/// Puts messages in the order of their places; those at one place stay in theirs.
pub fn sort_by_place(diagnostics: &mut [Diagnostic]) {
    diagnostics.sort_by_key(|told| told.span.start);
}

/// A repair: edits that together cure the fault. Its title is the help of its message.
#[derive(Clone, Debug, PartialEq)]
pub struct Fix {
    /// The message whose repair this is; languages take the title from it.
    pub title: Message,
    /// Whether it can be applied without asking: it cannot change the meaning for the worse.
    pub safe: bool,
    /// The edits, in order of place, not overlapping.
    pub edits: Vec<Edit>,
}

/// Text to put in place of a span.
#[derive(Clone, Debug, PartialEq)]
pub struct Edit {
    /// What is replaced; empty to insert.
    pub span: Span,
    /// The new text.
    pub text: String,
}

impl Fix {
    /// A safe repair that puts `text` in place of `span`.
    pub fn replace(title: Message, span: Span, text: &str) -> Self {
        Self { title, safe: true, edits: vec![Edit { span, text: text.to_owned() }] }
    }
}
