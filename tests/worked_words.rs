//! Words, speeds, tools and macros, calculated by hand: words that a control ignores or interprets
//! differently than intended, and unusual ones that are right.
use gcode_playground::analyze;
use gcode_playground::message::{Diagnostic, Severity};
use gcode_playground::setup::Setup;

/// The messages of a program: slug and line, counted from 1. Notes have a question mark.
fn told(text: &str, setup: &str) -> Vec<(String, Diagnostic)> {
    let analysis = analyze(text.as_bytes(), &Setup::from_json(setup).expect("a setup"));
    let told = analysis.diagnostics.into_iter().map(|told| {
        let line = text[..told.span.start as usize].matches('\n').count() + 1;
        let note = if told.severity == Severity::Info { "?" } else { "" };
        (format!("{}{note} {line}", told.message.slug()), told)
    });
    told.collect()
}

#[track_caller]
fn program_says(text: &str, setup: &str, expected: &[&str]) {
    let found: Vec<String> = told(text, setup).into_iter().map(|told| told.0).collect();
    assert_eq!(found, expected, "{text}");
}

/// Checks the messages of blocks between a head that prepares the machine and an end. Lines count from the
/// first of the blocks.
#[track_caller]
fn says_with(setup: &str, blocks: &str, expected: &[&str]) {
    let head = "O0001 (STOCK D=50 LENGTH=80)\nT0101\nG97 G99 S800 M03\nG00 X52 Z2\n";
    let found = told(&format!("{head}{blocks}\nG00 X200 Z200\nM30\n"), setup);
    let found = found.into_iter().map(|(name, _)| {
        let (slug, line) = name.split_once(' ').expect("slug and line");
        format!("{slug} {}", line.parse::<i32>().expect("a line") - head.matches('\n').count() as i32)
    });
    assert_eq!(found.collect::<Vec<_>>(), expected, "{blocks}");
}

#[track_caller]
fn says(blocks: &str, expected: &[&str]) {
    says_with("{}", blocks, expected);
}

/// The text after a fix of the first message of a rule.
#[track_caller]
fn repaired(text: &str, slug: &str, repair: usize) -> String {
    let found = told(text, "{}");
    let (_, diagnostic) = found.iter().find(|told| told.1.message.slug() == slug).expect("the message");
    let mut repaired = text.to_owned();
    for edit in diagnostic.fixes[repair].edits.iter().rev() {
        repaired.replace_range(edit.span.start as usize..edit.span.end as usize, &edit.text);
    }
    repaired
}

const GSK: &str = r#"{"dialect": {"control": "gsk", "feedMode": "G99"}}"#;

/// Table 1-2 of seed 000 is not part of the document. FANUC's range for lengths in steps of 0.001 mm is
/// ±99999.999 mm, eight digits (B-64304EN, range of command values).
#[test]
fn coordinates_and_r_take_eight_digits() {
    for letter in ["X", "U", "Z", "W", "R"] {
        for (value, expected) in [
            ("99999.999", false),
            ("-99999.999", false),
            ("99999999", false),
            ("100000.000", true),
            ("-100000.000", true),
            ("123456789", true),
        ] {
            let text = format!(
                "O0001\nT0101\nG97 G99 S800 M03\nG00 X52 Z2\nG90 X40 Z-20 F0.2\n{letter}{value}\nM30\n"
            );
            let found = told(&text, "{}").iter().any(|told| told.0 == "too-many-digits 6");
            assert_eq!(found, expected, "{letter}{value}");
        }
    }
}

#[test]
fn words_that_a_move_does_not_read_are_named() {
    says("G00 X46\nG01 Z-20 L1.5 F0.2\nX52", &["word-without-effect 2"]);
    says("G00 X46\nG01 Z-20 D2 F0.2\nX52", &["word-without-effect 2"]);
    says("G00 X46 P1 Q2\nG01 Z-20 F0.2\nX52", &["word-without-effect 1"]);
    // A missing arc code.
    says("G00 X46 R3\nG01 Z-20 F0.2\nX52", &["word-without-effect 1"]);
    says("G00 X46 Z2\nG01 Z-20 F0.2\nG02 X50 Z-22 R2 Q3\nG01 X52", &["word-without-effect 3"]);
}

#[test]
fn words_that_a_code_reads_are_right() {
    // Corners with and without a comma, centres, and words of other codes.
    says("G00 X40\nG01 Z-20 R2 F0.2\nX46 C1\nZ-30 ,R1\nX52", &[]);
    says("G00 X46 Z2\nG01 Z-20 F0.2\nG02 X50 Z-22 I2 K0\nG01 X52", &[]);
    // J is the centre along Y, where there is nothing; some post-processors write it.
    says("G00 X46 Z2\nG01 Z-20 F0.2\nG02 X50 Z-22 I2 J0\nG01 X52", &[]);
    says("G00 X46\nG01 Z-20 F0.2\nG04 P500\nX52", &[]);
    says("G50 S2000 Q50\nG00 X46\nG01 Z-20 F0.2\nX52", &[]);
    says("G00 X46\nG01 Z-20 F0.2\nX52\nG10 P1 X0 Z0", &[]);
    says("G00 X46 S900 P1\nG01 Z-20 F0.2\nX52", &[]);
    // On GSK, L and D are a chamfer and a rounding.
    says_with(GSK, "G00 X46\nG01 Z-20 L1.5 F0.2\nX52", &[]);
    says_with(GSK, "G00 X46\nG01 Z-20 D2 F0.2\nX52", &[]);
}

/// Seed 002: with G12.1 and X as the linear axis, I and J give the centre.
#[test]
fn under_polar_interpolation_j_is_the_centre_along_c() {
    let program = |arc: &str| {
        format!(
            "O1 (STOCK D=80 LENGTH=60)\n(TOOL T0101 TYPE=ENDMILL D=10)\nM45\nG28 H0\nT0101\nG97 S1000 M13\nG00 X90 Z5\nG98 G01 Z-5 F100\nG12.1\n\
             G01 X60 C0\n{arc}\nG01 X90 C20\nG13.1\nG00 X200 Z200\nM30\n"
        )
    };
    // From (30, 0) to (20, 10) around (20, 0).
    program_says(&program("G03 X40 C10 I-10 J0"), "{}", &[]);
    program_says(&program("G03 X40 C10 I-10 K5"), "{}", &["centre-word-outside-plane 11"]);
}

#[test]
fn corner_words_of_another_control_are_written_anew() {
    let text = "O1 (STOCK D=50 LENGTH=80)\nT0101\nG97 G99 S800 M03\nG00 X46 Z2\nG01 Z-20 D2 F0.2\nX52\nG00 X200 Z200\nM30\n";
    let fixed = repaired(text, "word-without-effect", 0);
    assert!(fixed.contains("Z-20 ,R2 F0.2"), "{fixed}");
    program_says(&fixed, "{}", &[]);
}

#[test]
fn a_dwell_is_as_long_as_somebody_means() {
    let cut = |dwell: &str| format!("G00 X46\nG01 Z-20 F0.2\n{dwell}\nX52");
    says(&cut("G04 X500"), &["dwell-unusual 3"]);
    says(&cut("G04 U1000"), &["dwell-unusual 3"]);
    says(&cut("G04 P5"), &["dwell-unusual 3"]);
    for right in ["G04 X5", "G04 X60", "G04 X500.", "G04 U0.5", "G04 P50", "G04 P1500", "G04 P10"] {
        says(&cut(right), &[]);
    }
    // A macro stops the look-ahead by the shortest possible dwell.
    program_says(&format!("{HEAD}G65 P9 A1\nM30\nO0009\nG04 P1\nM99\n"), "{}", &[]);
    // If integers count thousandths, 500 is half a second.
    let thousandths = r#"{"dialect": {"decimal": "leastIncrement"}}"#;
    let text = "O1 (STOCK D=50 LENGTH=80)\nT0101\nG97 G99 S800 M03\nG00 X46. Z2.\nG01 Z-20. F0.2\nG04 X500\nX52.\nG00 X200. Z200.\nM30\n";
    program_says(text, thousandths, &[]);
    // In a program with decimal points, the point is missing.
    program_says(text, r#"{"dialect": {"decimal": "calculator"}}"#, &["too-large-without-point 6"]);
}

const HEAD: &str = "O0001 (STOCK D=50 LENGTH=80)\nT0101\nG97 G99 S800 M03\nG00 X46 Z2\nG01 Z-30 F0.2\nX52\n";

#[test]
fn moves_after_the_end_are_named() {
    program_says(&format!("{HEAD}M30\nG00 X44 Z2\nG01 Z-20\nX52\nM30\n"), "{}", &["blocks-after-end 8"]);
    program_says(
        &format!("{HEAD}M98 P2\nM30\nO0002\nG00 W2\nM99\nG00 X60\n"),
        "{}",
        &["blocks-after-end 12"],
    );
}

#[test]
fn moves_after_the_end_are_named_between_the_ends_of_the_tape() {
    program_says(&format!("%\n{HEAD}M30\nN5 G00 X44 Z2\n%\n"), "{}", &["blocks-after-end 9"]);
    // Text after the end of the tape is not read.
    program_says(&format!("%\n{HEAD}M30\n%\nG00 X44 Z2\n"), "{}", &[]);
}

#[test]
fn what_something_leads_to_may_stand_after_the_end() {
    // Subprograms, the end of the tape, a jump, a skippable or conditional end.
    program_says(&format!("{HEAD}M98 P2\nM30\nO0002\nG00 W2\nM99\n"), "{}", &[]);
    program_says(&format!("%\n{HEAD}M30\n%\n"), "{}", &[]);
    program_says(&format!("{HEAD}#1=1\nIF [#1 EQ 1] GOTO 90\nM30\nN90 G00 X200 Z200\nM30\n"), "{}", &[]);
    program_says(&format!("{HEAD}/M30\nG00 X200 Z200\nM30\n"), "{}", &[]);
    // Blocks that move nothing are harmless.
    program_says(&format!("{HEAD}M30\nM99\n"), "{}", &[]);
}

#[test]
fn a_vacant_variable_takes_its_word_away() {
    says("#1=46\nG00 X#1\nG01 Z#2 F0.2\nX52", &["vacant-variable 3"]);
    says("G00 X46\nG01 Z#150 F0.2\nX52", &["vacant-variable 2"]);
    says("G00 X46\nG01 Z#501 F0.2\nX52", &["vacant-variable? 2"]);
    says("#2=-20\nG00 X46\nG01 Z#2 F0.2\nX52", &[]);
    // In an expression it counts as 0; #0 is deliberately vacant.
    says("G00 X46\nG01 Z[#2-20] F0.2\nX52", &[]);
    says("G00 X46\nG01 Z-20 X#0 F0.2\nX52", &[]);
    // A call may omit an argument; a variable that is not an argument was never set.
    let macro_of = |block: &str| format!("{HEAD}G65 P9 A46\nG00 X200 Z200\nM30\nO0009\n{block}\nM99\n");
    program_says(&macro_of("G00 X#1 Z#2"), "{}", &[]);
    program_says(&macro_of("G00 X#1 Z#30"), "{}", &["vacant-variable 11"]);
}

#[test]
fn a_loop_that_is_never_entered_is_noted() {
    let turned = |sign: &str| {
        format!("#1=48\nWHILE [#1 {sign} 40] DO1\nG00 X#1\nG01 Z-20 F0.2\nX52\nG00 Z2\n#1=#1-2\nEND1")
    };
    says(&turned("LT"), &["loop-not-entered? 2"]);
    says(&turned("GT"), &[]);
    // Not in the first round, but later.
    says(
        "#2=0\n#3=0\nWHILE [#2 LT 2] DO1\nWHILE [#3 GT 0] DO2\nG00 X46\nG01 Z-20 F0.2\nX52\nG00 Z2\n#3=#3-1\nEND2\n#3=1\n#2=#2+1\nEND1",
        &[],
    );
}

#[test]
fn a_tool_has_the_offset_of_its_station_where_all_others_have() {
    let program = |tools: &[&str]| {
        let cuts = tools.iter().enumerate().map(|(index, tool)| {
            let x = 48 - 2 * index;
            format!("{tool}\nG00 X{x} Z2\nG01 Z-20 F0.2\nX52\nG00 X200 Z200\n")
        });
        format!("O0001 (STOCK D=50 LENGTH=80)\nG97 G99 S800 M03\n{}M30\n", cuts.collect::<String>())
    };
    let at = |index: usize| format!("tool-offset-differs {}", 3 + 5 * index);
    program_says(&program(&["T0101", "T0203", "T0303", "T0404"]), "{}", &[&at(1)]);
    program_says(&program(&["T0101", "T0202", "T0303", "T0507"]), "{}", &[&at(3)]);
    // A second offset of a station, unless it is the offset of another tool.
    program_says(&program(&["T0101", "T0111", "T0202", "T0303"]), "{}", &[]);
    program_says(&program(&["T0101", "T0103", "T0202", "T0303"]), "{}", &[&at(1)]);
    // Too few other tools, two deviations, offsets that are cancelled.
    program_says(&program(&["T0101", "T0203", "T0303"]), "{}", &[]);
    program_says(&program(&["T0111", "T0212", "T0303", "T0404", "T0505"]), "{}", &[]);
    program_says(&program(&["T0101", "T0202", "T0303", "T0404"]), "{}", &[]);
}

#[test]
fn a_speed_is_one_that_a_lathe_cuts_with() {
    let cut = |speed: &str| format!("{speed}\nG00 X46\nG01 Z-20 F0.2\nX52");
    says(&cut("G50 S2000\nG96 S2000"), &["speed-unusual 2"]);
    says(&cut("G50 S2000\nG96 S5"), &["speed-unusual 2"]);
    says(&cut("G97 S18000"), &["speed-unusual 1"]);
    says(&cut("(MACHINE MAXSPEED=4000)\nG97 S4000"), &[]);
    says(&cut("(MACHINE MAXSPEED=4000)\nG97 S4001"), &["speed-unusual 2"]);
    says(&cut("(MACHINE MAXSPEED=4000)\nG50 S4000\nG96 S200"), &[]);
    says(&cut("(MACHINE MAXSPEED=4000)\nG50 S4001\nG96 S200"), &["speed-unusual? 2"]);
    for right in ["G50 S2000\nG96 S200", "G50 S2000\nG96 S1000", "G50 S2000\nG96 S12", "G97 S6000", "G97 S20"]
    {
        says(&cut(right), &[]);
    }
    // In feet: 2000 ft/min are 610 m/min.
    let inches =
        "O1\nG20 G99 T0101\nG50 S2000\nG96 S2000 M03\nG00 X2. Z.1\nG01 Z-1. F.01\nX2.2\nG00 X8. Z8.\nM30\n";
    program_says(inches, "{}", &[]);
}

/// A convex corner: from X40 Z-15 with R3 to X46 Z-18, centre 3 mm along -Z.
#[test]
fn a_centre_with_the_other_sign_is_offered_where_that_alone_fits() {
    let program = |arc: &str| {
        format!(
            "O1 (STOCK D=50 LENGTH=80)\nT0101\nG97 G99 S800 M03\nG00 X40 Z2\nG01 Z-15 F0.2\n{arc}\nX52\nG00 X200 Z200\nM30\n"
        )
    };
    for (wrong, right) in [
        ("G03 X46 Z-18 I0 K3", "G03 X46 Z-18 I0 K-3"),
        ("G02 X46 Z-18 I-3 K0", "G02 X46 Z-18 I3 K0"),
        ("G02 X46 Z-18 I-3", "G02 X46 Z-18 I3"),
        // From (20, -15) around (22, -19) to (24, -23): both signs.
        ("G02 X48 Z-23 K4 I-2", "G02 X48 Z-23 K-4 I2"),
    ] {
        assert_eq!(repaired(&program(wrong), "arc-end-off-circle", 0), program(right));
    }
    // Half of I would fit: that is not a sign error.
    let found = told(&program("G02 X46 Z-18 I6 K0"), "{}");
    assert!(
        found.iter().any(|told| told.1.message.slug() == "arc-end-off-circle" && told.1.fixes.is_empty())
    );
}

#[test]
fn a_cut_in_material_has_a_feed_that_an_insert_takes() {
    let program = |blocks: &str| {
        format!(
            "O1 (STOCK D=50 LENGTH=80)\nT0101\nG97 G99 S800 M03\nG00 X60 Z2\n{blocks}\nG00 X200 Z200\nM30\n"
        )
    };
    let says = |blocks: &str, expected: &[&str]| machine_says(&program(blocks), expected);
    says("G00 X46\nG01 Z-30 F1.5\nX52", &["feed-per-turn-high 6"]);
    says("G00 X46\nG98 G01 Z-30 F2000\nX52", &["feed-per-turn-high 6"]);
    // Allowed in the air, on the axis (a tap in a floating holder), and as the lead of a thread.
    says("G01 X46 F2\nZ-30 F0.2\nX52", &[]);
    says("G00 X46\nG01 Z-30 F0.6\nX52", &[]);
    says("G00 X0\nG01 Z-20 F1.5\nZ2\nG00 X60", &["drill-diameter-assumed 6"]);
    says("G00 X54 Z5\nG97 S300\nG92 X49.2 Z-20 F1.5\nX48.6\nX48.2", &[]);
    says("G00 X46\nG98 G01 Z-30 F200\nX52", &[]);
}

#[test]
fn a_tool_does_the_work_of_its_kind() {
    let program = |tool: &str, blocks: &str| {
        format!(
            "O1 (STOCK D=50 LENGTH=80)\n(TOOL T0101 {tool})\nT0101\nG97 G99 S300 M03\nG00 X54 Z5\n{blocks}\nG00 X200 Z200\nM30\n"
        )
    };
    let turn = "G90 X46 Z-30 F0.2";
    let thread = "G00 Z15\nG92 X49.2 Z-20 F1.5\nX48.8";
    machine_says(&program("TYPE=DRILL D=20", turn), &["tool-for-other-work 6"]);
    machine_says(&program("TYPE=THREADING", turn), &["tool-for-other-work 6"]);
    machine_says(&program("TYPE=TURNING INSERT=CNMG120408", thread), &["tool-for-other-work 7"]);
    machine_says(&program("TYPE=GROOVING WIDTH=3 REACH=12", thread), &["tool-for-other-work 7"]);
    machine_says(&program("TYPE=TURNING INSERT=CNMG120408", turn), &[]);
    machine_says(&program("TYPE=THREADING", thread), &[]);
    machine_says(&program("TYPE=DRILL D=20", "G00 X0\nG74 R1\nG74 Z-30 Q5000 F0.1\nG00 Z5"), &[]);
    // A threading tool may remove a burr or cut a small chamfer.
    machine_says(&program("TYPE=THREADING", "G00 X40 Z10\nG01 X50 Z-2 F0.1\nX54"), &[]);
}

/// Checks the machine rules only, with the lines of their blocks.
#[track_caller]
fn machine_says(text: &str, expected: &[&str]) {
    let mut analysis = analyze(text.as_bytes(), &Setup::default());
    analysis.check_at_machine();
    let found = analysis.diagnostics.iter().map(|told| {
        format!("{} {}", told.message.slug(), text[..told.span.start as usize].matches('\n').count() + 1)
    });
    assert_eq!(found.collect::<Vec<_>>(), expected, "{text}");
}

#[test]
fn a_place_is_named_as_often_as_the_other_way_round_is_not() {
    let program = |places: [&str; 3]| {
        let cuts = places
            .iter()
            .zip(["46", "44", "42"])
            .map(|(place, x)| format!("G00 {place}\nG01 X{x} Z1 F0.2\nZ-20\nX54\nG00 X200 Z200\n"));
        format!("O0001 (STOCK D=50 LENGTH=80)\nT0101\nG97 G99 S800 M03\n{}M30\n", cuts.collect::<String>())
    };
    let says = |places: [&str; 3], expected: &[&str]| program_says(&program(places), "{}", expected);
    says(["X52 Z2", "X2 Z52", "X52 Z2"], &["axes-exchanged 9"]);
    says(["X52 Z2", "Z52 X2", "X52 Z2"], &["axes-exchanged 9"]);
    says(["X52 Z2", "X52 Z2", "X52 Z2"], &[]);
    // Each order only once, or each value in other blocks too, is not enough evidence.
    says(["X52 Z2", "X2 Z52", "X54 Z2"], &[]);
    says(["X52 Z2", "X2 Z52", "X52 Z2 (ONCE MORE)\nX2"], &[]);
    let right = program(["X52 Z2", "X52 Z2", "X52 Z2"]);
    assert_eq!(repaired(&program(["X52 Z2", "X2 Z52", "X52 Z2"]), "axes-exchanged", 0), right);
}
