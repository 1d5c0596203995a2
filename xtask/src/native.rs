//! In: the sources. Out: the programs that run on this machine, in `target/debug`: the command line and the examples.
//!
//! They are built with the features that the tests give to the whole workspace: after the tests nothing is compiled anew.

use std::env;
use std::path::PathBuf;
use std::process::Command;

use crate::run::{self, Result, step};

/// The command line, built.
pub fn command_line() -> Result<PathBuf> {
    // The example brings the features of the tests.
    build(&["--bin", "gcode-playground", "--example", "npx"])?;
    Ok(run::target().join("debug").join(format!("gcode-playground{}", env::consts::EXE_SUFFIX)))
}

/// An example, built and ready to be started from the root of the repository.
pub fn example(name: &str) -> Result<Command> {
    build(&["--example", name])?;
    let program = run::target().join("debug/examples").join(format!("{name}{}", env::consts::EXE_SUFFIX));
    Ok(run::command(program))
}

fn build(what: &[&str]) -> Result {
    let mut cargo = run::command("cargo");
    cargo.args(["build", "--workspace"]).args(what);
    step(&format!("building {}", what[1]), &mut cargo).map(|_| ())
}
