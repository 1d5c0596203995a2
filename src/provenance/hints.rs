//! Quick check whether a text may be something else than a program in system A of a FANUC lathe.
//!
//! In: a statement. Out: whether it contains anything specific to other controls and machines, or to systems
//! B and C. Without any such statement [`recognise`](super::recognise) finds nothing. False positives are
//! possible, so the caller must then check in detail. This code is in the core of the module, the detailed
//! check is not.

use super::finder::is_zero;
use super::statement::Statement;

/// Beginnings of remarks that are statements of Fagor or LinuxCNC.
const REMARKS: [&[u8; 3]; 11] =
    [b"RPT", b"GOT", b"IF ", b"CAL", b"PCA", b"SUB", b"RET", b"DEB", b"PRI", b"LOG", b"MSG"];

/// Whether a statement contains anything specific to other controls.
pub fn is_unusual(text: &[u8], statement: &Statement) -> bool {
    let line = statement.span.of(text);
    let head = matches!(line, [b'%', _, ..] | [b'$' | b'!', ..] | [b'o' | b'O', b'<', ..]);
    let named = !statement.names().is_empty() || statement.named_variable.is_some();
    let assigned = statement.words().iter().any(|word| word.assigned);
    let beside_the_plane = statement.word(b'Y').is_some_and(|word| !is_zero(word) || statement.has(b'E'));
    let six_digits = statement.word(b'T').is_some_and(|word| word.span.len() == 7);
    head || named
        || assigned
        || beside_the_plane
        || six_digits
        || has_remark(text, statement)
        || has_code(statement)
}

fn has_remark(text: &[u8], statement: &Statement) -> bool {
    let Some([b'(', first, second, third, ..]) = statement.remark.map(|span| span.of(text)) else {
        return false;
    };
    let begins = [*first, *second, *third].map(|byte| byte.to_ascii_uppercase());
    REMARKS.contains(&&begins) || begins[0] == b'P' && second.is_ascii_digit()
}

fn has_code(statement: &Statement) -> bool {
    let has = |letters: &[u8]| statement.has_any(letters);
    let cycle = has(b"XU") && has(b"ZW");
    let bare = statement.words().iter().all(|word| matches!(word.letter, b'G' | b'N'));
    let unusual = |code: u32| match code {
        70 | 80 | 240 | 330 | 331 | 360 | 370 | 430 | 910 | 911 | 921..=923 | 930 | 950 | 1090 => true,
        200 | 210 => cycle && has(b"F"),
        640 => has(b"P"),
        700 | 710 if bare => true,
        720 if has(b"P") && !has(b"UW") => true,
        710..=730 => has(b"XZE") || has(b"R") && has(b"P"),
        760 => has(b"CJ"),
        770 | 780 if has(b"P") => true,
        660 | 680 | 690 => has(b"E"),
        770..=820 => cycle,
        900 => statement.codes(b'G').any(|(other, _)| matches!(other, 0 | 10)),
        920 | 940 => !has(b"XZUW"),
        960 => has(b"D"),
        _ => false,
    };
    statement.codes(b'G').any(|(code, _)| unusual(code))
        || statement.codes(b'M').any(|(code, _)| matches!(code, 1040 | 1090 | 1400 | 1900))
}
