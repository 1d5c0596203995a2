//! The recipes of `www/docs/manuals.md`, followed by `tests/manuals/recipes.py` with mdBook, Sphinx and Docusaurus.
//!
//! In: the built command line; the built package, if there is one. Out: whether each recipe ends in a page with its
//! example. The tools are installed once, in fixed versions, into the cache of the user.

use std::path::{Path, PathBuf};
use std::time::Duration;
use std::{env, fs};

use crate::run::{self, Result, command, step};
use crate::tools;

/// The Sphinx that the recipe is tried with.
const SPHINX: &str = "sphinx==9.0.4";

/// The packages of a site of Docusaurus.
const DOCUSAURUS: [&str; 5] = [
    "@docusaurus/core@3.10.2",
    "@docusaurus/preset-classic@3.10.2",
    "@mdx-js/react@3.1.1",
    "react@19.2.0",
    "react-dom@19.2.0",
];

/// `cargo xtask manuals`.
pub fn main() -> Result {
    recipes().map(|_| ())
}

/// Follows all recipes.
pub fn recipes() -> Result<Duration> {
    step("the command line", command("cargo").args(["build", "--bin", "gcode-playground"]))?;
    let program = run::target().join("debug").join(format!("gcode-playground{}", env::consts::EXE_SUFFIX));
    let (mdbook, sphinx, site) = (tools::mdbook()?, sphinx()?, site()?);
    let folder = site.parent().unwrap_or(&site).to_path_buf();
    let path = env::var_os("PATH").unwrap_or_default();
    let folders = [mdbook, sphinx].into_iter().chain(env::split_paths(&path));
    let path = env::join_paths(folders).map_err(|error| error.to_string())?;
    let package = run::www().join("dist/embed").join(env!("CARGO_PKG_VERSION"));
    let mut recipes = command("python3");
    recipes.arg("tests/manuals/recipes.py").args([&program, &package, &folder]);
    recipes.args(["html", "mdbook", "sphinx", "docusaurus"]).env("PATH", path);
    step("recipes for manuals", &mut recipes)
}

/// The folder of `sphinx-build`.
fn sphinx() -> Result<PathBuf> {
    let folder = tools::cache()?.join("manuals").join(SPHINX.replace("==", "-"));
    let bin = folder.join(if cfg!(windows) { "Scripts" } else { "bin" });
    if !bin.join(format!("sphinx-build{}", env::consts::EXE_SUFFIX)).is_file() {
        let mut python = command("python3");
        run::quiet("making a place for Sphinx", python.args(["-m", "venv"]).arg(&folder))?;
        let mut pip = command(bin.join("pip"));
        run::quiet("installing Sphinx (once)", pip.args(["install", "--quiet", SPHINX]))?;
    }
    Ok(bin)
}

/// The folder of a site that has the packages of Docusaurus.
fn site() -> Result<PathBuf> {
    let site = tools::cache()?.join("manuals").join("site");
    let wanted = DOCUSAURUS.join(" ");
    let stamp = site.join("installed");
    if fs::read_to_string(&stamp).is_ok_and(|installed| installed == wanted) {
        return Ok(site);
    }
    let failed = |path: &Path| format!("cannot write {}", path.display());
    fs::create_dir_all(&site).map_err(|error| format!("{}: {error}", failed(&site)))?;
    let package = site.join("package.json");
    fs::write(&package, "{\"name\": \"site\", \"private\": true, \"version\": \"0.0.0\"}\n")
        .map_err(|error| format!("{}: {error}", failed(&package)))?;
    let mut npm = run::npm();
    npm.current_dir(&site).args(["install", "--no-audit", "--no-fund", "--ignore-scripts"]).args(DOCUSAURUS);
    run::quiet("installing Docusaurus (once, some minutes)", &mut npm)?;
    fs::write(&stamp, wanted).map_err(|error| format!("{}: {error}", failed(&stamp)))?;
    Ok(site)
}
