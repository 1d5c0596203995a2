//! `check`: reports errors and warnings in programs, from files, folders and standard input.
//!
//! In: the arguments of `check`. Out: the findings in one of several formats, and the exit status: 0 if
//! nothing fails, 1 for errors (or more warnings than allowed), 2 for bad usage or a file that cannot be read
//! or written; the other files are still reported. `paths` finds the files, `pages` checks the programs in a
//! page of a manual, `selection` decides which findings count, `baseline` which are known, `reports` formats
//! them. All options can be combined: repaired programs and pages are reported like any other file.

mod baseline;
mod finding;
mod pages;
mod paths;
mod reports;
mod selection;
#[cfg(not(target_arch = "wasm32"))]
mod watch;

use std::collections::{BTreeMap, BTreeSet};
use std::io::{self, Write};
use std::mem;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc;
use std::thread;

use super::configuration::{Configurations, Settings};
use super::manual_page::Page;
use super::options::{Texts, With};
use super::subprograms::{self, Joined};
use super::system::{self, Stream, print_error_line};
use super::{
    NAME, Status, encoded, encoding, read_within, run_at_control, run_text, save, save_apart, terminal,
};
use crate::api::InferredStock;
use crate::limits;
use crate::message::{Diagnostic, Severity, said, sort_by_place};
use crate::repair::repaired_of;
use crate::sentences::Language;
use crate::source::{LineIndex, only_line_end};
use baseline::Baseline;
use finding::{Finding, Programs, Subject, What};
use reports::{Counts, Report, ReportOptions};
use selection::Selection;

pub(super) use reports::{Colour, ReportFormat};

/// Stack size of a worker thread, bytes: the same as for a main thread.
const STACK: usize = 8 << 20;
/// Maximum number of files that are checked but not yet written.
const MAX_UNWRITTEN: usize = 256;

/// The arguments of `check`.
#[derive(clap::Args)]
#[command(
    after_help = "Exit status:\n  0  no errors\n  1  errors, or more warnings than `--max-warnings` allows\n  2  bad usage, or a file that cannot be read or written"
)]
pub(super) struct Check {
    /// Programs, and folders with programs in them; `-` reads standard input.
    #[arg(required = true)]
    files: Vec<PathBuf>,
    #[command(flatten)]
    with: With,
    #[command(flatten)]
    texts: Texts,
    /// How findings are written.
    #[arg(long, value_enum, default_value = "text")]
    format: ReportFormat,
    /// Where to write them; standard output when left out.
    #[arg(short, long)]
    output_file: Option<PathBuf>,
    /// Whether text is coloured. `auto`: on a terminal, unless the environment variable NO_COLOR is set.
    #[arg(long, value_enum, default_value = "auto")]
    color: Colour,
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
    baseline: baseline::Files,
    /// The name that findings in standard input have.
    #[arg(long, value_name = "NAME")]
    stdin_filename: Option<String>,
    /// Make all repairs that do not change what the program does, and write the files back;
    /// what is left is reported.
    #[arg(long)]
    fix: bool,
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

/// Outcome for one file.
enum Checked {
    /// The file was checked.
    Done(Done),
    /// The file could not be read.
    Unreadable(String),
}

/// A checked file.
struct Done {
    /// Its part of the report.
    text: Vec<u8>,
    /// Its counts, without known findings.
    counts: Counts,
    /// Entries of all its findings, for `--write-baseline`.
    entries: Vec<baseline::Entry>,
    /// Descriptions of the repairs, one line each.
    repaired: Vec<String>,
    /// The repaired program, if it is to be printed.
    printed: Option<Vec<u8>>,
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
        for output in self.output_file.iter().chain(self.baseline.written()) {
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
            statistics: check.statistics,
            quiet: check.quiet,
            is_lone: found.files.len() == 1,
            are_pages: check.markdown,
        }),
        language,
        configurations,
    };
    job.run(&found)
}

/// Converts the line ends of `text` to CR LF or CR if `before` uses only this line end.
fn with_line_ends_of(before: &[u8], mut text: Vec<u8>) -> Vec<u8> {
    match only_line_end(before) {
        "\r" => text.iter_mut().filter(|byte| **byte == b'\n').for_each(|byte| *byte = b'\r'),
        "\r\n" => {
            let is_lone = |at: usize| text[at] == b'\n' && (at == 0 || text[at - 1] != b'\r');
            let ended =
                (0..text.len()).flat_map(|at| is_lone(at).then_some(b'\r').into_iter().chain([text[at]]));
            return ended.collect();
        }
        _ => {}
    }
    text
}

/// Keeps the messages of the program, and moves some messages of its subprograms to the calls: machine
/// findings, which only the joined run produces, and the first block that is not executed. All other messages
/// of a subprogram are reported when its own file is checked. `of_control`: the diagnostics before the
/// machine stage.
fn report_at_calls(diagnostics: &mut Vec<Diagnostic>, joined: &Joined, of_control: &[Diagnostic]) {
    let mut reported = BTreeSet::new();
    diagnostics.retain_mut(|diagnostic| {
        let Some(call) = joined.call(diagnostic.span) else {
            diagnostic.fixes.retain(|fix| fix.edits.iter().all(|edit| joined.is_own(edit.span)));
            return joined.is_own(diagnostic.span);
        };
        let message = &diagnostic.message;
        let (is_reported, slug) = match of_control.contains(diagnostic) {
            true => (diagnostic.is_error() || message.is::<said::ProgramNotFound>(), None),
            false => (diagnostic.severity >= Severity::Warning, Some(message.slug())),
        };
        diagnostic.span = call;
        diagnostic.fixes.clear();
        is_reported && reported.insert((call.start, slug))
    });
    sort_by_place(diagnostics);
}

/// One check of a set of files.
struct Job<'a> {
    check: &'a Check,
    configurations: Configurations<'a>,
    selection: Selection,
    known: Baseline,
    /// Maximum number of warnings; more fail the check.
    allowed: Option<usize>,
    report: Report,
    report_to: Stream,
    language: Language,
}

impl Job<'_> {
    fn run(&self, found: &paths::Found) -> Result<Status, String> {
        let mut problems = found.problems.clone();
        let mut counts = Counts::default();
        let mut entries = Vec::new();
        let body = |out: &mut dyn Write| {
            out.write_all(&self.report.begin())?;
            let mut is_first = true;
            self.in_order(&found.files, |checked| match checked {
                Checked::Done(done) => {
                    counts.add(&done.counts);
                    entries.extend(done.entries);
                    done.repaired.iter().for_each(|line| print_error_line(format_args!("{line}")));
                    if let Some(program) = done.printed {
                        save(None, &program).map_err(io::Error::other)?;
                    }
                    if !is_first && !done.text.is_empty() {
                        out.write_all(self.report.between())?;
                    }
                    is_first &= done.text.is_empty();
                    out.write_all(&done.text)
                }
                Checked::Unreadable(problem) => {
                    problems.push(problem);
                    Ok(())
                }
            })?;
            out.write_all(&self.report.end(&counts))
        };
        self.write(body)?;
        problems.dedup();
        for problem in &problems {
            print_error_line(format_args!("{NAME}: {problem}"));
        }
        if found.left_out > 0 && !self.check.markdown && !self.check.quiet {
            let files = super::counted(found.left_out, "file");
            print_error_line(format_args!(
                "{NAME}: {files} left out because of their ending or content; `--extension` chooses others"
            ));
        }
        if self.check.markdown && !self.check.quiet {
            print_error_line(format_args!("{NAME}: {}", reports::programs_of_pages(&counts)));
        }
        self.check.baseline.write(entries)?;
        let too_many = self.allowed.filter(|most| counts.warnings > *most);
        if let Some(most) = too_many {
            print_error_line(format_args!(
                "{NAME}: {} warnings; `--max-warnings` allows {most}",
                counts.warnings
            ));
        }
        Ok(match () {
            () if !problems.is_empty() => Status::Unusable,
            () => Status::faulty_if(counts.errors > 0 || too_many.is_some()),
        })
    }

    /// Writes to the requested output.
    fn write(&self, body: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> Result<(), String> {
        // A coloured report already masks text from programs.
        let is_coloured = self.report.is_coloured();
        let Some(path) = &self.check.output_file else {
            let to = self.report_to;
            return if is_coloured { super::print_bytes(to, body) } else { super::print_to(to, body) };
        };
        let mut text = Vec::new();
        let written = if is_coloured { body(&mut text) } else { body(&mut terminal::Masked(&mut text)) };
        written.map_err(|error| format!("standard output: {}", system::reason(&error)))?;
        save_apart(Some(path), &text)
    }

    /// Checks files on all processors; passes the results to `take` in the order of the files.
    fn in_order(&self, files: &[PathBuf], mut take: impl FnMut(Checked) -> io::Result<()>) -> io::Result<()> {
        let workers = system::processors().min(files.len());
        if workers < 2 {
            return files.iter().try_for_each(|file| take(self.file(file)));
        }
        let next = AtomicUsize::new(0);
        // A bounded channel limits how far checking runs ahead of writing.
        let (send, receive) = mpsc::sync_channel(MAX_UNWRITTEN);
        thread::scope(|scope| {
            for _ in 0..workers {
                let (send, next) = (send.clone(), &next);
                let work = move || {
                    loop {
                        let at = next.fetch_add(1, Ordering::Relaxed);
                        let Some(file) = files.get(at) else { return };
                        if send.send((at, self.file(file))).is_err() {
                            return;
                        }
                    }
                };
                thread::Builder::new().stack_size(STACK).spawn_scoped(scope, work)?;
            }
            drop(send);
            let mut waiting = BTreeMap::new();
            let mut due = 0;
            for (at, checked) in receive {
                waiting.insert(at, checked);
                while let Some(checked) = waiting.remove(&due) {
                    take(checked)?;
                    due += 1;
                }
            }
            Ok(())
        })
    }

    /// Checks one file.
    fn file(&self, file: &Path) -> Checked {
        self.check_file(file).map_or_else(Checked::Unreadable, Checked::Done)
    }

    fn check_file(&self, file: &Path) -> Result<Done, String> {
        let is_standard_input = file == Path::new("-");
        let given = self.check.stdin_filename.as_ref().filter(|_| is_standard_input);
        let settings = self.configurations.settings(given.map_or(file, Path::new))?;
        let (mut subject, repaired, printed) = match self.check.markdown {
            true => (self.page(file, given, &settings)?, Vec::new(), None),
            false => self.program(file, given, &settings)?,
        };
        let entries = self.check.baseline.entries(&subject);
        self.known.remove_known(&mut subject);
        let (text, counts) = self.report.subject(&subject);
        Ok(Done { text, counts, entries, repaired, printed })
    }

    /// Checks a program, after repairing it if requested.
    #[allow(clippy::type_complexity)]
    fn program(
        &self,
        file: &Path,
        given: Option<&String>,
        settings: &Settings,
    ) -> Result<(Subject, Vec<String>, Option<Vec<u8>>), String> {
        let setup = self.selection.setup(settings);
        let (mut name, bytes) = read_within(file, setup.limits.text as u64)?;
        if let Some(given) = given {
            name.clone_from(given);
        }
        let (mut text, encoding) = encoding::decode(bytes);
        let (mut lines_of_repairs, mut was_repaired) = (Vec::new(), false);
        if self.check.fix {
            let repaired = repaired_of(&text, &setup, &|found| self.selection.takes(settings, found));
            if let Some(open) = &repaired.open {
                let open = open.words(self.language);
                return Err(format!(
                    "{name}: the fixes do not come to an end; still open: {open}. The file is unchanged"
                ));
            }
            let lines = LineIndex::new(&text);
            was_repaired = !repaired.taken.is_empty();
            lines_of_repairs.extend(repaired.taken.iter().map(|taken| {
                let line = lines.line_of(taken.span.start) + 1;
                format!("{name}:{line}: {}", taken.title.words(self.language))
            }));
            text = with_line_ends_of(&text, repaired.text);
        }
        let folders = self.configurations.libraries(given.map_or(file, Path::new))?;
        let joined = subprograms::join(&text, &folders, setup.limits.text);
        let mut program = match joined {
            None => run_text(name, text, encoding, setup, |run| run),
            Some(mut joined) => {
                let run = mem::take(&mut joined.text);
                let mut program = run_at_control(name, run, encoding, setup, |run| run);
                let of_control = program.analysis.diagnostics.clone();
                program.analysis.check_at_machine();
                report_at_calls(&mut program.analysis.diagnostics, &joined, &of_control);
                program.text = text;
                program
            }
        };
        let mut printed = None;
        if self.check.fix {
            let is_printed = self.check.dry_run || file == Path::new("-");
            if is_printed || was_repaired {
                let text = String::from_utf8_lossy(&program.text);
                let bytes = encoded(&program, &text);
                match is_printed {
                    true => printed = Some(bytes.into_owned()),
                    false => save(Some(file), &bytes)?,
                }
            }
        }
        self.selection.keep(settings, &mut program.analysis.diagnostics);
        let stock = InferredStock::of(&program.analysis, self.language);
        let messages = program.analysis.diagnostics.into_iter().map(What::Message);
        let stock = stock.map(|stock| What::AssumedStock(None, stock));
        let subject = Subject {
            name: program.name,
            text: program.text,
            programs: Programs { checked: 1, left_out: 0 },
            findings: messages.chain(stock).map(|what| Finding { program: 0, what }).collect(),
        };
        Ok((subject, lines_of_repairs, printed))
    }

    /// Checks the programs of a page.
    fn page(&self, file: &Path, given: Option<&String>, settings: &Settings) -> Result<Subject, String> {
        let mut page = Page::read(file, limits::TEXT_BUFFER as u64)?;
        if let Some(given) = given {
            page.rename(given);
        }
        Ok(pages::check_page(page, settings, &self.selection, self.language))
    }
}
