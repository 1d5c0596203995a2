//! The glossary: `www/docs/glossary.md` is complete, and the words that it lists as "not" to be used appear in
//! no document, rule file, message or string that users read.
#[path = "glossary/phrase.rs"]
mod phrase;

use crate::project;
use crate::texts;
use std::collections::BTreeMap;

use phrase::{Language, Phrase};
use texts::Text;

/// The cells of all rows of the tables of terms.
fn rows() -> Vec<Vec<String>> {
    let text = project::source("www/docs/glossary.md");
    let rows = text.lines().filter(|line| line.starts_with("| ") && line.matches('|').count() == 8);
    let cells = |row: &str| row.trim_matches('|').split('|').map(|cell| cell.trim().to_owned()).collect();
    rows.map(cells).filter(|row: &Vec<String>| row[0] != "en").collect()
}

/// The forbidden words.
fn forbidden() -> Vec<Phrase> {
    let mut found = Vec::new();
    for row in rows() {
        for (column, language) in [(4, Language::English), (5, Language::Chinese), (6, Language::Russian)] {
            let phrases = row[column].split(';').map(str::trim).filter(|phrase| !phrase.is_empty());
            found.extend(phrases.map(|phrase| Phrase::new(language, phrase)));
        }
    }
    found
}

/// Files that are not searched, with the reason.
const LEFT_OUT: [(&str, &str); 2] =
    [("www/docs/glossary.md", "it lists the words"), ("tests/glossary", "its tests use the words")];

/// The texts that are searched, each with its prose in lower case.
fn searched() -> Vec<(Text, String)> {
    let left_out = |text: &Text| LEFT_OUT.iter().any(|(file, _)| text.file.starts_with(file));
    let mut texts = texts::all();
    texts.retain(|text| !left_out(text));
    let lower_case = |text: Text| {
        let lower_case = text.prose.to_lowercase();
        (text, lower_case)
    };
    texts.into_iter().map(lower_case).collect()
}

/// The matches of a phrase, as `file:line: the line`.
fn places(phrase: &Phrase, texts: &[(Text, String)]) -> Vec<String> {
    let mut places = Vec::new();
    for (text, lower_case) in texts {
        let lines = phrase.find(lower_case).into_iter().map(|at| text.line_at(at));
        places.extend(lines.map(|(number, line)| format!("{}:{number}: {line}", text.file)));
    }
    places
}

#[test]
fn words_that_are_not_used_are_not_in_the_texts() {
    let texts = searched();
    assert!(texts.len() > 5000, "only {} texts", texts.len());
    let found = forbidden().into_iter().filter_map(|phrase| {
        let places = places(&phrase, &texts);
        (!places.is_empty()).then(|| format!("`{}`:\n    {}", phrase.words, places.join("\n    ")))
    });
    let found: Vec<_> = found.collect();
    assert!(found.is_empty(), "the glossary has another word for these:\n{}", found.join("\n"));
}

#[test]
fn the_glossary_has_every_language_for_every_term() {
    let rows = rows();
    assert!(rows.len() > 60, "{}", rows.len());
    let mut terms = BTreeMap::new();
    for row in &rows {
        assert_eq!(row.len(), 7, "{row:?}");
        assert!(row[..3].iter().all(|cell| !cell.is_empty()), "a language is missing: {row:?}");
        assert!(terms.insert(&row[0], row).is_none(), "`{}` appears twice", row[0]);
    }
    let phrases = forbidden();
    assert!(phrases.len() > 50, "{}", phrases.len());
    for (at, phrase) in phrases.iter().enumerate() {
        let first = phrases.iter().position(|other| other == phrase);
        assert_eq!(first, Some(at), "`{}` is listed twice", phrase.words);
    }
}

#[test]
fn no_term_contains_a_word_that_is_not_used() {
    let phrases = forbidden();
    for row in rows() {
        for cell in &row[..3] {
            let bad = phrases.iter().find(|phrase| !phrase.find(&cell.to_lowercase()).is_empty());
            assert!(bad.is_none(), "`{cell}` contains {bad:?}");
        }
    }
}
