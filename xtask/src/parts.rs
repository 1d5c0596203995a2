//! In: the linked module of the page, with relocations. Out: what the first picture needs as a module of its
//! own, and a file for each part of `src/parts.rs` and each language, with the script that loads them.
//!
//! wasm-split cuts the module at the two entries (`entry!`). Code and data that are reachable only through an entry
//! go into the file of its part; code and data that both parts need go into a file that is loaded first.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use crate::format::LANGUAGES;
use crate::run::{self, Result};
use crate::setup::Setup;
use crate::{texts, translations};

/// What wasm-split calls the script that it would load the parts with. Ours is another: it can try again,
/// and runs under Node.
const LINK_SCRIPT: &str = "__wasm_split.js";

/// The parts, by `Part::name`. Each needs those before it.
const NAMES: [&str; 2] = ["early", "late"];

/// A module that is cut into parts.
pub struct Cut {
    /// What remains: the module that wasm-bindgen makes the package of.
    pub main: PathBuf,
    /// The other files: where each is, and its name in the package.
    pub files: Vec<(PathBuf, String)>,
    /// The names of the files each part needs, in order.
    parts: BTreeMap<String, Vec<String>>,
}

/// Cuts a module into a folder beside it.
pub fn cut(setup: &Setup, module: &Path, name: &str) -> Result<Cut> {
    let folder = module.with_extension("parts");
    let _ = fs::remove_dir_all(&folder);
    let mut split = setup.command("wasm-split-cli");
    split.arg(module).arg(&folder).args(["--out-name", name]);
    run::quiet("cutting the module into its parts", &mut split)?;
    let script = folder.join(LINK_SCRIPT);
    let script =
        fs::read_to_string(&script).map_err(|error| format!("cannot read {}: {error}", script.display()))?;
    let mut files = Vec::new();
    let mut parts = BTreeMap::<String, Vec<String>>::new();
    for (file, needed_by) in files_of(&script) {
        let shipped = shipped_name(&needed_by);
        // A part needs the files of the parts before it.
        let first = NAMES.iter().position(|name| needed_by.contains(&(*name).to_owned()));
        for name in &NAMES[first.unwrap_or_default()..] {
            parts.entry((*name).to_owned()).or_default().push(shipped.clone());
        }
        files.push((folder.join(file), shipped));
    }
    if parts.is_empty() {
        return Err(format!("{} was not cut: wasm-split found no part", module.display()));
    }
    Ok(Cut { main: folder.join(format!("{name}.wasm")), files, parts })
}

/// The scripts that know the files of the parts and load them, and their types.
type Scripts = [(&'static str, String); 4];

impl Cut {
    /// Its scripts.
    pub fn scripts(&self) -> Scripts {
        let languages = LANGUAGES.map(|tag| (tag.to_owned(), vec![format!("{tag}.txt")]));
        scripts(&self.parts.clone().into_iter().chain(languages).collect())
    }
}

/// The scripts of a module that is not cut: no part has a file.
pub fn whole() -> Scripts {
    scripts(&NAMES.into_iter().chain(LANGUAGES).map(|name| (name.to_owned(), Vec::new())).collect())
}

/// The texts of each language, by its tag.
pub fn texts() -> Result<Vec<(&'static str, String)>> {
    let (rules, texts) = translations::read()?;
    Ok((0..).zip(LANGUAGES).map(|(index, tag)| (tag, texts::list(index, &rules, &texts))).collect())
}

fn scripts(parts: &BTreeMap<String, Vec<String>>) -> Scripts {
    let row = |(part, files): (&String, &Vec<String>)| {
        let urls: Vec<String> =
            files.iter().map(|file| format!("new URL('./{file}', import.meta.url).href")).collect();
        format!("{part}: [{}],", urls.join(", "))
    };
    let rows: Vec<String> = parts.iter().map(row).collect();
    let names: Vec<String> = parts.keys().map(|part| format!("'{part}'")).collect();
    [
        ("part-files.js", include_str!("part-files.js").replace("/* FILES */", &rows.join("\n  "))),
        ("part-files.d.ts", include_str!("part-files.d.ts").replace("/* NAMES */", &names.join(" | "))),
        ("parts.js", include_str!("parts.js").to_owned()),
        ("parts.d.ts", include_str!("parts.d.ts").to_owned()),
    ]
}

/// The files that wasm-split's script loads, each with the parts that need it; those that several need first.
fn files_of(script: &str) -> Vec<(String, Vec<String>)> {
    let mut shared = Vec::new();
    let mut own = Vec::new();
    let mut above = "";
    for line in script.lines() {
        if let Some(rest) = line.strip_prefix("const __chunk_") {
            let number = rest.split(' ').next().unwrap_or_default();
            let parts = above.trim_start_matches("/* ").trim_end_matches(" */");
            let parts = parts.split(", ").map(str::to_lowercase);
            shared.push((format!("chunk_{number}.wasm"), parts.collect()));
        } else if let Some(rest) = line.strip_prefix("export const __wasm_split_load_") {
            let part = rest.split(' ').next().unwrap_or_default().to_owned();
            own.push((format!("split_{part}.wasm"), vec![part.to_lowercase()]));
        }
        above = line;
    }
    shared.extend(own);
    shared
}

/// The file that these parts need, in the package.
fn shipped_name(parts: &[String]) -> String {
    format!("{}.wasm", parts.join("-"))
}

#[cfg(test)]
mod tests {
    use super::{NAMES, files_of, shipped_name, whole};

    #[test]
    fn a_whole_module_has_all_parts_and_no_files_of_them() {
        let source = include_str!("../../src/parts.rs");
        let named: Vec<&str> =
            source.split("=> \"").skip(1).filter_map(|rest| rest.split('"').next()).collect();
        assert_eq!(named, NAMES);
        let [(_, files), ..] = whole();
        assert!(NAMES.iter().all(|name| files.contains(&format!("{name}: [],"))), "{files}");
    }

    #[test]
    fn files_that_several_parts_need_come_first() {
        let script = "/* Early, Late */\nconst __chunk_6 = makeLoad(() => {\n\
            export const __wasm_split_load_Late = wrapAsyncCb(makeLoad(() => {\n";
        let [shared, own] = &files_of(script)[..] else { panic!("two files") };
        assert_eq!(shared, &("chunk_6.wasm".to_owned(), vec!["early".to_owned(), "late".to_owned()]));
        assert_eq!(own, &("split_Late.wasm".to_owned(), vec!["late".to_owned()]));
        assert_eq!(shipped_name(&shared.1), "early-late.wasm");
    }
}
