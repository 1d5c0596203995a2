//! With inferred tools, the part has the programmed contour, or no part is shown: tested with random
//! contours, with the test programs, and with programs that a wrongly inferred tool would spoil.

use gcode_playground::analyze;
use gcode_playground::geometry::Point;
use gcode_playground::machine::SimulationResult;
use gcode_playground::machine::region::Region;
use gcode_playground::motion::{Cycle, Motion, Motions};
use gcode_playground::run::Analysis;
use gcode_playground::setup::Setup;
use gcode_playground::units::Diameter;
use proptest::prelude::*;

use crate::fixtures::all;

/// Largest allowed difference in radius, mm.
const TOLERANCE: f64 = 0.06;

/// Stations this close to a wall, mm, may have the radius of either side.
const BESIDE: f64 = 0.1;

/// Line segments per arc.
const PIECES: u32 = 200;

fn run(program: &str) -> (Analysis, SimulationResult) {
    let analysis = analyze(program.as_bytes(), &Setup::default());
    let simulation = SimulationResult::of(&analysis.motions, &analysis.setup);
    (analysis, simulation)
}

fn way(motion: &Motion) -> Vec<Point> {
    match motion.arc() {
        None => vec![motion.from, motion.to],
        Some(arc) => (0..=PIECES).map(|piece| arc.at(f64::from(piece) / f64::from(PIECES))).collect(),
    }
}

/// Smallest radius at which the motions cross a station.
fn least<'a>(motions: impl Iterator<Item = &'a Motion>, z: f64) -> Option<f64> {
    let mut found: Option<f64> = None;
    for motion in motions {
        for ends in way(motion).windows(2) {
            let (a, b) = (ends[0], ends[1]);
            if (a.z - b.z).abs() > 1e-9 && (a.z.min(b.z)..=a.z.max(b.z)).contains(&z) {
                let x = a.x + (z - a.z) / (b.z - a.z) * (b.x - a.x);
                found = Some(found.map_or(x, |least| least.min(x)));
            }
        }
    }
    found
}

/// Compares the outside of a part with the tool path at each station where the tool moves along Z.
fn compare(part: &Region, cuts: &[Motion], stations: impl Iterator<Item = f64>) -> Result<(), String> {
    for z in stations {
        let near = [-BESIDE, -BESIDE / 2.0, 0.0, BESIDE / 2.0, BESIDE];
        let mut near: Vec<f64> = near.iter().filter_map(|by| least(cuts.iter(), z + by)).collect();
        if near.len() < 5 {
            continue;
        }
        // Walls, bottoms of plunges, and corners.
        let ends = cuts.iter().flat_map(|cut| [cut.from, cut.to]);
        near.extend(ends.filter(|end| (end.z - z).abs() <= BESIDE).map(|end| end.x));
        let (low, high) =
            near.iter().fold((f64::INFINITY, 0.0_f64), |(low, high), x| (low.min(*x), high.max(*x)));
        let found = part.radii(z).last().map_or(0.0, |material| material.1);
        if found < low - TOLERANCE || found > high.max(0.0) + TOLERANCE {
            return Err(format!("Z{z:.2}: radius {found:.3}, the tip goes from {low:.3} to {high:.3}"));
        }
    }
    Ok(())
}

fn cuts(motions: &Motions) -> Vec<Motion> {
    motions.iter().filter(|motion| motion.kind.cuts()).collect()
}

/// A contour from right to left: steps along Z and in diameter, and which of them are arcs.
fn contour() -> impl Strategy<Value = Vec<(u32, i32, u32)>> {
    prop::collection::vec((0u32..12, -12i32..14, 0u32..4), 2..9)
}

fn blocks(steps: &[(u32, i32, u32)]) -> (String, f64) {
    let (mut z, mut x) = (0.0, 30.0);
    let mut text = String::new();
    for &(along, across, form) in steps {
        let (dz, dx) = (f64::from(along), f64::from(across));
        z -= dz;
        x = f64::max(x + dx, 6.0);
        let chord = dz.hypot(dx / 2.0);
        // An arc with a visible bulge that turns by less than a quarter.
        text += &match form {
            0 if chord > 2.0 && dz > 0.0 => format!("G02 X{x} Z{z} R{:.3}\n", 1.2 * chord),
            1 if chord > 2.0 && dz > 0.0 => format!("G03 X{x} Z{z} R{:.3}\n", 1.2 * chord),
            _ => format!("G01 X{x} Z{z}\n"),
        };
    }
    (text, z)
}

/// Number of random contours: `PROPTEST_CASES`, or few enough for every test run.
fn cases() -> u32 {
    match std::env::var("PROPTEST_CASES") {
        Ok(_) => ProptestConfig::default().cases,
        Err(_) => 96,
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: cases(), failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn a_finished_contour_is_there_or_no_part_is(steps in contour()) {
        let (blocks, end) = blocks(&steps);
        prop_assume!(end < -1.0);
        let found = contour_or_no_part(&blocks, end, 60);
        prop_assert!(found.is_ok(), "{found:?}");
    }
}

/// Runs one tool along a contour from the face to `end`, and compares the part at `count` stations.
fn contour_or_no_part(blocks: &str, end: f64, count: u32) -> Result<Option<Region>, String> {
    let program = format!(
        "(STOCK D=160 LENGTH=120)\nT0101\nG97 S500 M03\nG00 X30 Z2\nG01 Z0 F0.2\n{blocks}X170\nG00 Z5\n"
    );
    let (analysis, simulation) = run(&program);
    let Some(part) = simulation.finished() else {
        let is_told = !simulation.resolved_setup().unknown().is_empty();
        return if is_told { Ok(None) } else { Err(format!("no part and no reason:\n{program}")) };
    };
    let stations = (0..count).map(|index| end * (f64::from(index) + 0.37) / f64::from(count));
    compare(&part, &cuts(&analysis.motions), stations).map_err(|found| format!("{found}\n{program}"))?;
    Ok(Some(part))
}

/// Arcs that fall by a millimetre within a few tenths along Z: no possible tool can follow them.
#[test]
fn steep_arcs_are_not_gouged() {
    for (blocks, end) in [
        ("G02 X37 Z-5 R7.324\nG03 X25 Z-6 R7.299\n", -6.0),
        (
            "G02 X43 Z-7 R11.463\nG02 X41 Z-9 R2.683\nG02 X37 Z-14 R6.462\nG03 X26 Z-15 R6.708\nG03 X29 Z-24 R10.949\n",
            -24.0,
        ),
        (
            "G01 X20 Z-3\nG03 X9 Z-4 R6.708\nG03 X21 Z-13 R12.980\nG02 X19 Z-17 R4.948\nG03 X25 Z-24 R9.139\n",
            -24.0,
        ),
    ] {
        let found = contour_or_no_part(blocks, end, 600);
        assert!(found.is_ok(), "{found:?}");
    }
}

/// Arcs that fall less steeply, and steep ones that rise.
#[test]
fn arcs_that_a_tool_can_follow_are_cut_as_they_are_programmed() {
    let blocks = "G01 X30 Z-11\nG02 X41 Z-17 R9.767\nG03 X34 Z-28 R13.852\nG03 X22 Z-30 R7.589\nG03 X24 Z-39 R10.866\nG01 X31 Z-48\n";
    let found = contour_or_no_part(blocks, -48.0, 600);
    assert!(matches!(found, Ok(Some(_))), "{found:?}");
}

/// Contours finished by G70 as the last tool there.
#[test]
fn finishing_passes_of_all_programs_are_there() {
    let mut seen = 0;
    for program in all() {
        let analysis = analyze(program.text.as_bytes(), &Setup::from_json(&program.setup).expect("a setup"));
        let simulation = SimulationResult::of(&analysis.motions, &analysis.setup);
        let all: Vec<Motion> = cuts(&analysis.motions);
        let finishing = |motion: &Motion| motion.cycle.is_some_and(|step| step.cycle == Cycle::Finishing);
        let own: Vec<Motion> = all.iter().filter(|motion| finishing(motion)).copied().collect();
        let given = |motion: &Motion| {
            let (station, offset) = motion.process.tool;
            analysis.setup.tools.contains_key(&format!("T{station:02}{offset:02}"))
        };
        let Some(first) = own.first().filter(|motion| !given(motion)) else { continue };
        let is_bore = own.last().is_some_and(|last| last.to.x < first.from.x);
        if is_bore {
            continue;
        }
        let Some(part) = simulation.finished() else { panic!("{}: no part", program.id) };
        let low = own.iter().map(|motion| motion.to.z).fold(f64::INFINITY, f64::min);
        let stations = (0..80).map(|index| low * (f64::from(index) + 0.37) / 80.0);
        let others: Vec<Motion> = all.iter().filter(|motion| !finishing(motion)).copied().collect();
        let stations = stations.filter(|&z| least(others.iter(), z) >= least(own.iter(), z));
        if let Err(difference) = compare(&part, &own, stations) {
            panic!("{}: {difference}", program.id);
        }
        seen += 1;
    }
    assert!(seen > 3, "{seen} programs");
}

/// Checks the kinds of the tools, in order, and diameters of the part at some Z.
fn check(program: &str, tools: &str, diameters: &[(f64, f64)]) {
    let (analysis, simulation) = run(program);
    let kinds: Vec<&str> = simulation
        .resolved_setup()
        .tools()
        .map(|resolved_tool| resolved_tool.tool.kind.map_or("none", |kind| kind.name()))
        .collect();
    assert_eq!(kinds.join(" "), tools, "{program}");
    assert!(!analysis.diagnostics.iter().any(|told| told.is_error()), "{:?}", analysis.diagnostics);
    let Some(part) = simulation.finished() else {
        assert!(diameters.is_empty(), "no part: {program}");
        return;
    };
    for &(z, diameter) in diameters {
        let found = part.radii(z).last().map_or(0.0, |material| 2.0 * material.1);
        assert!((found - diameter).abs() < 0.1, "Z{z}: {found}, not {diameter}\n{program}");
    }
}

const HEAD: &str = "G21 G99 G97 S500 M03\n";

/// A grooving insert that roughs by plunges and then follows the whole contour, up and down, as some
/// programming systems do.
#[test]
fn a_blade_led_along_a_contour_makes_the_contour() {
    let mut program = format!("{HEAD}(GROOVE2)\nT0101\nG00 X64 Z1\n");
    for (z, x) in [(-1.0, 22.0), (-2.0, 24.0), (-10.0, 42.0), (-11.0, 44.0), (-30.0, 26.0), (-31.0, 24.5)] {
        program += &format!("G00 Z{z}\nG01 X60 F0.1\nX{x}\nX{} Z{}\nX62\nG00 X64\n", x + 2.0, z + 1.0);
    }
    program += "G00 Z2\nX20\nG01 Z0 F0.1\nG03 X40 Z-10 R10\nG01 X50 Z-15\nX50 Z-20\nG02 X24 Z-33 R13\nG01 Z-40\nX60 Z-50\nX64\nG00 Z2\n";
    check(&program, "grooving", &[(-12.5, 45.0), (-17.0, 50.0), (-36.0, 24.0), (-45.0, 42.0)]);
}

/// One grooving insert, as wide as its comment says, plunges in cycles and then cuts the walls.
#[test]
fn a_groove_is_finished_by_the_blade_that_made_it() {
    let program = format!(
        "{HEAD}N1T0909(OD ROUGH R0.8)\nG00 X62 Z2\nG90 X60 Z-60 F0.2\nG00 X100 Z50\nN2T0808(GROOVE H4)\nG00 X64 Z-34\n\
         G75 R0.1\nG75 X40 Z-20 P2000 Q3500 F0.1\nG00 X64\nZ-18\nG01 X60 F0.1\nX58 Z-19\nX40\nZ-25\nG00 X64\nZ-36\nG01 X60\nX58 Z-35\nX40\nZ-25\nG00 X64\n"
    );
    check(
        &program,
        "turning grooving grooving",
        &[(-10.0, 60.0), (-16.0, 40.0), (-30.0, 40.0), (-40.0, 60.0)],
    );
}

/// A contour that narrows towards the chuck is still outside: the tool retracts outwards.
#[test]
fn a_contour_that_falls_is_no_bore() {
    let program = format!("{HEAD}T0404\nG00 X66 Z2\nG01 X60 Z0 F0.2\nX56 Z-25\nX52 Z-45\nG00 X70 Z3\n");
    check(&program, "turning", &[(-12.5, 58.0), (-40.0, 53.0)]);
    // To the face at feed, across the face, and away along Z.
    let program = format!("{HEAD}T0101\nG00 X50 Z1\nG01 Z0 F0.2\nX-1\nG00 Z1\nX40\nG01 Z-20\nG00 Z1\nX60\n");
    check(&program, "turning", &[(-10.0, 40.0)]);
    // G28 without axes moves nothing here: the next tool goes to the axis from the position of this one.
    let program = format!(
        "{HEAD}T0707\nG00 X43 Z1\nG01 X41 Z0 F0.2\nG03 X55 Z-7 R7\nG28\nT0808\nG00 X0 Z1\nG01 Z-5 F0.1\nG00 Z2\n"
    );
    check(&program, "turning drill", &[(-8.0, 55.0)]);
    // A tool does not leave a bore by going deeper: that is a rapid into the work.
    let program = format!("{HEAD}T0101\nG00 X40 Z2\nG01 Z-20 F0.2\nX44\nG00 X30 Z-22\nX100 Z100\n");
    check(&program, "turning", &[(-10.0, 40.0)]);
}

/// If the insert named in a comment cannot make the cut, another one is used.
#[test]
fn words_do_not_spoil_the_part() {
    let falls = "G00 X40 Z2\nG01 Z-10 F0.2\nX30 Z-20\nZ-30\nX44\nG00 Z2\n";
    check(&format!("{HEAD}T0101 (CNMG120408)\n{falls}"), "turning", &[(-15.0, 35.0)]);
    check(&format!("{HEAD}T0101 (GROOVE 3MM)\n{falls}"), "turning", &[(-15.0, 35.0)]);
}

#[test]
fn words_give_measures() {
    let program = format!("{HEAD}T0202\n(BROCA 8MM)\nG00 X0 Z2\nG01 Z-20 F0.2\nG00 Z2\n");
    let (_, simulation) = run(&program);
    let drill = simulation.resolved_setup().tools().next().expect("a drill");
    assert_eq!(drill.tool.diameter, Some(Diameter::new(8.0)));
    let program = format!("{HEAD}T0303 (GROOVE W=2)\nG00 X42 Z-20\nG01 X30 F0.1\nG00 X42\n");
    let (_, simulation) = run(&program);
    let blade = simulation.resolved_setup().tools().next().expect("a blade");
    assert_eq!(blade.tool.width, Some(2.0));
}

/// One tool that turns and parts off can only be a grooving insert.
#[test]
fn parting_off_leaves_the_part() {
    let program = format!("{HEAD}T0101\nG00 X42 Z2\nX38\nG01 Z-45 F0.2\nX44\nG00 Z-40\nG01 X-1\nG00 X44\n");
    check(&program, "grooving", &[(-10.0, 38.0), (-36.0, 38.0), (-38.0, 0.0), (-42.0, 38.0)]);
}

#[test]
fn where_no_tool_will_do_no_part_is_shown() {
    let program = format!(
        "{HEAD}T0303\nG00 X52 Z2\nX42 Z-10\nG01 X30 F0.1\nZ-20\nX36 Z-30\nX28 Z-38\nX42\nG00 Z-24\nG01 X20\nG00 X52\n"
    );
    let (mut analysis, simulation) = run(&program);
    assert_eq!(simulation.resolved_setup().unknown().len(), 1);
    assert!(simulation.finished().is_none() && simulation.part_at(&analysis.motions, 1, 0.0).is_none());
    analysis.check_at_machine();
    let told: Vec<_> = analysis.diagnostics.iter().map(|told| told.message.slug()).collect();
    assert!(told.contains(&"tool-unknown"), "{told:?}");
    // A tool named by the user is trusted.
    let named = format!("(TOOL T0303 TYPE=GROOVING WIDTH=3)\n{program}");
    assert!(run(&named).1.finished().is_some());
}

/// The sub spindle takes over the part: its frame has its zero at the other end, and its cuts go towards +Z.
#[test]
fn a_second_clamping_leaves_the_part_of_the_first() {
    let first = "G54 T0101\nG00 X52 Z2\nX40\nG01 Z-30 F0.2\nX52\nG00 X60 Z5\n";
    let second = "G55 T0101\nG00 X52 Z-8\nZ-4\nG01 X-1 F0.1\nG00 Z-8\nX52\nZ0\nG01 X-1\nG00 Z-5\nX36\nG01 Z0\nX40 Z20\nX54\nG00 X60 Z-5\n";
    let kept = [(-2.0, 40.0), (-20.0, 40.0)];
    check(&format!("{HEAD}{first}"), "turning", &kept);
    let both = format!("{HEAD}{first}{second}");
    check(&both, "turning", &kept);
    let told = |program: &str| {
        let mut analysis = run(program).0;
        analysis.check_at_machine();
        analysis.diagnostics.iter().filter(|told| told.message.slug() == "work-zero-unknown").count()
    };
    assert_eq!(told(&both), 1);
    // Named tools and a named blank change nothing here, and rapids there are not checked against this work.
    let named = format!("(STOCK D=50 LENGTH=60)\n(TOOL T0101 TYPE=TURNING)\n{both}");
    let (mut analysis, simulation) = run(&named);
    let part = simulation.finished().expect("a part");
    assert!((part.radii(-20.0).last().expect("material").1 - 20.0).abs() < 0.01);
    analysis.check_at_machine();
    let slugs: Vec<_> = analysis.diagnostics.iter().map(|told| told.message.slug()).collect();
    assert_eq!(slugs.iter().filter(|slug| slug.contains("stock")).count(), 0, "{slugs:?}");
    // Back in the first frame the cuts count again. A frame used throughout is the first, whichever it is.
    let back = format!("{both}G54 T0101\nG00 X42 Z2\nX36\nG01 Z-10\nX42\nG00 X60 Z5\n");
    check(&back, "turning", &[(-5.0, 36.0), (-20.0, 40.0)]);
    let other = format!("{HEAD}{first}").replace("G54", "G56");
    check(&other, "turning", &kept);
    assert_eq!(told(&other), 0);
    // Zeros given in the program are known.
    let given = format!(
        "G10 L2 P1 X0 Z0\nG10 L2 P2 X0 Z0\n{HEAD}{first}G55 T0101\nG00 X42 Z2\nX36\nG01 Z-10\nX42\nG00 X60 Z5\n"
    );
    check(&given, "turning", &[(-5.0, 36.0), (-20.0, 40.0)]);
    assert_eq!(told(&given), 0);
}

/// Corners are rounded by arcs that are not quite tangent, because of rounded numbers.
#[test]
fn a_groove_whose_corner_bulges_is_one_groove() {
    let program = format!(
        "{HEAD}T0303 (GROOVE W=2)\nG00 X52 Z-20\nG01 X41 F0.1\nG00 X52\nZ-18.4\nG01 X50\nG03 X48.2 Z-19.3 R0.9\n\
         G01 X40\nZ-20\nG00 X52\nZ-22\nG01 X50\nG02 X48.2 Z-21 R0.9\nG01 X40\nZ-20\nG00 X52\n"
    );
    check(&program, "grooving", &[(-10.0, 50.0), (-20.0, 40.0)]);
}

/// A grooving insert removes the material in plunges next to each other, which make one groove; a turning
/// insert finishes.
#[test]
fn a_blade_that_roughs_for_an_insert_leaves_its_contour() {
    let mut program = format!("{HEAD}(GROOVE1)\nT0100\nG00 X64 Z1\n");
    let contour = |z: f64| if z > -12.0 { 30.0 - z } else { 54.0 + z };
    for step in 0..25 {
        let z = -f64::from(step);
        let x = contour(z) + 0.2;
        program += &format!("G00 Z{z}\nG01 X{x} F0.1\nX{} Z{}\nX62\nG00 X64\n", x + 2.0, z + 1.0);
    }
    program += "(GROOVE2)\nG00 Z-20\nG01 X24\nX64\nG00 Z5\n\
                T0200\nG00 X30 Z2\nG01 Z0 F0.1\nX42 Z-12\nX30 Z-24\nX64\nG00 Z5\n";
    check(&program, "grooving turning", &[(-6.0, 36.0), (-18.0, 36.0), (-22.0, 32.0), (-20.0, 24.0)]);
}

/// The contour of a cycle reverses in X and ends deeper than before: the material beyond it stays.
#[test]
fn a_contour_that_ends_in_the_bar_is_cut_as_it_is_written() {
    let program = format!(
        "{HEAD}T0101\nG00 X60 Z2\nG71 U2 R1\nG71 P100 Q200 U0.3 W0.2 F0.25\nN100 G00 X48\nG01 Z-20\nX34\nZ-45\nX26\n\
         N200 X60\nG70 P100 Q200\n"
    );
    check(&program, "turning", &[(-10.0, 48.0), (-30.0, 34.0), (-44.0, 34.0)]);
}
