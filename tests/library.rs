//! The three functions of the crate give the same results as the command line, for all test programs.
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use gcode_playground::sentences::Language;
use gcode_playground::setup::Setup;
use gcode_playground::{check, motions, repair};
use serde_json::Value;

/// For each program: its file, the file of its setup, and the setup.
fn programs() -> Vec<(PathBuf, Option<PathBuf>, Setup)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/programs");
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).expect("tests/programs").flatten() {
        let (program, setup) = (entry.path().join("program.nc"), entry.path().join("setup.json"));
        if program.is_file() {
            let file = setup.is_file().then_some(setup);
            let json =
                file.as_ref().map_or("{}".to_owned(), |file| fs::read_to_string(file).expect("a setup"));
            found.push((program, file, Setup::from_json(&json).expect("a setup")));
        }
    }
    found
}

/// The output of a command, without the notes of `check` and the titles of rules.
fn rows(words: &[&str], program: &Path, setup: Option<&PathBuf>) -> Vec<Value> {
    let mut command = Command::new(env!("CARGO_BIN_EXE_gcode-playground"));
    command.args(words).arg(program).args(setup.iter().flat_map(|file| [Path::new("--setup"), file]));
    let text = String::from_utf8(command.output().expect("it runs").stdout).expect("UTF-8");
    let rows = text.lines().map(|line| serde_json::from_str::<Value>(line).expect("an object a line"));
    let without_file = rows.map(|mut row| {
        // The library does not contain the pages of the rules.
        let object = row.as_object_mut().expect("an object");
        ["file", "title"].iter().for_each(|key| drop(object.remove(*key)));
        row
    });
    without_file.filter(|row| row.get("note").is_none()).collect()
}

/// Rows as serialised: keys without a value are omitted.
fn written<T: serde::Serialize>(rows: &[T]) -> Vec<Value> {
    let line = |row| serde_json::to_string(row).expect("JSON");
    rows.iter().map(|row| serde_json::from_str(&line(row)).expect("JSON")).collect()
}

#[test]
fn check_and_motions_are_those_of_the_command_line() {
    let programs = programs();
    assert!(programs.len() > 40, "{}", programs.len());
    for (file, setup_file, setup) in programs {
        let (text, name) = (fs::read(&file).expect("a program"), file.display());
        let told = written(&check(&text, &setup, Language::Chinese));
        let expected = rows(&["check", "--format", "json", "--lang", "zh"], &file, setup_file.as_ref());
        assert_eq!(told, expected, "messages of {name}");
        let made = written(&motions(&text, &setup));
        assert_eq!(made, rows(&["motions"], &file, setup_file.as_ref()), "motions of {name}");
    }
}

#[test]
fn repair_is_what_the_command_line_writes() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("library");
    fs::create_dir_all(&folder).expect("a folder");
    let file = folder.join("part.nc");
    for text in
        ["O1\r\nGO1 X5O Z-2 F0.1 (FACE\r\nM30\r\n", "G00 X1 Z–5\nG01 X２ F0.1\nM30", "G00 X50 Z2\nM30\n"]
    {
        fs::write(&file, text).expect("a file");
        let mut command = Command::new(env!("CARGO_BIN_EXE_gcode-playground"));
        command.args(["check", "--fix", "--quiet"]).arg(&file).output().expect("it runs");
        let repaired = repair(text.as_bytes(), &Setup::default());
        assert_eq!(fs::read(&file).expect("a file"), repaired.text, "{text}");
        // The fixed text needs no further fixes.
        assert!(repair(&repaired.text, &Setup::default()).taken.is_empty(), "{text}");
    }
}

#[test]
fn any_text_is_answered() {
    for text in [&b""[..], b"\0\xff\xfe%", b"(", b"G00 X1e999", b"#1=[[[["] {
        let setup = Setup::default();
        let _ = (check(text, &setup, Language::Russian), motions(text, &setup), repair(text, &setup));
    }
}
