//! Uncertain state after blocks that were not carried out, and how it becomes certain again, in a short
//! notation: `R(x,z)` rapid, `F` feed, `T` thread, `A` arc; a `?` marks uncertain motions.
use gcode_playground::analyze;
use gcode_playground::api;
use gcode_playground::machine::SimulationResult;
use gcode_playground::message::Severity;
use gcode_playground::run::Analysis;
use gcode_playground::setup::Setup;
use gcode_playground::units::number;

fn run(setup: &str, program: &str) -> Analysis {
    analyze(program.as_bytes(), &Setup::from_json(setup).expect("setup"))
}

fn motions(analysis: &Analysis) -> String {
    let rows = api::motions(&analysis.motions, &analysis.setup.machine).map(|row| {
        let letter = match row.kind {
            "rapid" => "R",
            "feed" => "F",
            "thread" => "T",
            "dwell" => "D",
            _ => "A",
        };
        let doubt = if row.uncertain { "?" } else { "" };
        format!("{letter}{doubt}({},{})", number(row.to.x.mm()), number(row.to.z))
    });
    rows.collect::<Vec<_>>().join(" ")
}

#[track_caller]
fn check_with(setup: &str, program: &str, expected: &str) {
    let analysis = run(setup, program);
    assert_eq!(motions(&analysis), expected, "\n{program}\n{:?}", analysis.diagnostics);
}

/// Checks the motions of a program that starts at X100 Z50.
#[track_caller]
fn check(program: &str, expected: &str) {
    check_with(r#"{"initial": {"x": 100, "z": 50}}"#, program, expected);
}

fn codes(analysis: &Analysis) -> Vec<&'static str> {
    analysis.diagnostics.iter().map(|found| found.message.slug()).collect()
}

/// Area of the half-section of the part, mm².
fn area(program: &str) -> f64 {
    let analysis = run("{}", program);
    let part = SimulationResult::of(&analysis.motions, &analysis.setup).finished().expect("a part");
    part.area()
}

#[test]
fn y_that_stays_0_changes_nothing() {
    let with = "G0G28U0.0V0.0\nG0X80Y0.Z5.\nG1X70.Y0F.2M3S500\nV0.\nG53 X200 Y0\nG28V0\nG30U0V0W0\nM30";
    let without = "G0G28U0.0\nG0X80Z5.\nG1X70.F.2M3S500\n\nG53 X200\n\nG30U0W0\nM30";
    let (with, without) = (run("{}", with), run("{}", without));
    assert_eq!(motions(&with), motions(&without));
    assert_eq!(codes(&with), codes(&without));
    assert!(!motions(&with).contains('?'));
}

#[test]
fn beside_y0_everything_is_uncertain_until_y_is_0_again() {
    check("G0 X80 Z5 Y3\nX70\nY0\nX60", "R?(80,5) R?(70,5) R(60,5)");
    check("G0 X80 Z5 V3\nX70\nV-3 X60\nX50", "R?(80,5) R?(70,5) R(60,5) R(50,5)");
    check("G0 X80 Z5 Y3\nG28 V0\nX60", "R?(80,5) R(60,5)");
    check("G0 X80 Z5\nG53 Y-40\nX60", "R(80,5) R?(60,5)");
    check(
        "G0 X80 Z5\nM3 S100\nG83 X10 Y5 Z-5 F.1\nG80\nG0 Y0 Z9",
        "R(80,5) R?(10,5) F?(10,-5) R?(10,5) R(10,9)",
    );
    let told = run("{}", "G0 X80 Y3\nX70 Y4\nM30");
    assert_eq!(codes(&told).iter().filter(|slug| **slug == "axis-not-supported").count(), 1);
}

#[test]
fn the_next_absolute_place_of_each_axis_ends_it() {
    // X is known after its own word, Z stays unknown until a word sets it.
    check("G0 X60 Z2\nM98 P9\nG0 X50\nW-5\nZ-4\nX40 Z1", "R(60,2) R?(50,2) R?(50,-3) R?(50,-4) R(40,1)");
    check("G0 X60 Z2\nM98 P9\nG0 X50 Z1\nU2\nW3", "R(60,2) R?(50,1) R(52,1) R(52,4)");
    check("G0 X60 Z2\nM98 P9\nG0 U5 W5\nU5\nX10 Z10\nU1", "R(60,2) R?(65,7) R?(70,7) R?(10,10) R(11,10)");
    // A block with an error makes only the programmed axes uncertain.
    check("M3 S1 F1\nG0 X60 Z2\nG1 Z-5 F-1\nX50\nZ-8\nX52", "R(60,2) F?(50,2) F?(50,-8) F(52,-8)");
    check("G0 X60 Z2\nG1 F-1\nG0 X50", "R(60,2) R(50,2)");
    check("G0 X60 Z2\nM3 S1 F1\nG1 X5X\nZ1\nX50\nZ0", "R(60,2) F?(60,1) F?(50,1) F(50,0)");
    // The reference point is a known position, and G50 sets one.
    check("G0 X60 Z2\nM98 P9\nG28 U0 W0\nG0 X50", "R(60,2) R?(300,300) R(50,300)");
    check("G0 X60 Z2\nM98 P9\nG28 U0\nG0 X50\nZ3\nX40", "R(60,2) R?(300,2) R?(50,2) R?(50,3) R(40,3)");
    check("G0 X60 Z2\nM98 P9\nG50 X200 Z150\nG0 X150", "R(60,2) R(150,150)");
    check("G0 X60 Z2\nM98 P9\nG53 X200 Z150\nG0 X150", "R(60,2) R?(200,150) R(150,150)");
    // In systems B and C, G91 counts from an unknown position.
    check_with(
        r#"{"initial": {"x": 100, "z": 50}, "dialect": {"gSystem": "B"}}"#,
        "G90 G0 X60 Z2\nM98 P9\nG91 G0 X5\nG90 X50 Z1\nX40",
        "R(60,2) R?(65,2) R?(50,1) R(40,1)",
    );
}

#[test]
fn what_kind_of_move_comes_is_unknown_until_a_code_says_it() {
    check("G0 X60 Z2\nM98 P9\nX50 Z1\nX40\nG0 X30\nX20", "R(60,2) R?(50,1) R?(40,1) R(30,1) R(20,1)");
    check("G0 X60 Z2\nG7.7 X50\nX40\nX30\nG1 X20 F1 M3 S1", "R(60,2) R?(40,2) R?(30,2) F(20,2)");
    check("G0 X60 Z2\nG300 (MAKER)\nG0 X50 Z1\nX40", "R(60,2) R?(50,1) R(40,1)");
}

#[test]
fn an_unsupported_code_puts_its_own_axes_in_doubt() {
    check("M3 S1 F1\nG0 X60 Z2\nG31 Z-5\nG0 X50\nZ3\nX40", "R(60,2) R?(50,2) R?(50,3) R(40,3)");
    check("G0 X60 Z2\nG5.1 Q1\nX50", "R(60,2) R(50,2)");
    // A mirror image stays until it is switched off.
    check("G0 X60 Z2\nG68\nX50 Z1\nX40\nG69\nX30 Z0\nX20", "R(60,2) R?(50,1) R?(40,1) R?(30,0) R(20,0)");
}

#[test]
fn cycles_come_back_to_where_they_started() {
    // A cycle block with an error leaves the tool where it is.
    check("M3 S1 F1\nG0 X60 Z2\nG71 P1 Q2 U1\nG0 X50\nZ1", "R(60,2) R(50,2) R(50,1)");
    // The words of a cycle are not a position of the tool.
    check(
        "M3 S1 F1\nG0 X60 Z2\nM98 P9\nG90 X50 Z-5\nG0 X62 Z3\nX61",
        "R(60,2) R?(50,2) F?(50,-5) F?(60,-5) R?(60,2) R?(62,3) R(61,3)",
    );
    // The stored words of a cycle are uncertain after a block with an error, until all are programmed again
    // or the cycle is cancelled.
    check("M3 S1 F1\nG0 X60 Z2\nG90 X55 Z-5X\nX50\nG0 X58", "R(60,2) R?(50,2) F?(60,2) R(58,2)");
    check("M3 S1 F1\nG0 X60 Z2\nG90 X55 Z-5X\nG90 X50 Z-5", "R(60,2) R(50,2) F(50,-5) F(60,-5) R(60,2)");
}

#[test]
fn a_contour_whose_cycle_cannot_be_read_is_drawn_in_doubt() {
    let program =
        |cycle: &str| format!("M3 S1 F1\nG0 X60 Z2\nG71 U2 R1\n{cycle}\nN10 G0 X50\nG1 Z-5\nN20 X60\nG0 X61");
    let good = run("{}", &program("G71 P10 Q20 U0 W0"));
    assert!(!motions(&good).contains('?'), "{}", motions(&good));
    check(&program("G71 P10 Q20 U0X"), "R(60,2) R?(50,2) F?(50,-5) F?(60,-5) R?(60,2) R(61,2)");
}

#[test]
fn what_comes_from_variables_is_as_doubtful_as_they_are() {
    check("G0 X60 Z2\n#1=30\n#1=[3\nX#1\nX50\nX40", "R(60,2) R?(30,2) R?(50,2) R(40,2)");
    check("G0 X60 Z2\n#2=5\nX#2\nX50", "R(60,2) R(5,2) R(50,2)");
}

#[test]
fn a_corner_that_does_not_fit_leaves_one_move_in_doubt() {
    check("M3 S1 F1\nG0 X60 Z2\nG1 Z-5 ,R90\nX80\nZ-9", "R(60,2) F?(80,-5) F(80,-9)");
}

#[test]
fn uncertain_cuts_are_not_taken_off_the_part() {
    let program = |middle: &str| {
        format!(
            "O1 (STOCK D=60 LENGTH=50)\nT0101\nG97 S500 M3\nG0 X62 Z2\nG0 X50\nG1 Z-10 F.2\nX62\nG0 Z2\n{middle}\nG0 X40 Z2\nG1 Z-5\nX62\nG0 X100 Z100\nM30"
        )
    };
    let (with, without) = (area(&program("M98 P9\nG1 U-30\nW-10\nU30")), area(&program("")));
    assert!((with - without).abs() < 1e-6, "{with}, not {without}");
}

/// After a skipped block the remaining material is uncertain, but the chuck is not. One unreadable pass makes
/// neither the tool unknown nor the part disappear.
#[test]
fn a_pass_that_cannot_be_read_leaves_the_part() {
    let program = "M3 S300 G0 X130 Z3\nG90 X120 Z-110 F200\nX110 ZZ-30\nX100\nX90\nX80\nX70\nX60\nG0 X120 Z-30\n\
                   G90 X120 Z-44 R-7.5 F150\nZ-56 R-15\nG0 X130 Z3\nM30";
    let mut analysis = run(r#"{"dialect": {"control": "gsk"}}"#, program);
    analysis.check_at_machine();
    assert!(!codes(&analysis).contains(&"tool-unknown"), "{:?}", codes(&analysis));
    let simulation = SimulationResult::of(&analysis.motions, &analysis.setup);
    assert!(simulation.finished().is_some());
}

#[test]
fn what_does_not_depend_on_it_is_still_checked() {
    let program = |cycle: &str, end: &str| {
        format!(
            "O1 (STOCK D=60 LENGTH=50 GRIP=20)\n(TOOL T0101 TYPE=TURNING)\nT0101\nG97 S500 M3\nG0 X62 Z2\n{cycle}\nG0 X50\nG0 {end}\nM30"
        )
    };
    let slugs = |program: &str| {
        let mut analysis = run("{}", program);
        analysis.check_at_machine();
        codes(&analysis)
    };
    assert!(slugs(&program("", "Z-5")).contains(&"rapid-through-stock"));
    assert!(!slugs(&program("G90 X50 Z-9 F-1", "Z-5")).contains(&"rapid-through-stock"));
    assert!(slugs(&program("G90 X50 Z-9 F-1", "Z-45")).contains(&"tool-into-jaws"));
}

#[test]
fn a_macro_without_its_call_does_not_know_its_arguments() {
    let only = |program: &str| {
        let analysis = run(r#"{"initial": {"x": 100, "z": 50}}"#, program);
        let found = codes(&analysis).into_iter().filter(|slug| slug.starts_with("macro")).collect::<Vec<_>>();
        (found, motions(&analysis))
    };
    let unknown = |program: &str, expected: &str| {
        assert_eq!(only(program), (vec!["macro-arguments-unknown"], expected.into()), "{program}");
    };
    // A division by an unknown argument, or by a value calculated from it, is not an error.
    unknown("#4=10/#3\n#100=[#1-#2]/[#1*2]\n#5=1/#100\nM99", "");
    unknown("G0 X[10/#3] Z5\nZ2\nM99", "R?(100,2)");
    unknown("G0 X#24 Z5\nM99", "R?(100,5)");
    // A misread GOTO300 is not a tool word, so the program is still a macro body.
    unknown("#4=10/#3\nGOT0300\n#5=1/#3\nM99", "");
    // The same applies to function values, jump targets and checks that depend on it, and to a loop that
    // might not end.
    unknown("#4=LN[#1]\nGOTO#2\nIF[#3EQ#0]GOTO 9\nM99\nN9 #3000=1(NO DEPTH)\nM99", "");
    unknown("IF[#3NE#0]GOTO 9\n#3000=1(NO DEPTH)\nN9 G0 X50\nM99", "R?(50,50)");
    unknown("#4=10\nWHILE[#4GT#1]DO1\nG0 X#4\n#4=#4-#2\nEND1\nM99", "R?(10,50)");
    unknown("#4=10\nN5 G0 X#4\n#4=#4-#2\nIF[#4GT#1]GOTO 5\nM99", "R(10,50)");
    unknown("IF[#1EQ#0]THEN #1=5\nIF[#2EQ1]THEN #3=1\n#4=1/#3+1/[#1-5]\nM99", "");
    // Arguments passed on are unknown as well.
    unknown("O1\nG65 P2 A#1 B[#2*2]\nM99\nO2\n#3=1/#1+1/#2\nM99", "");
}

#[test]
fn what_is_no_argument_is_a_fault_in_a_macro_as_in_every_program() {
    let division = |program: &str| {
        let found = codes(&run(r#"{"initial": {"x": 100, "z": 50}}"#, program));
        assert!(found.contains(&"macro-division-by-zero"), "{program}\n{found:?}");
    };
    // It assigns the zero itself; no address sets the variable; it is a main program with an end or tools.
    division("#1=0\n#4=5/#1\nM99");
    division("#5=#2\n#1=0\n#4=5/#1\nM99");
    division("#4=5/#10\nM99");
    division("#4=5/#3\nM30");
    division("T0101\n#4=5/#3\nM99");
    division("O1\n#1=0\nG65 P2 A#1\nM30\nO2\n#4=5/#1\nM99");
}

/// A contour with an error makes the motions of the correct contour, marked as uncertain. `cycle`: the blocks
/// of the cycle at X44 Z2, `faulty` and `sound`: the contour from N10 to N20.
#[track_caller]
fn check_faulty_contour(cycle: &str, faulty: &str, sound: &str, slug: &str) {
    let program = |contour: &str| format!("M3 S1 F1\nG0 X44 Z2\n{cycle}\nGOTO30\n{contour}\nN30 G0 X50");
    let (faulty, sound) = (run("{}", &program(faulty)), run("{}", &program(sound)));
    let errors = |analysis: &Analysis| -> Vec<_> {
        let found = analysis.diagnostics.iter().filter(|found| found.severity == Severity::Error);
        found.map(|found| found.message.slug()).collect()
    };
    assert_eq!((errors(&faulty), errors(&sound)), (vec![slug], vec![]), "{cycle}");
    // Neither the approach nor the motions after the cycle are uncertain.
    let expected = motions(&sound);
    let mut expected: Vec<_> = expected.split(' ').map(|own| own.replacen('(', "?(", 1)).collect();
    let last = expected.len() - 1;
    assert!(last > 4, "{expected:?}");
    for own in [0, last] {
        expected[own] = expected[own].replace('?', "");
    }
    assert_eq!(motions(&faulty), expected.join(" "), "{cycle}");
    // The remaining material is unknown.
    assert_eq!(faulty.motions.first_incomplete(), Some(1), "{cycle}");
}

#[test]
fn a_contour_with_an_error_is_drawn_in_doubt() {
    let sound = "N10 G0 X30\nG1 Z-5\nX36 Z-8\nN20 X44";
    let late = ["N10\nG0 X30\nG1 Z-5\nX36 Z-8\nN20 X44", "N10 G42\nG0 X30\nG1 Z-5\nX36 Z-8\nN20 X44"];
    let refused = "N10 G0 X30\nG1 Z-5\nG2 X34 Z-6 R0.1\nG1 X36 Z-8\nN20 X44";
    let called = "N10 G0 X30\nG1 Z-5\nM98 P7\nX36 Z-8\nN20 X44";
    for cycle in ["G70 P10 Q20", "G71 U2 R1\nG71 P10 Q20 U0 W0", "G73 U4 W0 R3\nG73 P10 Q20 U0 W0"] {
        for late in late {
            check_faulty_contour(cycle, late, sound, "contour-first-block");
        }
        check_faulty_contour(cycle, refused, sound, "arc-radius-too-small");
        check_faulty_contour(cycle, called, sound, "call-in-contour");
    }
    let facing = "G72 W2 R1\nG72 P10 Q20 U0 W0";
    check_faulty_contour(
        facing,
        "N10\nG0 Z-10\nG1 X38\nX34 Z-6\nN20 Z2",
        "N10 G0 Z-10\nG1 X38\nX34 Z-6\nN20 Z2",
        "contour-first-block",
    );
}

/// With an error in its own block, a cycle makes uncertain motions of the known words: its passes, or the
/// contour as written. The tool is back at the start point X44 Z2.
#[test]
fn a_cycle_with_an_error_is_drawn_in_doubt() {
    #[track_caller]
    fn check(head: &str, cycle: &str, slug: &str, expected: &str) {
        let analysis = run("{}", &format!("M3 S1 {head}\nG0 X44 Z2\n{cycle}\nG0 X50\nM30"));
        let told: Vec<_> = analysis.diagnostics.iter().map(|found| found.message.slug()).collect();
        assert!(told.contains(&slug), "{cycle}: {told:?}");
        assert_eq!(motions(&analysis), format!("R(44,2) {expected} R(50,2)"), "{cycle}");
    }
    let contour = "N10 G0 X30\nG1 Z-5\nX36 Z-8\nN20 X44";
    let as_written = "R?(30,2) F?(30,-5) F?(36,-8) F?(44,-8) R?(44,2)";
    for (first, second, slug) in [
        ("G71 U0 R1", "G71 P10 Q20 U0 W0", "depth-not-positive"),
        ("G71 U-2 R1", "G71 P10 Q20 U1 W0.5", "depth-not-positive"),
        ("G71 R1", "G71 P10 Q20 U0 W0", "depth-missing"),
        ("G73 U4 W0 R0", "G73 P10 Q20 U0 W0", "pattern-without-passes"),
        ("G73 U4 W0", "G73 P10 Q20 U0 W0", "pattern-without-passes"),
        // An unreadable word.
        ("G71 U2 R1", "G71 P10 Q20 U0 W", "number-missing"),
    ] {
        check("F1", &format!("{first}\n{second}\n{contour}"), slug, as_written);
    }
    // Only the feed rate is missing: the passes are 2 mm deep, on the radius.
    let passes = "R?(40,2) F?(40,-8) R?(42,-7) R?(42,2)";
    let roughing = "G71 U2 R1\nG71 P10 Q20 U0 W0\nN10 G0 X36\nN20 G1 Z-8";
    check("", roughing, "feed-missing", &format!("{passes} R?(36,2) F?(36,-8) R?(44,2)"));
    check("", "G90 X40 Z-5", "feed-missing", "R?(40,2) F?(40,-5) F?(44,-5) R?(44,2)");
    check("", "G94 X40 Z-5", "feed-missing", "R?(44,-5) F?(40,-5) F?(40,2) R?(44,2)");
    check("", "G92 X40 Z-5", "lead-missing", "R?(40,2) T?(40,-5) R?(44,-5) R?(44,2)");
    let thread = "G76 P010060 Q100 R0\nG76 X40 Z-5 P2000 Q300";
    check("", thread, "lead-missing", "R?(40,2) T?(40,-5) R?(44,-5) R?(44,2)");
    let thread = "G76 P010060 Q100 R0\nG76 X40 Z-5 P0 Q300";
    check("F1", thread, "thread-without-depth", "R?(40,2) T?(40,-5) R?(44,-5) R?(44,2)");
    check("F1", "G75 R1\nG75 X40 P-2000", "peck-negative", "F?(40,2) R?(44,2)");
    check("", "G75 R1\nG75 X40 P2000", "feed-missing", "F?(40,2) R?(44,2)");
    // The column step is missing: the first and the last column are known.
    let columns = "F?(40,2) R?(44,2) R?(44,-5) F?(40,-5) R?(44,-5) R?(44,2)";
    check("F1", "G75 R1\nG75 X40 Z-5 P2000", "peck-missing", columns);
    check("F1", "G75 R1\nG75 X40 Z-5 P2000 Q0", "peck-missing", columns);
}

/// Other faults of a cycle are reported once its contour is correct.
#[test]
fn an_error_in_a_contour_is_the_only_one_of_its_cycle() {
    let contour = "N10\nG0 X30\nG1 Z-5\nN20 X44\nG0 X50";
    for program in [
        format!("M3 S1 F1\nG0 X44 Z2\nG71 P10 Q20 U0 W0\n{contour}"),
        format!("M3 S1 F1\nG0 X44 Z2\nG73 P10 Q20 U0 W0\n{contour}"),
        format!("M3 S1\nG0 X44 Z2\nG71 U2 R1\nG71 P10 Q20 U0 W0\n{contour}"),
    ] {
        let analysis = run("{}", &program);
        let errors = analysis.diagnostics.iter().filter(|found| found.severity == Severity::Error);
        let errors: Vec<_> = errors.map(|found| found.message.slug()).collect();
        assert_eq!(errors, ["contour-first-block"], "{program}");
        assert!(motions(&analysis).contains("F?(30,-5) F?(44,-5) R?(44,2) R(50,2)"), "{program}");
    }
}

/// The block without F is not carried out, so the arc begins elsewhere, and its radius says nothing.
#[test]
fn an_arc_from_an_unknown_place_has_no_message() {
    for arc in ["G03 X11 W-5.5 R5.5", "G03 X11 W-5.5 K-5.5"] {
        let program = format!("T0101\nG98 G97 S800 M03\nG01 X0\n{arc} F100\nG01 W-10\nM30\n");
        let analysis = run("{}", &program);
        let codes = codes(&analysis);
        assert!(codes.contains(&"feed-missing"), "{arc}: {codes:?}");
        assert!(codes.iter().all(|code| !code.starts_with("arc-")), "{arc}: {codes:?}");
    }
}
