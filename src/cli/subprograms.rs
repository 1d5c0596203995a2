//! Subprograms in separate files: `M98 P2000` calls `O2000.nc` in the folder of the program or in a library.
//!
//! In: a program and folders. Out: the program, followed by the subprograms that it calls but does not
//! contain, each once, as if all were in the memory of a control. Must not know what is done with the
//! program.

use std::collections::{BTreeMap, BTreeSet};
use std::ffi::OsStr;
use std::ops::Range;
use std::path::PathBuf;

use super::encoding;
use super::system::{self, PathKind};
use crate::control::program::{calls_elsewhere, may_call};
use crate::run::subprograms::Joined;
use crate::source::Span;
use crate::text::block::{Block, BlockKind};
use crate::text::parser::Parser;

/// Endings of program files.
pub(super) const ENDINGS: &[&str] = &[
    "nc", "cnc", "ncc", "ngc", "gcode", "gc", "tap", "dnc", "eia", "iso", "prg", "pgm", "pim", "min", "mpf",
    "spf",
];

/// Maximum number of files added to a program.
const MAX_FILES: usize = 100;

/// Maximum number of programs searched for; each search may read files.
const MAX_SEARCHES: usize = 1000;

/// Appends the missing subprograms to a program, at most `most` bytes in all; `None` if none is missing or
/// none is found.
pub(super) fn join(text: &[u8], folders: &[PathBuf], most: usize) -> Option<Joined> {
    if !may_call(text) {
        return None;
    }
    let mut joined = Joined::new(&text[..extent(text).end]);
    let (mut looked_for, mut library) = (BTreeSet::new(), None);
    loop {
        let missing = calls_elsewhere(&joined.text)
            .into_iter()
            .filter(|(number, _)| looked_for.len() < MAX_SEARCHES && looked_for.insert(*number));
        let missing: Vec<(u32, Span, String)> =
            missing.map(|(number, word)| (number, word, word.quote(&joined.text))).collect();
        let before = joined.added();
        for (number, word, written) in missing {
            let library = library.get_or_insert_with(|| Library::of(folders));
            let Some(program) = library.find(number, &written, most) else { continue };
            if joined.added() == MAX_FILES || joined.text.len() + program.len() >= most {
                break;
            }
            joined.append(&program, word);
        }
        if joined.added() == before {
            break;
        }
    }
    (joined.added() > 0).then_some(joined)
}

/// The program files of folders, in the order of the folders.
struct Library {
    /// By file name without the ending, in lower case.
    by_stem: BTreeMap<String, Vec<PathBuf>>,
    /// By the number in the file name.
    by_number: BTreeMap<u32, Vec<PathBuf>>,
}

impl Library {
    /// Lists the files of each folder once.
    fn of(folders: &[PathBuf]) -> Self {
        let (mut by_stem, mut by_number) = (BTreeMap::new(), BTreeMap::new());
        for folder in folders {
            let entries = system::entries(folder).unwrap_or_default().into_iter();
            for entry in entries.filter(|entry| entry.kind == PathKind::File) {
                let path = folder.join(entry.name);
                let ending = path.extension().and_then(OsStr::to_str).unwrap_or_default();
                let is_program =
                    ENDINGS.iter().chain(&["txt", ""]).any(|one| ending.eq_ignore_ascii_case(one));
                let Some(stem) = path.file_stem().and_then(OsStr::to_str).filter(|_| is_program) else {
                    continue;
                };
                let (stem, digits) =
                    (stem.to_ascii_lowercase(), stem.strip_prefix(['O', 'o']).unwrap_or(stem));
                let number = digits.bytes().all(|byte| byte.is_ascii_digit()).then(|| digits.parse().ok());
                if let Some(number) = number.flatten() {
                    by_number.entry(number).or_insert_with(Vec::new).push(path.clone());
                }
                by_stem.entry(stem).or_insert_with(Vec::new).push(path);
            }
        }
        Self { by_stem, by_number }
    }

    /// Finds a program by its number; `word` is its name in the call.
    fn find(&self, number: u32, word: &str, most: usize) -> Option<Vec<u8>> {
        let name = word.strip_prefix('<').and_then(|name| name.strip_suffix('>')).map(str::trim);
        let (files, head) = match name {
            Some(name) => (self.by_stem.get(&name.to_ascii_lowercase()), word.to_owned()),
            None => (self.by_number.get(&number), format!("O{number:04}")),
        };
        files?.iter().find_map(|file| {
            let (text, _) = encoding::decode(system::read(file, most as u64).ok()?);
            program_of(&text, number, &head)
        })
    }
}

/// The programs of a file, one of which must have the number, or none a program number; then `head` is put
/// before it.
fn program_of(text: &[u8], number: u32, head: &str) -> Option<Vec<u8>> {
    let (mut parser, mut block, extent) = (Parser::new(text), Block::default(), extent(text));
    // A program number before the `%` belongs to the first program after it.
    let (mut before, mut heads) = (Vec::new(), Vec::new());
    while parser.next_block(&mut block) {
        let is_inside = block.span.start as usize >= extent.start;
        let found = if is_inside { &mut heads } else { &mut before };
        found.extend(block.program.into_iter().chain(block.second_name).map(|(number, _)| number));
    }
    let body = &text[extent];
    match () {
        () if heads.contains(&number) => Some([body, b"\n"].concat()),
        () if before.contains(&number) || before.is_empty() && heads.is_empty() => {
            Some([head.as_bytes(), b"\n", body, b"\n"].concat())
        }
        () => None,
    }
}

/// The range between the first `%` of a text and the `%` that ends its program.
fn extent(text: &[u8]) -> Range<usize> {
    let (mut parser, mut block) = (Parser::new(text), Block::default());
    let mut own = 0..text.len();
    while parser.next_block(&mut block) {
        match block.kind {
            BlockKind::Percent if parser.ended() => own.end = block.span.start as usize,
            BlockKind::Percent => own.start = block.span.end as usize,
            BlockKind::Words | BlockKind::Macro => {}
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
        // A program number before the `%`.
        assert_eq!(program("O2000\n%\nM99\n%\n").as_deref(), Some("O2000\n\nM99\n\n"));
        assert_eq!(program("O2000\n%\nM99\n").as_deref(), Some("O2000\n\nM99\n\n"));
        assert_eq!(program("O2001\n%\nM99\n%\n"), None);
    }

    #[test]
    fn a_program_ends_at_the_sign_that_the_parser_stops_at() {
        let own = |text: &str| text[extent(text.as_bytes())].to_owned();
        assert_eq!(own("%\nO1\nM30\n%\nO2\n"), "\nO1\nM30\n");
        assert_eq!(own("O1\n%\nM30\n"), "\nM30\n");
        assert_eq!(own("O1\n%\nM30\n%\nO2\n"), "\nM30\n");
    }

    #[test]
    fn a_bounded_number_of_programs_is_searched_for() {
        let calls: String = (1..=3000).map(|number| format!("M98 P{number}\n")).collect();
        let folder = std::env::temp_dir().join(format!("subprograms-{}", std::process::id()));
        std::fs::create_dir_all(&folder).expect("a folder");
        for number in 1..=2000 {
            std::fs::write(folder.join(format!("O{number:04}.nc")), "M99\n").expect("a file");
        }
        let started = std::time::Instant::now();
        let joined = join(calls.as_bytes(), std::slice::from_ref(&folder), 1 << 20).expect("subprograms");
        let took = started.elapsed();
        std::fs::remove_dir_all(&folder).expect("it goes");
        assert_eq!(joined.added(), MAX_FILES);
        assert!(took.as_secs() < 2, "{took:?}");
    }
}
