//! Control flow of programs: calls, jumps, loops and conditions; values from variables; and the expansion of
//! such programs. Motions: `R(x,z)` rapid, `F` feed, `T` thread, `D` dwell; X is a diameter.
use gcode_playground::api;
use gcode_playground::run::Analysis;
use gcode_playground::setup::Setup;
use gcode_playground::units::number;
use gcode_playground::{analyze, expand};

fn run(setup: &str, program: &str) -> Analysis {
    analyze(program.as_bytes(), &Setup::from_json(setup).expect("setup"))
}

/// The motions, with the angle of C if it turns.
fn listing(analysis: &Analysis) -> String {
    let rows = api::motions(&analysis.motions, &analysis.setup.machine).map(|row| {
        let c = row.to.c.map_or_else(String::new, |c| format!(",C{}", number(c)));
        let to = format!("({},{}{c})", number(row.to.x.mm()), number(row.to.z));
        match row.kind {
            "rapid" => format!("R{to}"),
            "feed" => format!("F{to}"),
            "thread" => format!("T{to}L{}", number(row.lead.unwrap_or(f64::NAN))),
            "dwell" => format!("D{}", number(row.seconds.unwrap_or(f64::NAN))),
            _ => format!("A{to}"),
        }
    });
    rows.collect::<Vec<_>>().join(" ")
}

/// Checks the motions of a program and of its expansion, and that there are no errors.
#[track_caller]
fn check_with(setup: &str, program: &str, expected: &str) {
    let analysis = run(setup, program);
    let faults: Vec<_> = analysis.diagnostics.iter().filter(|found| found.is_error()).collect();
    assert_eq!(listing(&analysis), expected, "\n{program}\n{:?}", analysis.diagnostics);
    assert!(faults.is_empty(), "{program}\n{faults:?}");
    let expanded = expand::expand(program.as_bytes(), &Setup::from_json(setup).expect("setup"));
    assert_eq!(listing(&run(setup, &expanded)), expected, "\n{program}\n{expanded}");
}

#[track_caller]
fn check(program: &str, expected: &str) {
    check_with(r#"{"initial": {"x": 100, "z": 50}, "dialect": {"feedMode": "G98"}}"#, program, expected);
}

#[test]
fn a_block_behind_then_is_a_block_like_any_other() {
    check("#2=7\nIF[1EQ1]THEN G0 X#2\nIF[1EQ2]THEN X8\nM30", "R(7,50)");
    check("IF[1EQ1]THEN G98 G0 X5\nIF[1EQ1]THEN M98 P2\nM30\nO2\nW-1\nM99", "R(5,50) R(5,49)");
}

/// M99 of a main program starts another pass only if the pass reads a changed value before assigning it.
#[test]
fn a_pass_of_the_main_program_is_made_again_only_where_it_reads_another_value() {
    // Assigned before it is read, or not read at all.
    check("O1\nG0 X50\n#1=5\nM99", "R(50,50)");
    check("O1\nG0 X50\n#500=5\nM99", "R(50,50)");
    check("O1\n#1=5\nG0 X#1\nM99", "R(5,50)");
    check("O1\n#100=2\n#[#100+1]=7\nG0 X#3\nM99", "R(7,50)");
    check("O1\n#1=3\nWHILE[#1GT1]DO1\nG0 X#1\n#1=#1-1\nEND1\nM99", "R(3,50) R(2,50)");
    check("O1\n#1=5\nIF[#1EQ5]GOTO 3\nG0 X1\nN3 G0 X9\n#1=6\nM99", "R(9,50)");
    check("O1\n#1=4\nM98 P2\n#1=3\nM99\nO2\nG0 X#1\nM99", "R(4,50)");
    check("O1\n#1=4\nG65 P2 A#1\n#1=3\nM99\nO2\nG0 X#1\n#1=9\nM99", "R(4,50)");
    // The pass that starts at M99 P.
    check("O1\n#1=5\nN10 G0 X#1\nM99 P10", "R(5,50)");
    check("O1\n#1=5\n#2=1\nN10 #2=3\nG0 X#2\n#2=7\nM99 P10", "R(3,50)");
    check("O1\n#1=5\nN10 G0 X#1\n#1=#1-1\nIF[#1LT3]GOTO 20\nM99 P10\nN20 M30", "R(5,50) R(4,50) R(3,50)");
    // Read before assigned: another pass, until nothing changes or the program ends.
    check("O1\nG0 X[10+#500]\n#500=3\nM99", "R(10,50) R(13,50)");
    check("O1\n#501=#501+1\nG0 X#501\nIF[#501GT2]GOTO 9\nM99\nN9 M30", "R(1,50) R(2,50) R(3,50)");
    check(
        "O1\nM98 P2\nIF[#100GT2]GOTO 9\nM99\nN9 M30\nO2\n#100=#100+1\nG0 X#100\nM99",
        "R(1,50) R(2,50) R(3,50)",
    );
    // Positions and modal codes.
    check("O1\nG0 X20\n#1=#5041\nX[#1+1]\nM99", "R(20,50) R(21,50)");
    check("O1\nG28 U0\n#1=#5041\nG0 X60\nM99", "R(300,50) R(60,50)");
    check("O1\nG99\n#1=#4005\nG0 X#1\nG98\nM99", "R(99,50)");
    check(
        "O1\n#1=#5041\nG0 X[#1/2]\nIF[#1LT20]GOTO 9\nM99\nN9 M30",
        "R(50,50) R(25,50) R(12.5,50) R(6.25,50)",
    );
    check("O1\nG0 U-40\nIF[#5041LT30]GOTO 9\nM99\nN9 M30", "R(60,50) R(20,50)");
    // A skipped block assigns nothing.
    let skip = r#"{"initial": {"x": 100, "z": 50}, "blockSkip": [1]}"#;
    check_with(skip, "O1\n/#500=#500+1\nG0 X5\nM99", "R(5,50)");
}

#[test]
fn loops_inside_each_other_and_jumps_out_of_them() {
    let nested = "WHILE[#1LT2]DO1\n#2=0\nWHILE[#2LT2]DO2\nG0 U-1\n#2=#2+1\nEND2\n#1=#1+1\nEND1\nM30";
    check(nested, "R(99,50) R(98,50) R(97,50) R(96,50)");
    let jumps = "N1 #1=#1+1\nDO1\nG0 U-1\nIF[#1LT3]GOTO 1\nGOTO 9\nEND1\nN9 M30";
    check(jumps, "R(99,50) R(98,50) R(97,50)");
}

#[test]
fn arguments_of_a_macro_keep_their_digits() {
    check(
        "#1=0.25\nG65 P2 A[1/3] S#1 Q#1\nM30\nO2\nG0 X[#1*3000]\nX[#19*8]\nX[#17*4]\nM99",
        "R(1000,50) R(2,50) R(1,50)",
    );
}

#[test]
fn values_of_variables_have_a_point_when_they_are_written_out() {
    let setup = r#"{"initial": {"x": 100, "z": 50}, "dialect": {"decimal": "leastIncrement"}}"#;
    check_with(setup, "#1=10\nG0 X#1\nZ10\nM30", "R(10,50) R(10,0.01)");
}

#[test]
fn a_tool_number_from_a_variable_has_no_leading_zeros() {
    let setup = r#"{"initial": {"x": 60, "z": 5}, "tools": {"T0101": {"noseRadius": 0.8, "tip": 3}}, "dialect": {"feedMode": "G98"}}"#;
    check_with(
        setup,
        "M3 S1 F9\n#1=101\nT#1\nG42 G1 X40 Z0\nZ-20\nG40 X60\nM30",
        "F(40,-0.8) F(40,-20.8) F(60,-20)",
    );
}

#[test]
fn moves_by_codes_for_one_block_call_the_modal_macro_too() {
    let program = "G66 P2 A5\nG28 U0\nG67\nM30\nO2\nG0 W-#1\nM99";
    check(program, "R(300,50) R(300,45)");
}

#[test]
fn g29_goes_over_the_intermediate_point_of_each_axis() {
    let over = "G28 X120\nG28 Z60\nG29 X50 Z10\nM30";
    check(over, "R(120,50) R(300,50) R(300,60) R(300,300) R(120,60) R(50,10)");
    check("G28 X120 Z60\nG29 U-10\nM30", "R(120,60) R(300,300) R(120,300) R(110,300)");
}

#[test]
fn offsets_are_added_to_what_the_table_holds() {
    let setup = r#"{"initial": {"x": 60, "z": 5}, "tools": {"T0101": {"noseRadius": 0.8, "tip": 3}}, "dialect": {"feedMode": "G98"}}"#;
    let path = "\nM3 S1 F9\nT0101\nG42 G1 X40 Z0\nZ-20\nG40 X60\nM30";
    let more = "F(40,-1.6) F(40,-21.6) F(60,-20)";
    for data in ["G10 P10001 C0.8", "G10 P1 R0.8", "G10 L10 P1 R1.6", "#2901=1.6"] {
        check_with(setup, &format!("{data}{path}"), more);
    }
}

#[test]
fn hole_cycles_keep_their_data_until_g80() {
    let head = "M45\nM13 S500 F100\nG0 X0 Z5\n";
    let two = "R(0,5) R(20,5) R(20,2) F(20,-20) R(20,5) R(30,5) R(30,2) F(30,-20) R(30,5)";
    check(&format!("{head}G83 X20 Z-20 R-3\nG83 X30\nM30"), two);
    check(&format!("{head}G83 U20 Z-20 R-3 K2\nM30"), &two.replace("(30,", "(40,"));
    let tap = "R(0,5) R(20,5) R(20,2) T(20,-20)L0.2 T(20,2)L0.2 R(20,5)";
    check(&format!("{head}G84 X20 Z-20 R-3\nM30"), tap);
}

#[test]
fn g99_of_system_b_goes_back_to_the_r_point() {
    let setup = r#"{"initial": {"x": 100, "z": 50}, "dialect": {"gSystem": "B", "feedMode": "G98"}}"#;
    let head = "M45\nM13 S500 F100\nG90 G0 X0 Z5\n";
    let program = format!("{head}G99 G83 X20 Z-20 R2\nX30\nG98 X40\nG80\nM30");
    let expected =
        "R(0,5) R(20,5) R(20,2) F(20,-20) R(20,2) R(30,2) F(30,-20) R(30,2) R(40,2) F(40,-20) R(40,5)";
    check_with(setup, &program, expected);
}

#[test]
fn a_move_behind_a_corner_and_a_call_is_written_out_whole() {
    let program = "M3 S5 F9\nG0 X50 Z2\nG1 X40 ,C1\nM98 P2\nM30\nO2\nG1 W-5\nX50\nM99";
    check(program, "R(50,2) F(42,2) F(40,1) F(40,-3) F(50,-3)");
}

#[test]
fn g10_under_g91_adds_to_the_zero_point() {
    let setup = r#"{"initial": {"x": 100, "z": 50}, "dialect": {"gSystem": "B"}}"#;
    let program = "G90 G10 L2 P1 X10\nG91 G10 L2 P1 X10\n#1=#5221\nG90 G0 X0 Z#1\nM30";
    check_with(setup, program, "R(0,20)");
}

#[test]
fn g91_of_system_b_counts_c_and_stands_in_polar_interpolation() {
    let setup = r#"{"initial": {"x": 60, "z": 5}, "dialect": {"gSystem": "B", "feedMode": "G98"}}"#;
    check_with(setup, "M45\nG90 G0 C30\nG91 C10\nM30", "R(60,5,C30) R(60,5,C40)");
    let polar = "M45\nM13 S1 F9\nG1 X50\nG12.1\nG94 G90 X40 C5\nG91 X-10 C5\nG90\nG13.1\nM30";
    check_with(setup, polar, "F(50,5) F(40,5,C5) F(30,5,C10)");
}

#[test]
fn calls_between_g12_1_and_g13_1_are_written_out_in_its_plane() {
    let program =
        "M45\nM13 S1 F9\nG1 X80\nG12.1\n#1=10\nX[2*#1] C20 M98 P3\nIF[1EQ1]THEN X30\nG13.1\nM30\nO3\nC2\nM99";
    check(program, "F(80,50) F(20,50,C20) F(20,50,C2) F(30,50,C2)");
}

#[test]
fn a_subprogram_before_its_main_program_keeps_the_word_of_the_system() {
    let program =
        "O2\nG0 X5\nM99\nO1\nG28 U0 W0\nG92 S2000\nG95 F.2\nG0 X60 Z2\nM98 P2\nG78 X40 Z-10 F2\nM30";
    let analysis = run("{}", program);
    let codes: Vec<_> = analysis.diagnostics.iter().map(|found| found.message.code()).collect();
    assert!(codes.contains(&"I-G-SYSTEM"), "{codes:?}");
}

/// P, Q and L of M98 and M99 are neither the dwell of the hole cycle in force nor starts, start angle or chamfer
/// of the move in their block.
#[test]
fn the_words_of_a_call_are_not_those_of_the_move() {
    let hole = |x: u32| format!("R({x},50) R({x},2) F({x},-5) R({x},50)");
    let holes = [0, 10, 20].map(hole).join(" ");
    let drill = "M3 S500 F100\nG83 X0 Z-5 R-48";
    check(&format!("O1\n{drill}\nM98 P200\nX20\nG80\nM30\nO200\nX10\nM99"), &holes);
    check(&format!("O1\nM98 P200\nN7 X20\nG80\nM30\nO200\n{drill}\nX10\nM99 P7"), &holes);
    // P of these codes is a frame or a spindle.
    check(&format!("{drill}\nG54.1 P1\nX10\nG97 S500 P1\nX20\nG80\nM30"), &holes);
    let gsk = r#"{"initial": {"x": 32, "z": 2}, "dialect": {"control": "gsk", "feedMode": "G99"}}"#;
    let pass = |x: u32| format!("R({x},2) T({x},-10)L2 R(32,-10) R(32,2)");
    let thread = "M3 S500\nG92 X29 Z-10 F2\nX28 M98 P200 L2\nM30\nO200\nX27\nM99";
    check_with(gsk, thread, &[29, 28, 27, 27].map(pass).join(" "));
    let line = "G01 X32 Z-5 F.2 M98 P200 L2\nM30\nO200\nG01 U5\nM99";
    check_with(gsk, line, "F(32,-5) F(37,-5) F(42,-5)");
}
