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
use gcode_playground::api::assist::{Reader, StateHelp, WordHelp};
use gcode_playground::assist::Asked;
use gcode_playground::assist::role::Role;
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
        self.with(byte, time, language, |asked, reader, _| reader.state(asked))
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
        } else if fs::read_to_string(&expected).ok().as_ref() != Some(&answered) {
            changed.push((path, answered));
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
