//! Tool offsets: geometry and wear, calculated by hand. Coordinates are positions of the tip, so the length of a
//! tool moves nothing; wear, and changes of an offset by the program, move the path and the part (FANUC B-64304,
//! tool offset; G10).
use gcode_playground::analyze;
use gcode_playground::api;
use gcode_playground::machine::SimulationResult;
use gcode_playground::machine::region::Region;
use gcode_playground::setup::Setup;
use gcode_playground::units::Diameter;

struct Ran {
    part: Region,
    /// Slugs of the messages.
    slugs: Vec<&'static str>,
    /// End points of the motions: X (diameter) and Z of the tip.
    ends: Vec<(f64, f64)>,
}

/// The last diameter is 50, its shoulder is at Z-20.
const TURNED: &str = "G00 X52. Z2.\nG01 X50. F0.2\nZ-20.\nX62.\nG00 X100. Z100.\n";

fn run(text: &str) -> Ran {
    let mut analysis = analyze(text.as_bytes(), &Setup::default());
    analysis.check_at_machine();
    let simulation = SimulationResult::of(&analysis.motions, &analysis.setup);
    let rows = analysis.motions.iter().map(|motion| api::motion(&motion, 0, &analysis.setup.machine).to);
    Ran {
        part: simulation.finished().expect("a blank"),
        slugs: analysis.diagnostics.iter().map(|told| told.message.slug()).collect(),
        ends: rows.map(|to| (to.x.mm(), to.z)).collect(),
    }
}

/// A program for a bar of 60 mm, with the words of a tool comment, blocks before the T word, and the T word.
fn turned(tool: &str, before: &str, called: &str) -> Ran {
    run(&format!(
        "O0001\n(STOCK D=60 LENGTH=60)\n(TOOL T0101 TYPE=TURNING INSERT=CNMG120400 {tool})\n{before}{called}\nG97 S800 M03\n{TURNED}M30\n"
    ))
}

impl Ran {
    /// The outside diameter at a Z. A nose is a polygon that deviates by up to 0.002 mm.
    fn diameter(&self, z: f64) -> f64 {
        let outside = self.part.radii(z).last().map_or(0.0, |radii| radii.1);
        Diameter::from_radius(outside).mm()
    }

    #[track_caller]
    fn has_diameter(&self, z: f64, wanted: f64) {
        let found = self.diameter(z);
        assert!((found - wanted).abs() < 0.003, "at Z{z}: {found} instead of {wanted}");
    }
}

/// X+0.04 of wear leaves 0.04 mm on the diameter; the tip is there, too.
#[test]
fn wear_of_x_moves_the_diameter() {
    let ran = turned("WEARX=0.04", "", "T0101");
    ran.has_diameter(-10.0, 50.04);
    assert!(ran.ends.contains(&(50.04, -20.0)), "{:?}", ran.ends);
    assert!(ran.slugs.is_empty(), "{:?}", ran.slugs);
}

/// Z-0.1 of wear moves the shoulder from Z-20 to Z-20.1.
#[test]
fn wear_of_z_moves_the_shoulder() {
    let ran = turned("WEARZ=-0.1", "", "T0101");
    ran.has_diameter(-20.05, 50.0);
    ran.has_diameter(-20.15, 60.0);
}

/// and Z-80 are the lengths of the tool.
#[test]
fn geometry_of_the_setup_moves_nothing() {
    let plain = turned("", "", "T0101");
    let ran = turned("OFFSETX=-152.3 OFFSETZ=-80", "", "T0101");
    ran.has_diameter(-10.0, 50.0);
    ran.has_diameter(-19.95, 50.0);
    ran.has_diameter(-20.05, 60.0);
    assert_eq!(plain.ends, ran.ends);
}

/// G10 before the T word, and while the offset is in force; absolute, incremental, by a system variable.
#[test]
fn the_program_changes_an_offset() {
    for (tool, before, called, wanted) in [
        ("", "G10 P1 X0.04\n", "T0101", 50.04),
        ("", "", "T0101\nG10 P1 X0.04", 50.04),
        ("", "#2001=0.04\n", "T0101", 50.04),
        ("", "", "T0101\n#2001=#2001+0.04", 50.04),
        ("WEARX=0.04", "", "T0101\n#2001=#2001+0.02", 50.06),
        ("WEARX=0.04", "G10 P1 U-0.06\n", "T0101", 49.98),
        // An absolute value replaces that of the setup.
        ("WEARX=0.04", "G10 P1 X0.01\n", "T0101", 50.01),
        ("", "G10 P10001 U0.1\n", "T0101", 50.1),
        ("OFFSETX=-152.3", "G10 P10001 U0.1\n", "T0101", 50.1),
        ("OFFSETX=-152.3", "G10 L10 P1 X-152.2\n", "T0101", 50.1),
        ("OFFSETX=-152.3", "#2701=#2701+0.1\n", "T0101", 50.1),
        // Another number, and one that is not in force any more.
        ("", "G10 P2 X0.04\n", "T0101", 50.0),
        ("", "", "T0202\nG10 P2 X0.04\nT0101", 50.0),
        // The length of a tool, entered by the program: X and Z of a table with one column, or of the geometry.
        ("", "G10 P1 X-152.3 Z-80.\n", "T0101", 50.0),
        ("", "G10 P10001 X-152.3 Z-80.\n", "T0101", 50.0),
        ("", "G10 P10001 X-152.3\nG10 P10001 U0.1\n", "T0101", 50.1),
        ("", "G10 P1 X-152.3\nG10 P1 U0.1\n", "T0101", 50.1),
        ("", "#2701=-152.3\n#2701=-152.2\n", "T0101", 50.1),
    ] {
        let ran = turned(tool, before, called);
        let found = ran.diameter(-10.0);
        assert!((found - wanted).abs() < 0.0005, "{tool} {before:?} {called:?}: {found} instead of {wanted}");
    }
}

/// 0.002 in on the diameter are 0.0508 mm.
#[test]
fn offsets_of_an_inch_program_are_in_inches() {
    let ran =
        run("O1 G20\n(STOCK D=60 LENGTH=60)\n(TOOL T0101 TYPE=TURNING INSERT=CNMG120400)\nG10 P1 X.002\n\
        T0101\nG97 S800 M03\nG00 X2.1 Z.1\nG01 X2. F.01\nZ-.8\nX2.5\nG00 X4. Z4.\nM30\n");
    ran.has_diameter(-10.0, 50.8508);
}

/// T0100 cancels the wear of offset 01: X40 is 40, and so is the diameter after T0111, whose wear is 0.
#[test]
fn offset_00_cancels_and_another_offset_of_the_tool_has_its_own_wear() {
    for called in ["T0100", "T0111", "T0100\nT0111"] {
        let ran = run(&format!(
            "O1\n(STOCK D=60 LENGTH=60)\n(TOOL T0101 TYPE=TURNING INSERT=CNMG120400 WEARX=0.04)\n(TOOL T0111 WEARZ=0)\n\
            T0101\nG97 S800 M03\n{TURNED}{called}\nG00 X52. Z2.\nG01 X40. F0.2\nZ-10.\nX62.\nG00 X100. Z100.\nM30\n"
        ));
        ran.has_diameter(-15.0, 50.04);
        ran.has_diameter(-5.0, 40.0);
    }
}

/// Only U and W: the tip takes the new offset with the next move, as with absolute words. From X200, U-150 is X50.
#[test]
fn incremental_moves_take_the_offset_too() {
    let ran = run(
        "O1\n(STOCK D=60 LENGTH=60)\n(TOOL T0101 TYPE=TURNING INSERT=CNMG120400 WEARX=0.04)\n(START X=200 Z=100)\n\
        T0101\nG97 S800 M03\nG00 U-148. W-98.\nG01 U-2. F0.2\nW-22.\nU12.\nG00 U138. W120.\nM30\n",
    );
    ran.has_diameter(-10.0, 50.04);
    assert_eq!(ran.ends.last(), Some(&(200.04, 100.0)));
}

/// The cycles start at the programmed point, and their passes are moved like other moves.
#[test]
fn cycles_are_moved() {
    let ran = run(
        "O1\n(STOCK D=60 LENGTH=60)\n(TOOL T0101 TYPE=TURNING INSERT=CNMG120400 WEARX=0.04 WEARZ=-0.1)\n\
        T0101\nG97 S800 M03\nG00 X62. Z2.\nG90 X56. Z-20. F0.2\nX50.\nG00 X100. Z100.\nM30\n",
    );
    ran.has_diameter(-10.0, 50.04);
    ran.has_diameter(-20.05, 50.04);
    ran.has_diameter(-20.15, 60.0);
}

/// A cone of 45° from Ø30 to Ø50 with a nose of 0.8 mm and R = 0.8 + 0.1 in the table: the control keeps the edge
/// 0.1·(√2 − 1) mm too deep, 0.1·(2 − √2) mm along X: Ø40 at Z-5 becomes 40 − 0.2·(2 − √2) = 39.883.
#[test]
fn wear_of_r_falsifies_a_compensated_cone() {
    let program = |wear: &str| {
        run(&format!(
            "O1\n(STOCK D=60 LENGTH=60)\n(TOOL T0101 TYPE=TURNING INSERT=CNMG120408 {wear})\nT0101\nG97 S800 M03\n\
            G00 X70. Z5.\nG42 G00 X26. Z2.\nG01 X30. Z0 F0.2\nX50. Z-10.\nZ-20.\nX62.\nG40 G00 X100. Z100.\nM30\n"
        ))
    };
    program("").has_diameter(-5.0, 40.0);
    program("WEARR=0.1").has_diameter(-5.0, 40.0 - 0.2 * (2.0 - 2.0_f64.sqrt()));
    // On the cylinder the edge stays at the programmed diameter.
    program("WEARR=0.1").has_diameter(-15.0, 50.0);
}

/// G28 takes the turret to its reference point whatever the offset: the tip is 0.04 mm nearer to the programmed
/// position than without wear, and the machine coordinate #5021 is the same.
#[test]
fn the_reference_point_does_not_depend_on_wear() {
    let home = |tool: &str| {
        let ran = run(&format!(
            "O1\n(STOCK D=60 LENGTH=60)\n(TOOL T0101 TYPE=TURNING INSERT=CNMG120400 {tool})\nT0101\nG97 S800 M03\n{TURNED}G28 U0 W0\nM30\n"
        ));
        *ran.ends.last().expect("a motion")
    };
    assert_eq!(home(""), home("WEARX=0.04 WEARZ=-0.1"));
}

/// A wear value of more than 9.999 mm is no wear (FANUC parameter 5013).
#[test]
fn wear_is_limited() {
    assert_eq!(turned("WEARX=12", "", "T0101").slugs, ["setup-value"]);
}

/// A comment that names tool, nose radius and tip direction is read: the cone is compensated by it, and the insert
/// has this nose. Without it, Ø40 is cut with a sharp tool, and the unknown radius is reported.
#[test]
fn a_nose_in_a_comment_is_read() {
    let program = |comment: &str| {
        run(&format!(
            "O1\n({comment})\n(STOCK D=60 LENGTH=60)\nT0101\nG97 S800 M03\nG00 X70. Z5.\nG42 G00 X26. Z2.\n\
            G01 X30. Z0 F0.2\nX50. Z-10.\nZ-20.\nX62.\nG40 G00 X100. Z100.\nM30\n"
        ))
    };
    let plain = program("ROUGH TOOL");
    assert!(plain.slugs.contains(&"nose-radius-unknown"), "{:?}", plain.slugs);
    let ran = program("TO1 = 80* Rough Tool, Tool Nose Radius: .0315, Tool Tip: 3");
    assert!(!ran.slugs.contains(&"nose-radius-unknown"), "{:?}", ran.slugs);
    ran.has_diameter(-5.0, 40.0);
    // The tip is beside the contour: at Z-5 it is nearer to the axis by r·(2 − √2) on the diameter.
    assert_ne!(plain.ends, ran.ends);
}
