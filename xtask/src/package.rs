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
use std::time::{Duration, Instant};

use crate::run::{self, Result};
use crate::setup::Setup;
use crate::{embed, parts};

/// What has to be loaded before the first picture may be at most so many bytes, compressed as a server does it.
const MOST_OF_THE_CORE: u64 = 180_000;

/// The same of all parts together.
const MOST_OF_ALL: u64 = 720_000;

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
    /// Whether it is cut into what is loaded first and later parts.
    pub is_cut: bool,
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
        // A function with one caller stays a function: merged into it, it compresses worse. Functions of like
        // names have like code, and compress better side by side.
        optimised: &[
            "--one-caller-inline-max-function-size=1",
            "-Oz",
            "--converge",
            "--reorder-functions-by-name",
        ],
        is_cut: true,
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
        if self.is_cut {
            // What refers to what: the linker forgets it, unless it is asked to keep it.
            cargo.args(["--", "--cfg", "parts", "-C", "link-arg=--emit-relocs", "-C", "strip=none"]);
        }
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
        let _ = fs::remove_dir_all(&self.package);
        self.remove_modules();
        let cut = self.is_cut.then(|| parts::cut(setup, &self.compiled(), self.name)).transpose()?;
        let mut bindgen = setup.command("wasm-bindgen");
        bindgen.args(["--target", "web", "--out-name", self.name, "--out-dir"]);
        bindgen.arg(&self.package).arg(cut.as_ref().map_or(self.compiled(), |cut| cut.main.clone()));
        // The parts bring functions into the table of the module.
        bindgen.args(cut.iter().map(|_| "--keep-lld-exports"));
        let bound = run::step("building the wasm package", &mut bindgen)?;
        let begun = Instant::now();
        let optimise = |from: &Path, to: &Path| {
            let mut wasm_opt = setup.command("wasm-opt");
            wasm_opt.args(FEATURES).args(self.optimised).arg(from).arg("-o").arg(to);
            run::quiet(&format!("optimising {}", to.display()), &mut wasm_opt)
        };
        optimise(&shipped, &shipped)?;
        if let Some(cut) = &cut {
            cut.files.iter().try_for_each(|(from, name)| optimise(from, &self.package.join(name)))?;
            cut.scripts().iter().try_for_each(|(name, text)| write(&self.package.join(name), text))?;
        }
        let optimised = begun.elapsed();
        write(&self.package.join("package.json"), &self.manifest())?;
        write(&self.package.join(".gitignore"), "*\n")?;
        if let Some(fingerprint) = self.fingerprint() {
            write(&stamp, &fingerprint)?;
        }
        Ok(compiled + bound + optimised)
    }

    /// Removes the modules of an older package: its parts may have had other names.
    fn remove_modules(&self) {
        let files = fs::read_dir(&self.package).into_iter().flatten().flatten().map(|entry| entry.path());
        for file in files.filter(|file| file.extension().is_some_and(|kind| kind == "wasm")) {
            // One that stays is found when the files are weighed.
            let _ = fs::remove_file(file);
        }
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
        let scripts = [include_str!("parts.js"), include_str!("part-files.js"), include_str!("parts.rs")];
        (FEATURES, self.optimised, self.is_cut, scripts).hash(&mut hasher);
        Some(format!("{:016x}", hasher.finish()))
    }

    /// So that Node takes the package's JavaScript for modules.
    fn manifest(&self) -> String {
        let (file, name) = (self.name, self.name.replace('_', "-"));
        format!(r#"{{ "name": "{name}", "type": "module", "main": "{file}.js", "types": "{file}.d.ts" }}"#)
            + "\n"
    }
}

/// Whether the module and its parts are as small as they should be and as large as the table of sizes in
/// `tests/speed/README.md` says; prints them.
pub fn size() -> Result<Duration> {
    let path = run::root().join("tests/speed/README.md");
    let text =
        fs::read_to_string(&path).map_err(|error| format!("cannot read {}: {error}", path.display()))?;
    let mut node = run::command("node");
    node.args(["-e", WEIGH]).arg(run::www().join("pkg"));
    node.args([MOST_OF_THE_CORE.to_string(), MOST_OF_ALL.to_string()]).args(stated_sizes(&text));
    run::step("weighing the module", &mut node)
}

/// The rows of the table of sizes: `core.wasm=180`, name of the file and kB.
fn stated_sizes(document: &str) -> Vec<String> {
    let rows = document.lines().filter_map(|line| {
        let mut cells = line.strip_prefix("| `")?.split('|').map(str::trim);
        let name = cells.next()?.strip_suffix(".wasm`")?;
        Some(format!("{name}.wasm={}", cells.next()?))
    });
    rows.collect()
}

/// Builds the whole static site into www/dist.
pub fn site(setup: &Setup) -> Result {
    wasm(setup)?;
    page(setup)?;
    run::say(format_args!("the site is in {}", run::www().join("dist").display()));
    Ok(())
}

/// Builds the page into www/dist, and next to it the rule pages, the reference and the element for other pages.
pub fn page(setup: &Setup) -> Result<Duration> {
    let page = run::step("building the page", &mut setup.npm(&["run", "build"]))?;
    let mut rules = run::command("cargo");
    rules.args(["run", "--quiet", "--example", "rule-pages", "--"]).arg(run::www().join("dist/rules"));
    let rules = run::step("writing the pages of the rules", &mut rules)?;
    let mut docs = run::command("cargo");
    docs.args(["run", "--quiet", "--example", "docs", "--"]).arg(run::www().join("dist/docs"));
    let docs = run::step("writing the reference", &mut docs)?;
    Ok(page + rules + docs + embed::element(setup)?)
}

/// Prints the size of each file, plain and compressed as a server does it, and fails where one is not as the
/// table says, or the first of them, or all, are more than allowed.
const WEIGH: &str = "\
    const [folder, mostOfTheCore, mostOfAll, ...stated] = process.argv.slice(1);\
    const { readFileSync, readdirSync } = require('node:fs');\
    const rows = new Map(stated.map((row) => row.split('=')));\
    const names = { 'gcode_playground_bg.wasm': 'core.wasm' };\
    const files = readdirSync(folder).filter((file) => file.endsWith('.wasm'));\
    const problems = [];\
    let all = 0;\
    const sizes = new Map();\
    for (const file of files) {\
      const name = file.includes('-') ? 'shared.wasm' : (names[file] ?? file);\
      const bytes = readFileSync(`${folder}/${file}`);\
      const small = require('node:zlib').gzipSync(bytes, { level: 9 }).length;\
      console.log(`${file}: ${bytes.length} bytes, ${small} compressed`);\
      all += small;\
      sizes.set(name, (sizes.get(name) ?? 0) + small);\
    }\
    for (const [name, small] of sizes) {\
      const kB = Number(rows.get(name));\
      if (!(Math.abs(small / 1000 - kB) <= Math.max(2, 0.03 * kB))) problems.push(`${name} is ${small}, not as tests/speed/README.md says: ${rows.get(name)}`);\
      if (name === 'core.wasm' && small > mostOfTheCore) problems.push(`${name} is larger than ${mostOfTheCore}`);\
      rows.delete(name);\
    }\
    for (const name of rows.keys()) problems.push(`tests/speed/README.md names ${name}, which is not there`);\
    console.log(`all: ${all} compressed (at most ${mostOfAll})`);\
    if (all > mostOfAll) problems.push(`all parts are larger than ${mostOfAll}`);\
    for (const problem of problems) console.error(problem);\
    process.exitCode = problems.length > 0 ? 1 : 0;";

fn write(path: &Path, text: &str) -> Result {
    fs::write(path, text).map_err(|error| format!("cannot write {}: {error}", path.display()))
}
