//! Writes the pages of all rules as HTML. Part of building the page: `cargo xtask play` and `cargo xtask test`.
//!
//! In: a folder. Out: in it `<lang>/<slug>.html`, `<lang>/index.html`, the pictures, and the style sheet of all.

mod book;
mod outcome;
mod page;
mod words;

use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::{env, fs, io};

fn main() -> ExitCode {
    // cargo puts options of its own behind ours.
    let folder = env::args().skip(1).find(|argument| !argument.starts_with('-'));
    match write(&PathBuf::from(folder.unwrap_or_else(|| "target/rules".into()))) {
        Ok(count) => {
            println!("{count} files of rule pages");
            ExitCode::SUCCESS
        }
        Err(problem) => {
            eprintln!("{problem}");
            ExitCode::FAILURE
        }
    }
}

fn write(folder: &Path) -> Result<usize, String> {
    let (mut pages, mut slips) = (Vec::new(), Vec::new());
    for (name, page) in page::all() {
        match page {
            Ok(page) => pages.push(page),
            Err(found) => slips.extend(found.iter().map(|slip| format!("{name}.md: {slip}"))),
        }
    }
    if !slips.is_empty() {
        return Err(slips.join("\n"));
    }
    let files = book::files(&pages)?;
    let saved = || -> io::Result<()> {
        for (name, content) in &files {
            let path = folder.join(name);
            fs::create_dir_all(path.parent().unwrap_or(folder))?;
            fs::write(path, content)?;
        }
        Ok(())
    };
    saved().map_err(|error| format!("{}: {error}", folder.display()))?;
    Ok(files.len())
}
