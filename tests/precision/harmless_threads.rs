//! Threads that machinists cut on purpose in unusual ways: no thread rule is triggered. Each is paired with a
//! similar mistake that is reported.

use gcode_playground::run::Run;
use gcode_playground::setup::Setup;

/// How often a rule is triggered, including machine checks.
fn count(slug: &str, text: &str) -> usize {
    let mut run = Run::new(text.as_bytes().to_vec(), Setup::default());
    while !run.advance(usize::MAX) {}
    let mut analysis = run.into_analysis();
    analysis.check_at_machine();
    analysis.diagnostics.iter().filter(|told| told.message.slug() == slug).count()
}

#[track_caller]
fn is_silent(slug: &str, text: &str) {
    assert_eq!(count(slug, text), 0, "{slug}\n{text}");
}

#[track_caller]
fn is_told(slug: &str, text: &str) {
    assert!(count(slug, text) > 0, "no {slug}\n{text}");
}

/// Passes in a bar, with a tool and the spindle running.
fn thread(bar: &str, speed: u32, passes: &str) -> String {
    format!("O0001 (STOCK {bar})\nT0505\nG97 S{speed} M03\n{passes}\nG00 X200 Z200 M09\nM30\n")
}

#[test]
fn a_coarse_thread_is_fed_in_along_both_flanks() {
    const RULE: &str = "thread-start-moved";
    let in_turn = "G00 X46 Z12 M08\nG92 X39.5 Z-90 F6\nX39\nG00 W0.1\nG92 X38.5 Z-90 F6\nG00 W-0.2\nG92 X38.5 Z-90 F6\n\
                   G00 W0.1\nG92 X38 Z-90 F6\nG00 W0.1\nG92 X37.5 Z-90 F6\nG00 W-0.2\nG92 X37.5 Z-90 F6";
    is_silent(RULE, &thread("D=40 LENGTH=140", 120, in_turn));
    let by_places = "G00 X46 Z14 M08\nG92 X39.4 Z-90 F7\nX38.8\nX38.2\nX37.6\nX37\nX36.4\nG00 Z14.2\nG92 X36 Z-90 F7\n\
                     G00 Z13.8\nG92 X36 Z-90 F7\nG00 Z14.2\nG92 X35.6 Z-90 F7\nG00 Z13.8\nG92 X35.6 Z-90 F7\nG00 Z14\n\
                     G92 X35 Z-90 F7\nX34.6\nX34.6";
    is_silent(RULE, &thread("D=40 LENGTH=140", 90, by_places));
    let flanks_finished = "G00 X36 Z8 M08\nG92 X29.2 Z-40 F3\nX28.5\nX27.9\nX27.3\nX26.9\nG00 Z8.05\nG92 X26.9 Z-40 F3\n\
                           G00 Z7.95\nG92 X26.9 Z-40 F3";
    is_silent(RULE, &thread("D=30 LENGTH=100", 300, flanks_finished));
    // Shifts of a half and of a third of the lead remove the crests.
    is_told(RULE, &thread("D=30 LENGTH=100", 300, &flanks_finished.replace("Z8.05", "Z9.5")));
    is_told(RULE, &thread("D=30 LENGTH=100", 300, &flanks_finished.replace("Z8.05", "Z9")));
}

#[test]
fn an_insert_narrower_than_the_groove_cuts_left_middle_and_right() {
    let loop_of = |lead: &str| {
        format!(
            "#1=29.6\nG00 X36 Z12 M08\nWHILE [#1 GE 23] DO1\nG00 Z12\nG92 X#1 Z-60 F{lead}\nG00 Z[12+[#1-23]*0.13]\n\
             G92 X#1 Z-60 F{lead}\nG00 Z[12-[#1-23]*0.13]\nG92 X#1 Z-60 F{lead}\n#1=#1-0.3\nEND1"
        )
    };
    is_silent("thread-start-moved", &thread("D=30 LENGTH=100", 100, &loop_of("6")));
    // A shift by a third of the lead to each side leaves no crest.
    is_told("thread-start-moved", &thread("D=30 LENGTH=100", 100, &loop_of("2.5")));
}

#[test]
fn a_thread_has_many_starts() {
    const RULE: &str = "thread-start-moved";
    let series = "G92 X39.1 Z-23 F24\nX38.4\nX37.8";
    for step in [2, 4, 6, 8, 12] {
        let starts = vec![series; 24 / step].join(format!("\nG00 W{step}\n").as_str());
        is_silent(RULE, &thread("D=40 LENGTH=60", 40, &format!("G00 X46 Z30 M08\n{starts}")));
    }
    // The series continues at another place.
    let goes_on = "G00 X46 Z30 M08\nG92 X39.1 Z-23 F24\nX38.4\nG00 W12\nG92 X37.8 Z-23 F24";
    is_told(RULE, &thread("D=40 LENGTH=60", 40, goes_on));
    let last_again = "G00 X46 Z30 M08\nG92 X39.1 Z-23 F24\nX38.4\nG00 W8\nG92 X38.4 Z-23 F24";
    is_told(RULE, &thread("D=40 LENGTH=60", 40, last_again));
}

#[test]
fn round_threads_and_oil_grooves_are_shallow() {
    const RULE: &str = "thread-depth-unusual";
    let bottle = "G00 X46 Z8\nG92 X39.4 Z-12 F4\nX38.8\nX38.3\nX37.9\nX37.6";
    is_silent(RULE, &thread("D=40 LENGTH=60", 200, bottle));
    let lamp = "G00 X32 Z8\nG92 X26 Z-22 F3.629\nX25.5\nX25.1\nX24.8\nX24.5\nX24.3";
    is_silent(RULE, &thread("D=26.5 LENGTH=60", 200, lamp));
    let oil_groove = "G00 X56 Z20\nG92 X49.5 Z-45 F20\nX49\nX48.5\nX48.2";
    is_silent(RULE, &thread("D=50 LENGTH=60", 60, oil_groove));
    // The lead of M30x3.5 with the depth of M30x1.
    let too_small = "G00 X34 Z8\nG92 X29.5 Z-22 F3.5\nX29.1\nX28.8";
    is_told(RULE, &thread("D=30 LENGTH=60", 200, too_small));
}

#[test]
fn a_scratch_shows_the_lead_before_the_passes() {
    const RULE: &str = "thread-pass-jumps";
    let stopped =
        "G00 X34 Z6 M08\nG92 X29.96 Z-30 F2\nX29.92\nM01\nG92 X29.2 Z-30 F2\nX28.6\nX28\nX27.6\nX27.4";
    is_silent(RULE, &thread("D=30 LENGTH=80", 480, stopped));
    is_silent(RULE, &thread("D=30 LENGTH=80", 480, &stopped.replace("M01\n", "")));
    // Measured in between: the next passes remove the rest.
    let measured = "G00 X34 Z6 M08\nG92 X29.6 Z-30 F2\nX29.3\nM00\nG92 X28.4 Z-30 F2\nX27.8\nX27.4";
    is_silent(RULE, &thread("D=30 LENGTH=80", 480, measured));
    is_told(RULE, &thread("D=30 LENGTH=80", 480, &measured.replace("M00\n", "")));
}

#[test]
fn the_last_passes_of_a_thread_are_spring_passes() {
    const RULE: &str = "thread-pass-not-deeper";
    let passes = "G00 X34 Z6 M08\nG92 X29.2 Z-30 F2\nX28.6\nX28\nX27.6\nX27.4";
    is_silent(RULE, &thread("D=30 LENGTH=80", 480, &format!("{passes}\nX27.4")));
    is_silent(RULE, &thread("D=30 LENGTH=80", 480, &format!("{passes}\nX27.4\nX27.4")));
    // The next part from the bar.
    let twice = format!("{passes}\nX27.4\nG92 X29.2 Z-30 F2\nX28.6\nX28\nX27.6\nX27.4\nX27.4");
    is_silent(RULE, &thread("D=30 LENGTH=80", 480, &twice));
    is_told(RULE, &thread("D=30 LENGTH=80", 480, &passes.replace("X28\n", "X28.6\n")));
    is_told(RULE, &thread("D=30 LENGTH=80", 480, &passes.replace("X28\n", "X28.8\n")));
}

#[test]
fn a_tension_holder_takes_up_a_little_of_the_lead() {
    let tapped = |out: &str| {
        let moves = format!("G00 X0 Z6 M08\nG32 Z-20 F1.7\nM05\nM04\nG32 Z6 F{out}\nM05");
        thread("D=40 LENGTH=60", 200, &moves)
    };
    for out in ["1.7", "1.75", "1.65"] {
        is_silent("tap-lead-changed", &tapped(out));
    }
    is_told("tap-lead-changed", &tapped("1.5"));
    is_told("tap-lead-changed", &tapped("0.85"));
}
