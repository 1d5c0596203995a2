//! Annotations of a GitHub workflow: one line for each finding.

use super::{api, sentence};

/// The annotations of a program.
pub(super) fn annotations(name: &str, rows: impl Iterator<Item = api::Diagnostic>) -> String {
    rows.map(|row| annotation(name, &row)).collect()
}

fn annotation(name: &str, row: &api::Diagnostic) -> String {
    let command = if row.severity == "info" { "notice" } else { &row.severity };
    let mut properties =
        format!("file={},line={},endLine={}", property(&name.replace('\\', "/")), row.line, row.end_line);
    // GitHub accepts columns only if the annotation is within one line.
    if row.line == row.end_line {
        properties += &format!(",col={},endColumn={}", row.column, row.end_column);
    }
    format!("::{command} {properties},title={}::{}\n", property(&row.code), data(&sentence(row)))
}

/// Escapes text for the part after the second `::`.
fn data(text: &str) -> String {
    text.replace('%', "%25").replace('\r', "%0D").replace('\n', "%0A")
}

/// Escapes text for a property.
fn property(text: &str) -> String {
    data(text).replace(':', "%3A").replace(',', "%2C")
}
