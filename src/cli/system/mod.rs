//! What the command line asks of the machine it runs on: arguments, files, folders, streams.
//!
//! In: paths, bytes. Out: bytes, and errors in words that are the same on every machine. Natively this is the standard library
//! (`native`), under Node the functions of `node.js` (`node`): so one command line is both, with the same output to the byte. `files` says how
//! files are read and written; both have the steps.
//! Must not know: programs.

mod files;
#[cfg(not(target_arch = "wasm32"))]
mod native;
#[cfg(target_arch = "wasm32")]
mod node;

use std::io::{self, ErrorKind, Write};
use std::path::Path;

#[cfg(not(target_arch = "wasm32"))]
use native as host;
#[cfg(target_arch = "wasm32")]
use node as host;

pub(super) use files::{peek, read, same_as, standard, was_read, write};
#[cfg(not(target_arch = "wasm32"))]
pub(super) use host::report_size_limit;
pub(super) use host::{
    absolute, arguments, entries, is_terminal, kind, processors, read_standard_input, stream, variable,
};
#[cfg(target_arch = "wasm32")]
pub(super) use node::end;

/// A stream of text to the reader.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Stream {
    /// Standard output: results.
    Output,
    /// Standard error: what is said about the work.
    Error,
}

/// What a path leads to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum PathKind {
    /// A file.
    File,
    /// A folder.
    Folder,
    /// A link in a folder, a pipe, a device.
    Other,
}

/// What is at a path; links are followed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Found {
    kind: PathKind,
    /// Permissions, as Unix numbers them; 0 elsewhere.
    mode: u32,
    /// User and group, as Unix numbers them; 0 elsewhere.
    owner: (u32, u32),
    /// The number of hard links; 1 where it is unknown.
    links: u64,
    /// File system and number of the file; unknown outside of Unix.
    id: Option<(u64, u64)>,
}

/// What a folder has in it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Entry {
    /// Its name in the folder.
    pub name: std::ffi::OsString,
    /// What it is; links are not followed.
    pub kind: PathKind,
}

/// What went wrong with a file, in words that no operating system changes.
pub(super) fn reason(error: &io::Error) -> String {
    match error.kind() {
        ErrorKind::NotFound => "no such file or folder".to_owned(),
        ErrorKind::PermissionDenied => "access is denied".to_owned(),
        ErrorKind::IsADirectory => "a folder, not a file".to_owned(),
        ErrorKind::NotADirectory => "a part of the path is no folder".to_owned(),
        ErrorKind::StorageFull => "the disk is full".to_owned(),
        ErrorKind::ReadOnlyFilesystem => "the disk can only be read".to_owned(),
        ErrorKind::QuotaExceeded => "the disk quota is used up".to_owned(),
        ErrorKind::FileTooLarge => "it would exceed the size limit for files".to_owned(),
        ErrorKind::InvalidFilename => "the name is too long or not allowed".to_owned(),
        ErrorKind::BrokenPipe => "the reader has closed the pipe".to_owned(),
        ErrorKind::InvalidData => "it is not UTF-8".to_owned(),
        _ => error.to_string(),
    }
}

/// Says a line on standard error, without commands to a terminal. Where nobody listens, it is lost.
pub(super) fn say(line: std::fmt::Arguments<'_>) {
    let line = super::terminal::without_commands(format!("{line}\n").as_bytes());
    let _ = stream(Stream::Error).write_all(&line);
}

/// A text file that belongs to the work itself, such as a setup.
pub(super) fn read_text(file: &Path) -> Result<String, String> {
    let at = |error: &io::Error| format!("{}: {}", file.display(), reason(error));
    let bytes = read(file, super::limits::TEXT_BUFFER as u64).map_err(|error| match error.kind() {
        ErrorKind::FileTooLarge => {
            format!("{}: more than {} MB", file.display(), super::limits::TEXT_BUFFER >> 20)
        }
        _ => at(&error),
    })?;
    // Editors of Windows begin a file with a mark that says that it is UTF-8.
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").map(<[u8]>::to_vec).unwrap_or(bytes);
    String::from_utf8(bytes).map_err(|_| at(&ErrorKind::InvalidData.into()))
}
