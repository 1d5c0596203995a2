//! The files of the programs in an editor: their settings, and the subprograms beside them.
//!
//! In: the address of a document. Out: settings as `check` uses them. A document without a file, such as a
//! new one, has the settings of the working directory.

use std::path::{Path, PathBuf};

use super::super::check::Selection;
use super::super::configuration::Configurations;
use super::super::options::ProgramOptions;
use super::super::subprograms;
use crate::run::subprograms::Joined;
use crate::server::host::{Host, Settings};

/// Configurations and setups of the options and of the files.
pub(super) struct Files<'a> {
    with: &'a ProgramOptions,
    configurations: Configurations<'a>,
}

impl<'a> Files<'a> {
    /// Reads the files of the options.
    pub(super) fn new(with: &'a ProgramOptions) -> Result<Self, String> {
        Ok(Self { with, configurations: Configurations::new(with)? })
    }
}

impl Host for Files<'_> {
    fn settings(&self, address: &str) -> Result<Settings, String> {
        let file = file(address).unwrap_or_else(|| PathBuf::from("program"));
        let settings = self.configurations.settings(&file)?;
        let keys = settings.configuration.as_ref().map(|configuration| &configuration.keys);
        let language = keys.and_then(|keys| keys.language.as_ref()).map(|said| said.value);
        let setup = Selection::default().setup(&settings);
        let rules_url = keys.and_then(|keys| keys.rules_url.as_ref()).map(|said| said.value.clone());
        Ok(Settings { setup, select: settings.select.clone(), language, rules_url })
    }

    fn with_subprograms(&self, address: &str, text: &[u8], most: usize) -> Option<Joined> {
        let file = file(address).unwrap_or_else(|| PathBuf::from("-"));
        let folders = self.configurations.libraries(&file).ok()?;
        subprograms::join(text, &folders, most)
    }

    fn forget(&mut self) {
        // A file of the options that cannot be read any more leaves all settings as they are.
        if let Ok(configurations) = Configurations::new(self.with) {
            self.configurations = configurations;
        }
    }
}

/// The file at an address; `None` if it is no file.
fn file(address: &str) -> Option<PathBuf> {
    let rest = address.strip_prefix("file:")?;
    let path = decoded(rest.strip_prefix("//").unwrap_or(rest));
    Some(match path.strip_prefix('/') {
        Some(path) if begins_with_drive(path) => PathBuf::from(path),
        Some(_) => PathBuf::from(path),
        // A folder that another computer shares: `file://server/folder/part.nc`.
        None => Path::new("//").join(path),
    })
}

/// Whether a path begins with the letter of a drive: `C:/`.
fn begins_with_drive(path: &str) -> bool {
    matches!(path.as_bytes(), [letter, b':', b'/' | b'\\', ..] if letter.is_ascii_alphabetic())
}

/// A part of an address with the characters that `%` encodes.
fn decoded(part: &str) -> String {
    let mut bytes = Vec::with_capacity(part.len());
    let mut rest = part.as_bytes();
    while let Some((first, behind)) = rest.split_first() {
        let byte = encoded(*first, behind);
        bytes.push(byte.unwrap_or(*first));
        rest = if byte.is_some() { &behind[2..] } else { behind };
    }
    String::from_utf8_lossy(&bytes).into_owned()
}

/// The byte that `%` and two digits encode.
fn encoded(first: u8, behind: &[u8]) -> Option<u8> {
    let digits = std::str::from_utf8(behind.get(..2)?).ok().filter(|_| first == b'%')?;
    digits.bytes().all(|digit| digit.is_ascii_hexdigit()).then(|| u8::from_str_radix(digits, 16).ok())?
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_address_names_a_file() {
        let path = |address: &str| file(address).map(|path| path.to_string_lossy().into_owned());
        assert_eq!(path("file:///home/a/b.nc").as_deref(), Some("/home/a/b.nc"));
        assert_eq!(path("file:///home/a%20b/%D0%B6.nc").as_deref(), Some("/home/a b/ж.nc"));
        assert_eq!(path("file:///100%25.nc").as_deref(), Some("/100%.nc"));
        assert_eq!(path("file:///c%3A/a.nc").as_deref(), Some("c:/a.nc"));
        assert_eq!(path("file:///C:/a.nc").as_deref(), Some("C:/a.nc"));
        assert_eq!(path("file:/home/a.nc").as_deref(), Some("/home/a.nc"));
        assert_eq!(path("file:///a%2").as_deref(), Some("/a%2"));
        assert_eq!(path("file:///a%+1").as_deref(), Some("/a%+1"));
        assert_eq!(path("untitled:Untitled-1"), None);
    }
}
