//! Words with misread characters, or characters of another keyboard: letters O and l instead of 0 and 1,
//! full-width characters.
//!
//! In: bytes at which a word begins. Out: the intended word. A correctly written word is not recognised.

/// U+2212 and U+2013.
const PRINTED_MINUS: [&[u8]; 2] = ["\u{2212}".as_bytes(), "\u{2013}".as_bytes()];

/// A longer number is not a typing mistake.
const LONGEST: usize = 16;

/// The intended word.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Misread {
    /// The address, upper-case.
    pub address: u8,
    /// Address, sign and number in ASCII.
    pub plain: String,
    /// The first letter that replaces a digit.
    pub letter: Option<u8>,
    /// Its length in bytes.
    pub len: usize,
}

/// The word at byte `start`, if it can only be a misread one.
pub fn read(text: &[u8], start: usize) -> Option<Misread> {
    let (address, mut at, mut wide) = character(text, start)?;
    if !address.is_ascii_alphabetic() {
        return None;
    }
    let (mut plain, mut len) = ([address.to_ascii_uppercase(); LONGEST + 1], 1);
    let (mut digits, mut letter) = (0, None);
    while let Some((byte, next, is_wide)) = character(text, at)
        && len <= LONGEST
    {
        let mut meant = byte;
        match byte {
            b'-' | b'+' if len == 1 => {}
            b'0'..=b'9' => digits += 1,
            b'.' => {}
            b'O' | b'o' | b'l' if !is_wide && is_misread_digit(text, at, address, digits) => {
                letter = letter.or(Some(byte));
                meant = if byte == b'l' { b'1' } else { b'0' };
                digits += 1;
            }
            _ => break,
        }
        plain[len] = meant;
        len += 1;
        wide |= is_wide;
        at = next;
    }
    let misread = (wide || letter.is_some()) && digits > 0;
    misread.then(|| Misread {
        address: address.to_ascii_uppercase(),
        plain: plain[..len].iter().map(|&byte| char::from(byte)).collect(),
        letter,
        len: at - start,
    })
}

/// Whether an O or l inside a number can only be a digit: it follows the letter or the digits of its word,
/// and after it and others like it there are digits or the end of the word.
fn is_misread_digit(text: &[u8], at: usize, address: u8, digits: usize) -> bool {
    let alike = text[at..].iter().take(LONGEST).take_while(|byte| matches!(byte, b'O' | b'o' | b'l')).count();
    let next = text.get(at + alike).copied().unwrap_or(b' ');
    let ends = matches!(next, b'0'..=b'9' | b'.') || !next.is_ascii_alphanumeric();
    if text[at] == b'l' {
        // `P9010l2`, and words in lower case: the repetitions of a call.
        let repeats = digits > 0 && (address.is_ascii_lowercase() || address == b'P');
        let alone = digits == 0 && alike == 1 && !next.is_ascii_digit();
        return ends && !repeats && !alone;
    }
    ends
}

/// Whether a character is the full-width form of an ASCII character.
pub fn is_full_width(sign: char) -> bool {
    ('\u{ff01}'..='\u{ff5e}').contains(&sign)
}

/// The ASCII form of the character at a byte, the start of the next one, and whether it was full-width. A
/// typographic minus (U+2212, U+2013) becomes `-`.
fn character(text: &[u8], at: usize) -> Option<(u8, usize, bool)> {
    match *text.get(at)? {
        0xEF => {
            // U+FF01 to U+FF5E are the full-width forms of the ASCII characters from `!` to `~`.
            let (second, third) = (*text.get(at + 1)?, *text.get(at + 2)?);
            let code = 0xF000 | u32::from(second & 0x3F) << 6 | u32::from(third & 0x3F);
            let twin = code.checked_sub(0xFEE0).filter(|twin| (0x21..=0x7E).contains(twin))?;
            (second & 0xC0 == 0x80 && third & 0xC0 == 0x80).then_some((twin as u8, at + 3, true))
        }
        0xE2 if PRINTED_MINUS.contains(&text.get(at..at + 3)?) => Some((b'-', at + 3, false)),
        byte if byte < 0x80 => Some((byte, at + 1, false)),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn plain(text: &str) -> Option<String> {
        read(text.as_bytes(), 0).map(|found| format!("{} {}", found.plain, &text[found.len..]))
    }

    #[test]
    fn misread_words() {
        let cases = [
            ("GO1 X5", "G01  X5"),
            ("X2O0", "X200 "),
            ("Z1O.5", "Z10.5 "),
            ("ZO", "Z0 "),
            ("Xl5", "X15 "),
            ("T0l01", "T0101 "),
            ("Ｘ５０．５Z", "X50.5 Z"),
            ("Z－2０ F", "Z-20  F"),
            ("NlO G0", "N10  G0"),
            ("X–1O Z", "X-10  Z"),
            ("U−l5", "U-15 "),
        ];
        for (text, expected) in cases {
            assert_eq!(plain(text).as_deref(), Some(expected), "{text}");
        }
    }

    #[test]
    fn what_is_written_right_is_no_misread_word() {
        for text in ["X50", "G01X5", "M98P1000L3", "m98p1000l3", "X", "O1000", "XY", "（X5）", "X–10"] {
            assert_eq!(plain(text), None, "{text}");
        }
        assert_eq!(read("p1000l3".as_bytes(), 0), None);
    }
}
