//! Implements the system interface with the functions of `node.js`, which use Node's modules.

use std::ffi::OsString;
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};

use wasm_bindgen::prelude::{JsValue, wasm_bindgen};

use super::{Entry, Found, PathKind, Stream};

#[wasm_bindgen(module = "/src/cli/system/node.js")]
extern "C" {
    fn argumentsTyped() -> Vec<String>;
    fn environmentVariable(name: &str) -> Option<String>;
    #[wasm_bindgen(catch)]
    fn readFile(path: &str, most: f64) -> Result<Vec<u8>, JsValue>;
    #[wasm_bindgen(catch)]
    fn readHead(path: &str, most: f64) -> Result<Vec<u8>, JsValue>;
    #[wasm_bindgen(catch)]
    fn readStandardInput(most: f64) -> Result<Vec<u8>, JsValue>;
    #[wasm_bindgen(catch)]
    fn createFile(path: &str, mode: u32) -> Result<i32, JsValue>;
    #[wasm_bindgen(catch)]
    fn openToWrite(path: &str) -> Result<i32, JsValue>;
    #[wasm_bindgen(catch)]
    fn writeWhole(descriptor: i32, bytes: &[u8]) -> Result<(), JsValue>;
    #[wasm_bindgen(catch)]
    fn writeDirectly(path: &str, bytes: &[u8]) -> Result<(), JsValue>;
    #[wasm_bindgen(catch)]
    fn closeSync(descriptor: i32) -> Result<(), JsValue>;
    #[wasm_bindgen(catch)]
    fn renameSync(from: &str, to: &str) -> Result<(), JsValue>;
    #[wasm_bindgen(catch)]
    fn unlinkSync(path: &str) -> Result<(), JsValue>;
    #[wasm_bindgen(catch)]
    fn flushFolder(folder: &str) -> Result<(), JsValue>;
    #[wasm_bindgen(catch)]
    fn fchownSync(descriptor: i32, user: u32, group: u32) -> Result<(), JsValue>;
    #[wasm_bindgen(catch)]
    fn fchmodSync(descriptor: i32, mode: u32) -> Result<(), JsValue>;
    #[wasm_bindgen(catch)]
    fn readlinkSync(path: &str) -> Result<String, JsValue>;
    #[wasm_bindgen(catch)]
    fn canonicalPath(path: &str) -> Result<String, JsValue>;
    #[wasm_bindgen(catch)]
    fn factsOf(path: &str) -> Result<Vec<u64>, JsValue>;
    #[wasm_bindgen(catch)]
    fn kindOf(path: &str) -> Result<String, JsValue>;
    #[wasm_bindgen(catch)]
    fn entriesOf(folder: &str) -> Result<Vec<String>, JsValue>;
    fn absolutePath(path: &str) -> String;
    #[wasm_bindgen(catch)]
    fn writeTo(descriptor: u32, bytes: &[u8]) -> Result<(), JsValue>;
    fn isTerminal(descriptor: u32) -> bool;
    fn endWith(status: u8);
}

/// Sets the exit status of the process.
pub(in crate::cli) fn end(status: u8) {
    endWith(status);
}

/// The command-line arguments; the first is the name of the program.
pub(in crate::cli) fn arguments() -> Vec<OsString> {
    argumentsTyped().into_iter().map(OsString::from).collect()
}

/// An environment variable; `None` if it is unset or empty.
pub(in crate::cli) fn variable(name: &str) -> Option<String> {
    environmentVariable(name).filter(|value| !value.is_empty())
}

/// Number of files that can be processed in parallel: a WebAssembly module has one thread.
pub(in crate::cli) fn processors() -> usize {
    1
}

/// Reads a file of at most `most` bytes. A larger file is not read; the error is `FileTooLarge`.
pub(super) fn read(file: &Path, most: u64) -> io::Result<Vec<u8>> {
    readFile(&text(file), most as f64).map_err(error)
}

/// Reads the first bytes of a file, at most `most`.
pub(super) fn read_head(file: &Path, most: u64) -> io::Result<Vec<u8>> {
    readHead(&text(file), most as f64).map_err(error)
}

/// Reads standard input; stops one byte past the limit.
pub(in crate::cli) fn read_standard_input(most: u64) -> io::Result<Vec<u8>> {
    readStandardInput(most as f64).map_err(error)
}

/// A file open for writing, by its descriptor.
pub(super) struct OpenFile(i32);

impl Drop for OpenFile {
    fn drop(&mut self) {
        let _ = closeSync(self.0);
    }
}

/// Creates a file that does not exist yet; `mode` is subject to the umask.
pub(super) fn create(path: &Path, mode: u32) -> io::Result<OpenFile> {
    createFile(&text(path), mode).map(OpenFile).map_err(error)
}

/// Opens an existing file for writing.
pub(super) fn open_to_write(path: &Path) -> io::Result<OpenFile> {
    openToWrite(&text(path)).map(OpenFile).map_err(error)
}

/// Replaces the whole content of a file, and flushes it to the disk.
pub(super) fn write_whole(file: &mut OpenFile, bytes: &[u8]) -> io::Result<()> {
    writeWhole(file.0, bytes).map_err(error)
}

/// Writes to a device, a pipe, or the path of a file descriptor.
pub(super) fn write_directly(path: &Path, bytes: &[u8]) -> io::Result<()> {
    writeDirectly(&text(path), bytes).map_err(error)
}

/// Renames a file, replacing an existing one.
pub(super) fn rename(from: &Path, to: &Path) -> io::Result<()> {
    renameSync(&text(from), &text(to)).map_err(error)
}

pub(super) fn remove(path: &Path) -> io::Result<()> {
    unlinkSync(&text(path)).map_err(error)
}

/// Flushes a folder to the disk, if the system supports it.
pub(super) fn flush_folder(folder: &Path) {
    let _ = flushFolder(&text(folder));
}

/// Sets user and group of a file.
pub(super) fn set_owner(file: &OpenFile, (user, group): (u32, u32)) -> io::Result<()> {
    fchownSync(file.0, user, group).map_err(error)
}

pub(super) fn set_mode(file: &OpenFile, mode: u32) -> io::Result<()> {
    fchmodSync(file.0, mode).map_err(error)
}

/// A number that is unlikely to be the same in another process.
pub(super) fn random() -> u64 {
    (js_sys::Math::random() * 2f64.powi(53)) as u64
}

/// The target of a symbolic link; `None` for any other path.
pub(super) fn link(path: &Path) -> Option<PathBuf> {
    readlinkSync(&text(path)).ok().map(PathBuf::from)
}

/// The canonical path, without symbolic links.
pub(super) fn canonical(path: &Path) -> io::Result<PathBuf> {
    canonicalPath(&text(path)).map(PathBuf::from).map_err(error)
}

/// Metadata of a path.
pub(super) fn found(path: &Path) -> io::Result<Found> {
    let facts = factsOf(&text(path)).map_err(error)?;
    let [mode, user, group, links, device, number] = facts[..] else {
        return Err(ErrorKind::InvalidData.into());
    };
    let kind = match mode & 0o170_000 {
        0o100_000 => PathKind::File,
        0o040_000 => PathKind::Folder,
        _ => PathKind::Other,
    };
    let mode = mode as u32 & 0o7777;
    Ok(Found { kind, mode, owner: (user as u32, group as u32), links, id: Some((device, number)) })
}

/// Type of a path; links are followed.
pub(in crate::cli) fn kind(path: &Path) -> io::Result<PathKind> {
    kindOf(&text(path)).map(|kind| kind_named(&kind)).map_err(error)
}

/// The entries of a folder, sorted by name.
pub(in crate::cli) fn entries(folder: &Path) -> io::Result<Vec<Entry>> {
    let listed = entriesOf(&text(folder)).map_err(error)?;
    let (pairs, _) = listed.as_chunks::<2>();
    let mut entries: Vec<Entry> =
        pairs.iter().map(|[name, kind]| Entry { name: name.into(), kind: kind_named(kind) }).collect();
    entries.sort_by(|a, b| a.name.cmp(&b.name));
    Ok(entries)
}

/// The absolute path, without `.` and `..`.
pub(in crate::cli) fn absolute(path: &Path) -> io::Result<PathBuf> {
    Ok(absolutePath(&text(path)).into())
}

/// Opens a stream for writing.
pub(in crate::cli) fn stream(stream: Stream) -> Box<dyn Write> {
    Box::new(Descriptor(descriptor(stream)))
}

/// Whether a stream is connected to a terminal.
pub(in crate::cli) fn is_terminal(stream: Stream) -> bool {
    isTerminal(descriptor(stream))
}

/// A stream, by its file descriptor.
struct Descriptor(u32);

impl Write for Descriptor {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        writeTo(self.0, bytes).map_err(error)?;
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

fn descriptor(stream: Stream) -> u32 {
    match stream {
        Stream::Output => 1,
        Stream::Error => 2,
    }
}

/// Paths come from JavaScript strings, so they are valid text.
fn text(path: &Path) -> String {
    path.to_string_lossy().into_owned()
}

fn kind_named(name: &str) -> PathKind {
    match name {
        "file" => PathKind::File,
        "folder" => PathKind::Folder,
        _ => PathKind::Other,
    }
}

/// Converts a Node error to an error of the standard library.
fn error(thrown: JsValue) -> io::Error {
    let property = |name: &str| js_sys::Reflect::get(&thrown, &name.into()).ok()?.as_string();
    let kind = match property("code").as_deref() {
        Some("ENOENT") => ErrorKind::NotFound,
        Some("EACCES" | "EPERM") => ErrorKind::PermissionDenied,
        Some("EISDIR") => ErrorKind::IsADirectory,
        Some("ENOTDIR") => ErrorKind::NotADirectory,
        Some("ENOSPC") => ErrorKind::StorageFull,
        Some("EROFS") => ErrorKind::ReadOnlyFilesystem,
        Some("EFBIG") => ErrorKind::FileTooLarge,
        Some("EDQUOT") => ErrorKind::QuotaExceeded,
        Some("ENAMETOOLONG") => ErrorKind::InvalidFilename,
        Some("EEXIST") => ErrorKind::AlreadyExists,
        Some("EBUSY") => ErrorKind::ResourceBusy,
        Some("EPIPE") => ErrorKind::BrokenPipe,
        _ => return io::Error::other(property("message").unwrap_or_default()),
    };
    kind.into()
}
