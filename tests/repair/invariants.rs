//! Invariants of the safe fixes of any text. The property test and the fuzz target share them.

use gcode_playground::repair::{Repaired, repaired};
use gcode_playground::setup::Setup;
use gcode_playground::text::block::Block;
use gcode_playground::text::lexer::{Lexer, TokenKind};
use gcode_playground::text::parser::Parser;

/// Applies all safe fixes and checks that they end, enclose no address with a value in brackets, add no
/// syntax error, and that a second application changes nothing.
pub fn repair(text: &[u8], setup: &Setup) -> Repaired {
    let fixed = repaired(text, setup);
    let shown = || {
        format!("\n{}\n--- fixed:\n{}", String::from_utf8_lossy(text), String::from_utf8_lossy(&fixed.text))
    };
    assert_eq!(fixed.open, None, "{}", shown());
    let (before, after) = (addresses(text), addresses(&fixed.text));
    assert!(is_part(&before, &after), "an address came into brackets: {before:?} {after:?}{}", shown());
    let (errors, left) = (errors_of_writing(text), errors_of_writing(&fixed.text));
    assert!(left <= errors, "{errors} errors of writing became {left}{}", shown());
    if fixed.taken.is_empty() {
        assert!(fixed.text == text, "changed without a fix{}", shown());
    } else {
        let again = repaired(&fixed.text, setup);
        assert!(
            again.text == fixed.text && again.taken.is_empty(),
            "a second application changes it{}",
            shown()
        );
    }
    fixed
}

/// The addresses with a value outside of brackets, in order: a letter followed by digits, with signs and
/// blanks between. Letters read as digits belong to the value, and full-width characters count as ASCII:
/// `GO1`, `Ｍ8`, `X5２`.
pub fn addresses(text: &[u8]) -> Vec<char> {
    let mut outside = text.to_vec();
    for token in Lexer::new(text, 0) {
        if matches!(token.kind, TokenKind::Comment | TokenKind::NestedComment | TokenKind::OpenComment) {
            outside[token.span.start as usize..token.span.end as usize].fill(b'(');
        }
    }
    let outside = String::from_utf8_lossy(&outside);
    let mut letters = outside.chars().map(ascii).peekable();
    let mut found = Vec::new();
    while let Some(letter) = letters.next() {
        if !letter.is_ascii_alphabetic() {
            continue;
        }
        let mut rest = letters.clone();
        let mut is_apart = false;
        let between = |sign: &char| matches!(sign, ' ' | '\t' | '+' | '-' | '\u{2212}' | '\u{2013}');
        while let Some(sign) = rest.next_if(between) {
            is_apart = matches!(sign, ' ' | '\t');
        }
        let mut digits = 0;
        while let Some(digit) = rest.next_if(|sign| {
            let is_letter = matches!(sign, 'O' | 'o' | 'l') && (digits > 0 || !is_apart);
            is_letter || sign.is_ascii_digit() || matches!(sign, '.' | ',')
        }) {
            digits += usize::from(digit.is_ascii_digit());
        }
        if digits > 0 {
            found.push(letter.to_ascii_uppercase());
            letters = rest;
        }
    }
    found
}

/// The ASCII equivalent of a full-width character.
fn ascii(sign: char) -> char {
    match sign {
        '\u{ff01}'..='\u{ff5e}' => char::from((u32::from(sign) - 0xfee0) as u8),
        _ => sign,
    }
}

/// Whether `part` is a subsequence of `whole`.
fn is_part(part: &[char], whole: &[char]) -> bool {
    let mut whole = whole.iter();
    part.iter().all(|one| whole.any(|other| other == one))
}

fn errors_of_writing(text: &[u8]) -> usize {
    let (mut parser, mut block, mut errors) = (Parser::new(text), Block::default(), 0);
    while parser.next_block(&mut block) {
        errors += block.faults.iter().filter(|fault| fault.is_error()).count();
    }
    errors
}
