//! The unit that a program selects first. Sizes in comments at its head are in this unit.

use crate::units::Unit;

/// The unit of the first G20 or G21 of a text.
pub fn unit_of(bytes: &[u8]) -> Option<Unit> {
    let mut at = 0;
    while let Some(found) = bytes[at..].iter().position(|byte| matches!(byte, b'G' | b'g' | b'(')) {
        at += found;
        if bytes[at] == b'(' {
            let ends = |byte: &u8| matches!(byte, b')' | b'\n' | b'\r');
            at += bytes[at..].iter().position(ends).unwrap_or(bytes.len() - at);
            continue;
        }
        let digits = &bytes[at + 1..bytes.len().min(at + 4)];
        match digits {
            [b'2', b'0', rest @ ..] if !rest.first().is_some_and(u8::is_ascii_digit) => {
                return Some(Unit::Inch);
            }
            [b'2', b'1', rest @ ..] if !rest.first().is_some_and(u8::is_ascii_digit) => {
                return Some(Unit::Millimetre);
            }
            _ => at += 1,
        }
    }
    None
}
