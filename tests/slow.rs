//! The integration tests that take minutes: `cargo test --test slow`.
#![cfg(not(target_arch = "wasm32"))]

mod endless;
#[allow(dead_code, reason = "only the programs are needed here")]
mod fixtures;

mod bounds;
mod edits;
