//! Finds all uses of a number: a sequence number, a program, a variable.
//!
//! In: the text, a place in it. Out: the positions, in text order. Only lines that may contain the number are
//! parsed, so that a long program is searched quickly. Does not need a run.

use std::ops::Range;

use memchr::{memchr, memchr3};

use super::names::{Computed, Name, Named, computed, names};
use crate::setup::dialect::CodeList;
use crate::source::{Span, line_around};
use crate::text::block::Block;
use crate::text::lexer::is_blank;
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
    let digits = name.number().to_string().into_bytes();
    let number = |from| {
        let is_meant =
            |at: usize| text[at..].starts_with(&digits) && may_be_a_name(text, at..at + digits.len());
        first_where(text, from, |rest| memchr(digits[0], rest), is_meant)
    };
    let with_name = match name {
        Name::Program(number) if program_name::is_name(number) => lines(text, |_| None),
        _ => lines(text, number),
    };
    let (mut found, mut programs) = (Vec::new(), ProgramCount::new(text));
    for line in with_name {
        read_line(text, line, codes, |named, block| {
            let program = programs.index_of(text, block);
            found.extend(named.into_iter().filter(|named| named.name == name).map(|named| (named, program)));
        });
    }
    found
}

/// The first target of a reference that the program computes and that `is_meant` accepts with the index of its
/// program.
pub fn first_computed(
    text: &[u8],
    codes: CodeList,
    is_meant: impl Fn(&Computed, u32) -> bool,
) -> Option<Computed> {
    // A variable, an expression, a jump, or a P or Q that is not a plain number.
    let may_refer = |byte: &u8| matches!(byte, b'#' | b'[' | b'P' | b'p' | b'Q' | b'q' | b'T' | b't');
    let reference = |from| first_where(text, from, |rest| rest.iter().position(may_refer), |_| true);
    let mut programs = ProgramCount::new(text);
    lines(text, reference).find_map(|line| {
        let mut first = None;
        blocks(text, line, |block| {
            let program = programs.index_of(text, block);
            let found = || computed(text, block, codes).into_iter().find(|found| is_meant(found, program));
            first = first.or_else(found);
        });
        first
    })
}

/// Counts the programs of a text. Blocks may be left out if they begin no program.
struct ProgramCount {
    /// The first letter or digit of the text.
    first: usize,
    index: u32,
    has_begun: bool,
}

impl ProgramCount {
    fn new(text: &[u8]) -> Self {
        let first = text.iter().position(u8::is_ascii_alphanumeric).unwrap_or(text.len());
        Self { first, index: 0, has_begun: false }
    }

    /// The index of the program of the next block. The first program of a text may lack a head.
    fn index_of(&mut self, text: &[u8], block: &Block) -> u32 {
        let is_later = || self.first < line_around(text, block.span.start as usize).start as usize;
        let begins = block.program.is_some();
        if begins && (self.has_begun || is_later()) {
            self.index += 1;
        }
        self.has_begun |= begins || !block.is_empty();
        self.index
    }
}

/// The lines that may begin a program, and those with a byte found by `next`, a search from a byte on; in text order.
fn lines<'a>(
    text: &'a [u8],
    next: impl FnMut(usize) -> Option<usize> + 'a,
) -> Box<dyn Iterator<Item = Span> + 'a> {
    // `O1`, `:1` (an older form of it), `<NAME>`; a name may also follow a number or M98.
    let is_head = move |at| begins_block(text, at);
    let heads = move |from| first_where(text, from, |rest| memchr3(b'O', b'o', b':', rest), is_head);
    let names = move |from| first_where(text, from, |rest| memchr(b'<', rest), |_| true);
    let mut searches = [Search::new(heads), Search::new(names), Search::new(next)];
    let mut from = 0;
    Box::new(std::iter::from_fn(move || {
        let byte = searches.iter_mut().filter_map(|search| search.first(from)).min()?;
        let line = line_around(text, byte);
        from = line.end as usize + 1;
        Some(line)
    }))
}

/// A search through a text, which keeps the byte that it has found.
struct Search<'a> {
    next: Box<dyn FnMut(usize) -> Option<usize> + 'a>,
    found: Option<usize>,
}

impl<'a> Search<'a> {
    fn new(mut next: impl FnMut(usize) -> Option<usize> + 'a) -> Self {
        let found = next(0);
        Self { next: Box::new(next), found }
    }

    /// The first byte from `from` on. `from` never decreases.
    fn first(&mut self, from: usize) -> Option<usize> {
        if self.found.is_some_and(|found| found < from) {
            self.found = (self.next)(from);
        }
        self.found
    }
}

/// The first byte from `from` on that `find` finds and `is_meant` accepts.
fn first_where(
    text: &[u8],
    from: usize,
    find: impl Fn(&[u8]) -> Option<usize>,
    is_meant: impl Fn(usize) -> bool,
) -> Option<usize> {
    let mut at = from;
    loop {
        at += find(text.get(at..)?)?;
        if is_meant(at) {
            return Some(at);
        }
        at += 1;
    }
}

/// Passes the blocks of a line to `take`, with the names in each.
fn read_line(text: &[u8], line: Span, codes: CodeList, mut take: impl FnMut(Vec<Named>, &Block)) {
    blocks(text, line, |block| take(names(text, block, codes), block));
}

/// Passes the blocks of a line to `take`.
fn blocks(text: &[u8], line: Span, mut take: impl FnMut(&Block)) {
    let mut parser = Parser::resume(&text[..line.end as usize], Resume::inside(line.start, 0));
    let mut block = Block::default();
    while parser.next_block(&mut block) {
        take(&block);
    }
}

/// Whether a program number may begin at a byte: there is nothing before it in its block but blanks, `%`, comments and
/// a slash with its level.
fn begins_block(text: &[u8], byte: usize) -> bool {
    let mut before = text[..byte].iter().rev().skip_while(|byte| is_blank(**byte) || **byte == b'%');
    match before.next() {
        None | Some(b'\n' | b'\r' | b';' | b')' | b'/') => true,
        Some(b'1'..=b'9') => before.next() == Some(&b'/'),
        Some(_) => false,
    }
}

/// Whether digits end a number that N, O, P, Q, GOTO, `:` or `#` may precede: not that of another address, and
/// not a fraction.
fn may_be_a_name(text: &[u8], digits: Range<usize>) -> bool {
    let is_end = || !text.get(digits.end).is_some_and(u8::is_ascii_digit);
    let before = || {
        let number = text[..digits.start].iter().rev().skip_while(|byte| byte.is_ascii_digit());
        number.copied().find(|byte| !matches!(byte, b' ' | b'\t'))
    };
    is_end()
        && before().is_none_or(|byte| match byte.to_ascii_uppercase() {
            b'N' | b'O' | b'P' | b'Q' => true,
            // `.0` is the number 0.
            b'.' => text[digits.clone()] == *b"0",
            byte => !byte.is_ascii_uppercase(),
        })
}
