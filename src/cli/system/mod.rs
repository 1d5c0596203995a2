//! The interface to the host system: arguments, files, folders, streams.
//!
//! In: paths, bytes. Out: bytes, and error messages that are the same on every system. The native program
//! uses the standard library (`native`), the module for Node uses `node.js` (`node`), with identical output.
//! `files` implements reading and writing on top of either. Must not know: programs.

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

/// An output stream of the process.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Stream {
    /// Standard output, for results.
    Output,
    /// Standard error, for messages.
    Error,
}

/// Type of a path.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum PathKind {
    /// A file.
    File,
    /// A folder.
    Folder,
    /// A link in a folder, a pipe, or a device.
    Other,
}

/// Metadata of a path; links are followed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Found {
    kind: PathKind,
    /// Unix permissions; 0 on other systems.
    mode: u32,
    /// Unix user and group; 0 on other systems.
    owner: (u32, u32),
    /// Number of hard links; 1 if unknown.
    links: u64,
    /// Device and inode number; `None` on other systems than Unix.
    id: Option<(u64, u64)>,
}

/// An entry of a folder.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Entry {
    /// Its name, without the folder.
    pub name: std::ffi::OsString,
    /// Its type; links are not followed.
    pub kind: PathKind,
}

/// The message for an I/O error, the same on every operating system.
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

/// Writes a line to standard error, with control characters masked. Errors are ignored.
pub(super) fn print_error_line(line: std::fmt::Arguments<'_>) {
    let line = super::terminal::without_commands(format!("{line}\n").as_bytes());
    let _ = stream(Stream::Error).write_all(&line);
}

/// Reads a text file that configures the command, such as a setup.
pub(super) fn read_text(file: &Path) -> Result<String, String> {
    let at = |error: &io::Error| format!("{}: {}", file.display(), reason(error));
    let bytes = read(file, super::limits::TEXT_BUFFER as u64).map_err(|error| match error.kind() {
        ErrorKind::FileTooLarge => {
            format!("{}: more than {} MB", file.display(), super::limits::TEXT_BUFFER >> 20)
        }
        _ => at(&error),
    })?;
    // Windows editors begin a UTF-8 file with a byte order mark.
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").map(<[u8]>::to_vec).unwrap_or(bytes);
    String::from_utf8(bytes).map_err(|_| at(&ErrorKind::InvalidData.into()))
}
