//! Shifts of the work zero that a program makes, worked out by hand: the part is that of the workpiece, coordinates are those
//! of the program.
use std::collections::BTreeSet;

use gcode_playground::current::Current;
use gcode_playground::export::csv;
use gcode_playground::geometry::Point;
use gcode_playground::machine::SimulationResult;
use gcode_playground::machine::region::Region;
use gcode_playground::motion::Motions;
use gcode_playground::run::Run;
use gcode_playground::scene::{Plane, StrokeShape};
use gcode_playground::setup::Setup;
use gcode_playground::units::Diameter;

struct Ran {
    motions: Motions,
    part: Region,
    setup: Setup,
    /// Slugs and lines, the first being 1.
    told: BTreeSet<String>,
}

fn run(text: &str) -> Ran {
    let mut run = Run::new(text.as_bytes().to_vec(), Setup::default());
    while !run.advance(usize::MAX) {}
    let mut analysis = run.into_analysis();
    analysis.check_at_machine();
    let simulation = SimulationResult::of(&analysis.motions, &analysis.setup);
    let line = |byte: u32| text[..byte as usize].matches('\n').count() + 1;
    let told = analysis.diagnostics.iter();
    Ran {
        told: told.map(|told| format!("{} {}", told.message.slug(), line(told.span.start))).collect(),
        part: simulation.finished().expect("a blank"),
        motions: analysis.motions,
        setup: analysis.setup,
    }
}

impl Ran {
    /// The outside diameter of the part at a Z, to a tenth.
    fn diameter(&self, z: f64) -> f64 {
        let outside = self.part.radii(z).last().map_or(0.0, |radii| radii.1);
        (10.0 * Diameter::from_radius(outside).mm()).round() / 10.0
    }
}

/// X40 is turned to Z-30; 40 mm further the bar of 50 mm is whole, and X42 is inside of it.
#[test]
fn a_rapid_into_the_bar_is_found_wherever_the_zero_is() {
    let program = |before: &str, shift: &str, to: &str| {
        format!(
            "(STOCK D=50 LENGTH=100)\n(TOOL T0101 TYPE=TURNING INSERT=CNMG120408 KR=95)\n{before}T0101\nG97 S800 M03\nG54 G00 X52. Z2.\nG90 X44. Z-30. F.2\nX40.\n{shift}\n{to}\nG00 X60.\nM30\n"
        )
    };
    let told = |before: &str, shift: &str, to: &str| run(&program(before, shift, to)).told;
    let crash = "rapid-through-stock";
    let has_crash = |told: &BTreeSet<String>| told.iter().any(|one| one.starts_with(crash));
    let plain = told("", "", "G00 X42. Z-60.");
    assert!(has_crash(&plain), "{plain:?}");
    let lines_after = |before: &str| before.matches('\n').count();
    for (before, shift, to) in [
        ("", "G52 Z-40.", "G00 X42. Z-20."),
        ("", "G50 W40.", "G00 X42. Z-20."),
        ("", "G10 P0 W-40.", "G00 X42. Z-20."),
        ("", "G10 P0 Z-40.", "G00 X42. Z-20."),
        ("", "G10 L2 P0 Z-40.", "G00 X42. Z-20."),
        ("", "G10 L2 P1 Z-40.", "G00 X42. Z-20."),
        ("", "G10 L2 P1 W-40.", "G00 X42. Z-20."),
        ("G10 L2 P1 Z-300.\n", "G10 L2 P1 Z-340.", "G00 X42. Z-20."),
        ("G10 L2 P1 Z0\nG10 L2 P2 Z-40.\n", "G55", "G00 X42. Z-20."),
        ("G10 L2 P1 Z-300.\nG10 L2 P3 Z-340.\n", "G56", "G00 X42. Z-20."),
        ("G10 L2 P1 Z0\nG10 L20 P5 Z-40.\n", "G54.1 P5", "G00 X42. Z-20."),
        ("", "#5222=-40.", "G00 X42. Z-20."),
        ("", "#5202=-40.", "G00 X42. Z-20."),
        ("#5222=0\n#5242=-40.\n", "G55", "G00 X42. Z-20."),
        // Two shifts add up, and one is taken back.
        ("", "G52 Z-10.\nG10 P0 W-30.", "G00 X42. Z-20."),
        ("", "G52 Z-40.\nG52 Z0", "G00 X42. Z-60."),
        // A shift of X: X32 is 42 mm of the bar.
        ("", "G52 X10.", "G00 X32. Z-60."),
        // Relative to a zero that was shifted before the first cut.
        ("G52 Z-500.\n", "G52 Z-540.", "G00 X42. Z-20."),
    ] {
        let told = told(before, shift, to);
        assert!(has_crash(&told), "{before}{shift}: {told:?}");
        let line = lines_after(before) + shift.lines().count() + 8;
        assert!(told.contains(&format!("{crash} {line}")), "{before}{shift}: {told:?}");
        let is_said = told.iter().any(|one| one.starts_with("work-zero-unknown"));
        assert_eq!(is_said, before.is_empty() && shift == "G10 L2 P1 Z-40.", "{before}{shift}: {told:?}");
    }
    // In the turned seat there is room; G50 X Z is no shift.
    for (shift, to) in [("G52 Z-40.", "G00 X42. Z20."), ("G50 Z-38.", "G00 Z-20.\nX42.")] {
        assert!(!has_crash(&told("", shift, to)), "{shift}");
    }
    // Nobody says where G56 is, or where G54 was.
    for (before, shift) in
        [("G10 L2 P1 Z0\n", "G56"), ("G10 L2 P3 Z-40.\n", "G56"), ("G10 L2 P3 W-40.\n", "G56")]
    {
        let unknown = told(before, shift, "G01 X42. Z-20. F.1");
        assert!(unknown.contains("work-zero-unknown 10") && !has_crash(&unknown), "{before}: {unknown:?}");
    }
    // A zero that is set after the first cut, and was not given before, is taken as 0, with a message.
    assert!(told("", "G10 L2 P1 Z-40.", "G00 X42. Z-20.").contains("work-zero-unknown 8"));
}

/// A groove 3 mm wide to 40 mm at Z-10 of G54, and one to 44 mm at Z-10 of G55, 30 mm further.
#[test]
fn grooves_of_two_work_coordinate_systems_are_side_by_side() {
    let ran = run(
        "(STOCK D=50 LENGTH=80)\n(TOOL T0303 TYPE=GROOVING WIDTH=3)\nG21 G99 G97 S500 M03 T0303\nG10 L2 P1 X0 Z0\nG10 L2 P2 X0 Z-30.\nG54 G00 X52. Z-10.\nG01 X40. F.1\nG00 X52.\nG55 G00 Z-10.\nG01 X44. F.1\nG00 X52.\nG54\nG00 X100. Z100.\nM30\n",
    );
    assert_eq!(ran.told, BTreeSet::new());
    let diameters = [-5.0, -8.5, -20.0, -38.5, -50.0].map(|z| ran.diameter(z));
    assert_eq!(diameters, [50.0, 40.0, 50.0, 44.0, 50.0]);
    // Motions keep programmed coordinates and carry the offset.
    let second = ran.motions.iter().filter(|motion| motion.kind.cuts()).nth(1).expect("two cuts");
    assert_eq!(
        (second.to, second.process.frame, second.process.zero),
        (Point::new(22.0, -10.0), 1, Point::new(0.0, -30.0))
    );
    assert_eq!(second.on_workpiece().to, Point::new(22.0, -40.0));
    // The rapid after the shift begins where the tool is: at Z-10 of G54, Z20 of G55.
    let ends: Vec<_> = ran.motions.on_workpiece().map(|motion| (motion.from, motion.to)).collect();
    for pair in ends.windows(2) {
        assert!(pair[0].1.is_same(pair[1].0), "{pair:?}");
    }
    let table = csv::csv(&ran.motions, &ran.setup.machine);
    let row = table.lines().find(|row| row.starts_with("10,feed")).expect("a row");
    assert!(row.starts_with("10,feed,T0303,44,-40,") && row.contains(",G55,0,-30,"), "{row}");
}

/// Several parts out of one bar: the same subprogram, 30 mm farther each time. Each part has a groove to 30 mm, 10 mm
/// from its face.
#[test]
fn a_subprogram_in_shifted_coordinates_cuts_several_parts() {
    for (shift, back) in [
        ("G50 W30.", ""),
        ("G10 P0 W-30.", ""),
        ("#5222=#5222-30.", "#5222=0\n"),
        ("#1=#1-30.\nG52 Z#1", "#1=0\n"),
    ] {
        let ran = run(&format!(
            "O0001\n(STOCK D=50 LENGTH=120)\n(TOOL T0303 TYPE=GROOVING WIDTH=3)\n{back}G21 G99 G97 S500 M03 T0303\nG00 X52. Z5.\nM98 P2\n{shift}\nM98 P2\n{shift}\nM98 P2\nG00 X100.\nM30\nO0002\nG00 X52. Z-13.\nG01 X30. F.1\nG00 X52.\nM99\n"
        ));
        for (z, diameter) in
            [(-11.5, 30.0), (-41.5, 30.0), (-71.5, 30.0), (-25.0, 50.0), (-55.0, 50.0), (-101.5, 50.0)]
        {
            assert_eq!(ran.diameter(z), diameter, "{shift} {z}: {:?}", ran.told);
        }
    }
}

/// What is drawn, and where the tool is shown, is on the workpiece.
#[test]
fn strokes_are_on_the_workpiece() {
    let text =
        "G97 S500 M3\nG00 X52 Z5\nG01 X40 Z-10 F0.2\nG52 Z-20\nG01 Z-5\nG02 X50 Z-10 R5\nG00 X60\nM30\n";
    let mut current = Current::new(text.as_bytes().to_vec(), Setup::default());
    while !current.advance(usize::MAX) {}
    let mut shapes = Vec::new();
    current.look(Plane::Section, |_, scene| shapes.extend(scene.strokes().map(|stroke| stroke.shape)));
    let ends: Vec<Point> = shapes.iter().map(StrokeShape::end).collect();
    let expected = [(26.0, 5.0), (20.0, -10.0), (20.0, -25.0), (25.0, -30.0), (30.0, -30.0)];
    assert_eq!(ends, expected.map(|(x, z)| Point::new(x, z)));
    let arc = shapes.iter().find_map(|shape| match shape {
        StrokeShape::Arc(arc) => Some(arc.center),
        _ => None,
    });
    assert_eq!(arc, Some(Point::new(25.0, -25.0)));
}
