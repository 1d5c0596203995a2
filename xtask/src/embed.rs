//! In: the page's sources, the rule pages, the interpreter's package and what others have written that is inside. Out: the
//! element for other people's pages and for Node, `www/dist/embed`: the npm package; and the same files in a folder with the
//! version in its name.

use std::collections::BTreeSet;
use std::env;
use std::fs;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use crate::run::{self, Result};
use crate::setup::Setup;

/// Files of the project that go with the element.
const OURS: [&str; 3] = ["LICENSE-APACHE", "LICENSE-MIT", "CHANGELOG.md"];

/// The interpreter's scripts, for Node.
const INTERPRETER: [&str; 5] =
    ["gcode_playground.js", "gcode_playground.d.ts", "parts.js", "parts.d.ts", "part-files.js"];

const VERSION: &str = env!("CARGO_PKG_VERSION");

/// What the licence texts are gathered in; the page's own build begins it.
const LICENCES: &str = "THIRD-PARTY-LICENSES.txt";

/// Builds the element; the rule pages are there already.
pub fn element(setup: &Setup) -> Result<Duration> {
    let built = run::step("building the element for other pages", &mut setup.npm(&["run", "build:element"]))?;
    let begun = Instant::now();
    let dist = run::www().join("dist");
    let folder = dist.join("embed");
    copy_folder(&dist.join("rules"), &folder.join("rules"))?;
    copy_folder(&run::www().join("embed"), &folder)?;
    copy_folder(&run::www().join("manuals"), &folder.join("sphinx"))?;
    change(&folder.join("package.json"), "0.0.0", VERSION)?;
    for file in OURS {
        copy(&run::root().join(file), &folder.join(file))?;
    }
    for file in INTERPRETER {
        copy(&run::www().join("pkg").join(file), &folder.join("node").join(file))?;
    }
    change(&folder.join("node/part-files.js"), "'./", "'../")?;
    // Only the newest library of types knows it.
    change(&folder.join("node/gcode_playground.d.ts"), "    [Symbol.dispose](): void;\n", "")?;
    add_licences(setup, &folder.join(LICENCES))?;
    let copied = dist.join("embed-of-this-version");
    let _ = fs::remove_dir_all(&copied);
    copy_folder(&folder, &copied)?;
    let versioned = folder.join(VERSION);
    fs::rename(&copied, &versioned).map_err(|error| cannot("move", &copied, &error))?;
    Ok(built + begun.elapsed())
}

/// Adds the licences of the crates that are in the module.
fn add_licences(setup: &Setup, file: &Path) -> Result {
    let mut tree = setup.command("cargo");
    // The module of the command line needs more than that of the page.
    tree.args(["tree", "--package", "gcode-playground", "--features", "npx", "--edges", "normal"]);
    tree.args([
        "--target",
        "wasm32-unknown-unknown",
        "--prefix",
        "none",
        "--format",
        "{p}|{l}|{r}",
        "--no-dedupe",
    ]);
    let listed = run::ask(&mut tree).ok_or("cargo tree does not list what is in the module")?;
    let rows: BTreeSet<&str> = listed.lines().filter(|row| !row.contains(" (")).collect();
    let mut text = fs::read_to_string(file).map_err(|error| cannot("read", file, &error))?;
    for row in rows {
        let [package, licence, repository] = row.splitn(3, '|').collect::<Vec<_>>()[..] else {
            return Err(format!("`{row}` is no row of cargo tree"));
        };
        let folder = crate_folder(&package.replacen(" v", "-", 1))?;
        text += &format!("\n{package} · {licence} · {repository}\n{}\n", "=".repeat(72));
        for licence in licence_files(&folder)? {
            text += &fs::read_to_string(&licence).map_err(|error| cannot("read", &licence, &error))?;
        }
    }
    fs::write(file, text).map_err(|error| cannot("write", file, &error))
}

/// Where cargo has unpacked a crate, by its name and version.
fn crate_folder(name: &str) -> Result<PathBuf> {
    let home = env::var_os("CARGO_HOME").map(PathBuf::from);
    let home = home.or_else(|| env::home_dir().map(|home| home.join(".cargo"))).unwrap_or_default();
    let sources = home.join("registry/src");
    let indexes = fs::read_dir(&sources).map_err(|error| cannot("read", &sources, &error))?;
    let mut folders = indexes.flatten().map(|index| index.path().join(name));
    folders.find(|folder| folder.is_dir()).ok_or_else(|| format!("{} has no {name}", sources.display()))
}

/// The files of a crate that hold its licence; some crates have none.
fn licence_files(folder: &Path) -> Result<Vec<PathBuf>> {
    let files = fs::read_dir(folder).map_err(|error| cannot("read", folder, &error))?;
    let is_one = |path: &PathBuf| {
        let name = path.file_name().unwrap_or_default().to_string_lossy().to_uppercase();
        path.is_file()
            && ["LICENSE", "LICENCE", "COPYING", "COPYRIGHT"].iter().any(|start| name.starts_with(start))
    };
    let mut files: Vec<PathBuf> = files.flatten().map(|entry| entry.path()).filter(is_one).collect();
    files.sort();
    Ok(files)
}

/// Puts another text in the place of one that stands in a file.
fn change(file: &Path, from: &str, to: &str) -> Result {
    let text = fs::read_to_string(file).map_err(|error| cannot("read", file, &error))?;
    if !text.contains(from) {
        return Err(format!("{} does not say `{from}`", file.display()));
    }
    fs::write(file, text.replace(from, to)).map_err(|error| cannot("write", file, &error))
}

pub fn copy_folder(from: &Path, to: &Path) -> Result {
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
