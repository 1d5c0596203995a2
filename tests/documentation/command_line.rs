//! Compares the reference of the command line (`www/docs/command-line.md`) with the help and the output of
//! the commands.

use std::collections::BTreeSet;
use std::process::Command;

use super::{PROGRAM, arguments, commands, first_cells};
use gcode_playground::analyze;
use gcode_playground::export::csv::csv;
use gcode_playground::setup::Setup;

/// The usage lines in the reference, without the name of the program.
fn usage_of_the_reference() -> Vec<String> {
    let lines = commands().into_iter().filter(|(document, _)| *document == "www/docs/command-line.md");
    lines.filter_map(|(_, line)| Some(line.strip_prefix("gcode-playground ")?.to_owned())).collect()
}

/// The long help of a command.
fn help(words: &[&str]) -> String {
    let output = Command::new(env!("CARGO_BIN_EXE_gcode-playground"))
        .args(words)
        .arg("--help")
        .output()
        .expect("help");
    String::from_utf8(output.stdout).expect("UTF-8")
}

/// The names of all commands.
fn subcommands() -> Vec<String> {
    let text = help(&[]);
    let rest = text.split("Commands:").nth(1).unwrap_or_default();
    let lines = rest.lines().skip(1).take_while(|line| line.starts_with(' '));
    let names = lines.filter_map(|line| line.split_whitespace().next());
    let all: Vec<String> = names.filter(|name| *name != "help").map(str::to_owned).collect();
    assert!(all.len() > 5, "{all:?}");
    all
}

#[test]
fn the_reference_lists_every_option_of_the_command_line() {
    let lines = usage_of_the_reference();
    let mut lacking = Vec::new();
    for name in subcommands() {
        let told = help(&[&name]);
        let usage: String = lines.iter().filter(|line| line.starts_with(name.as_str())).cloned().collect();
        assert!(!usage.is_empty(), "the reference does not show `{name}`");
        let options = told.lines().map(str::trim_start).filter(|line| line.starts_with('-'));
        // `- setup: …` is a value of an argument.
        for option in options.filter(|line| !line.starts_with("-h") && !line.starts_with("- ")) {
            // `-o, --output <FILE>`: one of its names is enough.
            let mut names = option.split_whitespace().map(|word| word.trim_end_matches(','));
            let shown = names.any(|name| name.starts_with('-') && usage.contains(name));
            if !shown {
                lacking.push(format!("{name}: {option}"));
            }
        }
    }
    assert!(lacking.is_empty(), "options that the reference does not show:\n{}", lacking.join("\n"));
}

/// The values of options and positional arguments, in both directions.
#[test]
fn the_reference_lists_the_values_of_every_argument() {
    let values = |cell: &str| -> BTreeSet<String> { cell.split_whitespace().map(str::to_owned).collect() };
    let rows = first_cells("www/docs/command-line.md", "| option |");
    // The value of an option such as `--setup` is "a … file", or "a folder".
    let rows = rows.iter().map(|cells| (cells[1].clone(), values(&cells[2])));
    let table: arguments::Values =
        rows.filter(|(_, own)| !own.contains("file") && !own.contains("folder")).collect();
    let lines = usage_of_the_reference();
    for name in subcommands() {
        let own = lines.iter().map(String::as_str);
        let own: Vec<&str> = own.filter(|line| line.split(' ').next() == Some(&name)).collect();
        let documented = arguments::of_usage(&own, &table);
        assert_eq!(arguments::of_help(&help(&[&name])), documented, "{name}: in the help, in the reference");
    }
}

#[test]
fn the_reference_describes_every_file_that_is_exported() {
    let rows = first_cells("www/docs/command-line.md", "| format |");
    let described: BTreeSet<String> =
        rows.iter().flat_map(|cells| cells[1].split_whitespace()).map(str::to_owned).collect();
    assert_eq!(arguments::of_help(&help(&["export"])).get(""), Some(&described));
}

#[test]
fn the_reference_lists_the_columns_of_the_table_of_motions() {
    let rows = first_cells("www/docs/command-line.md", "| format |");
    let row = rows.iter().find(|cells| cells[1] == "csv").expect("a row for csv");
    let listed = row[2].split("Columns: ").nth(1).and_then(|rest| rest.split(';').next());
    let analysis = analyze(PROGRAM.as_bytes(), &Setup::default());
    let table = csv(&analysis.motions, &analysis.setup.machine);
    assert_eq!(listed.map(|listed| listed.replace(' ', ",")).as_deref(), table.lines().next());
}
