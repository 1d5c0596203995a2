//! Comments over several lines: `(FIRST LINE`, `SECOND LINE 1.5`, `THIRD)`. A control ignores everything up
//! to the `)`.
//!
//! In: a text and a place in it. Out: the end of such a comment. It is limited to a few lines of text; a line
//! that is a valid block is executed. So a change of the text affects at most [`LINES`] lines around it.

use crate::source::Span;

/// Most lines of a comment after its first.
pub const LINES: usize = 6;

/// Most bytes of a comment.
const BYTES: usize = 600;

/// The ends of the lines of a comment with `(` at byte `open`, and the byte after its `)`. `None` if it ends
/// on its line, if there is another bracket before or in it, or if one of the other lines contains no word of
/// text.
pub fn over_lines(text: &[u8], open: usize) -> Option<(Vec<u32>, usize)> {
    let before = text[open.saturating_sub(BYTES)..open].iter().rev().take_while(|&&byte| byte != b'\n');
    if text[open] != b'(' || before.into_iter().any(|&byte| byte == b'(') {
        return None;
    }
    let text = &text[..text.len().min(open + BYTES)];
    let (mut ends, mut before, mut has_text) = (Vec::new(), b' ', true);
    for (at, &byte) in text.iter().enumerate().skip(open + 1) {
        match byte {
            b'(' => return None,
            b')' => {
                let rest = text[at + 1..].iter().find(|byte| !matches!(byte, b' ' | b'\t' | b'\r'));
                let is_last = matches!(rest, None | Some(b'\n'));
                return (is_last && has_text && !ends.is_empty()).then_some((ends, at + 1));
            }
            b'\n' if !has_text || ends.len() == LINES => return None,
            b'\n' => {
                ends.push(at as u32);
                has_text = false;
            }
            _ => has_text |= is_letter(byte) && is_letter(before),
        }
        before = byte;
    }
    None
}

/// Whether a block continues such a comment.
pub fn continues(text: &[u8], block: Span) -> bool {
    let start = block.start as usize;
    let from = start.saturating_sub(BYTES);
    let bracket = text[from..start].iter().rposition(|byte| matches!(byte, b'(' | b')'));
    bracket
        .and_then(|open| over_lines(text, from + open))
        .is_some_and(|(ends, end)| ends[0] < block.start && start < end)
}

fn is_letter(byte: u8) -> bool {
    byte.is_ascii_alphabetic() || byte >= 0x80
}

/// The range around a change of the text in which lines may now be read differently.
pub fn around(text: &[u8], start: usize, end: usize) -> (usize, usize) {
    let is_end = |byte: &&u8| **byte == b'\n';
    let lines = |bytes: &mut dyn Iterator<Item = &u8>| {
        let mut left = LINES + 1;
        bytes
            .take(2 * BYTES)
            .take_while(|byte| {
                left -= usize::from(is_end(byte));
                left > 0
            })
            .count()
    };
    (start - lines(&mut text[..start].iter().rev()), end + lines(&mut text[end..].iter()))
}
