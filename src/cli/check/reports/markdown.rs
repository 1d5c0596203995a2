//! A Markdown table for a comment or a page.

use super::{api, sentence};
use crate::cli::markdown::escaped;
use crate::sentences::{Language, labels};

/// The table header.
pub(super) fn begin(language: Language) -> String {
    let head = match language {
        Language::English => ["File", "Line", "Severity", "Code", "Finding"],
        Language::Chinese => ["文件", "行", "级别", "代码", "问题"],
        Language::Russian => ["Файл", "Строка", "Важность", "Код", "Замечание"],
    };
    format!("| {} |\n|---|---:|---|---|---|\n", head.join(" | "))
}

/// The table rows of a program.
pub(super) fn rows(name: &str, rows: impl Iterator<Item = api::Diagnostic>, language: Language) -> String {
    rows.map(|row| {
        let severity =
            crate::message::Severity::named(&row.severity).unwrap_or(crate::message::Severity::Info);
        let cells = [
            escaped(name),
            row.line.to_string(),
            labels::severity(severity, language).to_owned(),
            escaped(&row.code),
            escaped(&sentence(&row)),
        ];
        format!("| {} |\n", cells.join(" | "))
    })
    .collect()
}
