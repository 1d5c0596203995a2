//! In: the built element, which has the library, and the sources in `editors/vscode`. Out: the extension for
//! Visual Studio Code, `target/vscode/gcode-playground.vsix`.
//!
//! The files are collected in a separate folder, so that the archive contains nothing else.

use std::fs;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use crate::embed::{VERSION, change};
use crate::notices;
use crate::run::{self, Result, cannot, copy, step};
use crate::setup::{Setup, npm_ci};
use crate::{native, package};

/// Files of the extension that are packed as they are.
const OWN: [&str; 7] = [
    "README.md",
    "language-configuration.json",
    "package.json",
    "package.nls.json",
    "package.nls.ru.json",
    "package.nls.zh-cn.json",
    "syntaxes/gcode.tmLanguage.json",
];

/// Files of the project that are packed with it.
const OURS: [&str; 3] = ["LICENSE-APACHE", "LICENSE-MIT", "CHANGELOG.md"];

/// Scripts of the element's package that the element does not load: the page for frames, the search of the
/// manual, the package for learning platforms.
const OTHER_PAGES: [&str; 3] = ["frame.js", "search.js", "sco.js"];

/// `cargo xtask vscode`.
pub fn main() -> Result {
    let setup = Setup::for_building()?;
    package::wasm(&setup)?;
    package::page(&setup, native::Beside::Nothing)?;
    pack(&setup)?;
    run::say(format_args!("the extension is {}", archive().display()));
    Ok(())
}

/// Packs the extension, with the built element.
pub fn pack(setup: &Setup) -> Result<Duration> {
    let begun = Instant::now();
    let sources = run::root().join("editors/vscode");
    // Install scripts only get what packing does not need.
    let bin = npm_ci(&sources, "the npm packages of the extension", &["--ignore-scripts"])?;
    let mut types = setup.command("tsc");
    step("checking the extension's types", types.arg("--noEmit").arg("--project").arg(&sources))?;
    let element = run::www().join("dist/embed");
    let folder = run::target().join("vscode/extension");
    package::begin(&folder)?;
    for name in ["dist", "element", "syntaxes"] {
        let inside = folder.join(name);
        fs::create_dir(&inside).map_err(|error| cannot("make", &inside, &error))?;
    }
    for file in OWN {
        copy(&sources.join(file), &folder.join(file))?;
    }
    for file in OURS {
        copy(&run::root().join(file), &folder.join(file))?;
    }
    change(&folder.join("package.json"), "\"version\": \"0.0.0\"", &format!("\"version\": \"{VERSION}\""))?;
    for file in files_of_element(&element)? {
        copy(&file, &folder.join("element").join(file.file_name().unwrap_or_default()))?;
    }
    let mut bundle = setup.command("node");
    bundle.arg(sources.join("build.mjs")).arg(&element).arg(folder.join("dist"));
    step("bundling the extension", &mut bundle)?;
    let mut vsce = setup.command("node");
    vsce.arg(bin.with_file_name("@vscode/vsce/vsce")).current_dir(&folder);
    // The licence files are not named LICENSE, and no document has a relative link.
    vsce.args(["package", "--no-dependencies", "--skip-license", "--allow-missing-repository", "--out"]);
    step("packing the extension", vsce.arg(archive()))?;
    Ok(begun.elapsed())
}

/// The archive.
fn archive() -> PathBuf {
    run::target().join("vscode/gcode-playground.vsix")
}

/// The files that the element and the library load, and their licences.
fn files_of_element(element: &Path) -> Result<Vec<PathBuf>> {
    let entries = fs::read_dir(element).map_err(|error| cannot("read", element, &error))?;
    let is_needed = |path: &PathBuf| {
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        let is_file = [".js", ".wasm", ".txt"].iter().any(|ending| name.ends_with(ending));
        is_file && !OTHER_PAGES.contains(&&*name)
    };
    let files: Vec<PathBuf> = entries.flatten().map(|entry| entry.path()).filter(is_needed).collect();
    let has = |name: &str| files.iter().any(|file| file.ends_with(name));
    for name in ["element.js", "worker.js", "core.wasm", "en.txt", notices::FILE] {
        if !has(name) {
            return Err(format!("{} has no {name}", element.display()));
        }
    }
    Ok(files)
}
