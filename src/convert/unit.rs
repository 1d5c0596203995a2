//! Writes a program in millimetres or in inches.
//!
//! In: a program and its setup. Out: the edits of all its lengths, feed rates and cutting speeds, or the places that
//! prevent the conversion. It is all or nothing: a program has one unit. Lengths are rounded to the least increment of
//! the new unit; positions differ by at most [`NEAR`].

use super::{Conversion, first_block, has_one_unit, is_run, runs, with_point};
use crate::assist::form::{Form, g_of};
use crate::assist::role::Role;
use crate::control::codes::words::Axes;
use crate::control::codes::{G, MacroCall, Plane, written};
use crate::control::modal::State;
use crate::control::words::plain;
use crate::geometry::Point;
use crate::message::{Edit, applied};
use crate::motion::{Feed, Motion};
use crate::rewrite::has_no_new_complaints;
use crate::run::{Analysis, analyze};
use crate::setup::Setup;
use crate::setup::dialect::{CodeList, Control, DecimalRule, Dialect, PqUnit};
use crate::source::{Span, only_line_end};
use crate::text::block::{Block, BlockKind, Value, Word};
use crate::text::parser::Parser;
use crate::units::{Unit, number};

/// Greatest distance of two positions, mm: two least increments of 0.0001 inch.
pub const NEAR: f64 = 2.0 * 0.00254;
/// Greatest relative difference of two feed rates, which are rounded, too.
const SAME_FEED: f64 = 0.01;
/// Greatest relative difference of two leads.
const SAME_LEAD: f64 = 1e-3;
/// Decimals of feed rates and of leads in millimetres and in inches.
const FEED_DECIMALS: [i32; 2] = [3, 4];
const LEAD_DECIMALS: [i32; 2] = [4, 6];

/// What a word counts.
#[derive(Clone, Copy, PartialEq)]
enum Measure {
    /// Nothing that depends on the unit.
    Other,
    /// A length.
    Length,
    /// A length in least increments, if it has no decimal point.
    Increments,
    /// A feed rate.
    Feed,
    /// A lead.
    Lead,
    /// A cutting speed.
    Speed,
}

/// Writes a program in a unit. `own`: the length of the program itself, bytes.
pub(super) fn converted(text: &[u8], own: usize, setup: &Setup, to: Unit) -> Conversion {
    let runs = runs(text, setup);
    let analysis = &runs[0].1;
    if analysis.unit == to && has_one_unit(text, analysis.codes, to) {
        return Conversion::default();
    }
    let writer = Writer {
        text,
        codes: analysis.codes,
        from: analysis.unit,
        to,
        dialect: Dialect::new(&analysis.setup.dialect),
    };
    let refused = |left| Conversion { edits: Vec::new(), left };
    if !is_run(analysis) {
        return Conversion::default();
    }
    // Subprograms in other files would stay in the other unit.
    if own < text.len() || !has_one_unit(text, analysis.codes, analysis.unit) {
        return refused(writer.unit_codes());
    }
    let edits = match writer.edits(setup) {
        Ok(edits) => edits,
        Err(place) => return refused(vec![place]),
    };
    let (after, first_block) = (applied(text, &edits), first_block(text));
    let other =
        runs.iter().find_map(|(setup, before)| first_other(before, &analyze(&after, setup), to, first_block));
    match other {
        None => Conversion { edits, left: Vec::new() },
        Some(place) => refused(vec![place]),
    }
}

/// The block from which on the motions differ; the first one if only the messages differ, or `first_block` without
/// motions.
fn first_other(before: &Analysis, after: &Analysis, to: Unit, first_block: Span) -> Option<Span> {
    let motions = &before.motions;
    let other = motions.iter().zip(after.motions.iter()).position(|(one, other)| !is_same(&one, &other));
    if let Some(index) = other {
        return Some(motions.span(index));
    }
    let is_same = motions.len() == after.motions.len()
        && before.codes == after.codes
        && after.unit == to
        && has_no_new_complaints(before, after);
    (!is_same).then(|| if motions.is_empty() { first_block } else { motions.span(0) })
}

fn is_same(one: &Motion, other: &Motion) -> bool {
    let near = |a: Point, b: Point| a.distance(b) <= NEAR;
    let ratio = |a: f64, b: f64, most: f64| (a - b).abs() <= most * a.abs().max(b.abs());
    let centers = match (one.center, other.center) {
        (Some(a), Some(b)) => near(a, b),
        (a, b) => a.is_none() == b.is_none(),
    };
    let leads = match (one.lead, other.lead) {
        (Some(a), Some(b)) => ratio(a, b, SAME_LEAD),
        (a, b) => a.is_none() == b.is_none(),
    };
    let feeds = match (one.process.feed, other.process.feed) {
        (Feed::PerMinute(a), Feed::PerMinute(b)) | (Feed::PerTurn(a), Feed::PerTurn(b)) => {
            ratio(a, b, SAME_FEED)
        }
        (a, b) => a == b,
    };
    one.kind == other.kind
        && near(one.from, other.from)
        && near(one.to, other.to)
        && centers
        && leads
        && feeds
        && one.seconds == other.seconds
}

struct Writer<'a> {
    text: &'a [u8],
    codes: CodeList,
    from: Unit,
    to: Unit,
    dialect: Dialect,
}

impl Writer<'_> {
    /// All edits; the place of a word whose length is not known, such as an expression, as the error.
    fn edits(&self, setup: &Setup) -> Result<Vec<Edit>, Span> {
        let (mut parser, mut block) = (Parser::new(self.text), Block::default());
        // Only the modal codes that decide what a word means.
        let mut state = State::new(setup, &self.dialect);
        let (mut edits, mut has_code, mut first) = (Vec::new(), false, None);
        while parser.next_block(&mut block) {
            if block.kind == BlockKind::Macro {
                return Err(block.span);
            }
            if !block.words.is_empty() {
                // Before a block number and a sign of block skip, but after O.
                let is_head = block.program.is_some();
                first = first.or(Some(if is_head { block.words_span().start } else { block.span.start }));
            }
            let form = Form::of(&block, &state, self.codes);
            for word in &block.words {
                if let Some(code) = g_of(word, self.codes) {
                    if let G::Unit(_) = code {
                        has_code = true;
                        edits.push(Edit { span: word.span, text: self.unit_code() });
                    }
                    self.follow(&mut state, code).ok_or(word.span)?;
                }
            }
            for word in block.words.iter().filter(|word| !b"GMNOT".contains(&word.address)) {
                edits.extend(self.edit(word, form, &state)?);
            }
        }
        if let (false, Some(start)) = (has_code, first) {
            let text = self.unit_code() + only_line_end(self.text);
            edits.push(Edit { span: Span { start, end: start }, text });
        }
        edits.sort_by_key(|edit| (edit.span.start, edit.span.end));
        Ok(edits)
    }

    /// Applies a code to the state; `None` if the unit of its words is not known.
    fn follow(&self, state: &mut State, code: G) -> Option<()> {
        match code {
            G::Motion(mode) => {
                state.motion = mode;
                state.hole = None;
            }
            G::NoHole => state.hole = None,
            G::SurfaceSpeed => state.spindle.surface = true,
            G::ConstantSpeed => state.spindle.surface = false,
            // A hole cycle stays in force with words that its blocks omit.
            G::Hole(_) | G::Data | G::Polar(_) | G::Cylinder | G::NotSupported => return None,
            G::MacroCall(MacroCall::Once | MacroCall::Modal) => return None,
            G::Plane(plane) if plane != Plane::Zx => return None,
            _ => {}
        }
        Some(())
    }

    /// The edit of a word; its place if its length is not known.
    fn edit(&self, word: &Word, form: Form, state: &State) -> Result<Option<Edit>, Span> {
        let axes = Axes { surface: None, plane: Plane::Zx, c_axis: state.c_axis };
        let role = Role::of(word, form, state.spindle.surface, axes);
        let measure = measure(role).ok_or(word.span)?;
        // C is an angle or a chamfer.
        let is_unclear = matches!(word.address, b'C' | b'H') && !word.comma;
        let is_number = matches!(word.value, Value::Number { .. });
        if is_unclear || !is_number && measure != Measure::Other {
            return Err(word.span);
        }
        let Some(value) = plain(word).filter(|_| measure != Measure::Other) else { return Ok(None) };
        let letter = char::from(word.address);
        let comma = if word.comma { "," } else { "" };
        Ok(Some(Edit {
            span: word.span,
            text: format!("{comma}{letter}{}", self.number(word, value, measure)),
        }))
    }

    fn number(&self, word: &Word, value: f64, measure: Measure) -> String {
        let has_point = word.span.of(self.text).contains(&b'.');
        let of_unit = |own: [i32; 2]| own[usize::from(self.to == Unit::Inch)];
        let scale = self.from.millimetres() / self.to.millimetres();
        let rounded = |value: f64, decimals: i32| {
            let step = 10f64.powi(decimals);
            number((value * step).round() / step)
        };
        let counts = self.dialect.decimal == DecimalRule::LeastIncrement && !has_point;
        match measure {
            Measure::Other => number(value),
            Measure::Feed => rounded(value * scale, of_unit(FEED_DECIMALS)),
            Measure::Lead => {
                let text = format!("{:.*}", of_unit(LEAD_DECIMALS) as usize, value * scale);
                text.trim_end_matches('0').trim_end_matches('.').to_owned()
            }
            Measure::Speed => number((value * self.from.surface_metres() / self.to.surface_metres()).round()),
            Measure::Increments if !has_point && self.counts_increments(word.address) => {
                number((value * self.from.increment() * scale / self.to.increment()).round())
            }
            Measure::Length | Measure::Increments => {
                let length = if counts { value * self.from.increment() } else { value };
                let text = rounded(length * scale, i32::from(self.to.decimals()));
                with_point(text, has_point || self.dialect.decimal == DecimalRule::LeastIncrement)
            }
        }
    }

    /// Whether a number without a point counts least increments under each decimal rule.
    fn counts_increments(&self, letter: u8) -> bool {
        match letter {
            b'P' | b'Q' => self.dialect.pq_unit != PqUnit::Mm,
            b'D' => self.dialect.control != Control::Gsk,
            _ => false,
        }
    }

    /// G20 or G21, or the codes of system C.
    fn unit_code(&self) -> String {
        written(G::Unit(self.to), self.codes).unwrap_or_default()
    }

    /// The places of the codes of units.
    fn unit_codes(&self) -> Vec<Span> {
        let (mut parser, mut block, mut all) = (Parser::new(self.text), Block::default(), Vec::new());
        while parser.next_block(&mut block) {
            let own = block.words.iter().filter(|word| matches!(g_of(word, self.codes), Some(G::Unit(_))));
            all.extend(own.map(|word| word.span));
        }
        all
    }
}

/// What a word with a role counts; `None` if that is not known.
fn measure(role: Role) -> Option<Measure> {
    use Role::*;
    Some(match role {
        EndX | EndZ | EndY | WayX | WayZ | WayY | ViaX | ViaZ | ViaWayX | ViaWayZ | MachineX | MachineZ
        | OriginX | OriginZ | ShiftX | ShiftZ | LocalX | LocalZ | Chamfer | Rounding | ArcRadius
        | ArcCenterX | ArcCenterZ | ArcCenterY | CornerX | CornerZ | CycleEndX | CycleEndZ | CycleWayX
        | CycleWayZ | TaperX | TaperZ | PullOutAcross | PullOutAlong | Escape | AllowanceX | AllowanceZ
        | ReliefX | ReliefZ | PeckRetract | PeckEndX | PeckEndZ | PeckWayX | PeckWayZ | ThreadAllowance
        | ThreadEndX | ThreadEndZ | ThreadWayX | ThreadWayZ | ThreadTaper => Measure::Length,
        PassDepth | PassDepthZ | Peck | StepOver | BottomRelief | LeastDepth | ThreadHeight | FirstDepth => {
            Measure::Increments
        }
        Feed => Measure::Feed,
        Lead | LeadChange => Measure::Lead,
        CuttingSpeed => Measure::Speed,
        ProgramNumber | SequenceNumber | BlockSkip | Percent | Comment | SetupNote | ThreadsPerInch
        | LineAngle | StartAngle | SpindleSpeed | HighestSpeed | LowestSpeed | ToolAndOffset
        | DwellSeconds | DwellMilliseconds | Starts | ContourFirst | ContourLast | PatternPasses
        | FinishAfter | ThreadPacked | InfeedMethod | ThreadAngle | ReferencePoint | FrameNumber
        | CalledProgram | CalledSequence | CallRepeats | BeginsAt | ReturnsTo | Ignored => Measure::Other,
        _ => return None,
    })
}
