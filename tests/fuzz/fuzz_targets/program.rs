//! No bytes break anything: `cargo +nightly fuzz run --fuzz-dir tests/fuzz program`. The first byte chooses
//! the G-code system and the size of the slices; the rest is the program.
#![no_main]

use gcode_playground::setup::dialect::GSystem;
use gcode_playground::setup::Setup;
use gcode_playground::limits::Limits;
use gcode_playground::run::{Analysis, Run};
use gcode_playground::text::highlight::highlight;
use libfuzzer_sys::fuzz_target;

/// Bounds that are soon met, so that loops cost little.
const LIMITS: Limits = Limits {
    text: 1 << 20,
    motions: 2_000,
    moves_per_cycle: 500,
    cycle_work: 5_000,
    repeated_blocks: 1_000,
    repeated_text: 20_000,
    rounds: 500,
    macro_steps: 900,
    call_depth: 10,
    macro_depth: 5,
    messages: 100,
    part_motions: 200,
    part_corners: 500,
    compared_blocks: 1_000,
    stride: 64,
};

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
