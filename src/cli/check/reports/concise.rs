//! One line for each finding, for editors and `grep`: `part.nc:3:4: error PS0005 …`.

use super::api;

/// The lines of a program.
pub(super) fn lines(name: &str, rows: impl Iterator<Item = api::Diagnostic>) -> String {
    rows.map(|row| line(name, &row)).collect()
}

fn line(name: &str, row: &api::Diagnostic) -> String {
    let api::Diagnostic { line, column, severity, code, message, .. } = row;
    format!("{name}:{line}:{column}: {severity} {code} {}\n", message.replace('\n', " "))
}
