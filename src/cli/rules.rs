//! Lists the rules, and finds rules by name.
//!
//! In: the severities of a setup. Out: text or JSON, a row for each rule: slug, severity, code, alarms, kind.

use std::io::{self, Write};

use super::{Format, write_row};
use crate::api;
use crate::message::levels::nearest;
use crate::message::{Levels, RULES, Rule, Severity};
use crate::sentences::{Language, labels};

/// Writes the list, in the order of the slugs.
pub(super) fn write(
    out: &mut dyn Write,
    levels: &Levels,
    language: Language,
    format: Format,
) -> io::Result<()> {
    for rule in &RULES {
        let (slug, codes, alarms) = (rule.slug, rule.codes, rule.alarms);
        let level = levels.of(slug).unwrap_or(rule.severity);
        match format {
            Format::Json => write_row(out, &api::Rule::new(rule, level))?,
            Format::Text => {
                let (severity, kind) =
                    (labels::severity(level, language), labels::category(rule.kind, language));
                let alarms = if alarms == codes { String::new() } else { alarms.join(" ") };
                let line = format!("{slug:<34} {severity:<15} {:<22} {alarms:<8} {kind}", codes.join(" "));
                writeln!(out, "{line}")?;
            }
        }
    }
    Ok(())
}

/// The rules with a slug, a code or a group of this name.
pub(super) fn named(name: &str) -> Result<Vec<&'static str>, String> {
    let is_named = |known: &str| known.eq_ignore_ascii_case(name);
    let is_in_it = |rule: &Rule| rule.group.is_some_and(|group| is_named(group.name()));
    let found: Vec<_> = RULES
        .iter()
        .filter(|rule| is_named(rule.slug) || is_in_it(rule) || rule.codes.iter().any(|code| is_named(code)))
        .map(|rule| rule.slug)
        .collect();
    if found.is_empty() {
        let near = nearest(name).map_or_else(String::new, |near| format!("; the nearest is `{near}`"));
        return Err(format!("there is no rule `{name}`{near}"));
    }
    Ok(found)
}

/// Parses the name of a severity.
pub(super) fn level(name: &str) -> Result<Severity, String> {
    Severity::named(name)
        .ok_or_else(|| format!("`{name}` is no level of a rule; it can be off, info, warning or error"))
}
