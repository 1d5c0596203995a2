//! `grade`: exit status, table, measuring report, CSV, answers that cannot be read, answers with the same text.

use std::process::{Command, Output};

use serde_json::{Value, json};

use crate::folder::{self, Folder, err, out};
use crate::project;

/// A folder with the exercise `thread.md` and answers: names and texts.
fn course(name: &str, answers: &[(&str, &str)]) -> Folder {
    let folder = Folder::new(&format!("grade-{name}"));
    let folder = folder.with("thread.md", project::source("www/exercises/thread.md"));
    answers.iter().fold(folder, |folder, (name, text)| folder.with(name, text))
}

fn grade(folder: &Folder, arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_gcode-playground"));
    command.current_dir(&folder.0).args(["grade", "thread.md"]).args(arguments).output().expect("it runs")
}

/// Standard output of a run with an exit status.
#[track_caller]
fn graded(folder: &Folder, arguments: &[&str], status: i32) -> String {
    let output = grade(folder, arguments);
    assert_eq!(output.status.code(), Some(status), "{arguments:?}: {}", err(&output));
    out(&output)
}

fn answer(name: &str) -> String {
    project::source(&format!("tests/exercise/thread/{name}.nc"))
}

#[test]
fn the_exit_status_says_whether_all_answers_are_passed() {
    let (right, wrong) = (answer("reference"), answer("wrong-1"));
    let course = course("status", &[("a.nc", &right), ("b.nc", &wrong)]);
    let all = graded(&course, &["a.nc"], 0);
    assert!(all.contains("Same part"), "{all}");
    let all = graded(&course, &["a.nc", "b.nc"], 1);
    let rows: Vec<&str> = all.lines().collect();
    assert_eq!(rows.len(), 3, "{all}");
    assert!(rows[1].starts_with("a.nc  20") && rows[1].contains("Same part"), "{all}");
    assert!(rows[2].starts_with("b.nc  0") && rows[2].contains("Z-15: lead 1.5, wanted 2 ±0.001"), "{all}");
}

#[test]
fn an_answer_that_cannot_be_read_is_reported_and_the_others_are_graded() {
    let course = course("unreadable", &[("a.nc", &answer("reference"))]);
    let output = grade(&course, &["missing.nc", "a.nc"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(err(&output).contains("missing.nc"));
    assert!(out(&output).contains("Same part"));
}

#[test]
fn a_fault_of_the_exercise_names_its_line() {
    let course = course("fault", &[("a.nc", "M30\n"), ("thread.md", "---\nid: bad\nkind: sing\n---\n")]);
    let output = grade(&course, &["a.nc"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(err(&output).contains("thread.md:3: "), "{}", err(&output));
}

#[test]
fn answers_with_the_same_text_are_marked_and_no_others() {
    let right = answer("reference");
    // The same words with numbers, comments and blanks; and another first pass.
    let numbered: String = right
        .lines()
        .enumerate()
        .map(|(line, text)| match line {
            0 => format!("{text} (ANNA)\n"),
            _ => format!("N{} {}\n\n", line * 10, text.replace(' ', "  ")),
        })
        .collect();
    let other = right.replace("X29.1", "X29.2");
    let course = course("same", &[("a.nc", &right), ("b.nc", &numbered), ("c.nc", &other)]);
    let all = graded(&course, &["a.nc", "b.nc", "c.nc"], 0);
    let rows: Vec<&str> = all.lines().collect();
    assert!(!rows[1].contains("same text"), "{all}");
    assert!(rows[2].contains("same text as a.nc"), "{all}");
    assert!(!rows[3].contains("same text"), "{all}");
    let output = grade(&course, &["a.nc", "b.nc", "c.nc", "--format", "json"]);
    let same: Vec<Value> = folder::rows(&output).iter().map(|row| row["sameTextAs"].clone()).collect();
    assert_eq!(same, [Value::Null, json!("a.nc"), Value::Null]);
}

#[test]
fn details_are_the_measuring_report_and_the_checks() {
    let course = course("details", &[("b.nc", &answer("wrong-2"))]);
    let all = graded(&course, &["b.nc", "--details"], 1);
    let row = |name: &str| {
        let mut rows = all.lines().filter(|line| line.trim_start().starts_with(name));
        let row = rows.next().unwrap_or_else(|| panic!("no {name} in {all}"));
        row.split_whitespace().map(str::to_owned).collect::<Vec<_>>()
    };
    // The last pass is at X28.2 instead of X27.4; lead and length are right.
    assert_eq!(
        row("root diameter"),
        ["root", "diameter", "Z-15", "27.4", "28.2", "0.8", "-0.1", "…", "+0.1", "OUT"]
    );
    assert_eq!(row("lead"), ["lead", "Z-15", "2", "2", "0", "-0.001", "…", "+0.001", "in"]);
    assert_eq!(
        row("crest diameter"),
        ["crest", "diameter", "Z-15", "30", "30", "0", "-0.1", "…", "+0.1", "in"]
    );
    let markdown = graded(&course, &["b.nc", "--details", "--format", "markdown"], 1);
    assert!(markdown.contains("\n### b.nc\n"), "{markdown}");
    assert!(markdown.contains("| root diameter | Z-15 | 27.4 | 28.2 | 0.8 |"), "{markdown}");
}

#[test]
fn no_cell_of_csv_is_a_formula() {
    let right = answer("reference");
    let course = course("csv", &[("=1+1.nc", &right), ("a, \"b\".nc", &right)]);
    let text = graded(&course, &["=1+1.nc", "a, \"b\".nc", "--format", "csv"], 0);
    let rows: Vec<&str> = text.split("\r\n").collect();
    assert_eq!(rows.len(), 4, "{text}");
    assert!(rows[1].starts_with("'=1+1.nc,true,20,true,Same part,"), "{text}");
    assert!(rows[2].starts_with("\"a, \"\"b\"\".nc\",true,20,"), "{text}");
    assert!(rows[2].ends_with(",'=1+1.nc"), "{text}");
}

#[test]
fn the_table_is_written_in_the_language_of_the_teacher() {
    let course = course("language", &[("a.nc", &answer("reference"))]);
    assert!(graded(&course, &["a.nc", "--lang", "zh"], 0).contains("零件相同"));
    assert!(graded(&course, &["a.nc", "--lang", "ru"], 0).contains("Деталь та же"));
}
