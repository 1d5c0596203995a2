//! Places in the program text.
//!
//! In: the bytes of a program. Out: [`Span`]s (bytes), and the lines and columns that users and editors use.
//! The only module that converts bytes to UTF-16 columns. Must not know words or blocks.

pub mod address;
pub mod shift;

use std::ops::Range;

use memchr::{memchr, memchr_iter, memchr2, memrchr2};

/// A range of bytes of the program text, `start..end`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Span {
    /// First byte.
    pub start: u32,
    /// One past the last byte.
    pub end: u32,
}

impl Span {
    /// The span `start..end`.
    pub fn new(start: usize, end: usize) -> Self {
        debug_assert!(start <= end);
        Self { start: start as u32, end: end as u32 }
    }

    /// Number of bytes.
    pub fn len(self) -> usize {
        (self.end - self.start) as usize
    }

    /// Whether the span is empty.
    pub fn is_empty(self) -> bool {
        self.start == self.end
    }

    /// The smallest span that contains both.
    pub fn to(self, other: Span) -> Span {
        Span { start: self.start.min(other.start), end: self.end.max(other.end) }
    }

    /// Whether the span contains another one completely.
    pub fn contains(self, other: Span) -> bool {
        self.start <= other.start && other.end <= self.end
    }

    /// The bytes of `text` in this span.
    pub fn of(self, text: &[u8]) -> &[u8] {
        &text[self.start as usize..self.end as usize]
    }

    /// The text of this span, for messages; bytes that are not UTF-8 become `\u{FFFD}`.
    pub fn quote(self, text: &[u8]) -> String {
        String::from_utf8_lossy(self.of(text)).into_owned()
    }
}

/// A position in an editor: line and column from 0, the column in UTF-16 units.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct LineColumn {
    /// Line, from 0.
    pub line: u32,
    /// Column, from 0, in UTF-16 units.
    pub column: u32,
}

/// Starts of all lines, to convert bytes to lines, columns and UTF-16 offsets, and back.
///
/// A line ends at `\n`, `\r\n` or a lone `\r`, like in the editors from which text is pasted.
#[derive(Clone, Debug)]
pub struct LineIndex {
    /// First byte of each line.
    starts: Vec<u32>,
    /// Places with a known UTF-16 offset, in order: all starts of lines, and more in long lines. Empty while
    /// all text is ASCII without CRLF, because offsets then equal bytes.
    marks: Vec<Mark>,
    /// The line end for new text, if offsets count the text as written.
    line_end: Option<&'static str>,
}

/// A place with a known UTF-16 offset.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Mark {
    byte: u32,
    /// UTF-16 units before it. Each line end counts as one, as in editors that fold CRLF, unless offsets
    /// count the text as written.
    units: u32,
}

/// Most bytes between two marks in a line, or one character more: a text may be a single line.
const STRIDE: usize = 256;

impl LineIndex {
    /// Indexes the lines of `text`.
    pub fn new(text: &[u8]) -> Self {
        let (starts, plain) = line_starts(text);
        let mut index = Self { starts, marks: Vec::new(), line_end: None };
        if !plain {
            index.mark(text);
        }
        index
    }

    /// Indexes the lines of `text` with offsets into the text as written: CR LF counts as two units. Such an
    /// index does not support `edit`.
    pub fn as_written(text: &[u8]) -> Self {
        let starts = line_starts(text).0;
        let mut index = Self { starts, marks: Vec::new(), line_end: Some(only_line_end(text)) };
        if !text.is_ascii() {
            index.mark(text);
            let mut pairs = 0;
            let mut next = 0;
            for mark in &mut index.marks {
                let before = &text[next..mark.byte as usize];
                pairs += memchr_iter(b'\r', before).filter(|&at| before.get(at + 1) == Some(&b'\n')).count()
                    as u32;
                next = mark.byte as usize;
                mark.units += pairs;
            }
        }
        index
    }

    /// New text with the line ends of the text as written; unchanged, with `\n`, if each line end counts as
    /// one unit.
    pub fn with_line_ends(&self, new: String) -> String {
        match self.line_end {
            None | Some("\n") => new,
            Some(end) => new.replace('\n', end),
        }
    }

    /// Updates the index after a change: `inserted` bytes have replaced the range `replaced`, and the text is
    /// now `text`. Only the touched lines are read again, and the rest is shifted. All lines are read when
    /// offsets no longer equal bytes.
    pub fn edit(&mut self, text: &[u8], replaced: Range<usize>, inserted: usize) {
        // A line start depends on the bytes on both sides: on `\r` and the `\n` that may follow it.
        let first = self.line_of(replaced.start.saturating_sub(1) as u32) as usize;
        let next = self.starts.partition_point(|&start| start as usize <= replaced.end);
        let bytes = (inserted as u32).wrapping_sub(replaced.len() as u32);
        let start = self.starts[first] as usize;
        let end = self.starts.get(next).map_or(text.len(), |&after| after.wrapping_add(bytes) as usize);
        let mut read = Self::new(&text[start..end]);
        if self.marks.is_empty() && !read.marks.is_empty() {
            // These are the first marks: long lines elsewhere need theirs as well.
            *self = Self::new(text);
            return;
        }
        // The line start after the bytes that were read is `next`, which is kept.
        let lines = read.starts.len() - usize::from(next < self.starts.len());
        if !self.marks.is_empty() {
            if read.marks.is_empty() {
                read.mark(&text[start..end]);
            }
            let first = self.marks.partition_point(|mark| (mark.byte as usize) < start);
            let next = match self.starts.get(next) {
                Some(&next) => self.marks.partition_point(|mark| mark.byte < next),
                None => self.marks.len(),
            };
            let before = self.marks[first].units;
            let own = match read.starts.get(lines) {
                Some(&kept) => read.marks.partition_point(|mark| mark.byte < kept),
                None => read.marks.len(),
            };
            if next < self.marks.len() {
                let units = (before + read.marks[own].units).wrapping_sub(self.marks[next].units);
                for mark in &mut self.marks[next..] {
                    mark.byte = mark.byte.wrapping_add(bytes);
                    mark.units = mark.units.wrapping_add(units);
                }
            }
            let moved = |mark: &Mark| Mark { byte: start as u32 + mark.byte, units: before + mark.units };
            self.marks.splice(first..next, read.marks[..own].iter().map(moved));
        }
        self.starts[next..].iter_mut().for_each(|start| *start = start.wrapping_add(bytes));
        self.starts.splice(first..next, read.starts[..lines].iter().map(|&from| start as u32 + from));
    }

    /// Number of lines; at least 1.
    pub fn len(&self) -> u32 {
        self.starts.len() as u32
    }

    /// Always false: even an empty text has one line.
    pub fn is_empty(&self) -> bool {
        false
    }

    /// The bytes of a line (from 0) without its line end.
    pub fn line(&self, text: &[u8], line: u32) -> Span {
        let start = self.starts[line as usize] as usize;
        let mut end = self.starts.get(line as usize + 1).map_or(text.len(), |&next| next as usize);
        while end > start
            && matches!(text[end - 1], b'\n' | b'\r')
            && (end as u32) > self.starts[line as usize]
        {
            if line + 1 == self.len() {
                break;
            }
            end -= 1;
        }
        Span::new(start, end)
    }

    /// The line (from 0) that contains a byte.
    pub fn line_of(&self, byte: u32) -> u32 {
        self.starts.partition_point(|&start| start <= byte) as u32 - 1
    }

    /// Line and column of a byte.
    pub fn line_column(&self, text: &[u8], byte: u32) -> LineColumn {
        let byte = byte.min(text.len() as u32);
        let line = self.line_of(byte);
        let start = self.starts[line as usize];
        LineColumn { line, column: self.utf16_offset(text, byte) - self.utf16_offset(text, start) }
    }

    /// UTF-16 offset of a byte from the start of the text. Each line end counts as one unit, unless the index
    /// was made by [`LineIndex::as_written`].
    pub fn utf16_offset(&self, text: &[u8], byte: u32) -> u32 {
        let byte = byte.min(text.len() as u32);
        if self.marks.is_empty() {
            return byte;
        }
        let mark = self.marks[self.marks.partition_point(|mark| mark.byte <= byte) - 1];
        mark.units + utf16_len(&text[mark.byte as usize..byte as usize])
    }

    /// The byte at a UTF-16 offset; the inverse of [`LineIndex::utf16_offset`].
    pub fn byte_at_utf16(&self, text: &[u8], offset: u32) -> u32 {
        if self.marks.is_empty() {
            return offset.min(text.len() as u32);
        }
        let mark = self.marks[self.marks.partition_point(|mark| mark.units <= offset) - 1];
        let end = self.line(text, self.line_of(mark.byte)).end;
        let mut units = mark.units;
        for (at, ch) in chars(&text[mark.byte as usize..end as usize]) {
            if units >= offset {
                return mark.byte + at as u32;
            }
            units += ch;
        }
        end
    }

    /// Sets the marks.
    fn mark(&mut self, text: &[u8]) {
        let mut units = 0;
        for line in 0..self.len() {
            let span = self.line(text, line);
            self.marks.push(Mark { byte: span.start, units });
            let bytes = span.of(text);
            if bytes.len() <= STRIDE {
                units += utf16_len(bytes) + 1;
                continue;
            }
            let mut next = STRIDE;
            for (at, ch) in chars(bytes) {
                if at >= next {
                    self.marks.push(Mark { byte: span.start + at as u32, units });
                    next = at + STRIDE;
                }
                units += ch;
            }
            units += 1;
        }
    }
}

/// Whether a character must not be shown as it is: a control character other than LF and tab, which a
/// terminal may interpret as a command and XML forbids, or one that changes the direction of the text after
/// it.
pub fn is_unprintable(letter: char) -> bool {
    (letter.is_control() && !matches!(letter, '\n' | '\t'))
        || matches!(letter, '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}')
}

/// The line around a byte, without its line end (LF, CR LF or CR).
pub fn line_around(text: &[u8], byte: usize) -> Span {
    let byte = byte.min(text.len());
    let start = memrchr2(b'\n', b'\r', &text[..byte]).map_or(0, |end| end + 1);
    Span::new(start, line_end(text, byte))
}

/// End of the line that contains a byte, without its line end.
pub fn line_end(text: &[u8], byte: usize) -> usize {
    memchr2(b'\n', b'\r', &text[byte..]).map_or(text.len(), |length| byte + length)
}

/// The first byte of the line after the one that ends at byte `end`.
pub fn after_line_end(text: &[u8], end: usize) -> usize {
    let width = if text[end..].starts_with(b"\r\n") { 2 } else { 1 };
    text.len().min(end + width)
}

/// The line end of a text if it only has CR LF or only CR; otherwise LF.
pub fn only_line_end(text: &[u8]) -> &'static str {
    let is_lone = |at: usize| at == 0 || text[at - 1] != b'\r';
    match (memchr(b'\r', text), memchr(b'\n', text)) {
        (Some(_), None) => "\r",
        (Some(_), Some(_)) if !memchr_iter(b'\n', text).any(is_lone) => "\r\n",
        _ => "\n",
    }
}

/// First byte of each line, and whether every byte is one UTF-16 unit.
fn line_starts(text: &[u8]) -> (Vec<u32>, bool) {
    let ascii = text.is_ascii();
    if memchr(b'\r', text).is_none() {
        // The usual text from an editor. The lines are counted first, because a growing list takes twice its
        // memory.
        let ends = memchr_iter(b'\n', text);
        let mut starts = Vec::with_capacity(1 + ends.clone().count());
        starts.push(0);
        starts.extend(ends.map(|at| at as u32 + 1));
        return (starts, ascii);
    }
    let mut starts = vec![0];
    let mut plain = ascii;
    let mut at = 0;
    while at < text.len() {
        match text[at] {
            b'\n' => starts.push(at as u32 + 1),
            b'\r' if text.get(at + 1) == Some(&b'\n') => {
                plain = false;
                at += 1;
                starts.push(at as u32 + 1);
            }
            b'\r' => starts.push(at as u32 + 1),
            _ => {}
        }
        at += 1;
    }
    (starts, plain)
}

/// UTF-16 length of some bytes, as a browser counts them after decoding: a byte that is not UTF-8 counts as
/// one unit (the replacement character).
fn utf16_len(bytes: &[u8]) -> u32 {
    if bytes.is_ascii() {
        return bytes.len() as u32;
    }
    chars(bytes).map(|(_, units)| units).sum()
}

/// Byte position and UTF-16 length of each character; a maximal invalid sequence of the decoder is one
/// character.
fn chars(bytes: &[u8]) -> impl Iterator<Item = (usize, u32)> {
    let mut at = 0;
    bytes.utf8_chunks().flat_map(move |chunk| {
        let (start, end) = (at, at + chunk.valid().len());
        at = end + chunk.invalid().len();
        let valid = chunk.valid().char_indices().map(move |(i, ch)| (start + i, ch.len_utf16() as u32));
        valid.chain((!chunk.invalid().is_empty()).then_some((end, 1)))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Compares with the UTF-16 encoding of the text before the byte.
    #[test]
    fn offsets_as_written_count_what_is_there() {
        let texts = [
            "G0X1\nX2\n",
            "G0X1\r\nX2\r\n",
            "G0X1\rX2\r",
            "G0 (外圆)\r\nX1\rZ😀2\n\r\n(ж)\r\r\nX3",
            &format!("({})\r\nX1 (é)\r\nX2", "外😀".repeat(300)),
        ];
        for text in texts {
            let index = LineIndex::as_written(text.as_bytes());
            for (byte, _) in text.char_indices() {
                let units = text[..byte].encode_utf16().count() as u32;
                assert_eq!(index.utf16_offset(text.as_bytes(), byte as u32), units, "{text:?} {byte}");
            }
            let (written, folded) = (index.line_column(text.as_bytes(), 9), LineIndex::new(text.as_bytes()));
            assert_eq!(written, folded.line_column(text.as_bytes(), 9));
        }
    }

    #[test]
    fn columns_count_utf16_units_and_any_line_end() {
        let text = "G0 (外圆)\r\nX1\rZ😀2\n".as_bytes();
        let index = LineIndex::new(text);
        assert_eq!(index.len(), 4);
        let x = text.iter().position(|&b| b == b'X').unwrap() as u32;
        assert_eq!(index.line_column(text, x), LineColumn { line: 1, column: 0 });
        let two = text.iter().position(|&b| b == b'2').unwrap() as u32;
        assert_eq!(index.line_column(text, two), LineColumn { line: 2, column: 3 });
        assert_eq!(index.utf16_offset(text, x), 8);
        assert_eq!(index.line(text, 1).of(text), b"X1");
        for byte in [0, 4, x, two, text.len() as u32] {
            assert_eq!(index.byte_at_utf16(text, index.utf16_offset(text, byte)), byte);
        }
    }

    /// Checks that the index after an edit equals a new index of the text.
    fn check_edit(text: &mut Vec<u8>, index: &mut LineIndex, replaced: Range<usize>, insert: &[u8]) {
        let before = String::from_utf8_lossy(text).into_owned();
        text.splice(replaced.clone(), insert.iter().copied());
        index.edit(text, replaced.clone(), insert.len());
        let expected = LineIndex::new(text);
        assert_eq!(index.starts, expected.starts, "{before:?} {replaced:?} {insert:?}");
        // Marks stay after the last character that needed them is removed.
        if !expected.marks.is_empty() {
            assert_eq!(index.marks, expected.marks, "{before:?} {replaced:?} {insert:?}");
        }
        for byte in 0..=text.len() as u32 {
            let (found, expected) = (index.utf16_offset(text, byte), expected.utf16_offset(text, byte));
            assert_eq!(found, expected, "{before:?} {replaced:?} {insert:?} {byte}");
        }
    }

    #[test]
    fn an_edit_joins_and_parts_line_ends() {
        for (before, replaced, insert) in [
            ("a\rb", 2..2, "\n"),
            ("a\nb", 1..1, "\r"),
            ("a\r\nb", 2..2, "x"),
            ("a\r\nb", 1..2, ""),
            ("a\r\nb", 2..3, ""),
            ("a\rx\nb", 2..3, ""),
            ("\n", 0..1, ""),
            ("", 0..0, "外\r\n"),
            ("a\nb\nc", 0..5, ""),
            ("a\nb\nc", 5..5, "\n"),
            ("a\r", 2..2, "\n"),
        ] {
            let mut text = before.as_bytes().to_vec();
            let mut index = LineIndex::new(&text);
            check_edit(&mut text, &mut index, replaced, insert.as_bytes());
        }
    }

    #[test]
    fn the_first_sign_beyond_ascii_finds_long_lines_elsewhere() {
        let line = "X1 ".repeat(2 * STRIDE);
        let mut text = format!("{line}\nZ\n{line}").into_bytes();
        let mut index = LineIndex::new(&text);
        let behind = line.len() + 2;
        check_edit(&mut text, &mut index, behind..behind, "外".as_bytes());
        check_edit(&mut text, &mut index, 0..0, "外".as_bytes());
    }

    #[test]
    fn many_edits_leave_the_index_of_the_text() {
        let pieces: [&[u8]; 9] =
            [b"\r", b"\n", b"\r\n", b"X1", b"G0 Z2\n", "外".as_bytes(), "😀\r\nZ".as_bytes(), b"\xff", b""];
        let mut seed = 1u32;
        let mut below = |most: usize| {
            seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (seed >> 8) as usize % most
        };
        for _ in 0..200 {
            let mut text = b"G0 X1\nZ2\n".to_vec();
            let mut index = LineIndex::new(&text);
            for _ in 0..30 {
                let start = below(text.len() + 1);
                let end = (start + below(4)).min(text.len());
                check_edit(&mut text, &mut index, start..end, pieces[below(pieces.len())]);
            }
        }
    }

    #[test]
    fn bytes_that_are_not_utf8_count_one_unit_each() {
        let text = b"(\xff\xfe) X1";
        let index = LineIndex::new(text);
        assert_eq!(index.line_column(text, 5).column, 5);
    }

    /// A text may be a single line, and thousands of its places may be converted.
    #[test]
    fn places_in_a_long_line_are_those_of_a_count_from_its_beginning() {
        let text = "X1 外😀;".repeat(300).into_bytes();
        let text = [&text[..], b"\r\n\xff\xe5\xa4", &text[..], b"\xe5"].concat();
        let index = LineIndex::new(&text);
        let second = index.starts[1] as usize;
        for byte in 0..=text.len() {
            let start = if byte < second { 0 } else { second };
            let column = utf16_len(&text[start..byte]);
            assert_eq!(index.line_column(&text, byte as u32).column, column, "{byte}");
        }
        let last = index.utf16_offset(&text, text.len() as u32);
        for offset in 0..=last {
            let byte = index.byte_at_utf16(&text, offset);
            assert!(index.utf16_offset(&text, byte) >= offset, "{offset}");
        }
    }
}
