//! One check of a set of files: each file is read, repaired if that is requested, run and reported.
//!
//! In: the files, the options. Out: the report in the order of the files, and the exit status. Files are
//! checked on all processors. Must not know: how findings are formatted.

use std::collections::BTreeMap;
use std::io::{self, Write};
use std::mem;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc;
use std::thread;

use super::super::configuration::{Configurations, Settings};
use super::super::encoding::{self, Encoding};
use super::super::manual_page::Page;
use super::super::subprograms;
use super::super::system::{self, Stream, print_error_line};
use super::super::{
    NAME, Status, counted, encoded, print_bytes, print_to, read_within, run_at_control, run_text, save,
    save_apart, terminal,
};
use super::baseline::{self, Baseline};
use super::finding::{Finding, Programs, Subject, What};
use super::reports::{Counts, Report, programs_of_pages};
use super::selection::Selection;
use super::{Check, pages, paths};
use crate::api::InferredStock;
use crate::limits;
use crate::repair::{Repaired, repaired_of};
use crate::sentences::Language;
use crate::setup::Setup;
use crate::source::{LineIndex, only_line_end};

/// Stack size of a worker thread, bytes: the same as for a main thread.
const STACK: usize = 8 << 20;
/// Maximum number of files that are checked but not yet written.
const MAX_UNWRITTEN: usize = 256;

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

/// A program as it was read.
pub(super) struct Source {
    /// Its name for messages.
    pub name: String,
    /// UTF-8.
    pub text: Vec<u8>,
    /// Encoding of the file.
    pub encoding: Encoding,
}

/// One check of a set of files.
pub(super) struct Job<'a> {
    /// The options.
    pub check: &'a Check,
    /// The configurations of the files.
    pub configurations: Configurations<'a>,
    /// The rules that count.
    pub selection: Selection,
    /// The known findings.
    pub known: Baseline,
    /// Maximum number of warnings; more fail the check.
    pub allowed: Option<usize>,
    /// The format of the report.
    pub report: Report,
    /// Where it is written, if not into a file.
    pub report_to: Stream,
    /// Language of messages.
    pub language: Language,
}

impl Job<'_> {
    /// Checks the files and writes the report.
    pub(super) fn run(&self, found: &paths::Found) -> Result<Status, String> {
        let mut problems = found.problems.clone();
        let mut counts = Counts::default();
        let mut entries = Vec::new();
        let body = |out: &mut dyn Write| {
            out.write_all(&self.report.begin())?;
            let mut is_first = true;
            self.in_order(
                &found.files,
                |file| self.file(file),
                |checked| match checked {
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
                },
            )?;
            out.write_all(&self.report.end(&counts))
        };
        self.write(body)?;
        self.print_problems(&mut problems, found);
        if self.check.markdown && !self.check.quiet {
            print_error_line(format_args!("{NAME}: {}", programs_of_pages(&counts)));
        }
        self.check.baseline.write(entries)?;
        let too_many = self.allowed.filter(|most| counts.warnings > *most);
        if let Some(most) = too_many {
            print_error_line(format_args!(
                "{NAME}: {} warnings; `--max-warnings` allows {most}",
                counts.warnings
            ));
        }
        Ok(self.status(&problems, counts.errors > 0 || too_many.is_some()))
    }

    /// Prints the problems with files, and the number of files that were not checked.
    pub(super) fn print_problems(&self, problems: &mut Vec<String>, found: &paths::Found) {
        problems.dedup();
        for problem in problems {
            print_error_line(format_args!("{NAME}: {problem}"));
        }
        if found.left_out > 0 && !self.check.markdown && !self.check.quiet {
            let files = counted(found.left_out, "file");
            print_error_line(format_args!(
                "{NAME}: {files} left out because of their ending or content; `--extension` chooses others"
            ));
        }
    }

    /// The exit status, if there are problems with files, or the check fails.
    pub(super) fn status(&self, problems: &[String], fails: bool) -> Status {
        match problems {
            [] => Status::faulty_if(fails && !self.check.exit_zero),
            _ => Status::Unusable,
        }
    }

    /// Writes to the requested output.
    fn write(&self, body: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> Result<(), String> {
        // A coloured report already masks text from programs.
        let is_coloured = self.report.is_coloured();
        let Some(path) = &self.check.output_file else {
            let to = self.report_to;
            return if is_coloured { print_bytes(to, body) } else { print_to(to, body) };
        };
        let mut text = Vec::new();
        let written = if is_coloured { body(&mut text) } else { body(&mut terminal::Masked(&mut text)) };
        written.map_err(|error| format!("standard output: {}", system::reason(&error)))?;
        save_apart(Some(path), &text)
    }

    /// Does the same work for all files, on all processors; passes the results to `take` in the order of the
    /// files.
    pub(super) fn in_order<T: Send>(
        &self,
        files: &[PathBuf],
        work: impl Fn(&Path) -> T + Sync,
        mut take: impl FnMut(T) -> io::Result<()>,
    ) -> io::Result<()> {
        let workers = system::processors().min(files.len());
        if workers < 2 {
            return files.iter().try_for_each(|file| take(work(file)));
        }
        let next = AtomicUsize::new(0);
        // A bounded channel limits how far checking runs ahead of writing.
        let (send, receive) = mpsc::sync_channel(MAX_UNWRITTEN);
        thread::scope(|scope| {
            for _ in 0..workers {
                let (send, next, work) = (send.clone(), &next, &work);
                let works = move || {
                    loop {
                        let at = next.fetch_add(1, Ordering::Relaxed);
                        let Some(file) = files.get(at) else { return };
                        if send.send((at, work(file))).is_err() {
                            return;
                        }
                    }
                };
                thread::Builder::new().stack_size(STACK).spawn_scoped(scope, works)?;
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

    /// The name that the options give to standard input.
    pub(super) fn given_name(&self, file: &Path) -> Option<&String> {
        self.check.stdin_filename.as_ref().filter(|_| file == Path::new("-"))
    }

    fn check_file(&self, file: &Path) -> Result<Done, String> {
        let given = self.given_name(file);
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

    /// Reads and decodes a program.
    pub(super) fn read(&self, file: &Path, setup: &Setup) -> Result<Source, String> {
        let (name, bytes) = read_within(file, setup.limits.text as u64)?;
        let (text, encoding) = encoding::decode(bytes);
        Ok(Source { name: self.given_name(file).cloned().unwrap_or(name), text, encoding })
    }

    /// Makes the safe repairs of the selected rules. The error says that they do not come to an end.
    pub(super) fn repaired(
        &self,
        name: &str,
        text: &[u8],
        settings: &Settings,
        setup: &Setup,
    ) -> Result<Repaired, String> {
        let repaired = repaired_of(text, setup, &|found| self.selection.takes(settings, found));
        match &repaired.open {
            Some(open) => {
                let open = open.words(self.language);
                Err(format!(
                    "{name}: the fixes do not come to an end; still open: {open}. The file is unchanged"
                ))
            }
            None => Ok(Repaired { text: with_line_ends_of(text, repaired.text), ..repaired }),
        }
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
        let Source { name, mut text, encoding } = self.read(file, &setup)?;
        let (mut lines_of_repairs, mut was_repaired) = (Vec::new(), false);
        if self.check.fix {
            let repaired = self.repaired(&name, &text, settings, &setup)?;
            let lines = LineIndex::new(&text);
            was_repaired = !repaired.taken.is_empty();
            lines_of_repairs.extend(repaired.taken.iter().map(|taken| {
                let line = lines.line_of(taken.span.start) + 1;
                format!("{name}:{line}: {}", taken.title.words(self.language))
            }));
            text = repaired.text;
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
                joined.report_at_calls(&mut program.analysis.diagnostics, &of_control);
                program.analysis.hide_moved();
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
        let stock = stock.map(|stock| What::InferredStock(None, stock));
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
