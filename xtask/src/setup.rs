//! In: a machine with Rust and Node. Out: a machine on which everything can be built and tested ([`Setup`]).
//! Existing tools are only checked; missing ones are installed, with a message.

use std::ffi::{OsStr, OsString};
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};

use crate::run::{self, Result, cannot};
use crate::wasm_std::{self, Toolchain};
use crate::{browser, engines, spelling, tools};

/// The minimum version of Node.js for the tools of the page.
const NODE_MIN: u32 = 20;

/// The paths of the tools.
pub struct Setup {
    /// The toolchain for wasm32.
    pub toolchain: Toolchain,
    path: OsString,
}

impl Setup {
    /// Installs what is needed to develop the page.
    pub fn for_playing() -> Result<Self> {
        Self::for_playing_while(|_| Ok(()))
    }

    /// As [`Self::for_playing`]. `task` needs only the toolchain, and runs while npm installs its packages.
    pub fn for_playing_while(task: impl FnOnce(Toolchain) -> Result) -> Result<Self> {
        node()?;
        let (packages, toolchain) = run::both(npm_packages, || {
            let toolchain = wasm_std::ensure()?;
            task(toolchain).map(|()| toolchain)
        })?;
        let path = before([packages], &env::var_os("PATH").unwrap_or_default())?;
        Ok(Setup { toolchain, path })
    }

    /// Installs what is needed to build the site.
    pub fn for_building() -> Result<Self> {
        let (wasm_split, setup) = run::both(tools::wasm_split, Setup::for_playing)?;
        let Setup { toolchain, path } = setup;
        Ok(Setup { toolchain, path: before([wasm_split], &path)? })
    }

    /// Additionally installs what the tests need: the runner of the tests under Node.
    pub fn for_testing() -> Result<Self> {
        let (wasm_bindgen, setup) = run::both(tools::wasm_bindgen, Setup::for_building)?;
        let Setup { toolchain, path } = setup;
        Ok(Setup { toolchain, path: before(wasm_bindgen, &path)? })
    }

    /// Additionally installs what the packages for other projects need: wasm-pack, whose build takes longer
    /// than that of all other tools.
    pub fn for_packages() -> Result<Self> {
        let (wasm_pack, setup) = run::both(tools::wasm_pack, Setup::for_testing)?;
        let Setup { toolchain, path } = setup;
        Ok(Setup { toolchain, path: before(wasm_pack, &path)? })
    }

    /// A program that builds for wasm32 and finds all tools. It starts in the root of the repository.
    pub fn command(&self, program: &str) -> Command {
        let mut command = run::command(program);
        command.env("PATH", &self.path);
        self.toolchain.apply(&mut command);
        command
    }

    /// npm in the folder of the page.
    pub fn npm(&self, arguments: &[&str]) -> Command {
        let mut npm = run::npm();
        npm.env("PATH", &self.path).args(arguments);
        npm
    }
}

/// The folders, followed by the folders of a PATH.
fn before(folders: impl IntoIterator<Item = PathBuf>, path: &OsStr) -> Result<OsString> {
    env::join_paths(folders.into_iter().chain(env::split_paths(path)))
        .map_err(|error| format!("cannot extend PATH: {error}"))
}

/// `cargo xtask setup`: everything, including the browsers and hunspell for the tests.
pub fn main() -> Result {
    spelling::ensure()?;
    let setup = Setup::for_packages()?;
    let browser = browser::for_tests()?;
    let engines = engines::ensure()?;
    run::say(format_args!("wasm32 is built by: {}", setup.toolchain));
    run::say(format_args!("the browser tests use: {}", browser.display()));
    engines::tell(&engines);
    run::say("all is set up");
    Ok(())
}

/// Installs the npm packages of the page. Returns the folder of their programs.
fn npm_packages() -> Result<PathBuf> {
    let bin = npm_ci(&run::www(), "the page's npm packages", &[])?;
    // Without wasm-opt the module would not be optimised for size.
    if tools::in_node_bin(&bin, "wasm-opt") {
        Ok(bin)
    } else {
        Err("the npm package `binaryen`, which brings wasm-opt, is missing from www/package.json".to_owned())
    }
}

/// Installs the npm packages of a folder, unless the versions of its current package-lock.json are installed.
/// Returns the folder of their programs.
pub fn npm_ci(folder: &Path, what: &str, options: &[&str]) -> Result<PathBuf> {
    let read = |name: &str| {
        let path = folder.join(name);
        fs::read_to_string(&path).map_err(|error| cannot("read", &path, &error))
    };
    let wanted = read("package.json")? + &read("package-lock.json")?;
    let stamp = folder.join("node_modules").join(".installed-by-xtask");
    if !fs::read_to_string(&stamp).is_ok_and(|installed| installed == wanted) {
        let mut npm = run::npm();
        npm.current_dir(folder).args(["ci", "--no-audit", "--no-fund"]).args(options);
        run::quiet(&format!("installing {what}"), &mut npm)?;
        fs::write(&stamp, wanted).map_err(|error| cannot("write", &stamp, &error))?;
    }
    Ok(folder.join("node_modules").join(".bin"))
}

fn node() -> Result {
    let version = run::ask(run::command("node").arg("--version")).unwrap_or_default();
    let major = version.trim_start_matches('v').split('.').next().and_then(|part| part.parse::<u32>().ok());
    match major {
        Some(major) if major >= NODE_MIN => Ok(()),
        Some(_) => {
            Err(format!("Node.js {NODE_MIN} or newer is needed; this is {version}: see https://nodejs.org"))
        }
        None => Err(format!("Node.js {NODE_MIN} or newer is needed, with npm: see https://nodejs.org")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(name: &str) -> String {
        fs::read_to_string(run::root().join(name)).expect(name)
    }

    #[test]
    fn the_container_has_all_that_the_tests_look_for() {
        let dockerfile = read(".devcontainer/Dockerfile");
        assert!(read(".devcontainer/devcontainer.json").contains(r#""dockerfile": "Dockerfile""#));
        let words: Vec<&str> = dockerfile.split_whitespace().collect();
        for package in engines::packages().chain(spelling::PACKAGES).chain([browser::HEADLESS_SHELL]) {
            assert!(words.contains(&package), "{package}");
        }
        let image = dockerfile.lines().find_map(|line| line.strip_prefix("FROM ")).expect("an image");
        for workflow in ["test", "nightly", "release"] {
            let text = read(&format!(".github/workflows/{workflow}.yml"));
            // On Ubuntu no browser is installed for the tests.
            let containers = text.matches(&format!("    container: {image}\n")).count();
            assert_eq!(
                containers,
                text.matches("cargo xtask test").count() - usize::from(workflow == "test"),
                "{workflow}"
            );
        }
    }
}
