//! An expanded program makes the motions of the original:
//! `cargo +nightly fuzz run --fuzz-dir tests/fuzz expand`. The first byte selects the G-code system; the rest
//! is the program, as UTF-8. Runs that reach a limit are compared too.
#![no_main]

mod limits;

use gcode_playground::analyze;
use gcode_playground::expand::expand;
use gcode_playground::geometry::Point;
use gcode_playground::motion::Motion;
use gcode_playground::setup::Setup;
use gcode_playground::setup::dialect::GSystem;
use libfuzzer_sys::fuzz_target;
use limits::LIMITS;

/// Tolerance for rounded lengths, mm.
const ROUNDING: f64 = 0.0021;

fn near(a: f64, b: f64) -> bool {
    (a - b).abs() <= ROUNDING
}

fn same_place(a: Point, b: Point) -> bool {
    near(a.x, b.x) && near(a.z, b.z)
}

fn is_same(a: &Motion, b: &Motion) -> bool {
    let same_center = match (a.center, b.center) {
        (Some(a), Some(b)) => same_place(a, b),
        (a, b) => a.is_none() && b.is_none(),
    };
    let same_turn = match (a.rotary, b.rotary) {
        (Some(a), Some(b)) => near(a.from, b.from) && near(a.to, b.to),
        (a, b) => a.is_none() && b.is_none(),
    };
    a.kind == b.kind
        && same_place(a.from, b.from)
        && same_place(a.to, b.to)
        && same_center
        && same_turn
        && a.process.uncertain == b.process.uncertain
        && a.process.tool == b.process.tool
        && a.process.turn == b.process.turn
}

fuzz_target!(|input: &[u8]| {
    let Some((&choice, text)) = input.split_first() else { return };
    let text = String::from_utf8_lossy(text);
    let mut setup = Setup { limits: LIMITS, ..Setup::default() };
    setup.dialect.g_system =
        [None, Some(GSystem::A), Some(GSystem::B), Some(GSystem::C)][usize::from(choice % 4)];
    let expanded = expand(text.as_bytes(), &setup);
    let (before, after) =
        (analyze(text.as_bytes(), &setup).motions, analyze(expanded.as_bytes(), &setup).motions);
    assert_eq!(before.len(), after.len(), "{expanded}");
    for (index, (own, other)) in before.iter().zip(after.iter()).enumerate() {
        assert!(is_same(&own, &other), "{index}: {own:?}\n{other:?}\n{expanded}");
    }
});
