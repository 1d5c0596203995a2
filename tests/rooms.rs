//! The rooms of `src` have one order, listed in ARCHITECTURE.md: no file imports from a higher room, and no
//! files of a room import each other in a circle.
//!
//! A path counts as an import of the file that defines its target. Re-exports are followed, and tests are
//! left out. Paths from a parent module to its child modules do not count: a parent declares, re-exports and
//! calls its children.
#[path = "rooms/house.rs"]
mod house;
#[path = "rooms/paths.rs"]
mod paths;

use crate::circle;
use crate::project;
use std::collections::BTreeMap;

use house::{House, Module};

/// The rooms listed in ARCHITECTURE.md, lowest first: the first words of the lines of the first code block
/// under the heading.
fn rooms(document: &str) -> Vec<&str> {
    let section = document.split("\n## ").find(|part| part.starts_with("The rooms\n")).expect("a section");
    let picture = section.lines().skip_while(|line| !line.starts_with("    "));
    let picture = picture.take_while(|line| line.starts_with("    "));
    picture.filter_map(|line| line.split_whitespace().next()).collect()
}

/// All modules of `src` with their texts. `main.rs` only calls the command line; `rules` belongs to the build
/// script.
fn sources() -> BTreeMap<Module, String> {
    let mut found = modules("src/");
    found.retain(|module, _| module.first().is_none_or(|room| room != "main" && room != "rules"));
    found
}

/// All modules of the sources in a folder with their texts.
fn modules(folder: &str) -> BTreeMap<Module, String> {
    let mut found = BTreeMap::new();
    for file in project::files() {
        let Some(path) = file.strip_prefix(folder).and_then(|path| path.strip_suffix(".rs")) else {
            continue;
        };
        let mut module: Module = path.split('/').map(str::to_owned).collect();
        module.pop_if(|name| name == "mod" || name == "lib");
        assert!(found.insert(module, project::source(&file)).is_none(), "{file}: its module is there twice");
    }
    found
}

fn architecture() -> String {
    project::source("ARCHITECTURE.md")
}

#[test]
fn every_file_is_in_a_room_of_the_picture() {
    let unlisted = House::new(&sources(), &rooms(&architecture())).unlisted();
    assert!(unlisted.is_empty(), "ARCHITECTURE.md, \"The rooms\": {unlisted:#?}");
}

#[test]
fn no_file_imports_from_a_room_above() {
    let upward = House::new(&sources(), &rooms(&architecture())).upward();
    assert!(upward.is_empty(), "arrows up: {upward:#?}");
}

#[test]
fn no_files_of_a_room_import_each_other_in_a_circle() {
    let circles = House::new(&sources(), &rooms(&architecture())).circles();
    assert!(circles.is_empty(), "{circles:#?}");
}

#[test]
fn no_files_of_xtask_import_each_other_in_a_circle() {
    let circles = House::new(&modules("xtask/src/"), &[]).circles();
    assert!(circles.is_empty(), "{circles:#?}");
}

/// Each file shows where its names come from; only tests use a glob import of their parent.
#[test]
fn files_name_what_they_import() {
    let found: Vec<_> = sources()
        .into_iter()
        .filter(|(module, text)| {
            let is_test = module.iter().any(|name| name == "tests");
            !is_test && text.lines().any(|line| line.starts_with("use super::*"))
        })
        .map(|(module, _)| module.join("/"))
        .collect();
    assert!(found.is_empty(), "`use super::*` in {found:?}");
}

/// Whether a text derives or implements `Serialize` (not `Deserialize`).
fn serialises(text: &str) -> bool {
    let code = text.lines().map(|line| line.trim_start()).filter(|line| !line.starts_with("//"));
    let code: String = code.collect::<Vec<_>>().join(" ");
    let names =
        |list: &str| list.split(|letter: char| !letter.is_alphanumeric()).any(|word| word == "Serialize");
    let derives = code.split("derive(").skip(1).filter_map(|rest| rest.split(')').next()).any(names);
    derives || code.contains("Serialize for ")
}

/// Everything that leaves the crate as JSON or as an object is a row of `api`. Only `Diameter`, which the
/// rows contain, is in a lower room.
#[test]
fn only_the_rows_of_api_are_serialised() {
    let found: Vec<String> = sources()
        .into_iter()
        .filter(|(module, text)| module.first().is_none_or(|room| room != "api") && serialises(text))
        .map(|(module, _)| module.join("/"))
        .collect();
    assert_eq!(found, ["units"]);
}

#[test]
fn what_serialises_would_be_found() {
    assert!(serialises("#[derive(Clone, Serialize)] struct A;"));
    assert!(serialises("#[cfg_attr(test, derive(\n    Debug,\n    serde::Serialize))]"));
    assert!(serialises("impl Serialize for A {}"));
    assert!(!serialises("// derive(Serialize)\n#[derive(Deserialize)] fn f(row: &impl Serialize) {}"));
}

/// A small house for tests: module and text of each file.
fn house(files: &[(&str, &str)], rooms: &[&str]) -> House {
    let split = |path: &str| path.split('/').filter(|name| !name.is_empty()).map(str::to_owned).collect();
    let sources = files.iter().map(|(path, text)| (split(path), (*text).to_owned())).collect();
    House::new(&sources, rooms)
}

#[test]
fn an_arrow_up_would_be_found() {
    let upward = |files: &[(&str, &str)]| -> Vec<String> {
        let found = house(files, &["low", "high", "low/roof"]).upward();
        found.into_iter().map(|up| format!("{} {}", up.from, up.room)).collect()
    };
    let high = ("high", "use crate::low::Thing; pub struct Other;");
    assert!(upward(&[("low", ""), high, ("", "mod low; mod high;")]).is_empty());
    assert_eq!(upward(&[("low", "use crate::high::Other;"), high]), ["low high"]);
    assert_eq!(
        upward(&[("low", ""), ("low/part", "fn f() -> super::super::high::Other {}"), high]),
        ["low/part high"]
    );
    assert_eq!(upward(&[("low", "mod roof; use roof::Tile;"), ("low/roof", "")]), ["low low/roof"]);
    // Via the root of the crate.
    let root = ("", "pub use high::Other; pub fn own() {}");
    assert_eq!(upward(&[("low", "use crate::Other;"), high, root]), ["low high"]);
    assert_eq!(upward(&[("low", "use crate::own;"), high, root]), ["low lib.rs"]);
    // Tests may use higher rooms.
    let tested = "#[cfg(test)] mod tests; #[cfg(test)] mod more { use crate::high::Other; }";
    assert!(upward(&[("low", tested), ("low/tests", "use crate::high::Other;"), high]).is_empty());
}

#[test]
fn a_circle_would_be_found() {
    let circles = |files: &[(&str, &str)]| house(files, &["low"]).circles();
    let parent = ("low", "mod a; mod b; pub use a::One; pub use b::Two; use a::help;");
    let child = ("low/b", "use super::One; pub struct Two;");
    assert!(circles(&[parent, ("low/a", "pub struct One;"), child]).is_empty());
    assert_eq!(circles(&[parent, ("low/a", "use super::Two;"), child]), ["low/a → low/b → low/a"]);
    // A file that leads to a circle is not part of it. A child can close a circle for its parent.
    let leads = ("low/0", "use super::a::One;");
    assert_eq!(circles(&[parent, leads, ("low/a", "use super::Two;"), child]), ["low/a → low/b → low/a"]);
    let inner = ("low/a/inner", "use super::One;");
    let back = ("low/b", "use super::a::inner::help;");
    assert_eq!(
        circles(&[parent, ("low/a", "use super::b::Two;"), inner, back]),
        ["low/a → low/b → low/a/inner → low/a"]
    );
}

#[test]
fn a_circle_of_method_calls_would_be_found() {
    let circles = |b: &str| {
        let a = "impl S { fn f(&self) { self.g() } }";
        house(&[("low", "pub struct S; mod a; mod b;"), ("low/a", a), ("low/b", b)], &["low"]).circles()
    };
    assert!(circles("impl S { fn g(&self) {} }").is_empty());
    let circle = ["low/a → low/b → low/a"];
    assert_eq!(circles("impl S { fn g(&self) { self.f() } }"), circle);
    assert_eq!(circles("impl S { fn g(&self) {} } fn h(own: &mut S) { own.f() }"), circle);
}

#[test]
fn a_missing_room_would_be_found() {
    let small = house(&[("", ""), ("low", ""), ("low/a", ""), ("lower", "")], &["low", "high"]);
    assert_eq!(small.unlisted(), ["`lower` is in no room", "there is no module `high`"]);
    let document = "# A\n\n    no    no\n\n## The rooms\n\nText.\n\n    low   one\n    high  two\n\nText.\n\n    no   three\n";
    assert_eq!(rooms(document), ["low", "high"]);
}

#[test]
fn every_file_of_tests_runs() {
    let named = project::source("tests/it.rs") + &project::source("tests/slow.rs");
    let files = project::files();
    let files = files.iter().filter_map(|file| file.strip_prefix("tests/")?.strip_suffix(".rs"));
    let subjects = files.filter(|name| !name.contains('/') && !["it", "slow", "wasm"].contains(name));
    let missing: Vec<_> = subjects.filter(|name| !named.contains(&format!("\nmod {name};\n"))).collect();
    assert!(missing.is_empty(), "not in tests/it.rs: {missing:?}");
}
