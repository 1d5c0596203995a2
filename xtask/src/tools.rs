//! In: Cargo.lock. Out: the folders of wasm-pack and of wasm-bindgen's command line in the right versions,
//! for PATH. If the versions on PATH do not fit, they are built once with `cargo install` into a cache folder
//! of the user, keyed by version, so that every clone of the repository finds them.

use std::path::{Path, PathBuf};
use std::{env, fs};

use crate::run::{self, Result};

/// The features of WebAssembly that the compiler uses, as options of wasm-opt.
pub const WASM_FEATURES: [&str; 6] = [
    "--enable-bulk-memory",
    "--enable-nontrapping-float-to-int",
    "--enable-sign-ext",
    "--enable-mutable-globals",
    "--enable-reference-types",
    "--enable-multivalue",
];

/// The version to install if none is suitable.
const WASM_PACK: &str = "0.15.1";

/// The mdBook version of the test.
const MDBOOK: &str = "0.5.4";

/// The version of cargo-deny, which checks licences and advisories.
const CARGO_DENY: &str = "0.20.2";

/// The version of wasm-split. xtask parses the script that it generates.
const WASM_SPLIT: &str = "0.2.4";

/// The minimum version of wasm-pack.
const WASM_PACK_MIN: (u32, u32) = (0, 13);

/// The folder of wasm-pack; `None` if the one on PATH is suitable.
pub fn wasm_pack() -> Result<Option<PathBuf>> {
    let fits = |version: &str| major_minor(version).is_some_and(|version| version >= WASM_PACK_MIN);
    if version_on_path("wasm-pack").is_some_and(|version| fits(&version)) {
        return Ok(None);
    }
    cargo_install("wasm-pack", WASM_PACK, &["wasm-pack"]).map(Some)
}

/// The folder of wasm-bindgen and wasm-bindgen-test-runner; `None` if those on PATH are suitable. Their
/// version must equal that of the crate in Cargo.lock: they share a private format.
pub fn wasm_bindgen() -> Result<Option<PathBuf>> {
    let lock = run::root().join("Cargo.lock");
    let text =
        fs::read_to_string(&lock).map_err(|error| format!("cannot read {}: {error}", lock.display()))?;
    let wanted = locked_version(&text, "wasm-bindgen").ok_or("Cargo.lock names no wasm-bindgen")?;
    let tools = ["wasm-bindgen", "wasm-bindgen-test-runner"];
    if tools.iter().all(|tool| version_on_path(tool).as_deref() == Some(wanted)) {
        return Ok(None);
    }
    cargo_install("wasm-bindgen-cli", wanted, &tools).map(Some)
}

/// The folder for downloads and builds shared by all clones: `gcode-playground` in the cache of the user.
pub fn cache() -> Result<PathBuf> {
    let folder = |name: &str| env::var_os(name).filter(|value| !value.is_empty()).map(PathBuf::from);
    let home = || folder(if cfg!(windows) { "USERPROFILE" } else { "HOME" });
    let base = if cfg!(windows) {
        folder("LOCALAPPDATA").or_else(|| Some(home()?.join("AppData").join("Local")))
    } else if cfg!(target_os = "macos") {
        home().map(|home| home.join("Library").join("Caches"))
    } else {
        folder("XDG_CACHE_HOME").filter(|path| path.is_absolute()).or_else(|| Some(home()?.join(".cache")))
    };
    base.map(|base| base.join("gcode-playground")).ok_or_else(|| "this user has no home folder".to_owned())
}

/// The folder of wasm-split, which splits the module of the page into its parts.
pub fn wasm_split() -> Result<PathBuf> {
    cargo_install("wasm_split_cli_support", WASM_SPLIT, &["wasm-split-cli"])
}

/// The folder of mdBook.
pub fn mdbook() -> Result<PathBuf> {
    cargo_install("mdbook", MDBOOK, &["mdbook"])
}

/// The folder of cargo-deny.
pub fn cargo_deny() -> Result<PathBuf> {
    cargo_install("cargo-deny", CARGO_DENY, &["cargo-deny"])
}

fn cargo_install(package: &str, version: &str, programs: &[&str]) -> Result<PathBuf> {
    let prefix = cache()?.join("tools").join(format!("{package}-{version}"));
    let bin = prefix.join("bin");
    if programs.iter().all(|program| bin.join(format!("{program}{}", env::consts::EXE_SUFFIX)).is_file()) {
        return Ok(bin);
    }
    fs::create_dir_all(&prefix).map_err(|error| format!("cannot make {}: {error}", prefix.display()))?;
    let mut cargo = run::command("cargo");
    cargo.args(["install", package, "--version", &format!("={version}"), "--force", "--root"]).arg(&prefix);
    if package == "wasm_split_cli_support" {
        cargo.args(["--features", "build-binary"]);
    }
    if package == "cargo-deny" {
        // Its authors recommend the locked versions.
        cargo.arg("--locked");
    }
    if package == "mdbook" {
        // It only builds books here: no server, no search.
        cargo.arg("--no-default-features");
    }
    // An unoptimised build takes less than half the time, and is fast enough here.
    cargo.env("CARGO_PROFILE_RELEASE_OPT_LEVEL", "0").env("CARGO_PROFILE_RELEASE_LTO", "off");
    // Outside of the repository and without its settings.
    cargo.current_dir(&prefix);
    for name in ["CARGO_TARGET_DIR", "CARGO_BUILD_TARGET", "RUSTFLAGS", "CARGO_ENCODED_RUSTFLAGS"] {
        cargo.env_remove(name);
    }
    run::quiet(&format!("installing {package} {version} (once, some minutes)"), &mut cargo)?;
    Ok(bin)
}

/// The last word of the first line of `program --version`.
fn version_on_path(program: &str) -> Option<String> {
    let line = run::ask(run::command(program).arg("--version"))?;
    Some(line.lines().next()?.split_whitespace().next_back()?.to_owned())
}

fn major_minor(version: &str) -> Option<(u32, u32)> {
    let mut parts = version.split('.').map(|part| part.parse().ok());
    Some((parts.next()??, parts.next()??))
}

/// The version of a package in the text of a Cargo.lock.
pub fn locked_version<'lock>(lock: &'lock str, package: &str) -> Option<&'lock str> {
    let name = format!("name = \"{package}\"");
    let mut lines = lock.lines().skip_while(|line| *line != name);
    let version = lines.nth(1)?;
    version.strip_prefix("version = \"")?.strip_suffix('"')
}

/// Whether the `.bin` folder of npm packages contains a program, under its name on this system.
pub fn in_node_bin(bin: &Path, program: &str) -> bool {
    bin.join(if cfg!(windows) { format!("{program}.cmd") } else { program.to_owned() }).is_file()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_version_is_that_of_the_package_of_this_very_name() {
        let lock = "[[package]]\nname = \"wasm-bindgen-futures\"\nversion = \"0.4.1\"\n\n\
                    [[package]]\nname = \"wasm-bindgen\"\nversion = \"0.2.99\"\nsource = \"x\"\n";
        assert_eq!(locked_version(lock, "wasm-bindgen"), Some("0.2.99"));
        assert_eq!(locked_version(lock, "wasm"), None);
    }

    #[test]
    fn versions_compare_as_numbers() {
        assert!(major_minor("0.13.0") >= Some(WASM_PACK_MIN));
        assert!(major_minor("0.9.1") < Some(WASM_PACK_MIN));
        assert!(major_minor("1.0") > Some(WASM_PACK_MIN));
        assert_eq!(major_minor("none"), None);
    }
}
