//! In: the wasm package. Out: whether every hostile program ends in time, natively and in that package, and a
//! table of the times.

use std::path::PathBuf;
use std::time::Duration;

use crate::run::{self, Result, command, step};

/// Rows of the table on the terminal.
const SHOWN: usize = 12;

/// Runs all of them, in release builds; `report` is the path of the whole table.
pub fn main(report: Option<&PathBuf>) -> Result<Duration> {
    let folder = run::target().join("hostile");
    let mut native = command("cargo");
    native.args(["run", "--quiet", "--release", "--example", "hostile", "--"]).arg(&folder);
    // Link-time optimisation takes longer than all the programs, and makes them only a few percent faster.
    native.envs([("CARGO_PROFILE_RELEASE_LTO", "off"), ("CARGO_PROFILE_RELEASE_CODEGEN_UNITS", "16")]);
    let measured = step("hostile programs, native", &mut native)?;
    let mut node = command("node");
    node.arg("tests/speed/hostile.mjs").arg(&folder).args(["--show", &SHOWN.to_string()]);
    if let Some(report) = report {
        node.arg("--report").arg(report);
    }
    Ok(measured + step("hostile programs, wasm", &mut node)?)
}
