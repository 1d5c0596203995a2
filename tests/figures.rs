//! Annotations: the dimension of a word, the letters of a cycle, the dimensions of a part, and their labels.
//!
//! The expected values are worked out from the programs by hand; X is a diameter in comments and a radius in
//! values.

use std::collections::BTreeSet;
use std::fmt::Write;

use expect_test::expect_file;
use gcode_playground::export::figure::Subject;
use gcode_playground::export::file::caption;
use gcode_playground::figures::{self, Figure};
use gcode_playground::geometry::Point;
use gcode_playground::geometry::bounds::Bounds;
use gcode_playground::machine::SimulationResult;
use gcode_playground::motion::{Cycle, Step};
use gcode_playground::run::Run;
use gcode_playground::scene::Scene;
use gcode_playground::scene::annotation::{Annotation, Detail, Measure, Shape};
use gcode_playground::scene::camera::{Camera, Pixel, Size};
use gcode_playground::scene::face::Face;
use gcode_playground::scene::occupied::{Occupied, Rectangle};
use gcode_playground::scene::path_index::PathIndex;
use gcode_playground::scene::placement::{Placed, place};
use gcode_playground::scene::svg::{Contents, Passes, SvgOptions, camera, section};
use gcode_playground::scene::view::{Frame, View};
use gcode_playground::scene::work::Work;
use gcode_playground::sentences::Language;
use gcode_playground::setup::Setup;
use gcode_playground::source::LineIndex;
use gcode_playground::units::Unit;

use crate::fixtures;

fn run(text: &str, setup: &Setup) -> Run {
    Run::finished(text.as_bytes().to_vec(), setup.clone())
}

/// The labels of the word that begins at `word` in a line, from 1.
fn labels(text: &str, line: u32, word: &str) -> Vec<String> {
    let mut run = run(text, &Setup::default());
    annotations(&mut run, line, word).iter().map(|own| own.label.text(Unit::Millimetre)).collect()
}

fn annotations(run: &mut Run, line: u32, word: &str) -> Vec<Annotation> {
    let lines = LineIndex::new(run.text());
    let span = lines.line(run.text(), line - 1);
    let text = String::from_utf8_lossy(span.of(run.text())).into_owned();
    let column = text.find(word).unwrap_or_else(|| panic!("{word} in {text}"));
    figures::of_word(run, span.start + column as u32)
}

const G71: &str = "N010 G50 X150 Z100\nN020 G00 X41 Z0 M03 S600\nN030 G71 U2 R1\nN040 G71 P50 Q120 U0.5 W0.2 F100\n\
    N050 G01 X0\nN060 G03 X11 W-5.5 R5.5\nN070 G01 W-10\nN080 X17 W-10\nN090 W-15\nN100 G02 X29 W-7.348 R7.5\n\
    N110 G01 W-12.652\nN120 X41\nN130 G70 P50 Q120 F30\nN140 M30\n";

#[test]
fn the_words_of_g71_are_dimensions_of_its_passes() {
    assert_eq!(labels(G71, 3, "U2"), ["Δd = 2"]);
    assert_eq!(labels(G71, 3, "R1"), ["e = 1", "45°"]);
    assert_eq!(labels(G71, 4, "U0.5"), ["Δu/2 = 0.25"]);
    assert_eq!(labels(G71, 4, "W0.2"), ["Δw = 0.2"]);
    // P, Q and F are not lengths.
    assert!(labels(G71, 4, "P50").is_empty() && labels(G71, 4, "F100").is_empty());
    assert_eq!(labels(G71, 6, "R5.5"), ["R5.5"]);
    assert_eq!(labels(G71, 8, "X17"), ["Ø17", "X/2 = 8.5"]);
    assert_eq!(labels(G71, 8, "W-10"), ["W = −10"]);
    // The passes are at Ø37.5 and Ø33.5: 2 mm apart on the radius.
    let mut run = run(G71, &Setup::default());
    let depth = annotations(&mut run, 3, "U2");
    let Shape::Radial([from, to]) = depth[0].shape else { panic!("{depth:?}") };
    assert!((from.x - 18.75).abs() < 1e-6 && (to.x - 16.75).abs() < 1e-6, "{from:?} {to:?}");
}

/// From X62 Z2 to X58 Z-25 with R-10.8: the cut starts at X36.4. arctan(10.8 / 27) = 21.80°.
#[test]
fn the_r_of_a_taper_is_the_step_of_its_start() {
    let program = "G00 X62 Z2\nG90 X58 Z-25 R-10.8 F0.2\nM30\n";
    assert_eq!(labels(program, 2, "R-10.8"), ["R = −10.8", "α/2 = 21.8°"]);
    let mut run = run(program, &Setup::default());
    let own = annotations(&mut run, 2, "R-10.8");
    let Shape::Radial(ends) = own[0].shape else { panic!("{own:?}") };
    assert!((ends[0].x - 18.2).abs() < 1e-9 && (ends[1].x - 29.0).abs() < 1e-9, "{ends:?}");
    // X54 Z5 to X30 Z0 with R-24: the cut starts at Z-24.
    let facing = "G00 X54 Z5 S500 M03\nG94 X30 Z0 R-24 F0.1\nM30\n";
    assert_eq!(labels(facing, 2, "R-24")[0], "R = −24");
}

#[test]
fn the_words_of_a_thread_are_depths() {
    let program =
        "G00 X60 Z10 M03 S300\nG76 P011060 Q0.1 R0.1\nG76 X33.8 Z-60 R0 P2.4 Q0.7 F4\nG00 X100\nM30\n";
    assert_eq!(labels(program, 3, "P2.4"), ["k = 2.4"]);
    assert_eq!(labels(program, 3, "Q0.7"), ["Δd = 0.7"]);
    assert_eq!(labels(program, 3, "F4"), ["F = 4"]);
    // The infeeds 0.7, 0.29, 0.222 … 0.108, 0.086 are not 0.1; the last one, d, is.
    assert!(labels(program, 2, "Q0.1").is_empty());
    assert_eq!(labels(&program.replace("Q0.1 R0.1", "Q0.25 R0.1"), 2, "Q0.25"), ["Δd min = 0.25"]);
    assert_eq!(labels(program, 2, "R0.1"), ["d = 0.1"]);
    assert_eq!(labels(program, 3, "X33.8"), ["Ø33.8", "X/2 = 16.9"]);
    // The crest is at Ø38.6; the first pass is 0.7 below it.
    let mut run = run(program, &Setup::default());
    let own = annotations(&mut run, 3, "Q0.7");
    let Shape::Radial([crest, first]) = own[0].shape else { panic!("{own:?}") };
    assert!((crest.x - 19.3).abs() < 1e-6 && (first.x - 18.6).abs() < 1e-6, "{own:?}");
}

#[test]
fn pecks_and_columns_of_g75_are_lengths() {
    let program = "G50 X60 Z70\nG00 X42 Z22 M03\nG75 R1\nG75 X30 Z10 P3 Q2.9 F30\nG00 X60 Z70\nM30\n";
    assert_eq!(labels(program, 3, "R1"), ["e = 1"]);
    assert_eq!(labels(program, 4, "P3"), ["Δi = 3"]);
    assert_eq!(labels(program, 4, "Q2.9"), ["Δk = 2.9"]);
}

#[test]
fn corners_arcs_and_angles_have_their_sizes() {
    let program = "G00 X20 Z2 M03 S500\nG01 Z-15 ,R3 F0.2\nX40 ,C2\nZ-30\nG02 X50 Z-35 I5 K0\nG01 X70 ,A150\nG00 Z5\nM30\n";
    assert_eq!(labels(program, 2, ",R3"), ["R3"]);
    assert_eq!(labels(program, 3, ",C2"), ["C2"]);
    assert_eq!(labels(program, 5, "I5"), ["I = 5"]);
    assert_eq!(labels(program, 6, ",A150"), ["A = 150°"]);
}

/// Seed 002: at most 1500 rpm is reached at Ø = 1000 v / (π · 1500): 21.2 for 100 m/min, 25.5 for 120, 42.4 for 200.
#[test]
fn a_program_that_only_sets_speeds_is_a_chart() {
    let all = fixtures::all();
    let fixture = all.iter().find(|fixture| fixture.id == "s002-g50-g96").expect("a fixture");
    let mut run = run(&fixture.text, &Setup::from_json(&fixture.setup).expect("a setup"));
    let (chart, annotations) = figures::of_speeds(&mut run).expect("a chart");
    let texts: Vec<String> = annotations.iter().map(|own| own.label.text(Unit::Millimetre)).collect();
    for label in ["v = 100", "v = 120", "v = 200", "Ø21.2", "Ø25.5", "Ø42.4", "S = 1500"] {
        assert!(texts.iter().any(|text| text == label), "{label} is not in {texts:?}");
    }
    // 795.8 rpm at Ø40 and 100 m/min is on the first curve.
    let place = chart.place(40.0, 795.775);
    let near = chart.moves().scene(None).strokes().any(|stroke| {
        let (from, to) = (stroke.shape.start(), stroke.shape.end());
        (from.z..=to.z).contains(&place.z) && (to.x..=from.x).contains(&place.x)
    });
    assert!(near, "{place:?}");
}

/// P is the imaginary tip. With r = 0.2 a taper of 1:5, half angle 5.711°, is 0.2 · (1 + 0.1 − 1.005) = 0.019 mm too
/// thick on the radius.
#[test]
fn the_error_of_a_taper_without_compensation() {
    let program = "(STOCK D=60 LENGTH=80)\n(TOOL T0101 TYPE=TURNING R=0.2 TIP=3)\nT0101\nG97 S800 M03\n\
        G00 X44 Z12\nG42 G01 X44 Z10 F0.2\nX50 Z-20\nZ-40\nG40 X64\nM30\n";
    let run = run(program, &Setup::default());
    let simulation = SimulationResult::of(run.motions(), &run.setup_at_machine());
    let nose = figures::of_nose(&simulation, run.motions()).expect("a nose");
    let Shape::Detail(detail) = nose.shape else { panic!("{nose:?}") };
    let texts: Vec<String> = detail.annotations.iter().map(|own| own.label.text(Unit::Millimetre)).collect();
    assert_eq!(texts, ["P", "C", "r = 0.2", "Δ = 0.019"]);
}

/// The square of seed 002: A(50,0) B(50,25) C(-50,25) D(-50,-25) E(50,-25), seven moves, cutter of 20 mm.
#[test]
fn the_square_of_polar_interpolation_has_its_letters() {
    let all = fixtures::all();
    let fixture = all.iter().find(|fixture| fixture.id == "s002-g121-square").expect("a fixture");
    let run = run(&fixture.text, &Setup::from_json(&fixture.setup).expect("a setup"));
    let simulation = SimulationResult::of(run.motions(), &run.setup_at_machine());
    let face = Face::of(run.motions(), &simulation).expect("a face");
    let own = figures::of_face(face.moves());
    // X is to the right, C upwards.
    let named: Vec<(&str, f64, f64)> = own
        .iter()
        .filter_map(|own| match own.shape {
            Shape::Point(at) => Some((own.label.name, at.z + at.z, at.x)),
            _ => None,
        })
        .collect();
    let expected = [
        ("A", 50.0, 0.0),
        ("B", 50.0, 25.0),
        ("C", -50.0, 25.0),
        ("D", -50.0, -25.0),
        ("E", 50.0, -25.0),
        ("O", 0.0, 0.0),
    ];
    assert_points(&named, &expected);
    let steps = own.iter().filter(|own| matches!(own.shape, Shape::Step(_))).count();
    let sizes: Vec<f64> =
        own.iter().filter(|own| matches!(own.shape, Shape::Axial(_) | Shape::Radial(_))).map(shown).collect();
    assert_eq!((steps, sizes), (7, vec![50.0, 50.0]));
    // The last move leaves on the line of the first, from X70 to X100: its number is between X80, the start, and X100.
    let out = own.iter().find(|own| own.label.name == "⑦").expect("a step");
    let Shape::Step([from, to]) = out.shape else { panic!("{out:?}") };
    assert!((from.z - 40.0).abs() < 1e-6 && (to.z - 50.0).abs() < 1e-6, "{out:?}");
}

/// The figure of the cycle that a line calls, from 1, with its finished run.
fn figure(text: &str, setup: &str, line: u32) -> (Run, Figure) {
    let mut run = run(text, &Setup::from_json(setup).expect("a setup"));
    let lines = LineIndex::new(run.text());
    let start = lines.line(run.text(), line - 1).start;
    let figure = figures::of_cycle(&mut run, start);
    (run, figure)
}

/// The labels with a value of the figure of a cycle.
fn values(text: &str, setup: &str, line: u32) -> Vec<String> {
    let (_, figure) = figure(text, setup, line);
    let with_value = figure.annotations.iter().filter(|own| own.label.value.is_some());
    with_value.map(|own| own.label.text(Unit::Millimetre)).collect()
}

#[track_caller]
fn assert_has(found: &[String], expected: &[&str]) {
    let missing: Vec<_> = expected.iter().filter(|text| !found.iter().any(|own| own == *text)).collect();
    assert!(missing.is_empty(), "{missing:?} is not in {found:?}");
}

/// The numbered steps of the figure of a cycle with their ends, X as diameters.
fn steps(text: &str, line: u32) -> Vec<(&'static str, [(f64, f64); 2])> {
    let (_, figure) = figure(text, "{}", line);
    let mut found: Vec<(&'static str, [(f64, f64); 2])> = Vec::new();
    for own in with_details(&figure) {
        // A detail may repeat a number. The numbers of passes of G73 are no steps.
        let is_number = own.label.name.chars().all(|sign| ('①'..='⑳').contains(&sign));
        if let Shape::Step(ends) = own.shape
            && is_number
            && found.iter().all(|(name, _)| *name != own.label.name)
        {
            found.push((own.label.name, ends.map(|at| (at.x + at.x, at.z))));
        }
    }
    found.sort_by_key(|(name, _)| *name);
    found
}

/// The annotations of a figure and of its details.
fn with_details(figure: &Figure) -> Vec<&Annotation> {
    let inside = figure.annotations.iter().flat_map(|own| match &own.shape {
        Shape::Detail(detail) => &detail.annotations[..],
        _ => &[],
    });
    figure.annotations.iter().chain(inside).collect()
}

#[track_caller]
fn assert_steps(found: &[(&'static str, [(f64, f64); 2])], expected: &[(&'static str, [(f64, f64); 2])]) {
    let is_same = |a: (f64, f64), b: (f64, f64)| (a.0 - b.0).abs().max((a.1 - b.1).abs()) < 1e-3;
    let same = found.len() == expected.len()
        && found.iter().zip(expected).all(|(own, wanted)| {
            own.0 == wanted.0 && is_same(own.1[0], wanted.1[0]) && is_same(own.1[1], wanted.1[1])
        });
    assert!(same, "{found:?}, not {expected:?}");
}

/// The steps of `www/manual`. ③ to ⑤ belong to the fifth of ten passes: at X21 the arc around X32 Z-40.5 with R7.5
/// is at Z-40.5 - √(7.5² - 5.5²) = -45.599. ⑥ is the longest straight piece of the contour, from Z-25.5 to Z-40.5 at
/// X17. All are shifted by the allowance.
#[test]
fn the_steps_of_g71_are_those_of_the_manual() {
    assert_steps(
        &steps(G71, 4),
        &[
            ("①", [(41.0, 0.0), (41.5, 0.2)]),
            ("②", [(41.5, 0.2), (37.5, 0.2)]),
            ("③", [(21.5, 0.2), (21.5, -45.399)]),
            ("④", [(21.5, -45.399), (23.5, -44.399)]),
            ("⑤", [(23.5, -44.399), (23.5, 0.2)]),
            ("⑥", [(17.5, -25.3), (17.5, -40.3)]),
            ("⑦", [(41.5, -60.3), (41.0, 0.0)]),
        ],
    );
}

fn fixture(id: &str) -> String {
    fixtures::all().into_iter().find(|fixture| fixture.id == id).expect("a fixture").text
}

/// C is 18.25 and 5.5 from A, and each further start is 2 and 5/9 nearer. The longest straight piece is the cone. D, the
/// start of the last pass, is only the allowance from A.
#[test]
fn the_steps_and_letters_of_g73_are_those_of_the_manual() {
    let program = fixture("s003-g73");
    assert_steps(
        &steps(&program, 4),
        &[
            ("①", [(50.0, 10.0), (86.5, 15.5)]),
            ("②", [(86.5, 15.5), (36.5, 6.5)]),
            ("③", [(48.5, -9.5), (56.5, -24.5)]),
            ("④", [(70.5, -44.5), (82.5, 14.9444)]),
            ("⑤", [(34.5, -49.5), (50.0, 10.0)]),
        ],
    );
    assert_points(
        &points(&program, 4),
        &[("A", 50.0, 10.0), ("A′", 0.0, 1.0), ("B", 34.0, -50.0), ("C", 86.5, 15.5), ("D", 50.5, 10.5)],
    );
}

/// Seed 003: of G75, X is that of C and Z that of B; of G74, X is that of B and Z that of C.
#[test]
fn the_steps_and_letters_of_pecks_are_those_of_the_manual() {
    let program = fixture("s003-g75");
    assert_steps(
        &steps(&program, 4),
        &[
            ("①", [(42.0, 22.0), (36.0, 22.0)]),
            ("②", [(36.0, 22.0), (38.0, 22.0)]),
            ("④", [(30.0, 22.0), (42.0, 22.0)]),
            ("⑤", [(42.0, 22.0), (42.0, 19.1)]),
            ("⑥", [(42.0, 10.0), (42.0, 22.0)]),
        ],
    );
    assert_points(
        &points(&program, 4),
        &[("A", 42.0, 22.0), ("B", 42.0, 10.0), ("C", 30.0, 22.0), ("D", 30.0, 10.0)],
    );
    let face = "G00 X20 Z2 M03 S500\nG74 R1\nG74 X10 Z-12 P2000 Q5000 R0.3 F0.1\nM30\n";
    assert_points(
        &points(face, 3),
        &[("A", 20.0, 2.0), ("B", 10.0, 2.0), ("C", 20.0, -12.0), ("D", 10.0, -12.0)],
    );
    // From X20 to the bottom, aside by 0.3 away from the next column, back to Z2.
    let relief = steps(face, 3);
    assert_steps(
        &relief[2..4],
        &[("③", [(20.0, -12.0), (20.6, -12.0)]), ("④", [(20.6, -12.0), (20.6, 2.0)])],
    );
}

/// Pass 1 is at X37.2 and starts at 10 − 0.7 · tan 30° = 9.596, pass 12 at X33.8 and 10 − 2.4 · tan 30° = 8.614. The
/// pull-out is one lead, 4 mm. U/2 = (33.8 − 60)/2, W = −60 − 10.
#[test]
fn the_circuit_of_g76_is_that_of_the_first_and_the_last_pass() {
    let program = fixture("s003-g76");
    assert_steps(
        &steps(&program, 3),
        &[
            ("①", [(60.0, 10.0), (37.2, 9.5959)]),
            ("②", [(37.2, 9.5959), (37.2, -56.0)]),
            ("③", [(37.2, -56.0), (45.2, -60.0)]),
            ("④", [(45.2, -60.0), (60.0, -60.0)]),
            ("⑤", [(60.0, -60.0), (60.0, 10.0)]),
        ],
    );
    assert_has(&values(&program, "{}", 3), &["U/2 = −13.1", "W = −70"]);
    let (run, figure) = figure(&program, "{}", 3);
    // Twelve passes of five motions after the rapid to the start.
    let shown = figure.motions(run.motions());
    assert_eq!(shown, [1..6, 56..61]);
}

/// 0.7 · √2 = 0.99; the tenth pass, 0.7 · √10 = 2.214, is the last before 2.4 − 0.1.
#[test]
fn the_depths_of_g76_have_the_numbers_of_their_passes() {
    let (_, figure) = figure(&fixture("s003-g76"), "{}", 3);
    let details = figure.annotations.iter().filter_map(|own| match &own.shape {
        Shape::Detail(detail) => Some(detail),
        _ => None,
    });
    let texts: Vec<String> =
        details.flat_map(|detail| &detail.annotations).map(|own| own.label.text(Unit::Millimetre)).collect();
    let expected = ["k = 2.4", "Δd = 0.7", "Δd√2 = 0.99", "Δd√10 = 2.214", "d = 0.1", "a = 60°", "a/2 = 30°"];
    assert_eq!(texts, expected);
}

/// A thread at its programmed end: taper R-1 from X60 Z10 to X33.8 Z-60, with a pull-out of 4 mm. D is at X33.8.
#[test]
fn d_of_a_taper_thread_is_its_programmed_end() {
    let program = "G00 X60 Z10 M03 S200\nG76 P011060 Q100 R0.1\nG76 X33.8 Z-60 R-1 P2400 Q700 F4\nM30\n";
    let found = points(program, 3);
    let d = found.iter().find(|own| own.0 == "D").expect("D");
    assert!((d.1 - 33.8).abs() < 1e-6 && (d.2 + 60.0).abs() < 1e-6, "{found:?}");
}

/// At 500 rpm and lead 2, δ2 = 500 · 2 / 1800 = 0.556 and δ1 = 3.605 · δ2 = 2.003 (seed 001). A pull-out of one lead is
/// in place of the run-out.
#[test]
fn a_thread_has_its_run_in_run_out_and_pull_out() {
    let program = "G97 S500 M03\nG00 X35 Z4\nG92 X29.2 Z-26 F2\nM30\n";
    let chamfer = |tenths: u32| format!(r#"{{"dialect": {{"threadChamfer": {tenths}}}}}"#);
    let plain = values(program, &chamfer(0), 3);
    assert_has(&plain, &["δ1 ≥ 2", "δ2 ≥ 0.56"]);
    assert!(!plain.iter().any(|text| text.starts_with('r')), "{plain:?}");
    let with_pull_out = values(program, &chamfer(10), 3);
    assert_has(&with_pull_out, &["δ1 ≥ 2", "r = 2"]);
    assert!(!with_pull_out.iter().any(|text| text.starts_with("δ2")), "{with_pull_out:?}");
    // Under G96 the speed is not known.
    let surface = values(&program.replace("G97 S500", "G96 S100"), &chamfer(0), 3);
    assert!(!surface.iter().any(|text| text.starts_with('δ')), "{surface:?}");
}

/// G94 from X54 to X30 over 24 mm of Z is at Z-20 on Ø50; G90 from X36.4 at Z2 to X58 at Z-25 is 36.4 + 21.6 · 2/27 = 38
/// at the face.
#[test]
fn a_taper_has_its_size_at_the_blank() {
    let facing = "(STOCK D=50 LENGTH=60)\nG00 X54 Z5 S500 M03\nG94 X30 Z0 R-24 F0.1\nM30\n";
    assert_points(
        &points(facing, 3),
        &[
            ("A", 54.0, 5.0),
            ("B", 54.0, -24.0),
            ("E", 30.0, 0.0),
            ("F", 30.0, 5.0),
            ("C", 50.0, -20.0),
            ("G", 54.0, -20.0),
        ],
    );
    let found = values(facing, "{}", 3);
    assert_has(&found, &["Ø30", "Ø50", "20", "16.667", "R−20", "R = −24"]);
    // The block has Z0.
    assert!(!found.iter().any(|text| text.starts_with('Z')), "{found:?}");
    let turning = "(STOCK D=60 LENGTH=60)\nG00 X62 Z2\nG90 X58 Z-25 R-10.8 F0.2\nM30\n";
    assert_has(&values(turning, "{}", 3), &["Ø58", "Ø38", "R = −10.8", "10", "25"]);
}

/// Seed 004: R-20 from X54 is at Ø50 at Z-20 · 20/24 = Z-16.667; the material that it leaves is between this point, C and E.
#[test]
fn the_figure_of_g94_hatches_what_a_smaller_r_leaves() {
    let (_, figure) =
        figure("(STOCK D=50 LENGTH=60)\nG00 X54 Z5 S500 M03\nG94 X30 Z0 R-24 F0.1\nM30\n", "{}", 3);
    let zone = figure.annotations.iter().find_map(|own| match &own.shape {
        Shape::Zone { outline, way, .. } => Some((outline.clone(), *way)),
        _ => None,
    });
    let (outline, way) = zone.expect("a zone");
    let is_same = |found: &[Point], expected: &[(f64, f64)]| {
        let pairs = found.iter().zip(expected);
        found.len() == expected.len()
            && pairs.into_iter().all(|(own, (x, z))| own.distance(Point::new(x / 2.0, *z)) < 1e-3)
    };
    assert!(is_same(&outline, &[(50.0, -20.0), (30.0, 0.0), (50.0, -16.6667)]), "{outline:?}");
    assert!(is_same(&way, &[(54.0, -20.0), (30.0, 0.0)]), "{way:?}");
}

/// Passes at X45, X40 and X35: the drawing has Ø35, the words of the block belong to its pass. The last taper from
/// X18.4 at Z2 to X40 at Z-25 is at Ø20 at the face: 10 over 25.
#[test]
fn the_diameter_of_a_single_cycle_is_the_finished_one() {
    let straight =
        "(STOCK D=50 LENGTH=60)\nG00 X55 Z2 M03 S500\nG90 X45 Z-25 F0.2\nX40\nX35\nG00 X100\nM30\n";
    let found = values(straight, "{}", 3);
    assert_has(&found, &["Ø35", "X/2 = 22.5", "U/2 = −5"]);
    assert!(!found.iter().any(|text| text == "Ø45"), "{found:?}");
    let taper = "(STOCK D=60 LENGTH=60)\nG00 X62 Z2\nG90 X58 Z-25 R-10.8 F0.2\nX50\nX40\nM30\n";
    assert_has(&values(taper, "{}", 3), &["Ø40", "Ø20", "10", "25"]);
}

/// The passes of G73 lie on nearly one line before the contour: the figure has the infeed of the first and of the last
/// pass, and the contour of each.
#[test]
fn the_figure_of_g73_has_two_infeeds() {
    let (run, figure) = figure(&fixture("s003-g73"), "{}", 4);
    let shown = figure.motions(run.motions());
    let of_step = |wanted: Step| {
        let own = shown.iter().flat_map(Clone::clone).filter_map(|index| run.motions().get(index).cycle);
        let own = own.filter(|own| own.step == wanted && own.cycle == Cycle::Pattern);
        own.map(|own| own.pass).collect::<BTreeSet<u32>>()
    };
    assert_eq!(of_step(Step::Infeed), BTreeSet::from([1, 10]));
    assert_eq!(of_step(Step::Contour), (1..=10).collect());
}

/// The details of the figure of a cycle.
fn details(text: &str, line: u32) -> Vec<Detail> {
    let (_, figure) = figure(text, "{}", line);
    let details = figure.annotations.into_iter().filter_map(|own| match own.shape {
        Shape::Detail(detail) => Some(*detail),
        _ => None,
    });
    details.collect()
}

/// The corner of G71 is X29 Z-60.5 finished and X29.5 Z-60.3 roughed. That of G72, between its cone and its land, is X20
/// Z-20 finished and X20.1 Z-19.8 roughed: there is no corner between two axes.
#[test]
fn the_detail_of_the_allowance_is_at_a_corner_or_at_a_land() {
    for (program, finished, allowance) in [
        (G71.to_owned(), Point::new(14.5, -60.5), Point::new(0.25, 0.2)),
        (fixture("s003-g72"), Point::new(10.0, -20.0), Point::new(0.05, 0.2)),
    ] {
        let all = details(&program, 4);
        let [detail, _] = &all[..] else { panic!("{all:?}") };
        assert!(detail.edges[0][1].is_same(finished), "{detail:?}");
        assert!(detail.edges[1][1].is_same(finished.moved(allowance)), "{detail:?}");
        // The part is on the other side of its edge.
        let is_inside = |at: &Point| at.x <= finished.x + 1.0 && at.z <= finished.z + 1.0;
        assert!(detail.part[0].len() == 6 && detail.part[0].iter().all(is_inside), "{detail:?}");
        let texts: Vec<String> =
            detail.annotations.iter().map(|own| own.label.text(Unit::Millimetre)).collect();
        let expected = [format!("Δu/2 = {}", allowance.x), format!("Δw = {}", allowance.z)];
        assert_eq!(texts, [&expected[0], &expected[1], "⑥", "A′–B"]);
        let lengths = detail.annotations.iter().map(|own| match own.shape {
            Shape::Axial([a, b]) => (a.z - b.z).abs(),
            Shape::Radial([a, b]) => (a.x - b.x).abs(),
            _ => f64::NAN,
        });
        let expected = [allowance.x, allowance.z];
        assert!(lengths.zip(expected).all(|(own, wanted)| (own - wanted).abs() < 1e-6), "{detail:?}");
    }
}

/// C of G71 is 0.32 mm from A, D of G73 is 0.56 mm: each has a separate detail, with the move between them.
#[test]
fn a_point_near_the_start_is_in_a_detail() {
    for (program, expected) in [
        (G71.to_owned(), vec!["A", "C", "Δu/2 = 0.25", "Δw = 0.2", "①"]),
        (fixture("s003-g73"), vec!["A", "D", "Δu/2 = 0.25", "Δw = 0.5"]),
    ] {
        let all = details(&program, 4);
        let detail = all.last().expect("a detail");
        let texts: Vec<String> =
            detail.annotations.iter().map(|own| own.label.text(Unit::Millimetre)).collect();
        assert_eq!(texts, expected);
    }
}

/// The detail of G76 is around a groove, between the face at Z0 and the end at Z-60.
#[test]
fn the_detail_of_a_thread_is_at_its_grooves() {
    let all = details(&fixture("s003-g76"), 3);
    let [detail] = &all[..] else { panic!("{all:?}") };
    let (low, high) = (detail.at.z - detail.radius, detail.at.z + detail.radius);
    assert!(-60.0 < low && high < 0.0, "{low} to {high}");
}

/// The named points of the figure of a cycle, as diameters.
fn points(text: &str, line: u32) -> Vec<(&'static str, f64, f64)> {
    let (_, figure) = figure(text, "{}", line);
    let mut named: Vec<(&'static str, f64, f64)> = Vec::new();
    for own in with_details(&figure) {
        if let Shape::Point(at) = own.shape
            && own.label.name != "O"
            && named.iter().all(|(name, ..)| *name != own.label.name)
        {
            named.push((own.label.name, at.x + at.x, at.z));
        }
    }
    named
}

#[track_caller]
fn assert_points(found: &[(&'static str, f64, f64)], expected: &[(&'static str, f64, f64)]) {
    assert_eq!(found.len(), expected.len(), "{found:?}");
    for (own, wanted) in found.iter().zip(expected) {
        let off = (own.1 - wanted.1).abs().max((own.2 - wanted.2).abs());
        assert!(own.0 == wanted.0 && off < 1e-6, "{found:?}, not {expected:?}");
    }
}

#[test]
fn the_letters_of_a_cycle_are_where_the_manuals_have_them() {
    let straight = "G00 X32 Z2 M03 S400\nG90 X26 Z-30 F0.1\nM30\n";
    assert_points(
        &points(straight, 2),
        &[("A", 32.0, 2.0), ("B", 26.0, 2.0), ("C", 26.0, -30.0), ("D", 32.0, -30.0)],
    );
    let taper = "G00 X62 Z2\nG90 X58 Z-25 R-10.8 F0.2\nM30\n";
    assert_points(
        &points(taper, 2),
        &[("A", 62.0, 2.0), ("B", 36.4, 2.0), ("C", 58.0, -25.0), ("D", 62.0, -25.0)],
    );
    // The four signs of U, W and R (seed 001, fig. 3-57).
    for (words, b, c) in [
        ("U20 W-30 R5", (90.0, 0.0), (80.0, -30.0)),
        ("U-20 W-30 R-5", (30.0, 0.0), (40.0, -30.0)),
        ("U20 W30 R-5", (70.0, 0.0), (80.0, 30.0)),
        ("U-20 W30 R5", (50.0, 0.0), (40.0, 30.0)),
    ] {
        let program = format!("G00 X60 Z0 M03 S500\nG90 {words} F0.2\nM30\n");
        let found = points(&program, 2);
        assert_points(&found[..3], &[("A", 60.0, 0.0), ("B", b.0, b.1), ("C", c.0, c.1)]);
    }
    // C of G71 is Δu/2 and Δw from A.
    assert_points(
        &points(G71, 4),
        &[("A", 41.0, 0.0), ("A′ = O", 0.0, 0.0), ("B", 41.0, -60.5), ("C", 41.5, 0.2)],
    );
}

/// Ten passes of G73 from Ø36 more and 5 mm to the right (seed 003, example 3): nine steps of U18 on the radius.
#[test]
fn the_words_of_g73_are_its_relief_and_its_allowance() {
    let all = fixtures::all();
    let program = &all.iter().find(|fixture| fixture.id == "s003-g73").expect("a fixture").text;
    assert_eq!(labels(program, 3, "U18"), ["Δi = 18"]);
    assert_eq!(labels(program, 3, "W5"), ["Δk = 5"]);
    assert_eq!(labels(program, 3, "R10"), ["d = 10"]);
    assert_eq!(labels(program, 4, "U0.5"), ["Δu/2 = 0.25"]);
    assert_eq!(labels(program, 4, "W0.5"), ["Δw = 0.5"]);
    let mut run = run(program, &Setup::default());
    let relief = annotations(&mut run, 3, "U18");
    let Shape::Radial([first, last]) = relief[0].shape else { panic!("{relief:?}") };
    assert!((first.x - last.x - 18.0).abs() < 1e-6, "{relief:?}");
}

/// A stepped shaft, Ø30 to Z-20 with C2 at its end, a cone to Ø40 at Z-40, Ø40 to Z-60.
#[test]
fn the_part_has_each_size_once() {
    let program = "(STOCK D=50 LENGTH=80)\n(TOOL T0101 TYPE=TURNING NOSE=0)\nT0101 M03 S500\nG00 X22 Z2\n\
        G01 X26 Z0 F0.2\nX30 Z-2\nZ-20\nX40 Z-40\nZ-60\nX52\nG00 Z5\nM30\n";
    let mut texts = part_labels(program);
    texts.sort();
    let mut expected = ["C2", "Ø30", "1:2", "Ø40", "Ø50", "20", "40", "60", "80"].map(str::to_owned).to_vec();
    expected.sort();
    assert_eq!(texts, expected);
}

/// A shaft with random steps, cones, chamfers and arcs. Returns the program and its corners (Ø, Z).
fn random_shaft(random: &mut Random) -> (String, Vec<(f64, f64)>) {
    let mut program =
        "(STOCK D=100 LENGTH=150)\n(TOOL T0101 TYPE=TURNING NOSE=0)\nT0101 M03 S500\nG00 X102 Z2\n\
        G71 U3 R1\nG71 P10 Q20 U0.5 W0.1 F0.2\n"
            .to_owned();
    let (mut x, mut z) = (10.0 + 2.0 * random.below(5), 0.0);
    let _ = writeln!(program, "N10 G00 X{x}\nG01 Z0 F0.2");
    let mut corners = vec![(x, z)];
    // No shoulder at first: it would be a part of the face.
    let mut kind = 1.0;
    for _ in 0..3 + random.below(4) as usize {
        // Two edges on one line would be one.
        let next = random.below(5);
        kind = if next == kind { (next + 1.0) % 5.0 } else { next };
        let size = 1.0 + random.below(4);
        let block = match kind as u8 {
            0 => {
                z -= 5.0 + 0.5 * random.below(20);
                format!("G01 Z{z}")
            }
            1 => {
                x += 2.0 * size;
                format!("G01 X{x}")
            }
            2 => {
                (x, z) = (x + 2.0 * size, z - 3.0 * size - 6.0);
                format!("G01 X{x} Z{z}")
            }
            3 => {
                (x, z) = (x + 2.0 * size, z - size);
                format!("G01 X{x} Z{z}")
            }
            _ => {
                (x, z) = (x + 4.0 * size, z - 2.0 * size);
                format!("G03 X{x} Z{z} R{}", 2.0 * size)
            }
        };
        program += &(block + "\n");
        corners.push((x, z));
    }
    if kind == 1.0 {
        // Otherwise the last shoulder would be a part of that of the blank.
        z -= 5.0;
        let _ = writeln!(program, "G01 Z{z}");
        corners.push((x, z));
    }
    program += "N20 G01 X102\nG70 P10 Q20\nG00 Z5\nM30\n";
    (program, corners)
}

/// Linear congruential, after Knuth.
struct Random(u64);

impl Random {
    /// A whole number below `end`.
    fn below(&mut self, end: u64) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((self.0 >> 33) % end) as f64
    }
}

/// The number that a label shows.
fn shown(annotation: &Annotation) -> f64 {
    let text = annotation.label.text(Unit::Millimetre);
    text.trim_start_matches(|letter: char| !letter.is_ascii_digit())
        .trim_end_matches('°')
        .parse()
        .unwrap_or(0.0)
}

/// The corners of 100 random shafts follow from the shown dimensions alone, and no dimension is given twice.
#[test]
fn the_part_can_be_rebuilt_from_its_dimensions() {
    let mut random = Random(1);
    for _ in 0..100 {
        let (program, corners) = random_shaft(&mut random);
        let run = run(&program, &Setup::default());
        let annotations = part_annotations(&run);
        let is_same = |a: f64, b: f64| (a - b).abs() < 0.006;
        let (mut diameters, mut lengths, mut legs) = (Vec::new(), vec![0.0], Vec::new());
        for own in &annotations {
            let value = shown(own);
            match own.shape {
                Shape::Diameter(_) | Shape::DiameterThrough(_) => diameters.push(value),
                Shape::Axial(_) => {
                    assert!(!lengths.iter().any(|&other| is_same(other, value)), "{value} twice\n{program}");
                    lengths.push(value);
                }
                Shape::Note(at) if own.label.text(Unit::Millimetre).starts_with('C') => {
                    legs.push((at, value))
                }
                _ => {}
            }
        }
        for &(x, z) in &corners {
            // The middle of a chamfer is half a leg from its ends.
            let by_chamfer = |at: &(Point, f64)| {
                let (point, leg) = *at;
                is_same((point.x - x / 2.0).abs(), leg / 2.0) && is_same((point.z - z).abs(), leg / 2.0)
            };
            let has_chamfer = legs.iter().any(by_chamfer);
            let has_x = diameters.iter().any(|&value| is_same(value, x)) || has_chamfer;
            let has_z = lengths.iter().any(|&value| is_same(value, -z)) || has_chamfer;
            let texts: Vec<_> = annotations.iter().map(|own| own.label.text(Unit::Millimetre)).collect();
            assert!(has_x && has_z, "Ø{x} Z{z} is not in {texts:?}\n{program}");
        }
    }
}

fn part_labels(program: &str) -> Vec<String> {
    let run = run(program, &Setup::default());
    part_annotations(&run).iter().map(|own| own.label.text(Unit::Millimetre)).collect()
}

fn part_annotations(run: &Run) -> Vec<Annotation> {
    let simulation = SimulationResult::of(run.motions(), &run.setup_at_machine());
    figures::of_finished(&simulation, run.motions())
}

/// The figures of cycles on paper, 80 mm and 160 mm wide. `UPDATE_EXPECT=1 cargo test --test it figures::` writes
/// them again; look at each changed one before you commit it.
#[test]
fn figures_on_paper_are_the_committed_ones() {
    let all = fixtures::all();
    for (name, id) in [
        ("g90", "s001-frag-g90-cyl"),
        ("g90-taper", "s001-frag-g90-taper"),
        ("g94", "s004-g94-right"),
        ("g71", "s003-g71"),
        ("g72", "s003-g72"),
        ("g73", "hand-14-g73-forging"),
        ("g74", "s003-g74"),
        ("g75", "s003-g75"),
        ("g76", "s003-g76"),
    ] {
        let fixture = all.iter().find(|fixture| fixture.id == id).expect("a fixture");
        assert_on_paper(name, run(&fixture.text, &Setup::from_json(&fixture.setup).expect("a setup")));
    }
    // A finished M30×2 with a pull-out.
    let thread = std::fs::read_to_string("www/manual/examples/g92.nc").expect("the example of the manual");
    assert_on_paper("g92", run(&thread, &Setup::default()));
}

/// Holds the figure of the first cycle of a program against the committed one.
fn assert_on_paper(name: &str, mut run: Run) {
    let simulation = SimulationResult::of(run.motions(), &run.setup_at_machine());
    let first = figures::first_cycle(&run).expect("a cycle");
    let figure = figures::of_cycle(&mut run, first);
    let motions = figure.motions(run.motions());
    let mut annotations = figure.annotations;
    annotations.extend(figures::of_tool(&simulation, run.motions(), &motions));
    let options = SvgOptions {
        annotations,
        motions: Some(motions),
        caption: Some(caption(String::new(), Language::English)),
        passes: Passes::Apart,
        ..SvgOptions::default()
    };
    for width in [80, 160] {
        let options = options.clone().on_paper(f64::from(width));
        let picture = section(run.motions(), Some(&simulation), &options);
        expect_file![format!("figures/{name}-{width}.svg")].assert_eq(&picture);
    }
}

/// U/2 and W lead to the programmed end of a thread, not to the start of its pull-out: from X32 Z5 to X29 Z-20.
#[test]
fn the_distances_of_a_thread_include_its_pull_out() {
    let setup = Setup::from_json(r#"{"dialect": {"control": "gsk"}}"#).expect("a setup");
    let mut run = run("G00 X32 Z5 M03 S300\nG92 X29 Z-20 F2 J2 K3\nM30\n", &setup);
    let figure = figures::of_cycle(&mut run, 20);
    let texts: Vec<String> = figure.annotations.iter().map(|own| own.label.text(Unit::Millimetre)).collect();
    assert!(
        ["U/2 = −1.5", "W = −25"].iter().all(|label| texts.iter().any(|text| text == label)),
        "{texts:?}"
    );
}

/// Lines around a point, 3 pixels apart, up to 100 pixels away, with a gap of 36 by 36 pixels to the upper right: it is
/// too small for `Z−20`, 34 pixels and its margins, but not for a number.
fn with_a_gap(at: Pixel) -> Vec<Vec<Pixel>> {
    let gap = Rectangle::around(Pixel::new(at.x + 30.0, at.y - 24.0), 36.0, 36.0);
    let level = |step: i32| {
        let y = at.y + 3.0 * f64::from(step);
        let line = |from: f64, to: f64| vec![Pixel::new(from, y), Pixel::new(to, y)];
        let (left, right) = (at.x - 100.0, at.x + 100.0);
        match (gap.min.y..=gap.max.y).contains(&y) {
            true => vec![line(left, gap.min.x), line(gap.max.x, right)],
            false => vec![line(left, right)],
        }
    };
    (-33..=33).flat_map(level).collect()
}

/// Beyond 15 mm, 57 pixels, a leader line is too long: the label is a number, and its text is in a row.
#[test]
fn a_label_far_from_its_point_is_a_number_with_a_row() {
    let bounds = Bounds::around(Point::new(0.0, -60.0), Point::new(40.0, 0.0));
    let camera = Camera::fit(bounds, Size { width: 700.0, height: 500.0 });
    let at = Point::new(20.0, -30.0);
    let note = Annotation::dimension(Shape::Note(at), "", Measure::Coordinate('Z', -20.0));
    let middle = camera.to_screen(at);
    let placed = |lines: &[Vec<Pixel>]| {
        place(std::slice::from_ref(&note), &Occupied::of_lines(lines, &camera), &camera, Unit::Millimetre)
    };
    let dense = with_a_gap(middle);
    let texts = |placed: &Placed| placed.labels.iter().map(|own| own.text.clone()).collect::<Vec<_>>();
    let numbered = placed(&dense);
    assert_eq!(texts(&numbered), ["*1", "*1: Z−20"]);
    assert!(numbered.labels[0].area.middle().distance(middle) < 57.0, "{numbered:?}");
    // Without the gap, not even a number is near.
    let whole: Vec<Vec<Pixel>> = dense
        .iter()
        .map(|line| vec![Pixel::new(middle.x - 100.0, line[0].y), Pixel::new(middle.x + 100.0, line[0].y)])
        .collect();
    assert_eq!(texts(&placed(&whole)), ["Z−20"]);
}

/// A column beyond the line is its end.
#[test]
fn a_figure_of_a_column_beyond_the_line_is_empty() {
    let subject = Subject::parse("word:2:4294967295").expect("a subject");
    let run = || run("G00 X32 Z2\nG01 Z-5 F1\nM30\n", &Setup::default());
    let finished = run();
    let simulation = SimulationResult::of(finished.motions(), &finished.setup_at_machine());
    let options = subject.options(SvgOptions::default(), run, &simulation, finished.motions());
    assert!(options.annotations.is_empty());
}

/// Arrow heads of the rapids of G90 from X32 Z2 to X26 Z-30: down to the cut, and back to the right. The tip comes first.
#[test]
fn arrows_point_in_the_direction_of_the_move() {
    let program = "G00 X32 Z2 M03 S400\nG90 X26 Z-30 F0.1\nM30\n";
    let mut run = run(program, &Setup::default());
    let figure = figures::of_cycle(&mut run, 20);
    let motions = Some(figure.motions(run.motions()));
    let options = SvgOptions { annotations: figure.annotations, motions, ..SvgOptions::default() };
    let picture = section(run.motions(), None, &options);
    let heads = picture.split(r#"class="arrow rapid" d="M"#).nth(1).expect("arrow heads");
    let heads = heads.split('"').next().expect("a path");
    let mut directions = Vec::new();
    for head in heads.split('Z').filter(|head| !head.is_empty()) {
        let corners: Vec<(f64, f64)> = head
            .trim_start_matches('M')
            .split('L')
            .map(|corner| {
                let (x, y) = corner.split_once(' ').expect("two numbers");
                (x.parse().expect("a number"), y.parse().expect("a number"))
            })
            .collect();
        let back = ((corners[1].0 + corners[2].0) / 2.0, (corners[1].1 + corners[2].1) / 2.0);
        directions.push(((corners[0].0 - back.0).round(), (corners[0].1 - back.1).round()));
    }
    assert!(directions.contains(&(0.0, 8.0)) && directions.contains(&(8.0, 0.0)), "{directions:?}");
    assert!(!directions.contains(&(-8.0, 0.0)), "{directions:?}");
}

/// The tips of the arrow heads of annotations in a picture.
fn tips(picture: &str) -> Vec<Pixel> {
    let heads = picture.split(r#"class="head" d="M"#).nth(1).and_then(|rest| rest.split('"').next());
    let corners = heads.into_iter().flat_map(|heads| heads.split('M'));
    // Dots have arcs.
    let tips = corners.filter(|head| head.contains('L')).filter_map(|head| head.split('L').next());
    let numbers = tips.filter_map(|tip| tip.split_once(' '));
    numbers.map(|(x, y)| Pixel::new(x.parse().expect("a number"), y.parse().expect("a number"))).collect()
}

/// Where passes are drawn apart, each dimension of a cycle has its true length: Δk = 2.9 of G75 was drawn from a column to
/// a displaced peck of the next column, 2.2.
#[test]
fn dimensions_beside_displaced_passes_have_their_true_length() {
    let mut measured = 0;
    for fixture in fixtures::all() {
        let mut run = run(&fixture.text, &Setup::from_json(&fixture.setup).expect("a setup"));
        let Some(first) = figures::first_cycle(&run) else { continue };
        let figure = figures::of_cycle(&mut run, first);
        let motions = Some(figure.motions(run.motions()));
        for own in figure.annotations {
            let (length, is_along_z) = match own.shape {
                Shape::Axial([a, b]) => (b.z - a.z, true),
                Shape::Radial([a, b]) => (b.x - a.x, false),
                Shape::Diameter(at) | Shape::DiameterThrough(at) => (2.0 * at.x, false),
                _ => continue,
            };
            let name = format!("{}: {:?}", fixture.id, own.label);
            let options = SvgOptions {
                annotations: vec![own],
                motions: motions.clone(),
                passes: Passes::Apart,
                ..SvgOptions::default()
            };
            let options = options.on_paper(160.0);
            let path_index = PathIndex::of(run.motions());
            let scale = camera(&Scene::new(run.motions(), &path_index, None), &options).scale();
            let [from, to] = tips(&section(run.motions(), None, &options))[..] else { continue };
            let drawn = if is_along_z { to.x - from.x } else { to.y - from.y };
            // Coordinates are written to 0.01 pixels.
            assert!((drawn.abs() - scale * length.abs()).abs() < 0.1, "{name}: {} mm", drawn / scale);
            measured += 1;
        }
    }
    assert!(measured > 200, "{measured}");
}

/// The labels of a program that are omitted, in the window of a page 1440 pixels wide and on paper 160 mm wide; a
/// label that meets another label, a stroke, a line or the border is a failure, also on paper 80 mm wide.
fn omitted(name: &str, mut run: Run) -> Vec<String> {
    let simulation = SimulationResult::of(run.motions(), &run.setup_at_machine());
    let work = Work::of(&simulation, run.motions(), None);
    let path_index = PathIndex::of(run.motions());
    let figure =
        figures::first_cycle(&run).map_or_else(Figure::default, |byte| figures::of_cycle(&mut run, byte));
    let scene = Scene::new(run.motions(), &path_index, work.as_ref());
    let mut found = Vec::new();
    let of_cycle = SvgOptions {
        motions: Some(figure.motions(run.motions())).filter(|motions| !motions.is_empty()),
        annotations: figure.annotations,
        ..SvgOptions::default()
    };
    let of_part =
        SvgOptions { annotations: part_annotations(&run), contents: Contents::Part, ..SvgOptions::default() };
    for (kind, options) in [("cycle", of_cycle), ("part", of_part)] {
        let is_part = options.contents == Contents::Part;
        let mut view = View::new(&scene, Size { width: 860.0, height: 700.0 });
        view.set_labels(&scene, Some(if is_part { Frame::Part } else { Frame::Cuts }));
        let on_paper = |width: f64| camera(&scene, &options.clone().on_paper(width));
        for (medium, camera) in [("window", *view.camera()), ("160", on_paper(160.0)), ("80", on_paper(80.0))]
        {
            let is_drawn = |motion: usize| match medium {
                "window" => true,
                _ => options.motions.iter().flatten().any(|own| own.contains(&motion)),
            };
            let strokes = scene.strokes().filter(|stroke| is_drawn(stroke.motion)).map(|stroke| stroke.shape);
            let occupied = match (medium, is_part) {
                ("window", _) => Occupied::of(&scene, &camera, strokes),
                (_, false) => Occupied::of_strokes(&camera, strokes)
                    .with_part(&scene, &camera)
                    .with_blank(&scene, &camera),
                (_, true) => Occupied::of_strokes(&camera, std::iter::empty()).with_part(&scene, &camera),
            };
            let placed = place(&options.annotations, &occupied, &camera, Unit::Millimetre);
            let name = format!("{name}, {kind}, {medium}");
            assert_meets_nothing(&name, &placed, &occupied, &camera);
            assert_leaders_are_apart(&name, &placed);
            let omitted = placed.omitted.iter().filter(|_| medium != "80");
            found.extend(omitted.map(|text| format!("{name}: {text}")));
        }
    }
    found
}

fn assert_meets_nothing(name: &str, placed: &Placed, occupied: &Occupied, camera: &Camera) {
    for (index, label) in placed.labels.iter().enumerate() {
        let [across, down] = camera.inside(0.0);
        let area = label.area;
        assert!(
            area.min.x >= across[0]
                && area.max.x <= across[1]
                && area.min.y >= down[0]
                && area.max.y <= down[1],
            "{name}: {label:?} is outside"
        );
        assert!(occupied.is_free(&area), "{name}: {label:?} is over a stroke");
        let crossing = placed.lines.iter().chain(&placed.edges).find(|line| passes_through(line, &area));
        assert!(crossing.is_none(), "{name}: {label:?} is over {crossing:?}");
        for other in &placed.labels[..index] {
            assert!(!area.overlaps(&other.area), "{name}: {label:?} over {other:?}");
        }
    }
}

/// The leaders of two steps end at different places, and do not cross.
fn assert_leaders_are_apart(name: &str, placed: &Placed) {
    let leaders: Vec<[Pixel; 2]> = placed
        .ends
        .iter()
        .filter_map(|end| placed.lines.iter().find(|line| line.len() == 2 && line[0] == *end))
        .map(|line| [line[0], line[1]])
        .collect();
    assert_eq!(leaders.len(), placed.ends.len(), "{name}");
    for (index, own) in leaders.iter().enumerate() {
        for other in &leaders[..index] {
            assert!(own[0].distance(other[0]) >= 5.0, "{name}: {own:?} and {other:?} mark one place");
            assert!(!do_cross(*own, *other), "{name}: {own:?} crosses {other:?}");
        }
    }
}

/// Whether two straight lines have a point in common.
fn do_cross(own: [Pixel; 2], other: [Pixel; 2]) -> bool {
    let side = |line: [Pixel; 2], at: Pixel| {
        let [a, b] = line;
        (b.x - a.x) * (at.y - a.y) - (b.y - a.y) * (at.x - a.x)
    };
    side(own, other[0]) * side(own, other[1]) < -1e-6 && side(other, own[0]) * side(other, own[1]) < -1e-6
}

/// Labels contain no words, so they are the same in each language.
#[test]
fn labels_of_the_gallery_meet_nothing_and_none_is_omitted() {
    let all = fixtures::all().into_iter().flat_map(|fixture| {
        omitted(&fixture.id, run(&fixture.text, &Setup::from_json(&fixture.setup).expect("a setup")))
    });
    let all: Vec<String> = all.collect();
    assert!(all.is_empty(), "{all:#?}");
}

#[test]
fn labels_of_random_shafts_meet_nothing_and_none_is_omitted() {
    let mut random = Random(2);
    let all = (0..200).flat_map(|index| {
        let (program, _) = random_shaft(&mut random);
        omitted(&format!("shaft {index}"), run(&program, &Setup::default()))
    });
    let all: Vec<String> = all.collect();
    assert!(all.is_empty(), "{all:#?}");
}

/// Whether a polyline has a point inside a rectangle, away from its border.
fn passes_through(line: &[Pixel], area: &Rectangle) -> bool {
    line.windows(2).any(|ends| {
        (0..=200).any(|step| {
            let share = f64::from(step) / 200.0;
            let x = ends[0].x + share * (ends[1].x - ends[0].x);
            let y = ends[0].y + share * (ends[1].y - ends[0].y);
            (area.min.x + 1.0..area.max.x - 1.0).contains(&x)
                && (area.min.y + 1.0..area.max.y - 1.0).contains(&y)
        })
    })
}

/// A word whose place is outside the picture is an arrow at the border, and the camera stays.
#[test]
fn a_word_out_of_view_is_an_arrow_at_the_border() {
    let mut run = run("G00 X62 Z2\nG01 Z-30 F0.2\nX80\nM30\n", &Setup::default());
    let own = annotations(&mut run, 2, "Z-30");
    let path_index = PathIndex::of(run.motions());
    let scene = Scene::new(run.motions(), &path_index, None);
    let mut camera = Camera::fit(scene.bounds(), Size { width: 800.0, height: 500.0 });
    camera.zoom(40.0, camera.to_screen(Point::new(200.0, 200.0)));
    let placed = place(
        &own,
        &Occupied::of(&scene, &camera, scene.strokes().map(|stroke| stroke.shape)),
        &camera,
        Unit::Millimetre,
    );
    let [across, down] = camera.inside(0.0);
    let tip = placed.heads[0][0];
    assert!((tip.x - across[0]).abs() < 5.0 || (tip.y - down[1]).abs() < 5.0, "{tip:?}");
    assert_eq!(placed.labels.len(), 1);
}
