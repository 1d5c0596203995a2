//! Annotations of a workflow on GitHub: a line of text for each finding.

use super::{api, sentence};

/// The annotations of a program.
pub(super) fn annotations(name: &str, rows: impl Iterator<Item = api::Diagnostic>) -> String {
    rows.map(|row| annotation(name, &row)).collect()
}

fn annotation(name: &str, row: &api::Diagnostic) -> String {
    let command = if row.severity == "info" { "notice" } else { &row.severity };
    let mut properties =
        format!("file={},line={},endLine={}", property(&name.replace('\\', "/")), row.line, row.end_line);
    // Columns are taken of one line alone.
    if row.line == row.end_line {
        properties += &format!(",col={},endColumn={}", row.column, row.end_column);
    }
    format!("::{command} {properties},title={}::{}\n", property(&row.code), data(&sentence(row)))
}

/// What may stand after the second `::`.
fn data(text: &str) -> String {
    text.replace('%', "%25").replace('\r', "%0D").replace('\n', "%0A")
}

/// What may stand as a property.
fn property(text: &str) -> String {
    data(text).replace(':', "%3A").replace(',', "%2C")
}
