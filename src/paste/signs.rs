//! Detects that print has lost all minus signs, and asks the user.
//!
//! In: the blocks and pieces of a program. Out: questions at the words that may have been negative. A turning
//! program whose cuts go from the clearance at the face to larger Z, without any minus sign, has lost them. A
//! program with its zero at the chuck cuts toward smaller Z. Nothing is decided here.

use super::Piece;
use super::blocks::Blocks;
use super::items::{Item, Kind, Word};
use super::programs::Stretch;
use super::reason::Reason;
use crate::order;
use crate::source::Span;

/// Minimum number of cuts away from the part.
const MIN_CUTS: usize = 2;

/// Adds a question wherever a minus sign seems to be missing.
pub(super) fn ask(text: &str, items: &[Item], blocks: &Blocks, stretch: &Stretch, pieces: &mut Vec<Piece>) {
    let Some(ambiguous) = ambiguous(items, blocks, stretch) else { return };
    let mut asked = ambiguous.into_iter().peekable();
    let mut split = Vec::with_capacity(pieces.len());
    for piece in pieces.drain(..) {
        if piece.reason.is_some() {
            while asked.next_if(|span| span.start < piece.span.end).is_some() {}
            split.push(piece);
            continue;
        }
        // White space of unchanged pieces is normalised, so search for the words in the new text.
        let (mut from, mut rest) = (piece.span.start, piece.now.as_str());
        while let Some(span) = asked.next_if(|span| span.start < piece.span.end) {
            let word = &text[span.start as usize..span.end as usize];
            // The words between are the same in both texts, in the same order.
            let skipped =
                text[from as usize..span.start as usize].split_whitespace().map(str::len).sum::<usize>();
            let Some(place) = after_words(rest, skipped).filter(|&at| rest[at..].starts_with(word)) else {
                continue;
            };
            if place > 0 {
                split.push(Piece {
                    span: Span { start: from, end: span.start },
                    now: rest[..place].to_string(),
                    ..blank_piece()
                });
            }
            let (letter, number) = word.split_at(1);
            split.push(Piece {
                span,
                now: word.to_string(),
                reason: Some(Reason::LostMinus),
                choices: vec![word.to_string(), format!("{letter}-{}", number.trim_start())],
            });
            (from, rest) = (span.end, &rest[place + word.len()..]);
        }
        if from < piece.span.end || !rest.is_empty() {
            split.push(Piece {
                span: Span { start: from, end: piece.span.end },
                now: rest.to_string(),
                ..blank_piece()
            });
        }
    }
    *pieces = split;
}

fn blank_piece() -> Piece {
    Piece { span: Span::default(), now: String::new(), reason: None, choices: Vec::new() }
}

/// The offset after `bytes` bytes that are not white space, and the white space after them.
fn after_words(text: &str, bytes: usize) -> Option<usize> {
    let mut left = bytes;
    for (at, c) in text.char_indices() {
        if c.is_whitespace() {
            continue;
        }
        if left == 0 {
            return Some(at);
        }
        left = left.checked_sub(c.len_utf8())?;
    }
    None
}

/// The words that may have lost a minus sign; `None` if the program contains one, or cuts toward the part.
fn ambiguous(items: &[Item], blocks: &Blocks, stretch: &Stretch) -> Option<Vec<Span>> {
    let mut code = 0;
    let mut clearance: Option<f64> = None;
    let mut depths: Vec<f64> = Vec::new();
    let mut others = 0;
    let mut tapers: Vec<Span> = Vec::new();
    let mut depth_words: Vec<(f64, Span)> = Vec::new();
    for &number in &stretch.blocks {
        let block = &blocks.list[number as usize];
        let words = || {
            (block.first..block.end).filter(|&at| blocks.owner[at] == number).filter_map(|at| {
                match items[at].kind {
                    Kind::Word(word) => Some((word, items[at].span)),
                    _ => None,
                }
            })
        };
        let mut another = false;
        for (word, _) in words() {
            if word.value < 0.0 || word.value.is_nan() || word.lost_sign || matches!(word.letter, b'W' | b'U')
            {
                return None;
            }
            if word.letter == b'G' {
                match word.tenths() {
                    tenths @ (0 | 10 | 20 | 30 | 320 | 900 | 920 | 940) => code = tenths,
                    // The axis words of these codes cut nothing.
                    40 | 280 | 300 | 500 | 530 => another = true,
                    _ => {}
                }
            }
        }
        if another {
            continue;
        }
        let z = words().find(|(word, _)| word.letter == b'Z');
        if let Some((word, span)) = z {
            depth_words.push((word.value, span));
            if code == 0 {
                clearance = Some(word.value);
            } else if clearance.is_some_and(|from| word.value > from) {
                depths.push(word.value);
            } else {
                others += 1;
            }
        }
        if code >= 900 {
            tapers.extend(words().filter(|(word, _)| is_taper(*word)).map(|(_, span)| span));
        }
    }
    if depths.len() < MIN_CUTS || depths.len() < others {
        return None;
    }
    let mut asked: Vec<Span> =
        depth_words.into_iter().filter(|(z, _)| depths.contains(z)).map(|(_, span)| span).collect();
    asked.extend(tapers);
    order::by_key(&mut asked, |span| span.start);
    Some(asked)
}

fn is_taper(word: Word) -> bool {
    matches!(word.letter, b'R' | b'I' | b'K') && word.value > 0.0
}
