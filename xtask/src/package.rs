//! In: the sources of the core and of the page. Out: the wasm package in www/pkg and the page in www/dist;
//! other wasm packages that are built in the same way.
//!
//! The module is not built by wasm-pack: the crate is also an `rlib`, for the tests and the command line, and
//! cargo skips link-time optimisation for a library that is both. `cargo rustc` can build only the `cdylib`,
//! which makes the module a tenth smaller and faster.

use std::cmp::Reverse;
use std::collections::BTreeMap;
use std::collections::hash_map::DefaultHasher;
use std::fs;
use std::hash::{Hash, Hasher};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use flate2::Compression;
use flate2::write::GzEncoder;

use crate::bindgen::{self, For};
use crate::run::{self, Result};
use crate::setup::Setup;
use crate::tools::WASM_FEATURES;
use crate::{embed, native, npx, parts};

/// Budget of the module before the first picture: bytes, compressed as by a server.
const CORE: Budget = Budget { name: "core.wasm", bytes: 165_000 };

/// Budget of all parts and texts together.
const ALL: Budget = Budget { name: "all parts", bytes: 1_200_000 };

/// A size budget.
pub struct Budget {
    /// The thing measured.
    pub name: &'static str,
    /// Its budget in bytes.
    pub bytes: u64,
}

impl Budget {
    /// Prints the size, with a warning from 95 % of the budget on. Returns an error above 105 %.
    pub fn check(&self, size: u64) -> Result {
        let Self { name, bytes } = self;
        let text = format!("{name}: {size} bytes compressed, of {bytes}");
        if size * 20 > bytes * 21 {
            return Err(text + ": too large");
        }
        let warning = if size * 20 >= bytes * 19 { ": nearly all of it" } else { "" };
        run::say(text + warning);
        Ok(())
    }
}

/// Size of a file after compression by a server (`gzip -9`).
pub fn compressed_size(bytes: &[u8]) -> io::Result<u64> {
    let mut compressed = GzEncoder::new(Vec::new(), Compression::best());
    compressed.write_all(bytes)?;
    Ok(compressed.finish()?.len() as u64)
}

/// The file of a package that records its fingerprint.
pub const STAMP: &str = ".built-by-xtask";

/// A crate that is compiled to a module for JavaScript.
pub struct Module<'a> {
    /// Its name, with underscores.
    pub name: &'a str,
    /// The folder of the crate.
    pub folder: PathBuf,
    /// Its profile in Cargo.toml.
    pub profile: &'a str,
    /// Its features, as passed to cargo.
    pub features: &'a [&'a str],
    /// The target folder of cargo.
    pub target: PathBuf,
    /// The folder of the package.
    pub package: PathBuf,
    /// The options of wasm-opt.
    pub optimised: &'a [&'a str],
    /// Whether it is split into the core and later parts.
    pub is_cut: bool,
}

/// Builds the wasm package of the page.
pub fn wasm(setup: &Setup) -> Result<Duration> {
    let module = Module {
        name: "gcode_playground",
        folder: run::root(),
        profile: "page",
        features: &["--no-default-features"],
        target: run::target(),
        package: run::www().join("pkg"),
        // Functions with one caller are not inlined, because inlining makes the compressed size worse.
        // Functions with similar names have similar code, and compress better side by side.
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
    /// take longer than all other steps, run only if it has.
    pub fn build(&self, setup: &Setup) -> Result<Duration> {
        let compiled = self.compile(setup)?;
        let stamp = self.package.join(STAMP);
        let shipped = self.package.join(format!("{}_bg.wasm", self.name));
        let built = || {
            let scripts = ["js", "d.ts"].map(|kind| self.package.join(format!("{}.{kind}", self.name)));
            let made = shipped.is_file() && scripts.iter().all(|script| script.is_file());
            made.then(|| fs::read_to_string(&stamp).ok())?
        };
        let fingerprint = self.fingerprint();
        if fingerprint.is_some() && fingerprint == built() {
            run::say(format_args!("the wasm package in {} is up to date", self.package.display()));
            return Ok(compiled);
        }
        begin(&self.package)?;
        let cut = self.is_cut.then(|| parts::cut(setup, &self.compiled(), self.name)).transpose()?;
        let bound = match &cut {
            Some(cut) => bindgen::package(&cut.main, self.name, &self.package, For::PageWithParts),
            None => bindgen::package(&self.compiled(), self.name, &self.package, For::Page),
        }?;
        let begun = Instant::now();
        let mut modules = vec![(shipped.clone(), shipped.clone())];
        let later = cut.iter().flat_map(|cut| &cut.files);
        modules.extend(later.map(|(from, name)| (from.clone(), self.package.join(name))));
        // Large modules first, so that no single one runs alone at the end.
        modules.sort_by_key(|(from, _)| Reverse(fs::metadata(from).map_or(0, |file| file.len())));
        run::for_each(&modules, |(from, to)| {
            let mut wasm_opt = setup.command("wasm-opt");
            wasm_opt.args(WASM_FEATURES).args(self.optimised).arg(from).arg("-o").arg(to);
            run::quiet(&format!("optimising {}", to.display()), &mut wasm_opt)
        })?;
        if let Some(cut) = &cut {
            let texts = parts::texts()?.into_iter().map(|(language, list)| (format!("{language}.txt"), list));
            let scripts = cut.scripts().into_iter().map(|(name, text)| (name.to_owned(), text));
            texts.chain(scripts).try_for_each(|(name, text)| write(&self.package.join(name), &text))?;
        }
        let optimised = begun.elapsed();
        write(&self.package.join("package.json"), &self.manifest())?;
        write(&self.package.join(".gitignore"), "*\n")?;
        if let Some(fingerprint) = fingerprint {
            write(&stamp, &fingerprint)?;
        }
        Ok(compiled + bound + optimised)
    }

    fn compile(&self, setup: &Setup) -> Result<Duration> {
        let mut cargo = setup.command("cargo");
        cargo.current_dir(&self.folder).env("CARGO_TARGET_DIR", &self.target);
        cargo.args(["rustc", "--lib", "--crate-type", "cdylib", "--profile", self.profile]);
        cargo.args(["--target", "wasm32-unknown-unknown"]).args(self.features);
        if self.is_cut {
            // Relocations: the linker drops them unless told otherwise.
            cargo.args(["--", "--cfg", "parts", "-C", "link-arg=--emit-relocs", "-C", "strip=none"]);
        }
        run::step(&format!("compiling {} to wasm", self.name), &mut cargo)
    }

    /// The compiled module.
    fn compiled(&self) -> PathBuf {
        let folder = self.target.join("wasm32-unknown-unknown").join(self.profile);
        folder.join(format!("{}.wasm", self.name))
    }

    /// The inputs of the package: the compiled module, the options of wasm-opt and the version of
    /// wasm-bindgen.
    fn fingerprint(&self) -> Option<String> {
        let mut hasher = DefaultHasher::new();
        for path in [self.compiled(), self.folder.join("Cargo.lock")] {
            fs::read(path).ok()?.hash(&mut hasher);
        }
        let recipe = [
            include_str!("parts.js"),
            include_str!("parts.d.ts"),
            include_str!("part-files.js"),
            include_str!("part-files.d.ts"),
            include_str!("parts.rs"),
            include_str!("bindgen.rs"),
        ];
        (WASM_FEATURES, self.optimised, self.is_cut, recipe).hash(&mut hasher);
        if self.is_cut {
            parts::texts().ok()?.hash(&mut hasher);
        }
        Some(format!("{:016x}", hasher.finish()))
    }

    /// Makes Node treat the JavaScript of the package as modules.
    fn manifest(&self) -> String {
        let (file, name) = (self.name, self.name.replace('_', "-"));
        format!(r#"{{ "name": "{name}", "type": "module", "main": "{file}.js", "types": "{file}.d.ts" }}"#)
            + "\n"
    }
}

/// Checks that the module and its parts are within their budgets and close to the sizes in the table of
/// `tests/speed/README.md`. Prints the sizes.
pub fn size() -> Result<Duration> {
    let begun = Instant::now();
    let path = run::root().join("tests/speed/README.md");
    let text =
        fs::read_to_string(&path).map_err(|error| format!("cannot read {}: {error}", path.display()))?;
    let sizes = weigh(&run::www().join("pkg"))?;
    let problems = too_large(&sizes, &stated_sizes(&text));
    if problems.is_empty() { Ok(begun.elapsed()) } else { Err(problems.join("\n")) }
}

/// The size of each row of the table, compressed as by a server.
fn weigh(folder: &Path) -> Result<BTreeMap<String, u64>> {
    let cannot = |error: std::io::Error| format!("cannot weigh {}: {error}", folder.display());
    let mut sizes = BTreeMap::<String, u64>::new();
    for entry in fs::read_dir(folder).map_err(cannot)? {
        let path = entry.map_err(cannot)?.path();
        let file = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        if !file.ends_with(".wasm") && !file.ends_with(".txt") {
            continue;
        }
        let bytes = fs::read(&path).map_err(cannot)?;
        let small = compressed_size(&bytes).map_err(cannot)?;
        println!("{file}: {} bytes, {small} compressed", bytes.len());
        let row = match &*file {
            "gcode_playground_bg.wasm" => CORE.name,
            other => other,
        };
        *sizes.entry(row.to_owned()).or_default() += small;
    }
    Ok(sizes)
}

/// Sizes over budget or different from the table.
fn too_large(sizes: &BTreeMap<String, u64>, stated: &BTreeMap<String, u64>) -> Vec<String> {
    let core = sizes.get(CORE.name).copied().ok_or_else(|| format!("there is no {}", CORE.name));
    let checked = [core.and_then(|core| CORE.check(core)), ALL.check(sizes.values().sum())];
    let mut problems: Vec<String> = checked.into_iter().filter_map(Result::err).collect();
    for (file, &small) in sizes {
        let Some(&told) = stated.get(file) else {
            problems.push(format!("tests/speed/README.md does not name {file}"));
            continue;
        };
        if small.abs_diff(told * 1000) > (told * 100).max(2000) {
            problems.push(format!("{file} is {small}, not as tests/speed/README.md says: {told} kB"));
        }
    }
    let gone = stated.keys().filter(|file| !sizes.contains_key(*file));
    problems.extend(gone.map(|file| format!("tests/speed/README.md names {file}, which is not there")));
    problems
}

/// The rows of the table of sizes: file name and kB.
fn stated_sizes(document: &str) -> BTreeMap<String, u64> {
    let rows = document.lines().filter_map(|line| {
        let mut cells = line.strip_prefix("| `")?.split('|').map(str::trim);
        let name = cells
            .next()?
            .strip_suffix('`')
            .filter(|name| name.ends_with(".wasm") || name.ends_with(".txt"))?;
        Some((name.to_owned(), cells.next()?.parse().ok()?))
    });
    rows.collect()
}

/// Builds the whole static site into www/dist.
pub fn site(setup: &Setup) -> Result {
    run::both(|| npx::module(setup), || wasm(setup).and_then(|_| page(setup, native::Beside::Nothing)))?;
    npx::put_into_package()?;
    run::say(format_args!("the site is in {}", run::www().join("dist").display()));
    Ok(())
}

/// Builds the page into www/dist, and next to it the rule pages, the reference, the pages of the manual, the element for
/// other pages and the files for offline use.
pub fn page(setup: &Setup, beside: native::Beside) -> Result<Duration> {
    let page = run::step("building the page", &mut setup.npm(&["run", "build"]))?;
    let mut rules = native::rule_pages(beside)?;
    rules.arg(run::www().join("dist/rules"));
    let rules = run::step("writing the pages of the rules", &mut rules)?;
    let mut docs = native::reference(beside)?;
    docs.arg(run::www().join("dist"));
    let docs = run::step("writing the reference and the pages of the manual", &mut docs)?;
    let element = embed::element(setup)?;
    // It lists the existing files, so it comes last.
    let offline = run::step(
        "listing what is stored for use without a network",
        &mut setup.npm(&["run", "build:offline"]),
    )?;
    Ok(page + rules + docs + element + offline)
}

/// Creates an empty folder for a package: an incomplete package must not be used, and an older one may have
/// other parts.
pub fn begin(package: &Path) -> Result {
    let cannot = |error| format!("cannot make {}: {error}", package.display());
    let _ = fs::remove_file(package.join(STAMP));
    if package.exists() {
        fs::remove_dir_all(package).map_err(cannot)?;
    }
    fs::create_dir_all(package).map_err(cannot)
}

/// Writes a file.
pub fn write(path: &Path, text: &str) -> Result {
    fs::write(path, text).map_err(|error| format!("cannot write {}: {error}", path.display()))
}

#[cfg(test)]
mod tests {
    use super::{ALL, BTreeMap, Budget, CORE, stated_sizes, too_large};

    #[test]
    fn a_budget_fails_above_105_percent() {
        let budget = Budget { name: "a file", bytes: 100_000 };
        assert!(budget.check(105_000).is_ok());
        assert_eq!(
            budget.check(105_001),
            Err("a file: 105001 bytes compressed, of 100000: too large".to_owned())
        );
    }

    #[test]
    fn what_is_too_large_or_not_as_the_table_says_is_named() {
        let table = "| `core.wasm` | 160 | text |\n| `late.wasm` | 211 | material |\n";
        let stated = stated_sizes(table);
        let problems = |sizes: &[(&str, u64)]| {
            let sizes: BTreeMap<_, _> = sizes.iter().map(|&(file, size)| (file.to_owned(), size)).collect();
            too_large(&sizes, &stated)
        };
        assert!(problems(&[("core.wasm", 157_000), ("late.wasm", 232_000)]).is_empty());
        assert_eq!(problems(&[("core.wasm", 146_000), ("late.wasm", 233_000)]).len(), 1);
        let core = CORE.bytes * 21 / 20 + 1;
        assert_eq!(problems(&[("core.wasm", core), ("late.wasm", 211_000)]).len(), 1);
        assert_eq!(problems(&[("late.wasm", 211_000), ("en.txt", 17_000)]).len(), 3);
        let late = ALL.bytes * 21 / 20 + 1 - 145_000;
        let found = problems(&[("core.wasm", 145_000), ("late.wasm", late)]);
        assert!(found.iter().any(|text| text.starts_with("all parts")), "{found:?}");
    }
}
