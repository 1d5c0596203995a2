//! Tests the ways to check programs in a repository (`www/docs/teams.md`): `tests/teams/run.py` follows them
//! with the real tools.
//!
//! In: the built command line; the built package. Out: whether reports are valid, and whether each way
//! rejects faulty programs. The tools are installed once, in fixed versions, into the cache of the user.

use std::time::Duration;

use crate::run::{self, Result, command, step};
use crate::{debian, native, packages};

/// The schema validator, and the runner of hooks.
const PYTHON: [&str; 2] = ["check-jsonschema==0.39.0", "pre-commit==4.7.0"];

/// The SARIF schema, and the runner of GitLab jobs. Its newest version needs a newer Node.
const NODE: [&str; 2] = ["@microsoft/jest-sarif@1.0.0-beta.0", "gitlab-ci-local@4.68.1"];

/// The ways that are tested.
const WAYS: [&str; 5] = ["sarif", "schemas", "hooks", "action", "gitlab"];

/// `cargo xtask teams`.
pub fn main() -> Result {
    ways().map(|_| ())
}

/// Tests all ways.
pub fn ways() -> Result<Duration> {
    rsync()?;
    let program = native::command_line()?;
    let python = packages::python("teams/python", &PYTHON)?;
    let node = packages::npm("teams/node", &NODE)?;
    let mut ways = command(python.join("python"));
    ways.arg("tests/teams/run.py").arg(&program).arg(run::www().join("dist/embed"));
    ways.arg(node.join("node_modules")).args(WAYS);
    step("checks in a repository", &mut ways)
}

/// Finds or installs `rsync`, which `gitlab-ci-local` uses to copy a repository.
fn rsync() -> Result {
    let is_there = || run::succeeds(command("rsync").arg("--version"));
    if !is_there() && debian::available() {
        debian::install("installing `rsync` for the jobs of GitLab", &["rsync"])?;
    }
    if is_there() {
        Ok(())
    } else {
        Err("`rsync` is needed, to run the jobs of GitLab: install it".to_owned())
    }
}
