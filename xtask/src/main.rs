//! Developer commands: `cargo xtask …` builds, serves and tests the project, and installs what is needed for
//! that. In: the command line. Out: exit code 0; 1 if a step failed; 2 if the command line is invalid.
//!
//! Dependencies: as few as possible, because every user compiles this first. `flate2` compresses files to
//! measure the served size. `wasm-bindgen-cli-support` generates the JavaScript of a module: compiling it
//! takes half as long as installing its command.

mod advisories;
mod bench;
mod bindgen;
mod browser;
mod compare;
mod debian;
mod editors;
mod embed;
mod engines;
#[allow(dead_code, reason = "the build script uses all of it")]
#[path = "../../src/rules/format/mod.rs"]
mod format;
mod hostile;
mod library;
mod manuals;
mod native;
mod notices;
mod npx;
mod package;
mod packages;
mod parts;
mod play;
mod run;
mod setup;
mod spelling;
mod teams;
mod test;
#[path = "../../src/rules/texts.rs"]
mod texts;
mod tools;
mod translations;
mod vscode;
mod wasm_std;

use std::env;
use std::process::ExitCode;

use play::{Browser, Options};
use setup::Setup;

const USAGE: &str = "\
cargo xtask play [--port N] [--no-open]   serve the playground on localhost, open a browser, show each change
cargo xtask site                          build the whole static site into www/dist
cargo xtask test [--all | --native | --page [--shard N/M]]
                                          check a change: native tests, the page in Chromium, part of it in two other engines
                                          (--all: everything, as before a release; --native, --page: one half of the rest;
                                          --shard 1/3: a third of its browser tests)
cargo xtask bench [--own] [--write] [--rounds N]
                                          measure beside a floor and other programs, print the tables
                                          (--own: without the others; --write: into tests/speed/README.md)
cargo xtask compare-linuxcnc [--programs N] [--seed N]
                                          compare random programs with LinuxCNC's interpreter
cargo xtask manuals                       follow the recipes of www/docs/manuals.md with mdBook, Sphinx and Docusaurus
cargo xtask teams                         follow www/docs/teams.md with pre-commit, GitHub's and GitLab's files
cargo xtask editors                       follow www/docs/editors.md with Neovim and Emacs
cargo xtask vscode                        pack the extension for Visual Studio Code
cargo xtask translations                  list the texts that Chinese or Russian lacks
cargo xtask advisories                    check the licences and advisories of all packages
cargo xtask notices                       write the licences of the packages in the native program into target/notices
cargo xtask setup                         only install what the other commands need
";

/// The parsed command line.
#[derive(Debug, PartialEq, Eq)]
enum Task {
    Play(Options),
    Site,
    Test(test::Tier),
    Bench(bench::Options),
    Compare(Vec<String>),
    Manuals,
    Teams,
    Editors,
    Vscode,
    Translations,
    Advisories,
    Notices,
    Setup,
    Help,
}

fn main() -> ExitCode {
    let arguments: Vec<String> =
        env::args_os().skip(1).map(|word| word.to_string_lossy().into_owned()).collect();
    let words: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let task = match parse(&words) {
        Ok(task) => task,
        Err(message) => {
            eprintln!("xtask: {message}\n\n{USAGE}");
            return ExitCode::from(2);
        }
    };
    let result = match task {
        Task::Play(options) => play::main(options),
        Task::Site => Setup::for_building().and_then(|setup| package::site(&setup)),
        Task::Test(tier) => test::main(&tier),
        Task::Bench(options) => bench::main(options),
        Task::Compare(options) => compare::main(&options),
        Task::Manuals => manuals::main(),
        Task::Teams => teams::main(),
        Task::Editors => editors::main(),
        Task::Vscode => vscode::main(),
        Task::Translations => Setup::for_playing().and_then(|_| translations::main()),
        Task::Advisories => advisories::main(),
        Task::Notices => notices::main(),
        Task::Setup => setup::main(),
        Task::Help => {
            print!("{USAGE}");
            Ok(())
        }
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("\nxtask: {message}");
            ExitCode::FAILURE
        }
    }
}

fn parse(words: &[&str]) -> run::Result<Task> {
    match words {
        ["play", options @ ..] => parse_play(options).map(Task::Play),
        ["site"] => Ok(Task::Site),
        ["test", options @ ..] if !options.contains(&"--help") => parse_test(options).map(Task::Test),
        ["bench", options @ ..] if !options.contains(&"--help") => parse_bench(options).map(Task::Bench),
        ["compare-linuxcnc", options @ ..] => {
            Ok(Task::Compare(options.iter().map(|word| (*word).to_owned()).collect()))
        }
        ["manuals"] => Ok(Task::Manuals),
        ["teams"] => Ok(Task::Teams),
        ["editors"] => Ok(Task::Editors),
        ["vscode"] => Ok(Task::Vscode),
        ["translations"] => Ok(Task::Translations),
        ["advisories"] => Ok(Task::Advisories),
        ["notices"] => Ok(Task::Notices),
        ["setup"] => Ok(Task::Setup),
        ["help" | "--help" | "-h", ..] | [_, "--help" | "-h"] => Ok(Task::Help),
        [] => Err("which command?".to_owned()),
        _ => Err(format!("`{}` is not understood", words.join(" "))),
    }
}

fn parse_play(words: &[&str]) -> run::Result<Options> {
    let mut options = Options { port: None, browser: Browser::Open };
    let mut words = words.iter();
    while let Some(word) = words.next() {
        match *word {
            "--no-open" => options.browser = Browser::Leave,
            "--port" => {
                let number = words.next().ok_or("--port wants a number")?;
                options.port = Some(number.parse().map_err(|_| format!("`{number}` is no port number"))?);
            }
            other => return Err(format!("`{other}` is not understood")),
        }
    }
    Ok(options)
}

fn parse_test(words: &[&str]) -> run::Result<test::Tier> {
    match words {
        [] => Ok(test::Tier::Change),
        ["--all"] => Ok(test::Tier::All),
        ["--native"] => Ok(test::Tier::Native),
        ["--page"] => Ok(test::Tier::Page(None)),
        ["--page", "--shard", share] => Ok(test::Tier::Page(Some((*share).to_owned()))),
        _ => Err(format!("`test {}` is not understood", words.join(" "))),
    }
}

fn parse_bench(words: &[&str]) -> run::Result<bench::Options> {
    let mut options = bench::Options::default();
    let mut words = words.iter();
    while let Some(word) = words.next() {
        match *word {
            "--own" => options.own = true,
            "--write" => options.write = true,
            "--rounds" => {
                let number = words.next().ok_or("--rounds wants a number")?;
                let rounds = number.parse().ok().filter(|&rounds| rounds > 0);
                options.rounds = Some(rounds.ok_or_else(|| format!("`{number}` is no number of rounds"))?);
            }
            other => return Err(format!("`{other}` is not understood")),
        }
    }
    Ok(options)
}

#[cfg(test)]
#[path = "../../tests/documentation/documents.rs"]
mod documents;

#[cfg(test)]
mod tests {
    use super::documents::DOCUMENTS;
    use super::*;

    /// The commands in the documents, from code spans and blocks; two blanks separate a command from its
    /// explanation.
    fn documented() -> Vec<String> {
        let mut found = Vec::new();
        for document in DOCUMENTS {
            let text = std::fs::read_to_string(run::root().join(document)).expect(document);
            for rest in text.split("cargo xtask ").skip(1) {
                found.extend(
                    rest.split(['`', '\n'])
                        .next()
                        .and_then(|line| line.split("  ").next())
                        .map(str::to_owned),
                );
            }
        }
        found
    }

    #[test]
    fn every_command_of_the_documents_is_understood() {
        let documented = documented();
        assert!(documented.len() > 10, "{documented:?}");
        for line in &documented {
            let words: Vec<&str> = line.split_whitespace().collect();
            assert!(parse(&words).is_ok(), "cargo xtask {line}");
        }
        for line in USAGE.lines().filter_map(|line| line.strip_prefix("cargo xtask ")) {
            let name = line.split_whitespace().next().expect("a name");
            let told = documented.iter().any(|line| line.split_whitespace().next() == Some(name));
            assert!(told, "no document names `cargo xtask {name}`");
        }
    }

    #[test]
    fn command_lines() {
        let play = |port, browser| Ok(Task::Play(Options { port, browser }));
        assert_eq!(parse(&["play"]), play(None, Browser::Open));
        assert_eq!(parse(&["play", "--no-open", "--port", "81"]), play(Some(81), Browser::Leave));
        assert_eq!(parse(&["test"]), Ok(Task::Test(test::Tier::Change)));
        assert_eq!(parse(&["test", "--all"]), Ok(Task::Test(test::Tier::All)));
        assert_eq!(parse(&["test", "--native"]), Ok(Task::Test(test::Tier::Native)));
        let third = test::Tier::Page(Some("1/3".into()));
        assert_eq!(parse(&["test", "--page", "--shard", "1/3"]), Ok(Task::Test(third)));
        assert_eq!(parse(&["test", "--help"]), Ok(Task::Help));
        assert_eq!(
            parse(&["compare-linuxcnc", "--seed", "2"]),
            Ok(Task::Compare(vec!["--seed".into(), "2".into()]))
        );
        let own = bench::Options { own: true, rounds: Some(3), write: false };
        assert_eq!(parse(&["bench", "--own", "--rounds", "3"]), Ok(Task::Bench(own)));
        assert_eq!(parse(&["bench", "--help"]), Ok(Task::Help));
        assert!(parse(&["bench", "--rounds", "0"]).is_err());
        assert!(parse(&["play", "--port", "x"]).is_err());
        assert!(parse(&["play", "--port"]).is_err());
        assert!(parse(&["test", "more"]).is_err());
        assert!(parse(&[]).is_err());
    }
}
