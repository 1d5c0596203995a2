//! Help at the word and the state of the control, asked at places of fixtures that are marked with `$0`.
//!
//! Each file `tests/assist/*.nc` is a program with marks; the file `.help` beside it is what is answered at each of them, in
//! three languages. `UPDATE=1 cargo test --test assist` writes them anew; read what has changed before it is committed.
#![cfg(not(target_arch = "wasm32"))]

#[allow(dead_code, reason = "only the names of the programs are needed here")]
mod fixtures;

use std::fmt::Write;
use std::fs;

use gcode_playground::api::Places;
use gcode_playground::api::assist::{CompletionItem, Reader, StateHelp, WordHelp};
use gcode_playground::assist::Asked;
use gcode_playground::assist::role::Role;
use gcode_playground::assist::signature::Otherwise;
use gcode_playground::message::Severity;
use gcode_playground::run::Run;
use gcode_playground::run::replay::{Found, Time, block_at};
use gcode_playground::sentences::Language;
use gcode_playground::setup::Setup;
use gcode_playground::source::{LineIndex, Span};
use gcode_playground::text::block::Block;
use gcode_playground::text::parser::Resume;

/// A program that was run, and can be asked about.
struct Asking {
    run: Run,
    lines: LineIndex,
}

impl Asking {
    fn new(text: &str, setup: Setup) -> Self {
        let mut run = Run::new(text.into(), setup);
        while !run.advance(usize::MAX) {}
        let lines = LineIndex::new(run.text());
        Self { run, lines }
    }

    fn found(&mut self, byte: u32, time: Time) -> (Found, Block) {
        let line = self.lines.line_of(byte);
        let start = Resume::inside(self.lines.line(self.run.text(), line).start, line);
        let mut replay = self.run.replay(start, byte, time);
        while !self.run.advance_replay(&mut replay, 1000) {}
        let found = replay.found();
        let (_, block) = block_at(self.run.text(), found.place.start, found.place.start.byte);
        (found, block)
    }

    fn with<R>(
        &mut self,
        byte: u32,
        time: Time,
        language: Language,
        say: impl FnOnce(&Asked, &Reader, &Run) -> R,
    ) -> R {
        let (found, block) = self.found(byte, time);
        let run = &self.run;
        let asked = Asked {
            text: run.text(),
            block: &block,
            visit: found.visit.as_ref(),
            times: found.times,
            setup: run.setup(),
            dialect: run.dialect(),
            codes: run.code_list(),
        };
        let places = Places { text: run.text(), lines: &self.lines };
        say(&asked, &Reader { places, language, unit: run.state().unit }, run)
    }

    fn word(&mut self, byte: u32, time: Time, language: Language) -> Option<WordHelp> {
        self.with(byte, time, language, |asked, reader, run| {
            let notes: Vec<Span> = run.notes().spans().collect();
            reader.word(asked, byte, &notes, run.motions())
        })
    }

    fn state(&mut self, byte: u32, time: Time, language: Language) -> StateHelp {
        self.with(byte, time, language, |asked, reader, run| reader.state(asked, run.motions()))
    }
}

/// A text without its marks, and where they were.
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

/// What is answered at each mark.
fn answers(text: &str) -> String {
    let (plain, marks) = marked(text);
    let mut asking = Asking::new(&plain, Setup::default());
    let mut out = String::new();
    for mark in marks {
        for language in Language::ALL {
            match asking.word(mark, Time::Usual, language) {
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
            let StateHelp { explanation, .. } = asking.state(mark, Time::Usual, language);
            if !explanation.is_empty() {
                _ = writeln!(out, "{explanation}");
            }
        }
        let state = asking.state(mark, Time::Usual, Language::English);
        _ = writeln!(out, "line {}, {} of {}", state.line, state.number, state.times);
        for row in state.axes.iter().chain(&state.rows).chain(&state.variables) {
            let sign = if row.changed { '*' } else { ' ' };
            let since = row.line.map_or_else(String::new, |line| format!(" (line {line})"));
            let value =
                if row.changed { format!("{} -> {}", row.before, row.after) } else { row.after.clone() };
            _ = writeln!(out, "  {sign} {}: {value}{since}", row.name);
        }
        for frame in state.frames {
            _ = writeln!(out, "    {}", frame.text);
        }
        out.push('\n');
    }
    out
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
    let mut changed = Vec::new();
    for path in files {
        let answered = answers(&fs::read_to_string(&path).expect("a program"));
        let expected = path.with_extension("help");
        if std::env::var_os("UPDATE").is_some() {
            fs::write(&expected, &answered).expect("a file");
            continue;
        }
        let committed = fs::read_to_string(&expected).unwrap_or_default();
        let differ = committed.lines().zip(answered.lines()).enumerate().find(|(_, (old, new))| old != new);
        if let Some((line, (old, new))) = differ {
            changed.push(format!("{}, line {}: `{new}` instead of `{old}`", expected.display(), line + 1));
        } else if committed != answered {
            changed.push(format!("{}: another length", expected.display()));
        }
    }
    assert!(changed.is_empty(), "{changed:#?}");
}

/// Every word of every program of the gallery is explained, and none of the correct ones is said to have no meaning.
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
            let (found, block) = asking.found(at as u32, Time::Usual);
            let Some(word) = block.words.iter().find(|word| word.span.start == at as u32) else { continue };
            for language in Language::ALL {
                let help = asking.word(at as u32, Time::Usual, language);
                let help = help.unwrap_or_else(|| {
                    panic!("{id}: nothing is said of {:?}", word.span.quote(text.as_bytes()))
                });
                let is_known = found.times == 0 || help.title != Role::Ignored.words(language);
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
            asking.found(start, Time::Number(u32::MAX)).0.visit.filter(|visit| visit.purpose.is_none())
        });
        let last = last.expect("a block that is carried out");
        assert_eq!(last.after.state.position, end.position, "{id}");
        assert_eq!(last.after.state.variables, end.variables, "{id}");
    }
}

/// Blocks with all the words of their form, and what has to stand before and after them.
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

/// The block of a form in a program.
fn with_form(head: &str, block: &str, rest: &str) -> Asking {
    let text = format!("{FORM_HEAD}{head}{block}\n{rest}\nG00 X100 Z100\nM30\nO9100\nM99\n");
    Asking::new(&text, Setup::default())
}

/// The rules of all messages that are more than a note.
fn serious(head: &str, block: &str, rest: &str) -> Vec<String> {
    let asking = with_form(head, block, rest);
    let told = asking.run.diagnostics().iter().filter(|told| told.severity != Severity::Info);
    told.map(|told| told.message.slug().to_owned()).collect()
}

const FORM_HEAD: &str = "O1\nT0101 M3 S800 G99\nG00 X62 Z2\nG01 F0.25 Z1\nG00 Z2\n";

/// What a form calls necessary is missed by the control, and what it calls optional is not.
#[test]
fn a_form_asks_for_what_the_control_asks_for() {
    let mut wrong = Vec::new();
    for &(head, block, rest) in FORMS {
        let with_all = serious(head, block, rest);
        let mut asking = with_form(head, block, rest);
        let at = (FORM_HEAD.len() + head.len()) as u32;
        let signature = asking.with(at, Time::Usual, Language::English, |asked, _, _| asked.signature());
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
            let has_to = place.slot.otherwise == Otherwise::Missing;
            if new.is_empty() == has_to {
                wrong.push(format!("{block}: without {word} {:?}: {new:?}", place.slot.otherwise));
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

impl Asking {
    /// What can be written at a byte, for a reader who asks for it, or who types.
    fn completion(&mut self, byte: u32, language: Language, asked_for: bool) -> Vec<CompletionItem> {
        let end = self.run.state().clone();
        self.with(byte, Time::Usual, language, |asked, reader, _| {
            reader.completion(asked, byte, &end, asked_for).map_or_else(Vec::new, |found| found.items)
        })
    }
}

/// What is proposed at the mark `$0` of a program.
fn proposed(program: &str, setup: &str, asked_for: bool) -> Vec<CompletionItem> {
    let byte = program.find("$0").expect("a mark");
    let setup = Setup::from_json(setup).expect("a setup");
    Asking::new(&program.replace("$0", ""), setup).completion(byte as u32, Language::English, asked_for)
}

fn labels(items: &[CompletionItem]) -> Vec<&str> {
    items.iter().map(|item| item.label.as_str()).collect()
}

const STOCK: &str = r#"{"stock": {"diameter": 40, "length": 60}, "tools": {"T0303": {"type": "threading"}}}"#;
const HEAD: &str = "O1\nT0101 M3 S800 F0.2\nG00 X42 Z2\n";

#[test]
fn codes_are_proposed_as_the_control_writes_them_those_usual_here_first() {
    let g = |setup: &str| proposed(&format!("{HEAD}G$0\n"), setup, false);
    let found = g("{}");
    assert_eq!(labels(&found)[..4], ["G00", "G01", "G02", "G03"]);
    assert!(found.iter().all(|item| item.detail.len() > 2), "each has one line of words");
    let with_1 = proposed(&format!("{HEAD}G1$0\n"), "{}", false);
    assert_eq!(labels(&with_1)[0], "G01", "G1 is G01");
    assert!(labels(&with_1)[1..].iter().all(|label| label.starts_with("G1")), "{:?}", labels(&with_1));
    let in_b = g(r#"{"dialect": {"gSystem": "B"}}"#);
    assert!(labels(&in_b).contains(&"G77") && !labels(&in_b).contains(&"G94 X"), "{:?}", labels(&in_b));
    let m = proposed("O1\nT0101\nM$0\n", "{}", false);
    assert_eq!(labels(&m)[..2], ["M03", "M04"], "the spindle stands still");
}

#[test]
fn a_cycle_proposes_its_words_and_the_second_block_after_the_first() {
    let second = proposed(&format!("{HEAD}G76 P021260 Q100 R0.05\nG$0\n"), STOCK, false);
    assert!(second[0].label.starts_with("G76 X"), "{:?}", labels(&second));
    let missing = proposed(&format!("{HEAD}G76 P021260 Q100 R0.05\nG76 X37.4 Z-20 $0\n"), STOCK, false);
    assert_eq!(labels(&missing), ["P", "Q", "F"], "what it needs and does not have");
    let asked = proposed(&format!("{HEAD}G76 P021260 Q100 R0.05\nG76 X37.4 Z-20 $0\n"), STOCK, true);
    assert_eq!(labels(&asked), ["P", "Q", "F", "R"], "what can be left out, after that");
    let nothing = proposed(&format!("{HEAD}G01 X30 $0\n"), STOCK, false);
    assert!(nothing.is_empty(), "a list that nobody asked for is in the way");
}

#[test]
fn values_come_from_the_blank_the_tool_and_the_text() {
    let x = proposed(&format!("{HEAD}G01 X$0\n"), STOCK, false);
    assert_eq!(labels(&x), ["X40", "X42", "X0"]);
    assert!(x[0].detail.ends_with("diameter of the blank"), "{}", x[0].detail);
    let z = proposed(&format!("{HEAD}G01 Z-$0\n"), STOCK, false);
    assert_eq!(labels(&z), ["Z-60"], "the back; the face and the tool are not below zero");
    let w = proposed(&format!("{HEAD}G01 W$0\n"), STOCK, false);
    assert_eq!(labels(&w), ["W-2", "W-62"], "to the face, and to the back");
    let f = proposed(&format!("{HEAD}G01 X30 F0.15\nG01 Z-5 F$0\n"), STOCK, false);
    assert_eq!(labels(&f), ["F0.15", "F0.2"], "the newest first");
    let t = proposed(&format!("{HEAD}T$0\n"), STOCK, false);
    assert_eq!(labels(&t), ["T0101", "T0303"]);
    let point = proposed(
        &format!("{HEAD}G01 X$0\n"),
        r#"{"dialect": {"decimal": "leastIncrement"}, "stock": {"diameter": 40, "length": 60}}"#,
        false,
    );
    assert_eq!(point[0].label, "X40.", "without a point it would be 0.040 mm");
}

#[test]
fn numbers_that_exist_are_proposed_where_a_number_is_named() {
    let contour = "N10 G00 X20\nG01 Z-5\nN20 X42\nM30\nO9000\nM99\n";
    let p = proposed(&format!("{HEAD}G71 U2 R1\nG71 P$0\n{contour}"), "{}", false);
    assert_eq!(labels(&p), ["P10", "P20"]);
    assert_eq!(p[0].detail, "line 6");
    let call = proposed(&format!("{HEAD}M98 P$0\n{contour}"), "{}", false);
    assert_eq!(labels(&call), ["P9000"]);
    let next = proposed(&format!("{HEAD}N$0\n{contour}"), "{}", false);
    assert_eq!(labels(&next), ["N30"]);
    let goto = proposed(&format!("{HEAD}IF [#1 EQ 2] GOTO $0\n{contour}"), "{}", false);
    assert_eq!(labels(&goto), ["10", "20"]);
    let variable = proposed(&format!("{HEAD}#100=5\nG01 X#$0\n"), "{}", false);
    assert_eq!(labels(&variable), ["#100"]);
    assert_eq!(variable[0].detail, "= 5");
    assert!(proposed(&format!("{HEAD}(G$0\n"), "{}", true).is_empty(), "nothing in a comment");
}

/// Each snippet as it stands, after a head, runs without a warning: what is proposed must not be wrong.
#[test]
fn snippets_run_as_they_are() {
    let controls = [
        ("", "G99", "G98", ["G21", "G20"]),
        (r#""gSystem": "B""#, "G95", "G94", ["G21", "G20"]),
        (r#""gSystem": "C""#, "G95", "G94", ["G71", "G70"]),
        (r#""control": "gsk""#, "G99", "G98", ["G21", "G20"]),
        (r#""decimal": "leastIncrement""#, "G99", "G98", ["G21", "G20"]),
    ];
    let blanks = ["null", r#"{"diameter": 40, "length": 60}"#, r#"{"diameter": 8, "length": 12, "grip": 4}"#];
    let all = controls.iter().flat_map(|control| blanks.map(|blank| (control, blank)));
    for ((&(dialect, per_turn, per_minute, units), blank), is_metric) in
        all.flat_map(|control| [true, false].map(|is_metric| (control, is_metric)))
    {
        let unit = units[usize::from(!is_metric)];
        let setup = format!(r#"{{"stock": {blank}, "dialect": {{{dialect}}}}}"#);
        let snippets_in = |program: &str| {
            let items = proposed(program, &setup, true);
            items.into_iter().filter(|item| item.kind == "snippet").collect::<Vec<_>>()
        };
        let named = |items: &[CompletionItem], begins: &str| {
            let found = items.iter().find(|item| item.detail.starts_with(begins));
            found.unwrap_or_else(|| panic!("{dialect}: no {begins}: {:?}", labels(items))).text.clone()
        };
        let first = snippets_in(&format!("{unit}\n$0"));
        let (head, end) = (named(&first, "head of a program"), named(&first, "end of a program"));
        assert!(head.contains(per_turn), "{head}");
        let nearer = match (blank.contains("40"), is_metric) {
            (true, true) => "G00 X41. Z1.",
            (true, false) => "G00 X1.6 Z.05",
            (false, true) => "G00 X7. Z1.",
            (false, false) => "G00 X.3 Z.05",
        };
        for head in [head.clone(), head.replace(per_turn, per_minute), format!("{head}\n{nearer}")] {
            let snippets = snippets_in(&format!("{head}\n$0\n{end}\n"));
            assert!(!snippets.iter().any(|item| item.detail.starts_with("head of")), "it has one");
            assert!(snippets.len() > 12, "{dialect}: {:?}", labels(&snippets));
            for CompletionItem { text, detail, .. } in snippets {
                let program = match () {
                    () if detail.starts_with("end of") => format!("{head}\n{text}\n"),
                    () if detail.starts_with("a subprogram") => format!("{head}\nM98 P2000\n{end}\n{text}\n"),
                    () => format!("{head}\n{text}\n{end}\nO2000\nM99\nO9000\nM99\n"),
                };
                let run = Asking::new(&program, Setup::from_json(&setup).expect("a setup")).run;
                let serious = run.diagnostics().iter().filter(|told| told.severity != Severity::Info);
                let wrong: Vec<_> = serious.map(|told| told.message.slug()).collect();
                assert!(wrong.is_empty(), "{dialect}: {wrong:?} in\n{program}");
            }
        }
    }
}
