//! Threads calculated by hand: which of their passes is at fault, and which look unusual but are right.
use gcode_playground::analyze;
use gcode_playground::message::Severity;
use gcode_playground::setup::Setup;

/// The messages of a thread that is cut with spindle and tool ready: slug and line of its passes, counted
/// from 1. Notes have a question mark.
fn said_of(passes: &str) -> Vec<String> {
    let head = "O0001 (STOCK D=30 LENGTH=80)\nT0303 (THREAD)\nG97 S300 M03\n";
    let text = format!("{head}{passes}\nG00 X100 Z100\nM30\n");
    let analysis = analyze(text.as_bytes(), &Setup::default());
    let told = analysis.diagnostics.iter().map(|told| {
        let line = text[..told.span.start as usize].matches('\n').count() - head.matches('\n').count() + 1;
        let note = if told.severity == Severity::Info { "?" } else { "" };
        format!("{}{note} {line}", told.message.slug())
    });
    told.collect()
}

#[track_caller]
fn says(passes: &str, expected: &[&str]) {
    assert_eq!(said_of(passes), expected, "{passes}");
}

const RIGHT: &str = "G00 X34 Z8\nG92 X29.2 Z-20 F1.5\nX28.6\nX28.2\nX28.04";

#[test]
fn a_thread_of_ever_deeper_passes_is_right() {
    says(RIGHT, &[]);
    // As single moves, each from its own diameter.
    says(
        "G00 X34 Z8\nX29.2\nG32 Z-20 F1.5\nG00 X34\nZ8\nX28.6\nG32 Z-20\nG00 X34\nZ8\nX28.2\nG32 Z-20\nG00 X34",
        &[],
    );
    // A bore: deeper is a larger diameter.
    says("G00 X20 Z8\nG92 X22.4 Z-20 F1.5\nX23\nX23.4", &[]);
    // A taper, and an infeed along the flank.
    says("G00 X34 Z8\nG92 X29.2 Z-20 R-1 F1.5\nX28.6\nX28.2", &[]);
    says("G00 X34 Z8\nG92 X29.2 Z-20 F1.5\nG00 Z7.8\nG92 X28.4 Z-20", &[]);
}

#[test]
fn the_lead_of_a_pass_is_that_of_the_passes_before() {
    says(&RIGHT.replace("X28.6", "X28.6 F1"), &["thread-lead-changed 3"]);
    says(&RIGHT.replace("X28.2", "X28.2 F15"), &["thread-lead-changed 4"]);
    // The repeated word gives the same lead, in inches too.
    says(&RIGHT.replace("X28.2", "X28.2 F1.50"), &[]);
    // Another thread: it ends elsewhere, or is much smaller.
    says(&format!("{RIGHT}\nG00 Z-25\nG92 X27.2 Z-40 F1\nX26.8"), &[]);
    says(&format!("{RIGHT}\nG00 X22\nG92 X19.2 Z-20 F1\nX18.8"), &[]);
}

#[test]
fn a_pass_is_deeper_than_the_one_before_it_from_the_same_start() {
    says(&RIGHT.replace("X28.2", "X28.9"), &["thread-pass-not-deeper 4"]);
    // Two passes swapped: the second of them removes nothing.
    says("G00 X34 Z8\nG92 X29.2 Z-20 F1.5\nX28.2\nX28.6\nX28.04", &["thread-pass-not-deeper 4"]);
    says("G00 X20 Z8\nG92 X22.4 Z-20 F1.5\nX23\nX22.8\nX23.4", &["thread-pass-not-deeper 4"]);
    // With single moves, the first two passes show the direction of the depth.
    says(
        "G00 X34 Z8\nX29.2\nG32 Z-20 F1.5\nG00 X34\nZ8\nX28.6\nG32 Z-20\nG00 X34\nZ8\nX28.9\nG32 Z-20\nG00 X34",
        &["thread-pass-not-deeper 11"],
    );
    // Spring passes at the end are usual. A repeated pass is a note if a deeper one follows.
    says(&format!("{RIGHT}\nX28.04"), &[]);
    says(&format!("{RIGHT}\nX28.04\nX28.04"), &[]);
    says(&RIGHT.replace("X28.6", "X28.6\nX28.6"), &["thread-pass-not-deeper? 5"]);
    says(&RIGHT.replace("X28.6", "X28.6\nX28.6\nX28.6"), &["thread-pass-not-deeper? 6"]);
    // The same thread again, for the next part of the bar.
    says(&format!("{RIGHT}\nG92 X29.2 Z-20\nX28.6\nX28.2\nX28.04"), &[]);
}

#[test]
fn several_starts_are_each_a_thread_of_their_own() {
    // Each depth from both starts, by their positions and by angles.
    says(
        "G00 X34 Z9\nG92 X29.2 Z-20 F3\nG00 Z10.5\nG92 X29.2 Z-20\nG00 Z9\nG92 X28.6 Z-20\nG00 Z10.5\nG92 X28.6 Z-20",
        &[],
    );
    says("G00 X34 Z9\nG92 X29.2 Z-20 F3\nX29.2 Q180000\nX28.6 Q0\nX28.6 Q180000", &[]);
    // All passes of one start, then all of the other.
    says("G00 X34 Z9\nG92 X29.2 Z-20 F3\nX28.6\nX28.2\nG00 Z10.5\nG92 X29.2 Z-20\nX28.6\nX28.2", &[]);
    // Half a lead beside the earlier passes, and deeper: it removes their crests. So do a shift by a third of
    // the lead, and a last pass as deep as the one before.
    says("G00 X34 Z9\nG92 X29.2 Z-20 F3\nX28.6\nG00 Z10.5\nG92 X28.2 Z-20", &["thread-start-moved 5"]);
    says("G00 X34 Z9\nG92 X29.2 Z-20 F3\nX28.6\nG00 Z10\nG92 X28.2 Z-20", &["thread-start-moved 5"]);
    says("G00 X34 Z9\nG92 X29.2 Z-20 F3\nX28.6\nG00 Z10.5\nG92 X28.6 Z-20", &["thread-start-moved 5"]);
    // A small shift to both sides: the groove only gets wider.
    says("G00 X34 Z9\nG92 X29.2 Z-20 F3\nX28.6\nG00 Z9.5\nG92 X28.6 Z-20\nG00 Z8.5\nG92 X28.6 Z-20", &[]);
    // Three starts need a third of the lead.
    says(
        "G00 X34 Z9\nG92 X29.2 Z-20 F3\nG00 Z10\nG92 X29.2 Z-20\nG00 Z11\nG92 X29.2 Z-20\nG00 Z9\nG92 X28.6 Z-20",
        &[],
    );
    // Degrees instead of thousandths of a degree.
    says("G00 X34 Z9\nG92 X29.2 Z-20 F3\nX29.2 Q180\nX28.6", &["thread-angle-small 3"]);
    says("G00 X34 Z9\nX29.2\nG32 Z-20 F3 Q90", &["thread-angle-small 3"]);
}

#[test]
fn a_lead_is_one_that_controls_take_and_standards_have() {
    says(&RIGHT.replace("F1.5", "F600"), &["lead-out-of-range 2"]);
    says(&RIGHT.replace("F1.5", "F0.0001"), &["lead-out-of-range 2"]);
    says(&RIGHT.replace("F1.5", "F0.15"), &["thread-very-fine 2"]);
    // E gives a lead, as F does.
    says(&RIGHT.replace("F1.5", "E600"), &["lead-out-of-range 2"]);
    says(&RIGHT.replace("F1.5", "E0.15"), &["thread-very-fine 2"]);
    says(&RIGHT.replace("F1.5", "E1.5").replace("X28.6", "X28.6 E1"), &["thread-lead-changed 3"]);
    says("G00 X34 Z8\nG76 P011060 Q50 R0.05\nG76 X28.04 Z-20 P980 Q300 F600", &["lead-out-of-range 3"]);
    says("G00 X4 Z8\nG92 X0.9 Z-3 F0.2\nX0.8", &[]);
}

#[test]
fn a_lead_in_threads_per_inch_has_its_own_range() {
    let said = |word: &str| {
        let text = format!("O1\nT0303\nG97 S300 M03\nG00 X34 Z30\nX29\nG32 Z-20 {word}\nG00 X100\nM30\n");
        let setup = Setup::from_json(r#"{"dialect": {"control": "gsk"}}"#).expect("a setup");
        let told = analyze(text.as_bytes(), &setup).diagnostics;
        told.iter()
            .filter(|told| told.severity > Severity::Info)
            .map(|told| told.message.slug())
            .collect::<Vec<_>>()
    };
    assert!(said("I11").is_empty());
    assert_eq!(said("I26000"), ["lead-out-of-range"]);
    assert_eq!(said("I0.05"), ["lead-out-of-range"]);
}

#[test]
fn a_pass_goes_no_more_than_twice_as_much_deeper() {
    // 0.3 and 0.2 mm on the radius, then 0.7.
    says(&RIGHT.replace("X28.04", "X26.8"), &["thread-pass-jumps 5"]);
    // A pass that only scratches the work comes first; small steps may increase.
    says("G00 X34 Z8\nG92 X29.9 Z-20 F1.5\nX29.1\nX28.5\nX28.04", &[]);
    says("G00 X34 Z8\nG92 X29.2 Z-20 F1.5\nX29.1\nX28.5\nX28.04", &[]);
    // An excess is reported once.
    says("G00 X34 Z8\nG92 X29.2 Z-20 F1.5\nX29\nX28.2\nX27.4", &["thread-pass-jumps 4"]);
}

#[test]
fn a_pass_without_its_angle_cuts_the_first_start_again() {
    let starts =
        "G00 X34 Z12\nG92 X29.2 Z-20 F3 Q0\nX29.2 Q180000\nX28.6 Q0\nX28.6 Q180000\nX28.2 Q0\nX28.2 Q180000";
    says(starts, &[]);
    says(&starts.replace("X28.6 Q180000", "X28.6"), &["thread-angle-missing 5"]);
    // A start at 0° needs no Q, and a spring pass may be the last one.
    says(&starts.replace(" Q0", ""), &[]);
    says(&starts.replace(" Q0", "").replace("X28.6 Q180000", "X28.6"), &["thread-angle-missing 5"]);
    says("G00 X34 Z8\nG92 X29.2 Z-20 F1.5\nX28.6\nX28.6", &[]);
}

#[test]
fn the_speed_of_a_thread_follows_the_machine() {
    let said = |machine: &str| {
        let text = format!(
            "O1 (MACHINE {machine})\nT0303\nG97 S600 M03\nG00 X34 Z30\nG92 X29.2 Z-20 F2\nX28.4\nG00 X100\nM30\n"
        );
        let told = analyze(text.as_bytes(), &Setup::default()).diagnostics;
        told.iter()
            .map(|told| told.message.slug())
            .filter(|slug| *slug != "no-program-end")
            .collect::<Vec<_>>()
    };
    // The slide moves at 600 · 2 = 1200 mm/min.
    assert!(said("MAXSPEED=4000").is_empty());
    assert!(said("RAPIDZ=1200").is_empty());
    assert_eq!(said("RAPIDZ=1199"), ["thread-spindle-too-fast"]);
    // 1200 / 2 - 80 = 520, - 0 = 600, - 100 = 500.
    assert_eq!(said("THREADK=80"), ["thread-spindle-too-fast"]);
    assert!(said("THREADK=0").is_empty());
    assert_eq!(said("THREADK=100"), ["thread-spindle-too-fast"]);
}

/// G33 of GSK controls feeds in, reverses the spindle, and feeds out.
#[test]
fn the_tapping_cycle_of_gsk_turns_the_tap_out_itself() {
    let setup = Setup::from_json(r#"{"dialect": {"control": "gsk"}}"#).expect("a setup");
    let told = |program: &str| -> Vec<String> {
        let analysis = analyze(program.as_bytes(), &setup);
        analysis.diagnostics.iter().map(|told| told.message.slug().to_owned()).collect()
    };
    let head = "O0001 (STOCK D=40 BORE=8.5 LENGTH=60)\n(TOOL T0606 TYPE=TAP D=10)\nT0606\n";
    let right = format!("{head}G97 S300 M03\nG00 X0 Z6\nG33 Z-20 F1.5\nG00 X100 Z100\nM30\n");
    assert_eq!(told(&right), [""; 0]);
    assert_eq!(told(&right.replace("G97 S300", "G50 S1000\nG96 S30")), ["tap-at-surface-speed"]);
}
