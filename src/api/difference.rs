//! Rows for the differences between two versions of a program.
//!
//! In: a difference, both texts, a language. Out: a [`ProgramDifference`] for the page and for other
//! programs: blocks with their lines, changes as words and values. Long lists are truncated, and the omitted
//! entries are counted.

use serde::Serialize;

#[cfg(target_arch = "wasm32")]
use tsify::Tsify;

use super::{Comparison, Diagnostic, Places, rounded, tool_name};
use crate::difference::{self, Change as Changed, Parts, Place};
use crate::limits::{CHANGED_BLOCKS, SHOWN_OF_BLOCK};
use crate::sentences::Language;
use crate::sentences::difference::{Said, Told, clock, describe_change, describe_reading, said};
use crate::units::{Unit, number};

/// The differences between two versions of a program.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
#[serde(rename_all = "camelCase")]
pub struct ProgramDifference {
    /// Whether the texts are the same, except for N numbers, blanks and number formats.
    pub same_text: bool,
    /// Whether the motions are the same.
    pub same_motions: bool,
    /// How each version was read, where they differ.
    pub read_as: Vec<Change>,
    /// The differences of the text, in order.
    pub hunks: Vec<Hunk>,
    /// Number of changed blocks that are not listed.
    pub more_blocks: usize,
    /// Blocks whose motion differs although no text before them differs.
    pub unexplained: Later,
    /// The totals of both versions: time, passes, tools and so on, including those that are the same.
    pub totals: Vec<Change>,
    /// Where the finished parts differ; omitted if one of them cannot be shown.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub part: Option<Comparison>,
    /// Messages of the first version only.
    pub gone: Vec<Diagnostic>,
    /// Messages of the second version only.
    pub new: Vec<Diagnostic>,
}

/// Adjacent blocks whose text differs.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
pub struct Hunk {
    /// The blocks side by side.
    pub rows: Vec<Row>,
    /// Unchanged blocks whose motion differs because of these.
    pub later: Later,
}

/// A pair of blocks, one from each version; one of them may be missing.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
pub struct Row {
    /// The block of the first version.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub first: Option<Block>,
    /// The block of the second version.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub second: Option<Block>,
    /// The differences of their motion.
    pub changes: Vec<Change>,
}

/// A block as it is written.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
pub struct Block {
    /// Its line, from 1.
    pub line: u32,
    /// Its text, without surrounding blanks.
    pub text: String,
}

/// Unchanged blocks whose motion differs.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
pub struct Later {
    /// Number of blocks.
    pub blocks: usize,
    /// The first of them for each kind of change.
    pub rows: Vec<Row>,
}

/// A property with its value in both versions.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
pub struct Change {
    /// Stable name of the property, not translated: `end`, `feed`, `time`.
    pub what: &'static str,
    /// Translated name of the property.
    pub name: String,
    /// The value in the first version.
    pub first: String,
    /// The value in the second version.
    pub second: String,
}

/// The input for the rows.
struct Versions<'a> {
    places: [Places<'a>; 2],
    unit: Unit,
    language: Language,
}

impl ProgramDifference {
    /// The rows of a difference; lengths are shown in `unit`.
    pub fn new(
        found: &difference::ProgramDifference,
        places: [Places; 2],
        unit: Unit,
        language: Language,
    ) -> Self {
        let versions = Versions { places, unit, language };
        let (mut hunks, mut left, mut more_blocks) = (Vec::new(), CHANGED_BLOCKS, 0);
        for own in &found.hunks {
            let shown = own.rows.len().min(left);
            more_blocks += own.rows.len() - shown;
            left -= shown;
            if shown > 0 {
                let rows: Vec<Row> = own.rows[..shown].iter().map(|row| versions.row(row)).collect();
                hunks.push(Hunk { rows, later: versions.later(&own.later) }.with_time(own.seconds, language));
            }
        }
        let part = match &found.parts {
            Parts::Compared(comparison) => Some(Comparison::new(comparison)),
            Parts::Unknown => None,
        };
        let [first, second] = &versions.places;
        Self {
            same_text: found.same_text(),
            same_motions: found.same_motions,
            read_as: found.readings.iter().map(|&reading| read_as(reading, language)).collect(),
            hunks,
            more_blocks,
            unexplained: versions.later(&found.unexplained),
            totals: totals(&found.totals, language),
            part,
            gone: found.gone.iter().map(|one| first.diagnostic(one, language)).collect(),
            new: found.new.iter().map(|one| second.diagnostic(one, language)).collect(),
        }
    }

    /// Whether neither text nor motions differ.
    pub fn is_same(&self) -> bool {
        self.same_text && self.same_motions
    }
}

impl Hunk {
    /// Adds the time to the last row, if it differs.
    fn with_time(mut self, seconds: [f64; 2], language: Language) -> Self {
        if let Some(row) = self.rows.last_mut().filter(|_| (seconds[0] - seconds[1]).abs() >= 0.05) {
            row.changes.push(plain("time", Said::Time, seconds.map(clock), language));
        }
        self
    }

    /// Whether the motions are unchanged.
    pub fn is_without_motion(&self) -> bool {
        self.later.blocks == 0 && self.rows.iter().all(|row| row.changes.is_empty())
    }
}

impl Versions<'_> {
    fn row(&self, row: &difference::Row) -> Row {
        let [first, second] = [0, 1].map(|side| row.blocks[side].map(|place| self.block(side, place)));
        let changes = row.changes.iter().map(|change| {
            let Told { what: name, values: [first, second] } =
                describe_change(change, self.unit, self.language);
            Change { what: kind(change), name, first, second }
        });
        Row { first, second, changes: changes.collect() }
    }

    fn block(&self, side: usize, place: Place) -> Block {
        let quoted = place.span.quote(self.places[side].text);
        let whole = quoted.trim();
        let mut text: String = whole.chars().take(SHOWN_OF_BLOCK).collect();
        if text.len() < whole.len() {
            text.push('…');
        }
        Block { line: place.line + 1, text }
    }

    fn later(&self, later: &difference::Later) -> Later {
        Later { blocks: later.blocks, rows: later.rows.iter().map(|row| self.row(row)).collect() }
    }
}

/// The stable name of a change, not translated.
fn kind(change: &Changed) -> &'static str {
    match change {
        Changed::Moves(_) => "moves",
        Changed::Cycle(_) => "cycle",
        Changed::Passes(..) => "passes",
        Changed::Motions(_) => "motions",
        Changed::Kind(_) => "kind",
        Changed::End(_) => "end",
        Changed::Radius(_) => "radius",
        Changed::Way => "path",
        Changed::Feed(_) => "feed",
        Changed::Lead(_) => "lead",
        Changed::Speed(_) => "speed",
        Changed::Highest(_) => "maximumSpeed",
        Changed::Turn(_) => "spindle",
        Changed::Tool(_) => "tool",
        Changed::Dwell(_) => "dwell",
    }
}

fn plain(what: &'static str, name: Said, [first, second]: [String; 2], language: Language) -> Change {
    Change { what, name: said(name, language).to_owned(), first, second }
}

fn read_as(reading: difference::Reading, language: Language) -> Change {
    let what = match reading {
        difference::Reading::Codes(_) => "codes",
        difference::Reading::Decimal(_) => "decimal",
        difference::Reading::Unit(_) => "unit",
    };
    plain(what, Said::ReadAs, describe_reading(reading, language), language)
}

fn totals(both: &[difference::Totals; 2], language: Language) -> Vec<Change> {
    let of = |value: fn(&difference::Totals) -> String| both.each_ref().map(value);
    let mut rows = vec![
        plain("time", Said::Time, of(|own| clock(own.time.estimated())), language),
        plain("motions", Said::Motions, of(|own| own.motions.to_string()), language),
        plain("passes", Said::Passes, of(|own| own.passes.to_string()), language),
        plain("cut", Said::Cut, of(|own| number(rounded((10.0 * own.cut).round() / 10.0))), language),
        plain("rapid", Said::Rapid, of(|own| number(rounded((10.0 * own.rapid).round() / 10.0))), language),
        plain("tools", Said::Tools, of(tools), language),
    ];
    let without = of(|own| own.time.unknown_cuts.to_string());
    if without.iter().any(|count| count != "0") {
        rows.insert(1, plain("withoutTime", Said::WithoutTime, without, language));
    }
    rows
}

fn tools(own: &difference::Totals) -> String {
    let names: Vec<String> = own.tools.iter().filter_map(|&tool| tool_name(tool)).collect();
    if names.is_empty() { "–".to_owned() } else { names.join(" ") }
}
