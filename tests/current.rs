//! The current run: neither results of an earlier run nor partial results reach a picture.
use gcode_playground::current::Current;
use gcode_playground::machine::SimulationResult;
use gcode_playground::playback::clock::Playhead;
use gcode_playground::scene::Plane;
use gcode_playground::scene::camera::{Pixel, Size};
use gcode_playground::scene::ruler::Scale;
use gcode_playground::scene::source::{Picture, Stage};
use gcode_playground::scene::view::{Frame, View};
use gcode_playground::setup::{Setup, Turret};
use gcode_playground::units::Unit;
use proptest::prelude::*;

const SIZE: Size = Size { width: 800.0, height: 600.0 };

fn program(id: &str) -> (String, Setup) {
    let read = |file: &str| std::fs::read_to_string(format!("tests/programs/{id}/{file}")).expect("a file");
    (read("program.nc"), Setup::from_json(&read("setup.json")).expect("a setup"))
}

fn run(current: &mut Current) {
    while !current.advance(7) {}
    while !current.remove_material(3) {}
}

fn fresh(text: &str, setup: &Setup) -> Current {
    let mut current = Current::new(text.as_bytes().to_vec(), setup.clone());
    current.look(Plane::Section, |view, scene| view.resize(scene, SIZE, 1.0));
    run(&mut current);
    current
}

fn section(current: &mut Current) -> Picture<'_> {
    current.picture(Plane::Section).expect("there is always a section")
}

/// Everything that is drawn: strokes, blank, part, collisions, and the view.
fn seen(current: &mut Current) -> (String, View, Vec<Option<(String, View)>>) {
    let surfaces = Plane::SURFACES.map(|plane| {
        current.picture(plane).map(|picture| {
            let work = picture.scene.work().map(|work| (&work.blank, &work.part));
            (format!("{:?} {work:?}", picture.scene.strokes().collect::<Vec<_>>()), picture.view.clone())
        })
    });
    let picture = section(current);
    let strokes: Vec<_> = picture.scene.strokes().collect();
    let work = picture
        .scene
        .work()
        .map(|work| (&work.blank, &work.part, &work.obstacles, &work.tool, &work.dangers, &work.compared));
    (format!("{strokes:?} {work:?}"), picture.view.clone(), surfaces.into())
}

/// A picture requested during the material removal shows no partly cut part, neither then nor later.
#[test]
fn a_half_cut_part_is_never_shown() {
    let (text, setup) = program("s003-g71");
    let mut current = Current::new(text.into_bytes(), setup);
    while !current.advance(10) {}
    let mut slices = 0;
    loop {
        assert_eq!(current.stage(), Stage::Path);
        let picture = section(&mut current);
        assert!(picture.scene.work().is_none() && picture.source.stage == Stage::Path);
        assert!(current.part().is_none() && current.part_shown().is_none() && current.simulation().is_none());
        if current.remove_material(1) {
            break;
        }
        slices += 1;
    }
    assert!(slices > 50, "only {slices} slices");
    let whole = SimulationResult::of(current.motions(), current.run().setup()).finished().expect("a blank");
    assert_eq!(current.part(), Some(&whole));
    assert_eq!(current.part_shown(), Some(whole));
    let picture = section(&mut current);
    assert!(picture.source.stage == Stage::Whole && picture.scene.work().is_some());
}

/// Every start of a new run discards the results of the last one and assigns a new run identifier.
#[test]
fn nothing_of_a_run_outlives_it() {
    type Change = fn(&mut Current);
    let changes: [Change; 3] = [
        |current| current.set_text(b"G0 X50 Z2\nG1 Z-20 F0.2\n".to_vec(), Setup::default()),
        |current| current.set_setup(Setup::default()),
        |current| current.edit(0, 1, "("),
    ];
    for change in changes {
        let (text, setup) = program("s002-g121-square");
        let mut current = fresh(&text, &setup);
        current.set_cursor(Some(120));
        current.set_hover(Some(3));
        current.seek(Some(Playhead { motion: 5, share: 0.5 }));
        assert!(current.picture(Plane::Face).is_some());
        let before = section(&mut current).source;
        change(&mut current);
        assert_eq!(current.stage(), Stage::Running);
        assert!(
            current.simulation().is_none()
                && current.moves(Plane::Face).is_none()
                && current.resolved_setup().is_none()
        );
        let picture = section(&mut current);
        assert_ne!(picture.source.run, before.run);
        assert!(
            picture.view.hover.is_none() && picture.view.playhead.is_none() && picture.scene.work().is_none()
        );
        assert!(
            current.view(Plane::Face).highlight.is_empty() && current.view(Plane::Face).playhead.is_none()
        );
        run(&mut current);
        let after = section(&mut current).source;
        assert!(after.stage == Stage::Whole && after.run != before.run);
    }
}

/// An edited comment gives the tool a new description.
#[test]
fn an_edited_comment_describes_another_tool() {
    let text = "O1\nG21 G99\nT0303 (GROOVE W=3)\nG0 X50 Z-10\nG1 X30 F.1\nG0 X50\nM30\n";
    let mut current = fresh(text, &Setup::default());
    let width = |current: &Current| {
        let resolved = current.resolved_setup().expect("material is off");
        resolved.tool(&current.motions().get(1)).tool.width
    };
    assert_eq!(width(&current), Some(3.0));
    let at = text.find("3)").expect("the width") as u32;
    current.edit(at, at + 1, "4");
    run(&mut current);
    assert_eq!(width(&current), Some(4.0));
}

#[test]
fn the_unit_symbol_stays_from_run_to_run() {
    let (text, setup) = program("s003-g71");
    let mut current = fresh(&text, &setup);
    current.set_unit_symbols(["мм", "дюйм"]);
    current.edit(0, 0, "(A)\n");
    run(&mut current);
    assert_eq!(section(&mut current).view.scale.symbol, "мм");
    let before = section(&mut current).view.clone();
    current.set_unit_symbols(["mm", "in"]);
    assert!(!section(&mut current).view.shows_same_ground(&before));
    assert_eq!(current.view(Plane::Face).scale.symbol, "mm");
}

/// An inch program has rulers in inches until the user selects another unit; that selection stays.
#[test]
fn the_rulers_count_in_the_unit_of_the_program_or_the_chosen_one() {
    let inches = "O1\nG20 G99 G97 S800 M3\nT0101\nG0 X2. Z.1\nG1 Z-1. F.01\nM30\n";
    let mut current = fresh(inches, &Setup::default());
    let scale = |current: &mut Current| {
        let Scale { unit, symbol } = section(current).view.scale;
        (unit, symbol)
    };
    assert_eq!(scale(&mut current), (Unit::Inch, "in"));
    let before = section(&mut current).view.clone();
    current.set_unit(Some(Unit::Millimetre));
    assert_eq!(scale(&mut current), (Unit::Millimetre, "mm"));
    assert!(!section(&mut current).view.shows_same_ground(&before));
    current.set_text(inches.into(), Setup::default());
    run(&mut current);
    assert_eq!(scale(&mut current), (Unit::Millimetre, "mm"));
    current.set_unit(None);
    assert_eq!(scale(&mut current), (Unit::Inch, "in"));
    current.set_text(b"O1\nG0 X50 Z2\nM30\n".to_vec(), Setup::default());
    run(&mut current);
    assert_eq!((current.unit(), scale(&mut current)), (Unit::Millimetre, (Unit::Millimetre, "mm")));
}

/// After a stopped run, the clock knows all motions made so far.
#[test]
fn the_clock_of_a_stopped_run_knows_all_its_motions() {
    let text = "G99 M3 S500\n".to_owned() + &"G1 X50 Z-1 F0.2\nX60 Z0\n".repeat(3000);
    let mut current = Current::new(text.into_bytes(), Setup::default());
    current.advance(4000);
    let _ = current.clock();
    current.stop(1.0);
    let whole = current.clock().total().animation_seconds;
    let fresh =
        gcode_playground::playback::clock::Clock::new(current.motions(), &current.run().setup().machine);
    assert!(
        (whole - fresh.total().animation_seconds).abs() < 1e-9,
        "{whole}, not {}",
        fresh.total().animation_seconds
    );
}

/// Actions between two runs, and between two slices of a run.
#[derive(Clone, Debug)]
enum Act {
    Program(usize),
    Setup(usize),
    Edit { from: u32, insert: &'static str },
    Advance(usize),
    Machine(usize),
    StopMachining,
    Draw,
    Put(usize, f64),
    Hover(u32),
    Turn(bool),
    Zoom,
    Keep,
    Export,
}

const PROGRAMS: [&str; 5] = ["s003-g71", "s003-g73", "s002-g121-square", "s001-o6003", "s000-o0002"];

fn act() -> impl Strategy<Value = Act> {
    prop_oneof![
        2 => (0..PROGRAMS.len()).prop_map(Act::Program),
        1 => (0..PROGRAMS.len()).prop_map(Act::Setup),
        2 => (0u32..300, prop_oneof![Just("X"), Just("1"), Just("\n"), Just("(x)"), Just("")])
            .prop_map(|(from, insert)| Act::Edit { from, insert }),
        4 => (1usize..40).prop_map(Act::Advance),
        4 => (1usize..60).prop_map(Act::Machine),
        1 => Just(Act::StopMachining),
        5 => Just(Act::Draw),
        1 => ((0usize..40), (0.0f64..1.0)).prop_map(|(motion, share)| Act::Put(motion, share)),
        1 => (0u32..40).prop_map(Act::Hover),
        1 => any::<bool>().prop_map(Act::Turn),
        1 => Just(Act::Zoom),
        1 => Just(Act::Keep),
        1 => Just(Act::Export),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 48, failure_persistence: None, ..ProptestConfig::default() })]

    /// Whatever actions came before, the state equals that of a fresh run.
    #[test]
    fn whatever_was_there_before_a_run_looks_as_if_begun_afresh(acts in prop::collection::vec(act(), 1..40)) {
        let all: Vec<_> = PROGRAMS.iter().map(|id| program(id)).collect();
        let (mut text, mut setup) = all[0].clone();
        let mut current = fresh(&text, &setup);
        for act in &acts {
            match *act {
                Act::Program(index) => {
                    (text, setup) = all[index].clone();
                    current.set_text(text.clone().into_bytes(), setup.clone());
                }
                Act::Setup(index) => {
                    setup = all[index].1.clone();
                    current.set_setup(setup.clone());
                }
                Act::Edit { from, insert } => {
                    let from = (from as usize).min(text.len());
                    let to = (from + 1 - insert.len().min(1)).min(text.len());
                    text.replace_range(from..to, insert);
                    current.edit(from as u32, to as u32, insert);
                }
                Act::Advance(blocks) => { current.advance(blocks); }
                Act::Machine(motions) => { current.remove_material(motions); }
                // A cancelled part stays cancelled until the next run.
                Act::StopMachining => {
                    if current.simulation().is_none() {
                        current.stop_machining();
                        current.set_text(text.clone().into_bytes(), setup.clone());
                    }
                }
                Act::Draw => { seen(&mut current); }
                Act::Put(motion, share) => {
                    let motion = motion.min(current.motions().len().saturating_sub(1));
                    current.seek(Some(Playhead { motion, share }));
                    seen(&mut current);
                }
                Act::Hover(motion) => current.set_hover(Some(motion as usize)),
                Act::Turn(front) => {
                    current.set_turret(Some(if front { Turret::Front } else { Turret::Rear }));
                }
                Act::Zoom => {
                    current.look(Plane::Section, |view, _| view.zoom(1.5, Pixel::new(100.0, 100.0)));
                    seen(&mut current);
                    current.look(Plane::Section, |view, scene| view.fit(scene));
                }
                Act::Keep => current.keep(),
                Act::Export => current.finish_part(),
            }
        }
        let mut expected = fresh(&text, &setup);
        // The decimal rule is kept while the user types.
        if current.run().decimal_rule() != expected.run().decimal_rule() {
            current.reinfer_decimal_rule();
        }
        run(&mut current);
        current.end_comparison();
        current.seek(None);
        current.set_hover(None);
        current.set_turret(None);
        let (found, wanted) = (seen(&mut current), seen(&mut expected));
        prop_assert_eq!(&found.1, &wanted.1);
        let at = found.0.bytes().zip(wanted.0.bytes()).take_while(|(a, b)| a == b).count();
        let excerpt = |text: &str| text[at.saturating_sub(60)..text.len().min(at + 60)].to_owned();
        prop_assert!(found.0 == wanted.0, "{}\n{}", excerpt(&found.0), excerpt(&wanted.0));
        prop_assert!(found.2 == wanted.2, "the face");
        prop_assert_eq!(current.motions(), expected.motions());
    }
}

/// The host page can mark lines: their strokes are highlighted until the user selects a block, and again
/// after an edit.
#[test]
fn marked_lines_are_lit_up_until_a_block_is_chosen() {
    let text = "G00 X50 Z2\nG01 Z-10 F0.2\nX60\n(NO MOTION)\nG00 X70\n";
    let mut current = fresh(text, &Setup::default());
    let lit = |current: &mut Current| section(current).view.highlight.clone();
    current.set_marked_lines(vec![4..9, 1..3, 70..80]);
    assert_eq!(lit(&mut current), vec![1..4]);
    current.set_cursor(Some(0));
    assert_eq!(lit(&mut current), vec![0..1]);
    current.set_cursor(None);
    current.edit(0, 0, "\n");
    run(&mut current);
    assert_eq!(lit(&mut current), [0..2, 3..4]);
}

/// A picture can be fitted to the cuts, to the part, or to the whole path including the tool change position.
#[test]
fn a_picture_is_fitted_to_the_cuts_to_the_part_or_to_the_path() {
    let text = "G00 X300 Z400\nX50 Z2\nG01 Z-10 F0.2\nG00 X300 Z400\n";
    let setup = Setup::from_json(r#"{"stock": {"diameter": 60, "length": 80}}"#).expect("a setup");
    let mut current = fresh(text, &setup);
    let mut scale = |frame: Frame| {
        current.look(Plane::Section, |view, scene| view.set_frame(scene, frame));
        section(&mut current).view.camera().scale()
    };
    let [usual, cuts, part, path] = [Frame::Usual, Frame::Cuts, Frame::Part, Frame::Path].map(&mut scale);
    // The cut is 12 mm long and at radius 25; the blank is 80 mm long, and 60 mm high on both sides of the axis.
    assert!(cuts > 2.0 * part, "{cuts} {part}");
    assert!(part >= usual && usual > 2.0 * path, "{part} {usual} {path}");
}

const OF_THE_SIDE: &str =
    r#"{"stock": {"diameter": 60, "length": 60}, "tools": {"T0101": {"type": "endmill", "toolRadius": 5}}}"#;
/// Lines 8 to 10 are moves on the cylinder surface; the last one crosses the seam.
const GROOVE: &str = "M45\nT0101\nG98 G97 S1000 M13\nG00 X70 Z-20 C0\nG01 X50 F100\nG07.1 C30\n\nG01 C300\nZ-40\nC400\nG07.1 C0\nG00 X70\n";

/// The developed surface is a picture like the others: strokes are found by Z and C, the tool is at the same
/// place as in the section, and a selection in the section is also shown here, in all its pieces.
#[test]
fn the_side_is_picked_in_and_follows_the_section() {
    let mut current = fresh(GROOVE, &Setup::from_json(OF_THE_SIDE).expect("a setup"));
    let place = |current: &mut Current, z: f64, c: f64| {
        let at = current.side().expect("a side").point(z, c);
        current.picture(Plane::Side).expect("a side").view.camera().to_screen(at)
    };
    let mut found = Vec::new();
    for (z, c) in [(-20.0, 150.0), (-30.0, 300.0), (-40.0, 330.0), (-40.0, 380.0), (-40.0, 20.0)] {
        let at = place(&mut current, z, c);
        let (motion, at) = current.pick(Plane::Side, at, 4.0).expect("a stroke");
        let motions = current.picture(Plane::Section).expect("a section").scene;
        found.push(motions.stroke(motion).expect("a stroke").line + 1);
        assert!((at.x - 25.0).abs() < 1e-9 && (at.z - z).abs() < 0.2, "{at:?}");
    }
    assert_eq!(found, [8, 9, 10, 10, 10]);
    let beside = place(&mut current, -50.0, 150.0);
    assert!(current.pick(Plane::Side, beside, 4.0).is_none());
    let down = place(&mut current, -20.0, 90.0).y > place(&mut current, -20.0, 10.0).y;
    assert!(down, "seen from outside, with Z to the right, C counts downwards");

    current.set_cursor(Some(GROOVE.find("C400").expect("a block") as u32));
    let picture = current.picture(Plane::Side).expect("a side");
    assert_eq!((picture.view.highlight.len(), picture.view.highlight[0].clone()), (1, 2..4));
    let last = current.motions().len() - 2;
    current.seek(Some(Playhead { motion: last, share: 0.8 }));
    let expected = current.side().expect("a side").point(-40.0, 380.0);
    let picture = current.picture(Plane::Side).expect("a side");
    let playhead = picture.view.playhead.expect("a playhead");
    let at = picture.scene.place(playhead).expect("a place").at;
    assert!(at.distance(expected) < 1e-6, "{at:?}");
    let tool = picture.scene.work().and_then(|work| work.tool.as_ref()).expect("a tool");
    assert!(tool.tip.distance(expected) < 1e-6);
    current.set_hover(Some(last));
    assert_eq!(current.picture(Plane::Side).expect("a side").view.hover, Some(2));
    assert!(current.picture(Plane::Face).is_none());
    current.set_text(b"G00 X50 Z2\nG01 Z-20 F0.2\n".to_vec(), Setup::default());
    assert!(current.moves(Plane::Side).is_none());
    run(&mut current);
    assert!(current.picture(Plane::Side).is_none());
}

/// While the user types, the decimal rule is kept, until it is decided again: without its point, the X100.0 of G40 is
/// one of the numbers that decide it.
#[test]
fn the_decimal_rule_after_an_edit_is_that_of_a_fresh_run() {
    let (mut text, setup) = program("s002-g121-square");
    let mut current = fresh(&text, &setup);
    let point = text.find("X100.0").expect("a number") + "X100".len();
    text.replace_range(point..=point, "");
    current.edit(point as u32, point as u32 + 1, "");
    current.reinfer_decimal_rule();
    run(&mut current);
    assert!(current.motions() == fresh(&text, &setup).motions());
}
