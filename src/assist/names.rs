//! Finds numbers that identify blocks and values (N, O, #), and the words that refer to them.
//!
//! In: a block. Out: the numbers it defines or refers to. Does not need a run.

use super::form::{g_of, m_of};
use crate::control::codes::{G, M, Multiple};
use crate::control::program::program_and_repeats;
use crate::control::words::plain;
use crate::setup::dialect::CodeList;
use crate::source::Span;
use crate::text::block::{Block, BlockKind, Value};
use crate::text::highlight::sequence_span;

/// A number that identifies a block, a program or a variable.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Name {
    /// A block of the same program: `N10`.
    Sequence(u32),
    /// A program: `O1000`.
    Program(u32),
    /// A variable: `#100`.
    Variable(u32),
}

impl Name {
    /// The number.
    pub fn number(self) -> u32 {
        match self {
            Self::Sequence(number) | Self::Program(number) | Self::Variable(number) => number,
        }
    }
}

/// An occurrence of a name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Named {
    /// The name.
    pub name: Name,
    /// Span of the word, or of the variable.
    pub span: Span,
    /// Whether it is the definition: `N10` itself, or a variable that is assigned.
    pub defines: bool,
    /// Whether the block may be in another program: M99 P refers to a block of the caller.
    pub anywhere: bool,
}

/// The names in a block, in text order.
pub fn names(text: &[u8], block: &Block, codes: CodeList) -> Vec<Named> {
    let mut found = Vec::new();
    let own = |name, span| Named { name, span, defines: true, anywhere: false };
    let heads = block.program.into_iter().chain(block.second_name);
    found.extend(heads.map(|(number, span)| own(Name::Program(number), span)));
    let sequence = block.sequence.and_then(|number| {
        let span = sequence_span(text, block.span.start as usize, block.span.end as usize)?;
        Some(own(Name::Sequence(number), span))
    });
    found.extend(sequence);
    match block.kind {
        BlockKind::Macro => {
            let statement = block.words_span();
            found.extend(jump(text, statement));
            variables(text, statement, true, &mut found);
        }
        _ => {
            words(block, codes, &mut found);
            for word in block.words.iter().filter(|word| word.value == Value::Expression) {
                variables(text, word.span, false, &mut found);
            }
        }
    }
    found
}

/// The blocks and programs that words refer to.
fn words(block: &Block, codes: CodeList, found: &mut Vec<Named>) {
    #[derive(Clone, Copy)]
    enum By {
        Contour,
        Program,
        Block,
        Return,
    }
    let by = block.words.iter().find_map(|word| match (g_of(word, codes), m_of(word)) {
        (Some(G::Multiple(cycle)), _) if cycle.is_roughing() || cycle == Multiple::Finishing => {
            Some(By::Contour)
        }
        (Some(G::MacroCall(_)), _) | (_, Some(M::Call)) => Some(By::Program),
        (_, Some(M::LocalCall)) => Some(By::Block),
        (_, Some(M::Return)) => Some(By::Return),
        _ => None,
    });
    let Some(by) = by else { return };
    for word in &block.words {
        let Some(number) = plain(word).filter(|number| *number >= 0.0 && number.fract() == 0.0) else {
            continue;
        };
        let name = match (by, word.address) {
            (By::Contour, b'P' | b'Q') | (By::Block | By::Return, b'P') => Name::Sequence(number as u32),
            (By::Program, b'P') => Name::Program(program_and_repeats(number as u64).0),
            _ => continue,
        };
        let anywhere = matches!(by, By::Return);
        found.push(Named { name, span: word.span, defines: false, anywhere });
    }
}

/// The target of GOTO.
fn jump(text: &[u8], statement: Span) -> Option<Named> {
    let upper = statement.of(text).to_ascii_uppercase();
    let at = upper.windows(4).position(|four| four == b"GOTO")? + 4;
    let (number, span) = number_after(text, statement.start as usize + at, b" \tNn")?;
    Some(Named { name: Name::Sequence(number), span, defines: false, anywhere: false })
}

/// The variables in a statement or an expression; `statement`: the first one may be assigned.
fn variables(text: &[u8], within: Span, statement: bool, found: &mut Vec<Named>) {
    let (start, end) = (within.start as usize, (within.end as usize).min(text.len()));
    for hash in (start..end).filter(|&at| text[at] == b'#') {
        let Some((number, digits)) = number_after(text, hash + 1, b"") else { continue };
        let after = text[digits.end as usize..end].iter().find(|byte| !matches!(byte, b' ' | b'\t'));
        let defines = statement && hash == start && after == Some(&b'=');
        let span = Span::new(hash, digits.end as usize);
        found.push(Named { name: Name::Variable(number), span, defines, anywhere: false });
    }
}

/// The integer at a byte, after any `skipped` characters, and its span.
pub fn number_after(text: &[u8], at: usize, skipped: &[u8]) -> Option<(u32, Span)> {
    let at = at + text.get(at..)?.iter().take_while(|byte| skipped.contains(byte)).count();
    let count = text[at..].iter().take_while(|byte| byte.is_ascii_digit()).count();
    let number = std::str::from_utf8(&text[at..at + count]).ok()?.parse().ok()?;
    Some((number, Span::new(at, at + count)))
}
