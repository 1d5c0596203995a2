//! Writes the reference (`www/docs/*.md`) and the pages of the manual (`www/manual`) as HTML. Part of building the page:
//! `cargo xtask site` and `cargo xtask test`.
//!
//! In: the folder of the site. Out: its folder `docs`, with one page for each document (`README.md` becomes
//! `index.html`), and its folder `manual`, with one page for each document and language; a style sheet in each. The folder
//! `manual-of-element` is the manual for the package of the element.

mod calculator;
mod figure;
mod form;
mod manual;
mod site;

use std::path::Path;
use std::process::ExitCode;
use std::{env, fs, io};

/// The folder of the reference.
const REFERENCE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/..");

/// The folder of the pages of the manual.
const MANUAL: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../manual");

/// The exercises of the course.
const EXERCISES: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../exercises");

/// The programs of the gallery.
const PROGRAMS: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../../tests/programs");

fn main() -> ExitCode {
    let folder = env::args_os().nth(1).unwrap_or_else(|| "target/documents".into());
    match write(Path::new(&folder)) {
        Ok(count) => {
            println!("{count} files of the reference and the pages of the manual");
            ExitCode::SUCCESS
        }
        Err(problem) => {
            eprintln!("{problem}");
            ExitCode::FAILURE
        }
    }
}

fn write(site: &Path) -> Result<usize, String> {
    let pages = manual::files(Path::new(MANUAL), Path::new(EXERCISES))?;
    let without_page = manual::without_page(&pages, Path::new(PROGRAMS))?;
    let folders = [
        (site.join("docs"), site::files(Path::new(REFERENCE))?),
        (site.join("manual"), pages),
        // `xtask` moves it into the package of the element.
        (site.join("manual-of-element"), without_page),
    ];
    let mut count = 0;
    for (folder, files) in folders {
        let save = || -> io::Result<()> {
            for (name, content) in &files {
                let path = folder.join(name);
                fs::create_dir_all(path.parent().unwrap_or(&folder))?;
                fs::write(path, content)?;
            }
            Ok(())
        };
        save().map_err(|error| format!("{}: {error}", folder.display()))?;
        count += files.len();
    }
    Ok(count)
}
