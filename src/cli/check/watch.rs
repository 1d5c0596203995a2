//! `check --watch`: the check again whenever a file changes.
//!
//! In: a check. Out: its report, anew after each change of a program, a setup, a configuration, a list of known findings, or of which files
//! there are. It looks at times and lengths a few times a second: that works on every disk, also on those of a network. It ends with the process.

use std::convert::Infallible;
use std::fs;
use std::path::{Path, PathBuf};
use std::thread;
use std::time::{Duration, SystemTime};

use super::super::configuration::{self, Configurations};
use super::super::system::{self, Stream, say};
use super::{Check, paths};
use crate::cli::NAME;

/// How often it looks.
const EVERY: Duration = Duration::from_millis(250);

/// What clears a terminal.
const CLEAR: &[u8] = b"\x1b[2J\x1b[3J\x1b[H";

/// A file, and when it was written with how many bytes; nothing where it is gone.
type Seen = (PathBuf, Option<(SystemTime, u64)>);

/// Checks again and again.
pub(super) fn run(check: &Check) -> Result<Infallible, String> {
    if check.files.iter().any(|file| file == Path::new("-")) {
        return Err("`--watch` looks at files: standard input does not change".to_owned());
    }
    loop {
        // As it was before the check: what is written meanwhile is a change.
        let before = seen(check);
        if system::is_terminal(Stream::Output) {
            use std::io::Write;
            let _ = system::stream(Stream::Output).write_all(CLEAR);
        }
        if let Err(problem) = super::once(check) {
            say(format_args!("{NAME}: {problem}"));
        }
        say(format_args!("{NAME}: waiting for a change; Ctrl C ends"));
        // Of what `--fix` and reports have written nothing is new.
        let after = if check.fix { seen(check) } else { before };
        while seen(check) == after {
            thread::sleep(EVERY);
        }
    }
}

/// All files that have a say, as they are now.
fn seen(check: &Check) -> Vec<Seen> {
    let usual = super::usual_endings(check);
    let mut files: Vec<PathBuf> = check.with.setup.clone();
    files.extend(check.with.config.clone());
    files.extend(check.baseline.named());
    // A configuration that cannot be read is still to be looked at.
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
