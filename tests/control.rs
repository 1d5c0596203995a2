//! The effect of blocks, one rule per test, in a short notation: `R(x,z)` rapid, `F` feed, `T` thread,
//! `A+`/`A-` arc counter-clockwise and clockwise with its centre, `D` dwell; X is a diameter.
use gcode_playground::analyze;
use gcode_playground::api;
use gcode_playground::setup::Setup;
use gcode_playground::units::number;

/// Checks the motions of a program under a setup.
#[track_caller]
fn check_with(setup: &str, program: &str, expected: &str) {
    let setup = Setup::from_json(setup).expect("setup");
    let analysis = analyze(program.as_bytes(), &setup);
    let found: Vec<String> = api::motions(&analysis.motions, &analysis.setup.machine)
        .map(|row| {
            let to = format!("({},{})", number(row.to.x.mm()), number(row.to.z));
            match (row.kind, row.dir, row.center, row.seconds) {
                ("rapid", ..) => format!("R{to}"),
                ("feed", ..) => format!("F{to}"),
                ("thread", ..) => format!("T{to}"),
                (_, Some(dir), Some(center), _) => {
                    let sign = if dir == "ccw" { '+' } else { '-' };
                    format!("A{sign}{to}c({},{})", number(center.x.mm()), number(center.z))
                }
                (_, _, _, seconds) => format!("D{}", number(seconds.unwrap_or(f64::NAN))),
            }
        })
        .collect();
    assert_eq!(found.join(" "), expected, "\n{program}\n{:?}", analysis.diagnostics);
}

#[track_caller]
fn check(program: &str, expected: &str) {
    check_with(r#"{"initial": {"x": 100, "z": 50}}"#, program, expected);
}

#[test]
fn a_block_without_axis_words_moves_nothing() {
    check("G0\nM3 S100\nG01 F0.2\nT0101\nX80", "F(80,50)");
}

#[test]
fn absolute_and_incremental_words_mix() {
    check("G0 X80 W-10\nU-20 Z5\nW-1", "R(80,40) R(60,5) R(60,4)");
}

#[test]
fn nothing_is_inserted_between_moves_less_than_1_degree_apart() {
    for word in [",C2", ",R2", "C2", "R2"] {
        check(
            &format!("M3 S500\nG98 G1 X40 Z0 F100\nZ-20 {word}\nX40.4 Z-40\nX60"),
            "F(40,0) F(40,-20) F(40.4,-40) F(60,-40)",
        );
    }
    check(
        "M3 S500\nG98 G1 X40 Z0 F100\nZ-20 ,A180 ,R2\nZ-40 ,A179.5\nX60",
        "F(40,0) F(40,-20) F(40.3491,-40) F(60,-40)",
    );
    // An arc with a tangent transition to a line: L and D of GSK.
    check_with(
        r#"{"initial": {"x": 100, "z": 50}, "dialect": {"control": "gsk", "feedMode": "G98"}}"#,
        "M3 S500\nG1 X40 Z0 F100\nZ-20 D2\nG2 X60 Z-30 R10\nG1 X70",
        "F(40,0) F(40,-20) A-(60,-30)c(60,-20) F(70,-30)",
    );
}

#[test]
fn l_and_d_of_gsk_join_a_line_to_an_arc() {
    check_with(
        r#"{"initial": {"x": 100, "z": 50}, "dialect": {"control": "gsk", "feedMode": "G98"}}"#,
        "M3 S500\nG1 X40 Z0 F100\nZ-20 L2\nG3 X60 Z-30 R10\nG1 X70",
        "F(40,0) F(40,-18) F(43.98,-20.2) A+(60,-30)c(40,-30) F(70,-30)",
    );
}

#[test]
fn an_arc_that_cannot_form_a_corner_keeps_its_centre() {
    check_with(
        r#"{"initial": {"x": 100, "z": 50}, "dialect": {"strict": true}}"#,
        "M3 S500\nG98 G1 X40 Z0 F100\nZ-20 ,C2\nG3 X60 Z-30 R10",
        "F(40,0) A+(60,-30)c(40,-30)",
    );
}

#[test]
fn x_with_u_follows_the_control() {
    check("G0 X80 U-10", "R(90,50)");
    check("G0 U-10 X80", "R(80,50)");
    check_with(
        r#"{"initial": {"x": 100, "z": 50}, "dialect": {"control": "gsk"}}"#,
        "G0 X80 U-10",
        "R(80,50)",
    );
}

#[test]
fn moves_of_no_length_are_not_listed() {
    check("G0 X100 Z50\nG1 U0 W0 F1\nX100.0004", "");
}

#[test]
fn digits_below_the_least_increment_are_cut_off() {
    check("G0 X80.1239 Z-1.0019", "R(80.123,-1.001)");
}

#[test]
fn numbers_without_a_point_follow_the_decimal_rule() {
    let setup = r#"{"initial": {"x": 100, "z": 50}, "dialect": {"decimal": "leastIncrement"}}"#;
    check_with(setup, "G0 X80000 Z-10.\nG4 X1500", "R(80,-10) D1.5");
    check("G0 X80 Z-10", "R(80,-10)");
}

#[test]
fn inches_are_converted_and_keep_the_place() {
    check("G20 G0 X1. Z-2.\nG21 W-1", "R(25.4,-50.8) R(25.4,-51.8)");
    let setup = r#"{"initial": {"x": 100, "z": 50}, "dialect": {"decimal": "leastIncrement"}}"#;
    check_with(setup, "G20 G0 X10000 Z-5", "R(25.4,-0.0127)");
}

#[test]
fn arcs_by_radius_and_by_centre() {
    let start = "M3 S1 G98 F100\nG0 X20 Z0\n";
    check(&format!("{start}G3 X40 Z-10 R10"), "R(20,0) A+(40,-10)c(20,-10)");
    check(&format!("{start}G2 X40 Z-10 R10"), "R(20,0) A-(40,-10)c(40,0)");
    check(&format!("{start}G3 X40 Z-10 I0 K-10"), "R(20,0) A+(40,-10)c(20,-10)");
    check(&format!("{start}G2 X40 Z-10 R-10"), "R(20,0) A-(40,-10)c(20,-10)");
    // R takes priority over I and K; a full circle needs I or K.
    check(&format!("{start}G3 X40 Z-10 R10 I5 K5"), "R(20,0) A+(40,-10)c(20,-10)");
    check(&format!("{start}G2 K-5"), "R(20,0) A-(20,0)c(20,-5)");
    check(&format!("{start}G2 X20 Z0 R5"), "R(20,0)");
}

#[test]
fn an_error_drops_its_block_and_the_position_stays() {
    check("M3 S1\nG1 X90\nF0.1\nX80\nG2 X70 R1\nG1 Z0", "F(80,50) F(80,0)");
}

#[test]
fn dwells_in_seconds_and_milliseconds() {
    check("G04 X1.5\nG4 U2\nG04 P500\nG4", "D1.5 D2 D0.5");
}

#[test]
fn g28_goes_over_the_intermediate_point() {
    check("G28 U0 W0", "R(300,300)");
    check("G28 X120 Z60", "R(120,60) R(300,300)");
    check("G28 U0", "R(300,50)");
    let setup = r#"{"initial": {"x": 100, "z": 50}, "dialect": {"refPoint": {"x": 400, "z": 500}}}"#;
    check_with(setup, "G50 X0 Z0\nG28 U0 W0", "R(300,450)");
}

#[test]
fn g50_sets_and_shifts_the_frame() {
    check("G50 X200 Z100\nG0 X150\nW-10", "R(150,100) R(150,90)");
    check("G50 U50 W-5\nG0 U-10", "R(140,45)");
    // A speed limit alone sets no coordinates.
    check("G50 S2000\nG0 U-10", "R(90,50)");
}

#[test]
fn g52_shifts_all_frames() {
    check("G52 X10 Z5\nG0 U2\nG52 X0 Z0\nG0 U2", "R(92,45) R(104,50)");
    // It applies in every frame until it is cancelled.
    check("G54 G52 X10\nG55 G0 U2\nG54 U2", "R(92,50) R(94,50)");
    check("G10 L2 P2 X40\nG52 X10\nG55 G0 U2\nG52 X0 Z0\nG54 G0 U2", "R(52,50) R(104,50)");
    check("G55 G52 Z5\nG54.1 P1 G0 W-5\nG54 G52 Z0\nG0 W-5", "R(100,40) R(100,40)");
}

#[test]
fn g90_remembers_until_another_motion_code() {
    let start = "M3 S1 G98 F100\nG0 X60 Z2\n";
    check(
        &format!("{start}G90 X50 Z-30\nX40\nG0 X70"),
        "R(60,2) R(50,2) F(50,-30) F(60,-30) R(60,2) R(40,2) F(40,-30) F(60,-30) R(60,2) R(70,2)",
    );
    // U counts from the start point each time; blocks with only M, S or T do not repeat the cycle.
    check(
        &format!("{start}G90 U-10 W-32\nM8\nS500\nU-20"),
        "R(60,2) R(50,2) F(50,-30) F(60,-30) R(60,2) R(40,2) F(40,-30) F(60,-30) R(60,2)",
    );
    // If the code is repeated without R, the taper is cancelled; without a G code it stays.
    check(
        &format!("{start}G90 X50 Z-30 R-5\nX40\nG90 X40"),
        "R(60,2) R(40,2) F(50,-30) F(60,-30) R(60,2) R(30,2) F(40,-30) F(60,-30) R(60,2) \
         R(40,2) F(40,-30) F(60,-30) R(60,2)",
    );
    // R alone is stored and moves nothing.
    check(
        &format!("{start}G90 X50 Z-30\nR-5\nX40"),
        "R(60,2) R(50,2) F(50,-30) F(60,-30) R(60,2) R(30,2) F(40,-30) F(60,-30) R(60,2)",
    );
    // A dwell keeps the stored values; another one-shot code clears them.
    check(
        &format!("{start}G90 X50 Z-30\nG4 X1\nX40"),
        "R(60,2) R(50,2) F(50,-30) F(60,-30) R(60,2) D1 R(40,2) F(40,-30) F(60,-30) R(60,2)",
    );
    check(
        &format!("{start}G90 X50 Z-30\nG50 S100\nX40"),
        "R(60,2) R(50,2) F(50,-30) F(60,-30) R(60,2) R(40,2) F(60,2)",
    );
    // Another of the three codes keeps X and Z.
    check(
        &format!("{start}G90 X50 Z-30\nG94 X20"),
        "R(60,2) R(50,2) F(50,-30) F(60,-30) R(60,2) R(60,-30) F(20,-30) F(20,2) R(60,2)",
    );
}

#[test]
fn a_bare_g90_cuts_nothing() {
    check("M3 S1\nG18 G21 G40 G80 G90 G99\nG0 X60 Z2\nG1 Z-5 F0.2", "R(60,2) F(60,-5)");
    check("M3 S1 F1\nG90\nU0. W0.\nG0 X60", "R(60,50)");
}

#[test]
fn g92_pulls_out_as_set() {
    let start = "M3 S1\nG0 X35 Z4\n";
    let setup = r#"{"initial": {"x": 100, "z": 50}, "dialect": {"threadChamfer": 10}}"#;
    check_with(
        setup,
        &format!("{start}G92 X28 Z-26 F2"),
        "R(35,4) R(28,4) T(28,-24) T(32,-26) R(35,-26) R(35,4)",
    );
    check_with(setup, &format!("M24\n{start}G92 X28 Z-26 F2"), "R(35,4) R(28,4) T(28,-26) R(35,-26) R(35,4)");
    check(&format!("{start}G92 X28 Z-26 R-1 F2"), "R(35,4) R(26,4) T(28,-26) R(35,-26) R(35,4)");
    let gsk = r#"{"initial": {"x": 100, "z": 50}, "dialect": {"control": "gsk"}}"#;
    check_with(
        gsk,
        &format!("{start}G92 X28 Z-26 F2 J1 K3"),
        "R(35,4) R(28,4) T(28,-23) T(30,-26) R(35,-26) R(35,4)",
    );
    check_with(
        gsk,
        &format!("{start}G92 X28 Z-26 F2 L2"),
        "R(35,4) R(28,4) T(28,-26) R(35,-26) R(35,4) R(28,4) T(28,-26) R(35,-26) R(35,4)",
    );
}

#[test]
fn leads_in_threads_per_inch_follow_the_control() {
    let lead = |setup: &str, program: &str| -> Option<f64> {
        let analysis = analyze(program.as_bytes(), &Setup::from_json(setup).expect("setup"));
        api::motions(&analysis.motions, &analysis.setup.machine)
            .find(|row| row.kind == "thread")
            .and_then(|row| row.lead)
    };
    let gsk = r#"{"dialect": {"control": "gsk"}}"#;
    assert_eq!(lead(gsk, "M3 S1\nG0 X30 Z2\nG92 X28 Z-20 I8"), Some(3.175));
    assert_eq!(lead(gsk, "M3 S1\nG0 X30 Z2\nG32 Z-20 I10"), Some(2.54));
    assert_eq!(lead("{}", "M3 S1\nG0 X30 Z2\nG92 X28 Z-20 I1 F2"), Some(2.0));
    assert_eq!(lead("{}", "G20 M3 S1\nG0 X1. Z.1\nG32 Z-1. F.1"), Some(2.54));
    assert_eq!(lead("{}", "M3 S1\nG0 X30 Z2\nG32 Z-20"), None);
}

#[test]
fn the_program_ends_at_m30_and_what_follows_is_only_read() {
    check("G0 X80\nM30\nX70", "R(80,50)");
    check("G0 X80 M02\nX70", "R(80,50)");
    check("O1\nG0 X80\nM30\nO2\nG0 X70\nM99", "R(80,50)");
    check("G00 X200 Z200 T0100 M05", "R(200,200)");
}

#[test]
fn what_is_not_supported_moves_nothing_and_puts_its_axes_in_doubt() {
    let analysis = analyze(b"M3 S1\nG0 X50\nG36 X0 Z0\nG1 X40 F1\nZ5\nX30\nM30", &Setup::default());
    let rows: Vec<_> = api::motions(&analysis.motions, &analysis.setup.machine)
        .map(|row| (row.to.x.mm(), row.uncertain))
        .collect();
    assert_eq!(rows, [(50.0, false), (40.0, true), (40.0, true), (30.0, false)]);
}

#[test]
fn a_retreat_at_the_end_of_a_contour_is_no_part_of_it() {
    let program = |end: &str| {
        format!("M3 S1 F1\nG0 X50 Z2\nG71 U5 R1\nG71 P10 Q20 U0 W0\nN10 G0 X20\nG1 Z-20\nX40\n{end}\nN30 M30")
    };
    let setup = Setup::from_json("{}").expect("setup");
    let run = |end: &str| analyze(program(end).as_bytes(), &setup);
    let codes = |end: &str| -> Vec<&'static str> {
        run(end)
            .diagnostics
            .iter()
            .filter(|found| found.is_error())
            .map(|found| found.message.code())
            .collect()
    };
    assert_eq!(codes("N20 G00 Z2"), [] as [&str; 0]);
    // A control with strict contour rules reports it as an error; others omit the way back from the passes.
    assert_eq!(codes("N20 G01 Z2"), [] as [&str; 0]);
    let strict = Setup::from_json(r#"{"dialect": {"strict": true}}"#).expect("setup");
    let refused = analyze(program("N20 G01 Z2").as_bytes(), &strict);
    assert!(
        refused.diagnostics.iter().any(|found| found.is_error() && found.message.code() == "E-NOT-MONOTONE")
    );
    assert_eq!(run("N20 G00 Z2").motions.len(), run("N20 M8").motions.len());
}

#[test]
fn behind_an_error_the_run_is_incomplete_and_only_the_next_move_uncertain_chunks_later_too() {
    let text = format!("G1 X50 Z5 F0.2\nX[\n{}", "X1\nX2\n".repeat(5_000));
    let analysis = analyze(text.as_bytes(), &Setup::default());
    let chunks = analysis.motions.chunks();
    assert!(chunks.len() > 2);
    let all = chunks.iter().flat_map(|chunk| (0..chunk.len()).map(move |index| (chunk, index)));
    for (at, (chunk, index)) in all.enumerate() {
        assert_eq!(chunk.is_uncertain(index), at == 1, "motion {at}");
        assert_eq!(chunk.get(index).process.uncertain, at == 1, "motion {at}");
        assert_eq!(chunk.get(index).process.incomplete, at > 0, "motion {at}");
    }
}

#[test]
fn empty_lines_and_what_stands_after_a_semicolon_are_no_blocks() {
    let blocks = |text: &str| gcode_playground::analyze(text.as_bytes(), &Setup::default()).blocks;
    assert_eq!(blocks("G00 X1\nG00 X2\nM30"), 3);
    assert_eq!(blocks("G00 X1;\n\n  \nG00 X2;\n(REMARK)\nM30;\n"), 3);
    assert_eq!(blocks("G00 X1; G00 X2; M30"), 3);
}
