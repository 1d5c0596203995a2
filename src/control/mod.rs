//! What the control makes of what was written: the one place for units, diameters, frames and modal state.

pub mod dialect;
pub mod setup;
