//! Implements the system interface with the standard library.

use std::ffi::OsString;
use std::fs::{self, File, OpenOptions};
use std::hash::{BuildHasher, RandomState};
use std::io::{self, ErrorKind, IsTerminal, Read, Seek, Write};
use std::path::{Path, PathBuf};
#[cfg(unix)]
use std::sync::atomic::AtomicBool;

use super::{Entry, Found, PathKind, Stream};

/// A file open for writing.
pub(super) use std::fs::File as OpenFile;

/// The command-line arguments; the first is the name of the program.
pub(in crate::cli) fn arguments() -> Vec<OsString> {
    std::env::args_os().collect()
}

/// An environment variable; `None` if it is unset or empty.
pub(in crate::cli) fn variable(name: &str) -> Option<String> {
    std::env::var_os(name).map(|value| value.to_string_lossy().into_owned()).filter(|value| !value.is_empty())
}

/// Number of files that can be processed in parallel.
pub(in crate::cli) fn processors() -> usize {
    std::thread::available_parallelism().map_or(1, usize::from)
}

/// Reads a file of at most `most` bytes. A larger file is not read; the error is `FileTooLarge`.
pub(super) fn read(file: &Path, most: u64) -> io::Result<Vec<u8>> {
    let opened = File::open(file)?;
    let kind = opened.metadata()?;
    if kind.is_dir() {
        return Err(ErrorKind::IsADirectory.into());
    }
    if kind.len() > most {
        return Err(ErrorKind::FileTooLarge.into());
    }
    // A pipe, for example, has no length.
    within(opened, most)
}

/// Reads the first bytes of a file, at most `most`.
pub(super) fn read_head(file: &Path, most: u64) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    File::open(file)?.take(most).read_to_end(&mut bytes)?;
    Ok(bytes)
}

/// Reads standard input; stops one byte past the limit.
pub(in crate::cli) fn read_standard_input(most: u64) -> io::Result<Vec<u8>> {
    within(io::stdin().lock(), most)
}

fn within(from: impl Read, most: u64) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    from.take(most + 1).read_to_end(&mut bytes)?;
    if bytes.len() as u64 > most { Err(ErrorKind::FileTooLarge.into()) } else { Ok(bytes) }
}

/// Creates a file that does not exist yet; `mode` is subject to the umask.
pub(super) fn create(path: &Path, mode: u32) -> io::Result<OpenFile> {
    let mut options = OpenOptions::new();
    options.write(true).create_new(true);
    #[cfg(unix)]
    std::os::unix::fs::OpenOptionsExt::mode(&mut options, mode);
    #[cfg(not(unix))]
    let _ = mode;
    options.open(path)
}

/// Opens an existing file for writing.
pub(super) fn open_to_write(path: &Path) -> io::Result<OpenFile> {
    OpenOptions::new().write(true).open(path)
}

/// Replaces the whole content of a file, and flushes it to the disk.
pub(super) fn write_whole(file: &mut OpenFile, bytes: &[u8]) -> io::Result<()> {
    file.rewind()?;
    file.write_all(bytes)?;
    file.set_len(bytes.len() as u64)?;
    file.sync_all()
}

/// Writes to a device, a pipe, or the path of a file descriptor.
pub(super) fn write_directly(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let mut file = OpenOptions::new().write(true).truncate(true).open(path)?;
    file.write_all(bytes)
}

/// Renames a file, replacing an existing one.
pub(super) fn rename(from: &Path, to: &Path) -> io::Result<()> {
    fs::rename(from, to)
}

pub(super) fn remove(path: &Path) -> io::Result<()> {
    fs::remove_file(path)
}

/// Flushes a folder to the disk, if the system supports it.
pub(super) fn flush_folder(folder: &Path) {
    if cfg!(unix) {
        let _ = File::open(folder).and_then(|folder| folder.sync_all());
    }
}

/// Sets user and group of a file.
#[cfg(unix)]
pub(super) fn set_owner(file: &OpenFile, (user, group): (u32, u32)) -> io::Result<()> {
    std::os::unix::fs::fchown(file, Some(user), Some(group))
}

/// Sets the permissions of a file.
#[cfg(unix)]
pub(super) fn set_mode(file: &OpenFile, mode: u32) -> io::Result<()> {
    file.set_permissions(std::os::unix::fs::PermissionsExt::from_mode(mode))
}

// On other systems than Unix a new file inherits owner and permissions from its folder.
#[cfg(not(unix))]
pub(super) fn set_owner(_: &OpenFile, _: (u32, u32)) -> io::Result<()> {
    Ok(())
}

#[cfg(not(unix))]
pub(super) fn set_mode(_: &OpenFile, _: u32) -> io::Result<()> {
    Ok(())
}

/// A number that is unlikely to be the same in another process.
pub(super) fn random() -> u64 {
    RandomState::new().hash_one(std::process::id())
}

/// Turns a write beyond the file size limit into an error, as in Node. By default, SIGXFSZ ends the process.
#[cfg(unix)]
pub(in crate::cli) fn report_size_limit() {
    static WAS_REACHED: AtomicBool = AtomicBool::new(false);
    let _ = signal_hook::flag::register(signal_hook::consts::SIGXFSZ, &WAS_REACHED);
}

#[cfg(not(unix))]
pub(in crate::cli) fn report_size_limit() {}

/// The target of a symbolic link; `None` for any other path.
pub(super) fn link(path: &Path) -> Option<PathBuf> {
    fs::read_link(path).ok()
}

/// The canonical path, without symbolic links.
pub(super) fn canonical(path: &Path) -> io::Result<PathBuf> {
    fs::canonicalize(path)
}

/// Metadata of a path.
#[cfg(unix)]
pub(super) fn found(path: &Path) -> io::Result<Found> {
    use std::os::unix::fs::MetadataExt;
    let facts = fs::metadata(path)?;
    Ok(Found {
        kind: kind_of(facts.file_type()),
        mode: facts.mode() & 0o7777,
        owner: (facts.uid(), facts.gid()),
        links: facts.nlink(),
        id: Some((facts.dev(), facts.ino())),
    })
}

/// Metadata of a path.
#[cfg(not(unix))]
pub(super) fn found(path: &Path) -> io::Result<Found> {
    // The standard library does not report the number of hard links here.
    let kind = kind(path)?;
    Ok(Found { kind, mode: 0, owner: (0, 0), links: 1, id: None })
}

/// Type of a path; links are followed.
pub(in crate::cli) fn kind(path: &Path) -> io::Result<PathKind> {
    fs::metadata(path).map(|found| kind_of(found.file_type()))
}

/// The entries of a folder, sorted by name.
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

/// The absolute path, without `.` and `..`.
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

/// Opens a stream for writing.
pub(in crate::cli) fn stream(stream: Stream) -> Box<dyn Write> {
    match stream {
        Stream::Output => Box::new(io::stdout().lock()),
        Stream::Error => Box::new(io::stderr().lock()),
    }
}

/// Whether a stream is connected to a terminal.
pub(in crate::cli) fn is_terminal(stream: Stream) -> bool {
    match stream {
        Stream::Output => io::stdout().is_terminal(),
        Stream::Error => io::stderr().is_terminal(),
    }
}
