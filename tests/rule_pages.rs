//! The pages of the rules: every rule has one, its examples match its message, and the generated HTML is
//! consistent.
//!
//! All errors of all pages are reported together. `RULE_PAGES=slug,slug` checks only these pages.
#[path = "../www/rules/book.rs"]
mod book;
#[path = "../www/rules/outcome.rs"]
mod outcome;
#[path = "../www/rules/words.rs"]
mod words;

use crate::format;
use std::path::{Component, Path, PathBuf};

use gcode_playground::message::{Diagnostic, RULES, Severity};
use gcode_playground::sentences::Language;
use gcode_playground::setup::Setup;
use gcode_playground::source::LineIndex;

use format::RuleFile;
use format::page::{INDENT, Mark};
use outcome::{Marked, Outcome};

/// The folder of the manual.
const MANUAL: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/www/manual");

/// All rule files that can be parsed.
fn rules() -> Vec<RuleFile> {
    format::all(env!("CARGO_MANIFEST_DIR")).into_iter().filter_map(|(_, rule)| rule.ok()).collect()
}

#[test]
fn every_rule_has_a_page_and_every_page_a_rule() {
    let files: Vec<String> =
        format::all(env!("CARGO_MANIFEST_DIR")).into_iter().map(|(name, _)| name).collect();
    assert_eq!(files, RULES.map(|rule| rule.slug));
}

#[test]
fn pages_do_what_they_say() {
    let only = std::env::var("RULE_PAGES").unwrap_or_default();
    let only: Vec<&str> = only.split(',').filter(|slug| !slug.is_empty()).collect();
    let mut all = Vec::new();
    for (name, rule) in format::all(env!("CARGO_MANIFEST_DIR")) {
        if only.is_empty() || only.contains(&name.as_str()) {
            let slips = rule
                .map_or_else(|found| found.iter().map(ToString::to_string).collect(), |rule| slips(&rule));
            all.extend(slips.into_iter().map(|slip| format!("{name}: {slip}")));
        }
    }
    assert!(all.is_empty(), "{} slips in the pages:\n{}", all.len(), all.join("\n"));
}

/// The faults in the programs of a page.
fn slips(rule: &RuleFile) -> Vec<String> {
    let RuleFile { slug: own, page, .. } = rule;
    let setup = match Setup::from_json(&page.setup) {
        Ok(setup) => setup,
        Err(error) => return vec![format!("setup: {error}")],
    };
    let mut slips = Vec::new();
    let wrong = Outcome::of(&page.wrong, &setup, page.stop);
    let mut found: Vec<Mark> = wrong.told(own).map(|found| mark(&page.wrong, found)).collect();
    found.sort_unstable();
    if found.is_empty() {
        slips.push("`wrong` does not trigger it".to_owned());
    } else if page.is_placeless {
        if wrong.told(own).any(|told| !told.span.is_empty()) {
            slips.push(format!("it does stand at a place{}", shown(&page.wrong, &found)));
        }
    } else if found != page.marks {
        slips.push(format!("it stands elsewhere than marked; as it is told:{}", shown(&page.wrong, &found)));
    }
    let grave = |found: &&Diagnostic| found.severity > Severity::Info;
    let others = |found: &&Diagnostic| {
        let slug = found.message.slug();
        slug != own && !page.also.iter().any(|also| also == slug)
    };
    for other in wrong.analysis.diagnostics.iter().filter(grave).filter(others) {
        slips.push(format!("`wrong` says more: {}", told(&page.wrong, other)));
    }
    let right = Outcome::of(&page.right, &setup, None);
    for other in right.analysis.diagnostics.iter().filter(|found| grave(found) || !others(found)) {
        slips.push(format!("`right` is not: {}", told(&page.right, other)));
    }
    if page.is_fixed {
        // If only the author can know, several fixes are offered: one of them is right.
        let offered = wrong.told(own).map(|told| told.fixes.len()).max().unwrap_or_default();
        let mut made = (0..offered.max(1)).map(|choice| repaired(&page.wrong, wrong.told(own), choice));
        if !made.any(|made| made == page.right) {
            let first = repaired(&page.wrong, wrong.told(own), 0);
            slips.push(format!("the repairs do not make `right` of `wrong`, but\n{first}"));
        }
    }
    slips
}

/// The characters that a message marks, limited to its first line, without surrounding blanks.
fn mark(text: &str, found: &Diagnostic) -> Mark {
    let text = text.as_bytes();
    let lines = LineIndex::new(text);
    let line = lines.line_of(found.span.start);
    let whole = lines.line(text, line);
    let part = |from: u32, to: u32| String::from_utf8_lossy(&text[from as usize..to.max(from) as usize]);
    let spanned = part(found.span.start, found.span.end.min(whole.end));
    let blanks = spanned.chars().take_while(|letter| letter.is_whitespace()).count();
    let before = part(whole.start, found.span.start).chars().count();
    Mark { line: line as usize, column: before + blanks, length: spanned.trim().chars().count() }
}

/// A program after the fix with this index of each of these messages.
fn repaired<'a>(text: &str, told: impl Iterator<Item = &'a Diagnostic>, choice: usize) -> String {
    let fixes = told.filter_map(|found| found.fixes.get(choice));
    let mut edits: Vec<_> = fixes.flat_map(|fix| fix.edits.clone()).collect();
    edits.sort_by_key(|edit| std::cmp::Reverse(edit.span.start));
    let mut text = text.to_owned();
    for edit in edits {
        text.replace_range(edit.span.start as usize..edit.span.end as usize, &edit.text);
    }
    text
}

/// A message in one line.
fn told(text: &str, found: &Diagnostic) -> String {
    let (slug, Mark { line, column, .. }) = (found.message.slug(), mark(text, found));
    format!("{}:{} {slug}: {}", line + 1, column + 1, found.message.sentence(Language::English).message)
}

/// A program with carets, as shown on a page.
fn shown(program: &str, marks: &[Mark]) -> String {
    let mut out = String::new();
    for (number, line) in program.lines().enumerate() {
        let marks = || marks.iter().filter(|mark| mark.line == number);
        let indent = if marks().any(|mark| mark.column < 2) { INDENT } else { "" };
        out += &format!("\n    {indent}{line}");
        for Mark { column, length, .. } in marks() {
            let blanks = " ".repeat(indent.len() + column - 2);
            out += &format!("\n    //{blanks}{}", "^".repeat(*length));
        }
    }
    out
}

/// The mistakes in a rule file, one per line.
fn mistakes(text: &str) -> String {
    let mistakes = RuleFile::read(text).expect_err("not well formed");
    mistakes.iter().map(|mistake| format!("{mistake}\n")).collect()
}

#[test]
fn a_page_that_is_not_well_formed_is_told_in_full() {
    let text = "# x\n\n## examples\n\nfix: perhaps\n\n```wrong\n// ^\n```\n\n```right\nG00\n// ^\n```\n\n## de: Titel\n## en: {a}\nWhy: `a\n\n## zh: a";
    let slips = mistakes(text);
    for said in [
        "fix: perhaps",
        "no line to mark",
        "nothing is marked",
        "## de",
        "bracket",
        "backtick",
        "en: no What:",
        "zh: no Why:",
    ] {
        assert!(slips.contains(said), "{said} in\n{slips}");
    }
}

/// A rule file from its name up to its examples.
const HEAD: &str = "\nseverity: error\nkind: wrong\nalarm: PS0005\n\n## message NumberMissing\n\nAn address without its number.\n\n* address: letter `X`. The address.\n\nen: {address}\nzh: {address}\nru: {address}\n\n## examples\n";

#[test]
fn a_mistake_in_a_message_is_told_with_its_line() {
    let rule = |from: &str, to: &str| {
        let head = format!("# number-missing\n{HEAD}");
        assert!(head.contains(from), "{from}");
        mistakes(&head.replace(from, to))
    };
    for (from, to, said) in [
        ("en: {address}\n", "", "line 7: NumberMissing: no `en:`"),
        (
            "ru: {address}",
            "ru: {adress}",
            "line 7: NumberMissing: `ru` quotes {adress}, which is no argument",
        ),
        ("ru: {address}", "ru: x", "line 7: NumberMissing: `ru` does not quote {address}"),
        ("ru: {address}", "ru: {address}\nru help: y", "`ru help:` exists in one language only"),
        ("ru: {address}", "ru: {address}\nru: y", "line 16: this was said before"),
        ("letter `X`", "letter `XY`", "line 11: `XY` is no letter"),
        ("letter `X`", "sign `X`", "line 11: `sign` is none of the types letter, text"),
        ("* address: letter `X`. The", "* address letter `X`. The", "line 11: an argument is written"),
        ("address: letter `X`", "mm: letter `X`", "line 11: `mm` cannot be the name of an argument"),
        ("severity: error", "severity: grave", "line 3: `severity` is one of off, info, warning, error"),
        ("severity: error", "severity: off", "a rule that is off by default needs a `group`"),
        ("kind: wrong\n", "", "no `kind`"),
        ("alarm: PS0005\n", "", "neither `code` nor `alarm`"),
        ("alarm: PS0005", "alarm: PS0005, PS0006", "an argument of the type `alarm` belongs to"),
        ("## message NumberMissing", "## message number", "line 7: `number` is not a name in Rust"),
        ("An address without its number.", "", "no line says when it is given"),
    ] {
        let found = rule(from, to);
        assert!(found.contains(said), "{said}\nin\n{found}");
    }
}

#[test]
fn english_fills_what_another_language_lacks() {
    let whole = include_str!("../src/rules/number-missing.md");
    for (line, missing) in [("zh: ", "no `zh:`"), ("ru help: ", "no `ru help:`")] {
        let lines = whole.lines().filter(|own| !own.starts_with(line));
        let text: String = lines.map(|own| format!("{own}\n")).collect();
        let rule = RuleFile::read(&text).unwrap_or_else(|mistakes| panic!("{mistakes:?}"));
        let told: Vec<_> = rule.missing.iter().map(|mistake| mistake.what.clone()).collect();
        assert_eq!(told, [format!("NumberMissing: {missing}")]);
        let [english, chinese, russian] = &rule.messages[0].sentences;
        match line {
            "zh: " => assert_eq!(chinese, english),
            _ => assert_eq!(russian.help, english.help),
        }
    }
}

#[test]
fn what_a_page_says_is_held_against_what_happens() {
    let read = |wrong: &str, right: &str, head: &str| {
        let said = "What: a\n\nWhy: b\n\nRepair: c\n";
        let texts: String =
            Language::ALL.iter().map(|language| format!("\n## {}: t\n{said}", language.tag())).collect();
        let page = format!(
            "{}\n{HEAD}\n{head}\n\n```wrong\n{wrong}\n```\n\n```right\n{right}\n```\n{texts}",
            "# number-missing"
        );
        let rule = RuleFile::read(&page).unwrap_or_else(|mistakes| panic!("{mistakes:?}"));
        slips(&rule).join("\n")
    };
    assert_eq!(read("G00 X50 Z\n//      ^\nM30", "G00 X50 Z5\nM30", ""), "");
    assert!(read("G00 X50 Z\n// ^^\nM30", "G00 X50 Z5\nM30", "").contains("elsewhere"));
    assert!(read("G00 X50 Z5\n// ^^\nM30", "G00 X50\nM30", "").contains("does not trigger it"));
    assert!(read("G00 X50 Z\n//      ^", "G00 X50 Z5\nM30", "").contains("no-program-end"));
    assert!(read("G00 X50 Z\n//      ^\nM30", "G00 X50 Z5", "").contains("`right` is not"));
    assert!(read("G00 X50 Z\n//      ^\nM30", "G00 X50 Z5\nM30", "fix: yes").contains("the repairs"));
    assert!(read("G00 X50 Z\nM30", "G00 X50 Z5\nM30", "placeless: yes").contains("at a place"));
}

/// Two almost equal pictures would show the reader no difference.
#[test]
fn a_small_difference_from_the_corrected_part_is_marked() {
    let rules = rules();
    let page = &rules.iter().find(|rule| rule.slug == "taper-not-extended").expect("its page").page;
    let setup = Setup::from_json(&page.setup).expect("its setup");
    let [wrong, right] = [&page.wrong, &page.right].map(|text| Outcome::of(text, &setup, None));
    let picture = wrong.picture(Some(&right), None).expect("a picture");
    assert_eq!(picture.marked, Marked::Difference);
    let marks = |svg: &str| svg.matches(r#"class="only first""#).count();
    assert!(marks(&picture.svg) > 0, "{}", picture.svg);
    // The corrected part has nothing to mark, and neither has a part compared with itself.
    assert_eq!(right.picture(None, None).expect("a picture").marked, Marked::Nothing);
    let itself = wrong.picture(Some(&wrong), None).expect("a picture");
    assert_eq!((itself.marked, marks(&itself.svg)), (Marked::Nothing, 0));
}

#[test]
fn links_between_the_pages_lead_somewhere() {
    let files = book::files(&rules(), Path::new(MANUAL)).unwrap_or_else(|problem| panic!("{problem}"));
    let links = |html: &str| -> Vec<String> {
        let after = |name: &'static str| html.split(name).skip(1).collect::<Vec<_>>();
        let quoted = [after(" href=\""), after(" src=\"")].concat();
        quoted.into_iter().filter_map(|rest| Some(rest.split_once('"')?.0.to_owned())).collect()
    };
    let mut dead = Vec::new();
    for (name, html) in files.iter().filter(|(name, _)| name.ends_with(".html")) {
        let found = links(html);
        assert!(found.len() > 4, "{name} has links");
        for link in found {
            let path = link.split('#').next().unwrap_or_default();
            let target = resolved(Path::new(name).parent().unwrap_or(Path::new("")), path);
            // The playground is next to the folder of the pages.
            let is_there = match &target {
                Some(target) => files.contains_key(&target.to_string_lossy().replace('\\', "/")),
                None => path == "../../index.html" || is_in_manual(path),
            };
            if !is_there {
                dead.push(format!("{name}: {link}"));
            }
        }
    }
    assert!(dead.is_empty(), "{}", dead.join("\n"));
}

/// Whether a link leads to a page of the manual, `../../manual/en/g90.html`.
fn is_in_manual(link: &str) -> bool {
    let page = link.strip_prefix("../../manual/").and_then(|page| page.strip_suffix(".html"));
    page.is_some_and(|page| Path::new(MANUAL).join(format!("{page}.md")).is_file())
}

/// The target of a relative link; `None` if it is outside of the folder.
fn resolved(from: &Path, link: &str) -> Option<PathBuf> {
    let mut path = from.to_path_buf();
    for part in Path::new(link).components() {
        match part {
            Component::ParentDir if !path.pop() => return None,
            Component::ParentDir | Component::CurDir => {}
            part => path.push(part),
        }
    }
    Some(path)
}

#[test]
fn each_language_has_every_page_with_what_is_said_in_it() {
    let rules = rules();
    let files = book::files(&rules, Path::new(MANUAL)).unwrap_or_else(|problem| panic!("{problem}"));
    for RuleFile { slug, page, .. } in &rules {
        for language in Language::ALL {
            let tag = language.tag();
            let html = &files[&format!("{tag}/{slug}.html")];
            assert!(html.contains(&format!("<html lang=\"{tag}\">")));
            assert!(html.matches("<pre ").count() == 2 && html.contains("#program="), "{tag}: {slug}");
            assert!(page.is_placeless || html.contains("<mark "), "{tag}: {slug}");
            let index = &files[&format!("{tag}/index.html")];
            assert!(index.contains(&format!("href=\"{slug}.html\"")), "{tag}: {slug}");
        }
    }
}
