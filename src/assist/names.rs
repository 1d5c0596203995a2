//! Finds numbers that identify blocks and values (N, O, #), and the words that refer to them.
//!
//! In: a block. Out: the numbers it defines or refers to. Does not need a run.

use super::form::{g_of, m_of};
use crate::control::codes::{self, G, M, Multiple};
use crate::control::program::program_and_repeats;
use crate::control::words::plain;
use crate::setup::dialect::CodeList;
use crate::source::Span;
use crate::text::block::{Block, BlockKind, Value, Word};
use crate::text::highlight::sequence_span;
use crate::text::parser::{Parser, Resume};

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
    /// What it belongs to.
    pub fn kind(self) -> Kind {
        match self {
            Self::Sequence(_) => Kind::Sequence,
            Self::Program(_) => Kind::Program,
            Self::Variable(_) => Kind::Variable,
        }
    }

    /// The number.
    pub fn number(self) -> u32 {
        match self {
            Self::Sequence(number) | Self::Program(number) | Self::Variable(number) => number,
        }
    }
}

/// What a name belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A block.
    Sequence,
    /// A program.
    Program,
    /// A variable.
    Variable,
}

/// The program that contains the block of a reference.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scope {
    /// The program of the reference.
    Own,
    /// M99 P: the program that calls this one; the program of the reference if none calls it.
    Caller,
    /// M98 P Q: the called program, by the value of P.
    Called(u32),
}

impl Scope {
    /// Whether the block may be in another program.
    pub fn is_elsewhere(self) -> bool {
        self != Self::Own
    }
}

/// A target whose number the program computes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Computed {
    /// What the number belongs to.
    pub kind: Kind,
    /// The word, the statement or the variable.
    pub span: Span,
    /// For a reference to a block: where the block is.
    pub scope: Scope,
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
    /// For a reference to a block: where the block is.
    pub scope: Scope,
}

/// The names in a block, in text order.
pub fn names(text: &[u8], block: &Block, codes: CodeList) -> Vec<Named> {
    let mut found = Vec::new();
    let own = |name, span| Named { name, span, defines: true, scope: Scope::Own };
    let heads = block.program.into_iter().chain(block.second_name);
    found.extend(heads.map(|(number, span)| own(Name::Program(number), span)));
    let sequence = block.sequence.zip(sequence_span(text, block));
    found.extend(sequence.map(|(number, span)| own(Name::Sequence(number), span)));
    found.extend(references(text, block, codes).iter().filter_map(Reference::named));
    match block.kind {
        BlockKind::Macro => variables(text, block.words_span(), true, &mut found),
        _ => {
            for word in block.words.iter().filter(|word| word.value == Value::Expression) {
                variables(text, word.span, false, &mut found);
            }
        }
    }
    found
}

/// The targets that a block computes: `GOTO #1`, `M98 P#2`, `#[#3]`.
pub fn computed(text: &[u8], block: &Block, codes: CodeList) -> Vec<Computed> {
    let found = references(text, block, codes).into_iter().filter(|reference| reference.name.is_none());
    let found = found.map(|Reference { kind, span, scope, .. }| Computed { kind, span, scope });
    found.chain(computed_variable(text, block.words_span())).collect()
}

/// The first variable in a statement or in words whose number is computed.
fn computed_variable(text: &[u8], within: Span) -> Option<Computed> {
    let is_computed = |pair: &[u8]| matches!(pair, b"##" | b"#[");
    let at = within.start as usize + within.of(text).windows(2).position(is_computed)?;
    Some(Computed { kind: Kind::Variable, span: Span::new(at, at + 2), scope: Scope::Own })
}

/// The programs that a block calls, each by the value of its P; `None` for a value that is not a plain number.
pub fn calls(text: &[u8], block: &Block, codes: CodeList) -> Vec<Option<u32>> {
    let mut found = Vec::new();
    in_words(text, block, |block| {
        if matches!(by(block, codes), Some(By::Call | By::Macro)) {
            found.extend(block.words.iter().filter(|word| word.address == b'P').map(whole));
        }
    });
    found
}

/// Whether a block calls a part of the same program (M97).
pub fn calls_own_program(text: &[u8], block: &Block, codes: CodeList) -> bool {
    let mut found = false;
    in_words(text, block, |block| found |= by(block, codes) == Some(By::Block));
    found
}

/// A word that refers to a block or a program.
struct Reference {
    /// `None`: the number is not a plain number.
    name: Option<Name>,
    kind: Kind,
    span: Span,
    scope: Scope,
}

impl Reference {
    fn named(&self) -> Option<Named> {
        let Self { name, span, scope, .. } = *self;
        name.map(|name| Named { name, span, defines: false, scope })
    }
}

fn references(text: &[u8], block: &Block, codes: CodeList) -> Vec<Reference> {
    let mut found = Vec::new();
    found.extend(jump(text, block));
    in_words(text, block, |block| words(block, codes, &mut found));
    found
}

/// What the words P and Q of a block refer to.
#[derive(Clone, Copy, PartialEq, Eq)]
enum By {
    /// G70 to G73.
    Contour,
    /// M98, M198.
    Call,
    /// G65, G66.
    Macro,
    /// A jump of macro A: `G65 H80`.
    Jump,
    /// M97.
    Block,
    /// M99.
    Return,
}

fn by(block: &Block, codes: CodeList) -> Option<By> {
    block.words.iter().find_map(|word| match (g_of(word, codes), m_of(word)) {
        (Some(G::Multiple(cycle)), _) if cycle.is_roughing() || cycle == Multiple::Finishing => {
            Some(By::Contour)
        }
        (Some(G::MacroCall(_)), _) if codes::macro_a(block).is_some_and(codes::is_jump_of_macro_a) => {
            Some(By::Jump)
        }
        (Some(G::MacroCall(_)), _) => Some(By::Macro),
        (_, Some(M::Call)) => Some(By::Call),
        (_, Some(M::LocalCall)) => Some(By::Block),
        (_, Some(M::Return)) => Some(By::Return),
        _ => None,
    })
}

/// The blocks and programs that words refer to.
fn words(block: &Block, codes: CodeList, found: &mut Vec<Reference>) {
    let Some(by) = by(block, codes) else { return };
    let called = || block.words.iter().find(|word| word.address == b'P').and_then(whole);
    for word in &block.words {
        let number = whole(word);
        let (name, scope) = match (by, word.address) {
            (By::Contour, b'P' | b'Q') | (By::Block | By::Jump, b'P') => {
                (number.map(Name::Sequence), Scope::Own)
            }
            (By::Return, b'P') => (number.map(Name::Sequence), Scope::Caller),
            (By::Call, b'Q') => {
                let called = called();
                (number.filter(|_| called.is_some()).map(Name::Sequence), Scope::Called(called.unwrap_or(0)))
            }
            (By::Call | By::Macro, b'P') => {
                (number.map(|number| Name::Program(program_and_repeats(number.into()).0)), Scope::Own)
            }
            _ => continue,
        };
        let names_program = matches!(by, By::Call | By::Macro) && word.address == b'P';
        let kind = if names_program { Kind::Program } else { Kind::Sequence };
        found.push(Reference { name, kind, span: word.span, scope });
    }
}

/// The value of a word if it is a whole number.
fn whole(word: &Word) -> Option<u32> {
    plain(word).filter(|number| *number >= 0.0 && number.fract() == 0.0).map(|number| number as u32)
}

/// Passes the words of a block to `take`; of `IF … THEN` the words after THEN, as a block.
fn in_words(text: &[u8], block: &Block, mut take: impl FnMut(&Block)) {
    if block.kind != BlockKind::Macro {
        return take(block);
    }
    let statement = Statement::of(text, block);
    let Some(at) = statement.find(b"THEN").filter(|_| statement.begins(b"IF")) else { return };
    let end = block.statement_end as usize;
    let mut parser = Parser::resume(&text[..end], Resume::inside(at as u32 + 4, block.line));
    let mut own = Block::default();
    if parser.next_block(&mut own) && own.kind == BlockKind::Words {
        take(&own);
    }
}

/// A macro statement in capitals, with blanks in place of its comments.
struct Statement {
    start: usize,
    upper: Vec<u8>,
}

impl Statement {
    fn of(text: &[u8], block: &Block) -> Self {
        let span = block.words_span();
        let mut upper = span.of(text).to_ascii_uppercase();
        for comment in block.comments.iter().filter(|own| span.contains(**own)) {
            let (from, to) = (comment.start - span.start, comment.end - span.start);
            upper[from as usize..to as usize].fill(b' ');
        }
        Self { start: span.start as usize, upper }
    }

    fn begins(&self, word: &[u8]) -> bool {
        self.upper.starts_with(word)
    }

    /// First byte of a word in the text.
    fn find(&self, word: &[u8]) -> Option<usize> {
        self.upper.windows(word.len()).position(|found| found == word).map(|at| self.start + at)
    }

    /// The statement from a byte of the text on.
    fn from(&self, at: usize) -> &[u8] {
        self.upper.get(at - self.start..).unwrap_or_default()
    }
}

/// The target of GOTO.
fn jump(text: &[u8], block: &Block) -> Option<Reference> {
    if block.kind != BlockKind::Macro {
        return None;
    }
    let statement = Statement::of(text, block);
    let at = statement.find(b"GOTO").filter(|_| statement.begins(b"GOTO") || statement.begins(b"IF"))? + 4;
    let plain = number_after(text, at, b" \tNn").filter(|(_, span)| {
        let rest = statement.from(span.end as usize);
        rest.iter().all(|byte| matches!(byte, b' ' | b'\t'))
    });
    let (name, span) = match plain {
        Some((number, span)) => (Some(Name::Sequence(number)), span),
        None => (None, Span::new(at, block.statement_end as usize)),
    };
    Some(Reference { name, kind: Kind::Sequence, span, scope: Scope::Own })
}

/// The variables in a statement or an expression; `statement`: the first one may be assigned.
fn variables(text: &[u8], within: Span, statement: bool, found: &mut Vec<Named>) {
    let (start, end) = (within.start as usize, (within.end as usize).min(text.len()));
    for hash in (start..end).filter(|&at| text[at] == b'#') {
        let Some((number, digits)) = number_after(text, hash + 1, b"") else { continue };
        let after = text[digits.end as usize..end].iter().find(|byte| !matches!(byte, b' ' | b'\t'));
        let defines = statement && hash == start && after == Some(&b'=');
        let span = Span::new(hash, digits.end as usize);
        found.push(Named { name: Name::Variable(number), span, defines, scope: Scope::Own });
    }
}

/// The integer at a byte, after any `skipped` characters, and its span.
pub fn number_after(text: &[u8], at: usize, skipped: &[u8]) -> Option<(u32, Span)> {
    let at = at + text.get(at..)?.iter().take_while(|byte| skipped.contains(byte)).count();
    let count = text[at..].iter().take_while(|byte| byte.is_ascii_digit()).count();
    let number = std::str::from_utf8(&text[at..at + count]).ok()?.parse().ok()?;
    Some((number, Span::new(at, at + count)))
}
