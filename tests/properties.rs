//! Invariants for any input: no panic, no hang, spans in bounds, no byte lost; and invariants of the cycles
//! with random numbers.

use crate::random_programs;
use std::time::{Duration, Instant};

use gcode_playground::analyze;
use gcode_playground::api::Places;
use gcode_playground::control::modal::State;
use gcode_playground::expand::expand;
use gcode_playground::findings;
use gcode_playground::geometry::Point;
use gcode_playground::limits::Limits;
use gcode_playground::machine::SimulationResult;
use gcode_playground::motion::{Motion, MotionKind, Motions};
use gcode_playground::run::{Analysis, Run, TextEdit};
use gcode_playground::scene::Scene;
use gcode_playground::scene::face::Face;
use gcode_playground::scene::path_index::PathIndex;
use gcode_playground::scene::svg::{SvgOptions, svg};
use gcode_playground::scene::work::{Moment, Work};
use gcode_playground::sentences::Language;
use gcode_playground::setup::Setup;
use gcode_playground::source::LineIndex;
use gcode_playground::text::highlight::highlight;
use gcode_playground::text::lexer::Lexer;
use proptest::prelude::*;
use random_programs::{any_setup, piece, program};

/// Processes any bytes with all stages and checks the invariants.
fn check(text: &[u8]) {
    let mut at = 0;
    for token in Lexer::new(text, 0) {
        assert_eq!(token.span.start, at, "tokens leave no byte out");
        at = token.span.end;
    }
    assert_eq!(at as usize, text.len());
    let mut last = 0;
    for (span, _) in highlight(text, 0, text.len()) {
        assert!(last <= span.start && span.start < span.end && span.end as usize <= text.len());
        last = span.end;
    }
    check_analysis(text, &analyze(text, &Setup::default()));
}

/// Checks the invariants of the result of a program.
fn check_analysis(text: &[u8], analysis: &Analysis) {
    let lines = LineIndex::new(text);
    let places = Places { text, lines: &lines };
    for diagnostic in &analysis.diagnostics {
        assert!(diagnostic.span.start <= diagnostic.span.end && diagnostic.span.end as usize <= text.len());
        for language in Language::ALL {
            let row = places.diagnostic(diagnostic, language);
            assert!(row.line >= 1 && row.column >= 1 && row.from <= row.to && !row.message.is_empty());
        }
        for edit in diagnostic.fixes.iter().flat_map(|fix| &fix.edits) {
            assert!(edit.span.end as usize <= text.len());
        }
    }
    for index in 0..analysis.motions.len() {
        let (motion, span) = (analysis.motions.get(index), analysis.motions.span(index));
        assert!(span.end as usize <= text.len() && !span.is_empty());
        assert_eq!(analysis.motions.line(index), lines.line_of(span.start));
        let programmed = motion.programmed.map(|programmed| programmed.to);
        let places = [Some(motion.from), Some(motion.to), motion.center, programmed];
        for place in places.into_iter().flatten() {
            assert!(place.x.is_finite() && place.z.is_finite(), "{motion:?}");
        }
        let turn = motion.rotary.map_or(0.0, |rotary| rotary.from + rotary.to);
        assert!(turn.is_finite() && motion.lead.or(motion.seconds).unwrap_or(0.0).is_finite(), "{motion:?}");
    }
    let path_index = PathIndex::of(&analysis.motions);
    let picture = svg(&Scene::new(&analysis.motions, &path_index, None), &SvgOptions::default());
    assert!(picture.contains("<svg"));
    // One setup per program: there are enough programs.
    check_machine(analysis, &at_machine()[text.len() % 3]);
}

/// No program breaks the simulation, and no part is larger than its blank.
fn check_machine(analysis: &Analysis, setup: &Setup) {
    let motions = &analysis.motions;
    let simulation = SimulationResult::of(motions, setup);
    for told in findings::diagnostics(&simulation, motions, &setup.rules, &[]) {
        assert!(!told.message.sentence(Language::English).message.contains("NaN"), "{told:?}");
    }
    if let Some(face) = Face::of(motions, &simulation) {
        let work = face.work(&simulation, None);
        let picture = svg(&face.moves().scene(work.as_ref()), &SvgOptions::default());
        assert!(!picture.contains("NaN") && !picture.contains("inf"));
    }
    let (Some(blank), Some(part)) = (simulation.blank(), simulation.finished()) else { return };
    assert!(part.area() <= blank.area() + 1e-3, "{} of {}", part.area(), blank.area());
    let moment = Moment { motion: motions.len() / 2, share: 0.5, tip: Point::default() };
    for moment in [None, Some(moment)] {
        let work = Work::of(&simulation, motions, moment);
        let path_index = PathIndex::of(motions);
        let picture = svg(&Scene::new(motions, &path_index, work.as_ref()), &SvgOptions::default());
        assert!(!picture.contains("NaN") && !picture.contains("inf"));
    }
}

/// Setups for the machine checks: no fields, only a blank, all fields.
fn at_machine() -> [Setup; 3] {
    [
        "{}",
        r#"{"stock": {"diameter": 80, "bore": 10, "length": 90, "face": 1}}"#,
        r#"{"stock": {"diameter": 80, "length": 90, "grip": 20}, "tailstock": {"z": 5, "diameter": 20},
            "tools": {"T0101": {"type": "turning", "insert": "DNMG150604"}, "T0202": {"type": "boring", "shank": 8},
                      "T0303": {"type": "grooving", "reach": 10}, "T0404": {"type": "threading", "noseRadius": 0.1}},
            "machine": {"rapidX": 5000, "rapidZ": 8000, "travel": {"xMin": -50, "xMax": 300}}}"#,
    ]
    .map(|json| Setup::from_json(json).expect("a setup"))
}

/// Low limits that are reached quickly.
const SMALL: Limits = Limits {
    text: 10_000,
    motions: 600,
    moves_per_cycle: 200,
    cycle_work: 900,
    repeated_blocks: 300,
    repeated_text: 6_000,
    rounds: 150,
    macro_steps: 200,
    call_depth: 4,
    macro_depth: 3,
    messages: 30,
    part_motions: 1000,
    part_corners: 1000,
    compared_blocks: 20_000,
    stride: 7,
};

/// Runs a program with low limits, `slice` blocks at a time, and checks that it ends.
fn run_small(text: &str, setup: &Setup, slice: usize) -> Run {
    to_its_end(begin_small(text, setup), text, slice)
}

fn begin_small(text: &str, setup: &Setup) -> Run {
    Run::new(text.as_bytes().to_vec(), Setup { limits: SMALL, ..setup.clone() })
}

fn to_its_end(mut run: Run, text: &str, slice: usize) -> Run {
    // Each block is read once in order, and once more to report the faults in skipped text; both again if the
    // first program turns out to be a subprogram.
    let most = 2 * (SMALL.repeated_blocks + 2 * text.len() + 4);
    let mut slices = most / slice + 1;
    while !run.advance(slice) {
        slices -= 1;
        assert!(slices > 0, "never ends");
    }
    run
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(512))]

    #[test]
    fn no_macros_calls_and_cycles_break_anything(text in program(), setup in any_setup(), slice in 1usize..9) {
        let whole = run_small(&text, &setup, usize::MAX);
        let state = whole.state();
        prop_assert!([state.position.x, state.position.z, state.c].iter().all(|place| place.is_finite()));
        // If every block is recorded, lines are not executed in batches.
        let kept = to_its_end(begin_small(&text, &setup).traced(), &text, usize::MAX);
        // There are no snapshots either, after which the count of errors restarts.
        let incomplete = kept.state().incomplete;
        prop_assert_eq!(&State { incomplete, ..state.clone() }, kept.state());
        prop_assert_eq!(whole.blocks(), kept.blocks());
        let (state, sliced) = (state.clone(), run_small(&text, &setup, slice));
        let rule = whole.decided_rule();
        prop_assert_eq!(&state, sliced.state());
        let (whole, sliced, kept) = (whole.into_analysis(), sliced.into_analysis(), kept.into_analysis());
        prop_assert!(whole.motions.iter().eq(kept.motions.iter()));
        let place = |motions: &Motions, index| (motions.span(index), motions.line(index));
        let places = |motions: &Motions| (0..motions.len()).map(|index| place(motions, index)).collect::<Vec<_>>();
        prop_assert_eq!(places(&whole.motions), places(&kept.motions));
        prop_assert_eq!(&whole.diagnostics, &kept.diagnostics);
        prop_assert_eq!(&whole.motions, &sliced.motions);
        prop_assert_eq!(&whole.diagnostics, &sliced.diagnostics);
        // Without its middle part, and then with it inserted again, it is the same program.
        let (start, end) = (text.len() / 3, text.len() / 2);
        let without = [&text.as_bytes()[..start], &text.as_bytes()[end..]].concat();
        let small = Setup { limits: SMALL, ..setup.clone() };
        // An edit does not decide the rule again.
        let mut changed = match rule {
            Some(rule) => Run::with_decimal_rule(without, small, rule),
            None => Run::new(without, small),
        };
        while !changed.advance(usize::MAX) {}
        changed.edit(TextEdit { start, end: start, insert: text.as_bytes()[start..end].to_vec() });
        while !changed.advance(usize::MAX) {}
        let changed = changed.into_analysis();
        prop_assert!(whole.motions.iter().eq(changed.motions.iter()));
        prop_assert_eq!(&whole.diagnostics, &changed.diagnostics);
        prop_assert!(whole.motions.len() <= SMALL.motions);
        prop_assert!(whole.diagnostics.len() <= SMALL.messages + 3);
        check_analysis(text.as_bytes(), &whole);
        // The expansion can be parsed and run again.
        let plain = expand(text.as_bytes(), &Setup { limits: SMALL, ..setup.clone() });
        let _ = run_small(&plain, &setup, usize::MAX);
    }

    #[test]
    fn no_bytes_break_anything(text in prop::collection::vec(any::<u8>(), 0..400)) {
        check(&text);
    }

    #[test]
    fn no_program_breaks_anything(pieces in prop::collection::vec(piece(), 0..60)) {
        check(pieces.concat().as_bytes());
    }

    /// A run in slices gives the same result.
    #[test]
    fn a_run_in_slices_is_the_same_run(pieces in prop::collection::vec(piece(), 0..60), slice in 1usize..5) {
        let text = pieces.concat().into_bytes();
        let whole = analyze(&text, &Setup::default());
        let mut run = Run::new(text, Setup::default());
        while !run.advance(slice) {}
        let sliced = run.into_analysis();
        prop_assert_eq!(whole.motions, sliced.motions);
        prop_assert_eq!(whole.diagnostics, sliced.diagnostics);
    }

    /// G90, G92 and G94 end where they began, and are mirrored with their program.
    #[test]
    fn mirrored_cycles_make_mirrored_motions(
        code in prop::sample::select(vec![90, 92, 94]),
        start in (20i32..200, -20i32..20),
        end in (20i32..200, -100i32..-1),
        taper in -9i32..9,
    ) {
        let program = |sign: i32| {
            let taper = if code == 94 { sign * taper } else { taper };
            format!(
                "M3 S500\nG0 X{} Z{}\nG{code} X{} Z{} R{taper} F0.2\nX{}\nG0 X300",
                start.0, sign * start.1, end.0, sign * end.1, end.0 - 2,
            )
        };
        let setup = Setup::from_json(r#"{"dialect": {"threadChamfer": 10}}"#).unwrap();
        let run = |text: String| -> Vec<Motion> { analyze(text.as_bytes(), &setup).motions.iter().collect() };
        let (plain, mirrored) = (run(program(1)), run(program(-1)));
        prop_assert_eq!(plain.len(), mirrored.len());
        // The first motion starts at the start point of the setup, which is not mirrored.
        for (plain, mirrored) in plain.iter().zip(&mirrored).skip(1) {
            prop_assert_eq!(plain.kind, mirrored.kind);
            prop_assert!((plain.to.x - mirrored.to.x).abs() < 1e-9 && (plain.to.z + mirrored.to.z).abs() < 1e-9);
        }
        let home = plain[0].to;
        let returns: Vec<&Motion> = plain.iter().filter(|m| m.cycle.is_some()).collect();
        if let Some(last) = returns.last() {
            prop_assert!(last.to.is_same(home));
        }
    }

    /// A drawn arc meets the programmed end, with any notation of its centre.
    #[test]
    fn arcs_meet_their_end(end in (10i32..100, -50i32..50), radius in 60i32..200, turn in 2..=3) {
        let text = format!("M3 S1\nG0 X40 Z0\nG{turn} X{} Z{} R{radius} F0.1", end.0, end.1);
        let analysis = analyze(text.as_bytes(), &Setup::default());
        for motion in analysis.motions.iter() {
            if let Some(arc) = motion.arc() {
                prop_assert!((arc.radius() - f64::from(radius)).abs() < 1e-6);
                prop_assert!(arc.at(1.0).distance(arc.end) < 1e-6);
                prop_assert!(arc.sweep().abs() <= std::f64::consts::PI + 1e-9);
                prop_assert_eq!(arc.sweep() < 0.0, motion.kind == MotionKind::ArcClockwise);
            }
        }
    }
}

/// Hostile input is processed quickly.
#[test]
fn hostile_texts_are_answered_at_once() {
    // Every byte value at a length that shows quadratic time; some at the full 5 MB.
    let (short, five) = (50 << 10, 5 << 20);
    let mut texts: Vec<(String, Vec<u8>)> =
        (0..=255u8).map(|byte| (format!("50 kB of {byte:#04x}"), vec![byte; short])).collect();
    texts.extend(b"X(0\n ;\xff".iter().map(|&byte| (format!("5 MB of {byte:#04x}"), vec![byte; five])));
    for unit in [
        "X1", "G1X1Z1\n", "(", "()", "G0 X1;", "X1 ", "O1\n", "N1", "#1=", "[", "Z,", "GO", "−", "%\n",
        "\r\n",
    ] {
        texts.push((format!("50 kB of {unit:?}"), unit.repeat(short / unit.len()).into_bytes()));
    }
    for (name, text) in texts {
        let begun = Instant::now();
        let analysis = analyze(&text, &Setup::default());
        let took = begun.elapsed();
        assert!(took < Duration::from_secs(10), "{name}: {took:?}");
        assert!(!analysis.diagnostics.is_empty() || !analysis.motions.is_empty(), "{name}: nothing is said");
    }
}

#[test]
fn every_bound_has_its_message() {
    let codes = |text: &str, limits: Limits| -> Vec<&'static str> {
        let mut run = Run::new(text.as_bytes().to_vec(), Setup { limits, ..Setup::default() });
        while !run.advance(usize::MAX) {}
        run.diagnostics().iter().map(|diagnostic| diagnostic.message.code()).collect()
    };
    let limits = Limits::default();
    assert!(codes(&"X1".repeat(100), limits).contains(&"E-BLOCK-TOO-LONG"));
    assert!(codes("G0 X1", Limits { text: 3, ..limits }).contains(&"E-TEXT-TOO-LONG"));
    assert!(codes("G0 X1\nX2\nX3", Limits { motions: 2, ..limits }).contains(&"E-TOO-MANY-MOTIONS"));
    assert!(codes("X\nX\nX\nX\n", Limits { messages: 2, ..limits }).contains(&"I-MORE"));
    assert!(codes("", limits).contains(&"I-EMPTY"));
    let cycle = "F1\nG73 U1 R9\nG73 P1 Q2\nN1 G0 X1\nN2 X2\nG70 P1 Q2\nG70 P1 Q2";
    assert!(codes(cycle, Limits { moves_per_cycle: 8, ..limits }).contains(&"E-TOO-MANY-PASSES"));
    assert!(codes(cycle, Limits { moves_per_cycle: 1, ..limits }).contains(&"E-TOO-MANY-PASSES"));
    assert!(codes(cycle, Limits { cycle_work: 3, ..limits }).contains(&"E-TOO-MUCH-WORK"));
    assert!(!codes(cycle, limits).iter().any(|code| code.starts_with("E-TOO")));
    let mut run = Run::new(b"G0 X1\nX2".to_vec(), Setup::default());
    run.advance(1);
    run.stop(10.0);
    assert!(run.diagnostics().iter().any(|diagnostic| diagnostic.message.code() == "E-STOPPED"));
}
