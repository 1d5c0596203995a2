//! The units of length of the page.
//!
//! In: the current run, and the choice of the user. Out: the names of the units. All other rows use mm, and
//! the page converts them to this unit.

use serde::Serialize;

#[cfg(target_arch = "wasm32")]
use tsify::Tsify;

use crate::units::Unit;

/// The units of length.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
pub struct Units {
    /// The unit in which lengths are shown.
    #[cfg_attr(target_arch = "wasm32", tsify(type = "\"mm\" | \"inch\""))]
    pub shown: &'static str,
    /// The unit of the program.
    #[cfg_attr(target_arch = "wasm32", tsify(type = "\"mm\" | \"inch\""))]
    pub program: &'static str,
}

impl Units {
    /// The names of the displayed unit and of the unit of the program.
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
