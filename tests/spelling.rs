//! The spelling of the English and Russian texts, checked by hunspell with its dictionaries `en_GB` and
//! `ru_RU`.
//!
//! `tests/spelling/en.txt` and `tests/spelling/ru.txt` contain the words that a dictionary lacks, sorted, one
//! per line: terms, abbreviations, names. A lower-case word there is also accepted with capital letters.
//! Comments are not checked.
#[path = "spelling/hunspell.rs"]
mod hunspell;
#[path = "spelling/words.rs"]
mod words;

use crate::project;
use crate::texts;
use std::collections::{BTreeMap, BTreeSet};

use words::Script;

/// A language whose spelling is checked.
struct Language {
    dictionary: &'static str,
    script: Script,
    /// The words that the dictionary lacks.
    list: &'static str,
}

const ENGLISH: Language =
    Language { dictionary: "en_GB", script: Script::Latin, list: "tests/spelling/en.txt" };
const RUSSIAN: Language =
    Language { dictionary: "ru_RU", script: Script::Cyrillic, list: "tests/spelling/ru.txt" };

/// The words of a script in all texts, each with its first occurrence.
fn used(script: Script) -> BTreeMap<String, String> {
    let mut found = BTreeMap::new();
    for text in texts::all() {
        for (at, word) in words::words(&text.prose, script) {
            let place = || {
                let (number, line) = text.line_at(at);
                format!("{}:{number}: {line}", text.file)
            };
            found.entry(word).or_insert_with(place);
        }
    }
    found
}

fn check(language: &Language) {
    let text = project::source(language.list);
    let list: Vec<&str> = text.lines().collect();
    let sorted: BTreeSet<&str> = list.iter().copied().collect();
    assert!(list.iter().eq(sorted.iter()), "{} is not sorted, or a word is there twice", language.list);

    let used = used(language.script);
    assert!(used.len() > 1000, "only {} words of {:?} script", used.len(), language.script);
    let listed = |word: &String| sorted.contains(word.as_str()) || sorted.contains(&*word.to_lowercase());
    let unknown = hunspell::unknown(language.dictionary, used.keys());
    let wrong = unknown.iter().filter(|word| !listed(word));
    let wrong: Vec<String> = wrong.map(|word| format!("{word} in {}", used[word])).collect();
    assert!(wrong.is_empty(), "misspelled, or missing in {}:\n{}", language.list, wrong.join("\n"));
}

#[test]
fn english_is_spelled_as_the_dictionary_has_it() {
    check(&ENGLISH);
}

#[test]
fn russian_is_spelled_as_the_dictionary_has_it() {
    check(&RUSSIAN);
}

#[test]
fn misspellings_would_be_found() {
    let unknown = |dictionary, words: &[&str]| {
        hunspell::unknown(dictionary, words.iter().map(|word| (*word).to_owned()).collect::<Vec<_>>().iter())
    };
    assert_eq!(unknown("en_GB", &["spindle", "spindel", "Spindle", "colour", "color"]), ["color", "spindel"]);
    assert_eq!(unknown("ru_RU", &["шпиндель", "шпиндиль", "Подача", "передаёт"]), ["шпиндиль"]);
}
