//! Completion at a place: codes, words of the current cycle with their values, existing numbers, snippets.
//!
//! In: the text, a place in it, the executed block there. Out: proposals, the most likely first, as pieces of
//! text with their kind. Each value has its source: no value is guessed.

mod around;
mod prefix;
mod values;

use std::ops::Range;

use self::around::Around;
use self::prefix::{Prefix, begins_with, prefix_at};
use super::Query;
use super::form::Form;
use super::role::Role;
use super::snippet::{Piece, Snippet};
use crate::control::codes::cycles::CycleBlock;
use crate::control::codes::{self, Function, G, GCode, M, MotionMode, Multiple};
use crate::control::macros::Found;
use crate::control::modal::State;
use crate::motion::SpindleTurn;
use crate::order;
use crate::run::replay::block_at;
use crate::source::{Span, line_around};
use crate::text::parser::Resume;
use crate::text::program_name;

/// Maximum number of proposals of one kind.
const MAX_PROPOSALS: usize = 60;

/// Minimum length of a typed name, bytes: three letters, or one Chinese character.
const MIN_NAME_BYTES: usize = 3;

/// The numbers of the variables that are proposed: all below the system variables.
const PROPOSED_VARIABLES: Range<u32> = 1..1000;

/// Proposals for a place.
#[derive(Clone, Debug, PartialEq)]
pub struct Completion {
    /// The text that a proposal replaces: the typed prefix.
    pub span: Span,
    /// The proposals, the most likely first.
    pub items: Vec<Item>,
    /// Snippets to propose if their description contains the typed text: "rough" for G71. The caller
    /// compares, because descriptions depend on the language. Not truncated.
    pub by_name: Vec<Item>,
}

/// A proposal.
#[derive(Clone, Debug, PartialEq)]
pub struct Item {
    /// The text to insert.
    pub pieces: Vec<Piece>,
    /// Kind of the proposal.
    pub kind: ProposalKind,
}

/// Kind of a proposal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ProposalKind {
    /// A code, with its meaning if the table describes several codes in one row.
    Code(Function, Option<Role>),
    /// A word with the source of its value; the letter alone if no value is known.
    Word(Role, Option<ValueSource>),
    /// A sequence number, with the byte offset of its block.
    Sequence(u32),
    /// The next unused sequence number.
    NextSequence,
    /// A program, with its byte offset.
    Program(u32),
    /// A variable, with its value.
    Variable(f64),
    /// Several words or blocks.
    Snippet(Snippet),
}

/// Source of a value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ValueSource {
    /// The front face of the blank.
    Face,
    /// The back of the blank.
    Back,
    /// The outside of the blank.
    Outside,
    /// The bore of the blank.
    Bore,
    /// The axis of the spindle.
    Axis,
    /// The position of the tool.
    ToolPosition,
    /// An earlier value in the program.
    Used,
    /// A tool in the setup.
    InSetup,
}

impl Query<'_> {
    /// Proposals at a byte. `end`: the state after the run, used for blocks that are not executed.
    /// `is_explicit`: the user requested completion, so propose something even if no word was begun. `None` if
    /// there are no proposals.
    pub fn complete(&self, byte: u32, end: &State, is_explicit: bool) -> Option<Completion> {
        let line = line_around(self.text, byte as usize);
        let (prefix, span) = prefix_at(self.text, line.start, byte)?;
        let state = self.visit.map_or(end, |visit| &visit.before.state);
        let is_same_line = self.block.span.start <= byte && self.block.span.start >= line.start;
        let around = Around::of(self.text, line, self.codes);
        let proposer = Proposer { query: self, state, is_same_line, span, line, around };
        // After `G71 `, propose the whole cycle, which replaces the code.
        if let (Prefix::Nothing, true, true, Some(code)) =
            (prefix, is_explicit, is_same_line, self.only_code())
        {
            let items = proposer.cycles(&code.quote(self.text).to_ascii_uppercase());
            if !items.is_empty() {
                let span = Span { start: code.start, end: span.end };
                return Some(Completion { span, items, by_name: Vec::new() });
            }
        }
        let typed = span.quote(self.text).to_ascii_uppercase();
        let mut items = match prefix {
            Prefix::Word(b'G') => proposer.g_codes(&typed),
            Prefix::Word(b'M') => proposer.m_codes(),
            Prefix::Word(b'N') => proposer.next_sequence(),
            Prefix::Word(b'O') => proposer.snippets(),
            Prefix::Word(b'T') => proposer.tools(),
            Prefix::Word(letter) => proposer.word(letter),
            Prefix::Variable => proposer.variables(),
            Prefix::Goto => proposer.sequences(""),
            Prefix::Letters => proposer.snippets(),
            Prefix::Nothing => proposer.anything(is_explicit),
        };
        let is_name = prefix == Prefix::Letters && typed.len() >= MIN_NAME_BYTES;
        let by_name = if is_name { items.clone() } else { Vec::new() };
        // A proposal equal to the typed text is useless.
        items.retain(|item| {
            begins_with(item, &typed, prefix)
                && !matches!(&item.pieces[..], [Piece::Fixed(text)] if *text == typed)
        });
        items.truncate(MAX_PROPOSALS);
        (!items.is_empty() || !by_name.is_empty()).then_some(Completion { span, items, by_name })
    }

    /// The code of a block without other words.
    fn only_code(&self) -> Option<Span> {
        match &self.block.words[..] {
            [word] if word.address == b'G' && !word.comma => Some(word.span),
            _ => None,
        }
    }
}

/// Context for making proposals.
struct Proposer<'a> {
    query: &'a Query<'a>,
    /// State of the control before the block.
    state: &'a State,
    /// Whether the block of the query is on the line of the place.
    is_same_line: bool,
    /// The typed prefix.
    span: Span,
    /// The line of the place.
    line: Span,
    /// Numbers and values that the text around the place uses.
    around: Around,
}

fn fixed(text: impl Into<String>, kind: ProposalKind) -> Item {
    Item { pieces: vec![Piece::Fixed(text.into())], kind }
}

impl Proposer<'_> {
    // ---- codes ------------------------------------------------------------------------------------------

    /// The G codes of the control, ordered by how likely they are here. After a digit, whole cycles come first.
    fn g_codes(&self, typed: &str) -> Vec<Item> {
        let list = self.query.codes;
        let is_supported = |(_, code): &(String, &GCode)| code.code != G::NotSupported;
        let mut codes: Vec<_> = codes::g_codes(list).filter(is_supported).collect();
        order::by_key(&mut codes, |(_, code)| self.rank_g(code.code));
        let cycles = match typed {
            "G" => self.second_block().map(|snippet| self.snippet(snippet)).into_iter().collect(),
            _ => self.cycles(typed),
        };
        let codes = codes
            .into_iter()
            .map(|(written, code)| fixed(written, ProposalKind::Code(code.function(), code.role())));
        cycles.into_iter().chain(codes).collect()
    }

    /// Rank of a code; lower is more likely.
    fn rank_g(&self, code: G) -> usize {
        let spindle_turns = self.state.spindle.turn != SpindleTurn::Stopped;
        match code {
            // While the spindle does not turn, speed codes are the most likely.
            G::SurfaceSpeed | G::ConstantSpeed | G::Setting if !spindle_turns => 0,
            G::Motion(MotionMode::Rapid | MotionMode::Line) => 1,
            G::Motion(MotionMode::Arc(_)) => 2,
            G::Multiple(Multiple::Finishing) if self.around.is_roughed => 1,
            G::Multiple(_) | G::Motion(MotionMode::Cycle(_)) => 3,
            G::SurfaceSpeed | G::ConstantSpeed | G::Setting | G::Compensation(_) => 4,
            G::Dwell | G::Home | G::Feed(_) | G::Motion(_) => 5,
            G::Hole(_) | G::NoHole => 6,
            G::Idle => 8,
            G::NotSupported => 9,
            _ => 7,
        }
    }

    /// The M codes, ordered by how likely they are here.
    fn m_codes(&self) -> Vec<Item> {
        let is_stopped = self.state.spindle.turn == SpindleTurn::Stopped;
        let rank = |number: u16, code: M| match (number, code) {
            (_, M::Spindle(turn)) if is_stopped != (turn == SpindleTurn::Stopped) => 0,
            (_, M::Spindle(_)) => 4,
            (_, M::End) => 1,
            (8 | 9, _) => 2,
            (_, M::Pause(_) | M::Call | M::Return) => 3,
            _ => 5,
        };
        let mut codes: Vec<_> = codes::m_codes().collect();
        order::by_key(&mut codes, |&(number, code, ..)| rank(number, code));
        let item =
            |(number, _, function, role)| fixed(format!("M{number:02}"), ProposalKind::Code(function, role));
        codes.into_iter().map(item).collect()
    }

    // ---- existing numbers -------------------------------------------------------------------------------

    fn next_sequence(&self) -> Vec<Item> {
        let step = match self.around.sequences[..] {
            [.., (before, _), (last, _)] if last > before && last - before <= 100 => last - before,
            _ => 10,
        };
        vec![fixed(
            format!("N{}", self.around.last_sequence().saturating_add(step)),
            ProposalKind::NextSequence,
        )]
    }

    /// The sequence numbers of the text; those after the place come first.
    fn sequences(&self, letter: &str) -> Vec<Item> {
        let (before, after): (Vec<_>, Vec<_>) =
            self.around.sequences.iter().copied().partition(|&(_, at)| at <= self.span.start);
        let item = |(number, at)| fixed(format!("{letter}{number}"), ProposalKind::Sequence(at));
        after.into_iter().chain(before).map(item).collect()
    }

    /// The programs of the text except the current one.
    fn programs(&self) -> Vec<Item> {
        let programs = &self.around.programs;
        let current = programs.iter().rev().find(|(_, at)| *at <= self.span.start);
        let others =
            programs.iter().filter(|program| Some(*program) != current && !program_name::is_name(program.0));
        others.map(|(number, at)| fixed(format!("P{number}"), ProposalKind::Program(*at))).collect()
    }

    fn variables(&self) -> Vec<Item> {
        let value = |number: u32| match self.state.variables.read(number) {
            Ok(Found::Value(value)) => value,
            _ => None,
        };
        let items = PROPOSED_VARIABLES.filter_map(|number| {
            value(number).map(|value| fixed(format!("#{number}"), ProposalKind::Variable(value)))
        });
        items.collect()
    }

    /// The tools used earlier in the text, then the other tools of the setup.
    fn tools(&self) -> Vec<Item> {
        let used = &self.around.tools;
        let others = self.query.setup.tools.keys().filter(|tool| !used.contains(tool));
        let tools = used
            .iter()
            .map(|tool| (tool, ValueSource::Used))
            .chain(others.map(|tool| (tool, ValueSource::InSetup)));
        tools.map(|(tool, why)| fixed(&**tool, ProposalKind::Word(Role::ToolAndOffset, Some(why)))).collect()
    }

    // ---- snippets ---------------------------------------------------------------------------------------

    /// The second block of the cycle, if the previous block is its first block.
    fn second_block(&self) -> Option<Snippet> {
        let last = self.around.last?;
        let (_, block) = block_at(self.query.text, Resume::inside(last, 0), last);
        match Form::of(&block, self.state, self.query.codes) {
            Form::Multiple(cycle, CycleBlock::First) => Some(Snippet::Second(cycle)),
            _ => None,
        }
    }

    /// The snippets that fit here: a program has one head, at its beginning.
    fn snippets(&self) -> Vec<Item> {
        let has_number = self.around.programs.iter().any(|(_, at)| *at < self.line.start);
        let is_empty = self.around.last.is_none() && !has_number;
        let first = if is_empty { Some(Snippet::Head) } else { self.second_block() };
        let others = Snippet::all().filter(|snippet| Some(*snippet) != first);
        first
            .into_iter()
            .chain(others)
            .filter(|snippet| !(has_number && *snippet == Snippet::Head))
            .filter(|snippet| snippet.is_supported(self.query.dialect))
            .map(|snippet| self.snippet(snippet))
            .collect()
    }

    /// The cycles whose code starts with the typed text.
    fn cycles(&self, typed: &str) -> Vec<Item> {
        let is_cycle =
            |item: &Item| matches!(item.kind, ProposalKind::Snippet(snippet) if snippet.code().is_some());
        let begins = |item: &Item| is_cycle(item) && begins_with(item, typed, Prefix::Word(b'G'));
        self.snippets().into_iter().filter(begins).collect()
    }

    fn snippet(&self, snippet: Snippet) -> Item {
        let pieces = snippet.pieces(self.query, self.state, self.around.last_sequence());
        Item { pieces, kind: ProposalKind::Snippet(snippet) }
    }
}
