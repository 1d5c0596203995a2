//! Safe fixes of any bytes come to an end, add no error, hide no address, and are complete:
//! `cargo +nightly fuzz run --fuzz-dir tests/fuzz repair`. The first byte chooses the G-code system.
#![no_main]

#[path = "../../repair/invariants.rs"]
mod invariants;

use gcode_playground::limits::Limits;
use gcode_playground::setup::Setup;
use gcode_playground::setup::dialect::GSystem;
use libfuzzer_sys::fuzz_target;

/// Bounds that are soon met, so that loops cost little.
fn limits() -> Limits {
    Limits {
        text: 1 << 20,
        motions: 2_000,
        moves_per_cycle: 500,
        cycle_work: 5_000,
        repeated_blocks: 1_000,
        repeated_text: 20_000,
        rounds: 500,
        macro_steps: 900,
        ..Limits::default()
    }
}

fuzz_target!(|input: &[u8]| {
    let Some((&choice, text)) = input.split_first() else { return };
    let mut setup = Setup { limits: limits(), ..Setup::default() };
    setup.dialect.g_system =
        [None, Some(GSystem::A), Some(GSystem::B), Some(GSystem::C)][usize::from(choice % 4)];
    invariants::repair(text, &setup);
});
