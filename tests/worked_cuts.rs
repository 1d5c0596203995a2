//! Cuts calculated by hand: which of them remove nothing, are too deep or leave the blank, and which look
//! unusual but are right.
use gcode_playground::message::Severity;
use gcode_playground::run::Run;
use gcode_playground::setup::Setup;

const HEAD: &str = "O0001 (STOCK D=60 LENGTH=100)\nT0101\nG97 S800 M03\n";

/// Checks the messages of blocks in a bar of 60 mm, with spindle and tool ready: slug and line, counted
/// from 1. Notes have a question mark.
#[track_caller]
fn says(blocks: &str, expected: &[&str]) {
    says_of(HEAD, blocks, expected);
}

#[track_caller]
fn says_of(head: &str, blocks: &str, expected: &[&str]) {
    let text = format!("{head}{blocks}\nG00 X200 Z200\nM30\n");
    let mut run = Run::new(text.as_bytes().to_vec(), Setup::default());
    while !run.advance(usize::MAX) {}
    let mut analysis = run.into_analysis();
    analysis.check_at_machine();
    let told = analysis.diagnostics.iter().map(|told| {
        let line = text[..told.span.start as usize].matches('\n').count() - head.matches('\n').count() + 1;
        let note = if told.severity == Severity::Info { "?" } else { "" };
        format!("{}{note} {line}", told.message.slug())
    });
    assert_eq!(told.collect::<Vec<_>>(), expected, "{blocks}");
}

const CONTOUR: &str = "N10 G00 X40\nG01 Z-20\nX50 Z-30\nN20 X62";

#[test]
fn a_cycle_takes_something_off() {
    says("G00 X62 Z2\nG90 X56 Z-30 F0.2\nX52", &[]);
    says("G00 X68 Z2\nG90 X66 Z-30 F0.2\nX62", &["cycle-cuts-air 2"]);
    // The first pass cuts nothing, the second does: the work may be a casting.
    says("G00 X68 Z2\nG90 X62 Z-30 F0.2\nX58", &[]);
    // A pass at the bar diameter, and one that repeats the last pass: they clean and finish.
    says("G00 X62 Z2\nG90 X60 Z-30 F0.2", &[]);
    says("G00 X62 Z2\nG90 X56 Z-30 F0.2\nG00 X62 Z1.5\nG90 X56 Z-30 F0.1", &[]);
    // The whole contour is outside of the bar.
    says(
        "G00 X72 Z2\nG71 U2 R0.5\nG71 P10 Q20 U0.4 W0.1 F0.2\nN10 G00 X62\nG01 Z-20\nN20 X70 Z-30",
        &["cycle-cuts-air 3"],
    );
    says(&format!("G00 X62 Z2\nG71 U2 R0.5\nG71 P10 Q20 U0.4 W0.1 F0.2\n{CONTOUR}\nG70 P10 Q20 F0.1"), &[]);
    // A groove in front of the face: the minus of Z is missing.
    let groove = "O0001 (STOCK D=60 LENGTH=100)\nT0303 (GROOVING 3MM)\nG97 S800 M03\n";
    says_of(groove, "G00 X62 Z20\nG75 R0.5\nG75 X50 P2000 F0.08", &["cycle-cuts-air 3"]);
    says_of(groove, "G00 X62 Z-20\nG75 R0.5\nG75 X50 P2000 F0.08", &[]);
}

/// Plain moves of a tool that stay in the air: a digit too many, or a lost minus.
#[test]
fn a_tool_takes_something_off() {
    says("G00 X62 Z2\nX560\nG01 Z-30 F0.2\nX562", &["tool-cuts-air 3"]);
    says("G00 X56 Z2\nG01 Z-30 F0.2\nX62", &[]);
    // A pass at the bar diameter, and a cut that repeats the last one.
    says("G00 X60 Z2\nG01 Z-30 F0.2\nX62", &[]);
    says("G00 X56 Z2\nG01 Z-30 F0.2\nX62\nG00 X200 Z200\nT0101\nG00 X56 Z2\nG01 Z-30 F0.1\nX62", &[]);
    // A sawn bar may be longer than stated.
    says("G00 X62 Z3\nG01 X-1 F0.2\nG00 Z5", &[]);
    // The second tool cuts nothing; the first one does.
    says(
        "G00 X56 Z2\nG01 Z-30 F0.2\nX62\nG00 X200 Z200\nT0202\nG00 X540 Z2\nG01 Z-30 F0.1\nX542",
        &["tool-cuts-air 7"],
    );
}

/// A pass within an earlier one removes nothing; a repeated last pass is a spring pass (seed 000, O0002).
#[test]
fn a_pass_within_an_earlier_one_is_found() {
    says("G00 X62 Z2\nG90 X56 Z-30 F0.2\nX52\nX52\nX48", &["pass-not-deeper 4"]);
    says("G00 X62 Z2\nG90 X56 Z-30 F0.2\nX52\nX52", &[]);
    says("G00 X62 Z2\nG90 X56 Z-30 F0.2\nX52\nX52 Z-20\nX48 Z-30", &["pass-not-deeper 4"]);
    // Further along, or deeper at one end, it removes material.
    says("G00 X62 Z2\nG90 X56 Z-20 F0.2\nX52\nX52 Z-30\nX48", &[]);
    // From Z0, radius 27.6 at the start and 29.6 at Z-32; then 28.1, and 29.6 at Z-26, where the cone has 29.225.
    says("G00 X62 Z0\nG90 X59.2 Z-32 R-2 F0.2\nZ-26 R-1.5", &["pass-not-deeper 3"]);
    says("G00 X62 Z0\nG90 X59.2 Z-26 R-1.5 F0.2\nZ-32 R-2", &[]);
    says("G00 X62 Z2\nG94 X20 Z-2 F0.1\nZ-4\nZ-4\nZ-6", &["pass-not-deeper 4"]);
}

/// The cone of a face ends at the face, but the distance to its start point still counts (seed 004).
#[test]
fn a_taper_starts_near_the_work() {
    says("G00 X64 Z14\nG94 X40 Z0 R-12 F0.1", &["start-far-from-work? 2"]);
    says("G00 X64 Z2\nG94 X40 Z0 R-12 F0.1", &[]);
    // Passes that approach with the same R: the start is in front of the first one.
    says("G00 X64 Z14\nG94 X40 Z10 R-12 F0.1\nZ5\nZ0", &[]);
}

#[test]
fn a_rapid_through_the_work_is_found_with_tools_that_are_narrow() {
    // The tool is unnamed, and the material left before Z-20 allows only a very slim tool.
    let shaft =
        "G00 X62 Z2\nG90 X36.4 Z-39.9 F0.2\nX32.4 Z-19.9\nX28.4\nG00 X20 Z2\nG00 Z-20\nX36\nG01 Z-40\nX66";
    says(shaft, &["cut-too-deep 2", "rapid-through-stock 6"]);
    says(&shaft.replace("G00 Z-20", "G01 Z-20"), &["cut-too-deep 2"]);
    // A plunge of a narrow insert without its G01, which continues at rapid beside the groove.
    let groove = "G00 X62 Z-20\nG01 X40 F0.05\nG00 X62\nG00 Z-30\nG01 X40\nG00 Z-25\nX62";
    let head = "O0001 (STOCK D=60 LENGTH=100)\nT0303\nG97 S800 M03\n";
    says_of(head, groove, &["rapid-through-stock 6", "rapid-through-stock 7"]);
}

#[test]
fn a_groove_is_cut_once() {
    let head = "O0001 (STOCK D=60 LENGTH=100)\nT0303 (GROOVING 3MM)\nG97 S800 M03\n";
    let says = |blocks: &str, expected: &[&str]| says_of(head, blocks, expected);
    let groove = "G00 X62 Z-20\nG75 R0.5\nG75 X50 P2000 F0.08";
    says(&format!("{groove}\nG75 X50 P2000 F0.08"), &["cycle-cuts-air 4"]);
    // Once more to the turned diameter: it cleans the corner.
    says("G00 X62 Z-20\nG75 R0.5\nG75 X60 P2000 F0.08", &[]);
    // Deeper, and beside it.
    says(&format!("{groove}\nG75 X48 P2000 F0.08"), &[]);
    says(&format!("{groove}\nG00 Z-22\nG75 R0.5\nG75 X50 P2000 F0.08"), &[]);
    // The second round of a loop is for the next part of the bar.
    says(&format!("#1=0\nWHILE[#1LT2]DO1\n{groove}\n#1=#1+1\nEND1"), &[]);
}

#[test]
fn a_tool_leaves_a_groove_the_way_it_came() {
    let head = "O0001 (STOCK D=60 LENGTH=100)\nT0303 (GROOVING 3MM)\nG97 S800 M03\n";
    let groove = "G00 X62 Z-20\nG01 X50 F0.08";
    says_of(head, &format!("{groove}\nG00 Z5"), &["rapid-through-stock 3"]);
    says_of(head, &format!("{groove}\nG00 X62\nZ5"), &[]);
    // Pecks along Z begin in front of the work.
    let pecks = "G74 R0.5\nG74 X34 Z-10 P2000 Q3000 F0.08";
    says_of(head, &format!("G00 X40 Z2\n{pecks}"), &[]);
}

#[test]
fn an_insert_and_a_drill_bear_no_more_than_a_millimetre_of_feed() {
    // At the block with the feed, although that block only approaches the work.
    says("G00 X62 Z2\nG01 X56 F1\nZ-30\nX62", &["feed-per-turn-high 2"]);
    says("G00 X62 Z2\nG01 X56 F0.9\nZ-30\nX62", &[]);
    let drill = "O0001 (STOCK D=60 LENGTH=100)\n(TOOL T0202 TYPE=DRILL D=10)\nT0202\nG97 S800 M03\n";
    says_of(drill, "G00 X0 Z5\nG74 R1\nG74 Z-30 Q8000 F1", &["feed-per-turn-high 3"]);
    says_of(drill, "G00 X0 Z5\nG74 R1\nG74 Z-30 Q8000 F0.1", &[]);
    // A tap on the axis feeds by its pitch.
    says_of(drill, "G00 X0 Z5\nG84 Z-20 F1.5", &[]);
}

#[test]
fn the_infeed_of_a_contour_cycle_is_no_whole_blank() {
    let of = |infeed: &str| {
        format!("G00 X62 Z2\nG71 {infeed} R0.5\nG71 P10 Q20 U0.4 W0.1 F0.2\nN10 G00 X52\nG01 Z-20\nN20 X62")
    };
    // All material is removed in one pass of 4 mm; with a larger bar it would be 20 mm.
    says(&of("U20"), &["cut-too-deep 3"]);
    says(&of("U4"), &[]);
}

#[test]
fn facing_in_front_of_a_sawn_bar_is_right() {
    says("G00 X62 Z3\nG94 X-1 Z2 F0.2\nZ1\nZ0.2", &[]);
    says("G00 X62 Z22\nG94 X-1 Z20 F0.2\nZ18", &["cycle-cuts-air 2"]);
}

#[test]
fn the_same_blocks_may_cut_the_next_part_of_a_bar() {
    // The second round of a loop starts with the material that the first one left.
    says("#1=0\nWHILE[#1LT2]DO1\nG00 X62 Z2\nG90 X56 Z-30 F0.2\n#1=#1+1\nEND1", &[]);
    // After M00 the work may have been turned around.
    says("G00 X62 Z2\nG90 X56 Z-30 F0.2\nG00 X100 Z50\nM00\nM03\nG00 X68 Z2\nG90 X64 Z-30 F0.2", &[]);
}

#[test]
fn a_pass_is_no_deeper_than_an_insert_bears() {
    // 60 / 2 / 4 = 7.5 mm on the radius.
    says("G00 X62 Z2\nG90 X56 Z-30 F0.2\nX42", &[]);
    says("G00 X62 Z2\nG90 X56 Z-30 F0.2\nX40", &["cut-too-deep 3"]);
    // The next passes are not reported as too deep as well.
    says("G00 X62 Z2\nG90 X56 Z-30 F0.2\nX5.2\nX48\nX44", &["cut-too-deep 3"]);
    says("G00 X62 Z2\nG94 X20 Z-2 F0.2\nZ-10", &["cut-too-deep 3"]);
    // The first pass of G90, and single moves, relative to the work: from X60 to X44 are 8 mm.
    says("G00 X62 Z2\nG90 X44 Z-30 F0.2", &["cut-too-deep 2"]);
    says("G00 X44 Z2\nG01 Z-30 F0.2\nX62", &["cut-too-deep 2"]);
    says("G00 X46 Z2\nG01 Z-30 F0.2\nX62", &[]);
    // Where the bar is already turned, little is removed.
    says("G00 X62 Z2\nG90 X54 Z-30 F0.2\nX48\nX42\nG00 X40 Z2\nG01 Z-29 F0.1\nX62", &[]);
    says(&format!("G00 X62 Z2\nG71 U10 R0.5\nG71 P10 Q20 U0.4 W0.1 F0.2\n{CONTOUR}"), &["cut-too-deep 3"]);
}

#[test]
fn a_cut_ends_with_the_blank() {
    says("G00 X62 Z2\nG90 X56 Z-104 F0.2", &[]);
    says("G00 X62 Z2\nG90 X56 Z-110 F0.2", &["cut-beyond-blank 2"]);
    // Z with an extra digit is the fault, not the taper height that does not match it.
    says("G00 X72 Z2\nG90 X58 Z-300 R-1 F0.2", &["cut-beyond-blank 2"]);
    // Outside of the work, and with a drill, because of its point.
    says("G00 X62 Z2\nG01 Z-110 F0.2\nG00 X70", &["tool-cuts-air 2"]);
    let drill = "O0001 (STOCK D=60 LENGTH=100)\n(TOOL T0202 TYPE=DRILL D=10)\nT0202\nG97 S800 M03\n";
    says_of(drill, "G00 X0 Z5\nG01 Z-110 F0.1\nG00 Z5", &[]);
}

#[test]
fn a_contour_is_roughed_once() {
    let first = format!("G00 X62 Z2\nG71 U2 R0.5\nG71 P10 Q20 U0.4 W0.1 F0.2\n{CONTOUR}\n");
    let says = |more: &str, expected: &[&str]| says(&format!("{first}{more}"), expected);
    says("G71 P10 Q20 U0.4 W0.1 F0.2", &["contour-roughed-twice 8"]);
    says("G70 P10 Q20 F0.1", &[]);
    // With another allowance, and repeated after finishing.
    says("G71 P10 Q20 U0.2 W0.05 F0.2\nG70 P10 Q20 F0.1", &[]);
}

#[test]
fn the_depth_of_a_thread_fits_its_lead() {
    let head = "O0001 (STOCK D=30 LENGTH=80)\nT0303 (THREAD)\nG97 S300 M03\n";
    let says = |blocks: &str, expected: &[&str]| says_of(head, blocks, expected);
    // 30 to 28.04: 0.98 mm of 1.5 mm.
    says("G00 X34 Z8\nG92 X29.2 Z-20 F1.5\nX28.6\nX28.2\nX28.04", &[]);
    // 30 to 26.8: 1.6 mm.
    says("G00 X34 Z8\nG92 X29.2 Z-20 F1.5\nX28.4\nX27.6\nX26.8", &["thread-depth-unusual 5"]);
    // 30 to 29.2: 0.4 mm, in three passes.
    says("G00 X34 Z8\nG92 X29.6 Z-20 F1.5\nX29.4\nX29.2", &["thread-depth-unusual 4"]);
    // Two passes are not a complete thread, and with two starts the pitch is half the lead.
    says("G00 X34 Z8\nG92 X29.6 Z-20 F1.5\nX29.4", &[]);
    says("G00 X34 Z8\nG92 X29.4 Z-20 F1.5\nX29.4 Q180000\nX29 Q0\nX29 Q180000\nX28.8 Q0\nX28.8 Q180000", &[]);
    // Turned down before: the thread begins at 26 mm.
    says(
        "T0101\nG00 X32 Z2\nG90 X28 Z-30 F0.2\nX26\nG00 X100 Z50\nT0303\nG00 X30 Z8\nG92 X25.2 Z-20 F1.5\nX24.6\nX24.2\nX24.04",
        &[],
    );
}

#[test]
fn a_thread_ends_before_a_shoulder() {
    // A bar of 40 mm, turned to 30 mm up to Z-30.
    let head = "O0001 (STOCK D=40 LENGTH=80)\nT0101\nG97 S600 M03\nG00 X42 Z2\nG90 X35 Z-30 F0.2\nX30\nG00 X100 Z50\nT0303 (THREAD)\n";
    let says = |blocks: &str, expected: &[&str]| says_of(head, blocks, expected);
    // δ2 = 600 · 1.5 / 1800 = 0.5 mm.
    let thread = |end: &str| format!("G00 X44 Z8\nG92 X29.2 Z-{end} F1.5\nX28.6\nX28.2\nX28.04");
    says(&thread("29.4"), &[]);
    says(&thread("29.6"), &["thread-run-out-short? 2"]);
    says(&thread("30"), &["thread-run-out-short? 2"]);
    says(
        "G00 X44 Z8\nG76 P010060 Q100 R0.05\nG76 X28.04 Z-29.7 P980 Q300 F1.5",
        &["thread-run-out-short? 3"],
    );
    // At half the speed, half the run-out is needed.
    says(&format!("S300\n{}", thread("29.6")), &[]);
    // Without a shoulder the thread ends on the cylinder.
    says("G00 X44 Z8\nG92 X29.2 Z-20 F1.5\nX28.6\nX28.2\nX28.04", &[]);
}
