//! `format`: writes programs uniformly, in place.
//!
//! In: files and folders. Out: the formatted files, and the number of them on standard error.

use std::path::{Path, PathBuf};

use super::change::{Output, Source};
use super::check::paths;
use super::configuration::Configurations;
use super::options::ProgramOptions;
use super::system::print_error_line;
use super::{NAME, Status, counted};
use crate::format::edits;

/// The arguments of `format`.
#[derive(clap::Args)]
#[command(
    after_help = "Exit status:\n  0  written, or nothing to change\n  1  something would change, with `--check` or `--diff`\n  2  bad usage, a file that cannot be read or written, or a program that stays as it is"
)]
pub(super) struct Format {
    /// Programs, and folders with programs in them; `-` reads standard input and writes to standard output.
    #[arg(required = true)]
    files: Vec<PathBuf>,
    #[command(flatten)]
    with: ProgramOptions,
    #[command(flatten)]
    output: Output,
    #[command(flatten)]
    which: paths::Which,
}

/// Runs `format`.
pub(super) fn run(format: &Format) -> Result<Status, String> {
    let configurations = Configurations::new(&format.with)?;
    let found = paths::find(&format.files, &format.which, paths::PROGRAMS, &configurations)?;
    if format.output.is_for_one_file() && found.files.len() != 1 {
        return Err(format!("`--output` takes one program, not {}", found.files.len()));
    }
    let mut problems = found.problems;
    let mut changed = 0;
    for file in &found.files {
        match write(format, file, &configurations) {
            Ok(is_changed) => changed += usize::from(is_changed),
            Err(problem) => problems.push(problem),
        }
    }
    problems.iter().for_each(|problem| print_error_line(format_args!("{NAME}: {problem}")));
    report(format, changed, found.files.len());
    Ok(match () {
        () if !problems.is_empty() => Status::Unusable,
        () => Status::differing_if(changed > 0 && !format.output.writes()),
    })
}

/// Formats a file; returns whether it changes.
fn write(format: &Format, file: &Path, configurations: &Configurations<'_>) -> Result<bool, String> {
    let source = Source::read(file, configurations)?;
    let changed = source.changed(&edits(&source.text), "formatted")?;
    format.output.write(&source, changed.as_deref())?;
    Ok(changed.is_some())
}

/// Prints how many files were formatted, if they were written in place.
fn report(format: &Format, changed: usize, count: usize) {
    let is_in_place = format.output.writes() && !format.output.is_for_one_file();
    if is_in_place && format.files != [Path::new("-")] {
        print_error_line(format_args!("{NAME}: {} of {} formatted", changed, counted(count, "program")));
    }
}
