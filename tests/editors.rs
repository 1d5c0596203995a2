//! The extension for Visual Studio Code: its description agrees with the command line, the server and the
//! documents.
use std::collections::BTreeSet;

use crate::project::source;
use gcode_playground::sentences::{Language, server};
use serde_json::Value;

fn description() -> Value {
    serde_json::from_str(&source("editors/vscode/package.json")).expect("JSON")
}

/// The strings in the list that follows a text in a source.
fn list(source: &str, begin: &str) -> Vec<String> {
    let (_, rest) = source.split_once(begin).expect(begin);
    let words = rest.split(';').next().expect("a list");
    words.split('"').skip(1).step_by(2).map(str::to_owned).collect()
}

#[test]
fn the_language_has_the_endings_of_the_command_line() {
    let language = &description()["contributes"]["languages"][0];
    let endings: Vec<&str> =
        language["extensions"].as_array().expect("a list").iter().flat_map(Value::as_str).collect();
    let known = list(&source("src/cli/subprograms.rs"), "const ENDINGS: &[&str] =");
    let known: Vec<String> = known.iter().map(|ending| format!(".{ending}")).collect();
    assert_eq!(endings, known);
}

#[test]
fn the_documents_list_the_settings() {
    let settings = &description()["contributes"]["configuration"]["properties"];
    let settings: BTreeSet<&str> =
        settings.as_object().expect("settings").keys().map(String::as_str).collect();
    assert!(settings.len() > 2, "{settings:?}");
    for document in ["editors/vscode/README.md", "www/docs/editors.md"] {
        let text = source(document);
        let rows = text.lines().filter_map(|line| line.strip_prefix("| `gcode-playground."));
        let listed: BTreeSet<String> =
            rows.filter_map(|row| Some(format!("gcode-playground.{}", row.split('`').next()?))).collect();
        assert_eq!(listed.iter().map(String::as_str).collect::<BTreeSet<_>>(), settings, "{document}");
    }
}

/// With and without the native program, a user finds the action that applies all safe fixes under the same name.
#[test]
fn the_library_fixes_under_the_name_of_the_server() {
    let words = source("editors/vscode/src/words.ts");
    for language in [Language::English, Language::Chinese, Language::Russian] {
        let title = format!("fixAll: '{}'", server::fix_all(language));
        assert!(words.contains(&title), "{title}");
    }
    let library = source("editors/vscode/src/library.ts");
    let kind = list(&source("src/server/client.rs"), "pub const FIX_ALL: &str =").remove(0);
    let own = kind.strip_prefix("source.fixAll.").expect("a kind of fixes");
    assert!(library.contains(&format!("CodeActionKind.SourceFixAll.append('{own}')")), "{kind}");
}

/// Each text of the description is there in three languages, and no other.
#[test]
fn the_description_has_three_languages() {
    let text = source("editors/vscode/package.json");
    let named: BTreeSet<&str> =
        text.split("\"%").skip(1).filter_map(|rest| rest.split("%\"").next()).collect();
    assert!(named.len() > 3, "{named:?}");
    for language in ["", ".zh-cn", ".ru"] {
        let texts: Value =
            serde_json::from_str(&source(&format!("editors/vscode/package.nls{language}.json")))
                .expect("JSON");
        let texts = texts.as_object().expect("texts");
        assert_eq!(texts.keys().map(String::as_str).collect::<BTreeSet<_>>(), named, "{language}");
    }
}
