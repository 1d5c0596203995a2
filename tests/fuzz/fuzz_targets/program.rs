//! No input bytes cause a panic: `cargo +nightly fuzz run --fuzz-dir tests/fuzz program`. The first byte
//! selects the G-code system and the size of the slices; the rest is the program.
#![no_main]

mod limits;

use gcode_playground::setup::dialect::GSystem;
use gcode_playground::setup::Setup;
use gcode_playground::run::{Analysis, Run};
use gcode_playground::text::highlight::highlight;
use libfuzzer_sys::fuzz_target;
use limits::LIMITS;

fn run(text: &[u8], setup: &Setup, slice: usize) -> Analysis {
    let mut run = Run::new(text.to_vec(), Setup { limits: LIMITS, ..setup.clone() });
    while !run.advance(slice) {}
    let state = run.state();
    assert!(state.position.x.is_finite() && state.position.z.is_finite() && state.c.is_finite());
    run.into_analysis()
}

fuzz_target!(|input: &[u8]| {
    let Some((&choice, text)) = input.split_first() else { return };
    let mut setup = Setup::default();
    setup.dialect.g_system =
        [None, Some(GSystem::A), Some(GSystem::B), Some(GSystem::C)][usize::from(choice % 4)];
    let analysis = run(text, &setup, usize::MAX);
    for diagnostic in &analysis.diagnostics {
        assert!(diagnostic.span.end as usize <= text.len());
    }
    for index in 0..analysis.motions.len() {
        let to = analysis.motions.get(index).to;
        assert!(to.x.is_finite() && to.z.is_finite());
        assert!(analysis.motions.span(index).end as usize <= text.len());
    }
    let sliced = run(text, &setup, 1 + usize::from(choice / 4));
    assert!(analysis.motions == sliced.motions && analysis.diagnostics == sliced.diagnostics);
    let _ = highlight(text, 0, text.len());
});
