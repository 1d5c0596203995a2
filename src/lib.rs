//! A lathe G-code playground: program text in, tool motions and messages out.
//!
//! ```text
//! text ──► tokens ──► blocks ──► path ──► motions ──► part, time, dangers ──► scene ──► canvas / SVG
//!      what was written      what the control does    what happens at the machine   what you see
//! ```
//!
//! # What is wrong with a program
//!
//! ```
//! use gcode_playground::{analyze, sentences::Language, setup::Setup, source::LineIndex};
//!
//! let program = b"G00 X32 Z2\nG01 Z-30 F0.1\nG01 X\nM30\n";
//! let analysis = analyze(program, &Setup::default());
//! let lines = LineIndex::new(program);
//! for found in &analysis.diagnostics {
//!     let place = lines.line_column(program, found.span.start);
//!     println!("line {}: {}", place.line + 1, found.sentence(Language::English).message);
//! }
//! # assert!(analysis.diagnostics.iter().any(|found| lines.line_of(found.span.start) == 2));
//! ```
//!
//! [`run::Analysis::check_at_machine`] adds what runs into what, where a blank or a machine is given.
//!
//! # Which motions it makes
//!
//! Inside the crate X is a radius. The rows of [`api`] have diameters, as they are written and shown.
//!
//! ```
//! use gcode_playground::{analyze, motion::MotionKind, setup::Setup};
//!
//! let analysis = analyze(b"G00 X32 Z2\nG90 X30 Z-30 F0.1\nM30\n", &Setup::default());
//! let cut = analysis.motions.iter().find(|motion| motion.kind == MotionKind::Feed).expect("a cut");
//! assert_eq!((cut.to.x, cut.to.z), (15.0, -30.0));
//! ```
//!
//! # What it looks like
//!
//! ```
//! use gcode_playground::{analyze, scene::svg, setup::Setup};
//!
//! let analysis = analyze(b"G00 X32 Z2\nG90 X30 Z-30 F0.1\nM30\n", &Setup::default());
//! let picture = svg::section(&analysis.motions, Some(&analysis.simulate()), &svg::SvgOptions::default());
//! assert!(picture.starts_with("<svg"));
//! ```
//!
//! # All in one call, or in slices
//!
//! [`analyze`] is the whole way in one call; [`run::Run`] the same in slices, for a page that must not block.
//! Messages are made at every stage and travel in one list. The span of the source travels with every motion.
//!
//! The feature `cli`, which is on unless `default-features = false`, is the command line.

pub mod api;
pub mod assist;
#[cfg(all(feature = "cli", not(target_arch = "wasm32")))]
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
mod order;
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
