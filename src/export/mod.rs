//! Exports: tables, the setup sheet, the part for other programs.
//!
//! In: an analysed program. Out: texts and bytes, the same for the page and the command line, which both call
//! [`file::file`]. The exporters only format results of earlier stages. (The drawing is `scene::svg`, the
//! expanded program `expand`.)

pub mod card;
pub mod csv;
pub mod dxf;
pub mod figure;
pub mod file;
pub mod profile;
pub mod stl;
pub mod wanted_part;
