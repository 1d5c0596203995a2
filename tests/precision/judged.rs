//! What a list of judged messages says of the rules: how many are true, in total and by rule.
//!
//! In: lines of JSON, each with `file` (the first twelve digits of the SHA-256 of a real program), `line`,
//! `rule`, `verdict` (`true`, `false`, `unsure`) and `reason`. Out: the bounds that it breaks.

use std::collections::BTreeMap;

use serde::Deserialize;

/// One message of a real program, judged by somebody other than the author of its rule.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Judged {
    file: String,
    line: u32,
    rule: String,
    verdict: Verdict,
    reason: String,
}

#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq)]
#[serde(rename_all = "lowercase")]
enum Verdict {
    True,
    False,
    Unsure,
}

/// So many messages have to be judged.
const ENOUGH: usize = 150;
/// At most one in so many is false.
const ONE_IN: usize = 20;
/// A rule with so many messages must be right in `SHARE` percent of them.
const MANY: usize = 5;
const SHARE: usize = 80;

/// Reads a list. The error names the row.
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

/// The bounds that a list breaks, in words. What nobody could decide counts as a message, but not
/// as a true one of its rule.
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
    let wrong = list.iter().filter(|row| row.verdict == Verdict::False).count();
    if wrong * ONE_IN > list.len() {
        broken.push(format!("{wrong} of {} are false", list.len()));
    }
    let mut rules: BTreeMap<&str, (usize, usize)> = BTreeMap::new();
    for row in list {
        let (all, right) = rules.entry(&row.rule).or_default();
        *all += 1;
        *right += usize::from(row.verdict == Verdict::True);
    }
    for (rule, (all, right)) in rules {
        if all >= MANY && right * 100 < all * SHARE {
            broken.push(format!("{rule}: {right} of {all} are true"));
        }
    }
    broken
}

/// A list in which so many messages of a rule have these verdicts.
fn list(rules: &[(&str, usize, usize, usize)]) -> Vec<Judged> {
    let mut text = String::new();
    for (rule, right, wrong, unsure) in rules {
        let verdicts = [("true", right), ("false", wrong), ("unsure", unsure)];
        let verdicts = verdicts.into_iter().flat_map(|(verdict, &count)| std::iter::repeat_n(verdict, count));
        for (line, verdict) in verdicts.enumerate() {
            let line = line + 1;
            text += &format!(
                "{{\"file\": \"0123456789ab\", \"line\": {line}, \"rule\": \"{rule}\", \"verdict\": \"{verdict}\", \"reason\": \"-\"}}\n"
            );
        }
    }
    read(&text).expect("a list")
}

#[test]
fn one_false_message_in_twenty_is_the_most() {
    assert_eq!(broken_bounds(&list(&[("a", 38, 2, 0)]), 40), [""; 0]);
    assert_eq!(broken_bounds(&list(&[("a", 37, 3, 0)]), 40), ["3 of 40 are false"]);
    assert_eq!(broken_bounds(&list(&[("a", 39, 0, 0)]), 40), ["39 messages are judged; 40 are needed"]);
    assert_eq!(broken_bounds(&list(&[("a", 149, 0, 0)]), ENOUGH).len(), 1);
}

#[test]
fn a_rule_with_many_messages_is_mostly_right() {
    assert_eq!(broken_bounds(&list(&[("a", 4, 1, 0), ("b", 40, 0, 0)]), 0), [""; 0]);
    assert_eq!(broken_bounds(&list(&[("a", 3, 2, 0), ("b", 40, 0, 0)]), 0), ["a: 3 of 5 are true"]);
    assert_eq!(broken_bounds(&list(&[("a", 3, 0, 2), ("b", 40, 0, 0)]), 0), ["a: 3 of 5 are true"]);
    // Too few to say anything.
    assert_eq!(broken_bounds(&list(&[("a", 2, 2, 0), ("b", 40, 0, 0)]), 0), [""; 0]);
}

#[test]
fn a_list_that_cannot_be_trusted_is_refused() {
    let row = |file: &str, line: u32, verdict: &str, reason: &str| {
        format!(
            r#"{{"file": "{file}", "line": {line}, "rule": "a", "verdict": "{verdict}", "reason": "{reason}"}}"#
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
