//! Finds the files to check: named files, and programs in named folders.
//!
//! In: paths from the command line. Out: files in order, each once, and problems with paths. A named file is
//! always included, whatever its ending. In a folder the ending decides; `.gitignore` and `.ignore` are
//! respected (patterns by the crate `ignore`), hidden files are skipped, and links are not followed.

use std::collections::HashSet;
use std::ffi::OsStr;
use std::path::{Path, PathBuf};

use ignore::gitignore::{Gitignore, GitignoreBuilder};

use super::super::configuration::{self, Configurations};
use super::super::encoding;
use super::super::subprograms;
use super::super::system::{self, PathKind};
use super::super::terminal::printable_name;
use crate::text::block::Block;
use crate::text::parser::Parser;

/// Endings of program files. Files such as `O0001`, written by FANUC controls without an ending, count as
/// well.
pub(in crate::cli) const PROGRAMS: &[&str] = subprograms::ENDINGS;

/// Endings that are also used for other files (`""`: no ending): the text decides whether it is a program.
const SHARED: &[&str] = &["txt", "g", "h", ""];
/// Maximum number of blocks read of such a file.
const MAX_SCANNED_BLOCKS: usize = 100;
/// Maximum number of bytes read of such a file.
const HEAD: u64 = 64 << 10;

/// Endings of pages of a manual.
pub(in crate::cli) const PAGES: &[&str] = &["md", "markdown", "mdx", "html", "htm", "rst"];

/// Options that select files in folders.
#[derive(clap::Args)]
pub(in crate::cli) struct Which {
    /// Leave out what this pattern matches, as a line of a `.gitignore` (`--exclude 'old/**'`); may be given more than once.
    #[arg(long, value_name = "PATTERN")]
    exclude: Vec<String>,
    /// Leave out what `--exclude` and the configuration exclude even if it is named, as hooks name files.
    #[arg(long)]
    force_exclude: bool,
    /// The endings of programs in folders, instead of the usual ones.
    #[arg(long, value_name = "ENDING", value_delimiter = ',')]
    extension: Vec<String>,
}

/// Result of the search.
#[derive(Debug, Default)]
pub(in crate::cli) struct Found {
    /// The files to check, in order.
    pub files: Vec<PathBuf>,
    /// Errors about paths, as sentences.
    pub problems: Vec<String>,
    /// Number of files in folders skipped because of their ending.
    pub left_out: usize,
}

/// Finds the files; `usual` are the default endings. Returns an error for an invalid pattern.
pub(in crate::cli) fn find(
    given: &[PathBuf],
    which: &Which,
    usual: &[&str],
    configurations: &Configurations<'_>,
) -> Result<Found, String> {
    let mut found = Found::default();
    let mut seen = HashSet::new();
    for path in given {
        if !system::kind(path).is_ok_and(|kind| kind == PathKind::Folder) {
            let is_left_out = which.force_exclude && is_excluded(path, which, configurations)?;
            if !is_left_out && seen.insert(path.clone()) {
                found.files.push(path.clone());
            }
            continue;
        }
        let absolute = system::absolute(path)
            .map_err(|error| format!("{}: {}", path.display(), system::reason(&error)))?;
        let configuration = configurations.of(&path.join("program"))?;
        let mut excluded = vec![which.excluded(&absolute)?];
        let mut endings = which.extension.clone();
        if let Some(configuration) = &configuration {
            excluded.push(configuration.exclude.clone());
            if endings.is_empty() {
                endings = configuration.keys.extension.iter().map(|said| said.value.clone()).collect();
            }
        }
        let before = found.files.len();
        let mut walk = Walk { endings, usual, excluded, ignored: parents(&absolute), found, seen };
        // `.` and `./` name the folder; they are not part of the names of files in it.
        walk.folder(path.strip_prefix(".").unwrap_or(path), &absolute);
        let Walk { endings, found: looked, seen: met, .. } = walk;
        (found, seen) = (looked, met);
        if found.files.len() == before {
            let endings = if endings.is_empty() { usual.join(", ") } else { endings.join(", ") };
            let others = "`--extension` names others";
            found.problems.push(format!("{}: no file with the ending {endings}; {others}", path.display()));
        }
    }
    Ok(found)
}

impl Which {
    /// The `--exclude` patterns, relative to a folder.
    fn excluded(&self, folder: &Path) -> Result<Gitignore, String> {
        let patterns = self.exclude.iter().map(String::as_str);
        configuration::patterns(folder, patterns).map_err(|problem| format!("--exclude {problem}"))
    }
}

/// Whether a named file is excluded.
fn is_excluded(file: &Path, which: &Which, configurations: &Configurations<'_>) -> Result<bool, String> {
    let here = system::absolute(Path::new(".")).unwrap_or_default();
    let file = system::absolute(file).unwrap_or_else(|_| file.to_owned());
    let says = |patterns: &Gitignore, folder: &Path| {
        file.starts_with(folder) && patterns.matched_path_or_any_parents(&file, false).is_ignore()
    };
    let by_configuration = configurations.of(&file)?.is_some_and(|own| says(&own.exclude, &own.folder));
    Ok(by_configuration || says(&which.excluded(&here)?, &here))
}

/// A recursive walk through a folder.
struct Walk<'a> {
    /// Requested endings.
    endings: Vec<String>,
    /// Default endings, used if none are requested.
    usual: &'a [&'a str],
    /// Patterns of excluded files.
    excluded: Vec<Gitignore>,
    /// Patterns of `.gitignore` and `.ignore`, innermost folder last.
    ignored: Vec<Gitignore>,
    found: Found,
    seen: HashSet<PathBuf>,
}

impl Walk<'_> {
    /// Visits a folder, given its displayed name and its absolute path.
    fn folder(&mut self, shown: &Path, absolute: &Path) {
        let entries = match system::entries(absolute) {
            Ok(entries) => entries,
            Err(error) => {
                let problem = format!("{}: {}", printable_name(shown), system::reason(&error));
                self.found.problems.push(problem);
                return;
            }
        };
        self.ignored.extend(ignore_files(absolute));
        let depth = self.ignored.len();
        for entry in entries {
            let file = absolute.join(&entry.name);
            let is_folder = entry.kind == PathKind::Folder;
            if entry.name.as_encoded_bytes().starts_with(b".") || self.is_left_out(&file, is_folder) {
                continue;
            }
            let shown = shown.join(&entry.name);
            match entry.kind {
                PathKind::Folder => {
                    self.folder(&shown, &file);
                    self.ignored.truncate(depth);
                }
                PathKind::File if is_intended(&shown, &file, &self.endings, self.usual) => {
                    if self.seen.insert(shown.clone()) {
                        self.found.files.push(shown);
                    }
                }
                PathKind::File => self.found.left_out += 1,
                PathKind::Other => {}
            }
        }
    }

    fn is_left_out(&self, file: &Path, is_folder: bool) -> bool {
        if self.excluded.iter().any(|patterns| patterns.matched(file, is_folder).is_ignore()) {
            return true;
        }
        // The innermost folder takes precedence.
        let mut said = self.ignored.iter().rev().map(|patterns| patterns.matched(file, is_folder));
        said.find(|said| !said.is_none()).is_some_and(|said| said.is_ignore())
    }
}

/// Patterns from the `.gitignore` and `.ignore` of a folder; `None` if it has neither.
fn ignore_files(folder: &Path) -> Option<Gitignore> {
    let files = [".gitignore", ".ignore"];
    let texts: Vec<String> =
        files.iter().filter_map(|name| system::read_text(&folder.join(name)).ok()).collect();
    if texts.is_empty() {
        return None;
    }
    let mut builder = GitignoreBuilder::new(folder);
    for line in texts.iter().flat_map(|text| text.lines()) {
        // Invalid patterns are ignored, as in git.
        let _ = builder.add_line(None, line);
    }
    builder.build().ok()
}

/// Ignore patterns of the parent folders up to the root of the repository, innermost last.
fn parents(folder: &Path) -> Vec<Gitignore> {
    let is_root = |folder: &Path| system::kind(&folder.join(".git")).is_ok();
    let mut said = Vec::new();
    let mut folder = folder;
    while !is_root(folder)
        && let Some(parent) = folder.parent()
    {
        said.extend(ignore_files(parent));
        folder = parent;
    }
    said.reverse();
    said
}

/// Whether a file of a folder is to be checked, given its displayed name and its absolute path.
fn is_intended(shown: &Path, absolute: &Path, endings: &[String], usual: &[&str]) -> bool {
    let ending = shown.extension().and_then(OsStr::to_str).unwrap_or_default();
    let is_one = |wanted: &str| ending.eq_ignore_ascii_case(wanted.trim_start_matches('.'));
    if ending.is_empty() && usual == PROGRAMS {
        let name = shown.file_name().and_then(OsStr::to_str).unwrap_or_default();
        if is_program_number(name) {
            return true;
        }
    }
    if !endings.is_empty() {
        return endings.iter().any(|wanted| is_one(wanted));
    }
    let is_shared = || usual == PROGRAMS && SHARED.iter().any(|wanted| is_one(wanted));
    usual.iter().any(|wanted| is_one(wanted)) || is_shared() && is_program(absolute)
}

/// Whether the beginning of a file consists almost entirely of blocks.
fn is_program(file: &Path) -> bool {
    let Ok(mut bytes) = system::peek(file, HEAD) else { return false };
    if bytes.len() as u64 == HEAD {
        // The last line, and its last character, may be cut off.
        let end = bytes.iter().rposition(|&byte| byte == b'\n').unwrap_or(bytes.len());
        bytes.truncate(end);
    }
    let (text, _) = encoding::decode(bytes);
    let (mut parser, mut block) = (Parser::new(&text), Block::default());
    let (mut blocks, mut faulty, mut has_code) = (0, 0, false);
    while blocks < MAX_SCANNED_BLOCKS && parser.next_block(&mut block) {
        let is_empty = block.words.is_empty() && block.faults.is_empty();
        blocks += usize::from(!is_empty);
        faulty += usize::from(!block.faults.is_empty());
        has_code |= block.words.iter().any(|word| matches!(word.address, b'G' | b'M'));
    }
    has_code && 4 * faulty <= blocks
}

/// Whether `name` is a program number such as `O0001`.
fn is_program_number(name: &str) -> bool {
    let digits = name.strip_prefix(['O', 'o']).unwrap_or_default();
    !digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_digit())
}

#[cfg(test)]
mod tests {
    use super::is_program_number;

    #[test]
    fn files_of_a_control_are_named_by_their_program() {
        for name in ["O0001", "o12"] {
            assert!(is_program_number(name), "{name}");
        }
        for name in ["O", "README", "Oslo", "0001", "O12a"] {
            assert!(!is_program_number(name), "{name}");
        }
    }
}
