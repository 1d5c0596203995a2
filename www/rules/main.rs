//! Writes the pages of all rules as HTML. Part of building the page:
//! `cargo xtask play` and `cargo xtask test`.
//!
//! In: a folder. Out: in it `<lang>/<slug>.html`, `<lang>/index.html`, the pictures, the style sheet of all,
//! and `<lang>/messages.json`: the templates of all messages in a language, by the names of the messages.

mod book;
#[path = "../../src/rules/format/mod.rs"]
mod format;
mod outcome;
mod words;

use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::{env, fs, io};

/// The templates of each language, which the build script of the library made.
const SENTENCES: [(&str, &str); 3] = [
    ("en", include_str!(concat!(env!("OUT_DIR"), "/messages.en.json"))),
    ("zh", include_str!(concat!(env!("OUT_DIR"), "/messages.zh.json"))),
    ("ru", include_str!(concat!(env!("OUT_DIR"), "/messages.ru.json"))),
];

fn main() -> ExitCode {
    // cargo puts options of its own after ours.
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
    let (mut rules, mut mistakes) = (Vec::new(), Vec::new());
    for (name, rule) in format::all() {
        match rule {
            Ok(rule) => rules.push(rule),
            Err(found) => mistakes.extend(found.iter().map(|mistake| format!("{name}.md: {mistake}"))),
        }
    }
    if !mistakes.is_empty() {
        return Err(mistakes.join("\n"));
    }
    let mut files = book::files(&rules)?;
    for (language, sentences) in SENTENCES {
        files.insert(format!("{language}/messages.json"), sentences.to_owned());
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
