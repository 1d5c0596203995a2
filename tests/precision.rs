//! Tests how often messages are right: on judged programs, and on judged messages of real programs.
#[path = "precision/harmless.rs"]
mod harmless;
#[path = "precision/harmless_cuts.rs"]
mod harmless_cuts;
#[path = "precision/harmless_threads.rs"]
mod harmless_threads;
#[path = "precision/judged.rs"]
mod judged;
#[path = "precision/minus.rs"]
mod minus;
