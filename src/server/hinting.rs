//! Finds hints: where incremental words lead (`U-4` to a diameter, `W-10` to a position) and, on request, the
//! code in force, the feed per minute, and the number of passes.
//!
//! In: some blocks of a finished run. Out: the hints of their words, found in slices. A block that is executed
//! more than once gets none, because each execution may be different.

use super::client::HintKinds;
use crate::assist::Query;
use crate::assist::explain::{has_passes, number_of_passes};
use crate::assist::fact::{Fact, Quantity};
use crate::assist::form::g_of;
use crate::assist::hover::Hover;
use crate::assist::place::own_motions;
use crate::assist::role::Role;
use crate::control::codes::{G, MotionMode};
use crate::current::Current;
use crate::current::question::Question;
use crate::run::replay::VisitChoice;
use crate::run::{Run, RunId};
use crate::setup::dialect::CodeList;
use crate::source::{Span, line_around};
use crate::text::block::{Block, Word};
use crate::text::parser::{Parser, Resume};
use crate::units::number;

/// Maximum number of words that are looked at for one answer.
const MAX_WORDS: usize = 500;

/// A hint at a word.
#[derive(Clone, Debug, PartialEq)]
pub struct Hint {
    /// The byte before or after the word.
    pub at: u32,
    /// Its content.
    pub content: Content,
}

/// The content of a hint.
#[derive(Clone, Debug, PartialEq)]
pub enum Content {
    /// The absolute word, after the word: `X40`.
    Absolute(String),
    /// The code in force, before the word: `G01`.
    Code(String),
    /// The feed per minute, after the word.
    Feed(Quantity),
    /// The number of passes, after the code of a cycle.
    Passes(u32),
}

/// A search for hints.
pub struct Hinting {
    run: RunId,
    /// The blocks of the search.
    span: Span,
    kinds: HintKinds,
    /// The words that are still to be looked at, the last one first.
    words: Vec<Span>,
    /// Whether the question is about the next word.
    is_asked: bool,
    /// The hints that were found.
    pub found: Vec<Hint>,
}

impl Hinting {
    /// Begins a search in the lines that a span touches.
    pub fn new(run: &Run, span: Span, kinds: HintKinds) -> Self {
        let mut words = words(run.text(), span, kinds, run.code_list());
        words.truncate(MAX_WORDS);
        words.reverse();
        Self { run: run.id(), span, kinds, words, is_asked: false, found: Vec::new() }
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
            self.found.extend(hints(current, question, word, self.kinds));
        }
        self.words.is_empty()
    }
}

/// The words that can have hints, in the lines that a span touches.
fn words(text: &[u8], span: Span, kinds: HintKinds, codes: CodeList) -> Vec<Span> {
    let first = line_around(text, span.start as usize).start;
    let end = line_around(text, span.end as usize).end as usize;
    let mut parser = Parser::resume(&text[..end], Resume::inside(first, 0));
    let mut block = Block::default();
    let mut words = Vec::new();
    while words.len() < MAX_WORDS && parser.next_block(&mut block) {
        let first_axis = block.words.iter().find(|word| is_axis(word)).map(|word| word.span);
        let can_have = |word: &&Word| {
            !word.comma
                && match word.address {
                    b'U' | b'W' => true,
                    b'X' | b'Z' => kinds.code && first_axis == Some(word.span),
                    b'F' => kinds.feed,
                    b'G' => kinds.passes && is_cycle(word, codes),
                    _ => false,
                }
        };
        words.extend(block.words.iter().filter(can_have).map(|word| word.span));
    }
    words
}

fn is_axis(word: &Word) -> bool {
    matches!(word.address, b'X' | b'Z' | b'U' | b'W') && !word.comma
}

fn is_cycle(word: &Word, codes: CodeList) -> bool {
    matches!(g_of(word, codes), Some(G::Multiple(_) | G::Hole(_) | G::Motion(MotionMode::Cycle(_))))
}

/// The hints of a word whose block is found.
fn hints(current: &Current, question: &Question, span: Span, kinds: HintKinds) -> Vec<Hint> {
    let run = current.run();
    let Some(found) = question.found(current) else { return Vec::new() };
    let block = found.block(run);
    let query = Query::new(run, found, &block);
    let Some(visit) = query.visit else { return Vec::new() };
    if query.times > 1 && visit.purpose.is_none() {
        return Vec::new();
    }
    let Some(word) = block.words.iter().find(|word| word.span == span) else { return Vec::new() };
    if word.address == b'G' {
        let mut own = own_motions(run.motions(), block.span, visit);
        own.retain(|motion| motion.cycle.is_some_and(|step| has_passes(step.cycle)));
        let passes = number_of_passes(&own);
        return Vec::from_iter(
            (passes > 0).then_some(Hint { at: span.end, content: Content::Passes(passes) }),
        );
    }
    let Some(hover) = query.hover(span.start, &[], run.motions()) else { return Vec::new() };
    let is_first_axis = block.words.iter().find(|word| is_axis(word)).is_some_and(|first| first.span == span);
    let unit = visit.after.state.unit.millimetres();
    let of_fact = |fact: &Fact| match fact {
        Fact::FromTo(_, to) if matches!(word.address, b'U' | b'W') => {
            absolute(&hover, *to, unit).map(|text| Hint { at: span.end, content: Content::Absolute(text) })
        }
        Fact::ByCode(code, _) if kinds.code && is_first_axis => {
            Some(Hint { at: span.start, content: Content::Code(code.clone()) })
        }
        Fact::FeedAtSpeed(feed, _) if kinds.feed => {
            Some(Hint { at: span.end, content: Content::Feed(*feed) })
        }
        _ => None,
    };
    let mut hints: Vec<Hint> = hover.facts.iter().filter_map(of_fact).collect();
    hints.sort_by_key(|hint| hint.at);
    hints
}

/// The absolute word of an incremental one. `unit`: the unit of the program in millimetres.
fn absolute(hover: &Hover, to: Quantity, unit: f64) -> Option<String> {
    match (hover.role?, to) {
        (Role::EndX | Role::WayX, Quantity::Diameter(x)) => Some(format!("X{}", number(x.mm() / unit))),
        (Role::EndZ | Role::WayZ, Quantity::Length(z)) => Some(format!("Z{}", number(z / unit))),
        _ => None,
    }
}
