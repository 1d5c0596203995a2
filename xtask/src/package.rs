//! In: the core's sources and the page's. Out: the wasm package in www/pkg and the page in www/dist.

use std::collections::hash_map::DefaultHasher;
use std::env;
use std::fs;
use std::hash::{Hash, Hasher};
use std::path::PathBuf;
use std::time::Duration;

use crate::run::{self, Result};
use crate::setup::Setup;

const NAME: &str = "gcode_playground";

/// Builds the wasm package. cargo decides whether the module has changed; wasm-bindgen and wasm-opt, which take longer
/// than all else, run only if it has.
pub fn wasm(setup: &Setup) -> Result<Duration> {
    let mut cargo = setup.command("cargo");
    // The very command wasm-pack gives, so that it finds the work done.
    cargo.args(["build", "--lib", "--release", "--target", "wasm32-unknown-unknown"]);
    let compiled = run::step("compiling the core to wasm", &mut cargo)?;
    let pkg = run::www().join("pkg");
    let stamp = pkg.join(".built-by-xtask");
    let built = || {
        let made = [format!("{NAME}_bg.wasm"), format!("{NAME}.js"), format!("{NAME}.d.ts")];
        made.iter().all(|name| pkg.join(name).is_file()).then(|| fs::read_to_string(&stamp).ok())?
    };
    if fingerprint().is_some() && fingerprint() == built() {
        run::say("the wasm package in www/pkg is up to date");
        return Ok(compiled);
    }
    let mut wasm_pack = setup.command("wasm-pack");
    wasm_pack.args(["build", "--release", "--target", "web", "--mode", "no-install"]);
    wasm_pack.args(["--out-dir", "www/pkg", "--out-name", NAME]);
    let packed = run::step("building the wasm package", &mut wasm_pack)?;
    if let Some(fingerprint) = fingerprint() {
        fs::write(&stamp, fingerprint)
            .map_err(|error| format!("cannot write {}: {error}", stamp.display()))?;
    }
    Ok(compiled + packed)
}

/// Builds the page into www/dist.
pub fn page(setup: &Setup) -> Result<Duration> {
    run::step("building the page", &mut setup.npm(&["run", "build"]))
}

/// What the package is made from: the compiled module, the settings of wasm-opt and the version of wasm-bindgen.
fn fingerprint() -> Option<String> {
    let target = env::var_os("CARGO_TARGET_DIR").map_or_else(|| PathBuf::from("target"), PathBuf::from);
    let module =
        run::root().join(target).join("wasm32-unknown-unknown").join("release").join(format!("{NAME}.wasm"));
    let mut hasher = DefaultHasher::new();
    for path in [module, run::root().join("Cargo.toml"), run::root().join("Cargo.lock")] {
        fs::read(path).ok()?.hash(&mut hasher);
    }
    Some(format!("{:016x}", hasher.finish()))
}
