//! Programs that would run forever: each ends within seconds, with a message that says why.

use crate::endless;
use std::time::{Duration, Instant};

use endless::{Hostile, MAX_SECONDS, bounds, endless, hostile};
use gcode_playground::analyze;
use gcode_playground::limits::Limits;
use gcode_playground::message::{Diagnostic, Severity};
use gcode_playground::run::{Analysis, Run};
use gcode_playground::setup::Setup;
use gcode_playground::source::LineIndex;

/// Analyses a program under a setup and checks the time.
#[track_caller]
fn run_within(most: Duration, name: &str, setup: &str, text: &(impl AsRef<[u8]> + ?Sized)) -> Analysis {
    let setup = Setup::from_json(setup).expect("setup");
    let begun = Instant::now();
    let analysis = analyze(text.as_ref(), &setup);
    let took = begun.elapsed();
    assert!(took < most, "{name}: {took:?}");
    analysis
}

/// The same with a generous time limit, enough for a slow build on a busy machine.
#[track_caller]
fn run(name: &str, setup: &str, text: &(impl AsRef<[u8]> + ?Sized)) -> Analysis {
    run_within(Duration::from_secs(10), name, setup, text)
}

fn codes(analysis: &Analysis) -> Vec<String> {
    let told = analysis.diagnostics.iter().filter(|found| found.severity > Severity::Info);
    told.map(Diagnostic::code).collect()
}

#[test]
fn cycles_of_far_too_many_passes_are_refused_at_once() {
    for case in endless() {
        let most = Duration::from_secs_f64(MAX_SECONDS);
        let analysis = run_within(most, case.name, case.setup, &case.text);
        assert!(
            codes(&analysis).iter().any(|code| code == case.code),
            "{}: {:?}",
            case.name,
            codes(&analysis)
        );
        // At most the contour of the cycle is drawn, as uncertain.
        assert!(analysis.motions.len() <= 10, "{}", case.name);
        let certain = analysis.motions.iter().filter(|motion| !motion.process.uncertain).count();
        assert_eq!(certain, 1, "{}", case.name);
    }
}

#[test]
fn hostile_programs_end_with_their_message() {
    hostile().iter().for_each(ends_with_its_message);
}

fn ends_with_its_message(case: &Hostile) {
    let analysis = run(&case.name, case.setup, &case.text);
    let lines = LineIndex::new(&case.text);
    let told = |found: &Diagnostic| (found.code(), lines.line_of(found.span.start) + 1);
    let found: Vec<_> = analysis.diagnostics.iter().map(told).collect();
    assert!(
        found.iter().any(|(code, line)| code == case.code && *line == case.line),
        "{}: {found:?}",
        case.name
    );
    assert!(found.len() <= Limits::default().messages + 3, "{}", case.name);
}

/// For each limit, a program just within it runs, and one that exceeds it by one is reported.
#[test]
fn every_bound_is_exact() {
    for bound in bounds() {
        let slugs = |text: &str| -> Vec<&'static str> {
            let mut analysis = run(bound.slug, &bound.setup, text);
            analysis.check_at_machine();
            analysis.diagnostics.iter().map(|found| found.message.slug()).collect()
        };
        let (within, beyond) = (slugs(&bound.within), slugs(&bound.beyond));
        assert!(!within.contains(&bound.slug), "{}: {within:?}", bound.slug);
        assert!(beyond.contains(&bound.slug), "{}: {beyond:?}", bound.slug);
    }
}

/// A limit can be set to any low value, but only up to a maximum.
#[test]
fn limits_are_set_by_name_and_within_reason() {
    let limits = |json: &str| Setup::from_json(json).map(|setup| setup.limits);
    let usual = Limits::default();
    assert_eq!(limits("{}"), Ok(usual));
    assert_eq!(limits(r#"{"limits": {}}"#), Ok(usual));
    assert_eq!(
        limits(r#"{"limits": {"motions": 0, "callDepth": 100}}"#),
        Ok(Limits { motions: 0, call_depth: 100, ..usual })
    );
    let refused = |json: &str, what: &str| {
        let problem = limits(json).expect_err(what);
        assert!(problem.contains(what), "{problem}");
    };
    refused(r#"{"limits": {"motions": 20000001}}"#, "limits.motions is 20000001; the maximum is 20000000");
    refused(r#"{"limits": {"macroDepth": 6}}"#, "limits.macroDepth");
    refused(r#"{"limits": {"movements": 1}}"#, "unknown field `movements`");
    refused(r#"{"limits": {"stride": 1}}"#, "unknown field `stride`");
    refused(r#"{"limits": {"motions": -1}}"#, "-1");
}

#[test]
fn the_reference_lists_every_limit() {
    let page = include_str!("../www/docs/limits.md");
    for (name, usual, most) in Limits::default().settings() {
        let most = if most == 1_000_000_000 { "10⁹".into() } else { most.to_string() };
        let row = format!("| `{name}` | {usual} | {most} | ");
        assert!(page.contains(&row), "{row}");
    }
}

/// The reason for the end of a run is reported even if the limit of messages is reached.
#[test]
fn the_reason_for_the_end_is_always_told() {
    let limits = Limits { messages: 2, repeated_blocks: 99, motions: 2, ..Limits::default() };
    for (text, code) in [
        ("X\nX\nX\nN1 GOTO 1\n", "E-ENDLESS"),
        ("X\nX\nX\nM99\n", "W-ENDLESS"),
        ("X\nX\nX\nX1\nX2\nX3\n", "E-TOO-MANY-MOTIONS"),
        ("O1\nX\nX\nX\nM98 P1\n", "PS0077"),
        ("X\nX\nX\n#3000=1\n", "E-MACRO-ALARM"),
    ] {
        let mut run = Run::new(text.as_bytes().to_vec(), Setup { limits, ..Setup::default() });
        while !run.advance(usize::MAX) {}
        assert!(run.diagnostics().iter().any(|found| found.message.code() == code), "{text}");
    }
}

/// A cycle that exceeds the work limit of a run is reported as one error.
#[test]
fn a_cycle_that_ends_the_run_is_told_of_once() {
    let limits = Limits { cycle_work: 10, moves_per_cycle: 50, ..Limits::default() };
    for text in
        ["M3 S1\nG83 Z-9 Q1 F1\nX1", "M3 S1 F1\nX90 Z2\nG71 U0.01 R1\nG71 P1 Q2\nN1 G0 X20\nN2 G1 Z-20\nX40"]
    {
        let analysis = analyze(text.as_bytes(), &Setup { limits, ..Setup::default() });
        let errors = analysis.diagnostics.iter().filter(|found| found.is_error());
        let found: Vec<_> = errors.map(|found| found.message.slug()).collect();
        assert_eq!(found, ["too-much-work"], "{text}");
    }
}

/// M99 of a main program repeats it as long as a value that the program reads changes.
#[test]
fn rounds_of_the_main_program_end_by_what_they_ask_for() {
    let slugs = |text: &str| -> Vec<&'static str> {
        run(text, "{}", text).diagnostics.iter().map(|found| found.message.slug()).collect()
    };
    for text in [
        "N1 G0 U-1\nIF[#5041 LT 10]GOTO 9\nM99\nN9 M30\n",
        "#2001=#2001+1\nIF[#2001 GT 9]GOTO 9\nG0 X1\nM99\nN9 M30\n",
        "G0 X[#1]\n#1=#1+1\nIF[#1 GT 9]GOTO 9\nM99\nN9 M30\n",
    ] {
        assert_eq!(slugs(text), Vec::<&str>::new(), "{text}");
    }
    for text in ["G0 X5\n#1=5\nM99\n", "N5 #1=5\nG0 X#1\nM99 P5\n", "#500=5\nG0 X[#500]\nM99\n"] {
        assert_eq!(run(text, "{}", text).motions.len(), 1, "{text}");
        assert_eq!(slugs(text), ["main-program-without-end"], "{text}");
    }
    for text in ["G0 U-1\nM99\n", "#1=3\nG0 X#1\nM99\n", "G0 X5\n#1=#5041\nM99\n"] {
        assert_eq!(slugs(text), ["main-program-without-end"], "{text}");
    }
}

/// A cycle with nearly the maximum number of moves runs.
#[test]
fn a_cycle_just_within_the_bound_runs() {
    let text =
        "M3 S500\nG99 G0 X1000 Z2 F0.2\nG71 U0.011 R0.5\nG71 P1 Q2 U0 W0\nN1 G0 X0\nN2 G1 X1000 Z-100\nM30\n";
    let analysis = run("G71 U0.011", "{}", text);
    assert!(analysis.motions.len() > 180_000 && analysis.motions.len() < Limits::default().moves_per_cycle);
    assert_eq!(codes(&analysis), Vec::<&str>::new());
}

/// A contour of `blocks` blocks that falls and rises, as CAM systems write it.
fn contour(blocks: usize) -> String {
    let mut text = String::from("N1 G0 X50\n");
    for block in 0..blocks {
        text.push_str(&format!("G1 X{}.{:03} W-0.001\n", 50 + block % 2, block % 1000));
    }
    text + "N2 X200\n"
}

#[test]
fn g70_of_a_contour_of_100_000_blocks_runs() {
    let text = format!("M3 S500\nG99 F0.2\nG0 X200 Z2\nG70 P1 Q2\nM30\n{}", contour(100_000));
    let analysis = run("G70", "{}", &text);
    assert_eq!(analysis.motions.len(), 100_004);
}

#[test]
fn a_long_contour_called_again_and_again_ends_with_a_message() {
    let contour = contour(40_000);
    assert!(contour.len() > 700_000);
    let head = "M3 S500\nG99 F0.2\nG0 X200 Z2\nG71 U2 R0.5\nG72 W2 R0.5\n";
    let check = |name: &str, contour: &str, cycle: &str| {
        let calls = format!("{cycle}\n").repeat(1_000);
        let analysis = run(name, "{}", &format!("{head}{contour}{calls}M30\n"));
        assert!(codes(&analysis).iter().any(|found| found == "E-TOO-MUCH-WORK"), "{name}");
    };
    check("G70", &contour, "G70 P1 Q2");
    check("G71", &contour, "G71 P1 Q2 U1");
    check("G73", &contour, "G73 P1 Q2 U1 D2 I1 K1");
    // It fails each time, so no limit of motions ends the run.
    check("G70 with G28", &contour.replace("N2 ", "G28 U0\nN2 "), "G70 P1 Q2");
    check("G72 with a fault in each block", &contour.replace("G1 X", "G1 Q- X"), "G72 P1 Q2 U1");
}

#[test]
fn cycles_that_come_to_nothing_do_not_add_up() {
    let head = "M3 S500\nG99 F0.2\nG0 X200 Z2\nG71 U0.003 R0.5\nG76 P990060 Q1 R0\n";
    let setup = r#"{"dialect": {"pqUnit": "um"}}"#;
    let pockets = "N1 G0 X198 W0\nG1 X0 Z-10\nX190 Z-20\nX0 Z-30\nX190 Z-40\nN2 X0 Z-50\n";
    for (name, contour, cycle, code) in [
        ("refused after its last pass", pockets, "G71P1Q2", "E-TOO-MUCH-WORK"),
        ("moves of no length", "N1 G0 W0\n", "G73P1Q1D66666", "E-TOO-MUCH-WORK"),
        ("a thread of no length", "", "G76U0W0P20000Q100F2", "E-TOO-MUCH-WORK"),
        ("numbers found nowhere", "N1 G0 W0\n", "G70P1Q99999999", "E-NS-NOT-FOUND"),
        ("numbers found nowhere, far from home", "N1 G0 W0\n", "G70P99999999Q1", "E-NS-NOT-FOUND"),
    ] {
        let calls = format!("{cycle}\n").repeat(200_000);
        let analysis = run(name, setup, &format!("{head}{contour}G0 X200 Z2\n{calls}M30\n"));
        assert!(codes(&analysis).iter().any(|found| found == code), "{name}: {:?}", codes(&analysis));
    }
    // As many sequence numbers as calls, and all calls to one number.
    let text: String = (1..=200_000).map(|number| format!("N{number}G70P{number}Q{number}\n")).collect();
    assert!(codes(&run("each names itself", "{}", &text)).iter().any(|found| found == "PS0325"));
    assert!(
        codes(&run("each names the first", "{}", &"N1G70P1Q1\n".repeat(200_000)))
            .iter()
            .any(|found| found == "PS0325")
    );
}

#[test]
fn compensation_of_a_long_contour_runs() {
    let head = "M3 S500\nG99 F0.2\nT0101\nG0 X200 Z2\nG42\n";
    let setup = r#"{"tools": {"T0101": {"noseRadius": 0.4, "tip": 3}}}"#;
    let line = |block: u32| format!("G1 X{:.3} W-0.002\n", 50.0 + 0.001 * f64::from(block));
    let cone = format!("N1 G0 X50\n{}N2 W-5\n", (1..50_000).map(line).collect::<String>());
    let analysis = run("G42", setup, &format!("{head}G70 P1 Q2\nM30\n{cone}"));
    assert!(analysis.motions.len() > 49_000, "{:?}", &analysis.diagnostics);
    run("rapids", setup, &format!("{head}G70 P1 Q2\nM30\n{}", cone.replace("G1", "G0")));
}

#[test]
fn texts_that_repeat_one_thing_are_read_in_one_pass() {
    let programs: String = (10..100_000).map(|number| format!("O{number}\nM98 P10\nM99\n")).collect();
    run("programs", "{}", &programs);
    let calls = format!("O1\n{}M30\n{programs}O2\nM99\n", "M98 P2\n".repeat(100_000));
    run("calls", "{}", &calls);
    for part in ["(()", "X1(()", "[(()", "IF[1EQ1AND"] {
        run(part, "{}", &part.repeat(300_000));
    }
}

#[test]
fn loops_without_end_are_told() {
    for text in ["N1 GOTO 1", "DO1\nEND1", "O1\nN1 M99 P1", "O1\n#100=#100+1\nM99"] {
        let analysis = run(text, "{}", text);
        let told: Vec<_> = analysis.diagnostics.iter().map(|told| told.message.code()).collect();
        let code = if text.contains("M99 P1") { "W-ENDLESS" } else { "E-ENDLESS" };
        assert!(told.contains(&code), "{text}: {told:?}");
    }
}

/// G70 in a main program does not find the contour that a macro has roughed: it would continue in the middle
/// of the macro, whose M99 would search for the main program again and again.
#[test]
fn finishing_stays_in_its_own_program() {
    let macro_call = "M3 S500\nF.2\nG0 X50 Z2\nG65 P2\nG70 P1 Q2\nM30\n";
    let shape = "N1 G0 X20\nN2 G1 Z-9\nM99\n";
    let text = format!("{macro_call}O2\nG71 U1 R1\nG71 P1 Q2 U.4 W.1\n{shape}");
    assert!(codes(&run("G70", "{}", &text)).iter().any(|found| found == "E-NS-NOT-FOUND"));
}
