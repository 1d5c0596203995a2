//! A lathe G-code playground: program text in, tool motions and messages out.
//!
//! ```text
//! text ──► tokens ──► blocks ──► path ──► motions ──► part, time, dangers ──► scene ──► canvas / SVG
//!      what was written      what the control does    what happens at the machine   what you see
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
pub mod expand;
pub mod export;
pub mod findings;
pub mod geometry;
mod heap;
pub mod limits;
pub mod lint;
pub mod machine;
pub mod message;
pub mod motion;
pub mod parts;
pub mod paste;
pub mod playback;
pub mod provenance;
pub mod repair;
pub mod rewrite;
pub mod run;
pub mod scene;
pub mod sentences;
pub mod setup;
pub mod source;
pub mod text;
pub mod units;
#[cfg(target_arch = "wasm32")]
pub mod wasm;

pub use run::analyze;
