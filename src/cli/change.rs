//! A program file that a command changes: read with its subprograms, compared with the changed program, written.
//!
//! In: a file and the edits of a command. Out: the changed file, its name, or a diff. A file whose changed
//! program might run differently stays as it is. Must not know what the edits are for.

use std::path::{Path, PathBuf};

use super::configuration::Configurations;
use super::encoding::{self, Encoding};
use super::subprograms;
use super::unified::unified;
use super::{print, read_within, save};
use crate::message::Edit;
use crate::message::applied;
use crate::proof::{Difference, difference_by};
use crate::run::Run;
use crate::run::subprograms::Joined;
use crate::sentences::Language;
use crate::setup::Setup;
use crate::source::{LineIndex, Span};

/// What is written of a changed program.
#[derive(clap::Args)]
pub(super) struct Output {
    /// Change no file: list the files that would change. The exit status is 1 if there are any.
    #[arg(long, conflicts_with_all = ["diff", "output"])]
    check: bool,
    /// Change no file: print the changes as a unified diff. The exit status is 1 if there are any.
    #[arg(long, conflicts_with = "output")]
    diff: bool,
    /// Where to write the program, instead of the file itself.
    #[arg(short, long)]
    output: Option<PathBuf>,
}

impl Output {
    /// Whether files are changed.
    pub fn writes(&self) -> bool {
        !self.check && !self.diff
    }

    /// Whether there is one destination for all files.
    pub fn is_for_one_file(&self) -> bool {
        self.output.is_some()
    }

    /// Writes a program, changed or not.
    pub fn write(&self, source: &Source, changed: Option<&[u8]>) -> Result<(), String> {
        let text = changed.unwrap_or(&source.text);
        match () {
            () if self.check => changed.map_or(Ok(()), |_| print(|out| writeln!(out, "{}", source.name))),
            () if self.diff => changed.map_or(Ok(()), |changed| source.print_diff(changed)),
            () if self.output.is_some() => save(self.output.as_deref(), &source.encoded(text)),
            () if source.file == Path::new("-") => save(None, &source.encoded(text)),
            () => changed.map_or(Ok(()), |changed| save(Some(&source.file), &source.encoded(changed))),
        }
    }
}

/// A program file.
pub(super) struct Source {
    file: PathBuf,
    /// The name of the file for messages.
    pub name: String,
    /// The program, UTF-8.
    pub text: Vec<u8>,
    encoding: Encoding,
    joined: Option<Joined>,
    /// The setup that it is run with.
    pub setup: Setup,
}

impl Source {
    /// Reads a file, and the subprograms that it calls.
    pub fn read(file: &Path, configurations: &Configurations<'_>) -> Result<Self, String> {
        let setup = configurations.settings(file)?.setup.clone();
        let (name, bytes) = read_within(file, setup.limits.text as u64)?;
        let (text, encoding) = encoding::decode(bytes);
        let joined = subprograms::join(&text, &configurations.libraries(file)?, setup.limits.text);
        Ok(Self { file: file.to_owned(), name, text, encoding, joined, setup })
    }

    /// The program as it is run: with the subprograms from other files.
    pub fn run_text(&self) -> &[u8] {
        self.joined.as_ref().map_or(&self.text, |joined| &joined.text)
    }

    /// Length of the program itself in [`Source::run_text`], bytes.
    pub fn own(&self) -> usize {
        self.joined.as_ref().map_or(self.text.len(), Joined::own)
    }

    /// The changed program; `None` without edits. The error names what would differ. `action`: the edits, as in
    /// "not formatted".
    pub fn changed(&self, edits: &[Edit], action: &str) -> Result<Option<Vec<u8>>, String> {
        if edits.is_empty() {
            return Ok(None);
        }
        let (run, own) = (self.run_text(), self.own());
        let inside = edits.partition_point(|edit| edit.span.end as usize <= own);
        match difference_by(&edits[..inside], &Run::finished(run.to_vec(), self.setup.clone())) {
            Some(found) => Err(self.refusal(found, action)),
            None => Ok(Some(applied(&self.text, edits))),
        }
    }

    fn refusal(&self, found: Difference, action: &str) -> String {
        let why = found.reason(Language::English);
        let name = found.span().map_or_else(|| self.name.clone(), |span| self.place(span));
        format!("{name}: not {action}: {why}")
    }

    /// The place of a span in [`Source::run_text`]: `part.nc:5`.
    pub fn place(&self, span: Span) -> String {
        format!("{}:{}", self.name, self.line(span))
    }

    /// The line of a span, from 1.
    fn line(&self, span: Span) -> u32 {
        LineIndex::new(self.run_text()).line_of(span.start) + 1
    }

    fn encoded(&self, text: &[u8]) -> Vec<u8> {
        let text = String::from_utf8_lossy(text);
        self.encoding.encode(&text).map_or_else(|| text.as_bytes().to_vec(), |bytes| bytes.into_owned())
    }

    fn print_diff(&self, changed: &[u8]) -> Result<(), String> {
        let [before, after] = [&self.text[..], changed].map(String::from_utf8_lossy);
        print(|out| out.write_all(unified(&self.name, [&before, &after]).as_bytes()))
    }
}
