//! Constructs that machinists write on purpose, and that must not cause a warning. Each is paired with a
//! similar mistake that is reported.

use gcode_playground::analyze;
use gcode_playground::message::{Severity, said};
use gcode_playground::setup::Setup;

/// The slugs of the messages with at least this severity.
fn told(setup: &str, text: &str, least: Severity) -> Vec<&'static str> {
    let analysis = analyze(text.as_bytes(), &Setup::from_json(setup).expect("setup"));
    let grave = analysis.diagnostics.iter().filter(|told| told.severity >= least);
    grave.map(|told| told.message.slug()).collect()
}

/// Checks the warnings and errors of a program.
#[track_caller]
fn check_with(setup: &str, text: &str, slugs: &[&str]) {
    assert_eq!(told(setup, text, Severity::Warning), slugs, "\n{text}");
}

#[track_caller]
fn check(text: &str, slugs: &[&str]) {
    check_with("{}", text, slugs);
}

/// Checks that the program has only this note.
#[track_caller]
fn check_note(text: &str, slug: &str) {
    check(text, &[]);
    assert!(told("{}", text, Severity::Info).contains(&slug), "no {slug}\n{text}");
}

/// A turned part, followed by `rest`.
fn behind_turning(rest: &str) -> String {
    format!(
        "O0001\nG21 G40 G99\nT0101\nG97 S900 M03\nG00 X28 Z2 M08\nG01 Z-40 F0.2\nX34\nG00 X150 Z150 M09\nM05\n{rest}"
    )
}

#[test]
fn a_bar_is_pulled_with_the_spindle_stopped() {
    let puller = behind_turning(
        "T1010\nG98\nG00 X0 Z-10\nG01 Z-25 F300\nM11\nG04 X1\nG01 Z35 F1000\nM10\nG04 X1\nG00 Z150\nM30\n",
    );
    check(&puller, &[]);
    // Opened before the tool moves.
    let feeder = behind_turning(
        "T1212\nG98\nG00 X0 Z40\nG01 Z2 F1000\nM69\nG04 X1.5\nG01 Z0 F200\nG04 X0.5\nM68\nG00 X150 Z150\nM30\n",
    );
    check(&feeder, &[]);
    let stop_first = "O0001\nG21 G40\nT1212\nG98 G00 X0 Z40\nM11\nG01 Z1 F500\nM10\nG00 X150 Z150\nG97 S800 M03\n\
                      T0101 G99\nG00 X28 Z2 M08\nG01 Z-40 F0.2\nG00 X150 Z150\nM30\n";
    check(stop_first, &[]);
}

#[test]
fn a_cut_behind_the_bar_puller_needs_the_spindle_again() {
    let forgotten = behind_turning(
        "T1010\nG98\nG00 X0 Z-10\nG01 Z-25 F300\nM11\nG01 Z35 F1000\nM10\nG00 X150 Z150\nM03 S800 G97\nM05\n\
         T0101 G99\nG00 X28 Z2\nG01 Z-40 F0.2\nG00 X150 Z150\nM30\n",
    );
    check(&forgotten, &["cut-with-spindle-stopped"]);
    let no_chuck = behind_turning("T0202\nG00 X26 Z2\nG01 Z-20 F0.1\nG00 X150 Z150\nM30\n");
    check(&no_chuck, &["cut-with-spindle-stopped"]);
}

#[test]
fn a_makers_code_with_a_speed_may_turn_a_tool_or_another_spindle() {
    let milling = |start: &str| {
        format!(
            "O0001\nG21 G40\nT0606\nG98\nM45\nG28 H0\n{start}\nG00 X80 Z2 C0\nG12.1\nG01 X60 F200\nC20\nX-60\nC-20\nX60\n\
             C0\nX80\nG13.1\nG00 Z100\nM46\nM30\n"
        )
    };
    check(&milling("M63 S2500"), &[]);
    check(&milling("S2500 M103"), &[]);
    check(&milling("G97 S2500\nM52"), &[]);
    check(&milling("G97 S2500"), &["live-tool-stopped"]);
    let other_spindle = behind_turning(
        "T0707\nG96 S150 M203 P11\nG50 S2500\nG00 X32 Z-20 M08\nG75 R0.2\nG75 X-0.5 P1500 F0.06\nG00 X150 M205\nZ150\nM30\n",
    );
    check(&other_spindle, &[]);
    let no_speed = behind_turning("M79\nT0707\nG00 X32 Z-20 M08\nG01 X20 F0.06\nG00 X150\nZ150\nM30\n");
    check(&no_speed, &["cut-with-spindle-stopped"]);
}

#[test]
fn a_word_that_goes_nowhere_is_no_cut() {
    let text = "G99 T0101\nG97 S800 M03\nG00 X40 Z2 M08\nG01 Z-10 F0.2\nM05\nG28 U0\nW0\nM30\n";
    check(text, &[]);
    check(&text.replace("W0", "W1"), &["cut-with-spindle-stopped"]);
}

#[test]
fn the_percent_sign_may_stand_behind_the_last_block() {
    let program =
        |end: &str| format!("%\nO0001\nG99 T0101\nG97 S800 M03\nG00 X40 Z2\nG01 Z-9 F0.2\nG00 X90{end}");
    for end in ["\nM30%", "\nM30%\n", "\nM30 %\r\n", "\nM30;%\n\n", " M30%", "\nM02%\n%\n"] {
        check(&program(end), &[]);
    }
    // In the middle of a program it is a mistake.
    check(&program("%\nG00 Z90\nM30\n"), &["character-not-understood"]);
}

#[test]
fn threads_per_inch_are_a_whole_number() {
    let gsk = r#"{"dialect": {"control": "gsk"}}"#;
    let thread = "G99 T0303\nG97 S400 M03\nG00 X40.0 Z5.0 M08\nG92 X32.5 Z-30.5 I8\nX32.0\nX31.5\nX31.2\nX30.95\n\
                  G00 X100.0 Z100.0\nM30\n";
    check_with(gsk, thread, &[]);
    let straight = "G99 T0303\nG97 S400 M03\nG00 X40.0 Z5.0 M08\nX32.5\nG32 Z-30.5 I11\nG00 X40.0\nZ5.0\nX31.5\n\
                    G32 Z-30.5 I11\nG00 X40.0\nZ5.0\nX100.0 Z100.0\nM30\n";
    check_with(gsk, straight, &[]);
    // FANUC reads the same letter as a taper, so a warning is useful.
    check(&thread.replace("I8", "I-1.0 F3.0"), &["letter-i-in-g92"]);
}

#[test]
fn a_safe_line_with_g90_before_a_motion_code_starts_no_cycle() {
    let program = |header: &str, first: &str| {
        format!("{header}\nT0101\nG97 S800 M03\n{first} M08\nG01 Z-30. F.2\nX54.\nG00 X150. Z150.\nM30\n")
    };
    for header in ["G18G21G40G80G90G99", "G21 G18 G90 G99 G40", "G90 G54 G99", "G21 G40 G90 G99\nU0.W0."] {
        check(&program(header, "G00 X46. Z2."), &[]);
    }
    check(&program("G21 G90 G99", "G01 X46. Z2. F1."), &[]);
    // Here the cycle does start.
    check(&program("G21 G90 G99", "X46. Z2. F.2"), &["g90-is-a-cycle"]);
}

#[test]
fn a_feed_in_a_contour_that_g70_uses_is_no_slip() {
    let program = |finish: &str| {
        format!(
            "G99 T0101\nG97 S800 M03\nG00 X52 Z2 M08\nG71 U2 R0.5\nG71 P10 Q20 U0.4 W0.1 F0.25\nN10 G00 X30 S1200\n\
             G01 Z-20 F0.1\nN20 X52\n{finish}G00 X150 Z150\nM30\n"
        )
    };
    let classroom = r#"{"rules": {"feed-only-for-finishing": "warning"}}"#;
    check_with(classroom, &program("G70 P10 Q20\n"), &[]);
    check_with(classroom, &program("T0202\nG00 X52 Z2\nG70 P10 Q20\n"), &[]);
    let twice = ["feed-only-for-finishing", "feed-only-for-finishing"];
    check_with(classroom, &program(""), &twice);
    check_with(classroom, &program("(G70 P10 Q20)\n"), &twice);
}

#[test]
fn a_file_that_ends_in_m99_may_be_a_subprogram_or_run_with_a_bar_feeder() {
    check_note("O8001\nG28 U0\nG28 W0\nM01\nM99\n", "main-program-without-end");
    let bar = behind_turning("M20\nG04 X3\nM99\n");
    check_note(&bar, "main-program-without-end");
}

#[test]
fn a_cone_that_may_have_been_worked_out_is_a_note_without_a_repair() {
    let program = |taper: &str| {
        format!(
            "(STOCK D=50 LENGTH=80)\nG99 T0101\nG97 S800 M03\nG00 X60 Z4 M08\nG90 X50 Z-20 R{taper} F0.2\nG00 X90 Z90\nM30\n"
        )
    };
    let cone = |taper: &str| {
        let text = program(taper);
        let analysis = analyze(text.as_bytes(), &Setup::default());
        let found = analysis.diagnostics.into_iter().find(|told| told.message.slug() == "taper-not-extended");
        found.map(|told| (told.severity, told.fixes.len()))
    };
    // X44.1667 at the face is not a drawing dimension, and the cone has no usual slope.
    assert_eq!(cone("-3.5"), Some((Severity::Warning, 1)));
    // X40 at the face: calculated for the start point.
    assert_eq!(cone("-6"), None);
    // X48.3333 at the face, but 2 mm in the diameter over 24 mm are 1:12.
    assert_eq!(cone("-1"), Some((Severity::Info, 0)));
}

#[test]
fn both_axes_in_the_first_block_of_a_contour_are_a_note() {
    let text = "G99 T0101\nG97 S800 M03\nG00 X52 Z2 M08\nG71 U2 R0.5\nG71 P10 Q20 U0.4 W0.1 F0.25\nN10 G00 X30 Z2\n\
                G01 Z-20\nN20 X52\nG70 P10 Q20 F0.1\nG00 X150 Z150\nM30\n";
    check_note(text, "contour-names-both-axes");
}

#[test]
fn a_finish_may_start_from_another_point_that_clears_the_part() {
    let program = |start: &str| {
        format!(
            "G99 T0101\nG97 S800 M03\nG00 X52 Z2 M08\nG71 U2 R0.5\nG71 P10 Q20 U0.4 W0.1 F0.25\nN10 G00 X30\nG01 Z-20\n\
             X40\nZ-30\nN20 X50\nG00 X150 Z150\nT0202\nG97 S1200 M03\nG00 {start}\nG70 P10 Q20 F0.1\nG00 X150 Z150\nM30\n"
        )
    };
    for start in ["X51 Z2", "X60 Z5", "X50 Z1"] {
        check(&program(start), &[]);
    }
    // From there the last rapid crosses the shoulder at X50.
    for start in ["X34 Z2", "X52 Z-5"] {
        check(&program(start), &["finish-starts-elsewhere"]);
    }
}

#[test]
fn the_turret_may_turn_in_the_block_that_goes_home() {
    let program = |change: &str| {
        format!(
            "(STOCK D=50 LENGTH=80)\nG99 T0101\nG97 S800 M03\nG00 X46 Z2 M08\nG01 Z-20 F0.2\nX52\n{change}\nM30\n"
        )
    };
    check(&program("G28 U0 W0 T0202"), &[]);
    check(&program("T0202"), &["tool-change-near-work"]);
}

#[test]
fn a_speed_limit_may_stand_behind_the_rapid_that_comes_to_the_work() {
    let program = |limit: &str| {
        format!("G99 T0101\nG96 S200 M03\nG00 X54 Z2 M08\n{limit}G01 Z-20 F0.2\nG00 X150 Z150\nM30\n")
    };
    check(&program("G50 S2500\n"), &[]);
    check(&program(""), &["surface-speed-without-clamp"]);
}

#[test]
fn who_pads_places_with_zeros_means_them() {
    let program = |face: &str| {
        format!("G99 T0101\nG97 S500 M03\nG00 X58 Z02 M08\nG94 X00 {face} F0.2\nZ-1.5\nG00 X150 Z150\nM30\n")
    };
    check(&program("Z00"), &[]);
    let once = "G99 T0101\nG97 S500 M03\nG00 X58 Z02 M08\nG94 X0 Z0 F0.2\nZ-1.5\nG00 X150 Z150\nM30\n";
    check(once, &["leading-zero"]);
}

#[test]
fn a_drill_cycle_of_other_controls_ends_at_the_way_home() {
    let text = "G99 T0808\nG97 S1000 M03\nG00 X0 Z2 M08\nG81 Z-10 F0.1\nZ-20\nG28 U0 W0\nM30\n";
    check(text, &["hole-cycle-of-other-controls"]);
    check(&text.replace("G81", "G83").replace("F0.1", "Q5000 F0.1"), &["code-with-hole-cycle"]);
}

#[test]
fn a_contour_that_could_not_be_roughed_is_not_said_to_lack_its_roughing() {
    let text = "G99 T0101\nG97 S800 M03\nG00 X52 Z2 M08\nG71 U0 R0.5\nG71 P10 Q20 U0.4 W0.1 F0.25\nN10 G00 X30\nG01 Z-20\n\
                N20 X52\nG70 P10 Q20 F0.1\nG00 X150 Z150\nM30\n";
    check(text, &["depth-not-positive"]);
}

#[test]
fn an_arc_that_ends_elsewhere_along_y_goes_somewhere() {
    let program = |end: &str| {
        format!(
            "G98 G21 T0707\nG97 S3000 M03\nG17 G00 X40 Y8 Z-11 M08\nG01 X26.6 F75\nG18 G03 X26.6 {end}R15.5 F150\nG00 X60\nM30\n"
        )
    };
    let told = |text: &str| told("{}", text, Severity::Warning);
    assert!(!told(&program("Y-8 ")).contains(&"arc-without-way"));
    assert!(told(&program("")).contains(&"arc-without-way"));
}

#[test]
fn what_depends_on_the_control_is_said_once() {
    let text = "G99 T0101\nG97 S800 M03\nG00 X46 Z2 M08\nG01 Z-20 F0.2\nG28\nT0202\nG00 X44 Z2\nG01 Z-20\nG28\nM30\n";
    check(text, &["g28-without-axis"]);
    // Two digits with M06: a turret that takes only two.
    check("G99\nM06 T01\nG97 S800 M03\nG00 X46 Z2 M08\nG01 Z-20 F0.2\nG00 X90 Z90\nM30\n", &[]);
    // Roughing with compensation on: old controls ignore it, newer ones apply it.
    let rough = "G99 T0101\nG97 S800 M03\nG42 G00 X52 Z2 M08\nG71 U2 R0.5\nG71 P10 Q20 U0.4 W0.1 F0.25\nN10 G00 X30\n\
                 G01 Z-20\nN20 X52\nG70 P10 Q20 F0.1\nG40 G00 X150 Z150\nM30\n";
    check_note(rough, "compensation-without-effect");
}

#[test]
fn a_spindle_with_its_face_turned_round_cuts_toward_positive_z() {
    let back = "O0001\nG21 G40 G99\nT0101 G54\nG97 S900 M03\nG00 X28 Z2\nG01 Z-40 F0.2\nX34\nG00 X150 Z150\n\
                T0505 G55\nG97 S1200 M04 G00 X0 Z-3\nG01 Z16 F0.1\nG00 Z-3\nX150 Z-150\nM30\n";
    check(back, &[]);
    // The same cut from in front of the face, in the only frame.
    let lost = back.replace(" G55", "").replace("X0 Z-3", "X0 Z3");
    check(&lost, &["minus-missing"]);
}

#[test]
fn a_lone_g94_sets_the_unit_of_f_in_code_system_b() {
    let flat = |head: &str| {
        format!(
            "O0001\n{head}\nT0505\nM45\nM13 S1500\nG00 X80 C0 Z-2\nG12.1\nG01 X40 F100\nC10\nX80\nG13.1\nG00 X150 Z150\nM30\n"
        )
    };
    check(&flat("G94"), &[]);
    check(&flat("G99 G94"), &["polar-with-feed-per-turn", "feed-unit-mixed-up"]);
    check(&flat("G99"), &["polar-with-feed-per-turn", "feed-unit-mixed-up"]);
}

#[test]
fn a_station_that_stands_at_work_gets_its_offset() {
    let program =
        "O0001\nG21 G40 G99\nT2200\nG97 S900 M03\nG00 X28 Z2 T22\nG01 Z-40 F0.2\nX34\nG00 X150 Z150\nM30\n";
    check(program, &[]);
    check(&program.replace("T22\n", "T21\n"), &["short-tool-word"]);
    check(&program.replace("T2200", "T2202"), &["short-tool-word"]);
}

#[test]
fn numbers_of_tools_belong_to_the_machine() {
    let program = |call: &str| {
        format!(
            "O0001\nG21 G40 G99\n{call}\nG97 S900 M03\nG00 X28 Z2\nG01 Z-40 F0.2\nX34\nG00 X150 Z150\nM30\n"
        )
    };
    check_note(&program("M06 T012400"), "tool-number");
    check_note(&program("T012400"), "tool-number");
    check(&program("T1010101"), &["tool-number"]);
    check_note(&program("T0101\nG50 S2000 T0100"), "tool-with-setting-code");
    check(&program("G50 X150 Z150 T0101"), &["tool-with-setting-code"]);
}

#[test]
fn a_thread_starts_at_the_crest_that_its_height_gives() {
    let thread = |start: &str| {
        format!(
            "O0001\nG21 G40 G99\nT0303\nG97 S400 M03\nG00 {start} Z6\nG76 P020060 Q100 R0.05\n\
             G76 X27.4 Z-30 P1300 Q400 F2\nG00 X150 Z150\nM30\n"
        )
    };
    check_note(&thread("X30"), "thread-start-inside-crest");
    check(&thread("X29.5"), &["thread-start-inside-crest"]);
}

#[test]
fn the_first_pass_of_a_pattern_cuts_what_stands_there() {
    let part = |before: &str| {
        format!(
            "O0001 (STOCK D=60 LENGTH=90)\nG21 G40 G99\nT0101\nG97 S500 M03\nG00 X64 Z3\n{before}G00 X64 Z3\nG73 U1 W1 R3\n\
             G73 P10 Q20 U0.4 W0.1 F0.25\nN10 G00 X36 Z1\nG01 Z-10 F0.1\nN20 X50 Z-20\nG00 X150 Z150\nM30\n"
        )
    };
    check(&part("G90 X55 Z-40 F0.25\nX50\nX46\n"), &[]);
    check(&part(""), &["pattern-first-pass-deep"]);
    // The turned shape is not the shape that the contour needs.
    check(&part("G90 X55 Z-12 F0.25\nX50\nX46\n"), &["pattern-first-pass-deep"]);
}

#[test]
fn g96_has_no_speed_of_its_own() {
    let program =
        "O0001\nG21 G40 G99\nT0101\nG97 S250 M03\nG00 X28 Z2\nG96\nG01 Z-40 F0.2\nX34\nG00 X150 Z150\nM30\n";
    let analysis = analyze(program.as_bytes(), &Setup::default());
    let told = analysis.diagnostics.iter().find(|told| told.message.slug() == "speed-missing").expect("told");
    assert_eq!(told.message, said::SurfaceSpeedMissing.into());
    check(&program.replace("G96\n", "G50 S2000\nG96 S120\n"), &[]);
}

#[test]
fn commas_between_remarks_are_no_text() {
    let program = "O0001\nG21 G40 G99\n(FACE), (F0.3), (COOLANT ON).\nT0101\nG97 S900 M03\nG00 X28 Z2\nG01 Z-40 F0.2\nX34\nG00 X150 Z150\nM30\n";
    check(program, &["character-not-understood"]);
    check(&program.replace("(F0.3)", "feed of roughing"), &["text-outside-comment"]);
}

#[test]
fn the_machine_may_know_the_radius_of_a_cutter() {
    let flat = |tool: &str| {
        format!(
            "O0001\nG98\n{tool}\nM45\nM13 S1500\nG00 X90 C0 Z-2\nG12.1\nG42 G01 X50 F120\nC30\nG40 X90\nG13.1\nG00 X150 Z150\nM30\n"
        )
    };
    check_note(&flat("T0505"), "polar-without-cutter-radius");
    check(&flat("T0500"), &["polar-without-cutter-radius"]);
    check(&flat("T0505 (TOOL T0505 TYPE=ENDMILL CUTTER=0)"), &["polar-without-cutter-radius"]);
}

#[test]
fn a_feed_whose_unit_changed_is_told_of_once() {
    let threaded = |mode: &str| {
        format!(
            "O0001\nG21 G40 G99\nT0303\nG97 S400 M03\nG00 X34 Z6\nG92 X29 Z-30 F1.5\nX28.5\nG00 X150 Z150\n\
             T0101 {mode}\nG00 X28 Z2\nG01 Z-40\nX34\nG00 X150 Z150\nM30\n"
        )
    };
    check(&threaded("G98"), &["feed-kept-in-other-unit"]);
    check(&threaded("G99"), &["feed-of-thread-kept"]);
}

#[test]
fn compensation_switched_on_for_the_next_tool() {
    let program = "O0001\nG21 G40 G99\nT0101\nG97 S900 M03\nG00 X28 Z2\nG01 Z-20 F0.2\nX34\nG00 X150 Z150\nG42\nT0202\n\
                   G00 X20 Z2\nG01 Z-10\nX36\nG40 G00 X150 Z150\nM30\n";
    check(program, &[]);
    let left = program.replace("G42\n", "").replace("G00 X28", "G42 G00 X28");
    check(&left, &["compensation-left-on"]);
}

#[test]
fn a_lone_dwell_with_the_spindle_stopped_is_an_exact_stop() {
    let program = |dwell: &str, stop: &str| {
        format!(
            "O0001\nG21 G40 G99\nT0101\nG97 S900 M03\nG00 X28 Z2\nG01 Z-40 F0.2\n{stop}{dwell}\nX34\nG00 X150 Z150\nM30\n"
        )
    };
    let pulled =
        program("G04", "X34\nG00 X150 Z150\nM05\nM68\n").replace("M68\nG04\nX34\n", "M68\nG04\nM69\n");
    check_note(&pulled, "dwell-without-time");
    check(&program("G04", ""), &["dwell-without-time"]);
    check(&pulled.replace("G04", "G04 X0"), &["dwell-without-time"]);
}

#[test]
fn a_finish_starts_lower_where_the_way_back_is_free() {
    let program = |start: &str| {
        format!(
            "O0001\nG21 G40 G99\nT0101\nG97 S900 M03\nG00 X44 Z2\nG71 U2 R0.5\nG71 P10 Q20 U0.4 W0.1 F0.2\n\
             N10 G00 X20\nG01 Z-10\nX36 Z-30\nN20 G00 X44\nG00 X150 Z150\nG00 {start} Z2\nG70 P10 Q20 F0.1\nG00 X150 Z150\nM30\n"
        )
    };
    check(&program("X40"), &[]);
    check(&program("X34"), &["finish-starts-elsewhere"]);
}
