//! What leaves the playground as a file: tables, the setup sheet, the part for other programs.
//!
//! In: a program that was run. Out: texts and bytes, the same on the page and on the command line, which call
//! [`file::file`]. Each exporter only puts into words what earlier stages have worked out. (The drawing is
//! `scene::svg`, the expanded program `expand`.)

pub mod card;
pub mod csv;
pub mod dxf;
pub mod file;
pub mod profile;
pub mod stl;
