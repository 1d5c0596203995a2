//! `check --watch`: the check again whenever a file changes.
//!
//! In: a check. Out: its report, repeated after each change of a program, a setup, a configuration, a list of
//! known findings, or of the set of files. Polls modification times and sizes a few times a second, because
//! this works on every disk, including network drives. Ends with the process.

use std::convert::Infallible;
use std::fs;
use std::path::{Path, PathBuf};
use std::thread;
use std::time::{Duration, SystemTime};

use super::super::configuration::{self, Configurations};
use super::super::system::{self, Stream, print_error_line};
use super::{Check, paths};
use crate::cli::NAME;

/// Polling interval.
const EVERY: Duration = Duration::from_millis(250);

/// Escape sequences that clear the terminal.
const CLEAR: &[u8] = b"\x1b[2J\x1b[3J\x1b[H";

/// A file with its modification time and size in bytes; `None` if it does not exist.
type Seen = (PathBuf, Option<(SystemTime, u64)>);

/// Checks in a loop.
pub(super) fn run(check: &Check) -> Result<Infallible, String> {
    if check.files.iter().any(|file| file == Path::new("-")) {
        return Err("`--watch` looks at files: standard input does not change".to_owned());
    }
    loop {
        // Taken before the check, so that files written during the check count as changed.
        let before = seen(check);
        if system::is_terminal(Stream::Output) {
            use std::io::Write;
            let _ = system::stream(Stream::Output).write_all(CLEAR);
        }
        if let Err(problem) = super::once(check) {
            print_error_line(format_args!("{NAME}: {problem}"));
        }
        print_error_line(format_args!("{NAME}: waiting for a change; Ctrl C ends"));
        // Files that `--fix` rewrote do not count as changed.
        let after = if check.fix { seen(check) } else { before };
        while seen(check) == after {
            thread::sleep(EVERY);
        }
    }
}

/// All files that affect the result, in their current state.
fn seen(check: &Check) -> Vec<Seen> {
    let usual = super::usual_endings(check);
    let mut files: Vec<PathBuf> = check.with.setup.clone();
    files.extend(check.with.config.clone());
    files.extend(check.baseline.input());
    // A configuration that cannot be read is watched, too.
    files.push(PathBuf::from(configuration::NAME));
    if let Ok(configurations) = Configurations::new(&check.with)
        && let Ok(found) = paths::find(&check.files, &check.which, usual, &configurations)
    {
        for file in &found.files {
            if let Ok(settings) = configurations.settings(file) {
                files.extend(settings.setups.iter().map(|(path, _)| path.clone()));
                files.extend(settings.configuration.iter().map(|one| one.file(configuration::NAME)));
            }
        }
        files.extend(found.files);
    }
    files.sort();
    files.dedup();
    let stamp =
        |file: &Path| fs::metadata(file).ok().and_then(|facts| Some((facts.modified().ok()?, facts.len())));
    files
        .into_iter()
        .map(|file| {
            let stamp = stamp(&file);
            (file, stamp)
        })
        .collect()
}
