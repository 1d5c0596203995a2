//! The limits of a run under the fuzzer.

use gcode_playground::limits::Limits;

/// Low limits, so that loops cost little.
pub const LIMITS: Limits = Limits {
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
