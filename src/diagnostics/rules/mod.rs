//! Rules: what a good instructor would remark though the control runs it. One small file for each family.

pub mod machine;
mod taper;

pub use taper::taper_not_extended;
