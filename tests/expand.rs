//! The output of `expand` does the same as the program: the same motions at the same feed and speed, with the
//! same tool and spindle direction, and without additional messages.
#[path = "random_programs/shop.rs"]
pub mod shop;

use crate::fixtures;
use crate::format;
use crate::random_programs;
use std::collections::BTreeSet;

use gcode_playground::control::interpreter::Executed;
use gcode_playground::expand::expand;
use gcode_playground::limits::Limits;
use gcode_playground::message::Severity;
use gcode_playground::motion::{Feed, Motion, MotionKind, Step};
use gcode_playground::run::{Analysis, Run};
use gcode_playground::sentences::Language;
use gcode_playground::setup::Setup;
use gcode_playground::{analyze, api};
use proptest::prelude::*;
use random_programs::{any_setup, program};
use serde_json::{Map, Value};
use shop::{mistyped, shop_program};

/// Rows of the motions as the API returns them, without their origin.
fn rows(analysis: &Analysis) -> Vec<Map<String, Value>> {
    let row = |row| match serde_json::to_value(row).expect("row") {
        Value::Object(mut row) => {
            // For moves other than thread cuts, the lead is that of the cycle.
            if row.get("kind").is_none_or(|kind| kind != "thread") {
                row.remove("lead");
            }
            // These follow from end points, feed and speed, which are compared.
            if row.get("kind").is_none_or(|kind| kind != "dwell") {
                for key in ["seconds", "rpm", "feed"] {
                    row.remove(key);
                }
            }
            for key in ["line", "cycle", "pass", "step", "programmed"] {
                row.remove(key);
            }
            row
        }
        other => panic!("{other}"),
    };
    api::motions(&analysis.motions, &analysis.setup.machine).map(row).collect()
}

/// Whether two values are equal, lengths within the three decimals that are written.
fn alike(one: &Value, other: &Value) -> bool {
    match (one, other) {
        (Value::Object(one), Value::Object(other)) => {
            one.len() == other.len()
                && one.iter().all(|(key, value)| other.get(key).is_some_and(|other| alike(value, other)))
        }
        (Value::Number(one), Value::Number(other)) => {
            let (one, other) = (one.as_f64().unwrap_or(f64::NAN), other.as_f64().unwrap_or(f64::NAN));
            (one - other).abs() <= 0.0021 + 1e-3 * one.abs()
        }
        (one, other) => one == other,
    }
}

/// The first difference between a program and its expansion, if any.
fn difference(program: &str, setup: &Setup) -> Option<String> {
    let plain = expand(program.as_bytes(), setup);
    let (before, after) = (analyze(program.as_bytes(), setup), analyze(plain.as_bytes(), setup));
    let what = other_motions(&before, &after).or_else(|| more_reported(&before, &after))?;
    Some(format!("{what}\n{program}\n-- written out:\n{plain}"))
}

/// The first difference between the motions of two runs. A move that vanishes by rounding may be missing in
/// one of them.
fn other_motions(before: &Analysis, after: &Analysis) -> Option<String> {
    let (own, written) = (rows(before), rows(after));
    let (mut at, mut at_other) = (0, 0);
    loop {
        let why = match (own.get(at), written.get(at_other)) {
            (None, None) => return None,
            (Some(one), Some(other)) => {
                let motions = [before.motions.get(at), after.motions.get(at_other)];
                let Some(why) = other_motion([one, other], &motions) else {
                    (at, at_other) = (at + 1, at_other + 1);
                    continue;
                };
                format!("motion {at}: {why}")
            }
            _ => format!("{} motions, not {}", written.len(), own.len()),
        };
        if at < own.len() && may_be_lost(&before.motions.get(at)) {
            at += 1;
        } else if at_other < written.len() && may_be_lost(&after.motions.get(at_other)) {
            at_other += 1;
        } else {
            return Some(why);
        }
    }
}

/// Whether a move may vanish by rounding to 0.001 mm.
fn may_be_lost(motion: &Motion) -> bool {
    motion.kind != MotionKind::Dwell && motion.rotary.is_none() && motion.length() < 2.5e-3
}

/// The difference between two motions and their rows, if any.
fn other_motion([row, other_row]: [&Map<String, Value>; 2], [motion, other]: &[Motion; 2]) -> Option<String> {
    let (row, other_row) = (Value::Object(row.clone()), Value::Object(other_row.clone()));
    if !alike(&row, &other_row) {
        return Some(format!("{other_row}\n  not {row}"));
    }
    let (a, b) = (motion.process, other.process);
    if (a.turn, a.tool, a.clamp, a.speed) != (b.turn, b.tool, b.clamp, b.speed) {
        return Some(format!("{b:?}\n  not {a:?}"));
    }
    let same_feed = match (a.feed, b.feed) {
        (Feed::PerMinute(a), Feed::PerMinute(b)) | (Feed::PerTurn(a), Feed::PerTurn(b)) => {
            (a - b).abs() < 1e-4 * (1.0 + a)
        }
        (a, b) => a == b,
    };
    let is_fed = !matches!(motion.kind, MotionKind::Rapid | MotionKind::Dwell | MotionKind::Thread);
    (!same_feed && is_fed).then(|| format!("{:?} not {:?}", b.feed, a.feed))
}

/// An error or warning that appears only in the expanded program.
fn more_reported(before: &Analysis, after: &Analysis) -> Option<String> {
    // The sign is not checked for a cycle that returns at feed, but for its expanded moves.
    let returns = before.motions.iter().any(|motion| {
        motion.kind == MotionKind::Feed && motion.cycle.is_some_and(|step| step.step == Step::Retract)
    });
    let told: BTreeSet<_> = before.diagnostics.iter().map(|told| told.message.slug()).collect();
    let more = after.diagnostics.iter().find(|more| {
        matches!(more.severity, Severity::Error | Severity::Warning)
            && !told.contains(more.message.slug())
            && !(returns && more.message.slug() == "minus-missing")
    });
    let more = more?;
    Some(format!("{}: {}", more.message.slug(), more.message.sentence(Language::English).message))
}

#[track_caller]
fn check_with(setup: &str, program: &str) {
    let setup = Setup::from_json(setup).expect("setup");
    if let Some(why) = difference(program, &setup) {
        panic!("{why}");
    }
}

#[track_caller]
fn check(program: &str) {
    check_with("{}", program);
}

/// Reports all differences together.
#[track_caller]
fn assert_none(slips: &[String]) {
    assert!(slips.is_empty(), "{} programs change:\n{}", slips.len(), slips.join("\n\n"));
}

#[test]
fn the_programs_of_the_gallery_and_the_fixtures_do_the_same() {
    let mut slips = Vec::new();
    for program in fixtures::all() {
        let setup = Setup::from_json(&program.setup).expect(&program.id);
        slips.extend(difference(&program.text, &setup).map(|why| format!("{}: {why}", program.id)));
    }
    assert_none(&slips);
}

#[test]
fn the_corrected_programs_of_the_rule_pages_do_the_same() {
    let (mut slips, mut checked) = (Vec::new(), 0);
    for (name, rule) in format::all(env!("CARGO_MANIFEST_DIR")) {
        let page = rule.expect(&name).page;
        let setup = Setup::from_json(&page.setup).expect(&name);
        slips.extend(difference(&page.right, &setup).map(|why| format!("{name}: {why}")));
        checked += 1;
    }
    assert!(checked > 150, "{checked}");
    assert_none(&slips);
}

/// A contour roughed and finished, with `inside` in its second block and `behind` after the G70.
fn finished(inside: &str, behind: &str) -> String {
    format!(
        "O1\nT0101\nG50 S3000\nG97 S500 M03\nG00 X62 Z2\nG71 U2 R1\nG71 P10 Q20 U0.4 W0.1 F0.3\nN10 G00 X20\n\
         G01 Z-10 {inside}\nX30 Z-20 F0.08\nN20 X60\nG70 P10 Q20\n{behind}G00 X100 Z50\nM30"
    )
}

#[test]
fn what_a_contour_commands_holds_in_its_finishing() {
    for inside in ["S800 F0.1", "G96 S180 F0.1", "G97 S1200 F0.1", "G98 F90", "M04 F0.1", "S800 T0111 F0.1"] {
        check(&finished(inside, ""));
        check(&finished(inside, "G01 X59 F0.2\nZ-5\n"));
        check(&finished(inside, "G97 S400 M03\nG99 G01 X59 F0.2\nZ-5\n"));
    }
    let inches = finished("G96 S180 F0.1", "").replace("O1\n", "O1\nG20\n");
    check(&inches);
    check(&finished("G96 S180 F0.1", "G01 X59\n").replace("G50 S3000", "G50 S3000 Q400"));
}

#[test]
fn a_tap_is_turned_out_again() {
    let program = |start: &str, end: &str| {
        format!("O1\nT0101\nG97 {start}\nG00 X0 Z5\nG84 Z-20 R-2 F1.5{end}\nG80\nG00 Z50\nM30")
    };
    for start in ["S500 M03", "S500 M04"] {
        check(&program(start, ""));
        check(&program(start, "\nZ-25"));
        check(&program(start, " P500"));
    }
    // Rigid tapping starts the spindle.
    check(&program("S500", "").replace("G84", "M29 S500\nG84"));
    // With constant surface speed, both programs get the message.
    check(&program("S500 M03", "").replace("G97", "G50 S2000\nG96"));
}

#[test]
fn a_rounding_may_use_its_move_up() {
    check("O1\nT0101\nG97 S500 M03\nG00 X62 Z2\nG01 X75 F0.1\nZ-0.5\nZ-1 R0.5\nX82\nZ-5\nG00 X100 Z50\nM30");
}

#[test]
fn the_way_home_from_a_compensated_path_stays_the_way_home() {
    let setup = r#"{"tools": {"T0101": {"type": "turning", "noseRadius": 0.4, "tip": 3}}}"#;
    let program = |home: &str| {
        format!(
            "O1\nT0101\nG97 S500 M03\nG00 X62 Z2\nG42 X40 Z1\nG01 Z-10 F0.2\nX50 Z-20\nX64\nG40\n{home}\nT0202\n\
             G00 X60 Z2\nG28 U0 W0\nM30"
        )
    };
    for home in ["G28 U0 W0", "G28 U0", "G28 X70", "G28 U0\nG28 W0", "G30 P2 U0 W0"] {
        check_with(setup, &program(home));
    }
}

#[test]
fn moves_along_y_stay_as_they_are() {
    let head = "O1\n(MACHINE YAXIS=TRUE)\n(TOOL T0101 CUTTER=5 OFFSETR=5)\nM45\nG28 H0\nT0101\nG97 S1000 M13\nG98 G00 X100 Z5\n";
    for blocks in [
        "G17\nG01 X40 F100\nG03 X0 Y20 I-20\nG01 Y0",
        "G17\nG01 Z-5 F100\nG41 X40 Y-30\nY20\nX-40\nG40 X-60 Y40\nG00 Z50\nY0",
        "G17\nG41\nG01 Z-5 F100\nX40 Y-30\nY20,R3\nX-40\nG40\nX-60 Y40\nG00 Z50\nY0",
        "G00 X60 Y10 C90\nG01 Z-3 F100\nX30\nG28 V0",
        "G19\nG01 Z-10 F100\nG02 Y10 Z-20 K-10\nG00 X120\nG18 Y0\nG90 X80 Z-5",
    ] {
        check(&format!("{head}{blocks}\nM46\nM30\n"));
    }
}

#[test]
fn flank_infeed_of_a_taper_thread_is_no_moved_start() {
    check(
        "O1\nT0101\nG97 S500 M03\nG00 X34 Z5\nG76 P010060 Q100 R0.05\nG76 X30 Z-20 R-1.2 P1300 Q300 F2\n\
         G00 X80 Z20\nM30",
    );
}

/// The same F value is another feed rate after G98 and G99.
#[test]
fn a_cycle_that_changes_how_f_counts_names_its_feed_rate_again() {
    for (before, after, feed) in [("G98", "G99", "F0.25"), ("G99", "G98", "F80")] {
        for cycle in ["G94 X30 Z-1", "G90 X50 Z-10", "G74 R1\nG74 Z-10 Q3000", "G01 X30"] {
            check(&format!(
                "O1\nT0101\nG97 S500 M03\nG00 X62 Z2\n{before} G01 X61 {feed}\nX62\n{cycle} {after} {feed}\nG00 X80 Z20\nM30"
            ));
        }
    }
}

/// Words that a cycle ignores stay without effect.
#[test]
fn what_a_cycle_ignores_is_a_remark() {
    for cycle in ["G90 X40 Z-20 F0.2", "G92 X40 Z-20 F2", "G94 X40 Z-1 F0.2"] {
        for ignored in ["C25", "H1", "C25 M08", "R-1", "I2", "Y3"] {
            check(&format!(
                "O1\nT0101\nG97 S500 M03\nG00 X50 Z2\n{cycle}\n{ignored}\nX36\nG00 X100 Z100\nM30"
            ));
        }
    }
    let plain = expand(
        b"O1\nT0101\nG97 S500 M03\nG00 X50 Z2\nG90 X40 Z-20 F0.2\nC25\nG00 X90\nM30",
        &Setup::default(),
    );
    assert!(plain.contains("\n(C25)\n"), "{plain}");
    let analysis = analyze(
        b"O1\nT0101\nG97 S500 M03\nG00 X50 Z2\nG90 X40 Z-20 F0.2\nC25\nG00 X90\nM30",
        &Setup::default(),
    );
    let ignored = analysis.diagnostics.iter().find(|told| told.message.code() == "W-WORD-IGNORED");
    assert_eq!(
        ignored.map(|told| told.span.quote(b"O1\nT0101\nG97 S500 M03\nG00 X50 Z2\nG90 X40 Z-20 F0.2\nC25")),
        Some("C25".to_owned())
    );
}

/// A block without a code of group 01 keeps the code that was active when it was read.
#[test]
fn a_block_goes_by_the_code_of_the_program() {
    let program = |middle: &str| {
        format!("O1\nT0101\nG97 S500 M13\nM45\nG00 X50 Z2\nG98 G01 X40 F100\n{middle}\nG00 X100 Z100\nM30")
    };
    for middle in [
        "G28 U0\nC5",
        "G28 U0\nH5",
        "G28 U0 W0\nX40 Z1",
        "G30 P2 U0\nC5",
        "G53 X0\nC5",
        "G01 Z-5 ,R1\nX44\nC5",
        "G42 X38 Z1\nG01 Z-5\nG40 X44\nH5",
        "G90 X36 Z-9\nG01 X44\nC5",
        "G90 X36 Z-9\nG01\nC5",
        "G50 X40 Z2\nC5",
    ] {
        check(&program(middle));
    }
    assert!(expand(program("G28 U0\nC5").as_bytes(), &Setup::default()).contains("\nC5\n"));
}

/// Code that depends on an unsupported block stays as written, and uncertain.
#[test]
fn what_is_uncertain_stays_uncertain() {
    let corner = "G01 X40 Z0 ,R1 F0.1\nZ-21.42 ,R3.5\nX43.8 Z-23.36 ,A-146\nA89\nZ-30\nX60";
    let rough = "G71 U1 R0.5\nG71 P10 Q20 U0.4 W0.1 F0.3\nN10 G00 X20\nG01 Z-9\nN20 X50";
    for middle in [
        corner.to_owned(),
        "G01 Z-5 F0.1\nX4O\nG90 X40 Z-20\nX36\nG00 X60 Z5".to_owned(),
        "G90 X40 Z-20 F0.2\nX3O\nX34\nG00 X60 Z5\nG90 X40 Z-20\nX36".to_owned(),
        format!("G00 X6O\n{rough}\nG70 P10 Q20"),
        format!("{rough}\nG00 X6O\nG70 P10 Q20"),
        "G83 X44 C25\nG00 Z9".to_owned(),
        "G00 X0 Z5\nG83 Z-20 R-2 Q5000 F0.1\nZ-3O\nZ-25\nG80\nG00 X60".to_owned(),
        "M98 P7\nZ-5\nG90 X40 Z-20 F0.2\nX36".to_owned(),
        "#1=FOO[2]\nG01 X#1 F0.1\nZ-5\nX60".to_owned(),
        "G01 X40 Z-5 F0.1 ,C1\nZ-5.2.1\nX60\nG90 X40 Z-20".to_owned(),
    ] {
        for unit in ["", "G20\n"] {
            check(&format!("O1\n{unit}T0101\nG97 S500 M03\nG00 X50 Z2\n{middle}\nG00 X100 Z100\nM30"));
        }
    }
}

/// A contour at the end of the text is removed like any other.
#[test]
fn a_contour_at_the_end_is_left_out() {
    check("O1\nT0101\nM03 S500\nG00 X30 Z2\nG72 W1 R.5\nG72 P1 Q2 F0.2\nN1 G00 Z-9\nG01 X20\nN2 Z2\n");
}

/// Empty blocks need no memory, and other blocks little.
#[test]
fn blocks_of_a_long_text_need_little_memory() {
    let run = |text: String| {
        let mut run = Run::new(text.into_bytes(), Setup::default()).traced();
        while !run.advance(usize::MAX) {}
        run.into_analysis()
    };
    assert_eq!(run("\n".repeat(100_000)).trace.len(), 1);
    assert_eq!(run("M8\n\n\n".repeat(1_000)).trace.len(), 1_000);
    assert!(size_of::<Executed>() <= 80, "{}", size_of::<Executed>());
}

/// Blocks that change feed, speed, tool or spindle.
fn technology() -> impl Strategy<Value = String> {
    let whole =
        |letter: &'static str, low: u32, high: u32| (low..high).prop_map(move |n| format!("{letter}{n}"));
    prop_oneof![
        3 => Just(String::new()),
        2 => whole("S", 100, 2000),
        1 => whole("G96 S", 80, 300),
        1 => whole("G97 S", 200, 1500),
        2 => (5u32..40).prop_map(|n| format!("F0.{n:02}")),
        1 => Just("G98 F80".to_owned()),
        1 => Just("G99 F0.25".to_owned()),
        1 => Just("M04".to_owned()),
        1 => Just("M03".to_owned()),
    ]
}

/// An operation from X60 Z5 and back.
fn operation() -> impl Strategy<Value = String> {
    let contour = (technology(), technology(), technology(), technology()).prop_map(|(a, b, c, d)| {
        format!(
            "G00 X62 Z2\nG71 U3 R1\nG71 P10 Q20 U0.4 W0.1 F0.3\nN10 G00 X20 {a}\nG01 Z-10 F0.1 {b}\nX30 Z-20 {c}\n\
             N20 X61 {d}\nG70 P10 Q20\nG01 X59 F0.2\nZ-5\nX62\n"
        )
    });
    prop_oneof![
        3 => contour,
        1 => technology().prop_map(|a| format!("G00 X62 Z2\nG90 X56 Z-10 F0.2 {a}\nX52\nG00 X64\n")),
        1 => technology().prop_map(|a| format!("G00 X62 Z2\nG94 X30 Z-1 F0.2 {a}\nZ-2\nG00 X64\n")),
        1 => Just("G97 S500 M03\nG00 X0 Z5\nG84 Z-20 R-2 F1.5\nZ-25\nG80\n".to_owned()),
        1 => Just("G97 S500 M04\nG00 X0 Z5\nG84 Z-20 R-2 F1.5 P500\nG80\n".to_owned()),
        1 => technology().prop_map(|a| format!("G00 X0 Z5\nG83 Z-20 R-2 Q5000 F0.1 {a}\nG80\n")),
        1 => technology().prop_map(|a| format!("G00 X62 Z2\nG01 X40 ,C2 F0.2 {a}\nZ-20 ,R3\nX62\n")),
        1 => Just("G97 S500 M03\nG00 X32 Z5\nG92 X29 Z-20 F3\nX28.5\nG00 X62\n".to_owned()),
        1 => Just("G97 S500 M03\nG00 X32 Z5\nG76 P010060 Q100 R0.05\nG76 X27.4 Z-20 P1300 Q300 F2\nG00 X62\n".to_owned()),
    ]
}

proptest! {
    #[test]
    fn generated_programs_do_the_same(
        operations in prop::collection::vec((technology(), operation()), 1..4), inches in any::<bool>(),
    ) {
        let unit = if inches { "G20" } else { "G21" };
        let mut program = format!("O1\n{unit} G99 T0101\nG50 S2500\nG97 S600 M03\nG00 X80 Z20 F0.2\n");
        for (index, (between, operation)) in operations.iter().enumerate() {
            let operation = operation.replace("N10", &format!("N{}10", index + 1)).replace("N20", &format!("N{}20", index + 1));
            let operation = operation.replace("P10 Q20", &format!("P{0}10 Q{0}20", index + 1));
            program += &format!("{between}\n{operation}G00 X80 Z20\n");
        }
        program += "M05\nM30\n";
        // In inches the numbers would be unusually large, so the notation is fixed.
        let setup = Setup::from_json(r#"{"dialect": {"decimal": "calculator"}}"#).expect("setup");
        let why = difference(&program, &setup);
        prop_assert!(why.is_none(), "{}", why.unwrap_or_default());
    }
}

/// Valid and invalid programs of every kind, each with a setup.
fn any_program() -> impl Strategy<Value = (String, Setup)> {
    let shop = prop_oneof![shop_program(), mistyped(shop_program())];
    prop_oneof![
        4 => (shop, Just(Setup::default())),
        1 => (program(), any_setup()),
    ]
}

proptest! {
    // `PROPTEST_CASES` can request more.
    #![proptest_config(ProptestConfig { cases: ProptestConfig::default().cases.max(2000), ..ProptestConfig::default() })]

    /// The same motions, with the same uncertain marks, for any faulty program.
    #[test]
    fn any_program_does_the_same((text, setup) in any_program()) {
        let limits = Limits { motions: 3000, repeated_blocks: 2000, rounds: 500, macro_steps: 2000, ..setup.limits };
        let setup = Setup { limits, ..setup };
        let plain = expand(text.as_bytes(), &setup);
        let other = other_motions(&analyze(text.as_bytes(), &setup), &analyze(plain.as_bytes(), &setup));
        prop_assert!(other.is_none(), "{}\n{text}\n-- expanded:\n{plain}", other.unwrap_or_default());
    }
}

/// Seven passes by U and W: the rounding of their ends does not add up.
#[test]
fn the_rounding_of_increments_does_not_add_up() {
    check(
        "O1\nG21 G99 T0101\nG97 S800 M03\nG00 X62. Z5.\nG180G00 X62. Z2.\nG72 W1. R.5\nG72 P10 Q20 U.4 W.1 F.3\n\
         N10 G00 X20.\nG01 X54.5 Z-2\nN20 X60.\nG00 X100. Z100.\nM30\n",
    );
}

/// Codes in the block of the program number of a subprogram stay in force.
#[test]
fn codes_beside_the_number_of_a_subprogram_hold() {
    for head in ["O2 G55", "O2RG55", "O2 G98 F100.", "O2 G01 X40."] {
        check(&format!(
            "O1\nT0101\nG97 S500 M03\nG00 X50. Z2. F0.2\nM98 P2\nG00 X20.\nG90 X18. Z-5. F.2\nG00 X60.\nM30\n{head}\nG00 X14.25\nM99\n"
        ));
    }
}

#[test]
fn a_lead_by_e_holds_after_an_expanded_thread() {
    let head = "O1\nT0303\nG99 G97 S300 M03\nG00 X34 Z8\nG01 X33 F0.2\nG00 X34\n";
    let setup = Setup::default();
    for body in [
        // The cut between the threads has the earlier F, the thread after it the lead by E.
        "G92 X29.2 Z-20 E1.5\nX28.6\nG00 X34\nG01 Z5\nG00 X28\nG32 Z-20\nG00 X34",
        "G92 X29.2 Z-20 E1.5\nG00 X34\nG32 Z-20\nG01 Z5\nG00 X34\nG32 Z-20\nG00 X34",
        // The E of a copied thread, and another one of an expanded thread.
        "G32 Z-20 E2\nG00 X34\nG01 Z5\nG92 X29.2 Z-20 E1.5\nG00 X34\nG32 Z-20 E2\nG01 Z5\nG32 Z-20\nG00 X34",
        "G32 Z-20 E2\nG00 X34\nZ5\nG32 Z-20\nG92 X29.2 Z-20\nG00 X34\nG32 Z-25\nG01 Z5\nG32 Z-25\nG00 X34",
    ] {
        let program = format!("{head}{body}\nM30\n");
        assert!(expand(program.as_bytes(), &setup).contains("(G92 PASS 1)"), "{body}");
        assert_eq!(difference(&program, &setup), None);
        let leads = |text: &str| -> Vec<_> {
            let threads = analyze(text.as_bytes(), &setup).motions;
            threads
                .iter()
                .filter(|motion| motion.kind == MotionKind::Thread)
                .map(|motion| motion.lead)
                .collect()
        };
        assert_eq!(leads(&program), leads(&expand(program.as_bytes(), &setup)), "{body}");
    }
}

/// Each pass is written with its start angle: Q, and L on GSK.
#[test]
fn starts_of_a_thread_have_their_angle() {
    let program = "O1\nT0303\nG97 S300 M03\nG00 X34 Z8\nG92 X29.2 Z-20 F4 L2\nX29.2 Q90000\nG00 X34\nM30\n";
    let setup = Setup::from_json(r#"{"dialect": {"control": "gsk"}}"#).expect("a setup");
    assert_eq!(difference(program, &setup), None);
    let plain = expand(program.as_bytes(), &setup);
    let angles: Vec<_> = plain
        .lines()
        .filter(|line| line.starts_with("G32"))
        .filter_map(|line| line.split_once(" Q"))
        .map(|(_, q)| q)
        .collect();
    assert_eq!(angles, ["180000", "90000"], "{plain}");
}
