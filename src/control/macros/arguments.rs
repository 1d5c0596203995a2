//! The words of a G65 or G66 block as local variables of the called macro.

use super::MacroErrorKind;
use super::variables::{LOCALS, Locals};

/// A word that cannot pass an argument.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ArgumentError {
    /// Index of the word.
    pub index: usize,
    /// The error.
    pub kind: MacroErrorKind,
}

/// Maximum number of sets of I, J and K in one call.
const SETS: usize = 10;

/// The local variables #1 to #33 from the words of a call: letters and values, in program order. The caller
/// has removed everything that is not an argument: G65 or G66 itself, P, L, and vacant words.
///
/// Both specifications may be mixed: each letter has its variable, and I, J, K begin the next set whenever
/// one of them does not follow in alphabetical order. If two words set the same variable, the later wins.
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
