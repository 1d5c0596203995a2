//! `check --diff`: the repairs that `check --fix` would make, as a unified diff.
//!
//! In: the files, the options. Out: the diff, and the exit status: 1 if there are repairs. No program is written.

use std::path::Path;

use super::super::encoding::Encoding;
use super::super::system::{self, Stream, print_error_line};
use super::super::unified::unified;
use super::super::{NAME, Status, counted, save_apart};
use super::job::{Job, Source};
use super::paths;

/// The repairs of a file.
struct Repairs {
    /// How many there are.
    count: usize,
    /// Their diff, in the encoding in which it is written.
    diff: Vec<u8>,
}

/// Writes the diff of all files.
pub(super) fn run(job: &Job<'_>, found: &paths::Found) -> Result<Status, String> {
    let mut problems = found.problems.clone();
    let (mut diff, mut repairs, mut files) = (Vec::new(), 0, 0);
    let collected = job.in_order(
        &found.files,
        |file| repairs_of(job, file),
        |done| {
            match done {
                Ok(own) => {
                    diff.extend(own.diff);
                    repairs += own.count;
                    files += usize::from(own.count > 0);
                }
                Err(problem) => problems.push(problem),
            }
            Ok(())
        },
    );
    collected.map_err(|error| system::reason(&error))?;
    save_apart(job.check.output_file.as_deref(), &diff)?;
    job.print_problems(&mut problems, found);
    if repairs > 0 && !job.check.quiet {
        let (repairs, files) = (counted(repairs, "repair"), counted(files, "file"));
        print_error_line(format_args!("{NAME}: {repairs} in {files}; `--fix` makes them"));
    }
    Ok(job.status(&problems, repairs > 0))
}

/// The repairs of a file.
fn repairs_of(job: &Job<'_>, file: &Path) -> Result<Repairs, String> {
    let settings = job.configurations.settings(job.given_name(file).map_or(file, Path::new))?;
    let setup = job.selection.setup(&settings);
    let Source { name, text, encoding } = job.read(file, &setup)?;
    let repaired = job.repaired(&name, &text, &settings, &setup)?;
    let [before, after] = [&text, &repaired.text].map(|text| String::from_utf8_lossy(text));
    let diff = unified(&name, [&before, &after]);
    let is_shown = job.check.output_file.is_none() && system::is_terminal(Stream::Output);
    let diff = if is_shown { diff.into_bytes() } else { in_encoding(encoding, diff) };
    Ok(Repairs { count: repaired.taken.len(), diff })
}

/// A diff in the encoding of its file, so that `patch` finds the lines. UTF-16 is no encoding of a patch: such
/// a diff is UTF-8.
fn in_encoding(encoding: Encoding, diff: String) -> Vec<u8> {
    let bytes = match encoding {
        Encoding::Utf16(..) => None,
        Encoding::Utf8 | Encoding::Legacy(_) => encoding.encode(&diff).map(|bytes| bytes.into_owned()),
    };
    bytes.unwrap_or_else(|| diff.into_bytes())
}
