//! In: the sources of the page, the rule pages, the reference, the pages of the manual, the package of the interpreter,
//! and the licences of third-party code in it. Out: the element for other pages and for Node, `www/dist/embed`, which
//! is the npm package; and the same files in a folder with the version in its name.

use std::fs;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use crate::notices;
use crate::run::{self, Result, cannot, copy};
use crate::setup::Setup;

/// Files of the project that are shipped with the element.
const OURS: [&str; 3] = ["LICENSE-APACHE", "LICENSE-MIT", "CHANGELOG.md"];

/// The interpreter's scripts, for Node.
const INTERPRETER: [&str; 5] =
    ["gcode_playground.js", "gcode_playground.d.ts", "parts.js", "parts.d.ts", "part-files.js"];

/// The version of the project.
pub const VERSION: &str = env!("CARGO_PKG_VERSION");

/// Builds the element; requires the rule pages, the reference and the pages of the manual.
pub fn element(setup: &Setup) -> Result<Duration> {
    let built = run::step("building the element for other pages", &mut setup.npm(&["run", "build:element"]))?;
    let begun = Instant::now();
    let dist = run::www().join("dist");
    let folder = dist.join("embed");
    for pages in ["rules", "docs"] {
        copy_folder(&dist.join(pages), &folder.join(pages))?;
    }
    let manual = dist.join("manual-of-element");
    fs::rename(&manual, folder.join("manual")).map_err(|error| cannot("move", &manual, &error))?;
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
    // A bundler copies the file of this address.
    change(&folder.join("node/gcode_playground.js"), "'gcode_playground_bg.wasm'", "'../core.wasm'")?;
    // Only the newest type library contains this symbol.
    change(&folder.join("node/gcode_playground.d.ts"), "    [Symbol.dispose](): void;\n", "")?;
    // The build of the page writes the beginning of the file.
    add_licences(setup, &folder.join(notices::FILE))?;
    let copied = dist.join("embed-of-this-version");
    let _ = fs::remove_dir_all(&copied);
    copy_folder(&folder, &copied)?;
    let versioned = folder.join(VERSION);
    fs::rename(&copied, &versioned).map_err(|error| cannot("move", &copied, &error))?;
    Ok(built + begun.elapsed())
}

/// Appends the licences of the crates in the module.
fn add_licences(setup: &Setup, file: &Path) -> Result {
    let mut tree = setup.command("cargo");
    // The module of the command line has more dependencies than that of the page.
    tree.args(["tree", "--package", "gcode-playground", "--features", "npx"]);
    tree.args(["--target", "wasm32-unknown-unknown"]);
    let text = fs::read_to_string(file).map_err(|error| cannot("read", file, &error))?;
    fs::write(file, text + &notices::of(&mut tree)?).map_err(|error| cannot("write", file, &error))
}

/// Replaces a text in a file; it must be there.
pub fn change(file: &Path, from: &str, to: &str) -> Result {
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
