//! Evaluates a list of judged messages: how many are true, in total and per rule.
//!
//! In: JSON lines, each with `file` (the first twelve digits of the SHA-256 of a real program), `line`,
//! `rule`, `severity`, `verdict` (`true`, `defensible`, `false`, `unsure`) and `reason`. Out: the bounds that
//! the list violates.

use std::collections::BTreeMap;

use serde::Deserialize;

/// One message of a real program, judged by a person other than the author of its rule.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Judged {
    file: String,
    line: u32,
    rule: String,
    severity: Severity,
    verdict: Verdict,
    reason: String,
}

#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq)]
#[serde(rename_all = "lowercase")]
enum Severity {
    Error,
    Warning,
    Info,
}

#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq)]
#[serde(rename_all = "lowercase")]
enum Verdict {
    True,
    /// Not what the author of the program meant, but a reasonable reading.
    Defensible,
    False,
    Unsure,
}

impl Judged {
    fn is_right(&self) -> bool {
        matches!(self.verdict, Verdict::True | Verdict::Defensible)
    }
}

/// Minimum number of judged messages.
const ENOUGH: usize = 300;
/// Minimum share of messages that are true or defensible, percent.
const SHARES: [(Severity, usize); 2] = [(Severity::Error, 97), (Severity::Warning, 95)];
/// At least `SHARE` percent of the messages of a rule must be true or defensible if it has `MANY` of them.
const MANY: usize = 5;
const SHARE: usize = 80;

/// Parses a list. The error names the row.
fn read(list: &str) -> Result<Vec<Judged>, String> {
    let rows = list.lines().enumerate().filter(|(_, row)| !row.trim().is_empty());
    rows.map(|(at, row)| {
        let judged: Judged = serde_json::from_str(row).map_err(|error| format!("row {}: {error}", at + 1))?;
        let is_hash = judged.file.len() == 12 && judged.file.bytes().all(|byte| byte.is_ascii_hexdigit());
        match is_hash && judged.line > 0 && !judged.reason.trim().is_empty() {
            true => Ok(judged),
            false => {
                Err(format!("row {}: a hash of twelve digits, a line from 1 and a reason are needed", at + 1))
            }
        }
    })
    .collect()
}

/// The violated bounds, as text. Messages judged `unsure` count in the total, but not as true ones of their
/// rule.
fn broken_bounds(list: &[Judged], enough: usize) -> Vec<String> {
    let mut broken = Vec::new();
    if list.len() < enough {
        broken.push(format!("{} messages are judged; {enough} are needed", list.len()));
    }
    let mut places = std::collections::BTreeSet::new();
    for row in list {
        if !places.insert((&row.file, row.line, &row.rule)) {
            broken.push(format!("{} line {} {} stands twice", row.file, row.line, row.rule));
        }
    }
    for (severity, share) in SHARES {
        let all = list.iter().filter(|row| row.severity == severity);
        let (all, wrong) =
            all.fold((0, 0), |(all, wrong), row| (all + 1, wrong + usize::from(!row.is_right())));
        if wrong * 100 > all * (100 - share) {
            broken.push(format!("{wrong} of {all} of {severity:?} are false or unsure"));
        }
    }
    let mut rules: BTreeMap<&str, (usize, usize)> = BTreeMap::new();
    for row in list {
        let (all, right) = rules.entry(&row.rule).or_default();
        *all += 1;
        *right += usize::from(row.is_right());
    }
    for (rule, (all, right)) in rules {
        if all >= MANY && right * 100 < all * SHARE {
            broken.push(format!("{rule}: {right} of {all} are true"));
        }
    }
    broken
}

/// A list of warnings: for each rule the numbers of true, false and unsure messages.
fn list(rules: &[(&str, usize, usize, usize)]) -> Vec<Judged> {
    list_of("warning", rules)
}

fn list_of(severity: &str, rules: &[(&str, usize, usize, usize)]) -> Vec<Judged> {
    let mut text = String::new();
    for (rule, right, wrong, unsure) in rules {
        let verdicts = [("true", right), ("false", wrong), ("unsure", unsure)];
        let verdicts = verdicts.into_iter().flat_map(|(verdict, &count)| std::iter::repeat_n(verdict, count));
        for (line, verdict) in verdicts.enumerate() {
            let line = line + 1;
            text += &format!(
                "{{\"file\": \"0123456789ab\", \"line\": {line}, \"rule\": \"{rule}\", \"severity\": \"{severity}\", \"verdict\": \"{verdict}\", \"reason\": \"-\"}}\n"
            );
        }
    }
    read(&text).expect("a list")
}

#[test]
fn one_warning_in_twenty_and_three_errors_in_a_hundred_may_be_false() {
    assert_eq!(broken_bounds(&list(&[("a", 38, 2, 0)]), 40), [""; 0]);
    assert_eq!(broken_bounds(&list(&[("a", 37, 3, 0)]), 40), ["3 of 40 of Warning are false or unsure"]);
    assert_eq!(broken_bounds(&list_of("error", &[("a", 97, 3, 0)]), 40), [""; 0]);
    assert_eq!(
        broken_bounds(&list_of("error", &[("a", 38, 2, 0)]), 40),
        ["2 of 40 of Error are false or unsure"]
    );
    assert_eq!(broken_bounds(&list(&[("a", 39, 0, 0)]), 40), ["39 messages are judged; 40 are needed"]);
    assert_eq!(broken_bounds(&list(&[("a", 299, 0, 0)]), ENOUGH).len(), 1);
}

#[test]
fn a_rule_with_many_messages_is_mostly_right() {
    assert_eq!(broken_bounds(&list(&[("a", 4, 1, 0), ("b", 40, 0, 0)]), 0), [""; 0]);
    assert_eq!(broken_bounds(&list(&[("a", 3, 2, 0), ("b", 60, 0, 0)]), 0), ["a: 3 of 5 are true"]);
    assert_eq!(broken_bounds(&list(&[("a", 3, 0, 2), ("b", 60, 0, 0)]), 0), ["a: 3 of 5 are true"]);
    // Too few to judge.
    assert_eq!(broken_bounds(&list(&[("a", 2, 2, 0), ("b", 40, 0, 0)]), 0), [""; 0]);
}

#[test]
fn a_list_that_cannot_be_trusted_is_refused() {
    let row = |file: &str, line: u32, verdict: &str, reason: &str| {
        format!(
            r#"{{"file": "{file}", "line": {line}, "rule": "a", "severity": "info", "verdict": "{verdict}", "reason": "{reason}"}}"#
        )
    };
    assert!(read(&row("0123456789ab", 1, "true", "so it is")).is_ok());
    for wrong in [
        row("0123456789ab", 1, "", "not judged"),
        row("0123456789ab", 1, "true", ""),
        row("part.nc", 1, "true", "a name"),
        row("0123456789ab", 0, "true", "no line"),
    ] {
        assert!(read(&wrong).is_err(), "{wrong}");
    }
    let twice = [row("0123456789ab", 1, "true", "x"), row("0123456789ab", 1, "true", "x")].join("\n");
    assert_eq!(broken_bounds(&read(&twice).expect("a list"), 0), ["0123456789ab line 1 a stands twice"]);
}

#[test]
fn the_judged_messages_of_real_programs_hold_the_bounds() {
    let list = read(include_str!("judged.jsonl")).expect("the list");
    let broken = broken_bounds(&list, ENOUGH);
    assert!(broken.is_empty(), "{broken:#?}");
}
