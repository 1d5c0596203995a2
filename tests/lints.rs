//! Lints only observe: without them a run makes the same motions and reports the errors of the control.

use crate::fixtures;
use crate::format;
use gcode_playground::message::Diagnostic;
use gcode_playground::run::{Analysis, Run};
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
