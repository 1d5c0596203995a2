//! The part that a program makes.

use gcode_playground::analyze;
use gcode_playground::control::setup::Setup;
use gcode_playground::shop::Shop;
use gcode_playground::shop::region::Region;

fn shop(program: &str, setup: &str) -> Shop {
    let setup = Setup::from_json(setup).expect("a setup");
    let analysis = analyze(program.as_bytes(), &setup);
    Shop::done(&analysis.motions, &setup)
}

fn part(program: &str, setup: &str) -> Region {
    shop(program, setup).finished().expect("a blank")
}

fn folder(name: &str) -> (String, String) {
    let read = |file: &str| std::fs::read_to_string(format!("tests/programs/{name}/{file}")).expect("a file");
    (read("program.nc"), read("setup.json"))
}

fn check_diameters(part: &Region, z: f64, expected: &[(f64, f64)]) {
    let found: Vec<_> = part.radii(z).into_iter().map(|(low, high)| (2.0 * low, 2.0 * high)).collect();
    let near = |(a, b): (&(f64, f64), &(f64, f64))| (a.0 - b.0).abs() < 0.005 && (a.1 - b.1).abs() < 0.005;
    assert!(
        found.len() == expected.len() && found.iter().zip(expected).all(near),
        "Z{z}: {found:?}, not {expected:?}"
    );
}

/// Seed 001, case 6.3, with sharp tools. Outside, N240 goes from X45.4 Z3 to X50 Z-20: at Z-10 it is at
/// 45.4 + 4.6 × 13 / 23 = 48. Inside, N320 goes from X31 Z3 to X20 Z-30: at Z-10 it is at 31 − 11 × 13 / 33 = 26.667.
#[test]
fn o6003_has_the_diameters_of_its_drawing() {
    let (program, setup) = folder("s001-o6003");
    let part = part(&program, &setup);
    check_diameters(&part, -10.0, &[(26.667, 48.0)]);
    check_diameters(&part, -25.0, &[(31.0 - 11.0 * 28.0 / 33.0, 60.0)]);
    check_diameters(&part, -35.0, &[(20.0, 60.0)]);
}

const STOCK: &str = r#""stock": {"diameter": 60, "bore": 20, "length": 100, "grip": 20}"#;
const TOOLS: &str = r#""T0101": {"type": "turning"}, "T0202": {"type": "boring", "shank": 10}, "T0303": {"type": "grooving", "width": 3, "reach": 8}, "T0404": {"type": "turning", "insert": "VNMG160404", "enteringAngle": 93}"#;

/// What runs into what: the names of the dangers, with the line (from 1) of each.
fn check_danger(program: &str, expected: &[(&str, u32)]) {
    check_danger_with("", program, expected);
}

/// The same with more in the setup.
fn check_danger_with(more: &str, program: &str, expected: &[(&str, u32)]) {
    let travel = r#""travel": {"xMin": -20, "xMax": 300, "zMin": -95, "zMax": 310}"#;
    let setup = format!(r#"{{{more} {STOCK}, "tools": {{{TOOLS}}}, "machine": {{{travel}}}}}"#);
    let setup = Setup::from_json(&setup).expect("a setup");
    let analysis = analyze(program.as_bytes(), &setup);
    let shop = Shop::done(&analysis.motions, &setup);
    let named = |finding: &gcode_playground::shop::danger::Finding| {
        let name = format!("{:?}", finding.danger);
        (
            name.split([' ', '{']).next().unwrap_or_default().to_owned(),
            analysis.motions.line(finding.motion) + 1,
        )
    };
    let found: Vec<_> = shop.findings().iter().map(named).collect();
    let found: Vec<_> = found.iter().map(|(name, line)| (name.as_str(), *line)).collect();
    assert_eq!(found, expected, "{program}");
}

#[test]
fn a_rapid_into_the_work_is_found_and_a_near_miss_is_not() {
    check_danger("T0101\nG00 X62 Z2\nG00 X40 Z2\nG00 Z-10", &[("RapidThroughStock", 4)]);
    check_danger("T0101\nG00 X62 Z2\nG00 X40 Z0.02", &[]);
    check_danger("T0101\nG00 X61 Z2\nG00 Z-50", &[]);
    // Where the bar is turned off already, nothing is left to rub along.
    check_danger("M3 S500 T0101\nG00 X56 Z2\nG01 Z-30 F.2\nX60\nG00 Z2", &[]);
    // A hundredth of a millimetre is no touch.
    check_danger("T0101\nG00 X62 Z2\nG00 X60.02\nZ-50\nX62", &[]);
    check_danger("T0101\nG00 X62 Z2\nG00 X60\nZ-50\nX62", &[("RapidAlongStock", 4)]);
    check_danger("T0101\nG00 X62 Z2\nG00 X59.9\nZ-50\nX62", &[("RapidThroughStock", 4)]);
}

#[test]
fn what_is_cut_is_free_for_rapids() {
    check_danger(
        "T0101\nG00 X62 Z2\nG01 X50 F1\nG01 Z-30\nG00 X51 Z-29\nG00 Z2\nG00 X50\nG01 Z-30\nX62\nG00 Z2",
        &[],
    );
    // The wedge that 95° leave at a shoulder of 2 mm is scraped off; a shoulder of 10 mm is more than that.
    check_danger("T0101\nG00 X62 Z2\nG01 X56 F1\nZ-20\nG00 X62", &[]);
    check_danger("T0101\nG00 X62 Z2\nG01 X40 F1\nZ-20\nG00 X62", &[("RapidThroughStock", 5)]);
    // Half a millimetre too deep on the way back.
    check_danger(
        "T0101\nG00 X62 Z2\nG01 X50 F1\nG01 Z-30\nG00 X49\nG00 Z2",
        &[("RapidThroughStock", 5), ("RapidThroughStock", 6)],
    );
    check_danger("T0101\nG00 X62 Z2\nG90 X55 Z-30 F1\nX50\nX45\nG00 X200 Z100", &[]);
    check_danger(
        "T0101\nG00 X62 Z2\nG71 U2 R1\nG71 P1 Q2 U0.4 W0.1 F1\nN1 G00 X30\nG01 Z-20\nX40 Z-30\nN2 X62\nG70 P1 Q2\nG00 X100 Z50",
        &[],
    );
}

#[test]
fn a_dogleg_is_held_against_the_work_too() {
    check_danger("T0101\nG00 X100 Z2\nG00 X40 Z1", &[]);
    check_danger("T0101\nG00 X62 Z-50\nG01 X61.9 F1\nG00 X80 Z2", &[]);
    // The straight way keeps clear of the corner of the blank, the first leg does not.
    check_danger("T0101\nG00 X100 Z-40\nG00 X58 Z10\nG00 X100 Z-40", &[("DoglegThroughStock", 3)]);
}

#[test]
fn bores_are_left_along_the_axis() {
    check_danger("T0202\nG00 X18 Z2\nG00 Z-20\nG01 X24 F1\nG01 Z-40\nX19\nG00 Z2", &[]);
    check_danger("T0202\nG00 X18 Z2\nG00 Z-20\nG00 X30", &[("LeavesBore", 4)]);
    check_danger("T0202\nG00 X18 Z2\nG01 Z-20 F1", &[]);
}

#[test]
fn jaws_and_travel() {
    check_danger("T0101\nG00 X70 Z2\nG01 Z-78 F1\nG00 X100", &[]);
    check_danger("T0101\nG00 X70 Z2\nG01 Z-82 F1\nG00 X150 Z-70", &[("IntoJaws", 3), ("IntoJaws", 4)]);
    check_danger("T0101\nG00 X310 Z170", &[("OverTravel", 2)]);
    check_danger("T0101\nG00 X300 Z310\nG00 Z310.1", &[("OverTravel", 3)]);
}

#[test]
fn holders_slopes_and_the_axis() {
    // A blade that reaches 8 mm.
    check_danger("T0303\nG00 X62 Z-30\nG01 X46 F1\nX62", &[]);
    check_danger("T0303\nG00 X62 Z-30\nG01 X42 F1\nX62", &[("HolderInStock", 3), ("HolderInStock", 4)]);
    // 45° behind the tip: no rhombus of 80°, but one of 35° follows.
    check_danger("T0101\nG00 X62 Z2\nG01 X58 F1\nZ-20\nX50 Z-24\nZ-30\nX62", &[("SlopeTooSteep", 5)]);
    check_danger("T0404\nG00 X62 Z2\nG01 X58 F1\nZ-20\nX50 Z-24\nZ-30\nX62", &[]);
    check_danger("T0101\nG00 X62 Z0\nG01 X-0.8 F1\nG00 Z2", &[]);
    check_danger("T0101\nG00 X62 Z0\nG01 X-4 F1\nG00 Z2", &[("BelowCenter", 3)]);
    check_danger("T0909\nG00 X62 Z2\nG01 X50 F1", &[("ToolNotListed", 3)]);
}

#[test]
fn the_tailstock_stands_in_front_of_the_face() {
    let tailstock = r#""tailstock": {"z": -2, "diameter": 30},"#;
    check_danger_with(tailstock, "T0101\nG00 X40 Z5", &[]);
    check_danger_with(tailstock, "T0101\nG00 X6 Z5", &[("IntoTailstock", 2)]);
}

/// Real programs change tools behind a bare G28, which moves nothing here, and are cut with inserts that nobody has named.
#[test]
fn what_nobody_knows_is_no_danger() {
    let changed = "T0101\nG00 X62 Z2\nG01 X58 F1\nZ-20\nG00 X62\nZ2\nX10\nT0404\nG00 X64 Z-30\nX62";
    check_danger(changed, &[]);
    check_danger("T0101\nG00 X62 Z2\nG01 Z1 F1\nT0404\nG00 X40 Z-30", &[("RapidThroughStock", 5)]);
    let stock = Setup::from_json(&format!("{{{STOCK}}}")).expect("a setup");
    let findings = |program: &str| {
        let analysis = analyze(program.as_bytes(), &stock);
        Shop::done(&analysis.motions, &stock).findings().len()
    };
    // What a guessed insert leaves at its trailing edge.
    assert_eq!(findings("G00 X64 Z-2\nG01 X28 F1\nG00 X64\nZ-5\nG01 X28\nG00 Z2"), 0);
    assert_eq!(findings("G00 X64 Z2\nG00 X59.5\nG00 Z-5"), 0);
    assert_eq!(findings("G00 X64 Z2\nG00 X57\nG00 Z-5"), 1);
}
