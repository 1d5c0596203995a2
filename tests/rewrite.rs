//! Plain moves rewritten as cycles: the result for each shape, similar cases that must not change, and that
//! no motion changes.

use crate::fixtures;
use gcode_playground::analyze;
use gcode_playground::message::applied;
use gcode_playground::motion::{Feed, MotionKind};
use gcode_playground::rewrite::{Offer, offers, rewritten};
use gcode_playground::sentences::Language;
use gcode_playground::setup::Setup;
use gcode_playground::source::Span;
use proptest::prelude::*;

const SETUP: &str = r#"{"initial": {"x": 100, "z": 50}, "dialect": {"gSystem": "A"}}"#;

/// Checks a program under a setup after all offers are applied.
#[track_caller]
fn check_with(setup: &str, before: &str, after: &str) -> Vec<Offer> {
    let setup = Setup::from_json(setup).expect("setup");
    let (text, taken) = rewritten(before.as_bytes(), &setup);
    assert_eq!(String::from_utf8_lossy(&text), after, "from:\n{before}");
    same(before, &String::from_utf8_lossy(&text), &setup);
    taken
}

#[track_caller]
fn check(before: &str, after: &str) {
    let taken = check_with(SETUP, before, after);
    assert!(!taken.is_empty(), "nothing was written as a cycle");
}

/// Checks that there is no offer.
#[track_caller]
fn check_none(program: &str) {
    check_none_with(SETUP, program);
}

#[track_caller]
fn check_none_with(setup: &str, program: &str) {
    assert_eq!(check_with(setup, program, program), [], "\n{program}");
    let setup = Setup::from_json(setup).expect("setup");
    assert_eq!(offers(program.as_bytes(), &setup, None), [], "\n{program}");
}

/// Compares the motions of both texts apart from their code: kind, ends, centre, feed or lead, speed and
/// tool. Calculated here independently of the comparison in the crate.
#[track_caller]
fn same(before: &str, after: &str, setup: &Setup) {
    let rows = |text: &str| -> Vec<(MotionKind, Vec<i64>, String)> {
        let analysis = analyze(text.as_bytes(), setup);
        let fine = |value: f64| (value * 1e5).round() as i64;
        analysis
            .motions
            .iter()
            .map(|motion| {
                let (from, to) = (motion.from, motion.to);
                let center = motion.center.unwrap_or_default();
                let feed = match (motion.kind, motion.process.feed) {
                    (MotionKind::Rapid | MotionKind::Dwell, _) => 0.0,
                    (MotionKind::Thread, _) => motion.lead.unwrap_or(-1.0),
                    (_, Feed::PerMinute(feed)) => 1e6 + feed,
                    (_, Feed::PerTurn(feed)) => feed,
                    (_, Feed::Unset) => -2.0,
                };
                let numbers = [from.x, from.z, to.x, to.z, center.x, center.z, feed].map(fine).to_vec();
                let process = motion.process;
                (motion.kind, numbers, format!("{:?} {:?} {:?}", process.speed, process.turn, process.tool))
            })
            .collect()
    };
    assert_eq!(rows(before), rows(after), "\n{before}\n--- became ---\n{after}");
}

#[test]
fn four_moves_become_g90() {
    check(
        "G00 X32 Z2\nG00 X26\nG01 Z-30 F0.1\nX32\nG00 Z2\nG00 X100\nZ100\nM30\n",
        "G00 X32 Z2\nG90 X26 Z-30 F0.1\nG00 X100\nZ100\nM30\n",
    );
}

#[test]
fn the_seed_program_becomes_the_one_with_the_cycle() {
    let program = |id: &str| {
        fixtures::program(id, &|file| std::fs::read_to_string(fixtures::folder().join(file)).expect(file))
    };
    let (plain, cycle) = (program("s001-o0001"), program("s001-o0002"));
    check_with(&plain.setup, &plain.text, &cycle.text.replace("O0002", "O0001"));
}

#[test]
fn passes_from_one_start_point_go_on_with_what_changes() {
    check(
        "G0 X62 Z2\nX56\nG1 Z-40 F0.2\nX62\nG0 Z2\nX52\nG1 Z-40\nX62\nG0 Z2\nX50\nG1 Z-25 F0.1\nX62\nG0 Z2\nX100 Z100\nG1 X90\nM30\n",
        "G0 X62 Z2\nG90 X56 Z-40 F0.2\nX52\nX50 Z-25 F0.1\nG0 X100 Z100\nG1 X90\nM30\n",
    );
}

#[test]
fn a_cone_gets_its_r() {
    check(
        "G0 X62 Z0\nX40\nG1 X50 Z-30 F0.2\nX62\nG0 Z0\nX36\nG1 X46 Z-30\nX62\nG0 Z0\nX36\nG1 Z-30\nX62\nG0 Z0\nM30\n",
        "G0 X62 Z0\nG90 X50 Z-30 R-5 F0.2\nX46\nX36 R0\nM30\n",
    );
    // Falling from a point to the left of the end.
    check(
        "G00 X62. Z0.\nX56.\nG01 X50. Z-30. F.2\nX62.\nG00 Z0.\nM30\n",
        "G00 X62. Z0.\nG90 X50. Z-30. R3. F.2\nM30\n",
    );
}

#[test]
fn a_bore_is_cut_from_inside() {
    check(
        "G0 X18 Z2\nX22\nG1 Z-30 F0.1\nX18\nG0 Z2\nX26\nG1 Z-30\nX18\nG0 Z2\nZ100\nM30\n",
        "G0 X18 Z2\nG90 X22 Z-30 F0.1\nX26\nG0 Z100\nM30\n",
    );
}

#[test]
fn the_other_axis_first_is_g94() {
    check(
        "G00 X62 Z2\nZ-2\nG01 X20 F0.15\nZ2\nG00 X62\nZ-4\nG01 X20\nZ2\nG00 X62\nX100 Z100\nM30\n",
        "G00 X62 Z2\nG94 X20 Z-2 F0.15\nZ-4\nG00 X100 Z100\nM30\n",
    );
    check(
        "G00 X62 Z2\nZ-8\nG01 X20 Z-4 F0.15\nZ2\nG00 X62\nM30\n",
        "G00 X62 Z2\nG94 X20 Z-4 R-4 F0.15\nM30\n",
    );
}

#[test]
fn a_thread_becomes_g92() {
    check(
        "G97 S500 M03\nG00 X32 Z3\nX29.4\nG32 Z-23 F2\nG00 X32\nZ3\nX29\nG32 Z-23\nG00 X32\nZ3\nX100\nM30\n",
        "G97 S500 M03\nG00 X32 Z3\nG92 X29.4 Z-23 F2\nX29\nG00 X100\nM30\n",
    );
    // The last depth repeated.
    check(
        "G97 S500 M03\nG00 X32 Z3\nX29\nG32 Z-23 F2\nG00 X32\nZ3\nX29\nG32 Z-23\nG00 X32\nZ3\nM30\n",
        "G97 S500 M03\nG00 X32 Z3\nG92 X29 Z-23 F2\nX29\nM30\n",
    );
    check(
        "G97 S500 M03\nG00 X40 Z3\nX28\nG32 X30 Z-23 F2\nG00 X40\nZ3\nX27\nG32 X29 Z-23 F2\nG00 X40\nZ3\nM30\n",
        "G97 S500 M03\nG00 X40 Z3\nG92 X30 Z-23 R-1 F2\nX29\nM30\n",
    );
}

#[test]
fn incremental_words_count_from_the_start_point() {
    check(
        "G00 X32 Z2\nU-6\nG01 W-32 F0.1\nU6\nG00 W32\nU-8\nG01 W-32\nU8\nG00 W32\nU10\nM30\n",
        "G00 X32 Z2\nG90 U-6 W-32 F0.1\nU-8\nG00 U10\nM30\n",
    );
    // U of the cut counts from its own start, U of the cycle from the start point.
    check(
        "G00 X62 Z0\nU-22\nG01 U10 W-30 F0.2\nX62\nG00 Z0\nM30\n",
        "G00 X62 Z0\nG90 U-12 W-30 R-5 F0.2\nM30\n",
    );
}

#[test]
fn inches_stay_inches() {
    check(
        "G20\nG00 X2.5 Z.1\nX2.1\nG01 X2.25 Z-1.5 F.008\nX2.5\nG00 Z.1\nX4.\nM30\n",
        "G20\nG00 X2.5 Z.1\nG90 X2.25 Z-1.5 R-0.075 F.008\nG00 X4.\nM30\n",
    );
}

#[test]
fn other_systems_write_other_codes() {
    let system = |letter: &str| {
        format!(r#"{{"initial": {{"x": 100, "z": 50}}, "dialect": {{"gSystem": "{letter}"}}}}"#)
    };
    let moves = "G00 X32 Z2\nX26\nG01 Z-30 F0.1\nX32\nG00 Z2\nX100\nM30\n";
    check_with(&system("B"), moves, "G00 X32 Z2\nG77 X26 Z-30 F0.1\nG00 X100\nM30\n");
    check_with(&system("C"), moves, "G00 X32 Z2\nG20 X26 Z-30 F0.1\nG00 X100\nM30\n");
    check_with(
        &system("B"),
        "G00 X62 Z0\nG91\nX-22\nG01 X10 Z-30 F0.2\nX12\nG00 Z30\nX10\nM30\n",
        "G00 X62 Z0\nG91\nG77 X-12 Z-30 R-5 F0.2\nG00 X10\nM30\n",
    );
}

#[test]
fn numbers_without_point_get_one_where_it_counts() {
    check_with(
        r#"{"initial": {"x": 100, "z": 50}, "dialect": {"gSystem": "A", "decimal": "leastIncrement"}}"#,
        "G00 X62000 Z0\nX40000\nG01 X50000 Z-30000 F0.2\nX62000\nG00 Z0\nM30\n",
        "G00 X62000 Z0\nG90 X50000 Z-30000 R-5. F0.2\nM30\n",
    );
}

#[test]
fn comments_and_style_stay() {
    check(
        "N10 G00 X32 Z2 (START)\nN20 X26 (INFEED)\n(CUTTING)\nN30 G01 Z-30 F0.1 (CUT)\nN40 X32\nN50 G00 Z2\nN60 X100\nM30\n",
        "N10 G00 X32 Z2 (START)\nN20 G90 X26 Z-30 F0.1 (INFEED)\n(CUTTING)\n(CUT)\nN60 G00 X100\nM30\n",
    );
    check(
        "g0x32z2\nx26\ng1z-30f0.1\nx32\ng0z2\nx100z100\nm30\n",
        "g0x32z2\ng90x26z-30f0.1\ng0 x100z100\nm30\n",
    );
    check(
        "G00 X32 Z2; X26 (A) Z2; G01 Z-30 F0.1; X32; G00 Z2;\r\nX100;\r\nM30;\r\n",
        "G00 X32 Z2; G90 X26 Z-30 F0.1 (A);\r\nG00 X100;\r\nM30;\r\n",
    );
    check(
        "G0 X32 Z2\r\n\r\nX26\r\n\r\nG1 Z-30 F.1\r\nX32\r\nG0 Z2",
        "G0 X32 Z2\r\n\r\nG90 X26 Z-30 F.1\r\n\r\n",
    );
}

#[test]
fn what_relied_on_g00_gets_it() {
    let moves = "G00 X32 Z2\nX26\nG01 Z-30 F0.1\nX32\nG00 Z2\n";
    let cycle = "G00 X32 Z2\nG90 X26 Z-30 F0.1\n";
    let behind = |before: &str, after: &str| check(&format!("{moves}{before}"), &format!("{cycle}{after}"));
    behind("T0202\nM08\nX50 S300\nM30\n", "T0202\nM08\nG00 X50 S300\nM30\n");
    behind("G04 X1\nG28 U0 W0\nX50\nM30\n", "G04 X1\nG28 U0 W0\nG00 X50\nM30\n");
    behind("G01 X50\nX52\nM30\n", "G01 X50\nX52\nM30\n");
    // After a jump or a skipped block, G00 must be in force as before.
    behind("/X50\nX60\nM30\n", "G00\n/X50\nX60\nM30\n");
    behind("IF[#1EQ1]GOTO5\nX50\nN5 X60\nM30\n", "G00\nIF[#1EQ1]GOTO5\nX50\nN5 X60\nM30\n");
    behind("N5 X60\n#1=#1+1\nIF[#1LT3]GOTO5\nM30\n", "G00\nN5 X60\n#1=#1+1\nIF[#1LT3]GOTO5\nM30\n");
    behind("M98 P7\nM30\nO7\nX60\nM99\n", "G00\nM98 P7\nM30\nO7\nX60\nM99\n");
}

#[test]
fn one_cycle_behind_the_other() {
    check(
        "G00 X62 Z2\nX56\nG01 Z-40 F0.2\nX62\nG00 Z2\nZ-2\nG01 X20\nZ2\nG00 X62\nX100\nM30\n",
        "G00 X62 Z2\nG90 X56 Z-40 F0.2\nG94 X20 Z-2\nG00 X100\nM30\n",
    );
}

#[test]
fn moves_that_are_nearly_a_cycle_stay() {
    let program = |infeed: &str, cut: &str, retract: &str, back: &str| {
        format!("G00 X32 Z2\n{infeed}\n{cut}\n{retract}\n{back}\nM30\n")
    };
    // A retract at rapid, an infeed or a return at feed.
    check_none(&program("X26", "G01 Z-30 F0.1", "G00 X32", "Z2"));
    check_none(&program("G01 X26 F0.1", "Z-30", "X32", "G00 Z2"));
    check_none(&program("X26", "G01 Z-30 F0.1", "X32", "Z2"));
    // The end is not the start point.
    check_none(&program("X26", "G01 Z-30 F0.1", "X32", "G00 Z2.001"));
    check_none(&program("X26", "G01 Z-30 F0.1", "X33", "G00 Z2"));
    check_none(&program("X26 Z1", "G01 Z-30 F0.1", "X32", "G00 Z2"));
    // Another feed for the retract, or a feed set at the end.
    check_none(&program("X26", "G01 Z-30 F0.1", "X32 F0.5", "G00 Z2"));
    check_none(&program("X26", "G01 Z-30 F0.1", "X32", "G00 Z2 F0.5"));
    // Blocks with more than moves.
    check_none(&program("X26 M08", "G01 Z-30 F0.1", "X32", "G00 Z2"));
    check_none(&program("X26", "G01 Z-30 F0.1 S500", "X32", "G00 Z2"));
    check_none(&program("X26", "G01 Z-30 F0.1", "T0202 X32", "G00 Z2"));
    check_none(&program("X26", "G01 Z-30 F0.1", "M08\nX32", "G00 Z2"));
    check_none(&program("X26", "G01 Z-30 F0.1", "G04 X1\nX32", "G00 Z2"));
    check_none(&program("X26", "G01 Z-30 F0.1", "/X32", "G00 Z2"));
    check_none(&program("X26", "G01 Z-30 F0.1 ,C1", "X32", "G00 Z2"));
    check_none(&program("X#1", "G01 Z-30 F0.1", "X32", "G00 Z2"));
    check_none(&program("X[20+6]", "G01 Z-30 F0.1", "X32", "G00 Z2"));
    // An arc instead of a cut.
    check_none(&program("X26", "G02 X28 Z-30 R60 F0.1", "G01 X32", "G00 Z2"));
    // A taper that R cannot express exactly.
    check_none(&program("X26.001", "G01 X28 Z-30 F0.1", "X32", "G00 Z2"));
}

#[test]
fn threads_that_g92_would_cut_otherwise_stay() {
    let thread = "G97 S500 M03\nG00 X32 Z3\nX29.4\nG32 Z-23 F2\nG00 X32\nZ3\nM30\n";
    // The control ends G92 with a pull-out.
    check_none_with(
        r#"{"initial": {"x": 100, "z": 50}, "dialect": {"gSystem": "A", "threadChamfer": 10}}"#,
        thread,
    );
    check_none(&thread.replace("F2", "F2 Q180000"));
    check_none(&thread.replace("G32 Z-23 F2", "G34 Z-23 F2 K0.1"));
    check_none(&thread.replace("G00 X32\nZ3\nM30", "G01 X32\nG00 Z3\nM30"));
}

#[test]
fn a_taper_a_control_would_refuse_is_not_offered() {
    // The cut begins beyond the start point.
    check_none("G00 X30 Z0\nX40\nG01 X20 Z-30 F0.2\nX30\nG00 Z0\nM30\n");
}

#[test]
fn what_the_program_comes_to_from_elsewhere_stays() {
    let moves = "G00 X32 Z2\nX26\nN7 G01 Z-30 F0.1\nX32\nG00 Z2\n";
    check(&format!("{moves}M30\n"), "G00 X32 Z2\nG90 X26 Z-30 F0.1\nM30\n");
    check_none(&format!("{moves}IF[#1EQ1]GOTO7\nM30\n"));
    check_none(&format!("{moves}IF[#1EQ1]GOTO[#2+1]\nM30\n"));
    // Subprograms, loops and contours.
    check_none(&format!("M98 P7\nM30\nO7\n{moves}M99\n"));
    check_none(&format!("M97 P100\nM30\nN100\n{moves}M99\n"));
    check_none(&format!("#1=0\nWHILE[#1LT1]DO1\n#1=#1+1\n{moves}END1\nM30\n"));
    check_none(&format!("#1=0\nN5 #1=#1+1\n{moves}IF[#1LT2]GOTO5\nM30\n"));
    let contour = "G00 X26\nG01 Z-30 F0.1\nX32\nN20 G00 Z2\nM30\n";
    check_none(&format!("G00 X32 Z2\nG70 P10 Q20\nN10 {contour}"));
    check_none(&format!("G00 X32 Z2\nN10 {contour}").replace("M30", "G70 P10 Q20\nM30"));
}

#[test]
fn compensation_and_virtual_planes_stay() {
    let moves = "X26\nG01 Z-30 F0.1\nX32\nG00 Z2\n";
    check_none(&format!("T0101\nG00 X32 Z2\nG42\n{moves}G40 X40\nM30\n"));
    check_none(&format!("G00 X32 Z2\nG12.1\n{}G13.1\nM30\n", moves.replace('Z', "C")));
}

#[test]
fn an_offer_says_what_it_does() {
    let text = "G00 X32 Z2\nX26\nG01 Z-30 F0.1\nX32\nG00 Z2\nX24\nG01 Z-30\nX32\nG00 Z2\nX100\nM30\n";
    let setup = Setup::from_json(SETUP).expect("setup");
    let [offer] = &offers(text.as_bytes(), &setup, None)[..] else { panic!("one offer") };
    assert_eq!(offer.span, Span::new(11, text.find("X100").expect("X100") - 1));
    assert_eq!((offer.code.as_str(), offer.passes), ("G90", 2));
    assert_eq!(offer.title(Language::English), "Write these 2 passes as G90");
    assert_eq!(offer.title(Language::Chinese), "将这 2 刀写成 G90");
    assert_eq!(offer.title(Language::Russian), "Записать эти проходы (2) циклом G90");
    assert_eq!(offer.written(text.as_bytes()), "G90 X26 Z-30 F0.1\nX24");
}

/// For every program, an offer changes no motion, and an expanded program gets its cycles back.
#[test]
fn no_offer_changes_a_motion() {
    let (mut tried, mut back) = (0, 0);
    for program in fixtures::all() {
        let setup = Setup::from_json(&program.setup).expect(&program.id);
        let plain = gcode_playground::expand::expand(program.text.as_bytes(), &setup);
        for (text, is_plain) in [(&program.text, false), (&plain, true)] {
            for offer in offers(text.as_bytes(), &setup, None) {
                let changed = applied(text.as_bytes(), &offer.edits);
                same(text, &String::from_utf8_lossy(&changed), &setup);
                tried += 1;
                back += usize::from(is_plain);
            }
            let (all, _) = rewritten(text.as_bytes(), &setup);
            same(text, &String::from_utf8_lossy(&all), &setup);
        }
    }
    assert!(tried >= 10 && back >= 8, "only {tried} offers, {back} of written out programs");
}

/// Fragments that often, but not always, form a cycle, with code that may come between and after them.
fn piece() -> impl Strategy<Value = String> {
    let depth = prop::sample::select(vec![
        "G0 X50",
        "X46",
        "U-8",
        "G0 X58 (IN)",
        "Z-2",
        "G0 W-4",
        "N5 X44",
        "G0 X66",
        "/X50",
    ]);
    let cut = prop::sample::select(vec![
        "G1 Z-30 F0.2",
        "G1 X54 W-20",
        "G1 X20",
        "G32 Z-20 F2",
        "G1 U4 Z-10 F.1",
        "G1 Z-30",
        "G32 X52 Z-20",
    ]);
    let out = prop::sample::select(vec!["X60", "G0 X60", "Z2", "X60 F0.3", "U10", "G1 X60 (OUT)", "G0 Z2"]);
    let back = prop::sample::select(vec!["G0 Z2", "Z2", "G0 X60", "G0 W32", "G0 X60 Z2"]);
    let other = prop::sample::select(vec![
        "X70",
        "G0 X60 Z2",
        "M08",
        "G1 X58",
        "(NOTE)",
        "",
        "T0202",
        "G42",
        "G40",
        "G20",
        "G21",
        "G90 X40 Z-9",
        "#1=#1+1",
        "IF[#1LT3]GOTO5",
        "WHILE[#1LT2]DO1",
        "END1",
        "G98",
        "M98 P7",
        "G71 U1 R1",
        "G71 P5 Q6 U1 W1 F.2",
        "N6 Z-5",
        "G28 U0",
        "%",
    ]);
    let four =
        (depth, cut, out, back).prop_map(|(depth, cut, out, back)| format!("{depth}\n{cut}\n{out}\n{back}"));
    prop_oneof![4 => four, 1 => other.prop_map(String::from)]
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, failure_persistence: None, ..ProptestConfig::default() })]

    /// For random programs, an offer changes no motion, and there are no further offers after it.
    #[test]
    fn no_program_moves_otherwise(pieces in prop::collection::vec(piece(), 0..12), ends in prop::sample::select(vec!["\n", ";\n", "\r\n", ";"])) {
        let text = format!("G0 X60 Z2\n{}\nM30\nO7\nX60\nM99\n", pieces.join("\n")).replace('\n', ends);
        let limits = r#""limits": {"motions": 2000, "repeatedBlocks": 2000, "rounds": 100}"#;
        let setup = Setup::from_json(&format!(r#"{{"initial": {{"x": 100, "z": 50}}, {limits}}}"#)).expect("setup");
        for offer in offers(text.as_bytes(), &setup, None) {
            same(&text, &String::from_utf8_lossy(&applied(text.as_bytes(), &offer.edits)), &setup);
        }
        let (all, _) = rewritten(text.as_bytes(), &setup);
        same(&text, &String::from_utf8_lossy(&all), &setup);
        prop_assert_eq!(rewritten(&all, &setup).1, []);
    }

    /// No input bytes cause a panic.
    #[test]
    fn no_bytes_break_it(bytes in prop::collection::vec(prop::sample::select(b"GXZUWFNPQ0123. -\n;()/#=[]IFDOEND\r\xff".to_vec()), 0..300)) {
        rewritten(&bytes, &Setup::default());
    }
}
