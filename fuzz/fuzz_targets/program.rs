//! No bytes break anything: `cargo +nightly fuzz run program`.
#![no_main]

use gcode_playground::analyze;
use gcode_playground::control::setup::Setup;
use gcode_playground::text::highlight::highlight;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|text: &[u8]| {
    let analysis = analyze(text, &Setup::default());
    for diagnostic in &analysis.diagnostics {
        assert!(diagnostic.span.end as usize <= text.len());
    }
    for index in 0..analysis.motions.len() {
        let to = analysis.motions.get(index).to;
        assert!(to.x.is_finite() && to.z.is_finite());
        assert!(analysis.motions.span(index).end as usize <= text.len());
    }
    let _ = highlight(text, 0, text.len());
});
