//! `check --fix`: all safe repairs, files written back in their encoding.
//!
//! What was repaired goes to standard error, by the lines of the file as it was; then
//! what is left is reported.

use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use super::{Format, With, encoded, encoding, has_errors, print, read, run_text, save, setup_of, tell};
use crate::repair::repaired;
use crate::sentences::Language;
use crate::source::LineIndex;

/// Where the repaired programs go.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Target {
    /// Into their files; that of standard input to standard output.
    File,
    /// To standard output.
    Output,
}

/// Repairs programs, one after the other.
pub(super) fn files(
    files: &[PathBuf],
    with: &With,
    language: Language,
    format: Format,
    target: Target,
) -> Result<ExitCode, String> {
    let mut any_error = false;
    let setup = setup_of(with)?;
    for file in files {
        let (name, text) = read(file)?;
        let (text, encoding) = encoding::decode(text);
        let repaired = repaired(&text, &setup);
        let lines = LineIndex::new(&text);
        for taken in &repaired.taken {
            eprintln!("{name}:{}: {}", lines.line_of(taken.span.start) + 1, taken.title.words(language));
        }
        let program = run_text(name, repaired.text, encoding, setup.clone(), |run| run);
        any_error |= has_errors(&program.analysis);
        let to_output = target == Target::Output || file == Path::new("-");
        if to_output || !repaired.taken.is_empty() {
            let text = String::from_utf8_lossy(&program.text);
            save(Some(file.as_path()).filter(|_| !to_output), &encoded(&program, &text))?;
        }
        if to_output {
            let mut told = Vec::new();
            tell(&mut told, &program, language, format)
                .and_then(|()| io::stderr().write_all(&told))
                .map_err(|error| format!("standard error: {error}"))?;
        } else {
            print(|out| tell(out, &program, language, format))?;
        }
    }
    Ok(ExitCode::from(u8::from(any_error)))
}
