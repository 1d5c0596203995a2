//! Blanks given by an outline: forgings and castings. Volumes, contacts and collisions are calculated by hand.

use gcode_playground::analyze;
use gcode_playground::machine::SimulationResult;
use gcode_playground::machine::danger::Danger;
use gcode_playground::machine::region::Region;
use gcode_playground::run::Analysis;
use gcode_playground::scene::svg::{SvgOptions, section};
use gcode_playground::setup::blank::Outline;
use gcode_playground::setup::{Blank, Position, Setup, Stock};
use gcode_playground::units::Diameter;
use std::f64::consts::PI;

use crate::fixtures::all;

/// A setup with this stock and a sharp turning tool T01.
fn setup(stock: &str) -> Setup {
    let tools = r#""tools": {"T0101": {"type": "turning", "noseRadius": 0}}"#;
    Setup::from_json(&format!(r#"{{"stock": {{{stock}}}, {tools}}}"#)).expect("a setup")
}

fn analysis(program: &str, stock: &str) -> Analysis {
    analyze(format!("T0101\nG97 S500 M03\n{program}\nM30\n").as_bytes(), &setup(stock))
}

fn simulation(program: &str, stock: &str) -> SimulationResult {
    SimulationResult::of(&analysis(program, stock).motions, &setup(stock))
}

fn blank(stock: &str) -> Region {
    simulation("", stock).blank().expect("a blank").clone()
}

/// Volume of the body of revolution, mm³: the sum of the frustums under its edges.
fn volume(region: &Region) -> f64 {
    let frustums = region.edges().map(|(a, b)| PI / 3.0 * (a.z - b.z) * (a.x * a.x + a.x * b.x + b.x * b.x));
    frustums.sum()
}

#[track_caller]
fn check_volume(region: &Region, expected: f64) {
    let found = volume(region);
    assert!((found - expected).abs() < 1e-4 * expected, "{found}, not {expected}");
}

#[track_caller]
fn check_radii(region: &Region, z: f64, expected: &[(f64, f64)]) {
    let found = region.radii(z);
    let near = |(a, b): (&(f64, f64), &(f64, f64))| (a.0 - b.0).abs() < 1e-3 && (a.1 - b.1).abs() < 1e-3;
    let same = found.len() == expected.len() && found.iter().zip(expected).all(near);
    assert!(same, "Z{z}: {found:?}, not {expected:?}");
}

/// A frustum of the radii 10 and 20 and the height 30: π · 30 / 3 · (100 + 200 + 400) = 7000 π.
#[test]
fn a_frustum_has_its_volume() {
    let cone = blank(r#""outline": [[20, 0], [40, -30]]"#);
    check_volume(&cone, 7000.0 * PI);
    check_radii(&cone, -15.0, &[(0.0, 15.0)]);
    // The points on the axis may be given, and the direction does not matter.
    check_volume(&blank(r#""outline": [[0, 0], [20, 0], [40, -30], [0, -30]]"#), 7000.0 * PI);
    check_volume(&blank(r#""outline": [[40, -30], [20, 0]]"#), 7000.0 * PI);
}

/// A hub of ⌀60, 40 mm long, with a bore of ⌀20 that is ⌀30 behind Z-20:
/// π · (900 · 40 − 100 · 20 − 225 · 20) = 29 500 π. A blind bore of ⌀20 in a bar of ⌀50: π · (625 · 60 − 100 · 20).
#[test]
fn a_casting_is_hollow() {
    let hub = r#""outline": [[20, 0], [60, 0], [60, -40], [30, -40], [30, -20], [20, -20], [20, 0]]"#;
    let hub = blank(hub);
    check_volume(&hub, 29_500.0 * PI);
    check_radii(&hub, -10.0, &[(10.0, 30.0)]);
    check_radii(&hub, -30.0, &[(15.0, 30.0)]);
    let blind = blank(r#""outline": [[0, -20], [20, -20], [20, 0], [50, 0], [50, -60]]"#);
    check_volume(&blind, 35_500.0 * PI);
    check_radii(&blind, -10.0, &[(10.0, 25.0)]);
    check_radii(&blind, -30.0, &[(0.0, 25.0)]);
}

/// The extents that lints, completion and the picture use.
#[test]
fn the_extents_of_an_outline() {
    for (outline, [diameter, bore, face, length]) in [
        ("[36, 2], [36, -18], [56, -33], [56, -80]", [56.0, 0.0, 2.0, 82.0]),
        // The front face is a ring.
        ("[20, 0], [60, 0], [60, -40], [30, -40], [20, -20], [20, 0]", [60.0, 20.0, 0.0, 40.0]),
        ("[0, -20], [20, -20], [20, 1], [50, 1], [50, -60]", [50.0, 20.0, 1.0, 61.0]),
        // A dished face has its rim in front.
        ("[0, -5], [50, 0], [50, -60]", [50.0, 0.0, 0.0, 60.0]),
        ("[0, 10], [50, 0], [50, -60]", [50.0, 0.0, 10.0, 70.0]),
    ] {
        let extents = setup(&format!(r#""outline": [{outline}]"#)).extents().expect("a blank");
        let found = [extents.diameter.mm(), extents.bore.mm(), extents.face, extents.length];
        assert_eq!(found, [diameter, bore, face, length], "{outline}");
    }
}

/// On the cone from ⌀30 at Z0 to ⌀60 at Z-30 the radius is 15 − z / 2, so a pass at ⌀40 begins to cut at Z-10. It
/// removes the frustum from there, π · 20 / 3 · (400 + 600 + 900), without the cylinder inside, π · 400 · 20:
/// 14 000 / 3 π. The pass goes from Z2 to Z-33.
#[test]
fn a_pass_on_a_forged_cone() {
    let stock = r#""outline": [[30, 0], [60, -30]]"#;
    let program = "G00 X40 Z2\nG01 Z-33 F0.2\nG00 X80\nZ50";
    let cone = blank(stock);
    let simulation = simulation(program, stock);
    assert_eq!(simulation.findings(), []);
    let finished = simulation.finished().expect("a part");
    let removed = volume(&cone) - volume(&finished);
    assert!((removed - 14_000.0 / 3.0 * PI).abs() < 1.0, "{removed}");
    check_radii(&finished, -9.9, &[(0.0, 19.95)]);
    check_radii(&finished, -20.0, &[(0.0, 20.0)]);
    let motions = analysis(program, stock).motions;
    let removed_at = |z: f64| {
        let part = simulation.part_at(&motions, 1, (2.0 - z) / 35.0).expect("a part");
        cone.area() - part.area()
    };
    assert!(removed_at(-9.99).abs() < 1e-6 && removed_at(-10.5) > 0.05, "{}", removed_at(-10.5));
}

/// A rapid along ⌀40 meets the shoulder from ⌀30 to ⌀60 at Z-20, and is in the air before. In a bar of ⌀60 it would be
/// in the material from the face on.
#[test]
fn a_rapid_meets_the_shoulder_of_a_forging() {
    const FORGING: &str = r#""outline": [[30, 2], [30, -20], [60, -20], [60, -50]]"#;
    const BAR: &str = r#""diameter": 60, "face": 2, "length": 52"#;
    let rapid = |program: &str, stock: &str| {
        let simulation = simulation(program, stock);
        let found = simulation.findings().iter().map(|found| (found.danger, found.at.x, found.at.z));
        found.collect::<Vec<_>>()
    };
    let [into, clear] = ["G00 X40 Z5\nG00 Z-30", "G00 X40 Z5\nG00 Z-18\nG00 X100"];
    let found = rapid(into, FORGING);
    let [(Danger::RapidThroughStock, x, z)] = found[..] else { panic!("{found:?}") };
    assert!((x - 20.0).abs() < 0.05 && (z + 20.0).abs() < 0.05, "{x} {z}");
    assert_eq!(rapid(clear, FORGING), []);
    let found = rapid(clear, BAR);
    let [(Danger::RapidThroughStock, x, z), ..] = found[..] else { panic!("{found:?}") };
    assert!((x - 20.0).abs() < 0.05 && (z - 2.0).abs() < 0.05, "{x} {z}");
}

/// The jaws hold the shank of ⌀50, up to the flange of ⌀100: they are 40 mm high, from radius 25 to 65. On a cone
/// they hold the largest radius within the clamping length.
#[test]
fn jaws_hold_the_end_of_a_forging() {
    let chuck = |stock: &str| {
        let simulation = simulation("", stock);
        let mut all = simulation.obstacles(None);
        let jaws = all.next().expect("jaws").clone();
        (jaws, all.next().expect("a chuck").clone())
    };
    let flange = r#""outline": [[100, 0], [100, -20], [50, -20], [50, -70]], "grip": 50"#;
    let (jaws, body) = chuck(flange);
    check_radii(&jaws, -45.0, &[(25.0, 65.0)]);
    check_radii(&jaws, -19.0, &[]);
    check_radii(&body, -71.0, &[(0.0, 65.0)]);
    // 15 mm in front of the back, a cone from ⌀80 to ⌀20 has ⌀20 + 60 · 15 / 60 = ⌀35.
    check_radii(&chuck(r#""outline": [[20, 0], [80, -60]], "grip": 15"#).0, -50.0, &[(40.0, 80.0)]);
    check_radii(&chuck(r#""outline": [[80, 0], [20, -60]], "grip": 15"#).0, -50.0, &[(17.5, 57.5)]);
}

/// G73 on a forging: the first pass is 0.7 mm deep. In a bar of its diameter it would be 28 − 17.3 = 10.7 mm deep.
#[test]
fn a_pattern_fits_a_forging_and_no_bar() {
    let program =
        std::fs::read_to_string("tests/programs/hand-14-g73-forging/program.nc").expect("a program");
    let slugs = |stock: &str| {
        let mut analysis = analyze(program.as_bytes(), &setup(stock));
        analysis.check_at_machine();
        let slugs = analysis.diagnostics.iter().map(|found| found.message.slug());
        slugs.filter(|slug| slug.starts_with("pattern-")).collect::<Vec<_>>()
    };
    assert_eq!(slugs(r#""outline": [[36, 2], [36, -18], [56, -33], [56, -80]]"#), [""; 0]);
    assert_eq!(slugs(r#""diameter": 56, "face": 2, "length": 82"#), ["pattern-first-pass-deep"]);
}

/// The turret turns 50 mm in front of a flange of ⌀200: clear of its boss of ⌀60 at X120, and near it at X66.
#[test]
fn a_tool_change_in_front_of_a_flange() {
    let reported = |x: f64, stock: &str| {
        let analysis = analyze(format!("T0101\nG00 X{x} Z5\nT0202\nM30\n").as_bytes(), &setup(stock));
        analysis.diagnostics.iter().any(|found| found.message.slug() == "tool-change-near-work")
    };
    let flange = r#""outline": [[60, 0], [60, -50], [200, -50], [200, -80]]"#;
    assert!(!reported(120.0, flange) && reported(66.0, flange));
    assert!(reported(120.0, r#""diameter": 200, "length": 80"#));
}

/// The outline of a bar or tube.
fn rectangle(bar: Stock) -> Blank {
    let point = |x: Diameter, z: f64| Position { x, z };
    let mut points = vec![point(bar.diameter, bar.face), point(bar.diameter, bar.back())];
    if bar.bore.mm() > 0.0 {
        points.extend([point(bar.bore, bar.back()), point(bar.bore, bar.face)]);
        points.push(points[0]);
    }
    Blank::with_outline(Outline::new(points), bar.grip)
}

/// A blank whose outline is a rectangle gives the same messages, part and picture as the bar.
#[test]
fn a_rectangle_is_a_bar() {
    let mut checked = 0;
    for program in all() {
        let given = Setup::from_json(&program.setup).expect(&program.id);
        let Some(bar) = given.stock.as_ref().filter(|blank| blank.outline().is_none()) else { continue };
        let outlined = Setup { stock: Some(rectangle(bar.extents())), ..given.clone() };
        assert!(outlined.stock.as_ref().is_some_and(|blank| blank.is_bar() && blank.outline().is_some()));
        let [(told, part, picture), other] = [given, outlined].map(|setup| {
            let mut analysis = analyze(program.text.as_bytes(), &setup);
            analysis.check_at_machine();
            let simulation = SimulationResult::of(&analysis.motions, &setup);
            let picture = section(&analysis.motions, Some(&simulation), &SvgOptions::default());
            (analysis.diagnostics, simulation.finished(), picture)
        });
        assert_eq!(told, other.0, "{}", program.id);
        assert_eq!(part, other.1, "{}", program.id);
        assert_eq!(picture, other.2, "{}", program.id);
        checked += 1;
    }
    assert!(checked >= 20, "only {checked} programs have a bar");
}
