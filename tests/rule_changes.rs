//! The list of rule changes, `www/docs/rule-changes.md`: applying all versions in order results in the
//! current rules. `UPDATE_EXPECT=1 cargo test --test it rule_changes::` adds missing changes to the
//! unreleased version.
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use expect_test::expect_file;
use gcode_playground::message::{RULES, Severity};

const LIST: &str = "www/docs/rule-changes.md";
const HEAD: &str = "<!-- changes -->\n| rule | change |\n|---|---|\n";
const END: &str = "<!-- /changes -->\n";
const UNRELEASED: &str = "Unreleased";

/// The severities of rules, by slug.
type Severities = BTreeMap<String, String>;

/// The path of a file of the project.
fn path(file: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(file)
}

fn source(file: &str) -> String {
    fs::read_to_string(path(file)).expect(file)
}

/// Heading and rows of each version, newest first.
fn versions(list: &str) -> Vec<(String, Vec<(String, String)>)> {
    let sections = list.split("\n## ").skip(1);
    let row = |line: &str| {
        let cells: Vec<&str> = line.strip_prefix("| `")?.strip_suffix(" |")?.split(" | ").collect();
        Some((cells[0].trim_end_matches('`').to_owned(), (*cells.get(1)?).to_owned()))
    };
    sections
        .map(|section| {
            let heading = section.lines().next().unwrap_or_default().to_owned();
            (heading, section.lines().filter_map(row).collect())
        })
        .collect()
}

/// The severities after all changes. The error names a change that does not fit the state before it.
fn after_all(list: &str) -> Result<Severities, String> {
    let mut severities = Severities::new();
    for (version, rows) in versions(list).iter().rev() {
        for (slug, change) in rows {
            let before = severities.get(slug).cloned();
            let words: Vec<&str> = change.split(' ').collect();
            let after = match (words.as_slice(), &before) {
                (["added:", severity], None) => Some((*severity).to_owned()),
                ([from, "→", to], Some(before)) if from == before && from != to => Some((*to).to_owned()),
                (["removed"], Some(_)) => None,
                _ => return Err(format!("{version}: `{slug}` {change}, and before it {before:?}")),
            };
            match after {
                Some(severity) => severities.insert(slug.clone(), severity),
                None => severities.remove(slug),
            };
        }
    }
    Ok(severities)
}

fn as_they_are() -> Severities {
    let name = |severity: Severity| severity.name().to_owned();
    RULES.iter().map(|rule| (rule.slug.to_owned(), name(rule.severity))).collect()
}

/// The changes from one state to the other, sorted by slug.
fn changes(from: &Severities, to: &Severities) -> Vec<(String, String)> {
    let mut found = Vec::new();
    for (slug, severity) in to {
        match from.get(slug) {
            None => found.push((slug.clone(), format!("added: {severity}"))),
            Some(before) if before != severity => {
                found.push((slug.clone(), format!("{before} → {severity}")))
            }
            Some(_) => {}
        }
    }
    found.extend(
        from.keys().filter(|slug| !to.contains_key(*slug)).map(|slug| (slug.clone(), "removed".to_owned())),
    );
    found.sort();
    found
}

/// The list with its newest section replaced by the changes up to the current rules.
fn updated(list: &str, rules: &Severities) -> String {
    let (before, rest) =
        list.split_once(&format!("\n## {UNRELEASED}\n")).expect("a section for what is not released");
    let older = rest.find("\n## ").map_or("", |at| &rest[at..]);
    let earlier = after_all(older).expect("older versions fit each other");
    let rows =
        changes(&earlier, rules).into_iter().map(|(slug, change)| format!("| `{slug}` | {change} |\n"));
    format!("{before}\n## {UNRELEASED}\n\n{HEAD}{}{END}{older}", rows.collect::<String>())
}

#[test]
fn the_list_ends_with_the_rules_as_they_are() {
    let list = source(LIST);
    expect_file![path(LIST)].assert_eq(&updated(&list, &as_they_are()));
}

#[test]
fn its_versions_are_those_of_the_changelog() {
    let headings = |text: &str| {
        let lines = text.lines().filter_map(|line| line.strip_prefix("## "));
        lines.map(str::to_owned).collect::<Vec<_>>()
    };
    assert_eq!(headings(&source(LIST)), headings(&source("CHANGELOG.md")));
}

#[test]
fn a_change_that_nobody_wrote_down_is_found() {
    let list = format!(
        "# Changes\n\n## {UNRELEASED}\n\n{HEAD}| `b` | error → warning |\n| `c` | removed |\n{END}\n## 0.1.0\n\n{HEAD}| `a` | added: info |\n| `b` | added: error |\n| `c` | added: error |\n{END}"
    );
    let rules = |pairs: &[(&str, &str)]| {
        pairs.iter().map(|&(slug, severity)| (slug.to_owned(), severity.to_owned())).collect::<Severities>()
    };
    let now = rules(&[("a", "info"), ("b", "warning")]);
    assert_eq!(after_all(&list), Ok(now.clone()));
    assert!(changes(&now, &now).is_empty());
    let later = rules(&[("a", "warning"), ("b", "warning"), ("d", "error")]);
    let expected = [("a", "info → warning"), ("d", "added: error")];
    assert_eq!(changes(&now, &later), expected.map(|(slug, change)| (slug.to_owned(), change.to_owned())));
    // The updated list is consistent, and older versions stay unchanged.
    let written = updated(&list, &later);
    assert_eq!(after_all(&written), Ok(later.clone()));
    assert!(
        written.ends_with(&format!("| `c` | added: error |\n{END}"))
            && written.contains("| `b` | error → warning |\n")
    );
    assert_eq!(updated(&written, &later), written);
    // Changes of rules that do not exist or have another severity.
    for wrong in [
        "| `x` | error → warning |",
        "| `a` | error → warning |",
        "| `a` | added: info |",
        "| `x` | removed |",
    ] {
        let list = list.replace("| `c` | removed |", wrong);
        assert!(after_all(&list).is_err(), "{wrong}");
    }
}
