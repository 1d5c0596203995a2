//! A page of a manual that contains programs.
//!
//! In: a file, and the default settings of its examples. Out: its programs, their setups, and the conversion
//! of positions in programs to positions in the page. Used by `check --markdown` and `embed --check`. Must
//! not know what is done with them.

use std::path::Path;

use super::configuration::Settings;
use super::manual::{self, Attributes, Example, Markup};
use super::{Encoding, Program, encoding, read_within, run_text};
use crate::message::Diagnostic;
use crate::setup::dialect::Control;
use crate::setup::{Setup, profile};
use crate::source::{LineIndex, Span};

/// A page of a manual.
pub(super) struct Page {
    /// File name.
    pub name: String,
    /// Text, in UTF-8.
    pub text: Vec<u8>,
    /// Encoding of the file.
    pub encoding: Encoding,
    /// Markup language.
    pub markup: Markup,
}

impl Page {
    /// Reads a page.
    pub fn read(file: &Path, most: u64) -> Result<Self, String> {
        let (name, bytes) = read_within(file, most)?;
        // Pages are UTF-8 whenever they are valid: the guess is designed for comments of programs.
        let (text, encoding) = match std::str::from_utf8(&bytes) {
            Ok(_) => (bytes, Encoding::Utf8),
            Err(_) => encoding::decode(bytes),
        };
        let markup = Markup::of(&name);
        Ok(Self { name, text, encoding, markup })
    }

    /// Renames the page; the markup language follows from the name.
    pub fn rename(&mut self, name: &str) {
        self.markup = Markup::of(name);
        name.clone_into(&mut self.name);
    }

    /// Line and column of a byte, from 1.
    pub fn place(&self, lines: &LineIndex, byte: usize) -> (u32, u32) {
        let place = lines.line_column(&self.text, byte as u32);
        (place.line + 1, place.column + 1)
    }

    /// The programs in the page.
    pub fn examples(&self) -> Vec<Example> {
        manual::examples(&self.text, self.markup)
    }
}

/// Default settings of the programs in a page.
pub(super) struct Base {
    setups: Vec<String>,
    control: Option<Control>,
}

impl Base {
    /// No defaults: the example contains all settings.
    pub fn none() -> Self {
        Self { setups: Vec::new(), control: None }
    }

    /// Defaults from the options and the configuration.
    pub fn of(settings: &Settings) -> Self {
        let setups: Vec<String> = settings.setups.iter().map(|(_, json)| json.clone()).collect();
        let mut all = serde_json::from_str(&profile::joined_text(&setups)).unwrap_or(serde_json::json!({}));
        for (name, level) in &settings.rules {
            all["rules"][*name] = level.name().into();
        }
        Self { setups: vec![all.to_string()], control: settings.control }
    }

    /// The setup of an example with these attributes, as in the element.
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

/// A number if the text is one; other texts are rejected by the parser of setups.
fn number_or_text(text: &str) -> serde_json::Value {
    text.trim().parse::<u32>().map_or_else(|_| text.into(), Into::into)
}

/// Runs the program of an example.
pub(super) fn run(name: &str, example: &Example, setup: Setup) -> Program {
    run_text(name.to_owned(), example.program.text().to_vec(), Encoding::Utf8, setup, |run| run)
}

/// Converts a message about a program to a message about the page that contains it.
pub(super) fn placed(
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

/// The prefix of each line of a block in a quotation or a list; empty if `before` contains anything else.
fn margin(before: &[u8]) -> &str {
    let is_margin = before.iter().all(|byte| matches!(byte, b' ' | b'\t' | b'>'));
    std::str::from_utf8(before).ok().filter(|_| is_margin).unwrap_or_default()
}
