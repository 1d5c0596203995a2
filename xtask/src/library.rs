//! In: the sources and the description of the JavaScript package in `www/docs/library.md`. Out: whether the
//! description is true: the documented command builds the package of each target, its example runs under Node
//! and passes a strict `tsc`, no method traps with any argument, and the size is within budget. Also checks
//! that the crate written by `cargo package` builds.

use std::fs;
use std::path::Path;
use std::time::{Duration, Instant};

use crate::package::{Budget, compressed_size, write};
use crate::run::{self, Result, command, step};
use crate::setup::Setup;

const DOCUMENT: &str = "www/docs/library.md";

/// The module of the package contains all parts of the page, and cargo builds it without link-time
/// optimisation.
const MODULE: Budget = Budget { name: "the module of the package", bytes: 1_150_000 };

/// The output of the examples: the number of motions, and a message about the missing feed rate.
const PRINTED: [&str; 2] = ["1 [", "line 2: "];

/// A strict TypeScript configuration, which also checks the types of the package itself.
const TYPES: &str = r#"{
  "compilerOptions": {
    "target": "ES2022", "module": "ESNext", "moduleResolution": "bundler", "lib": ["ES2023", "DOM"],
    "strict": true, "noUncheckedIndexedAccess": true, "exactOptionalPropertyTypes": true, "noImplicitReturns": true,
    "noUnusedLocals": true, "noUnusedParameters": true, "verbatimModuleSyntax": true, "isolatedModules": true,
    "skipLibCheck": false, "noEmit": true, "types": ["node"], "typeRoots": ["TYPES"]
  },
  "files": ["program.mts"]
}
"#;

/// A target of wasm-pack, as described in the document.
#[derive(Debug, PartialEq, Eq)]
struct Target {
    name: String,
    /// The arguments of wasm-pack.
    build: Vec<String>,
    /// The example.
    script: String,
}

/// Checks the package of each target.
pub fn packages(setup: &Setup) -> Result<Duration> {
    let begun = Instant::now();
    let text = fs::read_to_string(run::root().join(DOCUMENT));
    let targets = targets(&text.map_err(|error| format!("cannot read {DOCUMENT}: {error}"))?)?;
    for target in &targets {
        // wasm-opt takes longer than all other steps, and has the same effect for each target.
        let optimise = if target == &targets[0] { Optimise::Yes } else { Optimise::No };
        target.check(setup, optimise)?;
    }
    let first = targets[0].folder().join("pkg");
    weigh(&first.join("gcode_playground_bg.wasm"))?;
    let mut hostile = command("node");
    step("hostile arguments", hostile.arg("tests/package/hostile.mjs").arg(&first))?;
    Ok(begun.elapsed())
}

/// Writes the crate that would be published, and builds it.
pub fn crate_file() -> Result<Duration> {
    let mut check = command("cargo");
    check.args(["check", "--lib", "--no-default-features"]);
    let library = step("checking the crate without the command line", &mut check)?;
    let mut package = command("cargo");
    package.args(["package", "--allow-dirty", "--quiet"]);
    // In the folder of the tests, this library would replace theirs: cargo writes it without a hash in its name.
    package.arg("--target-dir").arg(run::target().join("crate"));
    // The build only has to succeed.
    package.envs([("CARGO_PROFILE_DEV_OPT_LEVEL", "0"), ("CARGO_PROFILE_DEV_DEBUG", "0")]);
    Ok(library + step("building the packaged crate", &mut package)?)
}

#[derive(Clone, Copy)]
enum Optimise {
    Yes,
    No,
}

impl Target {
    /// Builds the package, runs the example and checks its types.
    fn check(&self, setup: &Setup, optimise: Optimise) -> Result {
        let folder = self.folder();
        fs::create_dir_all(&folder).map_err(|error| format!("cannot make {}: {error}", folder.display()))?;
        let mut wasm_pack = setup.command("wasm-pack");
        wasm_pack.env("CARGO_TARGET_DIR", run::target());
        wasm_pack.args(&self.build).args(["--mode", "no-install", "--out-dir"]).arg(folder.join("pkg"));
        match optimise {
            Optimise::Yes => {}
            Optimise::No => {
                wasm_pack.arg("--no-opt");
            }
        }
        step(&format!("building the package for {}", self.name), &mut wasm_pack)?;
        let types = run::www().join("node_modules/@types");
        write(&folder.join("tsconfig.json"), &TYPES.replace("TYPES", &types.display().to_string()))?;
        for kind in ["mjs", "mts"] {
            write(&folder.join(format!("program.{kind}")), &self.script)?;
        }
        let mut node = command("node");
        node.current_dir(&folder);
        if self.name == "bundler" {
            node.args(["--experimental-wasm-modules", "--no-warnings"]);
        }
        let printed = run::ask(node.arg("program.mjs"))
            .ok_or_else(|| format!("the example for {} fails: {}", self.name, run::shown(&node)))?;
        if let Some(missing) = PRINTED.iter().find(|part| !printed.contains(*part)) {
            return Err(format!("the example for {} does not print `{missing}`: {printed}", self.name));
        }
        let mut tsc = setup.command("tsc");
        step(&format!("checking the types for {}", self.name), tsc.arg("--project").arg(&folder)).map(drop)
    }

    fn folder(&self) -> std::path::PathBuf {
        run::target().join("packages").join(&self.name)
    }
}

/// The targets in the document: a wasm-pack command and a section with an example each.
fn targets(document: &str) -> Result<Vec<Target>> {
    let mut found = Vec::new();
    for line in document.lines().filter_map(|line| line.strip_prefix("    wasm-pack ")) {
        let build: Vec<String> = line.split_whitespace().map(str::to_owned).collect();
        let name = build.last().ok_or_else(|| format!("{DOCUMENT}: `{line}`"))?.clone();
        let section = document.split(&format!("\n### Target `{name}`\n")).nth(1);
        let section = section.ok_or_else(|| format!("{DOCUMENT} has no section `{name}`"))?;
        let section = section.split("\n#").next().unwrap_or_default();
        let lines = section.lines().filter_map(|line| line.strip_prefix("    "));
        let script: String = lines.flat_map(|line| [line, "\n"]).collect();
        if !script.starts_with("import ") {
            return Err(format!("{DOCUMENT}: the section `{name}` has no example"));
        }
        found.push(Target { name, build, script });
    }
    match found.len() {
        3 => Ok(found),
        other => Err(format!("{DOCUMENT} has {other} commands of wasm-pack")),
    }
}

fn weigh(module: &Path) -> Result {
    let cannot = |error: std::io::Error| format!("cannot read {}: {error}", module.display());
    MODULE.check(fs::read(module).and_then(|bytes| compressed_size(&bytes)).map_err(cannot)?)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn library() -> String {
        fs::read_to_string(run::root().join(DOCUMENT)).expect(DOCUMENT)
    }

    #[test]
    fn the_document_describes_three_targets_with_an_example_each() {
        let targets = targets(&library()).expect("targets");
        let names: Vec<&str> = targets.iter().map(|target| target.name.as_str()).collect();
        assert_eq!(names, ["nodejs", "web", "bundler"]);
        // The shortest example has five lines.
        assert_eq!(targets[0].script.lines().count(), 5);
        for target in &targets {
            assert_eq!(target.build[0], "build");
            assert!(target.script.contains("playground.diagnostics()"), "{}", target.name);
        }
    }

    #[test]
    fn a_section_that_is_missing_is_named() {
        let text = library().replace("### Target `web`", "### Target `www`");
        assert_eq!(targets(&text), Err(format!("{DOCUMENT} has no section `web`")));
    }
}
