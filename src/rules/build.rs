//! The build script: generates Rust code and lists of texts from the rule files and `src/sentences`.
//!
//! In: `src/rules/<slug>.md`, `src/sentences/<language>.txt`. Out, in `OUT_DIR`: `message.rs` (the message
//! types and the table of rules), `<language>.txt` (all texts of a language), `places.rs` (the index of each
//! text in these lists), `example_messages.rs` (a value of each message, for tests) and `pages.rs` (the rule
//! pages, for the command line). An error in a file fails the build and is reported with file and line; a
//! missing translation is a warning.

mod format;
mod generate;
mod texts;

use std::path::Path;
use std::process::ExitCode;
use std::{env, fs};

use texts::Texts;

fn main() -> ExitCode {
    println!("cargo::rerun-if-changed=src/rules");
    println!("cargo::rerun-if-changed=src/sentences");
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
    let texts = Texts::read(env!("CARGO_MANIFEST_DIR"));
    mistakes.extend_from_slice(&texts.mistakes);
    if !mistakes.is_empty() {
        for mistake in &mistakes {
            eprintln!("{mistake}");
        }
        return ExitCode::FAILURE;
    }
    for missing in texts::missing(&rules, &texts) {
        println!("cargo::warning={missing}");
    }
    let Some(folder) = env::var_os("OUT_DIR") else {
        eprintln!("cargo sets OUT_DIR");
        return ExitCode::FAILURE;
    };
    for (name, content) in generate::files(&rules, &texts) {
        if let Err(error) = fs::write(Path::new(&folder).join(&name), content) {
            eprintln!("{name}: {error}");
            return ExitCode::FAILURE;
        }
    }
    ExitCode::SUCCESS
}
