//! By functions of `node.js`, which use Node's own modules.

use std::ffi::OsString;
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};

use wasm_bindgen::prelude::{JsValue, wasm_bindgen};

use super::{Entry, PathKind, Stream};

#[wasm_bindgen(module = "/src/cli/system/node.js")]
extern "C" {
    fn argumentsTyped() -> Vec<String>;
    fn environmentVariable(name: &str) -> Option<String>;
    #[wasm_bindgen(catch)]
    fn readFile(path: &str, most: f64) -> Result<Vec<u8>, JsValue>;
    #[wasm_bindgen(catch)]
    fn readStandardInput(most: f64) -> Result<Vec<u8>, JsValue>;
    #[wasm_bindgen(catch)]
    fn writeFile(path: &str, bytes: &[u8]) -> Result<(), JsValue>;
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

/// The exit status that the process is to have.
pub(in crate::cli) fn end(status: u8) {
    endWith(status);
}

/// What was typed, with the name of the program first.
pub(in crate::cli) fn arguments() -> Vec<OsString> {
    argumentsTyped().into_iter().map(OsString::from).collect()
}

/// A variable of the environment; nothing where it is not set or empty.
pub(in crate::cli) fn variable(name: &str) -> Option<String> {
    environmentVariable(name).filter(|value| !value.is_empty())
}

/// How many files can be worked on at once: a module has one thread.
pub(in crate::cli) fn processors() -> usize {
    1
}

/// Reads a file of at most so many bytes. The error of a larger one is `FileTooLarge`; it is not read.
pub(in crate::cli) fn read(file: &Path, most: u64) -> io::Result<Vec<u8>> {
    readFile(&text(file), most as f64).map_err(error)
}

/// Reads standard input, no further than one byte beyond the limit.
pub(in crate::cli) fn read_standard_input(most: u64) -> io::Result<Vec<u8>> {
    readStandardInput(most as f64).map_err(error)
}

/// Writes a file.
pub(in crate::cli) fn write(file: &Path, bytes: &[u8]) -> io::Result<()> {
    writeFile(&text(file), bytes).map_err(error)
}

/// What a path leads to; links are followed.
pub(in crate::cli) fn kind(path: &Path) -> io::Result<PathKind> {
    kindOf(&text(path)).map(|kind| kind_named(&kind)).map_err(error)
}

/// What is in a folder, by name.
pub(in crate::cli) fn entries(folder: &Path) -> io::Result<Vec<Entry>> {
    let listed = entriesOf(&text(folder)).map_err(error)?;
    let (pairs, _) = listed.as_chunks::<2>();
    let mut entries: Vec<Entry> =
        pairs.iter().map(|[name, kind]| Entry { name: name.into(), kind: kind_named(kind) }).collect();
    entries.sort_by(|a, b| a.name.cmp(&b.name));
    Ok(entries)
}

/// A path from the root of the disk, without `.` and `..`.
pub(in crate::cli) fn absolute(path: &Path) -> io::Result<PathBuf> {
    Ok(absolutePath(&text(path)).into())
}

/// A stream to write to.
pub(in crate::cli) fn stream(stream: Stream) -> Box<dyn Write> {
    Box::new(Descriptor(descriptor(stream)))
}

/// Whether a stream goes to a terminal.
pub(in crate::cli) fn is_terminal(stream: Stream) -> bool {
    isTerminal(descriptor(stream))
}

/// A stream by its number.
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

/// Paths come from texts of JavaScript, so they are texts.
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

/// The error of Node as the standard library has it.
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
        Some("EPIPE") => ErrorKind::BrokenPipe,
        _ => return io::Error::other(property("message").unwrap_or_default()),
    };
    kind.into()
}
