//! A text extracted from a page, with the position of each of its bytes in the page.
//!
//! In: pieces of a page, verbatim or decoded (`&lt;` is `<`). Out: the text, and the mapping of its spans to
//! spans of the page. Must not know: the meaning of either.

use std::ops::Range;

use crate::source::Span;

/// A text with its positions in a page.
#[derive(Clone, Debug, Default)]
pub struct Mapped {
    text: Vec<u8>,
    /// In text order, without gaps or empty pieces.
    pieces: Vec<Piece>,
}

/// A range of the text.
#[derive(Clone, Copy, Debug)]
struct Piece {
    /// Its first byte in the text.
    start: usize,
    /// Its range in the page.
    page: (usize, usize),
    /// Whether it is verbatim, byte for byte.
    same: bool,
}

impl Mapped {
    /// A part of a page, verbatim.
    pub fn of(page: &[u8], range: Range<usize>) -> Self {
        let mut mapped = Self::default();
        mapped.keep(page, range);
        mapped
    }

    /// The text.
    pub fn text(&self) -> &[u8] {
        &self.text
    }

    /// Appends a part of the page, verbatim.
    pub fn keep(&mut self, page: &[u8], range: Range<usize>) {
        self.piece(&page[range.clone()], (range.start, range.end), true);
    }

    /// Appends `text`, the decoded form of a part of the page.
    pub fn read(&mut self, text: &[u8], page: &[u8], range: Range<usize>) {
        let same = page[range.clone()] == *text;
        self.piece(text, (range.start, range.end), same);
    }

    /// Appends a part of another text of the same page.
    pub fn keep_of(&mut self, other: &Self, range: Range<usize>) {
        if range.is_empty() {
            return;
        }
        let first = other.piece_at(range.start);
        for (index, piece) in other.pieces.iter().enumerate().skip(first) {
            if piece.start >= range.end {
                break;
            }
            let end = other.end_of(index).min(range.end);
            let start = piece.start.max(range.start);
            let page = match piece.same {
                true => (piece.page.0 + start - piece.start, piece.page.0 + end - piece.start),
                false => piece.page,
            };
            self.piece(&other.text[start..end], page, piece.same);
        }
    }

    /// Appends `text`, the decoded form of a part of another text of the same page.
    pub fn read_of(&mut self, text: &[u8], other: &Self, range: Range<usize>) {
        let Span { start, end } = other.in_page(Span::new(range.start, range.end));
        self.piece(text, (start as usize, end as usize), false);
    }

    /// A part of this text.
    pub fn part(&self, range: Range<usize>) -> Self {
        let mut part = Self::default();
        part.keep_of(self, range);
        part
    }

    /// Converts a span of the text to a span of the page.
    pub fn in_page(&self, span: Span) -> Span {
        let start = self.start_in_page(span.start as usize);
        let end = if span.is_empty() { start } else { self.end_in_page(span.end as usize) };
        Span::new(start, end.max(start))
    }

    /// Position in the page where a byte begins; the end position for an offset past the last byte.
    fn start_in_page(&self, at: usize) -> usize {
        if at >= self.text.len() {
            return self.pieces.last().map_or(0, |last| last.page.1);
        }
        let piece = self.pieces[self.piece_at(at)];
        if piece.same { piece.page.0 + at - piece.start } else { piece.page.0 }
    }

    /// Position in the page where the byte before `at` ends.
    fn end_in_page(&self, at: usize) -> usize {
        let at = at.min(self.text.len());
        let Some(last) = at.checked_sub(1) else { return self.start_in_page(0) };
        let piece = self.pieces[self.piece_at(last)];
        if piece.same { piece.page.0 + at - piece.start } else { piece.page.1 }
    }

    fn piece_at(&self, at: usize) -> usize {
        self.pieces.partition_point(|piece| piece.start <= at).saturating_sub(1)
    }

    fn end_of(&self, index: usize) -> usize {
        self.pieces.get(index + 1).map_or(self.text.len(), |next| next.start)
    }

    fn piece(&mut self, text: &[u8], page: (usize, usize), same: bool) {
        if text.is_empty() {
            return;
        }
        let goes_on = self.pieces.last().is_some_and(|last| last.same && same && last.page.1 == page.0);
        match self.pieces.last_mut() {
            Some(last) if goes_on => last.page.1 = page.1,
            _ => self.pieces.push(Piece { start: self.text.len(), page, same }),
        }
        self.text.extend_from_slice(text);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_byte_has_a_place() {
        let page = b"> G00 &lt;\r\n> X1";
        let mut mapped = Mapped::of(page, 2..6);
        mapped.read(b"<", page, 6..10);
        mapped.read(b"\n", page, 10..12);
        mapped.keep(page, 14..16);
        assert_eq!(mapped.text(), b"G00 <\nX1");
        let place = |start, end| {
            let Span { start, end } = mapped.in_page(Span::new(start, end));
            (start, end)
        };
        assert_eq!([place(0, 3), place(4, 5), place(4, 6)], [(2, 5), (6, 10), (6, 12)]);
        assert_eq!(
            [place(6, 8), place(6, 6), place(8, 8), place(0, 0)],
            [(14, 16), (14, 14), (16, 16), (2, 2)]
        );
        assert_eq!([place(5, 5), place(0, 8), place(99, 99)], [(10, 10), (2, 16), (16, 16)]);
    }

    #[test]
    fn a_part_of_a_part_keeps_its_places() {
        let page = b"ab&amp;cd";
        let mut mapped = Mapped::of(page, 0..2);
        mapped.read(b"&", page, 2..7);
        mapped.keep(page, 7..9);
        let part = mapped.part(1..4).part(1..3);
        assert_eq!(part.text(), b"&c");
        assert_eq!(part.in_page(Span::new(0, 1)), Span::new(2, 7));
        assert_eq!(part.in_page(Span::new(1, 2)), Span::new(7, 8));
        assert!(mapped.part(2..2).text().is_empty());
        assert_eq!(Mapped::default().in_page(Span::new(0, 3)), Span::new(0, 0));
    }
}
