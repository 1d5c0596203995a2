//! The G and M codes of a check, and those that a program uses.
//!
//! In: a list such as `G71, G70`; a program that has run, with its trace. Out: codes in the spelling of FANUC's system A.

use std::collections::{BTreeMap, BTreeSet};

use super::fault::{Part, Problem, ReadError, at_most};
use crate::control::codes::{g_code, g_codes};
use crate::run::Analysis;
use crate::setup::dialect::CodeList;
use crate::source::Span;
use crate::text::block::{Block, Value, Word};
use crate::text::lexer::Number;
use crate::text::parser::{Parser, Resume};

/// Most codes of one check.
const MOST: usize = 20;
/// Most bytes of blocks that are searched for codes; a cycle reads its contour again with each call.
const MOST_BYTES: usize = 1 << 20;

/// Reads a list of codes.
pub(super) fn read(key: &'static str, value: &str, line: usize) -> Result<Vec<String>, ReadError> {
    let mut found = Vec::new();
    for text in value.split(',') {
        let code = code(text.trim());
        let code = code.ok_or(ReadError::at(line, Problem::Value { key, expected: "G71, G70, M08" }))?;
        if !found.contains(&code) {
            found.push(code);
        }
        at_most(Part::Codes, found.len(), MOST, line)?;
    }
    Ok(found)
}

/// A code as it is written in a check.
fn code(text: &str) -> Option<String> {
    let (letter, digits) = (text.bytes().next()?.to_ascii_uppercase(), text.get(1..)?);
    let fits = |byte: u8| byte.is_ascii_digit() || byte == b'.';
    let is_number = (1..=5).contains(&digits.len()) && digits.bytes().all(fits);
    spelled(letter, Number::read(digits.as_bytes()), CodeList::A).filter(|_| is_number)
}

/// The spelling of a code in system A; of a code that only other systems have, its own spelling.
fn spelled(letter: u8, number: Number, list: CodeList) -> Option<String> {
    match letter {
        b'G' => {
            let key = number.tenths()?;
            let own = g_code(key, list);
            let same = g_codes(CodeList::A).find(|(_, code)| own.is_some_and(|own| std::ptr::eq(own, *code)));
            Some(same.map_or_else(|| plain('G', key), |(text, _)| text))
        }
        b'M' => Some(plain('M', number.tenths()?)),
        _ => None,
    }
}

fn plain(letter: char, tenths: u64) -> String {
    let decimal = if tenths.is_multiple_of(10) { String::new() } else { format!(".{}", tenths % 10) };
    format!("{letter}{:02}{decimal}", tenths / 10)
}

/// The codes of the executed blocks, sorted. Blocks of a contour that a cycle reads belong to them.
pub(super) fn used(text: &[u8], analysis: &Analysis) -> Vec<String> {
    let mut found = BTreeSet::new();
    each_block(text, analysis, |block| {
        let codes = block.words.iter().filter_map(|word| code_of(word, analysis.codes));
        found.extend(codes);
    });
    found.into_iter().collect()
}

/// The code of a word.
fn code_of(word: &Word, list: CodeList) -> Option<String> {
    match word.value {
        Value::Number { number, negative: false } => spelled(word.address, number, list),
        Value::Number { .. } | Value::Expression => None,
    }
}

/// Calls a function with each executed block, in the order of the text, including the blocks of contours.
pub(super) fn each_block(text: &[u8], analysis: &Analysis, mut call: impl FnMut(&Block)) {
    let mut ranges: BTreeMap<u32, (Resume, u32)> = BTreeMap::new();
    for own in &analysis.trace {
        let range = ranges.entry(own.at.byte).or_insert((own.at, own.passed));
        range.1 = range.1.max(own.passed);
    }
    let (mut block, mut left, mut read) = (Block::default(), MOST_BYTES, 0);
    for (start, (at, end)) in ranges {
        let from = start.max(read);
        let mut parser = Parser::resume(text, at);
        while parser.position().byte < end && left > 0 && parser.next_block(&mut block) {
            left = left.saturating_sub(block.span.len() + 1);
            if block.span.start >= from {
                call(&block);
            }
        }
        read = read.max(end);
    }
}

/// The first executed block with a code.
pub(super) fn place_of(code: &str, text: &[u8], analysis: &Analysis) -> Option<Span> {
    let mut found = None;
    each_block(text, analysis, |block| {
        let mut words = block.words.iter();
        let word = words.find(|word| code_of(word, analysis.codes).is_some_and(|own| own == code));
        found = found.or(word.map(|word| word.span));
    });
    found
}
