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
pub mod export;
pub mod geometry;
pub mod limits;
pub mod machine;
pub mod message;
pub mod motion;
pub mod run;
pub mod scene;
pub mod sentences;
pub mod setup;
pub mod source;
pub mod units;

// Public for the binary, the pages of the site and the tests only; they change without notice.
#[doc(hidden)]
pub mod assist;
#[doc(hidden)]
pub mod calculate;
#[cfg(all(feature = "cli", any(not(target_arch = "wasm32"), feature = "npx")))]
#[doc(hidden)]
pub mod cli;
#[doc(hidden)]
pub mod control;
#[doc(hidden)]
pub mod convert;
#[doc(hidden)]
pub mod current;
#[doc(hidden)]
pub mod exercise;
#[doc(hidden)]
pub mod expand;
#[doc(hidden)]
pub mod figures;
#[doc(hidden)]
pub mod findings;
#[doc(hidden)]
pub mod format;
#[doc(hidden)]
pub mod paste;
#[doc(hidden)]
pub mod playback;
#[doc(hidden)]
pub mod proof;
#[doc(hidden)]
pub mod references;
#[doc(hidden)]
pub mod renumber;
#[doc(hidden)]
pub mod repair;
#[doc(hidden)]
pub mod rewrite;
#[cfg(all(feature = "cli", any(not(target_arch = "wasm32"), feature = "npx")))]
#[doc(hidden)]
pub mod server;
#[doc(hidden)]
pub mod text;
#[cfg(all(target_arch = "wasm32", not(feature = "npx")))]
#[doc(hidden)]
pub mod wasm;

mod cycles;
mod difference;
mod heap;
mod library;
mod lint;
mod order;
mod parts;
mod provenance;
mod threads;

pub use library::{check, motions, repair};
pub use run::analyze;
