//! A lathe G-code playground: program text in, tool motions and messages out.
//!
//! ```text
//! text ──► tokens ──► blocks ──► motions ──► scene ──► canvas / SVG
//!      text              control, cycles     scene
//! ```
//!
//! [`analyze`] is the whole way in one call; [`run::Run`] the same in slices, for a page that must not block.
//! Messages are made at every stage and travel in one list. The span of the source travels with every motion.

pub mod api;
#[cfg(not(target_arch = "wasm32"))]
pub mod cli;
pub mod control;
pub mod current;
pub mod cycles;
pub mod diagnostics;
pub mod expand;
pub mod export;
pub mod geometry;
pub mod limits;
pub mod motion;
pub mod paste;
pub mod repair;
pub mod rewrite;
mod room;
pub mod run;
pub mod scene;
pub mod shop;
pub mod text;
#[cfg(target_arch = "wasm32")]
pub mod wasm;

use control::setup::Setup;
use run::{Analysis, Run};

/// Interprets a whole program.
///
/// ```
/// use gcode_playground::{analyze, control::setup::Setup};
///
/// let analysis = analyze(b"G00 X32 Z2\nG01 Z-30 F0.1\nM30", &Setup::default());
/// assert_eq!(analysis.motions.len(), 2);
/// ```
pub fn analyze(text: &[u8], setup: &Setup) -> Analysis {
    let mut run = Run::new(text.to_vec(), setup.clone());
    while !run.advance(usize::MAX) {}
    run.into_analysis()
}
