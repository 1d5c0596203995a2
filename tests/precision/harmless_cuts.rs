//! Cuts, speeds and program ends that look like mistakes but are right, and must not cause a warning. Each is
//! paired with a similar mistake that is reported.

use gcode_playground::analyze;
use gcode_playground::setup::Setup;

/// How often a program triggers a rule, including notes and machine checks.
fn times(setup: &str, text: &str, slug: &str) -> usize {
    let mut analysis = analyze(text.as_bytes(), &Setup::from_json(setup).expect("setup"));
    analysis.check_at_machine();
    analysis.diagnostics.iter().filter(|told| told.message.slug() == slug).count()
}

#[track_caller]
fn is_silent(slug: &str, text: &str) {
    assert_eq!(times("{}", text, slug), 0, "{slug}\n{text}");
}

#[track_caller]
fn is_told(slug: &str, text: &str) {
    assert_eq!(times("{}", text, slug), 1, "{slug}\n{text}");
}

/// Roughs a contour, and again after some blocks.
fn roughed_again(between: &str) -> String {
    let cycle = "G00 X52 Z2\nG71 U2 R0.5\nG71 P10 Q20 U0.4 W0.1 F0.2\n";
    format!(
        "O0001 (STOCK D=50 LENGTH=90)\nT0101\nG97 G99 S800 M03\n{cycle}N10 G00 X30\nG01 Z-20\nN20 X52\n\
         G00 X200 Z200\n{between}{cycle}G00 X200 Z200\nM30\n"
    )
}

#[test]
fn the_next_part_is_roughed_like_the_one_before() {
    let bar_stop = "M05\nT1212 (BAR STOP)\nG00 X0 Z0.2\nM11\nG04 U1.\nM10\nG00 Z50\nT0101\nM03\n";
    for between in ["M05\nM00\nM03 S800\n", "M01 (TURN ROUND)\nT0101\n", bar_stop] {
        is_silent("contour-roughed-twice", &roughed_again(between));
        is_silent("cycle-cuts-air", &roughed_again(between));
    }
    is_told("contour-roughed-twice", &roughed_again(""));
    is_told("contour-roughed-twice", &roughed_again("M05\nM03\n"));
}

/// Three tools retract to X200 Z150; a fourth goes elsewhere, followed by more blocks.
fn away(last: &str) -> String {
    let cut = |tool: u32, x: u32| format!("T0{tool}0{tool}\nG00 X52 Z2\nG01 X{x} F0.2\nZ-20\nX54\n");
    let three: String =
        [(1, 48), (2, 46), (3, 44)].map(|(tool, x)| cut(tool, x) + "G00 X200 Z150\n").concat();
    format!("O0001 (STOCK D=50 LENGTH=80)\nG97 G99 S800 M03\n{three}{}{last}", cut(4, 42))
}

#[test]
fn each_tool_may_leave_to_a_place_of_its_own() {
    for end in
        ["G00 X150 Z200 (LONG TOOL)\nM30\n", "G00 X150 Z200\nT0101\nM30\n", "G00 X150 Z200 M09\nM05\nM30\n"]
    {
        is_silent("axes-exchanged", &away(end));
    }
    is_told("axes-exchanged", &away("G00 X150 Z200\nG01 X40 Z1 F0.2\nZ-5\nG00 X200 Z150\nM30\n"));
}

#[test]
fn speeds_are_as_high_and_as_low_as_lathes_have_them() {
    let turned = |stock: &str, speed: &str| {
        format!(
            "O0001 ({stock})\nG50 S20000\n{speed} G99 M03\nT0101\nG00 X12 Z0\nG01 X-0.5 F0.01\nG00 X50 Z50\nM30\n"
        )
    };
    let slug = "speed-unusual";
    is_silent(slug, &turned("STOCK D=10 LENGTH=30", "G97 S15000"));
    is_silent(slug, &turned("ROLL", "G96 S7"));
    is_told(slug, &turned("STOCK D=10 LENGTH=30", "G97 S24000"));
    is_told(slug, &turned("STOCK D=50 LENGTH=30", "G97 S15000"));
    is_told(slug, &turned("ROLL", "G96 S4"));
    let machine = r#"{"machine": {"maxSpeed": 20000}}"#;
    assert_eq!(times(machine, &turned("STOCK D=50 LENGTH=30", "G97 S15000"), slug), 0);
}

#[test]
fn a_section_after_the_end_is_started_by_a_search() {
    let head = "O0001 (STOCK D=50 LENGTH=80)\nT0101\nG97 G99 S800 M03\nG00 X46 Z2\nG01 Z-20 F0.2\nX52\nG00 X200 Z200\n";
    let finish = "T0202\nG97 G99 S800 M03\nG00 X45.5 Z2\nG01 Z-20 F0.1\nX52\nG00 X200 Z200\n";
    let slug = "blocks-after-end";
    is_silent(slug, &format!("{head}M30\nN2 (FINISH ONLY)\n{finish}M30\n"));
    is_silent(slug, &format!("{head}M99\nN900 (RETRACT: RESTART HERE)\nG28 U0\nG28 W0\nM30\n"));
    // No sequence number to search for, no separate end, and numbers at every block.
    is_told(slug, &format!("{head}M30\n{finish}M30\n"));
    is_told(slug, &format!("{head}M30\nN2\n{finish}"));
    is_told(slug, &format!("{head}M30\nN80 G00 X44 Z2\nN90 G01 Z-20\nN100 M30\n"));
}

#[test]
fn tools_do_more_than_their_name_says() {
    let slug = "tool-for-other-work";
    let thread = |lead: &str| {
        format!(
            "O0001 (STOCK D=60 LENGTH=200)\n(TOOL T0505 TYPE=GROOVING WIDTH=3)\nT0505\nG97 S80 M03\nG00 X66 Z18\n\
             G92 X59.6 Z-120 F{lead}\nX59.2\nG00 X200 Z200\nM30\n"
        )
    };
    is_silent(slug, &thread("6"));
    is_told(slug, &thread("2"));
    let groove = |lead: &str| {
        format!(
            "O0001 (STOCK D=50 BORE=30 LENGTH=60)\n(TOOL T0707 TYPE=BORING)\nT0707\nG97 S50 M03\nG00 X28 Z5\nX30.6\n\
             G32 Z-45 F{lead}\nG00 X28\nZ200\nM30\n"
        )
    };
    is_silent(slug, &groove("40"));
    is_told(slug, &groove("2"));
    let drill = |start: &str, passes: &str| {
        format!(
            "O0001 (STOCK D=40 LENGTH=60)\n(TOOL T0202 TYPE=DRILL D=16)\nT0202\nG97 G99 S1500 M03\nG00 X0 Z2\n\
             G01 Z-20 F0.08\nG00 Z2\n{start}\n{passes}\nG00 X200 Z200\nM30\n"
        )
    };
    is_silent(slug, &drill("X15", "G90 X18 Z-15 F0.1\nX20\nX22"));
    is_told(slug, &drill("X42", "G90 X38 Z-15 F0.1\nX36"));
    // Deeper than the drilled hole.
    is_told(slug, &drill("X15", "G90 X18 Z-30 F0.1"));
}

/// Starts the spindle while the C axis is connected.
fn started_with_c(blocks: &str) -> String {
    format!(
        "O0001 (STOCK D=50 LENGTH=80)\nM45\nG28 H0\nT0505\nG98 G97 S1500 M13\nG00 X60 Z-20 C90\nG01 X44 F100\nG00 X60\n\
         M15\n{blocks}\nM30\n"
    )
}

#[test]
fn another_spindle_may_start_while_c_is_connected() {
    let slug = "c-axis-still-connected";
    let drilled = "G00 X60 Z-30 C0\nG01 X44 F100\nG00 X60";
    is_silent(slug, &started_with_c(&format!("T0606\nS2000 M03 P2\n{drilled}\nM05 P2\nM46")));
    is_silent(slug, &started_with_c(&format!("T0606\nS2000 M03\n{drilled}\nM05\nM46")));
    is_told(slug, &started_with_c("G97 S800 M3\nT0101"));
    is_told(slug, &started_with_c("G97 S800 M03\nT0101\nM46\nG00 X60 C0"));
    // A comment does not select a spindle.
    is_told(slug, &started_with_c("G97 S800 M03 (P2)\nT0101"));
}

#[test]
fn long_dwells_cool_down_and_warm_up() {
    let slug = "dwell-unusual";
    let cut = "T0303\nG97 G99 S500 M03\nG00 X54. Z-20.\nG01 X44. F0.08\n";
    let end = "G01 X54. F0.3\nG00 X200. Z200.\n";
    is_silent(slug, &format!("O0001 (STOCK D=50 LENGTH=80)\n{cut}{end}M05\nG04 X120\nM30\n"));
    is_silent(slug, "O0001 (WARM UP)\nG97 S500 M03\nG04 X300\nS1000\nG04 U600\nM05\nM30\n");
    is_told(slug, &format!("O0001 (STOCK D=50 LENGTH=80)\n{cut}G04 X120\n{end}M30\n"));
}

#[test]
fn a_second_offset_is_ten_or_twenty_higher() {
    let program = |tools: [&str; 4]| {
        let cuts = tools.map(|tool| format!("{tool}\nG00 X46 Z2\nG01 Z-10 F0.2\nG00 X100 Z100\n"));
        format!("O0001 (STOCK D=50 LENGTH=80)\nG97 G99 S800 M03\n{}M30\n", cuts.concat())
    };
    let slug = "tool-offset-differs";
    for tools in [
        ["T0111", "T0202", "T0303", "T0404"],
        ["T0101", "T0202", "T0313", "T0404"],
        ["T0101", "T0202", "T0303", "T0424"],
    ] {
        is_silent(slug, &program(tools));
    }
    is_told(slug, &program(["T0101", "T0202", "T0303", "T0405"]));
    // Station 11 is called.
    is_told(slug, &program(["T0111", "T0202", "T0303", "T1111"]).replace("M30", "T0404\nM30"));
}

#[test]
fn what_comes_from_outside_may_not_enter_a_loop() {
    let slug = "loop-not-entered";
    let cut = "T0101\nG97 G99 S800 M03\nG00 X46 Z2\nG01 Z-20 F0.2\nX52\nG00 X200 Z200\n";
    is_silent(slug, &format!("O0001 (STOCK D=50 LENGTH=80)\nWHILE [#1000 EQ 1] DO1\nEND1\n{cut}M30\n"));
    let called = |condition: &str| {
        format!(
            "O0001 (STOCK D=50 LENGTH=80)\n#100=0\nG65 P9473 A48 B46 C2\n{cut}M30\nO9473\nWHILE [{condition}] DO1\n\
             #1=#1-#3\nEND1\nM99\n"
        )
    };
    is_silent(slug, &called("#1 GT [#2+#3]"));
    is_told(slug, &called("#100 GT 5"));
}

#[test]
fn a_thin_bar_is_turned_in_one_pass_with_a_fine_feed() {
    let slug = "cut-too-deep";
    let turned = |feed: &str| {
        format!(
            "O0001 (STOCK D=16 LENGTH=40)\nT0101\nG97 G99 S4000 M03\nG00 X18 Z1\nG00 X3\nG01 Z-25 F{feed}\nX18\n\
             G00 X50 Z50\nM30\n"
        )
    };
    is_silent(slug, &turned("0.03"));
    is_told(slug, &turned("0.15"));
    let passes = |feed: &str| {
        format!(
            "O0001 (STOCK D=60 LENGTH=100)\nT0101\nG97 G99 S800 M03\nG00 X62 Z2\nG90 X56 Z-30 F{feed}\nX40\n\
             G00 X200 Z200\nM30\n"
        )
    };
    is_silent(slug, &passes("0.04"));
    is_told(slug, &passes("0.2"));
}

#[test]
fn a_tool_leaves_its_groove_or_shoulder_fast() {
    let slug = "feed-per-turn-high";
    let grooved = |blocks: &str| {
        format!(
            "O0001 (STOCK D=60 LENGTH=80)\n(TOOL T0303 TYPE=GROOVING WIDTH=4)\nT0303\nG97 G99 S600 M03\nG00 X64 Z-20\n\
             {blocks}\nG00 X200 Z200\nM30\n"
        )
    };
    is_silent(slug, &grooved("G01 X44 F0.08\nG04 U0.3\nG01 X62 F1.5"));
    is_silent(slug, &grooved("G01 X44 F0.08\nX64 F1.1\nG00 Z-23\nG01 X44 F0.08\nX64 F1.1"));
    is_told(slug, &grooved("G01 X44 F1.5\nX64"));
    let turned = |blocks: &str| {
        format!(
            "O0001 (STOCK D=60 LENGTH=80)\n(TOOL T0101 TYPE=TURNING INSERT=CNMG120408 KR=95)\nT0101\nG97 G99 S600 M03\n\
             G00 X55 Z2\n{blocks}\nG00 X200 Z200\nM30\n"
        )
    };
    is_silent(slug, &turned("G01 Z-30 F0.25\nX62 F1.5\nG00 Z2\nX50\nG98 G01 Z-30 F150\nX57 F1000"));
    is_told(slug, &turned("G01 Z-30 F1.5\nX62"));
    // The cut is facing.
    is_told(slug, &turned("G01 Z-1 F0.25\nX-1 F1.5\nZ2"));
}

#[test]
fn a_tool_in_a_bore_runs_out_behind_it() {
    let slug = "cut-beyond-blank";
    let bored = |z: &str| {
        format!(
            "O0001 (STOCK D=60 BORE=30 LENGTH=40)\n(TOOL T0404 TYPE=BORING)\nT0404\nG97 G99 S600 M03\nG00 X34 Z2\n\
             G01 Z{z} F0.15\nU-0.5\nG00 Z5\nG00 X200 Z200\nM30\n"
        )
    };
    is_silent(slug, &bored("-46"));
    is_told(slug, &bored("-60"));
    let thread = "O0001 (STOCK D=50 BORE=20 LENGTH=40)\n(TOOL T0505 TYPE=THREADING SIDE=INSIDE)\nT0505\nG97 G99 S300 M03\n\
                  G00 X18 Z10\nG92 X20.8 Z-46 F4\nX21.6\nX22.2\nG00 X200 Z200\nM30\n";
    is_silent(slug, thread);
    let turned = "O0001 (STOCK D=60 LENGTH=40)\nT0101\nG97 G99 S600 M03\nG00 X56 Z2\nG01 Z-46 F0.2\nX64\nG00 X200 Z200\nM30\n";
    is_told(slug, turned);
}
