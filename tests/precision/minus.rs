//! `minus-missing` on programs judged by hand: no false alarm, and at least 95 % right.

use gcode_playground::analyze;
use gcode_playground::message::Diagnostic;
use gcode_playground::setup::Setup;

/// A program and the verdict of a machinist.
struct Case {
    title: String,
    /// The word that lost its minus.
    lost: Option<String>,
    text: String,
}

fn cases() -> Vec<Case> {
    let (_, cases) = include_str!("minus.txt").split_once("\n\n## ").expect("a first case");
    let case = |part: &str| {
        let (title, text) = part.split_once('\n').expect("a program");
        let (verdict, _) = title.split_once(": ").expect("a verdict");
        let lost = match verdict.split_once(' ') {
            Some(("lost", word)) => Some(word.to_owned()),
            None if verdict == "right" => None,
            _ => panic!("neither `lost WORD` nor `right`: {title}"),
        };
        Case { title: title.to_owned(), lost, text: format!("{}\n", text.trim_end()) }
    };
    cases.split("\n## ").map(case).collect()
}

/// The words reported to have lost a minus, each with its fix.
fn told(text: &str) -> Vec<(String, String)> {
    let analysis = analyze(text.as_bytes(), &Setup::default());
    let minus = |told: &&Diagnostic| told.message.slug() == "minus-missing";
    let row = |told: &Diagnostic| {
        let fix = told.fixes.first().map(|fix| fix.edits[0].text.clone());
        (told.span.quote(text.as_bytes()), fix.unwrap_or_default())
    };
    analysis.diagnostics.iter().filter(minus).map(row).collect()
}

#[test]
fn a_lost_minus_is_told_and_a_meant_plus_is_not() {
    let cases = cases();
    let lost = cases.iter().filter(|case| case.lost.is_some()).count();
    assert!(lost >= 20 && cases.len() - lost >= 20, "{lost} of {}", cases.len());
    let (mut wrong_alarms, mut missed) = (Vec::new(), Vec::new());
    for case in &cases {
        let told = told(&case.text);
        let expected: Vec<(String, String)> =
            case.lost.iter().map(|word| (word.clone(), word.replace('Z', "Z-"))).collect();
        if told.iter().any(|told| !expected.contains(told)) {
            wrong_alarms.push((&case.title, told));
        } else if told != expected {
            missed.push(&case.title);
        }
    }
    assert!(wrong_alarms.is_empty(), "wrong alarms: {wrong_alarms:#?}; missed: {missed:#?}");
    assert!(missed.len() * 20 <= cases.len(), "missed: {missed:#?}");
}
