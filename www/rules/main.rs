//! Writes the pages of all rules as HTML. Part of building the page:
//! `cargo xtask site` and `cargo xtask test`.
//!
//! In: a folder. Out: `<lang>/<slug>.html`, `<lang>/index.html`, the pictures, one style sheet, and
//! `<lang>/messages.json`: the templates of all messages in a language, by message name.

mod book;
#[path = "../../src/rules/format/mod.rs"]
mod format;
mod outcome;
mod templates;
mod words;

use std::path::Path;
use std::process::ExitCode;
use std::{env, fs, io};

/// Root folder of the project.
const PROJECT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");

fn main() -> ExitCode {
    let folder = env::args_os().nth(1).unwrap_or_else(|| "target/rules".into());
    match write(Path::new(&folder)) {
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
    let (mut rules, mut mistakes) = (Vec::new(), Vec::new());
    for (name, rule) in format::all(PROJECT) {
        match rule {
            Ok(rule) => rules.push(rule),
            Err(found) => mistakes.extend(found.iter().map(|mistake| format!("{name}.md: {mistake}"))),
        }
    }
    if !mistakes.is_empty() {
        return Err(mistakes.join("\n"));
    }
    let mut files = book::files(&rules, &Path::new(PROJECT).join("www/manual"))?;
    for (index, language) in format::LANGUAGES.iter().enumerate() {
        files.insert(format!("{language}/messages.json"), templates::json(&rules, index));
    }
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
