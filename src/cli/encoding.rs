//! The encodings of program files: bytes to UTF-8 and back, without loss.
//!
//! In: the bytes of a file. Out: its text as UTF-8, and the encoding to write it in. Files with a byte order
//! mark, UTF-16 with a zero in every other byte, and valid UTF-8 are certain. Otherwise the non-ASCII bytes,
//! usually comments, are decoded as Chinese, Russian and Western text, and the most probable reading is used.
//! `www/src/files/encoding-guess.ts` does the same on the page, with the same table; `tests/encodings.json`
//! tests both. Must not know: the contents of a program.

use std::borrow::Cow;
use std::collections::HashSet;
use std::sync::LazyLock;

use encoding_rs::{GB18030, WINDOWS_1251, WINDOWS_1252};
use serde::Deserialize;

/// The encoding of a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Encoding {
    /// With or without a byte order mark, which is kept in the text.
    Utf8,
    /// With or without a byte order mark, which is removed from the text.
    Utf16(Endian, ByteOrderMark),
    /// An encoding that can only be guessed.
    Legacy(&'static encoding_rs::Encoding),
}

/// Byte order of UTF-16.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Endian {
    /// Low byte first.
    Little,
    /// High byte first.
    Big,
}

/// Whether a UTF-16 file begins with a byte order mark.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ByteOrderMark {
    /// With a byte order mark.
    Present,
    /// Without one.
    Absent,
}

/// Maximum number of non-ASCII bytes used for a guess; more do not change it.
const MAX_SCANNED_BYTES: usize = 100_000;

/// Decodes a file to UTF-8. Encoding the text again returns the same bytes.
pub fn decode(bytes: Vec<u8>) -> (Vec<u8>, Encoding) {
    let unmarked = unmarked_utf16(&bytes);
    if unmarked.is_none() && bytes.is_ascii() {
        return (bytes, Encoding::Utf8);
    }
    let marked = [Endian::Little, Endian::Big].map(|endian| Encoding::Utf16(endian, ByteOrderMark::Present));
    let unmarked = unmarked.map(|endian| Encoding::Utf16(endian, ByteOrderMark::Absent));
    for encoding in marked.into_iter().chain(unmarked) {
        if let Some(text) = encoding.decode(&bytes) {
            return (text.into_bytes(), encoding);
        }
    }
    if std::str::from_utf8(&bytes).is_ok() && !is_rather_chinese(&bytes) {
        return (bytes, Encoding::Utf8);
    }
    for encoding in by_likelihood(&bytes).map(Encoding::Legacy) {
        if let Some(text) = encoding.decode(&bytes) {
            return (text.into_bytes(), encoding);
        }
    }
    // Unreachable: every byte is a character of Windows-1252.
    (bytes, Encoding::Utf8)
}

impl Encoding {
    /// The common name of the encoding.
    pub fn name(self) -> &'static str {
        match self {
            Encoding::Utf8 => "UTF-8",
            Encoding::Utf16(Endian::Little, _) => "UTF-16LE",
            Encoding::Utf16(Endian::Big, _) => "UTF-16BE",
            Encoding::Legacy(encoding) => encoding.name(),
        }
    }

    /// Decodes bytes; `None` if encoding the text would not return the same bytes.
    fn decode(self, bytes: &[u8]) -> Option<String> {
        let text = match self {
            Encoding::Utf8 => String::from_utf8(bytes.to_vec()).ok()?,
            Encoding::Utf16(endian, mark) => {
                let (pairs, rest) = bytes.strip_prefix(mark.bytes(endian))?.as_chunks::<2>();
                let units: Vec<u16> = pairs.iter().map(|&pair| endian.unit(pair)).collect();
                String::from_utf16(&units).ok().filter(|_| rest.is_empty())?
            }
            Encoding::Legacy(encoding) => {
                encoding.decode_without_bom_handling_and_without_replacement(bytes)?.into_owned()
            }
        };
        (self.encode(&text).as_deref() == Some(bytes)).then_some(text)
    }

    /// Encodes a text; `None` if the encoding lacks a character.
    pub fn encode(self, text: &str) -> Option<Cow<'_, [u8]>> {
        match self {
            Encoding::Utf8 => Some(Cow::Borrowed(text.as_bytes())),
            Encoding::Utf16(endian, mark) => {
                let mut bytes = mark.bytes(endian).to_vec();
                bytes.extend(text.encode_utf16().flat_map(|unit| endian.bytes(unit)));
                Some(Cow::Owned(bytes))
            }
            Encoding::Legacy(encoding) => {
                let (bytes, _, no_place) = encoding.encode(text);
                (!no_place).then_some(bytes)
            }
        }
    }
}

impl ByteOrderMark {
    fn bytes(self, endian: Endian) -> &'static [u8] {
        match (self, endian) {
            (ByteOrderMark::Present, Endian::Little) => &[0xFF, 0xFE],
            (ByteOrderMark::Present, Endian::Big) => &[0xFE, 0xFF],
            (ByteOrderMark::Absent, _) => &[],
        }
    }
}

impl Endian {
    fn bytes(self, unit: u16) -> [u8; 2] {
        match self {
            Endian::Little => unit.to_le_bytes(),
            Endian::Big => unit.to_be_bytes(),
        }
    }

    fn unit(self, bytes: [u8; 2]) -> u16 {
        match self {
            Endian::Little => u16::from_le_bytes(bytes),
            Endian::Big => u16::from_be_bytes(bytes),
        }
    }
}

/// Characters that are common in comments of programs.
#[derive(Deserialize)]
struct Plausible {
    /// Chinese characters used in workshops.
    hanzi: String,
    /// Russian letters, in order of frequency.
    cyrillic: String,
    /// Non-ASCII letters of Western languages.
    western: String,
    /// Punctuation and symbols of any language.
    signs: String,
}

static PLAUSIBLE: LazyLock<Plausible> = LazyLock::new(|| {
    serde_json::from_str(include_str!("plausible.json")).expect("plausible.json is well formed")
});

/// The byte order of a UTF-16 file without a byte order mark. ASCII characters, most of a program, have a
/// zero high byte and a non-zero low byte. Paper-tape feed is a sequence of zeros, so both conditions are
/// tested.
fn unmarked_utf16(bytes: &[u8]) -> Option<Endian> {
    let (pairs, _) = bytes.as_chunks::<2>();
    let zeros = |at: usize| pairs.iter().filter(|pair| pair[at] == 0).count();
    let least = pairs.len().div_ceil(2).max(2);
    match (zeros(0), zeros(1)) {
        (0, high) if high >= least => Some(Endian::Little),
        (high, 0) if high >= least => Some(Endian::Big),
        _ => None,
    }
}

/// Whether valid UTF-8 is more probably GB18030, as in short Chinese comments: bytes that are letters of rare
/// alphabets in UTF-8, but common characters in GB18030.
fn is_rather_chinese(bytes: &[u8]) -> bool {
    let of_far_alphabet = |&byte: &u8| matches!(byte, 0xC6..=0xCD | 0xD2..=0xDF);
    let pairs = bytes.iter().filter(|byte| !byte.is_ascii()).count() / 2;
    !bytes.iter().any(|&byte| byte >= 0xE0)
        && bytes.iter().any(of_far_alphabet)
        && chinese(bytes) <= COMMON * pairs as f64
}

fn by_likelihood(bytes: &[u8]) -> impl Iterator<Item = &'static encoding_rs::Encoding> {
    let mut beyond_ascii = bytes.iter().enumerate().filter(|(_, byte)| !byte.is_ascii());
    let end = beyond_ascii.nth(MAX_SCANNED_BYTES - 1).map_or(bytes.len(), |(at, _)| at + 1);
    let looked = &bytes[..end];
    let mut surprises =
        [(GB18030, chinese(looked)), (WINDOWS_1252, western(looked)), (WINDOWS_1251, russian(looked))];
    surprises.sort_by(|a, b| a.1.total_cmp(&b.1));
    surprises.into_iter().map(|(encoding, _)| encoding)
}

/// Maximum surprise of a character in the first level of GB 2312.
const COMMON: f64 = 9.8;

// Surprise of a reading: the sum of `-ln(p)` for rough probabilities `p` of its characters.

/// Surprise as Russian: words of Cyrillic letters are likely, frequent letters more so. Capitals after small
/// letters and Latin neighbours are unlikely.
fn russian(bytes: &[u8]) -> f64 {
    let table = byte_table(WINDOWS_1251, |ch| {
        let small = ch.to_lowercase().next();
        match PLAUSIBLE.cyrillic.chars().position(|letter| Some(letter) == small) {
            Some(rank) => 2.2 + 0.12 * rank as f64,
            None if PLAUSIBLE.signs.contains(ch) => 5.0,
            None if ch.is_alphabetic() => 8.0,
            None => 9.0,
        }
    });
    let mut total = 0.0;
    for (at, &byte) in bytes.iter().enumerate().filter(|(_, byte)| !byte.is_ascii()) {
        let (character, surprise) = table[usize::from(byte)];
        let (before, after) = neighbours(bytes, at);
        total += surprise;
        if character.is_uppercase() && table[usize::from(before)].0.is_lowercase() {
            total += 4.0;
        }
        if is_letter(character) {
            let latin = [before, after].iter().filter(|byte| byte.is_ascii_alphabetic()).count();
            total += 3.0 * latin as f64;
        }
    }
    total
}

/// Surprise as Western text: single accented letters between Latin letters, and symbols next to numbers, are
/// likely.
fn western(bytes: &[u8]) -> f64 {
    let table = byte_table(WINDOWS_1252, |ch| {
        if PLAUSIBLE.western.contains(ch) {
            3.4
        } else if PLAUSIBLE.signs.contains(ch) {
            4.5
        } else if ch.is_alphabetic() {
            6.5
        } else {
            9.0
        }
    });
    let mut total = 0.0;
    let mut run = 0;
    for (at, &byte) in bytes.iter().enumerate() {
        if byte.is_ascii() {
            run = 0;
            continue;
        }
        let (character, surprise) = table[usize::from(byte)];
        total += surprise + [0.0, 3.0, 5.0][run.min(2)];
        run += 1;
        let (before, after) = neighbours(bytes, at);
        if is_letter(character) && !before.is_ascii_alphabetic() && !after.is_ascii_alphabetic() {
            total += 1.0;
        }
    }
    total
}

/// Surprise as Chinese: pairs of bytes; characters used in workshops are most likely. An invalid pair rules
/// it out.
fn chinese(bytes: &[u8]) -> f64 {
    let (common, _, _) = GB18030.encode(&PLAUSIBLE.hanzi);
    let common: HashSet<&[u8]> = common.chunks(2).collect();
    let mut total = 0.0;
    let mut at = 0;
    while at < bytes.len() {
        let lead = bytes[at];
        if lead.is_ascii() {
            at += 1;
            continue;
        }
        if matches!(lead, 0x80 | 0xFF) {
            return f64::INFINITY;
        }
        let Some(&trail) = bytes.get(at + 1) else { return total };
        total += match (lead, trail) {
            (_, b'0'..=b'9') => 20.0,
            (_, 0x00..=0x3F | 0x7F | 0xFF) => return f64::INFINITY,
            (_, 0x40..=0xA0) | (0x81..=0xA0, _) => 15.0,
            (0xA1..=0xA3, _) => 7.6,
            _ if common.contains(&bytes[at..at + 2]) => 6.0,
            (0xB0..=0xD7, _) => COMMON,
            _ => 12.8,
        };
        at += if trail.is_ascii_digit() { 4 } else { 2 };
    }
    total
}

/// The character of each byte, and its surprise.
fn byte_table(encoding: &'static encoding_rs::Encoding, surprise: impl Fn(char) -> f64) -> Vec<(char, f64)> {
    let entry = |byte: u8| {
        let (text, _) = encoding.decode_without_bom_handling(std::slice::from_ref(&byte));
        let character = text.chars().next().unwrap_or('\0');
        (character, if byte.is_ascii() { 0.0 } else { surprise(character) })
    };
    (0..=255).map(entry).collect()
}

/// The bytes before and after a byte; 0 at the ends.
fn neighbours(bytes: &[u8], at: usize) -> (u8, u8) {
    (at.checked_sub(1).map_or(0, |at| bytes[at]), bytes.get(at + 1).copied().unwrap_or(0))
}

fn is_letter(character: char) -> bool {
    character.is_uppercase() || character.is_lowercase()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn programs_are_read_as_what_they_are() {
        #[derive(Deserialize)]
        struct Case {
            encoding: String,
            text: String,
            bytes: String,
        }
        let cases: Vec<Case> = serde_json::from_str(include_str!("../../tests/encodings.json")).unwrap();
        for case in cases {
            let byte = |hex: &[u8]| u8::from_str_radix(std::str::from_utf8(hex).unwrap(), 16).unwrap();
            let bytes: Vec<u8> = case.bytes.as_bytes().chunks(2).map(byte).collect();
            let (text, encoding) = decode(bytes.clone());
            let text = String::from_utf8(text).unwrap();
            assert_eq!(text.trim_start_matches('\u{feff}'), case.text);
            assert_eq!(
                encoding.name().to_lowercase().replace('-', ""),
                case.encoding.replace("-no-bom", "").replace("-bom", "").replace('-', "")
            );
            assert_eq!(encoding.encode(&text).as_deref(), Some(bytes.as_slice()));
        }
    }
}
