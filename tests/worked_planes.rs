//! Functions of a turning centre (seed 002), calculated by hand: tailstock, clamps and stops of the spindle,
//! centre words of arcs, tapping on the axis.
use gcode_playground::analyze;
use gcode_playground::findings;
use gcode_playground::geometry::virtual_plane::Way;
use gcode_playground::machine::SimulationResult;
use gcode_playground::machine::live_holes::live_holes;
use gcode_playground::message::{Levels, Severity};
use gcode_playground::motion::MotionKind;
use gcode_playground::scene::work::{Moment, Work};
use gcode_playground::setup::Setup;
use gcode_playground::setup::notes::Notes;

/// The messages of a program, including collisions: slug and line, counted from 1. Notes have a question
/// mark.
fn said_of(text: &str) -> Vec<String> {
    let analysis = analyze(text.as_bytes(), &Setup::default());
    let setup = Notes::read(text.as_bytes()).applied_to(Setup::default());
    let simulation = SimulationResult::of(&analysis.motions, &setup);
    let levels = Levels::default();
    let machine = findings::diagnostics(&simulation, &analysis.motions, &levels, &analysis.diagnostics);
    let told = analysis.diagnostics.iter().chain(&machine).map(|told| {
        let line = text[..told.span.start as usize].matches('\n').count() + 1;
        let note = if told.severity == Severity::Info { "?" } else { "" };
        format!("{}{note} {line}", told.message.slug())
    });
    told.collect()
}

#[track_caller]
fn says(program: &str, expected: &[&str]) {
    assert_eq!(said_of(program), expected, "{program}");
}

/// A bar with a centre in its face: the cone of 60° begins at Z-2 and is ⌀8 at Z5.
fn with_centre(blocks: &str) -> String {
    format!(
        "O0001 (STOCK D=60 LENGTH=100)\n(TAILSTOCK Z=-2 D=30)\nT0101\nG97 S800 M03\n{blocks}\nM26\nG00 X200 Z200\nM30\n"
    )
}

#[test]
fn the_centre_is_in_the_way_only_while_it_is_forward() {
    says(&with_centre("G00 X40 Z5\nX2"), &["tool-into-tailstock 6"]);
    // Withdrawn before; in the block of the move; before the next move away.
    says(&with_centre("G00 X40 Z5\nM26\nX2"), &[]);
    says(&with_centre("G00 X40 Z5\nX2 M26"), &[]);
    says(&with_centre("G00 X40 Z5\nM26\nX2\nX40\nM25\nX2"), &["tool-into-tailstock 10"]);
    // In a program that advances it, it was withdrawn before.
    says(&with_centre("G00 X2 Z5\nX40\nM25\nX2"), &["tool-into-tailstock 8"]);
    says(&with_centre("G00 X2 Z5\nX40 M25\nX2"), &["tool-into-tailstock 7"]);
    // The tool leaves while the tailstock advances.
    says(&with_centre("G00 X2 Z5\nX40 M25\nX50"), &[]);
    // The interlock neither moves it nor permits a collision.
    says(&with_centre("G00 X40 Z5\nM712\nX2\nM713"), &["tool-into-tailstock 7"]);
    says(&with_centre("G00 X40 Z5\nM26\nM713\nX2"), &[]);
}

#[test]
fn a_subprogram_moves_the_centre_too() {
    let called = "O0001 (STOCK D=60 LENGTH=100)\n(TAILSTOCK Z=-2 D=30)\nT0101\nG97 S800 M03\nG00 X40 Z5\nM98 P2\nX2\n\
                  G00 X200 Z200\nM30\nO0002\nM26\nM99\n";
    says(called, &[]);
}

/// The number of outlines around the work: at the start of each motion, and without playback.
fn outlines(text: &str) -> (Vec<usize>, usize) {
    let analysis = analyze(text.as_bytes(), &Setup::default());
    let setup = Notes::read(text.as_bytes()).applied_to(Setup::default());
    let simulation = SimulationResult::of(&analysis.motions, &setup);
    let count =
        |moment| Work::of(&simulation, &analysis.motions, moment).map_or(0, |work| work.obstacles.len());
    let at = |motion| count(Some(Moment { motion, share: 0.0, tip: analysis.motions.get(motion).from }));
    ((0..analysis.motions.len()).map(at).collect(), count(None))
}

#[test]
fn the_centre_is_drawn_while_it_is_forward() {
    assert_eq!(outlines(&with_centre("G00 X40 Z5\nM26\nX20\nM25\nX40")), (vec![1, 0, 1, 0], 1));
    assert_eq!(outlines(&with_centre("G00 X40 Z5\nM25\nX20\nM26\nX40")), (vec![0, 1, 0, 0], 1));
    // If it never advances, it is not drawn.
    assert_eq!(outlines(&with_centre("M26\nG00 X40 Z5")), (vec![0, 0], 0));
}

/// A part is turned, followed by these blocks.
fn after_turning(blocks: &str) -> String {
    format!(
        "O0001 (STOCK D=50 LENGTH=80)\nG97 S800 M03 T0101\nG00 X46 Z2\nG01 Z-30 F0.2\nX54\nG00 X200 Z200\n{blocks}\nM30\n"
    )
}

#[test]
fn the_chuck_opens_when_the_spindle_stands() {
    says(&after_turning("M11"), &["chuck-opens-while-turning 7"]);
    // Machines with two spindles transfer the part while both rotate.
    says(&after_turning("M69"), &[]);
    says(&after_turning("M05\nM11\nM10"), &[]);
    says(&after_turning("M05\nM69\nM68"), &[]);
    // Both orientations stop the spindle, each at a different angle.
    says(&after_turning("M19\nM11"), &[]);
    says(&after_turning("M20\nM11"), &[]);
    says(&after_turning("M19\nM03\nM11"), &["chuck-opens-while-turning 9"]);
    // Closing it is harmless.
    says(&after_turning("M10"), &[]);
    says(&after_turning("M68"), &[]);
}

#[test]
fn no_thread_is_cut_with_an_oriented_spindle() {
    let thread = "T0303\nG97 S300 M03\nG00 X44 Z8";
    says(&after_turning(&format!("{thread}\nG32 Z-20 F1.5")), &[]);
    says(&after_turning(&format!("{thread}\nM19\nG32 Z-20 F1.5")), &["cut-with-spindle-stopped 11"]);
    says(&after_turning(&format!("{thread}\nM19\nM03\nG32 Z-20 F1.5")), &[]);
    // A keyway is shaped with the spindle held.
    says(&after_turning(&format!("{thread}\nM19\nG98 G01 Z-20 F500")), &[]);
}

#[test]
fn the_spindle_turns_again_once_c_is_released() {
    let indexed = "M05\nM45\nG28 H0\nT0505 M13\nG00 X60 Z-10 C90\nG98 G01 X40 F100\nX60";
    says(&after_turning(&format!("{indexed}\nM46\nG97 S800 M03")), &[]);
    says(&after_turning(&format!("{indexed}\nG97 S800 M03")), &["c-axis-still-connected 14"]);
    // C was connected but never used: M45 has another meaning on this machine.
    says(&after_turning("M05\nM45\nG97 S800 M03"), &[]);
}

/// The head of seed 002's square, with a move on the face under G12.1 from X50 C0.
fn on_the_face(arc: &str) -> String {
    format!(
        "O0001\n(TOOL T0101 CUTTER=10 OFFSETR=10)\nM45\nG28 H0\nG00 T0101\nG97 S100 M13\nG00 X50 Z30\nG98 G01 Z-5 F100\n\
         G12.1\n{arc}\nG13.1\nM46\nM30\n"
    )
}

fn arcs(text: &str) -> usize {
    let analysis = analyze(text.as_bytes(), &Setup::default());
    analysis
        .motions
        .iter()
        .filter(|motion| motion.virtual_move().is_some_and(|own| matches!(own.way, Way::Arc(_))))
        .count()
}

#[test]
fn arcs_on_the_face_have_i_and_j_or_r() {
    // A quarter circle about the centre of the face: from X50 C0 to X0 C25.
    for right in ["G03 X0 C25 I-25 J0", "G03 X0 C25 I-25", "G03 X0 C25 R25"] {
        says(&on_the_face(right), &[]);
        assert_eq!(arcs(&on_the_face(right)), 1, "{right}");
    }
    // K does not belong to an axis of the face: the arc uses I alone.
    says(&on_the_face("G03 X0 C25 I-25 K5"), &["centre-word-outside-plane 10"]);
    assert_eq!(arcs(&on_the_face("G03 X0 C25 I-25 K5")), 1);
    // R applies, and other centre words do not.
    says(&on_the_face("G03 X0 C25 R25 K5"), &["word-without-effect 10"]);
}

#[test]
fn arcs_of_turning_have_i_and_k_or_r() {
    let turned = |arc: &str| {
        format!(
            "O0001 (STOCK D=50 LENGTH=100)\nT0101\nG97 S800 M03\nG00 X40 Z2\nG01 Z-10 F0.2\n{arc}\nG00 X200\nM30\n"
        )
    };
    says(&turned("G02 X50 Z-15 I5 K0"), &[]);
    // J0 has no effect.
    says(&turned("G02 X50 Z-15 I5 J0"), &[]);
    says(&turned("G02 X50 Z-15 I5 J-3"), &["centre-word-outside-plane 6"]);
    // Without K there is no such arc: one message, an error.
    says(&turned("G02 X50 Z-15 I0 J-5"), &["centre-word-outside-plane 6", "not-checked-behind-fault? 7"]);
    says(&turned("G03 X50 Z-15 J-5"), &["centre-word-outside-plane 6"]);
}

fn tapped(blocks: &str) -> String {
    format!(
        "O0001 (STOCK D=40 LENGTH=60)\nT0606 (M12)\nG97 S200 M03\nG00 X0 Z6\n{blocks}\nG00 X200 Z200\nM30\n"
    )
}

#[test]
fn a_tap_on_the_axis_stops_at_the_bottom_and_comes_back_reversed() {
    says(&tapped("G32 Z-20 F1.75\nM05\nM04\nG32 Z6"), &[]);
    says(&tapped("G32 W-26 F1.75\nM05\nM04\nG32 W26 F1.75"), &[]);
    // Left-hand: in with M04, out with M03.
    says(&tapped("M04\nG32 Z-20 F1.75\nM05\nM03\nG32 Z6"), &[]);
    // Not reversed, or pulled out.
    says(&tapped("G32 Z-20 F1.75\nM05\nM03\nG32 Z6"), &["tap-not-reversed 8"]);
    says(&tapped("G32 Z-20 F1.75\nM05\nG00 Z6"), &["tap-not-reversed 7"]);
    // Reversed while it still rotates inwards.
    says(&tapped("G32 Z-20 F1.75\nM04\nG32 Z6"), &["tap-not-stopped? 6"]);
    says(&tapped("G32 Z-20 F1.75\nG04 X1\nM04\nG32 Z6"), &["tap-not-stopped? 7"]);
    // Out with another lead than in.
    says(&tapped("G32 Z-20 F1.75\nM05\nM04\nG32 Z6 F1.5"), &["tap-lead-changed 8"]);
    // Still stopped during the retract.
    says(&tapped("G32 Z-20 F1.75\nM05\nG32 Z6"), &["cut-with-spindle-stopped 7"]);
}

#[test]
fn the_motions_of_a_tap_are_those_that_are_written() {
    let text = tapped("G32 Z-20 F1.75\nM05\nM04\nG32 Z6");
    let analysis = analyze(text.as_bytes(), &Setup::default());
    let motions: Vec<_> = analysis.motions.iter().collect();
    let threads: Vec<_> = motions.iter().filter(|motion| motion.kind == MotionKind::Thread).collect();
    assert_eq!(threads.len(), 2);
    assert!(threads.iter().all(|motion| motion.lead == Some(1.75)));
    assert_eq!((threads[0].to.z, threads[1].to.z), (-20.0, 6.0));
}

/// Holes with live tools in the face at ⌀40 and in the side at Z-30, at several angles of C.
const LIVE_HOLES: &str = "O0001 (STOCK D=60 LENGTH=60)
(TOOL T0202 TYPE=DRILL D=6)
(TOOL T0303 TYPE=DRILL D=8)
(TOOL T0404 TYPE=TAP D=8)
M45
G28 H0
G00 T0202
G97 S1500 M13
G00 X40 Z5 C0
G98 G83 X40 C0 Z-12 R-3 Q4000 F100
C90
G80
G00 X100 Z100
T0303 M13
G00 X66 Z-30 C0
G87 Z-30 C0 X30 R-1 Q3000 F80
C120
G80
G00 X100 Z100
T0404 M13
G97 S200
G00 X66 Z-45 C0
G88 Z-45 C0 X40 R-1 F250
G80
G00 X100 Z100
M46
M30
";

#[test]
fn holes_of_live_drills_take_nothing_off_all_around() {
    says(LIVE_HOLES, &["cross-holes-left-out? 16"]);
    let analysis = analyze(LIVE_HOLES.as_bytes(), &Setup::default());
    let setup = Notes::read(LIVE_HOLES.as_bytes()).applied_to(Setup::default());
    let part = SimulationResult::of(&analysis.motions, &setup).finished().expect("a blank");
    // The bar is unchanged, in front of the holes and at each of them.
    for z in [-5.0, -10.0, -30.0, -45.0] {
        assert_eq!(part.radii(z), [(0.0, 30.0)], "Z{z}");
    }
    // Their entry points and depths, for the picture of the body: two in the face, two in the side, a tapped
    // one.
    let simulation = SimulationResult::of(&analysis.motions, &setup);
    let holes = |until| live_holes(&analysis.motions, simulation.resolved_setup(), &part, until);
    let rows: Vec<_> = holes(None)
        .iter()
        .map(|own| (own.mouth.x, own.mouth.z, own.bottom.x, own.bottom.z, own.c, own.radius))
        .collect();
    let expected = [
        (20.0, 0.0, 20.0, -12.0, 0.0, 3.0),
        (20.0, 0.0, 20.0, -12.0, 90.0, 3.0),
        (30.0, -30.0, 15.0, -30.0, 0.0, 4.0),
        (30.0, -30.0, 15.0, -30.0, 120.0, 4.0),
        (30.0, -45.0, 20.0, -45.0, 0.0, 4.0),
    ];
    assert_eq!(rows, expected);
    assert!(holes(Some((0, 1.0))).is_empty());
    // A drill on the axis still drills.
    let text = "O0001 (STOCK D=60 LENGTH=60)\n(TOOL T0202 TYPE=DRILL D=6)\nT0202\nG97 S800 M03\nG00 X0 Z5\n\
                G99 G83 X0 Z-12 R-3 Q4000 F0.1\nG80\nG00 Z100\nM30\n";
    let analysis = analyze(text.as_bytes(), &Setup::default());
    let setup = Notes::read(text.as_bytes()).applied_to(Setup::default());
    let part = SimulationResult::of(&analysis.motions, &setup).finished().expect("a blank");
    assert_eq!(part.radii(-5.0), [(3.0, 30.0)]);
}
