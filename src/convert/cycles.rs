//! Writes multiple cycles, G71 to G76, in one block or in two.
//!
//! In: a program and its setup. Out: the edits of each call, by its cutting block. Each word keeps its role; the tables
//! of `control::codes::cycles` say which letter has a role in which block. A word without a letter in the other form,
//! such as the escape of G71, is omitted: whether the motions stay the same is decided by the caller.

use std::collections::{BTreeMap, BTreeSet};

use super::{ProgramForm, is_plain, labels, with_blank, with_point};
use crate::assist::Query;
use crate::assist::fact::Quantity;
use crate::assist::form::cycle_block;
use crate::control::codes::cycles::CycleBlock;
use crate::control::codes::role::Role;
use crate::control::codes::words::CodeWord;
use crate::control::codes::{G, Multiple};
use crate::control::words::{after_letter, letters, plain};
use crate::message::Edit;
use crate::rewrite::g;
use crate::run::Run;
use crate::run::replay::VisitChoice;
use crate::setup::Setup;
use crate::setup::dialect::{CodeList, Control, DecimalRule, Dialect, PqUnit};
use crate::source::{LineIndex, Span, after_line_end, only_line_end};
use crate::text::block::{Block, BlockKind, Word};
use crate::text::parser::{Parser, Resume};
use crate::units::{Unit, number};

/// Maximum number of calls that are converted.
const MAX_CALLS: usize = 500;
/// Maximum number of blocks that are executed again to find a block.
const MAX_BLOCKS: usize = 200_000;
/// The angles of G76 that have two digits in P.
const MAX_ANGLE: f64 = 99.0;

/// A call of a multiple cycle.
struct Call {
    cycle: Multiple,
    /// A first block directly before it.
    first: Option<Place>,
    /// The block that cuts.
    own: Place,
    block: CycleBlock,
}

/// A block of a call.
#[derive(Clone, Copy)]
struct Place {
    /// Its first byte.
    start: u32,
    /// The code of the cycle.
    code: Span,
}

/// The edits of the calls that are in the other form.
pub(super) fn edits(text: &[u8], setup: &Setup, form: ProgramForm) -> BTreeMap<u32, Vec<Edit>> {
    let mut run = Run::finished(text.to_vec(), setup.clone());
    let codes = run.code_list();
    let own: Vec<Call> = calls(text, codes).into_iter().filter(|call| call.is_other(form)).collect();
    let lines = LineIndex::new(text);
    let labels = labels(text, codes);
    let own = own.iter().take(MAX_CALLS);
    own.filter_map(|call| Some((call.own.start, call.edits(&mut run, &lines, &labels)?))).collect()
}

/// The codes of the calls in the other form.
pub(super) fn codes_in_other_form(text: &[u8], codes: CodeList, form: ProgramForm) -> Vec<Span> {
    let own = calls(text, codes).into_iter().filter(|call| call.is_other(form));
    own.map(|call| call.first.unwrap_or(call.own).code).collect()
}

fn calls(text: &[u8], codes: CodeList) -> Vec<Call> {
    let (mut parser, mut block) = (Parser::new(text), Block::default());
    let (mut all, mut before) = (Vec::new(), None);
    while parser.next_block(&mut block) {
        if block.words.is_empty() && block.kind == BlockKind::Words {
            continue;
        }
        let first = std::mem::take(&mut before);
        let code = |word: &Word| Some((cycle_of(word, codes)?, word.span));
        let Some((cycle, code)) = block.words.iter().find_map(code) else { continue };
        let own = Place { start: block.span.start, code };
        match cycle_block(cycle, &block) {
            CycleBlock::First => before = Some((cycle, own)),
            block => {
                let first = first.filter(|(other, _)| *other == cycle).map(|(_, place)| place);
                all.push(Call { cycle, first, own, block });
            }
        }
    }
    all
}

/// The roughing, pecking or threading cycle of a code.
fn cycle_of(word: &Word, codes: CodeList) -> Option<Multiple> {
    match g(word, codes)? {
        G::Multiple(Multiple::Finishing) => None,
        G::Multiple(cycle) => Some(cycle),
        _ => None,
    }
}

impl Call {
    fn is_other(&self, form: ProgramForm) -> bool {
        match form {
            ProgramForm::OneBlock => self.block == CycleBlock::Second,
            _ => self.block == CycleBlock::Whole,
        }
    }

    /// `labels`: the block numbers that other blocks use.
    fn edits(&self, run: &mut Run, lines: &LineIndex, labels: &BTreeSet<u32>) -> Option<Vec<Edit>> {
        let dialect = Dialect::new(&run.setup().dialect);
        let writer = Writer { unit: run.state().unit, dialect, cycle: self.cycle, code: self.own.code };
        let own = given(run, lines, self.own.start)?;
        if self.block == CycleBlock::Whole {
            return writer.in_two_blocks(run.text(), &own);
        }
        let first = match self.first {
            Some(first) => Some(given(run, lines, first.start)?),
            None => None,
        };
        writer.in_one_block(run.text(), labels, first.as_ref(), &own)
    }
}

/// A block of a call, with the values of its words.
struct Given {
    block: Block,
    words: Vec<Value>,
    /// Finishing passes and pull-out of G76 that are in force before the block.
    thread: [u32; 2],
}

/// A word with its role.
struct Value {
    word: Word,
    text: String,
    role: Role,
    /// A length, mm; `None` for a count.
    mm: Option<f64>,
}

/// The block at a byte; `None` if it is not executed, or has more than the words of its cycle.
fn given(run: &mut Run, lines: &LineIndex, start: u32) -> Option<Given> {
    let place = Resume::inside(start, lines.line_of(start));
    let mut replay = run.replay(place, start, VisitChoice::Usual);
    let found = run.advance_replay(&mut replay, MAX_BLOCKS).then(|| replay.found())?;
    let block = found.block(run);
    let can_change = is_plain(&block) && block.delete.is_none();
    let state = &found.visit.as_ref().filter(|_| can_change)?.before.state;
    let thread = [state.parameters.finishing, u32::from(state.thread_chamfer)];
    let asked = Query::new(run, &found, &block);
    let value = |word: &Word| {
        let hover = asked.hover(word.span.start, &[], run.motions())?;
        let mm = match hover.quantity {
            Some(Quantity::Length(mm)) => Some(mm),
            _ => None,
        };
        Some(Value { word: *word, text: word.span.quote(run.text()), role: hover.role?, mm })
    };
    let own = block.words.iter().filter(|word| !b"GM".contains(&word.address));
    let words: Vec<Value> = own.map(value).collect::<Option<_>>()?;
    let is_once = |value: &Value| words.iter().filter(|other| other.role == value.role).count() == 1;
    let is_known = words.iter().all(|value| !value.word.comma && is_once(value));
    is_known.then_some(Given { block, words, thread })
}

/// Writes the words of a cycle in its other form.
struct Writer {
    unit: Unit,
    dialect: Dialect,
    cycle: Multiple,
    /// The code in the block that cuts.
    code: Span,
}

impl Writer {
    /// The first block is removed, and its words are added to the second one.
    fn in_one_block(
        &self,
        text: &[u8],
        labels: &BTreeSet<u32>,
        first: Option<&Given>,
        second: &Given,
    ) -> Option<Vec<Edit>> {
        let sequence = first.and_then(|first| first.block.sequence);
        let is_code = |word: &&Word| b"GM".contains(&word.address);
        let has_more_codes = first.is_some_and(|first| first.block.words.iter().filter(is_code).count() > 1);
        if has_more_codes || sequence.is_some_and(|own| labels.contains(&own)) {
            return None;
        }
        let of_first = || first.into_iter().flat_map(|first| &first.words);
        let letter = |value| self.letter(CycleBlock::Whole, value);
        let kept = second.words.iter().map(|value| letter(value).unwrap_or(value.word.address));
        if !self.is_block(CycleBlock::Whole, kept.chain(of_first().filter_map(letter))) {
            return None;
        }
        let mut edits: Vec<Edit> = first.map(|first| without_block(text, &first.block)).into_iter().collect();
        let mut added = Vec::new();
        for value in of_first() {
            if value.role == Role::ThreadPacked {
                let angle = plain(&value.word)? % 100.0;
                added.extend((angle > 0.0).then(|| format!("A{}", number(angle))));
            } else if let Some(letter) = letter(value) {
                added.push(self.written(value, CycleBlock::First, letter, CycleBlock::Whole)?);
            }
        }
        let mut changed = Vec::new();
        for value in &second.words {
            if let Some(letter) = letter(value) {
                let written = self.written(value, CycleBlock::Second, letter, CycleBlock::Whole)?;
                changed
                    .extend((written != value.text).then_some(Edit { span: value.word.span, text: written }));
            }
        }
        // Before the feed rate, as in manuals.
        let feed = second.words.iter().find(|value| value.word.address == b'F');
        let at = feed.map_or(second.block.words.last()?.span.end, |value| value.word.span.start);
        let words: String = match feed {
            Some(_) => added.iter().map(|word| format!("{word} ")).collect(),
            None => added.iter().map(|word| format!(" {word}")).collect(),
        };
        if !words.is_empty() {
            changed.push(Edit { span: Span { start: at, end: at }, text: words });
        }
        if edits.is_empty() {
            if changed.is_empty() {
                return None;
            }
            // The code of a second block alone is converted with its words.
            changed.push(Edit { span: self.code, text: self.code.quote(text) });
        }
        changed.sort_by_key(|edit| (edit.span.start, edit.span.end));
        edits.extend(changed);
        Some(edits)
    }

    /// A first block is added, with the words that belong to it.
    fn in_two_blocks(&self, text: &[u8], own: &Given) -> Option<Vec<Edit>> {
        let code = self.code.quote(text);
        let mut first = vec![code.clone()];
        let mut edits = Vec::new();
        let is_moved = |value: &Value| {
            self.letter(CycleBlock::Second, value).is_none()
                && self.letter(CycleBlock::First, value).is_some()
        };
        let kept = own.words.iter().filter(|value| !is_moved(value) && !is_of_first(value));
        let letter = |value| self.letter(CycleBlock::Second, value).unwrap_or(value.word.address);
        if !self.is_block(CycleBlock::Second, kept.map(letter)) {
            return None;
        }
        if self.cycle == Multiple::Threading {
            let angle = own.words.iter().find(|value| value.role == Role::ThreadAngle);
            let angle = angle.map_or(Some(0.0), |value| plain(&value.word))?;
            if !(0.0..=MAX_ANGLE).contains(&angle) || angle.fract() != 0.0 {
                return None;
            }
            let [finishing, pull_out] = own.thread;
            // The one-block form has neither a least depth nor an allowance.
            first.extend([
                format!("P{finishing:02}{pull_out:02}{angle:02}"),
                "Q0".to_owned(),
                "R0".to_owned(),
            ]);
        }
        for value in &own.words {
            let span = with_blank(text, value.word.span);
            let in_second = self.letter(CycleBlock::Second, value);
            let edit = match (in_second, self.letter(CycleBlock::First, value)) {
                // In the first block, or as in force.
                _ if is_of_first(value) => Edit { span, text: String::new() },
                (Some(letter), _) => {
                    let text = self.written(value, CycleBlock::Whole, letter, CycleBlock::Second)?;
                    Edit { span: value.word.span, text }
                }
                (None, Some(letter)) => {
                    first.push(self.written(value, CycleBlock::Whole, letter, CycleBlock::First)?);
                    Edit { span, text: String::new() }
                }
                // F, S and T.
                (None, None) => continue,
            };
            edits.extend((edit.text != value.text).then_some(edit));
        }
        // Without an amount in it, no first block is needed.
        let codes = match first.len() {
            1 => code,
            _ => format!("{}{}{code}", first.join(" "), only_line_end(text)),
        };
        edits.push(Edit { span: self.code, text: codes });
        edits.sort_by_key(|edit| (edit.span.start, edit.span.end));
        Some(edits)
    }

    /// Whether words with these letters are this block of the cycle.
    fn is_block(&self, block: CycleBlock, own: impl Iterator<Item = u8>) -> bool {
        self.cycle.spec().block(own.fold(0, |bits, letter| bits | letters(&[letter]))) == block
    }

    /// The letter of a role in a block: the usual one, or the letter that the word has.
    fn letter(&self, block: CycleBlock, value: &Value) -> Option<u8> {
        let words = self.cycle.spec().words(block);
        let own = |word: &&CodeWord| word.roles.contains(&value.role);
        let usual = words.iter().filter(|word| word.otherwise.is_some()).find(own);
        let usual = usual.and_then(|word| {
            let at = word.roles.iter().position(|role| *role == value.role)?;
            word.letters.get(at).copied()
        });
        let same = words.iter().filter(own).find(|word| word.letters.contains(&value.word.address));
        usual.or(same.map(|_| value.word.address))
    }

    /// A word with another letter.
    fn written(&self, value: &Value, from: CycleBlock, letter: u8, to: CycleBlock) -> Option<String> {
        let is_same = letter == value.word.address;
        if is_same && self.counts_increments(letter, from) == self.counts_increments(letter, to) {
            return Some(value.text.clone());
        }
        let letter = char::from(letter);
        let Some(mm) = value.mm else { return Some(format!("{letter}{}", after_letter(&value.text))) };
        let length = mm / self.unit.millimetres();
        if self.counts_increments(letter as u8, to) {
            return Some(format!("{letter}{}", number((length / self.unit.increment()).round())));
        }
        let needs_point = self.dialect.decimal == DecimalRule::LeastIncrement || value.text.contains('.');
        Some(format!("{letter}{}", with_point(number(length), needs_point)))
    }

    /// Whether a letter is a length in least increments, without a decimal point: P and Q of the two-block form, and D of
    /// the one-block form.
    fn counts_increments(&self, letter: u8, block: CycleBlock) -> bool {
        match (letter, block) {
            (b'P' | b'Q', CycleBlock::First | CycleBlock::Second) => self.dialect.pq_unit != PqUnit::Mm,
            (b'D', CycleBlock::Whole) => self.dialect.control != Control::Gsk,
            _ => false,
        }
    }
}

/// Whether the two-block form of G76 has the value in P of the first block, or as it is in force.
fn is_of_first(value: &Value) -> bool {
    matches!(value.role, Role::ThreadAngle | Role::InfeedMethod)
}

/// Removes the words of a block; its line, if the block has no comment.
fn without_block(text: &[u8], block: &Block) -> Edit {
    let end = block.span.end as usize;
    let ends_line = matches!(text.get(end), Some(b'\n' | b'\r'));
    let whole =
        || Span::new(block.span.start as usize, if ends_line { after_line_end(text, end) } else { end });
    Edit { span: if block.comments.is_empty() { whole() } else { block.words_span() }, text: String::new() }
}
