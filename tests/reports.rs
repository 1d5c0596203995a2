//! The formats of `gcode-playground check` for other programs, and the addresses of rule pages in them.
use serde_json::{Value, json};

use crate::folder::{FAULTY, Folder, out, rows};

/// The emoji is four bytes in UTF-8 and two UTF-16 units.
const MISREAD: &str = "O1\nM3 S500\n(😀) GO0 X5\nM30\n";

fn parsed(folder: &Folder, arguments: &[&str]) -> Value {
    serde_json::from_str(&out(&folder.check(arguments))).expect("JSON")
}

#[test]
fn concise_has_one_line_for_each_finding() {
    let folder = Folder::new("concise").with("a.nc", FAULTY).with("b.nc", MISREAD);
    let text = out(&folder.check(&[".", "--format", "concise"]));
    let lines: Vec<_> = text.lines().collect();
    let expected = [
        "a.nc:3:4: error PS0005 `X` has no number.",
        "b.nc:3:6: error E-OCR `GO0` has a letter where the digit 0 belongs.",
        "2 errors in 2 files, 1 fixable with --fix",
    ];
    assert_eq!(lines, expected);
    let quiet = out(&folder.check(&[".", "--format", "concise", "--quiet"]));
    assert_eq!(quiet.lines().collect::<Vec<_>>(), expected[..2]);
}

#[test]
fn gitlab_has_an_issue_for_each_finding() {
    let folder = Folder::new("gitlab").with("a.nc", FAULTY).with("sub/b.nc", "O2\nM3 S500\nG0 X50 Z2\nM30\n");
    let issues = parsed(&folder, &[".", "--format", "gitlab"]);
    let [issue] = &issues.as_array().expect("an array")[..] else { panic!("{issues}") };
    let text = "`X` has no number. Every address letter needs a value after it. A comment belongs in brackets: `( … )`.";
    let expected = json!({
        "description": text,
        "check_name": "number-missing",
        // FNV-1a of "a.nc", "number-missing", "G0X" and "1", each with a zero after it.
        "fingerprint": "fa30be58557e412b",
        "severity": "major",
        "location": {"path": "a.nc", "lines": {"begin": 3, "end": 3}},
    });
    assert_eq!(*issue, expected);
    let none = parsed(&folder, &["sub", "--format", "gitlab"]);
    assert_eq!(none, json!([]));
}

/// A finding keeps its fingerprint if its block moves, is renumbered or written with other blanks.
#[test]
fn a_fingerprint_follows_its_block() {
    let folder = Folder::new("fingerprints");
    let fingerprints = |text: &str| -> Vec<String> {
        std::fs::write(folder.0.join("a.nc"), text).expect("a program");
        let issues = parsed(&folder, &["a.nc", "--format", "gitlab"]);
        let issues = issues.as_array().expect("an array");
        issues.iter().map(|issue| issue["fingerprint"].as_str().expect("a text").to_owned()).collect()
    };
    let expected = ["fa30be58557e412b"];
    assert_eq!(fingerprints(FAULTY), expected);
    assert_eq!(fingerprints("O1\n(REMARK)\nM3 S500\nN30 G0  X\nM30\n"), expected);
    // An equal block is another finding.
    assert_eq!(fingerprints("O1\nM3 S500\nG0 X\nG0 X\nM30\n"), ["fa30be58557e412b", "fa268c58557597b0"]);
    assert_ne!(fingerprints("O1\nM3 S500\nG0 Z\nM30\n"), expected);
}

#[test]
fn rdjson_has_places_in_bytes_and_suggestions() {
    let folder = Folder::new("rdjson").with("a.nc", FAULTY).with("b.nc", MISREAD);
    let report = parsed(&folder, &[".", "--format", "rdjson"]);
    assert_eq!(report["source"], json!({"name": "gcode-playground"}));
    let found = report["diagnostics"].as_array().expect("diagnostics");
    assert_eq!(found.len(), 2);
    let range = |line: u32, start: u32, end: u32| json!({"start": {"line": line, "column": start}, "end": {"line": line, "column": end}});
    assert_eq!(found[0]["location"], json!({"path": "a.nc", "range": range(3, 4, 5)}));
    assert_eq!(
        (&found[0]["severity"], &found[0]["code"], &found[0]["suggestions"]),
        (&json!("ERROR"), &json!({"value": "number-missing"}), &json!([]))
    );
    // `(`, four bytes, `)` and a blank are before the word.
    assert_eq!(found[1]["location"], json!({"path": "b.nc", "range": range(3, 8, 11)}));
    assert_eq!(found[1]["suggestions"], json!([{"range": range(3, 8, 11), "text": "G00"}]));
    let none = Folder::new("rdjson-none").with("a.nc", "O2\nM3 S500\nG0 X50 Z2\nM30\n");
    assert_eq!(parsed(&none, &["a.nc", "--format", "rdjson"])["diagnostics"], json!([]));
}

const TITLE: &str = "An address letter without its number";
const PAGE: &str = "https://a.example/rules/en/number-missing.html";

#[test]
fn json_and_sarif_have_title_help_and_address_of_a_rule() {
    let folder = Folder::new("titles").with("a.nc", FAULTY);
    let row = |arguments: &[&str]| {
        let output = folder.check(&[&["a.nc", "--format", "json"], arguments].concat());
        rows(&output).swap_remove(0)
    };
    let with_address = ["--rules-url", "https://a.example/rules/"];
    assert_eq!((&row(&[])["title"], row(&[]).get("url")), (&json!(TITLE), None));
    assert_eq!(row(&with_address)["url"], PAGE);
    let russian = row(&[&with_address[..], &["--lang", "ru"]].concat());
    assert_eq!(russian["url"], "https://a.example/rules/ru/number-missing.html");
    let rule = |arguments: &[&str]| {
        let report = parsed(&folder, &[&["a.nc", "--format", "sarif"], arguments].concat());
        report["runs"][0]["tool"]["driver"]["rules"][0].clone()
    };
    let (plain, linked) = (rule(&[]), rule(&with_address));
    assert_eq!(plain["shortDescription"], json!({"text": TITLE}));
    let starts = |text: &Value, start: &str| text.as_str().is_some_and(|text| text.starts_with(start));
    assert!(starts(&plain["fullDescription"]["text"], "A word is a letter and a number."), "{plain}");
    for kind in ["text", "markdown"] {
        let help = &plain["help"][kind];
        assert!(starts(help, "The control cannot know where the cut should end."), "{help}");
        assert!(help.as_str().is_some_and(|help| help.contains("\n\nWrite the missing number")), "{help}");
    }
    assert_eq!((plain.get("helpUri"), &linked["helpUri"]), (None, &json!(PAGE)));
    let report = parsed(&folder, &[&["a.nc", "--format", "rdjson"], &with_address[..]].concat());
    assert_eq!(report["diagnostics"][0]["code"]["url"], PAGE);
}

#[test]
fn the_address_of_the_pages_is_set_once_in_the_configuration() {
    let folder = Folder::new("address").with("a.nc", FAULTY);
    let configured = folder.with("gcode-playground.toml", "rules-url = \"https://a.example/rules\"\n");
    let url = |arguments: &[&str]| {
        let output = configured.check(&[&["a.nc", "--format", "json"], arguments].concat());
        rows(&output)[0]["url"].clone()
    };
    assert_eq!(url(&[]), PAGE);
    assert_eq!(url(&["--rules-url", "http://b.example"]), "http://b.example/en/number-missing.html");
    for wrong in ["rules", "javascript:alert(1)", "https://a b"] {
        assert_eq!(configured.check(&["a.nc", "--rules-url", wrong]).status.code(), Some(2), "{wrong}");
    }
}
