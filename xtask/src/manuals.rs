//! Tests the recipes of `www/docs/manuals.md`: `tests/manuals/recipes.py` follows them with mdBook, Sphinx
//! and Docusaurus.
//!
//! In: the built command line; the built package, if there is one. Out: whether each recipe results in a page
//! with its example. The tools are installed once, in fixed versions, into the cache of the user.

use std::env;
use std::time::Duration;

use crate::run::{self, Result, command, step};
use crate::{native, packages, tools};

/// The Sphinx version of the test.
const SPHINX: &str = "sphinx==9.0.4";

/// The packages of a Docusaurus site.
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
    let program = native::command_line()?;
    let mdbook = tools::mdbook()?;
    let sphinx = packages::python(&format!("manuals/{}", SPHINX.replace("==", "-")), &[SPHINX])?;
    let site = packages::npm("manuals/site", &DOCUSAURUS)?;
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
