//! Help at a word and control state, requested at positions of fixtures that are marked with `$0`.
//!
//! Each file `tests/assist/*.nc` is a program with marks. The file `.help` beside it contains the answers at
//! each mark, in three languages. `UPDATE_EXPECT=1 cargo test --test it assist::` updates them; review the
//! difference before you commit it.
#[path = "assist/asking.rs"]
pub mod asking;
#[path = "assist/completion.rs"]
mod completion;
#[path = "assist/navigation.rs"]
mod navigation;
#[path = "assist/seeds.rs"]
mod seeds;
#[path = "assist/worked.rs"]
mod worked;

use crate::fixtures;
use std::fmt::Write;
use std::fs;
use std::path::Path;

use asking::Asking;
use expect_test::expect_file;
use gcode_playground::api::assist::{FormHelp, StateHelp, WordHelp};
use gcode_playground::assist::role::Role;
use gcode_playground::assist::signature::WhenOmitted;
use gcode_playground::message::Severity;
use gcode_playground::run::replay::VisitChoice;
use gcode_playground::sentences::Language;
use gcode_playground::setup::Setup;

/// A text without its marks, and the positions of the marks.
fn marked(text: &str) -> (String, Vec<u32>) {
    let mut pieces = text.split("$0");
    let mut plain = pieces.next().unwrap_or_default().to_owned();
    let mut marks = Vec::new();
    for piece in pieces {
        marks.push(plain.len() as u32);
        plain.push_str(piece);
    }
    (plain, marks)
}

/// The answers at all marks.
fn answers(text: &str) -> String {
    let (plain, marks) = marked(text);
    let mut asking = Asking::new(&plain, Setup::default());
    let mut out = String::new();
    for mark in marks {
        for language in Language::ALL {
            match asking.word(mark, VisitChoice::Usual, language) {
                None => _ = writeln!(out, "(nothing)"),
                Some(WordHelp { word, title, value, facts, .. }) => {
                    let value = value.map_or_else(String::new, |value| format!(" = {value}"));
                    _ = writeln!(out, "{word}: {title}{value}");
                    for fact in facts {
                        _ = writeln!(out, "    {}", fact.text);
                    }
                }
            }
        }
        for language in Language::ALL {
            let StateHelp { explanation, .. } = asking.state(mark, VisitChoice::Usual, language);
            if !explanation.is_empty() {
                _ = writeln!(out, "{explanation}");
            }
        }
        for language in Language::ALL {
            write_state(&mut out, &asking.state(mark, VisitChoice::Usual, language));
        }
        for language in Language::ALL {
            write_form(&mut out, asking.form(mark, language));
        }
        for language in Language::ALL {
            let proposed = asking.completion(mark, language, true);
            let shown = proposed.iter().take(3).map(|item| format!("{} ({})", item.label, item.detail));
            _ = writeln!(out, "proposed: {}", shown.collect::<Vec<_>>().join("; "));
        }
        if let Some(uses) = asking.with(mark, VisitChoice::Usual, Language::English, |_, reader, run| {
            reader.uses(run.code_list(), mark)
        }) {
            let lines: Vec<_> = uses.places.iter().map(|place| place.line.to_string()).collect();
            _ = writeln!(out, "{} in lines {}", uses.name, lines.join(", "));
        }
        out.push('\n');
    }
    for language in Language::ALL {
        let outline =
            asking.with(0, VisitChoice::Usual, language, |_, reader, run| reader.outline(run.code_list()));
        for entry in outline.entries {
            let indent = "  ".repeat(entry.depth.into());
            _ = writeln!(out, "{indent}{} {} {}", entry.line, entry.name, entry.detail);
        }
    }
    out
}

/// The state before and after a block.
fn write_state(out: &mut String, state: &StateHelp) {
    _ = writeln!(out, "line {}, {} of {}", state.line, state.number, state.times);
    for row in state.axes.iter().chain(&state.rows).chain(&state.variables) {
        let sign = if row.changed { '*' } else { ' ' };
        let since = row.line.map_or_else(String::new, |line| format!(" (line {line})"));
        let value = if row.changed { format!("{} -> {}", row.before, row.after) } else { row.after.clone() };
        _ = writeln!(out, "  {sign} {}: {value}{since}", row.name);
    }
    for frame in &state.frames {
        _ = writeln!(out, "    {}", frame.text);
    }
}

/// The form of a block: its words, and those that are missing.
fn write_form(out: &mut String, form: Option<FormHelp>) {
    for line in form.into_iter().flat_map(|form| form.lines) {
        let words = line.words.iter().map(|word| match word.state {
            "there" => format!("{} {}", word.letters, word.title),
            state => format!("{} {} ({state}: {})", word.letters, word.title, word.otherwise),
        });
        _ = writeln!(out, "form {}: {}", line.code, words.collect::<Vec<_>>().join("; "));
    }
}

#[test]
fn answers_at_the_marked_places_are_the_committed_ones() {
    let mut files: Vec<_> = fs::read_dir("tests/assist")
        .expect("a folder")
        .map(|entry| entry.expect("an entry").path())
        .collect();
    files.retain(|path| path.extension().is_some_and(|ending| ending == "nc"));
    files.sort();
    assert!(files.len() >= 5, "{files:?}");
    for path in files {
        let answered = answers(&fs::read_to_string(&path).expect("a program"));
        let name = path.with_extension("help").file_name().expect("a name").to_owned();
        expect_file![Path::new("assist").join(name)].assert_eq(&answered);
    }
}

/// Every word of every gallery program is explained, and no word of a correct one is reported as meaningless.
#[test]
fn every_word_of_every_program_is_explained() {
    for id in fixtures::gallery() {
        let read = |file: &str| fs::read_to_string(format!("tests/programs/{id}/{file}")).expect("a file");
        let setup = Setup::from_json(&read("setup.json")).expect("a setup");
        let text = read("program.nc");
        let mut asking = Asking::new(&text, setup);
        let errors: Vec<u32> = asking
            .run
            .diagnostics()
            .iter()
            .filter(|told| told.is_error())
            .map(|told| asking.lines.line_of(told.span.start))
            .collect();
        for (at, byte) in text.bytes().enumerate() {
            if !byte.is_ascii_uppercase() || errors.contains(&asking.lines.line_of(at as u32)) {
                continue;
            }
            let (found, block) = asking.found(at as u32, VisitChoice::Usual);
            let Some(word) = block.words.iter().find(|word| word.span.start == at as u32) else { continue };
            for language in Language::ALL {
                let help = asking.word(at as u32, VisitChoice::Usual, language);
                let help = help.unwrap_or_else(|| {
                    panic!("{id}: nothing is said of {:?}", word.span.quote(text.as_bytes()))
                });
                let is_known = found.visits == 0 || help.title != Role::Ignored.words(language);
                assert!(is_known && !help.title.is_empty(), "{id}, line {}: {help:#?}", block.line + 1);
            }
        }
    }
}

#[test]
fn the_state_shown_is_that_of_stepping() {
    for id in fixtures::gallery() {
        let read = |file: &str| fs::read_to_string(format!("tests/programs/{id}/{file}")).expect("a file");
        let setup = Setup::from_json(&read("setup.json")).expect("a setup");
        let mut asking = Asking::new(&read("program.nc"), setup);
        let end = asking.run.state().clone();
        let lines = asking.lines.len();
        let last = (0..lines).rev().find_map(|line| {
            let start = asking.lines.line(asking.run.text(), line).start;
            asking.found(start, VisitChoice::Number(u32::MAX)).0.visit.filter(|visit| visit.purpose.is_none())
        });
        let last = last.expect("a block that is carried out");
        assert_eq!(last.after.state.position, end.position, "{id}");
        assert_eq!(last.after.state.variables, end.variables, "{id}");
    }
}

/// Blocks with all the words of their form, and the lines required before and after them.
const FORMS: &[(&str, &str, &str)] = &[
    ("", "G00 X50 Z-10", ""),
    ("", "G01 X50 Z-10 F0.2", "G01 Z-20"),
    ("G01 Z0 F0.2\n", "G02 X70 Z-10 R12 F0.2", ""),
    ("G01 Z0 F0.2\n", "G03 X70 Z-10 R12 F0.2", ""),
    ("G32 W-1 F2\nG00 Z2\n", "G32 X62 Z-20 F2 Q0", ""),
    ("", "G90 X50 Z-20 R-2 F0.2", ""),
    ("", "G94 X50 Z-2 R-1 F0.2", ""),
    ("G32 W-1 F2\nG00 Z2\n", "G92 X50 Z-20 R-1 F2 Q0", ""),
    ("G71 U3 R1\n", "G71 U2 R1", "G71 P10 Q20 U0.4 W0.1 F0.3\nN10 G00 X30\nG01 Z-10\nN20 X60 Z-40"),
    ("G71 U2 R1\n", "G71 P10 Q20 U0.4 W0.1 F0.3 S600 T0101", "N10 G00 X30\nG01 Z-10\nN20 X60 Z-40"),
    ("", "G71 P10 Q20 U0.4 W0.1 D2000 F0.3", "N10 G00 X30\nG01 Z-10\nN20 X60 Z-40"),
    ("G72 W2 R1\n", "G72 P10 Q20 U0.4 W0.1 F0.3 S600 T0101", "N10 G00 Z-20\nG01 X40\nN20 Z0"),
    ("G73 U4 W2 R3\n", "G73 P10 Q20 U0.4 W0.1 F0.3 S600 T0101", "N10 G00 X30\nG01 Z-10\nN20 X60 Z-40"),
    ("G71 U2 R1\nG71 P10 Q20 F0.3\nN10 G00 X30\nG01 Z-10\nN20 X60 Z-40\n", "G70 P10 Q20", ""),
    ("", "G74 R1", "G74 Z-20 Q5000 F0.1"),
    ("G00 X0\nG74 R1\n", "G74 X0 Z-20 P1000 Q5000 R0 F0.1", ""),
    ("G75 R1\n", "G75 X40 Z-10 P3000 Q2000 R0 F0.1", ""),
    ("", "G76 P020060 Q100 R0.05", "G76 X57.4 Z-20 P1300 Q400 F2"),
    ("G76 P020060 Q100 R0.05\n", "G76 X57.4 Z-20 R0 P1300 Q400 F2", ""),
    ("G00 X0\n", "G83 X0 C0 Z-20 R-3 Q5000 P500 F100 K1", "G80"),
    ("", "G87 X40 C0 Z-10 R-3 Q5000 P500 F100 K1", "G80"),
    ("", "G04 X1.5", ""),
    ("", "G28 U0 W0", ""),
    ("", "G30 P2 U0 W0", ""),
    ("", "M98 P9100 L2", ""),
    ("", "G65 P9100 L1 A5", ""),
];

/// A program with the block of a form.
fn with_form(head: &str, block: &str, rest: &str) -> Asking {
    let text = format!("{FORM_HEAD}{head}{block}\n{rest}\nG00 X100 Z100\nM30\nO9100\nM99\n");
    Asking::new(&text, Setup::default())
}

/// The rules of all messages above note severity.
fn serious(head: &str, block: &str, rest: &str) -> Vec<String> {
    let asking = with_form(head, block, rest);
    let told = asking.run.diagnostics().iter().filter(|told| told.severity != Severity::Info);
    told.map(|told| told.message.slug().to_owned()).collect()
}

const FORM_HEAD: &str = "O1\nT0101 M3 S800 G99\nG00 X62 Z2\nG01 F0.25 Z1\nG00 Z2\n";

/// The control reports a missing word exactly if the form calls it required.
#[test]
fn a_form_asks_for_what_the_control_asks_for() {
    let mut wrong = Vec::new();
    for &(head, block, rest) in FORMS {
        let with_all = serious(head, block, rest);
        let mut asking = with_form(head, block, rest);
        let at = (FORM_HEAD.len() + head.len()) as u32;
        let signature =
            asking.with(at, VisitChoice::Usual, Language::English, |asked, _, _| asked.signature());
        let signature = signature.unwrap_or_else(|| panic!("{block}: no form"));
        let (_, places) = &signature.lines[signature.own];
        let words: Vec<&str> = block.split(' ').collect();
        for word in &words[1..] {
            let letter = word.trim_start_matches(',').as_bytes()[0];
            let Some(place) = places.iter().find(|place| place.slot.letters.contains(&letter)) else {
                wrong.push(format!("{block}: the form has no {word}"));
                continue;
            };
            let without = block.replacen(&format!(" {word}"), "", 1);
            let new: Vec<String> =
                serious(head, &without, rest).into_iter().filter(|rule| !with_all.contains(rule)).collect();
            let has_to = place.slot.otherwise == WhenOmitted::Missing;
            if new.is_empty() == has_to {
                wrong.push(format!("{block}: without {word} {:?}: {new:?}", place.slot.otherwise));
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}
