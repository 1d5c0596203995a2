//! Classifies the text for the colours of an editor.
//!
//! In: some lines of the text. Out: classified spans in order. The page does not know G-code: it only maps
//! class numbers to colours.

use super::block::{Block, BlockKind, Value};
use super::lexer::{Lexer, TokenKind};
use super::parser::{Parser, Resume};
use crate::order;
use crate::source::Span;

/// The class of a piece of text, for its colour.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum TokenClass {
    /// A comment.
    Comment = 0,
    /// A G word.
    GCode = 1,
    /// An M word.
    MCode = 2,
    /// An axis word: X Z U W C H Y V.
    Axis = 3,
    /// Another data word: R I K P Q …
    Data = 4,
    /// A program or sequence number.
    Number = 5,
    /// F, S, T.
    Technology = 6,
    /// A macro statement or expression.
    Macro = 7,
    /// Not recognised.
    Unknown = 8,
    /// `%`, `;`, `/`.
    Punctuation = 9,
}

/// The classified pieces of the lines from `start` (the first byte of a line) to byte `end`, in order of
/// place.
pub fn highlight(text: &[u8], start: usize, end: usize) -> Vec<(Span, TokenClass)> {
    let part = &text[..end.min(text.len())];
    let mut parser = Parser::resume(part, Resume::inside(start as u32, 0));
    let mut block = Block::default();
    let mut found = Vec::new();
    while parser.next_block(&mut block) {
        found.extend(block.comments.iter().map(|&span| (span, TokenClass::Comment)));
        match block.kind {
            BlockKind::Percent => found.push((block.span, TokenClass::Punctuation)),
            BlockKind::Macro => found.push((without_comments(&block), TokenClass::Macro)),
            BlockKind::Words => {}
        }
        if let Some((_, span)) = block.program {
            found.push((span, TokenClass::Number));
        }
        if block.sequence.is_some() {
            found.extend(sequence_span(part, &block).map(|span| (span, TokenClass::Number)));
        }
        for word in &block.words {
            let class = match (word.address, word.value) {
                (_, Value::Expression) => TokenClass::Macro,
                (b'G', _) => TokenClass::GCode,
                (b'M', _) => TokenClass::MCode,
                (b'X' | b'Z' | b'U' | b'W' | b'C' | b'H' | b'Y' | b'V', _) if !word.comma => TokenClass::Axis,
                (b'F' | b'S' | b'T', _) => TokenClass::Technology,
                (b'O' | b'N', _) => TokenClass::Number,
                _ => TokenClass::Data,
            };
            found.push((word.span, class));
        }
        let errors = block.faults.iter().filter(|fault| fault.is_error());
        found.extend(errors.map(|fault| (fault.span, TokenClass::Unknown)));
    }
    found.retain(|(span, _)| !span.is_empty());
    order::by_key(&mut found, |(span, _)| span.start);
    // Errors may overlap words: the first of two overlapping pieces is kept, so that spans never overlap.
    let mut last = 0;
    found.retain(|(span, _)| {
        let keep = span.start >= last;
        if keep {
            last = span.end;
        }
        keep
    });
    found
}

/// The part of a macro block before its first comment.
fn without_comments(block: &Block) -> Span {
    let end = block.comments.first().map_or(block.span.end, |comment| comment.start);
    Span { start: block.span.start, end: end.max(block.span.start) }
}

/// The span of `N10` at the head of a block.
pub fn sequence_span(text: &[u8], block: &Block) -> Option<Span> {
    block.sequence?;
    let heads = block.program.iter().chain(&block.second_name);
    let start = heads.map(|(_, span)| span.end).max().unwrap_or(block.span.start);
    let mut tokens = Lexer::new(&text[..block.span.end as usize], start as usize);
    let letter = tokens.find(|token| token.kind == TokenKind::Letter(b'N'))?.span;
    let number = tokens.find(|token| token.kind != TokenKind::Blank)?;
    matches!(number.kind, TokenKind::Number(_)).then(|| letter.to(number.span))
}
