//! How places of a text move along when the text before them is changed.
//!
//! In: which part was replaced, and how much longer and how many lines more the text has become. Out: the new
//! place of everything after that part. Knows nothing of what stands there.

use super::Span;

/// A change of a text, as seen by positions after it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shift {
    /// Bytes of the old text from this one on are moved; those before it stay where they are.
    pub from: u32,
    /// Bytes that the text has become longer.
    pub bytes: i64,
    /// Lines that it has become longer.
    pub lines: i64,
}

impl Shift {
    /// Whether a byte of the old text is moved.
    pub fn moves(&self, byte: u32) -> bool {
        byte >= self.from
    }

    /// The new place of a byte.
    pub fn byte(&self, byte: u32) -> u32 {
        if self.moves(byte) { (i64::from(byte) + self.bytes) as u32 } else { byte }
    }

    /// The new place of a span. One that ends where the change begins is not moved.
    pub fn span(&self, span: Span) -> Span {
        let start = self.byte(span.start);
        Span { start, end: start + span.len() as u32 }
    }

    /// The new number of a line that begins at or after the byte `at` of the old text.
    pub fn line(&self, line: u32, at: u32) -> u32 {
        if self.moves(at) { (i64::from(line) + self.lines) as u32 } else { line }
    }
}
