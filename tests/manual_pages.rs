//! The manual: every page exists in three languages with the same examples and exercises, all links are valid, and
//! the examples give the results that the pages state.
//!
//! `www/manual/examples/NAME.json` has the results of `NAME.nc`, worked out by hand:
//!
//! * `end`: the final point of the tip, X a diameter, mm
//! * `diameters`: the outside diameter of the part at each Z, mm
//! * `motions`: the number of motions
//! * `lines`: keys of the last motion of a line, as in the output of the command `motions`
//! * `messages`: the slugs of all messages except notes; none if it is missing
//! * `tries`: the same after the replacements of `change`, which are exercises of the page
//! * `task`: the same for a solution of the task of the page; the page does not show it

#[path = "../www/docs/html/calculator.rs"]
mod calculator;
#[path = "../www/docs/html/figure.rs"]
mod figure;
#[path = "../www/docs/html/form.rs"]
mod form;
#[path = "../www/docs/html/manual.rs"]
mod pages;

use crate::fixtures::same;
use crate::project::{self, source};
use crate::reference_pages::site;
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use expect_test::expect_file;
use gcode_playground::api;
use gcode_playground::machine::SimulationResult;
use gcode_playground::message::Severity;
use gcode_playground::run::{Analysis, Run};
use gcode_playground::sentences::Language;
use gcode_playground::setup::Setup;
use gcode_playground::setup::dialect::CodeList;
use serde_json::Value;

const LANGUAGES: [&str; 3] = ["en", "zh", "ru"];

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("www/manual")
}

/// The stems of the files of a folder with this ending.
fn stems(subfolder: &str, ending: &str) -> BTreeSet<String> {
    let entries = fs::read_dir(folder().join(subfolder)).expect("a folder").flatten();
    let names = entries.map(|entry| entry.file_name().to_string_lossy().into_owned());
    names.filter_map(|name| name.strip_suffix(ending).map(str::to_owned)).collect()
}

fn document(language: &str, page: &str) -> String {
    source(&format!("www/manual/{language}/{page}.md"))
}

/// The parts of a text between two marks.
fn between<'a>(text: &'a str, from: &str, to: &str) -> Vec<&'a str> {
    text.split(from).skip(1).filter_map(|rest| rest.split(to).next()).collect()
}

/// The examples of a document in their order, without the programs of figures.
fn examples(text: &str) -> Vec<&str> {
    between(text, "](../examples/", ")").into_iter().filter_map(|name| name.strip_suffix(".nc")).collect()
}

/// The number of paragraphs that are only a link to a program, and of calculators.
fn live_programs(text: &str) -> usize {
    let is_live = |one: &&str| {
        one.starts_with('[') && one.trim_end().ends_with(".nc)") && one.matches("](").count() == 1
    };
    text.split("\n\n").filter(is_live).count() + text.matches("{calculator ").count()
}

/// The code spans of the exercise after an example, before the next example or heading.
fn exercise(text: &str, example: &str) -> Vec<String> {
    let after = text.split(&format!("](../examples/{example}.nc)")).nth(1).expect("the example");
    let own = after.lines().skip(1).take_while(|line| !line.starts_with(['[', '#', '!']));
    let quoted = own.skip_while(|line| !line.starts_with('>')).take_while(|line| line.starts_with('>'));
    let quoted = quoted.collect::<Vec<_>>().join("\n");
    quoted.split('`').skip(1).step_by(2).map(str::to_owned).collect()
}

fn files() -> BTreeMap<String, String> {
    let exercises = folder().with_file_name("exercises");
    pages::files(&folder(), &exercises).unwrap_or_else(|mistakes| panic!("{mistakes}"))
}

#[test]
fn every_page_exists_in_three_languages_with_the_same_examples() {
    let files = files();
    let pages = stems("en", ".md");
    assert!(pages.len() >= 30, "{pages:?}");
    let count = |ending: &str| files.keys().filter(|name| name.ends_with(ending)).count();
    assert_eq!(count(".html"), LANGUAGES.len() * pages.len());
    let mut used = BTreeSet::new();
    for language in LANGUAGES {
        assert_eq!(stems(language, ".md"), pages, "{language}");
        for page in &pages {
            let (english, own) = (document("en", page), document(language, page));
            assert_eq!(examples(&own), examples(&english), "{language}/{page}");
            let html = &files[&format!("{language}/{page}.html")];
            assert!(html.contains(&format!("<html lang=\"{language}\">")), "{language}/{page}");
            assert_eq!(html.matches("<gcode-playground ").count(), live_programs(&own), "{language}/{page}");
            let figures = own.matches("![").count();
            assert_eq!(html.matches("<figure>").count(), figures, "{language}/{page} has figures");
            let formulas = [&own, &english].map(|text| text.matches("$$").count() / 2);
            assert_eq!([html.matches("<math").count(); 2], formulas, "{language}/{page} has formulas");
            for example in examples(&own) {
                used.insert(example.to_owned());
                let program = source(&format!("www/manual/examples/{example}.nc"));
                let escaped = program.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;");
                assert!(html.contains(&format!("<pre>\n{escaped}</pre>")), "{language}/{page}: {example}");
                assert_eq!(
                    exercise(&own, example),
                    exercise(&english, example),
                    "{language}/{page}: {example}"
                );
            }
        }
    }
    assert_eq!(used, stems("examples", ".nc"), "each example is on a page");
}

/// A link to a heading leads to the same heading in each language: `zh/g90.html#step-by-step`.
#[test]
fn headings_have_the_anchors_of_the_english_page() {
    let files = files();
    let ids = |html: &str| {
        let headings = html.lines().filter(|line| line.starts_with("<h"));
        let ids = headings.filter_map(|line| line.split(" id=\"").nth(1)?.split('"').next());
        ids.map(str::to_owned).collect::<Vec<_>>()
    };
    for page in stems("en", ".md") {
        let english = ids(&files[&format!("en/{page}.html")]);
        let headings = document("en", &page).lines().filter(|line| line.starts_with('#')).count();
        assert_eq!(english.len(), headings, "{page}");
        for language in LANGUAGES {
            assert_eq!(ids(&files[&format!("{language}/{page}.html")]), english, "{language}/{page}");
        }
    }
    for language in LANGUAGES {
        let html = &files[&format!("{language}/g90.html")];
        assert!(html.contains("<h2 id=\"step-by-step\">"), "{language}");
    }
}

/// In the order of the course, with their titles in the language of the page.
#[test]
fn a_page_links_to_its_exercises() {
    let files = files();
    let exercises = |name: &str| -> Vec<String> {
        let list = between(&files[name], "<section class=\"exercises\">", "</section>");
        list.iter().flat_map(|list| between(list, "#exercise=", "</a>")).map(str::to_owned).collect()
    };
    let [english, russian] = ["en", "ru"].map(|language| exercises(&format!("{language}/g94.html")));
    assert_eq!(
        english,
        [
            "face-step\">A short step on a large bar",
            "cone-face\">A pin with a conical shoulder",
            "undercut\">The cone that is too flat"
        ]
    );
    assert!(russian.len() == 3 && russian[0].starts_with("face-step\">"), "{russian:?}");
    assert_eq!(exercises("en/axes.html"), [""; 0]);
    let all = files.iter().filter(|(name, _)| name.starts_with("zh/") && name.ends_with(".html"));
    assert_eq!(all.map(|(name, _)| exercises(name).len()).sum::<usize>(), 24);
    let programs = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/programs");
    let own = pages::without_page(&files, &programs).expect("pages");
    assert!(!own["en/g94.html"].contains("exercise="));
}

/// The frame page of the package has no gallery.
#[test]
fn the_pages_of_the_package_link_to_programs_by_their_text() {
    let programs = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/programs");
    let own = pages::without_page(&files(), &programs).expect("pages");
    let linked: usize = own.values().map(|html| html.matches("index.html#program=").count()).sum();
    assert!(linked >= 3 * 12, "{linked}");
    for (name, html) in own.iter().filter(|(name, _)| name.ends_with(".html")) {
        for address in between(html, "../../index.html", "\"") {
            assert!(
                address.starts_with("#program=") && address.contains("&amp;setup=%7B"),
                "{name}: {address}"
            );
        }
    }
}

/// The rows of codes have anchors: `g71-g72.html#g71`.
#[test]
fn each_code_that_is_carried_out_has_one_row_in_the_manual() {
    let files = files();
    let table = api::codes(CodeList::A, Language::English);
    let done = table.rows.iter().filter(|row| row.effect == "done");
    let names = done.flat_map(|row| form::names_of(&row.a));
    let is_code = |name: &&str| {
        name.len() > 1 && name[1..].starts_with(|c: char| c.is_ascii_digit()) && name.starts_with(['G', 'M'])
    };
    for name in names.filter(is_code) {
        let id = format!(" id=\"{}\"", form::anchor(name));
        for language in LANGUAGES {
            let own = files.iter().filter(|(file, _)| file.starts_with(language));
            assert_eq!(
                own.map(|(_, html)| html.matches(&id).count()).sum::<usize>(),
                1,
                "{name}, {language}"
            );
        }
    }
}

/// The links from the table of codes and from the help to the manual.
#[test]
fn the_page_knows_the_pages_of_all_codes() {
    let mut list = serde_json::Map::new();
    for page in stems("en", ".md") {
        let text = document("en", &page);
        let codes = between(&text, "{codes ", "}");
        if !codes.is_empty() {
            list.insert(page, codes.join(" ").into());
        }
    }
    assert!(list.len() >= 20, "{list:?}");
    let list = serde_json::to_string_pretty(&list).expect("JSON") + "\n";
    expect_file![Path::new(project::ROOT).join("www/src/editor/manual-pages.json")].assert_eq(&list);
}

#[test]
fn links_between_the_pages_are_valid_and_each_page_has_its_neighbours() {
    let files = files();
    let pages = stems("en", ".md");
    for (name, html) in files.iter().filter(|(name, _)| name.ends_with(".html")) {
        let language = name.split('/').next().expect("a folder");
        for link in [between(html, " href=\"", "\""), between(html, " src=\"", "\"")].concat() {
            let (path, anchor) = link.split_once('#').unwrap_or((link, ""));
            let is_valid = match path.strip_prefix("../../") {
                // Files beside the folder of the pages.
                Some("index.html" | "element.js" | "search.js") => true,
                Some(other) => {
                    let rule = other.strip_prefix(&format!("rules/{language}/"));
                    let slug = rule.and_then(|rule| rule.strip_suffix(".html"));
                    slug.is_some_and(|slug| {
                        Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("src/rules/{slug}.md")).is_file()
                    })
                }
                None => {
                    let inside =
                        path.strip_prefix("../").map_or_else(|| format!("{language}/{path}"), str::to_owned);
                    let id = format!(" id=\"{anchor}\"");
                    files.get(&inside).is_some_and(|html| anchor.is_empty() || html.contains(&id))
                }
            };
            assert!(is_valid, "{name}: {link}");
        }
    }
    for language in LANGUAGES {
        let own = files.iter().filter(|(name, _)| name.starts_with(language));
        let count = |relation: &str| own.clone().filter(|(_, html)| html.contains(relation)).count();
        let order = pages.len() - 1;
        assert_eq!((count("rel=\"next\""), count("rel=\"prev\"")), (order, order), "{language}");
    }
}

fn run(text: &str, setup: &Setup) -> Analysis {
    let mut run = Run::new(text.as_bytes().to_vec(), setup.clone());
    while !run.advance(usize::MAX) {}
    let mut analysis = run.into_analysis();
    analysis.check_at_machine();
    analysis
}

/// The differences from the stated results.
fn differences(text: &str, setup: &Setup, expected: &Value) -> Vec<String> {
    let analysis = run(text, setup);
    let mut found = Vec::new();
    let serious = analysis.diagnostics.iter().filter(|told| told.severity > Severity::Info);
    let told: BTreeSet<&str> = serious.map(|told| told.message.slug()).collect();
    let stated = expected["messages"].as_array().into_iter().flatten().filter_map(Value::as_str).collect();
    if told != stated {
        found.push(format!("messages {told:?} instead of {stated:?}"));
    }
    let rows: Vec<Value> = api::motions(&analysis.motions, &analysis.setup.machine)
        .map(|row| serde_json::to_value(row).expect("a row"))
        .collect();
    if let Some(end) = expected.get("end") {
        found.extend(same(end, &rows.last().expect("a motion")["to"]).err());
    }
    if let Some(count) = expected.get("motions")
        && count.as_u64() != Some(rows.len() as u64)
    {
        found.push(format!("{} motions instead of {count}", rows.len()));
    }
    for (line, stated) in expected["lines"].as_object().into_iter().flatten() {
        let number = line.parse().expect("a line number");
        let row =
            rows.iter().rfind(|row| row["line"].as_u64() == Some(number)).expect("a motion of the line");
        found.extend(same(stated, row).err().map(|why| format!("line {line}: {why}")));
    }
    let simulation = SimulationResult::of(&analysis.motions, &analysis.setup);
    for (z, diameter) in expected["diameters"].as_object().into_iter().flatten() {
        let part = simulation.finished().expect("a part");
        let radii = part.radii(z.parse().expect("a Z"));
        let outside = radii.last().map_or(0.0, |&(_, high)| 2.0 * high);
        if (outside - diameter.as_f64().expect("a diameter")).abs() > 0.02 {
            found.push(format!("diameter {outside} at Z{z} instead of {diameter}"));
        }
    }
    found
}

/// The replacements of an exercise: a text of the program, and the text that replaces it.
fn replacements(exercise: &Value) -> impl Iterator<Item = (&str, &str)> {
    let change = exercise["change"].as_object().expect("a change");
    change.iter().map(|(from, to)| (from.as_str(), to.as_str().expect("a text")))
}

/// The pages of the way through, in their order.
fn chapters() -> Vec<String> {
    let index = document("en", pages::INDEX);
    let listed = index.lines().filter(|line| line.starts_with(|first: char| first.is_ascii_digit()));
    listed.map(|line| between(line, "](", ".md)")[0].to_owned()).collect()
}

#[test]
fn each_chapter_has_one_task() {
    let chapters = chapters();
    assert_eq!(chapters.len(), 12, "{chapters:?}");
    for (language, task) in LANGUAGES.into_iter().zip(["**Task**", "**练习**", "**Задача**"]) {
        for chapter in &chapters {
            assert_eq!(document(language, chapter).matches(task).count(), 1, "{language}/{chapter}");
        }
    }
}

#[test]
fn examples_and_exercises_give_the_stated_results() {
    let setup = Setup::from_json(&source("www/manual/examples/setup.json")).expect("a setup");
    let pages: BTreeMap<String, String> =
        stems("en", ".md").into_iter().map(|page| (page.clone(), document("en", &page))).collect();
    let (mut wrong, mut tries, mut tasks) = (Vec::new(), 0, 0);
    for example in stems("examples", ".nc") {
        let text = source(&format!("www/manual/examples/{example}.nc"));
        let json = source(&format!("www/manual/examples/{example}.json"));
        let stated: Value = serde_json::from_str(&json).unwrap_or_else(|error| panic!("{example}: {error}"));
        wrong.extend(differences(&text, &setup, &stated).iter().map(|why| format!("{example}: {why}")));
        let page = pages.values().find(|page| examples(page).contains(&&*example)).expect("its page");
        let spans = exercise(page, &example).join(" ");
        for exercise in stated["tries"].as_array().into_iter().flatten() {
            tries += 1;
            for (from, to) in replacements(exercise) {
                for word in from.split_whitespace().chain(to.split_whitespace()) {
                    // A word that stays the same is not named.
                    let stays = from.contains(word) && to.contains(word);
                    assert!(stays || spans.contains(word), "{example}: no exercise with `{word}`");
                }
            }
        }
        if let Some(task) = stated.get("task") {
            assert!(page.contains("**Task**"), "{example}: its page has no task");
            tasks += 1;
            assert!(replacements(task).count() > 0, "{example}");
        }
        for changed in stated["tries"].as_array().into_iter().flatten().chain(stated.get("task")) {
            let mut program = text.clone();
            for (from, to) in replacements(changed) {
                assert_eq!(program.matches(from).count(), 1, "{example}: `{from}`");
                program = program.replace(from, to);
            }
            let found = differences(&program, &setup, changed);
            wrong.extend(found.iter().map(|why| format!("{example}, {}: {why}", changed["change"])));
        }
    }
    assert!(tries > 150, "{tries}");
    // The task of the last chapter is about a program of the gallery.
    assert_eq!(tasks, chapters().len() - 1);
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn a_link_alone_to_a_program_is_an_element_and_other_links_lead_to_the_site() {
    let text = "# A\n\n[b `c`](../examples/axes.nc)\n\nd [e](moves.md) [f](../../../src/rules/no-program-end.md) [g](../../../tests/programs/s003-g71/program.nc) [h](g90.md#step-by-step) [i](g71-g72.md#g71)\n";
    let page =
        pages::Page::new(text, "a", &folder().join("en")).unwrap_or_else(|mistake| panic!("{mistake}"));
    assert_eq!(page.body.matches("<gcode-playground ").count(), 1, "{}", page.body);
    for part in [
        "language=\"en\"",
        "caption=\"b c\"",
        "setup=\"{ &quot;",
        "href=\"moves.html\"",
        "href=\"../../rules/en/no-program-end.html\"",
        "href=\"../../index.html#s003-g71\"",
        "href=\"g90.html#step-by-step\"",
        "href=\"g71-g72.html#g71\"",
    ] {
        assert!(page.body.contains(part), "{part} is missing in\n{}", page.body);
    }
    assert_eq!(page.links, ["moves", "g90", "g71-g72"]);
}

/// The addresses and the command of `www/docs/manuals.md`.
#[test]
fn the_document_about_manuals_names_pages_that_exist() {
    let (files, document) = (files(), source("www/docs/manuals.md"));
    let mut addresses = 0;
    for address in document.split("manual/").skip(1) {
        let is_part = |letter: char| letter.is_ascii_alphanumeric() || "/.-#".contains(letter);
        let address = address.split(|letter| !is_part(letter)).next().unwrap_or_default();
        let Some((page, anchor)) = address.split_once('#') else { continue };
        addresses += 1;
        let html = files.get(page).unwrap_or_else(|| panic!("{page}"));
        assert!(html.contains(&format!(" id=\"{anchor}\"")), "{address}");
    }
    assert_eq!(addresses, 5);
    let mut commands = document.lines().filter_map(|line| line.strip_prefix("    gcode-playground "));
    let line = commands.find(|line| line.contains("www/manual/")).expect("a command");
    let written = Path::new(env!("CARGO_TARGET_TMPDIR")).join("cone.html");
    let output = Command::new(env!("CARGO_BIN_EXE_gcode-playground"))
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .args(line.replace("-o cone.html", "-o").split_whitespace())
        .arg(&written)
        .output()
        .expect("the command line starts");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let html = fs::read_to_string(written).expect("the element");
    assert!(html.contains("<svg") && html.contains("G90 X58 Z-20 R-2.3 F0.2"), "{html}");
}

#[test]
fn each_page_names_its_licence() {
    for (name, html) in files().iter().filter(|(name, _)| name.ends_with(".html")) {
        let footer = between(html, "<footer>", "</footer>");
        assert!(matches!(footer[..], [text] if text.contains(env!("CARGO_PKG_LICENSE"))), "{name}");
    }
}

#[test]
fn mistakes_in_a_page_are_found() {
    for text in [
        "no heading",
        "# A\n\n<b>c</b>\n",
        "# A\n\n[b](none.md)\n",
        "# A\n\n[b](g90.md#none)\n",
        "# A\n\n## A\n",
        "# A\n\n[b](../examples/none.nc)\n",
        "# A\n\nb [c](../examples/axes.nc)\n",
        "# A\n\n[b](http://example.org)\n",
        "# A\n\n![b](../examples/axes.nc \"cycle:1\")\n",
        "# A\n\n{form G999}\n",
        "# A\n\n{codes G999}\n",
        "# A\n\n{table G71}\n",
    ] {
        assert!(pages::Page::new(text, "a", &folder().join("en")).is_err(), "{text}");
    }
    let english = "# A\n\n## B\n\n### C\n";
    for (text, is_valid) in [
        ("# 甲\n\n## 乙\n\n### 丙\n", true),
        ("# 甲\n\n## 乙\n", false),
        ("# 甲\n\n## 乙\n\n## 丙\n", false),
        ("# 甲\n\n## 乙\n\n### 丙\n\n## 丁\n", false),
    ] {
        let page = pages::Page::with_headings(text, english, "a", &folder().join("zh"));
        assert_eq!(page.is_ok(), is_valid, "{text}");
    }
}
