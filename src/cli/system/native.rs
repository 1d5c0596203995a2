//! By the standard library.

use std::ffi::OsString;
use std::fs::{self, File, OpenOptions};
use std::hash::{BuildHasher, RandomState};
use std::io::{self, ErrorKind, IsTerminal, Read, Seek, Write};
use std::path::{Path, PathBuf};
#[cfg(unix)]
use std::sync::atomic::AtomicBool;

use super::{Entry, Found, PathKind, Stream};

/// A file that is open for writing.
pub(super) use std::fs::File as OpenFile;

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
pub(super) fn read(file: &Path, most: u64) -> io::Result<Vec<u8>> {
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

/// Reads the first bytes of a file, at most `most`.
pub(super) fn read_head(file: &Path, most: u64) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    File::open(file)?.take(most).read_to_end(&mut bytes)?;
    Ok(bytes)
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

/// Creates a file, where there is none; `mode` before the mask of the process applies.
pub(super) fn create(path: &Path, mode: u32) -> io::Result<OpenFile> {
    let mut options = OpenOptions::new();
    options.write(true).create_new(true);
    #[cfg(unix)]
    std::os::unix::fs::OpenOptionsExt::mode(&mut options, mode);
    #[cfg(not(unix))]
    let _ = mode;
    options.open(path)
}

/// Opens a file that exists.
pub(super) fn open_to_write(path: &Path) -> io::Result<OpenFile> {
    OpenOptions::new().write(true).open(path)
}

/// Makes bytes the whole content of a file, and flushes it to the disk.
pub(super) fn write_whole(file: &mut OpenFile, bytes: &[u8]) -> io::Result<()> {
    file.rewind()?;
    file.write_all(bytes)?;
    file.set_len(bytes.len() as u64)?;
    file.sync_all()
}

/// Writes to a device, a pipe, or a file that the path of a descriptor names.
pub(super) fn write_directly(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let mut file = OpenOptions::new().write(true).truncate(true).open(path)?;
    file.write_all(bytes)
}

/// Renames a file over another one.
pub(super) fn rename(from: &Path, to: &Path) -> io::Result<()> {
    fs::rename(from, to)
}

/// Removes a file.
pub(super) fn remove(path: &Path) -> io::Result<()> {
    fs::remove_file(path)
}

/// Flushes the names in a folder to the disk, where the system can do that.
pub(super) fn flush_folder(folder: &Path) {
    if cfg!(unix) {
        let _ = File::open(folder).and_then(|folder| folder.sync_all());
    }
}

/// Gives a file to a user and a group.
#[cfg(unix)]
pub(super) fn set_owner(file: &OpenFile, (user, group): (u32, u32)) -> io::Result<()> {
    std::os::unix::fs::fchown(file, Some(user), Some(group))
}

/// Sets the permissions of a file.
#[cfg(unix)]
pub(super) fn set_mode(file: &OpenFile, mode: u32) -> io::Result<()> {
    file.set_permissions(std::os::unix::fs::PermissionsExt::from_mode(mode))
}

// Outside of Unix a new file gets owner and permissions from its folder.
#[cfg(not(unix))]
pub(super) fn set_owner(_: &OpenFile, _: (u32, u32)) -> io::Result<()> {
    Ok(())
}

#[cfg(not(unix))]
pub(super) fn set_mode(_: &OpenFile, _: u32) -> io::Result<()> {
    Ok(())
}

/// A number that another process is unlikely to get.
pub(super) fn random() -> u64 {
    RandomState::new().hash_one(std::process::id())
}

/// Makes a write beyond the size limit for files an error, as under Node. By default, its signal ends the process.
#[cfg(unix)]
pub(in crate::cli) fn report_size_limit() {
    static WAS_REACHED: AtomicBool = AtomicBool::new(false);
    let _ = signal_hook::flag::register(signal_hook::consts::SIGXFSZ, &WAS_REACHED);
}

#[cfg(not(unix))]
pub(in crate::cli) fn report_size_limit() {}

/// Where a symbolic link leads to; nothing for all else.
pub(super) fn link(path: &Path) -> Option<PathBuf> {
    fs::read_link(path).ok()
}

/// A path without symbolic links.
pub(super) fn canonical(path: &Path) -> io::Result<PathBuf> {
    fs::canonicalize(path)
}

/// What is at a path.
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

/// What is at a path.
#[cfg(not(unix))]
pub(super) fn found(path: &Path) -> io::Result<Found> {
    // The standard library does not report the number of hard links here.
    let kind = kind(path)?;
    Ok(Found { kind, mode: 0, owner: (0, 0), links: 1, id: None })
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
