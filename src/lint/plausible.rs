//! Numbers that do not fit the rest of their program: a lost point, a lost minus, U where X was meant.
//!
//! In: the text, its motions. Out: remarks, each with repairs to choose from. A control carries all of it out; only who
//! compares a block with the others sees it. So nothing is said of what occurs often in the same program: that is its
//! style.

mod increments;
mod passes;
mod points;
mod signs;

use crate::control::words::Reading;
use crate::message::{Diagnostic, Message};
use crate::motion::{Motion, Motions};
use crate::setup::Setup;
use crate::setup::dialect::DecimalRule;
use crate::source::Span;
use crate::text::block::{Block, BlockKind, Value};
use crate::text::parser::Parser;

/// A word with a number, where it stands.
#[derive(Clone, Copy, Debug)]
struct Word {
    address: u8,
    /// With its sign; a length in units of the program, whatever numbers without a point count.
    value: f64,
    negative: bool,
    /// Digits after the point; nothing without a point.
    decimals: Option<u8>,
    span: Span,
    /// Index of its block.
    block: usize,
}

/// What a chamfer or a rounded corner may take off a move, mm.
const CORNER: f64 = 5.0;

/// What a block is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Role {
    /// Moves to a place.
    Place,
    /// Cuts by a multiple cycle whose X and Z are a place.
    Deep,
    /// Parameters of a cycle, settings.
    Other,
}

/// A block with what it moved.
#[derive(Clone, Debug)]
struct Row {
    span: Span,
    role: Role,
    words: std::ops::Range<usize>,
    /// Its first motion, and one past its last.
    motions: Option<(usize, usize)>,
    arc: bool,
    /// G32, G33 or G92 is in force.
    thread: bool,
    /// It moves at rapid, as far as the text shows.
    rapid: bool,
    /// The same, and it names a place and is no cycle.
    moves_at_rapid: bool,
    /// It stands in a contour, P to Q.
    contour: bool,
    /// Its sequence number.
    sequence: Option<u32>,
    /// A tool is called, or the program ends: what stands after has nothing to do with what stood before.
    parts: bool,
}

/// A program taken apart.
struct Program<'a> {
    text: &'a [u8],
    rows: Vec<Row>,
    words: Vec<Word>,
    motions: &'a Motions,
    /// Millimetres in one unit of the text.
    unit: f64,
    /// What numbers without a point count.
    decimal: DecimalRule,
    /// A least increment, mm.
    increment: f64,
}

/// Adds remarks about the numbers of a program that has run, in the order of importance, to all that was reported of it.
/// `reading`: how its numbers are read at its end.
pub fn compare(
    text: &[u8],
    motions: &Motions,
    reading: Reading,
    setup: &Setup,
    reported: &mut Vec<Diagnostic>,
) {
    let sound = !reported.iter().any(Diagnostic::is_error);
    let diagnostics = remarks(text, motions, reading, sound, setup.limits.compared_blocks);
    let diagnostics = diagnostics.into_iter().map(|diagnostic| diagnostic.in_unit(reading.unit));
    // One fault, one message.
    let known = |new: &Diagnostic| reported.iter().any(|old| old.is_about(new.span));
    let mut diagnostics: Vec<_> =
        diagnostics.filter(|new| !known(new)).filter_map(|new| setup.rules.graded(new)).collect();
    if diagnostics.iter().any(turns_contour) {
        // The allowance is right, and what the contour does is a consequence.
        let gravest = reported.iter().filter(|old| follows(old)).map(|old| old.severity).max();
        reported.retain(|old| !follows(old));
        for one in diagnostics.iter_mut().filter(|one| turns_contour(one)) {
            one.severity = gravest.map_or(one.severity, |gravest| gravest.max(one.severity));
        }
    }
    let room = setup.limits.messages.saturating_sub(reported.len());
    reported.extend(diagnostics.into_iter().take(room));
}

/// Whether a number that is wrong makes a contour turn back.
fn turns_contour(diagnostic: &Diagnostic) -> bool {
    matches!(diagnostic.message, Message::MinusMissing { .. } | Message::IncrementalForAbsolute { .. })
}

/// Whether a message is a consequence of a contour that turns back.
fn follows(diagnostic: &Diagnostic) -> bool {
    matches!(diagnostic.message, Message::AllowanceSign { .. } | Message::ContourTurnsBack { .. })
}

/// Remarks about the numbers of a program of no more than `blocks` blocks; none of a longer one. `reading`: how its numbers are
/// read at its end. Of a program that is not
/// `sound` (a block was not carried out) only the writing is looked at: its motions are not what was meant.
fn remarks(text: &[u8], motions: &Motions, reading: Reading, sound: bool, blocks: usize) -> Vec<Diagnostic> {
    let Some(program) = Program::read(text, motions, reading, blocks) else { return Vec::new() };
    let mut diagnostics = program.leading_zeros();
    if program.has_both_units() {
        // Numbers of inches and of millimetres are not to be compared.
        return diagnostics;
    }
    diagnostics.extend(program.missing_points());
    diagnostics.extend(program.lost_minus_in_row());
    diagnostics.extend(program.increments_in_row());
    if sound {
        diagnostics.extend(program.far_off());
        diagnostics.extend(program.lost_minus());
        diagnostics.extend(program.increments());
    }
    diagnostics.truncate(MOST);
    // One fault, one message: what was reported first of a word stays.
    let mut seen = Vec::new();
    diagnostics.retain(|one| {
        let new = !seen.contains(&one.span);
        seen.push(one.span);
        new
    });
    diagnostics
}

/// Letters of lengths.
const LENGTHS: &[u8] = b"XYZUVWIJKRCA";

/// More of them are a consequence of something else.
const MOST: usize = 50;

const MULTIPLE: std::ops::RangeInclusive<u64> = 70..=76;
/// G04, G10, G28, G30, G50, G52, G53, G65, G66.
const SETTINGS: [u64; 9] = [4, 10, 28, 30, 50, 52, 53, 65, 66];

impl<'a> Program<'a> {
    /// Whether the program changes between inches and millimetres.
    fn has_both_units(&self) -> bool {
        let has = |code: f64| self.words.iter().any(|word| word.address == b'G' && word.value == code);
        has(20.0) && has(21.0)
    }

    fn read(text: &'a [u8], motions: &'a Motions, reading: Reading, most: usize) -> Option<Self> {
        let mut parser = Parser::new(text);
        let mut block = Block::default();
        let (mut rows, mut words) = (Vec::new(), Vec::new());
        let (mut rapid, mut thread) = (true, false);
        while parser.next_block(&mut block) {
            if rows.len() >= most {
                return None;
            }
            let first = words.len();
            let mut role = Role::Place;
            let mut arc = false;
            let has = |letters: &[u8]| block.words.iter().any(|word| letters.contains(&word.address));
            for word in &block.words {
                let Value::Number { number, negative } = word.value else { continue };
                let written = word.span.of(text);
                // A misread word was reported; a corner word counts from its corner.
                if !written.is_ascii() || !written[0].is_ascii_alphabetic() {
                    continue;
                }
                let fine = reading.decimal == DecimalRule::LeastIncrement
                    && !number.has_point()
                    && LENGTHS.contains(&word.address);
                let value = if fine { number.value() * reading.unit.increment() } else { number.value() };
                let value = if negative { -value } else { value };
                let decimals = number.has_point().then_some(number.decimals);
                if word.address == b'G' && number.decimals == 0 {
                    match number.mantissa {
                        32 | 33 | 92 => thread = true,
                        0..=3 | 90 | 94 => thread = false,
                        _ => {}
                    }
                    match number.mantissa {
                        code if SETTINGS.contains(&code) => role = Role::Other,
                        74..=76 if has(b"XZ") => role = Role::Deep,
                        // R and Q of a hole are no places.
                        83 | 84 | 85 | 87 | 88 | 89 => role = Role::Deep,
                        code if MULTIPLE.contains(&code) => role = Role::Other,
                        0 => rapid = true,
                        1 | 32 | 34 | 90 | 92 | 94 => rapid = false,
                        2 | 3 => (arc, rapid) = (true, false),
                        _ => {}
                    }
                }
                words.push(Word {
                    address: word.address,
                    value,
                    negative,
                    decimals,
                    span: word.span,
                    block: rows.len(),
                });
            }
            let ends = |word: &crate::text::block::Word| match word.value {
                Value::Number { number, .. } => {
                    word.address == b'T'
                        || word.address == b'M' && matches!(number.mantissa, 2 | 30 | 98 | 99)
                }
                Value::Expression => true,
            };
            let parts =
                block.program.is_some() || block.kind != BlockKind::Words || block.words.iter().any(ends);
            if block.kind != BlockKind::Words || block.is_broken() {
                role = Role::Other;
            }
            rows.push(Row {
                span: block.span,
                role,
                words: first..words.len(),
                motions: None,
                arc,
                thread,
                rapid,
                moves_at_rapid: rapid && role == Role::Place && has(b"XZUW"),
                contour: false,
                sequence: block.sequence,
                parts,
            });
        }
        let (unit, decimal) = (reading.unit.millimetres(), reading.decimal);
        let increment = reading.unit.increment() * unit;
        let mut program = Self { text, rows, words, motions, unit, decimal, increment };
        program.match_motions();
        program.find_contours();
        Some(program)
    }

    /// Which motions each block made, where it ran in one go.
    fn match_motions(&mut self) {
        // Most motions are made by the block of the motion before.
        let (mut before, mut row) = (u32::MAX, None);
        for index in 0..self.motions.len() {
            let start = self.motions.span(index).start;
            if start != before {
                row = self.rows.binary_search_by_key(&start, |row| row.span.start).ok();
                before = start;
            }
            let Some(row) = row else { continue };
            match &mut self.rows[row].motions {
                Some((_, end)) if *end == index => *end = index + 1,
                Some(_) => {}
                none => *none = Some((index, index + 1)),
            }
        }
    }

    /// Which blocks stand in a contour that a cycle before them names.
    fn find_contours(&mut self) {
        for index in 0..self.rows.len() {
            let words = self.words_of(&self.rows[index]);
            let cycle = words.iter().any(|word| word.address == b'G' && (71.0..=73.0).contains(&word.value));
            let named =
                |address: u8| words.iter().find(|word| word.address == address).map(|word| word.value as u32);
            let (true, Some(first), Some(last)) = (cycle, named(b'P'), named(b'Q')) else { continue };
            let at = |number: u32| {
                (index + 1..self.rows.len()).find(|&row| self.rows[row].sequence == Some(number))
            };
            if let (Some(first), Some(last)) = (at(first), at(last)) {
                self.rows[first.min(last)..=last].iter_mut().for_each(|row| row.contour = true);
            }
        }
    }

    fn words_of(&self, row: &Row) -> &[Word] {
        &self.words[row.words.clone()]
    }

    fn quote(&self, word: &Word) -> String {
        word.span.quote(self.text)
    }

    fn made(&self, row: &Row) -> impl Iterator<Item = Motion> + '_ {
        let (from, to) = row.motions.unwrap_or_default();
        (from..to).map(|index| self.motions.get(index))
    }

    /// Words that place the tool, along either axis, with a number that is not zero.
    fn places(&self) -> impl Iterator<Item = &Word> {
        self.words.iter().filter(|word| {
            b"XZUW".contains(&word.address) && self.rows[word.block].role != Role::Other && word.value != 0.0
        })
    }

    /// The places along an axis in the order of the text, with what stands before and after each in the same stretch.
    fn neighbours(&self, letters: &'static [u8]) -> Vec<(Option<&Word>, &Word, Option<&Word>)> {
        let own: Vec<&Word> = self.places_or_zero().filter(|word| letters.contains(&word.address)).collect();
        let together = |a: &Word, b: &Word| {
            let between = &self.rows[a.block + 1..=b.block];
            b.block > a.block && !between.iter().any(|row| row.parts)
        };
        let at = |index: Option<usize>| index.and_then(|index| own.get(index).copied());
        let mut found = Vec::new();
        for (index, &word) in own.iter().enumerate() {
            let before = at(index.checked_sub(1)).filter(|other| together(other, word));
            let behind = at(Some(index + 1)).filter(|other| together(word, other));
            found.push((before, word, behind));
        }
        found
    }

    fn places_or_zero(&self) -> impl Iterator<Item = &Word> {
        self.words
            .iter()
            .filter(|word| b"XZUW".contains(&word.address) && self.rows[word.block].role != Role::Other)
    }
}

/// To a thousandth of a millimetre.
fn round(length: f64) -> f64 {
    (1000.0 * length).round() / 1000.0
}
