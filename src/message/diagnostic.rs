//! A message at a position of the text, with its fixes.
//!
//! In: a [`Message`] and a span. Out: a [`Diagnostic`], which the page and the command line show. Independent
//! of the language: `sentences` contains the texts.

use super::rule::Severity;
use super::variants::Message;
use crate::order;
use crate::source::Span;
use crate::source::shift::Shift;
use crate::units::Unit;

/// A message with its position, severity and fixes.
#[derive(Clone, Debug, PartialEq)]
pub struct Diagnostic {
    /// The message.
    pub message: Message,
    /// The word or block that the message is about.
    pub span: Span,
    /// The unit for lengths in the message: that of the program at this position.
    pub unit: Unit,
    /// Its severity: usually that of the message, but a control can turn an error into a warning.
    pub severity: Severity,
    /// Alternative fixes; each resolves the problem.
    pub fixes: Vec<Fix>,
}

impl Diagnostic {
    /// Creates a diagnostic with the default severity.
    #[inline(always)]
    pub fn new(message: impl Into<Message>, span: Span) -> Self {
        Self::of(message.into(), span)
    }

    // Out of line, to keep the callers small.
    #[cold]
    #[inline(never)]
    fn of(message: Message, span: Span) -> Self {
        Self { severity: message.severity(), message, span, unit: Unit::Millimetre, fixes: Vec::new() }
    }

    /// Sets the severity.
    pub fn with_severity(mut self, severity: Severity) -> Self {
        self.severity = severity;
        self
    }

    /// Sets the unit of lengths.
    pub fn in_unit(mut self, unit: Unit) -> Self {
        self.unit = unit;
        self
    }

    /// Adds a fix.
    pub fn with(mut self, fix: Fix) -> Self {
        self.fixes.push(fix);
        self
    }

    /// The code of the message. It begins with E if the diagnostic is an error, and only then: if a control
    /// turns an error into a warning, `E-NOT-MONOTONE` becomes `W-NOT-MONOTONE`; if a setup turns a warning
    /// into an error, W or I becomes E.
    pub fn code(&self) -> String {
        let code = self.message.code();
        match (self.is_error(), code.split_at_checked(2)) {
            (true, Some(("W-" | "I-", name))) => ["E-", name].concat(),
            (false, Some(("E-", name))) => ["W-", name].concat(),
            _ => code.to_owned(),
        }
    }

    /// Moves its spans after an edit of the text before them.
    pub fn shift(&mut self, shift: &Shift) {
        self.span = shift.span(self.span);
        for edit in self.fixes.iter_mut().flat_map(|fix| &mut fix.edits) {
            edit.span = shift.span(edit.span);
        }
    }

    /// Whether it is a warning or an error about this word: its span contains the word, and has at most twice
    /// its length plus two bytes, enough for a second word.
    pub fn is_about(&self, word: Span) -> bool {
        let same = self.span.contains(word) && self.span.len() <= 2 * word.len() + 2;
        same && self.severity > Severity::Info
    }

    /// Whether the block cannot be executed as written.
    pub fn is_error(&self) -> bool {
        self.severity == Severity::Error
    }
}

/// Sorts messages by position, stably.
pub fn sort_by_place(diagnostics: &mut [Diagnostic]) {
    order::by_key(diagnostics, |diagnostic| diagnostic.span.start);
}

/// Kind of a fix, used for its title.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Repair {
    /// Close a comment.
    CloseComment,
    /// Insert a decimal point.
    DecimalPoint,
    /// Write the letter O instead of a zero.
    LetterO,
    /// Insert a minus sign.
    Minus,
    /// Replace a text.
    Write {
        /// The new text.
        text: String,
    },
    /// Delete a word.
    Delete {
        /// The word.
        text: String,
    },
    /// Insert a text.
    Insert {
        /// The new text.
        text: String,
    },
}

/// A fix: edits that together resolve the problem.
#[derive(Clone, Debug, PartialEq)]
pub struct Fix {
    /// Kind of the fix.
    pub title: Repair,
    /// Whether it can be applied without confirmation, because it does not change what the program does. If
    /// false, the user must confirm it.
    pub safe: bool,
    /// The edits, sorted by position, not overlapping.
    pub edits: Vec<Edit>,
}

/// A replacement of a span of the text.
#[derive(Clone, Debug, PartialEq)]
pub struct Edit {
    /// The replaced span; empty for an insertion.
    pub span: Span,
    /// The new text.
    pub text: String,
}

/// Applies edits, which are sorted by position and do not overlap.
pub fn applied(text: &[u8], edits: &[Edit]) -> Vec<u8> {
    let mut changed = Vec::with_capacity(text.len());
    let mut from = 0;
    for edit in edits {
        changed.extend_from_slice(&text[from..edit.span.start as usize]);
        changed.extend_from_slice(edit.text.as_bytes());
        from = edit.span.end as usize;
    }
    changed.extend_from_slice(&text[from..]);
    changed
}

impl Fix {
    /// A safe fix that replaces `span` by `text`.
    pub fn replace(title: Repair, span: Span, text: &str) -> Self {
        Self { title, safe: true, edits: vec![Edit { span, text: text.to_owned() }] }
    }

    /// A fix that replaces a word by `text`. Not safe.
    pub fn write(span: Span, text: String) -> Self {
        Self::replace(Repair::Write { text: text.clone() }, span, &text).needs_confirmation()
    }

    /// A fix that deletes a word and the spaces before it. Not safe.
    pub fn delete(text: &[u8], span: Span) -> Self {
        let before = text[..span.start as usize].iter().rev();
        let blanks = before.take_while(|byte| matches!(byte, b' ' | b'\t')).count() as u32;
        let from = Span { start: span.start - blanks, end: span.end };
        // At the start of a line, delete the spaces after the word instead.
        let behind =
            text[span.end as usize..].iter().take_while(|byte| matches!(byte, b' ' | b'\t')).count() as u32;
        let first = from.start == 0 || matches!(text[from.start as usize - 1], b'\n' | b'\r');
        let whole = if first { Span { start: span.start, end: span.end + behind } } else { from };
        Self::replace(Repair::Delete { text: span.quote(text) }, whole, "").needs_confirmation()
    }

    /// A fix that inserts `text` at byte `at`. Not safe.
    pub fn insert(at: u32, text: String) -> Self {
        let title = Repair::Insert { text: text.trim().to_owned() };
        Self::replace(title, Span { start: at, end: at }, &text).needs_confirmation()
    }

    /// Marks the fix as not safe: the user must confirm it.
    pub fn needs_confirmation(mut self) -> Self {
        self.safe = false;
        self
    }

    /// Marks the fix as safe: it does not change what the program does.
    pub fn safe(mut self) -> Self {
        self.safe = true;
        self
    }
}
