//! The list of rules.
//!
//! In: the levels of a setup. Out: text or JSON, a row for each rule: slug, severity, code, alarms, kind.

use std::io::{self, Write};

use super::{Format, write_row};
use crate::api;
use crate::message::{Levels, RULES};
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
