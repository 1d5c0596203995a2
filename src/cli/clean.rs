//! `clean`: lists the programs inside a text, or writes one of them.
//!
//! In: a file with any text. Out: the cleaned program; on standard error the changes, and questions that only
//! the user can answer.

use std::io::{self, Write};
use std::path::PathBuf;

use super::options::{Destination, LanguageOptions};
use super::system::Stream;
use super::{encoding, print, print_to, read, save};
use crate::api::paste::shortened;
use crate::paste::{self, Found, Name, Piece, Program};
use crate::sentences::Language;
use crate::source::LineIndex;

/// Maximum number of changes and questions that are listed.
const MAX_LISTED: usize = 1000;

/// The arguments of `clean`.
#[derive(clap::Args)]
pub(super) struct Clean {
    /// The text; `-` reads standard input.
    file: PathBuf,
    /// List the programs that are found instead of writing one.
    #[arg(long)]
    list: bool,
    /// Which of them to write, counted from 1.
    #[arg(long, default_value_t = 1)]
    program: usize,
    #[command(flatten)]
    texts: LanguageOptions,
    #[command(flatten)]
    to: Destination,
}

/// Runs `clean`.
pub(super) fn run(clean: &Clean) -> Result<(), String> {
    let (name, bytes) = read(&clean.file)?;
    let (bytes, from) = encoding::decode(bytes);
    let text = String::from_utf8_lossy(&bytes);
    let found = paste::find(&text);
    if found.too_long {
        return Err(format!("{name}: the text is longer than {} MB", crate::limits::MAX_PASTED_TEXT >> 20));
    }
    if clean.list {
        return print(|out| list(out, &found));
    }
    let Some(program) = clean.program.checked_sub(1).and_then(|at| found.programs.get(at)) else {
        return Err(match found.programs.len() {
            0 => format!("{name}: no program is found"),
            count => format!("{name}: there is no program {}; {count} are found", clean.program),
        });
    };
    let language = clean.texts.language();
    print_to(Stream::Error, |out| print_report(out, &name, &text, program, language))?;
    let cleaned = program.text();
    let bytes = from.encode(&cleaned).unwrap_or_else(|| cleaned.as_bytes().into());
    save(clean.to.file(), &bytes)
}

fn list(out: &mut dyn Write, found: &Found) -> io::Result<()> {
    for (at, program) in found.programs.iter().enumerate() {
        let (first, last) = (program.lines.0 + 1, program.lines.1 + 1);
        let (changes, questions) = (program.changes().count(), program.questions().count());
        let name = match &program.name {
            Name::Number(number) => format!("O{number:04}"),
            Name::Title(title) => title.clone(),
            Name::Line(line) => format!("line {}", line + 1),
        };
        writeln!(out, "{}\tlines {first}-{last}\t{changes} changes\t{questions} questions\t{name}", at + 1)?;
    }
    if found.more > 0 {
        writeln!(out, "and {} more, which are not listed", found.more)?;
    }
    Ok(())
}

/// Lists the changes and the questions, at most [`MAX_LISTED`].
fn print_report(
    out: &mut dyn Write,
    name: &str,
    text: &str,
    program: &Program,
    language: Language,
) -> io::Result<()> {
    let lines = LineIndex::new(text.as_bytes());
    let mut listed = program.pieces.iter().filter_map(|piece| Some((piece, piece.reason?)));
    for (piece, reason) in listed.by_ref().take(MAX_LISTED) {
        let place = lines.line_column(text.as_bytes(), piece.span.start);
        let (line, column) = (place.line + 1, place.column + 1);
        writeln!(out, "{name}:{line}:{column}: {}{}", reason.phrase(language), quoted(text, piece))?;
    }
    match listed.count() {
        0 => Ok(()),
        more => writeln!(out, "{name}: {more} more, which are not listed"),
    }
}

/// The old and the new text of a piece, shortened.
fn quoted(text: &str, piece: &Piece) -> String {
    let was = &text[piece.span.start as usize..piece.span.end as usize];
    if piece.is_question() {
        return format!(": {}", piece.choices.join(" / "));
    }
    match (was.trim(), piece.now.trim()) {
        ("", "") => String::new(),
        (was, "") => format!(": {}", shortened(was)),
        (was, now) => format!(": {} -> {now}", shortened(was)),
    }
}
