//! Finds programs inside other text: copied from a PDF, a slide, a forum, a chat.
//!
//! In: any text. Out: the programs in it, each as [`Piece`]s: old text, new text, and reason. The pieces of a
//! program cover its range of the text without gaps, so nothing is lost unnoticed. Ambiguities, such as a
//! minus sign lost in print, become questions; nothing is guessed. Knows the syntax of G-code, not its
//! meaning.
//!
//! ```text
//! text ──► items ──► blocks ──► programs ──► pieces
//!      words, prose   split at N, `;`   what belongs together
//! ```

mod blocks;
mod items;
mod pieces;
mod programs;
mod reason;
mod signs;

pub use reason::Reason;

use crate::limits::{MAX_FOUND_PROGRAMS, MAX_PASTED_TEXT};
use crate::source::Span;

/// The programs found in a text.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Found {
    /// The programs, in text order.
    pub programs: Vec<Program>,
    /// Number of further programs that are not listed.
    pub more: usize,
    /// Whether the text exceeds the length limit, so it was not searched.
    pub too_long: bool,
    /// How much of the result the user should review.
    pub review: Review,
}

/// How far a text is from a valid program, in increasing order.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Review {
    /// It is a program, or has only faults that the parser fixes as well.
    #[default]
    Nothing,
    /// It is a program except for a few stray characters.
    FewCharacters,
    /// It contains prose, or a program needed further corrections.
    Programs,
}

/// A program found in a text.
#[derive(Clone, Debug, PartialEq)]
pub struct Program {
    /// Its name.
    pub name: Name,
    /// Its range of the text.
    pub span: Span,
    /// First and last line, from 0.
    pub lines: (u32, u32),
    /// The pieces that cover its range without gaps.
    pub pieces: Vec<Piece>,
}

/// Name of a program.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Name {
    /// Its O number.
    Number(u32),
    /// The title before it.
    Title(String),
    /// It has no name: the line it begins in, from 0.
    Line(u32),
}

/// A range of the text, and its replacement.
#[derive(Clone, Debug, PartialEq)]
pub struct Piece {
    /// The old range; empty for an insertion.
    pub span: Span,
    /// The new text.
    pub now: String,
    /// Reason for the change; `None` if it is unchanged or only white space differs.
    pub reason: Option<Reason>,
    /// Possible readings, the printed one first; fewer than two if it is not a question.
    pub choices: Vec<String>,
}

impl Piece {
    /// Whether the user must choose a reading.
    pub fn is_question(&self) -> bool {
        self.choices.len() > 1
    }

    /// Whether it was corrected or omitted.
    pub fn is_change(&self) -> bool {
        self.reason.is_some() && !self.is_question()
    }
}

impl Program {
    /// The cleaned text, one block per line; questions are answered as printed.
    pub fn text(&self) -> String {
        self.pieces.iter().map(|piece| piece.now.as_str()).collect()
    }

    /// The cleaned text, with an answer (the index of a choice) for each question, in order.
    pub fn answered(&self, mut answer: impl FnMut(&Piece) -> usize) -> String {
        let mut text = String::new();
        for piece in &self.pieces {
            let chosen = if piece.is_question() { piece.choices.get(answer(piece)) } else { None };
            text.push_str(chosen.unwrap_or(&piece.now));
        }
        text
    }

    /// The pieces that were corrected or omitted.
    pub fn changes(&self) -> impl Iterator<Item = &Piece> {
        self.pieces.iter().filter(|piece| piece.is_change())
    }

    /// The pieces that the user must decide.
    pub fn questions(&self) -> impl Iterator<Item = &Piece> {
        self.pieces.iter().filter(|piece| piece.is_question())
    }
}

/// Finds the programs in a text.
///
/// ```
/// use gcode_playground::paste::find;
///
/// let found = find("Example: O0001; G00 X32 Z2; G01 Z–30 F0.1; M30;\nSee figure 4.");
/// assert_eq!(found.programs[0].text(), "O0001;\nG00 X32 Z2;\nG01 Z-30 F0.1;\nM30;\n");
/// ```
pub fn find(text: &str) -> Found {
    if text.len() > MAX_PASTED_TEXT {
        return Found { too_long: true, ..Found::default() };
    }
    let items = items::read(text);
    let mut blocks = blocks::assemble(text, &items);
    let stretches = programs::join(&items, &mut blocks);
    let more = stretches.len().saturating_sub(MAX_FOUND_PROGRAMS);
    let mut programs = Vec::new();
    let mut line = LineCount::default();
    for stretch in stretches.iter().take(MAX_FOUND_PROGRAMS) {
        let mut pieces = pieces::write(text, &items, &blocks, stretch);
        signs::ask(text, &items, &blocks, stretch, &mut pieces);
        let span = pieces.first().zip(pieces.last()).map_or_else(Span::default, |(a, z)| a.span.to(z.span));
        let lines = (line.of(text, span.start), line.of(text, span.end));
        let name = programs::name(text, &items, &blocks, stretch, lines.0);
        programs.push(Program { name, span, lines, pieces });
    }
    let review = if more > 0 { Review::Programs } else { review(text, &items, &programs) };
    Found { programs, more, too_long: false, review }
}

/// Maximum number of stray characters that count as few.
const FEW: usize = 3;

/// How far the text is from valid programs.
fn review(text: &str, items: &[items::Item], programs: &[Program]) -> Review {
    if programs.is_empty() {
        return Review::Nothing;
    }
    // The parser also treats text after `;` as a comment.
    let remark = |piece: &Piece| {
        piece.reason == Some(Reason::Remark) && text[..piece.span.start as usize].ends_with([';', '；'])
    };
    let needs_more = |piece: &&Piece| {
        let more = piece.reason.is_some_and(|reason| !reason.is_parsers_own());
        piece.is_question() || (more && !remark(piece))
    };
    let mut characters = 0;
    for piece in programs.iter().flat_map(|program| &program.pieces).filter(needs_more) {
        if piece.is_question() || !piece.reason.is_some_and(Reason::is_of_characters) {
            return Review::Programs;
        }
        characters += 1;
    }
    let mut next = programs.iter().map(|program| program.span).peekable();
    let around = items.iter().any(|item| {
        while next.peek().is_some_and(|span| span.end <= item.span.start) {
            next.next();
        }
        let inside = next.peek().is_some_and(|span| span.start <= item.span.start);
        !inside && item.kind.is_text(text, item.span)
    });
    match characters {
        _ if around => Review::Programs,
        0 => Review::Nothing,
        1..=FEW => Review::FewCharacters,
        _ => Review::Programs,
    }
}

/// Counts lines for increasing offsets.
#[derive(Default)]
struct LineCount {
    at: usize,
    line: u32,
}

impl LineCount {
    fn of(&mut self, text: &str, byte: u32) -> u32 {
        let to = (byte as usize).max(self.at);
        let bytes = &text.as_bytes()[self.at..to];
        let lone = |i: usize| bytes[i] == b'\r' && text.as_bytes().get(self.at + i + 1) != Some(&b'\n');
        self.line += (0..bytes.len()).filter(|&i| bytes[i] == b'\n' || lone(i)).count() as u32;
        self.at = to;
        self.line
    }
}
