//! Guesses the lost letter of a number.
//!
//! In: the number and the words around it. Out: letters, the most likely first.

use super::block::Word;
use crate::source::Span;

/// Most letters that are offered.
const OFFERED: usize = 3;

/// Letters that a number without one may have lost: those that are usual at this place and do not occur in
/// the block yet.
pub fn candidates(number: &str, span: Span, words: &[Word]) -> Vec<char> {
    let has = |letters: &[u8]| words.iter().any(|word| letters.contains(&word.address));
    // A word that is split by a blank begins before it.
    let behind = words.iter().filter(|word| word.span.start < span.start);
    let before = |letters: &[u8]| behind.clone().any(|word| letters.contains(&word.address));
    let code = |codes: &[u64]| {
        words.iter().any(|word| {
            word.address == b'G'
                && matches!(word.value, super::block::Value::Number { number, .. } if codes.contains(&number.mantissa) && number.decimals == 0)
        })
    };
    let (number, negative) = (
        number.trim_start_matches(['-', '+', '–', '−']),
        !number.starts_with(|first: char| first.is_ascii_digit() || first == '.'),
    );
    let has_point = number.contains('.');
    let digits = number.trim_start_matches('0');
    let value = size_of(number);
    let whole = !has_point && !negative;
    let contour = code(&[70, 71, 72, 73]);
    let deep = code(&[74, 75, 76]);
    let mut found = Vec::new();
    let mut offer = |letter: char, fits: bool| {
        if fits && !found.contains(&letter) {
            found.push(letter);
        }
    };
    let leading = number.len() >= 2 && number.starts_with('0') && whole;
    offer('T', whole && !has(b"T") && number.len() == 4 && (leading || value % 101.0 == 0.0));
    offer('S', whole && value >= 50.0 && !has(b"S") && (code(&[50, 96, 97]) || has(b"M")) && !has(b"XZUW"));
    offer('P', whole && (contour || deep) && !has(b"P") && has(b"Q"));
    offer('Q', whole && (contour || deep) && !has(b"Q") && has(b"P"));
    offer('P', whole && has(b"M") && !has(b"P") && value >= 1000.0);
    offer('G', (leading || value == 0.0 && number.len() == 2) && number.len() == 2 && !before(b"XZUW"));
    offer('M', (leading || whole && value <= 99.0) && !has(b"M") && digits.len() <= 2 && before(b"XZS"));
    offer('G', whole && !has(b"G") && !before(b"XZUWFS") && (70.0..100.0).contains(&value));
    let stands_first = words.iter().all(|word| word.span.start > span.start || word.address == b'G');
    offer('G', whole && number.len() == 2 && stands_first && is_usual_code(value));
    offer('F', has_point && !negative && value < 1.0 && !has(b"F") && before(b"XZUWPQ"));
    let arc = code(&[2, 3]);
    offer('R', arc && before(b"Z") && !has(b"R"));
    offer('X', !has(b"XU") && !before(b"ZW"));
    offer('Z', !has(b"ZW") && (before(b"XU") || has(b"XU")));
    offer('F', !negative && !has(b"F") && before(b"XZUW"));
    offer('R', !has(b"R") && !code(&[0]));
    offer('X', !has(b"XU"));
    offer('Z', !has(b"ZW"));
    offer('U', !has(b"U"));
    offer('W', !has(b"W"));
    found.truncate(OFFERED);
    found
}

/// Whether a number is a G code that is frequent at the head of a block.
fn is_usual_code(number: f64) -> bool {
    const CODES: [u8; 16] = [17, 18, 19, 20, 21, 28, 30, 32, 34, 40, 41, 42, 50, 54, 98, 99];
    CODES.iter().any(|&code| f64::from(code) == number)
}

/// The value of digits with at most one point, exact enough to compare it with the usual values of letters; 0
/// for anything else.
fn size_of(number: &str) -> f64 {
    let (mut value, mut scale, mut points) = (0.0, 1.0, 0);
    for byte in number.bytes() {
        match byte {
            b'.' => points += 1,
            b'0'..=b'9' => {
                value = 10.0 * value + f64::from(byte - b'0');
                scale *= if points > 0 { 10.0 } else { 1.0 };
            }
            _ => return 0.0,
        }
    }
    if points > 1 { 0.0 } else { value / scale }
}
