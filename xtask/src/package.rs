//! In: the core's sources and the page's. Out: the wasm package in www/pkg and the page in www/dist.
//!
//! The module is not built by wasm-pack: the crate is an `rlib` too, for the tests and the command line, and cargo
//! leaves link-time optimisation out of a library that is both. `cargo rustc` can ask for the one kind alone, which
//! makes the module a tenth smaller and faster.

use std::collections::hash_map::DefaultHasher;
use std::fs;
use std::hash::{Hash, Hasher};
use std::path::{Path, PathBuf};
use std::time::Duration;

use crate::run::{self, Result};
use crate::setup::Setup;

const NAME: &str = "gcode_playground";

/// The profile of Cargo.toml the module is built with.
const PROFILE: &str = "page";

/// What the module may be at most, compressed as a server does it, bytes. The aim is 180,000.
const MOST_COMPRESSED: u64 = 300_000;

/// What the compiler may use of WebAssembly, and how wasm-opt goes over it. A function with one caller stays a
/// function: merged into it, it compresses worse.
const WASM_OPT: [&str; 8] = [
    "--enable-bulk-memory",
    "--enable-nontrapping-float-to-int",
    "--enable-sign-ext",
    "--enable-mutable-globals",
    "--enable-reference-types",
    "--enable-multivalue",
    "--one-caller-inline-max-function-size=1",
    "-Oz",
];

/// Builds the wasm package. cargo decides whether the module has changed; wasm-bindgen and wasm-opt, which take longer
/// than all else, run only if it has.
pub fn wasm(setup: &Setup) -> Result<Duration> {
    let mut cargo = setup.command("cargo");
    cargo.args(["rustc", "--lib", "--crate-type", "cdylib", "--profile", PROFILE]);
    cargo.args(["--target", "wasm32-unknown-unknown"]);
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
    // Half a package is none.
    let _ = fs::remove_file(&stamp);
    let mut bindgen = setup.command("wasm-bindgen");
    bindgen.args(["--target", "web", "--out-name", NAME, "--out-dir"]).arg(&pkg).arg(module());
    let bound = run::step("building the wasm package", &mut bindgen)?;
    let mut wasm_opt = setup.command("wasm-opt");
    let shipped = pkg.join(format!("{NAME}_bg.wasm"));
    wasm_opt.args(WASM_OPT).arg(&shipped).arg("-o").arg(&shipped);
    let optimised = run::step("making the module small", &mut wasm_opt)?;
    write(&pkg.join("package.json"), PACKAGE)?;
    write(&pkg.join(".gitignore"), "*\n")?;
    if let Some(fingerprint) = fingerprint() {
        write(&stamp, &fingerprint)?;
    }
    Ok(compiled + bound + optimised)
}

/// Whether the module is as small as it should be; says how large it is.
pub fn size() -> Result<Duration> {
    let mut node = run::command("node");
    node.args(["-e", WEIGH]).arg(run::www().join("pkg").join(format!("{NAME}_bg.wasm")));
    node.arg(MOST_COMPRESSED.to_string());
    run::step("weighing the module", &mut node)
}

/// Builds the page into www/dist.
pub fn page(setup: &Setup) -> Result<Duration> {
    run::step("building the page", &mut setup.npm(&["run", "build"]))
}

/// So that Node takes the package's JavaScript for modules.
const PACKAGE: &str = r#"{ "name": "gcode-playground", "type": "module", "main": "gcode_playground.js", "types": "gcode_playground.d.ts" }
"#;

/// Prints the size of a file, plain and compressed, and fails where the latter is more than allowed.
const WEIGH: &str = "\
    const [file, most] = process.argv.slice(1);\
    const module = require('node:fs').readFileSync(file);\
    const small = require('node:zlib').gzipSync(module, { level: 9 }).length;\
    console.log(`wasm module: ${module.length} bytes, ${small} compressed (at most ${most})`);\
    process.exitCode = small > most ? 1 : 0;";

/// The module as the compiler leaves it.
fn module() -> PathBuf {
    run::target().join("wasm32-unknown-unknown").join(PROFILE).join(format!("{NAME}.wasm"))
}

/// What the package is made from: the compiled module, the settings of wasm-opt and the version of wasm-bindgen.
fn fingerprint() -> Option<String> {
    let mut hasher = DefaultHasher::new();
    for path in [module(), run::root().join("Cargo.lock")] {
        fs::read(path).ok()?.hash(&mut hasher);
    }
    WASM_OPT.hash(&mut hasher);
    Some(format!("{:016x}", hasher.finish()))
}

fn write(path: &Path, text: &str) -> Result {
    fs::write(path, text).map_err(|error| format!("cannot write {}: {error}", path.display()))
}
