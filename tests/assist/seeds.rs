//! The first word of each kind in every program of the seeds, marked, and the help for it.

use std::collections::BTreeSet;
use std::fmt::Write;
use std::fs;

use expect_test::expect_file;
use gcode_playground::run::replay::VisitChoice;
use gcode_playground::sentences::Language;
use gcode_playground::setup::Setup;

use super::asking::Asking;
use super::fixtures;

const FILE: &str = "seeds.help";

/// The marked words of a program. Letter and title define the kind of a word.
fn words(id: &str) -> String {
    let read = |file: &str| fs::read_to_string(format!("tests/programs/{id}/{file}")).expect("a file");
    let setup = Setup::from_json(&read("setup.json")).expect("a setup");
    let text = read("program.nc");
    let mut asking = Asking::new(&text, setup);
    let (mut kinds, mut out) = (BTreeSet::new(), String::new());
    for (at, letter) in
        text.bytes().enumerate().filter(|(_, byte)| byte.is_ascii_uppercase() || *byte == b'#')
    {
        let (_, block) = asking.found(at as u32, VisitChoice::Usual);
        let begins = block.words.iter().any(|word| word.span.start == at as u32) || letter == b'#';
        let Some(english) = asking.word(at as u32, VisitChoice::Usual, Language::English).filter(|_| begins)
        else {
            continue;
        };
        if english.from as usize > at || !kinds.insert((letter, english.title.clone())) {
            continue;
        }
        let line = text[..at].matches('\n').count();
        let start = text[..at].rfind('\n').map_or(0, |end| end + 1);
        let rest = text[at..].lines().next().unwrap_or_default();
        let _ = writeln!(out, "{} {}$0{rest}", line + 1, &text[start..at]);
        let value = |value: Option<String>| value.map_or_else(String::new, |value| format!(" = {value}"));
        let _ = writeln!(out, "    {}: {}{}", english.word, english.title, value(english.value));
        for language in [Language::Chinese, Language::Russian] {
            let help = asking.word(at as u32, VisitChoice::Usual, language).expect("the same word");
            let _ = writeln!(out, "    {}{}", help.title, value(help.value));
        }
    }
    out
}

#[test]
fn each_kind_of_word_in_every_program_of_the_seeds_is_explained_as_committed() {
    let seeds: Vec<_> = fixtures::gallery().into_iter().filter(|id| id.starts_with("s0")).collect();
    assert!(seeds.len() >= 25, "{seeds:?}");
    let answered: String = seeds.iter().map(|id| format!("## {id}\n{}\n", words(id))).collect();
    expect_file![FILE].assert_eq(&answered);
}
