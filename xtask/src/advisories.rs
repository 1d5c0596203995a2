//! In: the lock files, `deny.toml`, and the advisory databases. Out: whether each licence is allowed and no
//! package has an advisory. A check that reached no database has not passed.

use std::fmt;
use std::process::Command;

use crate::run::{self, Result};
use crate::tools;

/// The Rust workspaces. `tests/speed/peers` is left out: it contains programs of others, for comparison only.
const MANIFESTS: [&str; 2] = ["Cargo.toml", "tests/fuzz/Cargo.toml"];

/// The folders of npm packages, left out in the same way.
const NPM_FOLDERS: [&str; 2] = ["www", "editors/vscode"];

/// Checks of cargo-deny: name, arguments, and the words of a report without and with findings.
type Checks = (&'static str, &'static [&'static str], [&'static str; 2]);

const LICENCES: Checks = ("licences", &["licenses", "bans", "sources"], ["licenses ok", "licenses FAILED"]);
const ADVISORIES: Checks = ("advisories", &["advisories"], ["advisories ok", "advisories FAILED"]);

/// The beginning of the report of `npm audit`, without and with advisories.
const NPM: [&str; 2] = ["found 0 vulnerabilities", "# npm audit report"];

/// The result of a check.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Outcome {
    Passed,
    Failed,
    /// The tool ended without a report, for example because it reached no database.
    NotChecked,
}

impl Outcome {
    /// The result of a tool, from its success and its `output`. The output contains one of `reports` for each
    /// check that was carried out.
    fn of(success: bool, output: &str, reports: [&str; 2]) -> Self {
        match (reports.iter().any(|report| output.contains(report)), success) {
            (false, _) => Outcome::NotChecked,
            (true, true) => Outcome::Passed,
            (true, false) => Outcome::Failed,
        }
    }
}

impl fmt::Display for Outcome {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Outcome::Passed => "passed",
            Outcome::Failed => "failed",
            Outcome::NotChecked => "NOT CHECKED",
        })
    }
}

/// `cargo xtask advisories`.
pub fn main() -> Result {
    let deny = tools::cargo_deny()?.join("cargo-deny");
    let mut outcomes = Vec::new();
    for manifest in MANIFESTS {
        for (name, checks, reports) in [LICENCES, ADVISORIES] {
            let mut command = run::command(&deny);
            command
                .args(["--color", "never", "--workspace", "--locked", "--manifest-path", manifest, "check"])
                .args(checks);
            outcomes.push((format!("{name} of {manifest}"), check(&mut command, reports)?));
        }
    }
    for folder in NPM_FOLDERS {
        let mut audit = run::npm();
        audit.current_dir(run::root().join(folder)).arg("audit");
        outcomes.push((format!("advisories of {folder}/package-lock.json"), check(&mut audit, NPM)?));
    }
    conclude(&outcomes)
}

/// Runs a tool, and shows its output.
fn check(command: &mut Command, reports: [&str; 2]) -> Result<Outcome> {
    run::say(run::shown(command));
    let output = run::capture(command)?;
    let text =
        [output.stdout, output.stderr].map(|bytes| String::from_utf8_lossy(&bytes).into_owned()).concat();
    eprint!("{text}");
    Ok(Outcome::of(output.status.success(), &text, reports))
}

/// Prints the result of each check. Returns an error unless all have passed.
fn conclude(outcomes: &[(String, Outcome)]) -> Result {
    let list: Vec<_> = outcomes.iter().map(|(name, outcome)| format!("  {name}: {outcome}")).collect();
    let list = list.join("\n");
    if outcomes.iter().all(|(_, outcome)| *outcome == Outcome::Passed) {
        run::say(format_args!("licences and advisories:\n{list}"));
        Ok(())
    } else {
        Err(format!("licences and advisories:\n{list}"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_a_report_without_findings_passes() {
        let check = |success, output, reports, expected| {
            assert_eq!(Outcome::of(success, output, reports), expected, "{output}");
        };
        check(true, "advisories ok\n", ADVISORIES.2, Outcome::Passed);
        let found = "advisories FAILED\nerror[vulnerability]: Use after free\n";
        check(false, found, ADVISORIES.2, Outcome::Failed);
        let unreachable = "[ERROR] failed to fetch advisory database: Could not resolve host\n";
        check(false, unreachable, ADVISORIES.2, Outcome::NotChecked);
        check(true, "bans ok, licenses ok, sources ok\n", LICENCES.2, Outcome::Passed);
        check(false, "bans ok, licenses FAILED, sources ok\n", LICENCES.2, Outcome::Failed);
        check(false, "bans ok, licenses ok, sources FAILED\n", LICENCES.2, Outcome::Failed);
        check(false, "error: failed to parse deny.toml\n", LICENCES.2, Outcome::NotChecked);
        check(true, "found 0 vulnerabilities\n", NPM, Outcome::Passed);
        check(false, "# npm audit report\n\n1 high severity vulnerability\n", NPM, Outcome::Failed);
        check(false, "npm error audit endpoint returned an error\n", NPM, Outcome::NotChecked);
        // A tool that does nothing and exits with success.
        check(true, "", NPM, Outcome::NotChecked);
    }

    #[test]
    fn a_check_that_was_not_carried_out_is_an_error_and_is_named() {
        let outcomes = |second| [("a".to_owned(), Outcome::Passed), ("b".to_owned(), second)];
        assert_eq!(conclude(&outcomes(Outcome::Passed)), Ok(()));
        let not_checked = conclude(&outcomes(Outcome::NotChecked));
        assert_eq!(not_checked, Err("licences and advisories:\n  a: passed\n  b: NOT CHECKED".to_owned()));
        assert!(conclude(&outcomes(Outcome::Failed)).is_err());
    }
}
