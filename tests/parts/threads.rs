//! The positions of thread grooves, calculated by hand. Diameters, mm.
//!
//! The insert is a V of 60°: a groove of ⌀28 in a bar of ⌀30 is 1 mm deep, and 1.155 mm wide at the crest.

use gcode_playground::analyze;
use gcode_playground::machine::SimulationResult;
use gcode_playground::machine::region::Region;
use gcode_playground::motion::{MotionKind, Motions};
use gcode_playground::setup::Setup;

/// The bar of ⌀30 × 60 with the thread that the blocks cut, above the axis.
fn cut(control: &str, blocks: &str) -> Region {
    simulated(control, blocks).0.finished().expect("a blank")
}

fn simulated(control: &str, blocks: &str) -> (SimulationResult, Motions) {
    let setup = format!(
        r#"{{"dialect": {{"control": "{control}", "threadChamfer": 0}},
        "stock": {{"diameter": 30, "length": 60}}, "tools": {{"T0404": {{"type": "threading"}}}}}}"#
    );
    let setup = Setup::from_json(&setup).expect("a setup");
    let program = format!("T0404\nG97 S300 M03\n{blocks}\nG00 X100 Z100\nM30\n");
    let analysis = analyze(program.as_bytes(), &setup);
    (SimulationResult::of(&analysis.motions, &setup), analysis.motions)
}

/// Diameter at a Z.
fn at(part: &Region, z: f64) -> f64 {
    part.radii(z).last().map_or(0.0, |radii| 2.0 * radii.1)
}

/// Positions of grooves of ⌀28, from the face inwards, in steps of a hundredth of a millimetre.
fn grooves(part: &Region) -> Vec<f64> {
    let places = (1..2900).map(|step| -f64::from(step) / 100.0);
    places.filter(|&z| at(part, z) < 28.005).collect()
}

#[track_caller]
fn check(control: &str, blocks: &str, expected: &[f64]) {
    let found = grooves(&cut(control, blocks));
    let near = |(a, b): (&f64, &f64)| (a - b).abs() < 0.006;
    assert!(
        found.len() == expected.len() && found.iter().zip(expected).all(near),
        "{blocks}: {found:?}, not {expected:?}"
    );
}

/// Every `pitch` from `first` down to Z-28.9.
fn every(first: f64, pitch: f64) -> Vec<f64> {
    (0..).map(|turn| first - pitch * f64::from(turn)).take_while(|&z| z > -28.99).collect()
}

#[test]
fn a_start_angle_moves_the_grooves() {
    // From Z8 with lead 4: the spindle is at its mark at 8, 4, 0, -4.
    check("fanuc", "G00 X34 Z8\nG92 X28 Z-30 F4", &every(-4.0, 4.0));
    // Half a turn later the tool has moved half a lead when the mark passes.
    check("fanuc", "G00 X34 Z8\nG92 X28 Z-30 F4 Q180000", &every(-2.0, 4.0));
    check("fanuc", "G00 X34 Z8\nG92 X28 Z-30 F4\nX28 Q180000", &every(-2.0, 2.0));
    // With a start angle of 90° the tool has moved three quarters of a lead when the mark passes.
    check("fanuc", "G00 X34 Z8\nG92 X28 Z-30 F4 Q90000", &every(-3.0, 4.0));
    // A full turn counts as none, and Q applies only to its own block.
    check("fanuc", "G00 X34 Z8\nG92 X28 Z-30 F4 Q360000", &every(-4.0, 4.0));
    check("fanuc", "G00 X34 Z8\nG92 X29 Z-30 F4 Q180000\nX28", &every(-4.0, 4.0));
}

/// A helix passes the other side of the axis half a lead further: grooves at -4, -8 are opposite crests.
#[test]
fn below_the_axis_the_grooves_are_half_a_lead_further() {
    let check_below = |blocks: &str, expected: &[f64]| {
        let (simulation, _) = simulated("fanuc", blocks);
        let found = grooves(&simulation.opposite_finished().expect("a thread"));
        let near = |(a, b): (&f64, &f64)| (a - b).abs() < 0.006;
        assert!(found.len() == expected.len() && found.iter().zip(expected).all(near), "{blocks}: {found:?}");
    };
    check_below("G00 X34 Z8\nG92 X28 Z-30 F4", &every(-2.0, 4.0));
    check_below("G00 X34 Z8\nG92 X28 Z-30 F4 Q90000", &every(-1.0, 4.0));
    // The insert leaves at -28, after nine whole turns: in no half it cuts a groove all around.
    check_below("G00 X34 Z8\nG92 X28 Z-28 F4", &every(-2.0, 4.0));
    // Half the lead is the pitch of two starts, and one and a half pitches of three.
    check_below("G00 X34 Z8\nG92 X28 Z-30 F4\nX28 Q180000", &every(-2.0, 2.0));
    check_below("G00 X34 Z6\nG92 X28 Z-30 F6\nX28 Q120000\nX28 Q240000", &every(-1.0, 2.0));
}

#[test]
fn only_threads_differ_below_the_axis() {
    let (plain, motions) = simulated("fanuc", "G00 X34 Z8\nG90 X28 Z-30 F0.2");
    assert!(plain.opposite_finished().is_none() && plain.opposite_at(&motions, 3, 0.5).is_none());

    let (threaded, motions) = simulated("fanuc", "G00 X34 Z8\nG92 X28 Z-30 F4");
    let thread =
        (0..motions.len()).find(|&index| motions.kind(index) == MotionKind::Thread).expect("a thread");
    let both = |count, share| {
        let above = threaded.part_at(&motions, count, share).expect("a blank");
        let below = threaded.opposite_at(&motions, count, share).expect("a thread");
        (grooves(&above), grooves(&below))
    };
    assert!(!threaded.is_opposite_above());
    assert!(threaded.opposite_at(&motions, thread, 0.0).is_none());
    // Half of the 38 mm is cut up to Z-11: grooves above at -4 and -8, below at -2, -6 and -10.
    let (above, below) = both(thread, 0.5);
    assert!(above.len() == 2 && below.len() == 3, "{above:?} {below:?}");
    let (above, below) = both(thread + 1, 0.0);
    assert!((above.len(), below.len()) == (7, 7), "{above:?} {below:?}");
}

/// A tool at -X cuts on its own side when the mark passes: at -4 and -8.
#[test]
fn the_tool_at_negative_x_cuts_the_half_below_the_axis() {
    let (simulation, _) = simulated("fanuc", "G00 X-34 Z8\nX-28\nG32 Z-30 F4\nG00 X-34");
    assert!(simulation.is_opposite_above());
    let [tool, opposite] = [simulation.finished(), simulation.opposite_finished()];
    let [tool, opposite] = [tool, opposite].map(|half| grooves(&half.expect("a blank")));
    assert!((tool[0] + 4.0).abs() < 0.006 && (opposite[0] + 2.0).abs() < 0.006, "{tool:?} {opposite:?}");
}

#[test]
fn starts_shifted_by_angle_or_by_z_make_one_part() {
    let by_angle = cut("fanuc", "G00 X34 Z8\nG92 X28 Z-30 F4\nX28 Q180000");
    let by_place = cut("fanuc", "G00 X34 Z8\nG92 X28 Z-30 F4\nG00 Z10\nG92 X28 Z-30");
    for z in (1..290).map(|step| -f64::from(step) / 10.0) {
        assert!((at(&by_angle, z) - at(&by_place, z)).abs() < 1e-6, "Z{z}");
    }
    // A third of a turn equals a third of the lead farther from the work.
    for (q, z) in [(120_000, 8.0), (240_000, 10.0)] {
        let by_angle = cut("fanuc", &format!("G00 X34 Z6\nG92 X28 Z-30 F6 Q{q}"));
        let by_place = cut("fanuc", &format!("G00 X34 Z{z:.1}\nG92 X28 Z-30 F6"));
        assert_eq!(grooves(&by_angle), grooves(&by_place), "{q}");
    }
}

#[test]
fn three_starts_have_a_third_of_the_lead_as_pitch() {
    check("fanuc", "G00 X34 Z6\nG92 X28 Z-30 F6\nX28 Q120000\nX28 Q240000", &every(-2.0, 2.0));
    let by_moves = ["", "Q120000", "Q240000"]
        .map(|angle| format!("G00 X34 Z6\nX28\nG32 Z-32 F6 {angle}\nG00 X34\n"))
        .concat();
    check("fanuc", &by_moves, &every(-2.0, 2.0));
}

/// Away from the chuck: a left-hand thread with M03. From Z-30 the mark passes at -26, -22 and so on.
#[test]
fn starts_of_a_left_hand_thread() {
    let passes = |angles: &[&str]| -> String {
        angles.iter().map(|angle| format!("G00 X34\nZ-31\nX28\nG32 Z5 F4 {angle}\n")).collect()
    };
    check("fanuc", &passes(&[""]), &every(-3.0, 4.0));
    check("fanuc", &passes(&["Q180000"]), &every(-1.0, 4.0));
    check("fanuc", &passes(&["", "Q180000"]), &every(-1.0, 2.0));
}

/// n turns with F2 K1 are 2n + n²/2 long: 0, 2.5, 6, 10.5, 16, 22.5, 30; half a turn later 1.125, 4.125,
/// 8.125, 13.125, 19.125, 26.125.
#[test]
fn the_grooves_of_a_growing_lead_grow_apart() {
    let thread = |angle: &str| format!("G00 X34 Z4\nX28\nG34 Z-32 F2 K1 {angle}\nG00 X34");
    check("fanuc", &thread(""), &[-2.0, -6.5, -12.0, -18.5, -26.0]);
    check("fanuc", &thread("Q180000").replace("Z4", "Z4.125"), &[-4.0, -9.0, -15.0, -22.0]);
}

/// A block that continues a thread keeps its spindle angle; its Q has no effect.
#[test]
fn a_thread_goes_on_with_the_turn_of_the_block_before() {
    let thread =
        |one: &str, other: &str| format!("G00 X34 Z8\nX28\nG32 Z-10 F4 {one}\nZ-32 {other}\nG00 X34");
    check("fanuc", &thread("", "Q180000"), &every(-4.0, 4.0));
    check("fanuc", &thread("Q180000", ""), &every(-2.0, 4.0));
}

/// On GSK, L is the number of starts. P and Q of G76 are depths, but Q of a one-block G76 is its start angle.
#[test]
fn cycles_cut_all_starts() {
    check("gsk", "G00 X34 Z8\nG92 X28 Z-30 F4 L2", &every(-2.0, 2.0));
    check("gsk", "G00 X34 Z6\nG92 X28 Z-30 F6 L3", &every(-2.0, 2.0));
    let cycle = "G00 X34 Z8\nG76 P010000 Q50 R0\nG76 X28 Z-30 P1000 Q500 F4";
    check("gsk", cycle, &every(-4.0, 4.0));
    check("gsk", &format!("{cycle} L2"), &every(-2.0, 2.0));
    check("fanuc", cycle, &every(-4.0, 4.0));
    check("fanuc", "G00 X34 Z8\nG76 X28 Z-30 K1. D500 F4 A0 Q180000", &every(-2.0, 4.0));
}
