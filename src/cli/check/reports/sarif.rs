//! SARIF 2.1.0 (OASIS): one run of one tool, one result for each finding.
//!
//! Columns are UTF-16 code units, as in the JSON format. Rules follow the results, because only then it is
//! known which occurred.

use serde_json::{Value, json};

use super::{Counts, address, api, list};
use crate::cli::markdown;
use crate::cli::rule_page::{Page, Text};
use crate::message::{RULES, Rule, Severity};
use crate::sentences::Language;

/// The text before the results.
pub(super) fn begin() -> Vec<u8> {
    b"{\n\"$schema\": \"https://json.schemastore.org/sarif-2.1.0.json\",\n\"version\": \"2.1.0\",\n\"runs\": [{\n\"columnKind\": \"utf16CodeUnits\",\n\"results\": [\n".into()
}

/// The results of a program, separated by commas.
pub(super) fn results(name: &str, rows: impl Iterator<Item = api::Diagnostic>) -> Vec<u8> {
    list(rows.map(|row| result(name, &row)))
}

/// The text after the results. `pages`: the address of the rule pages.
pub(super) fn end(counts: &Counts, pages: Option<&str>, language: Language) -> Vec<u8> {
    let found = RULES.iter().filter(|rule| counts.rules.contains_key(rule.slug));
    let rules: Vec<Value> = found.map(|found| rule(found, pages, language)).collect();
    let driver = json!({"name": "gcode-playground", "version": env!("CARGO_PKG_VERSION"), "rules": rules});
    format!("\n],\n\"tool\": {{\"driver\": {driver}}}\n}}]\n}}\n").into_bytes()
}

/// The description of a rule: its title, its texts, and the address of its page.
fn rule(rule: &Rule, pages: Option<&str>, language: Language) -> Value {
    let mut object = json!({"id": rule.slug, "defaultConfiguration": {"level": level(rule.severity)}});
    if let Some(page) = Page::of(rule.slug) {
        let Text { title, what, why, repair } = *page.text(language);
        let paragraphs = [why, repair].map(markdown::with_code).join("\n\n");
        object["shortDescription"] = json!({"text": title});
        object["fullDescription"] = json!({"text": what});
        object["help"] = json!({"text": format!("{why}\n\n{repair}"), "markdown": paragraphs});
    }
    if let Some(folder) = pages {
        object["helpUri"] = language.rule_page(folder, rule.slug).into();
    }
    object
}

fn result(name: &str, row: &api::Diagnostic) -> Value {
    let region = |line: u32, column: u32, end_line: u32, end_column: u32| json!({"startLine": line, "startColumn": column, "endLine": end_line, "endColumn": end_column});
    let artifact = json!({"uri": uri(name)});
    let severity = Severity::named(&row.severity).unwrap_or(Severity::Info);
    let mut result = json!({
        "ruleId": row.slug,
        "level": level(severity),
        "message": {"text": super::sentence(row)},
        "locations": [{"physicalLocation": {
            "artifactLocation": artifact,
            "region": region(row.line, row.column, row.end_line, row.end_column),
        }}],
        "properties": {"code": row.code, "kind": row.kind},
    });
    let fixes: Vec<Value> = row
        .fixes
        .iter()
        .filter(|fix| !fix.edits.is_empty())
        .map(|fix| {
            let replacements: Vec<Value> = fix
                .edits
                .iter()
                .map(|edit| {
                    let deleted = region(edit.line, edit.column, edit.end_line, edit.end_column);
                    json!({"deletedRegion": deleted, "insertedContent": {"text": edit.text}})
                })
                .collect();
            json!({
                "description": {"text": fix.title},
                "artifactChanges": [{"artifactLocation": artifact, "replacements": replacements}],
            })
        })
        .collect();
    if !fixes.is_empty() {
        result["fixes"] = fixes.into();
    }
    result
}

/// The URI of a file: relative, or with `file:` if the path is absolute.
fn uri(name: &str) -> String {
    let name = name.replace('\\', "/");
    match name.split_once(':') {
        Some((drive, path)) if drive.len() == 1 && path.starts_with('/') => {
            format!("file:///{drive}:{}", address(path))
        }
        _ if name.starts_with("//") => format!("file:{}", address(&name)),
        _ if name.starts_with('/') => format!("file://{}", address(&name)),
        _ => address(&name),
    }
}

/// SARIF's names of severities.
fn level(severity: Severity) -> &'static str {
    match severity {
        Severity::Error => "error",
        Severity::Warning => "warning",
        Severity::Info => "note",
        Severity::Off => "none",
    }
}

#[cfg(test)]
mod tests {
    use super::uri;

    #[test]
    fn a_file_has_an_address_wherever_it_is() {
        for (name, address) in [
            ("programs/a b.nc", "programs/a%20b.nc"),
            (r"programs\ü.nc", "programs/%C3%BC.nc"),
            ("./a:b.nc", "a%3Ab.nc"),
            ("/home/a.nc", "file:///home/a.nc"),
            (r"C:\a b.nc", "file:///C:/a%20b.nc"),
            (r"\\server\a.nc", "file://server/a.nc"),
        ] {
            assert_eq!(uri(name), address);
        }
    }
}
