//! Programs that would take for ever: each is answered within seconds, and says why.
#![cfg(not(target_arch = "wasm32"))]

mod endless;

use std::time::{Duration, Instant};

use endless::{MOST_SECONDS, endless};
use gcode_playground::analyze;
use gcode_playground::control::setup::Setup;
use gcode_playground::limits::Limits;
use gcode_playground::run::Analysis;

/// The one door: what a program gives under a setup, in time.
#[track_caller]
fn run_within(most: Duration, name: &str, setup: &str, text: &str) -> Analysis {
    let setup = Setup::from_json(setup).expect("setup");
    let begun = Instant::now();
    let analysis = analyze(text.as_bytes(), &setup);
    let took = begun.elapsed();
    assert!(took < most, "{name}: {took:?}");
    analysis
}

/// The same, for work that adds up: the longest time is what a slow build on a busy machine may take.
#[track_caller]
fn run(name: &str, setup: &str, text: &str) -> Analysis {
    run_within(Duration::from_secs(10), name, setup, text)
}

fn codes(analysis: &Analysis) -> Vec<&'static str> {
    analysis.diagnostics.iter().map(|found| found.message.code()).collect()
}

#[test]
fn cycles_of_far_too_many_passes_are_refused_at_once() {
    for case in endless() {
        let most = Duration::from_secs_f64(MOST_SECONDS);
        let analysis = run_within(most, case.name, case.setup, &case.text);
        assert!(codes(&analysis).contains(&case.code), "{}: {:?}", case.name, codes(&analysis));
        assert_eq!(analysis.motions.len(), 1, "{}", case.name);
    }
}

/// Nearly as many moves as a cycle may have are made.
#[test]
fn a_cycle_just_within_the_bound_runs() {
    let text =
        "M3 S500\nG99 G0 X1000 Z2 F0.2\nG71 U0.011 R0.5\nG71 P1 Q2 U0 W0\nN1 G0 X0\nN2 G1 X1000 Z-100\nM30\n";
    let analysis = run("G71 U0.011", "{}", text);
    assert!(analysis.motions.len() > 180_000 && analysis.motions.len() < Limits::default().moves_per_cycle);
    assert_eq!(codes(&analysis), Vec::<&str>::new());
}

/// A contour of `blocks` blocks that falls and rises, as a program prepared by another program has it.
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
        assert!(codes(&analysis).contains(&"E-TOO-MUCH-WORK"), "{name}");
    };
    check("G70", &contour, "G70 P1 Q2");
    check("G71", &contour, "G71 P1 Q2 U1");
    check("G73", &contour, "G73 P1 Q2 U1 D2 I1 K1");
    // Refused each time, so that no number of motions ends it.
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
        ("numbers found nowhere", "N1 G0 W0\n", "G70P1Q99999999", "W-NS-NOT-FOUND"),
        ("numbers found nowhere, far from home", "N1 G0 W0\n", "G70P99999999Q1", "W-NS-NOT-FOUND"),
    ] {
        let calls = format!("{cycle}\n").repeat(200_000);
        let analysis = run(name, setup, &format!("{head}{contour}G0 X200 Z2\n{calls}M30\n"));
        assert!(codes(&analysis).contains(&code), "{name}: {:?}", codes(&analysis));
    }
    // As many numbers as calls, and all calls to one number.
    let text: String = (1..=200_000).map(|number| format!("N{number}G70P{number}Q{number}\n")).collect();
    assert!(codes(&run("each names itself", "{}", &text)).contains(&"PS0325"));
    assert!(codes(&run("each names the first", "{}", &"N1G70P1Q1\n".repeat(200_000))).contains(&"PS0325"));
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
        assert!(codes(&analysis).contains(&"W-ENDLESS"), "{text}: {:?}", codes(&analysis));
    }
}
