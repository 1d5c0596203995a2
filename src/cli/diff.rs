//! `diff`: the difference between two versions of a program, as text, Markdown, JSON or a drawing.
//!
//! In: two analysed programs. Out: changes of the text, and their effect on motion, time, part and messages.

use std::path::PathBuf;

use super::options::{LanguageOptions, PageFormat, ProgramOptions};
use super::system::print_error_line;
use super::{NAME, Program, Status, print, program_with, save_apart, write_row};
use crate::api::difference::{Change, Later, ProgramDifference, Row};
use crate::api::{Diagnostic, Places};
use crate::difference::{self, Version};
use crate::scene::camera::XPlus;
use crate::scene::ruler::Scale;
use crate::scene::svg::{MAX_STROKES, SvgOptions, overlay};
use crate::sentences::Language;
use crate::sentences::difference::{Said, said, said_with};
use crate::source::LineIndex;
use crate::units::number;

/// The arguments of `diff`.
#[derive(clap::Args)]
pub(super) struct Diff {
    /// The first version; `-` reads standard input.
    first: PathBuf,
    /// The second version.
    second: PathBuf,
    #[command(flatten)]
    with: ProgramOptions,
    #[command(flatten)]
    texts: LanguageOptions,
    /// How to write it.
    #[arg(long, value_enum, default_value = "text")]
    format: PageFormat,
    /// Exit status 0 where the text differs and the motion does not.
    #[arg(long)]
    motions_only: bool,
    /// Where to draw the tool paths of both, as SVG.
    #[arg(short, long)]
    output: Option<PathBuf>,
}

/// Compares two programs; the exit status says whether they differ.
pub(super) fn run(arguments: &Diff) -> Result<Status, String> {
    let Diff { first, second, with, texts, format, motions_only, output } = arguments;
    if first.as_os_str() == "-" && second.as_os_str() == "-" {
        return Err("only one of the programs can be standard input".to_owned());
    }
    let programs = [program_with(first, with, |run| run)?, program_with(second, with, |run| run)?];
    let language = texts.language();
    let found = difference::ProgramDifference::of(programs.each_ref().map(version));
    let lines = programs.each_ref().map(|program| LineIndex::as_written(&program.text));
    let places = [0, 1].map(|side| Places { text: &programs[side].text, lines: &lines[side] });
    let rows = ProgramDifference::new(&found, places, programs[1].analysis.unit, language);
    let [a, b] = &programs;
    let names = [a.name_beside(b), b.name_beside(a)];
    let written = Report { rows: &rows, names: &names, language };
    print(|out| match format {
        PageFormat::Json => write_row(out, &rows),
        PageFormat::Text => out.write_all(written.text().as_bytes()),
        PageFormat::Markdown => out.write_all(written.markdown().as_bytes()),
    })?;
    if let Some(output) = output {
        if programs.iter().any(|program| program.analysis.motions.len() > MAX_STROKES) {
            print_error_line(format_args!(
                "{NAME}: {}: the first {MAX_STROKES} motions of each program are drawn",
                output.display()
            ));
        }
        save_apart(Some(output), drawing(&programs, &names, language).as_bytes())?;
    }
    Ok(Status::differing_if(!found.same_motions || !(*motions_only || rows.same_text)))
}

fn version(program: &Program) -> Version<'_> {
    let analysis = &program.analysis;
    Version {
        text: &program.text,
        motions: &analysis.motions,
        diagnostics: &analysis.diagnostics,
        setup: &analysis.setup,
        codes: analysis.codes,
        unit: analysis.unit,
    }
}

/// Draws the tool paths of both programs.
fn drawing(programs: &[Program; 2], names: &[String; 2], language: Language) -> String {
    let analysis = &programs[1].analysis;
    let options = SvgOptions {
        x_plus: XPlus::from(analysis.setup.machine.turret),
        scale: Scale::of(analysis.unit),
        ..SvgOptions::default()
    };
    let [first, second] = names.each_ref().map(|name| said_with(Said::OnlyIn, name, language));
    let legend = [first, second, said(Said::InBoth, language).to_owned()];
    overlay(programs.each_ref().map(|program| &program.analysis.motions), &legend, &options)
}

/// Formats a difference for people.
struct Report<'a> {
    rows: &'a ProgramDifference,
    names: &'a [String; 2],
    language: Language,
}

impl Report<'_> {
    fn said(&self, what: Said) -> &'static str {
        said(what, self.language)
    }

    fn with(&self, what: Said, value: impl ToString) -> String {
        said_with(what, &value.to_string(), self.language)
    }

    /// A one-line summary, if the programs are the same in text or in motions.
    fn verdict(&self) -> Option<&'static str> {
        match (self.rows.same_text, self.rows.same_motions) {
            (true, true) => Some(self.said(Said::Same)),
            (false, true) => Some(self.said(Said::TextAlone)),
            (_, false) => None,
        }
    }

    fn text(&self) -> String {
        let rows = self.rows;
        let [first, second] = self.names;
        let mut lines = vec![format!("--- {first}"), format!("+++ {second}")];
        lines.extend(rows.read_as.iter().map(told));
        for hunk in &rows.hunks {
            lines.push(self.place(&hunk.rows));
            for row in &hunk.rows {
                lines.extend(blocks(row));
                lines.extend(row.changes.iter().map(|change| format!("    {}", told(change))));
            }
            if hunk.is_without_motion() {
                lines.push(format!("    {}", self.said(Said::NoMotion)));
            }
            self.later(&hunk.later, Said::Later, "    ", &mut lines);
        }
        if rows.more_blocks > 0 {
            lines.push(self.with(Said::More, rows.more_blocks));
        }
        self.later(&rows.unexplained, Said::Unexplained, "", &mut lines);
        lines.extend(self.verdict().map(str::to_owned));
        if !rows.is_same() {
            lines.push(format!("{}:", self.said(Said::Totals)));
            lines.extend(self.totals().iter().map(|line| format!("  {line}")));
            let part = self.part();
            lines.push(format!("{}:", self.said(Said::Part)));
            lines.extend(part.iter().map(|line| format!("  {line}")));
        }
        for (heading, found) in [(Said::Gone, &rows.gone), (Said::New, &rows.new)] {
            if !found.is_empty() {
                lines.push(format!("{}:", self.said(heading)));
                lines.extend(found.iter().map(|one| format!("  {}", self.message(one))));
            }
        }
        lines.join("\n") + "\n"
    }

    fn markdown(&self) -> String {
        let rows = self.rows;
        let [first, second] = self.names.each_ref().map(|name| code(name));
        let mut lines = vec![format!("### {first} → {second}"), String::new()];
        lines.extend(rows.read_as.iter().map(|own| format!("* {}", told(own))));
        for hunk in &rows.hunks {
            let blocks: Vec<String> = hunk.rows.iter().flat_map(blocks).collect();
            let fence = fence(&blocks);
            lines.extend([format!("{fence}diff"), self.place(&hunk.rows)]);
            lines.extend(blocks);
            lines.extend([fence, String::new()]);
            let changes = hunk.rows.iter().flat_map(|row| &row.changes);
            lines.extend(changes.map(|change| format!("* {}", told(change))));
            if hunk.is_without_motion() {
                lines.push(format!("* {}", self.said(Said::NoMotion)));
            }
            self.later(&hunk.later, Said::Later, "* ", &mut lines);
            lines.push(String::new());
        }
        if rows.more_blocks > 0 {
            lines.extend([self.with(Said::More, rows.more_blocks), String::new()]);
        }
        if rows.unexplained.blocks > 0 {
            self.later(&rows.unexplained, Said::Unexplained, "* ", &mut lines);
            lines.push(String::new());
        }
        if let Some(verdict) = self.verdict() {
            lines.extend([verdict.to_owned(), String::new()]);
        }
        if !rows.is_same() {
            let heading = cell(self.said(Said::Totals));
            lines.extend([format!("| {heading} | {first} | {second} |"), "|---|---|---|".to_owned()]);
            let totals = rows.totals.iter();
            lines.extend(totals.map(|own| {
                let [name, first, second] = [&own.name, &own.first, &own.second].map(|text| cell(text));
                format!("| {name} | {first} | {second} |")
            }));
            lines.push(String::new());
            let part = self.part();
            lines.extend(part.iter().map(|line| format!("* {}: {line}", self.said(Said::Part))));
            lines.push(String::new());
        }
        for (heading, found) in [(Said::Gone, &rows.gone), (Said::New, &rows.new)] {
            if !found.is_empty() {
                lines.extend([format!("{}:", self.said(heading)), String::new()]);
                lines.extend(found.iter().map(|one| format!("* {}", cell(&self.message(one)))));
                lines.push(String::new());
            }
        }
        while lines.last().is_some_and(String::is_empty) {
            lines.pop();
        }
        lines.join("\n") + "\n"
    }

    /// The header of a hunk: `@@ line 5 | line 5 @@`.
    fn place(&self, rows: &[Row]) -> String {
        let lines =
            [rows.iter().find_map(|row| row.first.as_ref()), rows.iter().find_map(|row| row.second.as_ref())];
        let told =
            lines.map(|block| block.map_or("–".to_owned(), |block| self.with(Said::Line, block.line)));
        format!("@@ {} @@", told.join(" | "))
    }

    fn later(&self, later: &Later, heading: Said, before: &str, lines: &mut Vec<String>) {
        if later.blocks == 0 {
            return;
        }
        lines.push(format!("{before}{}", self.with(heading, later.blocks)));
        let indent = " ".repeat(before.len());
        for row in &later.rows {
            let Some(block) = row.second.as_ref().or(row.first.as_ref()) else { continue };
            let text = if before.contains('*') { code(&block.text) } else { block.text.clone() };
            let changes: Vec<String> = row.changes.iter().map(told).collect();
            let bullet = if before.contains('*') { "* " } else { "  " };
            let line = self.with(Said::Line, block.line);
            lines.push(format!("{indent}{bullet}{line}: {text}: {}", changes.join("; ")));
        }
    }

    fn totals(&self) -> Vec<String> {
        let changed: Vec<String> =
            self.rows.totals.iter().filter(|own| own.first != own.second).map(told).collect();
        if changed.is_empty() { vec![self.said(Said::SameTotals).to_owned()] } else { changed }
    }

    fn part(&self) -> Vec<String> {
        let Some(part) = &self.rows.part else { return vec![self.said(Said::NoPart).to_owned()] };
        if part.differences.is_empty() {
            return vec![self.said(Said::SamePart).to_owned()];
        }
        let of = |difference: &crate::api::Difference| {
            let name = if difference.only == "first" { &self.names[0] } else { &self.names[1] };
            let radial = &difference.radial;
            let [from, to] = [radial.from.x, radial.to.x].map(|x| number(x.mm()));
            let [back, front] = difference.z.map(number);
            format!("{}: X{from} … X{to}, Z{back} … Z{front}", self.with(Said::OnlyIn, name))
        };
        part.differences.iter().take(MAX_PIECES).map(of).collect()
    }

    fn message(&self, found: &Diagnostic) -> String {
        format!("{}: {} {}", self.with(Said::Line, found.line), found.code, found.message)
    }
}

/// Maximum number of listed areas of the part, the largest first.
const MAX_PIECES: usize = 20;

/// The blocks of a row in the style of a patch, with `-` and `+`.
fn blocks(row: &Row) -> Vec<String> {
    let line = |sign: char, block: &Option<crate::api::difference::Block>| {
        block.as_ref().map(|block| format!("{sign} {}", block.text))
    };
    [line('-', &row.first), line('+', &row.second)].into_iter().flatten().collect()
}

/// Formats a change: `end point: X50 Z-20 → X49.96 Z-20`.
fn told(change: &Change) -> String {
    if change.first.is_empty() && change.second.is_empty() {
        return change.name.clone();
    }
    format!("{}: {} → {}", change.name, change.first, change.second)
}

/// A code fence that none of the lines closes.
fn fence(lines: &[String]) -> String {
    let longest = lines.iter().flat_map(|line| line.split(|letter| letter != '`')).map(str::len).max();
    "`".repeat(longest.unwrap_or(0).max(2) + 1)
}

/// Formats a text as inline code in Markdown.
fn code(text: &str) -> String {
    let text = text.replace(['\n', '\r'], " ");
    let ticks = fence(std::slice::from_ref(&text));
    let ticks = if text.contains('`') { ticks.as_str() } else { "`" };
    let blank = if text.contains('`') { " " } else { "" };
    format!("{ticks}{blank}{text}{blank}{ticks}")
}

/// Escapes a text for a table cell in Markdown.
pub(super) fn cell(text: &str) -> String {
    text.replace('|', "\\|").replace('<', "&lt;").replace(['\n', '\r'], " ")
}
