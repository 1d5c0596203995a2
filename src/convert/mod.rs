//! Writes a program in another form: U and W as X and Z or back, R as I and K or back, multiple cycles in one block or
//! in two, millimetres as inches or back, and the codes of another G-code system.
//!
//! In: a program and its setup. Out: the edits, and the words that stay. A coordinate is written in the other form only
//! if its place is known: not before the first absolute position, after a reference point or after a new tool, and not
//! if its block is executed at several places. The changed program makes the same motions, with block skip off and
//! on: a block that would not is left as it is. Cycles are in `cycles`, units in `unit`,
//! G-code systems in `system`. Must not know files.

mod cycles;
mod system;
pub mod unit;

use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;

use crate::assist::names::{Name, names};
use crate::control::codes::{G, MotionMode, Multiple};
use crate::control::words::plain;
use crate::geometry::{Arc, Point};
use crate::message::{Edit, applied};
use crate::motion::Motion;
use crate::proof::{is_for_other_control, switches};
use crate::rewrite::{first_other_motion, g, has_no_new_complaints};
use crate::run::{Analysis, analyze};
use crate::setup::Setup;
use crate::setup::dialect::{CodeList, DecimalRule, Dialect, GSystem};
use crate::source::Span;
use crate::text::block::{Block, BlockKind, Word};
use crate::text::parser::{Parser, Resume};
use crate::units::{Diameter, Unit, number};

/// The largest number of blocks that are left because their motions would differ.
const MAX_LEFT: usize = 20;
/// The largest number of motions of all runs that search for such blocks.
const MAX_MOTIONS: usize = 4_000_000;
/// The largest length of all copies of contours, as a multiple of the text.
const MAX_COPIES: usize = 4;
/// The largest difference of two motions, mm: the smallest step of a control. A centre that is written with its decimals
/// is rounded by half of it.
const SAME: f64 = 1e-3;
/// The largest difference of two motions whose words are exact, mm.
const EXACT: f64 = 1e-6;

/// The form in which words are written. Its name on the command line and in JavaScript is the variant in kebab case.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(all(feature = "cli", any(not(target_arch = "wasm32"), feature = "npx")), derive(clap::ValueEnum))]
#[cfg_attr(
    target_arch = "wasm32",
    derive(serde::Deserialize, tsify::Tsify),
    serde(rename_all = "kebab-case")
)]
pub enum ProgramForm {
    /// U and W as X and Z
    Absolute,
    /// X and Z as U and W
    Incremental,
    /// I and K of arcs as R
    Radius,
    /// R of arcs as I and K
    Center,
    /// G71 to G76 in one block
    OneBlock,
    /// G71 to G76 in two blocks
    TwoBlocks,
    /// Lengths in millimetres
    Mm,
    /// Lengths in inches
    Inch,
    /// The codes of G-code system A
    SystemA,
    /// The codes of G-code system B
    SystemB,
    /// The codes of G-code system C
    SystemC,
}

/// The edits that write a program in another form.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Conversion {
    /// Sorted by place.
    pub edits: Vec<Edit>,
    /// The words of the other form that stay.
    pub left: Vec<Span>,
}

/// Writes a program in a form. `own`: the length of the program itself, bytes; subprograms from other files after it stay.
pub fn converted(text: &[u8], own: usize, setup: &Setup, form: ProgramForm) -> Conversion {
    match form {
        ProgramForm::Mm => return unit::converted(text, own, setup, Unit::Millimetre),
        ProgramForm::Inch => return unit::converted(text, own, setup, Unit::Inch),
        ProgramForm::SystemA => return system::converted(text, own, setup, GSystem::A),
        ProgramForm::SystemB => return system::converted(text, own, setup, GSystem::B),
        ProgramForm::SystemC => return system::converted(text, own, setup, GSystem::C),
        _ => {}
    }
    let runs = runs(text, setup);
    let (words, mut found) = match form {
        ProgramForm::OneBlock | ProgramForm::TwoBlocks => {
            let codes = runs[0].1.codes;
            (cycles::codes_in_other_form(&text[..own], codes, form), cycles::edits(text, setup, form))
        }
        _ => (words(&text[..own], form), edits_of_blocks(text, &runs[0].1, form)),
    };
    found.retain(|start, _| (*start as usize) < own);
    let motions: usize = runs.iter().map(|(_, run)| run.motions.len()).sum();
    for _ in 0..MAX_LEFT.min(MAX_MOTIONS / motions.max(1)).max(1) {
        let edits: Vec<Edit> = found.values().flatten().cloned().collect();
        if edits.is_empty() {
            break;
        }
        match first_wrong(text, &edits, &runs, form) {
            None => {
                let is_written = |word: &Span| {
                    let at = edits.partition_point(|edit| edit.span.end <= word.start);
                    edits.get(at).is_some_and(|edit| edit.span.start <= word.start)
                };
                let left = words.into_iter().filter(|word| !is_written(word)).collect();
                return Conversion { edits, left };
            }
            Some(block) => {
                // The edits of this block, or of the last one before it, change its motions.
                let Some(culprit) = found.range(..=block).next_back().map(|(start, _)| *start) else { break };
                found.remove(&culprit);
            }
        }
    }
    Conversion { edits: Vec::new(), left: words }
}

/// The runs of a program, with block skip off and on.
fn runs(text: &[u8], setup: &Setup) -> Vec<(Setup, Analysis)> {
    let run = |block_skip| {
        let setup = Setup { block_skip, ..setup.clone() };
        let analysis = analyze(text, &setup);
        (setup, analysis)
    };
    switches(text, setup).into_iter().map(run).collect()
}

/// Whether a program is for this control: another one is not run, so nothing is known about it.
fn is_run(analysis: &Analysis) -> bool {
    !analysis.diagnostics.iter().any(is_for_other_control)
}

/// The block of the first motion that edits change; the largest number if only their number or the messages differ.
fn first_wrong(text: &[u8], edits: &[Edit], runs: &[(Setup, Analysis)], form: ProgramForm) -> Option<u32> {
    let after = applied(text, edits);
    let tolerance = if matches!(form, ProgramForm::Radius | ProgramForm::Center) { SAME } else { EXACT };
    runs.iter().find_map(|(setup, before)| {
        let after = analyze(&after, setup);
        match first_other_motion(&before.motions, &after.motions, tolerance) {
            Some(index) if index < before.motions.len() => Some(before.motions.span(index).start),
            Some(_) => Some(u32::MAX),
            None if before.codes != after.codes || !has_no_new_complaints(before, &after) => Some(u32::MAX),
            None => None,
        }
    })
}

/// The words of moves that are not in a form.
fn words(text: &[u8], form: ProgramForm) -> Vec<Span> {
    let (mut parser, mut block, mut all) = (Parser::new(text), Block::default(), Vec::new());
    while parser.next_block(&mut block) {
        let is_of_move = |code: G| is_modal(code) || matches!(code, G::Motion(_));
        if block.words.iter().filter_map(|word| g(word, CodeList::A)).all(is_of_move) {
            all.extend(block.words.iter().filter(|word| is_other(word, form, &block)).map(|word| word.span));
        }
    }
    all
}

/// Whether a word of a block is a coordinate or an arc in another form.
fn is_other(word: &Word, form: ProgramForm, block: &Block) -> bool {
    let is_arc =
        block.words.iter().any(|word| word.address == b'G' && matches!(plain(word), Some(2.0 | 3.0)));
    !word.comma
        && match form {
            ProgramForm::Absolute => matches!(word.address, b'U' | b'W'),
            ProgramForm::Incremental => matches!(word.address, b'X' | b'Z'),
            ProgramForm::Radius => is_arc && matches!(word.address, b'I' | b'K'),
            ProgramForm::Center => is_arc && word.address == b'R',
            _ => false,
        }
}

/// The move of a block, as it is programmed.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Move {
    from: Point,
    to: Point,
    arc: Option<Arc>,
    /// Whether X and Z of the start do not depend on an assumption.
    is_known: [bool; 2],
}

impl Move {
    /// Whether two executions of a block are the same in a form: the words of the other form do not depend on the rest.
    fn agrees(&self, other: &Self, form: ProgramForm) -> bool {
        let near = |a: Point, b: Point| a.distance(b) <= EXACT;
        let way = |own: &Self| Point::new(own.to.x - own.from.x, own.to.z - own.from.z);
        self.is_known == other.is_known
            && match form {
                ProgramForm::Absolute => near(self.to, other.to),
                ProgramForm::Incremental => near(way(self), way(other)),
                _ => near(way(self), way(other)) && self.arc.is_some() == other.arc.is_some(),
            }
    }
}

/// The edits of each block, by its first byte.
fn edits_of_blocks(text: &[u8], analysis: &Analysis, form: ProgramForm) -> BTreeMap<u32, Vec<Edit>> {
    let is_distance = matches!(form, ProgramForm::Absolute | ProgramForm::Incremental);
    if is_distance && analysis.codes != CodeList::A || !has_one_unit(text, analysis.codes, analysis.unit) {
        return BTreeMap::new();
    }
    let decimal = Dialect::new(&analysis.setup.dialect).decimal;
    let writer = Writer { text, form, unit: analysis.unit, decimal };
    let unrolled = Unrolled::of(text, analysis.codes);
    let moves = match unrolled.has_copies() {
        false => moves(&unrolled, analysis, form),
        true => moves(&unrolled, &analyze(&unrolled.text, &analysis.setup), form),
    };
    let of_block = |(start, found): (u32, Option<Move>)| Some((start, writer.edits(start, &found?)));
    moves.into_iter().filter_map(of_block).filter(|(_, edits)| !edits.is_empty()).collect()
}

/// A program with the blocks of a contour in place of each G70 that finishes it: so each of them makes its own motion.
#[derive(Default)]
struct Unrolled {
    text: Vec<u8>,
    pieces: Vec<Piece>,
}

/// A part of an unrolled text.
struct Piece {
    /// Its first byte.
    start: u32,
    /// Its bytes in the program.
    original: Range<u32>,
    /// Whether it is the copy of a contour.
    is_copy: bool,
}

impl Unrolled {
    fn of(text: &[u8], codes: CodeList) -> Self {
        let (mut parser, mut block) = (Parser::new(text), Block::default());
        let (mut numbered, mut calls): (BTreeMap<u32, Vec<Span>>, _) = (BTreeMap::new(), Vec::new());
        while parser.next_block(&mut block) {
            if let Some(number) = block.sequence {
                numbered.entry(number).or_default().push(block.span);
            }
            let value = |address: u8| block.words.iter().find(|word| word.address == address).and_then(plain);
            let finishes = |word| g(word, codes) == Some(G::Multiple(Multiple::Finishing));
            if let (true, Some(p), Some(q)) = (block.words.iter().any(finishes), value(b'P'), value(b'Q')) {
                calls.push((block.span, p as u32, q as u32));
            }
        }
        let mut unrolled = Self::default();
        let mut done = 0;
        for (call, p, q) in calls {
            let Some(first) = numbered.get(&p).map(|places| places[0]) else { continue };
            let Some(places) = numbered.get(&q) else { continue };
            let behind = places.partition_point(|place| place.start < first.start);
            let Some(last) = places.get(behind) else { continue };
            if unrolled.text.len() > MAX_COPIES * text.len() {
                break;
            }
            unrolled.push(text, done..call.start, false);
            unrolled.push(text, first.start..last.end, true);
            done = call.end;
        }
        unrolled.push(text, done..text.len() as u32, false);
        unrolled
    }

    fn push(&mut self, text: &[u8], original: Range<u32>, is_copy: bool) {
        let start = self.text.len() as u32;
        self.text.extend_from_slice(&text[original.start as usize..original.end as usize]);
        self.pieces.push(Piece { start, original, is_copy });
    }

    fn has_copies(&self) -> bool {
        self.pieces.iter().any(|piece| piece.is_copy)
    }

    /// The byte of the program for a byte of the text, and whether that is in a copy.
    fn original(&self, byte: u32) -> (u32, bool) {
        let behind = self.pieces.partition_point(|piece| piece.start <= byte);
        let piece = &self.pieces[behind - 1];
        (piece.original.start + (byte - piece.start), piece.is_copy)
    }
}

/// The block numbers to which a program can jump.
fn labels(text: &[u8], codes: CodeList) -> BTreeSet<u32> {
    let (mut parser, mut block, mut all) = (Parser::new(text), Block::default(), BTreeSet::new());
    while parser.next_block(&mut block) {
        all.extend(names(text, &block, codes).iter().filter(|named| !named.defines).filter_map(|named| {
            match named.name {
                Name::Sequence(number) => Some(number),
                _ => None,
            }
        }));
    }
    all
}

/// The words of the first block that has any.
fn first_block(text: &[u8]) -> Span {
    let (mut parser, mut block) = (Parser::new(text), Block::default());
    while parser.next_block(&mut block) {
        if !block.words.is_empty() {
            return block.words_span();
        }
    }
    Span::default()
}

/// Whether all blocks are in one unit.
fn has_one_unit(text: &[u8], codes: CodeList, unit: Unit) -> bool {
    let (mut parser, mut block) = (Parser::new(text), Block::default());
    while parser.next_block(&mut block) {
        let units = block.words.iter().filter_map(|word| g(word, codes)).filter_map(|code| match code {
            G::Unit(unit) => Some(unit),
            _ => None,
        });
        if units.into_iter().any(|own| own != unit) {
            return false;
        }
    }
    true
}

/// The moves of the blocks, by the first bytes of their originals; `None` if a block is executed in several ways.
fn moves(unrolled: &Unrolled, analysis: &Analysis, form: ProgramForm) -> BTreeMap<u32, Option<Move>> {
    let motions = &analysis.motions;
    let mut moves: BTreeMap<u32, Option<Move>> = BTreeMap::new();
    let mut is_known = [false; 2];
    let (mut block, mut index) = (Block::default(), 0);
    let mut before: Option<Motion> = None;
    let mut was_copy = false;
    while index < motions.len() {
        let span = motions.span(index);
        let mut end = index + 1;
        while end < motions.len() && motions.span(end) == span {
            end += 1;
        }
        let (first, last) = (motions.get(index), motions.get(end - 1));
        // G70 returns to its start, but a copy does not.
        let (start, is_copy) = unrolled.original(span.start);
        if was_copy && !is_copy || before.is_none_or(|before| !has_same_zero(&before, &first)) {
            is_known = [false; 2];
        }
        was_copy = is_copy;
        Parser::resume(&unrolled.text, Resume::inside(span.start, 0)).next_block(&mut block);
        let path =
            |motion: &Motion| motion.programmed.map_or((motion.from, motion.to), |own| (own.from, own.to));
        let own = Move { from: path(&first).0, to: path(&last).1, arc: programmed_arc(&first), is_known };
        let is_cycle = (index..end).any(|index| !is_move(&motions.get(index)));
        if !is_cycle {
            let is_convertible = is_convertible(&block, analysis.codes);
            let known = moves.entry(start).or_insert(Some(own));
            if !is_convertible || known.is_none_or(|known| !known.agrees(&own, form)) {
                *known = None;
            }
        }
        let has = |address: u8| block.words.iter().any(|word| word.address == address && !word.comma);
        if leads_elsewhere(&block, analysis.codes) {
            is_known = [false; 2];
        } else if !is_cycle {
            is_known = [is_known[0] || has(b'X'), is_known[1] || has(b'Z')];
        }
        before = Some(last);
        index = end;
    }
    moves
}

/// Whether the positions of two motions count from the same place, with the same tool.
fn has_same_zero(before: &Motion, after: &Motion) -> bool {
    let (one, other) = (&before.process, &after.process);
    one.tool == other.tool
        && one.frame == other.frame
        && one.zero == other.zero
        && one.tip_shift == other.tip_shift
}

/// Whether a motion is the move that its block programs, not a step of a cycle.
fn is_move(motion: &Motion) -> bool {
    motion.cycle.is_none() && motion.rotary.is_none() && !motion.process.uncertain
}

fn programmed_arc(motion: &Motion) -> Option<Arc> {
    let arc = motion.arc()?;
    Some(match motion.programmed {
        Some(own) => Arc { start: own.from, end: own.to, center: own.center?, turn: arc.turn },
        None => arc,
    })
}

/// Whether a block has only words with numbers, and no slash between them.
fn is_plain(block: &Block) -> bool {
    block.kind == BlockKind::Words
        && block.optional.is_none()
        && block.program.is_none()
        && !block.has_expressions
        && block.faults.is_empty()
}

/// A span with the blank before it.
fn with_blank(text: &[u8], span: Span) -> Span {
    let has_blank = span.start > 0 && text[span.start as usize - 1] == b' ';
    Span { start: span.start - u32::from(has_blank), end: span.end }
}

/// A number with a decimal point if it needs one.
fn with_point(number: String, needs_point: bool) -> String {
    if needs_point && !number.contains('.') { number + "." } else { number }
}

/// Whether a block contains only the words of a move, each at most once.
fn is_convertible(block: &Block, list: CodeList) -> bool {
    let axis = |address: u8| match address {
        b'U' => b'X',
        b'W' => b'Z',
        other => other,
    };
    let mut seen = Vec::new();
    is_plain(block)
        && block.words.iter().all(|word| {
            let is_first =
                word.address == b'G' || word.address == b'M' || !seen.contains(&axis(word.address));
            seen.push(axis(word.address));
            let is_of_move = match word.address {
                b'G' => g(word, list).is_some_and(is_modal),
                b'X' | b'Z' | b'U' | b'W' | b'F' | b'S' | b'M' | b'R' | b'I' | b'K' => true,
                _ => false,
            };
            is_first && is_of_move && !word.comma
        })
}

/// Whether a code leaves the coordinates of its block as they are.
fn is_modal(code: G) -> bool {
    matches!(
        code,
        G::Motion(MotionMode::Rapid | MotionMode::Line | MotionMode::Arc(_) | MotionMode::Thread)
            | G::Compensation(_)
            | G::Unit(_)
            | G::Feed(_)
            | G::SurfaceSpeed
            | G::ConstantSpeed
            | G::Idle
    )
}

/// Whether a block moves to a place that the program does not state.
fn leads_elsewhere(block: &Block, list: CodeList) -> bool {
    let leads = |code: G| matches!(code, G::Home | G::OtherHome | G::FromHome | G::Machine | G::CheckHome);
    block.words.iter().filter_map(|word| g(word, list)).any(leads)
}

/// Writes the words of blocks.
struct Writer<'a> {
    text: &'a [u8],
    form: ProgramForm,
    unit: Unit,
    decimal: DecimalRule,
}

impl Writer<'_> {
    fn edits(&self, start: u32, own: &Move) -> Vec<Edit> {
        let mut block = Block::default();
        Parser::resume(self.text, Resume::inside(start, 0)).next_block(&mut block);
        let others: Vec<Word> =
            block.words.iter().filter(|word| is_other(word, self.form, &block)).copied().collect();
        match self.form {
            ProgramForm::Absolute | ProgramForm::Incremental => {
                others.iter().filter_map(|word| self.coordinate(word, own)).collect()
            }
            ProgramForm::Radius => self.radius(&others, own).unwrap_or_default(),
            _ => self.center(&others, own).unwrap_or_default(),
        }
    }

    /// A coordinate as a distance, or a distance as a coordinate; `None` if its place is not known.
    fn coordinate(&self, word: &Word, own: &Move) -> Option<Edit> {
        let is_x = matches!(word.address, b'X' | b'U');
        if !own.is_known[usize::from(!is_x)] {
            return None;
        }
        let way = Point::new(own.to.x - own.from.x, own.to.z - own.from.z);
        let (to, letters) = match self.form {
            ProgramForm::Incremental => (way, ['U', 'W']),
            _ => (own.to, ['X', 'Z']),
        };
        let value = if is_x { Diameter::from_radius(to.x).mm() } else { to.z };
        let letter = letters[usize::from(!is_x)];
        Some(Edit { span: word.span, text: format!("{letter}{}", self.number(value, &[word])) })
    }

    /// I and K as R: in place of the first of them.
    fn radius(&self, words: &[Word], own: &Move) -> Option<Vec<Edit>> {
        let (first, rest) = words.split_first()?;
        let arc = own.arc?;
        // R is for arcs of less than half a turn (FANUC B-64304, G02).
        if arc.sweep().abs() >= std::f64::consts::PI {
            return None;
        }
        let radius = arc.start.distance(arc.center);
        let value = self.number(radius, &words.iter().collect::<Vec<_>>());
        let first = Edit { span: first.span, text: format!("R{value}") };
        let rest =
            rest.iter().map(|word| Edit { span: with_blank(self.text, word.span), text: String::new() });
        Some(std::iter::once(first).chain(rest).collect())
    }

    /// R as I and K, in its place.
    fn center(&self, words: &[Word], own: &Move) -> Option<Vec<Edit>> {
        let (word, arc) = (words.first()?, own.arc?);
        let [i, k] =
            [arc.center.x - arc.start.x, arc.center.z - arc.start.z].map(|way| self.number(way, &[word]));
        Some(vec![Edit { span: word.span, text: format!("I{i} K{k}") }])
    }

    /// A length, mm, in the unit of the program. It has a decimal point if one of the words that it replaces has one, or
    /// if a number without one would be in least increments.
    fn number(&self, mm: f64, instead_of: &[&Word]) -> String {
        let has_point = |word: &&Word| word.span.of(self.text).contains(&b'.');
        let needs_point = self.decimal == DecimalRule::LeastIncrement || instead_of.iter().any(has_point);
        with_point(number(mm / self.unit.millimetres()), needs_point)
    }
}
