//! Subprograms in separate files: `M98 P2000` calls `O2000.nc` in the folder of the program or in a library.
//!
//! In: a program and folders. Out: the program, then the subprograms that it calls and does not contain, each once, as a
//! control has them all in its memory. Must not know what is done with the program.

use std::collections::BTreeSet;
use std::ffi::OsStr;
use std::ops::Range;
use std::path::{Path, PathBuf};

use super::encoding;
use super::system::{self, PathKind};
use crate::control::program::calls_elsewhere;
use crate::text::block::{Block, BlockKind};
use crate::text::parser::Parser;

/// The endings of program files.
pub(super) const ENDINGS: &[&str] = &[
    "nc", "cnc", "ncc", "ngc", "gcode", "gc", "tap", "dnc", "eia", "iso", "prg", "pgm", "pim", "min", "mpf",
    "spf",
];

/// Most files that are added to a program.
const MOST_FILES: usize = 100;

/// A program with its subprograms.
pub(super) struct Joined {
    /// The program up to the sign that ends its tape, then the subprograms.
    pub text: Vec<u8>,
    /// Bytes of the program itself.
    pub own: usize,
}

/// Appends the subprograms to a program, at most `most` bytes in all; `None` if none is missing or found.
pub(super) fn join(text: &[u8], folders: &[PathBuf], most: usize) -> Option<Joined> {
    if !may_call(text) {
        return None;
    }
    let (mut joined, mut looked_for, mut files) = (Vec::new(), BTreeSet::new(), 0);
    let mut own = 0;
    loop {
        let read = if joined.is_empty() { text } else { &joined[..] };
        let missing = calls_elsewhere(read).into_iter().filter(|(number, _)| looked_for.insert(*number));
        let missing: Vec<(u32, String)> = missing.map(|(number, word)| (number, word.quote(read))).collect();
        let before = files;
        for (number, word) in missing {
            let Some(program) = folders.iter().find_map(|folder| find(number, &word, folder, most)) else {
                continue;
            };
            if joined.is_empty() {
                joined = text[..extent(text).end].to_vec();
                own = joined.len();
            }
            if files == MOST_FILES || joined.len() + program.len() >= most {
                break;
            }
            if !joined.ends_with(b"\n") {
                joined.push(b'\n');
            }
            joined.extend(program);
            files += 1;
        }
        if files == before {
            break;
        }
    }
    (files > 0).then_some(Joined { text: joined, own })
}

/// Whether a text may call anything: it has M98, M198, G65 or G66.
fn may_call(text: &[u8]) -> bool {
    text.windows(2).enumerate().any(|(at, code)| {
        let before = &text[at.saturating_sub(4)..at];
        let letter = before.iter().rev().find(|byte| !matches!(byte, b'0' | b'1' | b' '));
        matches!(code, b"98" | b"65" | b"66") && matches!(letter, Some(b'M' | b'm' | b'G' | b'g'))
    })
}

/// The program of a number in a folder; `word` is how the call names it.
fn find(number: u32, word: &str, folder: &Path, most: usize) -> Option<Vec<u8>> {
    let name = word.strip_prefix('<').and_then(|name| name.strip_suffix('>')).map(str::trim);
    let is_named_so = |file: &OsStr| {
        let file = Path::new(file);
        let ending = file.extension().and_then(OsStr::to_str).unwrap_or_default();
        let is_program = ENDINGS.iter().chain(&["txt", ""]).any(|one| ending.eq_ignore_ascii_case(one));
        let stem = file.file_stem().and_then(OsStr::to_str).unwrap_or_default();
        let digits = stem.strip_prefix(['O', 'o']).unwrap_or(stem);
        let has_number = digits.bytes().all(|byte| byte.is_ascii_digit()) && digits.parse() == Ok(number);
        is_program && name.map_or(has_number, |name| stem.eq_ignore_ascii_case(name))
    };
    let head = name.map_or_else(|| format!("O{number:04}"), |_| word.to_owned());
    let entries = system::entries(folder).ok()?.into_iter();
    entries.filter(|entry| entry.kind == PathKind::File && is_named_so(&entry.name)).find_map(|entry| {
        let (text, _) = encoding::decode(system::read(&folder.join(entry.name), most as u64).ok()?);
        program_of(&text, number, &head)
    })
}

/// The programs of a file, which must contain that of the number, or no head; then `head` is put before it.
fn program_of(text: &[u8], number: u32, head: &str) -> Option<Vec<u8>> {
    let (mut parser, mut block, mut heads) = (Parser::new(text), Block::default(), Vec::new());
    while parser.next_block(&mut block) {
        heads.extend(block.program.into_iter().chain(block.second_name).map(|(number, _)| number));
    }
    let body = &text[extent(text)];
    match () {
        () if heads.contains(&number) => Some([body, b"\n"].concat()),
        () if heads.is_empty() => Some([head.as_bytes(), b"\n", body, b"\n"].concat()),
        () => None,
    }
}

/// Where the programs of a tape are: after the first sign `%` and before the last one.
fn extent(text: &[u8]) -> Range<usize> {
    let (mut parser, mut block) = (Parser::new(text), Block::default());
    let (mut own, mut begun) = (0..text.len(), false);
    while parser.next_block(&mut block) {
        match block.kind {
            BlockKind::Percent if begun => own.end = block.span.start as usize,
            BlockKind::Percent => own.start = block.span.end as usize,
            BlockKind::Words | BlockKind::Macro => begun |= !block.is_empty(),
        }
    }
    if own.end == text.len() {
        // `M30%`
        let filled = text.trim_ascii_end();
        own.end = filled.strip_suffix(b"%").map_or(own.end, <[u8]>::len);
    }
    own.start.min(own.end)..own.end
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_has_the_program_that_is_called() {
        let program = |text: &str| {
            program_of(text.as_bytes(), 2000, "O2000").map(|own| String::from_utf8(own).expect("ASCII"))
        };
        assert_eq!(program("%\nO2000\nM99\n%\n").as_deref(), Some("\nO2000\nM99\n\n"));
        assert_eq!(program("O1\nM99\nO2000\nM99%\n").as_deref(), Some("O1\nM99\nO2000\nM99\n"));
        assert_eq!(program("G01 W-1.\nM99").as_deref(), Some("O2000\nG01 W-1.\nM99\n"));
        assert_eq!(program("O2001\nM99\n"), None);
    }

    #[test]
    fn what_calls_nothing_is_not_read() {
        for text in ["M98 P1", "m098P1", "G65 P1", "G 66 P1", "M198 P1"] {
            assert!(may_call(text.as_bytes()), "{text}");
        }
        assert!(!may_call(b"O1\nG01 X98. Z-65.66\nX1665\nM30\n"));
    }
}
