//! Known findings: a list in a file, so that only new findings fail the check.
//!
//! In: findings of files, and the list. Out: the findings that are not in the list. A finding is identified
//! by its file (relative to the folder of the list), its rule, and the text of its block without spaces and
//! without its sequence number (N), so that blocks may be moved and renumbered.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use serde_json::{Value, json};

use super::super::configuration::shown;
use super::super::system;
use super::finding::{Finding, Subject, What};
use crate::source::LineIndex;

/// Options for the list of known findings.
#[derive(clap::Args)]
pub(super) struct BaselineOptions {
    /// Ignore the findings listed in this file.
    #[arg(long, value_name = "FILE")]
    baseline: Option<PathBuf>,
    /// Write all findings to this file.
    #[arg(long, value_name = "FILE")]
    write_baseline: Option<PathBuf>,
}

/// Identifies a finding: file, rule, block.
pub(super) type Entry = (String, &'static str, String);

/// The known findings, each with its count.
#[derive(Default)]
pub(super) struct Baseline {
    /// The folder that file names are relative to.
    folder: PathBuf,
    known: BTreeMap<(String, String, String), usize>,
}

impl BaselineOptions {
    /// The list to read, if given.
    #[cfg(not(target_arch = "wasm32"))]
    pub(super) fn input(&self) -> Option<PathBuf> {
        self.baseline.clone()
    }

    /// The list to write, if given.
    pub(super) fn output(&self) -> Option<&PathBuf> {
        self.write_baseline.as_ref()
    }

    /// Reads the list; `default_path` is used if no option names one.
    pub(super) fn read(&self, default_path: Option<&Path>) -> Result<Baseline, String> {
        let Some(path) = self.baseline.as_deref().or(default_path) else { return Ok(Baseline::default()) };
        let at = |error: String| format!("{}: {error}", shown(path));
        if self.write_baseline.is_some() && system::kind(path).is_err() {
            // The list will be created by `--write-baseline`.
            return Ok(Baseline::default());
        }
        let text = system::read_text(path)?;
        let list: Value = serde_json::from_str(&text).map_err(|error| at(error.to_string()))?;
        let mut known = BTreeMap::new();
        for row in list.as_array().ok_or_else(|| at("not a list of findings".to_owned()))? {
            let text = |key: &str| row[key].as_str().map(str::to_owned);
            let (Some(file), Some(rule), Some(block), Some(count)) =
                (text("file"), text("rule"), text("block"), row["count"].as_u64())
            else {
                return Err(at(format!(
                    "expected an object with `file`, `rule`, `block` and `count`, found {row}"
                )));
            };
            *known.entry((file, rule, block)).or_default() += count as usize;
        }
        Ok(Baseline { folder: folder_of(path), known })
    }

    /// The entries for all findings of a file. Empty if no list is to be written.
    pub(super) fn entries(&self, subject: &Subject) -> Vec<Entry> {
        let Some(list) = &self.write_baseline else { return Vec::new() };
        let (folder, lines) = (folder_of(list), LineIndex::new(&subject.text));
        subject.findings.iter().filter_map(|one| entry(&folder, subject, &lines, one)).collect()
    }

    /// Writes the list, sorted by file, rule and block, one entry per line.
    pub(super) fn write(&self, entries: Vec<Entry>) -> Result<(), String> {
        let Some(path) = &self.write_baseline else { return Ok(()) };
        let mut counts: BTreeMap<Entry, usize> = BTreeMap::new();
        for entry in entries {
            *counts.entry(entry).or_default() += 1;
        }
        let rows: Vec<String> = counts
            .iter()
            .map(|((file, rule, block), count)| {
                json!({"file": file, "rule": rule, "block": block, "count": count}).to_string()
            })
            .collect();
        let text = if rows.is_empty() { "[]\n".to_owned() } else { format!("[\n{}\n]\n", rows.join(",\n")) };
        super::super::save(Some(path), text.as_bytes())
    }
}

impl Baseline {
    /// Removes the known findings of a file, each as often as it is listed.
    pub(super) fn remove_known(&self, subject: &mut Subject) {
        if self.known.is_empty() {
            return;
        }
        let mut left = BTreeMap::new();
        let lines = LineIndex::new(&subject.text);
        let findings = std::mem::take(&mut subject.findings);
        let is_new = |one: &Finding| {
            let Some((file, rule, block)) = entry(&self.folder, subject, &lines, one) else { return true };
            let key = (file, rule.to_owned(), block);
            let known = self.known.get(&key).copied().unwrap_or(0);
            let left = left.entry(key).or_insert(known);
            let is_known = *left > 0;
            *left -= usize::from(is_known);
            !is_known
        };
        subject.findings = findings.into_iter().filter(is_new).collect();
    }
}

/// The absolute path of the folder that contains a list.
fn folder_of(list: &Path) -> PathBuf {
    let mut folder = system::absolute(list).unwrap_or_else(|_| list.to_owned());
    folder.pop();
    folder
}

/// The entry of a finding; `None` if it is not a fault. The file name is relative to a folder if it is inside.
pub(super) fn entry(folder: &Path, subject: &Subject, lines: &LineIndex, one: &Finding) -> Option<Entry> {
    let text = &subject.text;
    let line = match &one.what {
        What::Message(message) => lines.line_of(message.span.start.min(text.len() as u32)),
        What::Remark(remark) => remark.place.0.saturating_sub(1).min(lines.len() - 1),
        What::InferredStock(..) => return None,
    };
    let place = lines.line(text, line);
    let block = String::from_utf8_lossy(&text[place.start as usize..place.end as usize]);
    let block: String = block.split_whitespace().collect();
    let without_number = block
        .strip_prefix(['N', 'n'])
        .map_or(&*block, |rest| rest.trim_start_matches(|letter: char| letter.is_ascii_digit()));
    // Relative to the folder of the list, so that the working directory does not matter.
    let name = system::absolute(Path::new(&subject.name)).ok();
    let name = name.and_then(|name| name.strip_prefix(folder).ok()?.to_str().map(str::to_owned));
    let name = name.unwrap_or_else(|| subject.name.clone()).replace('\\', "/");
    Some((name, one.slug()?, without_number.to_owned()))
}
