//! The format of reviewdog, which comments on changed lines: one object with all findings.
//!
//! Columns are bytes of the text in UTF-8. A suggestion replaces one range, so a fix with several edits has
//! none.

use serde_json::{Value, json};

use super::{Places, api, list, sentence};
use crate::message::Severity;
use crate::sentences::Language;

pub(super) const BEGIN: &str = "{\n\"source\": {\"name\": \"gcode-playground\"},\n\"diagnostics\": [\n";
pub(super) const END: &str = "\n]\n}\n";

/// The objects of a program, separated by commas. `pages`: the address of the rule pages.
pub(super) fn diagnostics(
    name: &str,
    places: Places<'_>,
    rows: impl Iterator<Item = api::Diagnostic>,
    pages: Option<&str>,
    language: Language,
) -> Vec<u8> {
    let path = name.replace('\\', "/");
    let found = rows.map(|row| {
        let mut code = json!({"value": row.slug});
        if let Some(folder) = pages {
            code["url"] = language.rule_page(folder, &row.slug).into();
        }
        let place = [(row.line, row.column), (row.end_line, row.end_column)];
        let severity = Severity::named(&row.severity).unwrap_or(Severity::Info);
        json!({
            "message": sentence(&row),
            "location": {"path": path.trim_start_matches("./"), "range": range(places, place)},
            "severity": level(severity),
            "code": code,
            "suggestions": suggestions(places, &row),
        })
    });
    list(found)
}

/// The fixes that are one edit.
fn suggestions(places: Places<'_>, row: &api::Diagnostic) -> Vec<Value> {
    let single = row.fixes.iter().filter_map(|fix| match &fix.edits[..] {
        [edit] => Some(edit),
        _ => None,
    });
    let suggestion = |edit: &api::Edit| {
        let place = [(edit.line, edit.column), (edit.end_line, edit.end_column)];
        json!({"range": range(places, place), "text": edit.text})
    };
    single.map(suggestion).collect()
}

/// A range from its start and its end: lines and columns from 1, columns in UTF-16 units.
fn range(places: Places<'_>, [start, end]: [(u32, u32); 2]) -> Value {
    let position = |(line, column)| json!({"line": line, "column": byte_column(places, line, column)});
    json!({"start": position(start), "end": position(end)})
}

/// The column in bytes, from 1, of a column in UTF-16 units, from 1.
fn byte_column(Places { text, lines }: Places<'_>, line: u32, column: u32) -> u32 {
    let start = lines.line(text, line.clamp(1, lines.len()) - 1).start;
    let units = lines.utf16_offset(text, start) + column.saturating_sub(1);
    lines.byte_at_utf16(text, units).saturating_sub(start) + 1
}

/// The names of severities.
fn level(severity: Severity) -> &'static str {
    match severity {
        Severity::Error => "ERROR",
        Severity::Warning => "WARNING",
        Severity::Info | Severity::Off => "INFO",
    }
}
