//! Shifts of the work zero within a program, calculated by hand: the part is in workpiece coordinates,
//! positions are in program coordinates.
use std::collections::BTreeSet;

use gcode_playground::current::Current;
use gcode_playground::export::csv;
use gcode_playground::geometry::Point;
use gcode_playground::machine::SimulationResult;
use gcode_playground::machine::region::Region;
use gcode_playground::motion::Motions;
use gcode_playground::playback::totals::totals;
use gcode_playground::run::Run;
use gcode_playground::scene::{Plane, StrokeShape};
use gcode_playground::setup::Setup;
use gcode_playground::units::Diameter;

struct Ran {
    motions: Motions,
    part: Region,
    setup: Setup,
    /// Slugs and line numbers, counted from 1.
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

/// X40 is turned to Z-30; 40 mm further the bar still has 50 mm, and X42 is inside it.
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
        ("", "#5222=#5222-40.", "G00 X42. Z-20."),
        ("", "#5202=-40.", "G00 X42. Z-20."),
        ("#5222=0\n#5242=-40.\n", "G55", "G00 X42. Z-20."),
        // Two shifts add up, and one is cancelled.
        ("", "G52 Z-10.\nG10 P0 W-30.", "G00 X42. Z-20."),
        ("", "G52 Z-40.\nG52 Z0", "G00 X42. Z-60."),
        // A shift of X: X32 is a diameter of 42 mm on the bar.
        ("", "G52 X10.", "G00 X32. Z-60."),
        // Relative to a zero that was shifted before the first cut.
        ("G52 Z-500.\n", "G52 Z-540.", "G00 X42. Z-20."),
    ] {
        let told = told(before, shift, to);
        assert!(has_crash(&told), "{before}{shift}: {told:?}");
        let line = lines_after(before) + shift.lines().count() + 8;
        assert!(told.contains(&format!("{crash} {line}")), "{before}{shift}: {told:?}");
        let is_said = told.iter().any(|one| one.starts_with("work-zero-unknown"));
        let is_taken = before.is_empty() && ["G10 L2 P1 Z-40.", "#5222=-40."].contains(&shift);
        assert_eq!(is_said, is_taken, "{before}{shift}: {told:?}");
    }
    // Where the bar is turned there is room; G50 X Z is not a shift.
    for (shift, to) in [("G52 Z-40.", "G00 X42. Z20."), ("G50 Z-38.", "G00 Z-20.\nX42.")] {
        assert!(!has_crash(&told("", shift, to)), "{shift}");
    }
    // The position of G56, or the original one of G54, is unknown.
    for (before, shift) in
        [("G10 L2 P1 Z0\n", "G56"), ("G10 L2 P3 Z-40.\n", "G56"), ("G10 L2 P3 W-40.\n", "G56")]
    {
        let unknown = told(before, shift, "G01 X42. Z-20. F.1");
        assert!(unknown.contains("work-zero-unknown 10") && !has_crash(&unknown), "{before}: {unknown:?}");
    }
    // A zero set after the first cut, and not given before, is assumed to be 0, with a message: also while
    // another one is active, and if set by a system variable.
    assert!(told("", "G10 L2 P1 Z-40.", "G00 X42. Z-20.").contains("work-zero-unknown 8"));
    assert!(told("", "#5222=-40.", "G00 X42. Z-20.").contains("work-zero-unknown 8"));
    for zero in ["G10 L2 P1 Z-300.", "#5222=-300."] {
        let told = told("G10 L2 P2 Z-30.\n", &format!("G55\n{zero}"), "G00 X60. Z5.");
        assert!(told.contains("work-zero-unknown 10"), "{zero}: {told:?}");
    }
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
    // The rapid after the shift begins at the current position: Z-10 of G54, Z20 of G55.
    let ends: Vec<_> = ran.motions.on_workpiece().map(|motion| (motion.from, motion.to)).collect();
    for pair in ends.windows(2) {
        assert!(pair[0].1.is_same(pair[1].0), "{pair:?}");
    }
    let table = csv::csv(&ran.motions, &ran.setup.machine);
    let row = table.lines().find(|row| row.starts_with("10,feed")).expect("a row");
    assert!(row.starts_with("10,feed,T0303,44,-40,") && row.contains(",G55,0,-30,"), "{row}");
}

/// Several parts from one bar: the same subprogram, 30 mm farther each time. Each part has a groove to 30 mm,
/// 10 mm from its face.
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

/// Strokes and the displayed tool position are in coordinates of the workpiece.
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

/// Notes that compare a position with the blank do not depend on the coordinates: G52 Z100 moves the zero to
/// Z100 of the workpiece.
#[test]
fn remarks_on_places_go_by_the_workpiece() {
    let tool = "(STOCK D=50 LENGTH=100)\n(TOOL T0101 TYPE=TURNING INSERT=CNMG120408 KR=95)\n";
    let head = "T0101\nG97 S1000 M03\nG00 X52. Z2.\nG90 X48. Z-30. F.2\n";
    let word = |z: f64| format!("Z{z:.3}");
    type Blocks = fn(&dyn Fn(f64) -> String) -> String;
    let cases: [(&str, Blocks); 7] = [
        ("tool-change-near-work", |z| format!("G00 X60. {}\nT0202", z(5.0))),
        ("", |_| "G28 U0 W0\nT0202".to_owned()),
        ("start-far-from-work", |z| format!("G00 X52. {}\nG90 X44. {} F.2", z(60.0), z(-20.0))),
        ("taper-not-extended", |z| format!("G00 X52. {}\nG90 X44. {} R-3. F.2", z(5.0), z(-30.0))),
        ("thread-run-in-short", |z| format!("G97 S300\nG00 X52. {}\nG92 X47. {} F2.", z(1.0), z(-20.0))),
        ("pattern-first-pass-deep", |z| {
            let contour = format!("N10 G00 X30. {}\nG01 {}\nN20 X52.", z(1.0), z(-20.0));
            format!("G00 X54. {}\nG73 U1. W0 R2\nG73 P10 Q20 U0 W0 F.2\n{contour}", z(3.0))
        }),
        ("contour-ends-in-stock", |z| {
            let contour = format!("N10 G00 X30.\nG01 {}\nN20 X40.", z(-20.0));
            format!("G00 X52. {}\nG71 U2. R1.\nG71 P10 Q20 U0 W0 F.2\n{contour}", z(3.0))
        }),
    ];
    for (slug, blocks) in cases {
        let told = |shift: &str, by: f64| {
            let blocks = blocks(&|z| word(z - by));
            run(&format!("{tool}{head}{shift}\n{blocks}\nG00 X100.\nM30\n")).told
        };
        let plain = told("(NO SHIFT)", 0.0);
        assert!(slug.is_empty() || plain.iter().any(|one| one.starts_with(slug)), "{slug}: {plain:?}");
        assert_eq!(told("G52 Z100.", 100.0), plain, "{slug}");
        assert_eq!(told("G10 P0 W-300.", -300.0), plain, "{slug}");
    }
}

/// A cut from Z2 to Z-30, and one to Z-20 of a coordinate system with its zero at Z-40.
#[test]
fn the_box_around_the_cuts_is_on_the_workpiece() {
    let text =
        "T0101\nG97 S800 M03\nG00 X40 Z2\nG01 Z-30 F0.2\nG00 X60\nG52 Z-40\nG00 X44 Z5\nG01 Z-20\nM30\n";
    let ran = run(text);
    let extents = totals(&ran.motions, &ran.setup.machine).1.extents.expect("cuts");
    assert_eq!((extents.min, extents.max), (Point::new(20.0, -60.0), Point::new(22.0, 2.0)));
}

/// Motions before the first cut are also placed on the workpiece: X42 at Z-20 of the second system is 42 mm
/// at Z-60 of a bar of 50 mm.
#[test]
fn motions_before_the_first_cut_are_on_the_workpiece() {
    let program = |zeros: &str, one: &str, other: &str, to: &str| {
        format!(
            "(STOCK D=50 LENGTH=100)\n(TOOL T0101 TYPE=TURNING INSERT=CNMG120408 KR=95)\n{zeros}\nT0101\nG97 S800 M03\n{one}\nG00 X60. Z5.\n{to}\nX60.\n{other}\nG00 Z2.\nG01 X44. F.2\nZ-30.\nG00 X60.\nM30\n"
        )
    };
    for (zeros, one, other, known) in [
        ("G10 L2 P1 Z0 G10 L2 P2 Z-40.", "G55", "G54", true),
        ("#5222=0", "G52 Z-40.", "G52 Z0", true),
        ("#5202=0", "G10 P0 Z-40.", "G10 P0 Z0", true),
        ("(NO ZERO)", "G50 W40.", "G50 W-40.", true),
        ("(NO ZERO)", "G55", "G54", false),
        ("G10 L2 P2 Z-40.", "G55", "G54", false),
    ] {
        let zeros = zeros.replace(" G10", "\nG10");
        let lines = zeros.matches('\n').count();
        let ran = run(&program(&zeros, one, other, "X42. Z-20."));
        let crash = format!("rapid-through-stock {}", lines + 8);
        assert_eq!(ran.told.contains(&crash), known, "{one}: {:?}", ran.told);
        let zero = if known { Point::new(0.0, -40.0) } else { Point::default() };
        for (index, motion) in ran.motions.iter().enumerate() {
            let expected = if index < 3 { (zero, !known) } else { (Point::default(), false) };
            assert_eq!((motion.process.zero, motion.process.other_setup), expected, "{one}: {index}");
        }
        // The same path in the coordinates of the first cut.
        let moved = run(&program(&zeros, "(ONE)", "(OTHER)", "X42. Z-60."));
        assert!(moved.told.contains(&crash), "{:?}", moved.told);
    }
    // G50 X Z names the position of the tip, and moves neither the tip nor the work.
    let named =
        run(&program("(NO ZERO)", "G52 Z-40.", "G52 Z0\nG50 Z100.", "X42. Z20.")
            .replace("G00 Z2.", "G00 Z62."));
    let zeros: Vec<_> = named.motions.iter().map(|motion| motion.process.zero.z).take(4).collect();
    assert_eq!(zeros, [-40.0, -40.0, -40.0, 0.0]);
}
