//! Normalises blocks for comparison. N numbers, white space and case do not count; in blocks without errors
//! and macro expressions the format of numbers does not count either.
//!
//! In: a text. Out: its blocks, each with the index of its [`Keys`] entry: blocks with the same index have
//! the same normalised text. Comments are compared word by word, with their case; blank lines are left out.
//! Must not know the meaning of a word.

use std::collections::HashMap;
use std::rc::Rc;

use super::Place;
use crate::source::Span;
use crate::text::block::{Block, BlockKind, Value, Word};
use crate::text::lexer::Number;
use crate::text::parser::Parser;

/// Whether `X50` and `X50.` are different.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Points {
    /// They are different: without a point, `X50` is a thousandth of `X50.`.
    Count,
    /// They are the same.
    Aside,
}

/// Separator between the words of a key; no word contains it.
const SEPARATOR: u8 = 0;

/// The distinct normalised blocks of both texts. A key is the list of the words of a block, separated by
/// [`SEPARATOR`].
#[derive(Default)]
pub(super) struct Keys {
    /// The index of each key in `keys`.
    indices: HashMap<Rc<[u8]>, u32>,
    keys: Vec<Rc<[u8]>>,
}

impl Keys {
    fn index(&mut self, key: &[u8]) -> u32 {
        if let Some(&index) = self.indices.get(key) {
            return index;
        }
        let index = self.keys.len() as u32;
        let key = Rc::<[u8]>::from(key);
        self.indices.insert(Rc::clone(&key), index);
        self.keys.push(key);
        index
    }

    /// The words of a block.
    pub(super) fn words(&self, index: u32) -> impl Iterator<Item = &[u8]> + Clone {
        self.keys[index as usize].split(|&byte| byte == SEPARATOR).filter(|word| !word.is_empty())
    }
}

/// The blocks of a text.
pub(super) struct Written {
    places: Vec<Place>,
    /// Index of the key of each block.
    pub(super) numbers: Vec<u32>,
    /// Block of each N number.
    sequences: HashMap<u32, usize>,
}

impl Written {
    /// Number of blocks.
    pub(super) fn len(&self) -> usize {
        self.places.len()
    }

    /// Position of a block.
    pub(super) fn place(&self, block: usize) -> Place {
        self.places[block]
    }

    /// The block that contains a byte; `None` before the first.
    pub(super) fn block_at(&self, byte: u32) -> Option<usize> {
        self.places.partition_point(|place| place.span.start <= byte).checked_sub(1)
    }

    /// The first block with an N number.
    pub(super) fn sequence(&self, number: u32) -> Option<usize> {
        self.sequences.get(&number).copied()
    }
}

/// Reads the blocks of a text.
pub(super) fn written(text: &[u8], points: Points, keys: &mut Keys) -> Written {
    let mut parser = Parser::new(text);
    let mut block = Block::default();
    let mut all = Written { places: Vec::new(), numbers: Vec::new(), sequences: HashMap::new() };
    let mut key = Vec::new();
    while parser.next_block(&mut block) {
        write_key(text, &block, points, &mut key);
        if key.is_empty() && block.sequence.is_none() {
            continue;
        }
        if let Some(number) = block.sequence {
            all.sequences.entry(number).or_insert(all.places.len());
        }
        all.places.push(Place { span: block.span, line: block.line });
        all.numbers.push(keys.index(&key));
    }
    all
}

fn write_key(text: &[u8], block: &Block, points: Points, key: &mut Vec<u8>) {
    key.clear();
    let is_plain = block.faults.is_empty() && !block.is_overlong() && !block.has_expressions;
    match block.kind {
        BlockKind::Percent => key.push(b'%'),
        BlockKind::Words if is_plain => write_words(block, points, key),
        BlockKind::Words | BlockKind::Macro => write_raw(text, block, key),
    }
    for comment in &block.comments {
        key.push(SEPARATOR);
        let words = comment.of(text).split(u8::is_ascii_whitespace).filter(|word| !word.is_empty());
        for (index, word) in words.enumerate() {
            if index > 0 {
                key.push(b' ');
            }
            key.extend(word.iter().filter(|&&byte| byte != SEPARATOR));
        }
    }
}

fn write_words(block: &Block, points: Points, key: &mut Vec<u8>) {
    if let Some(level) = block.delete {
        key.extend([b'/', b'0' + level % 10, SEPARATOR]);
    }
    // `O1234<NAME>` has a number and a name.
    for (number, _) in block.program.into_iter().chain(block.second_name) {
        key.push(b'O');
        key.extend(number.to_string().bytes());
        key.push(SEPARATOR);
    }
    for (index, word) in block.words.iter().enumerate() {
        if let Some((_, level)) = block.optional.filter(|(first, _)| *first == index) {
            key.extend([b'/', b'0' + level % 10, SEPARATOR]);
        }
        write_word(word, points, key);
        key.push(SEPARATOR);
    }
}

fn write_word(word: &Word, points: Points, key: &mut Vec<u8>) {
    if word.comma {
        key.push(b',');
    }
    key.push(word.address);
    let Value::Number { number, negative } = word.value else { return };
    let Number { mut mantissa, mut decimals, .. } = number;
    while decimals > 0 && mantissa % 10 == 0 {
        (mantissa, decimals) = (mantissa / 10, decimals - 1);
    }
    if negative && mantissa > 0 {
        key.push(b'-');
    }
    key.extend(mantissa.to_string().bytes());
    // `12.5` is `125e1`.
    if decimals > 0 {
        key.push(b'e');
        key.extend(decimals.to_string().bytes());
    }
    // A decimal point does not change the value of a code, a tool or a speed.
    let ignores_point = matches!(word.address, b'G' | b'M' | b'T' | b'S');
    if points == Points::Count && number.has_point() && !ignores_point {
        key.push(b'.');
    }
}

/// Writes the key of a block that is not a list of plain words: its characters without white space, N number
/// and comments.
fn write_raw(text: &[u8], block: &Block, key: &mut Vec<u8>) {
    let mut at = block.span.start;
    for comment in &block.comments {
        push_raw(Span { start: at, end: comment.start.max(at) }.of(text), key);
        at = comment.end.max(at);
    }
    push_raw(Span { start: at, end: block.span.end.max(at) }.of(text), key);
    if block.sequence.is_some() {
        let digits = |byte: &u8| byte.is_ascii_digit();
        let slashes = key.iter().take_while(|&&byte| byte == b'/' || byte.is_ascii_digit()).count();
        if key.get(slashes) == Some(&b'N') {
            let number = key[slashes + 1..].iter().take_while(|byte| digits(byte)).count();
            key.drain(slashes..slashes + 1 + number);
        }
    }
}

fn push_raw(text: &[u8], key: &mut Vec<u8>) {
    let counts = |byte: &&u8| !byte.is_ascii_whitespace() && **byte != SEPARATOR && **byte != b';';
    key.extend(text.iter().filter(counts).map(u8::to_ascii_uppercase));
}
