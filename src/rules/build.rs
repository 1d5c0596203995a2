//! The build script: makes Rust code of the rule files.
//!
//! In: `src/rules/<slug>.md`. Out, in `OUT_DIR`: `message.rs` (the types of messages and the table of rules),
//! `sentences.rs` (the templates in three languages), `example_messages.rs` (a value of each message, for tests)
//! and `pages.rs` (the rule pages, for the command line). A mistake in a rule file fails the build with file and line.

mod format;
mod generate;

use std::path::Path;
use std::process::ExitCode;
use std::{env, fs};

fn main() -> ExitCode {
    println!("cargo::rerun-if-changed=src/rules");
    let mut mistakes = Vec::new();
    let mut rules = Vec::new();
    for (name, rule) in format::all(env!("CARGO_MANIFEST_DIR")) {
        match rule {
            Ok(rule) => rules.push(rule),
            Err(found) => {
                let at = |mistake: &format::Mistake| {
                    format!("src/rules/{name}.md:{}: {}", mistake.line, mistake.what)
                };
                mistakes.extend(found.iter().map(at));
            }
        }
    }
    mistakes.extend(generate::duplicates(&rules));
    if !mistakes.is_empty() {
        for mistake in &mistakes {
            eprintln!("{mistake}");
        }
        return ExitCode::FAILURE;
    }
    let Some(folder) = env::var_os("OUT_DIR") else {
        eprintln!("cargo sets OUT_DIR");
        return ExitCode::FAILURE;
    };
    for (name, content) in generate::files(&rules) {
        if let Err(error) = fs::write(Path::new(&folder).join(&name), content) {
            eprintln!("{name}: {error}");
            return ExitCode::FAILURE;
        }
    }
    ExitCode::SUCCESS
}
