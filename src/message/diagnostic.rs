//! A message at a place of the text, with its repairs.
//!
//! In: a [`Message`] and a span. Out: what travels, in one list, to the page and the command line. Knows no
//! language: `sentences` says it.

use super::rule::Severity;
use super::variants::Message;
use crate::order;
use crate::source::Span;
use crate::source::shift::Shift;
use crate::units::Unit;

/// One message at one place.
#[derive(Clone, Debug, PartialEq)]
pub struct Diagnostic {
    /// What is to be said.
    pub message: Message,
    /// The word or block it is about.
    pub span: Span,
    /// The unit its lengths are shown in: that of the program at its place.
    pub unit: Unit,
    /// Its severity; mostly the message's own, but a control can turn an error into a warning.
    pub severity: Severity,
    /// Repairs whose result is known exactly.
    pub fixes: Vec<Fix>,
}

impl Diagnostic {
    /// A message at a place, with its usual severity.
    #[inline(always)]
    pub fn new(message: impl Into<Message>, span: Span) -> Self {
        Self::of(message.into(), span)
    }

    #[cold]
    #[inline(never)]
    fn of(message: Message, span: Span) -> Self {
        Self { severity: message.severity(), message, span, unit: Unit::Millimetre, fixes: Vec::new() }
    }

    /// The same with another severity.
    pub fn graded(mut self, severity: Severity) -> Self {
        self.severity = severity;
        self
    }

    /// The same with its lengths in a unit.
    pub fn in_unit(mut self, unit: Unit) -> Self {
        self.unit = unit;
        self
    }

    /// The same with one more repair.
    pub fn with(mut self, fix: Fix) -> Self {
        self.fixes.push(fix);
        self
    }

    /// The code of its message. The letter of an error is E, and of nothing else, whatever severity a setup or the
    /// control has given it: `E-NOT-MONOTONE` is `W-NOT-MONOTONE` where the control goes on.
    pub fn code(&self) -> String {
        let code = self.message.code();
        match (self.is_error(), code.split_at_checked(2)) {
            (true, Some(("W-" | "I-", name))) => ["E-", name].concat(),
            (false, Some(("E-", name))) => ["W-", name].concat(),
            _ => code.to_owned(),
        }
    }

    /// Moves its places along, when the text before them has changed.
    pub fn shift(&mut self, shift: &Shift) {
        self.span = shift.span(self.span);
        for edit in self.fixes.iter_mut().flat_map(|fix| &mut fix.edits) {
            edit.span = shift.span(edit.span);
        }
    }

    /// Whether it says something of a word already, alone or with a neighbour.
    pub fn is_about(&self, word: Span) -> bool {
        let same = self.span.contains(word) && self.span.len() <= 2 * word.len() + 2;
        same && self.severity > Severity::Info
    }

    /// Whether the block cannot be carried out as it is written.
    pub fn is_error(&self) -> bool {
        self.severity == Severity::Error
    }
}

/// Puts messages in the order of their places; those at one place stay in theirs.
pub fn sort_by_place(diagnostics: &mut [Diagnostic]) {
    order::by_key(diagnostics, |told| told.span.start);
}

/// What a repair does, as its title says it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Repair {
    /// Closes a comment.
    CloseComment,
    /// Writes a decimal point.
    DecimalPoint,
    /// Writes the letter O.
    LetterO,
    /// Writes a minus.
    Minus,
    /// Writes this in place of what stands there.
    Write {
        /// The new text.
        text: String,
    },
    /// Takes a word out.
    Delete {
        /// The word.
        text: String,
    },
    /// Puts this where nothing stood.
    Insert {
        /// The new text.
        text: String,
    },
}

/// A repair: edits that together cure the fault.
#[derive(Clone, Debug, PartialEq)]
pub struct Fix {
    /// What it does.
    pub title: Repair,
    /// Whether it can be applied without asking: it does not change what the program does.
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
    pub fn replace(title: Repair, span: Span, text: &str) -> Self {
        Self { title, safe: true, edits: vec![Edit { span, text: text.to_owned() }] }
    }

    /// A repair that puts `text` in place of a word; whoever reads the program must
    /// say whether that was meant.
    pub fn write(span: Span, text: String) -> Self {
        Self::replace(Repair::Write { text: text.clone() }, span, &text).asking()
    }

    /// A repair that takes a word out, with the blanks before it; to be asked for.
    pub fn delete(text: &[u8], span: Span) -> Self {
        let before = text[..span.start as usize].iter().rev();
        let blanks = before.take_while(|byte| matches!(byte, b' ' | b'\t')).count() as u32;
        let from = Span { start: span.start - blanks, end: span.end };
        // At the head of a line the blanks after it go.
        let behind =
            text[span.end as usize..].iter().take_while(|byte| matches!(byte, b' ' | b'\t')).count() as u32;
        let first = from.start == 0 || matches!(text[from.start as usize - 1], b'\n' | b'\r');
        let whole = if first { Span { start: span.start, end: span.end + behind } } else { from };
        Self::replace(Repair::Delete { text: span.quote(text) }, whole, "").asking()
    }

    /// A repair that puts `text` at byte `at`; to be asked for.
    pub fn insert(at: u32, text: String) -> Self {
        let title = Repair::Insert { text: text.trim().to_owned() };
        Self::replace(title, Span { start: at, end: at }, &text).asking()
    }

    /// The same repair, to be applied only when somebody asks for it.
    pub fn asking(mut self) -> Self {
        self.safe = false;
        self
    }

    /// The same repair, which does not change what the program does.
    pub fn safe(mut self) -> Self {
        self.safe = true;
        self
    }
}
