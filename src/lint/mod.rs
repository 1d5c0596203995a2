//! Rules: what a good instructor would remark though the control runs it. One small file for each family.

pub mod compensation;
pub mod contour;
pub mod cycle;
pub mod plausible;
mod taper;
pub mod thread;

pub use taper::{Reading as TaperReading, shape as taper_shape, taper_not_extended};
