//! Blocks and words of a program as written.

use super::lexer::Number;
use crate::limits::WORDS_PER_BLOCK;
use crate::message::{Diagnostic, said};
use crate::source::Span;
use crate::source::shift::Shift;

/// The value of a word.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Value {
    /// A signed number.
    Number {
        /// Digits and point.
        number: Number,
        /// Whether it has a minus sign.
        negative: bool,
    },
    /// A macro expression (`#1`, `[#1+2]`), not yet evaluated.
    Expression,
}

/// An address letter with its value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Word {
    /// The address, an upper-case ASCII letter.
    pub address: u8,
    /// Whether a comma precedes the letter (`,C2`).
    pub comma: bool,
    /// The value.
    pub value: Value,
    /// Letter, sign and number.
    pub span: Span,
}

/// The kind of a block.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum BlockKind {
    /// Words, possibly none.
    #[default]
    Words,
    /// A lone `%`: the start or end of the tape.
    Percent,
    /// A macro statement: an assignment or `IF`, `WHILE`, `GOTO`, `DO`, `END`.
    Macro,
}

/// A block: everything up to a line end or `;`. Its storage is reused for each block.
#[derive(Clone, Debug, Default)]
pub struct Block {
    /// All its bytes including comments, without the end of block.
    pub span: Span,
    /// Line, from 0.
    pub line: u32,
    /// The kind of the block.
    pub kind: BlockKind,
    /// Level of block delete: `/` and `/1` are 1.
    pub delete: Option<u8>,
    /// A slash within the block: index of the first word under block delete, and the level.
    pub optional: Option<(usize, u8)>,
    /// Program number (`O1234`) at its head, or the number of its [name](super::program_name).
    pub program: Option<(u32, Span)>,
    /// The number of the name after a program number, and the name: `O1234<NAME>`.
    pub second_name: Option<(u32, Span)>,
    /// Sequence number (`N10`) at its head.
    pub sequence: Option<u32>,
    /// The other words, in order.
    pub words: Vec<Word>,
    /// Comments, including brackets.
    pub comments: Vec<Span>,
    /// Errors in its notation.
    pub faults: Vec<Diagnostic>,
    /// First byte of its macro statement, if it is one.
    pub statement: u32,
    /// End of the macro statement, without the blanks and comments after it.
    pub statement_end: u32,
    /// Whether some words contain macro expressions.
    pub has_expressions: bool,
    /// Whether the block has errors in its notation, and the [part](crate::text::parser::READS_FAULTS) that
    /// reads such blocks is not loaded: then this block is incomplete or wrong.
    pub is_unread: bool,
    /// Whether it has more words than are kept.
    overlong: bool,
}

impl Block {
    /// Whether it contains nothing to execute.
    pub fn is_empty(&self) -> bool {
        self.kind == BlockKind::Words && self.words.is_empty() && self.program.is_none()
    }

    /// Whether an error in its notation prevents its execution.
    pub fn is_broken(&self) -> bool {
        self.faults.iter().any(|fault| fault.is_error() && !is_read_as_meant(fault))
    }

    /// Whether it has more words than are kept.
    pub fn is_overlong(&self) -> bool {
        self.overlong
    }

    /// Adds a word. A block that never ends is cut off and gets an error.
    #[inline]
    pub(super) fn word(&mut self, word: Word) {
        if self.words.len() < WORDS_PER_BLOCK {
            self.words.push(word);
        } else if !self.overlong {
            self.overlong = true;
            self.faults.clear();
            self.fault(Diagnostic::new(said::BlockTooLong { most: WORDS_PER_BLOCK }, word.span));
        }
    }

    pub(super) fn comment(&mut self, span: Span) {
        if self.comments.len() < WORDS_PER_BLOCK {
            self.comments.push(span);
        }
    }

    /// Whether no more words or errors are kept.
    pub(super) fn is_full(&self) -> bool {
        // One error more than words: a block of misread words is reported as too long.
        self.faults.len() > WORDS_PER_BLOCK || self.overlong
    }

    pub(super) fn fault(&mut self, fault: Diagnostic) {
        // One mistake, one message: words may be split where a block is cut off.
        if !self.is_full() || self.faults.is_empty() {
            self.faults.push(fault);
        }
    }

    pub(super) fn clear(&mut self) {
        self.overlong = false;
        self.is_unread = false;
        self.kind = BlockKind::Words;
        self.delete = None;
        self.optional = None;
        self.has_expressions = false;
        self.program = None;
        self.second_name = None;
        self.sequence = None;
        self.words.clear();
        self.comments.clear();
        self.faults.clear();
    }

    /// Shifts its spans after a change of the text before them.
    pub(super) fn shift(&mut self, shift: &Shift) {
        let words = self.words.iter_mut().map(|word| &mut word.span);
        let program = self.program.iter_mut().chain(&mut self.second_name).map(|(_, span)| span);
        for span in words.chain(program).chain(&mut self.comments).chain([&mut self.span]) {
            *span = shift.span(*span);
        }
        self.faults.iter_mut().for_each(|fault| fault.shift(shift));
        (self.statement, self.statement_end) = (shift.byte(self.statement), shift.byte(self.statement_end));
    }

    /// From the first word to the last, or the macro statement; the whole block if it has neither.
    pub fn words_span(&self) -> Span {
        match (self.words.first(), self.words.last()) {
            (Some(first), Some(last)) => first.span.to(last.span),
            _ if self.kind == BlockKind::Macro => Span { start: self.statement, end: self.statement_end },
            _ => self.span,
        }
    }
}

/// Whether the word of an error in the notation was read as it can only be meant: a comma that is the decimal
/// point, the letter O that is a zero. The block is executed, so that one typing error has no further messages.
pub fn is_read_as_meant(fault: &Diagnostic) -> bool {
    let has_one_reading =
        fault.message.is::<said::CommaForPoint>() || fault.message.is::<said::LetterForDigit>();
    has_one_reading && fault.fixes.iter().any(|fix| fix.safe)
}
