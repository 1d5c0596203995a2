//! Each word of a block is used, explained or reported. The expected results are derived by hand from FANUC's
//! formats of the codes (B-64304EN, B-64604EN), not from the output of the program.
use gcode_playground::analyze;
use gcode_playground::message::Severity;
use gcode_playground::setup::Setup;

const HEAD: &str = "O0001 (STOCK D=50 LENGTH=80)\nT0101\nG97 G99 S800 M03 F0.2\nG00 X52 Z2\n";
const CONTOUR: &str = "N10 G00 X40\nG01 Z-20\nN20 X52\n";

/// The messages at one word, which is appended to a block.
#[track_caller]
fn said_about(setup: &str, before: &str, block: &str, word: &str, after: &str) -> Vec<String> {
    let text = format!("{HEAD}{before}{block} {word}\n{after}G00 X200 Z200\nM30\n");
    let setup = Setup::from_json(setup).expect("a setup");
    let analysis = analyze(text.as_bytes(), &setup);
    let at = (HEAD.len() + before.len() + block.len() + 1) as u32;
    let about = |span: &gcode_playground::source::Span| span.start == at;
    let found = analysis.diagnostics.iter().filter(|told| about(&told.span));
    let found: Vec<String> = found.map(|told| told.message.slug().to_owned()).collect();
    let without = text.replacen(&format!("{block} {word}\n"), &format!("{block}\n"), 1);
    let without = analyze(without.as_bytes(), &setup);
    let is_error = |of: &gcode_playground::run::Analysis| of.diagnostics.iter().any(|told| told.is_error());
    if !found.is_empty() && !is_error(&analysis) {
        assert!(!is_error(&without), "{block}");
        assert_eq!(analysis.motions.len(), without.motions.len(), "{block} {word}");
        for index in 0..without.motions.len() {
            let [one, other] = [&analysis, &without].map(|of| of.motions.get(index).to);
            assert_eq!(one, other, "{block} {word}");
        }
    }
    found
}

/// Checks that each letter appended to a correct block is reported at its position.
#[track_caller]
fn all_are_reported(before: &str, block: &str, letters: &str, after: &str) {
    for letter in letters.chars() {
        let found = said_about("{}", before, block, &format!("{letter}3"), after);
        assert!(!found.is_empty(), "{block} {letter}3: nothing is said");
        assert_eq!(found.len(), 1, "{block} {letter}3: {found:?}");
    }
}

#[test]
fn words_that_a_move_does_not_read_are_reported() {
    all_are_reported("", "G00 X48 Z1", "ABDEIJKLPQR", "");
    all_are_reported("", "G01 X48 Z1", "BDEJLPQ", "");
    all_are_reported("", "G02 X54 Z1 R5", "ABCDEHIJKLPQ", "");
    all_are_reported("", "G02 X54 Z1 I1 K0", "ABCDEHLPQ", "");
    all_are_reported("", "G32 Z-20 F2", "ABDHIJKLP", "");
}

#[test]
fn words_that_a_single_cycle_does_not_read_are_reported() {
    all_are_reported("", "G90 X48 Z-20", "ABDEJKLPQ", "");
    all_are_reported("", "G92 X48 Z-20 F2", "ABDJKLP", "");
    all_are_reported("", "G94 X40 Z0", "ABDEIJLPQ", "");
    all_are_reported("G90 X48 Z-20\n", "X46", "ABDEJKLPQ", "");
}

#[test]
fn words_that_a_multiple_cycle_does_not_read_are_reported() {
    let second = format!("G71 P10 Q20 U0.5 W0.1\n{CONTOUR}");
    all_are_reported("", "G71 U2 R1", "ABCDEHIJKLVXYZ", &second);
    let second = "G72 P10 Q20 U0.5 W0.1\nN10 G00 Z-20\nG01 X40\nN20 Z2\n";
    all_are_reported("", "G72 W2 R1", "ABCDEHIJKLVXYZ", second);
    all_are_reported("G71 U2 R1\n", "G71 P10 Q20 U0.5 W0.1", "ABCEHIJKLRVY", CONTOUR);
    all_are_reported("G73 U2 W2 R3\n", "G73 P10 Q20 U0.5 W0.1", "ABCEHIJKLRVY", CONTOUR);
    let roughed = format!("G71 U2 R1\nG71 P10 Q20 U0.5 W0.1\n{CONTOUR}");
    all_are_reported(&roughed, "G70 P10 Q20", "ABCDEHIJKLRUVWY", "");
    all_are_reported("", "G75 R1", "ABCDEHIJKLPQVY", "G75 X40 Z-10 P2000 Q2000\n");
    all_are_reported("G75 R1\n", "G75 X40 Z-10 P2000 Q2000", "ABCDEHJLVY", "");
    all_are_reported("G74 R1\n", "G74 X40 Z-10 P2000 Q2000", "ABCDEHJLVY", "");
    let second = "G76 X27.4 Z-20 P1300 Q400 F2\n";
    all_are_reported("G00 X32\n", "G76 P020060 Q50 R0.02", "ABCDEHIJKLVY", second);
    all_are_reported("G00 X32\nG76 P020060 Q50 R0.02\n", "G76 X27.4 Z-20 P1300 Q400 F2", "ABCDHIJLVY", "");
}

#[test]
fn words_that_a_single_move_of_the_machine_does_not_read_are_reported() {
    all_are_reported("", "G53 X0 Z0", "BDEIJKLPQRUW", "");
    all_are_reported("", "G28 U0 W0", "ABDEIJKLPQR", "");
    all_are_reported("", "G04 X1", "ABCDEHIJKLPQRUYZ", "");
    all_are_reported("", "G50 S2000", "ABDEIJKLR", "");
}

/// If X gives the time of a dwell, P is not read. Of C and H only one takes effect.
#[test]
fn a_word_beside_another_of_the_same_meaning_is_reported() {
    let text = |block: &str| format!("{HEAD}G28 H0\n{block}\nG00 X200 Z200\nM30\n");
    assert_eq!(slugs(&text("G04 P500 X1")), ["word-without-effect"]);
    assert_eq!(slugs(&text("G04 X1 U2")), ["word-without-effect"]);
    assert_eq!(slugs(&text("G00 C90 H10")), ["absolute-and-incremental"]);
    assert_eq!(slugs(&text("G01 Z1 C90 H10")), ["absolute-and-incremental"]);
    let analysis = analyze(text("G00 C90 H10").as_bytes(), &Setup::default());
    let turned: Vec<_> = (0..analysis.motions.len())
        .filter_map(|index| analysis.motions.get(index).rotary)
        .map(|rotary| (rotary.from, rotary.to))
        .collect();
    // FANUC takes the later word.
    assert_eq!(turned, [(0.0, 10.0)]);
}

/// F in G00, S, T, D of G41, P beside M and S, arguments and data are read later, or by codes that are
/// unknown here.
#[test]
fn words_that_are_read_elsewhere_are_not_reported() {
    for (block, word) in [
        ("G00 X48 Z1", "F0.3"),
        ("G00 X48 Z1", "S900"),
        ("G42 G00 X48 Z1", "D1"),
        ("G00 X48 Z1 M03", "P11"),
        ("G97 S900", "P1"),
        ("G96 S100", "P1"),
        ("G54 G00 X48", "P1"),
        ("M200", "B5"),
        ("M19", "R90"),
        ("G22 X50 Z50", "I10"),
        ("G10 L2 P1", "Z0"),
        ("G40 G00 X60 Z5 I10", "K0"),
        ("G01 X48", "A170"),
        ("G32 Z-20 F2", "Q90000"),
        ("G92 X48 Z-20 F2", "R-1"),
        ("G83 Z-20 R3", "K2"),
        ("G83 Z-20 R3", "P500"),
        ("G30 U0 W0", "P2"),
        ("G04", "U1"),
        ("G50 X52", "Z2"),
    ] {
        let found = said_about("{}", "", block, word, "");
        let found: Vec<_> = found
            .iter()
            .filter(|slug| matches!(slug.as_str(), "word-without-effect" | "axis-not-supported"))
            .collect();
        assert!(found.is_empty(), "{block} {word}: {found:?}");
    }
    let gsk = r#"{"dialect": {"control": "gsk", "feedMode": "G99"}}"#;
    for (block, word) in
        [("G92 X48 Z-20 F2", "L2"), ("G92 X48 Z-20 F2 K2", "J2"), ("G32 Z-20 F2 J2", "K2"), ("G01 X48", "L1")]
    {
        let found = said_about(gsk, "", block, word, "");
        assert!(!found.iter().any(|slug| slug == "word-without-effect"), "{block} {word}: {found:?}");
    }
}

/// F, S and T of a contour are read by G70, its other words by the moves.
#[test]
fn words_of_a_contour_are_reported_once() {
    let blocks =
        "G71 U2 R1\nG71 P10 Q20 U0.5 W0.1\nN10 G00 X40 F0.1 S900\nG01 Z-20 E3\nN20 X52\nG70 P10 Q20\n";
    let text = format!("{HEAD}{blocks}G00 X200 Z200\nM30\n");
    let analysis = analyze(text.as_bytes(), &Setup::default());
    let found: Vec<_> =
        analysis.diagnostics.iter().filter(|told| told.message.slug() == "word-without-effect").collect();
    assert_eq!(found.len(), 1, "{found:?}");
}

/// B of a sub-spindle and A of a rotary tool head: one note per axis; G28 and G30 contain an axis.
#[test]
fn axes_that_are_not_shown_are_noted_once_each() {
    for block in ["G00 B-300", "G53 B-500", "G28 B0", "G28 A0", "G30 P2 B0", "G00 X60 B5", "G50 B0", "B90"] {
        let text = format!("{HEAD}{block}\n{block}\nG00 X200 Z200\nM30\n");
        let analysis = analyze(text.as_bytes(), &Setup::default());
        let slugs: Vec<_> = analysis.diagnostics.iter().map(|told| told.message.slug()).collect();
        let notes = slugs.iter().filter(|slug| **slug == "axis-not-supported").count();
        assert_eq!(notes, 1, "{block}: {slugs:?}");
        assert!(!slugs.contains(&"g28-without-axis"), "{block}");
        assert!(
            analysis.diagnostics.iter().all(|told| told.severity == Severity::Info),
            "{block}: {slugs:?}"
        );
    }
    let text = format!("{HEAD}G00 B5 A5\nA10\nB10\nG00 X200 Z200\nM30\n");
    let analysis = analyze(text.as_bytes(), &Setup::default());
    let notes = analysis.diagnostics.iter().filter(|told| told.message.slug() == "axis-not-supported");
    assert_eq!(notes.count(), 2);
}

fn slugs(text: &str) -> Vec<&'static str> {
    let analysis = analyze(text.as_bytes(), &Setup::default());
    analysis.diagnostics.iter().map(|told| told.message.slug()).collect()
}

/// Compensation with an unknown radius shows the programmed path: one note per offset, none if the radius is
/// known.
#[test]
fn an_unknown_nose_radius_is_noted_once_for_each_offset() {
    let program = |comment: &str| {
        format!(
            "O0001 (STOCK D=50 LENGTH=80)\nT0101 {comment}\nG97 G99 S800 M03\nG00 X54 Z2\nG42 G00 X40\nG01 Z-30 F0.2\nX44 Z-32\nX52\nG40 G00 X60\nM30\n"
        )
    };
    let notes = |text: &str| slugs(text).iter().filter(|slug| **slug == "nose-radius-unknown").count();
    assert_eq!(notes(&program("")), 1);
    assert_eq!(notes(&program("(OD ROUGHING)")), 1);
    assert_eq!(notes(&program("(TOOL T0101 TYPE=TURNING R=0.8 TIP=3)")), 0);
    assert_eq!(notes(&program("(TOOL T0101 INSERT=CNMG120408)")), 0);
    assert_eq!(notes(&program("").replace("G97 G99", "G10 P1 R0.8 Q3\nG97 G99")), 0);
    assert_eq!(notes(&program("").replace("G42 ", "")), 0);
    let second = program("").replace("M30", "T0202\nG42 G00 X40\nG01 Z-30\nG40 G00 X60\nM30");
    assert_eq!(notes(&second), 2);
}

/// A floating holder compensates a difference of the leads: no control raises an alarm.
#[test]
fn another_lead_of_a_tap_that_comes_out_is_a_warning() {
    let text = "O0001 (STOCK D=40 LENGTH=60)\nT0606 (M12)\nG97 S200 M03\nG00 X0 Z6\nG32 Z-20 F1.75\nM05\nM04\nG32 Z6 F1.5\nG00 X200 Z200\nM30\n";
    let analysis = analyze(text.as_bytes(), &Setup::default());
    let found = analysis.diagnostics.iter().find(|told| told.message.slug() == "tap-lead-changed");
    assert_eq!(found.map(|told| told.severity), Some(Severity::Warning));
}

/// M97 is a call only on Haas, and with P; elsewhere it is a code of the machine builder (`G28 B0 M97`).
#[test]
fn m97_without_p_is_a_code_of_the_machine() {
    let text = |block: &str| format!("{HEAD}{block}\nG00 X200 Z200\nM30\n");
    assert_eq!(slugs(&text("M97")), ["unknown-m-code"]);
    assert_eq!(slugs(&text("M98")), ["call-without-number"]);
    assert_eq!(slugs(&text("M97 P900")), ["sequence-number-not-found"]);
}

/// With another zero point, an arc towards +Z may cut towards its chuck.
#[test]
fn an_arc_in_another_work_coordinate_system_misses_no_minus() {
    let program = |frame: &str| {
        format!(
            "O0001\nT0101\nG97 G99 S800 M03\nG00 X40 Z3\nG01 Z-5 F0.1\nG00 X60 Z10\n{frame}\nG00 X32 Z3\nG01 Z0\nG03 X33.2 Z0.4 I-0.4 K0.4\nG01 X40\nG00 X60 Z10\nM30\n"
        )
    };
    assert!(!slugs(&program("G55")).contains(&"minus-missing"));
}

/// A control ends a comment at the first closing bracket: the rest is not read as words.
#[test]
fn a_bracket_within_a_comment_is_reported_where_text_is_left_over() {
    let text = |comment: &str| format!("O0001\nT0101 {comment}\nG97 S800 M03\nG00 X60 Z5\nM30\n");
    assert_eq!(slugs(&text("(OD TOOL (80 DEG)")), [""; 0]);
    assert_eq!(slugs(&text("(OD (80 DEG) TOOL)")), ["comment-in-comment"]);
    assert_eq!(slugs(&text("; (TURN (LONG CUT) TO Z-20)")), ["comment-in-comment"]);
}

/// One message for a sentence after `;`, even with numbers in it; blocks there are read.
#[test]
fn a_sentence_after_a_semicolon_is_one_fault() {
    let text = |rest: &str| format!("O0001\nT0101\nG97 S800 M03\nG00 X60 Z5 {rest}\nM30\n");
    assert_eq!(slugs(&text("; move 100%, speed 1mm/sec")), ["text-after-semicolon"]);
    assert!(!slugs(&text("; X20 move 100%, speed 1mm/sec")).contains(&"text-after-semicolon"));
    assert_eq!(slugs(&text("; G00 X70")), [""; 0]);
}

/// An S in the next block is not too late if nothing is cut in between.
#[test]
fn a_speed_is_kept_where_a_cut_uses_it() {
    let program = |blocks: &str| {
        format!(
            "O0001 (STOCK D=50 LENGTH=80)\nT0101\nG50 S2000\nG96 G99 S120 M03\nG00 X52 Z2\nG01 X40 F0.2\n{blocks}\nG00 X200 Z200\nM30\n"
        )
    };
    let kept = |blocks: &str| slugs(&program(blocks)).contains(&"speed-kept-in-other-unit");
    assert!(!kept("G97\nS490 M3\nG01 X30"));
    assert!(!kept("G97"));
    assert!(kept("G97\nG01 X30"));
}

/// A bore that narrows towards the chuck: U of the allowance is right, and the start point is wrong.
#[test]
fn no_other_sign_is_offered_for_an_allowance_whose_start_point_is_wrong() {
    let text = "O0001 (STOCK D=100 LENGTH=80)\nT0101\nG97 G99 S800 M03\nG00 X75 Z5\nG71 U1 R0.5\nG71 P10 Q20 U-1 W0.1 F0.2\nN10 G00 X66\nG01 Z-10\nX20 Z-30\nN20 G00 X18\nG00 X200 Z200\nM30\n";
    let analysis = analyze(text.as_bytes(), &Setup::default());
    for told in &analysis.diagnostics {
        assert!(!told.fixes.iter().any(|fix| fix.edits.iter().any(|edit| edit.text == "U1")), "{told:?}");
    }
}

/// Both blocks of a cycle in one: one message, and R of the first block does not become the taper of a
/// thread.
#[test]
fn both_blocks_of_a_cycle_in_one_block_are_one_fault() {
    for block in [
        "G76 P3 Q0.02 R0.005 X20.0 Z-30.0 P2.0 Q0.5 F1.0",
        "G76 P020060 Q100 R0.05 X27.4 Z-20 P1300 Q400 F2",
        "G71 U2 R1 P10 Q20 U0.5 W0.1 F0.2\nN10 G00 X40\nG01 Z-20\nN20 X52",
        "G73 U5 W2 R3 P10 Q20 U0.5 W0.1\nN10 G00 X40\nG01 Z-20\nN20 X52",
        "G75 R1 X40 Z-10 P2000 Q2000 R0",
    ] {
        let text = format!("{HEAD}{block}\nG00 X200 Z200\nM30\n");
        let found: Vec<_> =
            slugs(&text).into_iter().filter(|slug| *slug != "not-checked-behind-fault").collect();
        assert_eq!(found, ["cycle-in-one-block"], "{block}");
    }
    // The second block gets the code of the cycle, wherever it is in the block.
    let text = format!("{HEAD}G71 G99 U2 R1 P10 Q20 U0.5 W0.1 F0.2\nN10 G00 X40\nG01 Z-20\nN20 X52\nM30\n");
    let analysis = analyze(text.as_bytes(), &Setup::default());
    let fixes: Vec<_> = analysis.diagnostics.iter().flat_map(|told| &told.fixes).collect();
    assert!(format!("{fixes:?}").contains(r#""\nG71 ""#), "{fixes:?}");
    let one_block = "G71 P10 Q20 U0.5 W0.1 D2000 F0.2\nN10 G00 X40\nG01 Z-20\nN20 X52";
    assert!(!slugs(&format!("{HEAD}{one_block}\nM30\n")).contains(&"cycle-in-one-block"));
}

/// 30i, 31i and 32i allow corner rounding and chamfers between a line and an arc (B-64304EN, optional
/// chamfering and corner R). Line and arc meet at X30 Z0 at 90°: the arc of R2 has its centre 2 mm from both.
#[test]
fn a_corner_between_a_line_and_an_arc_is_made() {
    let text =
        "O0001\nT0101\nG97 G99 S500 M03\nG00 X20 Z0\nG01 X30 ,R2 F0.2\nG02 X50 Z-20 R25\nG01 X60\nM30\n";
    assert!(!slugs(text).contains(&"corner-without-next-move"), "{:?}", slugs(text));
    let analysis = analyze(text.as_bytes(), &Setup::default());
    let arcs: Vec<_> = (0..analysis.motions.len())
        .map(|index| analysis.motions.get(index))
        .filter_map(|motion| Some((motion.from, motion.to, motion.center?)))
        .collect();
    assert_eq!(arcs.len(), 2);
    for end in [arcs[0].0, arcs[0].1] {
        assert!((end.distance(arcs[0].2) - 2.0).abs() < 1e-6);
    }
    // It ends on the circle of the arc, which continues from there.
    assert!((arcs[0].1.distance(arcs[1].2) - 25.0).abs() < 1e-6);
    assert_eq!(arcs[0].1, arcs[1].0);
    let strict = Setup::from_json(r#"{"dialect": {"strict": true}}"#).expect("a setup");
    let found = analyze(text.as_bytes(), &strict);
    assert!(found.diagnostics.iter().any(|told| told.message.slug() == "corner-without-next-move"));
}

/// Controls support names of variables and PRM: they are not mistakes.
#[test]
fn names_of_variables_and_parameters_are_not_supported() {
    let text = "O0001\nSETVN 500[DIA,LEN]\n#500=40.\nT0101\nG97 G99 S500 M03\nG00 X52. Z2.\nG01 X[#DIA] F.2\n#1=PRM[3401,0]\nG00 X100. Z100.\nM30\n";
    let found = slugs(text);
    assert_eq!(found.iter().filter(|slug| **slug == "not-supported").count(), 2, "{found:?}");
    let analysis = analyze(text.as_bytes(), &Setup::default());
    assert!(!analysis.diagnostics.iter().any(|told| told.is_error()), "{found:?}");
}

#[test]
fn a_highest_speed_that_no_lathe_turns_is_reported() {
    for (block, reported) in [("G50 S22000", true), ("G50 S2200", false), ("G50 S9999", false)] {
        let text = format!("{HEAD}{block}\nG96 S100\nG01 X40 F0.2\nG00 X200 Z200\nM30\n");
        assert_eq!(slugs(&text).contains(&"speed-unusual"), reported, "{block}");
    }
}

/// Q180 of a thread may mean 180°. Q400 is not an angle, but may be the first depth of G76.
#[test]
fn a_start_angle_beyond_a_full_turn_is_not_offered() {
    for (word, offered) in [("Q180", 1), ("Q400", 0)] {
        let text = format!("{HEAD}G92 X48 Z-20 F2 {word}\nG00 X200 Z200\nM30\n");
        let analysis = analyze(text.as_bytes(), &Setup::default());
        let told = analysis.diagnostics.iter().find(|told| told.message.slug() == "thread-angle-small");
        assert_eq!(told.expect("the message").fixes.len(), offered, "{word}");
    }
}
