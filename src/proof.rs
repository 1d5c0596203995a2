//! Whether a changed text is still the same program.
//!
//! In: a text, the changed text and the setup. Out: the first [`Difference`]. Compared are: each block as read,
//! apart from its sequence number and the numbers that refer to blocks; the block that each reference leads to,
//! also where it is never executed; the motions and the codes of the messages, with block skip off and on. Must
//! not know what was changed, or why.

use crate::assist::names::{Name, Named, names};
use crate::control::words::plain;
use crate::message::{Diagnostic, Edit, applied, said};
use crate::references::{References, Target};
use crate::run::{Analysis, analyze};
use crate::sentences::Language;
use crate::setup::Setup;
use crate::setup::dialect::CodeList;
use crate::source::Span;
use crate::text::block::{Block, BlockKind, Value};
use crate::text::lexer::is_blank;
use crate::text::parser::Parser;

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

/// The first difference that edits make; `None` if the program stays the same.
pub fn difference_by(edits: &[Edit], text: &[u8], setup: &Setup) -> Option<Difference> {
    if edits.is_empty() { None } else { difference(text, &applied(text, edits), setup) }
}

/// The first difference; `None` if both texts are the same program.
pub fn difference(before: &[u8], after: &[u8], setup: &Setup) -> Option<Difference> {
    let mut codes = None;
    for block_skip in switches(before, setup) {
        let setup = Setup { block_skip, ..setup.clone() };
        let runs = [before, after].map(|text| analyze(text, &setup));
        if runs[0].diagnostics.iter().any(is_for_other_control) {
            return Some(Difference::OtherControl);
        }
        if let Some(found) = difference_of_runs(&runs) {
            return Some(found);
        }
        codes = Some(runs[0].codes);
    }
    let codes = codes.unwrap_or_default();
    difference_of_blocks(before, after, codes)
        .or_else(|| difference_of_references(before, after, codes, setup))
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

fn difference_of_runs([before, after]: &[Analysis; 2]) -> Option<Difference> {
    let stops = |run: &Analysis| -> Vec<_> {
        run.motions.stops(0..run.motions.len() + 1).map(|(index, stop)| (index, stop.kind)).collect()
    };
    let other = before.motions.iter().zip(after.motions.iter()).position(|(one, other)| one != other);
    let is_same = before.codes == after.codes
        && before.unit == after.unit
        && before.motions.len() == after.motions.len()
        && stops(before) == stops(after);
    let messages =
        |run: &Analysis| -> Vec<String> { run.diagnostics.iter().map(|told| told.code()).collect() };
    match other {
        Some(index) => Some(Difference::Motions(before.motions.span(index))),
        None if !is_same => Some(Difference::Motions(Span::default())),
        None if messages(before) != messages(after) => Some(Difference::Messages),
        None => None,
    }
}

fn difference_of_blocks(before: &[u8], after: &[u8], codes: CodeList) -> Option<Difference> {
    let mut parsers = [Parser::new(before), Parser::new(after)];
    let mut blocks = [Block::default(), Block::default()];
    loop {
        let [first, second] = &mut parsers;
        let left = [first.next_block(&mut blocks[0]), second.next_block(&mut blocks[1])];
        if left == [false, false] {
            return None;
        }
        let as_read = [as_read(before, &blocks[0], codes), as_read(after, &blocks[1], codes)];
        // After its last block, a text reads as empty blocks: an empty last line makes no difference.
        if as_read[0] != as_read[1] {
            return Some(Difference::Block(blocks[0].span));
        }
    }
}

/// A block as a control reads it, without the numbers of blocks.
fn as_read(text: &[u8], block: &Block, codes: CodeList) -> Vec<u8> {
    let named = names(text, block, codes);
    let is_reference = |named: &&Named| !named.defines && matches!(named.name, Name::Sequence(_));
    let references = || named.iter().filter(is_reference).map(|named| named.span);
    let mut read =
        format!("{:?} {:?} {:?} {:?}", block.kind, block.delete, block.optional, block.is_overlong());
    let heads = block.program.iter().chain(&block.second_name);
    read.extend(heads.map(|(number, _)| format!(" O{number}")));
    read.extend(block.faults.iter().map(|fault| format!(" !{}", fault.message.slug())));
    let mut read = read.into_bytes();
    for word in &block.words {
        read.extend([b' ', if word.comma { b',' } else { b' ' }, word.address]);
        match word.value {
            _ if references().any(|span| span == word.span) => {}
            Value::Number { number, .. } => {
                let value = plain(word).unwrap_or_default();
                read.extend(format!("{value} {} {}", number.decimals, number.points).into_bytes());
            }
            Value::Expression => read.extend(as_written(word.span.of(text))),
        }
    }
    for comment in &block.comments {
        read.push(b' ');
        read.extend(comment.of(text));
    }
    if block.kind == BlockKind::Macro {
        read.push(b' ');
        read.extend(statement(text, block, references()));
    }
    read
}

/// A macro statement without its references to blocks, which are in text order.
fn statement(text: &[u8], block: &Block, references: impl Iterator<Item = Span>) -> Vec<u8> {
    let whole = Span { start: block.statement, end: block.statement_end };
    let (mut read, mut from) = (Vec::new(), whole.start);
    for reference in references.filter(|reference| whole.contains(*reference)) {
        read.extend(as_written(Span { start: from, end: reference.start }.of(text)));
        from = reference.end;
    }
    read.extend(as_written(Span { start: from, end: whole.end }.of(text)));
    read
}

/// A text in capitals and without blanks.
fn as_written(bytes: &[u8]) -> Vec<u8> {
    bytes.iter().filter(|byte| !is_blank(**byte)).map(u8::to_ascii_uppercase).collect()
}

fn difference_of_references(
    before: &[u8],
    after: &[u8],
    codes: CodeList,
    setup: &Setup,
) -> Option<Difference> {
    let control = setup.dialect.control.unwrap_or_default();
    let [first, second] = [before, after].map(|text| References::of(text, codes, control).references);
    let is_same = |index: usize| {
        let (first, second) = (first.get(index), second.get(index));
        first.zip(second).is_some_and(|(first, second)| {
            first.block == second.block && leads_to_same(&first.target, &second.target)
        })
    };
    let at = (0..first.len().max(second.len())).find(|index| !is_same(*index))?;
    Some(Difference::Reference(first.get(at).map_or(Span::default(), |reference| reference.span)))
}

fn leads_to_same(first: &Target, second: &Target) -> bool {
    match (first, second) {
        (Target::Blocks { reached: first, .. }, Target::Blocks { reached: second, .. }) => first == second,
        _ => first == second,
    }
}
