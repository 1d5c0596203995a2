//! In: the help of a command, and its usage lines in the reference. Out: the values of each argument in both.

use std::collections::{BTreeMap, BTreeSet};

/// The values of each argument that accepts only certain values: options by their long names, positional
/// arguments under `""`.
pub type Values = BTreeMap<String, BTreeSet<String>>;

/// The values in the long help of a command.
pub fn of_help(help: &str) -> Values {
    let mut found = Values::new();
    let mut argument = String::new();
    let mut is_list = false;
    for line in help.lines().map(str::trim) {
        if line.starts_with('<') || line.starts_with("[<") || line.starts_with('-') && !line.starts_with("- ")
        {
            let long = line.split_whitespace().find(|word| word.starts_with("--"));
            argument = long.unwrap_or_default().to_owned();
            is_list = false;
        }
        if let Some((_, rest)) = line.split_once("[possible values: ") {
            let values = rest.trim_end_matches(']').split(", ").map(str::to_owned);
            found.entry(argument.clone()).or_default().extend(values);
        }
        is_list |= line == "Possible values:";
        if let Some((value, _)) = line.strip_prefix("- ").and_then(|value| value.split_once(':'))
            && is_list
        {
            found.entry(argument.clone()).or_default().insert(value.to_owned());
        }
    }
    found
}

/// The values in the usage lines of a command: `a|b` as a positional argument, or after an option. Options
/// with a placeholder have the values of `table`.
pub fn of_usage(lines: &[&str], table: &Values) -> Values {
    let mut found = Values::new();
    for line in lines {
        let line = line.replace(['[', ']'], " ");
        let mut option = None;
        for word in line.split_whitespace().skip(1) {
            if word.starts_with("--") {
                option = Some(word);
                continue;
            }
            let own = option.take();
            let choices: BTreeSet<String> = match own.and_then(|option| table.get(option)) {
                Some(values) if !word.contains('|') => values.clone(),
                _ if word.contains('|') => word.split('|').map(str::to_owned).collect(),
                _ => continue,
            };
            found.entry(own.unwrap_or_default().to_owned()).or_default().extend(choices);
        }
    }
    found
}

#[test]
fn values_are_read_from_help_and_usage() {
    let values = |pairs: &[(&str, &[&str])]| -> Values {
        let set = |values: &[&str]| values.iter().map(|value| (*value).to_owned()).collect();
        pairs.iter().map(|(name, own)| ((*name).to_owned(), set(own))).collect()
    };
    let long = "Arguments:\n  <KIND>\n      What\n\n      Possible values:\n      - a: One\n      - b: Two\n\n  <FILE>\n      A file\n\nOptions:\n  -l, --lang <LANG>\n      [possible values: en, ru]\n";
    let short = "Options:\n      --lang <LANG>  Language [possible values: en, ru]\n";
    assert_eq!(of_help(long), values(&[("", &["a", "b"]), ("--lang", &["en", "ru"])]));
    assert_eq!(of_help(short), values(&[("--lang", &["en", "ru"])]));
    let table = values(&[("--lang", &["en", "ru"])]);
    let lines = ["do a FILE [--fix [--dry]] [--lang L]", "do b|c FILE [--form x|y]"];
    assert_eq!(
        of_usage(&lines, &table),
        values(&[("", &["b", "c"]), ("--form", &["x", "y"]), ("--lang", &["en", "ru"])])
    );
}
