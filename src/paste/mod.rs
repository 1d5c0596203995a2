//! Programs inside other text: what comes out of a PDF, a slide, a forum, a chat.
//!
//! In: any text. Out: the programs found in it, each as [`Piece`]s: what stood there, what stands there now,
//! and why. The pieces of a program, one after the other, are its stretch of the text without a gap, so
//! nothing is lost unseen. What cannot be known, such as a sign that print has lost, is asked, never guessed.
//! Knows the look of G-code, not its meaning.
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

use crate::limits::{FOUND_PROGRAMS, PASTED_TEXT};
use crate::source::Span;

/// What a text holds.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Found {
    /// In the order in which they stand.
    pub programs: Vec<Program>,
    /// Programs beyond those that are listed.
    pub more: usize,
    /// The text is longer than is looked through.
    pub too_long: bool,
    /// How much the reader has to see of it.
    pub review: Review,
}

/// How far a text is from a program as a control takes it, least first.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Review {
    /// It is one, or only has faults that the parser repairs itself.
    #[default]
    Nothing,
    /// It is one but for a few stray characters.
    FewCharacters,
    /// Prose stands around it, or a program had to be repaired by more than that.
    Programs,
}

/// A program found in a text.
#[derive(Clone, Debug, PartialEq)]
pub struct Program {
    /// What it goes by.
    pub name: Name,
    /// Its stretch of the text.
    pub span: Span,
    /// First and last line, from 0.
    pub lines: (u32, u32),
    /// Its stretch, without a gap.
    pub pieces: Vec<Piece>,
}

/// What a program goes by.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Name {
    /// Its O number.
    Number(u32),
    /// What stands before it.
    Title(String),
    /// Nothing names it: the line it begins in, from 0.
    Line(u32),
}

/// A stretch of the text, and what becomes of it.
#[derive(Clone, Debug, PartialEq)]
pub struct Piece {
    /// Where it stood; empty where something is put in.
    pub span: Span,
    /// What stands there now.
    pub now: String,
    /// Why it is no longer what it was; nothing where it stayed, or only blanks changed.
    pub reason: Option<Reason>,
    /// What it can be read as, the first of them as printed; fewer than two where nothing is asked.
    pub choices: Vec<String>,
}

impl Piece {
    /// Whether the reader is to say what it is.
    pub fn is_question(&self) -> bool {
        self.choices.len() > 1
    }

    /// Whether it was repaired or left out.
    pub fn is_change(&self) -> bool {
        self.reason.is_some() && !self.is_question()
    }
}

impl Program {
    /// The cleaned text, one block a line; questions read as printed.
    pub fn text(&self) -> String {
        self.pieces.iter().map(|piece| piece.now.as_str()).collect()
    }

    /// The cleaned text with an answer for each question, in their order: which choice.
    pub fn answered(&self, mut answer: impl FnMut(&Piece) -> usize) -> String {
        let mut text = String::new();
        for piece in &self.pieces {
            let chosen = if piece.is_question() { piece.choices.get(answer(piece)) } else { None };
            text.push_str(chosen.unwrap_or(&piece.now));
        }
        text
    }

    /// What was repaired or left out.
    pub fn changes(&self) -> impl Iterator<Item = &Piece> {
        self.pieces.iter().filter(|piece| piece.is_change())
    }

    /// What the reader is to say.
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
    if text.len() > PASTED_TEXT {
        return Found { too_long: true, ..Found::default() };
    }
    let items = items::read(text);
    let mut blocks = blocks::assemble(text, &items);
    let stretches = programs::join(&items, &mut blocks);
    let more = stretches.len().saturating_sub(FOUND_PROGRAMS);
    let mut programs = Vec::new();
    let mut line = LineCount::default();
    for stretch in stretches.iter().take(FOUND_PROGRAMS) {
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

/// Up to so many stray characters are few.
const FEW: usize = 3;

/// How far the text is from programs as a control takes them.
fn review(text: &str, items: &[items::Item], programs: &[Program]) -> Review {
    if programs.is_empty() {
        return Review::Nothing;
    }
    // Text after a `;` the parser takes for a remark too.
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

/// Counts lines from the start, for places that only grow.
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
