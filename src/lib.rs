//! A lathe G-code playground: program text in, tool motions and messages out.
//!
//! ```text
//! text ──► tokens ──► blocks ──► path ──► motions ──► part, time, dangers ──► scene ──► canvas / SVG
//!      what was written      what the control does    what happens at the machine   what you see
//! ```
//!
//! # Three calls
//!
//! [`check`] reports the faults of a program, [`motions`] returns its motions, and
//! [`repair`](crate::repair()) applies all safe repairs. Inside the crate X is a radius. The rows of [`api`],
//! which these calls return, have diameters, as in programs and on screen.
//!
//! ```
//! use gcode_playground::{check, motions, repair, sentences::Language, setup::Setup};
//!
//! let setup = Setup::from_json(r#"{"dialect": {"control": "fanuc"}}"#).expect("a setup");
//! let program = b"G00 X62 Z2\nG90 X5O Z-30 F0.2\nM30\n";
//! for found in check(program, &setup, Language::English) {
//!     println!("{}:{}: {} {}", found.line, found.column, found.code, found.message);
//! }
//! let program = repair(program, &setup).text;
//! assert_eq!(program, b"G00 X62 Z2\nG90 X50 Z-30 F0.2\nM30\n");
//! assert_eq!(motions(&program, &setup).len(), 5);
//! ```
//!
//! # Pictures
//!
//! ```
//! use gcode_playground::{analyze, scene::svg, setup::Setup};
//!
//! let analysis = analyze(b"G00 X32 Z2\nG90 X30 Z-30 F0.1\nM30\n", &Setup::default());
//! let picture = svg::section(&analysis.motions, Some(&analysis.simulate()), &svg::SvgOptions::default());
//! assert!(picture.starts_with("<svg"));
//! ```
//!
//! # In one call, or in slices
//!
//! [`analyze`] runs all stages in one call; [`run::Run`] does the same in slices, for a page that must not
//! block. Every stage adds its messages to one list. Every motion has the span of its source.
//!
//! The default feature `cli` contains the command line; `default-features = false` leaves it out.

#![warn(clippy::self_named_module_files)]

pub mod api;
pub mod assist;
pub mod calculate;
#[cfg(all(feature = "cli", any(not(target_arch = "wasm32"), feature = "npx")))]
pub mod cli;
pub mod control;
pub mod current;
pub mod cycles;
pub mod difference;
pub mod expand;
pub mod export;
pub mod figures;
pub mod findings;
pub mod geometry;
mod heap;
pub mod library;
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
pub mod threads;
pub mod units;
#[cfg(all(target_arch = "wasm32", not(feature = "npx")))]
pub mod wasm;

pub use library::{check, motions, repair};
pub use run::analyze;
