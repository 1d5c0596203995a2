//! Finds all uses of a number: a sequence number, a program, a variable.
//!
//! In: the text, a place in it. Out: the positions, in text order. Only lines that contain the digits are
//! parsed, so that a long program is searched quickly. Does not need a run.

use super::names::{Name, Named, names};
use crate::setup::dialect::CodeList;
use crate::source::{Span, line_around};
use crate::text::block::Block;
use crate::text::parser::{Parser, Resume};
use crate::text::program_name;

/// Maximum number of positions in the list.
const MAX_USES: usize = 500;
/// First number of the common variables, which all programs share.
const FIRST_COMMON: u32 = 100;

/// The uses of a number.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Uses {
    /// The name that the number belongs to.
    pub name: Name,
    /// The positions, in text order.
    pub places: Vec<Named>,
    /// Index of the position to go to from the given one: from a reference to a block or a program to its
    /// definition, otherwise to the next use.
    pub next: usize,
    /// Whether there are more uses.
    pub is_cut: bool,
}

/// The uses of the number at a byte, or of the number that ends there; `None` if there is no number.
pub fn uses(text: &[u8], codes: CodeList, byte: u32) -> Option<Uses> {
    let own = name_at(text, codes, byte)?;
    let found = all(text, codes, own.name);
    let program = found.iter().find(|(named, _)| named.span == own.span).map(|&(_, program)| program)?;
    let is_local = is_local(own.name);
    let mut places: Vec<Named> = found
        .into_iter()
        .filter(|(named, of)| {
            !is_local || *of == program || named.scope.is_elsewhere() || own.scope.is_elsewhere()
        })
        .map(|(named, _)| named)
        .collect();
    let is_cut = places.len() > MAX_USES;
    let at = places.iter().position(|named| named.span == own.span)?;
    let (first, at) = if at < MAX_USES { (0, at) } else { (at + 1 - MAX_USES, MAX_USES - 1) };
    places.drain(..first);
    places.truncate(MAX_USES);
    let following = (at + 1..places.len()).chain(0..at);
    let names_another = !own.defines && !matches!(own.name, Name::Variable(_));
    let next = following.clone().find(|&index| !names_another || places[index].defines);
    Some(Uses { name: own.name, next: next.or(following.clone().next()).unwrap_or(at), places, is_cut })
}

/// The number at a byte, or the number that ends there.
pub fn name_at(text: &[u8], codes: CodeList, byte: u32) -> Option<Named> {
    let mut own = None;
    read_line(text, line_around(text, byte as usize), codes, |named, _| {
        own = own.or(named.iter().find(|named| named.span.start <= byte && byte <= named.span.end).copied());
    });
    own
}

/// Whether a name belongs to its program: all programs share the others.
pub fn is_local(name: Name) -> bool {
    match name {
        Name::Sequence(_) => true,
        Name::Program(_) => false,
        Name::Variable(number) => number < FIRST_COMMON,
    }
}

/// All positions of a name, each with the index of its program in the text, from 0.
pub fn all(text: &[u8], codes: CodeList, name: Name) -> Vec<(Named, u32)> {
    let digits = name.number().to_string();
    let names_program = matches!(name, Name::Program(number) if program_name::is_name(number));
    let (mut found, mut programs) = (Vec::new(), ProgramCount::new(text));
    let mut start = 0;
    while start < text.len() {
        let line = line_around(text, start);
        let own = line.of(text);
        let may_use = if names_program { own.contains(&b'<') } else { ends_a_number(own, digits.as_bytes()) };
        if may_begin_a_program(own) || may_use {
            read_line(text, line, codes, |named, block| {
                let program = programs.index_of(text, block);
                found.extend(
                    named.into_iter().filter(|named| named.name == name).map(|named| (named, program)),
                );
            });
        }
        start = line.end as usize + 1;
    }
    found
}

/// Counts the programs of a text. Blocks may be left out if they begin no program.
pub(super) struct ProgramCount {
    /// The first letter or digit of the text.
    first: usize,
    index: u32,
    has_begun: bool,
}

impl ProgramCount {
    pub(super) fn new(text: &[u8]) -> Self {
        let first = text.iter().position(u8::is_ascii_alphanumeric).unwrap_or(text.len());
        Self { first, index: 0, has_begun: false }
    }

    /// The index of the program of the next block. The first program of a text may lack a head.
    pub(super) fn index_of(&mut self, text: &[u8], block: &Block) -> u32 {
        let is_later = || self.first < line_around(text, block.span.start as usize).start as usize;
        let begins = block.program.is_some();
        if begins && (self.has_begun || is_later()) {
            self.index += 1;
        }
        self.has_begun |= begins || !block.is_empty();
        self.index
    }
}

/// Passes the blocks of a line to `take`, with the names in each.
fn read_line(text: &[u8], line: Span, codes: CodeList, mut take: impl FnMut(Vec<Named>, &Block)) {
    let mut parser = Parser::resume(&text[..line.end as usize], Resume::inside(line.start, 0));
    let mut block = Block::default();
    while parser.next_block(&mut block) {
        take(names(text, &block, codes), &block);
    }
}

/// Whether a block of the line may begin with O, a colon (an older form of O), or a program name.
fn may_begin_a_program(line: &[u8]) -> bool {
    line.split(|&byte| byte == b';').any(|block| {
        let first = block.iter().find(|byte| !matches!(byte, b' ' | b'\t' | b'%'));
        first.is_some_and(|byte| matches!(byte, b'O' | b'o' | b':' | b'<'))
    })
}

/// Whether a number in the line ends with these digits.
fn ends_a_number(line: &[u8], digits: &[u8]) -> bool {
    let last = digits.len() - 1;
    line.windows(digits.len()).enumerate().any(|(at, window)| {
        window[last] == digits[last]
            && window == digits
            && !line.get(at + digits.len()).is_some_and(u8::is_ascii_digit)
    })
}
