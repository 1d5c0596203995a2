//! Installs Python and npm packages for checks, once for each list of packages.
//!
//! In: names of Python and npm packages with their versions, and the name of a cache folder. Out: that folder
//! in the cache of the user, with the packages installed once. Does not know what the packages are for.

use std::fs;
use std::path::{Path, PathBuf};

use crate::run::{self, Result, command};
use crate::tools;

/// Installs Python packages into a virtual environment in the cache folder `name`, unless they are there.
/// Returns the folder of their executables, including `python`.
pub fn python(name: &str, packages: &[&str]) -> Result<PathBuf> {
    let folder = tools::cache()?.join(name);
    let bin = folder.join(if cfg!(windows) { "Scripts" } else { "bin" });
    let stamp = folder.join("installed");
    if !is_installed(&stamp, packages) {
        let mut python = command("python3");
        run::quiet(
            &format!("creating a virtual environment for {}", packages.join(", ")),
            python.args(["-m", "venv", "--clear"]).arg(&folder),
        )?;
        let mut pip = command(bin.join("pip"));
        run::quiet(
            &format!("installing {} (once)", packages.join(", ")),
            pip.args(["install", "--quiet"]).args(packages),
        )?;
        write(&stamp, &packages.join(" "))?;
    }
    Ok(bin)
}

/// Installs npm packages into `node_modules` of the cache folder `name`, unless they are there. Returns that
/// folder. Install scripts are not run.
pub fn npm(name: &str, packages: &[&str]) -> Result<PathBuf> {
    let folder = tools::cache()?.join(name);
    let stamp = folder.join("installed");
    if !is_installed(&stamp, packages) {
        fs::create_dir_all(&folder).map_err(|error| format!("cannot make {}: {error}", folder.display()))?;
        write(
            &folder.join("package.json"),
            "{\"name\": \"packages\", \"private\": true, \"version\": \"0.0.0\"}\n",
        )?;
        let mut npm = run::npm();
        npm.current_dir(&folder)
            .args(["install", "--no-audit", "--no-fund", "--ignore-scripts"])
            .args(packages);
        run::quiet(&format!("installing {} (once)", packages.join(", ")), &mut npm)?;
        write(&stamp, &packages.join(" "))?;
    }
    Ok(folder)
}

/// Whether the last installation was of these packages. An npm folder may also have packages of earlier
/// lists.
fn is_installed(stamp: &Path, packages: &[&str]) -> bool {
    fs::read_to_string(stamp).is_ok_and(|installed| installed == packages.join(" "))
}

fn write(path: &Path, text: &str) -> Result {
    fs::write(path, text).map_err(|error| format!("cannot write {}: {error}", path.display()))
}
