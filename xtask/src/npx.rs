//! In: the sources of the command line. Out: the same program as a module for Node, in `target/npx`, which
//! the npm package contains in `bin`; and whether its output equals that of the native program, byte for
//! byte.

use std::fs;
use std::path::PathBuf;
use std::time::{Duration, Instant};

use crate::bindgen::{self, For};
use crate::embed::copy_folder;
use crate::native;
use crate::run::{self, Result, step};
use crate::setup::Setup;
use crate::tools::WASM_FEATURES;

/// The profile in Cargo.toml: the same as for the page, with a separate folder.
const PROFILE: &str = "node";

/// The output folder of the module.
fn folder() -> PathBuf {
    run::target().join("npx")
}

/// Builds the module.
pub fn module(setup: &Setup) -> Result<Duration> {
    let mut cargo = setup.command("cargo");
    cargo.args(["rustc", "--bin", "gcode-playground", "--features", "npx", "--profile", PROFILE]);
    cargo.args(["--target", "wasm32-unknown-unknown"]);
    let compiled = step("compiling the command line to wasm", &mut cargo)?;
    let _ = fs::remove_dir_all(folder());
    let module = run::target().join("wasm32-unknown-unknown").join(PROFILE).join("gcode-playground.wasm");
    let bound = bindgen::package(&module, "command-line", &folder(), For::Node)?;
    let begun = Instant::now();
    let module = folder().join("command-line_bg.wasm");
    let mut wasm_opt = setup.command("wasm-opt");
    wasm_opt.args(WASM_FEATURES).arg("-O2").arg(&module).arg("-o").arg(&module);
    run::quiet("optimising the command line for Node", &mut wasm_opt)?;
    // The npm package has its own `package.json`.
    let _ = fs::remove_file(folder().join("package.json"));
    let starts = folder().join("gcode-playground.js");
    fs::write(&starts, "#!/usr/bin/env node\nimport './command-line.js';\n")
        .map_err(|error| format!("cannot write {}: {error}", starts.display()))?;
    executable(&starts)?;
    Ok(compiled + bound + begun.elapsed())
}

/// Copies the built module into the built package.
pub fn put_into_package() -> Result {
    let bin = run::www().join("dist/embed/bin");
    let _ = fs::remove_dir_all(&bin);
    copy_folder(&folder(), &bin)
}

#[cfg(unix)]
fn executable(file: &std::path::Path) -> Result {
    use std::os::unix::fs::PermissionsExt;
    let permissions = fs::Permissions::from_mode(0o755);
    fs::set_permissions(file, permissions)
        .map_err(|error| format!("cannot change {}: {error}", file.display()))
}

#[cfg(not(unix))]
fn executable(_: &std::path::Path) -> Result {
    Ok(())
}

/// Compares the output of the package with that of the native program.
pub fn compare(setup: &Setup) -> Result<Duration> {
    let begun = Instant::now();
    let scratch = run::target().join("npx-installed");
    let _ = fs::remove_dir_all(&scratch);
    fs::create_dir_all(&scratch).map_err(|error| format!("cannot make {}: {error}", scratch.display()))?;
    let mut pack = setup.npm(&["pack", "./dist/embed", "--silent", "--pack-destination"]);
    step("packing the npm package", pack.arg(&scratch))?;
    let package = scratch.join(format!("gcode-playground-{}.tgz", env!("CARGO_PKG_VERSION")));
    let mut install = setup.npm(&["install", "--silent", "--no-audit", "--no-fund", "--prefix"]);
    step("installing it", install.arg(&scratch).arg(&package))?;
    // The example expects it in its own folder, and starts it.
    native::command_line()?;
    let mut compare = native::example("npx")?;
    compare.arg(scratch.join("node_modules/.bin/gcode-playground"));
    step("the command line under Node beside the native one", &mut compare)?;
    Ok(begun.elapsed())
}
