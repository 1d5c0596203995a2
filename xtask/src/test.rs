//! In: the whole working tree. Out: whether all checks pass. Stops at the first step that fails.
//!
//! `cargo xtask test` checks a change in minutes; `--native` and `--page` are its halves, for parallel jobs.
//! `--all` adds checks that are slow or that a change rarely breaks: the fuzz targets, the hostile programs, a
//! long program in the language server, the packages for other projects, the command line under Node, the
//! recipes for manuals, the checks in a repository, the server in editors, the extension for Visual Studio
//! Code, and every browser test in three engines.

use std::env;
use std::path::PathBuf;
use std::process::Stdio;
use std::time::{Duration, Instant};

use crate::run::{self, Result, command, pretty, step};
use crate::setup::Setup;
use crate::{
    browser, debian, editors, engines, hostile, library, manuals, native, npx, package, spelling, teams,
    translations, vscode,
};

/// Which checks to run.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Tier {
    /// The checks that a single change is most likely to fail.
    Change,
    /// The half of them without the page: format, lints, native tests, the module under Node.
    Native,
    /// The other half: sizes, types, workflows, the page in browsers. A share `1/3` runs a part of the
    /// browser tests.
    Page(Option<String>),
    /// Everything.
    All,
}

/// The environment variable that requests every browser test in every engine that can run it.
const ALL_BROWSER_TESTS: &str = "PLAYGROUND_ALL_ENGINES";

/// The steps that have passed, with their times.
#[derive(Default)]
struct Done(Vec<(&'static str, Duration)>);

impl Done {
    fn add(&mut self, name: &'static str, time: Duration) {
        self.0.push((name, time));
    }
}

/// `cargo xtask test`.
pub fn main(tier: &Tier) -> Result {
    let start = Instant::now();
    let mut done = Done::default();
    let (has_native, has_page) = (!matches!(tier, Tier::Page(_)), *tier != Tier::Native);

    // Checks without set-up come first: a format error is reported within a second.
    if has_native {
        done.add("format", step("checking the format", command("cargo").args(["fmt", "--all", "--check"]))?);
        let mut clippy = command("cargo");
        clippy.args(["clippy", "--workspace", "--all-targets", "--", "-D", "warnings"]);
        done.add("lints", step("lints, native", &mut clippy)?);
    }
    let setting_up = Instant::now();
    let (setup, browsers) = set_up(tier)?;
    done.add("set-up", setting_up.elapsed());
    if has_native {
        native(&setup, &mut done)?;
    }
    if has_page {
        page(&setup, &browsers, tier, &mut done)?;
    }

    let list: Vec<_> = done.0.iter().map(|(name, time)| format!("{name} {}", pretty(*time))).collect();
    run::say(format_args!("times: {}", list.join(", ")));
    run::say(format_args!("all {} steps passed in {}", list.len(), pretty(start.elapsed())));
    Ok(())
}

/// Installs what the checks need. The variables name the browsers.
fn set_up(tier: &Tier) -> Result<(Setup, Vec<(&'static str, PathBuf)>)> {
    // On the machine of a contributor, nothing is installed without consent.
    if env::var_os("CI").is_none_or(|value| value != "true") {
        debian::forbid();
    }
    let setup = match tier {
        Tier::Page(_) => Setup::for_building(),
        Tier::Change | Tier::Native => Setup::for_testing(),
        Tier::All => Setup::for_packages(),
    }?;
    let spelling = if matches!(tier, Tier::Page(_)) { Ok(()) } else { spelling::ensure() };
    let browsers = if *tier == Tier::Native { Ok(Vec::new()) } else { browsers() };
    match (spelling, browsers) {
        (Ok(()), Ok(browsers)) => Ok((setup, browsers)),
        (spelling, browsers) => Err(all_of([spelling.err(), browsers.err()])
            + "\n\n`cargo xtask setup` installs all of it on Debian."),
    }
}

/// The messages of the checks that failed, a paragraph each.
fn all_of(errors: [Option<String>; 2]) -> String {
    errors.into_iter().flatten().collect::<Vec<_>>().join("\n\n")
}

fn browsers() -> Result<Vec<(&'static str, PathBuf)>> {
    match (browser::for_tests(), engines::ensure()) {
        (Ok(chromium), Ok(engines)) => {
            Ok([(browser::VARIABLE, chromium)].into_iter().chain(engines).collect())
        }
        (chromium, engines) => Err(all_of([chromium.err(), engines.err()])),
    }
}

/// The checks without the page.
fn native(setup: &Setup, done: &mut Done) -> Result {
    let mut clippy = setup.command("cargo");
    clippy.args(["clippy", "--target", "wasm32-unknown-unknown", "--lib", "--test", "wasm"]);
    clippy.args(["--", "-D", "warnings"]);
    done.add("wasm lints", step("lints, wasm32", &mut clippy)?);
    // `--all` compiles the fuzz targets; their lock file changes with each new dependency.
    let mut fuzz = command("cargo");
    fuzz.args(["metadata", "--locked", "--format-version", "1", "--manifest-path", "tests/fuzz/Cargo.toml"]);
    done.add("fuzz lock file", step("the lock file of the fuzz targets", fuzz.stdout(Stdio::null()))?);
    done.add("native tests", step("native tests", command("cargo").args(["test", "--workspace"]))?);
    let mut under_node = setup.command("cargo");
    under_node.args(["test", "--target", "wasm32-unknown-unknown", "--test", "wasm"]);
    under_node.env("CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_RUNNER", "wasm-bindgen-test-runner");
    under_node.env("WASM_BINDGEN_TEST_ONLY_NODE", "1");
    done.add("wasm tests", step("wasm tests under Node", &mut under_node)?);
    Ok(())
}

/// The checks of the page: its module, its files, and its behaviour in browsers.
fn page(setup: &Setup, browsers: &[(&'static str, PathBuf)], tier: &Tier, done: &mut Done) -> Result {
    if *tier == Tier::All {
        products(setup, done)?;
    } else {
        done.add("wasm package", package::wasm(setup)?);
    }
    done.add("wasm size", package::size()?);
    let begun = Instant::now();
    let missing = translations::missing()?;
    if !missing.is_empty() {
        let message = translations::message(&missing);
        if *tier == Tier::All {
            return Err(message);
        }
        run::say(format_args!("warning: {message}"));
    }
    done.add("translations", begun.elapsed());
    done.add("page lints", step("format and lints of the TypeScript", &mut setup.npm(&["run", "lint"]))?);
    done.add("page types", step("checking the page's types", &mut setup.npm(&["run", "typecheck"]))?);
    done.add(
        "workflows",
        step("checking the workflows", command("node").arg("tests/package/workflows.mjs"))?,
    );
    done.add("page", package::page(setup, native::Beside::Tests)?);
    let mut playwright = setup.npm(&["run", "test:browser"]);
    playwright.envs(browsers.iter().cloned());
    if *tier == Tier::All {
        for_other_projects(setup, done)?;
        playwright.env(ALL_BROWSER_TESTS, "1");
    }
    if let Tier::Page(Some(share)) = tier {
        playwright.args(["--", &format!("--shard={share}")]);
    }
    done.add("browser tests", step("browser tests", &mut playwright)?);
    Ok(())
}

/// Builds everything else, with the checks that need nothing further.
fn products(setup: &Setup, done: &mut Done) -> Result {
    let mut fuzz = command("cargo");
    fuzz.args(["check", "--locked", "--manifest-path", "tests/fuzz/Cargo.toml", "--no-default-features"]);
    fuzz.args(["--target-dir", "target/fuzz"]);
    done.add("fuzz targets", step("checking the fuzz targets", &mut fuzz)?);
    // Optimising a module as a whole uses only one processor.
    let (wasm, packages) = run::both(|| package::wasm(setup), || library::packages(setup))?;
    done.add("wasm package", wasm);
    done.add("packages", packages);
    let (node, crate_file) = run::both(|| npx::module(setup), library::crate_file)?;
    done.add("module for Node", node);
    done.add("crate", crate_file);
    // Their times are measured, so nothing runs in parallel.
    done.add("hostile programs", hostile::main(None)?);
    done.add("long program in the server", hostile::server(None)?);
    Ok(())
}

/// Checks of the packages that other projects use.
fn for_other_projects(setup: &Setup, done: &mut Done) -> Result {
    npx::put_into_package()?;
    // Each of the two runs its programs one after the other.
    let (teams, (node, manuals, editors)) =
        run::both(teams::ways, || Ok((npx::compare(setup)?, manuals::recipes()?, editors::editors()?)))?;
    done.add("command line for Node", node);
    done.add("manuals", manuals);
    done.add("editors", editors);
    done.add("teams", teams);
    // A browser test starts it.
    done.add("extension", vscode::pack(setup)?);
    Ok(())
}
