//! In: the active Rust toolchain. Out: a toolchain that has the standard library for wasm32 ([`Toolchain`]).
//!
//! With a working rustup this is only `rustup target add wasm32-unknown-unknown`.
//!
//! The rest is for machines on which rustup cannot reach its server, such as a closed build network. There,
//! on Debian, the library is built once (half a minute) from its source, which Debian packages together with
//! a compiler of exactly the same version. The result is installed where that compiler looks for it, and all
//! later wasm steps use that compiler, registered in rustup as the toolchain `debian`.
//!
//! The environment variable `XTASK_WASM_STD=debian` selects this second way directly, for testing.

use std::fmt;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};

use crate::debian;
use crate::run::{self, Result};

const TARGET: &str = "wasm32-unknown-unknown";

/// rustup's name for the compiler of the Debian packages.
const DEBIAN: &str = "debian";

/// A matching set: compiler, cargo, library source, clippy, and the linker of the LLVM version of the
/// compiler.
const PACKAGES: [&str; 5] = ["rustc-web", "cargo-web", "rust-web-src", "rust-web-clippy", LINKER];

/// Package and program. By default this compiler looks for `rust-lld`, which none of these packages contains.
const LINKER: &str = "lld-22";

/// A file next to the library that names the compiler for which it was built. After an update of the packages
/// it no longer matches.
const STAMP: &str = "built-by-gcode-playground.txt";

/// The toolchain that builds for wasm32.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Toolchain {
    /// The toolchain of all other steps.
    Active,
    /// Debian's, by its name in rustup.
    Debian,
}

impl fmt::Display for Toolchain {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Toolchain::Active => "the active Rust toolchain",
            Toolchain::Debian => "the Rust toolchain of Debian's packages",
        })
    }
}

impl Toolchain {
    /// Makes a command (`cargo`, `wasm-pack`, …) use this toolchain.
    pub fn apply(self, command: &mut Command) {
        match self {
            Toolchain::Active => {}
            Toolchain::Debian => {
                command.env("RUSTUP_TOOLCHAIN", DEBIAN);
                command.env("CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_LINKER", LINKER);
            }
        }
    }

    fn rustc(self) -> Command {
        let mut rustc = run::command("rustc");
        self.apply(&mut rustc);
        rustc
    }
}

/// Finds or installs a toolchain with the wasm32 standard library.
pub fn ensure() -> Result<Toolchain> {
    if env::var("XTASK_WASM_STD").is_ok_and(|way| way == DEBIAN) {
        return build_once();
    }
    if library_of(Toolchain::Active).is_some_and(|folder| has_std(&folder)) {
        return Ok(Toolchain::Active);
    }
    // If the second way was used before, rustup is not tried again.
    if debian_is_ready() {
        return Ok(Toolchain::Debian);
    }
    let mut add = run::command("rustup");
    let Err(rustup) =
        run::quiet("adding the wasm32 target to the Rust toolchain", add.args(["target", "add", TARGET]))
    else {
        return Ok(Toolchain::Active);
    };
    if !debian::available() {
        return Err(format!(
            "{rustup}\n\nThis Rust toolchain has no standard library for {TARGET}. Install it with\n\
             \n    rustup target add {TARGET}\n\n\
             (Rust from a Linux distribution has it as a package, such as libstd-rust-dev-wasm32 or \
             rust-std-static-{TARGET}), then start this command again."
        ));
    }
    run::say(format_args!("rustup could not add it: {}", first_error(&rustup)));
    build_once().map_err(|error| {
        format!(
            "{error}\n\nNeither `rustup target add {TARGET}` nor Debian's packages gave a standard library for \
             {TARGET}.\nMake one of them work, then start this command again."
        )
    })
}

fn build_once() -> Result<Toolchain> {
    if debian_is_ready() {
        return Ok(Toolchain::Debian);
    }
    if !debian::installed(&PACKAGES) {
        debian::install("installing Debian's Rust compiler with its library source", &PACKAGES)?;
    }
    let mut link = run::command("rustup");
    run::quiet("linking it as the toolchain `debian`", link.args(["toolchain", "link", DEBIAN, "/usr"]))?;
    let scratch = Scratch::new()?;
    let libraries = build(&scratch.0)?;
    let library = library_of(Toolchain::Debian).ok_or("Debian's rustc does not report its library folder")?;
    install(&libraries, &library, &scratch.0)?;
    Ok(Toolchain::Debian)
}

/// Builds std with an empty crate. Returns the `.rlib` files.
fn build(folder: &Path) -> Result<Vec<PathBuf>> {
    let failed = |error: std::io::Error| format!("cannot write to {}: {error}", folder.display());
    let manifest =
        "[package]\nname = \"empty\"\nedition = \"2021\"\n[lib]\npath = \"empty.rs\"\n[workspace]\n";
    fs::write(folder.join("Cargo.toml"), manifest).map_err(failed)?;
    fs::write(folder.join("empty.rs"), "").map_err(failed)?;
    let target_dir = folder.join("target");
    let mut cargo = run::command("cargo");
    Toolchain::Debian.apply(&mut cargo);
    cargo.current_dir(folder).env("CARGO_TARGET_DIR", &target_dir);
    // The source of the library may use features of the nightly compiler. With embedded bitcode, link-time
    // optimisation includes the library, as with the one from rustup.
    cargo.env("RUSTC_BOOTSTRAP", "1").env("RUSTFLAGS", "-Cembed-bitcode=yes");
    cargo.args(["build", "--release", "--target", TARGET, "-Z", "build-std=std,panic_abort,test"]);
    run::quiet("building the wasm32 standard library (once, half a minute)", &mut cargo)?;
    let deps = target_dir.join(TARGET).join("release").join("deps");
    let entries = fs::read_dir(&deps).map_err(|error| format!("cannot read {}: {error}", deps.display()))?;
    let is_library = |path: &PathBuf| {
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        name.ends_with(".rlib") && !name.starts_with("libempty-")
    };
    Ok(entries.filter_map(|entry| Some(entry.ok()?.path())).filter(is_library).collect())
}

/// Installs the libraries where the compiler looks for them. The stamp comes last, so that an incomplete
/// installation is not used.
fn install(libraries: &[PathBuf], folder: &Path, scratch: &Path) -> Result {
    let stamp = scratch.join(STAMP);
    let version = version().ok_or("Debian's rustc does not report its version")?;
    fs::write(&stamp, version).map_err(|error| format!("cannot write {}: {error}", stamp.display()))?;
    let rights = |program| debian::privileged(program).ok_or("no right to write to the toolchain's folder");
    if folder.exists() {
        run::quiet("removing an older one", rights("rm")?.arg("-r").arg(folder))?;
    }
    let mut install = rights("install")?;
    install.args(["-D", "--mode=644", "--target-directory"]).arg(folder).args(libraries).arg(&stamp);
    run::quiet("putting it where the compiler looks for it", &mut install)
}

fn debian_is_ready() -> bool {
    let stamp =
        || Some(fs::read_to_string(library_of(Toolchain::Debian)?.join(STAMP)).ok()?.trim().to_owned());
    stamp().is_some_and(|built_for| version().as_deref() == Some(&built_for))
}

fn version() -> Option<String> {
    run::ask(Toolchain::Debian.rustc().arg("-vV"))
}

fn library_of(toolchain: Toolchain) -> Option<PathBuf> {
    run::ask(toolchain.rustc().args(["--print", "target-libdir", "--target", TARGET])).map(PathBuf::from)
}

fn has_std(folder: &Path) -> bool {
    let is_std = |name: &str| name.starts_with("libstd-") && name.ends_with(".rlib");
    fs::read_dir(folder).is_ok_and(|mut entries| {
        entries.any(|entry| entry.is_ok_and(|e| is_std(&e.file_name().to_string_lossy())))
    })
}

fn first_error(text: &str) -> &str {
    text.lines().find(|line| line.starts_with("error")).unwrap_or("no reason given")
}

/// A folder that is removed on drop.
struct Scratch(PathBuf);

impl Scratch {
    fn new() -> Result<Self> {
        let folder = env::temp_dir().join(format!("gcode-playground-std-{}", std::process::id()));
        fs::create_dir_all(&folder).map_err(|error| format!("cannot make {}: {error}", folder.display()))?;
        Ok(Scratch(folder))
    }
}

impl Drop for Scratch {
    fn drop(&mut self) {
        // A failure is harmless: it is a temporary folder.
        let _ = fs::remove_dir_all(&self.0);
    }
}
