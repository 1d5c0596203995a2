//! `check --markdown`: all programs in the pages of a manual, with their places there.
//!
//! In: pages. Out: messages by line and column of the page, and on standard error how much was checked. An example
//! that says `no-check` is left out: a manual shows faulty programs, too.

use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use super::manual::attributes::{self, Fault};
use super::manual::{self, Attributes, Example, Holder, Markup};
use super::{Encoding, Format, Program, With, encoding, has_errors, print, read, run_text, setup_texts};
use super::{tell_at, write_row};
use crate::api::{ElementNote, InFile, InManual, InferredStock, Places};
use crate::message::Diagnostic;
use crate::sentences::{Language, labels};
use crate::setup::dialect::Control;
use crate::setup::{Setup, profile};
use crate::source::{LineIndex, Span};

/// A page of a manual.
pub(super) struct Page {
    /// The name of its file.
    pub name: String,
    /// As UTF-8.
    pub text: Vec<u8>,
    /// Of the file.
    pub encoding: Encoding,
    /// How it is written.
    pub markup: Markup,
}

impl Page {
    /// Reads a page.
    pub fn read(file: &Path) -> Result<Self, String> {
        let (name, bytes) = read(file)?;
        // Pages are UTF-8 unless they cannot be: the guess is made for comments of programs.
        let (text, encoding) = match std::str::from_utf8(&bytes) {
            Ok(_) => (bytes, Encoding::Utf8),
            Err(_) => encoding::decode(bytes),
        };
        let markup = Markup::of(&name);
        Ok(Self { name, text, encoding, markup })
    }

    /// The programs in it.
    pub fn examples(&self) -> Vec<Example> {
        manual::examples(&self.text, self.markup)
    }
}

/// What all programs are run with unless they say something else.
pub(super) struct Base {
    setups: Vec<String>,
    control: Option<Control>,
}

impl Base {
    /// Nothing: the example says all of it.
    pub fn none() -> Self {
        Self { setups: Vec::new(), control: None }
    }

    /// What the options say.
    pub fn new(with: &With) -> Result<Self, String> {
        Ok(Self { setups: setup_texts(with)?, control: with.control.map(|name| name.control()) })
    }

    /// The setup of an example with these attributes, as the element has it.
    pub fn setup(&self, attributes: &Attributes) -> Result<Setup, String> {
        let mut setups = self.setups.clone();
        setups.extend(attributes.get("setup").filter(|json| !json.is_empty()).map(str::to_owned));
        if let Some(levels) = attributes.get("block-skip") {
            let levels = levels.split([' ', ',', '\t', '\n', '\r']).filter(|level| !level.is_empty());
            let levels: Vec<_> = levels.map(number_or_text).collect();
            setups.push(serde_json::json!({"blockSkip": levels}).to_string());
        }
        if let Some(number) = attributes.get("program") {
            setups.push(serde_json::json!({"program": number_or_text(number)}).to_string());
        }
        let mut setup = profile::joined(&setups)?;
        if self.control.is_some() {
            setup.dialect.control = self.control;
        }
        if let Some(name) = attributes.get("control") {
            let json = serde_json::json!({"dialect": {"control": name}}).to_string();
            setup.dialect.control = Setup::from_json(&json)?.dialect.control;
        }
        Ok(setup)
    }
}

/// What is no number is refused where setups are read.
fn number_or_text(text: &str) -> serde_json::Value {
    text.trim().parse::<u32>().map_or_else(|_| text.into(), Into::into)
}

/// How much was checked.
#[derive(Default)]
struct Counts {
    programs: usize,
    with_errors: usize,
    without_stock: usize,
    left_out: usize,
}

/// Checks all programs of some pages.
pub(super) fn files(
    files: &[PathBuf],
    with: &With,
    language: Language,
    format: Format,
) -> Result<ExitCode, String> {
    let base = Base::new(with)?;
    let mut counts = Counts::default();
    for file in files {
        let page = Page::read(file)?;
        print(|out| check(out, &page, &base, language, format, &mut counts))?;
    }
    let Counts { programs, with_errors, without_stock, left_out } = counts;
    let told = [
        (with_errors, "with errors"),
        (without_stock, "without a stock (collisions not checked)"),
        (left_out, "not checked"),
    ];
    let told: String = told
        .iter()
        .filter(|(count, _)| *count > 0)
        .map(|(count, what)| format!("; {count} {what}"))
        .collect();
    eprintln!("gcode-playground: {}{told}", counted(programs, "program"));
    Ok(ExitCode::from(u8::from(with_errors > 0)))
}

/// `1 program`, `2 programs`.
pub(super) fn counted(count: usize, what: &str) -> String {
    format!("{count} {what}{}", if count == 1 { "" } else { "s" })
}

/// Checks the programs of a page.
fn check(
    out: &mut dyn Write,
    page: &Page,
    base: &Base,
    language: Language,
    format: Format,
    counts: &mut Counts,
) -> io::Result<()> {
    let lines = LineIndex::new(&page.text);
    for example in page.examples() {
        if example.attributes.get("src").is_some_and(|address| !address.is_empty()) {
            continue;
        }
        if example.attributes.get("no-check").is_some() {
            counts.left_out += 1;
            continue;
        }
        counts.programs += 1;
        let mut is_faulty = false;
        let at = InPage { page, lines: &lines, language, format };
        if !example.is_closed {
            is_faulty = true;
            at.note(out, &example, "element-not-closed", labels::element_not_closed(language).to_owned())?;
        }
        if example.holder != Holder::Code {
            for (name, value) in example.attributes.all() {
                let Some(fault) = attributes::fault(name, value) else { continue };
                is_faulty = true;
                let said = match fault {
                    Fault::Name => labels::attribute_unknown(name, language),
                    Fault::Value { expected } => labels::attribute_value(name, value, &expected, language),
                };
                at.note(out, &example, "attribute-wrong", said)?;
            }
        }
        match base.setup(&example.attributes) {
            Err(reason) => {
                is_faulty = true;
                at.note(out, &example, "setup-unreadable", labels::setup_unreadable(&reason, language))?;
            }
            Ok(setup) => {
                let program = run(&page.name, &example, setup);
                is_faulty |= has_errors(&program.analysis);
                at.messages(out, &example, &program)?;
                counts.without_stock += usize::from(at.stock(out, &example, &program)?);
            }
        }
        counts.with_errors += usize::from(is_faulty);
    }
    Ok(())
}

/// Runs the program of an example.
pub(super) fn run(name: &str, example: &Example, setup: Setup) -> Program {
    run_text(name.to_owned(), example.program.text().to_vec(), Encoding::Utf8, setup, |run| run)
}

/// Reports by places of a page.
pub(super) struct InPage<'a> {
    /// The page.
    pub page: &'a Page,
    /// Its lines.
    pub lines: &'a LineIndex,
    /// The language of the reports.
    pub language: Language,
    /// Their form.
    pub format: Format,
}

impl InPage<'_> {
    fn messages(&self, out: &mut dyn Write, example: &Example, program: &Program) -> io::Result<()> {
        let own_lines = LineIndex::new(&program.text);
        let found = program.analysis.diagnostics.iter();
        let found: Vec<_> = found
            .map(|told| placed(told, example, &own_lines, &program.text, &self.page.text, self.lines))
            .collect();
        let places = Places { text: &self.page.text, lines: self.lines };
        tell_at(out, &self.page.name, places, &found, self.language, self.format)
    }

    /// Something about an element.
    pub fn note(
        &self,
        out: &mut dyn Write,
        example: &Example,
        note: &'static str,
        message: String,
    ) -> io::Result<()> {
        let (line, column) = self.place(example.at);
        let file = &self.page.name;
        match self.format {
            Format::Json => {
                let row = InManual { line, column, row: ElementNote { note, message } };
                write_row(out, &InFile { file, row })
            }
            Format::Text => writeln!(out, "{file}:{line}:{column}: {message}"),
        }
    }

    /// Reports that the stock of an example is assumed; the answer is whether it is. As text, they are only counted.
    fn stock(&self, out: &mut dyn Write, example: &Example, program: &Program) -> io::Result<bool> {
        let Some(inferred) = InferredStock::of(&program.analysis, self.language) else { return Ok(false) };
        if self.format == Format::Json {
            let (line, column) = self.place(example.at);
            write_row(out, &InFile { file: &self.page.name, row: InManual { line, column, row: inferred } })?;
        }
        Ok(true)
    }

    fn place(&self, byte: usize) -> (u32, u32) {
        let place = self.lines.line_column(&self.page.text, byte as u32);
        (place.line + 1, place.column + 1)
    }
}

/// A message about a program as one about the page that contains it.
fn placed(
    told: &Diagnostic,
    example: &Example,
    own_lines: &LineIndex,
    own_text: &[u8],
    page: &[u8],
    lines: &LineIndex,
) -> Diagnostic {
    let in_page = |span: Span| example.in_page(span);
    let line_in_page = |line: i64| {
        let line = u32::try_from(line - 1).unwrap_or(0).min(own_lines.len() - 1);
        let start = own_lines.line(own_text, line).start;
        i64::from(lines.line_of(in_page(Span { start, end: start }).start)) + 1
    };
    let mut told = told.clone();
    told.message = told.message.with_lines(line_in_page);
    told.span = in_page(told.span);
    for edit in told.fixes.iter_mut().flat_map(|fix| &mut fix.edits) {
        if example.is_escaped {
            edit.text = manual::escaped(&edit.text);
        }
        if edit.text.contains('\n') {
            let line = own_lines.line(own_text, own_lines.line_of(edit.span.start)).start;
            let place = in_page(Span { start: line, end: line }).start;
            let before = &page[lines.line(page, lines.line_of(place)).start as usize..place as usize];
            edit.text = edit.text.replace('\n', &["\n", margin(before)].concat());
        }
        edit.span = in_page(edit.span);
    }
    told
}

/// What stands before each line of a block in a quotation or a list; nothing before a line that begins a block.
fn margin(before: &[u8]) -> &str {
    let is_margin = before.iter().all(|byte| matches!(byte, b' ' | b'\t' | b'>'));
    std::str::from_utf8(before).ok().filter(|_| is_margin).unwrap_or_default()
}
