//! `check`: reports errors and warnings in programs, from files, folders and standard input.
//!
//! In: the arguments of `check`. Out: the findings in one of several formats, and the exit status: 0 if
//! nothing fails, 1 for errors (or more warnings than allowed), 2 for bad usage or a file that cannot be read
//! or written; the other files are still reported. `paths` finds the files, `job` checks them, `pages` checks
//! the programs in a page of a manual, `selection` decides which findings count, `baseline` which are known,
//! `reports` formats them; `fixes` shows what `--fix` would change. All other options can be combined:
//! repaired programs and pages are reported like any other file.

mod baseline;
mod finding;
mod fixes;
mod job;
mod pages;
pub(super) mod paths;
mod reports;
mod selection;
#[cfg(not(target_arch = "wasm32"))]
mod watch;

use std::path::{Path, PathBuf};

use super::Status;
use super::configuration::{self, Configurations};
use super::options::{LanguageOptions, ProgramOptions};
use super::system::{self, Stream};
use crate::sentences::Language;
use job::Job;
use reports::{Report, ReportOptions};

pub(super) use reports::{Colour, ReportFormat};
pub(super) use selection::Selection;

/// The arguments of `check`.
#[derive(clap::Args)]
#[command(
    after_help = "Exit status:\n  0  no errors\n  1  errors, or more warnings than `--max-warnings` allows; with `--diff`, repairs\n  2  bad usage, or a file that cannot be read or written"
)]
pub(super) struct Check {
    /// Programs, and folders with programs in them; `-` reads standard input.
    #[arg(required = true)]
    files: Vec<PathBuf>,
    #[command(flatten)]
    with: ProgramOptions,
    #[command(flatten)]
    texts: LanguageOptions,
    /// How findings are written.
    #[arg(long, value_enum, default_value = "text")]
    format: ReportFormat,
    /// Where to write them; standard output by default.
    #[arg(short, long)]
    output_file: Option<PathBuf>,
    /// Whether text is coloured. `auto`: on a terminal, unless the environment variable NO_COLOR is set.
    #[arg(long, value_enum, default_value = "auto")]
    color: Colour,
    /// The address of the rule pages, a folder `rules` of the site: reports then link to the page of each rule.
    #[arg(long, value_name = "ADDRESS", value_parser = configuration::web_address)]
    rules_url: Option<String>,
    /// Write findings alone: no summary, no notes.
    #[arg(short, long)]
    quiet: bool,
    /// Write how often each rule was found instead of the findings.
    #[arg(long)]
    statistics: bool,
    #[command(flatten)]
    which: paths::Which,
    #[command(flatten)]
    selection: selection::Choice,
    #[command(flatten)]
    baseline: baseline::BaselineOptions,
    /// Exit status 0 even if there are findings or repairs; still 2 for bad usage and files that cannot be read.
    #[arg(long)]
    exit_zero: bool,
    /// The name that findings in standard input have.
    #[arg(long, value_name = "NAME")]
    stdin_filename: Option<String>,
    /// Make all repairs that do not change what the program does, and write the files back;
    /// what is left is reported.
    #[arg(long)]
    fix: bool,
    /// Show the repairs of `--fix` as a unified diff instead of the findings, and write no file; exit status 1 if
    /// there are any.
    #[arg(long, conflicts_with_all = ["fix", "markdown", "format", "statistics", "baseline", "write_baseline", "max_warnings"])]
    diff: bool,
    /// The files are pages of a manual (Markdown, HTML or reStructuredText, by their endings): every program
    /// in them is checked, and messages name its place in the page.
    #[arg(long, conflicts_with_all = ["fix", "library"])]
    markdown: bool,
    /// With `--fix`: print the repaired programs instead, and report what is left on standard error.
    #[arg(long, requires = "fix")]
    dry_run: bool,
    /// Check again whenever a file changes, until Ctrl C.
    #[cfg(not(target_arch = "wasm32"))]
    #[arg(short, long)]
    watch: bool,
}

/// Runs `check`.
pub(super) fn run(check: &Check) -> Result<Status, String> {
    #[cfg(not(target_arch = "wasm32"))]
    if check.watch {
        return watch::run(check).map(|never| match never {});
    }
    once(check)
}

/// Default endings of files in folders.
fn usual_endings(check: &Check) -> &'static [&'static str] {
    if check.markdown { paths::PAGES } else { paths::PROGRAMS }
}

impl Check {
    /// Refuses an output that would overwrite a program, and a table where XML is requested.
    fn refuse_what_would_be_lost(&self, files: &[PathBuf]) -> Result<(), String> {
        for output in self.output_file.iter().chain(self.baseline.output()) {
            let is_output = system::same_as(output);
            if files.iter().any(|file| is_output(file)) {
                return Err(format!("{}: is checked, so nothing else is written into it", output.display()));
            }
        }
        match self.format {
            ReportFormat::Text | ReportFormat::Json => Ok(()),
            _ if self.statistics => Err("`--statistics` is written as `--format text` or `json`".to_owned()),
            _ => Ok(()),
        }
    }
}

/// Runs the check once.
fn once(check: &Check) -> Result<Status, String> {
    let configurations = Configurations::new(&check.with)?;
    // Settings of the whole check come from the configuration of the working directory.
    let here = configurations.of(Path::new("program"))?;
    let keys = here.as_ref().map(|one| &one.keys);
    let language = keys.and_then(|keys| keys.language.as_ref()).map(|said| said.value);
    let language = check.texts.given().or(language).unwrap_or(Language::English);
    let rules_url = keys.and_then(|keys| Some(keys.rules_url.as_ref()?.value.clone()));
    let found = paths::find(&check.files, &check.which, usual_endings(check), &configurations)?;
    check.refuse_what_would_be_lost(&found.files)?;
    let has_standard_input = found.files.iter().any(|file| file == Path::new("-"));
    let known = keys.and_then(|keys| keys.baseline.as_ref()).zip(here.as_ref());
    let known = known.map(|(said, configuration)| configuration.file(&said.value));
    let job = Job {
        check,
        selection: Selection::new(&check.selection)?,
        known: check.baseline.read(known.as_deref())?,
        allowed: check
            .selection
            .max_warnings
            .or(keys.and_then(|keys| Some(keys.max_warnings.as_ref()?.value))),
        report_to: match check.fix && (check.dry_run || has_standard_input) {
            // Standard output contains the repaired programs.
            true => Stream::Error,
            false => Stream::Output,
        },
        report: Report::new(ReportOptions {
            format: check.format,
            colour: check.color,
            to_file: check.output_file.is_some(),
            language,
            rules_url: check.rules_url.clone().or(rules_url),
            statistics: check.statistics,
            quiet: check.quiet,
            is_lone: found.files.len() == 1,
            are_pages: check.markdown,
        }),
        language,
        configurations,
    };
    if check.diff { fixes::run(&job, &found) } else { job.run(&found) }
}
