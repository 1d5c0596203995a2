//! Lints only observe: without them a run makes the same motions and reports the errors of the control.

use crate::fixtures;
use crate::format;
use gcode_playground::message::Diagnostic;
use gcode_playground::run::{Analysis, Run};
use gcode_playground::sentences::Language;
use gcode_playground::setup::{Lints, Setup};

fn run(text: &[u8], setup: &Setup, lints: Lints) -> Analysis {
    let mut run = Run::new(text.to_vec(), Setup { lints, ..setup.clone() });
    while !run.advance(usize::MAX) {}
    run.into_analysis()
}

/// Runs a program with and without lints, checks that the motions are equal, and returns both lists of
/// messages.
fn compared(name: &str, text: &[u8], setup: &Setup) -> [Vec<Diagnostic>; 2] {
    let (with, without) = (run(text, setup, Lints::On), run(text, setup, Lints::Off));
    assert_eq!(with.motions.len(), without.motions.len(), "{name}");
    for index in 0..with.motions.len() {
        assert_eq!(with.motions.get(index), without.motions.get(index), "{name}, motion {index}");
    }
    [with.diagnostics, without.diagnostics]
}

#[test]
fn motions_and_errors_of_the_programs_are_the_same_without_lints() {
    for program in fixtures::all() {
        let setup = Setup::from_json(&program.setup).expect(&program.id);
        let [with, without] = compared(&program.id, program.text.as_bytes(), &setup);
        let errors =
            |all: &[Diagnostic]| all.iter().filter(|one| one.is_error()).cloned().collect::<Vec<_>>();
        assert_eq!(errors(&with), errors(&without), "{}", program.id);
    }
}

/// The examples show whether a rule is a lint: without lints, the lints report nothing and the control still
/// reports its errors.
#[test]
fn without_lints_the_control_reports_its_own_faults() {
    let mut of_lints = Vec::new();
    for (name, rule) in format::all(env!("CARGO_MANIFEST_DIR")) {
        let Ok(rule) = rule else { continue };
        let setup = Setup::from_json(&rule.page.setup).expect(&name);
        let told = compared(&name, rule.page.wrong.as_bytes(), &setup);
        let [with, without] = told.map(|told| told.iter().any(|one| one.message.slug() == rule.slug));
        assert!(with || !without, "{name}: only without lints");
        if with && !without {
            of_lints.push(rule.slug);
        }
    }
    let lint = |slug: &str| of_lints.iter().any(|own| own == slug);
    for slug in
        ["cut-with-spindle-stopped", "feed-unit-mixed-up", "taper-not-extended", "tool-change-near-work"]
    {
        assert!(lint(slug), "{slug} is a lint: {of_lints:?}");
    }
    for slug in ["unknown-g-code", "feed-missing", "taper-beyond-start-point"] {
        assert!(!lint(slug), "{slug} is of the control");
    }
}

/// The slugs of the messages for a program in a G-code system.
fn reported(system: &str, text: &str) -> Vec<&'static str> {
    let setup =
        format!(r#"{{"dialect": {{"gSystem": "{system}"}}, "stock": {{"diameter": 60, "length": 80}}}}"#);
    let setup = Setup::from_json(&setup).expect("a setup");
    let told = run(text.as_bytes(), &setup, Lints::On).diagnostics;
    told.iter().map(|one| one.message.slug()).collect()
}

#[test]
fn a_lost_minus_is_found_in_a_cycle_of_every_system() {
    let program = |cycle: &str, per_turn: &str| {
        format!(
            "{per_turn}\nT0101 M03 S800\nG00 X62 Z2\n{cycle} X56 Z-20 F0.2\nX52 Z20\nX48 Z-20\nX44\nG00 X100 Z50\nM30"
        )
    };
    for (system, cycle, per_turn) in [("A", "G90", "G99"), ("B", "G77", "G95"), ("C", "G20", "G95")] {
        let found = reported(system, &program(cycle, per_turn));
        assert!(found.contains(&"minus-missing"), "{system}: {found:?}");
    }
}

#[test]
fn a_contour_holds_the_codes_of_its_system() {
    let program = |between: &str| {
        format!(
            "G95\nT0101 M03 S800\nG00 X62 Z2\nG71 U2 R1\nG71 P1 Q2 U0.5 W0.1 F0.2\nN1 G00 X20\n{between}\nG01 Z-10\nN2 G01 X60\n\
             G70 P1 Q2\nG00 X100 Z50\nM30"
        )
    };
    let absolute = reported("B", &program("G90"));
    assert!(!absolute.iter().any(|slug| slug.contains("contour")), "{absolute:?}");
    let cycle = reported("B", &program("G77 X40 Z-5"));
    assert!(cycle.contains(&"contour-reaches-over-other-cycle"), "{cycle:?}");
    let of_a = reported("A", &program("G90 X40 Z-5").replace("G95", "G99"));
    assert!(of_a.contains(&"contour-reaches-over-other-cycle"), "{of_a:?}");
}

/// The rules that a program triggers, including those of the simulation.
fn slugs(text: &str) -> Vec<String> {
    let mut analysis = run(text.as_bytes(), &Setup::default(), Lints::On);
    analysis.check_at_machine();
    analysis.diagnostics.iter().map(|told| told.message.slug().to_owned()).collect()
}

/// A position to change the tool is usually within 500 mm; a longer one, or one towards the chuck, is not.
#[test]
fn a_small_part_may_be_left_by_far() {
    let head = "O0001 (STOCK D=24 LENGTH=60)\nT0101\nG97 G99 S800 M03\nG00 X22 Z2\nG01 Z-20 F0.2\n";
    let program = |rest: &str| slugs(&format!("{head}{rest}\nM30\n"));
    assert_eq!(program("X24\nG00 X200 Z200"), [""; 0]);
    assert_eq!(program("X24\nG00 X200 Z2000"), ["far-beyond-the-rest"]);
    assert!(program("X24\nG00 X200 Z-900").contains(&"far-beyond-the-rest".to_owned()));
}

/// A hole of a live tool that does not turn has one message.
#[test]
fn a_live_tool_that_does_not_turn_is_reported_once() {
    let hole = "O0001 (STOCK D=60 LENGTH=60)\n(TOOL T0303 TYPE=DRILL D=8)\nM45\nG28 H0\nT0303\nG00 X66 Z-30 C0\n\
        G98 G87 Z-30 C0 X30 R-1 F80\nC90\nG80\nG00 X150 Z100\nM46\nM30\n";
    assert_eq!(slugs(hole), ["live-tool-stopped", "cross-holes-left-out"]);
}

/// From X60 Z2 to X50 Z-20 with R-5.5 the cut is at X40 at the face: 5 mm deep in a bar of 50 mm. With R-2.2 from Z8
/// it is 1 + 2.2 · 20/28 = 2.57 mm deep in a bar of 40 mm, less than 3 mm.
#[test]
fn the_depth_of_a_taper_is_that_at_the_face() {
    let told = |text: &str| -> Vec<String> {
        let analysis = run(text.as_bytes(), &Setup::default(), Lints::On);
        let own = analysis.diagnostics.iter().filter(|told| told.message.slug() == "taper-first-pass-deep");
        own.map(|told| told.message.sentence(Language::English).message).collect()
    };
    let deep = "O0001 (STOCK D=50 LENGTH=80)\nT0101\nG97 S800 M03\nG00 X60 Z2\nG90 X50 Z-20 R-5.5 F0.2\nG00 X100 Z50\nM30\n";
    assert_eq!(told(deep), ["This pass of the taper is 5 mm deep at its small end."]);
    let shallow = "O0001 (STOCK D=40 LENGTH=80)\nT0101\nG97 S800 M03\nG00 X44 Z8\nG90 X38 Z-20 R-2.2 F0.2\nG00 X100 Z50\nM30\n";
    assert_eq!(told(shallow), [""; 0]);
}

/// A cut with the spindle stopped leaves its material: the way out of it has the same cause.
#[test]
fn a_cut_with_the_spindle_stopped_is_reported_once() {
    let program = |stop: &str, rest: &str| {
        slugs(&format!(
            "O0001 (STOCK D=60 LENGTH=100 GRIP=25)\n(TOOL T0101 TYPE=TURNING INSERT=CNMG120408)\nT0101\n\
             G97 S800 M03\n{stop}\nG99 G00 X62 Z-1\nG01 X-1 F0.15\nG00 Z5\n{rest}X100 Z50\nM30\n"
        ))
    };
    assert_eq!(program("M05", ""), ["cut-with-spindle-stopped"]);
    // A crash after the spindle turns again is another fault.
    let crash = "M03\nX62\nZ-30\nX40\nX62\n";
    assert_eq!(
        program("M05", crash),
        ["cut-with-spindle-stopped", "rapid-through-stock", "rapid-through-stock"]
    );
    // So is a crash of the next tool, and one after the tool has left the work.
    let other = "X100 Z50\nT0202\nX62 Z5\nZ-30\nX40\n";
    assert!(program("M05", other).contains(&"rapid-through-stock".to_owned()));
    let later = "X70 Z5\nZ-30\nX40\n";
    assert!(program("M05", later).contains(&"rapid-through-stock".to_owned()));
    assert_eq!(program("", ""), [""; 0]);
}

/// With the wrong K the block before is not carried out; the I after it has the right letter and sign.
#[test]
fn a_wrong_corner_word_is_reported_once() {
    let program = |first: &str| {
        slugs(&format!(
            "O0001 (STOCK D=44 LENGTH=80 GRIP=25)\nT0101\nG97 G99 S1000 M03\nG00 X34 Z2\nG01 Z-20 F0.15\n\
             X42 {first}\nZ-35 I1\nX46\nG00 X100 Z50\nM30\n"
        ))
    };
    assert_eq!(program("K-1"), [""; 0]);
    assert_eq!(program("K1"), ["corner-axis", "not-checked-behind-fault"]);
}

/// With the start at Z10, the cuts of a cone go from Z15 and Z10 at the inner end to Z3 and Z-2 at the outer end:
/// the second is the deeper one. Without R, a pass from Z-2 to Z0 is not.
#[test]
fn a_pass_is_compared_in_the_direction_of_the_infeed() {
    let program = |passes: &str| {
        let text = format!(
            "O0001 (STOCK D=60 LENGTH=80 FACE=16)\nT0101\nG97 G99 S800 M03\nG00 X64 Z10\n{passes}\n\
             G00 X100 Z50\nM30\n"
        );
        slugs(&text).contains(&"pass-not-deeper".to_owned())
    };
    assert!(!program("G94 X20 Z15 R-12 F0.1\nZ10"));
    assert!(program("G94 X20 Z8 F0.1\nZ6\nZ7"));
}
