//! A Code Quality report of GitLab: an array with one object for each finding.
//!
//! A fingerprint identifies a finding over several commits: it depends on file, rule and block, like an entry
//! of a baseline, and on the number of equal findings before it. Lines do not count.

use std::collections::HashMap;
use std::path::PathBuf;

use serde_json::json;

use super::super::baseline::{Entry, entry};
use super::super::finding::Subject;
use super::{Places, list, sentence};
use crate::cli::system;
use crate::message::Severity;
use crate::sentences::Language;

pub(super) const BEGIN: &str = "[\n";
pub(super) const END: &str = "\n]\n";

/// The objects of a file, separated by commas.
pub(super) fn issues(subject: &Subject, places: Places<'_>, language: Language) -> Vec<u8> {
    let here = system::absolute(&PathBuf::from(".")).unwrap_or_default();
    let mut before: HashMap<Entry, usize> = HashMap::new();
    let issues = subject.findings.iter().filter_map(|finding| {
        let row = finding.row(places, language)?;
        let entry = entry(&here, subject, places.lines, finding)?;
        let equal = before.entry(entry.clone()).or_default();
        *equal += 1;
        let severity = Severity::named(&row.severity).unwrap_or(Severity::Info);
        Some(json!({
            "description": sentence(&row),
            "check_name": row.slug,
            "fingerprint": fingerprint(&entry, *equal),
            "severity": level(severity),
            "location": {
                "path": entry.0.trim_start_matches("./"),
                "lines": {"begin": row.line, "end": row.end_line},
            },
        }))
    });
    list(issues)
}

/// GitLab's names of severities.
fn level(severity: Severity) -> &'static str {
    match severity {
        Severity::Error => "major",
        Severity::Warning => "minor",
        Severity::Info | Severity::Off => "info",
    }
}

/// A hash (FNV-1a, 64 bits) of an entry; `number`: which of the equal entries of the file, from 1.
fn fingerprint((file, rule, block): &Entry, number: usize) -> String {
    let number = number.to_string();
    let bytes = [file.as_str(), rule, block, &number].into_iter().flat_map(|part| part.bytes().chain([0]));
    let hash = bytes
        .fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x100_0000_01b3));
    format!("{hash:016x}")
}
