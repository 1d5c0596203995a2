//! Whether a changed text is still the same program.
//!
//! In: the run of a text, and the changed text. Out: the first [`Difference`]. Compared are: the motions and the codes
//! of the messages, with block skip off and on; each block as read, apart from its sequence number and the numbers
//! that refer to blocks; the block that each reference leads to, also where it is never executed. Must not know
//! the reason for the change.

use std::task::Poll;

use crate::assist::names::{Name, Named, names};
use crate::control::words::plain;
use crate::message::{Diagnostic, Edit, applied, said};
use crate::references::{References, Target};
use crate::run::Run;
use crate::sentences::Language;
use crate::setup::Setup;
use crate::setup::dialect::CodeList;
use crate::source::Span;
use crate::text::block::{Block, BlockKind, Value, Word};
use crate::text::lexer::is_blank;
use crate::text::parser::{Parser, Resume};

/// All levels of block skip.
const LEVELS: std::ops::RangeInclusive<u8> = 1..=9;

/// The reason why a changed text may not be the same program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Difference {
    /// The program is for another control: it is not run, so nothing is known.
    OtherControl,
    /// A block reads differently. The span is in the original text.
    Block(Span),
    /// A reference leads to another block. The span is in the original text.
    Reference(Span),
    /// The motions differ, from the block at this span of the original text on.
    Motions(Span),
    /// The messages differ.
    Messages,
}

impl Difference {
    /// Where the programs differ, in the original text.
    pub fn span(self) -> Option<Span> {
        match self {
            Self::Block(span) | Self::Reference(span) | Self::Motions(span) => Some(span),
            Self::OtherControl | Self::Messages => None,
        }
    }

    /// Why the text stays as it is.
    pub fn reason(self, language: Language) -> &'static str {
        language.among(match self {
            Self::OtherControl => [
                "it is a program for another control",
                "这是其他控制系统的程序",
                "это программа для другой системы ЧПУ",
            ],
            Self::Block(_) => {
                ["the block would read differently", "该程序段的含义会改变", "кадр читался бы иначе"]
            }
            Self::Reference(_) => [
                "the number would lead to another block",
                "顺序号会指向另一程序段",
                "номер указывал бы на другой кадр",
            ],
            Self::Motions(_) => [
                "the motions would differ from this block on",
                "从该程序段起运动会不同",
                "с этого кадра перемещения были бы другими",
            ],
            Self::Messages => ["the messages would differ", "提示信息会不同", "сообщения были бы другими"],
        })
    }
}

/// The first difference that edits make to the program of a run; `None` if the program stays the same.
pub fn difference_by(edits: &[Edit], run: &Run) -> Option<Difference> {
    if edits.is_empty() { None } else { difference(run, applied(run.text(), edits)) }
}

/// The first difference between the program of a run and a changed text; `None` if both are the same program.
pub fn difference(run: &Run, after: Vec<u8>) -> Option<Difference> {
    let mut comparison = Comparison::new(run, after);
    loop {
        if let Poll::Ready(found) = comparison.advance(run, usize::MAX) {
            return found;
        }
    }
}

/// The comparison of a program with a changed text, in slices.
pub struct Comparison {
    /// The settings of block skip that are compared after the current one, the next one last.
    switches: Vec<Vec<u8>>,
    /// The run of the original text with the current setting; `None`: the run of the caller.
    before: Option<Run>,
    /// The run of the changed text with the same setting.
    after: Run,
    stage: Stage,
}

/// What is compared.
enum Stage {
    Runs,
    /// The blocks from these places on.
    Blocks {
        at: [Resume; 2],
        /// Whether a sequence number or a reference may have been changed.
        is_renumbered: bool,
    },
    References,
}

impl Comparison {
    /// Begins to compare the text of a run with a changed text.
    pub fn new(run: &Run, after: Vec<u8>) -> Self {
        let mut switches = switches(run.text(), &run.setup_to_repeat());
        let own = switches.remove(0);
        switches.reverse();
        // The motions of a run that was stopped are incomplete.
        let before = (!run.is_complete()).then(|| run.repeated(run.text().to_vec(), own.clone()));
        Self { switches, before, after: run.repeated(after, own), stage: Stage::Runs }
    }

    /// Compares in one slice of at most `blocks` blocks; the motions, and the references, each in a slice. `run`: the
    /// run that the comparison began with, unchanged. Ready with the first difference; with `None` if both texts are
    /// the same program.
    pub fn advance(&mut self, run: &Run, blocks: usize) -> Poll<Option<Difference>> {
        match self.stage {
            Stage::Runs => self.advance_runs(run, blocks),
            Stage::Blocks { at, is_renumbered } => self.advance_blocks(run, blocks, at, is_renumbered),
            Stage::References => Poll::Ready(self.difference_of_references(run)),
        }
    }

    fn advance_runs(&mut self, run: &Run, blocks: usize) -> Poll<Option<Difference>> {
        let is_before_ready = self.before.as_mut().is_none_or(|before| before.advance(blocks));
        if !is_before_ready || !self.after.advance(blocks) {
            return Poll::Pending;
        }
        let before = self.before.as_ref().unwrap_or(run);
        if before.diagnostics().iter().any(is_for_other_control) {
            return Poll::Ready(Some(Difference::OtherControl));
        }
        let found = difference_of_runs(before, &self.after);
        if found.is_some() {
            return Poll::Ready(found);
        }
        match self.switches.pop() {
            Some(block_skip) => {
                self.before = Some(run.repeated(run.text().to_vec(), block_skip.clone()));
                self.after = run.repeated(self.after.take_text(), block_skip);
            }
            None => self.stage = Stage::Blocks { at: Default::default(), is_renumbered: false },
        }
        Poll::Pending
    }

    fn advance_blocks(
        &mut self,
        run: &Run,
        count: usize,
        at: [Resume; 2],
        mut is_renumbered: bool,
    ) -> Poll<Option<Difference>> {
        let (texts, codes) = ([run.text(), self.after.text()], self.codes(run));
        let mut parsers = [Parser::resume(texts[0], at[0]), Parser::resume(texts[1], at[1])];
        let mut blocks = [Block::default(), Block::default()];
        for _ in 0..count {
            let [first, second] = &mut parsers;
            let left = [first.next_block(&mut blocks[0]), second.next_block(&mut blocks[1])];
            if left == [false, false] {
                self.stage = Stage::References;
                return if is_renumbered { Poll::Pending } else { Poll::Ready(None) };
            }
            // After its last block, a text reads as empty blocks: an empty last line makes no difference.
            let reads = [Read::of(texts[0], &blocks[0]), Read::of(texts[1], &blocks[1])];
            if reads[0].has_same_numbers(&reads[1]) {
                continue;
            }
            is_renumbered = true;
            let [first, second] = reads.map(|read| read.without_references(codes));
            if !first.is_same(&second) {
                return Poll::Ready(Some(Difference::Block(blocks[0].span)));
            }
        }
        self.stage = Stage::Blocks { at: parsers.map(|parser| parser.position()), is_renumbered };
        Poll::Pending
    }

    fn difference_of_references(&self, run: &Run) -> Option<Difference> {
        let (codes, control) = (self.codes(run), run.setup_to_repeat().dialect.control.unwrap_or_default());
        let texts = [run.text(), self.after.text()];
        let [first, second] = texts.map(|text| References::of(text, codes, control).references);
        let is_same = |index: usize| {
            let (first, second) = (first.get(index), second.get(index));
            first.zip(second).is_some_and(|(first, second)| {
                first.block == second.block && leads_to_same(&first.target, &second.target)
            })
        };
        let at = (0..first.len().max(second.len())).find(|index| !is_same(*index))?;
        Some(Difference::Reference(first.get(at).map_or(Span::default(), |reference| reference.span)))
    }

    fn codes(&self, run: &Run) -> CodeList {
        self.before.as_ref().unwrap_or(run).code_list()
    }
}

/// Whether a message says that the program is for another control, and is not run.
pub fn is_for_other_control(told: &Diagnostic) -> bool {
    let message = &told.message;
    message.is::<said::ForeignControl>()
        || message.is::<said::ForeignMill>()
        || message.is::<said::ForeignPrinter>()
}

/// The settings of block skip under which the program runs: that of the setup, and off and on if a block can
/// be skipped.
pub fn switches(text: &[u8], setup: &Setup) -> Vec<Vec<u8>> {
    let mut found = vec![setup.block_skip.clone()];
    if text.contains(&b'/') {
        found.extend([Vec::new(), LEVELS.collect()].into_iter().filter(|other| *other != setup.block_skip));
    }
    found
}

fn difference_of_runs(before: &Run, after: &Run) -> Option<Difference> {
    let stops = |run: &Run| -> Vec<_> {
        run.motions().stops(0..run.motions().len() + 1).map(|(index, stop)| (index, stop.kind)).collect()
    };
    let is_same = before.code_list() == after.code_list()
        && before.state().unit == after.state().unit
        && before.inferred_rule() == after.inferred_rule()
        && before.motions().len() == after.motions().len()
        && stops(before) == stops(after);
    let messages = |run: &Run| -> Vec<String> { run.diagnostics().iter().map(|told| told.code()).collect() };
    let mut motions = before.motions().iter().zip(after.motions().iter());
    let has_same_chunks = before.motions().has_same_chunks(after.motions());
    match if has_same_chunks { None } else { motions.position(|(one, other)| one != other) } {
        Some(index) => Some(Difference::Motions(before.motions().span(index))),
        None if !is_same => Some(Difference::Motions(Span::default())),
        None if messages(before) != messages(after) => Some(Difference::Messages),
        None => None,
    }
}

/// A block as a control reads it.
struct Read<'a> {
    text: &'a [u8],
    block: &'a Block,
    /// The numbers of blocks in it that are not compared, in text order.
    left_out: Vec<Span>,
}

/// The value of a word.
#[derive(PartialEq)]
enum Content {
    LeftOut,
    Number { value: Option<f64>, decimals: u32, points: u32 },
    Expression(Vec<u8>),
}

impl<'a> Read<'a> {
    fn of(text: &'a [u8], block: &'a Block) -> Self {
        Self { text, block, left_out: Vec::new() }
    }

    /// The block without the words that refer to other blocks.
    fn without_references(self, codes: CodeList) -> Self {
        let names = names(self.text, self.block, codes);
        let is_reference = |named: &&Named| !named.defines && matches!(named.name, Name::Sequence(_));
        Self { left_out: names.iter().filter(is_reference).map(|named| named.span).collect(), ..self }
    }

    /// Whether two blocks are the same, with their sequence numbers and references. Of a macro statement this is known
    /// only if it is written in the same way.
    fn has_same_numbers(&self, other: &Self) -> bool {
        let as_written = |read: &Self| read.block.span.of(read.text);
        self.block.sequence == other.block.sequence
            && self.is_same(other)
            && (self.block.kind != BlockKind::Macro || as_written(self) == as_written(other))
    }

    /// Whether two blocks are the same, apart from their sequence numbers.
    fn is_same(&self, other: &Self) -> bool {
        self.kind() == other.kind()
            && self.faults().eq(other.faults())
            && self.block.words.len() == other.block.words.len()
            && self.block.words.iter().zip(&other.block.words).all(|words| self.is_same_word(other, words))
            && self.comments().eq(other.comments())
            && self.statement() == other.statement()
    }

    fn kind(&self) -> impl PartialEq {
        let block = self.block;
        let number = |head: Option<(u32, Span)>| head.map(|(number, _)| number);
        let heads = (number(block.program), number(block.second_name));
        (block.kind, block.delete, block.optional, block.is_overlong(), heads)
    }

    fn faults(&self) -> impl Iterator<Item = &str> {
        self.block.faults.iter().map(|fault| fault.message.slug())
    }

    fn comments(&self) -> impl Iterator<Item = &[u8]> {
        self.block.comments.iter().map(|comment| comment.of(self.text))
    }

    fn is_same_word(&self, other: &Self, (own, others): (&Word, &Word)) -> bool {
        let is_same_number = matches!(own.value, Value::Number { .. }) && own.value == others.value;
        let is_same_value = || self.content(own) == other.content(others);
        own.address == others.address && own.comma == others.comma && (is_same_number || is_same_value())
    }

    fn content(&self, word: &Word) -> Content {
        match word.value {
            _ if self.left_out.contains(&word.span) => Content::LeftOut,
            Value::Number { number, .. } => {
                let (decimals, points) = (number.decimals.into(), number.points.into());
                Content::Number { value: plain(word), decimals, points }
            }
            Value::Expression => Content::Expression(as_written(word.span.of(self.text))),
        }
    }

    /// The macro statement, if the block is one.
    fn statement(&self) -> Option<Vec<u8>> {
        let block = self.block;
        if block.kind != BlockKind::Macro {
            return None;
        }
        let whole = Span { start: block.statement, end: block.statement_end };
        let (mut read, mut from) = (Vec::new(), whole.start);
        for span in self.left_out.iter().filter(|span| whole.contains(**span)) {
            read.extend(as_written(Span { start: from, end: span.start }.of(self.text)));
            from = span.end;
        }
        read.extend(as_written(Span { start: from, end: whole.end }.of(self.text)));
        Some(read)
    }
}

/// A text in capitals and without blanks.
fn as_written(bytes: &[u8]) -> Vec<u8> {
    bytes.iter().filter(|byte| !is_blank(**byte)).map(u8::to_ascii_uppercase).collect()
}

fn leads_to_same(first: &Target, second: &Target) -> bool {
    match (first, second) {
        (Target::Blocks { reached: first, .. }, Target::Blocks { reached: second, .. }) => first == second,
        _ => first == second,
    }
}
