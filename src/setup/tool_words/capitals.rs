//! Converts text to capitals, for the alphabets used in tool names: Latin with accents, Greek, Cyrillic.
//!
//! In: a comment. Out: the same in capitals. The standard library supports all alphabets, but its table takes
//! 5 kB of the module.

/// The text in capitals; letters of other alphabets are unchanged.
pub(super) fn in_capitals(text: &str) -> String {
    let mut capitals = String::with_capacity(text.len());
    for letter in text.chars() {
        if letter == 'ß' { capitals.push_str("SS") } else { capitals.push(capital(letter)) }
    }
    capitals
}

fn capital(letter: char) -> char {
    let code = u32::from(letter);
    let down = match code {
        0x61..=0x7a
        | 0xe0..=0xf6
        | 0xf8..=0xfe
        | 0x3b1..=0x3c1
        | 0x3c3..=0x3cb
        | 0x430..=0x44f
        | 0xff41..=0xff5a => 0x20,
        0x450..=0x45f => 0x50,
        // Capital and small letters alternate.
        0x100..=0x130 | 0x132..=0x137 | 0x14a..=0x177 | 0x460..=0x481 | 0x48a..=0x4bf => code & 1,
        0x139..=0x148 | 0x179..=0x17e => u32::from(code % 2 == 0),
        _ => 0,
    };
    char::from_u32(code - down).unwrap_or(letter)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn these_alphabets_have_the_capitals_that_the_library_gives_them() {
        let ranges = [0..=0xff, 0x100..=0x17e, 0x391..=0x3a9, 0x3b1..=0x3c9, 0x400..=0x4bf, 0xff21..=0xff5a];
        // Letters whose capital is two letters (`in_capitals` handles the first), letters whose capital is in
        // another range, and a small one without a dot.
        let otherwise = ['ß', 'µ', 'ÿ', 'ı', 'ŉ', 'ς'];
        for letter in ranges.into_iter().flatten().filter_map(char::from_u32) {
            if !otherwise.contains(&letter) {
                assert_eq!(vec![capital(letter)], letter.to_uppercase().collect::<Vec<_>>(), "{letter}");
            }
        }
        assert_eq!(in_capitals("außen: Fräser 刀 ø12 каналы"), "AUSSEN: FRÄSER 刀 Ø12 КАНАЛЫ");
    }
}
