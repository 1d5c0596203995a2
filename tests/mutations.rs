//! Common faults, inserted into every correct program of `tests/programs` at every word where they apply.
//! Checks that the first message is at the fault, that its fix restores the motions, and that not all of its
//! fixes lead to another message.
//!
//! Some faults result in a valid program for another part, which only the drawing can distinguish from the
//! intended one. They are marked in the table, and no rate is required for them.
//!
//! `cargo test --test it mutations:: -- --nocapture` prints the table. `CLASS=minus` runs only the classes
//! whose names contain that word. `MISSES=file` writes every program whose message is misplaced, or whose
//! fixes do not restore it, to that file.

use crate::classes;
use crate::fixtures;
use crate::format;
use crate::text;
use std::collections::BTreeMap;

use classes::{CLASSES, Class, Known, Mutant, Need, Place};
use gcode_playground::machine::inferred::InferredSetup;
use gcode_playground::message::{Diagnostic, Fix, Severity};
use gcode_playground::motion::{Motion, MotionKind, Motions, Process};
use gcode_playground::run::{Analysis, Run};
use gcode_playground::sentences::Language;
use gcode_playground::setup::{Blank, Setup};
use text::Words;

/// Required share of faults of a class whose first message is at the fault, per cent.
const ASKED: f64 = 95.0;

/// Classes that are harder to detect from the program alone, with the required share and the reason.
const BELOW: [(&str, f64, &str); 14] = [
    ("dropped decimal point", 90.0, "a move out ten times as far is a place like any other"),
    ("lost minus", 79.0, "a retract to Z2 for Z-2 is a place like any other"),
    ("P and Q exchanged", 92.0, "infeed and shift of G74 and G75 may be either way round"),
    ("R not extended", 92.0, "between the passes beside it, it is one more pass"),
    ("U for X", 76.0, "who counts in increments now and then means it"),
    ("X for U", 84.0, "a place is as likely as an increment"),
    ("missing F", 87.0, "the F before it is still in force"),
    ("missing S", 90.0, "the S before it is still in force"),
    ("start inside the stock", 92.0, "in front of the work a smaller cut may begin there"),
    ("spindle too fast for the lead", 85.0, "the rule of thumb is for passes, not for taps"),
    ("passes of a thread exchanged", 92.0, "of several starts the order may be meant"),
    ("start angle lost", 79.0, "before another start has shown, it is a spring pass"),
    ("pass ten times as deep", 90.0, "where a taper no longer fits, R or X may be wrong: R is marked"),
    (
        "feed ten times too large",
        90.0,
        "a way out along a shoulder may be a retract, and F of a contour shows at G70",
    ),
];

/// Programs that are wrong on purpose.
const WRONG: [&str; 4] =
    ["s001-frag-g90-i-asprinted", "s002-g121-square-asprinted", "s004-g94-wrong", "syn-g90-r-violation"];

/// A run and the control's state after it.
struct Ran {
    analysis: Analysis,
    state: String,
}

fn run(text: &str, setup: &Setup) -> Ran {
    let mut run = Run::new(text.as_bytes().to_vec(), setup.clone());
    while !run.advance(usize::MAX) {}
    let state = run.state();
    // The state that affects later blocks, without positions in the text.
    let state = format!(
        "{:?}",
        (
            (state.position, state.motion, state.plane, state.unit, state.feed_mode, state.feed),
            (state.spindle, state.compensation, state.tool, &state.frames, &state.virtual_plane),
        )
    );
    Ran { analysis: run.into_analysis(), state }
}

/// The visible properties of a motion.
fn seen(motion: &Motion) -> Motion {
    Motion { process: Process { uncertain: false, incomplete: false, ..motion.process }, ..*motion }
}

fn same_motions(a: &Motions, b: &Motions) -> bool {
    a.len() == b.len() && a.iter().zip(b.iter()).all(|(a, b)| seen(&a) == seen(&b))
}

/// Number of the line that contains a byte, counted from 0.
fn line(text: &str, at: usize) -> usize {
    text[..at.min(text.len())].matches('\n').count()
}

/// A correct program, its setup with a blank, and its run.
struct Correct {
    id: String,
    text: String,
    setup: Setup,
    ran: Ran,
    /// Messages of the unchanged program, by slug and line.
    known: Vec<(&'static str, usize)>,
}

/// How often a message occurs.
fn count(slug: &str, told: &[Diagnostic]) -> usize {
    told.iter().filter(|told| told.message.slug() == slug).count()
}

impl Correct {
    fn new(id: String, text: String, setup: &str) -> Self {
        let mut setup = Setup::from_json(setup).expect(&id);
        let first = run(&text, &setup);
        // Users who check for collisions give the blank. Here the inferred blank is given.
        let inferred = || InferredSetup::of(&first.analysis.motions).stock.map(Blank::from);
        setup.stock = setup.stock.or_else(inferred);
        let mut ran = run(&text, &setup);
        ran.analysis.check_at_machine();
        let told = ran.analysis.diagnostics.iter().filter(|told| told.severity > Severity::Info);
        let known = told.map(|told| (told.message.slug(), line(&text, told.span.start as usize)));
        let known = known.collect();
        Self { id, text, setup, ran, known }
    }

    /// The first message that the fault causes.
    fn first_new<'a>(&self, text: &str, told: &'a [Diagnostic]) -> Option<&'a Diagnostic> {
        let told_all = told;
        told.iter().find(|told| {
            let key = (told.message.slug(), line(text, told.span.start as usize));
            let grows = text.matches('\n').count() - self.text.matches('\n').count();
            let before = (key.0, key.1.saturating_sub(grows));
            // A message that is reported once per program may have moved to another block.
            let moved = count(key.0, told_all) <= self.known.iter().filter(|known| known.0 == key.0).count();
            told.severity > Severity::Info
                && !moved
                && !self.known.contains(&key)
                && !self.known.contains(&before)
        })
    }
}

/// Whether a message is at the fault.
fn stands_at(mutant: &Mutant, correct: &Correct, told: &Diagnostic) -> bool {
    let (from, to) = (told.span.start as usize, told.span.end as usize);
    let touches =
        |start: usize, end: usize| from < end && start < to || from == to && (start..=end).contains(&from);
    let same_line = |at: usize| line(&mutant.text, from) == line(&mutant.text, at);
    match mutant.place {
        Place::At(start, end) => touches(start, end),
        Place::Needed(at, Need::Word(start, end)) => same_line(at) || same_line(start) || touches(start, end),
        Place::Needed(at, Need::End) => same_line(at) || to + 2 >= mutant.text.trim_end().len(),
        Place::Needed(at, Need::Cut) => {
            // The first later block that cuts in the correct program.
            let here = line(&mutant.text, at);
            let cuts = |motion: &(usize, Motion)| {
                !matches!(motion.1.kind, MotionKind::Rapid | MotionKind::Dwell)
                    && correct.ran.analysis.motions.line(motion.0) as usize >= here
            };
            let first = correct.ran.analysis.motions.iter().enumerate().find(cuts);
            let needing = first.map(|(index, _)| correct.ran.analysis.motions.line(index) as usize);
            let found = line(&mutant.text, from);
            found == here || Some(found) == needing
        }
    }
}

/// The text with a fix applied.
fn repaired(text: &str, fix: &Fix) -> Option<String> {
    let mut text = text.as_bytes().to_vec();
    for edit in fix.edits.iter().rev() {
        text.splice(edit.span.start as usize..edit.span.end as usize, edit.text.bytes());
    }
    String::from_utf8(text).ok()
}

/// A message that replaces the fixed one: of a rule that neither the program nor the mutant triggered.
fn replaced_by(correct: &Correct, mutant: &Mutant, told: &[Diagnostic], fix: &Fix) -> Option<Diagnostic> {
    let text = repaired(&mutant.text, fix)?;
    let after = run(&text, &correct.setup).analysis.diagnostics;
    let is_known = |one: &Diagnostic| {
        let slug = one.message.slug();
        correct.known.iter().any(|known| known.0 == slug) || count(slug, told) >= count(slug, &after)
    };
    after.iter().find(|one| one.severity > Severity::Info && !is_known(one)).cloned()
}

/// The line of a message.
fn row<'a>(text: &'a str, told: &Diagnostic) -> &'a str {
    text.lines().nth(line(text, told.span.start as usize)).unwrap_or("")
}

#[derive(Default)]
struct Score {
    mutants: usize,
    at_place: usize,
    restored: usize,
    /// Number of first messages with fixes, and of those whose fixes all lead to another message.
    advised: usize,
    dead_ends: usize,
}

fn judge(class: &Class, correct: &Correct, mutant: &Mutant, score: &mut Score, misses: &mut Vec<String>) {
    let mut ran = run(&mutant.text, &correct.setup);
    let unchanged =
        ran.state == correct.ran.state && same_motions(&ran.analysis.motions, &correct.ran.analysis.motions);
    if unchanged && !class.unseen {
        return;
    }
    score.mutants += 1;
    // The machine checks run only if the program alone shows nothing: they take long.
    let early = correct
        .first_new(&mutant.text, &ran.analysis.diagnostics)
        .is_some_and(|told| stands_at(mutant, correct, told));
    if !early {
        ran.analysis.check_at_machine();
    }
    let first = correct.first_new(&mutant.text, &ran.analysis.diagnostics);
    let at_place = first.is_some_and(|told| stands_at(mutant, correct, told));
    score.at_place += usize::from(at_place);
    let restores = |told: &Diagnostic| {
        // If only the author can know, several fixes are offered, and one of them must be right.
        told.fixes.iter().filter_map(|fix| repaired(&mutant.text, fix)).any(|text| {
            same_motions(&run(&text, &correct.setup).analysis.motions, &correct.ran.analysis.motions)
        })
    };
    let restored = first.is_some_and(restores);
    score.restored += usize::from(restored);
    if let Some(told) = first.filter(|told| !told.fixes.is_empty()) {
        score.advised += 1;
        let all = &ran.analysis.diagnostics;
        let next: Option<Vec<_>> =
            told.fixes.iter().map(|fix| Some((fix, replaced_by(correct, mutant, all, fix)?))).collect();
        // If only the author can know, several fixes are offered, and one of them must not lead to another
        // message.
        for (fix, next) in next.iter().flatten() {
            misses.push(format!(
                "leads on | {} | {} | {} `{}` | {} | {}",
                class.name,
                correct.id,
                told.message.slug(),
                row(&mutant.text, told),
                fix.title.words(Language::English),
                next.message.slug()
            ));
        }
        score.dead_ends += usize::from(next.is_some());
    }
    if !at_place || !restored {
        let place = match mutant.place {
            Place::At(start, _) | Place::Needed(start, _) => start,
        };
        let row = mutant.text.lines().nth(line(&mutant.text, place)).unwrap_or("");
        let told = first.map_or("nothing".to_owned(), |told| {
            let quoted = told.span.quote(mutant.text.as_bytes());
            let fixes = told.fixes.len();
            format!(
                "{} at line {} `{quoted}` fixes {fixes}",
                told.message.slug(),
                1 + line(&mutant.text, told.span.start as usize)
            )
        });
        let what = if at_place { "not restored" } else { "misplaced" };
        misses.push(format!(
            "{what} | {} | {} | line {} `{row}` | {told}",
            class.name,
            correct.id,
            1 + line(&mutant.text, place)
        ));
    }
}

#[test]
fn the_first_message_stands_at_the_fault() {
    let only = std::env::var("CLASS").ok();
    let fixtures = fixtures::all().into_iter().filter(|program| !WRONG.contains(&program.id.as_str()));
    let programs = fixtures.map(|program| Correct::new(program.id, program.text, &program.setup));
    // The corrected programs of the rule pages are used as well, except those about limits, whose setups have
    // low limits.
    let rules = format::all(env!("CARGO_MANIFEST_DIR")).into_iter().filter_map(|(_, rule)| rule.ok());
    let rules = rules.filter(|rule| !rule.page.setup.contains("limits"));
    let corrected = rules.map(|rule| Correct::new(rule.slug, rule.page.right, &rule.page.setup));
    let mut programs: Vec<Correct> = programs.collect();
    let whole_programs = programs.len();
    programs.extend(corrected);
    assert!(programs.len() >= 40, "{} programs", programs.len());
    let mut scores: BTreeMap<usize, Score> = BTreeMap::new();
    let mut misses = Vec::new();
    for (number, correct) in programs.iter().enumerate() {
        let words = Words::of(&correct.text);
        for (index, class) in CLASSES.iter().enumerate() {
            if only.as_ref().is_some_and(|only| !class.name.contains(only.as_str())) {
                continue;
            }
            // The examples of the pages are not complete programs.
            if class.known == Known::Drawing && number >= whole_programs {
                continue;
            }
            for mutant in (class.make)(&words) {
                judge(class, correct, &mutant, scores.entry(index).or_default(), &mut misses);
            }
        }
    }
    if let Some(path) = std::env::var_os("MISSES") {
        std::fs::write(path, misses.join("\n")).expect("misses");
    }
    let percent = |part: usize, whole: usize| 100.0 * part as f64 / whole.max(1) as f64;
    let mut whole = Score::default();
    let mut low = Vec::new();
    println!(
        "{:32} {:>8} {:>8} {:>9} {:>7} {:>8}  known from",
        "fault", "programs", "at place", "restored", "advised", "lead on"
    );
    for (index, class) in CLASSES.iter().enumerate() {
        let score = scores.remove(&index).unwrap_or_default();
        let (place, restored) =
            (percent(score.at_place, score.mutants), percent(score.restored, score.mutants));
        println!(
            "{:32} {:>8} {place:>7.1}% {restored:>8.1}% {:>7} {:>8}  {}",
            class.name,
            score.mutants,
            score.advised,
            score.dead_ends,
            match class.known {
                Known::Program => "the program",
                Known::Drawing => "the drawing",
            }
        );
        if class.known == Known::Drawing {
            if only.is_none() && score.mutants == 0 {
                low.push(format!("{}: no programs", class.name));
            }
            continue;
        }
        let asked = BELOW.iter().find(|below| below.0 == class.name).map_or(ASKED, |below| below.1);
        if only.is_none() && (score.mutants == 0 || place < asked) {
            low.push(format!("{}: {} programs, {place:.1} %", class.name, score.mutants));
        }
        // Sometimes the fault hides another one, which deserves its own message.
        if only.is_none() && score.dead_ends > 4.max(score.advised / 100) {
            let (dead_ends, advised) = (score.dead_ends, score.advised);
            low.push(format!("{}: {dead_ends} of {advised} repairs lead to another message", class.name));
        }
        whole.advised += score.advised;
        whole.dead_ends += score.dead_ends;
        whole.mutants += score.mutants;
        whole.at_place += score.at_place;
        whole.restored += score.restored;
    }
    let (place, restored) = (percent(whole.at_place, whole.mutants), percent(whole.restored, whole.mutants));
    println!("{:32} {:>8} {place:>7.1}% {restored:>8.1}%", "all", whole.mutants);
    assert!(low.is_empty(), "classes whose first message stands elsewhere or leads on too often: {low:#?}");
    assert!(whole.dead_ends * 300 <= whole.advised, "{} of {} lead on", whole.dead_ends, whole.advised);
    assert!(
        only.is_some() || place >= 90.0 && restored >= 60.0,
        "{place:.1} % at place, {restored:.1} % restored"
    );
}
