//! Finds where incremental words lead: `U-4` to a diameter, `W-10` to a position.
//!
//! In: some blocks of a finished run. Out: a hint for each U and W that ends a move, found in slices. A
//! block that is executed more than once gets none, because each execution may lead to another place.

use crate::assist::Query;
use crate::assist::fact::{Fact, Quantity};
use crate::assist::role::Role;
use crate::current::Current;
use crate::current::question::Question;
use crate::run::replay::VisitChoice;
use crate::run::{Run, RunId};
use crate::source::{Span, line_around};
use crate::text::block::Block;
use crate::text::parser::{Parser, Resume};
use crate::units::number;

/// Maximum number of words that are looked at for one answer.
const MAX_WORDS: usize = 500;

/// A hint after a word.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Hint {
    /// The byte after the word.
    pub at: u32,
    /// The absolute word: `X40`.
    pub text: String,
}

/// A search for hints.
pub struct Hinting {
    run: RunId,
    /// The blocks of the search.
    span: Span,
    /// The words that are still to be looked at, the last one first.
    words: Vec<Span>,
    /// Whether the question is about the next word.
    is_asked: bool,
    /// The hints that were found.
    pub found: Vec<Hint>,
}

impl Hinting {
    /// Begins a search in the lines that a span touches.
    pub fn new(run: &Run, span: Span) -> Self {
        let mut words = words(run.text(), span);
        words.truncate(MAX_WORDS);
        words.reverse();
        Self { run: run.id(), span, words, is_asked: false, found: Vec::new() }
    }

    /// Whether this is the search in a span of a run.
    pub fn is_about(&self, run: RunId, span: Span) -> bool {
        (self.run, self.span) == (run, span)
    }

    /// Continues the search; returns true once it has ended.
    pub fn advance(&mut self, current: &mut Current, question: &mut Question, blocks: usize) -> bool {
        let Some(word) = self.words.last().copied() else { return true };
        let is_known = !self.is_asked && question.ask(current, word.start, VisitChoice::Usual);
        self.is_asked = true;
        if is_known || question.look(current, blocks) {
            (self.is_asked, _) = (false, self.words.pop());
            self.found.extend(hint(current, question, word));
        }
        self.words.is_empty()
    }
}

/// The words U and W in the lines that a span touches.
fn words(text: &[u8], span: Span) -> Vec<Span> {
    let first = line_around(text, span.start as usize).start;
    let end = line_around(text, span.end as usize).end as usize;
    let mut parser = Parser::resume(&text[..end], Resume::inside(first, 0));
    let mut block = Block::default();
    let mut words = Vec::new();
    while words.len() < MAX_WORDS && parser.next_block(&mut block) {
        let own = block.words.iter().filter(|word| matches!(word.address, b'U' | b'W') && !word.comma);
        words.extend(own.map(|word| word.span));
    }
    words
}

/// The hint of a word whose block is found.
fn hint(current: &Current, question: &Question, word: Span) -> Option<Hint> {
    let (run, found) = (current.run(), question.found(current)?);
    let block = found.block(run);
    let query = Query::new(run, found, &block);
    let visit = query.visit?;
    if query.times > 1 && visit.purpose.is_none() {
        return None;
    }
    let hover = query.hover(word.start, &[], run.motions())?;
    let to = hover.facts.iter().find_map(|fact| match fact {
        Fact::FromTo(_, to) => Some(*to),
        _ => None,
    })?;
    let unit = visit.after.state.unit.millimetres();
    let text = match (hover.role?, to) {
        (Role::EndX | Role::WayX, Quantity::Diameter(x)) => format!("X{}", number(x.mm() / unit)),
        (Role::EndZ | Role::WayZ, Quantity::Length(z)) => format!("Z{}", number(z / unit)),
        _ => return None,
    };
    Some(Hint { at: word.end, text })
}
