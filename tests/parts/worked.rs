//! Single cases calculated by hand. Diameters, mm.

use gcode_playground::analyze;
use gcode_playground::machine::SimulationResult;
use gcode_playground::machine::region::Region;
use gcode_playground::setup::Setup;

const TOOLS: &str = r#""T0101": {"type": "turning", "noseRadius": 0.8, "pointAngle": 35, "enteringAngle": 93},
    "T0202": {"type": "drill", "diameter": 10}, "T0303": {"type": "grooving", "width": 3},
    "T0404": {"type": "threading"}, "T0505": {"type": "threading", "side": "inside"}"#;

/// The part of ⌀30 × 50 that a program makes. `chamfer` is the pull-out of threads in tenths of a lead.
fn part(chamfer: u32, program: &str) -> Region {
    let dialect = format!(r#""dialect": {{"threadChamfer": {chamfer}}}"#);
    let setup = format!(r#"{{{dialect}, "stock": {{"diameter": 30, "length": 50}}, "tools": {{{TOOLS}}}}}"#);
    let setup = Setup::from_json(&setup).expect("a setup");
    let analysis = analyze(program.as_bytes(), &setup);
    SimulationResult::of(&analysis.motions, &setup).finished().expect("a blank")
}

fn check(part: &Region, z: f64, expected: &[(f64, f64)]) {
    let found: Vec<_> = part.radii(z).into_iter().map(|(low, high)| (2.0 * low, 2.0 * high)).collect();
    let near = |(a, b): (&(f64, f64), &(f64, f64))| (a.0 - b.0).abs() < 0.01 && (a.1 - b.1).abs() < 0.01;
    assert!(
        found.len() == expected.len() && found.iter().zip(expected).all(near),
        "Z{z}: {found:.4?}, not {expected:?}"
    );
}

/// The imaginary tip follows X10 Z0 to X30 Z-10, where x + z = 5 in radius. The centre of the nose is 0.8
/// further in both: x + z = 6.6. The nose cuts 0.8 from it perpendicular to the taper: x + z = 6.6 − 0.8·√2 =
/// 5.4686. So the diameter is larger by 2 × 0.4686 = 0.937 everywhere on the taper.
#[test]
fn a_nose_leaves_a_taper_thicker() {
    let part = part(0, "T0101\nG00 X10 Z1\nG01 Z0 F1\nX30 Z-10\nG00 X40");
    for z in [-1.0, -5.0, -8.0] {
        check(&part, z, &[(0.0, 10.0 - 2.0 * z + 0.937)]);
    }
}

/// Along X20 to Z-20 and straight out: the nose stops with its centre at X21.6 Z-19.2. At Z-19.8 it is at
/// 10.8 − √(0.8² − 0.6²) = 10.2708 in radius, at Z-19.2 at 10.
#[test]
fn a_nose_leaves_a_corner_round() {
    let part = part(0, "T0101\nG00 X20 Z2\nG01 Z-20 F1\nX40");
    check(&part, -19.8, &[(0.0, 20.5417)]);
    check(&part, -19.2, &[(0.0, 20.0)]);
    check(&part, -20.01, &[(0.0, 30.0)]);
}

/// A grooving insert of 3 mm is measured at its left corner: at Z-15 it cuts Z-15 to Z-12.
#[test]
fn a_groove_is_as_wide_as_the_blade() {
    let part = part(0, "T0303\nG00 X32 Z-15\nG01 X20 F1\nG00 X32");
    for (z, diameter) in [(-15.01, 30.0), (-14.99, 20.0), (-12.01, 20.0), (-11.99, 30.0)] {
        check(&part, z, &[(0.0, diameter)]);
    }
    assert!((part.area() - 50.0 * 15.0 + 3.0 * 5.0).abs() < 1e-3);
}

/// Parting off at Z-30 leaves 20 mm in the chuck and 27 mm of part.
#[test]
fn parting_off_leaves_two_pieces() {
    let part = part(0, "T0303\nG00 X32 Z-30\nG01 X0 F1\nG00 X32");
    let mut lengths: Vec<f64> =
        part.pieces().map(|piece| Region::inside(&piece.outline).area() / 15.0).collect();
    lengths.sort_unstable_by(f64::total_cmp);
    assert_eq!(lengths.len(), 2);
    assert!((lengths[0] - 20.0).abs() < 1e-3 && (lengths[1] - 27.0).abs() < 1e-3, "{lengths:?}");
    check(&part, -28.0, &[]);
}

/// The point of 118° is at Z-20. At Z-18 it is 2 × 2·tan 59° = 6.657 wide; from 5 / tan 59° = 3.004 mm above
/// the point on, it is 10 wide.
#[test]
fn a_drill_leaves_its_point() {
    let part = part(0, "T0202\nG00 X0 Z2\nG01 Z-20 F1\nG00 Z2");
    check(&part, -20.01, &[(0.0, 30.0)]);
    check(&part, -18.0, &[(6.6571, 30.0)]);
    check(&part, -16.9, &[(10.0, 30.0)]);
}

/// From Z4 with a lead of 2 the notches are at Z0, Z-2 … Z-20. Half a millimetre beside one, the flank of 30°
/// is 0.5 / tan 30° = 0.866 higher in radius; in the middle it would be 1.732 higher, which is outside of the
/// bar.
#[test]
fn a_thread_has_a_notch_for_each_turn() {
    let part = part(0, "M03 S100\nT0404\nG00 X35 Z4\nG92 X27.6 Z-20 F2");
    for turn in 1..=10 {
        let z = -2.0 * f64::from(turn);
        check(&part, z, &[(0.0, 27.6)]);
        check(&part, z + 0.5, &[(0.0, 29.3321)]);
        check(&part, z + 1.0, &[(0.0, 30.0)]);
    }
    check(&part, -22.0, &[(0.0, 30.0)]);
    // A start shifted by 0.5 mm shifts all notches.
    let shifted = self::part(0, "M03 S100\nT0404\nG00 X35 Z3.5\nG92 X27.6 Z-20 F2");
    check(&shifted, -2.5, &[(0.0, 27.6)]);
    check(&shifted, -2.0, &[(0.0, 29.3321)]);
}

/// The pull-out of one lead begins at Z-17, half a turn after the notch at Z-16, and leaves at 45°: the next
/// notch is at Z-18, one millimetre higher. There is no notch where the pull-out begins.
#[test]
fn notches_go_on_in_the_pull_out() {
    let part = part(10, "M03 S100\nT0404\nG00 X35 Z4\nG92 X27.6 Z-19 F2");
    check(&part, -16.0, &[(0.0, 27.6)]);
    check(&part, -17.0, &[(0.0, 30.0)]);
    check(&part, -18.0, &[(0.0, 29.6)]);
}

/// Two threads in a row: 15 mm are 7½ turns, so the notches of the second one continue at Z-11, Z-13 … as in
/// the first.
#[test]
fn notches_go_on_from_thread_to_thread() {
    let part = part(0, "M03 S100\nT0404\nG00 X28 Z5\nG32 Z-10 F2\nG32 Z-21\nG00 X35");
    for z in [-1.0, -9.0, -11.0, -13.0, -21.0] {
        check(&part, z, &[(0.0, 28.0)]);
    }
    check(&part, -10.0, &[(0.0, 30.0)]);
    // After a rapid, the thread waits for the spindle mark.
    let part = self::part(0, "M03 S100\nT0404\nG00 X28 Z5\nG32 Z-10 F2\nG00 Z-10.5\nG32 Z-21 F2");
    check(&part, -10.5, &[(0.0, 28.0)]);
    check(&part, -11.0, &[(0.0, 29.732)]);
}

/// Halfway through a thread half of its turns are cut; a half-done arc ends on the arc.
#[test]
fn motions_are_shown_half_done() {
    let setup = format!(
        r#"{{"dialect": {{"threadChamfer": 0}}, "stock": {{"diameter": 30, "length": 50}}, "tools": {{{TOOLS}}}}}"#
    );
    let setup = Setup::from_json(&setup).expect("a setup");
    let at = |program: &str, count: usize, share: f64| {
        let analysis = analyze(program.as_bytes(), &setup);
        SimulationResult::of(&analysis.motions, &setup)
            .part_at(&analysis.motions, count, share)
            .expect("a blank")
    };
    let thread = at("M03 S100\nT0404\nG00 X28 Z4\nG32 Z-20 F2", 1, 0.5);
    check(&thread, -8.0, &[(0.0, 28.0)]);
    check(&thread, -10.0, &[(0.0, 30.0)]);
    // From X20 Z-10 about X40 Z-10 to X40 Z-20: halfway, the tip of the insert is at 20 − 10·cos 45° = 12.929
    // in radius and at Z −10 − 10·sin 45° = −17.071.
    let arc = "T0303\nG00 X20 Z-10\nG02 X40 Z-20 I10 K0 F1";
    check(&at(arc, 1, 0.5), -17.06, &[(0.0, 25.84)]);
    check(&at(arc, 1, 0.5), -17.08, &[(0.0, 30.0)]);
    check(&at(arc, 1, 0.0), -11.0, &[(0.0, 30.0)]);
}

/// Seed 004: from X54 at Z5 the taper of `G94 X30 Z0 R-20` begins at X54, outside the blank of ⌀50. On the
/// part it ends at −20 × 20 / 24 = −16.667; with R-24 at the −20 of the drawing.
#[test]
fn seed_004_begins_its_taper_in_the_air() {
    for (name, end) in [("s004-g94-wrong", -16.667), ("s004-g94-right", -20.0), ("s004-g94-x50", -20.0)] {
        let read =
            |file: &str| std::fs::read_to_string(format!("tests/programs/{name}/{file}")).expect("a file");
        let setup = Setup::from_json(&read("setup.json")).expect("a setup");
        let analysis = analyze(read("program.nc").as_bytes(), &setup);
        let part = SimulationResult::of(&analysis.motions, &setup).finished().expect("a blank");
        check(&part, end - 0.01, &[(0.0, 50.0)]);
        // From X50 there to X30 at Z0.
        check(&part, end / 2.0, &[(0.0, 40.0)]);
        check(&part, -0.01, &[(0.0, 30.0 - 20.0 * 0.01 / end)]);
    }
}

/// Moves that cannot be machined change nothing and do not stop the simulation.
#[test]
fn strange_motions_are_survived() {
    for program in [
        "T0404\nM03 S1\nG00 X28 Z2\nG32 Z-20 F0.000001",
        "T0404\nM03 S1\nG00 X28 Z2\nG32 Z2 F2\nG32 X28 Z2 F2",
        "T0101\nG00 X20 Z-10\nG03 X20 Z-10 I5 K0 F1",
        "T0101\nG00 X99999 Z99999\nG01 X-99999 Z-99999 F1\nG01 X99999 F1",
        "T0101\nG00 X20 Z-10\nG02 X20.001 Z-10 R50000 F1",
        "T0202\nG00 X0 Z1\nG01 Z1 F1\nX0 Z-0.0001",
    ] {
        let part = part(0, program);
        assert!(part.area().is_finite() && (0.0..=750.001).contains(&part.area()), "{program}");
    }
}
