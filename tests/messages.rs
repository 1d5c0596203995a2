//! Messages at their exact position: the carets under a line mark the span, followed by the code.
use gcode_playground::analyze;
use gcode_playground::findings;
use gcode_playground::machine::SimulationResult;
use gcode_playground::message::{Diagnostic, Kind, Severity};
use gcode_playground::sentences::{Language, labels};
use gcode_playground::setup::Setup;
use gcode_playground::source::LineIndex;

/// Checks that the annotated lines (`//  ^^^ CODE`) are all messages of a program, except `W-NO-END`.
#[track_caller]
fn check_with(setup: &str, annotated: &str) {
    let (mut program, mut expected) = (Vec::new(), Vec::new());
    for line in annotated.lines() {
        if let Some(marks) = line.strip_prefix("//") {
            let column = marks.find('^').expect("carets") + 2;
            let length = marks.matches('^').count();
            let code = marks[marks.rfind('^').expect("carets") + 1..].trim();
            expected.push((program.len(), column, length, code.to_owned()));
        } else {
            program.push(line);
        }
    }
    let program = program.join("\n");
    let analysis = analyze(program.as_bytes(), &Setup::from_json(setup).expect("setup"));
    let lines = LineIndex::new(program.as_bytes());
    let place = |found: &Diagnostic| {
        let at = lines.line_column(program.as_bytes(), found.span.start);
        let length = found.span.quote(program.as_bytes()).chars().count();
        (at.line as usize + 1, at.column as usize, length, found.code())
    };
    let found: Vec<_> = analysis.diagnostics.iter().map(place).filter(|row| row.3 != "W-NO-END").collect();
    assert_eq!(found, expected, "\n{program}");
}

#[track_caller]
fn check(annotated: &str) {
    check_with(r#"{"dialect": {"feedMode": "G98"}}"#, annotated);
}

/// Checks that all fixes together turn one text into the other.
#[track_caller]
fn check_fix(before: &str, after: &str) {
    let analysis = analyze(before.as_bytes(), &Setup::default());
    let mut edits: Vec<_> = analysis
        .diagnostics
        .iter()
        .filter(|found| found.message.slug() != "no-program-end")
        .flat_map(|found| &found.fixes)
        .flat_map(|fix| fix.edits.clone())
        .collect();
    edits.sort_by_key(|edit| std::cmp::Reverse(edit.span.start));
    let mut text = before.to_owned();
    for edit in edits {
        text.replace_range(edit.span.start as usize..edit.span.end as usize, &edit.text);
    }
    assert_eq!(text, after);
}

/// Two adjacent balls touch in a valley of 180°: no nose reaches its bottom, from any direction and with any
/// turret position.
#[test]
fn a_nose_does_not_fit_between_two_arcs_that_touch() {
    let there = "G42 G0 X32 Z2\nG1 Z0 F100\nG3 X28 Z-2 R2\n   G3 X34 Z-5 R3\n// ^^^^^^^^^^^^^ PS0041\nG1 Z-9\nG40 G0 X50";
    let back = "G41 G0 X34 Z-9\nG1 Z-5 F100\nG2 X28 Z-2 R3\n   G2 X32 Z0 R2\n// ^^^^^^^^^^^^ PS0041\nG1 Z2\nG40 G0 X50";
    // A bore that narrows in two steps, each a quarter of a ring.
    let inside = "G41 G0 X32 Z2\nG1 Z0 F100\nG2 X36 Z-2 R2\n   G2 X30 Z-5 R3\n// ^^^^^^^^^^^^^ PS0041\nG1 Z-9\nG40 G0 X20";
    for turret in ["rear", "front"] {
        for (program, tip) in [(there, 3), (back, 3), (inside, 2)] {
            for radius in [0.2, 0.4, 0.8] {
                let tool = format!(r#""T0101": {{"type": "turning", "noseRadius": {radius}, "tip": {tip}}}"#);
                let setup = format!(
                    r#"{{"dialect": {{"feedMode": "G98"}}, "machine": {{"turret": "{turret}"}}, "tools": {{{tool}}}}}"#
                );
                let start = if tip == 2 { "G0 X20 Z5" } else { "G0 X60 Z5" };
                check_with(&setup, &format!("M3 S500 T0101\n{start}\n{program}"));
            }
        }
    }
}

#[test]
fn under_compensation_the_path_may_not_turn_straight_back() {
    let setup = r#"{"dialect": {"feedMode": "G98"}, "tools": {"T0101": {"type": "turning", "noseRadius": 0.4, "tip": 3}}}"#;
    let start = "M3 S500 T0101\nG0 X60 Z2\nG42 X50 Z1";
    check_with(setup, &format!("{start}\nG1 Z-20 F100\n   G0 Z2\n// ^^^^^ W-TNRC-BACK\nG40 X60"));
    check_with(setup, &format!("{start}\nG1 Z-20 F100\nX54\nG0 Z2\nG40 X60"));
    check_with(setup, &format!("{start}\nG1 Z-20 F100\nG40 G0 Z2"));
}

#[test]
fn an_arc_with_a_radius_and_no_end_point_is_told() {
    check("M3 S500 F100\nG00 X50 Z5\n   G03 R5\n// ^^^^^^ W-ARC-NOWHERE");
}

#[test]
fn writing() {
    check("G00 X12.8. Z5\n//  ^^^^^^ PS0007");
    check("G00 X50 Z\n//      ^ PS0005");
    check("G00 X50 ?\n//      ^ PS0009");
    check("G00 X50 Z,15\n//      ^^^^ E-OCR");
    check("   GO0 X50\n// ^^^ E-OCR");
    check("   hello world\n// ^^^^^^^^^^^ E-PLAIN-TEXT");
    check("G00 (open\n//  ^ W-COMMENT-OPEN");
}

#[test]
fn a_comma_for_the_point_is_one_fault_and_what_its_word_switches_on_holds() {
    let start = "G99 M3 S500\nG00 X50 Z2\n";
    check_with("{}", &format!("{start}G01 Z-5 F0,2\n//      ^^^^ E-OCR\nX52\nG00 Z2"));
    check_with("{}", &format!("{start}G01 Z-5 F,2\n//      ^^^ E-OCR\nX52\nG00 Z2"));
    check_with("{}", &format!("{start}G32 Z-5 F1,5\n//      ^^^^ E-OCR\nZ-8\nG00 X60"));
    check_with("{}", &format!("{start}G01 Z-20,5 F0.2\n//  ^^^^^^ E-OCR\nX52\nG00 Z2"));
}

#[test]
fn a_feed_that_is_missing_after_a_broken_one_is_the_same_fault() {
    let start = "G99 M3 S500\nG00 X50 Z2\n";
    for (word, marks, code) in [
        ("F0.2.", "^^^^^", "PS0007"),
        ("F", "^", "PS0005"),
        ("F-0.2", "^^^^^", "PS0006"),
        ("F0..2", "^^^^^", "PS0007"),
    ] {
        check_with("{}", &format!("{start}G01 Z-5 {word}\n//      {marks} {code}\nX52\nG00 Z2"));
        check_with("{}", &format!("{start}   {word}\n// {marks} {code}\nG01 Z-5\nX52\nG00 Z2"));
    }
    // An unreadable word does not make the feed unknown.
    check_with("{}", &format!("{start}G01 Z-5.5.\n//  ^^^^^^ PS0007\n   X52\n// ^^^ PS0011\nG00 Z2"));
}

#[test]
fn the_letter_of_a_code_is_e_for_errors_alone() {
    let text = "(STOCK D=50 LENGTH=80)\nG99 T0101 M3 S800 M777\nG00 X60 Z2\nX40\nZ-20\nM30\n";
    let codes = |setup: &str| -> Vec<(bool, String)> {
        let mut analysis = analyze(text.as_bytes(), &Setup::from_json(setup).expect("setup"));
        analysis.check_at_machine();
        let rows = analysis.diagnostics.iter().map(|found| (found.is_error(), found.code()));
        rows.filter(|(_, code)| code.ends_with("-START-IN-STOCK") || code.ends_with("-M-UNKNOWN")).collect()
    };
    let of = |error: bool, code: &str| (error, code.to_owned());
    assert_eq!(codes("{}"), [of(false, "W-M-UNKNOWN"), of(true, "E-START-IN-STOCK")]);
    let graded = r#"{"rules": {"unknown-m-code": "error", "rapid-through-stock": "warning"}}"#;
    assert_eq!(codes(graded), [of(true, "E-M-UNKNOWN"), of(false, "W-START-IN-STOCK")]);
}

#[test]
fn the_first_block_of_a_contour_with_a_pocket_keeps_both_axes() {
    let program = |first: &str, last: &str| {
        format!(
            "G99 M3 S800\nG00 X52 Z2\nG71 U2 R0.5\nG71 P10 Q20 U0.4 W0.1 F0.25\nN10 G00 {first}\nG01 Z-10 F0.2\n\
             X30 Z-15\n{last}N20 G01 X50\nG70 P10 Q20\nG00 X100 Z100\nM30\n"
        )
    };
    let pocket = "X24 Z-20\nX30 Z-25\n";
    let told = |text: &str| -> Vec<&'static str> {
        let analysis = analyze(text.as_bytes(), &Setup::default());
        analysis.diagnostics.iter().map(|found| found.message.slug()).collect()
    };
    // With a pocket the word selects type II, so it must stay.
    assert_eq!(told(&program("X16 Z2", pocket)), [] as [&str; 0]);
    assert_eq!(told(&program("X16", pocket)), ["contour-turns-back"]);
    check_fix(&program("X16", pocket), &program("X16 W0", pocket));
    assert_eq!(told(&program("X16 W0", pocket)), [] as [&str; 0]);
    // Without a pocket it is unnecessary, and the fix removes it.
    assert_eq!(told(&program("X16 Z2", "")), ["contour-names-both-axes"]);
    check_fix(&program("X16 Z2", ""), &program("X16", ""));
    assert_eq!(told(&program("X16", "")), [] as [&str; 0]);
}

#[test]
fn a_taper_with_the_wrong_sign_keeps_its_end_point() {
    let program = |pass: &str| format!("G99 M3 S800\nG00 X60 Z2\n{pass}\nG00 X100 Z100\nM30\n");
    for (wrong, right) in [
        ("G90 U-10 W-30 R8 F0.2", "G90 U-10 W-30 R-8 F0.2"),
        ("G90 X50 Z-30 R+8. F0.2", "G90 X50 Z-30 R-8. F0.2"),
        ("G92 X58 Z-30 R1.5 F2", "G92 X58 Z-30 R-1.5 F2"),
        ("G94 X30 Z0 R5 F0.2", "G94 X30 Z0 R-5 F0.2"),
    ] {
        check_fix(&program(wrong), &program(right));
    }
}

#[test]
fn codes_and_words() {
    check("   G7.7 X5\n// ^^^^ PS0010");
    check("M3 S-100\n// ^^^^^ PS0006");
    check("M3 S1.5\n// ^^^^ PS0007");
    check("G00 X50 X60\n//      ^^^ W-DUP-WORD");
    check("G00 X50 U6\n//  ^^^^^^ W-X-AND-U");
    check("G00 G01 X50 F100 M3 S500\n//  ^^^ W-SAME-GROUP");
    check("G50 X100 Z100 T0101\n//            ^^^^^ PS0245");
    check("G00 X50 T1\n//      ^^ W-T1");
    check("G0 X60 Z5\nM3 S1 F100\n   G90\n// ^^^ W-G90-MILL\nX50 Z-30");
    check("   G28\n// ^^^ W-G28-NO-AXIS");
    check("   G04\n// ^^^ W-DWELL-NO-TIME");
    check("   M777\n// ^^^^ W-M-UNKNOWN");
}

#[test]
fn feed_and_spindle() {
    check("M3 S500\n   G01 X50\n// ^^^^^^^ PS0011");
    check("M3 S500\n   G32 Z5\n// ^^^^^^ PS0011");
    check_with("{}", "M3 S500\nG01 X50 F200\n//      ^^^^ W-FEED-MODE\nG01 X40 F100");
    check("M3 S500\nG01 X50 F0.2\n//      ^^^^ W-FEED-MODE");
    check_with("{}", "M3 S500\nG01 X50 F10\n//      ^^^ W-FEED-MODE");
    check_with("{}", "M3 S500\nG01 X50 F10\n//      ^^^ W-FEED-MODE\nG01 X40 F6\nG98 X30 F100");
    // A fast approach: the next feed fits the unit.
    check_with("{}", "M3 S500\nG01 X50 F5\nX40 F0.2");
    check("M3 S500\nG01 X50 F100\n   G99 X40\n// ^^^^^^^ W-FEED-KEPT");
    check("   G01 X50 F100\n// ^^^^^^^^^^^^ W-NO-SPINDLE\nX40");
    check("G96 S120 M3\n//  ^^^^ W-CSS-NOCLAMP");
    check("G50 S1000 Q2000\n//        ^^^^^ W-CSS-UNSET");
    check("G50 S1000\nG96 S100 M3\n   G32 Z5 F2\n// ^^^^^^^^^ W-THREAD-CSS");
    // The closest correct cases.
    check("G50 S2000\nG96 S120 M3\nG97 S500\nG32 Z5 F2");
    check("M3 S500\nG99 G01 X50 F0.2");
}

#[test]
fn arcs() {
    check("M3 S1 F100\nG0 X20 Z0\n   G3 X40 Z-10 R1\n// ^^^^^^^^^^^^^^ PS0020");
    check("M3 S1 F100\nG0 X20 Z0\n   G3 X40 Z-10\n// ^^^^^^^^^^^ PS0022");
    check("M3 S1 F100\nG0 X20 Z0\n   G3 X40 Z-10 K-8\n// ^^^^^^^^^^^^^^^ PS0020");
    check("M3 S1 F100\nG0 X20 Z0\nG3 X40 Z-10 K-10");
    let alarm = r#"{"dialect": {"negativeArcR": "alarm", "feedMode": "G98"}}"#;
    check_with(alarm, "M3 S1 F100\nG0 X20 Z0\nG3 X40 Z-10 R-10\n//          ^^^^ PS0023");
}

#[test]
fn tapers() {
    let gsk = r#"{"dialect": {"control": "gsk"}}"#;
    check_with(gsk, "M3 S1 F100\nG0 X60 Z0\nG90 X50 Z-30 R8\n//           ^^ E-TAPER-R");
    check_with(gsk, "M3 S1 F100\nG0 X60 Z0\nG90 X50 Z-30 R5\n//           ^^ W-TAPER-SIGN");
    check_with(gsk, "M3 S1 F100\nG0 X60 Z0\nG90 X60 Z-30 R-8");
    check_with(gsk, "M3 S1 F100\nG0 X60 Z5\nG94 X50 Z0 R8\n//         ^^ E-TAPER-R");
    let stock = r#"{"dialect": {"feedMode": "G98"}, "stock": {"diameter": 50, "length": 60}}"#;
    check_with(stock, "M3 S1 F100\nG0 X54 Z5\nG94 X30 Z0 R-20\n//         ^^^^ W-TAPER-NOT-EXTENDED");
    check_with(stock, "M3 S1 F100\nG0 X54 Z5\nG94 X30 Z0 R-24");
    // Of a series in which R grows, only the last pass makes the cone.
    let series = |last: i32| {
        let passes: Vec<String> = (2..=last / 2).map(|pass| format!("Z0 R-{}", 2 * pass)).collect();
        format!("M3 S1 F100\nG0 X54 Z5\nG94 X30 Z0 R-2\n{}", passes.join("\n"))
    };
    check_with(stock, &series(24));
    check_with(stock, &format!("{}\nG0 X54\nM30", series(24)));
    check_with(stock, &format!("{}\n// ^^^^ W-TAPER-NOT-EXTENDED", series(20)));
}

#[test]
fn programs() {
    check("   O0\n// ^^ E-PROGRAM-ZERO");
    check("O5\nG0 X1\nM30\n   O5\n// ^^ W-DUP-O");
    check("   M98\n// ^^^ PS0076");
    check("M98 P8001\n//  ^^^^^ PS0076\nG0 X1");
    check("   M98 P2\nM30\n   O2\nG0 X1\n   M98 P2\n// ^^^^^^ PS0077\nM99");
    check("G0 X1\n   M99\n// ^^^ W-ENDLESS");
    check("G0 X1\n   M99 P5\n//     ^^ PS0128");
    check("G0 X1\nN1 X2\n   M99 P1\n// ^^^^^^ W-ENDLESS");
    check("O1\nG0 X1\nM30\n   O2\n// ^^ I-NOT-RUN\nG0 X1\nM99");
    check("O1\nM98 P2\nM98 P3\nM30\nO2\nG0 X1\n   O3\n// ^^ W-NO-RETURN\nM99");
}

#[test]
fn repairs() {
    check_fix("GO1 X5", "G01 X5");
    check_fix("G01 Z,15", "G01 Z.15");
    check_fix("G01 Z2,5", "G01 Z2.5");
    check_fix("Z–20", "Z-20");
    check_fix("G0 (open\nX5", "G0 (open)\nX5");
    check_fix("00006;\nG0 X1", "O0006;\nG0 X1");
    check_fix("G0 X2O0 Zl0", "G0 X200 Z10");
    check_fix("G0 X1..5 Z2.5.", "G0 X1.5 Z2.5");
    check_fix("（外圆）\nG0 X5", "(外圆)\nG0 X5");
    check_fix("G0 X5；Z1", "G0 X5;Z1");
    let start = "M3 S500\nG99 G0 X50 Z2 F.2\n";
    let both = |before: &str, after: &str| check_fix(&format!("{start}{before}"), &format!("{start}{after}"));
    // Roles of U and W, signs, and words of the multiple cycles.
    both("G71 W2 R.5", "G71 U2 R.5");
    both("G72 U2 R.5", "G72 W2 R.5");
    both("G71 X2 R.5", "G71 U2 R.5");
    both("G71 U-2 R.5", "G71 U2 R.5");
    both("G73 X6 W2 R3", "G73 U6 W2 R3");
    // Sequence numbers that are missing, or written with a point.
    let contour = |p: &str, first: &str, last: &str| {
        format!("G71 U2 R.5\nG71 {p} Q2 U.4 W.1\n{first}G0 X30\nG1 Z-20\n{last}X50\nG0 X80 Z9")
    };
    both(&contour("P1", "", "N2 "), &contour("P1", "N1 ", "N2 "));
    both(&contour("P1", "N1 ", ""), &contour("P1", "N1 ", "N2 "));
    both(&contour("P1.", "N1 ", "N2 "), &contour("P1", "N1 ", "N2 "));
    // Threads.
    both("G76 P020050 Q100 R.05", "G76 P020055 Q100 R.05");
    both("G74 R.5\nG74 Z-20 Q5.5 F.1", "G74 R.5\nG74 Z-20 Q5500 F.1");
    check_fix(
        "G50 S900\nG96 S100 M3\nG0 X40 Z4\nG32 Z-9 F2",
        "G50 S900\nG96 S100 M3\nG0 X40 Z4\nG97 S790\nG32 Z-9 F2",
    );
    // Missing codes before a cut, and at the end.
    check_fix("G97 S500\nG99 G1 Z-5 F.1", "G97 S500\nM03\nG99 G1 Z-5 F.1");
    check_fix("G96 S100 M3\nG0 X40", "G50 S2000\nG96 S100 M3\nG0 X40");
    check_end("G0 X40", "G0 X40\nM30");
    check_end("%\nO1\nG0 X40\n%\n", "%\nO1\nG0 X40\nM30\n%\n");
}

/// Checks the fix at the end of the text.
#[track_caller]
fn check_end(before: &str, after: &str) {
    let repaired = gcode_playground::repair::repaired(before.as_bytes(), &Setup::default());
    assert_eq!(String::from_utf8_lossy(&repaired.text), after);
}

#[test]
fn cycles_and_corners() {
    let start = "M3 S500 F100\nG0 X50 Z2\n";
    let contour = "N1 G0 X20\nG1 Z-10\nN2 X50";
    check(&format!("{start}G71 U2 R1\nG71 X20 P1 Q2 U0 W0\n//  ^^^ PS0066\n{contour}"));
    check(&format!("{start}G71 U2 R1\nG71 P1 Q2 U0 W0\n{contour}\nG70 P1 Q2"));
    check(&format!("{start}   G71 P1 Q2 U0 W0\n// ^^^^^^^^^^^^^^^ E-G71-U-ROLE\n{contour}"));
    check(&format!("{start}G71 U-2 R1\n//  ^^^ E-G71-U-SIGN\nG71 P1 Q2\n{contour}"));
    check(&format!("{start}G71 U2 R1\nG71 P1 Q9\n//     ^^ E-NS-NOT-FOUND\n{contour}"));
    check(&format!("{start}G17\nG71 U2 R1\n   G71 P1 Q2\n// ^^^^^^^^^ PS0327\n{contour}"));
    check(&format!("{start}G90 X40 C20 Z-20\n//      ^^^ PS0330"));
    check(&format!("{start}{contour}\n   G70 P1 Q2\n// ^^^^^^^^^ W-G70-NO-ROUGH"));
    check(&format!("{start}G71 U2 R1\nG71 P1 Q2\n{contour}\nG0 X30\n   G70 P1 Q2\n// ^^^^^^^^^ W-G70-START"));
    check(&format!("{start}G74 R1\nG74 Z-12 Q5\n//       ^^ W-PQ-UNIT"));
    check(&format!("{start}G1 Z-20 C2 R1\n//      ^^ PS0053"));
    check(&format!("{start}G32 Z-20 F2 R2\n//          ^^ PS0050"));
    check(&format!("{start}G1 Z-20 ,C30\n//      ^^^^ PS0055\nX60"));
    check(&format!("{start}G1 Z-20 ,C2\n//      ^^^ PS0052\nG0 X60"));
    check(&format!("{start}G1 Z-20 I-2\n//      ^^^ PS0051\nX60"));
    // An arc forms no corner, except with a comma, or with L and D on GSK.
    for word in ["C2", "R2", "I2"] {
        let carets = "^".repeat(word.len());
        check(&format!("{start}G1 Z-20 {word}\n//      {carets} PS0052\nG2 X60 Z-25 R5"));
    }
    // Straight, and less than 1° to the side.
    for next in ["Z-30", "X50.3 Z-30", "X49.7 Z-30"] {
        for word in [",C2", ",R2", "C2", "R2"] {
            let carets = "^".repeat(word.len());
            check(&format!("{start}G1 Z-20 {word}\n//      {carets} W-CORNER-STRAIGHT\n{next}"));
        }
    }
    check(&format!("{start}G1 Z-20 ,R2\n//      ^^^ PS0051\nZ-10"));
    check(&format!("{start}G1 Z-20 K2\n//      ^^ PS0306\nX60"));
    check(&format!("{start}G1 Z-20 I2\nX60"));
    check(&format!("{start}G1 ,A180\n// ^^^^^ PS0056\nX60 Z-20"));
    check(&format!("{start}G17 G1 X60 ,A135\n//         ^^^^^ PS0212"));
    let strict = r#"{"dialect": {"feedMode": "G98", "strict": true}}"#;
    check_with(strict, &format!("{start}G1 X40 Z-20 C2\n//          ^^ PS0054\nZ-30"));
    check(&format!("{start}G1 X40 Z-20 C2\nZ-30"));
}

#[test]
fn calls_and_jumps() {
    check("O1\nM98 P2 Q30\n//     ^^^ PS0128\nM30\nO2\nN20 W-1\nM99");
    check("O1\nM97 P30\n//  ^^^ PS0128\nM30");
    check("O1\nM98 P2.5\n//  ^^^^ PS0007\nM30");
}

#[test]
fn macros() {
    check("   N#3 G0 X5\n// ^^^ PS0114");
    check("#1=123456789\nG0 Z5 X#1\n//    ^^^ PS0003");
    check("   WHILE[1EQ1]DO1\n// ^^^^^^^^^^^^^^ PS0124\nG0 X1");
    check("WHILE[#1LT2]DO1\n   DO1\n// ^^^ PS0126\n#1=#1+1\nGOTO 5\nEND1\nN5\nEND1");
    check("WHILE[1]DO1\n//   ^^^ PS0114\nG0 X1\nEND1");
    check("   DO4\n//   ^ PS0126\nG0 X1\nEND4");
    check("IF[1EQ1]THEN G0 X5 ?\n//                 ^ PS0009");
    let contour =
        "M3 S1 F9\nG0 X50 Z2\nG71 U1 R1\nG71 P1 Q2\nN1 G0 X30\n   GOTO 2\n// ^^^^^^ PS0325\nN2 G1 Z-5";
    check(contour);
}

#[test]
fn data_and_reference_points() {
    check("G10 P1 R0.4 T0101\n//          ^^^^^ PS0245");
    check("G10 L2 P7 X1\n//     ^^ PS0030");
    check("G10 P-1 X5\n//  ^^^ PS0030");
    check("G10 P1 Q15\n//     ^^^ PS0032");
    check("G54.1 P0\n//    ^^ PS0030");
}

#[test]
fn hole_cycles() {
    let head = "M13 S500 F100\nG0 X0 Z5\n";
    check(&format!("{head}G83 Z-20 Q0\n//       ^^ PS0045"));
    check(&format!("{head}G83 Z-20\n   G28 U0\n// ^^^ PS0044\nG0 X5"));
    check(&format!("{head}G83 Z-20\n   G71 U1 R1\n// ^^^ PS0327"));
    // A code of group 01 cancels it, even in a block with an error.
    check(&format!("{head}G83 Z-20\nG0 X5 S1.5\n//    ^^^^ PS0007\nX10"));
}

#[test]
fn virtual_planes() {
    let head = "M45\nM13 S500 F100\nG0 X80 Z5\n";
    check(&format!("{head}G12.1\n   X60\n// ^^^ E-G121-GCODE\nC10\nG1 X50\nG13.1"));
    check(&format!("{head}G42\n   G12.1\n// ^^^^^ E-G121-COMP\nG13.1"));
    check(&format!("{head}G1 X70 T0101\nG42\n   G7.1 C30\n// ^^^^^^^^ E-G121-COMP\nG7.1 C0"));
    check(&format!("{head}G1 X70\nG12.1\nX50\n   T0202\n// ^^^^^ W-POLAR-END\nG13.1"));
    check(&format!("{head}G1 X70\nG7.1 C30\nC10\n   M30\n// ^^^ W-POLAR-END"));
}

#[test]
fn a_macro_statement_is_marked_without_its_number_and_remark() {
    check("N1 IF[1EQ1]GOTO 50 (AWAY)\n// ^^^^^^^^^^^^^^^ PS0128\nG0 X1");
    check("N1 WHILE[1EQ1]DO1  (ROUND)\n// ^^^^^^^^^^^^^^ PS0124\nG0 X1");
    check("N1 END2 (ALONE)\n// ^^^^ PS0126\nG0 X1");
    check("G0 X1\n  #3000=1(NO TOOL)  (REMARK)\n//^^^^^^^^^^^^^^^^ E-MACRO-ALARM");
    // An END that matches no DO.
    check("  DO1 (A)\n//^^^ PS0124\nG0 X1\nEND2");
}

#[test]
fn a_macro_alarm_has_the_number_that_a_control_shows() {
    for (value, number) in [("1", "3001"), ("12", "3012"), ("99999999", "100002999")] {
        let analysis = analyze(format!("#3000={value}(NO TOOL)").as_bytes(), &Setup::default());
        let said = analysis.diagnostics[0].message.sentence(Default::default()).message;
        assert_eq!(said, format!("The program stops itself with alarm {number}: NO TOOL"));
    }
}

#[test]
fn a_block_that_is_too_long_is_one_fault() {
    let words: String = (0..70).map(|number| format!(" X{number} F.1 G1")).collect();
    let program = format!("M3 S500\nG0{words} U? W-\nG1 Z-5\nX5");
    let analysis = analyze(program.as_bytes(), &Setup::default());
    let told: Vec<_> = analysis.diagnostics.iter().map(|told| told.message.slug()).collect();
    assert_eq!(told, ["block-too-long", "no-program-end"]);
}

#[test]
fn a_main_program_that_begins_again_is_drawn_once() {
    check("O1\nN10 G0 X1\nX2\n  M99 P10\n//^^^^^^^ W-ENDLESS");
    check("O1\nG0 X1\nM99 P10\nX2\nN10 X3\nM30");
}

#[test]
fn the_machine_zero_of_the_setup_is_known() {
    let told = |setup: &str| {
        let analysis = analyze(b"G53 X0 Z0\nM30", &Setup::from_json(setup).expect("setup"));
        analysis.diagnostics.iter().map(|told| told.message.slug()).collect::<Vec<_>>()
    };
    assert_eq!(told("{}"), ["machine-zero-unknown"]);
    assert!(told(r#"{"dialect": {"refPoint": {"x": 400, "z": 500}}}"#).is_empty());
}

#[test]
fn what_lasts_is_told_once() {
    let start = "M3 S500 F100\nG0 X60 Z2\n";
    let contour = "N1 G0 X20\nG1 Z-10\nN2 X50";
    check(&format!("{start}G73 U5 W2 R0\n//        ^^ PS0321\nG73 P1 Q2 U1\n{contour}"));
    check(&format!("{start}  G73 U5 W2\n//^^^^^^^^^ PS0321\nG73 P1 Q2 U1\n{contour}"));
    let stock = r#"{"dialect": {"feedMode": "G98"}, "stock": {"diameter": 50, "length": 60}}"#;
    check_with(stock, "M3 S1 F100\nG0 X54 Z5\nG94 X30 Z2 R-20\n//         ^^^^ W-TAPER-NOT-EXTENDED\nZ1\nZ0");
    check("M3 S500\nG1 F0\n  X5\n//^^ PS0011\nX6\nX7\nF100 X8\nF0\n  X9\n//^^ PS0011");
    check("M3 S500 F100\nG96 S120\n//  ^^^^ W-CSS-NOCLAMP\nG1 X5\nG97 S500\nG96 S100\nX9");
    check("M3 S500 F100\nG96 S120\nG50 S2000\nG0 X5");
    check("M3 S500 F100\nG96 S120\nG97 S400\nG0 X5");
}

#[test]
fn a_plane_whose_end_is_refused_is_left() {
    let head = "M45\nM13 S500 F100\nG0 X80 Z5\nG12.1\nG1 X60\n";
    check(&format!("{head}G13.1 M46\n//    ^^^ E-G121-NOT-ALONE\nG0 X90\nM30"));
    let tool =
        r#"{"dialect": {"feedMode": "G98"}, "tools": {"T0101": {"type": "endmill", "toolRadius": 4}}}"#;
    let head = "T0101\nM45\nM13 S500 F100\nG0 X80 Z5\nG12.1\nG42 G1 X60\nC10\n";
    check_with(tool, &format!("{head}  G13.1\n//^^^^^ E-G121-COMP\nG0 X90\nG40\nM30"));
}

#[test]
fn numbers_and_words_are_named_as_they_are_written() {
    let start = "M3 S500 F100\nG0 X50 Z2\n";
    let contour = "N1 G0 X20\nG1 Z-10\nN2 X50";
    let said = |program: &str| {
        let analysis = analyze(program.as_bytes(), &Setup::default());
        analysis
            .diagnostics
            .iter()
            .map(|told| told.message.sentence(Default::default()).message)
            .collect::<Vec<_>>()
    };
    let has = |program: &str, sentence: &str| {
        let said = said(program);
        assert!(said.iter().any(|own| own == sentence), "{program}\n{said:?}");
    };
    check(&format!("{start}G71 P1 Q2 D-2\n//        ^^^ E-G71-U-SIGN\n{contour}"));
    has(&format!("{start}G71 P1 Q2 D-2\n{contour}"), "The depth of cut -2 of G71 must be greater than zero.");
    has(
        "G30 P2",
        "G30 contains no axis: on FANUC controls nothing moves; others move all axes. Nothing is drawn.",
    );
    let reversed = "N10 G1 X20\nN20 Z-5\nG71 U1 R1\nG71 P20 Q10";
    has(&format!("{start}{reversed}"), "The block that `Q10` names comes before N20, which P names.");
    has(
        &format!("{start}G2 X60 Z-5 I0 K0"),
        "I and K are zero: the centre is the start point, so the arc has no radius.",
    );
    has(&format!("{start}G0 X40 ,R2"), "`,R2`: this block has no corner.");
    // At the crest itself.
    has(
        "M3 S500 F100\nG0 X30 Z5\nG76 P010060 Q100 R0.05\nG76 X28 Z-20 P1000 Q300 F1.5",
        "G76 starts at X30, exactly where its P puts the crest of the thread.",
    );
    has(
        "M3 S500\nG0 X30 Z6\nG34 Z-30 F4 K-0.3",
        "With `K-0.3` the lead of G34 is zero after 26.67 mm, but the thread is 36 mm long.",
    );
    // At the end itself.
    has(
        "M3 S500\nG0 X30 Z6\nG34 Z-34 F4 K-.2",
        "With `K-.2` the lead of G34 is zero after 40 mm, but the thread is 40 mm long.",
    );
}

#[test]
fn places_at_the_machine_are_told_in_hundredths() {
    let setup = Setup::from_json(r#"{"stock": {"diameter": 50, "length": 60}}"#).expect("setup");
    let analysis = analyze(b"T0101\nG0 X60 Z0.123\nX41.12345 Z-20.6789", &setup);
    let simulation = SimulationResult::of(&analysis.motions, &setup);
    let told = findings::diagnostics(&simulation, &analysis.motions, &setup.rules, &analysis.diagnostics);
    let sentence = told.first().expect("told").message.sentence(Default::default()).message;
    let decimals = |part: &str| part.bytes().take_while(u8::is_ascii_digit).count();
    assert!(
        sentence.contains('.') && sentence.split('.').skip(1).all(|part| decimals(part) <= 2),
        "{sentence}"
    );
}

#[test]
fn codes_that_exclude_each_other() {
    check("G98 G99 M3 S500\n//  ^^^ W-SAME-GROUP");
    check("G50 S900\nG96 G97 S500\n//  ^^^ W-SAME-GROUP");
    check("G41 G40\n//  ^^^ W-SAME-GROUP");
    check("S500 M03 M04\n//       ^^^ W-SAME-GROUP");
    // The closest correct cases.
    check("G1 G01 G28 U0 F100");
    check("G97 G98 G40 M3 S500 M8");
    let analysis = analyze(b"M05 M03 S500", &Setup::default());
    let said = analysis.diagnostics[0].message.sentence(Default::default()).message;
    assert_eq!(said, "`M03` and `M05` belong to the same modal group; `M05` takes effect.");
}

#[test]
fn a_setup_word_that_cannot_be_read_is_one_fault() {
    check("(STOCK D=50 LENGHT=80)\n//          ^^^^^^^^^ W-SETUP-NOTE\nM30");
    check("  (STOCK D=-5 LENGTH=80)\n// ^^^^^^^^^^^^^^^^^^^^ E-SETUP\nM30");
    check_fix("(STOCK D=50 LENGHT=80)\nM30", "(STOCK D=50 LENGTH=80)\nM30");
    check_fix("(STOCK D=50 LENGTH=60 WHATEVER=80)\nM30", "(STOCK D=50 LENGTH=60 WHATEVER=80)\nM30");
}

#[test]
fn words_that_were_passed_over_in_silence() {
    let start = "M3 S500 F100\nG0 X50 Z2\n";
    check(&format!("{start}G92 X48 Z-20 F2 ,C1\n//              ^^^ PS0050"));
    check(&format!("{start}G90 X48 Z-20 ,R2\n//           ^^^ PS0051"));
    check(&format!("{start}G75 R-0.5\n//  ^^^^^ PS0318\nG75 X40 P2000"));
    check("T010101\nM30".replace("T010101\n", "  T010101\n//^^^^^^^ PS0043\n").as_str());
    check("T001001\nT13013\nM30");
    check("M3 S0\n  G1 X5 F100\n//^^^^^^^^^^ W-NO-SPINDLE\nX6");
    check("  G04 X0\n//^^^^^^ W-DWELL-NO-TIME");
    check("  G04 P-100\n//^^^^^^^^^ W-DWELL-NO-TIME");
    check("  G04 F2\n//^^^^^^ W-DWELL-NO-TIME");
}

#[test]
fn marks_of_words() {
    let start = "M3 S500 F100\nG0 X50 Z2\n";
    check(&format!(
        "{start}G71 U2 R1\nG71 P1 Q2\nN1 G0 X20 Z2\n//        ^^ W-NS-BOTH-AXES\nG1 Z-10\nN2 X50"
    ));
    let head = "M45\nM13 S500 F100\nG0 X80 Z5\nG12.1\n";
    check(&format!("{head}   G1 X-80 (PAST)\n// ^^^^^^^ W-POLAR-CENTER\nG13.1"));
}

#[test]
fn repairs_of_what_was_likely_meant() {
    check_fix("hello world\nG0 X1\nM30", "(hello world)\nG0 X1\nM30");
    check_fix("G0 X1; rough the face\nM30", "G0 X1; (rough the face)\nM30");
    let start = "M3 S500 F100\nG0 X50 Z2\n";
    check_fix(
        "M13 S500 G98 F100\nG0 X0 Z5\nG83 Z-20\nG28 U0\nM30",
        "M13 S500 G98 F100\nG0 X0 Z5\nG83 Z-20\nG80\nG28 U0\nM30",
    );
    check_fix(&format!("{start}G92 X48 Z-20 F2 ,C1\nM30"), &format!("{start}G92 X48 Z-20 F2\nM30"));
    let contour = "N1 G0 X20\nG1 Z-10\nN2 X50\nM30";
    let head = "M3 S500 G98 F100\nG0 X50 Z2\nG17\nG71 U2 R1\n";
    check_fix(&format!("{head}N5 G71 P1 Q2\n{contour}"), &format!("{head}N5 G18 G71 P1 Q2\n{contour}"));
    check_fix("#1=1\n#2=(#1+1)*3 (REMARK)\nM30", "#1=1\n#2=[#1+1]*3 (REMARK)\nM30");
    check_fix("#2=SIN(30)\nM30", "#2=SIN[30]\nM30");
    check_fix("#1=1\nIF[#1 = 1]GOTO 5\nN5 M30", "#1=1\nIF[#1 EQ 1]GOTO 5\nN5 M30");
    check_fix("#1=1\nIF[#1>=1]GOTO 5\nN5 M30", "#1=1\nIF[#1 GE 1]GOTO 5\nN5 M30");
    check_fix("GOTO N10\nN10 M30", "GOTO 10\nN10 M30");
    check_fix("GOTO #10\nN10 M30", "GOTO 10\nN10 M30");
}

/// Checks slug and severity of all messages, including machine messages.
#[track_caller]
fn check_levels(setup: &str, program: &str, expected: &[(&str, Severity)]) {
    let mut analysis = analyze(program.as_bytes(), &Setup::from_json(setup).expect("setup"));
    analysis.check_at_machine();
    let told: Vec<_> =
        analysis.diagnostics.iter().map(|found| (found.message.slug(), found.severity)).collect();
    assert_eq!(told, expected, "{setup}\n{program}");
}

#[test]
fn a_setup_and_a_comment_say_how_grave_a_rule_is() {
    use Severity::{Error, Info, Warning};
    let program = "G00 X50 Z2\nG7.7\nG00 X60";
    let end = ("no-program-end", Warning);
    check_levels("{}", program, &[("unknown-g-code", Error), end]);
    let lower = r#"{"rules": {"unknown-g-code": "info"}}"#;
    check_levels(lower, program, &[("unknown-g-code", Info), end]);
    check_levels(
        r#"{"rules": {"unknown-g-code": "off", "no-program-end": "error"}}"#,
        program,
        &[(end.0, Error)],
    );
    // A comment overrides the setup, rule by rule, wherever other setup comments are.
    let noted = format!("O0001\n(Rules unknown-g-code=Warning)\n{program}");
    check_levels(lower, &noted, &[("unknown-g-code", Warning), end]);
    check_levels(r#"{"rules": {"no-program-end": "off"}}"#, &noted, &[("unknown-g-code", Warning)]);
    check_levels("{}", "(RULES UNKNOWN-G-CODE=OFF NO-PROGRAM-END=OFF)\nG7.7", &[]);
    // Messages about the setup, and about the origin of a program, have severities as well.
    check_levels("{}", "(RULES SETUP-COMMENT=ERROR QQQ=1)\nM30", &[("setup-comment", Error)]);
    check_levels(
        r#"{"rules": {"program-for-another-control": "warning"}}"#,
        "%_N_PART_MPF\nG0 X=R1\nCYCLE95(\"A\",1)",
        &[("program-for-another-control", Warning)],
    );
}

#[test]
fn messages_of_the_machine_have_levels_too() {
    let program = "(STOCK D=60 LENGTH=80)\nT0101 M3 S500\nG00 X70 Z2\nG00 X40 Z-30\nG00 Z2\nM30\n";
    let usual = |program: &str, levels: &str| {
        let mut analysis = analyze(format!("{program}{levels}").as_bytes(), &Setup::default());
        analysis.check_at_machine();
        let of_rule = |found: &&Diagnostic| found.message.slug() == "rapid-through-stock";
        analysis.diagnostics.iter().filter(of_rule).map(|found| found.severity).max()
    };
    assert_eq!(usual(program, ""), Some(Severity::Error));
    assert_eq!(usual(program, "(RULES RAPID-THROUGH-STOCK=INFO)"), Some(Severity::Info));
    assert_eq!(usual(program, "(RULES RAPID-THROUGH-STOCK=OFF)"), None);
}

#[test]
fn a_level_changes_no_motion() {
    let program = "G00 X50 Z2\nG01 X40 Y3 F0.1\nG7.7 X9\nG00 X60\nM30";
    let usual = analyze(program.as_bytes(), &Setup::default());
    let rules: Vec<String> =
        usual.diagnostics.iter().map(|found| format!("\"{}\": \"off\"", found.message.slug())).collect();
    let setup = format!(r#"{{"rules": {{{}}}}}"#, rules.join(", "));
    let quiet = analyze(program.as_bytes(), &Setup::from_json(&setup).expect("setup"));
    assert!(usual.diagnostics.iter().any(Diagnostic::is_error));
    assert_eq!(quiet.diagnostics, []);
    let ends = |analysis: &gcode_playground::run::Analysis| -> Vec<_> {
        analysis.motions.iter().map(|motion| (motion.to.x, motion.to.z, motion.process.uncertain)).collect()
    };
    assert_eq!(ends(&quiet), ends(&usual));
}

/// Disabled rules do not count towards the message limit.
#[test]
fn what_is_off_is_not_counted() {
    let program = "G7.7\n".repeat(50) + "Z1..2\nM30";
    let setup = |rules: &str| format!(r#"{{"limits": {{"messages": 10}}, "rules": {rules}}}"#);
    let told = |rules: &str| -> Vec<_> {
        let setup = Setup::from_json(&setup(rules)).expect("setup");
        let analysis = analyze(program.as_bytes(), &setup);
        analysis.diagnostics.iter().map(|found| found.message.slug()).collect()
    };
    assert_eq!(told("{}").len(), 11);
    assert_eq!(told(r#"{"unknown-g-code": "off"}"#), ["second-decimal-point"]);
}

/// A control cancels the offset for a move to a machine position and restores it afterwards.
#[test]
fn compensation_left_on_is_told_where_the_tool_goes_home() {
    let told = |end: &str| -> Vec<String> {
        let program = format!("T0101\nM3 S500\nG0 X60 Z5\nG42 G1 X50 Z2 F.2\nZ-20\nX62\n{end}\nM30");
        let setup = r#"{"tools": {"T0101": {"type": "turning", "noseRadius": 0.8, "tip": 3}}}"#;
        let analysis = analyze(program.as_bytes(), &Setup::from_json(setup).expect("setup"));
        let found =
            analysis.diagnostics.iter().filter(|found| found.message.slug() == "compensation-left-on");
        found.map(|found| String::from_utf8_lossy(found.span.of(program.as_bytes())).into_owned()).collect()
    };
    for home in ["G28", "G30", "G53", "G27"] {
        let words = if home == "G53" { "X300 Z300" } else { "U0 W0" };
        assert_eq!(told(&format!("{home} {words}")), [home]);
        // Only once: not at the end as well.
        assert_eq!(told(&format!("{home} {words}\nT0202")), [home]);
        assert_eq!(told(&format!("G40 G0 X70\n{home} {words}")), [""; 0]);
        assert_eq!(told(&format!("G40 {home} {words}")), [""; 0]);
    }
    assert_eq!(told("G0 X100"), ["M30"]);
}

#[test]
fn a_block_of_a_cycle_without_an_axis_makes_no_pass() {
    let start = "M3 S500\nG0 X54 Z5\nG94 X30 Z0 R-4 F100\n";
    check(&format!("{start}  R-8\n//^^^ W-CYCLE-NO-AXIS\n  R-12 F80\n//^^^^ W-CYCLE-NO-AXIS\nG0 X100"));
    check(&format!("{start}Z0 R-8\nX30 R-12\nG0 X100"));
    check_fix(&format!("{start}R-8\nG0 X100\nM30"), &format!("{start}Z0 R-8\nG0 X100\nM30"));
    let incremental = "M3 S500\nG0 X54 Z5\nG90 W-30 U-4 R-1 F100\n";
    check_fix(&format!("{incremental}R-2\nG0 X100\nM30"), &format!("{incremental}U-4 R-2\nG0 X100\nM30"));
    // Repeating the code makes no pass either; the first block with the code may only set the taper.
    check(&format!("{start}G94 R-8\n//  ^^^ W-CYCLE-NO-AXIS\nG0 X100"));
    check("M3 S500\nG0 X54 Z5\nG94 R-4 F100\nX30 Z0\nG0 X100");
    // An F that a later cut uses has an effect; one that is replaced before any cut does not.
    check(&format!("{start}F80\nZ-1\nG0 X100"));
    check(&format!("{start}F80\nG0 X100\nG1 X90"));
    check(&format!("{start}  F80\n//^^^ W-CYCLE-NO-AXIS\nG0 X100\nG1 X90 F50"));
    check(&format!("{start}  F80\n//^^^ W-CYCLE-NO-AXIS\nG0 X100\nM30"));
    check(&format!("{start}M8\nG4 X1\nG0 X100"));
}

/// The page translates severity and category itself: its table must match the command line.
#[test]
fn the_page_names_severities_and_categories_as_the_command_line_does() {
    let table = std::fs::read_to_string("www/src/editor/problem-words.ts").expect("the table of the page");
    for language in Language::ALL {
        let own = table.split(&format!("  {}: {{", language.tag())).nth(1).expect("a table of each language");
        let words = |name: &str| -> Vec<String> {
            let row = own.split(&format!("{name}: {{")).nth(1).and_then(|rest| rest.split('}').next());
            row.expect("a row").split('\'').skip(1).step_by(2).map(str::to_owned).collect()
        };
        let severities = [Severity::Error, Severity::Warning, Severity::Info];
        assert_eq!(words("severity"), severities.map(|own| labels::severity(own, language)));
        // Beside a message, the category `wrong` is not shown.
        let categories = [Kind::Unsupported, Kind::Machine].map(|own| labels::category(own, language));
        assert_eq!(words("kind"), ["", categories[0], categories[1]]);
    }
}
