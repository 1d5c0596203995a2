//! In: the wasm package. Out: whether every hostile program ends in time, natively and in that package, and
//! whether the language server answers in time about a program of 20 MB; tables of the times.

use std::path::PathBuf;
use std::process::Command;
use std::time::Duration;

use crate::run::{self, Result, command, step};

/// Rows of the table on the terminal.
const SHOWN: usize = 12;

/// Runs all of them, in release builds; `report` is the path of the whole table.
pub fn main(report: Option<&PathBuf>) -> Result<Duration> {
    let folder = run::target().join("hostile");
    let measured = step("hostile programs, native", example("hostile").arg(&folder))?;
    let mut node = command("node");
    node.arg("tests/speed/hostile.mjs").arg(&folder).args(["--show", &SHOWN.to_string()]);
    if let Some(report) = report {
        node.arg("--report").arg(report);
    }
    Ok(measured + step("hostile programs, wasm", &mut node)?)
}

/// Measures the language server; `report` is the path of the table.
pub fn server(report: Option<&PathBuf>) -> Result<Duration> {
    step("the language server on a program of 20 MB", example("server").args(report))
}

/// Runs an example of the crate in a release build.
fn example(name: &str) -> Command {
    let mut cargo = command("cargo");
    cargo.args(["run", "--quiet", "--release", "--example", name, "--"]);
    // Link-time optimisation takes longer than all the programs, and makes them only a few percent faster.
    cargo.envs([("CARGO_PROFILE_RELEASE_LTO", "off"), ("CARGO_PROFILE_RELEASE_CODEGEN_UNITS", "16")]);
    cargo
}
