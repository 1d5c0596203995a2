//! In: options. Out: random programs compared with LinuxCNC's interpreter, by the package in
//! `tests/linuxcnc`. It is a separate package because it depends on the playground, and these commands must
//! not wait for that build.

use crate::run::{Result, command, not_started, shown};

/// `cargo xtask compare-linuxcnc`.
pub fn main(options: &[String]) -> Result {
    let mut compare = command("cargo");
    compare.args(["run", "--quiet", "--package", "compare-linuxcnc", "--"]).args(options);
    // Its output goes directly to the terminal and explains failures.
    let status = compare.status().map_err(|error| not_started(&compare, &error))?;
    if status.success() { Ok(()) } else { Err(format!("failed ({status}): {}", shown(&compare))) }
}
