//! A megabyte of a single character, also of characters that no program contains.

use super::{Hostile, case, megabyte};

/// A program for each of these characters.
pub fn one_sign() -> Vec<Hostile> {
    let signs = [
        ("E-PLAIN-TEXT", "[]:+NOGMXL"),
        ("W-PLAIN-TEXT", ",-*="),
        ("PS0009", "){}<>.!?&|\"'\\@$^_~外"),
        ("I-EMPTY", ";/% \t"),
        ("W-COMMENT-OPEN", "("),
        ("PS0114", "#"),
        ("PS0004", "0"),
    ];
    let of_one = |(code, signs): (&'static str, &'static str)| {
        signs.chars().map(move |sign| case(format!("`{sign}`"), megabyte(&sign.to_string()), code, 1))
    };
    let mut all: Vec<Hostile> = signs.into_iter().flat_map(of_one).collect();
    let bytes =
        |name, code, line, bytes: &[u8]| case(name, bytes.repeat((1 << 20) / bytes.len()), code, line);
    all.extend([
        bytes("CR", "I-EMPTY", 1, b"\r"),
        bytes("LF", "I-EMPTY", 1, b"\n"),
        bytes("CR LF", "I-EMPTY", 1, b"\r\n"),
        bytes("NUL", "I-EMPTY", 1, b"\0"),
        bytes("end of a DOS file", "I-EMPTY", 1, b"\x1A"),
        bytes("bytes that are no UTF-8", "PS0009", 1, b"\xFF"),
        bytes("the middle of a character", "PS0009", 1, b"\x80"),
        bytes("half a character", "PS0009", 1, b"\xE5\xA4"),
        bytes("X and half a character", "E-PLAIN-TEXT", 1, b"X\xE5\xA4"),
        bytes("byte order marks", "I-EMPTY", 1, b"\xEF\xBB\xBF"),
        bytes("UTF-16", "W-NO-END", 174763, b"X\x001\x00\n\x00"),
        bytes("words in one line that is not ASCII", "W-NO-END", 1, "(外)X1;".as_bytes()),
        bytes("faults in one line that is not ASCII", "PS0005", 1, "(外)X-;".as_bytes()),
        bytes(
            "faults in one line of ASCII, but for one sign",
            "PS0005",
            1,
            &[&b"X-;".repeat(300_000)[..], "(外)".as_bytes()].concat(),
        ),
        bytes("minus signs of print", "E-BLOCK-TOO-LONG", 1, "X−1".as_bytes()),
        bytes("words of a wide keyboard", "E-BLOCK-TOO-LONG", 1, "Ｘ１".as_bytes()),
        bytes("X45s", "PS0005", 1, b"X45s\n"),
        bytes("X45s in one line", "E-BLOCK-TOO-LONG", 1, b"X45s "),
        bytes("commas for points", "E-OCR", 1, b"X1,5\n"),
        bytes("blanks in numbers", "W-BLANK-IN-NUMBER", 1, b"X1 5\n"),
    ]);
    all
}
