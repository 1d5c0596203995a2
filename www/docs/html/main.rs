//! Writes the reference (`www/docs/*.md`) as HTML. Part of building the page:
//! `cargo xtask play` and `cargo xtask test`.
//!
//! In: a folder. Out: in it one page per document, `README.md` as `index.html`, and the style sheet of all.

mod site;

use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::{env, fs, io};

fn main() -> ExitCode {
    // cargo appends options of its own.
    let folder = env::args().skip(1).find(|argument| !argument.starts_with('-'));
    match write(&PathBuf::from(folder.unwrap_or_else(|| "target/docs".into()))) {
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
    let files = site::files()?;
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
