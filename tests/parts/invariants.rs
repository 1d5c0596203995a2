//! Invariants of every program, tested with random ones.

use gcode_playground::analyze;
use gcode_playground::machine::region::Region;
use gcode_playground::machine::{Simulation, SimulationResult, SimulationStep};
use gcode_playground::motion::Motions;
use gcode_playground::setup::Setup;
use proptest::prelude::*;

use super::gallery::compare;
use super::reach::Reach;

const SETUP: &str = r#"{"stock": {"diameter": 60, "bore": 12, "face": 1, "length": 50},
    "tools": {"T0101": {"type": "turning", "noseRadius": 0.8, "pointAngle": 55, "enteringAngle": 93},
              "T0202": {"type": "grooving", "width": 3}, "T0303": {"type": "threading"},
              "T0404": {"type": "boring", "noseRadius": 0.4, "pointAngle": 35, "enteringAngle": 93}}}"#;

fn reach(station: u16, pitch: f64) -> Reach {
    match station {
        2 => Reach::blade(3.0, 1.0),
        3 => Reach::thread(1.0, pitch),
        4 => Reach::rhombus(52.0, 35.0, 12.0, 0.4, (1.0, -1.0), false),
        _ => Reach::rhombus(32.0, 55.0, 12.0, 0.8, (1.0, 1.0), false),
    }
}

/// A block that moves somewhere in and around the blank.
fn block() -> impl Strategy<Value = String> {
    let (x, z) = (4u32..66, -48i32..6);
    prop_oneof![
        3 => (x.clone(), z.clone()).prop_map(|(x, z)| format!("G01 X{x} Z{z}.3 F0.2")),
        2 => (x.clone(), z.clone()).prop_map(|(x, z)| format!("G00 X{x} Z{z}.7")),
        2 => (x.clone(), z.clone(), 40u32..90, 2u32..4)
            .prop_map(|(x, z, radius, code)| format!("G0{code} X{x} Z{z} R{radius} F0.2")),
        1 => (2u32..40, 1u32..10, 2u32..4)
            .prop_map(|(i, k, code)| format!("G0{code} I{i} K-{k} F0.2")),
        1 => (x, z, 1u32..9).prop_map(|(x, z, lead)| format!("G32 X{x} Z{z} F{lead}.5")),
        1 => (1u32..5).prop_map(|tool| format!("T0{tool}0{tool}")),
    ]
}

fn program(most: usize) -> impl Strategy<Value = String> {
    prop::collection::vec(block(), 1..most)
        .prop_map(|blocks| format!("T0101\nG97 S500 M03\nG00 X70 Z5\n{}\n", blocks.join("\n")))
}

fn run(program: &str) -> (Motions, Setup) {
    let setup = Setup::from_json(SETUP).expect("a setup");
    let analysis = analyze(program.as_bytes(), &setup);
    (analysis.motions, setup)
}

/// Area of `one` that is not in `other`, mm².
fn more(one: &Region, other: &Region) -> f64 {
    one.difference(other).area()
}

/// Areas below this are rounding errors, mm².
const ROUNDING: f64 = 0.002;

fn same(one: &Region, other: &Region) -> bool {
    more(one, other) < ROUNDING && more(other, one) < ROUNDING
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 64, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn any_moment_is_on_the_way_to_the_end(program in program(10)) {
        every_moment_is_on_the_way(&program);
    }

    #[test]
    fn slices_do_not_matter(program in program(60), slice in 1usize..50) {
        let (motions, setup) = run(&program);
        let whole = SimulationResult::of(&motions, &setup);
        let mut machining = Simulation::new(&motions, &setup);
        let sliced = loop {
            match machining.advance(&motions, slice) {
                SimulationStep::InProgress(more) => machining = more,
                SimulationStep::Done(simulation) => break simulation,
            }
        };
        prop_assert_eq!(whole.finished(), sliced.finished());
        prop_assert_eq!(whole.findings(), sliced.findings());
    }

    #[test]
    fn only_what_tools_pass_over_goes(program in program(12)) {
        only_what_is_passed_over_goes(&program);
    }
}

fn every_moment_is_on_the_way(program: &str) {
    let (motions, setup) = run(program);
    let simulation = SimulationResult::of(&motions, &setup);
    let at = |count, share| simulation.part_at(&motions, count, share).expect("a blank");
    assert!(same(&at(0, 0.0), simulation.blank().expect("a blank")));
    let mut before = at(0, 0.0);
    for count in 0..motions.len() {
        let half = at(count, 0.5);
        let whole = at(count, 1.0);
        assert!(more(&half, &before) < ROUNDING, "motion {count}: material grows\n{program}");
        assert!(more(&whole, &half) < ROUNDING, "motion {count}: half of it takes less\n{program}");
        assert!(same(&whole, &at(count + 1, 0.0)), "motion {count} whole\n{program}");
        before = whole;
    }
    assert!(same(&before, &simulation.finished().expect("a blank")), "the end\n{program}");
}

/// The circle crosses the bottom of a groove 13 µm before the corner between its arc and its long flank. Without that
/// corner the flank would be thicker by 0.16 µm at that end.
#[test]
fn a_later_cut_does_not_bring_material_back() {
    every_moment_is_on_the_way(
        "T0101\nG97 S500 M03\nG00 X70 Z5\nG02 X49 Z-40 R40 F0.2\nG01 X13 Z-14.3 F0.2\nG02 X47 Z-19 R40 F0.2\nT0404\nG03 I3 K-1 F0.2\n",
    );
}

fn only_what_is_passed_over_goes(program: &str) {
    let (motions, setup) = run(program);
    let stock = setup.extents().expect("a blank");
    let threads = motions.iter().filter(|motion| motion.process.tool.0 == 3);
    let pitch = threads.filter_map(|motion| motion.lead).fold(0.0, f64::max);
    let pitch = if pitch > 0.0 { pitch } else { 3.0 };
    compare(program, &motions, &setup, &stock, |_, motion| reach(motion.process.tool.0, pitch));
}

/// Exactly, 3.3 µm are left on the bore where the arc ends; by chords, 5.1 µm: as thin as the tolerance of
/// both ends.
#[test]
fn a_sliver_thinner_than_the_tolerance_is_no_difference() {
    only_what_is_passed_over_goes(
        "T0101\nG97 S500 M03\nG00 X70 Z5\nT0202\nG00 X52 Z3.7\nG02 X12 Z-46 R73 F0.2\n",
    );
}
