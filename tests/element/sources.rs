//! What the sources of the page say about the element: parts, slots, events, members, custom properties.
//!
//! In: the files of `www/src`. Out: sorted names.

use crate::project::{files, source};
use std::collections::{BTreeMap, BTreeSet};

/// The files that define the class.
const CLASS: [&str; 2] = ["www/src/shell/element.ts", "www/src/shell/element-attributes.ts"];

/// The layers of the element; `page` is around it.
const LAYERS: [&str; 4] = ["www/src/dom/", "www/src/editor/", "www/src/panels/", "www/src/shell/"];

/// The sources of the element.
fn texts() -> Vec<String> {
    let files = files();
    let own = files.iter().filter(|file| LAYERS.iter().any(|layer| file.starts_with(layer)));
    own.filter(|file| file.ends_with(".ts")).map(|file| source(file)).collect()
}

/// The texts in quotes after each occurrence of `before`; blanks may be between.
fn quoted_after<'a>(text: &'a str, before: &'a str) -> impl Iterator<Item = &'a str> {
    text.split(before).skip(1).filter_map(|rest| rest.trim_start().strip_prefix('\'')?.split('\'').next())
}

fn is_name(text: &str) -> bool {
    !text.is_empty() && text.chars().all(|letter| letter.is_ascii_lowercase() || letter == '-')
}

/// The menus of the row at the top.
fn menus() -> Vec<String> {
    let header = source("www/src/panels/header.ts");
    let list = header.split("const MENUS = [").nth(1).and_then(|rest| rest.split(']').next());
    let names = list.expect("the list of menus").split('\'').skip(1).step_by(2);
    names.map(|name| format!("{name}-menu")).collect()
}

/// The parts. A dialog and a menu have their names as parts.
pub fn parts() -> BTreeSet<String> {
    let mut found: BTreeSet<String> = menus().into_iter().chain(["menu".to_owned()]).collect();
    for text in texts() {
        let names = quoted_after(&text, " part:").chain(quoted_after(&text, "new Dialog("));
        found.extend(names.filter(|name| is_name(name)).map(str::to_owned));
    }
    assert!(found.len() > 30, "{found:?}");
    found
}

pub fn slots() -> BTreeSet<String> {
    let mut found: BTreeSet<String> = menus().into_iter().collect();
    for text in texts() {
        found.extend(quoted_after(&text, "make('slot', { name:").map(str::to_owned));
    }
    found
}

/// The events, as their names occur in quotes.
pub fn events() -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    for text in texts() {
        let names = text.split('\'').filter(|name| name.starts_with("gcode-") && is_name(name));
        found.extend(names.filter(|name| *name != "gcode-playground").map(str::to_owned));
    }
    found
}

/// The public members of the class.
pub fn members() -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    for file in CLASS {
        let text = source(file);
        let class = text.split("\nexport class ").nth(1).and_then(|rest| rest.split("\n}\n").next());
        for line in class.expect("the class").lines().filter_map(|line| line.strip_prefix("  ")) {
            let line = ["get ", "set ", "async ", "override "]
                .iter()
                .fold(line, |line, word| line.strip_prefix(word).unwrap_or(line));
            let Some((name, _)) = line.split_once('(') else { continue };
            // Without type parameters.
            let name = name.split('<').next().unwrap_or_default();
            if !name.is_empty() && name.chars().all(char::is_alphanumeric) {
                found.insert(name.to_owned());
            }
        }
    }
    found
}

/// The custom properties with their values: the tokens, and those that a style sheet reads with a default.
pub fn custom_properties() -> BTreeMap<String, String> {
    let tokens = source("www/src/tokens.css");
    let first = tokens.split("\n}\n").next().unwrap_or_default();
    let declared = first.lines().filter_map(|line| line.trim().strip_suffix(';')?.split_once(": "));
    let mut found: BTreeMap<String, String> = declared
        .filter(|(name, _)| name.starts_with("--playground-"))
        .map(|(name, value)| (name.to_owned(), value.to_owned()))
        .collect();
    let styles = source("www/src/shell/styles.css");
    for used in styles.split("var(--playground-").skip(1) {
        let Some((name, value)) = used.split(')').next().and_then(|used| used.split_once(", ")) else {
            continue;
        };
        found.entry(format!("--playground-{name}")).or_insert_with(|| value.to_owned());
    }
    assert!(found.len() > 50, "{found:?}");
    found
}
