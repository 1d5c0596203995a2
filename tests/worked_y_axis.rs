//! The planes of seed 002, section 7, on a machine with a Y axis, calculated by hand: arcs of G17 and G19,
//! straight moves along Y, cutter compensation in these planes, and the messages of a lathe without that
//! axis.
use gcode_playground::analyze;
use gcode_playground::api;
use gcode_playground::findings;
use gcode_playground::geometry::virtual_plane::{Flat, Surface, VirtualMove, Way};
use gcode_playground::geometry::{Point, Turn};
use gcode_playground::machine::SimulationResult;
use gcode_playground::machine::region::Region;
use gcode_playground::message::{Levels, Severity};
use gcode_playground::motion::{Motion, MotionKind};
use gcode_playground::run::Analysis;
use gcode_playground::scene::face::Face;
use gcode_playground::sentences::Language;
use gcode_playground::setup::Setup;
use gcode_playground::setup::notes::Notes;

/// A rotating cutter of ⌀10, with C connected and held.
const HEAD: &str = "O0001 (STOCK D=80 LENGTH=60)\n(MACHINE YAXIS=TRUE)\n(TOOL T0101 CUTTER=5 OFFSETR=5)\nM45\nG28 H0\nT0101\nG97 S1000 M13\n\
                    G98 G00 X100 Z5\n";

fn run(text: &str) -> Analysis {
    analyze(text.as_bytes(), &Setup::default())
}

fn milled(blocks: &str) -> String {
    format!("{HEAD}{blocks}\nG18\nM46\nM30\n")
}

/// The messages of a program, including collisions: slug and line of the blocks after the head, counted from
/// 1.
fn said_of(text: &str) -> Vec<String> {
    let analysis = run(text);
    let setup = Notes::read(text.as_bytes()).applied_to(Setup::default());
    let simulation = SimulationResult::of(&analysis.motions, &setup);
    let machine =
        findings::diagnostics(&simulation, &analysis.motions, &Levels::default(), &analysis.diagnostics);
    let head = if text.starts_with(HEAD) { 8 } else { 0 };
    let told = analysis.diagnostics.iter().chain(&machine).map(|told| {
        let line = text[..told.span.start as usize].matches('\n').count() + 1 - head;
        let note = if told.severity == Severity::Info { "?" } else { "" };
        format!("{}{note} {line}", told.message.slug())
    });
    told.collect()
}

#[track_caller]
fn says(text: &str, expected: &[&str]) {
    assert_eq!(said_of(text), expected, "{text}");
}

/// The motions of the blocks after the head.
fn motions(blocks: &str) -> Vec<Motion> {
    let text = milled(blocks);
    let first = HEAD.len() as u32;
    let analysis = run(&text);
    let all = analysis.motions.chunks().iter().flat_map(|chunk| {
        (0..chunk.len()).filter(move |at| chunk.span(*at).start >= first).map(|at| chunk.get(at))
    });
    all.collect()
}

fn moved(motion: &Motion) -> VirtualMove {
    motion.virtual_move().unwrap_or_else(|| panic!("{motion:?}"))
}

/// Start and end as X (a radius), Y and Z.
fn ends(motion: &Motion) -> [[f64; 3]; 2] {
    let own = moved(motion);
    [0.0, 1.0].map(|share| {
        let (at, y) = (own.at(share), own.y_at(share));
        [at.x, y, at.z].map(|value| (1e6 * value).round() / 1e6 + 0.0)
    })
}

fn arc(motion: &Motion) -> gcode_playground::geometry::Arc {
    match moved(motion).way {
        Way::Arc(arc) => arc,
        Way::Line(..) => panic!("a line: {motion:?}"),
    }
}

#[test]
fn g17_arcs_lie_in_x_and_y_seen_from_plus_z() {
    // A quarter circle about the spindle axis, X to the right, Y up: from X40 Y0 counter-clockwise to X0 Y20.
    for right in ["G03 X0 Y20 I-20 J0", "G03 X0 Y20 I-20", "G03 X0 Y20 R20", "G03 U-40 V20 R20"] {
        let blocks = format!("G17\nG01 X40 F100\n{right}");
        let own = motions(&blocks);
        let arc = arc(&own[1]);
        assert_eq!(moved(&own[1]).surface, Surface::Flat(Flat::Xy), "{right}");
        assert_eq!(ends(&own[1]), [[20.0, 0.0, 5.0], [0.0, 20.0, 5.0]], "{right}");
        assert!(arc.center.is_same(Point::default()) && arc.turn == Turn::Counterclockwise, "{right}");
        says(&milled(&blocks), &[]);
    }
    // The opposite direction from the same start, and the opposite direction to the same end.
    assert_eq!(ends(&motions("G17\nG01 X40 F100\nG02 X0 Y-20 R20")[1])[1], [0.0, -20.0, 5.0]);
    let far = arc(&motions("G17\nG01 X40 F100\nG02 X0 Y20 I-20")[1]);
    assert!((far.sweep() + 1.5 * std::f64::consts::PI).abs() < 1e-9);
    // A full circle, and one that also moves down.
    let circle = &motions("G17\nG01 X40 F100\nG03 I-20")[1];
    assert!((circle.length() - 40.0 * std::f64::consts::PI).abs() < 1e-9);
    assert_eq!(ends(&motions("G17\nG01 X40 F100\nG03 X0 Y20 R20 Z-5")[1])[1], [0.0, 20.0, -5.0]);
}

#[test]
fn g19_arcs_lie_in_y_and_z_seen_from_plus_x() {
    // Y to the right, Z up. From Y0 Z-10 about Y0 Z-20: counter-clockwise to the left, clockwise to the
    // right.
    for (block, y) in
        [("G03 Y-10 Z-20 J0 K-10", -10.0), ("G02 Y10 Z-20 K-10", 10.0), ("G02 Y10 Z-20 R10", 10.0)]
    {
        let blocks = format!("G19\nG01 Z-10 F100\n{block}");
        let own = motions(&blocks);
        assert_eq!(moved(&own[1]).surface, Surface::Flat(Flat::Yz), "{block}");
        assert_eq!(ends(&own[1]), [[50.0, 0.0, -10.0], [50.0, y, -20.0]], "{block}");
        assert!(arc(&own[1]).center.is_same(Point::new(-20.0, 0.0)), "{block}");
        says(&milled(&blocks), &[]);
    }
}

#[test]
fn g18_arcs_beside_the_axis_keep_their_y() {
    let own = motions("G01 Y5 F100\nG02 X90 Z10 R5\nG01 Y0");
    assert_eq!(ends(&own[0]), [[50.0, 0.0, 5.0], [50.0, 5.0, 5.0]]);
    assert_eq!(ends(&own[1]), [[50.0, 5.0, 5.0], [45.0, 5.0, 10.0]]);
    assert_eq!(moved(&own[1]).surface, Surface::Flat(Flat::Zx));
    assert_eq!(ends(&own[2])[1], [45.0, 0.0, 10.0]);
}

#[test]
fn straight_moves_go_along_all_three_axes() {
    let own = motions("G00 X60 Y10 Z2\nG01 V-4 W-3 F100\nX30\nG00 Z50 Y0\nX90");
    assert_eq!(ends(&own[0]), [[50.0, 0.0, 5.0], [30.0, 10.0, 2.0]]);
    assert_eq!(own[0].kind, MotionKind::Rapid);
    assert_eq!(ends(&own[1]), [[30.0, 10.0, 2.0], [30.0, 6.0, -1.0]]);
    assert!((own[1].length() - 5.0).abs() < 1e-9);
    assert_eq!(ends(&own[2]), [[30.0, 6.0, -1.0], [15.0, 6.0, -1.0]]);
    assert_eq!(ends(&own[3])[1], [15.0, 0.0, 50.0]);
    // Back in the turning plane.
    assert!(own[4].rotary.is_none() && own[4].to == Point::new(45.0, 50.0));
    // C turns in the same block, and alone while the tool is beside the axis.
    let own = motions("G00 X60 Y10 C90\nC180\nY0");
    assert_eq!(own[0].rotary.map(|own| (own.from, own.to)), Some((0.0, 90.0)));
    assert_eq!(ends(&own[0])[1], [30.0, 10.0, 5.0]);
    assert_eq!(own[1].rotary.map(|own| (own.from, own.to)), Some((90.0, 180.0)));
    assert_eq!(ends(&own[2]), [[30.0, 10.0, 5.0], [30.0, 0.0, 5.0]]);
    // The rows contain Y.
    let rows = motions("G17\nG01 X40 F100\nG03 X0 Y20 I-20")
        .iter()
        .map(|motion| api::motion(motion, 0, &Default::default()))
        .collect::<Vec<_>>();
    assert_eq!((rows[1].to.y, rows[1].to.x.mm(), rows[1].mode), (Some(20.0), 0.0, Some("xy")));
    assert_eq!(rows[1].center.map(|at| (at.x.mm(), at.y)), Some((0.0, Some(0.0))));
}

#[test]
fn a_cutter_is_compensated_in_the_plane_in_force() {
    // A square of 40 mm on the face from outside, clockwise, with a cutter of ⌀10 to the left of the path.
    let blocks = "G17\nG01 Z-5 F100\nG41 X40 Y-30\nY20\nX-40\nY-20\nX60\nG40 X100 Y-20\nG00 Z50";
    let own = motions(blocks);
    let corners: Vec<[f64; 3]> =
        own.iter().filter(|motion| motion.virtual_move().is_some()).map(|motion| ends(motion)[1]).collect();
    // To the left of a path up at X20 (radius 20) is X15: this is a pocket milled from inside.
    assert!(corners.contains(&[15.0, 15.0, -5.0]), "{corners:?}");
    assert!(corners.contains(&[-15.0, 15.0, -5.0]), "{corners:?}");
    assert!(corners.contains(&[-15.0, -15.0, -5.0]), "{corners:?}");
    assert_eq!(corners.last(), Some(&[50.0, -20.0, 50.0]), "{corners:?}");
    // Around the outside with G42, with a rounded corner.
    let own = motions("G17\nG01 Z-5 F100\nG42 X40 Y-30\nY20,R8\nX-40\nG40 X-60 Y40");
    let rounds = own.iter().filter(|motion| matches!(moved_or_none(motion), Some(Way::Arc(_)))).count();
    assert_eq!(rounds, 1, "{own:?}");
    let arc = own.iter().find_map(|motion| match moved_or_none(motion) {
        Some(Way::Arc(arc)) => Some(arc),
        _ => None,
    });
    // Corner X40 Y20 rounded by 8: centre at radius 12 Y12, the path of the cutter centre has a radius of 13.
    let arc = arc.expect("a rounding");
    assert!(arc.center.is_same(Point::new(12.0, 12.0)) && (arc.radius() - 13.0).abs() < 1e-9, "{arc:?}");
    // Moves in the turning plane begin at the position of the cutter centre.
    says(&milled(blocks), &[]);
}

fn moved_or_none(motion: &Motion) -> Option<Way> {
    motion.virtual_move().map(|own| own.way)
}

#[test]
fn faults_of_arcs_are_those_of_turning() {
    let with = |arc: &str| milled(&format!("G17\nG01 X40 F100\n{arc}\nG00 X100"));
    says(&with("G03 X0 Y21 I-20"), &["arc-end-off-circle 3", "not-checked-behind-fault? 4"]);
    says(&with("G03 X0 Y20 I-20 K4"), &["centre-word-outside-plane 3"]);
    let no_centre = run(&with("G03 X0 Y20"));
    let sentences: Vec<String> =
        no_centre.diagnostics.iter().map(|found| found.message.sentence(Language::English).message).collect();
    assert_eq!(sentences, ["G03 has neither R nor I, J."]);
    says(&with("G03 X0 Y20 R5"), &["arc-radius-too-small 3", "not-checked-behind-fault? 4"]);
}

#[test]
fn a_lathe_without_a_y_axis_is_told() {
    let without = |blocks: &str| {
        format!(
            "O0001 (STOCK D=80 LENGTH=60)\nT0101\nG97 S1000 M03\nG00 X84 Z5\n{blocks}\nG00 X200 Z200 Y0\nM30\n"
        )
    };
    says(&without("G01 Y5 F0.2"), &["axis-not-supported 5", "not-checked-behind-fault? 6"]);
    says(&without("G17\nG03 X80 Z3 R5 F0.2"), &["plane-not-supported 6", "not-checked-behind-fault? 7"]);
    says(&without("G28 U0 V0\nG01 Y0 F0.2"), &[]);
    // With a Y axis, turning at Y0 is ordinary turning.
    let turned = |head: &str| {
        format!(
            "O0001 (STOCK D=80 LENGTH=60)\n{head}T0101\nG97 S1000 M03\nG00 X70 Z5 Y0\nG01 Z-30 F0.2\nX84\nG00 X200 Z200\nM30\n"
        )
    };
    let with = turned("(MACHINE YAXIS=TRUE)\n");
    assert!(run(&with).motions.iter().all(|motion| motion.rotary.is_none()));
    says(&with, &[]);
}

#[test]
fn what_is_not_done_beside_the_axis_is_said() {
    // Holes and cycles at a position beside the axis.
    says(
        &milled("G00 X40 Y10\nG83 X40 Z-12 R-3 F100\nG80\nG00 Z50\nY0"),
        &["not-supported 2", "not-checked-behind-fault? 2"],
    );
    says(
        &milled("G83 X40 Y10 Z-12 R-3 F100\nG80\nG00 Z50\nY0"),
        &["not-supported 1", "not-checked-behind-fault? 1"],
    );
    // The same applies to turning cycles and threads.
    for cycle in ["G90 X50 Z-20 F0.2", "G32 Z-20 F1.5", "G94 X50 Z-20 F0.2"] {
        let blocks = format!("G99 G00 X60 Y10\n{cycle}\nG00 Z50\nY0");
        assert!(said_of(&milled(&blocks)).contains(&"not-supported 2".to_owned()), "{cycle}");
    }
    // An arc of G18 with R that moves only along Y: G17 or G19 is missing. The next Y move is correct.
    let blocks = "G01 Y5 F100\nG03 X100 Y-5 R6\nG01 Y5\nX90";
    says(&milled(blocks), &["not-supported 2", "not-checked-behind-fault? 3"]);
    assert_eq!(
        motions(blocks).iter().map(|motion| motion.process.uncertain).collect::<Vec<_>>(),
        [false, true, false]
    );
    // With G12.1, Y is not an axis of the plane.
    says(
        &milled("G01 Z3 F100\nG12.1\nG01 X40 Y3\nG13.1\nG00 X100 Y0"),
        &["not-supported 3", "not-checked-behind-fault? 3"],
    );
}

#[test]
fn home_of_y_is_over_the_axis() {
    let own = motions("G00 X60 Y10\nG28 V0\nG01 X40 F100");
    let last = own.last().expect("motions");
    assert!(last.rotary.is_none(), "{last:?}");
    assert_eq!(ends(&own[1]), [[30.0, 10.0, 5.0], [30.0, 0.0, 5.0]]);
}

#[test]
fn a_slot_along_y_is_taken_off_the_face() {
    let text = milled("G17\nG00 X0 Y50\nZ-5\nG01 Y-50 F100\nG00 Z50\nY0 X100");
    says(&text, &[]);
    let setup = Notes::read(text.as_bytes()).applied_to(Setup::default());
    let analysis = run(&text);
    let simulation = SimulationResult::of(&analysis.motions, &setup);
    let face = Face::of(&analysis.motions, &simulation).expect("a face");
    let work = face.work(&simulation, None).expect("a blank");
    let area = |outlines: &[Vec<Point>]| {
        outlines.iter().map(|outline| Region::inside(outline).area().abs()).sum::<f64>()
    };
    // A slot of 10 mm divides the disc of ⌀80 into two pieces.
    assert_eq!(work.part.len(), 2);
    let slot = 2.0 * (5.0f64 * (1600.0f64 - 25.0).sqrt() + 1600.0 * (5.0f64 / 40.0).asin());
    let taken = area(&work.blank) - area(&work.part);
    assert!((taken - slot).abs() < 2.0, "{taken} {slot}");
    // The part in the section keeps its outline: milled regions are drawn as a frame.
    assert_eq!(simulation.finished().expect("a blank").radii(-3.0), [(0.0, 40.0)]);
    assert!(face.milled(usize::MAX).is_some());
}
