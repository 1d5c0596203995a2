//! What a good instructor would say though the control runs it: one file for each family of rules. Lints that need the part are in
//! `findings`.

pub mod compensation;
pub mod contour;
pub mod cycle;
pub mod plausible;
mod taper;
pub mod thread;

pub use taper::{Reading as TaperReading, shape as taper_shape, taper_not_extended};
