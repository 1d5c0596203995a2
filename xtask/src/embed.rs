//! In: the page's sources, the rule pages and what others have written that is inside. Out: the element for other
//! people's pages, `www/dist/embed`, and the same files in a folder with the version in its name.

use std::fs;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use crate::run::{self, Result};
use crate::setup::Setup;

/// Files of the project that go with the element.
const OURS: [&str; 3] = ["LICENSE-APACHE", "LICENSE-MIT", "CHANGELOG.md"];

/// Builds the element; the rule pages are there already.
pub fn element(setup: &Setup) -> Result<Duration> {
    let built = run::step("building the element for other pages", &mut setup.npm(&["run", "build:element"]))?;
    let begun = Instant::now();
    let dist = run::www().join("dist");
    let folder = dist.join("embed");
    copy_folder(&dist.join("rules"), &folder.join("rules"))?;
    for file in OURS {
        copy(&run::root().join(file), &folder.join(file))?;
    }
    let copied = dist.join("embed-of-this-version");
    let _ = fs::remove_dir_all(&copied);
    copy_folder(&folder, &copied)?;
    let versioned = folder.join(env!("CARGO_PKG_VERSION"));
    fs::rename(&copied, &versioned).map_err(|error| cannot("move", &copied, &error))?;
    Ok(built + begun.elapsed())
}

fn copy_folder(from: &Path, to: &Path) -> Result {
    fs::create_dir_all(to).map_err(|error| cannot("make", to, &error))?;
    for entry in fs::read_dir(from).map_err(|error| cannot("read", from, &error))? {
        let path = entry.map_err(|error| cannot("read", from, &error))?.path();
        let copied: PathBuf = to.join(path.file_name().unwrap_or_default());
        if path.is_dir() { copy_folder(&path, &copied)? } else { copy(&path, &copied)? }
    }
    Ok(())
}

fn copy(from: &Path, to: &Path) -> Result {
    fs::copy(from, to).map(drop).map_err(|error| cannot("copy", from, &error))
}

fn cannot(act: &str, path: &Path, error: &std::io::Error) -> String {
    format!("cannot {act} {}: {error}", path.display())
}
