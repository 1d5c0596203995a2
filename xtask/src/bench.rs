//! In: the options. Out: the tables of `tests/speed/README.md`: the playground compared with a floor and its
//! peers, natively, in wasm under Node and in a browser; the times of the hostile programs; the cost of the
//! first picture on a slow line; the times of the language server.

use std::fs;
use std::path::{Path, PathBuf};

use crate::package::{self, Module};
use crate::run::{self, Result, command, npm, step};
use crate::setup::Setup;
use crate::{browser, hostile, packages};

#[path = "../../tests/speed/workload.rs"]
mod workload;

/// A well-known linter for comparison.
const RUFF: &str = "ruff==0.17.6";

/// Default number of rounds for the command line.
const ROUNDS: u32 = 5;

/// The arguments of `cargo xtask bench`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Options {
    /// Measure only the playground and the floor; no peer is installed.
    pub own: bool,
    /// Write the tables into `tests/speed/README.md`.
    pub write: bool,
    /// Number of rounds of all measurements.
    pub rounds: Option<u32>,
}

/// `cargo xtask bench`.
pub fn main(options: Options) -> Result {
    let setup = Setup::for_building()?;
    let browser = browser::ensure()?;
    package::site(&setup)?;
    let binaries = run::target();
    let peers = binaries.join("bench-peers");
    build_floor_and_peers(&setup, options, &peers)?;
    let mut native = command("cargo");
    step("compiling the native run", native.args(["build", "--release", "--example", "native"]))?;
    let folder = binaries.join("bench");
    write_programs(&folder)?;
    let [measures, hostile_times, first_picture, over_files, server] =
        ["measures.md", "hostile.md", "first-picture.md", "command-line.md", "server.md"]
            .map(|name| folder.join(name));
    let mut node = command("node");
    node.arg("tests/speed/measure.mjs").arg(&folder).env(browser::VARIABLE, &browser);
    node.arg("--binaries").arg(binaries.join("release/examples")).arg("--peers").arg(peers.join("release"));
    node.arg("--report").arg(&measures);
    if let Some(rounds) = options.rounds {
        node.arg("--rounds").arg(rounds.to_string());
    }
    if options.own {
        node.arg("--own");
    }
    step("measuring", &mut node)?;
    hostile::main(Some(&hostile_times))?;
    hostile::server(Some(&server))?;
    let mut picture = command("node");
    picture.arg("tests/speed/first-picture.mjs").arg("--report").arg(&first_picture);
    picture.env(browser::VARIABLE, &browser);
    if let Some(rounds) = options.rounds {
        picture.arg("--rounds").arg(rounds.to_string());
    }
    step("measuring the first picture", &mut picture)?;
    command_line(&folder, &over_files, options.rounds.unwrap_or(ROUNDS))?;
    if options.write {
        write_tables(&[
            ("command-line", over_files),
            ("measures", measures),
            ("hostile", hostile_times),
            ("first-picture", first_picture),
            ("server", server),
        ])?;
    }
    Ok(())
}

/// Measures the command line on files, natively and under Node, compared with ruff.
fn command_line(folder: &Path, report: &Path, rounds: u32) -> Result {
    let mut build = command("cargo");
    step("compiling the command line", build.args(["build", "--release", "--bin", "gcode-playground"]))?;
    let ruff = packages::python("bench/python", &[RUFF])?.join("ruff");
    let mut python = command("python3");
    python.arg("tests/speed/command_line.py");
    python.arg(run::target().join("release/gcode-playground"));
    python.arg(run::www().join("dist/embed/bin/gcode-playground.js")).arg(ruff);
    python.arg(folder.join("plain.nc")).arg(folder).arg(report).arg(rounds.to_string());
    step("measuring the command line", &mut python).map(|_| ())
}

/// Builds the floor and the crates as wasm and as a native program, and installs the npm packages.
fn build_floor_and_peers(setup: &Setup, options: Options, target: &Path) -> Result {
    let folder = run::root().join("tests/speed/peers");
    let features: &[&str] = if options.own { &[] } else { &["--features", "peers"] };
    let module = Module {
        name: "bench_peers",
        folder: folder.clone(),
        profile: "release",
        features,
        target: target.to_owned(),
        package: folder.join("pkg"),
        optimised: &["-O3"],
        is_cut: false,
    };
    module.build(setup)?;
    let mut cargo = command("cargo");
    cargo.current_dir(&folder).env("CARGO_TARGET_DIR", target);
    step(
        "building the floor and the crates natively",
        cargo.args(["build", "--release", "--bin", "native"]).args(features),
    )?;
    if !options.own {
        let mut npm = npm();
        npm.current_dir(&folder).args(["ci", "--no-audit", "--no-fund"]);
        // The table reports a missing peer.
        if let Err(problem) = step("installing the peers from npm", &mut npm) {
            run::say(problem);
        }
    }
    Ok(())
}

fn write_programs(folder: &Path) -> Result {
    // Files left by an earlier run must not be measured.
    let _ = fs::remove_dir_all(folder);
    fs::create_dir_all(folder).map_err(|error| format!("cannot make {}: {error}", folder.display()))?;
    let write = |name: &str, text: String| {
        fs::write(folder.join(name), text).map_err(|error| format!("cannot write {name}: {error}"))
    };
    write("plain.nc", workload::plain(1_000_000))?;
    write("shaft.nc", workload::shaft())?;
    write("boxes.nc", workload::boxes(10_000))?;
    write("short.nc", workload::plain(3_000))?;
    write("rounds.nc", workload::rounds(3_000))?;
    for passes in workload::PASSES {
        write(&format!("passes-{passes}.nc"), workload::passes(passes))?;
    }
    let mut contours = workload::POINTS.into_iter();
    contours.try_for_each(|points| write(&format!("contour-{points}.nc"), workload::contour(points)))
}

/// Writes tables between their markers in `tests/speed/README.md`.
fn write_tables(tables: &[(&str, PathBuf)]) -> Result {
    let path = run::root().join("tests/speed/README.md");
    let read = |path: &Path| {
        fs::read_to_string(path).map_err(|error| format!("cannot read {}: {error}", path.display()))
    };
    let mut text = read(&path)?;
    for (name, table) in tables {
        text = between(&text, name, &read(table)?)
            .ok_or_else(|| format!("{} has no marks for `{name}`", path.display()))?;
    }
    fs::write(&path, text).map_err(|error| format!("cannot write {}: {error}", path.display()))
}

/// Replaces the content between `<!-- name -->` and `<!-- /name -->` in a text.
fn between(text: &str, name: &str, content: &str) -> Option<String> {
    let (head, rest) = text.split_once(&format!("<!-- {name} -->\n"))?;
    let (_, tail) = rest.split_once(&format!("<!-- /{name} -->"))?;
    Some(format!("{head}<!-- {name} -->\n{}\n<!-- /{name} -->{tail}", content.trim_end()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tables_go_between_their_marks() {
        let text = "a\n<!-- x -->\nold\n<!-- /x -->\nb\n";
        assert_eq!(between(text, "x", "new\n").as_deref(), Some("a\n<!-- x -->\nnew\n<!-- /x -->\nb\n"));
        assert_eq!(between(text, "y", "new"), None);
    }
}
