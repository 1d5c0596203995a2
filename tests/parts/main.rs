//! The part that a program makes, against geometry of the tests' own.
#![cfg(not(target_arch = "wasm32"))]

mod contours;
#[allow(dead_code, reason = "what other tests read of a program")]
#[path = "../fixtures/mod.rs"]
mod fixtures;
mod gallery;
mod inferred;
mod invariants;
mod reach;
mod worked;
