//! Every program of `tests/programs`, natively: motions, final point, messages, spindle, and the committed
//! output, which the wasm tests use as well.

use crate::fixtures;
use crate::project::source;
use expect_test::expect_file;
use fixtures::{Program, all, check_messages, compare, folder, gallery, same};
use gcode_playground::api::{self, Places};
use gcode_playground::expand::expand;
use gcode_playground::run::Run;
use gcode_playground::sentences::Language;
use gcode_playground::setup::Setup;
use gcode_playground::source::LineIndex;
use gcode_playground::{analyze, run::Analysis};
use serde_json::{Value, json};

fn analysis(program: &Program) -> Analysis {
    analyze(program.text.as_bytes(), &Setup::from_json(&program.setup).expect(&program.id))
}

fn motion_rows(analysis: &Analysis) -> Vec<Value> {
    api::motions(&analysis.motions, &analysis.setup.machine)
        .map(|row| serde_json::to_value(row).expect("row"))
        .collect()
}

fn message_rows(text: &str, analysis: &Analysis) -> Vec<Value> {
    let lines = LineIndex::new(text.as_bytes());
    let places = Places { text: text.as_bytes(), lines: &lines };
    let row = |found| serde_json::to_value(places.diagnostic(found, Language::English)).expect("row");
    analysis.diagnostics.iter().map(row).collect()
}

#[test]
fn motions_are_the_expected_ones() {
    let mut checked = 0;
    for program in all() {
        let found = motion_rows(&analysis(&program));
        compare(&program.motions, &found).unwrap_or_else(|why| panic!("{}: {why}", program.id));
        if let (Some(last), Some(end)) = (found.last(), program.expect.get("final")) {
            same(end, &last["to"]).unwrap_or_else(|why| panic!("{}: final point: {why}", program.id));
        }
        checked += 1;
    }
    assert!(checked >= 25, "only {checked} programs were checked");
}

#[test]
fn messages_are_the_expected_ones() {
    for program in all() {
        let mut analysis = analysis(&program);
        analysis.check_at_machine();
        let found = message_rows(&program.text, &analysis);
        check_messages(&program, &found).unwrap_or_else(|why| panic!("{}: {why}", program.id));
    }
}

/// A program with expanded cycles makes the same motions.
#[test]
fn expanded_programs_make_the_same_motions() {
    for program in all() {
        let setup = Setup::from_json(&program.setup).expect(&program.id);
        let plain = expand(program.text.as_bytes(), &setup);
        let (before, after) = (analysis(&program), analyze(plain.as_bytes(), &setup));
        let id = &program.id;
        assert_eq!(before.motions.len(), after.motions.len(), "{id}:\n{plain}");
        for (a, b) in before.motions.iter().zip(after.motions.iter()) {
            assert_eq!(a.kind, b.kind, "{id}:\n{plain}");
            let apart = a.to.distance(b.to).max(a.from.distance(b.from));
            assert!(apart <= 0.001, "{id}: {apart} mm apart at {:?}\n{plain}", a.to);
            // Blocks between G12.1 and G13.1 are not expanded.
            let plain = b.cycle.is_none() && (b.programmed.is_none() || b.virtual_move().is_some());
            assert!(plain, "{id}: not plain");
        }
    }
}

#[test]
fn the_spindle_is_as_commanded() {
    let mut checked = 0;
    for program in all() {
        for expected in program.expect["spindle"].as_array().into_iter().flatten() {
            let line = expected["line"].as_u64().expect("line") as usize;
            let head = program.text.lines().take(line).collect::<Vec<_>>().join("\n");
            let mut run = Run::new(head.into_bytes(), Setup::from_json(&program.setup).expect("setup"));
            while !run.advance(1) {}
            let spindle = run.state().spindle;
            if let Some(clamp) = expected["clamp"].as_f64() {
                assert_eq!(spindle.highest, Some(clamp), "{}", program.id);
            }
            if let Some(speed) = expected["v"].as_f64() {
                assert!(spindle.surface && spindle.cutting_speed == speed, "{}", program.id);
                // n = 1000·v / (π·D), limited by the maximum speed.
                let free = 1000.0 * speed / (std::f64::consts::PI * 80.0);
                assert_eq!(spindle.speed_at(40.0), Some(free.min(1500.0)));
            }
            checked += 1;
        }
    }
    assert_eq!(checked, 6);
}

/// The whole output, committed next to each program. `UPDATE_EXPECT=1 cargo test` updates it; review the
/// difference before you commit it.
#[test]
fn output_is_the_committed_one() {
    for program in all() {
        let analysis = analysis(&program);
        let mut output = String::new();
        let rows = motion_rows(&analysis).into_iter().chain(message_rows(&program.text, &analysis));
        for row in rows {
            output.push_str(&row.to_string());
            output.push('\n');
        }
        expect_file![folder().join(&program.id).join("output.jsonl")].assert_eq(&output);
    }
}

#[test]
fn the_gallery_lists_each_of_its_programs_once() {
    let listed = gallery();
    let mut shown: Vec<String> = Vec::new();
    for program in all() {
        let about = about(&program.id);
        assert!(is_translated(&about["title"]) && is_translated(&about["shows"]), "{}", program.id);
        let other = about["compareWith"].as_str();
        assert!(other.is_none_or(|other| listed.iter().any(|id| id == other)), "{}", program.id);
        if about["gallery"] == json!(true) {
            shown.push(program.id);
        }
    }
    let mut sorted = listed.clone();
    sorted.sort();
    assert_eq!(sorted, shown);
}

/// The chapters are pages of the manual: first the pages of the way through it, then others in the order of its index.
#[test]
fn the_gallery_follows_the_manual() {
    let index = source("www/manual/en/index.md");
    let mut pages: Vec<&str> = Vec::new();
    for page in index.split("](").skip(1).filter_map(|link| link.split_once(".md)")).map(|(page, _)| page) {
        if !pages.contains(&page) {
            pages.push(page);
        }
    }
    let chapters: Vec<Value> =
        serde_json::from_str(&source("tests/programs/gallery.json")).expect("chapters");
    let mut places = Vec::new();
    for chapter in &chapters {
        let name = chapter["chapter"].as_str().expect("a page");
        places.push(pages.iter().position(|page| *page == name).expect(name));
        assert!(chapter["programs"].as_array().is_some_and(|programs| !programs.is_empty()), "{name}");
        // The heading of the group in the gallery.
        for language in LANGUAGES {
            assert!(
                source(&format!("www/manual/{language}/{name}.md")).starts_with("# "),
                "{language}/{name}"
            );
        }
    }
    assert!(places.is_sorted_by(|a, b| a < b), "{places:?} of {pages:?}");
}

/// A program from a document lists each difference, so that the page can show it. A program of the tests has the seed
/// `hand`, `synthetic` or `machine`.
#[test]
fn programs_from_a_document_name_their_changes() {
    let mut checked = 0;
    for program in all() {
        let (id, about) = (&program.id, about(&program.id));
        let is_shown = about["gallery"] == json!(true);
        assert!(!is_shown || is_translated(&about["source"]), "{id}: the gallery shows `source`");
        let seed = about["seed"].as_str().expect("a seed");
        let is_from_document = seed.bytes().all(|digit| digit.is_ascii_digit());
        let changed = match &about["changed"] {
            Value::Null => {
                assert!(!is_from_document, "{id}: `changed` is missing");
                continue;
            }
            Value::Array(changed) => changed.as_slice(),
            nothing => {
                assert_eq!(nothing, "nothing", "{id}");
                continue;
            }
        };
        assert!(is_from_document && !changed.is_empty(), "{id}: write \"nothing\" for no change");
        for change in changed {
            assert!(is_translated(&change["why"]), "{id}: {change}");
            let places = change["places"].as_array().expect("places");
            assert!(!places.is_empty(), "{id}: {change}");
            for place in places {
                let word = place["word"].as_str().expect("a word");
                let before =
                    place["line"].as_u64().expect("a line").checked_sub(1).expect("lines count from 1");
                let blocks = program.text.lines().skip(before as usize).take(word.lines().count());
                let blocks = blocks.collect::<Vec<_>>().join("\n");
                assert!(!word.is_empty() && blocks.contains(word), "{id}: {place} is not in {blocks:?}");
                assert_ne!(place["source"], place["word"], "{id}");
                checked += 1;
            }
        }
    }
    assert!(checked > 90, "only {checked} places were checked");
}

/// With a given blank, a changed number does not change the blank.
#[test]
fn every_program_of_the_gallery_has_its_blank() {
    let listed = gallery();
    let programs = all();
    let without = programs
        .iter()
        .filter(|program| listed.contains(&program.id))
        .filter(|program| Setup::from_json(&program.setup).is_ok_and(|setup| setup.stock.is_none()));
    assert_eq!(without.map(|program| &program.id).collect::<Vec<_>>(), Vec::<&String>::new());
}

/// An example shows only the warnings of its lesson: a program is complete unless completeness is the lesson.
#[test]
fn a_program_of_the_gallery_greets_with_the_messages_of_its_lesson_alone() {
    let listed = gallery();
    let mut greeted = Vec::new();
    for program in all().iter().filter(|program| listed.contains(&program.id)) {
        let mut analysis = analysis(program);
        analysis.check_at_machine();
        let lesson: Vec<&str> = ["warnings", "alarms"]
            .iter()
            .flat_map(|key| program.expect[*key].as_array().into_iter().flatten())
            .filter_map(Value::as_str)
            .collect();
        for found in message_rows(&program.text, &analysis) {
            let code = found["code"].as_str().unwrap_or_default();
            if !lesson.contains(&code) {
                greeted.push(format!("{} line {}: {code} {}", program.id, found["line"], found["message"]));
            }
        }
    }
    assert_eq!(greeted, Vec::<String>::new(), "\n{}", greeted.join("\n"));
}

const LANGUAGES: [&str; 3] = ["en", "zh", "ru"];

/// Whether a text is there in three languages.
fn is_translated(text: &Value) -> bool {
    LANGUAGES.iter().all(|language| text[language].as_str().is_some_and(|text| !text.is_empty()))
}

fn about(id: &str) -> Value {
    let text = std::fs::read_to_string(folder().join(id).join("about.json")).expect("about.json");
    serde_json::from_str(&text).expect("about.json")
}
