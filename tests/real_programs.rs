//! Constructs of several hundred real programs, rewritten, with the result that a machinist would expect:
//! motions wherever a machine would run the program, and one message at the right position.
use gcode_playground::analyze;
use gcode_playground::message::Severity;
use gcode_playground::sentences::Language;
use gcode_playground::setup::Setup;

/// Checks the errors and warnings of a program, without `W-NO-END`, and its end point: X (diameter) and Z.
#[track_caller]
fn check_with(setup: &str, program: &str, codes: &[&str], end: (f64, f64)) {
    let analysis = analyze(program.as_bytes(), &Setup::from_json(setup).expect("setup"));
    let told = analysis.diagnostics.iter().filter(|found| found.severity != Severity::Info);
    let found: Vec<&str> =
        told.map(|found| found.message.code()).filter(|code| *code != "W-NO-END").collect();
    assert_eq!(found, codes, "\n{program}");
    let last = analysis.motions.iter().last().expect("a motion").to;
    assert!((2.0 * last.x - end.0).abs() < 1e-6 && (last.z - end.1).abs() < 1e-6, "{last:?}\n{program}");
}

#[track_caller]
fn check(program: &str, codes: &[&str], end: (f64, f64)) {
    check_with("{}", program, codes, end);
}

#[test]
fn integers_in_inch_programs_count_ten_thousandths() {
    let least = r#"{"dialect": {"decimal": "leastIncrement"}}"#;
    let text = "G20 M3 S500\nG0 X20000 Z1000\nG71 U450 R500\nG71 P1 Q2 U100 W50 F80\n\
                N1 G0 X10000\nG1 Z-5000\nN2 X20000\n";
    check_with(least, text, &[], (50.8, 2.54));
    // A number without a point among numbers with one.
    check_with(least, "G20 M3 S500\nG0 X1. Z0\nG75 R10\nG75 X.5 P250 F.004\nG0 X2. Z1.", &[], (50.8, 25.4));
}

/// The messages of a program under the default setup, except `W-NO-END`.
fn said(program: &str) -> Vec<String> {
    let analysis = analyze(program.as_bytes(), &Setup::default());
    let told = analysis.diagnostics.iter().filter(|found| found.message.code() != "W-NO-END");
    told.map(|found| format!("{}: {}", found.message.slug(), found.sentence(Language::English).message))
        .collect()
}

#[test]
fn programs_show_by_themselves_that_their_integers_are_least_increments() {
    let inches = "G20 G99 M3 S500\nG0 X2. Z.1\nG71 U800 R500\nG71 P1 Q2 U150 W20 F.016\n\
                  N1 G0 X1.\nG1 Z-1.\nN2 X2.\nG0 X2.5 Z1.\n";
    check(inches, &[], (63.5, 25.4));
    assert_eq!(said(inches), ["least-increments-concluded: No point = 0.0001 in: `U800` is 0.08 in."]);
    // The deepest pass leaves 0.015 in on the diameter and 0.002 in at the shoulder.
    let analysis = analyze(inches.as_bytes(), &Setup::default());
    let cuts = analysis.motions.iter().filter(|motion| motion.kind.cuts());
    let least = cuts.map(|motion| 2.0 * motion.to.x / 25.4).fold(f64::INFINITY, f64::min);
    assert!((least - 1.015).abs() < 1e-9, "{least}");
    let metric = "G21 G99 M3 S500 F.2\nG0 X50000 Z2000\nG1 Z-30000\nX52000\nG0 X60000 Z5000\n";
    check(metric, &[], (60.0, 5.0));
    assert_eq!(said(metric), ["least-increments-concluded: No point = 0.001 mm: `X50000` is 50 mm."]);
    // Without evidence, numbers count whole units.
    assert_eq!(said("G21 G99 M3 S500 F.2\nG0 X50 Z2\nG71 U2 R1\n"), [""; 0]);
}

#[test]
fn a_setup_that_says_otherwise_is_followed_and_the_number_told() {
    let setup = Setup::from_json(r#"{"dialect": {"decimal": "calculator"}}"#).expect("setup");
    let text = "G21 G99 M3 S500 F.2\nG0 X50. Z2.\nG1 Z-30.\nX60.\nG04 X2000\nG0 Z2.\n";
    let analysis = analyze(text.as_bytes(), &setup);
    let told = analysis.diagnostics.iter().find(|found| found.message.slug() == "too-large-without-point");
    let said = told.expect("told").sentence(Language::English).message;
    assert_eq!(said, "Here `X2000` is read as 2000 s, which is too long.");
    let note = format!("(DIALECT DECIMAL=LEASTINCREMENT)\n{text}");
    let analysis = analyze(note.as_bytes(), &setup);
    assert!(analysis.diagnostics.iter().all(|found| found.message.code() == "W-NO-END"));
}

/// Messages quote words as written, and lengths in the unit of the program.
#[test]
fn inch_programs_are_told_of_in_inches() {
    let head = "G20 G99 M3 S500\nG0 X2. Z.1\n";
    for (rest, message) in [
        ("G1 X1. F.5\n", "`F.5` under G99 is 0.5 in/rev."),
        (
            "G1 X1. F.01\nG2 X2. Z-1. R.1\n",
            "`R.1` is too small: start and end of the arc are 1.2083 in apart.",
        ),
        ("G90 X1.5 Z-1. R.5 F.01\n", "`R.5` is larger than half of the infeed (U-0.5)"),
        ("G71 U.1 R.25\n", "The escape `R.25` is larger than the depth of cut, 0.1 in."),
        (
            "G1 X1. F.01\nZ-1.\nX1.2\nX1.3\nG1 Z-90.\n",
            "`Z-90.` leads to Z-90, far beyond the rest of the program",
        ),
        ("G98 G1 X1. F5.\nG99 X.9\n", "After G99 the old feed rate 5 is now read in in/rev."),
    ] {
        let found = said(&format!("{head}{rest}"));
        assert!(found.iter().any(|found| found.contains(message)), "{message}\nis not in\n{found:#?}");
        assert!(found.iter().all(|found| !found.contains(" mm")), "{found:#?}");
    }
}

/// In systems B and C, G94 is feed per minute, G95 feed per revolution, and G92 limits the speed.
#[test]
fn messages_name_the_codes_of_the_g_code_system() {
    for system in ["B", "C"] {
        let head = format!("(DIALECT GSYSTEM={system})\nG95 M3 S500\nG0 X50. Z2.\n");
        for (rest, message) in [
            ("G1 X40. F50.\n", "`F50.` under G95 is 50 mm/rev."),
            ("G94 G1 X40. F.5\n", "`F.5` under G94 is only 0.5 mm/min."),
            ("G94 G1 X40. F50.\nG95 X39.\n", "After G95 the old feed rate 50"),
            ("G12.1\nG1 X40. F.2\nG13.1\n", "Feed per revolution (G95) cannot"),
        ] {
            let found = said(&format!("{head}{rest}"));
            assert!(found.iter().any(|found| found.contains(message)), "{message}\nis not in\n{found:#?}");
        }
        let text = format!("{head}G96 S150\nG1 X40. F.2\n");
        let analysis = analyze(text.as_bytes(), &Setup::default());
        let told =
            analysis.diagnostics.iter().find(|found| found.message.slug() == "surface-speed-without-clamp");
        assert_eq!(told.expect("told").fixes[0].edits[0].text, "G92 S2000\n");
    }
}

#[test]
fn slips_of_the_hand_are_told_at_their_word_and_nothing_else_is_lost() {
    let program = |slip: &str| format!("M3 S500\nG0 X20 Z2\nG1 Z-5 F.2\n{slip}\nG0 X60 Z9");
    for (slip, code) in [
        ("X-12.8.", "PS0007"),
        ("X-11.Z", "PS0005"),
        ("G1 Z,15", "E-OCR"),
        ("GO1 X5", "E-OCR"),
        ("Z\u{2013}7", "W-OCR"),
        ("M08.", "PS0007"),
    ] {
        check(&program(slip), &[code], (60.0, 9.0));
    }
    // A control joins digits separated by blanks: this is not G00, and such a code does not exist.
    check(&program("G00 3.7347"), &["W-BLANK-IN-NUMBER", "PS0010"], (60.0, 9.0));
    check("01000\nM3 S500\nG0 X20 Z2", &["W-OCR"], (20.0, 2.0));
}

#[test]
fn block_skip_and_calls_are_packed_tightly() {
    let text =
        "O1\nG0 X50 Z5\n/2M98P8001\n/\nG0 X40 / Z-3\nM98P20005\nM30\nO5\nG0 W-1\nM99\nO8001\nG0 X90\nM99\n";
    check(text, &[], (40.0, -5.0));
    check_with(r#"{"blockSkip": [1, 2]}"#, text, &[], (40.0, 3.0));
    check("G0 X50 Z5\nM98P100005\nM30\nO0005\nG0 W-1\nM99", &[], (50.0, -5.0));
    check("G0 T13013G54 X50 Z5", &[], (50.0, 5.0));
    check("G50 S2000\nG96S1200M03P11\nG0 X50 Z5\nG1 Z0 F.2", &[], (50.0, 0.0));
}

#[test]
fn a_header_with_g90_does_not_cut() {
    check("G18G20G40G80G90G99\nM3 S500\nG0 X2. Z.1", &[], (50.8, 2.54));
    // Even with axis words that move nothing.
    check("G21 G40 G90 G99\nU0.W0.\nM3 S500\nG0 X50 Z5", &[], (50.0, 5.0));
}

#[test]
fn homes_and_dwells_in_all_their_spellings() {
    check("G0 X50 Z5\nG28", &["W-G28-NO-AXIS"], (50.0, 5.0));
    check("G0 X50 Z5\nG28U0.V0.", &[], (300.0, 5.0));
    check("G0 X50 Z5\nG28U0.W0.", &[], (300.0, 300.0));
    check("G0 X50 Z5\nG4X1.\nG4U1.0\nG4P500\nG0 X40", &[], (40.0, 5.0));
    check("M3 S500\nG0 X50 Z5\nG4\nG0 X40", &["W-DWELL-NO-TIME"], (40.0, 5.0));
    check("G0 X50 Z5\nG53 X0. Z0.", &[], (300.0, 300.0));
    check("G0 X50 Z5\nG53 Z-50.", &[], (50.0, 250.0));
}

#[test]
fn sequence_numbers_may_be_bare_twice_or_out_of_order() {
    check("N30 G0 X50 Z5\nN10\nN20 X40\nN20 X30", &[], (30.0, 5.0));
    let contour = "N1 G0 X20\nG1 Z-20\nX40\nN2 X60";
    let head = "M3 S500 F.2\nG0 X60 Z2\nG71 U2 R1\n";
    check(&format!("{head}G71 P1 Q9\n{contour}\nG0 X90"), &["E-NS-NOT-FOUND"], (90.0, -20.0));
    // The contour precedes its cycle, so it runs once by itself; then the cycle runs.
    check(
        &format!("M3 S500 F.2\nG0 X60 Z2\n{contour}\nG0 X60 Z2\nG71 U2 R1\nG71 P1 Q2\nG0 X90"),
        &[],
        (90.0, 2.0),
    );
    // One cycle within the contour of another.
    let reaches = format!("{head}G71 P1 Q4 U.4\n{contour}\nG0 X60 Z2\nN3 G71 P1 Q2\nN4 G0 X90");
    check(&reaches, &["PS0325"], (90.0, 2.0));
    check(&format!("{head}G71 P1 Q2\n{contour}\nG70 P1 Q5\nG0 X90"), &["E-NS-NOT-FOUND"], (90.0, 2.0));
    // A duplicate sequence number: G70 uses the contour that roughing found.
    check(&format!("N1 T0101\n{head}G71 P1 Q2\n{contour}\nG70 P1 Q2"), &[], (60.0, 2.0));
}

#[test]
fn real_profiles_run() {
    let program =
        |profile: &str| format!("M3 S500 F.2\nG0 X60 Z2\nG71 U2 R1\nG71 P1 Q2 U.4 W.1\n{profile}\nG70 P1 Q2");
    let ends = (60.0, 2.0);
    check(&program("N1 G0 X20 Z2\nG1 Z-20\nN2 X60 Z-30"), &[], ends);
    check(&program("N1 G1 X20\nZ-20\nN2 X60 Z-30"), &[], ends);
    check(&program("N1 G0 G42 X20\nG1 Z-20\nG0 X40\nG1 Z-25\nN2 G40 X60 Z-30"), &[], ends);
    check(&program("(FINISH PASS)\n\nN1 G0 X20\n(STEP)\nG1 Z-20\nN2 X60 Z-30"), &[], ends);
    // X reverses in a relief groove: many machines run it, some raise an alarm.
    check(&program("N1 G0 X20\nG1 Z-10\nX18\nZ-14\nX30\nZ-20\nN2 X60 Z-30"), &["E-NOT-MONOTONE"], ends);
    // The last block returns to the face.
    check(&program("N1 G0 X20\nG1 Z-20\nX58\nN2 G1 X59 Z2"), &["E-NOT-MONOTONE"], ends);
    check(&program("N1 G0 X20\nG1 Z-20\nX58\nN2 G0 Z2"), &[], ends);
    // The end is slightly beyond the start point.
    check(&program("N1 G0 X20\nG1 Z-20\nN2 X61"), &["PS0322"], ends);
}

#[test]
fn drawing_dimensions_and_corners_without_commas() {
    check("M3 S500 F.2\nG0 X20 Z0\nG1 A170.0 Z-20. R2.0\nX60", &[], (60.0, -20.0));
    check("M3 S500 F.2\nG0 X20 Z0\nG1 A180. R5.\nX60. Z-20. A90.", &[], (60.0, -20.0));
    check("M3 S500 F.2\nG0 X20 Z0\nG1 X21.75,A150", &[], (21.75, -0.875 / 30f64.to_radians().tan()));
    check("M3 S500 F.2\nG0 X20 Z0\nG1 Z-20 C1.5\nX30 R2.\nZ-40", &[], (30.0, -40.0));
    check("#7=2\nM3 S500 F.2\nG0 X20 Z0\nG1 Z-20 R-#7\nX10", &[], (10.0, -20.0));
}

#[test]
fn remarks_in_all_their_forms() {
    check("G0 X50 Z5 (NOT CLOSED\nX40", &["W-COMMENT-OPEN"], (40.0, 5.0));
    check("G0 X50 (A (B) C) Z5", &["W-COMMENT-NESTED"], (50.0, 5.0));
    check("(FACE) ROUGH), (TURN)\nG0 X50 Z5", &["E-PLAIN-TEXT"], (50.0, 5.0));
    check("FACE AND TURN\nG0 X50 Z5", &["E-PLAIN-TEXT"], (50.0, 5.0));
    check("G0 X50 Z5; to the start\nG0 X40;", &["W-TEXT-AFTER-EOB"], (40.0, 5.0));
    check("G0 X50;Z5;\nX40", &[], (40.0, 5.0));
    check("N1 粗车外圆\nG0 X50 Z5 (精车)", &["PS0009"], (50.0, 5.0));
    check("(ЧЕРНОВАЯ)\nG0 X50 Z5", &[], (50.0, 5.0));
    check("(FACE), (TURN).\n----------\nG0 X50 Z5", &["PS0009", "E-PLAIN-TEXT"], (50.0, 5.0));
    check("\u{feff}G0 X50\r\nZ5\rX40\n", &[], (40.0, 5.0));
}

#[test]
fn windows_letters_in_remarks_do_no_harm() {
    let analysis = analyze(b"G0 X50 Z5 (\xd8 50 \xe9bauche)\nX40", &Setup::default());
    assert_eq!(analysis.motions.len(), 2);
    assert!(analysis.diagnostics.iter().all(|found| !found.is_error()));
}

#[test]
fn macros_as_people_write_them() {
    check("#1=1\nIF [#1 EQ 1] #122=5\nG0 X[#122*10] Z5", &[], (50.0, 5.0));
    let text = "#7=6\nM3 S500 F.2\nG0 X60 Z2\nG71 U[#7/3] R[#7/3]\nG71 P1 Q2 U.4\nN1 G0 X20\nG1 Z-20\nN2 X60";
    check(text, &[], (60.0, 2.0));
    check("G0 X50 Z5\nIF [1 EQ 1] THEN #3000=10 (TOOL MISSING)\nG0 X90", &["E-MACRO-ALARM"], (50.0, 5.0));
    // A switch of the machine builder: reported as a note, and ignored.
    check("#[#10036+1400]=1\nG0 X50 Z5", &[], (50.0, 5.0));
}

#[test]
fn headers_of_system_b_are_read_as_such() {
    let head = "G21 G40 G80 G90 G95\nG92 S2500\nM3 S500\n";
    check(&format!("{head}G0 X50 Z5\nG77 X40 Z-20 F.2\nG0 X90"), &[], (90.0, 5.0));
    check(&format!("{head}G0 X50 Z5\nG78 X40 Z-20 F2.\nG0 X90"), &[], (90.0, 5.0));
    check(&format!("{head}G0 X50 Z5\nG91 G0 X10 Z-1"), &[], (60.0, 4.0));
}

#[test]
fn one_line_cycles_of_haas_and_class_room_notes() {
    let contour = "N1 G0 X20\nG1 Z-20\nN2 X60";
    check(&format!("M3 S500\nG0 X60 Z2\nG71 P1 Q2 U.4 W.1 D2. F.2\n{contour}\nG70 P1 Q2"), &[], (60.0, 2.0));
    check("M3 G97 S500\nG0 X24 Z4\nG76 X18.16 Z-18. K.92 D.3 F1.5 A60", &[], (24.0, 4.0));
    check("[BILLET X62 Z70\n[TOOLDEF T1\nM3 S500\nG0 X50 Z5", &[], (50.0, 5.0));
    check("T0101 M06\nM3 S500\nG0 X0 Z5\nG81 Z-5 F.1\nG80\nG0 Z9", &["W-HOLE-G81"], (0.0, 9.0));
}
