//! In: the package list of `cargo tree`, and the sources in the cargo folder. Out: names and licence texts,
//! for the npm package and for the archives of the native program.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};

use crate::run::{self, Result, cannot, copy};

/// The file with the licences of all packages.
pub const FILE: &str = "THIRD-PARTY-LICENSES.txt";

/// The line between the name of a package and its licences.
const RULE: &str = "========================================================================";

/// `cargo xtask notices`: the licences for the archives of the native program.
pub fn main() -> Result {
    let folder = run::target().join("notices");
    fs::create_dir_all(&folder).map_err(|error| cannot("make", &folder, &error))?;
    let file = folder.join(FILE);
    fs::write(&file, of(&mut native())?).map_err(|error| cannot("write", &file, &error))?;
    let sysroot = run::ask(run::command("rustc").args(["--print", "sysroot"]));
    let sysroot = PathBuf::from(sysroot.ok_or("rustc does not say where it is")?);
    let library = sysroot.join("share/doc/rust/COPYRIGHT-library.html");
    copy(&library, &folder.join("RUST-STANDARD-LIBRARY-LICENSES.html"))?;
    run::say(format_args!("the licences are in {}", folder.display()));
    Ok(())
}

/// `cargo tree` for the native program.
fn native() -> Command {
    let mut tree = run::command("cargo");
    tree.args(["tree", "--package", "gcode-playground"]);
    tree
}

/// The licences of the packages that this `cargo tree` lists. A package without any licence is an error.
pub fn of(tree: &mut Command) -> Result<String> {
    tree.args(["--edges", "normal", "--prefix", "none", "--format", "{p}|{l}|{r}", "--no-dedupe"]);
    let listed = run::ask(tree).ok_or("cargo tree does not list the packages")?;
    // A bracket marks a folder of this repository, or a proc macro, which is not part of the binary.
    let rows: BTreeSet<&str> = listed.lines().filter(|row| !row.contains(" (")).collect();
    let mut text = String::new();
    for row in rows {
        let [package, licence, repository] = row.splitn(3, '|').collect::<Vec<_>>()[..] else {
            return Err(format!("`{row}` is no row of cargo tree"));
        };
        text += &format!("\n{package} · {licence} · {repository}\n{RULE}\n");
        let files = licence_files(&crate_folder(&package.replacen(" v", "-", 1))?)?;
        for file in &files {
            text += &read(file)?;
        }
        if files.is_empty() {
            text += &without_file(package, licence)?;
        }
    }
    Ok(text)
}

/// The licence text of a package without a licence file: the MIT licence, if it is one of its licences.
fn without_file(package: &str, licence: &str) -> Result<String> {
    let ours = read(&run::root().join("LICENSE-MIT"))?;
    let permission = ours.find("Permission is hereby granted").map(|start| &ours[start..]);
    permission
        .filter(|_| licence.split([' ', '/', '(', ')']).any(|name| name == "MIT"))
        .map(|permission| format!("MIT License\n\nCopyright (c) The authors of {package}\n\n{permission}"))
        .ok_or_else(|| format!("{package} ({licence}) has no file with its licence"))
}

/// The source folder of a crate, by its name and version.
fn crate_folder(name: &str) -> Result<PathBuf> {
    let home = env::var_os("CARGO_HOME").map(PathBuf::from);
    let home = home.or_else(|| env::home_dir().map(|home| home.join(".cargo"))).unwrap_or_default();
    let sources = home.join("registry/src");
    let indexes = fs::read_dir(&sources).map_err(|error| cannot("read", &sources, &error))?;
    let mut folders = indexes.flatten().map(|index| index.path().join(name));
    folders.find(|folder| folder.is_dir()).ok_or_else(|| format!("{} has no {name}", sources.display()))
}

/// The files of a crate that contain its licence; some crates have none.
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

fn read(file: &Path) -> Result<String> {
    fs::read_to_string(file).map_err(|error| cannot("read", file, &error))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_package_of_the_program_is_named_with_its_licence() {
        let text = of(&mut native()).expect("the licences");
        let parts: Vec<&str> = text.split(RULE).collect();
        let names = parts.iter().filter_map(|part| part.trim_end().lines().next_back());
        // `clap` has files with its licences, `i_overlay` has none.
        for package in ["clap v", "i_overlay v"] {
            assert!(names.clone().any(|name| name.starts_with(package)), "{package}");
        }
        for (name, licence) in names.zip(&parts[1..]) {
            let known = ["Permission is hereby granted", "Apache License"];
            assert!(known.iter().any(|words| licence.contains(words)), "{name}");
        }
    }

    #[test]
    fn a_package_without_any_licence_is_an_error() {
        let text = without_file("a v1", "Apache-2.0 OR MIT").expect("MIT");
        assert!(text.contains("The authors of a v1\n\nPermission is hereby granted"), "{text}");
        let message = without_file("a v1", "Apache-2.0").expect_err("no file, and not MIT");
        assert_eq!(message, "a v1 (Apache-2.0) has no file with its licence");
    }
}
