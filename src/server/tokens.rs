//! Semantic tokens: the classes of the words, for colours.
//!
//! In: a text, or some of its lines. Out: tokens on one line each, in order, as differences. Needs no run.

use gen_lsp_types::{
    Position, SemanticToken, SemanticTokens, SemanticTokensParams, SemanticTokensRangeParams,
};

use super::context::Asked;
use super::message::Failure;
use crate::source::{Span, after_line_end, line_around, line_end};
use crate::text::highlight::{TokenClass, highlight};

/// Longest text, bytes, whose tokens are sent in one response. For a longer text, clients request the tokens of the
/// visible lines.
pub const MAX_WHOLE: usize = 2 << 20;

/// The token types, in the order of [`TokenClass`].
const TYPES: [&str; 10] = [
    "comment",
    "keyword",
    "function",
    "variable",
    "parameter",
    "label",
    "property",
    "macro",
    "string",
    "operator",
];

/// The names of the token types.
pub fn legend() -> Vec<String> {
    TYPES.map(str::to_owned).to_vec()
}

/// The answer to `textDocument/semanticTokens/full`.
pub fn whole(asked: &Asked, _: &SemanticTokensParams) -> Result<Option<SemanticTokens>, Failure> {
    let length = asked.text().len();
    Ok((length <= MAX_WHOLE).then(|| tokens(asked, 0, length)))
}

/// The answer to `textDocument/semanticTokens/range`.
pub fn part(asked: &Asked, params: &SemanticTokensRangeParams) -> Result<Option<SemanticTokens>, Failure> {
    let (text, span) = (asked.text(), asked.positions().span(params.range));
    let start = line_around(text, span.start as usize).start as usize;
    let end = line_end(text, span.end as usize);
    let end = end.min(char_boundary(text, start + MAX_WHOLE));
    Ok(Some(tokens(asked, start, end)))
}

/// The first byte of a character at or after a byte.
fn char_boundary(text: &[u8], from: usize) -> usize {
    let continues = |at: &usize| text.get(*at).is_some_and(|byte| byte & 0xC0 == 0x80);
    (from..).find(|at| !continues(at)).unwrap_or(from)
}

fn tokens(asked: &Asked, start: usize, end: usize) -> SemanticTokens {
    let text = asked.text();
    let found = highlight(text, start, end).into_iter();
    let pieces = found.flat_map(|(span, class)| lines_of(text, span).map(move |line| (line, class)));
    let mut last = Position { line: 0, character: 0 };
    let data = pieces.map(|(span, class)| token(asked, span, class, &mut last)).collect();
    SemanticTokens { result_id: None, data }
}

/// The parts of a span on each line; a comment can have several.
fn lines_of(text: &[u8], span: Span) -> impl Iterator<Item = Span> + '_ {
    let mut at = span.start as usize;
    let end = span.end as usize;
    std::iter::from_fn(move || {
        if at >= end {
            return None;
        }
        let stop = line_end(text, at).min(end);
        let line = Span::new(at, stop);
        at = after_line_end(text, stop).max(stop + 1);
        Some(line)
    })
    .filter(|line| !line.is_empty())
}

fn token(asked: &Asked, span: Span, class: TokenClass, last: &mut Position) -> SemanticToken {
    let range = asked.range(span);
    let delta_line = range.start.line - last.line;
    let delta_start =
        if delta_line == 0 { range.start.character - last.character } else { range.start.character };
    *last = range.start;
    SemanticToken {
        delta_line,
        delta_start,
        length: range.end.character - range.start.character,
        token_type: class as u32,
        token_modifiers_bitset: 0,
    }
}
