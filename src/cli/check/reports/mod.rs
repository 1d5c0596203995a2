//! How findings are written: one report for all files, made of what is written before, for each program, between and after.
//!
//! In: files with the findings that count. Out: bytes. What is written of a file depends on that file
//! alone, so it is made wherever the file is checked; the counts are added up in between.

mod github;
mod junit;
mod markdown;
mod sarif;
mod words;

use std::collections::BTreeMap;
use std::io::{self, Write};

use clap::ValueEnum;

use super::super::system::{self, Stream};
use super::super::{counted, terminal, write_row};
use super::finding::{Finding, Programs, Remark, Subject, What};
use crate::api::{self, ElementNote, InFile, InManual, Places};
use crate::message::Severity;
use crate::sentences::Language;
use crate::source::LineIndex;

/// The formats.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(in crate::cli) enum ReportFormat {
    /// For people, with the line and carets under the words.
    Text,
    /// One JSON object a line.
    Json,
    /// SARIF 2.1.0, for code scanning.
    Sarif,
    /// Annotations of a workflow on GitHub.
    Github,
    /// JUnit's XML: each file is a suite, each error and warning a test that fails.
    Junit,
    /// A table for a comment or a page.
    Markdown,
}

/// When text is coloured.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(in crate::cli) enum Colour {
    /// On a terminal, unless NO_COLOR is set.
    Auto,
    /// Always.
    Always,
    /// Never.
    Never,
}

/// How much was found.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Counts {
    /// Files.
    pub files: usize,
    /// Programs in them.
    pub programs: Programs,
    /// Programs with errors.
    pub with_errors: usize,
    /// Errors.
    pub errors: usize,
    /// Warnings.
    pub warnings: usize,
    /// Notes.
    pub notes: usize,
    /// Findings that `--fix` repairs.
    pub fixable: usize,
    /// Programs whose stock is assumed: no collisions were looked for.
    pub without_stock: usize,
    /// How often each rule was found.
    pub rules: BTreeMap<&'static str, usize>,
}

impl Counts {
    fn of(subject: &Subject) -> Self {
        let mut counts = Self { files: 1, programs: subject.programs, ..Self::default() };
        let mut faulty = Vec::new();
        for one in &subject.findings {
            match one.severity() {
                Some(Severity::Error) => {
                    counts.errors += 1;
                    faulty.push(one.program);
                }
                Some(Severity::Warning) => counts.warnings += 1,
                Some(Severity::Info | Severity::Off) => counts.notes += 1,
                None => counts.without_stock += 1,
            }
            let Some(slug) = one.slug() else { continue };
            *counts.rules.entry(slug).or_default() += 1;
            if let What::Message(message) = &one.what {
                counts.fixable += usize::from(message.fixes.iter().any(|fix| fix.safe));
            }
        }
        faulty.dedup();
        counts.with_errors = faulty.len();
        counts
    }

    /// Adds those of other files.
    pub(super) fn add(&mut self, other: &Self) {
        self.files += other.files;
        self.programs.checked += other.programs.checked;
        self.programs.left_out += other.programs.left_out;
        self.with_errors += other.with_errors;
        self.errors += other.errors;
        self.warnings += other.warnings;
        self.notes += other.notes;
        self.fixable += other.fixable;
        self.without_stock += other.without_stock;
        for (rule, count) in &other.rules {
            *self.rules.entry(rule).or_default() += count;
        }
    }
}

/// How a report is asked for.
pub(super) struct Wanted {
    /// The format.
    pub format: ReportFormat,
    /// When text is coloured.
    pub colour: Colour,
    /// The report goes into a file, which is left without colours.
    pub to_file: bool,
    /// The language of messages.
    pub language: Language,
    /// How often each rule was found, instead of the findings.
    pub statistics: bool,
    /// Findings alone.
    pub quiet: bool,
    /// There is one file: the assumed stock of its program is shown; of several it is only counted.
    pub is_lone: bool,
    /// The files are pages with programs in them.
    pub are_pages: bool,
}

/// A report in a format.
pub(super) struct Report {
    wanted: Wanted,
    is_coloured: bool,
}

impl Report {
    /// A report as it is asked for.
    pub(super) fn new(wanted: Wanted) -> Self {
        let is_coloured = match wanted.colour {
            Colour::Always => true,
            Colour::Never => false,
            Colour::Auto => {
                let asked_not_to = system::variable("NO_COLOR").is_some();
                !wanted.to_file && !asked_not_to && system::is_terminal(Stream::Output)
            }
        };
        Self { wanted, is_coloured }
    }

    /// Whether it contains the commands of a terminal that colour it.
    pub(super) fn is_coloured(&self) -> bool {
        self.is_coloured && self.wanted.format == ReportFormat::Text
    }

    /// What stands before all programs.
    pub(super) fn begin(&self) -> Vec<u8> {
        match self.wanted.format {
            _ if self.wanted.statistics => Vec::new(),
            ReportFormat::Sarif => sarif::begin(),
            ReportFormat::Junit => junit::BEGIN.into(),
            ReportFormat::Markdown => markdown::begin(self.wanted.language).into(),
            ReportFormat::Text | ReportFormat::Json | ReportFormat::Github => Vec::new(),
        }
    }

    /// What stands between two programs of which something is written.
    pub(super) fn between(&self) -> &'static [u8] {
        match self.wanted.format {
            ReportFormat::Sarif if !self.wanted.statistics => b",\n",
            _ => b"",
        }
    }

    /// What is written of a file, and what counts.
    pub(super) fn subject(&self, subject: &Subject) -> (Vec<u8>, Counts) {
        let counts = Counts::of(subject);
        if self.wanted.statistics {
            return (Vec::new(), counts);
        }
        let places = Places { text: &subject.text, lines: &LineIndex::as_written(&subject.text) };
        let rows = || subject.findings.iter().filter_map(|one| one.row(places, self.wanted.language));
        let name = &subject.name;
        let text = match self.wanted.format {
            ReportFormat::Text => {
                let found = subject.findings.iter();
                found.map(|one| self.text(name, places, one)).collect::<String>().into_bytes()
            }
            ReportFormat::Json => {
                in_memory(|out| subject.findings.iter().try_for_each(|one| self.json(out, name, places, one)))
            }
            ReportFormat::Sarif => sarif::results(name, rows()),
            ReportFormat::Github => github::annotations(name, rows()).into_bytes(),
            ReportFormat::Junit => junit::suite(name, rows()).into_bytes(),
            ReportFormat::Markdown => markdown::rows(name, rows(), self.wanted.language).into_bytes(),
        };
        (text, counts)
    }

    /// A finding as text.
    fn text(&self, name: &str, places: Places<'_>, one: &Finding) -> String {
        match &one.what {
            What::Message(message) => {
                let (Places { text, lines }, found) = (places, std::slice::from_ref(message));
                terminal::render(name, text, lines, found, self.wanted.language, self.is_coloured)
            }
            What::Remark(Remark { place: (line, column), message, .. }) => {
                terminal::masked(&format!("{name}:{line}:{column}: {message}\n"))
            }
            What::AssumedStock(None, stock) if self.wanted.is_lone && !self.wanted.quiet => {
                terminal::masked(&format!("{name}: {}\n", stock.message))
            }
            What::AssumedStock(..) => String::new(),
        }
    }

    /// A finding as an object.
    fn json(&self, out: &mut dyn Write, file: &str, places: Places<'_>, one: &Finding) -> io::Result<()> {
        match &one.what {
            What::Message(message) => {
                let row = places.diagnostic(message, self.wanted.language);
                write_row(out, &InFile { file, row })
            }
            What::Remark(Remark { place: (line, column), slug, message }) => {
                let row = ElementNote { note: slug, message: message.clone() };
                write_row(out, &InFile { file, row: InManual { line: *line, column: *column, row } })
            }
            What::AssumedStock(..) if self.wanted.quiet => Ok(()),
            What::AssumedStock(None, row) => write_row(out, &InFile { file, row }),
            What::AssumedStock(Some((line, column)), row) => {
                write_row(out, &InFile { file, row: InManual { line: *line, column: *column, row } })
            }
        }
    }

    /// What stands after all programs.
    pub(super) fn end(&self, counts: &Counts) -> Vec<u8> {
        if self.wanted.statistics {
            return in_memory(|out| statistics(out, counts, self.wanted.format));
        }
        // The stock of a lone program has a line of its own; pages have their sum on standard error.
        let is_named = self.wanted.is_lone && !self.wanted.are_pages;
        let counts =
            &Counts { without_stock: if is_named { 0 } else { counts.without_stock }, ..counts.clone() };
        match self.wanted.format {
            ReportFormat::Sarif => sarif::end(counts),
            ReportFormat::Junit => junit::END.into(),
            ReportFormat::Markdown if !self.wanted.quiet => {
                format!("\n{}\n", words::summary(counts, self.wanted.language)).into_bytes()
            }
            // Where no file could be read, that is said, and not that nothing was found.
            ReportFormat::Text if counts.files == 0 => Vec::new(),
            ReportFormat::Text if !self.wanted.quiet && !self.wanted.are_pages => {
                format!("{}\n", words::summary(counts, self.wanted.language)).into_bytes()
            }
            _ => Vec::new(),
        }
    }
}

/// How many programs the pages have: `3 programs; 1 with errors`.
pub(super) fn programs_of_pages(counts: &Counts) -> String {
    let Counts { programs, with_errors, without_stock, .. } = counts;
    let told = [
        (*with_errors, "with errors"),
        (*without_stock, "without a stock (collisions not checked)"),
        (programs.left_out, "not checked"),
    ];
    let told = told.iter().filter(|(count, _)| *count > 0).map(|(count, what)| format!("; {count} {what}"));
    counted(programs.checked, "program") + &told.collect::<String>()
}

/// What is written, in memory.
fn in_memory(write: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> Vec<u8> {
    let mut text = Vec::new();
    write(&mut text).expect("memory takes all that is written");
    text
}

/// How often each rule was found, the most frequent first.
fn statistics(out: &mut dyn Write, counts: &Counts, format: ReportFormat) -> io::Result<()> {
    let mut rules: Vec<(&str, usize)> = counts.rules.iter().map(|(rule, count)| (*rule, *count)).collect();
    rules.sort_by(|a, b| b.1.cmp(&a.1).then(a.0.cmp(b.0)));
    for (rule, count) in rules {
        match format {
            ReportFormat::Json => writeln!(out, "{}", serde_json::json!({"slug": rule, "count": count}))?,
            _ => writeln!(out, "{count:>6}  {rule}")?,
        }
    }
    Ok(())
}

/// A finding as reports other than the text one have it: what was found, and what to do.
fn sentence(row: &api::Diagnostic) -> String {
    match &row.help {
        Some(help) => format!("{} {help}", row.message),
        None => row.message.clone(),
    }
}

/// The name of a file as a part of an address: with slashes, and `%` before what an address does not take.
fn address(name: &str) -> String {
    let mut address = String::new();
    for byte in name.replace('\\', "/").trim_start_matches("./").bytes() {
        match byte {
            b'A'..=b'Z' | b'a'..=b'z' | b'0'..=b'9' | b'-' | b'_' | b'.' | b'~' | b'/' => {
                address.push(char::from(byte));
            }
            _ => address.push_str(&format!("%{byte:02X}")),
        }
    }
    address
}
