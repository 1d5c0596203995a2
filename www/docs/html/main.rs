//! Writes the reference (`www/docs/*.md`) as HTML. Part of building the page:
//! `cargo xtask site` and `cargo xtask test`.
//!
//! In: a folder. Out: one page for each document (`README.md` becomes `index.html`), and one style sheet.

mod site;

use std::path::Path;
use std::process::ExitCode;
use std::{env, fs, io};

/// The folder of the documents.
const DOCUMENTS: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/..");

fn main() -> ExitCode {
    let folder = env::args_os().nth(1).unwrap_or_else(|| "target/docs".into());
    match write(Path::new(&folder)) {
        Ok(count) => {
            println!("{count} files of the reference");
            ExitCode::SUCCESS
        }
        Err(problem) => {
            eprintln!("{problem}");
            ExitCode::FAILURE
        }
    }
}

fn write(folder: &Path) -> Result<usize, String> {
    let files = site::files(Path::new(DOCUMENTS))?;
    let save = || -> io::Result<()> {
        fs::create_dir_all(folder)?;
        for (name, content) in &files {
            fs::write(folder.join(name), content)?;
        }
        Ok(())
    };
    save().map_err(|error| format!("{}: {error}", folder.display()))?;
    Ok(files.len())
}
