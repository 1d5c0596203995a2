//! The search for programs accepts any text: `cargo +nightly fuzz run --fuzz-dir tests/fuzz clean`.
#![no_main]

use gcode_playground::api::paste::shortened;
use gcode_playground::paste::{Program, find};
use libfuzzer_sys::fuzz_target;

/// A text without whitespace, which may change without a reason.
fn solid(text: &str) -> String {
    text.chars().filter(|c| !c.is_whitespace() && *c != '\0').collect()
}

/// The pieces of a program cover its range of the text without a gap, and nothing is lost without a reason.
fn check(text: &str, program: &Program) {
    let mut at = program.span.start;
    for piece in &program.pieces {
        assert_eq!(piece.span.start, at);
        at = piece.span.end;
        let was = &text[piece.span.start as usize..piece.span.end as usize];
        if piece.reason.is_none() {
            assert_eq!(solid(was), solid(&piece.now));
        }
        if piece.is_question() {
            assert_eq!(piece.choices[0], piece.now);
        }
        let _ = shortened(was);
    }
    assert_eq!(at, program.span.end);
}

fuzz_target!(|input: &[u8]| {
    let text = &*String::from_utf8_lossy(input);
    let found = find(text);
    let mut end = 0;
    for program in &found.programs {
        assert!(program.span.start >= end);
        check(text, program);
        end = program.span.end;
        for choice in 0..3 {
            // A cleaned program is an ordinary text.
            let cleaned = program.answered(|_| choice);
            for again in &find(&cleaned).programs {
                check(&cleaned, again);
            }
        }
    }
    assert!(end as usize <= text.len());
});
