//! Comparison of two parts, with the figures of seed 004.
use gcode_playground::analyze;
use gcode_playground::machine::compare::{Comparison, Side, parts};
use gcode_playground::machine::region::Region;
use gcode_playground::run::Analysis;
use gcode_playground::setup::Setup;

fn analysis(name: &str) -> Analysis {
    let read = |file: &str| std::fs::read_to_string(format!("tests/programs/{name}/{file}")).expect("a file");
    analyze(read("program.nc").as_bytes(), &Setup::from_json(&read("setup.json")).expect("a setup"))
}

fn compared(first: &str, second: &str) -> (Comparison, [Region; 2]) {
    let [first, second] = [first, second].map(analysis);
    let [a, b] = parts([(&first.motions, &first.setup), (&second.motions, &second.setup)]);
    let (a, b) = (a.expect("a part"), b.expect("a part"));
    (Comparison::of(&a, &b), [a, b])
}

fn near(found: f64, expected: f64) {
    assert!((found - expected).abs() < 0.002, "{found}, not {expected}");
}

/// Seed 004: with R-20 from X54 the cone goes from X54 Z-20 to X30 Z0, so the face at X50 is at
/// −20 × (50 − 30) / (54 − 30) = −16.667; with R-24 it is at −24 × 20 / 24 = −20.
#[test]
fn a_taper_that_was_not_extended_leaves_material_at_the_face() {
    let (comparison, [wrong, right]) = compared("s004-g94-wrong", "s004-g94-right");
    let face = |part: &Region| {
        let edges = part.edges().filter(|(a, b)| (a.x - b.x).abs() > 1.0);
        let corners = edges.flat_map(|(a, b)| [a, b]).filter(|at| (at.x - 25.0).abs() < 1e-4);
        corners.map(|at| at.z).fold(f64::NEG_INFINITY, f64::max)
    };
    near(face(&wrong), -16.667);
    near(face(&right), -20.0);
    assert_eq!(comparison.differences.len(), 1);
    let axial = comparison.axial().expect("a measure");
    near(2.0 * axial.from.x, 50.0);
    near(axial.from.z, -20.0);
    near(axial.to.z, -16.667);
    let radial = comparison.radial().expect("a measure");
    near(radial.length(), 5.0 / 3.0);
    near(radial.from.z, -16.667);
    // The triangle between X30 Z0, X50 Z-16.667 and X50 Z-20.
    near(comparison.area(Side::First), 10.0 / 2.0 * 10.0 / 3.0);
    near(comparison.area(Side::Second), 0.0);
}

#[test]
fn the_other_correct_program_makes_the_same_part() {
    assert!(compared("s004-g94-right", "s004-g94-x50").0.is_empty());
}
