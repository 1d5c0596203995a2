//! Compares two versions of a program: the blocks that differ, and the effect on the motions.
//!
//! In: two analysed programs. Out: a [`ProgramDifference`]: the changed blocks in [`Hunk`]s with the effect
//! of each, unchanged blocks with different motions, totals, parts and messages of both. Independent of the
//! language.
//!
//! `written` decides which blocks have the same text, `align` pairs them, `moves` compares the motions of
//! paired blocks, `later` finds the cause of different motions in an unchanged block.

mod align;
mod later;
mod messages;
mod moves;
mod totals;
mod written;

use crate::machine::compare::{Comparison, parts};
use crate::message::Diagnostic;
use crate::motion::Motions;
use crate::setup::Setup;
use crate::setup::dialect::{CodeList, DecimalChoice, DecimalRule};
use crate::source::Span;
use crate::units::Unit;
use align::{Alignment, Stretch};
pub use later::Later;
pub use moves::Change;
use moves::{Moves, changes};
pub use totals::Totals;
use written::{Written, written};

/// An analysed program.
#[derive(Clone, Copy)]
pub struct Version<'a> {
    /// The text.
    pub text: &'a [u8],
    /// Its motions.
    pub motions: &'a Motions,
    /// Its messages, sorted by position.
    pub diagnostics: &'a [Diagnostic],
    /// The setup of the run, with the decimal rule decided.
    pub setup: &'a Setup,
    /// The G code list that it was read with.
    pub codes: CodeList,
    /// The unit of length at its end.
    pub unit: Unit,
}

/// A block in the text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Place {
    /// Its span.
    pub span: Span,
    /// Line, from 0.
    pub line: u32,
}

/// A block of one version and its counterpart in the other; one may be missing.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// The blocks of the first and second version.
    pub blocks: [Option<Place>; 2],
    /// Differences of their motions.
    pub changes: Vec<Change>,
}

/// Neighbouring blocks with different text.
#[derive(Clone, Debug, PartialEq)]
pub struct Hunk {
    /// The blocks, in text order.
    pub rows: Vec<Row>,
    /// Known time of their motions in each version, s.
    pub seconds: [f64; 2],
    /// Unchanged blocks whose motions differ because of this hunk.
    pub later: Later,
}

/// A reading rule that differs between the versions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reading {
    /// The G code list.
    Codes([CodeList; 2]),
    /// Meaning of numbers without a decimal point.
    Decimal([DecimalRule; 2]),
    /// The unit of length.
    Unit([Unit; 2]),
}

/// The finished parts of both versions.
#[derive(Clone, Debug, PartialEq)]
pub enum Parts {
    /// The parts were compared; they are the same if the comparison is empty.
    Compared(Comparison),
    /// At least one part is unknown: no blank, or a limit was reached.
    Unknown,
}

/// The difference between two versions of a program.
#[derive(Clone, Debug, PartialEq)]
pub struct ProgramDifference {
    /// Changes of the text, in order.
    pub hunks: Vec<Hunk>,
    /// Blocks with different motions although no text that could be the cause differs.
    pub unexplained: Later,
    /// Whether the motions of both versions are the same, in the same order.
    pub same_motions: bool,
    /// Reading rules that differ.
    pub readings: Vec<Reading>,
    /// Totals of each version.
    pub totals: [Totals; 2],
    /// The finished parts.
    pub parts: Parts,
    /// Messages that only the first version has.
    pub gone: Vec<Diagnostic>,
    /// Messages that only the second version has.
    pub new: Vec<Diagnostic>,
}

impl ProgramDifference {
    /// Compares two versions.
    pub fn of(versions: [Version; 2]) -> Self {
        let rules = versions.map(decimal_rule);
        let points = if rules.contains(&DecimalRule::LeastIncrement) {
            written::Points::Count
        } else {
            written::Points::Aside
        };
        let mut keys = written::Keys::default();
        let texts = versions.map(|version| written(version.text, points, &mut keys));
        let [first, second] = &texts;
        let Alignment { stretches, partners } = Alignment::of([first, second], &keys);
        let moves = [0, 1].map(|side| Moves::of(versions[side].motions, &texts[side]));
        let same_motions = Moves::are_same(versions.map(|version| version.motions));
        let mut hunks: Vec<Hunk> = stretches.iter().map(|own| hunk(own, &texts, &moves, versions)).collect();
        let mut unexplained = Later::default();
        if !same_motions {
            let places = later::Places { texts: &texts, stretches: &stretches, keys: &keys };
            later::follow(&places, &partners, &moves, &mut hunks, &mut unexplained);
        }
        let totals = versions.map(|version| Totals::of(version.motions, &version.setup.machine));
        let unchanged = partners.iter().map(|pair| pair.map(Some));
        let changed = stretches.iter().flat_map(|stretch| stretch.pairs.iter().copied());
        let (gone, new) = messages::only(versions, &texts, unchanged.chain(changed));
        Self {
            hunks,
            unexplained,
            same_motions,
            readings: readings(versions, rules),
            totals,
            parts: both_parts(versions, same_motions),
            gone,
            new,
        }
    }

    /// Whether the texts are the same, apart from N numbers, white space and number format.
    pub fn same_text(&self) -> bool {
        self.hunks.is_empty()
    }
}

fn decimal_rule(version: Version) -> DecimalRule {
    match version.setup.dialect.decimal {
        Some(DecimalChoice::LeastIncrement) => DecimalRule::LeastIncrement,
        Some(DecimalChoice::Calculator | DecimalChoice::Auto) | None => DecimalRule::Calculator,
    }
}

fn readings(versions: [Version; 2], rules: [DecimalRule; 2]) -> Vec<Reading> {
    let codes = versions.map(|version| version.codes);
    let units = versions.map(|version| version.unit);
    let found = [
        (codes[0] != codes[1]).then_some(Reading::Codes(codes)),
        (rules[0] != rules[1]).then_some(Reading::Decimal(rules)),
        (units[0] != units[1]).then_some(Reading::Unit(units)),
    ];
    found.into_iter().flatten().collect()
}

fn hunk(stretch: &Stretch, texts: &[Written; 2], moves: &[Moves; 2], versions: [Version; 2]) -> Hunk {
    let rows = stretch.pairs.iter().map(|pair| row(*pair, texts, moves)).collect();
    let seconds = [0, 1].map(|side| {
        let machine = &versions[side].setup.machine;
        // `sum` of an empty iterator is -0.
        stretch.blocks[side].clone().fold(0.0, |sum, block| sum + moves[side].seconds(block, machine))
    });
    Hunk { rows, seconds, later: Later::default() }
}

/// A pair of blocks, one of which may be missing, with the differences of their motions.
fn row(pair: [Option<usize>; 2], texts: &[Written; 2], moves: &[Moves; 2]) -> Row {
    let blocks = [0, 1].map(|side| pair[side].map(|block| texts[side].place(block)));
    let own =
        [0, 1].map(|side| pair[side].map_or_else(|| moves[side].none(), |block| moves[side].block(block)));
    Row { blocks, changes: changes(&own[0], &own[1]) }
}

fn both_parts(versions: [Version; 2], same_motions: bool) -> Parts {
    let [first, second] = versions;
    if same_motions && first.setup == second.setup {
        return Parts::Compared(Comparison::default());
    }
    match parts(versions.map(|version| (version.motions, version.setup))) {
        [Some(first), Some(second)] => Parts::Compared(Comparison::of(&first, &second)),
        [_, _] => Parts::Unknown,
    }
}
