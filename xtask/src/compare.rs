//! In: options. Out: random programs compared with LinuxCNC's interpreter, by the package in
//! `tests/linuxcnc`. It is a package of its own because it needs the playground, which these commands
//! themselves must not wait for.

use crate::run::{Result, command, not_started, shown};

/// `cargo xtask compare-linuxcnc`.
pub fn main(options: &[String]) -> Result {
    let mut compare = command("cargo");
    compare.args(["run", "--quiet", "--package", "compare-linuxcnc", "--"]).args(options);
    // Its output goes to the terminal as it is, and says what is wrong by itself.
    let status = compare.status().map_err(|error| not_started(&compare, &error))?;
    if status.success() { Ok(()) } else { Err(format!("failed ({status}): {}", shown(&compare))) }
}
