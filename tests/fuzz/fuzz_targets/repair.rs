//! Applying safe fixes to any bytes ends, adds no error, hides no address, and is complete:
//! `cargo +nightly fuzz run --fuzz-dir tests/fuzz repair`. The first byte selects the G-code system.
#![no_main]

#[path = "../../repair/invariants.rs"]
mod invariants;
mod limits;

use gcode_playground::setup::Setup;
use gcode_playground::setup::dialect::GSystem;
use libfuzzer_sys::fuzz_target;
use limits::LIMITS;

fuzz_target!(|input: &[u8]| {
    let Some((&choice, text)) = input.split_first() else { return };
    let mut setup = Setup { limits: LIMITS, ..Setup::default() };
    setup.dialect.g_system =
        [None, Some(GSystem::A), Some(GSystem::B), Some(GSystem::C)][usize::from(choice % 4)];
    invariants::repair(text, &setup);
});
