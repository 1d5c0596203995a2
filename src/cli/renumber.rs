//! `renumber`: writes new sequence numbers, in place.
//!
//! In: a program. Out: the program with the new numbers, or the reason why they stay, with its place.

use std::path::PathBuf;

use super::Status;
use super::change::{Output, Source};
use super::configuration::Configurations;
use super::options::ProgramOptions;
use crate::renumber::{self, Blocks, Numbering, Refused, edits};
use crate::run::analyze;
use crate::sentences::Language;

/// The arguments of `renumber`.
#[derive(clap::Args)]
#[command(
    after_help = "Exit status:\n  0  written, or nothing to change\n  1  something would change, with `--check` or `--diff`\n  2  bad usage, a file that cannot be read or written, or a program whose numbers stay"
)]
pub(super) struct Renumber {
    /// The program; `-` reads standard input and writes to standard output.
    file: PathBuf,
    #[command(flatten)]
    with: ProgramOptions,
    /// The number of the first block of each program.
    #[arg(long, value_name = "N", default_value_t = 10, value_parser = clap::value_parser!(u32).range(1..))]
    from: u32,
    /// The difference between the numbers of two blocks.
    #[arg(long, value_name = "N", default_value_t = 10, value_parser = clap::value_parser!(u32).range(1..))]
    step: u32,
    /// Number every block, instead of those that have a number.
    #[arg(long)]
    all: bool,
    /// Remove the numbers that nothing refers to, instead.
    #[arg(long, conflicts_with_all = ["from", "step", "all"])]
    remove: bool,
    #[command(flatten)]
    output: Output,
}

impl Renumber {
    fn numbering(&self) -> Numbering {
        let blocks = if self.all { Blocks::All } else { Blocks::Numbered };
        match self.remove {
            true => Numbering::Remove,
            false => Numbering::Ascending { from: self.from, step: self.step, blocks },
        }
    }
}

/// Runs `renumber`.
pub(super) fn run(renumber: &Renumber) -> Result<Status, String> {
    let source = Source::read(&renumber.file, &Configurations::new(&renumber.with)?)?;
    let (text, control) = (source.run_text(), source.setup.dialect.control.unwrap_or_default());
    let codes = analyze(text, &source.setup).codes;
    let input = renumber::Source { text, own: source.own(), codes, control };
    let edits = edits(input, renumber.numbering()).map_err(|refused| sentence(&source, &refused))?;
    let changed = source.changed(&edits, "renumbered")?;
    renumber.output.write(&source, changed.as_deref())?;
    Ok(Status::differing_if(changed.is_some() && !renumber.output.writes()))
}

/// Why the numbers stay: `part.nc:5: not renumbered: …`.
fn sentence(source: &Source, refused: &Refused) -> String {
    let why = refused.reason(source.run_text(), Language::English);
    format!("{}: not renumbered: {why}", source.place(refused.span))
}
