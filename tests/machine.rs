//! The part and the collisions of worked programs.

use gcode_playground::analyze;
use gcode_playground::machine::SimulationResult;
use gcode_playground::machine::danger::Danger;
use gcode_playground::machine::region::Region;
use gcode_playground::message::Severity;
use gcode_playground::setup::Setup;

fn simulation(program: &str, setup: &str) -> SimulationResult {
    let setup = Setup::from_json(setup).expect("a setup");
    let analysis = analyze(program.as_bytes(), &setup);
    SimulationResult::of(&analysis.motions, &setup)
}

fn part(program: &str, setup: &str) -> Region {
    simulation(program, setup).finished().expect("a blank")
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
/// 45.4 + 4.6 × 13 / 23 = 48. Inside, N320 goes from X31 Z3 to X20 Z-30: at Z-10 it is at
/// 31 − 11 × 13 / 33 = 26.667.
#[test]
fn o6003_has_the_diameters_of_its_drawing() {
    let (program, setup) = folder("s001-o6003");
    let mut sharp: serde_json::Value = serde_json::from_str(&setup).expect("a setup");
    for tool in sharp["tools"].as_object_mut().expect("tools").values_mut() {
        tool.as_object_mut().expect("a tool").remove("noseRadius");
    }
    let with_noses = part(&program, &setup);
    let part = part(&program, &sharp.to_string());
    check_diameters(&part, -10.0, &[(26.667, 48.0)]);
    check_diameters(&part, -25.0, &[(31.0 - 11.0 * 28.0 / 33.0, 60.0)]);
    check_diameters(&part, -35.0, &[(20.0, 60.0)]);
    // A nose of radius r leaves r · (1 + tan α − 1 / cos α) on a cone, on either side: for 0.2 mm and tan α = 0.1
    // that is 0.019, for tan α = 5.5 / 33 it is 0.0306.
    check_diameters(&with_noses, -10.0, &[(26.667 - 0.0612, 48.0 + 0.038)]);
    check_diameters(&with_noses, -35.0, &[(20.0, 60.0)]);
}

const STOCK: &str = r#""stock": {"diameter": 60, "bore": 20, "length": 100, "grip": 20}"#;
const TOOLS: &str = r#""T0101": {"type": "turning"}, "T0202": {"type": "boring", "shank": 10}, "T0303": {"type": "grooving", "width": 3, "reach": 8}, "T0404": {"type": "turning", "insert": "VNMG160404", "enteringAngle": 93}"#;

/// Checks the names of the collisions, with the line of each, counted from 1.
fn check_danger(program: &str, expected: &[(&str, u32)]) {
    check_danger_with("", program, expected);
}

/// The same with additional setup fields.
fn check_danger_with(more: &str, program: &str, expected: &[(&str, u32)]) {
    let travel = r#""travel": {"xMin": -20, "xMax": 300, "zMin": -95, "zMax": 310}"#;
    let setup = format!(r#"{{{more} {STOCK}, "tools": {{{TOOLS}}}, "machine": {{{travel}}}}}"#);
    let setup = Setup::from_json(&setup).expect("a setup");
    let analysis = analyze(program.as_bytes(), &setup);
    let simulation = SimulationResult::of(&analysis.motions, &setup);
    let named = |finding: &gcode_playground::machine::danger::Finding| {
        let name = format!("{:?}", finding.danger);
        (
            name.split([' ', '{']).next().unwrap_or_default().to_owned(),
            analysis.motions.line(finding.motion) + 1,
        )
    };
    let found: Vec<_> = simulation.findings().iter().map(named).collect();
    let found: Vec<_> = found.iter().map(|(name, line)| (name.as_str(), *line)).collect();
    assert_eq!(found, expected, "{program}");
}

#[test]
fn a_rapid_into_the_work_is_found_and_a_near_miss_is_not() {
    check_danger("T0101\nG00 X62 Z2\nG00 X40 Z2\nG00 Z-10", &[("RapidThroughStock", 4)]);
    check_danger("T0101\nG00 X62 Z2\nG00 X40 Z0.02", &[]);
    check_danger("T0101\nG00 X61 Z2\nG00 Z-50", &[]);
    // Where the bar is already turned down, there is nothing to rub against.
    check_danger("M3 S500 T0101\nG00 X56 Z2\nG01 Z-30 F.2\nX60\nG00 Z2", &[]);
    // A distance of a hundredth of a millimetre is not a contact.
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
    // The wedge that a 95° tool leaves at a shoulder of 2 mm is scraped off; a shoulder of 10 mm is too much.
    check_danger("T0101\nG00 X62 Z2\nG01 X56 F1\nZ-20\nG00 X62", &[]);
    check_danger("T0101\nG00 X62 Z2\nG01 X40 F1\nZ-20\nG00 X62", &[("RapidThroughStock", 5)]);
    // Half a millimetre too deep on the return.
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
    // The direct path clears the corner of the blank, the first leg does not.
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

/// The jaws begin at Z-50. The tool is not given: its tip at X48 is within the bar, but the tool is not.
#[test]
fn an_assumed_tool_is_in_the_jaws_where_its_tip_passes_them() {
    let setup = r#"{"stock": {"diameter": 50, "length": 80, "grip": 30}}"#;
    let found = |z: &str| {
        let program = format!("T0101\nG97 S800 M03\nG00 X52 Z2\nG01 X48 F0.2\nZ{z}\nG00 X100 Z100\nM30");
        let findings = simulation(&program, setup).findings().to_vec();
        let jaws = findings.into_iter().filter(|finding| matches!(finding.danger, Danger::IntoJaws));
        jaws.map(|finding| (finding.motion, (10.0 * finding.at.z).round() / 10.0)).collect::<Vec<_>>()
    };
    assert_eq!(found("-49.5"), []);
    // The cut itself is the third motion; its retract begins in the jaws, too.
    assert_eq!(found("-60")[0], (2, -50.0));
    // A drill goes through them along the axis.
    let drilled = "T0202\nG97 S800 M03\nG00 X0 Z2\nG01 Z-70 F0.1\nG00 Z5\nM30";
    assert!(simulation(drilled, setup).findings().is_empty());
}

/// Checks the place of the first collision: diameter and Z, to two thousandths of a millimetre of radius.
fn check_place(setup: &str, program: &str, expected: (f64, f64)) {
    let findings = simulation(&format!("G97 S800 M03\n{program}"), setup).findings().to_vec();
    let at = findings.first().expect("a collision").at;
    let (x, z) = (2.0 * at.x, at.z);
    assert!((x - expected.0).abs() <= 0.004 && (z - expected.1).abs() <= 0.002, "{program}: X{x} Z{z}");
}

#[test]
fn a_collision_is_where_the_tool_first_touches() {
    let bar = r#""stock": {"diameter": 50, "length": 80, "grip": 30}"#;
    let assumed = format!("{{{bar}}}");
    // The jaws begin at Z-50. The nose of the assumed tool touches them beside the programmed point.
    check_place(&assumed, "T0101\nG00 X54 Z2\nG90 X46 Z-55 F0.25", (46.0, -50.0));
    check_place(&assumed, "T0101\nG00 X54 Z2\nG01 X20 F0.2\nZ-60", (20.0, -50.0));
    // At 45° from X60 Z2 the tip is at X50 where Z is -3.
    for nose in ["0", "0.4", "0.8"] {
        let tool = format!(r#""tools": {{"T0101": {{"type": "turning", "noseRadius": {nose}}}}}"#);
        let setup = format!("{{{bar}, {tool}}}");
        check_place(&setup, "T0101\nG00 X60 Z2\nG00 X40 Z-8", (50.0, -3.0));
        check_place(&setup, "T0101\nG00 X40 Z2\nG00 Z-8", (40.0, 0.0));
        check_place(&setup, "T0101\nG00 X60 Z-20\nG00 X40", (50.0, -20.0));
        // Along the turned surface of X40 into the shoulder at Z-30.
        let shoulder = "T0101\nG00 X54 Z2\nG01 X40 F0.2\nZ-30\nX54\nG00 Z2\nX40\nZ-40";
        check_place(&setup, shoulder, (40.0, -30.0));
        // The edge above the tip reaches the corner of the jaws, and the cut to X46 is below it.
        check_place(&setup, "T0101\nG00 X54 Z2\nG01 X46 F0.2\nZ-55", (50.0, -50.0));
    }
    // The holder of a blade with a reach of 8 mm meets the outside of the blank at the side of the insert.
    let blade = r#""tools": {"T0303": {"type": "grooving", "width": 3, "reach": 8}}"#;
    check_place(&format!("{{{bar}, {blade}}}"), "T0303\nG00 X54 Z-20\nG01 X30 F0.1", (50.0, -17.0));
}

/// The blank is a tube of 60 and 20 mm; the inserts have edges of 12 mm.
#[test]
fn a_tool_on_the_wrong_side_is_one_fault() {
    check_danger("T0202\nM3 S500\nG00 X62 Z2\nG90 X56 Z-30 F.2\nX52\nG00 X100 Z50", &[("WrongSide", 4)]);
    check_danger("T0101\nM3 S500\nG00 X18 Z2\nG90 X24 Z-30 F.2\nX26\nG00 Z50", &[("WrongSide", 4)]);
    check_danger("T0101\nM3 S500\nG00 X62 Z2\nG90 X56 Z-30 F.2\nX52\nG00 X100 Z50", &[]);
    check_danger("T0202\nM3 S500\nG00 X18 Z2\nG90 X24 Z-30 F.2\nX26\nG00 Z50", &[]);
    // A bore that is drilled with a tool that is not shown: the boring bar comes from within.
    let solid = r#"{"stock": {"diameter": 60, "length": 100}, "tools": {"T0202": {"type": "boring"}}}"#;
    let findings = simulation("T0202\nM3 S500\nG00 X36 Z2\nG90 X42 Z-30 F.2", solid).findings().to_vec();
    assert!(!findings.iter().any(|finding| matches!(finding.danger, Danger::WrongSide { .. })));
}

#[test]
fn holders_slopes_and_the_axis() {
    // A grooving insert with a reach of 8 mm.
    check_danger("T0303\nG00 X62 Z-30\nG01 X46 F1\nX62", &[]);
    check_danger("T0303\nG00 X62 Z-30\nG01 X42 F1\nX62", &[("HolderInStock", 3), ("HolderInStock", 4)]);
    // A slope of 45° behind the tip: an 80° rhombus cannot follow it, one of 35° can.
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

/// Real programs change tools after a G28 without axes, which moves nothing here, and cut with unnamed
/// inserts.
#[test]
fn what_nobody_knows_is_no_danger() {
    let changed = "T0101\nG00 X62 Z2\nG01 X58 F1\nZ-20\nG00 X62\nZ2\nX10\nT0404\nG00 X64 Z-30\nX62";
    check_danger(changed, &[]);
    check_danger("T0101\nG00 X62 Z2\nG01 Z1 F1\nT0404\nG00 X40 Z-30", &[("RapidThroughStock", 5)]);
    let stock = Setup::from_json(&format!("{{{STOCK}}}")).expect("a setup");
    let findings = |program: &str| {
        let analysis = analyze(program.as_bytes(), &stock);
        SimulationResult::of(&analysis.motions, &stock).findings().len()
    };
    // Material that an inferred insert leaves at its trailing edge.
    assert_eq!(findings("G00 X64 Z-2\nG01 X28 F1\nG00 X64\nZ-5\nG01 X28\nG00 Z2"), 0);
    assert_eq!(findings("G00 X64 Z2\nG00 X59.5\nG00 Z-5"), 0);
    assert_eq!(findings("G00 X64 Z2\nG00 X57\nG00 Z-5"), 1);
}

/// M20×2.5 with a relief groove from Z-22 to Z-25 in front of a shoulder of ⌀42; thread core 20 − 1.2269 ×
/// 2.5.
const TO_A_SHOULDER: &str = "O0020
T0101
G97 S800 M03
G00 X44 Z2
G90 X36 Z-25 F0.2
X30
X24
X20
G00 X200 Z200
T0202
G00 X44 Z-25
G01 X16.4 F0.05
G00 X44
X200 Z200
T0303
G97 S400
G00 X24 Z6
G92 X19.2 Z-23.5 F2.5
X18.4
X17.7
X17.2
X16.93
G00 X200 Z200
M30
";

#[test]
fn a_threading_tool_reaches_a_shoulder_behind_its_relief_groove() {
    let tools = r#""T0101": {"type": "turning"}, "T0202": {"type": "grooving", "width": 3}"#;
    for thread in [
        "",
        r#", "T0303": {"type": "threading"}"#,
        r#", "T0303": {"type": "threading", "insert": "16ER"}"#,
        r#", "T0303": {"type": "threading", "insert": "16ER2.5ISO", "reach": 14}"#,
        r#", "T0303": {"type": "threading", "edgeLength": 2.9}"#,
    ] {
        let stock = r#""stock": {"diameter": 42, "length": 60}, "dialect": {"threadChamfer": 0}"#;
        let simulation = simulation(TO_A_SHOULDER, &format!(r#"{{{stock}, "tools": {{{tools}{thread}}}}}"#));
        let found: Vec<_> = simulation.findings().iter().map(|found| (found.motion, found.danger)).collect();
        assert!(
            found.iter().all(|(_, danger)| matches!(danger, Danger::ToolNotListed { .. })),
            "{thread}: {found:?}"
        );
        let part = simulation.finished().expect("a blank");
        check_diameters(&part, -25.01, &[(0.0, 42.0)]);
        check_diameters(&part, -24.99, &[(0.0, 16.4)]);
        // A notch every 2.5 mm from Z6 on, and a crest between two notches.
        check_diameters(&part, -14.0, &[(0.0, 16.93)]);
        check_diameters(&part, -15.25, &[(0.0, 20.0)]);
    }
}

#[test]
fn a_threading_tool_with_long_edges_cuts_a_shoulder_away() {
    let stock = r#""stock": {"diameter": 42, "length": 60}, "dialect": {"threadChamfer": 0}"#;
    let tools = r#""T0101": {"type": "turning"}, "T0202": {"type": "grooving", "width": 3}, "T0303": {"type": "threading", "edgeLength": 12}"#;
    let simulation = simulation(TO_A_SHOULDER, &format!(r#"{{{stock}, "tools": {{{tools}}}}}"#));
    assert!(simulation.findings().iter().any(|found| found.danger == Danger::RapidThroughStock));
    assert!(simulation.finished().expect("a blank").radii(-25.01)[0].1 < 21.0);
}

/// The holder of a tool with an overhang of 8 mm hits a shoulder that is 11 mm high.
#[test]
fn the_holder_of_a_threading_tool_meets_a_high_shoulder() {
    let stock = r#""stock": {"diameter": 42, "length": 60}, "dialect": {"threadChamfer": 0}"#;
    let deep = TO_A_SHOULDER.replace("Z-23.5 F2.5", "Z-23.6 F2.5");
    let dangers = |program: &str, insert: &str, reach: u32| {
        let tools = format!(
            r#""T0101": {{"type": "turning"}}, "T0202": {{"type": "grooving", "width": 3}},
            "T0303": {{"type": "threading", "insert": "{insert}", "reach": {reach}}}"#
        );
        let simulation = simulation(program, &format!(r#"{{{stock}, "tools": {{{tools}}}}}"#));
        simulation.findings().iter().map(|found| found.danger).collect::<Vec<_>>()
    };
    assert_eq!(dangers(TO_A_SHOULDER, "16ER", 8), []);
    assert!(dangers(&deep, "16ER", 8).contains(&Danger::HolderInStock));
    // The holder of a left-hand tool is on the chuck side.
    assert!(dangers(TO_A_SHOULDER, "16EL", 8).contains(&Danger::HolderInStock));
}

/// The blank is ⌀60 with a bore of 20. The tool is unnamed, but the path of its tip is known.
#[test]
fn threads_that_start_within_the_work() {
    let check = |cycle: &str, start: &str, expected: &[&str]| {
        let blocks = match cycle {
            "G92" => "G92 X59.2 Z-30 F2\nX58.6\nX57.6",
            "G92 inside" => "G92 X20.8 Z-30 F2\nX21.4\nX22.4",
            "G76 inside" => "G76 P010060 Q50 R0.05\nG76 X22.6 Z-30 P1300 Q400 F2",
            _ => "G76 P010060 Q50 R0.05\nG76 X57.4 Z-30 P1300 Q400 F2",
        };
        let program = format!(
            "O1 (STOCK D=60 BORE=20 LENGTH=100)\nG99 T0505\nG97 S300 M3\nG0 {start}\n{blocks}\nG0 X100 Z100\nM30"
        );
        let mut analysis = analyze(program.as_bytes(), &Setup::default());
        analysis.check_at_machine();
        let starts = [
            "start-behind-face",
            "cycle-starts-in-stock",
            "thread-start-inside-crest",
            "rapid-through-stock",
        ];
        let slugs = analysis.diagnostics.iter().map(|found| found.message.slug());
        let found: Vec<_> = slugs.filter(|slug| starts.contains(slug)).collect();
        assert_eq!(found, expected, "{program}");
    };
    for cycle in ["G92", "G76"] {
        check(cycle, "X64 Z6", &[]);
        check(cycle, "X64 Z1", &[]);
        check(cycle, "X64 Z-5", &["start-behind-face"]);
        check(cycle, "X59.9 Z6", if cycle == "G92" { &[] } else { &["thread-start-inside-crest"] });
    }
    check("G92", "X59.5 Z6", &["cycle-starts-in-stock"]);
    check("G76", "X59.5 Z6", &["thread-start-inside-crest"]);
    for cycle in ["G92 inside", "G76 inside"] {
        check(cycle, "X16 Z6", &[]);
        check(cycle, "X16 Z-5", &["start-behind-face"]);
    }
}

/// A thread that starts in a relief groove does not start in the work.
#[test]
fn threads_that_start_in_a_groove() {
    let program = "O1 (STOCK D=60 LENGTH=100)\n(TOOL T0303 TYPE=GROOVING WIDTH=6)\nG99 T0303\nG97 S300 M3\n\
                   G0 X64 Z-32\nG1 X50 F.1\nG0 X64\nG0 Z100\nT0505\nG0 X64 Z-29\nG92 X59.2 Z5 F2\nX58.6\nG0 X100 Z100\nM30";
    let mut analysis = analyze(program.as_bytes(), &Setup::default());
    analysis.check_at_machine();
    let slugs: Vec<_> = analysis.diagnostics.iter().map(|found| found.message.slug()).collect();
    assert!(!slugs.contains(&"start-behind-face"), "{slugs:?}");
}

/// If a thread ends between two turns, the insert is in its own groove there, and retracts from it.
#[test]
fn a_thread_may_end_between_two_turns() {
    let slugs = |body: &str| {
        let text = format!(
            "O1 (STOCK D=30 LENGTH=80)\n(TOOL T0505 TYPE=THREADING)\nT0505\nG97 S480 M03\n{body}G00 X200 Z200\nM30\n"
        );
        let mut analysis = gcode_playground::analyze(text.as_bytes(), &Setup::default());
        analysis.check_at_machine();
        let found = analysis.diagnostics.iter().filter(|one| one.severity > Severity::Info);
        found.map(|one| one.message.slug()).collect::<Vec<_>>()
    };
    for end in ["-29", "-29.3", "-29.5", "-29.9", "-30"] {
        let passes = format!("G00 X34 Z6\nG92 X29.2 Z{end} F2\nX28.6\nX28\nX27.6\nX27.4\n");
        assert_eq!(slugs(&passes), [""; 0], "{end}");
        // As single moves, and as a cycle whose flank infeed moves the start, with a straight retract and
        // with a pull-out.
        let by_hand = format!("G00 X34 Z6\nX29\nG32 Z{end} F2\nG00 X34\nZ6\nX28.4\nG32 Z{end} F2\nG00 X34\n");
        assert_eq!(slugs(&by_hand), [""; 0], "{end}");
        for run_out in ["00", "05", "10"] {
            let cycle = format!("G00 X34 Z6\nG76 P02{run_out}60 Q50 R0.05\nG76 X27.4 Z{end} P1300 Q400 F2\n");
            assert_eq!(slugs(&cycle), [""; 0], "{end} {run_out}");
        }
    }
    // A rapid into the work is still reported.
    assert_eq!(slugs("G00 X34 Z6\nG92 X29.2 Z-29 F2\nG00 X28 Z-40\n")[0], "rapid-through-stock");
}
