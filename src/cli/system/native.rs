//! By the standard library.

use std::ffi::OsString;
use std::fs::{self, File};
use std::io::{self, ErrorKind, IsTerminal, Read, Write};
use std::path::{Path, PathBuf};

use super::{Entry, PathKind, Stream};

/// What was typed, with the name of the program first.
pub(in crate::cli) fn arguments() -> Vec<OsString> {
    std::env::args_os().collect()
}

/// A variable of the environment; nothing where it is not set or empty.
pub(in crate::cli) fn variable(name: &str) -> Option<String> {
    std::env::var_os(name).map(|value| value.to_string_lossy().into_owned()).filter(|value| !value.is_empty())
}

/// How many files can be worked on at once.
pub(in crate::cli) fn processors() -> usize {
    std::thread::available_parallelism().map_or(1, usize::from)
}

/// Reads a file of at most so many bytes. The error of a larger one is `FileTooLarge`; it is not read.
pub(in crate::cli) fn read(file: &Path, most: u64) -> io::Result<Vec<u8>> {
    let opened = File::open(file)?;
    let kind = opened.metadata()?;
    if kind.is_dir() {
        return Err(ErrorKind::IsADirectory.into());
    }
    if kind.len() > most {
        return Err(ErrorKind::FileTooLarge.into());
    }
    // What is no file, such as a pipe, has no length.
    within(opened, most)
}

/// Reads standard input, no further than one byte beyond the limit.
pub(in crate::cli) fn read_standard_input(most: u64) -> io::Result<Vec<u8>> {
    within(io::stdin().lock(), most)
}

fn within(from: impl Read, most: u64) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    from.take(most + 1).read_to_end(&mut bytes)?;
    if bytes.len() as u64 > most { Err(ErrorKind::FileTooLarge.into()) } else { Ok(bytes) }
}

/// Writes a file.
pub(in crate::cli) fn write(file: &Path, bytes: &[u8]) -> io::Result<()> {
    fs::write(file, bytes)
}

/// What a path leads to; links are followed.
pub(in crate::cli) fn kind(path: &Path) -> io::Result<PathKind> {
    fs::metadata(path).map(|found| kind_of(found.file_type()))
}

/// What is in a folder, by name.
pub(in crate::cli) fn entries(folder: &Path) -> io::Result<Vec<Entry>> {
    let mut entries = Vec::new();
    for entry in fs::read_dir(folder)? {
        let entry = entry?;
        entries.push(Entry { name: entry.file_name(), kind: kind_of(entry.file_type()?) });
    }
    entries.sort_by(|a, b| a.name.cmp(&b.name));
    Ok(entries)
}

fn kind_of(kind: fs::FileType) -> PathKind {
    match () {
        () if kind.is_file() => PathKind::File,
        () if kind.is_dir() => PathKind::Folder,
        () => PathKind::Other,
    }
}

/// A path from the root of the disk, without `.` and `..`.
pub(in crate::cli) fn absolute(path: &Path) -> io::Result<PathBuf> {
    let mut absolute = PathBuf::new();
    for part in std::path::absolute(path)?.components() {
        match part {
            std::path::Component::ParentDir => {
                absolute.pop();
            }
            part => absolute.push(part),
        }
    }
    Ok(absolute)
}

/// A stream to write to.
pub(in crate::cli) fn stream(stream: Stream) -> Box<dyn Write> {
    match stream {
        Stream::Output => Box::new(io::stdout().lock()),
        Stream::Error => Box::new(io::stderr().lock()),
    }
}

/// Whether a stream goes to a terminal.
pub(in crate::cli) fn is_terminal(stream: Stream) -> bool {
    match stream {
        Stream::Output => io::stdout().is_terminal(),
        Stream::Error => io::stderr().is_terminal(),
    }
}
