//! `grade`: runs answers with the setup of an exercise, and lists what is right and wrong.
//!
//! In: an exercise file and programs. Out: a table as text, Markdown, CSV or JSON; with `--details` the measuring
//! report and the checks of each answer. Answers with the same text are marked.

use std::collections::HashMap;
use std::path::PathBuf;

use clap::ValueEnum;

use super::diff::cell;
use super::options::{Destination, LanguageOptions};
use super::system::{self, print_error_line};
use super::terminal::json;
use super::{NAME, Status, encoding, read, save_apart};
use crate::api::InFile;
use crate::api::exercise::{Check, Graded, Size};
use crate::exercise::{Exercise, key_of};
use crate::sentences::Language;
use crate::sentences::difference::{Said, clock, said_with};
use crate::sentences::exercise::{Label, label, no_surface};
use crate::sentences::exercise_file::describe_fault;
use crate::units::number;

/// The arguments of `grade`.
#[derive(clap::Args)]
pub(super) struct Grade {
    /// The exercise.
    exercise: PathBuf,
    /// The answers: programs.
    #[arg(required = true)]
    files: Vec<PathBuf>,
    /// Add the measuring report and the checks of each answer.
    #[arg(long)]
    details: bool,
    #[command(flatten)]
    texts: LanguageOptions,
    /// How to write it.
    #[arg(long, value_enum, default_value = "text")]
    format: GradeFormat,
    #[command(flatten)]
    to: Destination,
}

#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum GradeFormat {
    Text,
    Json,
    Csv,
    Markdown,
}

/// An answer with its report.
struct Row {
    file: String,
    graded: Graded,
}

/// Grades the answers; the exit status says whether all of them are passed.
pub(super) fn run(arguments: &Grade) -> Result<Status, String> {
    let language = arguments.texts.language();
    let exercise = exercise(&arguments.exercise, language)?;
    let (rows, is_complete) = rows(arguments, &exercise, language);
    let report = Report { language, has_details: arguments.details };
    let text = match arguments.format {
        GradeFormat::Text => report.text(&rows),
        GradeFormat::Markdown => report.markdown(&rows),
        GradeFormat::Csv => csv(&rows),
        GradeFormat::Json => lines_of_json(&rows)?,
    };
    save_apart(arguments.to.file(), text.as_bytes())?;
    let is_passed = rows.iter().all(|row| row.graded.passed);
    Ok(if is_complete { Status::faulty_if(!is_passed) } else { Status::Unusable })
}

/// Reads the exercise file.
fn exercise(file: &std::path::Path, language: Language) -> Result<Exercise, String> {
    let text = system::read_text(file)?;
    Exercise::read(&text)
        .map_err(|error| format!("{}:{}: {}", file.display(), error.line, describe_fault(&error, language)))
}

/// The reports on all answers that can be read, and whether these are all.
fn rows(arguments: &Grade, exercise: &Exercise, language: Language) -> (Vec<Row>, bool) {
    let mut first_with: HashMap<Vec<u8>, String> = HashMap::new();
    let mut rows = Vec::new();
    for file in &arguments.files {
        let (name, text) = match read(file) {
            Ok((name, text)) => (name, encoding::decode(text).0),
            Err(problem) => {
                print_error_line(format_args!("{NAME}: {problem}"));
                continue;
            }
        };
        let mut graded = Graded::of_answer(exercise, &text, language);
        let earlier = first_with.entry(key_of(&text)).or_insert_with(|| name.clone());
        graded.same_text_as = (*earlier != name).then(|| earlier.clone());
        rows.push(Row { file: name, graded });
    }
    let is_complete = rows.len() == arguments.files.len();
    (rows, is_complete)
}

fn lines_of_json(rows: &[Row]) -> Result<String, String> {
    let line = |row: &Row| json(&InFile { file: &row.file, row: &row.graded }).map(|line| line + "\n");
    rows.iter().map(line).collect::<Result<_, _>>().map_err(|error| error.to_string())
}

/// Formats the reports for people.
struct Report {
    language: Language,
    has_details: bool,
}

impl Report {
    fn label(&self, own: Label) -> &'static str {
        label(own, self.language)
    }

    /// The headings of the table.
    fn headings(&self) -> Vec<String> {
        let labels = [
            Label::File,
            Label::Points,
            Label::Part,
            Label::Failed,
            Label::Problems,
            Label::Time,
            Label::Codes,
        ];
        labels.map(|own| self.label(own).to_owned()).to_vec()
    }

    /// The cells of an answer.
    fn cells(&self, Row { file, graded }: &Row) -> Vec<String> {
        let failed: Vec<&str> = graded.failed().map(|check| check.check.as_str()).collect();
        let time = graded.seconds.map_or_else(|| self.label(Label::Unknown).to_owned(), clock);
        let same = graded.same_text_as.as_ref();
        let same = same.map(|other| format!("; {} {other}", self.label(Label::SameText)));
        vec![
            file.clone(),
            graded.points.to_string(),
            self.part(graded) + &same.unwrap_or_default(),
            if failed.is_empty() { "–".to_owned() } else { failed.join("; ") },
            format!("{}, {}", graded.errors, graded.warnings),
            time,
            graded.codes.join(" "),
        ]
    }

    /// The verdict with its line and cause.
    fn part(&self, graded: &Graded) -> String {
        let line = graded.line.map(|line| self.line(line)).unwrap_or_default();
        let cause = graded.cause.as_ref();
        let cause =
            cause.map(|cause| format!("; {}{}", cause.text, self.line(cause.line))).unwrap_or_default();
        format!("{}{line}{cause}", graded.part)
    }

    /// A line of an answer, in parentheses.
    fn line(&self, line: u32) -> String {
        format!(" ({})", said_with(Said::Line, &line.to_string(), self.language))
    }

    fn text(&self, rows: &[Row]) -> String {
        let mut lines = aligned(&self.table(rows));
        for row in rows.iter().filter(|_| self.has_details) {
            lines.extend([String::new(), format!("{}:", row.file)]);
            lines.extend(aligned(&self.sizes(&row.graded.sizes)).into_iter().map(|line| format!("  {line}")));
            lines.extend(
                aligned(&self.checks(&row.graded.checks)).into_iter().map(|line| format!("  {line}")),
            );
        }
        lines.join("\n") + "\n"
    }

    fn markdown(&self, rows: &[Row]) -> String {
        let mut lines = table_of_markdown(&self.table(rows));
        for row in rows.iter().filter(|_| self.has_details) {
            lines.extend([String::new(), format!("### {}", cell(&row.file)), String::new()]);
            lines.extend(table_of_markdown(&self.sizes(&row.graded.sizes)));
            lines.push(String::new());
            lines.extend(table_of_markdown(&self.checks(&row.graded.checks)));
        }
        lines.join("\n") + "\n"
    }

    fn table(&self, rows: &[Row]) -> Vec<Vec<String>> {
        [self.headings()].into_iter().chain(rows.iter().map(|row| self.cells(row))).collect()
    }

    /// The measuring report.
    fn sizes(&self, sizes: &[Size]) -> Vec<Vec<String>> {
        let labels =
            [Label::Size, Label::Place, Label::Nominal, Label::Actual, Label::Deviation, Label::Tolerance];
        let head = labels.map(|own| self.label(own).to_owned()).into_iter().chain([String::new()]);
        let row = |size: &Size| {
            let verdict = self.label(if size.is_in { Label::In } else { Label::Out });
            vec![
                size.name.to_owned(),
                size.place.clone(),
                number(size.nominal),
                size.actual.map_or_else(|| no_surface(self.language).to_owned(), number),
                size.deviation.map(number).unwrap_or_default(),
                format!("{} … +{}", number(size.lower), number(size.upper)),
                verdict.to_owned(),
            ]
        };
        [head.collect()].into_iter().chain(sizes.iter().map(row)).collect()
    }

    fn checks(&self, checks: &[Check]) -> Vec<Vec<String>> {
        let head = vec![self.label(Label::Checks).to_owned(), String::new(), String::new()];
        let row = |check: &Check| {
            let verdict = self.label(if check.passed { Label::Passed } else { Label::NotPassed });
            let line = check.line.map(|line| self.line(line)).unwrap_or_default();
            vec![check.check.clone(), verdict.to_owned(), format!("{}{line}", check.found)]
        };
        [head].into_iter().chain(checks.iter().map(row)).collect()
    }
}

/// Pads the cells of each column to the same width.
fn aligned(rows: &[Vec<String>]) -> Vec<String> {
    let columns = rows.first().map_or(0, Vec::len);
    let width = |column: usize| rows.iter().map(|row| row[column].chars().count()).max().unwrap_or(0);
    let widths: Vec<usize> = (0..columns).map(width).collect();
    let padded = |row: &Vec<String>| {
        let cells = row.iter().zip(&widths).map(|(cell, width)| format!("{cell:<width$}  "));
        cells.collect::<String>().trim_end().to_owned()
    };
    rows.iter().map(padded).collect()
}

/// The rows of a table in Markdown, the headings first.
fn table_of_markdown(rows: &[Vec<String>]) -> Vec<String> {
    let line = |row: &Vec<String>| {
        let cells: String = row.iter().map(|text| format!(" {} |", cell(text))).collect();
        format!("|{cells}")
    };
    let mut lines: Vec<String> = rows.iter().map(line).collect();
    let columns = rows.first().map_or(0, Vec::len);
    lines.insert(1, format!("|{}", "---|".repeat(columns)));
    lines
}

/// The table as CSV.
fn csv(rows: &[Row]) -> String {
    const HEAD: &str =
        "file,passed,points,same_part,part,line,cause,failed,errors,warnings,seconds,codes,same_text_as";
    let row = |Row { file, graded }: &Row| {
        let failed: Vec<&str> = graded.failed().map(|check| check.check.as_str()).collect();
        let cells = [
            file.clone(),
            graded.passed.to_string(),
            graded.points.to_string(),
            graded.same_part.to_string(),
            graded.part.clone(),
            graded.line.map(|line| line.to_string()).unwrap_or_default(),
            graded.cause.as_ref().map(|cause| cause.text.clone()).unwrap_or_default(),
            failed.join("; "),
            graded.errors.to_string(),
            graded.warnings.to_string(),
            graded.seconds.map(number).unwrap_or_default(),
            graded.codes.join(" "),
            graded.same_text_as.clone().unwrap_or_default(),
        ];
        cells.map(|text| quoted(&text)).join(",")
    };
    let lines = [HEAD.to_owned()].into_iter().chain(rows.iter().map(row));
    lines.map(|line| line + "\r\n").collect()
}

/// A cell of CSV. A spreadsheet must not read the name of a file as a formula.
fn quoted(text: &str) -> String {
    let formula = if text.starts_with(['=', '+', '-', '@', '\t']) { "'" } else { "" };
    let text = format!("{formula}{}", text.replace(['\r', '\n'], " "));
    if text.contains([',', '"']) { format!("\"{}\"", text.replace('"', "\"\"")) } else { text }
}
