//! Positions of the protocol: a line, and a column in the units that client and server have agreed on.
//!
//! In: bytes and UTF-16 offsets. Out: positions, and back. A position outside the text is moved to the
//! nearest one inside, as the protocol requires.

use gen_lsp_types::{Position, PositionEncodingKind, Range};

use crate::source::{LineColumn, LineIndex, Span};

/// The unit of columns.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Encoding {
    /// Bytes.
    Utf8,
    /// UTF-16 code units, the default of the protocol.
    #[default]
    Utf16,
}

impl Encoding {
    /// Its name in the protocol.
    pub fn kind(self) -> PositionEncodingKind {
        match self {
            Self::Utf8 => PositionEncodingKind::UTF8,
            Self::Utf16 => PositionEncodingKind::UTF16,
        }
    }
}

/// A text, and the unit of its columns.
#[derive(Clone, Copy)]
pub struct Positions<'a> {
    /// The text, in UTF-8.
    pub text: &'a [u8],
    /// Its lines.
    pub lines: &'a LineIndex,
    /// The unit of columns.
    pub encoding: Encoding,
}

impl Positions<'_> {
    /// The position of a byte.
    pub fn position(&self, byte: u32) -> Position {
        let LineColumn { line, column } = self.lines.line_column(self.text, byte);
        let character = match self.encoding {
            Encoding::Utf16 => column,
            Encoding::Utf8 => byte.min(self.text.len() as u32) - self.lines.line(self.text, line).start,
        };
        Position { line, character }
    }

    /// The range of a span.
    pub fn range(&self, span: Span) -> Range {
        Range { start: self.position(span.start), end: self.position(span.end) }
    }

    /// The range between two UTF-16 offsets.
    pub fn range_of_offsets(&self, from: u32, to: u32) -> Range {
        let byte = |offset| self.lines.byte_at_utf16(self.text, offset);
        self.range(Span { start: byte(from), end: byte(to) })
    }

    /// The byte at a position.
    pub fn byte(&self, at: Position) -> u32 {
        if at.line >= self.lines.len() {
            return self.text.len() as u32;
        }
        let line = self.lines.line(self.text, at.line);
        match self.encoding {
            Encoding::Utf8 => self.begin_of_character(line.start.saturating_add(at.character).min(line.end)),
            Encoding::Utf16 => {
                let start = self.lines.utf16_offset(self.text, line.start);
                let byte = self.lines.byte_at_utf16(self.text, start.saturating_add(at.character));
                byte.min(line.end)
            }
        }
    }

    /// The first byte of the character that contains a byte.
    fn begin_of_character(&self, byte: u32) -> u32 {
        let continues = |at: &u32| self.text.get(*at as usize).is_some_and(|byte| byte & 0xC0 == 0x80);
        (0..=byte).rev().find(|at| !continues(at)).unwrap_or(0)
    }

    /// The span of a range; empty if its end is before its start.
    pub fn span(&self, range: Range) -> Span {
        let start = self.byte(range.start);
        Span { start, end: self.byte(range.end).max(start) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `外` has 3 bytes and 1 unit, `😀` 4 bytes and 2 units.
    const TEXT: &str = "G0 (外) X1\r\n(😀)\nM30";

    fn with<R>(encoding: Encoding, ask: impl FnOnce(&Positions) -> R) -> R {
        let lines = LineIndex::new(TEXT.as_bytes());
        ask(&Positions { text: TEXT.as_bytes(), lines: &lines, encoding })
    }

    fn at(line: u32, character: u32) -> Position {
        Position { line, character }
    }

    #[test]
    fn columns_are_bytes_or_utf_16_units() {
        let x = TEXT.find('X').expect("X") as u32;
        for (encoding, column) in [(Encoding::Utf8, 9), (Encoding::Utf16, 7)] {
            with(encoding, |positions| {
                assert_eq!(positions.position(x), at(0, column));
                assert_eq!(positions.byte(at(0, column)), x);
            });
        }
    }

    #[test]
    fn every_byte_of_a_character_start_is_found_again() {
        for encoding in [Encoding::Utf8, Encoding::Utf16] {
            with(encoding, |positions| {
                for (byte, _) in TEXT.char_indices().filter(|(_, letter)| *letter != '\n') {
                    assert_eq!(positions.byte(positions.position(byte as u32)), byte as u32);
                }
            });
        }
    }

    #[test]
    fn positions_outside_are_moved_inside() {
        let end_of_first = TEXT.find('\r').expect("CR") as u32;
        let smile = TEXT.find('😀').expect("a smile") as u32;
        for encoding in [Encoding::Utf8, Encoding::Utf16] {
            with(encoding, |positions| {
                assert_eq!(positions.byte(at(0, 99)), end_of_first);
                assert_eq!(positions.byte(at(0, u32::MAX)), end_of_first);
                assert_eq!(positions.byte(at(9, 0)), TEXT.len() as u32);
                assert_eq!(positions.byte(at(u32::MAX, u32::MAX)), TEXT.len() as u32);
                let inside = positions.byte(at(1, 2));
                assert!(inside == smile || inside == smile + 4, "never within a character");
            });
        }
    }
}
