//! The words of a G65 or G66 block as local variables of the macro that is called.

use super::MacroErrorKind;
use super::variables::{LOCALS, Locals};

/// A word that cannot hand over an argument.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ArgumentError {
    /// Which word, counted from 0.
    pub index: usize,
    /// What is wrong with it.
    pub kind: MacroErrorKind,
}

/// Most sets of I, J and K in one call.
const SETS: usize = 10;

/// The local variables #1 to #33 from the words of a call: letter and value, in the order they are written.
/// The caller has taken out what is no argument: G65 or G66 itself, P, L, and words whose value is vacant.
///
/// Both specifications may be mixed: each letter has its variable, and I, J, K begin a next set whenever one
/// of them does not follow in alphabetical order. Where two words reach the same variable, the later holds.
pub fn arguments(words: impl Iterator<Item = (u8, f64)>) -> Result<Locals, ArgumentError> {
    let mut locals = [None; LOCALS];
    let mut set = 0;
    let mut last = 0;
    for (index, (letter, value)) in words.enumerate() {
        let letter = letter.to_ascii_uppercase();
        let mut variable = variable(letter);
        if let b'I'..=b'K' = letter {
            set += usize::from(letter <= last);
            last = letter;
            variable = (set < SETS).then_some(usize::from(letter - b'I') + 4 + 3 * set);
        }
        match variable {
            Some(variable) => locals[variable - 1] = Some(value),
            None => return Err(ArgumentError { index, kind: MacroErrorKind::ArgumentLetter }),
        }
    }
    Ok(locals)
}

/// The variable of a letter in specification I.
fn variable(letter: u8) -> Option<usize> {
    Some(match letter {
        b'A'..=b'C' => usize::from(letter - b'A') + 1,
        b'D'..=b'F' => usize::from(letter - b'D') + 7,
        b'H' => 11,
        b'I'..=b'K' => usize::from(letter - b'I') + 4,
        b'M' => 13,
        b'Q'..=b'Z' => usize::from(letter - b'Q') + 17,
        _ => return None,
    })
}
