//! Tests the sentences of all messages, with arguments from the samples of the rule files.
#[path = "../rules/format/mod.rs"]
mod format;
#[path = "../../www/rules/templates.rs"]
mod templates;
#[allow(dead_code, reason = "the build script uses all of it")]
#[path = "../rules/texts.rs"]
mod texts;

use std::collections::BTreeSet;

use super::phrases::Phrase;
use super::{Language, Sentence, labels};
use crate::message::{Message, Value, said};
use crate::units::{Diameter, Unit, number};

include!(concat!(env!("OUT_DIR"), "/example_messages.rs"));

/// The build rejects unknown argument names; this finds unfilled placeholders.
#[test]
fn every_message_is_said_in_every_language_and_unit() {
    for message in example_messages() {
        for language in Language::ALL {
            for unit in [Unit::Millimetre, Unit::Inch] {
                let Sentence { message: said, help } = message.sentence_in(language, unit);
                let help = help.unwrap_or_default();
                assert!(
                    !said.is_empty() && !format!("{said}{help}").contains(['{', '}', '\n']),
                    "{said}\n{help}"
                );
            }
        }
    }
}

#[test]
fn languages_quote_the_same_in_phrases() {
    let sorted = |template: &'static str| {
        let mut names: Vec<&str> = template
            .split('{')
            .skip(1)
            .map(|part| part.split_once('}').expect("a closed placeholder").0)
            .collect();
        names.sort_unstable();
        names.dedup();
        names
    };
    for &phrase in Phrase::ALL {
        let [english, others @ ..] = Language::ALL.map(|language| sorted(language.phrase(phrase)));
        for other in others {
            assert_eq!(english, other, "{phrase:?}");
        }
    }
}

#[test]
fn what_a_message_quotes_is_not_a_template() {
    let text = "{text} {0}".to_owned();
    let message = Message::from(said::PlainText { text }).sentence(Language::English).message;
    assert_eq!(message, "`{text} {0}` is plain text, not a block.");
}

/// The file for the page contains everything to fill the sentences: names, types and templates.
#[test]
fn the_file_of_sentences_for_the_page_says_what_is_said_here() {
    let rules = format::all(env!("CARGO_MANIFEST_DIR")).into_iter().map(|(name, rule)| rule.expect(&name));
    let rules: Vec<_> = rules.collect();
    for (index, language) in Language::ALL.into_iter().enumerate() {
        assert_eq!(format::LANGUAGES[index], language.tag());
        let file: serde_json::Value = serde_json::from_str(&templates::json(&rules, index)).expect("JSON");
        let own: BTreeSet<&str> = file.as_object().expect("an object").keys().map(String::as_str).collect();
        assert_eq!(own, example_messages().iter().map(Message::name).collect());
        for message in example_messages() {
            let own = &file[message.name()];
            assert_eq!(own["rule"], message.slug());
            let filled = |template: &str| {
                let unit = labels::length(Unit::Inch, language);
                let mut text = template.replace("{mm}", unit);
                for (name, value) in message.arguments() {
                    let shown = match (own["arguments"][name].as_str().expect(name), value) {
                        ("text" | "word", Value::Text(text)) => text.into_owned(),
                        ("letter", Value::Letter(letter)) => letter.to_string(),
                        ("count" | "index" | "integer", Value::Count(count)) => count.to_string(),
                        ("program", Value::Program(program)) => format!("{program:04}"),
                        ("number", Value::Number(value)) => number(value),
                        ("length" | "diameter", Value::Length(length)) => number(length / 25.4),
                        (kind, value) => panic!("{value:?} is no {kind}"),
                    };
                    text = text.replace(&format!("{{{name}}}"), &shown);
                }
                text
            };
            let said = message.sentence_in(language, Unit::Inch);
            assert_eq!(filled(own["message"].as_str().expect("a template")), said.message);
            assert_eq!(own["help"].as_str().map(filled), said.help);
        }
    }
}

#[test]
fn a_language_without_a_text_has_the_english_one() {
    let [name, text] = ["no-program-end", include_str!("../rules/no-program-end.md")];
    let whole = format::RuleFile::read(text).expect(name);
    assert_eq!(whole.missing, []);
    // Neither the Russian sentence nor the Russian page.
    let page = text.find("## ru:").expect("a Russian page");
    let lines = text[..page].lines().filter(|line| !line.starts_with("ru"));
    let rule =
        format::RuleFile::read(&lines.map(|line| format!("{line}\n")).collect::<String>()).expect(name);
    assert_eq!(rule.missing.len(), rule.messages.len() + 1, "{:?}", rule.missing);
    assert_eq!(rule.messages[0].sentences[2], whole.messages[0].sentences[0]);
    assert_eq!(rule.page.texts[2], whole.page.texts[0]);
    assert_eq!(rule.page.texts[1], whole.page.texts[1]);
}

#[test]
fn other_texts_are_read_by_enum_and_variant() {
    use texts::Texts;
    let of = |files: [&str; 3]| Texts::of(&files.map(str::to_owned));
    let texts = of([
        "# Words\nRole.Comment: a comment\nEffect.Done:\n",
        "Role.Comment: 注释\nEffect.Done:\n",
        "Effect.Done:\n",
    ]);
    assert_eq!(texts.mistakes, Vec::<String>::new());
    assert_eq!(texts.missing, ["src/sentences/ru.txt: Role.Comment"]);
    assert_eq!(texts.list[0].said, ["a comment", "注释", "a comment"]);
    assert_eq!(texts.list[1].said, ["", "", ""]);
    let texts = of([
        "Role.Comment: a\nRole.Comment: b\nno key\n",
        "Role.Other: 其\n",
        "Role.Comment: а\nRole.Comment: б\n",
    ]);
    let lines: Vec<_> = texts
        .mistakes
        .iter()
        .map(|mistake| mistake.splitn(3, ':').take(2).collect::<Vec<_>>().join(":"))
        .collect();
    assert_eq!(
        lines,
        [
            "src/sentences/en.txt:2",
            "src/sentences/en.txt:3",
            "src/sentences/zh.txt:1",
            "src/sentences/ru.txt:2"
        ]
    );
}
