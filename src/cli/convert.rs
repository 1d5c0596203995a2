//! `convert`: writes coordinates, arcs, cycles, lengths or codes in another form, in place.
//!
//! In: a program. Out: the program in that form, with the same motions; on standard error how many words stay.

use std::path::PathBuf;

use super::Status;
use super::change::{Output, Source};
use super::configuration::Configurations;
use super::options::ProgramOptions;
use super::system::print_error_line;
use crate::convert::{ProgramForm, converted};
use crate::message::applied;

/// The arguments of `convert`.
#[derive(clap::Args)]
#[command(
    after_help = "Exit status:\n  0  written, or nothing to change\n  1  something would change, with `--check` or `--diff`\n  2  bad usage, or a file that cannot be read or written"
)]
pub(super) struct Convert {
    /// The program; `-` reads standard input and writes to standard output.
    file: PathBuf,
    /// The form to write.
    #[arg(long)]
    to: ProgramForm,
    #[command(flatten)]
    with: ProgramOptions,
    #[command(flatten)]
    output: Output,
}

/// Runs `convert`.
pub(super) fn run(convert: &Convert) -> Result<Status, String> {
    let source = Source::read(&convert.file, &Configurations::new(&convert.with)?)?;
    let found = converted(source.run_text(), source.own(), &source.setup, convert.to);
    let changed = (!found.edits.is_empty()).then(|| applied(&source.text, &found.edits));
    if let Some(first) = found.left.first() {
        let count = found.left.len();
        let (word, place) = (first.quote(source.run_text()), source.place(*first));
        print_error_line(format_args!("{place}: `{word}` stays ({count} in all)"));
    }
    convert.output.write(&source, changed.as_deref())?;
    Ok(Status::differing_if(changed.is_some() && !convert.output.writes()))
}
