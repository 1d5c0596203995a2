//! Lints for numbers that do not fit the rest of their program: a lost decimal point, a lost minus, U instead
//! of X.
//!
//! In: the text and its motions. Out: remarks, each with possible fixes. A control accepts all of these
//! blocks; only a comparison with the other blocks shows the mistake. So a pattern that is frequent in the
//! same program is not reported: it is the style of the author.

mod exchange;
mod increments;
mod passes;
mod points;
mod reach;
mod signs;
mod tools;

use std::collections::BTreeSet;

use crate::control::codes::{self, G, MotionMode, Multiple};
use crate::control::words::Reading;
use crate::message::{Diagnostic, said};
use crate::motion::Motions;
use crate::setup::Setup;
use crate::setup::dialect::{CodeList, DecimalRule};
use crate::source::Span;
use crate::text::block::{Block, BlockKind, Value};
use crate::text::parser::Parser;
use crate::units::Unit;

/// A word with a number, and its place.
#[derive(Clone, Copy, Debug)]
struct Word {
    address: u8,
    /// With its sign; a length in units of the program, whatever the rule for numbers without a point is.
    value: f64,
    negative: bool,
    /// Number of digits after the point; `None` without a point.
    decimals: Option<u8>,
    span: Span,
    /// Index of its block.
    block: usize,
}

/// Longest chamfer or corner rounding at the end of a move, mm.
const CORNER: f64 = 5.0;

/// The purpose of a block.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Role {
    /// Moves to a place.
    Place,
    /// Cuts with a multiple cycle whose X and Z are a place.
    Deep,
    /// Parameters of a cycle, or settings.
    Other,
}

/// A block with its motions.
#[derive(Clone, Debug)]
struct Row {
    span: Span,
    role: Role,
    words: std::ops::Range<usize>,
    /// Its first motion, and one past its last.
    motions: Option<(usize, usize)>,
    arc: bool,
    /// Whether G32, G33 or G92 is active.
    thread: bool,
    /// Whether it moves at rapid, according to the text.
    rapid: bool,
    /// Whether it moves at rapid to a place, and is not a cycle.
    moves_at_rapid: bool,
    /// Whether it belongs to a contour, P to Q.
    contour: bool,
    /// Whether its cycle roughs a contour.
    reads_contour: bool,
    /// Its sequence number.
    sequence: Option<u32>,
    /// Whether it calls a tool or ends the program: the numbers after it are unrelated to those before.
    parts: bool,
    /// The kind of the block.
    kind: BlockKind,
    /// Whether an O program begins.
    begins: bool,
    /// Index of its M02, M30 or M99, if that certainly ends the program.
    end: Option<usize>,
}

/// A parsed program.
struct Program<'a> {
    text: &'a [u8],
    rows: Vec<Row>,
    words: Vec<Word>,
    motions: &'a Motions,
    /// Millimetres in one unit of the text.
    unit: f64,
    /// The rule for numbers without a decimal point.
    decimal: DecimalRule,
    /// Least increment, mm.
    increment: f64,
    /// Whether it changes between inches and millimetres.
    has_both_units: bool,
    /// Targets of GOTO; `None` if the target is a variable.
    jumps: Vec<Option<u32>>,
}

/// Adds remarks about the numbers of a program that has run, in the order of importance, to the messages
/// about it. `reading` describes how its numbers are read at its end; `list` is the active list of codes.
pub fn compare(
    text: &[u8],
    motions: &Motions,
    reading: Reading,
    list: CodeList,
    setup: &Setup,
    reported: &mut Vec<Diagnostic>,
) {
    if reported.iter().any(is_of_dwell) && !(0..motions.len()).any(|index| motions.kind(index).cuts()) {
        // Without cuts it is a program that warms up the spindle.
        reported.retain(|old| !is_of_dwell(old));
    }
    let sound = !reported.iter().any(Diagnostic::is_error);
    let diagnostics = remarks(text, motions, reading, list, sound, setup.limits.compared_blocks);
    let diagnostics = diagnostics.into_iter().map(|diagnostic| diagnostic.in_unit(reading.unit));
    // One mistake, one message.
    let known = |new: &Diagnostic| reported.iter().any(|old| old.is_about(new.span));
    let mut diagnostics: Vec<_> =
        diagnostics.filter(|new| !known(new)).filter_map(|new| setup.rules.apply_to(new)).collect();
    if diagnostics.iter().any(turns_contour) {
        // The allowance is correct, and the message about the contour is a consequence.
        let gravest = reported.iter().filter(|old| is_consequence(old)).map(|old| old.severity).max();
        reported.retain(|old| !is_consequence(old));
        for one in diagnostics.iter_mut().filter(|one| turns_contour(one)) {
            one.severity = gravest.map_or(one.severity, |gravest| gravest.max(one.severity));
        }
    }
    let room = setup.limits.messages.saturating_sub(reported.len());
    reported.extend(diagnostics.into_iter().take(room));
}

/// Whether a message is about the time of a dwell.
fn is_of_dwell(diagnostic: &Diagnostic) -> bool {
    diagnostic.message.is::<said::DwellLong>() || diagnostic.message.is::<said::DwellShort>()
}

/// Whether a message is about a wrong number that makes a contour reverse.
fn turns_contour(diagnostic: &Diagnostic) -> bool {
    diagnostic.message.is::<said::MinusMissing>() || diagnostic.message.is::<said::IncrementalForAbsolute>()
}

/// Whether a message is a consequence of a contour that reverses.
fn is_consequence(diagnostic: &Diagnostic) -> bool {
    let message = &diagnostic.message;
    message.is::<said::AllowanceSign>()
        || message.is::<said::ContourTurnsBack>()
        || message.is::<said::ContourNotOneWay>()
}

/// Remarks about the numbers of a program; none if it has more than `blocks` blocks. `reading` describes how
/// its numbers are read at its end. If the program is not `sound` (a block was not executed), only its text
/// is checked: its motions are not the intended ones.
fn remarks(
    text: &[u8],
    motions: &Motions,
    reading: Reading,
    list: CodeList,
    sound: bool,
    blocks: usize,
) -> Vec<Diagnostic> {
    let Some(program) = Program::read(text, motions, reading, list, blocks) else { return Vec::new() };
    let mut diagnostics = program.leading_zeros();
    diagnostics.extend(program.unreached());
    diagnostics.extend(program.other_offset());
    diagnostics.extend(program.exchanged());
    if program.has_both_units {
        // Numbers in inches and in millimetres cannot be compared.
        return diagnostics;
    }
    diagnostics.extend(program.missing_points());
    diagnostics.extend(program.missing_minus_in_row());
    diagnostics.extend(program.increments_in_row());
    if sound {
        diagnostics.extend(program.far_off());
        diagnostics.extend(program.missing_minus());
        diagnostics.extend(program.increments());
    }
    diagnostics.truncate(MAX_REMARKS);
    // One mistake, one message: the first message about a word is kept.
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

/// Most remarks; more are a consequence of something else.
const MAX_REMARKS: usize = 50;

/// The meaning of a block's words according to its codes and the active ones.
#[derive(Clone, Copy)]
struct BlockCodes {
    role: Role,
    /// Whether its cycle is one of G74 to G76.
    is_multiple: bool,
    /// Whether its cycle roughs a contour.
    reads_contour: bool,
    /// Whether it switches to inches (true) or millimetres (false).
    inch: Option<bool>,
    arc: bool,
    /// Whether a thread is active.
    thread: bool,
    /// Whether it moves at rapid, according to the text.
    rapid: bool,
    /// Whether a hole cycle is active.
    hole: bool,
}

impl BlockCodes {
    /// The state at the beginning of a program.
    const START: Self = Self {
        role: Role::Place,
        is_multiple: false,
        reads_contour: false,
        inch: None,
        arc: false,
        thread: false,
        rapid: true,
        hole: false,
    };

    /// The state for the next block: the modal codes stay active.
    fn next(self) -> Self {
        let role = if self.hole { Role::Deep } else { Role::Place };
        Self { role, rapid: self.rapid, thread: self.thread, hole: self.hole, ..Self::START }
    }

    fn end_hole(&mut self) {
        if std::mem::take(&mut self.hole) {
            self.role = Role::Place;
        }
    }

    /// Handles a code of the block; an unknown code is ignored.
    fn read(&mut self, code: Option<G>) {
        let Some(code) = code else { return };
        match code {
            G::Motion(mode) => {
                self.end_hole();
                self.thread =
                    matches!(mode, MotionMode::Thread | MotionMode::VariableThread | MotionMode::Tapping)
                        || matches!(mode, MotionMode::Cycle(cycle) if cycle.is_thread());
                self.rapid = mode == MotionMode::Rapid;
                self.arc |= matches!(mode, MotionMode::Arc(_));
            }
            G::Dwell
            | G::Data
            | G::Home
            | G::OtherHome
            | G::Setting
            | G::LocalFrame
            | G::Machine
            | G::MacroCall(_) => self.role = Role::Other,
            G::Multiple(cycle) if !cycle.spec().reads_contour => {
                (self.role, self.is_multiple) = (Role::Deep, true);
            }
            G::Multiple(cycle) => {
                self.role = Role::Other;
                self.reads_contour = cycle != Multiple::Finishing;
            }
            // R, Q and K of a hole are not places, also in the blocks after it.
            G::Hole(_) => (self.role, self.hole) = (Role::Deep, true),
            G::NoHole => self.end_hole(),
            G::Unit(unit) => self.inch = Some(unit == Unit::Inch),
            G::Plane(_)
            | G::CheckHome
            | G::FromHome
            | G::EndOfData
            | G::Distance { .. }
            | G::HoleReturn(_)
            | G::NoModalMacro
            | G::Compensation(_)
            | G::Frame(_)
            | G::ExtendedFrame
            | G::Polar(_)
            | G::Cylinder
            | G::SurfaceSpeed
            | G::ConstantSpeed
            | G::Feed(_)
            | G::Idle
            | G::NotSupported => {}
        }
    }
}

impl<'a> Program<'a> {
    fn read(
        text: &'a [u8],
        motions: &'a Motions,
        reading: Reading,
        list: CodeList,
        most: usize,
    ) -> Option<Self> {
        let mut parser = Parser::new(text);
        let mut block = Block::default();
        let (mut rows, mut words) = (Vec::new(), Vec::new());
        let mut state = BlockCodes::START;
        let mut units = BTreeSet::new();
        let mut jumps = Vec::new();
        while parser.next_block(&mut block) {
            if rows.len() >= most {
                return None;
            }
            let first = words.len();
            let mut has_arguments = false;
            state = state.next();
            let has = |letters: &[u8]| block.words.iter().any(|word| is_among(letters, word.address));
            for word in &block.words {
                let Value::Number { number, negative } = word.value else { continue };
                let written = word.span.of(text);
                // A misread word was reported; a corner word is relative to its corner.
                if !written.is_ascii() || !written[0].is_ascii_alphabetic() {
                    continue;
                }
                let fine = reading.decimal == DecimalRule::LeastIncrement
                    && !number.has_point()
                    && is_among(LENGTHS, word.address);
                let value = if fine { number.value() * reading.unit.increment() } else { number.value() };
                let value = if negative { -value } else { value };
                let decimals = number.has_point().then_some(number.decimals);
                if word.address == b'G' {
                    let key = number.tenths();
                    let code = key.and_then(|key| codes::g_code(key, list)).map(|found| found.code);
                    has_arguments |= matches!(code, Some(G::MacroCall(_)))
                        || key.is_some_and(|key| codes::is_of_machine(key, list));
                    state.read(code);
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
            let mut role = state.role;
            if role == Role::Deep && state.is_multiple && !has(b"XZ") {
                // The first block of a pair.
                role = Role::Other;
            }
            if block.kind != BlockKind::Words || block.is_broken() || has_arguments {
                role = Role::Other;
            }
            units.extend(state.inch);
            if block.kind == BlockKind::Macro {
                jumps.extend(jump(block.span.of(text)));
            }
            // M99 with P is a jump.
            let ends = |word: &Word| {
                word.address == b'M' && (matches!(word.value, 2.0 | 30.0) || word.value == 99.0 && !has(b"P"))
            };
            let is_sure = block.kind == BlockKind::Words
                && block.delete.is_none()
                && block.optional.is_none()
                && !has_arguments;
            let end = (first..words.len()).find(|&index| is_sure && ends(&words[index]));
            let BlockCodes { rapid, thread, arc, reads_contour, .. } = state;
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
                reads_contour,
                sequence: block.sequence,
                parts,
                kind: block.kind,
                begins: block.program.is_some(),
                end,
            });
        }
        let (unit, decimal) = (reading.unit.millimetres(), reading.decimal);
        let increment = reading.unit.increment() * unit;
        let has_both_units = units.len() > 1;
        let mut program =
            Self { text, rows, words, motions, unit, decimal, increment, has_both_units, jumps };
        program.match_motions();
        program.find_contours();
        Some(program)
    }

    /// Finds the motions of each block in its first uninterrupted run.
    fn match_motions(&mut self) {
        // Most motions belong to the same block as the one before.
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

    /// Marks the blocks of contours that a cycle before them names.
    fn find_contours(&mut self) {
        for index in 0..self.rows.len() {
            let words = self.words_of(&self.rows[index]);
            let cycle = self.rows[index].reads_contour;
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

    /// Whether a block cuts.
    fn is_cut(&self, row: &Row) -> bool {
        let (from, to) = row.motions.unwrap_or_default();
        (from..to).any(|index| self.motions.kind(index).cuts())
    }

    /// Words that move the tool along either axis, with a number that is not zero.
    fn places(&self) -> impl Iterator<Item = &Word> {
        self.words.iter().filter(|word| {
            is_among(b"XZUW", word.address) && self.rows[word.block].role != Role::Other && word.value != 0.0
        })
    }

    /// The places along an axis in the order of the text, each with the place before and after it in the same
    /// section.
    fn neighbours(&self, letters: &'static [u8]) -> Vec<(Option<&Word>, &Word, Option<&Word>)> {
        let own: Vec<&Word> = self.places_or_zero().filter(|word| is_among(letters, word.address)).collect();
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
            .filter(|word| is_among(b"XZUW", word.address) && self.rows[word.block].role != Role::Other)
    }
}

/// Target of a GOTO in a macro statement: `Some(None)` if it is a variable, `None` without a GOTO.
fn jump(statement: &[u8]) -> Option<Option<u32>> {
    let at = statement.windows(4).position(|word| word.eq_ignore_ascii_case(b"GOTO"))?;
    let number: String = Span::new(at + 4, statement.len()).quote(statement);
    let digits: String = number.trim_start().chars().take_while(char::is_ascii_digit).collect();
    Some(digits.parse().ok())
}

/// Whether a letter is one of a few.
#[allow(clippy::manual_contains, reason = "that is a search made for long texts, and slow in short ones")]
fn is_among(letters: &[u8], letter: u8) -> bool {
    letters.iter().any(|&own| own == letter)
}

/// Rounds to a thousandth of a millimetre.
fn round(length: f64) -> f64 {
    (1000.0 * length).round() / 1000.0
}
