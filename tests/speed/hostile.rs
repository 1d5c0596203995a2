//! Measures the hostile programs of `tests/endless` natively. Part of `cargo xtask test --all` and
//! `cargo xtask bench`.
//!
//! In: a folder. Out: the programs as files in that folder, and `cases.json`, which lists them with their
//! messages, their times and how the times were measured. `tests/speed/hostile.mjs` reads it, runs the same
//! programs in wasm and judges the times.

#[path = "../endless/mod.rs"]
#[allow(dead_code, unused_imports, reason = "the tests use the rest of it")]
mod endless;

use std::path::{Path, PathBuf};
use std::time::Instant;
use std::{env, fs, io};

use endless::{Hostile, MAX_SECONDS, hostile};
use gcode_playground::analyze;
use gcode_playground::api::{Places, Summary};
use gcode_playground::convert::{ProgramForm, converted};
use gcode_playground::export::card::Card;
use gcode_playground::paste::find;
use gcode_playground::run::Run;
use gcode_playground::scene::path_index::PathIndex;
use gcode_playground::sentences::Language;
use gcode_playground::setup::Setup;
use gcode_playground::source::LineIndex;
use gcode_playground::text::highlight::highlight;
use serde::Serialize;

/// Total number of attempts for a program that is too slow: the machine may have been busy.
const ATTEMPTS: usize = 3;

/// Time limit for an answer, seconds. Half as much again as on a quiet machine: measurements on shared
/// processors were slower by that much.
const LONGEST: f64 = 1.5 * MAX_SECONDS;

/// Number of lines that a page shows at once.
const SHOWN_LINES: u32 = 60;

/// The contents of `cases.json`: the programs, and how they are measured.
#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct Cases {
    /// Native time limit for an answer.
    most_seconds: f64,
    attempts: usize,
    shown_lines: u32,
    cases: Vec<Case>,
}

/// A program and its measured result.
#[derive(Serialize)]
struct Case {
    name: String,
    file: String,
    setup: &'static str,
    bytes: usize,
    /// Code and line of the message that must be reported.
    code: &'static str,
    line: u32,
    /// Whether it was reported.
    told: bool,
    motions: u32,
    /// Milliseconds until the messages and the first content of a page are ready.
    answer: f64,
}

fn main() -> io::Result<()> {
    // cargo appends its own options to ours.
    let folder = env::args().skip(1).find(|argument| !argument.starts_with('-'));
    let folder = PathBuf::from(folder.unwrap_or_else(|| "target/hostile".into()));
    fs::create_dir_all(&folder)?;
    let all = hostile();
    let cases: io::Result<_> =
        all.iter().enumerate().map(|(index, case)| measured(case, index, &folder)).collect();
    quick_enough()?;
    let (most_seconds, attempts, shown_lines) = (LONGEST, ATTEMPTS, SHOWN_LINES);
    let told = Cases { most_seconds, attempts, shown_lines, cases: cases? };
    fs::write(folder.join("cases.json"), serde_json::to_string(&told)?)
}

/// Work that once took quadratic time or was slow: the setup sheet of 100,000 tools, other forms of many blocks, and the
/// search for programs in a line of 10 MB.
fn quick_enough() -> io::Result<()> {
    let tools: String = (1..=100_000).map(|tool| format!("T{tool:04}\nG00 X50 Z2\nG01 Z-5 F0.2\n")).collect();
    within("a setup sheet", 2.0, || {
        let text = format!("G97 S500 M03\n{tools}M30\n");
        let analysis = analyze(text.as_bytes(), &Setup::default());
        let card = Card {
            text: text.as_bytes(),
            motions: &analysis.motions,
            setup: &analysis.setup,
            codes: analysis.codes,
            unit: analysis.unit,
            drawings: &[],
        };
        card.html(Language::English).len()
    })?;
    let line = "X1".repeat(5_000_000);
    let moves: String =
        (0..100_000).map(|line| format!("G01 X{} Z-{} F0.2\n", line % 90, line % 70)).collect();
    let other_form = |text: &str| {
        converted(text.as_bytes(), text.len(), &Setup::default(), ProgramForm::Incremental).edits.len()
    };
    within("distances of 100,000 lines", 4.0, || other_form(&format!("G00 X50 Z2\n{moves}M30\n")))?;
    let finishing: String = (1..50_000).map(|number| format!("N{number} G70 P99999 Q99998\n")).collect();
    within("50,000 contours that are missing", 4.0, || other_form(&format!("G00 X50 Z2\n{finishing}M30\n")))?;
    within("a line of 10 MB", 4.0, || find(&line).programs.iter().map(|program| program.text().len()).sum())
}

/// Fails if each of [`ATTEMPTS`] attempts takes longer than `most` seconds.
fn within(name: &str, most: f64, work: impl Fn() -> usize) -> io::Result<()> {
    let mut best = f64::INFINITY;
    for _ in 0..ATTEMPTS {
        let watch = Watch::start();
        std::hint::black_box(work());
        best = best.min(watch.milliseconds() / 1e3);
        if best <= most {
            println!("{name}: {best:.2} s");
            return Ok(());
        }
    }
    Err(io::Error::other(format!("{name} takes {best:.2} s; {most} s are allowed")))
}

fn measured(case: &Hostile, index: usize, folder: &Path) -> io::Result<Case> {
    let file = format!("{index:03}.nc");
    fs::write(folder.join(&file), &case.text)?;
    let setup = Setup::from_json(case.setup).map_err(io::Error::other)?;
    let mut best = answer(case, &setup);
    for _ in 1..ATTEMPTS {
        if best.0 > 1e3 * LONGEST {
            best.0 = best.0.min(answer(case, &setup).0);
        }
    }
    let (answer, told, motions) = best;
    Ok(Case {
        name: case.name.clone(),
        file,
        setup: case.setup,
        bytes: case.text.len(),
        code: case.code,
        line: case.line,
        told,
        motions,
        answer,
    })
}

/// Everything that a page requests at once: milliseconds, whether the message was reported, and the number of
/// motions.
fn answer(case: &Hostile, setup: &Setup) -> (f64, bool, u32) {
    let watch = Watch::start();
    let mut run = Run::new(case.text.clone(), setup.clone());
    while !run.advance(1_000) {}
    let summary = Summary::new(run.motions(), run.diagnostics());
    let lines = LineIndex::new(&case.text);
    let places = Places { text: &case.text, lines: &lines };
    let row = |found| places.diagnostic(found, Language::English);
    let told: Vec<_> = run.diagnostics().iter().map(row).collect();
    let shown = lines.line(&case.text, lines.len().min(SHOWN_LINES) - 1).end as usize;
    let tokens: Vec<_> =
        highlight(&case.text, 0, shown).into_iter().map(|(span, _)| places.offsets(span)).collect();
    let path_index = PathIndex::of(run.motions());
    let taken = watch.milliseconds();
    std::hint::black_box((tokens, path_index));
    (taken, told.iter().any(|row| row.code == case.code && row.line == case.line), summary.motions)
}

/// Measures a piece of work: the processor time of the thread if the system reports it and it is shorter,
/// otherwise the elapsed time.
struct Watch {
    begun: Instant,
    computed: Option<f64>,
}

impl Watch {
    fn start() -> Self {
        Self { begun: Instant::now(), computed: computed() }
    }

    fn milliseconds(&self) -> f64 {
        let taken = self.begun.elapsed().as_secs_f64() * 1e3;
        match (self.computed, computed()) {
            (Some(before), Some(after)) => taken.min(after - before),
            _ => taken,
        }
    }
}

/// Processor time of this thread as Linux reports it, ms.
fn computed() -> Option<f64> {
    let told = fs::read_to_string("/proc/thread-self/schedstat").ok()?;
    told.split_whitespace().next()?.parse::<f64>().ok().map(|nanoseconds| nanoseconds / 1e6)
}
