//! In: the core's sources and the page's. Out: the wasm package in www/pkg and the page in www/dist; other
//! packages of wasm that are built in the same way.
//!
//! The module is not built by wasm-pack: the crate is an `rlib` too, for the tests and the command line, and
//! cargo leaves link-time optimisation out of a library that is both. `cargo rustc` can ask for the one kind
//! alone, which makes the module a tenth smaller and faster.

use std::collections::hash_map::DefaultHasher;
use std::fs;
use std::hash::{Hash, Hasher};
use std::path::{Path, PathBuf};
use std::time::Duration;

use crate::run::{self, Result};
use crate::setup::Setup;

/// What the module of the page may be at most, compressed as a server does it, bytes. The aim is 180,000 for
/// what reads programs; the part, its views and exports, the rules in three languages, what comments say of
/// tools, pasting and rewriting are in it too.
const MOST_COMPRESSED: u64 = 720_000;

/// What the compiler may use of WebAssembly.
const FEATURES: [&str; 6] = [
    "--enable-bulk-memory",
    "--enable-nontrapping-float-to-int",
    "--enable-sign-ext",
    "--enable-mutable-globals",
    "--enable-reference-types",
    "--enable-multivalue",
];

/// A crate that becomes a module for JavaScript.
pub struct Module<'a> {
    /// Its name, with underscores.
    pub name: &'a str,
    /// The folder of the crate.
    pub folder: PathBuf,
    /// The profile of its Cargo.toml it is built with.
    pub profile: &'a str,
    /// Its features, as passed to cargo.
    pub features: &'a [&'a str],
    /// The folder cargo builds in.
    pub target: PathBuf,
    /// Where the package goes.
    pub package: PathBuf,
    /// How wasm-opt goes over it.
    pub optimised: &'a [&'a str],
}

/// Builds the wasm package of the page.
pub fn wasm(setup: &Setup) -> Result<Duration> {
    let module = Module {
        name: "gcode_playground",
        folder: run::root(),
        profile: "page",
        features: &[],
        target: run::target(),
        package: run::www().join("pkg"),
        // A function with one caller stays a function: merged into it, it compresses worse.
        optimised: &["--one-caller-inline-max-function-size=1", "-Oz"],
    };
    module.build(setup)
}

impl Module<'_> {
    /// Builds the package. cargo decides whether the module has changed; wasm-bindgen and wasm-opt, which
    /// take longer than all else, run only if it has.
    pub fn build(&self, setup: &Setup) -> Result<Duration> {
        let mut cargo = setup.command("cargo");
        cargo.current_dir(&self.folder).env("CARGO_TARGET_DIR", &self.target);
        cargo.args(["rustc", "--lib", "--crate-type", "cdylib", "--profile", self.profile]);
        cargo.args(["--target", "wasm32-unknown-unknown"]).args(self.features);
        let compiled = run::step(&format!("compiling {} to wasm", self.name), &mut cargo)?;
        let stamp = self.package.join(".built-by-xtask");
        let shipped = self.package.join(format!("{}_bg.wasm", self.name));
        let built = || {
            let scripts = ["js", "d.ts"].map(|kind| self.package.join(format!("{}.{kind}", self.name)));
            let made = shipped.is_file() && scripts.iter().all(|script| script.is_file());
            made.then(|| fs::read_to_string(&stamp).ok())?
        };
        if self.fingerprint().is_some() && self.fingerprint() == built() {
            run::say(format_args!("the wasm package in {} is up to date", self.package.display()));
            return Ok(compiled);
        }
        // Half a package is none.
        let _ = fs::remove_file(&stamp);
        let mut bindgen = setup.command("wasm-bindgen");
        bindgen.args(["--target", "web", "--out-name", self.name, "--out-dir"]);
        bindgen.arg(&self.package).arg(self.compiled());
        let bound = run::step("building the wasm package", &mut bindgen)?;
        let mut wasm_opt = setup.command("wasm-opt");
        wasm_opt.args(FEATURES).args(self.optimised).arg(&shipped).arg("-o").arg(&shipped);
        let optimised = run::step("optimising the module", &mut wasm_opt)?;
        write(&self.package.join("package.json"), &self.manifest())?;
        write(&self.package.join(".gitignore"), "*\n")?;
        if let Some(fingerprint) = self.fingerprint() {
            write(&stamp, &fingerprint)?;
        }
        Ok(compiled + bound + optimised)
    }

    /// The module as the compiler leaves it.
    fn compiled(&self) -> PathBuf {
        let folder = self.target.join("wasm32-unknown-unknown").join(self.profile);
        folder.join(format!("{}.wasm", self.name))
    }

    /// What the package is made from: the compiled module, the settings of wasm-opt and
    /// the version of wasm-bindgen.
    fn fingerprint(&self) -> Option<String> {
        let mut hasher = DefaultHasher::new();
        for path in [self.compiled(), self.folder.join("Cargo.lock")] {
            fs::read(path).ok()?.hash(&mut hasher);
        }
        (FEATURES, self.optimised).hash(&mut hasher);
        Some(format!("{:016x}", hasher.finish()))
    }

    /// So that Node takes the package's JavaScript for modules.
    fn manifest(&self) -> String {
        let (file, name) = (self.name, self.name.replace('_', "-"));
        format!(r#"{{ "name": "{name}", "type": "module", "main": "{file}.js", "types": "{file}.d.ts" }}"#)
            + "\n"
    }
}

/// Whether the module is as small as it should be and as large as `tests/speed/README.md`
/// says; says how large it is.
pub fn size() -> Result<Duration> {
    let path = run::root().join("tests/speed/README.md");
    let text =
        fs::read_to_string(&path).map_err(|error| format!("cannot read {}: {error}", path.display()))?;
    let told =
        told_size(&text).ok_or("tests/speed/README.md has no line of a table that begins `| shipped: `")?;
    let mut node = run::command("node");
    node.args(["-e", WEIGH]).arg(run::www().join("pkg/gcode_playground_bg.wasm"));
    node.args([MOST_COMPRESSED.to_string(), (told * 1000).to_string()]);
    run::step("weighing the module", &mut node)
}

/// The size of the shipped module in the table of sizes, kB.
fn told_size(table: &str) -> Option<u64> {
    table.lines().find(|line| line.starts_with("| shipped: "))?.split('|').nth(2)?.trim().parse().ok()
}

/// Builds the page into www/dist, and next to it the rule pages and the reference.
pub fn page(setup: &Setup) -> Result<Duration> {
    let page = run::step("building the page", &mut setup.npm(&["run", "build"]))?;
    let mut rules = run::command("cargo");
    rules.args(["run", "--quiet", "--example", "rule-pages", "--"]).arg(run::www().join("dist/rules"));
    let rules = run::step("writing the pages of the rules", &mut rules)?;
    let mut docs = run::command("cargo");
    docs.args(["run", "--quiet", "--example", "docs", "--"]).arg(run::www().join("dist/docs"));
    Ok(page + rules + run::step("writing the reference", &mut docs)?)
}

/// Prints the size of a file, plain and compressed, and fails where the latter is more than allowed or
/// is not what the table says.
const WEIGH: &str = "\
    const [file, most, stated] = process.argv.slice(1);\
    const module = require('node:fs').readFileSync(file);\
    const small = require('node:zlib').gzipSync(module, { level: 9 }).length;\
    console.log(`wasm module: ${module.length} bytes, ${small} compressed (at most ${most})`);\
    const off = Math.abs(small / stated - 1) > 0.05;\
    if (off) console.log(`tests/speed/README.md says ${stated}: put the table right`);\
    process.exitCode = small > most || off ? 1 : 0;";

fn write(path: &Path, text: &str) -> Result {
    fs::write(path, text).map_err(|error| format!("cannot write {}: {error}", path.display()))
}
