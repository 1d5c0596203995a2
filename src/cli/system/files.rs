//! Reads and writes files. A failed write leaves the old file intact.
//!
//! In: paths, bytes. Out: bytes, or the reason why nothing was written. A regular file is replaced: the new
//! content is written to a temporary file in the same folder, flushed to the disk, and renamed. A file with
//! several hard links, or whose owner and mode cannot be given to the new file, is written in place, with a
//! backup until the write succeeds. A symbolic link is kept and its target written. Devices and pipes are
//! written directly. A file that changed on disk since this process read it is not written. Must not know:
//! programs.

use std::collections::BTreeMap;
use std::hash::{DefaultHasher, Hasher};
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

use super::host::{self, OpenFile};
use super::{Found, PathKind, Stream, reason};

/// Maximum number of symbolic links followed, as in Linux.
const LINKS: usize = 40;
/// Maximum number of names tried for a temporary file.
const NAMES: usize = 100;
/// Maximum size of a file that is written in place, bytes: its old content is kept in memory.
const IN_PLACE: u64 = 1 << 30;

/// Length and hash of each file that was read, by [`place`].
static READ: Mutex<BTreeMap<PathBuf, Content>> = Mutex::new(BTreeMap::new());

/// Held while a file is written in place, so that a thread that writes the file by another name sees no
/// partial content.
static IN_PLACE_WRITE: Mutex<()> = Mutex::new(());

/// Length and hash of a file's content.
type Content = (u64, u64);

/// Reads a file of at most `most` bytes. A larger file is the error `FileTooLarge`.
pub(in crate::cli) fn read(file: &Path, most: u64) -> io::Result<Vec<u8>> {
    let bytes = host::read(file, most)?;
    if let Ok(target) = target(file) {
        contents().insert(place(&target), content(&bytes));
    }
    Ok(bytes)
}

/// The first bytes of a file, at most `most`, to detect a program. The file does not count as read.
pub(in crate::cli) fn peek(file: &Path, most: u64) -> io::Result<Vec<u8>> {
    host::read_head(file, most)
}

/// Whether this process has read the path, and it is a regular file.
pub(in crate::cli) fn was_read(file: &Path) -> bool {
    let is_file = host::found(file).is_ok_and(|found| found.kind == PathKind::File);
    is_file && target(file).is_ok_and(|target| contents().contains_key(&place(&target)))
}

/// Returns a predicate: whether another path refers to the same file, by symbolic or hard links.
pub(in crate::cli) fn same_as(file: &Path) -> impl Fn(&Path) -> bool {
    let identity = |path: &Path| {
        let place = target(path).map(|target| place(&target)).ok();
        (place, host::found(path).ok().and_then(|found| found.id))
    };
    let (own_place, own_id) = identity(file);
    move |path| {
        let (place, id) = identity(path);
        place == own_place || id.is_some() && id == own_id
    }
}

/// The standard stream for a device path such as `/dev/stdout`.
pub(in crate::cli) fn standard(path: &Path) -> Option<Stream> {
    match path.to_str()? {
        "/dev/stdout" | "/dev/fd/1" | "/proc/self/fd/1" => Some(Stream::Output),
        "/dev/stderr" | "/dev/fd/2" | "/proc/self/fd/2" => Some(Stream::Error),
        _ => None,
    }
}

/// Writes a file. On error the file keeps its old content; the message begins with the file name.
pub(in crate::cli) fn write(path: &Path, bytes: &[u8]) -> Result<(), String> {
    let written = target(path).map_err(|error| reason(&error)).and_then(|target| {
        write_target(&target, bytes)?;
        if let Some(known) = contents().get_mut(&place(&target)) {
            *known = content(bytes);
        }
        Ok(())
    });
    written.map_err(|problem| format!("{}: {problem}", path.display()))
}

fn write_target(target: &Path, bytes: &[u8]) -> Result<(), String> {
    match host::found(target) {
        Ok(found) if found.kind == PathKind::Folder => Err(reason(&ErrorKind::IsADirectory.into())),
        Ok(found) if found.kind == PathKind::Other || is_descriptor(target) => {
            host::write_directly(target, bytes).map_err(|error| reason(&error))
        }
        Ok(found) => {
            // Renaming would also replace a write-protected file, so check for write permission first.
            host::open_to_write(target).map_err(|error| reason(&error))?;
            match found.links {
                0 | 1 => replace(target, Some(&found), bytes),
                _ => write_in_place(target, &found, bytes),
            }
        }
        Err(error) if error.kind() == ErrorKind::NotFound => replace(target, None, bytes),
        Err(error) => Err(reason(&error)),
    }
}

/// Renames a new file over the old one, if any.
fn replace(target: &Path, old: Option<&Found>, bytes: &[u8]) -> Result<(), String> {
    let mut new = Temporary::beside(target, if old.is_some() { 0o600 } else { 0o666 })?;
    host::write_whole(&mut new.file, bytes).map_err(|error| reason(&error))?;
    if let Some(old) = old
        && new.make_like(old).is_err()
    {
        drop(new);
        return write_in_place(target, old, bytes);
    }
    if is_written_by_others(target, bytes)? {
        return Ok(());
    }
    match (new.rename(target), old) {
        (Ok(()), _) => {
            host::flush_folder(folder_of(target));
            Ok(())
        }
        // The file is a mount point, as in a container.
        (Err(error), Some(old)) if error.kind() == ErrorKind::ResourceBusy => {
            write_in_place(target, old, bytes)
        }
        (Err(error), _) => Err(reason(&error)),
    }
}

/// Overwrites the old file, and restores it if that fails.
fn write_in_place(target: &Path, old: &Found, bytes: &[u8]) -> Result<(), String> {
    let _alone = IN_PLACE_WRITE.lock().unwrap_or_else(PoisonError::into_inner);
    let mut backup = Temporary::beside(target, 0o600)?;
    let before = host::read(target, IN_PLACE).map_err(|error| reason(&error))?;
    host::write_whole(&mut backup.file, &before).map_err(|error| reason(&error))?;
    // A backup that is left behind should rather be readable by its owner alone than be lost.
    let _ = backup.make_like(old);
    if is_written_by_others(target, bytes)? {
        return Ok(());
    }
    let mut file = host::open_to_write(target).map_err(|error| reason(&error))?;
    let Err(error) = host::write_whole(&mut file, bytes) else { return Ok(()) };
    let problem = reason(&error);
    match host::write_whole(&mut file, &before) {
        Ok(()) => Err(problem),
        Err(_) => Err(format!("{problem}; its old content is in {}", backup.keep().display())),
    }
}

/// Whether another process already wrote the new content. Returns an error if the file changed otherwise
/// since it was read.
fn is_written_by_others(target: &Path, bytes: &[u8]) -> Result<bool, String> {
    let Some(read) = contents().get(&place(target)).copied() else { return Ok(false) };
    match host::read(target, read.0.max(bytes.len() as u64)) {
        Ok(now) if content(&now) == read => Ok(false),
        Ok(now) if now == bytes => Ok(true),
        _ => {
            Err("changed on disk after it was read, so it is not overwritten; run the command again"
                .to_owned())
        }
    }
}

/// A temporary file, removed on drop unless it was renamed or kept.
struct Temporary {
    file: OpenFile,
    /// `None` after it was renamed or kept.
    path: Option<PathBuf>,
}

impl Temporary {
    /// Creates a file in the folder of another one; `mode` is subject to the umask.
    fn beside(target: &Path, mode: u32) -> Result<Self, String> {
        let mut tries = 0..NAMES;
        loop {
            // Independent of the target's name, which may already have the maximum length.
            let path = folder_of(target).join(format!(".gcode-playground-{:016x}.tmp", host::random()));
            match host::create(&path, mode) {
                Ok(file) => return Ok(Self { file, path: Some(path) }),
                Err(error) if error.kind() == ErrorKind::AlreadyExists && tries.next().is_some() => {}
                Err(error) => {
                    let is_closed =
                        matches!(error.kind(), ErrorKind::PermissionDenied | ErrorKind::ReadOnlyFilesystem);
                    let whose = if is_closed { "its folder cannot be written: " } else { "" };
                    return Err(format!("{whose}{}", reason(&error)));
                }
            }
        }
    }

    /// Copies owner, group and mode of another file.
    fn make_like(&self, old: &Found) -> io::Result<()> {
        let Some(path) = &self.path else { return Ok(()) };
        if host::found(path)?.owner != old.owner {
            host::set_owner(&self.file, old.owner)?;
        }
        // A change of owner clears mode bits.
        if host::found(path)?.mode != old.mode {
            host::set_mode(&self.file, old.mode)?;
        }
        Ok(())
    }

    fn rename(mut self, to: &Path) -> io::Result<()> {
        if let Some(path) = &self.path {
            host::rename(path, to)?;
        }
        self.path = None;
        Ok(())
    }

    fn keep(mut self) -> PathBuf {
        self.path.take().unwrap_or_default()
    }
}

impl Drop for Temporary {
    fn drop(&mut self) {
        if let Some(path) = &self.path {
            let _ = host::remove(path);
        }
    }
}

/// Follows symbolic links to a path that is not a link; it need not exist.
fn target(path: &Path) -> io::Result<PathBuf> {
    let mut path = path.to_owned();
    for _ in 0..LINKS {
        match host::link(&path).filter(|_| !is_descriptor(&path)) {
            Some(to) => path = folder_of(&path).join(to),
            None => return Ok(path),
        }
    }
    Err(io::Error::other("too many symbolic links"))
}

/// Whether a path names an open file of a process; its link need not be a valid path.
fn is_descriptor(path: &Path) -> bool {
    path.starts_with("/proc") || path.starts_with("/dev/fd")
}

fn folder_of(path: &Path) -> &Path {
    path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."))
}

/// The canonical path of a target, without symbolic links.
fn place(target: &Path) -> PathBuf {
    match (host::canonical(folder_of(target)), target.file_name()) {
        (Ok(folder), Some(name)) => folder.join(name),
        _ => target.to_owned(),
    }
}

fn contents() -> MutexGuard<'static, BTreeMap<PathBuf, Content>> {
    READ.lock().unwrap_or_else(PoisonError::into_inner)
}

fn content(bytes: &[u8]) -> Content {
    let mut hasher = DefaultHasher::new();
    hasher.write(bytes);
    (bytes.len() as u64, hasher.finish())
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::*;

    /// Writes a file that was changed to `changed` (or removed) after it was read; returns its content and
    /// the error.
    fn written(changed: Option<&str>) -> (Option<String>, Option<String>) {
        let folder = std::env::temp_dir().join(format!("gcode-playground-{:016x}", host::random()));
        fs::create_dir(&folder).expect("a folder");
        let file = folder.join("part.nc");
        fs::write(&file, "G00 X1\n").expect("a file");
        read(&file, 100).expect("a file");
        match changed {
            Some(changed) => fs::write(&file, changed).expect("a file"),
            None => fs::remove_file(&file).expect("a file"),
        }
        let error = write(&folder.join(".").join("part.nc"), b"G00 X2\n").err();
        let now = fs::read_to_string(&file).ok();
        assert_eq!(fs::read_dir(&folder).expect("a folder").count(), usize::from(now.is_some()));
        fs::remove_dir_all(&folder).expect("a folder");
        (now, error)
    }

    #[test]
    fn a_file_that_changed_after_it_was_read_is_not_overwritten() {
        let text = |text: &str| Some(text.to_owned());
        assert_eq!(written(Some("G00 X1\n")), (text("G00 X2\n"), None));
        // Another process wrote the same content.
        assert_eq!(written(Some("G00 X2\n")), (text("G00 X2\n"), None));
        for changed in [None, Some(""), Some("G00 X3\n"), Some("G00 X1\nM30\n")] {
            let (now, error) = written(changed);
            assert_eq!(now.as_deref(), changed);
            assert!(error.is_some_and(|error| error.contains("part.nc: changed on disk after it was read")));
        }
    }

    #[test]
    fn a_file_that_was_written_can_be_written_again() {
        let file = std::env::temp_dir().join(format!("gcode-playground-{:016x}.nc", host::random()));
        fs::write(&file, "1").expect("a file");
        read(&file, 100).expect("a file");
        assert_eq!(write(&file, b"2"), Ok(()));
        assert_eq!(write(&file, b"3"), Ok(()));
        assert_eq!(fs::read_to_string(&file).expect("a file"), "3");
        fs::remove_file(&file).expect("a file");
    }
}
