//! How a file is read, calculated by hand: control characters, programs of other controls, G-code systems,
//! program names.
use gcode_playground::analyze;
use gcode_playground::message::Severity;
use gcode_playground::message::applied;
use gcode_playground::repair::repaired;
use gcode_playground::run::{Run, TextEdit};
use gcode_playground::sentences::Language;
use gcode_playground::setup::Setup;

/// The messages of a program: slug and line, counted from 1. The slug of a note has a question mark, that of
/// a warning an exclamation mark.
fn told(text: &str, setup: &str) -> Vec<String> {
    let analysis = analyze(text.as_bytes(), &Setup::from_json(setup).expect("a setup"));
    let told = analysis.diagnostics.into_iter().map(|told| {
        let line = text[..told.span.start as usize].matches('\n').count() + 1;
        let mark = match told.severity {
            Severity::Info => "?",
            Severity::Warning => "!",
            Severity::Error | Severity::Off => "",
        };
        format!("{}{mark} {line}", told.message.slug())
    });
    told.collect()
}

/// End points of the moves: X as a diameter, Z.
fn ends(text: &str, setup: &str) -> Vec<(f64, f64)> {
    let analysis = analyze(text.as_bytes(), &Setup::from_json(setup).expect("a setup"));
    let round = |value: f64| (value * 1e4).round() / 1e4;
    analysis.motions.iter().map(|motion| (round(2.0 * motion.to.x), round(motion.to.z))).collect()
}

/// Remarks without brackets and unclosed comments are a habit: each is reported once, at the first
/// occurrence, with the number of the others, and its fix applies to all. A bracket before a word that may
/// belong to the block is a separate error.
#[test]
fn a_habit_is_reported_once_and_repaired_everywhere() {
    let text = "O1\nG0 X50 Z2 M3 S500; approach\nG1 Z-5 F0.2; rough it\nX60 (shoulder\n(face X20\nG0 X100; retract\nZ50 (home\nM30\n";
    let expected = ["text-after-semicolon! 2", "comment-not-closed! 4", "comment-not-closed 5"];
    assert_eq!(told(text, "{}"), expected);
    let analysis = analyze(text.as_bytes(), &Setup::default());
    let said: Vec<String> =
        analysis.diagnostics.iter().map(|told| told.sentence(Language::English).message).collect();
    assert_eq!(said[0], "`approach` after the `;` was taken as a comment (further places: 2).");
    assert!(said[1].starts_with("This bracket is not closed (further places: 1)"), "{said:?}");
    assert!(said[2].starts_with("This bracket is not closed;"), "{said:?}");
    let repaired = repaired(text.as_bytes(), &Setup::default());
    let right = "O1\nG0 X50 Z2 M3 S500; (approach)\nG1 Z-5 F0.2; (rough it)\nX60 (shoulder)\n(face X20\nG0 X100; (retract)\nZ50 (home)\nM30\n";
    assert_eq!(String::from_utf8_lossy(&repaired.text), right);
}

/// A control ignores everything from `(` to `)`. The lines of text in between are part of the comment: one
/// message, at the bracket. Further lines that are blocks are executed, and reported as usual.
#[test]
fn a_comment_over_several_lines_is_one() {
    for (remark, after) in [
        ("(first line\nsecond line 1.5\nthird)", 5),
        ("(X=minor diam., Z=into\ngroove, K=depth, D=first\nsides, F=feed=1/TPI=1/16, by table )", 5),
        ("(rough the face\r\nto 1.5 and X5O)", 4),
    ] {
        let text = format!("O1\nG0 X50 Z2 M3 S500 {remark}\nG1 Z-5 F0.2\nM30\n");
        assert_eq!(told(&text, "{}"), ["comment-not-closed! 2"], "{remark}");
        assert_eq!(ends(&text, "{}").len(), 2);
        assert_eq!(text.lines().nth(after - 1), Some("G1 Z-5 F0.2"));
        let analysis = analyze(text.as_bytes(), &Setup::default());
        let fixed = applied(text.as_bytes(), &analysis.diagnostics[0].fixes[0].edits);
        assert_eq!(told(&String::from_utf8(fixed).expect("UTF-8"), "{}"), [""; 0], "{remark}");
    }
    let blocks = told("O1\nG0 X50 Z2 M3 S500 (rough\nX20 1.5\nG1 Z-5 F0.2)\nM30\n", "{}");
    assert!(blocks.len() > 1, "{blocks:?}");
    let far =
        told(&format!("O1\nG0 X50 Z2 M3 S500 (rough\n{}end)\nM30\n", "more text 1.5\n".repeat(7)), "{}");
    assert!(far.len() > 1, "{far:?}");
}

/// Editing one bracket changes how the surrounding lines are read, as in a new run.
#[test]
fn the_brackets_of_a_long_comment_can_be_typed() {
    let cuts = |from: usize| (from..from + 3000).map(|z| format!("G1 Z-{z}. F0.2\n")).collect::<String>();
    let text =
        format!("O1\nG0 X50 Z2 M3 S500\n{}(first line\nsecond 1.5\nthird)\n{}M30\n", cuts(1), cuts(4001));
    for bracket in ["(first", "third)"] {
        let place = text.find(bracket).expect("there") + if bracket.starts_with('(') { 0 } else { 5 };
        let mut run = Run::new(text.clone().into_bytes(), Setup::default());
        while !run.advance(usize::MAX) {}
        let without = TextEdit { start: place, end: place + 1, insert: Vec::new() };
        let back = TextEdit { start: place, end: place, insert: vec![text.as_bytes()[place]] };
        for edit in [without, back] {
            run.edit(edit);
            while !run.advance(usize::MAX) {}
            let fresh = analyze(run.text(), &Setup::default());
            assert_eq!(run.diagnostics(), fresh.diagnostics);
        }
    }
}

/// B-64304EN (ISO code): a tape contains NUL, DC1 to DC4 and DEL, which are not significant: they are never
/// part of a word.
#[test]
fn control_characters_are_passed_over_outside_comments() {
    let plain =
        "%\nO0001\nG21 G99 G97 S500 M03 T0101\nG00 X60. Z2.\nG01 Z-14. F.2\nG00 X100. Z100.\nM30\n%\n";
    for byte in (1..=0x1Fu8).filter(|byte| !b"\n\r".contains(byte)).chain([0, 0x7F]) {
        let sign = char::from(byte);
        let marked: String = plain
            .lines()
            .map(|line| format!("{sign}{}{sign}\n", line.replace(' ', &format!("{sign} "))))
            .collect();
        assert_eq!(told(&marked, "{}"), told(plain, "{}"), "{byte:#x}");
        assert_eq!(ends(&marked, "{}"), [(60.0, 2.0), (60.0, -14.0), (100.0, 100.0)], "{byte:#x}");
    }
}

/// B-64484EN, program components: the text before the first `%` is the tape start section, and the control
/// skips it.
#[test]
fn text_before_the_first_percent_sign_is_a_leader() {
    let program =
        "%\nO0001\nG21 G99 G97 S500 M03 T0101\nG00 X60. Z2.\nG01 Z-14. F.2\nG00 X100. Z100.\nM30\n%\n";
    let way = [(60.0, 2.0), (60.0, -14.0), (100.0, 100.0)];
    for leader in [
        "PAWN 30",
        "国王  35",
        "车",
        "毛坯料宽40 长露出超过90",
        "SHAFT\n\n  DRAWING NO 12-3 (REV A)\n---",
        "Made by: me; 2026-11-27",
    ] {
        for end in ["\n", "\r\n", "\n\n \n"] {
            let text = format!("{leader}{end}{program}");
            assert_eq!(told(&text, "{}"), [""; 0], "{text}");
            assert_eq!(ends(&text, "{}"), way, "{text}");
        }
        // `%O0001`: the number may be on the line of the sign.
        let text = format!("{leader}\n{}", program.replacen("%\n", "%", 1));
        assert_eq!((told(&text, "{}"), ends(&text, "{}")), (vec![], way.to_vec()), "{text}");
    }
}

/// A faulty program is not a leader: neither before a single `%` at its end, nor before another program.
#[test]
fn a_program_before_a_percent_sign_is_read() {
    for (text, expected) in [
        ("PAWN 30\n%\n", vec!["number-missing 1"; 3]),
        ("Hello world\n%", vec!["text-outside-comment 1"]),
        ("Hello world\n%\n%\n", vec!["text-outside-comment 1"]),
        ("GO0 X60.\n%\nO2\nM30\n%\n", vec!["letter-for-digit 1"]),
        ("O1 SHAFT\nX\n%\nO2\nM30\n%\n", vec!["text-outside-comment 1", "number-missing 2"]),
    ] {
        let told: Vec<_> = told(text, "{}").into_iter().filter(|told| !told.contains(['!', '?'])).collect();
        assert_eq!(told, expected, "{text}");
    }
    let text = "HEAD\nG00 X60. Z2.\n%\nO2\nG00 X50. Z2.\nM30\n%\n";
    assert_eq!(ends(text, "{}"), [(60.0, 2.0)]);
}

/// X20,5 can only mean X20.5: the alarm stays, but the block is executed as with a point, also in blocks of
/// cycles.
#[test]
fn a_decimal_comma_is_read_as_a_point() {
    let head = "O0001\nG21 G99 G97 S500 M03 T0101\nG00 X62. Z2.\n";
    for body in [
        "G01 X20,5 F0,2\nZ-20\nX62.",
        "G01 X20.5 F0,2\nG02 X30,5 Z-3,0 R5,0\nG01 X62.",
        "G71 U2 R1\nG71 P10 Q20 U1 W0,2 F0,3\nN10 G00 X30,5\nG01 Z-20\nN20 X60.",
        "G75 R0,5\nG75 X56,08 Z-10 P2000 Q2000 F0,1",
        "G90 X50,5 Z-10. F0,2\nX40,5",
        "G01 X30. ,R2,5 F0,2\nZ-20,5 ,C1,5\nX62.",
        "G32 Z-20,5 F1,5\nG00 X62.",
    ] {
        let text = format!("{head}{body}\nG00 X100. Z100.\nM30\n");
        let point = |text: &str| {
            let mut signs: Vec<char> = text.chars().collect();
            for at in 1..signs.len() - 1 {
                if signs[at] == ',' && signs[at - 1].is_ascii_digit() && signs[at + 1].is_ascii_digit() {
                    signs[at] = '.';
                }
            }
            signs.into_iter().collect::<String>()
        };
        let meant = point(&text);
        let ends_meant = ends(&meant, "{}");
        assert_eq!(ends(&text, "{}"), ends_meant, "{text}");
        assert!(ends_meant.len() >= 3, "{text}");
        let (commas, others): (Vec<_>, Vec<_>) =
            told(&text, "{}").into_iter().partition(|told| told.starts_with("comma-for-point "));
        assert_eq!(others, told(&meant, "{}"), "{text}");
        assert_eq!(
            commas.len(),
            text.chars().zip(meant.chars()).filter(|(was, is)| was != is).count(),
            "{text}"
        );
    }
    let turned = format!("{head}G01 X20,5 F0,2\nZ-20\nG00 X100. Z100.\nM30\n");
    assert_eq!(ends(&turned, "{}"), [(62.0, 2.0), (20.5, 2.0), (20.5, -20.0), (100.0, 100.0)]);
    // Two commas in a number, or too many digits: the word is not read.
    for word in ["X1,2,3", "X20.5,5", "X12345678,5"] {
        let text = format!("{head}G01 {word} F.2\nG00 X100. Z100.\nM30\n");
        assert_eq!(ends(&text, "{}"), [(62.0, 2.0), (100.0, 100.0)], "{text}");
    }
}

/// A corner word needs a block that moves along a path; elsewhere it is not read.
#[test]
fn corner_words_without_a_corner_are_reported() {
    for block in [
        "G71 U2. R1. ,R2",
        "G74 R1. ,R2\nG74 Z-20. Q2000 F.1",
        "G76 P010060 Q50 R.05 ,C1",
        "G04 X1. ,R2",
        "G28 U0 W0 ,R2",
        "G50 S2000 ,R2",
        "G53 X0 Z0 ,C1",
        "G01 ,R2",
        "G00 ,R2",
        "M08 ,R2",
    ] {
        let text = format!(
            "O1\nG21 G99 G97 S500 M03 T0101\nG00 X60. Z2.\nG01 X58. F.2\n{block}\nG00 X100. Z100.\nM30\n"
        );
        let told = told(&text, "{}");
        assert!(told.contains(&"word-without-effect! 5".to_owned()), "{block} {told:?}");
    }
    for block in ["G01 X50. ,R2\nZ-20.", "G01 Z-5. ,C1\nX62.", "G01 ,A135 X62.", "G65 P1 ,R2", "M98 P1 ,R2"] {
        let text = format!(
            "O1\nG21 G99 G97 S500 M03 T0101\nG00 X40. Z2.\nG01 X38. F.2\n{block}\nG00 X100. Z100.\nM30\n"
        );
        assert!(!told(&text, "{}").contains(&"word-without-effect! 5".to_owned()), "{block}");
    }
}

/// The reported meaning of a misread word applies to everything after it: T0303 is station 3 with offset 3.
#[test]
fn a_misread_tool_word_has_a_station() {
    let text = |tool: &str| {
        format!(
            "O1\nG21 G40 G99 G97 S500 M03 T0101\nG00 X32. Z2.\nG01 X28. F.2\nG00 X60. Z50.\n{tool}\nG00 X32. Z-25.\nG01 X2. F.05\nG00 X60.\nM30\n"
        )
    };
    for tool in ["TO3O3", "T03O3", "To3o3"] {
        assert_eq!(told(&text(tool), "{}"), ["letter-for-digit 6"], "{tool}");
        let analysis = analyze(text(tool).as_bytes(), &Setup::default());
        let tools: Vec<_> = analysis.motions.iter().map(|motion| motion.process.tool).collect();
        let meant = analyze(text("T0303").as_bytes(), &Setup::default());
        assert_eq!(tools, meant.motions.iter().map(|motion| motion.process.tool).collect::<Vec<_>>());
    }
}

/// System B of FANUC: G92 sets coordinates, G94 is feed per minute. Codes of two cycles of system A without
/// an axis are not cycles.
#[test]
fn a_head_with_a_setting_of_coordinates_and_g94_g90_is_system_b() {
    let text = "N10 G92 X100 Z50\nN20 G94 G90\nN30 T0101\nN40 S1000 M03\nN50 G00 X32 Z2\nN60 G01 X28 F100\nN70 Z-20\nN80 G00 X100 Z50\nN90 M30\n";
    let named = r#"{"dialect": {"gSystem": "B"}}"#;
    assert_eq!(ends(text, "{}"), ends(text, named));
    assert_eq!(told(text, "{}"), ["g-code-system-concluded? 2"]);
}

/// HNC, programming manual, G71: one block has depth, retract, contour and allowances.
#[test]
fn roughing_of_hnc_in_one_block_is_recognised() {
    for cycle in [
        "G71 U2 R1 P10 Q20 U0.4 W0.1 F100",
        "G71 U7.0 R1.0 P10 Q20 U4.0 W2.0 S500",
        "G71 U2 R1 P10 Q20 X0.4 Z0.1 F100",
    ] {
        let text = format!(
            "%0003\nT0101\nM03 S800\nG00 X46 Z3\n{cycle}\nN10 G00 X20\nG01 Z-20\nX30\nN20 Z-40\nG00 X80 Z80\nM30\n"
        );
        let told = told(&text, "{}");
        assert!(told.len() == 1 && told[0].starts_with("program-for-another-control "), "{told:?}");
    }
}

/// B-64484EN, program name: 32 characters in `< >`, called by `M98 <NAME>` and `G65 <NAME>`.
#[test]
fn programs_are_called_by_their_names() {
    let text = |head: &str, call: &str, sub: &str| {
        format!(
            "%\n{head}\nG21 G99 G97 S500 M03 T0101\nG00 X52. Z2.\n{call}\nG00 X100. Z100.\nM30\n{sub}\nG01 W-5. F.2\nM99\n%\n"
        )
    };
    let twice = [(52.0, 2.0), (52.0, -3.0), (52.0, -8.0), (100.0, 100.0)];
    for (head, call, sub) in [
        ("<SHAFT-1>", "M98 <SUB1> L2", "<SUB1>"),
        ("<SHAFT-1>", "M98 <SUB1> L2", "O<SUB1>"),
        ("O<SHAFT-1> (TURNED)", "M98<sub1>L2", "<SUB1> (CUT)"),
        ("O1234<SHAFT-1>", "G65 <SUB.2> L2", "<SUB.2>"),
        ("O1234", "M98 P20007", "O0007<SUB1>"),
        ("O1234", "M98 <FINISHING PASS> L2", "O0007 <FINISHING PASS>"),
        ("", "M98 <SUB1>\nM98 <SUB1>", "<SUB1>"),
    ] {
        let text = text(head, call, sub);
        assert_eq!(told(&text, "{}"), [""; 0], "{text}");
        assert_eq!(ends(&text, "{}"), twice, "{text}");
    }
    let missing = text("<MAIN>", "M98 <SUB2>", "<SUB1>");
    assert_eq!(told(&missing, "{}"), ["program-not-found! 5", "program-not-run? 8"]);
    let analysis = analyze(missing.as_bytes(), &Setup::default());
    let said =
        analysis.diagnostics.iter().map(|told| told.span.quote(missing.as_bytes())).collect::<Vec<_>>();
    assert_eq!(said, ["<SUB2>", "<SUB1>"]);
    assert!(told(&text("<SUB1>", "", "<SUB1>"), "{}").contains(&"duplicate-program-number! 8".to_owned()));
}

/// A name is valid at the head of a block and after the code of a call; elsewhere it is not a word.
#[test]
fn a_name_without_a_place_is_reported() {
    for block in ["G00 X50. <NAME>", "M98 P1000 <", "N10 <NAME>", "M98 <NA*ME>", "IF[#1<2]GOTO5"] {
        let text = format!("O1\nG21 G99 G97 S500 M03 T0101\n{block}\nG00 X100. Z100.\nM30\n");
        assert!(
            told(&text, "{}").iter().any(|told| told.ends_with(" 3") && !told.contains(['!', '?'])),
            "{block}"
        );
    }
}

const GSK: &str = r#"{"dialect": {"control": "gsk"}}"#;

/// GSK980TDi manual, macro command list: the loop turns X48, X46 and X44; the jump skips `G0 X1`.
#[test]
fn macro_a_assigns_and_jumps() {
    let text = "O0010\nG98 M3 S500 T0101\nG0 X50 Z2\nG65 H01 P#200 Q3\nN20 G0 U-2\nG1 W-5 F100\nG0 W5\nG65 H03 P#200 Q#200 R1\n\
                G65 H83 P20 Q#200 R0\nG65 H80 P90\nG0 X1\nN90 G0 X100 Z100\nM30\n";
    let round = |x: f64| [(x, 2.0), (x, -3.0), (x, 2.0)];
    let expected =
        [[(50.0, 2.0)].as_slice(), &round(48.0), &round(46.0), &round(44.0), &[(100.0, 100.0)]].concat();
    assert_eq!(ends(text, GSK), expected);
    assert_eq!(told(text, GSK), [""; 0]);
}

/// Each operation of the list, calculated by hand; X is a diameter in millimetres.
#[test]
fn macro_a_has_the_operations_of_the_manual() {
    for (operation, expected) in [
        ("H01 P#200 Q-12", -12.0),
        ("H02 P#200 Q30 R12", 42.0),
        ("H03 P#200 Q30 R#500", 25.0),
        ("H04 P#200 Q#500 R7", 35.0),
        ("H05 P#200 Q7 R2", 3.5),
        ("H11 P#200 Q12 R10", 14.0),
        ("H12 P#200 Q12 R10", 8.0),
        ("H13 P#200 Q12 R10", 6.0),
        ("H21 P#200 Q49", 7.0),
        ("H22 P#200 Q-7", 7.0),
        ("H23 P#200 Q17 R#500", 2.0),
        ("H24 P#200 Q18", 12.0),
        ("H25 P#200 Q12", 18.0),
        ("H26 P#500 Q4 R10", 2.0),
        ("H27 P#200 Q30 R40", 50.0),
        ("H28 P#200 Q50 R30", 40.0),
        ("H31 P#200 Q40 R30", 20.0),
        ("H32 P#200 Q40 R60", 20.0),
        ("H33 P#200 Q10 R45", 10.0),
        ("H34 P#200 Q1 R1", 45.0),
    ] {
        let to = if operation.contains("P#500") { "#500" } else { "#200" };
        let text = format!("O1\nG98 M3 S500 T0101\n#500=5\nG65 {operation}\nG0 X{to} Z2\nM30\n");
        assert_eq!(ends(&text, GSK), [(expected, 2.0)], "{operation}");
    }
}

#[test]
fn macro_a_compares() {
    let jumps = |operation: u32, q: i32| {
        let text =
            format!("O1\nG98 M3 S500 T0101\nG65 H{operation} P90 Q{q} R5\nG0 X1\nN90 G0 X100 Z100\nM30\n");
        ends(&text, GSK).len() == 1
    };
    for (operation, expected) in [
        (80, [true; 3]),
        (81, [false, true, false]),
        (82, [true, false, true]),
        (83, [false, false, true]),
        (84, [true, false, false]),
        (85, [false, true, true]),
        (86, [true, true, false]),
    ] {
        assert_eq!([4, 5, 6].map(|q| jumps(operation, q)), expected, "H{operation}");
    }
}

#[test]
fn macro_a_says_what_it_cannot_do() {
    let says = |operation: &str, setup: &str| {
        told(&format!("O1\nG99 M3 S500 T0101\n{operation}\nG0 X50 Z2\nM30\n"), setup)
    };
    // H99: alarm 500+n; the program stops.
    let text = "O1\nG65 H99 P3\nG0 X50 Z2\nM30\n";
    assert_eq!((told(text, GSK), ends(text, GSK).len()), (vec!["macro-alarm 2".to_owned()], 0));
    let analysis = analyze(text.as_bytes(), &Setup::from_json(GSK).expect("a setup"));
    assert!(format!("{:?}", analysis.diagnostics[0].message).contains("503"));
    assert_eq!(says("G65 H14 P#200 Q1", GSK), ["not-supported! 3"]);
    assert_eq!(says("G65 H02 P#200 Q1", GSK), ["macro-format 3"]);
    assert_eq!(says("G65 H05 P#200 Q1 R0", GSK), ["macro-division-by-zero 3"]);
    assert_eq!(says("G65 H80 P77", GSK), ["sequence-number-not-found 3"]);
    // FANUC 0 also has macro A, but without these variables.
    assert_eq!(says("G65 H01 P#100 Q3", "{}"), [""; 0]);
    assert_eq!(says("G65 H01 P#200 Q3", "{}"), ["macro-variable-number 3"]);
    // In a program call, H is an ordinary argument.
    let text = "O1\nG99 M3 S500 T0101\nG65 H20 P9010\nM30\nO9010\nG0 X#11 Z2\nM99\n";
    assert_eq!(ends(text, "{}"), [(20.0, 2.0)]);
}

/// A program is read in the system in which it is written, as if the setup named it.
#[test]
fn programs_in_systems_b_and_c_are_read_in_them() {
    let emco = "O0078\nG54\nG92 S2000\nT0101\nG96 S180 M04\nG95\nG00 X52. Z2.\nG73 U2. R1.\nG73 P10 Q20 U.5 W.1 F.25\n\
                N10 G00 X30.\nG01 Z-25. F.1\nN20 X52.\nG72 P10 Q20\nG00 X100. Z50.\nT0303\nG97 S500 M03\nG00 X34. Z4.\n\
                G78 P021560 Q50 R.02\nG78 X27.4 Z-20. P1300 Q400 F2.\nG00 X100. Z50.\nM30\n";
    let fusion = "O1001\nG90 G94 G18\nG21\nG92 S4000\nG28 U0.\nT0101\nG90 G95 G18\nG54\nG97 S600 M3\nG0 X50. Z5.\nG92 S3000\n\
                  G96 S190 M3\nG0 Z2.\nX40.\nG1 X36. F0.2\nZ-20.\nX50.\nG0 Z5.\nG28 U0.\nM30\n";
    for (text, system, note) in
        [(emco, "C", "g-code-system-concluded? 18"), (fusion, "B", "g-code-system-concluded? 4")]
    {
        let named = format!(r#"{{"dialect": {{"gSystem": "{system}"}}}}"#);
        assert_eq!(ends(text, "{}"), ends(text, &named), "{system}");
        let told = told(text, "{}");
        assert!(told.contains(&note.to_owned()), "{told:?}");
        assert!(!told.iter().any(|told| !told.contains(['?', '!'])), "{told:?}");
    }
    // Roughing in passes of 2 mm in front of an allowance of 0.5: X48.5, X44.5, X40.5, X36.5, X32.5; the finish at X30.
    let levels = ends(emco, "{}").into_iter().filter(|&(_, z)| z < -20.0).map(|(x, _)| x);
    let levels: Vec<f64> = levels.collect();
    assert!([48.5, 44.5, 40.5, 36.5, 32.5, 30.0].iter().all(|level| levels.contains(level)), "{levels:?}");
}

/// Haas operator's manual, G112: Y is the second axis of the plane, a length; X is a diameter.
#[test]
fn y_is_the_second_axis_of_polar_interpolation() {
    let program = |second: &str| {
        format!(
            "O1\nG21 G98 G17\nT0505\nG97 S500 M03\nG00 X80. Z2. C0.\nG112\nG01 Z-1. F100.\nG01 X20. {second}15.\nG03 X-20. {second}15. R30.\nG113\nG00 X100. Z100.\nM30\n"
        )
    };
    assert_eq!(ends(&program("Y"), "{}"), ends(&program("C"), "{}"));
    let with_c = told(&program("C"), "{}");
    let mut with_y = told(&program("Y"), "{}");
    with_y.retain(|told| told != "axis-not-supported? 8");
    assert_eq!(with_y, with_c);
    assert_ne!(with_y.len(), told(&program("Y"), "{}").len());
}

/// G7 of LinuxCNC: X is a diameter. Otherwise the program reads as for a FANUC lathe in system B.
#[test]
fn a_plain_program_of_linuxcnc_is_read() {
    let program = |head: &str| {
        format!(
            "{head} G18 G21 G40 G80 G90\nG95\nT0101 M6\nG97 S800 M3\nG0 X42. Z2.\nG1 Z-20. F0.2\nG0 X60. Z60.\nM2\n"
        )
    };
    assert_eq!(told(&program("G7"), "{}"), told(&program(""), "{}"));
    assert_eq!(ends(&program("G7"), "{}"), [(42.0, 2.0), (42.0, -20.0), (60.0, 60.0)]);
    // G07 of FANUC programs an axis.
    assert!(told("O1\nG07 Z0\nM30\n", "{}").contains(&"not-supported! 2".to_owned()));
}

/// A program that switches between G90 and G91 is in system B, where G92 S limits the speed. G50 S is one
/// error, and its limit is known.
#[test]
fn a_speed_limit_of_system_a_is_one_error_in_system_b() {
    let program = "O1\nG90 G18 G21\nG28 G91 Z0. X0.\nG90\nT0101 M03 S800\nG00 G90 X55. Z5.\nG96 S180 M03\nG50 S3000\nG00 X50.\nG01 Z-60. F0.2\nG00 X100. Z100.\nM30\n";
    let told = told(program, "{}");
    assert_eq!(told, ["g-code-system-concluded? 2", "unknown-g-code 8"]);
    assert_eq!(ends(program, "{}")[1..4], [(55.0, 5.0), (50.0, 5.0), (50.0, -60.0)]);
}

/// Blocks before the O number that move nothing are part of the program: a remark, a title, a code for the
/// unit.
#[test]
fn text_in_front_of_the_program_number_is_no_program() {
    let program = "O0010\nT0101\nG97 G99 S600 M03\nG0 X65. Z3.\nX20.\nG1 Z-15. F0.2\nM30\n";
    let way = [(65.0, 3.0), (20.0, 3.0), (20.0, -15.0)];
    for (head, expected) in [
        ("; G71 Черновой цикл", ["text-after-semicolon! 1"].as_slice()),
        ("; G71 roughing cycle", &["text-after-semicolon! 1"]),
        ("; M3 spindle on\n;; T1 roughing", &["text-after-semicolon! 1"]),
        ("G71 Черновой цикл", &["text-outside-comment! 1"]),
        ("G71 roughing cycle", &["text-outside-comment 1"]),
        ("T1 roughing tool\n%", &[]),
        ("G21", &[]),
    ] {
        let text = format!("{head}\n{program}");
        assert_eq!((told(&text, "{}"), ends(&text, "{}")), (owned(expected), way.to_vec()), "{text}");
    }
    // A program without a number, followed by one that is never called.
    let text = format!("G0 X50. Z2.\nM30\n{program}");
    assert_eq!(told(&text, "{}"), ["program-not-run? 3"]);
    assert_eq!(ends(&text, "{}"), [(50.0, 2.0)]);
    let text = format!("G0 X50. Z2.\n{program}");
    assert_eq!(ends(&text, "{}"), [(50.0, 2.0)]);
    // Text after `;` that contains a position is a block.
    let text = format!("{program}; X20. roughing");
    assert!(!told(&text, "{}").contains(&"text-after-semicolon! 8".to_owned()));
}

fn owned(told: &[&str]) -> Vec<String> {
    told.iter().map(|told| (*told).to_owned()).collect()
}

/// Text after an arrow is a remark: one message for all, and a fix that puts each in brackets.
#[test]
fn text_behind_an_arrow_is_a_remark() {
    let program = |[one, two, three, four]: [&str; 4]| {
        format!(
            "O1000{one}\nG21 G99 G97 S800 M03\nT0101{two}\nG00 X42. Z2.{three}\nG01 X40. F0.2\nZ-80.{four}\nM30\n"
        )
    };
    let way = [(42.0, 2.0), (40.0, 2.0), (40.0, -80.0)];
    for arrow in ["<--", "-->", "<-", "->", "=>", "<==", "←", "→"] {
        let remarks = ["Program name", "Tool for turning", "Rapid", "Длина детали"]
            .map(|text| format!(" {arrow} {text}"));
        let text = program(remarks.each_ref().map(String::as_str));
        assert_eq!(told(&text, "{}"), ["text-after-semicolon! 1"], "{text}");
        assert_eq!(ends(&text, "{}"), way, "{text}");
        let right = program([" (Program name)", " (Tool for turning)", " (Rapid)", " (Длина детали)"]);
        let repaired = repaired(text.as_bytes(), &Setup::default());
        assert_eq!(String::from_utf8_lossy(&repaired.text), right);
    }
    // With numbers in it, only the author knows.
    let text = program(["", " <-- Tool 1", "", " <-- Length to Z-80 (finished)"]);
    assert_eq!((told(&text, "{}"), ends(&text, "{}")), (owned(&["text-after-semicolon! 3"]), way.to_vec()));
    // The end of the program before an arrow is read. An arrow in a comment or without text after it is not
    // one.
    assert_eq!(told("O1\nG0 X50. Z2. (a -> b)\nM30 <-- End\n", "{}"), ["text-after-semicolon! 3"]);
    for block in ["G0 X50. <-", "G0 X50. -> Z2.", "IF [#1 <- 5] GOTO 10", "#1 => 5 THEN"] {
        let told = told(&format!("O1\n{block}\nM30\n"), "{}");
        assert!(
            told.iter().any(|told| told.ends_with(" 2") && !told.contains(['!', '?'])),
            "{block}: {told:?}"
        );
    }
}

/// Coordinates with three decimals such as `Z1.000`, with feeds below 0.03, are inches. A metric program has
/// leading zeros, or feeds of 0.05 and more.
#[test]
fn coordinates_written_out_to_thousandths_show_inches() {
    let inches = |text: &str| told(text, "{}").iter().any(|told| told.starts_with("inches-concluded"));
    for text in [
        "G00 Z1.000\nX.0\nZ.050\nG74 R.050\nG74 X.0 Z-.500 P0 Q1000 R0 F.006\nG00 Z.050\n",
        "G97 S800 M3\nG00 Z.100\nX5.500\nG01 Z-2.300 F.015\nX5.600\n",
    ] {
        assert!(inches(text), "{text}");
        assert!(!inches(&format!("G21\n{text}")), "{text}");
    }
    for text in [
        "G97 S800 M3\nG00 Z0.100\nX5.500\nG01 Z-2.300 F0.015\nX5.600\n",
        "G97 S800 M3\nG00 Z.100\nX5.500\nG01 Z-2.300 F.1\nX5.600\n",
        "G97 S800 M3\nG00 Z.100\nX55.500\nG01 Z-2.300 F.015\nX55.600\n",
        "G97 S800 M3\nG00 Z1.\nX5.5\nG01 Z-2.3 F.015\nX5.600\n",
    ] {
        assert!(!inches(text), "{text}");
    }
}

/// With a start point at the end of the contour, a sign of W that is right for the contour is not an error.
#[test]
fn an_allowance_is_held_against_the_way_of_the_contour() {
    let program = |start: &str| {
        format!(
            "O1\nG21 G99 G97 S800 M03\nT0101\nG0 {start}\nG71 U1. R1.\nG71 P10 Q20 U0.4 W0.1 F0.2\nN10 G0 X15. Z0\nG1 Z-15.\n\
             X22. Z-30.\nN20 X32. Z-40.\nG0 X100. Z100.\nM30\n"
        )
    };
    for start in ["X32. Z-40.", "X32. Z2."] {
        let told = told(&program(start), "{}");
        assert!(!told.iter().any(|told| told.starts_with("allowance-into-part")), "{start}: {told:?}");
    }
    let wrong = program("X32. Z2.").replace("W0.1", "W-0.1");
    assert!(told(&wrong, "{}").iter().any(|told| told.starts_with("allowance-into-part")));
}

/// In systems B and C a thread is G33: if G32 is an error, the blocks that follow it are not rapids.
#[test]
fn a_thread_of_system_a_is_followed_by_no_rapid() {
    let text = "O1\nG90 G95 G21\nG92 S500\nT0505\nG97 S500 M3\nG0 X18. Z.2\nX11.6\nG32 Z-16.6 F1.\nX12. Z-16.8\nG0 X18.\nM30\n";
    assert_eq!(told(text, "{}"), ["g-code-system-concluded? 2", "unknown-g-code 8"]);
    let analysis = analyze(text.as_bytes(), &Setup::default());
    let to = analysis.motions.iter().find(|motion| (motion.to.z + 16.8).abs() < 1e-9).expect("the run-out");
    assert!(to.kind.cuts() && to.process.uncertain);
    let fix = &analysis.diagnostics[1].fixes[0];
    let fixed = String::from_utf8(applied(text.as_bytes(), &fix.edits)).expect("UTF-8");
    assert_eq!(fixed, text.replace("G32", "G33"));
    assert_eq!(told(&fixed, "{}")[1..], [""; 0]);
}

/// `check` reports a program with too many motions for the calculation of the part, with or without a given
/// blank.
#[test]
fn a_part_with_too_many_motions_is_reported_without_a_blank() {
    let setup = Setup::from_json(r#"{"limits": {"partMotions": 5}}"#).expect("a setup");
    for (blank, cuts) in [("", 6), ("", 5), ("(STOCK D=60 LENGTH=80)\n", 6)] {
        let cuts: String = (1..cuts).map(|z| format!("G1 Z-{z}. F0.2\n")).collect();
        let text = format!("O1\n{blank}G21 G99 G97 S500 M03 T0101\nG00 X50. Z2.\n{cuts}M30\n");
        let mut analysis = analyze(text.as_bytes(), &setup);
        analysis.check_at_machine();
        let told = analysis.diagnostics.iter().filter(|told| told.message.slug() == "part-too-many-motions");
        assert_eq!(told.count(), usize::from(analysis.motions.len() > 5), "{text}");
    }
}

/// The first example with the letter o in place of a zero in any X or Z: one message, and the motions of the
/// right program. Nothing that follows is reported, because the word can only be meant as the number.
#[test]
fn one_typing_error_has_one_message() {
    let read = |file: &str| std::fs::read_to_string(format!("tests/programs/s000-o0002/{file}"));
    let (text, setup) = (read("program.nc").expect("a program"), read("setup.json").expect("a setup"));
    assert_eq!(told(&text, &setup), [""; 0]);
    let right = ends(&text, &setup);
    let mut tried = 0;
    for (at, _) in text.match_indices('0') {
        let word = text[..at].rfind(char::is_alphabetic).expect("an address");
        // A zero with a digit before it, in a coordinate.
        if !b"XZ".contains(&text.as_bytes()[word]) || !text.as_bytes()[at - 1].is_ascii_digit() {
            continue;
        }
        let wrong = format!("{}o{}", &text[..at], &text[at + 1..]);
        let line = text[..at].matches('\n').count() + 1;
        assert_eq!(told(&wrong, &setup), [format!("letter-for-digit {line}")], "{wrong}");
        assert_eq!(ends(&wrong, &setup), right, "{wrong}");
        tried += 1;
    }
    assert_eq!(tried, 15);
}
