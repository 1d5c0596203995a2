//! Determines what is being typed before a place, and which proposals match it.

use super::{Item, ProposalKind};
use crate::assist::snippet::{Piece, Snippet};
use crate::source::Span;

/// The syntax being typed at a place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Prefix {
    /// Nothing yet: a word can begin here.
    Nothing,
    /// A word with this letter.
    Word(u8),
    /// `#` and digits.
    Variable,
    /// The target of GOTO.
    Goto,
    /// Letters of a macro statement.
    Letters,
}

/// The syntax typed before a byte, and its span. `None` in a comment, after a `;` on the same line (the text
/// there is usually a remark), and if the text before the byte matches no variant.
pub fn prefix_at(text: &[u8], line: u32, byte: u32) -> Option<(Prefix, Span)> {
    let (line, byte) = (line as usize, (byte as usize).min(text.len()));
    let before = text.get(line..byte)?;
    let is_comment = before.iter().fold(false, |is_comment, &byte| match byte {
        b'(' => true,
        b')' => false,
        _ => is_comment,
    });
    if is_comment || before.contains(&b';') {
        return None;
    }
    let is_of_number = |byte: &u8| byte.is_ascii_digit() || matches!(byte, b'.' | b'-' | b'+');
    let digits = before.iter().rev().take_while(|byte| is_of_number(byte)).count();
    let head = &before[..before.len() - digits];
    let last = |bytes: usize| Span::new(byte - bytes, byte);
    let letters = head.iter().rev().take_while(|byte| byte.is_ascii_alphabetic() || !byte.is_ascii()).count();
    let last_letters = |bytes: usize| head[head.len() - bytes..].to_ascii_uppercase();
    match head.last() {
        Some(b'#') => Some((Prefix::Variable, last(digits + 1))),
        Some(_) if letters == 1 => Some((Prefix::Word(last_letters(1)[0]), last(digits + 1))),
        Some(_) if letters >= 4 && last_letters(4) == b"GOTO" => Some((Prefix::Goto, last(digits))),
        Some(_) if letters > 1 && digits == 0 => Some((Prefix::Letters, last(letters))),
        Some(b' ' | b'\t') if head.trim_ascii_end().to_ascii_uppercase().ends_with(b"GOTO") => {
            Some((Prefix::Goto, last(digits)))
        }
        None | Some(b' ' | b'\t') if digits == 0 => Some((Prefix::Nothing, last(0))),
        _ => None,
    }
}

/// Whether a proposal matches the typed text. Numbers after G, M, N, P and T match with and without a leading
/// zero: `G1` matches G01 and G10. Letters of a macro statement match a snippet by its keyword, WHILE or IF.
pub fn begins_with(item: &Item, typed: &str, prefix: Prefix) -> bool {
    let first = match item.pieces.first() {
        Some(Piece::Fixed(text) | Piece::Fill(text)) => text.as_str(),
        None => return false,
    };
    match prefix {
        // The first two pieces of a snippet may form the typed code (letter and value), so compare them
        // together.
        Prefix::Word(_) => {
            let text = match item.pieces.get(1) {
                Some(Piece::Fill(value)) if first.len() == 1 => format!("{first}{value}"),
                _ => first.to_owned(),
            };
            // Letters whose numbers are often written with a leading zero.
            let without_leading_zero = |text: &str| match text.split_at_checked(2) {
                Some((head @ ("G0" | "M0" | "N0" | "P0" | "T0"), rest)) if !rest.is_empty() => {
                    format!("{}{rest}", &head[..1])
                }
                _ => text.to_owned(),
            };
            text.starts_with(typed) || without_leading_zero(&text).starts_with(&without_leading_zero(typed))
        }
        Prefix::Letters => match item.kind {
            ProposalKind::Snippet(Snippet::Loop) => "WHILE".starts_with(typed),
            ProposalKind::Snippet(Snippet::Condition) => "IF".starts_with(typed),
            _ => false,
        },
        Prefix::Nothing | Prefix::Variable | Prefix::Goto => first.starts_with(typed),
    }
}
