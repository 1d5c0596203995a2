//! The calculators of a word: the R of a taper, the depths of a cycle, a speed.
//!
//! In: the block at a place as executed, and the motions of the run. Out: the calculators that fit the word there,
//! their initial values, and the edits that write the results into the block.

use super::{Block, Calculator, Outcome, Word, WordValue, Writing};
use crate::assist::Query;
use crate::assist::fact;
use crate::assist::form::{Form, cycle_block, g_of};
use crate::assist::role::Role;
use crate::control::codes::cycles::CycleBlock;
use crate::control::codes::{G, MotionMode, Multiple};
use crate::control::modal::State;
use crate::control::words::quote;
use crate::geometry::SAME;
use crate::motion::Motions;
use crate::run::replay::block_at;
use crate::setup::dialect::FeedMode;
use crate::source::{LineIndex, Span};
use crate::text::block;
use crate::text::parser::Resume;
use crate::units::{Diameter, Unit};

/// A change of the text.
#[derive(Clone, Debug, PartialEq)]
pub struct Change {
    /// The replaced text; empty for an insertion.
    pub span: Span,
    /// The new text.
    pub text: String,
}

/// Values that differ by less than half of it are the same, mm.
const INCREMENT: f64 = 0.001;

/// Initial permitted error of the lead at the start of a thread, as a fraction of it.
const LEAD_ERROR: f64 = 0.01;

/// Initial cutting speed of a thread, m/min.
const THREAD_CUTTING_SPEED: f64 = 80.0;

/// The calculators that fit the word at a byte, the most useful first.
pub fn calculators(query: &Query, byte: u32, motions: &Motions) -> &'static [&'static str] {
    let Some(visit) = query.visit.filter(|visit| visit.purpose.is_none()) else { return &[] };
    let Some(role) = query.hover(byte, &[], motions).and_then(|hover| hover.role) else { return &[] };
    // The formulas of speeds are metric, so they are not offered in inch programs.
    let is_metric = visit.after.state.unit == Unit::Millimetre;
    match (Form::of(query.block, &visit.before.state, query.codes), role) {
        (Form::Motion { mode: MotionMode::Cycle(_), .. }, Role::TaperX) => &["r-of-g90"],
        (Form::Motion { mode: MotionMode::Cycle(_), .. }, Role::TaperZ) => &["r-of-g94"],
        (
            Form::Multiple(Multiple::Threading, CycleBlock::First),
            Role::LeastDepth | Role::ThreadAllowance,
        )
        | (Form::Multiple(Multiple::Threading, CycleBlock::Second), Role::ThreadHeight | Role::FirstDepth) => {
            &["passes-of-g76"]
        }
        (Form::Multiple(Multiple::RoughTurning, CycleBlock::First), Role::PassDepth) => &["passes-of-g71"],
        (Form::Multiple(Multiple::Pattern, CycleBlock::First), Role::ReliefX | Role::PatternPasses) => {
            &["steps-of-g73"]
        }
        (
            Form::Multiple(Multiple::Grooving, CycleBlock::Second),
            Role::StepOver | Role::PeckEndZ | Role::PeckWayZ,
        ) => &["columns-of-g75"],
        (_, Role::CuttingSpeed | Role::SpindleSpeed) if is_metric => &["speed"],
        (_, Role::Lead) if is_metric => &["thread-by-name", "run-in", "thread-height", "thread-speed"],
        _ => &[],
    }
}

/// The initial values of a calculator at a block, in millimetres; `None` for a value that the block does not
/// give.
pub fn values(calculator: &Calculator, query: &Query, motions: &Motions) -> Vec<Option<f64>> {
    let block = Values { query, motions };
    let unknown = || calculator.fields.iter().map(|_| None).collect::<Vec<_>>();
    let Some(visit) = query.visit else { return unknown() };
    let (before, after) = (&visit.before.state, &visit.after.state);
    let start = (Diameter::from_radius(before.position.x).mm(), before.position.z);
    let role = |role: Role| block.value(role);
    match calculator.name {
        "r-of-g90" => {
            let (xe, ze, r) = cycle_end(before, after);
            // The start of the taper in the drawing, for the current R: at Z0 if the cut passes Z0, else at
            // the start point.
            let z1 =
                if (ze.min(start.1)..ze.max(start.1)).contains(&0.0) && ze != 0.0 { 0.0 } else { start.1 };
            let share = if start.1 == ze { 1.0 } else { (z1 - ze) / (start.1 - ze) };
            vec![Some(xe + 2.0 * r * share), Some(z1), Some(xe), Some(ze), Some(start.1)]
        }
        "r-of-g94" => {
            let (xe, ze, r) = cycle_end(before, after);
            let bar = query.setup.stock.as_ref().map(|stock| stock.extents().diameter.mm());
            let x1 = bar.filter(|bar| (xe.min(start.0)..xe.max(start.0)).contains(bar) && *bar != xe);
            let x1 = x1.unwrap_or(start.0);
            let share = if start.0 == xe { 1.0 } else { (x1 - xe) / (start.0 - xe) };
            vec![Some(x1), Some(ze + r * share), Some(xe), Some(ze), Some(start.0)]
        }
        "passes-of-g76" => {
            let partner = partner(query);
            let other = |role: Role| {
                block.value(role).or_else(|| partner.as_ref().and_then(|own| block.value_in(own, role)))
            };
            let parameters = &after.parameters;
            let [x, z] = [Role::ThreadEndX, Role::ThreadEndZ].map(other);
            vec![
                x.or_else(|| other(Role::ThreadWayX).map(|way| start.0 + way)),
                z.or_else(|| other(Role::ThreadWayZ).map(|way| start.1 + way)),
                Some(start.1),
                other(Role::ThreadHeight),
                other(Role::FirstDepth),
                other(Role::LeastDepth),
                Some(parameters.thread_allowance),
                Some(parameters.angle),
                other(Role::Lead),
            ]
        }
        "passes-of-g71" => vec![Some(start.0), None, role(Role::PassDepth)],
        "steps-of-g73" => {
            let bar = query.setup.stock.as_ref().map(|stock| stock.extents().diameter.mm());
            let relief = role(Role::ReliefX);
            let least = bar.zip(relief).map(|(bar, relief)| bar - 2.0 * relief).filter(|least| *least >= 0.0);
            vec![bar, least, role(Role::PatternPasses)]
        }
        "columns-of-g75" => {
            let width = role(Role::PeckWayZ).or_else(|| role(Role::PeckEndZ).map(|z| z - start.1));
            // The first tool with a width, because most setups have only one.
            let tool = query.setup.tools.values().find_map(|tool| tool.width);
            vec![width, role(Role::StepOver), tool]
        }
        "speed" => {
            let speed = role(Role::SpindleSpeed).map(|rpm| std::f64::consts::PI * start.0 * rpm / 1000.0);
            let feed = after.feed.filter(|_| after.feed_mode == FeedMode::PerTurn);
            vec![role(Role::CuttingSpeed).or(speed), Some(start.0).filter(|x| *x > 0.0), feed, None]
        }
        "run-in" => {
            let speed = Some(after.spindle.rpm).filter(|rpm| *rpm > 0.0 && !after.spindle.surface);
            vec![speed, role(Role::Lead), Some(LEAD_ERROR)]
        }
        "thread-height" => {
            vec![query.setup.stock.as_ref().map(|stock| stock.extents().diameter.mm()), role(Role::Lead)]
        }
        "thread-by-name" => {
            let end = [Role::ThreadEndZ, Role::CycleEndZ, Role::EndZ].into_iter().find_map(role);
            let way = [Role::ThreadWayZ, Role::CycleWayZ, Role::WayZ].into_iter().find_map(role);
            vec![None, Some(start.1), end.or_else(|| way.map(|way| start.1 + way))]
        }
        "thread-speed" => vec![role(Role::Lead), Some(THREAD_CUTTING_SPEED)],
        _ => unknown(),
    }
}

/// The end of the cut of a single cycle: X a diameter, Z, and the R in force.
fn cycle_end(before: &State, after: &State) -> (f64, f64, f64) {
    let (memory, start) = (&after.memory, before.position);
    let (x, z) = (memory.x.from(start.x), memory.z.from(start.z));
    let clean = |value: f64| if value.abs() < SAME { 0.0 } else { value };
    (clean(Diameter::from_radius(x).mm()), clean(z), clean(memory.taper))
}

/// The values of the words of a block.
struct Values<'a> {
    query: &'a Query<'a>,
    motions: &'a Motions,
}

impl Values<'_> {
    /// The value of the word with a role in the block at the cursor, mm.
    fn value(&self, role: Role) -> Option<f64> {
        self.value_in(self.query.block, role)
    }

    /// The value of the word with a role in another block that is executed in the same state, mm.
    fn value_in(&self, block: &block::Block, role: Role) -> Option<f64> {
        let query = Query { block, ..*self.query };
        let hovers = block.words.iter().filter_map(|word| query.hover(word.span.start, &[], self.motions));
        hovers.filter(|hover| hover.role == Some(role)).find_map(|hover| millimetres(hover.quantity?))
    }

    /// The value of a word of a block, mm.
    fn value_of(&self, block: &block::Block, word: &block::Word) -> Option<f64> {
        let query = Query { block, ..*self.query };
        millimetres(query.hover(word.span.start, &[], self.motions)?.quantity?)
    }
}

/// The number in a quantity, mm if it is a length.
fn millimetres(quantity: fact::Quantity) -> Option<f64> {
    Some(match quantity {
        fact::Quantity::Length(value)
        | fact::Quantity::FeedPerTurn(value)
        | fact::Quantity::Speed(value)
        | fact::Quantity::CuttingSpeed(value)
        | fact::Quantity::Degrees(value)
        | fact::Quantity::Count(value) => value,
        fact::Quantity::Diameter(diameter) => diameter.mm(),
        _ => return None,
    })
}

/// The multiple cycle of a block, and which of its blocks it is.
fn cycle_block_of(query: &Query, block: &block::Block) -> Option<(Multiple, CycleBlock)> {
    block.words.iter().find_map(|word| match g_of(word, query.codes) {
        Some(G::Multiple(cycle)) => Some((cycle, cycle_block(cycle, block))),
        _ => None,
    })
}

/// The other block of a multiple cycle, in the line before or after.
fn partner(query: &Query) -> Option<block::Block> {
    let (cycle, half) = cycle_block_of(query, query.block)?;
    let lines = LineIndex::new(query.text);
    let wanted = match half {
        CycleBlock::First => (query.block.line + 1, CycleBlock::Second),
        CycleBlock::Second => (query.block.line.checked_sub(1)?, CycleBlock::First),
        CycleBlock::Whole => return None,
    };
    let line = lines.line(query.text, wanted.0);
    let (_, block) = block_at(query.text, Resume::inside(line.start, wanted.0), line.start);
    (cycle_block_of(query, &block)? == (cycle, wanted.1)).then_some(block)
}

/// The edits that write the blocks of a result into the block at the cursor, and into the other block of its
/// cycle. Words that have the value already stay as they are; a missing word is added. Empty if no block
/// fits.
pub fn edits(query: &Query, motions: &Motions, outcome: &Outcome, writing: Writing) -> Vec<Change> {
    let own = cycle_block_of(query, query.block).map(|(_, half)| half);
    let mut changes = Vec::new();
    for block in &outcome.blocks {
        if block.code == "G97" {
            changes.extend(speed_word(query, motions, block, writing));
        } else if block.half == own {
            changes.extend(written_into(query, motions, query.block, block, writing));
        } else if let (None, Some(lead)) = (own, block.words.iter().find(|word| word.letter == b'F')) {
            // G32 and G92 have one block for each pass: only the lead is written.
            let lead = Block { code: "", half: None, words: vec![lead.clone()] };
            changes.extend(written_into(query, motions, query.block, &lead, writing));
        } else if let Some(other) = partner(query) {
            changes.extend(written_into(query, motions, &other, block, writing));
        }
    }
    changes.sort_by_key(|change| change.span.start);
    changes
}

/// Writes S of a speed in rpm. Under G96, where S is a cutting speed, nothing is written.
fn speed_word(query: &Query, motions: &Motions, result: &Block, writing: Writing) -> Vec<Change> {
    let surface = query.visit.is_some_and(|visit| visit.after.state.spindle.surface);
    if surface { Vec::new() } else { written_into(query, motions, query.block, result, writing) }
}

/// The changes that write a result into a block. An incremental word (U, W) stays incremental.
fn written_into(
    query: &Query,
    motions: &Motions,
    block: &block::Block,
    result: &Block,
    writing: Writing,
) -> Vec<Change> {
    let start = query.visit.map(|visit| visit.before.state.position).unwrap_or_default();
    let start = (Diameter::from_radius(start.x).mm(), start.z);
    let mut changes = Vec::new();
    let mut missing = String::new();
    for word in &result.words {
        let alternatives: &[u8] = match word.letter {
            b'X' => b"XU",
            b'Z' => b"ZW",
            b'W' => b"WZ",
            // Older controls write the taper as I or K.
            b'R' if result.half.is_none() => b"RIK",
            _ => std::slice::from_ref(&word.letter),
        };
        let is_it = |other: &&block::Word| alternatives.contains(&other.address) && !other.comma;
        let Some(present) = block.words.iter().find(is_it) else {
            if is_in_force(query, word) {
                continue;
            }
            missing.push(' ');
            missing.push_str(&writing.word(word, None));
            continue;
        };
        let value = match (word.value, word.letter, present.address) {
            (WordValue::Length(mm), b'X', b'U') => WordValue::Length(mm - start.0),
            (WordValue::Length(mm), b'Z', b'W') => WordValue::Length(mm - start.1),
            (WordValue::Length(mm), b'W', b'Z') => WordValue::Length(mm + start.1),
            (value, ..) => value,
        };
        let before = quote(query.text, present.span);
        let mut new = writing.word(&Word { letter: present.address, value }, before.get(1..));
        if before.starts_with(|letter: char| letter.is_ascii_lowercase()) {
            new.make_ascii_lowercase();
        }
        let current = Values { query, motions }.value_of(block, present);
        let wanted = match value {
            WordValue::Length(value)
            | WordValue::PerTurn(value)
            | WordValue::Increments(value)
            | WordValue::Number(value) => Some(value),
            WordValue::Packed(_) => None,
        };
        let is_same = match (current, wanted) {
            (Some(current), Some(wanted)) => (current - wanted).abs() < INCREMENT / 2.0,
            _ => new == before,
        };
        if !is_same {
            changes.push(Change { span: present.span, text: new });
        }
    }
    if !missing.is_empty() {
        let end = block.words_span().end as usize;
        changes.push(Change { span: Span::new(end, end), text: missing });
    }
    changes
}

/// Whether an omitted X or Z has the value already: that of the single cycle in force, else that of the start
/// point.
fn is_in_force(query: &Query, word: &Word) -> bool {
    let Some(visit) = query.visit else { return false };
    let (x, z, _) = cycle_end(&visit.before.state, &visit.after.state);
    match (word.letter, word.value) {
        (b'X', WordValue::Length(mm)) => (mm - x).abs() < INCREMENT / 2.0,
        (b'Z', WordValue::Length(mm)) => (mm - z).abs() < INCREMENT / 2.0,
        _ => false,
    }
}

/// The texts of the fields for initial values; empty for an unknown one.
pub fn shown(calculator: &Calculator, values: &[Option<f64>], writing: Writing) -> Vec<String> {
    let fields = calculator.fields.iter().zip(values);
    fields
        .map(|(field, value)| value.map_or_else(String::new, |value| writing.value(field.quantity, value)))
        .collect()
}

impl Writing {
    /// How the block at the cursor is written.
    pub fn of(query: &Query) -> Self {
        let unit = query.visit.map_or(Unit::Millimetre, |visit| visit.after.state.unit);
        Self { unit, decimal: query.dialect.decimal, pq_unit: query.dialect.pq_unit }
    }
}
