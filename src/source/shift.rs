//! Shifts places of a text after a change before them.
//!
//! In: the replaced part, and by how many bytes and lines the text has grown. Out: the new position of
//! everything after that part. Must not know the content.

use super::Span;

/// The effect of a change on places after it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shift {
    /// First byte of the old text that moves; bytes before it do not.
    pub from: u32,
    /// Number of bytes by which the text has grown.
    pub bytes: i64,
    /// Number of lines by which it has grown.
    pub lines: i64,
}

impl Shift {
    /// Whether a byte of the old text moves.
    pub fn moves(&self, byte: u32) -> bool {
        byte >= self.from
    }

    /// The new position of a byte.
    pub fn byte(&self, byte: u32) -> u32 {
        if self.moves(byte) { (i64::from(byte) + self.bytes) as u32 } else { byte }
    }

    /// The new position of a span. One that ends where the change begins does not move.
    pub fn span(&self, span: Span) -> Span {
        let start = self.byte(span.start);
        Span { start, end: start + span.len() as u32 }
    }

    /// The new number of a line that begins at or after the byte `at` of the old text.
    pub fn line(&self, line: u32, at: u32) -> u32 {
        if self.moves(at) { (i64::from(line) + self.lines) as u32 } else { line }
    }
}
