//! The page "Checks in a repository": its files equal the example, its commands work there as described, its
//! tables match `action.yml` and `templates/check.yml` (`UPDATE_EXPECT=1 cargo test --test it teams::` writes
//! them), and all of them name the current version.
//!
//! `tests/teams/run.py` runs the tools on these files; `cargo xtask teams` calls it.

use crate::markdown;
use crate::project;
use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use expect_test::expect_file;

use markdown::Document;
use project::{ROOT, files, source};

const PAGE: &str = "www/docs/teams.md";
const EXAMPLE: &str = "tests/example-repository/";

/// The files of the example, by relative path.
fn example() -> Vec<(String, String)> {
    let names = files().into_iter().filter_map(|file| file.strip_prefix(EXAMPLE).map(str::to_owned));
    names.map(|name| (source(&format!("{EXAMPLE}{name}")), name)).map(|(text, name)| (name, text)).collect()
}

fn is_command(line: &str) -> bool {
    ["gcode-playground ", "pip install ", "pre-commit "].iter().any(|start| line.starts_with(start))
}

#[test]
fn each_block_is_a_file_of_the_example_or_commands() {
    let example = example();
    let mut shown = Vec::new();
    for block in Document::read(&source(PAGE)).blocks {
        if block.lines().all(is_command) {
            continue;
        }
        let file = example.iter().find(|(_, text)| text.trim_end() == block);
        let (name, _) = file.unwrap_or_else(|| panic!("no file of {EXAMPLE} is\n{block}"));
        shown.push(name.as_str());
    }
    // Files that a reader has to write are shown in full.
    let of_the_ways = [
        "gcode-playground.toml",
        "setup.json",
        ".pre-commit-config.yaml",
        ".pre-commit-config-npm.yaml",
        ".github/workflows/programs.yml",
        ".gitlab-ci.yml",
    ];
    assert_eq!(shown, of_the_ways);
    for (name, _) in &example {
        assert!(
            shown.contains(&name.as_str()) || source(PAGE).contains(&format!("| `{name}` |")),
            "{PAGE} does not say what {name} is"
        );
    }
}

/// A copy of the example.
fn copy(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("teams").join(name);
    let _ = fs::remove_dir_all(&folder);
    for (name, text) in example() {
        let path = folder.join(name);
        fs::create_dir_all(path.parent().expect("a folder")).expect("a folder");
        fs::write(path, text).expect("a file");
    }
    folder
}

fn call(folder: &Path, words: &str) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_gcode-playground"));
    command.current_dir(folder).args(words.split(' ')).output().expect("it runs")
}

#[test]
fn its_commands_end_as_it_says() {
    let folder = copy("commands");
    let blocks = Document::read(&source(PAGE)).blocks;
    let lines = blocks.iter().flat_map(|block| block.lines());
    let calls: Vec<&str> = lines.filter_map(|line| line.strip_prefix("gcode-playground ")).collect();
    let written = "check . --write-baseline known.json";
    let expected = [written, "check .", "check --markdown manual"];
    assert_eq!(calls, expected);
    let status = |words: &str| call(&folder, words).status.code();
    // The baseline is written before the configuration names it.
    let file = folder.join("gcode-playground.toml");
    let configuration = fs::read_to_string(&file).expect("a configuration");
    let before = configuration.replace("baseline = \"known.json\"\n", "");
    assert_ne!(before, configuration);
    fs::write(&file, before).expect("a configuration");
    fs::remove_file(folder.join("known.json")).expect("known.json");
    assert_eq!(status(written), Some(1));
    fs::write(&file, configuration).expect("a configuration");
    assert_eq!(expected[1..].iter().map(|words| status(words)).collect::<Vec<_>>(), [Some(0), Some(0)]);
    let list = fs::read_to_string(folder.join("known.json")).expect("known.json");
    assert_eq!(list, source(&format!("{EXAMPLE}known.json")), "`{written}` writes the list of the example");
}

#[test]
fn only_the_old_program_of_the_example_has_findings() {
    let output = call(&copy("findings"), "check . --no-config --setup setup.json --format json -q");
    let text = String::from_utf8(output.stdout).expect("UTF-8");
    assert!(!text.is_empty());
    for line in text.lines() {
        assert!(line.contains("programs/bushing.nc"), "{line}");
    }
}

/// A table of inputs, from a YAML file in which each input has a description and perhaps a default, one line
/// each.
fn table(file: &str) -> String {
    let text = source(file);
    let mut rows: Vec<(String, String, String)> = Vec::new();
    let mut depth = None;
    for line in text.lines().skip_while(|line| line.trim() != "inputs:") {
        let indent = line.len() - line.trim_start().len();
        let outside = *depth.get_or_insert(indent);
        let Some((name, value)) = line.trim().split_once(':') else { break };
        let value = value.trim().trim_matches('\'').to_owned();
        match name {
            "inputs" if indent == outside => {}
            _ if indent <= outside => break,
            _ if indent == outside + 2 => rows.push((name.to_owned(), String::new(), String::new())),
            "description" => rows.last_mut().expect("an input").2 = value,
            "default" => rows.last_mut().expect("an input").1 = value,
            _ => panic!("{file}: {line}"),
        }
    }
    let mut table = String::from("| input | default | meaning |\n|---|---|---|\n");
    for (name, default, meaning) in rows {
        let default = if default.is_empty() { default } else { format!("`{default}`") };
        let _ = writeln!(table, "| `{name}` | {default} | {} |", meaning.trim_end_matches('.'));
    }
    table
}

#[test]
fn the_tables_are_those_of_the_files() {
    let path = Path::new(ROOT).join(PAGE);
    for (name, file) in [("action", "action.yml"), ("template", "templates/check.yml")] {
        let page = source(PAGE);
        let (begin, end) = (format!("<!-- {name} -->\n"), format!("<!-- /{name} -->"));
        let (before, rest) = page.split_once(&begin).expect("a table");
        let (_, after) = rest.split_once(&end).expect("its end");
        let table = table(file);
        assert!(table.lines().count() > 5, "{file}: {table}");
        expect_file![&path].assert_eq(&format!("{before}{begin}{table}{end}{after}"));
    }
}

#[test]
fn all_of_them_name_this_version() {
    let version = env!("CARGO_PKG_VERSION");
    let mut texts = example();
    texts.extend(["action.yml", "templates/check.yml", PAGE].map(|name| (name.to_owned(), source(name))));
    let mut found = 0;
    for (name, text) in texts {
        for start in ["gcode-playground@v", "gcode-playground@", "rev: v", "raw/v", "default: 0.", "`v0."] {
            for (at, _) in text.match_indices(start) {
                let rest = &text[at..];
                let number = rest.find(|letter: char| letter.is_ascii_digit()).map(|from| &rest[from..]);
                // The package name before a version that is an input.
                if number.is_none() || rest.starts_with("gcode-playground@$") {
                    continue;
                }
                assert!(number.is_some_and(|number| number.starts_with(version)), "{name}: {}", &rest[..40]);
                found += 1;
            }
        }
    }
    assert!(found >= 9, "{found}");
}

#[test]
fn the_hooks_take_the_files_that_a_folder_stands_for() {
    let hooks = source(".pre-commit-hooks.yaml");
    for (file, list, count) in [("subprograms.rs", "ENDINGS", 1), ("check/paths.rs", "PAGES", 1)] {
        let lists = source(&format!("src/cli/{file}"));
        let (_, rest) = lists.split_once(&format!("const {list}: &[&str] =")).expect(list);
        let words = rest.split(';').next().expect("a list");
        let endings: Vec<&str> = words.split('"').skip(1).step_by(2).collect();
        assert!(endings.len() > 3, "{endings:?}");
        let pattern = format!("\\.({})", endings.join("|"));
        assert_eq!(hooks.matches(&pattern).count(), count, "{pattern}");
        let with_npm = source(&format!("{EXAMPLE}.pre-commit-config-npm.yaml"));
        assert!(list == "PAGES" || with_npm.contains(&pattern), "{pattern}");
    }
}
