//! Formats findings as one report: a beginning, a part for each file, separators, and an end.
//!
//! In: files with the findings that count. Out: bytes. The part of a file depends on that file alone, so it
//! is made in the thread that checks the file; the counts are added up afterwards.

mod concise;
mod github;
mod gitlab;
mod junit;
mod markdown;
mod rdjson;
mod sarif;
mod words;

use std::collections::BTreeMap;
use std::io::{self, Write};

use clap::ValueEnum;
use serde_json::Value;

use super::super::rule_page::Page;
use super::super::system::{self, Stream};
use super::super::{counted, terminal, write_row};
use super::finding::{Finding, Programs, Remark, Subject, What};
use crate::api::{self, ElementNote, InFile, InManual, OfRule, Places};
use crate::message::Severity;
use crate::sentences::Language;
use crate::source::LineIndex;

/// Formats of a report.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(in crate::cli) enum ReportFormat {
    /// For people, with the line and carets under the words.
    Text,
    /// One line for each finding: file:line:column: severity code message.
    Concise,
    /// One JSON object a line.
    Json,
    /// SARIF 2.1.0, for code scanning.
    Sarif,
    /// Annotations of a workflow on GitHub.
    Github,
    /// A Code Quality report of GitLab.
    Gitlab,
    /// The format of reviewdog.
    Rdjson,
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

/// Totals of a report.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Counts {
    /// Number of files.
    pub files: usize,
    /// Number of programs in them.
    pub programs: Programs,
    /// Number of programs with errors.
    pub with_errors: usize,
    /// Number of errors.
    pub errors: usize,
    /// Number of warnings.
    pub warnings: usize,
    /// Number of notes.
    pub notes: usize,
    /// Number of findings that `--fix` repairs.
    pub fixable: usize,
    /// Number of programs with an assumed stock, whose collisions were not checked.
    pub without_stock: usize,
    /// Number of findings of each rule.
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

    /// Adds the counts of other files.
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

/// Options of a report.
pub(super) struct ReportOptions {
    /// Output format.
    pub format: ReportFormat,
    /// When text is coloured.
    pub colour: Colour,
    /// The report is written to a file and not coloured by default.
    pub to_file: bool,
    /// Language of messages.
    pub language: Language,
    /// The address of the rule pages, if it is known.
    pub rules_url: Option<String>,
    /// Report the number of findings of each rule instead of the findings.
    pub statistics: bool,
    /// Report findings only.
    pub quiet: bool,
    /// There is one file: show the assumed stock of its program. For several files it is only counted.
    pub is_lone: bool,
    /// The files are pages with programs in them.
    pub are_pages: bool,
}

/// A report in one format.
pub(super) struct Report {
    wanted: ReportOptions,
    is_coloured: bool,
}

impl Report {
    /// Creates a report from its options.
    pub(super) fn new(wanted: ReportOptions) -> Self {
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

    /// Whether the output contains colour escape sequences.
    pub(super) fn is_coloured(&self) -> bool {
        self.is_coloured && self.wanted.format == ReportFormat::Text
    }

    /// The text before all programs.
    pub(super) fn begin(&self) -> Vec<u8> {
        match self.wanted.format {
            _ if self.wanted.statistics => Vec::new(),
            ReportFormat::Sarif => sarif::begin(),
            ReportFormat::Gitlab => gitlab::BEGIN.into(),
            ReportFormat::Rdjson => rdjson::BEGIN.into(),
            ReportFormat::Junit => junit::BEGIN.into(),
            ReportFormat::Markdown => markdown::begin(self.wanted.language).into(),
            ReportFormat::Text | ReportFormat::Concise | ReportFormat::Json | ReportFormat::Github => {
                Vec::new()
            }
        }
    }

    /// The separator between two files with output.
    pub(super) fn between(&self) -> &'static [u8] {
        match self.wanted.format {
            ReportFormat::Sarif | ReportFormat::Gitlab | ReportFormat::Rdjson if !self.wanted.statistics => {
                b",\n"
            }
            _ => b"",
        }
    }

    /// The part of a file, and its counts.
    pub(super) fn subject(&self, subject: &Subject) -> (Vec<u8>, Counts) {
        let counts = Counts::of(subject);
        if self.wanted.statistics {
            return (Vec::new(), counts);
        }
        let places = Places { text: &subject.text, lines: &LineIndex::as_written(&subject.text) };
        let rows = || subject.findings.iter().filter_map(|one| one.row(places, self.wanted.language));
        let (name, language) = (&subject.name, self.wanted.language);
        let text = match self.wanted.format {
            ReportFormat::Text => {
                let found = subject.findings.iter();
                found.map(|one| self.text(name, places, one)).collect::<String>().into_bytes()
            }
            ReportFormat::Concise => {
                let notes = subject.findings.iter().filter(|one| matches!(one.what, What::InferredStock(..)));
                let notes = notes.map(|one| self.text(name, places, one));
                notes.fold(concise::lines(name, rows()), |lines, note| lines + &note).into_bytes()
            }
            ReportFormat::Json => {
                in_memory(|out| subject.findings.iter().try_for_each(|one| self.json(out, name, places, one)))
            }
            ReportFormat::Sarif => sarif::results(name, rows()),
            ReportFormat::Github => github::annotations(name, rows()).into_bytes(),
            ReportFormat::Gitlab => gitlab::issues(subject, places, language),
            ReportFormat::Rdjson => {
                rdjson::diagnostics(name, places, rows(), self.wanted.rules_url.as_deref(), language)
            }
            ReportFormat::Junit => junit::suite(name, rows()).into_bytes(),
            ReportFormat::Markdown => markdown::rows(name, rows(), language).into_bytes(),
        };
        (text, counts)
    }

    /// Formats a finding as text.
    fn text(&self, name: &str, places: Places<'_>, one: &Finding) -> String {
        match &one.what {
            What::Message(message) => {
                let (Places { text, lines }, found) = (places, std::slice::from_ref(message));
                terminal::render(name, text, lines, found, self.wanted.language, self.is_coloured)
            }
            What::Remark(Remark { place: (line, column), message, .. }) => {
                terminal::masked(&format!("{name}:{line}:{column}: {message}\n"))
            }
            What::InferredStock(None, stock) if self.wanted.is_lone && !self.wanted.quiet => {
                terminal::masked(&format!("{name}: {}\n", stock.message))
            }
            What::InferredStock(..) => String::new(),
        }
    }

    /// Writes a finding as a JSON object.
    fn json(&self, out: &mut dyn Write, file: &str, places: Places<'_>, one: &Finding) -> io::Result<()> {
        match &one.what {
            What::Message(message) => {
                let row = self.of_rule(places.diagnostic(message, self.wanted.language));
                write_row(out, &InFile { file, row })
            }
            What::Remark(Remark { place: (line, column), slug, message }) => {
                let row = ElementNote { note: slug, message: message.clone() };
                write_row(out, &InFile { file, row: InManual { line: *line, column: *column, row } })
            }
            What::InferredStock(..) if self.wanted.quiet => Ok(()),
            What::InferredStock(None, row) => write_row(out, &InFile { file, row }),
            What::InferredStock(Some((line, column)), row) => {
                write_row(out, &InFile { file, row: InManual { line: *line, column: *column, row } })
            }
        }
    }

    /// The row of a message with the title and the address of its rule.
    fn of_rule(&self, row: api::Diagnostic) -> OfRule<api::Diagnostic> {
        let (slug, language) = (&row.slug, self.wanted.language);
        let title = Page::of(slug).map_or("", |page| page.text(language).title);
        let folder = self.wanted.rules_url.as_deref();
        let url = folder.map(|folder| language.rule_page(folder, slug));
        OfRule { row, title, url }
    }

    /// The text after all programs.
    pub(super) fn end(&self, counts: &Counts) -> Vec<u8> {
        if self.wanted.statistics {
            return in_memory(|out| statistics(out, counts, self.wanted.format));
        }
        // The stock of a single program has a separate line; for pages the total is on standard error.
        let is_named = self.wanted.is_lone && !self.wanted.are_pages;
        let counts =
            &Counts { without_stock: if is_named { 0 } else { counts.without_stock }, ..counts.clone() };
        match self.wanted.format {
            ReportFormat::Sarif => sarif::end(counts, self.wanted.rules_url.as_deref(), self.wanted.language),
            ReportFormat::Gitlab => gitlab::END.into(),
            ReportFormat::Rdjson => rdjson::END.into(),
            ReportFormat::Junit => junit::END.into(),
            ReportFormat::Markdown if !self.wanted.quiet => {
                format!("\n{}\n", words::summary(counts, self.wanted.language)).into_bytes()
            }
            // If no file could be read, errors were reported; a summary of "no findings" would be misleading.
            ReportFormat::Text | ReportFormat::Concise if counts.files == 0 => Vec::new(),
            ReportFormat::Text | ReportFormat::Concise if !self.wanted.quiet && !self.wanted.are_pages => {
                format!("{}\n", words::summary(counts, self.wanted.language)).into_bytes()
            }
            _ => Vec::new(),
        }
    }
}

/// Summary of the programs in pages: `3 programs; 1 with errors`.
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

/// Collects the output of `write` in memory.
fn in_memory(write: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> Vec<u8> {
    let mut text = Vec::new();
    write(&mut text).expect("memory takes all that is written");
    text
}

/// Number of findings of each rule, most frequent first.
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

/// Text of a finding for all formats except `text`: message and help.
fn sentence(row: &api::Diagnostic) -> String {
    match &row.help {
        Some(help) => format!("{} {help}", row.message),
        None => row.message.clone(),
    }
}

/// Objects of a JSON array, separated by commas.
fn list(objects: impl Iterator<Item = Value>) -> Vec<u8> {
    in_memory(|out| {
        for (at, object) in objects.enumerate() {
            if at > 0 {
                out.write_all(b",\n")?;
            }
            out.write_all(terminal::json(&object)?.as_bytes())?;
        }
        Ok(())
    })
}

/// A file name as part of a URL: with `/` as separator, percent-encoded.
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
