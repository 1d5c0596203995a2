//! Messages at their exact place: the carets under a line mark the span, the code stands behind them.
#![cfg(not(target_arch = "wasm32"))]

use gcode_playground::analyze;
use gcode_playground::control::setup::Setup;
use gcode_playground::diagnostics::{Diagnostic, Severity};
use gcode_playground::text::source::LineIndex;

/// The one door: a program whose annotated lines (`//  ^^^ CODE`) are all its messages but hints.
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
        (at.line as usize + 1, at.column as usize, length, found.message.code().to_owned())
    };
    let found: Vec<_> = analysis.diagnostics.iter().map(place).filter(|row| row.3 != "W-NO-END").collect();
    assert_eq!(found, expected, "\n{program}");
}

#[track_caller]
fn check(annotated: &str) {
    check_with(r#"{"dialect": {"feedMode": "G98"}}"#, annotated);
}

/// The one door of repairs: applied, they give the other text.
#[track_caller]
fn check_fix(before: &str, after: &str) {
    let analysis = analyze(before.as_bytes(), &Setup::default());
    let mut edits: Vec<_> = analysis
        .diagnostics
        .iter()
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

#[test]
fn an_arc_with_a_radius_and_no_end_point_is_told() {
    check("M3 S500 F100\nG00 X50 Z5\n   G03 R5\n// ^^^^^^ W-ARC-NOWHERE");
}

#[test]
fn writing() {
    check("G00 X12.8. Z5\n//  ^^^^^^ PS0007");
    check("G00 X50 Z\n//      ^ PS0005");
    check("G00 X50 ?\n//      ^ PS0009");
    check("G00 X50 Z,15\n//      ^^^^ W-OCR");
    check("   GO1 X50\n// ^^^ W-OCR");
    check("   hello world\n// ^^^^^^^^^^^ W-PLAIN-TEXT");
    check("G00 (open\n//  ^ W-COMMENT-OPEN");
}

#[test]
fn codes_and_words() {
    check("   G777 X5\n// ^^^^ PS0010");
    check("M3 S-100\n// ^^^^^ PS0006");
    check("M3 S1.5\n// ^^^^ PS0007");
    check("G00 X50 X60\n//      ^^^ W-DUP-WORD");
    check("G00 X50 U6\n//  ^^^^^^ W-X-AND-U");
    check("G00 G01 X50 F100 M3\n//  ^^^ W-SAME-GROUP");
    check("G50 X100 Z100 T0101\n//            ^^^^^ PS0245");
    check("G00 X50 T1\n//      ^^ W-T1");
    check("G21 G90 G98\n//  ^^^ W-G90-MILL");
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
    check("M3 S500\nG01 X50 F100\n   G99 X40\n// ^^^^^^^ W-FEED-KEPT");
    check("   G01 X50 F100\n// ^^^^^^^^^^^^ W-NO-SPINDLE\nX40");
    check("G96 S120 M3\n//  ^^^^ W-CSS-NOCLAMP");
    check("G50 S1000 Q2000\n//        ^^^^^ W-CSS-UNSET");
    check("G50 S1000\nG96 S100 M3\n   G32 Z5 F2\n// ^^^^^^^^^ W-THREAD-CSS");
    // The nearest cases that are right.
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
    check_with(gsk, "M3 S1 F100\nG0 X60 Z0\nG90 X50 Z-30 R5");
    check_with(gsk, "M3 S1 F100\nG0 X60 Z0\nG90 X60 Z-30 R-8");
    check_with(gsk, "M3 S1 F100\nG0 X60 Z5\nG94 X50 Z0 R8\n//         ^^ E-TAPER-R");
    let stock = r#"{"dialect": {"feedMode": "G98"}, "stock": {"diameter": 50, "length": 60}}"#;
    check_with(stock, "M3 S1 F100\nG0 X54 Z5\nG94 X30 Z0 R-20\n//         ^^^^ W-TAPER-NOT-EXTENDED");
    check_with(stock, "M3 S1 F100\nG0 X54 Z5\nG94 X30 Z0 R-24");
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
}

#[test]
fn cycles_and_corners() {
    let start = "M3 S500 F100\nG0 X50 Z2\n";
    let contour = "N1 G0 X20\nG1 Z-10\nN2 X50";
    check(&format!("{start}G71 U2 R1\nG71 X20 P1 Q2 U0 W0\n//  ^^^ PS0066\n{contour}"));
    check(&format!("{start}G71 U2 R1\nG71 P1 Q2 U0 W0\n{contour}\nG70 P1 Q2"));
    check(&format!("{start}   G71 P1 Q2 U0 W0\n// ^^^^^^^^^^^^^^^ W-G71-U-ROLE\n{contour}"));
    check(&format!("{start}G71 U-2 R1\n//  ^^^ W-G71-U-SIGN\nG71 P1 Q2\n{contour}"));
    check(&format!("{start}G71 U2 R1\nG71 P1 Q9\n//     ^^ W-NS-NOT-FOUND\n{contour}"));
    check(&format!("{start}G17\nG71 U2 R1\n   G71 P1 Q2\n// ^^^^^^^^^ PS0327\n{contour}"));
    check(&format!("{start}G90 X40 C20 Z-20\n//      ^^^ PS0330"));
    check(&format!("{start}{contour}\n   G70 P1 Q2\n// ^^^^^^^^^ W-G70-NO-ROUGH"));
    check(&format!("{start}G71 U2 R1\nG71 P1 Q2\n{contour}\nG0 X60\n   G70 P1 Q2\n// ^^^^^^^^^ W-G70-START"));
    check(&format!("{start}G74 R1\nG74 Z-12 Q5\n//       ^^ W-PQ-UNIT"));
    check(&format!("{start}G1 Z-20 C2 R1\n//      ^^ PS0053"));
    check(&format!("{start}G32 Z-20 F2 R2\n//          ^^ PS0050"));
    check(&format!("{start}G1 Z-20 ,C30\n//      ^^^^ PS0055\nX60"));
    check(&format!("{start}G1 Z-20 ,C2\n//      ^^^ PS0052\nG0 X60"));
    check(&format!("{start}G1 Z-20 I-2\n//      ^^^ PS0051\nX60"));
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
    // A code of group 01 ends it, even in a block that cannot be carried out.
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

/// The one door of levels: slug and severity of all messages, those of the machine among them.
#[track_caller]
fn check_levels(setup: &str, program: &str, expected: &[(&str, Severity)]) {
    let mut analysis = analyze(program.as_bytes(), &Setup::from_json(setup).expect("setup"));
    analysis.look_at_machine();
    let told: Vec<_> =
        analysis.diagnostics.iter().map(|found| (found.message.slug(), found.severity)).collect();
    assert_eq!(told, expected, "{setup}\n{program}");
}

#[test]
fn a_setup_and_a_comment_say_how_grave_a_rule_is() {
    use Severity::{Error, Info, Warning};
    let program = "G00 X50 Z2\nG777\nG00 X60";
    let end = ("no-program-end", Warning);
    check_levels("{}", program, &[("unknown-g-code", Error), end]);
    let lower = r#"{"rules": {"unknown-g-code": "info"}}"#;
    check_levels(lower, program, &[("unknown-g-code", Info), end]);
    check_levels(
        r#"{"rules": {"unknown-g-code": "off", "no-program-end": "error"}}"#,
        program,
        &[(end.0, Error)],
    );
    // A comment goes before the setup, rule by rule, wherever other comments of the setup stand.
    let noted = format!("O0001\n(Rules unknown-g-code=Warning)\n{program}");
    check_levels(lower, &noted, &[("unknown-g-code", Warning), end]);
    check_levels(r#"{"rules": {"no-program-end": "off"}}"#, &noted, &[("unknown-g-code", Warning)]);
    check_levels("{}", "(RULES UNKNOWN-G-CODE=OFF NO-PROGRAM-END=OFF)\nG777", &[]);
    // What is told of the setup itself, and of where a program comes from, has levels as well.
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
        analysis.look_at_machine();
        let of_rule = |found: &&Diagnostic| found.message.slug() == "rapid-through-stock";
        analysis.diagnostics.iter().filter(of_rule).map(|found| found.severity).max()
    };
    assert_eq!(usual(program, ""), Some(Severity::Error));
    assert_eq!(usual(program, "(RULES RAPID-THROUGH-STOCK=INFO)"), Some(Severity::Info));
    assert_eq!(usual(program, "(RULES RAPID-THROUGH-STOCK=OFF)"), None);
}

#[test]
fn a_level_changes_no_motion() {
    let program = "G00 X50 Z2\nG01 X40 Y3 F0.1\nG777 X9\nG00 X60\nM30";
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

/// What is off takes no room from what is told.
#[test]
fn what_is_off_is_not_counted() {
    let program = "G777\n".repeat(50) + "Z1..2\nM30";
    let setup = |rules: &str| format!(r#"{{"limits": {{"messages": 10}}, "rules": {rules}}}"#);
    let told = |rules: &str| -> Vec<_> {
        let setup = Setup::from_json(&setup(rules)).expect("setup");
        let analysis = analyze(program.as_bytes(), &setup);
        analysis.diagnostics.iter().map(|found| found.message.slug()).collect()
    };
    assert_eq!(told("{}").len(), 11);
    assert_eq!(told(r#"{"unknown-g-code": "off"}"#), ["second-decimal-point"]);
}
