//! In: the sources. Out: the programs that run on this machine: the command line, the examples and the page
//! writers.
//!
//! Together with the tests they are built in `target/debug`, with the same features that the tests enable in
//! the whole workspace, so that nothing is compiled twice. For the site alone, the page writers are built
//! without the dependencies of the tests.

use std::env;
use std::path::PathBuf;
use std::process::Command;

use crate::run::{self, Result, step};

/// Arguments of `cargo build` that give a program the features of the tests: examples use the
/// dev-dependencies.
const WITH_TESTS: [&str; 3] = ["--workspace", "--example", "npx"];

/// The profile of the page writers without the tests. In the folder of the tests, the library with fewer
/// features would invalidate theirs: cargo writes such a library without a hash in its name.
const PAGES: &str = "pages";

/// Other builds of the same sources in this command.
#[derive(Clone, Copy)]
pub enum Beside {
    /// The tests have been built, or will be.
    Tests,
    /// Nothing.
    Nothing,
}

/// The command line, built.
pub fn command_line() -> Result<PathBuf> {
    build("gcode-playground", &[&WITH_TESTS[..], &["--bin", "gcode-playground"]].concat())?;
    Ok(program("debug", "gcode-playground"))
}

/// An example, built, and ready to start from the root of the repository.
pub fn example(name: &str) -> Result<Command> {
    build(name, &["--workspace", "--example", name])?;
    Ok(run::command(program("debug/examples", name)))
}

/// The program that writes the rule pages into the folder given as its argument.
pub fn rule_pages(beside: Beside) -> Result<Command> {
    page_writer("gcode-playground-rule-pages", "rule-pages", beside)
}

/// The program that writes the reference and the pages of the manual into the site whose folder is its argument.
pub fn reference(beside: Beside) -> Result<Command> {
    page_writer("gcode-playground-reference", "reference", beside)
}

fn page_writer(package: &str, name: &str, beside: Beside) -> Result<Command> {
    let folder = match beside {
        Beside::Tests => {
            build(name, &[&WITH_TESTS[..], &["--bin", name]].concat())?;
            "debug"
        }
        Beside::Nothing => {
            build(name, &["--package", package, "--profile", PAGES])?;
            PAGES
        }
    };
    Ok(run::command(program(folder, name)))
}

fn build(name: &str, arguments: &[&str]) -> Result {
    let mut cargo = run::command("cargo");
    cargo.arg("build").args(arguments);
    step(&format!("building {name}"), &mut cargo).map(drop)
}

/// The file of a program in a subfolder of the target folder.
fn program(folder: &str, name: &str) -> PathBuf {
    run::target().join(folder).join(format!("{name}{}", env::consts::EXE_SUFFIX))
}
