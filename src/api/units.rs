//! The units of length of the page.
//!
//! In: the current run, and what the reader has chosen. Out: their names. All other rows have mm: who shows
//! them counts in this unit.

use serde::Serialize;

#[cfg(target_arch = "wasm32")]
use tsify::Tsify;

use crate::units::Unit;

/// The units of length.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
pub struct Units {
    /// In which lengths are to be shown.
    #[cfg_attr(target_arch = "wasm32", tsify(type = "\"mm\" | \"inch\""))]
    pub shown: &'static str,
    /// In which the program is written.
    #[cfg_attr(target_arch = "wasm32", tsify(type = "\"mm\" | \"inch\""))]
    pub program: &'static str,
}

impl Units {
    /// The unit that is shown, and that of the program.
    pub fn new(shown: Unit, program: Unit) -> Self {
        Self { shown: name(shown), program: name(program) }
    }
}

fn name(unit: Unit) -> &'static str {
    match unit {
        Unit::Millimetre => "mm",
        Unit::Inch => "inch",
    }
}
