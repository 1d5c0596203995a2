//! What holds for any input at all: no panic, no hang, spans in bounds, nothing lost; and invariants of the
//! cycles over random numbers.
#![cfg(not(target_arch = "wasm32"))]

use std::time::{Duration, Instant};

use gcode_playground::analyze;
use gcode_playground::api::Places;
use gcode_playground::control::setup::Setup;
use gcode_playground::diagnostics::messages::Language;
use gcode_playground::limits::Limits;
use gcode_playground::motion::{Motion, MotionKind};
use gcode_playground::run::Run;
use gcode_playground::scene::Scene;
use gcode_playground::scene::outline::Outline;
use gcode_playground::scene::svg::{SvgOptions, svg};
use gcode_playground::text::highlight::highlight;
use gcode_playground::text::lexer::Lexer;
use gcode_playground::text::source::LineIndex;
use proptest::prelude::*;

/// Runs some bytes through everything and checks what must always hold.
fn check(text: &[u8]) {
    let mut at = 0;
    for token in Lexer::new(text, 0) {
        assert_eq!(token.span.start, at, "tokens leave no byte out");
        at = token.span.end;
    }
    assert_eq!(at as usize, text.len());
    let analysis = analyze(text, &Setup::default());
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
        assert!(motion.to.x.is_finite() && motion.to.z.is_finite());
    }
    let mut last = 0;
    for (span, _) in highlight(text, 0, text.len()) {
        assert!(last <= span.start && span.start < span.end && span.end as usize <= text.len());
        last = span.end;
    }
    let outline = Outline::of(&analysis.motions);
    let picture = svg(&Scene::new(&analysis.motions, &outline, None), &SvgOptions::default());
    assert!(picture.contains("<svg"));
}

/// Pieces that programs are made of, good and bad.
fn piece() -> impl Strategy<Value = String> {
    let codes =
        "(G0|G00|G1|G2|G3|G4|G20|G21|G28|G32|G50|G52|G54|G59|G90|G92|G94|G96|G97|G98|G99|G71|G33|M3|M30)";
    prop_oneof![
        6 => codes,
        8 => "[XZUWRIKFSTPQJL] ?-?[0-9]{0,3}\\.?[0-9]{0,4}",
        1 => "[ \\t;\\n\r%/(),.:#\\[\\]=*A-Z−；（）外0-9-]{1,3}",
        1 => "(O0002|N10|\\(a\\)|;|\n|\r\n|#1=2|IF\\[#1 EQ 2\\]GOTO 10| )",
        2 => "\n",
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(512))]

    #[test]
    fn no_bytes_break_anything(text in prop::collection::vec(any::<u8>(), 0..400)) {
        check(&text);
    }

    #[test]
    fn no_program_breaks_anything(pieces in prop::collection::vec(piece(), 0..60)) {
        check(pieces.concat().as_bytes());
    }

    /// Slices of a run make no difference.
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

    /// G90, G92 and G94 end where they began, and turn over with their program.
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
        // The first motion comes from the start point of the setup, which is not mirrored.
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

    /// The arc drawn meets the programmed end, whichever way its centre is given.
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

/// Bad input is answered at once.
#[test]
fn hostile_texts_are_answered_at_once() {
    // Every byte at a length that shows a square law; some at the full 5 MB.
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
        let mut run = Run::within(text.as_bytes().to_vec(), Setup::default(), limits);
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
